/* Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
 * Included by cairn_lua.c, which has the conversions. */

static const field fields_cn_vec2[] = {
	{ "x", offsetof(cn_vec2, x), FLOAT, 0, NULL },
	{ "y", offsetof(cn_vec2, y), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_vec2 = { "cn_vec2", sizeof(cn_vec2), fields_cn_vec2, NULL, -1 };

static const field fields_cn_pose[] = {
	{ "position_m", offsetof(cn_pose, position_m), RECORD, 0, &record_cn_vec2 },
	{ "cosine", offsetof(cn_pose, cosine), FLOAT, 0, NULL },
	{ "sine", offsetof(cn_pose, sine), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_pose = { "cn_pose", sizeof(cn_pose), fields_cn_pose, NULL, -1 };

static const field fields_cn_velocity[] = {
	{ "linear_mps", offsetof(cn_velocity, linear_mps), RECORD, 0, &record_cn_vec2 },
	{ "angular_radps", offsetof(cn_velocity, angular_radps), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_velocity = { "cn_velocity", sizeof(cn_velocity), fields_cn_velocity, NULL, -1 };

static const field fields_cn_aabb[] = {
	{ "lower_m", offsetof(cn_aabb, lower_m), RECORD, 0, &record_cn_vec2 },
	{ "upper_m", offsetof(cn_aabb, upper_m), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_aabb = { "cn_aabb", sizeof(cn_aabb), fields_cn_aabb, NULL, -1 };

static const field fields_cn_mass_data[] = {
	{ "mass_kg", offsetof(cn_mass_data, mass_kg), FLOAT, 0, NULL },
	{ "inertia_kgm2", offsetof(cn_mass_data, inertia_kgm2), FLOAT, 0, NULL },
	{ "center_m", offsetof(cn_mass_data, center_m), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_mass_data = { "cn_mass_data", sizeof(cn_mass_data), fields_cn_mass_data, NULL, -1 };

static void init_cn_world_def(void *at)
{
	cn_world_def_init(at);
}

static const field fields_cn_world_def[] = {
	{ "flags", offsetof(cn_world_def, flags), UINT32, 0, NULL },
	{ "gravity_mps2", offsetof(cn_world_def, gravity_mps2), RECORD, 0, &record_cn_vec2 },
	{ "length_unit_m", offsetof(cn_world_def, length_unit_m), FLOAT, 0, NULL },
	{ "solver", offsetof(cn_world_def, solver), INT32, 0, NULL },
	{ "broadphase", offsetof(cn_world_def, broadphase), INT32, 0, NULL },
	{ "substep_count", offsetof(cn_world_def, substep_count), INT32, 0, NULL },
	{ "accuracy_m", offsetof(cn_world_def, accuracy_m), FLOAT, 0, NULL },
	{ "work_budget", offsetof(cn_world_def, work_budget), INT32, 0, NULL },
	{ "restitution_threshold_mps", offsetof(cn_world_def, restitution_threshold_mps), FLOAT, 0, NULL },
	{ "push_speed_max_mps", offsetof(cn_world_def, push_speed_max_mps), FLOAT, 0, NULL },
	{ "linear_speed_max_mps", offsetof(cn_world_def, linear_speed_max_mps), FLOAT, 0, NULL },
	{ "angular_speed_max_radps", offsetof(cn_world_def, angular_speed_max_radps), FLOAT, 0, NULL },
	{ "sleep_speed_mps", offsetof(cn_world_def, sleep_speed_mps), FLOAT, 0, NULL },
	{ "sleep_delay_s", offsetof(cn_world_def, sleep_delay_s), FLOAT, 0, NULL },
	{ "body_capacity", offsetof(cn_world_def, body_capacity), INT32, 0, NULL },
	{ "shape_capacity", offsetof(cn_world_def, shape_capacity), INT32, 0, NULL },
	{ "contact_capacity", offsetof(cn_world_def, contact_capacity), INT32, 0, NULL },
	{ "joint_capacity", offsetof(cn_world_def, joint_capacity), INT32, 0, NULL },
	{ "user_data", offsetof(cn_world_def, user_data), UINT64, 0, NULL },
	{ "memory_bytes", offsetof(cn_world_def, memory_bytes), UINT64, 0, NULL },
	{ "worker_count", offsetof(cn_world_def, worker_count), INT32, 0, NULL },
	{ "hit_speed_mps", offsetof(cn_world_def, hit_speed_mps), FLOAT, 0, NULL },
	{ "touching_capacity", offsetof(cn_world_def, touching_capacity), INT32, 0, NULL },
	{ "event_capacity", offsetof(cn_world_def, event_capacity), INT32, 0, NULL },
	{ "vertex_capacity", offsetof(cn_world_def, vertex_capacity), INT32, 0, NULL },
	{ "reserve", offsetof(cn_world_def, reserve), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_world_def = { "cn_world_def", sizeof(cn_world_def), fields_cn_world_def, init_cn_world_def, -1 };

static const field fields_cn_counters[] = {
	{ "bodies", offsetof(cn_counters, bodies), INT32, 0, NULL },
	{ "bodies_awake", offsetof(cn_counters, bodies_awake), INT32, 0, NULL },
	{ "shapes", offsetof(cn_counters, shapes), INT32, 0, NULL },
	{ "proxies", offsetof(cn_counters, proxies), INT32, 0, NULL },
	{ "contacts", offsetof(cn_counters, contacts), INT32, 0, NULL },
	{ "contacts_awake", offsetof(cn_counters, contacts_awake), INT32, 0, NULL },
	{ "contacts_touching", offsetof(cn_counters, contacts_touching), INT32, 0, NULL },
	{ "joints", offsetof(cn_counters, joints), INT32, 0, NULL },
	{ "joints_awake", offsetof(cn_counters, joints_awake), INT32, 0, NULL },
	{ "islands", offsetof(cn_counters, islands), INT32, 0, NULL },
	{ "islands_awake", offsetof(cn_counters, islands_awake), INT32, 0, NULL },
	{ "colors_used", offsetof(cn_counters, colors_used), INT32, 0, NULL },
	{ "overflow_contacts", offsetof(cn_counters, overflow_contacts), INT32, 0, NULL },
	{ "broadphase_tiles", offsetof(cn_counters, broadphase_tiles), INT32, 0, NULL },
	{ "steps", offsetof(cn_counters, steps), UINT32, 0, NULL },
	{ "warnings", offsetof(cn_counters, warnings), UINT32, 0, NULL },
	{ "pairs_not_added", offsetof(cn_counters, pairs_not_added), INT32, 0, NULL },
	{ "events_not_reported", offsetof(cn_counters, events_not_reported), INT32, 0, NULL },
	{ "islands_direct", offsetof(cn_counters, islands_direct), INT32, 0, NULL },
	{ "direct_work", offsetof(cn_counters, direct_work), INT32, 0, NULL },
	{ "islands_unsolved", offsetof(cn_counters, islands_unsolved), INT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_counters = { "cn_counters", sizeof(cn_counters), fields_cn_counters, NULL, -1 };

static const field fields_cn_island_report[] = {
	{ "body", offsetof(cn_island_report, body), UINT32, 0, NULL },
	{ "bodies", offsetof(cn_island_report, bodies), INT32, 0, NULL },
	{ "contacts", offsetof(cn_island_report, contacts), INT32, 0, NULL },
	{ "joints", offsetof(cn_island_report, joints), INT32, 0, NULL },
	{ "tier", offsetof(cn_island_report, tier), INT32, 0, NULL },
	{ "reason", offsetof(cn_island_report, reason), INT32, 0, NULL },
	{ "substeps", offsetof(cn_island_report, substeps), INT32, 0, NULL },
	{ "residual_m", offsetof(cn_island_report, residual_m), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_island_report = { "cn_island_report", sizeof(cn_island_report), fields_cn_island_report, NULL, -1 };

static const field fields_cn_profile[] = {
	{ "step_s", offsetof(cn_profile, step_s), FLOAT, 0, NULL },
	{ "wake_s", offsetof(cn_profile, wake_s), FLOAT, 0, NULL },
	{ "broadphase_s", offsetof(cn_profile, broadphase_s), FLOAT, 0, NULL },
	{ "narrowphase_s", offsetof(cn_profile, narrowphase_s), FLOAT, 0, NULL },
	{ "islands_s", offsetof(cn_profile, islands_s), FLOAT, 0, NULL },
	{ "prepare_s", offsetof(cn_profile, prepare_s), FLOAT, 0, NULL },
	{ "substeps_s", offsetof(cn_profile, substeps_s), FLOAT, 0, NULL },
	{ "finalize_s", offsetof(cn_profile, finalize_s), FLOAT, 0, NULL },
	{ "events_s", offsetof(cn_profile, events_s), FLOAT, 0, NULL },
	{ "sleep_s", offsetof(cn_profile, sleep_s), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_profile = { "cn_profile", sizeof(cn_profile), fields_cn_profile, NULL, -1 };

static const field fields_cn_memory_stats[] = {
	{ "bytes_in_use", offsetof(cn_memory_stats, bytes_in_use), UINT64, 0, NULL },
	{ "bytes_peak", offsetof(cn_memory_stats, bytes_peak), UINT64, 0, NULL },
	{ "allocator_calls", offsetof(cn_memory_stats, allocator_calls), UINT64, 0, NULL },
	{ "arena_capacity", offsetof(cn_memory_stats, arena_capacity), UINT64, 0, NULL },
	{ "arena_peak", offsetof(cn_memory_stats, arena_peak), UINT64, 0, NULL },
	{ "arena_fallbacks", offsetof(cn_memory_stats, arena_fallbacks), UINT64, 0, NULL },
	{ "blocks_capacity", offsetof(cn_memory_stats, blocks_capacity), UINT64, 0, NULL },
	{ "blocks_in_use", offsetof(cn_memory_stats, blocks_in_use), UINT64, 0, NULL },
	{ "blocks_large", offsetof(cn_memory_stats, blocks_large), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_memory_stats = { "cn_memory_stats", sizeof(cn_memory_stats), fields_cn_memory_stats, NULL, -1 };

static void init_cn_body_def(void *at)
{
	cn_body_def_init(at);
}

static const field fields_cn_body_def[] = {
	{ "type", offsetof(cn_body_def, type), INT32, 0, NULL },
	{ "position_m", offsetof(cn_body_def, position_m), RECORD, 0, &record_cn_vec2 },
	{ "angle_rad", offsetof(cn_body_def, angle_rad), FLOAT, 0, NULL },
	{ "linear_velocity_mps", offsetof(cn_body_def, linear_velocity_mps), RECORD, 0, &record_cn_vec2 },
	{ "angular_velocity_radps", offsetof(cn_body_def, angular_velocity_radps), FLOAT, 0, NULL },
	{ "linear_damping_per_s", offsetof(cn_body_def, linear_damping_per_s), FLOAT, 0, NULL },
	{ "angular_damping_per_s", offsetof(cn_body_def, angular_damping_per_s), FLOAT, 0, NULL },
	{ "gravity_scale", offsetof(cn_body_def, gravity_scale), FLOAT, 0, NULL },
	{ "sleep_speed_mps", offsetof(cn_body_def, sleep_speed_mps), FLOAT, 0, NULL },
	{ "flags", offsetof(cn_body_def, flags), UINT32, 0, NULL },
	{ "solver", offsetof(cn_body_def, solver), INT32, 0, NULL },
	{ "user_data", offsetof(cn_body_def, user_data), UINT64, 0, NULL },
	{ "name", offsetof(cn_body_def, name), TEXT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_body_def = { "cn_body_def", sizeof(cn_body_def), fields_cn_body_def, init_cn_body_def, -1 };

static const field fields_cn_body_moved[] = {
	{ "pose", offsetof(cn_body_moved, pose), RECORD, 0, &record_cn_pose },
	{ "user_data", offsetof(cn_body_moved, user_data), UINT64, 0, NULL },
	{ "body", offsetof(cn_body_moved, body), UINT32, 0, NULL },
	{ "fell_asleep", offsetof(cn_body_moved, fell_asleep), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_body_moved = { "cn_body_moved", sizeof(cn_body_moved), fields_cn_body_moved, NULL, -1 };

static const field fields_cn_filter[] = {
	{ "category", offsetof(cn_filter, category), UINT64, 0, NULL },
	{ "mask", offsetof(cn_filter, mask), UINT64, 0, NULL },
	{ "group", offsetof(cn_filter, group), INT32, 0, NULL },
	{ "reserved", offsetof(cn_filter, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_filter = { "cn_filter", sizeof(cn_filter), fields_cn_filter, NULL, -1 };

static const field fields_cn_material[] = {
	{ "static_friction", offsetof(cn_material, static_friction), FLOAT, 0, NULL },
	{ "dynamic_friction", offsetof(cn_material, dynamic_friction), FLOAT, 0, NULL },
	{ "restitution", offsetof(cn_material, restitution), FLOAT, 0, NULL },
	{ "rolling_resistance", offsetof(cn_material, rolling_resistance), FLOAT, 0, NULL },
	{ "tangent_speed_mps", offsetof(cn_material, tangent_speed_mps), FLOAT, 0, NULL },
	{ "friction_mix", offsetof(cn_material, friction_mix), INT32, 0, NULL },
	{ "restitution_mix", offsetof(cn_material, restitution_mix), INT32, 0, NULL },
	{ "user_id", offsetof(cn_material, user_id), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_material = { "cn_material", sizeof(cn_material), fields_cn_material, NULL, -1 };

static void init_cn_shape_def(void *at)
{
	cn_shape_def_init(at);
}

static const field fields_cn_shape_def[] = {
	{ "body", offsetof(cn_shape_def, body), UINT32, 0, NULL },
	{ "offset_m", offsetof(cn_shape_def, offset_m), RECORD, 0, &record_cn_vec2 },
	{ "angle_rad", offsetof(cn_shape_def, angle_rad), FLOAT, 0, NULL },
	{ "density_kgpm2", offsetof(cn_shape_def, density_kgpm2), FLOAT, 0, NULL },
	{ "material", offsetof(cn_shape_def, material), RECORD, 0, &record_cn_material },
	{ "filter", offsetof(cn_shape_def, filter), RECORD, 0, &record_cn_filter },
	{ "event_mask", offsetof(cn_shape_def, event_mask), UINT32, 0, NULL },
	{ "flags", offsetof(cn_shape_def, flags), UINT32, 0, NULL },
	{ "user_data", offsetof(cn_shape_def, user_data), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_shape_def = { "cn_shape_def", sizeof(cn_shape_def), fields_cn_shape_def, init_cn_shape_def, -1 };

static const field fields_cn_circle[] = {
	{ "center_m", offsetof(cn_circle, center_m), RECORD, 0, &record_cn_vec2 },
	{ "radius_m", offsetof(cn_circle, radius_m), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_circle = { "cn_circle", sizeof(cn_circle), fields_cn_circle, NULL, -1 };

static const field fields_cn_capsule[] = {
	{ "a_m", offsetof(cn_capsule, a_m), RECORD, 0, &record_cn_vec2 },
	{ "b_m", offsetof(cn_capsule, b_m), RECORD, 0, &record_cn_vec2 },
	{ "radius_m", offsetof(cn_capsule, radius_m), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_capsule = { "cn_capsule", sizeof(cn_capsule), fields_cn_capsule, NULL, -1 };

static const field fields_cn_edge[] = {
	{ "a_m", offsetof(cn_edge, a_m), RECORD, 0, &record_cn_vec2 },
	{ "b_m", offsetof(cn_edge, b_m), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_edge = { "cn_edge", sizeof(cn_edge), fields_cn_edge, NULL, -1 };

static const field fields_cn_polygon[] = {
	{ "count", offsetof(cn_polygon, count), INT32, 0, NULL },
	{ "radius_m", offsetof(cn_polygon, radius_m), FLOAT, 0, NULL },
	{ "points_m", offsetof(cn_polygon, points_m), RECORD, 16, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_polygon = { "cn_polygon", sizeof(cn_polygon), fields_cn_polygon, NULL, offsetof(cn_polygon, count) };

static const field fields_cn_chain[] = {
	{ "points_m", offsetof(cn_chain, points_m), POINTS, 0, NULL },
	{ "count", offsetof(cn_chain, count), INT32, 0, NULL },
	{ "loop", offsetof(cn_chain, loop), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_chain = { "cn_chain", sizeof(cn_chain), fields_cn_chain, NULL, offsetof(cn_chain, count) };

static const field fields_cn_manifold_point[] = {
	{ "point_m", offsetof(cn_manifold_point, point_m), RECORD, 0, &record_cn_vec2 },
	{ "separation_m", offsetof(cn_manifold_point, separation_m), FLOAT, 0, NULL },
	{ "normal_impulse_Ns", offsetof(cn_manifold_point, normal_impulse_Ns), FLOAT, 0, NULL },
	{ "feature_id", offsetof(cn_manifold_point, feature_id), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_manifold_point = { "cn_manifold_point", sizeof(cn_manifold_point), fields_cn_manifold_point, NULL, -1 };

static const field fields_cn_manifold[] = {
	{ "normal", offsetof(cn_manifold, normal), RECORD, 0, &record_cn_vec2 },
	{ "friction_impulse_Ns", offsetof(cn_manifold, friction_impulse_Ns), FLOAT, 0, NULL },
	{ "point_count", offsetof(cn_manifold, point_count), INT32, 0, NULL },
	{ "points", offsetof(cn_manifold, points), RECORD, 2, &record_cn_manifold_point },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_manifold = { "cn_manifold", sizeof(cn_manifold), fields_cn_manifold, NULL, offsetof(cn_manifold, point_count) };

static const field fields_cn_contact_event[] = {
	{ "shape_a", offsetof(cn_contact_event, shape_a), UINT32, 0, NULL },
	{ "shape_b", offsetof(cn_contact_event, shape_b), UINT32, 0, NULL },
	{ "body_a", offsetof(cn_contact_event, body_a), UINT32, 0, NULL },
	{ "body_b", offsetof(cn_contact_event, body_b), UINT32, 0, NULL },
	{ "child_a", offsetof(cn_contact_event, child_a), INT32, 0, NULL },
	{ "child_b", offsetof(cn_contact_event, child_b), INT32, 0, NULL },
	{ "contact_id", offsetof(cn_contact_event, contact_id), UINT32, 0, NULL },
	{ "kind", offsetof(cn_contact_event, kind), INT32, 0, NULL },
	{ "approach_speed_mps", offsetof(cn_contact_event, approach_speed_mps), FLOAT, 0, NULL },
	{ "manifold", offsetof(cn_contact_event, manifold), RECORD, 0, &record_cn_manifold },
	{ "normal_impulse_Ns", offsetof(cn_contact_event, normal_impulse_Ns), FLOAT, 0, NULL },
	{ "friction_impulse_Ns", offsetof(cn_contact_event, friction_impulse_Ns), FLOAT, 0, NULL },
	{ "hit_point_m", offsetof(cn_contact_event, hit_point_m), RECORD, 0, &record_cn_vec2 },
	{ "material_a", offsetof(cn_contact_event, material_a), UINT32, 0, NULL },
	{ "material_b", offsetof(cn_contact_event, material_b), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_contact_event = { "cn_contact_event", sizeof(cn_contact_event), fields_cn_contact_event, NULL, -1 };

static const field fields_cn_sensor_event[] = {
	{ "sensor", offsetof(cn_sensor_event, sensor), UINT32, 0, NULL },
	{ "visitor", offsetof(cn_sensor_event, visitor), UINT32, 0, NULL },
	{ "sensor_body", offsetof(cn_sensor_event, sensor_body), UINT32, 0, NULL },
	{ "visitor_body", offsetof(cn_sensor_event, visitor_body), UINT32, 0, NULL },
	{ "kind", offsetof(cn_sensor_event, kind), INT32, 0, NULL },
	{ "reserved", offsetof(cn_sensor_event, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_sensor_event = { "cn_sensor_event", sizeof(cn_sensor_event), fields_cn_sensor_event, NULL, -1 };

static const field fields_cn_joint_base[] = {
	{ "flags", offsetof(cn_joint_base, flags), UINT32, 0, NULL },
	{ "body_a", offsetof(cn_joint_base, body_a), UINT32, 0, NULL },
	{ "body_b", offsetof(cn_joint_base, body_b), UINT32, 0, NULL },
	{ "anchor_a_m", offsetof(cn_joint_base, anchor_a_m), RECORD, 0, &record_cn_vec2 },
	{ "anchor_b_m", offsetof(cn_joint_base, anchor_b_m), RECORD, 0, &record_cn_vec2 },
	{ "stiffness_hertz", offsetof(cn_joint_base, stiffness_hertz), FLOAT, 0, NULL },
	{ "stiffness_damping_ratio", offsetof(cn_joint_base, stiffness_damping_ratio), FLOAT, 0, NULL },
	{ "force_max_N", offsetof(cn_joint_base, force_max_N), FLOAT, 0, NULL },
	{ "torque_max_Nm", offsetof(cn_joint_base, torque_max_Nm), FLOAT, 0, NULL },
	{ "break_force_N", offsetof(cn_joint_base, break_force_N), FLOAT, 0, NULL },
	{ "break_torque_Nm", offsetof(cn_joint_base, break_torque_Nm), FLOAT, 0, NULL },
	{ "user_data", offsetof(cn_joint_base, user_data), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_joint_base = { "cn_joint_base", sizeof(cn_joint_base), fields_cn_joint_base, NULL, -1 };

static void init_cn_revolute_def(void *at)
{
	cn_revolute_def_init(at);
}

static const field fields_cn_revolute_def[] = {
	{ "base", offsetof(cn_revolute_def, base), RECORD, 0, &record_cn_joint_base },
	{ "reference_angle_rad", offsetof(cn_revolute_def, reference_angle_rad), FLOAT, 0, NULL },
	{ "lower_angle_rad", offsetof(cn_revolute_def, lower_angle_rad), FLOAT, 0, NULL },
	{ "upper_angle_rad", offsetof(cn_revolute_def, upper_angle_rad), FLOAT, 0, NULL },
	{ "motor_speed_radps", offsetof(cn_revolute_def, motor_speed_radps), FLOAT, 0, NULL },
	{ "motor_torque_max_Nm", offsetof(cn_revolute_def, motor_torque_max_Nm), FLOAT, 0, NULL },
	{ "spring_target_rad", offsetof(cn_revolute_def, spring_target_rad), FLOAT, 0, NULL },
	{ "spring_hertz", offsetof(cn_revolute_def, spring_hertz), FLOAT, 0, NULL },
	{ "spring_damping_ratio", offsetof(cn_revolute_def, spring_damping_ratio), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_revolute_def = { "cn_revolute_def", sizeof(cn_revolute_def), fields_cn_revolute_def, init_cn_revolute_def, -1 };

static void init_cn_distance_def(void *at)
{
	cn_distance_def_init(at);
}

static const field fields_cn_distance_def[] = {
	{ "base", offsetof(cn_distance_def, base), RECORD, 0, &record_cn_joint_base },
	{ "length_m", offsetof(cn_distance_def, length_m), FLOAT, 0, NULL },
	{ "length_min_m", offsetof(cn_distance_def, length_min_m), FLOAT, 0, NULL },
	{ "length_max_m", offsetof(cn_distance_def, length_max_m), FLOAT, 0, NULL },
	{ "motor_speed_mps", offsetof(cn_distance_def, motor_speed_mps), FLOAT, 0, NULL },
	{ "motor_force_max_N", offsetof(cn_distance_def, motor_force_max_N), FLOAT, 0, NULL },
	{ "spring_hertz", offsetof(cn_distance_def, spring_hertz), FLOAT, 0, NULL },
	{ "spring_damping_ratio", offsetof(cn_distance_def, spring_damping_ratio), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_distance_def, reserved), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_distance_def = { "cn_distance_def", sizeof(cn_distance_def), fields_cn_distance_def, init_cn_distance_def, -1 };

static void init_cn_fixed_def(void *at)
{
	cn_fixed_def_init(at);
}

static const field fields_cn_fixed_def[] = {
	{ "base", offsetof(cn_fixed_def, base), RECORD, 0, &record_cn_joint_base },
	{ "reference_angle_rad", offsetof(cn_fixed_def, reference_angle_rad), FLOAT, 0, NULL },
	{ "angular_hertz", offsetof(cn_fixed_def, angular_hertz), FLOAT, 0, NULL },
	{ "angular_damping_ratio", offsetof(cn_fixed_def, angular_damping_ratio), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_fixed_def, reserved), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_fixed_def = { "cn_fixed_def", sizeof(cn_fixed_def), fields_cn_fixed_def, init_cn_fixed_def, -1 };

static void init_cn_prismatic_def(void *at)
{
	cn_prismatic_def_init(at);
}

static const field fields_cn_prismatic_def[] = {
	{ "base", offsetof(cn_prismatic_def, base), RECORD, 0, &record_cn_joint_base },
	{ "axis", offsetof(cn_prismatic_def, axis), RECORD, 0, &record_cn_vec2 },
	{ "reference_angle_rad", offsetof(cn_prismatic_def, reference_angle_rad), FLOAT, 0, NULL },
	{ "lower_m", offsetof(cn_prismatic_def, lower_m), FLOAT, 0, NULL },
	{ "upper_m", offsetof(cn_prismatic_def, upper_m), FLOAT, 0, NULL },
	{ "motor_speed_mps", offsetof(cn_prismatic_def, motor_speed_mps), FLOAT, 0, NULL },
	{ "motor_force_max_N", offsetof(cn_prismatic_def, motor_force_max_N), FLOAT, 0, NULL },
	{ "spring_target_m", offsetof(cn_prismatic_def, spring_target_m), FLOAT, 0, NULL },
	{ "spring_hertz", offsetof(cn_prismatic_def, spring_hertz), FLOAT, 0, NULL },
	{ "spring_damping_ratio", offsetof(cn_prismatic_def, spring_damping_ratio), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_prismatic_def = { "cn_prismatic_def", sizeof(cn_prismatic_def), fields_cn_prismatic_def, init_cn_prismatic_def, -1 };

static void init_cn_wheel_def(void *at)
{
	cn_wheel_def_init(at);
}

static const field fields_cn_wheel_def[] = {
	{ "base", offsetof(cn_wheel_def, base), RECORD, 0, &record_cn_joint_base },
	{ "axis", offsetof(cn_wheel_def, axis), RECORD, 0, &record_cn_vec2 },
	{ "lower_m", offsetof(cn_wheel_def, lower_m), FLOAT, 0, NULL },
	{ "upper_m", offsetof(cn_wheel_def, upper_m), FLOAT, 0, NULL },
	{ "motor_speed_radps", offsetof(cn_wheel_def, motor_speed_radps), FLOAT, 0, NULL },
	{ "motor_torque_max_Nm", offsetof(cn_wheel_def, motor_torque_max_Nm), FLOAT, 0, NULL },
	{ "spring_hertz", offsetof(cn_wheel_def, spring_hertz), FLOAT, 0, NULL },
	{ "spring_damping_ratio", offsetof(cn_wheel_def, spring_damping_ratio), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_wheel_def = { "cn_wheel_def", sizeof(cn_wheel_def), fields_cn_wheel_def, init_cn_wheel_def, -1 };

static void init_cn_motor_def(void *at)
{
	cn_motor_def_init(at);
}

static const field fields_cn_motor_def[] = {
	{ "base", offsetof(cn_motor_def, base), RECORD, 0, &record_cn_joint_base },
	{ "offset_m", offsetof(cn_motor_def, offset_m), RECORD, 0, &record_cn_vec2 },
	{ "angle_rad", offsetof(cn_motor_def, angle_rad), FLOAT, 0, NULL },
	{ "hertz", offsetof(cn_motor_def, hertz), FLOAT, 0, NULL },
	{ "damping_ratio", offsetof(cn_motor_def, damping_ratio), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_motor_def, reserved), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_motor_def = { "cn_motor_def", sizeof(cn_motor_def), fields_cn_motor_def, init_cn_motor_def, -1 };

static void init_cn_mouse_def(void *at)
{
	cn_mouse_def_init(at);
}

static const field fields_cn_mouse_def[] = {
	{ "base", offsetof(cn_mouse_def, base), RECORD, 0, &record_cn_joint_base },
	{ "target_m", offsetof(cn_mouse_def, target_m), RECORD, 0, &record_cn_vec2 },
	{ "hertz", offsetof(cn_mouse_def, hertz), FLOAT, 0, NULL },
	{ "damping_ratio", offsetof(cn_mouse_def, damping_ratio), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_mouse_def = { "cn_mouse_def", sizeof(cn_mouse_def), fields_cn_mouse_def, init_cn_mouse_def, -1 };

static void init_cn_gear_def(void *at)
{
	cn_gear_def_init(at);
}

static const field fields_cn_gear_def[] = {
	{ "base", offsetof(cn_gear_def, base), RECORD, 0, &record_cn_joint_base },
	{ "ratio", offsetof(cn_gear_def, ratio), FLOAT, 0, NULL },
	{ "phase_rad", offsetof(cn_gear_def, phase_rad), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_gear_def = { "cn_gear_def", sizeof(cn_gear_def), fields_cn_gear_def, init_cn_gear_def, -1 };

static void init_cn_pulley_def(void *at)
{
	cn_pulley_def_init(at);
}

static const field fields_cn_pulley_def[] = {
	{ "base", offsetof(cn_pulley_def, base), RECORD, 0, &record_cn_joint_base },
	{ "ground_a_m", offsetof(cn_pulley_def, ground_a_m), RECORD, 0, &record_cn_vec2 },
	{ "ground_b_m", offsetof(cn_pulley_def, ground_b_m), RECORD, 0, &record_cn_vec2 },
	{ "ratio", offsetof(cn_pulley_def, ratio), FLOAT, 0, NULL },
	{ "length_m", offsetof(cn_pulley_def, length_m), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_pulley_def = { "cn_pulley_def", sizeof(cn_pulley_def), fields_cn_pulley_def, init_cn_pulley_def, -1 };

static void init_cn_ratchet_def(void *at)
{
	cn_ratchet_def_init(at);
}

static const field fields_cn_ratchet_def[] = {
	{ "base", offsetof(cn_ratchet_def, base), RECORD, 0, &record_cn_joint_base },
	{ "phase_rad", offsetof(cn_ratchet_def, phase_rad), FLOAT, 0, NULL },
	{ "click_rad", offsetof(cn_ratchet_def, click_rad), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_ratchet_def = { "cn_ratchet_def", sizeof(cn_ratchet_def), fields_cn_ratchet_def, init_cn_ratchet_def, -1 };

static void init_cn_rotary_spring_def(void *at)
{
	cn_rotary_spring_def_init(at);
}

static const field fields_cn_rotary_spring_def[] = {
	{ "base", offsetof(cn_rotary_spring_def, base), RECORD, 0, &record_cn_joint_base },
	{ "rest_angle_rad", offsetof(cn_rotary_spring_def, rest_angle_rad), FLOAT, 0, NULL },
	{ "hertz", offsetof(cn_rotary_spring_def, hertz), FLOAT, 0, NULL },
	{ "damping_ratio", offsetof(cn_rotary_spring_def, damping_ratio), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_rotary_spring_def, reserved), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_rotary_spring_def = { "cn_rotary_spring_def", sizeof(cn_rotary_spring_def), fields_cn_rotary_spring_def, init_cn_rotary_spring_def, -1 };

static void init_cn_groove_def(void *at)
{
	cn_groove_def_init(at);
}

static const field fields_cn_groove_def[] = {
	{ "base", offsetof(cn_groove_def, base), RECORD, 0, &record_cn_joint_base },
	{ "end_m", offsetof(cn_groove_def, end_m), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_groove_def = { "cn_groove_def", sizeof(cn_groove_def), fields_cn_groove_def, init_cn_groove_def, -1 };

static void init_cn_filter_joint_def(void *at)
{
	cn_filter_joint_def_init(at);
}

static const field fields_cn_filter_joint_def[] = {
	{ "base", offsetof(cn_filter_joint_def, base), RECORD, 0, &record_cn_joint_base },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_filter_joint_def = { "cn_filter_joint_def", sizeof(cn_filter_joint_def), fields_cn_filter_joint_def, init_cn_filter_joint_def, -1 };

static const field fields_cn_joint_event[] = {
	{ "joint", offsetof(cn_joint_event, joint), UINT32, 0, NULL },
	{ "constraint", offsetof(cn_joint_event, constraint), UINT32, 0, NULL },
	{ "body_a", offsetof(cn_joint_event, body_a), UINT32, 0, NULL },
	{ "body_b", offsetof(cn_joint_event, body_b), UINT32, 0, NULL },
	{ "force_N", offsetof(cn_joint_event, force_N), FLOAT, 0, NULL },
	{ "torque_Nm", offsetof(cn_joint_event, torque_Nm), FLOAT, 0, NULL },
	{ "destroyed", offsetof(cn_joint_event, destroyed), UINT32, 0, NULL },
	{ "reserved", offsetof(cn_joint_event, reserved), UINT32, 0, NULL },
	{ "user_data", offsetof(cn_joint_event, user_data), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_joint_event = { "cn_joint_event", sizeof(cn_joint_event), fields_cn_joint_event, NULL, -1 };

static void init_cn_angle_constraint_def(void *at)
{
	cn_angle_constraint_def_init(at);
}

static const field fields_cn_angle_constraint_def[] = {
	{ "flags", offsetof(cn_angle_constraint_def, flags), UINT32, 0, NULL },
	{ "body", offsetof(cn_angle_constraint_def, body), UINT32, 0, NULL },
	{ "lower_rad", offsetof(cn_angle_constraint_def, lower_rad), FLOAT, 0, NULL },
	{ "upper_rad", offsetof(cn_angle_constraint_def, upper_rad), FLOAT, 0, NULL },
	{ "hertz", offsetof(cn_angle_constraint_def, hertz), FLOAT, 0, NULL },
	{ "damping_ratio", offsetof(cn_angle_constraint_def, damping_ratio), FLOAT, 0, NULL },
	{ "break_torque_Nm", offsetof(cn_angle_constraint_def, break_torque_Nm), FLOAT, 0, NULL },
	{ "user_data", offsetof(cn_angle_constraint_def, user_data), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_angle_constraint_def = { "cn_angle_constraint_def", sizeof(cn_angle_constraint_def), fields_cn_angle_constraint_def, init_cn_angle_constraint_def, -1 };

static void init_cn_line_constraint_def(void *at)
{
	cn_line_constraint_def_init(at);
}

static const field fields_cn_line_constraint_def[] = {
	{ "flags", offsetof(cn_line_constraint_def, flags), UINT32, 0, NULL },
	{ "body", offsetof(cn_line_constraint_def, body), UINT32, 0, NULL },
	{ "anchor_m", offsetof(cn_line_constraint_def, anchor_m), RECORD, 0, &record_cn_vec2 },
	{ "origin_m", offsetof(cn_line_constraint_def, origin_m), RECORD, 0, &record_cn_vec2 },
	{ "axis", offsetof(cn_line_constraint_def, axis), RECORD, 0, &record_cn_vec2 },
	{ "tolerance_m", offsetof(cn_line_constraint_def, tolerance_m), FLOAT, 0, NULL },
	{ "lower_m", offsetof(cn_line_constraint_def, lower_m), FLOAT, 0, NULL },
	{ "upper_m", offsetof(cn_line_constraint_def, upper_m), FLOAT, 0, NULL },
	{ "hertz", offsetof(cn_line_constraint_def, hertz), FLOAT, 0, NULL },
	{ "damping_ratio", offsetof(cn_line_constraint_def, damping_ratio), FLOAT, 0, NULL },
	{ "break_force_N", offsetof(cn_line_constraint_def, break_force_N), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_line_constraint_def, reserved), UINT32, 0, NULL },
	{ "user_data", offsetof(cn_line_constraint_def, user_data), UINT64, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_line_constraint_def = { "cn_line_constraint_def", sizeof(cn_line_constraint_def), fields_cn_line_constraint_def, init_cn_line_constraint_def, -1 };

static const field fields_cn_update_report[] = {
	{ "steps", offsetof(cn_update_report, steps), INT32, 0, NULL },
	{ "leftover_s", offsetof(cn_update_report, leftover_s), FLOAT, 0, NULL },
	{ "dropped_s", offsetof(cn_update_report, dropped_s), FLOAT, 0, NULL },
	{ "interpolation", offsetof(cn_update_report, interpolation), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_update_report = { "cn_update_report", sizeof(cn_update_report), fields_cn_update_report, NULL, -1 };

static const field fields_cn_ray[] = {
	{ "origin_m", offsetof(cn_ray, origin_m), RECORD, 0, &record_cn_vec2 },
	{ "translation_m", offsetof(cn_ray, translation_m), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_ray = { "cn_ray", sizeof(cn_ray), fields_cn_ray, NULL, -1 };

static const field fields_cn_ray_hit[] = {
	{ "shape", offsetof(cn_ray_hit, shape), UINT32, 0, NULL },
	{ "body", offsetof(cn_ray_hit, body), UINT32, 0, NULL },
	{ "child", offsetof(cn_ray_hit, child), INT32, 0, NULL },
	{ "fraction", offsetof(cn_ray_hit, fraction), FLOAT, 0, NULL },
	{ "point_m", offsetof(cn_ray_hit, point_m), RECORD, 0, &record_cn_vec2 },
	{ "normal", offsetof(cn_ray_hit, normal), RECORD, 0, &record_cn_vec2 },
	{ "depth_m", offsetof(cn_ray_hit, depth_m), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_ray_hit, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_ray_hit = { "cn_ray_hit", sizeof(cn_ray_hit), fields_cn_ray_hit, NULL, -1 };

static void init_cn_query_filter(void *at)
{
	cn_query_filter_init(at);
}

static const field fields_cn_query_filter[] = {
	{ "category", offsetof(cn_query_filter, category), UINT64, 0, NULL },
	{ "mask", offsetof(cn_query_filter, mask), UINT64, 0, NULL },
	{ "ignored_body", offsetof(cn_query_filter, ignored_body), UINT32, 0, NULL },
	{ "flags", offsetof(cn_query_filter, flags), UINT32, 0, NULL },
	{ "visit", offsetof(cn_query_filter, visit), VISITOR, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_query_filter = { "cn_query_filter", sizeof(cn_query_filter), fields_cn_query_filter, init_cn_query_filter, -1 };

static const field fields_cn_closest[] = {
	{ "shape", offsetof(cn_closest, shape), UINT32, 0, NULL },
	{ "body", offsetof(cn_closest, body), UINT32, 0, NULL },
	{ "child", offsetof(cn_closest, child), INT32, 0, NULL },
	{ "distance_m", offsetof(cn_closest, distance_m), FLOAT, 0, NULL },
	{ "point_m", offsetof(cn_closest, point_m), RECORD, 0, &record_cn_vec2 },
	{ "normal", offsetof(cn_closest, normal), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_closest = { "cn_closest", sizeof(cn_closest), fields_cn_closest, NULL, -1 };

static const field fields_cn_distance[] = {
	{ "point_a_m", offsetof(cn_distance, point_a_m), RECORD, 0, &record_cn_vec2 },
	{ "point_b_m", offsetof(cn_distance, point_b_m), RECORD, 0, &record_cn_vec2 },
	{ "normal", offsetof(cn_distance, normal), RECORD, 0, &record_cn_vec2 },
	{ "distance_m", offsetof(cn_distance, distance_m), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_distance, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_distance = { "cn_distance", sizeof(cn_distance), fields_cn_distance, NULL, -1 };

static const field fields_cn_sweep[] = {
	{ "start", offsetof(cn_sweep, start), RECORD, 0, &record_cn_pose },
	{ "center_m", offsetof(cn_sweep, center_m), RECORD, 0, &record_cn_vec2 },
	{ "translation_m", offsetof(cn_sweep, translation_m), RECORD, 0, &record_cn_vec2 },
	{ "turn_rad", offsetof(cn_sweep, turn_rad), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_sweep, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_sweep = { "cn_sweep", sizeof(cn_sweep), fields_cn_sweep, NULL, -1 };

static const field fields_cn_impact[] = {
	{ "state", offsetof(cn_impact, state), INT32, 0, NULL },
	{ "fraction", offsetof(cn_impact, fraction), FLOAT, 0, NULL },
	{ "point_m", offsetof(cn_impact, point_m), RECORD, 0, &record_cn_vec2 },
	{ "normal", offsetof(cn_impact, normal), RECORD, 0, &record_cn_vec2 },
	{ "distance_m", offsetof(cn_impact, distance_m), FLOAT, 0, NULL },
	{ "reserved", offsetof(cn_impact, reserved), UINT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_impact = { "cn_impact", sizeof(cn_impact), fields_cn_impact, NULL, -1 };

static const field fields_cn_plane[] = {
	{ "normal", offsetof(cn_plane, normal), RECORD, 0, &record_cn_vec2 },
	{ "point_m", offsetof(cn_plane, point_m), RECORD, 0, &record_cn_vec2 },
	{ "separation_m", offsetof(cn_plane, separation_m), FLOAT, 0, NULL },
	{ "push_max_m", offsetof(cn_plane, push_max_m), FLOAT, 0, NULL },
	{ "push_m", offsetof(cn_plane, push_m), FLOAT, 0, NULL },
	{ "shape", offsetof(cn_plane, shape), UINT32, 0, NULL },
	{ "body", offsetof(cn_plane, body), UINT32, 0, NULL },
	{ "child", offsetof(cn_plane, child), INT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_plane = { "cn_plane", sizeof(cn_plane), fields_cn_plane, NULL, -1 };

static void init_cn_mover_def(void *at)
{
	cn_mover_def_init(at);
}

static const field fields_cn_mover_def[] = {
	{ "flags", offsetof(cn_mover_def, flags), UINT32, 0, NULL },
	{ "shape", offsetof(cn_mover_def, shape), RECORD, 0, &record_cn_polygon },
	{ "filter", offsetof(cn_mover_def, filter), RECORD, 0, &record_cn_query_filter },
	{ "up", offsetof(cn_mover_def, up), RECORD, 0, &record_cn_vec2 },
	{ "slope_limit_rad", offsetof(cn_mover_def, slope_limit_rad), FLOAT, 0, NULL },
	{ "step_height_m", offsetof(cn_mover_def, step_height_m), FLOAT, 0, NULL },
	{ "snap_m", offsetof(cn_mover_def, snap_m), FLOAT, 0, NULL },
	{ "gravity_scale", offsetof(cn_mover_def, gravity_scale), FLOAT, 0, NULL },
	{ "push_force_N", offsetof(cn_mover_def, push_force_N), FLOAT, 0, NULL },
	{ "iterations_max", offsetof(cn_mover_def, iterations_max), INT32, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_mover_def = { "cn_mover_def", sizeof(cn_mover_def), fields_cn_mover_def, init_cn_mover_def, -1 };

static const field fields_cn_mover[] = {
	{ "position_m", offsetof(cn_mover, position_m), RECORD, 0, &record_cn_vec2 },
	{ "velocity_mps", offsetof(cn_mover, velocity_mps), RECORD, 0, &record_cn_vec2 },
	{ "ground_normal", offsetof(cn_mover, ground_normal), RECORD, 0, &record_cn_vec2 },
	{ "ground_point_m", offsetof(cn_mover, ground_point_m), RECORD, 0, &record_cn_vec2 },
	{ "ground_local_m", offsetof(cn_mover, ground_local_m), RECORD, 0, &record_cn_vec2 },
	{ "ground_velocity_mps", offsetof(cn_mover, ground_velocity_mps), RECORD, 0, &record_cn_vec2 },
	{ "ground_body", offsetof(cn_mover, ground_body), UINT32, 0, NULL },
	{ "ground_shape", offsetof(cn_mover, ground_shape), UINT32, 0, NULL },
	{ "flags", offsetof(cn_mover, flags), UINT32, 0, NULL },
	{ "squeezed_m", offsetof(cn_mover, squeezed_m), FLOAT, 0, NULL },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_mover = { "cn_mover", sizeof(cn_mover), fields_cn_mover, NULL, -1 };

static void init_cn_area_def(void *at)
{
	cn_area_def_init(at);
}

static const field fields_cn_area_def[] = {
	{ "flags", offsetof(cn_area_def, flags), UINT32, 0, NULL },
	{ "priority", offsetof(cn_area_def, priority), INT32, 0, NULL },
	{ "gravity_mps2", offsetof(cn_area_def, gravity_mps2), RECORD, 0, &record_cn_vec2 },
	{ "center_m", offsetof(cn_area_def, center_m), RECORD, 0, &record_cn_vec2 },
	{ "pull_mps2", offsetof(cn_area_def, pull_mps2), FLOAT, 0, NULL },
	{ "pull_distance_m", offsetof(cn_area_def, pull_distance_m), FLOAT, 0, NULL },
	{ "linear_damping_per_s", offsetof(cn_area_def, linear_damping_per_s), FLOAT, 0, NULL },
	{ "angular_damping_per_s", offsetof(cn_area_def, angular_damping_per_s), FLOAT, 0, NULL },
	{ "density_kgpm2", offsetof(cn_area_def, density_kgpm2), FLOAT, 0, NULL },
	{ "drag_kgpm2", offsetof(cn_area_def, drag_kgpm2), FLOAT, 0, NULL },
	{ "lift_kgpm2", offsetof(cn_area_def, lift_kgpm2), FLOAT, 0, NULL },
	{ "flow_mps", offsetof(cn_area_def, flow_mps), RECORD, 0, &record_cn_vec2 },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_area_def = { "cn_area_def", sizeof(cn_area_def), fields_cn_area_def, init_cn_area_def, -1 };

static void init_cn_explosion_def(void *at)
{
	cn_explosion_def_init(at);
}

static const field fields_cn_explosion_def[] = {
	{ "radius_m", offsetof(cn_explosion_def, radius_m), FLOAT, 0, NULL },
	{ "falloff_m", offsetof(cn_explosion_def, falloff_m), FLOAT, 0, NULL },
	{ "impulse_Nspm", offsetof(cn_explosion_def, impulse_Nspm), FLOAT, 0, NULL },
	{ "center_m", offsetof(cn_explosion_def, center_m), RECORD, 0, &record_cn_vec2 },
	{ "filter", offsetof(cn_explosion_def, filter), RECORD, 0, &record_cn_query_filter },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_explosion_def = { "cn_explosion_def", sizeof(cn_explosion_def), fields_cn_explosion_def, init_cn_explosion_def, -1 };

static void init_cn_debug_draw(void *at)
{
	cn_debug_draw_init(at);
}

static const field fields_cn_debug_draw[] = {
	{ "flags", offsetof(cn_debug_draw, flags), UINT32, 0, NULL },
	{ "view", offsetof(cn_debug_draw, view), RECORD, 0, &record_cn_aabb },
	{ NULL, 0, FLOAT, 0, NULL },
};
static const record record_cn_debug_draw = { "cn_debug_draw", sizeof(cn_debug_draw), fields_cn_debug_draw, init_cn_debug_draw, -1 };


static int call_cn_world_step(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	float dt_s;
	read_value(L, 2, FLOAT, NULL, &dt_s, "dt_s");
	check(L, self, cn_world_step(self->pointer, dt_s));
	return 0;
}

static int call_cn_world_set_gravity(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float gravity_x_mps2;
	read_value(L, 2, FLOAT, NULL, &gravity_x_mps2, "gravity_x_mps2");
	float gravity_y_mps2;
	read_value(L, 3, FLOAT, NULL, &gravity_y_mps2, "gravity_y_mps2");
	check(L, self, cn_world_set_gravity(self->pointer, gravity_x_mps2, gravity_y_mps2));
	return 0;
}

static int call_cn_world_get_gravity(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	cn_vec2 out_0;
	check(L, NULL, cn_world_get_gravity(self->pointer, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static int call_cn_world_set_substep_count(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	int32_t count;
	read_value(L, 2, INT32, NULL, &count, "count");
	check(L, self, cn_world_set_substep_count(self->pointer, count));
	return 0;
}

static int call_cn_world_get_substep_count(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t out_0;
	check(L, NULL, cn_world_get_substep_count(self->pointer, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_set_solver(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	int32_t solver;
	read_value(L, 2, INT32, NULL, &solver, "solver");
	check(L, self, cn_world_set_solver(self->pointer, solver));
	return 0;
}

static int call_cn_world_get_solver(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t out_0;
	check(L, NULL, cn_world_get_solver(self->pointer, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_set_accuracy(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float accuracy_m;
	read_value(L, 2, FLOAT, NULL, &accuracy_m, "accuracy_m");
	int32_t work_budget;
	read_value(L, 3, INT32, NULL, &work_budget, "work_budget");
	check(L, self, cn_world_set_accuracy(self->pointer, accuracy_m, work_budget));
	return 0;
}

static int call_cn_world_get_accuracy(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	float out_0;
	int32_t out_1;
	check(L, NULL, cn_world_get_accuracy(self->pointer, &out_0, &out_1));
	push_value(L, FLOAT, NULL, &out_0);
	push_value(L, INT32, NULL, &out_1);
	return 2;
}

static int call_cn_world_get_worker_count(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t out_0;
	check(L, NULL, cn_world_get_worker_count(self->pointer, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_set_flags(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	uint32_t flags;
	read_value(L, 2, UINT32, NULL, &flags, "flags");
	check(L, self, cn_world_set_flags(self->pointer, flags));
	return 0;
}

static int call_cn_world_get_flags(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint32_t out_0;
	check(L, NULL, cn_world_get_flags(self->pointer, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_set_restitution_threshold(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	float speed_mps;
	read_value(L, 2, FLOAT, NULL, &speed_mps, "speed_mps");
	check(L, self, cn_world_set_restitution_threshold(self->pointer, speed_mps));
	return 0;
}

static int call_cn_world_set_hit_speed(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	float speed_mps;
	read_value(L, 2, FLOAT, NULL, &speed_mps, "speed_mps");
	check(L, self, cn_world_set_hit_speed(self->pointer, speed_mps));
	return 0;
}

static int call_cn_world_set_speed_limits(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float linear_mps;
	read_value(L, 2, FLOAT, NULL, &linear_mps, "linear_mps");
	float angular_radps;
	read_value(L, 3, FLOAT, NULL, &angular_radps, "angular_radps");
	check(L, self, cn_world_set_speed_limits(self->pointer, linear_mps, angular_radps));
	return 0;
}

static int call_cn_world_set_sleep(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float speed_mps;
	read_value(L, 2, FLOAT, NULL, &speed_mps, "speed_mps");
	float delay_s;
	read_value(L, 3, FLOAT, NULL, &delay_s, "delay_s");
	check(L, self, cn_world_set_sleep(self->pointer, speed_mps, delay_s));
	return 0;
}

static int call_cn_world_set_user_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	uint64_t user_data;
	read_value(L, 2, UINT64, NULL, &user_data, "user_data");
	check(L, self, cn_world_set_user_data(self->pointer, user_data));
	return 0;
}

static int call_cn_world_get_user_data(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t out_0;
	check(L, NULL, cn_world_get_user_data(self->pointer, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_world_get_bodies(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t capacity, out_count;
	check(L, NULL, cn_world_get_bodies(self->pointer, NULL, 0, &capacity));
	cn_body *out = buffer(L, capacity, sizeof(cn_body));
	check(L, NULL, cn_world_get_bodies(self->pointer, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_get_shapes(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t capacity, out_count;
	check(L, NULL, cn_world_get_shapes(self->pointer, NULL, 0, &capacity));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, cn_world_get_shapes(self->pointer, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_get_joints(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t capacity, out_count;
	check(L, NULL, cn_world_get_joints(self->pointer, NULL, 0, &capacity));
	cn_joint *out = buffer(L, capacity, sizeof(cn_joint));
	check(L, NULL, cn_world_get_joints(self->pointer, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_get_counters(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	cn_counters out_0;
	check(L, NULL, cn_world_get_counters(self->pointer, &out_0));
	push_value(L, RECORD, &record_cn_counters, &out_0);
	return 1;
}

static int call_cn_world_get_islands(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t capacity, out_count;
	check(L, NULL, cn_world_get_islands(self->pointer, NULL, 0, &capacity));
	cn_island_report *out = buffer(L, capacity, sizeof(cn_island_report));
	check(L, NULL, cn_world_get_islands(self->pointer, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_island_report, out, out_count);
	return 1;
}

static int call_cn_world_get_profile(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	cn_profile out_0;
	check(L, NULL, cn_world_get_profile(self->pointer, &out_0));
	push_value(L, RECORD, &record_cn_profile, &out_0);
	return 1;
}

static int call_cn_world_get_memory_stats(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	cn_memory_stats out_0;
	check(L, NULL, cn_world_get_memory_stats(self->pointer, &out_0));
	push_value(L, RECORD, &record_cn_memory_stats, &out_0);
	return 1;
}

static int call_cn_world_shift_origin(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float x_m;
	read_value(L, 2, FLOAT, NULL, &x_m, "x_m");
	float y_m;
	read_value(L, 3, FLOAT, NULL, &y_m, "y_m");
	check(L, self, cn_world_shift_origin(self->pointer, x_m, y_m));
	return 0;
}

static int call_cn_world_hash(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t out_0;
	check(L, NULL, cn_world_hash(self->pointer, &out_0));
	push_hash(L, out_0);
	return 1;
}

static int call_cn_world_save_size(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t out_0;
	check(L, NULL, cn_world_save_size(self->pointer, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_world_save(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t room;
	check(L, NULL, cn_world_save_size(self->pointer, &room));
	void *out = lua_newuserdata(L, room > 0 ? (size_t)room : 1);
	check(L, NULL, cn_world_save(self->pointer, out, room, &room));
	lua_pushlstring(L, out, (size_t)room);
	return 1;
}

static int call_cn_world_restore(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	size_t bytes;
	const void *save = luaL_checklstring(L, 2, &bytes);
	check(L, self, cn_world_restore(self->pointer, save, bytes));
	return 0;
}

static int call_cn_world_write_size(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t out_0;
	check(L, NULL, cn_world_write_size(self->pointer, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_world_write(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	uint64_t room;
	check(L, NULL, cn_world_write_size(self->pointer, &room));
	void *out = lua_newuserdata(L, room > 0 ? (size_t)room : 1);
	check(L, NULL, cn_world_write(self->pointer, out, room, &room));
	lua_pushlstring(L, out, (size_t)room);
	return 1;
}

static int call_cn_body_create(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_body_def def_value;
	const cn_body_def *def = read_struct(L, 2, &record_cn_body_def, &def_value, 0, "def");
	cn_body out_0;
	check(L, self, cn_body_create(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_body_create_many(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	int32_t defs_count;
	cn_body_def *defs = read_array(L, 2, RECORD, &record_cn_body_def, 0, "defs", &defs_count);
	int32_t count = defs_count;
	cn_body *out_bodies = buffer(L, count, sizeof(cn_body));
	check(L, self, cn_body_create_many(self->pointer, defs, count, out_bodies));
	write_array(L, 3, UINT32, NULL, out_bodies, count);
	return 1;
}

static int call_cn_body_destroy(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	check(L, self, cn_body_destroy(self->pointer, body));
	return 0;
}

static int call_cn_body_destroy_many(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	int32_t bodies_count;
	cn_body *bodies = read_array(L, 2, UINT32, NULL, 0, "bodies", &bodies_count);
	int32_t count = bodies_count;
	check(L, self, cn_body_destroy_many(self->pointer, bodies, count));
	return 0;
}

static int call_cn_body_is_valid(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	lua_pushboolean(L, cn_body_is_valid(self->pointer, body));
	return 1;
}

static int call_cn_body_set_type(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t type;
	read_value(L, 3, INT32, NULL, &type, "type");
	check(L, self, cn_body_set_type(self->pointer, body, type));
	return 0;
}

static int call_cn_body_get_type(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t out_0;
	check(L, NULL, cn_body_get_type(self->pointer, body, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_body_set_flags(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	uint32_t flags;
	read_value(L, 3, UINT32, NULL, &flags, "flags");
	check(L, self, cn_body_set_flags(self->pointer, body, flags));
	return 0;
}

static int call_cn_body_get_flags(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	uint32_t out_0;
	check(L, NULL, cn_body_get_flags(self->pointer, body, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_body_set_awake(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t awake;
	read_value(L, 3, INT32, NULL, &awake, "awake");
	check(L, self, cn_body_set_awake(self->pointer, body, awake));
	return 0;
}

static int call_cn_body_set_pose(lua_State *L)
{
	lua_settop(L, 5);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float position_x_m;
	read_value(L, 3, FLOAT, NULL, &position_x_m, "position_x_m");
	float position_y_m;
	read_value(L, 4, FLOAT, NULL, &position_y_m, "position_y_m");
	float angle_rad;
	read_value(L, 5, FLOAT, NULL, &angle_rad, "angle_rad");
	check(L, self, cn_body_set_pose(self->pointer, body, position_x_m, position_y_m, angle_rad));
	return 0;
}

static int call_cn_body_get_pose(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_pose out_0;
	check(L, NULL, cn_body_get_pose(self->pointer, body, &out_0));
	push_value(L, RECORD, &record_cn_pose, &out_0);
	return 1;
}

static int call_cn_body_get_position_parts(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_vec2 out_0;
	cn_vec2 out_1;
	check(L, NULL, cn_body_get_position_parts(self->pointer, body, &out_0, &out_1));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	push_value(L, RECORD, &record_cn_vec2, &out_1);
	return 2;
}

static int call_cn_body_get_angle(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float out_0;
	check(L, NULL, cn_body_get_angle(self->pointer, body, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_body_get_center(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_vec2 out_0;
	check(L, NULL, cn_body_get_center(self->pointer, body, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static int call_cn_body_set_velocity(lua_State *L)
{
	lua_settop(L, 5);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float linear_x_mps;
	read_value(L, 3, FLOAT, NULL, &linear_x_mps, "linear_x_mps");
	float linear_y_mps;
	read_value(L, 4, FLOAT, NULL, &linear_y_mps, "linear_y_mps");
	float angular_radps;
	read_value(L, 5, FLOAT, NULL, &angular_radps, "angular_radps");
	check(L, self, cn_body_set_velocity(self->pointer, body, linear_x_mps, linear_y_mps, angular_radps));
	return 0;
}

static int call_cn_body_get_velocity(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_velocity out_0;
	check(L, NULL, cn_body_get_velocity(self->pointer, body, &out_0));
	push_value(L, RECORD, &record_cn_velocity, &out_0);
	return 1;
}

static int call_cn_body_set_target_pose(lua_State *L)
{
	lua_settop(L, 6);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float position_x_m;
	read_value(L, 3, FLOAT, NULL, &position_x_m, "position_x_m");
	float position_y_m;
	read_value(L, 4, FLOAT, NULL, &position_y_m, "position_y_m");
	float angle_rad;
	read_value(L, 5, FLOAT, NULL, &angle_rad, "angle_rad");
	float dt_s;
	read_value(L, 6, FLOAT, NULL, &dt_s, "dt_s");
	check(L, self, cn_body_set_target_pose(self->pointer, body, position_x_m, position_y_m, angle_rad, dt_s));
	return 0;
}

static int call_cn_body_get_velocity_at(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float point_x_m;
	read_value(L, 3, FLOAT, NULL, &point_x_m, "point_x_m");
	float point_y_m;
	read_value(L, 4, FLOAT, NULL, &point_y_m, "point_y_m");
	cn_vec2 out_0;
	check(L, NULL, cn_body_get_velocity_at(self->pointer, body, point_x_m, point_y_m, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static int call_cn_body_get_world_point(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float local_x_m;
	read_value(L, 3, FLOAT, NULL, &local_x_m, "local_x_m");
	float local_y_m;
	read_value(L, 4, FLOAT, NULL, &local_y_m, "local_y_m");
	cn_vec2 out_0;
	check(L, NULL, cn_body_get_world_point(self->pointer, body, local_x_m, local_y_m, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static int call_cn_body_get_local_point(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float world_x_m;
	read_value(L, 3, FLOAT, NULL, &world_x_m, "world_x_m");
	float world_y_m;
	read_value(L, 4, FLOAT, NULL, &world_y_m, "world_y_m");
	cn_vec2 out_0;
	check(L, NULL, cn_body_get_local_point(self->pointer, body, world_x_m, world_y_m, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static int call_cn_body_get_aabb(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_aabb out_0;
	check(L, NULL, cn_body_get_aabb(self->pointer, body, &out_0));
	push_value(L, RECORD, &record_cn_aabb, &out_0);
	return 1;
}

static int call_cn_body_apply_force(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float force_x_N;
	read_value(L, 3, FLOAT, NULL, &force_x_N, "force_x_N");
	float force_y_N;
	read_value(L, 4, FLOAT, NULL, &force_y_N, "force_y_N");
	check(L, self, cn_body_apply_force(self->pointer, body, force_x_N, force_y_N));
	return 0;
}

static int call_cn_body_apply_force_at(lua_State *L)
{
	lua_settop(L, 6);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float force_x_N;
	read_value(L, 3, FLOAT, NULL, &force_x_N, "force_x_N");
	float force_y_N;
	read_value(L, 4, FLOAT, NULL, &force_y_N, "force_y_N");
	float point_x_m;
	read_value(L, 5, FLOAT, NULL, &point_x_m, "point_x_m");
	float point_y_m;
	read_value(L, 6, FLOAT, NULL, &point_y_m, "point_y_m");
	check(L, self, cn_body_apply_force_at(self->pointer, body, force_x_N, force_y_N, point_x_m, point_y_m));
	return 0;
}

static int call_cn_body_apply_torque(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float torque_Nm;
	read_value(L, 3, FLOAT, NULL, &torque_Nm, "torque_Nm");
	check(L, self, cn_body_apply_torque(self->pointer, body, torque_Nm));
	return 0;
}

static int call_cn_body_apply_impulse(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float impulse_x_Ns;
	read_value(L, 3, FLOAT, NULL, &impulse_x_Ns, "impulse_x_Ns");
	float impulse_y_Ns;
	read_value(L, 4, FLOAT, NULL, &impulse_y_Ns, "impulse_y_Ns");
	check(L, self, cn_body_apply_impulse(self->pointer, body, impulse_x_Ns, impulse_y_Ns));
	return 0;
}

static int call_cn_body_apply_impulse_at(lua_State *L)
{
	lua_settop(L, 6);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float impulse_x_Ns;
	read_value(L, 3, FLOAT, NULL, &impulse_x_Ns, "impulse_x_Ns");
	float impulse_y_Ns;
	read_value(L, 4, FLOAT, NULL, &impulse_y_Ns, "impulse_y_Ns");
	float point_x_m;
	read_value(L, 5, FLOAT, NULL, &point_x_m, "point_x_m");
	float point_y_m;
	read_value(L, 6, FLOAT, NULL, &point_y_m, "point_y_m");
	check(L, self, cn_body_apply_impulse_at(self->pointer, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m));
	return 0;
}

static int call_cn_body_apply_angular_impulse(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float impulse_Nms;
	read_value(L, 3, FLOAT, NULL, &impulse_Nms, "impulse_Nms");
	check(L, self, cn_body_apply_angular_impulse(self->pointer, body, impulse_Nms));
	return 0;
}

static int call_cn_body_get_mass_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_mass_data out_0;
	check(L, NULL, cn_body_get_mass_data(self->pointer, body, &out_0));
	push_value(L, RECORD, &record_cn_mass_data, &out_0);
	return 1;
}

static int call_cn_body_set_mass_data(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	cn_mass_data mass_value;
	const cn_mass_data *mass = read_struct(L, 3, &record_cn_mass_data, &mass_value, 0, "mass");
	check(L, self, cn_body_set_mass_data(self->pointer, body, mass));
	return 0;
}

static int call_cn_body_reset_mass_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	check(L, self, cn_body_reset_mass_data(self->pointer, body));
	return 0;
}

static int call_cn_body_set_damping(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float linear_per_s;
	read_value(L, 3, FLOAT, NULL, &linear_per_s, "linear_per_s");
	float angular_per_s;
	read_value(L, 4, FLOAT, NULL, &angular_per_s, "angular_per_s");
	check(L, self, cn_body_set_damping(self->pointer, body, linear_per_s, angular_per_s));
	return 0;
}

static int call_cn_body_get_damping(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float out_0;
	float out_1;
	check(L, NULL, cn_body_get_damping(self->pointer, body, &out_0, &out_1));
	push_value(L, FLOAT, NULL, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_body_set_gravity_scale(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float scale;
	read_value(L, 3, FLOAT, NULL, &scale, "scale");
	check(L, self, cn_body_set_gravity_scale(self->pointer, body, scale));
	return 0;
}

static int call_cn_body_get_gravity_scale(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float out_0;
	check(L, NULL, cn_body_get_gravity_scale(self->pointer, body, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_body_set_sleep_speed(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	float speed_mps;
	read_value(L, 3, FLOAT, NULL, &speed_mps, "speed_mps");
	check(L, self, cn_body_set_sleep_speed(self->pointer, body, speed_mps));
	return 0;
}

static int call_cn_body_set_solver(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t solver;
	read_value(L, 3, INT32, NULL, &solver, "solver");
	check(L, self, cn_body_set_solver(self->pointer, body, solver));
	return 0;
}

static int call_cn_body_get_solver(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t out_0;
	check(L, NULL, cn_body_get_solver(self->pointer, body, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_body_set_user_data(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	uint64_t user_data;
	read_value(L, 3, UINT64, NULL, &user_data, "user_data");
	check(L, self, cn_body_set_user_data(self->pointer, body, user_data));
	return 0;
}

static int call_cn_body_get_user_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	uint64_t out_0;
	check(L, NULL, cn_body_get_user_data(self->pointer, body, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_body_set_name(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	const char *name = luaL_optstring(L, 3, NULL);
	check(L, self, cn_body_set_name(self->pointer, body, name));
	return 0;
}

static int call_cn_body_get_name(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	const char *text;
	check(L, NULL, cn_body_get_name(self->pointer, body, &text));
	lua_pushstring(L, text);
	return 1;
}

static int call_cn_body_get_shapes(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t capacity, out_count;
	check(L, NULL, cn_body_get_shapes(self->pointer, body, NULL, 0, &capacity));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, cn_body_get_shapes(self->pointer, body, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_body_get_joints(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t capacity, out_count;
	check(L, NULL, cn_body_get_joints(self->pointer, body, NULL, 0, &capacity));
	cn_joint *out = buffer(L, capacity, sizeof(cn_joint));
	check(L, NULL, cn_body_get_joints(self->pointer, body, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_read_poses(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	int32_t bodies_count;
	cn_body *bodies = read_array(L, 2, UINT32, NULL, 1, "bodies", &bodies_count);
	int32_t count = bodies ? bodies_count : body_count(self);
	cn_pose *out = buffer(L, count, sizeof(cn_pose));
	check(L, NULL, cn_world_read_poses(self->pointer, bodies, count, out));
	write_array(L, 3, RECORD, &record_cn_pose, out, count);
	return 1;
}

static int call_cn_world_read_velocities(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	int32_t bodies_count;
	cn_body *bodies = read_array(L, 2, UINT32, NULL, 1, "bodies", &bodies_count);
	int32_t count = bodies ? bodies_count : body_count(self);
	cn_velocity *out = buffer(L, count, sizeof(cn_velocity));
	check(L, NULL, cn_world_read_velocities(self->pointer, bodies, count, out));
	write_array(L, 3, RECORD, &record_cn_velocity, out, count);
	return 1;
}

static int call_cn_world_write_velocities(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	int32_t bodies_count;
	cn_body *bodies = read_array(L, 2, UINT32, NULL, 1, "bodies", &bodies_count);
	int32_t velocities_count;
	cn_velocity *velocities = read_array(L, 3, RECORD, &record_cn_velocity, 0, "velocities", &velocities_count);
	int32_t count = velocities_count;
	even(L, 2, !bodies || bodies_count == count);
	check(L, self, cn_world_write_velocities(self->pointer, bodies, count, velocities));
	return 0;
}

static int call_cn_world_moved(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_changed_world(L);
	const cn_body_moved *out;
	int32_t out_count;
	check(L, self, cn_world_moved(self->pointer, &out, &out_count));
	write_array(L, 0, RECORD, &record_cn_body_moved, out, out_count);
	return 1;
}

static int call_cn_shape_create_circle(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	cn_circle circle_value;
	const cn_circle *circle = read_struct(L, 3, &record_cn_circle, &circle_value, 0, "circle");
	cn_shape out_0;
	check(L, self, cn_shape_create_circle(self->pointer, def, circle, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_create_capsule(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	cn_capsule capsule_value;
	const cn_capsule *capsule = read_struct(L, 3, &record_cn_capsule, &capsule_value, 0, "capsule");
	cn_shape out_0;
	check(L, self, cn_shape_create_capsule(self->pointer, def, capsule, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_create_edge(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	cn_edge edge_value;
	const cn_edge *edge = read_struct(L, 3, &record_cn_edge, &edge_value, 0, "edge");
	cn_shape out_0;
	check(L, self, cn_shape_create_edge(self->pointer, def, edge, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_create_polygon(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	cn_polygon polygon_value;
	const cn_polygon *polygon = read_struct(L, 3, &record_cn_polygon, &polygon_value, 0, "polygon");
	cn_shape out_0;
	check(L, self, cn_shape_create_polygon(self->pointer, def, polygon, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_create_box(lua_State *L)
{
	lua_settop(L, 5);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	float half_width_m;
	read_value(L, 3, FLOAT, NULL, &half_width_m, "half_width_m");
	float half_height_m;
	read_value(L, 4, FLOAT, NULL, &half_height_m, "half_height_m");
	float radius_m;
	read_value(L, 5, FLOAT, NULL, &radius_m, "radius_m");
	cn_shape out_0;
	check(L, self, cn_shape_create_box(self->pointer, def, half_width_m, half_height_m, radius_m, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_create_chain(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape_def def_value;
	const cn_shape_def *def = read_struct(L, 2, &record_cn_shape_def, &def_value, 0, "def");
	cn_chain chain_value;
	const cn_chain *chain = read_struct(L, 3, &record_cn_chain, &chain_value, 0, "chain");
	cn_shape out_0;
	check(L, self, cn_shape_create_chain(self->pointer, def, chain, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_attach(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_body body;
	read_value(L, 3, UINT32, NULL, &body, "body");
	check(L, self, cn_shape_attach(self->pointer, shape, body));
	return 0;
}

static int call_cn_shape_detach(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	check(L, self, cn_shape_detach(self->pointer, shape));
	return 0;
}

static int call_cn_shape_destroy(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	check(L, self, cn_shape_destroy(self->pointer, shape));
	return 0;
}

static int call_cn_shape_is_valid(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	lua_pushboolean(L, cn_shape_is_valid(self->pointer, shape));
	return 1;
}

static int call_cn_shape_get_type(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	int32_t out_0;
	check(L, NULL, cn_shape_get_type(self->pointer, shape, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_get_body(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_body out_0;
	check(L, NULL, cn_shape_get_body(self->pointer, shape, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_set_material(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_material material_value;
	const cn_material *material = read_struct(L, 3, &record_cn_material, &material_value, 0, "material");
	check(L, self, cn_shape_set_material(self->pointer, shape, material));
	return 0;
}

static int call_cn_shape_get_material(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_material out_0;
	check(L, NULL, cn_shape_get_material(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_material, &out_0);
	return 1;
}

static int call_cn_shape_set_density(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	float density_kgpm2;
	read_value(L, 3, FLOAT, NULL, &density_kgpm2, "density_kgpm2");
	check(L, self, cn_shape_set_density(self->pointer, shape, density_kgpm2));
	return 0;
}

static int call_cn_shape_get_density(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	float out_0;
	check(L, NULL, cn_shape_get_density(self->pointer, shape, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_shape_set_filter(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_filter filter_value;
	const cn_filter *filter = read_struct(L, 3, &record_cn_filter, &filter_value, 0, "filter");
	check(L, self, cn_shape_set_filter(self->pointer, shape, filter));
	return 0;
}

static int call_cn_shape_get_filter(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_filter out_0;
	check(L, NULL, cn_shape_get_filter(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_filter, &out_0);
	return 1;
}

static int call_cn_shape_set_event_mask(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint32_t event_mask;
	read_value(L, 3, UINT32, NULL, &event_mask, "event_mask");
	check(L, self, cn_shape_set_event_mask(self->pointer, shape, event_mask));
	return 0;
}

static int call_cn_shape_get_event_mask(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint32_t out_0;
	check(L, NULL, cn_shape_get_event_mask(self->pointer, shape, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_set_flags(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint32_t flags;
	read_value(L, 3, UINT32, NULL, &flags, "flags");
	check(L, self, cn_shape_set_flags(self->pointer, shape, flags));
	return 0;
}

static int call_cn_shape_get_flags(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint32_t out_0;
	check(L, NULL, cn_shape_get_flags(self->pointer, shape, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_shape_set_user_data(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint64_t user_data;
	read_value(L, 3, UINT64, NULL, &user_data, "user_data");
	check(L, self, cn_shape_set_user_data(self->pointer, shape, user_data));
	return 0;
}

static int call_cn_shape_get_user_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	uint64_t out_0;
	check(L, NULL, cn_shape_get_user_data(self->pointer, shape, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_shape_get_aabb(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_aabb out_0;
	check(L, NULL, cn_shape_get_aabb(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_aabb, &out_0);
	return 1;
}

static int call_cn_shape_get_mass_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_mass_data out_0;
	check(L, NULL, cn_shape_get_mass_data(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_mass_data, &out_0);
	return 1;
}

static int call_cn_shape_get_circle(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_circle out_0;
	check(L, NULL, cn_shape_get_circle(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_circle, &out_0);
	return 1;
}

static int call_cn_shape_get_capsule(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_capsule out_0;
	check(L, NULL, cn_shape_get_capsule(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_capsule, &out_0);
	return 1;
}

static int call_cn_shape_get_edge(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_edge out_0;
	check(L, NULL, cn_shape_get_edge(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_edge, &out_0);
	return 1;
}

static int call_cn_shape_get_polygon(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_polygon out_0;
	check(L, NULL, cn_shape_get_polygon(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_polygon, &out_0);
	return 1;
}

static int call_cn_shape_get_chain_points(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	int32_t capacity, out_count;
	check(L, NULL, cn_shape_get_chain_points(self->pointer, shape, NULL, 0, &capacity));
	cn_vec2 *out = buffer(L, capacity, sizeof(cn_vec2));
	check(L, NULL, cn_shape_get_chain_points(self->pointer, shape, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_vec2, out, out_count);
	return 1;
}

static int call_cn_shape_set_circle(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_circle circle_value;
	const cn_circle *circle = read_struct(L, 3, &record_cn_circle, &circle_value, 0, "circle");
	check(L, self, cn_shape_set_circle(self->pointer, shape, circle));
	return 0;
}

static int call_cn_shape_set_capsule(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_capsule capsule_value;
	const cn_capsule *capsule = read_struct(L, 3, &record_cn_capsule, &capsule_value, 0, "capsule");
	check(L, self, cn_shape_set_capsule(self->pointer, shape, capsule));
	return 0;
}

static int call_cn_shape_set_edge(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_edge edge_value;
	const cn_edge *edge = read_struct(L, 3, &record_cn_edge, &edge_value, 0, "edge");
	check(L, self, cn_shape_set_edge(self->pointer, shape, edge));
	return 0;
}

static int call_cn_shape_set_polygon(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_polygon polygon_value;
	const cn_polygon *polygon = read_struct(L, 3, &record_cn_polygon, &polygon_value, 0, "polygon");
	check(L, self, cn_shape_set_polygon(self->pointer, shape, polygon));
	return 0;
}

static int call_cn_shape_set_chain(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_chain chain_value;
	const cn_chain *chain = read_struct(L, 3, &record_cn_chain, &chain_value, 0, "chain");
	check(L, self, cn_shape_set_chain(self->pointer, shape, chain));
	return 0;
}

static int call_cn_shape_test_point(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	float point_x_m;
	read_value(L, 3, FLOAT, NULL, &point_x_m, "point_x_m");
	float point_y_m;
	read_value(L, 4, FLOAT, NULL, &point_y_m, "point_y_m");
	int32_t out_0;
	check(L, NULL, cn_shape_test_point(self->pointer, shape, point_x_m, point_y_m, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_contact_events(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	int32_t kind;
	read_value(L, 2, INT32, NULL, &kind, "kind");
	const cn_contact_event *out;
	int32_t out_count;
	check(L, self, cn_world_contact_events(self->pointer, kind, &out, &out_count));
	write_array(L, 0, RECORD, &record_cn_contact_event, out, out_count);
	return 1;
}

static int call_cn_world_sensor_events(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	const cn_sensor_event *out;
	int32_t out_count;
	check(L, NULL, cn_world_sensor_events(self->pointer, &out, &out_count));
	write_array(L, 0, RECORD, &record_cn_sensor_event, out, out_count);
	return 1;
}

static int call_cn_body_get_contacts(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t capacity, out_count;
	check(L, NULL, cn_body_get_contacts(self->pointer, body, NULL, 0, &capacity));
	cn_contact_event *out = buffer(L, capacity, sizeof(cn_contact_event));
	check(L, NULL, cn_body_get_contacts(self->pointer, body, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_contact_event, out, out_count);
	return 1;
}

static int call_cn_shape_get_contacts(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	int32_t capacity, out_count;
	check(L, NULL, cn_shape_get_contacts(self->pointer, shape, NULL, 0, &capacity));
	cn_contact_event *out = buffer(L, capacity, sizeof(cn_contact_event));
	check(L, NULL, cn_shape_get_contacts(self->pointer, shape, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_contact_event, out, out_count);
	return 1;
}

static int call_cn_shape_get_visitors(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape sensor;
	read_value(L, 2, UINT32, NULL, &sensor, "sensor");
	int32_t capacity, out_count;
	check(L, NULL, cn_shape_get_visitors(self->pointer, sensor, NULL, 0, &capacity));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, cn_shape_get_visitors(self->pointer, sensor, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_fell_asleep(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	const cn_body *out;
	int32_t out_count;
	check(L, NULL, cn_world_fell_asleep(self->pointer, &out, &out_count));
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_joint_create_revolute(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_revolute_def def_value;
	const cn_revolute_def *def = read_struct(L, 2, &record_cn_revolute_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_revolute(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_distance(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_distance_def def_value;
	const cn_distance_def *def = read_struct(L, 2, &record_cn_distance_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_distance(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_fixed(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_fixed_def def_value;
	const cn_fixed_def *def = read_struct(L, 2, &record_cn_fixed_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_fixed(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_prismatic(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_prismatic_def def_value;
	const cn_prismatic_def *def = read_struct(L, 2, &record_cn_prismatic_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_prismatic(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_wheel(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_wheel_def def_value;
	const cn_wheel_def *def = read_struct(L, 2, &record_cn_wheel_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_wheel(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_motor(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_motor_def def_value;
	const cn_motor_def *def = read_struct(L, 2, &record_cn_motor_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_motor(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_mouse(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_mouse_def def_value;
	const cn_mouse_def *def = read_struct(L, 2, &record_cn_mouse_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_mouse(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_gear(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_gear_def def_value;
	const cn_gear_def *def = read_struct(L, 2, &record_cn_gear_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_gear(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_pulley(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_pulley_def def_value;
	const cn_pulley_def *def = read_struct(L, 2, &record_cn_pulley_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_pulley(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_ratchet(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_ratchet_def def_value;
	const cn_ratchet_def *def = read_struct(L, 2, &record_cn_ratchet_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_ratchet(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_rotary_spring(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_rotary_spring_def def_value;
	const cn_rotary_spring_def *def = read_struct(L, 2, &record_cn_rotary_spring_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_rotary_spring(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_groove(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_groove_def def_value;
	const cn_groove_def *def = read_struct(L, 2, &record_cn_groove_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_groove(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_create_filter(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_filter_joint_def def_value;
	const cn_filter_joint_def *def = read_struct(L, 2, &record_cn_filter_joint_def, &def_value, 0, "def");
	cn_joint out_0;
	check(L, self, cn_joint_create_filter(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_destroy(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	check(L, self, cn_joint_destroy(self->pointer, joint));
	return 0;
}

static int call_cn_joint_is_valid(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	lua_pushboolean(L, cn_joint_is_valid(self->pointer, joint));
	return 1;
}

static int call_cn_joint_get_type(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	int32_t out_0;
	check(L, NULL, cn_joint_get_type(self->pointer, joint, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_get_bodies(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_body out_0;
	cn_body out_1;
	check(L, NULL, cn_joint_get_bodies(self->pointer, joint, &out_0, &out_1));
	push_value(L, UINT32, NULL, &out_0);
	push_value(L, UINT32, NULL, &out_1);
	return 2;
}

static int call_cn_joint_get_anchors(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_vec2 out_0;
	cn_vec2 out_1;
	check(L, NULL, cn_joint_get_anchors(self->pointer, joint, &out_0, &out_1));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	push_value(L, RECORD, &record_cn_vec2, &out_1);
	return 2;
}

static int call_cn_joint_get_reaction(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_vec2 out_0;
	float out_1;
	check(L, NULL, cn_joint_get_reaction(self->pointer, joint, &out_0, &out_1));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_joint_get_error(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float out_0;
	float out_1;
	check(L, NULL, cn_joint_get_error(self->pointer, joint, &out_0, &out_1));
	push_value(L, FLOAT, NULL, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_joint_set_solver(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	int32_t solver;
	read_value(L, 3, INT32, NULL, &solver, "solver");
	check(L, self, cn_joint_set_solver(self->pointer, joint, solver));
	return 0;
}

static int call_cn_joint_get_solver(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	int32_t out_0;
	check(L, NULL, cn_joint_get_solver(self->pointer, joint, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_set_user_data(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	uint64_t user_data;
	read_value(L, 3, UINT64, NULL, &user_data, "user_data");
	check(L, self, cn_joint_set_user_data(self->pointer, joint, user_data));
	return 0;
}

static int call_cn_joint_get_user_data(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	uint64_t out_0;
	check(L, NULL, cn_joint_get_user_data(self->pointer, joint, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_joint_set_flags(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	uint32_t flags;
	read_value(L, 3, UINT32, NULL, &flags, "flags");
	check(L, self, cn_joint_set_flags(self->pointer, joint, flags));
	return 0;
}

static int call_cn_joint_get_flags(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	uint32_t out_0;
	check(L, NULL, cn_joint_get_flags(self->pointer, joint, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_joint_get_revolute(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_revolute_def out_0;
	check(L, NULL, cn_joint_get_revolute(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_revolute_def, &out_0);
	return 1;
}

static int call_cn_joint_set_revolute(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_revolute_def def_value;
	const cn_revolute_def *def = read_struct(L, 3, &record_cn_revolute_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_revolute(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_distance(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_distance_def out_0;
	check(L, NULL, cn_joint_get_distance(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_distance_def, &out_0);
	return 1;
}

static int call_cn_joint_set_distance(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_distance_def def_value;
	const cn_distance_def *def = read_struct(L, 3, &record_cn_distance_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_distance(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_fixed(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_fixed_def out_0;
	check(L, NULL, cn_joint_get_fixed(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_fixed_def, &out_0);
	return 1;
}

static int call_cn_joint_set_fixed(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_fixed_def def_value;
	const cn_fixed_def *def = read_struct(L, 3, &record_cn_fixed_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_fixed(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_prismatic(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_prismatic_def out_0;
	check(L, NULL, cn_joint_get_prismatic(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_prismatic_def, &out_0);
	return 1;
}

static int call_cn_joint_set_prismatic(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_prismatic_def def_value;
	const cn_prismatic_def *def = read_struct(L, 3, &record_cn_prismatic_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_prismatic(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_wheel(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_wheel_def out_0;
	check(L, NULL, cn_joint_get_wheel(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_wheel_def, &out_0);
	return 1;
}

static int call_cn_joint_set_wheel(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_wheel_def def_value;
	const cn_wheel_def *def = read_struct(L, 3, &record_cn_wheel_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_wheel(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_motor_to(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_motor_def out_0;
	check(L, NULL, cn_joint_get_motor_to(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_motor_def, &out_0);
	return 1;
}

static int call_cn_joint_set_motor_to(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_motor_def def_value;
	const cn_motor_def *def = read_struct(L, 3, &record_cn_motor_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_motor_to(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_mouse(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_mouse_def out_0;
	check(L, NULL, cn_joint_get_mouse(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_mouse_def, &out_0);
	return 1;
}

static int call_cn_joint_set_mouse(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_mouse_def def_value;
	const cn_mouse_def *def = read_struct(L, 3, &record_cn_mouse_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_mouse(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_gear(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_gear_def out_0;
	check(L, NULL, cn_joint_get_gear(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_gear_def, &out_0);
	return 1;
}

static int call_cn_joint_set_gear(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_gear_def def_value;
	const cn_gear_def *def = read_struct(L, 3, &record_cn_gear_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_gear(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_pulley(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_pulley_def out_0;
	check(L, NULL, cn_joint_get_pulley(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_pulley_def, &out_0);
	return 1;
}

static int call_cn_joint_set_pulley(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_pulley_def def_value;
	const cn_pulley_def *def = read_struct(L, 3, &record_cn_pulley_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_pulley(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_ratchet(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_ratchet_def out_0;
	check(L, NULL, cn_joint_get_ratchet(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_ratchet_def, &out_0);
	return 1;
}

static int call_cn_joint_set_ratchet(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_ratchet_def def_value;
	const cn_ratchet_def *def = read_struct(L, 3, &record_cn_ratchet_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_ratchet(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_rotary_spring(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_rotary_spring_def out_0;
	check(L, NULL, cn_joint_get_rotary_spring(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_rotary_spring_def, &out_0);
	return 1;
}

static int call_cn_joint_set_rotary_spring(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_rotary_spring_def def_value;
	const cn_rotary_spring_def *def = read_struct(L, 3, &record_cn_rotary_spring_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_rotary_spring(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_groove(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_groove_def out_0;
	check(L, NULL, cn_joint_get_groove(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_groove_def, &out_0);
	return 1;
}

static int call_cn_joint_set_groove(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_groove_def def_value;
	const cn_groove_def *def = read_struct(L, 3, &record_cn_groove_def, &def_value, 0, "def");
	check(L, self, cn_joint_set_groove(self->pointer, joint, def));
	return 0;
}

static int call_cn_joint_get_base(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_joint_base out_0;
	check(L, NULL, cn_joint_get_base(self->pointer, joint, &out_0));
	push_value(L, RECORD, &record_cn_joint_base, &out_0);
	return 1;
}

static int call_cn_joint_set_base(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	cn_joint_base base_value;
	const cn_joint_base *base = read_struct(L, 3, &record_cn_joint_base, &base_value, 0, "base");
	check(L, self, cn_joint_set_base(self->pointer, joint, base));
	return 0;
}

static int call_cn_joint_set_target(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float target_x_m;
	read_value(L, 3, FLOAT, NULL, &target_x_m, "target_x_m");
	float target_y_m;
	read_value(L, 4, FLOAT, NULL, &target_y_m, "target_y_m");
	check(L, self, cn_joint_set_target(self->pointer, joint, target_x_m, target_y_m));
	return 0;
}

static int call_cn_joint_get_position(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float out_0;
	check(L, NULL, cn_joint_get_position(self->pointer, joint, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_joint_get_speed(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float out_0;
	check(L, NULL, cn_joint_get_speed(self->pointer, joint, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_joint_set_motor(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float speed;
	read_value(L, 3, FLOAT, NULL, &speed, "speed");
	float force_or_torque_max;
	read_value(L, 4, FLOAT, NULL, &force_or_torque_max, "force_or_torque_max");
	check(L, self, cn_joint_set_motor(self->pointer, joint, speed, force_or_torque_max));
	return 0;
}

static int call_cn_joint_set_limits(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_joint joint;
	read_value(L, 2, UINT32, NULL, &joint, "joint");
	float lower;
	read_value(L, 3, FLOAT, NULL, &lower, "lower");
	float upper;
	read_value(L, 4, FLOAT, NULL, &upper, "upper");
	check(L, self, cn_joint_set_limits(self->pointer, joint, lower, upper));
	return 0;
}

static int call_cn_world_joint_events(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	const cn_joint_event *out;
	int32_t out_count;
	check(L, NULL, cn_world_joint_events(self->pointer, &out, &out_count));
	write_array(L, 0, RECORD, &record_cn_joint_event, out, out_count);
	return 1;
}

static int call_cn_constraint_create_angle(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_angle_constraint_def def_value;
	const cn_angle_constraint_def *def = read_struct(L, 2, &record_cn_angle_constraint_def, &def_value, 0, "def");
	cn_constraint out_0;
	check(L, self, cn_constraint_create_angle(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_constraint_create_line(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_line_constraint_def def_value;
	const cn_line_constraint_def *def = read_struct(L, 2, &record_cn_line_constraint_def, &def_value, 0, "def");
	cn_constraint out_0;
	check(L, self, cn_constraint_create_line(self->pointer, def, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_constraint_destroy(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	check(L, self, cn_constraint_destroy(self->pointer, constraint));
	return 0;
}

static int call_cn_constraint_is_valid(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	lua_pushboolean(L, cn_constraint_is_valid(self->pointer, constraint));
	return 1;
}

static int call_cn_constraint_get_type(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	int32_t out_0;
	check(L, NULL, cn_constraint_get_type(self->pointer, constraint, &out_0));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_constraint_get_body(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_body out_0;
	check(L, NULL, cn_constraint_get_body(self->pointer, constraint, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_constraint_get_angle(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_angle_constraint_def out_0;
	check(L, NULL, cn_constraint_get_angle(self->pointer, constraint, &out_0));
	push_value(L, RECORD, &record_cn_angle_constraint_def, &out_0);
	return 1;
}

static int call_cn_constraint_set_angle(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_angle_constraint_def def_value;
	const cn_angle_constraint_def *def = read_struct(L, 3, &record_cn_angle_constraint_def, &def_value, 0, "def");
	check(L, self, cn_constraint_set_angle(self->pointer, constraint, def));
	return 0;
}

static int call_cn_constraint_get_line(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_line_constraint_def out_0;
	check(L, NULL, cn_constraint_get_line(self->pointer, constraint, &out_0));
	push_value(L, RECORD, &record_cn_line_constraint_def, &out_0);
	return 1;
}

static int call_cn_constraint_set_line(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_line_constraint_def def_value;
	const cn_line_constraint_def *def = read_struct(L, 3, &record_cn_line_constraint_def, &def_value, 0, "def");
	check(L, self, cn_constraint_set_line(self->pointer, constraint, def));
	return 0;
}

static int call_cn_constraint_get_position(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	float out_0;
	check(L, NULL, cn_constraint_get_position(self->pointer, constraint, &out_0));
	push_value(L, FLOAT, NULL, &out_0);
	return 1;
}

static int call_cn_constraint_get_reaction(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	cn_vec2 out_0;
	float out_1;
	check(L, NULL, cn_constraint_get_reaction(self->pointer, constraint, &out_0, &out_1));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_constraint_get_error(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_constraint constraint;
	read_value(L, 2, UINT32, NULL, &constraint, "constraint");
	float out_0;
	float out_1;
	check(L, NULL, cn_constraint_get_error(self->pointer, constraint, &out_0, &out_1));
	push_value(L, FLOAT, NULL, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_world_get_constraints(lua_State *L)
{
	lua_settop(L, 1);
	world_object *self = to_world(L);
	int32_t capacity, out_count;
	check(L, NULL, cn_world_get_constraints(self->pointer, NULL, 0, &capacity));
	cn_constraint *out = buffer(L, capacity, sizeof(cn_constraint));
	check(L, NULL, cn_world_get_constraints(self->pointer, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_body_get_constraints(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_body body;
	read_value(L, 2, UINT32, NULL, &body, "body");
	int32_t capacity, out_count;
	check(L, NULL, cn_body_get_constraints(self->pointer, body, NULL, 0, &capacity));
	cn_constraint *out = buffer(L, capacity, sizeof(cn_constraint));
	check(L, NULL, cn_body_get_constraints(self->pointer, body, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_set_fixed_step(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	float step_s;
	read_value(L, 2, FLOAT, NULL, &step_s, "step_s");
	int32_t steps_max;
	read_value(L, 3, INT32, NULL, &steps_max, "steps_max");
	check(L, self, cn_world_set_fixed_step(self->pointer, step_s, steps_max));
	return 0;
}

static int call_cn_world_update(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	float elapsed_s;
	read_value(L, 2, FLOAT, NULL, &elapsed_s, "elapsed_s");
	cn_update_report out_0;
	check(L, self, cn_world_update(self->pointer, elapsed_s, &out_0));
	push_value(L, RECORD, &record_cn_update_report, &out_0);
	return 1;
}

static int call_cn_world_read_poses_interpolated(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	int32_t bodies_count;
	cn_body *bodies = read_array(L, 2, UINT32, NULL, 1, "bodies", &bodies_count);
	float factor;
	read_value(L, 3, FLOAT, NULL, &factor, "factor");
	int32_t count = bodies ? bodies_count : body_count(self);
	cn_pose *out = buffer(L, count, sizeof(cn_pose));
	check(L, NULL, cn_world_read_poses_interpolated(self->pointer, bodies, count, factor, out));
	write_array(L, 4, RECORD, &record_cn_pose, out, count);
	return 1;
}

static int call_cn_world_cast_ray(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_ray ray_value;
	const cn_ray *ray = read_struct(L, 2, &record_cn_ray, &ray_value, 0, "ray");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	cn_ray_hit out_0;
	check(L, NULL, visited(L, self, cn_world_cast_ray(self->pointer, ray, filter, &out_0)));
	push_value(L, RECORD, &record_cn_ray_hit, &out_0);
	return 1;
}

static int call_cn_world_cast_ray_any(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_ray ray_value;
	const cn_ray *ray = read_struct(L, 2, &record_cn_ray, &ray_value, 0, "ray");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t out_0;
	check(L, NULL, visited(L, self, cn_world_cast_ray_any(self->pointer, ray, filter, &out_0)));
	push_value(L, INT32, NULL, &out_0);
	return 1;
}

static int call_cn_world_cast_ray_all(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_ray ray_value;
	const cn_ray *ray = read_struct(L, 2, &record_cn_ray, &ray_value, 0, "ray");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_world_cast_ray_all(self->pointer, ray, filter, NULL, 0, &capacity)));
	cn_ray_hit *out = buffer(L, capacity, sizeof(cn_ray_hit));
	check(L, NULL, visited(L, self, cn_world_cast_ray_all(self->pointer, ray, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_ray_hit, out, out_count);
	return 1;
}

static int call_cn_world_cast_rays(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	int32_t rays_count;
	cn_ray *rays = read_array(L, 2, RECORD, &record_cn_ray, 0, "rays", &rays_count);
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t count = rays_count;
	cn_ray_hit *out = buffer(L, count, sizeof(cn_ray_hit));
	check(L, NULL, visited(L, self, cn_world_cast_rays(self->pointer, rays, count, filter, out)));
	write_array(L, 4, RECORD, &record_cn_ray_hit, out, count);
	return 1;
}

static int call_cn_shape_cast_ray(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_ray ray_value;
	const cn_ray *ray = read_struct(L, 3, &record_cn_ray, &ray_value, 0, "ray");
	cn_ray_hit out_0;
	check(L, NULL, cn_shape_cast_ray(self->pointer, shape, ray, &out_0));
	push_value(L, RECORD, &record_cn_ray_hit, &out_0);
	return 1;
}

static int call_cn_world_cast_shape(lua_State *L)
{
	lua_settop(L, 5);
	world_object *self = to_world(L);
	cn_polygon shape_value;
	const cn_polygon *shape = read_struct(L, 2, &record_cn_polygon, &shape_value, 0, "shape");
	float translation_x_m;
	read_value(L, 3, FLOAT, NULL, &translation_x_m, "translation_x_m");
	float translation_y_m;
	read_value(L, 4, FLOAT, NULL, &translation_y_m, "translation_y_m");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 5, &record_cn_query_filter, &filter_value, 1, "filter");
	cn_ray_hit out_0;
	check(L, NULL, visited(L, self, cn_world_cast_shape(self->pointer, shape, translation_x_m, translation_y_m, filter, &out_0)));
	push_value(L, RECORD, &record_cn_ray_hit, &out_0);
	return 1;
}

static int call_cn_world_overlap_aabb(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_aabb box_value;
	const cn_aabb *box = read_struct(L, 2, &record_cn_aabb, &box_value, 0, "box");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_world_overlap_aabb(self->pointer, box, filter, NULL, 0, &capacity)));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, visited(L, self, cn_world_overlap_aabb(self->pointer, box, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_overlap_circle(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_circle circle_value;
	const cn_circle *circle = read_struct(L, 2, &record_cn_circle, &circle_value, 0, "circle");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_world_overlap_circle(self->pointer, circle, filter, NULL, 0, &capacity)));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, visited(L, self, cn_world_overlap_circle(self->pointer, circle, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_overlap_polygon(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_world(L);
	cn_polygon polygon_value;
	const cn_polygon *polygon = read_struct(L, 2, &record_cn_polygon, &polygon_value, 0, "polygon");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 3, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_world_overlap_polygon(self->pointer, polygon, filter, NULL, 0, &capacity)));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, visited(L, self, cn_world_overlap_polygon(self->pointer, polygon, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_overlap_point(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_world(L);
	float x_m;
	read_value(L, 2, FLOAT, NULL, &x_m, "x_m");
	float y_m;
	read_value(L, 3, FLOAT, NULL, &y_m, "y_m");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 4, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_world_overlap_point(self->pointer, x_m, y_m, filter, NULL, 0, &capacity)));
	cn_shape *out = buffer(L, capacity, sizeof(cn_shape));
	check(L, NULL, visited(L, self, cn_world_overlap_point(self->pointer, x_m, y_m, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, UINT32, NULL, out, out_count);
	return 1;
}

static int call_cn_world_closest_point(lua_State *L)
{
	lua_settop(L, 5);
	world_object *self = to_world(L);
	float x_m;
	read_value(L, 2, FLOAT, NULL, &x_m, "x_m");
	float y_m;
	read_value(L, 3, FLOAT, NULL, &y_m, "y_m");
	float distance_max_m;
	read_value(L, 4, FLOAT, NULL, &distance_max_m, "distance_max_m");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 5, &record_cn_query_filter, &filter_value, 1, "filter");
	cn_closest out_0;
	check(L, NULL, visited(L, self, cn_world_closest_point(self->pointer, x_m, y_m, distance_max_m, filter, &out_0)));
	push_value(L, RECORD, &record_cn_closest, &out_0);
	return 1;
}

static int call_cn_mover_collide(lua_State *L)
{
	lua_settop(L, 6);
	world_object *self = to_world(L);
	cn_polygon shape_value;
	const cn_polygon *shape = read_struct(L, 2, &record_cn_polygon, &shape_value, 0, "shape");
	float position_x_m;
	read_value(L, 3, FLOAT, NULL, &position_x_m, "position_x_m");
	float position_y_m;
	read_value(L, 4, FLOAT, NULL, &position_y_m, "position_y_m");
	float margin_m;
	read_value(L, 5, FLOAT, NULL, &margin_m, "margin_m");
	cn_query_filter filter_value;
	const cn_query_filter *filter = read_struct(L, 6, &record_cn_query_filter, &filter_value, 1, "filter");
	int32_t capacity, out_count;
	check(L, NULL, visited(L, self, cn_mover_collide(self->pointer, shape, position_x_m, position_y_m, margin_m, filter, NULL, 0, &capacity)));
	cn_plane *out = buffer(L, capacity, sizeof(cn_plane));
	check(L, NULL, visited(L, self, cn_mover_collide(self->pointer, shape, position_x_m, position_y_m, margin_m, filter, out, capacity, &out_count)));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_plane, out, out_count);
	return 1;
}

static int call_cn_mover_move(lua_State *L)
{
	lua_settop(L, 4);
	world_object *self = to_changed_world(L);
	cn_mover_def def_value;
	const cn_mover_def *def = read_struct(L, 2, &record_cn_mover_def, &def_value, 0, "def");
	float dt_s;
	read_value(L, 3, FLOAT, NULL, &dt_s, "dt_s");
	cn_mover mover_value;
	cn_mover *mover = read_struct(L, 4, &record_cn_mover, &mover_value, 0, "mover");
	check(L, self, visited(L, self, cn_mover_move(self->pointer, def, dt_s, mover)));
	lua_pushvalue(L, 4);
	write_record(L, &record_cn_mover, mover);
	lua_pop(L, 1);
	return 0;
}

static int call_cn_shape_set_area(lua_State *L)
{
	lua_settop(L, 3);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_area_def def_value;
	const cn_area_def *def = read_struct(L, 3, &record_cn_area_def, &def_value, 1, "def");
	check(L, self, cn_shape_set_area(self->pointer, shape, def));
	return 0;
}

static int call_cn_shape_get_area(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	cn_area_def out_0;
	check(L, NULL, cn_shape_get_area(self->pointer, shape, &out_0));
	push_value(L, RECORD, &record_cn_area_def, &out_0);
	return 1;
}

static int call_cn_shape_apply_wind(lua_State *L)
{
	lua_settop(L, 8);
	world_object *self = to_changed_world(L);
	cn_shape shape;
	read_value(L, 2, UINT32, NULL, &shape, "shape");
	float flow_x_mps;
	read_value(L, 3, FLOAT, NULL, &flow_x_mps, "flow_x_mps");
	float flow_y_mps;
	read_value(L, 4, FLOAT, NULL, &flow_y_mps, "flow_y_mps");
	float drag_kgpm2;
	read_value(L, 5, FLOAT, NULL, &drag_kgpm2, "drag_kgpm2");
	float lift_kgpm2;
	read_value(L, 6, FLOAT, NULL, &lift_kgpm2, "lift_kgpm2");
	float dt_s;
	read_value(L, 7, FLOAT, NULL, &dt_s, "dt_s");
	int32_t wake;
	read_value(L, 8, INT32, NULL, &wake, "wake");
	check(L, self, cn_shape_apply_wind(self->pointer, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake));
	return 0;
}

static int call_cn_world_explode(lua_State *L)
{
	lua_settop(L, 2);
	world_object *self = to_changed_world(L);
	cn_explosion_def def_value;
	const cn_explosion_def *def = read_struct(L, 2, &record_cn_explosion_def, &def_value, 0, "def");
	check(L, self, visited(L, self, cn_world_explode(self->pointer, def)));
	return 0;
}

static const luaL_Reg world_calls[] = {
	{ "step", call_cn_world_step },
	{ "set_gravity", call_cn_world_set_gravity },
	{ "get_gravity", call_cn_world_get_gravity },
	{ "set_substep_count", call_cn_world_set_substep_count },
	{ "get_substep_count", call_cn_world_get_substep_count },
	{ "set_solver", call_cn_world_set_solver },
	{ "get_solver", call_cn_world_get_solver },
	{ "set_accuracy", call_cn_world_set_accuracy },
	{ "get_accuracy", call_cn_world_get_accuracy },
	{ "get_worker_count", call_cn_world_get_worker_count },
	{ "set_flags", call_cn_world_set_flags },
	{ "get_flags", call_cn_world_get_flags },
	{ "set_restitution_threshold", call_cn_world_set_restitution_threshold },
	{ "set_hit_speed", call_cn_world_set_hit_speed },
	{ "set_speed_limits", call_cn_world_set_speed_limits },
	{ "set_sleep", call_cn_world_set_sleep },
	{ "set_user_data", call_cn_world_set_user_data },
	{ "get_user_data", call_cn_world_get_user_data },
	{ "get_bodies", call_cn_world_get_bodies },
	{ "get_shapes", call_cn_world_get_shapes },
	{ "get_joints", call_cn_world_get_joints },
	{ "get_counters", call_cn_world_get_counters },
	{ "get_islands", call_cn_world_get_islands },
	{ "get_profile", call_cn_world_get_profile },
	{ "get_memory_stats", call_cn_world_get_memory_stats },
	{ "shift_origin", call_cn_world_shift_origin },
	{ "hash", call_cn_world_hash },
	{ "save_size", call_cn_world_save_size },
	{ "save", call_cn_world_save },
	{ "restore", call_cn_world_restore },
	{ "write_size", call_cn_world_write_size },
	{ "write", call_cn_world_write },
	{ "body_create", call_cn_body_create },
	{ "body_create_many", call_cn_body_create_many },
	{ "body_destroy", call_cn_body_destroy },
	{ "body_destroy_many", call_cn_body_destroy_many },
	{ "body_is_valid", call_cn_body_is_valid },
	{ "body_set_type", call_cn_body_set_type },
	{ "body_get_type", call_cn_body_get_type },
	{ "body_set_flags", call_cn_body_set_flags },
	{ "body_get_flags", call_cn_body_get_flags },
	{ "body_set_awake", call_cn_body_set_awake },
	{ "body_set_pose", call_cn_body_set_pose },
	{ "body_get_pose", call_cn_body_get_pose },
	{ "body_get_position_parts", call_cn_body_get_position_parts },
	{ "body_get_angle", call_cn_body_get_angle },
	{ "body_get_center", call_cn_body_get_center },
	{ "body_set_velocity", call_cn_body_set_velocity },
	{ "body_get_velocity", call_cn_body_get_velocity },
	{ "body_set_target_pose", call_cn_body_set_target_pose },
	{ "body_get_velocity_at", call_cn_body_get_velocity_at },
	{ "body_get_world_point", call_cn_body_get_world_point },
	{ "body_get_local_point", call_cn_body_get_local_point },
	{ "body_get_aabb", call_cn_body_get_aabb },
	{ "body_apply_force", call_cn_body_apply_force },
	{ "body_apply_force_at", call_cn_body_apply_force_at },
	{ "body_apply_torque", call_cn_body_apply_torque },
	{ "body_apply_impulse", call_cn_body_apply_impulse },
	{ "body_apply_impulse_at", call_cn_body_apply_impulse_at },
	{ "body_apply_angular_impulse", call_cn_body_apply_angular_impulse },
	{ "body_get_mass_data", call_cn_body_get_mass_data },
	{ "body_set_mass_data", call_cn_body_set_mass_data },
	{ "body_reset_mass_data", call_cn_body_reset_mass_data },
	{ "body_set_damping", call_cn_body_set_damping },
	{ "body_get_damping", call_cn_body_get_damping },
	{ "body_set_gravity_scale", call_cn_body_set_gravity_scale },
	{ "body_get_gravity_scale", call_cn_body_get_gravity_scale },
	{ "body_set_sleep_speed", call_cn_body_set_sleep_speed },
	{ "body_set_solver", call_cn_body_set_solver },
	{ "body_get_solver", call_cn_body_get_solver },
	{ "body_set_user_data", call_cn_body_set_user_data },
	{ "body_get_user_data", call_cn_body_get_user_data },
	{ "body_set_name", call_cn_body_set_name },
	{ "body_get_name", call_cn_body_get_name },
	{ "body_get_shapes", call_cn_body_get_shapes },
	{ "body_get_joints", call_cn_body_get_joints },
	{ "read_poses", call_cn_world_read_poses },
	{ "read_velocities", call_cn_world_read_velocities },
	{ "write_velocities", call_cn_world_write_velocities },
	{ "moved", call_cn_world_moved },
	{ "shape_create_circle", call_cn_shape_create_circle },
	{ "shape_create_capsule", call_cn_shape_create_capsule },
	{ "shape_create_edge", call_cn_shape_create_edge },
	{ "shape_create_polygon", call_cn_shape_create_polygon },
	{ "shape_create_box", call_cn_shape_create_box },
	{ "shape_create_chain", call_cn_shape_create_chain },
	{ "shape_attach", call_cn_shape_attach },
	{ "shape_detach", call_cn_shape_detach },
	{ "shape_destroy", call_cn_shape_destroy },
	{ "shape_is_valid", call_cn_shape_is_valid },
	{ "shape_get_type", call_cn_shape_get_type },
	{ "shape_get_body", call_cn_shape_get_body },
	{ "shape_set_material", call_cn_shape_set_material },
	{ "shape_get_material", call_cn_shape_get_material },
	{ "shape_set_density", call_cn_shape_set_density },
	{ "shape_get_density", call_cn_shape_get_density },
	{ "shape_set_filter", call_cn_shape_set_filter },
	{ "shape_get_filter", call_cn_shape_get_filter },
	{ "shape_set_event_mask", call_cn_shape_set_event_mask },
	{ "shape_get_event_mask", call_cn_shape_get_event_mask },
	{ "shape_set_flags", call_cn_shape_set_flags },
	{ "shape_get_flags", call_cn_shape_get_flags },
	{ "shape_set_user_data", call_cn_shape_set_user_data },
	{ "shape_get_user_data", call_cn_shape_get_user_data },
	{ "shape_get_aabb", call_cn_shape_get_aabb },
	{ "shape_get_mass_data", call_cn_shape_get_mass_data },
	{ "shape_get_circle", call_cn_shape_get_circle },
	{ "shape_get_capsule", call_cn_shape_get_capsule },
	{ "shape_get_edge", call_cn_shape_get_edge },
	{ "shape_get_polygon", call_cn_shape_get_polygon },
	{ "shape_get_chain_points", call_cn_shape_get_chain_points },
	{ "shape_set_circle", call_cn_shape_set_circle },
	{ "shape_set_capsule", call_cn_shape_set_capsule },
	{ "shape_set_edge", call_cn_shape_set_edge },
	{ "shape_set_polygon", call_cn_shape_set_polygon },
	{ "shape_set_chain", call_cn_shape_set_chain },
	{ "shape_test_point", call_cn_shape_test_point },
	{ "contact_events", call_cn_world_contact_events },
	{ "sensor_events", call_cn_world_sensor_events },
	{ "body_get_contacts", call_cn_body_get_contacts },
	{ "shape_get_contacts", call_cn_shape_get_contacts },
	{ "shape_get_visitors", call_cn_shape_get_visitors },
	{ "fell_asleep", call_cn_world_fell_asleep },
	{ "joint_create_revolute", call_cn_joint_create_revolute },
	{ "joint_create_distance", call_cn_joint_create_distance },
	{ "joint_create_fixed", call_cn_joint_create_fixed },
	{ "joint_create_prismatic", call_cn_joint_create_prismatic },
	{ "joint_create_wheel", call_cn_joint_create_wheel },
	{ "joint_create_motor", call_cn_joint_create_motor },
	{ "joint_create_mouse", call_cn_joint_create_mouse },
	{ "joint_create_gear", call_cn_joint_create_gear },
	{ "joint_create_pulley", call_cn_joint_create_pulley },
	{ "joint_create_ratchet", call_cn_joint_create_ratchet },
	{ "joint_create_rotary_spring", call_cn_joint_create_rotary_spring },
	{ "joint_create_groove", call_cn_joint_create_groove },
	{ "joint_create_filter", call_cn_joint_create_filter },
	{ "joint_destroy", call_cn_joint_destroy },
	{ "joint_is_valid", call_cn_joint_is_valid },
	{ "joint_get_type", call_cn_joint_get_type },
	{ "joint_get_bodies", call_cn_joint_get_bodies },
	{ "joint_get_anchors", call_cn_joint_get_anchors },
	{ "joint_get_reaction", call_cn_joint_get_reaction },
	{ "joint_get_error", call_cn_joint_get_error },
	{ "joint_set_solver", call_cn_joint_set_solver },
	{ "joint_get_solver", call_cn_joint_get_solver },
	{ "joint_set_user_data", call_cn_joint_set_user_data },
	{ "joint_get_user_data", call_cn_joint_get_user_data },
	{ "joint_set_flags", call_cn_joint_set_flags },
	{ "joint_get_flags", call_cn_joint_get_flags },
	{ "joint_get_revolute", call_cn_joint_get_revolute },
	{ "joint_set_revolute", call_cn_joint_set_revolute },
	{ "joint_get_distance", call_cn_joint_get_distance },
	{ "joint_set_distance", call_cn_joint_set_distance },
	{ "joint_get_fixed", call_cn_joint_get_fixed },
	{ "joint_set_fixed", call_cn_joint_set_fixed },
	{ "joint_get_prismatic", call_cn_joint_get_prismatic },
	{ "joint_set_prismatic", call_cn_joint_set_prismatic },
	{ "joint_get_wheel", call_cn_joint_get_wheel },
	{ "joint_set_wheel", call_cn_joint_set_wheel },
	{ "joint_get_motor_to", call_cn_joint_get_motor_to },
	{ "joint_set_motor_to", call_cn_joint_set_motor_to },
	{ "joint_get_mouse", call_cn_joint_get_mouse },
	{ "joint_set_mouse", call_cn_joint_set_mouse },
	{ "joint_get_gear", call_cn_joint_get_gear },
	{ "joint_set_gear", call_cn_joint_set_gear },
	{ "joint_get_pulley", call_cn_joint_get_pulley },
	{ "joint_set_pulley", call_cn_joint_set_pulley },
	{ "joint_get_ratchet", call_cn_joint_get_ratchet },
	{ "joint_set_ratchet", call_cn_joint_set_ratchet },
	{ "joint_get_rotary_spring", call_cn_joint_get_rotary_spring },
	{ "joint_set_rotary_spring", call_cn_joint_set_rotary_spring },
	{ "joint_get_groove", call_cn_joint_get_groove },
	{ "joint_set_groove", call_cn_joint_set_groove },
	{ "joint_get_base", call_cn_joint_get_base },
	{ "joint_set_base", call_cn_joint_set_base },
	{ "joint_set_target", call_cn_joint_set_target },
	{ "joint_get_position", call_cn_joint_get_position },
	{ "joint_get_speed", call_cn_joint_get_speed },
	{ "joint_set_motor", call_cn_joint_set_motor },
	{ "joint_set_limits", call_cn_joint_set_limits },
	{ "joint_events", call_cn_world_joint_events },
	{ "constraint_create_angle", call_cn_constraint_create_angle },
	{ "constraint_create_line", call_cn_constraint_create_line },
	{ "constraint_destroy", call_cn_constraint_destroy },
	{ "constraint_is_valid", call_cn_constraint_is_valid },
	{ "constraint_get_type", call_cn_constraint_get_type },
	{ "constraint_get_body", call_cn_constraint_get_body },
	{ "constraint_get_angle", call_cn_constraint_get_angle },
	{ "constraint_set_angle", call_cn_constraint_set_angle },
	{ "constraint_get_line", call_cn_constraint_get_line },
	{ "constraint_set_line", call_cn_constraint_set_line },
	{ "constraint_get_position", call_cn_constraint_get_position },
	{ "constraint_get_reaction", call_cn_constraint_get_reaction },
	{ "constraint_get_error", call_cn_constraint_get_error },
	{ "get_constraints", call_cn_world_get_constraints },
	{ "body_get_constraints", call_cn_body_get_constraints },
	{ "set_fixed_step", call_cn_world_set_fixed_step },
	{ "update", call_cn_world_update },
	{ "read_poses_interpolated", call_cn_world_read_poses_interpolated },
	{ "cast_ray", call_cn_world_cast_ray },
	{ "cast_ray_any", call_cn_world_cast_ray_any },
	{ "cast_ray_all", call_cn_world_cast_ray_all },
	{ "cast_rays", call_cn_world_cast_rays },
	{ "shape_cast_ray", call_cn_shape_cast_ray },
	{ "cast_shape", call_cn_world_cast_shape },
	{ "overlap_aabb", call_cn_world_overlap_aabb },
	{ "overlap_circle", call_cn_world_overlap_circle },
	{ "overlap_polygon", call_cn_world_overlap_polygon },
	{ "overlap_point", call_cn_world_overlap_point },
	{ "closest_point", call_cn_world_closest_point },
	{ "mover_collide", call_cn_mover_collide },
	{ "mover_move", call_cn_mover_move },
	{ "shape_set_area", call_cn_shape_set_area },
	{ "shape_get_area", call_cn_shape_get_area },
	{ "shape_apply_wind", call_cn_shape_apply_wind },
	{ "explode", call_cn_world_explode },
	{ NULL, NULL },
};

static int call_cn_tree_insert(lua_State *L)
{
	lua_settop(L, 3);
	tree_object *self = to_tree(L);
	cn_aabb box_value;
	const cn_aabb *box = read_struct(L, 2, &record_cn_aabb, &box_value, 0, "box");
	uint64_t user_data;
	read_value(L, 3, UINT64, NULL, &user_data, "user_data");
	uint32_t out_0;
	check(L, NULL, cn_tree_insert(self->pointer, box, user_data, &out_0));
	push_value(L, UINT32, NULL, &out_0);
	return 1;
}

static int call_cn_tree_remove(lua_State *L)
{
	lua_settop(L, 2);
	tree_object *self = to_tree(L);
	uint32_t item;
	read_value(L, 2, UINT32, NULL, &item, "item");
	check(L, NULL, cn_tree_remove(self->pointer, item));
	return 0;
}

static int call_cn_tree_move(lua_State *L)
{
	lua_settop(L, 3);
	tree_object *self = to_tree(L);
	uint32_t item;
	read_value(L, 2, UINT32, NULL, &item, "item");
	cn_aabb box_value;
	const cn_aabb *box = read_struct(L, 3, &record_cn_aabb, &box_value, 0, "box");
	check(L, NULL, cn_tree_move(self->pointer, item, box));
	return 0;
}

static int call_cn_tree_get_box(lua_State *L)
{
	lua_settop(L, 2);
	tree_object *self = to_tree(L);
	uint32_t item;
	read_value(L, 2, UINT32, NULL, &item, "item");
	cn_aabb out_0;
	check(L, NULL, cn_tree_get_box(self->pointer, item, &out_0));
	push_value(L, RECORD, &record_cn_aabb, &out_0);
	return 1;
}

static int call_cn_tree_get_stats(lua_State *L)
{
	lua_settop(L, 1);
	tree_object *self = to_tree(L);
	int32_t out_0;
	int32_t out_1;
	check(L, NULL, cn_tree_get_stats(self->pointer, &out_0, &out_1));
	push_value(L, INT32, NULL, &out_0);
	push_value(L, INT32, NULL, &out_1);
	return 2;
}

static const luaL_Reg tree_calls[] = {
	{ "insert", call_cn_tree_insert },
	{ "remove", call_cn_tree_remove },
	{ "move", call_cn_tree_move },
	{ "get_box", call_cn_tree_get_box },
	{ "get_stats", call_cn_tree_get_stats },
	{ NULL, NULL },
};

static int call_cn_version(lua_State *L)
{
	lua_settop(L, 0);
	push_whole(L, cn_version());
	return 1;
}

static int call_cn_abi_version(lua_State *L)
{
	lua_settop(L, 0);
	push_whole(L, cn_abi_version());
	return 1;
}

static int call_cn_result_text(lua_State *L)
{
	lua_settop(L, 1);
	cn_result result;
	read_value(L, 1, INT32, NULL, &result, "result");
	lua_pushstring(L, cn_result_text(result));
	return 1;
}

static int call_cn_save_delta_size(lua_State *L)
{
	lua_settop(L, 2);
	size_t base_bytes;
	const void *base = luaL_checklstring(L, 1, &base_bytes);
	size_t save_bytes;
	const void *save = luaL_checklstring(L, 2, &save_bytes);
	uint64_t out_0;
	check(L, NULL, cn_save_delta_size(base, base_bytes, save, save_bytes, &out_0));
	push_value(L, UINT64, NULL, &out_0);
	return 1;
}

static int call_cn_save_delta(lua_State *L)
{
	lua_settop(L, 2);
	size_t base_bytes;
	const void *base = luaL_checklstring(L, 1, &base_bytes);
	size_t save_bytes;
	const void *save = luaL_checklstring(L, 2, &save_bytes);
	uint64_t room;
	check(L, NULL, cn_save_delta_size(base, base_bytes, save, save_bytes, &room));
	void *out = lua_newuserdata(L, room > 0 ? (size_t)room : 1);
	check(L, NULL, cn_save_delta(base, base_bytes, save, save_bytes, out, room, &room));
	lua_pushlstring(L, out, (size_t)room);
	return 1;
}

static int call_cn_save_apply(lua_State *L)
{
	lua_settop(L, 2);
	size_t base_bytes;
	const void *base = luaL_checklstring(L, 1, &base_bytes);
	size_t delta_bytes;
	const void *delta = luaL_checklstring(L, 2, &delta_bytes);
	uint64_t room = base_bytes + delta_bytes;
	void *out = lua_newuserdata(L, room > 0 ? (size_t)room : 1);
	check(L, NULL, cn_save_apply(base, base_bytes, delta, delta_bytes, out, room, &room));
	lua_pushlstring(L, out, (size_t)room);
	return 1;
}

static int call_cn_polygon_make_hull(lua_State *L)
{
	lua_settop(L, 2);
	int32_t points_m_count;
	cn_vec2 *points_m = read_array(L, 1, RECORD, &record_cn_vec2, 0, "points_m", &points_m_count);
	float radius_m;
	read_value(L, 2, FLOAT, NULL, &radius_m, "radius_m");
	int32_t count = points_m_count;
	cn_polygon out_0;
	check(L, NULL, cn_polygon_make_hull(points_m, count, radius_m, &out_0));
	push_value(L, RECORD, &record_cn_polygon, &out_0);
	return 1;
}

static int call_cn_polygon_make_box(lua_State *L)
{
	lua_settop(L, 6);
	float half_width_m;
	read_value(L, 1, FLOAT, NULL, &half_width_m, "half_width_m");
	float half_height_m;
	read_value(L, 2, FLOAT, NULL, &half_height_m, "half_height_m");
	float center_x_m;
	read_value(L, 3, FLOAT, NULL, &center_x_m, "center_x_m");
	float center_y_m;
	read_value(L, 4, FLOAT, NULL, &center_y_m, "center_y_m");
	float angle_rad;
	read_value(L, 5, FLOAT, NULL, &angle_rad, "angle_rad");
	float radius_m;
	read_value(L, 6, FLOAT, NULL, &radius_m, "radius_m");
	cn_polygon out_0;
	check(L, NULL, cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, &out_0));
	push_value(L, RECORD, &record_cn_polygon, &out_0);
	return 1;
}

static int call_cn_outline_decompose(lua_State *L)
{
	lua_settop(L, 2);
	int32_t points_m_count;
	cn_vec2 *points_m = read_array(L, 1, RECORD, &record_cn_vec2, 0, "points_m", &points_m_count);
	float length_unit_m;
	read_value(L, 2, FLOAT, NULL, &length_unit_m, "length_unit_m");
	int32_t count = points_m_count;
	int32_t capacity, out_count;
	check(L, NULL, cn_outline_decompose(points_m, count, length_unit_m, NULL, 0, &capacity));
	cn_polygon *out = buffer(L, capacity, sizeof(cn_polygon));
	check(L, NULL, cn_outline_decompose(points_m, count, length_unit_m, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_polygon, out, out_count);
	return 1;
}

static int call_cn_outline_simplify(lua_State *L)
{
	lua_settop(L, 3);
	int32_t points_m_count;
	cn_vec2 *points_m = read_array(L, 1, RECORD, &record_cn_vec2, 0, "points_m", &points_m_count);
	int32_t closed;
	read_value(L, 2, INT32, NULL, &closed, "closed");
	float tolerance_m;
	read_value(L, 3, FLOAT, NULL, &tolerance_m, "tolerance_m");
	int32_t count = points_m_count;
	int32_t capacity, out_count;
	check(L, NULL, cn_outline_simplify(points_m, count, closed, tolerance_m, NULL, 0, &capacity));
	cn_vec2 *out = buffer(L, capacity, sizeof(cn_vec2));
	check(L, NULL, cn_outline_simplify(points_m, count, closed, tolerance_m, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_vec2, out, out_count);
	return 1;
}

static int call_cn_outline_from_cells(lua_State *L)
{
	lua_settop(L, 6);
	int32_t cells_count;
	uint8_t *cells = read_array(L, 1, UINT8, NULL, 0, "cells", &cells_count);
	int32_t columns;
	read_value(L, 2, INT32, NULL, &columns, "columns");
	float origin_x_m;
	read_value(L, 3, FLOAT, NULL, &origin_x_m, "origin_x_m");
	float origin_y_m;
	read_value(L, 4, FLOAT, NULL, &origin_y_m, "origin_y_m");
	float cell_m;
	read_value(L, 5, FLOAT, NULL, &cell_m, "cell_m");
	int32_t outline;
	read_value(L, 6, INT32, NULL, &outline, "outline");
	int32_t count = cells_count;
	int32_t capacity, out_count;
	check(L, NULL, cn_outline_from_cells(cells, count, columns, origin_x_m, origin_y_m, cell_m, outline, NULL, 0, &capacity));
	cn_vec2 *out = buffer(L, capacity, sizeof(cn_vec2));
	check(L, NULL, cn_outline_from_cells(cells, count, columns, origin_x_m, origin_y_m, cell_m, outline, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_vec2, out, out_count);
	return 1;
}

static int call_cn_outline_from_field(lua_State *L)
{
	lua_settop(L, 7);
	int32_t values_count;
	float *values = read_array(L, 1, FLOAT, NULL, 0, "values", &values_count);
	int32_t columns;
	read_value(L, 2, INT32, NULL, &columns, "columns");
	float threshold;
	read_value(L, 3, FLOAT, NULL, &threshold, "threshold");
	float origin_x_m;
	read_value(L, 4, FLOAT, NULL, &origin_x_m, "origin_x_m");
	float origin_y_m;
	read_value(L, 5, FLOAT, NULL, &origin_y_m, "origin_y_m");
	float spacing_m;
	read_value(L, 6, FLOAT, NULL, &spacing_m, "spacing_m");
	int32_t outline;
	read_value(L, 7, INT32, NULL, &outline, "outline");
	int32_t count = values_count;
	int32_t capacity, out_count;
	check(L, NULL, cn_outline_from_field(values, count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, NULL, 0, &capacity));
	cn_vec2 *out = buffer(L, capacity, sizeof(cn_vec2));
	check(L, NULL, cn_outline_from_field(values, count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, out, capacity, &out_count));
	out_count = out_count < capacity ? out_count : capacity;
	write_array(L, 0, RECORD, &record_cn_vec2, out, out_count);
	return 1;
}

static int call_cn_polygon_distance(lua_State *L)
{
	lua_settop(L, 4);
	cn_polygon a_value;
	const cn_polygon *a = read_struct(L, 1, &record_cn_polygon, &a_value, 0, "a");
	cn_pose pose_a_value;
	const cn_pose *pose_a = read_struct(L, 2, &record_cn_pose, &pose_a_value, 0, "pose_a");
	cn_polygon b_value;
	const cn_polygon *b = read_struct(L, 3, &record_cn_polygon, &b_value, 0, "b");
	cn_pose pose_b_value;
	const cn_pose *pose_b = read_struct(L, 4, &record_cn_pose, &pose_b_value, 0, "pose_b");
	cn_distance out_0;
	check(L, NULL, cn_polygon_distance(a, pose_a, b, pose_b, &out_0));
	push_value(L, RECORD, &record_cn_distance, &out_0);
	return 1;
}

static int call_cn_polygon_cast(lua_State *L)
{
	lua_settop(L, 6);
	cn_polygon a_value;
	const cn_polygon *a = read_struct(L, 1, &record_cn_polygon, &a_value, 0, "a");
	cn_pose pose_a_value;
	const cn_pose *pose_a = read_struct(L, 2, &record_cn_pose, &pose_a_value, 0, "pose_a");
	cn_polygon b_value;
	const cn_polygon *b = read_struct(L, 3, &record_cn_polygon, &b_value, 0, "b");
	cn_pose pose_b_value;
	const cn_pose *pose_b = read_struct(L, 4, &record_cn_pose, &pose_b_value, 0, "pose_b");
	float translation_x_m;
	read_value(L, 5, FLOAT, NULL, &translation_x_m, "translation_x_m");
	float translation_y_m;
	read_value(L, 6, FLOAT, NULL, &translation_y_m, "translation_y_m");
	cn_ray_hit out_0;
	int32_t out_1;
	check(L, NULL, cn_polygon_cast(a, pose_a, b, pose_b, translation_x_m, translation_y_m, &out_0, &out_1));
	push_value(L, RECORD, &record_cn_ray_hit, &out_0);
	push_value(L, INT32, NULL, &out_1);
	return 2;
}

static int call_cn_polygon_collide(lua_State *L)
{
	lua_settop(L, 5);
	cn_polygon a_value;
	const cn_polygon *a = read_struct(L, 1, &record_cn_polygon, &a_value, 0, "a");
	cn_pose pose_a_value;
	const cn_pose *pose_a = read_struct(L, 2, &record_cn_pose, &pose_a_value, 0, "pose_a");
	cn_polygon b_value;
	const cn_polygon *b = read_struct(L, 3, &record_cn_polygon, &b_value, 0, "b");
	cn_pose pose_b_value;
	const cn_pose *pose_b = read_struct(L, 4, &record_cn_pose, &pose_b_value, 0, "pose_b");
	float margin_m;
	read_value(L, 5, FLOAT, NULL, &margin_m, "margin_m");
	cn_manifold out_0;
	check(L, NULL, cn_polygon_collide(a, pose_a, b, pose_b, margin_m, &out_0));
	push_value(L, RECORD, &record_cn_manifold, &out_0);
	return 1;
}

static int call_cn_polygon_time_of_impact(lua_State *L)
{
	lua_settop(L, 5);
	cn_polygon a_value;
	const cn_polygon *a = read_struct(L, 1, &record_cn_polygon, &a_value, 0, "a");
	cn_sweep sweep_a_value;
	const cn_sweep *sweep_a = read_struct(L, 2, &record_cn_sweep, &sweep_a_value, 0, "sweep_a");
	cn_polygon b_value;
	const cn_polygon *b = read_struct(L, 3, &record_cn_polygon, &b_value, 0, "b");
	cn_sweep sweep_b_value;
	const cn_sweep *sweep_b = read_struct(L, 4, &record_cn_sweep, &sweep_b_value, 0, "sweep_b");
	float distance_m;
	read_value(L, 5, FLOAT, NULL, &distance_m, "distance_m");
	cn_impact out_0;
	check(L, NULL, cn_polygon_time_of_impact(a, sweep_a, b, sweep_b, distance_m, &out_0));
	push_value(L, RECORD, &record_cn_impact, &out_0);
	return 1;
}

static int call_cn_mover_solve(lua_State *L)
{
	lua_settop(L, 3);
	int32_t planes_count;
	cn_plane *planes = read_array(L, 1, RECORD, &record_cn_plane, 0, "planes", &planes_count);
	float translation_x_m;
	read_value(L, 2, FLOAT, NULL, &translation_x_m, "translation_x_m");
	float translation_y_m;
	read_value(L, 3, FLOAT, NULL, &translation_y_m, "translation_y_m");
	int32_t count = planes_count;
	cn_vec2 out_0;
	float out_1;
	check(L, NULL, cn_mover_solve(planes, count, translation_x_m, translation_y_m, &out_0, &out_1));
	write_array(L, 1, RECORD, &record_cn_plane, planes, count);
	lua_pop(L, 1);
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	push_value(L, FLOAT, NULL, &out_1);
	return 2;
}

static int call_cn_mover_clip(lua_State *L)
{
	lua_settop(L, 3);
	int32_t planes_count;
	cn_plane *planes = read_array(L, 1, RECORD, &record_cn_plane, 0, "planes", &planes_count);
	float velocity_x_mps;
	read_value(L, 2, FLOAT, NULL, &velocity_x_mps, "velocity_x_mps");
	float velocity_y_mps;
	read_value(L, 3, FLOAT, NULL, &velocity_y_mps, "velocity_y_mps");
	int32_t count = planes_count;
	cn_vec2 out_0;
	check(L, NULL, cn_mover_clip(planes, count, velocity_x_mps, velocity_y_mps, &out_0));
	push_value(L, RECORD, &record_cn_vec2, &out_0);
	return 1;
}

static const luaL_Reg library_calls[] = {
	{ "version", call_cn_version },
	{ "abi_version", call_cn_abi_version },
	{ "result_text", call_cn_result_text },
	{ "save_delta_size", call_cn_save_delta_size },
	{ "save_delta", call_cn_save_delta },
	{ "save_apply", call_cn_save_apply },
	{ "polygon_make_hull", call_cn_polygon_make_hull },
	{ "polygon_make_box", call_cn_polygon_make_box },
	{ "outline_decompose", call_cn_outline_decompose },
	{ "outline_simplify", call_cn_outline_simplify },
	{ "outline_from_cells", call_cn_outline_from_cells },
	{ "outline_from_field", call_cn_outline_from_field },
	{ "polygon_distance", call_cn_polygon_distance },
	{ "polygon_cast", call_cn_polygon_cast },
	{ "polygon_collide", call_cn_polygon_collide },
	{ "polygon_time_of_impact", call_cn_polygon_time_of_impact },
	{ "mover_solve", call_cn_mover_solve },
	{ "mover_clip", call_cn_mover_clip },
	{ NULL, NULL },
};

static const struct {
	const char *name;
	int32_t value;
} constants[] = {
	{ "VERSION_MAJOR", (int32_t)CN_VERSION_MAJOR },
	{ "VERSION_MINOR", (int32_t)CN_VERSION_MINOR },
	{ "VERSION_PATCH", (int32_t)CN_VERSION_PATCH },
	{ "ABI_VERSION", (int32_t)CN_ABI_VERSION },
	{ "POLYGON_MAX_VERTICES", (int32_t)CN_POLYGON_MAX_VERTICES },
	{ "NAME_MAX_BYTES", (int32_t)CN_NAME_MAX_BYTES },
	{ "PLANES_MAX", (int32_t)CN_PLANES_MAX },
	{ "WORKERS_MAX", (int32_t)CN_WORKERS_MAX },
	{ "MAX_HANDLES", (int32_t)CN_MAX_HANDLES },
	{ "DEFAULT", (int32_t)CN_DEFAULT },
	{ "OK", (int32_t)CN_OK },
	{ "ERROR_ARGUMENT", (int32_t)CN_ERROR_ARGUMENT },
	{ "ERROR_HANDLE", (int32_t)CN_ERROR_HANDLE },
	{ "ERROR_MEMORY", (int32_t)CN_ERROR_MEMORY },
	{ "ERROR_LOCKED", (int32_t)CN_ERROR_LOCKED },
	{ "ERROR_CAPACITY", (int32_t)CN_ERROR_CAPACITY },
	{ "ERROR_STATE", (int32_t)CN_ERROR_STATE },
	{ "ERROR_INTERNAL", (int32_t)CN_ERROR_INTERNAL },
	{ "ERROR_FORMAT", (int32_t)CN_ERROR_FORMAT },
	{ "TYPE_VEC2", (int32_t)CN_TYPE_VEC2 },
	{ "TYPE_POSE", (int32_t)CN_TYPE_POSE },
	{ "TYPE_VELOCITY", (int32_t)CN_TYPE_VELOCITY },
	{ "TYPE_AABB", (int32_t)CN_TYPE_AABB },
	{ "TYPE_MASS_DATA", (int32_t)CN_TYPE_MASS_DATA },
	{ "TYPE_WORLD_DEF", (int32_t)CN_TYPE_WORLD_DEF },
	{ "TYPE_BODY_DEF", (int32_t)CN_TYPE_BODY_DEF },
	{ "TYPE_SHAPE_DEF", (int32_t)CN_TYPE_SHAPE_DEF },
	{ "TYPE_CIRCLE", (int32_t)CN_TYPE_CIRCLE },
	{ "TYPE_CAPSULE", (int32_t)CN_TYPE_CAPSULE },
	{ "TYPE_EDGE", (int32_t)CN_TYPE_EDGE },
	{ "TYPE_POLYGON", (int32_t)CN_TYPE_POLYGON },
	{ "TYPE_CHAIN", (int32_t)CN_TYPE_CHAIN },
	{ "TYPE_FILTER", (int32_t)CN_TYPE_FILTER },
	{ "TYPE_MATERIAL", (int32_t)CN_TYPE_MATERIAL },
	{ "TYPE_MANIFOLD_POINT", (int32_t)CN_TYPE_MANIFOLD_POINT },
	{ "TYPE_MANIFOLD", (int32_t)CN_TYPE_MANIFOLD },
	{ "TYPE_CONTACT_EVENT", (int32_t)CN_TYPE_CONTACT_EVENT },
	{ "TYPE_BODY_MOVED", (int32_t)CN_TYPE_BODY_MOVED },
	{ "TYPE_REVOLUTE_DEF", (int32_t)CN_TYPE_REVOLUTE_DEF },
	{ "TYPE_DISTANCE_DEF", (int32_t)CN_TYPE_DISTANCE_DEF },
	{ "TYPE_COUNTERS", (int32_t)CN_TYPE_COUNTERS },
	{ "TYPE_PROFILE", (int32_t)CN_TYPE_PROFILE },
	{ "TYPE_MEMORY_STATS", (int32_t)CN_TYPE_MEMORY_STATS },
	{ "TYPE_SENSOR_EVENT", (int32_t)CN_TYPE_SENSOR_EVENT },
	{ "TYPE_UPDATE_REPORT", (int32_t)CN_TYPE_UPDATE_REPORT },
	{ "TYPE_DEBUG_DRAW", (int32_t)CN_TYPE_DEBUG_DRAW },
	{ "TYPE_QUERY_FILTER", (int32_t)CN_TYPE_QUERY_FILTER },
	{ "TYPE_RAY", (int32_t)CN_TYPE_RAY },
	{ "TYPE_RAY_HIT", (int32_t)CN_TYPE_RAY_HIT },
	{ "TYPE_CLOSEST", (int32_t)CN_TYPE_CLOSEST },
	{ "TYPE_EXPLOSION_DEF", (int32_t)CN_TYPE_EXPLOSION_DEF },
	{ "TYPE_FIXED_DEF", (int32_t)CN_TYPE_FIXED_DEF },
	{ "TYPE_PRISMATIC_DEF", (int32_t)CN_TYPE_PRISMATIC_DEF },
	{ "TYPE_WHEEL_DEF", (int32_t)CN_TYPE_WHEEL_DEF },
	{ "TYPE_MOTOR_DEF", (int32_t)CN_TYPE_MOTOR_DEF },
	{ "TYPE_MOUSE_DEF", (int32_t)CN_TYPE_MOUSE_DEF },
	{ "TYPE_GEAR_DEF", (int32_t)CN_TYPE_GEAR_DEF },
	{ "TYPE_PULLEY_DEF", (int32_t)CN_TYPE_PULLEY_DEF },
	{ "TYPE_RATCHET_DEF", (int32_t)CN_TYPE_RATCHET_DEF },
	{ "TYPE_ROTARY_SPRING_DEF", (int32_t)CN_TYPE_ROTARY_SPRING_DEF },
	{ "TYPE_GROOVE_DEF", (int32_t)CN_TYPE_GROOVE_DEF },
	{ "TYPE_FILTER_JOINT_DEF", (int32_t)CN_TYPE_FILTER_JOINT_DEF },
	{ "TYPE_JOINT_BASE", (int32_t)CN_TYPE_JOINT_BASE },
	{ "TYPE_JOINT_EVENT", (int32_t)CN_TYPE_JOINT_EVENT },
	{ "TYPE_ANGLE_CONSTRAINT_DEF", (int32_t)CN_TYPE_ANGLE_CONSTRAINT_DEF },
	{ "TYPE_LINE_CONSTRAINT_DEF", (int32_t)CN_TYPE_LINE_CONSTRAINT_DEF },
	{ "TYPE_ISLAND_REPORT", (int32_t)CN_TYPE_ISLAND_REPORT },
	{ "TYPE_DISTANCE", (int32_t)CN_TYPE_DISTANCE },
	{ "TYPE_SWEEP", (int32_t)CN_TYPE_SWEEP },
	{ "TYPE_IMPACT", (int32_t)CN_TYPE_IMPACT },
	{ "TYPE_PLANE", (int32_t)CN_TYPE_PLANE },
	{ "TYPE_MOVER_DEF", (int32_t)CN_TYPE_MOVER_DEF },
	{ "TYPE_MOVER", (int32_t)CN_TYPE_MOVER },
	{ "TYPE_AREA_DEF", (int32_t)CN_TYPE_AREA_DEF },
	{ "TYPE_COUNT", (int32_t)CN_TYPE_COUNT },
	{ "WORLD_SLEEP", (int32_t)CN_WORLD_SLEEP },
	{ "WORLD_WARM_START", (int32_t)CN_WORLD_WARM_START },
	{ "WORLD_PROFILE", (int32_t)CN_WORLD_PROFILE },
	{ "WORLD_CONTINUOUS", (int32_t)CN_WORLD_CONTINUOUS },
	{ "RESERVE_NAMES", (int32_t)CN_RESERVE_NAMES },
	{ "RESERVE_CHAINS", (int32_t)CN_RESERVE_CHAINS },
	{ "RESERVE_EXTRA_ROWS", (int32_t)CN_RESERVE_EXTRA_ROWS },
	{ "RESERVE_MOVED", (int32_t)CN_RESERVE_MOVED },
	{ "SOLVER_AUTO", (int32_t)CN_SOLVER_AUTO },
	{ "SOLVER_SOFT", (int32_t)CN_SOLVER_SOFT },
	{ "SOLVER_DIRECT", (int32_t)CN_SOLVER_DIRECT },
	{ "SOLVER_SEQUENTIAL", (int32_t)CN_SOLVER_SEQUENTIAL },
	{ "BROADPHASE_SWEEP", (int32_t)CN_BROADPHASE_SWEEP },
	{ "BROADPHASE_TREE", (int32_t)CN_BROADPHASE_TREE },
	{ "WARNING_CONTACT_MEMORY", (int32_t)CN_WARNING_CONTACT_MEMORY },
	{ "WARNING_FRAME_MEMORY", (int32_t)CN_WARNING_FRAME_MEMORY },
	{ "WARNING_EVENT_MEMORY", (int32_t)CN_WARNING_EVENT_MEMORY },
	{ "WARNING_CROWD", (int32_t)CN_WARNING_CROWD },
	{ "WARNING_NOT_FINITE", (int32_t)CN_WARNING_NOT_FINITE },
	{ "TIER_SOFT", (int32_t)CN_TIER_SOFT },
	{ "TIER_DIRECT", (int32_t)CN_TIER_DIRECT },
	{ "TIER_FREE", (int32_t)CN_TIER_FREE },
	{ "TIER_REASON_NONE", (int32_t)CN_TIER_REASON_NONE },
	{ "TIER_REASON_SETTLING", (int32_t)CN_TIER_REASON_SETTLING },
	{ "TIER_REASON_NEW_CONTACT", (int32_t)CN_TIER_REASON_NEW_CONTACT },
	{ "TIER_REASON_OVERLAP", (int32_t)CN_TIER_REASON_OVERLAP },
	{ "TIER_REASON_JOINT", (int32_t)CN_TIER_REASON_JOINT },
	{ "TIER_REASON_STRESSED", (int32_t)CN_TIER_REASON_STRESSED },
	{ "TIER_REASON_SOLVER", (int32_t)CN_TIER_REASON_SOLVER },
	{ "TIER_REASON_OVERRIDE", (int32_t)CN_TIER_REASON_OVERRIDE },
	{ "TIER_REASON_ALONE", (int32_t)CN_TIER_REASON_ALONE },
	{ "TIER_REASON_MOVING", (int32_t)CN_TIER_REASON_MOVING },
	{ "TIER_REASON_CROWDED", (int32_t)CN_TIER_REASON_CROWDED },
	{ "TIER_REASON_WORK", (int32_t)CN_TIER_REASON_WORK },
	{ "TIER_REASON_KIND", (int32_t)CN_TIER_REASON_KIND },
	{ "TIER_REASON_NO_SET", (int32_t)CN_TIER_REASON_NO_SET },
	{ "TIER_REASON_MEMORY", (int32_t)CN_TIER_REASON_MEMORY },
	{ "TIER_REASON_JOINTED", (int32_t)CN_TIER_REASON_JOINTED },
	{ "BODY_STATIC", (int32_t)CN_BODY_STATIC },
	{ "BODY_KINEMATIC", (int32_t)CN_BODY_KINEMATIC },
	{ "BODY_DYNAMIC", (int32_t)CN_BODY_DYNAMIC },
	{ "BODY_LOCK_X", (int32_t)CN_BODY_LOCK_X },
	{ "BODY_LOCK_Y", (int32_t)CN_BODY_LOCK_Y },
	{ "BODY_LOCK_ROTATION", (int32_t)CN_BODY_LOCK_ROTATION },
	{ "BODY_BULLET", (int32_t)CN_BODY_BULLET },
	{ "BODY_ENABLED", (int32_t)CN_BODY_ENABLED },
	{ "BODY_SLEEP", (int32_t)CN_BODY_SLEEP },
	{ "BODY_AWAKE", (int32_t)CN_BODY_AWAKE },
	{ "SHAPE_CIRCLE", (int32_t)CN_SHAPE_CIRCLE },
	{ "SHAPE_CAPSULE", (int32_t)CN_SHAPE_CAPSULE },
	{ "SHAPE_POLYGON", (int32_t)CN_SHAPE_POLYGON },
	{ "SHAPE_EDGE", (int32_t)CN_SHAPE_EDGE },
	{ "SHAPE_CHAIN", (int32_t)CN_SHAPE_CHAIN },
	{ "MIX_AVERAGE", (int32_t)CN_MIX_AVERAGE },
	{ "MIX_GEOMETRIC", (int32_t)CN_MIX_GEOMETRIC },
	{ "MIX_MINIMUM", (int32_t)CN_MIX_MINIMUM },
	{ "MIX_MULTIPLY", (int32_t)CN_MIX_MULTIPLY },
	{ "MIX_MAXIMUM", (int32_t)CN_MIX_MAXIMUM },
	{ "SHAPE_SENSOR", (int32_t)CN_SHAPE_SENSOR },
	{ "SHAPE_SENSOR_SEEN", (int32_t)CN_SHAPE_SENSOR_SEEN },
	{ "SHAPE_ONE_WAY", (int32_t)CN_SHAPE_ONE_WAY },
	{ "SHAPE_PRE_SOLVE", (int32_t)CN_SHAPE_PRE_SOLVE },
	{ "EVENT_CREATED", (int32_t)CN_EVENT_CREATED },
	{ "EVENT_ENTER", (int32_t)CN_EVENT_ENTER },
	{ "EVENT_STAY", (int32_t)CN_EVENT_STAY },
	{ "EVENT_LEAVE", (int32_t)CN_EVENT_LEAVE },
	{ "EVENT_DESTROYED", (int32_t)CN_EVENT_DESTROYED },
	{ "EVENT_HIT", (int32_t)CN_EVENT_HIT },
	{ "EVENT_KINDS", (int32_t)CN_EVENT_KINDS },
	{ "JOINT_REVOLUTE", (int32_t)CN_JOINT_REVOLUTE },
	{ "JOINT_DISTANCE", (int32_t)CN_JOINT_DISTANCE },
	{ "JOINT_FIXED", (int32_t)CN_JOINT_FIXED },
	{ "JOINT_PRISMATIC", (int32_t)CN_JOINT_PRISMATIC },
	{ "JOINT_WHEEL", (int32_t)CN_JOINT_WHEEL },
	{ "JOINT_MOTOR_TO", (int32_t)CN_JOINT_MOTOR_TO },
	{ "JOINT_MOUSE", (int32_t)CN_JOINT_MOUSE },
	{ "JOINT_GEAR", (int32_t)CN_JOINT_GEAR },
	{ "JOINT_PULLEY", (int32_t)CN_JOINT_PULLEY },
	{ "JOINT_RATCHET", (int32_t)CN_JOINT_RATCHET },
	{ "JOINT_ROTARY_SPRING", (int32_t)CN_JOINT_ROTARY_SPRING },
	{ "JOINT_GROOVE", (int32_t)CN_JOINT_GROOVE },
	{ "JOINT_FILTER", (int32_t)CN_JOINT_FILTER },
	{ "JOINT_COLLIDE", (int32_t)CN_JOINT_COLLIDE },
	{ "JOINT_LIMIT", (int32_t)CN_JOINT_LIMIT },
	{ "JOINT_MOTOR", (int32_t)CN_JOINT_MOTOR },
	{ "JOINT_SPRING", (int32_t)CN_JOINT_SPRING },
	{ "JOINT_BREAKS", (int32_t)CN_JOINT_BREAKS },
	{ "CONSTRAINT_ANGLE", (int32_t)CN_CONSTRAINT_ANGLE },
	{ "CONSTRAINT_LINE", (int32_t)CN_CONSTRAINT_LINE },
	{ "CONSTRAINT_LIMIT", (int32_t)CN_CONSTRAINT_LIMIT },
	{ "CONSTRAINT_BREAKS", (int32_t)CN_CONSTRAINT_BREAKS },
	{ "QUERY_SKIP", (int32_t)CN_QUERY_SKIP },
	{ "QUERY_TAKE", (int32_t)CN_QUERY_TAKE },
	{ "QUERY_STOP", (int32_t)CN_QUERY_STOP },
	{ "QUERY_IGNORE_JOINED", (int32_t)CN_QUERY_IGNORE_JOINED },
	{ "QUERY_ONE_WAY", (int32_t)CN_QUERY_ONE_WAY },
	{ "QUERY_LEAVING", (int32_t)CN_QUERY_LEAVING },
	{ "IMPACT_NONE", (int32_t)CN_IMPACT_NONE },
	{ "IMPACT_HIT", (int32_t)CN_IMPACT_HIT },
	{ "IMPACT_OVERLAP", (int32_t)CN_IMPACT_OVERLAP },
	{ "IMPACT_FAILED", (int32_t)CN_IMPACT_FAILED },
	{ "MOVER_DROP", (int32_t)CN_MOVER_DROP },
	{ "MOVER_ON_GROUND", (int32_t)CN_MOVER_ON_GROUND },
	{ "MOVER_ON_WALL", (int32_t)CN_MOVER_ON_WALL },
	{ "MOVER_ON_CEILING", (int32_t)CN_MOVER_ON_CEILING },
	{ "AREA_REPLACE", (int32_t)CN_AREA_REPLACE },
	{ "DRAW_SHAPES", (int32_t)CN_DRAW_SHAPES },
	{ "DRAW_JOINTS", (int32_t)CN_DRAW_JOINTS },
	{ "DRAW_CONTACTS", (int32_t)CN_DRAW_CONTACTS },
	{ "DRAW_AABBS", (int32_t)CN_DRAW_AABBS },
	{ "DRAW_CENTERS", (int32_t)CN_DRAW_CENTERS },
	{ "DRAW_ISLANDS", (int32_t)CN_DRAW_ISLANDS },
};
