/*
 * test/world/memory_block_test.c - worlds in a fixed block: cn_world_bytes_needed is enough for every life within the
 * capacities and is all that is used; what is smaller is refused, what is beyond a capacity is counted.
 *
 * If a test here fails, look first in: world/create.c (capacities, bytes needed), base/blocks.c and base/table.c (growth),
 * then the stage that runs out.
 */
#include "memory_session.h"

#define CHURN_BODIES TEST_FORM(6000, 2000, 800)

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
	fixture_pyramid(fixed, 30);
	fixture_pyramid(free_world, 30);
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

/* Room for 16 bodies, one of them alive at a time, each life with a shape and a joint: far more lives than 16 slots have under their own
   indices. */
static void slots_never_wear_out(void)
{
	enum { LIVES = 60000, KEPT = 64 };
	cn_world_def capacities = fixed_def(16, 16, 32, 16);
	cn_body dead[KEPT] = { 0 };
	cn_shape dead_shapes[KEPT] = { 0 };
	fixed_block block;
	cn_world *world = fixed_world(&capacities, &block);
	cn_body held = fixture_circle(world, CN_BODY_DYNAMIC, 9.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	int32_t k, revived = 0, refused = 0;
	must(cn_world_set_gravity(world, 0.0f, 0.0f), world, "cn_world_set_gravity");
	for (k = 0; k < LIVES && refused == 0; ++k) {
		cn_distance_def def;
		cn_body_def body_def;
		cn_body body = 0;
		cn_shape_def shape_def;
		cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
		cn_joint joint;
		cn_body_def_init(&body_def);
		refused += cn_body_create(world, &body_def, &body) != CN_OK;
		shape_def = fixture_shape_def(body, 0.5f, 0.0f);
		refused += cn_shape_create_circle(world, &shape_def, &circle, &dead_shapes[k % KEPT]) != CN_OK;
		cn_distance_def_init(&def);
		def.base.body_a = held;
		def.base.body_b = body;
		refused += cn_joint_create_distance(world, &def, &joint) != CN_OK || !cn_joint_is_valid(world, joint);
		refused += cn_body_destroy(world, body) != CN_OK || cn_joint_is_valid(world, joint);
		if (k % 8 == 7)
			fixture_step(world, 1); /* which takes the events of what was destroyed */
		dead[k % KEPT] = body;
		revived += cn_body_is_valid(world, dead[(k + 1) % KEPT]) || cn_shape_is_valid(world, dead_shapes[(k + 1) % KEPT]) || !cn_body_is_valid(world, held);
	}
	print_block_use(world, block.bytes);
	if (refused > 0)
		printf("  life %d: %s\n", (int)k, cn_world_error_text(world));
	CHECK_LE("calls refused", refused, 0, "");
	CHECK_LE("handles that came alive again", revived, 0, "");
	CHECK(fixture_is_valid(world) && k == LIVES);
	fixture_step(world, 1);
	cn_world_destroy(world);
	block_close(&block);
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
		int32_t bodies = (int32_t)fixture_random(&random, 0.0f, most), contacts = (int32_t)fixture_random(&random, 0.0f, 2.0f * most);
		int32_t joints = (int32_t)fixture_random(&random, 0.0f, most), events = (int32_t)fixture_random(&random, 0.0f, most);
		cn_world_def def = fixed_def(bodies, contacts, joints, events);
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

static int32_t random_below(uint32_t *random, int32_t most)
{
	return (int32_t)fixture_random(random, 0.0f, (float)most);
}

/* Any definition: mostly small worlds, for which rounding and least sizes weigh most. */
static cn_world_def random_def(uint32_t *random)
{
	int32_t large = random_below(random, 4) == 0;
	cn_world_def def = fixed_def(random_below(random, large ? 300 : 50), random_below(random, large ? 1500 : 80), random_below(random, large ? 500 : 100), random_below(random, large ? 100 : 12));
	def.broadphase = random_below(random, 2);
	def.solver = random_below(random, 4);
	def.reserve = random_below(random, 2) ? def.reserve : (uint32_t)random_below(random, 16);
	def.vertex_capacity = random_below(random, 2) ? CN_POLYGON_MAX_VERTICES : 3 + random_below(random, 14);
	def.touching_capacity = random_below(random, 2) ? CN_DEFAULT : random_below(random, 60);
	def.event_capacity = random_below(random, 2) ? CN_DEFAULT : random_below(random, 60);
	def.worker_count = random_below(random, 4) ? 1 : 1 + random_below(random, 4);
	return def;
}

static void bytes_needed_make_any_world(void)
{
	uint32_t random = 99u;
	int32_t round, refused = 0, loose = 0;
	for (round = 0; round < TEST_FORM(1000, 300, 60); ++round) {
		cn_world_def def = random_def(&random);
		cn_world *world = NULL;
		fixed_block block;
		must(cn_world_bytes_needed(&def, &def.memory_bytes), NULL, "cn_world_bytes_needed");
		block = block_open(def.memory_bytes);
		def.memory = block.memory;
		loose += def.memory_bytes % 64 != 0;
		if (cn_world_create(&def, &world) == CN_OK)
			cn_world_destroy(world);
		else
			++refused;
		refused += block_close(&block) != 0;
	}
	CHECK_LE("definitions refused with the bytes that they need", refused, 0, "");
	CHECK_LE("needs that are no multiple of 64 bytes", loose, 0, "");
}

/* Forty boxes, every one with all events, of which ten pairs may report. */
static cn_world_def lean_def(void)
{
	cn_world_def def = fixed_def(41, 41, 200, 0);
	def.solver = CN_SOLVER_SOFT;
	def.touching_capacity = 120;
	def.event_capacity = 10;
	def.vertex_capacity = 4;
	def.reserve = 0;
	return def;
}

static void lean_fill(cn_world *world, cn_body *bodies)
{
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 40; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 1.05f * (float)(k % 8) + 0.1f * (float)(k / 8), 0.5f + 1.05f * (float)(k / 8), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
}

/* ENTER less LEAVE so far; the pairs of the default event mask. */
static int32_t lean_events(cn_world *world, int32_t *entered)
{
	const cn_contact_event *list;
	int32_t enter = 0, leave = 0;
	must(cn_world_contact_events(world, CN_EVENT_ENTER, &list, &enter), world, "cn_world_contact_events");
	must(cn_world_contact_events(world, CN_EVENT_LEAVE, &list, &leave), world, "cn_world_contact_events");
	*entered += enter;
	return enter - leave;
}

/* Capacities of events change no motion, every ENTER that is reported has its LEAVE, and destroying bodies never lacks memory. */
static void lean_blocks_keep_motion_and_ends(void)
{
	cn_world_def capacities = lean_def(), whole = fixed_def(41, 41, 200, 0);
	fixed_block block, other;
	cn_world *world = fixed_world(&capacities, &block), *full;
	cn_body bodies[40], full_bodies[40];
	int32_t k, differs = 0, open = 0, entered = 0, silent = 0;
	whole.solver = CN_SOLVER_SOFT;
	full = fixed_world(&whole, &other);
	lean_fill(world, bodies);
	lean_fill(full, full_bodies);
	for (k = 0; k < 200; ++k) {
		fixture_step(world, 1);
		fixture_step(full, 1);
		open += lean_events(world, &entered);
		silent += fixture_counters(world).events_not_reported;
		differs += fixture_hash(world) != fixture_hash(full);
	}
	must(cn_body_destroy_many(world, bodies, 40), world, "cn_body_destroy_many");
	fixture_step(world, 1);
	open += lean_events(world, &entered);
	printf("  block of %llu bytes, with default capacities %llu\n", (unsigned long long)block.bytes, (unsigned long long)other.bytes);
	CHECK_LE("steps that differ from a world with room for all events", differs, 0, "");
	CHECK_GE("ENTER events", entered, 5, "");
	CHECK_GE("pairs and events not reported", silent, 20, "");
	CHECK(open == 0);
	CHECK_LE("bytes, of those with default capacities", (double)block.bytes / (double)other.bytes, 0.6, "");
	cn_world_destroy(world);
	cn_world_destroy(full);
	CHECK_LE("bytes written outside of the blocks", block_close(&block) + block_close(&other), 0, "bytes");
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
			fixture_pyramid(world, 4);
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

/* One rolling box without memory for the extra rows of its contacts, with room for some of their pages: nine other boxes stand as they would. */
static void extra_rows_without_memory_cost_no_other_contact(void)
{
	cn_world_def def = fixed_def(40, 40, 2000, 0);
	uint64_t needed, left;
	int32_t k, fallen = 0, refused = 0;
	def.event_capacity = def.vertex_capacity = 4;
	def.reserve = CN_RESERVE_NAMES | CN_RESERVE_CHAINS | CN_RESERVE_MOVED;
	must(cn_world_bytes_needed(&def, &needed), NULL, "cn_world_bytes_needed");
	for (left = 0; left <= 24000; left += 3000) {
		fixed_block block = block_open(needed + left);
		cn_world *world = NULL;
		cn_body boxes[10];
		cn_shape rolling;
		cn_material material;
		int32_t count;
		def.memory = block.memory;
		def.memory_bytes = block.bytes;
		must(cn_world_create(&def, &world), NULL, "cn_world_create");
		fixture_floor(world, 0.6f, 0.0f);
		for (k = 0; k < 10; ++k)
			boxes[k] = fixture_box(world, CN_BODY_DYNAMIC, 2.0f * (float)k - 10.0f, k == 0 ? 0.5f : 2.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		must(cn_body_get_shapes(world, boxes[0], &rolling, 1, &count), world, "cn_body_get_shapes");
		must(cn_shape_get_material(world, rolling, &material), world, "cn_shape_get_material");
		material.rolling_resistance = 0.1f;
		must(cn_shape_set_material(world, rolling, &material), world, "cn_shape_set_material");
		fixture_step(world, 1);
		refused += (fixture_counters(world).warnings & CN_WARNING_CONTACT_MEMORY) != 0;
		fixture_step(world, 119);
		for (k = 1; k < 10; ++k)
			fallen += fixture_pose(world, boxes[k]).position_m.y < 0.4f;
		cn_world_destroy(world);
		CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
	}
	CHECK_GE("worlds that refuse the rolling contact", refused, 9, "");
	CHECK_LE("boxes that fell through the floor", fallen, 0, "");
}

#define REFUSED_BODIES 1100 /* enough that workers share the search */
#define WANTED_FIRST 500
#define WANTED 20

typedef struct chooser {
	cn_shape wanted[WANTED];
	int32_t asked;
} chooser;

static int32_t chooser_wants(const chooser *c, cn_shape shape)
{
	int32_t k;
	for (k = 0; k < WANTED; ++k)
		if (c->wanted[k] == shape)
			return 1;
	return 0;
}

static int32_t choose(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	chooser *c = user;
	(void)world;
	++c->asked;
	return chooser_wants(c, a) && chooser_wants(c, b);
}

/* Discs on one heap, in the middle of the list those that collide with each other. */
static void choosers_fill(cn_world *world, chooser *c)
{
	cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
	int32_t k;
	memset(c, 0, sizeof *c);
	for (k = 0; k < REFUSED_BODIES; ++k) {
		cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 1e-4f * (float)k, 0.0f, 0.0f), 0.5f, 0.0f);
		cn_shape shape;
		must(cn_shape_create_circle(world, &def, &circle, &shape), world, "cn_shape_create_circle");
		if (k >= WANTED_FIRST && k < WANTED_FIRST + WANTED)
			c->wanted[k - WANTED_FIRST] = shape;
	}
	must(cn_world_set_filter_callback(world, choose, c), world, "cn_world_set_filter_callback");
}

static void check_chooser(int32_t broadphase, int32_t workers)
{
	const int32_t wanted = WANTED * (WANTED - 1) / 2, pairs = REFUSED_BODIES * (REFUSED_BODIES - 1) / 2;
	cn_world_def capacities = fixed_def(REFUSED_BODIES, REFUSED_BODIES, wanted, 0);
	fixed_block block;
	cn_world *world;
	cn_counters counters;
	chooser c;
	int32_t step;
	capacities.broadphase = broadphase;
	capacities.worker_count = workers;
	world = fixed_world(&capacities, &block);
	choosers_fill(world, &c);
	for (step = 0; step < 2; ++step) {
		fixture_step(world, 1);
		counters = fixture_counters(world);
		printf("  broadphase %d, %d workers: %d contacts, %d pairs not added, %d asked of %d\n", (int)broadphase, (int)workers, (int)counters.contacts,
		       (int)counters.pairs_not_added, (int)c.asked, (int)pairs);
		CHECK(counters.contacts == wanted && counters.pairs_not_added == 0 && counters.warnings == 0);
		CHECK(c.asked == pairs); /* each once, in the first step */
	}
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	CHECK_LE("bytes written outside of the block", block_close(&block), 0, "bytes");
}

/* Pairs that the user's filter refuses count against no capacity, however many there are. */
static void refused_pairs_take_no_room(void)
{
	int32_t workers;
	for (workers = 1; workers <= 3; workers += 2) {
		check_chooser(CN_BROADPHASE_SWEEP, workers);
		check_chooser(CN_BROADPHASE_TREE, workers);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(pyramid_runs_in_a_fixed_block);
	RUN(churn_fits_in_bytes_needed);
	RUN(slots_never_wear_out);
	RUN(every_shape_may_take_every_size);
	RUN(every_capacity_is_kept);
	RUN(bytes_needed_make_any_world);
	RUN(lean_blocks_keep_motion_and_ends);
	RUN(small_blocks_are_refused);
	RUN(contacts_beyond_capacity_are_counted);
	RUN(extra_rows_without_memory_cost_no_other_contact);
	RUN(refused_pairs_take_no_room);
	return test_end();
}
