/*
 * arguments_test - promise: every public function refuses every bad argument with the right code and a
 * sentence that names it, and a call that fails changes nothing.
 *
 * The list of functions is read from include/cairn.h at run time, so a new function without an entry here
 * fails the test. Each entry has a good call and a list of bad ones. The good calls are used to show
 * that the entry's other arguments are fine, that inside a callback everything is refused, and that a
 * call which runs out of memory changes nothing either.
 */
#include "calls.h"

#ifndef CAIRN_HEADER
#define CAIRN_HEADER "include/cairn.h"
#endif

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
static void *test_enqueue(cn_task_fn *task, void *context, int32_t item_count, int32_t min_range, void *user)
{
	(void)min_range, (void)user;
	task(0, item_count, context);
	return NULL;
}
static void test_finish(void *task, void *user) { (void)task, (void)user; }
static void *some_pointer(int offset) { static uint64_t block[64]; return (unsigned char *)block + offset; }

static void bad_world_defs(cn_result (*call)(const cn_world_def *))
{
	ARG(call(NULL));
	SIZES(x, call(WD(struct_size, x)));
	FLAGS(x, 4, call(WD(flags, x)));
	VECTOR(v, call(WD(gravity_mps2, v)));
	POSITIVE(x, call(WD(length_unit_m, x)));
	ARG(call(WD(length_unit_m, 1.1e6f)));
	INTEGER(x, -1, 4, call(WD(solver, x)));
	INTEGER(x, -1, 2, call(WD(broadphase, x)));
	INTEGER(x, 0, 65, call(WD(substep_count, x)));
	NOT_NEGATIVE(x, call(WD(accuracy_m, x)));
	INTEGER(x, -1, 1000000001, call(WD(work_budget, x)));
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
	INTEGER(x, -1, CN_WORKERS_MAX + 1, call(WD(worker_count, x)));
	ARG(call(WD(enqueue, test_enqueue)));
	ARG(call(WD(finish, test_finish)));
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
ENTRY(cn_world_set_gravity, cn_world_set_gravity(W, 1.0f, -9.0f),
	NOW(cn_world_set_gravity(NULL, 1.0f, 1.0f)); VECTOR(v, cn_world_set_gravity(W, v.x, v.y));)
WORLD_GETTER(cn_world_get_gravity, cn_vec2)
ENTRY(cn_world_set_substep_count, cn_world_set_substep_count(W, 8),
	NOW(cn_world_set_substep_count(NULL, 8)); INTEGER(x, 0, 65, cn_world_set_substep_count(W, x));)
WORLD_GETTER(cn_world_get_substep_count, int32_t)
ENTRY(cn_world_set_solver, cn_world_set_solver(W, CN_SOLVER_DIRECT),
	NOW(cn_world_set_solver(NULL, 0)); INTEGER(x, -1, 4, cn_world_set_solver(W, x));)
WORLD_GETTER(cn_world_get_solver, int32_t)
ENTRY(cn_world_set_accuracy, cn_world_set_accuracy(W, 0.001f, 500),
	NOW(cn_world_set_accuracy(NULL, 0.001f, 500)); NOT_NEGATIVE(x, cn_world_set_accuracy(W, x, 500)); INTEGER(x, -1, 1000000001, cn_world_set_accuracy(W, 0.001f, x));)
ENTRY(cn_world_get_accuracy, cn_world_get_accuracy(W, OUT(float), INT + 8),
	NOW(cn_world_get_accuracy(NULL, OUT(float), INT + 8)); ARG(cn_world_get_accuracy(W, NULL, INT)); ARG(cn_world_get_accuracy(W, OUT(float), NULL));)
ENTRY(cn_world_set_flags, cn_world_set_flags(W, CN_WORLD_PROFILE),
	NOW(cn_world_set_flags(NULL, 0)); FLAGS(x, 4, cn_world_set_flags(W, x));)
WORLD_GETTER(cn_world_get_flags, uint32_t)
WORLD_GETTER(cn_world_get_worker_count, int32_t)
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
WORLD_LIST(cn_world_get_islands, cn_island_report)
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
	INTEGER(x, -1, 3, call(BD(solver, x)));
	ARG(call(BD(name, too_long())));
}

ENTRY(cn_body_def_init, (cn_body_def_init(&bd), CN_OK), cn_body_def_init(NULL);)
ENTRY(cn_body_create, cn_body_create(W, (reset(), &bd), OUT(cn_body)),
	bad_body_defs(call_body_create); NOW(cn_body_create(NULL, (reset(), &bd), OUT(cn_body))); ARG(cn_body_create(W, (reset(), &bd), NULL));)
ENTRY(cn_body_create_many, cn_body_create_many(W, spoiled_last((reset(), &bd)), 3, OUT(cn_body)),
	bad_body_defs(call_body_create_many); NOW(cn_body_create_many(NULL, many, 3, OUT(cn_body)));
	ARG(cn_body_create_many(W, spoiled_last((reset(), &bd)), -1, OUT(cn_body))); ARG(cn_body_create_many(W, many, 3, NULL));)
ENTRY(cn_body_destroy, cn_body_destroy(W, f.box), NOW(cn_body_destroy(NULL, f.box)); BODY(h, cn_body_destroy(W, h));)

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
ENTRY(cn_body_set_pose, cn_body_set_pose(W, f.box, 1.0f, 3.0f, 0.5f),
	NOW(cn_body_set_pose(NULL, f.box, 1.0f, 3.0f, 0.5f)); BODY(h, cn_body_set_pose(W, h, 1.0f, 3.0f, 0.5f));
	POSITION(v, cn_body_set_pose(W, f.box, v.x, v.y, 0.5f)); ANGLE(x, cn_body_set_pose(W, f.box, 0.0f, 0.0f, x));)
GETTER(cn_body_get_pose, BODY, f.box, cn_pose)
GETTER(cn_body_get_angle, BODY, f.box, float)
GETTER(cn_body_get_center, BODY, f.box, cn_vec2)
ENTRY(cn_body_set_velocity, cn_body_set_velocity(W, f.box, 1.0f, 0.0f, 1.0f),
	NOW(cn_body_set_velocity(NULL, f.box, 1.0f, 0.0f, 1.0f)); BODY(h, cn_body_set_velocity(W, h, 1.0f, 0.0f, 1.0f));
	VECTOR(v, cn_body_set_velocity(W, f.box, v.x, v.y, 1.0f)); FLOAT(x, cn_body_set_velocity(W, f.box, 1.0f, 0.0f, x));
	STATE(cn_body_set_velocity(W, f.ground, 0.0f, 0.0f, 0.0f));)
GETTER(cn_body_get_velocity, BODY, f.box, cn_velocity)
#define POINT_GETTER(name) ENTRY(name, name(W, f.box, 1.0f, 2.0f, OUT(cn_vec2)), NOW(name(NULL, f.box, 1.0f, 2.0f, OUT(cn_vec2))); \
	BODY(h, name(W, h, 1.0f, 2.0f, OUT(cn_vec2))); VECTOR(v, name(W, f.box, v.x, v.y, OUT(cn_vec2))); ARG(name(W, f.box, 1.0f, 2.0f, NULL));)
POINT_GETTER(cn_body_get_velocity_at)
POINT_GETTER(cn_body_get_world_point)
POINT_GETTER(cn_body_get_local_point)
GETTER(cn_body_get_aabb, BODY, f.box, cn_aabb)
#define PUSH_VECTOR(name, huge) ENTRY(name, name(W, f.box, 1.0f, 2.0f), NOW(name(NULL, f.box, 1.0f, 2.0f)); \
	BODY(h, name(W, h, 1.0f, 2.0f)); VECTOR(v, name(W, f.box, v.x, v.y)); huge)
#define PUSH_AT(name) ENTRY(name, name(W, f.box, 1.0f, 2.0f, 0.0f, 1.0f), NOW(name(NULL, f.box, 1.0f, 2.0f, 0.0f, 1.0f)); \
	BODY(h, name(W, h, 1.0f, 2.0f, 0.0f, 1.0f)); VECTOR(v, name(W, f.box, v.x, v.y, 0.0f, 1.0f)); \
	VECTOR(v, name(W, f.box, 1.0f, 2.0f, v.x, v.y)); ARG(name(W, f.box, 3e38f, 0.0f, 1.0f, 3e38f));)
#define PUSH_FLOAT(name) ENTRY(name, name(W, f.box, 2.0f), NOW(name(NULL, f.box, 2.0f)); BODY(h, name(W, h, 2.0f)); FLOAT(x, name(W, f.box, x));)
PUSH_VECTOR(cn_body_apply_force, CHECK(cn_body_apply_force(W, f.box, 3e38f, 0.0f) == CN_OK); ARG(cn_body_apply_force(W, f.box, 3e38f, 0.0f));
	CHECK(cn_body_apply_force(W, f.box, -3e38f, 0.0f) == CN_OK);)
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
ENTRY(cn_body_set_solver, cn_body_set_solver(W, f.box, CN_SOLVER_DIRECT),
	NOW(cn_body_set_solver(NULL, f.box, 0)); BODY(h, cn_body_set_solver(W, h, 0)); INTEGER(x, -1, 3, cn_body_set_solver(W, f.box, x));)
GETTER(cn_body_get_solver, BODY, f.box, int32_t)
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
ENTRY(cn_shape_test_point, cn_shape_test_point(W, f.box_shape, 0.0f, 0.0f, INT),
	NOW(cn_shape_test_point(NULL, f.box_shape, 0.0f, 0.0f, INT)); SHAPE(h, cn_shape_test_point(W, h, 0.0f, 0.0f, INT));
	VECTOR(v, cn_shape_test_point(W, f.box_shape, v.x, v.y, INT)); ARG(cn_shape_test_point(W, f.box_shape, 0.0f, 0.0f, NULL));)

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
ENTRY(cn_polygon_make_box, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)),
	POSITIVE(x, cn_polygon_make_box(x, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)));
	POSITIVE(x, cn_polygon_make_box(1.0f, x, 3.0f, 4.0f, 0.5f, 0.1f, OUT(cn_polygon)));
	POSITION(v, cn_polygon_make_box(1.0f, 2.0f, v.x, v.y, 0.5f, 0.1f, OUT(cn_polygon)));
	ANGLE(x, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, x, 0.1f, OUT(cn_polygon)));
	NOT_NEGATIVE(x, cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, x, OUT(cn_polygon)));
	ARG(cn_polygon_make_box(1.0f, 2.0f, 3.0f, 4.0f, 0.5f, 0.1f, NULL));)

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
	FLAGS(x, 5, call(RD(base.flags, x)));
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
	FLAGS(x, 5, call(DD(base.flags, x)));
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
ENTRY(cn_joint_set_solver, cn_joint_set_solver(W, f.pin, CN_SOLVER_SOFT),
	NOW(cn_joint_set_solver(NULL, f.pin, 0)); JOINT(h, cn_joint_set_solver(W, h, 0)); INTEGER(x, -1, 3, cn_joint_set_solver(W, f.pin, x));)
GETTER(cn_joint_get_solver, JOINT, f.pin, int32_t)
ENTRY(cn_joint_set_user_data, cn_joint_set_user_data(W, f.pin, 3), NOW(cn_joint_set_user_data(NULL, f.pin, 3)); JOINT(h, cn_joint_set_user_data(W, h, 3));)
GETTER(cn_joint_get_user_data, JOINT, f.pin, uint64_t)
ENTRY(cn_joint_set_flags, cn_joint_set_flags(W, f.pin, CN_JOINT_MOTOR | CN_JOINT_COLLIDE),
	NOW(cn_joint_set_flags(NULL, f.pin, 0)); JOINT(h, cn_joint_set_flags(W, h, 0)); FLAGS(x, 5, cn_joint_set_flags(W, f.pin, x));)
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

/* ------------------------------------------------------------------ trees */

static cn_tree *tree;
static uint32_t tree_item, tree_stale;
static cn_aabb tree_box;
static cn_ray tree_ray;

/* A tree with one item, and the name of one that is gone. */
static int tree_make(void)
{
	tree_box.lower_m = v2(-1.0f, 0.0f);
	tree_box.upper_m = v2(1.0f, 2.0f);
	tree_ray.origin_m = v2(-5.0f, 1.0f);
	tree_ray.translation_m = v2(10.0f, 0.0f);
	CHECK(cn_tree_create(0.1f, NULL, NULL, NULL, &tree) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 1, &tree_stale) == CN_OK && cn_tree_remove(tree, tree_stale) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 2, &tree_item) == CN_OK);
	return 0;
}

static cn_result tree_end(cn_result result)
{
	cn_tree_destroy(tree);
	tree = NULL;
	return result;
}

static int32_t tree_visit(uint32_t item, uint64_t user_data, void *user) { return item != 0 && user_data == 2 && user == NULL; }
static float tree_hit(uint32_t item, uint64_t user_data, float fraction, void *user) { return item != 0 && user_data == 2 && user == NULL ? fraction : 0.0f; }

#define TREE(call) (tree_make(), tree_end(call))
#define TREE_BOXES(call) do { const cn_aabb *b_ = NULL; ARG(call(b_)); b_ = &tree_box; \
	VECTOR(v, (tree_box.lower_m = v, call(b_))); tree_box.lower_m = v2(-1.0f, 0.0f); VECTOR(v, (tree_box.upper_m = v, call(b_))); \
	tree_box.upper_m = v2(-1.5f, 2.0f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, -0.5f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, 2.0f); } while (0)
#define TREE_ITEMS(h, call) do { uint32_t h = 0; BAD(CN_ERROR_HANDLE, call); h = tree_stale; BAD(CN_ERROR_HANDLE, call); \
	h = tree_item + 1; BAD(CN_ERROR_HANDLE, call); h = 0xFFFFFFFFu; BAD(CN_ERROR_HANDLE, call); } while (0)

ENTRY(cn_tree_create, TREE(CN_OK), NOT_NEGATIVE(x, cn_tree_create(x, NULL, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, NULL, NULL, NULL));
	ARG(cn_tree_create(0.1f, test_alloc, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, test_free, NULL, OUT(cn_tree *)));)
ENTRY(cn_tree_destroy, TREE(CN_OK), cn_tree_destroy(NULL);)
#define INSERT_BOX(b) cn_tree_insert(tree, b, 0, OUT(uint32_t))
ENTRY(cn_tree_insert, TREE(cn_tree_insert(tree, &tree_box, 3, &tree_item)),
	tree_make(); TREE_BOXES(INSERT_BOX); NOW(cn_tree_insert(NULL, &tree_box, 0, OUT(uint32_t))); ARG(cn_tree_insert(tree, &tree_box, 0, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_remove, TREE(cn_tree_remove(tree, tree_item)),
	tree_make(); TREE_ITEMS(h, cn_tree_remove(tree, h)); NOW(cn_tree_remove(NULL, tree_item)); tree_end(CN_OK);)
#define MOVE_BOX(b) cn_tree_move(tree, tree_item, b)
ENTRY(cn_tree_move, TREE(cn_tree_move(tree, tree_item, &tree_box)),
	tree_make(); TREE_BOXES(MOVE_BOX); TREE_ITEMS(h, cn_tree_move(tree, h, &tree_box)); NOW(cn_tree_move(NULL, tree_item, &tree_box)); tree_end(CN_OK);)
ENTRY(cn_tree_get_box, TREE(cn_tree_get_box(tree, tree_item, OUT(cn_aabb))),
	tree_make(); TREE_ITEMS(h, cn_tree_get_box(tree, h, OUT(cn_aabb))); NOW(cn_tree_get_box(NULL, tree_item, OUT(cn_aabb)));
	ARG(cn_tree_get_box(tree, tree_item, NULL)); tree_end(CN_OK);)
#define QUERY_BOX(b) cn_tree_query(tree, b, tree_visit, NULL)
ENTRY(cn_tree_query, TREE(cn_tree_query(tree, &tree_box, tree_visit, NULL)),
	tree_make(); TREE_BOXES(QUERY_BOX); NOW(cn_tree_query(NULL, &tree_box, tree_visit, NULL)); ARG(cn_tree_query(tree, &tree_box, NULL, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_cast_ray, TREE(cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)),
	tree_make(); NOW(cn_tree_cast_ray(NULL, &tree_ray, tree_hit, NULL)); ARG(cn_tree_cast_ray(tree, NULL, tree_hit, NULL));
	ARG(cn_tree_cast_ray(tree, &tree_ray, NULL, NULL)); VECTOR(v, (tree_ray.origin_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)));
	tree_ray.origin_m = v2(0.0f, 0.0f); VECTOR(v, (tree_ray.translation_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL))); tree_end(CN_OK);)
ENTRY(cn_tree_get_stats, TREE(cn_tree_get_stats(tree, INT, INT)),
	tree_make(); NOW(cn_tree_get_stats(NULL, INT, INT)); ARG(cn_tree_get_stats(tree, NULL, INT)); ARG(cn_tree_get_stats(tree, INT, NULL)); tree_end(CN_OK);)

/* ------------------------------------------------------------------ the table and the header */

/* ---- callbacks, sensors, shape flags, variable time, drawing */

static int32_t any_filter(cn_world *world, cn_shape a, cn_shape b, void *user) { (void)world; (void)a; (void)b; (void)user; return 1; }
static int32_t any_pre_solve(cn_world *world, const cn_contact_event *e, void *user) { (void)world; (void)e; (void)user; return 1; }
static void any_mix(cn_world *world, cn_shape a, cn_shape b, cn_material *m, void *user) { (void)world; (void)a; (void)b; (void)m; (void)user; }

ENTRY(cn_world_set_filter_callback, cn_world_set_filter_callback(W, any_filter, NULL),
	NOW(cn_world_set_filter_callback(NULL, any_filter, NULL)); CHECK(cn_world_set_filter_callback(W, NULL, NULL) == CN_OK);)
ENTRY(cn_world_set_pre_solve_callback, cn_world_set_pre_solve_callback(W, any_pre_solve, NULL),
	NOW(cn_world_set_pre_solve_callback(NULL, any_pre_solve, NULL)); CHECK(cn_world_set_pre_solve_callback(W, NULL, NULL) == CN_OK);)
ENTRY(cn_world_set_material_mix_callback, cn_world_set_material_mix_callback(W, any_mix, NULL),
	NOW(cn_world_set_material_mix_callback(NULL, any_mix, NULL)); CHECK(cn_world_set_material_mix_callback(W, NULL, NULL) == CN_OK);)
static const cn_sensor_event *sensor_events;
ENTRY(cn_world_sensor_events, cn_world_sensor_events(W, &sensor_events, INT),
	NOW(cn_world_sensor_events(NULL, &sensor_events, INT)); ARG(cn_world_sensor_events(W, NULL, INT)); ARG(cn_world_sensor_events(W, &sensor_events, NULL));)
ENTRY(cn_shape_set_flags, cn_shape_set_flags(W, f.box_shape, CN_SHAPE_ONE_WAY),
	NOW(cn_shape_set_flags(NULL, f.box_shape, 0)); SHAPE(h, cn_shape_set_flags(W, h, 0)); FLAGS(x, 4, cn_shape_set_flags(W, f.box_shape, x));)
GETTER(cn_shape_get_flags, SHAPE, f.box_shape, uint32_t)
ENTRY(cn_world_set_fixed_step, cn_world_set_fixed_step(W, 0.01f, 4),
	NOW(cn_world_set_fixed_step(NULL, 0.01f, 4)); POSITIVE(x, cn_world_set_fixed_step(W, x, 4)); ARG(cn_world_set_fixed_step(W, 1.01f, 4));
	INTEGER(x, 0, 1001, cn_world_set_fixed_step(W, 0.01f, x));)
ENTRY(cn_world_update, cn_world_update(W, 0.02f, (cn_update_report *)OUT(cn_update_report)),
	NOW(cn_world_update(NULL, 0.02f, NULL)); RANGE(x, -0.01f, 10.1f, cn_world_update(W, x, NULL));)
ENTRY(cn_world_read_poses_interpolated, cn_world_read_poses_interpolated(W, three(f.box, f.ball, f.pill), 3, 0.5f, OUT(cn_pose)),
	NOW(cn_world_read_poses_interpolated(NULL, three(f.box, f.ball, f.pill), 3, 0.5f, OUT(cn_pose)));
	RANGE(x, -0.01f, 1.01f, cn_world_read_poses_interpolated(W, three(f.box, f.ball, f.pill), 3, x, OUT(cn_pose)));
	BODY(h, cn_world_read_poses_interpolated(W, three(f.box, h, f.pill), 3, 0.5f, OUT(cn_pose)));
	ARG(cn_world_read_poses_interpolated(W, three(f.box, f.ball, f.pill), 3, 0.5f, NULL));
	ARG(cn_world_read_poses_interpolated(W, three(f.box, f.ball, f.pill), -1, 0.5f, OUT(cn_pose)));
	ARG(cn_world_read_poses_interpolated(W, NULL, 1, 0.5f, OUT(cn_pose)));)
static cn_debug_draw draw_functions;
static cn_debug_draw *draw_with(uint32_t size, uint32_t flags, cn_vec2 lower)
{
	cn_debug_draw_init(&draw_functions);
	draw_functions.struct_size = size;
	draw_functions.flags = flags;
	draw_functions.view.lower_m = lower;
	return &draw_functions;
}
#define DRAW_SIZE ((uint32_t)sizeof(cn_debug_draw))
ENTRY(cn_debug_draw_init, (cn_debug_draw_init(&draw_functions), CN_OK), cn_debug_draw_init(NULL);)
ENTRY(cn_world_draw, cn_world_draw(W, draw_with(DRAW_SIZE, 0, v2(0.0f, 0.0f))),
	NOW(cn_world_draw(NULL, draw_with(DRAW_SIZE, 0, v2(0.0f, 0.0f)))); ARG(cn_world_draw(W, NULL));
	SIZES(x, cn_world_draw(W, draw_with(x, 0, v2(0.0f, 0.0f)))); FLAGS(x, 6, cn_world_draw(W, draw_with(DRAW_SIZE, x, v2(0.0f, 0.0f))));
	VECTOR(v, cn_world_draw(W, draw_with(DRAW_SIZE, 0, v)));)

/* ---- queries */

static cn_ray ray;
static cn_ray_hit hit_list[2];
static cn_query_filter query_filter;
static cn_explosion_def blast;
static cn_aabb region_box;

static int reset_queries(void)
{
	reset();
	ray.origin_m = v2(-3.0f, 0.5f);
	ray.translation_m = v2(6.0f, 0.0f);
	cn_query_filter_init(&query_filter);
	cn_explosion_def_init(&blast);
	blast.center_m = v2(0.2f, 0.0f);
	blast.radius_m = 100.0f;
	blast.impulse_Nspm = 1.0f;
	region_box.lower_m = v2(-1.0f, -1.0f);
	region_box.upper_m = v2(1.0f, 1.0f);
	return 0;
}
static const cn_ray *good_ray(void) { reset_queries(); return &ray; }
static const cn_ray *ray_from(cn_vec2 v) { reset_queries(); ray.origin_m = v; return &ray; }
static const cn_ray *ray_along(cn_vec2 v) { reset_queries(); ray.translation_m = v; return &ray; }
/* The second of two is bad. */
static const cn_ray *ray_pair(cn_vec2 v) { static cn_ray two[2]; two[0] = *good_ray(); two[1] = *ray_along(v); return two; }
static const cn_polygon *region_points(int32_t count, float radius, cn_vec2 first)
{
	reset_queries();
	polygon.count = count;
	polygon.radius_m = radius;
	polygon.points_m[0] = first;
	return &polygon;
}
static const cn_aabb *region_from(cn_vec2 v) { reset_queries(); region_box.lower_m = v; return &region_box; }
static const cn_aabb *region_to(cn_vec2 v) { reset_queries(); region_box.upper_m = v; return &region_box; }

#define RAYS(call) do { ARG(call(NULL)); POSITION(v, call(ray_from(v))); VECTOR(v, call(ray_along(v))); ARG(call(ray_along(v2(2.1e6f, 0.0f)))); } while (0)
/* Polygons of one or two points need a radius. */
#define REGIONS(call) do { cn_vec2 o_ = v2(-0.5f, -0.5f); ARG(call(NULL)); INTEGER(x, 0, 17, call(region_points(x, 0.1f, o_))); \
	NOT_NEGATIVE(x, call(region_points(4, x, o_))); ARG(call(region_points(4, 1.1e6f, o_))); \
	{ int32_t n_; for (n_ = 1; n_ < 3; ++n_) POSITIVE(x, call(region_points(n_, x, o_))); } \
	POSITION(v, call(region_points(4, 0.0f, v))); ARG(call(region_points(4, 0.0f, v2(0.4f, 0.4f)))); ARG(call(region_points(2, 0.1f, v2(0.5f, -0.5f)))); } while (0)
#define OUTPUT_LIST(name, region) \
	NOW(name(NULL, region, NULL, OUT(cn_shape) + 4, 8, INT)); ARG(name(W, region, NULL, NULL, 1, INT)); \
	ARG(name(W, region, NULL, OUT(cn_shape) + 4, -1, INT)); ARG(name(W, region, NULL, OUT(cn_shape) + 4, 8, NULL));

ENTRY(cn_query_filter_init, (cn_query_filter_init(&query_filter), CN_OK), cn_query_filter_init(NULL);)
ENTRY(cn_explosion_def_init, (cn_explosion_def_init(&blast), CN_OK), cn_explosion_def_init(NULL);)
#define CAST_RAY(r) cn_world_cast_ray(W, r, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_ray, cn_world_cast_ray(W, good_ray(), &query_filter, OUT(cn_ray_hit)),
	RAYS(CAST_RAY); NOW(cn_world_cast_ray(NULL, good_ray(), NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_ray(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ANY(r) cn_world_cast_ray_any(W, r, NULL, INT)
ENTRY(cn_world_cast_ray_any, cn_world_cast_ray_any(W, good_ray(), &query_filter, INT),
	RAYS(CAST_RAY_ANY); NOW(cn_world_cast_ray_any(NULL, good_ray(), NULL, INT)); ARG(cn_world_cast_ray_any(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ALL(r) cn_world_cast_ray_all(W, r, NULL, OUT(cn_ray_hit) + 4, 8, INT)
ENTRY(cn_world_cast_ray_all, cn_world_cast_ray_all(W, good_ray(), &query_filter, OUT(cn_ray_hit) + 4, 8, INT),
	RAYS(CAST_RAY_ALL); NOW(cn_world_cast_ray_all(NULL, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, NULL, 1, INT)); ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, -1, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, NULL));)
#define CAST_RAYS(r) cn_world_cast_rays(W, r, 1, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_rays, cn_world_cast_rays(W, ray_pair(v2(1.0f, 0.0f)), 2, &query_filter, hit_list),
	RAYS(CAST_RAYS); NOW(cn_world_cast_rays(NULL, good_ray(), 1, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_rays(W, good_ray(), -1, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_rays(W, good_ray(), 1, NULL, NULL)); VECTOR(v, cn_world_cast_rays(W, ray_pair(v), 2, NULL, OUT(cn_ray_hit)));)
#define CAST_RAY_SHAPE(r) cn_shape_cast_ray(W, f.chain, r, OUT(cn_ray_hit))
ENTRY(cn_shape_cast_ray, cn_shape_cast_ray(W, f.chain, good_ray(), OUT(cn_ray_hit)),
	RAYS(CAST_RAY_SHAPE); NOW(cn_shape_cast_ray(NULL, f.chain, good_ray(), OUT(cn_ray_hit))); SHAPE(h, cn_shape_cast_ray(W, h, good_ray(), OUT(cn_ray_hit)));
	ARG(cn_shape_cast_ray(W, f.chain, good_ray(), NULL));)
#define CAST_SHAPE(p) cn_world_cast_shape(W, p, 1.0f, -2.0f, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_shape, cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, -2.0f, &query_filter, OUT(cn_ray_hit)),
	REGIONS(CAST_SHAPE); NOW(cn_world_cast_shape(NULL, (reset_queries(), &polygon), 1.0f, -2.0f, NULL, OUT(cn_ray_hit)));
	VECTOR(v, cn_world_cast_shape(W, (reset_queries(), &polygon), v.x, v.y, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 0.0f, 2.1e6f, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, 0.0f, NULL, NULL));)
#define OVERLAP_AABB(b) cn_world_overlap_aabb(W, b, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_aabb, cn_world_overlap_aabb(W, (reset_queries(), &region_box), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_aabb, (reset_queries(), &region_box)) ARG(OVERLAP_AABB(NULL)); POSITION(v, OVERLAP_AABB(region_from(v)));
	POSITION(v, OVERLAP_AABB(region_to(v))); ARG(OVERLAP_AABB(region_to(v2(-2.0f, 1.0f)))); ARG(OVERLAP_AABB(region_to(v2(1.0f, -2.0f))));)
#define OVERLAP_CIRCLE(c) cn_world_overlap_circle(W, c, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_circle, cn_world_overlap_circle(W, (reset_queries(), &circle), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_circle, (reset_queries(), &circle)) ARG(OVERLAP_CIRCLE(NULL)); POSITION(v, OVERLAP_CIRCLE(CI(center_m, v)));
	POSITIVE(x, OVERLAP_CIRCLE(CI(radius_m, x))); ARG(OVERLAP_CIRCLE(CI(radius_m, 1.1e6f)));)
#define OVERLAP_POLYGON(p) cn_world_overlap_polygon(W, p, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_polygon, cn_world_overlap_polygon(W, (reset_queries(), &polygon), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_polygon, (reset_queries(), &polygon)) REGIONS(OVERLAP_POLYGON);)
#define OVERLAP_POINT(v) cn_world_overlap_point(W, v.x, v.y, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_point, cn_world_overlap_point(W, 0.0f, 0.5f, &query_filter, OUT(cn_shape) + 4, 8, INT),
	POSITION(v, OVERLAP_POINT(v)); NOW(cn_world_overlap_point(NULL, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, NULL, 1, INT)); ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, -1, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, NULL));)
ENTRY(cn_world_closest_point, cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, &query_filter, OUT(cn_closest)),
	POSITION(v, cn_world_closest_point(W, v.x, v.y, 5.0f, NULL, OUT(cn_closest))); RANGE(x, -1e-30f, 4.1e6f, cn_world_closest_point(W, 0.0f, 3.0f, x, NULL, OUT(cn_closest)));
	NOW(cn_world_closest_point(NULL, 0.0f, 3.0f, 5.0f, NULL, OUT(cn_closest))); ARG(cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, NULL, NULL));)
#define BLAST(field, value) (reset_queries(), blast.field = (value), &blast)
ENTRY(cn_world_explode, cn_world_explode(W, BLAST(radius_m, 100.0f)),
	NOW(cn_world_explode(NULL, BLAST(radius_m, 1.0f))); ARG(cn_world_explode(W, NULL)); SIZES(x, cn_world_explode(W, BLAST(struct_size, x)));
	RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(radius_m, x))); RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(falloff_m, x)));
	FLOAT(x, cn_world_explode(W, BLAST(impulse_Nspm, x))); POSITION(v, cn_world_explode(W, BLAST(center_m, v)));
	ARG(cn_world_explode(W, BLAST(impulse_Nspm, 3e38f)));)

#include "arguments_joints.h"

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
	E(cn_world_set_solver), E(cn_world_get_solver), E(cn_world_set_accuracy), E(cn_world_get_accuracy), E(cn_world_get_islands),
	E(cn_world_set_flags), E(cn_world_get_flags), E(cn_world_get_worker_count), E(cn_world_set_restitution_threshold), E(cn_world_set_speed_limits), E(cn_world_set_sleep),
	E(cn_world_set_user_data), E(cn_world_get_user_data), E(cn_world_get_bodies), E(cn_world_get_shapes), E(cn_world_get_joints),
	E(cn_world_get_counters), E(cn_world_get_profile), E(cn_world_get_memory_stats), E(cn_world_hash), E(cn_world_validate),
	E(cn_body_def_init), E(cn_body_create), E(cn_body_create_many), E(cn_body_destroy), E(cn_body_destroy_many), E(cn_body_is_valid),
	E(cn_body_set_type), E(cn_body_get_type), E(cn_body_set_flags), E(cn_body_get_flags), E(cn_body_set_awake), E(cn_body_set_pose),
	E(cn_body_get_pose), E(cn_body_get_angle), E(cn_body_get_center), E(cn_body_set_velocity), E(cn_body_get_velocity),
	E(cn_body_get_velocity_at), E(cn_body_get_world_point), E(cn_body_get_local_point), E(cn_body_get_aabb), E(cn_body_apply_force),
	E(cn_body_apply_force_at), E(cn_body_apply_torque), E(cn_body_apply_impulse), E(cn_body_apply_impulse_at),
	E(cn_body_apply_angular_impulse), E(cn_body_get_mass_data), E(cn_body_set_mass_data), E(cn_body_reset_mass_data),
	E(cn_body_set_damping), E(cn_body_get_damping), E(cn_body_set_gravity_scale), E(cn_body_get_gravity_scale), E(cn_body_set_sleep_speed),
	E(cn_body_set_solver), E(cn_body_get_solver),
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
	E(cn_joint_get_reaction), E(cn_joint_get_error), E(cn_joint_set_solver), E(cn_joint_get_solver), E(cn_joint_set_user_data), E(cn_joint_get_user_data), E(cn_joint_set_flags),
	E(cn_joint_get_flags), E(cn_joint_get_revolute), E(cn_joint_set_revolute), E(cn_joint_get_distance), E(cn_joint_set_distance),
	E(cn_joint_get_position), E(cn_joint_get_speed), E(cn_joint_set_motor), E(cn_joint_set_limits), JOINT_ENTRIES,
	E(cn_world_set_filter_callback), E(cn_world_set_pre_solve_callback), E(cn_world_set_material_mix_callback), E(cn_world_sensor_events),
	E(cn_shape_set_flags), E(cn_shape_get_flags), E(cn_world_set_fixed_step), E(cn_world_update), E(cn_world_read_poses_interpolated),
	E(cn_debug_draw_init), E(cn_world_draw),
	E(cn_query_filter_init), E(cn_world_cast_ray), E(cn_world_cast_ray_any), E(cn_world_cast_ray_all), E(cn_world_cast_rays),
	E(cn_shape_cast_ray), E(cn_world_cast_shape), E(cn_world_overlap_aabb), E(cn_world_overlap_circle), E(cn_world_overlap_polygon),
	E(cn_world_overlap_point), E(cn_world_closest_point), E(cn_explosion_def_init), E(cn_world_explode),
	E(cn_tree_create), E(cn_tree_destroy), E(cn_tree_insert), E(cn_tree_remove), E(cn_tree_move), E(cn_tree_get_box), E(cn_tree_query),
	E(cn_tree_cast_ray), E(cn_tree_get_stats)
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
	fixture_with_joints(0);
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
		fixture_with_joints(0);
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
	fixture_with_joints(0);
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
			fixture_with_joints(1);
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
	return test_end();
}
