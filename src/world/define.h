/*
 * world/define.h - macros that define a public function in one line: reading and setting a value of a live record, arrays of events.
 * These functions check only the world, the handle and the output pointers (world/error.h).
 *
 *     CNI_DEFINE_GET(body, gravity_scale, float, record->gravity_scale)
 */
#ifndef CNI_WORLD_DEFINE_H
#define CNI_WORLD_DEFINE_H

#include "world/error.h"

/* Constraints are joint records. */
typedef cni_joint cni_constraint;

/* The body of a function that reads a live record: store is an expression of `record` and `world` that writes the results. */
#define CNI_READ_RECORD(noun, no_place, store) \
	{ \
		const cni_##noun *record; \
		if (world == NULL) \
			return CN_ERROR_ARGUMENT; \
		record = cni_live_##noun(world, noun); \
		if (record == NULL || (no_place)) \
			return record == NULL ? CN_ERROR_HANDLE : CN_ERROR_ARGUMENT; \
		store; \
		return CN_OK; \
	}

/* Defines the public function cn_<noun>_get_<what>, which reads one value: an expression of `record` and `world`. */
#define CNI_DEFINE_GET(noun, what, type, value) \
	cn_result cn_##noun##_get_##what(const cn_world *world, cn_##noun noun, type *out) CNI_READ_RECORD(noun, out == NULL, *out = value)

/* The same for two values: store is an expression that writes *out_a and *out_b. */
#define CNI_DEFINE_GET2(noun, what, type_a, type_b, store) \
	cn_result cn_##noun##_get_##what(const cn_world *world, cn_##noun noun, type_a *out_a, type_b *out_b) \
	CNI_READ_RECORD(noun, out_a == NULL || out_b == NULL, store)

/* The same for a body and a point: value is an expression of `point`. */
#define CNI_DEFINE_GET_AT(what, value) \
	cn_result cn_body_get_##what(const cn_world *world, cn_body body, float x_m, float y_m, cn_vec2 *out) \
	{ \
		cni_call call = cni_enter_const(world); \
		const cni_body *record = cni_check_body(&call, "body", body); \
		cn_vec2 point = { x_m, y_m }; \
		cni_check_finite2(&call, "point", point); \
		cni_check_pointer(&call, "out", out); \
		if (call.result == CN_OK) \
			*out = value; \
		return call.result; \
	}

/* Defines cn_<noun>_is_valid. */
#define CNI_DEFINE_IS_VALID(noun) \
	int32_t cn_##noun##_is_valid(const cn_world *world, cn_##noun noun) { return world != NULL && cni_live_##noun(world, noun) != NULL; }

/* Defines cn_<noun>_set_<what>, which stores one value after a check of it: both are expressions of `call`, `record`, `world` and the value. */
#define CNI_DEFINE_SET(noun, what, type, value, check, store) \
	cn_result cn_##noun##_set_##what(cn_world *world, cn_##noun noun, type value) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		cni_##noun *record = cni_check_##noun(&call, #noun, noun); \
		check; \
		if (call.result == CN_OK) \
			store; \
		return call.result; \
	}

/* Defines cn_<noun>_set_user_data and cn_<noun>_get_user_data; after: an expression, evaluated after the data were set. */
#define CNI_DEFINE_USER_DATA(noun, after) \
	CNI_DEFINE_GET(noun, user_data, uint64_t, record->user_data) \
	CNI_DEFINE_SET(noun, user_data, uint64_t, user_data, (void)0, (record->user_data = user_data, after))

/* Defines cn_world_<name>, which returns an array of the last step's events. */
#define CNI_DEFINE_EVENTS(name, type, array) \
	cn_result cn_world_##name(const cn_world *world, const type **out, int32_t *out_count) \
	{ \
		if (world == NULL || out == NULL || out_count == NULL) \
			return CN_ERROR_ARGUMENT; \
		*out = (const type *)world->events.array.data; \
		*out_count = world->events.array.count; \
		return CN_OK; \
	}

#endif
