/*
 * save/save_state.c - what the state of a world is: numbers and arrays by the lists of save/file_fields.c, tables below.
 *
 * Scratch of a step is not state, nor is what would be found again as it is: the lists of events that users see are built from
 * the logs; lanes of joints and plans of direct solving that are kept from the last step give the bits of new ones
 * (joints/joint_blocks.c, linear/sparse_plan.c), each compared with what it depends on before it is used. Memory, workers, callbacks, and the sentence of the
 * last error stay the world's own.
 */
#include "save/file.h"
#include "save/save.h"

#include <stddef.h>
#include <string.h>

/* ---- parts ---- */

/* Room that is made before records and events need it, so that what they do cannot fail: as when they were made. */
static void rooms_pass(cn_world *world, cni_snapshot *s)
{
	int32_t movable = cni_snapshot_number(s, world->movable_count), contacts = cni_snapshot_number(s, world->contact_count);
	int32_t lanes = cni_snapshot_number(s, world->touching_count), islands = cni_snapshot_number(s, world->island_count);
	int32_t joints = cni_snapshot_number(s, world->joint_handles.count), reporting = cni_snapshot_number(s, world->contacts_reporting);
	int32_t extra = cni_snapshot_number(s, cni_table_capacity(&world->blocks_extra) > 0 && cni_file_needs_extra(world));
	if (!cni_snapshot_reserves(s))
		return;
	cni_snapshot_need(s, cni_body_reserve(world, movable - world->movable_count) == CN_OK && cni_lane_reserve(world, lanes) &&
	                             (!extra || cni_lane_reserve_extra(world)) &&
	                             cni_contact_reserve(world, contacts - world->contact_count) == CN_OK &&
	                             (!world->memory.fixed || cni_contact_reserve_reports(world, reporting)) &&
	                             cni_island_reserve(world, islands - world->island_count) &&
	                             cni_joint_reserve(world, joints - world->joint_handles.count) == CN_OK);
}

/* Where no contact needs extra rows, they are all zero. */
static void extra_pass(cn_world *world, cni_snapshot *s)
{
	int32_t used = cni_file_extra_count(world), k;
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
	cni_snapshot_members(s, handles, offsetof(cni_handles, count), sizeof *handles);
}

/* Of events the logs; what was built from them is void. */
static void arrays_pass(cn_world *world, cni_snapshot *s)
{
	cni_array *array;
	int32_t k;
	for (k = 0; (array = cni_file_array(world, k)) != NULL; ++k)
		cni_snapshot_array(s, array);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		cni_events_forget_built(&world->events);
}

void cni_world_snapshot(cn_world *world, cni_snapshot *s)
{
	const cni_record *members = cni_file_kind(0);
	int32_t k;
	rooms_pass(world, s);
	tables_pass(world, s);
	handles_pass(s, &world->body_handles);
	handles_pass(s, &world->shape_handles);
	handles_pass(s, &world->joint_handles);
	for (k = 0; k < members->count; ++k)
		if (members->fields[k].kind != CNI_FIELD_DERIVED)
			cni_snapshot_state(s, (uint8_t *)world + members->fields[k].offset, members->fields[k].count * CNI_FIELD_BYTES(members->fields[k].kind));
	cni_snapshot_blocks(s, &world->blocks);
	world->broadphase_ops->snapshot(world->broadphase, s);
	arrays_pass(world, s); /* last what changes its length in most steps, so that it moves little else: save/save_delta.c */
	if (s->mode == CNI_SNAPSHOT_LOAD)
		world->joint_lanes.lanes = world->readback_kept = 0;
}

/* ---- what the bytes mean ---- */

uint64_t cni_world_layout(void)
{
	const uint64_t sizes[] = { CNI_LANES, sizeof(cni_body), sizeof(cni_shape), sizeof(cni_proxy), sizeof(cni_contact), sizeof(cni_contact_block),
		sizeof(cni_block_info), sizeof(cni_block_anchor), sizeof(cni_block_extra), sizeof(cni_joint), sizeof(cni_island), sizeof(cni_motion),
		sizeof(cni_previous), sizeof(cni_area), sizeof(cni_sleep_lane), sizeof(cni_event), sizeof(cn_contact_event), sizeof(cn_world), sizeof(void *), CN_VERSION_MAJOR, CN_VERSION_MINOR,
		CN_VERSION_PATCH };
	const cni_record *members = cni_file_kind(0);
	uint64_t hash = 0xCBF29CE484222325u;
	uint32_t k;
	for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k)
		hash = (hash ^ sizes[k]) * 0x100000001B3u;
	for (k = 0; k < (uint32_t)members->count; ++k)
		hash = (hash ^ ((uint64_t)members->fields[k].offset << 32 | members->fields[k].kind)) * 0x100000001B3u;
	return hash;
}
