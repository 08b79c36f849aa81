/*
 * test/fuzz/fuzz_calls.c - any sequence of all calls that change a world, with good and bad arguments, drawn by the table of calls
 * (bindings/record/calls.h, written from the public header). Properties: a failed call changes no hash; the world stays valid; a
 * restored save, a world read from its file, and a twin with the other broadphase and two workers go on with the same hash.
 */
#include "fuzz.h"

#define CALLS_MAX 120
#define BODIES_MAX 48
#define POINTS_MAX 12

typedef struct pool {
	uint32_t handles[64];
	int32_t count;
} pool;

typedef struct arguments {
	call_value v[CALL_PARAMS_MAX];
	union { uint64_t align; uint8_t bytes[4096]; } memory[CALL_PARAMS_MAX];
	cn_vec2 points[POINTS_MAX];
	char text[80];
} arguments;

typedef struct session {
	fuzz_source source;
	cn_world *world, *twin; /* twin may be NULL */
	pool pools[4];          /* bodies, shapes, joints, constraints: also stale ones */
} session;

/* ---- values ---- */

static float any_float(fuzz_source *s)
{
	static const uint32_t special[] = { 0, 0x80000000u, 0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x7F7FFFFFu, 1, 0x49742400u, 0xC9742400u, 0x3F800000u };
	uint32_t kind = fuzz_byte(s), word;
	float x;
	if (kind >= 24)
		return fuzz_unit(s) * (kind < 160 ? 1.0f : kind < 240 ? 10.0f : 1000.0f);
	word = kind < 20 ? special[kind % 10u] : fuzz_word(s);
	memcpy(&x, &word, sizeof x);
	return x;
}

static int32_t any_int(fuzz_source *s)
{
	uint32_t kind = fuzz_byte(s);
	return kind < 240 ? (int32_t)(kind % 6u) : kind < 250 ? -1 : (int32_t)fuzz_word(s);
}

static uint32_t any_handle(session *s, int32_t kind)
{
	const pool *p = &s->pools[kind];
	uint32_t choice = fuzz_byte(&s->source);
	if (choice >= 250)
		return fuzz_word(&s->source);
	if (choice >= 244 || p->count == 0)
		return 0;
	return p->handles[choice % (uint32_t)p->count];
}

static void keep_handle(session *s, int32_t kind, uint32_t handle)
{
	pool *p = &s->pools[kind];
	p->handles[p->count < 64 ? p->count++ : (int32_t)(handle % 64u)] = handle;
}

static uint32_t any_value(session *s, int32_t kind)
{
	float x;
	uint32_t word;
	switch (kind) {
	case CALL_FLOAT:
		x = any_float(&s->source);
		memcpy(&word, &x, sizeof word);
		return word;
	case CALL_INT: return (uint32_t)any_int(&s->source);
	case CALL_BODY:
	case CALL_SHAPE:
	case CALL_JOINT:
	case CALL_CONSTRAINT: return any_handle(s, kind - CALL_BODY);
	default: return fuzz_byte(&s->source) < 240 ? fuzz_byte(&s->source) & 31u : fuzz_word(&s->source);
	}
}

static const char *any_text(session *s, arguments *a)
{
	uint32_t length = fuzz_byte(&s->source) % 72u;
	if (length == 71)
		return NULL;
	memset(a->text, 'a', sizeof a->text);
	a->text[length] = '\0';
	return a->text;
}

/* ---- structs ---- */

static void any_points(session *s, arguments *a, uint8_t *field)
{
	const cn_vec2 *points = a->points;
	int32_t count = (int32_t)(fuzz_byte(&s->source) % (POINTS_MAX + 2u)) - 1, k;
	for (k = 0; k < POINTS_MAX; ++k) {
		a->points[k].x = 5.0f - (float)k + 0.3f * fuzz_unit(&s->source);
		a->points[k].y = fuzz_unit(&s->source);
	}
	memcpy(field, &points, sizeof points);
	memcpy(field + sizeof points, &count, sizeof count);
}

static void any_field(session *s, arguments *a, const call_struct *type, const call_field *field, uint8_t *item)
{
	const char *text;
	uint32_t word;
	int32_t k;
	for (k = 0; k < field->count; ++k) {
		uint8_t *at = item + field->offset + (field->kind == CALL_LONG ? 8u : 4u) * (size_t)k;
		if (field->kind == CALL_TEXT) {
			text = any_text(s, a);
			memcpy(at, &text, sizeof text);
		} else if (field->kind == CALL_POINTS) {
			any_points(s, a, at);
		} else {
			word = field->kind == CALL_SIZE ? (fuzz_byte(&s->source) < 250 ? type->bytes : fuzz_word(&s->source)) : any_value(s, field->kind);
			memcpy(at, &word, sizeof word);
		}
	}
}

static int32_t is_handle(int32_t kind) { return kind >= CALL_BODY && kind <= CALL_CONSTRAINT; }

/* Defaults with good handles, and a few fields changed; without defaults, all fields. */
static void any_struct(session *s, arguments *a, const call_struct *type, uint8_t *item)
{
	int32_t k, changes;
	memset(item, 0, type->bytes);
	if (strcmp(type->name, "cn_polygon") == 0 && fuzz_byte(&s->source) < 220) {
		float half_width = fuzz_range(&s->source, 0.1f, 1.0f);
		(void)cn_polygon_make_box(half_width, fuzz_range(&s->source, 0.1f, 1.0f), 0.0f, 0.0f, fuzz_unit(&s->source), 0.0f, (cn_polygon *)(void *)item);
		return;
	}
	if (type->init != NULL)
		type->init(item);
	for (k = 0; k < type->field_count; ++k) {
		const call_field *field = &type->fields[k];
		if (k > 0 && type->fields[k - 1].kind == CALL_POINTS)
			continue; /* their count: there are no more points than that */
		if (type->init == NULL || is_handle(field->kind) || field->kind == CALL_POINTS || strstr(field->name, "position_m") != NULL)
			any_field(s, a, type, field, item);
	}
	for (changes = (int32_t)(fuzz_byte(&s->source) % 4u); changes > 0 && type->init != NULL; --changes) {
		const call_field *field = &type->fields[fuzz_byte(&s->source) % (uint32_t)type->field_count];
		if (field->kind != CALL_POINTS)
			any_field(s, a, type, field, item);
	}
}

/* ---- calls ---- */

/* How many things behind a pointer fit. */
static int32_t things_max(const call_param *p)
{
	return p->structs >= 0 ? (int32_t)(sizeof(((arguments *)0)->memory[0]) / call_structs[p->structs].bytes) : 64;
}

static void any_arguments(session *s, const call_entry *entry, arguments *a)
{
	int32_t k, n;
	memset(a->v, 0, sizeof a->v);
	for (k = 0; k < entry->param_count; ++k) {
		const call_param *p = &entry->params[k];
		if (p->kind < CALL_SIZE)
			a->v[k].w = any_value(s, p->kind);
		if (p->kind == CALL_LONG)
			a->v[k].l = fuzz_word(&s->source);
		if (p->kind == CALL_INT && a->v[k].i > 6)
			a->v[k].i &= strcmp(p->name, "count") == 0 ? 7 : -1; /* no more than there is behind pointers */
	}
	for (k = 0; k < entry->param_count; ++k) {
		const call_param *p = &entry->params[k];
		uint8_t *memory = a->memory[k].bytes;
		int32_t things = call_things(entry, k, a->v);
		if (p->kind < CALL_SIZE)
			continue;
		if (fuzz_byte(&s->source) >= 253)
			continue; /* NULL */
		things = things < things_max(p) ? things : things_max(p);
		if (p->kind == CALL_TEXT)
			a->v[k].in = any_text(s, a);
		else if (p->structs >= 0)
			for (n = 0; n < things; ++n)
				any_struct(s, a, &call_structs[p->structs], memory + (size_t)n * call_structs[p->structs].bytes);
		else
			for (n = 0; n < things; ++n)
				((uint32_t *)(void *)memory)[n] = p->kind == CALL_IN || p->kind == CALL_INS ? any_handle(s, p->of - CALL_BODY) : 0u;
		if (p->kind != CALL_TEXT)
			a->v[k].out = memory;
	}
}

/* Bounds what one input costs. */
static void limit_cost(session *s, const call_entry *entry, arguments *a)
{
	int32_t bodies = 0;
	(void)cn_world_get_bodies(s->world, NULL, 0, &bodies);
	if (strcmp(entry->name, "cn_world_update") == 0 && a->v[0].f > 0.05f)
		a->v[0].f = 0.05f;
	if (strcmp(entry->name, "cn_world_set_fixed_step") == 0 && a->v[0].f < 0.004f)
		a->v[0].f = 0.004f;
	if (strcmp(entry->name, "cn_body_create_many") == 0 && bodies > BODIES_MAX)
		a->v[1].i = 0;
}

static uint64_t hash_of(const cn_world *world)
{
	uint64_t hash = 0;
	FUZZ_REQUIRE(cn_world_hash(world, &hash) == CN_OK);
	return hash;
}

static void require_valid(const cn_world *world)
{
	char text[160] = "";
	cn_result valid = cn_world_validate(world, text, (int32_t)sizeof text);
	if (valid != CN_OK)
		printf("%s\n", text);
	FUZZ_REQUIRE(valid == CN_OK);
}

static void keep_results(session *s, const call_entry *entry, const arguments *a, const uint32_t *twins)
{
	int32_t k, n;
	for (k = 0; k < entry->param_count; ++k) {
		const call_param *p = &entry->params[k];
		if ((p->kind != CALL_OUT && p->kind != CALL_OUTS) || a->v[k].out == NULL)
			continue;
		for (n = 0; n < call_things(entry, k, a->v) && n < 64; ++n) {
			uint32_t handle = ((const uint32_t *)a->v[k].in)[n];
			FUZZ_REQUIRE(s->twin == NULL || twins[n] == handle);
			keep_handle(s, p->of - CALL_BODY, handle);
		}
	}
}

/* The twin gets the same arguments; its results go elsewhere. */
static void twin_call(session *s, const call_entry *entry, const arguments *a, cn_result result, uint32_t *twins)
{
	static union { uint64_t align; uint8_t bytes[4096]; } memory;
	call_value v[CALL_PARAMS_MAX];
	int32_t k;
	memcpy(v, a->v, sizeof v);
	for (k = 0; k < entry->param_count; ++k)
		if (v[k].out != NULL && entry->params[k].kind >= CALL_OUT)
			v[k].out = entry->params[k].kind == CALL_RESULT || entry->params[k].kind == CALL_INOUT ? (void *)memory.bytes : (void *)twins;
	for (k = 0; k < entry->param_count; ++k)
		if (entry->params[k].kind == CALL_INOUT)
			return; /* the caller's state has moved on already */
	FUZZ_REQUIRE(entry->invoke(s->twin, v) == result);
}

static int32_t has_inout(const call_entry *entry)
{
	int32_t k;
	for (k = 0; k < entry->param_count; ++k)
		if (entry->params[k].kind == CALL_INOUT)
			return 1;
	return 0;
}

/* For the analysis of a failure: FUZZ_PRINT=1. */
static void print_call(const call_entry *entry, const arguments *a, cn_result result)
{
	int32_t k;
	printf("%s(", entry->name);
	for (k = 0; k < entry->param_count; ++k)
		if (entry->params[k].kind == CALL_FLOAT)
			printf(" %g", (double)a->v[k].f);
		else if (entry->params[k].kind < CALL_SIZE)
			printf(" 0x%x", (unsigned)a->v[k].w);
	printf(") = %s\n", cn_result_text(result));
}

static void any_call(session *s)
{
	static arguments a;
	uint32_t twins[64];
	uint32_t choice = fuzz_byte(&s->source);
	/* Steps and the creation of bodies and shapes often, else nothing happens. */
	static const char *const often[] = { "cn_world_step", "cn_body_create", "cn_shape_create_box", "cn_shape_create_circle", "cn_world_step", "cn_shape_create_polygon", "cn_world_step", "cn_shape_create_chain" };
	int32_t call = choice >= 160 ? call_find(often[choice % 8u]) : (int32_t)(choice % (uint32_t)call_count);
	const call_entry *entry = &call_entries[call];
	uint64_t before = hash_of(s->world);
	cn_result result;
	if (s->twin != NULL && has_inout(entry))
		return;
	any_arguments(s, entry, &a);
	limit_cost(s, entry, &a);
	if (choice >= 160 && strcmp(entry->name, "cn_world_step") == 0)
		a.v[0].f = 1.0f / 60.0f;
	memset(twins, 0, sizeof twins);
	result = entry->invoke(s->world, a.v);
	if (getenv("FUZZ_PRINT") != NULL)
		print_call(entry, &a, result);
	if (s->twin != NULL)
		twin_call(s, entry, &a, result, twins);
	if (result == CN_OK)
		keep_results(s, entry, &a, twins);
	else
		FUZZ_REQUIRE(hash_of(s->world) == before && result != CN_ERROR_INTERNAL && result != CN_ERROR_LOCKED);
	if (fuzz_byte(&s->source) >= 224)
		require_valid(s->world);
}

/* ---- what must hold at the end ---- */

static uint64_t later_hash(cn_world *world)
{
	int32_t k;
	for (k = 0; k < 3; ++k)
		(void)cn_world_step(world, 1.0f / 60.0f);
	return hash_of(world);
}

static void check_saves(cn_world *world)
{
	uint64_t save_bytes = 0, file_bytes = 0, straight;
	void *save, *file;
	cn_world *read = NULL;
	FUZZ_REQUIRE(cn_world_save_size(world, &save_bytes) == CN_OK && cn_world_write_size(world, &file_bytes) == CN_OK);
	save = malloc((size_t)save_bytes);
	file = malloc((size_t)file_bytes);
	FUZZ_REQUIRE(save != NULL && file != NULL);
	FUZZ_REQUIRE(cn_world_save(world, save, save_bytes, NULL) == CN_OK && cn_world_write(world, file, file_bytes, NULL) == CN_OK);
	FUZZ_REQUIRE(cn_world_read(NULL, file, file_bytes, &read) == CN_OK);
	straight = later_hash(world);
	FUZZ_REQUIRE(later_hash(read) == straight);
	FUZZ_REQUIRE(cn_world_restore(world, save, save_bytes) == CN_OK);
	FUZZ_REQUIRE(later_hash(world) == straight);
	cn_world_destroy(read);
	free(save);
	free(file);
}

static cn_world *world_of(uint32_t choice, int32_t twin)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.solver = (int32_t)(choice & 3u);
	def.broadphase = (int32_t)(choice >> 2 & 1u) ^ twin;
	def.worker_count = twin && (choice & 16u) ? 2 : 1;
	FUZZ_REQUIRE(cn_world_create(&def, &world) == CN_OK);
	return world;
}

void fuzz_calls(const uint8_t *bytes, size_t count)
{
	static session s;
	uint32_t choice;
	int32_t k;
	memset(&s, 0, sizeof s);
	s.source = fuzz_begin(bytes, count);
	choice = fuzz_byte(&s.source);
	s.world = world_of(choice, 0);
	if (choice & 8u)
		s.twin = world_of(choice, 1);
	for (k = 0; k < CALLS_MAX && fuzz_left(&s.source); ++k)
		any_call(&s);
	require_valid(s.world);
	if (s.twin != NULL) {
		require_valid(s.twin);
		FUZZ_REQUIRE(hash_of(s.world) == hash_of(s.twin));
	}
	check_saves(s.world);
	cn_world_destroy(s.world);
	cn_world_destroy(s.twin);
}
