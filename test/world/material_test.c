/*
 * test/world/material_test.c - materials against closed forms: mixing, rolling resistance, conveyors.
 *
 * If a test here fails, look first in: model/material.c (rules, callback), contacts/contact_kernel.h (rolling,
 * conveyors, friction), model/contact.c (extra rows of contacts that rest or sleep).
 */
#include "fixture.h"

#define GRAVITY 10.0

/* The two materials of the rules' tests, and what each CN_MIX_ rule makes of them. */
static const float friction_pair[2] = { 0.2f, 0.8f };
static const float restitution_pair[2] = { 0.3f, 0.9f };

static double mixed(int32_t rule, const float *pair)
{
	double a = (double)pair[0], b = (double)pair[1];
	switch (rule) {
	case CN_MIX_AVERAGE: return 0.5 * (a + b);
	case CN_MIX_GEOMETRIC: return sqrt(a * b);
	case CN_MIX_MINIMUM: return a < b ? a : b;
	case CN_MIX_MULTIPLY: return a * b;
	default: return a > b ? a : b;
	}
}

static cn_shape slab(cn_world *world, const cn_material *material)
{
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f), 0.0f, 0.0f);
	def.material = *material;
	return fixture_box_shape(world, &def, 500.0f, 1.0f);
}

static cn_body slider(cn_world *world, const cn_material *material, float x, float y, cn_shape *shape)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.0f, 0.0f);
	cn_shape s;
	def.material = *material;
	s = fixture_box_shape(world, &def, 0.5f, 0.1f);
	if (shape != NULL)
		*shape = s;
	return body;
}

static cn_body ball_on(cn_world *world, const cn_material *material, float x, float y, float radius, cn_shape *shape)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.0f, 0.0f);
	cn_circle circle;
	circle.center_m.x = circle.center_m.y = 0.0f;
	circle.radius_m = radius;
	def.material = *material;
	must(cn_shape_create_circle(world, &def, &circle, shape), world, "cn_shape_create_circle");
	return body;
}

static cn_material material_of(float friction, float restitution)
{
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.material.static_friction = def.material.dynamic_friction = friction;
	def.material.restitution = restitution;
	return def.material;
}

/* Distance to rest of a box sent along the floor at 5 m/s. */
static double slide(cn_world *world, const cn_material *ground, const cn_material *box)
{
	cn_body body;
	slab(world, ground);
	body = slider(world, box, -20.0f, 0.1f, NULL);
	fixture_set_velocity(world, body, 5.0f, 0.0f, 0.0f);
	fixture_step(world, 260);
	return (double)fixture_pose(world, body).position_m.x + 20.0;
}

static double slide_with_rules(int32_t ground_rule, int32_t box_rule)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material ground = material_of(friction_pair[0], 0.0f), box = material_of(friction_pair[1], 0.0f);
	double distance;
	ground.friction_mix = ground_rule;
	box.friction_mix = box_rule;
	distance = slide(world, &ground, &box);
	cn_world_destroy(world);
	return distance;
}

static void friction_follows_its_rule(void)
{
	int32_t a, b;
	double worst = 0.0;
	for (a = CN_MIX_AVERAGE; a <= CN_MIX_MAXIMUM; ++a)
		for (b = CN_MIX_AVERAGE; b <= CN_MIX_MAXIMUM; ++b) {
			double exact = 25.0 / (2.0 * mixed(a > b ? a : b, friction_pair) * GRAVITY), error = fabs(slide_with_rules(a, b) / exact - 1.0);
			if (error > 0.02)
				printf("  rules %d and %d: relative error %.4f\n", (int)a, (int)b, error);
			worst = error > worst ? error : worst;
		}
	CHECK_LE("relative error of the sliding distance, 25 pairs of rules", worst, 5.0 * SOLVED, "");
}

/* Height of the first bounce of a ball dropped from 5 m. */
static double bounce(cn_world *world, const cn_material *ground, const cn_material *ball)
{
	double top = 0.0;
	cn_body body;
	int32_t k, up = 0;
	slab(world, ground);
	body = ball_on(world, ball, 0.0f, 5.25f, 0.25f, NULL);
	for (k = 0; k < 200; ++k) {
		double height, speed;
		fixture_step(world, 1);
		height = (double)fixture_pose(world, body).position_m.y - 0.25;
		speed = (double)fixture_velocity(world, body).linear_mps.y;
		if (up && speed <= 0.0)
			break;
		up |= speed > 0.0;
		if (up && height > top)
			top = height;
	}
	return top;
}

static void restitution_follows_its_rule(void)
{
	int32_t a, b;
	double worst = 0.0;
	for (a = CN_MIX_AVERAGE; a <= CN_MIX_MAXIMUM; ++a)
		for (b = CN_MIX_AVERAGE; b <= CN_MIX_MAXIMUM; ++b) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_material ground = material_of(0.5f, restitution_pair[0]), ball = material_of(0.5f, restitution_pair[1]);
			double e = mixed(a > b ? a : b, restitution_pair), error;
			ground.restitution_mix = a;
			ball.restitution_mix = b;
			error = fabs(bounce(world, &ground, &ball) - e * e * 5.0) / 5.0;
			if (error > 0.03)
				printf("  rules %d and %d: error %.4f of the fall\n", (int)a, (int)b, error);
			worst = error > worst ? error : worst;
			cn_world_destroy(world);
		}
	CHECK_LE("error of the bounce, share of the fall, 25 pairs of rules", worst, 2.0 * SOLVED, "");
}

/* ---- the mix callback ---- */

typedef struct mixer {
	int32_t calls;
	int32_t unlocked;      /* calls that a locked world accepted */
	int32_t wrong;         /* calls that did not hold what the rules give */
	float expected;
	cn_material write;
	cn_body body;
} mixer;

static void mix_as_told(cn_world *world, cn_shape shape_a, cn_shape shape_b, cn_material *material, void *user)
{
	mixer *m = (mixer *)user;
	++m->calls;
	m->unlocked += cn_world_step(world, FRAME_S) != CN_ERROR_LOCKED;
	m->unlocked += cn_body_set_velocity(world, m->body, 0.0f, 0.0f, 0.0f) != CN_ERROR_LOCKED;
	m->unlocked += cn_shape_destroy(world, shape_a) != CN_ERROR_LOCKED;
	m->wrong += !cn_shape_is_valid(world, shape_a) || !cn_shape_is_valid(world, shape_b);
	m->wrong += fabsf(material->dynamic_friction - m->expected) > 1e-6f;
	*material = m->write;
}

static double slide_with_callback(mixer *m)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material ground = material_of(friction_pair[0], 0.0f), box = material_of(friction_pair[1], 0.0f);
	double distance;
	m->calls = m->unlocked = m->wrong = 0;
	m->expected = 0.4f;
	must(cn_world_set_material_mix_callback(world, mix_as_told, m), world, "cn_world_set_material_mix_callback");
	distance = slide(world, &ground, &box);
	CHECK(m->calls >= 1);
	CHECK(m->unlocked == 0);
	CHECK(m->wrong == 0);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	return distance;
}

static void callback_replaces_the_rules(void)
{
	mixer m;
	memset(&m, 0, sizeof m);
	m.write = material_of(0.25f, 0.0f);
	CHECK_LE("relative error at the callback's coefficient", fabs(slide_with_callback(&m) / (25.0 / (0.5 * GRAVITY)) - 1.0), SOLVED, "");
	CHECK_LE("calls for one pair", m.calls, 2.0, "");
}

static void callback_values_are_restrained(void)
{
	mixer m;
	double exact = 25.0 / (2.0 * 0.4 * GRAVITY);
	memset(&m, 0, sizeof m);
	m.write = material_of(NAN, NAN);
	m.write.rolling_resistance = m.write.tangent_speed_mps = NAN;
	CHECK_LE("relative error when NaN falls back to the rules", fabs(slide_with_callback(&m) / exact - 1.0), SOLVED, "");
	m.write = material_of(-3.0f, -1.0f);
	m.write.rolling_resistance = -5.0f;
	CHECK_LE("relative error of a negative coefficient taken as 0", fabs(slide_with_callback(&m) / (5.0 * 260.0 / 60.0) - 1.0), ROUNDING, "");
	m.write = material_of(0.25f, 0.0f);
	m.write.dynamic_friction = 50.0f; /* above the static one: as that */
	CHECK_LE("relative error of dynamic friction above static", fabs(slide_with_callback(&m) / (25.0 / (0.5 * GRAVITY)) - 1.0), SOLVED, "");
}

/* A belt that the callback makes runs to either side. */
static void callback_makes_a_belt(void)
{
	static const float speeds[2] = { 1.5f, -1.5f };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_material plain = material_of(0.5f, 0.0f);
		cn_body box;
		mixer m;
		memset(&m, 0, sizeof m);
		m.expected = 0.5f;
		m.write = plain;
		m.write.tangent_speed_mps = speeds[k];
		must(cn_world_set_material_mix_callback(world, mix_as_told, &m), world, "cn_world_set_material_mix_callback");
		slab(world, &plain);
		box = slider(world, &plain, 0.0f, 0.1f, NULL);
		fixture_step(world, 60);
		CHECK_LE("belt speed missed", fabs(fabs((double)fixture_velocity(world, box).linear_mps.x) - 1.5), ROUNDING, "m/s");
		CHECK(m.calls >= 1 && m.unlocked == 0 && m.wrong == 0);
		cn_world_destroy(world);
	}
}

static void callback_cannot_gain_energy(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material plain = material_of(0.5f, 0.2f);
	mixer m;
	memset(&m, 0, sizeof m);
	m.expected = 0.5f;
	m.write = material_of(0.5f, 7.0f);
	must(cn_world_set_material_mix_callback(world, mix_as_told, &m), world, "cn_world_set_material_mix_callback");
	CHECK_LE("bounce at a restitution of 7, taken as 1", bounce(world, &plain, &plain), 5.02, "m");
	CHECK(m.calls >= 1 && m.unlocked == 0 && m.wrong == 0);
	cn_world_destroy(world);
}

static void removed_callback_is_not_called(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material ground = material_of(friction_pair[0], 0.0f), box = material_of(friction_pair[1], 0.0f);
	mixer m;
	double exact = 25.0 / (2.0 * 0.4 * GRAVITY);
	memset(&m, 0, sizeof m);
	must(cn_world_set_material_mix_callback(world, mix_as_told, &m), world, "cn_world_set_material_mix_callback");
	must(cn_world_set_material_mix_callback(world, NULL, NULL), world, "cn_world_set_material_mix_callback");
	CHECK_LE("relative error after removal", fabs(slide(world, &ground, &box) / exact - 1.0), SOLVED, "");
	CHECK(m.calls == 0);
	cn_world_destroy(world);
}

/* ---- changes at run time ---- */

/* A sleeping box on a slope of 20 degrees whose ground becomes slippery slides away at the closed-form speed. */
static void resting_contact_takes_a_new_friction(void)
{
	double angle = 20.0 * 3.14159265358979323846 / 180.0, exact = GRAVITY * (sin(angle) - 0.1 * cos(angle)), speed;
	float c = (float)cos(angle), s = (float)sin(angle);
	cn_world *world = fixture_world(-10.0f, 1);
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, s, -c, (float)angle), 0.8f, 0.0f);
	cn_shape ground = fixture_box_shape(world, &def, 50.0f, 1.0f);
	cn_body box = fixture_box(world, CN_BODY_DYNAMIC, -0.1f * s, 0.1f * c, (float)angle, 0.5f, 0.1f, 0.8f, 0.0f);
	cn_material slippery = material_of(0.1f, 0.0f);
	cn_velocity v;
	slippery.friction_mix = CN_MIX_MULTIPLY;
	slippery.static_friction = slippery.dynamic_friction = 0.125f;
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, box));
	must(cn_shape_set_material(world, ground, &slippery), world, "cn_shape_set_material");
	CHECK(fixture_is_awake(world, box));
	fixture_step(world, 60);
	v = fixture_velocity(world, box);
	speed = sqrt(pow((double)v.linear_mps.x, 2) + pow((double)v.linear_mps.y, 2));
	CHECK_LE("relative error of the speed after 1 s", fabs(speed / exact - 1.0), SOLVED, "");
	cn_world_destroy(world);
}

static void sleeping_box_is_carried_off_by_a_belt_switched_on(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_material plain = material_of(0.5f, 0.0f), belt = plain;
	cn_shape ground = slab(world, &plain);
	cn_body box = slider(world, &plain, 0.0f, 0.1f, NULL);
	belt.tangent_speed_mps = 2.0f;
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, box));
	must(cn_shape_set_material(world, ground, &belt), world, "cn_shape_set_material");
	fixture_step(world, 120);
	CHECK_LE("belt speed missed", fabs((double)fixture_velocity(world, box).linear_mps.x - 2.0), ROUNDING, "m/s");
	must(cn_shape_set_material(world, ground, &plain), world, "cn_shape_set_material");
	fixture_step(world, 120);
	CHECK_LE("speed after the belt stopped", fabs((double)fixture_velocity(world, box).linear_mps.x), ROUNDING, "m/s");
	CHECK(!fixture_is_awake(world, box));
	cn_world_destroy(world);
}

static void rolling_ball_takes_a_new_resistance(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material plain = material_of(0.6f, 0.0f), stiff = plain;
	cn_shape shape;
	cn_body ball;
	double before, after;
	slab(world, &plain);
	ball = ball_on(world, &plain, 0.0f, 0.5f, 0.5f, &shape);
	fixture_set_velocity(world, ball, 5.0f, 0.0f, -10.0f);
	fixture_step(world, 60);
	before = (double)fixture_velocity(world, ball).linear_mps.x;
	CHECK_LE("speed lost in 1 s without resistance", fabs(before - 5.0), 10.0 * SOLVED, "m/s");
	stiff.rolling_resistance = 0.05f;
	must(cn_shape_set_material(world, shape, &stiff), world, "cn_shape_set_material");
	fixture_step(world, 60);
	after = (double)fixture_velocity(world, ball).linear_mps.x;
	CHECK_LE("error of the speed lost in 1 s with it", fabs((before - after) / (GRAVITY * 0.1 * 2.0 / 3.0) - 1.0), 10.0 * SOLVED, "");
	cn_world_destroy(world);
}

/* ---- rolling resistance ---- */

/*
 * A disc of radius R rolls without slipping. Friction F slows it, F = m a, and turns it; the lever l resists with
 * the torque l m g: I a / R = l m g - F R. So a = g (l / R) m R^2 / (m R^2 + I), and I = m R^2 / 2 gives 2/3.
 */
static void rolling_ball_slows_and_stops(void)
{
	static const float radii[] = { 0.25f, 0.5f, 1.0f };
	static const float levers[] = { 0.01f, 0.05f, 0.1f };
	size_t r, l;
	double worst_speed = 0.0, worst_stop = 0.0, worst_rest = 0.0;
	for (r = 0; r < 3; ++r)
		for (l = 0; l < 3; ++l) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_material plain = material_of(0.8f, 0.0f), stiff = plain;
			double a = GRAVITY * (double)(levers[l] / radii[r]) * 2.0 / 3.0, v0 = 0.5 * a * 3.0, error;
			cn_body ball;
			slab(world, &plain);
			stiff.rolling_resistance = levers[l];
			ball = ball_on(world, &stiff, 0.0f, radii[r], radii[r], NULL);
			fixture_set_velocity(world, ball, (float)v0, 0.0f, (float)-v0 / radii[r]);
			fixture_step(world, 45);
			error = fabs((v0 - (double)fixture_velocity(world, ball).linear_mps.x) / (0.75 * a) - 1.0);
			worst_speed = error > worst_speed ? error : worst_speed;
			fixture_step(world, 75);
			error = fabs((double)fixture_pose(world, ball).position_m.x / (v0 * v0 / (2.0 * a)) - 1.0);
			worst_stop = error > worst_stop ? error : worst_stop;
			error = fabs((double)fixture_velocity(world, ball).linear_mps.x);
			worst_rest = error > worst_rest ? error : worst_rest;
			cn_world_destroy(world);
		}
	CHECK_LE("relative error of the deceleration", worst_speed, 10.0 * SOLVED, "");
	CHECK_LE("relative error of the distance to rest", worst_stop, 10.0 * SOLVED, "");
	CHECK_LE("speed at the end", worst_rest, ROUNDING, "m/s");
}

/* The greater of the two levers counts, whichever shape has it. */
static void rolling_resistance_is_the_greater_one(void)
{
	static const float levers[3][2] = { { 0.05f, 0.0f }, { 0.0f, 0.05f }, { 0.05f, 0.02f } }; /* of the ground, of the ball */
	double exact = GRAVITY * 0.1 * 2.0 / 3.0, worst = 0.0;
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_material ground = material_of(0.8f, 0.0f), round = ground;
		cn_body ball;
		ground.rolling_resistance = levers[k][0];
		round.rolling_resistance = levers[k][1];
		slab(world, &ground);
		ball = ball_on(world, &round, 0.0f, 0.5f, 0.5f, NULL);
		fixture_set_velocity(world, ball, 3.0f, 0.0f, -6.0f);
		fixture_step(world, 60);
		worst = greater(worst, fabs((3.0 - (double)fixture_velocity(world, ball).linear_mps.x) / exact - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("relative error of the deceleration", worst, 10.0 * SOLVED, "");
}

/* Where along a slope of ratio times the critical one a ball is after 5 s, exact or measured. */
static double ball_on_slope(double ratio, double *exact)
{
	double slope = atan(ratio * 0.1 / 0.5), along;
	float c = (float)cos(slope), s = (float)sin(slope);
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material stiff = material_of(0.9f, 0.0f);
	cn_body ball;
	cn_pose pose;
	stiff.rolling_resistance = 0.1f;
	fixture_box(world, CN_BODY_STATIC, s, -c, (float)slope, 300.0f, 1.0f, 0.9f, 0.0f);
	ball = ball_on(world, &stiff, -0.5f * s, 0.5f * c, 0.5f, NULL);
	fixture_step(world, 300);
	pose = fixture_pose(world, ball);
	along = -(((double)pose.position_m.x + 0.5 * (double)s) * (double)c + ((double)pose.position_m.y - 0.5 * (double)c) * (double)s);
	*exact = 0.5 * 25.0 * 2.0 / 3.0 * GRAVITY * (sin(slope) - 0.2 * cos(slope));
	cn_world_destroy(world);
	return along;
}

static void ball_stays_below_the_critical_slope(void)
{
	double exact, rolled = ball_on_slope(0.98, &exact);
	CHECK_LE("rolled in 5 s at 0.98 of the critical slope", fabs(rolled), SOLVED, "m");
	rolled = ball_on_slope(1.2, &exact);
	CHECK_LE("relative error of the roll in 5 s at 1.2", fabs(rolled / exact - 1.0), 20.0 * SOLVED, "");
}

/* ---- conveyors ---- */

typedef struct belt_case {
	const char *name;
	float ground_speed, box_speed; /* tangent speeds of the two materials */
	float gravity;                 /* +10: the box hangs below a ceiling */
	int32_t box_first;             /* created first: the order of the pair turns */
} belt_case;

static void box_reaches_the_speed_of_the_belt(void)
{
	static const belt_case cases[] = {
		{ "ground", 3.0f, 0.0f, -10.0f, 0 }, { "ground, box first", 3.0f, 0.0f, -10.0f, 1 },
		{ "ground, backwards", -3.0f, 0.0f, -10.0f, 0 }, { "ceiling", 3.0f, 0.0f, 10.0f, 0 },
		{ "ceiling, box first", 3.0f, 0.0f, 10.0f, 1 }, { "box", 0.0f, 3.0f, -10.0f, 0 },
		{ "both", 2.0f, 1.5f, -10.0f, 0 }, { "both, box first", 2.0f, 1.5f, -10.0f, 1 },
		{ "both, against each other", 2.0f, -2.0f, -10.0f, 0 },
	};
	size_t k;
	for (k = 0; k < sizeof cases / sizeof *cases; ++k) {
		const belt_case *b = cases + k;
		cn_world *world = fixture_world(b->gravity, 0);
		cn_material ground = material_of(0.2f, 0.0f), load = ground;
		double sign = b->gravity < 0.0f ? 1.0 : -1.0, speed = sign * (double)(b->ground_speed + b->box_speed), v, dir = speed < 0.0 ? -1.0 : 1.0;
		float y = b->gravity < 0.0f ? 0.1f : -2.1f;
		cn_body box = 0;
		ground.tangent_speed_mps = b->ground_speed;
		load.tangent_speed_mps = b->box_speed;
		if (b->box_first)
			box = slider(world, &load, 0.0f, y, NULL);
		slab(world, &ground);
		if (!b->box_first)
			box = slider(world, &load, 0.0f, y, NULL);
		fixture_step(world, 60);
		v = (double)fixture_velocity(world, box).linear_mps.x;
		printf("  %s: after 1 s %.5f m/s\n", b->name, v);
		if (speed != 0.0)
			CHECK_LE("error of the speed under 0.2 g", fabs(v - dir * 2.0), SOLVED, "m/s");
		fixture_step(world, 180);
		CHECK_LE("belt speed missed", fabs((double)fixture_velocity(world, box).linear_mps.x - speed), ROUNDING, "m/s");
		fixture_step(world, 120);
		CHECK_LE("belt speed missed later", fabs((double)fixture_velocity(world, box).linear_mps.x - speed), ROUNDING, "m/s");
		CHECK_LE("turn of the box", fabs((double)fixture_pose(world, box).sine), ROUNDING, "");
		cn_world_destroy(world);
	}
}

/* ---- static and dynamic friction ---- */

static void push_must_exceed_static_friction_and_then_meets_dynamic(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_material ground = material_of(0.6f, 0.0f);
	cn_mass_data mass;
	double weight, moved, before, gained;
	cn_body box;
	int32_t k;
	ground.dynamic_friction = 0.3f;
	slab(world, &ground);
	box = slider(world, &ground, 0.0f, 0.1f, NULL);
	must(cn_body_get_mass_data(world, box, &mass), world, "cn_body_get_mass_data");
	weight = (double)mass.mass_kg * GRAVITY;
	fixture_step(world, 30);
	for (k = 0; k < 120; ++k) {
		cn_body_apply_force_at(world, box, (float)(0.58 * weight), 0.0f, fixture_pose(world, box).position_m.x, 0.02f);
		fixture_step(world, 1);
	}
	moved = (double)fixture_pose(world, box).position_m.x;
	CHECK_LE("moved in 2 s by 0.58 of its weight", fabs(moved), ROUNDING, "m");
	for (k = 0; k < 30; ++k) {
		cn_body_apply_force_at(world, box, (float)(0.64 * weight), 0.0f, fixture_pose(world, box).position_m.x, 0.02f);
		fixture_step(world, 1);
	}
	before = (double)fixture_velocity(world, box).linear_mps.x;
	CHECK_GE("speed after 0.5 s of 0.64 of its weight", before, 1.0, "m/s");
	for (k = 0; k < 60; ++k) {
		cn_body_apply_force_at(world, box, (float)(0.45 * weight), 0.0f, fixture_pose(world, box).position_m.x, 0.02f);
		fixture_step(world, 1);
	}
	gained = (double)fixture_velocity(world, box).linear_mps.x - before;
	CHECK_LE("relative error of the speed gained in 1 s by 0.45 of its weight", fabs(gained / (0.15 * GRAVITY) - 1.0), 2.0 * SOLVED, "");
	cn_world_destroy(world);
}

/* How far a box goes that lies on a slope, or is pushed at its centre from one step to the next, with this share of static friction. */
static double moved_by(float half_height, float friction, float dynamic_friction, double share, int32_t push, int32_t solver)
{
	cn_world_def def;
	cn_world *world;
	cn_material ground = material_of(friction, 0.0f);
	cn_shape_def shape;
	cn_mass_data mass;
	double slope = push ? 0.0 : atan(share * (double)friction), moved;
	cn_body box;
	int32_t k;
	cn_world_def_init(&def);
	def.solver = solver;
	def.gravity_mps2.x = (float)(GRAVITY * sin(slope));
	def.gravity_mps2.y = (float)(-GRAVITY * cos(slope));
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	ground.dynamic_friction = dynamic_friction;
	slab(world, &ground);
	box = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, half_height, 0.0f);
	shape = fixture_shape_def(box, 0.0f, 0.0f);
	shape.material = ground;
	fixture_box_shape(world, &shape, 0.5f, half_height);
	must(cn_body_get_mass_data(world, box, &mass), world, "cn_body_get_mass_data");
	for (k = 0; k < 240; ++k) {
		if (push && k >= 60)
			cn_body_apply_force(world, box, (float)(share * (double)friction * GRAVITY) * mass.mass_kg, 0.0f);
		fixture_step(world, 1);
	}
	moved = (double)fixture_pose(world, box).position_m.x;
	cn_world_destroy(world);
	return moved;
}

static void static_friction_holds_up_to_its_coefficient(void)
{
	const float heights[] = { 0.05f, 0.25f, 0.5f, 0.6f }, pairs[3][2] = { { 0.6f, 0.4f }, { 0.6f, 0.54f }, { 0.3f, 0.15f } };
	int32_t k, pair, push, solver;
	double held = 0.0, slid = HUGE_VAL;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver)
		for (push = 0; push < 2; ++push)
			for (pair = 0; pair < 3; ++pair)
				for (k = 0; k < 4; ++k) {
					held = fmax(held, moved_by(heights[k], pairs[pair][0], pairs[pair][1], 0.98, push, solver));
					slid = fmin(slid, moved_by(heights[k], pairs[pair][0], pairs[pair][1], 1.03, push, solver));
				}
	CHECK_LE("farthest way with 98% of static friction", held, 1e-3, "m");
	CHECK_GE("shortest way with 103%", slid, 1.0, "m");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(friction_follows_its_rule);
	RUN(restitution_follows_its_rule);
	RUN(callback_replaces_the_rules);
	RUN(callback_values_are_restrained);
	RUN(callback_makes_a_belt);
	RUN(callback_cannot_gain_energy);
	RUN(removed_callback_is_not_called);
	RUN(resting_contact_takes_a_new_friction);
	RUN(sleeping_box_is_carried_off_by_a_belt_switched_on);
	RUN(rolling_ball_takes_a_new_resistance);
	RUN(rolling_ball_slows_and_stops);
	RUN(rolling_resistance_is_the_greater_one);
	RUN(ball_stays_below_the_critical_slope);
	RUN(box_reaches_the_speed_of_the_belt);
	RUN(push_must_exceed_static_friction_and_then_meets_dynamic);
	RUN(static_friction_holds_up_to_its_coefficient);
	return test_end();
}
