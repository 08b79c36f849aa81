/*
 * test/world/piles_test.c - what a large pile bears is known at once: it does not sag, and it does not fly apart
 * where that cannot be known.
 *
 * If a test here fails, look first in: contacts/gravity_preload.c, then direct/solver_selection.c (which contacts are new) and the load in
 * contacts/contact_kernel.h.
 */
#include "fixture.h"

#define BODIES 1000

typedef struct pile {
	cn_world *world;
	cn_body bodies[BODIES];
	float x[BODIES], y[BODIES];
	int32_t count;
} pile;

static void pile_begin(pile *p)
{
	p->world = fixture_world(-10.0f, 0);
	p->count = 0;
}

static cn_body pile_box(pile *p, float x, float y, float density)
{
	cn_body body = fixture_body(p->world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.density_kgpm2 = density;
	fixture_box_shape(p->world, &def, 0.5f, 0.5f);
	p->bodies[p->count] = body;
	p->x[p->count] = x;
	p->y[p->count++] = y;
	return body;
}

/* Every second row is dense times as dense as the others. */
static void pile_pyramid(pile *p, int32_t base, float floor, float dense)
{
	int32_t row, k;
	for (row = 0; row < base; ++row)
		for (k = row; k < base; ++k)
			pile_box(p, 0.5f * (float)(row + 1) + (float)(k - row) - 0.5f * (float)base, (float)row + 0.5f + floor, row % 2 == 1 ? dense : 1.0f);
}

static double displacement(const pile *p)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		cn_pose pose = fixture_pose(p->world, p->bodies[k]);
		most = greater(most, hypot((double)(pose.position_m.x - p->x[k]), (double)(pose.position_m.y - p->y[k])));
	}
	return most;
}

static double fastest(const pile *p)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		cn_velocity v = fixture_velocity(p->world, p->bodies[k]);
		most = greater(most, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
	}
	return most;
}

/* Largest displacement in so many steps, looked at in each of the first ones and every fifth after. */
static double displacement_of(pile *p, int32_t steps)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < steps; ++k) {
		fixture_step(p->world, 1);
		if (k < 10 || k % 5 == 4)
			most = greater(most, displacement(p));
	}
	return most;
}

static pile tested;

static void t_a_large_pyramid_does_not_sag(void)
{
	pile_begin(&tested);
	fixture_floor(tested.world, 0.6f, 0.0f);
	pile_pyramid(&tested, 40, 0.0f, 1.0f);
	CHECK_LE("displacement in 2 s", displacement_of(&tested, 120), 1e-4, "m");
	cn_world_destroy(tested.world);
}

static void t_heavy_rows_on_light_ones_do_not_sag(void)
{
	pile_begin(&tested);
	fixture_floor(tested.world, 0.6f, 0.0f);
	pile_pyramid(&tested, 30, 0.0f, 20.0f);
	CHECK_LE("displacement in 2 s", displacement_of(&tested, 120), 1e-4, "m");
	cn_world_destroy(tested.world);
}

/* Loads are of the step's length, and are scaled when that changes. */
static void t_a_pyramid_may_be_built_late(void)
{
	pile_begin(&tested);
	fixture_floor(tested.world, 0.6f, 0.0f);
	must(cn_world_step(tested.world, 1.0f / 30.0f), tested.world, "cn_world_step");
	pile_pyramid(&tested, 30, 0.0f, 1.0f);
	CHECK_LE("displacement in 1 s, after a longer step", displacement_of(&tested, 60), ROUNDING, "m");
	cn_world_destroy(tested.world);
}

/* Friction that bears a part of the weight is laid on with its levers: on a slope of 0.2 to either side. */
static void t_a_pyramid_on_a_slope_does_not_sag(void)
{
	static const float along[2] = { 2.0f, -2.0f };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		pile_begin(&tested);
		must(cn_world_set_gravity(tested.world, along[k], -10.0f), tested.world, "cn_world_set_gravity");
		fixture_floor(tested.world, 0.6f, 0.0f);
		pile_pyramid(&tested, 24, 0.0f, 1.0f);
		fixture_step(tested.world, 1);
		CHECK_LE("fastest after one step", fastest(&tested), 1e-4, "m/s");
		CHECK_LE("displacement in 1 s", displacement_of(&tested, 60), 1e-4, "m");
		cn_world_destroy(tested.world);
	}
}

/* A pyramid on a board that reaches over the edge of a table and tips: nothing holds it, so nothing may be laid on it. */
static void t_what_cannot_be_held_is_let_fall(void)
{
	cn_body board;
	pile_begin(&tested);
	fixture_box(tested.world, CN_BODY_STATIC, -15.0f, -1.0f, 0.0f, 5.0f, 1.0f, 0.6f, 0.0f);
	board = fixture_box(tested.world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 12.0f, 0.5f, 0.6f, 0.0f);
	pile_pyramid(&tested, 23, 1.0f, 1.0f);
	fixture_step(tested.world, 1);
	CHECK_LE("fastest after one step", fastest(&tested), 10.5 / 60.0, "m/s");
	CHECK_LE("... the board", -fixture_velocity(tested.world, board).linear_mps.y, 10.5 / 60.0, "m/s");
	CHECK(fixture_is_valid(tested.world));
	cn_world_destroy(tested.world);
}

/* On 0.999 of the slope that its friction holds. */
static void t_a_body_set_down_on_a_slope_stays(void)
{
	const float angle = 0.4632477f; /* tan 0.4995, friction 0.5 */
	cn_body body;
	cn_pose from, to;
	pile_begin(&tested);
	fixture_box(tested.world, CN_BODY_STATIC, sinf(angle), -cosf(angle), angle, 50.0f, 1.0f, 0.5f, 0.0f);
	body = fixture_box(tested.world, CN_BODY_DYNAMIC, -0.5f * sinf(angle), 0.5f * cosf(angle), angle, 0.5f, 0.5f, 0.5f, 0.0f);
	from = fixture_pose(tested.world, body);
	fixture_step(tested.world, 120);
	to = fixture_pose(tested.world, body);
	CHECK_LE("slip in 2 s", hypot((double)(to.position_m.x - from.position_m.x), (double)(to.position_m.y - from.position_m.y)), 5e-6, "m");
	cn_world_destroy(tested.world);
}

/* A flat box that slides more easily than it sticks is set down, and pushed suddenly by a little less than sticks: it stays. */
static void t_a_sudden_push_does_not_break_loose(void)
{
	static const float parts[] = { 0.4f, 0.45f, 0.48f };
	double most = 0.0;
	int32_t k, n;
	for (n = 0; n < 3; ++n) {
		cn_body body;
		cn_shape_def def;
		pile_begin(&tested);
		fixture_floor(tested.world, 0.5f, 0.0f);
		body = fixture_body(tested.world, CN_BODY_DYNAMIC, 0.0f, 0.2f, 0.0f);
		def = fixture_shape_def(body, 0.5f, 0.0f);
		def.material.dynamic_friction = 0.2f;
		fixture_box_shape(tested.world, &def, 1.0f, 0.2f); /* 0.8 kg */
		fixture_step(tested.world, 10);
		for (k = 0; k < 60; ++k) {
			must(cn_body_apply_force(tested.world, body, parts[n] * 8.0f, 0.0f), tested.world, "cn_body_apply_force");
			fixture_step(tested.world, 1);
		}
		most = greater(most, fabs((double)fixture_pose(tested.world, body).position_m.x));
		cn_world_destroy(tested.world);
	}
	CHECK_LE("moved in 1 s by up to 0.48 of its weight", most, SOLVED, "m");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_large_pyramid_does_not_sag);
	RUN(t_heavy_rows_on_light_ones_do_not_sag);
	RUN(t_a_pyramid_may_be_built_late);
	RUN(t_a_pyramid_on_a_slope_does_not_sag);
	RUN(t_what_cannot_be_held_is_let_fall);
	RUN(t_a_body_set_down_on_a_slope_stays);
	RUN(t_a_sudden_push_does_not_break_loose);
	return test_end();
}
