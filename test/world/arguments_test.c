/*
 * arguments_test - promise: every public function refuses every bad argument with the right code and a
 * sentence that names it, and a call that fails changes nothing.
 *
 * The list of functions is read from include/cairn.h at run time, so a new function without an entry here
 * fails the test. Each entry has a good call and a list of bad ones. The good calls are used to show
 * that the entry's other arguments are fine, that inside a callback everything is refused, and that a
 * call which runs out of memory changes nothing either.
 */
#include "world/error.h"
#include "test.h"

#include <stdlib.h>

#ifndef CAIRN_HEADER
#define CAIRN_HEADER "include/cairn.h"
#endif

/* ------------------------------------------------------------------ allocator that can fail */

static int alloc_allow = -1;         /* allocations until the next failure; -1: never fail */
static uint32_t alloc_fail_mask;     /* random failures: fail when (random & mask) == 0; 0: off */
static uint32_t alloc_random = 1u;
static int64_t alloc_live;

static uint32_t random_next(uint32_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 17;
	*state ^= *state << 5;
	return *state;
}

static void *test_alloc(uint64_t bytes, uint32_t align, void *user)
{
	unsigned char *raw, *out;
	(void)user;
	if (alloc_allow == 0 || (alloc_fail_mask != 0 && (random_next(&alloc_random) & alloc_fail_mask) == 0))
		return NULL;
	if (alloc_allow > 0)
		--alloc_allow;
	raw = malloc((size_t)bytes + align + sizeof(void *));
	out = (unsigned char *)(((uintptr_t)raw + sizeof(void *) + align - 1) & ~(uintptr_t)(align - 1));
	memcpy(out - sizeof(void *), &raw, sizeof raw);
	alloc_live += (int64_t)bytes;
	return out;
}

static void test_free(void *memory, uint64_t bytes, void *user)
{
	void *raw;
	(void)user;
	memcpy(&raw, (unsigned char *)memory - sizeof(void *), sizeof raw);
	alloc_live -= (int64_t)bytes;
	free(raw);
}

/* ------------------------------------------------------------------ the world under test */

#define BAD_HANDLES 16

static struct {
	cn_world *w;
	cn_body ground, box, ball, pill, rail;
	cn_shape ground_shape, chain, edge, box_shape, ball_shape, pill_shape, loose;
	cn_joint pin, rope;
	cn_body bad_bodies[BAD_HANDLES];
	cn_shape bad_shapes[BAD_HANDLES];
	cn_joint bad_joints[BAD_HANDLES];
	int bad_body_count, bad_shape_count, bad_joint_count;
} f;

#define W (f.w)

static cn_world_def wd;
static cn_body_def bd;
static cn_shape_def sd;
static cn_revolute_def rd;
static cn_distance_def dd;
static cn_circle circle;
static cn_capsule capsule;
static cn_edge edge;
static cn_polygon polygon;
static cn_chain chain;
static cn_vec2 chain_points[4];
static cn_material material;
static cn_mass_data mass;
static cn_filter filter;

static cn_vec2 v2(float x, float y)
{
	cn_vec2 v;
	v.x = x;
	v.y = y;
	return v;
}

/* Good values of every struct, before a test spoils one field. */
static int reset(void)
{
	cn_world_def_init(&wd);
	cn_body_def_init(&bd);
	bd.position_m = v2(3.0f, 5.0f);
	bd.name = "a body with a name";
	cn_shape_def_init(&sd);
	sd.body = f.ball;
	cn_revolute_def_init(&rd);
	rd.base.body_a = f.box;
	rd.base.body_b = f.pill;
	cn_distance_def_init(&dd);
	dd.base.body_b = f.box;
	circle.center_m = v2(0.1f, 0.0f);
	circle.radius_m = 0.25f;
	capsule.a_m = edge.a_m = v2(-0.5f, 0.0f);
	capsule.b_m = edge.b_m = v2(0.5f, 0.0f);
	capsule.radius_m = 0.2f;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = 4;
	polygon.points_m[0] = v2(-0.5f, -0.5f);
	polygon.points_m[1] = v2(0.5f, -0.5f);
	polygon.points_m[2] = v2(0.5f, 0.5f);
	polygon.points_m[3] = v2(-0.5f, 0.5f);
	chain_points[0] = v2(4.0f, 0.0f);
	chain_points[1] = v2(2.0f, 0.2f);
	chain_points[2] = v2(-2.0f, 0.0f);
	chain_points[3] = v2(-4.0f, 0.5f);
	chain.points_m = chain_points;
	chain.count = 4;
	chain.loop = 0;
	material.static_friction = 0.5f;
	material.dynamic_friction = 0.4f;
	material.restitution = 0.1f;
	material.reserved = 0.0f;
	mass.mass_kg = 2.0f;
	mass.inertia_kgm2 = 0.5f;
	mass.center_m = v2(0.0f, 0.1f);
	memset(&filter, 0, sizeof filter);
	filter.category = 2;
	filter.mask = 1;
	return 0;
}

/* A good struct with one field spoiled. */
#define WD(field, value) (reset(), wd.field = (value), &wd)
#define BD(field, value) (reset(), bd.field = (value), &bd)
#define SD(field, value) (reset(), sd.field = (value), &sd)
#define RD(field, value) (reset(), rd.field = (value), &rd)
#define DD(field, value) (reset(), dd.field = (value), &dd)
#define CI(field, value) (reset(), circle.field = (value), &circle)
#define CA(field, value) (reset(), capsule.field = (value), &capsule)
#define ED(field, value) (reset(), edge.field = (value), &edge)
#define PO(field, value) (reset(), polygon.field = (value), &polygon)
#define CH(field, value) (reset(), chain.field = (value), &chain)
#define CP(point, value) (reset(), chain_points[point] = (value), &chain)
#define MA(field, value) (reset(), material.field = (value), &material)
#define BASE(def, a, b) (reset(), def.base.body_a = (a), def.base.body_b = (b), &def)
#define MD(field, value) (reset(), mass.field = (value), &mass)

static cn_body make_body(int32_t type, float x, float y)
{
	cn_body body = 0;
	reset();
	bd.type = type;
	bd.position_m = v2(x, y);
	CHECK(cn_body_create(W, &bd, &body) == CN_OK);
	return body;
}

static cn_shape make_ball(cn_body body)
{
	cn_shape shape = 0;
	reset();
	sd.body = body;
	CHECK(cn_shape_create_circle(W, &sd, &circle, &shape) == CN_OK);
	return shape;
}

static int bad_handles(uint32_t *out, uint32_t stale, uint32_t other_a, uint32_t other_b, int32_t (*is_valid)(const cn_world *, uint32_t))
{
	uint32_t state = 12345u;
	int count = 0;
	out[count++] = 0;
	out[count++] = stale;
	out[count++] = other_a;
	out[count++] = other_b;
	out[count++] = 0xFFFFFFFFu;
	while (count < BAD_HANDLES) {
		uint32_t bits = random_next(&state);
		if (count & 1)
			bits &= 0xFFF0000Fu; /* small indices with any generation and kind */
		if (!is_valid(W, bits))
			out[count++] = bits;
	}
	return count;
}

/* Ground with a chain and an edge, a box at rest on it, a ball and a capsule held by joints. */
static void fixture_make(int with_hooks)
{
	cn_body stale_body;
	cn_shape stale_shape;
	cn_joint stale_joint = 0;
	int k;
	memset(&f, 0, sizeof f);
	reset();
	if (with_hooks) {
		wd.alloc = test_alloc;
		wd.free = test_free;
	}
	CHECK(cn_world_create(&wd, &f.w) == CN_OK);
	f.ground = make_body(CN_BODY_STATIC, 0.0f, -1.0f);
	f.box = make_body(CN_BODY_DYNAMIC, 0.0f, 0.5f);
	f.ball = make_body(CN_BODY_DYNAMIC, 3.0f, 2.0f);
	f.pill = make_body(CN_BODY_DYNAMIC, 4.0f, 2.0f);
	f.rail = make_body(CN_BODY_KINEMATIC, -6.0f, 3.0f);
	sd.body = f.ground;
	CHECK(cn_shape_create_box(W, &sd, 20.0f, 1.0f, 0.0f, &f.ground_shape) == CN_OK);
	CHECK(cn_shape_create_chain(W, &sd, &chain, &f.chain) == CN_OK);
	CHECK(cn_shape_create_edge(W, &sd, &edge, &f.edge) == CN_OK);
	sd.body = f.box;
	sd.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	CHECK(cn_shape_create_polygon(W, &sd, &polygon, &f.box_shape) == CN_OK);
	f.ball_shape = make_ball(f.ball);
	sd.body = f.pill;
	CHECK(cn_shape_create_capsule(W, &sd, &capsule, &f.pill_shape) == CN_OK);
	f.loose = make_ball(0);
	reset();
	rd.base.body_a = f.ball;
	rd.base.anchor_a_m = v2(1.0f, 0.0f);
	CHECK(cn_joint_create_revolute(W, &rd, &f.pin) == CN_OK);
	dd.base.body_b = f.ball;
	dd.base.anchor_a_m = v2(3.0f, 4.0f);
	dd.length_m = 2.0f;
	CHECK(cn_joint_create_distance(W, &dd, &f.rope) == CN_OK);
	stale_body = make_body(CN_BODY_DYNAMIC, 9.0f, 9.0f);
	stale_shape = make_ball(stale_body);
	reset();
	rd.base.body_a = stale_body;
	CHECK(cn_joint_create_revolute(W, &rd, &stale_joint) == CN_OK);
	CHECK(cn_body_destroy(W, stale_body) == CN_OK);
	f.bad_body_count = bad_handles(f.bad_bodies, stale_body, f.box_shape, f.pin, cn_body_is_valid);
	f.bad_shape_count = bad_handles(f.bad_shapes, stale_shape, f.box, f.pin, cn_shape_is_valid);
	f.bad_joint_count = bad_handles(f.bad_joints, stale_joint, f.box, f.box_shape, cn_joint_is_valid);
	for (k = 0; k < 12; ++k)
		CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	reset();
}

static void fixture_free(void)
{
	cn_world_destroy(f.w);
	f.w = NULL;
}

/* ------------------------------------------------------------------ what a failed call may not change */

typedef struct state {
	uint64_t hash;
	uint64_t records;
	cn_counters counters;
} state;

static uint64_t fnv(uint64_t hash, const void *data, size_t bytes)
{
	const unsigned char *p = data;
	size_t k;
	for (k = 0; k < bytes; ++k)
		hash = (hash ^ p[k]) * 1099511628211u;
	return hash;
}

static uint64_t fnv_table(uint64_t hash, const cni_handles *handles, const cni_table *table)
{
	int32_t k;
	hash = fnv(hash, handles->slots.data, (size_t)handles->slots.count * sizeof(uint32_t));
	for (k = 0; k < cni_handles_used(handles); ++k)
		if (cni_handles_alive(handles, k))
			hash = fnv(hash, cni_table_at(table, k), (size_t)table->item_bytes);
	return hash;
}

/* Everything that lasts but for capacities, addresses and the error sentence. */
static state state_of(const cn_world *world)
{
	state s;
	uint64_t h = 14695981039346656037u;
	int32_t k;
	memset(&s, 0, sizeof s);
	CHECK(cn_world_hash(world, &s.hash) == CN_OK);
	CHECK(cn_world_get_counters(world, &s.counters) == CN_OK);
	h = fnv(h, &world->settings, sizeof world->settings);
	h = fnv(h, &world->user_data, sizeof world->user_data);
	h = fnv(h, world->events.callback, sizeof world->events.callback);
	h = fnv(h, world->events.callback_user, sizeof world->events.callback_user);
	for (k = 0; k < CN_EVENT_KINDS; ++k)
		h = fnv(h, &world->events.pending[k].count, sizeof(int32_t));
	h = fnv_table(h, &world->body_handles, &world->bodies);
	h = fnv_table(h, &world->shape_handles, &world->shapes);
	h = fnv_table(h, &world->joint_handles, &world->joints);
	h = fnv(h, world->motion.data, (size_t)world->motion.count * sizeof(cni_motion));
	h = fnv(h, world->awake_contacts.data, (size_t)world->awake_contacts.count * sizeof(int32_t));
	s.records = h;
	return s;
}

static void check_valid(const char *after)
{
	char text[192] = "";
	if (cn_world_validate(W, text, (int32_t)sizeof text) != CN_OK) {
		printf("  after %s: %s\n", after, text);
		test_fail(__FILE__, __LINE__, "world is not valid");
	}
}

/* ------------------------------------------------------------------ bad calls */

static const char *current;          /* function under test */
static int current_has_sentence;     /* it takes a non-const world */
static int bad_calls;
static state before;
static unsigned char out_bytes[8192];
#define OUT(T) ((T *)(void *)out_bytes)
#define INT OUT(int32_t)

static void bad_begin(void)
{
	/* Leave another function's sentence, so that a missing one is seen. */
	if (strcmp(current, "cn_world_set_substep_count") == 0)
		cn_world_set_flags(W, 0xFFFFFFFFu);
	else
		cn_world_set_substep_count(W, -1);
	memset(out_bytes, 0xA5, sizeof out_bytes);
	before = state_of(W);
}

static void bad_sentence(const char *what)
{
	const char *text = cn_world_error_text(W);
	size_t length = strlen(current);
	if (!current_has_sentence)
		return;
	if (strncmp(text, current, length) != 0 || text[length] != ':' || strlen(text) < length + 6) {
		printf("  %s gives the sentence \"%s\"\n", what, text);
		test_fail(__FILE__, __LINE__, "sentence must name the function and say what was wrong");
	}
}

static void bad_end(int line, const char *what, cn_result expected, cn_result result, int has_world)
{
	state after = state_of(W);
	size_t k;
	++bad_calls;
	if (result != expected) {
		printf("  %s gives %d (%s), not %d\n", what, (int)result, cn_world_error_text(W), (int)expected);
		test_fail(__FILE__, line, current);
	}
	if (memcmp(&before, &after, sizeof before) != 0) {
		printf("  after %s\n", what);
		test_fail(__FILE__, line, "a failed call changed the world");
	}
	for (k = 0; k < sizeof out_bytes; ++k)
		if (out_bytes[k] != 0xA5) {
			printf("  after %s\n", what);
			test_fail(__FILE__, line, "a failed call wrote its output");
			break;
		}
	if (has_world)
		bad_sentence(what);
	check_valid(what);
}

/* The call must give this code; NOW is for calls with a NULL world or none. */
#define BAD(code, call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, code, r_, 1); } while (0)
#define NOW(call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, CN_ERROR_ARGUMENT, r_, 0); } while (0)
#define ARG(call) BAD(CN_ERROR_ARGUMENT, call)
#define STATE(call) BAD(CN_ERROR_STATE, call)

static float number(int k)
{
	static const uint32_t bits[] = { 0x7FC00000u, 0x7F800000u, 0xFF800000u, 0xFFC12345u };
	float x;
	memcpy(&x, &bits[k & 3], sizeof x);
	return x;
}

/* x runs over what is not finite, and then over the out-of-range values given. */
#define FLOAT(x, call) do { int k_; for (k_ = 0; k_ < 4; ++k_) { float x = number(k_); ARG(call); } } while (0)
#define NOT_NEGATIVE(x, call) do { FLOAT(x, call); { float x = -1.0f; ARG(call); } { float x = -1e-30f; ARG(call); } } while (0)
#define POSITIVE(x, call) do { NOT_NEGATIVE(x, call); { float x = 0.0f; ARG(call); } { float x = -0.0f; ARG(call); } } while (0)
#define RANGE(x, below, above, call) do { FLOAT(x, call); { float x = (below); ARG(call); } { float x = (above); ARG(call); } } while (0)
#define ANGLE(x, call) RANGE(x, -10001.0f, 10001.0f, call)
#define INTEGER(x, below, above, call) do { { int32_t x = (below); ARG(call); } { int32_t x = (above); ARG(call); } \
	{ int32_t x = INT32_MIN; ARG(call); } { int32_t x = INT32_MAX; ARG(call); } } while (0)
#define FLAGS(x, first_unknown, call) do { int k_; for (k_ = (first_unknown); k_ < 32; ++k_) { uint32_t x = 1u << k_; ARG(call); } } while (0)
#define VECTOR(v, call) do { int k_; for (k_ = 0; k_ < 8; ++k_) { cn_vec2 v = k_ & 1 ? v2(0.0f, number(k_ >> 1)) : v2(number(k_ >> 1), 0.0f); ARG(call); } } while (0)
#define POSITION(v, call) do { VECTOR(v, call); { cn_vec2 v = v2(1.01e6f, 0.0f); ARG(call); } { cn_vec2 v = v2(0.0f, -1.01e6f); ARG(call); } } while (0)
#define SIZES(x, call) do { { uint32_t x = 0; ARG(call); } { uint32_t x = 1; ARG(call); } { uint32_t x = 0xFFFFFFFFu; ARG(call); } } while (0)
#define HANDLE(h, list, count, call) do { int k_; for (k_ = 0; k_ < count; ++k_) { uint32_t h = list[k_]; BAD(CN_ERROR_HANDLE, call); } } while (0)
#define BODY(h, call) HANDLE(h, f.bad_bodies, f.bad_body_count, call)
#define SHAPE(h, call) HANDLE(h, f.bad_shapes, f.bad_shape_count, call)
#define JOINT(h, call) HANDLE(h, f.bad_joints, f.bad_joint_count, call)
/* Bad handles without 0, where 0 has a meaning. */
#define BODY_BUT_ZERO(h, call) HANDLE(h, (f.bad_bodies + 1), (f.bad_body_count - 1), call)

/* name, its good call, its bad calls */
#define ENTRY(name, good, ...) \
	static cn_result good_##name(void) { return good; } \
	static void bad_##name(void) { __VA_ARGS__ }

/* (const world, handle, out) */
#define GETTER(name, KIND, handle, T) ENTRY(name, name(W, handle, OUT(T)), \
	NOW(name(NULL, handle, OUT(T))); KIND(h, name(W, h, OUT(T))); ARG(name(W, handle, NULL));)
#define GETTER2(name, KIND, handle, T, U) ENTRY(name, name(W, handle, OUT(T), OUT(U) + 16), \
	NOW(name(NULL, handle, OUT(T), OUT(U) + 16)); KIND(h, name(W, h, OUT(T), OUT(U) + 16)); \
	ARG(name(W, handle, NULL, OUT(U))); ARG(name(W, handle, OUT(T), NULL));)
/* (const world, out) */
#define WORLD_GETTER(name, T) ENTRY(name, name(W, OUT(T)), NOW(name(NULL, OUT(T))); ARG(name(W, NULL));)
/* (const world, out, capacity, out_count) */
#define WORLD_LIST(name, T) ENTRY(name, name(W, OUT(T) + 4, 8, INT), \
	NOW(name(NULL, OUT(T) + 4, 8, INT)); ARG(name(W, NULL, 1, INT)); ARG(name(W, OUT(T) + 4, -1, INT)); ARG(name(W, OUT(T) + 4, 8, NULL));)
/* (const world, handle, out, capacity, out_count) */
#define HANDLE_LIST(name, KIND, handle, T) ENTRY(name, name(W, handle, OUT(T) + 4, 8, INT), \
	NOW(name(NULL, handle, OUT(T) + 4, 8, INT)); KIND(h, name(W, h, OUT(T) + 4, 8, INT)); \
	ARG(name(W, handle, NULL, 1, INT)); ARG(name(W, handle, OUT(T) + 4, -1, INT)); ARG(name(W, handle, OUT(T) + 4, 8, NULL));)

/* ---- library and world */

ENTRY(cn_version, cn_version() > 0 ? CN_OK : -1, CHECK(cn_version() == CN_VERSION_MAJOR * 1000000 + CN_VERSION_MINOR * 1000 + CN_VERSION_PATCH);)
ENTRY(cn_abi_version, cn_abi_version() == CN_ABI_VERSION ? CN_OK : -1, (void)0;)
ENTRY(cn_result_text, cn_result_text(CN_OK) != NULL ? CN_OK : -1,
	CHECK(strlen(cn_result_text(CN_ERROR_HANDLE)) > 0); CHECK(strlen(cn_result_text(7)) > 0); CHECK(strlen(cn_result_text(INT32_MIN)) > 0);)
ENTRY(cn_sizeof, cn_sizeof(CN_TYPE_WORLD_DEF) == (int32_t)sizeof(cn_world_def) ? CN_OK : -1,
	int32_t k; CHECK(cn_sizeof(-1) == 0); CHECK(cn_sizeof(CN_TYPE_COUNT) == 0); CHECK(cn_sizeof(INT32_MAX) == 0); CHECK(cn_sizeof(INT32_MIN) == 0);
	for (k = 0; k < CN_TYPE_COUNT; ++k) CHECK(cn_sizeof(k) > 0);)
ENTRY(cn_world_def_init, (cn_world_def_init(&wd), CN_OK), cn_world_def_init(NULL);)

static void bad_world_defs(cn_result (*call)(const cn_world_def *));
static cn_result call_def_check(const cn_world_def *d) { return cn_world_def_check(d, NULL, 0); }
static cn_result call_bytes_needed(const cn_world_def *d) { return cn_world_bytes_needed(d, OUT(uint64_t)); }
static cn_result call_create(const cn_world_def *d) { return cn_world_create(d, OUT(cn_world *)); }
static void *some_pointer(int offset) { static uint64_t block[64]; return (unsigned char *)block + offset; }

static void bad_world_defs(cn_result (*call)(const cn_world_def *))
{
	ARG(call(NULL));
	SIZES(x, call(WD(struct_size, x)));
	FLAGS(x, 3, call(WD(flags, x)));
	VECTOR(v, call(WD(gravity_mps2, v)));
	POSITIVE(x, call(WD(length_unit_m, x)));
	ARG(call(WD(length_unit_m, 1.1e6f)));
	INTEGER(x, -1, 1, call(WD(solver, x)));
	INTEGER(x, -1, 1, call(WD(broadphase, x)));
	INTEGER(x, 0, 65, call(WD(substep_count, x)));
	NOT_NEGATIVE(x, call(WD(restitution_threshold_mps, x)));
	NOT_NEGATIVE(x, call(WD(push_speed_max_mps, x)));
	NOT_NEGATIVE(x, call(WD(linear_speed_max_mps, x)));
	NOT_NEGATIVE(x, call(WD(angular_speed_max_radps, x)));
	NOT_NEGATIVE(x, call(WD(sleep_speed_mps, x)));
	NOT_NEGATIVE(x, call(WD(sleep_delay_s, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(body_capacity, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(shape_capacity, x)));
	INTEGER(x, -1, INT32_MAX, call(WD(contact_capacity, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(joint_capacity, x)));
	ARG(call(WD(alloc, test_alloc)));
	ARG(call(WD(free, test_free)));
	ARG(call(WD(memory, some_pointer(1))));
}

ENTRY(cn_world_def_check, cn_world_def_check((reset(), &wd), NULL, 0),
	char text[64] = "x"; bad_world_defs(call_def_check); ARG(cn_world_def_check(&wd, NULL, 5)); ARG(cn_world_def_check(&wd, OUT(char), -1));
	CHECK(cn_world_def_check(WD(substep_count, 99), text, 8) == CN_ERROR_ARGUMENT); CHECK(strlen(text) == 7);
	CHECK(cn_world_def_check(WD(substep_count, 99), text, 64) == CN_ERROR_ARGUMENT); CHECK(strstr(text, "substep_count 99") != NULL);)
ENTRY(cn_world_bytes_needed, cn_world_bytes_needed((reset(), &wd), OUT(uint64_t)),
	bad_world_defs(call_bytes_needed); ARG(cn_world_bytes_needed((reset(), &wd), NULL));)

static cn_result create_and_destroy(void)
{
	cn_world *world = NULL;
	cn_result result;
	reset();
	wd.alloc = test_alloc;
	wd.free = test_free;
	result = cn_world_create(&wd, &world);
	if (result == CN_OK)
		cn_world_destroy(world);
	return result;
}

ENTRY(cn_world_create, create_and_destroy(),
	static uint64_t tiny[64]; void *block = (void *)(((uintptr_t)tiny + 63) & ~(uintptr_t)63);
	bad_world_defs(call_create); ARG(cn_world_create((reset(), &wd), NULL));
	reset(); wd.memory = block; wd.memory_bytes = 128; BAD(CN_ERROR_MEMORY, cn_world_create(&wd, OUT(cn_world *)));)
ENTRY(cn_world_destroy, CN_OK, cn_world_destroy(NULL);)
ENTRY(cn_world_step, cn_world_step(W, 0.01f),
	NOW(cn_world_step(NULL, 0.01f)); RANGE(x, -0.001f, 1.001f, cn_world_step(W, x));)
ENTRY(cn_world_error_text, cn_world_error_text(W) != NULL ? CN_OK : -1, CHECK(strcmp(cn_world_error_text(NULL), "") == 0);)
ENTRY(cn_world_set_gravity, cn_world_set_gravity(W, v2(1.0f, -9.0f)),
	NOW(cn_world_set_gravity(NULL, v2(1.0f, 1.0f))); VECTOR(v, cn_world_set_gravity(W, v));)
WORLD_GETTER(cn_world_get_gravity, cn_vec2)
ENTRY(cn_world_set_substep_count, cn_world_set_substep_count(W, 8),
	NOW(cn_world_set_substep_count(NULL, 8)); INTEGER(x, 0, 65, cn_world_set_substep_count(W, x));)
WORLD_GETTER(cn_world_get_substep_count, int32_t)
ENTRY(cn_world_set_flags, cn_world_set_flags(W, CN_WORLD_PROFILE),
	NOW(cn_world_set_flags(NULL, 0)); FLAGS(x, 3, cn_world_set_flags(W, x));)
WORLD_GETTER(cn_world_get_flags, uint32_t)
ENTRY(cn_world_set_restitution_threshold, cn_world_set_restitution_threshold(W, 2.0f),
	NOW(cn_world_set_restitution_threshold(NULL, 2.0f)); NOT_NEGATIVE(x, cn_world_set_restitution_threshold(W, x));)
ENTRY(cn_world_set_speed_limits, cn_world_set_speed_limits(W, 50.0f, 60.0f),
	NOW(cn_world_set_speed_limits(NULL, 1.0f, 1.0f)); POSITIVE(x, cn_world_set_speed_limits(W, x, 1.0f)); POSITIVE(x, cn_world_set_speed_limits(W, 1.0f, x));)
ENTRY(cn_world_set_sleep, cn_world_set_sleep(W, 0.1f, 1.0f),
	NOW(cn_world_set_sleep(NULL, 0.1f, 1.0f)); NOT_NEGATIVE(x, cn_world_set_sleep(W, x, 1.0f)); NOT_NEGATIVE(x, cn_world_set_sleep(W, 1.0f, x));)
ENTRY(cn_world_set_user_data, cn_world_set_user_data(W, 7), NOW(cn_world_set_user_data(NULL, 7));)
WORLD_GETTER(cn_world_get_user_data, uint64_t)
WORLD_LIST(cn_world_get_bodies, cn_body)
WORLD_LIST(cn_world_get_shapes, cn_shape)
WORLD_LIST(cn_world_get_joints, cn_joint)
WORLD_GETTER(cn_world_get_counters, cn_counters)
WORLD_GETTER(cn_world_get_profile, cn_profile)
WORLD_GETTER(cn_world_get_memory_stats, cn_memory_stats)
WORLD_GETTER(cn_world_hash, uint64_t)
ENTRY(cn_world_validate, cn_world_validate(W, NULL, 0),
	NOW(cn_world_validate(NULL, NULL, 0)); ARG(cn_world_validate(W, NULL, 5)); ARG(cn_world_validate(W, OUT(char), -1));)

/* ---- bodies */

static char long_name[CN_NAME_MAX_BYTES + 2];
static const char *too_long(void)
{
	memset(long_name, 'n', CN_NAME_MAX_BYTES + 1);
	return long_name;
}

static cn_body_def many[3];
static const cn_body_def *spoiled_last(const cn_body_def *d)
{
	many[0] = many[1] = many[2] = *d;
	reset();
	many[0] = many[1] = bd;
	return many;
}

static cn_result call_body_create(const cn_body_def *d) { return cn_body_create(W, d, OUT(cn_body)); }
static cn_result call_body_create_many(const cn_body_def *d) { return cn_body_create_many(W, d != NULL ? spoiled_last(d) : NULL, 3, OUT(cn_body)); }

static void bad_body_defs(cn_result (*call)(const cn_body_def *))
{
	ARG(call(NULL));
	SIZES(x, call(BD(struct_size, x)));
	INTEGER(x, -1, 3, call(BD(type, x)));
	POSITION(v, call(BD(position_m, v)));
	ANGLE(x, call(BD(angle_rad, x)));
	VECTOR(v, call(BD(linear_velocity_mps, v)));
	FLOAT(x, call(BD(angular_velocity_radps, x)));
	NOT_NEGATIVE(x, call(BD(linear_damping_per_s, x)));
	NOT_NEGATIVE(x, call(BD(angular_damping_per_s, x)));
	FLOAT(x, call(BD(gravity_scale, x)));
	NOT_NEGATIVE(x, call(BD(sleep_speed_mps, x)));
	FLAGS(x, 7, call(BD(flags, x)));
	ARG(call(BD(name, too_long())));
}

ENTRY(cn_body_def_init, (cn_body_def_init(&bd), CN_OK), cn_body_def_init(NULL);)
ENTRY(cn_body_create, cn_body_create(W, (reset(), &bd), OUT(cn_body)),
	bad_body_defs(call_body_create); NOW(cn_body_create(NULL, (reset(), &bd), OUT(cn_body))); ARG(cn_body_create(W, (reset(), &bd), NULL));)
ENTRY(cn_body_create_many, cn_body_create_many(W, spoiled_last((reset(), &bd)), 3, OUT(cn_body)),
	bad_body_defs(call_body_create_many); NOW(cn_body_create_many(NULL, many, 3, OUT(cn_body)));
	ARG(cn_body_create_many(W, spoiled_last((reset(), &bd)), -1, OUT(cn_body))); ARG(cn_body_create_many(W, many, 3, NULL));)
ENTRY(cn_body_destroy, cn_body_destroy(W, f.box), NOW(cn_body_destroy(NULL, f.box)); BODY(h, cn_body_destroy(W, h));)

static const cn_body *three(cn_body a, cn_body b, cn_body c)
{
	static cn_body list[3];
	list[0] = a;
	list[1] = b;
	list[2] = c;
	return list;
}

ENTRY(cn_body_destroy_many, cn_body_destroy_many(W, three(f.box, f.ground, f.ball), 3),
	NOW(cn_body_destroy_many(NULL, three(f.box, f.ground, f.ball), 3)); BODY(h, cn_body_destroy_many(W, three(f.box, f.ball, h), 3));
	BODY(h, cn_body_destroy_many(W, three(h, f.box, f.ball), 3)); ARG(cn_body_destroy_many(W, NULL, 1));
	ARG(cn_body_destroy_many(W, three(f.box, f.ball, f.box), 3)); ARG(cn_body_destroy_many(W, three(f.box, f.ball, f.pill), -1));)
ENTRY(cn_body_is_valid, cn_body_is_valid(W, f.box) ? CN_OK : -1,
	int k; CHECK(cn_body_is_valid(NULL, f.box) == 0); for (k = 0; k < f.bad_body_count; ++k) CHECK(cn_body_is_valid(W, f.bad_bodies[k]) == 0);)
ENTRY(cn_body_set_type, cn_body_set_type(W, f.box, CN_BODY_STATIC),
	NOW(cn_body_set_type(NULL, f.box, 0)); BODY(h, cn_body_set_type(W, h, 0)); INTEGER(x, -1, 3, cn_body_set_type(W, f.box, x));
	STATE(cn_body_set_type(W, f.ball, CN_BODY_STATIC)); STATE(cn_body_set_type(W, f.ball, CN_BODY_KINEMATIC));)
GETTER(cn_body_get_type, BODY, f.box, int32_t)
ENTRY(cn_body_set_flags, cn_body_set_flags(W, f.box, CN_BODY_LOCK_X),
	NOW(cn_body_set_flags(NULL, f.box, 0)); BODY(h, cn_body_set_flags(W, h, 0)); FLAGS(x, 7, cn_body_set_flags(W, f.box, x));)
GETTER(cn_body_get_flags, BODY, f.box, uint32_t)
ENTRY(cn_body_set_awake, cn_body_set_awake(W, f.box, 0), NOW(cn_body_set_awake(NULL, f.box, 0)); BODY(h, cn_body_set_awake(W, h, 0));)
ENTRY(cn_body_set_pose, cn_body_set_pose(W, f.box, v2(1.0f, 3.0f), 0.5f),
	NOW(cn_body_set_pose(NULL, f.box, v2(1.0f, 3.0f), 0.5f)); BODY(h, cn_body_set_pose(W, h, v2(1.0f, 3.0f), 0.5f));
	POSITION(v, cn_body_set_pose(W, f.box, v, 0.5f)); ANGLE(x, cn_body_set_pose(W, f.box, v2(0.0f, 0.0f), x));)
GETTER(cn_body_get_pose, BODY, f.box, cn_pose)
GETTER(cn_body_get_angle, BODY, f.box, float)
GETTER(cn_body_get_center, BODY, f.box, cn_vec2)
ENTRY(cn_body_set_velocity, cn_body_set_velocity(W, f.box, v2(1.0f, 0.0f), 1.0f),
	NOW(cn_body_set_velocity(NULL, f.box, v2(1.0f, 0.0f), 1.0f)); BODY(h, cn_body_set_velocity(W, h, v2(1.0f, 0.0f), 1.0f));
	VECTOR(v, cn_body_set_velocity(W, f.box, v, 1.0f)); FLOAT(x, cn_body_set_velocity(W, f.box, v2(1.0f, 0.0f), x));
	STATE(cn_body_set_velocity(W, f.ground, v2(0.0f, 0.0f), 0.0f));)
GETTER(cn_body_get_velocity, BODY, f.box, cn_velocity)
#define POINT_GETTER(name) ENTRY(name, name(W, f.box, v2(1.0f, 2.0f), OUT(cn_vec2)), NOW(name(NULL, f.box, v2(1.0f, 2.0f), OUT(cn_vec2))); \
	BODY(h, name(W, h, v2(1.0f, 2.0f), OUT(cn_vec2))); VECTOR(v, name(W, f.box, v, OUT(cn_vec2))); ARG(name(W, f.box, v2(1.0f, 2.0f), NULL));)
POINT_GETTER(cn_body_get_velocity_at)
POINT_GETTER(cn_body_get_world_point)
POINT_GETTER(cn_body_get_local_point)
GETTER(cn_body_get_aabb, BODY, f.box, cn_aabb)
#define PUSH_VECTOR(name, huge) ENTRY(name, name(W, f.box, v2(1.0f, 2.0f)), NOW(name(NULL, f.box, v2(1.0f, 2.0f))); \
	BODY(h, name(W, h, v2(1.0f, 2.0f))); VECTOR(v, name(W, f.box, v)); huge)
#define PUSH_AT(name) ENTRY(name, name(W, f.box, v2(1.0f, 2.0f), v2(0.0f, 1.0f)), NOW(name(NULL, f.box, v2(1.0f, 2.0f), v2(0.0f, 1.0f))); \
	BODY(h, name(W, h, v2(1.0f, 2.0f), v2(0.0f, 1.0f))); VECTOR(v, name(W, f.box, v, v2(0.0f, 1.0f))); \
	VECTOR(v, name(W, f.box, v2(1.0f, 2.0f), v)); ARG(name(W, f.box, v2(3e38f, 0.0f), v2(1.0f, 3e38f)));)
#define PUSH_FLOAT(name) ENTRY(name, name(W, f.box, 2.0f), NOW(name(NULL, f.box, 2.0f)); BODY(h, name(W, h, 2.0f)); FLOAT(x, name(W, f.box, x));)
PUSH_VECTOR(cn_body_apply_force, CHECK(cn_body_apply_force(W, f.box, v2(3e38f, 0.0f)) == CN_OK); ARG(cn_body_apply_force(W, f.box, v2(3e38f, 0.0f)));
	CHECK(cn_body_apply_force(W, f.box, v2(-3e38f, 0.0f)) == CN_OK);)
PUSH_AT(cn_body_apply_force_at)
PUSH_FLOAT(cn_body_apply_torque)
PUSH_VECTOR(cn_body_apply_impulse, (void)0;)
PUSH_AT(cn_body_apply_impulse_at)
PUSH_FLOAT(cn_body_apply_angular_impulse)
GETTER(cn_body_get_mass_data, BODY, f.box, cn_mass_data)
ENTRY(cn_body_set_mass_data, cn_body_set_mass_data(W, f.box, (reset(), &mass)),
	NOW(cn_body_set_mass_data(NULL, f.box, &mass)); BODY(h, cn_body_set_mass_data(W, h, (reset(), &mass))); ARG(cn_body_set_mass_data(W, f.box, NULL));
	POSITIVE(x, cn_body_set_mass_data(W, f.box, MD(mass_kg, x))); NOT_NEGATIVE(x, cn_body_set_mass_data(W, f.box, MD(inertia_kgm2, x)));
	ARG(cn_body_set_mass_data(W, f.box, MD(mass_kg, 1e-40f))); ARG(cn_body_set_mass_data(W, f.box, MD(inertia_kgm2, 1e-40f)));
	POSITION(v, cn_body_set_mass_data(W, f.box, MD(center_m, v))); STATE(cn_body_set_mass_data(W, f.ground, (reset(), &mass)));
	STATE(cn_body_set_mass_data(W, f.rail, (reset(), &mass)));)
ENTRY(cn_body_reset_mass_data, cn_body_reset_mass_data(W, f.box), NOW(cn_body_reset_mass_data(NULL, f.box)); BODY(h, cn_body_reset_mass_data(W, h));)
ENTRY(cn_body_set_damping, cn_body_set_damping(W, f.box, 0.1f, 0.2f),
	NOW(cn_body_set_damping(NULL, f.box, 0.1f, 0.2f)); BODY(h, cn_body_set_damping(W, h, 0.1f, 0.2f));
	NOT_NEGATIVE(x, cn_body_set_damping(W, f.box, x, 0.2f)); NOT_NEGATIVE(x, cn_body_set_damping(W, f.box, 0.1f, x));)
GETTER2(cn_body_get_damping, BODY, f.box, float, float)
ENTRY(cn_body_set_gravity_scale, cn_body_set_gravity_scale(W, f.box, -0.5f),
	NOW(cn_body_set_gravity_scale(NULL, f.box, 1.0f)); BODY(h, cn_body_set_gravity_scale(W, h, 1.0f)); FLOAT(x, cn_body_set_gravity_scale(W, f.box, x));)
GETTER(cn_body_get_gravity_scale, BODY, f.box, float)
ENTRY(cn_body_set_sleep_speed, cn_body_set_sleep_speed(W, f.box, 0.1f),
	NOW(cn_body_set_sleep_speed(NULL, f.box, 0.1f)); BODY(h, cn_body_set_sleep_speed(W, h, 0.1f)); NOT_NEGATIVE(x, cn_body_set_sleep_speed(W, f.box, x));)
ENTRY(cn_body_set_user_data, cn_body_set_user_data(W, f.box, 3), NOW(cn_body_set_user_data(NULL, f.box, 3)); BODY(h, cn_body_set_user_data(W, h, 3));)
GETTER(cn_body_get_user_data, BODY, f.box, uint64_t)
ENTRY(cn_body_set_name, cn_body_set_name(W, f.box, "another and a rather longer name"),
	NOW(cn_body_set_name(NULL, f.box, "n")); BODY(h, cn_body_set_name(W, h, "n")); ARG(cn_body_set_name(W, f.box, too_long()));)
GETTER(cn_body_get_name, BODY, f.box, const char *)
HANDLE_LIST(cn_body_get_shapes, BODY, f.box, cn_shape)
HANDLE_LIST(cn_body_get_joints, BODY, f.ball, cn_joint)

#define BULK(name, T, out) NOW(name(NULL, three(f.box, f.ball, f.pill), 3, out)); BODY(h, name(W, three(f.box, f.ball, h), 3, out)); \
	ARG(name(W, three(f.box, f.ball, f.pill), -1, out)); ARG(name(W, three(f.box, f.ball, f.pill), 3, NULL)); \
	ARG(name(W, NULL, 3, out)); ARG(name(W, NULL, 6, out)); ARG(name(W, NULL, -1, out));
ENTRY(cn_world_read_poses, cn_world_read_poses(W, NULL, 5, OUT(cn_pose)), BULK(cn_world_read_poses, cn_pose, OUT(cn_pose)))
ENTRY(cn_world_read_poses_strided, cn_world_read_poses_strided(W, NULL, 5, OUT(void), 20),
	const cn_body *l = three(f.box, f.ball, f.pill); NOW(cn_world_read_poses_strided(NULL, l, 3, OUT(void), 20));
	ARG(cn_world_read_poses_strided(W, l, 3, OUT(void), 15)); ARG(cn_world_read_poses_strided(W, l, 3, OUT(void), -16));
	ARG(cn_world_read_poses_strided(W, l, 3, NULL, 20)); ARG(cn_world_read_poses_strided(W, l, -3, OUT(void), 20));
	ARG(cn_world_read_poses_strided(W, NULL, 4, OUT(void), 20));
	BODY(h, cn_world_read_poses_strided(W, three(f.box, h, f.ball), 3, OUT(void), 20));)
ENTRY(cn_world_read_velocities, cn_world_read_velocities(W, NULL, 5, OUT(cn_velocity)), BULK(cn_world_read_velocities, cn_velocity, OUT(cn_velocity)))

static cn_velocity speeds[6];
static const cn_velocity *last_velocity(cn_vec2 linear, float angular)
{
	memset(speeds, 0, sizeof speeds);
	speeds[0].linear_mps = v2(1.0f, 1.0f);
	speeds[2].linear_mps = linear;
	speeds[2].angular_radps = angular;
	return speeds;
}
ENTRY(cn_world_write_velocities, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v2(1.0f, 2.0f), 3.0f)),
	const cn_velocity *good = last_velocity(v2(1.0f, 2.0f), 3.0f); BULK(cn_world_write_velocities, cn_velocity, good)
	VECTOR(v, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v, 0.0f)));
	FLOAT(x, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v2(0.0f, 0.0f), x)));
	STATE(cn_world_write_velocities(W, three(f.box, f.ball, f.ground), 3, last_velocity(v2(1.0f, 0.0f), 0.0f)));)
#define ARRAY_GETTER(name, T) ENTRY(name, name(W, OUT(const T *), INT + 8), NOW(name(NULL, OUT(const T *), INT + 8)); \
	ARG(name(W, NULL, INT + 8)); ARG(name(W, OUT(const T *), NULL));)
ARRAY_GETTER(cn_world_moved, cn_body_moved)

/* ---- shapes */

ENTRY(cn_shape_def_init, (cn_shape_def_init(&sd), CN_OK), cn_shape_def_init(NULL);)

static cn_result call_circle(const cn_shape_def *d) { return cn_shape_create_circle(W, d, &circle, OUT(cn_shape)); }
static cn_result call_capsule(const cn_shape_def *d) { return cn_shape_create_capsule(W, d, &capsule, OUT(cn_shape)); }
static cn_result call_edge(const cn_shape_def *d) { return cn_shape_create_edge(W, d, &edge, OUT(cn_shape)); }
static cn_result call_polygon(const cn_shape_def *d) { return cn_shape_create_polygon(W, d, &polygon, OUT(cn_shape)); }
static cn_result call_box(const cn_shape_def *d) { return cn_shape_create_box(W, d, 1.0f, 2.0f, 0.0f, OUT(cn_shape)); }
static cn_result call_chain(const cn_shape_def *d) { return cn_shape_create_chain(W, d, &chain, OUT(cn_shape)); }

static void bad_shape_defs(cn_result (*call)(const cn_shape_def *), int has_mass)
{
	reset();
	ARG(call(NULL));
	SIZES(x, call(SD(struct_size, x)));
	BODY_BUT_ZERO(h, call(SD(body, h)));
	POSITION(v, call(SD(offset_m, v)));
	ANGLE(x, call(SD(angle_rad, x)));
	NOT_NEGATIVE(x, call(SD(density_kgpm2, x)));
	RANGE(x, -0.1f, 101.0f, call(SD(material.static_friction, x)));
	RANGE(x, -0.1f, 0.61f, call(SD(material.dynamic_friction, x)));
	RANGE(x, -0.1f, 1.1f, call(SD(material.restitution, x)));
	FLAGS(x, CN_EVENT_KINDS, call(SD(event_mask, x)));
	if (has_mass) {
		ARG(call(SD(density_kgpm2, 1e30f)));
		ARG(call(SD(density_kgpm2, 1e-30f)));
	}
}

ENTRY(cn_shape_create_circle, cn_shape_create_circle(W, (reset(), &sd), &circle, NULL),
	bad_shape_defs(call_circle, 1); NOW(cn_shape_create_circle(NULL, &sd, &circle, OUT(cn_shape))); ARG(cn_shape_create_circle(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_circle(W, &sd, CI(center_m, v), OUT(cn_shape))); POSITIVE(x, cn_shape_create_circle(W, &sd, CI(radius_m, x), OUT(cn_shape)));
	ARG(cn_shape_create_circle(W, &sd, CI(radius_m, 1e7f), OUT(cn_shape)));)
ENTRY(cn_shape_create_capsule, cn_shape_create_capsule(W, (reset(), &sd), &capsule, NULL),
	bad_shape_defs(call_capsule, 1); NOW(cn_shape_create_capsule(NULL, &sd, &capsule, OUT(cn_shape))); ARG(cn_shape_create_capsule(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_capsule(W, &sd, CA(a_m, v), OUT(cn_shape))); VECTOR(v, cn_shape_create_capsule(W, &sd, CA(b_m, v), OUT(cn_shape)));
	POSITIVE(x, cn_shape_create_capsule(W, &sd, CA(radius_m, x), OUT(cn_shape))); ARG(cn_shape_create_capsule(W, &sd, CA(a_m, v2(0.499f, 0.0f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_edge, cn_shape_create_edge(W, (reset(), &sd), &edge, NULL),
	bad_shape_defs(call_edge, 0); NOW(cn_shape_create_edge(NULL, &sd, &edge, OUT(cn_shape))); ARG(cn_shape_create_edge(W, &sd, NULL, OUT(cn_shape)));
	VECTOR(v, cn_shape_create_edge(W, &sd, ED(a_m, v), OUT(cn_shape))); VECTOR(v, cn_shape_create_edge(W, &sd, ED(b_m, v), OUT(cn_shape)));
	ARG(cn_shape_create_edge(W, &sd, ED(a_m, v2(0.499f, 0.0f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_polygon, cn_shape_create_polygon(W, (reset(), &sd), &polygon, NULL),
	bad_shape_defs(call_polygon, 1); NOW(cn_shape_create_polygon(NULL, &sd, &polygon, OUT(cn_shape))); ARG(cn_shape_create_polygon(W, &sd, NULL, OUT(cn_shape)));
	INTEGER(x, 2, 17, cn_shape_create_polygon(W, &sd, PO(count, x), OUT(cn_shape))); NOT_NEGATIVE(x, cn_shape_create_polygon(W, &sd, PO(radius_m, x), OUT(cn_shape)));
	VECTOR(v, cn_shape_create_polygon(W, &sd, PO(points_m[2], v), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(-0.4f, -0.4f)), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(0.5f, -0.499f)), OUT(cn_shape)));
	ARG(cn_shape_create_polygon(W, &sd, PO(points_m[2], v2(-0.5f, 0.501f)), OUT(cn_shape)));)
ENTRY(cn_shape_create_box, cn_shape_create_box(W, (reset(), &sd), 1.0f, 2.0f, 0.1f, NULL),
	bad_shape_defs(call_box, 1); NOW(cn_shape_create_box(NULL, &sd, 1.0f, 2.0f, 0.1f, OUT(cn_shape))); reset();
	POSITIVE(x, cn_shape_create_box(W, &sd, x, 2.0f, 0.1f, OUT(cn_shape))); POSITIVE(x, cn_shape_create_box(W, &sd, 1.0f, x, 0.1f, OUT(cn_shape)));
	NOT_NEGATIVE(x, cn_shape_create_box(W, &sd, 1.0f, 2.0f, x, OUT(cn_shape))); ARG(cn_shape_create_box(W, &sd, 1e-4f, 2.0f, 0.0f, OUT(cn_shape)));)
static const cn_chain *loop_of_two(void)
{
	reset();
	chain.loop = 1;
	chain.count = 2;
	return &chain;
}

ENTRY(cn_shape_create_chain, cn_shape_create_chain(W, (reset(), &sd), &chain, NULL),
	bad_shape_defs(call_chain, 0); NOW(cn_shape_create_chain(NULL, &sd, &chain, OUT(cn_shape))); ARG(cn_shape_create_chain(W, &sd, NULL, OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, CH(points_m, NULL), OUT(cn_shape))); FLAGS(x, 1, cn_shape_create_chain(W, &sd, CH(loop, x), OUT(cn_shape)));
	INTEGER(x, 1, 65536, cn_shape_create_chain(W, &sd, CH(count, x), OUT(cn_shape))); VECTOR(v, cn_shape_create_chain(W, &sd, CP(3, v), OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, CP(2, chain_points[1]), OUT(cn_shape)));
	ARG(cn_shape_create_chain(W, &sd, loop_of_two(), OUT(cn_shape)));)
ENTRY(cn_shape_attach, cn_shape_attach(W, f.loose, f.pill),
	NOW(cn_shape_attach(NULL, f.loose, f.pill)); SHAPE(h, cn_shape_attach(W, h, f.pill)); BODY(h, cn_shape_attach(W, f.loose, h));
	STATE(cn_shape_attach(W, f.box_shape, f.pill)); STATE(cn_shape_attach(W, f.box_shape, f.box));)
ENTRY(cn_shape_detach, cn_shape_detach(W, f.box_shape),
	NOW(cn_shape_detach(NULL, f.box_shape)); SHAPE(h, cn_shape_detach(W, h)); STATE(cn_shape_detach(W, f.loose));)
ENTRY(cn_shape_destroy, cn_shape_destroy(W, f.ground_shape), NOW(cn_shape_destroy(NULL, f.box_shape)); SHAPE(h, cn_shape_destroy(W, h));)
ENTRY(cn_shape_is_valid, cn_shape_is_valid(W, f.loose) ? CN_OK : -1,
	int k; CHECK(cn_shape_is_valid(NULL, f.loose) == 0); for (k = 0; k < f.bad_shape_count; ++k) CHECK(cn_shape_is_valid(W, f.bad_shapes[k]) == 0);)
GETTER(cn_shape_get_type, SHAPE, f.loose, int32_t)
GETTER(cn_shape_get_body, SHAPE, f.loose, cn_body)
ENTRY(cn_shape_set_material, cn_shape_set_material(W, f.box_shape, (reset(), &material)),
	NOW(cn_shape_set_material(NULL, f.box_shape, &material)); SHAPE(h, cn_shape_set_material(W, h, (reset(), &material)));
	ARG(cn_shape_set_material(W, f.box_shape, NULL)); RANGE(x, -0.1f, 101.0f, cn_shape_set_material(W, f.box_shape, MA(static_friction, x)));
	RANGE(x, -0.1f, 0.51f, cn_shape_set_material(W, f.box_shape, MA(dynamic_friction, x)));
	RANGE(x, -0.1f, 1.1f, cn_shape_set_material(W, f.box_shape, MA(restitution, x)));)
GETTER(cn_shape_get_material, SHAPE, f.box_shape, cn_material)
ENTRY(cn_shape_set_density, cn_shape_set_density(W, f.box_shape, 3.0f),
	NOW(cn_shape_set_density(NULL, f.box_shape, 3.0f)); SHAPE(h, cn_shape_set_density(W, h, 3.0f)); NOT_NEGATIVE(x, cn_shape_set_density(W, f.box_shape, x));
	ARG(cn_shape_set_density(W, f.box_shape, 1e30f)); ARG(cn_shape_set_density(W, f.box_shape, 1e-30f));)
GETTER(cn_shape_get_density, SHAPE, f.box_shape, float)
ENTRY(cn_shape_set_filter, cn_shape_set_filter(W, f.box_shape, (reset(), &filter)),
	NOW(cn_shape_set_filter(NULL, f.box_shape, &filter)); SHAPE(h, cn_shape_set_filter(W, h, (reset(), &filter))); ARG(cn_shape_set_filter(W, f.box_shape, NULL));)
GETTER(cn_shape_get_filter, SHAPE, f.box_shape, cn_filter)
ENTRY(cn_shape_set_event_mask, cn_shape_set_event_mask(W, f.box_shape, 3),
	NOW(cn_shape_set_event_mask(NULL, f.box_shape, 3)); SHAPE(h, cn_shape_set_event_mask(W, h, 3)); FLAGS(x, CN_EVENT_KINDS, cn_shape_set_event_mask(W, f.box_shape, x));)
GETTER(cn_shape_get_event_mask, SHAPE, f.box_shape, uint32_t)
ENTRY(cn_shape_set_user_data, cn_shape_set_user_data(W, f.box_shape, 3), NOW(cn_shape_set_user_data(NULL, f.box_shape, 3)); SHAPE(h, cn_shape_set_user_data(W, h, 3));)
GETTER(cn_shape_get_user_data, SHAPE, f.box_shape, uint64_t)
GETTER(cn_shape_get_aabb, SHAPE, f.box_shape, cn_aabb)
GETTER(cn_shape_get_mass_data, SHAPE, f.box_shape, cn_mass_data)
#define GEOMETRY_GETTER(name, shape, other, T) ENTRY(name, name(W, shape, OUT(T)), \
	NOW(name(NULL, shape, OUT(T))); SHAPE(h, name(W, h, OUT(T))); ARG(name(W, shape, NULL)); STATE(name(W, other, OUT(T)));)
GEOMETRY_GETTER(cn_shape_get_circle, f.ball_shape, f.box_shape, cn_circle)
GEOMETRY_GETTER(cn_shape_get_capsule, f.pill_shape, f.ball_shape, cn_capsule)
GEOMETRY_GETTER(cn_shape_get_edge, f.edge, f.chain, cn_edge)
GEOMETRY_GETTER(cn_shape_get_polygon, f.box_shape, f.edge, cn_polygon)
ENTRY(cn_shape_get_chain_points, cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, 3, INT),
	NOW(cn_shape_get_chain_points(NULL, f.chain, OUT(cn_vec2) + 4, 3, INT)); SHAPE(h, cn_shape_get_chain_points(W, h, OUT(cn_vec2) + 4, 3, INT));
	ARG(cn_shape_get_chain_points(W, f.chain, NULL, 3, INT)); ARG(cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, -1, INT));
	ARG(cn_shape_get_chain_points(W, f.chain, OUT(cn_vec2) + 4, 3, NULL)); STATE(cn_shape_get_chain_points(W, f.edge, OUT(cn_vec2) + 4, 3, INT));)
ENTRY(cn_shape_test_point, cn_shape_test_point(W, f.box_shape, v2(0.0f, 0.0f), INT),
	NOW(cn_shape_test_point(NULL, f.box_shape, v2(0.0f, 0.0f), INT)); SHAPE(h, cn_shape_test_point(W, h, v2(0.0f, 0.0f), INT));
	VECTOR(v, cn_shape_test_point(W, f.box_shape, v, INT)); ARG(cn_shape_test_point(W, f.box_shape, v2(0.0f, 0.0f), NULL));)

static const cn_vec2 *hull_points(int kind, cn_vec2 last)
{
	static cn_vec2 p[4];
	p[0] = v2(0.0f, 0.0f);
	p[1] = v2(1.0f, 0.0f);
	p[2] = kind == 1 ? v2(2.0f, 0.0f) : kind == 2 ? p[1] : v2(1.0f, 1.0f);
	p[3] = kind != 0 ? p[0] : last;
	return p;
}
#define GOOD_POINTS hull_points(0, v2(0.0f, 1.0f))
ENTRY(cn_polygon_make_hull, cn_polygon_make_hull(GOOD_POINTS, 4, 0.0f, OUT(cn_polygon)),
	ARG(cn_polygon_make_hull(NULL, 4, 0.0f, OUT(cn_polygon))); ARG(cn_polygon_make_hull(GOOD_POINTS, 4, 0.0f, NULL));
	INTEGER(x, 0, 65537, cn_polygon_make_hull(GOOD_POINTS, x, 0.0f, OUT(cn_polygon))); ARG(cn_polygon_make_hull(GOOD_POINTS, 2, 0.0f, OUT(cn_polygon)));
	NOT_NEGATIVE(x, cn_polygon_make_hull(GOOD_POINTS, 4, x, OUT(cn_polygon))); POSITION(v, cn_polygon_make_hull(hull_points(0, v), 4, 0.0f, OUT(cn_polygon)));
	ARG(cn_polygon_make_hull(hull_points(1, v2(0.0f, 0.0f)), 4, 0.0f, OUT(cn_polygon)));
	ARG(cn_polygon_make_hull(hull_points(2, v2(0.0f, 0.0f)), 4, 0.0f, OUT(cn_polygon)));)
ENTRY(cn_polygon_make_box, cn_polygon_make_box(1.0f, 2.0f, v2(3.0f, 4.0f), 0.5f, 0.1f, OUT(cn_polygon)),
	POSITIVE(x, cn_polygon_make_box(x, 2.0f, v2(3.0f, 4.0f), 0.5f, 0.1f, OUT(cn_polygon)));
	POSITIVE(x, cn_polygon_make_box(1.0f, x, v2(3.0f, 4.0f), 0.5f, 0.1f, OUT(cn_polygon)));
	POSITION(v, cn_polygon_make_box(1.0f, 2.0f, v, 0.5f, 0.1f, OUT(cn_polygon)));
	ANGLE(x, cn_polygon_make_box(1.0f, 2.0f, v2(3.0f, 4.0f), x, 0.1f, OUT(cn_polygon)));
	NOT_NEGATIVE(x, cn_polygon_make_box(1.0f, 2.0f, v2(3.0f, 4.0f), 0.5f, x, OUT(cn_polygon)));
	ARG(cn_polygon_make_box(1.0f, 2.0f, v2(3.0f, 4.0f), 0.5f, 0.1f, NULL));)

/* ---- contacts */

static void ignore_event(cn_world *world, const cn_contact_event *event, void *user)
{
	(void)world;
	(void)event;
	(void)user;
}

#define EVENTS OUT(const cn_contact_event *)
ENTRY(cn_world_contact_events, cn_world_contact_events(W, CN_EVENT_STAY, EVENTS, INT + 8),
	NOW(cn_world_contact_events(NULL, 1, EVENTS, INT + 8)); INTEGER(x, -1, CN_EVENT_KINDS, cn_world_contact_events(W, x, EVENTS, INT + 8));
	ARG(cn_world_contact_events(W, 1, NULL, INT + 8)); ARG(cn_world_contact_events(W, 1, EVENTS, NULL));)
ENTRY(cn_world_set_contact_callback, cn_world_set_contact_callback(W, CN_EVENT_LEAVE, ignore_event, NULL),
	NOW(cn_world_set_contact_callback(NULL, 1, NULL, NULL)); INTEGER(x, -1, CN_EVENT_KINDS, cn_world_set_contact_callback(W, x, ignore_event, NULL));)
HANDLE_LIST(cn_body_get_contacts, BODY, f.box, cn_contact_event)
ARRAY_GETTER(cn_world_fell_asleep, cn_body)

/* ---- joints */

ENTRY(cn_revolute_def_init, (cn_revolute_def_init(&rd), CN_OK), cn_revolute_def_init(NULL);)
ENTRY(cn_distance_def_init, (cn_distance_def_init(&dd), CN_OK), cn_distance_def_init(NULL);)

static cn_result call_create_revolute(const cn_revolute_def *d) { return cn_joint_create_revolute(W, d, OUT(cn_joint)); }
static cn_result call_create_distance(const cn_distance_def *d) { return cn_joint_create_distance(W, d, OUT(cn_joint)); }
static cn_result call_set_revolute(const cn_revolute_def *d) { return cn_joint_set_revolute(W, f.pin, d); }
static cn_result call_set_distance(const cn_distance_def *d) { return cn_joint_set_distance(W, f.rope, d); }

static void bad_revolute(cn_result (*call)(const cn_revolute_def *))
{
	ARG(call(NULL));
	FLAGS(x, 4, call(RD(base.flags, x)));
	ANGLE(x, call(RD(reference_angle_rad, x)));
	RANGE(x, -3.2f, 0.1f, call(RD(lower_angle_rad, x)));
	RANGE(x, -0.1f, 3.2f, call(RD(upper_angle_rad, x)));
	FLOAT(x, call(RD(motor_speed_radps, x)));
	NOT_NEGATIVE(x, call(RD(motor_torque_max_Nm, x)));
	ANGLE(x, call(RD(spring_target_rad, x)));
	RANGE(x, -1.0f, 1.1e6f, call(RD(spring_hertz, x)));
	RANGE(x, -1.0f, 1.1e6f, call(RD(spring_damping_ratio, x)));
}

static void bad_distance(cn_result (*call)(const cn_distance_def *))
{
	ARG(call(NULL));
	FLAGS(x, 4, call(DD(base.flags, x)));
	POSITIVE(x, call(DD(length_m, x)));
	RANGE(x, -0.1f, 1.1f, call(DD(length_min_m, x)));
	NOT_NEGATIVE(x, call(DD(length_max_m, x)));
	FLOAT(x, call(DD(motor_speed_mps, x)));
	NOT_NEGATIVE(x, call(DD(motor_force_max_N, x)));
	RANGE(x, -1.0f, 1.1e6f, call(DD(spring_hertz, x)));
	RANGE(x, -1.0f, 1.1e6f, call(DD(spring_damping_ratio, x)));
}

/* What both creators check in base; S spoils a field of one type's definition. */
#define BAD_BASE(create, S, def) NOW(create(NULL, (reset(), &def), OUT(cn_joint))); ARG(create(W, (reset(), &def), NULL)); \
	SIZES(x, create(W, S(base.struct_size, x), OUT(cn_joint))); BODY_BUT_ZERO(h, create(W, S(base.body_a, h), OUT(cn_joint))); \
	BODY_BUT_ZERO(h, create(W, S(base.body_b, h), OUT(cn_joint))); POSITION(v, create(W, S(base.anchor_a_m, v), OUT(cn_joint))); \
	POSITION(v, create(W, S(base.anchor_b_m, v), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.box, f.box), OUT(cn_joint))); \
	ARG(create(W, BASE(def, 0, 0), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.ground, f.rail), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.ground, 0), OUT(cn_joint)));

ENTRY(cn_joint_create_revolute, cn_joint_create_revolute(W, (reset(), &rd), OUT(cn_joint)),
	bad_revolute(call_create_revolute); BAD_BASE(cn_joint_create_revolute, RD, rd))
ENTRY(cn_joint_create_distance, cn_joint_create_distance(W, (reset(), &dd), OUT(cn_joint)),
	bad_distance(call_create_distance); BAD_BASE(cn_joint_create_distance, DD, dd))
ENTRY(cn_joint_destroy, cn_joint_destroy(W, f.pin), NOW(cn_joint_destroy(NULL, f.pin)); JOINT(h, cn_joint_destroy(W, h));)
ENTRY(cn_joint_is_valid, cn_joint_is_valid(W, f.pin) ? CN_OK : -1,
	int k; CHECK(cn_joint_is_valid(NULL, f.pin) == 0); for (k = 0; k < f.bad_joint_count; ++k) CHECK(cn_joint_is_valid(W, f.bad_joints[k]) == 0);)
GETTER(cn_joint_get_type, JOINT, f.pin, int32_t)
GETTER2(cn_joint_get_bodies, JOINT, f.pin, cn_body, cn_body)
GETTER2(cn_joint_get_anchors, JOINT, f.pin, cn_vec2, cn_vec2)
GETTER2(cn_joint_get_reaction, JOINT, f.pin, cn_vec2, float)
GETTER2(cn_joint_get_error, JOINT, f.pin, float, float)
ENTRY(cn_joint_set_user_data, cn_joint_set_user_data(W, f.pin, 3), NOW(cn_joint_set_user_data(NULL, f.pin, 3)); JOINT(h, cn_joint_set_user_data(W, h, 3));)
GETTER(cn_joint_get_user_data, JOINT, f.pin, uint64_t)
ENTRY(cn_joint_set_flags, cn_joint_set_flags(W, f.pin, CN_JOINT_MOTOR | CN_JOINT_COLLIDE),
	NOW(cn_joint_set_flags(NULL, f.pin, 0)); JOINT(h, cn_joint_set_flags(W, h, 0)); FLAGS(x, 4, cn_joint_set_flags(W, f.pin, x));)
GETTER(cn_joint_get_flags, JOINT, f.pin, uint32_t)
#define JOINT_TYPE_GETTER(name, joint, other, T) ENTRY(name, name(W, joint, OUT(T)), \
	NOW(name(NULL, joint, OUT(T))); JOINT(h, name(W, h, OUT(T))); ARG(name(W, joint, NULL)); STATE(name(W, other, OUT(T)));)
JOINT_TYPE_GETTER(cn_joint_get_revolute, f.pin, f.rope, cn_revolute_def)
JOINT_TYPE_GETTER(cn_joint_get_distance, f.rope, f.pin, cn_distance_def)
ENTRY(cn_joint_set_revolute, cn_joint_set_revolute(W, f.pin, RD(base.flags, CN_JOINT_LIMIT | CN_JOINT_COLLIDE)),
	bad_revolute(call_set_revolute); NOW(cn_joint_set_revolute(NULL, f.pin, (reset(), &rd))); JOINT(h, cn_joint_set_revolute(W, h, (reset(), &rd)));
	STATE(cn_joint_set_revolute(W, f.rope, (reset(), &rd)));)
ENTRY(cn_joint_set_distance, cn_joint_set_distance(W, f.rope, DD(base.flags, CN_JOINT_SPRING)),
	bad_distance(call_set_distance); NOW(cn_joint_set_distance(NULL, f.rope, (reset(), &dd))); JOINT(h, cn_joint_set_distance(W, h, (reset(), &dd)));
	STATE(cn_joint_set_distance(W, f.pin, (reset(), &dd)));)
GETTER(cn_joint_get_position, JOINT, f.pin, float)
GETTER(cn_joint_get_speed, JOINT, f.pin, float)
ENTRY(cn_joint_set_motor, cn_joint_set_motor(W, f.pin, 1.0f, 2.0f),
	NOW(cn_joint_set_motor(NULL, f.pin, 1.0f, 2.0f)); JOINT(h, cn_joint_set_motor(W, h, 1.0f, 2.0f));
	FLOAT(x, cn_joint_set_motor(W, f.pin, x, 2.0f)); NOT_NEGATIVE(x, cn_joint_set_motor(W, f.pin, 1.0f, x));)
ENTRY(cn_joint_set_limits, cn_joint_set_limits(W, f.pin, -1.0f, 1.0f),
	NOW(cn_joint_set_limits(NULL, f.pin, -1.0f, 1.0f)); JOINT(h, cn_joint_set_limits(W, h, -1.0f, 1.0f));
	RANGE(x, -3.2f, 1.1f, cn_joint_set_limits(W, f.pin, x, 1.0f)); RANGE(x, -1.1f, 3.2f, cn_joint_set_limits(W, f.pin, -1.0f, x));
	RANGE(x, -0.1f, 2.1f, cn_joint_set_limits(W, f.rope, x, 2.0f)); RANGE(x, -0.1f, 0.9f, cn_joint_set_limits(W, f.rope, 1.0f, x));)

/* ------------------------------------------------------------------ the table and the header */

typedef struct entry {
	const char *name;
	void (*bad)(void);
	cn_result (*good)(void);
} entry;

#define E(name) { #name, bad_##name, good_##name }
static const entry table[] = {
	E(cn_version), E(cn_abi_version), E(cn_result_text), E(cn_sizeof),
	E(cn_world_def_init), E(cn_world_def_check), E(cn_world_bytes_needed), E(cn_world_create), E(cn_world_destroy), E(cn_world_step),
	E(cn_world_error_text), E(cn_world_set_gravity), E(cn_world_get_gravity), E(cn_world_set_substep_count), E(cn_world_get_substep_count),
	E(cn_world_set_flags), E(cn_world_get_flags), E(cn_world_set_restitution_threshold), E(cn_world_set_speed_limits), E(cn_world_set_sleep),
	E(cn_world_set_user_data), E(cn_world_get_user_data), E(cn_world_get_bodies), E(cn_world_get_shapes), E(cn_world_get_joints),
	E(cn_world_get_counters), E(cn_world_get_profile), E(cn_world_get_memory_stats), E(cn_world_hash), E(cn_world_validate),
	E(cn_body_def_init), E(cn_body_create), E(cn_body_create_many), E(cn_body_destroy), E(cn_body_destroy_many), E(cn_body_is_valid),
	E(cn_body_set_type), E(cn_body_get_type), E(cn_body_set_flags), E(cn_body_get_flags), E(cn_body_set_awake), E(cn_body_set_pose),
	E(cn_body_get_pose), E(cn_body_get_angle), E(cn_body_get_center), E(cn_body_set_velocity), E(cn_body_get_velocity),
	E(cn_body_get_velocity_at), E(cn_body_get_world_point), E(cn_body_get_local_point), E(cn_body_get_aabb), E(cn_body_apply_force),
	E(cn_body_apply_force_at), E(cn_body_apply_torque), E(cn_body_apply_impulse), E(cn_body_apply_impulse_at),
	E(cn_body_apply_angular_impulse), E(cn_body_get_mass_data), E(cn_body_set_mass_data), E(cn_body_reset_mass_data),
	E(cn_body_set_damping), E(cn_body_get_damping), E(cn_body_set_gravity_scale), E(cn_body_get_gravity_scale), E(cn_body_set_sleep_speed),
	E(cn_body_set_user_data), E(cn_body_get_user_data), E(cn_body_set_name), E(cn_body_get_name), E(cn_body_get_shapes), E(cn_body_get_joints),
	E(cn_world_read_poses), E(cn_world_read_poses_strided), E(cn_world_read_velocities), E(cn_world_write_velocities), E(cn_world_moved),
	E(cn_shape_def_init), E(cn_shape_create_circle), E(cn_shape_create_capsule), E(cn_shape_create_edge), E(cn_shape_create_polygon),
	E(cn_shape_create_box), E(cn_shape_create_chain), E(cn_shape_attach), E(cn_shape_detach), E(cn_shape_destroy), E(cn_shape_is_valid),
	E(cn_shape_get_type), E(cn_shape_get_body), E(cn_shape_set_material), E(cn_shape_get_material), E(cn_shape_set_density),
	E(cn_shape_get_density), E(cn_shape_set_filter), E(cn_shape_get_filter), E(cn_shape_set_event_mask), E(cn_shape_get_event_mask),
	E(cn_shape_set_user_data), E(cn_shape_get_user_data), E(cn_shape_get_aabb), E(cn_shape_get_mass_data), E(cn_shape_get_circle),
	E(cn_shape_get_capsule), E(cn_shape_get_edge), E(cn_shape_get_polygon), E(cn_shape_get_chain_points), E(cn_shape_test_point),
	E(cn_polygon_make_hull), E(cn_polygon_make_box), E(cn_world_contact_events), E(cn_world_set_contact_callback), E(cn_body_get_contacts),
	E(cn_world_fell_asleep), E(cn_revolute_def_init), E(cn_distance_def_init), E(cn_joint_create_revolute), E(cn_joint_create_distance),
	E(cn_joint_destroy), E(cn_joint_is_valid), E(cn_joint_get_type), E(cn_joint_get_bodies), E(cn_joint_get_anchors),
	E(cn_joint_get_reaction), E(cn_joint_get_error), E(cn_joint_set_user_data), E(cn_joint_get_user_data), E(cn_joint_set_flags),
	E(cn_joint_get_flags), E(cn_joint_get_revolute), E(cn_joint_set_revolute), E(cn_joint_get_distance), E(cn_joint_set_distance),
	E(cn_joint_get_position), E(cn_joint_get_speed), E(cn_joint_set_motor), E(cn_joint_set_limits)
};
#define TABLE_COUNT ((int)(sizeof table / sizeof *table))

/* What the header says about each function of the table. */
typedef struct declared {
	char name[64];
	int changes_world; /* takes a non-const world */
} declared;
static declared functions[512];
static int function_count;

static char *header_read(void)
{
	FILE *file = fopen(CAIRN_HEADER, "rb");
	char *text;
	size_t bytes;
	if (file == NULL)
		return NULL;
	text = malloc(1u << 20);
	bytes = fread(text, 1, (1u << 20) - 1, file);
	text[bytes] = '\0';
	fclose(file);
	return text;
}

/* One declaration, from behind CN_API to its semicolon. */
static void declaration_parse(const char *from, const char *to)
{
	declared *d = &functions[function_count];
	const char *open = memchr(from, '(', (size_t)(to - from)), *begin, *world;
	size_t length;
	if (open == NULL || function_count == 512)
		return;
	for (begin = open; begin > from && (begin[-1] == '_' || (begin[-1] >= 'a' && begin[-1] <= 'z') || (begin[-1] >= '0' && begin[-1] <= '9')); --begin)
		;
	length = (size_t)(open - begin);
	if (length == 0 || length >= sizeof d->name)
		return;
	memcpy(d->name, begin, length);
	d->name[length] = '\0';
	world = strstr(open, "cn_world *world");
	d->changes_world = world != NULL && world < to && strncmp(world - 6, "const ", 6) != 0;
	++function_count;
}

static void header_parse(void)
{
	char *text = header_read();
	const char *p;
	function_count = 0;
	if (text == NULL)
		return;
	for (p = strstr(text, "\nCN_API "); p != NULL; p = strstr(p + 1, "\nCN_API ")) {
		const char *end = strchr(p, ';');
		if (end != NULL)
			declaration_parse(p + 8, end);
	}
	free(text);
}

static int changes_world(const char *name)
{
	int k;
	for (k = 0; k < function_count; ++k)
		if (strcmp(functions[k].name, name) == 0)
			return functions[k].changes_world;
	return 0;
}

static void t_every_function_has_an_entry(void)
{
	int k, j, missing = 0;
	header_parse();
	REQUIRE(function_count > 0);
	for (k = 0; k < function_count; ++k) {
		for (j = 0; j < TABLE_COUNT && strcmp(functions[k].name, table[j].name) != 0; ++j)
			;
		if (j == TABLE_COUNT)
			printf("  no entry for %s\n", functions[k].name);
		missing += j == TABLE_COUNT;
	}
	CHECK_LE("functions without an entry", missing, 0, "");
	CHECK_GE("functions in the header", function_count, 136, "");
	CHECK(function_count == TABLE_COUNT);
}

static void t_bad_arguments_are_refused(void)
{
	int k;
	header_parse();
	fixture_make(0);
	bad_calls = 0;
	for (k = 0; k < TABLE_COUNT; ++k) {
		current = table[k].name;
		current_has_sentence = changes_world(current);
		table[k].bad();
	}
	fixture_free();
	CHECK_GE("bad calls made", bad_calls, 2000, "");
}

static void t_good_calls_succeed(void)
{
	int k, step;
	for (k = 0; k < TABLE_COUNT; ++k) {
		cn_result result;
		fixture_make(0);
		result = table[k].good();
		if (result != CN_OK) {
			printf("  %s gives %d: %s\n", table[k].name, (int)result, cn_world_error_text(W));
			test_fail(__FILE__, __LINE__, "good call failed");
		}
		check_valid(table[k].name);
		for (step = 0; step < 3; ++step) {
			CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
			check_valid(table[k].name);
		}
		fixture_free();
	}
}

/* ------------------------------------------------------------------ locked */

static int locked_calls, locked_callbacks;

static void call_everything(cn_world *world, const cn_contact_event *event, void *user)
{
	int k;
	(void)event;
	(void)user;
	if (locked_callbacks++ > 0)
		return;
	for (k = 0; k < TABLE_COUNT; ++k) {
		state s = state_of(world), after;
		cn_result result;
		if (!changes_world(table[k].name))
			continue;
		result = strcmp(table[k].name, "cn_world_destroy") == 0 ? (cn_world_destroy(world), CN_ERROR_LOCKED) : table[k].good();
		after = state_of(world);
		++locked_calls;
		if (result != CN_ERROR_LOCKED || memcmp(&s, &after, sizeof s) != 0) {
			printf("  %s gives %d\n", table[k].name, (int)result);
			test_fail(__FILE__, __LINE__, "a call inside a callback must be refused and change nothing");
		}
		if (strcmp(table[k].name, "cn_world_destroy") != 0)
			CHECK(strncmp(cn_world_error_text(world), table[k].name, strlen(table[k].name)) == 0);
	}
}

static void t_callbacks_lock_the_world(void)
{
	header_parse();
	fixture_make(0);
	locked_calls = locked_callbacks = 0;
	CHECK(cn_body_set_awake(W, f.box, 1) == CN_OK);
	CHECK(cn_world_set_contact_callback(W, CN_EVENT_STAY, call_everything, NULL) == CN_OK);
	CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	CHECK_GE("callbacks", locked_callbacks, 1, "");
	CHECK_GE("functions called in one", locked_calls, 50, "");
	CHECK(cn_world_set_contact_callback(W, CN_EVENT_STAY, NULL, NULL) == CN_OK);
	CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	check_valid("callbacks");
	fixture_free();
}

/* ------------------------------------------------------------------ memory */

/* Each call with the n-th allocation failing, for every n until it succeeds. */
static void t_running_out_of_memory_changes_nothing(void)
{
	int k, allow, failures = 0;
	for (k = 0; k < TABLE_COUNT; ++k) {
		for (allow = 0; allow < 40; ++allow) {
			state s, after;
			cn_result result;
			fixture_make(1);
			s = state_of(W);
			alloc_allow = allow;
			result = table[k].good();
			alloc_allow = -1;
			after = state_of(W);
			if (result == CN_OK) {
				fixture_free();
				break;
			}
			++failures;
			if (result != CN_ERROR_MEMORY || memcmp(&s, &after, sizeof s) != 0) {
				printf("  %s with allocation %d failing gives %d\n", table[k].name, allow, (int)result);
				test_fail(__FILE__, __LINE__, "a call without memory must fail and change nothing");
			}
			check_valid(table[k].name);
			CHECK(table[k].good() == CN_OK);
			check_valid(table[k].name);
			fixture_free();
		}
		CHECK(allow < 40);
	}
	CHECK_LE("bytes leaked", alloc_live, 0, "B");
	CHECK_GE("failures met", failures, 10, "");
}

/* ------------------------------------------------------------------ bookends */

/* The pairs that the events of all steps so far say are there. */
typedef struct known_pair {
	cn_shape a, b;
	int32_t child_a, child_b;
	uint32_t id;
	int touching;
} known_pair;
static known_pair known[4096];
static int known_count, bookend_errors, bookend_events;

static int known_find(const cn_contact_event *e)
{
	int k;
	for (k = 0; k < known_count; ++k)
		if (known[k].a == e->shape_a && known[k].b == e->shape_b && known[k].child_a == e->child_a && known[k].child_b == e->child_b)
			break;
	return k;
}

static void known_take(const cn_contact_event *e, int32_t kind)
{
	int k = known_find(e), there = k < known_count, good;
	known_pair *p = &known[k];
	++bookend_events;
	if (kind == CN_EVENT_CREATED) {
		good = !there && known_count < 4096;
		if (good) {
			++known_count;
			p->a = e->shape_a;
			p->b = e->shape_b;
			p->child_a = e->child_a;
			p->child_b = e->child_b;
			p->id = e->contact_id;
			p->touching = 0;
		}
	} else {
		good = there && p->id == e->contact_id && p->touching == (kind == CN_EVENT_LEAVE);
		if (good && kind == CN_EVENT_DESTROYED)
			*p = known[--known_count];
		else if (good)
			p->touching = kind == CN_EVENT_ENTER;
	}
	bookend_errors += !good;
}

/* After a step: its events must lead from the pairs known before to the pairs there are now. */
static void bookends_check(void)
{
	static const int32_t order[] = { CN_EVENT_LEAVE, CN_EVENT_DESTROYED, CN_EVENT_CREATED, CN_EVENT_ENTER };
	const cn_contact_event *events;
	cn_counters c;
	int32_t count, i, touching = 0;
	size_t k;
	for (k = 0; k < 4; ++k) {
		CHECK(cn_world_contact_events(W, order[k], &events, &count) == CN_OK);
		for (i = 0; i < count; ++i)
			known_take(&events[i], order[k]);
	}
	for (i = 0; i < known_count; ++i)
		touching += known[i].touching;
	CHECK(cn_world_get_counters(W, &c) == CN_OK);
	bookend_errors += c.contacts != known_count || c.contacts_touching != touching;
}

/* ------------------------------------------------------------------ random lives */

static int events_all; /* every shape reports everything, and keeps doing so */

static cn_result steps(int count)
{
	cn_result result = CN_OK;
	while (count-- > 0 && result == CN_OK) {
		result = cn_world_step(W, 1.0f / 60.0f);
		if (events_all)
			bookends_check();
	}
	return result;
}

/* The fixture's shapes report only some events until here: ask for all, and let their pairs begin anew. */
static void events_begin(void)
{
	cn_shape list[16];
	int32_t count = 0, k;
	CHECK(cn_world_get_shapes(W, list, 16, &count) == CN_OK);
	for (k = 0; k < count; ++k) {
		cn_body body = 0;
		CHECK(cn_shape_set_event_mask(W, list[k], (1u << CN_EVENT_KINDS) - 1u) == CN_OK);
		CHECK(cn_shape_get_body(W, list[k], &body) == CN_OK);
		if (body == 0)
			continue;
		CHECK(cn_shape_detach(W, list[k]) == CN_OK);
		CHECK(cn_shape_attach(W, list[k], body) == CN_OK);
	}
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	known_count = 0;
	{
		const cn_contact_event *events;
		CHECK(cn_world_contact_events(W, CN_EVENT_CREATED, &events, &count) == CN_OK);
		for (k = 0; k < count; ++k)
			known_take(&events[k], CN_EVENT_CREATED);
		CHECK(cn_world_contact_events(W, CN_EVENT_ENTER, &events, &count) == CN_OK);
		for (k = 0; k < count; ++k)
			known_take(&events[k], CN_EVENT_ENTER);
	}
}

static cn_body bodies[32];
static cn_shape shapes[64];
static cn_joint joints[32];

static cn_result random_create(uint32_t r, uint32_t *state_)
{
	int slot = (int)(r >> 8 & 31u);
	reset();
	if (events_all)
		sd.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	switch (r >> 4 & 3u) {
	case 0:
		bd.position_m = v2((float)(r >> 16 & 7u), (float)(r >> 20 & 3u));
		bd.type = r >> 24 & 7u ? CN_BODY_DYNAMIC : (int32_t)(r >> 27 & 1u);
		bd.flags = CN_BODY_ENABLED | CN_BODY_SLEEP | (r >> 28 & 1u ? (uint32_t)CN_BODY_AWAKE : 0u);
		return cn_body_is_valid(W, bodies[slot]) ? CN_OK : cn_body_create(W, &bd, &bodies[slot]);
	case 1:
		sd.body = cn_body_is_valid(W, bodies[slot]) && (r >> 16 & 7u) ? bodies[slot] : 0;
		if (cn_shape_is_valid(W, shapes[r >> 20 & 63u]))
			return cn_shape_destroy(W, shapes[r >> 20 & 63u]);
		if (r >> 30 & 1u)
			return cn_shape_create_circle(W, &sd, &circle, &shapes[r >> 20 & 63u]);
		if (r >> 29 & 1u)
			return cn_shape_create_polygon(W, &sd, &polygon, &shapes[r >> 20 & 63u]);
		return cn_shape_create_chain(W, &sd, &chain, &shapes[r >> 20 & 63u]);
	case 2:
		rd.base.body_a = bodies[slot];
		rd.base.body_b = bodies[random_next(state_) & 31u];
		rd.base.flags = r >> 29 & 1u ? (uint32_t)CN_JOINT_COLLIDE : 0u;
		if (cn_joint_is_valid(W, joints[r >> 20 & 31u]))
			return cn_joint_destroy(W, joints[r >> 20 & 31u]);
		return cn_joint_create_revolute(W, &rd, &joints[r >> 20 & 31u]);
	default:
		return cn_shape_attach(W, shapes[r >> 20 & 63u], bodies[slot]);
	}
}

static cn_result random_change(uint32_t r, uint32_t *state_)
{
	cn_body body = bodies[r >> 8 & 31u];
	cn_shape shape = shapes[r >> 20 & 63u];
	cn_joint joint = joints[r >> 20 & 31u];
	uint32_t more = random_next(state_);
	reset();
	filter.mask = more & 3u;
	switch (r >> 4 & 15u) {
	case 0: return more & 3u ? cn_shape_attach(W, shape, body) : cn_body_destroy(W, body);
	case 1: return cn_body_set_type(W, body, more & 1u ? CN_BODY_DYNAMIC : (int32_t)(more >> 1 & 1u));
	case 2: return steps(1);
	case 3: case 4: return cn_body_set_flags(W, body, (more & 7u ? (uint32_t)CN_BODY_ENABLED : 0u) | (more >> 4 & (CN_BODY_LOCK_X | CN_BODY_LOCK_ROTATION | CN_BODY_SLEEP)));
	case 5: return cn_body_set_awake(W, body, (int32_t)(more & 1u));
	case 6: return cn_body_set_pose(W, body, v2((float)(more & 7u), (float)(more >> 4 & 3u)), (float)(more >> 8 & 3u));
	case 7: return cn_shape_detach(W, shape);
	case 8: return cn_shape_set_filter(W, shape, &filter);
	case 9: return cn_shape_set_material(W, shape, &material);
	case 10: return events_all ? CN_OK : cn_shape_set_event_mask(W, shape, more & 31u);
	case 11: return cn_joint_set_flags(W, joint, more & 15u);
	case 12: return cn_body_set_mass_data(W, body, &mass);
	case 13: return cn_shape_set_density(W, shape, (float)(more & 3u));
	case 14: return more >> 28 ? cn_world_set_gravity(W, v2(0.0f, -8.0f - (float)(more & 3u))) : cn_body_destroy_many(W, three(body, bodies[more & 31u], bodies[more >> 8 & 31u]), 3);
	default: return cn_body_set_name(W, body, more & 1u ? "a name of some length, longer than sixteen" : "short");
	}
}

typedef struct tally {
	int done, refused, without_memory;
	int touching_most, joints_most, islands_most, asleep_most;
} tally;

static int larger(int a, int b) { return a > b ? a : b; }

static void tally_add(tally *t, cn_result result)
{
	cn_counters c;
	CHECK(cn_world_get_counters(W, &c) == CN_OK);
	t->done += result == CN_OK;
	t->without_memory += result == CN_ERROR_MEMORY;
	t->refused += result != CN_OK && result != CN_ERROR_MEMORY;
	t->touching_most = larger(t->touching_most, c.contacts_touching);
	t->joints_most = larger(t->joints_most, c.joints);
	t->islands_most = larger(t->islands_most, c.islands);
	t->asleep_most = larger(t->asleep_most, c.contacts - c.contacts_awake);
}

/* A random life of a world whose allocator may fail now and then. */
static void random_life(uint32_t seed, int operations, uint32_t fail_mask, tally *t)
{
	uint32_t random_state = seed;
	int k;
	memset(bodies, 0, sizeof bodies);
	memset(shapes, 0, sizeof shapes);
	memset(joints, 0, sizeof joints);
	fixture_make(1);
	if (events_all)
		events_begin();
	for (k = 0; k < operations && !test_this_failed; ++k) {
		uint32_t r = random_next(&random_state), kind = r & 15u;
		state s = state_of(W), after;
		cn_result result;
		alloc_random = r;
		alloc_fail_mask = r >> 31 ? fail_mask : 0u;
		result = kind < 2 ? steps(1 + (int)(r >> 4 & 15u)) : kind < 9 ? random_create(r, &random_state) : random_change(r, &random_state);
		alloc_fail_mask = 0;
		if (result != CN_OK) {
			after = state_of(W);
			if (memcmp(&s, &after, sizeof s) != 0) {
				printf("  operation %d (%08x): %s\n", k, r, cn_world_error_text(W));
				test_fail(__FILE__, __LINE__, "a failed call changed the world");
			}
		}
		tally_add(t, result);
		check_valid("a random call");
		if (test_this_failed)
			printf("  seed %u operation %d (%08x) result %d\n", seed, k, r, (int)result);
	}
	fixture_free();
}

static void t_events_are_bookended(void)
{
	uint32_t seed;
	tally t;
	memset(&t, 0, sizeof t);
	events_all = 1;
	bookend_errors = bookend_events = 0;
	for (seed = 1; seed <= 6 && !test_this_failed; ++seed)
		random_life(seed * 40503u + 1u, 1200, 0u, &t);
	events_all = 0;
	CHECK_GE("events seen", bookend_events, 1000, "");
	CHECK_LE("events out of place, or pairs that they do not account for", bookend_errors, 0, "");
}

static void t_random_calls_keep_the_world_valid(void)
{
	uint32_t seed;
	tally t;
	memset(&t, 0, sizeof t);
	for (seed = 1; seed <= 20 && !test_this_failed; ++seed)
		random_life(seed * 2654435761u, 1200, 1u, &t);
	CHECK_GE("calls that succeeded", t.done, 5000, "");
	CHECK_GE("calls refused for their arguments", t.refused, 1000, "");
	CHECK_GE("calls that ran out of memory", t.without_memory, 100, "");
	CHECK_GE("most touching contacts", t.touching_most, 20, "");
	CHECK_GE("most contacts asleep", t.asleep_most, 10, "");
	CHECK_GE("most joints", t.joints_most, 10, "");
	CHECK_GE("most islands", t.islands_most, 10, "");
	CHECK_LE("bytes leaked", alloc_live, 0, "B");
}

/* ------------------------------------------------------------------ reading back */

static void read_back_body(void)
{
	cn_pose pose;
	cn_velocity velocity;
	cn_mass_data got;
	cn_vec2 point, local;
	const char *name = NULL;
	float a = 0.0f, b = 0.0f;
	uint32_t flags = 0;
	uint64_t user = 0;
	CHECK(cn_body_set_mass_data(W, f.box, (reset(), &mass)) == CN_OK);
	CHECK(cn_body_get_mass_data(W, f.box, &got) == CN_OK && memcmp(&got, &mass, sizeof got) == 0);
	CHECK(cn_body_set_pose(W, f.box, v2(7.0f, 3.0f), 0.75f) == CN_OK);
	CHECK(cn_body_get_pose(W, f.box, &pose) == CN_OK);
	CHECK_LE("pose error x", (pose.position_m.x - 7.0f) * (pose.position_m.x - 7.0f), 1e-12, "m2");
	CHECK_LE("pose error y", (pose.position_m.y - 3.0f) * (pose.position_m.y - 3.0f), 1e-12, "m2");
	CHECK(cn_body_get_angle(W, f.box, &a) == CN_OK);
	CHECK_LE("angle error", (a - 0.75f) * (a - 0.75f), 1e-12, "rad2");
	CHECK(cn_body_get_world_point(W, f.box, v2(0.3f, -0.4f), &point) == CN_OK);
	CHECK(cn_body_get_local_point(W, f.box, point, &local) == CN_OK);
	CHECK_LE("local point error", (local.x - 0.3f) * (local.x - 0.3f) + (local.y + 0.4f) * (local.y + 0.4f), 1e-12, "m2");
	CHECK(cn_body_set_velocity(W, f.box, v2(1.0f, 2.0f), 3.0f) == CN_OK);
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK);
	CHECK(velocity.linear_mps.x == 1.0f && velocity.linear_mps.y == 2.0f && velocity.angular_radps == 3.0f);
	CHECK(cn_body_apply_impulse(W, f.box, v2(2.0f, 0.0f)) == CN_OK && cn_body_apply_angular_impulse(W, f.box, 1.0f) == CN_OK);
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK);
	CHECK(velocity.linear_mps.x == 2.0f && velocity.angular_radps == 5.0f); /* 2 kg, 0.5 kg m^2 */
	CHECK(cn_body_set_damping(W, f.box, 0.25f, 0.5f) == CN_OK && cn_body_get_damping(W, f.box, &a, &b) == CN_OK && a == 0.25f && b == 0.5f);
	CHECK(cn_body_set_gravity_scale(W, f.box, 0.5f) == CN_OK && cn_body_get_gravity_scale(W, f.box, &a) == CN_OK && a == 0.5f);
	CHECK(cn_body_set_user_data(W, f.box, 1234567890123u) == CN_OK && cn_body_get_user_data(W, f.box, &user) == CN_OK && user == 1234567890123u);
	CHECK(cn_body_set_name(W, f.box, "crate") == CN_OK && cn_body_get_name(W, f.box, &name) == CN_OK && strcmp(name, "crate") == 0);
	CHECK(cn_body_set_name(W, f.box, NULL) == CN_OK && cn_body_get_name(W, f.box, &name) == CN_OK && strcmp(name, "") == 0);
	CHECK(cn_body_set_flags(W, f.box, CN_BODY_LOCK_X | CN_BODY_ENABLED) == CN_OK && cn_body_get_flags(W, f.box, &flags) == CN_OK);
	CHECK(flags == (CN_BODY_LOCK_X | CN_BODY_ENABLED | CN_BODY_AWAKE));
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK && velocity.linear_mps.x == 0.0f && velocity.linear_mps.y == 2.0f);
	CHECK(cn_body_reset_mass_data(W, f.box) == CN_OK && cn_body_get_mass_data(W, f.box, &got) == CN_OK);
	CHECK_LE("mass of a unit square", (got.mass_kg - 1.0f) * (got.mass_kg - 1.0f), 1e-12, "kg2");
	CHECK_LE("its inertia", (got.inertia_kgm2 - 1.0f / 6.0f) * (got.inertia_kgm2 - 1.0f / 6.0f), 1e-12, "");
}

static void read_back_shape(void)
{
	cn_material m;
	cn_filter g;
	cn_circle c;
	cn_polygon p;
	cn_vec2 points[8];
	cn_mass_data d;
	float density = 0.0f;
	uint32_t mask = 0;
	int32_t count = 0, inside = 0;
	cn_body body = 1;
	reset();
	CHECK(cn_shape_set_material(W, f.box_shape, &material) == CN_OK && cn_shape_get_material(W, f.box_shape, &m) == CN_OK && memcmp(&m, &material, sizeof m) == 0);
	CHECK(cn_shape_set_filter(W, f.box_shape, &filter) == CN_OK && cn_shape_get_filter(W, f.box_shape, &g) == CN_OK && memcmp(&g, &filter, sizeof g) == 0);
	CHECK(cn_shape_set_density(W, f.box_shape, 3.0f) == CN_OK && cn_shape_get_density(W, f.box_shape, &density) == CN_OK && density == 3.0f);
	CHECK(cn_body_get_mass_data(W, f.box, &d) == CN_OK);
	CHECK_LE("mass after a change of density", (d.mass_kg - 3.0f) * (d.mass_kg - 3.0f), 1e-11, "kg2");
	CHECK(cn_shape_set_event_mask(W, f.box_shape, 5) == CN_OK && cn_shape_get_event_mask(W, f.box_shape, &mask) == CN_OK && mask == 5);
	CHECK(cn_shape_get_circle(W, f.ball_shape, &c) == CN_OK && memcmp(&c, &circle, sizeof c) == 0);
	CHECK(cn_shape_get_polygon(W, f.box_shape, &p) == CN_OK && memcmp(&p, &polygon, sizeof p) == 0);
	CHECK(cn_shape_get_chain_points(W, f.chain, points, 8, &count) == CN_OK && count == 4 && memcmp(points, chain_points, sizeof chain_points) == 0);
	CHECK(cn_shape_get_body(W, f.loose, &body) == CN_OK && body == 0);
	CHECK(cn_shape_attach(W, f.loose, f.pill) == CN_OK && cn_shape_get_body(W, f.loose, &body) == CN_OK && body == f.pill);
	CHECK(cn_body_get_shapes(W, f.pill, NULL, 0, &count) == CN_OK && count == 2);
	CHECK(cn_body_set_pose(W, f.box, v2(50.0f, 60.0f), 0.0f) == CN_OK);
	CHECK(cn_shape_test_point(W, f.box_shape, v2(50.4f, 60.4f), &inside) == CN_OK && inside == 1);
	CHECK(cn_shape_test_point(W, f.box_shape, v2(50.6f, 60.4f), &inside) == CN_OK && inside == 0);
}

static void read_back_joint(void)
{
	cn_revolute_def r;
	cn_distance_def d;
	cn_body a = 1, b = 1;
	reset();
	rd.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR;
	rd.lower_angle_rad = -1.0f;
	rd.upper_angle_rad = 2.0f;
	rd.motor_speed_radps = 3.0f;
	rd.motor_torque_max_Nm = 4.0f;
	rd.spring_hertz = 5.0f;
	rd.spring_damping_ratio = 0.5f;
	rd.spring_target_rad = 0.25f;
	rd.base.user_data = 99;
	CHECK(cn_joint_set_revolute(W, f.pin, &rd) == CN_OK && cn_joint_get_revolute(W, f.pin, &r) == CN_OK);
	CHECK(r.base.body_a == f.ball && r.base.body_b == f.pill && r.base.anchor_a_m.x == 1.0f);
	rd.base = r.base;
	CHECK(memcmp(&r, &rd, sizeof r) == 0);
	CHECK(r.base.flags == (CN_JOINT_LIMIT | CN_JOINT_MOTOR) && r.base.user_data == 99);
	CHECK(cn_joint_set_motor(W, f.pin, -1.0f, 7.0f) == CN_OK && cn_joint_set_limits(W, f.pin, -0.5f, 0.5f) == CN_OK);
	CHECK(cn_joint_get_revolute(W, f.pin, &r) == CN_OK && r.motor_speed_radps == -1.0f && r.motor_torque_max_Nm == 7.0f);
	CHECK(r.lower_angle_rad == -0.5f && r.upper_angle_rad == 0.5f);
	CHECK(cn_joint_get_distance(W, f.rope, &d) == CN_OK && d.length_m == 2.0f && d.length_max_m == 1.0f);
	CHECK(cn_joint_get_bodies(W, f.rope, &a, &b) == CN_OK && a == 0 && b == f.ball);
}

static void t_what_is_set_is_read_back(void)
{
	fixture_make(0);
	read_back_body();
	read_back_shape();
	read_back_joint();
	check_valid("setters");
	fixture_free();
}

/* A bulk read of all bodies, the bodies moved and the poses one by one tell the same. */
static void t_moved_lists_what_moved(void)
{
	const cn_body_moved *moved = NULL;
	const cn_body *asleep = NULL;
	cn_pose now[5], one;
	cn_body list[5];
	int32_t count = 0, k, steps_taken, fell = 0;
	fixture_make(0);
	CHECK(cn_body_set_velocity(W, f.rail, v2(1.0f, 0.0f), 0.0f) == CN_OK);
	CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	CHECK_GE("moved", count, 3, ""); /* rail, ball, capsule */
	for (k = 0; k < count; ++k) {
		CHECK(cn_body_get_pose(W, moved[k].body, &one) == CN_OK && memcmp(&one, &moved[k].pose, sizeof one) == 0);
		CHECK(moved[k].body != f.ground);
	}
	CHECK(cn_world_get_bodies(W, list, 5, &count) == CN_OK && count == 5);
	CHECK(cn_world_read_poses(W, NULL, 5, now) == CN_OK);
	for (k = 0; k < 5; ++k)
		CHECK(cn_body_get_pose(W, list[k], &one) == CN_OK && memcmp(&one, &now[k], sizeof one) == 0);
	CHECK(cn_body_destroy(W, f.rail) == CN_OK);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	for (k = 0; k < count; ++k)
		CHECK(moved[k].body != f.rail);
	for (steps_taken = 0; steps_taken < 600 && fell == 0; ++steps_taken) {
		CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
		CHECK(cn_world_fell_asleep(W, &asleep, &fell) == CN_OK);
	}
	CHECK_LE("steps until something fell asleep", steps_taken, 120, "");
	REQUIRE(fell > 0);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	CHECK(count >= fell && moved[0].body == asleep[0] && moved[0].fell_asleep == 1);
	fixture_free();
}

/* ------------------------------------------------------------------ numbers in sentences */

static void text_of(char *out, int32_t bytes, float x)
{
	cni_text text = cni_text_begin(out, bytes);
	cni_text_float(&text, x);
}

static void t_sentences_print_numbers(void)
{
	static const float exact[] = { 1.0f, -1.0f, 0.5f, 100.0f, 1e6f, 123456.0f, 0.1f, 0.001f, 3.14159265f, 1e9f, 1.5e-5f };
	static const char *const texts[] = { "1", "-1", "0.5", "100", "1000000", "123456", "0.1", "0.001", "3.14159", "1e9", "1.5e-5" };
	char out[64];
	uint32_t state_ = 99u;
	double worst = 0.0;
	int k;
	for (k = 0; k < (int)(sizeof exact / sizeof *exact); ++k) {
		text_of(out, 64, exact[k]);
		if (strcmp(out, texts[k]) != 0) {
			printf("  %s instead of %s\n", out, texts[k]);
			test_fail(__FILE__, __LINE__, "number in a sentence");
		}
	}
	for (k = 0; k < 200000; ++k) {
		uint32_t bits = random_next(&state_);
		float x;
		double read, error;
		memcpy(&x, &bits, sizeof x);
		if (!(x - x == 0.0f) || x == 0.0f)
			continue;
		text_of(out, 64, x);
		read = strtod(out, NULL);
		error = (read - (double)x) / (double)x;
		error = error < 0.0 ? -error : error;
		worst = error > worst ? error : worst;
	}
	CHECK_LE("relative error of six digits", worst, 5.0001e-6, "");
	text_of(out, 64, number(0));
	CHECK(strcmp(out, "nan") == 0);
	text_of(out, 64, number(2));
	CHECK(strcmp(out, "-inf") == 0);
	text_of(out, 4, 123456.0f);
	CHECK(strcmp(out, "123") == 0);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_every_function_has_an_entry);
	RUN(t_sentences_print_numbers);
	RUN(t_good_calls_succeed);
	RUN(t_bad_arguments_are_refused);
	RUN(t_callbacks_lock_the_world);
	RUN(t_running_out_of_memory_changes_nothing);
	RUN(t_what_is_set_is_read_back);
	RUN(t_moved_lists_what_moved);
	RUN(t_events_are_bookended);
	RUN(t_random_calls_keep_the_world_valid);
	return test_end();
}
