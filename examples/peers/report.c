/*
 * examples/peers/report.c - from the CSV of a comparison: a Markdown table, a bar chart (SVG) and, as the last
 * line of output, the geometric mean of Box2D's time over Cairn's.
 *
 *     report in.csv out.md out.svg [quick]
 *
 * The mean takes each scene of each build in which both engines came through: a time without a result is not
 * a time. What it leaves out is counted.
 */
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROWS_MAX 512
#define FIELDS 17
#define BASE "Box2D 3.2"
#define OURS "Cairn"

enum { BUILD, SCENE, ENGINE, BODIES, STEPS, ROUNDS, MEAN, MEDIAN, P99, MAXIMUM, FIRST, DISPLACEMENT, JOINT, PENETRATION, LOST, HASH, VERDICT };

typedef struct row {
	char text[400];
	char *field[FIELDS];
} row;

typedef struct table {
	row rows[ROWS_MAX];
	int32_t count;
	const char *clock;   /* what times are of */
} table;

static table data;

/* ------------------------------------------------------------------ reading */

static int32_t split(row *r)
{
	int32_t count = 0;
	r->text[strcspn(r->text, "\r\n")] = '\0';
	for (char *p = r->text; count < FIELDS;) {
		r->field[count++] = p;
		p = strchr(p, ',');
		if (p == NULL)
			break;
		*p++ = '\0';
	}
	return count == FIELDS;
}

static int32_t read_table(const char *path)
{
	FILE *file = fopen(path, "r");
	if (file == NULL)
		return 0;
	while (data.count < ROWS_MAX && fgets(data.rows[data.count].text, (int)sizeof data.rows[0].text, file) != NULL) {
		row *r = &data.rows[data.count];
		if (split(r) && strcmp(r->field[BUILD], "build") != 0)
			++data.count;
	}
	fclose(file);
	return data.count > 0;
}

static double number(const row *r, int32_t field) { return strtod(r->field[field], NULL); }
static int32_t has_run(const row *r) { return strcmp(r->field[VERDICT], "not run") != 0; }
static int32_t has_failed(const row *r) { return strncmp(r->field[VERDICT], "FAILED", 6) == 0; }
static int32_t is_good(const row *r) { return has_run(r) && !has_failed(r) && number(r, MEAN) > 0.0; }

/* The same scene and build by another engine, NULL if there is none. */
static const row *other(const row *r, const char *engine)
{
	for (int32_t i = 0; i < data.count; ++i) {
		const row *o = &data.rows[i];
		if (strcmp(o->field[BUILD], r->field[BUILD]) == 0 && strcmp(o->field[SCENE], r->field[SCENE]) == 0 &&
			strcmp(o->field[ENGINE], engine) == 0)
			return o;
	}
	return NULL;
}

/* 1 when no row before this one has the same field. */
static int32_t is_first(int32_t index, int32_t field)
{
	for (int32_t i = 0; i < index; ++i) {
		if (strcmp(data.rows[i].field[field], data.rows[index].field[field]) == 0)
			return 0;
	}
	return 1;
}

/* ------------------------------------------------------------------ geometric mean */

typedef struct mean {
	double log_sum;
	int32_t count;
	int32_t left_out;
} mean;

/* build NULL: all. */
static mean mean_of(const char *build)
{
	mean m = {0.0, 0, 0};
	for (int32_t i = 0; i < data.count; ++i) {
		const row *ours = &data.rows[i];
		if (strcmp(ours->field[ENGINE], OURS) != 0 || (build != NULL && strcmp(ours->field[BUILD], build) != 0))
			continue;
		const row *base = other(ours, BASE);
		if (base == NULL || !is_good(base) || !is_good(ours)) {
			++m.left_out;
			continue;
		}
		m.log_sum += log(number(base, MEAN) / number(ours, MEAN));
		++m.count;
	}
	return m;
}

static double value_of(mean m) { return m.count > 0 ? exp(m.log_sum / (double)m.count) : 0.0; }

static void write_means(FILE *out)
{
	for (int32_t i = 0; i < data.count; ++i) {
		if (!is_first(i, BUILD))
			continue;
		mean m = mean_of(data.rows[i].field[BUILD]);
		if (m.count == 0)
			continue;
		fprintf(out, "geometric mean over %s, %s: %.3f (%" PRId32 " scenes", BASE, data.rows[i].field[BUILD], value_of(m), m.count);
		if (m.left_out > 0)
			fprintf(out, ", %" PRId32 " left out", m.left_out);
		fprintf(out, ")\n\n");
	}
}

/* ------------------------------------------------------------------ Markdown */

/* Metres in the CSV, millimetres here. */
static void write_length(FILE *out, const row *r, int32_t field)
{
	if (r->field[field][0] == '\0')
		fprintf(out, " |");
	else
		fprintf(out, " %.2f |", 1000.0 * number(r, field));
}

static void write_row(FILE *out, const row *r)
{
	const row *base = other(r, BASE);
	fprintf(out, "| %s | %s | %s |", r->field[SCENE], r->field[BUILD], r->field[ENGINE]);
	if (!has_run(r)) {
		fprintf(out, " | | | | | | | | | | not run |\n");
		return;
	}
	fprintf(out, " %.4f | %.4f | %.4f | %.4f | %.4f |", number(r, MEAN), number(r, MEDIAN), number(r, P99), number(r, MAXIMUM), number(r, FIRST));
	if (base != NULL && is_good(base) && is_good(r))
		fprintf(out, " %.2f |", number(base, MEAN) / number(r, MEAN));
	else
		fprintf(out, " |");
	write_length(out, r, DISPLACEMENT);
	write_length(out, r, JOINT);
	write_length(out, r, PENETRATION);
	fprintf(out, " %s | %s%s%s |\n", r->field[LOST], has_failed(r) ? "**" : "", r->field[VERDICT], has_failed(r) ? "**" : "");
}

static void write_markdown(FILE *out, int32_t quick)
{
	fprintf(out, "# Time and accuracy beside other engines\n\n");
	if (quick)
		fprintf(out, "**Quick run: a quarter of the steps, fewer rounds. Neither times nor errors are those of a whole run.**\n\n");
	fprintf(out, "%s, least of %s rounds; the ratio is %s's time over the row's\n", data.clock, data.rows[0].field[ROUNDS], BASE);
	fprintf(out, "(above 1: faster); errors in millimetres. How it is measured: examples/peers/README.md.\n\n");
	fprintf(out, "| scene | build | engine | ms mean | ms median | p99 | maximum | first step | ratio | displacement | joint gap | penetration | lost | verdict |\n");
	fprintf(out, "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
	for (int32_t i = 0; i < data.count; ++i)
		write_row(out, &data.rows[i]);
	fprintf(out, "\n");
	write_means(out);
}

/* ------------------------------------------------------------------ chart */

#define NAME_PX 140.0
#define PANEL_PX 500.0
#define TOP_PX 112.0
#define BAR_PX 12.0
#define GAP_PX 9.0
#define DECADES_LEFT 1.0  /* a panel reaches from a tenth of Box2D's time ... */
#define DECADES_RIGHT 1.0 /* ... to ten times it */

/* Engines in the order of the first scene. */
static int32_t engine_index(const row *r)
{
	int32_t index = 0;
	for (int32_t i = 0; i < data.count; ++i) {
		if (strcmp(data.rows[i].field[ENGINE], r->field[ENGINE]) == 0)
			return index;
		index += is_first(i, ENGINE);
	}
	return index;
}

static int32_t count_first(int32_t field)
{
	int32_t count = 0;
	for (int32_t i = 0; i < data.count; ++i)
		count += is_first(i, field);
	return count;
}

static const char *color_of(int32_t engine)
{
	static const char *const colors[] = {"#1f6f8b", "#d98032", "#8a8f98"};
	return colors[engine % 3];
}

static double place_of(double ratio)
{
	double decades = log10(ratio);
	decades = fmin(fmax(decades, -DECADES_LEFT), DECADES_RIGHT);
	return PANEL_PX * 0.72 * (decades + DECADES_LEFT) / (DECADES_LEFT + DECADES_RIGHT);
}

static void write_axis(FILE *svg, double left, double bottom)
{
	static const double ticks[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};
	for (size_t i = 0; i < sizeof ticks / sizeof ticks[0]; ++i) {
		double x = left + place_of(ticks[i]);
		fprintf(svg, "<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='%s'/>\n", x, TOP_PX - 6.0, x, bottom, ticks[i] > 0.99 && ticks[i] < 1.01 ? "#444" : "#ddd");
		fprintf(svg, "<text x='%.1f' y='%.1f' text-anchor='middle' class='s'>%gx</text>\n", x, TOP_PX - 11.0, ticks[i]);
	}
}

/* A bar begins at the left and ends at the engine's time as a multiple of Box2D's. */
static void write_bar(FILE *svg, const row *r, double left, double y)
{
	const row *base = other(r, BASE);
	char label[120];
	double length = 0.0;
	if (!has_run(r))
		snprintf(label, sizeof label, "not run");
	else if (has_failed(r))
		snprintf(label, sizeof label, "%s (%.3g ms)", r->field[VERDICT], number(r, MEAN));
	else
		snprintf(label, sizeof label, "%.3g ms", number(r, MEAN));
	if (has_run(r)) {
		double base_ms = base != NULL && has_run(base) ? number(base, MEAN) : number(r, MEAN);
		length = fmax(place_of(number(r, MEAN) / base_ms), 1.0);
		fprintf(svg, "<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='%s' fill-opacity='%s'/>\n", left, y, length, BAR_PX - 1.5,
			color_of(engine_index(r)), has_failed(r) ? "0.3" : "1");
	}
	fprintf(svg, "<text x='%.1f' y='%.1f' class='s' fill='%s'>%s</text>\n", left + length + 4.0, y + BAR_PX - 3.0, has_failed(r) ? "#b00020" : "#333", label);
}

static void write_legend(FILE *svg)
{
	double x = 20.0;
	for (int32_t i = 0; i < data.count; ++i) {
		if (!is_first(i, ENGINE))
			continue;
		fprintf(svg, "<rect x='%.1f' y='40' width='12' height='12' fill='%s'/>", x, color_of(engine_index(&data.rows[i])));
		fprintf(svg, "<text x='%.1f' y='50'>%s</text>\n", x + 17.0, data.rows[i].field[ENGINE]);
		x += 120.0;
	}
}

/* All scenes of one build. */
static void write_panel(FILE *svg, const char *build, double left, double bottom, double pitch)
{
	int32_t scene = 0;
	fprintf(svg, "<text x='%.1f' y='80' font-weight='bold'>%s build</text>\n", left, build);
	write_axis(svg, left, bottom);
	for (int32_t i = 0; i < data.count; ++i) {
		if (!is_first(i, SCENE))
			continue;
		double y = TOP_PX + pitch * (double)scene++;
		for (int32_t k = 0; k < data.count; ++k) {
			const row *r = &data.rows[k];
			if (strcmp(r->field[SCENE], data.rows[i].field[SCENE]) == 0 && strcmp(r->field[BUILD], build) == 0)
				write_bar(svg, r, left, y + BAR_PX * (double)engine_index(r));
		}
	}
}

static void write_chart(FILE *svg, int32_t quick)
{
	int32_t scene = 0, panel = 0;
	double pitch = BAR_PX * (double)count_first(ENGINE) + GAP_PX;
	double bottom = TOP_PX + pitch * (double)count_first(SCENE);
	double width = NAME_PX + PANEL_PX * (double)count_first(BUILD) + 20.0;
	fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f' font-family='sans-serif' font-size='13'>\n", width, bottom + 24.0);
	fprintf(svg, "<style>.s{font-size:10.5px;paint-order:stroke;stroke:#fff;stroke-width:3px}</style><rect width='100%%' height='100%%' fill='#fff'/>\n");
	fprintf(svg, "<text x='20' y='24' font-size='16'>CPU time of a step as a multiple of %s's (shorter is faster, logarithmic)%s</text>\n", BASE,
		quick ? " - QUICK RUN" : "");
	write_legend(svg);
	for (int32_t i = 0; i < data.count; ++i) {
		if (is_first(i, SCENE))
			fprintf(svg, "<text x='%.1f' y='%.1f' text-anchor='end'>%s</text>\n",
				NAME_PX - 10.0, TOP_PX + pitch * ((double)scene++ + 0.5) - 1.0, data.rows[i].field[SCENE]);
	}
	for (int32_t i = 0; i < data.count; ++i) {
		if (is_first(i, BUILD))
			write_panel(svg, data.rows[i].field[BUILD], NAME_PX + PANEL_PX * (double)panel++, bottom, pitch);
	}
	fprintf(svg, "</svg>\n");
}

/* ------------------------------------------------------------------ main */

static int32_t write_file(const char *path, void (*write)(FILE *out, int32_t quick), int32_t quick)
{
	FILE *file = fopen(path, "w");
	if (file == NULL) {
		fprintf(stderr, "report: cannot write %s\n", path);
		return 0;
	}
	write(file, quick);
	return fclose(file) == 0;
}

int main(int argc, char **argv)
{
	if (argc < 5) {
		fprintf(stderr, "usage: report in.csv out.md out.svg clock [quick]\n");
		return 2;
	}
	int32_t quick = argc > 5;
	data.clock = argv[4];
	if (!read_table(argv[1])) {
		fprintf(stderr, "report: no rows in %s\n", argv[1]);
		return 1;
	}
	if (!write_file(argv[2], write_markdown, quick) || !write_file(argv[3], write_chart, quick))
		return 1;
	write_markdown(stdout, quick);
	mean all = mean_of(NULL);
	if (all.count == 0)
		printf("geometric mean over %s: none (no scene in which both came through)\n", BASE);
	else
		printf("geometric mean over %s: %.3f\n", BASE, value_of(all));
	return 0;
}
