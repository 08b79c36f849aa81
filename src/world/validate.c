/*
 * world/validate.c - checks every invariant between the tables, reading only.
 *
 * The report has the name of the first failed check and the index it failed at. Tests call this after every
 * failed allocation and every refused argument, and worlds from files pass it (save/file_check.c says what was checked before).
 *
 * Doubly linked lists are followed with the links back: a node has one predecessor, so a walk cannot come into a circle. What is in
 * several lists of one kind, or in none, shows in the sum of their lengths.
 */
#include "world/error.h"

#include <string.h>

typedef struct report {
	const cn_world *world;
	const char *what;   /* name of the failed check, NULL for none */
	int32_t index;
	int32_t shapes, contact_ends, joint_ends, members; /* lengths of all lists of bodies; bodies with an island */
} report;

static void expect(report *r, int32_t good, const char *what, int32_t index)
{
	if (good || r->what != NULL)
		return;
	r->what = what;
	r->index = index;
}

static int32_t body_alive(const cn_world *world, int32_t body)
{
	return body >= 0 && cni_handles_alive(&world->body_handles, body);
}

/* ---- bodies ---- */

static void check_room(report *r, const cni_body *b, const cni_shape *s, int32_t child, int32_t proxy)
{
	cni_aabb tight = cni_box_fatten(cni_geometry_aabb(cni_shape_geometry(&r->world->blocks, s), child, cni_body_transform(b)), cni_body_room(b));
	expect(r, cni_aabb_contains(&cni_proxy_at(r->world, proxy)->fat, &tight), "room of body", s->body);
	if (!(b->flags & CNI_BODY_AHEAD))
		return;
	tight = cni_box_moved(tight, cni_mul(r->world->step_dt, cni_v(b->vx, b->vy)));
	expect(r, cni_aabb_contains(&cni_proxy_at(r->world, proxy)->fat, &tight), "room ahead of body", s->body);
}

static void check_readback(report *r, int32_t body)
{
	cn_pose pose = cni_body_pose(cni_body_at(r->world, body));
	if (!r->world->readback_kept)
		return;
	const cn_body_moved *shown = cni_readback_at(r->world, body);
	expect(r, memcmp(&shown->pose, &pose, sizeof pose) == 0 && shown->body == cni_handles_of(&r->world->body_handles, body), "readback of body", body);
}

static void check_shapes_of(report *r, int32_t body)
{
	const cn_world *world = r->world;
	const cni_body *b = cni_body_at(world, body);
	int32_t before = CNI_NONE;
	for (int32_t shape = b->shape_first; shape != CNI_NONE && r->what == NULL; before = shape, shape = cni_shape_at(world, shape)->next) {
		const cni_shape *s = cni_shape_at(world, shape);
		expect(r, cni_handles_alive(&world->shape_handles, shape) && s->body == body, "shape list of body", body);
		expect(r, before == CNI_NONE || (s->prev == before && shape != b->shape_first), "shape list of body", body);
		if (r->what != NULL)
			return; /* a dead shape has no geometry */
		expect(r, cni_body_spans(world, b, shape), "extent of body", body);
		++r->shapes;
		for (int32_t child = 0; child < cni_shape_children(&world->blocks, s) && r->what == NULL; ++child) {
			int32_t proxy = cni_shape_proxy(world, s, child);
			expect(r, (proxy != CNI_NONE) == ((b->flags & CN_BODY_ENABLED) != 0), "shape is placed exactly when enabled, shape", shape);
			if (proxy == CNI_NONE)
				continue;
			expect(r, cni_proxy_at(world, proxy)->shape == shape && cni_proxy_child(cni_proxy_at(world, proxy)) == child && cni_proxy_at(world, proxy)->geometry == s->geometry, "proxy of shape", shape);
			expect(r, ((cni_proxy_at(world, proxy)->flags & CNI_PROXY_STATIC) != 0) == (b->type == CN_BODY_STATIC), "static mark of proxy", proxy);
			check_room(r, b, s, child, proxy);
		}
	}
	if (before != CNI_NONE)
		expect(r, cni_shape_at(world, b->shape_first)->prev == before, "last shape of body", body);
}

static void check_contacts_of(report *r, int32_t body)
{
	const cn_world *world = r->world;
	const cni_body *b = cni_body_at(world, body);
	int32_t count = 0, lanes = 0, in_front = 1, before = CNI_NONE, is_static;
	uint32_t colors = 0;
	for (int32_t key = b->contact_first; key != CNI_NONE; before = key, key = cni_contact_of_key(world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(world, key);
		expect(r, c->body[0] != CNI_NONE && c->body[key & 1] == body && c->prev[key & 1] == before, "contact list of body", body);
		if (r->what != NULL)
			return;
		is_static = cni_body_at(world, c->body[0])->type == CN_BODY_STATIC || cni_body_at(world, c->body[1])->type == CN_BODY_STATIC;
		expect(r, ((c->flags & CNI_CONTACT_STATIC) != 0) == is_static, "static flag of contact", key >> 1);
		expect(r, !is_static || in_front || (b->flags & CNI_BODY_MIXED), "order of contacts of body", body);
		in_front = is_static;
		++count;
		if (!cni_contact_has_lane(c))
			continue;
		++lanes;
		if (b->type == CN_BODY_DYNAMIC && cni_block_info_at(world, c->slot / CNI_LANES)->color != CNI_COLOR_OVERFLOW) {
			uint32_t bit = 1u << cni_block_info_at(world, c->slot / CNI_LANES)->color;
			expect(r, (colors & bit) == 0, "a colour twice on body", body);
			colors |= bit;
		}
	}
	r->contact_ends += count;
	expect(r, count == b->contact_count, "contact count of body", body);
	expect(r, lanes == b->lanes, "lane count of body", body);
	expect(r, colors == b->colors, "colours of body", body);
}

static void check_joints_of(report *r, int32_t body)
{
	const cn_world *world = r->world;
	int32_t key, before = CNI_NONE;
	for (key = cni_body_at(world, body)->joint_first; key != CNI_NONE && r->what == NULL; before = key, key = cni_joint_at(world, key >> 1)->next[key & 1]) {
		const cni_joint *j = cni_joint_at(world, key >> 1);
		expect(r, cni_handles_alive(&world->joint_handles, key >> 1) && j->body[key & 1] == body && j->prev[key & 1] == before, "joint list of body", body);
		++r->joint_ends;
	}
}

/* The narrowphase reads velocities of either. */
static void check_motion(report *r, const cni_body *b, int32_t body)
{
	const cn_world *world = r->world;
	const cni_motion *m = cni_motions(world) + b->awake;
	expect(r, cni_is_finite(m->vx) && cni_is_finite(m->vy) && cni_is_finite(m->w), "finite velocity of body", body);
	expect(r, b->vx == m->vx && b->vy == m->vy && b->w == m->w, "velocity in the record of body", body);
	expect(r, m->dpx == 0.0f && m->dpy == 0.0f && m->theta == 0.0f, "no change left over, body", body);
}

static void check_body(report *r, int32_t body)
{
	const cn_world *world = r->world;
	const cni_body *b = cni_body_at(world, body);
	expect(r, cni_is_finite(b->cx) && cni_is_finite(b->cy) && cni_is_finite(b->q.c) && cni_is_finite(b->q.s), "finite pose of body", body);
	expect(r, !(b->flags & CNI_BODY_MARK), "scratch mark of body", body);
	if (b->awake != 0) {
		expect(r, b->awake > 0 && b->awake < world->awake_count && cni_awake_ids(world)[b->awake] == body, "dense index of body", body);
		expect(r, b->type != CN_BODY_STATIC && (b->flags & CN_BODY_ENABLED), "awake body may move, body", body);
		if (r->what != NULL)
			return;
		check_motion(r, b, body);
	} else {
		expect(r, !(b->flags & CN_BODY_ENABLED) || (b->vx == 0.0f && b->vy == 0.0f && b->w == 0.0f), "still body that is not awake, body", body);
	}
	r->members += b->island != CNI_NONE;
	if (b->island != CNI_NONE) {
		expect(r, b->type == CN_BODY_DYNAMIC, "only dynamic bodies have islands, body", body);
		expect(r, (b->awake != 0) == (cni_island_at(world, b->island)->awake != 0), "island sleeps as one, body", body);
	}
	check_readback(r, body);
	check_shapes_of(r, body);
	check_contacts_of(r, body);
	check_joints_of(r, body);
}

static void check_bodies(report *r)
{
	const cn_world *world = r->world;
	int32_t k, movable = 0, kicked = 0;
	for (k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE && r->what == NULL; k = cni_handles_next(&world->body_handles, k + 1)) {
		check_body(r, k);
		movable += cni_body_at(world, k)->type != CN_BODY_STATIC;
		kicked += (cni_body_at(world, k)->flags & CNI_BODY_KICKED) != 0;
	}
	for (k = 0; k < world->kicked.count; ++k)
		kicked -= cni_handles_find(&world->body_handles, ((const cn_body *)world->kicked.data)[k]) != CNI_NONE;
	expect(r, movable == world->movable_count, "count of movable bodies", movable);
	expect(r, kicked <= 0, "bodies whose velocity was set and that no list has", kicked); /* files of earlier versions list some twice */
	for (k = 1; k < world->awake_count && r->what == NULL; ++k)
		expect(r, body_alive(world, cni_awake_ids(world)[k]) && cni_body_at(world, cni_awake_ids(world)[k])->awake == k, "awake list at", k);
}

/* ---- contacts ---- */

static void check_lane(report *r, int32_t contact)
{
	const cn_world *world = r->world;
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_block_info *info = cni_block_info_at(world, c->slot / CNI_LANES);
	const cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	int32_t lane = c->slot % CNI_LANES, flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0;
	expect(r, info->contact[lane] == contact, "lane of contact", contact);
	expect(r, block->ia[lane] == cni_body_at(world, c->body[flipped])->awake && block->ib[lane] == cni_body_at(world, c->body[1 - flipped])->awake,
	       "bodies in the lane of contact", contact);
	expect(r, cni_body_at(world, c->body[flipped])->type == CN_BODY_DYNAMIC, "lane body a is dynamic, contact", contact);
}

static int32_t sleep_lane_is_of(const cn_world *world, int32_t contact)
{
	int32_t slot = cni_contact_at(world, contact)->slot;
	if (CNI_SLEEP_IN_BLOCKS)
		return cni_block_info_at(world, slot)->color == CNI_COLOR_ASLEEP && cni_block_info_at(world, slot)->contact[0] == contact;
	return slot < world->sleep_lanes.count && ((const cni_sleep_lane *)world->sleep_lanes.data)[slot].contact == contact;
}

static void check_contact(report *r, int32_t contact)
{
	const cn_world *world = r->world;
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_body *a = cni_body_at(world, c->body[0]), *b = cni_body_at(world, c->body[1]);
	int32_t both = a->type == CN_BODY_DYNAMIC && b->type == CN_BODY_DYNAMIC, awake = a->awake != 0 || b->awake != 0;
	expect(r, ((c->flags & CNI_CONTACT_LINKED) != 0) == (both && (c->flags & CNI_CONTACT_TOUCHING)), "link of contact", contact);
	if (c->flags & CNI_CONTACT_LINKED)
		expect(r, a->island != CNI_NONE && a->island == b->island, "one island for contact", contact);
	if (!(c->flags & CNI_CONTACT_TOUCHING))
		expect(r, awake ? c->slot >= 0 && c->slot < world->apart.count && ((const int32_t *)world->apart.data)[c->slot] == contact : c->slot == CNI_NONE,
		       "apart list of contact", contact);
	else if (c->flags & CNI_CONTACT_ASLEEP)
		expect(r, sleep_lane_is_of(world, contact), "sleep lane of contact", contact);
	else
		check_lane(r, contact);
}

static void check_contacts(report *r)
{
	const cn_world *world = r->world;
	int32_t count = 0, touching = 0, lanes = 0;
	for (int32_t k = 0; k < world->contact_used && r->what == NULL; ++k) {
		const cni_contact *c = cni_contact_at(world, k);
		if (c->body[0] == CNI_NONE)
			continue;
		expect(r, body_alive(world, c->body[0]) && body_alive(world, c->body[1]), "bodies of contact", k);
		if (r->what == NULL)
			check_contact(r, k);
		++count;
		touching += (c->flags & CNI_CONTACT_TOUCHING) != 0;
	}
	expect(r, count == world->contact_count, "count of contacts", count);
	expect(r, 2 * count == r->contact_ends, "contacts in lists of bodies", r->contact_ends);
	expect(r, touching == world->touching_count, "count of touching contacts", touching);
	for (int32_t k = 0; k < CNI_COLOR_LISTS; ++k)
		lanes += world->colors[k].lanes;
	expect(r, lanes + world->sleep_lanes.count == touching, "lanes in colours and asleep", lanes);
}

/* ---- islands, joints, boxes ---- */

static void check_islands(report *r)
{
	const cn_world *world = r->world;
	int32_t islands = 0, members = 0;
	for (int32_t k = 0; k < world->island_used && r->what == NULL; ++k) {
		const cni_island *i = cni_island_at(world, k);
		int32_t count = 0, before = CNI_NONE;
		if (i->first == CNI_NONE)
			continue;
		++islands;
		for (int32_t body = i->first; body != CNI_NONE && r->what == NULL; before = body, body = cni_body_at(world, body)->island_next) {
			expect(r, body_alive(world, body) && cni_body_at(world, body)->island == k && cni_body_at(world, body)->island_prev == before, "body list of island", k);
			++count;
		}
		expect(r, count == i->count && count >= 2 && i->last == before, "size of island", k);
		members += count;
	}
	expect(r, islands == world->island_count, "count of islands", islands);
	expect(r, members == r->members, "bodies in lists of islands", members);
}

static void check_joint(report *r, int32_t joint)
{
	const cn_world *world = r->world;
	const cni_joint *j = cni_joint_at(world, joint);
	int32_t a = j->body[0], b = j->body[1], is_constraint = cni_joint_is_constraint(j->type);
	expect(r, (a == CNI_NONE || body_alive(world, a)) && (b == CNI_NONE || body_alive(world, b)) && a != b && (!is_constraint || a == CNI_NONE), "bodies of joint", joint);
	if (r->what != NULL)
		return;
	expect(r, j->linked == (cni_joint_is_enabled(world, j) && j->type != CN_JOINT_FILTER && cni_is_dynamic(world, a) && cni_is_dynamic(world, b)), "link of joint", joint);
	if (j->linked && r->what == NULL)
		expect(r, cni_body_at(world, a)->island != CNI_NONE && cni_body_at(world, a)->island == cni_body_at(world, b)->island, "one island for joint", joint);
	expect(r, j->awake == CNI_NONE || (j->awake < world->awake_joints.count && ((const int32_t *)world->awake_joints.data)[j->awake] == joint), "awake list of joint", joint);
}

static void check_joints(report *r)
{
	const cn_world *world = r->world;
	int32_t k, constraints = 0, ends = 0;
	for (k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE && r->what == NULL; k = cni_handles_next(&world->joint_handles, k + 1)) {
		const cni_joint *j = cni_joint_at(world, k);
		constraints += cni_joint_is_constraint(j->type);
		ends += (j->body[0] != CNI_NONE) + (j->body[1] != CNI_NONE);
		check_joint(r, k);
	}
	expect(r, constraints == world->constraint_count, "count of constraints", constraints);
	expect(r, ends == r->joint_ends, "joints in lists of bodies", ends);
	for (k = 0; k < world->awake_joints.count && r->what == NULL; ++k) {
		int32_t joint = ((const int32_t *)world->awake_joints.data)[k];
		expect(r, cni_handles_alive(&world->joint_handles, joint) && cni_joint_at(world, joint)->awake == k && cni_joint_at(world, joint)->type != CN_JOINT_FILTER, "list of awake joints at", k);
	}
}

static void check_shapes(report *r)
{
	const cn_world *world = r->world;
	int32_t attached = 0;
	for (int32_t k = cni_handles_next(&world->shape_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->shape_handles, k + 1))
		attached += cni_shape_at(world, k)->body != CNI_NONE;
	expect(r, attached == r->shapes, "shapes in lists of bodies", attached);
}

static void check_areas(report *r)
{
	const cn_world *world = r->world;
	for (int32_t k = 0; k < world->areas.count && r->what == NULL; ++k) {
		expect(r, cni_handles_alive(&world->shape_handles, cni_areas(world)[k].shape), "shape of area", k);
		expect(r, k == 0 || cni_area_is_before(cni_areas(world) + k - 1, cni_areas(world) + k), "order of area", k);
	}
}

cn_result cn_world_validate(const cn_world *world, char *text, int32_t text_bytes)
{
	report r;
	if (world == NULL || text_bytes < 0 || (text == NULL && text_bytes > 0))
		return CN_ERROR_ARGUMENT;
	memset(&r, 0, sizeof r);
	r.world = world;
	check_bodies(&r);
	check_shapes(&r);
	check_contacts(&r);
	check_islands(&r);
	check_joints(&r);
	check_areas(&r);
	expect(&r, cni_broadphase_holds(world->broadphase_ops, world->broadphase), "broadphase", 0);
	cni_text out = cni_text_begin(text, text_bytes);
	if (r.what == NULL)
		return CN_OK;
	cni_text_string(&out, "broken invariant: ");
	cni_text_string(&out, r.what);
	cni_text_string(&out, " ");
	cni_text_int(&out, r.index);
	return CN_ERROR_INTERNAL;
}
