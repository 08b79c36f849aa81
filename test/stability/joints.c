/*
 * test/stability/joints.c - structures held by joints: cantilevers, a bridge, a grid, a gear train, ragdolls, short chains.
 */
#include "scene.h"

#include <math.h>

/* ---- cantilever: welded boxes of 1 m that stand out of a wall ---- */

typedef struct cantilever_state {
	double sag, stretch;
} cantilever_state;

static void cantilever_build(scene_run *run)
{
	int32_t boxes = scene_count(run, "boxes"), k;
	cn_body previous = 0;
	run->group = -1;
	for (k = 0; k < boxes; ++k) {
		cn_body box;
		run->density = k + 1 == boxes ? scene_value(run, "tip") : 1.0;
		box = scene_box(run, CN_BODY_DYNAMIC, (double)k + 0.5, 0.0, 0.0, 0.5, 0.5);
		scene_weld(run, previous, box, (double)k, 0.0);
		previous = box;
	}
}

/* Of the middle of the last box. */
static double tip_sag(const scene_run *run) { return -scene_read(run, run->item_count - 1).y; }

static void cantilever_observe(scene_run *run)
{
	cantilever_state *state = run->state;
	state->sag = scene_greater(state->sag, fabs(tip_sag(run)));
	state->stretch = scene_greater(state->stretch, scene_anchor_error(run));
}

static void cantilever_finish(scene_run *run)
{
	const cantilever_state *state = run->state;
	scene_report(run, "tip_sag_max_m", state->sag);
	scene_report(run, "tip_sag_end_m", tip_sag(run));
	scene_report(run, "joint_stretch_max_m", state->stretch);
}

/* ---- what moving structures report: stretch, energy against the start, bodies below a depth ---- */

typedef struct held_state {
	double stretch, energy_start, energy_most, scale;
} held_state;

static void held_begin(scene_run *run, double height)
{
	held_state *state = run->state;
	int32_t k;
	if (run->refusal[0] != '\0')
		return;
	state->energy_start = state->energy_most = scene_energy(run);
	for (k = 0; k < run->item_count; ++k)
		state->scale += scene_read(run, k).mass * scene_value(run, "gravity") * height * scene_value(run, "size");
}

static void held_observe(scene_run *run)
{
	held_state *state = run->state;
	state->stretch = scene_greater(state->stretch, scene_anchor_error(run));
	state->energy_most = scene_greater(state->energy_most, scene_energy(run));
}

static void held_report(scene_run *run)
{
	const held_state *state = run->state;
	scene_report(run, "joint_stretch_max_m", state->stretch);
	scene_report(run, "joint_stretch_end_m", scene_anchor_error(run));
	scene_report(run, "energy_max_gain_pct", 100.0 * (state->energy_most - state->energy_start) / state->scale);
}

/* ---- bridge: planks of 1 m pinned along an arc that hangs between two points, and heavy boxes on them ---- */

#define BRIDGE_LOADS 3

static void bridge_build(scene_run *run)
{
	int32_t planks = scene_count(run, "planks"), k;
	double half = scene_value(run, "arc"), turn = 2.0 * half / (double)planks, radius = 0.5 / sin(0.5 * turn);
	cn_body previous = 0;
	for (k = 0; k < planks; ++k) {
		double at = -half + turn * (double)k, middle = at + 0.5 * turn, deep = radius * cos(0.5 * turn);
		cn_body plank = scene_box(run, CN_BODY_DYNAMIC, deep * sin(middle), -deep * cos(middle), middle, 0.5, 0.1);
		scene_pin(run, previous, plank, radius * sin(at), -radius * cos(at));
		previous = plank;
	}
	scene_pin(run, 0, previous, radius * sin(half), -radius * cos(half));
	run->density = scene_value(run, "load");
	for (k = 0; k < BRIDGE_LOADS; ++k)
		scene_box(run, CN_BODY_DYNAMIC, 2.0 * (double)(k - 1), -radius + 1.0, 0.0, 0.5, 0.5);
	held_begin(run, 1.0);
}

static void bridge_finish(scene_run *run)
{
	int32_t k, fallen = 0, planks = run->item_count - BRIDGE_LOADS;
	double lowest = 0.0;
	for (k = 0; k < planks; ++k)
		lowest = fmin(lowest, scene_read(run, k).y);
	for (k = planks; k < run->item_count; ++k)
		fallen += !(scene_read(run, k).y > lowest);
	held_report(run);
	scene_report(run, "fallen", (double)fallen);
}

/* ---- joint_grid: a square cloth of balls pinned to their neighbours, held by seven in the middle of its top ---- */

static void joint_grid_build(scene_run *run)
{
	int32_t side = scene_count(run, "side"), i, k;
	cn_body above[256], row[256];
	run->group = -1;
	if (side > 256)
		side = 256;
	for (i = 0; i < side; ++i) {
		for (k = 0; k < side; ++k) {
			int32_t held = i == 0 && k >= side / 2 - 3 && k <= side / 2 + 3;
			row[k] = scene_circle(run, held ? CN_BODY_STATIC : CN_BODY_DYNAMIC, (double)k, -(double)i, 0.4);
			if (i > 0)
				scene_pin(run, above[k], row[k], (double)k, 0.5 - (double)i);
			/* Two that are held need no pin, and may not have one. */
			if (k > 0 && !(held && k > side / 2 - 3))
				scene_pin(run, row[k - 1], row[k], (double)k - 0.5, -(double)i);
		}
		for (k = 0; k < side; ++k)
			above[k] = row[k];
	}
	held_begin(run, (double)side);
}

/* ---- gear_train: wheels on fixed axles, each geared to the next, the first driven by a motor ---- */

#define WHEELS_MAX 32

typedef struct gear_state {
	double angle[WHEELS_MAX], last[WHEELS_MAX]; /* over whole turns; as read */
	double error, stretch;
} gear_state;

static double wheel_radius(int32_t wheel) { return wheel % 2 == 0 ? 0.5 : 0.25; }
static double wheel_ratio(int32_t wheel) { return -wheel_radius(wheel - 1) / wheel_radius(wheel); }

static void gear_to(scene_run *run, cn_body previous, cn_body wheel, double ratio)
{
	cn_gear_def def;
	cn_joint joint;
	cn_gear_def_init(&def);
	def.base.body_a = previous;
	def.base.body_b = wheel;
	def.ratio = (float)ratio;
	scene_check(run, cn_joint_create_gear(run->world, &def, &joint));
}

static void drive(scene_run *run, cn_joint axle)
{
	scene_check(run, cn_joint_set_flags(run->world, axle, CN_JOINT_MOTOR));
	scene_check(run, cn_joint_set_motor(run->world, axle, (float)scene_value(run, "speed"), (float)scene_value(run, "torque")));
}

static void gear_train_build(scene_run *run)
{
	int32_t wheels = scene_count(run, "wheels"), k;
	double x = 0.0;
	cn_body previous = 0;
	run->group = -1;
	for (k = 0; k < wheels && k < WHEELS_MAX; ++k) {
		cn_body wheel;
		x += k > 0 ? wheel_radius(k - 1) + wheel_radius(k) : 0.0;
		wheel = scene_circle(run, CN_BODY_DYNAMIC, x, 0.0, wheel_radius(k));
		scene_pin(run, 0, wheel, x, 0.0);
		if (k > 0)
			gear_to(run, previous, wheel, wheel_ratio(k));
		previous = wheel;
	}
	drive(run, run->joints[0]);
}

static void gear_train_observe(scene_run *run)
{
	gear_state *state = run->state;
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		double angle = scene_read(run, k).angle;
		state->angle[k] += remainder(angle - state->last[k], 2.0 * SCENE_PI);
		state->last[k] = angle;
		if (k > 0)
			state->error = scene_greater(state->error, fabs(state->angle[k] - wheel_ratio(k) * state->angle[k - 1]));
	}
	state->stretch = scene_greater(state->stretch, scene_anchor_error(run));
}

static void gear_train_finish(scene_run *run)
{
	const gear_state *state = run->state;
	scene_report(run, "gear_err_max_rad", state->error);
	scene_report(run, "speed_err_rel", fabs(scene_read(run, 0).w / scene_value(run, "speed") - 1.0));
	scene_report(run, "joint_stretch_max_m", state->stretch);
}

/* ---- ragdolls: a pile of figures of 1.6 m in a pit ---- */

typedef struct bone {
	double y, from, to, radius; /* of a capsule */
	int32_t parent;
	double pin_y, lower, upper; /* limits in turns of pi */
} bone;

/* Hip, torso, head, then two legs and two arms of two bones each. */
static const bone bones[] = {
	{ 0.95, -0.02, 0.02, 0.095, -1, 0.0, 0.0, 0.0 },
	{ 1.2, -0.135, 0.135, 0.09, 0, 1.0, -0.25, 0.0 },
	{ 1.475, -0.038, 0.039, 0.075, 1, 1.4, -0.3, 0.1 },
	{ 0.775, -0.125, 0.125, 0.06, 0, 0.9, -0.05, 0.4 },
	{ 0.475, -0.155, 0.125, 0.045, 3, 0.625, -0.5, 0.0 },
	{ 0.775, -0.125, 0.125, 0.06, 0, 0.9, -0.05, 0.4 },
	{ 0.475, -0.155, 0.125, 0.045, 5, 0.625, -0.5, 0.0 },
	{ 1.225, -0.125, 0.125, 0.035, 1, 1.35, -0.1, 0.8 },
	{ 0.975, -0.125, 0.125, 0.03, 7, 1.1, -0.2, 0.3 },
	{ 1.225, -0.125, 0.125, 0.035, 1, 1.35, -0.1, 0.8 },
	{ 0.975, -0.125, 0.125, 0.03, 9, 1.1, -0.2, 0.3 },
};
#define BONES ((int32_t)(sizeof bones / sizeof *bones))
#define PIT_HALF 1.5

static void make_ragdoll(scene_run *run, double x, double y)
{
	cn_body made[sizeof bones / sizeof *bones];
	int32_t k;
	--run->group;
	for (k = 0; k < BONES; ++k) {
		const bone *b = &bones[k];
		made[k] = scene_body(run, CN_BODY_DYNAMIC, x, y + b->y, 0.0);
		scene_capsule_shape(run, made[k], 0.0, b->from, 0.0, b->to, b->radius);
		if (b->parent >= 0)
			scene_pin_limited(run, made[b->parent], made[k], x, y + b->pin_y, b->lower * SCENE_PI, b->upper * SCENE_PI);
	}
}

static void make_pit(scene_run *run)
{
	scene_floor(run);
	scene_box(run, CN_BODY_STATIC, -PIT_HALF - 1.0, 5.0, 0.0, 1.0, 5.0);
	scene_box(run, CN_BODY_STATIC, PIT_HALF + 1.0, 5.0, 0.0, 1.0, 5.0);
}

static void ragdolls_build(scene_run *run)
{
	int32_t count = scene_count(run, "count"), k;
	make_pit(run);
	run->friction = 0.2;
	for (k = 0; k < count; ++k)
		make_ragdoll(run, 0.8 * (double)(k % 3 - 1) + 0.02 * (double)(k / 3), 0.5 + 1.8 * (double)(k / 3));
	held_begin(run, 1.0);
}

static void pit_finish(scene_run *run)
{
	double wide = PIT_HALF * scene_value(run, "size");
	int32_t k, lost = 0;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		lost += !(m.y > 0.0 && fabs(m.x) < wide);
	}
	held_report(run);
	scene_report(run, "lost", (double)lost);
}

/* ---- links: short chains of thin boxes fall into the same pit ---- */

static void make_links(scene_run *run, int32_t links, double x, double y, double half_y)
{
	cn_body previous = 0;
	int32_t k;
	--run->group;
	for (k = 0; k < links; ++k) {
		cn_body link;
		run->density = k % 2 == 1 ? scene_value(run, "ratio") : 1.0;
		link = scene_box(run, CN_BODY_DYNAMIC, x + 0.3 * (double)k, y, 0.0, 0.15, half_y);
		if (k > 0)
			scene_pin(run, previous, link, x + 0.3 * (double)k - 0.15, y);
		previous = link;
	}
}

static void links_build(scene_run *run)
{
	int32_t count = scene_count(run, "count"), links = scene_count(run, "links"), k;
	make_pit(run);
	for (k = 0; k < count; ++k)
		make_links(run, links, -1.2 + 1.3 * (double)(k % 2) + 0.05 * (double)(k / 2 % 3), 0.5 + 0.4 * (double)(k / 2), 0.05 + 0.01 * (double)(k % 5));
	held_begin(run, 1.0);
}

const scene_family joint_families[] = {
	{ "cantilever", "boxes=10 tip=1 seconds=10", sizeof(cantilever_state), cantilever_build, cantilever_observe, cantilever_finish },
	{ "bridge", "planks=20 load=20 arc=0.5 seconds=10", sizeof(held_state), bridge_build, held_observe, bridge_finish },
	{ "joint_grid", "side=100 seconds=5", sizeof(held_state), joint_grid_build, held_observe, held_report },
	{ "gear_train", "wheels=8 speed=4 torque=10 gravity=0 seconds=10", sizeof(gear_state), gear_train_build, gear_train_observe, gear_train_finish },
	{ "links", "count=40 links=2 ratio=1 seconds=10", sizeof(held_state), links_build, held_observe, pit_finish },
	{ "ragdolls", "count=12 seconds=10", sizeof(held_state), ragdolls_build, held_observe, pit_finish },
};
const int32_t joint_family_count = (int32_t)(sizeof joint_families / sizeof *joint_families);
