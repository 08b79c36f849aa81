/*
 * base/threads.h - a team of workers that share loops, and the atomic words that it needs.
 *
 * A loop over independent items is split into contiguous chunks. Every worker owns a run of consecutive chunks, the same run
 * in every loop of as many items, so that its items are in its cache. A worker that has finished its run takes chunks from
 * other runs, so a worker whose core is busy elsewhere delays the loop only by its present chunk. The assignment of chunks
 * to workers depends on timing; a loop's results must not depend on it.
 *
 * A team has its own threads, or borrows threads of the user's task system for the duration of cni_team_run or a single
 * loop.
 * A team of NULL is one worker, the calling thread; with CN_NO_THREADS all teams are NULL.
 */
#ifndef CNI_BASE_THREADS_H
#define CNI_BASE_THREADS_H

#include "base/memory.h"

/* 1 when this build has teams. */
#if defined(CN_NO_THREADS) || !(defined(__GNUC__) || defined(_MSC_VER))
#define CNI_HAS_TEAMS 0
#else
#define CNI_HAS_TEAMS 1
#endif

/* 1 when the library can start its own threads; these sleep when there is no work. */
#if CNI_HAS_TEAMS && (defined(_WIN32) || defined(__unix__) || defined(__APPLE__)) && (!defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__))
#define CNI_HAS_THREADS 1
#else
#define CNI_HAS_THREADS 0
#endif

typedef struct cni_team cni_team;

/* Runs items begin to end - 1 of a loop. */
typedef void cni_range_fn(void *context, int32_t begin, int32_t end);
typedef void cni_lead_fn(void *context);

/* 2 to CN_WORKERS_MAX workers including the calling thread. enqueue and finish NULL: the team starts its own threads.
   Returns NULL, with everything released, when there is no memory or no thread. */
cni_team *cni_team_create(cni_memory *memory, int32_t workers, cn_enqueue_fn *enqueue, cn_finish_fn *finish, void *user);
/* Ends the team's threads. NULL is allowed. No loop may run. */
void cni_team_destroy(cni_team *team, cni_memory *memory);
int32_t cni_team_workers(const cni_team *team);
/* 1 when this build can give a world this number of workers. */
static inline int32_t cni_team_possible(int32_t workers, cn_enqueue_fn *enqueue)
{
	return workers > 1 && CNI_HAS_TEAMS && (CNI_HAS_THREADS || enqueue != NULL);
}
/* Bytes of a team, without its threads' stacks, which the system allocates. */
uint64_t cni_team_bytes(int32_t workers);

#if CNI_HAS_TEAMS
/* Calls fn for ranges that cover 0 to item_count - 1, each item once, none shorter than min_range unless item_count is.
   Returns when all are done. A loop of less than two such ranges is one call in this thread. Must not be called by fn. */
void cni_team_for(cni_team *team, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context);
/* Calls lead once, with the team awake and waiting for lead's loops. With the user's task system, lead may run in one of the
   system's threads. */
void cni_team_run(cni_team *team, cni_lead_fn *lead, void *context);

/* on 1: wakes the team's own threads, which then wait for loops without sleeping, until on 0 or some milliseconds without a
   loop. For serial work between loops that takes less time than waking a thread. No effect on a team of the user's task
   system. */
void cni_team_hold(cni_team *team, int32_t on);
#else /* inlined, so that a loop is a plain call */
static inline void cni_team_for(cni_team *team, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context)
{
	(void)team, (void)min_range;
	if (item_count > 0)
		fn(context, 0, item_count);
}
static inline void cni_team_run(cni_team *team, cni_lead_fn *lead, void *context)
{
	(void)team;
	lead(context);
}
static inline void cni_team_hold(cni_team *team, int32_t on) { (void)team, (void)on; }
#endif

/* ---- atomic words: loads acquire, stores release, the others do both ---- */

/* Annotations for helgrind, which reports atomic words as races and does not see the order they establish. Empty in other
   builds. */
#if defined(CNI_HELGRIND)
#include <valgrind/helgrind.h>
#define CNI_WORD_IS_SHARED(word) VALGRIND_HG_DISABLE_CHECKING(word, sizeof *(word))
#define CNI_WORD_SENDS(word) do { CNI_WORD_IS_SHARED(word); ANNOTATE_HAPPENS_BEFORE(word); } while (0)
#define CNI_WORD_RECEIVES(word) ANNOTATE_HAPPENS_AFTER(word)
#else
#define CNI_WORD_SENDS(word) ((void)(word))
#define CNI_WORD_RECEIVES(word) ((void)(word))
#define CNI_WORD_IS_SHARED(word) ((void)(word))
#endif

#if CNI_HAS_TEAMS && defined(__GNUC__)
static inline uint32_t cni_atomic_load(const uint32_t *word)
{
	CNI_WORD_IS_SHARED(word);
	uint32_t value = __atomic_load_n(word, __ATOMIC_ACQUIRE);
	CNI_WORD_RECEIVES(word);
	return value;
}
static inline void cni_atomic_store(uint32_t *word, uint32_t value)
{
	CNI_WORD_SENDS(word);
	__atomic_store_n(word, value, __ATOMIC_RELEASE);
}
static inline uint32_t cni_atomic_exchange(uint32_t *word, uint32_t value)
{
	CNI_WORD_SENDS(word);
	uint32_t was = __atomic_exchange_n(word, value, __ATOMIC_ACQ_REL);
	CNI_WORD_RECEIVES(word);
	return was;
}
/* Returns the previous value. */
static inline uint32_t cni_atomic_add(uint32_t *word, uint32_t value)
{
	CNI_WORD_SENDS(word);
	uint32_t was = __atomic_fetch_add(word, value, __ATOMIC_ACQ_REL);
	CNI_WORD_RECEIVES(word);
	return was;
}
/* Compare and exchange: if the word equals *expected, writes value and returns 1, else writes the word to *expected and
   returns 0. */
static inline int32_t cni_atomic_replace(uint32_t *word, uint32_t *expected, uint32_t value)
{
	CNI_WORD_SENDS(word);
	int32_t done = __atomic_compare_exchange_n(word, expected, value, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);
	CNI_WORD_RECEIVES(word);
	return done;
}
/* Relaxed load and store, for a word that several workers may set to the same value: as cheap as plain ones, without any
   order with other memory. */
static inline uint32_t cni_atomic_peek(const uint32_t *word)
{
	CNI_WORD_IS_SHARED(word);
	return __atomic_load_n(word, __ATOMIC_RELAXED);
}
static inline void cni_atomic_put(uint32_t *word, uint32_t value)
{
	CNI_WORD_IS_SHARED(word);
	__atomic_store_n(word, value, __ATOMIC_RELAXED);
}
#elif CNI_HAS_TEAMS
#include <intrin.h>
static inline uint32_t cni_atomic_peek(const uint32_t *word) { return *(const volatile uint32_t *)word; }
static inline void cni_atomic_put(uint32_t *word, uint32_t value) { *(volatile uint32_t *)word = value; }
static inline uint32_t cni_atomic_load(const uint32_t *word) { return (uint32_t)_InterlockedOr((volatile long *)word, 0); }
static inline void cni_atomic_store(uint32_t *word, uint32_t value) { (void)_InterlockedExchange((volatile long *)word, (long)value); }
static inline uint32_t cni_atomic_exchange(uint32_t *word, uint32_t value) { return (uint32_t)_InterlockedExchange((volatile long *)word, (long)value); }
static inline uint32_t cni_atomic_add(uint32_t *word, uint32_t value) { return (uint32_t)_InterlockedExchangeAdd((volatile long *)word, (long)value); }
static inline int32_t cni_atomic_replace(uint32_t *word, uint32_t *expected, uint32_t value)
{
	uint32_t was = (uint32_t)_InterlockedCompareExchange((volatile long *)word, (long)value, (long)*expected), wanted = *expected;
	*expected = was;
	return was == wanted;
}
#else
static inline uint32_t cni_atomic_add(uint32_t *word, uint32_t value)
{
	uint32_t was = *word;
	*word += value;
	return was;
}
static inline uint32_t cni_atomic_peek(const uint32_t *word) { return *word; }
static inline void cni_atomic_put(uint32_t *word, uint32_t value) { *word = value; }
#endif

#endif
