/*
 * test/families/families.c - runs every family for many seeds, judges the default solver against another, and reports.
 *
 * Usage: families [--family name] [--seeds n] [--first n] [--solvers auto,soft] [--substeps n] [--noise 1] [--monotone 1]
 *                 [--confirm n] [--csv file] [--record file] [--peer name=file] [--list]
 * The README says what is judged and how.
 */
#include "families.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CONFIRM_MAX 16
#define RUNS_MAX (CONFIRM_MAX + 1)
#define PEER_RUNS 3 /* of another engine for each seed: medians are compared */
#define NOISE_OTHER 1000 /* perturbations of the other side when a solver is judged against itself */

/* ---- judged measures ---- */

enum { M_JOINT, M_OVERLAP, M_ENERGY, M_SPEED, M_MOVED, M_BROKEN, M_COUNT };

typedef struct measure_kind {
	const char *name, *unit;
	double factor, allowance; /* worse: beyond factor x the other's + allowance, both in SI units and percent */
	double shown;             /* factor for printing */
} measure_kind;

static const measure_kind kinds[M_COUNT] = {
	{ "joint", "mm", 1.5, 0.001, 1e3 },
	{ "overlap", "mm", 1.5, 0.001, 1e3 },
	{ "energy", "%", 1.5, 1.0, 1.0 },
	{ "speed", "m/s", 1.5, 1.0, 1.0 },
	{ "moved", "mm", 1.5, 0.001, 1e3 },
	{ "broken", "", 1.0, 0.0, 1.0 },
};

typedef struct judged {
	double value[M_COUNT];
} judged;

static judged to_judged(const scene_measures *m)
{
	judged j;
	j.value[M_JOINT] = m->joint_p99;
	j.value[M_OVERLAP] = m->overlap_p99;
	j.value[M_ENERGY] = (m->flags & SCENE_NO_ENERGY) != 0 ? 0.0 : m->energy_pct;
	j.value[M_SPEED] = m->speed_max;
	j.value[M_MOVED] = (m->flags & SCENE_STANDS) != 0 ? m->moved_m : 0.0;
	j.value[M_BROKEN] = (double)(m->broken > 0 || m->at_limit || m->refused);
	return j;
}

static uint32_t worse_mask(const judged *mine, const judged *other)
{
	uint32_t mask = 0;
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		if (!(mine->value[k] <= kinds[k].factor * other->value[k] + kinds[k].allowance))
			mask |= 1u << k;
	return mask;
}

/* By how much of what is allowed. */
static double excess(const judged *mine, const judged *other, int32_t kind)
{
	double allowed = kinds[kind].factor * other->value[kind] + kinds[kind].allowance;
	return allowed > 0.0 ? mine->value[kind] / allowed : mine->value[kind];
}

/* ---- settings ---- */

typedef struct settings {
	const char *family;
	int32_t seeds, first, confirm, substeps;
	int noise, monotone;
	int32_t solvers[2];
	const char *names[2];
	FILE *csv, *record;
	const char *peer_name;
	FILE *peer; /* what --record wrote */
} settings;

static const char *const solver_names[] = { "auto", "soft", "direct", "sequential" };

static int ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return x < y ? -1 : x > y;
}

static double median(double *values, int32_t count)
{
	if (count == 0)
		return 0.0;
	qsort(values, (size_t)count, sizeof *values, ascending);
	return values[count / 2];
}

static scene_measures run_side(const settings *set, const family *which, int32_t seed, int32_t side, int32_t repeat)
{
	run_settings run;
	run.solver = set->solvers[side];
	run.substeps = set->substeps;
	run.noise = repeat + (set->noise && side == 0 ? NOISE_OTHER : 0);
	return run_scene(which, seed, &run);
}

static void keep_values(double values[M_COUNT][RUNS_MAX], int32_t at, const judged *j)
{
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		values[k][at] = j->value[k];
}

static judged median_judged(double values[M_COUNT][RUNS_MAX], int32_t count)
{
	judged j;
	int32_t k;
	for (k = 0; k < M_COUNT; ++k)
		j.value[k] = median(values[k], count);
	return j;
}

/* A seed that looks worse is run again with other perturbations of 1e-5 m, twice and then as often as is asked for, as
   long as the medians over all runs are worse. */
static uint32_t confirm_seed(const settings *set, const family *which, int32_t seed, judged sides[2])
{
	double values[2][M_COUNT][RUNS_MAX];
	uint32_t worse = worse_mask(&sides[0], &sides[1]);
	int32_t side, repeat;
	for (side = 0; side < 2; ++side)
		keep_values(values[side], 0, &sides[side]);
	for (repeat = 1; repeat <= set->confirm && worse != 0; ++repeat) {
		for (side = 0; side < 2; ++side) {
			scene_measures m = run_side(set, which, seed, side, repeat);
			judged j = to_judged(&m);
			keep_values(values[side], repeat, &j);
		}
		if (repeat != 2 && repeat != set->confirm)
			continue;
		for (side = 0; side < 2; ++side)
			sides[side] = median_judged(values[side], repeat + 1);
		worse = worse_mask(&sides[0], &sides[1]);
	}
	return worse;
}

/* ---- one family ---- */

typedef struct seed_result {
	int32_t seed;
	scene_measures measures[2];
	judged judged[2];
	uint32_t worse;
	int32_t has_peer;
	judged peer;
	uint32_t worse_than_peer;
} seed_result;

static void write_csv(FILE *file, const char *name, int32_t seed, const char *engine, const scene_measures *m, uint32_t worse)
{
	if (file == NULL)
		return;
	fprintf(file, "%s,%d,%s,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d,%d,%d,%d,%d,%d,%.9g,%.9g,%u\n", name, (int)seed, engine, m->joint_max, m->joint_p99,
		m->joint_mean, m->overlap_max, m->overlap_p99, m->energy_pct, m->speed_max, m->speed_fall, m->moved_m, m->step_ms, m->step_max_ms, (int)m->steps,
		(int)m->broken, (int)m->at_limit, (int)m->bodies, (int)m->joints, (int)m->refused, m->joint_start,
		m->overlap_start, (unsigned)worse);
}

static void write_csv_head(FILE *file)
{
	if (file != NULL)
		fprintf(file, "family,seed,engine,joint_max_m,joint_p99_m,joint_mean_m,overlap_max_m,overlap_p99_m,energy_pct,speed_max_mps,speed_fall_mps,moved_m,step_ms,"
			      "step_max_ms,steps,broken,at_limit,bodies,joints,refused,joint_start_m,overlap_start_m,worse\n");
}

static int read_row(const char *line, char name[64], int *seed, scene_measures *m)
{
	int steps, broken, limit, bodies, joints, refused;
	memset(m, 0, sizeof *m);
	if (sscanf(line, "%63[^,],%d,%*[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%d,%d,%d,%d,%d,%d", name, seed, &m->joint_max, &m->joint_p99, &m->joint_mean, &m->overlap_max,
		    &m->overlap_p99, &m->energy_pct, &m->speed_max, &m->speed_fall, &m->moved_m, &m->step_ms, &m->step_max_ms, &steps, &broken, &limit, &bodies, &joints, &refused)
		!= 19)
		return 0;
	m->steps = steps;
	m->broken = broken;
	m->at_limit = limit;
	m->refused = refused;
	return 1;
}

/* Medians of a peer's rows of this seed. The file has families and seeds in the order in which they are asked for. */
static int find_peer(const settings *set, const char *name, int32_t seed, uint32_t flags, judged *out, scene_measures *first)
{
	double values[M_COUNT][RUNS_MAX];
	char line[512], found[64];
	int32_t count = 0;
	int at;
	while (set->peer != NULL && count < PEER_RUNS && fgets(line, (int)sizeof line, set->peer) != NULL) {
		scene_measures m;
		judged j;
		if (!read_row(line, found, &at, &m) || strcmp(found, name) != 0 || at != seed || m.refused)
			continue;
		m.flags = flags;
		j = to_judged(&m);
		if (count == 0)
			*first = m;
		keep_values(values, count++, &j);
	}
	if (count > 0)
		*out = median_judged(values, count);
	return count > 0;
}

static void print_side(const char *engine, const scene_measures *m)
{
	if (m->refused) {
		printf("    %-12s refused: %s\n", engine, m->refusal);
		return;
	}
	printf("    %-12s joint p99 %.3f max %.3f mean %.3f mm; overlap p99 %.3f max %.3f mm; energy %+.3f %%; speed %.2f m/s (fall %.1f)%s; moved %.1f mm; "
	       "step %.4f ms, slowest %.3f; %d steps%s\n",
		engine, 1e3 * m->joint_p99, 1e3 * m->joint_max, 1e3 * m->joint_mean, 1e3 * m->overlap_p99, 1e3 * m->overlap_max, m->energy_pct, m->speed_max, m->speed_fall,
		m->at_limit ? " LIMIT" : "", 1e3 * m->moved_m, m->step_ms, m->step_max_ms, (int)m->steps, m->broken > 0 ? "; BROKEN" : "");
}

static void print_seed(const settings *set, const family *which, const seed_result *r, const scene_measures *peer)
{
	run_settings direct = { CN_SOLVER_DIRECT, 0, 0 };
	scene_measures m = run_scene(which, r->seed, &direct);
	int32_t side;
	printf("%s, seed %d: %d bodies, %d joints; at the start joint %.3f, overlap %.3f mm\n", which->name, (int)r->seed, (int)m.bodies, (int)m.joints, 1e3 * m.joint_start,
		1e3 * m.overlap_start);
	for (side = 0; side < 2; ++side)
		print_side(set->names[side], &r->measures[side]);
	print_side("direct", &m);
	if (r->has_peer)
		print_side(set->peer_name, peer);
}

static void run_seed(const settings *set, const family *which, int32_t seed, seed_result *r)
{
	scene_measures peer;
	int32_t side;
	memset(r, 0, sizeof *r);
	r->seed = seed;
	for (side = 0; side < 2; ++side) {
		r->measures[side] = run_side(set, which, seed, side, 0);
		r->judged[side] = to_judged(&r->measures[side]);
	}
	r->worse = confirm_seed(set, which, seed, r->judged);
	r->has_peer = find_peer(set, which->name, seed, r->measures[0].flags, &r->peer, &peer);
	if (r->has_peer)
		r->worse_than_peer = worse_mask(&r->judged[0], &r->peer);
	for (side = 0; side < 2; ++side)
		write_csv(set->csv, which->name, seed, set->names[side], &r->measures[side], side == 0 ? r->worse : 0);
	if (set->seeds == 1)
		print_seed(set, which, r, &peer);
}

static double median_of(const seed_result *results, int32_t count, int32_t side, int32_t kind)
{
	double *values = malloc((size_t)(count + 1) * sizeof *values), result;
	int32_t k;
	if (values == NULL)
		exit(2);
	for (k = 0; k < count; ++k)
		values[k] = results[k].judged[side].value[kind];
	result = median(values, count);
	free(values);
	return result;
}

static void print_times(const seed_result *results, int32_t count)
{
	double *ratios = malloc((size_t)(count + 1) * sizeof *ratios), worst = 0.0, slow = 0.0;
	int32_t k, at = 0, slow_at = 0;
	if (ratios == NULL)
		exit(2);
	for (k = 0; k < count; ++k) {
		const scene_measures *m = results[k].measures;
		ratios[k] = m[0].step_ms / fmax(m[1].step_ms, 1e-6);
		if (ratios[k] > worst)
			worst = ratios[k], at = results[k].seed;
		if (m[0].step_max_ms > slow)
			slow = m[0].step_max_ms, slow_at = results[k].seed;
	}
	printf(" | time x%.2f, worst x%.1f (seed %d), slowest step %.1f ms (seed %d)\n", median(ratios, count), worst, (int)at, slow, (int)slow_at);
	free(ratios);
}

static const judged *other_of(const seed_result *r, int peer) { return peer ? &r->peer : &r->judged[1]; }

/* The worst seeds of one measure, as many as fit a line. */
static void print_worst(const seed_result *results, int32_t count, int32_t kind, int peer)
{
	int32_t k, shown, last = -1;
	double before = HUGE_VAL;
	printf("    %-8s", kinds[kind].name);
	for (shown = 0; shown < 6; ++shown) {
		int32_t most = -1;
		double at = -1.0;
		for (k = 0; k < count; ++k) {
			const seed_result *r = &results[k];
			double by = excess(&r->judged[0], other_of(r, peer), kind);
			int listed = by > before || (by == before && k <= last);
			if (((peer ? r->worse_than_peer : r->worse) >> kind & 1u) != 0 && !listed && by > at) {
				most = k;
				at = by;
			}
		}
		if (most < 0)
			break;
		last = most;
		before = at;
		printf("%s seed %d: %.3g against %.3g %s", shown > 0 ? ";" : "", (int)results[most].seed, kinds[kind].shown * results[most].judged[0].value[kind],
			kinds[kind].shown * other_of(&results[most], peer)->value[kind], kinds[kind].unit);
	}
	printf("\n");
}

static int32_t count_mask(const seed_result *results, int32_t count, int peer, uint32_t mask)
{
	int32_t k, sum = 0;
	for (k = 0; k < count; ++k)
		sum += ((peer ? results[k].worse_than_peer : results[k].worse) & mask) != 0;
	return sum;
}

static void print_peer(const settings *set, const seed_result *results, int32_t count)
{
	int32_t k, compared = 0;
	for (k = 0; k < count; ++k)
		compared += results[k].has_peer;
	if (set->peer == NULL)
		return;
	if (compared == 0) {
		printf("  %s cannot build it\n", set->peer_name);
		return;
	}
	printf("  worse than %s in %d of %d\n", set->peer_name, (int)count_mask(results, count, 1, UINT32_MAX), (int)compared);
	for (k = 0; k < M_COUNT; ++k)
		if (count_mask(results, count, 1, 1u << k) > 0)
			print_worst(results, count, k, 1);
}

static int32_t report_family(const settings *set, const family *which, const seed_result *results, int32_t count, double cpu_s)
{
	int32_t k, worse = count_mask(results, count, 0, UINT32_MAX);
	printf("%-13s %d seeds, %d worse", which->name, (int)count, (int)worse);
	for (k = 0; k < M_COUNT; ++k)
		if (worse > 0 && count_mask(results, count, 0, 1u << k) > 0)
			printf(", %s %d", kinds[k].name, (int)count_mask(results, count, 0, 1u << k));
	printf(" | medians");
	for (k = 0; k < M_BROKEN; ++k) {
		double a = median_of(results, count, 0, k), b = median_of(results, count, 1, k);
		if (a != 0.0 || b != 0.0)
			printf(" %s %.3g/%.3g %s", kinds[k].name, kinds[k].shown * a, kinds[k].shown * b, kinds[k].unit);
	}
	print_times(results, count);
	for (k = 0; k < M_COUNT; ++k)
		if (count_mask(results, count, 0, 1u << k) > 0)
			print_worst(results, count, k, 0);
	print_peer(set, results, count);
	if (getenv("FAMILIES_TIMES") != NULL)
		printf("    took %.1f s\n", cpu_s);
	fflush(stdout);
	return worse;
}

static void record_seed(const settings *set, const family *which, int32_t seed)
{
	int32_t repeat;
	for (repeat = 0; repeat < PEER_RUNS; ++repeat) {
		scene_measures m = run_side(set, which, seed, 0, repeat);
		write_csv(set->record, which->name, seed, set->names[0], &m, 0);
	}
}

static int32_t run_family(const settings *set, const family *which)
{
	seed_result *results = calloc((size_t)set->seeds, sizeof *results);
	double start = cpu_clock_s();
	int32_t k, worse;
	if (results == NULL)
		exit(2);
	for (k = 0; k < set->seeds; ++k) {
		if (set->record != NULL)
			record_seed(set, which, set->first + k);
		else
			run_seed(set, which, set->first + k, &results[k]);
	}
	worse = set->record != NULL ? 0 : report_family(set, which, results, set->seeds, cpu_clock_s() - start);
	free(results);
	return worse;
}

/* ---- more substeps ought not to be worse ---- */

static const int32_t substep_list[] = { 1, 2, 3, 4, 6, 8, 12, 16 };
#define SUBSTEP_COUNT FAMILY_COUNT(substep_list)

/* Compares each number of substeps with the best of all smaller ones. */
static uint32_t monotone_seed(const settings *set, const family *which, int32_t seed)
{
	static const int32_t measured[3] = { M_JOINT, M_OVERLAP, M_MOVED };
	judged all[sizeof substep_list / sizeof *substep_list];
	uint32_t mask = 0;
	int32_t k, m;
	for (k = 0; k < SUBSTEP_COUNT; ++k) {
		run_settings run;
		scene_measures got;
		run.solver = set->solvers[0];
		run.substeps = substep_list[k];
		run.noise = 0;
		got = run_scene(which, seed, &run);
		all[k] = to_judged(&got);
	}
	for (m = 0; m < 3; ++m) {
		int32_t kind = measured[m], best = 0, worst = -1;
		double most = 1.0;
		for (k = 1; k < SUBSTEP_COUNT; ++k) {
			double allowed = 2.0 * all[best].value[kind] + 0.001, by = all[k].value[kind] / allowed;
			if (by > most)
				most = by, worst = k;
			if (all[k].value[kind] < all[best].value[kind])
				best = k;
		}
		if (worst < 0)
			continue;
		mask |= 1u << kind;
		printf("    %s seed %d, %s:", which->name, (int)seed, kinds[kind].name);
		for (k = 0; k < SUBSTEP_COUNT; ++k)
			printf(" %d: %.3g%s", (int)substep_list[k], 1e3 * all[k].value[kind], k == worst ? "!" : "");
		printf(" mm\n");
	}
	return mask;
}

static int32_t monotone_family(const settings *set, const family *which)
{
	int32_t k, worse = 0;
	for (k = 0; k < set->seeds; ++k)
		worse += monotone_seed(set, which, set->first + k) != 0;
	printf("%-13s %d seeds, %d worse with more substeps (%s)\n", which->name, (int)set->seeds, (int)worse, set->names[0]);
	fflush(stdout);
	return worse;
}

/* ---- command line ---- */

static const struct family_table {
	const family *families;
	const int32_t *count;
} tables[] = {
	{ cloth_families, &cloth_family_count },
	{ mechanism_families, &mechanism_family_count },
	{ rope_families, &rope_family_count },
	{ figure_families, &figure_family_count },
	{ vehicle_families, &vehicle_family_count },
	{ structure_families, &structure_family_count },
	{ heap_families, &heap_family_count },
};

static int is_asked_for(const settings *set, const family *which)
{
	if (set->monotone && (which->flags & SCENE_STANDS) == 0)
		return 0;
	return set->family == NULL || strcmp(set->family, which->name) == 0;
}

static int32_t run_all(const settings *set, int32_t *out_families)
{
	int32_t t, k, worse = 0;
	for (t = 0; t < FAMILY_COUNT(tables); ++t)
		for (k = 0; k < *tables[t].count; ++k) {
			const family *which = &tables[t].families[k];
			if (!is_asked_for(set, which))
				continue;
			++*out_families;
			worse += set->monotone ? monotone_family(set, which) : run_family(set, which);
		}
	return worse;
}

static int32_t solver_named(const char *name)
{
	int32_t k;
	for (k = 0; k < FAMILY_COUNT(solver_names); ++k)
		if (strncmp(name, solver_names[k], strlen(solver_names[k])) == 0)
			return k;
	fprintf(stderr, "families: no solver %s\n", name);
	exit(2);
}

static void set_solvers(settings *set, const char *text)
{
	const char *comma = strchr(text, ',');
	set->solvers[0] = solver_named(text);
	set->solvers[1] = comma != NULL ? solver_named(comma + 1) : CN_SOLVER_SOFT;
	set->names[0] = solver_names[set->solvers[0]];
	set->names[1] = solver_names[set->solvers[1]];
}

static FILE *open_csv(const char *path)
{
	FILE *file = fopen(path, "w");
	if (file == NULL) {
		fprintf(stderr, "families: cannot write %s\n", path);
		exit(2);
	}
	write_csv_head(file);
	return file;
}

static void list_families(void)
{
	int32_t t, k;
	for (t = 0; t < FAMILY_COUNT(tables); ++t)
		for (k = 0; k < *tables[t].count; ++k)
			printf("%s\n", tables[t].families[k].name);
	exit(0);
}

static void set_peer(settings *set, const char *text)
{
	static char name[32];
	const char *equals = strchr(text, '=');
	size_t length = equals != NULL ? (size_t)(equals - text) : 0;
	if (length == 0 || length >= sizeof name)
		exit(2);
	memcpy(name, text, length);
	set->peer_name = name;
	set->peer = fopen(equals + 1, "r");
}

static int take_option(settings *set, const char *option, const char *value)
{
	if (strcmp(option, "--family") == 0)
		set->family = value;
	else if (strcmp(option, "--seeds") == 0)
		set->seeds = (int32_t)atoi(value);
	else if (strcmp(option, "--first") == 0)
		set->first = (int32_t)atoi(value);
	else if (strcmp(option, "--confirm") == 0)
		set->confirm = (int32_t)atoi(value);
	else if (strcmp(option, "--substeps") == 0)
		set->substeps = (int32_t)atoi(value);
	else if (strcmp(option, "--solvers") == 0)
		set_solvers(set, value);
	else if (strcmp(option, "--noise") == 0)
		set->noise = atoi(value);
	else if (strcmp(option, "--monotone") == 0)
		set->monotone = atoi(value);
	else if (strcmp(option, "--csv") == 0)
		set->csv = open_csv(value);
	else if (strcmp(option, "--record") == 0)
		set->record = open_csv(value);
	else if (strcmp(option, "--peer") == 0)
		set_peer(set, value);
	else
		return 0;
	return 1;
}

int main(int argc, char **argv)
{
	settings set;
	int32_t k, worse, families = 0;
	memset(&set, 0, sizeof set);
	set.seeds = 200;
	set.first = 1;
	set.confirm = 8;
	set_solvers(&set, "auto,soft");
	for (k = 1; k < argc; k += 2) {
		if (strcmp(argv[k], "--list") == 0)
			list_families();
		if (k + 1 >= argc || !take_option(&set, argv[k], argv[k + 1])) {
			fprintf(stderr, "families: what is %s?\n", argv[k]);
			return 2;
		}
	}
	if (set.seeds < 1 || set.confirm < 0 || set.confirm > CONFIRM_MAX) {
		fprintf(stderr, "families: seeds must be at least 1, confirm 0 to %d\n", CONFIRM_MAX);
		return 2;
	}
	if (set.noise) /* a solver against itself */
		set.solvers[0] = set.solvers[1], set.names[0] = set.names[1];
	worse = run_all(&set, &families);
	if (set.csv != NULL)
		fclose(set.csv);
	if (set.record != NULL)
		fclose(set.record);
	if (families == 0) {
		fprintf(stderr, "families: no family of this name\n");
		return 2;
	}
	if (set.record == NULL)
		printf("%d families, %d seeds each from %d: %d worse\n", (int)families, (int)set.seeds, (int)set.first, (int)worse);
	return worse > 0;
}
