/* examples/top_down_car.c - a car seen from above: no gravity; each axle takes away its sideways velocity by an impulse, up to what
   its tyres hold. Slowly it drives the circle that its steering gives, fast it skids out of it. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define DT (1.0f / 60.0f)
#define WHEELBASE 2.6f
#define GRIP_N 6000.0f /* sideways, of one axle */

/* An axle at local x, turned by an angle against the car. */
static void apply_tyres(cn_world *world, cn_body car, float local_x, float angle_rad, float drive_N)
{
	cn_pose pose;
	cn_vec2 point, velocity;
	cn_body_get_pose(world, car, &pose);
	cn_body_get_world_point(world, car, local_x, 0.0f, &point);
	cn_body_get_velocity_at(world, car, point.x, point.y, &velocity);
	const float c = cosf(angle_rad), s = sinf(angle_rad);
	const cn_vec2 ahead = { c * pose.cosine - s * pose.sine, c * pose.sine + s * pose.cosine }, side = { -ahead.y, ahead.x };

	/* The impulse that stops the sideways motion of half the car's mass, or what the tyres hold. */
	cn_mass_data mass;
	cn_body_get_mass_data(world, car, &mass);
	float impulse = -0.5f * mass.mass_kg * (velocity.x * side.x + velocity.y * side.y);
	impulse = fminf(fmaxf(impulse, -GRIP_N * DT), GRIP_N * DT);
	cn_body_apply_impulse_at(world, car, impulse * side.x, impulse * side.y, point.x, point.y);
	cn_body_apply_force_at(world, car, drive_N * ahead.x, drive_N * ahead.y, point.x, point.y);
}

/* Drives at a speed with the front wheels turned for some time; the radius of the circle at the end. */
static float drive_circle(float speed_mps, float steer_rad)
{
	cn_world_def world_def;
	cn_world *world;
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body car;
	cn_velocity v = { { 0.0f, 0.0f }, 0.0f };
	cn_world_def_init(&world_def);
	world_def.gravity_mps2.y = 0.0f;
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 0.0f;
	cn_body_def_init(&body_def);
	cn_body_create(world, &body_def, &car);
	cn_shape_def_init(&shape_def);
	shape_def.body = car;
	shape_def.density_kgpm2 = 140.0f;
	cn_shape_create_box(world, &shape_def, 2.1f, 0.8f, 0.1f, NULL);
	for (int step = 0; step < 600; ++step) {
		cn_body_get_velocity(world, car, &v);
		float speed = hypotf(v.linear_mps.x, v.linear_mps.y);
		apply_tyres(world, car, 0.5f * WHEELBASE, steer_rad, 0.0f);
		apply_tyres(world, car, -0.5f * WHEELBASE, 0.0f, 2000.0f * (speed_mps - speed));
		cn_world_step(world, DT);
	}
	cn_body_get_velocity(world, car, &v);
	cn_world_destroy(world);
	return hypotf(v.linear_mps.x, v.linear_mps.y) / fabsf(v.angular_radps);
}

int main(void)
{
	const float steer_rad = 0.3f;
	/* The rear axle drives a circle of WHEELBASE / tan(steer), the centre of mass a slightly larger one. */
	const float expected = hypotf(WHEELBASE / tanf(steer_rad), 0.5f * WHEELBASE);
	const float slow = drive_circle(4.0f, steer_rad), fast = drive_circle(16.0f, steer_rad);
	printf("radius at 4 m/s: %.2f m (geometry: %.2f m), at 16 m/s: %.1f m\n", (double)slow, (double)expected, (double)fast);
	return !(fabsf(slow / expected - 1.0f) < 0.05f && fast > 1.5f * expected);
}
