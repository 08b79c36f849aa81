/*
 * test/stages/narrowphase_write_test.c - manifolds that are written side by side (stages/narrowphase_write.c) against those
 * written one by one (cni_contact_write): what passes read of blocks, anchors and ids must be the same to the bit, with each
 * kernel.
 *
 * A heap of boxes and balls lies on static ground; in a second one some bodies have a locked axis. If a row differs, compare
 * the order of operations in stages/contact_write.h with that of cni_contact_write.
 */
#include "base/cpu.h"
#include "model/world.h"
#include "stages/narrowphase_write.h"
#include "world/fixture.h"

#include <string.h>

#define LANES_MOST 2048
#define BLOCKS_MOST 256

typedef struct kept_block {
	cni_contact_block rows;
	cni_block_anchor anchor;
	cni_block_info info;
	uint16_t id[CNI_LANES][2];
} kept_block;

static cni_touch touches[LANES_MOST];
static kept_block before[BLOCKS_MOST], one_by_one[BLOCKS_MOST], together[BLOCKS_MOST];

static int32_t block_list(const cn_world *world, int32_t *out)
{
	int32_t color, block, lanes, count = 0;
	for (color = 0; color < CNI_COLORS; ++color)
		for (lanes = world->colors[color].lanes, block = world->colors[color].first; lanes > 0; lanes -= CNI_LANES) {
			if (count == BLOCKS_MOST)
				return count;
			out[count++] = block;
			block = cni_block_info_at(world, block)->next;
		}
	return count;
}

static void block_keep(cn_world *world, int32_t block, kept_block *out)
{
	int32_t l;
	memset(out, 0, sizeof *out);
	out->rows = *cni_block_at(world, block);
	out->anchor = *cni_block_anchor_at(world, block);
	out->info = *cni_block_info_at(world, block);
	for (l = 0; l < CNI_LANES; ++l)
		if (out->info.contact[l] != CNI_NONE)
			memcpy(out->id[l], cni_contact_at(world, out->info.contact[l])->id, sizeof out->id[l]);
}

static void block_put_back(cn_world *world, int32_t block, const kept_block *from)
{
	int32_t l;
	*cni_block_at(world, block) = from->rows;
	*cni_block_anchor_at(world, block) = from->anchor;
	*cni_block_info_at(world, block) = from->info;
	for (l = 0; l < CNI_LANES; ++l)
		if (from->info.contact[l] != CNI_NONE)
			memcpy(cni_contact_at(world, from->info.contact[l])->id, from->id[l], sizeof from->id[l]);
}

/* What lanes in use hold: the others may hold anything. */
static int32_t differ(const kept_block *a, const kept_block *b)
{
	int32_t l, row, count = a->info.anchored != b->info.anchored;
	const uint32_t *rows_a = (const uint32_t *)(const void *)&a->rows, *rows_b = (const uint32_t *)(const void *)&b->rows;
	const uint32_t *anchor_a = (const uint32_t *)(const void *)&a->anchor, *anchor_b = (const uint32_t *)(const void *)&b->anchor;
	for (l = 0; l < CNI_LANES; ++l) {
		if (a->info.contact[l] == CNI_NONE)
			continue;
		for (row = 0; row < (int32_t)(sizeof a->rows / sizeof(float)); row += CNI_LANES)
			count += rows_a[row + l] != rows_b[row + l];
		for (row = 0; row < (int32_t)(sizeof a->anchor / sizeof(float)); row += CNI_LANES)
			count += anchor_a[row + l] != anchor_b[row + l];
		count += a->id[l][0] != b->id[l][0] || a->id[l][1] != b->id[l][1];
	}
	return count;
}

/* Manifolds of all lanes for the poses as they are, in the order of blocks and lanes. */
static int32_t touches_find(cn_world *world, const int32_t *blocks, int32_t block_count)
{
	int32_t k, l, count = 0;
	for (k = 0; k < block_count; ++k)
		for (l = 0; l < CNI_LANES; ++l) {
			int32_t contact = cni_block_info_at(world, blocks[k])->contact[l];
			cni_touch *t = &touches[count];
			cni_touch_pair pair;
			if (contact == CNI_NONE)
				continue;
			if (count == LANES_MOST)
				return count;
			pair = cni_touch_pair_of(world, cni_contact_at(world, contact), contact);
			if (!cni_touch_begin(world, &pair, FRAME_S, t))
				continue;
			cni_touch_collide(t);
			cni_touch_finish(world, FRAME_S, t);
			count += t->manifold.count > 0;
		}
	return count;
}

/* The kernel that is tried, and how many lanes came to it. */
static cni_contact_write_fn *tried;
static int32_t lanes_tried;

static void kernel_counted(const cni_motion *motions, cni_contact_block *block, cni_block_anchor *anchor, const cni_write_lanes *w, uint32_t lanes)
{
	lanes_tried += cni_bit_count64(lanes);
	tried(motions, block, anchor, w, lanes);
}

/* Writes all lanes one by one and with the kernel; returns how many values differ. */
static int32_t both_ways(cn_world *world, int32_t *lanes)
{
	int32_t blocks[BLOCKS_MOST], k, wrong = 0, block_count = block_list(world, blocks), count = touches_find(world, blocks, block_count);
	cni_writer w;
	for (k = 0; k < block_count; ++k)
		block_keep(world, blocks[k], &before[k]);
	for (k = 0; k < count; ++k)
		cni_contact_write(world, touches[k].contact, touches[k].a, touches[k].b, &touches[k].manifold, touches[k].gap, touches[k].radius);
	for (k = 0; k < block_count; ++k) {
		block_keep(world, blocks[k], &one_by_one[k]);
		block_put_back(world, blocks[k], &before[k]);
	}
	cni_writer_begin(&w, world);
	w.kernel = kernel_counted;
	for (k = 0; k < count; ++k)
		cni_writer_add(&w, &touches[k]);
	cni_writer_flush(&w);
	for (k = 0; k < block_count; ++k) {
		block_keep(world, blocks[k], &together[k]);
		wrong += differ(&one_by_one[k], &together[k]);
	}
	*lanes += count;
	return wrong;
}

/* rare: three bodies do not move along x, and their blocks have extra rows. With CN_SOLVER_SOFT normals lag. */
static cn_world *heap(int32_t rare, int32_t solver)
{
	cn_world *world = fixture_world(-10.0f, 0);
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	fixture_floor(world, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -4.5f, 2.0f, 0.1f, 0.5f, 4.0f, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, 4.5f, 2.0f, -0.1f, 0.5f, 4.0f, 0.6f, 0.0f);
	for (k = 0; k < 150; ++k) {
		float x = -3.0f + 0.67f * (float)(k % 10) + 0.02f * (float)(k / 10), y = 0.5f + 0.75f * (float)(k / 10);
		cn_body body = k % 2 == 0 ? fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.1f * (float)(k % 7), 0.3f, 0.2f, 0.6f, 0.2f)
		                          : fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.25f, 0.6f, 0.2f);
		if (rare && k % 60 == 0)
			must(cn_body_set_flags(world, body, CN_BODY_ENABLED | CN_BODY_AWAKE | CN_BODY_LOCK_X), world, "cn_body_set_flags");
	}
	return world;
}

static void heap_is_written_alike(int32_t rare, int32_t solver, cni_contact_write_fn *kernel)
{
	cn_world *world = heap(rare, solver);
	int32_t step, wrong = 0, lanes = 0;
	tried = kernel;
	lanes_tried = 0;
	for (step = 0; step < 120; ++step) {
		fixture_step(world, 1);
		if (step % 6 == 0)
			wrong += both_ways(world, &lanes);
	}
	printf("  %d lanes written both ways, %d of them side by side\n", (int)lanes, (int)lanes_tried);
	CHECK_LE("values that differ", wrong, 0, "");
	CHECK_GE("lanes side by side", lanes_tried, rare ? 200 : 2000, "");
	if (rare)
		CHECK_GE("lanes one by one", lanes - lanes_tried, 200, "");
	cn_world_destroy(world);
}

static void widest_kernel(void)
{
	cni_contact_write_fn *kernel = cni_contact_kernel_choose()->write;
	if (kernel == NULL)
		SKIP("this build has no vectors");
	heap_is_written_alike(0, CN_SOLVER_AUTO, kernel);
	heap_is_written_alike(0, CN_SOLVER_SOFT, kernel);
	heap_is_written_alike(1, CN_SOLVER_AUTO, kernel);
}

#if CNI_HAS_WIDE_4
static void kernel_of_four(void)
{
	heap_is_written_alike(0, CN_SOLVER_AUTO, cni_contact_kernel_4.write);
	heap_is_written_alike(0, CN_SOLVER_SOFT, cni_contact_kernel_4.write);
	heap_is_written_alike(1, CN_SOLVER_AUTO, cni_contact_kernel_4.write);
}
#endif

int main(int argc, char **argv)
{
	test_begin(argc, argv);
#if CNI_HAS_WIDE_4
	RUN(kernel_of_four);
#endif
	RUN(widest_kernel);
	return test_end();
}
