/*
 * model/joint.c - joint records: lists, islands, and read-back through rows (idea in joint.h).
 *
 * Owns the joint table and the awake list. Invariant: a joint is in the lists of its bodies while it lives,
 * and in the awake list when one of its bodies is in the dense arrays and none is disabled; a filter joint
 * has nothing to solve and is in no awake list and no island.
 */
#include "model/joint_row.h"
#include "model/world.h"

#include <string.h>

const cni_joint_type *cni_joint_type_of(int32_t type)
{
	static const cni_joint_type *const types[CNI_JOINT_TYPES] = {
		&cni_joint_revolute, &cni_joint_distance, &cni_joint_fixed, &cni_joint_prismatic, &cni_joint_wheel,
		&cni_joint_motor, &cni_joint_mouse, &cni_joint_gear, &cni_joint_pulley, &cni_joint_ratchet,
		&cni_joint_rotary_spring, &cni_joint_groove, &cni_joint_filter, &cni_joint_angle, &cni_joint_line
	};
	return types[type];
}

/* Joints and constraints share a table, so their handles differ in the kind bits only. */
#define KIND_BITS ((uint32_t)(CNI_KIND_JOINT ^ CNI_KIND_CONSTRAINT) << 20)

uint32_t cni_joint_handle(const cn_world *world, int32_t joint)
{
	uint32_t handle = cni_handles_of(&world->joint_handles, joint);
	return cni_joint_is_constraint(cni_joint_at(world, joint)->type) ? handle ^ KIND_BITS : handle;
}

int32_t cni_joint_find(const cn_world *world, uint32_t handle, int32_t constraint)
{
	int32_t index = cni_handles_find(&world->joint_handles, constraint ? handle ^ KIND_BITS : handle);
	if (index != CNI_NONE && cni_joint_is_constraint(cni_joint_at(world, index)->type) != constraint)
		return CNI_NONE;
	return index;
}

int32_t cni_joint_blocks_for(int32_t joints)
{
	return joints / CNI_LANES + cni_min_i(joints, CNI_JOINT_COLORS);
}

cn_result cni_joint_reserve(cn_world *world, int32_t extra)
{
	int32_t used = cni_handles_used(&world->joint_handles) + extra;
	int32_t good = cni_table_reserve(&world->joints, &world->memory, used) &&
	               cni_array_reserve(&world->awake_joints, &world->memory, world->joint_handles.count + extra) &&
	               cni_array_reserve(&world->joint_work, &world->memory, world->joint_handles.count + extra) &&
	               cni_array_reserve(&world->joint_blocks, &world->memory, cni_joint_blocks_for(world->joint_handles.count + extra)) &&
	               cni_island_reserve(world, extra);
	return good ? CN_OK : CN_ERROR_MEMORY;
}

/* ---- lists ---- */

static void list_link(cn_world *world, int32_t joint, int32_t side)
{
	cni_joint *j = cni_joint_at(world, joint);
	cni_body *b;
	int32_t key = joint << 1 | side;
	j->prev[side] = j->next[side] = CNI_NONE;
	if (j->body[side] == CNI_NONE)
		return;
	b = cni_body_at(world, j->body[side]);
	j->next[side] = b->joint_first;
	if (b->joint_first != CNI_NONE)
		cni_joint_at(world, b->joint_first >> 1)->prev[b->joint_first & 1] = key;
	b->joint_first = key;
}

static void list_unlink(cn_world *world, int32_t joint, int32_t side)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t next = j->next[side], prev = j->prev[side];
	if (j->body[side] == CNI_NONE)
		return;
	if (prev != CNI_NONE)
		cni_joint_at(world, prev >> 1)->next[prev & 1] = next;
	else
		cni_body_at(world, j->body[side])->joint_first = next;
	if (next != CNI_NONE)
		cni_joint_at(world, next >> 1)->prev[next & 1] = prev;
}

static int32_t side_is_enabled(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] == CNI_NONE || (cni_body_at(world, j->body[side])->flags & CN_BODY_ENABLED);
}

static int32_t side_is_awake(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] != CNI_NONE && cni_body_at(world, j->body[side])->awake != 0;
}

static int32_t side_is_dynamic(const cn_world *world, const cni_joint *j, int32_t side)
{
	return j->body[side] != CNI_NONE && cni_body_at(world, j->body[side])->type == CN_BODY_DYNAMIC;
}

void cni_joint_enter_awake_list(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	if (j->awake != CNI_NONE || j->type == CN_JOINT_FILTER || !side_is_enabled(world, j, 0) || !side_is_enabled(world, j, 1))
		return;
	j->awake = world->awake_joints.count;
	((int32_t *)world->awake_joints.data)[world->awake_joints.count++] = joint;
}

void cni_joint_leave_awake_list(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t *list = (int32_t *)world->awake_joints.data;
	int32_t last;
	if (j->awake == CNI_NONE)
		return;
	last = list[--world->awake_joints.count];
	list[j->awake] = last;
	cni_joint_at(world, last)->awake = j->awake;
	j->awake = CNI_NONE;
}

int32_t cni_joint_count(const cn_world *world, int32_t body)
{
	int32_t key, count = 0;
	for (key = cni_body_at(world, body)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		++count;
	return count;
}

/* Both lists at once, so that the shorter one ends it. */
int32_t cni_joint_forbids(const cn_world *world, int32_t body_a, int32_t body_b)
{
	int32_t key[2], other[2] = { body_b, body_a }, side = 0;
	key[0] = cni_body_at(world, body_a)->joint_first;
	key[1] = cni_body_at(world, body_b)->joint_first;
	for (; key[side] != CNI_NONE; side = 1 - side) {
		const cni_joint *j = cni_joint_at(world, key[side] >> 1);
		if (j->body[1 - (key[side] & 1)] == other[side] && !(j->flags & CN_JOINT_COLLIDE))
			return 1;
		key[side] = j->next[key[side] & 1];
	}
	return 0;
}

/* Contacts between two bodies, which a joint now forbids. */
static void end_contacts_between(cn_world *world, int32_t body_a, int32_t body_b)
{
	int32_t key = cni_body_at(world, body_a)->contact_first;
	while (key != CNI_NONE) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t contact = key >> 1, other = c->body[1 - (key & 1)];
		key = c->next[key & 1];
		if (other == body_b)
			cni_contact_destroy(world, contact);
	}
}

/* First shape of the body that has fewer: the side whose list ends first. */
static int32_t first_shape_of_lesser(const cn_world *world, const cni_joint *j)
{
	int32_t first_a = cni_body_at(world, j->body[0])->shape_first, first_b = cni_body_at(world, j->body[1])->shape_first;
	int32_t a = first_a, b = first_b;
	while (a != CNI_NONE && b != CNI_NONE) {
		a = cni_shape_at(world, a)->next;
		b = cni_shape_at(world, b)->next;
	}
	return a == CNI_NONE ? first_a : first_b;
}

static void bodies_look_again(cn_world *world, const cni_joint *j)
{
	int32_t shape = first_shape_of_lesser(world, j);
	for (; shape != CNI_NONE; shape = cni_shape_at(world, shape)->next)
		cni_shape_look_again(world, shape);
}

void cni_joint_link(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t side, enabled = side_is_enabled(world, j, 0) && side_is_enabled(world, j, 1);
	j->awake = CNI_NONE;
	list_link(world, joint, 0);
	list_link(world, joint, 1);
	for (side = 0; side < 2; ++side)
		if (j->body[side] != CNI_NONE)
			cni_body_wake(world, j->body[side]);
	j->linked = enabled && j->type != CN_JOINT_FILTER && side_is_dynamic(world, j, 0) && side_is_dynamic(world, j, 1);
	if (j->linked)
		cni_island_link(world, j->body[0], j->body[1]);
	if (side_is_awake(world, j, 0) || side_is_awake(world, j, 1))
		cni_joint_enter_awake_list(world, joint);
	if (!(j->flags & CN_JOINT_COLLIDE) && j->body[0] != CNI_NONE && j->body[1] != CNI_NONE)
		end_contacts_between(world, j->body[0], j->body[1]);
}

void cni_joint_unlink(cn_world *world, int32_t joint)
{
	cni_joint *j = cni_joint_at(world, joint);
	int32_t side;
	for (side = 0; side < 2; ++side)
		if (j->body[side] != CNI_NONE)
			cni_body_wake(world, j->body[side]);
	cni_joint_leave_awake_list(world, joint);
	list_unlink(world, joint, 0);
	list_unlink(world, joint, 1);
	if (j->linked)
		cni_island_unlink(world, j->body[0], j->body[1]);
	j->linked = 0;
	if (!(j->flags & CN_JOINT_COLLIDE) && j->body[0] != CNI_NONE && j->body[1] != CNI_NONE)
		bodies_look_again(world, j);
}

void cni_joint_destroy(cn_world *world, int32_t joint)
{
	world->constraint_count -= cni_joint_is_constraint(cni_joint_at(world, joint)->type);
	cni_joint_unlink(world, joint);
	cni_handles_release(&world->joint_handles, joint);
}

/* ---- frames ---- */

/* Centre of mass - point, without losing digits far from the origin. */
static cni_vec2 center_from(const cni_body *b, cni_vec2 point)
{
	return cni_v((b->cx - point.x) + b->cx_low, (b->cy - point.y) + b->cy_low);
}

/* Anchor - ground point of a pulley's side; r is from the centre of mass to the anchor. */
static cni_vec2 from_ground(const cni_body *b, const cni_joint *j, int32_t side, cni_vec2 r)
{
	const float *ground = j->p + (side == 0 ? CNI_P_PULLEY_GROUND_A : CNI_P_PULLEY_GROUND_B);
	cni_vec2 point = cni_v(ground[0], ground[1]);
	return b == NULL ? cni_sub(j->anchor[side], point) : cni_add(center_from(b, point), r);
}

static cni_rot side_rotation(const cn_world *world, const cni_joint *j, int32_t side)
{
	cni_rot none = { 1.0f, 0.0f };
	return j->body[side] == CNI_NONE ? none : cni_body_at(world, j->body[side])->q;
}

float cni_joint_frame_angle(const cn_world *world, const cni_joint *j)
{
	const cni_joint_type *type = cni_joint_type_of(j->type);
	cni_rot qa = side_rotation(world, j, 0), qb = side_rotation(world, j, 1), q;
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

void cni_joint_anchors(const cn_world *world, const cni_joint *j, cni_vec2 *out_a, cni_vec2 *out_b)
{
	cni_vec2 *out[2];
	int32_t side;
	out[0] = out_a;
	out[1] = out_b;
	for (side = 0; side < 2; ++side)
		*out[side] = j->body[side] == CNI_NONE ? j->anchor[side]
		             : cni_transform_point(cni_body_transform(cni_body_at(world, j->body[side])), j->anchor[side]);
}

void cni_joint_error(const cn_world *world, const cni_joint *j, float *out_m, float *out_rad)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &f, rows), k;
	float linear_sq = 0.0f, angular = 0.0f;
	for (k = 0; k < count; ++k) {
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

float cni_joint_position_angle(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

cni_row cni_joint_speed_angle(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_row_angular(CNI_ROW_MOTOR, 0, 1.0f, f->ratio);
}

float cni_joint_position_axis(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_dot(cni_joint_axis(j, f), f->d);
}

cni_row cni_joint_speed_axis(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_row_fixed_direction(f, cni_joint_axis(j, f), CNI_ROW_MOTOR, 0, 1.0f);
}

float cni_joint_position_distance(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_length(f->d);
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
	cni_row r = cni_joint_type_of(j->type)->speed_row(j, &f);
	cn_velocity a = side_velocity(world, j, 0), b = side_velocity(world, j, 1);
	return cni_saturate(r.ax * a.linear_mps.x + r.ay * a.linear_mps.y + r.aw * a.angular_radps +
	                    r.bx * b.linear_mps.x + r.by * b.linear_mps.y + r.bw * b.angular_radps);
}

void cni_rows_impulse(const cni_row *rows, int32_t count, cni_vec2 rb, cni_vec2 *out_linear, float *out_angular)
{
	cni_vec2 linear = { 0.0f, 0.0f };
	float angular = 0.0f;
	int32_t k;
	for (k = 0; k < count; ++k) {
		cni_vec2 b = cni_v(rows[k].bx, rows[k].by);
		linear = cni_madd(linear, rows[k].impulse, b);
		/* The part of the angular Jacobian that is not the force's own moment about the centre. */
		angular += rows[k].impulse * (rows[k].bw - cni_cross(rb, b));
	}
	*out_linear = linear;
	*out_angular = angular;
}

void cni_joint_reaction(const cn_world *world, const cni_joint *j, cn_vec2 *out_force, float *out_torque)
{
	cni_joint_frame f = cni_joint_frame_make(world, j);
	cni_row rows[CNI_JOINT_ROWS];
	int32_t count = cni_joint_type_of(j->type)->rows(j, &f, rows), k;
	for (k = 0; k < count; ++k)
		rows[k].impulse = cni_saturate(j->impulse[rows[k].slot] * j->inv_h);
	cni_rows_impulse(rows, count, f.rb, out_force, out_torque);
	*out_force = cni_v(cni_saturate(out_force->x), cni_saturate(out_force->y));
	*out_torque = cni_saturate(*out_torque);
}

/* ---- events ---- */

static cni_array *event_log(cn_world *world)
{
	return world->events.in_step ? &world->events.joint_log : &world->events.joint_pending;
}

int32_t cni_joint_reserve_events(cn_world *world, int32_t count)
{
	cni_array *log = event_log(world);
	return cni_array_reserve(log, &world->memory, log->count + count);
}

int32_t cni_joint_event_log(cn_world *world, int32_t joint, float force, float torque, uint32_t destroyed)
{
	const cni_joint *j = cni_joint_at(world, joint);
	int32_t constraint = cni_joint_is_constraint(j->type), side;
	cni_array *log = event_log(world);
	cn_joint_event *e;
	if (!cni_joint_reserve_events(world, 1))
		return 0;
	e = (cn_joint_event *)log->data + log->count++;
	memset(e, 0, sizeof *e);
	e->joint = constraint ? 0 : cni_joint_handle(world, joint);
	e->constraint = constraint ? cni_joint_handle(world, joint) : 0;
	for (side = 0; side < 2; ++side)
		*(side == 0 ? &e->body_a : &e->body_b) = j->body[side] == CNI_NONE ? 0 : cni_handles_of(&world->body_handles, j->body[side]);
	e->destroyed = destroyed;
	e->force_N = force;
	e->torque_Nm = torque;
	e->user_data = j->user_data;
	return 1;
}
