/*
 * narrowphase/manifold_reuse.c - the first part of the narrowphase: updates manifolds whose bodies have moved little against each other.
 *
 * Most contacts of a pile are between bodies at rest, and in a crowd that moves most pairs move slowly against each other. The kernel of
 * contacts/manifold_reuse_kernel.h updates their lanes in place, several at once, from the anchors and the bodies' poses. It does not read
 * contact records, shapes or boxes. The narrowphase computes the manifolds of all other lanes. The world's workers share the blocks.
 *
 * Boxes need no test: a pair closer than the least margin of a fat box keeps overlapping boxes, whichever box was recomputed.
 *
 * Reads bodies, motion, anchors; writes lanes; marks bodies near static ones.
 */
#include "base/bitset.h"
#include "contacts/contact_pass.h"
#include "narrowphase/touch.h"

#include <stddef.h>
#include <string.h>

/* The layout of a record that kernels rely on. */
typedef char cni_body_begins_with_pose[offsetof(cni_body, cx) == 0 && offsetof(cni_body, q) == 16 && offsetof(cni_body, extent) == 32 ? 1 : -1];
typedef char cni_reuse_pose_begins_alike[offsetof(cni_reuse_pose, c) == offsetof(cni_body, q) && offsetof(cni_reuse_pose, extent) == 24 ? 1 : -1];

/* 10 us of work where all is followed. */
#define BLOCKS_A_RANGE 32
#define BODIES_A_RANGE 1024 /* likewise: records are read */

/* Fills the table, whose second half is read only if it has anchored lanes. Returns the anchored lanes whose bodies have no
   locked axis: locked bodies have other masses. */
static uint32_t bodies_gather(const cn_world *world, const cni_contact_block *k, const cni_block_anchor *anchor,
                              uint32_t anchored, cni_reuse_bodies *out)
{
	const int32_t *ids = cni_awake_ids(world);
	int32_t end = anchored >> CNI_LANES / 2 != 0 ? CNI_LANES : CNI_LANES / 2;
	for (int32_t l = 0; l < end; ++l) {
		out->a[l] = out->b[l] = cni_record_floats(&cni_body_none);
		if (!(anchored >> l & 1u))
			continue;
		cni_body *a = cni_body_at(world, ids[k->ia[l]]);
		cni_body *b = cni_body_at(world, k->ib[l] == 0 ? anchor->x.body[l] : ids[k->ib[l]]);
		if ((cni_body_flags(a) | cni_body_flags(b)) & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y)) {
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

static cni_reuse_pass pass_make(const cn_world *world, float dt)
{
	cni_reuse_pass pass;
	pass.motions = cni_motions(world);
	pass.poses = NULL;
	pass.dt = dt;
	pass.drift_most = 0.25f * world->settings.slop;
	pass.drift_most_of_faces = CNI_REUSE_FACE_SLOPS * world->settings.slop;
	pass.tiny = CNI_ROUND_PER_SLOP * world->settings.slop;
	pass.hair = 0.1f * world->settings.slop;
	pass.depth_most = CNI_REUSE_DEPTH_MARGINS * world->settings.contact_margin;
	pass.advance_most = CNI_ROLLING_ADVANCE_SLOPS * world->settings.slop;
	pass.lag_sq = cni_normal_lag_sq(world);
	pass.apart_most = world->settings.contact_margin - pass.hair;
	return pass;
}

#if defined(CNI_DEBUG)
static int32_t reused_boxes_overlap(const cn_world *world, const int32_t *contacts, uint32_t remaining)
{
	int32_t overlap = 1;
	for (int32_t l = 0; l < CNI_LANES && contacts[l] != CNI_NONE; ++l) {
		const cni_contact *c = cni_contact_at(world, contacts[l]);
		overlap &= (remaining >> l & 1u) || cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat);
	}
	return overlap;
}
#endif

/* A block and, as bits, its lanes in use; after reuse the lanes that still need a manifold. */
typedef struct reuse_block {
	int32_t block;
	uint32_t remaining;
} reuse_block;

/* The list uses the memory of the passes' list of blocks, which has room for every block. */
typedef char reuse_blocks_fit[sizeof(reuse_block) <= sizeof(cni_listed_block) ? 1 : -1];

typedef struct reuse_loop {
	const cn_world *world;
	const cni_contact_kernel *kernel;
	reuse_block *blocks; /* colours in order, a colour's blocks in order */
	int32_t count;
	cni_reuse_pose *poses; /* NULL: none */
	cni_reuse_pass pass;
} reuse_loop;

/* Gathers the poses densely before the lanes: a body has several lanes, so this pays where most bodies have an anchored one. */
static void poses_range(void *context, int32_t begin, int32_t end)
{
	const reuse_loop *loop = (const reuse_loop *)context;
	const cn_world *world = loop->world;
	for (int32_t k = begin + 1; k <= end; ++k) {
		const cni_body *b = cni_body_at(world, cni_awake_ids(world)[k]);
		cni_reuse_pose *p = &loop->poses[k];
		memcpy(p, b, offsetof(cni_reuse_pose, extent));
		p->extent = b->flags & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y) ? -1.0f : b->extent;
		p->inv_inertia = cni_motions(world)[k].inv_inertia;
	}
}

/* Makes no poses where there are too few anchored lanes to pay, or no memory. anchored: number of anchored lanes between awake bodies. */
static void poses_make(cn_world *world, reuse_loop *loop, int32_t anchored)
{
	if (anchored >= world->awake_count / 2)
		loop->poses = (cni_reuse_pose *)cni_arena_push(&world->arena, sizeof(cni_reuse_pose) * (uint64_t)world->awake_count);
	if (loop->poses == NULL)
		return;
	memset(loop->poses, 0, sizeof *loop->poses);
	cni_parallel_for(world, world->awake_count - 1, BODIES_A_RANGE, poses_range, loop);
	loop->pass.poses = loop->poses;
}

/* Returns the number of anchored lanes between awake bodies. */
static int32_t blocks_list(const cn_world *world, reuse_loop *loop)
{
	int32_t block, lanes, anchored = 0;
	loop->blocks = (reuse_block *)world->block_list.data;
	loop->count = 0;
	for (int32_t color = 0; color < CNI_COLORS; ++color)
		for (lanes = world->colors[color].lanes, block = world->colors[color].first; lanes > 0; lanes -= CNI_LANES) {
			const cni_block_info *info = cni_block_info_at(world, block);
			reuse_block *b = &loop->blocks[loop->count++];
			b->block = block;
			b->remaining = (1u << cni_min_i(lanes, CNI_LANES)) - 1u;
			if (color < CNI_COLOR_STATIC)
				anchored += cni_bit_count64(info->anchored);
			block = info->next;
		}
	return anchored;
}

CNI_INLINE void record_prefetch(const cn_world *world, int32_t index)
{
	const cni_body *b = cni_body_at(world, cni_max_i(cni_awake_ids(world)[index], 0));
	CNI_PREFETCH(b);
	CNI_PREFETCH(&b->flags);
}

/* Prefetches the bodies of the next block, and the rows of the block after it. Forced inline: compilers treat a function that only
   prefetches as having no effect. */
CNI_INLINE void blocks_prefetch(const reuse_loop *loop, int32_t next)
{
	const cn_world *world = loop->world;
	if (next >= loop->count)
		return;
	const cni_contact_block *k = cni_block_at(world, loop->blocks[next].block);
	for (int32_t l = 0; l < CNI_LANES; ++l) {
		if (loop->pass.poses != NULL) {
			CNI_PREFETCH(&loop->pass.poses[k->ia[l]]);
			CNI_PREFETCH(&loop->pass.poses[k->ib[l]]);
		} else {
			record_prefetch(world, k->ia[l]);
			record_prefetch(world, k->ib[l]);
		}
	}
	if (next + 1 >= loop->count)
		return;
	int32_t after = loop->blocks[next + 1].block;
	cni_lines_prefetch(cni_block_at(world, after), (int32_t)sizeof(cni_contact_block));
	cni_lines_prefetch(cni_block_anchor_at(world, after), (int32_t)sizeof(cni_block_anchor));
	CNI_PREFETCH(cni_block_info_at(world, after));
}

static uint32_t block_reuse(const reuse_loop *loop, int32_t block)
{
	const cn_world *world = loop->world;
	const cni_block_info *info = cni_block_info_at(world, block);
	uint32_t anchored = loop->pass.dt > 0.0f && CNI_ON(MANIFOLD_REUSE) ? info->anchored : 0;
	int32_t by_poses = loop->pass.poses != NULL && info->color < CNI_COLOR_STATIC;
	cni_block_anchor *anchor = cni_block_anchor_at(world, block);
	cni_contact_block *rows = cni_block_at(world, block);
	cni_reuse_bodies bodies;
	if (anchored != 0 && !by_poses)
		anchored = bodies_gather(world, rows, anchor, anchored, &bodies);
	return anchored == 0 ? 0 : loop->kernel->reuse(&loop->pass, rows, info, anchor, by_poses ? NULL : &bodies, anchored);
}

/* Blocks share bodies; of those only the flag CNI_BODY_AT_STATIC is written. */
static void reuse_range(void *context, int32_t begin, int32_t end)
{
	const reuse_loop *loop = (const reuse_loop *)context;
	for (int32_t k = begin; k < end; ++k) {
		if (loop->world->awake_count >= CNI_PREFETCH_BODIES)
			blocks_prefetch(loop, k + 1);
		loop->blocks[k].remaining &= ~block_reuse(loop, loop->blocks[k].block);
	}
}

/* Contacts of lanes that were not reused, in the order of blocks and lanes. */
static int32_t remaining_collect(const reuse_loop *loop, int32_t *remaining)
{
	int32_t count = 0;
	for (int32_t k = 0; k < loop->count; ++k) {
		const int32_t *contact = cni_block_info_at(loop->world, loop->blocks[k].block)->contact;
		CNI_ASSERT(reused_boxes_overlap(loop->world, contact, loop->blocks[k].remaining));
		for (uint32_t lanes = loop->blocks[k].remaining; lanes != 0; lanes &= lanes - 1u)
			remaining[count++] = contact[cni_bit_lowest32(lanes)];
	}
	return count;
}

int32_t cni_manifolds_reuse(cn_world *world, float dt, int32_t *remaining)
{
	reuse_loop loop;
	loop.world = world;
	loop.poses = NULL;
	loop.kernel = cni_contact_kernel_choose();
	loop.pass = pass_make(world, dt);
	int32_t anchored = blocks_list(world, &loop);
	if (dt > 0.0f && CNI_ON(MANIFOLD_REUSE))
		poses_make(world, &loop, anchored);
	cni_parallel_for(world, loop.count, BLOCKS_A_RANGE, reuse_range, &loop);
	cni_arena_pop(&world->arena, loop.poses);
	return remaining_collect(&loop, remaining);
}
