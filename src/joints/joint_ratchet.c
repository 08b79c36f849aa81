/*
 * joints/joint_ratchet.c - b may turn against a in one direction only, in clicks.
 *
 * The latch is the last click passed, counted from phase; it moves forwards at the end of a step (joint_turns.c) and keeps the angle from
 * falling behind it.
 *
 * p: phase, click, latch, turns. Impulse slot: 0.
 */
#include "joints/joint_row.h"

static int32_t ratchet_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	float click = j->p[CNI_P_RATCHET_CLICK], sign = click > 0.0f ? 1.0f : -1.0f;
	rows[0] = cni_row_angular(CNI_ROW_LIMIT, 0, sign, 1.0f);
	rows[0].error = sign * (f->angle - (j->p[CNI_P_RATCHET_PHASE] + click * j->p[CNI_P_RATCHET_LATCH]));
	return 1;
}

const cni_joint_type cni_joint_ratchet = { ratchet_rows, cni_joint_position_angle, cni_joint_speed_angle, CNI_USES_TURNS };
