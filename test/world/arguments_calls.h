/*
 * test/world/arguments_calls.h - how arguments_test describes a public function: the words for its good call and for what
 * is wrong with its bad ones. Included by arguments_test.c only.
 */
#ifndef CAIRN_TEST_ARGUMENTS_CALLS_H
#define CAIRN_TEST_ARGUMENTS_CALLS_H

#include "calls.h"

static const char *current;          /* function under test */
static int current_has_sentence;     /* it takes a non-const world */
static uint32_t *current_produced;   /* bits 1 << -code of the errors that it gave */
static int bad_calls;
static state before;
static unsigned char out_bytes[8192];
#define OUT(T) ((T *)(void *)out_bytes)
#define INT OUT(int32_t)

static void produced(cn_result result)
{
	if (result < 0 && result > -32)
		*current_produced |= 1u << -result;
}

static void bad_begin(void)
{
	/* Leave another function's sentence, so that a missing one is seen. */
	if (strcmp(current, "cn_world_set_substep_count") == 0)
		cn_world_set_flags(W, 0xFFFFFFFFu);
	else
		cn_world_set_substep_count(W, -1);
	memset(out_bytes, 0xA5, sizeof out_bytes);
	before = state_of(W);
}

static void bad_sentence(const char *what)
{
	const char *text = cn_world_error_text(W);
	size_t length = strlen(current);
	if (!current_has_sentence)
		return;
	if (strncmp(text, current, length) != 0 || text[length] != ':' || strlen(text) < length + 6) {
		printf("  %s gives the sentence \"%s\"\n", what, text);
		test_fail(__FILE__, __LINE__, "sentence must name the function and say what was wrong");
	}
}

static void bad_end(int line, const char *what, cn_result expected, cn_result result, int has_world)
{
	state after = state_of(W);
	size_t k;
	++bad_calls;
	produced(result);
	if (result != expected) {
		printf("  %s gives %d (%s), not %d\n", what, (int)result, cn_world_error_text(W), (int)expected);
		test_fail(__FILE__, line, current);
	}
	if (state_differs(&before, &after)) {
		printf("  after %s\n", what);
		test_fail(__FILE__, line, "a failed call changed the world");
	}
	for (k = 0; k < sizeof out_bytes; ++k)
		if (out_bytes[k] != 0xA5) {
			printf("  after %s\n", what);
			test_fail(__FILE__, line, "a failed call wrote its output");
			break;
		}
	if (has_world)
		bad_sentence(what);
	check_valid(what);
}

/* The call must give this code; NOW is for calls with a NULL world or none. */
#define BAD(code, call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, code, r_, 1); } while (0)
#define NOW(call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, CN_ERROR_ARGUMENT, r_, 0); } while (0)
#define ARG(call) BAD(CN_ERROR_ARGUMENT, call)
#define STATE(call) BAD(CN_ERROR_STATE, call)

static float number(int k)
{
	static const uint32_t bits[] = { 0x7FC00000u, 0x7F800000u, 0xFF800000u, 0xFFC12345u };
	float x;
	memcpy(&x, &bits[k & 3], sizeof x);
	return x;
}

/* x runs over what is not finite, and then over the out-of-range values given. */
#define FLOAT(x, call) do { int k_; for (k_ = 0; k_ < 4; ++k_) { float x = number(k_); ARG(call); } } while (0)
#define NOT_NEGATIVE(x, call) do { FLOAT(x, call); { float x = -1.0f; ARG(call); } { float x = -1e-30f; ARG(call); } } while (0)
/* Fields that take CN_DEFAULT. */
#define DEFAULT_OR_NOT_NEGATIVE(x, call) do { FLOAT(x, call); { float x = -1.0000001f; ARG(call); } { float x = -2.0f; ARG(call); } { float x = -1e-30f; ARG(call); } } while (0)
#define DEFAULT_OR_POSITIVE(x, call) do { DEFAULT_OR_NOT_NEGATIVE(x, call); { float x = 0.0f; ARG(call); } } while (0)
#define POSITIVE(x, call) do { NOT_NEGATIVE(x, call); { float x = 0.0f; ARG(call); } { float x = -0.0f; ARG(call); } } while (0)
#define RANGE(x, below, above, call) do { FLOAT(x, call); { float x = (below); ARG(call); } { float x = (above); ARG(call); } } while (0)
#define DEFAULT_OR_ABOVE_0(x, above, call) do { DEFAULT_OR_POSITIVE(x, call); { float x = (above); ARG(call); } } while (0)
#define ANGLE(x, call) RANGE(x, -10001.0f, 10001.0f, call)
#define INTEGER(x, below, above, call) do { { int32_t x = (below); ARG(call); } { int32_t x = (above); ARG(call); } \
	{ int32_t x = INT32_MIN; ARG(call); } { int32_t x = INT32_MAX; ARG(call); } } while (0)
#define FLAGS(x, first_unknown, call) do { int k_; for (k_ = (first_unknown); k_ < 32; ++k_) { uint32_t x = 1u << k_; ARG(call); } } while (0)
#define VECTOR(v, call) do { int k_; for (k_ = 0; k_ < 8; ++k_) { cn_vec2 v = k_ & 1 ? v2(0.0f, number(k_ >> 1)) : v2(number(k_ >> 1), 0.0f); ARG(call); } } while (0)
#define POSITION(v, call) do { VECTOR(v, call); { cn_vec2 v = v2(1.01e6f, 0.0f); ARG(call); } { cn_vec2 v = v2(0.0f, -1.01e6f); ARG(call); } } while (0)
#define SIZES(x, call) do { { uint32_t x = 0; ARG(call); } { uint32_t x = 1; ARG(call); } { uint32_t x = 0xFFFFFFFFu; ARG(call); } } while (0)
#define HANDLE(h, list, count, call) do { int k_; for (k_ = 0; k_ < count; ++k_) { uint32_t h = list[k_]; BAD(CN_ERROR_HANDLE, call); } } while (0)
#define BODY(h, call) HANDLE(h, f.bad_bodies, f.bad_body_count, call)
#define SHAPE(h, call) HANDLE(h, f.bad_shapes, f.bad_shape_count, call)
#define JOINT(h, call) HANDLE(h, f.bad_joints, f.bad_joint_count, call)
/* Bad handles without 0, where 0 has a meaning. */
#define BODY_BUT_ZERO(h, call) HANDLE(h, (f.bad_bodies + 1), (f.bad_body_count - 1), call)

/* name, its good call, its bad calls */
#define ENTRY(name, good, ...) \
	static cn_result good_##name(void) { return good; } \
	static void bad_##name(void) { __VA_ARGS__ }

/* (const world, handle, out) */
#define GETTER(name, KIND, handle, T) ENTRY(name, name(W, handle, OUT(T)), \
	NOW(name(NULL, handle, OUT(T))); KIND(h, name(W, h, OUT(T))); ARG(name(W, handle, NULL));)
#define GETTER2(name, KIND, handle, T, U) ENTRY(name, name(W, handle, OUT(T), OUT(U) + 16), \
	NOW(name(NULL, handle, OUT(T), OUT(U) + 16)); KIND(h, name(W, h, OUT(T), OUT(U) + 16)); \
	ARG(name(W, handle, NULL, OUT(U))); ARG(name(W, handle, OUT(T), NULL));)
/* (const world, out) */
#define WORLD_GETTER(name, T) ENTRY(name, name(W, OUT(T)), NOW(name(NULL, OUT(T))); ARG(name(W, NULL));)
/* (const world, out, capacity, out_count) */
#define WORLD_LIST(name, T) ENTRY(name, name(W, OUT(T) + 4, 8, INT), \
	NOW(name(NULL, OUT(T) + 4, 8, INT)); ARG(name(W, NULL, 1, INT)); ARG(name(W, OUT(T) + 4, -1, INT)); ARG(name(W, OUT(T) + 4, 8, NULL));)
/* (const world, handle, out, capacity, out_count) */
#define HANDLE_LIST(name, KIND, handle, T) ENTRY(name, name(W, handle, OUT(T) + 4, 8, INT), \
	NOW(name(NULL, handle, OUT(T) + 4, 8, INT)); KIND(h, name(W, h, OUT(T) + 4, 8, INT)); \
	ARG(name(W, handle, NULL, 1, INT)); ARG(name(W, handle, OUT(T) + 4, -1, INT)); ARG(name(W, handle, OUT(T) + 4, 8, NULL));)

#endif
