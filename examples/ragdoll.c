/* examples/ragdoll.c - a ragdoll of ten capsules on nine hinges with limits falls down a stair. A table describes it. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define BONES 10

typedef struct bone {
	int parent;          /* its hinge is at the bone's upper end */
	float top_y, bottom_y;
	float radius;
	float lower, upper;  /* of the hinge's angle, radians */
} bone;

static const bone bones[BONES] = {
	{ -1, 1.45f, 1.00f, 0.11f, 0.0f, 0.0f },                                        /* 0 torso */
	{ 0, 1.65f, 1.60f, 0.12f, -0.5f, 0.5f },                                        /* 1 head */
	{ 0, 0.95f, 0.55f, 0.08f, -0.5f, 1.3f }, { 2, 0.50f, 0.08f, 0.06f, -2.0f, 0.0f }, /* 2, 3 a leg */
	{ 0, 0.95f, 0.55f, 0.08f, -0.5f, 1.3f }, { 4, 0.50f, 0.08f, 0.06f, -2.0f, 0.0f }, /* 4, 5 the other */
	{ 0, 1.42f, 1.15f, 0.06f, -1.0f, 2.5f }, { 6, 1.10f, 0.85f, 0.05f, 0.0f, 2.0f },  /* 6, 7 an arm */
	{ 0, 1.42f, 1.15f, 0.06f, -1.0f, 2.5f }, { 8, 1.10f, 0.85f, 0.05f, 0.0f, 2.0f },  /* 8, 9 the other */
};

static void add_ragdoll(cn_world *world, float x, float y, cn_body out[BONES], cn_joint out_joints[BONES])
{
	for (int i = 0; i < BONES; ++i) {
		const bone *b = &bones[i];
		const float middle = 0.5f * (b->top_y + b->bottom_y), half = 0.5f * (b->top_y - b->bottom_y);
		const cn_capsule capsule = { { 0.0f, -half }, { 0.0f, half }, b->radius };
		cn_body_def body_def;
		cn_shape_def shape_def;
		cn_body_def_init(&body_def);
		body_def.position_m = (cn_vec2){ x, y + middle };
		cn_body_create(world, &body_def, &out[i]);
		cn_shape_def_init(&shape_def);
		shape_def.body = out[i];
		shape_def.density_kgpm2 = 100.0f;
		shape_def.filter.group = -1; /* its parts do not collide: one negative group for each ragdoll */
		cn_shape_create_capsule(world, &shape_def, &capsule, NULL);
		if (b->parent < 0)
			continue;
		const bone *p = &bones[b->parent];
		const float hinge = i == 1 ? 1.5f : b->top_y, parent_middle = 0.5f * (p->top_y + p->bottom_y);
		cn_revolute_def def;
		cn_revolute_def_init(&def);
		def.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR; /* a motor of speed 0 is friction */
		def.base.body_a = out[b->parent];
		def.base.body_b = out[i];
		def.base.anchor_a_m.y = hinge - parent_middle;
		def.base.anchor_b_m.y = hinge - middle;
		def.lower_angle_rad = b->lower;
		def.upper_angle_rad = b->upper;
		def.motor_torque_max_Nm = 1.0f;
		cn_joint_create_revolute(world, &def, &out_joints[i]);
	}
}

static void add_stair(cn_world *world)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_vec2 points[18];
	int32_t count = 0;
	cn_body_def_init(&body_def);
	body_def.type = CN_BODY_STATIC;
	cn_shape_def_init(&shape_def);
	cn_body_create(world, &body_def, &shape_def.body);
	points[count++] = (cn_vec2){ 20.0f, -2.4f }; /* from right to left: solid below */
	for (int step = 7; step >= 0; --step) {
		points[count++] = (cn_vec2){ 0.5f * (float)step, -0.3f * (float)(step + 1) };
		points[count++] = (cn_vec2){ 0.5f * (float)step, -0.3f * (float)step };
	}
	points[count++] = (cn_vec2){ -5.0f, 0.0f };
	const cn_chain stair = { points, count, 0 };
	cn_shape_create_chain(world, &shape_def, &stair, NULL);
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_body body[BONES];
	cn_joint joint[BONES] = { 0 };
	cn_vec2 torso;
	cn_counters counters;
	float worst_m = 0.0f, worst_rad = 0.0f;
	int step = 0;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_stair(world);
	add_ragdoll(world, -0.6f, 0.02f, body, joint);
	for (int i = 0; i < BONES; ++i)
		cn_body_set_velocity(world, body[i], 2.5f * bones[i].top_y, 0.0f, 0.0f); /* a push, the most at the head */
	do {
		cn_world_step(world, 1.0f / 60.0f);
		for (int i = 1; i < BONES; ++i) {
			float gap_m, beyond_rad;
			cn_joint_get_error(world, joint[i], &gap_m, &beyond_rad);
			worst_m = fmaxf(worst_m, gap_m);
			worst_rad = fmaxf(worst_rad, beyond_rad);
		}
		cn_world_get_counters(world, &counters);
	} while (counters.bodies_awake > 0 && ++step < 1200);
	cn_body_get_center(world, body[0], &torso);
	printf("asleep after %.1f s at (%.1f, %.1f); worst gap of a hinge %.2f mm, beyond a limit %.3f rad\n", step / 60.0, (double)torso.x,
		(double)torso.y, 1000.0 * (double)worst_m, (double)worst_rad);
	cn_world_destroy(world);
	return !(step < 1200 && torso.y < -1.0f && worst_m < 0.005f && worst_rad < 0.1f);
}
