/*
 * model/lane.c - colours, blocks and lanes (layout in contact.h).
 *
 * Owns the block tables, the free list of blocks, the colours and the colour bits of bodies. Greedy colouring: a contact takes
 * the lowest colour that neither of its dynamic bodies uses.
 *
 * Invariants: the blocks of a colour are full except for the last; unused lanes are all zero, so that they read and write the
 * dummy body and compute nothing; a body's colour bit is set exactly when one of its lanes has that colour (colour 31, overflow,
 * sets no bit); extra rows exist for no block or for all that contacts may take, so that contacts without them never wait for memory
 * of others.
 */
#include "base/bitset.h"
#include "model/world.h"

#include <string.h>

int32_t cni_lane_reserve_extra(cn_world *world)
{
	return cni_table_reserve(&world->blocks_extra, &world->memory, cni_table_capacity(&world->blocks_hot));
}

int32_t cni_lane_blocks_for(int32_t lanes)
{
	return lanes / CNI_LANES + (CNI_LANES == 1 ? 0 : cni_min_i(lanes, CNI_COLORS));
}

int32_t cni_lane_reserve(cn_world *world, int32_t lanes)
{
	int32_t blocks = cni_lane_blocks_for(lanes);
	return (cni_table_capacity(&world->blocks_extra) == 0 || cni_table_reserve(&world->blocks_extra, &world->memory, blocks)) &&
	       cni_table_reserve(&world->blocks_hot, &world->memory, blocks) &&
	       cni_table_reserve(&world->blocks_info, &world->memory, blocks) &&
	       cni_table_reserve(&world->blocks_anchor, &world->memory, blocks) &&
	       cni_array_reserve(&world->block_list, &world->memory, blocks);
}

static int32_t block_take(cn_world *world, int32_t color)
{
	cni_color *group = &world->colors[color];
	int32_t block = world->block_free;
	if (block != CNI_NONE)
		world->block_free = cni_block_info_at(world, block)->next;
	else
		block = world->block_used++;
	CNI_ASSERT(block < cni_table_capacity(&world->blocks_hot));
	memset(cni_block_at(world, block), 0, sizeof(cni_contact_block));
	memset(cni_block_anchor_at(world, block), 0, sizeof(cni_block_anchor));
	if (cni_block_extra_at(world, block) != NULL)
		memset(cni_block_extra_at(world, block), 0, sizeof(cni_block_extra));
	cni_block_info *info = cni_block_info_at(world, block);
	memset(info, 0, sizeof *info);
	for (int32_t lane = 0; lane < CNI_LANES; ++lane)
		info->contact[lane] = CNI_NONE;
	info->color = (int16_t)color;
	info->next = CNI_NONE;
	info->prev = group->last;
	if (group->last != CNI_NONE)
		cni_block_info_at(world, group->last)->next = block;
	else
		group->first = block;
	group->last = block;
	return block;
}

/* Frees the colour's last block, which is empty. */
static void block_free_last(cn_world *world, int32_t color)
{
	cni_color *group = &world->colors[color];
	int32_t block = group->last;
	cni_block_info *info = cni_block_info_at(world, block);
	group->last = info->prev;
	if (group->last != CNI_NONE)
		cni_block_info_at(world, group->last)->next = CNI_NONE;
	else
		group->first = CNI_NONE;
	info->next = world->block_free;
	info->color = CNI_NONE;
	world->block_free = block;
}

static cni_body *lane_body(const cn_world *world, const cni_contact *c, int32_t lane_side)
{
	int32_t flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0;
	return cni_body_at(world, c->body[lane_side ^ flipped]);
}

static int32_t color_choose(const cni_body *a, const cni_body *b)
{
	uint32_t dynamic_colors = (1u << CNI_COLOR_STATIC) - 1u, static_colors = ((1u << CNI_COLOR_OVERFLOW) - 1u) & ~dynamic_colors;
	uint32_t open = b->type == CN_BODY_DYNAMIC ? dynamic_colors & ~(a->colors | b->colors) : static_colors & ~a->colors;
	return open != 0 ? cni_bit_lowest32(open) : CNI_COLOR_OVERFLOW;
}

static void color_mark(cni_body *a, cni_body *b, int32_t color, int32_t on)
{
	uint32_t bit = 1u << color % 32;
	if (color >= CNI_COLOR_OVERFLOW)
		return;
	CNI_ASSERT(((a->colors & bit) != 0) == !on);
	(void)on;
	a->colors ^= bit;
	if (color < CNI_COLOR_STATIC) {
		CNI_ASSERT(((b->colors & bit) != 0) == !on);
		b->colors ^= bit;
	}
}

int32_t cni_blocks_are_few(const cn_world *world)
{
	int32_t count = 0;
	for (int32_t color = 0; color < CNI_COLORS; ++color)
		count += (world->colors[color].lanes + CNI_LANES - 1) / CNI_LANES;
	return count < world->block_used / 4;
}

void cni_lane_invalidate(cn_world *world, int32_t slot)
{
	cni_block_anchor *anchor = cni_block_anchor_at(world, slot / CNI_LANES);
	cni_block_info *info = cni_block_info_at(world, slot / CNI_LANES);
	if (!(info->anchored >> slot % CNI_LANES & 1u))
		return;
	info->anchored = (uint16_t)(info->anchored & ~(1u << slot % CNI_LANES));
	anchor->of.fresh.gap[slot % CNI_LANES] = anchor->of.fresh.approach[slot % CNI_LANES] = 0.0f;
}

void cni_lane_set_bodies(cn_world *world, const cni_contact *c)
{
	cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	int32_t lane = c->slot % CNI_LANES;
	int32_t ib = lane_body(world, c, 1)->awake;
	if ((block->ib[lane] == 0) != (ib == 0))
		cni_lane_invalidate(world, c->slot); /* anchors of static bodies have another form */
	block->ia[lane] = lane_body(world, c, 0)->awake;
	block->ib[lane] = ib;
}

/* The lane after the colour's last one. */
static void slot_take(cn_world *world, int32_t contact, int32_t color)
{
	cni_color *group = &world->colors[color];
	int32_t lane = group->lanes % CNI_LANES, block = lane == 0 ? block_take(world, color) : group->last, slot = block * CNI_LANES + lane;
	++group->lanes;
	cni_contact_at(world, contact)->slot = slot;
	cni_block_info_at(world, block)->contact[lane] = contact;
}

void cni_lane_take(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	if (cni_body_at(world, c->body[0])->type == CN_BODY_DYNAMIC)
		c->flags &= ~(uint32_t)CNI_CONTACT_FLIPPED;
	else
		c->flags |= CNI_CONTACT_FLIPPED;
	cni_body *a = lane_body(world, c, 0);
	cni_body *b = lane_body(world, c, 1);
	CNI_ASSERT(a->type == CN_BODY_DYNAMIC);
	int32_t color = color_choose(a, b);
	color_mark(a, b, color, 1);
	++a->lanes;
	++b->lanes;
	slot_take(world, contact, color);
	cni_lane_set_bodies(world, c);
}

void cni_lane_take_asleep(cn_world *world, int32_t contact)
{
	slot_take(world, contact, CNI_SLEEP_IN_BLOCKS ? CNI_COLOR_ASLEEP : CNI_COLOR_OVERFLOW);
	CNI_ASSERT(CNI_SLEEP_IN_BLOCKS);
}

/* Moves a column of rows between the slots' records and clears the source. */
static void column_move(void *from_record, void *to_record, int32_t from, int32_t to, int32_t rows)
{
	float *source = (float *)from_record + from % CNI_LANES, *target = (float *)to_record + to % CNI_LANES;
	for (; rows > 0; --rows, source += CNI_LANES, target += CNI_LANES) {
		if (target != source)
			memcpy(target, source, sizeof *target);
		memset(source, 0, sizeof *source);
	}
}

static void extra_move(cn_world *world, int32_t from, int32_t to)
{
	cni_block_extra *source = cni_block_extra_at(world, from / CNI_LANES), *target = cni_block_extra_at(world, to / CNI_LANES);
	if (source != NULL)
		column_move(source, target, from, to, CNI_ROWS_OF(cni_block_extra));
}

void cni_lane_set_fresh(cn_world *world, int32_t slot)
{
	cni_block_info *info = cni_block_info_at(world, slot / CNI_LANES);
	if (info->fresh_step != world->step_count + 1u)
		info->fresh = 0;
	info->fresh_step = world->step_count + 1u;
	info->fresh = (uint16_t)(info->fresh | 1u << slot % CNI_LANES);
}

static void fresh_move(cn_world *world, int32_t from, int32_t to)
{
	cni_block_info *source = cni_block_info_at(world, from / CNI_LANES);
	cni_block_info *target = cni_block_info_at(world, to / CNI_LANES);
	uint32_t bit = 1u << from % CNI_LANES;
	int32_t was_fresh = source->fresh_step == world->step_count + 1u && (source->fresh & bit);
	source->fresh = (uint16_t)(source->fresh & ~bit);
	target->fresh = (uint16_t)(target->fresh & ~(1u << to % CNI_LANES));
	if (was_fresh && from != to)
		cni_lane_set_fresh(world, to);
}

/* Moves a bit, and clears the source. */
static void bit_move(cni_lane_bits *source, cni_lane_bits *target, int32_t from, int32_t to)
{
	uint32_t bit = (uint32_t)*source >> from % CNI_LANES & 1u & (from != to);
	*source = (cni_lane_bits)cni_bits_with(*source, (uint32_t)from % CNI_LANES, 0);
	*target = (cni_lane_bits)cni_bits_with(*target, (uint32_t)to % CNI_LANES, bit);
}

static void anchor_move(cn_world *world, int32_t from, int32_t to)
{
	cni_block_info *source_info = cni_block_info_at(world, from / CNI_LANES), *target_info = cni_block_info_at(world, to / CNI_LANES);
	uint32_t anchored = source_info->anchored >> from % CNI_LANES & 1u & (from != to);
	column_move(cni_block_anchor_at(world, from / CNI_LANES), cni_block_anchor_at(world, to / CNI_LANES), from, to, CNI_ROWS_OF(cni_block_anchor));
	source_info->anchored = (uint16_t)cni_bits_with(source_info->anchored, (uint32_t)from % CNI_LANES, 0);
	target_info->anchored = (uint16_t)cni_bits_with(target_info->anchored, (uint32_t)to % CNI_LANES, anchored);
	bit_move(&source_info->of_b, &target_info->of_b, from, to);
	bit_move(&source_info->face, &target_info->face, from, to);
	bit_move(&source_info->points_of_b, &target_info->points_of_b, from, to);
}

/* Copies one lane over another and clears the source. */
static void lane_move(cn_world *world, int32_t from, int32_t to)
{
	cni_block_info *source_info = cni_block_info_at(world, from / CNI_LANES);
	cni_block_info *target_info = cni_block_info_at(world, to / CNI_LANES);
	column_move(cni_block_at(world, from / CNI_LANES), cni_block_at(world, to / CNI_LANES), from, to, CNI_ROWS_OF(cni_contact_block));
	if (from != to) {
		int32_t contact = source_info->contact[from % CNI_LANES];
		target_info->contact[to % CNI_LANES] = contact;
		target_info->restitution[to % CNI_LANES] = source_info->restitution[from % CNI_LANES];
		target_info->flags |= source_info->flags;
		cni_contact_at(world, contact)->slot = to;
	}
	extra_move(world, from, to);
	anchor_move(world, from, to);
	fresh_move(world, from, to);
	source_info->contact[from % CNI_LANES] = CNI_NONE;
	source_info->restitution[from % CNI_LANES] = 0.0f;
}

void cni_lane_free(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	int32_t color = cni_block_info_at(world, c->slot / CNI_LANES)->color;
	cni_color *group = &world->colors[color];
	int32_t last = group->last * CNI_LANES + (group->lanes - 1) % CNI_LANES;
	color_mark(lane_body(world, c, 0), lane_body(world, c, 1), color, 0);
	if (color != CNI_COLOR_ASLEEP) {
		--lane_body(world, c, 0)->lanes;
		--lane_body(world, c, 1)->lanes;
	}
	lane_move(world, last, c->slot);
	c->slot = CNI_NONE;
	if (--group->lanes % CNI_LANES == 0)
		block_free_last(world, color);
}
