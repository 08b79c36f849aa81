/*
 * test/world/locks_test.c - bodies with locked axes in joints, and axes that are locked and freed while the world runs.
 */
#include "joints.h"
#include "random_bodies.h"
#include "test.h"

static void set_locks(cn_world *world, cn_body body, uint32_t locks)
{
	must(cn_body_set_flags(world, body, (uint32_t)CN_BODY_ENABLED | (uint32_t)CN_BODY_SLEEP | locks), world, "cn_body_set_flags");
}

/* ---- joints ---- */

/* Chains swing below a body that cannot move, can only turn, or slides along x. */
static void chains_hang_exactly_from_locked_bodies(void)
{
	static const uint32_t locks[3] = { CN_BODY_LOCK_X | CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION, CN_BODY_LOCK_X | CN_BODY_LOCK_Y, CN_BODY_LOCK_Y };
	int32_t k, step, i;
	for (k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[10], held = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.4f, 0.0f, 0.1f, 0.1f, 0.0f, 0.0f);
		cn_joint joints[10];
		double worst = 0.0;
		make_chain(world, 10, 1.0f, 0.0f, bodies, joints);
		must(cn_joint_destroy(world, joints[0]), world, "cn_joint_destroy");
		joints[0] = hinge(world, held, at(0.0f, -0.4f), bodies[0], at(-0.25f, 0.0f));
		set_locks(world, held, locks[k]);
		for (step = 0; step < 60; ++step) {
			fixture_step(world, 1);
			for (i = 0; i < 10; ++i)
				worst = fmax(worst, joint_error_m(world, joints[i]));
		}
		CHECK_LE("greatest error of a joint", worst, 1e-4, "m");
		CHECK_LE("way along the locked axis", fabs((double)fixture_pose(world, held).position_m.y - (double)0.4f), 0.0, "m");
		cn_world_destroy(world);
	}
}

/* A pendulum on a cart that its locks keep on a rail, and the same cart on a slide. */
static void a_locked_axis_is_a_rail(void)
{
	int32_t slides, step;
	cn_vec2 ends[2];
	for (slides = 0; slides < 2; ++slides) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body cart = unit_box(world, 0.0f, 0.0f, 0.0f), bob = fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 0.0f, 0.0f, 0.3f, 0.3f, 0.0f, 0.0f);
		cn_joint pin = hinge(world, cart, at(0.3f, 0.2f), bob, at(-1.7f, 0.2f));
		double worst = 0.0;
		if (slides) {
			cn_prismatic_def def;
			cn_prismatic_def_init(&def);
			connect(&def.base, 0, at(0.0f, 0.0f), cart, at(0.0f, 0.0f));
			def.axis = at(1.0f, 0.0f);
			make_prismatic(world, &def);
		} else {
			set_locks(world, cart, CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION);
		}
		for (step = 0; step < 120; ++step) {
			fixture_step(world, 1);
			worst = fmax(worst, joint_error_m(world, pin));
		}
		CHECK_LE("greatest error of the pin", worst, 1e-4, "m");
		ends[slides] = fixture_pose(world, bob).position_m;
		cn_world_destroy(world);
	}
	CHECK_LE("distance of the bobs after 2 s", hypot((double)(ends[0].x - ends[1].x), (double)(ends[0].y - ends[1].y)), 1e-4, "m");
}

/* Of its two rows that of the angle moves nothing. */
static void slides_hold_bodies_that_cannot_turn(void)
{
	int32_t solver;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body box = unit_box(world, 0.0f, 0.0f, 0.0f);
		cn_prismatic_def def;
		cn_prismatic_def_init(&def);
		connect(&def.base, 0, at(0.0f, 0.0f), box, at(0.0f, 0.0f));
		def.axis = at(1.0f, 0.0f);
		must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
		set_locks(world, box, CN_BODY_LOCK_ROTATION);
		make_prismatic(world, &def);
		fixture_step(world, 60);
		CHECK_LE("way down in a second", fabs((double)fixture_pose(world, box).position_m.y), 1e-3, "m");
		cn_world_destroy(world);
	}
}

/* Also where a unit of length is a pixel: 1 / inertia is small there beside 1 / mass. */
static void motors_turn_locked_wheels_of_any_size(void)
{
	int32_t solver, large;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver)
		for (large = 0; large < 2; ++large) {
			float radius = large ? 500.0f : 0.5f, mass;
			cn_world *world = fixture_world(0.0f, 0);
			cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, radius, 0.6f, 0.0f);
			cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
			mass = mass_of(world, wheel).mass_kg;
			must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
			set_locks(world, wheel, CN_BODY_LOCK_X);
			def.base.flags = CN_JOINT_MOTOR;
			def.motor_speed_radps = 2.0f;
			def.motor_torque_max_Nm = 100.0f * mass * radius * radius;
			(void)make_revolute(world, &def);
			fixture_step(world, 60);
			CHECK_LE("error of the speed", fabs((double)fixture_velocity(world, wheel).angular_radps - 2.0), 0.01, "rad/s");
			cn_world_destroy(world);
		}
}

/* A joint that ends at a locked axis reports its force, and breaks by it. */
static void a_locked_axis_reports_what_it_bears(void)
{
	int32_t swapped, breaks;
	for (swapped = 0; swapped < 2; ++swapped)
		for (breaks = 0; breaks < 2; ++breaks) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body held = unit_box(world, 0.0f, 0.0f, 0.0f), load = unit_box(world, 0.0f, -2.0f, 0.0f);
			cn_revolute_def def = swapped ? revolute_def(load, at(0.0f, 2.0f), held, at(0.0f, 0.0f)) : revolute_def(held, at(0.0f, 0.0f), load, at(0.0f, 2.0f));
			cn_joint pin;
			def.base.break_force_N = breaks ? 9.0f : 1000.0f;
			def.base.flags |= CN_JOINT_BREAKS;
			set_locks(world, held, CN_BODY_LOCK_X | CN_BODY_LOCK_Y);
			pin = make_revolute(world, &def);
			fixture_step(world, 60);
			CHECK((cn_joint_is_valid(world, pin) != 0) == !breaks);
			if (!breaks)
				CHECK_LE("error of the force", fabs(fabs((double)joint_force(world, pin).y) - GRAVITY), 0.01, "N");
			cn_world_destroy(world);
		}
}

/* ---- locked in play ---- */

/* Locks a random body every 30 steps, for 15. Returns the greatest speed. */
static double locked_in_turn(cn_world *world, const cn_body *bodies, int32_t count, uint32_t *random)
{
	double fastest = 0.0;
	int32_t step, k, held = 0;
	for (step = 0; step < 300; ++step) {
		if (step % 30 == 0) {
			held = draw_int(random, count);
			set_locks(world, bodies[held], 1u + (uint32_t)draw_int(random, 7));
		} else if (step % 30 == 15) {
			set_locks(world, bodies[held], 0);
		}
		fixture_step(world, 1);
		for (k = 0; k < count; ++k) {
			cn_vec2 v = fixture_velocity(world, bodies[k]).linear_mps;
			fastest = fmax(fastest, hypot((double)v.x, (double)v.y));
		}
	}
	CHECK(fixture_is_valid(world));
	return fastest;
}

#define PILE 40

static void locks_in_a_pile_throw_nothing(void)
{
	int32_t seed, seeds = TEST_MANY(30);
	double fastest = 0.0;
	for (seed = 0; seed < seeds; ++seed) {
		uint32_t random = 77u + 13u * (uint32_t)seed;
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[PILE];
		int32_t k;
		draw_ground(world, &random, draw_int(&random, GROUND_KINDS), 0.6f);
		for (k = 0; k < PILE; ++k)
			bodies[k] = draw_body(world, &random, 0.8f * (float)(k % 8), 0.5f + 0.8f * (float)(k / 8), 0.35f, 0.6f, 0.0f);
		fastest = fmax(fastest, locked_in_turn(world, bodies, PILE, &random));
		cn_world_destroy(world);
	}
	CHECK_LE("greatest speed", fastest, 20.0, "m/s");
}

#define NET 6

static void locks_in_a_net_throw_nothing(void)
{
	int32_t seed, seeds = TEST_MANY(30), x, y;
	double fastest = 0.0;
	for (seed = 0; seed < seeds; ++seed) {
		uint32_t random = 413u + 17u * (uint32_t)seed;
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[NET * NET];
		for (y = 0; y < NET; ++y)
			for (x = 0; x < NET; ++x) {
				cn_body *b = &bodies[y * NET + x];
				*b = fixture_circle(world, CN_BODY_DYNAMIC, (float)x, -(float)y, 0.2f, 0.6f, 0.0f);
				if (y == 0 && (x == 0 || x == NET - 1))
					(void)hinge(world, 0, at((float)x, 0.5f), *b, at(0.0f, 0.5f));
				if (x > 0 && draw_int(&random, 4) > 0)
					(void)hinge(world, b[-1], at(0.5f, 0.0f), *b, at(-0.5f, 0.0f));
				if (y > 0)
					(void)hinge(world, b[-NET], at(0.0f, -0.5f), *b, at(0.0f, 0.5f));
			}
		fastest = fmax(fastest, locked_in_turn(world, bodies, NET * NET, &random));
		cn_world_destroy(world);
	}
	CHECK_LE("greatest speed", fastest, 30.0, "m/s");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(chains_hang_exactly_from_locked_bodies);
	RUN(a_locked_axis_is_a_rail);
	RUN(slides_hold_bodies_that_cannot_turn);
	RUN(motors_turn_locked_wheels_of_any_size);
	RUN(a_locked_axis_reports_what_it_bears);
	RUN(locks_in_a_pile_throw_nothing);
	RUN(locks_in_a_net_throw_nothing);
	return test_end();
}
