/*
 * test/world/sensor_test.c - sensors, one-way platforms, and the callbacks that let pairs pass.
 *
 * If a test here fails, look first in: narrowphase/narrowphase.c (sensors, one-way, pre-solve), model/contact.c
 * (bookends, filter callback), world/shape.c (flags).
 */
#include "fixture.h"

#define GRAVITY 10.0

/* ---- book of who is in which sensor ---- */

#define BOOK 256
typedef struct book {
	cn_shape sensor[BOOK], visitor[BOOK];
	int32_t count;        /* inside now, by the events */
	int32_t enters, leaves;
	int32_t broken;       /* events that did not match */
	uint64_t hash;        /* of the whole sequence */
} book;

static void book_read(const cn_world *world, book *b)
{
	const cn_sensor_event *e;
	int32_t n, k, i;
	must(cn_world_sensor_events(world, &e, &n), world, "cn_world_sensor_events");
	for (k = 0; k < n; ++k) {
		for (i = 0; i < b->count && !(b->sensor[i] == e[k].sensor && b->visitor[i] == e[k].visitor); ++i)
			;
		b->hash = (((b->hash ^ e[k].sensor) * 1099511628211u ^ e[k].visitor) * 1099511628211u ^ (uint64_t)e[k].kind) * 1099511628211u;
		if (e[k].kind == CN_EVENT_ENTER) {
			++b->enters;
			if (i < b->count || b->count == BOOK) {
				++b->broken;
				continue;
			}
			b->sensor[b->count] = e[k].sensor;
			b->visitor[b->count++] = e[k].visitor;
		} else {
			++b->leaves;
			if (i == b->count || e[k].kind != CN_EVENT_LEAVE) {
				++b->broken;
				continue;
			}
			--b->count;
			b->sensor[i] = b->sensor[b->count];
			b->visitor[i] = b->visitor[b->count];
		}
	}
}

static void step_and_read(cn_world *world, book *b, int32_t steps)
{
	while (steps-- > 0) {
		fixture_step(world, 1);
		book_read(world, b);
	}
}

static cn_shape sensor_box(cn_world *world, int32_t type, float x, float y, float half, cn_body *out_body)
{
	cn_body body = fixture_body(world, type, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.5f);
	def.flags = CN_SHAPE_SENSOR;
	if (out_body != NULL)
		*out_body = body;
	return fixture_box_shape(world, &def, half, half);
}

static cn_shape shape_of(const cn_world *world, cn_body body)
{
	cn_shape shape = 0;
	int32_t count;
	must(cn_body_get_shapes(world, body, &shape, 1, &count), world, "cn_body_get_shapes");
	return shape;
}

/* ---- sensors ---- */

static void sensor_touches_nothing(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	book b = { 0 };
	cn_body ball;
	int32_t k;
	double worst = 0.0;
	sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.25f, 0.6f, 0.5f);
	for (k = 1; k <= 120; ++k) {
		double t = k / 60.0, error;
		step_and_read(world, &b, 1);
		error = fabs((double)fixture_pose(world, ball).position_m.y - (5.0 - 0.5 * GRAVITY * t * t));
		worst = error > worst ? error : worst;
	}
	CHECK_LE("error of the fall through a sensor", worst, 1e-4, "m");
	CHECK(b.enters == 1 && b.leaves == 1 && b.broken == 0 && b.count == 0);
	CHECK(fixture_counters(world).contacts_touching == 0);
	cn_world_destroy(world);
}

/* Entering is told in the step whose start finds an overlap. */
static void sensor_is_exact(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	book b = { 0 };
	cn_body ball;
	float enter_x = -9.0f, leave_x = -9.0f;
	int32_t k;
	sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, -2.0f, 0.0f, 0.25f, 0.6f, 0.0f);
	fixture_set_velocity(world, ball, 0.6f, 0.0f, 0.0f); /* 1 cm a step */
	for (k = 0; k < 420; ++k) {
		float x = fixture_pose(world, ball).position_m.x;
		int32_t enters = b.enters, leaves = b.leaves;
		step_and_read(world, &b, 1);
		enter_x = b.enters > enters ? x : enter_x;
		leave_x = b.leaves > leaves ? x : leave_x;
	}
	CHECK_LE("entered off the surface by", fabs((double)enter_x + 1.25), 0.01 + ROUNDING, "m");
	CHECK_LE("left off the surface by", fabs((double)leave_x - 1.25), 0.01 + ROUNDING, "m");
	cn_world_destroy(world);
}

static void sensor_sees_what_it_should(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	book b = { 0 };
	cn_shape fixed = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL), moving;
	cn_body dynamic, kinematic, mover;
	int32_t k;
	dynamic = fixture_circle(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.1f, 0.6f, 0.0f);
	kinematic = fixture_circle(world, CN_BODY_KINEMATIC, -0.5f, 0.0f, 0.1f, 0.6f, 0.0f);
	fixture_circle(world, CN_BODY_STATIC, 0.0f, 0.5f, 0.1f, 0.6f, 0.0f);
	sensor_box(world, CN_BODY_DYNAMIC, 0.0f, -0.5f, 0.1f, NULL);
	step_and_read(world, &b, 2);
	CHECK(b.count == 2);
	for (k = 0; k < b.count; ++k)
		CHECK(b.sensor[k] == fixed && (b.visitor[k] == shape_of(world, dynamic) || b.visitor[k] == shape_of(world, kinematic)));
	/* a sensor on a kinematic body comes by */
	moving = sensor_box(world, CN_BODY_KINEMATIC, -5.0f, 0.0f, 0.3f, &mover);
	fixture_set_velocity(world, mover, 5.0f, 0.0f, 0.0f);
	step_and_read(world, &b, 120);
	CHECK(b.enters == 4 && b.leaves == 2 && b.broken == 0);
	for (k = 0; k < b.count; ++k)
		CHECK(b.sensor[k] == fixed);
	CHECK(cn_shape_is_valid(world, moving));
	cn_world_destroy(world);
}

/* Each event names the bodies of its sensor and of its visitor, whichever of the two has the lesser type. */
static void events_name_their_bodies(void)
{
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		const cn_sensor_event *e = NULL;
		cn_body round = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), square = fixture_body(world, CN_BODY_DYNAMIC, 0.3f, 0.0f, 0.0f);
		cn_shape_def circle_def = fixture_shape_def(round, 0.6f, 0.0f), box_def = fixture_shape_def(square, 0.6f, 0.0f);
		cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
		cn_shape ball = 0, box;
		int32_t count = 0;
		circle_def.flags = k == 0 ? CN_SHAPE_SENSOR : 0u;
		box_def.flags = k == 1 ? CN_SHAPE_SENSOR : 0u;
		must(cn_shape_create_circle(world, &circle_def, &circle, &ball), world, "cn_shape_create_circle");
		box = fixture_box_shape(world, &box_def, 0.5f, 0.5f);
		fixture_step(world, 1);
		must(cn_world_sensor_events(world, &e, &count), world, "cn_world_sensor_events");
		REQUIRE(count == 1);
		CHECK(e->sensor == (k == 0 ? ball : box) && e->sensor_body == (k == 0 ? round : square));
		CHECK(e->visitor == (k == 0 ? box : ball) && e->visitor_body == (k == 0 ? square : round));
		cn_world_destroy(world);
	}
}

enum { END_DESTROY_BODY, END_DESTROY_SHAPE, END_DESTROY_SENSOR, END_TELEPORT, END_DISABLE, END_FLAGS, END_DETACH, END_FILTER, END_TYPE, ENDS };

static void every_end_is_told_once(void)
{
	static const char *const names[] = { "destroy body", "destroy shape", "destroy sensor", "teleport", "disable", "flags", "detach", "filter", "type static" };
	int32_t how;
	for (how = 0; how < ENDS; ++how) {
		cn_world *world = fixture_world(0.0f, 1);
		book b = { 0 };
		cn_shape sensor = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL), shape;
		cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.5f, 0.0f, 0.1f, 0.6f, 0.0f);
		cn_filter none = { 0, 0, 0, 0 };
		shape = shape_of(world, ball);
		step_and_read(world, &b, how & 1 ? 2 : 90); /* awake, or asleep */
		CHECK(b.enters == 1 && b.count == 1);
		switch (how) {
		case END_DESTROY_BODY: must(cn_body_destroy(world, ball), world, "end"); break;
		case END_DESTROY_SHAPE: must(cn_shape_destroy(world, shape), world, "end"); break;
		case END_DESTROY_SENSOR: must(cn_shape_destroy(world, sensor), world, "end"); break;
		case END_TELEPORT: must(cn_body_set_pose(world, ball, 20.0f, 0.0f, 0.0f), world, "end"); break;
		case END_DISABLE: must(cn_body_set_flags(world, ball, CN_BODY_SLEEP), world, "end"); break;
		case END_FLAGS: must(cn_shape_set_flags(world, sensor, 0u), world, "end"); break;
		case END_DETACH: must(cn_shape_detach(world, shape), world, "end"); break;
		case END_FILTER: must(cn_shape_set_filter(world, shape, &none), world, "end"); break;
		default: must(cn_body_set_type(world, ball, CN_BODY_STATIC), world, "end"); break;
		}
		step_and_read(world, &b, 3);
		if (b.leaves != 1 || b.enters != 1 || b.count != 0 || b.broken != 0)
			printf("  %s: %d enters, %d leaves, %d broken\n", names[how], (int)b.enters, (int)b.leaves, (int)b.broken);
		CHECK(b.enters == 1 && b.leaves == 1 && b.count == 0 && b.broken == 0);
		CHECK(fixture_is_valid(world));
		/* and back again, where it can */
		if (how == END_TELEPORT || how == END_DISABLE || how == END_FLAGS || how == END_DETACH || how == END_TYPE) {
			if (how == END_TELEPORT)
				must(cn_body_set_pose(world, ball, 0.5f, 0.0f, 0.0f), world, "back");
			else if (how == END_DISABLE)
				must(cn_body_set_flags(world, ball, CN_BODY_SLEEP | CN_BODY_ENABLED), world, "back");
			else if (how == END_FLAGS) {
				must(cn_shape_set_flags(world, sensor, CN_SHAPE_SENSOR), world, "back");
				must(cn_body_set_pose(world, ball, 0.5f, 0.0f, 0.0f), world, "back");
			} else if (how == END_DETACH)
				must(cn_shape_attach(world, shape, ball), world, "back");
			else
				must(cn_body_set_type(world, ball, CN_BODY_DYNAMIC), world, "back");
			step_and_read(world, &b, 3);
			if (b.enters != 2)
				printf("  %s and back: %d enters\n", names[how], (int)b.enters);
			CHECK(b.enters == 2 && b.leaves == 1 && b.broken == 0);
		}
		cn_world_destroy(world);
	}
}

/* A sensor reports who enters and leaves, whatever contact events its visitors ask for meanwhile. */
static void masks_of_visitors_do_not_matter(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body ball = fixture_circle(world, CN_BODY_DYNAMIC, -3.0f, 0.0f, 0.3f, 0.5f, 0.0f);
	const cn_contact_event *events;
	int32_t k, kind, count, contacts = 0;
	book b;
	memset(&b, 0, sizeof b);
	sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL);
	fixture_set_velocity(world, ball, 3.0f, 0.0f, 0.0f);
	for (k = 0; k < 120; ++k) {
		must(cn_shape_set_event_mask(world, shape_of(world, ball), k % 3 == 0 ? 0u : (1u << CN_EVENT_KINDS) - 1u), world, "cn_shape_set_event_mask");
		step_and_read(world, &b, 1);
		for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
			must(cn_world_contact_events(world, kind, &events, &count), world, "cn_world_contact_events");
			contacts += count;
		}
	}
	CHECK(b.enters == 1 && b.leaves == 1 && b.broken == 0);
	CHECK(contacts == 0 && fixture_is_valid(world));
	cn_world_destroy(world);
}

static void sleeping_is_not_leaving(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	book b = { 0 };
	cn_body box;
	fixture_floor(world, 0.6f, 0.0f);
	sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 2.0f, NULL);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	step_and_read(world, &b, 180);
	CHECK(!fixture_is_awake(world, box));
	CHECK(b.enters == 1 && b.leaves == 0);
	must(cn_body_set_awake(world, box, 1), world, "wake");
	step_and_read(world, &b, 10);
	CHECK(b.enters == 1 && b.leaves == 0);
	fixture_set_velocity(world, box, 10.0f, 8.0f, 0.0f);
	step_and_read(world, &b, 120);
	CHECK(b.enters == 1 && b.leaves == 1 && b.broken == 0);
	cn_world_destroy(world);
}

/* 60 bodies rain through 9 sensors while some are destroyed and teleported. */
static uint64_t rain(book *b)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[60];
	uint32_t random = 123456789u;
	int32_t k, step;
	memset(b, 0, sizeof *b);
	fixture_floor(world, 0.6f, 0.2f);
	for (k = 0; k < 9; ++k)
		sensor_box(world, k % 3 == 0 ? CN_BODY_KINEMATIC : CN_BODY_STATIC, -4.0f + (float)k, 0.5f + 0.5f * (float)(k % 4), 0.7f, NULL);
	for (k = 0; k < 60; ++k) {
		float x = fixture_random(&random, -4.0f, 4.0f), y = fixture_random(&random, 2.0f, 12.0f);
		bodies[k] = fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.2f, 0.6f, 0.2f);
	}
	for (step = 0; step < 240; ++step) {
		step_and_read(world, b, 1);
		if (step % 20 == 10 && step / 20 < 6)
			must(cn_body_destroy(world, bodies[step / 20]), world, "destroy");
		if (step % 20 == 15)
			must(cn_body_set_pose(world, bodies[10 + step / 20], fixture_random(&random, -4.0f, 4.0f), 5.0f, 0.0f), world, "teleport");
	}
	for (k = 6; k < 60; ++k)
		must(cn_body_destroy(world, bodies[k]), world, "destroy");
	step_and_read(world, b, 1);
	cn_world_destroy(world);
	return b->hash;
}

/* A chain of three edges passes: one visitor. */
static void a_chain_enters_once(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_vec2 points[4] = { { 0.6f, 0.0f }, { 0.2f, 0.0f }, { -0.2f, 0.0f }, { -0.6f, 0.0f } };
	cn_chain chain = { points, 4, 0 };
	cn_body passing = fixture_body(world, CN_BODY_KINEMATIC, -5.0f, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(passing, 0.6f, 0.0f);
	cn_contact_event contacts[4];
	book b;
	int32_t count = -1;
	memset(&b, 0, sizeof b);
	must(cn_shape_create_chain(world, &def, &chain, NULL), world, "cn_shape_create_chain");
	sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, NULL);
	fixture_set_velocity(world, passing, 6.0f, 0.0f, 0.0f);
	step_and_read(world, &b, 50);
	CHECK(b.enters == 1 && b.count == 1);
	must(cn_body_get_contacts(world, passing, contacts, 4, &count), world, "cn_body_get_contacts");
	CHECK(count == 0); /* those of sensors have events of their own */
	step_and_read(world, &b, 70);
	CHECK(b.enters == 1 && b.leaves == 1 && b.broken == 0);
	cn_world_destroy(world);
}

/* A shape of each kind, half a metre around the origin of its body. */
static cn_shape round_or_square(cn_world *world, const cn_shape_def *def, int32_t kind)
{
	static const cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
	static const cn_capsule capsule = { { -0.2f, 0.0f }, { 0.2f, 0.0f }, 0.5f };
	cn_shape shape = 0;
	if (kind == 0)
		must(cn_shape_create_circle(world, def, &circle, &shape), world, "cn_shape_create_circle");
	else if (kind == 1)
		must(cn_shape_create_capsule(world, def, &capsule, &shape), world, "cn_shape_create_capsule");
	else
		shape = fixture_box_shape(world, def, 0.5f, 0.5f);
	return shape;
}

/* Visitors of a sensor, of a shape and a chain from +x to -x or back, where the shape's centre is this high over the chain. */
static int32_t visitors_at(float height, int32_t kind, int32_t chain_senses, float turned)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_vec2 points[3] = { { 2.0f, 0.0f }, { 0.1f, 0.0f }, { -2.0f, 0.0f } };
	cn_chain chain = { points, 3, 0 };
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, turned), 0.6f, 0.0f);
	cn_shape shapes[2];
	int32_t count = -1;
	def.flags = chain_senses ? CN_SHAPE_SENSOR : 0;
	must(cn_shape_create_chain(world, &def, &chain, &shapes[1]), world, "cn_shape_create_chain");
	def.flags = chain_senses ? 0 : CN_SHAPE_SENSOR;
	def.body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, height, 0.0f);
	shapes[0] = round_or_square(world, &def, kind);
	fixture_step(world, 2);
	must(cn_shape_get_visitors(world, shapes[chain_senses], NULL, 0, &count), world, "cn_shape_get_visitors");
	cn_world_destroy(world);
	return count;
}

/* For sensors a chain is a line: its back counts as its front does. */
static void a_chain_has_two_sides_for_sensors(void)
{
	static const float heights[] = { -0.51f, -0.49f, -0.3f, 0.0f, 0.3f, 0.49f, 0.51f };
	int32_t kind, senses, turned, k, right = 0;
	for (kind = 0; kind < 3; ++kind)
		for (senses = 0; senses < 2; ++senses)
			for (turned = 0; turned < 2; ++turned)
				for (k = 0; k < 7; ++k)
					right += visitors_at(heights[k], kind, senses, 3.1415927f * (float)turned) == (k > 0 && k < 6);
	printf("  %d of 84 places seen as overlap or not\n", right);
	CHECK(right == 84);
}

static void order_is_deterministic(void)
{
	static book first, second;
	CHECK(rain(&first) == rain(&second));
	printf("  %d enters, %d leaves\n", (int)first.enters, (int)first.leaves);
	CHECK(first.enters > 100 && first.enters == first.leaves && first.broken == 0 && first.count == 0);
}

/* ---- one-way platforms ---- */

static cn_body platform(cn_world *world, float y, float angle)
{
	cn_body body = fixture_body(world, CN_BODY_STATIC, 0.0f, y, angle);
	cn_shape_def def = fixture_shape_def(body, 0.0f, 0.0f);
	def.flags = CN_SHAPE_ONE_WAY;
	fixture_box_shape(world, &def, 2.0f, 0.1f);
	return body;
}

static void body_jumps_through_and_lands(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body box;
	double apex = 0.0;
	int32_t k;
	fixture_floor(world, 0.0f, 0.0f);
	platform(world, 3.0f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.25f, 0.0f, 0.25f, 0.25f, 0.0f, 0.0f);
	fixture_step(world, 10);
	fixture_set_velocity(world, box, 0.0f, 10.0f, 0.0f);
	for (k = 0; k < 150; ++k) {
		double y;
		fixture_step(world, 1);
		y = (double)fixture_pose(world, box).position_m.y;
		apex = y > apex ? y : apex;
	}
	CHECK_LE("error of the height of the jump", fabs(apex - 5.25), 2.0 * ROUNDING, "m");
	CHECK_LE("error of the height on the platform", fabs((double)fixture_pose(world, box).position_m.y - 3.35), SAG_M, "m");
	fixture_set_velocity(world, box, 3.0f, 0.0f, 0.0f); /* walks off */
	fixture_step(world, 150);
	CHECK_LE("error of the height after walking off", fabs((double)fixture_pose(world, box).position_m.y - 0.25), SAG_M, "m");
	cn_world_destroy(world);
}

static void fall_from_above_stays(void)
{
	static const float falls[] = { 1.0f, 20.0f, 100.0f, 400.0f };
	size_t k;
	for (k = 0; k < 4; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 5.37f, 0.0f, 0.25f, 0.25f, 0.0f, 0.0f);
		platform(world, 3.0f, 0.0f);
		fixture_set_velocity(world, box, 0.0f, -falls[k], 0.0f);
		fixture_step(world, 120);
		printf("  thrown down at %g m/s\n", (double)falls[k]);
		CHECK_LE("error of the height on the platform", fabs((double)fixture_pose(world, box).position_m.y - 3.35), SAG_M, "m");
		cn_world_destroy(world);
	}
}

typedef struct pass_case {
	float angle;  /* of the platform */
	float vx, vy; /* the body starts 3 m before the platform's middle */
	int32_t stops;
} pass_case;

static void platform_stops_one_side_only(void)
{
	const float quarter = 1.57079633f, half = 3.14159265f;
	const pass_case cases[] = {
		{ 0.0f, 1.0f, 0.0f, 0 }, { 0.0f, -1.0f, 0.0f, 0 }, { 0.0f, 0.0f, 1.0f, 0 }, { 0.0f, 0.0f, -1.0f, 1 },
		{ quarter, 1.0f, 0.0f, 1 }, { quarter, -1.0f, 0.0f, 0 }, { quarter, 0.0f, 1.0f, 0 }, { quarter, 0.0f, -1.0f, 0 }, /* up is -x */
		{ half, 0.0f, 1.0f, 1 }, { half, 0.0f, -1.0f, 0 }, { half, 1.0f, 0.0f, 0 },
	};
	static const float speeds[] = { 3.0f, 30.0f, 200.0f };
	size_t k, s;
	double worst = 0.0;
	for (k = 0; k < sizeof cases / sizeof *cases; ++k)
		for (s = 0; s < 3; ++s) {
			const pass_case *c = cases + k;
			cn_world *world = fixture_world(0.0f, 0);
			cn_body box = fixture_box(world, CN_BODY_DYNAMIC, -3.0f * c->vx, -3.0f * c->vy, 0.0f, 0.2f, 0.2f, 0.0f, 0.0f);
			cn_velocity v;
			double change, along;
			platform(world, 0.0f, c->angle);
			fixture_set_velocity(world, box, speeds[s] * c->vx, speeds[s] * c->vy, 0.0f);
			fixture_step(world, 120);
			v = fixture_velocity(world, box);
			along = (double)(fixture_pose(world, box).position_m.x * c->vx + fixture_pose(world, box).position_m.y * c->vy);
			change = fmax(fabs((double)v.linear_mps.x - (double)(speeds[s] * c->vx)), fabs((double)v.linear_mps.y - (double)(speeds[s] * c->vy)));
			if (c->stops ? along > -0.29 : change > 1e-5)
				printf("  platform at %g rad, direction (%g, %g), %g m/s: at %g, changed by %g\n", (double)c->angle, (double)c->vx, (double)c->vy, (double)speeds[s], along, change);
			if (c->stops)
				CHECK(along <= -0.29);
			else
				worst = change > worst ? change : worst;
			cn_world_destroy(world);
		}
	CHECK_LE("velocity changed while passing", worst, 1e-5, "m/s");
}

/* ---- pre-solve ---- */

typedef struct watcher {
	int32_t calls, enters, unlocked, bad;
	int32_t pass_from, pass_to; /* steps in which the pair passes */
	int32_t step;
} watcher;

static int32_t watch(cn_world *world, const cn_contact_event *e, void *user)
{
	watcher *w = (watcher *)user;
	cn_pose pose;
	++w->calls;
	w->enters += e->kind == CN_EVENT_ENTER;
	w->unlocked += cn_world_step(world, FRAME_S) != CN_ERROR_LOCKED;
	w->unlocked += cn_body_set_velocity(world, e->body_b, 0.0f, 0.0f, 0.0f) != CN_ERROR_LOCKED;
	w->bad += cn_body_get_pose(world, e->body_a, &pose) != CN_OK;
	w->bad += e->kind != CN_EVENT_ENTER && e->kind != CN_EVENT_STAY;
	w->bad += e->manifold.point_count < 1 || e->manifold.point_count > 2;
	w->bad += fabsf(fabsf(e->manifold.normal.y) - 1.0f) > 1e-3f;
	return w->step < w->pass_from || w->step >= w->pass_to;
}

static cn_body watched_box(cn_world *world, watcher *w, cn_shape *out_shape)
{
	cn_body box = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.25f, 0.0f);
	cn_shape_def def = fixture_shape_def(box, 0.6f, 0.0f);
	cn_shape shape;
	def.flags = CN_SHAPE_PRE_SOLVE;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -0.05f, 0.0f, 10.0f, 0.05f, 0.6f, 0.0f);
	shape = fixture_box_shape(world, &def, 0.25f, 0.25f);
	if (out_shape != NULL)
		*out_shape = shape;
	must(cn_world_set_pre_solve_callback(world, watch, w), world, "cn_world_set_pre_solve_callback");
	return box;
}

static void pre_solve_lets_pass_in_chosen_steps(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	watcher w = { 0, 0, 0, 0, 60, 64, 0 };
	cn_body box = watched_box(world, &w, NULL);
	double lowest = 1.0, speed = 0.0;
	for (w.step = 0; w.step < 240; ++w.step) {
		double y;
		fixture_step(world, 1);
		y = (double)fixture_pose(world, box).position_m.y;
		lowest = y < lowest ? y : lowest;
		if (w.step == 59)
			CHECK_LE("error of the height before", fabs(y - 0.25), SAG_M, "m");
		if (w.step == 63)
			speed = (double)fixture_velocity(world, box).linear_mps.y;
	}
	CHECK_LE("error of the speed after passing for 4 steps", fabs(speed + GRAVITY * 4.0 / 60.0), ROUNDING, "m/s");
	CHECK_LE("error of the height after", fabs((double)fixture_pose(world, box).position_m.y - 0.25), SAG_M, "m");
	printf("  %d calls, lowest %.4f m\n", (int)w.calls, lowest);
	CHECK(w.calls == 240 && w.enters == 1 && w.unlocked == 0 && w.bad == 0);
	cn_world_destroy(world);
}

static void pre_solve_lets_fall_through(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	watcher w = { 0, 0, 0, 0, 0, 1000, 0 };
	cn_body box = watched_box(world, &w, NULL);
	int32_t calls;
	fixture_step(world, 1);
	calls = w.calls;
	CHECK(calls == 1 && w.enters == 1);
	fixture_step(world, 59);
	CHECK_LE("error of the fall in 1 s", fabs((double)fixture_pose(world, box).position_m.y - (0.25 - 0.5 * GRAVITY)), ROUNDING, "m");
	CHECK(w.unlocked == 0 && w.enters == 1);
	cn_world_destroy(world);
}

static void pre_solve_is_asked_only_where_wanted(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	watcher w = { 0, 0, 0, 0, 0, 0, 0 };
	cn_shape shape;
	cn_body box = watched_box(world, &w, &shape);
	int32_t calls;
	fixture_step(world, 10);
	CHECK(w.calls == 10);
	must(cn_shape_set_flags(world, shape, 0u), world, "cn_shape_set_flags");
	fixture_step(world, 10);
	CHECK(w.calls == 10);
	must(cn_shape_set_flags(world, shape, CN_SHAPE_PRE_SOLVE), world, "cn_shape_set_flags");
	fixture_step(world, 10);
	calls = w.calls;
	CHECK(calls >= 19);
	must(cn_world_set_pre_solve_callback(world, NULL, NULL), world, "cn_world_set_pre_solve_callback");
	fixture_step(world, 10);
	CHECK(w.calls == calls && w.bad == 0 && w.unlocked == 0);
	CHECK_LE("error of the height", fabs((double)fixture_pose(world, box).position_m.y - 0.25), SAG_M, "m");
	cn_world_destroy(world);
}

/* ---- filter callback ---- */

typedef struct judge {
	int32_t calls, unlocked, bad, answer;
} judge;

static int32_t decide(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	judge *j = (judge *)user;
	++j->calls;
	j->unlocked += cn_world_step(world, FRAME_S) != CN_ERROR_LOCKED;
	j->unlocked += cn_shape_destroy(world, a) != CN_ERROR_LOCKED;
	j->bad += !cn_shape_is_valid(world, a) || !cn_shape_is_valid(world, b) || a == b;
	return j->answer;
}

static double fall_on_judged_floor(judge *j, int32_t remove_first)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body box;
	double y;
	fixture_box(world, CN_BODY_STATIC, 0.0f, -0.05f, 0.0f, 10.0f, 0.05f, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 2.0f, 0.0f, 0.25f, 0.25f, 0.6f, 0.0f);
	must(cn_world_set_filter_callback(world, decide, j), world, "cn_world_set_filter_callback");
	if (remove_first)
		must(cn_world_set_filter_callback(world, NULL, NULL), world, "cn_world_set_filter_callback");
	fixture_step(world, 5);
	CHECK(j->calls == 0); /* the boxes are far apart */
	fixture_step(world, 85);
	y = (double)fixture_pose(world, box).position_m.y;
	cn_world_destroy(world);
	return y;
}

static void filter_callback_decides(void)
{
	judge j = { 0, 0, 0, 1 };
	CHECK_LE("error of the height when allowed", fabs(fall_on_judged_floor(&j, 0) - 0.25), SAG_M, "m");
	printf("  allowed: %d calls\n", (int)j.calls);
	CHECK(j.calls >= 1 && j.unlocked == 0 && j.bad == 0);
	j.calls = j.answer = 0;
	CHECK_LE("error of the fall when denied", fabs(fall_on_judged_floor(&j, 0) - (2.0 - 0.5 * GRAVITY * 2.25)), 2.0 * ROUNDING, "m");
	printf("  denied: %d calls\n", (int)j.calls);
	CHECK(j.calls >= 1 && j.unlocked == 0 && j.bad == 0);
	j.calls = 0;
	CHECK_LE("error of the height when removed", fabs(fall_on_judged_floor(&j, 1) - 0.25), SAG_M, "m");
	CHECK(j.calls == 0);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(sensor_touches_nothing);
	RUN(sensor_is_exact);
	RUN(sensor_sees_what_it_should);
	RUN(events_name_their_bodies);
	RUN(every_end_is_told_once);
	RUN(masks_of_visitors_do_not_matter);
	RUN(sleeping_is_not_leaving);
	RUN(a_chain_enters_once);
	RUN(a_chain_has_two_sides_for_sensors);
	RUN(order_is_deterministic);
	RUN(body_jumps_through_and_lands);
	RUN(fall_from_above_stays);
	RUN(platform_stops_one_side_only);
	RUN(pre_solve_lets_pass_in_chosen_steps);
	RUN(pre_solve_lets_fall_through);
	RUN(pre_solve_is_asked_only_where_wanted);
	RUN(filter_callback_decides);
	return test_end();
}
