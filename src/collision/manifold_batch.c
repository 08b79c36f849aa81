/*
 * collision/manifold_batch.c - fills a batch of pairs and reads the manifolds back.
 */
#include "collision/manifold_batch.h"
#include "base/cpu.h"

#include <string.h>

/* Columns that a kernel may work out beyond the last pair. */
#define WIDTH_MAX (CNI_BATCH_PAIRS < 8 ? CNI_BATCH_PAIRS : 8)

cni_batch_kernel_fn *cni_batch_kernel_choose(void)
{
	return CNI_WIDEST(NULL, cni_batch_kernel_4, cni_batch_kernel_8);
}

static void axis_add(cni_manifold_batch *batch, int32_t k, const cni_manifold_input *in, int32_t axis)
{
	const cni_geometry *g = axis > CN_POLYGON_MAX_VERTICES ? in->b : in->a;
	int32_t edge = (axis + CN_POLYGON_MAX_VERTICES - 1) % CN_POLYGON_MAX_VERTICES;
	if (axis == 0 || edge >= g->count)
		axis = edge = 0;
	cni_vec2 n = cni_geometry_normals(g)[edge];
	cni_vec2 p = cni_geometry_points(g)[edge];
	batch->axis[k] = axis;
	batch->axis_nx[k] = n.x;
	batch->axis_ny[k] = n.y;
	batch->axis_px[k] = p.x;
	batch->axis_py[k] = p.y;
}

int32_t cni_batch_add(cni_manifold_batch *batch, const cni_manifold_input *in, const cni_manifold_cache *cache)
{
	int32_t k = batch->count++;
	CNI_ASSERT(k < CNI_BATCH_PAIRS && cni_batch_take(in));
	batch->qc[k] = in->b_in_a.q.c;
	batch->qs[k] = in->b_in_a.q.s;
	batch->tx[k] = in->b_in_a.t.x;
	batch->ty[k] = in->b_in_a.t.y;
	batch->radius_a[k] = in->a->radius;
	batch->radius_b[k] = in->b->radius;
	batch->margin[k] = in->margin;
	batch->slop = in->slop;
	batch->count_a[k] = in->a->count;
	batch->count_b[k] = in->b->count;
	batch->a[k] = (const float *)(const void *)cni_geometry_points(in->a);
	batch->b[k] = (const float *)(const void *)cni_geometry_points(in->b);
	axis_add(batch, k, in, cache->axis);
	return k;
}

/* Rows of numbers that a kernel reads, from qc to count_b. */
#define INPUT_ROWS (offsetof(cni_manifold_batch, a) / (CNI_BATCH_PAIRS * sizeof(float)))

/* Copies the last column to fill the kernel's width. */
static void pad(cni_manifold_batch *batch)
{
	int32_t last = batch->count - 1;
	float *rows = (float *)(void *)batch;
	for (int32_t k = batch->count; k % WIDTH_MAX != 0; ++k) {
		for (size_t row = 0; row < INPUT_ROWS; ++row)
			memcpy(rows + row * CNI_BATCH_PAIRS + k, rows + row * CNI_BATCH_PAIRS + last, sizeof *rows);
		batch->a[k] = batch->a[last];
		batch->b[k] = batch->b[last];
	}
}

void cni_batch_run(cni_manifold_batch *batch, cni_batch_kernel_fn *kernel)
{
	if (batch->count == 0)
		return;
	if (batch->count == 1) { /* a single pair is cheaper without the kernel */
		batch->state[0] = CNI_BATCH_FALLBACK;
		return;
	}
	pad(batch);
	kernel(batch, batch->count);
}

static void point_read(const cni_batch_point *p, int32_t column, float margin, cni_manifold *out)
{
	cni_manifold_point *to = &out->points[out->count];
	if (p->separation[column] > margin)
		return;
	to->point = cni_v(p->x[column], p->y[column]);
	to->separation = p->separation[column];
	to->id = (uint32_t)p->id[column];
	++out->count;
}

void cni_batch_read(const cni_manifold_batch *batch, int32_t column, const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	if (batch->state[column] == CNI_BATCH_FALLBACK) {
		cni_manifold_function(in->a->type, in->b->type)(in, cache, out);
		return;
	}
	cache->axis = (uint8_t)batch->axis[column];
	out->count = 0;
	if (batch->state[column] == CNI_BATCH_APART)
		return;
	out->normal = cni_v(batch->nx[column], batch->ny[column]);
	point_read(&batch->point[0], column, in->margin, out);
	if (batch->state[column] == CNI_BATCH_POINTS)
		point_read(&batch->point[1], column, in->margin, out);
}
