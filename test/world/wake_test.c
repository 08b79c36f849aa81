/*
 * test/world/wake_test.c - what wakes sleepers and what does not, and sleep by call.
 *
 * If a test here fails, look first in: model/island_sleep.c (moving between awake and asleep), the function that was to wake,
 * world/body_state.c (cn_body_set_awake), narrowphase/narrowphase.c (what moves into sleepers).
 */
#include "sleep.h"

/* ---- waking ---- */

enum {
	WAKE_CONTACT, WAKE_JOINT, WAKE_IMPULSE, WAKE_ANGULAR_IMPULSE, WAKE_FORCE, WAKE_TORQUE, WAKE_VELOCITY, WAKE_WRITE, WAKE_CALL,
	WAKE_SUPPORT, WAKE_MATERIAL, WAKE_DENSITY, WAKE_GRAVITY, WAKE_SCALE, WAKE_TELEPORT, WAKE_TYPE, WAKE_GROUND_TYPE, WAKE_GROUND_GONE,
	WAKE_GROUND_OFF, WAKE_GROUND_SHAPE, WAKE_GROUND_MATERIAL, WAKE_GROUND_FILTER, WAKE_GROUND_MOVES, WAKE_NO_SLEEP, WAKE_WORLD, WAKE_MASS,
	WAKE_LOCK, WAKE_NEW_SHAPE, WAKES
};
static const char *const wake_names[] = {
	"contact", "joint", "impulse", "angular impulse", "force", "torque", "velocity", "written velocity", "cn_body_set_awake",
	"support destroyed", "material", "density", "gravity", "gravity scale", "teleport", "type", "type of the ground", "ground destroyed",
	"ground disabled", "shape of the ground destroyed", "material of the ground", "filter of the ground", "ground teleported", "CN_BODY_SLEEP off", "CN_WORLD_SLEEP off",
	"mass data", "lock", "new shape"
};

/* box rests on support, support on the ground; all asleep. */
static void wake_by(cn_world *world, int32_t way, cn_body ground, cn_body support, cn_body box)
{
	cn_material material = fixture_shape_def(0, 0.1f, 0.0f).material;
	cn_filter none = { 1, 0, 0, 0 };
	cn_mass_data mass = { 3.0f, 1.0f, { 0.0f, 0.0f } };
	cn_velocity velocity = { { 0.2f, 0.0f }, 0.0f };
	cn_distance_def rod;
	cn_joint joint;
	cn_body ball;
	cn_shape_def def;
	switch (way) {
	case WAKE_CONTACT:
		ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 3.0f, 0.5f, 0.6f, 0.0f);
		fixture_set_velocity(world, ball, 0.0f, -10.0f, 0.0f);
		fixture_step(world, 8);
		break;
	case WAKE_JOINT:
		cn_distance_def_init(&rod);
		rod.base.body_b = box;
		rod.base.anchor_a_m.y = 3.0f;
		rod.length_m = 1.5f;
		must(cn_joint_create_distance(world, &rod, &joint), world, "joint");
		break;
	case WAKE_IMPULSE: must(cn_body_apply_impulse(world, box, 0.1f, 0.0f), world, "impulse"); break;
	case WAKE_ANGULAR_IMPULSE: must(cn_body_apply_angular_impulse(world, box, 0.1f), world, "angular impulse"); break;
	case WAKE_FORCE: must(cn_body_apply_force(world, box, 0.1f, 0.0f), world, "force"); break;
	case WAKE_TORQUE: must(cn_body_apply_torque(world, box, 0.1f), world, "torque"); break;
	case WAKE_VELOCITY: fixture_set_velocity(world, box, 0.1f, 0.0f, 0.0f); break;
	case WAKE_WRITE: must(cn_world_write_velocities(world, &box, 1, &velocity), world, "write"); break;
	case WAKE_CALL: must(cn_body_set_awake(world, box, 1), world, "awake"); break;
	case WAKE_SUPPORT: must(cn_body_destroy(world, support), world, "destroy"); break;
	case WAKE_MATERIAL: must(cn_shape_set_material(world, fixture_first_shape(world, box), &material), world, "material"); break;
	case WAKE_DENSITY: must(cn_shape_set_density(world, fixture_first_shape(world, box), 3.0f), world, "density"); break;
	case WAKE_GRAVITY: must(cn_world_set_gravity(world, 0.0f, -9.0f), world, "gravity"); break;
	case WAKE_SCALE: must(cn_body_set_gravity_scale(world, box, 0.5f), world, "scale"); break;
	case WAKE_TELEPORT: must(cn_body_set_pose(world, box, 0.0f, 4.0f, 0.0f), world, "teleport"); break;
	case WAKE_TYPE: must(cn_body_set_type(world, box, CN_BODY_KINEMATIC), world, "type"); break;
	case WAKE_GROUND_TYPE: must(cn_body_set_type(world, ground, CN_BODY_KINEMATIC), world, "type"); break;
	case WAKE_GROUND_GONE: must(cn_body_destroy(world, ground), world, "destroy"); break;
	case WAKE_GROUND_OFF: must(cn_body_set_flags(world, ground, 0), world, "disable"); break;
	case WAKE_GROUND_SHAPE: must(cn_shape_destroy(world, fixture_first_shape(world, ground)), world, "destroy shape"); break;
	case WAKE_GROUND_MATERIAL: must(cn_shape_set_material(world, fixture_first_shape(world, ground), &material), world, "material"); break;
	case WAKE_GROUND_FILTER: must(cn_shape_set_filter(world, fixture_first_shape(world, ground), &none), world, "filter"); break;
	case WAKE_GROUND_MOVES: must(cn_body_set_pose(world, ground, 0.0f, -2.0f, 0.0f), world, "teleport"); break;
	case WAKE_NO_SLEEP: must(cn_body_set_flags(world, box, CN_BODY_ENABLED), world, "flags"); break;
	case WAKE_WORLD: must(cn_world_set_flags(world, CN_WORLD_WARM_START), world, "flags"); break;
	case WAKE_MASS: must(cn_body_set_mass_data(world, box, &mass), world, "mass"); break;
	case WAKE_LOCK: must(cn_body_set_flags(world, box, CN_BODY_ENABLED | CN_BODY_SLEEP | CN_BODY_LOCK_X), world, "flags"); break;
	default:
		def = fixture_shape_def(box, 0.6f, 0.0f);
		def.offset_m.x = 1.0f;
		fixture_box_shape(world, &def, 0.2f, 0.2f);
	}
}

static void all_that_should_wakes(void)
{
	int32_t way;
	for (way = 0; way < WAKES; ++way) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body ground = fixture_floor(world, 0.6f, 0.0f), support = unit_box(world, 0.0f, 0.5f), box = unit_box(world, 0.0f, 1.5f);
		cn_body far = unit_box(world, 20.0f, 0.5f);
		int32_t own = cn_body_is_valid(world, support), everything = way == WAKE_GRAVITY || way == WAKE_WORLD || (way >= WAKE_GROUND_TYPE && way <= WAKE_GROUND_MOVES);
		fixture_step(world, 120);
		REQUIRE(own && !fixture_is_awake(world, support) && !fixture_is_awake(world, box) && !fixture_is_awake(world, far));
		wake_by(world, way, ground, support, box);
		if (!fixture_is_awake(world, box) || (cn_body_is_valid(world, support) && !fixture_is_awake(world, support)) || fixture_is_awake(world, far) != everything) {
			printf("  %s: box %d, support %d, a body elsewhere %d\n", wake_names[way], (int)fixture_is_awake(world, box),
			       cn_body_is_valid(world, support) ? (int)fixture_is_awake(world, support) : -1, (int)fixture_is_awake(world, far));
			CHECK(0);
		}
		CHECK(fixture_is_valid(world));
		fixture_step(world, 2);
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* Calls that set what is set already, or zero velocity, do not wake. */
static void what_changes_nothing_does_not_wake(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body box;
	fixture_floor(world, 0.6f, 0.0f);
	box = unit_box(world, 0.0f, 0.5f);
	fixture_step(world, 120);
	must(cn_world_set_gravity(world, 0.0f, -10.0f), world, "gravity");
	must(cn_body_set_velocity(world, box, 0.0f, 0.0f, 0.0f), world, "velocity");
	must(cn_body_set_gravity_scale(world, box, 1.0f), world, "scale");
	must(cn_body_set_type(world, box, CN_BODY_DYNAMIC), world, "type");
	must(cn_body_set_user_data(world, box, 7), world, "user data");
	CHECK(!fixture_is_awake(world, box));
	cn_world_destroy(world);
}

static void a_moving_platform_wakes_what_stands_on_it(void)
{
	int32_t near;
	for (near = 0; near < 2; ++near) { /* 1: it stands beside and is run into */
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body platform = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, near ? 0.5f : -0.5f, 0.0f, 2.0f, 0.5f, 0.6f, 0.0f), box;
		int32_t k, asleep = 0;
		if (near)
			fixture_floor(world, 0.6f, 0.0f);
		box = unit_box(world, near ? 3.0f : 0.0f, 0.5f);
		fixture_step(world, 120);
		CHECK(!fixture_is_awake(world, box) && !fixture_is_awake(world, platform));
		fixture_set_velocity(world, platform, 0.5f, 0.0f, 0.0f);
		for (k = 0; k < 240; ++k) {
			fixture_step(world, 1);
			asleep += k > 70 && !fixture_is_awake(world, box);
		}
		CHECK_LE("steps in which the passenger slept", asleep, 0, "");
		CHECK_LE("error of the passenger's way", fabs((double)fixture_pose(world, box).position_m.x - (near ? 4.5 : 2.0)), 0.03, "m");
		fixture_set_velocity(world, platform, 0.0f, 0.0f, 0.0f);
		fixture_step(world, 120);
		CHECK(!fixture_is_awake(world, box) && !fixture_is_awake(world, platform));
		cn_world_destroy(world);
	}
}

/* Slow enough that the passengers' speed alone would let them sleep. */
static void a_turning_platform_keeps_its_passengers_awake(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body platform = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, -0.5f, 0.0f, 2.0f, 0.5f, 0.6f, 0.0f);
	cn_body box = unit_box(world, 0.0f, 0.5f), top = unit_box(world, 0.0f, 1.5f);
	int32_t k, asleep = 0;
	fixture_set_velocity(world, platform, 0.0f, 0.0f, 0.01f);
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		asleep += !fixture_is_awake(world, box) || !fixture_is_awake(world, top);
	}
	CHECK_LE("steps asleep", asleep, 0, "");
	CHECK_LE("error of the passenger's angle", fabs((double)fixture_pose(world, top).sine - sin(0.1)), 2.0 * SOLVED, "");
	cn_world_destroy(world);
}

/* What was added to a sleeping pair by filter or by moving the ground begins in the next step. */
static void ground_that_comes_to_sleepers_wakes_them(void)
{
	int32_t way;
	for (way = 0; way < 4; ++way) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body ground = fixture_floor(world, 0.6f, 0.0f), box, wall;
		cn_filter all = { 1, ~(uint64_t)0, 0, 0 }, none = { 1, 0, 0, 0 };
		const cn_contact_event *events;
		int32_t count, k, entered = 0;
		(void)ground;
		box = unit_box(world, 0.0f, 0.5f);
		wall = fixture_box(world, CN_BODY_STATIC, way == 0 ? 10.0f : 0.7f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		if (way == 1 || way == 2)
			must(cn_shape_set_filter(world, fixture_first_shape(world, wall), &none), world, "filter");
		if (way == 3)
			must(cn_body_set_flags(world, wall, 0), world, "disable");
		fixture_step(world, 120);
		REQUIRE(!fixture_is_awake(world, box));
		if (way == 0)
			must(cn_body_set_pose(world, wall, 0.7f, 0.5f, 0.0f), world, "teleport");
		else if (way == 1)
			must(cn_shape_set_filter(world, fixture_first_shape(world, wall), &all), world, "filter");
		else if (way == 3)
			must(cn_body_set_flags(world, wall, CN_BODY_ENABLED), world, "enable");
		else { /* the sleeper's filter: it ignores the wall until both allow */
			must(cn_shape_set_filter(world, fixture_first_shape(world, wall), &all), world, "filter");
			must(cn_shape_set_filter(world, fixture_first_shape(world, box), &all), world, "filter");
		}
		for (k = 0; k < 2; ++k) {
			fixture_step(world, 1);
			must(cn_world_contact_events(world, CN_EVENT_ENTER, &events, &count), world, "events");
			entered += count;
		}
		printf("  way %d\n", (int)way);
		CHECK_GE("pairs that entered within 2 steps", entered, 1, "");
		fixture_step(world, 120);
		CHECK_LE("place of the box after it was pushed out", fixture_pose(world, box).position_m.x, -0.29, "m");
		cn_world_destroy(world);
	}
}

/* ---- by call ---- */

static void set_awake_0_takes_only_what_is_connected(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body a, b, c;
	fixture_floor(world, 0.0f, 0.0f);
	a = unit_box(world, 0.0f, 0.5f);
	b = unit_box(world, 1.01f, 0.5f);
	c = unit_box(world, 0.0f, 1.5f);
	fixture_step(world, 5);
	fixture_set_velocity(world, b, 5.0f, 0.0f, 0.0f); /* leaves the others */
	fixture_step(world, 10);
	must(cn_body_set_awake(world, a, 0), world, "cn_body_set_awake");
	CHECK(!fixture_is_awake(world, a) && !fixture_is_awake(world, c));
	CHECK(fixture_is_awake(world, b));
	CHECK(fell_asleep_count(world, a) == 1 && fell_asleep_count(world, b) == 0);
	CHECK(fixture_is_valid(world));
	fixture_step(world, 60);
	CHECK_LE("error of the way of the one that went on", fabs((double)fixture_pose(world, b).position_m.x - (1.01 + 5.0 * 70.0 / 60.0)), ROUNDING, "m");
	CHECK(!fixture_is_awake(world, a));
	cn_world_destroy(world);
}

/* Put to sleep in the air it stays there, at rest. */
static void set_awake_0_holds_a_flying_body(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body box = unit_box(world, 0.0f, 10.0f);
	float y;
	fixture_step(world, 10);
	must(cn_body_set_awake(world, box, 0), world, "cn_body_set_awake");
	y = fixture_pose(world, box).position_m.y;
	fixture_step(world, 60);
	CHECK(fixture_pose(world, box).position_m.y == y && fixture_velocity(world, box).linear_mps.y == 0.0f);
	must(cn_body_set_awake(world, box, 1), world, "cn_body_set_awake");
	fixture_step(world, 60);
	CHECK_LE("error of the fall afterwards", fabs((double)(y - fixture_pose(world, box).position_m.y) - 5.0), ROUNDING, "m");
	cn_world_destroy(world);
}

/* In some step the boxes of a ball and of the wall behind it come apart as the step ends. A ball that is put to sleep then keeps
   their contact, and the wall that comes up finds it. */
static void a_wall_comes_up_to_one_put_to_sleep(void)
{
	static const float speeds[] = { 1.0f, 4.0f, 17.0f };
	int32_t run, repeats = 0, met = 0;
	for (run = 0; run < 180; ++run) {
		cn_world *world = fixture_world(0.0f, 1);
		cn_body wall = fixture_box(world, CN_BODY_KINEMATIC, -0.6f, 0.0f, 0.0f, 0.1f, 1.0f, 0.6f, 0.0f);
		cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.0f);
		cn_contact_event contacts[4];
		int32_t k, count = 0;
		fixture_set_velocity(world, wall, speeds[run / 60], 0.0f, 0.0f);
		fixture_set_velocity(world, ball, 3.0f * speeds[run / 60], 0.0f, 0.0f);
		fixture_step(world, 1 + run % 60);
		must(cn_body_set_awake(world, ball, 0), world, "cn_body_set_awake");
		for (k = 0; k < 60; ++k) {
			fixture_step(world, 1);
			must(cn_body_get_contacts(world, ball, contacts, 4, &count), world, "cn_body_get_contacts");
			repeats += count > 1;
			met += count == 1;
		}
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
	printf("  %d steps with a contact, %d with several\n", (int)met, (int)repeats);
	CHECK(repeats == 0 && met > 100);
}

/* A sensor, an area, or a wall that a sleeping box has come to overlap. */
static void static_shapes_made_over_sleepers_wake_them(void)
{
	int32_t kind;
	for (kind = 0; kind < 3; ++kind) {
		cn_world *world = fixture_world(-10.0f, 1);
		cn_body box = (fixture_floor(world, 0.6f, 0.0f), fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f)), post;
		cn_shape_def def;
		cn_shape shape, visitor = 0;
		cn_area_def area;
		int32_t count = 0;
		fixture_step(world, 120);
		CHECK(!fixture_is_awake(world, box));
		post = fixture_body(world, CN_BODY_STATIC, kind == 2 ? 0.9f : 0.0f, 0.6f, 0.0f);
		def = fixture_shape_def(post, 0.6f, 0.0f);
		def.flags = kind < 2 ? CN_SHAPE_SENSOR : 0;
		shape = fixture_box_shape(world, &def, 0.5f, 0.5f);
		CHECK(fixture_is_awake(world, box));
		cn_area_def_init(&area);
		area.gravity_mps2.y = 20.0f;
		if (kind == 1)
			must(cn_shape_set_area(world, shape, &area), world, "cn_shape_set_area");
		fixture_step(world, 10);
		if (kind == 0)
			must(cn_shape_get_visitors(world, shape, &visitor, 1, &count), world, "cn_shape_get_visitors");
		CHECK(kind != 0 || (count == 1 && visitor == fixture_first_shape(world, box)));
		CHECK(kind != 1 || fixture_pose(world, box).position_m.y > 0.55f);
		CHECK(kind != 2 || fixture_pose(world, box).position_m.x < -0.05f);
		cn_world_destroy(world);
	}
}

static void bodies_made_asleep_wait(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body_def def;
	cn_body box, ball;
	cn_shape_def shape;
	cn_body_def_init(&def);
	fixture_floor(world, 0.6f, 0.0f);
	def.flags = CN_BODY_ENABLED | CN_BODY_SLEEP;
	def.position_m.y = 0.5f;
	must(cn_body_create(world, &def, &box), world, "cn_body_create");
	shape = fixture_shape_def(box, 0.6f, 0.0f);
	fixture_box_shape(world, &shape, 0.5f, 0.5f);
	CHECK(!fixture_is_awake(world, box));
	fixture_step(world, 30);
	CHECK(!fixture_is_awake(world, box));
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 2.0f, 0.3f, 0.6f, 0.0f);
	fixture_step(world, 60);
	CHECK(fixture_is_awake(world, box) || fixture_is_awake(world, ball) == 0);
	CHECK_GE("the ball lies on the box at", fixture_pose(world, ball).position_m.y, 1.29, "m");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(all_that_should_wakes);
	RUN(what_changes_nothing_does_not_wake);
	RUN(a_moving_platform_wakes_what_stands_on_it);
	RUN(a_turning_platform_keeps_its_passengers_awake);
	RUN(ground_that_comes_to_sleepers_wakes_them);
	RUN(set_awake_0_takes_only_what_is_connected);
	RUN(set_awake_0_holds_a_flying_body);
	RUN(a_wall_comes_up_to_one_put_to_sleep);
	RUN(static_shapes_made_over_sleepers_wake_them);
	RUN(bodies_made_asleep_wait);
	return test_end();
}
