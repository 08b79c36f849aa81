/*
 * world/library.c - version, result texts and struct sizes of the library. Needs no world and has no state.
 */
#include "cairn.h"

int32_t cn_version(void)
{
	return CN_VERSION_MAJOR * 1000000 + CN_VERSION_MINOR * 1000 + CN_VERSION_PATCH;
}

int32_t cn_abi_version(void)
{
	return CN_ABI_VERSION;
}

const char *cn_result_text(cn_result result)
{
	switch (result) {
	case CN_OK: return "ok";
	case CN_ERROR_ARGUMENT: return "an argument is NULL, not finite, out of range or degenerate";
	case CN_ERROR_HANDLE: return "a handle is stale, of another kind or 0";
	case CN_ERROR_MEMORY: return "out of memory";
	case CN_ERROR_LOCKED: return "the world is locked while a callback runs";
	case CN_ERROR_CAPACITY: return "too many things alive at once, or an output array is too small";
	case CN_ERROR_STATE: return "the object is in a state in which this makes no sense";
	case CN_ERROR_INTERNAL: return "an internal invariant is broken";
	case CN_ERROR_FORMAT: return "the bytes are not a saved world, or damaged";
	default: return "unknown result code";
	}
}

#define SIZE(type, name) { CN_TYPE_##type, (uint16_t)sizeof(name) }
static const struct size_of_type {
	uint16_t type, bytes;
} sizes[CN_TYPE_COUNT] = {
	SIZE(VEC2, cn_vec2), SIZE(POSE, cn_pose), SIZE(VELOCITY, cn_velocity), SIZE(AABB, cn_aabb), SIZE(MASS_DATA, cn_mass_data),
	SIZE(WORLD_DEF, cn_world_def), SIZE(BODY_DEF, cn_body_def), SIZE(SHAPE_DEF, cn_shape_def), SIZE(CIRCLE, cn_circle),
	SIZE(CAPSULE, cn_capsule), SIZE(EDGE, cn_edge), SIZE(POLYGON, cn_polygon), SIZE(CHAIN, cn_chain), SIZE(FILTER, cn_filter),
	SIZE(SENSOR_EVENT, cn_sensor_event), SIZE(UPDATE_REPORT, cn_update_report), SIZE(DEBUG_DRAW, cn_debug_draw),
	SIZE(MATERIAL, cn_material), SIZE(MANIFOLD_POINT, cn_manifold_point), SIZE(MANIFOLD, cn_manifold),
	SIZE(CONTACT_EVENT, cn_contact_event), SIZE(BODY_MOVED, cn_body_moved), SIZE(REVOLUTE_DEF, cn_revolute_def),
	SIZE(DISTANCE_DEF, cn_distance_def), SIZE(COUNTERS, cn_counters), SIZE(PROFILE, cn_profile),
	SIZE(MEMORY_STATS, cn_memory_stats), SIZE(QUERY_FILTER, cn_query_filter), SIZE(RAY, cn_ray), SIZE(RAY_HIT, cn_ray_hit),
	SIZE(CLOSEST, cn_closest), SIZE(EXPLOSION_DEF, cn_explosion_def), SIZE(FIXED_DEF, cn_fixed_def),
	SIZE(PRISMATIC_DEF, cn_prismatic_def), SIZE(WHEEL_DEF, cn_wheel_def), SIZE(MOTOR_DEF, cn_motor_def),
	SIZE(MOUSE_DEF, cn_mouse_def), SIZE(GEAR_DEF, cn_gear_def), SIZE(PULLEY_DEF, cn_pulley_def),
	SIZE(RATCHET_DEF, cn_ratchet_def), SIZE(ROTARY_SPRING_DEF, cn_rotary_spring_def), SIZE(GROOVE_DEF, cn_groove_def),
	SIZE(FILTER_JOINT_DEF, cn_filter_joint_def), SIZE(JOINT_BASE, cn_joint_base), SIZE(JOINT_EVENT, cn_joint_event),
	SIZE(ANGLE_CONSTRAINT_DEF, cn_angle_constraint_def), SIZE(LINE_CONSTRAINT_DEF, cn_line_constraint_def),
	SIZE(ISLAND_REPORT, cn_island_report), SIZE(DISTANCE, cn_distance), SIZE(SWEEP, cn_sweep), SIZE(IMPACT, cn_impact),
	SIZE(PLANE, cn_plane), SIZE(MOVER_DEF, cn_mover_def), SIZE(MOVER, cn_mover), SIZE(AREA_DEF, cn_area_def)
};

int32_t cn_sizeof(int32_t type)
{
	int32_t k = 0;
	while (k < CN_TYPE_COUNT && sizes[k].type != type)
		++k;
	return k < CN_TYPE_COUNT ? sizes[k].bytes : 0;
}
