/*
 * test/world/events_impulse_test.c - impulses of contact events over the whole step, and hits.
 *
 * Impulses are compared with the momentum of the bodies: in a step a body without joints gains m g dt and the impulses of its
 * contacts, whatever solver, substeps and restitution gave them. Hits are compared with closed forms.
 *
 * If a test here fails, run world/events_pair first, then look in: contacts/impulse_sums.c, model/event.c (logs),
 * contacts/restitution.c (impacts), direct/contact_collect.c (directly solved contacts).
 */
#include "events.h"

enum { WITH_IMPULSES = 1 << CN_EVENT_ENTER | 1 << CN_EVENT_STAY | 1 << CN_EVENT_LEAVE, HITS = 1 << CN_EVENT_HIT };

/* ---- momentum ---- */

#define CROWD 60

typedef struct crowd {
	cn_world *world;
	cn_body bodies[CROWD];
	double mass[CROWD];
	double px[CROWD], py[CROWD]; /* momentum before a step, then what it should be */
	double carried[CROWD];       /* sum of the sizes of its impulses in the step */
} crowd;

static void crowd_shape(crowd *c, uint32_t *seed, int32_t k)
{
	float bounce = k % 3 == 0 ? fixture_random(seed, 0.2f, 1.0f) : 0.0f;
	cn_shape_def def = fixture_shape_def(c->bodies[k], fixture_random(seed, 0.0f, 1.0f), bounce);
	cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
	def.event_mask = WITH_IMPULSES;
	def.density_kgpm2 = fixture_random(seed, 0.5f, 4.0f);
	def.material.rolling_resistance = k % 5 == 0 ? 0.01f : 0.0f;
	if (k % 2)
		must(cn_shape_create_circle(c->world, &def, &circle, NULL), c->world, "circle");
	else
		fixture_box_shape(c->world, &def, 0.4f, 0.25f);
}

static void crowd_make(crowd *c, int32_t solver, uint32_t seed)
{
	int32_t k;
	c->world = fixture_world(-10.0f, 0);
	must(cn_world_set_solver(c->world, solver), c->world, "solver");
	fixture_floor(c->world, 0.6f, 0.0f);
	fixture_box(c->world, CN_BODY_STATIC, -4.0f, 5.0f, 0.0f, 0.5f, 10.0f, 0.5f, 0.5f);
	fixture_box(c->world, CN_BODY_STATIC, 4.0f, 5.0f, 0.0f, 0.5f, 10.0f, 0.5f, 0.5f);
	for (k = 0; k < CROWD; ++k) {
		cn_mass_data mass;
		float vx;
		c->bodies[k] = fixture_body(c->world, CN_BODY_DYNAMIC, -3.0f + 1.2f * (float)(k % 6), 0.6f + 1.1f * (float)(k / 6), fixture_random(&seed, -1.0f, 1.0f));
		crowd_shape(c, &seed, k);
		vx = fixture_random(&seed, -3.0f, 3.0f);
		fixture_set_velocity(c->world, c->bodies[k], vx, fixture_random(&seed, -3.0f, 3.0f), 0.0f);
		/* Angular damping: flying groups get no correction of their angular momentum, which moves momentum within the group. */
		must(cn_body_set_damping(c->world, c->bodies[k], 0.0f, 0.01f), c->world, "damping");
		must(cn_body_get_mass_data(c->world, c->bodies[k], &mass), c->world, "mass");
		c->mass[k] = (double)mass.mass_kg;
	}
}

static int32_t crowd_find(const crowd *c, cn_body body)
{
	int32_t k;
	for (k = 0; k < CROWD && c->bodies[k] != body; ++k)
		;
	return k;
}

static void crowd_push(crowd *c, cn_body body, double x, double y)
{
	int32_t k = crowd_find(c, body);
	if (k == CROWD)
		return;
	c->px[k] += x;
	c->py[k] += y;
	c->carried[k] += sqrt(x * x + y * y);
}

/* Adds the impulses of the events of one kind to the bodies' momenta. */
static void crowd_account(crowd *c, int32_t kind)
{
	const cn_contact_event *e;
	int32_t count = events_of(c->world, kind, &e), k;
	for (k = 0; k < count; ++k) {
		double n = (double)e[k].normal_impulse_Ns, t = (double)e[k].friction_impulse_Ns;
		double nx = (double)e[k].manifold.normal.x, ny = (double)e[k].manifold.normal.y;
		crowd_push(c, e[k].body_a, -(n * nx + t * ny), -(n * ny - t * nx));
		crowd_push(c, e[k].body_b, n * nx + t * ny, n * ny - t * nx);
	}
}

/* Steps once. Returns the greatest difference of a body's momentum from what the events account for, relative to its impulses. */
static double crowd_step(crowd *c)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < CROWD; ++k) {
		cn_velocity v = fixture_velocity(c->world, c->bodies[k]);
		c->px[k] = c->mass[k] * (double)v.linear_mps.x;
		c->py[k] = c->mass[k] * ((double)v.linear_mps.y - 10.0 / 60.0);
		c->carried[k] = c->mass[k] * (10.0 / 60.0 + fabs((double)v.linear_mps.x) + fabs((double)v.linear_mps.y));
	}
	fixture_step(c->world, 1);
	crowd_account(c, CN_EVENT_ENTER);
	crowd_account(c, CN_EVENT_STAY);
	for (k = 0; k < CROWD; ++k) {
		cn_velocity v = fixture_velocity(c->world, c->bodies[k]);
		double x = c->px[k] - c->mass[k] * (double)v.linear_mps.x, y = c->py[k] - c->mass[k] * (double)v.linear_mps.y;
		worst = greater(worst, sqrt(x * x + y * y) / c->carried[k]);
	}
	return worst;
}

/* In the first 90 steps all bodies fall, bounce and slide; nothing rests for the whole step yet. */
static void impulses_account_for_momentum(void)
{
	static const char *const names[] = { "AUTO", "SOFT", "DIRECT", "SEQUENTIAL" };
	int32_t solver, step;
	uint32_t seed;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SEQUENTIAL; ++solver) {
		double worst = 0.0;
		for (seed = 1; seed <= 3; ++seed) {
			static crowd c;
			crowd_make(&c, solver, 7919u * seed);
			for (step = 0; step < 90; ++step)
				worst = greater(worst, crowd_step(&c));
			cn_world_destroy(c.world);
		}
		printf("  %s: ", names[solver]);
		CHECK_LE("momentum that the events do not account for", worst, 5.0 * SOLVED, "of what a body carries");
	}
}

/* A stack that rests takes one substep a step; its events still hold the impulse of the whole step. */
static void a_stack_at_rest_reports_its_weight(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	const cn_contact_event *e;
	cn_body box;
	double bottom = 0.0;
	int32_t k, count;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 5; ++k) {
		box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		set_mask(world, box, WITH_IMPULSES);
	}
	fixture_step(world, 200);
	count = events_of(world, CN_EVENT_STAY, &e);
	for (k = 0; k < count; ++k)
		bottom = greater(bottom, (double)e[k].normal_impulse_Ns);
	CHECK(count == 5);
	CHECK_LE("impulse of the lowest contact / weight of the stack in a step - 1", fabs(bottom / (5.0 * 10.0 / 60.0) - 1.0), 10.0 * SOLVED, "");
	cn_world_destroy(world);
}

/* What is asked between steps has the last substep's impulses, and no sums. */
static void contacts_at_rest_have_the_force_of_a_substep(void)
{
	static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_SOFT, CN_SOLVER_DIRECT, CN_SOLVER_SEQUENTIAL };
	double worst = 0.0, sums = 0.0;
	int32_t s, k, count = 0;
	for (s = 0; s < 4; ++s) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_contact_event e;
		double impulse = 0.0, substeps = solvers[s] == CN_SOLVER_SEQUENTIAL ? 1.0 : 4.0;
		cn_body box;
		must(cn_world_set_solver(world, solvers[s]), world, "cn_world_set_solver");
		fixture_floor(world, 0.6f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_step(world, 200);
		must(cn_body_get_contacts(world, box, &e, 1, &count), world, "cn_body_get_contacts");
		CHECK(count == 1 && e.kind == CN_EVENT_STAY);
		for (k = 0; k < e.manifold.point_count; ++k)
			impulse += (double)e.manifold.points[k].normal_impulse_Ns;
		worst = greater(worst, fabs(impulse * substeps / (10.0 / 60.0) - 1.0));
		sums = greater(sums, fabs((double)e.normal_impulse_Ns) + fabs((double)e.friction_impulse_Ns));
		cn_world_destroy(world);
	}
	CHECK_LE("force of the points / weight - 1", worst, 10.0 * SOLVED, "");
	CHECK_LE("sums", sums, 0.0, "Ns");
}

/* A drop reports the impulse that stops it, or turns it around, in ENTER and the STAY after it. */
static void a_drop_reports_what_stops_it(void)
{
	int32_t k;
	for (k = 0; k < 3; ++k) {
		float bounce = 0.5f * (float)k;
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body ball;
		const cn_contact_event *e;
		double sum = 0.0, v = 0.0, expected;
		int32_t step, entered = 0;
		fixture_floor(world, 0.0f, bounce);
		ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 3.0f, 0.5f, 0.0f, bounce);
		set_mask(world, ball, WITH_IMPULSES);
		for (step = 0; step < 120 && sum == 0.0; ++step) {
			v = -(double)fixture_velocity(world, ball).linear_mps.y;
			fixture_step(world, 1);
			if (events_of(world, CN_EVENT_ENTER, &e) == 1) {
				entered = 1;
				sum += (double)e[0].normal_impulse_Ns;
			}
			if (events_of(world, CN_EVENT_STAY, &e) == 1)
				sum += (double)e[0].normal_impulse_Ns;
		}
		/* Gravity acts over the step, before and after the impact. */
		expected = (v + 10.0 / 60.0 + (double)fixture_velocity(world, ball).linear_mps.y) * 3.14159265 * 0.25;
		CHECK(entered);
		CHECK_LE("impulse of the drop / change of momentum - 1", fabs(sum / expected - 1.0), 5.0 * SOLVED, "");
		CHECK_GE("impulse", sum, (1.0 + (double)bounce) * 0.9 * v * 3.14159265 * 0.25, "N s");
		cn_world_destroy(world);
	}
}

/* ---- hits ---- */

/* A box tips over its lower corner: the pair touches all the time, and the far corner hits the floor. About the corner
   I = m 8 h^2 / 3, the centre falls from h (sin a + cos a) to h, and the far corner moves at 2 h w. */
static void a_tipping_box_hits_within_its_touch(void)
{
	const double h = 0.5, lean = 0.6;
	double w = sqrt(2.0 * 10.0 * h * (sin(lean) + cos(lean) - 1.0) / (8.0 * h * h / 3.0)), speed = 2.0 * h * w;
	cn_world *world = fixture_world(-10.0f, 0);
	const cn_contact_event *e = NULL;
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f), 5.0f, 0.0f);
	cn_body box = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, (float)(h * (sin(lean) + cos(lean))), (float)lean);
	int32_t step, hits = 0, enters = 0;
	cn_contact_event hit;
	memset(&hit, 0, sizeof hit);
	def.material.user_id = 7;
	fixture_box_shape(world, &def, 10.0f, 1.0f);
	def = fixture_shape_def(box, 5.0f, 0.0f);
	def.material.user_id = 9;
	def.event_mask = HITS | 1 << CN_EVENT_ENTER | 1 << CN_EVENT_LEAVE;
	fixture_box_shape(world, &def, 0.5f, 0.5f);
	for (step = 0; step < 120; ++step) {
		fixture_step(world, 1);
		enters += count_events(world, CN_EVENT_ENTER);
		if (events_of(world, CN_EVENT_HIT, &e) > 0) {
			++hits;
			hit = e[0];
		}
	}
	CHECK(enters == 1);
	CHECK(hits == 1);
	CHECK_LE("speed of the blow / closed form - 1", fabs((double)hit.approach_speed_mps / speed - 1.0), 0.02, "");
	CHECK_LE("distance of its point from the far corner", fabs((double)hit.hit_point_m.x - (h * (sin(lean) - cos(lean)) + 2.0 * h)), 0.02, "m");
	CHECK_LE("height of its point", fabs((double)hit.hit_point_m.y), 0.02, "m");
	CHECK_GE("its impulse", hit.normal_impulse_Ns, 0.25 * speed, "N s");
	CHECK(hit.kind == CN_EVENT_HIT && hit.manifold.point_count >= 1);
	CHECK((hit.body_a == box && hit.material_a == 9 && hit.material_b == 7) || (hit.body_b == box && hit.material_b == 9 && hit.material_a == 7));
	cn_world_destroy(world);
}

/* Hits of one ball dropped from 1 m: v = sqrt(2 g h) = 4.47 m/s. Returns their number in 2 s. */
static int32_t hits_of_a_drop(uint32_t mask, float hit_speed, float *out_speed)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball;
	const cn_contact_event *e;
	int32_t step, hits = 0;
	fixture_floor(world, 0.0f, 0.0f);
	must(cn_world_set_hit_speed(world, hit_speed), world, "cn_world_set_hit_speed");
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.5f, 0.0f, 0.0f);
	set_mask(world, ball, mask);
	for (step = 0; step < 120; ++step) {
		fixture_step(world, 1);
		if (events_of(world, CN_EVENT_HIT, &e) > 0 && ++hits == 1)
			*out_speed = e[0].approach_speed_mps;
	}
	cn_world_destroy(world);
	return hits;
}

static void hits_are_reported_from_the_hit_speed_on(void)
{
	float speed = 0.0f;
	CHECK(hits_of_a_drop(HITS, 1.0f, &speed) == 1);
	CHECK_LE("speed of the hit - closed form", fabs((double)speed - sqrt(20.0)), 10.0 / 60.0, "m/s"); /* what a step adds */
	CHECK(hits_of_a_drop(HITS, 4.0f, &speed) == 1);
	CHECK(hits_of_a_drop(HITS, 5.0f, &speed) == 0);
	CHECK(hits_of_a_drop(WITH_IMPULSES, 1.0f, &speed) == 0); /* no shape asks */
	CHECK_GE("hits in 2 s without a least speed", hits_of_a_drop(HITS, 0.0f, &speed), 60, ""); /* the ball at rest too */
}

/* Newton's cradle with a gap of 1 cm: each ball hits the next, and the last flies off. */
static void bouncing_bodies_hit_each_other(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body balls[4];
	int32_t k, step, hits = 0;
	double sum = 0.0, mass = 3.14159265 * 0.25;
	const cn_contact_event *e;
	for (k = 0; k < 4; ++k) {
		balls[k] = fixture_circle(world, CN_BODY_DYNAMIC, 1.01f * (float)k, 0.0f, 0.5f, 0.0f, 1.0f);
		set_mask(world, balls[k], HITS);
	}
	fixture_set_velocity(world, balls[0], 5.0f, 0.0f, 0.0f);
	for (step = 0; step < 60; ++step) {
		int32_t count;
		fixture_step(world, 1);
		count = events_of(world, CN_EVENT_HIT, &e);
		for (k = 0; k < count; ++k, ++hits) {
			sum += (double)e[k].normal_impulse_Ns;
			CHECK_LE("speed of the hit - 5 m/s", fabs((double)e[k].approach_speed_mps - 5.0), 10.0 * SOLVED, "m/s");
		}
	}
	CHECK(hits == 3);
	CHECK_LE("sum of the impulses / 3 m v - 1", fabs(sum / (3.0 * mass * 5.0) - 1.0), 10.0 * SOLVED, "");
	CHECK_LE("speed of the last ball - 5 m/s", fabs((double)fixture_velocity(world, balls[3]).linear_mps.x - 5.0), 10.0 * SOLVED, "m/s");
	cn_world_destroy(world);
}

/* ---- saves and calls between steps ---- */

static void hits_survive_their_bodies_and_a_restore(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball;
	const cn_contact_event *e;
	cn_contact_event hit;
	uint64_t bytes = 0;
	void *save;
	int32_t step;
	fixture_floor(world, 0.0f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.5f, 0.0f, 0.0f);
	set_mask(world, ball, HITS);
	for (step = 0; step < 60 && count_events(world, CN_EVENT_HIT) == 0; ++step)
		fixture_step(world, 1);
	REQUIRE(events_of(world, CN_EVENT_HIT, &e) == 1);
	hit = e[0];
	must(cn_world_save_size(world, &bytes), world, "cn_world_save_size");
	save = malloc((size_t)bytes);
	must(cn_world_save(world, save, bytes, NULL), world, "cn_world_save");
	must(cn_body_destroy(world, ball), world, "cn_body_destroy");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_HIT) == 0);
	must(cn_world_restore(world, save, bytes), world, "cn_world_restore");
	must(cn_body_destroy(world, ball), world, "cn_body_destroy");
	REQUIRE(events_of(world, CN_EVENT_HIT, &e) == 1);
	CHECK(memcmp(&hit, e, sizeof hit) == 0);
	free(save);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(impulses_account_for_momentum);
	RUN(a_stack_at_rest_reports_its_weight);
	RUN(contacts_at_rest_have_the_force_of_a_substep);
	RUN(a_drop_reports_what_stops_it);
	RUN(a_tipping_box_hits_within_its_touch);
	RUN(hits_are_reported_from_the_hit_speed_on);
	RUN(bouncing_bodies_hit_each_other);
	RUN(hits_survive_their_bodies_and_a_restore);
	return test_end();
}
