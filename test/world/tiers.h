/*
 * test/world/tiers.h - what the tests of the solver's choice for islands share: worlds, stacks, reports.
 */
#ifndef TEST_WORLD_TIERS_H
#define TEST_WORLD_TIERS_H

#include "direct/direct.h"
#include "contacts/contacts.h"
#include "heaps.h"
#include "joints.h"
#include "model/world.h"
#include "direct/direct_contact.h"
#include "model/solve.h"

#define REPORTS 64

static inline cn_world *make_world(int32_t solver, float accuracy, int32_t budget)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	def.solver = solver;
	def.accuracy_m = accuracy;
	def.work_budget = budget;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

/* Unit boxes one on the other, exactly touching. Returns the lowest; *out_top may be NULL. */
static inline cn_body stack(cn_world *world, float x, int32_t count, cn_body *out_top)
{
	cn_body first = 0, box = 0;
	int32_t k;
	for (k = 0; k < count; ++k) {
		box = fixture_box(world, CN_BODY_DYNAMIC, x, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		first = k == 0 ? box : first;
	}
	if (out_top != NULL)
		*out_top = box;
	return first;
}

static inline int32_t reports(const cn_world *world, cn_island_report *out)
{
	int32_t count = 0;
	memset(out, 0, sizeof *out * REPORTS);
	must(cn_world_get_islands(world, out, REPORTS, &count), world, "cn_world_get_islands");
	return count;
}

/* The report on the only island. */
static inline cn_island_report report(const cn_world *world)
{
	cn_island_report list[REPORTS];
	CHECK(reports(world, list) == 1);
	return list[0];
}

static inline int is(const cn_world *world, int32_t tier, int32_t reason)
{
	cn_island_report r = report(world);
	if (r.tier == tier && r.reason == reason)
		return 1;
	printf("  tier %d reason %d, not %d and %d\n", (int)r.tier, (int)r.reason, (int)tier, (int)reason);
	return 0;
}

static inline void set_body(cn_world *world, cn_body body, int32_t solver)
{
	must(cn_body_set_solver(world, body, solver), world, "cn_body_set_solver");
}

#endif
