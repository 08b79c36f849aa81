/*
 * examples/peers/engine_chipmunk.c - Chipmunk 7 as one of the engines: default space, 10 iterations, doubles.
 *
 * It has no revolute joint with limit, motor and spring in one, so those are constraints of their own beside
 * the pivot. Friction of a pair is the product there, so each shape is given the square root. It cannot
 * damp one body's linear velocity, which two bones of a ragdoll ask for: they go without.
 */
#include "peers/engine.h"
#include <chipmunk/chipmunk.h>
#include <math.h>
#include <stdlib.h>

/* Chipmunk has no bodies that never sleep: those are woken before each step. */
typedef struct chipmunk_world {
	cpSpace *space;
	cpBody **restless;
	int32_t restless_count;
	int32_t restless_capacity;
	int32_t sleep;
} chipmunk_world;

static cpVect vec(peer_vec v) { return cpv((cpFloat)v.x, (cpFloat)v.y); }
static cpBody *body_of(peer_handle handle) { return (cpBody *)(uintptr_t)handle; }

static void *create(const peer_world_def *def)
{
	chipmunk_world *world = def->workers == 1 ? (chipmunk_world *)calloc(1, sizeof *world) : NULL;
	if (world == NULL)
		return NULL;
	world->space = cpSpaceNew();
	world->sleep = def->sleep;
	cpSpaceSetGravity(world->space, vec(def->gravity));
	if (def->sleep) {
		/* As the others: without gravity its own threshold would be 0. */
		cpSpaceSetSleepTimeThreshold(world->space, 0.5);
		cpSpaceSetIdleSpeedThreshold(world->space, 0.05);
	}
	return world;
}

static int32_t keep_awake(chipmunk_world *world, cpBody *body)
{
	if (world->restless_count == world->restless_capacity) {
		int32_t capacity = 2 * world->restless_capacity + 16;
		cpBody **grown = (cpBody **)realloc(world->restless, (size_t)capacity * sizeof *grown);
		if (grown == NULL)
			return 0;
		world->restless = grown;
		world->restless_capacity = capacity;
	}
	world->restless[world->restless_count++] = body;
	return 1;
}

static int32_t add_body(void *world, const peer_body_def *def, peer_handle *out)
{
	chipmunk_world *w = (chipmunk_world *)world;
	cpBody *body = def->flags & PEER_DYNAMIC ? cpBodyNew(0.0, 0.0) : cpBodyNewStatic();
	cpBodySetPosition(body, vec(def->position));
	if (def->flags & PEER_DYNAMIC)
		cpBodySetVelocity(body, vec(def->velocity));
	cpSpaceAddBody(w->space, body);
	*out = (peer_handle)(uintptr_t)body;
	return !(w->sleep && (def->flags & PEER_NEVER_SLEEPS)) || keep_awake(w, body);
}

/* ------------------------------------------------------------------ shapes */

static void finish_shape(cpSpace *space, cpShape *shape, const peer_shape_def *def)
{
	cpGroup group = def->group < 0 ? (cpGroup)(-(int64_t)def->group) : CP_NO_GROUP;
	cpShapeSetFriction(shape, sqrt((cpFloat)def->friction));
	cpShapeSetElasticity(shape, sqrt((cpFloat)def->restitution));
	cpShapeSetFilter(shape, cpShapeFilterNew(group, def->category, def->mask));
	if (cpBodyGetType(cpShapeGetBody(shape)) == CP_BODY_TYPE_DYNAMIC)
		cpShapeSetDensity(shape, (cpFloat)def->density);
	cpSpaceAddShape(space, shape);
}

/* Segments that know their neighbours. The ends of an open chain have none. */
static void add_chain(cpSpace *space, cpBody *body, const peer_shape_def *def)
{
	int32_t count = def->count, loop = def->kind == PEER_LOOP;
	for (int32_t i = 0; i < count - !loop; ++i) {
		peer_vec a = def->points[i], b = def->points[(i + 1) % count];
		peer_vec before = loop || i > 0 ? def->points[(i + count - 1) % count] : a;
		peer_vec after = loop || i + 2 < count ? def->points[(i + 2) % count] : b;
		cpShape *shape = cpSegmentShapeNew(body, vec(a), vec(b), 0.0);
		cpSegmentShapeSetNeighbors(shape, vec(before), vec(after));
		finish_shape(space, shape, def);
	}
}

static cpShape *new_polygon(cpBody *body, const peer_shape_def *def)
{
	cpVect points[PEER_POLYGON_MAX];
	for (int32_t i = 0; i < def->count; ++i)
		points[i] = vec(def->points[i]);
	return cpPolyShapeNew(body, def->count, points, cpTransformIdentity, (cpFloat)def->radius);
}

static cpShape *new_shape(cpBody *body, const peer_shape_def *def)
{
	switch (def->kind) {
	case PEER_CIRCLE: return cpCircleShapeNew(body, (cpFloat)def->radius, vec(def->points[0]));
	case PEER_POLYGON: return new_polygon(body, def);
	default: return cpSegmentShapeNew(body, vec(def->points[0]), vec(def->points[1]), (cpFloat)def->radius);
	}
}

static int32_t add_shape(void *world, peer_handle body, const peer_shape_def *def)
{
	cpSpace *space = ((chipmunk_world *)world)->space;
	if (def->kind == PEER_CHAIN || def->kind == PEER_LOOP)
		add_chain(space, body_of(body), def);
	else
		finish_shape(space, new_shape(body_of(body), def), def);
	return 1;
}

/* ------------------------------------------------------------------ joints */

static void add_constraint(cpSpace *space, cpConstraint *constraint)
{
	cpConstraintSetCollideBodies(constraint, cpFalse);
	cpSpaceAddConstraint(space, constraint);
}

/* Stiffness and damping of a spring of this frequency between the two inertias. */
static cpConstraint *new_spring(cpBody *a, cpBody *b, const peer_joint_def *def)
{
	cpFloat inverse = (cpBodyGetType(a) == CP_BODY_TYPE_DYNAMIC ? 1.0 / cpBodyGetMoment(a) : 0.0) +
		(cpBodyGetType(b) == CP_BODY_TYPE_DYNAMIC ? 1.0 / cpBodyGetMoment(b) : 0.0);
	cpFloat omega = 2.0 * CP_PI * (cpFloat)def->spring_hertz;
	cpFloat stiffness = omega * omega / inverse, damping = 2.0 * (cpFloat)def->spring_damping_ratio * omega / inverse;
	return cpDampedRotarySpringNew(a, b, -(cpFloat)def->reference, stiffness, damping);
}

static int32_t add_joint(void *world, peer_handle handle_a, peer_handle handle_b, const peer_joint_def *def)
{
	cpSpace *space = ((chipmunk_world *)world)->space;
	cpBody *ground = cpSpaceGetStaticBody(space);
	cpBody *a = handle_a != 0 ? body_of(handle_a) : ground, *b = handle_b != 0 ? body_of(handle_b) : ground;
	cpFloat reference = (cpFloat)def->reference;
	add_constraint(space, cpPivotJointNew2(a, b, vec(def->anchor_a), vec(def->anchor_b)));
	if (def->flags & PEER_LIMIT)
		add_constraint(space, cpRotaryLimitJointNew(a, b, reference + (cpFloat)def->lower, reference + (cpFloat)def->upper));
	if (def->flags & PEER_MOTOR) {
		cpConstraint *motor = cpSimpleMotorNew(a, b, -(cpFloat)def->motor_speed);
		cpConstraintSetMaxForce(motor, (cpFloat)def->motor_torque);
		add_constraint(space, motor);
	}
	if (def->flags & PEER_SPRING)
		add_constraint(space, new_spring(a, b, def));
	return 1;
}

/* ------------------------------------------------------------------ life and death, steps */

static void drop_shape(cpBody *body, cpShape *shape, void *space)
{
	(void)body;
	cpSpaceRemoveShape((cpSpace *)space, shape);
	cpShapeFree(shape);
}

static void drop_constraint(cpBody *body, cpConstraint *constraint, void *space)
{
	(void)body;
	cpSpaceRemoveConstraint((cpSpace *)space, constraint);
	cpConstraintFree(constraint);
}

static void drop_body(cpBody *body, void *space)
{
	cpBodyEachConstraint(body, drop_constraint, space);
	cpBodyEachShape(body, drop_shape, space);
	cpSpaceRemoveBody((cpSpace *)space, body);
	cpBodyFree(body);
}

static void remove_body(void *world, peer_handle body) { drop_body(body_of(body), ((chipmunk_world *)world)->space); }

typedef struct body_list {
	cpBody **items;
	int32_t count;
	int32_t capacity;
} body_list;

static void list_body(cpBody *body, void *data)
{
	body_list *list = (body_list *)data;
	if (list->count == list->capacity) {
		int32_t capacity = 2 * list->capacity + 64;
		cpBody **grown = (cpBody **)realloc(list->items, (size_t)capacity * sizeof *grown);
		if (grown == NULL)
			return;
		list->items = grown;
		list->capacity = capacity;
	}
	list->items[list->count++] = body;
}

static void destroy(void *world)
{
	chipmunk_world *w = (chipmunk_world *)world;
	body_list list = {NULL, 0, 0};
	cpSpaceEachBody(w->space, list_body, &list);
	for (int32_t i = 0; i < list.count; ++i)
		drop_body(list.items[i], w->space);
	cpSpaceFree(w->space);
	free(list.items);
	free(w->restless);
	free(w);
}

static void fall_asleep(void *world, peer_handle body)
{
	if (((chipmunk_world *)world)->sleep)
		cpBodySleep(body_of(body));
}

static void step(void *world, float dt)
{
	chipmunk_world *w = (chipmunk_world *)world;
	for (int32_t i = 0; i < w->restless_count; ++i)
		cpBodyActivate(w->restless[i]);
	cpSpaceStep(w->space, (cpFloat)dt);
}

static void read_pose(void *world, peer_handle body, peer_pose *out)
{
	cpVect position = cpBodyGetPosition(body_of(body));
	(void)world;
	out->x = (double)position.x;
	out->y = (double)position.y;
	out->angle = (double)cpBodyGetAngle(body_of(body));
}

const peer_engine peer_engine_chipmunk = {"Chipmunk 7", "default space, 10 iterations, no substeps, doubles, 1 thread", create, destroy, add_body,
	add_shape, add_joint, fall_asleep, remove_body, step, read_pose};
