/*
 * test/world/determinism_test.c - same input, same bits: one golden number a scene, whatever the compiler, its
 * options, the processor, the memory the world lives in, and what else runs beside it.
 *
 * A scene's number is the FNV-1a digest of cn_world_hash every ten steps, so a difference that heals is seen
 * too. If every scene differs in one build only, look for contraction, wider floats (base/config.h) or an
 * uninitialised value; if golden numbers hold and only one of the other tests fails, look for an order that
 * depends on addresses or on memory that was not cleared (base/table.c, base/blocks.c, model/lane.c).
 *
 * The golden numbers may be replaced when a change is meant to alter motion (solver, narrowphase, mass
 * properties, the order of pairs, a scene itself) and every build of test/variants.sh agrees on the new
 * ones. They may not be replaced because one build disagrees, nor for a change that should not
 * alter motion: there the difference is the finding. CAIRN_PRINT_GOLDEN=1 prints the table ready to paste.
 */
#include "fixture.h"
#include "scenes/scenes.h"

typedef struct golden {
	const char *scene;
	int32_t steps;
	int32_t everywhere; /* cheap enough for every test here */
	uint64_t digest;
} golden;

/* clang-format off */
static const golden goldens[] = {
	{ "falling_hinges", 480, 1, 0x8b50471c51fa1aee },
	{ "small_200", 300, 1, 0xe216f521a4dfe85e },
	{ "small_50_sleep", 600, 1, 0x9a4e05f82fde73b7 },
	{ "dominoes", 400, 1, 0x7410bcc4c51d0675 },
	{ "ragdolls", 480, 1, 0x79bbc97ee284f9fc },
	{ "bridge", 240, 1, 0x405f86f0ffbe711a },
	{ "car", 400, 1, 0x207b722fb5e67c25 },
	{ "mixer", 240, 1, 0x7474ddb540fd6ed1 },
	{ "pyramid", 120, 0, 0x387c9d4d7cb5aaff },
	{ "rain", 150, 0, 0xbd48b22521a1db77 },
	{ "tumbler_1000", 300, 0, 0x97bcb1e3139a9906 },
};
/* clang-format on */
/* By an emulator (test/cross.sh), which is slow, the golden numbers alone: the other tests say nothing about a processor. By the
   slowest, TEST_EMULATED=2, without the scenes that are large: the others have every kind of shape, joint and contact. */
#if defined(TEST_EMULATED)
#define EMULATED TEST_EMULATED
#else
#define EMULATED 0
#endif

#define GOLDENS ((int32_t)(sizeof goldens / sizeof *goldens))

/* ---- running a scene ---- */

typedef struct course {
	scene_run run;
	uint64_t digest;
} course;

static void must_scene(const scene_run *run)
{
	if (run->result == CN_OK)
		return;
	printf("  scene: %s (%s)\n", run->error_text, cn_result_text(run->result));
	exit(2);
}

static void course_open(course *c, const char *name, const cn_world_def *def)
{
	const scene *which = scene_find(name);
	if (which == NULL) {
		printf("  no scene %s\n", name);
		exit(2);
	}
	scene_open(&c->run, which, def);
	must_scene(&c->run);
	c->digest = 0xCBF29CE484222325u;
}

static void course_step(course *c)
{
	uint64_t hash;
	int32_t byte;
	scene_step(&c->run);
	must_scene(&c->run);
	if (c->run.step_index % 10 != 0)
		return;
	hash = fixture_hash(c->run.world);
	for (byte = 0; byte < 8; ++byte)
		c->digest = (c->digest ^ (hash >> 8 * byte & 0xFFu)) * 0x100000001B3u;
}

static uint64_t course_finish(course *c, int32_t steps)
{
	while (c->run.step_index < steps)
		course_step(c);
	scene_close(&c->run);
	return c->digest;
}

static uint64_t digest_of(const golden *g, const cn_world_def *def)
{
	course c;
	course_open(&c, g->scene, def);
	return course_finish(&c, g->steps);
}

/* What a scene gives here and now: the other tests compare with this, so that they still say something when
   the golden numbers wait for an update. */
static uint64_t reference_of(const golden *g)
{
	static uint64_t references[GOLDENS];
	static int32_t known[GOLDENS];
	int32_t k = (int32_t)(g - goldens);
	if (!known[k])
		references[k] = digest_of(g, NULL);
	known[k] = 1;
	return references[k];
}

static void check_digest(const golden *g, uint64_t digest, const char *how)
{
	uint64_t reference = reference_of(g);
	printf("  %s %s: %016llx, alone %016llx\n", g->scene, how, (unsigned long long)digest, (unsigned long long)reference);
	CHECK(digest == reference);
}

/* ---- the golden numbers ---- */

static void golden_hashes_hold(void)
{
	int32_t k, print = getenv("CAIRN_PRINT_GOLDEN") != NULL;
	for (k = 0; k < GOLDENS; ++k) {
		uint64_t digest;
		if (EMULATED == 2 && !goldens[k].everywhere)
			continue;
		digest = reference_of(&goldens[k]);
		if (print)
			printf("\t{ \"%s\", %d, %d, 0x%016llx },\n", goldens[k].scene, (int)goldens[k].steps, (int)goldens[k].everywhere, (unsigned long long)digest);
		else
			printf("  %s: %016llx, golden %016llx\n", goldens[k].scene, (unsigned long long)digest, (unsigned long long)goldens[k].digest);
		CHECK(print || test_golden_holds(digest, goldens[k].digest));
	}
}

/* Whether one of the tests below runs a scene: all of the cheap ones in the long form, else every third or fourth, others than the test before. */
static int32_t is_run_by(int32_t k, int32_t test) { return goldens[k].everywhere && (k + test) % TEST_FORM(1, 3, 4) == 0; }

/* ---- the same world again ---- */

static void second_world_after_the_first_repeats_it(void)
{
	int32_t k;
	for (k = 0; k < GOLDENS; ++k)
		if (is_run_by(k, 0))
			check_digest(&goldens[k], digest_of(&goldens[k], NULL), "created again");
}

/* Two runs of a scene and one of the next scene take turns, the second run three steps behind. */
static void worlds_side_by_side_do_not_meet(void)
{
	int32_t k;
	for (k = 0; k + 1 < GOLDENS; ++k) {
		const golden *g = &goldens[k];
		course first, second, other;
		if (!is_run_by(k, 1))
			continue;
		course_open(&first, g->scene, NULL);
		course_open(&second, g->scene, NULL);
		course_open(&other, goldens[k + 1].scene, NULL);
		while (second.run.step_index < g->steps) {
			if (first.run.step_index < g->steps)
				course_step(&first);
			if (first.run.step_index % 4 == 0)
				course_step(&other);
			if (first.run.step_index >= 3)
				course_step(&second);
		}
		check_digest(g, course_finish(&first, g->steps), "interleaved, first");
		check_digest(g, course_finish(&second, g->steps), "interleaved, second");
		scene_close(&other.run);
	}
}

/* ---- memory ---- */

static void reserve_enough(cn_world_def *def)
{
	def->body_capacity = 1000;
	def->shape_capacity = 2000;
	def->contact_capacity = 8000;
	def->joint_capacity = 1000;
}

static void reserved_capacities_change_nothing(void)
{
	int32_t k;
	for (k = 0; k < GOLDENS; ++k) {
		cn_world_def def;
		scene_world_def(scene_find(goldens[k].scene), &def);
		reserve_enough(&def);
		if (is_run_by(k, 2))
			check_digest(&goldens[k], digest_of(&goldens[k], &def), "reserved");
	}
}

static void fixed_memory_changes_nothing(void)
{
	int32_t k;
	for (k = 0; k < GOLDENS; ++k) {
		cn_world_def def;
		unsigned char *raw;
		if (!is_run_by(k, 3))
			continue;
		scene_world_def(scene_find(goldens[k].scene), &def);
		reserve_enough(&def);
		must(cn_world_bytes_needed(&def, &def.memory_bytes), NULL, "cn_world_bytes_needed");
		raw = (unsigned char *)malloc((size_t)def.memory_bytes + 64);
		REQUIRE(raw != NULL);
		memset(raw, 0xA5, (size_t)def.memory_bytes + 64);
		def.memory = raw + (64 - (uintptr_t)raw % 64) % 64;
		check_digest(&goldens[k], digest_of(&goldens[k], &def), "in one block");
		free(raw);
	}
}

/* Memory full of rubbish at irregular addresses; with falling set later blocks lie below earlier ones. */
typedef struct odd_heap {
	unsigned char *bytes;
	uint64_t size, used;
	uint32_t random;
	int32_t falling;
} odd_heap;

static void *odd_alloc(uint64_t bytes, uint32_t align, void *user)
{
	odd_heap *heap = (odd_heap *)user;
	uint64_t gap = 64 * (uint64_t)fixture_random(&heap->random, 0.0f, 8.0f), size = (bytes + 63) / 64 * 64;
	unsigned char *memory;
	(void)align; /* the heap and all sizes are multiples of 64 */
	if (heap->used + gap + size > heap->size)
		return NULL;
	heap->used += gap + size;
	memory = heap->bytes + (heap->falling ? heap->size - heap->used : heap->used - size);
	memset(memory, (int)(heap->random & 0xFFu), (size_t)size);
	return memory;
}

static void odd_free(void *memory, uint64_t bytes, void *user)
{
	(void)user;
	memset(memory, 0xDD, (size_t)bytes);
}

static void addresses_change_nothing(void)
{
	odd_heap heap = { NULL, 64u << 20, 0, 12345u, 0 };
	unsigned char *raw = (unsigned char *)malloc((size_t)heap.size + 64);
	int32_t k;
	REQUIRE(raw != NULL);
	heap.bytes = raw + (64 - (uintptr_t)raw % 64) % 64;
	for (k = 0; k < GOLDENS; ++k) {
		cn_world_def def;
		if (!is_run_by(k, 4))
			continue;
		scene_world_def(scene_find(goldens[k].scene), &def);
		def.alloc = odd_alloc;
		def.free = odd_free;
		def.allocator_user = &heap;
		for (heap.falling = TEST_FORM(0, k / 2 % 2, k / 4 % 2); heap.falling < 2; heap.falling += TEST_FORM(1, 2, 2)) {
			heap.used = 0;
			check_digest(&goldens[k], digest_of(&goldens[k], &def), heap.falling ? "at falling addresses" : "at rising addresses");
		}
	}
	free(raw);
}

/* ---- looking ---- */

static void read_everything(cn_world *world)
{
	const cn_contact_event *events;
	const cn_body_moved *moved;
	const cn_body *asleep;
	cn_body bodies[64];
	cn_profile profile;
	int32_t kind, count, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		must(cn_world_contact_events(world, kind, &events, &count), world, "cn_world_contact_events");
	must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
	must(cn_world_fell_asleep(world, &asleep, &count), world, "cn_world_fell_asleep");
	must(cn_world_get_profile(world, &profile), world, "cn_world_get_profile");
	must(cn_world_get_bodies(world, bodies, 64, &count), world, "cn_world_get_bodies");
	for (k = 0; k < count && k < 64; ++k) {
		cn_contact_event contacts[8];
		cn_aabb box;
		int32_t contact_count;
		must(cn_body_get_contacts(world, bodies[k], contacts, 8, &contact_count), world, "cn_body_get_contacts");
		must(cn_body_get_aabb(world, bodies[k], &box), world, "cn_body_get_aabb");
	}
	fixture_counters(world);
}

static void reading_and_profiling_change_nothing(void)
{
	int32_t k;
	for (k = 0; k < GOLDENS; ++k) {
		cn_world_def def;
		course c;
		if (!is_run_by(k, 5))
			continue;
		scene_world_def(scene_find(goldens[k].scene), &def);
		def.flags |= CN_WORLD_PROFILE;
		course_open(&c, goldens[k].scene, &def);
		while (c.run.step_index < goldens[k].steps) {
			course_step(&c);
			read_everything(c.run.world);
			if (c.run.step_index % 60 == 0)
				CHECK(fixture_is_valid(c.run.world));
		}
		check_digest(&goldens[k], course_finish(&c, goldens[k].steps), "read every step");
	}
}

/* A hash that noticed nothing would pass everything above. */
static void hash_sees_the_last_bit(void)
{
	cn_world *worlds[2];
	uint64_t before[2];
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_body body;
		worlds[k] = fixture_world(-10.0f, 1);
		body = fixture_box(worlds[k], CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_set_velocity(worlds[k], body, k == 0 ? 1.0f : nextafterf(1.0f, 2.0f), 0.0f, 0.0f);
		before[k] = fixture_hash(worlds[k]);
		fixture_step(worlds[k], 1);
	}
	CHECK(before[0] != before[1]);
	CHECK(fixture_hash(worlds[0]) != before[0]);
	CHECK(fixture_hash(worlds[0]) != fixture_hash(worlds[1]));
	cn_world_destroy(worlds[0]);
	cn_world_destroy(worlds[1]);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(golden_hashes_hold);
	if (getenv("CAIRN_PRINT_GOLDEN") == NULL && !EMULATED) {
		RUN(second_world_after_the_first_repeats_it);
		RUN(worlds_side_by_side_do_not_meet);
		RUN(reserved_capacities_change_nothing);
		RUN(fixed_memory_changes_nothing);
		RUN(addresses_change_nothing);
		RUN(reading_and_profiling_change_nothing);
		RUN(hash_sees_the_last_bit);
	}
	return test_end();
}
