/*
 * examples/demo/page.c - one self-contained page, without scripts. It stays cheap to open: an animation
 * loads when it comes into view.
 */
#include "demo/page.h"
#include "demo/draw.h"
#include <inttypes.h>
#include <stdio.h>

static const char *const style =
	"body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1120px;padding:0 1rem;color:#2d3138;background:#fff}"
	"h1{margin-bottom:.2rem}h2{margin:.2rem 0 .6rem}h3{margin:1.4rem 0 .4rem;font-size:15px}section{margin:2.5rem 0;border-top:1px solid #dfe1e3;padding-top:1rem}"
	"img{border:1px solid #dfe1e3;max-width:100%;height:auto;display:block}section>div{display:flex;flex-wrap:wrap;gap:0 1.6rem;border:0}"
	"dl{display:grid;grid-template-columns:repeat(auto-fill,minmax(215px,1fr));align-content:start;gap:.1rem 1.2rem;margin:.4rem 0;flex:1 1 215px;font-size:14px}"
	"dl div{display:flex;justify-content:space-between;border-bottom:1px solid #f0f0ee}"
	"ul{display:grid;grid-template-columns:1fr 1fr 1fr;list-style:none;padding:0;margin:.4rem 0;max-width:100%;font-size:14px}"
	"dt{color:#6a7078}dd{margin:0;white-space:nowrap;font-variant-numeric:tabular-nums}"
	"i{display:inline-block;width:1em;height:1em;margin:0 .35em 0 1em;vertical-align:-.12em;border:1px solid #2d3138}code{font-size:13px}";

static void write_legend(FILE *f)
{
	static const struct { int32_t color; const char *text; } legend[] = {{DRAW_STATIC, "static"}, {DRAW_KINEMATIC, "kinematic"}};
	fputs("<p>A colour for each body, paler asleep;", f);
	for (size_t i = 0; i < sizeof legend / sizeof legend[0]; ++i)
		fprintf(f, "<i style=\"background:#%06" PRIx32 "\"></i>%s", draw_colors[legend[i].color], legend[i].text);
	fputs("</p>\n<p><b>Overlap at rest</b>: how deep bodies slower than 2 cm/s at the end are in each other; the error of a pile. "
		  "<b>Worst overlap in motion</b>: the deepest of the whole run, also of bodies that hit each other at that moment. "
		  "<b>Largest joint error</b>: the widest gap of a joint in the whole run.</p>\n", f);
}

static void write_row(FILE *f, const char *what, const char *format, double value)
{
	fprintf(f, "<div><dt>%s</dt><dd>", what);
	fprintf(f, format, value);
	fputs("</dd></div>\n", f);
}

static void write_scene(FILE *f, const demo_figures *d)
{
	fprintf(f, "<section id=\"%s\"><h2>%s</h2>\n", d->name, d->title);
	fprintf(f, "<div><a href=\"%s.png\"><img src=\"%s.gif\" width=\"%" PRId32 "\" height=\"%" PRId32 "\" loading=\"lazy\" alt=\"%s\"></a>\n",
		d->name, d->name, d->width, d->height, d->title);
	fputs("<dl>\n", f);
	write_row(f, "bodies", "%.0f", (double)d->bodies);
	write_row(f, "joints", "%.0f", (double)d->joints);
	write_row(f, "contacts at the end", "%.0f", (double)d->contacts);
	write_row(f, "asleep at the end", "%.0f", (double)d->asleep);
	write_row(f, "step, median", "%.3f ms", d->ms_median);
	write_row(f, "99 of 100 steps below", "%.3f ms", d->ms_p99);
	if (d->rest_points > 0)
		write_row(f, "overlap at rest", "%.3f mm", 1000.0 * (double)d->rest_overlap_m);
	write_row(f, "worst overlap in motion", "%.1f mm", 1000.0 * (double)d->motion_overlap_m);
	if (d->joints > 0)
		write_row(f, "largest joint error", "%.2f mm", 1000.0 * (double)d->joint_error_m);
	fprintf(f, "<div><dt>hash</dt><dd><code>%016" PRIx64 "</code></dd></div>\n</dl></div></section>\n", d->hash);
}

static void write_duel(FILE *f, const duel_figures *d)
{
	fprintf(f, "<h3>%s</h3>\n<img src=\"%s.gif\" width=\"%" PRId32 "\" height=\"%" PRId32 "\" loading=\"lazy\" alt=\"%s\">\n<ul style=\"width:%" PRId32 "px\">",
		d->title, d->name, d->width, d->height, d->title, d->width);
	for (int32_t e = 0; e < d->engines; ++e)
		fprintf(f, "<li><b>%s</b> %s</li>", d->engine[e], d->verdict[e]);
	fputs("</ul>\n", f);
}

static void write_duels(FILE *f, const duel_figures *duels, int32_t count)
{
	if (count == 0)
		return;
	fputs("<section id=\"engines\"><h2>The same scene in other engines</h2>\n<p>Default settings of each engine, 60 steps a second, the same "
		  "program to the line (<code>test/stability</code>). The films of the other engines are stored; <code>make demo PEERS=1</code> makes them "
		  "anew. Scenes in which the others are as good or better are in <a href=\"../../test/stability/chart/README.md\">the chart</a>.</p>\n", f);
	for (int32_t i = 0; i < count; ++i)
		write_duel(f, &duels[i]);
	fputs("</section>\n", f);
}

int32_t page_write(const char *folder, const demo_figures *figures, int32_t count, int32_t first, const duel_figures *duels, int32_t duel_count)
{
	char path[512];
	snprintf(path, sizeof path, "%s/index.html", folder);
	FILE *f = fopen(path, "w");
	if (f == NULL)
		return 0;
	fprintf(f, "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
			   "<title>Cairn demo</title><style>%s</style>\n<h1>Cairn demo</h1>\n"
			   "<p>Every picture was drawn by this run. Click one for a larger still of its last frame; <code>make testbed-web</code> lets you play "
			   "with all of them.</p>\n",
		style);
	write_legend(f);
	for (int32_t i = 0; i < count; ++i) {
		if (i == first)
			write_duels(f, duels, duel_count);
		write_scene(f, &figures[i]);
	}
	if (first >= count)
		write_duels(f, duels, duel_count);
	fputs("</html>\n", f);
	return fclose(f) == 0;
}
