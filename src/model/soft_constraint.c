/*
 * model/soft_constraint.c - coefficients of soft constraints and springs from their frequency, damping ratio and substep.
 */
#include "model/solve.h"

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

/*
 * Springs and joints with a stiffness are solved once a substep, and the impulse of the last substep is a part of the next. Exact joints make their
 * bodies heavier than the row's mass, so that this part lags behind: with 0.25 / h, as rigid joints have, which are relaxed, it drives them.
 */
cni_soft cni_soft_row(float hertz, float damping_ratio, float h)
{
	return cni_soft_implicit(cni_min(hertz, 0.125f / h), damping_ratio, h);
}

/* 1 - e^-x for x >= 0, accurate to a few units in the last place for small x too: a series up to 0.5, then E(2x) = E (2 - E). */
static float decay_of(float x)
{
	int32_t halvings = 0;
	if (x > 80.0f)
		return 1.0f;
	for (; x > 0.5f; x *= 0.5f)
		++halvings;
	float e = x * (1.0f - x * (0.5f - x * (1.0f / 6.0f - x * (1.0f / 24.0f - x * (1.0f / 120.0f - x * (1.0f / 720.0f - x * (1.0f / 5040.0f)))))));
	while (halvings-- > 0)
		e *= 2.0f - e;
	return e;
}

/* 1 + D - T of a damped oscillation over a time h, without cancellation: D and T are the determinant and the trace of the map of
   position and velocity over h. It equals (1 - z1)(1 - z2) with the eigenvalues z of the map. */
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
 * The carried part of a spring's impulse (r D below), so that a constant load stretches it by load / k exactly:
 *   pull (1 - r) = w^2 h^2 (D + (T - 3 D) r)
 * Without it, damping of a velocity that already has the load's share of the substep would make the spring stiffer by about zeta
 * w h. For light damping at high frequency no r below 1 does it, and the error without it is a few hundredths at most.
 */
static float spring_memory(float pull, float det, float wh)
{
	float ratio = pull / (wh * wh), n = ratio - det, d = ratio + 1.0f - 2.0f * det - pull;
	return n > 0.0f && n < d ? cni_min(n / d, 0.6f) : 0.0f;
}

/*
 * One body on the spring, stepped as below, with p the impulse over the mass, has three eigenvalues:
 *   p' = m p - b v - a x     v' = v + p'     x' = x + h v'
 * Two are set to those of the true motion over h, with determinant D and trace T (cosh when overdamped), the third is r:
 *   D = e^(-2 zeta w h)     T = 2 e^(-zeta w h) cos(w_d h)
 * Comparing coefficients:
 *   m = D r     b = 1 - D + r (2 D - T)     h a = (1 + D - T)(1 - r)
 * A body on several springs has waves several times as fast. Where these may be beyond the substep's resolution, springs are implicit, which loses
 * energy instead of gaining it: a lattice of discs with eight springs each reached 250 to 400 m/s.
 */
cni_soft cni_soft_exact(float hertz, float damping_ratio, float h)
{
	float wh = 2.0f * CNI_PI * hertz * h, pull, decay, r;
	cni_soft soft = { 0.0f, 0.0f, 1.0f };
	if (!CNI_ON(EXACT_SPRINGS) || wh > CNI_SPRING_TURN_MOST)
		return cni_soft_row(hertz, damping_ratio, h);
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
