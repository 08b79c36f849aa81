/*
 * examples/peers/engine_box2d.c - Box2D 3.2 as one of the engines: default world, 4 substeps; several workers are threads of its own.
 * Its headers need C17.
 */
#include "peers/engine.h"
#include <box2d/box2d.h>
#include <stdlib.h>

#define SUBSTEPS 4

typedef struct box2d_world {
	b2WorldId id;
	b2BodyId ground; /* for joints with the world */
} box2d_world;

static b2Vec2 vec(peer_vec v)
{
	b2Vec2 out = {v.x, v.y};
	return out;
}

static void *create(const peer_world_def *def)
{
	box2d_world *world = (box2d_world *)malloc(sizeof *world);
	if (world == NULL)
		return NULL;
	b2WorldDef world_def = b2DefaultWorldDef();
	world_def.gravity = vec(def->gravity);
	world_def.enableSleep = def->sleep != 0;
	world_def.workerCount = def->workers;
	world->id = b2CreateWorld(&world_def);
	b2BodyDef ground = b2DefaultBodyDef();
	world->ground = b2CreateBody(world->id, &ground);
	return world;
}

static void destroy(void *world)
{
	b2DestroyWorld(((box2d_world *)world)->id);
	free(world);
}

static int32_t add_body(void *world, const peer_body_def *def, peer_handle *out)
{
	b2BodyDef body_def = b2DefaultBodyDef();
	body_def.type = def->flags & PEER_DYNAMIC ? b2_dynamicBody : b2_staticBody;
	body_def.position.x = def->position.x;
	body_def.position.y = def->position.y;
	body_def.linearVelocity = vec(def->velocity);
	body_def.linearDamping = def->linear_damping;
	body_def.enableSleep = (def->flags & PEER_NEVER_SLEEPS) == 0;
	body_def.isAwake = (def->flags & PEER_ASLEEP) == 0;
	*out = b2StoreBodyId(b2CreateBody(((box2d_world *)world)->id, &body_def));
	return 1;
}

/* ------------------------------------------------------------------ shapes */

static b2Filter filter_of(const peer_shape_def *def)
{
	b2Filter filter = b2DefaultFilter();
	filter.categoryBits = def->category;
	/* Bits that no peer_shape_def names stay on. */
	filter.maskBits = def->mask == UINT32_MAX ? UINT64_MAX : def->mask;
	filter.groupIndex = def->group;
	return filter;
}

static b2SurfaceMaterial material_of(const peer_shape_def *def)
{
	b2SurfaceMaterial material = b2DefaultSurfaceMaterial();
	material.friction = def->friction;
	material.restitution = def->restitution;
	return material;
}

static int32_t add_polygon(b2BodyId body, const b2ShapeDef *on, const peer_shape_def *def)
{
	b2Vec2 points[PEER_POLYGON_MAX];
	for (int32_t i = 0; i < def->count; ++i)
		points[i] = vec(def->points[i]);
	b2Hull hull = b2ComputeHull(points, def->count);
	b2Polygon polygon = b2MakePolygon(&hull, def->radius);
	if (hull.count == 0)
		return 0;
	b2CreatePolygonShape(body, on, &polygon);
	return 1;
}

/* An open chain's first and last edges only guide: scenes know and make them long and out of reach. */
static int32_t add_chain(b2BodyId body, const peer_shape_def *def)
{
	b2ChainDef chain = b2DefaultChainDef();
	b2SurfaceMaterial material = material_of(def);
	b2Vec2 *points = (b2Vec2 *)malloc((size_t)def->count * sizeof *points);
	if (points == NULL)
		return 0;
	for (int32_t i = 0; i < def->count; ++i)
		points[i] = vec(def->points[i]);
	chain.points = points;
	chain.count = def->count;
	chain.materials = &material;
	chain.materialCount = 1;
	chain.filter = filter_of(def);
	chain.isLoop = def->kind == PEER_LOOP;
	b2CreateChain(body, &chain);
	free(points);
	return 1;
}

static int32_t add_shape(void *world, peer_handle handle, const peer_shape_def *def)
{
	b2BodyId body = b2LoadBodyId(handle);
	b2ShapeDef on = b2DefaultShapeDef();
	b2Circle circle = {vec(def->points[0]), def->radius};
	b2Capsule capsule = {vec(def->points[0]), vec(def->points[def->count > 1]), def->radius};
	b2Segment segment = {capsule.center1, capsule.center2};
	(void)world;
	on.density = def->density;
	on.material = material_of(def);
	on.filter = filter_of(def);
	switch (def->kind) {
	case PEER_CIRCLE: b2CreateCircleShape(body, &on, &circle); return 1;
	case PEER_CAPSULE: b2CreateCapsuleShape(body, &on, &capsule); return 1;
	case PEER_EDGE: b2CreateSegmentShape(body, &on, &segment); return 1;
	case PEER_POLYGON: return add_polygon(body, &on, def);
	default: return add_chain(body, def);
	}
}

/* ------------------------------------------------------------------ joints, steps */

static int32_t add_joint(void *world, peer_handle a, peer_handle b, const peer_joint_def *def)
{
	box2d_world *w = (box2d_world *)world;
	b2RevoluteJointDef joint = b2DefaultRevoluteJointDef();
	joint.base.bodyIdA = a != 0 ? b2LoadBodyId(a) : w->ground;
	joint.base.bodyIdB = b != 0 ? b2LoadBodyId(b) : w->ground;
	joint.base.localFrameA.p = vec(def->anchor_a);
	joint.base.localFrameA.q = b2MakeRot(def->reference);
	joint.base.localFrameB.p = vec(def->anchor_b);
	joint.enableLimit = (def->flags & PEER_LIMIT) != 0;
	joint.lowerAngle = def->lower;
	joint.upperAngle = def->upper;
	joint.enableMotor = (def->flags & PEER_MOTOR) != 0;
	joint.motorSpeed = def->motor_speed;
	joint.maxMotorTorque = def->motor_torque;
	joint.enableSpring = (def->flags & PEER_SPRING) != 0;
	joint.hertz = def->spring_hertz;
	joint.dampingRatio = def->spring_damping_ratio;
	b2CreateRevoluteJoint(w->id, &joint);
	return 1;
}

static void remove_body(void *world, peer_handle body)
{
	(void)world;
	b2DestroyBody(b2LoadBodyId(body));
}

static void step(void *world, float dt) { b2World_Step(((box2d_world *)world)->id, dt, SUBSTEPS); }

static void read_pose(void *world, peer_handle body, peer_pose *out)
{
	b2WorldTransform transform = b2Body_GetTransform(b2LoadBodyId(body));
	(void)world;
	out->x = (double)transform.p.x;
	out->y = (double)transform.p.y;
	out->angle = (double)b2Rot_GetAngle(transform.q);
}

const peer_engine peer_engine_box2d = {"Box2D 3.2", "default world, 4 substeps, 1 worker", create, destroy, add_body, add_shape, add_joint, NULL,
	remove_body, step, read_pose};
