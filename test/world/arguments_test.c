/*
 * arguments_test - promise: every public function refuses every bad argument with the right code and a
 * sentence that names it, and a call that fails changes nothing.
 *
 * The list of functions is read from include/cairn.h at run time, so a new function without an entry here
 * fails the test. Each entry has a good call and a list of bad ones. The good calls are used to show
 * that the entry's other arguments are fine, that inside a callback everything is refused, and that a
 * call which runs out of memory changes nothing either.
 *
 * The last test compares the errors that were produced on the way with those that the header documents, function by function: its
 * comment, and the rules at the top of the header.
 */
#include "arguments_calls.h"

#include "model/world.h"

#include "arguments_world.h"
#include "arguments_bodies.h"
#include "arguments_shapes.h"
#include "arguments_areas.h"
#include "arguments_joints.h"
#include "arguments_queries.h"

#ifndef CAIRN_HEADER
#define CAIRN_HEADER "include/cairn.h"
#endif

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
	E(cn_world_set_solver), E(cn_world_get_solver), E(cn_world_set_accuracy), E(cn_world_get_accuracy), E(cn_world_get_islands),
	E(cn_world_set_flags), E(cn_world_get_flags), E(cn_world_get_worker_count), E(cn_world_set_restitution_threshold), E(cn_world_set_hit_speed), E(cn_world_set_speed_limits), E(cn_world_set_sleep),
	E(cn_world_set_user_data), E(cn_world_get_user_data), E(cn_world_get_bodies), E(cn_world_get_shapes), E(cn_world_get_joints),
	E(cn_world_save_size), E(cn_world_save), E(cn_world_restore), E(cn_world_write_size), E(cn_world_write), E(cn_world_read), E(cn_save_delta_size), E(cn_save_delta), E(cn_save_apply),
	E(cn_world_get_counters), E(cn_world_get_profile), E(cn_world_get_memory_stats), E(cn_world_hash), E(cn_world_shift_origin), E(cn_body_get_position_parts), E(cn_world_validate),
	E(cn_body_def_init), E(cn_body_create), E(cn_body_create_many), E(cn_body_destroy), E(cn_body_destroy_many), E(cn_body_is_valid),
	E(cn_body_set_type), E(cn_body_get_type), E(cn_body_set_flags), E(cn_body_get_flags), E(cn_body_set_awake), E(cn_body_set_pose),
	E(cn_body_get_pose), E(cn_body_get_angle), E(cn_body_get_center), E(cn_body_set_velocity), E(cn_body_set_target_pose), E(cn_body_get_velocity),
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
	E(cn_shape_get_capsule), E(cn_shape_set_circle), E(cn_shape_set_capsule), E(cn_shape_set_edge), E(cn_shape_set_polygon), E(cn_shape_set_chain), E(cn_shape_get_edge), E(cn_shape_get_polygon), E(cn_shape_get_chain_points), E(cn_shape_test_point),
	E(cn_outline_decompose), E(cn_outline_simplify), E(cn_outline_from_cells), E(cn_outline_from_field),
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
	E(cn_area_def_init), E(cn_shape_set_area), E(cn_shape_get_area), E(cn_shape_apply_wind),
	E(cn_polygon_distance), E(cn_polygon_cast), E(cn_polygon_collide), E(cn_polygon_time_of_impact),
	E(cn_mover_def_init), E(cn_mover_move), E(cn_mover_collide), E(cn_mover_solve), E(cn_mover_clip), E(cn_shape_get_contacts), E(cn_shape_get_visitors),
	E(cn_tree_create), E(cn_tree_destroy), E(cn_tree_insert), E(cn_tree_remove), E(cn_tree_move), E(cn_tree_get_box), E(cn_tree_query),
	E(cn_tree_cast_ray), E(cn_tree_get_stats)
};
#define TABLE_COUNT ((int)(sizeof table / sizeof *table))

/* What the header says about each function of the table. */
typedef struct declared {
	char name[64];
	char comment[2048];
	char parameters[512];
	int changes_world; /* takes a non-const world */
	int has_result;    /* returns a cn_result */
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

static void copy_text(char *out, size_t capacity, const char *from, const char *to)
{
	size_t length = (size_t)(to - from);
	length = length < capacity ? length : capacity - 1;
	memcpy(out, from, length);
	out[length] = '\0';
}

/* The comment that ends right before a declaration. */
static void comment_parse(declared *d, const char *text, const char *declaration)
{
	const char *begin = declaration;
	d->comment[0] = '\0';
	if (declaration - text < 2 || strncmp(declaration - 2, "*/", 2) != 0)
		return;
	while (begin > text && strncmp(begin, "/*", 2) != 0)
		--begin;
	copy_text(d->comment, sizeof d->comment, begin, declaration);
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
	d->has_result = strncmp(from, "cn_result ", 10) == 0;
	copy_text(d->parameters, sizeof d->parameters, open, to);
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
		if (end != NULL) {
			int known = function_count;
			declaration_parse(p + 8, end);
			if (function_count > known)
				comment_parse(&functions[known], text, p);
		}
	}
	free(text);
}

static const declared *declared_find(const char *name)
{
	int k;
	for (k = 0; k < function_count; ++k)
		if (strcmp(functions[k].name, name) == 0)
			return &functions[k];
	return NULL;
}

static int changes_world(const char *name)
{
	const declared *d = declared_find(name);
	return d != NULL && d->changes_world;
}

/* ------------------------------------------------------------------ errors that were produced */

static uint32_t produced_by[TABLE_COUNT];

/* The entry that what follows is about. */
static void entry_begin(int k)
{
	current = table[k].name;
	current_produced = &produced_by[k];
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
	fixture_with_joints(1);
	bad_calls = 0;
	for (k = 0; k < TABLE_COUNT; ++k) {
		entry_begin(k);
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

/* Functions of a non-const world, and those of which the header says so. */
static int is_locked_out(const char *name)
{
	const declared *d = declared_find(name);
	return d != NULL && (d->changes_world || strstr(d->comment, "CN_ERROR_LOCKED") != NULL);
}

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
		if (!is_locked_out(table[k].name))
			continue;
		entry_begin(k);
		result = strcmp(table[k].name, "cn_world_destroy") == 0 ? (cn_world_destroy(world), CN_ERROR_LOCKED) : table[k].good();
		after = state_of(world);
		++locked_calls;
		if (strcmp(table[k].name, "cn_world_destroy") != 0)
			produced(result);
		if (result != CN_ERROR_LOCKED || state_differs(&s, &after)) {
			printf("  %s gives %d\n", table[k].name, (int)result);
			test_fail(__FILE__, __LINE__, "a call inside a callback must be refused and change nothing");
		}
		if (strcmp(table[k].name, "cn_world_destroy") != 0 && changes_world(table[k].name))
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
		entry_begin(k);
		for (allow = 0; allow < 100; ++allow) {
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
			produced(result);
			if (result != CN_ERROR_MEMORY || state_differs(&s, &after)) {
				printf("  %s with allocation %d failing gives %d\n", table[k].name, allow, (int)result);
				test_fail(__FILE__, __LINE__, "a call without memory must fail and change nothing");
			}
			check_valid(table[k].name);
			CHECK(table[k].good() == CN_OK);
			check_valid(table[k].name);
			fixture_free();
		}
		CHECK(allow < 100);
	}
	CHECK_LE("bytes leaked", alloc_live, 0, "B");
	CHECK_GE("failures met", failures, 10, "");
}

static int creates(const char *name)
{
	return strstr(name, "_create") != NULL && strcmp(name, "cn_world_create") != 0 && strcmp(name, "cn_tree_create") != 0;
}

/* Tables grow by pages: creates until one of them has to, and there is no memory for it. */
static void create_until_memory_ends(int k)
{
	int made, times = 0;
	for (made = 0; made < 2; ++made) {
		state s, after;
		cn_result result = CN_OK;
		int n;
		fixture_with_joints(1);
		alloc_allow = 0;
		for (n = 0; result == CN_OK && n < 5000 && (made == 0 || n < times); ++n)
			result = table[k].good();
		s = state_of(W);
		if (made == 0)
			times = n - 1;
		else
			result = table[k].good();
		alloc_allow = -1;
		after = state_of(W);
		produced(result);
		if (result != CN_ERROR_MEMORY || state_differs(&s, &after)) {
			printf("  %s gives %d after %d calls\n", table[k].name, (int)result, n);
			test_fail(__FILE__, __LINE__, "creating without memory must fail and change nothing");
		}
		check_valid(table[k].name);
		CHECK(table[k].good() == CN_OK);
		fixture_free();
	}
}

static void t_creating_until_memory_ends_changes_nothing(void)
{
	int k;
	for (k = 0; k < TABLE_COUNT; ++k) {
		if (!creates(table[k].name))
			continue;
		entry_begin(k);
		create_until_memory_ends(k);
	}
}

/* ------------------------------------------------------------------ as many things as there may be */

static cni_handles *tables_of(int k) { return k == 0 ? &W->body_handles : k == 1 ? &W->shape_handles : &W->joint_handles; }

/* Tables that say that they are full: a million bodies take a gigabyte. */
static cn_result call_with_full_tables(cn_result (*call)(void))
{
	int32_t slots[3], counts[3];
	cn_result result;
	int k;
	for (k = 0; k < 3; ++k) {
		cni_handles *handles = tables_of(k);
		slots[k] = handles->slots.count;
		counts[k] = handles->count;
		handles->slots.count = handles->count = CN_MAX_HANDLES;
	}
	result = call();
	for (k = 0; k < 3; ++k) {
		tables_of(k)->slots.count = slots[k];
		tables_of(k)->count = counts[k];
	}
	return result;
}

static void t_full_tables_take_nothing(void)
{
	int k, calls = 0;
	for (k = 0; k < TABLE_COUNT; ++k) {
		state s, after;
		cn_result result;
		if (!creates(table[k].name))
			continue;
		entry_begin(k);
		fixture_with_joints(0);
		s = state_of(W);
		result = call_with_full_tables(table[k].good);
		after = state_of(W);
		produced(result);
		++calls;
		if (result != CN_ERROR_CAPACITY || state_differs(&s, &after) || strncmp(cn_world_error_text(W), current, strlen(current)) != 0) {
			printf("  %s gives %d: %s\n", current, (int)result, cn_world_error_text(W));
			test_fail(__FILE__, __LINE__, "a full table must refuse, and nothing may change");
		}
		check_valid(current);
		fixture_free();
	}
	CHECK_GE("functions that create", calls, 20, "");
}

/* ------------------------------------------------------------------ errors as documented */

static const char *const error_names[] = { "", "CN_ERROR_ARGUMENT", "CN_ERROR_HANDLE", "CN_ERROR_MEMORY", "CN_ERROR_LOCKED", "CN_ERROR_CAPACITY", "CN_ERROR_STATE",
	"CN_ERROR_INTERNAL", "CN_ERROR_FORMAT" };
#define ERRORS ((int)(sizeof error_names / sizeof *error_names))
#define BIT(error) (1u << -(error))

/* A handle by value or in an array, an item of a tree, or a definition that holds one. */
static int takes_handle(const declared *d)
{
	static const char *const kinds[] = { " cn_body body", " cn_shape s", " cn_joint joint", " cn_constraint constraint", " uint32_t item", "const cn_body *bodies",
		"cn_shape_def *def", "cn_query_filter *filter", "cn_explosion_def *def", "cn_mover_def *def" };
	size_t k;
	for (k = 0; k < sizeof kinds / sizeof *kinds; ++k)
		if (strstr(d->parameters, kinds[k]) != NULL)
			return 1;
	return creates(d->name) && (strncmp(d->name, "cn_joint", 8) == 0 || strncmp(d->name, "cn_constraint", 13) == 0);
}

/* The errors that a comment names, also those of the function that it refers to: "otherwise as cn_...". */
static uint32_t named_errors(const declared *d)
{
	const char *other = strstr(d->comment, "therwise as cn_");
	uint32_t errors = 0;
	int e;
	for (e = 1; e < ERRORS; ++e)
		if (strstr(d->comment, error_names[e]) != NULL)
			errors |= 1u << e;
	if (other != NULL) {
		char name[64];
		int k, length = 0;
		for (other += 12; length < 63 && (other[length] == '_' || (other[length] >= 'a' && other[length] <= 'z')); ++length)
			name[length] = other[length];
		name[length] = '\0';
		for (k = 0; k < function_count; ++k)
			if (strcmp(functions[k].name, name) == 0 && &functions[k] != d)
				errors |= named_errors(&functions[k]);
	}
	return errors;
}

static uint32_t documented_errors(const declared *d)
{
	uint32_t errors = named_errors(d);
	if (!d->has_result)
		return 0;
	errors |= BIT(CN_ERROR_ARGUMENT);
	if (takes_handle(d))
		errors |= BIT(CN_ERROR_HANDLE);
	if (d->changes_world)
		errors |= BIT(CN_ERROR_LOCKED);
	if (creates(d->name))
		errors |= BIT(CN_ERROR_MEMORY) | BIT(CN_ERROR_CAPACITY);
	return errors;
}

static void pairs_print(const char *name, uint32_t errors, const char *what)
{
	int e;
	for (e = 1; e < ERRORS; ++e)
		if (errors >> e & 1u)
			printf("  %s: %s is %s\n", name, error_names[e], what);
}

/* Whatever changes a world may need memory, by the rules of the header. */
static void t_errors_are_those_of_the_header(void)
{
	int k, missing = 0, extra = 0, pairs = 0, e;
	for (k = 0; k < TABLE_COUNT; ++k) {
		const declared *d = declared_find(table[k].name);
		uint32_t documented, allowed;
		REQUIRE(d != NULL);
		documented = documented_errors(d);
		allowed = documented | (d->changes_world ? BIT(CN_ERROR_MEMORY) : 0u);
		for (e = 1; e < ERRORS; ++e) {
			pairs += (int)(documented >> e & 1u);
			missing += (int)((documented & ~produced_by[k]) >> e & 1u);
			extra += (int)((produced_by[k] & ~allowed) >> e & 1u);
		}
		pairs_print(d->name, documented & ~produced_by[k], "documented and not produced");
		pairs_print(d->name, produced_by[k] & ~allowed, "produced and not documented");
	}
	CHECK_GE("pairs of function and error", pairs, 600, "");
	CHECK_LE("documented and not produced", missing, 0, "");
	CHECK_LE("produced and not documented", extra, 0, "");
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
	RUN(t_creating_until_memory_ends_changes_nothing);
	RUN(t_full_tables_take_nothing);
	if (test_filter == NULL) /* the others produce the errors */
		RUN(t_errors_are_those_of_the_header);
	return test_end();
}
