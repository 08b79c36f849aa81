/*
 * mover_plane_test - promise: the plane solver finds the nearest translation that its planes allow, within its pushes; the
 * planes of a shape are those that it touches, each once, and none that another one covers.
 *
 * Checked against all intersections of one and two planes in double precision.
 */
#include "world/fixture.h"
#include <float.h>

/* ------------------------------------------------------------------ the solver */

static uint32_t seed = 3u;
static float rnd(float lower, float upper) { return fixture_random(&seed, lower, upper); }

static double height(const cn_plane *p, double x, double y) { return (double)p->separation_m + (double)p->normal.x * x + (double)p->normal.y * y; }

static int allowed(const cn_plane *p, int32_t count, double give, double x, double y)
{
	for (int32_t i = 0; i < count; ++i)
		if (height(p + i, x, y) < -give - 1e-9)
			return 0;
	return 1;
}

static void keep(const cn_plane *p, int32_t count, double give, const double wanted[2], double x, double y, double *best)
{
	double distance = hypot(x - wanted[0], y - wanted[1]);
	if (distance < *best && allowed(p, count, give, x, y))
		*best = distance;
}

/* Distance of the nearest translation when all planes give way by so much (negative: are stricter); 1e300 when none is allowed. */
static double nearest(const cn_plane *p, int32_t count, double give, const double wanted[2])
{
	double best = 1e300;
	int32_t i, j;
	keep(p, count, give, wanted, wanted[0], wanted[1], &best);
	for (i = 0; i < count; ++i) {
		double nx = (double)p[i].normal.x, ny = (double)p[i].normal.y, length = nx * nx + ny * ny, s = (double)p[i].separation_m + give;
		double h = s + nx * wanted[0] + ny * wanted[1];
		keep(p, count, give, wanted, wanted[0] - h * nx / length, wanted[1] - h * ny / length, &best);
		for (j = 0; j < i; ++j) {
			double mx = (double)p[j].normal.x, my = (double)p[j].normal.y, c = nx * my - ny * mx, r = (double)p[j].separation_m + give;
			if (fabs(c) > 1e-9)
				keep(p, count, give, wanted, (r * ny - s * my) / c, (s * mx - r * nx) / c, &best);
		}
	}
	return best;
}

/* share: of planes that are nearly parallel to the one before. */
static int32_t random_planes(cn_plane *p, float share)
{
	int32_t count = 1 + (int32_t)rnd(0.0f, 5.99f), i;
	memset(p, 0, 6 * sizeof *p);
	for (i = 0; i < count; ++i) {
		double angle = (double)rnd(-3.1f, 3.1f);
		if (i > 0 && rnd(0.0f, 1.0f) < share) /* nearly along or against the one before */
			angle = atan2((double)p[i - 1].normal.y, (double)p[i - 1].normal.x) + (double)rnd(-1e-3f, 1e-3f) + (rnd(0.0f, 1.0f) < 0.2f ? 3.14159265 : 0.0);
		p[i].normal.x = (float)cos(angle);
		p[i].normal.y = (float)sin(angle);
		p[i].separation_m = rnd(-0.3f, 0.3f);
		p[i].push_max_m = FLT_MAX;
	}
	return count;
}

/* GIVE: what rounding may make of a plane. The distance found lies between those for planes that give way by it and for stricter ones. */
#define GIVE 4e-6

static void t_finds_the_nearest(void)
{
	int32_t k, i, impossible = 0, pushed = 0, wrong = 0;
	double overlap = 0.0, worst = 0.0;
	for (k = 0; k < 50000; ++k) {
		cn_plane p[6];
		int32_t count = random_planes(p, 0.2f);
		double wanted[2], loose, strict, found;
		cn_vec2 out;
		float left;
		wanted[0] = (double)rnd(-1.0f, 1.0f);
		wanted[1] = (double)rnd(-1.0f, 1.0f);
		must(cn_mover_solve(p, count, (float)wanted[0], (float)wanted[1], &out, &left), NULL, "solve");
		found = hypot((double)out.x - wanted[0], (double)out.y - wanted[1]);
		loose = nearest(p, count, GIVE, wanted);
		strict = nearest(p, count, -GIVE, wanted);
		if (loose > 1e299) {
			++impossible;
			wrong += !((double)left > 0.0);
			continue;
		}
		if (strict > 2.0) /* none, or only where planes that are nearly opposite cross */
			continue;
		overlap = greater(overlap, (double)left);
		worst = greater(worst, fmax(loose - found, found - strict));
		for (i = 0; i < count; ++i) {
			pushed += p[i].push_m > 0.0f;
			wrong += !(p[i].push_m >= 0.0f);
		}
	}
	CHECK_LE("beyond what is nearest, up to rounding of the planes", worst, 1e-6, "m");
	CHECK_LE("overlap left", overlap, 4e-6, "m");
	CHECK_LE("wrong pushes and overlaps", wrong, 0, "");
	CHECK_GE("pushes", pushed, 10000, "");
	CHECK_GE("sets that leave no room", impossible, 100, "");
}

/* With bounded pushes: what makes a point the nearest (Karush, Kuhn, Tucker): it is wanted plus all pushes, a plane that it is in front
   of does not push, and one that it is behind of pushes its most. */
static void t_pushes_are_bounded(void)
{
	int32_t k, i, saturated = 0, wrong = 0, sets = 0;
	double off = 0.0;
	for (k = 0; k < 50000; ++k) {
		cn_plane p[6];
		int32_t count = random_planes(p, 0.0f); /* how parallel planes share a push is open */
		double x, y;
		cn_vec2 wanted, out;
		float left;
		for (i = 0; i < count; ++i)
			if (rnd(0.0f, 1.0f) < 0.6f)
				p[i].push_max_m = rnd(0.0f, 0.5f);
		wanted.x = rnd(-1.0f, 1.0f);
		wanted.y = rnd(-1.0f, 1.0f);
		must(cn_mover_solve(p, count, wanted.x, wanted.y, &out, &left), NULL, "solve");
		if (left > 1e-5f) /* no room */
			continue;
		++sets;
		x = (double)wanted.x;
		y = (double)wanted.y;
		for (i = 0; i < count; ++i) {
			double h = height(p + i, (double)out.x, (double)out.y);
			x += (double)(p[i].push_m * p[i].normal.x);
			y += (double)(p[i].push_m * p[i].normal.y);
			saturated += p[i].push_m > 0.0f && p[i].push_m >= p[i].push_max_m;
			wrong += (h > 1e-4 && p[i].push_m > 1e-4f) || (h < -1e-4 && p[i].push_m < p[i].push_max_m);
		}
		off = greater(off, hypot(x - (double)out.x, y - (double)out.y) / (1.0 + hypot(x, y)));
	}
	CHECK_LE("planes that push what they need not, or too little", wrong, 0, "");
	CHECK_GE("planes that push their most", saturated, 10000, "");
	CHECK_GE("sets", sets, 25000, "");
	CHECK_LE("off the wanted translation and all pushes", off, 2e-3, "of the way");
}

static cn_plane plane(float x, float y, float separation, float most)
{
	cn_plane p;
	memset(&p, 0, sizeof p);
	p.normal.x = x;
	p.normal.y = y;
	p.separation_m = separation;
	p.push_max_m = most;
	return p;
}

static void t_known_answers(void)
{
	cn_plane p[3];
	cn_vec2 out;
	float left;
	/* A floor: the part into it is taken out. */
	p[0] = plane(0.0f, 1.0f, 0.0f, FLT_MAX);
	must(cn_mover_solve(p, 1, 3.0f, -2.0f, &out, &left), NULL, "solve");
	CHECK(out.x == 3.0f && out.y == 0.0f && left == 0.0f && p[0].push_m == 2.0f);
	/* A soft one pushes no farther than it may. */
	p[0].push_max_m = 0.5f;
	must(cn_mover_solve(p, 1, 3.0f, -2.0f, &out, &left), NULL, "solve");
	CHECK(out.y == -1.5f && p[0].push_m == 0.5f && left == 0.0f);
	/* Between two walls that overlap it by 0.1 m each there is no room: the middle. */
	p[0] = plane(1.0f, 0.0f, -0.1f, FLT_MAX);
	p[1] = plane(-1.0f, 0.0f, -0.1f, FLT_MAX);
	must(cn_mover_solve(p, 2, 0.0f, 1.0f, &out, &left), NULL, "solve");
	CHECK_LE("off the middle", fabs((double)out.x), 1e-6, "m");
	CHECK_LE("error of the overlap", fabs((double)left - 0.1), 1e-6, "m");
	CHECK(out.y == 1.0f);
	/* Velocities: only what pushed counts. */
	p[0] = plane(0.0f, 1.0f, 0.0f, FLT_MAX);
	p[1] = plane(1.0f, 0.0f, 0.0f, FLT_MAX);
	p[0].push_m = 1.0f;
	must(cn_mover_clip(p, 2, -3.0f, -4.0f, &out), NULL, "clip");
	CHECK(out.x == -3.0f && out.y == 0.0f);
	must(cn_mover_clip(p, 2, 3.0f, 4.0f, &out), NULL, "clip");
	CHECK(out.x == 3.0f && out.y == 4.0f);
	must(cn_mover_solve(NULL, 0, 3.0f, -2.0f, &out, &left), NULL, "solve");
	CHECK(out.x == 3.0f && out.y == -2.0f);
}

/* ------------------------------------------------------------------ the planes */

static cn_world *w;

static int32_t planes_at(const cn_polygon *shape, float x, float y, float margin, uint32_t flags, cn_plane *out)
{
	cn_query_filter filter;
	int32_t count;
	cn_query_filter_init(&filter);
	filter.flags = flags;
	must(cn_mover_collide(w, shape, x, y, margin, &filter, out, 8, &count), w, "collide");
	return count;
}

static void t_planes_are_what_is_touched(void)
{
	cn_polygon capsule = { 2, 0.3f, { { 0.0f, -0.5f }, { 0.0f, 0.5f } } };
	cn_plane p[8];
	cn_body floor, wall;
	int32_t count;
	w = fixture_world(0.0f, 1);
	floor = fixture_floor(w, 0.5f, 0.0f);
	wall = fixture_box(w, CN_BODY_STATIC, 2.0f, 2.0f, 0.0f, 1.0f, 3.0f, 0.5f, 0.0f);
	count = planes_at(&capsule, 0.68f, 0.79f, 0.05f, 0, p); /* 1 cm in the floor, 2 cm from the wall */
	CHECK(count == 2 && p[0].body == floor && p[1].body == wall);
	CHECK(p[0].normal.y == 1.0f && p[1].normal.x == -1.0f && p[0].push_max_m == FLT_MAX);
	CHECK_LE("error of the separations", fabs((double)p[0].separation_m + 0.01) + fabs((double)p[1].separation_m - 0.02), 1e-6, "m");
	CHECK(planes_at(&capsule, 0.68f, 0.79f, 0.01f, 0, p) == 1 && planes_at(&capsule, 0.0f, 2.0f, 0.05f, 0, p) == 0);
	cn_world_destroy(w);
}

/* A mover with corners beside round shapes: the separation is that of the centre from the polygon less the radius, from both orders. */
static void t_planes_of_round_shapes(void)
{
	cn_polygon slab = { 4, 0.0f, { { -0.5f, -0.4f }, { 0.5f, -0.4f }, { 0.5f, 0.4f }, { -0.5f, 0.4f } } };
	cn_capsule capsule = { { -1.0f, 0.0f }, { 1.0f, 0.0f }, 0.25f };
	cn_shape_def sd;
	cn_plane p[8];
	w = fixture_world(0.0f, 1);
	fixture_circle(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 10.0f, 0.0f, 0.5f * (float)acos(-1.0)), 0.5f, 0.0f);
	must(cn_shape_create_capsule(w, &sd, &capsule, NULL), w, "cn_shape_create_capsule");
	CHECK(planes_at(&slab, 0.2f, 0.92f, 0.05f, 0, p) == 1);
	CHECK_LE("above a disc: error of the separation", fabs((double)p[0].separation_m - 0.02), 1e-6, "m");
	CHECK_LE("error of the normal", fabs((double)p[0].normal.x) + fabs((double)p[0].normal.y - 1.0), 1e-6, "");
	CHECK(planes_at(&slab, 0.8f, 0.7f, 0.05f, 0, p) == 1);
	CHECK_LE("a corner beside a disc: error of the separation", fabs((double)p[0].separation_m - (hypot(0.3, 0.3) - 0.5)), 1e-6, "m");
	CHECK_LE("error of the normal", fabs((double)p[0].normal.x - sqrt(0.5)) + fabs((double)p[0].normal.y - sqrt(0.5)), 1e-5, "");
	CHECK(planes_at(&slab, 9.27f, 0.3f, 0.05f, 0, p) == 1);
	CHECK_LE("beside an upright capsule: error of the separation", fabs((double)p[0].separation_m + 0.02), 1e-6, "m");
	CHECK_LE("error of the normal", fabs((double)p[0].normal.x + 1.0), 1e-6, "");
	cn_world_destroy(w);
}

/* Of a row of tiles at one height only those under its feet; a tile that is higher by a millimetre is one more. */
static void t_tiles_behind_a_plane_are_left_out(void)
{
	cn_polygon capsule = { 2, 0.3f, { { 0.0f, -0.5f }, { 0.0f, 0.5f } } };
	cn_plane p[8];
	int32_t k, tilted = 0;
	w = fixture_world(0.0f, 1);
	for (k = 0; k < 5; ++k)
		fixture_box(w, CN_BODY_STATIC, (float)k, k == 4 ? -0.499f : -0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	for (k = 0; k < 300; ++k) {
		int32_t count = planes_at(&capsule, 0.01f * (float)k, 0.8f, 0.02f, 0, p);
		tilted += count != 1 || p[0].normal.x != 0.0f;
	}
	CHECK_LE("places with other planes than the floor's", tilted, 0, "of 300");
	CHECK(planes_at(&capsule, 3.45f, 0.8f, 0.02f, 0, p) == 2 && p[0].normal.x == 0.0f && p[1].normal.x < 0.0f);
	cn_world_destroy(w);
}

static void t_one_way_planes(void)
{
	cn_polygon capsule = { 2, 0.3f, { { 0.0f, -0.5f }, { 0.0f, 0.5f } } };
	cn_plane p[8];
	cn_shape_def sd;
	w = fixture_world(0.0f, 1);
	sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, -0.1f, 0.0f), 0.5f, 0.0f);
	sd.flags = CN_SHAPE_ONE_WAY;
	fixture_box_shape(w, &sd, 2.0f, 0.1f);
	CHECK(planes_at(&capsule, 0.0f, 0.8f, 0.01f, CN_QUERY_ONE_WAY, p) == 1);
	CHECK(planes_at(&capsule, 0.0f, 0.796f, 0.01f, CN_QUERY_ONE_WAY, p) == 1);
	CHECK(planes_at(&capsule, 0.0f, 0.79f, 0.01f, CN_QUERY_ONE_WAY, p) == 0);
	CHECK(planes_at(&capsule, 0.0f, -1.0f, 0.01f, CN_QUERY_ONE_WAY, p) == 0);
	CHECK(planes_at(&capsule, 2.3f, 0.0f, 0.01f, CN_QUERY_ONE_WAY, p) == 0);
	CHECK(planes_at(&capsule, 0.0f, 0.79f, 0.01f, 0, p) == 1 && planes_at(&capsule, 0.0f, -1.0f, 0.01f, 0, p) == 1);
	cn_world_destroy(w);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_finds_the_nearest);
	RUN(t_pushes_are_bounded);
	RUN(t_known_answers);
	RUN(t_planes_are_what_is_touched);
	RUN(t_planes_of_round_shapes);
	RUN(t_tiles_behind_a_plane_are_left_out);
	RUN(t_one_way_planes);
	return test_end();
}
