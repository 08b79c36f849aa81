/*
 * stages/solve_make.c - the numbers of one step: substep length and soft-constraint coefficients.
 */
#include "stages/contact_pass.h"

cni_soft cni_soft_implicit(float hertz, float damping_ratio, float h)
{
	float omega = 2.0f * CNI_PI * hertz;
	float a1 = 2.0f * damping_ratio + h * omega;
	float a2 = h * omega * a1;
	float a3 = 1.0f / (1.0f + a2);
	cni_soft soft = { 1.0f, 0.0f, 0.0f };
	if (hertz <= 0.0f)
		return soft;
	soft.mass_scale = a2 * a3;
	soft.bias_scale = omega / a1 * soft.mass_scale;
	soft.impulse_scale = a3;
	return soft;
}

/* e^x for x <= 0 by halving into [-0.5, 0] and squaring back; relative error < 1e-6 where it is not tiny. */
static float exp_negative(float x)
{
	int32_t halvings = 0;
	float e;
	if (x < -80.0f)
		return 0.0f;
	while (x < -0.5f) {
		x *= 0.5f;
		++halvings;
	}
	e = 1.0f + x * (1.0f + x * (0.5f + x * (1.0f / 6.0f + x * (1.0f / 24.0f + x * (1.0f / 120.0f + x * (1.0f / 720.0f))))));
	while (halvings-- > 0)
		e *= e;
	return e;
}

/*
 * One body on the spring, stepped as v' = v + j / m, x' = x + h v' with j = -m (b v + a x), is the linear
 * map with determinant 1 - b and trace 2 - b - h a. The true motion over h has determinant
 * e^(-2 zeta w h) and trace 2 e^(-zeta w h) cos(w_d h) (cosh when overdamped); equating them gives a, b.
 */
cni_soft cni_soft_exact(float hertz, float damping_ratio, float h)
{
	float wh = 2.0f * CNI_PI * hertz * h, zeta = damping_ratio, half_trace, det;
	cni_soft soft = { 0.0f, 0.0f, 1.0f };
	if (wh <= 0.0f)
		return soft;
	det = exp_negative(-2.0f * zeta * wh);
	if (zeta < 1.0f) {
		half_trace = exp_negative(-zeta * wh) * cni_sincos(wh * cni_sqrt(1.0f - zeta * zeta)).c;
	} else {
		float root = cni_sqrt(zeta * zeta - 1.0f);
		half_trace = 0.5f * (exp_negative(-(zeta - root) * wh) + exp_negative(-(zeta + root) * wh));
	}
	soft.mass_scale = 1.0f - det;
	soft.bias_scale = (1.0f + det - 2.0f * half_trace) / h;
	soft.impulse_scale = det;
	return soft;
}

static cni_solve make(const cn_world *world, float dt, int32_t substeps)
{
	const cni_settings *set = &world->settings;
	cni_solve s;
	float last = world->step_dt;
	s.dt = dt;
	s.substeps = substeps;
	s.h = dt / (float)substeps;
	s.inv_h = s.h > 0.0f ? 1.0f / s.h : 0.0f;
	s.warm_scale = (set->flags & CN_WORLD_WARM_START) == 0 ? 0.0f : last > 0.0f ? cni_min(dt / last, 4.0f) : 1.0f;
	s.push_speed = set->push_speed_max;
	s.restitution_threshold = set->restitution_threshold;
	s.contact = cni_soft_implicit(0.125f * s.inv_h, 10.0f, s.h);
	s.contact_static = cni_soft_implicit(0.25f * s.inv_h, 10.0f, s.h);
	s.joint = cni_soft_implicit(0.25f * s.inv_h, 2.0f, s.h);
	s.kernel = cni_contact_kernel_choose();
	return s;
}

cni_solve cni_solve_make(const cn_world *world, float dt)
{
	return make(world, dt, world->settings.substeps);
}

cni_solve cni_solve_make_sequential(const cn_world *world, float dt)
{
	cni_solve s = make(world, dt, 1);
	s.warm_scale = 0.0f;
	return s;
}
