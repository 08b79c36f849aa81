/*
 * test/geometry/medium_test.c - buoyancy, drag and lift of shapes against numeric integration in double precision, and the implicit
 * step that cannot reverse the motion relative to the medium.
 *
 * If a test here fails, look in geometry/medium.c.
 */
#include "geometry/medium.h"
#include "geometry/shapes.h"
#include "test.h"

#define PI 3.14159265358979
#define SAMPLES 20000

typedef struct scene {
	record r;
	cni_in_medium in;
	cni_medium medium;
	cni_medium_region region;
} scene;

static const cni_medium_region everywhere;

static void scene_random(scene *s, int32_t type, float spin)
{
	memset(&s->medium, 0, sizeof s->medium);
	record_random(&s->r, type, 1.0f);
	s->in.geometry = &s->r.g;
	s->in.center = random_vec(0.5f);
	s->in.q = transform_make(0.0f, 0.0f, random_in(-3.0f, 3.0f)).q;
	s->in.velocity = random_vec(3.0f);
	s->in.spin = spin;
	s->medium.up = cni_v(0.0f, 1.0f);
	s->medium.buoyancy = 0.0f;
	s->medium.drag = random_in(0.5f, 2.0f);
	s->medium.lift = random_in(0.5f, 2.0f);
	s->medium.flow = random_vec(3.0f);
	s->region = everywhere;
}

static cni_medium_force force_of(const scene *s)
{
	cni_medium_force f;
	memset(&f, 0, sizeof f);
	cni_medium_add(&f, &s->medium, &s->region, &s->in);
	return f;
}

/* ---- references ---- */

/* The point is (x, y) with the normal (nx, ny); its material moves as (cx, cy). */
static void element_sum(const scene *s, double x, double y, double cx, double cy, double nx, double ny, double length, double sum[3])
{
	double ux = (double)s->medium.flow.x - ((double)s->in.velocity.x - (double)s->in.spin * cy);
	double uy = (double)s->medium.flow.y - ((double)s->in.velocity.y + (double)s->in.spin * cx);
	double across = -(nx * ux + ny * uy), speed = hypot(ux, uy), fx, fy, lift;
	if (across <= 0.0)
		return;
	lift = 0.5 * (double)s->medium.lift * across * -(nx * -uy + ny * ux) / speed * length;
	fx = 0.5 * (double)s->medium.drag * across * ux * length - lift * uy;
	fy = 0.5 * (double)s->medium.drag * across * uy * length + lift * ux;
	sum[0] += fx;
	sum[1] += fy;
	sum[2] += x * fy - y * fx;
}

static void edge_sum(const scene *s, cni_vec2 a, cni_vec2 b, cni_vec2 n, double sum[3])
{
	double length = hypot((double)b.x - (double)a.x, (double)b.y - (double)a.y);
	for (int32_t k = 0; k < SAMPLES; ++k) {
		double t = (k + 0.5) / SAMPLES, x = (double)a.x + t * ((double)b.x - (double)a.x), y = (double)a.y + t * ((double)b.y - (double)a.y);
		element_sum(s, x, y, x, y, (double)n.x, (double)n.y, length / SAMPLES, sum);
	}
}

static void arc_sum(const scene *s, cni_vec2 p, double radius, double from, double to, double sum[3])
{
	for (int32_t k = 0; k < SAMPLES; ++k) {
		double angle = from + (to - from) * (k + 0.5) / SAMPLES, nx = cos(angle), ny = sin(angle);
		element_sum(s, (double)p.x + radius * nx, (double)p.y + radius * ny, (double)p.x, (double)p.y, nx, ny, radius * (to - from) / SAMPLES, sum);
	}
}

static void outline_sum(const scene *s, double sum[3])
{
	const cni_geometry *g = &s->r.g;
	const cni_vec2 *p = cni_geometry_points(g), *n = cni_geometry_normals(g);
	sum[0] = sum[1] = sum[2] = 0.0;
	if (g->count == 1) {
		arc_sum(s, cni_rotate(s->in.q, cni_sub(p[0], s->in.center)), (double)g->radius, 0.0, 2.0 * PI, sum);
		return;
	}
	for (int32_t k = 0; k < g->count; ++k) {
		int32_t next = (k + 1) % g->count;
		cni_vec2 a = cni_rotate(s->in.q, cni_sub(p[k], s->in.center)), b = cni_rotate(s->in.q, cni_sub(p[next], s->in.center));
		cni_vec2 n1 = cni_rotate(s->in.q, n[k]), n2 = cni_rotate(s->in.q, n[next]);
		double from = atan2((double)n1.y, (double)n1.x), turn = atan2((double)n2.y, (double)n2.x) - from;
		edge_sum(s, cni_madd(a, g->radius, n1), cni_madd(b, g->radius, n1), n1, sum);
		if (g->radius > 0.0f)
			arc_sum(s, b, (double)g->radius, from, from + (turn < 0.0 ? turn + 2.0 * PI : turn), sum);
	}
}

static double force_error(const cni_medium_force *f, const double sum[3])
{
	double size = fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]), error = 0.0;
	for (int32_t k = 0; k < 3; ++k)
		error = greater(error, fabs((double)f->drag[k] - sum[k]) / (size + 1e-3));
	return error;
}

/* ---- drag and lift ---- */

static void t_wind_is_exact(void)
{
	double still = 0.0, turning = 0.0, sum[3];
	for (int32_t k = 0; k < TEST_MANY(60); ++k) {
		scene s;
		cni_medium_force f;
		int32_t type = k % 3;
		scene_random(&s, type, 0.0f);
		f = force_of(&s);
		outline_sum(&s, sum);
		still = greater(still, force_error(&f, sum));
		scene_random(&s, type, random_in(-5.0f, 5.0f));
		if (s.r.g.radius > 0.0f && s.r.g.count > 1)
			continue;
		s.medium.lift = 0.0f;
		f = force_of(&s);
		outline_sum(&s, sum);
		turning = greater(turning, force_error(&f, sum));
	}
	CHECK_LE("drag and lift without spin against the integral", still, 2e-5, "relative");
	CHECK_LE("drag with spin, of circles and corners without radius", turning, 2e-5, "relative");
}

static void t_plates_have_two_sides(void)
{
	scene s;
	cni_medium_force f, back;
	scene_random(&s, CN_SHAPE_EDGE, 0.0f);
	f = force_of(&s);
	s.in.velocity = cni_sub(cni_mul(2.0f, s.medium.flow), s.in.velocity);
	back = force_of(&s);
	CHECK(hypot((double)f.drag[0], (double)f.drag[1]) > 0.01);
	CHECK_LE("force of the opposite flow plus force", hypot((double)(f.drag[0] + back.drag[0]), (double)(f.drag[1] + back.drag[1])), 1e-5, "N");
}

/* Where all of it moves as one with the flow, F = resist (W - V) with W the flow. */
static void t_resistance_gives_the_force(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < 200; ++k) {
		scene s;
		cni_medium_force f;
		double w[3];
		scene_random(&s, k % 4, random_in(-5.0f, 5.0f));
		f = force_of(&s);
		w[0] = (double)s.medium.flow.x - (double)s.in.velocity.x;
		w[1] = (double)s.medium.flow.y - (double)s.in.velocity.y;
		w[2] = -(double)s.in.spin;
		for (int32_t i = 0; i < 3; ++i) {
			double sum = 0.0;
			for (int32_t j = 0; j < 3; ++j)
				sum += (double)f.resist[i][j] * w[j];
			worst = greater(worst, fabs(sum - (double)f.drag[i]));
		}
	}
	CHECK_LE("resist (W - V) - force", worst, 1e-4, "N");
}

/* ---- the implicit step ---- */

static double kinetic(const float mass[3], const double v[3])
{
	return (double)mass[0] * v[0] * v[0] + (double)mass[1] * v[1] * v[1] + (double)mass[2] * v[2] * v[2];
}

static void t_wind_never_reverses(void)
{
	double most = 0.0, least = 1.0;
	for (int32_t k = 0; k < TEST_SAMPLES(3000); ++k) {
		scene s;
		cni_medium_force f;
		float mass[3], change[3];
		double before[3], after[3], product = 0.0;
		scene_random(&s, k % 5 == 4 ? CN_SHAPE_EDGE : k % 4, random_in(-50.0f, 50.0f));
		s.in.velocity = cni_mul(random_in(0.0f, 100.0f), s.in.velocity);
		s.medium.drag *= powf(10.0f, random_in(-3.0f, 6.0f));
		s.medium.lift *= powf(10.0f, random_in(-3.0f, 6.0f));
		mass[0] = mass[1] = powf(10.0f, random_in(-4.0f, 4.0f));
		mass[2] = mass[0] * random_in(0.01f, 0.5f);
		f = force_of(&s);
		cni_medium_solve(&f, mass, powf(10.0f, random_in(-4.0f, 0.0f)), change);
		before[0] = (double)s.in.velocity.x - (double)s.medium.flow.x;
		before[1] = (double)s.in.velocity.y - (double)s.medium.flow.y;
		before[2] = (double)s.in.spin;
		for (int32_t i = 0; i < 3; ++i) {
			after[i] = before[i] + (double)change[i];
			product += (double)mass[i] * before[i] * after[i];
		}
		most = greater(most, kinetic(mass, after) / kinetic(mass, before));
		least = fmin(least, product / kinetic(mass, before));
	}
	CHECK_LE("energy relative to the wind, after over before", most, 1.0 + 1e-5, "");
	CHECK_GE("the old velocity in the new one", least, -1e-5, "");
}

/* ---- parts of shapes ---- */

static void water(scene *s, float level)
{
	s->medium.buoyancy = 1.0f;
	s->medium.drag = s->medium.lift = 0.0f;
	s->region.count = 1;
	s->region.normals[0] = cni_v(0.0f, 1.0f);
	s->region.offsets[0] = level;
}

static void t_box_in_water(void)
{
	scene s;
	cni_medium_force f;
	scene_random(&s, CN_SHAPE_CIRCLE, 0.0f);
	record_box(&s.r, 1.5f, 0.5f, 0.0f, transform_none());
	s.in.center = cni_v(0.25f, 0.0f);
	s.in.q = transform_none().q;
	water(&s, -0.2f);
	f = force_of(&s);
	CHECK_LE("buoyancy of 3 m x 0.3 m", fabs((double)f.force[1] - 0.9), 1e-6, "N");
	CHECK_LE("its torque about a centre 0.25 m beside", fabs((double)f.force[2] + 0.25 * 0.9), 1e-6, "N m");
	CHECK_LE("stiffness: width of the waterline", fabs((double)f.heave - 3.0), 1e-6, "N/m");
	CHECK_LE("... integral of x^2", fabs((double)f.roll - (27.0 / 12.0 + 3.0 * 0.0625)), 1e-5, "N m");
	water(&s, 0.6f);
	CHECK_LE("wholly in it", fabs((double)force_of(&s).force[1] - 3.0), 1e-6, "N");
	water(&s, -0.5f);
	CHECK_LE("wholly out of it", fabs((double)force_of(&s).force[1]), 0.0, "N");
}

static void t_disc_in_water(void)
{
	double worst = 0.0, torque = 0.0;
	scene s;
	scene_random(&s, CN_SHAPE_CIRCLE, 0.0f);
	record_circle(&s.r, 1.0f);
	s.in.center = cni_v(0.0f, 0.0f);
	for (int32_t k = -99; k <= 99; ++k) {
		double level = 0.01 * k, exact = acos(-level) + level * sqrt(1.0 - level * level);
		cni_medium_force f;
		water(&s, (float)level);
		f = force_of(&s);
		worst = greater(worst, fabs((double)f.force[1] - exact) / PI);
		torque = greater(torque, fabs((double)f.force[2]));
	}
	CHECK_LE("area of a segment of a disc, of the disc", worst, 0.005, "");
	CHECK_LE("torque of still water on a disc", torque, 1e-5, "N m");
}

/* Any shape in any convex region, by columns and rows. */
static void grid_sum(const scene *s, double sum[3])
{
	const int32_t side = 600;
	const double reach = 2.5, step = 2.0 * reach / side;
	sum[0] = sum[1] = sum[2] = 0.0;
	for (int32_t i = 0; i < side * side; ++i) {
		double x = -reach + (i % side + 0.5) * step, y = -reach + (i / side + 0.5) * step;
		cni_vec2 r = cni_v((float)x, (float)y);
		int32_t k = 0;
		while (k < s->region.count && cni_dot(s->region.normals[k], r) <= s->region.offsets[k])
			++k;
		if (k < s->region.count || !cni_geometry_contains(&s->r.g, cni_add(cni_unrotate(s->in.q, r), s->in.center)))
			continue;
		sum[1] += step * step;
		sum[2] += step * step * x;
	}
}

static void t_parts_in_regions(void)
{
	double worst = 0.0;
	int32_t wet = 0;
	for (int32_t k = 0; k < TEST_MANY(24); ++k) {
		scene s;
		record area;
		cni_medium_force f;
		double sum[3];
		scene_random(&s, k % 3, 0.0f);
		s.medium.drag = s.medium.lift = 0.0f;
		s.medium.buoyancy = 1.0f;
		record_random(&area, CN_SHAPE_POLYGON, 1.0f);
		cni_medium_region_make(&s.region, &area.g, cni_add(area.g.centroid, random_vec(0.3f)), s.in.q);
		f = force_of(&s);
		grid_sum(&s, sum);
		wet += sum[1] > 0.05;
		worst = greater(worst, fabs((double)f.force[1] - sum[1]) + fabs((double)f.force[2] - sum[2]));
	}
	CHECK_GE("regions that overlap", wet, TEST_FORM(12, 6, 1), "");
	CHECK_LE("area and first moment against a grid", worst, 0.02, "m^2");
}

/* ---- regions ---- */

static void t_tangent_of_a_planet(void)
{
	record planet;
	cni_medium_region region;
	record_circle(&planet, 10.0f);
	cni_medium_region_make(&region, &planet.g, cni_v(0.0f, -12.0f), transform_none().q);
	CHECK(region.count == 1 && region.normals[0].y == -1.0f);
	CHECK_LE("surface 2 m above a point below the planet", fabs((double)region.offsets[0] + 2.0), 1e-5, "m");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_wind_is_exact);
	RUN(t_plates_have_two_sides);
	RUN(t_resistance_gives_the_force);
	RUN(t_wind_never_reverses);
	RUN(t_box_in_water);
	RUN(t_disc_in_water);
	RUN(t_parts_in_regions);
	RUN(t_tangent_of_a_planet);
	return test_end();
}
