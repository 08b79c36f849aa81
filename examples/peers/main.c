/*
 * examples/peers/main.c - runs scenes in every engine that was compiled in and prints CSV rows.
 *
 *     peers label [--header] [--quick] [--rounds n] [--workers n] [--scene name] [--list]
 *
 * label is the first column: how all of it was compiled. Rounds are the outer loop and engines the inner one,
 * so that what else the machine does falls on all of them. A step's time is this thread's CPU time without
 * what reading the clock costs (with several workers: time that passed); the first step is not timed, nor is what a
 * scene makes and removes between steps. Printed are the smallest mean of a round and the smallest median.
 *
 * In the first round a judge (judge.h) looks on: five times in the second half of the run, because some
 * scenes begin with overlap on purpose. Later rounds run without it and must end with the same poses.
 */
#ifdef __linux__
#define _POSIX_C_SOURCE 200112L
#endif
#include "peers/world.h"
#include <inttypes.h>
#include <math.h>
#ifdef __linux__
#include <setjmp.h>
#include <signal.h>
#include <unistd.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define ROUNDS 3
#define QUICK_ROUNDS 2
#define QUICK_SHARE 4
#define QUICK_STEPS_MIN 120
#define CHECK_STEPS 10
#define SLOWEST 4.0   /* times the first engine's run, and a second */
#define DISPLACEMENT_MAX_M 1.0
#define JOINT_MAX_M 1.0

static const peer_engine *const engines[] = {
	&peer_engine_cairn,
#ifdef PEERS_BOX2D
	&peer_engine_box2d,
#endif
#ifdef PEERS_CHIPMUNK
	&peer_engine_chipmunk,
#endif
};
#define ENGINES ((int32_t)(sizeof engines / sizeof engines[0]))

typedef struct options {
	const char *label;
	const char *scene;    /* NULL: all */
	int32_t rounds;
	int32_t quick;
	int32_t workers;
} options;

typedef struct result {
	measure_times times;  /* of one round */
	double mean_ms;       /* smallest of all rounds */
	double median_ms;
	double p99_ms;        /* of the slow steps; the first step is not among them */
	double max_ms;
	double first_ms;
	double step_ms;       /* the first step of the last round */
	peer_errors errors;
	uint64_t hash;
	int32_t bodies;
	int32_t differs;      /* a later round ended elsewhere */
	int32_t stopped;      /* what it did made no sense any more, or took too long */
	int32_t not_run;      /* the engine lacks something that the scene needs */
} result;

/* ------------------------------------------------------------------ clock */

static int32_t work_is_shared; /* threads wait for each other: what counts is the time that passes */

static double clock_seconds(void)
{
#ifdef CLOCK_THREAD_CPUTIME_ID
	struct timespec now;
	clock_gettime(work_is_shared ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1.0e-9 * (double)now.tv_nsec;
#else
	return (double)clock() / (double)CLOCKS_PER_SEC;
#endif
}

/* What two readings with nothing between them differ by, at least. */
static double clock_cost(void)
{
	double least = 1.0;
	for (int32_t i = 0; i < 1000; ++i) {
		double start = clock_seconds();
		least = fmin(least, clock_seconds() - start);
	}
	return least;
}

/* ------------------------------------------------------------------ one run */

/* A quick run still has to come to where things happen. */
static int32_t steps_of(const peer_scene *scene, int32_t quick)
{
	int32_t share = scene->step_count / QUICK_SHARE;
	return quick ? (share > QUICK_STEPS_MIN ? share : QUICK_STEPS_MIN) : scene->step_count;
}

/* The end of each of the last five tenths. */
static int32_t is_sample(int32_t taken, int32_t steps)
{
	for (int32_t tenth = 6; tenth <= 10; ++tenth) {
		if (taken == steps * tenth / 10)
			return 1;
	}
	return 0;
}

/* A scene that came apart may take for ever: the first round stops there. */
static int32_t is_hopeless(peer_world *world, int32_t taken, double run_ms, double limit_ms, result *out)
{
	if (world->judge == NULL)
		return 0;
	if (taken % CHECK_STEPS == 0 && !out->errors.broken)
		peer_world_measure(world, 0, &out->errors);
	return out->errors.broken || out->errors.lost > 0 || run_ms > limit_ms;
}

static void run_steps(peer_world *world, int32_t steps, double cost, double limit_ms, result *out)
{
	double run_ms = 0.0;
	out->times.count = 0;
	for (int32_t i = 0; i < steps; ++i) {
		if (world->scene->step != NULL)
			world->scene->step(world, i);
		double start = clock_seconds();
		world->engine->step(world->world, PEER_STEP_S);
		double seconds = clock_seconds() - start - cost;
		if (i > 0)
			measure_times_add(&out->times, fmax(seconds, 0.0));
		else
			out->step_ms = 1000.0 * seconds;
		if (world->judge != NULL && !out->errors.broken && is_sample(i + 1, steps))
			peer_world_measure(world, 1, &out->errors);
		run_ms += 1000.0 * seconds;
		if (is_hopeless(world, i + 1, run_ms, limit_ms, out)) {
			out->stopped = 1;
			return;
		}
	}
}

/* A single step may never end: an alarm leaves it, and the world with it, as they are. limit_ms HUGE_VAL: none. */
#ifdef __linux__
static sigjmp_buf escape;
static void leave(int number)
{
	(void)number;
	siglongjmp(escape, 1);
}

static void run_guarded(peer_world *world, int32_t steps, double cost, double limit_ms, result *out)
{
	if (world->judge != NULL && limit_ms < HUGE_VAL) {
		if (sigsetjmp(escape, 1) != 0) {
			out->stopped = 1;
			return;
		}
		signal(SIGALRM, leave);
		alarm((unsigned)(0.002 * limit_ms) + 5u);
	}
	run_steps(world, steps, cost, limit_ms, out);
	alarm(0);
}
#else
#define run_guarded run_steps
#endif

static double mean_of(const measure_times *times)
{
	double sum = 0.0;
	for (int32_t i = 0; i < times->count; ++i)
		sum += times->ms[i];
	return sum / (double)(times->count > 0 ? times->count : 1);
}

static int32_t count_dynamic(const peer_world *world)
{
	int32_t count = 0;
	for (int32_t i = 0; i < world->count; ++i)
		count += world->slots[i].alive && (world->slots[i].flags & PEER_DYNAMIC);
	return count;
}

static double least_of(int32_t round, double least, double value) { return round == 0 ? value : fmin(least, value); }

static void run_round(const options *o, const peer_engine *engine, const peer_scene *scene, int32_t round, int32_t steps, double cost, double limit_ms, result *out)
{
	peer_world world;
	if (!peer_world_open(&world, engine, scene, o->workers, round == 0)) {
		out->not_run = 1;
		return;
	}
	run_guarded(&world, steps, cost, limit_ms, out);
	if (out->stopped) {
		out->bodies = count_dynamic(&world);
		out->mean_ms = mean_of(&out->times);
		return; /* what is left of the world cannot be trusted, not even to be destroyed */
	}
	uint64_t hash = peer_world_hash(&world);
	double mean = mean_of(&out->times);
	measure_times_sort(&out->times);
	out->mean_ms = least_of(round, out->mean_ms, mean);
	out->median_ms = least_of(round, out->median_ms, measure_times_at(&out->times, 0.5));
	out->p99_ms = least_of(round, out->p99_ms, measure_times_at(&out->times, 0.99));
	out->max_ms = least_of(round, out->max_ms, measure_times_at(&out->times, 1.0));
	out->first_ms = least_of(round, out->first_ms, out->step_ms);
	out->differs |= round > 0 && hash != out->hash;
	out->hash = hash;
	out->bodies = count_dynamic(&world);
	out->not_run |= world.failed;
	peer_world_close(&world);
}

/* ------------------------------------------------------------------ rows */

static const char *verdict_of(const result *r, const peer_scene *scene)
{
	if (r->not_run)
		return "not run";
	if (r->errors.broken)
		return "FAILED: not a number";
	if ((scene->flags & PEER_SCENE_STANDS) && r->errors.displacement > DISPLACEMENT_MAX_M)
		return "FAILED: fell";
	if (r->errors.joint > JOINT_MAX_M)
		return "FAILED: joints came apart";
	if (r->errors.lost > 0)
		return "FAILED: bodies lost";
	if (r->stopped)
		return "FAILED: too slow";
	return r->differs ? "rounds differ" : "ok";
}

static void print_header(void)
{
	printf("build,scene,engine,bodies,steps,rounds,ms_mean,ms_median,ms_p99,ms_max,ms_first,displacement_m,joint_gap_m,penetration_m,bodies_lost,hash,verdict\n");
}

static void print_row(const options *o, const peer_scene *scene, const peer_engine *engine, const result *r)
{
	printf("%s,%s,%s,%" PRId32 ",%" PRId32 ",%" PRId32 ",", o->label, scene->name, engine->name, r->bodies, steps_of(scene, o->quick), o->rounds);
	if (r->not_run) {
		printf(",,,,,,,,,,%s\n", verdict_of(r, scene));
		return;
	}
	printf("%.5f,%.5f,%.5f,%.5f,%.5f,", r->mean_ms, r->median_ms, r->p99_ms, r->max_ms, r->first_ms);
	if (scene->flags & PEER_SCENE_STANDS)
		printf("%.5f", r->errors.displacement);
	printf(",%.5f,%.5f,%" PRId32 ",%016" PRIx64 ",%s\n", r->errors.joint, r->errors.penetration, r->errors.lost, r->hash, verdict_of(r, scene));
}

static int32_t run_scene(const options *o, const peer_scene *scene)
{
	result results[ENGINES];
	int32_t good = 1, steps = steps_of(scene, o->quick);
	double cost = clock_cost();
	memset(results, 0, sizeof results);
	for (int32_t i = 0; i < ENGINES; ++i)
		good &= measure_times_open(&results[i].times, steps);
	for (int32_t round = 0; good && round < o->rounds; ++round) {
		for (int32_t i = 0; i < ENGINES; ++i) {
			double limit_ms = i == 0 ? HUGE_VAL : SLOWEST * results[0].mean_ms * (double)steps + 1000.0;
			if (!results[i].not_run && !results[i].stopped)
				run_round(o, engines[i], scene, round, steps, cost, limit_ms, &results[i]);
		}
	}
	for (int32_t i = 0; i < ENGINES; ++i) {
		if (good)
			print_row(o, scene, engines[i], &results[i]);
		measure_times_close(&results[i].times);
	}
	fflush(stdout);
	return good;
}

/* ------------------------------------------------------------------ main */

static int usage(void)
{
	fprintf(stderr, "usage: peers label [--header] [--quick] [--rounds n] [--workers n] [--scene name] [--list]\n");
	return 2;
}

static int list_all(void)
{
	for (int32_t i = 0; i < peer_scene_count(); ++i)
		printf("%s\n", peer_scene_at(i)->name);
	return 0;
}

int main(int argc, char **argv)
{
	options o = {NULL, NULL, 0, 0, 1};
	int32_t found = 0, good = 1;
	if (argc < 2)
		return usage();
	o.label = argv[1];
	for (int i = 2; i < argc; ++i) {
		if (strcmp(argv[i], "--header") == 0)
			print_header();
		else if (strcmp(argv[i], "--list") == 0)
			return list_all();
		else if (strcmp(argv[i], "--quick") == 0)
			o.quick = 1;
		else if (strcmp(argv[i], "--rounds") == 0 && i + 1 < argc)
			o.rounds = (int32_t)strtol(argv[++i], NULL, 10);
		else if (strcmp(argv[i], "--workers") == 0 && i + 1 < argc)
			o.workers = (int32_t)strtol(argv[++i], NULL, 10);
		else if (strcmp(argv[i], "--scene") == 0 && i + 1 < argc)
			o.scene = argv[++i];
		else
			return usage();
	}
	if (o.workers < 1)
		return usage();
	work_is_shared = o.workers > 1;
	if (o.rounds < 1)
		o.rounds = o.quick ? QUICK_ROUNDS : ROUNDS;
	for (int32_t i = 0; i < peer_scene_count(); ++i) {
		if (o.scene != NULL && strcmp(o.scene, peer_scene_at(i)->name) != 0)
			continue;
		++found;
		good &= run_scene(&o, peer_scene_at(i));
	}
	if (found == 0) {
		fprintf(stderr, "peers: there is no scene %s (--list shows them)\n", o.scene);
		return 2;
	}
	return good ? 0 : 1;
}
