/*
 * test/arch/digest.h - the number of a scene: the FNV-1a digest of 32-bit words, which are the same whatever the byte order (state
 * hashes, floats as bits, counts), and the first call that failed. Needs cairn.h only.
 */
#ifndef CAIRN_TEST_ARCH_DIGEST_H
#define CAIRN_TEST_ARCH_DIGEST_H

#include "cairn.h"

#include <string.h>

/* Definitions of worlds come from the program: it chooses the memory. */
static void arch_world_def(cn_world_def *def);

static int32_t arch_failed_line;     /* of the first call that failed; 0: none */
static const char *arch_failed_file;

#define MUST(call) arch_must(call, __FILE__, __LINE__)
static void arch_must(cn_result result, const char *file, int32_t line)
{
	if (result == CN_OK || arch_failed_line != 0)
		return;
	arch_failed_file = file;
	arch_failed_line = line;
}

static uint64_t arch_digest;

/* What must occur in some scene, else the numbers say less than they promise: tiers, contact events, then the rest. */
enum {
	SEEN_TIER = 0,
	SEEN_EVENT = 3,
	SEEN_SENSOR = 9,
	SEEN_BROKEN,
	SEEN_YIELDED,
	SEEN_ASLEEP,
	SEEN_REFUSED,
	SEEN_COUNT
};
#define ARCH_SEEN_ALL ((1u << SEEN_COUNT) - 1u)
static uint32_t arch_seen;

static void see(int32_t what) { arch_seen |= 1u << what; }

static void mix(uint32_t word)
{
	int32_t byte;
	for (byte = 0; byte < 4; ++byte)
		arch_digest = (arch_digest ^ (word >> 8 * byte & 0xFFu)) * 0x100000001B3u;
}

static void mix_float(float x)
{
	uint32_t bits;
	memcpy(&bits, &x, sizeof bits);
	mix(bits);
}

static void mix_vec2(cn_vec2 v)
{
	mix_float(v.x);
	mix_float(v.y);
}

static void mix_world(const cn_world *world)
{
	uint64_t hash = 0;
	MUST(cn_world_hash(world, &hash));
	mix((uint32_t)hash);
	mix((uint32_t)(hash >> 32));
}

#endif
