/*
 * test/stability/stability.c - the stability suite: command line, choice of cases, judging and printing.
 *
 *     stability [pattern...] [options]     see README.md, or stability --help
 *
 * Every metric is a row of the CSV; every bound is a promise that passed or failed. Exit code 1 when one failed.
 */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATTERNS_MAX 64
#define NAME_BYTES 96

typedef struct solver_name {
	const char *name;
	int32_t solver;
	int sequential; /* one iteration a step: substeps mean nothing */
} solver_name;

static const solver_name solvers[] = {
	{ "auto", CN_SOLVER_AUTO, 0 },
	{ "soft", CN_SOLVER_SOFT, 0 },
	{ "direct", CN_SOLVER_DIRECT, 0 },
	{ "sequential", CN_SOLVER_SEQUENTIAL, 1 },
};
#define SOLVER_COUNT ((int32_t)(sizeof solvers / sizeof *solvers))

typedef struct request {
	scene_settings settings;
	const char *patterns[PATTERNS_MAX];
	int32_t pattern_count;
	const char *family; /* NULL: cases */
	const char *csv_path, *film_path;
	int list, sweep;
	char parameters[512]; /* all --set, joined */
} request;

typedef struct tally {
	FILE *csv;
	int32_t passed, failed, skipped;
} tally;

static const char help[] =
	"stability [pattern...] [options]\n"
	"  pattern             cases whose name contains it\n"
	"  --family name       a family by itself, without bounds: a case that is not in the list\n"
	"  --list              cases and families with their parameters\n"
	"  --set name=value    a parameter, for every case that is run; may be repeated\n"
	"  --solver name       auto, soft, direct or sequential\n"
	"  --substeps n        1 to 64\n"
	"  --dt 1/120          seconds a frame, a number or a fraction\n"
	"  --seconds s         simulated time\n"
	"  --csv file          every metric as a row\n"
	"  --film file         what the run looks like: film.c; of one case\n"
	"  --sweep             the cases of the chart, for every solver and 1, 2, 4, 8, 16 substeps\n";

/* ---- command line ---- */

static void refuse(const char *what, const char *word)
{
	fprintf(stderr, "stability: %s: %s\n%s", what, word, help);
	exit(2);
}

static double number_or_fraction(const char *text)
{
	char *end;
	double value = strtod(text, &end);
	if (*end == '/')
		value /= strtod(end + 1, &end);
	if (*end != '\0' || !(value > 0.0) || value > 1e9)
		refuse("not a number above 0", text);
	return value;
}

static const solver_name *find_solver(const char *name)
{
	int32_t k;
	for (k = 0; k < SOLVER_COUNT; ++k)
		if (strcmp(solvers[k].name, name) == 0)
			return &solvers[k];
	refuse("no such solver", name);
	return NULL;
}

static void use_solver(scene_settings *settings, const solver_name *solver)
{
	settings->solver_name = solver->name;
	settings->solver = solver->solver;
}

static int is_parameter(const char *name)
{
	double value;
	int32_t k;
	for (k = 0; k < scene_case_count; ++k) {
		const scene_family *family = scene_family_find(scene_cases[k].family);
		if (family != NULL && values_find(family->parameters, name, &value))
			return 1;
	}
	return values_find(SCENE_COMMON, name, &value);
}

/* Later settings stand first: the first of a name is found. */
static void add_parameter(request *r, const char *text)
{
	char joined[sizeof r->parameters], name[NAME_BYTES];
	size_t length = strcspn(text, "=");
	if (text[length] == '\0' || strchr(text, ' ') != NULL || length >= sizeof name)
		refuse("not name=value", text);
	memcpy(name, text, length);
	name[length] = '\0';
	if (!is_parameter(name))
		refuse("no family has this parameter", name);
	if ((size_t)snprintf(joined, sizeof joined, "%s %s", text, r->parameters) >= sizeof joined)
		refuse("too many settings", text);
	memcpy(r->parameters, joined, sizeof joined);
}

static void take_option(request *r, const char *name, const char *value)
{
	if (value == NULL)
		refuse("needs a value", name);
	if (strcmp(name, "--set") == 0)
		add_parameter(r, value);
	else if (strcmp(name, "--family") == 0)
		r->family = value;
	else if (strcmp(name, "--solver") == 0)
		use_solver(&r->settings, find_solver(value));
	else if (strcmp(name, "--substeps") == 0)
		r->settings.substeps = (int32_t)number_or_fraction(value);
	else if (strcmp(name, "--dt") == 0)
		r->settings.dt_s = number_or_fraction(value);
	else if (strcmp(name, "--seconds") == 0)
		r->settings.seconds = number_or_fraction(value);
	else if (strcmp(name, "--csv") == 0)
		r->csv_path = value;
	else if (strcmp(name, "--film") == 0)
		r->film_path = value;
	else
		refuse("no such option", name);
}

static void read_arguments(request *r, int argc, char **argv)
{
	int k;
	use_solver(&r->settings, &solvers[0]);
	r->settings.parameters = r->parameters;
	for (k = 1; k < argc; ++k)
		if (strcmp(argv[k], "--list") == 0)
			r->list = 1;
		else if (strcmp(argv[k], "--sweep") == 0)
			r->sweep = 1;
		else if (strcmp(argv[k], "--help") == 0) {
			printf("%s", help);
			exit(0);
		} else if (strncmp(argv[k], "--", 2) == 0) {
			take_option(r, argv[k], k + 1 < argc ? argv[k + 1] : NULL);
			++k;
		} else if (r->pattern_count < PATTERNS_MAX)
			r->patterns[r->pattern_count++] = argv[k];
}

static void list_all(void)
{
	const scene_family *family = NULL;
	int32_t k;
	printf("every family: %s\n", SCENE_COMMON);
	for (k = 0; k < scene_case_count; ++k) {
		const scene_case *c = &scene_cases[k];
		if (scene_family_find(c->family) != family) {
			family = scene_family_find(c->family);
			printf("%s: %s\n", family->name, family->parameters);
		}
		printf("    %-26s %-30s %s\n", c->name, c->parameters, c->bounds);
	}
}

/* ---- judging ---- */

static const scene_metric *find_metric(const scene_run *run, const char *name)
{
	int32_t k;
	for (k = 0; k < run->metric_count; ++k)
		if (strcmp(run->metrics[k].name, name) == 0)
			return &run->metrics[k];
	return NULL;
}

/* "default", "ss4", "ss4 dt0.0083": what was asked for. */
static void setting_text(const scene_settings *settings, char *text, size_t bytes)
{
	size_t used = (size_t)snprintf(text, bytes, settings->substeps > 0 ? "ss%d" : "default", (int)settings->substeps);
	if (settings->dt_s > 0.0 && used < bytes)
		snprintf(text + used, bytes - used, " dt%g", settings->dt_s);
}

static double us_per_frame(const scene_run *run) { return run->frame > 0 ? 1e6 * run->cpu_s / (double)run->frame : 0.0; }

static void write_row(const tally *t, const scene_run *run, const char *name, const scene_settings *settings, const scene_metric *metric, const values_bound *bound, int passed)
{
	char setting[64];
	if (t->csv == NULL)
		return;
	setting_text(settings, setting, sizeof setting);
	fprintf(t->csv, "%s,%s,%s,%s,%.9g,", name, settings->solver_name, setting, metric->name, metric->value);
	if (bound != NULL)
		fprintf(t->csv, "%s%g,%d,", bound->at_most ? "<=" : ">=", bound->bound, passed);
	else
		fprintf(t->csv, ",,");
	fprintf(t->csv, "%.3f\n", us_per_frame(run));
}

/* One row for each bound, one for each metric without any. Prints what failed, and the rest unless quiet. */
static void judge(tally *t, const scene_run *run, const char *name, const char *bounds, const scene_settings *settings, int quiet)
{
	values_bound bound;
	const char *text = bounds;
	int32_t k;
	while (values_next_bound(&text, &bound)) {
		const scene_metric *metric = find_metric(run, bound.metric);
		int passed;
		if (metric == NULL)
			refuse("a bound for a metric that is not measured", bound.metric);
		passed = bound.at_most ? metric->value <= bound.bound : metric->value >= bound.bound;
		t->passed += passed;
		t->failed += !passed;
		if (!passed || !quiet)
			printf("%s %-26s %-24s %12.6g %s %-8g %10.2f us\n", passed ? "ok  " : "FAIL", name, metric->name, metric->value, bound.at_most ? "<=" : ">=", bound.bound, us_per_frame(run));
		write_row(t, run, name, settings, metric, &bound, passed);
	}
	for (k = 0; k < run->metric_count; ++k) {
		const scene_metric *metric = &run->metrics[k];
		size_t length = strlen(metric->name);
		const char *found = strstr(bounds, metric->name);
		if (found != NULL && (found[length] == '<' || found[length] == '>'))
			continue;
		if (!quiet)
			printf("     %-26s %-24s %12.6g\n", name, metric->name, metric->value);
		write_row(t, run, name, settings, metric, NULL, 0);
	}
}

/* ---- running ---- */

static void run_case(tally *t, const scene_case *which, const char *name, const scene_settings *settings, int quiet)
{
	const scene_family *family = scene_family_find(which->family);
	scene_run run;
	if (family == NULL)
		refuse("no such family", which->family);
	if (scene_execute(&run, family, which, settings))
		judge(t, &run, name, which->bounds, settings, quiet);
	else {
		++t->skipped;
		printf("skip %-26s %s\n", name, run.refusal);
	}
	fflush(stdout);
	scene_dispose(&run);
}

static void run_seeds(tally *t, const scene_case *which, const scene_settings *settings)
{
	int32_t seed, failed = t->failed;
	for (seed = 1; seed <= which->seeds; ++seed) {
		char name[NAME_BYTES], parameters[NAME_BYTES];
		scene_case one = *which;
		snprintf(name, sizeof name, "%s_seed%d", which->name, (int)seed);
		snprintf(parameters, sizeof parameters, "seed=%d %s", (int)seed, which->parameters);
		one.parameters = parameters;
		run_case(t, &one, name, settings, 1);
	}
	printf("     %-26s seeds 1 to %d, %d bounds broken\n", which->name, (int)which->seeds, (int)(t->failed - failed));
}

static int is_wanted(const request *r, const char *name)
{
	int32_t k;
	for (k = 0; k < r->pattern_count; ++k)
		if (strstr(name, r->patterns[k]) != NULL)
			return 1;
	return r->pattern_count == 0 && r->family == NULL;
}

static void run_cases(tally *t, const request *r, const scene_settings *settings)
{
	int32_t k;
	for (k = 0; k < scene_case_count; ++k) {
		const scene_case *c = &scene_cases[k];
		int in_chart = c->name[0] >= '0' && c->name[0] <= '9';
		if (!is_wanted(r, c->name) || (r->sweep && r->pattern_count == 0 && !in_chart))
			continue;
		if (c->seeds > 0)
			run_seeds(t, c, settings);
		else
			run_case(t, c, c->name, settings, 0);
	}
	if (r->family != NULL) {
		scene_case own = { NULL, NULL, "", "", 0 };
		own.family = r->family;
		run_case(t, &own, own.family, settings, 0);
	}
}

static void sweep(tally *t, const request *r)
{
	static const int32_t substeps[] = { 1, 2, 4, 8, 16 };
	int32_t s, k;
	for (s = 0; s < SOLVER_COUNT; ++s) {
		scene_settings settings = r->settings;
		use_solver(&settings, &solvers[s]);
		for (k = 0; k < (int32_t)(sizeof substeps / sizeof *substeps); ++k) {
			if (solvers[s].sequential && k > 0)
				break;
			settings.substeps = substeps[k];
			printf("---- %s, %d substeps\n", settings.solver_name, (int)settings.substeps);
			run_cases(t, r, &settings);
		}
	}
}

int main(int argc, char **argv)
{
	static request r;
	tally t = { NULL, 0, 0, 0 };
	read_arguments(&r, argc, argv);
	if (r.list) {
		list_all();
		return 0;
	}
	if (r.film_path != NULL && (r.settings.film = fopen(r.film_path, "w")) == NULL)
		refuse("cannot write", r.film_path);
	if (r.csv_path != NULL) {
		t.csv = fopen(r.csv_path, "w");
		if (t.csv == NULL)
			refuse("cannot write", r.csv_path);
		fprintf(t.csv, "scene,solver,setting,metric,value,bound,pass,us_per_frame\n");
	}
	if (r.sweep)
		sweep(&t, &r);
	else
		run_cases(&t, &r, &r.settings);
	if (r.settings.film != NULL && fclose(r.settings.film) != 0)
		refuse("cannot write", r.film_path);
	if (t.csv != NULL && fclose(t.csv) != 0)
		refuse("cannot write", r.csv_path);
	printf("%d passed, %d failed, %d skipped\n", (int)t.passed, (int)t.failed, (int)t.skipped);
	return t.failed != 0;
}
