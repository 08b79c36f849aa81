/*
 * test/world/events_test.c - contact events: bookended, deterministic, masked, and telling the truth.
 *
 * The churn tests do to a world everything that can begin or end a contact, in random order, and keep a ledger
 * of what the events say; after every step the ledger must equal what the world holds.
 *
 * If a test here fails, look first in: model/contact.c (begin, end, destroy), model/event.c (logs),
 * stages/narrowphase.c (changes), world/shape.c (masks, filters), model/contact_lane.c (manifolds).
 */
#include "fixture.h"

enum {
	ALL_EVENTS = (1 << CN_EVENT_KINDS) - 1,
	TOUCH_EVENTS = 1 << CN_EVENT_ENTER | 1 << CN_EVENT_LEAVE,
	BOX_EVENTS = 1 << CN_EVENT_CREATED | 1 << CN_EVENT_DESTROYED
};

static int32_t events_of(cn_world *world, int32_t kind, const cn_contact_event **out)
{
	int32_t count = 0;
	must(cn_world_contact_events(world, kind, out, &count), world, "cn_world_contact_events");
	return count;
}

static int32_t count_events(cn_world *world, int32_t kind)
{
	const cn_contact_event *events;
	return events_of(world, kind, &events);
}

static int32_t count_all_events(cn_world *world)
{
	int32_t kind, count = 0;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		count += count_events(world, kind);
	return count;
}

static cn_shape first_shape(const cn_world *world, cn_body body)
{
	cn_shape shape = 0;
	int32_t count;
	must(cn_body_get_shapes(world, body, &shape, 1, &count), world, "cn_body_get_shapes");
	return shape;
}

static void set_mask(cn_world *world, cn_body body, uint32_t mask)
{
	must(cn_shape_set_event_mask(world, first_shape(world, body), mask), world, "cn_shape_set_event_mask");
}

/* ---- the ledger ---- */

#define LEDGER 16384

typedef struct entry {
	int32_t created, entered, entered_now;
	cn_shape a, b;
	int32_t child_a, child_b;
} entry;

typedef struct ledger {
	entry pairs[LEDGER];
	int32_t created, entered;
	int32_t wrong;          /* events that contradict what came before */
	int32_t masks_change;   /* DESTROYED may then come before LEAVE: its mask went first */
	int32_t told[CN_EVENT_KINDS];
} ledger;

static ledger book;

static void complain(ledger *l, const char *what, const cn_contact_event *e)
{
	if (l->wrong++ < 5)
		printf("  %s: pair %u, shapes %08x %08x\n", what, (unsigned)e->contact_id, (unsigned)e->shape_a, (unsigned)e->shape_b);
}

static int32_t same_pair(const entry *p, const cn_contact_event *e)
{
	return p->a == e->shape_a && p->b == e->shape_b && p->child_a == e->child_a && p->child_b == e->child_b;
}

static void ledger_open(entry *p, const cn_contact_event *e)
{
	p->a = e->shape_a;
	p->b = e->shape_b;
	p->child_a = e->child_a;
	p->child_b = e->child_b;
}

static void ledger_take(ledger *l, int32_t kind, const cn_contact_event *e)
{
	entry *p = &l->pairs[e->contact_id % LEDGER];
	++l->told[kind];
	if (e->kind != kind || e->contact_id == 0 || e->contact_id >= LEDGER)
		complain(l, "bad kind or id", e);
	if ((p->created || p->entered) && !same_pair(p, e))
		complain(l, "event of another pair under the same id", e);
	switch (kind) {
	case CN_EVENT_CREATED:
		if (p->created)
			complain(l, "created twice", e);
		ledger_open(p, e);
		l->created += !p->created;
		p->created = 1;
		break;
	case CN_EVENT_ENTER:
		if (p->entered)
			complain(l, "entered twice", e);
		ledger_open(p, e);
		l->entered += !p->entered;
		p->entered = p->entered_now = 1;
		break;
	case CN_EVENT_STAY:
		if (!p->entered || p->entered_now)
			complain(l, "stay without an earlier enter", e);
		break;
	case CN_EVENT_LEAVE:
		if (!p->entered)
			complain(l, "leave without enter", e);
		l->entered -= p->entered;
		p->entered = 0;
		break;
	default:
		if (!p->created || (p->entered && !l->masks_change))
			complain(l, "destroyed without created, or before leave", e);
		l->created -= p->created;
		p->created = 0;
	}
}

/* Ends come first: an id that ended may begin again in the same step. */
static void ledger_read(ledger *l, cn_world *world, uint64_t *stream)
{
	static const int32_t order[] = { CN_EVENT_LEAVE, CN_EVENT_DESTROYED, CN_EVENT_CREATED, CN_EVENT_ENTER, CN_EVENT_STAY };
	const cn_contact_event *events;
	int32_t o, k, count;
	for (o = 0; o < CN_EVENT_KINDS; ++o) {
		count = events_of(world, order[o], &events);
		for (k = 0; k < count; ++k) {
			const unsigned char *bytes = (const unsigned char *)&events[k];
			size_t byte;
			ledger_take(l, order[o], &events[k]);
			for (byte = 0; byte < sizeof events[k]; ++byte)
				*stream = (*stream ^ bytes[byte]) * 0x100000001B3u;
		}
	}
	for (k = 0; k < LEDGER; ++k)
		l->pairs[k].entered_now = 0;
}

/* ---- churn: a world to which everything happens ---- */

#define CHURN_BODIES 240
#define CHURN_JOINTS 64
#define CHURN_SPARE 32

typedef struct churn {
	cn_world *world;
	uint32_t seed;
	uint32_t mask;                  /* of new shapes */
	int32_t masks_change;
	cn_body bodies[CHURN_BODIES];   /* 0: gone for now */
	cn_joint joints[CHURN_JOINTS];
	cn_shape spare[CHURN_SPARE];    /* detached shapes */
} churn;

static float churn_random(churn *c, float lower, float upper) { return fixture_random(&c->seed, lower, upper); }

static int32_t churn_int(churn *c, int32_t count) { return (int32_t)fixture_random(&c->seed, 0.0f, (float)count - 0.001f); }

static uint32_t churn_mask(churn *c)
{
	static const uint32_t spans[] = { 0, TOUCH_EVENTS, BOX_EVENTS, TOUCH_EVENTS | BOX_EVENTS };
	return c->masks_change ? spans[churn_int(c, 4)] : c->mask;
}

static void churn_shape(churn *c, cn_body body)
{
	cn_shape_def def = fixture_shape_def(body, 0.5f, churn_random(c, -1.0f, 0.5f) > 0.0f ? 0.4f : 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
	cn_capsule capsule = { { -0.3f, 0.0f }, { 0.3f, 0.1f }, 0.15f };
	def.event_mask = churn_mask(c);
	def.offset_m.x = churn_random(c, -0.1f, 0.1f);
	switch (churn_int(c, 3)) {
	case 0: must(cn_shape_create_circle(c->world, &def, &circle, NULL), c->world, "circle"); break;
	case 1: must(cn_shape_create_capsule(c->world, &def, &capsule, NULL), c->world, "capsule"); break;
	default: must(cn_shape_create_box(c->world, &def, 0.3f, 0.2f, 0.0f, NULL), c->world, "box");
	}
}

static void churn_body(churn *c, int32_t k)
{
	int32_t type = churn_int(c, 12) == 0 ? churn_int(c, 2) : CN_BODY_DYNAMIC;
	c->bodies[k] = fixture_body(c->world, type, churn_random(c, -7.0f, 7.0f), churn_random(c, 0.5f, 9.0f), churn_random(c, -3.0f, 3.0f));
	churn_shape(c, c->bodies[k]);
	if (churn_int(c, 4) == 0)
		churn_shape(c, c->bodies[k]);
	if (type != CN_BODY_STATIC)
		fixture_set_velocity(c->world, c->bodies[k], churn_random(c, -3.0f, 3.0f), churn_random(c, -3.0f, 3.0f), churn_random(c, -4.0f, 4.0f));
}

/* A valley of one chain, with a box as a lid on what rolls out. */
static void churn_ground(churn *c)
{
	static const cn_vec2 points[] = { { 9, 10 }, { 8, 1 }, { 5, 0 }, { 2, 0.3f }, { 0, 0 }, { -2, 0.3f }, { -5, 0 }, { -8, 1 }, { -9, 10 } };
	cn_chain chain;
	cn_shape_def def = fixture_shape_def(fixture_body(c->world, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.6f, 0.0f);
	chain.points_m = points;
	chain.count = (int32_t)(sizeof points / sizeof *points);
	chain.loop = 0;
	def.event_mask = churn_mask(c);
	must(cn_shape_create_chain(c->world, &def, &chain, NULL), c->world, "chain");
	def.body = fixture_body(c->world, CN_BODY_STATIC, 0.0f, -3.0f, 0.0f);
	fixture_box_shape(c->world, &def, 40.0f, 1.0f);
}

static void churn_begin(churn *c, uint32_t seed, uint32_t mask, int32_t masks_change)
{
	int32_t k;
	memset(c, 0, sizeof *c);
	c->world = fixture_world(-10.0f, 1);
	c->seed = seed * 2654435761u + 1u;
	c->mask = mask;
	c->masks_change = masks_change;
	must(cn_world_set_sleep(c->world, 0.2f, 0.1f), c->world, "cn_world_set_sleep"); /* much falls asleep and wakes */
	churn_ground(c);
	for (k = 0; k < CHURN_BODIES; ++k)
		churn_body(c, k);
}

static void churn_joint(churn *c, cn_body a, cn_body b)
{
	cn_joint *slot = &c->joints[churn_int(c, CHURN_JOINTS)];
	cn_revolute_def revolute;
	cn_distance_def distance;
	int32_t type_a, type_b;
	if (*slot != 0 && cn_joint_is_valid(c->world, *slot)) {
		if (churn_int(c, 2))
			must(cn_joint_set_flags(c->world, *slot, churn_int(c, 2) ? CN_JOINT_COLLIDE : 0u), c->world, "cn_joint_set_flags");
		else
			must(cn_joint_destroy(c->world, *slot), c->world, "cn_joint_destroy");
		return;
	}
	must(cn_body_get_type(c->world, a, &type_a), c->world, "cn_body_get_type");
	must(cn_body_get_type(c->world, b, &type_b), c->world, "cn_body_get_type");
	if (a == b || (type_a != CN_BODY_DYNAMIC && type_b != CN_BODY_DYNAMIC))
		return;
	cn_revolute_def_init(&revolute);
	cn_distance_def_init(&distance);
	revolute.base.body_a = distance.base.body_a = a;
	revolute.base.body_b = distance.base.body_b = b;
	revolute.base.flags = churn_int(c, 3) == 0 ? CN_JOINT_COLLIDE : 0u;
	distance.length_m = 1.0f;
	if (churn_int(c, 2))
		must(cn_joint_create_revolute(c->world, &revolute, slot), c->world, "cn_joint_create_revolute");
	else
		must(cn_joint_create_distance(c->world, &distance, slot), c->world, "cn_joint_create_distance");
}

/* A body that touches it, for joints that end contacts; else itself. */
static cn_body churn_neighbour(churn *c, cn_body body)
{
	cn_contact_event e[8];
	int32_t count, k;
	must(cn_body_get_contacts(c->world, body, e, 8, &count), c->world, "cn_body_get_contacts");
	for (k = 0; k < count && k < 8; ++k)
		if (e[k].body_a != body || e[k].body_b != body)
			return e[k].body_a == body ? e[k].body_b : e[k].body_a;
	return body;
}

static void churn_filter(churn *c, cn_body body)
{
	static const cn_filter filters[] = {
		{ 1, ~(uint64_t)0, 0, 0 }, { 1, ~(uint64_t)0, 0, 0 }, { 2, 2, 0, 0 }, { 1, 1, -3, 0 }, { 4, 0, 5, 0 }, { (uint64_t)1 << 63, ~(uint64_t)0, 0, 0 }
	};
	if (first_shape(c->world, body) != 0)
		must(cn_shape_set_filter(c->world, first_shape(c->world, body), &filters[churn_int(c, 6)]), c->world, "cn_shape_set_filter");
}

static void churn_detach(churn *c, cn_body body)
{
	cn_shape *slot = &c->spare[churn_int(c, CHURN_SPARE)];
	if (*slot != 0) {
		if (churn_int(c, 4) == 0)
			must(cn_shape_destroy(c->world, *slot), c->world, "cn_shape_destroy");
		else
			must(cn_shape_attach(c->world, *slot, body), c->world, "cn_shape_attach");
		*slot = 0;
	} else if ((*slot = first_shape(c->world, body)) != 0) {
		must(cn_shape_detach(c->world, *slot), c->world, "cn_shape_detach");
	}
}

static void churn_world(churn *c)
{
	cn_vec2 gravity = { 0.0f, -10.0f };
	gravity.x = churn_random(c, -1.0f, 1.0f);
	if (churn_int(c, 4) == 0)
		must(cn_world_set_gravity(c->world, gravity.x, gravity.y), c->world, "cn_world_set_gravity");
	else
		must(cn_world_set_flags(c->world, CN_WORLD_WARM_START | (churn_int(c, 3) ? (uint32_t)CN_WORLD_SLEEP : 0u)), c->world, "cn_world_set_flags");
}

static void churn_teleport(churn *c, cn_body body)
{
	cn_vec2 to;
	to.x = churn_random(c, -7.0f, 7.0f);
	to.y = churn_random(c, 0.5f, 9.0f);
	must(cn_body_set_pose(c->world, body, to.x, to.y, churn_random(c, -3.0f, 3.0f)), c->world, "cn_body_set_pose");
}

static void churn_act(churn *c)
{
	int32_t k = churn_int(c, CHURN_BODIES), what = churn_int(c, 24);
	cn_body body = c->bodies[k], other = c->bodies[churn_int(c, CHURN_BODIES)];
	cn_material material = fixture_shape_def(0, 0.9f, 0.2f).material;
	uint32_t flags;
	if (body == 0) {
		churn_body(c, k);
		return;
	}
	switch (what) {
	case 0: case 1: must(cn_body_destroy(c->world, body), c->world, "cn_body_destroy"); c->bodies[k] = 0; break;
	case 2: case 3: churn_teleport(c, body); break;
	case 4: case 5: churn_filter(c, body); break;
	case 6: case 7:
		if (cn_body_set_type(c->world, body, churn_int(c, 3)) == CN_ERROR_ARGUMENT)
			must(CN_ERROR_ARGUMENT, c->world, "cn_body_set_type");
		break;
	case 8: case 9: case 10:
		must(cn_body_get_flags(c->world, body, &flags), c->world, "cn_body_get_flags");
		must(cn_body_set_flags(c->world, body, flags ^ CN_BODY_ENABLED), c->world, "cn_body_set_flags");
		break;
	case 11: case 12: case 13: churn_detach(c, body); break;
	case 14: case 15: churn_joint(c, body, churn_neighbour(c, body)); break;
	case 16: churn_joint(c, body, other != 0 ? other : body); break;
	case 17: case 18: must(cn_body_set_awake(c->world, body, churn_int(c, 2)), c->world, "cn_body_set_awake"); break;
	case 19: if (churn_int(c, 8) == 0) churn_world(c); break;
	case 20: churn_shape(c, body); break;
	case 21: if (first_shape(c->world, body) != 0) must(cn_shape_set_material(c->world, first_shape(c->world, body), &material), c->world, "material"); break;
	case 22: if (first_shape(c->world, body) != 0) must(cn_shape_set_density(c->world, first_shape(c->world, body), churn_random(c, 0.5f, 4.0f)), c->world, "density"); break;
	default:
		if (c->masks_change && first_shape(c->world, body) != 0)
			must(cn_shape_set_event_mask(c->world, first_shape(c->world, body), churn_mask(c)), c->world, "mask");
	}
}

static void churn_step(churn *c, int32_t calls)
{
	while (calls-- > 0)
		churn_act(c);
	fixture_step(c->world, 1);
}

static void churn_end(churn *c)
{
	int32_t k, count;
	cn_body bodies[CHURN_BODIES + 2];
	must(cn_world_get_bodies(c->world, bodies, CHURN_BODIES + 2, &count), c->world, "cn_world_get_bodies");
	for (k = 0; k < count; ++k)
		must(cn_body_destroy(c->world, bodies[k]), c->world, "cn_body_destroy");
	fixture_step(c->world, 1);
}

/* ---- churn tests ---- */

static void every_beginning_gets_its_end(void)
{
	uint32_t seed;
	for (seed = 1; seed <= 4; ++seed) {
		static churn c;
		int32_t step, off = 0;
		uint64_t stream = 0;
		memset(&book, 0, sizeof book);
		churn_begin(&c, seed, ALL_EVENTS, 0);
		for (step = 0; step < 200; ++step) {
			cn_counters counters;
			churn_step(&c, step % 50 < 40 ? (int32_t)seed * 2 : 0);
			ledger_read(&book, c.world, &stream);
			counters = fixture_counters(c.world);
			off += counters.contacts != book.created || counters.contacts_touching != book.entered;
			if (step % 5 == 0)
				REQUIRE(fixture_is_valid(c.world));
		}
		printf("  seed %u: %d created, %d entered, %d stayed, %d left, %d destroyed\n", (unsigned)seed, (int)book.told[CN_EVENT_CREATED],
		       (int)book.told[CN_EVENT_ENTER], (int)book.told[CN_EVENT_STAY], (int)book.told[CN_EVENT_LEAVE], (int)book.told[CN_EVENT_DESTROYED]);
		churn_end(&c);
		ledger_read(&book, c.world, &stream);
		CHECK_LE("events that contradict earlier ones", book.wrong, 0, "");
		CHECK_LE("steps after which the events' pairs are not the world's", off, 0, "");
		CHECK_LE("pairs left open at the end", book.created + book.entered, 0, "");
		CHECK_GE("pairs entered", book.told[CN_EVENT_ENTER], 1000, "");
		cn_world_destroy(c.world);
	}
}

/* With masks that change under way: what both sides ask for now decides which pairs are open. */
static int32_t mask_of_pair(const cn_world *world, const cn_contact_event *e)
{
	uint32_t a, b;
	must(cn_shape_get_event_mask(world, e->shape_a, &a), world, "cn_shape_get_event_mask");
	must(cn_shape_get_event_mask(world, e->shape_b, &b), world, "cn_shape_get_event_mask");
	return (int32_t)(a | b);
}

static int32_t pairs_off(churn *c, const ledger *l)
{
	int32_t k, i, count, off = 0, open = 0, entered = 0;
	static cn_contact_event e[512];
	cn_body bodies[CHURN_BODIES + 2];
	int32_t body_count;
	must(cn_world_get_bodies(c->world, bodies, CHURN_BODIES + 2, &body_count), c->world, "cn_world_get_bodies");
	for (k = 0; k < body_count; ++k) {
		must(cn_body_get_contacts(c->world, bodies[k], e, 512, &count), c->world, "cn_body_get_contacts");
		for (i = 0; i < count && i < 512; ++i) {
			int32_t mask, awake = fixture_is_awake(c->world, e[i].body_a) || fixture_is_awake(c->world, e[i].body_b);
			const entry *p = &l->pairs[e[i].contact_id];
			if (e[i].body_a != bodies[k])
				continue;
			mask = mask_of_pair(c->world, &e[i]);
			open += p->created;
			entered += p->entered;
			if (!awake)
				continue; /* a sleeping pair may owe its beginning until it wakes */
			off += p->created != ((mask & BOX_EVENTS) == BOX_EVENTS);
			off += p->entered != ((mask & TOUCH_EVENTS) == TOUCH_EVENTS && e[i].kind == CN_EVENT_STAY);
		}
	}
	return off + (open != l->created) + (entered != l->entered);
}

static void changing_masks_keep_pairs_bookended(void)
{
	uint32_t seed;
	for (seed = 1; seed <= 3; ++seed) {
		static churn c;
		int32_t step, off = 0;
		uint64_t stream = 0;
		memset(&book, 0, sizeof book);
		book.masks_change = 1;
		churn_begin(&c, seed + 100, 0, 1);
		for (step = 0; step < 150; ++step) {
			churn_step(&c, step % 50 < 40 ? 10 : 0);
			ledger_read(&book, c.world, &stream);
			off += pairs_off(&c, &book);
		}
		churn_end(&c);
		ledger_read(&book, c.world, &stream);
		CHECK_LE("events that contradict earlier ones", book.wrong, 0, "");
		CHECK_LE("pairs whose events do not follow their masks", off, 0, "");
		CHECK_LE("pairs left open at the end", book.created + book.entered, 0, "");
		CHECK_GE("pairs entered", book.told[CN_EVENT_ENTER], 300, "");
		cn_world_destroy(c.world);
	}
}

static uint64_t churn_stream(uint32_t seed)
{
	static churn c;
	int32_t step;
	uint64_t stream = 0;
	memset(&book, 0, sizeof book);
	churn_begin(&c, seed, ALL_EVENTS, 0);
	for (step = 0; step < 100; ++step) {
		churn_step(&c, 6);
		ledger_read(&book, c.world, &stream);
	}
	stream ^= fixture_hash(c.world);
	cn_world_destroy(c.world);
	return stream;
}

static void equal_histories_tell_equal_events(void)
{
	uint64_t first = churn_stream(7), second = churn_stream(7), other = churn_stream(8);
	printf("  stream %016llx\n", (unsigned long long)first);
	CHECK(first == second);
	CHECK(first != other);
}

/* ---- callbacks ---- */

#define HEARD 20000
typedef struct listener {
	cn_contact_event events[HEARD];
	int32_t count;
	int32_t unlocked; /* calls that should have been refused */
} listener;

static listener ears[CN_EVENT_KINDS];

static void hear(cn_world *world, const cn_contact_event *event, void *user)
{
	listener *l = (listener *)user;
	cn_vec2 zero = { 0.0f, 0.0f };
	const cn_contact_event *events;
	int32_t count;
	l->unlocked += cn_body_set_velocity(world, event->body_a, zero.x, zero.y, 0.0f) != CN_ERROR_LOCKED;
	l->unlocked += cn_world_contact_events(world, CN_EVENT_ENTER, &events, &count) != CN_ERROR_LOCKED;
	l->unlocked += cn_world_step(world, 0.01f) != CN_ERROR_LOCKED;
	if (l->count < HEARD)
		l->events[l->count++] = *event;
}

static void callbacks_hear_what_arrays_say(void)
{
	static churn with, without;
	int32_t step, kind, differ = 0, heard = 0, unlocked = 0;
	churn_begin(&with, 21, ALL_EVENTS, 0);
	churn_begin(&without, 21, ALL_EVENTS, 0);
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		must(cn_world_set_contact_callback(with.world, kind, hear, &ears[kind]), with.world, "cn_world_set_contact_callback");
	for (step = 0; step < 120; ++step) {
		for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
			ears[kind].count = 0;
		churn_step(&with, step % 40 < 20 ? 6 : 0);
		churn_step(&without, step % 40 < 20 ? 6 : 0);
		for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
			const cn_contact_event *a, *b;
			int32_t count_a = events_of(with.world, kind, &a), count_b = events_of(without.world, kind, &b);
			heard += count_a;
			unlocked += ears[kind].unlocked;
			if (count_a != ears[kind].count || count_a != count_b ||
			    (count_a > 0 && (memcmp(a, ears[kind].events, sizeof *a * (size_t)count_a) || memcmp(a, b, sizeof *a * (size_t)count_a)))) {
				if (differ++ == 0)
					printf("  step %d kind %d: heard %d, array %d, array without callbacks %d\n", (int)step, (int)kind, (int)ears[kind].count, (int)count_a, (int)count_b);
			}
		}
	}
	CHECK_LE("lists that differ", differ, 0, "");
	CHECK_LE("calls that were not refused inside callbacks", unlocked, 0, "");
	CHECK_GE("events heard", heard, 2000, "");
	must(cn_world_set_contact_callback(with.world, CN_EVENT_STAY, NULL, NULL), with.world, "remove");
	ears[CN_EVENT_STAY].count = 0;
	fixture_step(with.world, 1);
	CHECK(ears[CN_EVENT_STAY].count == 0);
	cn_world_destroy(with.world);
	cn_world_destroy(without.world);
}

/* ---- masks ---- */

/* The kinds heard while a ball falls, rests, and is taken away. */
static uint32_t kinds_of_a_life(uint32_t mask_a, uint32_t mask_b)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body ground = fixture_floor(world, 0.5f, 0.0f), ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.5f, 0.5f, 0.0f);
	cn_vec2 away = { 0.0f, 50.0f };
	uint32_t kinds = 0;
	int32_t step, kind;
	set_mask(world, ground, mask_a);
	set_mask(world, ball, mask_b);
	for (step = 0; step < 60; ++step) {
		if (step == 50)
			must(cn_body_set_pose(world, ball, away.x, away.y, 0.0f), world, "cn_body_set_pose");
		fixture_step(world, 1);
		for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
			if (count_events(world, kind) > 0)
				kinds |= 1u << kind;
	}
	cn_world_destroy(world);
	return kinds;
}

static void a_pair_reports_what_either_asks_for(void)
{
	uint32_t a, b, wrong = 0;
	for (a = 0; a <= ALL_EVENTS; ++a)
		wrong += kinds_of_a_life(a, 0) != a || kinds_of_a_life(0, a) != a;
	for (a = 0; a < CN_EVENT_KINDS; ++a)
		for (b = 0; b < CN_EVENT_KINDS; ++b)
			wrong += kinds_of_a_life(1u << a, 1u << b) != (1u << a | 1u << b);
	CHECK_LE("masks that were not respected", wrong, 0, "");
}

/* ---- ends through calls ---- */

enum { END_DESTROY_BODY, END_DESTROY_SHAPE, END_DETACH, END_DISABLE, END_FILTER, END_TYPE, END_TELEPORT, END_JOINT, END_MANY, END_GROUND, END_WAYS };
static const char *const end_names[] = { "destroy body", "destroy shape", "detach", "disable", "filter", "type", "teleport", "joint", "destroy many", "destroy ground" };

static void end_by_call(cn_world *world, int32_t way, cn_body ground, cn_body box)
{
	cn_filter none = { 1, 0, 0, 0 };
	cn_vec2 away = { 0.0f, 50.0f };
	cn_distance_def def;
	cn_joint joint;
	cn_shape shape = first_shape(world, box);
	switch (way) {
	case END_DESTROY_BODY: must(cn_body_destroy(world, box), world, "destroy"); break;
	case END_DESTROY_SHAPE: must(cn_shape_destroy(world, shape), world, "destroy shape"); break;
	case END_DETACH: must(cn_shape_detach(world, shape), world, "detach"); break;
	case END_DISABLE: must(cn_body_set_flags(world, box, CN_BODY_SLEEP), world, "disable"); break;
	case END_FILTER: must(cn_shape_set_filter(world, shape, &none), world, "filter"); break;
	case END_TYPE: must(cn_body_set_type(world, box, CN_BODY_KINEMATIC), world, "type"); break;
	case END_TELEPORT: must(cn_body_set_pose(world, box, away.x, away.y, 0.0f), world, "teleport"); break;
	case END_JOINT:
		cn_distance_def_init(&def);
		def.base.body_a = ground;
		def.base.body_b = box;
		def.length_m = 1.5f;
		must(cn_joint_create_distance(world, &def, &joint), world, "joint");
		break;
	case END_MANY: must(cn_body_destroy_many(world, &box, 1), world, "destroy many"); break;
	default: must(cn_body_destroy(world, ground), world, "destroy ground");
	}
}

static void ends_between_steps_are_told_by_the_next_step(void)
{
	int32_t way, asleep;
	for (way = 0; way < END_WAYS; ++way)
		for (asleep = 0; asleep < 2; ++asleep) {
			cn_world *world = fixture_world(-10.0f, asleep);
			cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
			cn_shape ground_shape = first_shape(world, ground), box_shape = first_shape(world, box);
			const cn_contact_event *e;
			int32_t before;
			set_mask(world, box, ALL_EVENTS);
			fixture_step(world, 90);
			CHECK(fixture_is_awake(world, box) == !asleep);
			end_by_call(world, way, ground, box);
			before = count_events(world, CN_EVENT_LEAVE) + count_events(world, CN_EVENT_DESTROYED);
			fixture_step(world, 1);
			if (before != 0 || count_events(world, CN_EVENT_LEAVE) != 1 || count_events(world, CN_EVENT_DESTROYED) != 1 ||
			    count_events(world, CN_EVENT_STAY) + count_events(world, CN_EVENT_CREATED) != 0) {
				printf("  %s, asleep %d: before %d, leave %d, destroyed %d, stay %d, created %d\n", end_names[way], (int)asleep, (int)before, (int)count_events(world, CN_EVENT_LEAVE),
				       (int)count_events(world, CN_EVENT_DESTROYED), (int)count_events(world, CN_EVENT_STAY), (int)count_events(world, CN_EVENT_CREATED));
				CHECK(0);
			}
			if (events_of(world, CN_EVENT_LEAVE, &e) == 1)
				CHECK((e->shape_a == ground_shape && e->shape_b == box_shape && e->body_a == ground && e->body_b == box) ||
				      (e->shape_b == ground_shape && e->shape_a == box_shape && e->body_b == ground && e->body_a == box));
			CHECK(fixture_is_valid(world));
			fixture_step(world, 1);
			CHECK(count_events(world, CN_EVENT_LEAVE) + count_events(world, CN_EVENT_DESTROYED) == 0);
			cn_world_destroy(world);
		}
}

/* Calls that come after a step do not rewrite what it told. */
static void arrays_tell_of_the_last_step_only(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	(void)ground;
	set_mask(world, box, ALL_EVENTS);
	fixture_step(world, 120);
	CHECK(!fixture_is_awake(world, box));
	must(cn_body_set_awake(world, box, 1), world, "wake");
	CHECK_LE("events told of a pair that slept, after waking it by a call", count_all_events(world), 0, "");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_STAY) == 1);
	must(cn_body_set_awake(world, box, 0), world, "sleep");
	fixture_step(world, 1);
	CHECK(count_all_events(world) == 0);
	cn_world_destroy(world);
}

/* ---- sleep ---- */

static void sleeping_pairs_are_silent_and_go_on(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[3];
	const cn_contact_event *e;
	uint32_t ids[2];
	int32_t k, told = 0, stays = 0;
	bodies[0] = fixture_floor(world, 0.5f, 0.0f);
	bodies[1] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	bodies[2] = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	for (k = 0; k < 3; ++k)
		set_mask(world, bodies[k], ALL_EVENTS);
	fixture_step(world, 10);
	REQUIRE(events_of(world, CN_EVENT_STAY, &e) == 2);
	ids[0] = e[0].contact_id;
	ids[1] = e[1].contact_id;
	fixture_step(world, 110);
	REQUIRE(!fixture_is_awake(world, bodies[1]));
	for (k = 0; k < 60; ++k) {
		fixture_step(world, 1);
		told += count_all_events(world);
	}
	CHECK_LE("events of sleeping pairs in 60 steps", told, 0, "");
	must(cn_body_set_awake(world, bodies[2], 1), world, "wake");
	fixture_step(world, 1);
	CHECK(count_events(world, CN_EVENT_ENTER) + count_events(world, CN_EVENT_CREATED) + count_events(world, CN_EVENT_LEAVE) == 0);
	stays = events_of(world, CN_EVENT_STAY, &e);
	REQUIRE(stays == 2);
	CHECK((e[0].contact_id == ids[0] && e[1].contact_id == ids[1]) || (e[0].contact_id == ids[1] && e[1].contact_id == ids[0]));
	for (k = 0; k < 2; ++k) {
		int32_t on_ground = e[k].body_a == bodies[0] || e[k].body_b == bodies[0];
		double load = (on_ground ? 2.0 : 1.0) * 10.0 / 240.0; /* N s in a substep */
		double impulse = (double)e[k].manifold.points[0].normal_impulse_Ns + (double)e[k].manifold.points[1].normal_impulse_Ns;
		CHECK_LE("error of the impulse in the first step awake / load", fabs(impulse / load - 1.0), 0.02, "");
	}
	cn_world_destroy(world);
}

/* ---- truth ---- */

typedef struct truth {
	double normal_error;  /* | |n| - 1 | */
	int32_t backwards;    /* normals that do not point from a to b */
	int32_t outside;      /* points that are not between the two shapes */
	int32_t points, bad_counts;
} truth;

/* The surface point moved a little towards the shape's middle must be inside of the shape. */
static int32_t is_on(const cn_world *world, cn_shape shape, cn_vec2 p, float nudge)
{
	cn_aabb box;
	cn_vec2 d;
	float length;
	int32_t inside = 0;
	must(cn_shape_get_aabb(world, shape, &box), world, "cn_shape_get_aabb");
	d.x = 0.5f * (box.lower_m.x + box.upper_m.x) - p.x;
	d.y = 0.5f * (box.lower_m.y + box.upper_m.y) - p.y;
	length = (float)hypot((double)d.x, (double)d.y);
	nudge = length > nudge ? nudge / length : 1.0f;
	p.x += nudge * d.x;
	p.y += nudge * d.y;
	must(cn_shape_test_point(world, shape, p.x, p.y, &inside), world, "cn_shape_test_point");
	return inside;
}

/* What is allowed: 2 cm, and how far the surfaces turned in the step (points follow how bodies move, not how
   they turn in it). */
static float nudge_of(const cn_world *world, const cn_contact_event *e)
{
	float w = fabsf(fixture_velocity(world, e->body_a).angular_radps) + fabsf(fixture_velocity(world, e->body_b).angular_radps);
	return 0.02f + w * FRAME_S * 0.5f;
}

static void truth_of(truth *t, const cn_world *world, const cn_contact_event *e)
{
	const cn_manifold *m = &e->manifold;
	cn_aabb a, b;
	float along, nudge = nudge_of(world, e);
	int32_t k;
	must(cn_shape_get_aabb(world, e->shape_a, &a), world, "cn_shape_get_aabb");
	must(cn_shape_get_aabb(world, e->shape_b, &b), world, "cn_shape_get_aabb");
	along = m->normal.x * (b.lower_m.x + b.upper_m.x - a.lower_m.x - a.upper_m.x) + m->normal.y * (b.lower_m.y + b.upper_m.y - a.lower_m.y - a.upper_m.y);
	t->normal_error = fmax(t->normal_error, fabs(hypot((double)m->normal.x, (double)m->normal.y) - 1.0));
	t->backwards += along <= 0.0f;
	t->bad_counts += m->point_count < 1 || m->point_count > 2;
	for (k = 0; k < m->point_count; ++k) {
		float half = 0.5f * m->points[k].separation_m;
		cn_vec2 on_a = m->points[k].point_m, on_b = on_a;
		on_a.x -= half * m->normal.x;
		on_a.y -= half * m->normal.y;
		on_b.x += half * m->normal.x;
		on_b.y += half * m->normal.y;
		++t->points;
		t->outside += !is_on(world, e->shape_a, on_a, nudge) || !is_on(world, e->shape_b, on_b, nudge);
	}
}

static void manifolds_lie_between_their_shapes(void)
{
	static const float spins[] = { 0.0f, 2.0f };
	size_t s;
	for (s = 0; s < 2; ++s) {
		static churn c;
		truth enter = { 0.0, 0, 0, 0, 0 }, stay = { 0.0, 0, 0, 0, 0 };
		const cn_contact_event *e;
		int32_t step, kind, k, count;
		memset(&c, 0, sizeof c);
		c.world = fixture_world(-10.0f, 0);
		c.seed = 99;
		c.mask = ALL_EVENTS;
		for (k = 0; k < 3; ++k) {
			cn_shape_def def = fixture_shape_def(fixture_body(c.world, CN_BODY_STATIC, 11.0f * (float)(k - 1), k == 1 ? -5.0f : 5.0f, 0.0f), 0.5f, 0.0f);
			fixture_box_shape(c.world, &def, k == 1 ? 8.0f : 3.0f, k == 1 ? 5.0f : 8.0f);
		}
		for (k = 0; k < 150; ++k) {
			c.bodies[k] = fixture_body(c.world, CN_BODY_DYNAMIC, 1.2f * (float)(k % 10) - 5.4f, 0.8f + 1.1f * (float)(k / 10), churn_random(&c, -3.0f, 3.0f));
			churn_shape(&c, c.bodies[k]);
			fixture_set_velocity(c.world, c.bodies[k], 0.0f, -4.0f, spins[s] * churn_random(&c, -1.0f, 1.0f));
		}
		for (step = 0; step < 180; ++step) {
			fixture_step(c.world, 1);
			for (kind = CN_EVENT_ENTER; kind <= CN_EVENT_STAY; ++kind) {
				count = events_of(c.world, kind, &e);
				for (k = 0; k < count; ++k)
					truth_of(kind == CN_EVENT_ENTER ? &enter : &stay, c.world, &e[k]);
			}
		}
		printf("  spin %.0f rad/s: %d points at enter, %d at stay\n", (double)spins[s], (int)enter.points, (int)stay.points);
		CHECK_LE("length of normals - 1", fmax(enter.normal_error, stay.normal_error), 1e-5, "");
		CHECK_LE("manifolds without points, or with too many", enter.bad_counts + stay.bad_counts, 0, "");
		CHECK_LE("normals that point from b to a", enter.backwards + stay.backwards, 0, "");
		CHECK_LE("share of points at enter that are not between the shapes", (double)enter.outside / (double)enter.points, 0.01, "");
		CHECK_LE("share of points at stay that are not between the shapes", (double)stay.outside / (double)stay.points, 0.002, "");
		CHECK_GE("points at stay", stay.points, 10000, "");
		cn_world_destroy(c.world);
	}
}

/* As of the end of the step, says the header: also for what moves fast. */
static void separation_is_that_at_the_end_of_the_step(void)
{
	static const float speeds[] = { 0.5f, 5.0f, 20.0f };
	size_t s;
	for (s = 0; s < 3; ++s) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body ground = fixture_floor(world, 0.5f, 0.0f), ball;
		const cn_contact_event *e;
		double worst = 0.0, worst_point = 0.0;
		int32_t k, seen = 0;
		(void)ground;
		ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.3f, 1.0f, 0.5f, 0.5f, 0.7f);
		set_mask(world, ball, ALL_EVENTS);
		fixture_set_velocity(world, ball, 0.0f, -speeds[s], 0.0f);
		for (k = 0; k < 120; ++k) {
			int32_t kind;
			fixture_step(world, 1);
			for (kind = CN_EVENT_ENTER; kind <= CN_EVENT_STAY; ++kind)
				if (events_of(world, kind, &e) == 1) {
					double gap = (double)fixture_pose(world, ball).position_m.y - 0.5;
					worst = fmax(worst, fabs((double)e->manifold.points[0].separation_m - gap));
					worst_point = fmax(worst_point, fabs((double)e->manifold.points[0].point_m.y - 0.5 * gap));
					++seen;
				}
		}
		printf("  %.1f m/s\n", (double)speeds[s]);
		CHECK(seen > 0);
		CHECK_LE("separation - gap at the end of the step", worst, 1e-5, "m");
		CHECK_LE("height of the point - half the gap", worst_point, 1e-5, "m");
		cn_world_destroy(world);
	}
}

static void approach_speed_is_that_of_the_fall(void)
{
	static const float heights[] = { 0.2f, 1.0f, 5.0f, 20.0f };
	size_t i;
	int32_t flip;
	for (i = 0; i < 4; ++i)
		for (flip = 0; flip < 2; ++flip) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body ball;
			const cn_contact_event *e;
			double v = sqrt(2.0 * 10.0 * (double)heights[i]), told = -1.0, other = 0.0;
			int32_t k;
			if (flip) /* circle a, box b */
				fixture_floor(world, 0.5f, 0.0f);
			else /* circle against circle */
				fixture_circle(world, CN_BODY_STATIC, 0.0f, -50.0f, 50.0f, 0.5f, 0.0f);
			ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.5f + heights[i], 0.5f, 0.5f, 0.0f);
			set_mask(world, ball, ALL_EVENTS);
			for (k = 0; k < 180; ++k) {
				int32_t kind;
				fixture_step(world, 1);
				for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
					if (events_of(world, kind, &e) > 0) {
						if (kind == CN_EVENT_ENTER && told < 0.0)
							told = (double)e->approach_speed_mps;
						else if (kind != CN_EVENT_ENTER)
							other = fmax(other, fabs((double)e->approach_speed_mps));
					}
			}
			printf("  from %.1f m: %.3f m/s, exact %.3f\n", (double)heights[i], told, v);
			CHECK_LE("approach speed - speed of the fall", fabs(told - v), 10.0 / 60.0 + 1e-3, "m/s"); /* what a step adds */
			CHECK_LE("approach speed of other kinds", other, 0.0, "m/s");
			cn_world_destroy(world);
		}
}

/* ---- masks that change ---- */

static void a_mask_takes_effect_on_present_contacts(void)
{
	int32_t asleep;
	for (asleep = 0; asleep < 2; ++asleep) {
		cn_world *world = fixture_world(-10.0f, asleep);
		cn_body ground = fixture_floor(world, 0.5f, 0.0f), box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
		set_mask(world, ground, 0);
		set_mask(world, box, 0);
		fixture_step(world, 90);
		set_mask(world, box, ALL_EVENTS); /* opens what is there */
		if (asleep) {
			fixture_step(world, 1);
			CHECK(count_all_events(world) == 0);
			must(cn_body_set_awake(world, box, 1), world, "wake");
		}
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_CREATED) == 1 && count_events(world, CN_EVENT_ENTER) == 1 && count_events(world, CN_EVENT_STAY) == 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_STAY) == 1 && count_all_events(world) == 1);
		set_mask(world, box, 1u << CN_EVENT_STAY); /* closes it */
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_LEAVE) == 1 && count_events(world, CN_EVENT_DESTROYED) == 1 && count_events(world, CN_EVENT_STAY) == 1);
		set_mask(world, ground, TOUCH_EVENTS); /* the other shape asks */
		set_mask(world, box, 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_ENTER) == 1 && count_all_events(world) == 1);
		set_mask(world, box, TOUCH_EVENTS); /* both ask: nothing new */
		set_mask(world, ground, 0);
		fixture_step(world, 1);
		CHECK(count_all_events(world) == 0);
		set_mask(world, box, 0); /* closed and opened between two steps */
		set_mask(world, box, TOUCH_EVENTS);
		set_mask(world, box, 0);
		fixture_step(world, 1);
		CHECK(count_events(world, CN_EVENT_LEAVE) == 1 && count_all_events(world) == 1);
		must(cn_body_destroy(world, box), world, "destroy");
		fixture_step(world, 1);
		CHECK(count_all_events(world) == 0);
		cn_world_destroy(world);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_beginning_gets_its_end);
	RUN(changing_masks_keep_pairs_bookended);
	RUN(equal_histories_tell_equal_events);
	RUN(callbacks_hear_what_arrays_say);
	RUN(a_pair_reports_what_either_asks_for);
	RUN(ends_between_steps_are_told_by_the_next_step);
	RUN(arrays_tell_of_the_last_step_only);
	RUN(sleeping_pairs_are_silent_and_go_on);
	RUN(manifolds_lie_between_their_shapes);
	RUN(separation_is_that_at_the_end_of_the_step);
	RUN(approach_speed_is_that_of_the_fall);
	RUN(a_mask_takes_effect_on_present_contacts);
	return test_end();
}
