/*
 * step/finalize_kernel.h - finalize.c's loop over bodies with vectors: part of integrate_kernel.h. It takes CNI_WIDTH
 * consecutive bodies at a time, with the bits of finalize.c's body_take.
 */
#include <stddef.h>
#include <string.h>

#define ALL_LANES ((1u << CNI_WIDTH) - 1u)

/* The loaded state of CNI_WIDTH bodies. */
typedef struct body_lanes {
	cni_body *b[CNI_WIDTH];
	cni_motion *m;
	cni_wide vx, vy, w, v_sq;
	cni_wide dx, dy, turn, extent, turn_reach;
} body_lanes;

/* 0: a body is above the speed limits, or turns beyond the range of the sine here. */
CNI_INLINE int32_t lanes_load(const cn_world *world, int32_t k, body_lanes *f)
{
	const int32_t *ids = cni_awake_ids(world) + k, row[8] = { 0, 1, 2, 3, 4, 5, 6, 7 }, stride = (int32_t)(sizeof(cni_motion) / sizeof(float));
	const cni_settings *set = &world->settings;
	float *records[CNI_WIDTH], turn_reach[CNI_WIDTH];
	cni_wide unused;
	f->m = cni_motions(world) + k;
	cni_wide_gather4(&f->m->vx, stride, row, &f->vx, &f->vy, &f->w, &unused);
	cni_wide_gather4(&f->m->dpx, stride, row, &f->dx, &f->dy, &f->turn, &unused);
	f->v_sq = f->vx * f->vx + f->vy * f->vy;
	if (cni_mask_bits((f->v_sq <= cni_wide_of(set->linear_speed_max * set->linear_speed_max)) & (cni_wide_abs(f->w) <= cni_wide_of(set->angular_speed_max)) &
	                  (cni_wide_abs(f->turn) <= cni_wide_of(CNI_NEAR_RAD))) != ALL_LANES)
		return 0;
	for (int32_t l = 0; l < CNI_WIDTH; ++l) {
		f->b[l] = cni_body_at(world, ids[l]);
		records[l] = (float *)(void *)f->b[l];
		turn_reach[l] = cni_body_turn_reach(f->b[l]);
	}
	f->turn_reach = cni_wide_load_loose(turn_reach);
	f->extent = cni_wide_gather_from((const float *const *)records, offsetof(cni_body, extent) / sizeof(float));
	return 1;
}

CNI_INLINE void sum_exactly_wide(cni_wide *high, cni_wide *low, cni_wide change)
{
	cni_wide rest = *low + change, sum = *high + rest;
	*low = rest - (sum - *high);
	*high = sum;
}

/* Writes the readback: cni_readback_store for what finalizing changes. */
CNI_INLINE void lanes_show(const cn_world *world, int32_t k, cni_mask moved, cni_wide x, cni_wide y, cni_wide c, cni_wide s)
{
	const int32_t *ids = cni_awake_ids(world) + k;
	float *shown[CNI_WIDTH];
	for (int32_t l = 0; l < CNI_WIDTH; ++l) {
		cn_body_moved *to = cni_readback_at(world, ids[l]);
		shown[l] = (float *)(void *)&to->pose;
		to->fell_asleep = (uint32_t)moved[l] & (world->step_count + 1u);
	}
	cni_wide_scatter4_to(shown, 0, x, y, c, s);
}

/* take_pose without the room. Returns what the movement takes from each body's room. */
CNI_INLINE cni_wide lanes_poses(const cn_world *world, int32_t k, const body_lanes *f, cni_mask *moved)
{
	const int32_t at_center = (int32_t)(offsetof(cni_body, cx) / sizeof(float)), at_rotation = (int32_t)(offsetof(cni_body, q) / sizeof(float));
	float *records[CNI_WIDTH];
	cni_wide x, y, x_low, y_low, c, s, lx, ly, before_x, before_y, after_x, after_y, turn_c, turn_s, new_c, new_s, length;
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		records[l] = (float *)(void *)f->b[l];
	cni_wide_gather4_from((const float *const *)records, at_center, &x, &y, &x_low, &y_low);
	cni_wide_gather4_from((const float *const *)records, at_rotation, &c, &s, &lx, &ly);
	before_x = x - (c * lx - s * ly) + x_low;
	before_y = y - (s * lx + c * ly) + y_low;
	sum_exactly_wide(&x, &x_low, f->dx);
	sum_exactly_wide(&y, &y_low, f->dy);
	cni_wide_sincos_near(f->turn, &turn_c, &turn_s);
	new_c = c * turn_c - s * turn_s;
	new_s = s * turn_c + c * turn_s;
	length = cni_wide_sqrt(new_c * new_c + new_s * new_s);
	cni_mask turns = f->turn != cni_wide_of(0.0f);
	new_c = cni_wide_select(turns, new_c / length, c);
	new_s = cni_wide_select(turns, new_s / length, s);
	after_x = x - (new_c * lx - new_s * ly) + x_low;
	after_y = y - (new_s * lx + new_c * ly) + y_low;
	cni_mask same = (before_x == after_x) & (before_y == after_y) & (c == new_c) & (s == new_s);
	*moved = ~same;
	cni_wide_scatter4_to(records, at_center, x, y, x_low, y_low);
	cni_wide_scatter2_to(records, at_rotation, new_c, new_s);
	if (world->readback_kept)
		lanes_show(world, k, *moved, after_x, after_y, new_c, new_s);
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		f->m[l].dpx = f->m[l].dpy = f->m[l].theta = 0.0f;
	return cni_wide_max(cni_wide_abs(f->dx), cni_wide_abs(f->dy)) + cni_wide_abs(f->turn) * f->turn_reach +
	       cni_wide_of(CNI_BODY_ROUNDING) * (cni_wide_abs(x) + cni_wide_abs(y) + f->extent);
}

/* The rest of take_pose: flags, and the room less the taken part. Returns bits of bodies without enough room for the way ahead. */
CNI_INLINE uint32_t lanes_rooms(const body_lanes *f, cni_wide taken, cni_mask moved, float dt)
{
	cni_wide step = cni_wide_of(dt), ahead = cni_wide_max(cni_wide_abs(step * f->vx), cni_wide_abs(step * f->vy));
	cni_mask room, flags = moved & ((int32_t)CNI_BODY_MOVED - (cni_mask){ 0 });
	for (int32_t l = 0; l < CNI_WIDTH; ++l)
		room[l] = f->b[l]->room;
	room = (cni_mask)cni_wide_max((cni_wide)(room << 16) - taken, cni_wide_of(0.0f)) >> 16;
	for (int32_t l = 0; l < CNI_WIDTH; ++l) {
		f->b[l]->room = (uint16_t)room[l];
		f->b[l]->flags = (f->b[l]->flags & ~CNI_BODY_OF_THE_WAY) | (uint32_t)flags[l];
	}
	return ~cni_mask_bits((cni_wide)(room << 16) > ahead) & ALL_LANES;
}

/* body_accelerates for bodies without damping. */
CNI_INLINE cni_mask lanes_accelerate(const cn_world *world, int32_t k, const body_lanes *f, float h)
{
	const int32_t row[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
	cni_wide start_x, start_y, ax, ay, dx, dy, most_sq, flags, w, jumped, alpha, step = cni_wide_of(h), zero = cni_wide_of(0.0f);
	cni_wide_gather4(&cni_starts(world)[k].vx, (int32_t)(sizeof(cni_velocity_start) / sizeof(float)), row, &start_x, &start_y, &w, &jumped);
	cni_wide_gather4(&cni_externals(world)[k].ax, (int32_t)(sizeof(cni_external) / sizeof(float)), row, &ax, &ay, &alpha, &flags);
	cni_mask is_free = ((cni_mask)flags & ((int32_t)CNI_EXTERNAL_FREE - (cni_mask){ 0 })) != (cni_mask){ 0 };
	ax = step * ax;
	ay = step * ay;
	dx = f->vx - start_x + ax;
	dy = f->vy - start_y + ay;
	most_sq = cni_wide_of(CNI_REST_CHANGE_PART * CNI_REST_CHANGE_PART) * (ax * ax + ay * ay) + cni_wide_of(cni_little_change_sq(world, h));
	return (is_free & ((ax != zero) | (ay != zero))) | (~is_free & (dx * dx + dy * dy > most_sq));
}

typedef struct rest_state {
	uint32_t slow, still; /* bits of bodies; still: not accelerating */
	float dt, delay;
	cni_gain_limits gain;
	uint32_t pushed, left, rested;
} rest_state;

/* Updates one body's velocity, rest timer and external force. Bodies with special rest rules are left to finalize.c. Called per lane:
   compilers do not unroll the loop. */
CNI_INLINE void lane_rest(rest_state *r, cni_body *b, const cni_motion *m, cni_external *d, uint32_t lane)
{
	if (!(r->slow & lane) && b->sleep_speed < 0.0f) {
		cni_body_restless(b);
	} else if (b->sleep_speed >= 0.0f || b->type != CN_BODY_DYNAMIC || !(b->flags & CN_BODY_SLEEP) || (d->flags & CNI_EXTERNAL_DAMPED)) {
		r->left |= lane;
		return;
	} else {
		int32_t rests = (r->still & lane) && !cni_body_gains(b, m, m->vx - b->vx, m->vy - b->vy, m->w - b->w, &r->gain);
		b->sleep_time = rests ? b->sleep_time + r->dt : 0.0f;
		r->rested |= b->sleep_time >= r->delay && b->sleep_time > 0.0f;
	}
	memcpy(&b->vx, &m->vx, 3 * sizeof(float));
	d->ax = d->ay = d->alpha = 0.0f;
}

/* cni_is_pushed. */
CNI_INLINE uint32_t lanes_pushed(const cni_solve *s, const body_lanes *f)
{
	cni_wide step = cni_wide_of(s->dt), most_sq = cni_wide_of(s->pushed_most * s->pushed_most), x = f->dx - step * f->vx, y = f->dy - step * f->vy;
	cni_wide turn = (f->turn - step * f->w) * f->extent;
	return cni_mask_bits((x * x + y * y > most_sq) | (turn * turn > most_sq));
}

CNI_INLINE rest_state lanes_rest(const cn_world *world, const cni_solve *s, int32_t k, const body_lanes *f)
{
	cni_wide slow_sq = cni_wide_of(world->settings.sleep_speed * world->settings.sleep_speed), turn = f->w * f->extent;
	rest_state r = { 0, 0, s->dt, world->settings.sleep_delay, cni_gain_limits_make(world, s->dt), 0, 0, 0 };
	cni_external *d = cni_externals(world) + k;
	r.pushed = lanes_pushed(s, f);
	r.slow = cni_mask_bits((f->v_sq <= slow_sq) & (turn * turn <= slow_sq)) & ~r.pushed;
	if (r.slow != 0)
		r.still = cni_mask_bits(~lanes_accelerate(world, k, f, s->h));
	lane_rest(&r, f->b[0], &f->m[0], &d[0], 1u);
	lane_rest(&r, f->b[1], &f->m[1], &d[1], 2u);
	lane_rest(&r, f->b[2], &f->m[2], &d[2], 4u);
	lane_rest(&r, f->b[3], &f->m[3], &d[3], 8u);
#if CNI_WIDTH == 8
	lane_rest(&r, f->b[4], &f->m[4], &d[4], 16u);
	lane_rest(&r, f->b[5], &f->m[5], &d[5], 32u);
	lane_rest(&r, f->b[6], &f->m[6], &d[6], 64u);
	lane_rest(&r, f->b[7], &f->m[7], &d[7], 128u);
#endif
	return r;
}

static cni_poses_taken kernel_poses(cn_world *world, const cni_solve *s, int32_t begin, int32_t end)
{
	cni_poses_taken out = { 0, 0, 0, 0, 0 };
	int32_t k;
	for (k = begin; k + CNI_WIDTH <= end; k += CNI_WIDTH) {
		cni_mask moved;
		body_lanes f;
		if (!lanes_load(world, k, &f)) {
			out.left |= (uint64_t)ALL_LANES << (k - begin);
			continue;
		}
		cni_wide taken = lanes_poses(world, k, &f, &moved);
		out.no_room |= (uint64_t)lanes_rooms(&f, taken, moved, s->dt) << (k - begin);
		rest_state r = lanes_rest(world, s, k, &f);
		out.rest |= (uint64_t)r.left << (k - begin);
		out.pushed |= (uint64_t)r.pushed << (k - begin);
		out.rested |= r.rested;
	}
	for (; k < end; ++k)
		out.left |= (uint64_t)1 << (k - begin);
	return out;
}
