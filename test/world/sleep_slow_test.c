/*
 * test/world/sleep_slow_test.c - slow is not at rest: what gathers speed slowly, or is moved slowly by a motor, does not fall asleep. What rocks
 * among bodies at rest does, after a while.
 *
 * Each case is a family over a few speeds and delays of sleep. If one of them sleeps, look at cni_body_gains in
 * step/integrate_pass.h, at keep_driven_awake and at movers_damp in step/sleep.c.
 */
#include "sleep.h"

#define SECONDS 5
#define STEPS (60 * SECONDS)
#define SETTINGS 4

static const struct { float speed, delay; } settings[SETTINGS] = { { 0.01f, 0.5f }, { 0.05f, 0.2f }, { 0.05f, 0.5f }, { 0.2f, 1.0f } };

static cn_world *sloping_world(int32_t setting, float gravity_x, float gravity_y)
{
	cn_world *world = fixture_world(gravity_y, 1);
	must(cn_world_set_sleep(world, settings[setting].speed, settings[setting].delay), world, "cn_world_set_sleep");
	must(cn_world_set_gravity(world, gravity_x, gravity_y), world, "cn_world_set_gravity");
	return world;
}

static cn_world *slow_world(int32_t setting, float gravity_x) { return sloping_world(setting, gravity_x, -10.0f); }

static int32_t steps_asleep(cn_world *world, cn_body body, int32_t steps)
{
	int32_t k, asleep = 0;
	for (k = 0; k < steps; ++k) {
		fixture_step(world, 1);
		asleep += !fixture_is_awake(world, body);
	}
	return asleep;
}

/* A floor is a slope when gravity has a part along it: (1 + excess) times what friction holds. */
static cn_body box_on_slope(cn_world *world, float friction)
{
	cn_body box;
	fixture_floor(world, friction, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, -20.0f, 0.5f, 0.0f, 0.5f, 0.5f, friction, 0.0f);
	return box;
}

static void boxes_slide_on_slopes_a_little_too_steep(void)
{
	static const float excesses[] = { 0.005f, 0.01f, 0.02f, 0.05f }, frictions[] = { 0.3f, 0.5f, 0.8f };
	int32_t setting, asleep = 0;
	size_t e, f;
	double worst = 0.0;
	for (setting = 0; setting < SETTINGS; ++setting)
		for (e = 0; e < 4; ++e)
			for (f = 0; f < 3; ++f) {
				float acceleration = 10.0f * frictions[f] * excesses[e];
				cn_world *world = slow_world(setting, 10.0f * frictions[f] + acceleration);
				cn_body box = box_on_slope(world, frictions[f]);
				double way = 0.5 * (double)acceleration * SECONDS * SECONDS;
				asleep += steps_asleep(world, box, STEPS);
				worst = greater(worst, fabs(((double)fixture_pose(world, box).position_m.x + 20.0) / way - 1.0));
				cn_world_destroy(world);
			}
	CHECK_LE("steps asleep", asleep, 0, "");
	CHECK_LE("error of the way in 5 s", worst, 0.05, "of it");
}

static void boxes_slide_where_there_is_little_gravity(void)
{
	static const float gravities[] = { 0.4f, 1.0f, 1.6f, 3.7f }, excesses[] = { 0.005f, 0.01f, 0.02f, 0.05f };
	int32_t asleep = 0, g, e, f;
	for (g = 0; g < 4; ++g)
		for (e = 0; e < 4; ++e)
			for (f = 0; f < 3; ++f) {
				float friction = 0.3f + 0.25f * (float)f;
				cn_world *world = sloping_world(2, gravities[g] * friction * (1.0f + excesses[e]), -gravities[g]);
				asleep += steps_asleep(world, box_on_slope(world, friction), STEPS) > 0;
				cn_world_destroy(world);
			}
	CHECK_LE("boxes asleep on a slope 0.5 to 5% too steep, of 48", asleep, 0, "");
}

static void boxes_on_slopes_that_hold_them_sleep(void)
{
	int32_t setting, awake = 0;
	for (setting = 0; setting < SETTINGS; ++setting) {
		cn_world *world = slow_world(setting, 10.0f * 0.49f);
		cn_body box = box_on_slope(world, 0.5f);
		awake += steps_to_sleep(world, box, 30 + (int32_t)(60.0f * settings[setting].delay)) < 0;
		cn_world_destroy(world);
	}
	CHECK_LE("boxes awake half a second after the delay", awake, 0, "");
}

/* A rod that stands on a hinge, 1 to 10 mrad off the upright. */
static void rods_that_begin_to_fall_do_not_sleep(void)
{
	static const float tilts[] = { 1e-3f, 3e-3f, 1e-2f };
	int32_t asleep = 0;
	size_t t;
	for (t = 0; t < 3; ++t) {
		cn_world *world = slow_world(2, 0.0f);
		cn_body rod = fixture_box(world, CN_BODY_DYNAMIC, 2.0f * tilts[t], 2.0f, -tilts[t], 0.1f, 2.0f, 0.6f, 0.0f);
		cn_revolute_def hinge;
		cn_joint joint;
		cn_revolute_def_init(&hinge);
		hinge.base.body_b = rod;
		hinge.base.anchor_b_m.y = -2.0f;
		must(cn_joint_create_revolute(world, &hinge, &joint), world, "cn_joint_create_revolute");
		asleep += steps_asleep(world, rod, 150);
		cn_world_destroy(world);
	}
	CHECK_LE("steps asleep", asleep, 0, "");
}

/* Slower than the sleep speed for longer than the delay around each apex. */
static void long_pendulums_do_not_sleep_at_their_apex(void)
{
	static const float lengths[] = { 2.0f, 10.0f, 40.0f };
	int32_t asleep = 0;
	size_t n;
	for (n = 0; n < 3; ++n) {
		cn_world *world = slow_world(2, 0.0f);
		float angle = 0.1f / sqrtf(10.0f * lengths[n]);
		cn_body bob = fixture_circle(world, CN_BODY_DYNAMIC, lengths[n] * angle, -lengths[n], 0.2f, 0.6f, 0.0f);
		cn_distance_def rod;
		cn_joint joint;
		cn_distance_def_init(&rod);
		rod.base.body_b = bob;
		rod.length_m = lengths[n];
		must(cn_joint_create_distance(world, &rod, &joint), world, "cn_joint_create_distance");
		asleep += steps_asleep(world, bob, 900);
		cn_world_destroy(world);
	}
	CHECK_LE("steps asleep", asleep, 0, "");
}

static void what_a_motor_moves_slowly_stays_awake(void)
{
	static const float speeds[] = { 0.002f, 0.01f, 0.04f, -0.002f, -0.04f };
	double worst = 0.0;
	size_t n;
	for (n = 0; n < sizeof speeds / sizeof *speeds; ++n) {
		cn_world *world = slow_world(2, 0.0f);
		cn_body box = unit_box(world, 0.0f, 0.0f);
		cn_prismatic_def slide;
		cn_joint joint;
		cn_prismatic_def_init(&slide);
		slide.base.body_b = box;
		slide.base.flags |= CN_JOINT_MOTOR;
		slide.motor_speed_mps = speeds[n];
		slide.motor_force_max_N = 1000.0f;
		must(cn_joint_create_prismatic(world, &slide, &joint), world, "cn_joint_create_prismatic");
		fixture_step(world, STEPS);
		worst = greater(worst, fabs((double)fixture_pose(world, box).position_m.x / (SECONDS * (double)speeds[n]) - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("error of the way in 5 s", worst, 0.02, "of it");
}

/* A wall stops the box, and it rests although the motor goes on pushing. */
static void what_a_motor_cannot_move_sleeps(void)
{
	cn_world *world = slow_world(2, 0.0f);
	cn_body box = unit_box(world, 0.0f, 0.0f);
	cn_prismatic_def slide;
	cn_joint joint;
	fixture_box(world, CN_BODY_STATIC, 1.0f, 0.0f, 0.0f, 0.5f, 2.0f, 0.6f, 0.0f);
	cn_prismatic_def_init(&slide);
	slide.base.body_b = box;
	slide.base.flags |= CN_JOINT_MOTOR;
	slide.motor_speed_mps = 0.5f;
	slide.motor_force_max_N = 5.0f;
	must(cn_joint_create_prismatic(world, &slide, &joint), world, "cn_joint_create_prismatic");
	CHECK_LE("steps until it sleeps", steps_to_sleep(world, box, 120), 60, "");
	CHECK(!fixture_is_awake(world, box));
	cn_world_destroy(world);
}

/* A ball with a weight low in it, which rolls to and fro without slip: on a plate of this type. */
static cn_body toy_on_plate(cn_world *world, int32_t type, float angle)
{
	cn_body toy;
	cn_shape_def def;
	cn_circle ball = { { 0.0f, 0.0f }, 0.5f }, weight = { { 0.0f, -0.3f }, 0.15f };
	fixture_floor(world, 0.6f, 0.0f);
	fixture_box(world, type, 0.0f, 0.25f, 0.0f, 2.0f, 0.25f, 0.6f, 0.0f);
	toy = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, angle);
	def = fixture_shape_def(toy, 0.6f, 0.0f);
	must(cn_shape_create_circle(world, &def, &ball, NULL), world, "cn_shape_create_circle");
	def.density_kgpm2 = 20.0f;
	must(cn_shape_create_circle(world, &def, &weight, NULL), world, "cn_shape_create_circle");
	return toy;
}

/* Rolling to and fro takes no energy, but would keep awake what else rests in the island. */
static void what_rocks_on_bodies_at_rest_comes_to_rest(void)
{
	static const float angles[] = { 0.03f, 0.06f, 0.1f };
	size_t a;
	for (a = 0; a < 3; ++a) {
		cn_world *world = slow_world(2, 0.0f);
		cn_body toy = toy_on_plate(world, CN_BODY_DYNAMIC, angles[a]);
		printf("  %.2f rad: sleeps after %d steps\n", (double)angles[a], (int)steps_to_sleep(world, toy, 900));
		CHECK(!fixture_is_awake(world, toy));
		cn_world_destroy(world);
	}
}

/* Nothing waits for a body that is alone in its island. */
static void what_rocks_alone_rocks_on(void)
{
	cn_world *world = slow_world(2, 0.0f);
	cn_body toy = toy_on_plate(world, CN_BODY_STATIC, 0.1f);
	double most = 0.0;
	int32_t k;
	for (k = 0; k < 1800; ++k) {
		fixture_step(world, 1);
		most = k < 1500 ? 0.0 : greater(most, fabs(asin((double)fixture_pose(world, toy).sine)));
	}
	CHECK_GE("rad, its swing after 25 s", most, 0.095, "rad");
	CHECK_LE("rad, its swing after 25 s", most, 0.101, "rad");
	cn_world_destroy(world);
}

/* A plate bears it, so that it is not alone in its island. */
static void a_box_slides_on_a_plate_at_rest(void)
{
	cn_world *world = slow_world(2, 3.3f);
	cn_body box;
	double way = 0.5 * 0.3 * SECONDS * SECONDS;
	fixture_floor(world, 0.8f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.25f, 0.0f, 20.0f, 0.25f, 0.8f, 0.0f);
	fixture_step(world, 10);
	box = fixture_box(world, CN_BODY_DYNAMIC, -10.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.1125f, 0.0f); /* friction is the root of the product: 0.3 */
	CHECK_LE("steps asleep", steps_asleep(world, box, STEPS), 0, "");
	CHECK_GE("part of its way", ((double)fixture_pose(world, box).position_m.x + 10.0) / way, 0.98, "");
	cn_world_destroy(world);
}

int main(void)
{
	RUN(boxes_slide_on_slopes_a_little_too_steep);
	RUN(boxes_slide_where_there_is_little_gravity);
	RUN(boxes_on_slopes_that_hold_them_sleep);
	RUN(rods_that_begin_to_fall_do_not_sleep);
	RUN(long_pendulums_do_not_sleep_at_their_apex);
	RUN(what_a_motor_moves_slowly_stays_awake);
	RUN(what_a_motor_cannot_move_sleeps);
	RUN(what_rocks_on_bodies_at_rest_comes_to_rest);
	RUN(what_rocks_alone_rocks_on);
	RUN(a_box_slides_on_a_plate_at_rest);
	return test_end();
}
