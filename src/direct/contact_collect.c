/*
 * direct/contact_collect.c - takes contacts out of their lanes for a step, to be solved directly (direct_contacts.c), and returns them.
 *
 * Reads contacts of islands; reads and writes lanes of contact blocks.
 */
#include "contacts/contacts.h"
#include "direct/direct.h"
#include "direct/direct_contact.h"

#include <string.h>

static const cni_block_extra *extra_rows(const cn_world *world, const cni_contact *c)
{
	int32_t block = c->slot / CNI_LANES;
	return cni_block_info_at(world, block)->flags & CNI_BLOCK_EXTRA ? cni_block_extra_at(world, block) : NULL;
}

int32_t cni_direct_lane_is_locked(const cn_world *world, const cni_contact *c)
{
	const cni_block_extra *x = extra_rows(world, c);
	int32_t l = c->slot % CNI_LANES;
	return x != NULL && x->lock_ax[l] + x->lock_ay[l] + x->lock_bx[l] + x->lock_by[l] != 0.0f;
}

float cni_direct_lane_tangent_speed(const cn_world *world, const cni_contact *c)
{
	const cni_block_extra *x = extra_rows(world, c);
	return x != NULL ? x->tangent_speed[c->slot % CNI_LANES] : 0.0f;
}

/*
 * Friction at its bound slides, or is at the limit of a redundant system: in a standing house of cards a tenth of all contacts are. If they began
 * active, every step would search for the set anew. Where the static coefficient is greater the two cannot be distinguished.
 */
static void friction_guess(cni_direct_contact *p)
{
	float sum = p->j[0] + p->j[1];
	if (sum <= 0.0f || p->static_friction > p->dynamic_friction || cni_abs(p->j[2]) < (1.0f - CNI_SLIDE_CLOSE) * p->dynamic_friction * sum)
		return;
	p->state[2] = CNI_ROW_SLIDES;
	p->slide_sign = p->j[2] > 0.0f ? 1.0f : -1.0f;
}

void cni_direct_contact_read(const cn_world *world, const cni_contact *c, cni_direct_contact *p)
{
	const cni_contact_block *k = cni_block_at(world, c->slot / CNI_LANES);
	int32_t l = c->slot % CNI_LANES;
	memset(p, 0, sizeof *p);
	p->block = c->slot / CNI_LANES;
	p->lane = l;
	p->ia = k->ia[l];
	p->ib = k->ib[l];
	p->nx = k->nx[l];
	p->ny = k->ny[l];
	p->dn = k->dn[l];
	p->dt = k->dt[l];
	p->fa = k->fa[l];
	p->fb = k->fb[l];
	p->static_friction = k->static_friction[l];
	p->dynamic_friction = k->dynamic_friction[l];
	p->untouched = 1;
	p->mass[2] = k->tm[l];
	p->j[2] = p->first[2] = k->jt[l];
	for (int32_t i = 0; i < 2; ++i) {
		p->at[i] = k->p[i].at[l];
		p->an[i] = k->p[i].an[l];
		p->s0[i] = k->p[i].s0[l];
		p->mass[i] = k->p[i].nm[l];
		p->j[i] = k->p[i].jn[l];
		p->load[i] = k->p[i].load[l];
		p->first[i] = p->j[i];
		p->state[i] = p->mass[i] > 0.0f && p->j[i] > 0.0f ? CNI_ROW_ACTIVE : CNI_ROW_OPEN;
	}
	friction_guess(p);
}

/* 1: the contact closes so fast that it bounces. A slower one does not, whatever its restitution. */
static int32_t bounces(const cn_world *world, const cni_contact *c)
{
	cni_direct_contact p;
	int32_t fast = 0;
	if (cni_block_info_at(world, c->slot / CNI_LANES)->restitution[c->slot % CNI_LANES] <= 0.0f)
		return 0;
	cni_direct_contact_read(world, c, &p);
	for (int32_t i = 0; i < 2; ++i)
		fast |= p.mass[i] > 0.0f && cni_direct_contact_speed(&p, i, cni_motions(world) + p.ia, cni_motions(world) + p.ib) < -world->settings.restitution_threshold;
	return fast;
}

int32_t cni_direct_contacts_collect(const cn_world *world, int32_t island, int32_t *contacts, int32_t room)
{
	int32_t count = 0;
	for (int32_t body = cni_island_at(world, island)->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			int32_t other = c->body[1 - (key & 1)];
			if (!cni_contact_has_lane(c))
				continue;
			if (cni_body_at(world, other)->type == CN_BODY_DYNAMIC && (key & 1))
				continue; /* collected at its other body */
			if (!cni_lane_is_plain(world, c->slot / CNI_LANES, c->slot % CNI_LANES))
				return CNI_DIRECT_CONTACTS_KIND;
			if (bounces(world, c))
				return CNI_DIRECT_CONTACTS_BOUNCE;
			if (count == room)
				return CNI_DIRECT_CONTACTS_MANY;
			contacts[count++] = key >> 1;
		}
	return count;
}

static void lane_write(cn_world *world, const cni_direct_contact *p, const float mass[3], const float j[3], const float load[2])
{
	cni_contact_block *block = cni_block_at(world, p->block);
	block->tm[p->lane] = mass[2];
	block->jt[p->lane] = j[2];
	for (int32_t i = 0; i < 2; ++i) {
		block->p[i].nm[p->lane] = mass[i];
		block->p[i].jn[p->lane] = j[i];
		block->p[i].load[p->lane] = load[i];
	}
}

void cni_direct_contacts_extract(cn_world *world, cni_sparse *sparse)
{
	const float idle[3] = { 0.0f, 0.0f, 0.0f };
	for (int32_t k = 0; k < sparse->contact_count; ++k) {
		const cni_direct_contact *p = &sparse->contacts[k];
		lane_write(world, p, idle, idle, idle);
		if (cni_block_info_at(world, p->block)->flags & CNI_BLOCK_EXTRA)
			cni_block_extra_at(world, p->block)->rolling_impulse[p->lane] = 0.0f;
	}
}

/* Lanes of extracted contacts hold no impulses: theirs are added here. */
void cni_direct_sum_impulses(cn_world *world, const cni_sparse *sparse)
{
	for (int32_t k = 0; k < sparse->contact_count; ++k) {
		const cni_direct_contact *p = &sparse->contacts[k];
		if (p->node != CNI_NONE)
			cni_impulse_sums_take(world, cni_block_info_at(world, p->block)->contact[p->lane], p->j[0], p->j[1], p->j[2]);
	}
}

/* A solved contact's impulse is exact, so it becomes the load. */
static void contact_restore(cn_world *world, cni_direct_contact *p)
{
	lane_write(world, p, p->mass, p->j, p->untouched ? p->load : p->j);
	p->node = CNI_NONE;
}

void cni_direct_contacts_restore(cn_world *world, cni_sparse *sparse, const cni_component *c)
{
	for (int32_t k = c->contact_begin; k < c->contact_end; ++k)
		contact_restore(world, &sparse->contacts[k]);
}

void cni_direct_contacts_restore_all(cn_world *world, cni_sparse *sparse, float h)
{
	for (int32_t k = 0; k < sparse->contact_count; ++k) {
		cni_direct_contact *p = &sparse->contacts[k];
		if (p->node == CNI_NONE)
			continue;
		if (cni_is_stressed(world, p->ia, p->ib, p->j[0] + p->j[1], h, 1.0f))
			cni_island_at(world, cni_awake_island(world, p->ia))->good_steps = 0;
		contact_restore(world, p);
	}
}

/* ---- rows ---- */

/* Separation of a point now; see contacts/contact_kernel.h. */
CNI_INLINE float turned(float angle, float n, float t)
{
	float x = cni_clamp(angle, -1.25f, 1.25f), x2 = x * x;
	return x * (1.0f - x2 * (1.0f / 6.0f - x2 * (1.0f / 120.0f))) * t - x2 * (0.5f - x2 * (1.0f / 24.0f)) * n;
}

float cni_direct_contact_separation(const cni_direct_contact *p, int32_t i, const cni_motion *a, const cni_motion *b)
{
	return p->s0[i] + p->nx * (b->dpx - a->dpx) + p->ny * (b->dpy - a->dpy) + turned(b->theta, p->an[i] - p->dn, p->at[i] - p->dt) - turned(a->theta, p->an[i], p->at[i]);
}
