/*
 * test/stages/narrowphase_sift_test.c - what the narrowphase passes by (stages/narrowphase_sift.c) against what it would find.
 *
 * A crowd of boxes and circles flies about, at the origin or far from it. After each step its contacts are sifted, all at once
 * (from the copy of the bodies) and a few at a time (from their records): what is passed by must have no manifold and
 * overlapping boxes, and all else must come out in order. If something is passed by that touches, look at the margins in
 * circles_apart.
 */
#include "model/world.h"
#include "stages/narrowphase_sift.h"
#include "world/fixture.h"

#define SIDE 50
#define CONTACTS_MOST 65536
#define A_FEW 1000

static int32_t kept[CONTACTS_MOST], kept_of_few[CONTACTS_MOST];

/* In a box of 24 m. */
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
		cn_body body = k % 2 == 0 ? fixture_circle(world, CN_BODY_DYNAMIC, at_x, at_y, size, 0.5f, 0.3f)
		                          : fixture_box(world, CN_BODY_DYNAMIC, at_x, at_y, 0.1f * w, size, 0.2f, 0.5f, 0.3f);
		fixture_set_velocity(world, body, vx, vy, w);
	}
	return world;
}

/* Sifts part of the apart list; returns how many come out, their indices in order. with_copy: whether there was one. */
static int32_t sift(cn_world *world, int32_t first, int32_t count, int32_t *out, int32_t *with_copy)
{
	cni_touch_pair pairs[CNI_SIFT_BATCH];
	int32_t more, k, found = 0;
	cni_sift_list list;
	cni_sift s;
	cni_sift_open(&list, world, (const int32_t *)world->apart.data + first, count, count, FRAME_S);
	*with_copy = list.bodies != NULL;
	cni_sift_begin(&s, &list, 0, count);
	while ((more = cni_sift_batch(&s, pairs)) != CNI_NONE)
		for (k = 0; k < more; ++k)
			out[found++] = pairs[k].index;
	cni_sift_close(&list);
	return found;
}

static int32_t manifold_points(cn_world *world, int32_t contact, int32_t *boxes_overlap)
{
	cni_touch_pair pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
	cni_contact c = *pair.contact; /* colliding leaves hints */
	cni_touch touch;
	int32_t near;
	pair.contact = &c;
	near = cni_touch_begin(world, &pair, FRAME_S, &touch);
	*boxes_overlap = touch.boxes_overlap;
	if (!near)
		return 0;
	cni_touch_collide(&touch);
	cni_touch_finish(world, FRAME_S, &touch);
	return touch.manifold.count;
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
		wrong += manifold_points(world, apart[k], &overlap) != 0 || !overlap;
	}
	return wrong + (at != count);
}

static void crowd_is_sifted(float x)
{
	cn_world *world = crowd(x);
	int32_t step, k, copies = 0, copies_of_few = 0, wrong = 0, passed = 0, total = 0, differ = 0;
	for (step = 0; step < 40; ++step) {
		int32_t found, few = 0, copy;
		fixture_step(world, 1);
		REQUIRE(world->apart.count < CONTACTS_MOST);
		found = sift(world, 0, world->apart.count, kept, &copy);
		copies += copy;
		for (k = 0; k < world->apart.count; k += A_FEW) {
			few += sift(world, k, world->apart.count - k < A_FEW ? world->apart.count - k : A_FEW, kept_of_few + few, &copy);
			copies_of_few += copy;
		}
		differ += few != found;
		for (k = 0; k < found && k < few; ++k)
			differ += kept[k] != kept_of_few[k];
		total += world->apart.count;
		wrong += wrongly_passed(world, kept, found, &passed);
	}
	printf("  %d contacts apart in a step, of which %d are passed by\n", total / 40, passed / 40);
	CHECK_LE("contacts passed by that would have changed", wrong, 0, "");
	CHECK_LE("contacts told otherwise from the copy of the bodies", differ, 0, "");
	CHECK_GE("steps sifted from a copy", copies, 20, "");
	CHECK_LE("... when there were few contacts", copies_of_few, 0, "");
	CHECK_GE("part of those apart that are passed by", (double)passed / (double)total, 0.3, "");
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

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(nothing_that_touches_is_passed_by);
	RUN(nothing_is_passed_by_far_from_the_origin);
	return test_end();
}
