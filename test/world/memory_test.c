/*
 * test/world/memory_test.c - memory of whole worlds: every allocation may fail, a fixed block is enough and
 * is all that is used, a warm world asks for nothing, and the budgets.
 *
 * If a test here fails, look first in: world/create.c (capacities, bytes needed), the function that the
 * message names (what it reserves before it changes anything), stages/pairs.c and stages/narrowphase.c (steps),
 * model/event.c (bookends), base/blocks.c and base/table.c (growth).
 */
#include "memory_session.h"

#include "stages/broadphase_sweep.h"

/* Slow builds visit fewer numbers. */
#ifdef TEST_SLOW
#define FAILURE_STRIDE 3
#define CHURN_BODIES 2000
#else
#define FAILURE_STRIDE 1
#define CHURN_BODIES 20000
#endif
#define FAILURES_EVERY 3000 /* every number up to here, then a stride of 13 */

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

static void fail_at_every_number(int32_t failing_steps)
{
	int64_t n, last = calls_of_plain_run(), problems = 0, refused = 0, warned = 0, runs = 0;
	REQUIRE(last > 0);
	for (n = 1; n <= last && problems < 5; n += n < FAILURES_EVERY ? FAILURE_STRIDE : 13) {
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

static void world_survives_one_failed_allocation(void) { fail_at_every_number(0); }
static void world_survives_five_steps_without_memory(void) { fail_at_every_number(5); }
static void world_survives_forty_steps_without_memory(void) { fail_at_every_number(40); }

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
		speed = fmax(speed, fabs((double)fixture_velocity(world, body).linear_mps.y));
	}
	CHECK_LE("fastest", speed, 1.2, "m/s"); /* what it was given, and gravity of a step */
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ------------------------------------------------------------------ a fixed block */

#define GUARD_BYTES 4096
#define GUARD 0x5C

/* A block of the caller's with guards on both sides. */
typedef struct fixed_block {
	uint8_t *raw, *memory;
	uint64_t bytes;
} fixed_block;

static fixed_block block_open(uint64_t bytes)
{
	fixed_block b;
	b.bytes = bytes;
	b.raw = (uint8_t *)malloc((size_t)bytes + 2 * GUARD_BYTES + 64);
	if (b.raw == NULL)
		abort();
	memset(b.raw, GUARD, (size_t)bytes + 2 * GUARD_BYTES + 64);
	b.memory = b.raw + GUARD_BYTES;
	b.memory += (64 - (uintptr_t)b.memory % 64) % 64;
	return b;
}

/* Bytes written outside of the block. */
static int64_t block_close(fixed_block *b)
{
	int64_t written = 0;
	const uint8_t *p, *end = b->raw + b->bytes + 2 * GUARD_BYTES + 64;
	for (p = b->raw; p < end; ++p)
		written += (p < b->memory || p >= b->memory + b->bytes) && *p != GUARD;
	free(b->raw);
	return written;
}

static void *abort_alloc(uint64_t bytes, uint32_t align, void *user)
{
	(void)bytes;
	(void)align;
	(void)user;
	abort();
}

static void abort_free(void *memory, uint64_t bytes, void *user)
{
	(void)memory;
	(void)bytes;
	(void)user;
	abort();
}

static cn_world_def fixed_def(int32_t bodies, int32_t shapes, int32_t contacts, int32_t joints)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def.body_capacity = bodies;
	def.shape_capacity = shapes;
	def.contact_capacity = contacts;
	def.joint_capacity = joints;
	return def;
}

/* A world in a block of exactly the bytes that its capacities need; any use of the allocator aborts. */
static cn_world *fixed_world(const cn_world_def *capacities, fixed_block *block)
{
	cn_world_def def = *capacities;
	cn_world *world = NULL;
	uint64_t bytes = 0;
	must(cn_world_bytes_needed(&def, &bytes), NULL, "cn_world_bytes_needed");
	*block = block_open(bytes);
	def.memory = block->memory;
	def.memory_bytes = bytes;
	def.alloc = abort_alloc;
	def.free = abort_free;
	must(cn_world_create(&def, &world), NULL, "cn_world_create in a block of bytes_needed");
	return world;
}

static void build_pyramid(cn_world *world, int32_t base)
{
	int32_t i, k;
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < base; ++i)
		for (k = i; k < base; ++k)
			fixture_box(world, CN_BODY_DYNAMIC, (float)k - 0.5f * (float)i - 0.5f * (float)base, 0.5f + (float)i, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
}

static void print_block_use(const cn_world *world, uint64_t bytes)
{
	cn_memory_stats stats;
	must(cn_world_get_memory_stats(world, &stats), NULL, "cn_world_get_memory_stats");
	printf("  block of %llu bytes: %llu in use, %llu at most, %llu asked for inside of it\n", (unsigned long long)bytes,
	       (unsigned long long)(stats.bytes_in_use + sizeof(cn_world)), (unsigned long long)(stats.bytes_peak + sizeof(cn_world)), (unsigned long long)stats.allocator_calls);
}

static void pyramid_runs_in_a_fixed_block(void)
{
	cn_world_def capacities = fixed_def(466, 466, 2000, 0);
	fixed_block block;
	cn_world *fixed = fixed_world(&capacities, &block), *free_world = fixture_world(-10.0f, 1);
	int32_t k, differs = 0;
	build_pyramid(fixed, 30);
	build_pyramid(free_world, 30);
	for (k = 0; k < 20; ++k) {
		fixture_step(fixed, 6);
		fixture_step(free_world, 6);
		differs += fixture_hash(fixed) != fixture_hash(free_world) || fixture_counters(fixed).warnings != 0;
	}
	CHECK_GE("contacts", fixture_counters(fixed).contacts, 1300, "");
	CHECK_LE("times that it differs from a world with hooks", differs, 0, "");
	print_block_use(fixed, block.bytes);
	cn_world_destroy(fixed);
	cn_world_destroy(free_world);
	CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
}

/* ---- churn: the same random life in two worlds */

#define CHURN_ALIVE 200

typedef struct churn {
	cn_world *world;
	cn_body bodies[CHURN_ALIVE];
	cn_joint joints[CHURN_ALIVE];
	int32_t count;
	uint32_t random;
	int32_t refused;   /* calls that failed */
	int32_t warned;
	int64_t made;
} churn;

static int32_t churn_index(churn *c, int32_t below)
{
	return (int32_t)fixture_random(&c->random, 0.0f, (float)below - 0.01f);
}

static void churn_expect(churn *c, cn_result result)
{
	if (result == CN_OK)
		return;
	if (c->refused++ == 0)
		printf("  %s\n", cn_world_error_text(c->world));
}

static void churn_polygon(churn *c, const cn_shape_def *def)
{
	cn_polygon polygon;
	int32_t k;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = 3 + churn_index(c, 14);
	for (k = 0; k < polygon.count; ++k) {
		polygon.points_m[k].x = 0.6f * (float)cos(6.2831853 * k / polygon.count);
		polygon.points_m[k].y = 0.6f * (float)sin(6.2831853 * k / polygon.count);
	}
	churn_expect(c, cn_shape_create_polygon(c->world, def, &polygon, NULL));
}

/* Up to 40 edges and no more than the capacity allows: each counts as a shape. */
static void churn_chain(churn *c, const cn_shape_def *def)
{
	cn_vec2 points[41];
	cn_chain chain;
	int32_t k;
	chain.points_m = points;
	chain.count = 2 + churn_index(c, 40);
	chain.loop = 0;
	for (k = 0; k < chain.count; ++k) {
		points[k].x = -0.3f * (float)k;
		points[k].y = (float)(k % 2) * 0.1f;
	}
	churn_expect(c, cn_shape_create_chain(c->world, def, &chain, NULL));
}

static void churn_create(churn *c)
{
	static const char name[] = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcde";
	int32_t kind = churn_index(c, 8), length = churn_index(c, 64), at = c->count++;
	cn_body_def def;
	cn_shape_def shape;
	cn_body_def_init(&def);
	def.type = kind == 7 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
	def.position_m.x = fixture_random(&c->random, -12.0f, 12.0f);
	def.position_m.y = fixture_random(&c->random, 0.0f, 12.0f);
	def.linear_velocity_mps.x = fixture_random(&c->random, -8.0f, 8.0f);
	def.name = name + length;
	churn_expect(c, cn_body_create(c->world, &def, &c->bodies[at]));
	c->joints[at] = 0;
	shape = fixture_shape_def(c->bodies[at], 0.4f, 0.0f);
	shape.event_mask = 31u;
	shape.material.rolling_resistance = kind == 6 ? 0.05f : 0.0f;
	if (kind < 5) {
		churn_polygon(c, &shape);
	} else if (kind < 7) {
		cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
		churn_expect(c, cn_shape_create_circle(c->world, &shape, &circle, NULL));
	} else {
		churn_chain(c, &shape);
	}
	if (kind == 1 && at > 0) {
		cn_distance_def joint;
		cn_distance_def_init(&joint);
		joint.base.body_a = c->bodies[at];
		joint.base.body_b = c->bodies[at - 1];
		joint.length_m = 2.0f;
		churn_expect(c, cn_joint_create_distance(c->world, &joint, &c->joints[at]));
	}
	++c->made;
}

static void churn_destroy(churn *c)
{
	int32_t at = churn_index(c, c->count);
	churn_expect(c, cn_body_destroy(c->world, c->bodies[at]));
	c->bodies[at] = c->bodies[--c->count];
}

static void churn_rename(churn *c)
{
	static const char name[] = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcde";
	churn_expect(c, cn_body_set_name(c->world, c->bodies[churn_index(c, c->count)], name + churn_index(c, 64)));
}

static void churn_step(churn *c)
{
	const cn_contact_event *events;
	const cn_body_moved *moved;
	const cn_sensor_event *sensor;
	int32_t count, kind;
	churn_expect(c, cn_world_step(c->world, FRAME_S));
	c->warned += fixture_counters(c->world).warnings != 0;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		churn_expect(c, cn_world_contact_events(c->world, kind, &events, &count));
	churn_expect(c, cn_world_moved(c->world, &moved, &count));
	churn_expect(c, cn_world_sensor_events(c->world, &sensor, &count));
}

/* A wave: fills up, empties, in rounds of ten changes and a step. */
static void churn_round(churn *c, int64_t round)
{
	int32_t k, filling = round / 25 % 2 == 0;
	for (k = 0; k < 10; ++k) {
		if (c->count < CHURN_ALIVE && (c->count < 20 || fixture_random(&c->random, 0.0f, 1.0f) < (filling ? 0.9f : 0.2f)))
			churn_create(c);
		else
			churn_destroy(c);
	}
	churn_rename(c);
	churn_step(c);
}

static void churn_fits_in_bytes_needed(void)
{
	/* At most 200 bodies, of which any may be a chain of 40 edges. */
	cn_world_def capacities = fixed_def(CHURN_ALIVE + 1, CHURN_ALIVE * 40 + 1, 16000, CHURN_ALIVE);
	churn *fixed = (churn *)calloc(1, sizeof *fixed), *free_one = (churn *)calloc(1, sizeof *free_one);
	fixed_block block;
	int64_t round;
	int32_t differs = 0;
	fixed->world = fixed_world(&capacities, &block);
	free_one->world = fixture_world(-10.0f, 1);
	fixed->random = free_one->random = 0x9E3779B9u;
	fixture_floor(fixed->world, 0.6f, 0.0f);
	fixture_floor(free_one->world, 0.6f, 0.0f);
	for (round = 0; fixed->made < CHURN_BODIES && fixed->refused == 0; ++round) {
		churn_round(fixed, round);
		churn_round(free_one, round);
		if (round % 50 == 0)
			differs += fixture_hash(fixed->world) != fixture_hash(free_one->world);
	}
	printf("  %lld bodies made in %lld rounds, %d contacts at the end\n", (long long)fixed->made, (long long)round, fixture_counters(fixed->world).contacts);
	CHECK_LE("calls that failed", fixed->refused, 0, "");
	CHECK_LE("steps with a warning", fixed->warned, 0, "");
	CHECK_LE("times that it differs from a world with hooks", differs, 0, "");
	CHECK(fixture_is_valid(fixed->world));
	print_block_use(fixed->world, block.bytes);
	cn_world_destroy(fixed->world);
	cn_world_destroy(free_one->world);
	CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
	free(fixed);
	free(free_one);
}

/* Every shape of a world becomes each size in turn: no size class may keep what another one needs. */
static void every_shape_may_take_every_size(void)
{
	cn_world_def capacities = fixed_def(101, 101, 400, 0);
	fixed_block block;
	cn_world *world = fixed_world(&capacities, &block);
	cn_body bodies[101];
	int32_t corners, k, j, refused = 0;
	for (k = 0; k < 101; ++k) {
		bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, 3.0f * (float)(k % 10), 3.0f * (float)(k / 10), 0.0f);
		refused += cn_body_set_name(world, bodies[k], "x") != CN_OK;
	}
	for (corners = 3; corners <= CN_POLYGON_MAX_VERTICES; ++corners) {
		char name[CN_NAME_MAX_BYTES + 1];
		memset(name, 'n', sizeof name);
		name[4 * corners - 1] = '\0';
		for (k = 0; k < 101; ++k) {
			cn_shape_def def = fixture_shape_def(bodies[k], 0.6f, 0.0f);
			cn_shape old = 0;
			cn_polygon polygon;
			int32_t count;
			must(cn_body_get_shapes(world, bodies[k], &old, 1, &count), world, "cn_body_get_shapes");
			if (count > 0)
				must(cn_shape_destroy(world, old), world, "cn_shape_destroy");
			memset(&polygon, 0, sizeof polygon);
			polygon.count = corners;
			for (j = 0; j < corners; ++j) {
				polygon.points_m[j].x = (float)cos(6.2831853 * j / corners);
				polygon.points_m[j].y = (float)sin(6.2831853 * j / corners);
			}
			refused += cn_shape_create_polygon(world, &def, &polygon, NULL) != CN_OK;
			refused += cn_body_set_name(world, bodies[k], name) != CN_OK;
		}
		fixture_step(world, 2);
	}
	CHECK_LE("calls that failed", refused, 0, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
}

/* Fills a world to its capacities with the largest of everything; returns how many calls failed. */
static int32_t fill_world(cn_world *world, const cn_world_def *def)
{
	cn_body bodies[128];
	cn_polygon polygon;
	int32_t k, refused = 0;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = CN_POLYGON_MAX_VERTICES;
	for (k = 0; k < polygon.count; ++k) {
		polygon.points_m[k].x = (float)cos(6.2831853 * k / polygon.count);
		polygon.points_m[k].y = (float)sin(6.2831853 * k / polygon.count);
	}
	for (k = 0; k < def->body_capacity; ++k) {
		cn_body_def body;
		cn_body_def_init(&body);
		body.position_m.x = 5.0f * (float)k;
		body.name = "a name that takes all of the sixty-three bytes that it may have";
		refused += cn_body_create(world, &body, &bodies[k]) != CN_OK;
	}
	for (k = 0; k < def->shape_capacity; ++k) {
		cn_shape_def shape = fixture_shape_def(def->body_capacity > 0 ? bodies[k % def->body_capacity] : 0, 0.6f, 0.0f);
		refused += cn_shape_create_polygon(world, &shape, &polygon, NULL) != CN_OK;
	}
	for (k = 0; k < def->joint_capacity && def->body_capacity > 0; ++k) {
		cn_revolute_def joint;
		cn_joint handle;
		cn_revolute_def_init(&joint);
		joint.base.body_a = bodies[k % def->body_capacity];
		joint.base.anchor_b_m.x = 5.0f * (float)(k % def->body_capacity);
		refused += cn_joint_create_revolute(world, &joint, &handle) != CN_OK;
	}
	return refused;
}

static void every_capacity_is_kept(void)
{
	uint32_t random = 12345u;
	int32_t round, refused = 0, warned = 0, written = 0;
	for (round = 0; round < 60; ++round) {
		float most = round < 10 ? 3.0f : 120.0f;
		cn_world_def def = fixed_def((int32_t)fixture_random(&random, 0.0f, most), (int32_t)fixture_random(&random, 0.0f, 2.0f * most),
		                             (int32_t)fixture_random(&random, 0.0f, most), (int32_t)fixture_random(&random, 0.0f, most));
		fixed_block block;
		cn_world *world;
		if (round == 0)
			def = fixed_def(0, 0, 0, 0);
		world = fixed_world(&def, &block);
		refused += fill_world(world, &def);
		fixture_step(world, 3);
		warned += fixture_counters(world).warnings != 0;
		cn_world_destroy(world);
		written += block_close(&block) != 0;
	}
	CHECK_LE("calls within capacities that failed", refused, 0, "");
	CHECK_LE("worlds with warnings", warned, 0, "");
	CHECK_LE("blocks written outside of", written, 0, "");
}

/* A block of any size either makes a world that keeps its promises or is refused. */
static void small_blocks_are_refused(void)
{
	cn_world_def def = fixed_def(40, 40, 160, 8);
	uint64_t needed = 0, bytes;
	int32_t k, made = 0, refused = 0, broken = 0, bodies_refused = 0;
	must(cn_world_bytes_needed(&def, &needed), NULL, "cn_world_bytes_needed");
	for (bytes = 0; bytes <= needed; bytes += bytes + 192 < needed ? needed / 97 + 1 : 64) {
		fixed_block block = block_open(bytes);
		cn_world *world = (cn_world *)1;
		cn_result result;
		def.memory = block.memory;
		def.memory_bytes = bytes;
		result = cn_world_create(&def, &world);
		if (result == CN_OK) {
			++made;
			build_pyramid(world, 4);
			for (k = 0; k < 200; ++k) {
				cn_body_def body;
				cn_body handle;
				cn_body_def_init(&body);
				bodies_refused += cn_body_create(world, &body, &handle) == CN_ERROR_MEMORY;
			}
			fixture_step(world, 3);
			broken += !fixture_is_valid(world);
			cn_world_destroy(world);
		} else {
			++refused;
			broken += result != CN_ERROR_MEMORY || world != (cn_world *)1;
		}
		broken += block_close(&block) != 0;
	}
	printf("  %d blocks up to %llu bytes: %d refused, %d made\n", made + refused, (unsigned long long)needed, refused, made);
	CHECK_GE("blocks refused", refused, 50, "");
	CHECK_GE("worlds made", made, 1, "");
	CHECK_GE("bodies refused beyond the capacity", bodies_refused, 1, "");
	CHECK_LE("broken promises", broken, 0, "");
}

/* Sixteen contacts' room for a heap of many: steps go on and say so; the world recovers when the heap is small. */
static void contacts_beyond_capacity_are_counted(void)
{
	cn_world_def capacities = fixed_def(400, 400, 16, 0);
	fixed_block block;
	cn_world *world = fixed_world(&capacities, &block);
	cn_body bodies[300];
	session checker;
	cn_counters c;
	int32_t k, lost_most = 0, warned = 0, broken = 0;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 300; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.45f * (float)(k % 20), 0.5f + 0.45f * (float)(k / 20), 0.0f, 0.25f, 0.25f, 0.6f, 0.0f);
	for (k = 0; k < 30; ++k) {
		fixture_step(world, 1);
		c = fixture_counters(world);
		lost_most = c.pairs_not_added > lost_most ? c.pairs_not_added : lost_most;
		warned += (c.warnings & CN_WARNING_CONTACT_MEMORY) != 0;
		broken += !fixture_is_valid(world);
	}
	printf("  %d contacts made, %d pairs not added at most, %d of 30 steps with a warning\n", c.contacts, lost_most, warned);
	CHECK_GE("contacts made", c.contacts, 16, "");
	CHECK_GE("pairs not added", lost_most, 100, "");
	CHECK_GE("steps with a warning", warned, 30, "");
	must(cn_body_destroy_many(world, bodies + 3, 297), world, "cn_body_destroy_many");
	fixture_step(world, 2);
	c = fixture_counters(world);
	CHECK(c.warnings == 0 && c.pairs_not_added == 0);
	memset(&checker, 0, sizeof checker);
	checker.world = world;
	session_check_contacts(&checker);
	CHECK(checker.problem == NULL);
	CHECK_LE("steps after which the world was not valid", broken, 0, "");
	cn_world_destroy(world);
	CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
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
	build_pyramid(world, 15);
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
	build_tumbler(world, 300);
	check_steady(world, &hooks, 2500, 600, 0);
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
	return print_row(owner, blocks->bytes_in_chunks + blocks->bytes_large + (uint64_t)blocks->chunk_capacity * 16, blocks->bytes_in_use + blocks->bytes_large);
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
	sum += array_row("motion", &world->motion) + array_row("start", &world->start) + array_row("drive", &world->drive);
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

static void budgets_hold(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint64_t empty = bytes_in_use(world), lone, pyramid;
	int32_t k;
	if (sizeof(void *) != 8)
		SKIP("budgets are for 64 bits");
	CHECK_LE("empty world", empty, 16384, "bytes");
	for (k = 0; k < 1000; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, 20.0f * (float)(k % 100), 20.0f * (float)(k / 100), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 1);
	lone = bytes_in_use(world);
	print_owners(world, 1000);
	CHECK_LE("lone box", (double)(lone - empty) / 1000.0, 512, "bytes");
	cn_world_destroy(world);
	world = fixture_world(-10.0f, 1);
	build_pyramid(world, 100);
	fixture_step(world, 1);
	pyramid = bytes_in_use(world);
	print_owners(world, 5051);
	CHECK_LE("box of a pyramid with its contacts, after one step", (double)pyramid / 5051.0, 1200, "bytes");
	must(cn_world_set_sleep(world, 0.0f, 1e6f), world, "cn_world_set_sleep"); /* what sleeps has its lanes elsewhere, and room for being awake */
	fixture_step(world, 99);
	CHECK_LE("... after 100 steps", (double)bytes_in_use(world) / 5051.0, 1200, "bytes");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(a_locked_body_stays_slow_without_memory);
	RUN(world_survives_one_failed_allocation);
	RUN(world_survives_five_steps_without_memory);
	RUN(world_survives_forty_steps_without_memory);
	RUN(pyramid_runs_in_a_fixed_block);
	RUN(churn_fits_in_bytes_needed);
	RUN(every_shape_may_take_every_size);
	RUN(every_capacity_is_kept);
	RUN(small_blocks_are_refused);
	RUN(contacts_beyond_capacity_are_counted);
	RUN(resting_world_asks_for_nothing);
	RUN(moving_world_asks_for_nothing);
	RUN(budgets_hold);
	return test_end();
}
