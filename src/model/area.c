/*
 * model/area.c - the list of areas (layout in area.h).
 */
#include "model/world.h"

cni_area *cni_area_of_shape(const cn_world *world, int32_t shape)
{
	int32_t k;
	for (k = 0; k < world->areas.count; ++k)
		if (cni_areas(world)[k].shape == shape)
			return cni_areas(world) + k;
	return NULL;
}

void cni_area_remove(cn_world *world, int32_t shape)
{
	int32_t k, kept = 0;
	for (k = 0; k < world->areas.count; ++k)
		if (cni_areas(world)[k].shape != shape)
			cni_areas(world)[kept++] = cni_areas(world)[k];
	world->areas.count = kept;
}

int32_t cni_area_set(cn_world *world, const cni_area *area)
{
	int32_t k;
	if (!cni_array_reserve(&world->areas, &world->memory, world->areas.count + 1))
		return 0;
	cni_area_remove(world, area->shape);
	for (k = world->areas.count; k > 0; --k) {
		const cni_area *before = cni_areas(world) + k - 1;
		if (cni_area_is_before(before, area))
			break;
		cni_areas(world)[k] = *before;
	}
	cni_areas(world)[k] = *area;
	++world->areas.count;
	return 1;
}
