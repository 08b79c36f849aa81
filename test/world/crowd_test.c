/*
 * test/world/crowd_test.c - promises of bodies made in one spot: a step's pairs and memory are bounded, CN_WARNING_CROWD and
 * pairs_not_added report pairs that wait, the bodies come apart, bodies elsewhere and the ground miss no contact, and the bits
 * are the same with both broadphases and any number of workers.
 *
 * If a test fails, look in broadphase/pair_list.c (pairs left out), narrowphase/pairs.c (their turns, the limit of contacts).
 * `crowd_test t_soak` makes crowds of 4,000 and 10,000 (make soak).
 */
#include "workers.h"

#define LIMIT(proxies) (32768 + 16 * (proxies)) /* pairs of a step, and contacts of a world beyond which bodies with 16 get no more */

typedef struct crowd {
	cn_world *world;
	cn_body *bodies;
	int32_t count;
	int32_t contacts_most;
	int32_t not_added;     /* in all steps */
	int32_t warnings;      /* steps with CN_WARNING_CROWD */
	int32_t warned_last;   /* the last of them */
	int32_t steps;
	uint64_t digest;
} crowd;

static void shape_of_kind(cn_world *world, cn_body body, int32_t kind)
{
	static const cn_vec2 corners[3] = { { -0.4f, -0.3f }, { 0.4f, -0.3f }, { 0.0f, 0.5f } };
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.1f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.4f };
	cn_capsule capsule = { { -0.3f, 0.0f }, { 0.3f, 0.0f }, 0.2f };
	cn_polygon triangle;
	if (kind == 0)
		must(cn_shape_create_circle(world, &def, &circle, NULL), world, "circle");
	else if (kind == 1)
		must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "capsule");
	else if (kind == 2) {
		must(cn_polygon_make_hull(corners, 3, 0.0f, &triangle), world, "hull");
		must(cn_shape_create_polygon(world, &def, &triangle, NULL), world, "polygon");
	} else {
		fixture_box_shape(world, &def, 0.5f, kind == 3 ? 0.5f : 0.25f);
		if (kind == 5)
			fixture_box_shape(world, &def, 0.2f, 0.6f);
	}
}

/* kinds 1: boxes of 1 m; else shapes of six kinds. */
static void crowd_open(crowd *c, const cn_world_def *def, int32_t count, int32_t spots, int32_t kinds, uint32_t seed)
{
	uint32_t random = seed * 2654435761u | 1u;
	int32_t k;
	memset(c, 0, sizeof *c);
	c->bodies = (cn_body *)calloc((size_t)count, sizeof *c->bodies);
	c->count = count;
	must(cn_world_create(def, &c->world), NULL, "cn_world_create");
	fixture_box(c->world, CN_BODY_STATIC, 0.0f, -1.0f, 0.0f, 5000.0f, 1.0f, 0.5f, 0.0f);
	for (k = 0; k < count; ++k) {
		float at = 12.0f * (float)(k % spots), angle = kinds > 1 ? fixture_random(&random, -3.0f, 3.0f) : 0.0f;
		c->bodies[k] = fixture_body(c->world, CN_BODY_DYNAMIC, at, 2.0f, angle);
		shape_of_kind(c->world, c->bodies[k], kinds > 1 ? (int32_t)fixture_random(&random, 0.0f, 5.99f) : 3);
	}
}

static void crowd_close(crowd *c)
{
	cn_world_destroy(c->world);
	free(c->bodies);
}

static void crowd_step(crowd *c, int32_t steps)
{
	for (; steps > 0; --steps) {
		cn_counters counters;
		fixture_step(c->world, 1);
		counters = fixture_counters(c->world);
		++c->steps;
		c->contacts_most = counters.contacts > c->contacts_most ? counters.contacts : c->contacts_most;
		c->not_added += counters.pairs_not_added;
		c->warnings += (counters.warnings & CN_WARNING_CROWD) != 0;
		c->warned_last = counters.warnings & CN_WARNING_CROWD ? c->steps : c->warned_last;
		c->digest = digest_world(c->digest, c->world);
	}
}

/* Lowest centre; -infinity if some number is none. */
static double crowd_lowest(const crowd *c)
{
	double lowest = HUGE_VAL;
	int32_t k;
	for (k = 0; k < c->count; ++k) {
		cn_pose p = fixture_pose(c->world, c->bodies[k]);
		cn_velocity v = fixture_velocity(c->world, c->bodies[k]);
		if (!isfinite(p.position_m.x + p.position_m.y + v.linear_mps.x + v.linear_mps.y + v.angular_radps))
			return -HUGE_VAL;
		lowest = fmin(lowest, (double)p.position_m.y);
	}
	return lowest;
}

/* Bodies whose centre is inside of another body. */
static int32_t crowd_entangled(const crowd *c)
{
	int32_t k, entangled = 0;
	for (k = 0; k < c->count; ++k) {
		cn_vec2 center;
		cn_shape shapes[8];
		int32_t found = 0, i, others = 0;
		must(cn_body_get_center(c->world, c->bodies[k], &center), c->world, "cn_body_get_center");
		must(cn_world_overlap_point(c->world, center.x, center.y, NULL, shapes, 8, &found), c->world, "cn_world_overlap_point");
		for (i = 0; i < found && i < 8; ++i) {
			cn_body body = 0;
			must(cn_shape_get_body(c->world, shapes[i], &body), c->world, "cn_shape_get_body");
			others += body != c->bodies[k];
		}
		entangled += others > 0;
	}
	return entangled;
}

static void check_crowd(crowd *c, int32_t warned_at_most)
{
	printf("  %d bodies: at most %d contacts, %d pairs left out, %d steps with a warning\n", (int)c->count, (int)c->contacts_most, (int)c->not_added, (int)c->warnings);
	CHECK_LE("contacts of a step", c->contacts_most, LIMIT(c->count + 1) + 16 * c->count, "");
	CHECK_GE("pairs left out", c->not_added, 1, "");
	CHECK_LE("last step with a warning", c->warned_last, warned_at_most, "");
	CHECK_GE("lowest centre", crowd_lowest(c), 0.1, "m");
	CHECK_LE("bodies with their centre in another one at the end", crowd_entangled(c), 0, "");
	CHECK(fixture_is_valid(c->world));
}

/* Width over height of the boxes' centres: not a column, which coincident centres would become if all normals were alike. */
static double crowd_width_over_height(const crowd *c)
{
	double left = HUGE_VAL, right = -HUGE_VAL, top = 1.0;
	int32_t k;
	for (k = 0; k < c->count; ++k) {
		cn_pose p = fixture_pose(c->world, c->bodies[k]);
		left = fmin(left, (double)p.position_m.x);
		right = fmax(right, (double)p.position_m.x);
		top = fmax(top, (double)p.position_m.y);
	}
	return (right - left) / top;
}

static void t_boxes_in_one_spot_come_apart(void)
{
	cn_world_def def;
	crowd c;
	cn_world_def_init(&def);
	crowd_open(&c, &def, 290, 1, 1, 1);
	crowd_step(&c, 120);
	check_crowd(&c, 120);
	CHECK_GE("width over height", crowd_width_over_height(&c), 0.5, "");
	crowd_close(&c);
}

/* n bodies of random kinds in k spots. */
static void random_crowds(uint32_t seeds, int32_t steps)
{
	cn_world_def def;
	crowd c;
	uint32_t seed;
	for (seed = 1; seed <= seeds; ++seed) {
		int32_t spots = 1 + (int32_t)seed / 2 % 2;
		cn_world_def_init(&def);
		def.broadphase = seed % 2 == 0 ? CN_BROADPHASE_TREE : CN_BROADPHASE_SWEEP;
		def.solver = seed % 3 == 0 ? CN_SOLVER_SOFT : CN_SOLVER_AUTO;
		crowd_open(&c, &def, 150 + 140 * (spots + (int32_t)(seed + 4) % 5), spots, 6, seed);
		crowd_step(&c, steps);
		check_crowd(&c, 120);
		crowd_close(&c);
	}
}

static void t_random_crowds_come_apart(void) { random_crowds(1, 80); }
static void t_soak_random_crowds(void) { random_crowds(40, 600); }

static void t_same_bits_with_any_broadphase_and_workers(void)
{
	uint64_t digest = 0;
	int32_t k;
	for (k = 0; k < 4; k += TEST_FORM(1, 3, 3)) {
		tasks system;
		cn_world_def def;
		crowd c;
		cn_world_def_init(&def);
		def.broadphase = k % 2 == 0 ? CN_BROADPHASE_SWEEP : CN_BROADPHASE_TREE;
		def.worker_count = k < 2 ? 1 : 3;
		if (k >= 2)
			use_tasks(&def, &system, TASKS_ON_THREADS);
		crowd_open(&c, &def, 290, 1, 6, 7);
		crowd_step(&c, 4);
		digest = k == 0 ? c.digest : digest;
		CHECK(c.digest == digest && c.not_added > 0);
		crowd_close(&c);
	}
}

/* A stack and falling balls far from the crowd move as they do without it. */
static void t_bodies_elsewhere_miss_no_contact(void)
{
	double heights[2][16], differs = 0.0;
	int32_t k, i;
	for (k = 0; k < 2; ++k) {
		cn_body others[16];
		cn_world_def def;
		crowd c;
		cn_world_def_init(&def);
		crowd_open(&c, &def, k == 0 ? 1 : 290, 1, 1, 1);
		for (i = 0; i < 16; ++i)
			others[i] = i < 4 ? fixture_box(c.world, CN_BODY_DYNAMIC, -900.0f, 0.5f + (float)i, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f)
			                  : fixture_circle(c.world, CN_BODY_DYNAMIC, -900.0f - 3.0f * (float)i, 0.25f + 0.03f * (float)i, 0.3f, 0.5f, 0.0f);
		crowd_step(&c, 12);
		for (i = 0; i < 16; ++i)
			heights[k][i] = (double)fixture_pose(c.world, others[i]).position_m.y;
		CHECK(k == 0 || c.warnings > 0);
		crowd_close(&c);
	}
	for (i = 0; i < 16; ++i)
		differs = greater(differs, fabs(heights[0][i] - heights[1][i]));
	CHECK_LE("difference of heights with and without a crowd", differs, SOLVED, "m");
}

/* Shapes of one body and shapes that filters keep apart are no crowd. */
static void t_filtered_boxes_are_no_crowd(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_counters counters;
	int32_t k;
	for (k = 0; k < 400; ++k) {
		cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f);
		cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
		def.filter.mask = 0;
		fixture_box_shape(world, &def, 0.5f, 0.5f);
	}
	fixture_step(world, 2);
	counters = fixture_counters(world);
	CHECK(counters.warnings == 0 && counters.pairs_not_added == 0 && counters.contacts == 0);
	cn_world_destroy(world);
}

static void t_soak_crowds(void)
{
	static const int32_t counts[2] = { 4000, 10000 };
	int32_t k;
	for (k = 0; k < 2; ++k) {
		cn_memory_stats memory;
		cn_world_def def;
		crowd c;
		cn_world_def_init(&def);
		crowd_open(&c, &def, counts[k], 1, 1, 1);
		crowd_step(&c, 900);
		check_crowd(&c, 600);
		must(cn_world_get_memory_stats(c.world, &memory), c.world, "cn_world_get_memory_stats");
		CHECK_LE("memory of a body", (double)memory.bytes_peak / (double)counts[k], 16384, "bytes");
		crowd_close(&c);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_boxes_in_one_spot_come_apart);
	RUN(t_random_crowds_come_apart);
	RUN(t_same_bits_with_any_broadphase_and_workers);
	RUN(t_bodies_elsewhere_miss_no_contact);
	RUN(t_filtered_boxes_are_no_crowd);
	RUN_WHEN_NAMED(t_soak_random_crowds);
	RUN_WHEN_NAMED(t_soak_crowds);
	return test_end();
}
