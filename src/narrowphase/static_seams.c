/*
 * narrowphase/static_seams.c - finds corners that are hidden between flush faces of static shapes, or of shapes of one kinematic body
 * (collision/seam.c). Searches the box around such shapes that were created, moved by their user, changed or destroyed since the last step;
 * without changes it does nothing.
 *
 * Reads proxies, shapes, bodies, the broadphase; writes the seams in geometry records.
 */
#include "narrowphase/touch.h"
#include "collision/manifold.h"

typedef struct seam_search {
	cn_world *world;
	int32_t proxy;
	cni_geometry *geometry;
} seam_search;

/* Do both shapes collide with the same shapes? Otherwise a shape could fall into the seam. */
static int32_t stop_the_same(const cni_shape *a, const cni_shape *b)
{
	return a->category == b->category && a->mask == b->mask && a->group == b->group &&
	       ((a->flags | b->flags) & (CN_SHAPE_SENSOR | CN_SHAPE_ONE_WAY | CN_SHAPE_PRE_SOLVE)) == 0;
}

static float neighbour_add_seams(void *context, int32_t proxy, float limit)
{
	const seam_search *s = (const seam_search *)context;
	const cn_world *world = s->world;
	const cni_proxy *p = cni_proxy_at(world, proxy), *own = cni_proxy_at(world, s->proxy);
	const cni_shape *shape = cni_shape_at(world, p->shape), *own_shape = cni_shape_at(world, own->shape);
	float slop = world->settings.slop;
	if (proxy == s->proxy || (shape->body != own_shape->body && !(p->flags & own->flags & CNI_PROXY_STATIC)))
		return limit;
	const cni_geometry *g = cni_proxy_geometry(&world->blocks, p);
	if (!cni_seams_possible(g, slop) || !stop_the_same(shape, own_shape))
		return limit;
	const cni_body *a = cni_body_at(world, own_shape->body);
	const cni_body *b = cni_body_at(world, shape->body);
	s->geometry->seams |= cni_seams_between(s->geometry, g, cni_body_b_in_a(a, b, cni_body_a_to_b(a, b)), slop);
	return limit;
}

static float changed_find_seams(void *context, int32_t proxy, float limit)
{
	cn_world *world = (cn_world *)context;
	const cni_proxy *p = cni_proxy_at(world, proxy);
	seam_search s = { world, proxy, (cni_geometry *)cni_blocks_at(&world->blocks, p->geometry) };
	if (cni_is_chain(s.geometry->type))
		return limit;
	s.geometry->seams = 0;
	if (!cni_is_dynamic(world, cni_shape_at(world, p->shape)->body) && cni_seams_possible(s.geometry, world->settings.slop))
		world->broadphase_ops->query(world->broadphase, &p->fat, neighbour_add_seams, &s);
	return limit;
}

void cni_stage_seams(cn_world *world)
{
	if (!world->seams_changed)
		return;
	world->seams_changed = 0;
	world->broadphase_ops->query(world->broadphase, &world->seams_box, changed_find_seams, world);
}
