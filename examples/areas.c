/* examples/areas.c - sensors that act on what is in them: a pool on which a raft carries two crates, a fan that keeps a ball in the air,
   a planet with a moon. An area is a sensor with a cn_area_def. */
#include "cairn.h"
#include <math.h>
#include <stdio.h>

#define STEP_S (1.0f / 60.0f)

static cn_body add_body(cn_world *world, int32_t type, float x, float y)
{
	cn_body_def def;
	cn_body body = 0;
	cn_body_def_init(&def);
	def.type = type;
	def.position_m = (cn_vec2){ x, y };
	cn_body_create(world, &def, &body);
	return body;
}

static cn_body add_box(cn_world *world, float x, float y, float half_width, float half_height, float density)
{
	cn_body body = add_body(world, CN_BODY_DYNAMIC, x, y);
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	def.density_kgpm2 = density;
	cn_shape_create_box(world, &def, half_width, half_height, 0.0f, NULL);
	return body;
}

static cn_body add_ball(cn_world *world, float x, float y, float radius, float density)
{
	cn_body body = add_body(world, CN_BODY_DYNAMIC, x, y);
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = body;
	def.density_kgpm2 = density;
	cn_shape_create_circle(world, &def, &(cn_circle){ { 0.0f, 0.0f }, radius }, NULL);
	return body;
}

/* Water with its surface at y = 0, from x = -10 to 10. */
static void add_pool(cn_world *world)
{
	cn_shape_def def;
	cn_area_def area;
	cn_shape pool = 0;
	cn_shape_def_init(&def);
	def.body = add_body(world, CN_BODY_STATIC, 0.0f, -5.0f);
	def.flags = CN_SHAPE_SENSOR;
	cn_shape_create_box(world, &def, 10.0f, 5.0f, 0.0f, &pool);
	cn_area_def_init(&area);
	area.density_kgpm2 = 1000.0f; /* buoyancy */
	area.drag_kgpm2 = 1000.0f;    /* resistance, with the square of the speed */
	area.linear_damping_per_s = area.angular_damping_per_s = 1.0f; /* waves take the rest */
	cn_shape_set_area(world, pool, &area);
}

/* A column of air, 4 m wide, that rises at 12 m/s. */
static void add_fan(cn_world *world, float x)
{
	cn_shape_def def;
	cn_area_def area;
	cn_shape column = 0;
	cn_shape_def_init(&def);
	def.body = add_body(world, CN_BODY_STATIC, x, 5.0f);
	def.flags = CN_SHAPE_SENSOR;
	cn_shape_create_box(world, &def, 2.0f, 5.0f, 0.0f, &column);
	cn_area_def_init(&area);
	area.drag_kgpm2 = 1.2f * 0.5f; /* density of air times the drag coefficient of a ball */
	area.flow_mps.y = 12.0f;
	cn_shape_set_area(world, column, &area);
}

/* A planet of 5 m with 10 m/s^2 on its surface, and no other gravity within 30 m. */
static void add_planet(cn_world *world, float x, float y)
{
	cn_shape_def def;
	cn_area_def area;
	cn_shape space = 0;
	cn_shape_def_init(&def);
	def.body = add_body(world, CN_BODY_STATIC, x, y);
	cn_shape_create_circle(world, &def, &(cn_circle){ { 0.0f, 0.0f }, 5.0f }, NULL);
	def.flags = CN_SHAPE_SENSOR;
	cn_shape_create_circle(world, &def, &(cn_circle){ { 0.0f, 0.0f }, 30.0f }, &space);
	cn_area_def_init(&area);
	area.flags = CN_AREA_REPLACE;
	area.pull_mps2 = 10.0f;
	area.pull_distance_m = 5.0f;
	cn_shape_set_area(world, space, &area);
}

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_pose raft_pose, ball_pose, moon_pose;
	cn_world_def_init(&world_def);
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;
	add_pool(world);
	cn_body raft = add_box(world, 0.0f, 0.0f, 2.0f, 0.5f, 200.0f); /* 800 kg */
	add_box(world, -1.0f, 1.0f, 0.5f, 0.5f, 500.0f);                /* 500 kg each: together they displace 1.8 m^2 */
	add_box(world, 1.0f, 1.0f, 0.5f, 0.5f, 500.0f);
	add_fan(world, 20.0f);
	cn_body ball = add_ball(world, 20.0f, 2.0f, 0.4f, 3.0f); /* m g = 15 N; in the fan at rest 0.6 / 2 x 0.8 m x 12^2 = 35 N */
	add_planet(world, 100.0f, 0.0f);
	cn_body moon = add_ball(world, 115.0f, 0.0f, 0.3f, 1.0f);
	const float orbit_mps = sqrtf(10.0f * 5.0f * 5.0f / 15.0f);
	cn_body_set_velocity(world, moon, 0.0f, orbit_mps, 0.0f);
	float nearest_m = 15.0f, farthest_m = 15.0f;
	for (int step = 0; step < 1800; ++step) {
		cn_world_step(world, STEP_S);
		cn_body_get_pose(world, moon, &moon_pose);
		const float distance_m = hypotf(moon_pose.position_m.x - 100.0f, moon_pose.position_m.y);
		nearest_m = fminf(nearest_m, distance_m);
		farthest_m = fmaxf(farthest_m, distance_m);
	}
	cn_body_get_pose(world, raft, &raft_pose);
	cn_body_get_pose(world, ball, &ball_pose);
	printf("draught of the raft %.3f m; the ball hovers at %.1f m; the moon was %.2f to %.2f m from its planet\n", 0.5 - (double)raft_pose.position_m.y,
		(double)ball_pose.position_m.y, (double)nearest_m, (double)farthest_m);
	cn_world_destroy(world);
	return !(fabsf(0.5f - raft_pose.position_m.y - 0.45f) < 0.005f && fabsf(ball_pose.position_m.y - 10.0f) < 1.0f && nearest_m > 14.8f && farthest_m < 15.2f);
}
