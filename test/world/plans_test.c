/*
 * test/world/plans_test.c - plans of directly solved systems are kept from step to step (linear/sparse_plan.c), and that
 * changes nothing: the same life in a world that keeps them, in one that forgets them before every step, and in one
 * that gets no memory for them, with the same hash after every step. If it differs, something that a plan depends on
 * is not compared. So it is with nets whose lanes tell that there is nothing to plan (joints/joint_blocks.c).
 */
#include "base/hooks.h"
#include "joints.h"
#include "model/world.h"
#include "joints/joint_pass.h"

#define STEPS 420
#define PARTS 9
#define DOLLS 6

typedef struct life {
	cn_world *world;
	hooks memory;
	cn_body parts[DOLLS][PARTS];
	cn_joint joints[DOLLS][PARTS];
	cn_body wheel, stack[8];
} life;

/* A tree of hinged boxes, each on one of those before it; odd ones hang from the world, even ones fall. */
static void doll(life *l, int32_t which, float x, float y)
{
	int32_t k;
	for (k = 0; k < PARTS; ++k) {
		int32_t from = (k - 1) / 2;
		l->parts[which][k] = fixture_box(l->world, CN_BODY_DYNAMIC, x + 0.6f * (float)(k % 3), y - 0.5f * (float)k, 0.0f, 0.2f, 0.2f, 0.6f, 0.0f);
		if (k > 0)
			l->joints[which][k] = hinge(l->world, l->parts[which][from], at(0.2f, -0.2f), l->parts[which][k], at(-0.2f, 0.2f));
		else if (which % 2)
			l->joints[which][k] = hinge(l->world, 0, at(x, y), l->parts[which][k], at(0.0f, 0.2f));
	}
}

/* A square of pins, which is a net with loops. */
static void square(life *l, float x, float y)
{
	cn_body above[6], left = 0;
	int32_t i, k;
	for (i = 0; i < 6; ++i)
		for (k = 0; k < 6; ++k) {
			cn_body body = fixture_circle(l->world, i == 0 && k < 2 ? CN_BODY_STATIC : CN_BODY_DYNAMIC, x + (float)k, y - (float)i, 0.3f, 0.6f, 0.0f);
			if (i > 0)
				(void)hinge(l->world, above[k], at(0.0f, -0.5f), body, at(0.0f, 0.5f));
			if (k > 0 && !(i == 0 && k < 2))
				(void)hinge(l->world, left, at(0.5f, 0.0f), body, at(-0.5f, 0.0f));
			above[k] = left = body;
		}
}

static void begin(life *l)
{
	cn_world_def def;
	int32_t k;
	memset(l, 0, sizeof *l);
	cn_world_def_init(&def);
	def.alloc = hooks_alloc;
	def.free = hooks_free;
	def.allocator_user = &l->memory;
	must(cn_world_create(&def, &l->world), NULL, "cn_world_create");
	CHECK(cni_arena_reserve(&l->world->arena, 1u << 21)); /* what is not kept must have room */
	(void)fixture_floor(l->world, 0.6f, 0.0f);
	for (k = 0; k < DOLLS; ++k)
		doll(l, k, -30.0f + 5.0f * (float)k, 6.0f);
	square(l, 4.0f, 20.0f);
	l->wheel = fixture_box(l->world, CN_BODY_KINEMATIC, 20.0f, 12.0f, 0.0f, 0.2f, 0.2f, 0.6f, 0.0f);
	(void)hinge(l->world, l->wheel, at(1.0f, 0.0f), l->parts[1][PARTS - 1], at(0.0f, 0.0f));
	fixture_set_velocity(l->world, l->wheel, 0.0f, 0.0f, 0.2f);
	for (k = 0; k < 8; ++k)
		l->stack[k] = fixture_box(l->world, CN_BODY_DYNAMIC, 30.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	must(cn_body_set_solver(l->world, l->stack[0], CN_SOLVER_DIRECT), l->world, "cn_body_set_solver");
}

/* What a plan depends on changes now and then; between these steps it stays. */
static void live(life *l, int32_t step)
{
	if (step == 60)
		must(cn_joint_destroy(l->world, l->joints[1][3]), l->world, "cn_joint_destroy");
	if (step == 90)
		must(cn_body_destroy(l->world, l->parts[2][4]), l->world, "cn_body_destroy");
	if (step == 120)
		must(cn_body_set_type(l->world, l->parts[3][2], CN_BODY_KINEMATIC), l->world, "cn_body_set_type");
	if (step == 150)
		must(cn_body_set_type(l->world, l->parts[3][2], CN_BODY_DYNAMIC), l->world, "cn_body_set_type");
	if (step == 180)
		doll(l, 4, 12.0f, 8.0f);
	if (step == 250) /* the stack has slept for long */
		must(cn_body_set_awake(l->world, l->stack[7], 1), l->world, "cn_body_set_awake");
	if (step == 300) /* what fell down sleeps by now */
		fixture_set_velocity(l->world, l->parts[0][0], 0.0f, 4.0f, 1.0f);
	if (step == 330)
		l->world->settings.work_budget = 200;
	if (step == 345)
		l->world->settings.work_budget = 0;
	if (step == 360)
		must(cn_world_set_solver(l->world, CN_SOLVER_DIRECT), l->world, "cn_world_set_solver");
}

static void plans_forget(cn_world *world)
{
	world->direct_plans[0].count = world->direct_plans[1].count = 0;
}

static void plans_free(cn_world *world)
{
	cni_array_deinit(&world->direct_plans[0], &world->memory);
	cni_array_deinit(&world->direct_plans[1], &world->memory);
}

static void kept_plans_change_nothing(void)
{
	static life kept, anew, denied;
	int32_t k, differ = 0, used = 0, refused = 0, slept = 0, woke = 0;
	begin(&kept);
	begin(&anew);
	begin(&denied);
	for (k = 0; k < STEPS; ++k) {
		int64_t calls;
		int32_t awake = fixture_counters(kept.world).bodies_awake;
		const void *plan = kept.world->direct_plans[0].data;
		live(&kept, k);
		live(&anew, k);
		live(&denied, k);
		plans_forget(anew.world);
		plans_free(denied.world);
		calls = kept.memory.calls;
		fixture_step(kept.world, 1);
		fixture_step(anew.world, 1);
		/* Nobody else asked for memory in this step: all that is refused is a plan's. */
		denied.memory.fail_at = kept.memory.calls == calls ? denied.memory.calls + 1 : 0;
		denied.memory.fail_after = 1;
		calls = denied.memory.calls;
		fixture_step(denied.world, 1);
		refused += denied.memory.fail_at != 0 && denied.memory.calls > calls;
		denied.memory.fail_at = 0;
		used += plan != NULL && kept.world->direct_plans[0].data == plan;
		slept += fixture_counters(kept.world).bodies_awake < awake;
		woke += fixture_counters(kept.world).bodies_awake > awake;
		differ += fixture_hash(kept.world) != fixture_hash(anew.world) || fixture_hash(kept.world) != fixture_hash(denied.world);
	}
	printf("  %d steps: %d with a plan in place, %d without memory for it, bodies fell asleep in %d, woke in %d\n", STEPS, (int)used, (int)refused, (int)slept, (int)woke);
	CHECK(differ == 0);
	CHECK(used > STEPS / 2 && refused > 100 && slept > 2 && woke > 1);
	CHECK(fixture_is_valid(kept.world) && fixture_is_valid(denied.world));
	cn_world_destroy(kept.world);
	cn_world_destroy(anew.world);
	cn_world_destroy(denied.world);
	CHECK(kept.memory.pieces == 0 && denied.memory.pieces == 0 && kept.memory.wrong_frees == 0);
}

/* ---- nets of which nothing is to be planned ---- */

#define NET_SIDE 16
#define NET_STEPS 150

typedef struct net_life {
	cn_world *world;
	cn_body body[NET_SIDE][NET_SIDE];
	cn_joint right[NET_SIDE][NET_SIDE], down[NET_SIDE][NET_SIDE]; /* from body[y][x] */
	int32_t told; /* steps for which lanes told that there was nothing to plan */
} net_life;

static void net_begin(net_life *n)
{
	int32_t x, y;
	memset(n, 0, sizeof *n);
	n->world = fixture_world(-10.0f, 0);
	for (y = 0; y < NET_SIDE; ++y)
		for (x = 0; x < NET_SIDE; ++x) {
			n->body[y][x] = fixture_circle(n->world, y == 0 && (x == 0 || x == NET_SIDE - 1) ? CN_BODY_STATIC : CN_BODY_DYNAMIC, (float)x, -(float)y, 0.3f, 0.6f, 0.0f);
			if (x > 0)
				n->right[y][x - 1] = hinge(n->world, n->body[y][x - 1], at(0.5f, 0.0f), n->body[y][x], at(-0.5f, 0.0f));
			if (y > 0)
				n->down[y - 1][x] = hinge(n->world, n->body[y - 1][x], at(0.0f, -0.5f), n->body[y][x], at(0.0f, 0.5f));
		}
}

/* Cuts a row's joints to the rows above and below, so that it is a chain, and so a tree; or makes them again. */
static void row_cut(net_life *n, int32_t y, int32_t cut)
{
	int32_t x, side;
	for (x = 0; x < NET_SIDE; ++x)
		for (side = 0; side < 2; ++side) {
			cn_joint *joint = &n->down[y - 1 + side][x];
			if (cut)
				must(cn_joint_destroy(n->world, *joint), n->world, "cn_joint_destroy");
			else
				*joint = hinge(n->world, n->body[y - 1 + side][x], at(0.0f, -0.5f), n->body[y + side][x], at(0.0f, 0.5f));
		}
}

/* Each changes what may be planned, and some leave the joints in their lanes. */
static void net_live(net_life *n, int32_t step)
{
	switch (step) {
	case 20: row_cut(n, 3, 1); break;
	case 30: row_cut(n, 3, 0); break;
	case 60: must(cn_joint_destroy(n->world, n->right[6][7]), n->world, "cn_joint_destroy"); break;
	case 61: row_cut(n, 7, 1); break;              /* in the step after lanes were taken anew */
	case 70: row_cut(n, 7, 0); break;
	case 90: must(cn_world_set_accuracy(n->world, CN_DEFAULT, 100), n->world, "cn_world_set_accuracy"); break;
	case 95: must(cn_world_set_accuracy(n->world, CN_DEFAULT, CN_DEFAULT), n->world, "cn_world_set_accuracy"); break;
	case 105: must(cn_body_set_type(n->world, n->body[5][5], CN_BODY_STATIC), n->world, "cn_body_set_type"); break;
	case 110: must(cn_body_set_type(n->world, n->body[5][5], CN_BODY_DYNAMIC), n->world, "cn_body_set_type"); break;
	case 120: must(cn_joint_set_solver(n->world, n->right[0][7], CN_SOLVER_DIRECT), n->world, "cn_joint_set_solver"); break;
	case 130: must(cn_joint_set_solver(n->world, n->right[0][7], CN_SOLVER_AUTO), n->world, "cn_joint_set_solver"); break;
	default: break;
	}
}

static void nets_that_are_not_planned_move_the_same(void)
{
	static net_life tells, asks;
	int32_t step, planned = 0;
	net_begin(&tells);
	net_begin(&asks);
	for (step = 0; step < NET_STEPS; ++step) {
		uint64_t a, b;
		net_live(&tells, step);
		net_live(&asks, step);
		asks.world->joint_lanes.alone = 0; /* plans in every step */
		fixture_step(tells.world, 1);
		fixture_step(asks.world, 1);
		tells.told += cni_joint_lanes_need_no_plan(tells.world);
		planned += fixture_counters(asks.world).direct_work > 0;
		REQUIRE(cn_world_hash(tells.world, &a) == CN_OK && cn_world_hash(asks.world, &b) == CN_OK);
		if (a != b)
			printf("  differs after step %d\n", (int)step);
		REQUIRE(a == b);
	}
	printf("  %d steps were not planned, something was solved directly in %d\n", (int)tells.told, (int)planned);
	CHECK_GE("steps that were not planned", tells.told, 40, "");
	CHECK_GE("steps in which something was solved directly", planned, 15, "");
	cn_world_destroy(tells.world);
	cn_world_destroy(asks.world);
}

/* A chain whose factorization is beyond the budget of 64 substeps, but not of one. */
static void fewer_substeps_leave_more_for_each(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[8];
	cn_joint joints[8];
	int32_t before;
	must(cn_world_set_substep_count(world, 64), world, "cn_world_set_substep_count");
	must(cn_world_set_accuracy(world, CN_DEFAULT, 1000), world, "cn_world_set_accuracy");
	make_chain(world, 8, 1.0f, 0.0f, bodies, joints);
	fixture_step(world, 5);
	before = fixture_counters(world).direct_work;
	must(cn_world_set_substep_count(world, 1), world, "cn_world_set_substep_count");
	fixture_step(world, 1);
	printf("  work planned with 64 substeps: %d, with 1: %d\n", (int)before, (int)fixture_counters(world).direct_work);
	CHECK(before == 0 && fixture_counters(world).direct_work > 0);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(kept_plans_change_nothing);
	RUN(fewer_substeps_leave_more_for_each);
	RUN(nets_that_are_not_planned_move_the_same);
	return test_end();
}
