/*
 * geometry/mass.c - mass, centre and inertia in closed form.
 *
 * A shape is the sum of pieces with known area, first moment and polar second moment about one reference point. A rounded
 * polygon consists of the polygon, one rectangle length x radius on every edge, and one circular sector at every vertex,
 * from the normal before it to the normal after it:
 *
 *   sector of angle w at v:  area r^2 w / 2,  integral of rho dA = r^3 / 3 * right_perp(n2 - n1),
 *                            integral of |rho|^2 dA = r^4 w / 4      (rho measured from v)
 *
 * The reference point is the mean of the points, so that shapes far from the origin do not lose digits.
 */
#include "geometry/shape.h"

typedef struct moments {
	float area;
	cni_vec2 first;  /* integral of position */
	float second;    /* integral of |position|^2 */
} moments;

/* Triangle (origin, a, b), signed. */
static void triangle_add(moments *sum, cni_vec2 a, cni_vec2 b)
{
	float cross = cni_cross(a, b);
	sum->area += 0.5f * cross;
	sum->first = cni_madd(sum->first, cross / 6.0f, cni_add(a, b));
	sum->second += cross * (cni_dot(a, a) + cni_dot(a, b) + cni_dot(b, b)) / 12.0f;
}

/* Rectangle of the given length and width whose side a -> b touches the polygon. */
static void border_add(moments *sum, cni_vec2 a, cni_vec2 b, cni_vec2 normal, float width)
{
	float length = cni_length(cni_sub(b, a));
	float area = length * width;
	cni_vec2 center = cni_madd(cni_lerp(a, b, 0.5f), 0.5f * width, normal);
	sum->area += area;
	sum->first = cni_madd(sum->first, area, center);
	sum->second += area * (length * length + width * width) / 12.0f + area * cni_length_sq(center);
}

static void sector_add(moments *sum, cni_vec2 v, cni_vec2 n1, cni_vec2 n2, float radius)
{
	float angle = cni_atan2(cni_cross(n1, n2), cni_dot(n1, n2));
	float r2 = radius * radius;
	float area = 0.5f * r2 * angle;
	cni_vec2 first = cni_mul(r2 * radius / 3.0f, cni_right_perp(cni_sub(n2, n1)));
	sum->area += area;
	sum->first = cni_add(sum->first, cni_madd(first, area, v));
	sum->second += 0.25f * r2 * r2 * angle + 2.0f * cni_dot(v, first) + area * cni_length_sq(v);
}

static cni_vec2 points_mean(const cni_geometry *g)
{
	const cni_vec2 *p = cni_geometry_points(g);
	cni_vec2 sum = cni_v(0.0f, 0.0f);
	for (int32_t i = 0; i < g->count; ++i)
		sum = cni_add(sum, cni_sub(p[i], p[0]));
	return cni_madd(p[0], 1.0f / (float)g->count, sum);
}

static cn_mass_data moments_mass(const moments *m, cni_vec2 reference, float density)
{
	cni_vec2 center = cni_mul(1.0f / m->area, m->first);
	float second = cni_max(m->second - m->area * cni_length_sq(center), 0.0f);
	cn_mass_data mass = { density * m->area, density * second, cni_add(reference, center) };
	return mass;
}

static cn_mass_data polygon_mass(const cni_geometry *g, float density)
{
	const cni_vec2 *p = cni_geometry_points(g);
	const cni_vec2 *normals = cni_geometry_normals(g);
	cni_vec2 reference = points_mean(g);
	moments sum = { 0.0f, { 0.0f, 0.0f }, 0.0f };
	for (int32_t i = 0; i < g->count; ++i) {
		int32_t next = i + 1 < g->count ? i + 1 : 0;
		cni_vec2 a = cni_sub(p[i], reference);
		cni_vec2 b = cni_sub(p[next], reference);
		triangle_add(&sum, a, b);
		if (g->radius > 0.0f) {
			border_add(&sum, a, b, normals[i], g->radius);
			sector_add(&sum, b, normals[i], normals[next], g->radius);
		}
	}
	return moments_mass(&sum, reference, density);
}

static cn_mass_data circle_mass(const cni_geometry *g, float density)
{
	float r2 = g->radius * g->radius, mass_kg = density * CNI_PI * r2;
	cn_mass_data mass = { mass_kg, 0.5f * mass_kg * r2, cni_geometry_points(g)[0] };
	return mass;
}

/* A rectangle length x 2 r and two half discs, whose centroids are 4 r / (3 pi) beyond its ends. */
static cn_mass_data capsule_mass(const cni_geometry *g, float density)
{
	const cni_vec2 *p = cni_geometry_points(g);
	float r = g->radius, length = cni_length(cni_sub(p[1], p[0])), arm = 4.0f * r / (3.0f * CNI_PI);
	float box_kg = density * 2.0f * r * length, disc_kg = density * CNI_PI * r * r;
	float inertia = box_kg * (length * length + 4.0f * r * r) / 12.0f
		+ disc_kg * (0.5f * r * r + 0.25f * length * length + length * arm);
	cn_mass_data mass = { box_kg + disc_kg, inertia, cni_lerp(p[0], p[1], 0.5f) };
	return mass;
}

cn_mass_data cni_geometry_mass(const cni_geometry *g, float density)
{
	cn_mass_data none = { 0.0f, 0.0f, { 0.0f, 0.0f } };
	switch (g->type) {
	case CN_SHAPE_CIRCLE:
		return circle_mass(g, density);
	case CN_SHAPE_CAPSULE:
		return capsule_mass(g, density);
	case CN_SHAPE_POLYGON:
		return polygon_mass(g, density);
	default:
		none.center_m = g->centroid;
		return none;
	}
}
