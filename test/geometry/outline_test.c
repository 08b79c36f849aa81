/*
 * outline_test.c - promises of cn_outline_decompose, cn_outline_simplify, cn_outline_from_cells and
 * cn_outline_from_field on random and hostile outlines,
 * against areas, distances and crossing numbers in double precision, and of the exact orientation against integers.
 */
#include "geometry/outline.h"
#include "geometry/shapes.h"
#include "world/fixture.h"

#define THICKNESS 0.0005 /* of a world of length unit 1 */
#define POINTS_MAX 1024
#define TWO_PI 6.283185307179586

typedef struct outline {
	cn_vec2 points[POINTS_MAX];
	int32_t count;
} outline;
typedef struct pieces {
	cn_polygon piece[POINTS_MAX];
	int32_t count;
} pieces;

static outline shape;
static pieces parts;

/* ------------------------------------------------------------------ references */

static double area_of(const cn_vec2 *p, int32_t n)
{
	double sum = 0.0;
	for (int32_t i = 0; i < n; ++i) {
		cn_vec2 a = p[i], b = p[(i + 1) % n];
		sum += ((double)a.x - (double)p[0].x) * ((double)b.y - (double)p[0].y) - ((double)a.y - (double)p[0].y) * ((double)b.x - (double)p[0].x);
	}
	return 0.5 * sum;
}

static double perimeter_of(const cn_vec2 *p, int32_t n)
{
	double sum = 0.0;
	for (int32_t i = 0; i < n; ++i)
		sum += hypot((double)p[(i + 1) % n].x - (double)p[i].x, (double)p[(i + 1) % n].y - (double)p[i].y);
	return sum;
}

static double distance_to_segment(cn_vec2 a, cn_vec2 b, cn_vec2 p)
{
	double ux = (double)b.x - (double)a.x, uy = (double)b.y - (double)a.y, dx = (double)p.x - (double)a.x, dy = (double)p.y - (double)a.y;
	double length_sq = ux * ux + uy * uy;
	double t = length_sq > 0.0 ? fmin(fmax((dx * ux + dy * uy) / length_sq, 0.0), 1.0) : 0.0;
	return hypot(dx - t * ux, dy - t * uy);
}

static double distance_to_row(const cn_vec2 *row, int32_t n, int32_t closed, cn_vec2 p)
{
	double least = 1e30;
	for (int32_t i = 0; i < (closed ? n : n - 1); ++i)
		least = fmin(least, distance_to_segment(row[i], row[(i + 1) % n], p));
	return least;
}

/* Crossing number. */
static int32_t contains(const cn_vec2 *row, int32_t n, cn_vec2 p)
{
	int32_t inside = 0;
	for (int32_t i = 0; i < n; ++i) {
		cn_vec2 a = row[i], b = row[(i + 1) % n];
		if ((a.y > p.y) != (b.y > p.y)
		    && (double)p.x < (double)a.x + ((double)p.y - (double)a.y) * ((double)b.x - (double)a.x) / ((double)b.y - (double)a.y))
			inside = !inside;
	}
	return inside;
}

/* ------------------------------------------------------------------ random simple outlines */

static void make_star(outline *o)
{
	o->count = 4 + random_below(60);
	for (int32_t i = 0; i < o->count; ++i) {
		double angle = TWO_PI * ((double)i + (double)random_in(0.0f, 0.9f)) / (double)o->count, r = (double)random_in(0.5f, 5.0f);
		o->points[i] = cni_v((float)(r * cos(angle)), (float)(r * sin(angle)));
	}
}

static void make_spiral(outline *o)
{
	int32_t half = 10 + random_below(60);
	double turn = (double)random_in(0.1f, 0.4f), growth = (double)random_in(0.1f, 0.5f), width = (double)random_in(0.1f, 0.7f);
	o->count = 2 * half;
	for (int32_t i = 0; i < half; ++i) {
		double angle = turn * (double)i, r = 1.0 + growth * angle;
		o->points[i] = cni_v((float)(r * cos(angle)), (float)(r * sin(angle)));
		r += width * growth * TWO_PI;
		o->points[o->count - 1 - i] = cni_v((float)(r * cos(angle)), (float)(r * sin(angle)));
	}
}

/* Turned by any angle or by none: the feet of all teeth lie on one line. */
static void make_comb(outline *o)
{
	int32_t teeth = 1 + random_below(20);
	cni_transform x = transform_make(random_in(-9, 9), random_in(-9, 9), random_below(2) ? random_in(-3, 3) : 0.0f);
	o->count = 0;
	o->points[o->count++] = cni_v(0.0f, -1.0f);
	o->points[o->count++] = cni_v((float)teeth, -1.0f);
	for (int32_t i = teeth - 1; i >= 0; --i) {
		float height = random_in(0.2f, 4.0f);
		o->points[o->count++] = cni_v((float)i + 0.75f, 0.0f);
		o->points[o->count++] = cni_v((float)i + 0.75f, height);
		o->points[o->count++] = cni_v((float)i + 0.25f, height);
		o->points[o->count++] = cni_v((float)i + 0.25f, 0.0f);
	}
	for (int32_t i = 0; i < o->count; ++i)
		o->points[i] = cni_transform_point(x, o->points[i]);
}

static int32_t cross(cn_vec2 a, cn_vec2 b, cn_vec2 c, cn_vec2 d)
{
	return cni_orientation(a, b, c) * cni_orientation(a, b, d) <= 0 && cni_orientation(c, d, a) * cni_orientation(c, d, b) <= 0;
}

/* Random points whose edges are exchanged (2-opt) until none cross: needles and narrow bays. */
static void make_tangle(outline *o)
{
	int32_t changed = 1;
	o->count = 4 + random_below(20);
	for (int32_t i = 0; i < o->count; ++i)
		o->points[i] = random_vec(2);
	while (changed) {
		changed = 0;
		for (int32_t i = 0; i < o->count; ++i)
			for (int32_t j = i + 2; j < o->count - (i == 0); ++j) {
				if (!cross(o->points[i], o->points[i + 1], o->points[j], o->points[(j + 1) % o->count]))
					continue;
				changed = 1;
				for (int32_t a = i + 1, b = j; a < b; ++a, --b) {
					cn_vec2 p = o->points[a];
					o->points[a] = o->points[b];
					o->points[b] = p;
				}
			}
	}
}

static void make_random(outline *o, int32_t kind)
{
	static void (*const make[4])(outline *o) = { make_star, make_spiral, make_comb, make_tangle };
	make[kind & 3](o);
	if (random_below(2))
		for (int32_t a = 0, b = o->count - 1; a < b; ++a, --b) {
			cn_vec2 p = o->points[a];
			o->points[a] = o->points[b];
			o->points[b] = p;
		}
}

/* ------------------------------------------------------------------ decomposition */

static cn_result decompose(const outline *o, pieces *out)
{
	return cn_outline_decompose(o->points, o->count, 1.0f, out->piece, POINTS_MAX, &out->count);
}

static double area_of_pieces(const pieces *p)
{
	double sum = 0.0;
	for (int32_t i = 0; i < p->count; ++i)
		sum += area_of(p->piece[i].points_m, p->piece[i].count);
	return sum;
}

/* Random points of which a number of pieces other than 1 inside and 0 outside contains; points near an edge are skipped. */
static int32_t samples_wrong(const outline *o, const pieces *p, int32_t samples)
{
	int32_t wrong = 0;
	for (int32_t k = 0; k < samples; ++k) {
		cn_vec2 a = o->points[random_below(o->count)], b = o->points[random_below(o->count)];
		cn_vec2 x = cni_lerp(a, b, random_in(0, 1));
		int32_t held = 0;
		double near = distance_to_row(o->points, o->count, 1, x);
		for (int32_t i = 0; i < p->count; ++i) {
			near = fmin(near, distance_to_row(p->piece[i].points_m, p->piece[i].count, 1, x));
			held += contains(p->piece[i].points_m, p->piece[i].count, x);
		}
		wrong += near > 2.0 * THICKNESS && held != contains(o->points, o->count, x);
	}
	return wrong;
}

static int32_t shapes_refused(cn_world *world, const pieces *p)
{
	int32_t refused = 0;
	cn_shape_def def = fixture_shape_def(0, 0.5f, 0.0f);
	for (int32_t i = 0; i < p->count; ++i) {
		cn_shape made;
		if (cn_shape_create_polygon(world, &def, &p->piece[i], &made) != CN_OK)
			++refused;
		else
			must(cn_shape_destroy(world, made), world, "destroy");
	}
	return refused;
}

static void t_pieces_cover_the_outline_once(void)
{
	static const char *const names[4] = { "stars", "spirals", "combs", "tangles" };
	cn_world *world = fixture_world(0.0f, 0);
	double lost[4] = { 0.0, 0.0, 0.0, 0.0 }, share = 0.0;
	int32_t refused = 0, wrong = 0, failed = 0, points[4] = { 0, 0, 0, 0 }, made[4] = { 0, 0, 0, 0 };
	for (int32_t k = 0; k < TEST_SAMPLES(1000); ++k) {
		make_random(&shape, k);
		if (decompose(&shape, &parts) != CN_OK) {
			++failed;
			continue;
		}
		double difference = fabs(fabs(area_of(shape.points, shape.count)) - area_of_pieces(&parts));
		lost[k & 3] = greater(lost[k & 3], difference / perimeter_of(shape.points, shape.count));
		share = greater(share, difference / fabs(area_of(shape.points, shape.count)));
		refused += shapes_refused(world, &parts);
		wrong += samples_wrong(&shape, &parts, 20);
		points[k & 3] += shape.count;
		made[k & 3] += parts.count;
	}
	cn_world_destroy(world);
	for (int32_t kind = 0; kind < 4; ++kind) {
		printf("       %s: %d points, %d pieces\n", names[kind], (int)points[kind], (int)made[kind]);
		CHECK_LE(names[kind], 1000.0 * lost[kind], 1e-3, "mm of the perimeter lost or doubled");
	}
	CHECK_LE("share of the area lost or doubled", share, 1e-5, "");
	CHECK_LE("simple outlines refused", failed, 0, "");
	CHECK_LE("pieces that cn_shape_create_polygon refuses", refused, 0, "");
	CHECK_LE("samples not in exactly one piece", wrong, 0, "");
}

/* A minimum for outlines whose best decomposition is known. */
static void t_few_pieces(void)
{
	static const cn_vec2 ell[6] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
	static const cn_vec2 comb[10] = { { 0, 0 }, { 5, 0 }, { 5, 3 }, { 4, 3 }, { 4, 1 }, { 3, 1 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 0, 1 } };
	memcpy(shape.points, ell, sizeof ell);
	shape.count = 6;
	REQUIRE(decompose(&shape, &parts) == CN_OK);
	CHECK_LE("pieces of an L", parts.count, 2, "");
	memcpy(shape.points, comb, sizeof comb);
	shape.count = 10;
	REQUIRE(decompose(&shape, &parts) == CN_OK);
	CHECK_LE("pieces of a comb with two teeth", parts.count, 3, "");
	shape.count = 16;
	for (int32_t i = 0; i < 16; ++i)
		shape.points[i] = cni_v((float)cos(TWO_PI * i / 16.0), (float)sin(TWO_PI * i / 16.0));
	REQUIRE(decompose(&shape, &parts) == CN_OK);
	CHECK_LE("pieces of a convex polygon of 16 points", parts.count, 1, "");
	CHECK(parts.piece[0].count == 16);
	shape.count = POINTS_MAX;
	for (int32_t i = 0; i < POINTS_MAX; ++i)
		shape.points[i] = cni_v((float)(60.0 * cos(TWO_PI * i / POINTS_MAX)), (float)(60.0 * sin(TWO_PI * i / POINTS_MAX)));
	REQUIRE(decompose(&shape, &parts) == CN_OK);
	CHECK_LE("pieces of a circle of 1024 points", parts.count, 90, "");
	CHECK_LE("its area lost", fabs(1.0 - area_of_pieces(&parts) / area_of(shape.points, shape.count)), 1e-6, "share");
}

static cn_result decompose_points(const cn_vec2 *points, int32_t count)
{
	memcpy(shape.points, points, (size_t)count * sizeof *points);
	shape.count = count;
	return decompose(&shape, &parts);
}
#define DECOMPOSE(...) decompose_points((const cn_vec2[]){ __VA_ARGS__ }, (int32_t)(sizeof((const cn_vec2[]){ __VA_ARGS__ }) / sizeof(cn_vec2)))

static void t_hostile_outlines(void)
{
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 }) == CN_ERROR_ARGUMENT);                                   /* crosses itself */
	CHECK(DECOMPOSE({ 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0 }, { 0, 2 }) == CN_ERROR_ARGUMENT);                         /* a point on an edge */
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 1, 1 }, { 0, 2 }) == CN_ERROR_ARGUMENT);               /* a point twice */
	CHECK(DECOMPOSE({ 0, 0 }, { 3, 0 }, { 1, 0 }, { 1, 1 }) == CN_ERROR_ARGUMENT);                                   /* folds back */
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }) == CN_ERROR_ARGUMENT);                                   /* a line */
	CHECK(DECOMPOSE({ 1, 1 }, { 1, 1 }, { 1, 1 }) == CN_ERROR_ARGUMENT);                                             /* a point */
	CHECK(DECOMPOSE({ 0, 0 }, { 10, 0 }, { 5, 1e-6f }) == CN_ERROR_ARGUMENT);                                        /* too thin */
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 0 }, { 1, 1 }) == CN_ERROR_ARGUMENT);               /* around twice */
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 0 }, { (float)NAN, 1 }) == CN_ERROR_ARGUMENT);
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 0 }, { 1, (float)INFINITY }) == CN_ERROR_ARGUMENT);
	CHECK(DECOMPOSE({ 0, 0 }, { 1, 0 }) == CN_ERROR_ARGUMENT);
	/* Close and collinear points are cleaned. */
	CHECK(DECOMPOSE({ 0, 0 }, { 0, 0 }, { 0.5f, 0 }, { 1, 0 }, { 1, 1e-5f }, { 1, 1 }, { 0, 1 }, { 0, 0 }) == CN_OK);
	CHECK(parts.count == 1 && parts.piece[0].count == 4);
	CHECK_LE("area of a cleaned square", fabs(area_of_pieces(&parts) - 1.0), 1e-6, "m^2");
	CHECK(DECOMPOSE({ 1e-30f, 0 }, { 1, -1e-40f }, { 0, 1 }) == CN_OK);
	/* A capacity of 0 counts. */
	int32_t count = 0;
	CHECK(cn_outline_decompose(shape.points, shape.count, 1.0f, NULL, 0, &count) == CN_OK && count == 1);
}

/* Points of a small lattice, exact or with noise at 1 m or 1 km: most outlines touch themselves or nearly do. Those that pass have the
   area of their pieces, up to slivers. */
static void t_lattice_outlines(void)
{
	int32_t accepted = 0, far_off = 0;
	double worst = 0.0, worst_noisy = 0.0;
	for (int32_t k = 0; k < TEST_SAMPLES(20000); ++k) {
		float noise = k & 1 ? 3.0e-5f * (float)random_below(20) : 0.0f, shift = k & 2 ? 1000.0f : 0.0f;
		shape.count = 3 + random_below(7);
		for (int32_t i = 0; i < shape.count; ++i)
			shape.points[i] = cni_v((float)random_below(5) + random_in(-noise, noise) + shift, (float)random_below(5) + random_in(-noise, noise));
		if (decompose(&shape, &parts) != CN_OK)
			continue;
		++accepted;
		far_off += shift > 0.0f;
		double difference = fabs(fabs(area_of(shape.points, shape.count)) - area_of_pieces(&parts)) / perimeter_of(shape.points, shape.count);
		if (noise > 0.0f)
			worst_noisy = greater(worst_noisy, difference);
		else
			worst = greater(worst, difference);
	}
	CHECK_GE("outlines accepted", accepted, TEST_SAMPLES(1000), "");
	CHECK_GE("of these 1 km away", far_off, TEST_SAMPLES(500), "");
	CHECK_LE("worst difference of areas", worst, 1e-9, "m of the perimeter");
	CHECK_LE("worst difference of areas with noise", 1000.0 * worst_noisy, 1000.0 * THICKNESS, "mm of the perimeter");
}

static void t_orientation_is_exact(void)
{
	int32_t wrong = 0, zero = 0;
	for (int32_t k = 0; k < TEST_SAMPLES(100000); ++k) {
		int64_t ax = random_below(1 << 23), ay = random_below(1 << 23), ux = random_below(1 << 10), uy = random_below(1 << 10);
		int64_t s = random_below(1 << 11), t = random_below(1 << 11);
		int64_t bx = ax + s * ux, by = ay + s * uy, cx = ax + t * ux + random_below(3) - 1, cy = ay + t * uy;
		int64_t exact = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
		int32_t sign = exact > 0 ? 1 : exact < 0 ? -1 : 0;
		zero += sign == 0;
		wrong += cni_orientation(cni_v((float)ax, (float)ay), cni_v((float)bx, (float)by), cni_v((float)cx, (float)cy)) != sign;
	}
	CHECK_GE("collinear triples", zero, TEST_SAMPLES(10000), "");
	CHECK_LE("wrong signs", wrong, 0, "");
}

/* ------------------------------------------------------------------ simplification */

static void t_simplified_within_tolerance(void)
{
	static cn_vec2 out[POINTS_MAX];
	int32_t before = 0, after = 0, foreign = 0;
	double worst = 0.0;
	for (int32_t k = 0; k < 400; ++k) {
		int32_t closed = random_below(2), count, at = 0;
		float tolerance = random_below(4) ? random_in(0.01f, 1.0f) : 0.0f;
		make_random(&shape, k);
		REQUIRE(cn_outline_simplify(shape.points, shape.count, closed, tolerance, out, POINTS_MAX, &count) == CN_OK);
		before += shape.count;
		after += count;
		for (int32_t i = 0; i < count; ++i, ++at)
			while (at < shape.count && !(shape.points[at].x == out[i].x && shape.points[at].y == out[i].y))
				++at;
		foreign += at > shape.count;
		for (int32_t i = 0; i < shape.count && count > 0; ++i)
			worst = greater(worst, distance_to_row(out, count, closed, shape.points[i]) - (double)tolerance);
	}
	printf("       %d points, %d kept\n", (int)before, (int)after);
	CHECK_LE("deviation beyond the tolerance", worst, 1e-6, "m");
	CHECK_LE("rows not in the order of the input", foreign, 0, "");
}

static void t_simplified_known(void)
{
	static cn_vec2 many[65536], out[65536];
	static const cn_vec2 square[8] = { { 0.5f, 0 }, { 1, 0 }, { 1, 0.5f }, { 1, 1 }, { 0.5f, 1 }, { 0, 1 }, { 0, 0.5f }, { 0, 0 } };
	int32_t count;
	REQUIRE(cn_outline_simplify(square, 8, 1, 0.01f, out, 8, &count) == CN_OK);
	CHECK(count == 4 && out[0].x == 1.0f && out[0].y == 0.0f);
	REQUIRE(cn_outline_simplify(square, 8, 1, 9.0f, out, 8, &count) == CN_OK);
	CHECK(count == 0);
	REQUIRE(cn_outline_simplify(square, 8, 0, 9.0f, NULL, 0, &count) == CN_OK);
	CHECK(count == 2);
	for (int32_t i = 0; i < 65536; ++i)
		many[i] = cni_v((float)cos(TWO_PI * i / 65536.0), (float)sin(TWO_PI * i / 65536.0));
	REQUIRE(cn_outline_simplify(many, 65536, 1, 0.01f, many, 65536, &count) == CN_OK); /* in place */
	/* A chord of half angle a deviates by 1 - cos a: 23 at least, and halving gives a power of two. */
	CHECK(count >= 23 && count <= 32);
	CHECK_LE("radius of the points kept", fabs(hypot((double)many[7].x, (double)many[7].y) - 1.0), 1e-6, "m");
}

/* ------------------------------------------------------------------ cells */

#define COLUMNS 12
#define ROWS 9

static uint8_t grid[ROWS][COLUMNS];
static cn_vec2 cell_points[4 * ROWS * COLUMNS];
static int32_t cell_counts[ROWS * COLUMNS + 1], cell_point_count, cell_outline_count;

static void outline_count_add(int32_t count)
{
	cell_counts[cell_outline_count] = count;
	cell_outline_count += count > 0;
	cell_point_count += count;
}

static cn_result cells_trace(float side)
{
	int32_t count = 1;
	cell_point_count = cell_outline_count = 0;
	while (count > 0) {
		cn_result result = cn_outline_from_cells(&grid[0][0], ROWS * COLUMNS, COLUMNS, -3.0f, 2.0f, side, cell_outline_count, cell_points + cell_point_count,
			4 * ROWS * COLUMNS - cell_point_count, &count);
		if (result != CN_OK)
			return result;
		outline_count_add(count);
	}
	return CN_OK;
}

static int32_t grid_random(void)
{
	int32_t solid = 0, share = 1 + random_below(9);
	for (int32_t y = 0; y < ROWS; ++y)
		for (int32_t x = 0; x < COLUMNS; ++x)
			solid += grid[y][x] = (uint8_t)(random_below(10) < share);
	return solid;
}

/* 1 if the cell 1/4 of a side to the left of the middle of a -> b is solid and the one to the right is not. */
static int32_t solid_on_the_left(cn_vec2 a, cn_vec2 b)
{
	int32_t is_left[2], length = (int32_t)(fabs((double)(b.x - a.x)) + fabs((double)(b.y - a.y)) + 0.5);
	for (int32_t k = 0; k < length; ++k) {
		cn_vec2 unit = cni_mul(1.0f / (float)length, cni_sub(b, a)), middle = cni_madd(a, (float)k + 0.5f, unit);
		for (int32_t side = 0; side < 2; ++side) {
			cn_vec2 p = cni_madd(middle, side ? -0.25f : 0.25f, cni_left_perp(unit));
			int32_t x = (int32_t)floor((double)p.x + 3.0), y = (int32_t)floor((double)p.y - 2.0);
			is_left[side] = x >= 0 && y >= 0 && x < COLUMNS && y < ROWS && grid[y][x];
		}
		if (!is_left[0] || is_left[1])
			return 0;
	}
	return 1;
}

static void t_outlines_of_cells(void)
{
	int32_t sides_wrong = 0, corners_wrong = 0, touching = 0, decomposed = 0;
	double worst = 0.0, pieces_worst = 0.0;
	for (int32_t k = 0; k < 500; ++k) {
		int32_t solid = grid_random(), at = 0;
		double sum = 0.0;
		REQUIRE(cells_trace(1.0f) == CN_OK);
		for (int32_t o = 0; o < cell_outline_count; ++o) {
			const cn_vec2 *p = cell_points + at;
			int32_t n = cell_counts[o];
			sum += area_of(p, n);
			for (int32_t i = 0; i < n; ++i) {
				cn_vec2 a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
				sides_wrong += !solid_on_the_left(a, b);
				corners_wrong += !((a.x == b.x) != (a.y == b.y) && (a.x == b.x) == (b.y == c.y));
			}
			if (area_of(p, n) > 0.0) {
				int32_t status = decompose_points(p, n);
				decomposed += status == CN_OK;
				touching += status != CN_OK;
				if (status == CN_OK)
					pieces_worst = greater(pieces_worst, fabs(area_of_pieces(&parts) - area_of(p, n)));
			}
			at += n;
		}
		CHECK(at == cell_point_count);
		worst = greater(worst, fabs(sum - (double)solid));
	}
	printf("       %d outlines in pieces, %d touch themselves at a corner\n", (int)decomposed, (int)touching);
	CHECK_LE("area of the outlines beside that of the solid cells", worst, 0.0, "m^2");
	CHECK_LE("edges without solid on their left or with solid on their right", sides_wrong, 0, "");
	CHECK_LE("points that are no corner", corners_wrong, 0, "");
	CHECK_GE("outlines decomposed", decomposed, 1000, "");
	CHECK_LE("area of their pieces", pieces_worst, 1e-4, "m^2");
}

static void t_ball_rests_on_cells(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < 10; ++k) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body ground = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), balls[COLUMNS];
		cn_shape_def def = fixture_shape_def(ground, 0.5f, 0.0f);
		int32_t at = 0, tops[COLUMNS];
		grid_random();
		REQUIRE(cells_trace(1.0f) == CN_OK);
		for (int32_t o = 0; o < cell_outline_count; at += cell_counts[o], ++o) {
			cn_chain chain = { cell_points + at, cell_counts[o], 1 };
			must(cn_shape_create_chain(world, &def, &chain, NULL), world, "chain");
		}
		for (int32_t x = 0; x < COLUMNS; ++x) {
			tops[x] = ROWS - 1;
			while (tops[x] >= 0 && !grid[tops[x]][x])
				--tops[x];
			balls[x] = fixture_circle(world, CN_BODY_DYNAMIC, (float)x - 2.5f, (float)tops[x] + 4.0f, 0.25f, 0.5f, 0.0f);
		}
		fixture_step(world, 120);
		for (int32_t x = 0; x < COLUMNS; ++x)
			if (tops[x] >= 0)
				worst = greater(worst, fabs((double)fixture_pose(world, balls[x]).position_m.y - (3.0 + tops[x] + 0.25)));
		cn_world_destroy(world);
	}
	CHECK_LE("height of balls at rest on the cells", worst, SAG_M, "m");
}

/* ------------------------------------------------------------------ fields */

static float field[ROWS][COLUMNS];

static cn_result field_trace(float spacing)
{
	int32_t count = 1;
	cell_point_count = cell_outline_count = 0;
	while (count > 0) {
		cn_result result = cn_outline_from_field(&field[0][0], ROWS * COLUMNS, COLUMNS, 0.5f, 0.0f, 0.0f, spacing, cell_outline_count, cell_points + cell_point_count,
			4 * ROWS * COLUMNS - cell_point_count, &count);
		if (result != CN_OK)
			return result;
		outline_count_add(count);
	}
	return CN_OK;
}

/* Samples in or on the wrong side of the outlines: the crossing number of all outlines together. */
static int32_t field_samples_wrong(void)
{
	int32_t wrong = 0;
	for (int32_t y = 1; y < ROWS - 1; ++y)
		for (int32_t x = 1; x < COLUMNS - 1; ++x) {
			int32_t inside = 0;
			for (int32_t o = 0, at = 0; o < cell_outline_count; at += cell_counts[o], ++o)
				inside ^= contains(cell_points + at, cell_counts[o], cni_v((float)x, (float)y));
			wrong += inside != (field[y][x] >= 0.5f);
		}
	return wrong;
}

/* Many samples equal the threshold, where a crossing would lie on the sample. */
static void t_outlines_of_fields(void)
{
	int32_t wrong = 0, refused = 0, outlines = 0;
	double least = 1e30;
	for (int32_t k = 0; k < 500; ++k) {
		for (int32_t y = 0; y < ROWS; ++y)
			for (int32_t x = 0; x < COLUMNS; ++x)
				field[y][x] = random_below(3) ? random_in(0, 1) : 0.5f * (float)random_below(3);
		REQUIRE(field_trace(1.0f) == CN_OK);
		wrong += field_samples_wrong();
		for (int32_t o = 0, at = 0; o < cell_outline_count; at += cell_counts[o], ++o) {
			++outlines;
			refused += decompose_points(cell_points + at, cell_counts[o]) != CN_OK;
			least = fmin(least, (double)cni_least_distance(cell_points + at, cell_counts[o], 1));
		}
	}
	CHECK_GE("outlines", outlines, 1000, "");
	CHECK_LE("samples on the wrong side", wrong, 0, "");
	CHECK_LE("outlines that touch themselves", refused, 0, "");
	CHECK_GE("least distance of consecutive points", least, 1.0 / 64.0 - 1e-6, "of the spacing");
}

static void t_field_of_a_disc(void)
{
	cn_vec2 centre = cni_v(5.3f, 4.1f);
	double worst = 0.0;
	for (int32_t y = 0; y < ROWS; ++y)
		for (int32_t x = 0; x < COLUMNS; ++x)
			field[y][x] = 0.5f + 3.0f - cni_length(cni_sub(cni_v((float)x, (float)y), centre));
	REQUIRE(field_trace(1.0f) == CN_OK);
	REQUIRE(cell_outline_count == 1 && cell_counts[0] == cell_point_count);
	for (int32_t i = 0; i < cell_point_count; ++i)
		worst = greater(worst, fabs((double)cni_length(cni_sub(cell_points[i], centre)) - 3.0));
	CHECK_LE("distance of the points from the circle", worst, 0.05, "of the spacing");
	CHECK_LE("area beside the disc's", fabs(area_of(cell_points, cell_point_count) / (0.5 * TWO_PI * 9.0) - 1.0), 0.05, "share");
	/* All solid: the border. */
	for (int32_t y = 0; y < ROWS; ++y)
		for (int32_t x = 0; x < COLUMNS; ++x)
			field[y][x] = 1e38f;
	REQUIRE(field_trace(0.5f) == CN_OK);
	CHECK(cell_outline_count == 1 && cell_point_count == 2 * (ROWS + COLUMNS) - 4);
	CHECK_LE("area of a solid field", fabs(area_of(cell_points, cell_point_count) - 0.25 * (ROWS - 1) * (COLUMNS - 1)), 0.0, "m^2");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_orientation_is_exact);
	RUN(t_few_pieces);
	RUN(t_pieces_cover_the_outline_once);
	RUN(t_hostile_outlines);
	RUN(t_lattice_outlines);
	RUN(t_simplified_within_tolerance);
	RUN(t_simplified_known);
	RUN(t_outlines_of_cells);
	RUN(t_ball_rests_on_cells);
	RUN(t_outlines_of_fields);
	RUN(t_field_of_a_disc);
	return test_end();
}
