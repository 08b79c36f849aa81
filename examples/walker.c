/* examples/walker.c - a character rides two moving platforms over a pit and jumps from one to the other: the shortest program of that kind.
   platformer.c has a longer level, early and late jumps, a crate to push and a picture. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define DT (1.0f / 60.0f)

static cn_body add_box(cn_world *world, int32_t type, float x, float y, float half_width, float half_height)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m.x = x;
	body_def.position_m.y = y;
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	cn_shape_create_box(world, &shape_def, half_width, half_height, 0.0f, NULL);
	return body;
}

/* Moves a platform: cn_body_set_target_pose, unlike cn_body_set_pose, carries what stands on it. */
static void move_platform(cn_world *world, cn_body platform, float x, float y, float range, float time_s)
{
	cn_body_set_target_pose(world, platform, x + range * sinf(time_s), y, 0.0f, DT);
}

/* One frame of the character: run and jump are the player's keys. */
static void move_character(cn_world *world, const cn_mover_def *def, cn_mover *mover, float run, int jump)
{
	mover->velocity_mps.x = 4.0f * run;
	if (jump && (mover->flags & CN_MOVER_ON_GROUND))
		mover->velocity_mps.y = 6.0f;
	cn_mover_move(world, def, DT, mover);
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_mover_def def;
	cn_mover mover = { .position_m = { -6.0f, 0.81f } };
	cn_body platforms[2], ground, ground_before = 0;
	int rides = 0, next = 0;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_box(world, CN_BODY_STATIC, -8.0f, -1.0f, 4.0f, 1.0f);
	ground = add_box(world, CN_BODY_STATIC, 16.0f, -1.0f, 4.0f, 1.0f);
	platforms[0] = add_box(world, CN_BODY_KINEMATIC, 0.0f, -0.2f, 1.2f, 0.2f);
	platforms[1] = add_box(world, CN_BODY_KINEMATIC, 8.0f, -0.2f, 1.2f, 0.2f);
	cn_mover_def_init(&def); /* a capsule 1.6 m high */
	for (int frame = 0; frame < 1200 && mover.ground_body != ground; ++frame) {
		const float time_s = DT * (float)frame;
		cn_pose pose[2];
		move_platform(world, platforms[0], -1.0f, -0.2f, 2.0f, -time_s);
		move_platform(world, platforms[1], 8.0f, -0.2f, 3.0f, time_s);
		cn_world_step(world, DT);
		cn_world_read_poses(world, platforms, 2, pose);

		/* The player: waits at an edge until the next platform is near, jumps, and steers to its middle in the air. */
		const float x = mover.position_m.x, goals[3] = { pose[0].position_m.x, pose[1].position_m.x, 13.5f };
		const int grounded = (mover.flags & CN_MOVER_ON_GROUND) != 0;
		next = mover.ground_body == platforms[0] ? 1 : mover.ground_body == platforms[1] ? 2 : next;
		const float edge = next == 0 ? -4.3f : goals[next - 1] + 0.8f;
		const int jump = grounded && fabsf(edge - x) < 0.1f && goals[next] - x < 3.8f;
		const float way = (grounded && !jump ? edge : goals[next]) - x;
		const float run = fminf(fmaxf(5.0f * way, -1.0f), 1.0f);
		move_character(world, &def, &mover, run, jump);

		if (mover.ground_body != ground_before && mover.ground_body != 0) {
			rides += mover.ground_body == platforms[0] || mover.ground_body == platforms[1];
			printf("%5.2f s: stands on %s at x = %.2f m\n", (double)time_s, mover.ground_body == platforms[0] ? "platform 1" :
				mover.ground_body == platforms[1] ? "platform 2" : "the ground", (double)mover.position_m.x);
			ground_before = mover.ground_body;
		}
	}
	cn_world_destroy(world);
	return !(mover.ground_body == ground && rides >= 2);
}
