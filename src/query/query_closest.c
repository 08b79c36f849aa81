/*
 * query/query_closest.c - the public function that finds the shape nearest to a point.
 *
 * The search box around the point grows until the best shape is within the box, so the cost depends on the
 * neighbourhood, not on the allowed distance. Shape and child order equal distances.
 */
#include "query/query.h"
#include "collision/distance.h"

#define GROWTH 4.0f

typedef struct closest_query {
	const cni_sight *sight;
	cni_vec2 point;
	float distance_max;
	cn_closest best;
} closest_query;

/* Lower bound of the distance from the point to anything in the box: 0 inside. */
static float box_distance(const cni_aabb *box, cni_vec2 p)
{
	float dx = cni_max(cni_max(box->x0 - p.x, p.x - box->x1), 0.0f);
	float dy = cni_max(cni_max(box->y0 - p.y, p.y - box->y1), 0.0f);
	return cni_max(dx, dy);
}

static int32_t is_closer(const closest_query *q, const cni_query_target *t, float distance)
{
	int32_t best = q->best.shape != 0 ? cni_shape_index(q->sight->world, q->best.shape) : CNI_NONE;
	if (q->best.shape == 0 || distance != q->best.distance_m)
		return q->best.shape == 0 || distance < q->best.distance_m;
	return t->index < best || (t->index == best && t->child < q->best.child);
}

static cn_closest closest_make(const cn_world *world, const cni_query_target *t, const cni_nearest *n)
{
	const cn_closest made = { cni_handles_of(&world->shape_handles, t->index), cni_handle_or_zero(&world->body_handles, t->shape->body), t->child, n->distance,
		cni_body_to_world(t->body, n->point), cni_rotate(t->body->q, n->normal) };
	return made;
}

static float closest_visit(void *context, int32_t proxy, float limit)
{
	closest_query *q = (closest_query *)context;
	const cn_world *world = q->sight->world;
	cni_query_target t;
	if (q->best.shape != 0 && box_distance(&cni_proxy_at(world, proxy)->fat, q->point) > cni_max(q->best.distance_m, 0.0f))
		return limit;
	if (!cni_query_target_of(q->sight, proxy, &t) || cni_sight_hides_one_way(q->sight, t.shape))
		return limit;
	cni_nearest n = cni_geometry_nearest(t.geometry, t.child, cni_body_to_local(t.body, q->point));
	if (n.distance > q->distance_max || !is_closer(q, &t, n.distance) || cni_sight_ask_target(q->sight, &t) == CN_QUERY_SKIP)
		return limit;
	q->best = closest_make(world, &t, &n);
	return limit;
}

static void search_within(closest_query *q, float reach)
{
	cni_aabb box = cni_box_fatten(cni_aabb_of(q->point, q->point), reach);
	q->sight->world->broadphase_ops->query(q->sight->world->broadphase, &box, closest_visit, q);
}

cn_result cn_world_closest_point(const cn_world *world, float x_m, float y_m, float distance_max_m, const cn_query_filter *filter, cn_closest *out)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	closest_query q = { &sight, { x_m, y_m }, distance_max_m, { 0, 0, 0, 0.0f, { 0.0f, 0.0f }, { 0.0f, 0.0f } } };
	cni_check_position(&call, "point", q.point);
	if (call.result == CN_OK)
		cni_check_range(&call, "distance_max_m", distance_max_m, 0.0f, 4.0f * CNI_POSITION_MAX_UNITS * world->settings.length_unit);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	float reach = cni_min(distance_max_m, world->settings.length_unit);
	search_within(&q, reach);
	while (reach < distance_max_m && (q.best.shape == 0 || q.best.distance_m > reach)) {
		reach = cni_min(distance_max_m, GROWTH * reach);
		search_within(&q, reach);
	}
	*out = q.best;
	return CN_OK;
}
