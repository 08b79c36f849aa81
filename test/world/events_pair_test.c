/*
 * test/world/events_pair_test.c - contact events of a few bodies at a time: masks, ends through calls, sleep, and manifolds
 * that tell the truth. Whole worlds are in events_test.c.
 *
 * If a test here fails, look first in: world/shape.c (masks, filters), model/contact.c (begin, end, destroy),
 * model/event.c (logs), narrowphase/narrowphase.c (changes), model/contact_lane.c (manifolds).
 */
#include "events.h"

/* ---- masks ---- */

/* The kinds heard while a ball falls, rests, and is taken away. */
static uint32_t kinds_of_a_life(uint32_t mask_a, uint32_t mask_b)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ground = fixture_floor(world, 0.5f, 0.0f), ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.5f, 0.5f, 0.0f);
	cn_vec2 away = { 0.0f, 50.0f };
	uint32_t kinds = 0;
	int32_t step, kind;
	set_mask(world, ground, mask_a);
	set_mask(world, ball, mask_b);
	for (step = 0; step < 60; ++step) {
		if (step == 50)
			must(cn_body_set_pose(world, ball, away.x, away.y, 0.0f), world, "cn_body_set_pose");
		fixture_step(world, 1);
		for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
			if (count_events(world, kind) > 0)
				kinds |= 1u << kind;
	}
	cn_world_destroy(world);
	return kinds;
}

static void a_pair_reports_what_either_asks_for(void)
{
	uint32_t a, b, wrong = 0;
	for (a = 0; a <= ALL_EVENTS; ++a)
		wrong += kinds_of_a_life(a, 0) != a || kinds_of_a_life(0, a) != a;
	for (a = 0; a < CN_EVENT_KINDS; ++a)
		for (b = 0; b < CN_EVENT_KINDS; ++b)
			wrong += kinds_of_a_life(1u << a, 1u << b) != (1u << a | 1u << b);
	CHECK_LE("masks that were not respected", wrong, 0, "");
}

/* ---- ends through calls ---- */

enum { END_DESTROY_BODY, END_DESTROY_SHAPE, END_DETACH, END_DISABLE, END_FILTER, END_TYPE, END_TELEPORT, END_JOINT, END_MANY, END_GROUND, END_WAYS };
static const char *const end_names[] = { "destroy body", "destroy shape", "detach", "disable", "filter", "type", "teleport", "joint", "destroy many", "destroy ground" };

static void end_by_call(cn_world *world, int32_t way, cn_body ground, cn_body box)
{
	cn_filter none = { 1, 0, 0, 0 };
	cn_vec2 away = { 0.0f, 50.0f };
	cn_distance_def def;
	cn_joint joint;
	cn_shape shape = fixture_first_shape(world, box);
	switch (way) {
	case END_DESTROY_BODY: must(cn_body_destroy(world, box), world, "destroy"); break;
	case END_DESTROY_SHAPE: must(cn_shape_destroy(world, shape), world, "destroy shape"); break;
	case END_DETACH: must(cn_shape_detach(world, shape), world, "detach"); break;
	case END_DISABLE: must(cn_body_set_flags(world, box, CN_BODY_SLEEP), world, "disable"); break;
	case END_FILTER: must(cn_shape_set_filter(world, shape, &none), world, "filter"); break;
	case END_TYPE: must(cn_body_set_type(world, box, CN_BODY_KINEMATIC), world, "type"); break;
	case END_TELEPORT: must(cn_body_set_pose(world, box, away.x, away.y, 0.0f), world, "teleport"); break;
	case END_JOINT:
		cn_distance_def_init(&def);
		def.base.body_a = ground;
		def.base.body_b = box;
		def.length_m = 1.5f;
		must(cn_joint_create_distance(world, &def, &joint), world, "joint");
		break;
	case END_MANY: must(cn_body_destroy_many(world, &box, 1), world, "destroy many"); break;
	default: must(cn_body_destroy(world, ground), world, "destroy ground");
	}
}

static void ends_between_steps_are_told_by_the_next_step(void)
{
	int32_t way, asleep;
	for (way = 0; way < END_WAYS; ++way)
		for (asleep = 0; asleep < 2; ++asleep) {
			cn_world *world = fixture_world(-10.0f, asleep);
			cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
			cn_shape ground_shape = fixture_first_shape(world, ground), box_shape = fixture_first_shape(world, box);
			const cn_contact_event *e;
			int32_t before;
			set_mask(world, box, ALL_EVENTS);
			fixture_step(world, 90);
			CHECK(fixture_is_awake(world, box) == !asleep);
			end_by_call(world, way, ground, box);
			before = count_events(world, CN_EVENT_LEAVE) + count_events(world, CN_EVENT_DESTROYED);
			fixture_step(world, 1);
			if (before != 0 || count_events(world, CN_EVENT_LEAVE) != 1 || count_events(world, CN_EVENT_DESTROYED) != 1 ||
			    count_events(world, CN_EVENT_STAY) + count_events(world, CN_EVENT_CREATED) != 0) {
				printf("  %s, asleep %d: before %d, leave %d, destroyed %d, stay %d, created %d\n", end_names[way], (int)asleep, (int)before, (int)count_events(world, CN_EVENT_LEAVE),
				       (int)count_events(world, CN_EVENT_DESTROYED), (int)count_events(world, CN_EVENT_STAY), (int)count_events(world, CN_EVENT_CREATED));
				CHECK(0);
			}
			if (events_of(world, CN_EVENT_LEAVE, &e) == 1)
				CHECK((e->shape_a == ground_shape && e->shape_b == box_shape && e->body_a == ground && e->body_b == box) ||
				      (e->shape_b == ground_shape && e->shape_a == box_shape && e->body_b == ground && e->body_a == box));
			CHECK(fixture_is_valid(world));
			fixture_step(world, 1);
			CHECK(count_events(world, CN_EVENT_LEAVE) + count_events(world, CN_EVENT_DESTROYED) == 0);
			cn_world_destroy(world);
		}
}

/* Calls that come after a step do not rewrite what it told. */
static void arrays_tell_of_the_last_step_only(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	(void)ground;
	set_mask(world, box, ALL_EVENTS);
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, box));
	must(cn_body_set_awake(world, box, 1), world, "wake");
	CHECK_LE("events told of a pair that slept, after waking it by a call", count_all_events(world), 0, "");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_STAY) == 1);
	must(cn_body_set_awake(world, box, 0), world, "sleep");
	fixture_step(world, 1);
	CHECK(count_all_events(world) == 0);
	cn_world_destroy(world);
}

/* ---- sleep ---- */

static void sleeping_pairs_are_silent_and_go_on(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[3];
	const cn_contact_event *e;
	uint32_t ids[2];
	int32_t k, told = 0, stays = 0;
	bodies[0] = fixture_floor(world, 0.5f, 0.0f);
	bodies[1] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	bodies[2] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	for (k = 0; k < 3; ++k)
		set_mask(world, bodies[k], ALL_EVENTS);
	fixture_step(world, 10);
	REQUIRE(events_of(world, CN_EVENT_STAY, &e) == 2);
	ids[0] = e[0].contact_id;
	ids[1] = e[1].contact_id;
	fixture_step(world, 110);
	REQUIRE(!fixture_is_awake(world, bodies[1]));
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		told += count_all_events(world);
	}
	CHECK_LE("events of sleeping pairs in 60 steps", told, 0, "");
	must(cn_body_set_awake(world, bodies[2], 1), world, "wake");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_ENTER) + count_events(world, CN_EVENT_CREATED) + count_events(world, CN_EVENT_LEAVE) == 0);
	stays = events_of(world, CN_EVENT_STAY, &e);
	REQUIRE(stays == 2);
	CHECK((e[0].contact_id == ids[0] && e[1].contact_id == ids[1]) || (e[0].contact_id == ids[1] && e[1].contact_id == ids[0]));
	for (k = 0; k < 2; ++k) {
		int32_t on_ground = e[k].body_a == bodies[0] || e[k].body_b == bodies[0];
		double load = (on_ground ? 2.0 : 1.0) * 10.0 / 240.0; /* N s in a substep */
		double impulse = (double)e[k].manifold.points[0].normal_impulse_Ns + (double)e[k].manifold.points[1].normal_impulse_Ns;
		CHECK_LE("error of the impulse in the first step awake / load", fabs(impulse / load - 1.0), 5.0 * SOLVED, "");
	}
	cn_world_destroy(world);
}

/* ---- truth ---- */

typedef struct truth {
	double normal_error;  /* | |n| - 1 | */
	int32_t backwards;    /* normals that do not point from a to b */
	int32_t outside;      /* points that are not between the two shapes */
	int32_t points, bad_counts;
} truth;

/* The surface point moved a little towards the shape's middle must be inside of the shape. */
static int32_t is_on(const cn_world *world, cn_shape shape, cn_vec2 p, float nudge)
{
	cn_aabb box;
	cn_vec2 d;
	float length;
	int32_t inside = 0;
	must(cn_shape_get_aabb(world, shape, &box), world, "cn_shape_get_aabb");
	d.x = 0.5f * (box.lower_m.x + box.upper_m.x) - p.x;
	d.y = 0.5f * (box.lower_m.y + box.upper_m.y) - p.y;
	length = (float)hypot((double)d.x, (double)d.y);
	nudge = length > nudge ? nudge / length : 1.0f;
	p.x += nudge * d.x;
	p.y += nudge * d.y;
	must(cn_shape_test_point(world, shape, p.x, p.y, &inside), world, "cn_shape_test_point");
	return inside;
}

/* What is allowed: 2 cm, and how far the surfaces turned in the step (points follow how bodies move, not how
   they turn in it). */
static float nudge_of(const cn_world *world, const cn_contact_event *e)
{
	float w = fabsf(fixture_velocity(world, e->body_a).angular_radps) + fabsf(fixture_velocity(world, e->body_b).angular_radps);
	return 0.02f + w * FRAME_S * 0.5f;
}

static void truth_of(truth *t, const cn_world *world, const cn_contact_event *e)
{
	const cn_manifold *m = &e->manifold;
	cn_aabb a, b;
	float along, nudge = nudge_of(world, e);
	int32_t k;
	must(cn_shape_get_aabb(world, e->shape_a, &a), world, "cn_shape_get_aabb");
	must(cn_shape_get_aabb(world, e->shape_b, &b), world, "cn_shape_get_aabb");
	along = m->normal.x * (b.lower_m.x + b.upper_m.x - a.lower_m.x - a.upper_m.x) + m->normal.y * (b.lower_m.y + b.upper_m.y - a.lower_m.y - a.upper_m.y);
	t->normal_error = greater(t->normal_error, fabs(hypot((double)m->normal.x, (double)m->normal.y) - 1.0));
	t->backwards += along <= 0.0f;
	t->bad_counts += m->point_count < 1 || m->point_count > 2;
	for (k = 0; k < m->point_count; ++k) {
		float half = 0.5f * m->points[k].separation_m;
		cn_vec2 on_a = m->points[k].point_m, on_b = on_a;
		on_a.x -= half * m->normal.x;
		on_a.y -= half * m->normal.y;
		on_b.x += half * m->normal.x;
		on_b.y += half * m->normal.y;
		++t->points;
		t->outside += !is_on(world, e->shape_a, on_a, nudge) || !is_on(world, e->shape_b, on_b, nudge);
	}
}

static void churn_truths(float spin, uint32_t seed, truth *enter, truth *stay)
{
	churn c;
	const cn_contact_event *e;
	int32_t step, kind, k, count;
	memset(&c, 0, sizeof c);
	c.world = fixture_world(-10.0f, 0);
	c.seed = seed;
	c.mask = ALL_EVENTS;
	for (k = 0; k < 3; ++k) {
		cn_shape_def def = fixture_shape_def(fixture_body(c.world, CN_BODY_STATIC, 11.0f * (float)(k - 1), k == 1 ? -5.0f : 5.0f, 0.0f), 0.5f, 0.0f);
		fixture_box_shape(c.world, &def, k == 1 ? 8.0f : 3.0f, k == 1 ? 5.0f : 8.0f);
	}
	for (k = 0; k < 150; ++k) {
		c.bodies[k] = fixture_body(c.world, CN_BODY_DYNAMIC, 1.2f * (float)(k % 10) - 5.4f, 0.8f + 1.1f * (float)(k / 10), churn_random(&c, -3.0f, 3.0f));
		churn_shape(&c, c.bodies[k]);
		fixture_set_velocity(c.world, c.bodies[k], 0.0f, -4.0f, spin * churn_random(&c, -1.0f, 1.0f));
	}
	for (step = 0; step < 180; ++step) {
		fixture_step(c.world, 1);
		for (kind = CN_EVENT_ENTER; kind <= CN_EVENT_STAY; ++kind) {
			count = events_of(c.world, kind, &e);
			for (k = 0; k < count; ++k)
				truth_of(kind == CN_EVENT_ENTER ? enter : stay, c.world, &e[k]);
		}
	}
	cn_world_destroy(c.world);
}

/* Of 740 points at enter some 3 lie outside (0 to 8): one crowd would be a matter of luck. */
static void manifolds_lie_between_their_shapes(void)
{
	static const float spins[] = { 0.0f, 2.0f };
	size_t s;
	for (s = 0; s < 2; ++s) {
		truth enter = { 0.0, 0, 0, 0, 0 }, stay = { 0.0, 0, 0, 0, 0 };
		uint32_t seed;
		for (seed = 97; seed < 97 + TEST_MANY(6); ++seed)
			churn_truths(spins[s], seed, &enter, &stay);
		printf("  spin %.0f rad/s: %d points at enter, %d at stay\n", (double)spins[s], (int)enter.points, (int)stay.points);
		CHECK_LE("length of normals - 1", fmax(enter.normal_error, stay.normal_error), 1e-5, "");
		CHECK_LE("manifolds without points, or with too many", enter.bad_counts + stay.bad_counts, 0, "");
		CHECK_LE("normals that point from b to a", enter.backwards + stay.backwards, 0, "");
		CHECK_LE("share of points at enter that are not between the shapes", (double)enter.outside / (double)enter.points, 0.01, "");
		CHECK_LE("share of points at stay that are not between the shapes", (double)stay.outside / (double)stay.points, 0.002, "");
		CHECK_GE("points at stay", stay.points, 16000 * TEST_MANY(6), "");
	}
}

/* As of the end of the step, says the header: also for what moves fast. */
static void separation_is_that_at_the_end_of_the_step(void)
{
	static const float speeds[] = { 0.5f, 5.0f, 20.0f };
	size_t s;
	for (s = 0; s < 3; ++s) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body ground = fixture_floor(world, 0.5f, 0.0f), ball;
		const cn_contact_event *e;
		double worst = 0.0, worst_point = 0.0;
		int32_t k, seen = 0;
		(void)ground;
		ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.3f, 1.0f, 0.5f, 0.5f, 0.7f);
		set_mask(world, ball, ALL_EVENTS);
		fixture_set_velocity(world, ball, 0.0f, -speeds[s], 0.0f);
		for (k = 0; k < 120; ++k) {
			int32_t kind;
			fixture_step(world, 1);
			for (kind = CN_EVENT_ENTER; kind <= CN_EVENT_STAY; ++kind)
				if (events_of(world, kind, &e) == 1) {
					double gap = (double)fixture_pose(world, ball).position_m.y - 0.5;
					worst = greater(worst, fabs((double)e->manifold.points[0].separation_m - gap));
					worst_point = greater(worst_point, fabs((double)e->manifold.points[0].point_m.y - 0.5 * gap));
					++seen;
				}
		}
		printf("  %.1f m/s\n", (double)speeds[s]);
		CHECK(seen > 0);
		CHECK_LE("separation - gap at the end of the step", worst, 1e-5, "m");
		CHECK_LE("height of the point - half the gap", worst_point, 1e-5, "m");
		cn_world_destroy(world);
	}
}

static void approach_speed_is_that_of_the_fall(void)
{
	static const float heights[] = { 0.2f, 1.0f, 5.0f, 20.0f };
	size_t i;
	int32_t flip;
	for (i = 0; i < 4; ++i)
		for (flip = 0; flip < 2; ++flip) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body ball;
			const cn_contact_event *e;
			double v = sqrt(2.0 * 10.0 * (double)heights[i]), told = -1.0, other = 0.0;
			int32_t k;
			if (flip) /* circle a, box b */
				fixture_floor(world, 0.5f, 0.0f);
			else /* circle against circle */
				fixture_circle(world, CN_BODY_STATIC, 0.0f, -50.0f, 50.0f, 0.5f, 0.0f);
			ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + heights[i], 0.5f, 0.5f, 0.0f);
			set_mask(world, ball, ALL_EVENTS);
			for (k = 0; k < 180; ++k) {
				int32_t kind;
				fixture_step(world, 1);
				for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
					if (events_of(world, kind, &e) > 0) {
						if (kind == CN_EVENT_ENTER && told < 0.0)
							told = (double)e->approach_speed_mps;
						else if (kind != CN_EVENT_ENTER && kind != CN_EVENT_HIT)
							other = greater(other, fabs((double)e->approach_speed_mps));
					}
			}
			printf("  from %.1f m: %.3f m/s, exact %.3f\n", (double)heights[i], told, v);
			CHECK_LE("approach speed - speed of the fall", fabs(told - v), 10.0 / 60.0 + 1e-3, "m/s"); /* what a step adds */
			CHECK_LE("approach speed of other kinds", other, 0.0, "m/s");
			cn_world_destroy(world);
		}
}

/* ---- masks that change ---- */

static void a_mask_takes_effect_on_present_contacts(void)
{
	int32_t asleep;
	for (asleep = 0; asleep < 2; ++asleep) {
		cn_world *world = fixture_world(-10.0f, asleep);
		cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
		set_mask(world, ground, 0);
		set_mask(world, box, 0);
		fixture_step(world, 90);
		set_mask(world, box, ALL_EVENTS); /* opens what is there */
		if (asleep) {
			fixture_step(world, 1);
			CHECK(count_all_events(world) == 0);
			must(cn_body_set_awake(world, box, 1), world, "wake");
		}
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_CREATED) == 1 && count_events(world, CN_EVENT_ENTER) == 1 && count_events(world, CN_EVENT_STAY) == 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_STAY) == 1 && count_all_events(world) == 1);
		set_mask(world, box, 1u << CN_EVENT_STAY); /* closes it */
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_LEAVE) == 1 && count_events(world, CN_EVENT_DESTROYED) == 1 && count_events(world, CN_EVENT_STAY) == 1);
		set_mask(world, ground, TOUCH_EVENTS); /* the other shape asks */
		set_mask(world, box, 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_ENTER) == 1 && count_all_events(world) == 1);
		set_mask(world, box, TOUCH_EVENTS); /* both ask: nothing new */
		set_mask(world, ground, 0);
		fixture_step(world, 1);
		CHECK(count_all_events(world) == 0);
		set_mask(world, box, 0); /* closed and opened between two steps */
		set_mask(world, box, TOUCH_EVENTS);
		set_mask(world, box, 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_LEAVE) == 1 && count_all_events(world) == 1);
		must(cn_body_destroy(world, box), world, "destroy");
		fixture_step(world, 1);
		CHECK(count_all_events(world) == 0);
		cn_world_destroy(world);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(a_pair_reports_what_either_asks_for);
	RUN(ends_between_steps_are_told_by_the_next_step);
	RUN(arrays_tell_of_the_last_step_only);
	RUN(sleeping_pairs_are_silent_and_go_on);
	RUN(manifolds_lie_between_their_shapes);
	RUN(separation_is_that_at_the_end_of_the_step);
	RUN(approach_speed_is_that_of_the_fall);
	RUN(a_mask_takes_effect_on_present_contacts);
	return test_end();
}
