/*
 * query/query_cast.c - public functions that cast rays and shapes.
 *
 * The broadphase finds fat boxes along the way; collision/cast.h finds the hit in the shape's own frame. Hits
 * are ordered by fraction, then by shape and child. A ray is shortened to slightly beyond its best hit, so
 * that it still finds equal hits in any order of visits.
 */
#include "query/query.h"
#include "collision/cast.h"

#include <string.h>

/* A shape is moved in pieces, so that a long way does not look at everything in one large box. */
#define PIECES_MAX 64

/* ------------------------------------------------------------------ hits */

static void check_ray(cni_call *call, const cn_ray *ray)
{
	cni_check_pointer(call, "ray", ray);
	if (call->result != CN_OK)
		return;
	cni_check_position(call, "origin_m", ray->origin_m);
	cni_check_translation(call, ray->translation_m);
}

static int32_t hit_before(const void *a, const void *b)
{
	const cn_ray_hit *x = (const cn_ray_hit *)a, *y = (const cn_ray_hit *)b;
	return x->fraction != y->fraction ? x->fraction < y->fraction : cni_part_before(x->shape, x->child, y->shape, y->child);
}

static void hit_make(const cn_world *world, const cni_query_target *t, const cni_cast_hit *hit, cn_ray_hit *out)
{
	out->shape = cni_handles_of(&world->shape_handles, t->index);
	out->body = cni_handle_or_zero(&world->body_handles, t->shape->body);
	out->child = t->child;
	out->fraction = hit->fraction;
	out->depth_m = hit->depth;
	out->reserved = 0;
	out->point_m = t->body != NULL ? cni_body_to_world(t->body, hit->point) : hit->point;
	out->normal = t->body != NULL ? cni_rotate(t->body->q, hit->normal) : hit->normal;
}

static cn_ray_hit hit_none(void)
{
	cn_ray_hit none;
	memset(&none, 0, sizeof none);
	none.fraction = 1.0f;
	return none;
}

/* ------------------------------------------------------------------ which hits count */

/* Whether a hit counts under CN_QUERY_ONE_WAY and for starts in contact. translation is in the frame of the shape hit. */
static int32_t is_met(const cni_sight *sight, const cni_query_target *t, const cni_cast_hit *hit, cni_vec2 translation)
{
	if ((sight->filter.flags & CN_QUERY_ONE_WAY) && (t->shape->flags & CN_SHAPE_ONE_WAY) &&
	    (hit->depth > sight->world->settings.slop || !(hit->normal.y > CNI_ONE_WAY_COSINE)))
		return 0;
	return !cni_cast_leads_out(hit, sight->touch, translation);
}

/* ------------------------------------------------------------------ rays */

typedef struct ray_query {
	const cni_sight *sight;
	cni_vec2 origin, translation;
	cn_ray_hit best;
	cn_ray_hit stop;    /* for cn_world_cast_ray_all: the first hit of CN_QUERY_STOP; shape 0: none */
	cni_first all;      /* for cn_world_cast_ray_all */
} ray_query;

static void ray_begin(ray_query *q, const cni_sight *sight, const cn_ray *ray)
{
	q->sight = sight;
	q->origin = ray->origin_m;
	q->translation = ray->translation_m;
	q->best = q->stop = hit_none();
}

static void ray_run(ray_query *q, cni_query_fn *visit)
{
	const cn_world *world = q->sight->world;
	world->broadphase_ops->ray(world->broadphase, q->origin, q->translation, visit, q);
}

/* Casts against the shape of one box; 0 for a miss. */
static int32_t ray_cast(const ray_query *q, const cni_query_target *t, cn_ray_hit *out)
{
	cni_vec2 origin = t->body != NULL ? cni_body_to_local(t->body, q->origin) : q->origin;
	cni_vec2 translation = t->body != NULL ? cni_unrotate(t->body->q, q->translation) : q->translation;
	cni_cast_hit hit;
	if (!cni_cast_ray(t->geometry, t->child, origin, translation, &hit) || !is_met(q->sight, t, &hit, translation))
		return 0;
	hit_make(q->sight->world, t, &hit, out);
	return 1;
}

static void best_keep(cn_ray_hit *best, const cn_ray_hit *hit)
{
	if (best->shape == 0 || hit_before(hit, best))
		*best = *hit;
}

/* CN_QUERY_* of a proxy; CN_QUERY_SKIP for a miss. */
static int32_t ray_visit(ray_query *q, int32_t proxy, cn_ray_hit *out)
{
	cni_query_target t;
	if (!cni_query_target_of(q->sight, proxy, &t) || !ray_cast(q, &t, out))
		return CN_QUERY_SKIP;
	return cni_sight_ask(q->sight, out);
}

/* The limit is never 0: all shapes around the origin must be visited. */
static float ray_visit_nearest(void *context, int32_t proxy, float limit)
{
	ray_query *q = (ray_query *)context;
	cn_ray_hit hit;
	if (ray_visit(q, proxy, &hit) == CN_QUERY_SKIP)
		return limit;
	best_keep(&q->best, &hit);
	return cni_min(q->best.fraction * 1.000001f + FLT_MIN, limit);
}

static float ray_visit_any(void *context, int32_t proxy, float limit)
{
	ray_query *q = (ray_query *)context;
	cn_ray_hit hit;
	if (ray_visit(q, proxy, &hit) == CN_QUERY_SKIP)
		return limit;
	q->best = hit;
	return 0.0f;
}

static float ray_visit_all(void *context, int32_t proxy, float limit)
{
	ray_query *q = (ray_query *)context;
	cn_ray_hit hit;
	int32_t said = ray_visit(q, proxy, &hit);
	if (said == CN_QUERY_SKIP || (q->stop.shape != 0 && hit_before(&q->stop, &hit)))
		return limit;
	if (said == CN_QUERY_STOP)
		q->stop = hit;
	cni_first_add(&q->all, &hit);
	return limit;
}

/* After a hit with CN_QUERY_STOP the query runs again, as hits beyond it may have been counted before. */
static void ray_run_all(ray_query *q, cn_ray_hit *out, int32_t capacity)
{
	cni_first_begin(&q->all, out, (int32_t)sizeof *out, capacity, hit_before);
	ray_run(q, ray_visit_all);
	if (q->stop.shape != 0) {
		cni_first_begin(&q->all, out, (int32_t)sizeof *out, capacity, hit_before);
		ray_run(q, ray_visit_all);
	}
	cni_first_end(&q->all);
}

cn_ray_hit cni_ray_cast(const cni_sight *sight, cni_vec2 origin, cni_vec2 translation)
{
	cn_ray ray = { origin, translation };
	ray_query q;
	ray_begin(&q, sight, &ray);
	ray_run(&q, ray_visit_nearest);
	return q.best;
}

cn_result cn_world_cast_ray(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	check_ray(&call, ray);
	cni_check_pointer(&call, "out", out);
	if (call.result == CN_OK)
		*out = cni_ray_cast(&sight, ray->origin_m, ray->translation_m);
	return call.result;
}

cn_result cn_world_cast_ray_any(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, int32_t *out_hit)
{
	cni_call call = cni_enter_const(world);
	ray_query q;
	cni_sight sight = cni_check_filter(&call, filter);
	check_ray(&call, ray);
	cni_check_pointer(&call, "out_hit", out_hit);
	if (call.result != CN_OK)
		return call.result;
	ray_begin(&q, &sight, ray);
	ray_run(&q, ray_visit_any);
	*out_hit = q.best.shape != 0;
	return CN_OK;
}

cn_result cn_world_cast_ray_all(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out, int32_t capacity, int32_t *out_count)
{
	cni_call call = cni_enter_const(world);
	ray_query q;
	cni_sight sight = cni_check_filter(&call, filter);
	check_ray(&call, ray);
	cni_check_output(&call, out, capacity, out_count);
	if (call.result != CN_OK)
		return call.result;
	ray_begin(&q, &sight, ray);
	ray_run_all(&q, out, capacity);
	*out_count = q.all.total;
	return CN_OK;
}

cn_result cn_world_cast_rays(const cn_world *world, const cn_ray *rays, int32_t count, const cn_query_filter *filter, cn_ray_hit *out)
{
	cni_call call = cni_enter_const(world);
	cni_sight sight = cni_check_filter(&call, filter);
	cni_check_array(&call, "rays", rays, count);
	cni_check_array(&call, "out", out, count);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
		check_ray(&call, rays + k);
	for (int32_t k = 0; k < count && call.result == CN_OK; ++k)
		out[k] = cni_ray_cast(&sight, rays[k].origin_m, rays[k].translation_m);
	return call.result;
}

cn_result cn_shape_cast_ray(const cn_world *world, cn_shape shape, const cn_ray *ray, cn_ray_hit *out)
{
	cni_call call = cni_enter_const(world);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_query_target t;
	cn_ray_hit hit;
	ray_query q;
	cni_sight sight = cni_check_filter(&call, NULL);
	check_ray(&call, ray);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	ray_begin(&q, &sight, ray);
	t.shape = s;
	t.body = s->body != CNI_NONE ? cni_body_at(world, s->body) : NULL;
	t.geometry = cni_shape_geometry(&world->blocks, s);
	t.index = cni_shape_index(world, shape);
	for (t.child = 0; t.child < cni_shape_children(&world->blocks, s); ++t.child)
		if (ray_cast(&q, &t, &hit))
			best_keep(&q.best, &hit);
	*out = q.best;
	return CN_OK;
}

/* ------------------------------------------------------------------ shapes */

typedef struct shape_query {
	const cni_sight *sight;
	const cni_region *region;
	cni_vec2 translation;
	cni_aabb box;           /* of the region at its start */
	cn_ray_hit best;
} shape_query;

/* Whether the moving region's box may meet a fat box before the best hit: separating axes x, y and the normal of the translation. */
static int32_t sweep_may_meet(const shape_query *q, const cni_aabb *fat)
{
	cni_vec2 d = q->translation;
	cni_vec2 end = cni_mul(q->best.shape != 0 ? q->best.fraction * 1.000001f : 1.0f, d);
	float x0 = fat->x0 - q->box.x1, x1 = fat->x1 - q->box.x0, y0 = fat->y0 - q->box.y1, y1 = fat->y1 - q->box.y0;
	float middle = d.x * (y0 + y1) - d.y * (x0 + x1);
	float reach = cni_abs(d.x) * (y1 - y0) + cni_abs(d.y) * (x1 - x0);
	return cni_min(end.x, 0.0f) <= x1 && cni_max(end.x, 0.0f) >= x0 && cni_min(end.y, 0.0f) <= y1 && cni_max(end.y, 0.0f) >= y0 &&
	       cni_abs(middle) <= reach * 1.00001f;
}

static float shape_visit(void *context, int32_t proxy, float limit)
{
	shape_query *q = (shape_query *)context;
	cni_query_target t;
	cni_proxy_points moving = { q->region->points, q->region->count, q->region->radius };
	cni_cast_hit hit;
	cn_ray_hit made;
	if (!sweep_may_meet(q, &cni_proxy_at(q->sight->world, proxy)->fat) || !cni_query_target_of(q->sight, proxy, &t))
		return limit;
	cni_vec2 translation = cni_unrotate(t.body->q, q->translation);
	if (!cni_cast_points(t.geometry, t.child, moving, q->region->center, cni_region_in(q->region, t.body), translation, &hit) ||
	    !is_met(q->sight, &t, &hit, translation))
		return limit;
	hit_make(q->sight->world, &t, &hit, &made);
	if (cni_sight_ask(q->sight, &made) != CN_QUERY_SKIP)
		best_keep(&q->best, &made);
	return limit;
}

static int32_t piece_count(const shape_query *q)
{
	float size = (q->box.x1 - q->box.x0) + (q->box.y1 - q->box.y0) + q->sight->world->settings.length_unit;
	float pieces = cni_length(q->translation) / (2.0f * size);
	return 1 + (int32_t)cni_min(pieces, (float)(PIECES_MAX - 1));
}

cn_ray_hit cni_region_cast(const cni_sight *sight, const cni_region *region, cni_vec2 translation)
{
	const cn_world *world = sight->world;
	shape_query q = { sight, region, translation, cni_region_box(region, cni_v(0.0f, 0.0f)), hit_none() };
	int32_t pieces = piece_count(&q);
	for (int32_t k = 0; k < pieces; ++k) {
		float from = (float)k / (float)pieces, to = (float)(k + 1) / (float)pieces;
		cni_aabb box = cni_region_box(region, cni_mul(from, translation)), end = cni_region_box(region, cni_mul(to, translation));
		if (q.best.shape != 0 && q.best.fraction * 1.000001f < from)
			break;
		box = cni_aabb_union(&box, &end);
		world->broadphase_ops->query(world->broadphase, &box, shape_visit, &q);
	}
	return q.best;
}

cn_result cn_world_cast_shape(const cn_world *world, const cn_polygon *shape, float translation_x_m, float translation_y_m, const cn_query_filter *filter,
	cn_ray_hit *out)
{
	cni_call call = cni_enter_const(world);
	cni_vec2 translation = { translation_x_m, translation_y_m };
	cni_sight sight = cni_check_filter(&call, filter);
	cni_region region;
	cni_check_region(&call, shape, &region);
	cni_check_translation(&call, translation);
	cni_check_pointer(&call, "out", out);
	if (call.result == CN_OK)
		*out = cni_region_cast(&sight, &region, translation);
	return call.result;
}
