/*
 * test/world/spin_test.c - what nothing holds keeps its angular momentum (step/angular_momentum.c), and nothing else is turned.
 *
 * Momentum is summed in double precision around the centre of mass, from poses and velocities as a game reads them.
 */
#include "fixture.h"

#define BODIES 30
#define STEPS 600

typedef struct spin {
	double sum;     /* kg m^2 / s */
	double scale;   /* of its parts' absolute values */
	double turning; /* inertia of all around the centre of mass */
} spin;

typedef struct part {
	double x, y, vx, vy, w, mass, inertia;
} part;

static part part_of(const cn_world *world, cn_body body)
{
	cn_mass_data m;
	cn_pose pose = fixture_pose(world, body);
	cn_velocity v = fixture_velocity(world, body);
	part p;
	must(cn_body_get_mass_data(world, body, &m), world, "cn_body_get_mass_data");
	p.x = (double)pose.position_m.x; /* every shape here has its centre at the body's origin */
	p.y = (double)pose.position_m.y;
	p.vx = (double)v.linear_mps.x;
	p.vy = (double)v.linear_mps.y;
	p.w = (double)v.angular_radps;
	p.mass = (double)m.mass_kg;
	p.inertia = (double)m.inertia_kgm2;
	return p;
}

static spin spin_of(const cn_world *world, const cn_body *bodies, int32_t count)
{
	part mean = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	spin s = { 0.0, 0.0, 0.0 };
	int32_t k;
	for (k = 0; k < count; ++k) {
		part p = part_of(world, bodies[k]);
		mean.mass += p.mass;
		mean.x += p.mass * p.x;
		mean.y += p.mass * p.y;
		mean.vx += p.mass * p.vx;
		mean.vy += p.mass * p.vy;
	}
	for (k = 0; k < count; ++k) {
		part p = part_of(world, bodies[k]);
		double x = p.x - mean.x / mean.mass, y = p.y - mean.y / mean.mass;
		double own = p.mass * (x * (p.vy - mean.vy / mean.mass) - y * (p.vx - mean.vx / mean.mass)) + p.inertia * p.w;
		s.sum += own;
		s.scale += fabs(own);
		s.turning += p.mass * (x * x + y * y) + p.inertia;
	}
	return s;
}

/* Balls and boxes that fly into each other with a swirl, while all of them fall. */
static void cluster_make(cn_world *world, cn_body *bodies, float friction, float e, uint32_t *seed)
{
	int32_t k;
	for (k = 0; k < BODIES; ++k) {
		float x = fixture_random(seed, -0.2f, 0.2f) + 1.2f * (float)(k % 6) - 3.0f, y = 1.2f * (float)(k / 6) - 3.0f;
		float r = fixture_random(seed, 0.2f, 0.5f);
		bodies[k] = k % 2 ? fixture_box(world, CN_BODY_DYNAMIC, x, y, x, r, 0.7f * r, friction, e) : fixture_circle(world, CN_BODY_DYNAMIC, x, y, r, friction, e);
		fixture_set_velocity(world, bodies[k], -x - 0.5f * y, -y + 0.5f * x, fixture_random(seed, -1.0f, 1.0f));
	}
}

static double cluster_drift(float gravity, float friction, float e, int32_t jointed, uint32_t seed)
{
	cn_world *world = fixture_world(gravity, 0);
	cn_body bodies[BODIES];
	spin before, after;
	double drift = 0.0;
	int32_t k, touching = 0;
	cluster_make(world, bodies, friction, e, &seed);
	for (k = 0; k + 1 < BODIES && jointed; k += 2) {
		cn_fixed_def def;
		cn_joint joint;
		cn_fixed_def_init(&def);
		def.base.body_a = bodies[k];
		def.base.body_b = bodies[k + 1];
		must(cn_joint_create_fixed(world, &def, &joint), world, "cn_joint_create_fixed");
		fixture_set_velocity(world, bodies[k + 1], fixture_velocity(world, bodies[k]).linear_mps.x, fixture_velocity(world, bodies[k]).linear_mps.y, 0.0f);
	}
	fixture_step(world, 1);
	before = spin_of(world, bodies, BODIES);
	for (k = 0; k < STEPS; ++k) {
		fixture_step(world, 1);
		after = spin_of(world, bodies, BODIES);
		drift = greater(drift, fabs(after.sum - before.sum) / before.scale);
		touching += fixture_counters(world).contacts_touching;
	}
	CHECK(fixture_is_valid(world));
	CHECK_GE("contacts, summed over the steps", touching, 300, "");
	cn_world_destroy(world);
	return drift;
}

static void clusters_keep_their_spin(void)
{
	uint32_t seed;
	for (seed = 1; seed <= 3; ++seed) {
		CHECK_LE("drift, sticking", cluster_drift(0.0f, 0.6f, 0.0f, 0, seed * 2654435761u), 2e-6, "");
		CHECK_LE("drift, bouncing", cluster_drift(0.0f, 0.0f, 0.9f, 0, seed * 2654435761u), 2e-6, "");
	}
}

/* 5 m down, where poses are read with fewer digits. */
static void falling_clusters_keep_their_spin(void)
{
	CHECK_LE("drift", cluster_drift(-0.1f, 0.6f, 0.3f, 0, 77u), 1e-5, "");
}

static void jointed_clusters_keep_their_spin(void)
{
	CHECK_LE("drift", cluster_drift(0.0f, 0.6f, 0.3f, 1, 99u), 2e-6, "");
}

/* A ball that another has left goes straight on, whatever the other meets, though they are of one island until they sleep. */
static void what_flies_alone_is_left_alone(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.5f, 0.6f, 0.8f);
	cn_body box = fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 0.4f, 0.3f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_velocity after, now;
	int32_t k, apart = 0;
	fixture_box(world, CN_BODY_DYNAMIC, 5.0f, 1.5f, 0.1f, 0.5f, 2.0f, 0.6f, 0.0f);
	fixture_set_velocity(world, ball, 4.0f, 0.0f, 0.0f);
	fixture_step(world, 40);
	CHECK(fixture_counters(world).contacts_touching == 0);
	after = fixture_velocity(world, ball);
	CHECK_GE("speed of the box", (double)fixture_velocity(world, box).linear_mps.x, 1.0, "m/s");
	for (k = 0; k < 200; ++k) {
		fixture_step(world, 1);
		now = fixture_velocity(world, ball);
		apart += now.linear_mps.x != after.linear_mps.x || now.linear_mps.y != after.linear_mps.y || now.angular_radps != after.angular_radps;
	}
	CHECK_GE("turning of the box by what it met", fabs((double)fixture_velocity(world, box).angular_radps), 0.01, "rad/s");
	CHECK(apart == 0);
	cn_world_destroy(world);
}

/* One of two boxes that touch has a torque, and pushes the other away when it turns. */
static void a_torque_turns_what_nothing_else_holds(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body pair[2];
	spin s;
	int32_t k;
	pair[0] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	pair[1] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 60; ++k) {
		must(cn_body_apply_torque(world, pair[0], 0.1f), world, "cn_body_apply_torque");
		fixture_step(world, 1);
	}
	s = spin_of(world, pair, 2);
	CHECK_LE("spin after 0.1 Nm for 1 s less 0.1", fabs(s.sum - 0.1), 1e-3, "kg m^2 / s");
	CHECK_GE("speed of the other", fabs((double)fixture_velocity(world, pair[1]).linear_mps.y), 1e-3, "m/s");
	cn_world_destroy(world);
}

/*
 * Gears bear on the world: two discs that touch, without friction, share a spin by their ratio, and do not keep its sum. I wa = I w - 2 j and
 * I wb = j with wb = 2 wa give wa = w / 5.
 */
static void gears_may_change_the_spin(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body pair[2];
	cn_gear_def def;
	cn_joint joint;
	int32_t k;
	for (k = 0; k < 2; ++k)
		pair[k] = fixture_circle(world, CN_BODY_DYNAMIC, (float)k, 0.0f, 0.5f, 0.0f, 0.0f);
	cn_gear_def_init(&def);
	def.base.flags |= CN_JOINT_COLLIDE;
	def.base.body_a = pair[0];
	def.base.body_b = pair[1];
	def.ratio = 2.0f;
	must(cn_joint_create_gear(world, &def, &joint), world, "cn_joint_create_gear");
	fixture_set_velocity(world, pair[0], 0.0f, 0.0f, 5.0f);
	fixture_step(world, 60);
	CHECK(fixture_counters(world).contacts_touching == 1);
	for (k = 0; k < 2; ++k) {
		cn_velocity v = fixture_velocity(world, pair[k]);
		CHECK_LE("error of the spin", fabs((double)v.angular_radps - (k == 0 ? 1.0 : 2.0)), 1e-3, "rad/s");
		CHECK_LE("speed of the centre", hypot((double)v.linear_mps.x, (double)v.linear_mps.y), 1e-4, "m/s");
	}
	cn_world_destroy(world);
}

/* A damped pair slows down; it would not if the loss were given back. */
static void damping_is_not_undone(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body pair[2];
	spin before, after;
	int32_t k;
	for (k = 0; k < 2; ++k) {
		pair[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_set_velocity(world, pair[k], k == 0 ? 0.05f : -0.05f, 0.0f, 0.1f);
		must(cn_body_set_damping(world, pair[k], 1.0f, 1.0f), world, "cn_body_set_damping");
	}
	before = spin_of(world, pair, 2);
	fixture_step(world, 60);
	after = spin_of(world, pair, 2);
	CHECK_LE("spin after 1 s at 1/s", fabs(after.sum) / fabs(before.sum), 0.38, "of the start's");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(clusters_keep_their_spin);
	RUN(falling_clusters_keep_their_spin);
	RUN(jointed_clusters_keep_their_spin);
	RUN(what_flies_alone_is_left_alone);
	RUN(a_torque_turns_what_nothing_else_holds);
	RUN(gears_may_change_the_spin);
	RUN(damping_is_not_undone);
	return test_end();
}
