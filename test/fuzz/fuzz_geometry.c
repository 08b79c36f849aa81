/*
 * test/fuzz/fuzz_geometry.c - shapes and casts against slow references: a hull against its points, mass against integration, rays and
 * moved shapes against points along the way.
 */
#include "fuzz.h"

#include <math.h>

#define SAMPLES 64
#define MARGIN 2e-3 /* metres: rounding, and the touching distance of a tenth of the slop */
#define SLOP 0.005
#define HULL_MARGIN 0.015 /* half a percent of the size, which is at most 2.9 m */

/* Distance of a point outside of a polygon without radius, negative inside: the largest height over an edge. */
static double height_over(const cn_polygon *p, double x, double y)
{
	double most = -1e30;
	int32_t k;
	for (k = 0; k < p->count; ++k) {
		cn_vec2 a = p->points_m[k], b = p->points_m[(k + 1) % p->count];
		double ex = (double)b.x - (double)a.x, ey = (double)b.y - (double)a.y, length = sqrt(ex * ex + ey * ey);
		double height = ((x - (double)a.x) * ey - (y - (double)a.y) * ex) / length;
		most = height > most ? height : most;
	}
	return most;
}

static int32_t any_hull(fuzz_source *s, cn_polygon *out)
{
	cn_vec2 points[24];
	int32_t count = 3 + (int32_t)(fuzz_byte(s) % 22u), k;
	for (k = 0; k < count; ++k) {
		points[k].x = 2.0f * fuzz_unit(s);
		points[k].y = 2.0f * fuzz_unit(s);
	}
	if (cn_polygon_make_hull(points, count, 0.0f, out) != CN_OK)
		return 0;
	FUZZ_REQUIRE(out->count >= 3 && out->count <= CN_POLYGON_MAX_VERTICES);
	for (k = 0; k < count && out->count < CN_POLYGON_MAX_VERTICES; ++k) /* a full one leaves points out */
		FUZZ_REQUIRE(height_over(out, (double)points[k].x, (double)points[k].y) < HULL_MARGIN);
	return 1;
}

static cn_shape add_polygon(cn_world *world, const cn_polygon *polygon, float x, float y)
{
	cn_body_def def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_shape shape = 0;
	cn_body_def_init(&def);
	def.position_m.x = x;
	def.position_m.y = y;
	cn_shape_def_init(&shape_def);
	FUZZ_REQUIRE(cn_body_create(world, &def, &body) == CN_OK);
	shape_def.body = body;
	return cn_shape_create_polygon(world, &shape_def, polygon, &shape) == CN_OK ? shape : 0;
}

/* Midpoints of a grid over the polygon: the error is at most the cells that its border crosses. */
static void check_mass(const cn_world *world, cn_shape shape, const cn_polygon *p)
{
	cn_mass_data mass;
	double area = 0.0, cell = 4.4 / SAMPLES, around = 0.0;
	int32_t row, column, k;
	FUZZ_REQUIRE(cn_shape_get_mass_data(world, shape, &mass) == CN_OK);
	for (row = 0; row < SAMPLES; ++row)
		for (column = 0; column < SAMPLES; ++column)
			area += height_over(p, -2.2 + cell * (column + 0.5), -2.2 + cell * (row + 0.5)) < 0.0 ? cell * cell : 0.0;
	for (k = 0; k < p->count; ++k) {
		cn_vec2 a = p->points_m[k], b = p->points_m[(k + 1) % p->count];
		around += hypot((double)b.x - (double)a.x, (double)b.y - (double)a.y);
	}
	FUZZ_REQUIRE(fabs((double)mass.mass_kg - area) <= 1.5 * cell * around + 4.0 * cell * cell);
	FUZZ_REQUIRE(mass.inertia_kgm2 > 0.0f && height_over(p, (double)mass.center_m.x, (double)mass.center_m.y) < MARGIN);
}

/* The first of many points along the ray that is inside. */
static void check_ray(const cn_world *world, const cn_polygon *p, float px, float py, fuzz_source *s)
{
	cn_ray ray;
	cn_ray_hit hit;
	double first = 2.0, deepest = 1e30, length;
	int32_t k;
	ray.origin_m.x = 5.0f * fuzz_unit(s);
	ray.origin_m.y = 5.0f * fuzz_unit(s);
	ray.translation_m.x = 10.0f * fuzz_unit(s);
	ray.translation_m.y = 10.0f * fuzz_unit(s);
	length = hypot((double)ray.translation_m.x, (double)ray.translation_m.y);
	if (length < 0.1 || cn_world_cast_ray(world, &ray, NULL, &hit) != CN_OK)
		return;
	for (k = 0; k <= 1000; ++k) {
		double t = (double)k / 1000.0, x = (double)ray.origin_m.x + t * (double)ray.translation_m.x - (double)px, y = (double)ray.origin_m.y + t * (double)ray.translation_m.y - (double)py;
		double height = height_over(p, x, y);
		deepest = height < deepest ? height : deepest;
		if (height < -MARGIN && first > 1.0)
			first = t;
	}
	if (hit.shape == 0) { /* a ray that starts inside by less than the slop and leaves is no hit */
		double start = height_over(p, (double)(ray.origin_m.x - px), (double)(ray.origin_m.y - py));
		FUZZ_REQUIRE(first > 1.0 || (start < MARGIN && deepest > -SLOP - MARGIN));
		return;
	}
	{ /* what is hit is on the border, and no sample before it is inside */
		double x = (double)hit.point_m.x - (double)px, y = (double)hit.point_m.y - (double)py;
		FUZZ_REQUIRE(hit.fraction == 0.0f || fabs(height_over(p, x, y)) < MARGIN);
		FUZZ_REQUIRE(first > 1.0 || (double)hit.fraction <= first + MARGIN);
		FUZZ_REQUIRE(deepest < MARGIN + 0.001 * length);
	}
}

/* Separation of two polygons along the normals of both: at most their distance, negative when they overlap. */
static double separation(const cn_polygon *a, const cn_polygon *b)
{
	double most = -1e30;
	int32_t side, k, n;
	for (side = 0; side < 2; ++side) {
		const cn_polygon *p = side ? b : a, *q = side ? a : b;
		for (k = 0; k < p->count; ++k) {
			cn_vec2 from = p->points_m[k], to = p->points_m[(k + 1) % p->count];
			double ex = (double)to.x - (double)from.x, ey = (double)to.y - (double)from.y, length = sqrt(ex * ex + ey * ey), least = 1e30;
			for (n = 0; n < q->count; ++n)
				least = fmin(least, (((double)q->points_m[n].x - (double)from.x) * ey - ((double)q->points_m[n].y - (double)from.y) * ex) / length);
			most = fmax(most, least);
		}
	}
	return most;
}

static cn_polygon moved_by(const cn_polygon *p, float x, float y)
{
	cn_polygon out = *p;
	int32_t k;
	for (k = 0; k < out.count; ++k) {
		out.points_m[k].x += x;
		out.points_m[k].y += y;
	}
	return out;
}

/* Before it hits, a moved box does not overlap; where it hits, nothing is between them. */
static void check_moved(const cn_world *world, const cn_polygon *p, float px, float py, fuzz_source *s)
{
	cn_polygon box, there = moved_by(p, px, py), here;
	cn_ray_hit hit;
	int32_t k;
	float tx = 10.0f * fuzz_unit(s), ty = 10.0f * fuzz_unit(s), x = 6.0f * fuzz_unit(s), y = 6.0f * fuzz_unit(s), end;
	if (cn_polygon_make_box(0.3f, 0.2f, x, y, fuzz_unit(s), 0.0f, &box) != CN_OK || cn_world_cast_shape(world, &box, tx, ty, NULL, &hit) != CN_OK)
		return;
	if (hit.shape != 0 && hit.fraction == 0.0f) {
		FUZZ_REQUIRE(separation(&box, &there) < MARGIN);
		return;
	}
	end = hit.shape != 0 ? hit.fraction : 1.0f;
	for (k = 0; k < 200; ++k) {
		here = moved_by(&box, end * (float)k / 200.0f * tx, end * (float)k / 200.0f * ty);
		FUZZ_REQUIRE(separation(&here, &there) > -2.0 * MARGIN - SLOP); /* it may start in contact, up to the slop, and leave */
	}
	here = moved_by(&box, end * tx, end * ty);
	FUZZ_REQUIRE(hit.shape == 0 || separation(&here, &there) < SLOP + MARGIN);
}

void fuzz_geometry(const uint8_t *bytes, size_t count)
{
	fuzz_source s = fuzz_begin(bytes, count);
	cn_polygon polygon;
	cn_world_def def;
	cn_world *world = NULL;
	cn_shape shape;
	float x, y;
	int32_t k;
	if (!any_hull(&s, &polygon))
		return;
	cn_world_def_init(&def);
	FUZZ_REQUIRE(cn_world_create(&def, &world) == CN_OK);
	x = fuzz_unit(&s);
	y = fuzz_unit(&s);
	shape = add_polygon(world, &polygon, x, y);
	if (shape != 0) {
		check_mass(world, shape, &polygon);
		for (k = 0; k < 4; ++k)
			check_ray(world, &polygon, x, y, &s);
		check_moved(world, &polygon, x, y, &s);
	}
	cn_world_destroy(world);
}
