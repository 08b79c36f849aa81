/*
 * test/world/bodies.h - what tests of bodies share.
 */
#ifndef CAIRN_TEST_BODIES_H
#define CAIRN_TEST_BODIES_H

#include "joints.h"

static inline cn_body box_at(cn_world *world, int32_t type, float x, float y)
{
	return fixture_box(world, type, x, y, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
}

static inline int32_t type_of(const cn_world *world, cn_body body)
{
	int32_t type = -1;
	must(cn_body_get_type(world, body, &type), world, "cn_body_get_type");
	return type;
}

static inline cn_vec2 center_of(const cn_world *world, cn_body body)
{
	cn_vec2 center;
	must(cn_body_get_center(world, body, &center), world, "cn_body_get_center");
	return center;
}

static inline void set_flags(cn_world *world, cn_body body, uint32_t flags)
{
	must(cn_body_set_flags(world, body, CN_BODY_ENABLED | CN_BODY_SLEEP | flags), world, "cn_body_set_flags");
}

#endif
