/*
 * collision/seam.c - seams, flush joints of faces of two shapes that are static or on one kinematic body: the faces form one surface, the
 * corners between them are hidden, and sliding shapes must not catch on them.
 *
 * A polygon or an edge stores which ends of its faces are hidden (cni_geometry.seams). narrowphase/static_seams.c finds
 * them when such shapes are made, moved or destroyed. A manifold whose normal belongs to a hidden corner, or to the side
 * face below it, is replaced by a manifold of the surface (as internal edge removal in Jolt and Bullet; for chains see
 * manifold_chain.c). A face that one neighbour covers leads nowhere: a shape deep inside leaves through another face.
 */
#include "collision/manifold.h"

/* Sine of the angle up to which two faces are one surface: a tile of 2 m is off by less than the slop then. */
#define FLUSH_SINE_MAX 0.002f
/* Sine up to which a normal is the surface's own: rounding. */
#define OWN_SINE_MAX 1e-5f
/* ... up to which two points are still those of the surface, about a degree: a body that tilts slides on without loss. */
#define FLAT_SINE_MAX 0.02f
/* Bits COVERED_FROM + face, of shapes with at most COVERED_FACES faces: one neighbour continues both faces beside this one, and so covers it. */
#define COVERED_FROM 20
#define COVERED_FACES 10
/* Cosine between a normal and that of a covered face from which it leads into the neighbour: less than 60 degrees. */
#define COVERED_COSINE 0.5f

typedef struct face {
	cni_vec2 start, normal, along; /* along: unit; the face spans 0 to length along it */
	float length;
} face;

static face face_of(const cni_geometry *g, int32_t index)
{
	const cni_vec2 *p = cni_geometry_points(g);
	cni_vec2 normal = cni_geometry_normals(g)[index], along = cni_left_perp(normal);
	float length = cni_dot(along, cni_sub(p[index + 1 < g->count ? index + 1 : 0], p[index]));
	face f = { cni_madd(p[index], g->radius, normal), normal, along, length };
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

/* 1 when the other face continues f at this end. */
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

/* Adds the faces that are covered because both of their ends are hidden. */
static uint32_t covered_add(uint32_t seams, int32_t count)
{
	for (int32_t i = 0; i < count && count <= COVERED_FACES; ++i) {
		int32_t before = i > 0 ? i - 1 : count - 1, after = i + 1 < count ? i + 1 : 0;
		seams |= (seams >> (2 * before + 1) & seams >> 2 * after & 1u) << (COVERED_FROM + i);
	}
	return seams;
}

uint32_t cni_seams_between(const cni_geometry *g, const cni_geometry *h, cni_transform h_in_g, float slop)
{
	uint32_t seams = 0;
	for (int32_t k = 0; k < h->count; ++k) {
		face other = face_moved(face_of(h, k), h_in_g);
		for (int32_t i = 0; i < g->count; ++i) {
			face f = face_of(g, i);
			if (!(cni_dot(f.normal, other.normal) > 0.0f && cni_abs(cni_cross(f.normal, other.normal)) <= FLUSH_SINE_MAX))
				continue;
			seams |= (uint32_t)face_continues(&f, &other, 0, slop) << 2 * i | (uint32_t)face_continues(&f, &other, 1, slop) << (2 * i + 1);
		}
	}
	return g->count > 2 ? covered_add(seams, g->count) : seams;
}

/* The moving shape, in the frame of the static one. */
typedef struct mover {
	cni_proxy_points set;
	cni_vec2 storage[2];
	cni_transform at;
	int32_t inverse;     /* 1: `at` maps the static shape's frame into this one's */
} mover;

static cni_vec2 mover_point(const mover *o, int32_t k)
{
	return o->inverse ? cni_untransform_point(o->at, o->set.points[k]) : cni_transform_point(o->at, o->set.points[k]);
}

/* The points of the moving shape that are lowest over a face, up to the slop: the first and the last along the face. */
typedef struct underside {
	float at[2], height[2];
	float low;           /* lowest height of the shape, radius included */
} underside;

static underside underside_find(const mover *o, const face *f, float slop)
{
	underside u = { { FLT_MAX, -FLT_MAX }, { 0.0f, 0.0f }, FLT_MAX };
	float at[CN_POLYGON_MAX_VERTICES], height[CN_POLYGON_MAX_VERTICES];
	for (int32_t k = 0; k < o->set.count; ++k) {
		cni_vec2 d = cni_sub(mover_point(o, k), f->start);
		at[k] = cni_dot(f->along, d);
		height[k] = cni_dot(f->normal, d) - o->set.radius;
		u.low = cni_min(u.low, height[k]);
	}
	for (int32_t k = 0; k < o->set.count; ++k) {
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

/* Appends a point at position `at` along the face to the manifold, if it is within the margin. */
static void surface_point(const cni_manifold_input *in, const face *f, float at, float height, uint32_t id, int32_t static_is_b, cni_manifold *m)
{
	cni_vec2 p = cni_madd(cni_madd(f->start, at, f->along), 0.5f * height, f->normal);
	cni_manifold_point *to = &m->points[m->count];
	if (height > in->margin)
		return;
	to->point = static_is_b ? cni_transform_point(in->b_in_a, p) : p;
	to->separation = height;
	to->id = id;
	++m->count;
}

/* The second point's id differs from all that name features. */
#define SECOND_ID 0x40u

/* Writes the manifold of the face and the part of the underside that is above it when the shape reaches its plane. */
static void surface_take(const face *f, const underside *u, cni_vec2 motion, const cni_manifold_input *in, int32_t static_is_b, cni_manifold *m)
{
	float down = -cni_dot(motion, f->normal), part = u->low > 0.0f ? (down > u->low ? u->low / down : 1.0f) : 0.0f;
	float shift = part * cni_dot(motion, f->along);
	float from = cni_max(u->at[0], -in->slop - shift), to = cni_min(u->at[1], f->length + in->slop - shift);
	uint32_t id = m->points[0].id;
	m->count = 0;
	m->normal = static_is_b ? cni_neg(cni_rotate(in->b_in_a.q, f->normal)) : f->normal;
	if (from > to)
		return;
	surface_point(in, f, from, height_at(u, from), id, static_is_b, m);
	if (to - from > in->slop)
		surface_point(in, f, to, height_at(u, to), id | SECOND_ID, static_is_b, m);
}

/* 1 when the manifold has two points and its normal is the surface's up to a small tilt: its points are kept. */
static int32_t is_flat(const face *f, cni_vec2 normal, const cni_manifold *m)
{
	return m->count == 2 && cni_dot(normal, f->normal) > 0.0f && cni_abs(cni_dot(normal, f->along)) <= FLAT_SINE_MAX;
}

/* Does the normal lead out through a covered face, and is it no other face's own? */
static int32_t leads_into_neighbour(const cni_geometry *owner, cni_vec2 normal)
{
	const cni_vec2 *normals = cni_geometry_normals(owner);
	int32_t leads = 0;
	for (int32_t i = 0; i < owner->count; ++i) {
		if (owner->seams >> (COVERED_FROM + i) & 1u)
			leads |= cni_dot(normal, normals[i]) > COVERED_COSINE;
		else if (cni_dot(normal, normals[i]) > 0.0f && cni_abs(cni_cross(normal, normals[i])) <= OWN_SINE_MAX)
			return 0;
	}
	return leads;
}

/* What is deep in the shape leaves it through the nearest face that is not covered, on its own side of the middle: neighbours push it out
   of a shape that is enclosed there. center: the moving shape's, in the frame of the static one. */
static void leave_uncovered(const mover *o, cni_vec2 center, const cni_geometry *owner, cni_vec2 motion, const cni_manifold_input *in, int32_t static_is_b, cni_manifold *m)
{
	underside best = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, -FLT_MAX };
	int32_t nearest = CNI_NONE;
	face f;
	for (int32_t i = 0; i < owner->count; ++i) {
		f = face_of(owner, i);
		if ((owner->seams >> (COVERED_FROM + i) & 1u) || cni_dot(f.normal, cni_sub(center, owner->centroid)) < 0.0f)
			continue;
		underside u = underside_find(o, &f, in->slop);
		if (u.low <= best.low)
			continue;
		best = u;
		nearest = i;
	}
	if (nearest == CNI_NONE)
		return;
	f = face_of(owner, nearest);
	if (best.at[0] <= f.length && best.at[1] >= 0.0f) /* else the neighbour has its lowest points */
		surface_take(&f, &best, motion, in, static_is_b, m);
}

void cni_seams_mend(const cni_manifold_input *in, cni_vec2 motion, float depth, cni_manifold *m)
{
	int32_t static_is_b = cni_seams_of(in->a) == 0;
	const cni_geometry *owner = static_is_b ? in->b : in->a, *other = static_is_b ? in->a : in->b;
	cni_vec2 normal = static_is_b ? cni_unrotate(in->b_in_a.q, cni_neg(m->normal)) : m->normal;
	mover o;
	o.set = cni_geometry_proxy(other, static_is_b ? in->child_a : in->child_b, o.storage);
	o.at = in->b_in_a;
	o.inverse = static_is_b;
	if (static_is_b)
		motion = cni_unrotate(in->b_in_a.q, cni_neg(motion));
	for (int32_t i = 0; i < owner->count; ++i) {
		uint32_t ends = owner->seams >> 2 * i & 3u;
		if (ends == 0)
			continue;
		face f = face_of(owner, i);
		float across = cni_dot(normal, f.along);
		if (cni_abs(across) <= OWN_SINE_MAX || !(ends >> (across > 0.0f) & 1u))
			continue;
		underside u = underside_find(&o, &f, in->slop);
		if (u.low < -depth)
			continue;
		if (is_flat(&f, normal, m))
			m->normal = static_is_b ? cni_neg(cni_rotate(in->b_in_a.q, f.normal)) : f.normal;
		else
			surface_take(&f, &u, motion, in, static_is_b, m);
		return;
	}
	if (owner->count > 2 && owner->count <= COVERED_FACES && leads_into_neighbour(owner, normal))
		leave_uncovered(&o, static_is_b ? cni_untransform_point(o.at, other->centroid) : cni_transform_point(o.at, other->centroid), owner, motion, in, static_is_b, m);
}
