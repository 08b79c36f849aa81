/*
 * joints/joint_pulley.c - a rope from anchor a over two points of the world to anchor b:
 * |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never pushes.
 *
 * p: length, ground a, ground b, ratio. Impulse slot: 0.
 */
#include "joints/joint_row.h"

/* Unit vector along x; 0 for an anchor that lies on its pulley. */
static cni_vec2 direction(cni_vec2 x, float length)
{
	return length > 1e-9f ? cni_mul(1.0f / length, x) : cni_v(0.0f, 0.0f);
}

/* d/dt of sign * (length of rope in use). */
static cni_row rope_row(const cni_joint *j, const cni_joint_frame *f, float sign, float *out_length)
{
	float ratio = j->p[CNI_P_PULLEY_RATIO], length_a = cni_length(f->d), length_b = cni_length(f->e);
	cni_vec2 u = direction(f->d, length_a), v = cni_mul(ratio, direction(f->e, length_b));
	cni_row r;
	memset(&r, 0, sizeof r);
	r.ax = sign * u.x;
	r.ay = sign * u.y;
	r.aw = sign * cni_cross(f->ra, u);
	r.bx = sign * v.x;
	r.by = sign * v.y;
	r.bw = sign * cni_cross(f->rb, v);
	r.kind = CNI_ROW_LIMIT;
	*out_length = length_a + ratio * length_b;
	return r;
}

static int32_t pulley_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	float length;
	rows[0] = rope_row(j, f, -1.0f, &length);
	rows[0].error = j->p[CNI_P_LENGTH] - length;
	return 1;
}

static float pulley_position(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_length(f->d) + j->p[CNI_P_PULLEY_RATIO] * cni_length(f->e);
}

static cni_row pulley_speed_row(const cni_joint *j, const cni_joint_frame *f)
{
	float length;
	return rope_row(j, f, 1.0f, &length);
}

const cni_joint_type cni_joint_pulley = { pulley_rows, pulley_position, pulley_speed_row, CNI_USES_GROUNDS };
