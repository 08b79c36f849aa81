/*
 * collision/manifold_batch_kernel.h - collides CNI_WIDTH pairs of polygons, capsules and edges side by side: included by
 * manifold_batch_4.c and manifold_batch_8.c, which define CNI_WIDTH and CNI_KERNEL (the function's name).
 *
 * The method, the names and the order of every operation are those of manifold_faces.c and distance.c, so that the bits
 * are the same. Branches there are masks here.
 *
 * The lanes of a group have as many places as the shape with the most corners needs, an even number. Corners are loaded by
 * twos; shapes with fewer corners fill the other places by repeating their last two:
 *
 *   place      0   1   2   3   4   5
 *   hexagon   p0  p1  p2  p3  p4  p5
 *   pentagon  p0  p1  p2  p3  p3  p4
 *   box       p0  p1  p2  p3  p2  p3
 *   triangle  p0  p1  p1  p2  p1  p2
 *   segment   p0  p1  p0  p1  p0  p1
 *
 * Of equal corners the code always chooses the first, so only the last corner of an odd number has a place other than its
 * number: the next. Most groups have four places: the compiler makes a copy of the code for them.
 */
#include "base/wide.h"
#include "collision/manifold_batch.h"
#include "collision/manifold_faces.h"

typedef struct wide2 {
	cni_wide x, y;
} wide2;

typedef struct skeleton {
	wide2 point[CN_POLYGON_MAX_VERTICES], normal[CN_POLYGON_MAX_VERTICES]; /* by place */
	cni_mask count;
	cni_mask even; /* corners up to this number have it as their place too: for an odd count, all but the last */
} skeleton;

/* In every lane, a face of one of the two skeletons and its separation from the other one. */
typedef struct face {
	cni_wide separation;
	cni_mask edge;
	cni_mask of_b;
} face;

CNI_INLINE wide2 wide2_of(cni_wide x, cni_wide y) { wide2 v; v.x = x; v.y = y; return v; }
CNI_INLINE cni_wide dot(wide2 a, wide2 b) { return a.x * b.x + a.y * b.y; }
CNI_INLINE wide2 sub(wide2 a, wide2 b) { return wide2_of(a.x - b.x, a.y - b.y); }
CNI_INLINE wide2 rotate(wide2 q, wide2 v) { return wide2_of(q.x * v.x - q.y * v.y, q.y * v.x + q.x * v.y); }
CNI_INLINE wide2 unrotate(wide2 q, wide2 v) { return wide2_of(q.x * v.x + q.y * v.y, q.x * v.y - q.y * v.x); }
CNI_INLINE wide2 choose(cni_mask m, wide2 a, wide2 b) { return wide2_of(cni_wide_select(m, a.x, b.x), cni_wide_select(m, a.y, b.y)); }
CNI_INLINE cni_mask choose_i(cni_mask m, cni_mask a, cni_mask b) { return (m & a) | (~m & b); }
CNI_INLINE cni_mask mask_of(int32_t x) { return x - (cni_mask){ 0 }; }
CNI_INLINE cni_mask mask_load(const int32_t *p) { return *(const cni_mask *)(const void *)p; }
CNI_INLINE void mask_store(int32_t *p, cni_mask m) { *(cni_mask *)(void *)p = m; }

CNI_INLINE int32_t mask_any(cni_mask m) { return cni_mask_bits(m) != 0; }

/* Loads two vectors at an offset (in floats) of each of CNI_WIDTH records. */
CNI_INLINE void load_two(const float *const *records, cni_mask offset, wide2 *first, wide2 *second)
{
	CNI_ALIGNED(32) int32_t at[CNI_WIDTH];
	const float *from[CNI_WIDTH];
	mask_store(at, offset);
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		from[l] = records[l] + at[l];
	cni_wide_gather4_from(from, 0, &first->x, &first->y, &second->x, &second->y);
}

CNI_INLINE void skeleton_load(const float *const *records, const int32_t *count, skeleton *out, int32_t places)
{
	cni_mask twice = mask_load(count) + mask_load(count), last = twice - mask_of(4);
	out->count = mask_load(count);
	out->even = choose_i((out->count & mask_of(1)) == mask_of(0), mask_of(CN_POLYGON_MAX_VERTICES), out->count - mask_of(2));
	cni_wide_gather4_from(records, 0, &out->point[0].x, &out->point[0].y, &out->point[1].x, &out->point[1].y);
	load_two(records, twice, &out->normal[0], &out->normal[1]);
	for (int32_t i = 2; i < places; i += 2) {
		cni_mask at = choose_i(last > mask_of(2 * i), mask_of(2 * i), last);
		load_two(records, at, &out->point[i], &out->point[i + 1]);
		load_two(records, at + twice, &out->normal[i], &out->normal[i + 1]);
	}
}

CNI_INLINE void boxes_load(const float *const *records, skeleton *out)
{
	out->count = mask_of(4);
	out->even = mask_of(CN_POLYGON_MAX_VERTICES);
	for (int32_t i = 0; i < 4; i += 2) {
		cni_wide_gather4_from(records, 2 * i, &out->point[i].x, &out->point[i].y, &out->point[i + 1].x, &out->point[i + 1].y);
		cni_wide_gather4_from(records, 2 * i + 8, &out->normal[i].x, &out->normal[i].y, &out->normal[i + 1].x, &out->normal[i + 1].y);
	}
}

CNI_INLINE cni_mask place_of(const skeleton *s, cni_mask index) { return index - (index > s->even); }
CNI_INLINE cni_mask index_of(const skeleton *s, cni_mask place) { return place + (place > s->even); }

/* The number of places is even. */
CNI_INLINE cni_wide lowest(const skeleton *s, wide2 direction, int32_t places)
{
	cni_wide low = cni_wide_min(dot(direction, s->point[1]), dot(direction, s->point[0]));
	for (int32_t i = 2; i < places; i += 2) {
		low = cni_wide_min(dot(direction, s->point[i]), low);
		low = cni_wide_min(dot(direction, s->point[i + 1]), low);
	}
	return low;
}

/* Separation along the cached face, before b is moved into a's frame. */
CNI_INLINE cni_wide cached_separation(const cni_manifold_batch *k, int32_t l, const skeleton *a, const skeleton *b, wide2 q, wide2 t, int32_t places)
{
	cni_mask axis = mask_load(k->axis + l), of_b = axis > mask_of(CN_POLYGON_MAX_VERTICES);
	wide2 n = wide2_of(cni_wide_load(k->axis_nx + l), cni_wide_load(k->axis_ny + l));
	wide2 p = wide2_of(cni_wide_load(k->axis_px + l), cni_wide_load(k->axis_py + l));
	wide2 moved = rotate(q, n);
	cni_wide of_a_at = lowest(b, unrotate(q, n), places) + dot(n, sub(t, p));
	cni_wide of_b_at = lowest(a, moved, places) - (dot(n, p) + dot(moved, t));
	return cni_wide_select(axis == mask_of(0), cni_wide_of(-FLT_MAX), cni_wide_select(of_b, of_b_at, of_a_at));
}

CNI_INLINE void skeleton_move(skeleton *b, wide2 q, wide2 t, int32_t places)
{
	for (int32_t i = 0; i < places; ++i) {
		wide2 p = rotate(q, b->point[i]);
		b->point[i] = wide2_of(p.x + t.x, p.y + t.y);
		b->normal[i] = rotate(q, b->normal[i]);
	}
}

CNI_INLINE cni_wide face_separation(const skeleton *reference, const skeleton *other, int32_t edge, int32_t places)
{
	return lowest(other, reference->normal[edge], places) - dot(reference->normal[edge], reference->point[edge]);
}

CNI_INLINE face best_face(const skeleton *reference, const skeleton *other, cni_mask of_b, int32_t places)
{
	face f;
	f.edge = mask_of(0);
	f.separation = face_separation(reference, other, 0, places);
	for (int32_t i = 1; i < places; ++i) {
		cni_wide separation = face_separation(reference, other, i, places);
		f.edge = choose_i(separation > f.separation, mask_of(i), f.edge);
		f.separation = cni_wide_max(separation, f.separation);
	}
	f.edge = index_of(reference, f.edge);
	f.of_b = of_b;
	return f;
}

CNI_INLINE face face_select(cni_mask m, face a, face b)
{
	face f = { cni_wide_select(m, a.separation, b.separation), choose_i(m, a.edge, b.edge), choose_i(m, a.of_b, b.of_b) };
	return f;
}

/* The axis of greatest separation. Among nearly equal axes it prefers a's to b's, and the cached one to all. */
CNI_INLINE face axis_choose(const skeleton *a, const skeleton *b, cni_mask cached, cni_wide cached_at, cni_wide touch, int32_t places)
{
	face best = best_face(a, b, mask_of(0), places), of_b = best_face(b, a, mask_of(-1), places), old;
	best = face_select(of_b.separation > best.separation + touch, of_b, best);
	old.separation = cached_at;
	old.of_b = cached > mask_of(CN_POLYGON_MAX_VERTICES);
	old.edge = cached - mask_of(1) - (old.of_b & mask_of(CN_POLYGON_MAX_VERTICES));
	return face_select(cached_at >= cni_wide_max(best.separation, of_b.separation) - touch, old, best);
}

/* Point or normal at a place in every lane. */
CNI_INLINE wide2 pick(const wide2 *v, cni_mask place, int32_t places)
{
	wide2 picked = v[0];
	for (int32_t i = 1; i < places; ++i)
		picked = choose(place == mask_of(i), v[i], picked);
	return picked;
}

CNI_INLINE cni_mask next_vertex(const skeleton *b, cni_mask edge)
{
	cni_mask next = edge + mask_of(1);
	return next & ~(next == b->count);
}

typedef struct clip {
	wide2 normal, start, end;
	cni_wide length;
	cni_mask reference[2], reference_edge;
	cni_mask incident[2], incident_edge;
	wide2 point[2];
	cni_wide at[2], height[2];
} clip;

CNI_INLINE cni_mask incident_find(const skeleton *b, wide2 normal, int32_t places)
{
	cni_wide least = dot(b->normal[0], normal);
	cni_mask edge = mask_of(0);
	for (int32_t i = 1; i < places; ++i) {
		cni_wide facing = dot(b->normal[i], normal);
		edge = choose_i(facing < least, mask_of(i), edge);
		least = cni_wide_min(facing, least);
	}
	return index_of(b, edge);
}

CNI_INLINE clip clip_make(const skeleton *reference, cni_mask edge, const skeleton *incident, int32_t places)
{
	clip c;
	cni_mask place = place_of(reference, edge), end = next_vertex(reference, edge), v0, v1, swap;
	wide2 n = pick(reference->normal, place, places), t = wide2_of(-n.y, n.x), start = pick(reference->point, place, places), first, second;
	c.normal = n;
	c.start = start;
	c.end = pick(reference->point, place_of(reference, end), places);
	c.length = dot(t, sub(c.end, start));
	c.reference[0] = edge;
	c.reference[1] = end;
	c.reference_edge = edge;
	c.incident_edge = v0 = incident_find(incident, n, places);
	v1 = next_vertex(incident, v0);
	first = pick(incident->point, place_of(incident, v0), places);
	second = pick(incident->point, place_of(incident, v1), places);
	swap = dot(t, sub(second, first)) < cni_wide_of(0.0f);
	c.incident[0] = choose_i(swap, v1, v0);
	c.incident[1] = choose_i(swap, v0, v1);
	c.point[0] = choose(swap, second, first);
	c.point[1] = choose(swap, first, second);
	for (int32_t i = 0; i < 2; ++i) {
		wide2 d = sub(c.point[i], start);
		c.at[i] = dot(t, d);
		c.height[i] = dot(n, d);
	}
	return c;
}

typedef struct clipped_end {
	wide2 point;
	cni_wide height;
	cni_mask reference, incident; /* features */
} clipped_end;

CNI_INLINE clipped_end clip_end(const clip *c, int32_t side, cni_wide aligned)
{
	cni_wide beyond = cni_wide_max(side ? c->at[1] - c->length : -c->at[0], cni_wide_of(0.0f));
	cni_wide width = cni_wide_max(c->at[1] - c->at[0], cni_wide_of(FLT_MIN));
	cni_wide fraction = cni_wide_min(beyond / width, cni_wide_of(1.0f));
	cni_wide inside = side ? c->length - c->at[1] : c->at[0];
	wide2 from = c->point[side], to = c->point[1 - side];
	clipped_end e;
	e.point = wide2_of(from.x + fraction * (to.x - from.x), from.y + fraction * (to.y - from.y));
	e.height = c->height[side] + fraction * (c->height[1 - side] - c->height[side]);
	e.reference = choose_i(inside > aligned, mask_of(CNI_FEATURE_EDGE) + c->reference_edge, c->reference[side]);
	e.incident = choose_i(inside < -aligned, mask_of(CNI_FEATURE_EDGE) + c->incident_edge, c->incident[side]);
	return e;
}

CNI_INLINE cni_mask id_of(cni_mask feature_a, cni_mask feature_b)
{
	return (feature_a + mask_of(1)) << 8 | (feature_b + mask_of(1));
}

CNI_INLINE void end_store(cni_manifold_batch *k, int32_t l, int32_t side, const clipped_end *e, cni_mask of_b, wide2 normal)
{
	cni_wide ra = cni_wide_load(k->radius_a + l), rb = cni_wide_load(k->radius_b + l), half = cni_wide_of(0.5f);
	cni_wide shift = cni_wide_select(of_b, half * (e->height + ra - rb), half * (ra - rb - e->height));
	cni_batch_point *p = &k->point[side];
	cni_wide_store(p->x + l, e->point.x + shift * normal.x);
	cni_wide_store(p->y + l, e->point.y + shift * normal.y);
	cni_wide_store(p->separation + l, e->height - (ra + rb));
	mask_store(p->id + l, id_of(choose_i(of_b, e->incident, e->reference), choose_i(of_b, e->reference, e->incident)));
}

/* ---- corners ---- */

/* Closest points of two segments. */
typedef struct closest {
	wide2 point_a, point_b;
	cni_wide fraction_a, fraction_b, distance_sq;
} closest;

CNI_INLINE cni_wide fraction_nearest(wide2 point, wide2 start, wide2 end)
{
	wide2 edge = sub(end, start);
	cni_wide length_sq = dot(edge, edge), fraction = dot(sub(point, start), edge) / length_sq;
	fraction = cni_wide_max(cni_wide_of(0.0f), cni_wide_min(cni_wide_of(1.0f), fraction));
	return cni_wide_select(length_sq > cni_wide_of(0.0f), fraction, cni_wide_of(0.0f));
}

CNI_INLINE wide2 lerp(wide2 a, wide2 b, cni_wide t) { return wide2_of(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)); }

CNI_INLINE void closest_try(closest *best, wide2 a, wide2 b, cni_wide fraction_a, cni_wide fraction_b)
{
	wide2 d = sub(b, a);
	cni_wide distance_sq = dot(d, d);
	cni_mask keep = distance_sq >= best->distance_sq;
	best->point_a = choose(keep, best->point_a, a);
	best->point_b = choose(keep, best->point_b, b);
	best->fraction_a = cni_wide_select(keep, best->fraction_a, fraction_a);
	best->fraction_b = cni_wide_select(keep, best->fraction_b, fraction_b);
	best->distance_sq = cni_wide_select(keep, best->distance_sq, distance_sq);
}

CNI_INLINE closest closest_make(wide2 p1, wide2 q1, wide2 p2, wide2 q2)
{
	closest best;
	cni_wide zero = cni_wide_of(0.0f), one = cni_wide_of(1.0f), f;
	best.point_a = best.point_b = wide2_of(zero, zero);
	best.fraction_a = best.fraction_b = zero;
	best.distance_sq = cni_wide_of(FLT_MAX);
	f = fraction_nearest(p1, p2, q2);
	closest_try(&best, p1, lerp(p2, q2, f), zero, f);
	f = fraction_nearest(q1, p2, q2);
	closest_try(&best, q1, lerp(p2, q2, f), one, f);
	f = fraction_nearest(p2, p1, q1);
	closest_try(&best, lerp(p1, q1, f), p2, f, zero);
	f = fraction_nearest(q2, p1, q1);
	closest_try(&best, lerp(p1, q1, f), q2, f, one);
	return best;
}

/* Lanes in which the two segments cross. */
CNI_INLINE cni_mask segments_cross(wide2 p1, wide2 q1, wide2 p2, wide2 q2)
{
	wide2 e1 = sub(q1, p1), e2 = sub(q2, p2), r = sub(p2, p1);
	cni_wide zero = cni_wide_of(0.0f), c = e1.x * e2.y - e1.y * e2.x, t1 = r.x * e2.y - r.y * e2.x, t2 = r.x * e1.y - r.y * e1.x;
	cni_mask minus = c < zero;
	c = cni_wide_select(minus, -c, c);
	t1 = cni_wide_select(minus, -t1, t1);
	t2 = cni_wide_select(minus, -t2, t2);
	return (c > zero) & (t1 > zero) & (t1 < c) & (t2 > zero) & (t2 < c);
}

CNI_INLINE cni_mask is_end(cni_wide fraction) { return (fraction <= cni_wide_of(0.0f)) | (fraction >= cni_wide_of(1.0f)); }

/* Closest points that may be two corners. */
typedef struct corners {
	closest at;
	wide2 normal;
	cni_wide distance;
	cni_mask a, b;  /* the corners */
	cni_mask known; /* lanes in which the closest features are these corners */
} corners;

CNI_INLINE corners corners_find(const skeleton *a, const skeleton *b, const clip *c, cni_mask of_b, cni_wide touch, cni_wide error, int32_t places)
{
	wide2 p1 = choose(of_b, c->point[0], c->start), q1 = choose(of_b, c->point[1], c->end);
	wide2 p2 = choose(of_b, c->start, c->point[0]), q2 = choose(of_b, c->end, c->point[1]), d;
	corners f;
	f.at = closest_make(p1, q1, p2, q2);
	f.distance = cni_wide_sqrt(f.at.distance_sq);
	d = sub(f.at.point_b, f.at.point_a);
	f.normal = wide2_of(d.x / f.distance, d.y / f.distance);
	cni_mask last_a = ~(f.at.fraction_a < cni_wide_of(1.0f));
	cni_mask last_b = ~(f.at.fraction_b < cni_wide_of(1.0f));
	f.a = choose_i(of_b, choose_i(last_a, c->incident[1], c->incident[0]), choose_i(last_a, c->reference[1], c->reference[0]));
	f.b = choose_i(of_b, choose_i(last_b, c->reference[1], c->reference[0]), choose_i(last_b, c->incident[1], c->incident[0]));
	f.known = is_end(f.at.fraction_a) & is_end(f.at.fraction_b) & ~segments_cross(p1, q1, p2, q2);
	f.known &= (f.distance > touch) & (f.at.distance_sq < cni_wide_of(FLT_MAX));
	f.known &= -lowest(a, wide2_of(-f.normal.x, -f.normal.y), places) - dot(f.normal, f.at.point_a) <= error;
	f.known &= dot(f.normal, f.at.point_b) - lowest(b, f.normal, places) <= error;
	return f;
}

/* Overwrites the stored point with the corners' point in some lanes. */
CNI_INLINE void corners_store(cni_manifold_batch *k, int32_t l, const corners *f, cni_mask where)
{
	cni_wide ra = cni_wide_load(k->radius_a + l), separation = f->distance - ra - cni_wide_load(k->radius_b + l);
	cni_wide shift = ra + cni_wide_of(0.5f) * separation;
	cni_batch_point *p = &k->point[0];
	cni_wide_store_where(k->nx + l, where, f->normal.x);
	cni_wide_store_where(k->ny + l, where, f->normal.y);
	cni_wide_store_where(p->x + l, where, f->at.point_a.x + shift * f->normal.x);
	cni_wide_store_where(p->y + l, where, f->at.point_a.y + shift * f->normal.y);
	cni_wide_store_where(p->separation + l, where, separation);
	mask_store(p->id + l, choose_i(where, id_of(f->a, f->b), mask_load(p->id + l)));
}

/* ---- manifolds ---- */

/* Stores the points of every lane and its state. */
CNI_INLINE void points_store(cni_manifold_batch *k, int32_t l, const skeleton *a, const skeleton *b, face axis, cni_mask is_apart, cni_wide touch, cni_wide aligned,
	int32_t places)
{
	skeleton reference, incident;
	clipped_end low, high, first, second;
	for (int32_t i = 0; i < places; ++i) {
		reference.point[i] = choose(axis.of_b, b->point[i], a->point[i]);
		reference.normal[i] = choose(axis.of_b, b->normal[i], a->normal[i]);
		incident.point[i] = choose(axis.of_b, a->point[i], b->point[i]);
		incident.normal[i] = choose(axis.of_b, a->normal[i], b->normal[i]);
	}
	reference.count = choose_i(axis.of_b, b->count, a->count);
	incident.count = choose_i(axis.of_b, a->count, b->count);
	reference.even = choose_i(axis.of_b, b->even, a->even);
	incident.even = choose_i(axis.of_b, a->even, b->even);
	clip c = clip_make(&reference, axis.edge, &incident, places);
	low = clip_end(&c, 0, aligned);
	high = clip_end(&c, 1, aligned);
	cni_wide at = cni_wide_select(c.height[1] < c.height[0], c.at[1], c.at[0]);
	cni_wide height = cni_wide_select(c.height[1] < c.height[0], c.height[1], c.height[0]);
	cni_mask exact = (at >= cni_wide_of(0.0f)) & (at <= c.length);
	cni_wide overlap = cni_wide_min(c.length, c.at[1]) - cni_wide_max(cni_wide_of(0.0f), c.at[0]);
	cni_mask missed = overlap < cni_wide_of(0.0f);
	cni_wide ends = cni_wide_min(low.height, high.height);
	cni_mask near = ~missed & (cni_wide_abs(ends - height) <= touch);
	cni_mask wanted = ~is_apart & ~exact & ~near & (missed | (height > touch));
	wide2 normal = choose(axis.of_b, wide2_of(-c.normal.x, -c.normal.y), c.normal);
	cni_wide_store(k->nx + l, normal.x);
	cni_wide_store(k->ny + l, normal.y);
	first.point = choose(axis.of_b, high.point, low.point);
	first.height = cni_wide_select(axis.of_b, high.height, low.height);
	first.reference = choose_i(axis.of_b, high.reference, low.reference);
	first.incident = choose_i(axis.of_b, high.incident, low.incident);
	second.point = choose(axis.of_b, low.point, high.point);
	second.height = cni_wide_select(axis.of_b, low.height, high.height);
	second.reference = choose_i(axis.of_b, low.reference, high.reference);
	second.incident = choose_i(axis.of_b, low.incident, high.incident);
	end_store(k, l, 0, &first, axis.of_b, normal);
	end_store(k, l, 1, &second, axis.of_b, normal);
	cni_mask state = choose_i(overlap >= touch, mask_of(CNI_BATCH_POINTS), mask_of(CNI_BATCH_FALLBACK));
	if (mask_any(wanted)) {
		corners f = corners_find(a, b, &c, axis.of_b, touch, cni_wide_of(0.01f * k->slop), places);
		cni_mask where = wanted & f.known & (missed | ~(cni_wide_abs(ends - f.distance) <= touch));
		corners_store(k, l, &f, where);
		state = choose_i(where, mask_of(CNI_BATCH_POINT), choose_i(wanted & ~f.known, mask_of(CNI_BATCH_FALLBACK), state));
	}
	mask_store(k->state + l, choose_i(is_apart, mask_of(CNI_BATCH_APART), state));
}

CNI_INLINE void pairs_collide(cni_manifold_batch *k, int32_t l, skeleton *a, skeleton *b, int32_t places)
{
	cni_wide touch = cni_wide_of(CNI_TOUCH_PER_SLOP * k->slop), aligned = cni_wide_of(CNI_ALIGNED_PER_SLOP * k->slop);
	cni_wide reach = cni_wide_load(k->margin + l) + cni_wide_load(k->radius_a + l) + cni_wide_load(k->radius_b + l), cached_at;
	wide2 q = wide2_of(cni_wide_load(k->qc + l), cni_wide_load(k->qs + l)), t = wide2_of(cni_wide_load(k->tx + l), cni_wide_load(k->ty + l));
	cni_mask cached = mask_load(k->axis + l), is_apart, still;
	cached_at = cached_separation(k, l, a, b, q, t, places);
	still = cached_at > reach;
	mask_store(k->state + l, mask_of(CNI_BATCH_APART));
	if (!mask_any(~still))
		return;
	skeleton_move(b, q, t, places);
	face axis = axis_choose(a, b, cached, cached_at, touch, places);
	mask_store(k->axis + l, choose_i(still, cached, axis.edge + mask_of(1) + (axis.of_b & mask_of(CN_POLYGON_MAX_VERTICES))));
	is_apart = still | (axis.separation > reach);
	if (mask_any(~is_apart))
		points_store(k, l, a, b, axis, is_apart, touch, aligned, places);
}

/* Some shape has more than four corners. */
static void polygons_collide(cni_manifold_batch *k, int32_t l)
{
	skeleton a, b;
	int32_t most = 0, places;
	for (int32_t i = l; i < l + CNI_WIDTH; ++i)
		most = cni_max_i(most, cni_max_i(k->count_a[i], k->count_b[i]));
	places = (most + 1) & ~1;
	skeleton_load(k->a + l, k->count_a + l, &a, places);
	skeleton_load(k->b + l, k->count_b + l, &b, places);
	pairs_collide(k, l, &a, &b, places);
}

/* Inlined into the kernel, with loops of a constant length: most pairs come here. */
CNI_INLINE void fours_collide(cni_manifold_batch *k, int32_t l)
{
	skeleton a, b;
	if (mask_any((mask_load(k->count_a + l) & mask_load(k->count_b + l)) != mask_of(4))) { /* some count is less than 4 */
		skeleton_load(k->a + l, k->count_a + l, &a, 4);
		skeleton_load(k->b + l, k->count_b + l, &b, 4);
	} else {
		boxes_load(k->a + l, &a);
		boxes_load(k->b + l, &b);
	}
	pairs_collide(k, l, &a, &b, 4);
}

void CNI_KERNEL(cni_manifold_batch *batch, int32_t pairs)
{
	for (int32_t l = 0; l < pairs; l += CNI_WIDTH)
		if (mask_any((mask_load(batch->count_a + l) > mask_of(4)) | (mask_load(batch->count_b + l) > mask_of(4))))
			polygons_collide(batch, l);
		else
			fours_collide(batch, l);
}
