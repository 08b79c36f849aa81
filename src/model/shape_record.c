/*
 * model/shape_record.c - shape records: memory of geometry, proxies, margins of boxes, filters.
 */
#include "model/world.h"

#include <string.h>

uint64_t cni_shape_piece_bytes(const cn_world *world, int32_t type, int32_t count)
{
	int32_t bytes = cni_geometry_bytes(type, count);
	if (world->memory.fixed)
		bytes = cni_max_i(bytes, cni_geometry_bytes(CN_SHAPE_POLYGON, world->vertex_capacity));
	return (uint64_t)bytes;
}

int32_t cni_shape_reserve_extra(cn_world *world, cni_shape *s)
{
	if (s->extra != 0)
		return 1;
	s->extra = cni_blocks_alloc(&world->blocks, sizeof(cni_shape_extra));
	if (s->extra == 0)
		return 0;
	memset(cni_shape_extra_of(&world->blocks, s), 0, sizeof(cni_shape_extra));
	return 1;
}

int32_t cni_shape_edge_proxy(const cn_world *world, const cni_shape *s, int32_t child)
{
	if (s->box.proxies == 0)
		return CNI_NONE;
	return ((const int32_t *)cni_blocks_at(&world->blocks, s->box.proxies))[child];
}

float cni_box_margin(const cn_world *world, int32_t body_type, const cni_aabb *tight)
{
	const cni_settings *set = &world->settings;
	if (body_type == CN_BODY_STATIC || !CNI_ON(FAT_BOXES))
		return set->contact_margin;
	return cni_clamp(CNI_BOX_MARGIN_PART * cni_max(tight->x1 - tight->x0, tight->y1 - tight->y0), set->contact_margin, set->box_margin);
}

cn_result cni_proxy_reserve(cn_world *world, int32_t extra)
{
	if (!cni_table_reserve(&world->proxies, &world->memory, world->proxy_used + cni_max_i(extra - world->proxy_free_count, 0)))
		return CN_ERROR_MEMORY;
	return world->broadphase_ops->reserve(world->broadphase, extra) ? CN_OK : CN_ERROR_MEMORY;
}

void cni_seams_change(cn_world *world, const cni_aabb *box)
{
	if (!CNI_ON(SEAMS))
		return;
	world->seams_box = world->seams_changed ? cni_aabb_union(&world->seams_box, box) : *box;
	world->seams_changed = 1;
}

int32_t cni_filter_allows(const cni_shape *a, const cni_shape *b)
{
	if (a->group == b->group && a->group != 0)
		return a->group > 0;
	return (a->category & b->mask) != 0 && (b->category & a->mask) != 0;
}
