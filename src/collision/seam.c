/*
 * collision/seam.c - finding hidden corners between flush faces, and taking their normals out of manifolds.
 */
#include "collision/seam.h"
#include "collision/distance.h"

/* Sine of the angle up to which two faces are one surface: a tile of 2 m is off by less than the slop then. */
#define FLUSH_SINE_MAX 0.002f
/* Sine up to which a normal is the surface's own: rounding. */
#define OWN_SINE_MAX 1e-5f
/* ... up to which two points are still those of the surface, about a degree: a body that tilts slides on without loss. */
#define FLAT_SINE_MAX 0.02f

typedef struct face {
	cni_vec2 start, normal, along; /* unit; the face reaches from 0 to length along it */
	float length;
} face;

static face face_of(const cni_geometry *g, int32_t index)
{
	const cni_vec2 *p = cni_geometry_points(g);
	face f;
	f.normal = cni_geometry_normals(g)[index];
	f.start = cni_madd(p[index], g->radius, f.normal);
	f.along = cni_left_perp(f.normal);
	f.length = cni_dot(f.along, cni_sub(p[index + 1 < g->count ? index + 1 : 0], p[index]));
	return f;
}

static face face_moved(face f, cni_transform x)
{
	f.start = cni_transform_point(x, f.start);
	f.normal = cni_rotate(x.q, f.normal);
	f.along = cni_rotate(x.q, f.along);
	return f;
}

int32_t cni_seams_possible(const cni_geometry *g, float slop)
{
	return (g->type == CN_SHAPE_POLYGON || g->type == CN_SHAPE_EDGE) && g->radius <= slop;
}

/* Does the other face go on where this one ends? */
static int32_t face_continues(const face *f, const face *other, int32_t end, float slop)
{
	float at = end ? f->length : 0.0f, from, to;
	cni_vec2 corner = cni_madd(f->start, at, f->along);
	if (cni_abs(cni_dot(other->normal, cni_sub(corner, other->start))) > slop)
		return 0;
	from = cni_dot(f->along, cni_sub(other->start, corner));
	to = from + other->length;
	return end ? from <= slop && to > slop : to >= -slop && from < -slop;
}

uint32_t cni_seams_between(const cni_geometry *g, const cni_geometry *h, cni_transform h_in_g, float slop)
{
	uint32_t seams = 0;
	int32_t i, k;
	for (k = 0; k < h->count; ++k) {
		face other = face_moved(face_of(h, k), h_in_g);
		for (i = 0; i < g->count; ++i) {
			face f = face_of(g, i);
			if (!(cni_dot(f.normal, other.normal) > 0.0f && cni_abs(cni_cross(f.normal, other.normal)) <= FLUSH_SINE_MAX))
				continue;
			seams |= (uint32_t)face_continues(&f, &other, 0, slop) << 2 * i | (uint32_t)face_continues(&f, &other, 1, slop) << (2 * i + 1);
		}
	}
	return seams;
}

/* The other shape, seen from the fixed one. */
typedef struct mover {
	cni_proxy_points set;
	cni_vec2 storage[2];
	cni_transform at;
	int32_t inverse;     /* the transform is that of the fixed shape seen from this one */
} mover;

static cni_vec2 mover_point(const mover *o, int32_t k)
{
	return o->inverse ? cni_untransform_point(o->at, o->set.points[k]) : cni_transform_point(o->at, o->set.points[k]);
}

/* What of it is lowest over a face, within the slop: from where to where along the face, and how high. */
typedef struct underside {
	float at[2], height[2];
	float low;           /* of the shape, rounding included */
} underside;

static underside underside_find(const mover *o, const face *f, float slop)
{
	underside u = { { FLT_MAX, -FLT_MAX }, { 0.0f, 0.0f }, FLT_MAX };
	float at[CN_POLYGON_MAX_VERTICES], height[CN_POLYGON_MAX_VERTICES];
	int32_t k;
	for (k = 0; k < o->set.count; ++k) {
		cni_vec2 d = cni_sub(mover_point(o, k), f->start);
		at[k] = cni_dot(f->along, d);
		height[k] = cni_dot(f->normal, d) - o->set.radius;
		u.low = cni_min(u.low, height[k]);
	}
	for (k = 0; k < o->set.count; ++k) {
		if (height[k] > u.low + slop)
			continue;
		if (at[k] < u.at[0]) {
			u.at[0] = at[k];
			u.height[0] = height[k];
		}
		if (at[k] > u.at[1]) {
			u.at[1] = at[k];
			u.height[1] = height[k];
		}
	}
	return u;
}

static float height_at(const underside *u, float at)
{
	float width = u->at[1] - u->at[0];
	return width > 0.0f ? u->height[0] + (at - u->at[0]) / width * (u->height[1] - u->height[0]) : cni_min(u->height[0], u->height[1]);
}

/* One more point of the manifold, at a place along the face. */
static void surface_point(const cni_manifold_input *in, const face *f, float at, float height, uint32_t id, int32_t fixed_is_b, cni_manifold *m)
{
	cni_vec2 p = cni_madd(cni_madd(f->start, at, f->along), 0.5f * height, f->normal);
	cni_manifold_point *to = &m->points[m->count];
	if (height > in->margin)
		return;
	to->point = fixed_is_b ? cni_transform_point(in->b_in_a, p) : p;
	to->separation = height;
	to->id = id;
	++m->count;
}

/* The second point's id differs from all that name features. */
#define SECOND_ID 0x40u

/* What is above the part of the surface that is this face when it comes down to it on its way. */
static void surface_take(const face *f, const underside *u, cni_vec2 way, const cni_manifold_input *in, int32_t fixed_is_b, cni_manifold *m)
{
	float down = -cni_dot(way, f->normal), part = u->low > 0.0f ? (down > u->low ? u->low / down : 1.0f) : 0.0f, shift = part * cni_dot(way, f->along);
	float from = cni_max(u->at[0], -in->slop - shift), to = cni_min(u->at[1], f->length + in->slop - shift);
	uint32_t id = m->points[0].id;
	m->count = 0;
	m->normal = fixed_is_b ? cni_neg(cni_rotate(in->b_in_a.q, f->normal)) : f->normal;
	if (from > to)
		return;
	surface_point(in, f, from, height_at(u, from), id, fixed_is_b, m);
	if (to - from > in->slop)
		surface_point(in, f, to, height_at(u, to), id | SECOND_ID, fixed_is_b, m);
}

/* Two points that are the surface's but for a little tilt: they stay where they are. */
static int32_t is_flat(const face *f, cni_vec2 normal, const cni_manifold *m)
{
	return m->count == 2 && cni_dot(normal, f->normal) > 0.0f && cni_abs(cni_dot(normal, f->along)) <= FLAT_SINE_MAX;
}

void cni_seams_mend(const cni_manifold_input *in, cni_vec2 way, float depth, cni_manifold *m)
{
	int32_t fixed_is_b = cni_seams_of(in->a) == 0, i;
	const cni_geometry *fixed = fixed_is_b ? in->b : in->a, *other = fixed_is_b ? in->a : in->b;
	cni_vec2 normal = fixed_is_b ? cni_unrotate(in->b_in_a.q, cni_neg(m->normal)) : m->normal;
	mover o;
	o.set = cni_geometry_proxy(other, fixed_is_b ? in->child_a : in->child_b, o.storage);
	o.at = in->b_in_a;
	o.inverse = fixed_is_b;
	if (fixed_is_b)
		way = cni_unrotate(in->b_in_a.q, cni_neg(way));
	for (i = 0; i < fixed->count; ++i) {
		uint32_t ends = fixed->seams >> 2 * i & 3u;
		underside u;
		float across;
		face f;
		if (ends == 0)
			continue;
		f = face_of(fixed, i);
		across = cni_dot(normal, f.along);
		if (cni_abs(across) <= OWN_SINE_MAX || !(ends >> (across > 0.0f) & 1u))
			continue;
		u = underside_find(&o, &f, in->slop);
		if (u.low < -depth)
			continue;
		if (is_flat(&f, normal, m))
			m->normal = fixed_is_b ? cni_neg(cni_rotate(in->b_in_a.q, f.normal)) : f.normal;
		else
			surface_take(&f, &u, way, in, fixed_is_b, m);
		return;
	}
}
