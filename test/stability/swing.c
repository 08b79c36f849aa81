/*
 * test/stability/swing.c - pendulums and chains of rods, against exact periods and integrated references.
 */
#include "scene.h"

#include <math.h>

#define ROD_THIN 0.05
#define REFERENCE_STEPS 40 /* RK4 steps a frame: an error far below a nanometre for two rods */

/* ---- energy as a share of the height that the system falls through ---- */

typedef struct swing_energy {
	double start, scale, most;
} swing_energy;

static void energy_begin(swing_energy *energy, const scene_run *run, double scale)
{
	energy->start = energy->most = scene_energy(run);
	energy->scale = scale;
}

static void energy_observe(swing_energy *energy, const scene_run *run) { energy->most = scene_greater(energy->most, scene_energy(run)); }

static void energy_report(const swing_energy *energy, scene_run *run)
{
	scene_report(run, "energy_max_gain_pct", 100.0 * (energy->most - energy->start) / energy->scale);
	scene_report(run, "energy_end_pct", 100.0 * (scene_energy(run) - energy->start) / energy->scale);
}

/* ---- pendulum: a rod of 1 m on a pin, released at rest ---- */

#define PENDULUM_PERIODS 20

typedef struct pendulum_state {
	swing_energy energy;
	double anchor_error;
	double last_angle, last_time;
	double first, previous, period_first, period_late; /* times of falling zero crossings */
	int32_t crossings;
} pendulum_state;

static double from_hanging(const scene_run *run) { return remainder(scene_read(run, 0).angle + 0.5 * SCENE_PI, 2.0 * SCENE_PI); }

static void pendulum_build(scene_run *run)
{
	pendulum_state *state = run->state;
	double angle = scene_value(run, "angle"), size = scene_value(run, "size");
	cn_body rod = scene_box(run, CN_BODY_DYNAMIC, 0.5 * sin(angle), -0.5 * cos(angle), angle - 0.5 * SCENE_PI, 0.5, ROD_THIN);
	double mass;
	scene_pin(run, 0, rod, 0.0, 0.0);
	mass = scene_read(run, 0).mass;
	energy_begin(&state->energy, run, mass * scene_value(run, "gravity") * 0.5 * size * (1.0 - cos(angle)));
	state->last_angle = angle;
}

static void pendulum_observe(scene_run *run)
{
	pendulum_state *state = run->state;
	double angle = from_hanging(run);
	energy_observe(&state->energy, run);
	state->anchor_error = scene_greater(state->anchor_error, scene_anchor_error(run));
	if (state->last_angle > 0.0 && angle <= 0.0) {
		double at = state->last_time + (run->time_s - state->last_time) * state->last_angle / (state->last_angle - angle);
		if (state->crossings == 0)
			state->first = at;
		if (state->crossings == 1)
			state->period_first = at - state->previous;
		if (state->crossings == PENDULUM_PERIODS)
			state->period_late = at - state->previous;
		state->previous = at;
		++state->crossings;
	}
	state->last_angle = angle;
	state->last_time = run->time_s;
}

static void pendulum_finish(scene_run *run)
{
	const pendulum_state *state = run->state;
	scene_motion m = scene_read(run, 0);
	double arm = 0.5 * scene_value(run, "size"), g = scene_value(run, "gravity");
	double exact = reference_period(2.0 * SCENE_PI * sqrt((m.inertia + m.mass * arm * arm) / (m.mass * g * arm)), scene_value(run, "angle"));
	double mean = state->crossings > 1 ? (state->previous - state->first) / (double)(state->crossings - 1) : 0.0;
	energy_report(&state->energy, run);
	scene_report(run, "pin_drift_max_m", state->anchor_error);
	scene_report(run, "period_err_pct", 100.0 * fabs(state->period_first / exact - 1.0));
	scene_report(run, "period20_err_pct", 100.0 * fabs(state->period_late / exact - 1.0));
	scene_report(run, "period_mean_err_pct", 100.0 * fabs(mean / exact - 1.0));
}

/* ---- rods pinned one after the other; shared by double_pend and chain ---- */

typedef struct chain_state {
	swing_energy energy;
	reference_chain reference;
	double reached_s; /* the reference's time */
	double stretch, trajectory_error, diverged_s, end_start_y;
} chain_state;

/* Straight from the pin at the origin: along +x (swing) or down (hang). */
static void build_rods(scene_run *run, int32_t links, double length, int32_t hang)
{
	cn_body previous = 0;
	int32_t k;
	run->group = -1;
	for (k = 0; k < links; ++k) {
		double middle = ((double)k + 0.5) * length, pinned = (double)k * length;
		cn_body rod = scene_box(run, CN_BODY_DYNAMIC, hang ? 0.0 : middle, hang ? -middle : 0.0, hang ? -0.5 * SCENE_PI : 0.0, 0.5 * length, ROD_THIN);
		scene_pin(run, previous, rod, hang ? 0.0 : pinned, hang ? -pinned : 0.0);
		previous = rod;
	}
}

static void set_reference(scene_run *run, int32_t links, double length, double end_mass, int32_t hang)
{
	reference_chain *reference = &((chain_state *)run->state)->reference;
	scene_motion rod = scene_read(run, 0);
	int32_t k;
	reference->links = links < REFERENCE_LINKS_MAX ? links : REFERENCE_LINKS_MAX;
	reference->length = length * scene_value(run, "size");
	reference->mass = rod.mass;
	reference->inertia = rod.inertia;
	reference->end_mass = end_mass;
	reference->gravity = scene_value(run, "gravity");
	for (k = 0; k < reference->links; ++k)
		reference->angle[k] = hang ? -0.5 * SCENE_PI : 0.0;
}

/* Where the reference ends, less where the library's end is. */
static double reference_error(scene_run *run, double x, double y, int32_t steps)
{
	chain_state *state = run->state;
	double exact_x, exact_y;
	reference_chain_advance(&state->reference, run->time_s - state->reached_s, steps);
	state->reached_s = run->time_s;
	reference_chain_end(&state->reference, &exact_x, &exact_y);
	return hypot(x - exact_x, y - exact_y);
}

/* ---- double_pend: two rods of 1 m, released level ---- */

static void double_pend_build(scene_run *run)
{
	chain_state *state = run->state;
	double size = scene_value(run, "size");
	build_rods(run, 2, 1.0, 0);
	set_reference(run, 2, 1.0, 0.0, 0);
	energy_begin(&state->energy, run, state->reference.mass * scene_value(run, "gravity") * 2.0 * size);
	state->diverged_s = -1.0;
}

static void double_pend_observe(scene_run *run)
{
	chain_state *state = run->state;
	scene_motion m = scene_read(run, 1);
	double arm = 0.5 * scene_value(run, "size"), error;
	error = reference_error(run, m.x + arm * cos(m.angle), m.y + arm * sin(m.angle), REFERENCE_STEPS);
	energy_observe(&state->energy, run);
	state->stretch = scene_greater(state->stretch, scene_anchor_error(run));
	if (run->time_s <= 1.0 + 1e-6)
		state->trajectory_error = scene_greater(state->trajectory_error, error);
	if (state->diverged_s < 0.0 && !(error < 0.1))
		state->diverged_s = run->time_s;
}

static void double_pend_finish(scene_run *run)
{
	const chain_state *state = run->state;
	energy_report(&state->energy, run);
	scene_report(run, "pin_drift_max_m", state->stretch);
	scene_report(run, "tip_err_max_1s_m", state->trajectory_error);
	scene_report(run, "t_diverge_0.1m_s", state->diverged_s < 0.0 ? run->time_s : state->diverged_s);
}

/* ---- chain: links of 0.8 m and 1:ratio a ball pinned by its centre to the end ---- */

#define LINK_LENGTH 0.8
#define BALL_RADIUS 0.5

static void chain_build(scene_run *run)
{
	chain_state *state = run->state;
	int32_t links = scene_count(run, "links"), hang = scene_count(run, "hang");
	double end = LINK_LENGTH * (double)links, g = scene_value(run, "gravity"), ball_mass;
	cn_body last, ball;
	build_rods(run, links, LINK_LENGTH, hang);
	last = run->items[run->item_count - 1].body;
	run->density = scene_value(run, "ratio") * LINK_LENGTH * 2.0 * ROD_THIN / (SCENE_PI * BALL_RADIUS * BALL_RADIUS);
	ball = scene_circle(run, CN_BODY_DYNAMIC, hang ? 0.0 : end, hang ? -end : 0.0, BALL_RADIUS);
	scene_pin(run, last, ball, hang ? 0.0 : end, hang ? -end : 0.0);
	if (run->refusal[0] != '\0')
		return;
	ball_mass = scene_read(run, links).mass;
	set_reference(run, links, LINK_LENGTH, ball_mass, hang);
	end *= scene_value(run, "size");
	energy_begin(&state->energy, run, g * end * (ball_mass + 0.5 * state->reference.mass * (double)links));
	state->end_start_y = scene_read(run, links).y;
}

static void chain_observe(scene_run *run)
{
	chain_state *state = run->state;
	energy_observe(&state->energy, run);
	state->stretch = scene_greater(state->stretch, scene_anchor_error(run));
	if (scene_count(run, "hang") == 0 && run->time_s <= 3.0 + 1e-6 && scene_count(run, "links") <= REFERENCE_LINKS_MAX) {
		scene_motion ball = scene_read(run, run->item_count - 1);
		state->trajectory_error = scene_greater(state->trajectory_error, reference_error(run, ball.x, ball.y, REFERENCE_STEPS));
	}
}

static void chain_finish(scene_run *run)
{
	const chain_state *state = run->state;
	scene_report(run, "joint_stretch_max_m", state->stretch);
	scene_report(run, "joint_stretch_end_m", scene_anchor_error(run));
	energy_report(&state->energy, run);
	if (scene_count(run, "hang") == 0)
		scene_report(run, "ball_traj_err_3s_m", state->trajectory_error);
	else
		scene_report(run, "ball_drop_m", state->end_start_y - scene_read(run, run->item_count - 1).y);
}

const scene_family swing_families[] = {
	{ "pendulum", "angle=1 seconds=60", sizeof(pendulum_state), pendulum_build, pendulum_observe, pendulum_finish },
	{ "double_pend", "seconds=10", sizeof(chain_state), double_pend_build, double_pend_observe, double_pend_finish },
	{ "chain", "links=20 ratio=10 hang=0 seconds=10", sizeof(chain_state), chain_build, chain_observe, chain_finish },
};
const int32_t swing_family_count = (int32_t)(sizeof swing_families / sizeof *swing_families);
