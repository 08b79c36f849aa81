/*
 * examples/demo/palette.c - making the palette and finding nearest entries by a table of 32 x 32 x 32.
 */
#include "demo/palette.h"
#include <string.h>

static void add_entry(palette *p, canvas_color a, canvas_color b, int32_t quarters)
{
	if (p->count >= PALETTE_MAX)
		return;
	uint8_t *entry = p->rgb + 3 * p->count++;
	for (int32_t i = 0; i < 3; ++i) {
		int32_t shift = 16 - 8 * i, from = (int32_t)((a >> shift) & 255u), to = (int32_t)((b >> shift) & 255u);
		entry[i] = (uint8_t)(from + (to - from) * quarters / 4);
	}
}

static int32_t find_nearest(const palette *p, int32_t r, int32_t g, int32_t b)
{
	int32_t best = 0, best_distance = 1 << 30;
	for (int32_t i = 0; i < p->count; ++i) {
		int32_t dr = r - p->rgb[3 * i], dg = g - p->rgb[3 * i + 1], db = b - p->rgb[3 * i + 2];
		int32_t distance = 3 * dr * dr + 6 * dg * dg + db * db; /* the eye sees green best */
		if (distance < best_distance) {
			best_distance = distance;
			best = i;
		}
	}
	return best;
}

static int32_t cell_of(const uint8_t *rgb) { return (rgb[0] >> 3) << 10 | (rgb[1] >> 3) << 5 | rgb[2] >> 3; }

void palette_make(palette *p, const canvas_color *colors, int32_t count)
{
	memset(p, 0, sizeof *p);
	for (int32_t i = 0; i < count; ++i)
		add_entry(p, colors[i], colors[i], 0);
	for (int32_t i = 0; i < count; ++i) {
		for (int32_t j = i + 1; j < count; ++j) {
			add_entry(p, colors[i], colors[j], 2);
			add_entry(p, colors[i], colors[j], 1);
			add_entry(p, colors[i], colors[j], 3);
		}
	}
	for (int32_t cell = 0; cell < 32768; ++cell)
		p->nearest[cell] = (uint8_t)find_nearest(p, (cell >> 10) * 8 + 4, (cell >> 5 & 31) * 8 + 4, (cell & 31) * 8 + 4);
	/* Pure colours stay exactly themselves. */
	for (int32_t i = count - 1; i >= 0; --i)
		p->nearest[cell_of(p->rgb + 3 * i)] = (uint8_t)i;
}

void palette_apply(const palette *p, const canvas *c, uint8_t *out_pixels)
{
	for (int32_t i = 0; i < c->width * c->height; ++i)
		out_pixels[i] = p->nearest[cell_of(c->rgb + 3 * i)];
}
