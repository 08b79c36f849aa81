/* examples/car.c - a car seen from the side: a chassis on two wheel joints, each a spring and a motor, on hills of one chain. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define DT (1.0f / 60.0f)
#define POINTS 161

typedef struct car {
	cn_body chassis;
	cn_joint wheels[2];
} car;

static cn_body add_wheel(cn_world *world, float x, float y, float radius)
{
	const cn_circle circle = { { 0.0f, 0.0f }, radius };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body wheel = 0;
	cn_body_def_init(&body_def);
	body_def.position_m = (cn_vec2){ x, y };
	cn_body_create(world, &body_def, &wheel);
	cn_shape_def_init(&shape_def);
	shape_def.body = wheel;
	shape_def.density_kgpm2 = 60.0f;
	shape_def.material.static_friction = shape_def.material.dynamic_friction = 1.2f;
	cn_shape_create_circle(world, &shape_def, &circle, NULL);
	return wheel;
}

static car add_car(cn_world *world, float x, float y)
{
	car c = { 0, { 0, 0 } };
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body_def_init(&body_def);
	body_def.position_m = (cn_vec2){ x, y };
	cn_body_create(world, &body_def, &c.chassis);
	cn_shape_def_init(&shape_def);
	shape_def.body = c.chassis;
	shape_def.density_kgpm2 = 200.0f;
	cn_shape_create_box(world, &shape_def, 1.5f, 0.3f, 0.1f, NULL);
	for (int i = 0; i < 2; ++i) {
		const float wheel_x = i == 0 ? -1.0f : 1.0f;
		cn_wheel_def def;
		cn_wheel_def_init(&def);
		def.base.flags = CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT;
		def.base.body_a = c.chassis;
		def.base.body_b = add_wheel(world, x + wheel_x, y - 0.5f, 0.4f);
		def.base.anchor_a_m = (cn_vec2){ wheel_x, -0.5f };
		def.lower_m = -0.2f; /* of the suspension, along the axis (0, 1) of the chassis */
		def.upper_m = 0.2f;
		def.spring_hertz = 3.0f;
		cn_joint_create_wheel(world, &def, &c.wheels[i]);
	}
	return c;
}

/* throttle -1 to 1: to the right is clockwise, a negative speed. 0 rolls. */
static void drive(cn_world *world, const car *c, float throttle)
{
	for (int i = 0; i < 2; ++i)
		cn_joint_set_motor(world, c->wheels[i], -30.0f * throttle, 600.0f * fabsf(throttle));
}

static void add_hills(cn_world *world)
{
	static cn_vec2 points[POINTS];
	cn_body_def body_def;
	cn_shape_def shape_def;
	for (int i = 0; i < POINTS; ++i) { /* from right to left: solid below */
		const float x = 150.0f - (float)i;
		points[i] = (cn_vec2){ x, x > 0.0f ? 1.5f * sinf(0.25f * x) * fminf(0.05f * x, 1.0f) : 0.0f };
	}
	const cn_chain hills = { points, POINTS, 0 };
	cn_body_def_init(&body_def);
	body_def.type = CN_BODY_STATIC;
	cn_shape_def_init(&shape_def);
	cn_body_create(world, &body_def, &shape_def.body);
	cn_shape_create_chain(world, &shape_def, &hills, NULL);
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_vec2 at = { 0.0f, 0.0f };
	cn_velocity v = { { 0.0f, 0.0f }, 0.0f };
	int step = 0;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_hills(world);
	const car c = add_car(world, -5.0f, 1.0f);
	for (; step < 1800 && at.x < 120.0f; ++step) {
		drive(world, &c, 1.0f);
		cn_world_step(world, DT);
		cn_body_get_center(world, c.chassis, &at);
	}
	printf("over the hills, 120 m, in %.1f s\n", step / 60.0);
	for (int brake = 0; brake < 240; ++brake) {
		for (int i = 0; i < 2; ++i)
			cn_joint_set_motor(world, c.wheels[i], 0.0f, 600.0f); /* a motor of speed 0 brakes */
		cn_world_step(world, DT);
	}
	cn_body_get_velocity(world, c.chassis, &v);
	printf("after 4 s of braking: %.2f m/s\n", (double)hypotf(v.linear_mps.x, v.linear_mps.y));
	cn_world_destroy(world);
	return !(step < 1800 && hypotf(v.linear_mps.x, v.linear_mps.y) < 0.1f);
}
