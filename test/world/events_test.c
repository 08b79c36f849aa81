/*
 * test/world/events_test.c - contact events in worlds where everything happens: bookended, deterministic, and told alike
 * by arrays and callbacks.
 *
 * The churn tests do to a world everything that can begin or end a contact, in random order, and keep a ledger
 * of what the events say; after every step the ledger must equal what the world holds.
 *
 * If a test here fails, run world/events_pair first, then look in: model/contact.c (begin, end, destroy), model/event.c
 * (logs), narrowphase/narrowphase.c (changes), step/event_callbacks.c (callbacks).
 */
#include "events.h"

/* ---- the ledger ---- */

#define LEDGER 16384

typedef struct entry {
	int32_t created, entered, entered_now;
	int32_t owes;           /* steps for which what it told has not been what its mask asks for */
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
	case CN_EVENT_HIT:
		if (!p->entered)
			complain(l, "hit without enter", e);
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
	static const int32_t order[] = { CN_EVENT_LEAVE, CN_EVENT_DESTROYED, CN_EVENT_CREATED, CN_EVENT_ENTER, CN_EVENT_STAY, CN_EVENT_HIT };
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

/* ---- churn tests ---- */

static void every_beginning_gets_its_end(void)
{
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(4); ++seed) {
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

/* A touching pair sleeps with a dynamic body of it, others with both bodies. */
static int32_t pair_is_awake(const cn_world *world, const cn_contact_event *e)
{
	int32_t type[2], awake[2], side;
	for (side = 0; side < 2; ++side) {
		cn_body body = side == 0 ? e->body_a : e->body_b;
		must(cn_body_get_type(world, body, &type[side]), world, "cn_body_get_type");
		awake[side] = fixture_is_awake(world, body);
	}
	if (e->kind != CN_EVENT_STAY)
		return awake[0] || awake[1];
	return (awake[0] || type[0] != CN_BODY_DYNAMIC) && (awake[1] || type[1] != CN_BODY_DYNAMIC);
}

/* A sleeping pair may owe its beginning until the first step in which it is awake from the start. */
static int32_t pair_is_off(const cn_world *world, entry *p, const cn_contact_event *e)
{
	int32_t mask = mask_of_pair(world, e), off;
	off = p->created != ((mask & BOX_EVENTS) == BOX_EVENTS) || p->entered != ((mask & TOUCH_EVENTS) == TOUCH_EVENTS && e->kind == CN_EVENT_STAY);
	p->owes = off && pair_is_awake(world, e) ? p->owes + 1 : 0;
	return p->owes > 1;
}

static int32_t pair_forgives(const cn_world *world, entry *p, const cn_contact_event *e)
{
	if (!pair_is_awake(world, e))
		p->owes = 0;
	return 0;
}

/* The sum of what look returns over the pairs that the world holds; counts those that the ledger has as created and as entered. */
static int32_t pairs_visit(const churn *c, ledger *l, int32_t (*look)(const cn_world *, entry *, const cn_contact_event *), int32_t *created, int32_t *entered)
{
	int32_t k, i, count, body_count, sum = 0;
	static cn_contact_event e[512];
	cn_body bodies[CHURN_BODIES + 2];
	*created = *entered = 0;
	must(cn_world_get_bodies(c->world, bodies, CHURN_BODIES + 2, &body_count), c->world, "cn_world_get_bodies");
	for (k = 0; k < body_count; ++k) {
		must(cn_body_get_contacts(c->world, bodies[k], e, 512, &count), c->world, "cn_body_get_contacts");
		for (i = 0; i < count && i < 512; ++i) {
			entry *p = &l->pairs[e[i].contact_id];
			if (e[i].body_a != bodies[k])
				continue;
			*created += p->created;
			*entered += p->entered;
			sum += look(c->world, p, &e[i]);
		}
	}
	return sum;
}

static int32_t pairs_off(const churn *c, ledger *l)
{
	int32_t created, entered, off = pairs_visit(c, l, pair_is_off, &created, &entered);
	return off + (created != l->created) + (entered != l->entered);
}

/* With seed 584 a pair that owes wakes in two steps, and is put to sleep between them. */
static void masks_change(uint32_t seed)
{
	static churn c;
	int32_t step, off = 0, created, entered;
	uint64_t stream = 0;
	memset(&book, 0, sizeof book);
	book.masks_change = 1;
	churn_begin(&c, seed + 100, 0, 1);
	for (step = 0; step < 150; ++step) {
		churn_calls(&c, step % 50 < 40 ? 10 : 0);
		pairs_visit(&c, &book, pair_forgives, &created, &entered);
		fixture_step(c.world, 1);
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

static void changing_masks_keep_pairs_bookended(void)
{
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(10); ++seed)
		masks_change(seed);
	masks_change(584);
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

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_beginning_gets_its_end);
	RUN(changing_masks_keep_pairs_bookended);
	RUN(equal_histories_tell_equal_events);
	RUN(callbacks_hear_what_arrays_say);
	return test_end();
}
