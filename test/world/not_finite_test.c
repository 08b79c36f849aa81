/*
 * test/world/not_finite_test.c - whatever finite numbers go in, finite numbers come out, and the world stays valid: gravity and speeds near
 * the largest float, steps shorter than floats have inverses for.
 */
#include "model/world.h"

#include "joints.h"

#include <float.h>

#define BODIES 10
#define JOINTS 3
#define SEEDS TEST_MANY(30)

enum { HEAVY, HEAVIEST, FAST, KICKED, KINDS };
static const char *const kind_names[KINDS] = { "gravity up to 3e38", "gravity from 1e38", "speeds up to 1e38", "kicks up to 1e10 m/s" };

typedef struct scene_of {
	cn_world *world;
	cn_body bodies[BODIES];
	cn_joint joints[JOINTS];
	uint32_t random;
} scene_of;

static float draw(scene_of *s, float lower, float upper) { return fixture_random(&s->random, lower, upper); }

/* Of any order of magnitude. */
static float draw_large(scene_of *s, float exponent, float exponent_most)
{
	return (float)pow(10.0, (double)draw(s, exponent, exponent_most)) * draw(s, -1.0f, 1.0f);
}

static void scene_make(scene_of *s, int32_t solver, int32_t kind, uint32_t seed)
{
	cn_world_def def;
	int32_t k;
	memset(s, 0, sizeof *s);
	s->random = seed * 7919u + 1u;
	cn_world_def_init(&def);
	def.solver = solver;
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	if (kind == HEAVY || kind == HEAVIEST) {
		def.gravity_mps2.x = draw_large(s, 30.0f, 38.0f);
		def.gravity_mps2.y = -1e38f * draw(s, kind == HEAVY ? 1e-8f : 1.0f, 3.3f);
	} else {
		def.linear_speed_max_mps = kind == FAST ? 3e38f : 1e10f;
		def.angular_speed_max_radps = kind == FAST ? 3e38f : 1e5f;
	}
	must(cn_world_create(&def, &s->world), NULL, "cn_world_create");
	fixture_box(s->world, CN_BODY_STATIC, 0.0f, -3.0f, 0.3f, 0.8f, 0.6f, 0.6f, 0.5f);
	for (k = 0; k < BODIES; ++k)
		s->bodies[k] = k % 2 ? fixture_box(s->world, CN_BODY_DYNAMIC, draw(s, -3.0f, 3.0f), draw(s, 0.0f, 5.0f), draw(s, -3.0f, 3.0f), 0.5f, draw(s, 0.2f, 1.0f), 0.6f, draw(s, 0.0f, 1.0f))
		                     : fixture_circle(s->world, CN_BODY_DYNAMIC, draw(s, -3.0f, 3.0f), draw(s, 0.0f, 5.0f), draw(s, 0.2f, 1.0f), 0.6f, draw(s, 0.0f, 1.0f));
	for (k = 0; k < JOINTS; ++k)
		s->joints[k] = hinge(s->world, s->bodies[k], at(0.0f, 0.0f), s->bodies[k + 3], at(0.0f, 0.5f));
	for (k = 0; k < BODIES && kind == FAST; ++k)
		fixture_set_velocity(s->world, s->bodies[k], draw_large(s, 10.0f, 38.0f), draw_large(s, 10.0f, 38.0f), draw_large(s, 10.0f, 38.0f));
}

static void scene_kick(scene_of *s)
{
	int32_t k;
	for (k = 0; k < BODIES; ++k)
		fixture_set_velocity(s->world, s->bodies[k], draw_large(s, 3.0f, 10.0f), draw_large(s, 3.0f, 10.0f), draw_large(s, 0.0f, 10.0f));
}

static int32_t are_finite(const float *numbers, size_t count)
{
	size_t k;
	for (k = 0; k < count; ++k)
		if (!isfinite(numbers[k]))
			return 0;
	return 1;
}

#define ALL_FINITE(item) are_finite((const float *)(const void *)&(item), sizeof(item) / sizeof(float))

static int32_t body_is_finite(const cn_world *world, cn_body body)
{
	cn_pose pose = fixture_pose(world, body);
	cn_velocity v = fixture_velocity(world, body);
	cn_contact_event events[16];
	cn_vec2 there;
	int32_t count, k, good = ALL_FINITE(pose) && ALL_FINITE(v);
	must(cn_body_get_velocity_at(world, body, 1e6f, -1e6f, &there), world, "cn_body_get_velocity_at");
	must(cn_body_get_contacts(world, body, events, 16, &count), world, "cn_body_get_contacts");
	for (k = 0; k < count && k < 16; ++k)
		good &= isfinite(events[k].manifold.friction_impulse_Ns) && isfinite(events[k].manifold.points[0].normal_impulse_Ns) && isfinite(events[k].approach_speed_mps);
	return good && ALL_FINITE(there);
}

/* What it reports, and what it goes on from. */
static int32_t joint_is_finite(const cn_world *world, cn_joint joint)
{
	const cni_joint *record = cni_joint_at(world, cni_joint_find(world, joint, 0));
	cn_vec2 force = joint_force(world, joint);
	return ALL_FINITE(force) && ALL_FINITE(record->impulse) && isfinite(joint_torque(world, joint)) && isfinite(joint_error_m(world, joint)) && isfinite(joint_error_rad(world, joint)) &&
	       isfinite(joint_speed(world, joint)) && isfinite(joint_position(world, joint));
}

static int32_t scene_is_finite(const scene_of *s)
{
	int32_t k, good = 1;
	for (k = 0; k < BODIES; ++k)
		good &= body_is_finite(s->world, s->bodies[k]);
	for (k = 0; k < JOINTS; ++k)
		good &= joint_is_finite(s->world, s->joints[k]);
	return good;
}

static void t_absurd_forces_and_speeds(void)
{
	int32_t solver, kind, step;
	uint32_t seed;
	for (kind = 0; kind < KINDS; ++kind) {
		int32_t wrong = 0, invalid = 0;
		for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SEQUENTIAL; ++solver)
			for (seed = 0; seed < SEEDS; ++seed) {
				scene_of s;
				int32_t good = 1, valid = 1;
				scene_make(&s, solver, kind, seed);
				for (step = 0; step < 60 && good && valid; ++step) {
					if (kind == KICKED && step % 3 == 1)
						scene_kick(&s);
					fixture_step(s.world, 1);
					good = scene_is_finite(&s);
					valid = fixture_is_valid(s.world);
				}
				wrong += !good;
				invalid += !valid;
				cn_world_destroy(s.world);
			}
		printf("  %s:\n", kind_names[kind]);
		CHECK_LE("worlds with a number that is none", wrong, 0, "");
		CHECK_LE("worlds that are not valid", invalid, 0, "");
	}
}

/* After a step without any length to speak of the joint bears what it bore, and so it does after the next. */
static void t_steps_of_no_length(void)
{
	static const float lengths[] = { 1e-45f, 1e-39f, 1e-30f, 1e-15f, 9e-10f };
	int32_t solver, k;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_DIRECT; ++solver) {
		double worst = 0.0;
		for (k = 0; k < (int32_t)(sizeof lengths / sizeof *lengths); ++k) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body box = unit_box(world, 0.0f, 0.5f, 0.0f);
			cn_joint joint = hinge(world, 0, at(0.0f, 0.6f), box, at(0.0f, 0.0f));
			must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
			fixture_step(world, 60);
			must(cn_world_step(world, lengths[k]), world, "cn_world_step");
			worst = greater(worst, fabs((double)joint_force(world, joint).y - GRAVITY));
			fixture_step(world, 1);
			worst = greater(worst, fabs((double)joint_force(world, joint).y - GRAVITY));
			cn_world_destroy(world);
		}
		CHECK_LE("force of a joint that bears 10 N, error", worst, 0.01, "N");
	}
}

/* Beside a body that is awake and touches it. */
static void t_what_is_made_asleep_does_not_move(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body_def def;
	cn_shape_def shape;
	cn_body asleep = 0;
	cn_velocity v;
	fixture_floor(world, 0.6f, 0.0f);
	cn_body_def_init(&def);
	def.flags &= ~(uint32_t)CN_BODY_AWAKE;
	def.position_m.y = 0.5f;
	def.linear_velocity_mps.x = 3.0f;
	def.angular_velocity_radps = 2.0f;
	must(cn_body_create(world, &def, &asleep), world, "cn_body_create");
	shape = fixture_shape_def(asleep, 0.6f, 0.0f);
	fixture_box_shape(world, &shape, 0.5f, 0.5f);
	v = fixture_velocity(world, asleep);
	CHECK(!fixture_is_awake(world, asleep) && v.linear_mps.x == 0.0f && v.angular_radps == 0.0f);
	unit_box(world, 0.0f, 1.7f, 0.0f);
	fixture_step(world, 60);
	CHECK_LE("moved", fabs((double)fixture_pose(world, asleep).position_m.x), 1e-3, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* Gravity times its scale overflows; areas with the greatest numbers of all kinds. */
static void t_fields_that_overflow(void)
{
	int32_t solver, kind, wrong = 0;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SEQUENTIAL; ++solver)
		for (kind = 0; kind < 4; ++kind) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body body = unit_box(world, 0.0f, 1.0f, 0.3f);
			cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
			cn_area_def area;
			cn_shape sensor;
			fixture_floor(world, 0.6f, 0.0f);
			must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
			def.flags = CN_SHAPE_SENSOR;
			sensor = fixture_box_shape(world, &def, 10.0f, 1.2f);
			cn_area_def_init(&area);
			if (kind == 0)
				must(cn_body_set_gravity_scale(world, body, FLT_MAX), world, "cn_body_set_gravity_scale");
			if (kind & 1)
				area.gravity_mps2.y = area.pull_mps2 = FLT_MAX;
			if (kind & 2) {
				area.linear_damping_per_s = area.angular_damping_per_s = area.density_kgpm2 = area.drag_kgpm2 = area.lift_kgpm2 = 1e9f;
				area.flow_mps.x = FLT_MAX;
			}
			must(cn_shape_set_area(world, sensor, &area), world, "cn_shape_set_area");
			fixture_step(world, 60);
			wrong += !fixture_is_valid(world) || !body_is_finite(world, body);
			cn_world_destroy(world);
		}
	CHECK_LE("worlds that are not valid, or with a number that is none", wrong, 0, "");
}

/* The velocity at the new centre is that of the old one plus rotation times the way between them. */
static void t_a_spinning_body_gets_a_shape(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.5f, 0.5f, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
	fixture_set_velocity(world, body, 0.0f, 1.0f, 3e38f);
	def.offset_m = at(20.0f, -30.0f);
	fixture_box_shape(world, &def, 1.0f, 1.0f);
	CHECK_GE("mass", mass_of(world, body).mass_kg, 4.0, "kg"); /* the new centre */
	CHECK(isfinite(fixture_velocity(world, body).linear_mps.x) && isfinite(fixture_velocity(world, body).linear_mps.y));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void t_hulls_refuse_what_is_no_radius(void)
{
	static const cn_vec2 square[] = { { 0.0f, 0.0f }, { 1.0f, 0.0f }, { 1.0f, 1.0f }, { 0.0f, 1.0f } };
	cn_polygon out;
	CHECK(cn_polygon_make_hull(square, 4, (float)NAN, &out) == CN_ERROR_ARGUMENT);
	CHECK(cn_polygon_make_hull(square, 4, (float)INFINITY, &out) == CN_ERROR_ARGUMENT);
	CHECK(cn_polygon_make_hull(square, 4, 0.1f, &out) == CN_OK && out.radius_m == 0.1f);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_absurd_forces_and_speeds);
	RUN(t_steps_of_no_length);
	RUN(t_fields_that_overflow);
	RUN(t_what_is_made_asleep_does_not_move);
	RUN(t_a_spinning_body_gets_a_shape);
	RUN(t_hulls_refuse_what_is_no_radius);
	return test_end();
}
