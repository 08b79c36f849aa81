/*
 * test/stability/chart/peer_rapier.c - the calls of the stability suite on Rapier, through rapier/lib.rs: default
 * integration parameters; what it calls solver iterations are the substeps.
 */
#include "peer.h"

#include <stdlib.h>

#define CONTACTS_MAX 256

const char peer_name[] = "Rapier 0.36";
const int32_t peer_substeps_default = 4;

/* ---- rapier/lib.rs ---- */

typedef struct rapier_world rapier_world;

typedef struct rapier_surface {
	float density, friction, restitution;
	int32_t group;
} rapier_surface;

typedef struct rapier_motion {
	float x, y, cosine, sine;
	float center_x, center_y;
	float vx, vy, w;
	float mass, inertia;
	float local_center_x, local_center_y;
} rapier_motion;

typedef struct rapier_joint {
	uint32_t body_a, body_b;
	cn_vec2 anchor_a, anchor_b;
	float reference;
	int32_t collide, limited;
	float lower, upper;
} rapier_joint;

rapier_world *rapier_create(float gravity_x, float gravity_y, int32_t sleep, int32_t substeps);
void rapier_destroy(rapier_world *world);
void rapier_step(rapier_world *world, float dt);
uint32_t rapier_add_body(rapier_world *world, int32_t dynamic, int32_t bullet, float x, float y, float angle);
void rapier_set_velocity(rapier_world *world, uint32_t body, float vx, float vy, float turn);
void rapier_read(rapier_world *world, uint32_t body, rapier_motion *out);
int32_t rapier_contacts(const rapier_world *world, uint32_t body, uint32_t *out, int32_t capacity);
void rapier_add_ball(rapier_world *world, uint32_t body, const rapier_surface *surface, float x, float y, float radius);
void rapier_add_capsule(rapier_world *world, uint32_t body, const rapier_surface *surface, const cn_vec2 *ends, float radius);
void rapier_add_box(rapier_world *world, uint32_t body, const rapier_surface *surface, float half_x, float half_y, float radius);
int32_t rapier_add_polygon(rapier_world *world, uint32_t body, const rapier_surface *surface, const cn_vec2 *points, int32_t count, float radius);
uint32_t rapier_pin(rapier_world *world, const rapier_joint *joint);
uint32_t rapier_weld(rapier_world *world, const rapier_joint *joint);

/* ---- world ---- */

/* Handles are Rapier's numbers, which begin with 1: 0 is the ground that joints hang on. */
struct cn_world {
	rapier_world *inside;
	rapier_joint *joints;
	int32_t joint_count, joint_capacity;
};

cn_result cn_world_create(const cn_world_def *def, cn_world **out_world)
{
	cn_world *world = calloc(1, sizeof *world);
	if (world == NULL)
		return CN_ERROR_MEMORY;
	world->inside = rapier_create(def->gravity_mps2.x, def->gravity_mps2.y, (def->flags & CN_WORLD_SLEEP) != 0, def->substep_count);
	*out_world = world;
	return CN_OK;
}

void cn_world_destroy(cn_world *world)
{
	if (world == NULL)
		return;
	rapier_destroy(world->inside);
	free(world->joints);
	free(world);
}

cn_result cn_world_step(cn_world *world, float dt_s)
{
	rapier_step(world->inside, dt_s);
	return CN_OK;
}

/* ---- bodies ---- */

cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body)
{
	*out_body = rapier_add_body(world->inside, def->type == CN_BODY_DYNAMIC, (def->flags & CN_BODY_BULLET) != 0, def->position_m.x, def->position_m.y, def->angle_rad);
	return CN_OK;
}

cn_result cn_body_set_velocity(cn_world *world, cn_body body, float vx_mps, float vy_mps, float angular_radps)
{
	rapier_set_velocity(world->inside, body, vx_mps, vy_mps, angular_radps);
	return CN_OK;
}

static rapier_motion motion_of(const cn_world *world, cn_body body)
{
	rapier_motion motion;
	rapier_read(world->inside, body, &motion);
	return motion;
}

cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out)
{
	rapier_motion m = motion_of(world, body);
	out->position_m.x = m.x;
	out->position_m.y = m.y;
	out->cosine = m.cosine;
	out->sine = m.sine;
	return CN_OK;
}

cn_result cn_body_get_center(const cn_world *world, cn_body body, cn_vec2 *out_m)
{
	rapier_motion m = motion_of(world, body);
	out_m->x = m.center_x;
	out_m->y = m.center_y;
	return CN_OK;
}

cn_result cn_body_get_velocity(const cn_world *world, cn_body body, cn_velocity *out)
{
	rapier_motion m = motion_of(world, body);
	out->linear_mps.x = m.vx;
	out->linear_mps.y = m.vy;
	out->angular_radps = m.w;
	return CN_OK;
}

cn_result cn_body_get_mass_data(const cn_world *world, cn_body body, cn_mass_data *out)
{
	rapier_motion m = motion_of(world, body);
	out->mass_kg = m.mass;
	out->inertia_kgm2 = m.inertia;
	out->center_m.x = m.local_center_x;
	out->center_m.y = m.local_center_y;
	return CN_OK;
}

/* The bodies that touch this one; the suite asks for nothing else of a contact. */
cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count)
{
	uint32_t others[CONTACTS_MAX];
	int32_t k, count = rapier_contacts(world->inside, body, others, CONTACTS_MAX);
	for (k = 0; k < count && k < capacity && k < CONTACTS_MAX; ++k) {
		out[k].body_a = body;
		out[k].body_b = others[k];
	}
	*out_count = count;
	return CN_OK;
}

/* ---- shapes ---- */

static rapier_surface surface(const cn_shape_def *def)
{
	rapier_surface out;
	out.density = def->density_kgpm2;
	out.friction = def->material.dynamic_friction;
	out.restitution = def->material.restitution;
	out.group = def->filter.group;
	return out;
}

cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape)
{
	rapier_surface on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK)
		rapier_add_ball(world->inside, def->body, &on, circle->center_m.x, circle->center_m.y, circle->radius_m);
	return result;
}

cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape)
{
	cn_vec2 ends[2];
	rapier_surface on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	ends[0] = capsule->a_m;
	ends[1] = capsule->b_m;
	if (result == CN_OK)
		rapier_add_capsule(world->inside, def->body, &on, ends, capsule->radius_m);
	return result;
}

cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	rapier_surface on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK && !rapier_add_polygon(world->inside, def->body, &on, polygon->points_m, polygon->count, polygon->radius_m))
		result = peer_refuse("Rapier finds no hull");
	return result;
}

cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape)
{
	rapier_surface on = surface(def);
	cn_result result = peer_check_shape(def);
	(void)out_shape;
	if (result == CN_OK)
		rapier_add_box(world->inside, def->body, &on, half_width_m, half_height_m, radius_m);
	return result;
}

/* ---- joints ---- */

static rapier_joint base_of(const cn_joint_base *base, float reference_angle_rad)
{
	rapier_joint joint = {0, 0, {0.0f, 0.0f}, {0.0f, 0.0f}, 0.0f, 0, 0, 0.0f, 0.0f};
	joint.body_a = base->body_a;
	joint.body_b = base->body_b;
	joint.anchor_a = base->anchor_a_m;
	joint.anchor_b = base->anchor_b_m;
	joint.reference = reference_angle_rad;
	joint.collide = (base->flags & CN_JOINT_COLLIDE) != 0;
	return joint;
}

/* Anchors stay where they are in their bodies: they are kept here. */
static cn_result keep(cn_world *world, const rapier_joint *joint, cn_joint *out_joint)
{
	if (world->joint_count == world->joint_capacity) {
		int32_t capacity = 2 * world->joint_capacity + 64;
		rapier_joint *joints = realloc(world->joints, (size_t)capacity * sizeof *joints);
		if (joints == NULL)
			return CN_ERROR_MEMORY;
		world->joints = joints;
		world->joint_capacity = capacity;
	}
	world->joints[world->joint_count++] = *joint;
	*out_joint = (cn_joint)world->joint_count;
	return CN_OK;
}

cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint)
{
	rapier_joint joint = base_of(&def->base, def->reference_angle_rad);
	joint.limited = (def->base.flags & CN_JOINT_LIMIT) != 0;
	joint.lower = def->lower_angle_rad;
	joint.upper = def->upper_angle_rad;
	rapier_pin(world->inside, &joint);
	return keep(world, &joint, out_joint);
}

cn_result cn_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint)
{
	rapier_joint joint = base_of(&def->base, def->reference_angle_rad);
	rapier_weld(world->inside, &joint);
	return keep(world, &joint, out_joint);
}

static cn_vec2 anchor_of(const cn_world *world, uint32_t body, cn_vec2 local)
{
	rapier_motion m = motion_of(world, body);
	cn_vec2 out;
	out.x = m.x + m.cosine * local.x - m.sine * local.y;
	out.y = m.y + m.sine * local.x + m.cosine * local.y;
	return out;
}

cn_result cn_joint_get_anchors(const cn_world *world, cn_joint joint, cn_vec2 *out_world_a_m, cn_vec2 *out_world_b_m)
{
	const rapier_joint *at = &world->joints[joint - 1];
	*out_world_a_m = anchor_of(world, at->body_a, at->anchor_a);
	*out_world_b_m = anchor_of(world, at->body_b, at->anchor_b);
	return CN_OK;
}
