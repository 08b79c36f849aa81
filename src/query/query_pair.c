/*
 * query/query_pair.c - public functions on two convex shapes without a world: distance, cast, time of impact, manifold.
 *
 * Computes in the frame of a, which keeps all digits far from the world's origin, and transforms the results to the world.
 * Reads its arguments only.
 */
#include "query/query.h"
#include "collision/cast.h"
#include "collision/manifold.h"
#include "collision/toi.h"

#include <string.h>

/* Of a world whose length unit is 1 m. */
#define SLOP_M 0.005f
#define IMPACT_TOLERANCE_M 1e-4f

/* ------------------------------------------------------------------ arguments */

void cni_solid_make(const cn_polygon *p, cni_solid *out)
{
	const cni_transform none = cni_identity();
	cn_circle circle = { p->points_m[0], p->radius_m };
	cn_capsule capsule = { p->points_m[0], p->points_m[1], p->radius_m };
	cn_edge edge = { p->points_m[0], p->points_m[1] };
	if (p->count == 1)
		cni_geometry_circle(&out->g, &circle, none);
	else if (p->count == 2 && p->radius_m > 0.0f)
		cni_geometry_capsule(&out->g, &capsule, none);
	else if (p->count == 2)
		cni_geometry_edge(&out->g, &edge, none);
	else
		cni_geometry_polygon(&out->g, p, none);
}

static void check_solid(cni_call *call, const char *field, const cn_polygon *p, cni_solid *out)
{
	cni_check_pointer(call, field, p);
	if (call->result != CN_OK)
		return;
	cni_check_range_int(call, "count", p->count, 1, CN_POLYGON_MAX_VERTICES);
	cni_check_range(call, "radius_m", p->radius_m, 0.0f, CNI_COORDINATE_MAX);
	for (int32_t i = 0; i < p->count && call->result == CN_OK; ++i)
		cni_check_within(call, "points_m", p->points_m[i], CNI_COORDINATE_MAX);
	if (call->result != CN_OK)
		return;
	const char *wrong = cni_check_convex(p, CNI_THICKNESS_LEAST);
	cni_check(call, wrong == NULL, CN_ERROR_ARGUMENT, wrong);
	if (wrong == NULL)
		cni_solid_make(p, out);
}

static void check_pose(cni_call *call, const char *field, const cn_pose *pose, cni_transform *out)
{
	memset(out, 0, sizeof *out);
	cni_check_pointer(call, field, pose);
	if (call->result != CN_OK)
		return;
	cni_check_within(call, "position_m", pose->position_m, CNI_COORDINATE_MAX);
	float length_sq = pose->cosine * pose->cosine + pose->sine * pose->sine;
	cni_check(call, length_sq > 0.98f && length_sq < 1.02f, CN_ERROR_ARGUMENT, "cosine and sine must be those of an angle");
	out->q.c = pose->cosine;
	out->q.s = pose->sine;
	out->t = pose->position_m;
	if (call->result == CN_OK)
		out->q = cni_rot_normalize(out->q);
}

typedef struct pair {
	cni_solid a, b;
	cni_transform pose_a, pose_b;
	cni_transform b_in_a;
} pair;

static void check_pair(cni_call *call, const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, pair *out)
{
	check_solid(call, "a", a, &out->a);
	check_pose(call, "pose_a", pose_a, &out->pose_a);
	check_solid(call, "b", b, &out->b);
	check_pose(call, "pose_b", pose_b, &out->pose_b);
	if (call->result != CN_OK)
		return;
	out->b_in_a.q = cni_rot_between(out->pose_a.q, out->pose_b.q);
	out->b_in_a.t = cni_untransform_point(out->pose_a, out->pose_b.t);
}

/* ------------------------------------------------------------------ distance, cast, manifold */

/* translation: in the frame of a. */
static int32_t pair_cast(const pair *p, cni_vec2 translation, cni_cast_hit *out)
{
	return cni_cast_points(&p->a.g, 0, cni_geometry_proxy(&p->b.g, 0, NULL), p->b.g.centroid, p->b_in_a, translation, out);
}

/* Shortest way out of touching or overlapping surfaces. If rounding leaves b just outside, a cast from centre to centre finds it. */
static int32_t inside_find(const pair *p, cni_cast_hit *hit)
{
	cni_vec2 way = cni_sub(p->a.g.centroid, cni_transform_point(p->b_in_a, p->b.g.centroid));
	return pair_cast(p, cni_v(0.0f, 0.0f), hit) || pair_cast(p, way, hit);
}

cn_result cn_polygon_distance(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, cn_distance *out)
{
	cni_call call = cni_enter_free();
	cni_cast_hit hit;
	pair p;
	check_pair(&call, a, pose_a, b, pose_b, &p);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	memset(out, 0, sizeof *out);
	cni_closest d = cni_distance(cni_geometry_proxy(&p.a.g, 0, NULL), cni_geometry_proxy(&p.b.g, 0, NULL), p.b_in_a);
	int32_t inside = !(d.distance > 0.0f) && inside_find(&p, &hit);
	out->normal = cni_rotate(p.pose_a.q, inside ? hit.normal : d.normal);
	out->distance_m = inside ? -hit.depth : d.distance;
	out->point_a_m = cni_transform_point(p.pose_a, inside ? hit.point : d.point_a);
	out->point_b_m = inside ? cni_madd(out->point_a_m, -hit.depth, out->normal) : cni_transform_point(p.pose_a, d.point_b);
	return CN_OK;
}

cn_result cn_polygon_cast(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, float translation_x_m,
	float translation_y_m, cn_ray_hit *out, int32_t *out_hit)
{
	cni_call call = cni_enter_free();
	cni_vec2 translation = { translation_x_m, translation_y_m };
	cni_cast_hit hit;
	pair p;
	check_pair(&call, a, pose_a, b, pose_b, &p);
	cni_check_within(&call, "translation", translation, 2.0f * CNI_COORDINATE_MAX);
	cni_check_pointer(&call, "out", out);
	cni_check_pointer(&call, "out_hit", out_hit);
	if (call.result != CN_OK)
		return call.result;
	memset(out, 0, sizeof *out);
	out->fraction = 1.0f;
	translation = cni_unrotate(p.pose_a.q, translation);
	*out_hit = pair_cast(&p, translation, &hit) && !cni_cast_leads_out(&hit, SLOP_M, translation);
	if (!*out_hit)
		return CN_OK;
	out->fraction = hit.fraction;
	out->depth_m = hit.depth;
	out->point_m = cni_transform_point(p.pose_a, hit.point);
	out->normal = cni_rotate(p.pose_a.q, hit.normal);
	return CN_OK;
}

/* Manifold of the pair. The pair functions take the smaller type first: returns 1 if that is b. */
static int32_t pair_manifold(const pair *p, float margin, cni_manifold *out)
{
	int32_t swapped = p->b.g.type < p->a.g.type;
	cni_manifold_cache cache = { 0, { 0, 0, 0 } };
	cni_manifold_input in = { &p->a.g, &p->b.g, 0, 0, p->b_in_a, margin, SLOP_M };
	if (swapped) {
		in.a = &p->b.g;
		in.b = &p->a.g;
		in.b_in_a.q = cni_rot_between(p->pose_b.q, p->pose_a.q);
		in.b_in_a.t = cni_untransform_point(p->pose_b, p->pose_a.t);
	}
	memset(out, 0, sizeof *out);
	cni_manifold_function(in.a->type, in.b->type)(&in, &cache, out);
	return swapped;
}

cn_result cn_polygon_collide(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b,
	float margin_m, cn_manifold *out)
{
	cni_call call = cni_enter_free();
	cni_manifold m;
	pair p;
	check_pair(&call, a, pose_a, b, pose_b, &p);
	cni_check_range(&call, "margin_m", margin_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_pointer(&call, "out", out);
	if (call.result == CN_OK && ((a->count == 1 && !(a->radius_m > 0.0f)) || (b->count == 1 && !(b->radius_m > 0.0f))))
		cni_refuse(&call, CN_ERROR_ARGUMENT, "a single point must have a radius > 0");
	if (call.result != CN_OK)
		return call.result;
	int32_t swapped = pair_manifold(&p, margin_m, &m);
	memset(out, 0, sizeof *out);
	out->point_count = m.count;
	if (m.count > 0)
		out->normal = swapped ? cni_neg(cni_rotate(p.pose_b.q, m.normal)) : cni_rotate(p.pose_a.q, m.normal);
	for (int32_t k = 0; k < m.count; ++k) {
		uint32_t id = m.points[k].id;
		out->points[k].point_m = cni_transform_point(swapped ? p.pose_b : p.pose_a, m.points[k].point);
		out->points[k].separation_m = m.points[k].separation;
		out->points[k].feature_id = swapped ? (id & 255u) << 8 | id >> 8 : id;
	}
	return CN_OK;
}

/* ------------------------------------------------------------------ time of impact */

static void check_sweep(cni_call *call, const char *field, const cn_sweep *sweep, cni_path *out)
{
	cni_transform start;
	cni_check_pointer(call, field, sweep);
	if (call->result != CN_OK)
		return;
	check_pose(call, field, &sweep->start, &start);
	cni_check_within(call, "center_m", sweep->center_m, CNI_COORDINATE_MAX);
	cni_check_within(call, "translation_m", sweep->translation_m, 2.0f * CNI_COORDINATE_MAX);
	cni_check_angle(call, "turn_rad", sweep->turn_rad);
	if (call->result != CN_OK)
		return;
	out->q = start.q;
	out->turn = sweep->turn_rad;
	out->local_center = sweep->center_m;
	out->start = cni_transform_point(start, sweep->center_m);
	out->end = cni_add(out->start, sweep->translation_m);
}

/* Moves a path's origin to a's start: only differences of the two paths matter. */
static void path_shift(cni_path *path, cni_vec2 origin)
{
	path->start = cni_sub(path->start, origin);
	path->end = cni_sub(path->end, origin);
}

cn_result cn_polygon_time_of_impact(const cn_polygon *a, const cn_sweep *sweep_a, const cn_polygon *b, const cn_sweep *sweep_b,
	float distance_m, cn_impact *out)
{
	cni_call call = cni_enter_free();
	cni_toi_input in;
	cni_solid sa, sb;
	check_solid(&call, "a", a, &sa);
	check_sweep(&call, "sweep_a", sweep_a, &in.path_a);
	check_solid(&call, "b", b, &sb);
	check_sweep(&call, "sweep_b", sweep_b, &in.path_b);
	cni_check_range(&call, "distance_m", distance_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	cni_vec2 origin = in.path_a.start;
	path_shift(&in.path_a, origin);
	path_shift(&in.path_b, origin);
	in.a = &sa.g;
	in.b = &sb.g;
	in.child_a = in.child_b = 0;
	in.target = distance_m;
	in.tolerance = IMPACT_TOLERANCE_M;
	cni_toi_result hit = cni_toi(&in);
	memset(out, 0, sizeof *out);
	out->state = hit.state;
	out->fraction = hit.fraction;
	if (hit.state != CNI_TOI_HIT)
		return CN_OK;
	out->point_m = cni_add(hit.point, origin);
	out->normal = hit.normal;
	out->distance_m = hit.distance;
	return CN_OK;
}
