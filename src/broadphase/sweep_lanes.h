/*
 * broadphase/sweep_lanes.h - tests of a box against CNI_WIDTH entries at a time, and where CNI_KERNEL is defined the
 * inner loop of finding pairs under that name: sweep_search.c and sweep_lanes_8.c have one each.
 * Comparisons only, so all widths find the same.
 */
#include "base/wide.h"
#include "broadphase/sweep.h"

CNI_INLINE cni_mask lanes_overlap(const float *x0, const float *x1, const float *y0, const float *y1, const cni_aabb *box)
{
	cni_wide left = cni_wide_load_loose(x0), right = cni_wide_load_loose(x1), low = cni_wide_load_loose(y0), high = cni_wide_load_loose(y1);
	cni_wide box_x0 = cni_wide_of(box->x0), box_x1 = cni_wide_of(box->x1), box_y0 = cni_wide_of(box->y0), box_y1 = cni_wide_of(box->y1);
	return (left <= box_x1) & (right >= box_x0) & (low <= box_y1) & (high >= box_y0);
}

#ifdef CNI_KERNEL

/* New overlaps in the group of entries that begins at k, as bits. What is behind the last entry begins beyond any probe. */
CNI_INLINE uint32_t lanes_new(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t k)
{
	uint32_t bits = 0;
	int32_t l, i;
	for (l = 0; l < CNI_SWEEP_LANES; l += CNI_WIDTH) {
		cni_mask now, old;
		i = k + l;
		now = lanes_overlap(v->x0 + i, v->x1 + i, v->y0 + i, v->y1 + i, &q->now);
		old = lanes_overlap(v->px0 + i, v->px1 + i, v->py0 + i, v->py1 + i, &q->old);
		bits |= cni_mask_bits(now & ~old) << l;
	}
	return bits;
}

uint32_t CNI_KERNEL(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t *k, uint32_t wanted)
{
	int32_t i = *k;
	uint32_t bits = 0;
	for (; i < v->count && v->x0[i] <= q->now.x1; i += CNI_SWEEP_LANES) {
		bits = lanes_new(q, v, i) & wanted;
		wanted = ~0u;
		if (bits != 0)
			break;
	}
	*k = i;
	return bits;
}

#endif
