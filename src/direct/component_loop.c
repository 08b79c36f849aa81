/*
 * direct/component_loop.c - loops over the components of a step, which workers share.
 *
 * Components have no movable body in common, and what cannot move is not written (linear/lever.h). One worker alone runs those with contacts, in
 * order, as their attempts share the work of a step (CNI_ATTEMPT_WORK), and those at kinematic bodies, whose rotations they share.
 * Where a component fails in a loop, its joints become soft after the loop: that writes the world.
 *
 * Reads components; writes the list of those that are solved alone, and what the function of a loop writes.
 */
#include "direct/direct_system.h"

#define SHARED_WORK 2000      /* blocks: loops over less are done with before a worker is awake */
#define SHARED_WORK_AWAKE 200 /* ... where the workers wait for it */

static int32_t is_serial(const cni_component *c) { return c->has_contacts || c->meets_kinematic; }

void cni_components_list(cni_sparse *sparse)
{
	for (int32_t serial = 0; serial < 2; ++serial) {
		for (int32_t k = 0; k < sparse->component_count; ++k) {
			const cni_component *c = &sparse->components[k];
			if (c->done || c->batches == CNI_BATCHED || is_serial(c) != serial)
				continue;
			sparse->alone[sparse->alone_count++] = k;
			sparse->alone_work += c->work;
		}
		sparse->shared_count = serial ? sparse->shared_count : sparse->alone_count;
	}
}

cni_team *cni_components_team(const cn_world *world, const cni_sparse *sparse, int32_t times)
{
	return times * sparse->alone_work >= SHARED_WORK ? world->team : NULL;
}

typedef struct component_loop {
	cn_world *world;
	const cni_solve *s;
	cni_component_fn *fn;
	int32_t argument;
} component_loop;

static void components_range(void *context, int32_t begin, int32_t end)
{
	const component_loop *l = (const component_loop *)context;
	for (int32_t k = begin; k < end; ++k)
		l->fn(l->world, l->s, &l->s->direct->components[l->s->direct->alone[k]], l->argument);
}

void cni_components_run(cn_world *world, const cni_solve *s, cni_team *team, cni_component_fn *fn, int32_t argument)
{
	component_loop l = { world, s, fn, argument };
	cni_team_for(s->direct->alone_work >= SHARED_WORK_AWAKE ? team : NULL, s->direct->shared_count, 1, components_range, &l);
	components_range(&l, s->direct->shared_count, s->direct->alone_count);
}

void cni_components_give_up(cn_world *world, const cni_solve *s)
{
	for (int32_t k = 0; k < s->direct->alone_count; ++k)
		if (s->direct->components[s->direct->alone[k]].pending)
			cni_component_give_up(world, s->direct, &s->direct->components[s->direct->alone[k]]);
}
