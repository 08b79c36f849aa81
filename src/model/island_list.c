/*
 * model/island_list.c - island records: lookup, memory.
 */
#include "model/world.h"

cni_island *cni_island_at(const cn_world *world, int32_t island)
{
	return (cni_island *)cni_table_at_sized(&world->islands, island, sizeof(cni_island), CNI_PAGE_ISLANDS);
}

int32_t cni_island_reserve(cn_world *world, int32_t extra)
{
	return cni_table_reserve(&world->islands, &world->memory, cni_max_i(world->island_used, world->island_count + extra));
}
