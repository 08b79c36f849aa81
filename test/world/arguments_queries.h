/*
 * test/world/arguments_queries.h - entries of arguments_test for queries, explosions and trees: good and bad calls of each
 * function. Included by arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_QUERIES_H
#define CAIRN_TEST_ARGUMENTS_QUERIES_H

/* ---- queries */

static cn_ray ray;
static cn_ray_hit hit_list[2];
static cn_query_filter query_filter;
static cn_explosion_def blast;
static cn_aabb region_box;

static int reset_queries(void)
{
	reset();
	ray.origin_m = v2(-3.0f, 0.5f);
	ray.translation_m = v2(6.0f, 0.0f);
	cn_query_filter_init(&query_filter);
	cn_explosion_def_init(&blast);
	blast.center_m = v2(0.2f, 0.0f);
	blast.radius_m = 100.0f;
	blast.impulse_Nspm = 1.0f;
	region_box.lower_m = v2(-1.0f, -1.0f);
	region_box.upper_m = v2(1.0f, 1.0f);
	return 0;
}
static const cn_ray *good_ray(void) { reset_queries(); return &ray; }
static const cn_ray *ray_from(cn_vec2 v) { reset_queries(); ray.origin_m = v; return &ray; }
static const cn_ray *ray_along(cn_vec2 v) { reset_queries(); ray.translation_m = v; return &ray; }
/* The second of two is bad. */
static const cn_ray *ray_pair(cn_vec2 v) { static cn_ray two[2]; two[0] = *good_ray(); two[1] = *ray_along(v); return two; }
static const cn_polygon *region_points(int32_t count, float radius, cn_vec2 first)
{
	reset_queries();
	polygon.count = count;
	polygon.radius_m = radius;
	polygon.points_m[0] = first;
	return &polygon;
}
static const cn_aabb *region_from(cn_vec2 v) { reset_queries(); region_box.lower_m = v; return &region_box; }
static const cn_aabb *region_to(cn_vec2 v) { reset_queries(); region_box.upper_m = v; return &region_box; }

static cn_query_filter spoiled;
static const cn_query_filter *flagged(uint32_t flags) { cn_query_filter_init(&spoiled); spoiled.flags = flags; return &spoiled; }
static const cn_query_filter *ignoring(cn_body body) { cn_query_filter_init(&spoiled); spoiled.ignored_body = body; return &spoiled; }
/* call takes a filter. */
#define FILTERS(call) do { FLAGS(x, 3, call(flagged(x))); BODY_BUT_ZERO(h, call(ignoring(h))); } while (0)
#define RAYS(call) do { ARG(call(NULL)); POSITION(v, call(ray_from(v))); VECTOR(v, call(ray_along(v))); ARG(call(ray_along(v2(2.1e6f, 0.0f)))); } while (0)
/* Polygons of one or two points need a radius. */
#define REGIONS(call) do { cn_vec2 o_ = v2(-0.5f, -0.5f); ARG(call(NULL)); INTEGER(x, 0, 17, call(region_points(x, 0.1f, o_))); \
	NOT_NEGATIVE(x, call(region_points(4, x, o_))); ARG(call(region_points(4, 1.1e6f, o_))); \
	{ int32_t n_; for (n_ = 1; n_ < 3; ++n_) POSITIVE(x, call(region_points(n_, x, o_))); } \
	POSITION(v, call(region_points(4, 0.0f, v))); ARG(call(region_points(4, 0.0f, v2(0.4f, 0.4f)))); ARG(call(region_points(2, 0.1f, v2(0.5f, -0.5f)))); } while (0)
#define OUTPUT_LIST(name, region) \
	NOW(name(NULL, region, NULL, OUT(cn_shape) + 4, 8, INT)); ARG(name(W, region, NULL, NULL, 1, INT)); \
	ARG(name(W, region, NULL, OUT(cn_shape) + 4, -1, INT)); ARG(name(W, region, NULL, OUT(cn_shape) + 4, 8, NULL));

ENTRY(cn_query_filter_init, (cn_query_filter_init(&query_filter), CN_OK), cn_query_filter_init(NULL);)
ENTRY(cn_explosion_def_init, (cn_explosion_def_init(&blast), CN_OK), cn_explosion_def_init(NULL);)
#define CAST_RAY(r) cn_world_cast_ray(W, r, NULL, OUT(cn_ray_hit))
#define CAST_RAY_BY(fl) cn_world_cast_ray(W, good_ray(), fl, OUT(cn_ray_hit))
ENTRY(cn_world_cast_ray, cn_world_cast_ray(W, good_ray(), &query_filter, OUT(cn_ray_hit)),
	FILTERS(CAST_RAY_BY); RAYS(CAST_RAY); NOW(cn_world_cast_ray(NULL, good_ray(), NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_ray(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ANY(r) cn_world_cast_ray_any(W, r, NULL, INT)
#define CAST_RAY_ANY_BY(fl) cn_world_cast_ray_any(W, good_ray(), fl, INT)
ENTRY(cn_world_cast_ray_any, cn_world_cast_ray_any(W, good_ray(), &query_filter, INT),
	FILTERS(CAST_RAY_ANY_BY); RAYS(CAST_RAY_ANY); NOW(cn_world_cast_ray_any(NULL, good_ray(), NULL, INT)); ARG(cn_world_cast_ray_any(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ALL(r) cn_world_cast_ray_all(W, r, NULL, OUT(cn_ray_hit) + 4, 8, INT)
#define CAST_RAY_ALL_BY(fl) cn_world_cast_ray_all(W, good_ray(), fl, OUT(cn_ray_hit) + 4, 8, INT)
ENTRY(cn_world_cast_ray_all, cn_world_cast_ray_all(W, good_ray(), &query_filter, OUT(cn_ray_hit) + 4, 8, INT),
	FILTERS(CAST_RAY_ALL_BY); RAYS(CAST_RAY_ALL); NOW(cn_world_cast_ray_all(NULL, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, NULL, 1, INT)); ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, -1, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, NULL));)
#define CAST_RAYS(r) cn_world_cast_rays(W, r, 1, NULL, OUT(cn_ray_hit))
#define CAST_RAYS_BY(fl) cn_world_cast_rays(W, good_ray(), 1, fl, OUT(cn_ray_hit))
ENTRY(cn_world_cast_rays, cn_world_cast_rays(W, ray_pair(v2(1.0f, 0.0f)), 2, &query_filter, hit_list),
	FILTERS(CAST_RAYS_BY); RAYS(CAST_RAYS); NOW(cn_world_cast_rays(NULL, good_ray(), 1, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_rays(W, good_ray(), -1, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_rays(W, good_ray(), 1, NULL, NULL)); VECTOR(v, cn_world_cast_rays(W, ray_pair(v), 2, NULL, OUT(cn_ray_hit)));)
#define CAST_RAY_SHAPE(r) cn_shape_cast_ray(W, f.chain, r, OUT(cn_ray_hit))
ENTRY(cn_shape_cast_ray, cn_shape_cast_ray(W, f.chain, good_ray(), OUT(cn_ray_hit)),
	RAYS(CAST_RAY_SHAPE); NOW(cn_shape_cast_ray(NULL, f.chain, good_ray(), OUT(cn_ray_hit))); SHAPE(h, cn_shape_cast_ray(W, h, good_ray(), OUT(cn_ray_hit)));
	ARG(cn_shape_cast_ray(W, f.chain, good_ray(), NULL));)
#define CAST_SHAPE(p) cn_world_cast_shape(W, p, 1.0f, -2.0f, NULL, OUT(cn_ray_hit))
#define CAST_SHAPE_BY(fl) cn_world_cast_shape(W, &polygon, 1.0f, -2.0f, fl, OUT(cn_ray_hit))
ENTRY(cn_world_cast_shape, cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, -2.0f, &query_filter, OUT(cn_ray_hit)),
	FILTERS(CAST_SHAPE_BY); REGIONS(CAST_SHAPE); NOW(cn_world_cast_shape(NULL, (reset_queries(), &polygon), 1.0f, -2.0f, NULL, OUT(cn_ray_hit)));
	VECTOR(v, cn_world_cast_shape(W, (reset_queries(), &polygon), v.x, v.y, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 0.0f, 2.1e6f, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, 0.0f, NULL, NULL));)
#define OVERLAP_AABB(b) cn_world_overlap_aabb(W, b, NULL, OUT(cn_shape) + 4, 8, INT)
#define OVERLAP_AABB_BY(fl) cn_world_overlap_aabb(W, &region_box, fl, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_aabb, cn_world_overlap_aabb(W, (reset_queries(), &region_box), &query_filter, OUT(cn_shape) + 4, 8, INT),
	FILTERS(OVERLAP_AABB_BY); OUTPUT_LIST(cn_world_overlap_aabb, (reset_queries(), &region_box)) ARG(OVERLAP_AABB(NULL)); POSITION(v, OVERLAP_AABB(region_from(v)));
	POSITION(v, OVERLAP_AABB(region_to(v))); ARG(OVERLAP_AABB(region_to(v2(-2.0f, 1.0f)))); ARG(OVERLAP_AABB(region_to(v2(1.0f, -2.0f))));)
#define OVERLAP_CIRCLE(c) cn_world_overlap_circle(W, c, NULL, OUT(cn_shape) + 4, 8, INT)
#define OVERLAP_CIRCLE_BY(fl) cn_world_overlap_circle(W, &circle, fl, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_circle, cn_world_overlap_circle(W, (reset_queries(), &circle), &query_filter, OUT(cn_shape) + 4, 8, INT),
	FILTERS(OVERLAP_CIRCLE_BY); OUTPUT_LIST(cn_world_overlap_circle, (reset_queries(), &circle)) ARG(OVERLAP_CIRCLE(NULL)); POSITION(v, OVERLAP_CIRCLE(CI(center_m, v)));
	POSITIVE(x, OVERLAP_CIRCLE(CI(radius_m, x))); ARG(OVERLAP_CIRCLE(CI(radius_m, 1.1e6f)));)
#define OVERLAP_POLYGON(p) cn_world_overlap_polygon(W, p, NULL, OUT(cn_shape) + 4, 8, INT)
#define OVERLAP_POLYGON_BY(fl) cn_world_overlap_polygon(W, &polygon, fl, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_polygon, cn_world_overlap_polygon(W, (reset_queries(), &polygon), &query_filter, OUT(cn_shape) + 4, 8, INT),
	FILTERS(OVERLAP_POLYGON_BY); OUTPUT_LIST(cn_world_overlap_polygon, (reset_queries(), &polygon)) REGIONS(OVERLAP_POLYGON);)
#define OVERLAP_POINT(v) cn_world_overlap_point(W, v.x, v.y, NULL, OUT(cn_shape) + 4, 8, INT)
#define OVERLAP_POINT_BY(fl) cn_world_overlap_point(W, 0.0f, 0.5f, fl, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_point, cn_world_overlap_point(W, 0.0f, 0.5f, &query_filter, OUT(cn_shape) + 4, 8, INT),
	FILTERS(OVERLAP_POINT_BY); POSITION(v, OVERLAP_POINT(v)); NOW(cn_world_overlap_point(NULL, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, NULL, 1, INT)); ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, -1, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, NULL));)
#define CLOSEST_BY(fl) cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, fl, OUT(cn_closest))
ENTRY(cn_world_closest_point, cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, &query_filter, OUT(cn_closest)),
	FILTERS(CLOSEST_BY); POSITION(v, cn_world_closest_point(W, v.x, v.y, 5.0f, NULL, OUT(cn_closest))); RANGE(x, -1e-30f, 4.1e6f, cn_world_closest_point(W, 0.0f, 3.0f, x, NULL, OUT(cn_closest)));
	NOW(cn_world_closest_point(NULL, 0.0f, 3.0f, 5.0f, NULL, OUT(cn_closest))); ARG(cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, NULL, NULL));)
#define BLAST(field, value) (reset_queries(), blast.field = (value), &blast)
#define EXPLODE_BY(fl) cn_world_explode(W, BLAST(filter, *(fl)))
ENTRY(cn_world_explode, cn_world_explode(W, BLAST(radius_m, 100.0f)),
	FILTERS(EXPLODE_BY); NOW(cn_world_explode(NULL, BLAST(radius_m, 1.0f))); ARG(cn_world_explode(W, NULL)); SIZES(x, cn_world_explode(W, BLAST(struct_size, x)));
	RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(radius_m, x))); RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(falloff_m, x)));
	FLOAT(x, cn_world_explode(W, BLAST(impulse_Nspm, x))); POSITION(v, cn_world_explode(W, BLAST(center_m, v)));
	ARG(cn_world_explode(W, BLAST(impulse_Nspm, 3e38f)));)

/* ---- two shapes without a world */

static cn_polygon pair_a, pair_b;
static cn_pose pair_pose;
static cn_sweep pair_sweep;

static int reset_pair(void)
{
	reset_queries();
	pair_a = pair_b = polygon;
	memset(&pair_pose, 0, sizeof pair_pose);
	pair_pose.position_m.x = 3.0f;
	pair_pose.cosine = 1.0f;
	memset(&pair_sweep, 0, sizeof pair_sweep);
	pair_sweep.start = pair_pose;
	return 0;
}
static const cn_polygon *pair_of(int32_t count, float radius, cn_vec2 first)
{
	reset_pair();
	pair_b.count = count;
	pair_b.radius_m = radius;
	pair_b.points_m[0] = first;
	return &pair_b;
}
static const cn_pose *pose_at(cn_vec2 v) { reset_pair(); pair_pose.position_m = v; return &pair_pose; }
static const cn_pose *pose_of(float cosine, float sine) { reset_pair(); pair_pose.cosine = cosine; pair_pose.sine = sine; return &pair_pose; }
#define SWEEP(field, value) (reset_pair(), pair_sweep.field = (value), &pair_sweep)

/* call takes a polygon; the other polygon is &pair_a. */
#define SOLIDS(call) do { cn_vec2 o_ = v2(-0.5f, -0.5f); ARG(call(NULL)); INTEGER(x, 0, 17, call(pair_of(x, 0.1f, o_))); \
	NOT_NEGATIVE(x, call(pair_of(4, x, o_))); ARG(call(pair_of(4, 1.1e6f, o_))); POSITION(v, call(pair_of(4, 0.0f, v))); \
	ARG(call(pair_of(4, 0.0f, v2(0.4f, 0.4f)))); ARG(call(pair_of(2, 0.1f, v2(0.5f, -0.5f)))); } while (0)
#define POSES(call) do { ARG(call(NULL)); POSITION(v, call(pose_at(v))); FLOAT(x, call(pose_of(x, 0.0f))); FLOAT(x, call(pose_of(1.0f, x))); \
	ARG(call(pose_of(0.0f, 0.0f))); ARG(call(pose_of(1.0f, 0.2f))); ARG(call(pose_of(0.9f, 0.0f))); } while (0)
#define SWEEPS(call) do { ARG(call(NULL)); POSITION(v, call(SWEEP(start.position_m, v))); FLOAT(x, call(SWEEP(start.cosine, x))); ARG(call(SWEEP(start.sine, 1.0f))); \
	POSITION(v, call(SWEEP(center_m, v))); VECTOR(v, call(SWEEP(translation_m, v))); ARG(call(SWEEP(translation_m, v2(2.1e6f, 0.0f)))); ANGLE(x, call(SWEEP(turn_rad, x))); } while (0)

#define DISTANCE(a, pa, b, pb) cn_polygon_distance(a, pa, b, pb, OUT(cn_distance))
#define DISTANCE_A(p) DISTANCE(p, &pair_pose, &pair_a, &pair_pose)
#define DISTANCE_B(p) DISTANCE(&pair_a, &pair_pose, p, &pair_pose)
#define DISTANCE_PA(p) DISTANCE(&pair_a, p, &pair_a, &pair_sweep.start)
#define DISTANCE_PB(p) DISTANCE(&pair_a, &pair_sweep.start, &pair_a, p)
ENTRY(cn_polygon_distance, (reset_pair(), DISTANCE(&pair_a, &pair_pose, &pair_b, &pair_pose)),
	SOLIDS(DISTANCE_A); SOLIDS(DISTANCE_B); POSES(DISTANCE_PA); POSES(DISTANCE_PB);
	ARG((reset_pair(), cn_polygon_distance(&pair_a, &pair_pose, &pair_b, &pair_pose, NULL)));)
#define CAST_PAIR(a, pa, b, pb, tx, ty) cn_polygon_cast(a, pa, b, pb, tx, ty, OUT(cn_ray_hit), INT + 64)
#define CAST_A(p) CAST_PAIR(p, &pair_pose, &pair_a, &pair_pose, 1.0f, 2.0f)
#define CAST_B(p) CAST_PAIR(&pair_a, &pair_pose, p, &pair_pose, 1.0f, 2.0f)
#define CAST_PA(p) CAST_PAIR(&pair_a, p, &pair_a, &pair_sweep.start, 1.0f, 2.0f)
#define CAST_PB(p) CAST_PAIR(&pair_a, &pair_sweep.start, &pair_a, p, 1.0f, 2.0f)
ENTRY(cn_polygon_cast, (reset_pair(), CAST_PAIR(&pair_a, &pair_pose, &pair_b, &pair_pose, 1.0f, 2.0f)),
	SOLIDS(CAST_A); SOLIDS(CAST_B); POSES(CAST_PA); POSES(CAST_PB);
	RANGE(x, -2.1e6f, 2.1e6f, (reset_pair(), CAST_PAIR(&pair_a, &pair_pose, &pair_b, &pair_pose, x, 0.0f)));
	RANGE(x, -2.1e6f, 2.1e6f, (reset_pair(), CAST_PAIR(&pair_a, &pair_pose, &pair_b, &pair_pose, 0.0f, x)));
	ARG((reset_pair(), cn_polygon_cast(&pair_a, &pair_pose, &pair_b, &pair_pose, 1.0f, 2.0f, NULL, INT)));
	ARG((reset_pair(), cn_polygon_cast(&pair_a, &pair_pose, &pair_b, &pair_pose, 1.0f, 2.0f, OUT(cn_ray_hit), NULL)));)
#define COLLIDE(a, pa, b, pb) cn_polygon_collide(a, pa, b, pb, 0.1f, OUT(cn_manifold))
#define COLLIDE_A(p) COLLIDE(p, &pair_pose, &pair_a, &pair_pose)
#define COLLIDE_B(p) COLLIDE(&pair_a, &pair_pose, p, &pair_pose)
#define COLLIDE_PA(p) COLLIDE(&pair_a, p, &pair_a, &pair_sweep.start)
#define COLLIDE_PB(p) COLLIDE(&pair_a, &pair_sweep.start, &pair_a, p)
ENTRY(cn_polygon_collide, (reset_pair(), COLLIDE(&pair_a, &pair_pose, &pair_b, &pair_pose)),
	SOLIDS(COLLIDE_A); SOLIDS(COLLIDE_B); POSES(COLLIDE_PA); POSES(COLLIDE_PB); ARG(COLLIDE_A(pair_of(1, 0.0f, v2(0.0f, 0.0f)))); ARG(COLLIDE_B(pair_of(1, 0.0f, v2(0.0f, 0.0f))));
	RANGE(x, -1e-30f, 1.1e6f, (reset_pair(), cn_polygon_collide(&pair_a, &pair_pose, &pair_b, &pair_pose, x, OUT(cn_manifold))));
	ARG((reset_pair(), cn_polygon_collide(&pair_a, &pair_pose, &pair_b, &pair_pose, 0.1f, NULL)));)
#define IMPACT(a, sa, b, sb) cn_polygon_time_of_impact(a, sa, b, sb, 0.0f, OUT(cn_impact))
#define IMPACT_A(p) IMPACT(p, &pair_sweep, &pair_a, &pair_sweep)
#define IMPACT_B(p) IMPACT(&pair_a, &pair_sweep, p, &pair_sweep)
#define IMPACT_SA(s) IMPACT(&pair_a, s, &pair_a, &other_sweep)
#define IMPACT_SB(s) IMPACT(&pair_a, &other_sweep, &pair_a, s)
static cn_sweep other_sweep = { { { 0.0f, 5.0f }, 1.0f, 0.0f }, { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f, 0 };
ENTRY(cn_polygon_time_of_impact, (reset_pair(), IMPACT(&pair_a, &pair_sweep, &pair_b, &other_sweep)),
	SOLIDS(IMPACT_A); SOLIDS(IMPACT_B); SWEEPS(IMPACT_SA); SWEEPS(IMPACT_SB); ARG(IMPACT(&pair_a, NULL, &pair_a, &other_sweep));
	RANGE(x, -1e-30f, 1.1e6f, (reset_pair(), cn_polygon_time_of_impact(&pair_a, &pair_sweep, &pair_b, &other_sweep, x, OUT(cn_impact))));
	ARG((reset_pair(), cn_polygon_time_of_impact(&pair_a, &pair_sweep, &pair_b, &other_sweep, 0.0f, NULL)));)

/* ---- the character mover */

static cn_mover_def md;
static cn_mover mover;
static cn_plane mover_planes[3];

static int reset_mover(void)
{
	reset_queries();
	cn_mover_def_init(&md);
	memset(&mover, 0, sizeof mover);
	mover.position_m = v2(0.0f, 3.0f);
	memset(mover_planes, 0, sizeof mover_planes);
	mover_planes[0].normal = mover_planes[1].normal = v2(0.0f, 1.0f);
	mover_planes[2].normal = v2(1.0f, 0.0f);
	mover_planes[0].push_m = mover_planes[0].push_max_m = 1.0f;
	return 0;
}
#define MOV(field, value) (reset_mover(), md.field = (value), &md)
#define MO(field, value) (reset_mover(), mover.field = (value), &mover)
#define PL(field, value) (reset_mover(), mover_planes[1].field = (value), mover_planes)

ENTRY(cn_mover_def_init, (cn_mover_def_init(&md), CN_OK), cn_mover_def_init(NULL);)
#define MOVE(d) cn_mover_move(W, d, 0.01f, &mover)
ENTRY(cn_mover_move, (reset_mover(), MOVE(&md)),
	NOW(cn_mover_move(NULL, MOV(flags, 0), 0.01f, &mover)); ARG(MOVE(NULL)); ARG(cn_mover_move(W, MOV(flags, 0), 0.01f, NULL)); SIZES(x, MOVE(MOV(struct_size, x)));
	FLAGS(x, 1, MOVE(MOV(flags, x))); VECTOR(v, MOVE(MOV(up, v))); ARG(MOVE(MOV(up, v2(0.0f, 0.0f)))); RANGE(x, -1e-30f, 1.6f, MOVE(MOV(slope_limit_rad, x)));
	INTEGER(x, 0, 17, MOVE(MOV(shape.count, x))); NOT_NEGATIVE(x, MOVE(MOV(shape.radius_m, x))); ARG(MOVE(MOV(shape.radius_m, 0.0f))); POSITION(v, MOVE(MOV(shape.points_m[1], v)));
	NOT_NEGATIVE(x, MOVE(MOV(step_height_m, x))); NOT_NEGATIVE(x, MOVE(MOV(snap_m, x))); RANGE(x, -1.1e6f, 1.1e6f, MOVE(MOV(gravity_scale, x)));
	NOT_NEGATIVE(x, MOVE(MOV(push_force_N, x))); INTEGER(x, 0, 65, MOVE(MOV(iterations_max, x)));
	FLAGS(x, 3, MOVE(MOV(filter.flags, x))); BODY_BUT_ZERO(h, MOVE(MOV(filter.ignored_body, h)));
	RANGE(x, -0.01f, 1.01f, cn_mover_move(W, MOV(flags, 0), x, &mover)); ARG(cn_mover_move(W, MOV(flags, 0), 0.0f, &mover));
	POSITION(v, cn_mover_move(W, &md, 0.01f, MO(position_m, v))); VECTOR(v, cn_mover_move(W, &md, 0.01f, MO(velocity_mps, v)));
	VECTOR(v, cn_mover_move(W, &md, 0.01f, MO(ground_normal, v))); VECTOR(v, cn_mover_move(W, &md, 0.01f, MO(ground_point_m, v)));
	VECTOR(v, cn_mover_move(W, &md, 0.01f, MO(ground_local_m, v))); VECTOR(v, cn_mover_move(W, &md, 0.01f, MO(ground_velocity_mps, v)));
	FLAGS(x, 3, cn_mover_move(W, &md, 0.01f, MO(flags, x)));)
#define MOVER_COLLIDE(p) cn_mover_collide(W, p, 0.0f, 0.5f, 0.1f, NULL, OUT(cn_plane) + 4, 8, INT)
#define MOVER_COLLIDE_BY(fl) cn_mover_collide(W, &polygon, 0.0f, 0.5f, 0.1f, fl, OUT(cn_plane) + 4, 8, INT)
ENTRY(cn_mover_collide, cn_mover_collide(W, (reset_queries(), &polygon), 0.0f, 0.5f, 0.1f, &query_filter, OUT(cn_plane) + 4, 8, INT),
	REGIONS(MOVER_COLLIDE); FILTERS(MOVER_COLLIDE_BY); NOW(cn_mover_collide(NULL, &polygon, 0.0f, 0.5f, 0.1f, NULL, OUT(cn_plane) + 4, 8, INT));
	POSITION(v, cn_mover_collide(W, (reset_queries(), &polygon), v.x, v.y, 0.1f, NULL, OUT(cn_plane) + 4, 8, INT));
	RANGE(x, -1e-30f, 1.1e6f, cn_mover_collide(W, (reset_queries(), &polygon), 0.0f, 0.5f, x, NULL, OUT(cn_plane) + 4, 8, INT));
	ARG(cn_mover_collide(W, &polygon, 0.0f, 0.5f, 0.1f, NULL, NULL, 1, INT)); ARG(cn_mover_collide(W, &polygon, 0.0f, 0.5f, 0.1f, NULL, OUT(cn_plane) + 4, -1, INT));
	ARG(cn_mover_collide(W, &polygon, 0.0f, 0.5f, 0.1f, NULL, OUT(cn_plane) + 4, 8, NULL));)
#define SOLVE(p, n) cn_mover_solve(p, n, 0.5f, -0.5f, OUT(cn_vec2), OUT(float) + 8)
ENTRY(cn_mover_solve, (reset_mover(), SOLVE(mover_planes, 3)),
	ARG(SOLVE(NULL, 1)); INTEGER(x, -1, 65, (reset_mover(), SOLVE(mover_planes, x))); VECTOR(v, SOLVE(PL(normal, v), 3)); ARG(SOLVE(PL(normal, v2(0.0f, 0.9f)), 3));
	RANGE(x, -1.1e9f, 1.1e9f, SOLVE(PL(separation_m, x), 3)); NOT_NEGATIVE(x, SOLVE(PL(push_max_m, x), 3));
	VECTOR(v, (reset_mover(), cn_mover_solve(mover_planes, 3, v.x, v.y, OUT(cn_vec2), OUT(float) + 8)));
	ARG((reset_mover(), cn_mover_solve(mover_planes, 3, 0.5f, -0.5f, NULL, OUT(float)))); ARG((reset_mover(), cn_mover_solve(mover_planes, 3, 0.5f, -0.5f, OUT(cn_vec2), NULL)));)
#define CLIP(p, n) cn_mover_clip(p, n, 0.5f, -0.5f, OUT(cn_vec2))
ENTRY(cn_mover_clip, (reset_mover(), CLIP(mover_planes, 3)),
	ARG(CLIP(NULL, 1)); INTEGER(x, -1, 65, (reset_mover(), CLIP(mover_planes, x))); VECTOR(v, CLIP(PL(normal, v), 3)); ARG(CLIP(PL(normal, v2(0.0f, 0.9f)), 3));
	RANGE(x, -1.1e9f, 1.1e9f, CLIP(PL(separation_m, x), 3)); NOT_NEGATIVE(x, CLIP(PL(push_max_m, x), 3)); FLOAT(x, CLIP(PL(push_m, x), 3));
	VECTOR(v, (reset_mover(), cn_mover_clip(mover_planes, 3, v.x, v.y, OUT(cn_vec2)))); ARG((reset_mover(), cn_mover_clip(mover_planes, 3, 0.5f, -0.5f, NULL)));)

/* ---- trees */

static cn_tree *tree;
static uint32_t tree_item, tree_stale;
static cn_aabb tree_box;
static cn_ray tree_ray;

/* A tree with one item, and the name of one that is gone. */
static int tree_make(void)
{
	tree_box.lower_m = v2(-1.0f, 0.0f);
	tree_box.upper_m = v2(1.0f, 2.0f);
	tree_ray.origin_m = v2(-5.0f, 1.0f);
	tree_ray.translation_m = v2(10.0f, 0.0f);
	CHECK(cn_tree_create(0.1f, NULL, NULL, NULL, &tree) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 1, &tree_stale) == CN_OK && cn_tree_remove(tree, tree_stale) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 2, &tree_item) == CN_OK);
	return 0;
}

static cn_result tree_end(cn_result result)
{
	cn_tree_destroy(tree);
	tree = NULL;
	return result;
}

static int32_t tree_visit(uint32_t item, uint64_t user_data, void *user) { return item != 0 && user_data == 2 && user == NULL; }
static float tree_hit(uint32_t item, uint64_t user_data, float fraction, void *user) { return item != 0 && user_data == 2 && user == NULL ? fraction : 0.0f; }

#define TREE(call) (tree_make(), tree_end(call))
#define TREE_BOXES(call) do { const cn_aabb *b_ = NULL; ARG(call(b_)); b_ = &tree_box; \
	VECTOR(v, (tree_box.lower_m = v, call(b_))); tree_box.lower_m = v2(-1.0f, 0.0f); VECTOR(v, (tree_box.upper_m = v, call(b_))); \
	tree_box.upper_m = v2(-1.5f, 2.0f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, -0.5f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, 2.0f); } while (0)
#define TREE_ITEMS(h, call) do { uint32_t h = 0; BAD(CN_ERROR_HANDLE, call); h = tree_stale; BAD(CN_ERROR_HANDLE, call); \
	h = tree_item + 1; BAD(CN_ERROR_HANDLE, call); h = 0xFFFFFFFFu; BAD(CN_ERROR_HANDLE, call); } while (0)

ENTRY(cn_tree_create, TREE(CN_OK), NOT_NEGATIVE(x, cn_tree_create(x, NULL, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, NULL, NULL, NULL));
	ARG(cn_tree_create(0.1f, test_alloc, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, test_free, NULL, OUT(cn_tree *)));)
ENTRY(cn_tree_destroy, TREE(CN_OK), cn_tree_destroy(NULL);)
#define INSERT_BOX(b) cn_tree_insert(tree, b, 0, OUT(uint32_t))
ENTRY(cn_tree_insert, TREE(cn_tree_insert(tree, &tree_box, 3, &tree_item)),
	tree_make(); TREE_BOXES(INSERT_BOX); NOW(cn_tree_insert(NULL, &tree_box, 0, OUT(uint32_t))); ARG(cn_tree_insert(tree, &tree_box, 0, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_remove, TREE(cn_tree_remove(tree, tree_item)),
	tree_make(); TREE_ITEMS(h, cn_tree_remove(tree, h)); NOW(cn_tree_remove(NULL, tree_item)); tree_end(CN_OK);)
#define MOVE_BOX(b) cn_tree_move(tree, tree_item, b)
ENTRY(cn_tree_move, TREE(cn_tree_move(tree, tree_item, &tree_box)),
	tree_make(); TREE_BOXES(MOVE_BOX); TREE_ITEMS(h, cn_tree_move(tree, h, &tree_box)); NOW(cn_tree_move(NULL, tree_item, &tree_box)); tree_end(CN_OK);)
ENTRY(cn_tree_get_box, TREE(cn_tree_get_box(tree, tree_item, OUT(cn_aabb))),
	tree_make(); TREE_ITEMS(h, cn_tree_get_box(tree, h, OUT(cn_aabb))); NOW(cn_tree_get_box(NULL, tree_item, OUT(cn_aabb)));
	ARG(cn_tree_get_box(tree, tree_item, NULL)); tree_end(CN_OK);)
#define QUERY_BOX(b) cn_tree_query(tree, b, tree_visit, NULL)
ENTRY(cn_tree_query, TREE(cn_tree_query(tree, &tree_box, tree_visit, NULL)),
	tree_make(); TREE_BOXES(QUERY_BOX); NOW(cn_tree_query(NULL, &tree_box, tree_visit, NULL)); ARG(cn_tree_query(tree, &tree_box, NULL, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_cast_ray, TREE(cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)),
	tree_make(); NOW(cn_tree_cast_ray(NULL, &tree_ray, tree_hit, NULL)); ARG(cn_tree_cast_ray(tree, NULL, tree_hit, NULL));
	ARG(cn_tree_cast_ray(tree, &tree_ray, NULL, NULL)); VECTOR(v, (tree_ray.origin_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)));
	tree_ray.origin_m = v2(0.0f, 0.0f); VECTOR(v, (tree_ray.translation_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL))); tree_end(CN_OK);)
ENTRY(cn_tree_get_stats, TREE(cn_tree_get_stats(tree, INT, INT)),
	tree_make(); NOW(cn_tree_get_stats(NULL, INT, INT)); ARG(cn_tree_get_stats(tree, NULL, INT)); ARG(cn_tree_get_stats(tree, INT, NULL)); tree_end(CN_OK);)

#endif
