/*
 * examples/scenes/build.c - short forms of the API calls that scenes are made of, and opening,
 * stepping and closing a run.
 */
#include "scenes/build.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int32_t scene_check(scene_run *run, cn_result result)
{
	if (run->result == CN_OK && result != CN_OK) {
		const char *why = cn_world_error_text(run->world);
		run->result = result;
		snprintf(run->error_text, sizeof run->error_text, "%s", why[0] != '\0' ? why : cn_result_text(result));
	}
	return run->result == CN_OK;
}

void *scene_memory(scene_run *run, uint64_t bytes)
{
	run->memory = calloc(1, (size_t)bytes);
	if (run->memory == NULL)
		scene_check(run, CN_ERROR_MEMORY);
	return run->memory;
}

/* ------------------------------------------------------------------ numbers */

/* sin x = x - x^3/3! + ...; 14 terms leave less than 1e-13 on [-pi, pi]. */
static double sine_series(double x)
{
	double term = x, sum = x;
	for (int32_t k = 1; k < 14; ++k) {
		term = -term * x * x / (double)((2 * k) * (2 * k + 1));
		sum += term;
	}
	return sum;
}

float scene_sine(double angle_rad)
{
	const double pi = 3.14159265358979323846;
	while (angle_rad > pi)
		angle_rad -= 2.0 * pi;
	while (angle_rad < -pi)
		angle_rad += 2.0 * pi;
	return (float)sine_series(angle_rad);
}

float scene_cosine(double angle_rad) { return scene_sine(angle_rad + 0.5 * 3.14159265358979323846); }

/* ------------------------------------------------------------------ bodies */

cn_body scene_body_with(scene_run *run, const cn_body_def *def)
{
	cn_body body = 0;
	if (run->result == CN_OK)
		scene_check(run, cn_body_create(run->world, def, &body));
	return body;
}

cn_body scene_body(scene_run *run, int32_t type, float x_m, float y_m)
{
	cn_body_def def;
	cn_body_def_init(&def);
	def.type = type;
	def.position_m = scene_vec(x_m, y_m);
	return scene_body_with(run, &def);
}

cn_body scene_simple_box(scene_run *run, float x_m, float y_m, float half_width_m, float half_height_m)
{
	cn_body body = scene_body(run, CN_BODY_DYNAMIC, x_m, y_m);
	cn_shape_def def = scene_surface(body, 1.0f, 0.6f, 0.0f);
	scene_box(run, &def, half_width_m, half_height_m, 0.0f);
	return body;
}

/* ------------------------------------------------------------------ shapes */

cn_shape_def scene_surface(cn_body body, float density_kgpm2, float friction, float restitution)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	def.density_kgpm2 = density_kgpm2;
	def.material.static_friction = friction;
	def.material.dynamic_friction = friction;
	def.material.restitution = restitution;
	return def;
}

void scene_circle(scene_run *run, const cn_shape_def *def, float radius_m)
{
	cn_circle circle;
	circle.center_m = scene_vec(0.0f, 0.0f);
	circle.radius_m = radius_m;
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_circle(run->world, def, &circle, NULL));
}

void scene_capsule(scene_run *run, const cn_shape_def *def, cn_vec2 a_m, cn_vec2 b_m, float radius_m)
{
	cn_capsule capsule;
	capsule.a_m = a_m;
	capsule.b_m = b_m;
	capsule.radius_m = radius_m;
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_capsule(run->world, def, &capsule, NULL));
}

void scene_box(scene_run *run, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m)
{
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_box(run->world, def, half_width_m, half_height_m, radius_m, NULL));
}

void scene_regular_polygon(scene_run *run, const cn_shape_def *def, int32_t count, float radius_m)
{
	cn_polygon polygon;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = count;
	for (int32_t i = 0; i < count; ++i) {
		double angle = 2.0 * 3.14159265358979323846 * (double)i / (double)count;
		polygon.points_m[i] = scene_vec(radius_m * scene_cosine(angle), radius_m * scene_sine(angle));
	}
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_polygon(run->world, def, &polygon, NULL));
}

void scene_offset_box(scene_run *run, const cn_shape_def *def, cn_vec2 center_m, float half_width_m, float half_height_m)
{
	cn_shape_def moved = *def;
	moved.offset_m = center_m;
	scene_box(run, &moved, half_width_m, half_height_m, 0.0f);
}

void scene_edge(scene_run *run, const cn_shape_def *def, cn_vec2 a_m, cn_vec2 b_m)
{
	cn_edge edge;
	edge.a_m = a_m;
	edge.b_m = b_m;
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_edge(run->world, def, &edge, NULL));
}

void scene_chain(scene_run *run, const cn_shape_def *def, const cn_vec2 *points_m, int32_t count, uint32_t loop)
{
	cn_chain chain;
	memset(&chain, 0, sizeof chain);
	chain.points_m = points_m;
	chain.count = count;
	chain.loop = loop;
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_chain(run->world, def, &chain, NULL));
}

/* ------------------------------------------------------------------ joints */

cn_revolute_def scene_revolute(cn_body body_a, cn_vec2 anchor_a_m, cn_body body_b, cn_vec2 anchor_b_m)
{
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	def.base.body_a = body_a;
	def.base.body_b = body_b;
	def.base.anchor_a_m = anchor_a_m;
	def.base.anchor_b_m = anchor_b_m;
	return def;
}

cn_joint scene_join(scene_run *run, const cn_revolute_def *def)
{
	cn_joint joint = 0;
	if (run->result == CN_OK)
		scene_check(run, cn_joint_create_revolute(run->world, def, &joint));
	return joint;
}

void scene_join_motor(scene_run *run, cn_body body_a, cn_vec2 anchor_a_m, cn_body body_b, cn_vec2 anchor_b_m, float speed_radps, float torque_Nm)
{
	cn_revolute_def def = scene_revolute(body_a, anchor_a_m, body_b, anchor_b_m);
	def.base.flags |= CN_JOINT_MOTOR;
	def.motor_speed_radps = speed_radps;
	def.motor_torque_max_Nm = torque_Nm;
	scene_join(run, &def);
}

/* ------------------------------------------------------------------ runs */

void scene_world_def(const scene *which, cn_world_def *out)
{
	cn_world_def_init(out);
	out->gravity_mps2 = which->gravity_mps2;
	if (which->flags & SCENE_SLEEP)
		out->flags |= CN_WORLD_SLEEP;
	else
		out->flags &= ~(uint32_t)CN_WORLD_SLEEP;
}

cn_result scene_open(scene_run *run, const scene *which, const cn_world_def *def)
{
	cn_world_def own;
	memset(run, 0, sizeof *run);
	run->scene = which;
	scene_world_def(which, &own);
	if (!scene_check(run, cn_world_create(def != NULL ? def : &own, &run->world)))
		return run->result;
	which->create(run);
	if (run->result != CN_OK)
		scene_close(run);
	return run->result;
}

cn_result scene_before_step(scene_run *run)
{
	if (run->result == CN_OK && run->scene->step != NULL)
		run->scene->step(run, run->step_index);
	return run->result;
}

cn_result scene_step(scene_run *run)
{
	if (scene_before_step(run) == CN_OK && scene_check(run, cn_world_step(run->world, SCENE_STEP_S)))
		++run->step_index;
	return run->result;
}

void scene_close(scene_run *run)
{
	cn_world_destroy(run->world);
	free(run->memory);
	run->world = NULL;
	run->memory = NULL;
}
