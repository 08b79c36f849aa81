/*
 * direct/cone_account.c - what an island has spent on interior points (limits and reasons in direct/direct_contact.h).
 *
 * Reads and writes cone_spent and cone_paid_step of islands.
 */
#include "direct/direct_contact.h"

void cni_cone_debt_set(const cn_world *world, cni_island *i, int32_t debt)
{
	i->cone_spent = debt;
	i->cone_paid_step = world->step_count;
}

void cni_cone_motion_owes(const cn_world *world, cni_island *i)
{
	cni_cone_debt_set(world, i, cni_max_i(cni_cone_debt(world, i), CNI_CONE_DEBT + CNI_CONE_REFILL * i->count));
}
