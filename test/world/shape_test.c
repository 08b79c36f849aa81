/*
 * test/world/shape_test.c - what a shape is: mass, material, filter, attaching, and ground without bumps.
 *
 * If a test here fails, look first in: geometry/mass.c and model/body.c (mass), world/shape.c (changes),
 * collision/manifold_chain.c and manifold_faces.c (ground), geometry/shape_build.c and hull.c (polygons).
 */
#include "fixture.h"


#define PI 3.14159265358979323846

static cn_mass_data mass_of(const cn_world *world, cn_body body)
{
	cn_mass_data mass;
	must(cn_body_get_mass_data(world, body, &mass), world, "cn_body_get_mass_data");
	return mass;
}

static cn_shape chain_of(cn_world *world, cn_body body, const cn_vec2 *points, int32_t count, uint32_t loop, float friction)
{
	cn_shape_def def = fixture_shape_def(body, friction, 0.0f);
	cn_chain chain;
	cn_shape shape;
	chain.points_m = points;
	chain.count = count;
	chain.loop = loop;
	must(cn_shape_create_chain(world, &def, &chain, &shape), world, "cn_shape_create_chain");
	return shape;
}

/* ---- mass ---- */

/* A part with its closed form about its own centre. */
typedef struct part {
	double mass, inertia, x, y;
} part;

static part part_add(cn_world *world, cn_body body, int32_t what, uint32_t *seed)
{
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	float a = fixture_random(seed, 0.2f, 1.0f), b = fixture_random(seed, 0.2f, 1.0f), r = fixture_random(seed, 0.1f, 0.5f);
	double A = (double)a, B = (double)b, R = (double)r, density;
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	cn_polygon triangle;
	part p;
	def.offset_m.x = fixture_random(seed, -3.0f, 3.0f);
	def.offset_m.y = fixture_random(seed, -3.0f, 3.0f);
	def.angle_rad = fixture_random(seed, -3.0f, 3.0f);
	def.density_kgpm2 = fixture_random(seed, 0.5f, 5.0f);
	density = (double)def.density_kgpm2;
	p.x = (double)def.offset_m.x;
	p.y = (double)def.offset_m.y;
	switch (what) {
	case 0:
		fixture_box_shape(world, &def, a, b);
		p.mass = density * 4.0 * A * B;
		p.inertia = p.mass * (A * A + B * B) / 3.0;
		return p;
	case 1:
		circle.radius_m = r;
		must(cn_shape_create_circle(world, &def, &circle, NULL), world, "circle");
		p.mass = density * PI * R * R;
		p.inertia = 0.5 * p.mass * R * R;
		return p;
	case 2: { /* a bar and two half discs */
		double bar = density * 4.0 * A * R, discs = density * PI * R * R, h = 4.0 * R / (3.0 * PI);
		capsule.a_m.x = -a;
		capsule.b_m.x = a;
		capsule.radius_m = r;
		must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "capsule");
		p.mass = bar + discs;
		p.inertia = bar * (A * A + R * R) / 3.0 + discs * (0.5 * R * R - h * h + (A + h) * (A + h));
		return p;
	}
	default: /* a right triangle with legs a and b along the axes: its centroid is (a, b) / 3 */
		memset(&triangle, 0, sizeof triangle);
		triangle.count = 3;
		triangle.points_m[1].x = a;
		triangle.points_m[2].y = b;
		must(cn_shape_create_polygon(world, &def, &triangle, NULL), world, "triangle");
		p.mass = density * 0.5 * A * B;
		p.inertia = p.mass * (A * A + B * B) / 18.0;
		p.x += cos((double)def.angle_rad) * A / 3.0 - sin((double)def.angle_rad) * B / 3.0;
		p.y += sin((double)def.angle_rad) * A / 3.0 + cos((double)def.angle_rad) * B / 3.0;
		return p;
	}
}

static void compound_mass_is_the_closed_form(void)
{
	uint32_t seed = 17;
	int32_t trial;
	double worst_mass = 0.0, worst_center = 0.0, worst_inertia = 0.0;
	for (trial = 0; trial < 200; ++trial) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 5.0f, -3.0f, 1.0f);
		part parts[8], sum = { 0.0, 0.0, 0.0, 0.0 };
		int32_t count = 1 + trial % 8, k;
		cn_mass_data m;
		for (k = 0; k < count; ++k) {
			parts[k] = part_add(world, body, (trial + 3 * k) % 4, &seed);
			sum.mass += parts[k].mass;
			sum.x += parts[k].mass * parts[k].x;
			sum.y += parts[k].mass * parts[k].y;
		}
		sum.x /= sum.mass;
		sum.y /= sum.mass;
		for (k = 0; k < count; ++k)
			sum.inertia += parts[k].inertia + parts[k].mass * (pow(parts[k].x - sum.x, 2) + pow(parts[k].y - sum.y, 2));
		m = mass_of(world, body);
		worst_mass = greater(worst_mass, fabs((double)m.mass_kg / sum.mass - 1.0));
		worst_center = greater(worst_center, hypot((double)m.center_m.x - sum.x, (double)m.center_m.y - sum.y));
		worst_inertia = greater(worst_inertia, fabs((double)m.inertia_kgm2 / sum.inertia - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("error of mass, relative", worst_mass, 2e-6, "");
	CHECK_LE("error of the centre", worst_center, 2e-6, "m");
	CHECK_LE("error of inertia, relative", worst_inertia, 1e-5, "");
}

static void mass_follows_density_and_attachment(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), owner;
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_shape left, right, loose;
	float density;
	def.offset_m.x = -2.0f;
	left = fixture_box_shape(world, &def, 0.5f, 0.5f);
	def.offset_m.x = 2.0f;
	right = fixture_box_shape(world, &def, 0.5f, 0.5f);
	CHECK(fabsf(mass_of(world, body).mass_kg - 2.0f) < 1e-6f && fabsf(mass_of(world, body).center_m.x) < 1e-6f);
	must(cn_shape_set_density(world, right, 3.0f), world, "density");
	must(cn_shape_get_density(world, right, &density), world, "density");
	CHECK(density == 3.0f && fabsf(mass_of(world, body).mass_kg - 4.0f) < 1e-6f && fabsf(mass_of(world, body).center_m.x - 1.0f) < 1e-6f);
	must(cn_shape_detach(world, left), world, "detach");
	CHECK(fabsf(mass_of(world, body).mass_kg - 3.0f) < 1e-6f && fabsf(mass_of(world, body).center_m.x - 2.0f) < 1e-6f);
	must(cn_shape_get_body(world, left, &owner), world, "body");
	CHECK(owner == 0 && cn_shape_detach(world, left) == CN_ERROR_STATE);
	must(cn_shape_attach(world, left, body), world, "attach");
	CHECK(cn_shape_attach(world, left, body) == CN_ERROR_STATE && fabsf(mass_of(world, body).mass_kg - 4.0f) < 1e-6f);
	def.body = 0;
	loose = fixture_box_shape(world, &def, 0.5f, 0.5f);
	must(cn_body_destroy(world, body), world, "destroy"); /* takes its shapes along, not the loose one */
	CHECK(!cn_shape_is_valid(world, left) && !cn_shape_is_valid(world, right) && cn_shape_is_valid(world, loose));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- material ---- */

/* A box at rest on a slope of atan 0.4: sticks with friction 0.6, slides when it drops to 0.1. */
static void friction_change_acts_on_resting_contacts(void)
{
	int32_t asleep, on_box;
	for (asleep = 0; asleep < 2; ++asleep)
		for (on_box = 0; on_box < 2; ++on_box) {
			cn_world *world = fixture_world(-10.0f, asleep);
			double angle = atan(0.4), c = cos(angle), s = sin(angle), t = 1.0, a, mu = sqrt(0.6 * 0.1);
			cn_body ground = fixture_box(world, CN_BODY_STATIC, (float)s, (float)-c, (float)angle, 50.0f, 1.0f, 0.6f, 0.0f), box;
			cn_material slippery = fixture_shape_def(0, 0.1f, 0.0f).material;
			cn_pose start, end;
			box = fixture_box(world, CN_BODY_DYNAMIC, (float)(-0.5 * s), (float)(0.5 * c), (float)angle, 0.5f, 0.5f, 0.6f, 0.0f);
			fixture_step(world, 120);
			CHECK(fixture_is_awake(world, box) == !asleep);
			start = fixture_pose(world, box);
			must(cn_shape_set_material(world, fixture_first_shape(world, on_box ? box : ground), &slippery), world, "material");
			fixture_step(world, 60);
			end = fixture_pose(world, box);
			a = 10.0 * (s - mu * c);
			CHECK_LE("error of the slide in 1 s", fabs(hypot((double)(end.position_m.x - start.position_m.x), (double)(end.position_m.y - start.position_m.y)) - 0.5 * a * t * t), SOLVED, "m");
			cn_world_destroy(world);
		}
}

static void restitution_change_acts_at_once(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ball;
	cn_material bouncy = fixture_shape_def(0, 0.6f, 0.9f).material, read;
	double apex = 0.0;
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 30);
	must(cn_shape_set_material(world, fixture_first_shape(world, ball), &bouncy), world, "material");
	must(cn_shape_get_material(world, fixture_first_shape(world, ball), &read), world, "material");
	CHECK(read.restitution == 0.9f);
	must(cn_body_set_velocity(world, ball, 0.0f, -5.0f, 0.0f), world, "velocity"); /* jumped down while it rests */
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		apex = greater(apex, (double)fixture_pose(world, ball).position_m.y - 0.5);
	}
	CHECK_LE("error of the apex / exact", fabs(apex / (0.5 * 4.5 * 4.5 / 10.0) - 1.0), ROUNDING, "");
	cn_world_destroy(world);
}

/* ---- filters ---- */

static int32_t filters_collide(const cn_filter *a, const cn_filter *b)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ground = fixture_floor(world, 0.6f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	int32_t collide;
	must(cn_shape_set_filter(world, fixture_first_shape(world, ground), a), world, "filter");
	must(cn_shape_set_filter(world, fixture_first_shape(world, box), b), world, "filter");
	fixture_step(world, 20);
	collide = fixture_pose(world, box).position_m.y > 0.45f;
	cn_world_destroy(world);
	return collide;
}

static void filters_decide_who_collides(void)
{
	static const uint64_t bits[] = { 0, 1, 2, (uint64_t)1 << 63, ~(uint64_t)0 };
	static const int32_t groups[] = { 0, 3, -3, 4 };
	size_t i, j, k, l;
	int32_t wrong = 0, yes = 0;
	for (i = 0; i < 5; ++i)
		for (j = 0; j < 5; ++j)
			for (k = 0; k < 4; ++k)
				for (l = 0; l < 4; ++l) {
					cn_filter a = { 0, 0, 0, 0 }, b = { 0, 0, 0, 0 };
					int32_t expected;
					a.category = bits[i];
					a.mask = bits[4 - j];
					b.category = bits[j];
					b.mask = bits[(i + j) % 5];
					a.group = groups[k];
					b.group = groups[l];
					expected = a.group == b.group && a.group != 0 ? a.group > 0 : (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
					wrong += filters_collide(&a, &b) != expected;
					yes += expected;
				}
	printf("  %d of 400 pairs collide\n", (int)yes);
	CHECK_LE("filters that decided wrongly", wrong, 0, "");
}

static void filter_changes_begin_and_end_contacts(void)
{
	int32_t asleep;
	for (asleep = 0; asleep < 2; ++asleep) {
		cn_world *world = fixture_world(-10.0f, asleep);
		cn_filter none = { 1, 0, 0, 0 }, all = { 1, ~(uint64_t)0, 0, 0 };
		cn_body box;
		fixture_floor(world, 0.6f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_step(world, 90);
		must(cn_shape_set_filter(world, fixture_first_shape(world, box), &none), world, "filter");
		fixture_step(world, 6); /* sinks 5 cm */
		CHECK_LE("height of the box that falls through", fixture_pose(world, box).position_m.y, 0.46, "m");
		must(cn_shape_set_filter(world, fixture_first_shape(world, box), &all), world, "filter");
		fixture_step(world, 60);
		CHECK_LE("error of its height when the floor holds again", fabs((double)fixture_pose(world, box).position_m.y - 0.5), SAG_M, "m");
		cn_world_destroy(world);
	}
}

/* ---- ground ---- */

enum { SLIDE_CIRCLE, SLIDE_BOX, SLIDE_CAPSULE, SLIDE_ROUNDED, SLIDE_TRIANGLE, SLIDES };
static const char *const slide_names[] = { "circle", "box", "capsule", "rounded box", "triangle" };
enum { GROUND_CHAIN, GROUND_EDGES, GROUND_EDGES_BACK, GROUND_BOXES, GROUNDS };
static const char *const ground_names[] = { "chain", "separate edges", "separate edges seen from behind", "separate boxes" };

static void ground_make(cn_world *world, int32_t what)
{
	cn_body ground = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
	cn_vec2 points[61];
	int32_t k;
	for (k = 0; k <= 60; ++k) {
		points[k].x = 30.0f - (float)k;
		points[k].y = 0.0f;
	}
	if (what == GROUND_CHAIN) {
		chain_of(world, ground, points, 61, 0, 0.3f);
		return;
	}
	for (k = 0; k < 60; ++k) {
		cn_shape_def def = fixture_shape_def(ground, 0.3f, 0.0f);
		cn_edge edge;
		if (what == GROUND_BOXES) {
			def.offset_m.x = points[k].x - 0.5f;
			def.offset_m.y = -0.5f;
			fixture_box_shape(world, &def, 0.5f, 0.5f);
			continue;
		}
		edge.a_m = points[what == GROUND_EDGES ? k : k + 1];
		edge.b_m = points[what == GROUND_EDGES ? k + 1 : k];
		must(cn_shape_create_edge(world, &def, &edge, NULL), world, "edge");
	}
}

static cn_body slider_make(cn_world *world, int32_t what, float *height)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, -20.3f, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.3f, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.4f };
	cn_capsule capsule = { { -0.4f, 0.0f }, { 0.4f, 0.0f }, 0.25f };
	cn_polygon triangle;
	*height = 0.25f;
	switch (what) {
	case SLIDE_CIRCLE:
		must(cn_shape_create_circle(world, &def, &circle, NULL), world, "circle");
		*height = 0.4f;
		break;
	case SLIDE_BOX: fixture_box_shape(world, &def, 0.4f, 0.25f); break;
	case SLIDE_CAPSULE: must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "capsule"); break;
	case SLIDE_ROUNDED: must(cn_shape_create_box(world, &def, 0.35f, 0.2f, 0.05f, NULL), world, "rounded"); break;
	default:
		memset(&triangle, 0, sizeof triangle);
		triangle.count = 3;
		triangle.points_m[0].x = -0.5f;
		triangle.points_m[1].x = 0.5f;
		triangle.points_m[2].y = 0.6f;
		must(cn_shape_create_polygon(world, &def, &triangle, NULL), world, "triangle");
		*height = 0.0f;
	}
	must(cn_body_set_pose(world, body, -20.3f, *height, 0.0f), world, "pose");
	return body;
}

/* The worst of all slides. */
typedef struct slide {
	double bump, tilt, speed; /* metres, radians, share of the speed at first */
} slide;

/* Slides 5 m/s at first over a vertex every metre; circles roll without slip. */
static void slide_run(int32_t ground, int32_t what, int32_t fast, slide *most)
{
	cn_world *world = fixture_world(-10.0f, 0);
	float height, v0 = fast ? 20.0f : 5.0f, mu = 0.3f;
	cn_body body;
	double bump = 0.0, tilt = 0.0, v, exact, worst = 0.0;
	int32_t k, steps = fast ? 100 : 60;
	ground_make(world, ground);
	body = slider_make(world, what, &height);
	fixture_step(world, 60);
	fixture_set_velocity(world, body, v0, 0.0f, what == SLIDE_CIRCLE ? -v0 / 0.4f : 0.0f);
	for (k = 1; k <= steps; ++k) {
		cn_pose p;
		fixture_step(world, 1);
		p = fixture_pose(world, body);
		bump = greater(bump, fabs((double)(p.position_m.y - height)));
		if (what != SLIDE_CIRCLE)
			tilt = greater(tilt, fabs((double)p.sine));
		v = (double)fixture_velocity(world, body).linear_mps.x;
		exact = what == SLIDE_CIRCLE ? (double)v0 : (double)v0 - 10.0 * (double)mu * k / 60.0;
		worst = greater(worst, fabs(v - exact));
	}
	worst /= (double)v0;
	if (bump > 1e-3 || tilt > 1e-3 || worst > 1e-3)
		printf("  %s over %s at %.0f m/s: bump %.5f m, tilt %.5f, speed error %.4f\n", slide_names[what], ground_names[ground], (double)v0, bump, tilt, worst);
	most->bump = greater(most->bump, bump);
	most->tilt = greater(most->tilt, tilt);
	most->speed = greater(most->speed, worst);
	cn_world_destroy(world);
}

static void things_slide_over_flat_ground_without_bumps(void)
{
	int32_t ground, what, fast;
	slide most = { 0.0, 0.0, 0.0 };
	for (ground = 0; ground < GROUNDS; ++ground)
		for (what = 0; what < SLIDES; ++what)
			for (fast = 0; fast < 2; ++fast)
				slide_run(ground, what, fast, &most);
	CHECK_LE("bump", most.bump, 1e-3, "m");
	CHECK_LE("tilt", most.tilt, 1e-3, "rad");
	CHECK_LE("error of the speed / speed at first", most.speed, 1e-3, "");
}

/* Along a slope, through a valley and over a hill of a chain: contact all the way, no kicks. */
static void things_slide_over_smooth_hills_without_kicks(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_vec2 points[201];
	cn_body ground = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), ball;
	double start, worst = 0.0;
	int32_t k;
	for (k = 0; k <= 200; ++k) {
		points[k].x = 20.0f - 0.2f * (float)k;
		points[k].y = (float)(1.0 - cos((double)points[k].x * PI / 10.0));
	}
	chain_of(world, ground, points, 201, 0, 0.0f);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, -8.0f, (float)(1.0 - cos(0.8 * PI)) + 0.32f, 0.3f, 0.0f, 0.0f);
	fixture_step(world, 2);
	start = 10.0 * (double)fixture_pose(world, ball).position_m.y;
	for (k = 0; k < 600; ++k) { /* without friction it swings for ever: energy stays, but for the corners of the chain */
		cn_velocity v;
		double energy;
		fixture_step(world, 1);
		v = fixture_velocity(world, ball);
		energy = 10.0 * (double)fixture_pose(world, ball).position_m.y + 0.5 * (pow((double)v.linear_mps.x, 2) + pow((double)v.linear_mps.y, 2));
		worst = greater(worst, energy - start);
	}
	CHECK_LE("energy gained / energy of the swing", worst / (start - 3.0), 0.01, "");
	CHECK_GE("swing after 10 s is still inside of the valley", fabs((double)fixture_pose(world, ball).position_m.x) < 9.0, 1, "");
	cn_world_destroy(world);
}

static void edges_hold_from_both_sides(void)
{
	static const float directions[] = { 1.0f, -1.0f };
	size_t d;
	for (d = 0; d < 2; ++d) {
		cn_world *world = fixture_world(-10.0f * directions[d], 0);
		cn_body ground = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), ball, box;
		cn_shape_def def = fixture_shape_def(ground, 0.6f, 0.0f);
		cn_edge edge = { { -5.0f, 0.0f }, { 5.0f, 0.0f } }, read;
		cn_shape shape;
		must(cn_shape_create_edge(world, &def, &edge, &shape), world, "edge");
		must(cn_shape_get_edge(world, shape, &read), world, "edge");
		CHECK(memcmp(&read, &edge, sizeof edge) == 0);
		ball = fixture_circle(world, CN_BODY_DYNAMIC, -2.0f, 2.0f * directions[d], 0.5f, 0.6f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 2.0f * directions[d], 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_step(world, 120);
		CHECK_LE("error of the ball's height", fabs((double)(fixture_pose(world, ball).position_m.y * directions[d] - 0.5f)), SAG_M, "m");
		CHECK_LE("error of the box's height", fabs((double)(fixture_pose(world, box).position_m.y * directions[d] - 0.5f)), SAG_M, "m");
		cn_world_destroy(world);
	}
}

static void chains_hold_from_the_front_only(void)
{
	int32_t loop, what;
	for (loop = 0; loop < 2; ++loop)
		for (what = 0; what < 3; ++what) {
			static const cn_vec2 open[] = { { 5.0f, 0.0f }, { 1.0f, 0.0f }, { -1.0f, 0.0f }, { -5.0f, 0.0f } };
			static const cn_vec2 block[] = { { 5.0f, 0.0f }, { -5.0f, 0.0f }, { -5.0f, -9.0f }, { 5.0f, -9.0f } }; /* counter-clockwise */
			cn_world *world = fixture_world(0.0f, 0);
			cn_body ground = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), front, back;
			double top;
			chain_of(world, ground, loop ? block : open, 4, (uint32_t)loop, 0.6f);
			front = what == 0 ? fixture_circle(world, CN_BODY_DYNAMIC, -2.0f, 2.0f, 0.3f, 0.6f, 0.0f)
			                  : fixture_box(world, CN_BODY_DYNAMIC, -2.0f, 2.0f, 0.0f, what == 1 ? 0.3f : 0.1f, 0.3f, 0.6f, 0.0f);
			back = what == 0 ? fixture_circle(world, CN_BODY_DYNAMIC, 2.0f, -2.0f, 0.3f, 0.6f, 0.0f)
			                 : fixture_box(world, CN_BODY_DYNAMIC, 2.0f, -2.0f, 0.0f, what == 1 ? 0.3f : 0.1f, 0.3f, 0.6f, 0.0f);
			fixture_set_velocity(world, front, 0.0f, -3.0f, 0.0f);
			fixture_set_velocity(world, back, 0.0f, 3.0f, 0.0f);
			fixture_step(world, 120);
			top = (double)fixture_pose(world, front).position_m.y;
			CHECK_LE("error of the height of what came from the front", fabs(top - 0.3), SAG_M, "m");
			CHECK_LE("error of the way of what came from behind", fabs((double)fixture_pose(world, back).position_m.y - 4.0), ROUNDING, "m");
			cn_world_destroy(world);
		}
}

/* ---- polygons ---- */

static void rounded_polygons_are_as_large_as_they_say(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f), ball;
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_shape shape;
	cn_mass_data m;
	cn_aabb box;
	int32_t inside;
	double area = 4.0 * 0.5 * 0.3 + 2.0 * 0.1 * 2.0 * 0.8 + PI * 0.01; /* the box, four strips, four quarter discs */
	fixture_floor(world, 0.6f, 0.0f);
	must(cn_shape_create_box(world, &def, 0.5f, 0.3f, 0.1f, &shape), world, "rounded box");
	must(cn_shape_get_mass_data(world, shape, &m), world, "mass");
	CHECK_LE("error of its area / area", fabs((double)m.mass_kg / area - 1.0), ROUNDING, "");
	must(cn_shape_get_aabb(world, shape, &box), world, "aabb");
	CHECK_LE("error of its box", fabs((double)(box.upper_m.x - box.lower_m.x) - 1.2) + fabs((double)(box.upper_m.y - box.lower_m.y) - 0.8), 1e-5, "m");
	must(cn_shape_test_point(world, shape, 0.58f, 1.38f, &inside), world, "point"); /* beyond the round corner */
	CHECK(!inside);
	must(cn_shape_test_point(world, shape, 0.56f, 1.36f, &inside), world, "point");
	CHECK(inside);
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 2.5f, 0.25f, 0.6f, 0.0f);
	fixture_step(world, 180);
	CHECK_LE("error of its height at rest", fabs((double)fixture_pose(world, body).position_m.y - 0.4), SAG_M, "m");
	CHECK_LE("error of the height of a ball on it", fabs((double)fixture_pose(world, ball).position_m.y - 1.05), 2.0 * SAG_M, "m");
	cn_world_destroy(world);
}

static double hull_area(const cn_polygon *p)
{
	double area = 0.0;
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		cn_vec2 a = p->points_m[k], b = p->points_m[(k + 1) % p->count];
		area += 0.5 * ((double)a.x * (double)b.y - (double)a.y * (double)b.x);
	}
	return area;
}

static void hulls_hold_their_points(void)
{
	uint32_t seed = 3;
	int32_t trial, k, i, outside = 0;
	double worst = 0.0, least = 1.0;
	for (trial = 0; trial < 100; ++trial) {
		cn_vec2 points[60];
		cn_polygon hull;
		int32_t count = 4 + trial % 57;
		cn_world *world = fixture_world(0.0f, 0);
		cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
		for (k = 0; k < count; ++k) { /* in a disc, so that there may be more corners than a polygon holds */
			double angle = (double)fixture_random(&seed, -3.14f, 3.14f), r = 2.0 * sqrt((double)fixture_random(&seed, 0.0f, 1.0f));
			points[k].x = (float)(r * cos(angle));
			points[k].y = (float)(r * sin(angle));
		}
		must(cn_polygon_make_hull(points, count, 0.0f, &hull), NULL, "cn_polygon_make_hull");
		CHECK(hull.count >= 3 && hull.count <= CN_POLYGON_MAX_VERTICES && hull_area(&hull) > 0.0);
		must(cn_shape_create_polygon(world, &def, &hull, NULL), world, "polygon"); /* it is one that shapes take */
		for (i = 0; i < hull.count; ++i) {
			cn_vec2 a = hull.points_m[i], b = hull.points_m[(i + 1) % hull.count], c = hull.points_m[(i + 2) % hull.count];
			double length = hypot((double)(b.x - a.x), (double)(b.y - a.y));
			double turn = ((double)b.x - (double)a.x) * ((double)c.y - (double)b.y) - ((double)b.y - (double)a.y) * ((double)c.x - (double)b.x);
			least = fmin(least, turn);
			for (k = 0; k < count; ++k) {
				double out = (((double)points[k].x - (double)a.x) * ((double)b.y - (double)a.y) - ((double)points[k].y - (double)a.y) * ((double)b.x - (double)a.x)) / length;
				worst = greater(worst, out);
				outside += out > 0.1;
			}
		}
		cn_world_destroy(world);
	}
	CHECK_LE("farthest point outside of its simplified hull", worst, 5e-3, "m");
	CHECK_GE("least turn at a corner (convex: > 0)", least, 1e-7, "m^2");
	CHECK_LE("points left out", outside, 0, "");
	{
		static const cn_vec2 line[] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 } }, same[] = { { 1, 1 }, { 1, 1 }, { 1, 1 } };
		cn_polygon hull;
		CHECK(cn_polygon_make_hull(line, 4, 0.0f, &hull) == CN_ERROR_ARGUMENT && cn_polygon_make_hull(same, 3, 0.0f, &hull) == CN_ERROR_ARGUMENT);
	}
}

static void shapes_sit_where_their_offset_says(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 10.0f, 20.0f, (float)(0.5 * PI));
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_circle circle = { { 1.0f, 0.0f }, 0.25f }, read;
	cn_shape shape, box;
	cn_aabb bounds;
	cn_polygon polygon;
	def.offset_m.x = 2.0f;
	def.angle_rad = (float)(0.5 * PI);
	must(cn_shape_create_circle(world, &def, &circle, &shape), world, "circle");
	must(cn_shape_get_circle(world, shape, &read), world, "circle");
	CHECK_LE("error of the local centre", hypot((double)read.center_m.x - 2.0, (double)read.center_m.y - 1.0), 1e-6, "m");
	must(cn_shape_get_aabb(world, shape, &bounds), world, "aabb");
	CHECK_LE("error of the world box", hypot((double)bounds.lower_m.x - 8.75, (double)bounds.upper_m.y - 22.25), 1e-5, "m");
	box = fixture_box_shape(world, &def, 1.0f, 0.5f);
	must(cn_shape_get_aabb(world, box, &bounds), world, "aabb"); /* turned twice by 90 degrees */
	CHECK_LE("error of the turned box", hypot((double)bounds.lower_m.x - 9.0, (double)bounds.upper_m.y - 22.5), 1e-5, "m");
	must(cn_shape_get_polygon(world, box, &polygon), world, "polygon");
	CHECK(polygon.count == 4 && cn_shape_get_circle(world, box, &read) == CN_ERROR_STATE);
	cn_world_destroy(world);
}

/* ---- levels: one static body of many tiles ---- */

static cn_shape tile(cn_world *world, cn_body body, int32_t k)
{
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.offset_m.x = (float)(k % 1000);
	def.offset_m.y = -(float)(k / 1000);
	return fixture_box_shape(world, &def, 0.5f, 0.5f);
}

/* Tiles that came last, beyond all others, hold as the first; others do when some have gone; and they weigh what they should when
   their body becomes dynamic. */
static void tiles_hold_wherever_they_are(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body level = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), balls[3];
	cn_shape first = tile(world, level, 0), far_away, middle;
	int32_t k;
	middle = tile(world, level, 30);
	far_away = tile(world, level, 200);
	balls[0] = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.3f, 0.6f, 0.0f);
	balls[1] = fixture_circle(world, CN_BODY_DYNAMIC, 30.0f, 1.5f, 0.3f, 0.6f, 0.0f);
	balls[2] = fixture_circle(world, CN_BODY_DYNAMIC, 200.0f, 1.5f, 0.3f, 0.6f, 0.0f);
	fixture_step(world, 120);
	for (k = 0; k < 3; ++k)
		CHECK_LE("ball above its tile", fabs((double)fixture_pose(world, balls[k]).position_m.y - 0.8), 0.01, "m");
	must(cn_shape_destroy(world, far_away), world, "cn_shape_destroy");
	must(cn_shape_destroy(world, first), world, "cn_shape_destroy");
	(void)tile(world, level, 31);
	fixture_step(world, 60);
	CHECK_LE("ball on a tile that stayed", fabs((double)fixture_pose(world, balls[1]).position_m.y - 0.8), 0.01, "m");
	CHECK(fixture_pose(world, balls[0]).position_m.y < 0.0f && fixture_pose(world, balls[2]).position_m.y < 0.0f);
	must(cn_body_set_type(world, level, CN_BODY_DYNAMIC), world, "cn_body_set_type");
	CHECK_LE("error of the mass of two tiles", fabs((double)mass_of(world, level).mass_kg - 2.0), 1e-5, "kg");
	CHECK_LE("error of their centre", fabs((double)mass_of(world, level).center_m.x - 30.5), 1e-4, "m");
	must(cn_shape_destroy(world, middle), world, "cn_shape_destroy");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(compound_mass_is_the_closed_form);
	RUN(mass_follows_density_and_attachment);
	RUN(friction_change_acts_on_resting_contacts);
	RUN(restitution_change_acts_at_once);
	RUN(filters_decide_who_collides);
	RUN(filter_changes_begin_and_end_contacts);
	RUN(things_slide_over_flat_ground_without_bumps);
	RUN(things_slide_over_smooth_hills_without_kicks);
	RUN(edges_hold_from_both_sides);
	RUN(chains_hold_from_the_front_only);
	RUN(rounded_polygons_are_as_large_as_they_say);
	RUN(hulls_hold_their_points);
	RUN(shapes_sit_where_their_offset_says);
	RUN(tiles_hold_wherever_they_are);
	return test_end();
}
