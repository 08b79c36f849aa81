/*
 * save/file_codec.c - chunks and fields to bytes and back (picture in file.h).
 *
 * Reading trusts nothing: the frames of all chunks are checked first, so that they tile the file exactly; a chunk is found by its
 * tag; a field is checked by its kind. Whatever is wrong sets f->result, and from then on reading gives zeros.
 */
#include "save/file.h"

#include <string.h>

#define HEAD_BYTES 16u
#define COUNT_MAX (1 << 30)

uint64_t cni_file_get(const uint8_t *from, uint32_t bytes)
{
	uint64_t value = 0;
	for (uint32_t k = 0; k < bytes; ++k)
		value |= (uint64_t)from[k] << 8 * k;
	return value;
}

void cni_file_put(uint8_t *to, uint64_t value, uint32_t bytes)
{
	for (uint32_t k = 0; k < bytes; ++k)
		to[k] = (uint8_t)(value >> 8 * k);
}

/* FNV-1a (Fowler, Noll, Vo, 1991): each step can be undone, so a single changed byte always shows. */
uint64_t cni_file_checksum(const uint8_t *bytes, uint64_t count)
{
	uint64_t hash = 0xCBF29CE484222325u;
	for (uint64_t k = 0; k < count; ++k)
		hash = (hash ^ bytes[k]) * 0x100000001B3u;
	return hash;
}

cni_file cni_file_begin(int32_t mode, uint8_t *out)
{
	cni_file f;
	memset(&f, 0, sizeof f);
	f.mode = mode;
	f.out = out;
	return f;
}

void cni_file_fail(cni_file *f, cn_result result)
{
	if (f->result == CN_OK)
		f->result = result;
	f->at = f->end;
}

/* ---- chunks ---- */

/* Bytes of the chunk's records, or UINT64_MAX if they do not fit. */
static uint64_t records_bytes(const uint8_t *head, uint64_t most)
{
	uint64_t record = cni_file_get(head + 4, 4), count = cni_file_get(head + 8, 8);
	if (record == 0 || count > (uint64_t)COUNT_MAX || count > most / record)
		return UINT64_MAX;
	return record * count;
}

cni_file cni_file_read(const uint8_t *chunks, uint64_t bytes)
{
	cni_file f = cni_file_begin(CNI_FILE_READ, NULL);
	uint64_t at = 0;
	f.in = chunks;
	f.bytes = bytes;
	while (at < bytes && f.result == CN_OK) {
		uint64_t records = bytes - at < HEAD_BYTES ? UINT64_MAX : records_bytes(chunks + at, bytes - at - HEAD_BYTES);
		cni_file_need(&f, records != UINT64_MAX, CN_ERROR_FORMAT);
		at += HEAD_BYTES + records;
	}
	return f;
}

/* The head of a chunk; NULL: there is none, or more than one, or the file has failed. */
static const uint8_t *chunk_find(const cni_file *f, const char *tag)
{
	const uint8_t *found = NULL;
	for (uint64_t at = 0; at < f->bytes && f->result == CN_OK; at += HEAD_BYTES + records_bytes(f->in + at, f->bytes)) {
		if (memcmp(f->in + at, tag, 4) != 0)
			continue;
		if (found != NULL)
			return NULL;
		found = f->in + at;
	}
	return found;
}

int32_t cni_file_has(const cni_file *f, const char *tag)
{
	return chunk_find(f, tag) != NULL;
}

int32_t cni_file_count(cni_file *f, const char *tag)
{
	const uint8_t *head = chunk_find(f, tag);
	cni_file_need(f, head != NULL, CN_ERROR_FORMAT);
	return head != NULL ? (int32_t)cni_file_get(head + 8, 8) : 0;
}

static int32_t chunk_open(cni_file *f, const char *tag, uint32_t least, uint32_t *stride)
{
	const uint8_t *head = chunk_find(f, tag);
	*stride = least;
	if (head == NULL || cni_file_get(head + 4, 4) < least) {
		cni_file_fail(f, CN_ERROR_FORMAT);
		return 0;
	}
	*stride = (uint32_t)cni_file_get(head + 4, 4);
	f->at = head + HEAD_BYTES;
	f->end = f->at + (size_t)records_bytes(head, f->bytes);
	return (int32_t)cni_file_get(head + 8, 8);
}

static void bytes_put(cni_file *f, uint64_t value, uint32_t bytes)
{
	if (f->mode == CNI_FILE_WRITE)
		cni_file_put(f->out + f->bytes, value, bytes);
	f->bytes += bytes;
}

int32_t cni_file_chunk(cni_file *f, const char *tag, uint32_t least, int32_t count, uint32_t *stride)
{
	if (f->mode == CNI_FILE_READ)
		return chunk_open(f, tag, least, stride);
	for (uint32_t k = 0; k < 4; ++k)
		bytes_put(f, (uint8_t)tag[k], 1);
	bytes_put(f, least, 4);
	bytes_put(f, (uint64_t)count, 8);
	*stride = least;
	return count;
}

int32_t cni_file_chunk_begin(cni_file *f, const char *tag, uint32_t bytes)
{
	uint32_t stride;
	int32_t count = cni_file_chunk(f, tag, bytes, 0, &stride);
	cni_file_need(f, stride == bytes, CN_ERROR_FORMAT);
	f->begun = f->bytes;
	return count;
}

void cni_file_chunk_end(cni_file *f, uint32_t bytes)
{
	if (f->mode == CNI_FILE_READ)
		cni_file_need(f, cni_file_left(f) == 0, CN_ERROR_FORMAT);
	else if (f->mode == CNI_FILE_WRITE)
		cni_file_put(f->out + f->begun - 8, (f->bytes - f->begun) / bytes, 8);
}

uint64_t cni_file_left(const cni_file *f)
{
	return f->result == CN_OK ? (uint64_t)(f->end - f->at) : 0;
}

static uint64_t bytes_get(cni_file *f, uint32_t bytes)
{
	if (cni_file_left(f) < bytes) {
		cni_file_fail(f, CN_ERROR_FORMAT);
		return 0;
	}
	uint64_t value = cni_file_get(f->at, bytes);
	f->at += bytes;
	return value;
}

uint32_t cni_file_word(cni_file *f, uint32_t word)
{
	if (f->mode == CNI_FILE_READ)
		return (uint32_t)bytes_get(f, 4);
	bytes_put(f, word, 4);
	return word;
}

void cni_file_raw(cni_file *f, uint8_t *bytes, uint32_t count)
{
	for (uint32_t k = 0; k < count; ++k) {
		if (f->mode == CNI_FILE_READ)
			bytes[k] = (uint8_t)bytes_get(f, 1);
		else
			bytes_put(f, bytes[k], 1);
	}
}

/* ---- fields ---- */

uint32_t cni_record_file_bytes(const cni_record *record)
{
	uint32_t bytes = 0;
	for (int32_t k = 0; k < record->count; ++k)
		if (record->fields[k].kind > CNI_FIELD_SAVED)
			bytes += record->fields[k].count * CNI_FIELD_BYTES(record->fields[k].kind);
	return bytes;
}

/* Memory to number: every kind has the width of its C type. */
static uint64_t field_load(const void *from, uint32_t bytes)
{
	uint16_t half;
	uint32_t word;
	uint64_t value;
	switch (bytes) {
	case 1: return *(const uint8_t *)from;
	case 2: memcpy(&half, from, sizeof half); return half;
	case 4: memcpy(&word, from, sizeof word); return word;
	default: memcpy(&value, from, sizeof value); return value;
	}
}

static void field_store(void *to, uint64_t value, uint32_t bytes)
{
	uint16_t half = (uint16_t)value;
	uint32_t word = (uint32_t)value;
	switch (bytes) {
	case 1: *(uint8_t *)to = (uint8_t)value; break;
	case 2: memcpy(to, &half, sizeof half); break;
	case 4: memcpy(to, &word, sizeof word); break;
	default: memcpy(to, &value, sizeof value); break;
	}
}

static int32_t value_is_good(const cni_file *f, uint32_t kind, uint64_t value)
{
	uint32_t word = (uint32_t)value;
	if (kind < CNI_FIELD_FLOAT || kind == CNI_FIELD_LONG) /* of any value */
		return 1;
	switch (kind) {
	case CNI_FIELD_FLOAT: return (word & 0x7F800000u) != 0x7F800000u;
	case CNI_FIELD_BIT: return word <= 1u;
	case CNI_FIELD_COUNT: return word <= (uint32_t)COUNT_MAX;
	case CNI_FIELD_STAMP: return word <= f->step_count;
	default: return word == 0xFFFFFFFFu || word < (uint32_t)f->limits[kind];
	}
}

static void field_pass(cni_file *f, const cni_field *field, uint8_t *item)
{
	uint32_t bytes = CNI_FIELD_BYTES(field->kind);
	if (field->kind <= CNI_FIELD_SAVED)
		return;
	for (uint32_t k = 0; k < field->count; ++k, item += bytes) {
		if (f->mode == CNI_FILE_READ) {
			uint64_t value = bytes_get(f, bytes);
			cni_file_need(f, value_is_good(f, field->kind, value), CN_ERROR_FORMAT);
			field_store(item, f->result == CN_OK ? value : 0, bytes);
		} else {
			bytes_put(f, field_load(item, bytes) & (field->kind == CNI_FIELD_DRIVE ? (1u << CNI_EXTERNAL_COLOR_SHIFT) - 1u : UINT64_MAX), bytes);
		}
	}
}

static void zeros_pass(cni_file *f, uint32_t count)
{
	if (count == 0)
		return;
	if (f->mode == CNI_FILE_WRITE)
		memset(f->out + f->bytes, 0, count);
	if (f->mode != CNI_FILE_READ)
		f->bytes += count;
	else if (cni_file_left(f) < count)
		cni_file_fail(f, CN_ERROR_FORMAT);
	else
		f->at += count;
}

void cni_file_record(cni_file *f, const cni_record *record, void *item, uint32_t stride)
{
	uint32_t known = cni_record_file_bytes(record);
	if (f->mode == CNI_FILE_MEASURE || item == NULL) {
		zeros_pass(f, stride);
		return;
	}
	for (int32_t k = 0; k < record->count && f->result == CN_OK; ++k)
		field_pass(f, &record->fields[k], (uint8_t *)item + record->fields[k].offset);
	zeros_pass(f, stride - known);
}
