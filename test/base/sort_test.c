/* Promises of base/sort.h: sorted, with and without scratch. */
#include "hooks.h"

#include "base/sort.h"

#include "../test.h"

#include <float.h>
#include <math.h>

enum { MOST = 3000 };

static uint64_t keys[MOST + 1], reference[MOST], scratch[MOST + 1];

/* Stable selection by counting smaller keys before: as simple as can be. */
static void reference_sort(int32_t count)
{
	int32_t i, j;

	for (i = 0; i < count; ++i) {
		int32_t place = 0;

		for (j = 0; j < count; ++j)
			place += keys[j] < keys[i] || (keys[j] == keys[i] && j < i);
		reference[place] = keys[i];
	}
}

static uint64_t key_of_pattern(int32_t pattern, int32_t i, uint32_t *state)
{
	uint64_t wide = (uint64_t)random_next(state) << 32 | random_next(state);

	switch (pattern) {
	case 0: return wide;                                    /* all bytes */
	case 1: return wide % 7;                                /* many equal */
	case 2: return (uint64_t)i * 10 + wide % 25;            /* nearly sorted */
	case 3: return (uint64_t)(MOST - i);                    /* reversed */
	case 4: return (wide & 0xFFF0000FFFu) << 8;             /* pairs of ids */
	case 5: return 42;                                      /* all equal */
	default: return wide % 300 << 56 | (wide >> 60);        /* first and last byte only: an even number of passes */
	}
}

/* Number of mismatches for one input. */
static int32_t mismatches(int32_t pattern, int32_t count, int32_t with_scratch, uint32_t *state)
{
	int32_t i, wrong = 0;

	for (i = 0; i < count; ++i)
		keys[i] = key_of_pattern(pattern, i, state);
	keys[count] = scratch[count] = 12345;
	reference_sort(count);
	cni_sort_keys(keys, with_scratch ? scratch : NULL, count);
	for (i = 0; i < count; ++i)
		wrong += keys[i] != reference[i];
	return wrong + (keys[count] != 12345 || scratch[count] != 12345);
}

static void sort_all(int32_t with_scratch)
{
	static const int32_t counts[] = {0, 1, 2, 3, 31, 32, 33, 100, 257, 1000};
	uint32_t state = 4242;
	int32_t pattern, i, wrong = 0;

	for (pattern = 0; pattern < 7; ++pattern)
		for (i = 0; i < (int32_t)(sizeof counts / sizeof counts[0]); ++i)
			wrong += mismatches(pattern, counts[i], with_scratch, &state);
	wrong += mismatches(0, MOST, with_scratch, &state);
	wrong += mismatches(3, MOST, with_scratch, &state);
	CHECK_LE("places that differ from the reference", wrong, 0, "places");
}

static void t_sorted_with_scratch(void) { sort_all(1); }
static void t_sorted_without_scratch(void) { sort_all(0); }

static void t_float_keys_keep_order(void)
{
	static const float special[] = {-FLT_MAX, -1.0f, -FLT_MIN, -1e-45f, -0.0f, 0.0f, 1e-45f, FLT_MIN, 1.0f, FLT_MAX};
	uint32_t state = 31;
	int32_t i, j, wrong = 0;

	for (i = 0; i < 10; ++i)
		for (j = 0; j < 10; ++j)
			wrong += (special[i] < special[j]) != (cni_sort_float_key(special[i]) < cni_sort_float_key(special[j]));
	for (i = 0; i < 200000; ++i) {
		uint32_t bits[2];
		float x[2];

		bits[0] = random_next(&state);
		bits[1] = random_next(&state);
		memcpy(x, bits, sizeof x);
		if (isfinite(x[0]) && isfinite(x[1]))
			wrong += (x[0] < x[1]) != (cni_sort_float_key(x[0]) < cni_sort_float_key(x[1]));
	}
	CHECK_LE("pairs in the wrong order", wrong, 0, "pairs");
	CHECK(cni_sort_float_key(-0.0f) == cni_sort_float_key(0.0f));
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_sorted_with_scratch);
	RUN(t_sorted_without_scratch);
	RUN(t_float_keys_keep_order);
	return test_end();
}
