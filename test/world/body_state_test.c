/*
 * test/world/body_state_test.c - types and locks of bodies, and what is disabled.
 *
 * If a test here fails, look first in: world/body_state.c, model/body.c (records), step/integrate.c (locks),
 * model/contact_lane.c and contacts/contact_solve.c (locked bodies in contact).
 */
#include "bodies.h"

/* ---- types ---- */

static void each_type_moves_as_it_should(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body fixed = box_at(world, CN_BODY_STATIC, 0.0f, 0.0f), moving = box_at(world, CN_BODY_KINEMATIC, 5.0f, 0.0f), falling = box_at(world, CN_BODY_DYNAMIC, 10.0f, 0.0f);
	CHECK(cn_body_set_velocity(world, fixed, 1.0f, 0.0f, 0.0f) == CN_ERROR_STATE);
	fixture_set_velocity(world, moving, 1.0f, 0.5f, 0.25f);
	must(cn_body_apply_force(world, moving, 100.0f, 0.0f), world, "force");
	must(cn_body_apply_impulse(world, fixed, 100.0f, 0.0f), world, "impulse");
	fixture_step(world, 120);
	CHECK(fixture_pose(world, fixed).position_m.y == 0.0f && fixture_pose(world, fixed).position_m.x == 0.0f);
	CHECK_LE("error of a kinematic body's place after 2 s", hypot((double)fixture_pose(world, moving).position_m.x - 7.0, (double)fixture_pose(world, moving).position_m.y - 1.0), 1e-5, "m");
	CHECK_LE("error of its angle", fabs(asin((double)fixture_pose(world, moving).sine) - 0.5), 1e-5, "rad");
	CHECK_LE("error of a falling body's place", fabs((double)fixture_pose(world, falling).position_m.y + 20.0), 1e-4, "m");
	CHECK(mass_of(world, fixed).mass_kg == 0.0f && mass_of(world, moving).mass_kg == 0.0f && fabsf(mass_of(world, falling).mass_kg - 1.0f) < 1e-6f);
	cn_world_destroy(world);
}

/* A kinematic body pushes, and is not pushed back. */
static void kinematic_bodies_are_not_pushed(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body ram = box_at(world, CN_BODY_KINEMATIC, 0.0f, 0.0f), box = box_at(world, CN_BODY_DYNAMIC, 2.0f, 0.0f);
	fixture_set_velocity(world, ram, 2.0f, 0.0f, 0.0f);
	must(cn_body_set_damping(world, ram, 1.0f, 1.0f), world, "cn_body_set_damping"); /* of a kinematic body: none */
	fixture_step(world, 120);
	CHECK_LE("error of the ram's place", fabs((double)fixture_pose(world, ram).position_m.x - 4.0), 1e-5, "m");
	CHECK_GE("place of the pushed box", fixture_pose(world, box).position_m.x, 4.99, "m");
	CHECK_LE("error of its speed", fabs((double)fixture_velocity(world, box).linear_mps.x - 2.0), ROUNDING, "m/s");
	cn_world_destroy(world);
}

/* A box on the ground with one on top, jointed to a third, changes type while awake or asleep. */
static void change_run(int32_t from, int32_t to, int32_t asleep, int32_t jointed)
{
	cn_world *world = fixture_world(-10.0f, asleep);
	cn_body box, top, other;
	cn_joint joint = 0;
	float y;
	fixture_floor(world, 0.6f, 0.0f);
	box = box_at(world, from, 0.0f, 0.5f);
	top = box_at(world, CN_BODY_DYNAMIC, 0.0f, 1.5f);
	other = box_at(world, CN_BODY_DYNAMIC, 1.0f, 0.5f);
	if (jointed)
		joint = hinge(world, box, at(0.5f, 0.0f), other, at(-0.5f, 0.0f));
	fixture_step(world, 120);
	must(cn_body_set_type(world, box, to), world, "cn_body_set_type");
	CHECK(fixture_is_valid(world));
	CHECK(type_of(world, box) == to && fixture_is_awake(world, top));
	CHECK(fixture_is_awake(world, box) == (to != CN_BODY_STATIC));
	CHECK((mass_of(world, box).mass_kg > 0.0f) == (to == CN_BODY_DYNAMIC));
	CHECK(fixture_velocity(world, box).linear_mps.x == 0.0f || to != CN_BODY_STATIC);
	fixture_step(world, 120);
	CHECK(fixture_is_valid(world));
	y = fixture_pose(world, top).position_m.y; /* it still stands on it */
	if (fabsf(y - 1.5f) > 0.01f || fabsf(fixture_pose(world, box).position_m.y - 0.5f) > 0.01f || (jointed && !cn_joint_is_valid(world, joint))) {
		printf("  %d to %d, asleep %d, jointed %d: top at %.4f, box at %.4f\n", (int)from, (int)to, (int)asleep, (int)jointed, (double)y, (double)fixture_pose(world, box).position_m.y);
		CHECK(0);
	}
	/* What it has become shows when it is pushed. */
	must(cn_body_apply_impulse(world, box, 0.0f, 8.0f), world, "impulse");
	fixture_step(world, 1);
	CHECK((fixture_velocity(world, box).linear_mps.y > 0.5f) == (to == CN_BODY_DYNAMIC));
	if (jointed) {
		must(cn_joint_destroy(world, joint), world, "cn_joint_destroy");
		CHECK(fixture_is_valid(world));
	}
	cn_world_destroy(world);
}

static void all_six_changes_of_type_work(void)
{
	int32_t from, to, asleep, jointed;
	for (from = 0; from < 3; ++from)
		for (to = 0; to < 3; ++to)
			for (asleep = 0; asleep < 2; ++asleep)
				for (jointed = 0; jointed < 2; ++jointed)
					if (from != to)
						change_run(from, to, asleep, jointed);
}

static void a_type_may_not_leave_a_joint_without_a_dynamic_body(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body a = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f), b = box_at(world, CN_BODY_DYNAMIC, 1.0f, 0.0f);
	cn_distance_def rod;
	cn_joint joint;
	uint64_t hash;
	cn_distance_def_init(&rod);
	rod.base.body_a = a;
	rod.base.body_b = b;
	must(cn_joint_create_distance(world, &rod, &joint), world, "joint");
	must(cn_body_set_type(world, a, CN_BODY_STATIC), world, "type");
	hash = fixture_hash(world);
	CHECK(cn_body_set_type(world, b, CN_BODY_KINEMATIC) == CN_ERROR_STATE);
	CHECK(cn_body_set_type(world, b, CN_BODY_STATIC) == CN_ERROR_STATE);
	CHECK(type_of(world, b) == CN_BODY_DYNAMIC && fixture_hash(world) == hash && fixture_is_valid(world));
	must(cn_joint_destroy(world, joint), world, "destroy");
	CHECK(cn_body_set_type(world, b, CN_BODY_STATIC) == CN_OK);
	cn_world_destroy(world);
}

/* ---- locks ---- */

static void locked_axes_keep_their_place(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body x_locked = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f), y_locked = box_at(world, CN_BODY_DYNAMIC, 5.0f, 0.0f), turn_locked = box_at(world, CN_BODY_DYNAMIC, 10.0f, 0.0f);
	set_flags(world, x_locked, CN_BODY_LOCK_X);
	set_flags(world, y_locked, CN_BODY_LOCK_Y);
	set_flags(world, turn_locked, CN_BODY_LOCK_ROTATION);
	fixture_set_velocity(world, x_locked, 3.0f, 0.0f, 1.0f);
	fixture_set_velocity(world, y_locked, 3.0f, 1.0f, 1.0f);
	fixture_set_velocity(world, turn_locked, 0.0f, 0.0f, 1.0f);
	must(cn_body_apply_torque(world, turn_locked, 10.0f), world, "torque");
	must(cn_body_apply_angular_impulse(world, turn_locked, 10.0f), world, "angular impulse");
	must(cn_body_apply_force(world, x_locked, 50.0f, 0.0f), world, "force");
	fixture_step(world, 60);
	CHECK_LE("change of the locked x", fabs((double)fixture_pose(world, x_locked).position_m.x), 0.0, "m");
	CHECK_LE("error of the free y", fabs((double)fixture_pose(world, x_locked).position_m.y + 5.0), ROUNDING, "m");
	CHECK_LE("change of the locked y", fabs((double)fixture_pose(world, y_locked).position_m.y), 0.0, "m");
	CHECK_LE("error of the free x", fabs((double)fixture_pose(world, y_locked).position_m.x - 8.0), ROUNDING, "m");
	CHECK_LE("change of the locked angle", fabs((double)fixture_pose(world, turn_locked).sine), 0.0, "");
	CHECK_LE("error of the free angle", fabs(asin((double)fixture_pose(world, x_locked).sine) - 1.0), ROUNDING, "rad");
	cn_world_destroy(world);
}

/* A ball rolls into one, and a weld carries the other. */
static void every_solver_keeps_locked_axes(int32_t solver)
{
	cn_world *world;
	cn_world_def def;
	cn_body x_locked, y_locked, load;
	cn_fixed_def weld;
	cn_joint joint;
	cn_world_def_init(&def);
	def.solver = solver;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.6f, 0.0f);
	x_locked = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.5f);
	y_locked = box_at(world, CN_BODY_DYNAMIC, 0.0f, 8.0f);
	load = box_at(world, CN_BODY_DYNAMIC, 2.0f, 8.0f);
	set_flags(world, x_locked, CN_BODY_LOCK_X);
	set_flags(world, y_locked, CN_BODY_LOCK_Y);
	cn_fixed_def_init(&weld);
	weld.base.body_a = y_locked;
	weld.base.body_b = load;
	weld.base.anchor_a_m.x = 2.0f;
	must(cn_joint_create_fixed(world, &weld, &joint), world, "cn_joint_create_fixed");
	fixture_set_velocity(world, fixture_circle(world, CN_BODY_DYNAMIC, -4.0f, 0.5f, 0.5f, 0.6f, 0.0f), 5.0f, 0.0f, 0.0f);
	fixture_step(world, 120);
	CHECK_LE("change of the locked x", fabs((double)fixture_pose(world, x_locked).position_m.x), ROUNDING, "m");
	CHECK_LE("change of the locked y", fabs((double)fixture_pose(world, y_locked).position_m.y - 8.0), ROUNDING, "m");
	cn_world_destroy(world);
}

static void locked_axes_hold_with_every_solver(void)
{
	int32_t solver;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SEQUENTIAL; ++solver)
		every_solver_keeps_locked_axes(solver);
}

/* A body that does not turn, and a rod to another that is thrown: of 200, those that turn after all. */
static void locked_rotation_holds_in_swings(void)
{
	uint32_t seed = 11;
	int32_t run, turned = 0;
	for (run = 0; run < 200; ++run) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body locked = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f, 0.3f, 0.8f, 0.6f, 0.0f);
		cn_body thrown = fixture_box(world, CN_BODY_DYNAMIC, 1.2f, fixture_random(&seed, -0.3f, 1.0f), 0.0f, fixture_random(&seed, 0.1f, 0.6f), fixture_random(&seed, 0.05f, 0.3f), 0.6f, 0.0f);
		cn_distance_def rod;
		cn_joint joint;
		set_flags(world, locked, CN_BODY_LOCK_ROTATION);
		cn_distance_def_init(&rod);
		rod.base.body_a = locked;
		rod.base.body_b = thrown;
		rod.base.anchor_a_m.y = 0.5f;
		rod.base.anchor_b_m.x = fixture_random(&seed, -0.5f, 0.5f);
		rod.length_m = (float)hypot(1.2 + (double)rod.base.anchor_b_m.x, (double)fixture_pose(world, thrown).position_m.y - 0.5);
		must(cn_joint_create_distance(world, &rod, &joint), world, "cn_joint_create_distance");
		fixture_set_velocity(world, thrown, fixture_random(&seed, -8.0f, 8.0f), fixture_random(&seed, 0.0f, 8.0f), fixture_random(&seed, -8.0f, 8.0f));
		fixture_step(world, 300);
		turned += fixture_pose(world, locked).sine != 0.0f;
		cn_world_destroy(world);
	}
	CHECK(turned == 0);
}

typedef struct bounce {
	double deepest, speed_error, moved, energy; /* how far the ball went in, its final speed, the box, energy / start */
} bounce;

/* A ball of some mass hits a box of 1 kg from its side at 5 m/s. */
static bounce ball_hits_locked_box(float mass_kg, uint32_t locks, float e)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body box = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f), ball = fixture_circle(world, CN_BODY_DYNAMIC, -2.0f, 0.0f, 0.25f, 0.0f, e);
	cn_mass_data mass = mass_of(world, ball);
	bounce b = { 0.0, 0.0, 0.0, 0.0 };
	double back;
	int32_t k;
	mass.inertia_kgm2 *= mass_kg / mass.mass_kg;
	mass.mass_kg = mass_kg;
	must(cn_body_set_mass_data(world, ball, &mass), world, "mass");
	set_flags(world, box, locks);
	fixture_set_velocity(world, ball, 5.0f, 0.0f, 0.0f);
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		b.deepest = greater(b.deepest, (double)fixture_pose(world, ball).position_m.x + 0.75);
	}
	back = -(double)fixture_velocity(world, ball).linear_mps.x;
	b.speed_error = fabs(back - 5.0 * (double)e);
	b.moved = fabs((double)fixture_pose(world, box).position_m.x);
	if (locks & CN_BODY_LOCK_Y)
		b.moved = greater(b.moved, fabs((double)fixture_pose(world, box).position_m.y));
	b.energy = back * back / 25.0;
	cn_world_destroy(world);
	return b;
}

/* The worst over balls of 10 g to 100 kg, with and without bounce. */
static bounce locked_box_worst(uint32_t locks)
{
	static const float masses[] = { 0.01f, 1.0f, 100.0f };
	bounce worst = { 0.0, 0.0, 0.0, 0.0 };
	size_t m;
	int32_t e;
	for (m = 0; m < 3; ++m)
		for (e = 0; e < 2; ++e) {
			bounce b = ball_hits_locked_box(masses[m], locks, (float)e);
			worst.deepest = greater(worst.deepest, b.deepest);
			worst.speed_error = greater(worst.speed_error, b.speed_error);
			worst.moved = greater(worst.moved, b.moved);
			worst.energy = greater(worst.energy, b.energy);
		}
	return worst;
}

static void both_locks_are_infinite_mass(void)
{
	int32_t turn;
	for (turn = 0; turn < 2; ++turn) {
		bounce b = locked_box_worst(CN_BODY_LOCK_X | CN_BODY_LOCK_Y | (turn ? (uint32_t)CN_BODY_LOCK_ROTATION : 0u));
		CHECK_LE("change of the locked place", b.moved, 0.0, "m");
		CHECK_LE("how deep the ball went", b.deepest, 1e-4, "m");
		CHECK_LE("error of its speed afterwards", b.speed_error, ROUNDING, "m/s");
		CHECK_LE("energy / start", b.energy, 1.0001, "");
	}
}

/* What may move along x alone lies on a lift that is tilted by less than a thousandth: to keep out of its way it would have to leave
   at 4 km/s. */
static void what_is_pushed_across_its_free_axis_stays(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body lift = fixture_box(world, CN_BODY_KINEMATIC, 0.0f, -0.5f, 4e-4f, 5.0f, 0.5f, 0.0f, 0.7f), box = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.5f);
	double fastest = 0.0;
	int32_t k;
	set_flags(world, box, CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION);
	fixture_set_velocity(world, lift, 0.0f, 2.0f, 0.0f);
	for (k = 0; k < 30; ++k) {
		fixture_step(world, 1);
		fastest = greater(fastest, fabs((double)fixture_velocity(world, box).linear_mps.x));
	}
	CHECK_LE("speed of the box", fastest, 1e-3, "m/s");
	cn_world_destroy(world);
}

static void a_locked_axis_keeps_its_place_when_hit(void)
{
	int32_t turn;
	for (turn = 0; turn < 2; ++turn) {
		bounce b = locked_box_worst(CN_BODY_LOCK_X | (turn ? (uint32_t)CN_BODY_LOCK_ROTATION : 0u));
		CHECK_LE("change of the locked x", b.moved, 0.0, "m");
		CHECK_LE("energy / start", b.energy, 1.0001, "");
	}
}

static void a_locked_axis_is_a_wall(void)
{
	bounce b = locked_box_worst(CN_BODY_LOCK_X | CN_BODY_LOCK_ROTATION);
	CHECK_LE("how deep the ball went", b.deepest, 1e-4, "m");
	CHECK_LE("error of its speed afterwards", b.speed_error, ROUNDING, "m/s");
}

/* A box locked in the air carries another; a tall thin one whose rotation is locked is not pushed over. */
static void locked_bodies_rest_and_carry(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body lift = box_at(world, CN_BODY_DYNAMIC, 0.0f, 5.0f), load = box_at(world, CN_BODY_DYNAMIC, 0.0f, 6.0f), tall;
	fixture_floor(world, 0.6f, 0.0f);
	set_flags(world, lift, CN_BODY_LOCK_X | CN_BODY_LOCK_Y);
	tall = fixture_box(world, CN_BODY_DYNAMIC, 10.0f, 2.0f, 0.0f, 0.2f, 2.0f, 0.6f, 0.0f);
	set_flags(world, tall, CN_BODY_LOCK_ROTATION);
	must(cn_body_apply_impulse_at(world, tall, 1.0f, 0.0f, 10.0f, 4.0f), world, "impulse");
	fixture_step(world, 300);
	CHECK(fixture_pose(world, lift).position_m.y == 5.0f && fixture_pose(world, tall).sine == 0.0f);
	CHECK_LE("sinking of the load", fabs((double)fixture_pose(world, load).position_m.y - 6.0), 0.006, "m");
	CHECK_LE("sinking of the tall one", fabs((double)fixture_pose(world, tall).position_m.y - 2.0), SAG_M, "m");
	CHECK(!fixture_is_awake(world, load) && !fixture_is_awake(world, tall));
	set_flags(world, lift, 0);
	fixture_step(world, 120);
	CHECK_LE("height of the lift when it is let go", fabs((double)fixture_pose(world, lift).position_m.y - 0.5), 1e-4, "m");
	cn_world_destroy(world);
}

/* ---- disabled ---- */

static void disabled_bodies_take_no_part(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body ball, box;
	uint32_t flags;
	fixture_floor(world, 0.6f, 0.0f);
	box = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.5f);
	must(cn_body_set_flags(world, box, CN_BODY_SLEEP), world, "flags");
	must(cn_body_get_flags(world, box, &flags), world, "flags");
	CHECK(!(flags & (CN_BODY_ENABLED | CN_BODY_AWAKE)));
	must(cn_body_apply_impulse(world, box, 1.0f, 1.0f), world, "impulse");
	must(cn_body_set_awake(world, box, 1), world, "awake");
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 3.0f, 0.3f, 0.6f, 0.0f);
	fixture_step(world, 120);
	CHECK(fixture_pose(world, box).position_m.y == 0.5f && fixture_pose(world, box).position_m.x == 0.0f);
	CHECK_LE("height of the ball that fell through it", fixture_pose(world, ball).position_m.y, 0.301, "m");
	must(cn_body_set_flags(world, box, CN_BODY_SLEEP | CN_BODY_ENABLED), world, "flags");
	CHECK(fixture_is_awake(world, box));
	fixture_step(world, 120);
	CHECK(fixture_penetration(world, &ball, 1) < 0.006f);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(each_type_moves_as_it_should);
	RUN(kinematic_bodies_are_not_pushed);
	RUN(all_six_changes_of_type_work);
	RUN(a_type_may_not_leave_a_joint_without_a_dynamic_body);
	RUN(locked_axes_keep_their_place);
	RUN(locked_axes_hold_with_every_solver);
	RUN(locked_rotation_holds_in_swings);
	RUN(both_locks_are_infinite_mass);
	RUN(a_locked_axis_keeps_its_place_when_hit);
	RUN(what_is_pushed_across_its_free_axis_stays);
	RUN(a_locked_axis_is_a_wall);
	RUN(locked_bodies_rest_and_carry);
	RUN(disabled_bodies_take_no_part);
	return test_end();
}
