/*
 * examples/record/coding.c - calls to bytes and back, by the table of calls.
 *
 * A pointer is a byte, 0 for NULL, and then what it points to. struct_size is written as 0xFFFFFFFF where it is this machine's, for
 * pointers have other sizes elsewhere.
 */
#include "record/coding.h"

#include <stdlib.h>
#include <string.h>

/* ---- writing ---- */

static int32_t out_reserve(coding_out *out, uint64_t more)
{
	uint64_t capacity = out->capacity;
	uint8_t *bytes;
	if (out->count + more <= capacity)
		return 1;
	while (capacity < out->count + more)
		capacity = capacity < 4096 ? 4096 : 2 * capacity;
	bytes = (uint8_t *)realloc(out->bytes, (size_t)capacity);
	if (bytes == NULL) {
		out->failed = 1;
		return 0;
	}
	out->bytes = bytes;
	out->capacity = capacity;
	return 1;
}

void coding_put(coding_out *out, uint64_t value, int32_t bytes)
{
	int32_t k;
	if (!out_reserve(out, (uint64_t)bytes))
		return;
	for (k = 0; k < bytes; ++k)
		out->bytes[out->count++] = (uint8_t)(value >> 8 * k);
}

void coding_put_bytes(coding_out *out, const void *bytes, uint64_t count)
{
	if (count == 0 || !out_reserve(out, count))
		return;
	memcpy(out->bytes + out->count, bytes, (size_t)count);
	out->count += count;
}

void coding_free(coding_out *out)
{
	free(out->bytes);
	memset(out, 0, sizeof *out);
}

static void put_text(coding_out *out, const char *text)
{
	uint8_t length = 0;
	coding_put(out, text != NULL, 1);
	if (text == NULL)
		return;
	while (length <= CN_NAME_MAX_BYTES && text[length] != '\0')
		++length;
	coding_put(out, length, 1);
	coding_put_bytes(out, text, length);
}

static uint32_t word_at(const uint8_t *at)
{
	uint32_t word;
	memcpy(&word, at, sizeof word);
	return word;
}

static int32_t points_count(int32_t count) { return count < 0 ? 0 : count > 65536 ? 65536 : count; }

static void put_points(coding_out *out, const uint8_t *field)
{
	const uint8_t *points;
	int32_t count, k;
	memcpy(&points, field, sizeof points);
	memcpy(&count, field + sizeof points, sizeof count);
	coding_put(out, points != NULL, 1);
	for (k = 0; points != NULL && k < 2 * points_count(count); ++k)
		coding_put(out, word_at(points + 4 * (size_t)k), 4);
}

static void put_field(coding_out *out, const call_struct *type, const call_field *field, const uint8_t *item)
{
	const uint8_t *at = item + field->offset;
	const char *text;
	uint64_t value;
	int32_t k;
	if (field->kind == CALL_TEXT) {
		memcpy(&text, at, sizeof text);
		put_text(out, text);
	} else if (field->kind == CALL_POINTS) {
		coding_put(out, word_at(at + sizeof(void *)), 4); /* the count, once more: a reader needs it first */
		put_points(out, at);
	} else if (field->kind == CALL_SIZE) {
		coding_put(out, word_at(at) == type->bytes ? 0xFFFFFFFFu : word_at(at), 4);
	} else {
		for (k = 0; k < field->count; ++k) {
			if (field->kind == CALL_LONG) {
				memcpy(&value, at + 8 * (size_t)k, sizeof value);
				coding_put(out, value, 8);
			} else {
				coding_put(out, word_at(at + 4 * (size_t)k), 4);
			}
		}
	}
}

static void put_structs(coding_out *out, const call_struct *type, const void *items, int32_t count)
{
	int32_t k, n;
	coding_put(out, items != NULL, 1);
	for (k = 0; k < count && items != NULL; ++k)
		for (n = 0; n < type->field_count; ++n)
			put_field(out, type, &type->fields[n], (const uint8_t *)items + (size_t)k * type->bytes);
}

static void put_words(coding_out *out, const void *words, int32_t count)
{
	int32_t k;
	coding_put(out, words != NULL, 1);
	for (k = 0; k < count && words != NULL; ++k)
		coding_put(out, word_at((const uint8_t *)words + 4 * (size_t)k), 4);
}

void coding_put_call(coding_out *out, const call_entry *entry, const call_value *v)
{
	uint32_t word;
	int32_t k;
	for (k = 0; k < entry->param_count; ++k) { /* values first: counts are among them */
		if (entry->params[k].kind == CALL_LONG) {
			coding_put(out, v[k].l, 8);
		} else if (entry->params[k].kind < CALL_SIZE) {
			memcpy(&word, &v[k], sizeof word);
			coding_put(out, word, 4);
		}
	}
	for (k = 0; k < entry->param_count; ++k) {
		const call_param *p = &entry->params[k];
		int32_t things = call_things(entry, k, v);
		switch (p->kind) {
		case CALL_TEXT: put_text(out, (const char *)v[k].in); break;
		case CALL_STRUCT:
		case CALL_STRUCTS: put_structs(out, &call_structs[p->structs], v[k].in, things); break;
		case CALL_INOUT: put_structs(out, &call_structs[p->structs], v[k].out, 1); break;
		case CALL_IN:
		case CALL_INS: put_words(out, v[k].in, things); break;
		case CALL_RESULT:
		case CALL_OUT:
		case CALL_OUTS: coding_put(out, v[k].out != NULL, 1); break;
		default: break;
		}
	}
}

static int32_t gives_handles(const call_param *p, const call_value *v)
{
	return (p->kind == CALL_OUT || p->kind == CALL_OUTS) && v->out != NULL;
}

void coding_put_results(coding_out *out, const call_entry *entry, const call_value *v)
{
	int32_t k;
	for (k = 0; k < entry->param_count; ++k)
		if (gives_handles(&entry->params[k], &v[k]))
			put_words(out, v[k].out, call_things(entry, k, v));
}

/* ---- reading ---- */

coding_in coding_begin(const void *bytes, uint64_t count)
{
	coding_in in;
	memset(&in, 0, sizeof in);
	in.at = (const uint8_t *)bytes;
	in.end = count > 0 ? in.at + (size_t)count : in.at;
	in.size = count;
	return in;
}

void coding_in_free(coding_in *in)
{
	while (in->piece_count > 0)
		free(in->pieces[--in->piece_count]);
}

uint64_t coding_get(coding_in *in, int32_t bytes)
{
	uint64_t value = 0;
	int32_t k;
	if (in->failed || in->end - in->at < bytes) {
		in->failed = 1;
		return 0;
	}
	for (k = 0; k < bytes; ++k)
		value |= (uint64_t)in->at[k] << 8 * k;
	in->at += bytes;
	return value;
}

float coding_get_float(coding_in *in)
{
	uint32_t word = (uint32_t)coding_get(in, 4);
	float x;
	memcpy(&x, &word, sizeof x);
	return x;
}

void *coding_room(coding_in *in, uint64_t count, uint64_t bytes)
{
	void *piece;
	/* Each thing takes a byte of the record at least. */
	if (in->failed || count > in->size + 1 || in->piece_count == (int32_t)(sizeof in->pieces / sizeof in->pieces[0])) {
		in->failed = 1;
		return NULL;
	}
	piece = calloc((size_t)count + 1, (size_t)bytes);
	if (piece == NULL)
		in->failed = 1;
	else
		in->pieces[in->piece_count++] = piece;
	return piece;
}

static char *get_text(coding_in *in)
{
	int32_t there = (int32_t)coding_get(in, 1), length, k;
	char *text;
	if (!there)
		return NULL;
	length = (int32_t)coding_get(in, 1);
	text = (char *)coding_room(in, (uint64_t)length, 1);
	for (k = 0; k < length && text != NULL; ++k)
		text[k] = (char)coding_get(in, 1);
	return text;
}

static void get_word(coding_in *in, uint8_t *to)
{
	uint32_t word = (uint32_t)coding_get(in, 4);
	memcpy(to, &word, sizeof word);
}

static void get_points(coding_in *in, uint8_t *field)
{
	int32_t count = points_count((int32_t)coding_get(in, 4)), k;
	uint8_t *points = NULL;
	if (coding_get(in, 1)) {
		points = (uint8_t *)coding_room(in, (uint64_t)count, 8);
		for (k = 0; k < 2 * count && points != NULL && !in->failed; ++k)
			get_word(in, points + 4 * (size_t)k);
	}
	memcpy(field, &points, sizeof points);
}

static void get_field(coding_in *in, const call_struct *type, const call_field *field, uint8_t *item)
{
	uint8_t *at = item + field->offset;
	const char *text;
	uint64_t value;
	uint32_t word;
	int32_t k;
	if (field->kind == CALL_TEXT) {
		text = get_text(in);
		memcpy(at, &text, sizeof text);
	} else if (field->kind == CALL_POINTS) {
		get_points(in, at);
	} else if (field->kind == CALL_SIZE) {
		word = (uint32_t)coding_get(in, 4);
		word = word == 0xFFFFFFFFu ? type->bytes : word;
		memcpy(at, &word, sizeof word);
	} else {
		for (k = 0; k < field->count; ++k) {
			if (field->kind == CALL_LONG) {
				value = coding_get(in, 8);
				memcpy(at + 8 * (size_t)k, &value, sizeof value);
			} else {
				get_word(in, at + 4 * (size_t)k);
			}
		}
	}
}

static void *get_structs(coding_in *in, const call_struct *type, int32_t count)
{
	uint8_t *items;
	int32_t k, n;
	if (!coding_get(in, 1))
		return NULL;
	items = (uint8_t *)coding_room(in, (uint64_t)count, type->bytes);
	for (k = 0; k < count && items != NULL && !in->failed; ++k)
		for (n = 0; n < type->field_count; ++n)
			get_field(in, type, &type->fields[n], items + (size_t)k * type->bytes);
	return items;
}

static void *get_words(coding_in *in, int32_t count)
{
	uint8_t *words;
	int32_t k;
	if (!coding_get(in, 1))
		return NULL;
	words = (uint8_t *)coding_room(in, (uint64_t)count, 4);
	for (k = 0; k < count && words != NULL && !in->failed; ++k)
		get_word(in, words + 4 * (size_t)k);
	return words;
}

static void *get_room(coding_in *in, int32_t things, uint64_t bytes)
{
	if (!coding_get(in, 1))
		return NULL;
	return coding_room(in, (uint64_t)things, bytes);
}

void coding_get_call(coding_in *in, const call_entry *entry, call_value *v)
{
	uint32_t word;
	int32_t k;
	memset(v, 0, sizeof *v * CALL_PARAMS_MAX);
	for (k = 0; k < entry->param_count; ++k) {
		if (entry->params[k].kind == CALL_LONG) {
			v[k].l = coding_get(in, 8);
		} else if (entry->params[k].kind < CALL_SIZE) {
			word = (uint32_t)coding_get(in, 4);
			memcpy(&v[k], &word, sizeof word);
		}
	}
	for (k = 0; k < entry->param_count; ++k) {
		const call_param *p = &entry->params[k];
		int32_t things = call_things(entry, k, v);
		switch (p->kind) {
		case CALL_TEXT: v[k].in = get_text(in); break;
		case CALL_STRUCT:
		case CALL_STRUCTS: v[k].in = get_structs(in, &call_structs[p->structs], things); break;
		case CALL_INOUT: v[k].out = get_structs(in, &call_structs[p->structs], 1); break;
		case CALL_IN:
		case CALL_INS: v[k].in = get_words(in, things); break;
		case CALL_RESULT: v[k].out = get_room(in, 1, call_structs[p->structs].bytes); break;
		case CALL_OUT:
		case CALL_OUTS: v[k].out = get_room(in, things, 4); break;
		default: break;
		}
	}
}

int32_t coding_results_match(coding_in *in, const call_entry *entry, const call_value *v)
{
	int32_t k, n, same = 1;
	for (k = 0; k < entry->param_count; ++k) {
		if (!gives_handles(&entry->params[k], &v[k]))
			continue;
		same &= coding_get(in, 1) == 1;
		for (n = 0; n < call_things(entry, k, v); ++n)
			same &= (uint32_t)coding_get(in, 4) == word_at((const uint8_t *)v[k].out + 4 * (size_t)n);
	}
	return same && !in->failed;
}
