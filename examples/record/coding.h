/*
 * examples/record/coding.h - numbers, structs and whole calls as little-endian bytes, the same on every machine.
 */
#ifndef CAIRN_EXAMPLES_CODING_H
#define CAIRN_EXAMPLES_CODING_H

#include "record/calls.h"

/* Bytes that grow. */
typedef struct coding_out {
	uint8_t *bytes;
	uint64_t count, capacity;
	int32_t failed; /* 1: no memory */
} coding_out;

void coding_put(coding_out *out, uint64_t value, int32_t bytes);
void coding_put_bytes(coding_out *out, const void *bytes, uint64_t count);
void coding_free(coding_out *out);
/* The arguments of a call, as they are before it. */
void coding_put_call(coding_out *out, const call_entry *entry, const call_value *v);
/* What it has given: handles. */
void coding_put_results(coding_out *out, const call_entry *entry, const call_value *v);

/* Bytes that are read; memory for what pointers point to. */
typedef struct coding_in {
	const uint8_t *at, *end;
	uint64_t size;
	int32_t failed;     /* 1: they end too early, or say what cannot be */
	void *pieces[32];   /* freed by coding_in_free */
	int32_t piece_count;
} coding_in;

coding_in coding_begin(const void *bytes, uint64_t count);
uint64_t coding_get(coding_in *in, int32_t bytes);
float coding_get_float(coding_in *in);
/* count things of so many bytes, zeroed; NULL after a failure. */
void *coding_room(coding_in *in, uint64_t count, uint64_t bytes);
void coding_get_call(coding_in *in, const call_entry *entry, call_value *v);
/* 1: these are the handles that the call gives now. */
int32_t coding_results_match(coding_in *in, const call_entry *entry, const call_value *v);
void coding_in_free(coding_in *in);

#endif
