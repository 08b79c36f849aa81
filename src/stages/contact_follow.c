/*
 * stages/contact_follow.c - the first part of the narrowphase: contacts that go on as they were.
 *
 * Most contacts of a pile are between things at rest. Their lanes are brought up to date side by side from their anchors
 * and the bodies' poses, in the blocks where they lie, by the kernel of stages/contact_follow.h; records, shapes and boxes
 * are not looked at. What cannot be followed so is handed to the narrowphase.
 *
 * Boxes need no test: a pair nearer than the least margin of a fat box goes on overlapping with it, whichever box
 * was made anew.
 *
 * Reads bodies, motion, anchors; writes lanes; marks bodies that have static ones about them.
 */
#include "stages/contact_pass.h"

#include <stddef.h>

/* What kernels read of a record. */
typedef char cni_body_begins_with_pose[offsetof(cni_body, cx) == 0 && offsetof(cni_body, q) == 16 && offsetof(cni_body, extent) == 32 ? 1 : -1];

const cni_body cni_body_nowhere;

/* Fills the table, of whose halves only those with anchored lanes are read; returns the anchored lanes whose axes are free: locked ones have other masses. */
static uint32_t bodies_find(const cn_world *world, const cni_contact_block *k, const cni_block_anchor *anchor, uint32_t anchored, cni_follow_bodies *out)
{
	const int32_t *ids = cni_awake_ids(world);
	int32_t l, end = anchored >> CNI_LANES / 2 != 0 ? CNI_LANES : CNI_LANES / 2;
	for (l = 0; l < end; ++l) {
		cni_body *a, *b;
		out->a[l] = out->b[l] = cni_record_floats(&cni_body_nowhere);
		if (!(anchored >> l & 1u))
			continue;
		a = cni_body_at(world, ids[k->ia[l]]);
		b = cni_body_at(world, k->ib[l] == 0 ? anchor->x.body[l] : ids[k->ib[l]]);
		if ((a->flags | b->flags) & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y)) {
			anchored &= ~(1u << l);
			continue;
		}
		if (k->ib[l] == 0)
			cni_contact_mark_static(a, b);
		out->a[l] = cni_record_floats(a);
		out->b[l] = cni_record_floats(b);
	}
	return anchored;
}

static cni_follow_pass pass_make(const cn_world *world, float dt)
{
	cni_follow_pass pass;
	pass.motions = cni_motions(world);
	pass.dt = dt;
	pass.drift_most = 0.25f * world->settings.slop;
	pass.hair = 0.1f * world->settings.slop;
	pass.depth_most = world->settings.contact_margin;
	pass.apart_most = world->settings.contact_margin - pass.hair;
	return pass;
}

#if defined(CNI_DEBUG)
static int32_t boxes_overlap(const cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	return cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat);
}
#endif

/* Asks for the bodies of the next block, and for the rows of that after it. Inlined by force: compilers take a function
   that only prefetches for one that does nothing. */
CNI_INLINE void blocks_prefetch(const cn_world *world, int32_t next)
{
	const cni_contact_block *k;
	int32_t l, after;
	if (next == CNI_NONE)
		return;
	k = cni_block_at(world, next);
	for (l = 0; l < CNI_LANES; ++l) {
		const cni_body *a = cni_body_at(world, cni_max_i(cni_awake_ids(world)[k->ia[l]], 0));
		CNI_PREFETCH(a);
		CNI_PREFETCH(&a->flags);
		if (k->ib[l] != 0) {
			const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k->ib[l]]);
			CNI_PREFETCH(b);
			CNI_PREFETCH(&b->flags);
		}
	}
	after = cni_block_info_at(world, next)->next;
	if (after == CNI_NONE)
		return;
	cni_lines_prefetch(cni_block_at(world, after), (int32_t)sizeof(cni_contact_block));
	cni_lines_prefetch(cni_block_anchor_at(world, after), (int32_t)sizeof(cni_block_anchor));
	CNI_PREFETCH(cni_block_info_at(world, after));
}

int32_t cni_contacts_follow(cn_world *world, float dt, int32_t *left)
{
	const cni_contact_kernel *kernel = cni_contact_kernel_choose();
	cni_follow_pass pass = pass_make(world, dt);
	cni_follow_bodies bodies;
	int32_t color, block, l, count = 0;
	for (color = 0; color < CNI_COLORS; ++color)
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			const cni_block_info *info = cni_block_info_at(world, block);
			uint32_t followed = info->anchored;
			if (world->awake_count >= CNI_PREFETCH_BODIES)
				blocks_prefetch(world, info->next);
			if (dt == 0.0f)
				followed = 0;
			if (followed != 0)
				followed = bodies_find(world, cni_block_at(world, block), cni_block_anchor_at(world, block), followed, &bodies);
			if (followed != 0)
				followed = kernel->follow(&pass, cni_block_at(world, block), cni_block_anchor_at(world, block), &bodies, followed);
			for (l = 0; l < CNI_LANES && info->contact[l] != CNI_NONE; ++l)
				if (!(followed >> l & 1u))
					left[count++] = info->contact[l];
				else
					CNI_ASSERT(boxes_overlap(world, info->contact[l]));
		}
	return count;
}
