/* examples/conveyor.c - crates on two belts, one of them uphill; a sensor counts what arrives. A belt is a surface with a speed:
   cn_material.tangent_speed_mps. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define BELT_MPS 2.0f

static cn_body add_box(cn_world *world, int32_t type, cn_vec2 at, float angle_rad, cn_vec2 half, float belt_mps, uint32_t flags)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m = at;
	body_def.angle_rad = angle_rad;
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	shape_def.flags = flags;
	shape_def.material.static_friction = shape_def.material.dynamic_friction = 0.8f;
	shape_def.material.tangent_speed_mps = belt_mps; /* positive: to the right on the upper side */
	cn_shape_create_box(world, &shape_def, half.x, half.y, 0.0f, NULL);
	return body;
}

static int arrived(const cn_world *world)
{
	const cn_sensor_event *events;
	int32_t count;
	int entered = 0;
	cn_world_sensor_events(world, &events, &count);
	for (int32_t i = 0; i < count; ++i)
		entered += events[i].kind == CN_EVENT_ENTER;
	return entered;
}

int main(void)
{
	const float slope_rad = 0.3f, c = cosf(slope_rad), s = sinf(slope_rad);
	cn_world_def world_def;
	cn_world *world;
	cn_body first = 0;
	cn_velocity level = { { 0.0f, 0.0f }, 0.0f }, uphill = level;
	int count = 0;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	/* A belt of 10 m to x = 0, one of 10 m up a slope, a sensor at its end, a floor. */
	add_box(world, CN_BODY_STATIC, (cn_vec2){ -5.0f, -0.25f }, 0.0f, (cn_vec2){ 5.0f, 0.25f }, BELT_MPS, 0);
	add_box(world, CN_BODY_STATIC, (cn_vec2){ 5.0f * c + 0.25f * s, 5.0f * s - 0.25f * c }, slope_rad, (cn_vec2){ 5.0f, 0.25f }, BELT_MPS, 0);
	add_box(world, CN_BODY_STATIC, (cn_vec2){ 14.0f, -4.25f }, 0.0f, (cn_vec2){ 8.0f, 0.25f }, 0.0f, 0);
	add_box(world, CN_BODY_STATIC, (cn_vec2){ 10.0f * c + 0.7f, 10.0f * s }, 0.0f, (cn_vec2){ 0.1f, 1.0f }, 0.0f, CN_SHAPE_SENSOR);
	for (int step = 0; step < 1080; ++step) {
		if (step % 75 == 0 && step < 450) {
			cn_body crate = add_box(world, CN_BODY_DYNAMIC, (cn_vec2){ -9.0f, 0.3f }, 0.0f, (cn_vec2){ 0.3f, 0.3f }, 0.0f, 0);
			first = first != 0 ? first : crate;
		}
		cn_world_step(world, 1.0f / 60.0f);
		count += arrived(world);
		if (step == 180)
			cn_body_get_velocity(world, first, &level);
		if (step == 400)
			cn_body_get_velocity(world, first, &uphill);
	}
	const float uphill_mps = hypotf(uphill.linear_mps.x, uphill.linear_mps.y);
	printf("a crate moves at %.3f m/s on the level belt, at %.3f m/s uphill; %d of 6 crates arrived\n", (double)level.linear_mps.x,
		(double)uphill_mps, count);
	cn_world_destroy(world);
	return !(fabsf(level.linear_mps.x - BELT_MPS) < 0.01f && fabsf(uphill_mps - BELT_MPS) < 0.02f && count == 6);
}
