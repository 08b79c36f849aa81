/*
 * contacts/contact_solve.c - the contact passes of a substep: warm start, soft solve, relax. They run over the colours in order,
 * and over a colour's blocks with the widest kernel. Without a team a pass is one kernel call for all blocks.
 *
 * Within a colour no dynamic body appears twice, so its lanes are independent, and workers may share its blocks; they
 * synchronise before the next colour. In static colours lane body b is read and not written. Contacts of the overflow colour are
 * solved one by one, in place.
 */
#include "contacts/contacts.h"
#include "base/bitset.h"
#include "base/cpu.h"
#include "contacts/contact_pass.h"

#define BLOCKS_A_RANGE 8 /* about a microsecond, more than the workers of a team take to meet */

const cni_contact_kernel *cni_contact_kernel_choose(void)
{
	return CNI_WIDEST(&cni_contact_kernel_plain, &cni_contact_kernel_4, &cni_contact_kernel_8);
}

static cni_color_pass color_pass_make(cn_world *world, const cni_solve *s, const cni_listed_block *blocks)
{
	cni_color_pass c = { s->contact, cni_motions(world), world->settled ? cni_externals(world) : NULL, blocks, world->awake_count >= CNI_PREFETCH_BODIES };
	return c;
}

/* Solves one lane with the plain kernel. which: not _AGAIN. */
static void lane_run(cn_world *world, const cni_solve *s, int32_t which, const cni_listed_block *b, int32_t l)
{
	cni_listed_block one = *b;
	cni_color_pass c = color_pass_make(world, s, &one);
	one.begin = (cni_listed_number)l;
	one.lanes = (cni_listed_number)(l + 1);
	one.kind = (cni_listed_number)(c.motions[b->rows->ib[l]].inv_mass == 0.0f ? CNI_CONTACTS_ONE_SIDED : 0);
	cni_contact_kernel_plain.pass[which](&c, 0, 1);
}

static void overflow_run(cn_world *world, const cni_solve *s, int32_t which)
{
	const cni_listed_block *blocks = cni_listed_blocks(world, CNI_COLOR_OVERFLOW);
	int32_t count = world->colors[CNI_COLOR_OVERFLOW].listed_count, again = which == CNI_PASS_AGAIN;
	for (int32_t k = 0; k < count; ++k) {
		uint32_t left = again ? blocks[k].info->again : (1u << blocks[k].lanes) - 1u;
		if (again)
			blocks[k].info->again = 0;
		for (; left != 0; left &= left - 1u)
			lane_run(world, s, again ? CNI_PASS_SOLVE : which, &blocks[k], cni_bit_lowest32(left));
	}
}

typedef struct color_loop {
	cni_color_pass c;
	cni_contact_kernel_fn *run;
} color_loop;

static void color_range(void *context, int32_t begin, int32_t end)
{
	const color_loop *loop = (const color_loop *)context;
	loop->run(&loop->c, begin, end);
}

static void colors_run(cn_world *world, const cni_solve *s, int32_t which)
{
	const cni_listed_block *list = (const cni_listed_block *)world->block_list.data;
	color_loop loop = { color_pass_make(world, s, list), s->kernel->pass[which] };
	uint32_t left = s->contact_colors & ~(1u << CNI_COLOR_OVERFLOW);
	int32_t count = 0;
	for (; left != 0; left &= left - 1u) {
		const cni_color *group = &world->colors[cni_bit_lowest32(left)];
		if (group->listed_count == 0)
			continue;
		if (s->team != NULL || loop.c.blocks + count != list + group->listed) {
			cni_team_for(s->team, count, BLOCKS_A_RANGE, color_range, &loop);
			loop.c.blocks = list + group->listed;
			count = 0;
		}
		count += group->listed_count;
	}
	cni_team_for(s->team, count, BLOCKS_A_RANGE, color_range, &loop);
}

static cni_listed_block listed_of(const cn_world *world, int32_t block, int32_t lanes)
{
	cni_block_info *info = cni_block_info_at(world, block);
	int32_t kind = (info->flags & CNI_BLOCK_RESTED ? CNI_CONTACTS_RESTED : 0) | (info->color >= CNI_COLOR_STATIC ? CNI_CONTACTS_ONE_SIDED : 0);
	cni_listed_block listed = { cni_block_at(world, block), info->flags & CNI_BLOCK_EXTRA ? cni_block_extra_at(world, block) : NULL, info,
		info->fresh_step == world->step_count + 1u ? info->fresh : (cni_listed_bits)0, 0, (cni_listed_number)cni_min_i(lanes, CNI_LANES), (cni_listed_number)kind };
	return listed;
}

/* A colour's blocks form a linked list, and a link outside the cache stalls. This prefetches all links, unless few of the allocated
   blocks are in use. */
CNI_INLINE void infos_prefetch(const cn_world *world)
{
	for (int32_t block = 0; block < world->block_used; ++block)
		CNI_PREFETCH(&cni_block_info_at(world, block)->next);
}

/* Convex bodies that do not overlap have three contacts each at most, as the graph of their contacts is planar. Where they have more,
   bodies were made or pressed into one spot, and one sweep leaves so much of the speed of the soft pass, which pushes them apart, that
   they fly apart as from an explosion. */
static int32_t relax_sweeps(const cn_world *world)
{
	int32_t lanes = world->colors[CNI_COLOR_OVERFLOW].lanes;
	for (int32_t color = 0; color < CNI_COLOR_STATIC; ++color)
		lanes += world->colors[color].lanes;
	return lanes > CNI_CROWD_CONTACTS * world->awake_count ? CNI_CROWD_RELAX_SWEEPS : 1;
}

void cni_contacts_list(cn_world *world, cni_solve *s)
{
	cni_listed_block *list = (cni_listed_block *)world->block_list.data;
	int32_t block, count = 0, k;
	uint32_t sums = 0;
	if (!cni_blocks_are_few(world))
		infos_prefetch(world);
	for (int32_t color = 0; color < CNI_COLORS; ++color) {
		world->colors[color].listed = count;
		world->colors[color].listed_count = 0;
		if (world->colors[color].lanes == 0)
			continue;
		s->lanes += world->colors[color].lanes;
		for (k = world->colors[color].lanes, block = world->colors[color].first; k > 0; k -= CNI_LANES) {
			cni_block_info *info = cni_block_info_at(world, block);
			list[count++] = listed_of(world, block, k);
			s->bounces |= (info->flags & CNI_BLOCK_RESTITUTION) != 0;
			sums |= info->flags & CNI_BLOCK_SUMS;
			info->flags = (uint16_t)(info->flags & ~CNI_BLOCK_RESTED);
			block = info->next;
		}
		world->colors[color].listed_count = count - world->colors[color].listed;
		s->contact_colors |= 1u << color;
	}
	CNI_ASSERT(count <= world->block_list.capacity);
	s->relax_sweeps = relax_sweeps(world);
	s->sums = sums != 0 || world->events.log[CN_EVENT_ENTER].count > 0;
}

void cni_contacts_pass(cn_world *world, const cni_solve *s, int32_t which)
{
	int32_t left = which == CNI_PASS_RELAX ? s->relax_sweeps : 1;
	for (; left > 0; --left) {
		if (which != CNI_PASS_WARM)
			overflow_run(world, s, which);
		colors_run(world, s, which);
	}
	if (which == CNI_PASS_WARM)
		overflow_run(world, s, which);
}
