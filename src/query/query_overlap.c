/*
 * query/query_overlap.c - public functions that list the shapes in a region, in the order of
 * cn_world_get_shapes.
 *
 * A chain has many boxes but is listed once. The query remembers the first CHAINS_MAX chains it finds; it lists
 * any other chain for its first overlapping edge, which needs no memory but tests the edges before.
 */
#include "query/query.h"

#define CHAINS_MAX 32

typedef struct overlap_query overlap_query;
typedef int32_t overlap_test_fn(const overlap_query *q, const cni_query_target *t);

struct overlap_query {
	const cni_sight *sight;
	overlap_test_fn *test;
	const cni_region *region;   /* of test_region */
	cni_aabb box;
	cni_vec2 point;
	cni_first found;
	int32_t stop;               /* last shape to list, CNI_NONE without a stop */
	int32_t chains[CHAINS_MAX];
	int32_t chain_count;
};

/* ------------------------------------------------------------------ tests */

static int32_t test_box(const overlap_query *q, const cni_query_target *t)
{
	cni_aabb tight = cni_geometry_aabb(t->geometry, t->child, cni_body_transform(t->body));
	return cni_aabb_overlap(&tight, &q->box);
}

static int32_t test_region(const overlap_query *q, const cni_query_target *t)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(t->geometry, t->child, storage);
	cni_closest closest = cni_closest_find(set.points, set.count, q->region->points, q->region->count, cni_region_in(q->region, t->body));
	return closest.distance <= set.radius + q->region->radius;
}

static int32_t test_point(const overlap_query *q, const cni_query_target *t)
{
	return cni_geometry_contains(t->geometry, cni_body_to_local(t->body, q->point));
}

/* ------------------------------------------------------------------ finding */

static int32_t index_before(const void *a, const void *b)
{
	return cni_order_of(*(const cn_shape *)a) < cni_order_of(*(const cn_shape *)b);
}

static int32_t chain_is_known(const overlap_query *q, int32_t shape)
{
	for (int32_t k = q->chain_count - 1; k >= 0; --k)
		if (q->chains[k] == shape)
			return 1;
	return 0;
}

/* Whether no earlier edge of the chain overlaps. */
static int32_t chain_begins_with(const overlap_query *q, cni_query_target t)
{
	int32_t child = t.child;
	for (t.child = 0; t.child < child; ++t.child)
		if (cni_aabb_overlap(&cni_proxy_at(q->sight->world, cni_shape_proxy(q->sight->world, t.shape, t.child))->fat, &q->box) && q->test(q, &t))
			return 0;
	return 1;
}

/* Whether a shape overlaps and is not in the list. */
static int32_t overlap_finds(overlap_query *q, const cni_query_target *t)
{
	if ((t->shape->type == CN_SHAPE_CHAIN && chain_is_known(q, t->index)) || !q->test(q, t))
		return 0;
	if (t->shape->type != CN_SHAPE_CHAIN)
		return 1;
	if (q->chain_count == CHAINS_MAX)
		return chain_begins_with(q, *t);
	q->chains[q->chain_count++] = t->index;
	return 1;
}

static float overlap_visit(void *context, int32_t proxy, float limit)
{
	overlap_query *q = (overlap_query *)context;
	cni_query_target t;
	if (!cni_query_target_of(q->sight, proxy, &t) || cni_sight_hides_one_way(q->sight, t.shape))
		return limit;
	if ((q->stop != CNI_NONE && t.index > q->stop) || !overlap_finds(q, &t))
		return limit;
	t.child = 0; /* a chain as a whole */
	int32_t said = cni_sight_ask_target(q->sight, &t);
	if (said == CN_QUERY_SKIP)
		return limit;
	if (said == CN_QUERY_STOP)
		q->stop = t.index;
	cn_shape handle = cni_handles_of(&q->sight->world->shape_handles, t.index);
	cni_first_add(&q->found, &handle);
	return limit;
}

static void overlap_search(overlap_query *q, cn_shape *out, int32_t capacity)
{
	q->chain_count = 0;
	cni_first_begin(&q->found, out, (int32_t)sizeof *out, capacity, index_before);
	q->sight->world->broadphase_ops->query(q->sight->world->broadphase, &q->box, overlap_visit, q);
	cni_first_end(&q->found);
}

/* Runs a query whose test, region and box are set. */
static cn_result overlap_run(overlap_query *q, const cni_sight *sight, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	q->sight = sight;
	q->stop = CNI_NONE;
	overlap_search(q, out, capacity);
	if (q->stop != CNI_NONE) /* shapes after it may have been counted before */
		overlap_search(q, out, capacity);
	*out_count = q->found.total;
	return CN_OK;
}

/* ------------------------------------------------------------------ public functions */

cn_result cn_world_overlap_aabb(const cn_world *world, const cn_aabb *box, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	overlap_query q;
	cni_check_output(&call, out, capacity, out_count);
	cni_check_pointer(&call, "box", box);
	if (call.result != CN_OK)
		return call.result;
	cni_check_position(&call, "lower_m", box->lower_m);
	cni_check_position(&call, "upper_m", box->upper_m);
	cni_check(&call, box->lower_m.x <= box->upper_m.x && box->lower_m.y <= box->upper_m.y, CN_ERROR_ARGUMENT, "lower_m must not be above upper_m");
	if (call.result != CN_OK)
		return call.result;
	q.test = test_box;
	q.box = cni_aabb_of(box->lower_m, box->upper_m);
	return overlap_run(&q, &sight, out, capacity, out_count);
}

cn_result cn_world_overlap_polygon(const cn_world *world, const cn_polygon *polygon, const cn_query_filter *filter, cn_shape *out, int32_t capacity,
	int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	overlap_query q;
	cni_region region;
	cni_check_output(&call, out, capacity, out_count);
	cni_check_region(&call, polygon, &region);
	if (call.result != CN_OK)
		return call.result;
	q.test = test_region;
	q.region = &region;
	q.box = cni_region_box(&region, cni_v(0.0f, 0.0f));
	return overlap_run(&q, &sight, out, capacity, out_count);
}

cn_result cn_world_overlap_circle(const cn_world *world, const cn_circle *circle, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cn_polygon one_point;
	cni_check_pointer(&call, "circle", circle);
	if (call.result != CN_OK)
		return call.result;
	one_point.count = 1;
	one_point.radius_m = circle->radius_m;
	one_point.points_m[0] = circle->center_m;
	return cn_world_overlap_polygon(world, &one_point, filter, out, capacity, out_count);
}

cn_result cn_world_overlap_point(const cn_world *world, float x_m, float y_m, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	overlap_query q;
	cni_check_output(&call, out, capacity, out_count);
	cni_check_position(&call, "point", cni_v(x_m, y_m));
	if (call.result != CN_OK)
		return call.result;
	q.test = test_point;
	q.point = cni_v(x_m, y_m);
	q.box = cni_aabb_of(q.point, q.point);
	return overlap_run(&q, &sight, out, capacity, out_count);
}
