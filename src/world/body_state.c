/*
 * world/body_state.c - public functions on a body's type, flags, sleep state and own solver.
 *
 * A change of type or of CN_BODY_ENABLED removes the body from joints, contacts, island and dense arrays,
 * changes the record, and inserts it again. The joints' records stay; only their links are removed and made
 * again, in an order that keeps the order of the body's joint list.
 */
#include "world/define.h"

#include <string.h>

#define FLAGS_SETTABLE (CN_BODY_LOCK_X | CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION | CN_BODY_BULLET | CN_BODY_ENABLED | CN_BODY_SLEEP)
#define FLAGS_LOCKS (CN_BODY_LOCK_X | CN_BODY_LOCK_Y | CN_BODY_LOCK_ROTATION)

/* ------------------------------------------------------------------ unlinking and linking */

/* Reserves memory for the events of ending all contacts and for the islands that linking the joints again creates. */
static void reserve_relink(cni_call *call, cn_world *world, int32_t body)
{
	cni_check_ends_of(call, world, body);
	if (call->result == CN_OK && !cni_island_reserve(world, cni_joint_count(world, body)))
		cni_refuse(call, CN_ERROR_MEMORY, "no memory for islands");
}

/* Unlinks all joints of a body; returns them as a list through next[0], in reverse order. */
static int32_t joints_unlink(cn_world *world, const cni_body *b)
{
	int32_t chain = CNI_NONE;
	while (b->joint_first != CNI_NONE) {
		int32_t joint = b->joint_first >> 1;
		cni_joint_unlink(world, joint);
		cni_joint_at(world, joint)->next[0] = chain;
		chain = joint;
	}
	return chain;
}

/* They begin without impulses: those that held a kinematic body would throw it when it becomes dynamic. */
static void joints_link(cn_world *world, int32_t chain)
{
	while (chain != CNI_NONE) {
		int32_t joint = chain;
		chain = cni_joint_at(world, joint)->next[0];
		memset(cni_joint_at(world, joint)->impulse, 0, sizeof cni_joint_at(world, joint)->impulse);
		cni_joint_link(world, joint);
	}
}

/* Removes a body without linked joints from contacts, island and dense arrays. Requires cni_contact_reserve_end. */
static void leave_simulation(cn_world *world, int32_t body)
{
	cni_contact_destroy_of_body(world, body);
	cni_island_remove_body(world, body);
	if (cni_body_at(world, body)->awake != 0)
		cni_body_leave_awake(world, body);
	world->events.moved_built = 0;
}

/* ------------------------------------------------------------------ type */

/* Whether the body is the only dynamic body of a joint. */
static int32_t is_only_dynamic_of_a_joint(const cn_world *world, const cni_body *b)
{
	int32_t key = b->joint_first;
	while (key != CNI_NONE && cni_is_dynamic(world, cni_joint_at(world, key >> 1)->body[1 - (key & 1)]))
		key = cni_joint_at(world, key >> 1)->next[key & 1];
	return key != CNI_NONE;
}

static void store_type(cn_world *world, cni_body *b, int32_t type)
{
	world->movable_count += (type != CN_BODY_STATIC) - (b->type != CN_BODY_STATIC);
	b->type = (uint8_t)type;
	cni_body_restless(b);
	if (type == CN_BODY_STATIC)
		b->vx = b->vy = b->w = 0.0f;
	if (type != CN_BODY_DYNAMIC)
		b->flags &= ~(uint32_t)CNI_BODY_MASS_OVERRIDE;
}

cn_result cn_body_set_type(cn_world *world, cn_body body, int32_t type)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	int32_t index = cni_body_index(world, body), chain, shape;
	cni_check_range_int(&call, "type", type, CN_BODY_STATIC, CN_BODY_DYNAMIC);
	if (call.result != CN_OK || b->type == type)
		return call.result;
	if (type != CN_BODY_DYNAMIC && is_only_dynamic_of_a_joint(world, b))
		return cni_refuse(&call, CN_ERROR_STATE, "a joint or constraint would be left without a dynamic body");
	reserve_relink(&call, world, cni_body_index(world, body));
	if (call.result == CN_OK && b->type == CN_BODY_STATIC)
		cni_check_reserved(&call, cni_body_reserve(world, 1), "movable bodies");
	if (call.result != CN_OK)
		return call.result;
	cni_body_let_go(world, index);
	cni_body_wake(world, index);
	chain = joints_unlink(world, b);
	leave_simulation(world, index);
	store_type(world, b, type);
	cni_body_update_mass(world, index);
	if (type != CN_BODY_STATIC && (b->flags & CN_BODY_ENABLED))
		cni_body_enter_awake(world, index);
	for (shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
		cni_shape_refilter(world, shape);
	joints_link(world, chain);
	return CN_OK;
}

CNI_DEFINE_GET(body, type, int32_t, record->type)

/* ------------------------------------------------------------------ flags */

static void unplace_all(cn_world *world, const cni_body *b, int32_t end)
{
	for (int32_t shape = b->shape_first; shape != end; shape = cni_shape_at(world, shape)->next)
		cni_shape_unplace(world, shape);
}

/* Creates the boxes of every shape, or of none on failure. */
static void place_all(cni_call *call, cn_world *world, const cni_body *b)
{
	for (int32_t shape = b->shape_first; shape != CNI_NONE && call->result == CN_OK; shape = cni_shape_at(world, shape)->next) {
		cni_check_reserved(call, cni_shape_place(world, shape), "boxes of its shapes");
		if (call->result != CN_OK)
			unplace_all(world, b, shape);
	}
}

static void set_enabled(cn_world *world, int32_t body, int32_t enabled)
{
	cni_body *b = cni_body_at(world, body);
	cni_body_let_go(world, body);
	cni_body_wake(world, body);
	int32_t chain = joints_unlink(world, b);
	if (enabled) {
		b->flags |= CN_BODY_ENABLED;
		cni_body_wake_met(world, body);
	} else {
		leave_simulation(world, body);
		unplace_all(world, b, CNI_NONE);
		b->flags &= ~(uint32_t)CN_BODY_ENABLED;
	}
	joints_link(world, chain);
}

cn_result cn_body_set_flags(cn_world *world, cn_body body, uint32_t flags)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	cni_check_flags(&call, "flags", flags, FLAGS_SETTABLE | CN_BODY_AWAKE);
	if (call.result != CN_OK)
		return call.result;
	flags &= FLAGS_SETTABLE;
	uint32_t changed = (b->flags ^ flags) & FLAGS_SETTABLE;
	if (changed & CN_BODY_ENABLED) {
		reserve_relink(&call, world, cni_body_index(world, body));
		if (flags & CN_BODY_ENABLED)
			place_all(&call, world, b);
		if (call.result != CN_OK)
			return call.result;
		set_enabled(world, cni_body_index(world, body), (flags & CN_BODY_ENABLED) != 0);
	}
	b->flags = (b->flags & ~(uint32_t)FLAGS_SETTABLE) | flags;
	if (changed & FLAGS_LOCKS) {
		cni_body_let_go(world, cni_body_index(world, body));
		cni_body_wake(world, cni_body_index(world, body));
		cni_body_store_velocity(world, b, cni_body_velocity(world, b));
		cni_body_refresh_motion(world, b);
	}
	if ((changed & CN_BODY_SLEEP) && !(flags & CN_BODY_SLEEP))
		cni_body_wake(world, cni_body_index(world, body));
	return CN_OK;
}

CNI_DEFINE_GET(body, flags, uint32_t, (record->flags & FLAGS_SETTABLE) | (record->awake != 0 ? (uint32_t)CN_BODY_AWAKE : 0u))

/* ------------------------------------------------------------------ awake */

/* Splits an island that lost links: bodies that are no longer connected must not sleep together. 0 without memory. */
static int32_t island_split_unconnected(cn_world *world, const cni_body *b)
{
	return b->island == CNI_NONE || cni_island_at(world, b->island)->losses == 0 || cni_island_split(world, b->island);
}

cn_result cn_body_set_awake(cn_world *world, cn_body body, int32_t awake)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	if (call.result != CN_OK)
		return call.result;
	if (awake) {
		cni_body_wake(world, cni_body_index(world, body));
		return CN_OK;
	}
	if (b->awake == 0)
		return CN_OK;
	if (!cni_body_reserve_sleep(world, cni_body_index(world, body)) || !island_split_unconnected(world, b) || !cni_body_put_to_sleep(world, cni_body_index(world, body)))
		return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for contacts at rest");
	world->events.moved_built = 0;
	return CN_OK;
}

/* ------------------------------------------------------------------ solver */

CNI_DEFINE_SET(body, solver, int32_t, solver, cni_check_solver(&call, solver, CN_SOLVER_DIRECT), cni_body_set_solver(world, record, solver))
CNI_DEFINE_GET(body, solver, int32_t, cni_body_solver(record))
