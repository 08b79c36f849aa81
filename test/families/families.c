/*
 * test/families/families.c - runs every family for many seeds, judges the default solver against another, and reports.
 *
 * Usage: families [--family name] [--seeds n] [--first n] [--solvers auto,soft] [--substeps n] [--noise 1] [--meddle kind] [--drift mps]
 *                 [--pace kind] [--surface kind] [--monotone 1]
 *                 [--confirm n] [--csv file] [--record file] [--peer name=file] [--list]
 * The README says what is judged and how.
 */
#include "judge.h"

#include <stdlib.h>
#include <string.h>

/* ---- one family ---- */

static void print_seed(const settings *set, const family *which, const seed_result *r, const scene_measures *peer)
{
	run_settings direct = { CN_SOLVER_DIRECT, 0, 0, 0.0, 0, 0, 0 };
	scene_measures m;
	int32_t side;
	direct.meddle = set->meddle;
	direct.drift_mps = set->drift_mps;
	direct.pace = set->pace;
	direct.surface = set->surface;
	m = run_scene(which, r->seed, &direct);
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
	r->first_worse[0] = worse_mask(&r->judged[0], &r->judged[1]);
	r->first_worse[1] = worse_mask(&r->judged[1], &r->judged[0]);
	r->worse = confirm_seed(set, which, seed, r->judged);
	confirm_time(set, which, r);
	r->has_peer = find_peer(set, which->name, seed, r->measures[0].flags, &r->peer, &peer);
	if (r->has_peer)
		r->worse_than_peer = worse_mask(&r->judged[0], &r->peer);
	for (side = 0; side < 2; ++side)
		write_csv(set->csv, which->name, seed, set->names[side], &r->measures[side], side == 0 ? r->worse : 0);
	if (set->seeds == 1)
		print_seed(set, which, r, &peer);
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
		run.meddle = 0;
		run.drift_mps = set->drift_mps;
		run.pace = set->pace;
		run.surface = set->surface;
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

static const char *const solver_names[] = { "auto", "soft", "direct", "sequential" };

static const struct family_table {
	const family *families;
	const int32_t *count;
} tables[] = {
	{ cloth_families, &cloth_family_count },
	{ mechanism_families, &mechanism_family_count },
	{ machine_families, &machine_family_count },
	{ rope_families, &rope_family_count },
	{ figure_families, &figure_family_count },
	{ vehicle_families, &vehicle_family_count },
	{ structure_families, &structure_family_count },
	{ heap_families, &heap_family_count },
	{ workshop_families, &workshop_family_count },
	{ compound_families, &compound_family_count },
	{ playground_families, &playground_family_count },
	{ contraption_families, &contraption_family_count },
	{ guided_families, &guided_family_count },
	{ area_families, &area_family_count },
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
	else if (strcmp(option, "--meddle") == 0)
		set->meddle = (int32_t)atoi(value);
	else if (strcmp(option, "--drift") == 0)
		set->drift_mps = atof(value);
	else if (strcmp(option, "--pace") == 0)
		set->pace = (int32_t)atoi(value);
	else if (strcmp(option, "--surface") == 0)
		set->surface = (int32_t)atoi(value);
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
