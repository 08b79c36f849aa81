/*
 * test/families/judge.h - what is judged of a run, and what a family's report is made of.
 */
#ifndef CAIRN_FAMILIES_JUDGE_H
#define CAIRN_FAMILIES_JUDGE_H

#include "families.h"
#include <stdio.h>

#define CONFIRM_MAX 16
#define RUNS_MAX (CONFIRM_MAX + 1)
#define PEER_RUNS 3      /* of another engine for each seed: medians are compared */
#define NOISE_OTHER 1000 /* perturbations of the first side when a solver is judged against itself */
#define REFERENCE_SUBSTEPS 64
#define EXPENSIVE_TIME 4.0        /* times the other's: a seed that takes longer is to have an error smaller in proportion */
#define EXPENSIVE_TIME_MEDIAN 2.0 /* ... and a family, by medians */
#define EXPENSIVE_RUNS 2          /* more runs on both sides of a seed that looks expensive: the shortest times decide */
#define ERROR_LEAST 1e-6     /* m: lesser errors are none */

enum { M_JOINT, M_OVERLAP, M_ENERGY, M_SPEED, M_MOVED, M_BROKEN, M_COUNT };

typedef struct measure_kind {
	const char *name, *unit;
	double factor, allowance; /* worse: beyond factor x the other's + allowance, both in SI units and percent */
	double shown;             /* factor for printing */
} measure_kind;

extern const measure_kind kinds[M_COUNT];

typedef struct judged {
	double value[M_COUNT];
} judged;

typedef struct settings {
	const char *family;
	int32_t seeds, first, confirm, substeps;
	int noise, monotone;
	int32_t meddle;  /* run_settings.meddle */
	double drift_mps; /* likewise */
	int32_t pace, surface;
	int32_t solvers[2];
	const char *names[2];
	FILE *csv, *record;
	const char *peer_name;
	FILE *peer; /* what --record wrote */
} settings;

typedef struct seed_result {
	int32_t seed;
	scene_measures measures[2];
	judged judged[2];
	uint32_t worse;
	uint32_t first_worse[2]; /* without confirmation: by side, the measures of the first run in which it is worse than the other */
	double time_ratio, gain; /* time of a step over the other's; the other's error over mine */
	int32_t has_peer;
	judged peer;
	uint32_t worse_than_peer;
} seed_result;

/* ---- judge.c ---- */

judged to_judged(const scene_measures *m);
/* Bit k: measure k of mine is worse. */
uint32_t worse_mask(const judged *mine, const judged *other);
/* Mine as a multiple of what the other allows. */
double excess(const judged *mine, const judged *other, int32_t kind);
/* Sorts the values. */
double median(double *values, int32_t count);
void keep_values(double values[M_COUNT][RUNS_MAX], int32_t at, const judged *j);
judged median_judged(double values[M_COUNT][RUNS_MAX], int32_t count);
scene_measures run_side(const settings *set, const family *which, int32_t seed, int32_t side, int32_t repeat);
/* A seed that looks worse is run again with other perturbations of 1e-5 m, twice and then as often as is asked for, as
   long as the medians over all runs are worse. sides: the first run in, medians out. */
uint32_t confirm_seed(const settings *set, const family *which, int32_t seed, judged sides[2]);

/* The greatest of joint error, overlap and displacement, m, at least ERROR_LEAST. */
double error_of(const judged *j);
/* Takes so much longer that its error would have to be smaller, and is not? */
int is_expensive(double time_ratio, double gain, double time_most);
/* Fills in time_ratio and gain from measures and judged. */
void confirm_time(const settings *set, const family *which, seed_result *r);

/* ---- table.c: rows of CSV ---- */

void write_csv_head(FILE *file);
/* file may be NULL. */
void write_csv(FILE *file, const char *name, int32_t seed, const char *engine, const scene_measures *m, uint32_t worse);
/* Medians of another engine's rows of this seed, and the first of them. The file has families and seeds in the order in which
   they are asked for. Returns 0 if there are none. */
int find_peer(const settings *set, const char *name, int32_t seed, uint32_t flags, judged *out, scene_measures *first);

/* ---- report.c ---- */

void print_side(const char *engine, const scene_measures *m);
/* One line a family, and one for each measure with worse seeds. Returns the number of worse seeds. */
int32_t report_family(const settings *set, const family *which, const seed_result *results, int32_t count, double cpu_s);

#endif
