/*
 * examples/demo/gif.c - container and LZW coding (Welch, "A technique for high-performance data
 * compression", 1984): codes grow from 9 to 12 bits, then the table starts anew. The table is a hash
 * of (prefix code, next pixel) with linear probing.
 */
#include "demo/gif.h"
#include <stdlib.h>
#include <string.h>

#define TRANSPARENT 255
#define CODE_CLEAR 256
#define CODE_END 257
#define CODE_FIRST 258
#define CODE_LIMIT 4096
#define HASH_SLOTS 16384

/* ------------------------------------------------------------------ bytes */

static void put_bytes(gif *g, const void *bytes, size_t count)
{
	if (fwrite(bytes, 1, count, g->file) != count)
		g->failed = 1;
}

static void put_byte(gif *g, int32_t byte)
{
	uint8_t b = (uint8_t)byte;
	put_bytes(g, &b, 1);
}

static void put_word(gif *g, int32_t word)
{
	put_byte(g, word & 255);
	put_byte(g, word >> 8 & 255);
}

/* ------------------------------------------------------------------ codes into blocks of 255 bytes */

typedef struct bit_writer {
	gif *g;
	uint32_t bits;
	int32_t bit_count;
	int32_t byte_count;
	uint8_t block[255];
} bit_writer;

static void flush_block(bit_writer *w)
{
	if (w->byte_count == 0)
		return;
	put_byte(w->g, w->byte_count);
	put_bytes(w->g, w->block, (size_t)w->byte_count);
	w->byte_count = 0;
}

static void put_block_byte(bit_writer *w)
{
	w->block[w->byte_count++] = (uint8_t)w->bits;
	if (w->byte_count == 255)
		flush_block(w);
}

static void put_code(bit_writer *w, int32_t code, int32_t width)
{
	w->bits |= (uint32_t)code << w->bit_count;
	w->bit_count += width;
	for (; w->bit_count >= 8; w->bit_count -= 8) {
		put_block_byte(w);
		w->bits >>= 8;
	}
}

static void finish_codes(bit_writer *w)
{
	if (w->bit_count > 0)
		put_block_byte(w);
	flush_block(w);
	put_byte(w->g, 0);
}

/* ------------------------------------------------------------------ LZW */

typedef struct lzw_table {
	int32_t next;  /* code to be given out next */
	int32_t width; /* bits of a code */
	int32_t keys[HASH_SLOTS]; /* prefix << 8 | pixel, plus 1; 0: empty */
	int16_t codes[HASH_SLOTS];
} lzw_table;

static void reset_table(lzw_table *t)
{
	t->next = CODE_FIRST;
	t->width = 9;
	memset(t->keys, 0, sizeof t->keys);
}

/* Slot of the pair, or the empty one where it belongs. */
static int32_t find_slot(const lzw_table *t, int32_t key)
{
	uint32_t slot = (uint32_t)key * 2654435761u >> 18;
	while (t->keys[slot] != 0 && t->keys[slot] != key)
		slot = (slot + 1) & (HASH_SLOTS - 1);
	return (int32_t)slot;
}

static void write_lzw(gif *g, lzw_table *t, const uint8_t *pixels, int32_t count)
{
	bit_writer w;
	memset(&w, 0, sizeof w);
	w.g = g;
	put_byte(g, 8);
	reset_table(t);
	put_code(&w, CODE_CLEAR, t->width);
	int32_t prefix = pixels[0];
	for (int32_t i = 1; i < count; ++i) {
		int32_t key = (prefix << 8 | pixels[i]) + 1, slot = find_slot(t, key);
		if (t->keys[slot] == key) {
			prefix = t->codes[slot];
			continue;
		}
		put_code(&w, prefix, t->width);
		prefix = pixels[i];
		if (t->next < CODE_LIMIT) {
			/* The decoder is one entry behind, hence the test before the new code exists. */
			if (t->next == 1 << t->width)
				++t->width;
			t->keys[slot] = key;
			t->codes[slot] = (int16_t)t->next++;
		} else {
			put_code(&w, CODE_CLEAR, t->width);
			reset_table(t);
		}
	}
	put_code(&w, prefix, t->width);
	if (t->next < CODE_LIMIT && t->next == 1 << t->width)
		++t->width;
	put_code(&w, CODE_END, t->width);
	finish_codes(&w);
}

/* ------------------------------------------------------------------ container */

int32_t gif_open(gif *g, const char *path, int32_t width, int32_t height, const uint8_t *rgb, int32_t count, int32_t delay_cs)
{
	static const uint8_t forever[] = {0x21, 0xff, 11, 'N', 'E', 'T', 'S', 'C', 'A', 'P', 'E', '2', '.', '0', 3, 1, 0, 0, 0};
	uint8_t colors[256 * 3] = {0};
	memset(g, 0, sizeof *g);
	g->width = width;
	g->height = height;
	g->delay_cs = delay_cs;
	g->previous = (uint8_t *)malloc((size_t)width * (size_t)height);
	g->scratch = (uint8_t *)malloc((size_t)width * (size_t)height);
	g->file = g->previous != NULL && g->scratch != NULL ? fopen(path, "wb") : NULL;
	if (g->file == NULL) {
		free(g->previous);
		free(g->scratch);
		return 0;
	}
	memcpy(colors, rgb, (size_t)count * 3);
	put_bytes(g, "GIF89a", 6);
	put_word(g, width);
	put_word(g, height);
	put_byte(g, 0xf7); /* global table of 256 colours of 8 bits */
	put_word(g, 0);
	put_bytes(g, colors, sizeof colors);
	put_bytes(g, forever, sizeof forever);
	return 1;
}

typedef struct changed_box {
	int32_t x0, y0, x1, y1;
} changed_box;

/* One pixel at least, because a frame may not be empty. */
static changed_box find_changes(const gif *g, const uint8_t *pixels)
{
	changed_box box = {g->width, g->height, 0, 0};
	for (int32_t y = 0; y < g->height; ++y) {
		for (int32_t x = 0; x < g->width; ++x) {
			if (g->frames > 0 && pixels[y * g->width + x] == g->previous[y * g->width + x])
				continue;
			box.x0 = x < box.x0 ? x : box.x0;
			box.y0 = y < box.y0 ? y : box.y0;
			box.x1 = x >= box.x1 ? x + 1 : box.x1;
			box.y1 = y + 1;
		}
	}
	if (box.x1 == 0)
		box.x0 = box.y0 = 0, box.x1 = box.y1 = 1;
	return box;
}

static void cut_changes(gif *g, const uint8_t *pixels, const changed_box *box)
{
	uint8_t *out = g->scratch;
	for (int32_t y = box->y0; y < box->y1; ++y) {
		for (int32_t x = box->x0; x < box->x1; ++x) {
			int32_t at = y * g->width + x;
			*out++ = g->frames > 0 && pixels[at] == g->previous[at] ? TRANSPARENT : pixels[at];
		}
	}
}

void gif_add(gif *g, const uint8_t *pixels)
{
	lzw_table *table = (lzw_table *)malloc(sizeof *table);
	changed_box box = find_changes(g, pixels);
	if (table == NULL) {
		g->failed = 1;
		return;
	}
	cut_changes(g, pixels, &box);
	put_byte(g, 0x21); /* graphic control: keep what is there, one colour is transparent */
	put_byte(g, 0xf9);
	put_byte(g, 4);
	put_byte(g, 1 << 2 | 1);
	put_word(g, g->delay_cs);
	put_byte(g, TRANSPARENT);
	put_byte(g, 0);
	put_byte(g, 0x2c); /* image */
	put_word(g, box.x0);
	put_word(g, box.y0);
	put_word(g, box.x1 - box.x0);
	put_word(g, box.y1 - box.y0);
	put_byte(g, 0);
	write_lzw(g, table, g->scratch, (box.x1 - box.x0) * (box.y1 - box.y0));
	memcpy(g->previous, pixels, (size_t)g->width * (size_t)g->height);
	++g->frames;
	free(table);
}

long gif_close(gif *g)
{
	put_byte(g, 0x3b);
	long bytes = ftell(g->file);
	if (fclose(g->file) != 0)
		g->failed = 1;
	free(g->previous);
	free(g->scratch);
	return g->failed ? -1 : bytes;
}
