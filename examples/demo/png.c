/*
 * examples/demo/png.c - chunks with CRC-32 (ISO 3309), rows in stored deflate blocks (RFC 1950, 1951).
 * One block a row: a filter byte 0 and the pixels.
 */
#include "demo/png.h"
#include <stdio.h>
#include <string.h>

typedef struct png_writer {
	FILE *file;
	uint32_t crc;
	uint32_t sum_a, sum_b; /* Adler-32 of the rows */
	int32_t failed;
} png_writer;

static uint32_t crc_byte(uint32_t crc, uint8_t byte)
{
	crc ^= byte;
	for (int32_t i = 0; i < 8; ++i)
		crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1u)));
	return crc;
}

static void put(png_writer *w, const void *bytes, uint32_t count)
{
	const uint8_t *b = (const uint8_t *)bytes;
	for (uint32_t i = 0; i < count; ++i)
		w->crc = crc_byte(w->crc, b[i]);
	if (fwrite(bytes, 1, count, w->file) != count)
		w->failed = 1;
}

static void put_32(png_writer *w, uint32_t value)
{
	uint8_t bytes[4];
	for (int32_t i = 0; i < 4; ++i)
		bytes[i] = (uint8_t)(value >> (24 - 8 * i));
	put(w, bytes, 4);
}

/* The CRC of a chunk covers its name and data, not its length. */
static void begin_chunk(png_writer *w, const char *name, uint32_t bytes)
{
	put_32(w, bytes);
	w->crc = 0xffffffffu;
	put(w, name, 4);
}

static void end_chunk(png_writer *w) { put_32(w, w->crc ^ 0xffffffffu); }

static void put_row_bytes(png_writer *w, const uint8_t *bytes, uint32_t count)
{
	put(w, bytes, count);
	for (uint32_t i = 0; i < count; ++i) {
		w->sum_a = (w->sum_a + bytes[i]) % 65521u;
		w->sum_b = (w->sum_b + w->sum_a) % 65521u;
	}
}

static void put_header(png_writer *w, uint32_t width, uint32_t height)
{
	static const uint8_t form[5] = {8, 3, 0, 0, 0}; /* 8 bits, palette, deflate, filters, no interlace */
	begin_chunk(w, "IHDR", 13);
	put_32(w, width);
	put_32(w, height);
	put(w, form, 5);
	end_chunk(w);
}

static void put_pixels(png_writer *w, uint32_t width, uint32_t height, const uint8_t *pixels)
{
	static const uint8_t zlib_header[2] = {0x78, 0x01}, filter = 0;
	uint32_t length = width + 1;
	begin_chunk(w, "IDAT", 2 + height * (5 + length) + 4);
	put(w, zlib_header, 2);
	for (uint32_t y = 0; y < height; ++y) {
		uint8_t block[5] = {0};
		block[0] = y + 1 == height;
		block[1] = (uint8_t)length;
		block[2] = (uint8_t)(length >> 8);
		block[3] = (uint8_t)~length;
		block[4] = (uint8_t)(~length >> 8);
		put(w, block, 5);
		put_row_bytes(w, &filter, 1);
		put_row_bytes(w, pixels + (size_t)y * width, width);
	}
	put_32(w, w->sum_b << 16 | w->sum_a);
	end_chunk(w);
}

int32_t png_write(const char *path, int32_t width, int32_t height, const uint8_t *pixels, const uint8_t *rgb, int32_t count)
{
	static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
	png_writer w;
	memset(&w, 0, sizeof w);
	w.sum_a = 1;
	w.file = fopen(path, "wb");
	if (w.file == NULL)
		return 0;
	put(&w, signature, 8);
	put_header(&w, (uint32_t)width, (uint32_t)height);
	begin_chunk(&w, "PLTE", 3 * (uint32_t)count);
	put(&w, rgb, 3 * (uint32_t)count);
	end_chunk(&w);
	put_pixels(&w, (uint32_t)width, (uint32_t)height, pixels);
	begin_chunk(&w, "IEND", 0);
	end_chunk(&w);
	return fclose(w.file) == 0 && !w.failed;
}
