/*
 * test/world/arguments_world.h - entries of arguments_test for the library, worlds, callbacks, sensors, variable time and
 * drawing: good and bad calls of each function. Included by arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_WORLD_H
#define CAIRN_TEST_ARGUMENTS_WORLD_H

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
	DEFAULT_OR_NOT_NEGATIVE(x, call(WD(accuracy_m, x)));
	INTEGER(x, 0, 1000000001, call(WD(work_budget, x))); INTEGER(x, -2, 1000000001, call(WD(work_budget, x)));
	DEFAULT_OR_NOT_NEGATIVE(x, call(WD(restitution_threshold_mps, x))); DEFAULT_OR_NOT_NEGATIVE(x, call(WD(hit_speed_mps, x)));
	DEFAULT_OR_POSITIVE(x, call(WD(push_speed_max_mps, x)));
	DEFAULT_OR_POSITIVE(x, call(WD(linear_speed_max_mps, x)));
	POSITIVE(x, call(WD(angular_speed_max_radps, x)));
	DEFAULT_OR_NOT_NEGATIVE(x, call(WD(sleep_speed_mps, x)));
	NOT_NEGATIVE(x, call(WD(sleep_delay_s, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(body_capacity, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(shape_capacity, x)));
	INTEGER(x, -1, INT32_MAX, call(WD(contact_capacity, x)));
	INTEGER(x, -1, CN_MAX_HANDLES + 1, call(WD(joint_capacity, x)));
	INTEGER(x, 0, CN_WORKERS_MAX + 1, call(WD(worker_count, x)));
	INTEGER(x, -2, INT32_MAX, call(WD(touching_capacity, x)));
	INTEGER(x, -2, INT32_MAX, call(WD(event_capacity, x)));
	INTEGER(x, 2, CN_POLYGON_MAX_VERTICES + 1, call(WD(vertex_capacity, x)));
	FLAGS(x, 4, call(WD(reserve, x)));
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
	NOW(cn_world_set_accuracy(NULL, 0.001f, 500)); DEFAULT_OR_NOT_NEGATIVE(x, cn_world_set_accuracy(W, x, 500)); INTEGER(x, 0, 1000000001, cn_world_set_accuracy(W, 0.001f, x)); INTEGER(x, -2, 1000000001, cn_world_set_accuracy(W, 0.001f, x));)
ENTRY(cn_world_get_accuracy, cn_world_get_accuracy(W, OUT(float), INT + 8),
	NOW(cn_world_get_accuracy(NULL, OUT(float), INT + 8)); ARG(cn_world_get_accuracy(W, NULL, INT)); ARG(cn_world_get_accuracy(W, OUT(float), NULL));)
ENTRY(cn_world_set_flags, cn_world_set_flags(W, CN_WORLD_PROFILE),
	NOW(cn_world_set_flags(NULL, 0)); FLAGS(x, 4, cn_world_set_flags(W, x));)
WORLD_GETTER(cn_world_get_flags, uint32_t)
WORLD_GETTER(cn_world_get_worker_count, int32_t)
ENTRY(cn_world_set_hit_speed, cn_world_set_hit_speed(W, 2.0f),
	NOW(cn_world_set_hit_speed(NULL, 2.0f)); NOT_NEGATIVE(x, cn_world_set_hit_speed(W, x));)
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
ENTRY(cn_world_shift_origin, cn_world_shift_origin(W, 0.5f, -0.25f),
	NOW(cn_world_shift_origin(NULL, 1.0f, 1.0f)); POSITION(v, cn_world_shift_origin(W, v.x, v.y));)
WORLD_GETTER(cn_world_hash, uint64_t)
/* Of a world with a broken invariant: world/validate_test.c breaks others. */
static cn_result validate_broken(void)
{
	cn_result result;
	++W->movable_count;
	result = cn_world_validate(W, NULL, 0);
	--W->movable_count;
	return result;
}
ENTRY(cn_world_validate, cn_world_validate(W, NULL, 0),
	NOW(cn_world_validate(NULL, NULL, 0)); ARG(cn_world_validate(W, NULL, 5)); ARG(cn_world_validate(W, OUT(char), -1));
	BAD(CN_ERROR_INTERNAL, validate_broken());)

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
static uint8_t save_bytes[1 << 21], file_bytes[1 << 16];
static cn_world *file_world;
static uint64_t save_count(void)
{
	uint64_t bytes = 0;
	if (cn_world_save(W, save_bytes, sizeof save_bytes, &bytes) != CN_OK)
		bytes = 64; /* in a callback */
	return bytes;
}
/* The state that W has now, with a byte changed and less of it. */
static cn_result restore_with(cn_world *world, uint64_t at, uint8_t change, uint64_t less)
{
	uint64_t bytes = save_count();
	save_bytes[at < bytes ? at : bytes / 2] ^= change;
	return cn_world_restore(world, save_bytes, less < bytes ? bytes - less : 0);
}
/* The state of a world with many more bodies, where every allocation fails. */
static cn_result restore_larger(void)
{
	uint64_t bytes = 0;
	cn_world *world = NULL;
	cn_result result = CN_OK;
	int k;
	reset();
	wd.alloc = test_alloc;
	wd.free = test_free;
	if (cn_world_create(&wd, &world) != CN_OK)
		return CN_OK;
	for (k = 0; k < 600 && result == CN_OK; ++k)
		result = cn_body_create(world, &bd, OUT(cn_body));
	memset(out_bytes, 0xA5, sizeof out_bytes);
	if (result == CN_OK)
		result = cn_world_save(world, save_bytes, sizeof save_bytes, &bytes);
	cn_world_destroy(world);
	if (result != CN_OK)
		return result;
	alloc_allow = 0;
	result = cn_world_restore(W, save_bytes, bytes);
	alloc_allow = -1;
	return result;
}
ENTRY(cn_world_save_size, cn_world_save_size(W, OUT(uint64_t)), NOW(cn_world_save_size(NULL, OUT(uint64_t))); ARG(cn_world_save_size(W, NULL));)
ENTRY(cn_world_save, cn_world_save(W, save_bytes, sizeof save_bytes, OUT(uint64_t)),
	NOW(cn_world_save(NULL, save_bytes, sizeof save_bytes, OUT(uint64_t))); ARG(cn_world_save(W, NULL, sizeof save_bytes, OUT(uint64_t)));
	BAD(CN_ERROR_CAPACITY, cn_world_save(W, save_bytes, save_count() - 1, OUT(uint64_t))); BAD(CN_ERROR_CAPACITY, cn_world_save(W, save_bytes, 0, OUT(uint64_t)));)
ENTRY(cn_world_restore, restore_with(W, 0, 0, 0),
	NOW(restore_with(NULL, 0, 0, 0)); ARG(cn_world_restore(W, NULL, 100));
	BAD(CN_ERROR_FORMAT, restore_with(W, 0, 1, 0)); BAD(CN_ERROR_FORMAT, restore_with(W, UINT64_MAX, 1, 0)); BAD(CN_ERROR_FORMAT, restore_with(W, 0, 0, 1));
	BAD(CN_ERROR_FORMAT, restore_with(W, 0, 0, 1000)); BAD(CN_ERROR_FORMAT, restore_with(W, 0, 0, UINT64_MAX)); STATE(restore_with(W, 4, 1, 0));
	BAD(CN_ERROR_MEMORY, restore_larger());)
/* The bytes of a small world of its own, in a callback too. */
static uint64_t file_count(void)
{
	static uint64_t bytes;
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	if (bytes == 0 && cn_world_create(&def, &world) == CN_OK)
		(void)cn_world_write(world, file_bytes, sizeof file_bytes, &bytes);
	cn_world_destroy(world);
	return bytes;
}
/* A world from these, with a byte changed. */
static cn_result read_with(uint64_t at, uint8_t change, uint64_t less)
{
	uint64_t bytes = file_count();
	cn_world_def def;
	cn_world *world = NULL;
	cn_result result;
	cn_world_def_init(&def);
	def.alloc = test_alloc;
	def.free = test_free;
	file_bytes[at < bytes ? at : 0] ^= change;
	result = cn_world_read(&def, file_bytes, less < bytes ? bytes - less : 0, &world);
	file_bytes[at < bytes ? at : 0] ^= change;
	cn_world_destroy(world);
	return result;
}
static cn_result read_with_def(uint32_t struct_size, int32_t workers)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_result result;
	cn_world_def_init(&def);
	def.struct_size = struct_size;
	def.worker_count = workers;
	result = cn_world_read(&def, file_bytes, file_count(), &world);
	cn_world_destroy(world);
	return result;
}
ENTRY(cn_world_write_size, cn_world_write_size(W, OUT(uint64_t)), NOW(cn_world_write_size(NULL, OUT(uint64_t))); ARG(cn_world_write_size(W, NULL));)
ENTRY(cn_world_write, cn_world_write(W, save_bytes, sizeof save_bytes, OUT(uint64_t)),
	NOW(cn_world_write(NULL, save_bytes, sizeof save_bytes, OUT(uint64_t))); ARG(cn_world_write(W, NULL, sizeof save_bytes, OUT(uint64_t)));
	BAD(CN_ERROR_CAPACITY, cn_world_write(W, save_bytes, 1000, OUT(uint64_t))); BAD(CN_ERROR_CAPACITY, cn_world_write(W, save_bytes, 0, OUT(uint64_t)));)
/* A call without a world. */
#define NO_FILE(call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, CN_ERROR_FORMAT, r_, 0); } while (0)
ENTRY(cn_world_read, read_with(0, 0, 0), NOW(cn_world_read(NULL, NULL, 100, &file_world)); NOW(cn_world_read(NULL, file_bytes, file_count(), NULL));
	NOW(read_with_def(3, 1)); NOW(read_with_def((uint32_t)sizeof(cn_world_def), -1)); NO_FILE(read_with(0, 1, 0)); NO_FILE(read_with(UINT64_MAX, 1, 0));
	NO_FILE(read_with(0, 0, 1)); NO_FILE(read_with(0, 0, UINT64_MAX));)
/* A save of a small world of its own, and its delta against itself. */
static uint8_t own_save[1 << 16], own_delta[1 << 16], own_out[1 << 16];
static uint64_t own_count(void)
{
	static uint64_t bytes;
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	if (bytes == 0 && cn_world_create(&def, &world) == CN_OK)
		(void)cn_world_save(world, own_save, sizeof own_save, &bytes);
	cn_world_destroy(world);
	return bytes;
}
static uint64_t delta_count(void)
{
	uint64_t bytes = 0, save = own_count();
	(void)cn_save_delta(own_save, save, own_save, save, own_delta, sizeof own_delta, &bytes);
	return bytes;
}
#define NO_ROOM(call) do { cn_result r_; bad_begin(); r_ = (call); bad_end(__LINE__, #call, CN_ERROR_CAPACITY, r_, 0); } while (0)
ENTRY(cn_save_delta_size, (cn_save_delta_size(own_save, own_count(), own_save, own_count(), OUT(uint64_t))),
	NOW(cn_save_delta_size(NULL, 9, own_save, own_count(), OUT(uint64_t))); NOW(cn_save_delta_size(own_save, own_count(), NULL, 9, OUT(uint64_t)));
	NOW(cn_save_delta_size(own_save, own_count(), own_save, own_count(), NULL)); NO_FILE(cn_save_delta_size(own_save, 9, own_save, own_count(), OUT(uint64_t)));
	NO_FILE(cn_save_delta_size(own_save, own_count(), own_save, own_count() - 1, OUT(uint64_t)));)
ENTRY(cn_save_delta, (cn_save_delta(own_save, own_count(), own_save, own_count(), own_out, sizeof own_out, OUT(uint64_t))),
	NOW(cn_save_delta(NULL, 9, own_save, own_count(), own_out, sizeof own_out, OUT(uint64_t))); NOW(cn_save_delta(own_save, own_count(), NULL, 9, own_out, sizeof own_out, OUT(uint64_t)));
	NOW(cn_save_delta(own_save, own_count(), own_save, own_count(), NULL, sizeof own_out, OUT(uint64_t)));
	NO_ROOM(cn_save_delta(own_save, own_count(), own_save, own_count(), own_out, 8, OUT(uint64_t))); NO_FILE(cn_save_delta(own_save, 9, own_save, own_count(), own_out, sizeof own_out, OUT(uint64_t)));)
ENTRY(cn_save_apply, (cn_save_apply(own_save, own_count(), own_delta, delta_count(), own_out, sizeof own_out, OUT(uint64_t))),
	NOW(cn_save_apply(NULL, 9, own_delta, delta_count(), own_out, sizeof own_out, OUT(uint64_t))); NOW(cn_save_apply(own_save, own_count(), NULL, 9, own_out, sizeof own_out, OUT(uint64_t)));
	NOW(cn_save_apply(own_save, own_count(), own_delta, delta_count(), NULL, sizeof own_out, OUT(uint64_t)));
	NO_ROOM(cn_save_apply(own_save, own_count(), own_delta, delta_count(), own_out, 8, OUT(uint64_t)));
	NO_FILE(cn_save_apply(own_save, own_count(), own_delta, delta_count() - 1, own_out, sizeof own_out, OUT(uint64_t)));
	NO_FILE(cn_save_apply(own_save, own_count() - 8, own_delta, delta_count(), own_out, sizeof own_out, OUT(uint64_t)));)
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

#endif
