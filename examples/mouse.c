/* examples/mouse.c - dragging by the mouse, here a script: what is under the pointer is found by a query and pulled by a mouse joint.
   A rope and a cloth are dragged and let go. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

/* ---- the mouse: press, move, release ---- */

static cn_joint mouse_press(cn_world *world, cn_vec2 at)
{
	cn_shape shape = 0;
	cn_body body = 0;
	int32_t count = 0, type = CN_BODY_STATIC;
	cn_mouse_def def;
	cn_mass_data mass;
	cn_joint joint = 0;
	const cn_circle pointer = { at, 0.1f };
	cn_world_overlap_circle(world, &pointer, NULL, &shape, 1, &count);
	if (count > 0 && cn_shape_get_body(world, shape, &body) == CN_OK)
		cn_body_get_type(world, body, &type);
	if (type != CN_BODY_DYNAMIC)
		return 0;
	cn_mouse_def_init(&def);
	def.base.body_b = body;
	cn_body_get_local_point(world, body, at.x, at.y, &def.base.anchor_b_m);
	def.target_m = at;
	cn_body_get_mass_data(world, body, &mass);
	def.base.force_max_N = 2000.0f * mass.mass_kg;
	cn_joint_create_mouse(world, &def, &joint);
	return joint;
}

static void mouse_move(cn_world *world, cn_joint mouse, cn_vec2 to) { cn_joint_set_target(world, mouse, to.x, to.y); }
static void mouse_release(cn_world *world, cn_joint mouse) { cn_joint_destroy(world, mouse); }

/* ---- what is dragged ---- */

static cn_body add_ball(cn_world *world, int32_t type, float x, float y, float radius)
{
	const cn_circle circle = { { 0.0f, 0.0f }, radius };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m = (cn_vec2){ x, y };
	body_def.linear_damping_per_s = 0.5f;
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	shape_def.filter.group = -1; /* balls do not collide with each other */
	cn_shape_create_circle(world, &shape_def, &circle, NULL);
	return body;
}

/* A thread of some length at most, which may be slack. */
static void tie(cn_world *world, cn_body a, cn_body b, float length)
{
	cn_distance_def def;
	cn_joint joint;
	cn_distance_def_init(&def);
	def.base.flags = CN_JOINT_LIMIT;
	def.base.body_a = a;
	def.base.body_b = b;
	def.length_m = def.length_max_m = length;
	cn_joint_create_distance(world, &def, &joint);
}

#define COLUMNS 10
#define ROWS 8
#define LINKS 16

/* Hung up at every third point of its upper edge. */
static void add_cloth(cn_world *world, cn_body cloth[ROWS][COLUMNS])
{
	for (int row = 0; row < ROWS; ++row) {
		for (int k = 0; k < COLUMNS; ++k) {
			int32_t type = row == 0 && k % 3 == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
			cloth[row][k] = add_ball(world, type, 0.3f * (float)k, -0.3f * (float)row, 0.08f);
			if (k > 0)
				tie(world, cloth[row][k - 1], cloth[row][k], 0.3f);
			if (row > 0)
				tie(world, cloth[row - 1][k], cloth[row][k], 0.3f);
		}
	}
}

static void add_rope(cn_world *world, cn_body *end)
{
	for (int k = 0; k <= LINKS; ++k) {
		cn_body ball = add_ball(world, k == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC, 5.0f, -0.2f * (float)k, 0.08f);
		if (k > 0)
			tie(world, *end, ball, 0.2f);
		*end = ball;
	}
}

static float worst_stretch(const cn_world *world)
{
	cn_joint joints[2 * COLUMNS * ROWS + LINKS];
	int32_t count = 0;
	float worst = 0.0f, gap = 0.0f, turn = 0.0f;
	cn_world_get_joints(world, joints, (int32_t)(sizeof joints / sizeof joints[0]), &count);
	for (int32_t i = 0; i < count; ++i) {
		cn_joint_get_error(world, joints[i], &gap, &turn);
		worst = fmaxf(worst, gap);
	}
	return worst;
}

/* Drags a body for two seconds and lets go. Returns how far it is from the pointer then; stretch gets the worst of that time. */
static float drag(cn_world *world, cn_body body, cn_vec2 by, float *stretch)
{
	cn_vec2 start, end;
	cn_body_get_center(world, body, &start);
	cn_joint mouse = mouse_press(world, start);
	for (int step = 1; step <= 120; ++step) {
		float part = fminf((float)step / 90.0f, 1.0f);
		mouse_move(world, mouse, (cn_vec2){ start.x + part * by.x, start.y + part * by.y });
		cn_world_step(world, 1.0f / 60.0f);
		*stretch = fmaxf(*stretch, worst_stretch(world));
	}
	cn_body_get_center(world, body, &end);
	mouse_release(world, mouse);
	return hypotf(end.x - start.x - by.x, end.y - start.y - by.y);
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_body cloth[ROWS][COLUMNS], rope = 0;
	float stretch = 0.0f;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_cloth(world, cloth);
	add_rope(world, &rope);
	float off_cloth = drag(world, cloth[ROWS - 1][COLUMNS - 1], (cn_vec2){ -1.5f, 1.0f }, &stretch);
	float off_rope = drag(world, rope, (cn_vec2){ 2.0f, 1.5f }, &stretch);
	printf("off the pointer: cloth %.3f m, rope %.3f m; the worst stretched thread %.3f m\n", (double)off_cloth, (double)off_rope,
		(double)stretch);
	cn_world_destroy(world);
	/* The mouse joint is a spring: the more it lifts, the farther it hangs behind. */
	return !(off_cloth < 0.1f && off_rope < 0.1f && stretch < 0.03f);
}
