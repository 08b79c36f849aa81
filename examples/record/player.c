/*
 * examples/record/player.c - the player, and the search for the first difference.
 */
#include "record/player.h"
#include "record/record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct record {
	int32_t kind; /* 0: the end */
	const uint8_t *bytes;
	uint64_t count;
} record;

static record record_at(const player *p, uint64_t at)
{
	record r = { 0, NULL, 0 };
	coding_in in;
	if (p->count - at < 9)
		return r;
	in = coding_begin(p->bytes + at, 9);
	r.kind = (int32_t)coding_get(&in, 1);
	r.count = coding_get(&in, 8);
	r.bytes = p->bytes + at + 9;
	if (r.count > p->count - at - 9)
		r.kind = 0;
	return r;
}

static void differ(player *p, const char *what)
{
	if (p->differs)
		return;
	p->differs = 1;
	p->report_step = p->step;
	(void)snprintf(p->report, sizeof p->report, "step %llu: %s", (unsigned long long)p->step, what);
}

/* ---- checks ---- */

static const char *const field_names[RECORD_BODY_WORDS] = {
	"handle", "position x", "position y", "rotation cosine", "rotation sine", "velocity x", "velocity y", "angular velocity", "awake"
};

static void differ_in_body(player *p, uint32_t body, int32_t field, uint32_t recorded, uint32_t here)
{
	char text[160];
	const char *name = "";
	float a, b;
	memcpy(&a, &recorded, sizeof a);
	memcpy(&b, &here, sizeof b);
	if (cn_body_get_name(p->world, body, &name) != CN_OK || name == NULL)
		name = "";
	if (field == 0 || field == RECORD_BODY_WORDS - 1)
		(void)snprintf(text, sizeof text, "body 0x%08x \"%s\", %s: recorded 0x%x, here 0x%x", (unsigned)body, name, field_names[field], (unsigned)recorded, (unsigned)here);
	else
		(void)snprintf(text, sizeof text, "body 0x%08x \"%s\", %s: recorded %.9g, here %.9g", (unsigned)body, name, field_names[field], (double)a, (double)b);
	differ(p, text);
}

static void compare_check(player *p, const record *r)
{
	coding_out out = { NULL, 0, 0, 0 };
	coding_in recorded, here;
	uint32_t bodies, own, k;
	int32_t field;
	uint64_t hash, own_hash;
	record_put_check(&out, p->world, p->step);
	recorded = coding_begin(r->bytes, r->count);
	here = coding_begin(out.bytes, out.count);
	(void)coding_get(&recorded, 8);
	(void)coding_get(&here, 8);
	hash = coding_get(&recorded, 8);
	own_hash = coding_get(&here, 8);
	bodies = (uint32_t)coding_get(&recorded, 4);
	own = (uint32_t)coding_get(&here, 4);
	for (k = 0; k < bodies && k < own && !p->differs; ++k) {
		uint32_t body = 0;
		for (field = 0; field < RECORD_BODY_WORDS && !p->differs; ++field) {
			uint32_t a = (uint32_t)coding_get(&recorded, 4), b = (uint32_t)coding_get(&here, 4);
			body = field == 0 ? b : body;
			if (a != b)
				differ_in_body(p, body, field, a, b);
		}
	}
	if (bodies != own)
		differ(p, "another number of bodies");
	if (hash != own_hash)
		differ(p, "all bodies are alike, and the impulses of contacts or the memory of joints are not (cn_world_hash)");
	++p->checks;
	coding_free(&out);
}

/* ---- records ---- */

static int32_t read_key(player *p, const record *r)
{
	cn_world *world = NULL;
	coding_in in = coding_begin(r->bytes, r->count);
	uint64_t step = coding_get(&in, 8);
	if (in.failed || cn_world_read(p->def, in.at, r->count - 8, &world) != CN_OK)
		return 0;
	cn_world_destroy(p->world);
	p->world = world;
	p->step = step;
	return 1;
}

static void compare_key(player *p, const record *r)
{
	uint64_t bytes = 0;
	uint8_t *own = NULL;
	if (cn_world_write_size(p->world, &bytes) == CN_OK)
		own = (uint8_t *)malloc((size_t)bytes);
	if (own == NULL || cn_world_write(p->world, own, bytes, NULL) != CN_OK)
		p->broken = 1;
	else if (bytes != r->count - 8 || memcmp(own, r->bytes + 8, (size_t)bytes) != 0)
		differ(p, "the written world has other bytes: a state that no body shows yet");
	free(own);
}

static void read_names(player *p, const record *r)
{
	coding_in in = coding_begin(r->bytes, r->count);
	int32_t count = (int32_t)coding_get(&in, 2), k, n;
	for (k = 0; k < count && k < 256; ++k) {
		char name[256];
		int32_t length = (int32_t)coding_get(&in, 1);
		for (n = 0; n < length; ++n)
			name[n] = (char)coding_get(&in, 1);
		name[length] = '\0';
		p->calls_here[k] = in.failed ? -1 : call_find(name);
	}
}

static int32_t is_step(const call_entry *entry)
{
	return strcmp(entry->name, "cn_world_step") == 0 || strcmp(entry->name, "cn_world_update") == 0;
}

static void compare_result(player *p, const call_entry *entry, cn_result result, const call_value *v)
{
	record r = record_at(p, p->at);
	coding_in in;
	char text[160];
	cn_result recorded;
	if (r.kind != RECORD_RESULT)
		return; /* the recording ends in this call */
	p->at += 9 + r.count;
	in = coding_begin(r.bytes, r.count);
	recorded = (cn_result)(uint32_t)coding_get(&in, 4);
	if (recorded != result)
		(void)snprintf(text, sizeof text, "%s: recorded %s, here %s", entry->name, cn_result_text(recorded), cn_result_text(result));
	else if (result == CN_OK && !coding_results_match(&in, entry, v))
		(void)snprintf(text, sizeof text, "%s gives another handle", entry->name);
	else
		return;
	differ(p, text);
}

/* 1: it was a step. */
static int32_t play_call(player *p, const record *r)
{
	call_value v[CALL_PARAMS_MAX];
	coding_in in = coding_begin(r->bytes, r->count);
	uint32_t named = (uint32_t)coding_get(&in, 2);
	int32_t call = named < 256u ? p->calls_here[named] : -1, stepped = 0;
	cn_result result;
	if (call < 0) {
		differ(p, "a call that this version does not know");
		return 0;
	}
	coding_get_call(&in, &call_entries[call], v);
	if (in.failed) {
		p->broken = 1;
	} else {
		result = call_entries[call].invoke(p->world, v);
		stepped = is_step(&call_entries[call]) && result == CN_OK;
		p->step += (uint64_t)stepped;
		++p->calls;
		compare_result(p, &call_entries[call], result, v);
	}
	coding_in_free(&in);
	return stepped;
}

/* Plays the next record. *stepped: it was a step. 0: the end. */
static int32_t play_record(player *p, int32_t *stepped)
{
	record r = record_at(p, p->at);
	*stepped = 0;
	if (r.kind == 0 || p->broken)
		return 0;
	p->at += 9 + r.count;
	switch (r.kind) {
	case RECORD_CALL: *stepped = play_call(p, &r); break;
	case RECORD_CHECK: compare_check(p, &r); break;
	case RECORD_KEY: compare_key(p, &r); break;
	case RECORD_JUMP: /* the state that follows came from a save */
		r = record_at(p, p->at);
		if (r.kind != RECORD_KEY || !read_key(p, &r))
			p->broken = 1;
		p->at += 9 + r.count;
		break;
	default: break; /* of a later version */
	}
	return !p->broken;
}

/* What belongs to a step comes after it: checks and written worlds. */
static void play_rest_of_step(player *p)
{
	record r = record_at(p, p->at);
	int32_t stepped;
	while ((r.kind == RECORD_CHECK || r.kind == RECORD_KEY) && play_record(p, &stepped))
		r = record_at(p, p->at);
}

int32_t player_step(player *p)
{
	int32_t stepped = 0;
	while (!stepped && play_record(p, &stepped))
		;
	if (stepped)
		play_rest_of_step(p);
	return stepped;
}

/* ---- opening, seeking ---- */

/* Where the last written world at or before a step is; also counts all steps. 0: there is none. */
static uint64_t key_before(player *p, uint64_t step)
{
	uint64_t at = 8, found = 0, steps = 0;
	record r = record_at(p, at);
	for (; r.kind != 0; at += 9 + r.count, r = record_at(p, at)) {
		coding_in in = coding_begin(r.bytes, r.count);
		if (r.kind == RECORD_NAMES)
			read_names(p, &r);
		if (r.kind == RECORD_KEY && coding_get(&in, 8) <= step)
			found = at;
		if (r.kind == RECORD_CALL) {
			uint32_t call = (uint32_t)coding_get(&in, 2);
			record result = record_at(p, at + 9 + r.count);
			coding_in code = coding_begin(result.bytes, result.kind == RECORD_RESULT ? result.count : 0);
			if (call < 256u && p->calls_here[call] >= 0 && is_step(&call_entries[p->calls_here[call]]) && coding_get(&code, 4) == 0 && !code.failed)
				++steps;
		}
	}
	p->step_count = steps;
	return found;
}

int32_t player_seek(player *p, uint64_t step)
{
	if (step > p->step_count)
		return 0;
	if (step < p->step || p->world == NULL) {
		uint64_t at = key_before(p, step);
		record r = record_at(p, at);
		if (at == 0 || !read_key(p, &r))
			return 0;
		p->at = at + 9 + r.count;
		play_rest_of_step(p);
	}
	while (p->step < step)
		if (!player_step(p))
			return 0;
	return 1;
}

int32_t player_open(player *p, const cn_world_def *def, const void *bytes, uint64_t count)
{
	int32_t k;
	memset(p, 0, sizeof *p);
	p->bytes = (const uint8_t *)bytes;
	p->count = count;
	p->def = def;
	for (k = 0; k < 256; ++k)
		p->calls_here[k] = -1;
	if (count < 8 || memcmp(bytes, "CairnRec", 8) != 0 || key_before(p, 0) == 0)
		return 0;
	return player_seek(p, 0);
}

void player_close(player *p)
{
	cn_world_destroy(p->world);
	p->world = NULL;
}
