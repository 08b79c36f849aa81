/*
 * test/narrowphase/cull_test.c - what the narrowphase passes by (narrowphase/cull.c) against what it would find.
 *
 * A crowd of boxes and circles flies about, at the origin or far from it. After each step its contacts are culled in three
 * ways: all at once (from the copy of the bodies, four side by side where there are vectors), in ranges of three (from the
 * copy, one by one), and as lists of a few (from the bodies' records, one by one). All must tell the same: what is passed by
 * must not come within the contact margin (by the time of impact of the two shapes) and have overlapping boxes, all else must come out in order, and the same bodies must be marked as having
 * static ones about them. Contacts with something to tell must come out. In a heap that comes to rest on hills, the second look of
 * the second look is compared with the time of impact as well. If something is passed by that touches, look at the
 * margins in circles_apart.
 */
#include "model/world.h"
#include "narrowphase/cull.h"
#include "collision/toi.h"
#include "world/fixture.h"

#define SIDE 50
#define CONTACTS_MOST 65536
#define A_FEW 1000
#define HILLS 48

/* One way to cull. */
typedef struct way {
	int32_t list, range, at_a_time;  /* contacts of a list, of a range of it, that are asked for */
	int32_t found[CONTACTS_MOST];    /* indices of what came out, in order */
	int32_t count, copies;           /* lists that had a copy of the bodies */
	uint8_t marked[SIDE * SIDE + 4]; /* bodies, by record */
} way;

static way all_at_once, by_threes, few_at_a_time;
static uint32_t flags_before[CONTACTS_MOST];

/* In a box of 24 m; some of the circles stand still. */
static cn_world *crowd(float x)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint32_t seed = 7;
	int32_t k;
	for (k = 0; k < 4; ++k)
		fixture_box(world, CN_BODY_STATIC, x + (k == 1 ? -2.0f : k == 3 ? 26.0f : 12.0f), k == 0 ? -2.0f : k == 2 ? 26.0f : 12.0f, k % 2 ? 1.570796f : 0.0f, 15.0f,
		            1.0f, 0.5f, 0.3f);
	for (k = 0; k < SIDE * SIDE; ++k) {
		float at_x = x + 0.48f * (float)(k % SIDE), at_y = 0.48f * (float)(k / SIDE), size = fixture_random(&seed, 0.1f, 0.25f);
		float vx = fixture_random(&seed, -20.0f, 20.0f), vy = fixture_random(&seed, -20.0f, 20.0f), w = fixture_random(&seed, -20.0f, 20.0f);
		int32_t type = k % 64 == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
		cn_body body = k % 2 == 0 ? fixture_circle(world, type, at_x, at_y, size, 0.5f, 0.3f)
		                          : fixture_box(world, CN_BODY_DYNAMIC, at_x, at_y, 0.1f * w, size, 0.2f, 0.5f, 0.3f);
		if (type == CN_BODY_DYNAMIC)
			fixture_set_velocity(world, body, vx, vy, w);
	}
	return world;
}

/* Sifts part of the apart list. */
static void cull_part(cn_world *world, int32_t first, int32_t count, way *w)
{
	cni_touch_pair pairs[CNI_CULL_BATCH];
	int32_t more, k, begin;
	cni_cull_list list;
	cni_cull s;
	cni_cull_open(&list, world, (const int32_t *)world->apart.data + first, count, count, FRAME_S);
	w->copies += list.bodies != NULL;
	for (begin = 0; begin < count; begin += w->range) {
		cni_cull_begin(&s, &list, begin, cni_min_i(count, begin + w->range));
		while ((more = cni_cull_next(&s, pairs, w->at_a_time)) > 0)
			for (k = 0; k < more; ++k)
				w->found[w->count++] = pairs[k].index;
	}
	cni_cull_close(&list);
}

static void cull(cn_world *world, way *w)
{
	int32_t k;
	w->count = 0;
	for (k = 0; k < world->body_handles.slots.count; ++k)
		cni_body_at(world, k)->flags &= ~(uint32_t)CNI_BODY_AT_STATIC;
	for (k = 0; k < world->apart.count; k += w->list)
		cull_part(world, k, cni_min_i(w->list, world->apart.count - k), w);
	for (k = 0; k < world->body_handles.slots.count; ++k)
		w->marked[k] = (cni_body_at(world, k)->flags & CNI_BODY_AT_STATIC) != 0;
}

static int32_t ways_differ(const way *a, const way *b)
{
	return a->count != b->count || memcmp(a->found, b->found, sizeof a->found[0] * (size_t)a->count) != 0 || memcmp(a->marked, b->marked, sizeof a->marked) != 0;
}

static void way_init(way *w, int32_t list, int32_t range, int32_t at_a_time)
{
	memset(w, 0, sizeof *w);
	w->list = list;
	w->range = range;
	w->at_a_time = at_a_time;
}

/* Every fifth contact has something to tell, every eleventh one entered. */
static void flags_set(cn_world *world)
{
	static const uint32_t tells[3] = { CNI_CONTACT_SENSING, CNI_CONTACT_PASSING, CNI_CONTACT_CREATED_OWED };
	const int32_t *apart = (const int32_t *)world->apart.data;
	int32_t k;
	for (k = 0; k < world->apart.count; ++k)
		cni_contact_at(world, apart[k])->flags = flags_before[k] | (k % 5 == 0 ? tells[k / 5 % 3] : 0u) | (k % 11 == 0 ? (uint32_t)CNI_CONTACT_ENTERED : 0u);
}

/* Contacts that have something to tell and were passed by, and those that enter still. */
static int32_t flags_ignored(cn_world *world, const way *w)
{
	const int32_t *apart = (const int32_t *)world->apart.data;
	int32_t k, at = 0, ignored = 0;
	for (k = 0; k < world->apart.count; ++k) {
		int32_t found = at < w->count && w->found[at] == apart[k];
		at += found;
		ignored += (k % 5 == 0 && !found) || (cni_contact_at(world, apart[k])->flags & CNI_CONTACT_ENTERED) != 0;
	}
	return ignored;
}

/* Leaves the flags as they were. */
static int32_t flags_wrong(cn_world *world)
{
	const int32_t *apart = (const int32_t *)world->apart.data;
	way *ways[3] = { &all_at_once, &by_threes, &few_at_a_time };
	int32_t k, wrong = 0;
	for (k = 0; k < world->apart.count; ++k)
		flags_before[k] = cni_contact_at(world, apart[k])->flags;
	for (k = 0; k < 3; ++k) {
		flags_set(world);
		cull(world, ways[k]);
		wrong += flags_ignored(world, ways[k]) + ways_differ(ways[k], ways[0]);
	}
	for (k = 0; k < world->apart.count; ++k)
		cni_contact_at(world, apart[k])->flags = flags_before[k];
	return wrong;
}

static cni_path path_of(const cni_body *b, const cni_body *from)
{
	cni_path p;
	p.start = cni_v((b->cx - from->cx) + (b->cx_low - from->cx_low), (b->cy - from->cy) + (b->cy_low - from->cy_low));
	p.end = cni_v(p.start.x + FRAME_S * b->vx, p.start.y + FRAME_S * b->vy);
	p.q = b->q;
	p.turn = FRAME_S * b->w;
	p.local_center = b->local_center;
	return p;
}

/* Do the shapes come within the contact margin, less a tenth, while the bodies move through the step? */
static int32_t come_near(cn_world *world, int32_t contact, int32_t *boxes_overlap)
{
	cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
	cni_toi_input in;
	*boxes_overlap = cni_aabb_overlap(&pair.proxy[0]->fat, &pair.proxy[1]->fat);
	in.a = cni_proxy_geometry(&world->blocks, pair.proxy[0]);
	in.b = cni_proxy_geometry(&world->blocks, pair.proxy[1]);
	in.child_a = cni_proxy_child(pair.proxy[0]);
	in.child_b = cni_proxy_child(pair.proxy[1]);
	in.path_a = path_of(pair.body[0], pair.body[0]);
	in.path_b = path_of(pair.body[1], pair.body[0]);
	in.target = 0.9f * world->settings.contact_margin;
	in.tolerance = 0.05f * world->settings.contact_margin;
	return cni_toi(&in).state != CNI_TOI_SEPARATED;
}

/* Contacts that were passed by and should not have been, or that came out in another order. */
static int32_t wrongly_passed(cn_world *world, const int32_t *found, int32_t count, int32_t *passed)
{
	const int32_t *apart = (const int32_t *)world->apart.data;
	int32_t k, at = 0, wrong = 0, overlap;
	for (k = 0; k < world->apart.count; ++k) {
		if (at < count && found[at] == apart[k]) {
			++at;
			continue;
		}
		++*passed;
		wrong += come_near(world, apart[k], &overlap) || !overlap;
	}
	return wrong + (at != count);
}

static void crowd_is_sifted(float x)
{
	cn_world *world = crowd(x);
	int32_t step, k, wrong = 0, passed = 0, total = 0, differ = 0, ignored = 0, marked = 0;
	way_init(&all_at_once, CONTACTS_MOST, CONTACTS_MOST, CNI_CULL_BATCH);
	way_init(&by_threes, CONTACTS_MOST, 3, 2);
	way_init(&few_at_a_time, A_FEW, A_FEW, 5);
	for (step = 0; step < 40; ++step) {
		fixture_step(world, 1);
		REQUIRE(world->apart.count < CONTACTS_MOST && world->body_handles.slots.count <= SIDE * SIDE + 4);
		cull(world, &all_at_once);
		cull(world, &by_threes);
		cull(world, &few_at_a_time);
		differ += ways_differ(&all_at_once, &by_threes) || ways_differ(&all_at_once, &few_at_a_time);
		total += world->apart.count;
		wrong += wrongly_passed(world, all_at_once.found, all_at_once.count, &passed);
		for (k = 0; k < SIDE * SIDE + 4; ++k)
			marked += all_at_once.marked[k];
		ignored += flags_wrong(world);
	}
	printf("  %d contacts apart in a step, of which %d are passed by; %d bodies near static ones\n", total / 40, passed / 40, marked / 40);
	CHECK_LE("contacts passed by that come near", wrong, 0, "");
	CHECK_LE("steps in which two ways tell otherwise", differ, 0, "");
	CHECK_LE("contacts whose flags are not heeded", ignored, 0, "");
	CHECK_GE("lists culled from a copy", all_at_once.copies, 40, "");
	CHECK_LE("... of a few", few_at_a_time.copies, 0, "");
	CHECK_GE("part of those apart that are passed by", (double)passed / (double)total, 0.3, "");
	CHECK_GE("bodies near static ones", (double)marked / 40.0, 10.0, "");
	cn_world_destroy(world);
}

static void nothing_that_touches_is_passed_by(void)
{
	crowd_is_sifted(0.0f);
}

static void nothing_is_passed_by_far_from_the_origin(void)
{
	crowd_is_sifted(100000.0f);
}

static void hills(cn_world *world, float x)
{
	cn_vec2 points[HILLS];
	cn_body ground = fixture_body(world, CN_BODY_STATIC, x, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(ground, 0.5f, 0.0f);
	cn_chain chain = { 0 };
	int32_t k;
	for (k = 0; k < HILLS; ++k) {
		points[k].x = 30.0f - 1.5f * (float)k;
		points[k].y = k % 3 == 0 ? 0.4f : 0.0f;
	}
	chain.points_m = points;
	chain.count = HILLS;
	REQUIRE(cn_shape_create_chain(world, &def, &chain, NULL) == CN_OK);
}

static void capsule_add(cn_world *world, float x, float y, float size)
{
	cn_capsule capsule = { { -size, 0.0f }, { size, 0.1f }, 0.1f };
	cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, x, y, 7.0f * size), 0.5f, 0.0f);
	REQUIRE(cn_shape_create_capsule(world, &def, &capsule, NULL) == CN_OK);
}

/* Boxes, capsules and circles come to rest on hills: most of those that are near each other stay apart. */
static cn_world *heap(float x)
{
	cn_world *world = fixture_world(-10.0f, 1);
	uint32_t seed = 5;
	int32_t k;
	hills(world, x);
	for (k = 0; k < 400; ++k) {
		float at_x = x - 12.0f + 1.2f * (float)(k % 20), at_y = 1.5f + 0.8f * (float)(k / 20), size = fixture_random(&seed, 0.1f, 0.3f);
		if (k % 3 == 0) {
			fixture_circle(world, CN_BODY_DYNAMIC, at_x, at_y, size, 0.5f, 0.0f);
		} else if (k % 3 == 1) {
			fixture_box(world, CN_BODY_DYNAMIC, at_x, at_y, 9.0f * size, size, 0.2f, 0.5f, 0.0f);
		} else {
			capsule_add(world, at_x, at_y, size);
		}
	}
	return world;
}

static void pairs_that_stay_apart_do_not_meet(float x, double part_least)
{
	cn_world *world = heap(x);
	int32_t step, k, total = 0, passed = 0, wrong = 0, overlap;
	for (step = 0; step < 120; ++step) {
		fixture_step(world, 1);
		for (k = 0; k < world->apart.count; ++k) {
			int32_t contact = ((const int32_t *)world->apart.data)[k];
			cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
			++total;
			if (!cni_pair_stays_apart(world, &pair, FRAME_S))
				continue;
			++passed;
			wrong += come_near(world, contact, &overlap) || !overlap;
		}
	}
	CHECK_LE("pairs said to stay apart that come near", wrong, 0, "");
	CHECK_GE("part of those apart that are said to stay so", (double)passed / (double)total, part_least, "");
	cn_world_destroy(world);
}

static void faces_and_circles_stay_apart(void)
{
	pairs_that_stay_apart_do_not_meet(0.0f, 0.35);
	pairs_that_stay_apart_do_not_meet(50000.0f, 0.35);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(faces_and_circles_stay_apart);
	RUN(nothing_that_touches_is_passed_by);
	RUN(nothing_is_passed_by_far_from_the_origin);
	return test_end();
}
