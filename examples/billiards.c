/* examples/billiards.c - a break shot seen from above: no gravity, elastic balls, damping for the cloth, sensors for the pockets.
   Sizes are of centimetres, so the world has a length unit to match. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define RADIUS 0.0286f
#define HALF_LENGTH 1.27f
#define HALF_WIDTH 0.635f

static cn_body add_ball(cn_world *world, float x, float y)
{
	const cn_circle circle = { { 0.0f, 0.0f }, RADIUS };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.position_m = (cn_vec2){ x, y };
	body_def.linear_damping_per_s = 0.5f; /* the cloth */
	body_def.angular_damping_per_s = 2.0f;
	body_def.flags |= CN_BODY_BULLET; /* fast and small */
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	shape_def.density_kgpm2 = 66.0f; /* 0.17 kg */
	shape_def.material.static_friction = shape_def.material.dynamic_friction = 0.06f;
	shape_def.material.restitution = 0.95f;
	cn_shape_create_circle(world, &shape_def, &circle, NULL);
	return body;
}

/* Cushions: a clockwise loop is solid outside. Pockets: sensors, which report and do not collide. */
static void add_table(cn_world *world)
{
	const float x = HALF_LENGTH, y = HALF_WIDTH;
	const cn_vec2 corners[4] = { { -x, -y }, { -x, y }, { x, y }, { x, -y } };
	const cn_chain cushions = { corners, 4, 1 };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body table;
	cn_body_def_init(&body_def);
	body_def.type = CN_BODY_STATIC;
	cn_body_create(world, &body_def, &table);
	cn_shape_def_init(&shape_def);
	shape_def.body = table;
	shape_def.material.restitution_mix = CN_MIX_MAXIMUM; /* the default: the balls' 0.95 counts */
	cn_shape_create_chain(world, &shape_def, &cushions, NULL);
	shape_def.flags = CN_SHAPE_SENSOR;
	for (int k = 0; k < 6; ++k) {
		const cn_circle pocket = { { x * (float)(k % 3 - 1), k < 3 ? y : -y }, 0.06f };
		cn_shape_create_circle(world, &shape_def, &pocket, NULL);
	}
}

/* Balls that entered a pocket in the last step leave the table. */
static int take_potted(cn_world *world)
{
	const cn_sensor_event *events;
	int32_t count;
	int potted = 0;
	cn_world_sensor_events(world, &events, &count);
	for (int32_t i = 0; i < count; ++i)
		potted += events[i].kind == CN_EVENT_ENTER && cn_body_destroy(world, events[i].visitor_body) == CN_OK;
	return potted;
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	int potted = 0, step = 0;
	int32_t left = 0;
	cn_counters counters;
	cn_world_def_init(&world_def);
	world_def.gravity_mps2.y = 0.0f;
	world_def.length_unit_m = 0.05f;
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_table(world);
	for (int row = 0; row < 5; ++row) {
		for (int k = 0; k <= row; ++k)
			add_ball(world, 0.6f + 1.7321f * RADIUS * (float)row, RADIUS * (float)(2 * k - row));
	}
	cn_body_set_velocity(world, add_ball(world, -0.6f, 0.004f), 9.0f, 0.0f, 0.0f);

	do {
		cn_world_step(world, 1.0f / 60.0f);
		potted += take_potted(world);
		cn_world_get_counters(world, &counters);
	} while (counters.bodies_awake > 0 && ++step < 3600);

	cn_body bodies[17];
	cn_pose poses[17];
	cn_world_get_bodies(world, bodies, 17, &left);
	cn_world_read_poses(world, NULL, left, poses);
	int outside = 0;
	for (int32_t i = 0; i < left; ++i)
		outside += fabsf(poses[i].position_m.x) > HALF_LENGTH || fabsf(poses[i].position_m.y) > HALF_WIDTH;
	printf("at rest after %.1f s: %d potted, %d on the table, %d outside of it\n", step / 60.0, potted, (int)left - 1, outside);
	cn_world_destroy(world);
	return !(step < 3600 && outside == 0 && potted + left - 1 == 16);
}
