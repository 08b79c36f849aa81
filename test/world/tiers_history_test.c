/*
 * test/world/tiers_history_test.c - what the choice of an island's solver remembers: refusals, stays, what interior points cost, through
 * merging and splitting.
 *
 * If a test here fails, run world/tiers first. Then look in: direct/solver_selection.c (refusals, stays), model/island.c (merging),
 * direct/direct_contact.h (what an island owes), direct/direct_contacts.c (admission), direct/contact_active_set.c (sliding).
 */
#include "tiers.h"

/* ------------------------------------------------------------------ what is known of an island */

static int32_t island_number(const cn_world *world, cn_body body)
{
	return cni_body_at(world, cni_handles_find(&world->body_handles, body))->island;
}

static cni_island *island_of(const cn_world *world, cn_body body)
{
	return cni_island_at(world, island_number(world, body));
}

/* What could not be solved directly, and how long it is to stay so, is known of what it becomes a part of, and of its parts. */
static void t_islands_that_meet_or_part_keep_what_is_known(void)
{
	int32_t k;
	for (k = 0; k < 2; ++k) { /* the one that has a past is the smaller, and the larger */
		cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
		cn_body old = stack(world, 0.0f, k == 0 ? 2 : 3, NULL), young = stack(world, 10.0f, 4 - k, NULL);
		cni_island *i, *other;
		uint32_t now;
		fixture_step(world, 3);
		now = world->step_count;
		i = island_of(world, old);
		other = island_of(world, young);
		i->tier = other->tier = CNI_TIER_SOFT;
		i->refused_step = now - 400u;
		i->refused_steps = 500; /* 100 are left */
		i->reason = CN_TIER_REASON_NO_SET;
		i->stay_steps = 60;
		i->given_step = now - 7u;
		i->unheld_step = now - 1u;
		i->cone_step = now - 3u;
		i->cone_spent = 1000; /* 100 steps ago: what is left is less than the other's */
		i->cone_paid_step = now - 100u;
		other->refused_step = now - 1u;
		other->refused_steps = 50;
		other->reason = CN_TIER_REASON_MOVING;
		other->stay_steps = 15;
		other->given_step = now - 2u;
		other->unheld_step = now - 2u;
		other->cone_step = 0;
		other->cone_spent = 900;
		other->cone_paid_step = now;
		REQUIRE(cni_island_reserve(world, 1));
		cni_island_link(world, cni_handles_find(&world->body_handles, old), cni_handles_find(&world->body_handles, young));
		i = island_of(world, young);
		CHECK(i == island_of(world, old) && i->count == 6);
		CHECK(i->refused_step == now - 400u && i->refused_steps == 500 && i->reason == CN_TIER_REASON_NO_SET);
		CHECK(i->stay_steps == 60 && i->given_step == now - 7u);
		CHECK(i->unheld_step == now - 1u && i->cone_step == now - 3u);
		CHECK(cni_cone_debt(world, i) == 900);
		REQUIRE(cni_island_split(world, island_number(world, old)));
		CHECK(island_number(world, old) != island_number(world, young));
		for (other = island_of(world, old); other != NULL; other = other == island_of(world, old) ? island_of(world, young) : NULL) {
			CHECK(other->refused_step == now - 400u && other->refused_steps == 500);
			CHECK(other->stay_steps == 60 && other->given_step == now - 7u);
			CHECK(other->unheld_step == now - 1u && other->cone_step == now - 3u);
		}
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* Each time for twice as long, up to 32 s; and as the first time when that is long ago. */
static void t_refusals_last_longer_each_time(void)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	cn_body first;
	cni_island *i;
	int32_t k, wrong = 0, expected = 120;
	fixture_floor(world, 0.6f, 0.0f);
	first = stack(world, 0.0f, 3, NULL);
	fixture_step(world, 2);
	i = island_of(world, first);
	for (k = 0; k < 8; ++k) {
		cni_island_refuse(world, island_number(world, first), CN_TIER_REASON_WORK);
		wrong += i->refused_steps != expected || !cni_island_is_refused(i, world->step_count + (uint32_t)expected - 1u) ||
		         cni_island_is_refused(i, world->step_count + (uint32_t)expected);
		expected = expected < 960 ? 2 * expected : 1920;
	}
	CHECK_LE("refusals of another length than twice the last", wrong, 0, "");
	i->refused_step = world->step_count - 8u * 1920u - 1u;
	cni_island_refuse(world, island_number(world, first), CN_TIER_REASON_WORK);
	CHECK(i->refused_steps == 120);
	cn_world_destroy(world);
}

/* Steps until an island is soft again. */
static int32_t steps_direct(cn_world *world)
{
	int32_t k;
	for (k = 0; k < 2000; ++k) {
		fixture_step(world, 1);
		if (report(world).tier == CN_TIER_SOFT)
			break;
	}
	return k;
}

/* The stay grows fourfold each time that an island turns bad again soon. */
static void t_what_turns_bad_again_stays_longer(void)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	cn_body top;
	int32_t k, steps[3];
	fixture_floor(world, 0.6f, 0.0f);
	stack(world, 0.0f, 3, &top);
	for (k = 0; k < 3; ++k) {
		steps[k] = steps_direct(world);
		must(cn_body_set_pose(world, top, 0.0f, 2.49f, 0.0f), world, "cn_body_set_pose"); /* deeper than the accuracy */
	}
	printf("  steps: %d, %d, %d\n", (int)steps[0], (int)steps[1], (int)steps[2]);
	CHECK_GE("second stay", steps[1], 60, "steps");
	CHECK_LE("second stay", steps[1], 80, "steps");
	CHECK_GE("third stay", steps[2], 240, "steps");
	CHECK_LE("third stay", steps[2], 260, "steps");
	cn_world_destroy(world);
}

/* No more than 64 at a time; the others wait for their turn, and are told to be crowded out. */
static void t_so_many_islands_at_a_time(void)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, 1000000);
	cn_island_report list[100];
	int32_t k, count = 0, direct = 0, crowded = 0;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 90; ++k) {
		fixture_box(world, CN_BODY_DYNAMIC, 2.0f * (float)k - 90.0f, 0.49f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		fixture_box(world, CN_BODY_DYNAMIC, 2.0f * (float)k - 90.0f, 1.47f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	}
	fixture_step(world, 1);
	must(cn_world_get_islands(world, list, 100, &count), world, "cn_world_get_islands");
	REQUIRE(count == 90);
	for (k = 0; k < count; ++k) {
		direct += list[k].tier == CN_TIER_DIRECT;
		crowded += list[k].tier == CN_TIER_SOFT && list[k].reason == CN_TIER_REASON_CROWDED;
	}
	CHECK(direct == 64 && crowded == 26 && fixture_counters(world).islands_direct == 64);
	fixture_step(world, 600);
	CHECK(fixture_counters(world).islands_direct == 0);
	cn_world_destroy(world);
}

/* The loads of what falls after all are forgotten, those of both points of each contact. */
static void t_what_falls_forgets_its_loads(void)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	cn_body first;
	cni_island *i;
	int32_t block, l, p, loaded = 0, left = 0;
	fixture_floor(world, 0.6f, 0.0f);
	first = stack(world, 0.0f, 3, NULL);
	fixture_step(world, 5);
	i = island_of(world, first);
	REQUIRE(i->tier == CNI_TIER_DIRECT);
	for (block = 0; block < world->block_used; ++block)
		for (l = 0; l < CNI_LANES; ++l)
			for (p = 0; p < 2 && cni_block_info_at(world, block)->color != CNI_NONE; ++p)
				loaded += cni_block_at(world, block)->p[p].load[l] != 0.0f;
	i->gives_step = world->step_count;
	i->falls_steps = 3;
	cni_island_refuse(world, island_number(world, first), CN_TIER_REASON_MOVING);
	for (block = 0; block < world->block_used; ++block)
		for (l = 0; l < CNI_LANES; ++l)
			for (p = 0; p < 2 && cni_block_info_at(world, block)->color != CNI_NONE; ++p)
				left += cni_block_at(world, block)->p[p].load[l] != 0.0f;
	CHECK(loaded == 6 && left == 0);
	cn_world_destroy(world);
}

/* Presses the contacts of the stack by 20,000 weights, and says that it was refused in this step. Returns by how many weights the solver
   for the next step presses. */
static double weights_after(int32_t reason)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	float h = 0.25f * FRAME_S;
	double most = 0.0;
	cn_body first;
	int32_t block, l;
	fixture_floor(world, 0.6f, 0.0f);
	first = stack(world, 0.0f, 3, NULL);
	fixture_step(world, 5);
	CHECK(island_of(world, first)->tier == CNI_TIER_DIRECT);
	for (block = 0; block < world->block_used; ++block)
		for (l = 0; l < CNI_LANES; ++l)
			if (cni_block_at(world, block)->p[0].jn[l] > 0.0f)
				cni_block_at(world, block)->p[0].jn[l] = 20000.0f * 10.0f * h;
	cni_island_refuse(world, island_number(world, first), reason);
	cni_stage_select_solvers(world, h);
	for (block = 0; block < world->block_used; ++block)
		for (l = 0; l < CNI_LANES; ++l)
			most = fmax(most, (double)(cni_block_at(world, block)->p[0].jn[l] / (10.0f * h)));
	cn_world_destroy(world);
	return most;
}

/* One part of an island may have a solution that presses a body from both sides by any force, while another part has none: soft constraints
   would start from it, and throw the body. */
static void t_what_has_no_set_presses_no_harder_than_soft_contacts_bear(void)
{
	CHECK_LE("weights after a solution was not found", weights_after(CN_TIER_REASON_NO_SET), 301.0, "weights");
	CHECK_GE("... after it fell", weights_after(CN_TIER_REASON_MOVING), 19999.0, "weights");
}

/* A row of three boxes between kinematic bodies that close at 4 cm/s has no set after some steps. The soft solver goes on from impulses that are in
   balance; where each was reduced by what the lighter of its bodies bears, the middle box left at up to 6.2 m/s in 24 of 40 rows. */
static void t_what_is_squeezed_is_not_thrown(void)
{
	double fastest = 0.0;
	int32_t row, k, i, unsolved = 0;
	for (row = 0; row < 40; ++row) {
		cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
		cn_body boxes[3];
		for (i = 0; i < 5; ++i) {
			cn_body body = fixture_body(world, i < 3 ? CN_BODY_DYNAMIC : CN_BODY_KINEMATIC, i < 3 ? 0.2f * (float)(i - 1) : i == 3 ? -0.5f : 0.5f, 1.0f, 0.0f);
			cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
			def.density_kgpm2 = 100.0f * (i == 1 ? powf(2.0f, (float)(row % 8) - 3.5f) : i == 2 ? powf(3.0f, (float)(row / 8 - 2)) : 1.0f);
			fixture_box_shape(world, &def, i < 3 ? 0.1f : 0.2f, i < 3 ? 0.3f : 0.4f);
			if (i < 3)
				boxes[i] = body;
			else
				fixture_set_velocity(world, body, i == 3 ? 0.02f : -0.02f, 0.0f, 0.0f);
		}
		for (k = 0; k < 60; ++k) {
			fixture_step(world, 1);
			unsolved += fixture_counters(world).islands_unsolved;
			for (i = 0; i < 3; ++i) {
				cn_velocity v;
				must(cn_body_get_velocity(world, boxes[i], &v), world, "cn_body_get_velocity");
				fastest = fmax(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
			}
		}
		cn_world_destroy(world);
	}
	CHECK_GE("steps without a set", unsolved, 100, "");
	CHECK_LE("the fastest box", fastest, 0.2, "m/s");
}

/* A column of 4 to 10 boxes of some 0.3 to 1 kg under one of 1,000 to 1e6 kg that falls on it: the fastest of them in 2.5 s. With a blow, it
   stands, and one of them gets 6 m/s after 1.5 s, when what stands is at rest. */
static double load_column(uint32_t seed, int32_t blow)
{
	double fastest = 0.0;
	float y = 0.0f, friction, dt = 1.0f / (30.0f + 30.0f * (float)(seed % 2u));
	cn_body boxes[11];
	cn_world_def world_def;
	cn_world *world = NULL;
	int32_t i, step, count, hit = (int32_t)(1.5f / dt);
	cn_world_def_init(&world_def);
	world_def.substep_count = 2 + 2 * (int32_t)(seed / 2u % 2u);
	must(cn_world_create(&world_def, &world), NULL, "cn_world_create");
	friction = fixture_random(&seed, 0.3f, 1.0f);
	fixture_floor(world, friction, 0.0f);
	count = (int32_t)fixture_random(&seed, 4.0f, 11.0f);
	for (i = 0; i <= count; ++i) {
		float height = i < count ? fixture_random(&seed, 0.1f, 0.4f) : 0.3f;
		float above = i < count || blow ? 0.0f : fixture_random(&seed, 0.0f, 1.5f), x = fixture_random(&seed, -0.05f, 0.05f);
		boxes[i] = fixture_body(world, CN_BODY_DYNAMIC, x, y + height + above, 0.0f);
		cn_shape_def def = fixture_shape_def(boxes[i], friction, 0.0f);
		def.density_kgpm2 = i < count ? 1.0f : powf(10.0f, fixture_random(&seed, 3.0f, 6.0f));
		fixture_box_shape(world, &def, fixture_random(&seed, 0.4f, 0.7f), height);
		y += 2.0f * height;
	}
	for (step = 0; (float)step * dt < 2.5f; ++step) {
		if (blow && step == hit)
			fixture_set_velocity(world, boxes[count / 2], 6.0f, 0.0f, 0.0f);
		must(cn_world_step(world, dt), world, "cn_world_step");
		for (i = 0; i <= count; ++i) {
			cn_velocity v = fixture_velocity(world, boxes[i]);
			fastest = fmax(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
		}
	}
	cn_world_destroy(world);
	return fastest;
}

/* Exact impulses on both sides of a light body are thousands of its weights, and cancel. The soft solver began with them where such a column fell, cost too
   much or had a joint, and where one at rest was struck. */
static void t_what_bears_much_is_not_thrown(void)
{
	double fastest[2] = { 0.0, 0.0 };
	for (uint32_t k = 0; k < TEST_FORM(120u, 60u, 12u); ++k)
		fastest[k % 2u] = fmax(fastest[k % 2u], load_column(k / 2u + 1u, (int32_t)(k % 2u)));
	CHECK_LE("the fastest box of columns that fall", fastest[0], 50.0, "m/s");
	CHECK_LE("the fastest box of columns that are struck", fastest[1], 50.0, "m/s");
}

/* A column of six boxes of 0.5 to 16 kg that a kinematic plate presses 20 to 60 mm too far, falls asleep so, and is let go: the fastest box from then on.
   Its steps without a solution are added to *unsolved. */
static double press_and_let_go(uint32_t seed, int32_t *unsolved)
{
	float dt = 1.0f / 30.0f, speed = 0.2f;
	double fastest = 0.0;
	cn_body boxes[6], press;
	cn_world_def world_def;
	cn_world *world = NULL;
	int32_t i, step, stops, goes;
	cn_world_def_init(&world_def);
	world_def.substep_count = 2;
	must(cn_world_create(&world_def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < 7; ++i) {
		cn_body body = fixture_body(world, i < 6 ? CN_BODY_DYNAMIC : CN_BODY_KINEMATIC, i < 6 ? 0.0f : fixture_random(&seed, 0.0f, 0.1f), i < 6 ? 0.25f + 0.5f * (float)i : 3.22f, 0.0f);
		cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
		def.density_kgpm2 = powf(10.0f, fixture_random(&seed, 0.0f, 1.5f));
		fixture_box_shape(world, &def, i < 6 ? 0.5f : 0.4f, i < 6 ? 0.25f : 0.2f);
		*(i < 6 ? &boxes[i] : &press) = body;
	}
	stops = (int32_t)((0.02f + fixture_random(&seed, 0.02f, 0.06f)) / (speed * dt));
	goes = stops + 60;
	for (step = 0; step < goes + 60; ++step) {
		fixture_set_velocity(world, press, 0.0f, step < stops ? -speed : step < goes ? 0.0f : 0.3f, 0.0f);
		must(cn_world_step(world, dt), world, "cn_world_step");
		*unsolved += fixture_counters(world).islands_unsolved;
		for (i = 0; step >= goes && i < 6; ++i) {
			cn_velocity v;
			must(cn_body_get_velocity(world, boxes[i], &v), world, "cn_body_get_velocity");
			fastest = fmax(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y));
		}
	}
	cn_world_destroy(world);
	return fastest;
}

/* No impulses close the gaps of a column between fixed and kinematic bodies. Those of the exact solution were thousands of weights, and soft contacts began
   with them when the column woke: boxes of 18 of 40 columns were thrown at 10 to 123 m/s. Nor is the column at rest in the frame of a plate that comes down
   on it, where the ground would do work, and no solution fit its energy. */
static void t_what_is_squeezed_and_let_go_is_not_thrown(void)
{
	double fastest = 0.0;
	int32_t unsolved = 0;
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(40); ++seed)
		fastest = fmax(fastest, press_and_let_go(seed, &unsolved));
	CHECK_LE("the fastest box", fastest, 0.3, "m/s");
	CHECK_LE("steps without a solution", unsolved, TEST_FORM(100, 50, 10), "");
}

/* Soft contacts give way by s g h^2 under s own weights: much for a small body, little for a large one. */
static void t_small_bodies_are_crushed_sooner(void)
{
	static const float halves[3] = { 0.5f, 0.05f, 0.005f };
	float h = 0.25f * FRAME_S;
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	int32_t k, index[3];
	for (k = 0; k < 3; ++k)
		index[k] = cni_body_at(world, cni_handles_find(&world->body_handles, fixture_box(world, CN_BODY_DYNAMIC, 3.0f * (float)k, 0.0f, 0.0f, halves[k], halves[k], 0.6f, 0.0f)))->awake;
	for (k = 0; k < 3; ++k) {
		float weight = 10.0f * h / cni_motions(world)[index[k]].inv_mass; /* as an impulse */
		CHECK(!cni_is_stressed(world, 0, index[k], 1.0f * weight, h, 1.0f));
		CHECK(cni_is_stressed(world, 0, index[k], 10.0f * weight, h, 1.0f) == (k > 0)); /* 17 mm: of extents 0.7, 0.07, 0.007 m */
		CHECK(cni_is_stressed(world, index[k], 0, 4.0f * weight, h, 1.0f) == (k > 1)); /* 3 mm */
		CHECK(cni_is_stressed(world, index[k], 0, 16.0f * weight, h, 1.0f)); /* whatever its size */
	}
	cn_world_destroy(world);
}

/* Soft prevails, whichever of the two bodies is asked first. */
static void t_soft_prevails_in_any_order(void)
{
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
		cn_body first, top;
		fixture_floor(world, 0.6f, 0.0f);
		first = stack(world, 0.0f, 4, &top);
		set_body(world, first, k == 0 ? CN_SOLVER_SOFT : CN_SOLVER_DIRECT);
		set_body(world, top, k == 0 ? CN_SOLVER_DIRECT : CN_SOLVER_SOFT);
		fixture_step(world, 2);
		CHECK(is(world, CN_TIER_SOFT, CN_TIER_REASON_OVERRIDE));
		cn_world_destroy(world);
	}
}

/* ---- what interior points may cost ---- */

/* Planks that fall across each other into a pit. */
static void planks(cn_world *world, uint32_t random)
{
	int32_t k;
	fixture_floor(world, 0.8f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -3.5f, 10.0f, 0.0f, 0.5f, 12.0f, 0.8f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, 3.5f, 10.0f, 0.0f, 0.5f, 12.0f, 0.8f, 0.0f);
	for (k = 0; k < 24; ++k) {
		float half = fixture_random(&random, 0.4f, 1.2f), angle = fixture_random(&random, -0.2f, 0.2f);
		fixture_box(world, CN_BODY_DYNAMIC, k % 2 == 0 ? -1.5f : 1.5f, 0.6f + 0.25f * (float)(k / 2) * 2.0f, angle, half, 0.03f, 0.8f, 0.0f);
	}
}

/* owes: of each island as every step begins. Returns the most work of interior points in a step. */
static int32_t most_cone_work(cn_world *world, int32_t owes)
{
	int32_t most = 0, step, k;
	for (step = 0; step < 180; ++step) {
		for (k = 0; k < world->island_used; ++k) {
			cni_island_at(world, k)->cone_spent = owes;
			cni_island_at(world, k)->cone_paid_step = world->step_count;
		}
		fixture_step(world, 1);
		most = cni_max_i(most, world->cone_work);
	}
	return most;
}

static void t_an_island_that_owes_too_much_has_no_interior_points(void)
{
	int32_t most[2] = { 0, 0 }, k;
	uint32_t seed;
	for (k = 0; k < 2; ++k)
		for (seed = 1; seed <= 12; ++seed) {
			cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
			planks(world, seed * 2654435761u);
			most[k] = cni_max_i(most[k], most_cone_work(world, 1 + k * CNI_CONE_DEBT));
			cn_world_destroy(world);
		}
	CHECK_GE("most work in a step", most[0], 1500, "blocks");
	CHECK_LE("... of islands that owe too much", most[1], 0, "blocks");
}

/* What was poured owes all that it may, what stood from the beginning nothing. */
static void t_what_was_poured_spends_little(void)
{
	int32_t steps = 0, step;
	uint32_t seed;
	for (seed = 1; seed <= 12; ++seed) {
		cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
		cn_body bodies[10];
		heap_bowl(world);
		heap_drop(world, seed, bodies, 10);
		for (step = 0; step < 300; ++step) {
			fixture_step(world, 1);
			steps += world->cone_work > 0;
		}
		cn_world_destroy(world);
	}
	CHECK_LE("steps with interior points, of 12 heaps", steps, 16, "");
}

/* Steps of the first 90, of 1/30 s, with interior points. */
static int32_t cone_steps(cn_world *world)
{
	int32_t steps = 0, step;
	for (step = 0; step < 90; ++step) {
		must(cn_world_step(world, 1.0f / 30.0f), world, "cn_world_step");
		steps += world->cone_work > 0;
	}
	cn_world_destroy(world);
	return steps;
}

/* Courses of boxes that touch their neighbours, each to fall by this gap. */
static cn_world *courses(int32_t base, float gap)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	uint32_t random = 2654435761u;
	int32_t i, k;
	fixture_floor(world, 0.6f, 0.0f);
	for (i = 0; i < base; ++i)
		for (k = i; k < base; ++k)
			fixture_box(world, CN_BODY_DYNAMIC, (float)k - 0.5f * (float)i + fixture_random(&random, -1e-5f, 1e-5f), 0.5f + (float)i + gap * (float)(i + 1), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	return world;
}

/* Boxes that overlap by 12 mm, one on the other, each moved sideways. */
static cn_world *overlapping(float half_x, float half_y)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, CN_DEFAULT, CN_DEFAULT);
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 8; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, k % 2 == 0 ? 0.0f : 0.3f * half_x, half_y + (2.0f * half_y - 0.012f) * (float)k, 0.0f, half_x, half_y, 0.6f, 0.0f);
	return world;
}

/* What is to fall by more than a slop moves on its way, as what thin bodies push apart does, though it is at rest at first. */
static void t_what_is_far_from_rest_waits(void)
{
	cn_world *world;
	int32_t base, steps = 0;
	for (base = 3; base <= 7; ++base)
		steps += cone_steps(courses(base, 0.01f));
	CHECK_LE("steps with interior points, of 5 pyramids", steps, 0, "");
	world = overlapping(0.4f, 0.016f);
	fixture_step(world, 1);
	CHECK(is(world, CN_TIER_SOFT, CN_TIER_REASON_MOVING));
	cn_world_destroy(world);
	world = overlapping(0.4f, 0.2f);
	fixture_step(world, 1);
	CHECK(is(world, CN_TIER_DIRECT, CN_TIER_REASON_OVERLAP));
	cn_world_destroy(world);
}

/* Rounds in which only sliding impulses do not match keep their set, so heaps that came to rest in a bowl are refused less often. */
static void t_sliding_impulses_converge_with_one_set(void)
{
	int32_t sum = 0, step, k;
	uint32_t seed;
	for (seed = 1; seed <= 12; ++seed) {
		cn_world *world = make_world(CN_SOLVER_SOFT, CN_DEFAULT, CN_DEFAULT);
		cn_island_report list[REPORTS];
		cn_body bodies[10];
		heap_bowl(world);
		heap_drop(world, seed, bodies, 10);
		fixture_step(world, 150);
		must(cn_world_set_solver(world, CN_SOLVER_AUTO), world, "cn_world_set_solver");
		for (step = 0; step < 400; ++step) {
			fixture_step(world, 1);
			for (k = reports(world, list); k > 0; --k)
				sum += list[k - 1].reason == CN_TIER_REASON_NO_SET;
		}
		cn_world_destroy(world);
	}
	CHECK_LE("islands without a set, of 4,800 steps", sum, 340, "");
}

/* The step in which a stack of three becomes direct that is put back to the same overlap before each step, with this speed; 0: none. */
static int32_t direct_since(float speed)
{
	cn_world *world = make_world(CN_SOLVER_AUTO, 0.0f, CN_DEFAULT);
	cn_body bodies[3];
	int32_t k, step, since = 0;
	fixture_floor(world, 0.0f, 0.0f);
	for (k = 0; k < 3; ++k)
		bodies[k] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.49f + 0.98f * (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (step = 1; step <= CNI_SELECTION_WAIT_STEPS + 3 && since == 0; ++step) {
		for (k = 0; k < 3; ++k) {
			must(cn_body_set_pose(world, bodies[k], 0.0f, 0.49f + 0.98f * (float)k, 0.0f), world, "cn_body_set_pose");
			fixture_set_velocity(world, bodies[k], speed, 0.0f, 0.0f);
		}
		fixture_step(world, 1);
		if (report(world).tier == CN_TIER_DIRECT)
			since = step;
		else
			CHECK(is(world, CN_TIER_SOFT, CN_TIER_REASON_MOVING));
	}
	cn_world_destroy(world);
	return since;
}

static void t_moving_islands_wait(void)
{
	int32_t moving = direct_since(0.3f), still = direct_since(0.0f);
	printf("  direct since step %d when sliding, %d when still\n", (int)moving, (int)still);
	CHECK(moving == CNI_SELECTION_WAIT_STEPS + 1);
	CHECK(still == 1);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_moving_islands_wait);
	RUN(t_islands_that_meet_or_part_keep_what_is_known);
	RUN(t_refusals_last_longer_each_time);
	RUN(t_what_turns_bad_again_stays_longer);
	RUN(t_so_many_islands_at_a_time);
	RUN(t_what_falls_forgets_its_loads);
	RUN(t_what_has_no_set_presses_no_harder_than_soft_contacts_bear);
	RUN(t_what_is_squeezed_is_not_thrown);
	RUN(t_what_is_squeezed_and_let_go_is_not_thrown);
	RUN(t_what_bears_much_is_not_thrown);
	RUN(t_small_bodies_are_crushed_sooner);
	RUN(t_soft_prevails_in_any_order);
	RUN(t_what_was_poured_spends_little);
	RUN(t_what_is_far_from_rest_waits);
	RUN(t_sliding_impulses_converge_with_one_set);
	RUN(t_an_island_that_owes_too_much_has_no_interior_points);
	return test_end();
}
