/*
 * test/world/seams_test.c - fixed shapes whose faces lie flush end to end are one surface: nothing that slides along is caught
 * where they meet; real steps and gaps stop bodies as before.
 *
 * A generator draws the body (kind, size), the tiles (kind, length, one body or many), the angle of the floor, speed and step
 * from a seed.
 *
 * If a test here fails, look first in: collision/seam.c (what is flush, what is mended), narrowphase/static_seams.c (when it is found),
 * narrowphase/touch.c, narrowphase/continuous.c.
 */
#include "fixture.h"

enum { BODY_BOX, BODY_BALL, BODY_CAPSULE, BODY_POLYGON, BODY_KINDS };
enum { TILE_BOXES_ONE_BODY, TILE_BOXES, TILE_EDGES, TILE_POLYGONS, TILE_BOXES_KINEMATIC, TILE_KINDS };
static const char *const body_names[] = { "box", "ball", "capsule", "pentagon" };
static const char *const tile_names[] = { "boxes on one body", "boxes", "edges", "trapezoids", "boxes on a kinematic body" };

typedef struct ride {
	int32_t body, tiles;
	float size, tile;    /* m */
	float angle;         /* of the floor */
	float speed, dt, friction;
	int32_t upright;     /* 1: the rider does not turn */
	float height, fall;  /* over the floor at first, m; speed towards it, m/s */
	float step_up;       /* of every tile from the tenth on, m */
} ride;

static void tile_add(cn_world *world, cn_body *shared, const ride *r, float x, float y)
{
	float c = cosf(r->angle), s = sinf(r->angle), half = 0.5f * r->tile, high = fmaxf(half, 0.5f);
	cn_polygon trapezoid = { 4, 0.0f, { { -half, 0.0f }, { -0.8f * half, -high }, { 0.8f * half, -high }, { half, 0.0f } } };
	cn_edge edge;
	cn_shape_def def;
	cn_result result;
	int32_t one = r->tiles == TILE_BOXES_ONE_BODY || r->tiles == TILE_BOXES_KINEMATIC;
	if (one && *shared == 0)
		*shared = fixture_body(world, r->tiles == TILE_BOXES_KINEMATIC ? CN_BODY_KINEMATIC : CN_BODY_STATIC, 0.0f, 0.0f, r->angle);
	def = fixture_shape_def(one ? *shared : fixture_body(world, CN_BODY_STATIC, c * x - s * y, s * x + c * y, r->angle), r->friction, 0.0f);
	if (one) {
		def.offset_m.x = x;
		def.offset_m.y = y - high;
		result = cn_shape_create_box(world, &def, half, high, 0.0f, NULL);
	} else if (r->tiles == TILE_BOXES) {
		def.offset_m.y = -high;
		result = cn_shape_create_box(world, &def, half, high, 0.0f, NULL);
	} else if (r->tiles == TILE_POLYGONS) {
		result = cn_shape_create_polygon(world, &def, &trapezoid, NULL);
	} else {
		edge.a_m.x = half;
		edge.b_m.x = -half;
		edge.a_m.y = edge.b_m.y = 0.0f;
		result = cn_shape_create_edge(world, &def, &edge, NULL);
	}
	must(result, world, "tile_add");
}

/* Edges have no sides: the step's own. */
static void riser_add(cn_world *world, const ride *r, float x)
{
	cn_body body = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, r->angle);
	cn_shape_def def = fixture_shape_def(body, r->friction, 0.0f);
	cn_edge edge;
	edge.a_m.x = edge.b_m.x = x;
	edge.a_m.y = r->step_up;
	edge.b_m.y = -0.5f;
	must(cn_shape_create_edge(world, &def, &edge, NULL), world, "riser_add");
}

/* A box that trips over a low step may turn over it: one that cannot turn has to stop. */
static void stay_upright(cn_world *world, cn_body body)
{
	uint32_t flags;
	must(cn_body_get_flags(world, body, &flags), world, "cn_body_get_flags");
	must(cn_body_set_flags(world, body, flags | CN_BODY_LOCK_ROTATION), world, "cn_body_set_flags");
}

static cn_body rider_add(cn_world *world, const ride *r, float x)
{
	float c = cosf(r->angle), s = sinf(r->angle), h = 0.5f * r->size, y = r->body == BODY_CAPSULE ? 0.5f * h : r->body == BODY_POLYGON ? 0.8f * h : h;
	cn_body body;
	cn_shape_def def;
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { -0.5f * h, 0.0f }, { 0.5f * h, 0.0f }, 0.5f * h };
	cn_polygon pentagon = { 5, 0.0f, { { -0.6f * h, -0.8f * h }, { 0.6f * h, -0.8f * h }, { h, 0.3f * h }, { 0.0f, h }, { -h, 0.3f * h } } };
	cn_result result;
	y += r->height;
	body = fixture_body(world, CN_BODY_DYNAMIC, c * x - s * y, s * x + c * y, r->angle);
	def = fixture_shape_def(body, r->friction, 0.0f);
	circle.radius_m = h;
	switch (r->body) {
	case BODY_BOX: result = cn_shape_create_box(world, &def, h, h, 0.0f, NULL); break;
	case BODY_BALL: result = cn_shape_create_circle(world, &def, &circle, NULL); break;
	case BODY_CAPSULE: result = cn_shape_create_capsule(world, &def, &capsule, NULL); break;
	default: result = cn_shape_create_polygon(world, &def, &pentagon, NULL); break;
	}
	must(result, world, "rider_add");
	if (r->upright)
		stay_upright(world, body);
	fixture_set_velocity(world, body, c * r->speed + s * r->fall, s * r->speed - c * r->fall, 0.0f);
	return body;
}

typedef struct ridden {
	double hop;   /* highest of the centre over its place at first, m */
	double sunk;
	double lost;  /* of the speed along the floor, relative; least speed over first */
	double turned;/* rad */
	double way;   /* m, beyond the start */
} ridden;

/* Gravity is across the floor. The floor reaches 6 m or 0.8 s ahead. */
static ridden ride_run(const ride *r)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_body rider, shared = 0;
	float c = cosf(r->angle), s = sinf(r->angle), far = fminf(fmaxf(6.0f, 0.8f * r->speed), 40.0f) + 4.0f, x;
	double first_x, first_y, least = 1e9, most = 0.0;
	ridden out = { 0.0, 0.0, 0.0, 0.0, 0.0 };
	cn_pose pose;
	int32_t k, tiles = (int32_t)(far / r->tile) + 8;
	cn_world_def_init(&def);
	def.gravity_mps2.x = 10.0f * s;
	def.gravity_mps2.y = -10.0f * c;
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	x = -2.0f - r->size;
	if (r->tiles == TILE_EDGES && r->step_up > 0.0f)
		riser_add(world, r, x + 9.5f * r->tile);
	for (k = 0; k < tiles; ++k, x += r->tile)
		tile_add(world, &shared, r, x, k >= 10 ? r->step_up : 0.0f);
	rider = rider_add(world, r, 0.0f);
	pose = fixture_pose(world, rider);
	first_x = (double)(c * pose.position_m.x + s * pose.position_m.y);
	first_y = (double)(c * pose.position_m.y - s * pose.position_m.x);
	while (out.way < (double)(far - 4.0f) && k++ < 2000) {
		cn_velocity v;
		double along, y, speed;
		must(cn_world_step(world, r->dt), world, "cn_world_step");
		pose = fixture_pose(world, rider);
		v = fixture_velocity(world, rider);
		along = (double)(c * pose.position_m.x + s * pose.position_m.y) - first_x;
		y = (double)(c * pose.position_m.y - s * pose.position_m.x) - first_y;
		speed = (double)(c * v.linear_mps.x + s * v.linear_mps.y);
		least = fmin(least, speed);
		most = fmax(most, speed);
		out.hop = fmax(out.hop, y);
		out.sunk = fmax(out.sunk, -y);
		out.turned = fmax(out.turned, r->body == BODY_BALL ? 0.0 : fabs((double)(pose.sine * c - pose.cosine * s)));
		if (along <= out.way && k > tiles + 60)
			break;
		out.way = fmax(out.way, along);
	}
	out.lost = fmax(1.0 - least / (double)r->speed, most / (double)r->speed - 1.0);
	cn_world_destroy(world);
	return out;
}

/* With SEAMS in the environment: which rides were caught. */
static void ride_print(const ride *r, const ridden *a)
{
	printf("    %s over %s: size %.3f tile %.3f angle %.2f speed %.2f dt 1/%.0f fall %.2f height %.3f: lost %.4f hop %.4f turned %.4f\n", body_names[r->body], tile_names[r->tiles],
	       (double)r->size, (double)r->tile, (double)r->angle, (double)r->speed, 1.0 / (double)r->dt, (double)r->fall, (double)r->height, a->lost, a->hop, a->turned);
}

static ride ride_draw(uint32_t *random, int32_t body, int32_t tiles)
{
	static const float steps[] = { 1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 120.0f, 1.0f / 240.0f };
	ride r;
	r.body = body;
	r.tiles = tiles;
	r.size = 0.1f * powf(20.0f, fixture_random(random, 0.0f, 1.0f));
	r.tile = 0.25f * powf(8.0f, fixture_random(random, 0.0f, 1.0f));
	r.angle = fixture_random(random, 0.0f, 1.0f) < 0.5f ? 0.0f : fixture_random(random, -3.1f, 3.1f);
	r.speed = powf(40.0f, fixture_random(random, 0.0f, 1.0f));
	r.dt = steps[(int32_t)fixture_random(random, 0.0f, 3.999f)];
	r.friction = 0.0f;
	r.step_up = r.height = r.fall = 0.0f;
	r.upright = 0;
	return r;
}

#define RIDES TEST_MANY(40)

static void frictionless_bodies_slide_on(void)
{
	uint32_t random = 2463534242u;
	int32_t body, tiles, k;
	for (body = 0; body < BODY_KINDS; ++body)
		for (tiles = 0; tiles < TILE_KINDS; ++tiles) {
			ridden worst = { 0.0, 0.0, 0.0, 0.0, 0.0 };
			int32_t caught = 0;
			for (k = 0; k < RIDES; ++k) {
				ride r = ride_draw(&random, body, tiles);
				ridden a = ride_run(&r);
				caught += a.lost > 1e-3 || a.hop > 0.005;
				if ((a.lost > 1e-3 || a.hop > 0.005) && getenv("SEAMS") != NULL)
					ride_print(&r, &a);
				worst.hop = fmax(worst.hop, a.hop);
				worst.sunk = fmax(worst.sunk, a.sunk);
				worst.lost = fmax(worst.lost, a.lost);
				worst.turned = fmax(worst.turned, a.turned);
			}
			printf("  %s over %s, caught %d of %d\n", body_names[body], tile_names[tiles], caught, RIDES);
			CHECK_LE("speed lost or gained, relative", worst.lost, 1e-3, "");
			CHECK_LE("hop", worst.hop, 5e-3, "m");
			CHECK_LE("sunk", worst.sunk, 5e-3, "m");
		}
}

/*
 * They come down on the tiles in the first 0.1 s. Wide boxes that strike many tiles at once at 25 m/s and more may rise and turn:
 * a few sweeps over so many contacts do not take all of such an impact evenly. On one floor none does; without seams about half of the boxes are caught.
 */
static void what_lands_slides_on(void)
{
	uint32_t random = 123459876u;
	int32_t k, caught[2] = { 0, 0 };
	for (k = 0; k < 8 * RIDES; ++k) {
		ride r = ride_draw(&random, k % 2 ? BODY_BALL : BODY_BOX, k / 2 % TILE_KINDS);
		ridden a;
		r.fall = fixture_random(&random, 1.0f, 30.0f);
		r.height = fixture_random(&random, 0.0f, 0.1f * r.fall);
		r.speed = fmaxf(r.speed, 5.0f);
		a = ride_run(&r);
		caught[r.fall > 20.0f] += a.lost > 1e-3 || a.hop > 5e-3;
		if ((a.lost > 1e-3 || a.hop > 5e-3) && getenv("SEAMS") != NULL)
			ride_print(&r, &a);
	}
	CHECK_LE("caught of those that fall at 1 to 20 m/s", caught[0], 0, "");
	CHECK_LE("caught of those that fall at 20 to 30 m/s", caught[1], 6, "");
}

static void friction_is_that_of_one_floor(void)
{
	uint32_t random = 88675123u;
	double worst = 0.0, way;
	int32_t k;
	for (k = 0; k < 4 * RIDES; ++k) {
		ride r = ride_draw(&random, k % 2 ? BODY_BOX : BODY_POLYGON, k / 2 % TILE_KINDS);
		r.friction = 0.5f;
		r.size = fmaxf(r.size, 0.2f);
		r.speed = 1.0f + 0.125f * r.speed;
		way = 0.5 * (double)(r.speed * r.speed) / (0.5 * 10.0);
		worst = fmax(worst, fabs(ride_run(&r).way - way) - 0.5 * (double)(r.speed * r.dt)); /* where in a step it stops */
	}
	CHECK_LE("way to rest against v^2 / (2 mu g)", worst, 0.02, "m");
}

/* What is higher than the slop is no seam. */
static void steps_stop(void)
{
	uint32_t random = 362436069u;
	double beyond = 0.0;
	int32_t k, passed = 0;
	for (k = 0; k < 4 * RIDES; ++k) {
		ride r = ride_draw(&random, BODY_BOX, k % TILE_KINDS);
		double step_at, over;
		r.upright = 1;
		r.size = fmaxf(r.size, 0.3f);
		r.tile = fmaxf(r.tile, 0.6f);
		r.step_up = fixture_random(&random, 0.02f, 0.1f);
		step_at = 9.5 * (double)r.tile - 2.0 - 1.5 * (double)r.size; /* way of the centre until the front is there */
		over = ride_run(&r).way - step_at;
		beyond = fmax(beyond, over);
		passed += over > 0.02;
	}
	printf("  passed %d of %d\n", passed, 4 * RIDES);
	CHECK_LE("way beyond the step", beyond, 0.02, "m");
}

/* A wall of stacked tiles, which a box is pushed against while it falls along it for 0.8 s. */
static void falls_along_a_wall(void)
{
	uint32_t random = 521288629u;
	double worst = 0.0, aside = 0.0;
	int32_t k, i;
	for (k = 0; k < 2 * RIDES; ++k) {
		cn_world_def def;
		cn_world *world = NULL;
		cn_body body, wall = fixture_random(&random, 0.0f, 1.0f) < 0.5f ? 1u : 0u;
		float tile = fixture_random(&random, 0.25f, 1.0f), half = fixture_random(&random, 0.05f, 0.5f), push = fixture_random(&random, 1.0f, 20.0f);
		cn_world_def_init(&def);
		def.gravity_mps2.x = -push;
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
		must(cn_world_create(&def, &world), NULL, "cn_world_create");
		if (wall != 0)
			wall = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
		for (i = 0; (float)i * tile < 8.0f; ++i) {
			cn_body on = wall != 0 ? wall : fixture_body(world, CN_BODY_STATIC, -0.5f * tile, 2.0f - (float)i * tile, 0.0f);
			cn_shape_def shape = fixture_shape_def(on, 0.0f, 0.0f);
			if (wall != 0) {
				shape.offset_m.x = -0.5f * tile;
				shape.offset_m.y = 2.0f - (float)i * tile;
			}
			fixture_box_shape(world, &shape, 0.5f * tile, 0.5f * tile);
		}
		body = k % 4 == 3 ? fixture_circle(world, CN_BODY_DYNAMIC, half, 0.0f, half, 0.0f, 0.0f) : fixture_box(world, CN_BODY_DYNAMIC, half, 0.0f, 0.0f, half, half, 0.0f, 0.0f);
		fixture_step(world, 48);
		worst = fmax(worst, fabs((double)fixture_velocity(world, body).linear_mps.y / -8.0 - 1.0));
		aside = fmax(aside, fabs((double)(fixture_pose(world, body).position_m.x - half)));
		cn_world_destroy(world);
	}
	CHECK_LE("speed of the fall, relative error", worst, 1e-3, "");
	CHECK_LE("moved from the wall", aside, 5e-3, "m");
}

/* Cards of 0.5 to 10 mm over tiles of 0.5 m: their cores are near the ground. */
static void thin_cards_slide_on(void)
{
	static const float thicknesses[] = { 0.0005f, 0.001f, 0.002f, 0.005f, 0.01f }, speeds[] = { 1.0f, 3.0f, 10.0f, 40.0f };
	double worst = 0.0;
	int32_t i, k;
	for (i = 0; i < 20; ++i) {
		float thickness = thicknesses[i / 4], speed = speeds[i % 4];
		cn_world *world = fixture_world(-10.0f, 0);
		cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.0f, 0.0f);
		cn_body card;
		def.offset_m.y = -0.25f;
		for (k = -2; k < 90; ++k) {
			def.offset_m.x = 0.5f * (float)k;
			fixture_box_shape(world, &def, 0.25f, 0.25f);
		}
		card = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f * thickness, 0.0f, 0.1f, 0.5f * thickness, 0.0f, 0.0f);
		fixture_set_velocity(world, card, speed, 0.0f, 0.0f);
		fixture_step(world, 60);
		worst = fmax(worst, fabs((double)(fixture_pose(world, card).position_m.x / speed) - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("way of a second, relative error", worst, 1e-3, "");
}

/* How far a box gets that slides at 4 m/s from one tile to the next in a second. what: 0 nothing, 1 the first one is let down by
   15 mm before, 2 it is replaced by a lower one. */
static double way_over_two_tiles(int32_t what)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body first = fixture_box(world, CN_BODY_STATIC, 0.0f, -0.5f, 0.0f, 2.0f, 0.5f, 0.0f, 0.0f), box;
	fixture_box(world, CN_BODY_STATIC, 4.0f, -0.5f, 0.0f, 2.0f, 0.5f, 0.0f, 0.0f);
	fixture_step(world, 1);
	if (what == 1)
		must(cn_body_set_pose(world, first, 0.0f, -0.515f, 0.0f), world, "cn_body_set_pose");
	if (what == 2) {
		must(cn_body_destroy(world, first), world, "cn_body_destroy");
		fixture_step(world, 1);
		fixture_box(world, CN_BODY_STATIC, 0.0f, -0.515f, 0.0f, 2.0f, 0.5f, 0.0f, 0.0f);
	}
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, what ? 0.235f : 0.25f, 0.0f, 0.25f, 0.25f, 0.0f, 0.0f);
	stay_upright(world, box);
	fixture_set_velocity(world, box, 4.0f, 0.0f, 0.0f);
	fixture_step(world, 60);
	{
		double x = (double)fixture_pose(world, box).position_m.x;
		cn_world_destroy(world);
		return x;
	}
}

static void what_is_moved_or_replaced_is_looked_at_anew(void)
{
	CHECK_GE("over flush tiles", way_over_two_tiles(0), 3.99, "m");
	CHECK_LE("after the first is let down by 15 mm", way_over_two_tiles(1), 1.76, "m");
	CHECK_LE("after it is replaced by a lower one", way_over_two_tiles(2), 1.76, "m");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(frictionless_bodies_slide_on);
	RUN(what_lands_slides_on);
	RUN(friction_is_that_of_one_floor);
	RUN(steps_stop);
	RUN(falls_along_a_wall);
	RUN(thin_cards_slide_on);
	RUN(what_is_moved_or_replaced_is_looked_at_anew);
	return test_end();
}
