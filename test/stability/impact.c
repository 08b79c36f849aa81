/*
 * test/stability/impact.c - restitution and fast bodies: drops, a cluster that collapses, a row of balls, bullets.
 */
#include "scene.h"

#include <math.h>

/* ---- drop: apexes of a bouncing ball, from its heights alone ---- */

#define APEXES 5
#define DROP_RADIUS 0.5

typedef struct drop_state {
	double before[2]; /* the last two heights */
	double apex[APEXES];
	int32_t count;
} drop_state;

static void drop_build(scene_run *run)
{
	drop_state *state = run->state;
	scene_floor(run);
	run->restitution = scene_value(run, "e");
	scene_circle(run, CN_BODY_DYNAMIC, 0.0, DROP_RADIUS + scene_value(run, "height"), DROP_RADIUS);
	state->before[0] = state->before[1] = scene_value(run, "height") * scene_value(run, "size");
}

/* The top of the parabola through three heights, if they are one flight: else the highest of them. */
static double parabola_top(double a, double b, double c, double fall)
{
	double bend = 2.0 * b - a - c;
	return fabs(bend - fall) < 0.02 * fall ? b + (c - a) * (c - a) / (8.0 * bend) : b;
}

static void drop_observe(scene_run *run)
{
	drop_state *state = run->state;
	double height = scene_read(run, 0).y - DROP_RADIUS * scene_value(run, "size");
	double fall = scene_value(run, "gravity") * run->dt_s * run->dt_s;
	if (run->frame > 2 && state->before[1] > state->before[0] && state->before[1] >= height && state->count < APEXES)
		state->apex[state->count++] = parabola_top(state->before[0], state->before[1], height, fall);
	state->before[0] = state->before[1];
	state->before[1] = height;
}

static void drop_finish(scene_run *run)
{
	const drop_state *state = run->state;
	double start = scene_value(run, "height") * scene_value(run, "size"), e = scene_value(run, "e"), exact = start, worst = 0.0, error = 0.0;
	int32_t k;
	for (k = 0; k < APEXES; ++k) {
		exact *= e * e;
		error = state->apex[k] - exact;
		worst = scene_greater(worst, fabs(error));
		if (k == 0)
			scene_report(run, "apex1_err_m", error);
	}
	scene_report(run, "apex5_err_m", error);
	scene_report(run, "apex_maxerr_frac_of_h0", worst / start);
}

/* ---- shared by what collides without gravity: energy and momentum against the start ---- */

typedef struct conserved {
	scene_momentum start;
	double energy_start, energy_most, momentum_scale;
	double linear_drift, angular_drift;
} conserved;

static void conserved_begin(conserved *state, const scene_run *run)
{
	int32_t k;
	state->start = scene_momentum_read(run);
	state->energy_start = state->energy_most = scene_energy(run);
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		state->momentum_scale += m.mass * hypot(m.vx, m.vy);
	}
}

static void conserved_observe(scene_run *run)
{
	conserved *state = run->state;
	scene_momentum now = scene_momentum_read(run);
	double linear = hypot(now.x - state->start.x, now.y - state->start.y) / state->momentum_scale;
	double angular = state->start.angular != 0.0 ? fabs(now.angular / state->start.angular - 1.0) : 0.0;
	state->energy_most = scene_greater(state->energy_most, scene_energy(run));
	state->linear_drift = scene_greater(state->linear_drift, linear);
	state->angular_drift = scene_greater(state->angular_drift, angular);
}

static void conserved_report(scene_run *run)
{
	const conserved *state = run->state;
	scene_report(run, "lin_mom_drift_rel", state->linear_drift);
	scene_report(run, "ang_mom_drift_rel", state->angular_drift);
	scene_report(run, "energy_max_over_E0", state->energy_most / state->energy_start);
	scene_report(run, "energy_end_over_E0", scene_energy(run) / state->energy_start);
}

/* ---- cluster: balls and boxes that fall inwards, with a swirl ---- */

static void cluster_build(scene_run *run)
{
	int32_t side = scene_count(run, "side"), i, j;
	run->restitution = scene_value(run, "e");
	run->friction = scene_value(run, "friction");
	for (i = 0; i < side; ++i)
		for (j = 0; j < side; ++j) {
			double x = 1.5 * ((double)j - 0.5 * (double)(side - 1)), y = 1.5 * ((double)i - 0.5 * (double)(side - 1));
			/* Not on a lattice: a golden sequence moves each a little. */
			x += 0.2 * fmod(0.618034 * (double)(i * side + j + 1), 1.0);
			y += 0.2 * fmod(0.754878 * (double)(i * side + j + 1), 1.0);
			if ((i + j) % 2 == 0)
				scene_circle(run, CN_BODY_DYNAMIC, x, y, 0.4);
			else
				scene_box(run, CN_BODY_DYNAMIC, x, y, 0.0, 0.4, 0.3);
			scene_set_velocity(run, run->items[run->item_count - 1].body, -2.0 * x - 0.5 * y, -2.0 * y + 0.5 * x, 0.0);
		}
	conserved_begin(run->state, run);
}

/* ---- collision_chain: a ball hits a row of equal balls with small gaps ---- */

typedef struct chain_state {
	conserved sums; /* first: conserved_observe reads it */
	double last_speed;
} chain_state;

#define CHAIN_SPEED 5.0

static void collision_chain_build(scene_run *run)
{
	int32_t k, balls = scene_count(run, "balls");
	run->restitution = scene_value(run, "e");
	run->friction = 0.0;
	for (k = 0; k < balls; ++k)
		scene_circle(run, CN_BODY_DYNAMIC, (1.0 + scene_value(run, "gap")) * (double)k, 0.0, 0.5);
	scene_set_velocity(run, run->items[0].body, CHAIN_SPEED, 0.0, 0.0);
	conserved_begin(run->state, run);
}

static void collision_chain_observe(scene_run *run)
{
	chain_state *state = run->state;
	/* The last ball's first speed: with e < 1 the ones behind may push it again. */
	if (state->last_speed == 0.0)
		state->last_speed = scene_read(run, run->item_count - 1).vx;
	conserved_observe(run);
}

static void collision_chain_finish(scene_run *run)
{
	const chain_state *state = run->state;
	double exact = CHAIN_SPEED * pow(0.5 * (1.0 + scene_value(run, "e")), (double)(run->item_count - 1));
	scene_report(run, "last_speed_err_rel", fabs(state->last_speed / exact - 1.0));
	conserved_report(run);
}

/* ---- bullet: balls of 5 cm at walls of 10 cm, one wall each ---- */

#define BULLETS 20
#define WALL_HALF 0.05

static void bullet_build(scene_run *run)
{
	double speed = scene_value(run, "speed"), y, x;
	int32_t k, walls_move = scene_count(run, "wall") > 0;
	for (k = 0; k < BULLETS; ++k) {
		y = 2.0 * (double)k;
		/* Every phase of the step at which a wall may be met. */
		x = -2.0 - speed * run->dt_s * (double)k / (double)BULLETS;
		run->body_flags = scene_count(run, "wall") == 2 ? CN_BODY_BULLET : 0;
		scene_circle(run, CN_BODY_DYNAMIC, x, y, 0.025);
		scene_set_velocity(run, run->items[run->item_count - 1].body, speed, 0.0, 0.0);
		run->body_flags = 0;
		if (walls_move)
			scene_box(run, CN_BODY_DYNAMIC, 0.0, y, 0.0, WALL_HALF, 0.9);
		else
			scene_box(run, CN_BODY_STATIC, 0.0, y, 0.0, WALL_HALF, 0.9);
	}
}

/* A bullet whose centre is beyond the middle of its wall went through. */
static void bullet_finish(scene_run *run)
{
	int32_t k, through = 0, stride = run->item_count / BULLETS;
	for (k = 0; k < BULLETS; ++k) {
		scene_motion ball = scene_read(run, k * stride);
		double wall = stride == 2 ? scene_read(run, k * stride + 1).x : 0.0;
		through += !(ball.x < wall);
	}
	scene_report(run, "tunnel_frac", (double)through / (double)BULLETS);
}

const scene_family impact_families[] = {
	{ "drop", "e=1 height=4 seconds=10", sizeof(drop_state), drop_build, drop_observe, drop_finish },
	{ "cluster", "e=1 side=6 friction=0 gravity=0 seconds=5", sizeof(conserved), cluster_build, conserved_observe, conserved_report },
	{ "collision_chain", "e=1 balls=10 gap=0.05 gravity=0 seconds=3", sizeof(chain_state), collision_chain_build, collision_chain_observe, collision_chain_finish },
	{ "bullet", "speed=390 wall=0 gravity=0 seconds=1", 0, bullet_build, NULL, bullet_finish },
};
const int32_t impact_family_count = (int32_t)(sizeof impact_families / sizeof *impact_families);
