/*
 * test/world/seams_test.c - fixed shapes whose faces lie flush end to end are one surface: nothing that slides along is caught
 * where they meet; real steps and gaps stop bodies as before.
 *
 * A generator draws the body (kind, size), the tiles (kind, length, one body or many), the angle of the floor, speed and step
 * from a seed.
 *
 * If a test here fails, look first in: geometry/seam.c (what is flush, what is mended), stages/seams.c (when it is found),
 * stages/narrowphase_touch.c, stages/continuous.c.
 */
#include "fixture.h"

enum { BODY_BOX, BODY_BALL, BODY_CAPSULE, BODY_POLYGON, BODY_KINDS };
enum { TILE_BOXES_ONE_BODY, TILE_BOXES, TILE_EDGES, TILE_POLYGONS, TILE_KINDS };
static const char *const body_names[] = { "box", "ball", "capsule", "pentagon" };
static const char *const tile_names[] = { "boxes on one body", "boxes", "edges", "trapezoids" };

typedef struct ride {
	int32_t body, tiles;
	float size, tile;    /* m */
	float angle;         /* of the floor */
	float speed, dt, friction;
	float step_up;       /* of every tile from the tenth on, m */
	float corner;        /* turn between tiles from the tenth on, rad; TILE_EDGES alone. Positive: concave */
} ride;

static void tile_add(cn_world *world, cn_body *shared, const ride *r, float x, float y)
{
	float c = cosf(r->angle), s = sinf(r->angle), half = 0.5f * r->tile, high = fmaxf(half, 0.5f);
	cn_polygon trapezoid = { 4, 0.0f, { { -half, 0.0f }, { -0.8f * half, -high }, { 0.8f * half, -high }, { half, 0.0f } } };
	cn_edge edge;
	cn_shape_def def;
	cn_result result;
	if (r->tiles == TILE_BOXES_ONE_BODY && *shared == 0)
		*shared = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, r->angle);
	def = fixture_shape_def(r->tiles == TILE_BOXES_ONE_BODY ? *shared : fixture_body(world, CN_BODY_STATIC, c * x - s * y, s * x + c * y, r->angle), r->friction, 0.0f);
	if (r->tiles == TILE_BOXES_ONE_BODY) {
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

static cn_body rider_add(cn_world *world, const ride *r, float x)
{
	float c = cosf(r->angle), s = sinf(r->angle), h = 0.5f * r->size, y = r->body == BODY_CAPSULE ? 0.5f * h : r->body == BODY_POLYGON ? 0.8f * h : h;
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, c * x - s * y, s * x + c * y, r->angle);
	cn_shape_def def = fixture_shape_def(body, r->friction, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { -0.5f * h, 0.0f }, { 0.5f * h, 0.0f }, 0.5f * h };
	cn_polygon pentagon = { 5, 0.0f, { { -0.6f * h, -0.8f * h }, { 0.6f * h, -0.8f * h }, { h, 0.3f * h }, { 0.0f, h }, { -h, 0.3f * h } } };
	cn_result result;
	circle.radius_m = h;
	switch (r->body) {
	case BODY_BOX: result = cn_shape_create_box(world, &def, h, h, 0.0f, NULL); break;
	case BODY_BALL: result = cn_shape_create_circle(world, &def, &circle, NULL); break;
	case BODY_CAPSULE: result = cn_shape_create_capsule(world, &def, &capsule, NULL); break;
	default: result = cn_shape_create_polygon(world, &def, &pentagon, NULL); break;
	}
	must(result, world, "rider_add");
	fixture_set_velocity(world, body, c * r->speed, s * r->speed, 0.0f);
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
	r.step_up = r.corner = 0.0f;
	return r;
}

#define RIDES 40

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
				if (a.lost > 1e-3 || a.hop > 0.005) {
					++caught;
					if (getenv("SEAMS") != NULL)
						printf("    size %.3f tile %.3f angle %.2f speed %.2f dt 1/%.0f: lost %.4f hop %.4f turned %.4f way %.2f\n", (double)r.size, (double)r.tile, (double)r.angle, (double)r.speed, 1.0 / (double)r.dt, a.lost, a.hop, a.turned, a.way);
				}
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

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(frictionless_bodies_slide_on);
	return test_end();
}
