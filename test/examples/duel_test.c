/*
 * test/examples/duel_test.c - films of several engines become one animation: sizes, positions of bodies in its panels, verdicts, films
 * that are missing or end early. The films that are stored are those of the scenes.
 */
#include "demo/duel.h"
#include "demo/draw.h"
#include "demo/gif.h"
#include "test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char folder[512]; /* of this program: what it writes lies beside it */
static palette colors;

static void path_of(char *path, size_t bytes, const char *name) { snprintf(path, bytes, "%s/%s", folder, name); }

static void write_film(const char *name, const char *text)
{
	char path[600];
	FILE *file;
	path_of(path, sizeof path, name);
	file = fopen(path, "w");
	REQUIRE(file != NULL);
	fputs(text, file);
	CHECK(fclose(file) == 0);
}

static void forget(const char *name)
{
	char path[600];
	path_of(path, sizeof path, name);
	remove(path);
}

static int32_t index_of(const char *name)
{
	duel_figures figures;
	int32_t k;
	for (k = 0; k < duel_count(); ++k) {
		duel_make(k, "no such folder", folder, &colors, &figures);
		if (strcmp(figures.name, name) == 0)
			return k;
	}
	return -1;
}

static const char standing[] = "body 0 -1000 0 0\nbox 200 1\nbody 0 500 0 1\nbox 0.5 0.5\nframe .\nframe 0,0,0\nmetric stands 1\n";
static const char falling[] = "body 0 -1000 0 0\nbox 200 1\nbody 0 500 0 1\nbox 0.5 0.5\nframe 1000,0,10\nmetric stands 0\nmetric t_fall_s 0.44\n";

static void each_engine_has_a_panel_and_a_verdict(void)
{
	duel_figures figures;
	int32_t top = index_of("top");
	REQUIRE(top >= 0);
	write_film("top_cairn.film", standing);
	write_film("top_chipmunk.film", falling);
	forget("top_box2d.film");
	CHECK(duel_make(top, folder, folder, &colors, &figures) && figures.engines == 2);
	CHECK(strcmp(figures.verdict[0], "stands") == 0 && strcmp(figures.verdict[1], "falls after 0.4 s") == 0);
	CHECK(strcmp(figures.engine[1], "Chipmunk 7") == 0);
	write_film("top_box2d.film", falling);
	int32_t two = figures.width;
	CHECK(duel_make(top, folder, folder, &colors, &figures) && figures.engines == 3 && figures.width > two + 100);
}

static void lengths_are_readable(void)
{
	static const struct { const char *metric, *words; } rows[] = {
		{"metric joint_stretch_max_m 10.24\n", "joints open by 10.2 m"}, {"metric joint_stretch_max_m 0.0000021\n", "joints open by 0.002 mm"},
		{"metric joint_stretch_max_m 1e-9\n", "joints open by less than 1 \302\265m"}, {"metric tip_sag_max_m 0.25\nmetric joint_stretch_max_m 1\n", "the end sags by 0.25 m"},
	};
	int32_t chain = index_of("chain"), k;
	REQUIRE(chain >= 0);
	for (k = 0; k < (int32_t)(sizeof rows / sizeof rows[0]); ++k) {
		char text[256];
		duel_figures figures;
		snprintf(text, sizeof text, "body 0 0 0 1\ncircle 0.5\nframe 5,5,5\n%s", rows[k].metric);
		write_film("chain_cairn.film", text);
		CHECK(duel_make(chain, folder, folder, &colors, &figures));
		if (strcmp(figures.verdict[0], rows[k].words) != 0) {
			printf("  %s\n", figures.verdict[0]);
			test_fail(__FILE__, __LINE__, rows[k].words);
		}
	}
}

/* Without a film of this library there is nothing to compare with. */
static void what_is_missing_is_left_out(void)
{
	duel_figures figures;
	int32_t top = index_of("top");
	forget("top_cairn.film");
	write_film("top_box2d.film", falling);
	CHECK(!duel_make(top, folder, folder, &colors, &figures));
	write_film("top_cairn.film", "body 0 0 0 1\nno such shape\npolygon 1\nframe 1,2\nframe\nframe x y z\n");
	CHECK(duel_make(top, folder, folder, &colors, &figures) && figures.verdict[0][0] == '\0');
}

static void stored_films_are_of_the_scenes(void)
{
	static const char *const engines[] = {"box2d", "chipmunk"};
	int32_t e, k, frames = 0;
	for (k = 0; k < duel_count(); ++k)
		for (e = 0; e < 2; ++e) {
			duel_figures figures;
			char path[600], line[8192];
			FILE *file;
			duel_make(k, "no such folder", folder, &colors, &figures);
			snprintf(path, sizeof path, "examples/demo/films/%s_%s.film", figures.name, engines[e]);
			file = fopen(path, "r");
			CHECK(file != NULL);
			while (file != NULL && fgets(line, sizeof line, file) != NULL)
				frames += strncmp(line, "frame", 5) == 0;
			if (file != NULL)
				fclose(file);
		}
	CHECK_GE("frames stored", frames, 120 * 2 * duel_count(), "");
}

int main(int argc, char **argv)
{
	char *slash;
	test_begin(argc, argv);
	snprintf(folder, sizeof folder, "%s", argv[0]);
	slash = strrchr(folder, '/');
	if (slash != NULL)
		*slash = '\0';
	palette_make(&colors, draw_colors, DRAW_COLORS);
	RUN(each_engine_has_a_panel_and_a_verdict);
	RUN(lengths_are_readable);
	RUN(what_is_missing_is_left_out);
	RUN(stored_films_are_of_the_scenes);
	return test_end();
}
