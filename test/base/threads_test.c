/*
 * test/base/threads_test.c - teams of workers: every item once, loops one after the other, with threads
 * of their own and with the user's tasks.
 */
#include "base/tasks.h"

#include "base/hooks.h"
#include "base/threads.h"
#include "test.h"

#ifdef TEST_EMULATED
#define ITEMS 1000
#else
#define ITEMS 5000
#endif
#define CHAIN_STEPS TEST_FORM(1000, 400, 100)
#define IDLE_TURNS TEST_FORM(3000000, 3000000, 300000) /* each takes at least ten times as long under a sanitizer */
#define IDLE_LOOPS TEST_FORM(10, 5, 4)

static const int32_t worker_counts[] = { 2, 3, 8, 64 };
#define WORKER_COUNTS ((int32_t)(sizeof worker_counts / sizeof *worker_counts))

/* kind CNI_NONE: threads of its own. */
static cni_team *team_make(cni_memory *memory, int32_t workers, int32_t kind, tasks *system)
{
	memset(system, 0, sizeof *system);
	system->kind = kind;
	return kind == CNI_NONE ? cni_team_create(memory, workers, NULL, NULL, NULL) : cni_team_create(memory, workers, tasks_enqueue, tasks_finish, system);
}

/* ---- loops ---- */

typedef struct loop {
	cni_team *team;
	int32_t min_range;
	int32_t item_count;
	int32_t times[ITEMS];          /* how often each item was run */
	int32_t wrong;                 /* calls that break a promise */
	int32_t busy;                  /* additions an item */
	float sums[ITEMS];
} loop;

static void loop_range(void *context, int32_t begin, int32_t end)
{
	loop *l = context;
	int32_t k, n;
	if (begin >= end || (end - begin < l->min_range && end - begin < l->item_count)) {
		l->wrong = 1;
		return;
	}
	for (k = begin; k < end; ++k) {
		++l->times[k];
		for (n = 0; n < l->busy; ++n)
			l->sums[k] += 1.0f;
	}
}

static void check_loop(loop *l, int32_t item_count, int32_t min_range)
{
	int32_t k, good = 1;
	memset(l->times, 0, sizeof l->times);
	l->item_count = item_count;
	l->min_range = min_range;
	cni_team_for(l->team, item_count, min_range, loop_range, l);
	for (k = 0; k < ITEMS; ++k)
		good &= l->times[k] == (k < item_count);
	CHECK(good);
	CHECK(!l->wrong);
}

static void check_loops(cni_team *team)
{
	static loop l;
	int32_t k;
	memset(&l, 0, sizeof l);
	l.team = team;
	for (k = 0; k < 40; ++k)
		check_loop(&l, k, 1 + k % 3);
	for (l.busy = 0; l.busy < 100; l.busy += TEST_FORM(33, 99, 99))
		for (k = 1; k < ITEMS; k = 3 * k + 1)
			check_loop(&l, ITEMS - k % 7, k);
}

static void every_item_runs_once(void)
{
	cni_memory memory;
	hooks h;
	int32_t w, kind;
	hooks_init(&h, &memory);
	check_loops(NULL);
	for (w = 0; w < WORKER_COUNTS; ++w)
		for (kind = CNI_NONE; kind < TASKS_KINDS; ++kind) {
			tasks system;
			cni_team *team;
			if (!cni_team_possible(worker_counts[w], kind == CNI_NONE ? NULL : tasks_enqueue))
				continue;
			team = team_make(&memory, worker_counts[w], kind, &system);
			REQUIRE(team != NULL);
			CHECK(cni_team_workers(team) == worker_counts[w]);
			check_loops(team);
			cni_team_destroy(team, &memory);
			if (kind != CNI_NONE) {
				CHECK(system.enqueued > 0 && system.wrong == 0 && !system.open);
				CHECK(system.finished == (kind == TASKS_AT_ONCE ? 0 : system.enqueued));
			}
			CHECK(h.pieces == 0);
		}
}

/* ---- loops one after the other ---- */

/* Each loop reads what others wrote in the loop before it: items are mixed with others at changing distances. */
typedef struct chain {
	cni_team *team;
	uint32_t values[2][ITEMS];
	int32_t step;
} chain;

static void chain_range(void *context, int32_t begin, int32_t end)
{
	chain *c = context;
	const uint32_t *from = c->values[c->step & 1];
	uint32_t *to = c->values[~c->step & 1];
	int32_t k, far = 1 + c->step * 977 % (ITEMS - 1);
	for (k = begin; k < end; ++k)
		to[k] = (from[k] ^ from[(k + far) % ITEMS] >> 3) * 2654435761u + 1u;
}

static void chain_lead(void *context)
{
	chain *c = context;
	for (c->step = 0; c->step < CHAIN_STEPS; ++c->step)
		cni_team_for(c->team, ITEMS, 100, chain_range, c);
}

static uint32_t chain_digest(cni_team *team)
{
	static chain c;
	uint32_t digest = 0;
	int32_t k;
	for (k = 0; k < ITEMS; ++k)
		c.values[0][k] = (uint32_t)k * 2654435761u;
	c.team = team;
	cni_team_run(team, chain_lead, &c);
	for (k = 0; k < ITEMS; ++k)
		digest = digest * 31u + c.values[0][k];
	return digest;
}

static void loops_see_what_the_last_one_wrote(void)
{
	uint32_t alone = chain_digest(NULL);
	cni_memory memory;
	hooks h;
	int32_t w, kind;
	hooks_init(&h, &memory);
	for (w = 0; w < WORKER_COUNTS; ++w)
		for (kind = CNI_NONE; kind < TASKS_KINDS; ++kind) {
			tasks system;
			cni_team *team;
			uint32_t digest;
			if (!cni_team_possible(worker_counts[w], kind == CNI_NONE ? NULL : tasks_enqueue))
				continue;
			team = team_make(&memory, worker_counts[w], kind, &system);
			REQUIRE(team != NULL);
			digest = chain_digest(team);
			printf("  %d workers, %s: %08x, alone %08x\n", (int)worker_counts[w], kind == CNI_NONE ? "own threads" : tasks_name(kind), (unsigned)digest, (unsigned)alone);
			CHECK(digest == alone);
			if (kind != CNI_NONE)
				CHECK(system.enqueued == 1); /* one task for all loops of a run */
			cni_team_destroy(team, &memory);
		}
}

/* ---- sleeping ---- */

static uint32_t idle_turns;

/* Longer than workers watch for work in vain. */
static void idle(void)
{
	volatile uint32_t *turns = &idle_turns;
	int32_t k;
	for (k = 0; k < IDLE_TURNS; ++k)
		++*turns;
}

static void idle_lead(void *context)
{
	loop *l = context;
	int32_t k;
	for (k = 0; k < IDLE_LOOPS; ++k) {
		idle();
		check_loop(l, ITEMS, 50);
	}
}

/* Workers have gone to sleep when the next loop comes, between loops and in a run. */
static void sleepers_are_woken(void)
{
	static loop l;
	cni_memory memory;
	hooks h;
	int32_t kind;
	hooks_init(&h, &memory);
	for (kind = CNI_NONE; kind < TASKS_KINDS; ++kind) {
		tasks system;
		if (!cni_team_possible(3, kind == CNI_NONE ? NULL : tasks_enqueue))
			continue;
		memset(&l, 0, sizeof l);
		l.team = team_make(&memory, 3, kind, &system);
		REQUIRE(l.team != NULL);
		idle_lead(&l);
		cni_team_run(l.team, idle_lead, &l);
		cni_team_destroy(l.team, &memory);
	}
}

/* Held once for several loops, held again and again, held to the end; between the loops less time than the team is held, and more. */
static void teams_that_are_held_do_their_loops(void)
{
	static loop l;
	cni_memory memory;
	hooks h;
	int32_t w, k;
	hooks_init(&h, &memory);
	cni_team_hold(NULL, 1);
	for (w = 0; w < WORKER_COUNTS && cni_team_possible(2, NULL); ++w) {
		memset(&l, 0, sizeof l);
		l.team = cni_team_create(&memory, worker_counts[w], NULL, NULL, NULL);
		REQUIRE(l.team != NULL);
		for (k = 0; k < 6; ++k) {
			cni_team_hold(l.team, k != 4);
			check_loop(&l, ITEMS, 50);
			check_loop(&l, ITEMS, 500);
			if (k % 2 == 0)
				idle_lead(&l);
			cni_team_hold(l.team, k == 5);
		}
		cni_team_destroy(l.team, &memory);
		CHECK(h.pieces == 0);
	}
}

/* ---- life ---- */

static void teams_come_and_go(void)
{
	cni_memory memory;
	hooks h;
	int32_t k;
	hooks_init(&h, &memory);
	if (!cni_team_possible(2, NULL))
		SKIP("no threads");
	for (k = 0; k < 200; ++k) {
		static loop l;
		memset(&l, 0, sizeof l);
		l.team = cni_team_create(&memory, 2 + k % 5, NULL, NULL, NULL);
		REQUIRE(l.team != NULL);
		if (k % 3 != 0)
			check_loop(&l, ITEMS, 10);
		cni_team_destroy(l.team, &memory);
		CHECK(h.pieces == 0 && h.wrong_frees == 0);
	}
	h.fail_at = h.calls + 1;
	CHECK(cni_team_create(&memory, 4, NULL, NULL, NULL) == NULL);
	CHECK(h.pieces == 0);
	cni_team_destroy(NULL, &memory);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_item_runs_once);
	RUN(loops_see_what_the_last_one_wrote);
	RUN(sleepers_are_woken);
	RUN(teams_that_are_held_do_their_loops);
	RUN(teams_come_and_go);
	return test_end();
}
