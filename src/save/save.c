/*
 * save/save.c - saving a world into the caller's memory and restoring it: a header that says what the bytes are, then the state
 * (save/save_state.c).
 *
 * A restore looks at all of the header first, then makes room (which may fail), and only then changes the world.
 */
#include "world/error.h"
#include "save/save.h"

#include <string.h>

#define MAGIC 0x53414343u /* "CCAS" */

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
	int32_t l;
	for (k = 0; k + sizeof word <= count; k += sizeof word) {
		memcpy(word, bytes + k, sizeof word);
		sum[0] = mixed(sum[0], word[0]);
		sum[1] = mixed(sum[1], word[1]);
		sum[2] = mixed(sum[2], word[2]);
		sum[3] = mixed(sum[3], word[3]);
	}
	for (; k < count; ++k)
		sum[0] = mixed(sum[0], bytes[k]);
	for (l = 1; l < 4; ++l)
		sum[0] = mixed(sum[0] * 0x9E3779B97F4A7C15u, sum[l]);
	return sum[0];
}

static header header_of(const cn_world *world, uint64_t bytes)
{
	const header h = { MAGIC, world->settings.broadphase, world->vertex_capacity, world->settings.length_unit, cni_world_layout(), bytes, 0 };
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
	cni_world_snapshot((cn_world *)world, &s); /* which changes nothing */
	*out_bytes = sizeof(header) + s.bytes;
	return CN_OK;
}

cn_result cn_world_save(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes)
{
	cni_snapshot s;
	header h;
	uint64_t bytes;
	cn_result sized = out != NULL ? cn_world_save_size(world, &bytes) : CN_ERROR_ARGUMENT;
	if (sized != CN_OK || capacity < bytes)
		return sized != CN_OK ? sized : CN_ERROR_CAPACITY;
	h = header_of(world, bytes);
	s = cni_snapshot_begin(CNI_SNAPSHOT_SAVE, (uint8_t *)out + sizeof h, NULL);
	cni_world_snapshot((cn_world *)world, &s);
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
	return h.magic == MAGIC && h.layout == cni_world_layout() && h.bytes == bytes;
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
static cni_snapshot state_pass(cn_world *world, int32_t mode, const uint8_t *bytes)
{
	cni_snapshot s = cni_snapshot_begin(mode, (uint8_t *)bytes + sizeof(header), &world->memory);
	cni_world_snapshot(world, &s);
	return s;
}

cn_result cn_world_restore(cn_world *world, const void *save, uint64_t bytes)
{
	cni_call call = cni_enter(world, __func__);
	cni_check_pointer(&call, "save", save);
	check_save(&call, world, (const uint8_t *)save, bytes);
	if (call.result != CN_OK)
		return call.result;
	if (state_pass(world, CNI_SNAPSHOT_RESERVE, (const uint8_t *)save).failed) {
		(void)state_pass(world, CNI_SNAPSHOT_ABANDON, (const uint8_t *)save);
		return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the saved state");
	}
	(void)state_pass(world, CNI_SNAPSHOT_LOAD, (const uint8_t *)save);
	return CN_OK;
}
