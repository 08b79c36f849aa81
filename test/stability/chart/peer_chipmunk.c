/*
 * test/stability/chart/peer_chipmunk.c - the calls of the stability suite on Chipmunk 7: default space, 10 iterations a
 * step, doubles. It has no substeps: a frame is cut into as many steps. A weld is a pivot and a gear of ratio 1.
 *
 * Friction of a pair is the product there, so each shape is given the square root. Restitution is the product too;
 * where there is any, the greater is put in by a callback.
 */
#include "peer.h"

#include <chipmunk/chipmunk.h>
#include <math.h>
#include <stdlib.h>

const char peer_name[] = "Chipmunk 7";
const int32_t peer_substeps_default = 1;

struct cn_world {
	cpSpace *space;
	peer_list bodies, joints, shapes, constraints;
	int32_t substeps;
};

static cpVect vec(cn_vec2 v) { return cpv((cpFloat)v.x, (cpFloat)v.y); }

static cn_vec2 back(cpVect v)
{
	cn_vec2 out;
	out.x = (float)v.x;
	out.y = (float)v.y;
	return out;
}

static cpBody *body_of(const cn_world *world, cn_body handle)
{
	uint64_t stored = peer_find(&world->bodies, handle);
	return stored == 0 ? cpSpaceGetStaticBody(world->space) : (cpBody *)(uintptr_t)stored;
}

/* ---- world ---- */

cn_result cn_world_create(const cn_world_def *def, cn_world **out_world)
{
	cn_world *world = calloc(1, sizeof *world);
	if (world == NULL)
		return CN_ERROR_MEMORY;
	world->space = cpSpaceNew();
	cpSpaceSetGravity(world->space, vec(def->gravity_mps2));
	if (def->flags & CN_WORLD_SLEEP)
		cpSpaceSetSleepTimeThreshold(world->space, 0.5);
	world->substeps = def->substep_count;
	*out_world = world;
	return CN_OK;
}

void cn_world_destroy(cn_world *world)
{
	int32_t k;
	if (world == NULL)
		return;
	for (k = 0; k < world->constraints.count; ++k) {
		cpConstraint *constraint = (cpConstraint *)(uintptr_t)world->constraints.items[k];
		cpSpaceRemoveConstraint(world->space, constraint);
		cpConstraintFree(constraint);
	}
	for (k = 0; k < world->shapes.count; ++k) {
		cpShape *shape = (cpShape *)(uintptr_t)world->shapes.items[k];
		cpSpaceRemoveShape(world->space, shape);
		cpShapeFree(shape);
	}
	for (k = 0; k < world->bodies.count; ++k) {
		cpBody *body = (cpBody *)(uintptr_t)world->bodies.items[k];
		cpSpaceRemoveBody(world->space, body);
		cpBodyFree(body);
	}
	cpSpaceFree(world->space);
	free(world->bodies.items);
	free(world->joints.items);
	free(world->shapes.items);
	free(world->constraints.items);
	free(world);
}

cn_result cn_world_step(cn_world *world, float dt_s)
{
	int32_t k;
	for (k = 0; k < world->substeps; ++k)
		cpSpaceStep(world->space, (cpFloat)dt_s / (cpFloat)world->substeps);
	return CN_OK;
}

/* ---- bodies ---- */

cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body)
{
	cpBody *body = def->type == CN_BODY_DYNAMIC ? cpBodyNew(0.0, 0.0) : cpBodyNewStatic();
	cpBodySetPosition(body, vec(def->position_m));
	cpBodySetAngle(body, (cpFloat)def->angle_rad);
	cpSpaceAddBody(world->space, body);
	*out_body = peer_keep(&world->bodies, (uint64_t)(uintptr_t)body);
	cpBodySetUserData(body, (cpDataPointer)(uintptr_t)*out_body);
	return CN_OK;
}

cn_result cn_body_set_velocity(cn_world *world, cn_body body, float vx_mps, float vy_mps, float angular_radps)
{
	cpBodySetVelocity(body_of(world, body), cpv((cpFloat)vx_mps, (cpFloat)vy_mps));
	cpBodySetAngularVelocity(body_of(world, body), (cpFloat)angular_radps);
	return CN_OK;
}

cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out)
{
	cpFloat angle = cpBodyGetAngle(body_of(world, body));
	out->position_m = back(cpBodyGetPosition(body_of(world, body)));
	out->cosine = (float)cos(angle);
	out->sine = (float)sin(angle);
	return CN_OK;
}

cn_result cn_body_get_center(const cn_world *world, cn_body body, cn_vec2 *out_m)
{
	cpBody *at = body_of(world, body);
	*out_m = back(cpBodyLocalToWorld(at, cpBodyGetCenterOfGravity(at)));
	return CN_OK;
}

cn_result cn_body_get_velocity(const cn_world *world, cn_body body, cn_velocity *out)
{
	out->linear_mps = back(cpBodyGetVelocity(body_of(world, body)));
	out->angular_radps = (float)cpBodyGetAngularVelocity(body_of(world, body));
	return CN_OK;
}

cn_result cn_body_get_mass_data(const cn_world *world, cn_body body, cn_mass_data *out)
{
	cpBody *of = body_of(world, body);
	out->mass_kg = (float)cpBodyGetMass(of);
	out->inertia_kgm2 = (float)cpBodyGetMoment(of);
	out->center_m = back(cpBodyGetCenterOfGravity(of));
	return CN_OK;
}

typedef struct contact_list {
	cn_contact_event *out;
	int32_t count, capacity;
} contact_list;

static void list_contact(cpBody *body, cpArbiter *arbiter, void *data)
{
	contact_list *list = data;
	cpBody *a, *b;
	(void)body;
	cpArbiterGetBodies(arbiter, &a, &b);
	if (list->count < list->capacity) {
		list->out[list->count].body_a = (cn_body)(uintptr_t)cpBodyGetUserData(a);
		list->out[list->count].body_b = (cn_body)(uintptr_t)cpBodyGetUserData(b);
	}
	++list->count;
}

/* The bodies that touch this one; the suite asks for nothing else of a contact. */
cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	contact_list list = {out, 0, capacity};
	cpBodyEachArbiter(body_of(world, body), list_contact, &list);
	*out_count = list.count;
	return CN_OK;
}

/* ---- shapes ---- */

static cpBool take_greater_restitution(cpArbiter *arbiter, cpSpace *space, cpDataPointer data)
{
	cpShape *a, *b;
	(void)space, (void)data;
	cpArbiterGetShapes(arbiter, &a, &b);
	cpArbiterSetRestitution(arbiter, cpfmax(cpShapeGetElasticity(a), cpShapeGetElasticity(b)));
	return cpTrue;
}

static cn_result add_shape(cn_world *world, const cn_shape_def *def, cpShape *shape)
{
	cn_result result = peer_check_shape(def);
	if (result != CN_OK) {
		cpShapeFree(shape);
		return result;
	}
	cpShapeSetFriction(shape, sqrt((cpFloat)def->material.dynamic_friction));
	cpShapeSetElasticity(shape, (cpFloat)def->material.restitution);
	cpShapeSetFilter(shape, cpShapeFilterNew((cpGroup)-def->filter.group, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
	if (cpBodyGetType(cpShapeGetBody(shape)) == CP_BODY_TYPE_DYNAMIC)
		cpShapeSetDensity(shape, (cpFloat)def->density_kgpm2);
	if (def->material.restitution > 0.0f)
		cpSpaceAddDefaultCollisionHandler(world->space)->preSolveFunc = take_greater_restitution;
	cpSpaceAddShape(world->space, shape);
	peer_keep(&world->shapes, (uint64_t)(uintptr_t)shape);
	return CN_OK;
}

cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape)
{
	(void)out_shape;
	return add_shape(world, def, cpCircleShapeNew(body_of(world, def->body), (cpFloat)circle->radius_m, vec(circle->center_m)));
}

cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape)
{
	(void)out_shape;
	return add_shape(world, def, cpSegmentShapeNew(body_of(world, def->body), vec(capsule->a_m), vec(capsule->b_m), (cpFloat)capsule->radius_m));
}

cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	cpVect points[CN_POLYGON_MAX_VERTICES];
	int32_t k;
	(void)out_shape;
	for (k = 0; k < polygon->count; ++k)
		points[k] = vec(polygon->points_m[k]);
	return add_shape(world, def, cpPolyShapeNew(body_of(world, def->body), polygon->count, points, cpTransformIdentity, (cpFloat)polygon->radius_m));
}

cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape)
{
	cpFloat width = 2.0 * (cpFloat)half_width_m, height = 2.0 * (cpFloat)half_height_m;
	(void)out_shape;
	return add_shape(world, def, cpBoxShapeNew(body_of(world, def->body), width, height, (cpFloat)radius_m));
}

/* ---- joints ---- */

static cpConstraint *add_constraint(cn_world *world, const cn_joint_base *base, cpConstraint *constraint)
{
	cpConstraintSetCollideBodies(constraint, (base->flags & CN_JOINT_COLLIDE) != 0);
	cpSpaceAddConstraint(world->space, constraint);
	peer_keep(&world->constraints, (uint64_t)(uintptr_t)constraint);
	return constraint;
}

/* The pivot is what a joint is known by: it has the anchors. */
static void add_pivot(cn_world *world, const cn_joint_base *base, cn_joint *out_joint)
{
	cpBody *a = body_of(world, base->body_a), *b = body_of(world, base->body_b);
	cpConstraint *pivot = add_constraint(world, base, cpPivotJointNew2(a, b, vec(base->anchor_a_m), vec(base->anchor_b_m)));
	*out_joint = peer_keep(&world->joints, (uint64_t)(uintptr_t)pivot);
}

cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint)
{
	cpBody *a = body_of(world, def->base.body_a), *b = body_of(world, def->base.body_b);
	cpFloat reference = (cpFloat)def->reference_angle_rad;
	add_pivot(world, &def->base, out_joint);
	if (def->base.flags & CN_JOINT_LIMIT)
		add_constraint(world, &def->base, cpRotaryLimitJointNew(a, b, reference + (cpFloat)def->lower_angle_rad, reference + (cpFloat)def->upper_angle_rad));
	return CN_OK;
}

cn_result cn_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint)
{
	add_pivot(world, &def->base, out_joint);
	/* Its angle is that of b less a less the phase. */
	add_constraint(world, &def->base, cpGearJointNew(body_of(world, def->base.body_a), body_of(world, def->base.body_b), -(cpFloat)def->reference_angle_rad, 1.0));
	return CN_OK;
}

cn_result cn_joint_get_anchors(const cn_world *world, cn_joint joint, cn_vec2 *out_world_a_m, cn_vec2 *out_world_b_m)
{
	const cpConstraint *pivot = (const cpConstraint *)(uintptr_t)peer_find(&world->joints, joint);
	*out_world_a_m = back(cpBodyLocalToWorld(cpConstraintGetBodyA(pivot), cpPivotJointGetAnchorA(pivot)));
	*out_world_b_m = back(cpBodyLocalToWorld(cpConstraintGetBodyB(pivot), cpPivotJointGetAnchorB(pivot)));
	return CN_OK;
}
