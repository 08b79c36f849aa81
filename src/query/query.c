/*
 * query/query.c - shared by all queries: see query.h.
 */
#include "query/query.h"
#include "geometry/outline.h"

#include <string.h>

/* ------------------------------------------------------------------ filter */

void cn_query_filter_init(cn_query_filter *filter)
{
	if (filter == NULL)
		return;
	memset(filter, 0, sizeof *filter);
	filter->category = 1;
	filter->mask = ~(uint64_t)0;
}

cni_sight cni_check_filter(cni_call *call, const cn_query_filter *filter)
{
	cni_sight s;
	memset(&s, 0, sizeof s);
	s.world = call->world;
	s.ignored = CNI_NONE;
	cn_query_filter_init(&s.filter);
	if (call->result != CN_OK)
		return s;
	if (filter != NULL)
		s.filter = *filter;
	cni_check_flags(call, "flags", s.filter.flags, CN_QUERY_IGNORE_JOINED | CN_QUERY_ONE_WAY | CN_QUERY_LEAVING);
	if (s.filter.ignored_body != 0 && cni_check_body(call, "ignored_body", s.filter.ignored_body) != NULL)
		s.ignored = cni_body_index(call->world, s.filter.ignored_body);
	s.touch = s.filter.flags & CN_QUERY_LEAVING ? FLT_MAX : call->world->settings.slop;
	return s;
}

static int32_t is_joined(const cn_world *world, int32_t body, int32_t to)
{
	for (int32_t key = cni_body_at(world, to)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		if (cni_joint_at(world, key >> 1)->body[!(key & 1)] == body)
			return 1;
	return 0;
}

/* Whether a query sees a shape; all queries decide it here. */
static int32_t sight_sees(const cni_sight *sight, const cni_shape *shape)
{
	const cn_query_filter *filter = &sight->filter;
	if ((shape->flags & (CN_SHAPE_SENSOR | CN_SHAPE_SENSOR_SEEN)) == CN_SHAPE_SENSOR || (shape->flags & sight->without))
		return 0;
	if ((shape->category & filter->mask) == 0 || (shape->mask & filter->category) == 0)
		return 0;
	return sight->ignored == CNI_NONE ||
	       (shape->body != sight->ignored && !((filter->flags & CN_QUERY_IGNORE_JOINED) && is_joined(sight->world, shape->body, sight->ignored)));
}

int32_t cni_query_target_of(const cni_sight *sight, int32_t proxy, cni_query_target *out)
{
	const cn_world *world = sight->world;
	const cni_proxy *p = cni_proxy_at(world, proxy);
	out->index = p->shape;
	out->child = cni_proxy_child(p);
	out->shape = cni_shape_at(world, p->shape);
	if (!sight_sees(sight, out->shape))
		return 0;
	out->body = cni_body_at(world, out->shape->body);
	out->geometry = cni_shape_geometry(&world->blocks, out->shape);
	return 1;
}

int32_t cni_sight_ask(const cni_sight *sight, const cn_ray_hit *hit)
{
	return sight->filter.visit != NULL ? sight->filter.visit(sight->world, hit, sight->filter.user) : CN_QUERY_TAKE;
}

int32_t cni_sight_ask_target(const cni_sight *sight, const cni_query_target *t)
{
	cn_ray_hit hit;
	if (sight->filter.visit == NULL)
		return CN_QUERY_TAKE;
	memset(&hit, 0, sizeof hit);
	hit.shape = cni_handles_of(&sight->world->shape_handles, t->index);
	hit.body = cni_handle_or_zero(&sight->world->body_handles, t->shape->body);
	hit.child = t->child;
	return cni_sight_ask(sight, &hit);
}

/* ------------------------------------------------------------------ region */

cn_polygon cni_region_polygon(const cni_region *region)
{
	cn_polygon p;
	p.count = region->count;
	p.radius_m = region->radius;
	memcpy(p.points_m, region->points, sizeof p.points_m);
	return p;
}

const char *cni_check_convex(const cn_polygon *p, float tolerance)
{
	if (p->count > 2)
		return cni_check_polygon(p, tolerance);
	return p->count == 2 && !(cni_length(cni_sub(p->points_m[1], p->points_m[0])) > tolerance) ? cni_points_near : NULL;
}

/* Checks the points, which are relative to the first one, and makes them counter-clockwise. */
static void check_region_points(cni_call *call, cni_region *region)
{
	cn_polygon relative = cni_region_polygon(region);
	const char *wrong = cni_check_convex(&relative, call->world->settings.thickness_least);
	cni_check_complaint(call, wrong, region->points, region->count, region->count > 2);
	if (wrong == NULL && region->count > 2 && cni_cross(region->points[1], region->points[2]) < 0.0f)
		cni_points_reverse(region->points, region->count);
}

void cni_check_translation(cni_call *call, cn_vec2 translation)
{
	cni_check_position(call, "half the translation", cni_mul(0.5f, translation));
}

void cni_check_region(cni_call *call, const cn_polygon *polygon, cni_region *out)
{
	cni_check_pointer(call, "polygon", polygon);
	if (call->result != CN_OK)
		return;
	cni_check_range_int(call, "count", polygon->count, 1, CN_POLYGON_MAX_VERTICES);
	cni_check_range(call, "radius_m", polygon->radius_m, polygon->count < 3 ? FLT_MIN : 0.0f, CNI_COORDINATE_MAX);
	for (int32_t i = 0; i < polygon->count && call->result == CN_OK; ++i)
		cni_check_position(call, "points_m", polygon->points_m[i]);
	if (call->result != CN_OK)
		return;
	memset(out, 0, sizeof *out);
	out->origin = polygon->points_m[0];
	out->count = polygon->count;
	out->radius = polygon->radius_m;
	for (int32_t i = 0; i < polygon->count; ++i) {
		out->points[i] = cni_sub(polygon->points_m[i], out->origin);
		out->center = cni_madd(out->center, 1.0f / (float)polygon->count, out->points[i]);
	}
	check_region_points(call, out);
}

cni_aabb cni_region_box(const cni_region *region, cni_vec2 offset)
{
	cni_vec2 base = cni_add(region->origin, offset);
	cni_aabb box = { base.x, base.y, base.x, base.y };
	for (int32_t i = 0; i < region->count; ++i)
		box = cni_aabb_with_point(box, cni_add(base, region->points[i]));
	return cni_box_fatten(box, region->radius);
}

cni_transform cni_region_in(const cni_region *region, const cni_body *body)
{
	cni_transform x = { { body->q.c, -body->q.s }, cni_body_to_local(body, region->origin) };
	return x;
}

/* ------------------------------------------------------------------ the first items of a stream: a heap */

static uint8_t *first_at(const cni_first *first, int32_t i)
{
	return first->items + (size_t)i * (size_t)first->item_bytes;
}

static void first_swap(const cni_first *first, int32_t i, int32_t j)
{
	uint8_t kept[CNI_FIRST_ITEM_BYTES];
	memcpy(kept, first_at(first, i), (size_t)first->item_bytes);
	memcpy(first_at(first, i), first_at(first, j), (size_t)first->item_bytes);
	memcpy(first_at(first, j), kept, (size_t)first->item_bytes);
}

static void first_sift_up(const cni_first *first, int32_t i)
{
	while (i > 0 && first->before(first_at(first, (i - 1) / 2), first_at(first, i))) {
		first_swap(first, i, (i - 1) / 2);
		i = (i - 1) / 2;
	}
}

static void first_sift_down(const cni_first *first, int32_t count)
{
	int32_t i = 0;
	for (;;) {
		int32_t last = i;
		for (int32_t child = 2 * i + 1; child <= 2 * i + 2 && child < count; ++child)
			if (first->before(first_at(first, last), first_at(first, child)))
				last = child;
		if (last == i)
			return;
		first_swap(first, i, last);
		i = last;
	}
}

void cni_first_begin(cni_first *first, void *items, int32_t item_bytes, int32_t capacity, cni_before_fn *before)
{
	const cni_first empty = { (uint8_t *)items, item_bytes, capacity, 0, 0, before };
	CNI_ASSERT(item_bytes <= CNI_FIRST_ITEM_BYTES);
	*first = empty;
}

void cni_first_add(cni_first *first, const void *item)
{
	++first->total;
	if (first->held < first->capacity) {
		memcpy(first_at(first, first->held), item, (size_t)first->item_bytes);
		first_sift_up(first, first->held++);
	} else if (first->held > 0 && first->before(item, first_at(first, 0))) {
		memcpy(first_at(first, 0), item, (size_t)first->item_bytes);
		first_sift_down(first, first->held);
	}
}

void cni_first_end(cni_first *first)
{
	for (int32_t count = first->held - 1; count > 0; --count) {
		first_swap(first, 0, count);
		first_sift_down(first, count);
	}
}
