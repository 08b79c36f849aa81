/*
 * test/examples/record_test.c - a recording plays to the same bits, wherever it is entered; the first difference is found and named; one
 * that ends anywhere plays to there.
 */
#include "../../bindings/record/cairn_record.h"
#include "record/player.h"
#include "record/record.h"
#include "../world/fixture.h"

#define STEPS 240

static uint64_t hashes[STEPS + 1];
static cn_body thrown;

/* Calls of many kinds. cairn_record.h came first: they are recorded under their own names. */
static cn_body add_box(cn_world *world, float x, float y, const char *name)
{
	cn_body_def def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&def);
	def.position_m.x = x;
	def.position_m.y = y;
	def.name = name;
	must(cn_body_create(world, &def, &body), world, "cn_body_create");
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	must(cn_shape_create_box(world, &shape_def, 0.4f, 0.4f, 0.0f, NULL), world, "cn_shape_create_box");
	return body;
}

static void add_ground(cn_world *world)
{
	cn_vec2 points[3] = { { 9.0f, 0.0f }, { 0.0f, -0.2f }, { -9.0f, 0.0f } };
	cn_chain chain = { points, 3, 0 };
	cn_shape_def def;
	cn_shape_def_init(&def);
	def.body = fixture_body(world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f);
	must(cn_shape_create_chain(world, &def, &chain, NULL), world, "cn_shape_create_chain");
}

static void add_many(cn_world *world)
{
	cn_body_def defs[4];
	cn_body bodies[4];
	cn_velocity velocities[4];
	cn_revolute_def pin;
	cn_joint joint = 0;
	int32_t k;
	for (k = 0; k < 4; ++k) {
		cn_body_def_init(&defs[k]);
		defs[k].position_m.x = -3.0f + (float)k;
		defs[k].position_m.y = 6.0f;
		velocities[k].linear_mps.x = (float)k;
		velocities[k].linear_mps.y = velocities[k].angular_radps = 0.0f;
	}
	must(cn_body_create_many(world, defs, 4, bodies), world, "cn_body_create_many");
	must(cn_world_write_velocities(world, bodies, 4, velocities), world, "cn_world_write_velocities");
	cn_revolute_def_init(&pin);
	pin.base.body_a = bodies[0];
	pin.base.body_b = bodies[1];
	must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
	must(cn_body_destroy_many(world, bodies + 2, 2), world, "cn_body_destroy_many");
	CHECK(cn_body_destroy(world, bodies[3]) == CN_ERROR_HANDLE); /* recorded too */
	CHECK(cn_body_create(world, NULL, bodies) == CN_ERROR_ARGUMENT && cn_body_set_name(world, bodies[0], NULL) == CN_OK);
}

static void game_step(cn_world *world, int32_t step)
{
	cn_update_report report;
	if (step == 60)
		must(cn_body_set_velocity(world, thrown, 9.0f, 2.0f, 1.0f), world, "cn_body_set_velocity");
	if (step == 100)
		add_many(world);
	if (step % 16 == 3)
		must(cn_world_update(world, 0.0167f, &report), world, "cn_world_update");
	else
		must(cn_world_step(world, FRAME_S), world, "cn_world_step");
}

/* A game of STEPS steps with a rollback on the way. */
static coding_out recorded_game(int32_t recorded)
{
	const record_options options = { 10, 50 };
	coding_out out = { NULL, 0, 0, 0 };
	cn_world *world = fixture_world(-10.0f, 1);
	void *save;
	uint64_t bytes;
	int32_t k;
	add_ground(world);
	if (recorded)
		CHECK(record_begin(world, &options, record_to_memory, &out));
	for (k = 0; k < 12; ++k)
		add_box(world, 2.0f + 0.85f * (float)(k % 3), 0.5f + 0.85f * (float)(k / 3), "box");
	thrown = add_box(world, -6.0f, 2.0f, "thrown");
	hashes[0] = fixture_hash(world);
	for (k = 0; k < STEPS; ++k) {
		if (k == 150) {
			must(cn_world_save_size(world, &bytes), world, "cn_world_save_size");
			save = malloc((size_t)bytes);
			must(cn_world_save(world, save, bytes, NULL), world, "cn_world_save");
			must(cn_body_apply_impulse(world, thrown, 5.0f, 50.0f), world, "cn_body_apply_impulse"); /* the restore takes it back */
			must(cn_world_restore(world, save, bytes), world, "cn_world_restore");
			free(save);
		}
		game_step(world, k);
		hashes[k + 1] = fixture_hash(world);
	}
	cn_world_destroy(world);
	CHECK(!out.failed);
	return out;
}

static void t_a_recording_plays_to_the_same_bits(void)
{
	coding_out out = recorded_game(1);
	int32_t same = 0, k;
	player p;
	REQUIRE(player_open(&p, NULL, out.bytes, out.count));
	CHECK(p.step_count == STEPS);
	for (k = 1; player_step(&p) && k <= STEPS; ++k)
		same += fixture_hash(p.world) == hashes[k];
	printf("  %d of %d steps alike, %d calls, %d checks, %d bytes; %s\n", (int)same, STEPS, (int)p.calls, (int)p.checks, (int)out.count, p.differs ? p.report : "no difference");
	CHECK(same == STEPS && !p.differs && !p.broken && p.checks >= STEPS / 10);
	player_close(&p);
	coding_free(&out);
}

static void t_every_step_can_be_sought(void)
{
	coding_out out = recorded_game(1);
	uint32_t random = 5;
	int32_t k;
	player p;
	REQUIRE(player_open(&p, NULL, out.bytes, out.count));
	for (k = 0; k < 25; ++k) {
		uint64_t step = 1 + (uint64_t)fixture_random(&random, 0.0f, (float)STEPS - 1.0f);
		CHECK(player_seek(&p, step) && p.step == step && fixture_hash(p.world) == hashes[step]);
	}
	CHECK(player_seek(&p, STEPS) && !player_seek(&p, STEPS + 1) && !p.differs);
	player_close(&p);
	coding_free(&out);
}

/* The recorded velocity of the thrown box gets another bit. */
static void t_the_first_difference_is_named(void)
{
	coding_out out = recorded_game(1);
	const int32_t call = call_find("cn_body_set_velocity");
	uint64_t at = 8, changed = 0;
	player p;
	while (at + 9 < out.count) {
		coding_in in = coding_begin(out.bytes + at, 11);
		int32_t kind = (int32_t)coding_get(&in, 1);
		uint64_t count = coding_get(&in, 8);
		if (kind == RECORD_CALL && (int32_t)coding_get(&in, 2) == call)
			changed = at + 9 + 2 + 4; /* index, body, linear x */
		at += 9 + count;
	}
	REQUIRE(changed != 0);
	out.bytes[changed] ^= 1u;
	REQUIRE(player_open(&p, NULL, out.bytes, out.count));
	while (player_step(&p) && !p.differs)
		;
	printf("  %s\n", p.report);
	CHECK(p.differs && p.report_step == 70 && strstr(p.report, "\"thrown\"") != NULL && strstr(p.report, "velocity x") != NULL);
	player_close(&p);
	coding_free(&out);
}

static void t_a_recording_that_ends_anywhere_plays_to_there(void)
{
	coding_out out = recorded_game(1);
	uint64_t count;
	int32_t opened = 0, differs = 0;
	for (count = 0; count < out.count; count += 1 + out.count / 60) {
		uint8_t *part = (uint8_t *)malloc((size_t)count + 1);
		player p;
		memcpy(part, out.bytes, (size_t)count);
		if (player_open(&p, NULL, part, count)) {
			++opened;
			while (player_step(&p))
				;
			differs += p.differs;
		}
		player_close(&p);
		free(part);
	}
	printf("  %d opened, %d differ\n", (int)opened, (int)differs);
	CHECK(opened > 30 && differs == 0);
	coding_free(&out);
}

static void t_recording_changes_nothing(void)
{
	uint64_t recorded[STEPS + 1];
	coding_out out = recorded_game(1), none;
	memcpy(recorded, hashes, sizeof hashes);
	none = recorded_game(0);
	CHECK(memcmp(recorded, hashes, sizeof hashes) == 0 && none.count == 0);
	coding_free(&out);
}

static int32_t refused;

static void meddle(cn_world *world, const cn_contact_event *event, void *user)
{
	(void)world;
	(void)event;
	refused += cn_world_step((cn_world *)user, FRAME_S) == CN_ERROR_LOCKED && cn_body_destroy((cn_world *)user, thrown) == CN_ERROR_LOCKED;
	cn_world_destroy((cn_world *)user); /* does nothing, and does not end the recording */
}

/* What a callback calls is refused; in a replay, which has no callbacks, nothing would refuse it. */
static void t_calls_from_callbacks_are_not_recorded(void)
{
	coding_out out = { NULL, 0, 0, 0 };
	cn_world *world = fixture_world(-10.0f, 1);
	player p;
	int32_t k;
	add_ground(world);
	CHECK(record_begin(world, NULL, record_to_memory, &out));
	thrown = add_box(world, 0.0f, 1.0f, "falls");
	must(cn_world_set_contact_callback(world, CN_EVENT_ENTER, meddle, world), world, "cn_world_set_contact_callback");
	for (k = 0; k < 60; ++k)
		must(cn_world_step(world, FRAME_S), world, "cn_world_step");
	cn_world_destroy(world);
	CHECK(refused >= 1);
	REQUIRE(player_open(&p, NULL, out.bytes, out.count));
	CHECK(p.step_count == 60);
	while (player_step(&p))
		continue;
	printf("  %d refused; %s\n", (int)refused, p.differs ? p.report : "no difference");
	CHECK(!p.differs && !p.broken && p.checks >= 2);
	player_close(&p);
	coding_free(&out);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_recording_plays_to_the_same_bits);
	RUN(t_every_step_can_be_sought);
	RUN(t_the_first_difference_is_named);
	RUN(t_a_recording_that_ends_anywhere_plays_to_there);
	RUN(t_recording_changes_nothing);
	RUN(t_calls_from_callbacks_are_not_recorded);
	return test_end();
}
