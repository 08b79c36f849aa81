/*
 * test/world/sleep_residual_test.c - nothing falls asleep while an overlap or an open joint is still being corrected, and what cannot be
 * corrected keeps nobody awake. (src/step/integrate_pass.h: CNI_PUSHED_SPEED)
 */
#include "joints.h"

#define STEPS_MOST 1200
/* What is left when it falls asleep: contacts give way by SAG_M under a weight, and a joint is closed. */
#define LEFT_M (2.0 * SAG_M)

static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_SOFT, CN_SOLVER_DIRECT };
static const char *const solver_names[] = { "auto", "soft", "direct" };
#define SOLVERS 3

static cn_world *world_with(int32_t solver)
{
	cn_world *world = fixture_world(-10.0f, 1);
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	return world;
}

/* Steps until everything sleeps, or STEPS_MOST. */
static int32_t steps_awake(cn_world *world)
{
	int32_t k;
	for (k = 0; k < STEPS_MOST && fixture_counters(world).bodies_awake > 0; ++k)
		fixture_step(world, 1);
	return k;
}

static void check_asleep(const char *solver, int32_t steps, double left)
{
	printf("  %s: asleep after %d steps\n", solver, (int)steps);
	CHECK(steps < STEPS_MOST);
	CHECK_LE("error that is left", left, LEFT_M, "m");
}

/* Deep in the ground, upright and turned; pushed out at up to 3 m/s, and its velocity is none all the time. */
static void t_a_deep_box_comes_out(void)
{
	int32_t k, turned;
	for (k = 0; k < SOLVERS; ++k)
		for (turned = 0; turned < 2; ++turned) {
			cn_world *world = world_with(solvers[k]);
			cn_body box;
			int32_t steps;
			fixture_box(world, CN_BODY_STATIC, 0.0f, -10.0f, 0.0f, 100.0f, 10.0f, 0.6f, 0.0f);
			box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, -1.3f, turned ? 1.5f : 0.0f, 1.0f, 1.0f, 0.6f, 0.0f);
			steps = steps_awake(world);
			check_asleep(solver_names[k], steps, fabs((double)fixture_pose(world, box).position_m.y - 1.0));
			cn_world_destroy(world);
		}
}

static double boxes_in_one_place(int32_t solver, int32_t sleep, int32_t *out_steps)
{
	cn_world *world = world_with(solver);
	cn_body boxes[2];
	double left;
	must(cn_world_set_flags(world, CN_WORLD_WARM_START | CN_WORLD_CONTINUOUS | (sleep ? CN_WORLD_SLEEP : 0u)), world, "cn_world_set_flags");
	fixture_floor(world, 0.6f, 0.0f);
	boxes[0] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.6f, 0.0f);
	boxes[1] = fixture_box(world, CN_BODY_DYNAMIC, 0.3f, 1.0f, 0.0f, 1.0f, 1.0f, 0.6f, 0.0f);
	*out_steps = steps_awake(world);
	left = (double)fixture_penetration(world, boxes, 2);
	cn_world_destroy(world);
	return left;
}

/* Friction may hold them before they are quite apart, so beside boxes that never sleep. */
static void t_boxes_in_one_place_come_apart(void)
{
	int32_t k, steps, all;
	for (k = 0; k < SOLVERS; ++k) {
		double asleep = boxes_in_one_place(solvers[k], 1, &steps), awake = boxes_in_one_place(solvers[k], 0, &all);
		printf("  %s: %.2g m overlap asleep, %.2g m awake\n", solver_names[k], asleep, awake);
		check_asleep(solver_names[k], steps, asleep - awake);
	}
}

/* Made 10 m apart: to the world, in the air, and between two boxes that lie on the ground. */
static void t_an_open_joint_closes(void)
{
	int32_t k, between;
	for (k = 0; k < SOLVERS; ++k)
		for (between = 0; between < 2; ++between) {
			cn_world *world = world_with(solvers[k]);
			cn_body box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, between ? 1.0f : 5.0f, 0.0f, 1.0f, 1.0f, 0.6f, 0.0f), other = 0;
			cn_joint joint;
			int32_t steps;
			fixture_floor(world, 0.6f, 0.0f);
			if (between)
				other = fixture_box(world, CN_BODY_DYNAMIC, 10.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.6f, 0.0f);
			joint = hinge(world, other, between ? at(0.0f, 0.0f) : at(10.0f, 5.0f), box, at(0.0f, 0.0f));
			steps = steps_awake(world);
			check_asleep(solver_names[k], steps, joint_error_m(world, joint));
			cn_world_destroy(world);
		}
}

/* A box in a gap that is too narrow, and a body that two pins want in two places: errors that stay do not keep them awake. */
static void t_what_cannot_be_corrected_sleeps(void)
{
	int32_t k;
	for (k = 0; k < SOLVERS; ++k) {
		cn_world *world = world_with(solvers[k]);
		cn_body torn;
		int32_t steps;
		fixture_floor(world, 0.6f, 0.0f);
		fixture_box(world, CN_BODY_STATIC, -2.0f, 5.0f, 0.0f, 1.1f, 5.0f, 0.6f, 0.0f);
		fixture_box(world, CN_BODY_STATIC, 2.0f, 5.0f, 0.0f, 1.1f, 5.0f, 0.6f, 0.0f);
		fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f, 0.6f, 0.0f);
		torn = fixture_box(world, CN_BODY_DYNAMIC, 20.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
		hinge(world, 0, at(19.0f, 5.0f), torn, at(0.0f, 0.0f));
		hinge(world, 0, at(21.0f, 5.0f), torn, at(0.0f, 0.0f));
		steps = steps_awake(world);
		printf("  %s: asleep after %d steps, %d awake\n", solver_names[k], (int)steps, (int)fixture_counters(world).bodies_awake);
		CHECK(steps < STEPS_MOST);
		cn_world_destroy(world);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_a_deep_box_comes_out);
	RUN(t_boxes_in_one_place_come_apart);
	RUN(t_an_open_joint_closes);
	RUN(t_what_cannot_be_corrected_sleeps);
	return test_end();
}
