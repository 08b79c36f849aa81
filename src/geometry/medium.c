/*
 * geometry/medium.c - buoyancy, drag and lift of a shape in a medium (see medium.h).
 *
 * Drag and lift are those of an outline whose elements ds do not shade each other. With the velocity u of the medium relative to an element
 * of outward normal n that faces it (n . u < 0), and t = u / |u| turned by +90 degrees:
 *
 *   drag = drag / 2 (-n . u) u ds                 coefficient on the width across the flow: Newton's law of resistance (1687)
 *   lift = lift / 2 (-n . u) (-n . t) |u| t ds    flat plate: sin a cos a (Hoerner, "Fluid-Dynamic Lift", 1985, chapter 4)
 *
 * Both are (k + g R) u with k = drag / 2 (-n . u) >= 0, g = lift / 2 (-n . u) (-n . t) and R a turn by +90 degrees. With k and g frozen at
 * the present velocity the force is linear in u: the drag part takes energy, the lift part does no work.
 *
 * On a straight edge u is linear along the edge, and drag is a polynomial of degree 3 in its torque: two Gauss points on the facing part
 * are exact. Drag of a round corner in a flow of one velocity is even across the flow and acts in the middle of its width, and
 * integral (-n . u) (-n . t) over an arc is elementary: exact but for what u changes along the corner of a turning body.
 *
 * The part within a region: Sutherland and Hodgman's clipping (1974) of the outline, with round corners as those of a regular polygon of
 * 16 sides and the same area.
 */
#include "geometry/medium.h"

#define ARC_SIDES 16
#define OUTLINE_MOST (2 * CN_POLYGON_MAX_VERTICES + ARC_SIDES + CNI_MEDIUM_PLANES)
#define RESIST_MOST 1e4f /* times the mass, in a step: floats can solve it, and it stops all but a part of 1e-4 of the velocity */
#define OWN (-1) /* an edge of the shape itself; others: a plane of the region */

typedef struct outline {
	cni_vec2 points[OUTLINE_MOST];
	int32_t edges[OUTLINE_MOST]; /* from point k to the next */
	int32_t count;
} outline;

/* ---- region ---- */

void cni_medium_region_make(cni_medium_region *region, const cni_geometry *g, cni_vec2 center, cni_rot q)
{
	const cni_vec2 *p = cni_geometry_points(g), *n = cni_geometry_normals(g);
	if (g->type == CN_SHAPE_POLYGON) {
		region->count = g->count;
		for (int32_t k = 0; k < g->count; ++k) {
			region->normals[k] = cni_rotate(q, n[k]);
			region->offsets[k] = cni_dot(n[k], cni_sub(p[k], center)) + g->radius;
		}
		return;
	}
	cni_vec2 axis = g->count == 2 ? cni_sub(p[1], p[0]) : cni_v(0.0f, 0.0f);
	cni_vec2 to = cni_madd(cni_sub(center, p[0]), -cni_segment_fraction(center, p[0], axis), axis);
	cni_vec2 way = cni_normalize(to);
	region->count = 1;
	region->normals[0] = cni_rotate(q, way.x == 0.0f && way.y == 0.0f ? cni_v(0.0f, 1.0f) : way);
	region->offsets[0] = g->radius - cni_length(to);
}

/* ---- drag and lift ---- */

/* Velocity of the medium relative to the body's material at r. */
static cni_vec2 relative_flow(const cni_medium *m, const cni_in_medium *s, cni_vec2 r)
{
	return cni_sub(m->flow, cni_madd(s->velocity, s->spin, cni_left_perp(r)));
}

/* Adds the force (k + g R) u at r. */
static void element_add(cni_medium_force *sum, cni_vec2 r, cni_vec2 u, float k, float g)
{
	cni_vec2 force = cni_v(k * u.x - g * u.y, g * u.x + k * u.y), turn = cni_left_perp(r);
	sum->drag[0] += force.x;
	sum->drag[1] += force.y;
	sum->drag[2] += cni_cross(r, force);
	sum->resist[0][0] += k;
	sum->resist[0][1] -= g;
	sum->resist[0][2] += k * turn.x - g * turn.y;
	sum->resist[1][0] += g;
	sum->resist[1][1] += k;
	sum->resist[1][2] += g * turn.x + k * turn.y;
	sum->resist[2][0] += turn.x * k + turn.y * g;
	sum->resist[2][1] += turn.y * k - turn.x * g;
	sum->resist[2][2] += k * cni_dot(turn, turn);
}

/* The part of the edge a -> b between fractions from and to, on which n . u does not change its sign; n faces the flow. */
static void edge_part_add(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s, cni_vec2 a, cni_vec2 b, cni_vec2 n, float from, float to)
{
	static const float gauss[2] = { 0.211324865f, 0.788675135f };
	float weight = 0.25f * (to - from) * cni_length(cni_sub(b, a)); /* half of the length, and the half of drag and lift */
	for (int32_t k = 0; k < 2; ++k) {
		cni_vec2 r = cni_lerp(a, b, from + gauss[k] * (to - from)), u = relative_flow(m, s, r);
		float speed = cni_length(u), across = -cni_dot(n, u);
		if (across > 0.0f)
			element_add(sum, r, u, m->drag * weight * across, -m->lift * weight * across * cni_dot(n, cni_left_perp(u)) / speed);
	}
}

static void edge_add(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s, cni_vec2 a, cni_vec2 b, cni_vec2 n)
{
	float at_a = -cni_dot(n, relative_flow(m, s, a)), at_b = -cni_dot(n, relative_flow(m, s, b));
	if (at_a <= 0.0f && at_b <= 0.0f)
		return;
	edge_part_add(sum, m, s, a, b, n, at_a < 0.0f ? at_a / (at_a - at_b) : 0.0f, at_b < 0.0f ? at_a / (at_a - at_b) : 1.0f);
}

/* Is the direction d on the arc of at most half a turn from n1 counter-clockwise to n2? */
static int32_t arc_has(cni_vec2 n1, cni_vec2 n2, cni_vec2 d)
{
	return cni_cross(n1, d) >= 0.0f && cni_cross(d, n2) >= 0.0f;
}

/* The corner at p, whose flow is u, that faces the flow from y1 to y2 times its radius, along t: y falls counter-clockwise. */
static void arc_part_add(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s, cni_vec2 p, cni_vec2 u, float y1, float y2)
{
	float speed = cni_length(u), radius = s->geometry->radius, half = 0.5f * radius * (y1 - y2) * speed, middle = 0.5f * (y1 + y2);
	if (half <= 0.0f)
		return;
	cni_vec2 r = cni_madd(p, radius * middle / speed, cni_left_perp(u));
	element_add(sum, r, relative_flow(m, s, r), m->drag * half, -m->lift * half * middle);
}

static void arc_add(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s, cni_vec2 p, cni_vec2 n1, cni_vec2 n2)
{
	cni_vec2 u = relative_flow(m, s, p), t = cni_left_perp(cni_normalize(u));
	int32_t first = cni_dot(n1, u) < 0.0f, last = cni_dot(n2, u) < 0.0f;
	if ((first || arc_has(n1, n2, t)) && (last || arc_has(n1, n2, cni_neg(t))))
		arc_part_add(sum, m, s, p, u, first ? cni_dot(n1, t) : 1.0f, last ? cni_dot(n2, t) : -1.0f);
}

static cni_vec2 point_of(const cni_in_medium *s, cni_vec2 local)
{
	return cni_rotate(s->q, cni_sub(local, s->center));
}

/* Edges and chains are thin plates: both sides. */
static void plates_drag(cni_medium_force *sum, const cni_medium *m, const cni_medium_region *region, const cni_in_medium *s)
{
	for (int32_t child = 0; child < cni_geometry_children(s->geometry); ++child) {
		cni_vec2 storage[2], a, b, n;
		float from = 0.0f, to = 1.0f;
		cni_proxy_points ends = cni_geometry_proxy(s->geometry, child, storage);
		a = point_of(s, ends.points[0]);
		b = point_of(s, ends.points[1]);
		for (int32_t k = 0; k < region->count; ++k) {
			float at_a = cni_dot(region->normals[k], a) - region->offsets[k], at_b = cni_dot(region->normals[k], b) - region->offsets[k];
			if (at_a > 0.0f)
				from = at_b >= 0.0f ? 1.0f : cni_max(from, at_a / (at_a - at_b));
			else if (at_b > 0.0f)
				to = cni_min(to, at_a / (at_a - at_b));
		}
		if (from >= to)
			continue;
		n = cni_normalize(cni_right_perp(cni_sub(b, a)));
		storage[0] = cni_lerp(a, b, from);
		storage[1] = cni_lerp(a, b, to);
		edge_add(sum, m, s, storage[0], storage[1], n);
		edge_add(sum, m, s, storage[0], storage[1], cni_neg(n));
	}
}

static void whole_drag(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s)
{
	const cni_geometry *g = s->geometry;
	const cni_vec2 *p = cni_geometry_points(g), *normals = cni_geometry_normals(g);
	if (g->count == 1) {
		cni_vec2 center = point_of(s, p[0]);
		arc_part_add(sum, m, s, center, relative_flow(m, s, center), 1.0f, -1.0f);
		return;
	}
	for (int32_t k = 0; k < g->count; ++k) {
		int32_t next = k + 1 < g->count ? k + 1 : 0;
		cni_vec2 n = cni_rotate(s->q, normals[k]), out = cni_mul(g->radius, n);
		edge_add(sum, m, s, cni_add(point_of(s, p[k]), out), cni_add(point_of(s, p[next]), out), n);
		if (g->radius > 0.0f)
			arc_add(sum, m, s, point_of(s, p[next]), n, cni_rotate(s->q, normals[next]));
	}
}

/* ---- the part within the region ---- */

static void outline_push(outline *o, cni_vec2 point, int32_t edge)
{
	if (o->count == OUTLINE_MOST)
		return; /* rounding on nearly collinear points: no corner of note */
	o->points[o->count] = point;
	o->edges[o->count++] = edge;
}

/* Directions of the regular polygon's corners strictly between n1 and n2 (a circle: all), from the first one counter-clockwise. They
   turn with up, so that still water does not turn a circle. */
static void corner_push(outline *o, cni_vec2 p, float radius, cni_vec2 up, cni_vec2 n1, cni_vec2 n2, int32_t all)
{
	const float reach = 1.01300909f; /* sqrt(2 pi / (16 sin(2 pi / 16))): the area of the circle */
	const cni_rot turn = { 0.923879533f, 0.382683432f };
	cni_vec2 d = up, before = cni_unrotate(turn, up);
	int32_t k;
	for (k = 0; k < ARC_SIDES && !all && !(cni_cross(n1, d) > 0.0f && cni_cross(n1, before) <= 0.0f); ++k) {
		before = d;
		d = cni_rotate(turn, d);
	}
	if (k == ARC_SIDES)
		return;
	for (k = 0; k < ARC_SIDES && (all || (cni_cross(n1, d) > 0.0f && cni_cross(d, n2) > 0.0f)); ++k) {
		outline_push(o, cni_madd(p, radius * reach, d), OWN);
		d = cni_rotate(turn, d);
	}
}

static void outline_make(outline *o, const cni_in_medium *s, cni_vec2 up)
{
	const cni_geometry *g = s->geometry;
	const cni_vec2 *p = cni_geometry_points(g), *normals = cni_geometry_normals(g);
	o->count = 0;
	if (g->count == 1) {
		corner_push(o, point_of(s, p[0]), g->radius, up, up, up, 1);
		return;
	}
	for (int32_t k = 0; k < g->count; ++k) {
		cni_vec2 at = point_of(s, p[k]), before = cni_rotate(s->q, normals[k > 0 ? k - 1 : g->count - 1]), n = cni_rotate(s->q, normals[k]);
		if (g->radius > 0.0f) {
			outline_push(o, cni_madd(at, g->radius, before), OWN);
			corner_push(o, at, g->radius, up, before, n, 0);
		}
		outline_push(o, cni_madd(at, g->radius, n), OWN);
	}
}

static void outline_clip(outline *o, cni_vec2 normal, float offset, int32_t plane)
{
	outline in = *o;
	o->count = 0;
	for (int32_t k = 0; k < in.count; ++k) {
		cni_vec2 a = in.points[k], b = in.points[k + 1 < in.count ? k + 1 : 0];
		float at_a = cni_dot(normal, a) - offset, at_b = cni_dot(normal, b) - offset;
		if (at_a <= 0.0f)
			outline_push(o, a, in.edges[k]);
		if ((at_a <= 0.0f) != (at_b <= 0.0f))
			outline_push(o, cni_lerp(a, b, at_a / (at_a - at_b)), at_a <= 0.0f ? plane : in.edges[k]);
	}
}

/* The surface of the medium: rising by dy uncovers L dy, so buoyancy falls; the same for turning. */
static void surface_stiffness(cni_medium_force *sum, const cni_medium *m, cni_vec2 normal, cni_vec2 a, cni_vec2 b)
{
	float rise = m->buoyancy * cni_length(cni_sub(b, a)) * cni_dot(normal, m->up), xa = cni_cross(a, m->up), xb = cni_cross(b, m->up);
	if (rise <= 0.0f)
		return;
	sum->heave += rise;
	sum->heave_flow += rise * cni_dot(m->flow, m->up);
	sum->roll += rise * (xa * xa + xa * xb + xb * xb) / 3.0f;
}

static void displacement_add(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s, float area, cni_vec2 center)
{
	float force = m->buoyancy * area;
	sum->force[0] += force * m->up.x;
	sum->force[1] += force * m->up.y;
	sum->force[2] += force * cni_cross(center, m->up);
	sum->roll += cni_max(force * cni_dot(center, m->up), 0.0f);
	element_add(sum, center, relative_flow(m, s, center), m->damping * area, 0.0f);
	sum->drag[2] -= m->turn_damping * area * s->spin;
	sum->resist[2][2] += m->turn_damping * area;
}

static void part_displacement(cni_medium_force *sum, const cni_medium *m, const cni_medium_region *region, const cni_in_medium *s, const outline *o)
{
	cni_vec2 first = { 0.0f, 0.0f }, from = o->points[0];
	float area = 0.0f;
	for (int32_t k = 0; k < o->count; ++k) {
		cni_vec2 p = o->points[k], next = o->points[k + 1 < o->count ? k + 1 : 0], a = cni_sub(p, from), b = cni_sub(next, from);
		float twice = cni_cross(a, b);
		area += 0.5f * twice;
		first = cni_madd(first, twice / 6.0f, cni_add(a, b));
		if (o->edges[k] != OWN)
			surface_stiffness(sum, m, region->normals[o->edges[k]], p, next);
	}
	if (area > 0.0f)
		displacement_add(sum, m, s, area, cni_madd(from, 1.0f / area, first));
}

static void part_add(cni_medium_force *sum, const cni_medium *m, const cni_medium_region *region, const cni_in_medium *s)
{
	outline o;
	outline_make(&o, s, m->up);
	for (int32_t k = 0; k < region->count && o.count > 0; ++k)
		outline_clip(&o, region->normals[k], region->offsets[k], k);
	if (o.count < 3)
		return;
	part_displacement(sum, m, region, s, &o);
	for (int32_t k = 0; k < o.count; ++k) {
		cni_vec2 a = o.points[k], b = o.points[k + 1 < o.count ? k + 1 : 0];
		if (o.edges[k] == OWN)
			edge_add(sum, m, s, a, b, cni_normalize(cni_right_perp(cni_sub(b, a))));
	}
}

static void whole_displacement(cni_medium_force *sum, const cni_medium *m, const cni_in_medium *s)
{
	if (m->buoyancy == 0.0f && m->damping == 0.0f && m->turn_damping == 0.0f)
		return;
	cn_mass_data whole = cni_geometry_mass(s->geometry, 1.0f);
	displacement_add(sum, m, s, whole.mass_kg, point_of(s, whole.center_m));
}

static int32_t is_within(const cni_medium_region *region, const cni_in_medium *s)
{
	const cni_vec2 *p = cni_geometry_points(s->geometry);
	for (int32_t i = 0; i < s->geometry->count && region->count > 0; ++i) {
		cni_vec2 r = point_of(s, p[i]);
		for (int32_t k = 0; k < region->count; ++k)
			if (cni_dot(region->normals[k], r) + s->geometry->radius > region->offsets[k])
				return 0;
	}
	return 1;
}

void cni_medium_add(cni_medium_force *sum, const cni_medium *medium, const cni_medium_region *region, const cni_in_medium *shape)
{
	int32_t type = shape->geometry->type;
	if (type == CN_SHAPE_EDGE || type == CN_SHAPE_CHAIN) {
		plates_drag(sum, medium, region, shape);
	} else if (is_within(region, shape)) {
		whole_displacement(sum, medium, shape);
		whole_drag(sum, medium, shape);
	} else {
		part_add(sum, medium, region, shape);
	}
}

/* ---- the implicit step ---- */

/* The norm of the resistance in units of mass, or more. */
static float resist_norm(const cni_medium_force *sum, const float inverse_root[3])
{
	float most = 0.0f;
	for (int32_t i = 0; i < 3; ++i) {
		float row = 0.0f;
		for (int32_t j = 0; j < 3; ++j)
			row += cni_abs(sum->resist[i][j]) * inverse_root[i] * inverse_root[j];
		most = cni_max(most, row);
	}
	return most;
}

/* Gauss with partial pivoting: lift far beyond the mass would cost the digits of a symmetric elimination. The last column is the right side,
   then the solution. */
static void solve_3(float m[3][4])
{
	for (int32_t i = 0; i < 3; ++i) {
		int32_t pivot = i;
		for (int32_t k = i + 1; k < 3; ++k)
			if (cni_abs(m[k][i]) > cni_abs(m[pivot][i]))
				pivot = k;
		for (int32_t j = i; j < 4; ++j) {
			float swap = m[i][j];
			m[i][j] = m[pivot][j];
			m[pivot][j] = swap;
		}
		for (int32_t k = i + 1; k < 3; ++k) {
			float times = m[k][i] / m[i][i];
			for (int32_t j = i; j < 4; ++j)
				m[k][j] -= times * m[i][j];
		}
	}
	for (int32_t i = 2; i >= 0; --i) {
		for (int32_t j = i + 1; j < 3; ++j)
			m[i][3] -= m[i][j] * m[j][3];
		m[i][3] /= m[i][i];
	}
}

/* In units of the roots of the masses, in which the matrix is the identity and the resistance. */
void cni_medium_solve(const cni_medium_force *sum, const float mass[3], float dt, float change[3])
{
	float m[3][4], inverse_root[3], part;
	for (int32_t i = 0; i < 3; ++i)
		inverse_root[i] = mass[i] > 0.0f ? 1.0f / cni_sqrt(mass[i]) : 0.0f;
	part = dt * cni_min(1.0f, RESIST_MOST / cni_max(dt * resist_norm(sum, inverse_root), 1.0f));
	for (int32_t i = 0; i < 3; ++i) {
		for (int32_t j = 0; j < 3; ++j)
			m[i][j] = part * sum->resist[i][j] * inverse_root[i] * inverse_root[j];
		m[i][i] += 1.0f;
		m[i][3] = (dt * sum->force[i] + part * sum->drag[i]) * inverse_root[i];
	}
	solve_3(m);
	for (int32_t i = 0; i < 3; ++i)
		change[i] = m[i][3] * inverse_root[i];
}
