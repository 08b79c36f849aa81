/*
 * test/families/measure.c - errors of joints, overlaps and energy, from poses and velocities.
 */
#include "families.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int32_t measure_read(scene *s)
{
	int32_t k, broken = 0;
	for (k = 0; k < s->body_count; ++k) {
		scene_body *body = &s->bodies[k];
		cn_pose pose;
		cn_vec2 center;
		cn_velocity velocity;
		double sum;
		memset(&velocity, 0, sizeof velocity);
		if (cn_body_get_pose(s->world, body->handle, &pose) != CN_OK || cn_body_get_center(s->world, body->handle, &center) != CN_OK)
			return 1;
		if (body->dynamic && cn_body_get_velocity(s->world, body->handle, &velocity) != CN_OK)
			return 1;
		body->px = (double)pose.position_m.x - s->drifted_m;
		body->py = (double)pose.position_m.y;
		body->c = (double)pose.cosine;
		body->s = (double)pose.sine;
		body->cx = (double)center.x - s->drifted_m;
		body->cy = (double)center.y;
		body->vx = body->dynamic ? (double)velocity.linear_mps.x - s->drift_mps : 0.0;
		body->vy = (double)velocity.linear_mps.y;
		body->w = (double)velocity.angular_radps;
		body->turned += remainder(atan2(body->s, body->c) - body->turned, 2.0 * PI);
		sum = body->px + body->py + body->c + body->s + body->vx + body->vy + body->w;
		broken += !(fabs(sum) < 1e30);
	}
	return broken;
}

/* ---- joints ---- */

static const scene_body the_world = { 0, 0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

static double beyond(const scene_joint *j, double value)
{
	if (j->lower > j->upper)
		return 0.0;
	return fmax(0.0, fmax(j->lower - value, value - j->upper));
}

static double pulley_error(const scene_joint *j, double ax, double ay, double bx, double by)
{
	return fmax(0.0, hypot(ax - j->ground[0], ay - j->ground[1]) + j->ratio * hypot(bx - j->ground[2], by - j->ground[3]) - j->length);
}

/* Metres: gaps and lengths beyond what is allowed, angles times the arm. */
static double joint_error(const scene *s, const scene_joint *j)
{
	const scene_body *a = j->a == WORLD ? &the_world : &s->bodies[j->a], *b = &s->bodies[j->b];
	double ax = a->px + a->c * j->ax - a->s * j->ay, ay = a->py + a->s * j->ax + a->c * j->ay;
	double bx = b->px + b->c * j->bx - b->s * j->by, by = b->py + b->s * j->bx + b->c * j->by;
	double gap = hypot(bx - ax, by - ay), angle = remainder(b->turned - a->turned - j->reference, 2.0 * PI);
	double ux = a->c * j->axis_x - a->s * j->axis_y, uy = a->s * j->axis_x + a->c * j->axis_y;
	double along = ux * (bx - ax) + uy * (by - ay), across = fabs(ux * (by - ay) - uy * (bx - ax));
	switch (j->type) {
	case CN_JOINT_REVOLUTE:
		return fmax(gap, j->arm * beyond(j, angle));
	case CN_JOINT_FIXED:
		return fmax(gap, j->arm * fabs(angle));
	case CN_JOINT_DISTANCE:
		return beyond(j, gap);
	case CN_JOINT_PRISMATIC:
		return fmax(fmax(across, j->arm * fabs(angle)), beyond(j, along));
	case CN_JOINT_WHEEL: case CN_JOINT_GROOVE:
		return fmax(across, beyond(j, along));
	case CN_JOINT_GEAR:
		return j->arm * fabs(b->turned - j->ratio * a->turned - j->reference);
	case ANGLE_CONSTRAINT:
		return j->arm * beyond(j, b->turned);
	case LINE_CONSTRAINT:
		return fmax(fmax(0.0, across - j->tolerance), beyond(j, along));
	case CN_JOINT_PULLEY:
		return pulley_error(j, ax, ay, bx, by);
	default:
		return 0.0;
	}
}

double measure_joints(const scene *s)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < s->joint_count; ++k)
		worst = fmax(worst, joint_error(s, &s->joints[k]));
	return worst;
}

/* ---- overlap: convex cores with radii, by separating axes when the cores overlap, else by their distance ---- */

static double support_gap(const scene_shape *shape, double nx, double ny, double px, double py)
{
	double least = HUGE_VAL;
	int32_t k;
	for (k = 0; k < shape->count; ++k)
		least = fmin(least, nx * (shape->now[k][0] - px) + ny * (shape->now[k][1] - py));
	return least;
}

/* Greatest separation along the normals of a's edges; a segment is a box without thickness. */
static double separation_by(const scene_shape *a, const scene_shape *b)
{
	double most = -HUGE_VAL;
	int32_t k;
	for (k = 0; a->count > 1 && k < a->count; ++k) {
		const double *from = a->now[k], *to = a->now[(k + 1) % a->count];
		double ex = to[0] - from[0], ey = to[1] - from[1], length = hypot(ex, ey);
		most = fmax(most, support_gap(b, ey / length, -ex / length, from[0], from[1]));
		if (a->count == 2)
			most = fmax(most, support_gap(b, ex / length, ey / length, to[0], to[1]));
	}
	return most;
}

static double point_distance(const double *p, const double *from, const double *to)
{
	double ex = to[0] - from[0], ey = to[1] - from[1], dx = p[0] - from[0], dy = p[1] - from[1];
	double square = ex * ex + ey * ey, t = square > 0.0 ? fmax(0.0, fmin(1.0, (ex * dx + ey * dy) / square)) : 0.0;
	return hypot(dx - t * ex, dy - t * ey);
}

static double core_distance(const scene_shape *a, const scene_shape *b)
{
	double least = HUGE_VAL;
	int32_t i, k;
	for (i = 0; i < a->count; ++i)
		for (k = 0; k < b->count; ++k) {
			least = fmin(least, point_distance(a->now[i], b->now[k], b->now[(k + 1) % b->count]));
			least = fmin(least, point_distance(b->now[k], a->now[i], a->now[(i + 1) % a->count]));
		}
	return least;
}

static double shape_overlap(const scene_shape *a, const scene_shape *b)
{
	double radii = a->radius + b->radius, apart = fmax(separation_by(a, b), separation_by(b, a));
	if (apart > radii)
		return 0.0;
	if (apart > 0.0 || (a->count == 1 && b->count == 1))
		apart = core_distance(a, b);
	return fmax(0.0, radii - apart);
}

static void place_shape(const scene *s, scene_shape *shape)
{
	const scene_body *body = &s->bodies[shape->body];
	int32_t k;
	shape->lower[0] = shape->lower[1] = HUGE_VAL;
	shape->upper[0] = shape->upper[1] = -HUGE_VAL;
	for (k = 0; k < shape->count; ++k) {
		double x = shape->points[k][0], y = shape->points[k][1], *now = shape->now[k];
		int32_t axis;
		now[0] = body->px + body->c * x - body->s * y;
		now[1] = body->py + body->s * x + body->c * y;
		for (axis = 0; axis < 2; ++axis) {
			shape->lower[axis] = fmin(shape->lower[axis], now[axis] - shape->radius);
			shape->upper[axis] = fmax(shape->upper[axis], now[axis] + shape->radius);
		}
	}
}

static int compare_pairs(const void *a, const void *b)
{
	uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
	return x < y ? -1 : x > y;
}

static int may_collide(const scene *s, const scene_shape *x, const scene_shape *y)
{
	uint32_t a = (uint32_t)(x->body < y->body ? x->body : y->body), b = (uint32_t)(x->body < y->body ? y->body : x->body), key = a << 16 | b;
	if (a == b || (!s->bodies[a].dynamic && !s->bodies[b].dynamic) || (x->group == y->group && x->group < 0))
		return 0;
	return s->apart_count == 0 || bsearch(&key, s->apart, (size_t)s->apart_count, sizeof key, compare_pairs) == NULL;
}

/* Shapes by their lower x: nearly sorted from frame to frame, so by insertion. */
static void sort_shapes(scene *s)
{
	int32_t k, at;
	if (s->order == NULL) {
		s->order = malloc((size_t)(s->shape_count + 1) * sizeof *s->order);
		if (s->order == NULL)
			exit(2);
		for (k = 0; k < s->shape_count; ++k)
			s->order[k] = k;
		if (s->apart_count > 0)
			qsort(s->apart, (size_t)s->apart_count, sizeof *s->apart, compare_pairs);
	}
	for (k = 1; k < s->shape_count; ++k) {
		int32_t shape = s->order[k];
		double lower = s->shapes[shape].lower[0];
		for (at = k; at > 0 && s->shapes[s->order[at - 1]].lower[0] > lower; --at)
			s->order[at] = s->order[at - 1];
		s->order[at] = shape;
	}
}

double measure_overlap(scene *s)
{
	double deepest = 0.0;
	int32_t i, k;
	for (k = 0; k < s->shape_count; ++k)
		place_shape(s, &s->shapes[k]);
	sort_shapes(s);
	for (i = 0; i < s->shape_count; ++i) {
		const scene_shape *a = &s->shapes[s->order[i]];
		for (k = i + 1; k < s->shape_count; ++k) {
			const scene_shape *b = &s->shapes[s->order[k]];
			if (b->lower[0] > a->upper[0])
				break;
			if (b->lower[1] > a->upper[1] || a->lower[1] > b->upper[1] || !may_collide(s, a, b))
				continue;
			deepest = fmax(deepest, shape_overlap(a, b));
		}
	}
	return deepest;
}

/* ---- energy: kinetic and potential of all dynamic bodies, J ---- */

double measure_energy(const scene *s)
{
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < s->body_count; ++k) {
		const scene_body *b = &s->bodies[k];
		if (b->dynamic)
			sum += 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) + 0.5 * b->inertia * b->w * b->w + b->mass * GRAVITY * b->cy;
	}
	return sum;
}
