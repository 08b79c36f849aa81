/*
 * test/stability/chart/peer_box2d.c - the calls of the stability suite on Box2D 3.2: default world, one worker, the
 * suite's substeps. Its headers need C17.
 */
#include "peer.h"

#include <box2d/box2d.h>
#include <stdlib.h>

#define CONTACTS_MAX 256

const char peer_name[] = "Box2D 3.2";
const int32_t peer_substeps_default = 4;

struct cn_world {
	b2WorldId id;
	b2BodyId ground; /* for joints with the world */
	peer_list bodies, joints;
	int32_t substeps;
};

static b2Vec2 vec(cn_vec2 v)
{
	b2Vec2 out = {v.x, v.y};
	return out;
}

static b2BodyId body_of(const cn_world *world, cn_body handle)
{
	uint64_t stored = peer_find(&world->bodies, handle);
	return stored == 0 ? world->ground : b2LoadBodyId(stored);
}

static cn_body handle_of(b2ShapeId shape) { return (cn_body)(uintptr_t)b2Body_GetUserData(b2Shape_GetBody(shape)); }

/* ---- world ---- */

cn_result cn_world_create(const cn_world_def *def, cn_world **out_world)
{
	b2WorldDef world_def = b2DefaultWorldDef();
	b2BodyDef ground = b2DefaultBodyDef();
	cn_world *world = calloc(1, sizeof *world);
	if (world == NULL)
		return CN_ERROR_MEMORY;
	world_def.gravity = vec(def->gravity_mps2);
	world_def.enableSleep = (def->flags & CN_WORLD_SLEEP) != 0;
	world->id = b2CreateWorld(&world_def);
	world->ground = b2CreateBody(world->id, &ground);
	world->substeps = def->substep_count;
	*out_world = world;
	return CN_OK;
}

void cn_world_destroy(cn_world *world)
{
	if (world == NULL)
		return;
	b2DestroyWorld(world->id);
	free(world->bodies.items);
	free(world->joints.items);
	free(world);
}

cn_result cn_world_step(cn_world *world, float dt_s)
{
	b2World_Step(world->id, dt_s, world->substeps);
	return CN_OK;
}

/* ---- bodies ---- */

cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body)
{
	b2BodyDef body_def = b2DefaultBodyDef();
	b2BodyId body;
	body_def.type = def->type == CN_BODY_DYNAMIC ? b2_dynamicBody : b2_staticBody;
	body_def.position.x = def->position_m.x;
	body_def.position.y = def->position_m.y;
	body_def.rotation = b2MakeRot(def->angle_rad);
	body_def.isBullet = (def->flags & CN_BODY_BULLET) != 0;
	body = b2CreateBody(world->id, &body_def);
	*out_body = peer_keep(&world->bodies, b2StoreBodyId(body));
	b2Body_SetUserData(body, (void *)(uintptr_t)*out_body);
	return CN_OK;
}

cn_result cn_body_set_velocity(cn_world *world, cn_body body, float vx_mps, float vy_mps, float angular_radps)
{
	b2Vec2 velocity = {vx_mps, vy_mps};
	b2Body_SetLinearVelocity(body_of(world, body), velocity);
	b2Body_SetAngularVelocity(body_of(world, body), angular_radps);
	return CN_OK;
}

cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out)
{
	b2WorldTransform transform = b2Body_GetTransform(body_of(world, body));
	out->position_m.x = (float)transform.p.x;
	out->position_m.y = (float)transform.p.y;
	out->cosine = transform.q.c;
	out->sine = transform.q.s;
	return CN_OK;
}

cn_result cn_body_get_center(const cn_world *world, cn_body body, cn_vec2 *out_m)
{
	b2Pos center = b2Body_GetWorldCenter(body_of(world, body));
	out_m->x = (float)center.x;
	out_m->y = (float)center.y;
	return CN_OK;
}

cn_result cn_body_get_velocity(const cn_world *world, cn_body body, cn_velocity *out)
{
	b2Vec2 velocity = b2Body_GetLinearVelocity(body_of(world, body));
	out->linear_mps.x = velocity.x;
	out->linear_mps.y = velocity.y;
	out->angular_radps = b2Body_GetAngularVelocity(body_of(world, body));
	return CN_OK;
}

cn_result cn_body_get_mass_data(const cn_world *world, cn_body body, cn_mass_data *out)
{
	b2MassData mass = b2Body_GetMassData(body_of(world, body));
	out->mass_kg = mass.mass;
	out->inertia_kgm2 = mass.rotationalInertia;
	out->center_m.x = mass.center.x;
	out->center_m.y = mass.center.y;
	return CN_OK;
}

/* The bodies that touch this one; the suite asks for nothing else of a contact. */
cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	b2ContactData contacts[CONTACTS_MAX];
	int32_t k, count = b2Body_GetContactData(body_of(world, body), contacts, CONTACTS_MAX);
	for (k = 0; k < count && k < capacity; ++k) {
		out[k].body_a = handle_of(contacts[k].shapeIdA);
		out[k].body_b = handle_of(contacts[k].shapeIdB);
	}
	*out_count = count;
	return CN_OK;
}

/* ---- shapes ---- */

static b2ShapeDef surface(const cn_shape_def *def)
{
	b2ShapeDef out = b2DefaultShapeDef();
	out.density = def->density_kgpm2;
	out.material.friction = def->material.dynamic_friction;
	out.material.restitution = def->material.restitution;
	out.filter.groupIndex = def->filter.group;
	return out;
}

cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape)
{
	b2Circle shape = {vec(circle->center_m), circle->radius_m};
	b2ShapeDef on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK)
		b2CreateCircleShape(body_of(world, def->body), &on, &shape);
	return result;
}

cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape)
{
	b2Capsule shape = {vec(capsule->a_m), vec(capsule->b_m), capsule->radius_m};
	b2ShapeDef on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK)
		b2CreateCapsuleShape(body_of(world, def->body), &on, &shape);
	return result;
}

cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	b2Vec2 points[B2_MAX_POLYGON_VERTICES];
	b2ShapeDef on = surface(def);
	b2Polygon shape;
	b2Hull hull;
	int32_t k;
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result != CN_OK || polygon->count > B2_MAX_POLYGON_VERTICES)
		return result != CN_OK ? result : peer_refuse("too many points");
	for (k = 0; k < polygon->count; ++k)
		points[k] = vec(polygon->points_m[k]);
	hull = b2ComputeHull(points, polygon->count);
	if (hull.count == 0)
		return peer_refuse("Box2D finds no hull");
	shape = b2MakePolygon(&hull, polygon->radius_m);
	b2CreatePolygonShape(body_of(world, def->body), &on, &shape);
	return CN_OK;
}

cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape)
{
	b2Polygon shape = radius_m > 0.0f ? b2MakeRoundedBox(half_width_m, half_height_m, radius_m) : b2MakeBox(half_width_m, half_height_m);
	b2ShapeDef on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK)
		b2CreatePolygonShape(body_of(world, def->body), &on, &shape);
	return result;
}

/* ---- joints ---- */

static void set_base(const cn_world *world, b2JointDef *out, const cn_joint_base *base, float reference_angle_rad)
{
	out->bodyIdA = body_of(world, base->body_a);
	out->bodyIdB = body_of(world, base->body_b);
	out->localFrameA.p = vec(base->anchor_a_m);
	out->localFrameA.q = b2MakeRot(reference_angle_rad);
	out->localFrameB.p = vec(base->anchor_b_m);
	out->collideConnected = (base->flags & CN_JOINT_COLLIDE) != 0;
}

cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint)
{
	b2RevoluteJointDef joint = b2DefaultRevoluteJointDef();
	set_base(world, &joint.base, &def->base, def->reference_angle_rad);
	joint.enableLimit = (def->base.flags & CN_JOINT_LIMIT) != 0;
	joint.lowerAngle = def->lower_angle_rad;
	joint.upperAngle = def->upper_angle_rad;
	joint.enableMotor = (def->base.flags & CN_JOINT_MOTOR) != 0;
	joint.motorSpeed = def->motor_speed_radps;
	joint.maxMotorTorque = def->motor_torque_max_Nm;
	*out_joint = peer_keep(&world->joints, b2StoreJointId(b2CreateRevoluteJoint(world->id, &joint)));
	return CN_OK;
}

cn_result cn_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint)
{
	b2WeldJointDef joint = b2DefaultWeldJointDef();
	set_base(world, &joint.base, &def->base, def->reference_angle_rad);
	*out_joint = peer_keep(&world->joints, b2StoreJointId(b2CreateWeldJoint(world->id, &joint)));
	return CN_OK;
}

cn_result cn_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint)
{
	b2DistanceJointDef joint = b2DefaultDistanceJointDef();
	set_base(world, &joint.base, &def->base, 0.0f);
	joint.length = def->length_m;
	joint.enableSpring = (def->base.flags & CN_JOINT_SPRING) != 0;
	joint.hertz = def->spring_hertz;
	joint.dampingRatio = def->spring_damping_ratio;
	joint.enableLimit = (def->base.flags & CN_JOINT_LIMIT) != 0;
	joint.minLength = def->length_min_m;
	joint.maxLength = def->length_max_m;
	*out_joint = peer_keep(&world->joints, b2StoreJointId(b2CreateDistanceJoint(world->id, &joint)));
	return CN_OK;
}

/* Box2D slides along the x axis of frame a. */
static void turn_frames(b2JointDef *joint, cn_vec2 axis, float reference_angle_rad)
{
	float angle = b2Atan2(axis.y, axis.x);
	joint->localFrameA.q = b2MakeRot(angle);
	joint->localFrameB.q = b2MakeRot(angle - reference_angle_rad);
}

cn_result cn_joint_create_prismatic(cn_world *world, const cn_prismatic_def *def, cn_joint *out_joint)
{
	b2PrismaticJointDef joint = b2DefaultPrismaticJointDef();
	set_base(world, &joint.base, &def->base, 0.0f);
	turn_frames(&joint.base, def->axis, def->reference_angle_rad);
	joint.enableLimit = (def->base.flags & CN_JOINT_LIMIT) != 0;
	joint.lowerTranslation = def->lower_m;
	joint.upperTranslation = def->upper_m;
	joint.enableMotor = (def->base.flags & CN_JOINT_MOTOR) != 0;
	joint.motorSpeed = def->motor_speed_mps;
	joint.maxMotorForce = def->motor_force_max_N;
	*out_joint = peer_keep(&world->joints, b2StoreJointId(b2CreatePrismaticJoint(world->id, &joint)));
	return CN_OK;
}

cn_result cn_joint_create_wheel(cn_world *world, const cn_wheel_def *def, cn_joint *out_joint)
{
	b2WheelJointDef joint = b2DefaultWheelJointDef();
	set_base(world, &joint.base, &def->base, 0.0f);
	turn_frames(&joint.base, def->axis, 0.0f);
	joint.enableSpring = (def->base.flags & CN_JOINT_SPRING) != 0;
	joint.hertz = def->spring_hertz;
	joint.dampingRatio = def->spring_damping_ratio;
	joint.enableLimit = (def->base.flags & CN_JOINT_LIMIT) != 0;
	joint.lowerTranslation = def->lower_m;
	joint.upperTranslation = def->upper_m;
	joint.enableMotor = (def->base.flags & CN_JOINT_MOTOR) != 0;
	joint.motorSpeed = def->motor_speed_radps;
	joint.maxMotorTorque = def->motor_torque_max_Nm;
	*out_joint = peer_keep(&world->joints, b2StoreJointId(b2CreateWheelJoint(world->id, &joint)));
	return CN_OK;
}

static cn_vec2 anchor_of(b2BodyId body, b2Transform frame)
{
	b2Pos at = b2Body_GetWorldPoint(body, frame.p);
	cn_vec2 out;
	out.x = (float)at.x;
	out.y = (float)at.y;
	return out;
}

cn_result cn_joint_get_anchors(const cn_world *world, cn_joint joint, cn_vec2 *out_world_a_m, cn_vec2 *out_world_b_m)
{
	b2JointId id = b2LoadJointId(peer_find(&world->joints, joint));
	*out_world_a_m = anchor_of(b2Joint_GetBodyA(id), b2Joint_GetLocalFrameA(id));
	*out_world_b_m = anchor_of(b2Joint_GetBodyB(id), b2Joint_GetLocalFrameB(id));
	return CN_OK;
}
