/*
 * test/stability/motion.c - one body alone: flight, spin, a box on an incline.
 */
#include "scene.h"

#include <math.h>

static double angle_error(double angle, double exact) { return fabs(remainder(angle - exact, 2.0 * SCENE_PI)); }

/* ---- free: a thrown, spinning box against its parabola ---- */

#define THROW_X 7.0
#define THROW_Y 20.0

typedef struct free_state {
	double position_error, velocity_error;
} free_state;

static void free_build(scene_run *run)
{
	cn_body body = scene_box(run, CN_BODY_DYNAMIC, 0.0, 0.0, 0.0, 0.5, 0.25);
	scene_set_velocity(run, body, THROW_X, THROW_Y, scene_value(run, "spin"));
}

static void free_observe(scene_run *run)
{
	free_state *state = run->state;
	scene_motion m = scene_read(run, 0);
	double t = run->time_s, g = scene_value(run, "gravity");
	state->position_error = scene_greater(state->position_error, hypot(m.x - THROW_X * t, m.y - (THROW_Y - 0.5 * g * t) * t));
	state->velocity_error = scene_greater(state->velocity_error, hypot(m.vx - THROW_X, m.vy - (THROW_Y - g * t)));
}

static void free_finish(scene_run *run)
{
	const free_state *state = run->state;
	scene_motion m = scene_read(run, 0);
	double spin = scene_value(run, "spin");
	scene_report(run, "pos_err_m", state->position_error);
	scene_report(run, "vel_err", state->velocity_error);
	scene_report(run, "ang_err_rad", angle_error(m.angle, spin * run->time_s));
	scene_report(run, "spin_loss_frac", spin != 0.0 ? 1.0 - m.w / spin : 0.0);
}

/* ---- rod: a thin rod that spins without gravity ---- */

static void rod_build(scene_run *run)
{
	cn_body body = scene_box(run, CN_BODY_DYNAMIC, 0.0, 0.0, 0.0, 1.0, 0.05);
	scene_set_velocity(run, body, 0.0, 0.0, scene_value(run, "spin"));
}

static void rod_finish(scene_run *run)
{
	scene_motion m = scene_read(run, 0);
	double spin = scene_value(run, "spin"), start = 0.5 * m.inertia * spin * spin;
	scene_report(run, "spin_loss_pct", 100.0 * (1.0 - m.w / spin));
	scene_report(run, "ang_err_rad", angle_error(m.angle, spin * run->time_s));
	scene_report(run, "energy_end_pct", 100.0 * (scene_energy(run) / start - 1.0));
}

/* ---- incline: a box on a plane whose slope is ratio times the coefficient of friction ---- */

static double incline_angle(const scene_run *run) { return atan(scene_value(run, "ratio") * scene_value(run, "friction")); }

static void incline_build(scene_run *run)
{
	double angle = incline_angle(run), c = cos(angle), s = sin(angle);
	run->friction = scene_value(run, "friction");
	scene_box(run, CN_BODY_STATIC, s, -c, angle, 50.0, 1.0);
	scene_box(run, CN_BODY_DYNAMIC, -0.5 * s, 0.5 * c, angle, 0.5, 0.5);
}

static void incline_finish(scene_run *run)
{
	double angle = incline_angle(run), mu = scene_value(run, "friction"), t = run->time_s;
	double pull = scene_value(run, "gravity") * (sin(angle) - mu * cos(angle)), exact = pull > 0.0 ? 0.5 * pull * t * t : 0.0;
	scene_motion m = scene_read(run, 0);
	double slip = -((m.x - run->items[0].x) * cos(angle) + (m.y - run->items[0].y) * sin(angle));
	scene_report(run, "slip_m", slip);
	scene_report(run, "slip_exact_m", exact);
	scene_report(run, "slip_err_m", fabs(slip - exact));
}

const scene_family motion_families[] = {
	{ "free", "spin=3 seconds=10", sizeof(free_state), free_build, free_observe, free_finish },
	{ "rod", "spin=20 seconds=10 gravity=0", 0, rod_build, NULL, rod_finish },
	{ "incline", "ratio=0.98 friction=0.5 seconds=5", 0, incline_build, NULL, incline_finish },
};
const int32_t motion_family_count = (int32_t)(sizeof motion_families / sizeof *motion_families);
