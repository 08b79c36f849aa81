/*
 * examples/scenes/ragdolls.c - the ragdoll, and scenes in which many of them fall: rain (over five
 * long floors, made and destroyed all the time) and ragdolls (a heap in a valley, for pictures).
 *
 *        head                  Eleven bodies, ten revolute joints. A bone is a capsule along y;
 *    arm torso arm             feet are rounded polygons on the lower legs. The joints' motors of
 *        hip                   speed 0 are their friction, springs pull them to their rest angles.
 *      leg leg
 */
#include "scenes/build.h"

enum { HIP, TORSO, HEAD, UPPER_LEG_A, LOWER_LEG_A, UPPER_LEG_B, LOWER_LEG_B, UPPER_ARM_A, LOWER_ARM_A, UPPER_ARM_B, LOWER_ARM_B };

typedef struct bone {
	float y_m;                /* of the body above the ragdoll's base */
	float from_m, to_m;       /* capsule along y in the body's frame */
	float radius_m;
	float linear_damping_per_s;
	int32_t parent;           /* -1: none */
	float joint_y_m;          /* above the base */
	float lower_pi, upper_pi; /* limits, in units of pi */
	float reference_pi;       /* rest angle */
	float friction;           /* of the joint, times 0.05 Nm */
} bone;

static const bone bones[SCENE_RAGDOLL_BODIES] = {
	{0.95f, -0.02f, 0.02f, 0.095f, 0.0f, -1, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f},
	{1.2f, -0.135f, 0.135f, 0.09f, 0.0f, HIP, 1.0f, -0.25f, 0.0f, 0.0f, 0.5f},
	{1.475f, -0.038f, 0.039f, 0.075f, 0.1f, TORSO, 1.4f, -0.3f, 0.1f, 0.0f, 0.25f},
	{0.775f, -0.125f, 0.125f, 0.06f, 0.0f, HIP, 0.9f, -0.05f, 0.4f, 0.0f, 1.0f},
	{0.475f, -0.155f, 0.125f, 0.045f, 0.0f, UPPER_LEG_A, 0.625f, -0.5f, -0.02f, 0.0f, 0.5f},
	{0.775f, -0.125f, 0.125f, 0.06f, 0.0f, HIP, 0.9f, -0.05f, 0.4f, 0.0f, 1.0f},
	{0.475f, -0.155f, 0.125f, 0.045f, 0.0f, UPPER_LEG_B, 0.625f, -0.5f, -0.02f, 0.0f, 0.5f},
	{1.225f, -0.125f, 0.125f, 0.035f, 0.0f, TORSO, 1.35f, -0.1f, 0.8f, 0.0f, 0.5f},
	{0.975f, -0.125f, 0.125f, 0.03f, 0.1f, UPPER_ARM_A, 1.1f, -0.2f, 0.3f, 0.25f, 0.1f},
	{1.225f, -0.125f, 0.125f, 0.035f, 0.0f, TORSO, 1.35f, -0.1f, 0.8f, 0.0f, 0.5f},
	{0.975f, -0.125f, 0.125f, 0.03f, 0.1f, UPPER_ARM_B, 1.1f, -0.2f, 0.3f, 0.25f, 0.1f},
};

static void add_foot(scene_run *run, const cn_shape_def *bone_def)
{
	cn_shape_def def = *bone_def;
	cn_polygon foot = {4, 0.015f, {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}}};
	def.material.static_friction = 0.05f;
	def.material.dynamic_friction = 0.05f;
	def.filter.mask = 1;
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_polygon(run->world, &def, &foot, NULL));
}

static cn_body add_bone(scene_run *run, const bone *b, float x_m, float y_m, int32_t group, int32_t has_foot)
{
	cn_body_def body_def;
	cn_body_def_init(&body_def);
	body_def.position_m = scene_vec(x_m, y_m + b->y_m);
	body_def.linear_damping_per_s = b->linear_damping_per_s;
	cn_body body = scene_body_with(run, &body_def);
	cn_shape_def def = scene_surface(body, 1.0f, 0.2f, 0.0f);
	def.filter.category = 2;
	def.filter.mask = 1 | 2;
	def.filter.group = group;
	scene_capsule(run, &def, scene_vec(0.0f, b->from_m), scene_vec(0.0f, b->to_m), b->radius_m);
	if (has_foot)
		add_foot(run, &def);
	return body;
}

static void add_bone_joint(scene_run *run, const bone *b, cn_body parent, cn_body child)
{
	cn_vec2 anchor_parent = scene_vec(0.0f, b->joint_y_m - bones[b->parent].y_m);
	cn_revolute_def def = scene_revolute(parent, anchor_parent, child, scene_vec(0.0f, b->joint_y_m - b->y_m));
	def.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR | CN_JOINT_SPRING;
	def.reference_angle_rad = b->reference_pi * SCENE_PI;
	def.lower_angle_rad = b->lower_pi * SCENE_PI;
	def.upper_angle_rad = b->upper_pi * SCENE_PI;
	def.motor_torque_max_Nm = 0.05f * b->friction;
	def.spring_hertz = 5.0f;
	def.spring_damping_ratio = 0.5f;
	scene_join(run, &def);
}

void scene_ragdoll(scene_run *run, float x_m, float y_m, int32_t group, cn_body out[SCENE_RAGDOLL_BODIES])
{
	for (int32_t i = 0; i < SCENE_RAGDOLL_BODIES; ++i) {
		out[i] = add_bone(run, &bones[i], x_m, y_m, group, i == LOWER_LEG_A || i == LOWER_LEG_B);
		if (bones[i].parent >= 0)
			add_bone_joint(run, &bones[i], out[bones[i].parent], out[i]);
	}
}

/* ------------------------------------------------------------------ rain */

#define RAIN_FLOORS 5
#define RAIN_COLUMNS 40
#define RAIN_GROUP 5
#define RAIN_WIDTH_M 250.0f

/* Bodies of column c, floor f, member m start at ((c * floors + f) * group + m) * 11. */
typedef struct rain_state {
	cn_body bodies[RAIN_COLUMNS * RAIN_FLOORS * RAIN_GROUP * SCENE_RAGDOLL_BODIES];
	int32_t columns_made;
	int32_t oldest;
} rain_state;

static cn_body *rain_ragdoll(rain_state *state, int32_t column, int32_t floor, int32_t member)
{
	return state->bodies + ((column * RAIN_FLOORS + floor) * RAIN_GROUP + member) * SCENE_RAGDOLL_BODIES;
}

static void make_rain_column(scene_run *run, rain_state *state, int32_t column)
{
	float x = -0.5f * RAIN_WIDTH_M + RAIN_WIDTH_M / (float)RAIN_COLUMNS * ((float)column + 0.5f);
	for (int32_t floor = 0; floor < RAIN_FLOORS; ++floor) {
		for (int32_t member = 0; member < RAIN_GROUP; ++member) {
			int32_t number = (column * RAIN_FLOORS + floor) * RAIN_GROUP + member;
			scene_ragdoll(run, x + 0.5f * (float)member, 40.0f + 45.0f * (float)floor, -1 - number, rain_ragdoll(state, column, floor, member));
		}
	}
}

static void destroy_rain_column(scene_run *run, rain_state *state, int32_t column)
{
	const int32_t count = RAIN_FLOORS * RAIN_GROUP * SCENE_RAGDOLL_BODIES;
	if (run->result == CN_OK)
		scene_check(run, cn_body_destroy_many(run->world, rain_ragdoll(state, column, 0, 0), count));
}

void scene_create_rain(scene_run *run)
{
	scene_memory(run, sizeof(rain_state));
	for (int32_t floor = 0; floor < RAIN_FLOORS; ++floor) {
		cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 45.0f * (float)floor), 1.0f, 0.6f, 0.0f);
		for (int32_t i = 0; i <= 500; ++i)
			scene_offset_box(run, &def, scene_vec(-0.5f * RAIN_WIDTH_M + 0.5f * (float)i, 0.0f), 0.25f, 0.25f);
	}
}

/* Every 8 steps one more column; when all are there, the oldest is destroyed and made again. */
void scene_step_rain(scene_run *run, int32_t step_index)
{
	rain_state *state = (rain_state *)run->memory;
	if (step_index % 8 != 0)
		return;
	if (state->columns_made < RAIN_COLUMNS) {
		make_rain_column(run, state, state->columns_made++);
		return;
	}
	destroy_rain_column(run, state, state->oldest);
	make_rain_column(run, state, state->oldest);
	state->oldest = (state->oldest + 1) % RAIN_COLUMNS;
}

/* ------------------------------------------------------------------ ragdolls in a valley */

/* Points run from right to left: the ground is below them. */
void scene_create_ragdolls(scene_run *run)
{
	static const cn_vec2 valley[] = {{7.2f, 12.0f}, {7.0f, 3.2f}, {5.0f, 2.2f}, {3.6f, 0.9f}, {2.4f, 0.6f}, {1.2f, 0.0f}, {0.3f, 0.4f},
		{-0.9f, 0.3f}, {-1.8f, 0.0f}, {-3.0f, 0.6f}, {-4.2f, 1.7f}, {-5.4f, 1.8f}, {-7.0f, 3.2f}, {-7.2f, 12.0f}};
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.6f, 0.0f);
	scene_chain(run, &def, valley, (int32_t)(sizeof valley / sizeof valley[0]), 0);
}

/* Every 24 steps four more, until the heap is complete. */
void scene_step_ragdolls(scene_run *run, int32_t step_index)
{
	int32_t wave = step_index / 24;
	cn_body bodies[SCENE_RAGDOLL_BODIES];
	if (step_index % 24 != 0 || 4 * wave >= run->scene->size)
		return;
	for (int32_t i = 0; i < 4; ++i) {
		float x = -4.5f + 2.7f * (float)i + 0.3f * (float)(wave % 4);
		scene_ragdoll(run, x, 7.0f + 0.3f * (float)i, -1 - (4 * wave + i), bodies);
	}
}
