/*
 * test/test.h - the test harness: one executable per test file, one function per promise.
 *
 *     static void t_ball_falls(void) { CHECK_LE("apex error", error, 1e-3, "m"); }
 *     int main(int argc, char **argv) { RUN(t_ball_falls); return test_end(); }
 *
 * CHECK fails the running test and goes on; REQUIRE also leaves the test function. CHECK_LE prints the
 * measured value beside its bound, always; greater() gathers the worst of many. test_begin takes an optional substring filter from argv.
 * Each executable ends with one line "N passed, N failed, N skipped" and exit code 0 when none failed;
 * test/run.sh adds those up.
 */
#ifndef CAIRN_TEST_H
#define CAIRN_TEST_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int test_passed, test_failed, test_skipped, test_this_failed, test_this_skipped;
static const char *test_filter;

static inline void test_begin(int argc, char **argv) { test_filter = argc > 1 ? argv[1] : NULL; }

static inline void test_run(const char *name, void (*function)(void))
{
	if (test_filter != NULL && strstr(name, test_filter) == NULL)
		return;
	test_this_failed = 0;
	test_this_skipped = 0;
	function();
	if (test_this_failed)
		++test_failed;
	else if (test_this_skipped)
		++test_skipped;
	else
		++test_passed;
	printf("%s %s\n", test_this_failed ? "FAIL" : test_this_skipped ? "skip" : "ok  ", name);
}

static inline int test_end(void)
{
	printf("%d passed, %d failed, %d skipped\n", test_passed, test_failed, test_skipped);
	return test_failed != 0;
}

static inline void test_fail(const char *file, int line, const char *what)
{
	printf("  %s:%d: %s\n", file, line, what);
	test_this_failed = 1;
}

static inline void test_bound(const char *file, int line, const char *what, double value, double bound, const char *unit, int below)
{
	int good = below ? value <= bound : value >= bound;
	printf("  %s %s: %.7g %s, bound %s %.7g\n", good ? "    " : "OVER", what, value, unit, below ? "<=" : ">=", bound);
	if (!good)
		test_fail(file, line, what);
}

/* The worst so far. A number that is none counts as infinite, and so is never forgotten: fmax would pass over it. */
static inline double greater(double most, double value)
{
	return isfinite(most) && isfinite(value) ? fmax(most, value) : HUGE_VAL;
}

/* A golden number says that something changed, not that it is wrong: CAIRN_NO_GOLDEN lets any pass (test/mutation.sh). */
static inline int test_golden_holds(uint64_t digest, uint64_t golden)
{
	return digest == golden || getenv("CAIRN_NO_GOLDEN") != NULL;
}

/*
 * How much runs of what differs by a random number or a length alone: all of it in the long form (TEST_LONG: make soak), about half in
 * make test, a tenth in a slow build (TEST_SLOW: sanitizers and emulators), which looks for faults of memory and arithmetic.
 */
#if defined(TEST_LONG)
#define TEST_FORM(whole, usual, slow) (whole)
#elif defined(TEST_SLOW)
#define TEST_FORM(whole, usual, slow) (slow)
#else
#define TEST_FORM(whole, usual, slow) (usual)
#endif
/* So many random scenes: at least one. Bounds on how many of them fail scale by it, too. */
#define TEST_MANY(count) TEST_FORM(count, ((count) + 1) / 2, ((count) + 9) / 10)
/* So many random values, rounds or steps of which each takes little. */
#define TEST_SAMPLES(count) TEST_FORM(count, (count) / 2, (count) / 10)

#define RUN(function) test_run(#function, function)
/* Prints times and checks none: runs only when the filter names it (make test-times). */
#define RUN_WHEN_NAMED(function) do { if (test_filter != NULL) RUN(function); } while (0)
#define SKIP(why) do { printf("  skipped: %s\n", why); test_this_skipped = 1; return; } while (0)
#define CHECK(condition) do { if (!(condition)) test_fail(__FILE__, __LINE__, #condition); } while (0)
#define REQUIRE(condition) do { if (!(condition)) { test_fail(__FILE__, __LINE__, #condition); return; } } while (0)
#define CHECK_LE(what, value, bound, unit) test_bound(__FILE__, __LINE__, what, (double)(value), (double)(bound), unit, 1)
#define CHECK_GE(what, value, bound, unit) test_bound(__FILE__, __LINE__, what, (double)(value), (double)(bound), unit, 0)

#endif
