/*
 * test/world/rest_test.c - islands at rest take one substep (step/early_rest.c): that changes nothing that anybody sees.
 *
 * What is about to move moves as it should, however gently it is asked to; what stands on something slow is carried; an
 * island of which one body moves is solved as ever. If something sticks or lags, look at the conditions of body_rests.
 */
#include "step/stages.h"
#include "heaps.h"
#include "model/world.h"
#include "model/solve.h"

static cn_body box_at(cn_world *world, float x, float y, float friction)
{
	return fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.0f, 0.5f, 0.5f, friction, 0.0f);
}

static cn_island_report first_island(const cn_world *world)
{
	cn_island_report reports[8];
	int32_t count = 0;
	memset(reports, 0, sizeof reports);
	must(cn_world_get_islands(world, reports, 8, &count), world, "cn_world_get_islands");
	CHECK(count > 0);
	return reports[0];
}

static int32_t substeps_of_first_island(const cn_world *world)
{
	return first_island(world).substeps;
}

static void a_pile_at_rest_takes_one_substep(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body top;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 5; ++k)
		top = box_at(world, 0.0f, 0.5f + (float)k, 0.6f);
	fixture_step(world, 60);
	CHECK(substeps_of_first_island(world) == 1);
	fixture_set_velocity(world, top, 0.2f, 0.0f, 0.0f);
	fixture_step(world, 1);
	CHECK(substeps_of_first_island(world) == 4);
	fixture_step(world, 240);
	CHECK(substeps_of_first_island(world) == 1);
	CHECK_LE("the top's height against 4.5 m", fabs((double)fixture_pose(world, top).position_m.y - 4.5), 1e-5, "m");
	cn_world_destroy(world);
}

/* A force of a thousandth of the weight on a box without friction: x = a t^2 / 2. A step that is lost costs 1.7 mm. */
static void a_gentle_force_moves_it(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body box;
	int32_t k;
	fixture_floor(world, 0.0f, 0.0f);
	box = box_at(world, 0.0f, 0.5f, 0.0f);
	fixture_step(world, 60);
	for (k = 0; k < 600; ++k) {
		must(cn_body_apply_force(world, box, 0.01f, 0.0f), world, "cn_body_apply_force");
		fixture_step(world, 1);
	}
	CHECK_LE("way in 10 s against 0.5 m", fabs((double)fixture_pose(world, box).position_m.x - 0.5), 1e-5, "m");
	cn_world_destroy(world);
}

/* A torque as small on a disc without friction: w = T t / I. */
static void a_gentle_torque_turns_it(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body disc;
	cn_mass_data mass;
	int32_t k;
	fixture_floor(world, 0.0f, 0.0f);
	disc = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.0f, 0.0f);
	must(cn_body_get_mass_data(world, disc, &mass), world, "cn_body_get_mass_data");
	fixture_step(world, 60);
	for (k = 0; k < 600; ++k) {
		must(cn_body_apply_torque(world, disc, 1e-3f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	CHECK_LE("spin after 10 s against T t / I", fabs((double)fixture_velocity(world, disc).angular_radps / (1e-2 / (double)mass.inertia_kgm2) - 1.0), 1e-4, "");
	CHECK_LE("turned against T t^2 / (2 I)", fabs(asin((double)fixture_pose(world, disc).sine) / (0.05 / (double)mass.inertia_kgm2) - 1.0), 1e-3, "");
	cn_world_destroy(world);
}

/* A contact at rest has one of the step's substeps: its load follows by a part of what it does in all of them. */
static void loads_of_what_rests_follow_slower(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	int32_t substeps[3] = { 2, 4, 9 }, k, kind;
	for (k = 0; k < 3; ++k) {
		cni_solve s;
		must(cn_world_set_substep_count(world, substeps[k]), world, "cn_world_set_substep_count");
		s = cni_solve_make(world, FRAME_S, world->settings.substeps);
		for (kind = 0; kind < CNI_CONTACTS_KINDS; ++kind)
			if (kind & CNI_CONTACTS_RESTED) {
				const cni_contact_pass *moves = &s.contact[kind & ~CNI_CONTACTS_RESTED], *rests = &s.contact[kind];
				CHECK_LE("error of the ratio of parts", fabs((double)(rests->load_part / moves->load_part) * substeps[k] - 1.0), 1e-6, "");
				CHECK_LE("... and of weights that are heavy", fabs((double)(rests->load_heavy / moves->load_heavy) * substeps[k] - 1.0), 1e-6, "");
			}
	}
	cn_world_destroy(world);
}

static void what_stands_on_something_slow_is_carried(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body lift = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, -0.5f, 0.0f, 3.0f, 0.5f, 0.6f, 0.0f), box;
	box = box_at(world, 0.0f, 0.5f, 0.6f);
	fixture_step(world, 60);
	fixture_set_velocity(world, lift, 5e-5f, 5e-5f, 0.0f);
	fixture_step(world, 3600);
	CHECK_LE("the lift's way in a minute against 3 mm", fabs((double)fixture_pose(world, lift).position_m.x - 3e-3), 1e-6, "m");
	CHECK_LE("... and up", fabs((double)fixture_pose(world, lift).position_m.y + 0.5 - 3e-3), 1e-6, "m");
	CHECK_LE("the box's way against 3 mm", fabs((double)fixture_pose(world, box).position_m.x - 3e-3), 1e-5, "m");
	CHECK_LE("... and up", fabs((double)fixture_pose(world, box).position_m.y - 0.5 - 3e-3), 1e-5, "m");
	cn_world_destroy(world);
}

/* Until the overlap is gone; what is left then is pushed apart at less than the 0.1 mm/s at which things rest. */
static void pushed_out_of_an_overlap(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body high;
	int32_t k, pushed = 0, rested = 0;
	fixture_floor(world, 0.6f, 0.0f);
	box_at(world, 0.0f, 0.5f, 0.6f);
	high = box_at(world, 0.0f, 1.45f, 0.6f);
	for (k = 0; k < 120; ++k) {
		cn_island_report island;
		fixture_step(world, 1);
		island = first_island(world);
		pushed += island.residual_m > 1e-5f;
		rested += island.residual_m > 1e-5f && island.substeps != 4;
	}
	CHECK_GE("steps with more than 10 um of overlap", pushed, 10, "");
	CHECK_LE("... of these not in all substeps", rested, 0, "");
	CHECK(substeps_of_first_island(world) == 1);
	CHECK_LE("height of the upper box against 1.5 m", fabs((double)fixture_pose(world, high).position_m.y - 1.5), 1e-5, "m");
	cn_world_destroy(world);
}

/* With a thousandth of a metre a second squared, thrown 4.5 mm high: at the top it is slow, and still near the floor. */
static void thrown_in_weak_gravity(void)
{
	cn_world *world = fixture_world(-1e-3f, 0);
	double off = 0.0;
	cn_body box;
	int32_t k, slow = 0, rested = 0;
	fixture_floor(world, 0.6f, 0.0f);
	box = box_at(world, 0.0f, 0.5f, 0.6f);
	fixture_step(world, 60);
	CHECK(substeps_of_first_island(world) == 1);
	fixture_set_velocity(world, box, 0.0f, 3e-3f, 0.0f);
	for (k = 1; k <= 350; ++k) {
		double t = (double)k * (double)FRAME_S, y;
		fixture_step(world, 1);
		y = (double)fixture_pose(world, box).position_m.y - 0.5;
		off = greater(off, fabs(y - 3e-3 * t + 0.5e-3 * t * t));
		slow += fabs((double)fixture_velocity(world, box).linear_mps.y) < 5e-5;
		rested += substeps_of_first_island(world) != 4;
	}
	CHECK_GE("steps below 0.05 mm/s", slow, 5, "");
	CHECK_LE("steps of its flight not in all substeps", rested, 0, "");
	CHECK_LE("distance from the parabola", off, 1e-6, "m");
	cn_world_destroy(world);
}

/* The end of a throw is no rest, however weak gravity is; nor is being pushed out of an overlap. */
static void what_is_on_its_way_is_not_at_rest(void)
{
	pushed_out_of_an_overlap();
	thrown_in_weak_gravity();
}

#define HEAP_BODIES 50
#define HEAPS 10

/* A heap of mixed bodies does not creep for ever: what a contact bears is known well enough when nothing has moved for a while. A
   ball may roll off one of them late. */
static void heaps_come_to_rest(void)
{
	int32_t heap, rested = 0;
	for (heap = 1; heap <= HEAPS; ++heap) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body bodies[HEAP_BODIES];
		double speed = 0.0;
		int32_t k;
		heap_bowl(world);
		heap_drop(world, (uint32_t)heap, bodies, HEAP_BODIES);
		fixture_step(world, 840);
		for (k = 0; k < 60; ++k) {
			fixture_step(world, 1);
			speed = greater(speed, heap_speed(world, bodies, HEAP_BODIES));
		}
		rested += speed < 1e-4;
		cn_world_destroy(world);
	}
	CHECK_GE("heaps below 0.1 mm/s for a second", rested, HEAPS - 2, "");
}

#define POURED_BODIES 100
#define POURED_HEAPS TEST_MANY(12)
#define POURED_STEPS 360

/* What comes to rest slowly, or swings about its place, does not restart its rest timer (cni_body_gains): half of the heaps sleep within 350
   steps. */
static void poured_heaps_fall_asleep(void)
{
	int32_t heap, step, asleep = 0;
	for (heap = 1; heap <= POURED_HEAPS; ++heap) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body bodies[POURED_BODIES];
		heap_bowl(world);
		heap_drop(world, (uint32_t)heap, bodies, POURED_BODIES);
		for (step = 0; step < POURED_STEPS && (step < 60 || fixture_counters(world).bodies_awake > 0); ++step)
			fixture_step(world, 1);
		asleep += step < POURED_STEPS;
		cn_world_destroy(world);
	}
	CHECK_GE("heaps of 100 that sleep within 360 steps", asleep, POURED_HEAPS / 2, "");
}

int main(void)
{
	RUN(a_pile_at_rest_takes_one_substep);
	RUN(a_gentle_force_moves_it);
	RUN(a_gentle_torque_turns_it);
	RUN(loads_of_what_rests_follow_slower);
	RUN(what_stands_on_something_slow_is_carried);
	RUN(what_is_on_its_way_is_not_at_rest);
	RUN(heaps_come_to_rest);
	RUN(poured_heaps_fall_asleep);
	return test_end();
}
