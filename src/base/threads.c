/*
 * base/threads.c - teams: distribution of a loop's chunks, waiting of workers, threads of POSIX and Win32.
 *
 * Every worker has a seat in its own cache lines: the loop, the worker's run, and a word with the number of chunks of the run
 * that are left. The leader writes the seats, the words last. A worker that sees a nonzero word takes chunks from its seat
 * one by one, then from the other seats, adds their number to `done`, and watches its word again. The leader takes chunks in
 * the same way, then waits until `done` plus its own chunks are all. So a worker reads a seat only after it has taken a
 * chunk of it, and the seat does not change before that chunk is done:
 *
 *   leader   seats, words --release-->        take, run ...  wait for done ... next loop
 *   worker                --acquire--> take, run ...  done --release-->
 *
 * The leader waits only for workers that have taken a chunk: workers that sleep, are late, or never come cost nothing.
 *
 * A worker that has watched its word for some microseconds without work marks it ASLEEP and waits on a condition variable.
 * The mark is in the word itself, so that the next writer of the word cannot miss it. In a held team the worker keeps
 * watching and yields its core now and then.
 *
 * With the user's task system the first thread to arrive leads, be it the caller or a task, and the others help until the
 * seats are CLOSED. So tasks may run at once within enqueue, in any order, one after the other in finish, or in parallel.
 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif
#include "base/threads.h"
#include "base/maths.h"

#if CNI_HAS_THREADS && defined(_WIN32)
#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0600
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#elif CNI_HAS_THREADS
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#endif

#if CNI_HAS_TEAMS

#include <string.h>

#define CLOSED 0x80000000u     /* the worker leaves */
#define ASLEEP 0x40000000u     /* it waits on the condition variable */
#define CHUNKS_MOST 0xFFFFu    /* the rest of a word: chunks left */
#define CHUNKS_A_RUN 16        /* at most: so that little is left to a worker whose core was taken away, or whose items were expensive */
#define SPIN_ROUNDS 1000       /* some 10 to 50 us before one who waits offers its core: who it waits for may need it */
#define YIELD_ROUNDS 4         /* ... so many times, before a worker sleeps */
#define HELD_ROUNDS 200        /* ... of a team that is held, each after as many rounds: some milliseconds */
#define LINE_BYTES 128         /* processors fetch cache lines of 64 bytes in pairs */

/* ---- system threads ---- */

#if CNI_HAS_THREADS && defined(_WIN32)
typedef struct thread_gate {
	SRWLOCK lock;
	CONDITION_VARIABLE changed;
} thread_gate;
typedef HANDLE thread_id;

static int32_t gate_init(thread_gate *gate)
{
	InitializeSRWLock(&gate->lock);
	InitializeConditionVariable(&gate->changed);
	return 1;
}
static void gate_deinit(thread_gate *gate) { (void)gate; }
static void gate_lock(thread_gate *gate) { AcquireSRWLockExclusive(&gate->lock); }
static void gate_unlock(thread_gate *gate) { ReleaseSRWLockExclusive(&gate->lock); }
static void gate_wait(thread_gate *gate) { SleepConditionVariableSRW(&gate->changed, &gate->lock, INFINITE, 0); }
static void gate_wake_all(thread_gate *gate) { WakeAllConditionVariable(&gate->changed); }
static void thread_yield(void) { SwitchToThread(); }
#elif CNI_HAS_THREADS
typedef struct thread_gate {
	pthread_mutex_t lock;
	pthread_cond_t changed;
} thread_gate;
typedef pthread_t thread_id;

static int32_t gate_init(thread_gate *gate)
{
	if (pthread_mutex_init(&gate->lock, NULL) != 0)
		return 0;
	if (pthread_cond_init(&gate->changed, NULL) == 0)
		return 1;
	pthread_mutex_destroy(&gate->lock);
	return 0;
}
static void gate_deinit(thread_gate *gate)
{
	pthread_cond_destroy(&gate->changed);
	pthread_mutex_destroy(&gate->lock);
}
static void gate_lock(thread_gate *gate) { pthread_mutex_lock(&gate->lock); }
static void gate_unlock(thread_gate *gate) { pthread_mutex_unlock(&gate->lock); }
static void gate_wait(thread_gate *gate) { pthread_cond_wait(&gate->changed, &gate->lock); }
static void gate_wake_all(thread_gate *gate) { pthread_cond_broadcast(&gate->changed); }
static void thread_yield(void) { sched_yield(); }
#else
typedef int32_t thread_gate;
typedef int32_t thread_id;
static int32_t gate_init(thread_gate *gate) { return *gate = 1; }
static void gate_deinit(thread_gate *gate) { (void)gate; }
static void thread_yield(void) {}
#endif

/* Leaves the core's execution units to its other hardware thread while spinning. */
static void thread_pause(void)
{
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
	__builtin_ia32_pause();
#elif defined(__GNUC__) && defined(__aarch64__)
	__asm__ __volatile__("yield");
#elif defined(_MSC_VER)
	YieldProcessor();
#endif
}

/* ---- the team ---- */

/* The loop that chunks belong to. */
typedef struct loop {
	cni_range_fn *fn;
	void *context;
	int32_t item_count;
	int32_t chunk_count;
} loop;

typedef struct seat {
	loop of;            /* a copy beside the word, so that one cache line holds both */
	int32_t chunk_end;  /* of the worker's run */
	uint32_t word;      /* chunks left of the run, or flags */
	uint8_t rest[LINE_BYTES - sizeof(loop) - 8];
} seat;

/* One of the team's own threads and its argument. */
typedef struct thread {
	cni_team *team;
	thread_id id;
	int32_t worker;
} thread;

struct cni_team {
	int32_t open;       /* 1: a leader is active and loops are shared; with own threads always 1 */
	int32_t worker_count;
	cn_enqueue_fn *enqueue; /* NULL: own threads */
	cn_finish_fn *finish;
	void *user;
	cni_lead_fn *lead;
	void *lead_context;
	uint32_t held;      /* 1: cni_team_hold */
	uint8_t padding[LINE_BYTES];
	uint32_t done;      /* chunks that workers other than the leader have run */
	uint8_t done_padding[LINE_BYTES - 4];
	uint32_t arrived;   /* workers that have arrived since the user's tasks were enqueued */
	uint8_t arrived_padding[LINE_BYTES - 4];
	thread_gate gate;
	seat *seats;        /* one per worker */
	thread *threads;    /* own threads, of workers 1 and up */
	int32_t thread_count;
};

/* ---- taking chunks ---- */

static int32_t chunk_begin(const loop *of, int32_t chunk)
{
	return (int32_t)((int64_t)of->item_count * chunk / of->chunk_count);
}

/* Takes and runs chunks of a seat until none is left; returns their number. */
static uint32_t run_take(seat *s)
{
	uint32_t left = cni_atomic_load(&s->word), count = 0;
	while (left & CHUNKS_MOST) {
		if (cni_atomic_replace(&s->word, &left, left - 1u)) {
			int32_t chunk = s->chunk_end - (int32_t)left;
			s->of.fn(s->of.context, chunk_begin(&s->of, chunk), chunk_begin(&s->of, chunk + 1));
			++count;
			left = cni_atomic_load(&s->word);
		}
	}
	return count;
}

/* The same for the other seats, in ascending order from the worker's own. */
static uint32_t others_take(cni_team *team, int32_t worker)
{
	uint32_t count = 0;
	for (int32_t k = worker + 1; k < team->worker_count; ++k)
		count += run_take(&team->seats[k]);
	for (int32_t k = 0; k < worker; ++k)
		count += run_take(&team->seats[k]);
	return count;
}

/* ---- waiting ---- */

#if CNI_HAS_THREADS
static void seat_sleep(cni_team *team, seat *s)
{
	uint32_t word = 0;
	if (!cni_atomic_replace(&s->word, &word, ASLEEP))
		return;
	gate_lock(&team->gate);
	while (cni_atomic_load(&s->word) == ASLEEP)
		gate_wait(&team->gate);
	gate_unlock(&team->gate);
}
static void wake_all(cni_team *team)
{
	gate_lock(&team->gate);
	gate_wake_all(&team->gate);
	gate_unlock(&team->gate);
}
#else
static void seat_sleep(cni_team *team, seat *s) { (void)team, (void)s; }
static void wake_all(cni_team *team) { (void)team; }
#endif

/* Spins for some microseconds while the seat's word is 0. Returns the word. */
static uint32_t seat_spin(const seat *s)
{
	for (int32_t round = 0; round < SPIN_ROUNDS; ++round) {
		uint32_t word = cni_atomic_load(&s->word);
		if (word != 0)
			return word;
		thread_pause();
	}
	return 0;
}

/* Waits until the seat's word is not 0; returns it. */
static uint32_t seat_watch(cni_team *team, seat *s)
{
	for (int32_t round = 0;; ++round) {
		int32_t held = cni_atomic_load(&team->held) != 0;
		uint32_t word = round == 0 || held ? seat_spin(s) : cni_atomic_load(&s->word);
		if (word != 0)
			return word;
		thread_yield();
		if (round >= (held ? HELD_ROUNDS : YIELD_ROUNDS)) {
			seat_sleep(team, s);
			round = -1;
		}
	}
}

static void done_add(cni_team *team, uint32_t count)
{
	if (count > 0)
		cni_atomic_add(&team->done, count);
}

/* A worker's main loop. It reports its own run as done before it takes chunks of others, because the leader may be waiting
   for that run. */
static void help(cni_team *team, int32_t worker)
{
	while (!(seat_watch(team, &team->seats[worker]) & CLOSED)) {
		done_add(team, run_take(&team->seats[worker]));
		done_add(team, others_take(team, worker));
	}
}

/* Writes a word to all seats and wakes sleeping workers. */
static void seats_set(cni_team *team, uint32_t word)
{
	uint32_t was = 0;
	for (int32_t k = 0; k < team->worker_count; ++k)
		was |= cni_atomic_exchange(&team->seats[k].word, word);
	if (was & ASLEEP)
		wake_all(team);
}

/* ---- loops ---- */

/* Writes the workers' runs of the loop. The leader's seat is last, so that the others can begin. */
static void seats_fill(cni_team *team, const loop *of, int32_t runs)
{
	uint32_t was = 0;
	for (int32_t k = runs - 1; k >= 0; --k) {
		seat *s = &team->seats[k];
		s->of = *of;
		s->chunk_end = of->chunk_count * (k + 1) / runs;
		was |= cni_atomic_exchange(&s->word, (uint32_t)(s->chunk_end - of->chunk_count * k / runs));
	}
	if (was & ASLEEP)
		wake_all(team);
}

/* The leader's part of a loop. It reads other seats only if `done` shows that chunks are left. */
static void chunks_finish(cni_team *team, uint32_t count)
{
	count -= run_take(&team->seats[0]);
	if (cni_atomic_load(&team->done) != count)
		count -= others_take(team, 0);
	for (int32_t round = 0; cni_atomic_load(&team->done) != count; ++round) {
		if (round < SPIN_ROUNDS)
			thread_pause();
		else
			thread_yield();
	}
}

static int32_t workers_here(const cni_team *team)
{
	return team->enqueue == NULL ? team->worker_count : cni_min_i((int32_t)cni_atomic_load(&team->arrived), team->worker_count);
}

/* of.chunk_count: at most so many. */
static void loop_share(cni_team *team, loop of)
{
	int32_t runs = cni_min_i(workers_here(team), of.chunk_count);
	if (runs < 2) {
		of.fn(of.context, 0, of.item_count);
		return;
	}
	of.chunk_count = cni_min_i(of.chunk_count, runs * CHUNKS_A_RUN);
	cni_atomic_store(&team->done, 0);
	seats_fill(team, &of, runs);
	chunks_finish(team, (uint32_t)of.chunk_count);
}

typedef struct single_loop {
	cni_team *team;
	loop of;
} single_loop;

static void single_loop_lead(void *context)
{
	const single_loop *l = (const single_loop *)context;
	loop_share(l->team, l->of);
}

void cni_team_for(cni_team *team, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context)
{
	if (item_count <= 0)
		return;
	if (team == NULL || item_count / 2 < min_range) {
		fn(context, 0, item_count);
		return;
	}
	single_loop l = { team, { fn, context, item_count, item_count / min_range } };
	if (team->open)
		loop_share(team, l.of);
	else
		cni_team_run(team, single_loop_lead, &l);
}

void cni_team_hold(cni_team *team, int32_t on)
{
	if (team == NULL || team->enqueue != NULL)
		return;
	cni_atomic_store(&team->held, (uint32_t)on);
	if (on)
		seats_set(team, 0);
}

/* ---- leading and helping with the user's tasks ---- */

static void team_join(cni_team *team)
{
	uint32_t worker = cni_atomic_add(&team->arrived, 1u);
	if (worker == 0) {
		team->open = 1;
		team->lead(team->lead_context);
		team->open = 0;
		seats_set(team, CLOSED);
	} else if (worker < (uint32_t)team->worker_count) {
		help(team, (int32_t)worker);
	}
}

static void join_task(int32_t begin, int32_t end, void *context)
{
	(void)begin, (void)end; /* one worker, whatever the range */
	team_join((cni_team *)context);
}

void cni_team_run(cni_team *team, cni_lead_fn *lead, void *context)
{
	if (team == NULL) {
		lead(context);
		return;
	}
	if (team->enqueue == NULL) {
		seats_set(team, 0);
		lead(context);
		return;
	}
	team->lead = lead;
	team->lead_context = context;
	cni_atomic_store(&team->arrived, 0);
	seats_set(team, 0);
	void *task = team->enqueue(join_task, team, team->worker_count - 1, 1, team->user);
	team_join(team);
	if (task != NULL)
		team->finish(task, team->user);
}

/* ---- own threads ---- */

#if CNI_HAS_THREADS && defined(_WIN32)
static DWORD WINAPI thread_main(void *told)
{
	const thread *t = (const thread *)told;
	help(t->team, t->worker);
	return 0;
}

static int32_t thread_start(thread *t)
{
	t->id = CreateThread(NULL, 0, thread_main, t, 0, NULL);
	return t->id != NULL;
}

static void thread_end(thread *t)
{
	WaitForSingleObject(t->id, INFINITE);
	CloseHandle(t->id);
}
#elif CNI_HAS_THREADS
static void *thread_main(void *told)
{
	const thread *t = (const thread *)told;
	help(t->team, t->worker);
	return NULL;
}

/* Starts the thread with all signals blocked, so that the user's threads handle them. */
static int32_t thread_start(thread *t)
{
	sigset_t all, before;
	sigfillset(&all);
	pthread_sigmask(SIG_SETMASK, &all, &before);
	int32_t good = pthread_create(&t->id, NULL, thread_main, t) == 0;
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	return good;
}

static void thread_end(thread *t) { pthread_join(t->id, NULL); }
#else
static int32_t thread_start(thread *t) { return (void)t, 0; }
static void thread_end(thread *t) { (void)t; }
#endif

static int32_t threads_start(cni_team *team)
{
	for (; team->thread_count < team->worker_count - 1; ++team->thread_count) {
		thread *t = &team->threads[team->thread_count];
		t->team = team;
		t->worker = team->thread_count + 1;
		if (!thread_start(t))
			return 0;
	}
	return 1;
}

/* ---- creation and destruction ---- */

static uint64_t seats_offset(void) { return (sizeof(cni_team) + LINE_BYTES - 1u) / LINE_BYTES * LINE_BYTES; }

uint64_t cni_team_bytes(int32_t workers)
{
	return seats_offset() + (sizeof(seat) + sizeof(thread)) * (uint64_t)workers;
}

cni_team *cni_team_create(cni_memory *memory, int32_t workers, cn_enqueue_fn *enqueue, cn_finish_fn *finish, void *user)
{
	CNI_ASSERT(workers >= 2 && workers <= CN_WORKERS_MAX && (enqueue == NULL) == (finish == NULL));
	cni_team *team = (cni_team *)cni_memory_alloc(memory, cni_team_bytes(workers));
	if (team == NULL)
		return NULL;
	memset(team, 0, (size_t)cni_team_bytes(workers));
	team->worker_count = workers;
	team->open = enqueue == NULL;
	team->enqueue = enqueue;
	team->finish = finish;
	team->user = user;
	team->seats = (seat *)(void *)((uint8_t *)team + seats_offset());
	team->threads = (thread *)(void *)(team->seats + workers);
	if (!gate_init(&team->gate)) {
		cni_memory_free(memory, team, cni_team_bytes(workers));
		return NULL;
	}
	if (enqueue == NULL && !threads_start(team)) {
		cni_team_destroy(team, memory);
		return NULL;
	}
	return team;
}

void cni_team_destroy(cni_team *team, cni_memory *memory)
{
	if (team == NULL)
		return;
	seats_set(team, CLOSED);
	while (team->thread_count > 0)
		thread_end(&team->threads[--team->thread_count]);
	gate_deinit(&team->gate);
	cni_memory_free(memory, team, cni_team_bytes(team->worker_count));
}

int32_t cni_team_workers(const cni_team *team) { return team == NULL ? 1 : team->worker_count; }

#else

uint64_t cni_team_bytes(int32_t workers) { return (void)workers, 0; }
int32_t cni_team_workers(const cni_team *team) { return (void)team, 1; }
void cni_team_destroy(cni_team *team, cni_memory *memory) { (void)team, (void)memory; }

cni_team *cni_team_create(cni_memory *memory, int32_t workers, cn_enqueue_fn *enqueue, cn_finish_fn *finish, void *user)
{
	(void)memory, (void)workers, (void)enqueue, (void)finish, (void)user;
	return NULL;
}

#endif
