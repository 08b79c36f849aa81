/*
 * stages/contact_joined.c - few contacts on bodies that joints hold, solved through their joints.
 *
 * A heavy box on a light plank of a bridge: a pass over the contact sees the plank alone, not the bridge that holds it, and
 * passes over contacts and joints by turns would need thousands of rounds. So contacts of a loop of pins, and of an island
 * with joints that have come apart, see the joints: stages/contact_reach.c. Here is which contacts those are, their way out
 * of their lanes and back, and what they may do to energy. Where little lies on them, or the contacts are too many, or of a
 * kind that cannot be solved so, these stay in their lanes, by turns with the joints (stages/joint_close.c).
 *
 * Closing gaps lifts what hangs, more than the gap where joints are nearly in line. What stands on fixed ground and
 * is not driven may not end a substep with more kinetic energy than it began with and its drive gave on the way; the rest is
 * taken out of all its velocities.
 *
 * Loops stay while the soft solver would let them come apart again. Those that are given back all the same begin from no
 * impulse.
 *
 * Reads and writes lanes of contact blocks, motion velocities, start; islands' tier fields, joints' held_step.
 */
#include "stages/press.h"
#include "stages/joint_work.h"

#include <string.h>

#define LOAD_MOST 800.0f       /* masses that touch, each contact its heavier one, over the lightest */
#define SOFT_GIVE 0.4f         /* 1 / (w h)^2 of soft joints: stages/solve_make.c */

/* ---- which ---- */

static int32_t joined_may_be(const cn_world *world, int32_t island)
{
	const cni_island *i = cni_island_at(world, island);
	return i->tier == CNI_TIER_DIRECT && i->solver != CN_SOLVER_DIRECT && cni_island_has_joints(world, island);
}

static int32_t component_island(const cn_world *world, const cni_sparse *sparse, const cni_component *c)
{
	return c->body_begin < c->body_end ? cni_awake_island(world, sparse->bodies[c->body_begin]) : CNI_NONE;
}

static int32_t is_of_this_step(const cn_world *world, int32_t island)
{
	return cni_island_at(world, island)->joined_step == world->step_count + 1u;
}

static void place_give(const cn_world *world, int32_t island, int32_t place)
{
	cni_island_at(world, island)->joined = place;
	cni_island_at(world, island)->joined_step = world->step_count + 1u;
}

/* NULL: none. */
static cni_joined *joined_of(const cn_world *world, const cni_sparse *sparse, int32_t island)
{
	int32_t place = island != CNI_NONE && is_of_this_step(world, island) ? cni_island_at(world, island)->joined : CNI_NONE;
	return place != CNI_NONE ? &sparse->joined[place] : NULL;
}

static void components_find(const cn_world *world, cni_sparse *sparse)
{
	int32_t k;
	for (k = sparse->component_count - 1; k >= 0 && sparse->joined_count > 0; --k) {
		cni_component *c = &sparse->components[k];
		cni_joined *j = joined_of(world, sparse, component_island(world, sparse, c));
		if (j == NULL)
			continue;
		c->joined = (int32_t)(j - sparse->joined);
		c->joined_next = j->component;
		j->component = k;
		j->loops |= c->loops;
	}
}

/* Does so much lie on what is so light that passes by turns would let it through? */
static int32_t is_heavily_laden(const cn_world *world, const cni_joined *j)
{
	float load = 0.0f, lightest = 0.0f;
	int32_t i;
	for (i = 0; i < j->count; ++i) {
		const cni_contact_block *block = cni_block_at(world, j->presses[i].block);
		float inv_a = cni_motions(world)[block->ia[j->presses[i].lane]].inv_mass, inv_b = cni_motions(world)[block->ib[j->presses[i].lane]].inv_mass;
		load += inv_a > 0.0f && inv_b > 0.0f ? 1.0f / cni_min(inv_a, inv_b) : 0.0f;
		lightest = cni_max(lightest, cni_max(inv_a, inv_b));
	}
	return load * lightest > LOAD_MOST;
}

/* Contacts of so many islands. */
static int32_t presses_room(int32_t islands)
{
	return CNI_JOINED_CONTACTS * cni_min_i(islands, CNI_JOINED_FULL);
}

/* Its contacts, of which there may be so many. Loops that bear little leave them to the soft solver. */
static void presses_find(const cn_world *world, cni_joined *j, cni_press *presses, int32_t room)
{
	j->presses = presses;
	j->count = cni_presses_collect(world, j->island, presses, cni_min_i(CNI_JOINED_CONTACTS, room));
	j->in_lanes = j->count < 0 || (j->loops && !is_heavily_laden(world, j));
	j->count = j->in_lanes ? 0 : j->count;
	j->columns = (3 * j->count + 3) & ~3;
}

static void island_join(const cn_world *world, cni_sparse *out, int32_t island)
{
	cni_joined *j = &out->joined[out->joined_count];
	memset(j, 0, sizeof *j);
	j->island = island;
	j->component = CNI_NONE;
	j->fresh = 1;
	j->turned = FLT_MAX;
	place_give(world, island, out->joined_count++);
}

int32_t cni_joined_collect(cn_world *world, cni_sparse *out)
{
	const int32_t *islands = (const int32_t *)world->direct_islands.data;
	int32_t k, presses = 0, most = world->awake_joints.count > 0 ? cni_min_i(world->direct_islands.count, CNI_JOINED_ISLANDS) : 0, room = presses_room(most);
	if (most == 0)
		return 1;
	out->joined = (cni_joined *)cni_arena_push(&world->arena, sizeof(cni_joined) * (uint64_t)most);
	out->joined_presses = (cni_press *)cni_arena_push(&world->arena, sizeof(cni_press) * (uint64_t)room);
	if (out->joined == NULL || out->joined_presses == NULL)
		return 0;
	for (k = 0; k < world->direct_islands.count && out->joined_count < most; ++k)
		if (!is_of_this_step(world, islands[k]) && joined_may_be(world, islands[k]))
			island_join(world, out, islands[k]);
	components_find(world, out);
	for (k = 0; k < out->joined_count; ++k) {
		presses_find(world, &out->joined[k], out->joined_presses + presses, room - presses);
		presses += out->joined[k].count;
	}
	return 1;
}

const cni_joined *cni_component_joined(const cni_sparse *sparse, const cni_component *c)
{
	return c->joined != CNI_NONE && c->joined < sparse->joined_count ? &sparse->joined[c->joined] : NULL;
}

static int32_t not_done_from(const cni_sparse *sparse, int32_t k)
{
	while (k != CNI_NONE && sparse->components[k].done)
		k = sparse->components[k].joined_next;
	return k;
}

int32_t cni_joined_first(const cni_sparse *sparse, const cni_joined *joined)
{
	return not_done_from(sparse, joined->component);
}

int32_t cni_joined_next(const cni_sparse *sparse, int32_t k)
{
	return not_done_from(sparse, sparse->components[k].joined_next);
}

/* ---- what of it may change its energy ---- */

static int32_t is_driven_by(const cn_world *world, int32_t index)
{
	const cni_motion *m = cni_motions(world) + index;
	return index != 0 && m->inv_mass == 0.0f && (m->vx != 0.0f || m->vy != 0.0f || m->w != 0.0f);
}

static int32_t is_still(const cn_world *world, int32_t index)
{
	return cni_motions(world)[index].inv_mass == 0.0f;
}

static void ends_look(const cn_world *world, cni_joined *j, int32_t ia, int32_t ib)
{
	j->grounded |= is_still(world, ia) || is_still(world, ib);
	j->driven |= is_driven_by(world, ia) || is_driven_by(world, ib);
}

static int32_t may_drive(const cni_joint_work *w)
{
	return (w->flags & CNI_WORK_SPRINGY) || (w->record->flags & (CN_JOINT_SPRING | CN_JOINT_MOTOR));
}

static void drives_look(const cn_world *world, cni_sparse *sparse)
{
	int32_t k, i;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_work *w = cni_joint_works(world) + k;
		cni_joined *j = joined_of(world, sparse, cni_joint_island(world, w->ia, w->ib));
		if (j == NULL)
			continue;
		ends_look(world, j, w->ia, w->ib);
		j->driven |= may_drive(w);
	}
	for (k = 0; k < sparse->joined_count; ++k)
		for (i = 0; i < sparse->joined[k].count; ++i)
			ends_look(world, &sparse->joined[k], sparse->joined[k].presses[i].ia, sparse->joined[k].presses[i].ib);
}

/* ---- lanes ---- */

static uint64_t reach_floats(const cni_joined *j)
{
	return (uint64_t)(j->columns * j->columns);
}

static int32_t nodes_most(const cni_sparse *sparse)
{
	int32_t k, most = 0;
	for (k = 0; k < sparse->component_count; ++k)
		most = cni_max_i(most, sparse->components[k].end - sparse->components[k].begin);
	return most;
}

static void presses_take(cn_world *world, cni_joined *j)
{
	int32_t i;
	for (i = 0; i < j->count; ++i) {
		cni_press *p = &j->presses[i];
		p->ia = cni_block_at(world, p->block)->ia[p->lane];
		p->ib = cni_block_at(world, p->block)->ib[p->lane];
		p->untouched = 0; /* whatever becomes of it, its impulses are solved for */
		cni_press_take(world, p);
	}
}

static void held_mark(cn_world *world, const cni_sparse *sparse)
{
	int32_t k, n;
	world->joined_step = world->step_count + 1u;
	for (k = 0; k < sparse->component_count; ++k) {
		const cni_component *c = &sparse->components[k];
		if (c->done || cni_component_joined(sparse, c) == NULL)
			continue;
		for (n = c->begin; n < c->end; ++n)
			cni_joint_at(world, cni_joint_works(world)[sparse->nodes[n].owner].joint)->held_step = world->joined_step;
	}
}

void cni_joined_let_go(cn_world *world)
{
	int32_t k, r;
	if (world->joined_step != world->step_count || world->step_count == 0)
		return;
	for (k = 0; k < world->awake_joints.count; ++k) {
		cni_joint_work *w = cni_joint_works(world) + k;
		cni_joint *j = cni_joint_at(world, w->joint);
		if (j->held_step != world->step_count || (w->flags & CNI_WORK_DIRECT))
			continue;
		for (r = 0; r < CNI_JOINT_RIGID_ROWS; ++r)
			j->impulse[r] = 0.0f;
		for (r = 0; r < w->row_count && r < w->rigid_count; ++r)
			w->rows[r].impulse = 0.0f;
	}
}

void cni_joined_take(cn_world *world, cni_sparse *sparse)
{
	uint64_t floats = 0;
	int32_t k, columns = 0;
	float *reach, *nodes;
	for (k = 0; k < sparse->joined_count; ++k) {
		floats += reach_floats(&sparse->joined[k]);
		columns = cni_max_i(columns, sparse->joined[k].columns);
	}
	if (sparse->joined_count == 0)
		return;
	reach = (float *)cni_arena_push(&world->arena, sizeof(float) * floats);
	nodes = (float *)cni_arena_push(&world->arena, sizeof(float) * (uint64_t)(columns * CNI_NODE_ROWS * nodes_most(sparse)));
	if (reach == NULL || nodes == NULL) {
		sparse->joined_count = 0; /* their contacts are the soft solver's */
		return;
	}
	held_mark(world, sparse);
	for (k = 0; k < sparse->joined_count; ++k) {
		sparse->joined[k].reach = reach;
		sparse->joined[k].nodes = nodes;
		reach += reach_floats(&sparse->joined[k]);
		presses_take(world, &sparse->joined[k]);
	}
	drives_look(world, sparse);
}

uint64_t cni_joined_bytes(int32_t joints, int32_t contacts)
{
	const uint64_t rows = 3 * CNI_JOINED_CONTACTS;
	int32_t islands = cni_min_i(joints, CNI_JOINED_ISLANDS);
	uint64_t most = (uint64_t)cni_min_i(contacts, CNI_JOINED_CONTACTS * CNI_JOINED_FULL);
	if (joints == 0)
		return 0;
	return sizeof(cni_joined) * (uint64_t)islands + sizeof(cni_press) * (uint64_t)presses_room(islands) +
	       sizeof(float) * rows * (3 * most + CNI_NODE_ROWS * (uint64_t)joints) + 256;
}

/* Would its joints come apart if the soft solver had them? They give way by about 0.4 h of the speed that what they bear
   gives to their bodies alone. */
static int32_t joints_are_laden(const cn_world *world, const cni_solve *s, const cni_component *c)
{
	float most = CNI_BAD_PART * world->settings.accuracy / (SOFT_GIVE * s->h);
	const cni_motion *motions = cni_motions(world);
	int32_t k, i;
	for (k = c->begin; k < c->end; ++k) {
		const cni_node *n = &s->direct->nodes[k];
		for (i = 0; i < n->rows; ++i) {
			const cni_lever *l = &n->lever[i];
			const cni_motion *a = motions + n->ia, *b = motions + n->ib;
			float own = cni_lever_inverse_mass(l, a, b);
			if (own * cni_abs(cni_joint_works(world)[n->owner].rows[i].impulse) > most)
				return 1;
		}
	}
	return 0;
}

void cni_joined_look(cn_world *world, const cni_solve *s)
{
	int32_t k;
	for (k = 0; k < s->direct->component_count && s->direct->joined_count > 0; ++k) {
		const cni_component *c = &s->direct->components[k];
		if (!c->done && !c->presses && cni_component_joined(s->direct, c) != NULL && joints_are_laden(world, s, c))
			cni_island_at(world, cni_awake_island(world, s->direct->bodies[c->body_begin]))->good_steps = 0;
	}
}

void cni_joined_give_back(cn_world *world, cni_sparse *sparse)
{
	int32_t k, i;
	for (k = 0; k < sparse->joined_count; ++k)
		for (i = 0; i < sparse->joined[k].count; ++i)
			cni_press_give_back(world, &sparse->joined[k].presses[i]);
}

/* ---- energy ---- */

static const cni_body *next_of(const cn_world *world, const cni_body *b)
{
	return b->island_next == CNI_NONE ? NULL : cni_body_at(world, b->island_next);
}

static const cni_body *first_of(const cn_world *world, const cni_joined *j)
{
	return cni_body_at(world, cni_island_at(world, j->island)->first);
}

/* Twice the kinetic energy. */
static float energy_of(const cni_motion *m, float vx, float vy, float w)
{
	float moving = m->inv_mass > 0.0f ? (vx * vx + vy * vy) / m->inv_mass : 0.0f;
	return m->inv_inertia > 0.0f ? moving + w * w / m->inv_inertia : moving;
}

/* Twice what its drive gives to a body that moves like this for a substep. */
static float work_of(const cni_motion *m, const cni_drive *d, float h)
{
	float moving = m->inv_mass > 0.0f ? (d->ax * m->vx + d->ay * m->vy) / m->inv_mass : 0.0f;
	return 2.0f * h * (m->inv_inertia > 0.0f ? moving + d->alpha * m->w / m->inv_inertia : moving);
}

void cni_joined_moved(cn_world *world, const cni_solve *s, cni_joined *j)
{
	const cni_body *b;
	float most = 0.0f;
	j->energy = 0.0f;
	for (b = first_of(world, j); b != NULL; b = next_of(world, b)) {
		const cni_motion *m = cni_motions(world) + b->awake;
		const cni_drive *d = cni_drives(world) + b->awake;
		cni_velocity_start *v = cni_starts(world) + b->awake;
		j->energy += energy_of(m, v->vx - s->h * d->ax, v->vy - s->h * d->ay, v->w - s->h * d->alpha) + work_of(m, d, s->h);
		v->struck = cni_max(v->struck, 1.0f); /* it moves by these velocities, and is not corrected */
		most = cni_max(most, cni_abs(m->w));
	}
	j->turned += s->h * most;
}

void cni_joined_hold(cn_world *world, cni_joined *j)
{
	const cni_body *b;
	float after = 0.0f, less;
	for (b = first_of(world, j); b != NULL; b = next_of(world, b)) {
		const cni_motion *m = cni_motions(world) + b->awake;
		after += energy_of(m, m->vx, m->vy, m->w);
	}
	if (!(after > j->energy) || !j->grounded || j->driven)
		return;
	less = (j->energy > 0.0f ? cni_sqrt(j->energy / after) : 0.0f) - 1.0f;
	for (b = first_of(world, j); b != NULL; b = next_of(world, b)) {
		cni_motion *m = cni_motions(world) + b->awake;
		cni_velocity_start *v = cni_starts(world) + b->awake;
		v->vx += less * m->vx;
		v->vy += less * m->vy;
		v->w += less * m->w;
		m->vx += less * m->vx;
		m->vy += less * m->vy;
		m->w += less * m->w;
	}
}
