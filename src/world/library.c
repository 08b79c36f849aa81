/*
 * world/library.c - version, result texts and struct sizes of the library. Needs no world and has no state.
 */
#include "base/config.h"
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

int32_t cn_sizeof(int32_t type)
{
	switch (type) {
	case CN_TYPE_VEC2: return (int32_t)sizeof(cn_vec2);
	case CN_TYPE_POSE: return (int32_t)sizeof(cn_pose);
	case CN_TYPE_VELOCITY: return (int32_t)sizeof(cn_velocity);
	case CN_TYPE_AABB: return (int32_t)sizeof(cn_aabb);
	case CN_TYPE_MASS_DATA: return (int32_t)sizeof(cn_mass_data);
	case CN_TYPE_WORLD_DEF: return (int32_t)sizeof(cn_world_def);
	case CN_TYPE_BODY_DEF: return (int32_t)sizeof(cn_body_def);
	case CN_TYPE_SHAPE_DEF: return (int32_t)sizeof(cn_shape_def);
	case CN_TYPE_CIRCLE: return (int32_t)sizeof(cn_circle);
	case CN_TYPE_CAPSULE: return (int32_t)sizeof(cn_capsule);
	case CN_TYPE_EDGE: return (int32_t)sizeof(cn_edge);
	case CN_TYPE_POLYGON: return (int32_t)sizeof(cn_polygon);
	case CN_TYPE_CHAIN: return (int32_t)sizeof(cn_chain);
	case CN_TYPE_FILTER: return (int32_t)sizeof(cn_filter);
	case CN_TYPE_SENSOR_EVENT: return (int32_t)sizeof(cn_sensor_event);
	case CN_TYPE_UPDATE_REPORT: return (int32_t)sizeof(cn_update_report);
	case CN_TYPE_DEBUG_DRAW: return (int32_t)sizeof(cn_debug_draw);
	case CN_TYPE_MATERIAL: return (int32_t)sizeof(cn_material);
	case CN_TYPE_MANIFOLD_POINT: return (int32_t)sizeof(cn_manifold_point);
	case CN_TYPE_MANIFOLD: return (int32_t)sizeof(cn_manifold);
	case CN_TYPE_CONTACT_EVENT: return (int32_t)sizeof(cn_contact_event);
	case CN_TYPE_BODY_MOVED: return (int32_t)sizeof(cn_body_moved);
	case CN_TYPE_REVOLUTE_DEF: return (int32_t)sizeof(cn_revolute_def);
	case CN_TYPE_DISTANCE_DEF: return (int32_t)sizeof(cn_distance_def);
	case CN_TYPE_COUNTERS: return (int32_t)sizeof(cn_counters);
	case CN_TYPE_PROFILE: return (int32_t)sizeof(cn_profile);
	case CN_TYPE_MEMORY_STATS: return (int32_t)sizeof(cn_memory_stats);
	case CN_TYPE_QUERY_FILTER: return (int32_t)sizeof(cn_query_filter);
	case CN_TYPE_RAY: return (int32_t)sizeof(cn_ray);
	case CN_TYPE_RAY_HIT: return (int32_t)sizeof(cn_ray_hit);
	case CN_TYPE_CLOSEST: return (int32_t)sizeof(cn_closest);
	case CN_TYPE_EXPLOSION_DEF: return (int32_t)sizeof(cn_explosion_def);
	case CN_TYPE_FIXED_DEF: return (int32_t)sizeof(cn_fixed_def);
	case CN_TYPE_PRISMATIC_DEF: return (int32_t)sizeof(cn_prismatic_def);
	case CN_TYPE_WHEEL_DEF: return (int32_t)sizeof(cn_wheel_def);
	case CN_TYPE_MOTOR_DEF: return (int32_t)sizeof(cn_motor_def);
	case CN_TYPE_MOUSE_DEF: return (int32_t)sizeof(cn_mouse_def);
	case CN_TYPE_GEAR_DEF: return (int32_t)sizeof(cn_gear_def);
	case CN_TYPE_PULLEY_DEF: return (int32_t)sizeof(cn_pulley_def);
	case CN_TYPE_RATCHET_DEF: return (int32_t)sizeof(cn_ratchet_def);
	case CN_TYPE_ROTARY_SPRING_DEF: return (int32_t)sizeof(cn_rotary_spring_def);
	case CN_TYPE_GROOVE_DEF: return (int32_t)sizeof(cn_groove_def);
	case CN_TYPE_FILTER_JOINT_DEF: return (int32_t)sizeof(cn_filter_joint_def);
	case CN_TYPE_JOINT_BASE: return (int32_t)sizeof(cn_joint_base);
	case CN_TYPE_JOINT_EVENT: return (int32_t)sizeof(cn_joint_event);
	case CN_TYPE_ANGLE_CONSTRAINT_DEF: return (int32_t)sizeof(cn_angle_constraint_def);
	case CN_TYPE_LINE_CONSTRAINT_DEF: return (int32_t)sizeof(cn_line_constraint_def);
	case CN_TYPE_ISLAND_REPORT: return (int32_t)sizeof(cn_island_report);
	case CN_TYPE_DISTANCE: return (int32_t)sizeof(cn_distance);
	case CN_TYPE_SWEEP: return (int32_t)sizeof(cn_sweep);
	case CN_TYPE_IMPACT: return (int32_t)sizeof(cn_impact);
	case CN_TYPE_PLANE: return (int32_t)sizeof(cn_plane);
	case CN_TYPE_MOVER_DEF: return (int32_t)sizeof(cn_mover_def);
	case CN_TYPE_MOVER: return (int32_t)sizeof(cn_mover);
	case CN_TYPE_AREA_DEF: return (int32_t)sizeof(cn_area_def);
	default: return 0;
	}
}
