/*
 * contacts/pile_state.c - tests of piles: is a body or an island quiet, has an island joints, does a contact bear more than soft
 * constraints can?
 */
#include "contacts/contacts.h"

static int32_t body_is_slower(const cn_world *world, const cni_body *b, cni_vec2 frame, float most)
{
	const cni_motion *m = cni_motions(world) + b->awake;
	float turn = m->w * b->extent;
	return cni_sq(m->vx - frame.x) + cni_sq(m->vy - frame.y) <= most * most && turn * turn <= most * most;
}

static int32_t bodies_are_slower(const cn_world *world, const cni_island *i, cni_vec2 frame, float most)
{
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (!body_is_slower(world, cni_body_at(world, body), frame, most))
			return 0;
	return 1;
}

/* ---- what carries an island ---- */

/* Is the body kinematic, and moves without turning, but for rounding? Stores its velocity where the other one is. */
static int32_t carries(const cn_world *world, int32_t body, const cni_body *other, cni_vec2 *velocity)
{
	const cni_body *b = body == CNI_NONE ? NULL : cni_body_at(world, body);
	if (b == NULL || b->type != CN_BODY_KINEMATIC || b->awake == CNI_NONE)
		return 0;
	const cni_motion *m = cni_motions(world) + b->awake;
	*velocity = cni_v(m->vx - m->w * (other->cy - b->cy), m->vy + m->w * (other->cx - b->cx));
	return cni_abs(m->w) <= CNI_CARRIER_SPIN && (m->vx != 0.0f || m->vy != 0.0f);
}

static int32_t is_carried(const cn_world *world, const cni_body *b, cni_vec2 *velocity)
{
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		if (cni_contact_has_lane(cni_contact_of_key(world, key)) && carries(world, cni_contact_of_key(world, key)->body[1 - (key & 1)], b, velocity))
			return 1;
	for (int32_t key = b->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		if (carries(world, cni_joint_at(world, key >> 1)->body[1 - (key & 1)], b, velocity))
			return 1;
	return 0;
}

/* Does the body move with what may carry it, rather than rest beside it? */
static int32_t moves_with(const cni_motion *m, cni_vec2 velocity)
{
	return cni_sq(m->vx - velocity.x) + cni_sq(m->vy - velocity.y) < cni_sq(m->vx) + cni_sq(m->vy);
}

/* Bodies of a crowd move apart, which two of them show: what carries others is only looked for where all move together. */
static cni_vec2 frame_find(const cn_world *world, const cni_island *i)
{
	const cni_body *first = cni_body_at(world, i->first);
	const cni_motion *m = cni_motions(world) + first->awake;
	cni_vec2 zero = { 0.0f, 0.0f }, velocity = zero;
	if (body_is_slower(world, first, zero, CNI_REST_SPEED * world->settings.length_unit) ||
	    !bodies_are_slower(world, i, cni_v(m->vx, m->vy), 2.0f * CNI_PILE_QUIET_SPEED * world->settings.length_unit))
		return zero;
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (is_carried(world, cni_body_at(world, body), &velocity))
			return moves_with(m, velocity) ? velocity : zero;
	return zero;
}

cni_vec2 cni_island_frame(const cn_world *world, cni_island *i)
{
	if (i->frame_step != world->step_count + 1u) {
		i->frame_step = world->step_count + 1u;
		i->frame = frame_find(world, i);
	}
	return i->frame;
}

/* ---- speeds ---- */

int32_t cni_island_is_slower(const cn_world *world, cni_island *i, float most)
{
	return bodies_are_slower(world, i, cni_island_frame(world, i), most);
}

int32_t cni_island_is_quiet(const cn_world *world, cni_island *i)
{
	return cni_island_is_slower(world, i, CNI_PILE_QUIET_SPEED * world->settings.length_unit);
}

int32_t cni_body_is_quiet(const cn_world *world, const cni_body *b)
{
	cni_vec2 zero = { 0.0f, 0.0f };
	return body_is_slower(world, b, zero, CNI_PILE_QUIET_SPEED * world->settings.length_unit);
}

/* ---- islands and contacts ---- */

int32_t cni_body_is_jointed(const cn_world *world, const cni_body *b)
{
	return (cni_externals(world)[b->awake].flags & CNI_EXTERNAL_JOINTED) != 0;
}

int32_t cni_island_has_joints(const cn_world *world, int32_t island)
{
	for (int32_t body = cni_island_at(world, island)->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (cni_body_is_jointed(world, cni_body_at(world, body)))
			return 1;
	return 0;
}

/*
 * Soft contacts yield by about g h^2 per carried weight, so a column of s bodies shortens by s^2 g h^2. When that is not small
 * against its width, the column tilts faster than the solver rights it: small bodies sooner than large ones.
 */
int32_t cni_is_stressed(const cn_world *world, int32_t ia, int32_t ib, float impulse, float h, float part)
{
	float g = cni_length(world->settings.gravity), inv_a = cni_motions(world)[ia].inv_mass, inv_b = cni_motions(world)[ib].inv_mass;
	float stress = g > 0.0f ? impulse * cni_max(inv_a, inv_b) / (part * h * g) : 0.0f;
	float size = cni_body_at(world, cni_awake_ids(world)[inv_b > inv_a ? ib : ia])->extent;
	return stress > CNI_PILE_STRESS_MAX || stress * stress * g * h * h > CNI_PILE_BUCKLING_PART * size;
}
