/*
 * test/fuzz/corpus_test.c - every fuzz target on the inputs of corpus.txt (found by libFuzzer, and seeds), on changed ones and on random ones, with
 * any compiler. A line of corpus.txt is a target's name and bytes in hexadecimal.
 */
#include "../test.h"
#include "fuzz.h"

#include <ctype.h>

#define INPUTS TEST_SAMPLES(400)
#define CHANGES TEST_SAMPLES(100)
#define BYTES_MAX 1024

static const struct target {
	const char *name;
	void (*run)(const uint8_t *bytes, size_t count);
} targets[] = { { "calls", fuzz_calls }, { "file", fuzz_file }, { "recording", fuzz_recording }, { "geometry", fuzz_geometry } };
#define TARGETS ((int32_t)(sizeof targets / sizeof *targets))

static void run_random(const struct target *target)
{
	static uint8_t bytes[BYTES_MAX];
	uint32_t random = 1;
	int32_t input, k;
	for (input = 0; input < INPUTS; ++input) {
		for (k = 0; k < BYTES_MAX; ++k) {
			random = random * 1664525u + 1013904223u;
			bytes[k] = (uint8_t)(random >> 24);
		}
		target->run(bytes, sizeof bytes);
	}
	printf("  %s: %d random inputs\n", target->name, INPUTS);
}

static void t_calls_on_random_bytes(void) { run_random(&targets[0]); }
static void t_files_of_random_bytes(void) { run_random(&targets[1]); }
static void t_recordings_of_random_bytes(void) { run_random(&targets[2]); }
static void t_geometry_of_random_bytes(void) { run_random(&targets[3]); }

static int32_t digit(int c) { return c <= '9' ? c - '0' : tolower(c) - 'a' + 10; }

/* Reads the bytes of a line. */
static size_t line_bytes(FILE *file, uint8_t **bytes)
{
	size_t count = 0, capacity = 1 << 16;
	int c, high = -1;
	*bytes = (uint8_t *)malloc(capacity);
	for (c = fgetc(file); c != EOF && c != '\n' && *bytes != NULL; c = fgetc(file)) {
		if (!isxdigit(c))
			continue;
		if (high < 0) {
			high = digit(c);
			continue;
		}
		if (count == capacity)
			*bytes = (uint8_t *)realloc(*bytes, capacity *= 2);
		(*bytes)[count++] = (uint8_t)(high << 4 | digit(c));
		high = -1;
	}
	return count;
}

/* The input, and what becomes of it when some bytes change. */
static void run_input(const struct target *target, uint8_t *bytes, size_t count)
{
	uint32_t random = (uint32_t)count + 1;
	int32_t change, n;
	target->run(bytes, count);
	for (change = 0; change < CHANGES && count > 0; ++change) {
		uint8_t *changed = (uint8_t *)malloc(count);
		memcpy(changed, bytes, count);
		for (n = change % 4; n >= 0; --n) {
			random = random * 1664525u + 1013904223u;
			changed[(random >> 8) % count] ^= (uint8_t)(1u << (random >> 4) % 8u);
		}
		target->run(changed, count);
		free(changed);
	}
}

static void t_the_corpus(void)
{
	FILE *file = fopen("test/fuzz/corpus.txt", "r");
	char name[16];
	int32_t inputs = 0, k;
	REQUIRE(file != NULL);
	while (fscanf(file, "%15s", name) == 1) {
		uint8_t *bytes;
		size_t count = line_bytes(file, &bytes);
		for (k = 0; k < TARGETS; ++k)
			if (strcmp(targets[k].name, name) == 0) {
				run_input(&targets[k], bytes, count);
				++inputs;
			}
		free(bytes);
	}
	fclose(file);
	printf("  %d inputs, each with %d changes\n", (int)inputs, CHANGES);
	CHECK(inputs >= 3);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_the_corpus);
	RUN(t_calls_on_random_bytes);
	RUN(t_files_of_random_bytes);
	RUN(t_recordings_of_random_bytes);
	RUN(t_geometry_of_random_bytes);
	return test_end();
}
