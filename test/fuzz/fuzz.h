/*
 * test/fuzz/fuzz.h - what the fuzz targets share. A target is a function of bytes that checks a property and aborts when it does not hold.
 * libFuzzer calls it through entry.c (run.sh); corpus_test.c calls it with the bytes of corpus.txt and with random ones, with any
 * compiler.
 */
#ifndef CAIRN_TEST_FUZZ_H
#define CAIRN_TEST_FUZZ_H

#include "record/calls.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fuzz_calls(const uint8_t *bytes, size_t count);
void fuzz_file(const uint8_t *bytes, size_t count);
void fuzz_recording(const uint8_t *bytes, size_t count);
void fuzz_geometry(const uint8_t *bytes, size_t count);

#define FUZZ_REQUIRE(condition) do { if (!(condition)) { printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); fflush(stdout); abort(); } } while (0)

/* Bytes as a source of choices; zeros when they are used up. */
typedef struct fuzz_source {
	const uint8_t *at, *end;
} fuzz_source;

static inline fuzz_source fuzz_begin(const uint8_t *bytes, size_t count)
{
	fuzz_source s;
	s.at = bytes;
	s.end = bytes + count;
	return s;
}
static inline int32_t fuzz_left(const fuzz_source *s) { return s->at < s->end; }
static inline uint32_t fuzz_byte(fuzz_source *s) { return s->at < s->end ? *s->at++ : 0u; }
static inline uint32_t fuzz_half(fuzz_source *s)
{
	uint32_t low = fuzz_byte(s);
	return low | fuzz_byte(s) << 8;
}
static inline uint32_t fuzz_word(fuzz_source *s)
{
	uint32_t low = fuzz_half(s);
	return low | fuzz_half(s) << 16;
}
/* -1 .. 1 in steps of 1/32768. */
static inline float fuzz_unit(fuzz_source *s) { return ((float)fuzz_half(s) - 32768.0f) / 32768.0f; }
static inline float fuzz_range(fuzz_source *s, float lower, float upper) { return lower + (upper - lower) * (0.5f + 0.5f * fuzz_unit(s)); }

#endif
