/*
 * stages/contact_solve.c - warm start, soft solve and relax of all contacts: colours in order, blocks of a
 * colour through the widest kernel there is.
 *
 * Within a colour no dynamic body appears twice, so its lanes are independent. In static colours lane body
 * b is read and not written. So a colour's blocks may be shared among workers; they meet before the next colour. Contacts
 * in the overflow colour are solved one by one.
 */
#include "base/bitset.h"
#include "base/cpu.h"
#include "stages/contact_pass.h"

#include <string.h>

#define BLOCKS_A_RANGE 8 /* about a microsecond, more than the workers of a team take to meet */

const cni_contact_kernel *cni_contact_kernel_choose(void)
{
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		return &cni_contact_kernel_8;
#endif
#if CNI_HAS_WIDE_4
	return &cni_contact_kernel_4;
#else
	return &cni_contact_kernel_plain;
#endif
}

static cni_contact_pass pass_make(const cni_solve *s, int32_t one_sided)
{
	cni_contact_pass pass;
	pass.inv_h = s->inv_h;
	pass.push_speed = s->push_speed;
	pass.impact_speed = -s->restitution_threshold;
	pass.warm_scale = s->warm_scale;
	pass.load_part = cni_min(CNI_LOAD_RATE * s->dt, 1.0f);
	pass.load_heavy = s->load_heavy;
	pass.one_sided = one_sided;
	pass.soft = one_sided ? s->contact_static : s->contact;
	return pass;
}

/* Copies one lane between blocks. */
static void lane_copy(const cni_contact_block *from, int32_t from_lane, cni_contact_block *to, int32_t to_lane)
{
	const int32_t rows = (int32_t)(sizeof *from / (CNI_LANES * sizeof(float)));
	int32_t row;
	for (row = 0; row < rows; ++row)
		memcpy((float *)(void *)to + row * CNI_LANES + to_lane, (const float *)(const void *)from + row * CNI_LANES + from_lane, sizeof(float));
}

static void extra_lane_copy(const cni_block_extra *from, int32_t from_lane, cni_block_extra *to, int32_t to_lane)
{
	const int32_t rows = (int32_t)(sizeof *from / (CNI_LANES * sizeof(float)));
	int32_t row;
	if (from == NULL)
		return;
	for (row = 0; row < rows; ++row)
		memcpy((float *)(void *)to + row * CNI_LANES + to_lane, (const float *)(const void *)from + row * CNI_LANES + from_lane, sizeof(float));
}

/* Room for a lane by itself; its other lanes stay empty. */
typedef struct lone_lane {
	cni_contact_block rows;
	cni_block_extra extra;
} lone_lane;

/* A lane by itself, through the plain kernel. */
static void lane_run(cn_world *world, const cni_solve *s, cni_contact_kernel_fn *run, const cni_listed_block *b, int32_t l, lone_lane *one)
{
	cni_motion *motions = cni_motions(world);
	cni_contact_pass pass = pass_make(s, motions[b->rows->ib[l]].inv_mass == 0.0f);
	lane_copy(b->rows, l, &one->rows, 0);
	extra_lane_copy(b->extra, l, &one->extra, 0);
	run(motions, &one->rows, b->extra != NULL ? &one->extra : NULL, &pass, b->fresh >> l & 1u, 1);
	lane_copy(&one->rows, 0, b->rows, l);
	extra_lane_copy(b->extra != NULL ? &one->extra : NULL, 0, b->extra, l);
}

static void overflow_run(cn_world *world, const cni_solve *s, cni_contact_kernel_fn *run)
{
	const cni_listed_block *blocks = cni_listed_blocks(world, CNI_COLOR_OVERFLOW);
	int32_t count = world->colors[CNI_COLOR_OVERFLOW].listed_count, k, l;
	lone_lane one;
	if (count == 0)
		return;
	memset(&one, 0, sizeof one);
	for (k = 0; k < count; ++k)
		for (l = 0; l < blocks[k].lanes; ++l)
			lane_run(world, s, run, &blocks[k], l, &one);
}

/* A pass over the blocks of one colour: they share no body that they write. */
typedef struct color_pass {
	cni_contact_pass pass, rested; /* the latter for blocks whose time passes more slowly: loads follow in its measure */
	cni_contact_kernel_fn *run;
	cni_motion *motions;
	const cni_listed_block *blocks;
	int32_t prefetches;
} color_pass;

/* Asks for the rows of the block after the next, and for the bodies of the next. Inlined by force: compilers take a function
   that only prefetches for one that does nothing. */
CNI_INLINE void blocks_prefetch(const color_pass *c, int32_t k, int32_t end)
{
	int32_t l;
	if (k + 2 < end)
		cni_lines_prefetch(c->blocks[k + 2].rows, (int32_t)sizeof(cni_contact_block));
	if (k + 1 >= end)
		return;
	for (l = 0; l < CNI_LANES; ++l) {
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ia[l]]);
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ib[l]]);
	}
}

static void color_pass_run(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const color_pass *c = (const color_pass *)context;
	int32_t k;
	(void)worker;
	for (k = begin; k < end; ++k) {
		const cni_listed_block *b = &c->blocks[k];
		if (c->prefetches)
			blocks_prefetch(c, k, end);
		c->run(c->motions, b->rows, b->extra, b->rested ? &c->rested : &c->pass, b->fresh, b->lanes);
	}
}

static void colors_run(cn_world *world, const cni_solve *s, cni_contact_kernel_fn *run)
{
	color_pass c;
	uint32_t left;
	int32_t one_sided = -1;
	c.run = run;
	c.motions = cni_motions(world);
	c.prefetches = world->awake_count >= CNI_PREFETCH_BODIES;
	for (left = s->contact_colors & ~(1u << CNI_COLOR_OVERFLOW); left != 0; left &= left - 1u) {
		int32_t color = cni_bit_lowest32(left);
		if ((color >= CNI_COLOR_STATIC) != one_sided) {
			one_sided = color >= CNI_COLOR_STATIC;
			c.pass = c.rested = pass_make(s, one_sided);
			c.rested.load_part /= (float)s->substeps;
			c.rested.load_heavy /= (float)s->substeps;
		}
		c.blocks = cni_listed_blocks(world, color);
		cni_team_for(s->team, world->colors[color].listed_count, BLOCKS_A_RANGE, color_pass_run, &c);
	}
}

static cni_listed_block listed_of(const cn_world *world, int32_t block, int32_t lanes)
{
	cni_block_info *info = cni_block_info_at(world, block);
	cni_listed_block listed;
	listed.rows = cni_block_at(world, block);
	listed.extra = info->flags & CNI_BLOCK_EXTRA ? cni_block_extra_at(world, block) : NULL;
	listed.info = info;
	listed.fresh = info->fresh_step == world->step_count + 1u ? info->fresh : 0;
	listed.lanes = cni_min_i(lanes, CNI_LANES);
	listed.rested = (info->flags & CNI_BLOCK_RESTED) != 0;
	return listed;
}

int32_t cni_contacts_list(cn_world *world, cni_solve *s)
{
	cni_listed_block *list = (cni_listed_block *)world->block_list.data;
	int32_t color, block, count = 0, lanes = 0, k;
	for (color = 0; color < CNI_COLORS; ++color) {
		world->colors[color].listed = count;
		lanes += world->colors[color].lanes;
		for (k = world->colors[color].lanes, block = world->colors[color].first; k > 0; k -= CNI_LANES) {
			cni_block_info *info = cni_block_info_at(world, block);
			list[count++] = listed_of(world, block, k);
			s->bounces |= (info->flags & CNI_BLOCK_RESTITUTION) != 0;
			info->flags &= ~(uint32_t)CNI_BLOCK_RESTED;
			block = info->next;
		}
		world->colors[color].listed_count = count - world->colors[color].listed;
		s->contact_colors |= (uint32_t)(world->colors[color].lanes > 0) << color;
	}
	CNI_ASSERT(count <= world->block_list.capacity);
	return lanes;
}

void cni_contacts_warm_start(cn_world *world, const cni_solve *s)
{
	colors_run(world, s, s->kernel->warm);
	overflow_run(world, s, cni_contact_kernel_plain.warm);
}

void cni_contacts_solve(cn_world *world, const cni_solve *s)
{
	overflow_run(world, s, cni_contact_kernel_plain.solve);
	colors_run(world, s, s->kernel->solve);
}

void cni_contact_solve_again(cn_world *world, const cni_solve *s, int32_t slot)
{
	cni_listed_block b = listed_of(world, slot / CNI_LANES, CNI_LANES);
	lone_lane one;
	memset(&one, 0, sizeof one);
	lane_run(world, s, cni_contact_kernel_plain.solve, &b, slot % CNI_LANES, &one);
}

void cni_contacts_relax(cn_world *world, const cni_solve *s)
{
	overflow_run(world, s, cni_contact_kernel_plain.relax);
	colors_run(world, s, s->kernel->relax);
}
