/*
 * test/families/run.c - one scene of a family on one solver: builds it, steps it, measures it after every frame.
 */
#ifndef _WIN32
#define _POSIX_C_SOURCE 200112L
#endif
#include "families.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define SPEED_LIMIT 399.0 /* m/s: the default linear_speed_max_mps is 400 */
#define NOISE_M 1e-5
#define CPU_MAX_S 20.0    /* a run that takes longer is given up */

#ifdef CLOCK_PROCESS_CPUTIME_ID
double cpu_clock_s(void)
{
	struct timespec now;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
#else
double cpu_clock_s(void) { return (double)clock() / (double)CLOCKS_PER_SEC; }
#endif

static uint32_t mixed(uint32_t x)
{
	x = (x ^ x >> 16) * 0x7feb352du; /* lowbias32 (Wellons, 2018) */
	x = (x ^ x >> 15) * 0x846ca68bu;
	x ^= x >> 16;
	return x != 0 ? x : 1u;
}

/* The time step: mostly 1/60 s; also 1/30, 1/120, 1/240 and frames of uneven length. */
static void pick_time(scene *s)
{
	static const double rates[10] = { 60.0, 60.0, 60.0, 60.0, 60.0, 30.0, 120.0, 120.0, 240.0, 60.0 };
	int32_t kind = pick_int(s, 0, 9);
	s->dt_s = 1.0 / rates[kind];
	s->vary = kind == 9;
	s->seconds = 4.0;
}

/* In place of the world, to which nothing that moves can be jointed. */
static void begin_frame(scene *s)
{
	cn_body_def def;
	cn_body_def_init(&def);
	def.type = CN_BODY_KINEMATIC;
	def.linear_velocity_mps.x = (float)s->drift_mps;
	if (cn_body_create(s->world, &def, &s->frame) != CN_OK)
		snprintf(s->refusal, sizeof s->refusal, "no frame");
}

static void begin_scene(scene *s, const family *which, int32_t seed, const run_settings *settings)
{
	const char *c;
	cn_world_def def;
	uint32_t random = (uint32_t)seed;
	memset(s, 0, sizeof *s);
	for (c = which->name; *c != '\0'; ++c)
		random = mixed(random * 31u + (uint32_t)(unsigned char)*c);
	s->random = mixed(random);
	s->density = 1.0;
	s->friction = 0.6;
	s->flags = which->flags;
	s->noise_m = settings->noise != 0 ? NOISE_M : 0.0;
	s->noise_random = mixed((uint32_t)settings->noise * 7919u + 1u);
	cn_world_def_init(&def);
	def.solver = settings->solver;
	if (settings->substeps > 0)
		def.substep_count = settings->substeps;
	def.gravity_mps2.y = (float)-GRAVITY;
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	s->substeps = def.substep_count;
	if (cn_world_def_check(&def, s->refusal, (int32_t)sizeof s->refusal) != CN_OK)
		return;
	s->refusal[0] = '\0';
	if (cn_world_create(&def, &s->world) != CN_OK)
		snprintf(s->refusal, sizeof s->refusal, "no world");
	pick_time(s);
	s->surface = settings->surface < 0 ? 1 + (int32_t)((uint32_t)seed % (SURFACE_COUNT - 1)) : settings->surface;
	s->drift_mps = settings->drift_mps;
	if (s->drift_mps != 0.0)
		begin_frame(s);
}

static void end_scene(scene *s)
{
	cn_world_destroy(s->world);
	free(s->bodies);
	free(s->shapes);
	free(s->joints);
	free(s->apart);
	free(s->order);
}

/* m g L + kinetic energy, L the greater extent of the dynamic bodies; and what falling through all of the scene gives. */
static double natural_energy(scene *s, double *out_speed)
{
	double mass = 0.0, kinetic = 0.0, fastest = 0.0, lower[2] = { HUGE_VAL, HUGE_VAL }, upper[2] = { -HUGE_VAL, -HUGE_VAL };
	int32_t k;
	for (k = 0; k < s->body_count; ++k) {
		scene_body *b = &s->bodies[k];
		cn_mass_data data;
		if (!b->dynamic || cn_body_get_mass_data(s->world, b->handle, &data) != CN_OK)
			continue;
		b->mass = (double)data.mass_kg;
		b->inertia = (double)data.inertia_kgm2;
		mass += b->mass;
		kinetic += 0.5 * b->mass * (b->vx * b->vx + b->vy * b->vy) + 0.5 * b->inertia * b->w * b->w;
		fastest = fmax(fastest, hypot(b->vx, b->vy));
		lower[0] = fmin(lower[0], b->px - b->reach);
		upper[0] = fmax(upper[0], b->px + b->reach);
		lower[1] = fmin(lower[1], b->py - b->reach);
		upper[1] = fmax(upper[1], b->py + b->reach);
	}
	*out_speed = sqrt(fastest * fastest + 2.0 * GRAVITY * fmax(upper[0] - lower[0], upper[1] - fmin(lower[1], 0.0)));
	return mass * GRAVITY * fmax(upper[0] - lower[0], upper[1] - lower[1]) + kinetic;
}

static void measure_motion(const scene *s, scene_measures *m)
{
	int32_t k;
	m->moved_m = 0.0;
	for (k = 0; k < s->body_count; ++k) {
		const scene_body *b = &s->bodies[k];
		if (!b->dynamic)
			continue;
		m->speed_max = fmax(m->speed_max, hypot(b->vx, b->vy));
		m->moved_m = fmax(m->moved_m, hypot(b->px - b->x, b->py - b->y));
	}
	m->moved_m = fmin(m->moved_m, MOVED_MAX_M);
	m->at_limit = m->speed_max > SPEED_LIMIT;
}

static int ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return x < y ? -1 : x > y;
}

static double percentile_99(double *values, int32_t count)
{
	if (count == 0)
		return 0.0;
	qsort(values, (size_t)count, sizeof *values, ascending);
	return values[(int32_t)(0.99 * (double)(count - 1))];
}

/* One frame. Returns 0 when the run is over before its time. */
static int step_once(scene *s, scene_measures *m, double now_s, double dt_s)
{
	cn_result result = meddle(s, now_s, dt_s);
	double start = cpu_clock_s(), spent;
	if (result == CN_OK)
		result = cn_world_step(s->world, (float)dt_s);
	spent = 1e3 * (cpu_clock_s() - start);
	m->step_ms += spent;
	m->step_max_ms = fmax(m->step_max_ms, spent);
	++m->steps;
	s->drifted_m += s->drift_mps * (double)(float)dt_s;
	m->broken = measure_read(s);
	if (result != CN_OK)
		snprintf(s->refusal, sizeof s->refusal, "%s", cn_world_error_text(s->world));
	return result == CN_OK && m->broken == 0 && m->step_ms < 1e3 * CPU_MAX_S;
}

/* Length of a frame. random: 0 to 1. */
static double frame_of(const scene *s, int32_t pace, int32_t frame, double now_s, double random)
{
	switch (pace) {
	case PACE_HITCHES: return random < 0.03 ? fmax(s->dt_s, 1.0 / 20.0) : s->dt_s;
	case PACE_SLOW_MOTION: return (int32_t)now_s & 1 ? 0.25 * s->dt_s : s->dt_s;
	case PACE_ALTERNATING: return frame & 1 ? 0.5 * s->dt_s : 2.0 * fmin(s->dt_s, 1.0 / 60.0);
	case PACE_ANY: return pow(12.0, random) / 240.0;
	default: return s->vary ? s->dt_s * (0.5 + random) : s->dt_s;
	}
}

static void step_frames(scene *s, scene_measures *m, int32_t pace)
{
	int32_t frames = (int32_t)lround(s->seconds / s->dt_s) * (pace != PACE_OF_SEED ? 10 : 1), k, given_up = 0;
	double *errors = malloc((size_t)frames * sizeof *errors), *overlaps = malloc((size_t)frames * sizeof *overlaps);
	double scale, start, most, now_s = 0.0, dt_s;
	uint32_t random = mixed(s->random);
	if (errors == NULL || overlaps == NULL)
		exit(2);
	m->broken = measure_read(s);
	scale = natural_energy(s, &m->speed_fall);
	start = most = measure_energy(s);
	m->joint_start = measure_joints(s);
	m->overlap_start = measure_overlap(s);
	for (k = 0; k < frames && (pace == PACE_OF_SEED || now_s < s->seconds); ++k) {
		random = mixed(random);
		dt_s = frame_of(s, pace, k, now_s, (double)random / 4294967296.0);
		given_up = !step_once(s, m, now_s, dt_s);
		if (given_up)
			break;
		now_s += dt_s;
		errors[k] = measure_joints(s);
		overlaps[k] = measure_overlap(s);
		most = fmax(most, measure_energy(s));
		measure_motion(s, m);
		m->joint_max = fmax(m->joint_max, errors[k]);
		m->overlap_max = fmax(m->overlap_max, overlaps[k]);
		m->joint_mean += errors[k];
	}
	m->joint_p99 = percentile_99(errors, k);
	m->overlap_p99 = percentile_99(overlaps, k);
	m->joint_mean /= k > 0 ? (double)k : 1.0;
	m->step_ms /= m->steps > 0 ? (double)m->steps : 1.0;
	m->energy_pct = 100.0 * (most - start) / scale;
	if (given_up && m->broken == 0 && s->refusal[0] == '\0')
		snprintf(s->refusal, sizeof s->refusal, "given up after %.0f s of processor time", CPU_MAX_S);
	free(errors);
	free(overlaps);
}

scene_measures run_scene(const family *which, int32_t seed, const run_settings *settings)
{
	scene_measures m;
	scene s;
	memset(&m, 0, sizeof m);
	begin_scene(&s, which, seed, settings);
	if (s.refusal[0] == '\0')
		which->build(&s);
	meddle_begin(&s, settings->meddle);
	if (s.refusal[0] == '\0')
		step_frames(&s, &m, settings->pace);
	m.flags = s.flags;
	m.bodies = s.body_count;
	m.joints = s.joint_count;
	m.refused = s.refusal[0] != '\0';
	memcpy(m.refusal, s.refusal, sizeof m.refusal);
	end_scene(&s);
	return m;
}
