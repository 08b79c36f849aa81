/*
 * geometry/outline_decompose.c - a simple polygon into convex pieces, without new points and without memory (34 KB of stack).
 *
 * 1. Ears are clipped (Meisters 1975) into triangles, which half-edges connect. A clip changes whether its two neighbours are ears and
 *    no others, so each vertex is tested about three times.
 * 2. Diagonals flip while the smaller altitude of their two triangles grows (Lawson 1977, with the altitude as measure: it is what the
 *    shape check requires).
 * 3. Diagonals are removed while the union of their two pieces stays one that cni_check_polygon accepts (Hertel, Mehlhorn 1983), the
 *    longest first. Vertices that are flat in the union, within the resolution of floats, are left out of it.
 * 4. Pieces that the check refuses are thinner than the tolerance, and are left out.
 * Orientations are exact, so 1 and 2 cannot fail; heights and lengths are plain floats.
 * O(count^2).
 */
#include "geometry/outline.h"

#include <string.h>

#define TRIANGLES_MAX (CNI_OUTLINE_POINTS_MAX - 2)
#define HALF_EDGES_MAX (3 * TRIANGLES_MAX)
#define RING_MAX (2 * CN_POLYGON_MAX_VERTICES)
#define NO_TWIN 0xFFFFu /* an edge of the outline */

enum diagonal { DIAGONAL_UNTRIED, DIAGONAL_REMOVED, DIAGONAL_KEPT };

/* Half-edge h is edge h % 3 of triangle h / 3, from corner[h] to corner[half_next(h)]; the triangle is on its left. */
typedef struct mesh {
	cni_vec2 points[CNI_OUTLINE_POINTS_MAX];
	uint16_t corner[HALF_EDGES_MAX];
	uint16_t twin[HALF_EDGES_MAX];
	uint8_t diagonal[HALF_EDGES_MAX];
	uint8_t emitted[HALF_EDGES_MAX];
	int32_t point_count;
	int32_t half_edge_count;
	float tolerance;
	float flat; /* height of a vertex that is left out of a union */
} mesh;

static int32_t half_next(int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
static int32_t half_previous(int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

static void half_link(mesh *m, int32_t h, uint32_t twin)
{
	m->twin[h] = (uint16_t)twin;
	if (twin != NO_TWIN)
		m->twin[twin] = (uint16_t)h;
}

/* ------------------------------------------------------------------ ears */

/* The part of the outline that is not clipped yet, counter-clockwise. */
typedef struct unclipped {
	uint16_t next[CNI_OUTLINE_POINTS_MAX];
	uint16_t previous[CNI_OUTLINE_POINTS_MAX];
	uint16_t outside[CNI_OUTLINE_POINTS_MAX]; /* the half-edge beyond the edge from this vertex to the next, or NO_TWIN */
	uint8_t no_ear[CNI_OUTLINE_POINTS_MAX];   /* tested, and neither neighbour was clipped since */
	int32_t count;
} unclipped;

static void unclipped_init(unclipped *r, int32_t count)
{
	for (int32_t i = 0; i < count; ++i) {
		r->next[i] = (uint16_t)(i + 1 < count ? i + 1 : 0);
		r->previous[i] = (uint16_t)(i > 0 ? i - 1 : count - 1);
		r->outside[i] = NO_TWIN;
		r->no_ear[i] = 0;
	}
	r->count = count;
}

static int32_t triangle_holds(cni_vec2 a, cni_vec2 b, cni_vec2 c, cni_vec2 p)
{
	if (p.x < cni_min(a.x, cni_min(b.x, c.x)) || p.x > cni_max(a.x, cni_max(b.x, c.x)))
		return 0;
	return cni_orientation(a, b, p) >= 0 && cni_orientation(b, c, p) >= 0 && cni_orientation(c, a, p) >= 0;
}

static int32_t vertex_is_ear(const mesh *m, const unclipped *r, int32_t vertex)
{
	int32_t before = r->previous[vertex], after = r->next[vertex];
	cni_vec2 a = m->points[before], b = m->points[vertex], c = m->points[after];
	if (cni_orientation(a, b, c) <= 0)
		return 0;
	for (int32_t i = r->next[after]; i != before; i = r->next[i])
		if (triangle_holds(a, b, c, m->points[i]))
			return 0;
	return 1;
}

static void ear_clip(mesh *m, unclipped *r, int32_t vertex)
{
	int32_t before = r->previous[vertex], after = r->next[vertex];
	int32_t h = m->half_edge_count;
	m->corner[h] = (uint16_t)before;
	m->corner[h + 1] = (uint16_t)vertex;
	m->corner[h + 2] = (uint16_t)after;
	half_link(m, h, r->outside[before]);
	half_link(m, h + 1, r->outside[vertex]);
	half_link(m, h + 2, r->count == 3 ? r->outside[after] : NO_TWIN);
	m->half_edge_count += 3;
	r->outside[before] = (uint16_t)(h + 2);
	r->next[before] = (uint16_t)after;
	r->previous[after] = (uint16_t)before;
	r->no_ear[before] = r->no_ear[after] = 0;
	--r->count;
}

/* Alternates around the outline, so that fans of thin triangles do not arise. */
static int32_t outline_triangulate(mesh *m)
{
	unclipped r;
	int32_t vertex = 0, waited = 0;
	unclipped_init(&r, m->point_count);
	m->half_edge_count = 0;
	while (r.count >= 3 && waited < r.count) {
		int32_t after = r.next[vertex];
		if (r.no_ear[vertex] || !vertex_is_ear(m, &r, vertex)) {
			r.no_ear[vertex] = 1;
			++waited;
		} else {
			ear_clip(m, &r, vertex);
			after = r.next[after];
			waited = 0;
		}
		vertex = after;
	}
	return r.count < 3;
}

/* ------------------------------------------------------------------ flips */

static float altitude_least(cni_vec2 a, cni_vec2 b, cni_vec2 c)
{
	float longest = cni_max(cni_distance_sq(a, b), cni_max(cni_distance_sq(b, c), cni_distance_sq(c, a)));
	return cni_abs(cni_cross(cni_sub(b, a), cni_sub(c, a))) / cni_sqrt(longest);
}

static void diagonal_flip(mesh *m, int32_t h)
{
	int32_t g = m->twin[h];
	int32_t h1 = half_next(h), h2 = half_previous(h), g1 = half_next(g), g2 = half_previous(g);
	uint16_t a = m->corner[h], b = m->corner[g], c = m->corner[h2], d = m->corner[g2];
	uint16_t bc = m->twin[h1], ca = m->twin[h2], ad = m->twin[g1], db = m->twin[g2];
	m->corner[h] = d;
	m->corner[h1] = c;
	m->corner[h2] = a;
	m->corner[g] = c;
	m->corner[g1] = d;
	m->corner[g2] = b;
	half_link(m, h1, ca);
	half_link(m, h2, ad);
	half_link(m, g1, db);
	half_link(m, g2, bc);
}

static int32_t flip_gains(const mesh *m, int32_t h)
{
	int32_t g = m->twin[h];
	cni_vec2 a = m->points[m->corner[h]], b = m->points[m->corner[g]];
	cni_vec2 c = m->points[m->corner[half_previous(h)]], d = m->points[m->corner[half_previous(g)]];
	if (cni_orientation(c, a, d) <= 0 || cni_orientation(d, b, c) <= 0)
		return 0;
	return cni_min(altitude_least(d, c, a), altitude_least(c, d, b)) > 1.001f * cni_min(altitude_least(a, b, c), altitude_least(b, a, d));
}

/* Each flip raises the smaller altitude of a pair of triangles, so flips end; the bound only guards the time. */
static void diagonals_flip(mesh *m)
{
	int32_t flipped = 1;
	for (int32_t sweep = 0; flipped && sweep < m->point_count; ++sweep) {
		flipped = 0;
		for (int32_t h = 0; h < m->half_edge_count; ++h) {
			if (m->twin[h] == NO_TWIN || m->twin[h] < h || !flip_gains(m, h))
				continue;
			diagonal_flip(m, h);
			flipped = 1;
		}
	}
}

/* ------------------------------------------------------------------ pieces */

/* The next edge of the piece's boundary. */
static int32_t boundary_next(const mesh *m, int32_t h)
{
	h = half_next(h);
	while (m->diagonal[h] == DIAGONAL_REMOVED)
		h = half_next(m->twin[h]);
	return h;
}

static int32_t ring_flattest(const cni_vec2 *ring, int32_t count, float flat)
{
	int32_t flattest = CNI_NONE;
	float least = flat;
	for (int32_t i = 0; i < count; ++i) {
		float height = cni_vertex_height(ring, count, i);
		if (height <= least) {
			flattest = i;
			least = height;
		}
	}
	return flattest;
}

/* The piece with boundary edge h as a polygon; 0 if no shape could take it. */
static int32_t piece_make(const mesh *m, int32_t first, cn_polygon *out)
{
	cni_vec2 ring[RING_MAX];
	int32_t count = 0, h = first, flattest;
	do {
		if (count == RING_MAX)
			return 0;
		ring[count++] = m->points[m->corner[h]];
		h = boundary_next(m, h);
	} while (h != first);
	while (count > 3 && (flattest = ring_flattest(ring, count, m->flat)) != CNI_NONE)
		count = cni_point_remove(ring, count, flattest);
	if (count > CN_POLYGON_MAX_VERTICES)
		return 0;
	memset(out, 0, sizeof *out);
	out->count = count;
	memcpy(out->points_m, ring, (size_t)count * sizeof ring[0]);
	return cni_check_polygon(out, m->tolerance) == NULL;
}

static void diagonal_set(mesh *m, int32_t h, enum diagonal state)
{
	m->diagonal[h] = m->diagonal[m->twin[h]] = (uint8_t)state;
}

static int32_t diagonal_longest_untried(const mesh *m)
{
	int32_t longest = CNI_NONE;
	float length_sq = -1.0f;
	for (int32_t h = 0; h < m->half_edge_count; ++h) {
		if (m->twin[h] == NO_TWIN || m->twin[h] < h || m->diagonal[h] != DIAGONAL_UNTRIED)
			continue;
		float l = cni_distance_sq(m->points[m->corner[h]], m->points[m->corner[m->twin[h]]]);
		if (l > length_sq) {
			longest = h;
			length_sq = l;
		}
	}
	return longest;
}

static void pieces_merge(mesh *m)
{
	int32_t h;
	memset(m->diagonal, DIAGONAL_UNTRIED, sizeof m->diagonal);
	while ((h = diagonal_longest_untried(m)) != CNI_NONE) {
		cn_polygon piece;
		diagonal_set(m, h, DIAGONAL_REMOVED);
		if (!piece_make(m, boundary_next(m, h), &piece))
			diagonal_set(m, h, DIAGONAL_KEPT);
	}
}

static int32_t pieces_write(mesh *m, cn_polygon *out, int32_t capacity)
{
	int32_t count = 0;
	memset(m->emitted, 0, sizeof m->emitted);
	for (int32_t h = 0; h < m->half_edge_count; ++h) {
		cn_polygon piece;
		int32_t i = h;
		if (m->diagonal[h] == DIAGONAL_REMOVED || m->emitted[h])
			continue;
		do {
			m->emitted[i] = 1;
			i = boundary_next(m, i);
		} while (i != h);
		if (!piece_make(m, h, &piece))
			continue;
		if (count < capacity)
			out[count] = piece;
		++count;
	}
	return count;
}

const char *cni_outline_decompose(const cni_vec2 *points, int32_t count, float tolerance, cn_polygon *out, int32_t capacity,
                                  int32_t *out_count)
{
	mesh m;
	const char *wrong = cni_outline_clean(points, count, tolerance, m.points, &m.point_count);
	if (wrong != NULL)
		return wrong;
	m.tolerance = tolerance;
	m.flat = cni_collinear_height(m.points, m.point_count, 0.0f);
	int32_t complete = outline_triangulate(&m);
	CNI_ASSERT(complete);
	(void)complete;
	diagonals_flip(&m);
	pieces_merge(&m);
	*out_count = pieces_write(&m, out, capacity);
	return *out_count > 0 ? NULL : "the outline must be thicker than the tolerance";
}
