/*
 * stages/narrowphase.c - stages 3 and 4: how the shapes of awake contacts touch.
 *
 * First every awake contact is looked at on its own: one that goes on touching has its lane rewritten in
 * place; one whose state changes is put on a list. Then the list is worked through in contact order: lanes are
 * taken and freed, islands linked, events logged, ended pairs removed. Only the second part
 * changes shared tables.
 *
 * Reads bodies, shapes, geometry, proxies; writes contacts, lanes, and through them islands and events.
 *
 * Contact margin: slow pairs touch when closer than four slops (speculative contact). Fast pairs look as far
 * ahead as they come closer in the step, so that they meet the surface instead of each other's inside; a
 * point that their motion does not reach is dropped.
 */
#include "stages/solver.h"

typedef struct cni_change {
	int32_t contact;
	int32_t reserved;
	cni_manifold manifold; /* count 0: ended */
} cni_change;

typedef struct pair_motion {
	cni_vec2 v;       /* velocity of b's centre relative to a's, in a's frame */
	float wa, wb;
	float reach;      /* most that surface points can come closer in the step */
} pair_motion;

static pair_motion motion_make(const cn_world *world, const cni_body *a, const cni_body *b, float dt)
{
	const cni_motion *ma = cni_motions(world) + a->awake, *mb = cni_motions(world) + b->awake;
	pair_motion m;
	m.v = cni_unrotate(a->q, cni_v(mb->vx - ma->vx, mb->vy - ma->vy));
	m.wa = ma->w;
	m.wb = mb->w;
	m.reach = dt * (cni_abs(m.v.x) + cni_abs(m.v.y) + cni_abs(m.wa) * a->extent + cni_abs(m.wb) * b->extent);
	return m;
}

/* Keeps the points that are within the plain margin or are reached within the step. */
static void drop_unreached(cni_manifold *out, const pair_motion *m, const cni_body *a, cni_vec2 b_center, float margin, float dt)
{
	int32_t k, kept = 0;
	for (k = 0; k < out->count; ++k) {
		cni_vec2 p = out->points[k].point;
		cni_vec2 ra = cni_sub(p, a->local_center), rb = cni_sub(p, b_center);
		cni_vec2 v = cni_add(m->v, cni_sub(cni_mul(m->wb, cni_left_perp(rb)), cni_mul(m->wa, cni_left_perp(ra))));
		float closing = -cni_dot(out->normal, v);
		if (out->points[k].separation <= margin + cni_max(closing, 0.0f) * dt)
			out->points[kept++] = out->points[k];
	}
	out->count = kept;
}

static void contact_collide(const cn_world *world, cni_contact *c, float dt, cni_manifold *out)
{
	const cni_proxy *pa = cni_proxy_at(world, c->proxy[0]), *pb = cni_proxy_at(world, c->proxy[1]);
	const cni_shape *sa = cni_shape_at(world, pa->shape), *sb = cni_shape_at(world, pb->shape);
	const cni_body *a = cni_body_at(world, c->body[0]), *b = cni_body_at(world, c->body[1]);
	float margin = world->settings.contact_margin;
	pair_motion m = motion_make(world, a, b, dt);
	cni_manifold_input in;
	in.a = cni_shape_geometry(&world->blocks, sa);
	in.b = cni_shape_geometry(&world->blocks, sb);
	in.child_a = pa->child;
	in.child_b = pb->child;
	in.b_in_a = cni_body_b_in_a(a, b);
	in.slop = world->settings.slop;
	in.margin = cni_max(margin, m.reach);
	out->count = 0;
	cni_manifold_function(sa->type, sb->type)(&in, &c->cache, out);
	if (m.reach > margin)
		drop_unreached(out, &m, a, cni_transform_point(in.b_in_a, b->local_center), margin, dt);
}

/* Looks at one contact: 1 when its state changes (out then says how). */
static int32_t contact_update(cn_world *world, int32_t contact, float dt, cni_manifold *out)
{
	cni_contact *c = cni_contact_at(world, contact);
	int32_t touching = (c->flags & CNI_CONTACT_TOUCHING) != 0;
	c->flags &= ~(uint32_t)CNI_CONTACT_ENTERED;
	if (c->flags & CNI_CONTACT_ASLEEP)
		return 0;
	contact_collide(world, c, dt, out);
	if (out->count > 0 && touching) {
		cni_contact_write(world, contact, out);
		return (c->flags & CNI_CONTACT_ENTER_OWED) != 0;
	}
	if (out->count > 0 || touching)
		return 1;
	return !cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat) ||
	       (c->flags & CNI_CONTACT_CREATED_OWED);
}

static void pay_owed(cn_world *world, int32_t contact, uint32_t owed, int32_t kind)
{
	cni_contact *c = cni_contact_at(world, contact);
	if ((c->flags & owed) && cni_event_log(world, contact, kind))
		c->flags &= ~owed;
}

static void change_apply(cn_world *world, const cni_change *change)
{
	cni_contact *c = cni_contact_at(world, change->contact);
	pay_owed(world, change->contact, CNI_CONTACT_CREATED_OWED, CN_EVENT_CREATED);
	if (change->manifold.count > 0) {
		if (c->flags & CNI_CONTACT_TOUCHING) {
			pay_owed(world, change->contact, CNI_CONTACT_ENTER_OWED, CN_EVENT_ENTER);
		} else if (!cni_contact_begin(world, change->contact, &change->manifold)) {
			world->warnings |= CN_WARNING_CONTACT_MEMORY;
			++world->pairs_not_added;
		}
		return;
	}
	if ((c->flags & CNI_CONTACT_TOUCHING) && !cni_contact_end(world, change->contact))
		return;
	if (!cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat))
		cni_contact_destroy(world, change->contact);
}

static void changes_apply(cn_world *world, cni_array *changes)
{
	int32_t k;
	for (k = 0; k < changes->count; ++k)
		change_apply(world, (const cni_change *)changes->data + k);
	changes->count = 0;
}

void cni_stage_narrowphase(cn_world *world, float dt)
{
	int32_t k = 0;
	cni_array *changes = &world->changes;
	cni_change overflow;
	while (k < world->awake_contacts.count) {
		int32_t contact = ((const int32_t *)world->awake_contacts.data)[k];
		cni_change *next = changes->count < changes->capacity || cni_array_reserve(changes, &world->memory, changes->count + 1)
		                       ? (cni_change *)changes->data + changes->count : &overflow;
		next->contact = contact;
		next->reserved = 0;
		++k;
		if (!contact_update(world, contact, dt, &next->manifold))
			continue;
		if (next != &overflow) {
			++changes->count;
			continue;
		}
		/* No room to remember it: leave its change to the next step, but do not solve a stale manifold. */
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		if (cni_contact_at(world, contact)->flags & CNI_CONTACT_TOUCHING && overflow.manifold.count == 0)
			cni_contact_write_empty(world, contact);
	}
	changes_apply(world, changes);
}

void cni_narrowphase_init(cn_world *world)
{
	cni_array_init(&world->changes, (int32_t)sizeof(cni_change));
}
