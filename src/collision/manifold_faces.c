/*
 * collision/manifold_faces.c - the kernel of all pairs whose skeletons have faces.
 *
 *  1. Separating axes: find the face of either shape with the greatest separation. The cached axis is tested first, so that
 *     pairs that stay apart cost one face, and it is kept while no other axis is better by more than the touch distance.
 *  2. Clip the incident edge, the edge of the other shape opposite the reference face, to the slab between the reference
 *     face's ends (Sutherland, Hodgman 1974; for boxes Catto, GDC 2006).
 *  3. Where the axis does not give the distance (the deepest vertex is beyond the face's end and the skeletons are apart),
 *     the closest features give one point along their true direction. The two clipped edges give a guess that support
 *     points verify; GJK decides otherwise.
 *
 *        incident edge      1 ------------ 0        position along t
 *                     ------|--------------|------
 *        reference edge     start   n^     end      t = left_perp(n)
 *
 * The Minkowski difference of two crossing segments is a parallelogram whose sides are their faces, so the kernel is exact for
 * capsules and edges as well.
 *
 * Invariant: a manifold's points are ordered along left_perp of its normal, whichever shape was the
 * reference, and an id names the same two features either way.
 */
#include "collision/manifold_faces.h"
#include "collision/distance.h"

static const cni_transform same_frame = { { 1.0f, 0.0f }, { 0.0f, 0.0f } };

static cni_faces faces_moved(cni_faces f, cni_transform transform, cni_faces_storage *storage)
{
	for (int32_t i = 0; i < f.count; ++i) {
		storage->points[i] = cni_transform_point(transform, f.points[i]);
		storage->normals[i] = cni_rotate(transform.q, f.normals[i]);
	}
	cni_faces moved = { storage->points, storage->normals, f.count, f.radius };
	return moved;
}

/* Two boxes: computes the four faces side by side, which compilers vectorize. */
static float boxes_best(const cni_faces *reference, const cni_faces *other, int32_t *out_edge)
{
	const cni_vec2 *n = reference->normals;
	const cni_vec2 *p = reference->points;
	const cni_vec2 *q = other->points;
	float nx[4], ny[4], face[4], low[4];
	for (int32_t i = 0; i < 4; ++i) {
		nx[i] = n[i].x;
		ny[i] = n[i].y;
		face[i] = nx[i] * p[i].x + ny[i] * p[i].y;
		low[i] = nx[i] * q[0].x + ny[i] * q[0].y;
	}
	for (int32_t i = 0; i < 4; ++i)
		low[i] = cni_min(nx[i] * q[1].x + ny[i] * q[1].y, low[i]);
	for (int32_t i = 0; i < 4; ++i)
		low[i] = cni_min(nx[i] * q[2].x + ny[i] * q[2].y, low[i]);
	for (int32_t i = 0; i < 4; ++i)
		low[i] = cni_min(nx[i] * q[3].x + ny[i] * q[3].y, low[i]) - face[i];
	int32_t edge01 = low[1] > low[0];
	int32_t edge23 = 2 + (low[3] > low[2]);
	float best01 = cni_max(low[1], low[0]);
	float best23 = cni_max(low[3], low[2]);
	*out_edge = best23 > best01 ? edge23 : edge01;
	return cni_max(best23, best01);
}

/* The face of reference with the greatest separation from other; returns the separation. */
static float faces_best(const cni_faces *reference, const cni_faces *other, int32_t *out_edge)
{
	if (reference->count == 4 && other->count == 4)
		return boxes_best(reference, other, out_edge);
	float best = -FLT_MAX;
	int32_t edge = 0;
	for (int32_t i = 0; i < reference->count; ++i) {
		cni_vec2 n = reference->normals[i];
		float separation = cni_points_lowest(other->points, other->count, n) - cni_dot(n, reference->points[i]);
		edge = separation > best ? i : edge;
		best = cni_max(separation, best);
	}
	*out_edge = edge;
	return best;
}

/* ------------------------------------------------------------------ clipping */

typedef struct clip {
	cni_vec2 normal;       /* of the reference face */
	float length;          /* of the reference edge: positions 0 to length */
	int32_t reference[2];  /* its vertices, by position */
	int32_t reference_edge;
	int32_t incident[2];   /* vertices of the incident edge, by position */
	int32_t incident_edge;
	cni_vec2 point[2];     /* of the incident vertices */
	float at[2];           /* positions of the incident vertices */
	float height[2];       /* ... and their heights over the reference face */
	int32_t lowest;        /* 0 or 1: the lower incident vertex */
} clip;

/* The edge whose normal is most opposed to the reference normal. It ends at the lowest vertex, because that vertex's two
   normals enclose the direction down. Unlike that vertex it does not change with a slight tilt of a box that lies flat. */
static int32_t incident_find(const cni_faces *f, cni_vec2 normal)
{
	int32_t edge = 0;
	float least = cni_dot(f->normals[0], normal);
	for (int32_t i = 1; i < f->count; ++i) {
		float facing = cni_dot(f->normals[i], normal);
		edge = facing < least ? i : edge;
		least = cni_min(facing, least);
	}
	return edge;
}

static void clip_make(clip *c, const cni_faces *a, const cni_faces *b, cni_axis axis)
{
	const cni_faces *reference = axis.of_b ? b : a, *incident = axis.of_b ? a : b;
	cni_vec2 n = reference->normals[axis.edge];
	cni_vec2 t = cni_left_perp(n);
	int32_t edge = axis.edge, end = edge + 1 < reference->count ? edge + 1 : 0;
	cni_vec2 start_point = reference->points[edge];
	c->normal = n;
	c->length = cni_dot(t, cni_sub(reference->points[end], start_point));
	c->reference[0] = edge;
	c->reference[1] = end;
	c->reference_edge = edge;
	c->incident_edge = incident_find(incident, n);
	int32_t v0 = c->incident_edge;
	int32_t v1 = v0 + 1 < incident->count ? v0 + 1 : 0;
	/* Both shapes are counter-clockwise, so edges that face each other run in opposite directions. */
	int32_t swap = cni_dot(t, cni_sub(incident->points[v1], incident->points[v0])) < 0.0f;
	c->incident[0] = swap ? v1 : v0;
	c->incident[1] = swap ? v0 : v1;
	for (int32_t i = 0; i < 2; ++i) {
		c->point[i] = incident->points[c->incident[i]];
		cni_vec2 d = cni_sub(c->point[i], start_point);
		c->at[i] = cni_dot(t, d);
		c->height[i] = cni_dot(n, d);
	}
	c->lowest = c->height[1] < c->height[0];
}

/* Overlap of the two edges along the reference face; negative: minus their distance. */
static float clip_overlap(const clip *c)
{
	return cni_min(c->length, c->at[1]) - cni_max(0.0f, c->at[0]);
}

/* 1 when the lowest vertex is in front of the reference edge itself: the separation is then the true distance. */
static int32_t clip_is_exact(const clip *c)
{
	float at = c->at[c->lowest];
	return at >= 0.0f && at <= c->length;
}

static uint32_t clip_id(const clip *c, int32_t side, int32_t of_b, float aligned)
{
	float reference_at = side ? c->length : 0.0f;
	float inside = side ? reference_at - c->at[1] : c->at[0] - reference_at;
	int32_t reference_feature = inside > aligned ? CNI_FEATURE_EDGE + c->reference_edge : c->reference[side];
	int32_t incident_feature = inside < -aligned ? CNI_FEATURE_EDGE + c->incident_edge : c->incident[side];
	return of_b ? cni_manifold_id(incident_feature, reference_feature) : cni_manifold_id(reference_feature, incident_feature);
}

typedef struct contact_end {
	cni_vec2 point;  /* on the incident skeleton */
	float height;
	int32_t vertex;  /* side (0 or 1) that names its features in the id */
} contact_end;

static contact_end clip_end(const clip *c, int32_t side)
{
	float beyond = cni_max(side ? c->at[1] - c->length : -c->at[0], 0.0f);
	float width = cni_max(c->at[1] - c->at[0], FLT_MIN);
	float fraction = cni_min(beyond / width, 1.0f);
	float height = c->height[side] + fraction * (c->height[1 - side] - c->height[side]);
	contact_end e = { cni_lerp(c->point[side], c->point[1 - side], fraction), height, side };
	return e;
}

/* Both ends of the overlap, or one if they are closer than the touch distance. Returns their number. */
static int32_t clip_ends(const clip *c, float touch, contact_end ends[2])
{
	float overlap = clip_overlap(c);
	if (overlap >= touch) {
		ends[0] = clip_end(c, 0);
		ends[1] = clip_end(c, 1);
		return 2;
	}
	if (overlap < 0.0f) {
		/* The edges miss each other: the nearer end of the incident edge. */
		int32_t side = c->at[0] > c->length ? 0 : 1;
		const contact_end nearer = { c->point[side], c->height[side], side };
		ends[0] = nearer;
		return 1;
	}
	contact_end low = clip_end(c, 0), high = clip_end(c, 1);
	ends[0] = high.height < low.height ? high : low;
	return 1;
}

static void clip_emit(const clip *c, const cni_faces *a, const cni_faces *b, int32_t of_b, const cni_manifold_input *in, cni_manifold *out)
{
	contact_end ends[2];
	int32_t count = clip_ends(c, CNI_TOUCH_PER_SLOP * in->slop, ends);
	float radii = a->radius + b->radius;
	cni_vec2 n = of_b ? cni_neg(c->normal) : c->normal;
	out->normal = n;
	out->count = 0;
	for (int32_t i = 0; i < count; ++i) {
		const contact_end *e = &ends[of_b ? count - 1 - i : i];
		if (e->height - radii > in->margin)
			continue;
		/* Moves the incident skeleton point along the normal to the middle between the surfaces. */
		float shift = of_b ? 0.5f * (e->height + a->radius - b->radius) : 0.5f * (a->radius - b->radius - e->height);
		cni_manifold_point *p = &out->points[out->count++];
		p->point = cni_madd(e->point, shift, n);
		p->separation = e->height - radii;
		p->id = clip_id(c, e->vertex, of_b, CNI_ALIGNED_PER_SLOP * in->slop);
	}
}

/* ------------------------------------------------------------------ closest features */

static int32_t feature_of(const int32_t index[2], int32_t count)
{
	if (index[0] == index[1])
		return index[0];
	int32_t low = cni_min_i(index[0], index[1]);
	int32_t high = cni_max_i(index[0], index[1]);
	return CNI_FEATURE_EDGE + (high == low + 1 ? low : count - 1);
}

/* 1 when no point of either skeleton reaches into the gap between the two closest points by more than error. */
static int32_t closest_holds(const cni_faces *a, const cni_faces *b, const cni_closest *c, float error)
{
	float reach_a = -cni_points_lowest(a->points, a->count, cni_neg(c->normal));
	float reach_b = cni_points_lowest(b->points, b->count, c->normal);
	return reach_a - cni_dot(c->normal, c->point_a) <= error && cni_dot(c->normal, c->point_b) - reach_b <= error;
}

static void ends_set(int32_t index[2], float fraction, int32_t first, int32_t second)
{
	index[0] = fraction < 1.0f ? first : second;
	index[1] = fraction > 0.0f ? second : first;
}

/* Closest features: guessed from the clipped edges and verified, otherwise found by GJK. */
static cni_closest closest_features(const cni_faces *a, const cni_faces *b, const clip *c, int32_t of_b, float slop)
{
	const int32_t *va = of_b ? c->incident : c->reference;
	const int32_t *vb = of_b ? c->reference : c->incident;
	cni_segment_distance s = cni_segment_to_segment(a->points[va[0]], a->points[va[1]], b->points[vb[0]], b->points[vb[1]]);
	if (s.distance_sq > 0.0f) {
		cni_closest guess = { s.point_a, s.point_b, cni_normalize(cni_sub(s.point_b, s.point_a)), cni_sqrt(s.distance_sq), { 0, 0 }, { 0, 0 } };
		ends_set(guess.index_a, s.fraction_a, va[0], va[1]);
		ends_set(guess.index_b, s.fraction_b, vb[0], vb[1]);
		if (guess.distance > CNI_TOUCH_PER_SLOP * slop && closest_holds(a, b, &guess, 0.01f * slop))
			return guess;
	}
	return cni_closest_find(a->points, a->count, b->points, b->count, same_frame);
}

static void point_emit(const cni_faces *a, const cni_faces *b, const cni_closest *c, const cni_manifold_input *in, cni_manifold *out)
{
	float separation = c->distance - a->radius - b->radius;
	out->normal = c->normal;
	out->count = 0;
	if (separation > in->margin)
		return;
	out->count = 1;
	out->points[0].point = cni_madd(c->point_a, a->radius + 0.5f * separation, c->normal);
	out->points[0].separation = separation;
	out->points[0].id = cni_manifold_id(feature_of(c->index_a, a->count), feature_of(c->index_b, b->count));
}

/* ------------------------------------------------------------------ chain corners */

enum { GATE_OPEN, GATE_FACE, GATE_REFUSE };

/* Decides whether the closest features of a chain edge (shape b) may push along their own direction (GATE_OPEN), only along
   the axis (GATE_FACE), or not at all. of_surface: the axis is the chain edge's own normal, which may always push shapes in
   front of the edge. */
static int32_t chain_gate(const cni_chain_edge *chain, const cni_closest *c, int32_t of_surface, float overlap, float touch)
{
	cni_vec2 outward = cni_neg(c->normal);
	if (c->index_b[0] != c->index_b[1])
		return cni_dot(outward, chain->normal) > 0.0f ? GATE_OPEN : GATE_REFUSE;
	int32_t end = c->index_b[0];
	switch (chain->corner[end]) {
	case CNI_CORNER_FLAT:
		return of_surface && overlap > -touch ? GATE_FACE : GATE_REFUSE;
	case CNI_CORNER_CONVEX:
		/* Beyond the neighbour's normal the contact belongs to the neighbour's far end, not to this corner. */
		return cni_dot(outward, cni_sub(chain->ghost[end], chain->points[end])) <= touch ? GATE_OPEN : GATE_REFUSE;
	default:
		return cni_dot(outward, chain->normal) >= -CNI_OPEN_BACK_MAX ? GATE_OPEN : GATE_REFUSE;
	}
}

/* ------------------------------------------------------------------ manifolds */

/* Difference between the separation of the clipped edges and the true distance of the skeletons. */
static float clip_error(const clip *c, float touch, float distance)
{
	contact_end ends[2];
	int32_t count = clip_ends(c, touch, ends);
	float low = count == 2 ? cni_min(ends[0].height, ends[1].height) : ends[0].height;
	return cni_abs(low - distance);
}

/* 1 when the clipped edges give the true distance up to the touch distance. The true distance is at least the lowest
   vertex's height and at most the height of the lowest clipped end, which is in front of the reference edge. Faces that
   rest on each other pass this test and need no closest features. */
static int32_t clip_is_near(const clip *c, float overlap, float touch)
{
	return overlap >= 0.0f && clip_error(c, touch, c->height[c->lowest]) <= touch;
}

/* The face that is the closest feature of f, direction pointing out of f; CNI_NONE for a vertex. */
static int32_t closest_face(const cni_faces *f, const int32_t index[2], cni_vec2 direction)
{
	int32_t feature = feature_of(index, f->count);
	if (feature < CNI_FEATURE_EDGE)
		return CNI_NONE;
	if (f->count == 2)
		return cni_dot(f->normals[0], direction) < 0.0f;
	return feature - CNI_FEATURE_EDGE;
}

/* Manifold of separated skeletons with known closest features: clips along a face if one of them is a face and the clipped
   distance is right, else gives one point. */
static void closest_emit(const cni_faces *a, const cni_faces *b, const cni_closest *closest, const cni_manifold_input *in, cni_manifold *out)
{
	cni_axis axis;
	clip c;
	axis.of_b = 0;
	axis.separation = closest->distance;
	axis.edge = closest_face(a, closest->index_a, closest->normal);
	if (axis.edge == CNI_NONE) {
		axis.of_b = 1;
		axis.edge = closest_face(b, closest->index_b, cni_neg(closest->normal));
	}
	if (axis.edge != CNI_NONE) {
		clip_make(&c, a, b, axis);
		if (clip_error(&c, CNI_TOUCH_PER_SLOP * in->slop, closest->distance) <= CNI_TOUCH_PER_SLOP * in->slop) {
			clip_emit(&c, a, b, axis.of_b, in, out);
			return;
		}
	}
	point_emit(a, b, closest, in, out);
}

void cni_faces_manifold(const cni_faces *a, const cni_faces *b, cni_axis axis, const cni_chain_edge *chain,
	const cni_manifold_input *in, cni_manifold *out)
{
	float touch = CNI_TOUCH_PER_SLOP * in->slop;
	clip c;
	clip_make(&c, a, b, axis);
	float overlap = clip_overlap(&c);
	if ((c.height[c.lowest] > touch || overlap < 0.0f) && !clip_is_exact(&c) && !clip_is_near(&c, overlap, touch)) {
		cni_closest closest = closest_features(a, b, &c, axis.of_b, in->slop);
		if (closest.distance > touch && (overlap < 0.0f || clip_error(&c, touch, closest.distance) > touch)) {
			int32_t gate = chain == NULL ? GATE_OPEN : chain_gate(chain, &closest, axis.of_b, overlap, touch);
			out->count = 0;
			if (gate == GATE_OPEN)
				closest_emit(a, b, &closest, in, out);
			if (gate != GATE_FACE)
				return;
		}
	}
	clip_emit(&c, a, b, axis.of_b, in, out);
}

/* Separation along the cached face, before b is moved into a's frame. -FLT_MAX: nothing cached. */
static float cached_separation(const cni_faces *a, const cni_faces *b, cni_transform b_in_a, int32_t cached)
{
	if (cached >= 1 && cached <= a->count) {
		cni_vec2 n = a->normals[cached - 1];
		float low = cni_points_lowest(b->points, b->count, cni_unrotate(b_in_a.q, n));
		return low + cni_dot(n, cni_sub(b_in_a.t, a->points[cached - 1]));
	}
	if (cached > CN_POLYGON_MAX_VERTICES && cached <= CN_POLYGON_MAX_VERTICES + b->count) {
		int32_t edge = cached - CN_POLYGON_MAX_VERTICES - 1;
		cni_vec2 n = cni_rotate(b_in_a.q, b->normals[edge]);
		float face = cni_dot(b->normals[edge], b->points[edge]);
		return cni_points_lowest(a->points, a->count, n) - (face + cni_dot(n, b_in_a.t));
	}
	return -FLT_MAX;
}

/* The axis of greatest separation. Among nearly equal axes it prefers a's to b's, and the cached one to all. */
static cni_axis axis_choose(const cni_faces *a, const cni_faces *b, int32_t cached, float cached_at, float touch)
{
	cni_axis best, of_b;
	best.of_b = 0;
	best.separation = faces_best(a, b, &best.edge);
	of_b.of_b = 1;
	of_b.separation = faces_best(b, a, &of_b.edge);
	if (of_b.separation > best.separation + touch)
		best = of_b;
	if (cached_at >= cni_max(best.separation, of_b.separation) - touch) {
		best.separation = cached_at;
		best.of_b = cached > CN_POLYGON_MAX_VERTICES;
		best.edge = cached - 1 - (best.of_b ? CN_POLYGON_MAX_VERTICES : 0);
	}
	return best;
}

void cni_collide_polygons(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	cni_faces a = cni_faces_of(in->a), b_local = cni_faces_of(in->b);
	float reach = in->margin + a.radius + b_local.radius;
	int32_t cached = cache->axis;
	float cached_at = cached_separation(&a, &b_local, in->b_in_a, cached);
	out->count = 0;
	if (cached_at > reach)
		return;
	cni_faces_storage storage;
	cni_faces b = faces_moved(b_local, in->b_in_a, &storage);
	cni_axis axis = axis_choose(&a, &b, cached, cached_at, CNI_TOUCH_PER_SLOP * in->slop);
	cache->axis = (uint8_t)(axis.edge + 1 + (axis.of_b ? CN_POLYGON_MAX_VERTICES : 0));
	if (axis.separation > reach)
		return;
	cni_faces_manifold(&a, &b, axis, NULL, in, out);
}
