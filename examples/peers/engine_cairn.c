/*
 * examples/peers/engine_cairn.c - Cairn as one of the engines, with its default settings.
 */
#include "cairn.h"
#include "peers/engine.h"
#include "peers/judge.h"
#include <string.h>

static cn_vec2 vec(peer_vec v)
{
	cn_vec2 out;
	out.x = v.x;
	out.y = v.y;
	return out;
}

static void *create(const peer_world_def *def)
{
	cn_world_def world_def;
	cn_world *world = NULL;
	cn_world_def_init(&world_def);
	world_def.gravity_mps2 = vec(def->gravity);
	world_def.worker_count = def->workers;
	if (!def->sleep)
		world_def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	return cn_world_create(&world_def, &world) == CN_OK ? world : NULL;
}

static void destroy(void *world) { cn_world_destroy((cn_world *)world); }

static int32_t add_body(void *world, const peer_body_def *def, peer_handle *out)
{
	cn_body_def body_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = def->flags & PEER_DYNAMIC ? CN_BODY_DYNAMIC : CN_BODY_STATIC;
	body_def.position_m = vec(def->position);
	body_def.linear_velocity_mps = vec(def->velocity);
	body_def.linear_damping_per_s = def->linear_damping;
	if (def->flags & PEER_NEVER_SLEEPS)
		body_def.flags &= ~(uint32_t)CN_BODY_SLEEP;
	if (def->flags & PEER_ASLEEP)
		body_def.flags &= ~(uint32_t)CN_BODY_AWAKE;
	int32_t good = cn_body_create((cn_world *)world, &body_def, &body) == CN_OK;
	*out = body;
	return good;
}

/* ------------------------------------------------------------------ shapes */

static cn_shape_def surface(peer_handle body, const peer_shape_def *def)
{
	cn_shape_def out;
	cn_shape_def_init(&out);
	out.body = (cn_body)body;
	out.density_kgpm2 = def->density;
	out.material.static_friction = def->friction;
	out.material.dynamic_friction = def->friction;
	out.material.restitution = def->restitution;
	out.filter.category = def->category;
	out.filter.mask = def->mask;
	out.filter.group = def->group;
	return out;
}

static cn_result add_circle(cn_world *world, const cn_shape_def *on, const peer_shape_def *def)
{
	cn_circle circle;
	circle.center_m = vec(def->points[0]);
	circle.radius_m = def->radius;
	return cn_shape_create_circle(world, on, &circle, NULL);
}

static cn_result add_capsule(cn_world *world, const cn_shape_def *on, const peer_shape_def *def)
{
	cn_capsule capsule;
	capsule.a_m = vec(def->points[0]);
	capsule.b_m = vec(def->points[1]);
	capsule.radius_m = def->radius;
	return cn_shape_create_capsule(world, on, &capsule, NULL);
}

static cn_result add_edge(cn_world *world, const cn_shape_def *on, const peer_shape_def *def)
{
	cn_edge edge;
	edge.a_m = vec(def->points[0]);
	edge.b_m = vec(def->points[1]);
	return cn_shape_create_edge(world, on, &edge, NULL);
}

static cn_result add_polygon(cn_world *world, const cn_shape_def *on, const peer_shape_def *def)
{
	cn_polygon polygon;
	memset(&polygon, 0, sizeof polygon);
	polygon.count = def->count;
	polygon.radius_m = def->radius;
	for (int32_t i = 0; i < def->count && i < PEER_POLYGON_MAX; ++i)
		polygon.points_m[i] = vec(def->points[i]);
	return cn_shape_create_polygon(world, on, &polygon, NULL);
}

/* The two vectors have the same two floats. */
static cn_result add_chain(cn_world *world, const cn_shape_def *on, const peer_shape_def *def)
{
	cn_chain chain;
	memset(&chain, 0, sizeof chain);
	chain.points_m = (const cn_vec2 *)(const void *)def->points;
	chain.count = def->count;
	chain.loop = def->kind == PEER_LOOP;
	return cn_shape_create_chain(world, on, &chain, NULL);
}

static int32_t add_shape(void *world, peer_handle body, const peer_shape_def *def)
{
	cn_shape_def on = surface(body, def);
	cn_world *w = (cn_world *)world;
	switch (def->kind) {
	case PEER_CIRCLE: return add_circle(w, &on, def) == CN_OK;
	case PEER_CAPSULE: return add_capsule(w, &on, def) == CN_OK;
	case PEER_POLYGON: return add_polygon(w, &on, def) == CN_OK;
	case PEER_EDGE: return add_edge(w, &on, def) == CN_OK;
	default: return add_chain(w, &on, def) == CN_OK;
	}
}

/* ------------------------------------------------------------------ joints, steps */

static int32_t add_joint(void *world, peer_handle a, peer_handle b, const peer_joint_def *def)
{
	cn_revolute_def joint;
	cn_joint made = 0;
	cn_revolute_def_init(&joint);
	joint.base.flags |= def->flags & PEER_LIMIT ? CN_JOINT_LIMIT : 0u;
	joint.base.flags |= def->flags & PEER_MOTOR ? CN_JOINT_MOTOR : 0u;
	joint.base.flags |= def->flags & PEER_SPRING ? CN_JOINT_SPRING : 0u;
	joint.base.body_a = (cn_body)a;
	joint.base.body_b = (cn_body)b;
	joint.base.anchor_a_m = vec(def->anchor_a);
	joint.base.anchor_b_m = vec(def->anchor_b);
	joint.reference_angle_rad = def->reference;
	joint.lower_angle_rad = def->lower;
	joint.upper_angle_rad = def->upper;
	joint.motor_speed_radps = def->motor_speed;
	joint.motor_torque_max_Nm = def->motor_torque;
	joint.spring_hertz = def->spring_hertz;
	joint.spring_damping_ratio = def->spring_damping_ratio;
	return cn_joint_create_revolute((cn_world *)world, &joint, &made) == CN_OK;
}

static void remove_body(void *world, peer_handle body) { cn_body_destroy((cn_world *)world, (cn_body)body); }
static void step(void *world, float dt) { cn_world_step((cn_world *)world, dt); }

static void read_pose(void *world, peer_handle body, peer_pose *out)
{
	cn_pose pose;
	float angle = 0.0f;
	memset(&pose, 0, sizeof pose);
	cn_body_get_pose((cn_world *)world, (cn_body)body, &pose);
	cn_body_get_angle((cn_world *)world, (cn_body)body, &angle);
	out->x = (double)pose.position_m.x;
	out->y = (double)pose.position_m.y;
	out->angle = (double)angle;
}

const peer_engine peer_engine_cairn = {"Cairn", "4 substeps", create, destroy, add_body, add_shape, add_joint, NULL,
	remove_body, step, read_pose};

/* ------------------------------------------------------------------ the judge */

int32_t peer_judge_place(void *world, peer_handle body, const peer_pose *pose)
{
	return cn_body_set_pose((cn_world *)world, (cn_body)body, (float)pose->x, (float)pose->y, (float)pose->angle) == CN_OK;
}

void peer_judge_errors(void *world, measure_worst *worst)
{
	if (cn_world_step((cn_world *)world, 0.0f) != CN_OK)
		worst->failed = 1;
	measure_errors(worst, (const cn_world *)world);
}
