/*
 * save/save.c - saving a world into the caller's memory and restoring it: a header that says what the bytes are, then the state.
 *
 * A restore looks at all of the header first, then makes room (which may fail), and only then changes the world.
 *
 * Scratch of a step is not state, nor is what would be found again as it is: the lists of events that users see are built from
 * the logs; lanes of joints and plans of direct solving that are kept from the last step give the bits of new ones
 * (joints/joint_blocks.c, linear/sparse_plan.c), each compared with what it depends on before it is used. Memory, workers, callbacks, and the sentence of the
 * last error stay the world's own.
 */
#include "base/snapshot.h"
#include "save/file.h"
#include "world/error.h"

#include <stddef.h>
#include <string.h>

#define MAGIC 0x53414343u /* "CCAS" */

/* ---- what the state is: numbers and arrays by the lists of save/file_fields.c, tables below ---- */

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
	int32_t used = cni_file_extra_count(world);
	uint64_t bytes = s->bytes + sizeof(int32_t);
	if (s->mode == CNI_SNAPSHOT_LOAD && used == 0 && cni_table_capacity(&world->blocks_extra) > 0)
		for (int32_t k = 0; k < world->block_used; ++k)
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
	for (int32_t k = 0; (array = cni_file_array(world, k)) != NULL; ++k)
		cni_snapshot_array(s, array);
	if (s->mode == CNI_SNAPSHOT_LOAD)
		cni_events_forget_built(&world->events);
}

/* SAVE and MEASURE change nothing. */
static void state_pass(cn_world *world, cni_snapshot *s)
{
	const cni_record *members = cni_file_kind(0);
	rooms_pass(world, s);
	tables_pass(world, s);
	handles_pass(s, &world->body_handles);
	handles_pass(s, &world->shape_handles);
	handles_pass(s, &world->joint_handles);
	for (int32_t k = 0; k < members->count; ++k)
		if (members->fields[k].kind != CNI_FIELD_DERIVED)
			cni_snapshot_state(s, (uint8_t *)world + members->fields[k].offset, members->fields[k].count * CNI_FIELD_BYTES(members->fields[k].kind));
	cni_snapshot_blocks(s, &world->blocks);
	world->broadphase_ops->snapshot(world->broadphase, s);
	arrays_pass(world, s); /* last what changes its length in most steps, so that it moves little else: save/save_delta.c */
	if (s->mode == CNI_SNAPSHOT_LOAD)
		world->joint_lanes.lanes = world->readback_kept = 0;
}

/* Changes with what the bytes mean: sizes and places of records, version, order of bytes. */
static uint64_t state_layout(void)
{
	const uint64_t sizes[] = { CNI_LANES, sizeof(cni_body), sizeof(cni_shape), sizeof(cni_proxy), sizeof(cni_contact), sizeof(cni_contact_block),
		sizeof(cni_block_info), sizeof(cni_block_anchor), sizeof(cni_block_extra), sizeof(cni_joint), sizeof(cni_island), sizeof(cni_motion),
		sizeof(cni_previous), sizeof(cni_area), sizeof(cni_sleep_lane), sizeof(cni_event), sizeof(cn_contact_event), sizeof(cn_world), sizeof(void *), CN_VERSION_MAJOR, CN_VERSION_MINOR,
		CN_VERSION_PATCH };
	const cni_record *members = cni_file_kind(0);
	uint64_t hash = 0xCBF29CE484222325u;
	for (uint32_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k)
		hash = (hash ^ sizes[k]) * 0x100000001B3u;
	for (uint32_t k = 0; k < (uint32_t)members->count; ++k)
		hash = (hash ^ ((uint64_t)members->fields[k].offset << 32 | members->fields[k].kind)) * 0x100000001B3u;
	return hash;
}

/* ---- saving ---- */

typedef struct header {
	uint32_t magic;
	int32_t broadphase;
	int32_t fixed;         /* vertex capacity of a world in a caller's block, whose pieces have other sizes; 0: others */
	float length_unit;
	uint64_t layout;
	uint64_t bytes;        /* this header included */
	uint64_t checksum;     /* of what follows */
} header;

static inline uint64_t mixed(uint64_t sum, uint64_t word)
{
	return (sum << 23 | sum >> 41) + word;
}

/* Sums that are turned before each word is added, in four lanes that the processor adds at once. A single change always shows: each
   step can be undone. */
uint64_t cni_save_checksum(const void *from, uint64_t count)
{
	const uint8_t *bytes = (const uint8_t *)from;
	uint64_t sum[4] = { 1, 2, 3, 4 }, word[4], k;
	for (k = 0; k + sizeof word <= count; k += sizeof word) {
		memcpy(word, bytes + k, sizeof word);
		sum[0] = mixed(sum[0], word[0]);
		sum[1] = mixed(sum[1], word[1]);
		sum[2] = mixed(sum[2], word[2]);
		sum[3] = mixed(sum[3], word[3]);
	}
	for (; k < count; ++k)
		sum[0] = mixed(sum[0], bytes[k]);
	for (int32_t l = 1; l < 4; ++l)
		sum[0] = mixed(sum[0] * 0x9E3779B97F4A7C15u, sum[l]);
	return sum[0];
}

static header header_of(const cn_world *world, uint64_t bytes)
{
	const header h = { MAGIC, world->settings.broadphase, world->vertex_capacity, world->settings.length_unit, state_layout(), bytes, 0 };
	return h;
}

cn_result cn_world_save_size(const cn_world *world, uint64_t *out_bytes)
{
	cni_call call = cni_enter_const(world);
	cni_snapshot s = cni_snapshot_begin(CNI_SNAPSHOT_MEASURE, NULL, NULL);
	cni_check_pointer(&call, "out_bytes", out_bytes);
	cni_check_boundary(&call, world);
	if (call.result != CN_OK)
		return call.result;
	state_pass((cn_world *)world, &s); /* which changes nothing */
	*out_bytes = sizeof(header) + s.bytes;
	return CN_OK;
}

cn_result cn_world_save(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes)
{
	uint64_t bytes;
	cn_result sized = out != NULL ? cn_world_save_size(world, &bytes) : CN_ERROR_ARGUMENT;
	if (sized != CN_OK || capacity < bytes)
		return sized != CN_OK ? sized : CN_ERROR_CAPACITY;
	header h = header_of(world, bytes);
	cni_snapshot s = cni_snapshot_begin(CNI_SNAPSHOT_SAVE, (uint8_t *)out + sizeof h, NULL);
	state_pass((cn_world *)world, &s);
	h.checksum = cni_save_checksum((const uint8_t *)out + sizeof h, s.bytes);
	memcpy(out, &h, sizeof h);
	if (out_bytes != NULL)
		*out_bytes = h.bytes;
	return CN_OK;
}

int32_t cni_save_is_one(const void *save, uint64_t bytes)
{
	header h;
	if (bytes < sizeof h)
		return 0;
	memcpy(&h, save, sizeof h);
	return h.magic == MAGIC && h.layout == state_layout() && h.bytes == bytes;
}

/* ---- restoring ---- */

/* Is this a whole save, of such a world? */
static void check_save(cni_call *call, const cn_world *world, const uint8_t *bytes, uint64_t count)
{
	header own, h;
	if (call->result != CN_OK)
		return;
	own = header_of(world, 0);
	memset(&h, 0, sizeof h);
	if (count >= sizeof h)
		memcpy(&h, bytes, sizeof h);
	cni_check(call, h.magic == own.magic, CN_ERROR_FORMAT, "save; these bytes are none of cn_world_save");
	cni_check(call, h.layout == own.layout, CN_ERROR_FORMAT, "save; must be of this version of the library, and of this kind of machine");
	cni_check(call, h.bytes == count, CN_ERROR_FORMAT, "bytes; must be as many as cn_world_save has written");
	cni_check(call, h.broadphase == own.broadphase && h.fixed == own.fixed && h.length_unit == own.length_unit, CN_ERROR_STATE,
	          "save; must be of a world with the same broadphase and length unit, and in a caller's block if this one is");
	if (call->result == CN_OK && h.checksum != cni_save_checksum(bytes + sizeof h, count - sizeof h))
		cni_refuse(call, CN_ERROR_FORMAT, "save; its bytes have been changed");
}

/* The state in these bytes. They are only read. */
static cni_snapshot bytes_pass(cn_world *world, int32_t mode, const uint8_t *bytes)
{
	cni_snapshot s = cni_snapshot_begin(mode, (uint8_t *)bytes + sizeof(header), &world->memory);
	state_pass(world, &s);
	return s;
}

cn_result cn_world_restore(cn_world *world, const void *save, uint64_t bytes)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "save", save);
	check_save(&call, world, (const uint8_t *)save, bytes);
	if (call.result != CN_OK)
		return call.result;
	if (bytes_pass(world, CNI_SNAPSHOT_RESERVE, (const uint8_t *)save).failed) {
		(void)bytes_pass(world, CNI_SNAPSHOT_ABANDON, (const uint8_t *)save);
		return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the saved state");
	}
	(void)bytes_pass(world, CNI_SNAPSHOT_LOAD, (const uint8_t *)save);
	return CN_OK;
}
