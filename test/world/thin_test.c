/*
 * test/world/thin_test.c - shapes of 0.5 to 10 mm, up to 1,000 times as long as thick, keep the promises of thick ones: they
 * have their mass, come to rest on the ground and on each other, sleep there, and neither sink nor pass through walls.
 *
 * Shapes are drawn from a generator: kind, thickness, length, place, angle and speed from a seed.
 *
 * If a test here fails, look first in: collision/manifold_faces.c (touch distances), narrowphase/touch.c (what grazes),
 * narrowphase/continuous.c (cores of shapes), geometry/mass.c.
 */
#include "fixture.h"

enum { THIN_BOX, THIN_CAPSULE, THIN_TRIANGLE, THIN_ROUNDED, THIN_KINDS };
static const char *const thin_names[] = { "box", "capsule", "triangle", "rounded box" };
static const float thicknesses_m[] = { 0.0005f, 0.001f, 0.002f, 0.005f, 0.01f };
#define THICKNESSES 5
#define SEEDS TEST_MANY(12)
#define THICKNESS_LEAST_M 0.0005f

static uint32_t random_state;

static void random_seed(uint32_t seed) { random_state = seed * 2654435761u + 12345u; }

static float random_between(float low, float high)
{
	random_state = random_state * 1664525u + 1013904223u;
	return low + (high - low) * (float)(random_state >> 8) / 16777216.0f;
}

typedef struct thin {
	int32_t kind;
	float thickness, length; /* m */
} thin;

static thin thin_make(int32_t kind, float thickness)
{
	thin t;
	t.kind = kind;
	t.thickness = thickness;
	t.length = t.thickness * powf(10.0f, random_between(1.0f, 3.0f));
	if (t.length > 2.0f)
		t.length = 2.0f;
	return t;
}

static void thin_shape(cn_world *world, const cn_shape_def *def, thin t)
{
	float hx = 0.5f * t.length, hy = 0.5f * t.thickness, core = fmaxf(0.7f * hy, 0.5f * THICKNESS_LEAST_M);
	cn_capsule capsule = { { -hx + hy, 0.0f }, { hx - hy, 0.0f }, hy };
	cn_polygon triangle = { 3, 0.0f, { { -hx, -hy }, { hx, -hy }, { 0.3f * hx, hy } } };
	cn_result result;
	switch (t.kind) {
	case THIN_BOX: result = cn_shape_create_box(world, def, hx, hy, 0.0f, NULL); break;
	case THIN_CAPSULE: result = cn_shape_create_capsule(world, def, &capsule, NULL); break;
	case THIN_TRIANGLE: result = cn_shape_create_polygon(world, def, &triangle, NULL); break;
	default: result = cn_shape_create_box(world, def, hx - (hy - core), core, hy - core, NULL); break;
	}
	must(result, world, "thin_shape");
}

static cn_body thin_body(cn_world *world, thin t, float x, float y, float angle, float friction)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, angle);
	cn_shape_def def = fixture_shape_def(body, friction, 0.0f);
	thin_shape(world, &def, t);
	return body;
}

/* Lowest (way 1) or highest (way -1) point of a body along y, m. */
static double thin_lowest(const cn_world *world, cn_body body, double way)
{
	cn_aabb box;
	must(cn_body_get_aabb(world, body, &box), world, "cn_body_get_aabb");
	return way > 0.0 ? (double)box.lower_m.y : (double)box.upper_m.y;
}

static void t_mass_is_that_of_closed_forms(void)
{
	double worst = 0.0;
	int32_t i, seed;
	for (i = 0; i < THICKNESSES; ++i)
		for (seed = 0; seed < SEEDS; ++seed) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_mass_data box, capsule;
			thin t;
			double l, h, r, straight, disc, kg, inertia;
			random_seed((uint32_t)(100 * i + seed));
			t = thin_make(THIN_BOX, thicknesses_m[i]);
			l = (double)t.length;
			h = (double)t.thickness;
			must(cn_body_get_mass_data(world, thin_body(world, t, 0.0f, 0.0f, 0.7f, 0.6f), &box), world, "mass");
			worst = fmax(worst, fabs((double)box.mass_kg / (l * h) - 1.0));
			worst = fmax(worst, fabs((double)box.inertia_kgm2 / (l * h * (l * l + h * h) / 12.0) - 1.0));
			t.kind = THIN_CAPSULE;
			r = 0.5 * h;
			straight = 2.0 * r * (l - 2.0 * r);
			disc = 3.14159265358979 * r * r;
			kg = straight + disc;
			inertia = straight * ((l - 2.0 * r) * (l - 2.0 * r) + h * h) / 12.0 +
			          disc * (0.5 * r * r + 0.25 * (l - 2.0 * r) * (l - 2.0 * r) + (l - 2.0 * r) * 4.0 * r / (3.0 * 3.14159265358979));
			must(cn_body_get_mass_data(world, thin_body(world, t, 0.0f, 0.0f, 0.7f, 0.6f), &capsule), world, "mass");
			worst = fmax(worst, fabs((double)capsule.mass_kg / kg - 1.0));
			worst = fmax(worst, fabs((double)capsule.inertia_kgm2 / inertia - 1.0));
			cn_world_destroy(world);
		}
	CHECK_LE("mass and inertia, relative error", worst, 1e-4, "");
}

static int32_t thin_sleeps(const cn_world *world, cn_body body)
{
	uint32_t flags;
	must(cn_body_get_flags(world, body, &flags), world, "cn_body_get_flags");
	return (flags & CN_BODY_AWAKE) == 0;
}

static void t_what_falls_rests_on_the_ground_and_sleeps(void)
{
	int32_t kind, i, seed;
	for (kind = 0; kind < THIN_KINDS; ++kind) {
		double sunk = 0.0, above = 0.0;
		int32_t awake = 0;
		for (i = 0; i < THICKNESSES; ++i)
			for (seed = 0; seed < SEEDS; ++seed) {
				cn_world *world = fixture_world(-10.0f, 1);
				cn_body body;
				thin t;
				int32_t step;
				random_seed((uint32_t)(10000 * kind + 100 * i + seed));
				fixture_floor(world, 0.6f, 0.0f);
				t = thin_make(kind, thicknesses_m[i]);
				float y = random_between(0.1f, 1.0f) + 0.5f * t.length, angle = random_between(0.0f, 6.28f);
				float vx = random_between(-2.0f, 2.0f), vy = random_between(-3.0f, 0.0f);
				body = thin_body(world, t, 0.0f, y, angle, 0.6f);
				fixture_set_velocity(world, body, vx, vy, random_between(-5.0f, 5.0f));
				for (step = 0; step < 600; ++step) {
					fixture_step(world, 1);
					if (step > 300)
						sunk = fmax(sunk, -thin_lowest(world, body, 1.0));
				}
				above = fmax(above, (thin_lowest(world, body, -1.0)) / (double)t.thickness);
				awake += !thin_sleeps(world, body);
				cn_world_destroy(world);
			}
		printf("  %s\n", thin_names[kind]);
		CHECK_LE("sunk after 5 s", sunk, 2.8e-4, "m"); /* g / w^2 at 30 Hz: of a body as light as its contact */
		CHECK_LE("top over the ground, thicknesses", above, kind == THIN_TRIANGLE ? 1.6 : 10.4, "");
		CHECK_LE("awake after 10 s", awake, 0, "");
	}
}

static void t_a_pack_of_cards_stands(void)
{
	int32_t kind, i, k;
	enum { CARDS = 20 };
	for (kind = 0; kind < 2; ++kind)
		for (i = 0; i < THICKNESSES; ++i) {
			cn_world *world = fixture_world(-10.0f, 1);
			cn_body body[CARDS];
			thin t = { kind ? THIN_ROUNDED : THIN_BOX, 0.0f, 0.1f };
			double worst = 0.0, gone = 0.0;
			int32_t awake = 0;
			t.thickness = thicknesses_m[i];
			fixture_floor(world, 0.6f, 0.0f);
			for (k = 0; k < CARDS; ++k)
				body[k] = thin_body(world, t, 0.0f, ((float)k + 0.5f) * t.thickness, 0.0f, 0.6f);
			fixture_step(world, 600);
			for (k = 0; k < CARDS; ++k) {
				cn_pose pose = fixture_pose(world, body[k]);
				worst = fmax(worst, fabs((double)pose.position_m.y / (double)t.thickness - ((double)k + 0.5)));
				gone = fmax(gone, fabs((double)pose.position_m.x));
				awake += !thin_sleeps(world, body[k]);
			}
			printf("  %s of %.1f mm\n", thin_names[t.kind], 1e3 * (double)t.thickness);
			CHECK_LE("a card out of its place, thicknesses", worst, 0.5, "");
			CHECK_LE("a card moved aside", gone, 1e-3, "m");
			CHECK_LE("cards awake after 10 s", awake, 0, "");
			cn_world_destroy(world);
		}
}

/* A closed room of 4 m, its walls 2 cm thick (boxes) or without thickness (edges). */
static void room_make(cn_world *world, int32_t edges)
{
	static const float sides[4][4] = { { 0.0f, -2.0f, 1.0f, 0.0f }, { 0.0f, 2.0f, 1.0f, 0.0f }, { -2.0f, 0.0f, 0.0f, 1.0f }, { 2.0f, 0.0f, 0.0f, 1.0f } };
	int32_t k;
	for (k = 0; k < 4; ++k) {
		const float *s = sides[k];
		cn_body body = fixture_body(world, CN_BODY_STATIC, s[0], s[1], 0.0f);
		cn_shape_def def = fixture_shape_def(body, 0.3f, 0.0f);
		cn_edge edge;
		edge.a_m.x = -2.1f * s[2];
		edge.a_m.y = -2.1f * s[3];
		edge.b_m.x = 2.1f * s[2];
		edge.b_m.y = 2.1f * s[3];
		if (edges)
			must(cn_shape_create_edge(world, &def, &edge, NULL), world, "edge");
		else
			fixture_box_shape(world, &def, s[2] != 0.0f ? 2.1f : 0.01f, s[3] != 0.0f ? 2.1f : 0.01f);
	}
}

enum { THROWN = 4 };

/* How many of four bodies that are thrown about in the room have left it after 3 s: half sunk in a wall is inside. */
static int32_t thrown_out(int32_t kind, int32_t edges, int32_t thickness, int32_t seed)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body[THROWN];
	float most = 2.0f + thicknesses_m[thickness];
	int32_t out = 0, k;
	room_make(world, edges);
	random_seed((uint32_t)(10000 * kind + 100 * thickness + seed + 7));
	for (k = 0; k < THROWN; ++k) {
		thin t = thin_make(kind, thicknesses_m[thickness]);
		float angle = random_between(0.0f, 6.28f), vx = random_between(-60.0f, 60.0f), vy = random_between(-60.0f, 60.0f);
		body[k] = thin_body(world, t, (float)(k % 2) - 0.5f, (float)(k / 2) - 0.5f, angle, 0.3f);
		fixture_set_velocity(world, body[k], vx, vy, random_between(-20.0f, 20.0f));
	}
	fixture_step(world, 180);
	for (k = 0; k < THROWN; ++k) {
		cn_pose pose = fixture_pose(world, body[k]);
		out += fabsf(pose.position_m.x) > most || fabsf(pose.position_m.y) > most;
	}
	cn_world_destroy(world);
	return out;
}

/* Of 20,000 of each kind 0.01 to 0.02% leave a room of edges; of triangles 0.55%, for the tip of a wedge has no core: a share that takes a
   sample of thousands. */
static void t_what_is_thrown_stays_in_the_room(void)
{
	int32_t kind, edges, i, seed;
	for (kind = 0; kind < THIN_KINDS; ++kind)
		for (edges = 0; edges < 2; ++edges) {
			int32_t out = 0, seeds = kind == THIN_TRIANGLE && edges ? 10 * SEEDS : SEEDS, all = THROWN * THICKNESSES * seeds;
			for (i = 0; i < THICKNESSES; ++i)
				for (seed = 0; seed < seeds; ++seed)
					out += thrown_out(kind, edges, i, seed + 12 - SEEDS); /* the last ones: seed 11 is the only one that some faults are seen at */
			printf("  %s, walls are %s: of %d\n", thin_names[kind], edges ? "edges" : "boxes", all);
			CHECK_LE("share out of the room", (double)out / all, kind == THIN_TRIANGLE ? 0.01 : 0.0, "");
		}
}

/* Trials in which a blow pressed a body into an edge by more than its core's depth, and a second one pressed it through. */
static void t_what_is_pressed_into_an_edge_stays(void)
{
	static const int32_t trials[][3] = {
		{ THIN_BOX, 1, 800 },     { THIN_BOX, 2, 57 },      { THIN_BOX, 3, 227 },     { THIN_BOX, 3, 281 },     { THIN_CAPSULE, 3, 360 }, { THIN_CAPSULE, 4, 368 }, { THIN_CAPSULE, 4, 493 },
		{ THIN_ROUNDED, 1, 510 }, { THIN_ROUNDED, 2, 7 },   { THIN_ROUNDED, 2, 158 }, { THIN_ROUNDED, 2, 826 }, { THIN_ROUNDED, 2, 983 }, { THIN_ROUNDED, 2, 989 },
		{ THIN_ROUNDED, 3, 161 }, { THIN_ROUNDED, 3, 276 },
	};
	int32_t out = 0;
	size_t k;
	for (k = 0; k < sizeof trials / sizeof trials[0]; ++k)
		out += thrown_out(trials[k][0], 1, trials[k][1], trials[k][2]);
	CHECK_LE("out of the room", out, 0, "");
}

/* Seen from each of the two, which began on end with their backs to -x, the other is on the wrong side. */
static int32_t cards_crossed(cn_pose left, cn_pose right)
{
	float x = right.position_m.x - left.position_m.x, y = right.position_m.y - left.position_m.y;
	return x * left.sine - y * left.cosine < 0.0f && x * right.sine - y * right.cosine < 0.0f;
}

/* Of pairs of cards that meet broadside, tilted by up to 3 degrees and moved aside by up to 4 cm, the share that pass through
   each other. */
static double share_crossed(float thickness, float speed_most)
{
	int32_t seed, passed = 0, step;
	enum { PAIRS = 100 };
	for (seed = 0; seed < PAIRS; ++seed) {
		cn_world *world = fixture_world(0.0f, 0);
		thin t = { THIN_BOX, 0.0f, 0.0f };
		cn_body left, right;
		float speed, back, y;
		random_seed((uint32_t)seed);
		t.thickness = thickness;
		t.length = random_between(0.1f, 0.3f);
		speed = random_between(1.0f, speed_most);
		back = random_between(0.0f, 1.0f);
		y = random_between(-0.04f, 0.04f);
		left = thin_body(world, t, -1.0f, y, 1.5708f + random_between(-0.05f, 0.05f), 0.3f);
		right = thin_body(world, t, 1.0f, 0.0f, 1.5708f + random_between(-0.05f, 0.05f), 0.3f);
		fixture_set_velocity(world, left, speed, 0.0f, 0.0f);
		fixture_set_velocity(world, right, -back * speed, 0.0f, 0.0f);
		for (step = 0; step < (int32_t)(120.0f / ((1.0f + back) * speed)) + 6; ++step)
			fixture_step(world, 1);
		passed += cards_crossed(fixture_pose(world, left), fixture_pose(world, right));
		cn_world_destroy(world);
	}
	return (double)passed / (double)PAIRS;
}

/* Bodies that are no bullets may pass each other where they turn by radians in a step: at up to 40 m/s a fifth of boxes of 4 cm
   do as well (Box2D 3.2: 78% of those, nine tenths of cards of 2 mm; at up to 3 m/s half of these). */
static void t_cards_that_meet_rarely_pass(void)
{
	double slow = 0.0, fast = 0.0;
	int32_t i;
	for (i = 0; i < THICKNESSES; ++i) {
		slow = fmax(slow, share_crossed(thicknesses_m[i], 3.0f));
		fast = fmax(fast, share_crossed(thicknesses_m[i], 40.0f));
	}
	CHECK_LE("share that passed at 1 to 3 m/s", slow, 0.05, "");
	CHECK_LE("share that passed at 1 to 40 m/s", fast, 0.45, "");
}

static void t_too_thin_is_said(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	cn_shape shape = 0;
	CHECK(cn_shape_create_box(world, &def, 0.5f, 0.0001f, 0.0f, &shape) == CN_ERROR_ARGUMENT);
	printf("  %s\n", cn_world_error_text(world));
	CHECK(strstr(cn_world_error_text(world), "0.0002;") != NULL);
	CHECK(strstr(cn_world_error_text(world), "0.0005") != NULL);
	CHECK(strstr(cn_world_error_text(world), "length_unit_m up to 0.4 ") != NULL);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_mass_is_that_of_closed_forms);
	RUN(t_what_falls_rests_on_the_ground_and_sleeps);
	RUN(t_a_pack_of_cards_stands);
	RUN(t_what_is_thrown_stays_in_the_room);
	RUN(t_what_is_pressed_into_an_edge_stays);
	RUN(t_cards_that_meet_rarely_pass);
	RUN(t_too_thin_is_said);
	return test_end();
}
