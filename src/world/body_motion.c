/*
 * world/body_motion.c - public functions on pose, points, velocity, forces and impulses of a body.
 */
#include "world/define.h"

/* ------------------------------------------------------------------ pose and points */

/* Wakes the other bodies of all contacts of a teleported body, touching or not: the next step must check these contacts, and it skips
   contacts of sleeping bodies. */
static void wake_contacts(cn_world *world, int32_t body)
{
	for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1])
		cni_body_wake(world, cni_contact_of_key(world, key)->body[1 - (key & 1)]);
}

/* Ends contacts whose boxes a teleport has moved apart, as the next step would not if the body were put to sleep before it. Requires
   cni_contact_reserve_end. */
static void end_contacts_apart(cn_world *world, int32_t body)
{
	int32_t key = cni_body_at(world, body)->contact_first;
	while (key != CNI_NONE) {
		const cni_contact *c = cni_contact_of_key(world, key);
		int32_t contact = key >> 1, proxy = c->proxy[key & 1];
		key = c->next[key & 1];
		if (cni_aabb_overlap(&cni_proxy_at(world, c->proxy[0])->fat, &cni_proxy_at(world, c->proxy[1])->fat))
			continue;
		cni_contact_destroy(world, contact);
		/* Otherwise boxes that overlap at the last and at the next step would not be a new pair. */
		world->broadphase_ops->touch(world->broadphase, proxy);
	}
}

cn_result cn_body_set_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad)
{
	cn_vec2 position_m = { position_x_m, position_y_m };
	cni_call call = cni_enter(world, __func__);
	int32_t index = cni_body_index(world, body);
	cni_check_body(&call, "body", body);
	cni_check_position(&call, "position_m", position_m);
	cni_check_angle(&call, "angle_rad", angle_rad);
	cni_check_ends_of(&call, world, index);
	if (call.result != CN_OK)
		return call.result;
	wake_contacts(world, index);
	cni_body_wake_neighbours(world, index);
	cni_body_wake(world, index);
	cni_body_set_transform(world, index, position_m, cni_sincos(angle_rad));
	for (int32_t key = cni_body_at(world, index)->joint_first; key != CNI_NONE; key = cni_joint_at(world, key >> 1)->next[key & 1])
		cni_joint_at(world, key >> 1)->apart = 1;
	end_contacts_apart(world, index);
	cni_body_wake_met(world, index);
	cni_body_at(world, index)->flags |= CNI_BODY_AGAIN;
	world->pairs_may_repeat |= CNI_PAIRS_MARKED; /* the boxes may have separated and overlap again */
	return CN_OK;
}

/* A getter a body is how most programs read, so it must not wait for the record where the readback is kept. */
cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out)
{
	if (world == NULL)
		return CN_ERROR_ARGUMENT;
	int32_t index = cni_handles_find(&world->body_handles, body);
	if (index == CNI_NONE || out == NULL)
		return index == CNI_NONE ? CN_ERROR_HANDLE : CN_ERROR_ARGUMENT;
	*out = cni_readback_ask(world) ? cni_readback_at(world, index)->pose : cni_body_pose(cni_body_at(world, index));
	return CN_OK;
}

CNI_DEFINE_GET(body, angle, float, cni_atan2(record->q.s, record->q.c))
CNI_DEFINE_GET(body, center, cn_vec2, cni_v(record->cx + record->cx_low, record->cy + record->cy_low))

CNI_DEFINE_GET_AT(world_point, cni_body_to_world(record, point))
CNI_DEFINE_GET_AT(local_point, cni_body_to_local(record, point))

/* ------------------------------------------------------------------ velocity */

cn_result cn_body_set_velocity(cn_world *world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps)
{
	cn_velocity v = { { linear_x_mps, linear_y_mps }, angular_radps };
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	cni_check_finite2(&call, "linear_mps", v.linear_mps);
	cni_check_finite(&call, "angular_radps", angular_radps);
	cni_check(&call, b == NULL || b->type != CN_BODY_STATIC, CN_ERROR_STATE, "the body is static");
	if (call.result != CN_OK)
		return call.result;
	if (linear_x_mps != 0.0f || linear_y_mps != 0.0f || angular_radps != 0.0f)
		cni_body_wake(world, cni_body_index(world, body));
	cni_body_store_velocity(world, b, v);
	cni_body_kick(world, cni_body_index(world, body));
	return CN_OK;
}

/* Velocity that takes a body to a pose in dt. */
static cn_velocity velocity_to(const cni_body *b, cn_vec2 position, float angle, float dt)
{
	cni_rot q = cni_sincos(angle), turn = cni_rot_between(b->q, q);
	cni_vec2 center = cni_add(position, cni_rotate(q, b->local_center));
	cn_velocity v = { cni_mul(1.0f / dt, cni_body_arm(b, center)), cni_atan2(turn.s, turn.c) / dt };
	return v;
}

cn_result cn_body_set_target_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s)
{
	cn_vec2 position_m = { position_x_m, position_y_m };
	cni_call call = cni_enter(world, __func__);
	const cni_body *b = cni_check_body(&call, "body", body);
	cni_check_position(&call, "position_m", position_m);
	cni_check_angle(&call, "angle_rad", angle_rad);
	cni_check_range(&call, "dt_s", dt_s, 1e-6f, 1.0f);
	cni_check(&call, b == NULL || b->type == CN_BODY_KINEMATIC, CN_ERROR_STATE, "the body is not kinematic");
	if (call.result != CN_OK)
		return call.result;
	cn_velocity v = velocity_to(b, position_m, angle_rad, dt_s);
	return cn_body_set_velocity(world, body, v.linear_mps.x, v.linear_mps.y, v.angular_radps);
}

CNI_DEFINE_GET(body, velocity, cn_velocity, cni_body_velocity(world, record))

static cn_vec2 finite_velocity_at(const cn_world *world, const cni_body *b, cn_vec2 point)
{
	cn_vec2 v = cni_body_velocity_at(world, b, point);
	return cni_v(cni_saturate(v.x), cni_saturate(v.y));
}

CNI_DEFINE_GET_AT(velocity_at, finite_velocity_at(world, record, point))

/* ------------------------------------------------------------------ forces and impulses */

/* Forces and impulses act on enabled dynamic bodies only. */
static int32_t takes_forces(const cni_body *b)
{
	return b->type == CN_BODY_DYNAMIC && (b->flags & CN_BODY_ENABLED);
}

/* A force or an impulse in the body's centre of mass, with its torque. */
typedef struct push {
	cni_body *body; /* NULL: the call has failed */
	cni_vec2 linear;
	float angular;
} push;

static push push_at_center(cni_call *call, cn_body body, const char *field, float x, float y, float angular)
{
	push p = { cni_check_body(call, "body", body), { x, y }, angular };
	cni_check_finite2(call, field, p.linear);
	cni_check_finite(call, field, angular);
	return p;
}

static push push_at(cni_call *call, cn_body body, const char *field, float x, float y, float point_x_m, float point_y_m)
{
	push p = push_at_center(call, body, field, x, y, 0.0f);
	cni_vec2 point_m = { point_x_m, point_y_m };
	cni_check_finite2(call, "point_m", point_m);
	p.angular = p.body != NULL ? cni_cross(cni_body_arm(p.body, point_m), p.linear) : 0.0f;
	return p;
}

/* Adds to the force and torque of the next step; sums of finite numbers may overflow. */
static cn_result add_force(cni_call *call, cn_world *world, cn_body body, push p)
{
	cni_external *d;
	if (call->result != CN_OK || !takes_forces(p.body))
		return call->result;
	d = cni_externals(world) + p.body->awake; /* the dummy has no force */
	cni_vec2 total = cni_add(cni_v(d->ax, d->ay), p.linear);
	float total_torque = d->alpha + p.angular;
	if (!cni_is_finite2(total) || !cni_is_finite(total_torque))
		return cni_refuse(call, CN_ERROR_ARGUMENT, "the sum of forces and torques of this step must stay finite");
	cni_body_wake(world, cni_body_index(world, body));
	d = cni_externals(world) + p.body->awake;
	d->ax = total.x;
	d->ay = total.y;
	d->alpha = total_torque;
	return CN_OK;
}

/* Changes the velocity at once by impulse / mass and angular impulse / inertia, except along locked axes. */
static cn_result add_impulse(cni_call *call, cn_world *world, cn_body body, push p)
{
	cni_body *b = p.body;
	if (call->result != CN_OK || !takes_forces(b))
		return call->result;
	cn_velocity v = cni_body_velocity(world, b);
	v.linear_mps = cni_add(v.linear_mps, cni_v(p.linear.x / b->mass, p.linear.y / b->mass));
	if (b->inertia > 0.0f)
		v.angular_radps += p.angular / b->inertia;
	if (!cni_is_finite2(v.linear_mps) || !cni_is_finite(v.angular_radps))
		return cni_refuse(call, CN_ERROR_ARGUMENT, "the velocity after the impulse must stay finite");
	cni_body_wake(world, cni_body_index(world, body));
	cni_body_store_velocity(world, b, v);
	cni_body_kick(world, cni_body_index(world, body));
	return CN_OK;
}

/* Defines the three functions that apply a force or an impulse: in the centre of mass, at a point, and its torque alone. */
#define DEFINE_APPLY(linear, field, angular, angular_field, add) \
	cn_result cn_body_apply_##linear(cn_world *world, cn_body body, float x, float y) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return add(&call, world, body, push_at_center(&call, body, field, x, y, 0.0f)); \
	} \
	cn_result cn_body_apply_##linear##_at(cn_world *world, cn_body body, float x, float y, float point_x_m, float point_y_m) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return add(&call, world, body, push_at(&call, body, field, x, y, point_x_m, point_y_m)); \
	} \
	cn_result cn_body_apply_##angular(cn_world *world, cn_body body, float turn) \
	{ \
		cni_call call = cni_enter(world, __func__); \
		return add(&call, world, body, push_at_center(&call, body, angular_field, 0.0f, 0.0f, turn)); \
	}

DEFINE_APPLY(force, "force_N", torque, "torque_Nm", add_force)
DEFINE_APPLY(impulse, "impulse_Ns", angular_impulse, "impulse_Nms", add_impulse)
