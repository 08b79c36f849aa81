/*
 * examples/demo/palette.h - the 255 colours of all pictures: the drawing colours and mixtures of every
 * two of them, which is what anti-aliased borders are made of. Entry 255 stays free for "transparent".
 */
#ifndef CAIRN_DEMO_PALETTE_H
#define CAIRN_DEMO_PALETTE_H

#include "demo/canvas.h"

#define PALETTE_MAX 255

typedef struct palette {
	int32_t count;
	uint8_t rgb[256 * 3];
	uint8_t nearest[32768]; /* entry by the top five bits of red, green and blue */
} palette;

void palette_make(palette *p, const canvas_color *colors, int32_t count);
/* One entry a pixel. */
void palette_apply(const palette *p, const canvas *c, uint8_t *out_pixels);

#endif
