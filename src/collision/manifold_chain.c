/*
 * collision/manifold_chain.c - manifolds of circles, capsules and polygons (shape a) with one edge of a chain (shape b).
 *
 * An edge is one-sided: a shape whose centroid is behind it does not collide. Its neighbours decide
 * which normals may act (after Catto, "Ghost Collisions", 2020):
 *
 *   open end        no neighbour: all directions around the end, except from behind
 *   flat, concave   only the edge's own normal: the neighbour's surface covers the corner
 *   convex          directions between the two edges' normals
 *
 * For shapes with faces the separating axes are those of the local surface, not of the edge alone: the far points of convex
 * neighbours (ghosts) are support points and the neighbours' normals are axes. When a ghost or a neighbour gives the best
 * axis, the contact belongs to the neighbour and this edge makes no manifold. At flat and concave corners the shape's own
 * faces only prove separation and never become the normal, so an inner corner cannot push along the surface.
 */
#include "collision/manifold_faces.h"

/* Sine of the turn up to which a corner counts as flat: about half a degree. */
#define FLAT_SINE_MAX 0.01f
/* By how much (cosine) both edges of a convex corner claim a circle in the middle between them. */
#define SHARED_COSINE 1.0e-4f

static int32_t corner_kind(cni_vec2 before, cni_vec2 after)
{
	float turn = cni_cross(before, after);
	float limit = FLAT_SINE_MAX * FLAT_SINE_MAX * cni_length_sq(before) * cni_length_sq(after);
	if (turn > 0.0f && turn * turn > limit)
		return CNI_CORNER_CONVEX;
	/* A hairpin turns by half a circle: its tip is convex. */
	return turn >= 0.0f && cni_dot(before, after) < 0.0f ? CNI_CORNER_CONVEX : CNI_CORNER_FLAT;
}

static int32_t chain_neighbour(const cni_geometry *g, int32_t index)
{
	if (index >= 0 && index < g->count)
		return index;
	if (!g->seams)
		return CNI_NONE;
	return index < 0 ? index + g->count : index - g->count;
}

static cni_vec2 normal_moved(const cni_manifold_input *in, cni_vec2 along)
{
	return cni_rotate(in->b_in_a.q, cni_normalize(cni_right_perp(along)));
}

/* The edge without its neighbours, which is enough to reject most shapes (behind the edge or too far in front). Directions
   come from the chain's own points, which keep more digits than the transformed ones. */
static void chain_surface(cni_chain_edge *e, const cni_manifold_input *in)
{
	const cni_vec2 *p = cni_geometry_points(in->b);
	cni_vec2 start = p[in->child_b], end = p[chain_neighbour(in->b, in->child_b + 1)];
	e->normal = normal_moved(in, cni_sub(end, start));
	e->points[0] = cni_transform_point(in->b_in_a, start);
	e->points[1] = cni_transform_point(in->b_in_a, end);
}

static void chain_corner(cni_chain_edge *e, const cni_manifold_input *in, int32_t end)
{
	const cni_geometry *g = in->b;
	const cni_vec2 *p = cni_geometry_points(g);
	cni_vec2 start = p[in->child_b], stop = p[chain_neighbour(g, in->child_b + 1)];
	cni_vec2 along = cni_sub(stop, start);
	int32_t ghost = chain_neighbour(g, in->child_b + (end ? 2 : -1));
	e->corner[end] = CNI_CORNER_OPEN;
	e->ghost[end] = e->points[end];
	e->neighbour_normal[end] = e->normal;
	if (ghost == CNI_NONE)
		return;
	cni_vec2 beyond = end ? cni_sub(p[ghost], stop) : cni_sub(start, p[ghost]);
	e->ghost[end] = cni_transform_point(in->b_in_a, p[ghost]);
	e->corner[end] = end ? corner_kind(along, beyond) : corner_kind(beyond, along);
	if (e->corner[end] == CNI_CORNER_CONVEX)
		e->neighbour_normal[end] = normal_moved(in, beyond);
}

/* ------------------------------------------------------------------ circle */

/* For a circle beyond an end: 1 when this edge may push it away from the corner along outward. */
static int32_t corner_owns(const cni_chain_edge *e, int32_t end, cni_vec2 outward, cni_vec2 offset)
{
	if (e->corner[end] == CNI_CORNER_OPEN)
		return 1;
	if (e->corner[end] == CNI_CORNER_FLAT)
		return 0;
	if (cni_dot(offset, cni_sub(e->ghost[end], e->points[end])) > 0.0f)
		return 0;
	return cni_dot(outward, e->normal) >= cni_dot(outward, e->neighbour_normal[end]) - SHARED_COSINE;
}

void cni_collide_circle_chain(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	(void)cache;
	float touch = CNI_TOUCH_PER_SLOP * in->slop;
	cni_chain_edge e;
	chain_surface(&e, in);
	cni_vec2 center = cni_geometry_points(in->a)[0];
	cni_vec2 offset = cni_sub(center, e.points[0]);
	cni_vec2 along = cni_left_perp(e.normal);
	float height = cni_dot(e.normal, offset);
	out->count = 0;
	if (height < 0.0f || height - in->a->radius > in->margin)
		return;
	float at = cni_dot(along, offset);
	float length = cni_dot(along, cni_sub(e.points[1], e.points[0]));
	if (at >= 0.0f && at <= length) {
		cni_circle_manifold(in, e.normal, height - in->a->radius, CNI_FEATURE_EDGE, out);
		return;
	}
	int32_t end = at > 0.0f;
	int32_t almost_on = end ? at <= length + touch : at >= -touch;
	cni_vec2 d = cni_sub(center, e.points[end]);
	float distance = cni_length(d);
	if (!almost_on && distance - in->a->radius > in->margin)
		return;
	chain_corner(&e, in, end);
	/* Flat corners overlap a little, so that rounding opens no gap between two edges. */
	if (e.corner[end] == CNI_CORNER_FLAT && almost_on) {
		cni_circle_manifold(in, e.normal, height - in->a->radius, CNI_FEATURE_EDGE, out);
		return;
	}
	cni_vec2 outward = distance > 0.0f ? cni_normalize(d) : e.normal;
	if (corner_owns(&e, end, outward, d))
		cni_circle_manifold(in, outward, distance - in->a->radius, end, out);
}

/* ------------------------------------------------------------------ shapes with faces */

enum { AXIS_SURFACE, AXIS_SHAPE, AXIS_NEIGHBOUR };

typedef struct chain_axis {
	float separation;
	int32_t kind;
	int32_t edge;   /* AXIS_SHAPE: the face of a */
	float apart;    /* greatest separation along any axis, including axes that may not push */
} chain_axis;

static float points_height(const cni_faces *f, cni_vec2 normal, cni_vec2 origin)
{
	float low = FLT_MAX;
	for (int32_t i = 0; i < f->count; ++i)
		low = cni_min(cni_dot(normal, cni_sub(f->points[i], origin)), low);
	return low;
}

/* Axes of the surface: the edge's own normal (separation `height`) and those of convex neighbours. */
static void surface_axes(const cni_chain_edge *e, const cni_faces *a, float height, float touch, chain_axis *best)
{
	best->separation = height;
	best->kind = AXIS_SURFACE;
	best->edge = 0;
	float bar = best->separation + touch;
	for (int32_t end = 0; end < 2; ++end) {
		if (e->corner[end] != CNI_CORNER_CONVEX)
			continue;
		float separation = points_height(a, e->neighbour_normal[end], e->points[end]);
		if (separation > bar) {
			bar = separation;
			best->separation = separation;
			best->kind = AXIS_NEIGHBOUR;
		}
	}
	best->apart = best->separation;
}

/* Considers a face of the shape as axis, against the edge's ends and the ghosts of convex corners. */
static void shape_axis(const cni_chain_edge *e, cni_vec2 normal, cni_vec2 origin, int32_t edge, float touch, chain_axis *best)
{
	float height[2] = { cni_dot(normal, cni_sub(e->points[0], origin)), cni_dot(normal, cni_sub(e->points[1], origin)) };
	int32_t end = height[1] < height[0];
	float low = height[end];
	int32_t kind = AXIS_SHAPE;
	best->apart = cni_max(best->apart, low);
	if (e->corner[end] == CNI_CORNER_FLAT)
		return;
	for (int32_t i = 0; i < 2; ++i) {
		if (e->corner[i] != CNI_CORNER_CONVEX)
			continue;
		float ghost = cni_dot(normal, cni_sub(e->ghost[i], origin));
		if (ghost < low - touch)
			kind = AXIS_NEIGHBOUR;
		low = cni_min(ghost, low);
	}
	/* An open end does not push towards the back. At a convex end the ghosts limit the axis to the corner's normals. */
	if (e->corner[end] == CNI_CORNER_OPEN && -cni_dot(normal, e->normal) < -CNI_OPEN_BACK_MAX)
		kind = AXIS_NEIGHBOUR;
	float bar = best->kind == AXIS_SURFACE ? best->separation + touch : best->separation;
	if (low <= bar)
		return;
	best->separation = low;
	best->kind = kind;
	best->edge = edge;
}

void cni_collide_faces_chain(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	cni_faces a = cni_faces_of(in->a);
	float touch = CNI_TOUCH_PER_SLOP * in->slop;
	cni_chain_edge e;
	chain_axis best;
	(void)cache;
	out->count = 0;
	chain_surface(&e, in);
	if (cni_dot(e.normal, cni_sub(in->a->centroid, e.points[0])) < 0.0f)
		return;
	float height = points_height(&a, e.normal, e.points[0]);
	if (height > in->margin + a.radius)
		return;
	chain_corner(&e, in, 0);
	chain_corner(&e, in, 1);
	surface_axes(&e, &a, height, touch, &best);
	for (int32_t i = 0; i < a.count && best.apart <= in->margin + a.radius; ++i)
		shape_axis(&e, a.normals[i], a.points[i], i, touch, &best);
	if (best.apart > in->margin + a.radius || best.kind == AXIS_NEIGHBOUR)
		return;
	cni_vec2 normals[2] = { e.normal, cni_neg(e.normal) };
	cni_faces b = { e.points, normals, 2, 0.0f };
	cni_axis axis = { best.separation, best.kind == AXIS_SHAPE ? best.edge : 0, best.kind != AXIS_SHAPE };
	cni_faces_manifold(&a, &b, axis, &e, in, out);
}
