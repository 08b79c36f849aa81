/*
 * world/origin.c - moves the origin of a world to another place, and reads positions with the digits that one float drops.
 *
 * Writes whatever is stored in world coordinates: centres of bodies, earlier poses for interpolation, boxes, world anchors of joints.
 * Contacts, islands and logs hold relative positions and handles, so they stay. The sum of high and low part of a centre is
 * shifted without error but for the last bit of the low part (Knuth, TwoSum), so distances between bodies stay.
 *
 * Boxes are shifted in floats and may overlap afterwards where they did not before. So each proxy is touched: the next step
 * looks at all pairs again and finds the contacts of those that have one.
 */
#include "world/define.h"

/* (*high + *low) - shift, as a high and a low part. */
static void shift_parts(float *high, float *low, float shift)
{
	float sum = *high - shift, back = sum + shift;
	float error = (*high - back) - (shift - (back - sum)), rest = *low + error;
	*high = sum + rest;
	*low = rest - (*high - sum);
}

static void bodies_shift(cn_world *world, cni_vec2 offset)
{
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1)) {
		cni_body *b = cni_body_at(world, k);
		shift_parts(&b->cx, &b->cx_low, offset.x);
		shift_parts(&b->cy, &b->cy_low, offset.y);
		cni_readback_store(world, k);
	}
	for (int32_t k = 0; k < world->previous.count; ++k) {
		cni_previous *p = (cni_previous *)world->previous.data + k;
		p->x -= offset.x;
		p->y -= offset.y;
	}
}

static void number_pair_shift(float *pair, cni_vec2 offset)
{
	pair[0] -= offset.x;
	pair[1] -= offset.y;
}

static void joints_shift(cn_world *world, cni_vec2 offset)
{
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->joint_handles, k + 1)) {
		cni_joint *j = cni_joint_at(world, k);
		for (int32_t side = 0; side < 2; ++side)
			if (j->body[side] == CNI_NONE)
				j->anchor[side] = cni_sub(j->anchor[side], offset);
		if (j->type == CN_JOINT_GROOVE && j->body[0] == CNI_NONE)
			number_pair_shift(j->p + CNI_P_GROOVE_END_X, offset);
		if (j->type == CN_JOINT_PULLEY) {
			number_pair_shift(j->p + CNI_P_PULLEY_GROUND_A, offset);
			number_pair_shift(j->p + CNI_P_PULLEY_GROUND_B, offset);
		}
	}
	world->joint_lanes.lanes = 0;
}

/* Rounding may take the margin from a box far from the origin: such a box is made again. */
static void boxes_shift(cn_world *world, cni_vec2 offset)
{
	for (int32_t k = 0; k < world->proxy_used; ++k) {
		cni_aabb box = cni_box_moved(cni_proxy_at(world, k)->fat, cni_neg(offset));
		if (!(cni_proxy_at(world, k)->flags & CNI_PROXY_ALIVE))
			continue;
		cni_proxy_set_fat(cni_proxy_at(world, k), &box);
		world->broadphase_ops->move(world->broadphase, k);
		world->broadphase_ops->touch(world->broadphase, k);
	}
	world->seams_box = cni_box_moved(world->seams_box, cni_neg(offset));
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1))
		cni_body_refresh_boxes(world, k);
	world->pairs_may_repeat |= CNI_PAIRS_ALL;
	world->broadphase_ops->settle(world->broadphase);
}

cn_result cn_world_shift_origin(cn_world *world, float x_m, float y_m)
{
	cni_call call = cni_enter(world, __func__);
	cni_vec2 offset = cni_v(x_m, y_m);
	cni_check_position(&call, "the new origin", offset);
	if (call.result != CN_OK || (x_m == 0.0f && y_m == 0.0f))
		return call.result;
	bodies_shift(world, offset);
	joints_shift(world, offset);
	boxes_shift(world, offset);
	cni_events_forget_built(&world->events); /* they have points */
	return CN_OK;
}

/* The origin of the body's frame is its centre less the turned local centre. */
static void parts_read(const cni_body *b, cn_vec2 *high, cn_vec2 *low)
{
	cni_vec2 arm = cni_rotate(b->q, b->local_center);
	*high = cni_v(b->cx, b->cy);
	*low = cni_v(b->cx_low, b->cy_low);
	shift_parts(&high->x, &low->x, arm.x);
	shift_parts(&high->y, &low->y, arm.y);
}

CNI_DEFINE_GET2(body, position_parts, cn_vec2, cn_vec2, parts_read(record, out_a, out_b))
