/*
 * test/base/hooks.h - memory hooks for tests: count what is out, check the sizes that come back, fill
 * fresh memory with garbage, and fail at a chosen call or for good after it.
 */
#ifndef CAIRN_TEST_BASE_HOOKS_H
#define CAIRN_TEST_BASE_HOOKS_H

#include "base/memory.h"

#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

typedef struct hooks {
	int64_t calls;
	int64_t fail_at;     /* this call fails (counted from 1), 0: none */
	int32_t fail_after;  /* 1: all later ones too */
	int32_t wrong_frees; /* a free with another size than was asked for, or a wrong alignment asked */
	int64_t pieces;
	uint64_t bytes;
} hooks;

static inline void *hooks_alloc(uint64_t bytes, uint32_t align, void *user)
{
	hooks *h = user;
	uint8_t *raw, *aligned;

	h->calls += 1;
	if (align != 64)
		h->wrong_frees += 1;
	if (h->fail_at != 0 && (h->calls == h->fail_at || (h->fail_after && h->calls > h->fail_at)))
		return NULL;
	raw = malloc((size_t)bytes + 192);
	if (raw == NULL)
		abort();
	aligned = raw + 128 - (uintptr_t)raw % 64;
	memcpy(aligned - 8 - sizeof raw, &raw, sizeof raw);
	memcpy(aligned - 8, &bytes, 8);
	memset(aligned, 0xA5, (size_t)bytes);
	h->pieces += 1;
	h->bytes += bytes;
	return aligned;
}

static inline void hooks_free(void *memory, uint64_t bytes, void *user)
{
	hooks *h = user;
	uint8_t *aligned = memory, *raw;
	uint64_t asked;

	memcpy(&raw, aligned - 8 - sizeof raw, sizeof raw);
	memcpy(&asked, aligned - 8, 8);
	if (asked != bytes)
		h->wrong_frees += 1;
	h->pieces -= 1;
	h->bytes -= bytes;
	free(raw);
}

static inline void hooks_init(hooks *h, cni_memory *memory)
{
	memset(h, 0, sizeof *h);
	cni_memory_init_hooks(memory, hooks_alloc, hooks_free, h);
}

/* xorshift (Marsaglia, 2003). */
static inline uint32_t random_next(uint32_t *state)
{
	uint32_t x = *state;

	x ^= x << 13;
	x ^= x >> 17;
	x ^= x << 5;
	return *state = x;
}

#ifdef CNI_DEBUG
/* Debug builds trip an assert where release builds refuse: TRIPS is 1 when the expression aborts. */
static jmp_buf trip_point;
static inline void trip_caught(int signal_number)
{
	(void)signal_number;
	longjmp(trip_point, 1);
}
#define TRIPS(expression) \
	(signal(SIGABRT, trip_caught), setjmp(trip_point) ? 1 : ((void)(expression), 0))
#endif

#endif
