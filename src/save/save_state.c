/*
 * save/save_state.c - what the state of a world is: every member of cn_world is in one of the lists below, or is passed by
 * cni_world_snapshot.
 *
 * Scratch of a step is not state, nor is what would be found again as it is: the lists of events that users see are built from
 * the logs; lanes of joints and plans of direct solving that are kept from the last step give the bits of new ones
 * (joints/joint_blocks.c, linear/sparse_plan.c), each compared with what it depends on before it is used. Memory, workers, callbacks, and the sentence of the
 * last error stay the world's own.
 */
#include "save/save.h"

#include <stddef.h>
#include <string.h>

typedef struct member {
	uint32_t offset;
	uint32_t bytes;
} member;

#define MEMBER(name) { (uint32_t)offsetof(cn_world, name), (uint32_t)sizeof(((cn_world *)0)->name) }

/* Copied as it is. */
static const member state_members[] = {
	MEMBER(user_data), MEMBER(settings), MEMBER(step_count), MEMBER(step_dt), MEMBER(mean_dt), MEMBER(overridden),
	MEMBER(movable_count), MEMBER(awake_count), MEMBER(fixed_step), MEMBER(time_owed), MEMBER(steps_max),
	MEMBER(proxy_used), MEMBER(proxy_free), MEMBER(proxy_count), MEMBER(proxy_free_count), MEMBER(pairs_may_repeat),
	MEMBER(seams_changed), MEMBER(seams_box), MEMBER(contact_used), MEMBER(contact_free), MEMBER(contact_count), MEMBER(contacts_reporting), MEMBER(touching_count),
	MEMBER(block_used), MEMBER(block_free), MEMBER(colors), MEMBER(constraint_count), MEMBER(stressed_joints),
	MEMBER(island_used), MEMBER(island_free), MEMBER(island_count), MEMBER(split_step), MEMBER(joints_soft_step), MEMBER(settled),
	MEMBER(piles_new), MEMBER(masses_estimated), MEMBER(estimated), MEMBER(piles_unheld), MEMBER(solvers_asked), MEMBER(direct_work), MEMBER(direct_failed), MEMBER(cone_work),
	MEMBER(warnings), MEMBER(pairs_not_added), MEMBER(events_not_reported)
};

/* Passed below. */
static const member passed_members[] = {
	MEMBER(blocks), MEMBER(body_handles), MEMBER(bodies), MEMBER(motion), MEMBER(start), MEMBER(external), MEMBER(awake_id), MEMBER(kicked),
	MEMBER(previous), MEMBER(shape_handles), MEMBER(shapes), MEMBER(proxies), MEMBER(broadphase), MEMBER(areas), MEMBER(contacts), MEMBER(apart),
	MEMBER(blocks_hot), MEMBER(blocks_info), MEMBER(blocks_anchor), MEMBER(blocks_extra), MEMBER(sleep_lanes), MEMBER(joint_handles),
	MEMBER(joints), MEMBER(awake_joints), MEMBER(islands), MEMBER(direct_islands), MEMBER(events)
};

/* Memory, scratch, caches, what stays the world's own. */
static const member other_members[] = {
	MEMBER(memory), MEMBER(vertex_capacity), MEMBER(arena), MEMBER(team), MEMBER(locked), MEMBER(awake_islands), MEMBER(step_islands), MEMBER(step_island_count),
	MEMBER(reserved_time), MEMBER(broadphase_ops), MEMBER(pairs), MEMBER(block_list), MEMBER(joint_work), MEMBER(joint_blocks),
	MEMBER(joint_colors), MEMBER(joint_lanes), MEMBER(row_blocks), MEMBER(row_block_count), MEMBER(row_blocks_of), MEMBER(joint_plain_first),
	MEMBER(reserved_plain), MEMBER(direct_plans), MEMBER(filter), MEMBER(filter_user), MEMBER(pre_solve), MEMBER(pre_solve_user),
	MEMBER(material_mix), MEMBER(material_mix_user), MEMBER(profile), MEMBER(error), MEMBER(readback), MEMBER(readback_kept), MEMBER(readback_asked),
	MEMBER(sums), MEMBER(sums_count), MEMBER(sums_active), MEMBER(event_capacity), MEMBER(reserved_islands), MEMBER(set_work), MEMBER(bodies_stopped)
};

#define COUNT_OF(list) ((int32_t)(sizeof(list) / sizeof((list)[0])))

/* ---- parts ---- */

/* Room that is made before records and events need it, so that what they do cannot fail: as when they were made. */
static void rooms_pass(cn_world *world, cni_snapshot *s)
{
	int32_t movable = cni_snapshot_number(s, world->movable_count), contacts = cni_snapshot_number(s, world->contact_count);
	int32_t lanes = cni_snapshot_number(s, world->touching_count), islands = cni_snapshot_number(s, world->island_count);
	int32_t joints = cni_snapshot_number(s, world->joint_handles.count), reporting = cni_snapshot_number(s, world->contacts_reporting);
	if (!cni_snapshot_reserves(s))
		return;
	cni_snapshot_need(s, cni_body_reserve(world, movable - world->movable_count) == CN_OK && cni_lane_reserve(world, lanes) &&
	                             cni_contact_reserve(world, contacts - world->contact_count) == CN_OK &&
	                             (!world->memory.fixed || cni_contact_reserve_reports(world, reporting)) &&
	                             cni_island_reserve(world, islands - world->island_count) &&
	                             cni_joint_reserve(world, joints - world->joint_handles.count) == CN_OK);
}

/* Few worlds have contacts that need extra rows; where none does now, they are all zero. */
static int32_t extra_used(const cn_world *world)
{
	int32_t k;
	if (cni_table_capacity(&world->blocks_extra) == 0)
		return 0;
	for (k = 0; k < world->block_used; ++k)
		if (cni_block_info_at(world, k)->flags & CNI_BLOCK_EXTRA)
			return world->block_used;
	return 0;
}

static void extra_pass(cn_world *world, cni_snapshot *s)
{
	int32_t used = extra_used(world), k;
	uint64_t bytes = s->bytes + sizeof(int32_t);
	if (s->mode == CNI_SNAPSHOT_LOAD && used == 0 && cni_table_capacity(&world->blocks_extra) > 0)
		for (k = 0; k < world->block_used; ++k)
			memset(cni_block_extra_at(world, k), 0, sizeof(cni_block_extra));
	cni_snapshot_table(s, &world->blocks_extra, used);
	if (cni_snapshot_reserves(s) && (s->bytes > bytes || cni_table_capacity(&world->blocks_extra) > 0))
		cni_snapshot_need(s, cni_lane_reserve_extra(world));
}

/* Before the counters below them: what was used until now is still known. */
static void tables_pass(cn_world *world, cni_snapshot *s)
{
	cni_snapshot_table(s, &world->bodies, cni_handles_used(&world->body_handles));
	cni_snapshot_table(s, &world->shapes, cni_handles_used(&world->shape_handles));
	cni_snapshot_table(s, &world->proxies, world->proxy_used);
	cni_snapshot_table(s, &world->contacts, world->contact_used);
	cni_snapshot_table(s, &world->blocks_hot, world->block_used);
	extra_pass(world, s); /* asks the infos */
	cni_snapshot_table(s, &world->blocks_info, world->block_used);
	cni_snapshot_table(s, &world->blocks_anchor, world->block_used);
	cni_snapshot_table(s, &world->joints, cni_handles_used(&world->joint_handles));
	cni_snapshot_table(s, &world->islands, world->island_used);
}

static void handles_pass(cni_snapshot *s, cni_handles *handles)
{
	cni_snapshot_array(s, &handles->slots);
	cni_snapshot_array(s, &handles->aliases);
	cni_snapshot_array(s, &handles->by_slot);
	cni_snapshot_state(s, &handles->count, sizeof handles->count);
	cni_snapshot_state(s, &handles->free_first, sizeof handles->free_first);
	cni_snapshot_state(s, &handles->free_last, sizeof handles->free_last);
	cni_snapshot_state(s, &handles->worn, sizeof handles->worn);
	cni_snapshot_state(s, &handles->alias_next, sizeof handles->alias_next);
}

static void arrays_pass(cn_world *world, cni_snapshot *s)
{
	cni_snapshot_array(s, &world->motion);
	cni_snapshot_array(s, &world->start);
	cni_snapshot_array(s, &world->external);
	cni_snapshot_array(s, &world->awake_id);
	cni_snapshot_array(s, &world->kicked);
	cni_snapshot_array(s, &world->previous);
	cni_snapshot_array(s, &world->areas);
	cni_snapshot_array(s, &world->apart);
	cni_snapshot_array(s, &world->sleep_lanes);
	cni_snapshot_array(s, &world->awake_joints);
	cni_snapshot_array(s, &world->direct_islands);
}

/* The logs; what was built from them is void. */
static void events_pass(cni_events *events, cni_snapshot *s)
{
	int32_t kind;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		cni_snapshot_array(s, &events->log[kind]);
		cni_snapshot_array(s, &events->pending[kind]);
		if (s->mode == CNI_SNAPSHOT_LOAD)
			events->built[kind] = events->seen[kind].count = 0;
	}
	cni_snapshot_array(s, &events->sensor_log);
	cni_snapshot_array(s, &events->sensor_pending);
	cni_snapshot_array(s, &events->joint_log);
	cni_snapshot_array(s, &events->joint_pending);
	cni_snapshot_array(s, &events->asleep);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		events->moved_built = events->moved.count = 0;
}

void cni_world_snapshot(cn_world *world, cni_snapshot *s)
{
	int32_t k;
	rooms_pass(world, s);
	tables_pass(world, s);
	handles_pass(s, &world->body_handles);
	handles_pass(s, &world->shape_handles);
	handles_pass(s, &world->joint_handles);
	for (k = 0; k < COUNT_OF(state_members); ++k)
		cni_snapshot_state(s, (uint8_t *)world + state_members[k].offset, state_members[k].bytes);
	cni_snapshot_blocks(s, &world->blocks);
	world->broadphase_ops->snapshot(world->broadphase, s);
	arrays_pass(world, s); /* last what changes its length in most steps, so that it moves little else: save/save_delta.c */
	events_pass(&world->events, s);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		world->joint_lanes.lanes = world->readback_kept = 0;
}

/* ---- what the bytes mean ---- */

static uint64_t mix(uint64_t hash, uint64_t number)
{
	return (hash ^ number) * 0x100000001B3u;
}

uint64_t cni_world_layout(void)
{
	const uint64_t sizes[] = { CNI_LANES, sizeof(cni_body), sizeof(cni_shape), sizeof(cni_proxy), sizeof(cni_contact), sizeof(cni_contact_block),
		sizeof(cni_block_info), sizeof(cni_block_anchor), sizeof(cni_block_extra), sizeof(cni_joint), sizeof(cni_island), sizeof(cni_motion),
		sizeof(cni_previous), sizeof(cni_area), sizeof(cni_sleep_lane), sizeof(cni_event), sizeof(cn_contact_event), sizeof(cn_world), sizeof(void *), CN_VERSION_MAJOR, CN_VERSION_MINOR,
		CN_VERSION_PATCH };
	uint64_t hash = 0xCBF29CE484222325u;
	int32_t k;
	for (k = 0; k < COUNT_OF(sizes); ++k)
		hash = mix(hash, sizes[k]);
	for (k = 0; k < COUNT_OF(state_members); ++k)
		hash = mix(hash, (uint64_t)state_members[k].offset << 32 | state_members[k].bytes);
	return hash;
}

/* The end of the member of a list that begins at or spans an offset; 0: there is none. */
static uint32_t member_end(const member *list, int32_t count, uint32_t offset)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		if (list[k].offset <= offset && offset < list[k].offset + list[k].bytes)
			return list[k].offset + list[k].bytes;
	return 0;
}

int32_t cni_world_unknown_offset(void)
{
	uint32_t offset = 0;
	while (offset < sizeof(cn_world)) {
		uint32_t end = member_end(state_members, COUNT_OF(state_members), offset) + member_end(passed_members, COUNT_OF(passed_members), offset) +
		               member_end(other_members, COUNT_OF(other_members), offset);
		if (end == 0)
			return (int32_t)offset;
		offset = end;
	}
	return -1;
}
