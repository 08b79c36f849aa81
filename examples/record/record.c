/*
 * examples/record/record.c - the recorder, and the functions of bindings/record/cairn_record.h.
 */
#include "record/record.h"

#include <stdlib.h>
#include <string.h>

#define RECORDED_MAX 16
#define CHECK_STEPS 30
#define KEY_STEPS 600

typedef struct recorder {
	cn_world *world; /* NULL: unused */
	record_sink *sink;
	void *user;
	record_options options;
	uint64_t step;
	int32_t inside; /* a call is being made: what callbacks call is refused and not recorded */
	coding_out out;
} recorder;

static recorder recorders[RECORDED_MAX];
static int32_t recorder_count; /* in use: 0 costs a call one comparison */

static recorder *recorder_of(const cn_world *world)
{
	int32_t k;
	for (k = 0; k < RECORDED_MAX && recorder_count > 0; ++k)
		if (recorders[k].world == world && world != NULL)
			return &recorders[k];
	return NULL;
}

void record_to_file(const void *bytes, uint64_t count, void *user)
{
	FILE *file = (FILE *)user;
	if (fwrite(bytes, 1, (size_t)count, file) == (size_t)count)
		(void)fflush(file);
}

void record_to_memory(const void *bytes, uint64_t count, void *user)
{
	coding_put_bytes((coding_out *)user, bytes, count);
}

/* ---- records ---- */

/* Sends what was coded as one record. */
static void send(recorder *r, int32_t kind)
{
	uint8_t head[9];
	int32_t k;
	head[0] = (uint8_t)kind;
	for (k = 0; k < 8; ++k)
		head[1 + k] = (uint8_t)(r->out.count >> 8 * k);
	r->sink(head, sizeof head, r->user);
	r->sink(r->out.bytes, r->out.count, r->user);
	r->out.count = 0;
}

static void send_names(recorder *r)
{
	int32_t k;
	coding_put(&r->out, (uint64_t)call_count, 2);
	for (k = 0; k < call_count; ++k) {
		coding_put(&r->out, strlen(call_entries[k].name), 1);
		coding_put_bytes(&r->out, call_entries[k].name, strlen(call_entries[k].name));
	}
	send(r, RECORD_NAMES);
}

static int32_t send_key(recorder *r)
{
	uint64_t bytes = 0;
	void *file;
	int32_t good = cn_world_write_size(r->world, &bytes) == CN_OK;
	file = good ? malloc((size_t)bytes) : NULL;
	good = file != NULL && cn_world_write(r->world, file, bytes, NULL) == CN_OK;
	if (good) {
		coding_put(&r->out, r->step, 8);
		coding_put_bytes(&r->out, file, bytes);
		send(r, RECORD_KEY);
	}
	free(file);
	return good;
}

static void put_float(coding_out *out, float x)
{
	uint32_t word;
	memcpy(&word, &x, sizeof word);
	coding_put(out, word, 4);
}

static void put_body(coding_out *out, const cn_world *world, cn_body body)
{
	cn_pose pose;
	cn_velocity v;
	uint32_t flags = 0;
	memset(&pose, 0, sizeof pose);
	memset(&v, 0, sizeof v);
	(void)cn_body_get_pose(world, body, &pose);
	(void)cn_body_get_velocity(world, body, &v);
	(void)cn_body_get_flags(world, body, &flags);
	coding_put(out, body, 4);
	put_float(out, pose.position_m.x);
	put_float(out, pose.position_m.y);
	put_float(out, pose.cosine);
	put_float(out, pose.sine);
	put_float(out, v.linear_mps.x);
	put_float(out, v.linear_mps.y);
	put_float(out, v.angular_radps);
	coding_put(out, flags & CN_BODY_AWAKE ? 1u : 0u, 4);
}

void record_put_check(coding_out *out, const cn_world *world, uint64_t step)
{
	uint64_t hash = 0;
	int32_t count = 0, k;
	cn_body *bodies;
	(void)cn_world_hash(world, &hash);
	(void)cn_world_get_bodies(world, NULL, 0, &count);
	bodies = (cn_body *)calloc((size_t)count + 1, sizeof *bodies);
	if (bodies == NULL || cn_world_get_bodies(world, bodies, count, &count) != CN_OK)
		count = 0;
	coding_put(out, step, 8);
	coding_put(out, hash, 8);
	coding_put(out, (uint64_t)count, 4);
	for (k = 0; k < count; ++k)
		put_body(out, world, bodies[k]);
	free(bodies);
}

static void send_check(recorder *r)
{
	record_put_check(&r->out, r->world, r->step);
	send(r, RECORD_CHECK);
}

/* ---- beginning and end ---- */

int32_t record_begin(cn_world *world, const record_options *options, record_sink *sink, void *user)
{
	recorder *r = NULL;
	int32_t k;
	for (k = 0; k < RECORDED_MAX && r == NULL; ++k)
		if (recorders[k].world == NULL)
			r = &recorders[k];
	if (r == NULL || recorder_of(world) != NULL)
		return 0;
	memset(r, 0, sizeof *r);
	r->world = world;
	r->sink = sink;
	r->user = user;
	r->options.check_steps = options != NULL && options->check_steps > 0 ? options->check_steps : CHECK_STEPS;
	r->options.key_steps = options != NULL && options->key_steps > 0 ? options->key_steps : KEY_STEPS;
	sink("CairnRec", 8, user);
	send_names(r);
	++recorder_count;
	if (send_key(r))
		return 1;
	r->world = NULL;
	--recorder_count;
	return 0;
}

void record_end(cn_world *world)
{
	recorder *r = recorder_of(world);
	if (r == NULL || r->inside)
		return;
	send_check(r);
	coding_free(&r->out);
	r->world = NULL;
	--recorder_count;
}

/* ---- calls ---- */

static int32_t steps(const call_entry *entry)
{
	return strcmp(entry->name, "cn_world_step") == 0 || strcmp(entry->name, "cn_world_update") == 0;
}

cn_result record_call(cn_world *world, int32_t call, call_value *v)
{
	const call_entry *entry = &call_entries[call];
	recorder *r = recorder_of(world);
	cn_result result;
	if (r == NULL || r->inside)
		return entry->invoke(world, v);
	coding_put(&r->out, (uint64_t)call, 2);
	coding_put_call(&r->out, entry, v);
	send(r, RECORD_CALL);
	r->inside = 1;
	result = entry->invoke(world, v);
	r->inside = 0;
	coding_put(&r->out, (uint32_t)result, 4);
	if (result == CN_OK)
		coding_put_results(&r->out, entry, v);
	send(r, RECORD_RESULT);
	if (!steps(entry) || result != CN_OK)
		return result;
	++r->step;
	if (r->step % (uint64_t)r->options.check_steps == 0)
		send_check(r);
	if (r->step % (uint64_t)r->options.key_steps == 0)
		(void)send_key(r);
	return result;
}

#include "../../bindings/record/cairn_record.h"

/* Another state: the recording goes on from there. */
cn_result cnr_world_restore(cn_world *world, const void *save, uint64_t bytes)
{
	cn_result result = cn_world_restore(world, save, bytes);
	recorder *r = recorder_of(world);
	if (r != NULL && result == CN_OK) {
		coding_put(&r->out, r->step, 8);
		send(r, RECORD_JUMP);
		(void)send_key(r);
	}
	return result;
}

void cnr_world_destroy(cn_world *world)
{
	record_end(world);
	cn_world_destroy(world);
}

#include "../../bindings/record/wrappers.h"
