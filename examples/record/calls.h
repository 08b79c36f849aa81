/*
 * examples/record/calls.h - every call that changes a world as an entry of a table: its name, its parameters down to the fields of
 * structs, and a function that makes it. bindings/record/calls.h has the table, written from the public header.
 *
 *     call_value v[CALL_PARAMS_MAX];
 *     v[0].w = body; v[1].f = 1.0f; v[2].f = 0.0f;
 *     call_entries[call_find("cn_body_apply_force")].invoke(world, v);
 */
#ifndef CAIRN_EXAMPLES_CALLS_H
#define CAIRN_EXAMPLES_CALLS_H

#define CAIRN_RECORD_PLAIN_NAMES /* the library's own functions, not the recorded ones */
#include "cairn.h"

#define CALL_PARAMS_MAX 8

enum {
	/* values, also fields of structs */
	CALL_FLOAT, CALL_INT, CALL_WORD, CALL_LONG, CALL_BODY, CALL_SHAPE, CALL_JOINT, CALL_CONSTRAINT,
	CALL_SIZE,    /* field struct_size */
	CALL_TEXT,    /* const char *, at most CN_NAME_MAX_BYTES */
	CALL_POINTS,  /* field: const cn_vec2 *, as many as the int32_t behind it says */
	/* pointers */
	CALL_STRUCT,  /* const T * */
	CALL_STRUCTS, /* const T *, count of them */
	CALL_IN, CALL_INS,   /* const handle *; count of them */
	CALL_OUT, CALL_OUTS, /* handle *; count of them */
	CALL_INOUT,   /* T *: the caller's state, read and written */
	CALL_RESULT   /* T *: written only */
};

typedef union call_value {
	float f;
	int32_t i;
	uint32_t w;
	uint64_t l;
	const void *in;
	void *out;
} call_value;

typedef struct call_field {
	const char *name;
	uint32_t offset;
	int32_t count;
	int32_t kind;
} call_field;

typedef struct call_struct {
	const char *name;
	const call_field *fields;
	int32_t field_count;
	uint32_t bytes;
	void (*init)(void *item); /* sets defaults; NULL: it has none */
} call_struct;

typedef struct call_param {
	const char *name;
	int32_t kind;
	int32_t of;      /* kind of a handle behind a pointer */
	int32_t structs; /* index into call_structs, or -1 */
	int32_t count;   /* index of the parameter with the count, or -1 */
} call_param;

typedef struct call_entry {
	const char *name;
	cn_result (*invoke)(cn_world *world, const call_value *v);
	const call_param *params;
	int32_t param_count;
} call_entry;

extern const call_struct call_structs[];
extern const call_entry call_entries[];
extern const int32_t call_count;

/* Index of a function, or -1. */
int32_t call_find(const char *name);
/* Number of things behind a pointer parameter: 1, or what the count says, at least 0. */
int32_t call_things(const call_entry *entry, int32_t param, const call_value *v);

#endif
