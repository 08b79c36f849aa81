/*
 * model/event.c - the logs behind contact, sensor and joint events (design in event.h).
 */
#include "model/world.h"

#include <string.h>

static void pending_to_log(cni_array *log, cni_array *pending)
{
	cni_array old = *log;
	*log = *pending;
	*pending = old;
	pending->count = 0;
}

void cni_events_forget_built(cni_events *events)
{
	for (int32_t kind = 0; kind < CN_EVENT_KINDS; ++kind)
		events->built[kind] = events->seen[kind].count = 0;
	events->moved_built = events->moved.count = 0;
}

void cni_events_begin_step(cni_events *events)
{
	for (int32_t kind = 0; kind < CN_EVENT_KINDS; ++kind)
		if (kind == CN_EVENT_LEAVE || kind == CN_EVENT_DESTROYED) /* contacts may end between steps too, but begin in steps only */
			pending_to_log(&events->log[kind], &events->pending[kind]);
		else
			events->log[kind].count = 0;
	pending_to_log(&events->sensor_log, &events->sensor_pending);
	pending_to_log(&events->joint_log, &events->joint_pending);
	cni_events_forget_built(events);
	events->asleep.count = 0;
}

void *cni_event_add(cn_world *world, cni_array *log)
{
	if (!cni_array_reserve(log, &world->memory, log->count + 1)) {
		world->warnings |= CN_WARNING_EVENT_MEMORY;
		++world->events_not_reported;
		return NULL;
	}
	return (uint8_t *)log->data + (size_t)log->count++ * (size_t)log->item_bytes;
}

static void event_write(const cn_world *world, int32_t contact, cni_event *e)
{
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_proxy *a = cni_proxy_at(world, c->proxy[0]), *b = cni_proxy_at(world, c->proxy[1]);
	e->shape_a = cni_handles_of(&world->shape_handles, a->shape);
	e->shape_b = cni_handles_of(&world->shape_handles, b->shape);
	e->body_a = cni_handles_of(&world->body_handles, c->body[0]);
	e->body_b = cni_handles_of(&world->body_handles, c->body[1]);
	e->child = cni_proxy_child(b) != 0 ? ~cni_proxy_child(b) : cni_proxy_child(a);
	e->contact = contact;
	e->approach_speed = 0.0f;
}

/* Clears the impulses of an ENTER, and reads its approach speed, 0 once the lane is anchored. */
static void enter_begin(const cn_world *world, const cni_contact *c, cni_event *e)
{
	cni_block_anchor *anchor = cni_contact_free_anchor(world, c);
	int32_t l = c->slot % CNI_LANES;
	if (anchor == NULL)
		return;
	anchor->c[l] = anchor->s[l] = 0.0f;
	e->approach_speed = anchor->of.fresh.approach[l];
}

void cni_contact_add_enter_impulses(cn_world *world, const cni_contact *c, float normal, float friction)
{
	cni_block_anchor *anchor = c->flags & CNI_CONTACT_ENTERED ? cni_contact_free_anchor(world, c) : NULL;
	if (anchor == NULL)
		return;
	anchor->c[c->slot % CNI_LANES] += normal;
	anchor->s[c->slot % CNI_LANES] += friction;
}

static void enter_impulses_read(const cn_world *world, const cni_contact *c, cn_contact_event *out)
{
	const cni_block_anchor *anchor = cni_contact_free_anchor(world, c);
	if (anchor == NULL)
		return;
	out->normal_impulse_Ns = anchor->c[c->slot % CNI_LANES];
	out->friction_impulse_Ns = anchor->s[c->slot % CNI_LANES];
}

int32_t cni_event_log(cn_world *world, int32_t contact, int32_t kind)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (!cni_contact_reports_kind(c, kind))
		return 1;
	cni_event *e = (cni_event *)cni_event_add(world, world->events.in_step ? &world->events.log[kind] : &world->events.pending[kind]);
	if (e == NULL)
		return 0;
	event_write(world, contact, e);
	if (kind == CN_EVENT_ENTER)
		enter_begin(world, c, e);
	return 1;
}

static int32_t contact_stays(const cni_contact *c)
{
	const uint32_t mask = CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP | CNI_CONTACT_ENTERED | CNI_CONTACT_ENTER_OWED;
	return (c->flags & mask) == CNI_CONTACT_TOUCHING && cni_contact_reports_kind(c, CN_EVENT_STAY);
}

void cni_event_log_stay(cn_world *world, int32_t contact, const cni_event_sums *sums)
{
	if (!contact_stays(cni_contact_at(world, contact)))
		return;
	cni_event_stay *e = (cni_event_stay *)cni_event_add(world, &world->events.log[CN_EVENT_STAY]);
	if (e == NULL)
		return;
	e->contact = contact;
	e->normal_impulse = sums->normal;
	e->friction_impulse = sums->friction;
}

/* The manifold lists its points without those that are missing. */
static cn_vec2 hit_point(const cni_contact *c, const cn_manifold *m, int32_t point)
{
	int32_t k = point == 1 && c->id[0] != 0 ? 1 : 0;
	return m->points[cni_min_i(k, cni_max_i(m->point_count - 1, 0))].point_m;
}

void cni_event_log_hit(cn_world *world, int32_t contact, const cni_event_sums *sums)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if ((c->flags & CNI_CONTACT_ENTER_OWED) || !cni_contact_reports_kind(c, CN_EVENT_HIT))
		return;
	cn_contact_event *e = (cn_contact_event *)cni_event_add(world, &world->events.log[CN_EVENT_HIT]);
	if (e == NULL)
		return;
	cni_contact_describe(world, contact, CN_EVENT_HIT, e);
	e->approach_speed_mps = sums->approach;
	e->normal_impulse_Ns = sums->normal;
	e->friction_impulse_Ns = sums->friction;
	e->hit_point_m = hit_point(c, &e->manifold, sums->point);
}

int32_t cni_sensor_event_log(cn_world *world, int32_t contact, int32_t kind)
{
	const cni_contact *c = cni_contact_at(world, contact);
	cni_array *log = world->events.in_step ? &world->events.sensor_log : &world->events.sensor_pending;
	int32_t shapes[2], side;
	shapes[0] = cni_proxy_at(world, c->proxy[0])->shape;
	shapes[1] = cni_proxy_at(world, c->proxy[1])->shape;
	side = cni_shape_at(world, shapes[0])->flags & CN_SHAPE_SENSOR ? 0 : 1;
	cn_sensor_event *e = (cn_sensor_event *)cni_event_add(world, log);
	if (e == NULL)
		return 0;
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
	if (kind == CN_EVENT_ENTER && event_is_current(world, e)) {
		cni_contact_describe(world, e->contact, kind, out);
		enter_impulses_read(world, cni_contact_at(world, e->contact), out);
	}
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

/* A pair that stayed and then fell asleep, or ended, is left out. */
static void build_stay(const cn_world *world, const cni_array *log, cni_array *seen)
{
	for (int32_t k = 0; k < log->count; ++k) {
		const cni_event_stay *e = (const cni_event_stay *)log->data + k;
		cn_contact_event *out = (cn_contact_event *)seen->data + seen->count;
		if (!contact_stays(cni_contact_at(world, e->contact)))
			continue;
		cni_contact_describe(world, e->contact, CN_EVENT_STAY, out);
		out->normal_impulse_Ns = e->normal_impulse;
		out->friction_impulse_Ns = e->friction_impulse;
		++seen->count;
	}
}

static void build_from_log(const cn_world *world, const cni_array *log, int32_t kind, cni_array *seen)
{
	if (kind == CN_EVENT_STAY) {
		build_stay(world, log, seen);
		return;
	}
	for (; seen->count < log->count; ++seen->count) {
		cn_contact_event *out = (cn_contact_event *)seen->data + seen->count;
		if (kind == CN_EVENT_HIT)
			*out = ((const cn_contact_event *)log->data)[seen->count];
		else
			event_expand(world, (const cni_event *)log->data + seen->count, kind, out);
	}
}

cn_result cni_events_build(cn_world *world, int32_t kind)
{
	cni_events *events = &world->events;
	cni_array *seen = &events->seen[kind];
	const cni_array *log = &events->log[kind];
	if (events->built[kind])
		return CN_OK;
	seen->count = 0;
	if (!cni_array_reserve(seen, &world->memory, log->count))
		return CN_ERROR_MEMORY;
	build_from_log(world, log, kind, seen);
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
