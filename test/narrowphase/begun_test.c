/*
 * test/narrowphase/begun_test.c - manifolds kept for contacts that begin to touch (narrowphase/begun.c).
 *
 * A store takes manifolds of contacts in the order of their list, and gives them back in this order: three of each group of old
 * contacts, all of the groups of new ones, none beyond its room. If this fails, contacts begin with manifolds of others.
 */
#include "model/world.h"
#include "narrowphase/touch.h"
#include "world/fixture.h"

#define CONTACTS 1000
#define KEPT_OF_AN_OLD_GROUP 32
#define KEPT_WHERE_MANY_ARE_NEW 12

/* Offers every `every`th contact, marked by its place, and takes back what was kept. */
static void round_trip(int32_t created, int32_t every, int32_t *kept, int32_t *kept_of_new, int32_t *wrong)
{
	cn_world *world = fixture_world(-10.0f, 1);
	static int32_t places[CONTACTS];
	cni_contact contact;
	cni_begun_store store;
	cni_touch touch;
	int32_t k;
	memset(&contact, 0, sizeof contact);
	memset(&touch, 0, sizeof touch);
	touch.contact = &contact;
	*kept = *kept_of_new = *wrong = 0;
	cni_begun_open(&store, world, CONTACTS, created);
	for (k = 0; k < CONTACTS; k += every) {
		contact.slot = k;
		touch.result.manifold.normal.x = touch.result.gap.y = touch.result.radius[1] = (float)k;
		if (!cni_begun_keep(&store, &touch))
			continue;
		places[(*kept)++] = k;
		*kept_of_new += k >= CONTACTS - created;
	}
	for (k = 0; k < *kept; ++k) {
		const cni_touch_result *b = cni_begun_take(&store);
		float place = (float)places[k];
		*wrong += b->manifold.normal.x != place || b->gap.y != place || b->radius[1] != place;
	}
	cni_begun_close(&store, world);
	cn_world_destroy(world);
}

static void manifolds_come_back_in_order(void)
{
	int32_t kept, kept_of_new, wrong, groups = CONTACTS / CNI_BEGUN_GROUP + 1, of_old = KEPT_OF_AN_OLD_GROUP * groups;
	round_trip(0, 1, &kept, &kept_of_new, &wrong);
	CHECK_LE("old contacts: wrong manifolds", wrong, 0, "");
	CHECK(kept == of_old);
	round_trip(200, 1, &kept, &kept_of_new, &wrong);
	CHECK_LE("200 of 1,000 are new: wrong manifolds", wrong, 0, "");
	CHECK_GE("... kept of the new ones", kept_of_new, 200, "");
	CHECK_LE("... kept in all", kept, of_old + 200 + CNI_BEGUN_GROUP, "");
	round_trip(200, 50, &kept, &kept_of_new, &wrong);
	CHECK_LE("few of them begin: wrong manifolds", wrong, 0, "");
	CHECK(kept == CONTACTS / 50);
	round_trip(CONTACTS, 1, &kept, &kept_of_new, &wrong);
	CHECK_LE("all are new: wrong manifolds", wrong, 0, "");
	CHECK(kept == KEPT_WHERE_MANY_ARE_NEW * groups);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(manifolds_come_back_in_order);
	return test_end();
}
