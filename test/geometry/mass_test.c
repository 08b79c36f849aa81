/*
 * mass_test.c - masses, centres and inertias against closed forms and numeric integration.
 */
#include "geometry/shapes.h"
#include "test.h"

#define PI 3.14159265358979

static void mass_compare(const char *what, cn_mass_data m, double mass, double inertia, double x, double y, double bound)
{
	double error = fmax(fabs((double)m.mass_kg / mass - 1.0), fabs((double)m.inertia_kgm2 / inertia - 1.0));
	double size = sqrt(inertia / mass);
	error = greater(error, hypot((double)m.center_m.x - x, (double)m.center_m.y - y) / size);
	CHECK_LE(what, error, bound, "relative");
}

static void t_circle(void)
{
	record r;
	cn_circle c = { { 3, -2 }, 0.5f };
	cni_geometry_circle(&r.g, &c, transform_make(1, 1, 0));
	double mass = 2.0 * PI * 0.25;
	mass_compare("circle", cni_geometry_mass(&r.g, 2.0f), mass, mass * 0.125, 4, -1, 1e-6);
}

static void t_box(void)
{
	record r;
	record_box(&r, 1.5f, 0.5f, 0.0f, transform_make(10.0f, 20.0f, 0.7f));
	mass_compare("box", cni_geometry_mass(&r.g, 4.0f), 12.0, 12.0 * (9.0 + 1.0) / 12.0, 10, 20, 1e-5);
	record_box(&r, 25.0f, 0.01f, 0.0f, transform_none());
	mass_compare("plank", cni_geometry_mass(&r.g, 1.0f), 1.0, (2500.0 + 0.0004) / 12.0, 0, 0, 1e-5);
}

static void t_triangle(void)
{
	record r;
	cn_polygon p = { 3, 0, { { 0, 0 }, { 3, 0 }, { 0, 4 } } };
	cni_geometry_polygon(&r.g, &p, transform_none());
	/* A right triangle about its centroid: m (b^2 + h^2) / 18. */
	mass_compare("triangle", cni_geometry_mass(&r.g, 1.0f), 6.0, 6.0 * 25.0 / 18.0, 1.0, 4.0 / 3.0, 1e-6);
}

static void t_regular_polygons(void)
{
	for (int32_t n = 3; n <= 16; ++n) {
		record r;
		cn_polygon p = { n, 0, { { 0, 0 } } };
		for (int32_t i = 0; i < n; ++i)
			p.points_m[i] = cni_v((float)(2.0 * cos(2.0 * PI * i / n)), (float)(2.0 * sin(2.0 * PI * i / n)));
		cni_geometry_polygon(&r.g, &p, transform_make(-7.0f, 5.0f, 0.3f));
		double area = 0.5 * n * 4.0 * sin(2.0 * PI / n);
		double inertia = area * 4.0 / 6.0 * (2.0 + cos(2.0 * PI / n));
		mass_compare("regular polygon", cni_geometry_mass(&r.g, 1.0f), area, inertia, -7, 5, 5e-6);
	}
}

static void t_capsule(void)
{
	record r;
	cn_capsule c = { { -1, 0 }, { 1, 0 }, 0.5f };
	cni_geometry_capsule(&r.g, &c, transform_make(2.0f, 3.0f, 1.0f));
	double box = 2.0, disc = PI * 0.25, arm = 4.0 * 0.5 / (3.0 * PI);
	/* Half disc about its own centroid: m r^2 / 2 - m arm^2 with m of the half. */
	double inertia = box * (4.0 + 1.0) / 12.0 + disc * (0.125 - arm * arm + (1.0 + arm) * (1.0 + arm));
	mass_compare("capsule", cni_geometry_mass(&r.g, 1.0f), box + disc, inertia, 2, 3, 1e-6);
}

/* Midpoint sums over a fine grid of what contains says is inside. */
static void integrate(const cni_geometry *g, double *mass, double *inertia, double *x, double *y)
{
	cni_aabb box = cni_geometry_aabb(g, 0, transform_none());
	int32_t n = 700;
	double dx = ((double)box.x1 - (double)box.x0) / n, dy = ((double)box.y1 - (double)box.y0) / n, s = 0, sx = 0, sy = 0, ss = 0;
	for (int32_t i = 0; i < n; ++i)
		for (int32_t j = 0; j < n; ++j) {
			double px = (double)box.x0 + (i + 0.5) * dx, py = (double)box.y0 + (j + 0.5) * dy;
			if (!cni_geometry_contains(g, cni_v((float)px, (float)py)))
				continue;
			s += 1.0;
			sx += px;
			sy += py;
			ss += px * px + py * py;
		}
	*x = sx / s;
	*y = sy / s;
	*mass = s * dx * dy;
	*inertia = (ss / s - *x * *x - *y * *y) * *mass;
}

static void t_rounded_polygon_by_integration(void)
{
	for (int32_t k = 0; k < 8; ++k) {
		record r;
		cn_polygon p = random_polygon(1.0f);
		p.radius_m = 0.1f + 0.1f * (float)k;
		cni_geometry_polygon(&r.g, &p, transform_make(0.5f, -0.5f, 1.0f));
		double mass, inertia, x, y;
		integrate(&r.g, &mass, &inertia, &x, &y);
		mass_compare("rounded polygon", cni_geometry_mass(&r.g, 1.0f), mass, inertia, x, y, 2e-3);
	}
}

static void t_rounded_box_is_exact(void)
{
	record r;
	double a = 1.0, b = 0.5, q = 0.25, arm = 4.0 * q / (3.0 * PI);
	record_box(&r, 1.0f, 0.5f, 0.25f, transform_none());
	double sides = 2 * (2 * a) * q, ends = 2 * (2 * b) * q, disc = PI * q * q;
	double mass = 4 * a * b + sides + ends + disc;
	double inertia = 4 * a * b * (4 * a * a + 4 * b * b) / 12.0;
	inertia += sides * ((4 * a * a + q * q) / 12.0 + (b + q / 2) * (b + q / 2));
	inertia += ends * ((4 * b * b + q * q) / 12.0 + (a + q / 2) * (a + q / 2));
	/* Quarter discs: polar q^2 / 2 about their corner, centroid arm away along both axes. */
	inertia += disc * (q * q / 2 + a * a + b * b + 2 * arm * (a + b));
	mass_compare("rounded box", cni_geometry_mass(&r.g, 1.0f), mass, inertia, 0, 0, 1e-6);
}

static void t_massless(void)
{
	record r;
	cn_edge e = { { 0, 0 }, { 1, 0 } };
	cni_geometry_edge(&r.g, &e, transform_none());
	CHECK(cni_geometry_mass(&r.g, 1.0f).mass_kg == 0.0f && cni_geometry_mass(&r.g, 1.0f).inertia_kgm2 == 0.0f);
	record_box(&r, 1.0f, 1.0f, 0.0f, transform_none());
	cn_mass_data m = cni_geometry_mass(&r.g, 0.0f);
	CHECK(m.mass_kg == 0.0f && m.inertia_kgm2 == 0.0f && m.center_m.x == 0.0f);
}

static void t_sizes(void)
{
	for (int32_t k = -2; k <= 5; ++k) {
		record r;
		float h = (float)pow(10.0, (double)k);
		record_box(&r, h, h, 0.0f, transform_none());
		double s = (double)h;
		mass_compare("box of any size", cni_geometry_mass(&r.g, 1.0f), 4 * s * s, 4 * s * s * 8 * s * s / 12.0, 0, 0, 1e-6);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_circle);
	RUN(t_box);
	RUN(t_triangle);
	RUN(t_regular_polygons);
	RUN(t_capsule);
	RUN(t_rounded_polygon_by_integration);
	RUN(t_rounded_box_is_exact);
	RUN(t_massless);
	RUN(t_sizes);
	return test_end();
}
