/*
 * test/save/file_test.c - a world that is read from its bytes goes on bit for bit like the written one, with the game's handles, after
 * every kind of history and in memory of every kind; the bytes are the same on every machine; whatever is no written world is refused.
 */
#include "files.h"

#include "world/joints.h"
#include "save/file.h"

#define LOCKSTEP TEST_FORM(40, 14, 10)

#ifdef TEST_EMULATED
#define EMULATED 1
#else
#define EMULATED 0
#endif

/* ---- going on ---- */

static const struct journey {
	const char *scene;
	int32_t written_at;
	setting s;
} journeys[] = {
	{ "falling_hinges", 90, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "dominoes", 150, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "ragdolls", 100, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "bridge", 120, { CN_SOLVER_AUTO, TREE, 0, 1 } },
	{ "car", 60, { CN_SOLVER_AUTO, SWEEP, 0, 0 } },
	{ "mixer", 60, { CN_SOLVER_AUTO, TREE, 2, 0 } },
	{ "small_50_sleep", 300, { CN_SOLVER_AUTO, SWEEP, 0, 1 } },
	{ "pyramid", 20, { CN_SOLVER_AUTO, SWEEP, 2, 1 } },
	{ "pyramid", 70, { CN_SOLVER_AUTO, TREE, 0, 0 } },
	{ "falling_hinges", 200, { CN_SOLVER_SOFT, TREE, 2, 0 } },
	{ "small_200", 120, { CN_SOLVER_SOFT, SWEEP, 0, 1 } },
	{ "dominoes", 200, { CN_SOLVER_DIRECT, TREE, 0, 1 } },
	{ "falling_hinges", 60, { CN_SOLVER_SEQUENTIAL, SWEEP, 2, 1 } },
};

static void digests_take(scene_run *run, uint64_t digests[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP; ++k) {
		scene_steps(run, 1);
		digests[k] = digest_events(run->world);
	}
}

static int32_t same_digests(const uint64_t a[LOCKSTEP], const uint64_t b[LOCKSTEP])
{
	int32_t k;
	for (k = 0; k < LOCKSTEP && a[k] == b[k]; ++k)
		;
	return k;
}

/* The scene's world becomes the one that is read from its bytes; its own memory, with handles, stays. */
static void run_through_file(scene_run *run, const setting *s, void **block)
{
	saved f = write_world(run->world);
	cn_world *written = run->world;
	void *old = *block;
	run->world = read_into(&f, s, block);
	CHECK(writes_the_same(run->world, &f));
	cn_world_destroy(written);
	free(old);
	saved_free(&f);
}

static int32_t journey_goes_on(const scene *which, int32_t written_at, const setting *s)
{
	uint64_t straight[LOCKSTEP], read[LOCKSTEP];
	int32_t through;
	for (through = 0; through < 2; ++through) {
		scene_run run;
		void *block;
		memset(&run, 0, sizeof run);
		run.scene = which;
		run.world = world_of(which, s, &block);
		which->create(&run);
		scene_must(&run);
		scene_steps(&run, written_at);
		if (through)
			run_through_file(&run, s, &block);
		digests_take(&run, through ? read : straight);
		scene_close(&run);
		free(block);
	}
	return same_digests(straight, read);
}

static void t_a_world_that_is_read_goes_on_bit_for_bit(void)
{
	size_t k;
	for (k = 0; k < sizeof journeys / sizeof journeys[0]; ++k) {
		const struct journey *j = &journeys[k];
		int32_t same = journey_goes_on(scene_find(j->scene), j->written_at, &j->s);
		printf("  %s, solver %d, broadphase %d, workers %d, block %d: %d of %d steps alike\n", j->scene, (int)j->s.solver, (int)j->s.broadphase, (int)j->s.workers,
		       (int)j->s.in_block, (int)same, LOCKSTEP);
		CHECK(same == LOCKSTEP);
	}
}

/* Every scene of the examples that is not large. */
static void t_every_scene_goes_on(void)
{
	const setting s = { CN_SOLVER_AUTO, SWEEP, 0, 0 };
	int32_t k, scenes = 0;
	if (TEST_FORM(0, 0, 1))
		SKIP("in slow builds");
	for (k = 0; k < scene_count(); ++k) {
		const scene *which = scene_at(k);
		int32_t same;
		scene_run run;
		must(scene_open(&run, which, NULL), NULL, which->name);
		if (fixture_counters(run.world).bodies > 300) {
			scene_close(&run);
			continue;
		}
		scene_close(&run);
		same = journey_goes_on(which, 45, &s);
		if (same != LOCKSTEP)
			printf("  %s: %d of %d steps alike\n", which->name, (int)same, LOCKSTEP);
		CHECK(same == LOCKSTEP);
		++scenes;
	}
	printf("  %d of %d scenes\n", (int)scenes, (int)scene_count());
}

/* ---- what a game knows ---- */

static void t_handles_names_and_data_are_kept(void)
{
	cn_world *world = fixture_world(-10.0f, 1), *read;
	cn_body kept = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f), gone, newer, unnamed;
	cn_shape shape = fixture_first_shape(world, kept), loose = 0;
	cn_shape_def def;
	cn_polygon polygon;
	const char *name;
	uint64_t data = 0, shape_data = 0, world_data = 0;
	saved f;
	gone = fixture_box(world, CN_BODY_DYNAMIC, 3.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	unnamed = fixture_circle(world, CN_BODY_DYNAMIC, 6.0f, 1.0f, 0.5f, 0.6f, 0.0f);
	cn_shape_def_init(&def);
	must(cn_shape_create_box(world, &def, 0.4f, 0.3f, 0.05f, &loose), world, "cn_shape_create_box");
	must(cn_body_set_user_data(world, kept, 0x123456789ABCDEFu), world, "cn_body_set_user_data");
	must(cn_shape_set_user_data(world, shape, 0xFEDCBA987654321u), world, "cn_shape_set_user_data");
	must(cn_world_set_user_data(world, 0x8000000000000001u), world, "cn_world_set_user_data");
	must(cn_body_set_name(world, kept, "the one that is kept"), world, "cn_body_set_name");
	must(cn_body_destroy(world, gone), world, "cn_body_destroy");
	f = write_world(world);
	read = read_world(&f);
	CHECK(cn_body_get_user_data(read, kept, &data) == CN_OK && data == 0x123456789ABCDEFu);
	CHECK(cn_shape_get_user_data(read, shape, &shape_data) == CN_OK && shape_data == 0xFEDCBA987654321u);
	CHECK(cn_world_get_user_data(read, &world_data) == CN_OK && world_data == 0x8000000000000001u);
	CHECK(cn_body_get_name(read, kept, &name) == CN_OK && strcmp(name, "the one that is kept") == 0);
	CHECK(cn_body_get_name(read, unnamed, &name) == CN_OK && name[0] == '\0');
	CHECK(cn_shape_get_polygon(read, loose, &polygon) == CN_OK && polygon.count == 4 && polygon.radius_m == 0.05f);
	CHECK(!cn_body_is_valid(read, gone));
	/* The next things get the same handles. */
	newer = fixture_box(world, CN_BODY_DYNAMIC, 9.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	CHECK(fixture_box(read, CN_BODY_DYNAMIC, 9.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f) == newer);
	saved_free(&f);
	cn_world_destroy(world);
	cn_world_destroy(read);
}

static void mix_rough(cn_world *world, cn_shape a, cn_shape b, cn_material *mixed, void *user)
{
	(void)world;
	(void)a;
	(void)b;
	(void)user;
	mixed->rolling_resistance = 0.1f;
}

/* A ball with rolling resistance, its own or of the user's mix, sleeps in the save and in the file, and is struck after it. */
static void rows_of_a_sleeper_come_back(int32_t mixed)
{
	cn_world *worlds[3] = { fixture_world(-10.0f, 1), fixture_world(-10.0f, 1), NULL };
	cn_body ball = (fixture_floor(worlds[0], 0.6f, 0.0f), fixture_circle(worlds[0], CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
	cn_material rough;
	saved s, f;
	int32_t k;
	must(cn_shape_get_material(worlds[0], fixture_first_shape(worlds[0], ball), &rough), worlds[0], "cn_shape_get_material");
	rough.rolling_resistance = mixed ? 0.0f : 0.1f;
	must(cn_shape_set_material(worlds[0], fixture_first_shape(worlds[0], ball), &rough), worlds[0], "cn_shape_set_material");
	must(cn_world_set_material_mix_callback(worlds[0], mixed ? mix_rough : NULL, NULL), worlds[0], "callback");
	fixture_step(worlds[0], 120);
	CHECK(!fixture_is_awake(worlds[0], ball));
	s = save_world(worlds[0]);
	f = write_world(worlds[0]);
	restore_world(worlds[1], &s);
	worlds[2] = read_world(&f);
	for (k = 0; k < 3; ++k) {
		must(cn_body_apply_impulse(worlds[k], ball, 3.0f, 0.0f), worlds[k], "cn_body_apply_impulse");
		fixture_step(worlds[k], 120);
		CHECK_LE("speed of the ball", fabs((double)fixture_velocity(worlds[k], ball).linear_mps.x), 0.01, "m/s");
		CHECK(fixture_hash(worlds[k]) == fixture_hash(worlds[0]));
	}
	for (k = 0; k < 3; ++k)
		cn_world_destroy(worlds[k]);
	saved_free(&s);
	saved_free(&f);
}

static void t_rows_of_sleepers_come_back(void)
{
	rows_of_a_sleeper_come_back(0);
	rows_of_a_sleeper_come_back(1);
}

/* Forces, kicks, pending events, owed time, boxes that have changed: all that calls have left for the next step. */
static void t_what_calls_have_left_is_kept(void)
{
	cn_world *worlds[2] = { NULL, NULL };
	uint64_t hashes[2][LOCKSTEP];
	cn_body falling, heap[6];
	saved f;
	int32_t k, w;
	worlds[0] = fixture_world(-10.0f, 1);
	fixture_floor(worlds[0], 0.6f, 0.0f);
	for (k = 0; k < 6; ++k)
		heap[k] = fixture_box(worlds[0], CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	falling = fixture_circle(worlds[0], CN_BODY_DYNAMIC, 5.0f, 9.0f, 0.5f, 0.6f, 0.5f);
	fixture_step(worlds[0], 30);
	must(cn_world_update(worlds[0], 0.024f, NULL), worlds[0], "cn_world_update");
	must(cn_body_apply_force(worlds[0], falling, 30.0f, 4.0f), worlds[0], "cn_body_apply_force");
	must(cn_body_set_velocity(worlds[0], heap[5], 3.0f, 0.0f, 1.0f), worlds[0], "cn_body_set_velocity");
	must(cn_body_destroy(worlds[0], heap[2]), worlds[0], "cn_body_destroy");
	must(cn_body_set_pose(worlds[0], heap[4], 0.3f, 4.0f, 0.2f), worlds[0], "cn_body_set_pose");
	fixture_box(worlds[0], CN_BODY_DYNAMIC, 0.1f, 9.0f, 0.3f, 0.5f, 0.5f, 0.6f, 0.0f);
	f = write_world(worlds[0]);
	worlds[1] = read_world(&f);
	for (w = 0; w < 2; ++w)
		for (k = 0; k < LOCKSTEP; ++k) {
			must(cn_world_update(worlds[w], 0.011f, NULL), worlds[w], "cn_world_update");
			hashes[w][k] = digest_events(worlds[w]);
		}
	printf("  %d of %d updates alike\n", (int)same_digests(hashes[0], hashes[1]), LOCKSTEP);
	CHECK(same_digests(hashes[0], hashes[1]) == LOCKSTEP);
	saved_free(&f);
	cn_world_destroy(worlds[0]);
	cn_world_destroy(worlds[1]);
}

static uint64_t written_bytes(cn_world *world)
{
	saved f = write_world(world);
	uint64_t sum = cni_file_checksum((const uint8_t *)f.data, f.bytes);
	saved_free(&f);
	return sum;
}

/* ---- a random life ---- */

#define LIVES TEST_MANY(40)
#define CHANGES 60

static cn_body random_body(cn_world *world, int32_t round, float x, float y, float size)
{
	cn_body body = round ? fixture_circle(world, CN_BODY_DYNAMIC, x, y, size, 0.5f, 0.2f) : fixture_box(world, CN_BODY_DYNAMIC, x, y, x, size, 0.4f, 0.5f, 0.0f);
	cn_material material;
	must(cn_shape_get_material(world, fixture_first_shape(world, body), &material), world, "cn_shape_get_material");
	material.rolling_resistance = size > 0.5f ? 0.05f : 0.0f;
	must(cn_shape_set_material(world, fixture_first_shape(world, body), &material), world, "cn_shape_set_material");
	return body;
}

static void random_change(cn_world *world, uint32_t *random, cn_body *bodies, int32_t *count)
{
	int32_t kind = (int32_t)fixture_random(random, 0.0f, 7.99f), at = *count > 0 ? (int32_t)fixture_random(random, 0.0f, (float)*count - 0.01f) : 0;
	float x = fixture_random(random, -4.0f, 4.0f), y = fixture_random(random, 0.5f, 8.0f), size = fixture_random(random, 0.2f, 0.6f);
	cn_revolute_def pin;
	cn_joint joint;
	if (kind <= 2 && *count < 40)
		bodies[(*count)++] = random_body(world, kind == 0, x, y, size);
	else if (*count < 2)
		return;
	else if (kind == 3) {
		must(cn_body_destroy(world, bodies[at]), world, "cn_body_destroy");
		bodies[at] = bodies[--*count];
	} else if (kind == 4) {
		must(cn_body_set_velocity(world, bodies[at], x, y, size), world, "cn_body_set_velocity");
	} else if (kind == 5) {
		must(cn_body_set_flags(world, bodies[at], CN_BODY_SLEEP | (x > -1.0f ? (uint32_t)CN_BODY_ENABLED : 0u)), world, "cn_body_set_flags");
	} else if (kind == 6) {
		must(cn_body_set_type(world, bodies[at], x > 1.0f ? CN_BODY_KINEMATIC : CN_BODY_DYNAMIC), world, "cn_body_set_type");
	} else {
		cn_revolute_def_init(&pin);
		pin.base.body_a = bodies[at];
		pin.base.body_b = bodies[(at + 1) % *count];
		pin.base.break_force_N = 500.0f;
		(void)cn_joint_create_revolute(world, &pin, &joint); /* refused for two kinematic bodies */
	}
}

/* The life of a world, written and read after every `every` changes; 0: never. *bytes: checksum of what it writes at the end. */
static uint64_t random_life(uint32_t seed, int32_t every, uint64_t *bytes)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[40];
	uint64_t digest = 0, now;
	int32_t count = 0, change;
	fixture_floor(world, 0.6f, 0.0f);
	for (change = 1; change <= CHANGES; ++change) {
		random_change(world, &seed, bodies, &count);
		if (every > 0 && change % every == 0) {
			saved f = write_world(world);
			cn_world_destroy(world);
			world = read_world(&f);
			saved_free(&f);
		}
		fixture_step(world, 1 + change % 5);
		now = digest_events(world);
		digest = digest_bytes(digest, &now, sizeof now);
	}
	CHECK(fixture_is_valid(world));
	*bytes = written_bytes(world);
	cn_world_destroy(world);
	return digest;
}

static void t_random_lives_go_on_through_files(void)
{
	uint64_t bytes[2];
	uint32_t seed;
	int32_t same = 0, same_bytes = 0;
	for (seed = 1; seed <= LIVES; ++seed) {
		same += random_life(seed, 0, &bytes[0]) == random_life(seed, 1 + (int32_t)seed % 3, &bytes[1]);
		same_bytes += bytes[0] == bytes[1];
	}
	printf("  %d of %d lives alike, %d write the same bytes\n", (int)same, LIVES, (int)same_bytes);
	CHECK(same == LIVES && same_bytes == LIVES);
}

/* ---- equal worlds write equal bytes ---- */

/* Does the world, after these steps, write the bytes of one that is read from it now? The body is woken in both. Destroys the world. */
static int32_t writes_what_its_copy_writes(cn_world *world, cn_body body, int32_t steps)
{
	saved f = write_world(world);
	cn_world *worlds[2] = { world, read_world(&f) };
	uint64_t bytes[2];
	int32_t k;
	for (k = 0; k < 2; ++k) {
		must(cn_body_set_awake(worlds[k], body, 1), worlds[k], "cn_body_set_awake");
		fixture_step(worlds[k], steps);
		bytes[k] = written_bytes(worlds[k]);
		cn_world_destroy(worlds[k]);
	}
	saved_free(&f);
	return bytes[0] == bytes[1];
}

/* The lanes of soft joints are kept from step to step, and found anew after reading. */
static void t_a_soft_net_writes_equal_bytes(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body = 0, before = fixture_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f, 0.2f, 0.1f, 0.6f, 0.0f);
	int32_t k;
	must(cn_world_set_solver(world, CN_SOLVER_SOFT), world, "cn_world_set_solver");
	for (k = 1; k <= 10; ++k, before = body) {
		cn_joint joint;
		cn_revolute_def pin;
		cn_revolute_def_init(&pin);
		body = fixture_box(world, CN_BODY_DYNAMIC, 0.5f * (float)k, 0.0f, 0.0f, 0.2f, 0.1f, 0.6f, 0.0f);
		pin.base.body_a = before;
		pin.base.body_b = body;
		pin.base.anchor_a_m.x = 0.25f;
		pin.base.anchor_b_m.x = -0.25f;
		must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
	}
	fixture_step(world, 20);
	CHECK(writes_what_its_copy_writes(world, body, 1));
}

/* A box without rolling resistance slept beside a ball with it, which is gone. */
static void t_a_sleeper_writes_equal_bytes(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body floor = fixture_floor(world, 0.6f, 0.0f), ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_body box = fixture_box(world, CN_BODY_DYNAMIC, 5.0f, 0.7f, 0.5f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_material rough;
	must(cn_shape_get_material(world, fixture_first_shape(world, ball), &rough), world, "cn_shape_get_material");
	rough.rolling_resistance = 0.1f;
	must(cn_shape_set_material(world, fixture_first_shape(world, ball), &rough), world, "cn_shape_set_material");
	fixture_step(world, 300);
	must(cn_body_destroy(world, ball), world, "cn_body_destroy");
	CHECK(floor != 0 && !fixture_is_awake(world, box));
	CHECK(writes_what_its_copy_writes(world, box, 300));
}

/* ---- the same bytes everywhere ---- */

/* Golden: the checksum of the bytes after some steps of a small world, and of all steps of the world that is read from them. */
#define GOLDEN_BYTES 0x35a59ec3ec34b9ecu
#define GOLDEN_STEPS 0xc8578b372ac77d7eu

static void t_the_bytes_are_the_same_everywhere(void)
{
	cn_world *world = zoo_world(), *read;
	saved f = write_world(world);
	uint64_t bytes = cni_file_checksum((const uint8_t *)f.data, f.bytes), steps = 0, hash;
	int32_t k;
	read = read_world(&f);
	for (k = 0; k < 60; ++k) {
		fixture_step(read, 1);
		hash = fixture_hash(read);
		for (int32_t byte = 0; byte < 8; ++byte)
			steps = (steps ^ (hash >> 8 * byte & 0xFFu)) * 0x100000001B3u;
	}
	printf("  %d bytes: %016llx, steps %016llx\n", (int)f.bytes, (unsigned long long)bytes, (unsigned long long)steps);
	CHECK(test_golden_holds(bytes, GOLDEN_BYTES));
	CHECK(test_golden_holds(steps, GOLDEN_STEPS));
	saved_free(&f);
	cn_world_destroy(world);
	cn_world_destroy(read);
}

/* ---- completeness ---- */

/* A new member of a record, cn_world among them, must be put into its list in src/save/file_fields.c. Counted where records have no padding. */
static int32_t is_named(const cni_record *record, int32_t offset)
{
	int32_t k;
	for (k = 0; k < record->count; ++k) {
		const cni_field *field = &record->fields[k];
		if (offset >= field->offset && offset < field->offset + (int32_t)(field->count * CNI_FIELD_BYTES(field->kind)))
			return 1;
	}
	return 0;
}

static void t_every_member_is_known(void)
{
	const cni_record *record;
	int32_t kinds, offset, unknown = 0;
	if (sizeof(void *) != 8)
		SKIP("pointers of 8 bytes only");
	for (kinds = 0; (record = cni_file_kind(kinds)) != NULL; ++kinds) {
		for (offset = 0; offset < record->bytes; ++offset) {
			if (is_named(record, offset))
				continue;
			if (unknown++ == 0)
				printf("  first unknown byte: record %d, offset %d\n", (int)kinds, (int)offset);
		}
	}
	CHECK_GE("kinds of records", kinds, 31, "");
	CHECK_LE("bytes that no field names", unknown, 0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_the_bytes_are_the_same_everywhere);
	if (EMULATED)
		return test_end(); /* the other tests say nothing about a processor */
	RUN(t_a_world_that_is_read_goes_on_bit_for_bit);
	RUN(t_every_scene_goes_on);
	RUN(t_handles_names_and_data_are_kept);
	RUN(t_what_calls_have_left_is_kept);
	RUN(t_rows_of_sleepers_come_back);
	RUN(t_random_lives_go_on_through_files);
	RUN(t_a_soft_net_writes_equal_bytes);
	RUN(t_a_sleeper_writes_equal_bytes);
	RUN(t_every_member_is_known);
	return test_end();
}
