/*
 * test/world/soft_test.c - CN_SOLVER_SOFT, which knows no loads and solves nothing directly: what stands by its own weight stands
 * for a minute, and what tilts lets go.
 *
 * If a test here fails, look first at CNI_NORMAL_LAG in model/world.h, then at contacts/manifold_reuse_kernel.h and model/contact_lane.c, which
 * keep to it.
 */
#include "fixture.h"

#define BODIES 100
#define MINUTE 3600
#define FRICTION 0.6f
#define OFFSET 0.005f /* m to either side: no pile is made exactly */

typedef struct pile {
	cn_world *world;
	cn_body bodies[BODIES];
	float x[BODIES];
	int32_t count;
	uint32_t random;
} pile;

static void pile_begin(pile *p)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def.gravity_mps2.y = -10.0f;
	def.solver = CN_SOLVER_SOFT;
	def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &p->world), NULL, "cn_world_create");
	fixture_floor(p->world, FRICTION, 0.0f);
	p->count = 0;
	p->random = 1;
}

static void pile_box(pile *p, float x, float y, float size, float density)
{
	cn_shape_def def;
	p->x[p->count] = x + fixture_random(&p->random, -OFFSET, OFFSET);
	p->bodies[p->count] = fixture_body(p->world, CN_BODY_DYNAMIC, p->x[p->count], y, 0.0f);
	def = fixture_shape_def(p->bodies[p->count], FRICTION, 0.0f);
	def.density_kgpm2 = density;
	fixture_box_shape(p->world, &def, 0.5f * size, 0.5f * size);
	++p->count;
}

static void pile_stack(pile *p, int32_t count, float size)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		pile_box(p, 0.0f, ((float)k + 0.5f) * size, size, 1.0f);
}

/* How far it has leaned, in m. */
static double lean(const pile *p)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < p->count; ++k)
		most = greater(most, fabs((double)(fixture_pose(p->world, p->bodies[k]).position_m.x - p->x[k])));
	return most;
}

static pile tested;

static double lean_of_stack(int32_t count, float size)
{
	double most;
	pile_begin(&tested);
	pile_stack(&tested, count, size);
	fixture_step(tested.world, MINUTE);
	most = lean(&tested);
	cn_world_destroy(tested.world);
	return most;
}

static void t_stacks_stand(void)
{
	CHECK_LE("10 boxes of 0.3 m", lean_of_stack(10, 0.3f), 0.05, "m");
	CHECK_LE("20 boxes of 1 m", lean_of_stack(20, 1.0f), 0.05, "m");
	CHECK_LE("50 boxes of 1 m", lean_of_stack(50, 1.0f), 0.5, "m"); /* half a box: where it would fall */
}

static void t_a_heavy_box_stands_on_light_ones(void)
{
	pile_begin(&tested);
	pile_stack(&tested, 10, 1.0f);
	pile_box(&tested, 0.0f, 10.5f, 1.0f, 10.0f);
	fixture_step(tested.world, MINUTE);
	CHECK_LE("10 boxes under one of ten times the mass", lean(&tested), 0.05, "m");
	cn_world_destroy(tested.world);
}

/* A board turns about its middle under a box. Returns the angle at which that has slid 5 mm, less what friction holds: atan(0.6). */
static double late_by(float spin)
{
	double angle = 0.0, slid = 0.0;
	cn_body board, box;
	pile_begin(&tested);
	board = fixture_box(tested.world, CN_BODY_KINEMATIC, 0.0f, 10.0f, 0.0f, 5.0f, 0.1f, FRICTION, 0.0f);
	box = fixture_box(tested.world, CN_BODY_DYNAMIC, 0.0f, 10.35f, 0.0f, 0.5f, 0.25f, FRICTION, 0.0f);
	fixture_set_velocity(tested.world, board, 0.0f, 0.0f, spin);
	while (angle < 1.0 && slid < 0.005) {
		cn_pose on, of;
		fixture_step(tested.world, 1);
		on = fixture_pose(tested.world, board);
		of = fixture_pose(tested.world, box);
		angle = asin((double)on.sine);
		slid = fabs((double)((of.position_m.x - on.position_m.x) * on.cosine + (of.position_m.y - on.position_m.y) * on.sine));
	}
	cn_world_destroy(tested.world);
	return angle - atan((double)FRICTION);
}

/* Sliding 5 mm at a spin w takes (6 s w^2 / (g cos))^(1/3): 0.02 and 0.05 rad. */
static void t_what_tilts_lets_go(void)
{
	CHECK_LE("faster than normals lag: late by", late_by(0.2f), 0.06, "rad");
	CHECK_LE("slower: late by", late_by(0.05f), 0.03 + 0.1, "rad");
	CHECK_GE("slower: late by", late_by(0.05f), 0.0, "rad");
}

/* A contact with what is fixed is a spring of 1 / (4 h) = 60 Hz: more load F presses a body of mass m in by F / (m w^2). */
static void t_loads_sink_by_the_spring(void)
{
	double w = 2.0 * 3.14159265358979 * 60.0, exact = 10.0 / (w * w), depth = 0.0, before;
	cn_body box;
	int32_t k;
	pile_begin(&tested);
	box = fixture_box(tested.world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, FRICTION, 0.0f); /* 1 kg */
	fixture_step(tested.world, 600);
	before = (double)fixture_pose(tested.world, box).position_m.y;
	for (k = 0; k < 60; ++k) {
		must(cn_body_apply_force(tested.world, box, 0.0f, -10.0f), tested.world, "cn_body_apply_force");
		fixture_step(tested.world, 1);
		depth = greater(depth, before - (double)fixture_pose(tested.world, box).position_m.y);
	}
	CHECK_LE("depth against F / (m w^2)", fabs(depth / exact - 1.0), 0.1, "");
	cn_world_destroy(tested.world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_stacks_stand);
	RUN(t_a_heavy_box_stands_on_light_ones);
	RUN(t_what_tilts_lets_go);
	RUN(t_loads_sink_by_the_spring);
	return test_end();
}
