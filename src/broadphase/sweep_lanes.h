/*
 * broadphase/sweep_lanes.h - tests a box against CNI_WIDTH entries at a time: 8 if the file that includes this says so. Where
 * CNI_KERNEL is defined, it also defines the inner loop of the pair search under that name: once in sweep_search.c, once in
 * sweep_lanes_8.c. The code only compares, so all widths find the same pairs.
 */
#include "base/cpu.h"
#if !defined(CNI_WIDTH) && CNI_HAS_WIDE_4
#define CNI_WIDTH 4
#elif !defined(CNI_WIDTH)
#define CNI_WIDTH 1
#endif
#include "base/wide.h"
#include "broadphase/sweep.h"

CNI_INLINE cni_mask lanes_overlap(const cni_sweep_rows *rows, int32_t k, const cni_aabb *box)
{
	cni_wide left = cni_wide_load_loose(rows->x0 + k), right = cni_wide_load_loose(rows->x1 + k);
	cni_wide low = cni_wide_load_loose(rows->y0 + k), high = cni_wide_load_loose(rows->y1 + k);
	cni_wide box_x0 = cni_wide_of(box->x0), box_x1 = cni_wide_of(box->x1), box_y0 = cni_wide_of(box->y0), box_y1 = cni_wide_of(box->y1);
	return (left <= box_x1) & (right >= box_x0) & (low <= box_y1) & (high >= box_y0);
}

#ifdef CNI_KERNEL

/* New overlaps in the group of entries that begins at k, as bits. The padding behind the last entry overlaps no probe. */
CNI_INLINE uint32_t lanes_new(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t k)
{
	uint32_t bits = 0;
	for (int32_t l = 0; l < CNI_SWEEP_LANES; l += CNI_WIDTH)
		bits |= cni_mask_bits(lanes_overlap(&v->now, k + l, &q->now) & ~lanes_overlap(&v->old, k + l, &q->old)) << l;
	return bits;
}

uint32_t CNI_KERNEL(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t *k, uint32_t wanted)
{
	int32_t i = *k;
	uint32_t bits = 0;
	for (; i < v->count && v->now.x0[i] <= q->now.x1; i += CNI_SWEEP_LANES) {
		bits = lanes_new(q, v, i) & wanted;
		wanted = ~0u;
		if (bits != 0)
			break;
	}
	*k = i;
	return bits;
}

#endif
