/*
 * model/event.c - the logs behind contact, sensor and joint events (design in event.h).
 */
#include "model/event.h"
#include "model/world.h"

#include <string.h>

void cni_events_init(cni_events *events)
{
	int32_t kind;
	memset(events, 0, sizeof *events);
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		cni_array_init(&events->log[kind], (int32_t)sizeof(cni_event));
		cni_array_init(&events->pending[kind], (int32_t)sizeof(cni_event));
		cni_array_init(&events->seen[kind], (int32_t)sizeof(cn_contact_event));
	}
	cni_array_init(&events->sensor_log, (int32_t)sizeof(cn_sensor_event));
	cni_array_init(&events->sensor_pending, (int32_t)sizeof(cn_sensor_event));
	cni_array_init(&events->joint_log, (int32_t)sizeof(cn_joint_event));
	cni_array_init(&events->joint_pending, (int32_t)sizeof(cn_joint_event));
	cni_array_init(&events->moved, (int32_t)sizeof(cn_body_moved));
	cni_array_init(&events->asleep, (int32_t)sizeof(cn_body));
}

void cni_events_deinit(cni_events *events, cni_memory *memory)
{
	int32_t kind;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		cni_array_deinit(&events->log[kind], memory);
		cni_array_deinit(&events->pending[kind], memory);
		cni_array_deinit(&events->seen[kind], memory);
	}
	cni_array_deinit(&events->sensor_log, memory);
	cni_array_deinit(&events->sensor_pending, memory);
	cni_array_deinit(&events->joint_log, memory);
	cni_array_deinit(&events->joint_pending, memory);
	cni_array_deinit(&events->moved, memory);
	cni_array_deinit(&events->asleep, memory);
}

static void pending_to_log(cni_array *log, cni_array *pending)
{
	cni_array old = *log;
	*log = *pending;
	*pending = old;
	pending->count = 0;
}

void cni_events_begin_step(cni_events *events)
{
	int32_t kind;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		cni_array log = events->log[kind];
		log.count = 0;
		events->log[kind] = log;
		/* Contacts may end between steps too, but begin in steps only. */
		if (kind == CN_EVENT_LEAVE || kind == CN_EVENT_DESTROYED) {
			events->log[kind] = events->pending[kind];
			events->pending[kind] = log;
		}
		events->built[kind] = 0;
		events->seen[kind].count = 0;
	}
	pending_to_log(&events->sensor_log, &events->sensor_pending);
	pending_to_log(&events->joint_log, &events->joint_pending);
	events->moved_built = 0;
	events->asleep.count = 0;
}

int32_t cni_event_log(cn_world *world, int32_t contact, int32_t kind)
{
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_proxy *a = cni_proxy_at(world, c->proxy[0]), *b = cni_proxy_at(world, c->proxy[1]);
	cni_array *log = world->events.in_step ? &world->events.log[kind] : &world->events.pending[kind];
	cni_event *e;
	if (!(c->flags >> CNI_CONTACT_EVENTS_SHIFT & 1u << kind))
		return 1;
	if (!cni_array_reserve(log, &world->memory, log->count + 1)) {
		world->warnings |= CN_WARNING_EVENT_MEMORY;
		++world->events_not_reported;
		return 0;
	}
	e = (cni_event *)log->data + log->count++;
	e->shape_a = cni_handles_of(&world->shape_handles, a->shape);
	e->shape_b = cni_handles_of(&world->shape_handles, b->shape);
	e->body_a = cni_handles_of(&world->body_handles, c->body[0]);
	e->body_b = cni_handles_of(&world->body_handles, c->body[1]);
	e->child = cni_proxy_child(b) != 0 ? ~cni_proxy_child(b) : cni_proxy_child(a);
	e->contact = contact;
	e->approach_speed = kind == CN_EVENT_ENTER ? cni_contact_approach(world, c) : 0.0f;
	return 1;
}

int32_t cni_sensor_event_log(cn_world *world, int32_t contact, int32_t kind)
{
	const cni_contact *c = cni_contact_at(world, contact);
	cni_array *log = world->events.in_step ? &world->events.sensor_log : &world->events.sensor_pending;
	int32_t shapes[2], side;
	cn_sensor_event *e;
	if (!cni_array_reserve(log, &world->memory, log->count + 1)) {
		world->warnings |= CN_WARNING_EVENT_MEMORY;
		++world->events_not_reported;
		return 0;
	}
	shapes[0] = cni_proxy_at(world, c->proxy[0])->shape;
	shapes[1] = cni_proxy_at(world, c->proxy[1])->shape;
	side = cni_shape_at(world, shapes[0])->flags & CN_SHAPE_SENSOR ? 0 : 1;
	e = (cn_sensor_event *)log->data + log->count++;
	e->sensor = cni_handles_of(&world->shape_handles, shapes[side]);
	e->visitor = cni_handles_of(&world->shape_handles, shapes[1 - side]);
	e->sensor_body = cni_handles_of(&world->body_handles, c->body[side]);
	e->visitor_body = cni_handles_of(&world->body_handles, c->body[1 - side]);
	e->kind = kind;
	e->reserved = 0;
	return 1;
}

/* Does the record still hold the contact of the event? */
static int32_t event_is_current(const cn_world *world, const cni_event *e)
{
	const cni_contact *c = cni_contact_at(world, e->contact);
	return (c->flags & CNI_CONTACT_TOUCHING) && c->body[0] != CNI_NONE &&
	       cni_handles_find(&world->shape_handles, e->shape_a) == cni_proxy_at(world, c->proxy[0])->shape &&
	       cni_handles_find(&world->shape_handles, e->shape_b) == cni_proxy_at(world, c->proxy[1])->shape;
}

static void event_expand(const cn_world *world, const cni_event *e, int32_t kind, cn_contact_event *out)
{
	memset(out, 0, sizeof *out);
	if (kind == CN_EVENT_ENTER && event_is_current(world, e))
		cni_contact_describe(world, e->contact, kind, out);
	out->shape_a = e->shape_a;
	out->shape_b = e->shape_b;
	out->body_a = e->body_a;
	out->body_b = e->body_b;
	out->child_a = e->child >= 0 ? e->child : 0;
	out->child_b = e->child < 0 ? ~e->child : 0;
	out->contact_id = (uint32_t)e->contact + 1u;
	out->kind = kind;
	out->approach_speed_mps = e->approach_speed;
}

static int32_t contact_stays(const cni_contact *c)
{
	const uint32_t mask = CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP | CNI_CONTACT_ENTERED | CNI_CONTACT_ENTER_OWED;
	return (c->flags & mask) == CNI_CONTACT_TOUCHING && (c->flags >> CNI_CONTACT_EVENTS_SHIFT & 1u << CN_EVENT_STAY);
}

static int32_t stay_add(cn_world *world, int32_t contact, cni_array *seen)
{
	if (!contact_stays(cni_contact_at(world, contact)))
		return 1;
	if (!cni_array_reserve(seen, &world->memory, seen->count + 1)) {
		seen->count = 0;
		return 0;
	}
	cni_contact_describe(world, contact, CN_EVENT_STAY, (cn_contact_event *)seen->data + seen->count++);
	return 1;
}

static cn_result build_stay(cn_world *world, cni_array *seen)
{
	int32_t color, block, l;
	for (color = 0; color < CNI_COLORS; ++color)
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next)
			for (l = 0; l < CNI_LANES && cni_block_info_at(world, block)->contact[l] != CNI_NONE; ++l)
				if (!stay_add(world, cni_block_info_at(world, block)->contact[l], seen))
					return CN_ERROR_MEMORY;
	return CN_OK;
}

cn_result cni_events_build(cn_world *world, int32_t kind)
{
	cni_events *events = &world->events;
	cni_array *seen = &events->seen[kind];
	const cni_array *log = &events->log[kind];
	int32_t k;
	if (events->built[kind])
		return CN_OK;
	seen->count = 0;
	if (kind == CN_EVENT_STAY) {
		if (build_stay(world, seen) != CN_OK)
			return CN_ERROR_MEMORY;
	} else {
		if (!cni_array_reserve(seen, &world->memory, log->count))
			return CN_ERROR_MEMORY;
		for (k = 0; k < log->count; ++k)
			event_expand(world, (const cni_event *)log->data + k, kind, (cn_contact_event *)seen->data + k);
		seen->count = log->count;
	}
	events->built[kind] = 1;
	return CN_OK;
}

void cni_contact_send_deferred_events(cn_world *world, int32_t contact, uint32_t owed, int32_t kind)
{
	cni_contact *c = cni_contact_at(world, contact);
	if (!(c->flags & owed) || !cni_event_log(world, contact, kind))
		return;
	c->flags &= ~owed;
	if (kind == CN_EVENT_ENTER)
		c->flags |= CNI_CONTACT_ENTERED;
}
