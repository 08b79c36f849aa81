/*
 * model/body.c - body records, the dense arrays of awake bodies (layout in body.h), fat boxes. Mass from shapes is in body_shapes.c.
 *
 * Invariant: for every dense index k >= 1, record awake_id[k] has awake == k; every lane of a touching contact has the current
 * dense indices of its bodies, 0 for a body without one.
 */
#include "model/world.h"

#include <string.h>

const cni_body cni_body_none = { 0 };

cn_velocity cni_body_velocity(const cn_world *world, const cni_body *b)
{
	const cni_motion *m = cni_motions(world) + b->awake;
	cn_velocity awake = { { m->vx, m->vy }, m->w }, asleep = { { b->vx, b->vy }, b->w };
	return b->awake != 0 ? awake : asleep;
}

cni_vec2 cni_body_velocity_at(const cn_world *world, const cni_body *b, cni_vec2 point)
{
	cn_velocity v = cni_body_velocity(world, b);
	return cni_madd(v.linear_mps, v.angular_radps, cni_left_perp(cni_body_arm(b, point)));
}

void cni_body_store_velocity(cn_world *world, cni_body *b, cn_velocity v)
{
	if (b->flags & CN_BODY_LOCK_X)
		v.linear_mps.x = 0.0f;
	if (b->flags & CN_BODY_LOCK_Y)
		v.linear_mps.y = 0.0f;
	if (b->flags & CN_BODY_LOCK_ROTATION)
		v.angular_radps = 0.0f;
	if (b->awake != 0) {
		cni_motion *m = cni_motions(world) + b->awake;
		m->vx = v.linear_mps.x;
		m->vy = v.linear_mps.y;
		m->w = v.angular_radps;
	}
	b->vx = v.linear_mps.x;
	b->vy = v.linear_mps.y;
	b->w = v.angular_radps;
	b->flags &= ~(uint32_t)CNI_BODY_AHEAD;
}

void cni_readback_store(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	if (!world->readback_kept)
		return;
	cn_body_moved *shown = cni_readback_at(world, body);
	shown->pose = cni_body_pose(b);
	shown->user_data = b->user_data;
	shown->body = cni_handles_of(&world->body_handles, body);
	shown->fell_asleep = b->flags & CNI_BODY_MOVED ? world->step_count + (uint32_t)world->events.in_step : 0u;
}

void cni_body_init(cn_world *world, int32_t body, const cn_body_def *def)
{
	cni_body *b = cni_body_at(world, body);
	cn_velocity v = { def->linear_velocity_mps, def->angular_velocity_radps };
	memset(b, 0, sizeof *b);
	b->cx = def->position_m.x;
	b->cy = def->position_m.y;
	b->q = cni_sincos(def->angle_rad);
	b->linear_damping = def->linear_damping_per_s;
	b->angular_damping = def->angular_damping_per_s;
	b->gravity_scale = def->gravity_scale;
	b->sleep_speed = def->sleep_speed_mps;
	b->flags = def->flags & ~(uint32_t)CN_BODY_AWAKE;
	cni_body_set_solver(world, b, def->solver);
	b->type = (uint8_t)def->type;
	b->mass = def->type == CN_BODY_DYNAMIC ? 1.0f : 0.0f;
	b->island = b->island_next = b->island_prev = CNI_NONE;
	b->shape_first = b->joint_first = b->contact_first = CNI_NONE;
	b->user_data = def->user_data;
	cni_readback_store(world, body);
	if (def->type != CN_BODY_STATIC && (def->flags & CN_BODY_AWAKE)) /* what sleeps does not move */
		cni_body_store_velocity(world, b, v);
}

void cni_body_set_solver(cn_world *world, cni_body *b, int32_t solver)
{
	b->flags &= ~(uint32_t)(CNI_BODY_SOLVER_SOFT | CNI_BODY_SOLVER_DIRECT);
	b->flags |= solver == CN_SOLVER_SOFT ? (uint32_t)CNI_BODY_SOLVER_SOFT : solver == CN_SOLVER_DIRECT ? (uint32_t)CNI_BODY_SOLVER_DIRECT : 0u;
	if (solver != CN_SOLVER_AUTO)
		world->overridden = 1;
}

cn_result cni_body_reserve(cn_world *world, int32_t extra)
{
	int32_t count = world->movable_count + extra + 1;
	int32_t good = cni_array_reserve(&world->motion, &world->memory, count) &&
	               cni_array_reserve(&world->start, &world->memory, count) &&
	               cni_array_reserve(&world->external, &world->memory, count) &&
	               cni_array_reserve(&world->awake_id, &world->memory, count);
	return good ? CN_OK : CN_ERROR_MEMORY;
}

void cni_body_refresh_motion(cn_world *world, cni_body *b)
{
	if (b->awake == 0)
		return;
	cni_motion *m = cni_motions(world) + b->awake;
	m->inv_mass = b->type == CN_BODY_DYNAMIC ? 1.0f / b->mass : 0.0f;
	m->inv_inertia = b->type == CN_BODY_DYNAMIC && b->inertia > 0.0f && !(b->flags & CN_BODY_LOCK_ROTATION) ? 1.0f / b->inertia : 0.0f;
	if (b->flags & CN_BODY_LOCK_X)
		m->vx = b->vx = 0.0f;
	if (b->flags & CN_BODY_LOCK_Y)
		m->vy = b->vy = 0.0f;
	if (b->flags & CN_BODY_LOCK_ROTATION)
		m->w = b->w = 0.0f;
}

static void arrays_set_count(cn_world *world, int32_t count)
{
	world->awake_count = count;
	world->motion.count = count;
	world->start.count = count;
	world->external.count = count;
	world->awake_id.count = count;
}

void cni_body_enter_awake(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	int32_t k = world->awake_count;
	CNI_ASSERT(b->awake == 0 && b->type != CN_BODY_STATIC && (b->flags & CN_BODY_ENABLED));
	CNI_ASSERT(k < world->motion.capacity);
	arrays_set_count(world, k + 1);
	cni_motion *m = cni_motions(world) + k;
	memset(m, 0, sizeof *m);
	memset(cni_starts(world) + k, 0, sizeof(cni_velocity_start));
	memset(cni_externals(world) + k, 0, sizeof(cni_external));
	m->vx = b->vx;
	m->vy = b->vy;
	m->w = b->w;
	cni_awake_ids(world)[k] = body;
	b->awake = k;
	cni_body_refresh_motion(world, b);
	cni_contact_fix_body(world, body);
}

void cni_body_leave_awake(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	int32_t k = b->awake, last = world->awake_count - 1;
	cni_motion *m = cni_motions(world);
	CNI_ASSERT(k >= 1 && cni_awake_ids(world)[k] == body);
	b->vx = m[k].vx;
	b->vy = m[k].vy;
	b->w = m[k].w;
	b->awake = 0;
	b->flags &= ~((uint32_t)CNI_BODY_AHEAD | (uint32_t)CNI_BODY_MOVED);
	cni_contact_fix_body(world, body);
	if (k != last) {
		int32_t moved = cni_awake_ids(world)[last];
		m[k] = m[last];
		cni_starts(world)[k] = cni_starts(world)[last];
		cni_externals(world)[k] = cni_externals(world)[last];
		cni_awake_ids(world)[k] = moved;
		cni_body_at(world, moved)->awake = k;
		cni_contact_fix_body(world, moved);
	}
	arrays_set_count(world, last);
}

void cni_body_set_transform(cn_world *world, int32_t body, cni_vec2 origin, cni_rot q)
{
	cni_body *b = cni_body_at(world, body);
	cni_vec2 r = cni_rotate(q, b->local_center);
	b->q = q;
	b->cx = origin.x + r.x;
	b->cy = origin.y + r.y;
	b->cx_low = b->cy_low = 0.0f;
	cni_readback_store(world, body);
	if (body < world->previous.count)
		((cni_previous *)world->previous.data)[body].body = 0; /* no interpolation across a teleport */
	cni_body_refresh_boxes(world, body);
}

void cni_body_refresh_boxes(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	cni_transform x = cni_body_transform(b);
	cni_body_forget_room(b);
	for (int32_t index = b->shape_first; index != CNI_NONE; index = cni_shape_at(world, index)->next) {
		const cni_shape *s = cni_shape_at(world, index);
		for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child) {
			int32_t proxy = cni_shape_proxy(world, s, child);
			if (proxy == CNI_NONE)
				break;
			cni_aabb tight = cni_geometry_aabb(cni_shape_geometry(&world->blocks, s), child, x);
			if (b->type == CN_BODY_STATIC) {
				cni_seams_change(world, &cni_proxy_at(world, proxy)->fat);
				cni_seams_change(world, &tight);
			}
			if (cni_aabb_contains(&cni_proxy_at(world, proxy)->fat, &tight))
				continue;
			cni_aabb fat = cni_box_fatten(tight, cni_box_margin(world, b->type, &tight));
			cni_proxy_set_fat(cni_proxy_at(world, proxy), &fat);
			world->broadphase_ops->move(world->broadphase, proxy);
		}
	}
}

/* The list has room for as many destroyed bodies as there are living ones. Beyond, and without memory, the boxes are stretched now, by a step
   whose length is likely. */
void cni_body_kick(cn_world *world, int32_t body)
{
	cni_array *kicked = &world->kicked;
	cni_body *b = cni_body_at(world, body);
	cni_vec2 v = cni_body_velocity(world, b).linear_mps;
	if ((v.x == 0.0f && v.y == 0.0f) || (b->flags & CNI_BODY_KICKED))
		return;
	if (kicked->count < 2 * world->body_handles.count && cni_array_reserve(kicked, &world->memory, kicked->count + 1)) {
		((cn_body *)kicked->data)[kicked->count++] = cni_handles_of(&world->body_handles, body);
		b->flags |= CNI_BODY_KICKED;
	} else if (b->awake != 0) {
		(void)cni_body_boxes_set(world, b, cni_mul(cni_max(world->step_dt, world->fixed_step), v), world);
	}
}

static cni_aabb box_stretch(cni_aabb box, cni_vec2 ahead)
{
	box.x0 += cni_min(ahead.x, 0.0f);
	box.x1 += cni_max(ahead.x, 0.0f);
	box.y0 += cni_min(ahead.y, 0.0f);
	box.y1 += cni_max(ahead.y, 0.0f);
	return box;
}

/* Least distance between the sides of a box and of one within it. */
static float box_room(const cni_aabb *outer, const cni_aabb *inner)
{
	float x = cni_min(inner->x0 - outer->x0, outer->x1 - inner->x1), y = cni_min(inner->y0 - outer->y0, outer->y1 - inner->y1);
	return cni_min(x, y);
}

/* Result for a proxy's box, as bits. _AHEAD: the box covers the way ahead. */
enum { BOX_STAYS = 0, BOX_AHEAD = 1, BOX_LEAVES = 2 };

/* Compares a proxy's box with the shape's box now and after the way ahead. BOX_LEAVES: it has a new box. *room: distance by which the
   resulting box encloses the shape, now and ahead. */
CNI_INLINE int32_t box_leaves(const cn_world *world, const cni_body *b, cni_proxy *p, const cni_transform *x, cni_vec2 ahead, float *room)
{
	float way_x = cni_abs(ahead.x), way_y = cni_abs(ahead.y), margin, rounding = CNI_BODY_ROUNDING * cni_max(cni_abs(b->cx) + cni_abs(b->cy) + b->extent, way_x + way_y);
	cni_aabb box;
	cni_geometry_box(cni_proxy_geometry(&world->blocks, p), cni_proxy_child(p), x, &box);
	*room = box_room(&p->fat, &box) - rounding;
	if (*room > cni_max(way_x, way_y))
		return BOX_STAYS;
	margin = cni_box_margin(world, b->type, &box);
	int32_t reaches = cni_max(way_x, way_y) > 0.5f * margin; /* a shorter way needs no stretched box */
	if (reaches)
		box = box_stretch(box, ahead);
	if (cni_aabb_contains(&p->fat, &box)) {
		if (!reaches || box_room(&p->fat, &box) <= rounding)
			return BOX_STAYS;
		*room = box_room(&p->fat, &box) - rounding;
		return BOX_AHEAD;
	}
	if (reaches && b->lanes == 0 && CNI_ON(FAT_BOXES))
		box = box_stretch(box, cni_mul(CNI_BOX_FLIGHT_STEPS, ahead));
	box = cni_box_fatten(box, margin);
	cni_proxy_set_fat(p, &box);
	*room = margin - rounding;
	return reaches ? BOX_LEAVES | BOX_AHEAD : BOX_LEAVES;
}

int32_t cni_body_boxes_set(const cn_world *world, cni_body *b, cni_vec2 ahead, cn_world *tell)
{
	cni_transform x = cni_body_transform(b);
	float room = FLT_MAX, one;
	int32_t set = CNI_BOXES_NONE, reaches = 1;
	const cni_shape *s;
	if (cni_body_has_room(b, ahead))
		return CNI_BOXES_NONE;
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = s->next) {
		s = cni_shape_at(world, shape);
		for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child) {
			int32_t proxy = cni_shape_proxy(world, s, child), what = box_leaves(world, b, cni_proxy_at(world, proxy), &x, ahead, &one);
			room = cni_min(room, one);
			reaches &= what; /* BOX_AHEAD */
			if (!(what & BOX_LEAVES))
				continue;
			set = set == CNI_BOXES_NONE ? proxy : CNI_BOXES_SEVERAL;
			if (tell != NULL)
				tell->broadphase_ops->move(tell->broadphase, proxy);
		}
	}
	b->flags = reaches ? b->flags | CNI_BODY_AHEAD : b->flags & ~(uint32_t)CNI_BODY_AHEAD;
	cni_body_set_room(b, room);
	return set;
}

static void proxy_tell(cn_world *world, int32_t proxy)
{
	if (cni_proxy_at(world, proxy)->flags & CNI_PROXY_MOVED)
		world->broadphase_ops->move(world->broadphase, proxy);
}

void cni_body_boxes_tell(cn_world *world, const cni_body *b, int32_t set)
{
	if (set != CNI_BOXES_SEVERAL) {
		proxy_tell(world, set);
		return;
	}
	for (int32_t shape = b->shape_first; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next) {
		const cni_shape *s = cni_shape_at(world, shape);
		for (int32_t child = 0; child < cni_shape_children(&world->blocks, s); ++child)
			proxy_tell(world, cni_shape_proxy(world, s, child));
	}
}
