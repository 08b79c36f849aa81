/*
 * test/arch/queries.h - the scene that asks: every query of a world and of two shapes, the mover, outlines.
 */
#ifndef CAIRN_TEST_ARCH_QUERIES_H
#define CAIRN_TEST_ARCH_QUERIES_H

#include "build.h"

static void mix_hit(const cn_ray_hit *hit)
{
	mix(hit->shape);
	mix(hit->body);
	mix((uint32_t)hit->child);
	mix_float(hit->fraction);
	mix_vec2(hit->point_m);
	mix_vec2(hit->normal);
	mix_float(hit->depth_m);
}

static void mix_shapes(const cn_shape *shapes, int32_t count)
{
	int32_t k;
	mix((uint32_t)count);
	for (k = 0; k < count && k < 32; ++k)
		mix(shapes[k]);
}

static void query_world(const cn_world *world, int32_t k)
{
	cn_ray_hit hit, hits[32];
	cn_shape shapes[32];
	cn_closest closest;
	cn_polygon moving = hull_of(5, 0.3f, 0.1f);
	cn_circle circle;
	cn_aabb box;
	cn_ray ray;
	int32_t any, count, h;
	ray.origin_m = arch_random_vec2(-8.0f, 8.0f, 0.0f, 6.0f);
	ray.translation_m = arch_random_vec2(-9.0f, 9.0f, -9.0f, 2.0f);
	MUST(cn_world_cast_ray(world, &ray, NULL, &hit));
	mix_hit(&hit);
	MUST(cn_world_cast_ray_any(world, &ray, NULL, &any));
	mix((uint32_t)any);
	MUST(cn_world_cast_ray_all(world, &ray, NULL, hits, 32, &count));
	mix((uint32_t)count);
	for (h = 0; h < count && h < 32; ++h)
		mix_hit(&hits[h]);
	if (k % 3 == 0)
		moving.count = 1 + k % 2; /* a circle, a capsule */
	for (h = 0; h < moving.count; ++h)
		moving.points_m[h] = vec2(moving.points_m[h].x + ray.origin_m.x, moving.points_m[h].y + ray.origin_m.y);
	MUST(cn_world_cast_shape(world, &moving, ray.translation_m.x, ray.translation_m.y, NULL, &hit));
	mix_hit(&hit);
	MUST(cn_world_overlap_polygon(world, &moving, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	circle.center_m = ray.origin_m;
	circle.radius_m = 1.0f;
	MUST(cn_world_overlap_circle(world, &circle, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	box.lower_m = vec2(ray.origin_m.x - 1.0f, ray.origin_m.y - 0.5f);
	box.upper_m = vec2(ray.origin_m.x + 1.0f, ray.origin_m.y + 0.5f);
	MUST(cn_world_overlap_aabb(world, &box, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	MUST(cn_world_overlap_point(world, ray.origin_m.x, ray.origin_m.y, NULL, shapes, 32, &count));
	mix_shapes(shapes, count);
	MUST(cn_world_closest_point(world, ray.origin_m.x, ray.origin_m.y, 10.0f, NULL, &closest));
	mix(closest.shape);
	mix_float(closest.distance_m);
	mix_vec2(closest.point_m);
	mix_vec2(closest.normal);
}

static cn_pose pose_of(int32_t k, float x, float y)
{
	static const cn_vec2 rotations[] = { { 1.0f, 0.0f }, { 0.8f, 0.6f }, { 0.0f, -1.0f }, { -0.6f, 0.8f } };
	cn_pose pose;
	pose.position_m = vec2(x, y);
	pose.cosine = rotations[k % 4].x;
	pose.sine = rotations[k % 4].y;
	return pose;
}

static void query_pair(int32_t k)
{
	cn_polygon a = hull_of(7, 0.5f, 0.0f), b = hull_of(6, 0.4f, k % 2 ? 0.1f : 0.0f);
	cn_vec2 place = arch_random_vec2(-1.5f, 1.5f, -1.5f, 1.5f);
	cn_pose pose_a = pose_of(k, 0.0f, 0.0f), pose_b = pose_of(k + 1, place.x, place.y);
	cn_distance distance;
	cn_manifold manifold;
	cn_ray_hit hit;
	cn_sweep sweep_a, sweep_b;
	cn_impact impact;
	int32_t any, p;
	MUST(cn_polygon_distance(&a, &pose_a, &b, &pose_b, &distance));
	mix_vec2(distance.point_a_m);
	mix_vec2(distance.point_b_m);
	mix_vec2(distance.normal);
	mix_float(distance.distance_m);
	MUST(cn_polygon_collide(&a, &pose_a, &b, &pose_b, 0.5f, &manifold));
	mix_vec2(manifold.normal);
	for (p = 0; p < manifold.point_count; ++p) {
		mix_vec2(manifold.points[p].point_m);
		mix_float(manifold.points[p].separation_m);
		mix(manifold.points[p].feature_id);
	}
	MUST(cn_polygon_cast(&a, &pose_a, &b, &pose_b, -3.0f * pose_b.position_m.x, -3.0f * pose_b.position_m.y, &hit, &any));
	mix((uint32_t)any);
	mix_float(hit.fraction);
	mix_vec2(hit.normal);
	memset(&sweep_a, 0, sizeof sweep_a);
	sweep_a.start = pose_a;
	sweep_b = sweep_a;
	sweep_b.start = pose_of(k + 1, 3.0f, arch_random(-0.5f, 0.5f));
	sweep_b.translation_m = vec2(-5.0f, 0.0f);
	sweep_b.turn_rad = arch_random(-3.0f, 3.0f);
	MUST(cn_polygon_time_of_impact(&a, &sweep_a, &b, &sweep_b, 0.01f, &impact));
	mix((uint32_t)impact.state);
	mix_float(impact.fraction);
	mix_vec2(impact.normal);
}

static void walk(cn_world *world)
{
	cn_mover_def def;
	cn_mover mover;
	int32_t k;
	cn_mover_def_init(&def);
	memset(&mover, 0, sizeof mover);
	mover.position_m = vec2(-7.0f, 4.0f);
	for (k = 0; k < 90; ++k) {
		MUST(cn_world_step(world, 1.0f / 60.0f));
		mover.velocity_mps.x = 4.0f;
		if (k % 30 == 29 && (mover.flags & CN_MOVER_ON_GROUND))
			mover.velocity_mps.y = 6.0f;
		MUST(cn_mover_move(world, &def, 1.0f / 60.0f, &mover));
		mix_vec2(mover.position_m);
		mix_vec2(mover.velocity_mps);
		mix(mover.flags);
		mix_float(mover.squeezed_m);
	}
}

static void mix_outlines(void)
{
	static const cn_vec2 outline[] = { { 0.0f, 0.0f }, { 4.0f, 0.0f }, { 4.0f, 3.0f }, { 2.1f, 1.0f }, { 2.0f, 3.5f }, { 1.0f, 1.5f }, { 0.0f, 3.0f } };
	cn_polygon pieces[5];
	cn_vec2 points[64];
	float values[64];
	int32_t count, k, p;
	MUST(cn_outline_decompose(outline, 7, 1.0f, pieces, 5, &count));
	for (k = 0; k < count; ++k)
		for (p = 0; p < pieces[k].count; ++p)
			mix_vec2(pieces[k].points_m[p]);
	for (k = 0; k < 64; ++k)
		values[k] = arch_random(-1.0f, 1.0f);
	MUST(cn_outline_from_field(values, 64, 8, 0.0f, 0.0f, 0.0f, 0.5f, 0, points, 64, &count));
	MUST(cn_outline_simplify(points, count, 1, 0.1f, points, 64, &count));
	for (k = 0; k < count; ++k)
		mix_vec2(points[k]);
}

static void scene_queries(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_TREE);
	int32_t k;
	add_ground(world);
	add_rain(world, 30);
	steps(world, 60);
	for (k = 0; k < 60; ++k)
		query_world(world, k);
	for (k = 0; k < 60; ++k)
		query_pair(k);
	walk(world);
	mix_outlines();
	mix_world(world);
	cn_world_destroy(world);
}

#endif
