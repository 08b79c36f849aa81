/*
 * test/world/broadphase_choice_test.c - promise: def.broadphase changes nothing but time and memory: both
 * broadphases give the same contacts and the same bits after every step.
 *
 * If a test here fails, a pair was found a step early or late or not at all: look in broadphase/ for
 * the structure that differs from brute force (broadphase/sweep_test.c and broadphase_tree_test.c).
 */
#include "fixture.h"
#include "scenes/scenes.h"

#define STEPS TEST_FORM(300, 200, 100)
#define EVERY TEST_FORM(1, 2, 10) /* validations are expensive */

static int worlds_differ(const cn_world *a, const cn_world *b)
{
	cn_counters ca = fixture_counters(a), cb = fixture_counters(b);
	ca.broadphase_tiles = cb.broadphase_tiles = 0;
	return fixture_hash(a) != fixture_hash(b) || memcmp(&ca, &cb, sizeof ca) != 0;
}

/* First step after which the two differ, or STEPS. */
static int32_t first_difference(scene_run runs[2], const char *name)
{
	int32_t step, invalid = 0;
	for (step = 0; step < STEPS; ++step) {
		must(scene_step(&runs[0]), runs[0].world, name);
		must(scene_step(&runs[1]), runs[1].world, name);
		invalid += step % EVERY == 0 && !fixture_is_valid(runs[1].world);
		if (worlds_differ(runs[0].world, runs[1].world))
			break;
	}
	CHECK_LE("steps after which the world with the tree is not valid", invalid, 0, "");
	return step;
}

static void scene_is_the_same(const char *name, int32_t size)
{
	scene_run runs[2];
	const scene *found = scene_find(name);
	scene which;
	cn_counters counters;
	int32_t k;
	REQUIRE(found != NULL);
	which = *found;
	which.size = size > 0 ? size : which.size;
	for (k = 0; k < 2; ++k) {
		cn_world_def def;
		scene_world_def(&which, &def);
		def.flags |= CN_WORLD_SLEEP;
		def.broadphase = k == 0 ? CN_BROADPHASE_SWEEP : CN_BROADPHASE_TREE;
		memset(&runs[k], 0, sizeof runs[k]);
		must(scene_open(&runs[k], &which, &def), NULL, name);
	}
	CHECK_GE("steps with equal bits", first_difference(runs, name), STEPS, "");
	counters = fixture_counters(runs[1].world);
	printf("  %s: %d bodies, %d awake, %d contacts, hash %016llx\n", name, counters.bodies, counters.bodies_awake, counters.contacts,
	       (unsigned long long)fixture_hash(runs[1].world));
	scene_close(&runs[0]);
	scene_close(&runs[1]);
}

static void t_falling_hinges(void) { scene_is_the_same("falling_hinges", 0); }
static void t_pyramid(void) { scene_is_the_same("pyramid", 15); }
static void t_tumbler(void) { scene_is_the_same("tumbler", 15); }
static void t_ragdolls(void) { scene_is_the_same("ragdolls", 0); }
static void t_mixer(void) { scene_is_the_same("mixer", 100); }
static void t_car_on_a_chain(void) { scene_is_the_same("car", 0); }

/* ---- a world of its own, in which everything is changed between steps */

#define BODIES 150

typedef struct play {
	cn_world *world;
	cn_body body[BODIES];
	cn_shape shape[BODIES];
	uint32_t random;
} play;

/* From 5 cm to 10 m, most of them small. */
static void play_add(play *p, int32_t k)
{
	float x = fixture_random(&p->random, -60.0f, 60.0f), y = fixture_random(&p->random, 1.0f, 60.0f), size = 0.05f;
	cn_shape_def def;
	while (size < 5.0f && fixture_random(&p->random, 0.0f, 1.0f) < 0.72f)
		size *= 1.7f;
	p->body[k] = fixture_body(p->world, k % 17 == 0 ? CN_BODY_KINEMATIC : CN_BODY_DYNAMIC, x, y, x);
	def = fixture_shape_def(p->body[k], 0.5f, k % 5 == 0 ? 0.8f : 0.0f);
	p->shape[k] = fixture_box_shape(p->world, &def, size, 0.5f * size);
	fixture_set_velocity(p->world, p->body[k], -0.5f * x, k % 13 == 0 ? -300.0f : -10.0f, y);
}

static void play_open(play *p, int32_t broadphase)
{
	cn_world_def def;
	int32_t k;
	memset(p, 0, sizeof *p);
	p->random = 99u;
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	must(cn_world_create(&def, &p->world), NULL, "cn_world_create");
	fixture_floor(p->world, 0.6f, 0.0f);
	for (k = 0; k < BODIES; ++k)
		play_add(p, k);
}

/* Destroys, makes, teleports, filters, detaches and wakes, the same in both. */
static void play_change(play *p, int32_t step)
{
	int32_t k = step * 7 % BODIES;
	cn_filter filter;
	if (step % 3 == 0) {
		must(cn_body_destroy(p->world, p->body[k]), p->world, "cn_body_destroy");
		play_add(p, k);
	}
	k = step * 11 % BODIES;
	if (step % 5 == 0) {
		float x = fixture_random(&p->random, -60.0f, 60.0f), y = fixture_random(&p->random, 1.0f, 40.0f);
		must(cn_body_set_pose(p->world, p->body[k], x, y, 0.5f), p->world, "set_pose");
	}
	k = step * 13 % BODIES;
	if (step % 4 == 0) {
		must(cn_shape_get_filter(p->world, p->shape[k], &filter), p->world, "cn_shape_get_filter");
		filter.mask = step % 8 == 0 ? 0 : ~(uint64_t)0;
		must(cn_shape_set_filter(p->world, p->shape[k], &filter), p->world, "cn_shape_set_filter");
	}
	if (step % 10 == 9) {
		must(cn_shape_detach(p->world, p->shape[k]), p->world, "cn_shape_detach");
		must(cn_shape_attach(p->world, p->shape[k], p->body[k]), p->world, "cn_shape_attach");
	}
	if (step % 20 == 0)
		must(cn_body_set_type(p->world, p->body[k], step % 40 ? CN_BODY_DYNAMIC : CN_BODY_STATIC), p->world, "cn_body_set_type");
}

static void t_mixed_sizes_with_changes(void)
{
	play p[2];
	int32_t step, invalid = 0;
	cn_counters counters;
	play_open(&p[0], CN_BROADPHASE_SWEEP);
	play_open(&p[1], CN_BROADPHASE_TREE);
	for (step = 0; step < STEPS && !worlds_differ(p[0].world, p[1].world); ++step) {
		int32_t k;
		for (k = 0; k < 2; ++k) {
			if (step < 200)
				play_change(&p[k], step);
			fixture_step(p[k].world, 1);
		}
		invalid += step % EVERY == 0 && !fixture_is_valid(p[1].world);
	}
	CHECK_GE("steps with equal bits", step, STEPS, "");
	CHECK_LE("steps after which the world with the tree is not valid", invalid, 0, "");
	counters = fixture_counters(p[1].world);
	printf("  %d bodies, %d awake, %d contacts\n", counters.bodies, counters.bodies_awake, counters.contacts);
	cn_world_destroy(p[0].world);
	cn_world_destroy(p[1].world);
}

/* ---- a fixed block of the size that cn_world_bytes_needed asks for */

static void t_fixed_memory_is_enough(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	uint64_t bytes[2];
	cn_counters counters;
	void *raw;
	int32_t k, warnings = 0;
	cn_world_def_init(&def);
	def.body_capacity = def.shape_capacity = 301;
	def.contact_capacity = 3000;
	must(cn_world_bytes_needed(&def, &bytes[0]), NULL, "cn_world_bytes_needed");
	def.broadphase = CN_BROADPHASE_TREE;
	must(cn_world_bytes_needed(&def, &bytes[1]), NULL, "cn_world_bytes_needed");
	printf("  sweep %llu bytes, tree %llu bytes\n", (unsigned long long)bytes[0], (unsigned long long)bytes[1]);
	raw = malloc((size_t)bytes[1] + 64);
	REQUIRE(raw != NULL);
	def.memory = (void *)(((uintptr_t)raw + 63) & ~(uintptr_t)63);
	def.memory_bytes = bytes[1];
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.5f, 0.0f);
	for (k = 0; k < 300; ++k)
		(void)fixture_box(world, CN_BODY_DYNAMIC, (float)(k % 20) * 1.1f - 11.0f, 1.0f + (float)(k / 20) * 1.1f, 0.1f * (float)k, 0.5f, 0.5f, 0.5f, 0.0f);
	for (k = 0; k < 200; ++k) {
		fixture_step(world, 1);
		counters = fixture_counters(world);
		warnings += counters.warnings != 0;
	}
	CHECK_LE("steps short of memory", warnings, 0, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
	free(raw);
}

/* Only the two that there are. */
static void t_others_are_refused(void)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.broadphase = 2;
	CHECK(cn_world_create(&def, &world) == CN_ERROR_ARGUMENT && world == NULL);
	def.broadphase = -1;
	CHECK(cn_world_create(&def, &world) == CN_ERROR_ARGUMENT && world == NULL);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_falling_hinges);
	RUN(t_pyramid);
	RUN(t_tumbler);
	RUN(t_ragdolls);
	RUN(t_mixer);
	RUN(t_car_on_a_chain);
	RUN(t_mixed_sizes_with_changes);
	RUN(t_fixed_memory_is_enough);
	RUN(t_others_are_refused);
	return test_end();
}
