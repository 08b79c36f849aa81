/*
 * test/world/memory_test.c - memory of whole worlds: every allocation may fail, a warm world asks for nothing, and the
 * budgets. Fixed blocks are in memory_block_test.c.
 *
 * If a test here fails, look first in: the function that the message names (what it reserves before it changes anything),
 * narrowphase/pairs.c and narrowphase/narrowphase.c (steps), model/event.c (bookends), base/blocks.c and base/table.c (growth).
 */
#include "memory_session.h"

#include "broadphase/sweep.h"

#define FAILURE_STRIDE TEST_FORM(1, 3, 9)
#define FAILURES_EVERY 3000 /* this stride up to here, then one of 13 */

/* ------------------------------------------------------------------ the n-th allocation fails */

/* Number of the call in which each allocation is asked for, from a run without failures. */
static int64_t calls_of_plain_run(void)
{
	session *s = (session *)calloc(1, sizeof *s);
	int64_t allocations;
	session_run(s, 0, 0);
	printf("  without failures: %d calls, %lld allocations, %lld events, %d bodies asleep at most\n", s->calls,
	       (long long)s->hooks.calls, (long long)s->events, s->asleep_most);
	if (s->problem != NULL)
		printf("  step %d: %s (%lld)\n", s->problem_step, s->problem, (long long)s->problem_value);
	CHECK(s->problem == NULL);
	CHECK_GE("events in a run", s->events, 1000, "");
	allocations = s->problem == NULL ? s->hooks.calls : 0;
	free(s);
	return allocations;
}

/* From the first number on. The three tests begin at 1, 2 and 3: together they visit every number where the stride is 3. */
static void fail_at_numbers(int64_t first, int32_t failing_steps)
{
	int64_t n, last = calls_of_plain_run(), problems = 0, refused = 0, warned = 0, runs = 0;
	REQUIRE(last > 0);
	for (n = first; n <= last && problems < 5; n += n < FAILURES_EVERY ? FAILURE_STRIDE : 13) {
		session *s = (session *)calloc(1, sizeof *s);
		session_run(s, n, failing_steps);
		++runs;
		refused += s->refused;
		warned += s->warned;
		if (s->problem != NULL) {
			++problems;
			printf("  allocation %lld, step %d: %s (%lld)\n", (long long)n, s->problem_step, s->problem, (long long)s->problem_value);
		}
		free(s);
	}
	printf("  %lld runs: %lld calls said CN_ERROR_MEMORY, %lld steps had a warning\n", (long long)runs, (long long)refused, (long long)warned);
	CHECK_GE("refused calls a run", (double)refused / (double)runs, 0.1, "");
	CHECK_GE("steps with a warning", warned, 1, "");
	CHECK_LE("runs with a broken promise", problems, 0, "runs");
}

static void world_survives_one_failed_allocation(void) { fail_at_numbers(1, 0); }
static void world_survives_five_steps_without_memory(void) { fail_at_numbers(2, 5); }
static void world_survives_forty_steps_without_memory(void) { fail_at_numbers(3, 40); }

/* ------------------------------------------------------------------ a chain without memory for its boxes */

static uint8_t *written(const cn_world *world, uint64_t *bytes)
{
	uint8_t *file;
	must(cn_world_write_size(world, bytes), world, "cn_world_write_size");
	file = (uint8_t *)malloc((size_t)*bytes);
	if (file == NULL)
		abort();
	must(cn_world_write(world, file, *bytes, NULL), world, "cn_world_write");
	return file;
}

static void a_chain_that_is_refused_changes_nothing(void)
{
	session_hooks hooks;
	cn_world_def def;
	cn_world *world = NULL;
	cn_shape_def shape;
	cn_vec2 points[600];
	cn_chain chain = { points, 600, 0 };
	int32_t k, refused = 0, changed = 0;
	cn_result result = CN_ERROR_MEMORY;
	memset(&hooks, 0, sizeof hooks);
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = &hooks;
	def.shape_capacity = 1000;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	shape = fixture_shape_def(fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f), 0.6f, 0.0f);
	fixture_step(world, 3);
	for (k = 0; k < 600; ++k) {
		points[k].x = -0.1f * (float)k;
		points[k].y = 0.0f;
	}
	for (k = 1; result == CN_ERROR_MEMORY && k < 100; ++k) {
		uint64_t before_bytes, after_bytes;
		uint8_t *before = written(world, &before_bytes), *after;
		hooks.fail_first = hooks.fail_last = hooks.calls + k;
		result = cn_shape_create_chain(world, &shape, &chain, NULL);
		hooks.fail_first = 0;
		after = written(world, &after_bytes);
		refused += result == CN_ERROR_MEMORY;
		changed += result == CN_ERROR_MEMORY && (before_bytes != after_bytes || memcmp(before, after, (size_t)before_bytes) != 0);
		free(before);
		free(after);
	}
	CHECK(result == CN_OK);
	CHECK_GE("calls refused", refused, 2, "");
	CHECK_LE("... that changed the world", changed, 0, "");
	cn_world_destroy(world);
}

/* ------------------------------------------------------------------ steps that work around missing memory say so */

static void pin(cn_world *world, cn_body a, float x, float y, cn_body b)
{
	cn_revolute_def def;
	cn_joint joint;
	cn_revolute_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m.x = x;
	def.base.anchor_a_m.y = y;
	def.base.anchor_b_m.y = 0.3f;
	def.base.flags |= CN_JOINT_LIMIT;
	def.lower_angle_rad = -0.4f;
	def.upper_angle_rad = 0.3f;
	must(cn_joint_create_revolute(world, &def, &joint), world, "cn_joint_create_revolute");
}

/* Twenty trunks with three limbs, solved side by side; two boxes on the ground, of which a warm step finds one locked and one a conveyor. */
static cn_world *workaround_world(session_hooks *hooks, int32_t warm)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_body boxes[2];
	int32_t k, limb, count;
	memset(hooks, 0, sizeof *hooks);
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = hooks;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 2; ++k)
		boxes[k] = fixture_box(world, CN_BODY_DYNAMIC, -5.0f - 2.0f * (float)k, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 20; ++k) {
		cn_body trunk = fixture_box(world, CN_BODY_DYNAMIC, 3.0f * (float)k, 5.0f, 0.1f * (float)k, 0.5f, 0.1f, 0.6f, 0.0f);
		for (limb = -1; limb <= 1; ++limb) {
			cn_body b = fixture_body(world, CN_BODY_DYNAMIC, 3.0f * (float)k + 0.4f * (float)limb, 4.7f, 0.0f);
			cn_shape_def shape = fixture_shape_def(b, 0.6f, 0.0f);
			shape.filter.group = -1;
			fixture_box_shape(world, &shape, 0.08f, 0.3f);
			pin(world, trunk, 0.4f * (float)limb, 0.0f, b);
		}
	}
	if (warm) {
		cn_shape shape;
		cn_material material;
		fixture_step(world, 3);
		must(cn_body_set_flags(world, boxes[0], CN_BODY_ENABLED | CN_BODY_SLEEP | CN_BODY_AWAKE | (warm == 1 ? CN_BODY_LOCK_X : 0u)), world, "cn_body_set_flags");
		must(cn_body_get_shapes(world, boxes[1], &shape, 1, &count), world, "cn_body_get_shapes");
		must(cn_shape_get_material(world, shape, &material), world, "cn_shape_get_material");
		material.tangent_speed_mps = warm == 2 ? 1.0f : 0.0f;
		must(cn_shape_set_material(world, shape, &material), world, "cn_shape_set_material");
		must(cn_body_set_velocity(world, boxes[0], 1.0f, 0.0f, 0.0f), world, "cn_body_set_velocity");
	}
	return world;
}

static void steps_that_lack_memory_say_so(void)
{
	int32_t warm, silent = 0, changed = 0, failures = 0;
	for (warm = 0; warm < 3; ++warm) {
		uint64_t hash = 0;
		int64_t number, before;
		for (number = 0; number == 0 || number < 500; ++number) {
			session_hooks hooks;
			cn_world *world = workaround_world(&hooks, warm);
			cn_result result;
			before = hooks.calls;
			hooks.fail_first = number > 0 ? before + number : 0;
			hooks.fail_last = hooks.fail_first + 1; /* arrays ask twice */
			result = cn_world_step(world, FRAME_S);
			if (number == 0)
				hash = fixture_hash(world);
			failures += hooks.failed > 0;
			if (hooks.failed > 0 && result == CN_OK && fixture_hash(world) != hash) {
				++changed;
				silent += fixture_counters(world).warnings == 0;
			}
			cn_world_destroy(world);
			if (number > 0 && hooks.failed == 0)
				break;
		}
	}
	printf("  %d steps with failed allocations\n", (int)failures);
	CHECK_GE("steps that such failures changed", changed, 5, "");
	CHECK_LE("... without a warning", silent, 0, "");
}

/* ------------------------------------------------------------------ a kick without memory to remember it */

static void a_fast_body_hits_without_memory(void)
{
	session_hooks hooks;
	cn_world_def def;
	cn_world *world = NULL;
	cn_body ball;
	memset(&hooks, 0, sizeof hooks);
	cn_world_def_init(&def);
	def.gravity_mps2.y = 0.0f;
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = &hooks;
	def.contact_capacity = 16;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.1f, 0.0f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 2.0f, 0.0f, 0.0f, 0.05f, 2.0f, 0.0f, 0.0f);
	fixture_step(world, 3);
	hooks.fail_first = hooks.calls + 1;
	hooks.fail_last = hooks.calls + 2; /* with spare room, and without */
	must(cn_body_set_velocity(world, ball, 300.0f, 0.0f, 0.0f), world, "cn_body_set_velocity");
	CHECK(hooks.failed == 2);
	fixture_step(world, 1);
	CHECK_LE("speed behind the board", (double)fixture_velocity(world, ball).linear_mps.x, 30.0, "m/s");
	cn_world_destroy(world);
}

/* ------------------------------------------------------------------ a locked axis without memory for its rows */

/* A ball stuck between two steep walls is locked along x and pushed down when there is no memory any more. Its mass along
   their normals is then a hundredth: a solver that does not know of the lock must not be told that. */
static void a_locked_body_stays_slow_without_memory(void)
{
	session_hooks hooks;
	cn_world_def def;
	cn_world *world = NULL;
	cn_body body = 0;
	cn_counters counters;
	double speed = 0.0;
	int32_t k;
	memset(&hooks, 0, sizeof hooks);
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = &hooks;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_box(world, CN_BODY_STATIC, 1.0f, 0.0f, -0.1f, 0.5f, 20.0f, 0.0f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -1.0f, 0.0f, 0.1f, 0.5f, 20.0f, 0.0f, 0.0f);
	body = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.1f, 0.5f, 0.0f, 0.0f);
	fixture_step(world, 20);
	must(cn_world_get_counters(world, &counters), world, "cn_world_get_counters");
	CHECK(counters.contacts_touching == 2);
	hooks.fail_first = 1;
	hooks.fail_last = INT64_MAX;
	must(cn_body_set_flags(world, body, CN_BODY_ENABLED | CN_BODY_SLEEP | CN_BODY_AWAKE | CN_BODY_LOCK_X | CN_BODY_LOCK_ROTATION), world, "cn_body_set_flags");
	must(cn_body_set_velocity(world, body, 0.0f, -1.0f, 0.0f), world, "cn_body_set_velocity");
	for (k = 0; k < 60; ++k) {
		(void)cn_world_step(world, FRAME_S);
		speed = greater(speed, fabs((double)fixture_velocity(world, body).linear_mps.y));
	}
	CHECK_LE("fastest", speed, 1.2, "m/s"); /* what it was given, and gravity of a step */
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ------------------------------------------------------------------ a warm world asks for nothing */

static cn_world *counted_world(session_hooks *hooks, int32_t sleep)
{
	cn_world_def def;
	cn_world *world = NULL;
	memset(hooks, 0, sizeof *hooks);
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = hooks;
	if (!sleep)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static void check_steady(cn_world *world, const session_hooks *hooks, int32_t warm_up, int32_t steps, int64_t most)
{
	cn_memory_stats before, after;
	int64_t calls;
	fixture_step(world, warm_up);
	calls = hooks->calls;
	must(cn_world_get_memory_stats(world, &before), NULL, "cn_world_get_memory_stats");
	fixture_step(world, steps);
	must(cn_world_get_memory_stats(world, &after), NULL, "cn_world_get_memory_stats");
	printf("  %lld allocator calls in %d steps of warm-up; arena %llu bytes, %llu fallbacks\n", (long long)calls, warm_up,
	       (unsigned long long)after.arena_capacity, (unsigned long long)after.arena_fallbacks);
	CHECK_LE("allocator calls after it", hooks->calls - calls, most, "calls");
	CHECK_LE("arena fallbacks after it", after.arena_fallbacks - before.arena_fallbacks, 0, "");
}

static void resting_world_asks_for_nothing(void)
{
	session_hooks hooks;
	cn_world *world = counted_world(&hooks, 0);
	fixture_pyramid(world, 15);
	check_steady(world, &hooks, 120, 300, 0);
	cn_world_destroy(world);
	CHECK(hooks.pieces == 0 && hooks.wrong == 0);
}

static void build_tumbler(cn_world *world, int32_t boxes)
{
	cn_body drum = fixture_body(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 0.0f);
	int32_t k;
	for (k = 0; k < 4; ++k) {
		cn_shape_def def = fixture_shape_def(drum, 0.6f, 0.0f);
		def.offset_m.x = k == 0 ? 10.0f : k == 1 ? -10.0f : 0.0f;
		def.offset_m.y = k == 2 ? 10.0f : k == 3 ? -10.0f : 0.0f;
		fixture_box_shape(world, &def, k < 2 ? 0.5f : 10.0f, k < 2 ? 10.0f : 0.5f);
	}
	for (k = 0; k < boxes; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, 0.7f * (float)(k % 20) - 7.0f, 0.7f * (float)(k / 20) - 5.0f, 0.0f, 0.25f, 0.25f, 0.6f, 0.0f);
	fixture_set_velocity(world, drum, 0.0f, 0.0f, 0.5f);
}

static void moving_world_asks_for_nothing(void)
{
	session_hooks hooks;
	cn_world *world = counted_world(&hooks, 0);
	build_tumbler(world, TEST_FORM(300, 150, 150));
	check_steady(world, &hooks, 3000, TEST_SAMPLES(600), 0);
	cn_world_destroy(world);
	CHECK(hooks.pieces == 0 && hooks.wrong == 0);
}

/* ------------------------------------------------------------------ budgets */

static double row_bodies;

static uint64_t print_row(const char *owner, uint64_t capacity, uint64_t used)
{
	if (capacity > 0)
		printf("    %-22s %8.1f, of it used %8.1f\n", owner, (double)capacity / row_bodies, (double)used / row_bodies);
	return capacity;
}

static uint64_t table_row(const char *owner, const cni_table *table, int32_t used)
{
	uint64_t bytes = (uint64_t)table->page_count * ((uint64_t)table->item_bytes << table->page_shift) + (uint64_t)table->page_capacity * sizeof(void *);
	return print_row(owner, bytes, (uint64_t)used * (uint64_t)table->item_bytes);
}

static uint64_t array_row(const char *owner, const cni_array *array)
{
	return print_row(owner, (uint64_t)array->capacity * (uint64_t)array->item_bytes, (uint64_t)array->count * (uint64_t)array->item_bytes);
}

static uint64_t blocks_row(const char *owner, const cni_blocks *blocks)
{
	return print_row(owner, blocks->bytes_in_chunks + blocks->bytes_large + (uint64_t)blocks->chunks.capacity * 16, blocks->bytes_in_use + blocks->bytes_large);
}

static uint64_t events_rows(const cni_events *events)
{
	uint64_t sum = 0;
	int32_t kind;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		sum += array_row("events of the step", &events->log[kind]);
		sum += array_row("events since", &events->pending[kind]);
		sum += array_row("events as seen", &events->seen[kind]);
	}
	sum += array_row("sensor events", &events->sensor_log) + array_row("sensor events since", &events->sensor_pending);
	return sum + array_row("moved list", &events->moved) + array_row("fell asleep list", &events->asleep);
}

/* Bytes by owner, divided by the number of bodies. */
static void print_owners(const cn_world *world, int32_t bodies)
{
	const cni_sweep *sweep = (const cni_sweep *)(const void *)world->broadphase;
	uint64_t sum = 0;
	row_bodies = bodies;
	sum += print_row("world struct", sizeof *world, sizeof *world);
	sum += table_row("bodies", &world->bodies, world->body_handles.count);
	sum += table_row("shapes", &world->shapes, world->shape_handles.count);
	sum += table_row("proxies", &world->proxies, world->proxy_count);
	sum += table_row("contacts", &world->contacts, world->contact_count);
	sum += table_row("contact blocks", &world->blocks_hot, world->block_used);
	sum += table_row("contact block infos", &world->blocks_info, world->block_used);
	sum += table_row("contact block anchors", &world->blocks_anchor, world->block_used);
	sum += table_row("islands", &world->islands, world->island_count);
	sum += array_row("body handles", &world->body_handles.slots) + array_row("shape handles", &world->shape_handles.slots);
	sum += array_row("motion", &world->motion) + array_row("start", &world->start) + array_row("drive", &world->external);
	sum += array_row("awake ids", &world->awake_id) + array_row("apart contacts", &world->apart);
	sum += array_row("pairs", &world->pairs.list) + array_row("sleep lanes", &world->sleep_lanes);
	sum += events_rows(&world->events);
	sum += print_row("frame arena", world->arena.capacity, world->arena.high_water);
	sum += blocks_row("geometry and names", &world->blocks) + blocks_row("broadphase rows", &sweep->rows);
	sum += array_row("broadphase tiles", &sweep->tiles) + print_row("broadphase table", (uint64_t)sweep->slot_capacity * 4, 0);
	sum += array_row("broadphase moved bits", &sweep->moved) + array_row("broadphase loose bits", &sweep->loose) + print_row("broadphase struct", sizeof *sweep, sizeof *sweep);
	print_row("others", world->memory.bytes_in_use > sum ? world->memory.bytes_in_use - sum : 0, 0);
}

static uint64_t bytes_in_use(const cn_world *world)
{
	cn_memory_stats stats;
	must(cn_world_get_memory_stats(world, &stats), NULL, "cn_world_get_memory_stats");
	return stats.bytes_in_use;
}

/* Figures of examples/docs/memory.md, within 2%. */
static void figure_holds(const char *what, double bytes, double documented)
{
	printf("  %s: %.0f bytes, documented %.0f\n", what, bytes, documented);
	CHECK_LE("off the documentation", fabs(bytes - documented) / documented, 0.02, "of it");
}

/* Bytes of each of so many bodies with a box that touches nothing, after one step. */
static double lone_bytes(int32_t boxes)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint64_t bytes = bytes_in_use(world);
	int32_t k;
	for (k = 0; k < boxes; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, 20.0f * (float)(k % 100), 20.0f * (float)(k / 100), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 1);
	bytes = bytes_in_use(world) - bytes;
	if (boxes == 1000)
		print_owners(world, boxes);
	cn_world_destroy(world);
	return (double)bytes / boxes;
}

static void budgets_hold(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	if (sizeof(void *) != 8)
		SKIP("budgets are for 64 bits");
	figure_holds("empty world", (double)bytes_in_use(world), 8552);
	cn_world_destroy(world);
	figure_holds("lone box of 100", lone_bytes(100), 657);
	figure_holds("lone box of 1,000", lone_bytes(1000), 509);
	figure_holds("lone box of 100,000", lone_bytes(100000), 482);
	world = fixture_world(-10.0f, 1);
	fixture_pyramid(world, 100);
	fixture_step(world, 1);
	print_owners(world, 5051);
	figure_holds("box of a pyramid with its contacts", (double)bytes_in_use(world) / 5051.0, 1200);
	must(cn_world_set_sleep(world, 0.0f, 1e6f), world, "cn_world_set_sleep"); /* what sleeps has its lanes elsewhere, and room for being awake */
	fixture_step(world, 99);
	CHECK_LE("... after 100 steps", (double)bytes_in_use(world) / 5051.0, 1200, "bytes");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(a_chain_that_is_refused_changes_nothing);
	RUN(steps_that_lack_memory_say_so);
	RUN(a_fast_body_hits_without_memory);
	RUN(a_locked_body_stays_slow_without_memory);
	RUN(world_survives_one_failed_allocation);
	RUN(world_survives_five_steps_without_memory);
	RUN(world_survives_forty_steps_without_memory);
	RUN(resting_world_asks_for_nothing);
	RUN(moving_world_asks_for_nothing);
	RUN(budgets_hold);
	return test_end();
}
