/*
 * test/world/units_test.c - a world is the same in any unit of length and mass: with lengths times a power of two, and the world's
 * length_unit with them, every pose and velocity is the same float times that power, in every step. So is one with masses times a power
 * of two. A program that counts in pixels or centimetres gets what one in metres gets.
 *
 * If a test here fails, look first for a length, speed or impulse that is compared with a number without length_unit, and for one that is
 * compared with an angle without cni_row_length (joints/joint_constraint.h) or added to a torque.
 */
#include "joints.h"

#include <string.h>

#define BODIES 24
#define STEPS 150
#define CASES TEST_FORM(24, 9, 3)
#define NOTHING 2e-16 /* m, m/s: squares of 1/1024 of it, as energies are of speeds, are below FLT_MIN and lose bits */

typedef struct scaled {
	cn_world *world;
	float length, mass; /* of one metre, of one kilogram */
	uint32_t random;    /* equal at all scales */
	cn_body bodies[BODIES];
} scaled;

static float pick(scaled *s, float least, float most) { return fixture_random(&s->random, least, most); }

static int32_t one_of(scaled *s, int32_t count) { return (int32_t)(fixture_random(&s->random, 0.0f, 1.0f) * 0.999f * (float)count); }

static cn_vec2 place(const scaled *s, float x, float y) { return at(s->length * x, s->length * y); }

static scaled open_scaled(uint32_t seed, int32_t solver, float length, float mass)
{
	scaled s;
	cn_world_def def;
	memset(&s, 0, sizeof s);
	s.length = length;
	s.mass = mass;
	s.random = seed * 2654435761u + 1u;
	cn_world_def_init(&def);
	def.solver = solver;
	def.length_unit_m = length;
	def.gravity_mps2 = place(&s, 0.0f, -10.0f);
	must(cn_world_create(&def, &s.world), NULL, "cn_world_create");
	return s;
}

static cn_body make_body(scaled *s, int32_t type, float x, float y, float angle)
{
	return fixture_body(s->world, type, s->length * x, s->length * y, angle);
}

static cn_shape_def surface(scaled *s, cn_body body)
{
	cn_shape_def def = fixture_shape_def(body, pick(s, 0.0f, 1.0f), one_of(s, 3) == 0 ? pick(s, 0.0f, 0.9f) : 0.0f);
	def.density_kgpm2 = s->mass / (s->length * s->length) * (one_of(s, 4) == 0 ? pick(s, 1.0f, 100.0f) : 1.0f);
	if (one_of(s, 8) == 0)
		def.material.rolling_resistance = s->length * pick(s, 0.0f, 0.1f);
	if (one_of(s, 8) == 0)
		def.material.tangent_speed_mps = s->length * pick(s, -2.0f, 2.0f);
	return def;
}

static void add_shape(scaled *s, cn_body body)
{
	cn_shape_def def = surface(s, body);
	cn_circle circle;
	cn_capsule capsule;
	cn_polygon triangle = { 3, 0.0f, { { 0.0f, 0.0f } } };
	float a = pick(s, 0.1f, 0.5f), b = pick(s, 0.02f, 0.4f);
	switch (one_of(s, 4)) {
	case 0:
		must(cn_shape_create_box(s->world, &def, s->length * a, s->length * b, 0.0f, NULL), s->world, "box");
		break;
	case 1:
		circle.center_m = place(s, 0.0f, 0.0f);
		circle.radius_m = s->length * a;
		must(cn_shape_create_circle(s->world, &def, &circle, NULL), s->world, "circle");
		break;
	case 2:
		capsule.a_m = place(s, -a, 0.0f);
		capsule.b_m = place(s, a, 0.0f);
		capsule.radius_m = s->length * b;
		must(cn_shape_create_capsule(s->world, &def, &capsule, NULL), s->world, "capsule");
		break;
	default:
		triangle.radius_m = s->length * 0.05f;
		triangle.points_m[0] = place(s, -a, -a);
		triangle.points_m[1] = place(s, a, -a);
		triangle.points_m[2] = place(s, 0.0f, b);
		must(cn_shape_create_polygon(s->world, &def, &triangle, NULL), s->world, "triangle");
	}
}

static void add_ground(scaled *s)
{
	cn_vec2 points[6];
	cn_chain chain = { NULL, 6, 0 };
	cn_body ground = make_body(s, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), paddle = make_body(s, CN_BODY_KINEMATIC, 0.0f, 0.3f, 0.0f);
	cn_shape_def def;
	int32_t k;
	for (k = 0; k < 6; ++k)
		points[k] = place(s, 20.0f - 8.0f * (float)k, k == 0 || k == 5 ? 6.0f : pick(s, 0.0f, 0.5f));
	chain.points_m = points;
	def = surface(s, ground);
	must(cn_shape_create_chain(s->world, &def, &chain, NULL), s->world, "chain");
	def = surface(s, paddle);
	must(cn_shape_create_box(s->world, &def, s->length, 0.2f * s->length, 0.0f, NULL), s->world, "paddle");
	must(cn_body_set_velocity(s->world, paddle, s->length * pick(s, -1.0f, 1.0f), 0.0f, pick(s, -2.0f, 2.0f)), s->world, "velocity");
}

/* ---- joints ---- */

static float force_of(const scaled *s, float newtons) { return s->mass * s->length * newtons; }
static float torque_of(const scaled *s, float newton_metres) { return s->mass * s->length * s->length * newton_metres; }

static cn_joint_base *begin(scaled *s, cn_joint_base *base, cn_body a, cn_body b)
{
	cn_pose pose_a = fixture_pose(s->world, a), pose_b = fixture_pose(s->world, b);
	float half_x = 0.5f * (pose_b.position_m.x - pose_a.position_m.x), half_y = 0.5f * (pose_b.position_m.y - pose_a.position_m.y);
	connect(base, a, at(half_x, half_y), b, at(-half_x, -half_y));
	base->flags = (uint32_t)one_of(s, 16) << 1 & (uint32_t)(CN_JOINT_LIMIT | CN_JOINT_MOTOR | CN_JOINT_SPRING);
	if (one_of(s, 4) == 0) {
		base->force_max_N = force_of(s, pick(s, 1.0f, 300.0f));
		base->torque_max_Nm = torque_of(s, pick(s, 1.0f, 100.0f));
	}
	if (one_of(s, 6) == 0) {
		base->flags |= CN_JOINT_BREAKS;
		base->break_force_N = force_of(s, pick(s, 10.0f, 1000.0f));
		base->break_torque_Nm = torque_of(s, pick(s, 10.0f, 300.0f));
	}
	if (one_of(s, 6) == 0) {
		base->stiffness_hertz = pick(s, 2.0f, 30.0f);
		base->stiffness_damping_ratio = pick(s, 0.0f, 1.0f);
	}
	return base;
}

static void add_revolute(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	begin(s, &def.base, a, b);
	def.lower_angle_rad = pick(s, -1.0f, 0.0f);
	def.upper_angle_rad = pick(s, 0.0f, 1.0f);
	def.motor_speed_radps = pick(s, -5.0f, 5.0f);
	def.motor_torque_max_Nm = torque_of(s, pick(s, 0.0f, 50.0f));
	def.spring_hertz = pick(s, 0.5f, 10.0f);
	must(cn_joint_create_revolute(s->world, &def, &joint), s->world, "revolute");
}

static void add_distance(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_distance_def def;
	cn_distance_def_init(&def);
	begin(s, &def.base, a, b);
	def.base.anchor_a_m = def.base.anchor_b_m = at(0.0f, 0.0f);
	def.length_m = s->length * 1.5f;
	def.length_min_m = 0.0f;
	def.length_max_m = s->length * 1.6f;
	def.motor_speed_mps = s->length * pick(s, -1.0f, 1.0f);
	def.motor_force_max_N = force_of(s, pick(s, 0.0f, 30.0f));
	def.spring_hertz = pick(s, 0.5f, 10.0f);
	must(cn_joint_create_distance(s->world, &def, &joint), s->world, "distance");
}

static void add_fixed(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_fixed_def def;
	cn_fixed_def_init(&def);
	begin(s, &def.base, a, b);
	if (one_of(s, 3) == 0)
		def.angular_hertz = pick(s, 1.0f, 20.0f);
	must(cn_joint_create_fixed(s->world, &def, &joint), s->world, "fixed");
}

static void add_prismatic(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_prismatic_def def;
	cn_prismatic_def_init(&def);
	begin(s, &def.base, a, b);
	def.axis = at(1.0f, pick(s, -1.0f, 1.0f));
	def.lower_m = -s->length * pick(s, 0.0f, 0.5f);
	def.upper_m = s->length * pick(s, 0.0f, 0.5f);
	def.motor_speed_mps = s->length * pick(s, -2.0f, 2.0f);
	def.motor_force_max_N = force_of(s, pick(s, 0.0f, 50.0f));
	def.spring_hertz = pick(s, 0.5f, 10.0f);
	must(cn_joint_create_prismatic(s->world, &def, &joint), s->world, "prismatic");
}

static void add_wheel(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_wheel_def def;
	cn_wheel_def_init(&def);
	begin(s, &def.base, a, b);
	def.lower_m = -s->length * 0.2f;
	def.upper_m = s->length * 0.2f;
	def.motor_speed_radps = pick(s, -10.0f, 10.0f);
	def.motor_torque_max_Nm = torque_of(s, pick(s, 0.0f, 20.0f));
	must(cn_joint_create_wheel(s->world, &def, &joint), s->world, "wheel");
}

static void add_other(scaled *s, cn_body a, cn_body b)
{
	cn_joint joint;
	cn_motor_def motor;
	cn_gear_def gear;
	cn_pulley_def pulley;
	cn_ratchet_def ratchet;
	cn_rotary_spring_def spring;
	cn_groove_def groove;
	cn_pose from = fixture_pose(s->world, a), to = fixture_pose(s->world, b);
	switch (one_of(s, 6)) {
	case 0:
		cn_motor_def_init(&motor);
		begin(s, &motor.base, a, b);
		motor.base.force_max_N = force_of(s, 50.0f);
		motor.base.torque_max_Nm = torque_of(s, 20.0f);
		must(cn_joint_create_motor(s->world, &motor, &joint), s->world, "motor");
		break;
	case 1:
		cn_gear_def_init(&gear);
		begin(s, &gear.base, a, b);
		gear.ratio = pick(s, -3.0f, -0.5f);
		must(cn_joint_create_gear(s->world, &gear, &joint), s->world, "gear");
		break;
	case 2:
		cn_pulley_def_init(&pulley);
		begin(s, &pulley.base, a, b);
		pulley.ground_a_m = at(from.position_m.x, from.position_m.y + 4.0f * s->length);
		pulley.ground_b_m = at(to.position_m.x, to.position_m.y + 4.0f * s->length);
		pulley.length_m = 9.0f * s->length;
		must(cn_joint_create_pulley(s->world, &pulley, &joint), s->world, "pulley");
		break;
	case 3:
		cn_ratchet_def_init(&ratchet);
		begin(s, &ratchet.base, a, b);
		ratchet.click_rad = 0.3f;
		must(cn_joint_create_ratchet(s->world, &ratchet, &joint), s->world, "ratchet");
		break;
	case 4:
		cn_rotary_spring_def_init(&spring);
		begin(s, &spring.base, a, b);
		must(cn_joint_create_rotary_spring(s->world, &spring, &joint), s->world, "rotary spring");
		break;
	default:
		cn_groove_def_init(&groove);
		begin(s, &groove.base, a, b);
		groove.end_m = at(groove.base.anchor_a_m.x + s->length, groove.base.anchor_a_m.y);
		must(cn_joint_create_groove(s->world, &groove, &joint), s->world, "groove");
	}
}

static void add_joint(scaled *s, cn_body a, cn_body b)
{
	switch (one_of(s, 8)) {
	case 0: case 1: add_revolute(s, a, b); break;
	case 2: case 3: add_distance(s, a, b); break;
	case 4: add_fixed(s, a, b); break;
	case 5: add_prismatic(s, a, b); break;
	case 6: add_wheel(s, a, b); break;
	default: add_other(s, a, b); break;
	}
}

/* Bodies in rows above the ground; most have a joint to one that was made before, or to the world. */
static scaled make_scene(uint32_t seed, int32_t solver, float length, float mass)
{
	scaled s = open_scaled(seed, solver, length, mass);
	int32_t k;
	add_ground(&s);
	for (k = 0; k < BODIES; ++k) {
		s.bodies[k] = make_body(&s, CN_BODY_DYNAMIC, 1.5f * (float)(k % 8 - 4), 1.5f + 1.5f * (float)(k / 8), pick(&s, -0.5f, 0.5f));
		add_shape(&s, s.bodies[k]);
		if (k % 8 > 0 && one_of(&s, 4) > 0)
			add_joint(&s, s.bodies[k - 1], s.bodies[k]);
		if (k >= 8 && one_of(&s, 5) == 0)
			add_joint(&s, s.bodies[k - 8], s.bodies[k]);
	}
	return s;
}

/* ---- running ---- */

static int32_t differ(float value, float other, float scale)
{
	return fabs((double)value - (double)other / (double)scale) > NOTHING;
}

/* The number of bodies whose state is not that of the same body in the other world, whose lengths are longer. */
static int32_t states_differ(const scaled *a, const scaled *b)
{
	int32_t k, count = 0;
	for (k = 0; k < BODIES; ++k) {
		cn_pose p = fixture_pose(a->world, a->bodies[k]), q = fixture_pose(b->world, b->bodies[k]);
		cn_velocity v = fixture_velocity(a->world, a->bodies[k]), u = fixture_velocity(b->world, b->bodies[k]);
		count += differ(p.position_m.x, q.position_m.x, b->length) || differ(p.position_m.y, q.position_m.y, b->length) || differ(p.sine, q.sine, 1.0f) ||
		         differ(v.linear_mps.x, u.linear_mps.x, b->length) || differ(v.linear_mps.y, u.linear_mps.y, b->length) ||
		         differ(v.angular_radps, u.angular_radps, 1.0f);
	}
	return count;
}

/* Users do the same in both worlds: blows, and parts that become static for a while. */
static void meddle(const scaled *s, int32_t step)
{
	cn_body body = s->bodies[step / 30 % BODIES];
	if (step % 30 == 20)
		must(cn_body_apply_impulse(s->world, body, force_of(s, 3.0f), force_of(s, 2.0f)), s->world, "impulse");
	if (step % 60 == 30)
		must(cn_body_set_type(s->world, s->bodies[(step / 60 * 7 + 3) % BODIES], CN_BODY_STATIC), s->world, "type");
	if (step % 60 == 59)
		must(cn_body_set_type(s->world, s->bodies[(step / 60 * 7 + 3) % BODIES], CN_BODY_DYNAMIC), s->world, "type");
}

/* The first step after which the worlds differ, or -1. */
static int32_t differs_from(uint32_t seed, int32_t solver, float length, float mass)
{
	scaled one = make_scene(seed, solver, 1.0f, 1.0f), other = make_scene(seed, solver, length, mass);
	int32_t k, found = -1;
	for (k = 0; k < STEPS && found < 0; ++k) {
		meddle(&one, k);
		meddle(&other, k);
		fixture_step(one.world, 1);
		fixture_step(other.world, 1);
		if (states_differ(&one, &other) > 0)
			found = k;
	}
	cn_world_destroy(one.world);
	cn_world_destroy(other.world);
	return found;
}

static void check_scale(float length, float mass)
{
	static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_SOFT, CN_SOLVER_DIRECT };
	uint32_t seed;
	for (seed = 0; seed < CASES; ++seed) {
		int32_t step = differs_from(seed, solvers[seed % 3], length, mass);
		if (step >= 0)
			printf("  seed %u, solver %d, length x %g, mass x %g: other states after step %d\n", seed, (int)solvers[seed % 3], (double)length, (double)mass, (int)step);
		CHECK(step < 0);
	}
}

static void pixels_are_as_good_as_metres(void) { check_scale(128.0f, 1.0f); }

static void kilometres_are_as_good_as_metres(void) { check_scale(1.0f / 1024.0f, 1.0f); }

static void grams_are_as_good_as_kilograms(void) { check_scale(1.0f, 1024.0f); }

int main(void)
{
	RUN(pixels_are_as_good_as_metres);
	RUN(kilometres_are_as_good_as_metres);
	RUN(grams_are_as_good_as_kilograms);
	return test_end();
}
