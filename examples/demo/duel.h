/*
 * examples/demo/duel.h - scenes of the stability suite side by side: this library and other engines, from films that
 * test/stability/film.c wrote.
 */
#ifndef CAIRN_DEMO_DUEL_H
#define CAIRN_DEMO_DUEL_H

#include "demo/palette.h"

#include <stdint.h>

#define DUEL_ENGINES 3

typedef struct duel_figures {
	const char *name;
	const char *title;
	int32_t width, height;          /* of the animation */
	int32_t engines;                /* films found, this library's first */
	const char *engine[DUEL_ENGINES];
	char verdict[DUEL_ENGINES][64]; /* what the suite measured */
} duel_figures;

int32_t duel_count(void);
/* Reads films/<scene>_<engine>.film and writes folder/<scene>.gif. 0 when there is no film of this library, or the animation cannot be
   written. */
int32_t duel_make(int32_t index, const char *films, const char *folder, const palette *colors, duel_figures *out);

#endif
