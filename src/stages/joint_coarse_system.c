/*
 * stages/joint_coarse_system.c - the systems that bind the modes of nets' patches (stages/joint_coarse.h): 1 + g J'J by rows, each
 * from its first entry that is not 0, factored in place as L L' (Cholesky; George and Liu, "Computer Solution of Large
 * Sparse Positive Definite Systems", 1981, chapter 4). Doubles: g makes the largest entries a million times the smallest.
 *
 * Reads nets, pins, patches, parts; writes patches' columns and entries, entries, speeds, and which nets are dear.
 */
#include "stages/joint_coarse.h"

#include <string.h>

#define STIFF 1e6            /* g over the mass of a body */
#define ENTRIES_MOST 64      /* of a system, a body: more cost as much as the passes */
#define PIVOT_LEAST 0.5      /* of a factor, squared: half of what it is without rounding */

/* Four sums, so that they need not wait for each other. */
CNI_INLINE double dot(const double *a, const double *b, int32_t count)
{
	double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
	int32_t k = 0;
	for (; k + 4 <= count; k += 4) {
		s0 += a[k] * b[k];
		s1 += a[k + 1] * b[k + 1];
		s2 += a[k + 2] * b[k + 2];
		s3 += a[k + 3] * b[k + 3];
	}
	for (; k < count; ++k)
		s0 += a[k] * b[k];
	return (s0 + s1) + (s2 + s3);
}

/* ---- making ---- */

void cni_coarse_system_size(const cni_coarse_view *v, int32_t *patch_of)
{
	int32_t n, p, k, i;
	for (p = 0; p < v->head->patch_count; ++p) {
		v->patches[p].column = v->patches[p].mode;
		for (k = v->patches[p].body_begin; k < v->patches[p].body_end; ++k)
			patch_of[k] = p;
	}
	for (k = 0; k < v->head->pin_count; ++k) {
		const cni_net_pin *pin = &v->pins[k];
		cni_patch *low, *high;
		if (pin->a == CNI_NONE || pin->b == CNI_NONE)
			continue;
		low = &v->patches[cni_min_i(patch_of[pin->a], patch_of[pin->b])];
		high = &v->patches[cni_max_i(patch_of[pin->a], patch_of[pin->b])];
		high->column = cni_min_i(high->column, low->mode);
	}
	for (n = 0; n < v->head->net_count; ++n) {
		cni_net_range *net = &v->nets[n];
		int64_t before = v->head->entry_count;
		for (p = net->patch_begin; p < net->patch_end; ++p) {
			cni_patch *patch = &v->patches[p];
			patch->entry = v->head->entry_count;
			for (i = 0; i < patch->modes; ++i)
				v->head->entry_count += patch->mode + i - patch->column + 1;
		}
		net->dear = v->head->entry_count - before > ENTRIES_MOST * (int64_t)(net->body_end - net->body_begin);
		if (net->dear)
			v->head->entry_count = before;
	}
}

static double *row_of(const cni_coarse_view *v, const cni_patch *patch, int32_t i)
{
	return v->entries + patch->entry + (int64_t)i * (patch->mode - patch->column + 1) + (int64_t)i * (i - 1) / 2;
}

/* Speed of the end of a body's arm by each mode of its patch. */
static void arm_modes(const cni_coarse_view *v, const cni_patch *patch, int32_t net_body, float x, float y, double sign, double out[2][CNI_PATCH_MODES])
{
	const float *at = v->parts + patch->part + 3 * (net_body - patch->body_begin) * patch->modes;
	int32_t i;
	for (i = 0; i < patch->modes; ++i, at += 3) {
		out[0][i] = sign * ((double)at[0] - (double)at[2] * (double)y);
		out[1][i] = sign * ((double)at[1] + (double)at[2] * (double)x);
	}
}

/* The rows of a patch by the columns of another one, or itself, += g a' b */
static void rows_add(const cni_coarse_view *v, const cni_patch *row, const cni_patch *column, double a[2][CNI_PATCH_MODES], double b[2][CNI_PATCH_MODES], double g)
{
	int32_t i, j;
	for (i = 0; i < row->modes; ++i)
		for (j = 0; j < (row == column ? i + 1 : column->modes); ++j)
			row_of(v, row, i)[column->mode - row->column + j] += g * (a[0][i] * b[0][j] + a[1][i] * b[1][j]);
}

static void system_write(const cni_coarse_view *v, const cni_net_range *net, const int32_t *patch_of)
{
	double g = 0.0;
	int32_t k, i;
	for (k = net->body_begin; k < net->body_end; ++k)
		g += STIFF / ((double)v->bodies[k].inv_mass * (double)(net->body_end - net->body_begin));
	for (k = net->patch_begin; k < net->patch_end; ++k)
		for (i = 0; i < v->patches[k].modes; ++i)
			row_of(v, &v->patches[k], i)[v->patches[k].mode - v->patches[k].column + i] = 1.0;
	for (k = net->pin_begin; k < net->pin_end; ++k) {
		const cni_net_pin *pin = &v->pins[k];
		const cni_patch *pa, *pb;
		double a[2][CNI_PATCH_MODES], b[2][CNI_PATCH_MODES];
		if (pin->a == CNI_NONE || pin->b == CNI_NONE || patch_of[pin->a] == patch_of[pin->b])
			continue;
		pa = &v->patches[patch_of[pin->a]];
		pb = &v->patches[patch_of[pin->b]];
		arm_modes(v, pa, pin->a, pin->arms.ax, pin->arms.ay, -1.0, a);
		arm_modes(v, pb, pin->b, pin->arms.bx, pin->arms.by, 1.0, b);
		rows_add(v, pa, pa, a, a, g);
		rows_add(v, pb, pb, b, b, g);
		if (pa > pb)
			rows_add(v, pa, pb, a, b, g);
		else
			rows_add(v, pb, pa, b, a, g);
	}
}

/* A row of the factor, given those before it. 0: rounding has eaten what the least of its pivots may be, which is 1: masses
   differ by twelve decimal orders and more. */
static int32_t row_factor(const cni_coarse_view *v, const cni_patch *patch, int32_t i, const int32_t *patch_of_mode)
{
	double *row = row_of(v, patch, i);
	int32_t j, at = patch->mode + i;
	for (j = patch->column; j <= at; ++j) {
		const cni_patch *other = &v->patches[patch_of_mode[j]];
		const double *before = row_of(v, other, j - other->mode);
		int32_t from = cni_max_i(patch->column, other->column);
		double sum = row[j - patch->column] - dot(row + (from - patch->column), before + (from - other->column), j - from);
		if (j == at && !(sum > PIVOT_LEAST))
			return 0;
		row[j - patch->column] = j < at ? sum * before[j - other->column] : 1.0 / cni_sqrt_double(sum);
	}
	return 1;
}

static int32_t system_factor(const cni_coarse_view *v, const cni_net_range *net, const int32_t *patch_of_mode)
{
	int32_t p, i;
	for (p = net->patch_begin; p < net->patch_end; ++p)
		for (i = 0; i < v->patches[p].modes; ++i)
			if (!row_factor(v, &v->patches[p], i, patch_of_mode))
				return 0;
	return 1;
}

void cni_coarse_system_make(const cni_coarse_view *v, const int32_t *patch_of, int32_t *patch_of_mode)
{
	int32_t n, p, i;
	for (p = 0; p < v->head->patch_count; ++p)
		for (i = 0; i < v->patches[p].modes; ++i)
			patch_of_mode[v->patches[p].mode + i] = p;
	memset(v->entries, 0, sizeof(double) * (size_t)v->head->entry_count);
	for (n = 0; n < v->head->net_count; ++n) {
		if (v->nets[n].dear)
			continue;
		system_write(v, &v->nets[n], patch_of);
		v->nets[n].dear = !system_factor(v, &v->nets[n], patch_of_mode);
	}
}

/* ---- solving ---- */

void cni_coarse_system_solve(const cni_coarse_view *v, const cni_net_range *net)
{
	double *q = v->speeds;
	int32_t p, i, k;
	for (p = net->patch_begin; p < net->patch_end; ++p) {
		const cni_patch *patch = &v->patches[p];
		const double *row = v->entries + patch->entry;
		for (i = 0; i < patch->modes; ++i) {
			int32_t length = patch->mode + i - patch->column;
			q[patch->mode + i] = (q[patch->mode + i] - dot(row, q + patch->column, length)) * row[length];
			row += length + 1;
		}
	}
	for (p = net->patch_end - 1; p >= net->patch_begin; --p) {
		const cni_patch *patch = &v->patches[p];
		int32_t first = patch->mode - patch->column;
		for (i = patch->modes - 1; i >= 0; --i) {
			const double *row = row_of(v, patch, i);
			int32_t length = first + i;
			double x = q[patch->mode + i] *= row[length], *to = q + patch->column;
			for (k = 0; k < length; ++k)
				to[k] -= row[k] * x;
		}
	}
}
