/*
 * test/base/tasks.h - small task systems, as a user might have one: run at once within enqueue, in reverse order of
 * the ranges, all in finish, or each range on a thread of its own. Included first of all.
 */
#ifndef CAIRN_TEST_BASE_TASKS_H
#define CAIRN_TEST_BASE_TASKS_H

#if !defined(_WIN32) && !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "cairn.h"

#ifndef _WIN32
#include <pthread.h>
#endif

enum { TASKS_AT_ONCE, TASKS_REVERSED, TASKS_IN_FINISH, TASKS_ON_THREADS, TASKS_KINDS };

typedef struct task_range {
	struct tasks *tasks;
	int32_t begin, end;
#ifndef _WIN32
	pthread_t thread;
#endif
	int32_t started;
} task_range;

typedef struct tasks {
	int32_t kind;
	int32_t enqueued, finished;
	int32_t wrong;       /* calls that break a promise of cairn.h */
	int32_t open;
	cn_task_fn *task;
	void *context;
	int32_t item_count;
	task_range ranges[CN_WORKERS_MAX];
} tasks;

static inline const char *tasks_name(int32_t kind)
{
	static const char *const names[TASKS_KINDS] = { "at once", "reversed", "in finish", "on threads" };
	return names[kind];
}

static inline void *task_range_run(void *context)
{
	const task_range *range = context;
	range->tasks->task(range->begin, range->end, range->tasks->context);
	return NULL;
}

/* Where there are no such threads the items run at once. */
static inline void task_range_start(task_range *range)
{
#ifndef _WIN32
	range->started = pthread_create(&range->thread, NULL, task_range_run, range) == 0;
#endif
	if (!range->started)
		task_range_run(range);
}

static inline void task_range_wait(task_range *range)
{
#ifndef _WIN32
	if (range->started)
		pthread_join(range->thread, NULL);
#endif
	range->started = 0;
}

static inline void *tasks_enqueue(cn_task_fn *task, void *context, int32_t item_count, int32_t min_range, void *user)
{
	tasks *t = user;
	int32_t k;
	++t->enqueued;
	t->wrong += t->open || item_count < 1 || item_count >= CN_WORKERS_MAX || min_range != 1;
	t->task = task;
	t->context = context;
	t->item_count = item_count;
	if (t->kind == TASKS_AT_ONCE) {
		task(0, item_count, context);
		return NULL;
	}
	t->open = 1;
	for (k = 0; k < item_count; ++k) {
		t->ranges[k].tasks = t;
		t->ranges[k].begin = k;
		t->ranges[k].end = k + 1;
		t->ranges[k].started = 0;
	}
	for (k = item_count - 1; k >= 0; --k) {
		if (t->kind == TASKS_REVERSED)
			task_range_run(&t->ranges[k]);
		else if (t->kind == TASKS_ON_THREADS)
			task_range_start(&t->ranges[k]);
	}
	return t;
}

static inline void tasks_finish(void *task, void *user)
{
	tasks *t = user;
	int32_t k;
	++t->finished;
	t->wrong += task != user || !t->open;
	for (k = 0; k < t->item_count; ++k) {
		if (t->kind == TASKS_IN_FINISH)
			task_range_run(&t->ranges[k]);
		else if (t->kind == TASKS_ON_THREADS)
			task_range_wait(&t->ranges[k]);
	}
	t->open = 0;
}

#endif
