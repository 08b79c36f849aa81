/*
 * mover_test - promise: a character goes exactly as fast as it is told, climbs what it may and nothing else, stands still,
 * jumps as high as physics says, never passes through a wall, and is not caught by seams.
 *
 * If a test here fails, look first in: src/query/mover.c (order of a move; steps, slopes, snapping),
 * mover_plane.c (what bounds it, sliding).
 */
#include "movers.h"

/* ------------------------------------------------------------------ level ground */

static void t_walks_level_ground_at_its_speed(void)
{
	double worst = 0.0, height = 0.0;
	int32_t k, off = 0;
	begin(0.0f, 0.8f);
	ground();
	walk(0.0f, 2);
	mover.position_m.x = 0.0f;
	for (k = 1; k <= 120; ++k) {
		walk(5.0f, 1);
		worst = greater(worst, fabs((double)mover.position_m.x - 5.0 * k / 60.0));
		height = greater(height, fabs(feet()));
		off += !on_ground();
	}
	CHECK_LE("off where 5 m/s takes it, in 2 s", worst, 1e-5, "m");
	CHECK_LE("height over the ground", height, 1e-6, "m");
	CHECK_LE("frames off the ground", off, 0, "");
	CHECK(mover.velocity_mps.x == 5.0f && mover.velocity_mps.y == 0.0f && mover.ground_normal.y == 1.0f);
	cn_world_destroy(w);
}

/* A capsule, a box and a disc over tiles, edges and a chain. */
static void t_seams_do_not_catch(void)
{
	const char *ground_names[3] = { "boxes", "edges", "a chain" };
	int32_t kind, shape, k;
	for (kind = 0; kind < 3; ++kind)
		for (shape = 0; shape < 3; ++shape) {
			double worst = 0.0, height = 0.0;
			float x = 0.0f;
			int32_t off = 0;
			begin(0.0f, 0.8f);
			if (shape == 1)
				must(cn_polygon_make_box(0.3f, 0.8f, 0.0f, 0.0f, 0.0f, 0.0f, &md.shape), NULL, "box");
			if (shape == 2) {
				md.shape.count = 1;
				md.shape.radius_m = 0.8f;
				md.shape.points_m[0].y = 0.0f;
			}
			tiles(kind);
			walk(0.0f, 2);
			for (k = 1; k <= 240; ++k) {
				walk(7.3f, 1);
				x += 7.3f * FRAME_S; /* in floats too, whose sum is off by 0.05 mm at the end */
				worst = greater(worst, fabs((double)(mover.position_m.x - x)));
				height = greater(height, fabs(feet()));
				off += !on_ground();
			}
			printf("  shape %d over %s\n", (int)shape, ground_names[kind]);
			CHECK_LE("off where its speed takes it, in 4 s", worst, 1e-5, "m");
			CHECK_LE("height over the ground", height, 1e-5, "m");
			CHECK_LE("frames off the ground", off, 0, "");
			cn_world_destroy(w);
		}
}

/* ------------------------------------------------------------------ steps and slopes */

/* How high it gets at a step, or a stair of several. */
static double climbs(float step, int32_t steps, float speed)
{
	int32_t k;
	double up;
	begin(-1.0f, 0.8f);
	ground();
	for (k = 0; k < steps; ++k)
		box(10.0f + 0.5f * (float)k, 0.5f * step * (float)(k + 1), 10.0f, 0.5f * step * (float)(k + 1), 0.0f);
	walk(speed, (int32_t)(180.0f / fabsf(speed)));
	up = feet();
	CHECK(fixture_is_valid(w));
	cn_world_destroy(w);
	return up;
}

static void t_climbs_steps_up_to_its_limit(void)
{
	static const float speeds[4] = { 0.5f, 2.0f, 5.0f, 20.0f };
	int32_t k;
	for (k = 0; k < 4; ++k) {
		CHECK_LE("error of the height after a step of 0.05 m", fabs(climbs(0.05f, 1, speeds[k]) - 0.05), 1e-5, "m");
		CHECK_LE("error of the height after a step of 0.2 m", fabs(climbs(0.2f, 1, speeds[k]) - 0.2), 1e-5, "m");
		CHECK_LE("error of the height after a step of 0.295 m", fabs(climbs(0.295f, 1, speeds[k]) - 0.295), 1e-5, "m");
		CHECK_LE("height at a step of 0.31 m", fabs(climbs(0.31f, 1, speeds[k])), 1e-5, "m");
		CHECK_LE("height at a step of 0.6 m", fabs(climbs(0.6f, 1, speeds[k])), 1e-5, "m");
	}
	CHECK_LE("error of the height after a stair of 4 x 0.25 m", fabs(climbs(0.25f, 4, 2.0f) - 1.0), 1e-5, "m");
}

/* With a limit of 0.1 m, a third of the radius: round feet do not roll over what is higher. */
static void t_round_feet_do_not_roll_over_steps(void)
{
	begin(-1.0f, 0.8f);
	md.step_height_m = 0.1f;
	ground();
	box(10.0f, 0.06f, 10.0f, 0.06f, 0.0f);
	walk(3.0f, 120);
	CHECK_LE("distance walked into a step of 0.12 m", (double)mover.position_m.x, 0.0, "m");
	CHECK_LE("height", feet(), 1e-5, "m");
	cn_world_destroy(w);
}

/* Walks at a ramp that rises towards +x from x = 0; how high it gets in 3 s. */
static double climbs_slope(float degrees, float speed)
{
	float angle = degrees * 3.14159265f / 180.0f;
	double up;
	begin(-1.0f, 0.8f);
	ground();
	box(10.0f * cosf(angle) + 1.0f * sinf(angle), 10.0f * sinf(angle) - 1.0f * cosf(angle), 10.0f, 1.0f, angle);
	walk(speed, 180);
	up = feet();
	cn_world_destroy(w);
	return up;
}

static void t_slope_limit_holds_on_both_sides(void)
{
	static const float speeds[3] = { 1.0f, 3.0f, 10.0f };
	int32_t k;
	cn_mover_def_init(&md);
	for (k = 0; k < 3; ++k) {
		/* 0.87 rad are 49.8 degrees. */
		CHECK_GE("height on a slope of 49 degrees", climbs_slope(49.0f, speeds[k]), 1.2 * (double)speeds[k] < 4.0 ? 1.2 * (double)speeds[k] : 4.0, "m");
		CHECK_LE("height on a slope of 51 degrees", climbs_slope(51.0f, speeds[k]), 1e-3, "m");
		CHECK_LE("height on a slope of 75 degrees", climbs_slope(75.0f, speeds[k]), 1e-3, "m");
	}
}

static void t_slopes_are_walked_at_its_speed(void)
{
	double before_x, before_y, worst = 0.0;
	int32_t k, off = 0;
	float angle = 0.5f;
	begin(0.0f, 1.5f);
	box(0.0f, -1.0f, 50.0f, 1.0f, angle);
	walk(0.0f, 90);
	CHECK(on_ground());
	for (k = 0; k < 360; ++k) {
		before_x = (double)mover.position_m.x;
		before_y = (double)mover.position_m.y;
		walk(k < 180 ? 4.0f : -4.0f, 1);
		worst = greater(worst, fabs(hypot((double)mover.position_m.x - before_x, (double)mover.position_m.y - before_y) * 60.0 - 4.0));
		off += !on_ground();
	}
	CHECK_LE("speed off 4 m/s up and down a slope of 0.5 rad", worst, 0.01, "m/s");
	CHECK_LE("frames off the ground", off, 0, "");
	cn_world_destroy(w);
}

static void t_stands_still_on_slopes(void)
{
	static const float angles[3] = { 0.2f, 0.6f, 0.85f };
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_vec2 at;
		begin(0.0f, 1.5f);
		box(0.0f, -1.0f, 50.0f, 1.0f, angles[k]);
		walk(0.0f, 120);
		CHECK(on_ground());
		at = mover.position_m;
		walk(0.0f, 3600);
		CHECK_LE("creep on a slope in a minute", hypot((double)(mover.position_m.x - at.x), (double)(mover.position_m.y - at.y)), 0.0, "m");
		cn_world_destroy(w);
	}
	begin(0.0f, 1.5f);
	box(0.0f, -1.0f, 50.0f, 1.0f, 1.0f);
	for (k = 0; k < 120; ++k)
		move();
	CHECK(!on_ground());
	CHECK_LE("slid on a slope of 1 rad, in 2 s", (double)mover.position_m.y, -3.0, "m");
	cn_world_destroy(w);
}

/* Down a stair and over a crest without a frame in the air. */
static void t_keeps_to_the_ground_downhill(void)
{
	int32_t k, off = 0;
	begin(-1.0f, 1.8f);
	box(-20.0f, 0.5f, 20.0f, 0.5f, 0.0f);
	for (k = 0; k < 4; ++k)
		box(0.3f + 0.6f * (float)k, 0.4f - 0.1f * (float)k, 0.3f, 0.4f - 0.1f * (float)k, 0.0f);
	ground();
	walk(0.0f, 5);
	for (k = 0; k < 120; ++k) {
		walk(2.0f, 1);
		off += !on_ground();
	}
	CHECK_LE("frames in the air down a stair of 5 x 0.2 m", off, 0, "");
	CHECK_LE("height at its foot", fabs(feet()), 1e-5, "m");
	CHECK_LE("off where its speed takes it", fabs((double)mover.position_m.x - 3.0), 0.02, "m");
	cn_world_destroy(w);
}

/* Hills of a chain or of a row of hulls, up to 40 degrees: from one end to the other and back at 4 m/s along the ground. */
static void t_hills_are_walked_at_its_speed(void)
{
	int32_t kind, k, i;
	for (kind = 0; kind < 2; ++kind) {
		cn_vec2 points[101];
		cn_chain chain = { points, 101, 0 };
		cn_shape_def sd;
		uint32_t state = 9u;
		double length = 0.0, frames;
		int32_t off = 0, out = 0, back = 0;
		begin(0.0f, 3.0f);
		points[100].x = -5.0f;
		points[100].y = 0.0f;
		for (k = 99; k >= 0; --k) { /* from right to left */
			float step = fixture_random(&state, 0.4f, 1.5f), angle = k > 95 || k < 3 ? 0.0f : fixture_random(&state, -0.7f, 0.7f);
			points[k].x = points[k + 1].x + step * cosf(angle);
			points[k].y = points[k + 1].y + step * sinf(angle);
		}
		sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
		if (kind == 0)
			must(cn_shape_create_chain(w, &sd, &chain, NULL), w, "chain");
		for (k = 0; k < 100 && kind == 1; ++k) {
			cn_vec2 corners[4];
			cn_polygon hull;
			corners[0] = corners[2] = points[k];
			corners[1] = corners[3] = points[k + 1];
			corners[2].y -= 2.0f;
			corners[3].y -= 2.0f;
			must(cn_polygon_make_hull(corners, 4, 0.0f, &hull), NULL, "hull");
			must(cn_shape_create_polygon(w, &sd, &hull, NULL), w, "polygon");
		}
		mover.position_m.x = points[97].x;
		walk(0.0f, 60);
		CHECK(on_ground());
		for (k = 0; k < 97; ++k)
			length += k >= 2 ? hypot((double)(points[k].x - points[k + 1].x), (double)(points[k].y - points[k + 1].y)) : 0.0;
		frames = length / 4.0 * 60.0;
		for (i = 0; mover.position_m.x < points[2].x && i < 4000; ++i, ++out) {
			walk(4.0f, 1);
			off += !on_ground();
		}
		for (i = 0; mover.position_m.x > points[97].x && i < 4000; ++i, ++back) {
			walk(-4.0f, 1);
			off += !on_ground();
		}
		printf("  %g m of %s: %d frames there, %d back, %g at that speed\n", length, kind ? "hulls" : "a chain", (int)out, (int)back, frames);
		CHECK_LE("frames off the ground", off, 0, "");
		/* The foot of a capsule goes round corners on an arc, and loses a little where the ground turns up. */
		CHECK_LE("time there off the ground's length over 4 m/s", fabs(out / frames - 1.0), 0.01, "of it");
		CHECK_LE("time back", fabs(back / frames - 1.0), 0.01, "of it");
		cn_world_destroy(w);
	}
}

/* ------------------------------------------------------------------ air */

static void t_jumps_as_high_as_physics_says(void)
{
	double top = 0.0;
	int32_t k, frames = 0;
	begin(0.0f, 0.8f);
	ground();
	walk(0.0f, 2);
	mover.velocity_mps.y = 6.0f;
	for (k = 0; k < 120; ++k) {
		fixture_step(w, 1);
		move();
		top = greater(top, feet());
		frames += !on_ground();
	}
	/* The top lies between two frames: by up to g (dt / 2)^2 / 2. */
	CHECK_LE("error of the height of a jump at 6 m/s", fabs(top - 1.8), 4e-4, "m");
	CHECK_LE("error of its time", fabs((frames + 1) / 60.0 - 1.2), 1.5 / 60.0, "s");
	CHECK_LE("height after landing", fabs(feet()), 1e-5, "m");
	cn_world_destroy(w);
}

static void t_no_speed_passes_a_wall(void)
{
	static const float speeds[4] = { 10.0f, 100.0f, 1000.0f, 30000.0f };
	int32_t k;
	for (k = 0; k < 4; ++k) {
		begin(0.0f, 0.8f);
		ground();
		box(5.0f, 2.0f, 0.005f, 4.0f, 0.0f);
		walk(speeds[k], 40);
		CHECK_LE("distance from the wall", fabs((double)mover.position_m.x - (5.0 - 0.005 - RADIUS)), 1e-5, "m");
		CHECK(mover.flags & CN_MOVER_ON_WALL);
		CHECK_LE("speed left", fabs((double)mover.velocity_mps.x), 1e-3, "m/s");
		cn_world_destroy(w);
		begin(0.0f, 3.0f);
		ground();
		mover.velocity_mps.y = -speeds[k];
		walk(0.0f, 40);
		CHECK_LE("height after falling on the ground", fabs(feet()), 1e-5, "m");
		cn_world_destroy(w);
	}
}

static void t_ceilings_stop_a_jump(void)
{
	begin(0.0f, 0.8f);
	ground();
	box(0.0f, 3.0f, 5.0f, 1.0f, 0.0f);
	walk(0.0f, 2);
	mover.velocity_mps.y = 8.0f;
	for (int32_t k = 0; k < 4; ++k)
		move();
	CHECK(mover.flags & CN_MOVER_ON_CEILING);
	CHECK_LE("speed after hitting its head", (double)mover.velocity_mps.y, 1e-6, "m/s");
	walk(0.0f, 60);
	CHECK_LE("height after that", fabs(feet()), 1e-5, "m");
	cn_world_destroy(w);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_walks_level_ground_at_its_speed);
	RUN(t_seams_do_not_catch);
	RUN(t_climbs_steps_up_to_its_limit);
	RUN(t_round_feet_do_not_roll_over_steps);
	RUN(t_slope_limit_holds_on_both_sides);
	RUN(t_slopes_are_walked_at_its_speed);
	RUN(t_hills_are_walked_at_its_speed);
	RUN(t_stands_still_on_slopes);
	RUN(t_keeps_to_the_ground_downhill);
	RUN(t_jumps_as_high_as_physics_says);
	RUN(t_no_speed_passes_a_wall);
	RUN(t_ceilings_stop_a_jump);
	return test_end();
}
