/*
 * test/header/strict_handles.cpp - compiled by the part header-cxx of test/variants.sh with CN_STRICT_HANDLES: without MISUSE it
 * compiles, with each MISUSE from 1 on it does not. Handles keep the size and value of numbers.
 */
#define CN_STRICT_HANDLES
#include "cairn.h"

#ifndef MISUSE
#define MISUSE 0
#endif

static_assert(sizeof(cn_body) == 4 && sizeof(cn_shape) == 4 && sizeof(cn_joint) == 4 && sizeof(cn_constraint) == 4, "handles are numbers of 32 bits");
static_assert(sizeof(cn_shape_def) % 8 == 0 && sizeof(cn_contact_event) % 4 == 0, "structs keep their layout");

cn_result use(cn_world *world, cn_body body, cn_shape shape, cn_joint joint, cn_constraint constraint);
cn_result use(cn_world *world, cn_body body, cn_shape shape, cn_joint joint, cn_constraint constraint)
{
	cn_body owner = cn_body{}, other{};
	cn_shape_def def;
	cn_pose pose;
	int32_t type = 0;
	cn_shape_def_init(&def);
	def.body = body;
	if (cn_shape_get_body(world, shape, &owner) != CN_OK || owner != body || owner == 0)
		return CN_ERROR_STATE;
	uint32_t number = body;
	other = static_cast<cn_body>(number);
	(void)joint, (void)constraint;
#if MISUSE == 1
	cn_body_get_pose(world, shape, &pose);
#elif MISUSE == 2
	cn_shape_get_type(world, body, &type);
#elif MISUSE == 3
	cn_joint_get_type(world, constraint, &type);
#elif MISUSE == 4
	def.body = shape;
#elif MISUSE == 5
	owner = 5;
#elif MISUSE == 6
	cn_shape_get_body(world, shape, &shape);
#elif MISUSE == 7
	cn_body_destroy(world, 7);
#elif MISUSE == 8
	cn_constraint_destroy(world, joint);
#endif
	if (cn_shape_get_type(world, shape, &type) != CN_OK)
		return CN_ERROR_HANDLE;
	return cn_body_get_pose(world, other, &pose);
}
