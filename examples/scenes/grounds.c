/*
 * examples/scenes/grounds.c - things that move over ground: mixed bodies dropped into a bowl, dominoes,
 * and a car on a terrain of one smooth chain.
 */
#include "scenes/build.h"

/* ------------------------------------------------------------------ bowl (the small scenes) */

/* Half an ellipse of 12 edges, 10 m wide and 10 m deep; bodies come down in rows of five, every second
   row shifted by half a space. Circle 0.25, box of half 0.25, capsule of half-length and radius 0.15. */
void scene_create_bowl(scene_run *run)
{
	cn_shape_def ground = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.6f, 0.0f);
	for (int32_t i = 0; i < 12; ++i) {
		double a = 3.14159265358979323846 * (double)i / 12.0, b = 3.14159265358979323846 * (double)(i + 1) / 12.0;
		scene_edge(run, &ground, scene_vec(-5.0f * scene_cosine(a), 10.0f - 10.0f * scene_sine(a)),
			scene_vec(-5.0f * scene_cosine(b), 10.0f - 10.0f * scene_sine(b)));
	}
	for (int32_t i = 0; i < run->scene->size; ++i) {
		int32_t row = i / 5;
		float x = 0.8f * (float)(i % 5 - 2) + (row % 2 == 0 ? -0.2f : 0.2f);
		cn_shape_def def = scene_surface(scene_body(run, CN_BODY_DYNAMIC, x, 5.0f + 0.8f * (float)row), 1.0f, 0.6f, 0.0f);
		if (i % 3 == 0)
			scene_circle(run, &def, 0.25f);
		else if (i % 3 == 1)
			scene_box(run, &def, 0.25f, 0.25f, 0.0f);
		else
			scene_capsule(run, &def, scene_vec(-0.15f, 0.0f), scene_vec(0.15f, 0.0f), 0.15f);
	}
}

/* ------------------------------------------------------------------ dominoes */

/* A ball rolls into the first of a row of dominoes on a table; the last one falls off its end. */
void scene_create_dominoes(scene_run *run)
{
	const float spacing = 0.75f, half_height = 0.75f;
	int32_t count = run->scene->size;
	float length = spacing * (float)(count - 1), left = -0.5f * length;
	cn_shape_def table = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, -0.5f), 1.0f, 0.6f, 0.0f);
	scene_offset_box(run, &table, scene_vec(-2.0f, 0.0f), 0.5f * length + 2.5f, 0.5f);
	cn_shape_def ground = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, -4.0f), 1.0f, 0.6f, 0.0f);
	scene_box(run, &ground, 0.5f * length + 8.0f, 0.5f, 0.0f);

	for (int32_t i = 0; i < count; ++i)
		scene_simple_box(run, left + spacing * (float)i, half_height, 0.1f, half_height);

	cn_body_def ball_def;
	cn_body_def_init(&ball_def);
	ball_def.position_m = scene_vec(left - 3.0f, 0.5f);
	ball_def.linear_velocity_mps = scene_vec(6.0f, 0.0f);
	ball_def.angular_velocity_radps = -12.0f;
	cn_shape_def ball = scene_surface(scene_body_with(run, &ball_def), 1.0f, 0.6f, 0.0f);
	scene_circle(run, &ball, 0.5f);
}

/* ------------------------------------------------------------------ car */

#define TERRAIN_POINTS 400
#define TERRAIN_LEFT_M (-20.0f)

/* Hills that grow with x, flat around the start. */
static float terrain_height(float x)
{
	float ramp = x < 5.0f ? 0.0f : (x < 30.0f ? (x - 5.0f) / 25.0f : 1.0f);
	return ramp * (0.9f * scene_sine((double)x * 0.23) + 0.35f * scene_sine((double)x * 0.61) + 0.08f * scene_sine((double)x * 2.1));
}

static void add_terrain(scene_run *run)
{
	cn_vec2 points[TERRAIN_POINTS];
	for (int32_t i = 0; i < TERRAIN_POINTS; ++i) {
		float x = TERRAIN_LEFT_M + 0.5f * (float)(TERRAIN_POINTS - 1 - i);
		points[i] = scene_vec(x, terrain_height(x));
	}
	points[TERRAIN_POINTS - 1].y = 8.0f; /* a wall behind the start */
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.9f, 0.0f);
	scene_chain(run, &def, points, TERRAIN_POINTS, 0);
}

static void add_wheel(scene_run *run, cn_body chassis, cn_vec2 hub_m, cn_vec2 chassis_position_m)
{
	cn_body wheel = scene_body(run, CN_BODY_DYNAMIC, chassis_position_m.x + hub_m.x, chassis_position_m.y + hub_m.y);
	cn_shape_def def = scene_surface(wheel, 2.0f, 1.2f, 0.0f);
	scene_circle(run, &def, 0.5f);
	scene_join_motor(run, chassis, hub_m, wheel, scene_vec(0.0f, 0.0f), -14.0f, 5.0f);
}

/* A plank on a pivot, its near end on the ground. */
static void add_seesaw(scene_run *run)
{
	const cn_vec2 pivot_m = {1.0f, 0.35f};
	cn_body_def plank_def;
	cn_body_def_init(&plank_def);
	plank_def.position_m = pivot_m;
	plank_def.angle_rad = 0.12f;
	cn_body plank = scene_body_with(run, &plank_def);
	cn_shape_def def = scene_surface(plank, 2.0f, 0.6f, 0.0f);
	scene_box(run, &def, 2.2f, 0.05f, 0.0f);
	cn_revolute_def pivot = scene_revolute(0, pivot_m, plank, scene_vec(0.0f, 0.0f));
	scene_join(run, &pivot);
}

void scene_create_car(scene_run *run)
{
	const cn_vec2 start = {-12.0f, 1.1f};
	cn_polygon hull = {6, 0.0f, {{-1.6f, -0.35f}, {1.6f, -0.35f}, {1.75f, 0.0f}, {0.6f, 0.45f}, {-1.0f, 0.55f}, {-1.65f, 0.2f}}};
	add_terrain(run);
	cn_body chassis = scene_body(run, CN_BODY_DYNAMIC, start.x, start.y);
	cn_shape_def def = scene_surface(chassis, 1.0f, 0.3f, 0.0f);
	if (run->result == CN_OK)
		scene_check(run, cn_shape_create_polygon(run->world, &def, &hull, NULL));
	add_wheel(run, chassis, scene_vec(-1.1f, -0.5f), start);
	add_wheel(run, chassis, scene_vec(1.1f, -0.5f), start);
	add_seesaw(run);
	run->focus = chassis;
}
