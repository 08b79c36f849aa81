/*
 * step/solve_make.c - the numbers of one step: substep length and soft-constraint coefficients.
 */
#include "contacts/contact_pass.h"
#include "step/integrate_pass.h"
#include "joints/joint_pass.h"

/*
 * What is borne is a force: a longer step needs larger impulses, a shorter one smaller ones. Where the product of these factors does
 * not remain the ratio of the steps, a pile sags or jumps: walls fell at once with a limit of 4 when a step was 0.2 to 1.8 times the
 * mean (a ratio of 9). After a pause nothing is known.
 */
#define WARM_MOST 20.0f
#define MEAN_PART (1.0f / 64.0f) /* of a step in the mean: about a second's steps count */

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

/* 1 - e^-x for x >= 0 to a few units in the last place however small x is: a series up to 0.5, then E(2x) = E (2 - E). */
static float decay_of(float x)
{
	int32_t halvings = 0;
	float e;
	if (x > 80.0f)
		return 1.0f;
	for (; x > 0.5f; x *= 0.5f)
		++halvings;
	e = x * (1.0f - x * (0.5f - x * (1.0f / 6.0f - x * (1.0f / 24.0f - x * (1.0f / 120.0f - x * (1.0f / 720.0f - x * (1.0f / 5040.0f)))))));
	while (halvings-- > 0)
		e *= 2.0f - e;
	return e;
}

/* 1 + D - T of a damped oscillation over a time h, without cancellation: D and T are the determinant and the
   trace of the map from (x, v) now to (x, v) then. = (1 - z1)(1 - z2) with its eigenvalues z. */
static float oscillation_pull(float wh, float zeta)
{
	if (zeta < 1.0f) {
		float e = decay_of(zeta * wh), sine = cni_sincos(0.5f * wh * cni_sqrt(1.0f - zeta * zeta)).s;
		return e * e + 4.0f * (1.0f - e) * sine * sine;
	} else {
		float root = zeta + cni_sqrt(zeta * zeta - 1.0f);
		return decay_of(wh / root) * decay_of(wh * root);
	}
}

/*
 * How much of a spring's impulse is carried over (r D below), so that a constant load stretches it by
 * load / k exactly: pull (1 - r) = w^2 h^2 (D + (T - 3 D) r). Damping of a velocity that already has
 * the load's share of the substep would else make it stiffer by about zeta w h. For light damping at high
 * frequency no r below 1 does it, and the error without is a few hundredths at most.
 */
static float spring_memory(float pull, float det, float wh)
{
	float ratio = pull / (wh * wh), n = ratio - det, d = ratio + 1.0f - 2.0f * det - pull;
	return n > 0.0f && n < d ? cni_min(n / d, 0.6f) : 0.0f;
}

/*
 * One body on the spring, stepped as p' = m p - b v - a x, v' = v + p', x' = x + h v', with p the impulse over
 * the mass, has three eigenvalues. Two are made those of the true motion over h, with determinant
 * D = e^(-2 zeta w h) and trace T = 2 e^(-zeta w h) cos(w_d h) (cosh when overdamped), the third is r. Comparing
 * coefficients: m = D r, b = 1 - D + r (2 D - T), h a = (1 + D - T)(1 - r). Springs stiffer than the
 * rigid joints of model/solve.h, 1/(4h), are as stiff as those: beyond the substep's reach their waves alias.
 */
cni_soft cni_soft_exact(float hertz, float damping_ratio, float h)
{
	float wh = cni_min(2.0f * CNI_PI * hertz * h, 0.5f * CNI_PI), pull, decay, r;
	cni_soft soft = { 0.0f, 0.0f, 1.0f };
	if (!CNI_ON(EXACT_SPRINGS))
		return cni_soft_implicit(hertz, damping_ratio, h);
	if (wh < 1e-12f)
		return soft;
	decay = decay_of(2.0f * damping_ratio * wh);
	pull = oscillation_pull(wh, damping_ratio);
	r = spring_memory(pull, 1.0f - decay, wh);
	soft.mass_scale = decay * (1.0f - r) + r * pull;
	soft.bias_scale = pull * (1.0f - r) / h;
	soft.impulse_scale = 1.0f - decay + r * (2.0f * decay - pull - 1.0f); /* 1 - b - m */
	return soft;
}

/* CNI_LOAD_HEAVY / (h stress^2) of a step, times the square of the speed that the impulse gives. Without gravity there is
   no weight to compare with. */
static float load_heavy(const cn_world *world, const cni_solve *s)
{
	float g_sq = cni_length_sq(world->settings.gravity);
	return g_sq > 0.0f ? CNI_LOAD_HEAVY * s->dt * s->h * g_sq : FLT_MAX;
}

static cni_contact_pass contact_pass_make(const cn_world *world, const cni_solve *s, int32_t kind)
{
	float rate = s->soft_rate;
	cni_contact_pass pass;
	pass.inv_h = s->inv_h;
	pass.push_speed = s->push_speed;
	pass.impact_speed = CNI_ON(IMPACTS) ? -s->restitution_threshold : -FLT_MAX;
	pass.warm_scale = s->warm_scale;
	pass.load_part = cni_min(CNI_LOAD_RATE * s->dt, 1.0f);
	pass.load_heavy = load_heavy(world, s);
	pass.one_sided = (kind & CNI_CONTACTS_ONE_SIDED) != 0;
	pass.soft = cni_soft_implicit(pass.one_sided ? 0.25f * rate : 0.125f * rate, 10.0f, s->h);
	if (kind & CNI_CONTACTS_RESTED) {
		pass.load_part /= (float)s->substeps;
		pass.load_heavy /= (float)s->substeps;
	}
	return pass;
}

/*
 * A mean of the steps. Stiffness is tied to it and not to the step that is taken: a spring of k = m / h^2 that is another in every step
 * drives the sway of a pile (parametric excitation), by more than softness damps it when steps vary by more than half. Where all steps
 * are equal the mean is equal to them, to the bit.
 */
static float mean_step(const cn_world *world, float dt)
{
	float mean = world->mean_dt, part = cni_max(MEAN_PART, 1.0f / ((float)world->step_count + 1.0f));
	return mean > 0.0f && CNI_ON(MEAN_STEP) ? mean + part * (cni_min(dt, 2.0f * mean) - mean) : dt;
}

static cni_solve make(const cn_world *world, float dt, int32_t substeps)
{
	const cni_settings *set = &world->settings;
	cni_solve s;
	float last = world->step_dt;
	int32_t kind;
	memset(&s, 0, sizeof s);
	s.dt = dt;
	s.substeps = substeps;
	s.h = dt / (float)substeps;
	s.inv_h = s.h > 0.0f ? 1.0f / s.h : 0.0f;
	s.mean_dt = mean_step(world, dt);
	s.soft_rate = s.mean_dt > 0.0f ? 1.0f / (s.mean_dt / (float)substeps) : 0.0f;
	s.warm_scale = (set->flags & CN_WORLD_WARM_START) == 0 ? 0.0f : last > 0.0f ? cni_min(dt / last, WARM_MOST) : 1.0f;
	s.push_speed = set->push_speed_max;
	s.restitution_threshold = set->restitution_threshold;
	s.shock_speed = set->length_unit;
	for (kind = 0; kind < CNI_CONTACTS_KINDS; ++kind)
		s.contact[kind] = contact_pass_make(world, &s, kind);
	s.joint = cni_soft_implicit(0.25f * s.inv_h, 2.0f, s.h);
	s.kernel = cni_contact_kernel_choose();
	s.joint_kernel = cni_joint_kernel_choose();
	s.body_kernel = cni_body_kernel_choose();
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
