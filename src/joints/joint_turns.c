/*
 * joints/joint_turns.c - angles over whole turns, for gears, ratchets, rotary springs and angle constraints.
 *
 * For each side the record keeps the body's angle in [-pi, pi] that is expected at the end of the last step from its rotation in the step,
 * and the number of whole turns. An angle read from a rotation gets the turns that bring it nearest to the expected one. So the count is
 * exact and the read angle never drifts from the poses, however long the world runs; when the user sets a rotation, the shorter way round
 * counts.
 *
 * A gear's angle b - ratio * angle a is a difference of large numbers after many turns; the turns' part is computed with the rounding error
 * of the product (Dekker, 1971) and so stays exact to a few 1e-7 of the ratio.
 */
#include "joints/joint_type.h"

#define TURN_RAD 6.28318530717958f

static float rounded(float x)
{
	return (float)(int32_t)(x + (x < 0.0f ? -0.5f : 0.5f));
}

/* Angle of a side in (-pi, pi] and its whole turns. */
static float side_angle(const cni_joint *j, int32_t side, cni_rot q, float *out_turns)
{
	const float *state = j->p + CNI_P_TURN + 2 * side;
	if (j->body[side] == CNI_NONE) {
		*out_turns = 0.0f;
		return 0.0f;
	}
	float angle = cni_atan2(q.s, q.c);
	*out_turns = state[1] + rounded((state[0] - angle) / TURN_RAD);
	return angle;
}

/* x = high + low with high of 12 bits, so that products of halves are exact (Veltkamp, 1968). */
static float split_high(float x)
{
	float c = 4097.0f * x;
	return c - (c - x);
}

/* b - ratio * a, rounded once. */
static float turns_difference(float b, float ratio, float a)
{
	float product = ratio * a;
	float rh = split_high(ratio), rl = ratio - rh, ah = split_high(a), al = a - ah;
	float error = ((rh * ah - product) + rh * al + rl * ah) + rl * al;
	return (b - product) - error;
}

float cni_joint_turned(const cni_joint *j, cni_rot qa, cni_rot qb, float ratio)
{
	float turns_a, turns_b;
	float a = side_angle(j, 0, qa, &turns_a), b = side_angle(j, 1, qb, &turns_b);
	return (b - ratio * a) + TURN_RAD * turns_difference(turns_b, ratio, turns_a);
}

/* The click that holds a ratchet at this angle. A thousandth of a click below a click counts as on it, so that a ratchet that starts on a
   click does not fall back to the one before. */
static float latch_at(const cni_joint *j, float angle)
{
	float clicks = (angle - j->p[CNI_P_RATCHET_PHASE]) / j->p[CNI_P_RATCHET_CLICK] + 1e-3f;
	float whole = (float)(int32_t)clicks;
	return clicks < whole ? whole - 1.0f : whole;
}

void cni_joint_ratchet_begin(const cn_world *world, cni_joint *j)
{
	j->p[CNI_P_RATCHET_LATCH] = latch_at(j, cni_joint_turned(j, cni_joint_side_rotation(world, j, 0), cni_joint_side_rotation(world, j, 1), 1.0f));
}

void cni_joint_turns_begin(const cn_world *world, cni_joint *j)
{
	if (!(cni_joint_type_of(j->type)->uses & CNI_USES_TURNS))
		return;
	for (int32_t side = 0; side < 2; ++side) {
		cni_rot q = cni_joint_side_rotation(world, j, side);
		j->p[CNI_P_TURN + 2 * side] = cni_atan2(q.s, q.c);
		j->p[CNI_P_TURN + 2 * side + 1] = 0.0f;
	}
	if (j->type == CN_JOINT_RATCHET)
		cni_joint_ratchet_begin(world, j);
}

void cni_joint_turns_advance(const cn_world *world, cni_joint *j, float theta_a, float theta_b)
{
	float turned[2];
	for (int32_t side = 0; side < 2; ++side) {
		float *state = j->p + CNI_P_TURN + 2 * side;
		float turns, angle = side_angle(j, side, cni_joint_side_rotation(world, j, side), &turns);
		float expected = angle + (side == 0 ? theta_a : theta_b);
		float whole = rounded(expected / TURN_RAD);
		state[0] = expected - TURN_RAD * whole;
		state[1] = turns + whole;
		turned[side] = state[0];
	}
	if (j->type == CN_JOINT_RATCHET) {
		float turns = j->p[CNI_P_TURN + 3] - j->p[CNI_P_TURN + 1];
		j->p[CNI_P_RATCHET_LATCH] = cni_max(j->p[CNI_P_RATCHET_LATCH], latch_at(j, (turned[1] - turned[0]) + TURN_RAD * turns));
	}
}
