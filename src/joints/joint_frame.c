/*
 * joints/joint_frame.c - a joint's frame at the present poses, and read-back through its rows: anchors, error, position, speed, reaction.
 */
#include "joints/joint_type.h"

/* Anchor - ground point of a pulley's side, without losing digits far from the origin; r is from the centre of mass to the anchor. */
static cni_vec2 from_ground(const cni_body *b, const cni_joint *j, int32_t side, cni_vec2 r)
{
	const float *ground = j->p + (side == 0 ? CNI_P_PULLEY_GROUND_A : CNI_P_PULLEY_GROUND_B);
	cni_vec2 point = cni_v(ground[0], ground[1]);
	return b == NULL ? cni_sub(j->anchor[side], point) : cni_add(cni_v((b->cx - point.x) + b->cx_low, (b->cy - point.y) + b->cy_low), r);
}

float cni_joint_frame_angle(const cn_world *world, const cni_joint *j)
{
	const cni_joint_type *type = cni_joint_type_of(j->type);
	cni_rot qa = cni_joint_side_rotation(world, j, 0), qb = cni_joint_side_rotation(world, j, 1), q;
	if (type->uses & CNI_USES_TURNS)
		return cni_joint_turned(j, qa, qb, (type->uses & CNI_USES_RATIO) ? j->p[CNI_P_GEAR_RATIO] : 1.0f);
	if (!(type->uses & CNI_USES_ANGLE))
		return 0.0f;
	q = cni_rot_between(qa, qb);
	return cni_wrap_angle(cni_atan2(q.s, q.c) - j->p[CNI_P_REFERENCE] * (float)((type->uses & CNI_USES_REFERENCE) != 0));
}

cni_joint_frame cni_joint_frame_place(const cn_world *world, const cni_joint *j)
{
	const cni_joint_type *type = cni_joint_type_of(j->type);
	const cni_body *a = j->body[0] == CNI_NONE ? NULL : cni_body_at(world, j->body[0]);
	const cni_body *b = j->body[1] == CNI_NONE ? NULL : cni_body_at(world, j->body[1]);
	cni_rot qa = { 1.0f, 0.0f }, qb = { 1.0f, 0.0f };
	cni_vec2 la = j->anchor[0], lb = j->anchor[1], d = { 0.0f, 0.0f };
	cni_joint_frame f;
	if (a != NULL) {
		qa = a->q;
		la = cni_sub(la, a->local_center);
		d = cni_v(-a->cx, -a->cy);
	}
	if (b != NULL) {
		qb = b->q;
		lb = cni_sub(lb, b->local_center);
		d = cni_add(d, cni_v(b->cx, b->cy));
		d = cni_add(d, cni_v(b->cx_low, b->cy_low));
	}
	if (a != NULL)
		d = cni_sub(d, cni_v(a->cx_low, a->cy_low));
	f.ra = cni_rotate(qa, la);
	f.rb = cni_rotate(qb, lb);
	/* With the world on one side that side's anchor is a large number: subtract it from the centre first. */
	f.d = a != NULL && b == NULL ? cni_sub(cni_add(d, f.rb), f.ra) : cni_add(cni_sub(d, f.ra), f.rb);
	f.e = cni_v(0.0f, 0.0f);
	if (type->uses & CNI_USES_GROUNDS) {
		f.d = from_ground(a, j, 0, f.ra);
		f.e = from_ground(b, j, 1, f.rb);
	}
	f.qa = qa;
	f.angle = 0.0f;
	f.ratio = (type->uses & CNI_USES_RATIO) ? j->p[CNI_P_GEAR_RATIO] : 1.0f;
	return f;
}

cni_joint_frame cni_joint_frame_make(const cn_world *world, const cni_joint *j)
{
	cni_joint_frame f = cni_joint_frame_place(world, j);
	f.angle = cni_joint_frame_angle(world, j);
	return f;
}

/* ---- read-back ---- */

static cni_vec2 side_anchor(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] == CNI_NONE ? j->anchor[side] : cni_transform_point(cni_body_transform(cni_body_at(world, j->body[side])), j->anchor[side]);
}

void cni_joint_anchors(const cn_world *world, const cni_joint *j, cni_vec2 *out_a, cni_vec2 *out_b)
{
	*out_a = side_anchor(world, j, 0);
	*out_b = side_anchor(world, j, 1);
}

void cni_joint_error(const cn_world *world, const cni_joint *j, float *out_m, float *out_rad)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &f, rows);
	float linear_sq = 0.0f, angular = 0.0f;
	for (int32_t k = 0; k < count; ++k) {
		float e = rows[k].kind == CNI_ROW_RIGID ? rows[k].error : cni_min(rows[k].error, 0.0f);
		if (rows[k].kind != CNI_ROW_RIGID && rows[k].kind != CNI_ROW_LIMIT)
			continue;
		if (rows[k].angular)
			angular = cni_max(angular, cni_abs(e));
		else
			linear_sq += e * e;
	}
	*out_m = cni_saturate(cni_sqrt(linear_sq));
	*out_rad = cni_saturate(angular);
}

float cni_joint_position(const cn_world *world, const cni_joint *j)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	return cni_saturate(cni_joint_type_of(j->type)->position(j, &f));
}

static cn_velocity side_velocity(const cn_world *world, const cni_joint *j, int32_t side)
{
	cn_velocity zero = { { 0.0f, 0.0f }, 0.0f };
	return j->body[side] == CNI_NONE ? zero : cni_body_velocity(world, cni_body_at(world, j->body[side]));
}

float cni_joint_speed(const cn_world *world, const cni_joint *j)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_lever l = cni_joint_type_of(j->type)->speed_row(j, &f).lever;
	cn_velocity a = side_velocity(world, j, 0), b = side_velocity(world, j, 1);
	return cni_saturate(l.ax * a.linear_mps.x + l.ay * a.linear_mps.y + l.aw * a.angular_radps +
	                    l.bx * b.linear_mps.x + l.by * b.linear_mps.y + l.bw * b.angular_radps);
}

void cni_rows_impulse(const cni_row *rows, int32_t count, cni_vec2 rb, cni_vec2 *out_linear, float *out_angular)
{
	cni_vec2 linear = { 0.0f, 0.0f };
	float angular = 0.0f;
	for (int32_t k = 0; k < count; ++k) {
		cni_vec2 b = cni_v(rows[k].lever.bx, rows[k].lever.by);
		linear = cni_madd(linear, rows[k].impulse, b);
		/* The part of the angular Jacobian that is not the force's own moment about the centre. */
		angular += rows[k].impulse * (rows[k].lever.bw - cni_cross(rb, b));
	}
	*out_linear = linear;
	*out_angular = angular;
}

void cni_joint_reaction(const cn_world *world, const cni_joint *j, cn_vec2 *out_force, float *out_torque)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &f, rows);
	for (int32_t k = 0; k < count; ++k)
		rows[k].impulse = cni_saturate(j->impulse[rows[k].slot] * j->inv_h);
	cni_rows_impulse(rows, count, f.rb, out_force, out_torque);
	*out_force = cni_v(cni_saturate(out_force->x), cni_saturate(out_force->y));
	*out_torque = cni_saturate(*out_torque);
}
