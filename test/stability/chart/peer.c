/*
 * test/stability/chart/peer.c - what adapters share: defaults of definitions, handles, refusals.
 */
#include "peer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *refusal = "";

/* ---- handles ---- */

uint32_t peer_keep(peer_list *list, uint64_t item)
{
	if (list->count == list->capacity) {
		list->capacity = 2 * list->capacity + 64;
		list->items = realloc(list->items, (size_t)list->capacity * sizeof *list->items);
		if (list->items == NULL) {
			fprintf(stderr, "%s: out of memory\n", peer_name);
			exit(2);
		}
	}
	list->items[list->count++] = item;
	return (uint32_t)list->count;
}

uint64_t peer_find(const peer_list *list, uint32_t handle)
{
	return handle == 0 || handle > (uint32_t)list->count ? 0 : list->items[handle - 1];
}

/* ---- refusals ---- */

cn_result peer_refuse(const char *sentence)
{
	refusal = sentence;
	return CN_ERROR_STATE;
}

cn_result peer_check_shape(const cn_shape_def *def)
{
	return def->offset_m.x != 0.0f || def->offset_m.y != 0.0f || def->angle_rad != 0.0f ? peer_refuse("the adapter has no shapes off the body's origin") : CN_OK;
}

const char *cn_result_text(cn_result result) { return result == CN_OK ? "no error" : "refused"; }

const char *cn_world_error_text(const cn_world *world)
{
	(void)world;
	return refusal;
}

cn_result cn_world_def_check(const cn_world_def *def, char *text, int32_t text_bytes)
{
	const char *why = NULL;
	if (def->solver != CN_SOLVER_AUTO)
		why = "has one solver";
	else if (def->length_unit_m != 1.0f)
		why = "keeps its length unit of 1 m here";
	if (why == NULL)
		return CN_OK;
	snprintf(text, (size_t)text_bytes, "%s %s", peer_name, why);
	return CN_ERROR_ARGUMENT;
}

/* A type of joint that the adapter lacks: its definition is zeros, and it is refused. */
#define LACKS_JOINT(type, words) \
	void cn_##type##_def_init(cn_##type##_def *def) \
	{ \
		memset(def, 0, sizeof *def); \
		def->base.struct_size = (uint32_t)sizeof *def; \
	} \
	cn_result cn_joint_create_##type(cn_world *world, const cn_##type##_def *def, cn_joint *out_joint) \
	{ \
		(void)world, (void)def, (void)out_joint; \
		return peer_refuse("the adapter has no " words); \
	}

LACKS_JOINT(gear, "gears")
LACKS_JOINT(pulley, "pulleys")
LACKS_JOINT(groove, "grooves")
LACKS_JOINT(ratchet, "ratchets")
LACKS_JOINT(rotary_spring, "rotary springs")
LACKS_JOINT(motor, "motors to a pose")

/* The same of a type of constraint on one body. */
#define LACKS_CONSTRAINT(type) \
	void cn_##type##_constraint_def_init(cn_##type##_constraint_def *def) \
	{ \
		memset(def, 0, sizeof *def); \
		def->struct_size = (uint32_t)sizeof *def; \
	} \
	cn_result cn_constraint_create_##type(cn_world *world, const cn_##type##_constraint_def *def, cn_constraint *out_constraint) \
	{ \
		(void)world, (void)def, (void)out_constraint; \
		return peer_refuse("the adapter has no constraints on one body"); \
	}

LACKS_CONSTRAINT(angle)
LACKS_CONSTRAINT(line)

void cn_area_def_init(cn_area_def *def) { memset(def, 0, sizeof *def); }

cn_result cn_shape_set_area(cn_world *world, cn_shape shape, const cn_area_def *def)
{
	(void)world, (void)shape, (void)def;
	return peer_refuse("the adapter has no areas");
}

cn_result cn_body_set_flags(cn_world *world, cn_body body, uint32_t flags)
{
	(void)world, (void)body, (void)flags;
	return peer_refuse("the adapter cannot lock bodies");
}

cn_result cn_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max)
{
	(void)world, (void)joint, (void)speed, (void)force_or_torque_max;
	return peer_refuse("the adapter has no motors");
}

cn_result cn_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags)
{
	(void)world, (void)joint, (void)flags;
	return peer_refuse("the adapter cannot change joints");
}

/* ---- definitions: what the suite leaves as it is ---- */

void cn_world_def_init(cn_world_def *def)
{
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
	def->flags = CN_WORLD_SLEEP | CN_WORLD_WARM_START | CN_WORLD_CONTINUOUS;
	def->gravity_mps2.y = -10.0f;
	def->length_unit_m = 1.0f;
	def->solver = CN_SOLVER_AUTO;
	def->substep_count = peer_substeps_default;
}

void cn_body_def_init(cn_body_def *def)
{
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
	def->type = CN_BODY_DYNAMIC;
	def->gravity_scale = 1.0f;
}

void cn_shape_def_init(cn_shape_def *def)
{
	memset(def, 0, sizeof *def);
	def->struct_size = (uint32_t)sizeof *def;
	def->density_kgpm2 = 1.0f;
	def->material.static_friction = def->material.dynamic_friction = 0.6f;
	def->filter.category = 1;
	def->filter.mask = UINT64_MAX;
}

void cn_revolute_def_init(cn_revolute_def *def)
{
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
}

void cn_fixed_def_init(cn_fixed_def *def)
{
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
}

void cn_distance_def_init(cn_distance_def *def)
{
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
	def->length_m = def->length_max_m = 1.0f;
}

void cn_prismatic_def_init(cn_prismatic_def *def)
{
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
	def->axis.x = 1.0f;
}

void cn_wheel_def_init(cn_wheel_def *def)
{
	memset(def, 0, sizeof *def);
	def->base.struct_size = (uint32_t)sizeof *def;
	def->axis.y = 1.0f;
	def->spring_hertz = 1.0f;
	def->spring_damping_ratio = 0.7f;
}

/* ---- from the pose ---- */

cn_result cn_body_get_angle(const cn_world *world, cn_body body, float *out_rad)
{
	cn_pose pose;
	cn_result result = cn_body_get_pose(world, body, &pose);
	if (result == CN_OK)
		*out_rad = atan2f(pose.sine, pose.cosine);
	return result;
}

cn_result cn_body_get_local_point(const cn_world *world, cn_body body, float x_m, float y_m, cn_vec2 *out_m)
{
	cn_pose pose;
	cn_result result = cn_body_get_pose(world, body, &pose);
	if (result == CN_OK) {
		float x = x_m - pose.position_m.x, y = y_m - pose.position_m.y;
		out_m->x = pose.cosine * x + pose.sine * y;
		out_m->y = pose.cosine * y - pose.sine * x;
	}
	return result;
}
