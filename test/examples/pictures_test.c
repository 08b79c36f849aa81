/*
 * test/examples/pictures_test.c - the pictures of the demo hold what was drawn: areas of the rasteriser
 * against closed forms, and the GIF and PNG writers against decoders written here from the formats.
 */
#include "demo/canvas.h"
#include "demo/draw.h"
#include "demo/gif.h"
#include "demo/palette.h"
#include "demo/png.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>

static uint32_t seed = 12345;
static uint32_t random_bits(void)
{
	seed = seed * 1664525u + 1013904223u;
	return seed >> 8;
}

static uint8_t *read_whole(const char *path, long *out_bytes)
{
	FILE *f = fopen(path, "rb");
	*out_bytes = 0;
	if (f == NULL)
		return NULL;
	fseek(f, 0, SEEK_END);
	*out_bytes = ftell(f);
	fseek(f, 0, SEEK_SET);
	uint8_t *bytes = (uint8_t *)malloc((size_t)*out_bytes + 1);
	if (bytes != NULL && fread(bytes, 1, (size_t)*out_bytes, f) != (size_t)*out_bytes)
		*out_bytes = 0;
	fclose(f);
	return bytes;
}

/* Beside the executable; removed after reading. */
static char gif_path[512], png_path[512];

/* ------------------------------------------------------------------ canvas */

/* Black on white: how many pixels' worth are covered. */
static double covered_area(const canvas *c)
{
	double sum = 0.0;
	for (int32_t i = 0; i < c->width * c->height; ++i)
		sum += (255.0 - (double)c->rgb[3 * i]) / 255.0;
	return sum;
}

static void t_areas(void)
{
	canvas c;
	REQUIRE(canvas_open(&c, 200, 150));
	canvas_clear(&c, 0xffffff);
	canvas_disc(&c, (canvas_point){80.3f, 70.7f}, 30.0f, 0, 0, 0.0f);
	CHECK_LE("disc area error", fabs(covered_area(&c) / (3.14159265 * 900.0) - 1.0), 2e-3, "");

	canvas_clear(&c, 0xffffff);
	canvas_capsule(&c, (canvas_point){50.0f, 40.0f}, (canvas_point){110.0f, 120.0f}, 10.0f, 0, 0, 0.0f);
	CHECK_LE("capsule area error", fabs(covered_area(&c) / (100.0 * 20.0 + 3.14159265 * 100.0) - 1.0), 3e-3, "");

	const canvas_point tilted[4] = {{60.0f, 20.0f}, {140.0f, 80.0f}, {110.0f, 120.0f}, {30.0f, 60.0f}}; /* 100 x 50 */
	canvas_clear(&c, 0xffffff);
	canvas_polygon(&c, tilted, 4, 0.0f, 0, 0, 0.0f);
	CHECK_LE("box area error", fabs(covered_area(&c) / 5000.0 - 1.0), 2e-3, "");
	canvas_clear(&c, 0xffffff);
	canvas_polygon(&c, tilted, 4, 8.0f, 0, 0, 0.0f);
	CHECK_LE("rounded box area error", fabs(covered_area(&c) / (5000.0 + 300.0 * 8.0 + 3.14159265 * 64.0) - 1.0), 2e-3, "");
	canvas_close(&c);
}

/* Shapes far outside or across the border must not write outside of the picture (the address sanitizer sees it). */
static void t_clipping(void)
{
	canvas c;
	REQUIRE(canvas_open(&c, 31, 17));
	canvas_clear(&c, 0xffffff);
	for (int32_t i = 0; i < 2000; ++i) {
		canvas_point a = {(float)(random_bits() % 200) - 80.0f, (float)(random_bits() % 200) - 80.0f};
		canvas_point b = {(float)(random_bits() % 200) - 80.0f, (float)(random_bits() % 200) - 80.0f};
		canvas_capsule(&c, a, b, 3.0f, 0xff0000, 0, 1.0f);
	}
	canvas_disc(&c, (canvas_point){1.0e9f, -1.0e9f}, 5.0f, 0, 0, 0.0f);
	canvas_disc(&c, (canvas_point){15.0f, 8.0f}, 1.0e5f, 0x123456, 0, 0.0f);
	CHECK(c.rgb[0] == 0x12 && c.rgb[1] == 0x34 && c.rgb[2] == 0x56);
	CHECK(c.rgb[3 * 31 * 17 - 1] == 0x56);
	canvas_close(&c);
}

static void t_palette_keeps_drawing_colors(void)
{
	static palette p;
	canvas c;
	uint8_t pixel;
	palette_make(&p, draw_colors, DRAW_COLORS);
	CHECK_LE("palette entries", p.count, PALETTE_MAX, "");
	REQUIRE(canvas_open(&c, 1, 1));
	for (int32_t i = 0; i < DRAW_COLORS; ++i) {
		canvas_clear(&c, draw_colors[i]);
		palette_apply(&p, &c, &pixel);
		CHECK(pixel == i);
	}
	canvas_close(&c);
}

/* ------------------------------------------------------------------ GIF */

typedef struct gif_reader {
	const uint8_t *bytes;
	long at, end;
	int32_t width, height, frames;
	uint8_t *screen;
	/* code stream of the image that is read */
	uint32_t bits;
	int32_t bit_count, block_left;
} gif_reader;

static int32_t next_byte(gif_reader *r) { return r->at < r->end ? r->bytes[r->at++] : -1; }
static int32_t next_word(gif_reader *r)
{
	int32_t low = next_byte(r);
	return low | next_byte(r) << 8;
}

static int32_t next_code(gif_reader *r, int32_t width)
{
	while (r->bit_count < width) {
		if (r->block_left == 0)
			r->block_left = next_byte(r);
		if (r->block_left <= 0)
			return -1;
		r->bits |= (uint32_t)next_byte(r) << r->bit_count;
		r->bit_count += 8;
		--r->block_left;
	}
	int32_t code = (int32_t)(r->bits & ((1u << width) - 1u));
	r->bits >>= width;
	r->bit_count -= width;
	return code;
}

typedef struct image_box {
	int32_t x, y, w, h, filled;
} image_box;

static void put_pixel(gif_reader *r, image_box *box, uint8_t pixel)
{
	int32_t x = box->x + box->filled % box->w, y = box->y + box->filled / box->w;
	if (box->filled++ < box->w * box->h && pixel != 255)
		r->screen[y * r->width + x] = pixel;
}

/* Decodes until the end code; 0 when the stream makes no sense. */
static int32_t decode_image(gif_reader *r, image_box *box)
{
	static int16_t prefix[4096];
	static uint8_t last[4096], stack[4097];
	int32_t next = 258, width = 9, previous = -1;
	r->bits = 0;
	r->bit_count = r->block_left = 0;
	for (;;) {
		int32_t code = next_code(r, width), depth = 0;
		if (code == 256) {
			next = 258, width = 9, previous = -1;
			continue;
		}
		if (code == 257)
			break;
		if (code < 0 || code > next || (code == next && previous < 0))
			return 0;
		int32_t walk = code < next ? code : previous;
		while (walk >= 258) {
			stack[depth++] = last[walk];
			walk = prefix[walk];
		}
		uint8_t first = (uint8_t)walk;
		put_pixel(r, box, first);
		while (depth > 0)
			put_pixel(r, box, stack[--depth]);
		if (code == next)
			put_pixel(r, box, first);
		if (previous >= 0 && next < 4096) {
			prefix[next] = (int16_t)previous;
			last[next++] = first;
			if (next == 1 << width && width < 12)
				++width;
		}
		previous = code;
	}
	while (r->block_left-- > 0)
		next_byte(r);
	return next_byte(r) == 0 && box->filled == box->w * box->h;
}

static int32_t read_header(gif_reader *r)
{
	if (r->end < 800 || memcmp(r->bytes, "GIF89a", 6) != 0)
		return 0;
	r->at = 6;
	r->width = next_word(r);
	r->height = next_word(r);
	r->at = 13 + 768;
	return next_byte(r) == 0x21 && (r->at += 18) > 0;
}

/* 1: a frame was drawn on the screen, 0: the end, -1: nonsense. */
static int32_t read_frame(gif_reader *r)
{
	image_box box;
	int32_t kind = next_byte(r);
	if (kind == 0x3b)
		return r->at == r->end ? 0 : -1;
	if (kind != 0x21)
		return -1;
	r->at += 7;
	if (next_byte(r) != 0x2c)
		return -1;
	box.x = next_word(r), box.y = next_word(r), box.w = next_word(r), box.h = next_word(r), box.filled = 0;
	if (next_byte(r) != 0 || next_byte(r) != 8 || box.x + box.w > r->width || box.y + box.h > r->height)
		return -1;
	++r->frames;
	return decode_image(r, &box) ? 1 : -1;
}

/* Frame k of a film that has noise (new tables), a moving block (small rectangles) and repetition. */
static void make_frame(uint8_t *pixels, int32_t width, int32_t height, int32_t k)
{
	for (int32_t i = 0; i < width * height; ++i) {
		int32_t x = i % width, y = i / width;
		uint32_t noise = ((uint32_t)i * 2654435761u + (uint32_t)k * 40503u) >> 13;
		if (k < 2)
			pixels[i] = (uint8_t)(noise % 255u);
		else
			pixels[i] = (uint8_t)(x >= 3 * k && x < 3 * k + 20 && y >= 2 * k && y < 2 * k + 9 ? 7 : (k < 7 ? x / 16 : 3));
	}
}

static void t_gif_reads_back(void)
{
	enum { W = 150, H = 90, FRAMES = 10 };
	static uint8_t pixels[W * H], screen[W * H], colors[255 * 3];
	gif g;
	gif_reader r = {0};
	REQUIRE(gif_open(&g, gif_path, W, H, colors, 255, 5));
	for (int32_t k = 0; k < FRAMES; ++k) {
		make_frame(pixels, W, H, k < 9 ? k : 8); /* the last two are equal */
		gif_add(&g, pixels);
	}
	long written = gif_close(&g);
	r.bytes = read_whole(gif_path, &r.end);
	remove(gif_path);
	r.screen = screen;
	REQUIRE(r.bytes != NULL);
	CHECK(written == r.end);
	CHECK(read_header(&r));
	CHECK(r.width == W && r.height == H);
	for (int32_t k = 0; k < FRAMES; ++k) {
		if (read_frame(&r) != 1) {
			test_fail(__FILE__, __LINE__, "a frame can be decoded");
			break;
		}
		make_frame(pixels, W, H, k < 9 ? k : 8);
		CHECK(memcmp(pixels, screen, sizeof pixels) == 0);
	}
	CHECK(read_frame(&r) == 0);
	CHECK(r.frames == FRAMES);
	free((void *)(uintptr_t)r.bytes);
}

/* ------------------------------------------------------------------ PNG */

static uint32_t be32(const uint8_t *b) { return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3]; }

static uint32_t crc_of(const uint8_t *bytes, uint32_t count)
{
	uint32_t crc = 0xffffffffu;
	for (uint32_t i = 0; i < count; ++i) {
		for (uint32_t bit = 0; bit < 8; ++bit) {
			uint32_t carry = (crc ^ (uint32_t)(bytes[i] >> bit)) & 1u;
			crc = crc >> 1 ^ (carry ? 0xedb88320u : 0u);
		}
	}
	return ~crc;
}

/* Returns the data of the named chunk after checking the CRCs of all. */
static const uint8_t *find_chunk(const uint8_t *bytes, long end, const char *name, uint32_t *out_bytes)
{
	const uint8_t *found = NULL;
	for (long at = 8; at + 12 <= end;) {
		uint32_t count = be32(bytes + at);
		CHECK(crc_of(bytes + at + 4, count + 4) == be32(bytes + at + 8 + count));
		if (memcmp(bytes + at + 4, name, 4) == 0) {
			found = bytes + at + 8;
			*out_bytes = count;
		}
		at += 12 + (long)count;
	}
	return found;
}

static void t_png_reads_back(void)
{
	enum { W = 37, H = 11 };
	static uint8_t pixels[W * H], colors[255 * 3];
	long end;
	uint32_t count = 0, a = 1, b = 0;
	CHECK(crc_of((const uint8_t *)"123456789", 9) == 0xcbf43926u); /* the check value of this CRC */
	for (int32_t i = 0; i < W * H; ++i)
		pixels[i] = (uint8_t)(random_bits() % 255);
	REQUIRE(png_write(png_path, W, H, pixels, colors, 255));
	uint8_t *bytes = read_whole(png_path, &end);
	remove(png_path);
	REQUIRE(bytes != NULL);
	CHECK(memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0);
	const uint8_t *header = find_chunk(bytes, end, "IHDR", &count);
	REQUIRE(header != NULL && count == 13);
	CHECK(be32(header) == W && be32(header + 4) == H);
	const uint8_t *data = find_chunk(bytes, end, "IDAT", &count);
	REQUIRE(data != NULL && count == 2 + H * (5 + 1 + W) + 4);
	CHECK((data[0] * 256 + data[1]) % 31 == 0);
	for (int32_t y = 0; y < H; ++y) {
		const uint8_t *block = data + 2 + y * (5 + 1 + W);
		CHECK(block[0] == (y == H - 1) && block[1] == W + 1 && block[2] == 0 && block[3] == 255 - (W + 1) && block[4] == 255);
		CHECK(block[5] == 0 && memcmp(block + 6, pixels + y * W, W) == 0);
		for (int32_t i = 0; i <= W; ++i) {
			a = (a + block[5 + i]) % 65521u;
			b = (b + a) % 65521u;
		}
	}
	CHECK(be32(data + count - 4) == (b << 16 | a));
	free(bytes);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	snprintf(gif_path, sizeof gif_path, "%s.gif", argv[0]);
	snprintf(png_path, sizeof png_path, "%s.png", argv[0]);
	RUN(t_areas);
	RUN(t_clipping);
	RUN(t_palette_keeps_drawing_colors);
	RUN(t_gif_reads_back);
	RUN(t_png_reads_back);
	return test_end();
}
