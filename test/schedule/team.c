/*
 * test/schedule/team.c - stands in for base/threads.c and base/clock.c: teams of up to CN_WORKERS_MAX workers that one thread simulates.
 *
 * A loop is split into chunks and runs as in base/threads.c. The chunk that the simulated worker takes next runs at once, and its
 * processor time is added to that worker's. The loop ends when its last chunk ends. Serial code between loops takes the time it takes.
 * A message costs the time of a cache line between cores: the leader writes one line for each seat, a worker reads one line
 * for each seat it looks at, and adds to one when it ends.
 *
 * It is exact in what depends on the algorithm: chunks, seats, order, serial parts, messages. It leaves out what the machine adds:
 * cores share memory bandwidth and large caches, but each brings a cache of its own, and one thread has all data in one cache.
 */
#define _POSIX_C_SOURCE 200112L
#include "base/threads.h"
#include "base/clock.h"
#include "base/maths.h"
#include "team.h"

#include <time.h>

#define CHUNKS_A_RUN 16        /* of base/threads.c */
#define PASSING_SLACK_NS 3000.0 /* of two readings of each clock */

struct cni_team {
	int32_t workers;
};

schedule_choice schedule = { SCHEDULE_OFF, 80.0 };
static double skew_ns; /* simulated time less processor time */

static double clock_ns(clockid_t clock)
{
	struct timespec now;
	(void)clock_gettime(clock, &now);
	return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

/* Time that this thread ran, and quicker to read, time as it passes. */
static double processor_ns(void) { return clock_ns(CLOCK_THREAD_CPUTIME_ID); }
static double passing_ns(void) { return clock_ns(CLOCK_MONOTONIC); }

/* What reading passing_ns takes. */
static double reading_ns(void)
{
	static double cost;
	if (cost == 0.0) {
		double from = processor_ns();
		int32_t k;
		for (k = 0; k < 100000; ++k)
			cost += passing_ns() > 0.0 ? 0.0 : 1.0;
		cost = (processor_ns() - from) / 100000;
	}
	return cost;
}

uint64_t cni_clock_ns(void) { return (uint64_t)(processor_ns() + skew_ns); }

cni_team *cni_team_create(cni_memory *memory, int32_t workers, cn_enqueue_fn *enqueue, cn_finish_fn *finish, void *user)
{
	static cni_team teams[CN_WORKERS_MAX + 1];
	(void)memory, (void)enqueue, (void)finish, (void)user;
	teams[workers].workers = workers;
	return &teams[workers];
}

void cni_team_destroy(cni_team *team, cni_memory *memory) { (void)team, (void)memory; }
int32_t cni_team_workers(const cni_team *team) { return team == NULL ? 1 : team->workers; }
uint64_t cni_team_bytes(int32_t workers) { return workers > 0 ? 0 : 0; }
void cni_team_run(cni_team *team, cni_lead_fn *lead, void *context) { (void)team, lead(context); }
void cni_team_hold(cni_team *team, int32_t on) { (void)team, (void)on; }

typedef struct shared_loop {
	cni_range_fn *fn;
	void *context;
	int32_t items;
} shared_loop;

static double chunk_run(const shared_loop *l, int32_t chunk, int32_t chunks)
{
	double from = passing_ns(), took;
	l->fn(l->context, (int32_t)((int64_t)l->items * chunk / chunks), (int32_t)((int64_t)l->items * (chunk + 1) / chunks));
	took = passing_ns() - from - reading_ns();
	return took > 0.0 ? took : 0.0;
}

/* The seats of a loop: the chunks next to end - 1 of each, and when its worker is free. */
typedef struct seats {
	int32_t count, next[CN_WORKERS_MAX], end[CN_WORKERS_MAX];
	double free_ns[CN_WORKERS_MAX];
} seats;

static seats seats_fill(int32_t runs, int32_t chunks)
{
	seats s;
	int32_t k;
	s.count = runs;
	for (k = 0; k < runs; ++k) {
		s.next[k] = (int32_t)((int64_t)chunks * k / runs);
		s.end[k] = (int32_t)((int64_t)chunks * (k + 1) / runs);
		s.free_ns[k] = schedule.line_ns * (k == 0 ? runs - 1 : runs - k + 1); /* the leader's seat is written last, and by itself */
	}
	return s;
}

static int32_t first_free(const seats *s)
{
	int32_t k, first = 0;
	for (k = 1; k < s->count; ++k)
		if (s->free_ns[k] < s->free_ns[first])
			first = k;
	return first;
}

/* The seat from which a worker takes its next chunk, -1: none is left. */
static int32_t seat_of(seats *s, int32_t worker)
{
	int32_t k;
	for (k = 0; k < s->count; ++k) {
		int32_t seat = (worker + k) % s->count;
		if (k > 0)
			s->free_ns[worker] += schedule.line_ns;
		if (s->next[seat] < s->end[seat])
			return seat;
	}
	return -1;
}

/* Runs all chunks of a loop. uniform_ns >= 0: each counts as so long instead of what it takes. Returns when the last one ends. */
static double chunks_run(seats *s, int32_t chunks, const shared_loop *l, double uniform_ns)
{
	double end_ns = 0.0, took;
	int32_t left = chunks;
	while (left > 0) {
		int32_t worker = first_free(s), seat = seat_of(s, worker), chunk;
		if (seat < 0) {
			s->free_ns[worker] = 1e30;
			continue;
		}
		chunk = s->next[seat]++;
		took = uniform_ns >= 0.0 ? uniform_ns : chunk_run(l, chunk, chunks);
		s->free_ns[worker] += took;
		end_ns = s->free_ns[worker] > end_ns ? s->free_ns[worker] : end_ns;
		--left;
	}
	return end_ns + schedule.line_ns;
}

/* Simulated time of a loop. Where another program had the core meanwhile, the time of its chunks is unknown, and all count the same. */
static double loop_run(const cni_team *team, int32_t ranges, const shared_loop *l)
{
	int32_t runs = cni_min_i(team->workers, ranges), chunks = cni_min_i(ranges, runs * CHUNKS_A_RUN);
	seats s = seats_fill(runs, chunks);
	double passed = passing_ns(), ran = processor_ns(), took = chunks_run(&s, chunks, l, -1.0);
	ran = processor_ns() - ran;
	passed = passing_ns() - passed;
	if (passed < ran + 0.25 * ran + PASSING_SLACK_NS)
		return took;
	s = seats_fill(runs, chunks);
	ran -= reading_ns() * (double)chunks;
	return chunks_run(&s, chunks, l, ran > 0.0 ? ran / (double)chunks : 0.0);
}

void cni_team_for(cni_team *team, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context)
{
	const shared_loop l = { fn, context, item_count };
	double from, took = 0.0;
	if (item_count <= 0)
		return;
	if (team == NULL || item_count / 2 < min_range || schedule.mode == SCHEDULE_OFF) {
		fn(context, 0, item_count);
		return;
	}
	from = processor_ns();
	if (schedule.mode == SCHEDULE_SERIAL)
		fn(context, 0, item_count);
	else
		took = loop_run(team, item_count / min_range, &l);
	skew_ns += took - (processor_ns() - from);
}
