/*
 * step/solve_make.c - the numbers of one step: substep length and soft-constraint coefficients.
 */
#include "step/stages.h"
#include "contacts/contact_pass.h"
#include "step/integrate_pass.h"
#include "joints/joint_pass.h"

/* CNI_LOAD_HEAVY / (h stress^2) of a step, times the square of the speed that the impulse gives. Weightless bodies are compared with
   bodies under standard gravity: without a limit, the loads of contacts that press a wedged body from both sides rise for as long as it moves,
   and the first of them to lose its impulse throws it. */
static float load_heavy(const cn_world *world, const cni_solve *s)
{
	float g_sq = cni_length_sq(world->settings.gravity), standard = CNI_STANDARD_GRAVITY * world->settings.length_unit;
	return CNI_LOAD_HEAVY * s->dt * s->h * (g_sq > 0.0f ? g_sq : standard * standard);
}

/*
 * Contacts harden with depth, to twice their frequency. A soft contact sinks in proportion to what it bears, so bodies deep in a moving
 * crowd overlap by the weight of all above. Stiff contacts from the start would let tall piles sway: a pushed pyramid of base 100 falls.
 * At rest loads keep overlaps below a slop, so that piles are as soft as they must be. Contacts that bear more than
 * CNI_CRUSH_ACCELERATION are crushed: hard ones would throw a crowd at 4.2 times the speed of the plate that presses it against a wall.
 */
static void hardening_make(const cn_world *world, const cni_solve *s, float hertz, cni_contact_pass *pass)
{
	float slop = world->settings.slop;
	pass->deep = CNI_ON(HARDENING) ? cni_soft_implicit(2.0f * hertz, 10.0f, s->h) : pass->soft;
	pass->deep_rate = 1.0f / ((CNI_DEEP_SLOPS - 1.0f) * slop);
	pass->deep_from = -slop * pass->deep_rate;
	pass->crush_rate = s->inv_h / (CNI_CRUSH_ACCELERATION * world->settings.length_unit);
}

static cni_contact_pass contact_pass_make(const cn_world *world, const cni_solve *s, int32_t kind)
{
	float hertz = (kind & CNI_CONTACTS_ONE_SIDED ? 0.25f : 0.125f) * s->soft_rate;
	cni_contact_pass pass;
	pass.inv_h = s->inv_h;
	pass.push_speed = s->push_speed;
	pass.impact_speed = CNI_ON(IMPACTS) ? -s->restitution_threshold : -FLT_MAX;
	pass.warm_scale = s->warm_scale;
	pass.load_part = cni_min(CNI_LOAD_RATE * s->dt, 1.0f);
	pass.load_heavy = load_heavy(world, s);
	pass.one_sided = (kind & CNI_CONTACTS_ONE_SIDED) != 0;
	pass.soft = cni_soft_implicit(hertz, 10.0f, s->h);
	hardening_make(world, s, hertz, &pass);
	if (kind & CNI_CONTACTS_RESTED) {
		pass.load_part /= (float)s->substeps;
		pass.load_heavy /= (float)s->substeps;
	}
	return pass;
}

/*
 * A mean of the step lengths. Stiffness is tied to it and not to the current step: a spring k = m / h^2 that changes with every
 * step drives the sway of a pile (parametric excitation), by more than softness damps it when steps vary by more than half. If
 * all steps are equal, the mean equals them to the bit.
 */
static float mean_step(const cn_world *world, float dt)
{
	float mean = world->mean_dt, part = cni_max(CNI_MEAN_STEP_PART, 1.0f / ((float)world->step_count + 1.0f));
	return mean > 0.0f && CNI_ON(MEAN_STEP) ? mean + part * (cni_min(dt, 2.0f * mean) - mean) : dt;
}

/*
 * The longest step of late. Joints bear loads over long spans, so their stiffness does not rise with the mean within a second: a stretched bridge
 * that becomes 16 times as stiff, in slow motion, is thrown by 16 times its tension. A rare long step does not soften them.
 */
static float longest_step(const cn_world *world, float dt)
{
	float longest = world->longest_dt;
	return CNI_ON(MEAN_STEP) ? cni_max(dt, longest + cni_min(dt / CNI_LONGEST_STEP_S, 1.0f) * (dt - longest)) : dt;
}

static float joint_hertz(const cni_solve *s)
{
	return cni_min(0.25f * s->inv_h, cni_max(CNI_JOINT_HERTZ_LEAST, 0.25f / cni_max(s->joint_h, FLT_MIN)));
}

/*
 * A joint under load keeps a gap that its closing holds. In shorter steps it closes no faster than in the longest of late: a straight bridge at rest that
 * closed 100 times as fast, in slow motion, would be thrown by its lever.
 */
static float joint_error_rate(const cni_solve *s)
{
	return CNI_JOINT_ERROR_RATE * cni_min(s->inv_h, 1.0f / cni_max(s->joint_h, FLT_MIN));
}

/*
 * What is borne is a force: a longer step needs larger impulses, a shorter one smaller ones. Where the product of these factors does
 * not remain the ratio of the steps, a pile sags or jumps: walls fell at once with a limit of 4 when a step was 0.2 to 1.8 times the
 * mean (a ratio of 9). After a pause nothing is known.
 */
static float warm_scale(const cn_world *world, float dt)
{
	float last = world->step_dt;
	if ((world->settings.flags & CN_WORLD_WARM_START) == 0)
		return 0.0f;
	return last > 0.0f ? cni_min(dt / last, CNI_WARM_STEP_RATIO_MAX) : 1.0f;
}

static void joints_make(const cn_world *world, cni_solve *s)
{
	s->joint_warm_scale = cni_min(s->warm_scale, 1.0f); /* an impact's impulse is no load: seven times as much of it, after a pause, throws chains */
	s->joint_h = s->longest_dt / (float)s->substeps;
	s->joint_error_rate = joint_error_rate(s);
	s->restless_speed = CNI_JOINT_RESTLESS * world->settings.length_unit;
	s->joint = cni_soft_implicit(joint_hertz(s), 2.0f, s->h);
	s->joint_turn_most = cni_min(CNI_JOINT_GAP_MOST, CNI_JOINT_CLOSING_MOST / cni_soft_error_rate(&s->joint, 1));
	s->joint_gap_most = s->joint_turn_most * world->settings.length_unit;
	s->joint_kernel = cni_joint_kernel_choose();
}

cni_solve cni_solve_make(const cn_world *world, float dt, int32_t substeps)
{
	const cni_settings *set = &world->settings;
	cni_solve s;
	memset(&s, 0, sizeof s);
	s.dt = dt;
	s.substeps = substeps;
	s.h = dt / (float)substeps;
	s.inv_h = s.h > 0.0f ? 1.0f / s.h : 0.0f;
	s.mean_dt = mean_step(world, dt);
	s.soft_rate = s.mean_dt > 0.0f ? 1.0f / (s.mean_dt / (float)substeps) : 0.0f;
	s.longest_dt = longest_step(world, dt);
	s.warm_scale = warm_scale(world, dt);
	s.push_speed = set->push_speed_max;
	s.restitution_threshold = set->restitution_threshold;
	for (int32_t kind = 0; kind < CNI_CONTACTS_KINDS; ++kind)
		s.contact[kind] = contact_pass_make(world, &s, kind);
	s.pushed_most = dt * cni_min(set->slop * cni_soft_error_rate(&s.contact[0].soft, 1), 0.5f * set->push_speed_max); /* a slop is left */
	s.kernel = cni_contact_kernel_choose();
	if (CNI_HAS_JOINTS)
		joints_make(world, &s);
	s.body_kernel = cni_body_kernel_choose();
	return s;
}

cni_solve cni_solve_make_sequential(const cn_world *world, float dt)
{
	cni_solve s = cni_solve_make(world, dt, 1);
	s.warm_scale = 0.0f;
	s.pushed_most = world->settings.slop; /* it corrects overlaps at once */
	s.body_kernel = NULL; /* its displacements at the end are corrections alone: finalize.c, body_is_pushed */
	return s;
}
