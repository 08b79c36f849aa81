/*
 * model/contact.c - contact records: lists, creation and destruction, begin and end of touching (layout in contact.h).
 *
 * Owns the contact table, its free list, the apart list and the sleep store. Contact events are logged here (deferred ones by
 * cni_contact_send_deferred_events), which makes them bookended: a contact that has logged CREATED logs DESTROYED before its
 * record is freed, one that has logged ENTER logs LEAVE before it stops touching.
 */
#include "model/world.h"

#include <string.h>

/* ---- lists ---- */

/* More contacts with static bodies than this are not kept in front. */
#define STATIC_IN_FRONT 8

/* The key after which a contact is linked, CNI_NONE: first. Contacts with static bodies are in front of all others, where continuous
   collision finds them without reading the others' records. */
static int32_t link_after(const cn_world *world, const cni_contact *c, cni_body *b)
{
	int32_t key = b->contact_first, after = CNI_NONE, count = 0;
	if ((c->flags & CNI_CONTACT_STATIC) || (b->flags & CNI_BODY_MIXED))
		return CNI_NONE;
	for (; key != CNI_NONE && (cni_contact_of_key(world, key)->flags & CNI_CONTACT_STATIC); ++count) {
		if (count == STATIC_IN_FRONT) {
			b->flags |= CNI_BODY_MIXED;
			return CNI_NONE;
		}
		after = key;
		key = cni_contact_of_key(world, key)->next[key & 1];
	}
	return after;
}

static void list_link(cn_world *world, int32_t contact, cni_contact *c, int32_t side, cni_body *b)
{
	int32_t key = contact << 1 | side, prev = link_after(world, c, b);
	int32_t *from = prev != CNI_NONE ? &cni_contact_of_key(world, prev)->next[prev & 1] : &b->contact_first;
	c->prev[side] = prev;
	c->next[side] = *from;
	if (*from != CNI_NONE)
		cni_contact_of_key(world, *from)->prev[*from & 1] = key;
	*from = key;
	++b->contact_count;
}

static void list_unlink(cn_world *world, int32_t contact, int32_t side)
{
	cni_contact *c = cni_contact_at(world, contact);
	cni_body *b = cni_body_at(world, c->body[side]);
	int32_t next = c->next[side], prev = c->prev[side];
	if (prev != CNI_NONE)
		cni_contact_of_key(world, prev)->next[prev & 1] = next;
	else
		b->contact_first = next;
	if (next != CNI_NONE)
		cni_contact_of_key(world, next)->prev[next & 1] = prev;
	if (--b->contact_count == 0)
		b->flags &= ~(uint32_t)CNI_BODY_MIXED;
}

static int32_t one_is_dynamic(const cn_world *world, const cni_shape *a, const cni_shape *b)
{
	return cni_body_at(world, a->body)->type == CN_BODY_DYNAMIC || cni_body_at(world, b->body)->type == CN_BODY_DYNAMIC;
}

/* A sensor detects shapes that are not sensors, of bodies that may move. */
static int32_t sensor_may_see(const cn_world *world, const cni_shape *a, const cni_shape *b)
{
	const cni_shape *visitor = a->flags & CN_SHAPE_SENSOR ? b : a;
	return !(a->flags & b->flags & CN_SHAPE_SENSOR) && cni_body_at(world, visitor->body)->type != CN_BODY_STATIC;
}

int32_t cni_contact_user_allows(const void *context, int32_t proxy_a, int32_t proxy_b)
{
	const cn_world *world = (const cn_world *)context;
	cn_world *locked = (cn_world *)(uintptr_t)world; /* the lock is the only field that changes during a filter */
	if (world->filter == NULL)
		return 1;
	++locked->locked;
	int32_t allowed = world->filter(locked, cni_handles_of(&world->shape_handles, cni_proxy_at(world, proxy_a)->shape),
	                        cni_handles_of(&world->shape_handles, cni_proxy_at(world, proxy_b)->shape), world->filter_user);
	--locked->locked;
	return allowed != 0;
}

int32_t cni_contact_possible(const void *context, int32_t proxy_a, int32_t proxy_b)
{
	const cn_world *world = (const cn_world *)context;
	const cni_shape *a = cni_shape_at(world, cni_proxy_at(world, proxy_a)->shape);
	const cni_shape *b = cni_shape_at(world, cni_proxy_at(world, proxy_b)->shape);
	if (a->body == b->body || !cni_filter_allows(a, b))
		return 0;
	if ((a->flags | b->flags) & CN_SHAPE_SENSOR ? !sensor_may_see(world, a, b) : !one_is_dynamic(world, a, b))
		return 0;
	if (cni_manifold_function(cni_min_i(a->type, b->type), cni_max_i(a->type, b->type)) == NULL)
		return 0;
	return !cni_joint_forbids(world, a->body, b->body);
}

int32_t cni_contact_allowed(const cn_world *world, int32_t proxy_a, int32_t proxy_b)
{
	return cni_contact_possible(world, proxy_a, proxy_b) && cni_contact_user_allows(world, proxy_a, proxy_b);
}

/* ---- creation and destruction ---- */

/* Memory for the ends of so many contacts in these logs of contacts and sensors, beside what is in them if more is 1. */
static int32_t ends_reserve(cn_world *world, cni_array *logs, cni_array *sensed, int32_t count, int32_t more)
{
	cni_array *leave = &logs[CN_EVENT_LEAVE], *destroyed = &logs[CN_EVENT_DESTROYED];
	return cni_array_reserve(sensed, &world->memory, more * sensed->count + count) && cni_array_reserve(leave, &world->memory, more * leave->count + count) &&
	       cni_array_reserve(destroyed, &world->memory, more * destroyed->count + count);
}

/* With a fixed memory block, room for the end events of every contact that reports is reserved before it does: destroying must not fail
   without memory. The logs of the last step and of calls since are swapped, so both reserve it. */
int32_t cni_contact_reserve_reports(cn_world *world, int32_t count)
{
	cni_events *events = &world->events;
	return !CNI_HAS_EVENTS || (ends_reserve(world, events->log, &events->sensor_log, count, 0) && ends_reserve(world, events->pending, &events->sensor_pending, count, 0));
}

cn_result cni_contact_reserve(cn_world *world, int32_t extra)
{
	int32_t count = world->contact_count + extra;
	int32_t good = cni_table_reserve(&world->contacts, &world->memory, cni_max_i(world->contact_used, count)) &&
	               cni_array_reserve(&world->apart, &world->memory, count);
	return good ? CN_OK : CN_ERROR_MEMORY;
}

/* Most contacts report nothing. */
CNI_INLINE int32_t event_log(cn_world *world, int32_t contact, const cni_contact *c, int32_t kind)
{
	return !cni_contact_reports_kind(c, kind) || cni_event_log(world, contact, kind);
}

static void log_or_defer(cn_world *world, int32_t contact, cni_contact *c, int32_t kind, uint32_t owed)
{
	if (!event_log(world, contact, c, kind))
		c->flags |= owed;
}

/* The flags of a contact that is to have these: in a fixed block without room for the ends of its events it has none. */
static uint32_t flags_with_room(cn_world *world, uint32_t flags)
{
	if (!cni_contact_reports(flags))
		return flags;
	if (world->memory.fixed &&
	    (world->contacts_reporting >= world->event_capacity || !cni_contact_reserve_reports(world, world->contacts_reporting + 1))) {
		world->warnings |= CN_WARNING_EVENT_MEMORY;
		++world->events_not_reported;
		return flags & CNI_CONTACT_SENSOR ? CNI_CONTACT_SENSOR | CNI_CONTACT_MUTE : flags & ((1u << CNI_CONTACT_EVENTS_SHIFT) - 1u);
	}
	++world->contacts_reporting;
	return flags;
}

/* Flags of a contact between two shapes. Sensor pairs report through sensor events only. */
static uint32_t flags_of_shapes(const cni_shape *a, const cni_shape *b)
{
	uint32_t shapes = (uint32_t)(a->flags | b->flags), flags = 0;
	if (shapes & CN_SHAPE_SENSOR)
		return CNI_CONTACT_SENSOR;
	if (shapes & CN_SHAPE_ONE_WAY)
		flags |= CNI_CONTACT_ONE_WAY;
	if (shapes & CN_SHAPE_PRE_SOLVE)
		flags |= CNI_CONTACT_PRE_SOLVE;
	return flags | (uint32_t)(a->event_mask | b->event_mask) << CNI_CONTACT_EVENTS_SHIFT;
}

/*
 * Free records are a stack. Each has the index of the next one and of the four after it: otherwise each of many takes in a row
 * would wait for a record's memory to find the next one.
 */
static int32_t record_take(cn_world *world)
{
	int32_t contact = world->contact_free;
	const cni_contact *c, *ahead;
	if (contact == CNI_NONE)
		return world->contact_used++;
	c = cni_contact_at(world, contact);
	world->contact_free = c->slot;
	if (c->prev[1] != CNI_NONE) {
		ahead = cni_contact_at(world, c->prev[1]);
		CNI_PREFETCH(ahead);
		CNI_PREFETCH((const char *)(ahead + 1) - 1);
	}
	return contact;
}

static void record_give(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	const cni_contact *below = world->contact_free == CNI_NONE ? NULL : cni_contact_at(world, world->contact_free);
	c->slot = world->contact_free;
	c->next[0] = below == NULL ? CNI_NONE : below->slot;
	c->next[1] = below == NULL ? CNI_NONE : below->next[0];
	c->prev[0] = below == NULL ? CNI_NONE : below->next[1];
	c->prev[1] = below == NULL ? CNI_NONE : below->prev[0];
	world->contact_free = contact;
}

void cni_contact_create(cn_world *world, int32_t proxy_a, int32_t proxy_b)
{
	const cni_shape *a = cni_shape_at(world, cni_proxy_at(world, proxy_a)->shape);
	const cni_shape *b = cni_shape_at(world, cni_proxy_at(world, proxy_b)->shape);
	int32_t contact = record_take(world), side;
	cni_contact *c = cni_contact_at(world, contact);
	cni_body *body[2];
	++world->contact_count;
	memset(c, 0, sizeof *c);
	side = a->type > b->type; /* manifold functions take the lesser type first */
	c->proxy[side] = proxy_a;
	c->proxy[1 - side] = proxy_b;
	c->body[side] = a->body;
	c->body[1 - side] = b->body;
	c->slot = CNI_NONE;
	c->flags = flags_with_room(world, flags_of_shapes(a, b));
	body[0] = cni_body_at(world, c->body[0]);
	body[1] = cni_body_at(world, c->body[1]);
	if (body[0]->type == CN_BODY_STATIC || body[1]->type == CN_BODY_STATIC)
		c->flags |= CNI_CONTACT_STATIC;
	list_link(world, contact, c, 0, body[0]);
	list_link(world, contact, c, 1, body[1]);
	if (body[0]->awake != 0 || body[1]->awake != 0) {
		cni_contact_mark_static(body[0], body[1]);
		cni_contact_enter_apart_list(world, contact);
	}
	log_or_defer(world, contact, c, CN_EVENT_CREATED, CNI_CONTACT_CREATED_OWED);
}

cn_result cni_contact_reserve_end(cn_world *world, int32_t contacts)
{
	int32_t ends = cni_min_i(contacts, world->contacts_reporting); /* callers count contacts between two of their bodies twice */
	return !CNI_HAS_EVENTS || ends_reserve(world, world->events.pending, &world->events.sensor_pending, ends, 1) ? CN_OK : CN_ERROR_MEMORY;
}

int32_t cni_contact_destroy(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	if ((c->flags & CNI_CONTACT_TOUCHING) && !cni_contact_end(world, contact))
		return 0;
	if ((c->flags & CNI_CONTACT_SENSING) && !cni_contact_update_sensor(world, contact, 0))
		return 0;
	if (!(c->flags & CNI_CONTACT_CREATED_OWED) && !event_log(world, contact, c, CN_EVENT_DESTROYED))
		return 0;
	cni_contact_leave_apart_list(world, contact);
	list_unlink(world, contact, 0);
	list_unlink(world, contact, 1);
	world->contacts_reporting -= cni_contact_reports(c->flags);
	c->flags = 0;
	c->body[0] = c->body[1] = CNI_NONE;
	record_give(world, contact);
	--world->contact_count;
	return 1;
}

static void destroy_and_wake(cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	int32_t a = c->body[0], b = c->body[1], touching = (c->flags & CNI_CONTACT_TOUCHING) != 0;
	int32_t done = cni_contact_destroy(world, contact);
	CNI_ASSERT(done); /* the caller reserved memory for the logs */
	(void)done;
	if (touching) {
		cni_body_wake(world, a);
		cni_body_wake(world, b);
	}
}

void cni_contact_destroy_of_body(cn_world *world, int32_t body)
{
	const cni_body *b = cni_body_at(world, body);
	while (b->contact_first != CNI_NONE)
		destroy_and_wake(world, b->contact_first >> 1);
}

void cni_contact_destroy_of_shape(cn_world *world, int32_t shape)
{
	int32_t key = cni_contact_first_of_shape(world, shape);
	while (key != CNI_NONE) {
		int32_t contact = key >> 1;
		key = cni_contact_next_of_shape(world, key, shape);
		destroy_and_wake(world, contact);
	}
}

/* When a pair starts to report both a begin event and its end event, the begin event is deferred to the next step; when it stops
   reporting both, the end event is logged now. So events stay bookended while masks change. */
static void event_span_change(cn_world *world, int32_t contact, uint32_t mask, int32_t begin, int32_t end, uint32_t owed)
{
	cni_contact *c = cni_contact_at(world, contact);
	uint32_t span = 1u << begin | 1u << end;
	int32_t before = (c->flags >> CNI_CONTACT_EVENTS_SHIFT & span) == span, after = (mask & span) == span;
	if (before == after)
		return;
	if (after) {
		c->flags |= owed;
		cni_contact_invalidate(world, contact);
		return;
	}
	if (!(c->flags & owed))
		cni_event_log(world, contact, end); /* the caller reserved memory */
	c->flags &= ~owed;
}

void cni_contact_set_events(cn_world *world, int32_t contact, uint32_t mask)
{
	cni_contact *c = cni_contact_at(world, contact);
	if (c->flags & CNI_CONTACT_SENSOR)
		return;
	int32_t had = cni_contact_reports(c->flags);
	if (!had)
		mask = flags_with_room(world, mask << CNI_CONTACT_EVENTS_SHIFT) >> CNI_CONTACT_EVENTS_SHIFT;
	if (c->flags & CNI_CONTACT_TOUCHING)
		event_span_change(world, contact, mask, CN_EVENT_ENTER, CN_EVENT_LEAVE, CNI_CONTACT_ENTER_OWED);
	event_span_change(world, contact, mask, CN_EVENT_CREATED, CN_EVENT_DESTROYED, CNI_CONTACT_CREATED_OWED);
	c->flags = (c->flags & ((1u << CNI_CONTACT_EVENTS_SHIFT) - 1u)) | mask << CNI_CONTACT_EVENTS_SHIFT;
	world->contacts_reporting -= had && mask == 0;
	cni_contact_mark_sums(world, c);
}

/* ---- touching ---- */

/* Links the islands of two dynamic bodies that begin to touch, and wakes a sleeping side. */
static void contact_join_islands(cn_world *world, cni_contact *c)
{
	if (cni_body_at(world, c->body[0])->type == CN_BODY_DYNAMIC && cni_body_at(world, c->body[1])->type == CN_BODY_DYNAMIC) {
		cni_island_link(world, c->body[0], c->body[1]);
		c->flags |= CNI_CONTACT_LINKED;
		return;
	}
	for (int32_t side = 0; side < 2; ++side)
		if (cni_body_at(world, c->body[side])->type == CN_BODY_DYNAMIC && cni_body_at(world, c->body[side])->awake == 0)
			cni_body_wake(world, c->body[side]);
}

/* Closing speed along the normal before the solver runs. */
static float approach_now(const cn_world *world, const cni_contact *c, const cni_manifold *manifold)
{
	const cni_body *a = cni_body_at(world, c->body[0]), *b = cni_body_at(world, c->body[1]);
	cn_velocity va = cni_body_velocity(world, a), vb = cni_body_velocity(world, b);
	cni_vec2 n = cni_rotate(a->q, manifold->normal);
	cni_vec2 ra = cni_rotate(a->q, cni_sub(manifold->points[0].point, a->local_center));
	cni_vec2 rb = cni_sub(ra, cni_v(b->cx - a->cx, b->cy - a->cy));
	cni_vec2 at_a = cni_madd(va.linear_mps, va.angular_radps, cni_left_perp(ra));
	cni_vec2 at_b = cni_madd(vb.linear_mps, vb.angular_radps, cni_left_perp(rb));
	return cni_max(-cni_dot(n, cni_sub(at_b, at_a)), 0.0f);
}

/* May it have rolling resistance, or a conveyor? */
static int32_t may_need_extra(const cn_world *world, const cni_contact *c)
{
	for (int32_t side = 0; side < 2; ++side) {
		const cni_shape *s = cni_shape_at(world, cni_proxy_at(world, c->proxy[side])->shape);
		if (s->rolling_resistance > 0.0f || s->tangent_speed != 0.0f)
			return 1;
	}
	return world->material_mix != NULL;
}

int32_t cni_contact_begin(cn_world *world, int32_t contact, const cni_touch_result *touch)
{
	cni_contact *c = cni_contact_at(world, contact);
	if (!cni_lane_reserve(world, world->touching_count + 1) || !cni_island_reserve(world, 1) || (may_need_extra(world, c) && !cni_lane_reserve_extra(world)))
		return 0;
	++world->touching_count;
	float approach = approach_now(world, c, &touch->manifold);
	contact_join_islands(world, c);
	cni_contact_leave_apart_list(world, contact);
	cni_lane_take(world, contact);
	c->flags |= CNI_CONTACT_TOUCHING | CNI_CONTACT_ENTERED | CNI_CONTACT_REFRESH;
	cni_contact_mark_sums(world, c);
	c->id[0] = c->id[1] = 0;
	cni_block_anchor_at(world, c->slot / CNI_LANES)->of.fresh.approach[c->slot % CNI_LANES] = approach;
	cni_lane_set_fresh(world, c->slot);
	cni_contact_write(world, c, cni_body_at(world, c->body[0]), cni_body_at(world, c->body[1]), touch);
	log_or_defer(world, contact, c, CN_EVENT_ENTER, CNI_CONTACT_ENTER_OWED);
	return 1;
}

int32_t cni_contact_end(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	if (!(c->flags & CNI_CONTACT_ENTER_OWED) && !event_log(world, contact, c, CN_EVENT_LEAVE)) {
		if (!(c->flags & CNI_CONTACT_ASLEEP))
			cni_contact_write_empty(world, contact);
		return 0;
	}
	if (c->flags & CNI_CONTACT_ASLEEP)
		cni_contact_sleep_lane_free(world, c);
	else
		cni_lane_free(world, contact);
	if (c->flags & CNI_CONTACT_LINKED)
		cni_island_unlink(world, c->body[0]);
	c->flags &= ~(uint32_t)(CNI_CONTACT_TOUCHING | CNI_CONTACT_LINKED | CNI_CONTACT_ENTER_OWED | CNI_CONTACT_ENTERED);
	--world->touching_count;
	if (cni_body_at(world, c->body[0])->awake != 0 || cni_body_at(world, c->body[1])->awake != 0)
		cni_contact_enter_apart_list(world, contact);
	return 1;
}

/* Does a contact of another edge of a chain say already that the two shapes overlap? */
static int32_t is_sensed_by_another(const cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	int32_t a = cni_proxy_at(world, c->proxy[0])->shape, b = cni_proxy_at(world, c->proxy[1])->shape;
	if (cni_shape_children(&world->blocks, cni_shape_at(world, a)) == 1 && cni_shape_children(&world->blocks, cni_shape_at(world, b)) == 1)
		return 0;
	for (int32_t key = cni_contact_first_of_shape(world, a); key != CNI_NONE; key = cni_contact_next_of_shape(world, key, a)) {
		const cni_contact *other = cni_contact_of_key(world, key);
		if (key >> 1 != contact && (other->flags & CNI_CONTACT_SENSING) &&
		    (cni_proxy_at(world, other->proxy[0])->shape == b || cni_proxy_at(world, other->proxy[1])->shape == b))
			return 1;
	}
	return 0;
}

int32_t cni_contact_update_sensor(cn_world *world, int32_t contact, int32_t overlaps)
{
	cni_contact *c = cni_contact_at(world, contact);
	int32_t was = (c->flags & CNI_CONTACT_SENSING) != 0;
	if (was == overlaps || (c->flags & CNI_CONTACT_MUTE))
		return 1;
	if (!is_sensed_by_another(world, contact) && !cni_sensor_event_log(world, contact, overlaps ? CN_EVENT_ENTER : CN_EVENT_LEAVE))
		return 0;
	c->flags ^= (uint32_t)CNI_CONTACT_SENSING;
	if (cni_has_areas(world))
		cni_area_visited(world, contact);
	return 1;
}
