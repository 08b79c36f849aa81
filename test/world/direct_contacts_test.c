/*
 * test/world/direct_contacts_test.c - what is promised of contacts that are solved directly, alone and among joints:
 * stacks, walls, random scenes, the same bits in a fixed block; of contacts that would part joints, or press on light bodies that joints
 * hold.
 *
 * If a test here fails, run linear/sparse and world/direct first. Then look in: direct/solver_selection.c and direct_contacts.c,
 * joint_projection.c (hard stops), component_fate.c (loaded bridges), heavy_contacts.c (light boards and arms, chains in heaps).
 */
#include "direct.h"

/* ---- stacks ---- */

static void stack_run(const char *name, int32_t count, float top_factor, int32_t solver, double overlap_bound)
{
	scene s = scene_open(GRAVITY, 0, solver);
	double overlap = 0.0, drift = 0.0, angle = 0.0;
	int32_t k, i;
	fixture_floor(s.world, 0.6f, 0.0f);
	for (k = 0; k < count; ++k)
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 0.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
	weigh(&s, last_body(&s), top_factor);
	for (k = 0; k < 300; ++k) {
		fixture_step(s.world, 1);
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
		for (i = 0; i < count; ++i) {
			cn_pose p = fixture_pose(s.world, s.bodies[i]);
			drift = greater(drift, hypot((double)p.position_m.x, (double)p.position_m.y - 0.5 - (double)i));
			angle = greater(angle, fabs((double)p.sine));
		}
	}
	printf("  %s\n", name);
	CHECK_LE("greatest overlap", overlap, overlap_bound, "m");
	CHECK_LE("greatest distance of a box from where it was", drift, 2e-3, "m");
	CHECK_LE("greatest tilt", angle, ROUNDING, "rad");
	scene_close(&s);
}

static void stacks_stand_still(void)
{
	stack_run("20 boxes", 20, 1.0f, CN_SOLVER_AUTO, 1e-3);
	stack_run("20 boxes, CN_SOLVER_DIRECT", 20, 1.0f, CN_SOLVER_DIRECT, 1e-3);
	stack_run("1,000 times the mass on ten boxes", 11, 1000.0f, CN_SOLVER_AUTO, 1e-3);
	stack_run("1,000 times the mass on ten boxes, CN_SOLVER_DIRECT", 11, 1000.0f, CN_SOLVER_DIRECT, 1e-3);
}

/* ---- a wall and a ball ---- */

static void wall_run(const char *name, float speed, int32_t solver)
{
	scene s = scene_open(GRAVITY, 0, solver);
	cn_body ball;
	watch w;
	int32_t row, column;
	fixture_floor(s.world, 0.6f, 0.0f);
	for (row = 0; row < 6; ++row)
		for (column = 0; column < 4 + row % 2; ++column)
			keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, (float)column - 0.5f * (float)(row % 2), 0.25f + 0.5f * (float)row, 0.0f, 0.5f, 0.25f, 0.6f, 0.0f));
	ball = keep(&s, fixture_circle(s.world, CN_BODY_DYNAMIC, -6.0f, 1.2f, 0.5f, 0.6f, 0.0f));
	weigh(&s, ball, 10.0f);
	fixture_set_velocity(s.world, ball, speed, 2.0f, 0.0f);
	w = watch_begin(&s);
	watch_steps(&w, &s, TEST_FORM(240, 90, 60));
	printf("  %s\n", name);
	CHECK_LE("greatest speed / the ball's", w.speed / hypot((double)speed, 2.0), 1.05, "");
	CHECK_LE("energy / start", w.energy / w.energy_start, 1.0001, "");
	scene_close(&s);
}

static void wall_falls_or_stands(void)
{
	wall_run("ball of 15 m/s", 15.0f, CN_SOLVER_AUTO);
	wall_run("ball of 15 m/s, CN_SOLVER_DIRECT", 15.0f, CN_SOLVER_DIRECT);
	wall_run("ball of 40 m/s", 40.0f, CN_SOLVER_AUTO);
}

/* ---- random scenes ---- */

static void random_pair(scene *s, uint32_t *random, cn_body a, cn_body b)
{
	float kind = fixture_random(random, 0.0f, 3.0f), x, y;
	cn_pose pa = fixture_pose(s->world, a), pb = fixture_pose(s->world, b);
	cn_vec2 la, lb;
	x = 0.5f * (pa.position_m.x + pb.position_m.x);
	y = 0.5f * (pa.position_m.y + pb.position_m.y);
	must(cn_body_get_local_point(s->world, a, x, y, &la), s->world, "cn_body_get_local_point");
	must(cn_body_get_local_point(s->world, b, x, y, &lb), s->world, "cn_body_get_local_point");
	if (kind < 1.0f) {
		pin(s, a, la, b, lb);
	} else if (kind < 2.0f) {
		cn_distance_def def;
		cn_distance_def_init(&def);
		def.base.body_a = a;
		def.base.body_b = b;
		def.length_m = hypotf(pa.position_m.x - pb.position_m.x, pa.position_m.y - pb.position_m.y);
		must(cn_joint_create_distance(s->world, &def, &s->joints[s->joint_count++]), s->world, "cn_joint_create_distance");
	} else {
		cn_fixed_def def;
		cn_fixed_def_init(&def);
		def.base.body_a = a;
		def.base.body_b = b;
		def.base.anchor_a_m = la;
		def.base.anchor_b_m = lb;
		must(cn_joint_create_fixed(s->world, &def, &s->joints[s->joint_count]), s->world, "cn_joint_create_fixed");
		must(cn_joint_get_position(s->world, s->joints[s->joint_count++], &def.reference_angle_rad), s->world, "cn_joint_get_position");
		must(cn_joint_set_fixed(s->world, s->joints[s->joint_count - 1], &def), s->world, "cn_joint_set_fixed");
	}
}

/* Boxes and circles, some jointed to their neighbours, fall into a trough. */
static void fill_random(scene *s, uint32_t seed)
{
	uint32_t random = seed * 2654435761u + 99u;
	int32_t row, column;
	fixture_floor(s->world, 0.6f, 0.0f);
	fixture_box(s->world, CN_BODY_STATIC, -4.0f, 4.0f, 0.0f, 0.5f, 5.0f, 0.6f, 0.0f);
	fixture_box(s->world, CN_BODY_STATIC, 4.0f, 4.0f, 0.0f, 0.5f, 5.0f, 0.6f, 0.0f);
	for (row = 0; row < 4; ++row) {
		cn_body before = 0;
		for (column = -2; column <= 2; ++column) {
			float size = fixture_random(&random, 0.2f, 0.5f), friction = fixture_random(&random, 0.0f, 1.0f), angle = fixture_random(&random, -3.0f, 3.0f);
			float restitution = fixture_random(&random, -1.5f, 0.5f), x = 1.3f * (float)column, y = 1.0f + 1.4f * (float)row, vx, vy, w;
			cn_body body;
			if (fixture_random(&random, 0.0f, 1.0f) < 0.25f) {
				before = 0;
				continue;
			}
			restitution = restitution > 0.0f ? restitution : 0.0f;
			if (fixture_random(&random, 0.0f, 1.0f) < 0.4f)
				body = fixture_circle(s->world, CN_BODY_DYNAMIC, x, y, size, friction, restitution);
			else
				body = fixture_box(s->world, CN_BODY_DYNAMIC, x, y, angle, size, 0.6f * size, friction, restitution);
			keep(s, body);
			weigh(s, body, (float)pow(10.0, (double)fixture_random(&random, -1.0f, 1.0f)));
			vx = fixture_random(&random, -3.0f, 3.0f);
			vy = fixture_random(&random, -3.0f, 3.0f);
			w = fixture_random(&random, -3.0f, 3.0f);
			fixture_set_velocity(s->world, body, vx, vy, w);
			if (before != 0 && fixture_random(&random, 0.0f, 1.0f) < 0.5f)
				random_pair(s, &random, before, body);
			before = body;
		}
	}
}

#define RANDOM_SEEDS TEST_MANY(20)
#define RANDOM_STEPS 150

/* As parts of the energy at the start: the most there was, and the most that came back after a low. */
typedef struct balance {
	double most, rise;
	int32_t valid;
} balance;

static balance random_run(uint32_t seed, int32_t solver)
{
	scene s = scene_open(GRAVITY, seed % 2 == 0, solver);
	balance b = { 0.0, 0.0, 1 };
	double start, least;
	int32_t k;
	fill_random(&s, seed);
	start = least = energy_in(&s);
	for (k = 0; k < RANDOM_STEPS; ++k) {
		double now;
		fixture_step(s.world, 1);
		now = energy_in(&s);
		least = fmin(least, now);
		b.most = greater(b.most, now / start);
		b.rise = greater(b.rise, (now - least) / start);
		b.valid = b.valid && fixture_is_valid(s.world);
	}
	scene_close(&s);
	return b;
}

/* Joints and contacts that contradict each other store some energy in what overlaps, and give it back. */
static void random_scenes_behave(void)
{
	static const char *const names[] = { "CN_SOLVER_AUTO", "CN_SOLVER_SOFT", "CN_SOLVER_DIRECT" };
	static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_SOFT, CN_SOLVER_DIRECT };
	int32_t k;
	for (k = 0; k < 3; ++k) {
		balance worst = { 0.0, 0.0, 1 };
		uint32_t seed;
		for (seed = 1; seed <= RANDOM_SEEDS; ++seed) {
			balance b = random_run(seed, solvers[k]);
			if (!b.valid || b.most > 1.001 || b.rise > 0.1)
				printf("  seed %u: energy %.5f of the start at most, %.5f back, valid %d\n", (unsigned)seed, b.most, b.rise, (int)b.valid);
			CHECK(b.valid);
			worst.most = greater(worst.most, b.most);
			worst.rise = greater(worst.rise, b.rise);
		}
		printf("  %s\n", names[k]);
		CHECK_LE("energy / start", worst.most, solvers[k] == CN_SOLVER_SOFT ? 1.02 : 1.001, "");
		CHECK_LE("energy that came back / start", worst.rise, 0.1, "");
	}
}

/* ---- the same bits ---- */

/* Chains, a stack and a random heap, in a world of the definition's kind of memory. */
static uint64_t history(const cn_world_def *def, uint32_t *warnings)
{
	scene s;
	uint64_t hash;
	int32_t k;
	memset(&s, 0, sizeof s);
	must(cn_world_create(def, &s.world), NULL, "cn_world_create");
	fill_random(&s, 5);
	add_chain(&s, 0, at(10.0f, 6.0f), 10.0f, 6.0f, 0.0f, 12);
	weigh(&s, last_body(&s), 500.0f);
	for (k = 0; k < 8; ++k)
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, -10.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
	weigh(&s, last_body(&s), 200.0f);
	*warnings = 0;
	for (k = 0; k < 180; ++k) {
		fixture_step(s.world, 1);
		*warnings |= fixture_counters(s.world).warnings;
	}
	CHECK(fixture_is_valid(s.world));
	hash = fixture_hash(s.world);
	cn_world_destroy(s.world);
	return hash;
}

static void fixed_memory_gives_the_same_bits(void)
{
	static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_DIRECT };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_world_def def;
		uint64_t bytes = 0, growing, again, fixed;
		uint32_t warnings;
		uint8_t *raw;
		cn_world_def_init(&def);
		def.solver = solvers[k];
		def.body_capacity = def.shape_capacity = 64;
		def.contact_capacity = 512;
		def.joint_capacity = 64;
		growing = history(&def, &warnings);
		CHECK(warnings == 0);
		again = history(&def, &warnings);
		must(cn_world_bytes_needed(&def, &bytes), NULL, "cn_world_bytes_needed");
		raw = (uint8_t *)malloc((size_t)bytes + 64);
		REQUIRE(raw != NULL);
		def.memory = raw + (64 - (uintptr_t)raw % 64) % 64;
		def.memory_bytes = bytes;
		fixed = history(&def, &warnings);
		free(raw);
		printf("  %s: growing %016llx, again %016llx, in %llu bytes %016llx, warnings %u\n", k ? "CN_SOLVER_DIRECT" : "CN_SOLVER_AUTO",
		       (unsigned long long)growing, (unsigned long long)again, (unsigned long long)bytes, (unsigned long long)fixed, (unsigned)warnings);
		CHECK(warnings == 0);
		CHECK(growing == again);
		CHECK(growing == fixed);
	}
}

/* ---- contacts that part joints ---- */

/* Planks of 1 m between two points along an arc, or straight with arc 0. */
static void add_planks(scene *s, int32_t count, double arc)
{
	double turn = 2.0 * arc / (double)count, radius = arc > 0.0 ? 0.5 / sin(0.5 * turn) : 0.0;
	cn_body before = 0;
	int32_t k;
	for (k = 0; k < count; ++k) {
		double middle = -arc + turn * ((double)k + 0.5), deep = radius * cos(0.5 * turn);
		double x = arc > 0.0 ? deep * sin(middle) : (double)k + 0.5 - 0.5 * (double)count;
		cn_body plank = fixture_box(s->world, CN_BODY_DYNAMIC, (float)x, (float)(radius - deep * cos(middle)), (float)middle, 0.5f, 0.1f, 0.6f, 0.0f);
		double end_x = arc > 0.0 ? -radius * sin(arc) : -0.5 * (double)count, end_y = radius * (1.0 - cos(arc));
		pin(s, before, before != 0 ? at(0.5f, 0.0f) : at((float)end_x, (float)end_y), keep(s, plank), at(-0.5f, 0.0f));
		before = plank;
		if (k + 1 == count)
			pin(s, plank, at(0.5f, 0.0f), 0, at((float)-end_x, (float)end_y));
	}
}

/* Boxes of `factor` times their mass fall onto it. Returns the greatest distance between anchors. */
static double bridge_run(int32_t planks, double arc, int32_t boxes, float factor, int32_t solver, double *gained)
{
	scene s = scene_open(GRAVITY, 0, solver);
	watch w;
	int32_t k;
	add_planks(&s, planks, arc);
	for (k = 0; k < boxes; ++k) {
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, -5.0f + 2.0f * (float)(k % 6), 2.0f + 3.0f * (float)(k / 6), 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
		weigh(&s, last_body(&s), factor);
	}
	w = watch_begin(&s);
	watch_steps(&w, &s, 600);
	*gained = (w.energy - w.energy_start) / (GRAVITY * ((double)planks * 0.2 + (double)boxes * (double)factor));
	scene_close(&s);
	return w.apart;
}

/* Long loops of pins that carry something are soft: as good as with CN_SOLVER_SOFT. Short ones are exact. */
static void loaded_bridges_are_as_good_as_soft(void)
{
	static const struct {
		const char *name;
		int32_t planks, boxes;
		double arc;
		float factor;
	} runs[] = { { "an arc, 6 boxes of 20 kg", 20, 6, 0.5, 20.0f },     { "straight, 6 boxes of 1 kg", 20, 6, 0.0, 1.0f },
		     { "straight, 30 boxes of 1 kg", 20, 30, 0.0, 1.0f }, { "straight and long, 30 boxes of 1 kg", 60, 30, 0.0, 1.0f } };
	int32_t k;
	for (k = 0; k < 4; ++k) {
		double gained, of_soft, soft = bridge_run(runs[k].planks, runs[k].arc, runs[k].boxes, runs[k].factor, CN_SOLVER_SOFT, &of_soft);
		double apart = bridge_run(runs[k].planks, runs[k].arc, runs[k].boxes, runs[k].factor, CN_SOLVER_AUTO, &gained);
		printf("  %s: anchors apart by %.4f m, with CN_SOLVER_SOFT %.4f m\n", runs[k].name, apart, soft);
		CHECK_LE("greatest distance between anchors, of that of CN_SOLVER_SOFT", apart / soft, runs[k].planks > 32 ? 1.5 : 0.1, "");
		CHECK_LE("energy gained, by what the bodies weigh", gained, 0.01, "m");
	}
}

/* A chain that comes down on its end at 10 m/s, and is 42 mm shorter in a substep if only the end is stopped. */
static void hard_stops_part_no_joints(void)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	watch w;
	int32_t k;
	fixture_floor(s.world, 0.6f, 0.0f);
	add_chain(&s, 0, nowhere(), 0.0f, 0.4f, 1.4f, 6);
	for (k = 0; k < s.body_count; ++k)
		fixture_set_velocity(s.world, s.bodies[k], 0.0f, -10.0f, 0.0f);
	w = watch_begin(&s);
	watch_steps(&w, &s, 180);
	CHECK_LE("greatest distance between anchors", w.apart, 5e-3, "m");
	CHECK_LE("energy gained", w.energy / w.energy_start - 1.0, 1e-3, "");
	scene_close(&s);
}

/* ---- contacts with light bodies that joints hold ---- */

/* A board of 1 x 0.2 m and 0.2 kg, from (x, y) on at this angle. */
static cn_body add_board(scene *s, double x, double y, double angle)
{
	return keep(s, fixture_box(s->world, CN_BODY_DYNAMIC, (float)(x + 0.5 * cos(angle)), (float)(y + 0.5 * sin(angle)), (float)angle, 0.5f, 0.1f, 0.6f, 0.0f));
}

static void add_heavy_box(scene *s, float x, float y, float factor)
{
	keep(s, fixture_box(s->world, CN_BODY_DYNAMIC, x, y, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
	weigh(s, last_body(s), factor);
}

static void add_cantilever(scene *s, double x, int32_t boards)
{
	cn_body before = 0;
	int32_t k;
	for (k = 0; k < boards; ++k) {
		cn_body board = add_board(s, x + (double)k, 5.0, 0.0);
		weld(s, before, k == 0 ? at((float)x, 5.0f) : at(0.5f, 0.0f), board, at(-0.5f, 0.0f));
		before = board;
	}
}

static void set_surface(const scene *s, float restitution, float rolling, float tangent_speed)
{
	int32_t k, count;
	for (k = 0; k < s->body_count; ++k) {
		cn_shape shape;
		cn_material m;
		must(cn_body_get_shapes(s->world, s->bodies[k], &shape, 1, &count), s->world, "cn_body_get_shapes");
		must(cn_shape_get_material(s->world, shape, &m), s->world, "cn_shape_get_material");
		m.restitution = restitution;
		m.rolling_resistance = rolling;
		m.tangent_speed_mps = tangent_speed;
		must(cn_shape_set_material(s->world, shape, &m), s->world, "cn_shape_set_material");
	}
}

/* A box of 100 kg falls 1 m onto a cantilever of boards of 0.2 kg. A contact that knows nothing of the joints lets it sink in by 0.4 m. */
static void heavy_box_run(const char *name, float restitution, float rolling, float tangent_speed, double bound)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	double overlap = 0.0;
	watch w;
	int32_t k;
	printf("  %s\n", name);
	add_cantilever(&s, 0.0, 8);
	add_heavy_box(&s, 6.9f, 6.6f, 100.0f);
	set_surface(&s, restitution, rolling, tangent_speed);
	w = watch_begin(&s);
	for (k = 0; k < 240; ++k) {
		watch_steps(&w, &s, 1);
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	CHECK_LE("greatest overlap", overlap, bound, "m");
	if (tangent_speed != 0.0f)
		CHECK_LE("speed by which both belts miss theirs", fabs((double)fixture_velocity(s.world, last_body(&s)).linear_mps.x / (2.0 * (double)tangent_speed) - 1.0), 0.02, "");
	CHECK_LE("greatest distance between anchors", w.apart, 1e-3, "m");
	CHECK_LE("energy gained", w.energy / w.energy_start - 1.0, 1e-4, "");
	scene_close(&s);
}

static void heavy_boxes_lie_on_light_boards(void)
{
	heavy_box_run("inelastic", 0.0f, 0.0f, 0.0f, 1e-3);
	heavy_box_run("restitution 0.3", 0.3f, 0.0f, 0.0f, 0.015);
	heavy_box_run("restitution 0.8", 0.8f, 0.0f, 0.0f, 0.015); /* it lands on a corner and rocks */
	heavy_box_run("rolling resistance of 0.1 m", 0.0f, 0.1f, 0.0f, 1e-3);
	heavy_box_run("conveyors of -0.1 m/s", 0.0f, 0.0f, -0.1f, 1e-3);
}

/* As many machines as the scene has: 20 cantilevers, each with a box. With room for 32 contacts in a step the 17th box sank in by 0.17 m. */
static void each_of_many_boxes_lies_on_its_boards(void)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	double overlap = 0.0;
	int32_t k;
	for (k = 0; k < 20; ++k) {
		add_cantilever(&s, 20.0 * (double)k, 5);
		add_heavy_box(&s, 20.0f * (float)k + 4.0f, 6.5f, 100.0f);
	}
	for (k = 0; k < 120; ++k) {
		fixture_step(s.world, 1);
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	CHECK_LE("greatest overlap", overlap, 1e-3, "m");
	scene_close(&s);
}

/* A cantilever is as good as fixed: what falls on it from 2 m rises again to restitution^2 * 2 m. Impacts of free bodies would end with the
   boards, which the joints stop. */
static void boxes_bounce_off_jointed_boards(void)
{
	const float factors[] = { 0.1f, 0.5f, 1.0f, 10.0f, 100.0f, 1000.0f };
	int32_t k, i;
	for (i = 0; i < (int32_t)(sizeof factors / sizeof factors[0]); ++i) {
		scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
		double high = 0.0;
		watch w;
		add_cantilever(&s, 0.0, 4);
		keep(&s, fixture_box(s.world, CN_BODY_DYNAMIC, 3.5f, 7.35f, 0.0f, 0.25f, 0.25f, 0.6f, 0.0f));
		weigh(&s, last_body(&s), factors[i]);
		set_surface(&s, 0.8f, 0.0f, 0.0f);
		w = watch_begin(&s);
		for (k = 0; k < 90; ++k) {
			watch_steps(&w, &s, 1);
			if (fixture_velocity(s.world, last_body(&s)).linear_mps.y > 0.0f)
				high = greater(high, (double)fixture_pose(s.world, last_body(&s)).position_m.y - 5.35);
		}
		printf("  a box of %g times the mass of a board\n", (double)factors[i]);
		CHECK_LE("height of the bounce - 1.28 m", fabs(high - 1.28), 0.1, "m");
		CHECK_LE("energy gained", w.energy / w.energy_start - 1.0, 1e-4, "");
		scene_close(&s);
	}
}

/* Two boards welded to an arm on a pivot, whose limit a box of 300 kg releases or reaches, and which turns away under it. */
static void light_arms_throw_no_heavy_boxes(void)
{
	double gained = 0.0;
	int32_t k;
	for (k = 0; k < 64; ++k) {
		scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
		double angle = PI * (double)k / 32.0, from = k % 2 ? -0.5 : 0.0;
		cn_revolute_def def = revolute_def(0, at(0.0f, 2.0f), add_board(&s, from * cos(angle), 2.0 + from * sin(angle), angle), at((float)(-0.5 - from), 0.0f));
		watch w;
		(void)add_board(&s, (1.0 + from) * cos(angle), 2.0 + (1.0 + from) * sin(angle), angle);
		weld(&s, s.bodies[0], at(0.5f, 0.0f), s.bodies[1], at(-0.5f, 0.0f));
		def.base.flags |= k % 4 < 2 ? CN_JOINT_LIMIT : 0u;
		def.reference_angle_rad = (float)angle;
		def.lower_angle_rad = -0.5f;
		def.upper_angle_rad = 0.0f;
		s.joints[s.joint_count++] = make_revolute(s.world, &def);
		add_heavy_box(&s, -0.9f + 0.3f * (float)(k % 7), 5.0f, 300.0f);
		fixture_set_velocity(s.world, s.bodies[0], 0.0f, 0.0f, k % 4 < 2 ? 0.0f : 20.0f);
		w = watch_begin(&s);
		watch_steps(&w, &s, 120);
		gained = greater(gained, (w.energy - w.energy_start) / (300.0 * GRAVITY));
		scene_close(&s);
	}
	CHECK_LE("energy gained, by what the box weighs", gained, 0.01, "m");
}

/* Two boxes of 6 times the mass of the board below them stand on it, and it lies on the ground; a flywheel that it carries turns, so that nothing of
   it is quiet. It would yield for as long as it bears them. */
static void light_boards_bear_what_stands(void)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	const cn_filter nothing = { 1u, 0u, 0, 0 };
	cn_body board = add_board(&s, 0.0, 0.1, 0.0), wheel = keep(&s, fixture_circle(s.world, CN_BODY_DYNAMIC, 1.2f, 0.1f, 0.3f, 0.6f, 0.0f));
	cn_revolute_def def = revolute_def(board, at(0.7f, 0.0f), wheel, at(0.0f, 0.0f));
	int32_t k;
	weigh(&s, board, 10.0f);
	must(cn_shape_set_filter(s.world, fixture_first_shape(s.world, wheel), &nothing), s.world, "cn_shape_set_filter");
	def.base.flags |= CN_JOINT_MOTOR;
	def.motor_speed_radps = 5.0f;
	def.motor_torque_max_Nm = 1.0f;
	s.joints[s.joint_count++] = make_revolute(s.world, &def);
	keep(&s, fixture_floor(s.world, 0.6f, 0.0f));
	for (k = 0; k < 2; ++k)
		add_heavy_box(&s, 0.5f, 0.7f + (float)k, 12.0f);
	fixture_step(s.world, 240);
	CHECK_LE("overlap", fixture_penetration(s.world, s.bodies, s.body_count), 0.0005, "m");
	scene_close(&s);
}

/* A deck of 16 boards, each pinned to the next and to a stay, which is pinned to a body that moves at this speed, up or down; six boxes of 100 times a
   board's mass, each on boards of its own, fall 0.3 m onto it. They push through the same joints: one of them is as far from the others as their
   boards are. Returns the greatest overlap. */
static double deck_run(float speed, double *apart)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	const cn_filter nothing = { 1u, 0u, 0, 0 };
	cn_body carrier = keep(&s, fixture_body(s.world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 0.0f)), before = carrier;
	double overlap = 0.0;
	watch w;
	int32_t k;
	fixture_set_velocity(s.world, carrier, 0.5f * speed, speed, 0.0f);
	for (k = 0; k < 16; ++k) {
		cn_body board = add_board(&s, (double)k, 5.0, 0.0), stay;
		pin(&s, before, before != carrier ? at(0.5f, 0.0f) : at(0.0f, 5.0f), board, at(-0.5f, 0.0f));
		before = board;
		stay = fixture_box(s.world, CN_BODY_DYNAMIC, (float)k + 0.5f, 8.0f, 0.0f, 0.05f, 2.9f, 0.6f, 0.0f);
		must(cn_shape_set_filter(s.world, fixture_first_shape(s.world, stay), &nothing), s.world, "cn_shape_set_filter");
		pin(&s, board, at(0.0f, 0.1f), keep(&s, stay), at(0.0f, -2.9f));
		pin(&s, carrier, at((float)k + 0.5f, 10.9f), stay, at(0.0f, 2.9f));
	}
	pin(&s, before, at(0.5f, 0.0f), carrier, at(16.0f, 5.0f));
	for (k = 0; k < 6; ++k)
		add_heavy_box(&s, 1.6f + 2.6f * (float)k, 5.9f, 100.0f);
	w = watch_begin(&s);
	for (k = 0; k < 240; ++k) {
		watch_steps(&w, &s, 1);
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	*apart = w.apart;
	scene_close(&s);
	return overlap;
}

static void heavy_boxes_share_a_deck(void)
{
	static const float speeds[] = { 0.0f, 3.0f, -3.0f };
	int32_t k;
	for (k = 0; k < (int32_t)(sizeof speeds / sizeof speeds[0]); ++k) {
		double apart, overlap = deck_run(speeds[k], &apart);
		printf("  a deck that moves at %g m/s\n", (double)speeds[k]);
		CHECK_LE("greatest overlap", overlap, 3e-3, "m");
		CHECK_LE("greatest distance between anchors", apart, 1.2e-3, "m");
	}
}

/* A bridge of 24 pinned boards that hangs between fixed ends, and a box of this many times a board's mass that falls onto it from this height. What
   stops it travels board by board, and joints and contacts alternate. Returns the greatest overlap over 3 s. */
static double bridge_is_struck(float ratio, float drop, float dt_s)
{
	scene s = scene_open(GRAVITY, 0, CN_SOLVER_AUTO);
	cn_body bank = keep(&s, fixture_body(s.world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f)), before = bank;
	double overlap = 0.0;
	int32_t k;
	for (k = 0; k < 24; ++k) {
		cn_body board = add_board(&s, (double)k, 5.0, 0.0);
		pin(&s, before, before != bank ? at(0.5f, 0.0f) : at(0.0f, 5.0f), board, at(-0.5f, 0.0f));
		before = board;
	}
	pin(&s, before, at(0.5f, 0.0f), bank, at(24.0f, 5.0f));
	add_heavy_box(&s, 12.0f, 5.6f + drop, ratio);
	for (k = 0; k < (int32_t)(3.0f / dt_s); ++k) {
		must(cn_world_step(s.world, dt_s), s.world, "cn_world_step");
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	scene_close(&s);
	return overlap;
}

static void heavy_boxes_fall_on_bridges(void)
{
	static const float ratios[] = { 30.0f, 100.0f, 300.0f }, drops[] = { 0.5f, 1.5f, 4.0f }, steps[] = { 1.0f / 60.0f, 1.0f / 30.0f };
	double most = 0.0, sum = 0.0;
	int32_t i, k, m;
	for (i = 0; i < 3; ++i)
		for (k = 0; k < 3; ++k)
			for (m = 0; m < 2; ++m) {
				double overlap = bridge_is_struck(ratios[i], drops[k], steps[m]);
				printf("  %4.0f times, %.1f m, 1/%.0f s: %.1f mm\n", (double)ratios[i], (double)drops[k], (double)(1.0f / steps[m]), 1e3 * overlap);
				most = greater(most, overlap);
				sum += overlap;
			}
	CHECK_LE("mean of the greatest overlaps", sum / 18.0, 0.045, "m");
	CHECK_LE("greatest of all", most, 0.15, "m");
}

/* ---- chains that are pressed into each other ---- */

static void add_chain_of_discs(scene *s, uint32_t *random, float y)
{
	float x = -1.3f + fixture_random(random, 0.0f, 0.3f);
	int32_t k;
	for (k = 0; k < 6; ++k) {
		cn_body disc = keep(s, fixture_circle(s->world, CN_BODY_DYNAMIC, x + 0.42f * (float)k, y, 0.2f, 0.5f, 0.0f));
		weigh(s, disc, fixture_random(random, 0.8f, 2.2f));
		if (k > 0)
			pin(s, s->bodies[s->body_count - 2], at(0.21f, 0.0f), disc, at(-0.21f, 0.0f));
	}
}

/* Six chains of six discs between two walls, of nearly equal masses; two balls of 80 times a disc's mass fall on them. Returns the greatest overlap. */
static double chain_heap_run(int32_t solver, uint32_t seed)
{
	scene s = scene_open(GRAVITY, 0, solver);
	uint32_t random = seed;
	double overlap = 0.0;
	int32_t k;
	keep(&s, fixture_floor(s.world, 0.5f, 0.0f));
	for (k = -1; k <= 1; k += 2)
		keep(&s, fixture_box(s.world, CN_BODY_STATIC, 2.1f * (float)k, 5.0f, 0.0f, 0.3f, 6.0f, 0.3f, 0.0f));
	for (k = 0; k < 6; ++k)
		add_chain_of_discs(&s, &random, 0.5f + 0.5f * (float)k);
	for (k = 0; k < 2; ++k)
		weigh(&s, keep(&s, fixture_circle(s.world, CN_BODY_DYNAMIC, fixture_random(&random, -1.0f, 1.0f), 5.0f + 2.0f * (float)k, 0.5f, 0.5f, 0.0f)), 13.0f);
	for (k = 0; k < 240; ++k) {
		fixture_step(s.world, 1);
		overlap = greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	scene_close(&s);
	return overlap;
}

/* The links bear each other as the ground does, but as free bodies they would yield by what their own masses are too light for. */
static void heavy_balls_press_no_chains_into_each_other(void)
{
	const int32_t seeds = TEST_MANY(20);
	double direct = 0.0, soft = 0.0;
	int32_t seed;
	for (seed = 1; seed <= seeds; ++seed) {
		direct += chain_heap_run(CN_SOLVER_AUTO, (uint32_t)seed) / (double)seeds;
		soft += chain_heap_run(CN_SOLVER_SOFT, (uint32_t)seed) / (double)seeds;
	}
	CHECK_LE("greatest overlap, mean", direct, 0.07, "m");
	CHECK_LE("greatest overlap, mean, over that of soft constraints", direct / soft, 0.8, "");
}

/* ---- heavy boxes on machines at their limits ---- */

static cn_body add_plate(scene *s, float x, float y, float half_x, float half_y)
{
	return weighing(s, fixture_box(s->world, CN_BODY_DYNAMIC, x, y, 0.0f, half_x, half_y, 0.6f, 0.0f), 1.0f);
}

static void add_slider(scene *s, cn_body below, cn_vec2 anchor_below, cn_body plate, float travel)
{
	cn_prismatic_def def;
	cn_prismatic_def_init(&def);
	def.base.flags |= CN_JOINT_LIMIT;
	def.base.body_a = below;
	def.base.body_b = plate;
	def.base.anchor_a_m = anchor_below;
	def.axis = at(0.0f, 1.0f);
	def.lower_m = -travel;
	def.upper_m = travel;
	(void)make_prismatic(s->world, &def);
}

static void add_hinge(scene *s, cn_body before, cn_vec2 anchor_before, cn_body board, float travel)
{
	cn_revolute_def def = revolute_def(before, anchor_before, board, at(-0.5f, 0.0f));
	def.base.flags |= CN_JOINT_LIMIT;
	def.lower_angle_rad = -travel;
	def.upper_angle_rad = travel;
	(void)make_revolute(s->world, &def);
}

enum { PLATE, ARM, TOWER, CRATE, PLANK, STACK, PORTAL }; /* what a box falls on: machines, then loose parts */

/* A plate on a slider, an arm of boards, a tower of plates on sliders; all have limits and parts of 1 kg. Returns the height of its top. */
static float add_machine(scene *s, int32_t machine, uint32_t *random)
{
	float travel = fixture_random(random, 0.01f, 0.3f), top = 2.0f;
	int32_t count = 1 + (int32_t)fixture_random(random, 0.0f, 3.99f), k;
	cn_body before = 0;
	if (machine == PLATE)
		add_slider(s, 0, at(0.0f, top), add_plate(s, 0.0f, top, 1.0f, 0.1f), travel);
	for (k = 0; k < count && machine == ARM; ++k) {
		cn_body board = add_plate(s, 0.5f + (float)k, top, 0.5f, 0.1f);
		add_hinge(s, before, k > 0 ? at(0.5f, 0.0f) : at(0.0f, top), board, travel);
		before = board;
	}
	for (k = 0; k < count && machine == TOWER; ++k) {
		cn_body plate = add_plate(s, 0.0f, top = 0.5f + 0.6f * (float)k, 1.0f, 0.1f);
		add_slider(s, before, k > 0 ? at(0.0f, 0.6f) : at(0.0f, top), plate, 0.5f * travel);
		before = plate;
	}
	return top + 0.1f;
}

/* A crate, a plank on two posts, a stack of crates, a portal, of parts of 1 kg. Returns the height of its top. */
static float add_structure(scene *s, int32_t structure, uint32_t *random)
{
	int32_t count = structure == STACK ? 2 + (int32_t)fixture_random(random, 0.0f, 2.99f) : 1, k;
	float top = 0.5f;
	switch (structure) {
	case PLANK:
		for (k = -1; k <= 1; k += 2)
			keep(s, fixture_box(s->world, CN_BODY_STATIC, 1.5f * (float)k, 0.4f, 0.0f, 0.2f, 0.4f, 0.6f, 0.0f));
		(void)add_plate(s, 0.0f, 0.9f, 1.7f, 0.1f);
		return 1.0f;
	case PORTAL:
		for (k = -1; k <= 1; k += 2)
			(void)add_plate(s, 0.8f * (float)k, 0.5f, 0.15f, 0.5f);
		(void)add_plate(s, 0.0f, 1.1f, 1.1f, 0.1f);
		return 1.2f;
	default:
		for (k = 0; k < count; ++k, top += 0.5f)
			(void)add_plate(s, 0.0f, top - 0.25f, 0.5f, 0.25f);
		return top - 0.5f;
	}
}

typedef struct landing {
	double rebound; /* greatest speed upwards, of that at which it landed */
	double overlap;
} landing;

static landing landing_run(int32_t solver, int32_t scenery, uint32_t seed)
{
	scene s = scene_open(GRAVITY, 0, solver);
	landing l = { 0.0, 0.0 };
	uint32_t random = 2654435761u * seed;
	double down = 0.0, up = 0.0;
	float high, x, mass;
	cn_body box;
	int32_t k;
	keep(&s, fixture_floor(s.world, 0.6f, 0.0f));
	high = scenery <= TOWER ? add_machine(&s, scenery, &random) : add_structure(&s, scenery, &random);
	x = scenery == ARM ? fixture_random(&random, 0.3f, 0.7f) : fixture_random(&random, -0.3f, 0.3f);
	mass = powf(1000.0f, fixture_random(&random, 0.0f, 1.0f));
	box = weighing(&s, fixture_box(s.world, CN_BODY_DYNAMIC, x, high + 0.3f + fixture_random(&random, 0.1f, 3.0f), 0.0f, 0.3f, 0.3f, 0.6f, 0.0f), mass);
	for (k = 0; k < 180; ++k) {
		double speed;
		fixture_step(s.world, 1);
		speed = (double)fixture_velocity(s.world, box).linear_mps.y;
		down = greater(down, -speed);
		up = greater(up, speed);
		l.overlap = greater(l.overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count));
	}
	l.rebound = up / down;
	scene_close(&s);
	return l;
}

/* Means of the solvers over random scenes. */
static void landings_compare(const char *name, int32_t scenery, double rebound_most, double overlap_part)
{
	const int32_t seeds = TEST_MANY(30);
	landing direct = { 0.0, 0.0 }, soft = { 0.0, 0.0 };
	int32_t seed;
	for (seed = 1; seed <= seeds; ++seed) {
		landing d = landing_run(CN_SOLVER_AUTO, scenery, (uint32_t)seed), f = landing_run(CN_SOLVER_SOFT, scenery, (uint32_t)seed);
		direct.rebound += d.rebound / (double)seeds;
		direct.overlap += d.overlap / (double)seeds;
		soft.rebound += f.rebound / (double)seeds;
		soft.overlap += f.overlap / (double)seeds;
	}
	printf("  %s: rebound %.3f, with soft constraints %.3f; overlap %.4f m, %.4f m\n", name, direct.rebound, soft.rebound, direct.overlap, soft.overlap);
	CHECK_LE("rebound, mean", direct.rebound, rebound_most, "of the speed of the landing");
	CHECK_LE("greatest overlap, mean, over that of soft constraints", direct.overlap / soft.overlap, overlap_part, "");
}

/* The limits bear the box as the ground would. A contact that takes the part at its limit for a light free body lets the box sink in and throws
   it up again. */
static void boxes_stay_on_machines_at_their_limits(void)
{
	landings_compare("a plate on a slider", PLATE, 0.12, 0.05);
	landings_compare("an arm", ARM, 0.12, 0.25);
	landings_compare("a tower of sliders", TOWER, 0.12, 0.05);
}

/* Boxes of 1 to 1,000 times its mass. Soft contacts let them sink in and throw them up again. */
static void heavy_boxes_stay_on_what_they_strike(void)
{
	landings_compare("a crate", CRATE, 0.1, 0.05);
	landings_compare("a plank on posts", PLANK, 0.1, 0.05);
	landings_compare("a stack", STACK, 0.1, 0.2);
	landings_compare("a portal", PORTAL, 0.1, 0.1);
}

/* A wheel whose axle is 20 mm too near to a fixed bed. Returns the greatest overlap after a second. */
static double jammed_wheel_run(int32_t solver)
{
	scene s = scene_open(GRAVITY, 0, solver);
	double overlap = 0.0;
	int32_t k;
	keep(&s, fixture_box(s.world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f, 2.0f, 0.5f, 0.6f, 0.0f));
	pin(&s, 0, at(0.0f, 0.98f), keep(&s, fixture_circle(s.world, CN_BODY_DYNAMIC, 0.0f, 0.98f, 0.5f, 0.6f, 0.0f)), at(0.0f, 0.0f));
	fixture_set_velocity(s.world, last_body(&s), 0.0f, 0.0f, 5.0f);
	for (k = 0; k < 120; ++k) {
		fixture_step(s.world, 1);
		overlap = k >= 60 ? greater(overlap, (double)fixture_penetration(s.world, s.bodies, s.body_count)) : 0.0;
	}
	scene_close(&s);
	return overlap;
}

/* Joint and contact contradict each other. Both give way, as with soft constraints. */
static void jammed_wheels_give_way(void)
{
	double direct = jammed_wheel_run(CN_SOLVER_AUTO), soft = jammed_wheel_run(CN_SOLVER_SOFT);
	CHECK_LE("overlap, over that of soft constraints", direct / soft, 1.2, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(stacks_stand_still);
	RUN(wall_falls_or_stands);
	RUN(random_scenes_behave);
	RUN(fixed_memory_gives_the_same_bits);
	RUN(loaded_bridges_are_as_good_as_soft);
	RUN(hard_stops_part_no_joints);
	RUN(heavy_boxes_lie_on_light_boards);
	RUN(each_of_many_boxes_lies_on_its_boards);
	RUN(boxes_stay_on_machines_at_their_limits);
	RUN(heavy_boxes_stay_on_what_they_strike);
	RUN(jammed_wheels_give_way);
	RUN(light_boards_bear_what_stands);
	RUN(heavy_boxes_share_a_deck);
	RUN(heavy_boxes_fall_on_bridges);
	RUN(heavy_balls_press_no_chains_into_each_other);
	RUN(boxes_bounce_off_jointed_boards);
	RUN(light_arms_throw_no_heavy_boxes);
	return test_end();
}
