/*
 * test/model/contact_order_test.c - contacts with static bodies lead a body's list (model/contact.c), where continuous collision looks
 * for them. A body that has had many is CNI_BODY_MIXED: its whole list is searched. cn_world_validate checks the rule; here it is
 * checked that bodies of both kinds occur and that fast ones stay in front of the ground, also in a world from a file of an earlier
 * version, which has no flags of static contacts.
 */
#include "model/world.h"
#include "world/fixture.h"

#include <string.h>

#define TILES 40
#define BALLS 24

static cn_world *heap_on_tiles(cn_body *bar)
{
	cn_world *world = fixture_world(-10.0f, 0);
	int32_t k;
	for (k = 0; k < TILES; ++k)
		fixture_box(world, CN_BODY_STATIC, 0.25f * (float)(k - TILES / 2), -0.05f, 0.0f, 0.125f, 0.05f, 0.5f, 0.0f);
	for (k = 0; k < BALLS; ++k)
		fixture_circle(world, CN_BODY_DYNAMIC, -3.5f + 0.2f * (float)(k % 8), 0.11f + 0.2f * (float)(k / 8), 0.1f, 0.5f, 0.0f);
	*bar = fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 0.1f, 0.0f, 2.0f, 0.1f, 0.5f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 1.5f, 0.31f, 0.0f, 0.1f, 0.1f, 0.5f, 0.0f);
	fixture_step(world, 30);
	return world;
}

static int32_t bodies_with(const cn_world *world, uint32_t flag)
{
	int32_t k, count = 0;
	for (k = 0; k < world->body_handles.slots.count; ++k)
		count += cni_body_at(world, k)->type == CN_BODY_DYNAMIC && (cni_body_at(world, k)->flags & flag) != 0;
	return count;
}

/* Everything is thrown at the ground by turns; counts what comes to lie below it. */
static int32_t bodies_thrown_through(cn_world *world)
{
	int32_t k, turn, below = 0;
	for (turn = 0; turn < 10; ++turn) {
		for (k = 0; k < world->body_handles.slots.count; ++k)
			if (cni_body_at(world, k)->type == CN_BODY_DYNAMIC)
				fixture_set_velocity(world, cni_handles_of(&world->body_handles, k), 0.0f, turn % 2 == 0 ? 3.0f : -60.0f, 0.0f);
		fixture_step(world, 4);
	}
	for (k = 0; k < world->body_handles.slots.count; ++k)
		below += cni_body_at(world, k)->type == CN_BODY_DYNAMIC && cni_body_at(world, k)->cy < 0.0f;
	return below;
}

static void static_contacts_lead(void)
{
	cn_body bar;
	cn_world *world = heap_on_tiles(&bar);
	CHECK(fixture_is_valid(world));
	CHECK(cni_body_at(world, cni_handles_find(&world->body_handles, bar))->flags & CNI_BODY_MIXED);
	CHECK_LE("bodies with many static contacts", bodies_with(world, CNI_BODY_MIXED), 1, "");
	CHECK_LE("bodies thrown through the ground", bodies_thrown_through(world), 0, "");
	cn_world_destroy(world);
}

static void files_of_earlier_versions_have_no_order(void)
{
	cn_body bar;
	cn_world *world = heap_on_tiles(&bar), *read = NULL;
	uint64_t bytes = 0;
	void *file;
	int32_t k;
	for (k = 0; k < world->contact_used; ++k)
		cni_contact_at(world, k)->flags &= ~(uint32_t)CNI_CONTACT_STATIC;
	for (k = 0; k < world->body_handles.slots.count; ++k)
		cni_body_at(world, k)->flags &= ~(uint32_t)CNI_BODY_MIXED;
	must(cn_world_write_size(world, &bytes), world, "cn_world_write_size");
	file = malloc((size_t)bytes);
	REQUIRE(file != NULL);
	must(cn_world_write(world, file, bytes, NULL), world, "cn_world_write");
	must(cn_world_read(NULL, file, bytes, &read), NULL, "cn_world_read");
	CHECK_GE("bodies whose list has no order", bodies_with(read, CNI_BODY_MIXED), 5, "");
	CHECK(fixture_is_valid(read));
	CHECK_LE("bodies thrown through the ground", bodies_thrown_through(read), 0, "");
	CHECK(fixture_is_valid(read));
	free(file);
	cn_world_destroy(read);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(static_contacts_lead);
	RUN(files_of_earlier_versions_have_no_order);
	return test_end();
}
