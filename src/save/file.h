/*
 * save/file.h - a world as portable bytes: what the files of cn_world_write and cn_world_read share.
 *
 * A file is a header of 32 bytes and chunks:
 *
 *   header   "CairnWld" | version (4) | 0 (4) | bytes of the file (8) | checksum of all that follows (8)
 *   chunk    tag (4 letters) | bytes of a record (4) | number of records (8) | records
 *
 * A reader skips chunks that it does not know, and the bytes of a record behind the fields that it knows. So a later version
 * appends fields and adds chunks, and reads the files of earlier ones.
 */
#ifndef CNI_WORLD_FILE_H
#define CNI_WORLD_FILE_H

#include "model/world.h"

/* Kinds of fields. From CNI_FIELD_BODY on: an int32 index that is CNI_NONE or below a limit. */
enum {
	CNI_FIELD_DERIVED, /* bytes that are not in the file */
	CNI_FIELD_SAVED,   /* ... of cn_world, but copied into a save: save/save.c */
	CNI_FIELD_BYTE,
	CNI_FIELD_HALF,    /* 16 bits */
	CNI_FIELD_WORD,    /* 32 bits of any meaning */
	CNI_FIELD_DRIVE,   /* flags of a cni_external, without the colours of joints: lanes that are kept do not set them again */
	CNI_FIELD_FLOAT,   /* finite */
	CNI_FIELD_BIT,     /* int32: 0 or 1 */
	CNI_FIELD_COUNT,   /* int32: 0 .. 2^30 */
	CNI_FIELD_STAMP,   /* a number of a step that is over: at most the step count */
	CNI_FIELD_LONG,    /* 64 bits */
	CNI_FIELD_BODY,
	CNI_FIELD_SHAPE,
	CNI_FIELD_JOINT,
	CNI_FIELD_PROXY,
	CNI_FIELD_CONTACT,
	CNI_FIELD_ISLAND,
	CNI_FIELD_BLOCK,
	CNI_FIELD_JOINT_KEY,
	CNI_FIELD_CONTACT_KEY,
	CNI_FIELD_KINDS
};

typedef struct cni_field {
	uint16_t offset;
	uint16_t count;
	uint32_t kind;
} cni_field;

#define CNI_FIELD_BYTES(kind) ((kind) == CNI_FIELD_LONG ? 8u : (kind) == CNI_FIELD_HALF ? 2u : (kind) <= CNI_FIELD_BYTE ? 1u : 4u)

/* All fields of a kind of record. */
typedef struct cni_record {
	const cni_field *fields;
	int32_t count;
	int32_t bytes;       /* of the record in memory */
} cni_record;

enum { CNI_FILE_MEASURE, CNI_FILE_WRITE, CNI_FILE_READ };

typedef struct cni_file {
	uint8_t *out;            /* WRITE */
	const uint8_t *in;       /* READ: the chunks */
	uint64_t bytes;          /* READ: of the chunks; else: passed so far */
	uint64_t begun;          /* ... before the records of the chunk of cni_file_chunk_begin */
	const uint8_t *at;       /* READ: the next byte of the present chunk */
	const uint8_t *end;      /* ... and its end */
	int32_t mode;
	cn_result result;        /* READ: CN_OK until something is wrong */
	uint32_t step_count;
	int32_t limits[CNI_FIELD_KINDS];
} cni_file;

/* ---- file_codec.c: chunks and fields to bytes and back, in little-endian order on every machine */

/* MEASURE, or WRITE to out. */
cni_file cni_file_begin(int32_t mode, uint8_t *out);
/* READ: checks the chunks' frames. */
cni_file cni_file_read(const uint8_t *chunks, uint64_t bytes);
void cni_file_fail(cni_file *f, cn_result result);
/* Fails unless good. */
static inline void cni_file_need(cni_file *f, int32_t good, cn_result otherwise)
{
	if (!good)
		cni_file_fail(f, otherwise);
}
/* Begins a chunk: writes its head, or finds it. Returns the number of records; READ: 0 after a failure. least: the bytes of a
   record in the file; when reading, the least that a record must have. *stride: bytes from one record to the next. */
int32_t cni_file_chunk(cni_file *f, const char *tag, uint32_t least, int32_t count, uint32_t *stride);
/* A chunk of records that have no more fields than now: in READ their bytes must be exactly `bytes`. Returns their number in READ; in
   the other modes it follows from what is passed until the end. */
int32_t cni_file_chunk_begin(cni_file *f, const char *tag, uint32_t bytes);
/* READ: nothing must be left. */
void cni_file_chunk_end(cni_file *f, uint32_t bytes);
/* READ: is there such a chunk? */
int32_t cni_file_has(const cni_file *f, const char *tag);
/* The number of records of a chunk, in READ. */
int32_t cni_file_count(cni_file *f, const char *tag);
/* Bytes of a record in the file. */
uint32_t cni_record_file_bytes(const cni_record *record);
/* Passes one record; NULL: one of zeros, which READ skips. */
void cni_file_record(cni_file *f, const cni_record *record, void *item, uint32_t stride);
/* Single numbers within a chunk. READ beyond its end fails and gives 0. */
uint32_t cni_file_word(cni_file *f, uint32_t word);
void cni_file_raw(cni_file *f, uint8_t *bytes, uint32_t count);
/* Bytes of the present chunk that are left, in READ. */
uint64_t cni_file_left(const cni_file *f);
uint64_t cni_file_get(const uint8_t *from, uint32_t bytes);
void cni_file_put(uint8_t *to, uint64_t value, uint32_t bytes);
uint64_t cni_file_checksum(const uint8_t *bytes, uint64_t count);

/* ---- file_fields.c: the fields of every record, and the order of the chunks */

/* Settings, from the chunk of the world alone: READ needs them before the world exists. */
void cni_file_settings(cni_file *f, cni_settings *settings);
/* Passes the whole world; READ: into one that was created empty, with the settings of the file. */
void cni_file_world(cn_world *world, cni_file *f);
/* The k-th kind of records, that of cn_world first; NULL: there are no more. */
const cni_record *cni_file_kind(int32_t k);
/* Blocks with extra rows: all, where some contact needs them, else none, as in most worlds. */
int32_t cni_file_extra_count(const cn_world *world);
/* Has some sleeper a conveyor or rolling resistance? Of those awake blocks have a flag: cni_file_extra_count. */
int32_t cni_file_needs_extra(const cn_world *world);
/* The k-th array of the world's state; NULL: there are no more. */
cni_array *cni_file_array(cn_world *world, int32_t k);

/* ---- file_rebuild.c: what a file does not hold, as it follows from the rest */

/* Geometry and names: their chunks. */
void cni_file_pieces(cn_world *world, cni_file *f);
/* Counts that follow from the records, READ only; and memory that goes with them. */
void cni_file_counts(cn_world *world, cni_file *f);
/* The shapes' boxes, from the proxies. */
void cni_file_boxes(cn_world *world, cni_file *f);
/* Flags of contacts that files of earlier versions do not have, and extra rows of those asleep; after cni_file_world_holds. */
void cni_file_contacts(cn_world *world, cni_file *f);
/* The broadphase, after all checks. */
void cni_file_broadphase(cn_world *world, cni_file *f);

/* ---- file_check.c: whether what was read is a world */

/* Handles: before anything asks them which slots are alive. 1: good. */
int32_t cni_file_handles_hold(const cni_handles *handles);
/* All else: indices are in range already. 1: good. */
int32_t cni_file_world_holds(const cn_world *world);

/* ---- save.c: saves in the caller's memory, which have the same fields */

/* Does the header say that these bytes are a save of this build? */
int32_t cni_save_is_one(const void *save, uint64_t bytes);
uint64_t cni_save_checksum(const void *bytes, uint64_t count);

#endif
