/*
 * world/error.c - owns the sentence in world->error: text building without printf, and the argument
 * checks of every public function (see error.h for how they are used).
 *
 * Floats are printed from their bits: m * 2^e becomes m * 10^x by doubling or halving m, which is divided or multiplied by ten where it
 * would lose or overflow its 64 bits. Each of the at most 200 steps loses less than 2^-59 of the value, so the six digits are correct
 * except for exact ties.
 */
#include "world/error.h"

#include <stdarg.h>
#include <string.h>

/* ------------------------------------------------------------------ text */

cni_text cni_text_begin(char *out, int32_t capacity)
{
	cni_text text = { out, capacity, 0 };
	if (out != NULL && capacity > 0)
		out[0] = '\0';
	return text;
}

static void text_char(cni_text *text, char c)
{
	if (text->out == NULL || text->used + 1 >= text->capacity)
		return;
	text->out[text->used++] = c;
	text->out[text->used] = '\0';
}

void cni_text_string(cni_text *text, const char *string)
{
	while (*string != '\0')
		text_char(text, *string++);
}

static void text_digits(cni_text *text, uint64_t value, int32_t base)
{
	char digits[24];
	int32_t count = 0;
	do {
		digits[count++] = "0123456789abcdef"[value % (uint64_t)base];
		value /= (uint64_t)base;
	} while (value != 0);
	while (count > 0)
		text_char(text, digits[--count]);
}

void cni_text_int(cni_text *text, int64_t value)
{
	if (value < 0)
		text_char(text, '-');
	text_digits(text, value < 0 ? (uint64_t)0 - (uint64_t)value : (uint64_t)value, 10);
}

/* Six decimal digits d and the exponent x of a finite float > 0, given as its bits: value = d * 10^x, rounded. */
static uint32_t float_digits(uint32_t bits, int32_t *out_exponent)
{
	int32_t biased = (int32_t)(bits >> 23 & 255u), e = (biased != 0 ? biased : 1) - 150, x = 1;
	uint64_t m = (bits & 0x7FFFFFu) | (biased != 0 ? 0x800000u : 0u); /* value = m * 2^e * 10^(x - 1) */
	for (; e > 0; --e) {
		if (m >> 63) {
			m /= 10u;
			++x;
		}
		m *= 2u;
	}
	for (; e < 0; ++e) {
		for (; m >> 60 == 0; m *= 10u)
			--x;
		m /= 2u;
	}
	for (; m < 1000000u; m *= 10u)
		--x;
	for (; m >= 10000000u; m /= 10u)
		++x;
	m = (m + 5u) / 10u;
	*out_exponent = m == 1000000u ? x + 1 : x;
	return m == 1000000u ? 100000u : (uint32_t)m;
}

/* d with its point after the first `before` of its six digits (before may be <= 0), zeros trimmed. */
static void text_point(cni_text *text, uint32_t d, int32_t before)
{
	uint32_t unit = 100000u;
	if (before <= 0) {
		cni_text_string(text, "0.");
		for (int32_t k = before; k < 0; ++k)
			text_char(text, '0');
	}
	for (int32_t k = 0; k < 6 || k < before; ++k) {
		if (k >= before && d == 0)
			return;
		if (k == before && before > 0)
			text_char(text, '.');
		text_char(text, k < 6 ? (char)('0' + (char)(d / unit)) : '0');
		d = k < 6 ? d % unit : 0;
		unit = unit > 1 ? unit / 10u : 1u;
	}
}

void cni_text_float(cni_text *text, float value)
{
	uint32_t bits = cni_bits_of(value) & 0x7FFFFFFFu, d;
	int32_t exponent;
	if (cni_bits_of(value) >> 31 && bits <= 0x7F800000u)
		text_char(text, '-');
	if (bits == 0 || bits >= 0x7F800000u) {
		cni_text_string(text, bits == 0 ? "0" : bits == 0x7F800000u ? "inf" : "nan");
		return;
	}
	d = float_digits(bits, &exponent);
	if (exponent >= -9 && exponent <= 3) {
		text_point(text, d, exponent + 6);
		return;
	}
	text_point(text, d, 1);
	text_char(text, 'e');
	cni_text_int(text, exponent + 5);
}

/* ------------------------------------------------------------------ entering */

cni_call cni_enter(cn_world *world, const char *function)
{
	cni_call call = { world, world != NULL ? world->error : NULL, function, world != NULL ? CN_OK : CN_ERROR_ARGUMENT };
	cni_check(&call, world == NULL || world->locked == 0, CN_ERROR_LOCKED, "the world is locked while a callback runs");
	return call;
}

cni_call cni_enter_const(const cn_world *world)
{
	cni_call call = { world, NULL, "", world != NULL ? CN_OK : CN_ERROR_ARGUMENT };
	return call;
}

cni_call cni_enter_free(void)
{
	cni_call call = { NULL, NULL, "", CN_OK };
	return call;
}

/* ------------------------------------------------------------------ refusing */

/* Records the first failure of a call: "function: " and the format with %s for a string, %f cni_bits_of a float (doubles take
   soft-float routines on processors that compute in single precision only), %i an int64_t, %x a uint32_t. */
static void refuse_in_words(cni_call *call, cn_result result, const char *format, ...)
{
	va_list values;
	if (call->result != CN_OK)
		return;
	call->result = result;
	cni_text text = cni_text_begin(call->sentence, call->sentence != NULL ? CNI_ERROR_TEXT_BYTES : 0);
	cni_text_string(&text, call->function);
	cni_text_string(&text, ": ");
	va_start(values, format);
	for (; *format != '\0'; ++format) {
		if (*format != '%') {
			text_char(&text, *format);
			continue;
		}
		switch (*++format) {
		case 's': cni_text_string(&text, va_arg(values, const char *)); break;
		case 'f': cni_text_float(&text, cni_float_of(va_arg(values, uint32_t))); break;
		case 'i': cni_text_int(&text, va_arg(values, int64_t)); break;
		case 'x': cni_text_string(&text, "0x"), text_digits(&text, va_arg(values, uint32_t), 16); break; /* flags and handles */
		default: text_char(&text, *format); break;
		}
	}
	va_end(values);
}

/* A macro, so that without messages the compiler drops the words and their numbers. */
#define refuse(call, result, ...) \
	do { \
		if (CNI_HAS_MESSAGES) \
			refuse_in_words(call, result, __VA_ARGS__); \
		else \
			refuse_in_silence(call, result); \
	} while (0)

static void refuse_in_silence(cni_call *call, cn_result result)
{
	if (call->result == CN_OK)
		call->result = result;
}

cn_result cni_refuse(cni_call *call, cn_result result, const char *what)
{
	refuse(call, result, "%s", what);
	return call->result;
}

cn_result cni_refuse_float(cni_call *call, const char *field, float value, const char *must)
{
	refuse(call, CN_ERROR_ARGUMENT, "%s %f; %s", field, cni_bits_of(value), must);
	return call->result;
}

cn_result cni_refuse_int(cni_call *call, const char *field, int64_t value, const char *must)
{
	refuse(call, CN_ERROR_ARGUMENT, "%s %i; %s", field, value, must);
	return call->result;
}

void cni_check_complaint(cni_call *call, const char *complaint, const cn_vec2 *points, int32_t count, int32_t closed)
{
	cni_check(call, complaint == NULL || complaint == cni_points_near, CN_ERROR_ARGUMENT, complaint);
	if (complaint == NULL || call->result != CN_OK)
		return;
	float distance = cni_least_distance(points, count, closed);
	float least = call->world->settings.thickness_least;
	if (distance > 0.0f)
		refuse(call, CN_ERROR_ARGUMENT, "distance of points_m %f; must be from %f (0.05%% of the length unit) to 1e6; a world with cn_world_def.length_unit_m up to %f takes it",
		       cni_bits_of(distance), cni_bits_of(least), cni_bits_of(distance / CNI_THICKNESS_LEAST));
	else
		refuse(call, CN_ERROR_ARGUMENT, "distance of points_m %f; must be from %f", cni_bits_of(distance), cni_bits_of(least));
}

void cni_check_reserved(cni_call *call, cn_result result, const char *things)
{
	if (result != CN_OK)
		refuse(call, result, "%s%s", result == CN_ERROR_CAPACITY ? "too many " : "no memory for ", things);
}

void cni_check_ends_of(cni_call *call, cn_world *world, int32_t body)
{
	if (call->result == CN_OK && body != CNI_NONE)
		cni_check_reserved(call, cni_contact_reserve_end(world, cni_body_at(world, body)->contact_count), "events of its contacts");
}

/* ------------------------------------------------------------------ checks of pointers and sizes */

void cni_check_pointer(cni_call *call, const char *field, const void *pointer)
{
	if (pointer == NULL)
		refuse(call, CN_ERROR_ARGUMENT, "%s is NULL", field);
}

void cni_check_array(cni_call *call, const char *field, const void *array, int32_t count)
{
	if (count < 0)
		cni_refuse_int(call, "count", count, "must be >= 0");
	if (count > 0)
		cni_check_pointer(call, field, array);
}

int32_t cni_check_def(cni_call *call, const void *def, size_t bytes, const char *init)
{
	cni_check_pointer(call, "def", def);
	if (call->result == CN_OK && *(const uint32_t *)def != (uint32_t)bytes)
		refuse(call, CN_ERROR_ARGUMENT, "struct_size %i; must be %i: call %s first", (int64_t)*(const uint32_t *)def, (int64_t)bytes, init);
	return call->result == CN_OK;
}

/* ------------------------------------------------------------------ checks of numbers */

void cni_check_finite(cni_call *call, const char *field, float value)
{
	if (!cni_is_finite(value))
		cni_refuse_float(call, field, value, "must be finite");
}

void cni_check_finite2(cni_call *call, const char *field, cn_vec2 value)
{
	if (!cni_is_finite2(value))
		refuse(call, CN_ERROR_ARGUMENT, "%s (%f, %f); both must be finite", field, cni_bits_of(value.x), cni_bits_of(value.y));
}

void cni_check_at_least(cni_call *call, const char *field, float value, float lower)
{
	if (!(cni_is_finite(value) && value >= lower))
		refuse(call, CN_ERROR_ARGUMENT, "%s %f; must be finite and >= %f", field, cni_bits_of(value), cni_bits_of(lower));
}

void cni_check_positive(cni_call *call, const char *field, float value)
{
	if (!(cni_is_finite(value) && value > 0.0f))
		cni_refuse_float(call, field, value, "must be finite and > 0");
}

void cni_check_at_least_or_default(cni_call *call, const char *field, float value)
{
	if (value != (float)CN_DEFAULT)
		cni_check_at_least(call, field, value, 0.0f);
}

void cni_check_positive_or_default(cni_call *call, const char *field, float value)
{
	if (value != (float)CN_DEFAULT)
		cni_check_positive(call, field, value);
}

void cni_check_above_0_or_default(cni_call *call, const char *field, float value, float upper)
{
	if (value == (float)CN_DEFAULT)
		return;
	cni_check_positive(call, field, value);
	cni_check_range(call, field, value, 0.0f, upper);
}

void cni_check_range(cni_call *call, const char *field, float value, float lower, float upper)
{
	if (!(value >= lower && value <= upper))
		refuse(call, CN_ERROR_ARGUMENT, "%s %f; must be from %f to %f", field, cni_bits_of(value), cni_bits_of(lower), cni_bits_of(upper));
}

void cni_check_within(cni_call *call, const char *field, cn_vec2 value, float most)
{
	cni_check_range(call, field, value.x, -most, most);
	cni_check_range(call, field, value.y, -most, most);
}

void cni_check_work_budget(cni_call *call, int32_t value)
{
	if (value != CN_DEFAULT)
		cni_check_range_int(call, "work_budget", value, 1, CNI_CONSTRAINT_BUDGET_MAX);
}

void cni_check_range_int(cni_call *call, const char *field, int32_t value, int32_t lower, int32_t upper)
{
	if (!(value >= lower && value <= upper))
		refuse(call, CN_ERROR_ARGUMENT, "%s %i; must be from %i to %i", field, (int64_t)value, (int64_t)lower, (int64_t)upper);
}

void cni_check_boundary(cni_call *call, const cn_world *world)
{
	cni_check(call, world == NULL || (world->locked == 0 && !world->events.in_step), CN_ERROR_LOCKED, "not while a callback runs");
}

void cni_check_solver(cni_call *call, int32_t solver, int32_t most)
{
	cni_check_range_int(call, "solver", solver, CN_SOLVER_AUTO, most);
	if ((solver == CN_SOLVER_DIRECT && !CNI_HAS_DIRECT) || (solver == CN_SOLVER_SEQUENTIAL && !CNI_HAS_SEQUENTIAL))
		refuse(call, CN_ERROR_ARGUMENT, "solver %i; this library was built without it (CN_NO_DIRECT, CN_NO_SEQUENTIAL)", (int64_t)solver);
}

void cni_check_flags(cni_call *call, const char *field, uint32_t value, uint32_t allowed)
{
	if ((value & ~allowed) != 0)
		refuse(call, CN_ERROR_ARGUMENT, "%s %x; only the bits of %x mean something", field, value, allowed);
}

void cni_check_position(cni_call *call, const char *field, cn_vec2 value)
{
	if (call->result != CN_OK)
		return;
	float limit = CNI_POSITION_MAX_UNITS * call->world->settings.length_unit;
	if (!(cni_abs(value.x) <= limit && cni_abs(value.y) <= limit))
		refuse(call, CN_ERROR_ARGUMENT, "%s (%f, %f); both must be finite and within +-%f", field, cni_bits_of(value.x), cni_bits_of(value.y), cni_bits_of(limit));
}

void cni_check_angle(cni_call *call, const char *field, float value)
{
	cni_check_range(call, field, value, -CNI_ANGLE_MAX_RAD, CNI_ANGLE_MAX_RAD);
}

void cni_check_shape_mass(cni_call *call, cn_mass_data mass)
{
	float kg = mass.mass_kg;
	float inertia = mass.inertia_kgm2 + kg * cni_length_sq(mass.center_m);
	if (!(kg == 0.0f || (kg >= 1e-20f && kg <= 1e20f)))
		cni_refuse_float(call, "mass of the shape", kg, "must be 0 or from 1e-20 to 1e20 kg: change the density");
	else if (!(inertia == 0.0f || (inertia >= 1e-35f && inertia <= 1e35f)))
		cni_refuse_float(call, "inertia of the shape", inertia, "must be 0 or from 1e-35 to 1e35 kg m^2: change the density");
}

void cni_check_material(cni_call *call, const cn_material *material)
{
	cni_check_range(call, "static_friction", material->static_friction, 0.0f, 100.0f);
	cni_check_range(call, "dynamic_friction", material->dynamic_friction, 0.0f, material->static_friction);
	cni_check_range(call, "restitution", material->restitution, 0.0f, CNI_HAS_RESTITUTION ? 1.0f : 0.0f);
	cni_check_range(call, "rolling_resistance", material->rolling_resistance, 0.0f, 1e3f);
	cni_check_range(call, "tangent_speed_mps", material->tangent_speed_mps, -1e4f, 1e4f);
	cni_check_range_int(call, "friction_mix", material->friction_mix, CN_MIX_AVERAGE, CN_MIX_MAXIMUM);
	cni_check_range_int(call, "restitution_mix", material->restitution_mix, CN_MIX_AVERAGE, CN_MIX_MAXIMUM);
}

/* ------------------------------------------------------------------ checks of handles */

/* Defines cni_check_<noun>. */
#define DEFINE_CHECK(noun, record, handle) \
	record *cni_check_##noun(cni_call *call, const char *field, handle given) \
	{ \
		record *found = call->result == CN_OK ? cni_live_##noun(call->world, given) : NULL; \
		if (found == NULL) \
			refuse(call, CN_ERROR_HANDLE, "%s %x; must be the handle of a live " #noun, field, given); \
		return found; \
	}

DEFINE_CHECK(body, cni_body, cn_body)
DEFINE_CHECK(shape, cni_shape, cn_shape)
DEFINE_CHECK(joint, cni_joint, cn_joint)
DEFINE_CHECK(constraint, cni_joint, cn_constraint)

/* ------------------------------------------------------------------ lists and slots */

void cni_check_output(cni_call *call, const void *out, int32_t capacity, const int32_t *out_count)
{
	cni_check_array(call, "out", out, capacity);
	cni_check_pointer(call, "out_count", out_count);
}

cni_list cni_list_begin(cni_call *call, uint32_t *out, int32_t capacity, const int32_t *out_count)
{
	cni_list list = { out, capacity, 0 };
	cni_check_output(call, out, capacity, out_count);
	return list;
}

cn_result cni_slots_reserve(cn_world *world, cni_handles *handles, cni_table *records, int32_t extra)
{
	int32_t used = cni_handles_used(handles);
	int32_t waiting = used - handles->count;
	cn_result result = cni_handles_reserve(handles, &world->memory, extra);
	if (result != CN_OK)
		return result;
	return cni_table_reserve(records, &world->memory, used + cni_max_i(extra - waiting, 0)) ? CN_OK : CN_ERROR_MEMORY;
}

/* ------------------------------------------------------------------ reading the sentence */

const char *cn_world_error_text(const cn_world *world)
{
	return world != NULL ? world->error : "";
}
