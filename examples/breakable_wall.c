/* examples/breakable_wall.c - bricks welded to each other by joints that break; a ball goes through, and what is not hit stays up. */
#include "cairn.h"
#include <stdio.h>

#define COLUMNS 2
#define ROWS 12

static cn_body add_brick(cn_world *world, int32_t type, float x, float y, float half_width, float half_height)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m = (cn_vec2){ x, y };
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	shape_def.density_kgpm2 = 200.0f;
	cn_shape_create_box(world, &shape_def, half_width, half_height, 0.0f, NULL);
	return body;
}

/* Mortar: b is at (x, y) from a. */
static void weld(cn_world *world, cn_body a, cn_body b, float x, float y)
{
	cn_fixed_def def;
	cn_joint joint;
	cn_fixed_def_init(&def);
	def.base.flags = CN_JOINT_BREAKS; /* without it a break is reported only */
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m = (cn_vec2){ x, y };
	def.base.break_force_N = 6000.0f;
	def.base.break_torque_Nm = 2000.0f;
	cn_joint_create_fixed(world, &def, &joint);
}

/* Two bricks thick, seen from its end; its lowest row is welded to the ground. */
static void add_wall(cn_world *world, cn_body ground, cn_body bricks[ROWS][COLUMNS])
{
	for (int row = 0; row < ROWS; ++row) {
		for (int k = 0; k < COLUMNS; ++k) {
			bricks[row][k] = add_brick(world, CN_BODY_DYNAMIC, 0.6f * (float)k, 0.15f + 0.3f * (float)row, 0.3f, 0.15f);
			if (k > 0)
				weld(world, bricks[row][k - 1], bricks[row][k], 0.6f, 0.0f);
			if (row == 0)
				weld(world, ground, bricks[0][k], 0.6f * (float)k, 1.15f);
			else
				weld(world, bricks[row - 1][k], bricks[row][k], 0.0f, 0.3f);
		}
	}
}

static cn_body shoot(cn_world *world, float x, float y, float speed_mps)
{
	const cn_circle circle = { { 0.0f, 0.0f }, 0.25f };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body ball = 0;
	cn_body_def_init(&body_def);
	body_def.position_m = (cn_vec2){ x, y };
	body_def.linear_velocity_mps.x = speed_mps;
	cn_body_create(world, &body_def, &ball);
	cn_shape_def_init(&shape_def);
	shape_def.body = ball;
	shape_def.density_kgpm2 = 800.0f;
	cn_shape_create_circle(world, &shape_def, &circle, NULL);
	return ball;
}

/* Steps for a while; the joints that broke. */
static int run(cn_world *world, int steps)
{
	const cn_joint_event *events;
	int32_t count;
	int broken = 0;
	for (int step = 0; step < steps; ++step) {
		cn_world_step(world, 1.0f / 60.0f);
		cn_world_joint_events(world, &events, &count);
		for (int32_t i = 0; i < count; ++i)
			broken += events[i].destroyed != 0;
	}
	return broken;
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_body bricks[ROWS][COLUMNS];
	cn_pose ball_at, corner_at;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_wall(world, add_brick(world, CN_BODY_STATIC, 0.0f, -1.0f, 30.0f, 1.0f), bricks);
	const int before = run(world, 60);
	const cn_body ball = shoot(world, -4.0f, 2.6f, 30.0f);
	const int after = run(world, 180);
	cn_body_get_pose(world, ball, &ball_at);
	cn_body_get_pose(world, bricks[0][0], &corner_at);
	printf("joints broken: %d by standing, %d by the ball; it is at x = %.1f m, the lowest brick moved %.3f m\n", before, after,
		(double)ball_at.position_m.x, (double)corner_at.position_m.x);
	cn_world_destroy(world);
	return !(before == 0 && after >= 4 && corner_at.position_m.x < 0.05f && ball_at.position_m.x > 2.5f);
}
