/*
 * examples/demo/page.c - one self-contained page, without scripts. It stays cheap to open: an animation
 * loads when it comes into view.
 */
#include "demo/page.h"
#include "demo/draw.h"
#include <inttypes.h>
#include <stdio.h>

static const char *const style =
	"body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1040px;padding:0 1rem;color:#2d3138;background:#fff}"
	"h1{margin-bottom:.2rem}section{margin:2rem 0;border-top:1px solid #dfe1e3;padding-top:1rem}"
	"img{border:1px solid #dfe1e3;max-width:100%;height:auto}.row{display:flex;flex-wrap:wrap;gap:1.2rem}"
	"td,th{text-align:left;padding:.1rem .8rem .1rem 0}td+td{font-variant-numeric:tabular-nums}"
	"i{display:inline-block;width:1em;height:1em;margin:0 .35em 0 1em;vertical-align:-.12em;border:1px solid #2d3138}code{font-size:13px}";

static void write_legend(FILE *f)
{
	static const struct { int32_t color; const char *text; } legend[] = {{DRAW_STATIC, "static"}, {DRAW_KINEMATIC, "kinematic"},
		{DRAW_AWAKE, "awake"}, {DRAW_ASLEEP, "asleep"}, {DRAW_CONTACT, "contact and its normal"}, {DRAW_JOINT, "joint"}};
	fputs("<p>", f);
	for (size_t i = 0; i < sizeof legend / sizeof legend[0]; ++i)
		fprintf(f, "<i style=\"background:#%06" PRIx32 "\"></i>%s", draw_colors[legend[i].color], legend[i].text);
	fputs("</p>\n", f);
}

static void write_row(FILE *f, const char *what, const char *format, double value)
{
	fprintf(f, "<tr><td>%s<td>", what);
	fprintf(f, format, value);
	fputs("\n", f);
}

static void write_scene(FILE *f, const demo_figures *d)
{
	fprintf(f, "<section id=\"%s\"><h2>%s</h2>\n<div class=\"row\">\n", d->name, d->title);
	fprintf(f, "<a href=\"%s.png\"><img src=\"%s.gif\" width=\"%" PRId32 "\" height=\"%" PRId32 "\" loading=\"lazy\" alt=\"%s\"></a>\n", d->name, d->name,
		d->width, d->height, d->title);
	fputs("<table>\n", f);
	write_row(f, "bodies", "%.0f", (double)d->bodies);
	write_row(f, "asleep at the end", "%.0f", (double)d->asleep);
	write_row(f, "contacts at the end", "%.0f", (double)d->contacts);
	write_row(f, "joints", "%.0f", (double)d->joints);
	write_row(f, "steps of 1/60 s", "%.0f", (double)d->steps);
	write_row(f, "ms a step, least", "%.3f", d->ms_min);
	write_row(f, "ms a step, median", "%.3f", d->ms_median);
	write_row(f, "ms a step, 99 of 100 below", "%.3f", d->ms_p99);
	write_row(f, "deepest penetration, mm", "%.2f", 1000.0 * (double)d->penetration_m);
	write_row(f, "largest joint error, mm", "%.2f", 1000.0 * (double)d->joint_error_m);
	fprintf(f, "<tr><td>state hash<td><code>%016" PRIx64 "</code>\n</table></div></section>\n", d->hash);
}

int32_t page_write(const char *folder, const demo_figures *figures, int32_t count)
{
	char path[512];
	snprintf(path, sizeof path, "%s/index.html", folder);
	FILE *f = fopen(path, "w");
	if (f == NULL)
		return 0;
	fprintf(f, "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
			   "<title>Cairn demo</title><style>%s</style>\n<h1>Cairn demo</h1>\n"
			   "<p>Every picture was drawn by this run. Click one for a still of its last frame at twice the size.</p>\n",
		style);
	write_legend(f);
	for (int32_t i = 0; i < count; ++i)
		write_scene(f, &figures[i]);
	fputs("</html>\n", f);
	return fclose(f) == 0;
}
