/*
 * test/world/workers.h - what tests of worlds with several workers share: how many workers, task systems for a definition,
 * digests of what was seen, and a watch on the thread in which the user is asked. Included first of all.
 */
#ifndef CAIRN_TEST_WORLD_WORKERS_H
#define CAIRN_TEST_WORLD_WORKERS_H

#include "base/tasks.h"

#include "fixture.h"

static const int32_t worker_counts[] = { 2, 3, 8 };
#define WORKER_COUNTS ((int32_t)(sizeof worker_counts / sizeof *worker_counts))

static inline void use_tasks(cn_world_def *def, tasks *system, int32_t kind)
{
	memset(system, 0, sizeof *system);
	system->kind = kind;
	def->enqueue = tasks_enqueue;
	def->finish = tasks_finish;
	def->task_user = system;
}

/* FNV-1a. */
static inline uint64_t digest_bytes(uint64_t digest, const void *bytes, size_t count)
{
	const unsigned char *p = bytes;
	size_t k;
	for (k = 0; k < count; ++k)
		digest = (digest ^ p[k]) * 0x100000001B3u;
	return digest;
}

static inline uint64_t digest_world(uint64_t digest, cn_world *world)
{
	uint64_t hash = fixture_hash(world);
	return digest_bytes(digest, &hash, sizeof hash);
}

/* The thread in which the user is to be asked, and how often it was another. */
typedef struct own_thread {
	int32_t elsewhere;
#ifndef _WIN32
	pthread_t caller;
#endif
} own_thread;

static inline void own_thread_begin(own_thread *t)
{
	memset(t, 0, sizeof *t);
#ifndef _WIN32
	t->caller = pthread_self();
#endif
}

static inline void own_thread_check(own_thread *t)
{
#ifndef _WIN32
	t->elsewhere += !pthread_equal(t->caller, pthread_self());
#else
	(void)t;
#endif
}

#endif
