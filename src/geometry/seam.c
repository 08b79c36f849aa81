/*
 * geometry/seam.c - finding hidden corners between flush faces, and taking their normals out of manifolds.
 */
#include "geometry/seam.h"
#include "geometry/distance.h"

/* Sine of the angle up to which two faces are one surface: a tile of 2 m is off by less than the slop then. */
#define FLUSH_SINE_MAX 0.002f
/* Sine up to which a normal is the surface's own: it takes less than a thousandth of the load along the surface. */
#define OWN_SINE_MAX 0.001f
/* ... up to which two points are still those of the surface, about a degree. */
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

/* The height of its lowest point over a face; where it is. */
static float mover_lowest(const mover *o, const face *f, cni_vec2 *where)
{
	float low = FLT_MAX;
	int32_t k;
	for (k = 0; k < o->set.count; ++k) {
		cni_vec2 p = mover_point(o, k);
		float height = cni_dot(f->normal, cni_sub(p, f->start));
		if (height < low) {
			low = height;
			*where = p;
		}
	}
	return low - o->set.radius;
}

/* The manifold in the frame of the fixed shape, the normal out of it. */
static void surface_take(const cni_geometry *fixed, const face *f, float low, cni_vec2 where, cni_vec2 normal, const cni_manifold_input *in, cni_manifold *m)
{
	float slop = in->slop, at = cni_dot(f->along, cni_sub(where, f->start)), radius = fixed == in->a ? in->b->radius : in->a->radius;
	cni_vec2 n = f->normal, p = cni_madd(where, -(radius + 0.5f * low), n);
	int32_t flat = m->count == 2 && cni_dot(normal, n) > 0.0f && cni_abs(cni_dot(normal, f->along)) <= FLAT_SINE_MAX;
	if (!flat && !(at >= -slop && at <= f->length + slop && low <= in->margin)) {
		m->count = 0;
		return;
	}
	if (fixed == in->a) {
		m->normal = n;
	} else {
		m->normal = cni_neg(cni_rotate(in->b_in_a.q, n));
		p = cni_transform_point(in->b_in_a, p);
	}
	if (flat)
		return;
	m->count = 1;
	m->points[0].point = p;
	m->points[0].separation = low;
}

void cni_seams_mend(const cni_manifold_input *in, float depth, cni_manifold *m)
{
	const cni_geometry *fixed = cni_seams_of(in->a) != 0 ? in->a : in->b, *other = fixed == in->a ? in->b : in->a;
	cni_vec2 normal = fixed == in->a ? m->normal : cni_unrotate(in->b_in_a.q, cni_neg(m->normal)), where = { 0.0f, 0.0f };
	mover o;
	int32_t i;
	o.set = cni_geometry_proxy(other, fixed == in->a ? in->child_b : in->child_a, o.storage);
	o.at = in->b_in_a;
	o.inverse = fixed == in->b;
	for (i = 0; i < fixed->count; ++i) {
		uint32_t ends = fixed->seams >> 2 * i & 3u;
		face f;
		float across, low;
		if (ends == 0)
			continue;
		f = face_of(fixed, i);
		across = cni_dot(normal, f.along);
		if (cni_abs(across) <= OWN_SINE_MAX || !(ends >> (across > 0.0f) & 1u))
			continue;
		low = mover_lowest(&o, &f, &where);
		if (low < -depth)
			continue;
		surface_take(fixed, &f, low, where, normal, in, m);
		return;
	}
}
