/*
 * narrowphase/apart.c - a second look at pairs whose circles meet: does a direction separate the shapes throughout the step?
 *
 * Boxes side by side, the bones of a ragdoll, and a wheel with the next pieces of ground are inside each other's circles and stay apart for
 * many steps. A direction that is fixed in the world separates two shapes for the step if it separates them now by more than the
 * contact margin and what their motion takes: the speed at which the centres approach along it, and the reach of each body's turning. So any
 * direction is right. The good ones are that of the face that separated the pair in its last manifold and, for a circle beside a segment,
 * that of the nearest point.
 *
 * Like culling by circles, this only skips work: the manifold would be empty, or its points would be out of the motion's reach.
 *
 * Reads contacts, bodies, boxes, geometry.
 */
#include "narrowphase/cull.h"

/* Least height of the shape's corners over its body's centre of mass along n. */
CNI_INLINE float lowest_along(const cni_body *b, const cni_geometry *g, cni_vec2 n)
{
	cni_vec2 m = cni_unrotate(b->q, n);
	return cni_points_lowest(cni_geometry_points(g), g->count, m) - cni_dot(m, b->local_center);
}

/* How far turning moves the surfaces in a second. */
CNI_INLINE float turn_of(const cni_body *a, const cni_body *b)
{
	return cni_abs(a->w) * cni_body_turn_reach(a) + cni_abs(b->w) * cni_body_turn_reach(b);
}

/* The face that separated the pair last: cache.axis is not 0. */
CNI_INLINE int32_t face_separates(const cn_world *world, const cni_touch_pair *p, float dt)
{
	int32_t axis = (int32_t)p->contact->cache.axis - 1, side = axis >= CN_POLYGON_MAX_VERTICES, edge = axis - CN_POLYGON_MAX_VERTICES * side;
	const cni_body *f = p->body[side], *o = p->body[1 - side];
	const cni_geometry *face = cni_proxy_geometry(&world->blocks, p->proxy[side]), *other = cni_proxy_geometry(&world->blocks, p->proxy[1 - side]);
	cni_vec2 normal, n;
	float height, closing;
	if (edge >= face->count)
		return 0;
	normal = cni_geometry_normals(face)[edge];
	n = cni_rotate(f->q, normal);
	height = cni_dot(normal, cni_sub(cni_geometry_points(face)[edge], f->local_center));
	closing = cni_max(cni_dot(n, cni_v(f->vx - o->vx, f->vy - o->vy)), 0.0f);
	return cni_dot(n, cni_body_a_to_b(f, o)) + lowest_along(o, other, n) - height - face->radius - other->radius >
	       world->settings.contact_margin + dt * (closing + turn_of(f, o));
}

/* A circle, and a capsule, an edge or a piece of a chain, but the piece that closes a loop. */
CNI_INLINE int32_t circle_is_far(const cn_world *world, const cni_touch_pair *p, float dt)
{
	const cni_body *a = p->body[0], *b = p->body[1];
	const cni_geometry *circle = cni_proxy_geometry(&world->blocks, p->proxy[0]), *other = cni_proxy_geometry(&world->blocks, p->proxy[1]);
	int32_t child = cni_proxy_child(p->proxy[1]);
	const cni_vec2 *points = cni_geometry_points(other) + child;
	cni_vec2 center, start, edge, nearest;
	float reach;
	if (circle->count != 1 || (cni_is_chain(other->type) ? child + 1 >= other->count : other->count != 2))
		return 0;
	center = cni_rotate(a->q, cni_sub(cni_geometry_points(circle)[0], a->local_center));
	edge = cni_rotate(b->q, cni_sub(points[1], points[0]));
	start = cni_add(cni_body_a_to_b(a, b), cni_rotate(b->q, cni_sub(points[0], b->local_center)));
	nearest = cni_segment_nearest(center, start, edge);
	reach = circle->radius + other->radius + world->settings.contact_margin + dt * (cni_length(cni_v(a->vx - b->vx, a->vy - b->vy)) + turn_of(a, b));
	return cni_distance_sq(center, nearest) > reach * reach;
}

int32_t cni_pair_stays_apart(const cn_world *world, const cni_touch_pair *p, float dt)
{
	if (!cni_aabb_overlap(&p->proxy[0]->fat, &p->proxy[1]->fat))
		return 0;
	if (p->contact->cache.axis != 0)
		return face_separates(world, p, dt);
	return CNI_CULL_LOOKS_AHEAD && circle_is_far(world, p, dt);
}
