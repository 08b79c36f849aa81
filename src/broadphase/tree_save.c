/*
 * broadphase/tree_save.c - a tree through a snapshot (base/snapshot.h): its nodes as they are, and where items hang.
 */
#include "broadphase/tree.h"

static int32_t *places_of(const cni_tree *tree) { return (int32_t *)tree->places.data; }

/* Places there is room for are many; those behind the last item that hangs somewhere say nothing. */
static int32_t places_used(const cni_tree *tree)
{
	int32_t count = tree->places.count;
	while (count > 0 && places_of(tree)[count - 1] == CNI_NONE)
		--count;
	return count;
}

static void counts_pass(cni_tree *tree, cni_snapshot *s)
{
	cni_snapshot_state(s, &tree->node_free, sizeof tree->node_free);
	cni_snapshot_state(s, &tree->count, sizeof tree->count);
	cni_snapshot_state(s, &tree->stale, sizeof tree->stale);
	cni_snapshot_state(s, &tree->dice, sizeof tree->dice);
	cni_snapshot_state(s, &tree->waited, sizeof tree->waited);
	cni_snapshot_state(s, &tree->patience, sizeof tree->patience);
	cni_snapshot_state(s, &tree->built, sizeof tree->built);
	cni_snapshot_state(s, &tree->cost, sizeof tree->cost);
}

void cni_tree_snapshot(cni_tree *tree, cni_snapshot *s)
{
	int32_t k, places = cni_snapshot_number(s, places_used(tree));
	if (cni_snapshot_reserves(s))
		cni_snapshot_need(s, cni_tree_reserve(tree, s->memory, places, 0));
	cni_snapshot_state(s, tree->places.data, (uint64_t)places * sizeof(int32_t));
	cni_snapshot_array(s, &tree->nodes);
	counts_pass(tree, s);
	for (k = places; k < tree->places.count && s->mode == CNI_SNAPSHOT_LOAD; ++k)
		places_of(tree)[k] = CNI_NONE;
}
