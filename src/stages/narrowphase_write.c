/*
 * stages/narrowphase_write.c - manifolds of contacts that go on touching, put into their lanes.
 *
 * Contacts that touch are finished in the order of blocks and lanes, so the manifolds of a block come one after the other.
 * They wait until the block changes or the window of contacts ends; then the block's lanes are written side by side by the
 * kernel of stages/contact_write.h. A few cost less one by one, and so do those that need more than the kernel knows of:
 * contacts that are still ahead, with locks, or that users look at, and all in a block with extra rows (rolling, conveyors,
 * locks). What passes read of a lane has the same bits either way.
 *
 * Reads bodies, motion, manifolds; writes lanes, their anchors, and the ids of contacts.
 */
#include "stages/narrowphase_write.h"

#include <stddef.h>
#include <string.h>

/* Fewer lanes of a block are written one by one. */
#define LANES_LEAST 4

/* What the kernel reads of a manifold. */
typedef char cni_manifold_begins_with_normal[offsetof(cni_manifold, normal) == 0 && offsetof(cni_manifold, points) == 16 ? 1 : -1];
typedef char cni_manifold_point_is_four[sizeof(cni_manifold_point) == 16 && offsetof(cni_manifold_point, separation) == 8 ? 1 : -1];

static const cni_manifold no_manifold;

void cni_writer_begin(cni_writer *w, cn_world *world)
{
	w->world = world;
	w->kernel = CNI_ON(LANE_WRITER) ? cni_contact_kernel_choose()->write : NULL;
	w->block = CNI_NONE;
	w->lanes = 0;
	w->opened = 0;
	w->of.lag_sq = cni_normal_lag_sq(world);
}

static void write_one(const cni_writer *w, const cni_touch *t)
{
	cni_contact_write(w->world, t->contact, t->a, t->b, &t->manifold, t->gap, t->radius);
}

/* Is all that its lane needs what the kernel writes? */
static int32_t is_plain(const cni_touch *t)
{
	const uint32_t owed = CNI_CONTACT_ENTER_OWED | CNI_CONTACT_CREATED_OWED;
	const uint32_t rare = owed | CNI_CONTACT_ENTERED | CNI_CONTACT_REFRESH | CNI_CONTACT_ONE_WAY | CNI_CONTACT_PRE_SOLVE;
	uint32_t locks = (cni_body_flags(t->a) | cni_body_flags(t->b)) & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y);
	return ((t->contact->flags & rare) | locks) == 0 && t->gap.x == 0.0f && t->gap.y == 0.0f;
}

void cni_writer_add(cni_writer *w, const cni_touch *t)
{
	uint32_t slot = (uint32_t)t->contact->slot;
	if (w->kernel == NULL || !is_plain(t)) {
		write_one(w, t);
		return;
	}
	if ((int32_t)(slot / CNI_LANES) != w->block) {
		cni_writer_flush(w);
		w->block = (int32_t)(slot / CNI_LANES);
	}
	w->lanes |= 1u << slot % CNI_LANES;
	w->touch[slot % CNI_LANES] = t;
}

/* ---- side by side ---- */

/* What lanes point to that are not written must be there, whatever it says: at first this, then what earlier lanes left. */
static void lanes_open(cni_writer *w)
{
	int32_t l;
	for (l = 0; l < CNI_LANES; ++l) {
		w->of.a[l] = w->of.b[l] = cni_record_floats(&cni_body_nowhere);
		w->of.manifold[l] = (const float *)(const void *)&no_manifold;
		w->of.radius_a[l] = w->of.radius_b[l] = 0.0f;
	}
	w->opened = 1;
}

/* Which points are those that the lane had: a point takes over the impulse of its old self. No two have one id, and none
   has the id 0. */
static void points_match(cni_writer *w, const cni_touch *t, int32_t l)
{
	cni_contact *c = t->contact;
	uint32_t two = t->manifold.count == 2, id0 = t->manifold.points[0].id, id1 = two ? t->manifold.points[1].id : 0;
	uint32_t is00 = id0 == c->id[0], is01 = !is00 & (id0 == c->id[1]), is10 = two & (id1 == c->id[0]), is11 = two & !is10 & (id1 == c->id[1]);
	w->of.two |= two << l;
	w->of.from[0][0] |= is00 << l;
	w->of.from[0][1] |= is01 << l;
	w->of.from[1][0] |= is10 << l;
	w->of.from[1][1] |= is11 << l;
	c->id[0] = (uint16_t)id0;
	c->id[1] = (uint16_t)id1;
}

static void lane_set(cni_writer *w, const cni_touch *t, int32_t l)
{
	uint32_t flipped = (t->contact->flags & CNI_CONTACT_FLIPPED) != 0;
	w->of.a[l] = cni_record_floats(flipped ? t->b : t->a);
	w->of.b[l] = cni_record_floats(flipped ? t->a : t->b);
	w->of.manifold[l] = (const float *)(const void *)&t->manifold;
	w->of.radius_a[l] = t->radius[flipped];
	w->of.radius_b[l] = t->radius[1 - flipped];
	w->of.flipped |= flipped << l;
	points_match(w, t, l);
}

/* Lanes at the world know the record of what stands there by its index: see cni_block_anchor. */
static void anchors_finish(const cni_writer *w, const cni_block_info *info, const cni_contact_block *block, cni_block_anchor *anchor)
{
	uint32_t lanes;
	for (lanes = w->lanes; lanes != 0; lanes &= lanes - 1u) {
		int32_t l = cni_bit_lowest32(lanes);
		if (block->ib[l] == 0)
			anchor->x.body[l] = cni_contact_at(w->world, info->contact[l])->body[1 - (int32_t)(w->of.flipped >> l & 1u)];
	}
}

static void write_together(cni_writer *w)
{
	cni_contact_block *block = cni_block_at(w->world, w->block);
	cni_block_anchor *anchor = cni_block_anchor_at(w->world, w->block);
	cni_block_info *info = cni_block_info_at(w->world, w->block);
	uint32_t lanes;
	if (!w->opened)
		lanes_open(w);
	w->of.flipped = w->of.two = 0;
	memset(w->of.from, 0, sizeof w->of.from);
	for (lanes = w->lanes; lanes != 0; lanes &= lanes - 1u)
		lane_set(w, w->touch[cni_bit_lowest32(lanes)], cni_bit_lowest32(lanes));
	w->kernel(cni_motions(w->world), block, anchor, &w->of, w->lanes);
	info->anchored = (uint16_t)(info->anchored | w->lanes);
	anchors_finish(w, info, block, anchor);
}

static int32_t block_has_extra(const cni_writer *w)
{
	return (cni_block_info_at(w->world, w->block)->flags & CNI_BLOCK_EXTRA) != 0;
}

void cni_writer_flush(cni_writer *w)
{
	if (w->lanes == 0)
		return;
	if (cni_bit_count64(w->lanes) < LANES_LEAST || block_has_extra(w))
		for (; w->lanes != 0; w->lanes &= w->lanes - 1u)
			write_one(w, w->touch[cni_bit_lowest32(w->lanes)]);
	else
		write_together(w);
	w->block = CNI_NONE;
	w->lanes = 0;
}
