/* examples/task_system.c - a step on the program's own threads. A pool runs parts of the library's tasks; the result has the same bits as
   on one thread. Most programs need none of this: cn_world_def.worker_count alone makes the world start its own threads. */
#include "cairn.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#define THREADS 3 /* beside the one that steps */

/* One task at a time, which is all that a world asks for: ranges of it are taken in turn. */
typedef struct pool {
	pthread_t threads[THREADS];
	pthread_mutex_t lock;
	pthread_cond_t work, done;
	cn_task_fn *task;
	void *context;
	int32_t next, count, range, running, taken;
	int stop;
} pool;

/* Takes one range and runs it. Called and returns with the lock held; 0 when there is none left. */
static int run_range(pool *p)
{
	if (p->task == NULL || p->next >= p->count)
		return 0;
	cn_task_fn *task = p->task;
	void *context = p->context;
	const int32_t begin = p->next, end = begin + p->range < p->count ? begin + p->range : p->count;
	p->next = end;
	++p->running;
	++p->taken;
	pthread_mutex_unlock(&p->lock);
	task(begin, end, context);
	pthread_mutex_lock(&p->lock);
	if (--p->running == 0 && p->next >= p->count)
		pthread_cond_broadcast(&p->done);
	return 1;
}

static void *thread_main(void *user)
{
	pool *p = (pool *)user;
	pthread_mutex_lock(&p->lock);
	while (!p->stop) {
		if (!run_range(p))
			pthread_cond_wait(&p->work, &p->lock);
	}
	pthread_mutex_unlock(&p->lock);
	return NULL;
}

static void *enqueue(cn_task_fn *task, void *context, int32_t item_count, int32_t min_range, void *user)
{
	pool *p = (pool *)user;
	pthread_mutex_lock(&p->lock);
	p->task = task;
	p->context = context;
	p->next = 0;
	p->count = item_count;
	p->range = min_range > 0 ? min_range : 1;
	pthread_cond_broadcast(&p->work);
	pthread_mutex_unlock(&p->lock);
	return p;
}

/* Helps, then waits for what others run. */
static void finish(void *task, void *user)
{
	pool *p = (pool *)user;
	(void)task;
	pthread_mutex_lock(&p->lock);
	while (run_range(p))
		continue;
	while (p->running > 0)
		pthread_cond_wait(&p->done, &p->lock);
	p->task = NULL;
	pthread_mutex_unlock(&p->lock);
}

static int pool_start(pool *p)
{
	int started = 1;
	pthread_mutex_init(&p->lock, NULL);
	pthread_cond_init(&p->work, NULL);
	pthread_cond_init(&p->done, NULL);
	for (int i = 0; i < THREADS; ++i)
		started = started && pthread_create(&p->threads[i], NULL, thread_main, p) == 0;
	return started;
}

static void pool_stop(pool *p)
{
	pthread_mutex_lock(&p->lock);
	p->stop = 1;
	pthread_cond_broadcast(&p->work);
	pthread_mutex_unlock(&p->lock);
	for (int i = 0; i < THREADS; ++i)
		pthread_join(p->threads[i], NULL);
}

/* The hash of a heap of 900 boxes after some steps; p NULL: on one thread. */
static uint64_t run(pool *p)
{
	cn_world_def def;
	cn_world *world;
	cn_body_def body_def;
	cn_shape_def shape_def;
	uint64_t hash = 0;
	cn_world_def_init(&def);
	if (p != NULL) {
		def.worker_count = THREADS + 1;
		def.enqueue = enqueue;
		def.finish = finish;
		def.task_user = p;
	}
	if (cn_world_create(&def, &world) != CN_OK)
		return 0;
	cn_body_def_init(&body_def);
	cn_shape_def_init(&shape_def);
	for (int i = 0; i <= 900; ++i) {
		body_def.type = i == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
		body_def.position_m = i == 0 ? (cn_vec2){ 0.0f, -1.0f } : (cn_vec2){ (float)(i % 30) - 15.0f, 0.5f + (float)(i / 30) };
		cn_body_create(world, &body_def, &shape_def.body);
		cn_shape_create_box(world, &shape_def, i == 0 ? 30.0f : 0.45f, i == 0 ? 1.0f : 0.45f, 0.0f, NULL);
	}
	for (int step = 0; step < 30; ++step)
		cn_world_step(world, 1.0f / 60.0f);
	cn_world_hash(world, &hash);
	cn_world_destroy(world);
	return hash;
}

int main(void)
{
	static pool threads;
	if (!pool_start(&threads))
		return 1;
	const uint64_t alone = run(NULL), shared = run(&threads);
	pool_stop(&threads);
	printf("one thread %016llx, %d threads %016llx; %d ranges of tasks\n", (unsigned long long)alone, THREADS + 1, (unsigned long long)shared,
		(int)threads.taken);
	return !(alone != 0 && alone == shared);
}
