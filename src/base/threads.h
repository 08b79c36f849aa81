/*
 * base/threads.h - a team of workers that share loops, and the few atomic words this takes.
 *
 * A loop over items that do not depend on each other is cut into contiguous chunks, and every worker has a run of
 * them that is its own, the same one in every loop of so many items: what it touched last time is in its cache. Who
 * has finished takes what is left of the others' runs, so a worker whose core is busy elsewhere delays nobody but for
 * the chunk it is in. Which worker runs which chunk is left to chance; a loop's results must not depend on it.
 *
 * A team has threads of its own, or borrows some of the user's task system for as long as cni_team_run or a single
 * loop lasts. Workers are numbered 0 (who leads) to cni_team_workers - 1, never two at once with one number.
 * A team of NULL is one worker, the calling thread; with CN_NO_THREADS there is no other.
 */
#ifndef CNI_BASE_THREADS_H
#define CNI_BASE_THREADS_H

#include "base/memory.h"

/* Are there teams at all? */
#if defined(CN_NO_THREADS) || !(defined(__GNUC__) || defined(_MSC_VER))
#define CNI_HAS_TEAMS 0
#else
#define CNI_HAS_TEAMS 1
#endif

/* Threads that the library starts itself, and that sleep when there is nothing to do. */
#if CNI_HAS_TEAMS && (defined(_WIN32) || defined(__unix__) || defined(__APPLE__)) && (!defined(__EMSCRIPTEN__) || defined(__EMSCRIPTEN_PTHREADS__))
#define CNI_HAS_THREADS 1
#else
#define CNI_HAS_THREADS 0
#endif

typedef struct cni_team cni_team;

/* Items begin to end - 1 of a loop, by the worker of that number. */
typedef void cni_range_fn(void *context, int32_t begin, int32_t end, int32_t worker);
typedef void cni_lead_fn(void *context);

/* 2 to CN_WORKERS_MAX workers, the calling thread one of them. enqueue and finish NULL: threads of its own. NULL: no
   memory, or no threads; nothing is left then. */
cni_team *cni_team_create(cni_memory *memory, int32_t workers, cn_enqueue_fn *enqueue, cn_finish_fn *finish, void *user);
/* Ends its threads. NULL is allowed. No loop may run. */
void cni_team_destroy(cni_team *team, cni_memory *memory);
int32_t cni_team_workers(const cni_team *team);
/* Can this library give a world so many workers? */
static inline int32_t cni_team_possible(int32_t workers, cn_enqueue_fn *enqueue)
{
	return workers > 1 && CNI_HAS_TEAMS && (CNI_HAS_THREADS || enqueue != NULL);
}
/* How much memory a team takes; its threads' stacks are the system's. */
uint64_t cni_team_bytes(int32_t workers);

/* Calls fn for ranges that cover 0 to item_count - 1, each item once, none shorter than min_range but where item_count
   is. Returns when all are done. A loop of less than two such ranges is one call in this thread. Not from within fn. */
void cni_team_for(cni_team *team, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context);
/* Calls lead once, with the team awake and waiting for the loops in it. With the user's task system lead may run in
   one of its threads. */
void cni_team_run(cni_team *team, cni_lead_fn *lead, void *context);

/* on 1: the team's own threads wake, and watch for loops without sleeping until it is 0 again, or nothing has come for some
   milliseconds: for when a thread does other things between loops that take less time than to wake somebody. A team of the user's
   task system is not held. */
void cni_team_hold(cni_team *team, int32_t on);

/* ---- atomic words: loads acquire, stores release, the rest does both ---- */

/* For a build that helgrind looks at, which takes atomic words for races and does not see what they order. Elsewhere nothing. */
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
	uint32_t value;
	CNI_WORD_IS_SHARED(word);
	value = __atomic_load_n(word, __ATOMIC_ACQUIRE);
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
	uint32_t was;
	CNI_WORD_SENDS(word);
	was = __atomic_exchange_n(word, value, __ATOMIC_ACQ_REL);
	CNI_WORD_RECEIVES(word);
	return was;
}
/* Returns what it was before. */
static inline uint32_t cni_atomic_add(uint32_t *word, uint32_t value)
{
	uint32_t was;
	CNI_WORD_SENDS(word);
	was = __atomic_fetch_add(word, value, __ATOMIC_ACQ_REL);
	CNI_WORD_RECEIVES(word);
	return was;
}
/* If it is *expected it becomes value: 1. Else *expected becomes what it is: 0. */
static inline int32_t cni_atomic_replace(uint32_t *word, uint32_t *expected, uint32_t value)
{
	int32_t done;
	CNI_WORD_SENDS(word);
	done = __atomic_compare_exchange_n(word, expected, value, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);
	CNI_WORD_RECEIVES(word);
	return done;
}
/* Of a word that several workers may set to the same value: cost what plain ones do, and say nothing of other memory. */
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
