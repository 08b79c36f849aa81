/*
 * collision/toi.c - time of impact by conservative advancement along separating axes.
 *
 * At a fraction t the closest points (GJK) give an axis n. Along the fixed n the gap between the two
 * skeletons at t + x is bounded from below by a function g that is concave in x:
 *
 *   g(x) = (c + x v).n - target - reach_a(x) - reach_b(x)
 *   reach(x) = max over points of  r.n + x rate + x^2 bend     upper bound on how far points reach along n
 *
 * with c the offset of the centres, v its change, rate the derivative of r.n by rotation, and bend half the greatest second
 * derivative on the interval: -turn^2 r.n, small or 0 for the points in front. While g > 0 the shapes cannot touch. Where a
 * concave function is positive at lo and negative at hi, its secant crosses 0 before the function does, so every secant
 * step is safe. t advances to where g is nearly 0, and a new axis follows. Full rotations at a distance are covered by the
 * discs that the points sweep.
 *
 * Conservative advancement: Mirtich, "Impulse-based Dynamic Simulation" (1996); fixed axes and roots along them: Catto,
 * "Continuous Collision" (GDC 2013). Catto searches the root between the ends of the interval, which misses hits in between
 * when bodies rotate far; the concave bound does not.
 */
#include "collision/toi.h"
#include "collision/distance.h"

#define ITERATIONS_MAX 256
/* Steps of the root search along one axis. */
#define ROOT_STEPS_MAX 6
/* Farthest turn looked at along one axis: beyond, the bound on the bend is too loose to be of use. */
#define TURN_MAX_RAD 1.0f
/* Float error of a distance relative to the lengths that it is computed from. */
#define DISTANCE_ERROR 5.0e-7f

/* One shape: its points relative to its centre of mass. */
typedef struct mover {
	cni_vec2 arms[CN_POLYGON_MAX_VERTICES];
	float lengths[CN_POLYGON_MAX_VERTICES];
	int32_t count;
	float radius;
	float reach;      /* longest arm */
	float turn;
	cni_rot q0, q;    /* rotation at the start and now */
} mover;

/* r.n of each point along an axis now, and its bound after x more: along + x rate + x^2 bend. */
typedef struct support_bound {
	float along[CN_POLYGON_MAX_VERTICES];
	float rate[CN_POLYGON_MAX_VERTICES];
	float bend[CN_POLYGON_MAX_VERTICES];
	int32_t count;
} support_bound;

typedef struct advance {
	mover a, b;
	cni_vec2 center, velocity; /* b's centre minus a's at the start; its change until the end */
	float target;              /* distance of the skeletons */
	float tolerance;
} advance;

/* The gap along one axis. */
typedef struct gap {
	support_bound a, b;
	float distance; /* of the centres along the axis, minus the target */
	float speed;
} gap;

cni_transform cni_path_at(const cni_path *path, float fraction)
{
	cni_transform x;
	x.q = cni_rot_normalize(cni_rot_mul(path->q, cni_sincos(path->turn * fraction)));
	x.t = cni_sub(cni_lerp(path->start, path->end, fraction), cni_rotate(x.q, path->local_center));
	return x;
}

/* ------------------------------------------------------------------ setting up */

static void mover_make(mover *m, const cni_geometry *g, int32_t child, const cni_path *path)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	m->count = set.count;
	m->radius = set.radius;
	m->reach = 0.0f;
	m->turn = path->turn;
	m->q0 = m->q = path->q;
	for (int32_t i = 0; i < set.count; ++i) {
		m->arms[i] = cni_sub(set.points[i], path->local_center);
		m->lengths[i] = cni_length(m->arms[i]);
		m->reach = cni_max(m->reach, m->lengths[i]);
	}
	/* Rotation about its own centre does not move a disc. */
	if (m->count == 1 && !(m->reach > 0.0f))
		m->turn = 0.0f;
}

static void advance_make(advance *v, const cni_toi_input *in)
{
	mover_make(&v->a, in->a, in->child_a, &in->path_a);
	mover_make(&v->b, in->b, in->child_b, &in->path_b);
	v->center = cni_sub(in->path_b.start, in->path_a.start);
	v->velocity = cni_sub(cni_sub(in->path_b.end, in->path_a.end), v->center);
	float size = v->a.reach + v->b.reach + v->a.radius + v->b.radius;
	float travel = cni_length(v->velocity) + cni_abs(v->a.turn) * v->a.reach + cni_abs(v->b.turn) * v->b.reach;
	/* Larger distances have larger errors, but only distances about the size of the shapes decide. */
	v->tolerance = cni_max(in->tolerance, DISTANCE_ERROR * (size + travel));
	v->target = cni_max(in->target + v->a.radius + v->b.radius, v->tolerance);
}

/* 1 when the discs around the centres never touch. */
static int32_t discs_miss(const advance *v)
{
	float reach = v->a.reach + v->b.reach + v->target + v->tolerance;
	float length_sq = cni_length_sq(v->velocity);
	float at = length_sq > 0.0f ? cni_clamp(-cni_dot(v->center, v->velocity) / length_sq, 0.0f, 1.0f) : 0.0f;
	return cni_length_sq(cni_madd(v->center, at, v->velocity)) > reach * reach;
}

/* 1 when a disc whose centre moves straight from `from` to `to` stays on one side of a line without touching it. The line
   goes through `point`; reach is the disc's radius times the length of `normal`. */
static int32_t disc_stays_off(cni_vec2 from, cni_vec2 to, cni_vec2 point, cni_vec2 normal, float reach)
{
	float start = cni_dot(cni_sub(from, point), normal), end = cni_dot(cni_sub(to, point), normal);
	return cni_min(start, end) > reach || cni_max(start, end) < -reach;
}

/* 1 when the disc around b's centre stays in front of a face of a, and a does not rotate. This decides most shapes that fall
   towards a floor. */
static int32_t disc_stays_in_front(const advance *v, const cni_toi_input *in)
{
	const mover *a = &v->a;
	const float reach = v->b.reach + v->target + v->tolerance;
	cni_vec2 from = cni_unrotate(a->q0, v->center), to = cni_unrotate(a->q0, cni_add(v->center, v->velocity)), along;
	if (a->turn != 0.0f || a->count < 2)
		return 0;
	if (in->a->type != CN_SHAPE_POLYGON) {
		along = cni_sub(a->arms[1], a->arms[0]);
		return disc_stays_off(from, to, a->arms[0], cni_left_perp(along), reach * cni_length(along));
	}
	for (int32_t i = 0; i < a->count; ++i) {
		cni_vec2 normal = cni_geometry_normals(in->a)[i];
		if (cni_min(cni_dot(cni_sub(from, a->arms[i]), normal), cni_dot(cni_sub(to, a->arms[i]), normal)) > reach)
			return 1;
	}
	return 0;
}

static void advance_to(advance *v, float t)
{
	v->a.q = cni_rot_normalize(cni_rot_mul(v->a.q0, cni_sincos(v->a.turn * t)));
	v->b.q = cni_rot_normalize(cni_rot_mul(v->b.q0, cni_sincos(v->b.turn * t)));
}

/* Closest points in a frame at a's centre that rotates with a. */
static cni_closest closest_now(const advance *v, float t)
{
	cni_transform b_in_a;
	b_in_a.q = cni_rot_between(v->a.q, v->b.q);
	b_in_a.t = cni_unrotate(v->a.q, cni_madd(v->center, t, v->velocity));
	return cni_closest_find(v->a.arms, v->a.count, v->b.arms, v->b.count, b_in_a);
}

/* ------------------------------------------------------------------ the gap along an axis */

/* During a rotation by at most angle <= 1 rad, r.n = along cos + side sin >= along (1 - angle^2 / 2) - |side| angle
   where along > 0 and side < 0. This bounds the second derivative. */
static void support_bound_make(support_bound *f, const mover *m, cni_vec2 axis, float angle)
{
	cni_vec2 n = cni_unrotate(m->q, axis);
	float cosine_min = 1.0f - 0.5f * angle * angle;
	f->count = m->count;
	for (int32_t i = 0; i < m->count; ++i) {
		float along = cni_dot(m->arms[i], n);
		float side = cni_dot(cni_left_perp(m->arms[i]), n);
		float ahead = m->turn < 0.0f ? -side : side;
		float least = (along > 0.0f ? along * cosine_min : along) + (ahead < 0.0f ? ahead * angle : 0.0f);
		float most = cni_min(cni_max(-least, 0.0f), m->lengths[i]);
		f->along[i] = along;
		f->rate[i] = m->turn * side;
		f->bend[i] = 0.5f * m->turn * m->turn * most;
	}
}

static float support_bound_at(const support_bound *f, float x)
{
	float most = f->along[0] + x * (f->rate[0] + x * f->bend[0]);
	for (int32_t i = 1; i < f->count; ++i)
		most = cni_max(most, f->along[i] + x * (f->rate[i] + x * f->bend[i]));
	return most;
}

static float gap_at(const gap *g, float x)
{
	return g->distance + x * g->speed - support_bound_at(&g->a, x) - support_bound_at(&g->b, x);
}

/* The largest x found in [0, hi] up to which the gap is proven open. */
static float gap_root(const gap *g, float hi, float tolerance)
{
	float lo = 0.0f, gap_lo = gap_at(g, 0.0f), gap_hi = gap_at(g, hi);
	if (gap_hi >= 0.0f)
		return hi;
	for (int32_t i = 0; i < ROOT_STEPS_MAX && gap_lo > 0.25f * tolerance; ++i) {
		lo = lo + (hi - lo) * (gap_lo / (gap_lo - gap_hi));
		gap_lo = cni_max(gap_at(g, lo), 0.0f); /* below 0 by rounding only */
		float middle = 0.5f * (lo + hi);
		float gap_middle = gap_at(g, middle);
		if (gap_middle >= 0.0f) {
			lo = middle;
			gap_lo = gap_middle;
		} else {
			hi = middle;
			gap_hi = gap_middle;
		}
	}
	return lo;
}

/* The interval from t on in which the axis n proves that the shapes do not touch. */
static float axis_free(const advance *v, cni_vec2 n, float t)
{
	float rest = 1.0f - t, x = rest, by_discs;
	float fastest = cni_max(cni_abs(v->a.turn), cni_abs(v->b.turn));
	gap g;
	g.distance = cni_dot(cni_madd(v->center, t, v->velocity), n) - v->target;
	g.speed = cni_dot(v->velocity, n);
	by_discs = g.distance - v->a.reach - v->b.reach;
	if (by_discs > 0.0f && by_discs + rest * g.speed >= 0.0f)
		return rest;
	by_discs = by_discs > 0.0f ? by_discs / -g.speed : 0.0f;
	if (fastest * x > TURN_MAX_RAD)
		x = TURN_MAX_RAD / fastest;
	support_bound_make(&g.a, &v->a, n, cni_abs(v->a.turn) * x);
	support_bound_make(&g.b, &v->b, cni_neg(n), cni_abs(v->b.turn) * x);
	return cni_min(rest, cni_max(by_discs, gap_root(&g, x, v->tolerance)));
}

/* ------------------------------------------------------------------ one-sided edges */

/* 1 when the centroid of the shape is behind the chain edge at this fraction. */
static int32_t is_behind(const cni_geometry *chain, int32_t child, const cni_path *chain_path, const cni_geometry *shape, const cni_path *path, float t)
{
	cni_vec2 storage[2];
	if (!cni_is_chain(chain->type))
		return 0;
	cni_proxy_points edge = cni_geometry_proxy(chain, child, storage);
	cni_rot q_chain = cni_rot_mul(chain_path->q, cni_sincos(chain_path->turn * t));
	cni_rot q = cni_rot_mul(path->q, cni_sincos(path->turn * t));
	cni_vec2 between = cni_sub(cni_lerp(path->start, path->end, t), cni_lerp(chain_path->start, chain_path->end, t));
	cni_vec2 seen = cni_unrotate(q_chain, cni_add(between, cni_rotate(q, cni_sub(shape->centroid, path->local_center))));
	cni_vec2 from = cni_sub(seen, cni_sub(edge.points[0], chain_path->local_center));
	return cni_dot(cni_right_perp(cni_sub(edge.points[1], edge.points[0])), from) < 0.0f;
}

static int32_t comes_from_behind(const cni_toi_input *in, float t)
{
	return is_behind(in->a, in->child_a, &in->path_a, in->b, &in->path_b, t) ||
	       is_behind(in->b, in->child_b, &in->path_b, in->a, &in->path_a, t);
}

/* ------------------------------------------------------------------ the search */

static void result_hit(cni_toi_result *out, const advance *v, const cni_toi_input *in, const cni_closest *closest)
{
	cni_vec2 center_a = cni_lerp(in->path_a.start, in->path_a.end, out->fraction);
	cni_vec2 a = cni_madd(closest->point_a, v->a.radius, closest->normal);
	cni_vec2 b = cni_madd(closest->point_b, -v->b.radius, closest->normal);
	out->state = CNI_TOI_HIT;
	out->distance = closest->distance - v->a.radius - v->b.radius;
	out->normal = cni_rotate(v->a.q, closest->normal);
	out->point = cni_add(center_a, cni_rotate(v->a.q, cni_lerp(a, b, 0.5f)));
	if (comes_from_behind(in, out->fraction))
		out->state = CNI_TOI_SEPARATED;
}

/* Advances until a hit, the end of the step, or the iteration limit. */
static void search(cni_toi_result *out, advance *v, const cni_toi_input *in)
{
	out->fraction = 0.0f;
	out->state = CNI_TOI_FAILED;
	for (; out->iterations < ITERATIONS_MAX;) {
		advance_to(v, out->fraction);
		cni_closest closest = closest_now(v, out->fraction);
		++out->iterations;
		if (!(closest.distance > 0.0f)) {
			out->state = out->fraction > 0.0f ? CNI_TOI_FAILED : CNI_TOI_OVERLAPPED;
			return;
		}
		if (closest.distance <= v->target + v->tolerance) {
			result_hit(out, v, in, &closest);
			return;
		}
		float next = out->fraction + axis_free(v, cni_rotate(v->a.q, closest.normal), out->fraction);
		if (next >= 1.0f) {
			out->state = CNI_TOI_SEPARATED;
			return;
		}
		if (!(next > out->fraction))
			return;
		out->fraction = next;
	}
}

cni_toi_result cni_toi(const cni_toi_input *in)
{
	cni_toi_result out = { CNI_TOI_SEPARATED, 1.0f, 0.0f, { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0 };
	advance v;
	advance_make(&v, in);
	if (discs_miss(&v) || disc_stays_in_front(&v, in) || comes_from_behind(in, 0.0f))
		return out;
	search(&out, &v, in);
	if (out.state == CNI_TOI_SEPARATED)
		out.fraction = 1.0f;
	return out;
}
