/* Written by bindings/generate.py from include/cairn.h: edit bindings/generator/record.py instead. */
static const call_field fields_cn_body_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_body_def, struct_size), 1, CALL_SIZE },
	{ "type", (uint32_t)offsetof(cn_body_def, type), 1, CALL_INT },
	{ "position_m.x", (uint32_t)offsetof(cn_body_def, position_m.x), 1, CALL_FLOAT },
	{ "position_m.y", (uint32_t)offsetof(cn_body_def, position_m.y), 1, CALL_FLOAT },
	{ "angle_rad", (uint32_t)offsetof(cn_body_def, angle_rad), 1, CALL_FLOAT },
	{ "linear_velocity_mps.x", (uint32_t)offsetof(cn_body_def, linear_velocity_mps.x), 1, CALL_FLOAT },
	{ "linear_velocity_mps.y", (uint32_t)offsetof(cn_body_def, linear_velocity_mps.y), 1, CALL_FLOAT },
	{ "angular_velocity_radps", (uint32_t)offsetof(cn_body_def, angular_velocity_radps), 1, CALL_FLOAT },
	{ "linear_damping_per_s", (uint32_t)offsetof(cn_body_def, linear_damping_per_s), 1, CALL_FLOAT },
	{ "angular_damping_per_s", (uint32_t)offsetof(cn_body_def, angular_damping_per_s), 1, CALL_FLOAT },
	{ "gravity_scale", (uint32_t)offsetof(cn_body_def, gravity_scale), 1, CALL_FLOAT },
	{ "sleep_speed_mps", (uint32_t)offsetof(cn_body_def, sleep_speed_mps), 1, CALL_FLOAT },
	{ "flags", (uint32_t)offsetof(cn_body_def, flags), 1, CALL_WORD },
	{ "solver", (uint32_t)offsetof(cn_body_def, solver), 1, CALL_INT },
	{ "user_data", (uint32_t)offsetof(cn_body_def, user_data), 1, CALL_LONG },
	{ "name", (uint32_t)offsetof(cn_body_def, name), 1, CALL_TEXT },
};
static const call_field fields_cn_mass_data[] = {
	{ "mass_kg", (uint32_t)offsetof(cn_mass_data, mass_kg), 1, CALL_FLOAT },
	{ "inertia_kgm2", (uint32_t)offsetof(cn_mass_data, inertia_kgm2), 1, CALL_FLOAT },
	{ "center_m.x", (uint32_t)offsetof(cn_mass_data, center_m.x), 1, CALL_FLOAT },
	{ "center_m.y", (uint32_t)offsetof(cn_mass_data, center_m.y), 1, CALL_FLOAT },
};
static const call_field fields_cn_velocity[] = {
	{ "linear_mps.x", (uint32_t)offsetof(cn_velocity, linear_mps.x), 1, CALL_FLOAT },
	{ "linear_mps.y", (uint32_t)offsetof(cn_velocity, linear_mps.y), 1, CALL_FLOAT },
	{ "angular_radps", (uint32_t)offsetof(cn_velocity, angular_radps), 1, CALL_FLOAT },
};
static const call_field fields_cn_shape_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_shape_def, struct_size), 1, CALL_SIZE },
	{ "body", (uint32_t)offsetof(cn_shape_def, body), 1, CALL_BODY },
	{ "offset_m.x", (uint32_t)offsetof(cn_shape_def, offset_m.x), 1, CALL_FLOAT },
	{ "offset_m.y", (uint32_t)offsetof(cn_shape_def, offset_m.y), 1, CALL_FLOAT },
	{ "angle_rad", (uint32_t)offsetof(cn_shape_def, angle_rad), 1, CALL_FLOAT },
	{ "density_kgpm2", (uint32_t)offsetof(cn_shape_def, density_kgpm2), 1, CALL_FLOAT },
	{ "material.static_friction", (uint32_t)offsetof(cn_shape_def, material.static_friction), 1, CALL_FLOAT },
	{ "material.dynamic_friction", (uint32_t)offsetof(cn_shape_def, material.dynamic_friction), 1, CALL_FLOAT },
	{ "material.restitution", (uint32_t)offsetof(cn_shape_def, material.restitution), 1, CALL_FLOAT },
	{ "material.rolling_resistance", (uint32_t)offsetof(cn_shape_def, material.rolling_resistance), 1, CALL_FLOAT },
	{ "material.tangent_speed_mps", (uint32_t)offsetof(cn_shape_def, material.tangent_speed_mps), 1, CALL_FLOAT },
	{ "material.friction_mix", (uint32_t)offsetof(cn_shape_def, material.friction_mix), 1, CALL_INT },
	{ "material.restitution_mix", (uint32_t)offsetof(cn_shape_def, material.restitution_mix), 1, CALL_INT },
	{ "material.user_id", (uint32_t)offsetof(cn_shape_def, material.user_id), 1, CALL_WORD },
	{ "filter.category", (uint32_t)offsetof(cn_shape_def, filter.category), 1, CALL_LONG },
	{ "filter.mask", (uint32_t)offsetof(cn_shape_def, filter.mask), 1, CALL_LONG },
	{ "filter.group", (uint32_t)offsetof(cn_shape_def, filter.group), 1, CALL_INT },
	{ "filter.reserved", (uint32_t)offsetof(cn_shape_def, filter.reserved), 1, CALL_WORD },
	{ "event_mask", (uint32_t)offsetof(cn_shape_def, event_mask), 1, CALL_WORD },
	{ "flags", (uint32_t)offsetof(cn_shape_def, flags), 1, CALL_WORD },
	{ "user_data", (uint32_t)offsetof(cn_shape_def, user_data), 1, CALL_LONG },
};
static const call_field fields_cn_circle[] = {
	{ "center_m.x", (uint32_t)offsetof(cn_circle, center_m.x), 1, CALL_FLOAT },
	{ "center_m.y", (uint32_t)offsetof(cn_circle, center_m.y), 1, CALL_FLOAT },
	{ "radius_m", (uint32_t)offsetof(cn_circle, radius_m), 1, CALL_FLOAT },
};
static const call_field fields_cn_capsule[] = {
	{ "a_m.x", (uint32_t)offsetof(cn_capsule, a_m.x), 1, CALL_FLOAT },
	{ "a_m.y", (uint32_t)offsetof(cn_capsule, a_m.y), 1, CALL_FLOAT },
	{ "b_m.x", (uint32_t)offsetof(cn_capsule, b_m.x), 1, CALL_FLOAT },
	{ "b_m.y", (uint32_t)offsetof(cn_capsule, b_m.y), 1, CALL_FLOAT },
	{ "radius_m", (uint32_t)offsetof(cn_capsule, radius_m), 1, CALL_FLOAT },
};
static const call_field fields_cn_edge[] = {
	{ "a_m.x", (uint32_t)offsetof(cn_edge, a_m.x), 1, CALL_FLOAT },
	{ "a_m.y", (uint32_t)offsetof(cn_edge, a_m.y), 1, CALL_FLOAT },
	{ "b_m.x", (uint32_t)offsetof(cn_edge, b_m.x), 1, CALL_FLOAT },
	{ "b_m.y", (uint32_t)offsetof(cn_edge, b_m.y), 1, CALL_FLOAT },
};
static const call_field fields_cn_polygon[] = {
	{ "count", (uint32_t)offsetof(cn_polygon, count), 1, CALL_INT },
	{ "radius_m", (uint32_t)offsetof(cn_polygon, radius_m), 1, CALL_FLOAT },
	{ "points_m[0].x", (uint32_t)offsetof(cn_polygon, points_m[0].x), 1, CALL_FLOAT },
	{ "points_m[0].y", (uint32_t)offsetof(cn_polygon, points_m[0].y), 1, CALL_FLOAT },
	{ "points_m[1].x", (uint32_t)offsetof(cn_polygon, points_m[1].x), 1, CALL_FLOAT },
	{ "points_m[1].y", (uint32_t)offsetof(cn_polygon, points_m[1].y), 1, CALL_FLOAT },
	{ "points_m[2].x", (uint32_t)offsetof(cn_polygon, points_m[2].x), 1, CALL_FLOAT },
	{ "points_m[2].y", (uint32_t)offsetof(cn_polygon, points_m[2].y), 1, CALL_FLOAT },
	{ "points_m[3].x", (uint32_t)offsetof(cn_polygon, points_m[3].x), 1, CALL_FLOAT },
	{ "points_m[3].y", (uint32_t)offsetof(cn_polygon, points_m[3].y), 1, CALL_FLOAT },
	{ "points_m[4].x", (uint32_t)offsetof(cn_polygon, points_m[4].x), 1, CALL_FLOAT },
	{ "points_m[4].y", (uint32_t)offsetof(cn_polygon, points_m[4].y), 1, CALL_FLOAT },
	{ "points_m[5].x", (uint32_t)offsetof(cn_polygon, points_m[5].x), 1, CALL_FLOAT },
	{ "points_m[5].y", (uint32_t)offsetof(cn_polygon, points_m[5].y), 1, CALL_FLOAT },
	{ "points_m[6].x", (uint32_t)offsetof(cn_polygon, points_m[6].x), 1, CALL_FLOAT },
	{ "points_m[6].y", (uint32_t)offsetof(cn_polygon, points_m[6].y), 1, CALL_FLOAT },
	{ "points_m[7].x", (uint32_t)offsetof(cn_polygon, points_m[7].x), 1, CALL_FLOAT },
	{ "points_m[7].y", (uint32_t)offsetof(cn_polygon, points_m[7].y), 1, CALL_FLOAT },
	{ "points_m[8].x", (uint32_t)offsetof(cn_polygon, points_m[8].x), 1, CALL_FLOAT },
	{ "points_m[8].y", (uint32_t)offsetof(cn_polygon, points_m[8].y), 1, CALL_FLOAT },
	{ "points_m[9].x", (uint32_t)offsetof(cn_polygon, points_m[9].x), 1, CALL_FLOAT },
	{ "points_m[9].y", (uint32_t)offsetof(cn_polygon, points_m[9].y), 1, CALL_FLOAT },
	{ "points_m[10].x", (uint32_t)offsetof(cn_polygon, points_m[10].x), 1, CALL_FLOAT },
	{ "points_m[10].y", (uint32_t)offsetof(cn_polygon, points_m[10].y), 1, CALL_FLOAT },
	{ "points_m[11].x", (uint32_t)offsetof(cn_polygon, points_m[11].x), 1, CALL_FLOAT },
	{ "points_m[11].y", (uint32_t)offsetof(cn_polygon, points_m[11].y), 1, CALL_FLOAT },
	{ "points_m[12].x", (uint32_t)offsetof(cn_polygon, points_m[12].x), 1, CALL_FLOAT },
	{ "points_m[12].y", (uint32_t)offsetof(cn_polygon, points_m[12].y), 1, CALL_FLOAT },
	{ "points_m[13].x", (uint32_t)offsetof(cn_polygon, points_m[13].x), 1, CALL_FLOAT },
	{ "points_m[13].y", (uint32_t)offsetof(cn_polygon, points_m[13].y), 1, CALL_FLOAT },
	{ "points_m[14].x", (uint32_t)offsetof(cn_polygon, points_m[14].x), 1, CALL_FLOAT },
	{ "points_m[14].y", (uint32_t)offsetof(cn_polygon, points_m[14].y), 1, CALL_FLOAT },
	{ "points_m[15].x", (uint32_t)offsetof(cn_polygon, points_m[15].x), 1, CALL_FLOAT },
	{ "points_m[15].y", (uint32_t)offsetof(cn_polygon, points_m[15].y), 1, CALL_FLOAT },
};
static const call_field fields_cn_chain[] = {
	{ "points_m", (uint32_t)offsetof(cn_chain, points_m), 1, CALL_POINTS },
	{ "count", (uint32_t)offsetof(cn_chain, count), 1, CALL_INT },
	{ "loop", (uint32_t)offsetof(cn_chain, loop), 1, CALL_WORD },
};
static const call_field fields_cn_material[] = {
	{ "static_friction", (uint32_t)offsetof(cn_material, static_friction), 1, CALL_FLOAT },
	{ "dynamic_friction", (uint32_t)offsetof(cn_material, dynamic_friction), 1, CALL_FLOAT },
	{ "restitution", (uint32_t)offsetof(cn_material, restitution), 1, CALL_FLOAT },
	{ "rolling_resistance", (uint32_t)offsetof(cn_material, rolling_resistance), 1, CALL_FLOAT },
	{ "tangent_speed_mps", (uint32_t)offsetof(cn_material, tangent_speed_mps), 1, CALL_FLOAT },
	{ "friction_mix", (uint32_t)offsetof(cn_material, friction_mix), 1, CALL_INT },
	{ "restitution_mix", (uint32_t)offsetof(cn_material, restitution_mix), 1, CALL_INT },
	{ "user_id", (uint32_t)offsetof(cn_material, user_id), 1, CALL_WORD },
};
static const call_field fields_cn_filter[] = {
	{ "category", (uint32_t)offsetof(cn_filter, category), 1, CALL_LONG },
	{ "mask", (uint32_t)offsetof(cn_filter, mask), 1, CALL_LONG },
	{ "group", (uint32_t)offsetof(cn_filter, group), 1, CALL_INT },
	{ "reserved", (uint32_t)offsetof(cn_filter, reserved), 1, CALL_WORD },
};
static const call_field fields_cn_revolute_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_revolute_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_revolute_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_revolute_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_revolute_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_revolute_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_revolute_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_revolute_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_revolute_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_revolute_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_revolute_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_revolute_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_revolute_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_revolute_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_revolute_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_revolute_def, base.user_data), 1, CALL_LONG },
	{ "reference_angle_rad", (uint32_t)offsetof(cn_revolute_def, reference_angle_rad), 1, CALL_FLOAT },
	{ "lower_angle_rad", (uint32_t)offsetof(cn_revolute_def, lower_angle_rad), 1, CALL_FLOAT },
	{ "upper_angle_rad", (uint32_t)offsetof(cn_revolute_def, upper_angle_rad), 1, CALL_FLOAT },
	{ "motor_speed_radps", (uint32_t)offsetof(cn_revolute_def, motor_speed_radps), 1, CALL_FLOAT },
	{ "motor_torque_max_Nm", (uint32_t)offsetof(cn_revolute_def, motor_torque_max_Nm), 1, CALL_FLOAT },
	{ "spring_target_rad", (uint32_t)offsetof(cn_revolute_def, spring_target_rad), 1, CALL_FLOAT },
	{ "spring_hertz", (uint32_t)offsetof(cn_revolute_def, spring_hertz), 1, CALL_FLOAT },
	{ "spring_damping_ratio", (uint32_t)offsetof(cn_revolute_def, spring_damping_ratio), 1, CALL_FLOAT },
};
static const call_field fields_cn_distance_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_distance_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_distance_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_distance_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_distance_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_distance_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_distance_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_distance_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_distance_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_distance_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_distance_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_distance_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_distance_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_distance_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_distance_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_distance_def, base.user_data), 1, CALL_LONG },
	{ "length_m", (uint32_t)offsetof(cn_distance_def, length_m), 1, CALL_FLOAT },
	{ "length_min_m", (uint32_t)offsetof(cn_distance_def, length_min_m), 1, CALL_FLOAT },
	{ "length_max_m", (uint32_t)offsetof(cn_distance_def, length_max_m), 1, CALL_FLOAT },
	{ "motor_speed_mps", (uint32_t)offsetof(cn_distance_def, motor_speed_mps), 1, CALL_FLOAT },
	{ "motor_force_max_N", (uint32_t)offsetof(cn_distance_def, motor_force_max_N), 1, CALL_FLOAT },
	{ "spring_hertz", (uint32_t)offsetof(cn_distance_def, spring_hertz), 1, CALL_FLOAT },
	{ "spring_damping_ratio", (uint32_t)offsetof(cn_distance_def, spring_damping_ratio), 1, CALL_FLOAT },
	{ "reserved", (uint32_t)offsetof(cn_distance_def, reserved), 1, CALL_FLOAT },
};
static const call_field fields_cn_fixed_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_fixed_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_fixed_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_fixed_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_fixed_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_fixed_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_fixed_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_fixed_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_fixed_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_fixed_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_fixed_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_fixed_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_fixed_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_fixed_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_fixed_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_fixed_def, base.user_data), 1, CALL_LONG },
	{ "reference_angle_rad", (uint32_t)offsetof(cn_fixed_def, reference_angle_rad), 1, CALL_FLOAT },
	{ "angular_hertz", (uint32_t)offsetof(cn_fixed_def, angular_hertz), 1, CALL_FLOAT },
	{ "angular_damping_ratio", (uint32_t)offsetof(cn_fixed_def, angular_damping_ratio), 1, CALL_FLOAT },
	{ "reserved", (uint32_t)offsetof(cn_fixed_def, reserved), 1, CALL_FLOAT },
};
static const call_field fields_cn_prismatic_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_prismatic_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_prismatic_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_prismatic_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_prismatic_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_prismatic_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_prismatic_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_prismatic_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_prismatic_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_prismatic_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_prismatic_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_prismatic_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_prismatic_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_prismatic_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_prismatic_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_prismatic_def, base.user_data), 1, CALL_LONG },
	{ "axis.x", (uint32_t)offsetof(cn_prismatic_def, axis.x), 1, CALL_FLOAT },
	{ "axis.y", (uint32_t)offsetof(cn_prismatic_def, axis.y), 1, CALL_FLOAT },
	{ "reference_angle_rad", (uint32_t)offsetof(cn_prismatic_def, reference_angle_rad), 1, CALL_FLOAT },
	{ "lower_m", (uint32_t)offsetof(cn_prismatic_def, lower_m), 1, CALL_FLOAT },
	{ "upper_m", (uint32_t)offsetof(cn_prismatic_def, upper_m), 1, CALL_FLOAT },
	{ "motor_speed_mps", (uint32_t)offsetof(cn_prismatic_def, motor_speed_mps), 1, CALL_FLOAT },
	{ "motor_force_max_N", (uint32_t)offsetof(cn_prismatic_def, motor_force_max_N), 1, CALL_FLOAT },
	{ "spring_target_m", (uint32_t)offsetof(cn_prismatic_def, spring_target_m), 1, CALL_FLOAT },
	{ "spring_hertz", (uint32_t)offsetof(cn_prismatic_def, spring_hertz), 1, CALL_FLOAT },
	{ "spring_damping_ratio", (uint32_t)offsetof(cn_prismatic_def, spring_damping_ratio), 1, CALL_FLOAT },
};
static const call_field fields_cn_wheel_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_wheel_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_wheel_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_wheel_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_wheel_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_wheel_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_wheel_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_wheel_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_wheel_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_wheel_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_wheel_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_wheel_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_wheel_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_wheel_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_wheel_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_wheel_def, base.user_data), 1, CALL_LONG },
	{ "axis.x", (uint32_t)offsetof(cn_wheel_def, axis.x), 1, CALL_FLOAT },
	{ "axis.y", (uint32_t)offsetof(cn_wheel_def, axis.y), 1, CALL_FLOAT },
	{ "lower_m", (uint32_t)offsetof(cn_wheel_def, lower_m), 1, CALL_FLOAT },
	{ "upper_m", (uint32_t)offsetof(cn_wheel_def, upper_m), 1, CALL_FLOAT },
	{ "motor_speed_radps", (uint32_t)offsetof(cn_wheel_def, motor_speed_radps), 1, CALL_FLOAT },
	{ "motor_torque_max_Nm", (uint32_t)offsetof(cn_wheel_def, motor_torque_max_Nm), 1, CALL_FLOAT },
	{ "spring_hertz", (uint32_t)offsetof(cn_wheel_def, spring_hertz), 1, CALL_FLOAT },
	{ "spring_damping_ratio", (uint32_t)offsetof(cn_wheel_def, spring_damping_ratio), 1, CALL_FLOAT },
};
static const call_field fields_cn_motor_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_motor_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_motor_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_motor_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_motor_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_motor_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_motor_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_motor_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_motor_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_motor_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_motor_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_motor_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_motor_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_motor_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_motor_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_motor_def, base.user_data), 1, CALL_LONG },
	{ "offset_m.x", (uint32_t)offsetof(cn_motor_def, offset_m.x), 1, CALL_FLOAT },
	{ "offset_m.y", (uint32_t)offsetof(cn_motor_def, offset_m.y), 1, CALL_FLOAT },
	{ "angle_rad", (uint32_t)offsetof(cn_motor_def, angle_rad), 1, CALL_FLOAT },
	{ "hertz", (uint32_t)offsetof(cn_motor_def, hertz), 1, CALL_FLOAT },
	{ "damping_ratio", (uint32_t)offsetof(cn_motor_def, damping_ratio), 1, CALL_FLOAT },
	{ "reserved", (uint32_t)offsetof(cn_motor_def, reserved), 1, CALL_FLOAT },
};
static const call_field fields_cn_mouse_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_mouse_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_mouse_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_mouse_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_mouse_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_mouse_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_mouse_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_mouse_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_mouse_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_mouse_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_mouse_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_mouse_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_mouse_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_mouse_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_mouse_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_mouse_def, base.user_data), 1, CALL_LONG },
	{ "target_m.x", (uint32_t)offsetof(cn_mouse_def, target_m.x), 1, CALL_FLOAT },
	{ "target_m.y", (uint32_t)offsetof(cn_mouse_def, target_m.y), 1, CALL_FLOAT },
	{ "hertz", (uint32_t)offsetof(cn_mouse_def, hertz), 1, CALL_FLOAT },
	{ "damping_ratio", (uint32_t)offsetof(cn_mouse_def, damping_ratio), 1, CALL_FLOAT },
};
static const call_field fields_cn_gear_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_gear_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_gear_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_gear_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_gear_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_gear_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_gear_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_gear_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_gear_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_gear_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_gear_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_gear_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_gear_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_gear_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_gear_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_gear_def, base.user_data), 1, CALL_LONG },
	{ "ratio", (uint32_t)offsetof(cn_gear_def, ratio), 1, CALL_FLOAT },
	{ "phase_rad", (uint32_t)offsetof(cn_gear_def, phase_rad), 1, CALL_FLOAT },
};
static const call_field fields_cn_pulley_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_pulley_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_pulley_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_pulley_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_pulley_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_pulley_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_pulley_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_pulley_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_pulley_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_pulley_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_pulley_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_pulley_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_pulley_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_pulley_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_pulley_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_pulley_def, base.user_data), 1, CALL_LONG },
	{ "ground_a_m.x", (uint32_t)offsetof(cn_pulley_def, ground_a_m.x), 1, CALL_FLOAT },
	{ "ground_a_m.y", (uint32_t)offsetof(cn_pulley_def, ground_a_m.y), 1, CALL_FLOAT },
	{ "ground_b_m.x", (uint32_t)offsetof(cn_pulley_def, ground_b_m.x), 1, CALL_FLOAT },
	{ "ground_b_m.y", (uint32_t)offsetof(cn_pulley_def, ground_b_m.y), 1, CALL_FLOAT },
	{ "ratio", (uint32_t)offsetof(cn_pulley_def, ratio), 1, CALL_FLOAT },
	{ "length_m", (uint32_t)offsetof(cn_pulley_def, length_m), 1, CALL_FLOAT },
};
static const call_field fields_cn_ratchet_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_ratchet_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_ratchet_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_ratchet_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_ratchet_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_ratchet_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_ratchet_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_ratchet_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_ratchet_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_ratchet_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_ratchet_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_ratchet_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_ratchet_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_ratchet_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_ratchet_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_ratchet_def, base.user_data), 1, CALL_LONG },
	{ "phase_rad", (uint32_t)offsetof(cn_ratchet_def, phase_rad), 1, CALL_FLOAT },
	{ "click_rad", (uint32_t)offsetof(cn_ratchet_def, click_rad), 1, CALL_FLOAT },
};
static const call_field fields_cn_rotary_spring_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_rotary_spring_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_rotary_spring_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_rotary_spring_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_rotary_spring_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_rotary_spring_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_rotary_spring_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_rotary_spring_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_rotary_spring_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_rotary_spring_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_rotary_spring_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_rotary_spring_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_rotary_spring_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_rotary_spring_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_rotary_spring_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_rotary_spring_def, base.user_data), 1, CALL_LONG },
	{ "rest_angle_rad", (uint32_t)offsetof(cn_rotary_spring_def, rest_angle_rad), 1, CALL_FLOAT },
	{ "hertz", (uint32_t)offsetof(cn_rotary_spring_def, hertz), 1, CALL_FLOAT },
	{ "damping_ratio", (uint32_t)offsetof(cn_rotary_spring_def, damping_ratio), 1, CALL_FLOAT },
	{ "reserved", (uint32_t)offsetof(cn_rotary_spring_def, reserved), 1, CALL_FLOAT },
};
static const call_field fields_cn_groove_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_groove_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_groove_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_groove_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_groove_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_groove_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_groove_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_groove_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_groove_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_groove_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_groove_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_groove_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_groove_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_groove_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_groove_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_groove_def, base.user_data), 1, CALL_LONG },
	{ "end_m.x", (uint32_t)offsetof(cn_groove_def, end_m.x), 1, CALL_FLOAT },
	{ "end_m.y", (uint32_t)offsetof(cn_groove_def, end_m.y), 1, CALL_FLOAT },
};
static const call_field fields_cn_filter_joint_def[] = {
	{ "base.struct_size", (uint32_t)offsetof(cn_filter_joint_def, base.struct_size), 1, CALL_SIZE },
	{ "base.flags", (uint32_t)offsetof(cn_filter_joint_def, base.flags), 1, CALL_WORD },
	{ "base.body_a", (uint32_t)offsetof(cn_filter_joint_def, base.body_a), 1, CALL_BODY },
	{ "base.body_b", (uint32_t)offsetof(cn_filter_joint_def, base.body_b), 1, CALL_BODY },
	{ "base.anchor_a_m.x", (uint32_t)offsetof(cn_filter_joint_def, base.anchor_a_m.x), 1, CALL_FLOAT },
	{ "base.anchor_a_m.y", (uint32_t)offsetof(cn_filter_joint_def, base.anchor_a_m.y), 1, CALL_FLOAT },
	{ "base.anchor_b_m.x", (uint32_t)offsetof(cn_filter_joint_def, base.anchor_b_m.x), 1, CALL_FLOAT },
	{ "base.anchor_b_m.y", (uint32_t)offsetof(cn_filter_joint_def, base.anchor_b_m.y), 1, CALL_FLOAT },
	{ "base.stiffness_hertz", (uint32_t)offsetof(cn_filter_joint_def, base.stiffness_hertz), 1, CALL_FLOAT },
	{ "base.stiffness_damping_ratio", (uint32_t)offsetof(cn_filter_joint_def, base.stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "base.force_max_N", (uint32_t)offsetof(cn_filter_joint_def, base.force_max_N), 1, CALL_FLOAT },
	{ "base.torque_max_Nm", (uint32_t)offsetof(cn_filter_joint_def, base.torque_max_Nm), 1, CALL_FLOAT },
	{ "base.break_force_N", (uint32_t)offsetof(cn_filter_joint_def, base.break_force_N), 1, CALL_FLOAT },
	{ "base.break_torque_Nm", (uint32_t)offsetof(cn_filter_joint_def, base.break_torque_Nm), 1, CALL_FLOAT },
	{ "base.user_data", (uint32_t)offsetof(cn_filter_joint_def, base.user_data), 1, CALL_LONG },
};
static const call_field fields_cn_joint_base[] = {
	{ "struct_size", (uint32_t)offsetof(cn_joint_base, struct_size), 1, CALL_SIZE },
	{ "flags", (uint32_t)offsetof(cn_joint_base, flags), 1, CALL_WORD },
	{ "body_a", (uint32_t)offsetof(cn_joint_base, body_a), 1, CALL_BODY },
	{ "body_b", (uint32_t)offsetof(cn_joint_base, body_b), 1, CALL_BODY },
	{ "anchor_a_m.x", (uint32_t)offsetof(cn_joint_base, anchor_a_m.x), 1, CALL_FLOAT },
	{ "anchor_a_m.y", (uint32_t)offsetof(cn_joint_base, anchor_a_m.y), 1, CALL_FLOAT },
	{ "anchor_b_m.x", (uint32_t)offsetof(cn_joint_base, anchor_b_m.x), 1, CALL_FLOAT },
	{ "anchor_b_m.y", (uint32_t)offsetof(cn_joint_base, anchor_b_m.y), 1, CALL_FLOAT },
	{ "stiffness_hertz", (uint32_t)offsetof(cn_joint_base, stiffness_hertz), 1, CALL_FLOAT },
	{ "stiffness_damping_ratio", (uint32_t)offsetof(cn_joint_base, stiffness_damping_ratio), 1, CALL_FLOAT },
	{ "force_max_N", (uint32_t)offsetof(cn_joint_base, force_max_N), 1, CALL_FLOAT },
	{ "torque_max_Nm", (uint32_t)offsetof(cn_joint_base, torque_max_Nm), 1, CALL_FLOAT },
	{ "break_force_N", (uint32_t)offsetof(cn_joint_base, break_force_N), 1, CALL_FLOAT },
	{ "break_torque_Nm", (uint32_t)offsetof(cn_joint_base, break_torque_Nm), 1, CALL_FLOAT },
	{ "user_data", (uint32_t)offsetof(cn_joint_base, user_data), 1, CALL_LONG },
};
static const call_field fields_cn_angle_constraint_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_angle_constraint_def, struct_size), 1, CALL_SIZE },
	{ "flags", (uint32_t)offsetof(cn_angle_constraint_def, flags), 1, CALL_WORD },
	{ "body", (uint32_t)offsetof(cn_angle_constraint_def, body), 1, CALL_BODY },
	{ "lower_rad", (uint32_t)offsetof(cn_angle_constraint_def, lower_rad), 1, CALL_FLOAT },
	{ "upper_rad", (uint32_t)offsetof(cn_angle_constraint_def, upper_rad), 1, CALL_FLOAT },
	{ "hertz", (uint32_t)offsetof(cn_angle_constraint_def, hertz), 1, CALL_FLOAT },
	{ "damping_ratio", (uint32_t)offsetof(cn_angle_constraint_def, damping_ratio), 1, CALL_FLOAT },
	{ "break_torque_Nm", (uint32_t)offsetof(cn_angle_constraint_def, break_torque_Nm), 1, CALL_FLOAT },
	{ "user_data", (uint32_t)offsetof(cn_angle_constraint_def, user_data), 1, CALL_LONG },
};
static const call_field fields_cn_line_constraint_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_line_constraint_def, struct_size), 1, CALL_SIZE },
	{ "flags", (uint32_t)offsetof(cn_line_constraint_def, flags), 1, CALL_WORD },
	{ "body", (uint32_t)offsetof(cn_line_constraint_def, body), 1, CALL_BODY },
	{ "anchor_m.x", (uint32_t)offsetof(cn_line_constraint_def, anchor_m.x), 1, CALL_FLOAT },
	{ "anchor_m.y", (uint32_t)offsetof(cn_line_constraint_def, anchor_m.y), 1, CALL_FLOAT },
	{ "origin_m.x", (uint32_t)offsetof(cn_line_constraint_def, origin_m.x), 1, CALL_FLOAT },
	{ "origin_m.y", (uint32_t)offsetof(cn_line_constraint_def, origin_m.y), 1, CALL_FLOAT },
	{ "axis.x", (uint32_t)offsetof(cn_line_constraint_def, axis.x), 1, CALL_FLOAT },
	{ "axis.y", (uint32_t)offsetof(cn_line_constraint_def, axis.y), 1, CALL_FLOAT },
	{ "tolerance_m", (uint32_t)offsetof(cn_line_constraint_def, tolerance_m), 1, CALL_FLOAT },
	{ "lower_m", (uint32_t)offsetof(cn_line_constraint_def, lower_m), 1, CALL_FLOAT },
	{ "upper_m", (uint32_t)offsetof(cn_line_constraint_def, upper_m), 1, CALL_FLOAT },
	{ "hertz", (uint32_t)offsetof(cn_line_constraint_def, hertz), 1, CALL_FLOAT },
	{ "damping_ratio", (uint32_t)offsetof(cn_line_constraint_def, damping_ratio), 1, CALL_FLOAT },
	{ "break_force_N", (uint32_t)offsetof(cn_line_constraint_def, break_force_N), 1, CALL_FLOAT },
	{ "reserved", (uint32_t)offsetof(cn_line_constraint_def, reserved), 1, CALL_WORD },
	{ "user_data", (uint32_t)offsetof(cn_line_constraint_def, user_data), 1, CALL_LONG },
};
static const call_field fields_cn_update_report[] = {
	{ "steps", (uint32_t)offsetof(cn_update_report, steps), 1, CALL_INT },
	{ "leftover_s", (uint32_t)offsetof(cn_update_report, leftover_s), 1, CALL_FLOAT },
	{ "dropped_s", (uint32_t)offsetof(cn_update_report, dropped_s), 1, CALL_FLOAT },
	{ "interpolation", (uint32_t)offsetof(cn_update_report, interpolation), 1, CALL_FLOAT },
};
static const call_field fields_cn_mover_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_mover_def, struct_size), 1, CALL_SIZE },
	{ "flags", (uint32_t)offsetof(cn_mover_def, flags), 1, CALL_WORD },
	{ "shape.count", (uint32_t)offsetof(cn_mover_def, shape.count), 1, CALL_INT },
	{ "shape.radius_m", (uint32_t)offsetof(cn_mover_def, shape.radius_m), 1, CALL_FLOAT },
	{ "shape.points_m[0].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[0].x), 1, CALL_FLOAT },
	{ "shape.points_m[0].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[0].y), 1, CALL_FLOAT },
	{ "shape.points_m[1].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[1].x), 1, CALL_FLOAT },
	{ "shape.points_m[1].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[1].y), 1, CALL_FLOAT },
	{ "shape.points_m[2].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[2].x), 1, CALL_FLOAT },
	{ "shape.points_m[2].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[2].y), 1, CALL_FLOAT },
	{ "shape.points_m[3].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[3].x), 1, CALL_FLOAT },
	{ "shape.points_m[3].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[3].y), 1, CALL_FLOAT },
	{ "shape.points_m[4].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[4].x), 1, CALL_FLOAT },
	{ "shape.points_m[4].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[4].y), 1, CALL_FLOAT },
	{ "shape.points_m[5].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[5].x), 1, CALL_FLOAT },
	{ "shape.points_m[5].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[5].y), 1, CALL_FLOAT },
	{ "shape.points_m[6].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[6].x), 1, CALL_FLOAT },
	{ "shape.points_m[6].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[6].y), 1, CALL_FLOAT },
	{ "shape.points_m[7].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[7].x), 1, CALL_FLOAT },
	{ "shape.points_m[7].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[7].y), 1, CALL_FLOAT },
	{ "shape.points_m[8].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[8].x), 1, CALL_FLOAT },
	{ "shape.points_m[8].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[8].y), 1, CALL_FLOAT },
	{ "shape.points_m[9].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[9].x), 1, CALL_FLOAT },
	{ "shape.points_m[9].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[9].y), 1, CALL_FLOAT },
	{ "shape.points_m[10].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[10].x), 1, CALL_FLOAT },
	{ "shape.points_m[10].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[10].y), 1, CALL_FLOAT },
	{ "shape.points_m[11].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[11].x), 1, CALL_FLOAT },
	{ "shape.points_m[11].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[11].y), 1, CALL_FLOAT },
	{ "shape.points_m[12].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[12].x), 1, CALL_FLOAT },
	{ "shape.points_m[12].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[12].y), 1, CALL_FLOAT },
	{ "shape.points_m[13].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[13].x), 1, CALL_FLOAT },
	{ "shape.points_m[13].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[13].y), 1, CALL_FLOAT },
	{ "shape.points_m[14].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[14].x), 1, CALL_FLOAT },
	{ "shape.points_m[14].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[14].y), 1, CALL_FLOAT },
	{ "shape.points_m[15].x", (uint32_t)offsetof(cn_mover_def, shape.points_m[15].x), 1, CALL_FLOAT },
	{ "shape.points_m[15].y", (uint32_t)offsetof(cn_mover_def, shape.points_m[15].y), 1, CALL_FLOAT },
	{ "filter.category", (uint32_t)offsetof(cn_mover_def, filter.category), 1, CALL_LONG },
	{ "filter.mask", (uint32_t)offsetof(cn_mover_def, filter.mask), 1, CALL_LONG },
	{ "filter.ignored_body", (uint32_t)offsetof(cn_mover_def, filter.ignored_body), 1, CALL_BODY },
	{ "filter.flags", (uint32_t)offsetof(cn_mover_def, filter.flags), 1, CALL_WORD },
	{ "up.x", (uint32_t)offsetof(cn_mover_def, up.x), 1, CALL_FLOAT },
	{ "up.y", (uint32_t)offsetof(cn_mover_def, up.y), 1, CALL_FLOAT },
	{ "slope_limit_rad", (uint32_t)offsetof(cn_mover_def, slope_limit_rad), 1, CALL_FLOAT },
	{ "step_height_m", (uint32_t)offsetof(cn_mover_def, step_height_m), 1, CALL_FLOAT },
	{ "snap_m", (uint32_t)offsetof(cn_mover_def, snap_m), 1, CALL_FLOAT },
	{ "gravity_scale", (uint32_t)offsetof(cn_mover_def, gravity_scale), 1, CALL_FLOAT },
	{ "push_force_N", (uint32_t)offsetof(cn_mover_def, push_force_N), 1, CALL_FLOAT },
	{ "iterations_max", (uint32_t)offsetof(cn_mover_def, iterations_max), 1, CALL_INT },
};
static const call_field fields_cn_mover[] = {
	{ "position_m.x", (uint32_t)offsetof(cn_mover, position_m.x), 1, CALL_FLOAT },
	{ "position_m.y", (uint32_t)offsetof(cn_mover, position_m.y), 1, CALL_FLOAT },
	{ "velocity_mps.x", (uint32_t)offsetof(cn_mover, velocity_mps.x), 1, CALL_FLOAT },
	{ "velocity_mps.y", (uint32_t)offsetof(cn_mover, velocity_mps.y), 1, CALL_FLOAT },
	{ "ground_normal.x", (uint32_t)offsetof(cn_mover, ground_normal.x), 1, CALL_FLOAT },
	{ "ground_normal.y", (uint32_t)offsetof(cn_mover, ground_normal.y), 1, CALL_FLOAT },
	{ "ground_point_m.x", (uint32_t)offsetof(cn_mover, ground_point_m.x), 1, CALL_FLOAT },
	{ "ground_point_m.y", (uint32_t)offsetof(cn_mover, ground_point_m.y), 1, CALL_FLOAT },
	{ "ground_local_m.x", (uint32_t)offsetof(cn_mover, ground_local_m.x), 1, CALL_FLOAT },
	{ "ground_local_m.y", (uint32_t)offsetof(cn_mover, ground_local_m.y), 1, CALL_FLOAT },
	{ "ground_velocity_mps.x", (uint32_t)offsetof(cn_mover, ground_velocity_mps.x), 1, CALL_FLOAT },
	{ "ground_velocity_mps.y", (uint32_t)offsetof(cn_mover, ground_velocity_mps.y), 1, CALL_FLOAT },
	{ "ground_body", (uint32_t)offsetof(cn_mover, ground_body), 1, CALL_BODY },
	{ "ground_shape", (uint32_t)offsetof(cn_mover, ground_shape), 1, CALL_SHAPE },
	{ "flags", (uint32_t)offsetof(cn_mover, flags), 1, CALL_WORD },
	{ "squeezed_m", (uint32_t)offsetof(cn_mover, squeezed_m), 1, CALL_FLOAT },
};
static const call_field fields_cn_area_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_area_def, struct_size), 1, CALL_SIZE },
	{ "flags", (uint32_t)offsetof(cn_area_def, flags), 1, CALL_WORD },
	{ "priority", (uint32_t)offsetof(cn_area_def, priority), 1, CALL_INT },
	{ "gravity_mps2.x", (uint32_t)offsetof(cn_area_def, gravity_mps2.x), 1, CALL_FLOAT },
	{ "gravity_mps2.y", (uint32_t)offsetof(cn_area_def, gravity_mps2.y), 1, CALL_FLOAT },
	{ "center_m.x", (uint32_t)offsetof(cn_area_def, center_m.x), 1, CALL_FLOAT },
	{ "center_m.y", (uint32_t)offsetof(cn_area_def, center_m.y), 1, CALL_FLOAT },
	{ "pull_mps2", (uint32_t)offsetof(cn_area_def, pull_mps2), 1, CALL_FLOAT },
	{ "pull_distance_m", (uint32_t)offsetof(cn_area_def, pull_distance_m), 1, CALL_FLOAT },
	{ "linear_damping_per_s", (uint32_t)offsetof(cn_area_def, linear_damping_per_s), 1, CALL_FLOAT },
	{ "angular_damping_per_s", (uint32_t)offsetof(cn_area_def, angular_damping_per_s), 1, CALL_FLOAT },
	{ "density_kgpm2", (uint32_t)offsetof(cn_area_def, density_kgpm2), 1, CALL_FLOAT },
	{ "drag_kgpm2", (uint32_t)offsetof(cn_area_def, drag_kgpm2), 1, CALL_FLOAT },
	{ "lift_kgpm2", (uint32_t)offsetof(cn_area_def, lift_kgpm2), 1, CALL_FLOAT },
	{ "flow_mps.x", (uint32_t)offsetof(cn_area_def, flow_mps.x), 1, CALL_FLOAT },
	{ "flow_mps.y", (uint32_t)offsetof(cn_area_def, flow_mps.y), 1, CALL_FLOAT },
};
static const call_field fields_cn_explosion_def[] = {
	{ "struct_size", (uint32_t)offsetof(cn_explosion_def, struct_size), 1, CALL_SIZE },
	{ "radius_m", (uint32_t)offsetof(cn_explosion_def, radius_m), 1, CALL_FLOAT },
	{ "falloff_m", (uint32_t)offsetof(cn_explosion_def, falloff_m), 1, CALL_FLOAT },
	{ "impulse_Nspm", (uint32_t)offsetof(cn_explosion_def, impulse_Nspm), 1, CALL_FLOAT },
	{ "center_m.x", (uint32_t)offsetof(cn_explosion_def, center_m.x), 1, CALL_FLOAT },
	{ "center_m.y", (uint32_t)offsetof(cn_explosion_def, center_m.y), 1, CALL_FLOAT },
	{ "filter.category", (uint32_t)offsetof(cn_explosion_def, filter.category), 1, CALL_LONG },
	{ "filter.mask", (uint32_t)offsetof(cn_explosion_def, filter.mask), 1, CALL_LONG },
	{ "filter.ignored_body", (uint32_t)offsetof(cn_explosion_def, filter.ignored_body), 1, CALL_BODY },
	{ "filter.flags", (uint32_t)offsetof(cn_explosion_def, filter.flags), 1, CALL_WORD },
};
static void start_cn_body_def(void *item) { cn_body_def_init((cn_body_def *)item); }
static void start_cn_shape_def(void *item) { cn_shape_def_init((cn_shape_def *)item); }
static void start_cn_revolute_def(void *item) { cn_revolute_def_init((cn_revolute_def *)item); }
static void start_cn_distance_def(void *item) { cn_distance_def_init((cn_distance_def *)item); }
static void start_cn_fixed_def(void *item) { cn_fixed_def_init((cn_fixed_def *)item); }
static void start_cn_prismatic_def(void *item) { cn_prismatic_def_init((cn_prismatic_def *)item); }
static void start_cn_wheel_def(void *item) { cn_wheel_def_init((cn_wheel_def *)item); }
static void start_cn_motor_def(void *item) { cn_motor_def_init((cn_motor_def *)item); }
static void start_cn_mouse_def(void *item) { cn_mouse_def_init((cn_mouse_def *)item); }
static void start_cn_gear_def(void *item) { cn_gear_def_init((cn_gear_def *)item); }
static void start_cn_pulley_def(void *item) { cn_pulley_def_init((cn_pulley_def *)item); }
static void start_cn_ratchet_def(void *item) { cn_ratchet_def_init((cn_ratchet_def *)item); }
static void start_cn_rotary_spring_def(void *item) { cn_rotary_spring_def_init((cn_rotary_spring_def *)item); }
static void start_cn_groove_def(void *item) { cn_groove_def_init((cn_groove_def *)item); }
static void start_cn_filter_joint_def(void *item) { cn_filter_joint_def_init((cn_filter_joint_def *)item); }
static void start_cn_angle_constraint_def(void *item) { cn_angle_constraint_def_init((cn_angle_constraint_def *)item); }
static void start_cn_line_constraint_def(void *item) { cn_line_constraint_def_init((cn_line_constraint_def *)item); }
static void start_cn_mover_def(void *item) { cn_mover_def_init((cn_mover_def *)item); }
static void start_cn_area_def(void *item) { cn_area_def_init((cn_area_def *)item); }
static void start_cn_explosion_def(void *item) { cn_explosion_def_init((cn_explosion_def *)item); }

const call_struct call_structs[] = {
	{ "cn_body_def", fields_cn_body_def, (int32_t)(sizeof fields_cn_body_def / sizeof fields_cn_body_def[0]), (uint32_t)sizeof(cn_body_def), start_cn_body_def },
	{ "cn_mass_data", fields_cn_mass_data, (int32_t)(sizeof fields_cn_mass_data / sizeof fields_cn_mass_data[0]), (uint32_t)sizeof(cn_mass_data), NULL },
	{ "cn_velocity", fields_cn_velocity, (int32_t)(sizeof fields_cn_velocity / sizeof fields_cn_velocity[0]), (uint32_t)sizeof(cn_velocity), NULL },
	{ "cn_shape_def", fields_cn_shape_def, (int32_t)(sizeof fields_cn_shape_def / sizeof fields_cn_shape_def[0]), (uint32_t)sizeof(cn_shape_def), start_cn_shape_def },
	{ "cn_circle", fields_cn_circle, (int32_t)(sizeof fields_cn_circle / sizeof fields_cn_circle[0]), (uint32_t)sizeof(cn_circle), NULL },
	{ "cn_capsule", fields_cn_capsule, (int32_t)(sizeof fields_cn_capsule / sizeof fields_cn_capsule[0]), (uint32_t)sizeof(cn_capsule), NULL },
	{ "cn_edge", fields_cn_edge, (int32_t)(sizeof fields_cn_edge / sizeof fields_cn_edge[0]), (uint32_t)sizeof(cn_edge), NULL },
	{ "cn_polygon", fields_cn_polygon, (int32_t)(sizeof fields_cn_polygon / sizeof fields_cn_polygon[0]), (uint32_t)sizeof(cn_polygon), NULL },
	{ "cn_chain", fields_cn_chain, (int32_t)(sizeof fields_cn_chain / sizeof fields_cn_chain[0]), (uint32_t)sizeof(cn_chain), NULL },
	{ "cn_material", fields_cn_material, (int32_t)(sizeof fields_cn_material / sizeof fields_cn_material[0]), (uint32_t)sizeof(cn_material), NULL },
	{ "cn_filter", fields_cn_filter, (int32_t)(sizeof fields_cn_filter / sizeof fields_cn_filter[0]), (uint32_t)sizeof(cn_filter), NULL },
	{ "cn_revolute_def", fields_cn_revolute_def, (int32_t)(sizeof fields_cn_revolute_def / sizeof fields_cn_revolute_def[0]), (uint32_t)sizeof(cn_revolute_def), start_cn_revolute_def },
	{ "cn_distance_def", fields_cn_distance_def, (int32_t)(sizeof fields_cn_distance_def / sizeof fields_cn_distance_def[0]), (uint32_t)sizeof(cn_distance_def), start_cn_distance_def },
	{ "cn_fixed_def", fields_cn_fixed_def, (int32_t)(sizeof fields_cn_fixed_def / sizeof fields_cn_fixed_def[0]), (uint32_t)sizeof(cn_fixed_def), start_cn_fixed_def },
	{ "cn_prismatic_def", fields_cn_prismatic_def, (int32_t)(sizeof fields_cn_prismatic_def / sizeof fields_cn_prismatic_def[0]), (uint32_t)sizeof(cn_prismatic_def), start_cn_prismatic_def },
	{ "cn_wheel_def", fields_cn_wheel_def, (int32_t)(sizeof fields_cn_wheel_def / sizeof fields_cn_wheel_def[0]), (uint32_t)sizeof(cn_wheel_def), start_cn_wheel_def },
	{ "cn_motor_def", fields_cn_motor_def, (int32_t)(sizeof fields_cn_motor_def / sizeof fields_cn_motor_def[0]), (uint32_t)sizeof(cn_motor_def), start_cn_motor_def },
	{ "cn_mouse_def", fields_cn_mouse_def, (int32_t)(sizeof fields_cn_mouse_def / sizeof fields_cn_mouse_def[0]), (uint32_t)sizeof(cn_mouse_def), start_cn_mouse_def },
	{ "cn_gear_def", fields_cn_gear_def, (int32_t)(sizeof fields_cn_gear_def / sizeof fields_cn_gear_def[0]), (uint32_t)sizeof(cn_gear_def), start_cn_gear_def },
	{ "cn_pulley_def", fields_cn_pulley_def, (int32_t)(sizeof fields_cn_pulley_def / sizeof fields_cn_pulley_def[0]), (uint32_t)sizeof(cn_pulley_def), start_cn_pulley_def },
	{ "cn_ratchet_def", fields_cn_ratchet_def, (int32_t)(sizeof fields_cn_ratchet_def / sizeof fields_cn_ratchet_def[0]), (uint32_t)sizeof(cn_ratchet_def), start_cn_ratchet_def },
	{ "cn_rotary_spring_def", fields_cn_rotary_spring_def, (int32_t)(sizeof fields_cn_rotary_spring_def / sizeof fields_cn_rotary_spring_def[0]), (uint32_t)sizeof(cn_rotary_spring_def), start_cn_rotary_spring_def },
	{ "cn_groove_def", fields_cn_groove_def, (int32_t)(sizeof fields_cn_groove_def / sizeof fields_cn_groove_def[0]), (uint32_t)sizeof(cn_groove_def), start_cn_groove_def },
	{ "cn_filter_joint_def", fields_cn_filter_joint_def, (int32_t)(sizeof fields_cn_filter_joint_def / sizeof fields_cn_filter_joint_def[0]), (uint32_t)sizeof(cn_filter_joint_def), start_cn_filter_joint_def },
	{ "cn_joint_base", fields_cn_joint_base, (int32_t)(sizeof fields_cn_joint_base / sizeof fields_cn_joint_base[0]), (uint32_t)sizeof(cn_joint_base), NULL },
	{ "cn_angle_constraint_def", fields_cn_angle_constraint_def, (int32_t)(sizeof fields_cn_angle_constraint_def / sizeof fields_cn_angle_constraint_def[0]), (uint32_t)sizeof(cn_angle_constraint_def), start_cn_angle_constraint_def },
	{ "cn_line_constraint_def", fields_cn_line_constraint_def, (int32_t)(sizeof fields_cn_line_constraint_def / sizeof fields_cn_line_constraint_def[0]), (uint32_t)sizeof(cn_line_constraint_def), start_cn_line_constraint_def },
	{ "cn_update_report", fields_cn_update_report, (int32_t)(sizeof fields_cn_update_report / sizeof fields_cn_update_report[0]), (uint32_t)sizeof(cn_update_report), NULL },
	{ "cn_mover_def", fields_cn_mover_def, (int32_t)(sizeof fields_cn_mover_def / sizeof fields_cn_mover_def[0]), (uint32_t)sizeof(cn_mover_def), start_cn_mover_def },
	{ "cn_mover", fields_cn_mover, (int32_t)(sizeof fields_cn_mover / sizeof fields_cn_mover[0]), (uint32_t)sizeof(cn_mover), NULL },
	{ "cn_area_def", fields_cn_area_def, (int32_t)(sizeof fields_cn_area_def / sizeof fields_cn_area_def[0]), (uint32_t)sizeof(cn_area_def), start_cn_area_def },
	{ "cn_explosion_def", fields_cn_explosion_def, (int32_t)(sizeof fields_cn_explosion_def / sizeof fields_cn_explosion_def[0]), (uint32_t)sizeof(cn_explosion_def), start_cn_explosion_def },
};

static cn_result invoke_cn_world_step(cn_world *world, const call_value *v)
{
	return cn_world_step(world, v[0].f);
}
static const call_param params_cn_world_step[] = {
	{ "dt_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_gravity(cn_world *world, const call_value *v)
{
	return cn_world_set_gravity(world, v[0].f, v[1].f);
}
static const call_param params_cn_world_set_gravity[] = {
	{ "gravity_x_mps2", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "gravity_y_mps2", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_substep_count(cn_world *world, const call_value *v)
{
	return cn_world_set_substep_count(world, v[0].i);
}
static const call_param params_cn_world_set_substep_count[] = {
	{ "count", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_world_set_solver(cn_world *world, const call_value *v)
{
	return cn_world_set_solver(world, v[0].i);
}
static const call_param params_cn_world_set_solver[] = {
	{ "solver", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_world_set_accuracy(cn_world *world, const call_value *v)
{
	return cn_world_set_accuracy(world, v[0].f, v[1].i);
}
static const call_param params_cn_world_set_accuracy[] = {
	{ "accuracy_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "work_budget", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_world_set_flags(cn_world *world, const call_value *v)
{
	return cn_world_set_flags(world, v[0].w);
}
static const call_param params_cn_world_set_flags[] = {
	{ "flags", CALL_WORD, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_world_set_restitution_threshold(cn_world *world, const call_value *v)
{
	return cn_world_set_restitution_threshold(world, v[0].f);
}
static const call_param params_cn_world_set_restitution_threshold[] = {
	{ "speed_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_hit_speed(cn_world *world, const call_value *v)
{
	return cn_world_set_hit_speed(world, v[0].f);
}
static const call_param params_cn_world_set_hit_speed[] = {
	{ "speed_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_speed_limits(cn_world *world, const call_value *v)
{
	return cn_world_set_speed_limits(world, v[0].f, v[1].f);
}
static const call_param params_cn_world_set_speed_limits[] = {
	{ "linear_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "angular_radps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_sleep(cn_world *world, const call_value *v)
{
	return cn_world_set_sleep(world, v[0].f, v[1].f);
}
static const call_param params_cn_world_set_sleep[] = {
	{ "speed_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "delay_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_world_set_user_data(cn_world *world, const call_value *v)
{
	return cn_world_set_user_data(world, v[0].l);
}
static const call_param params_cn_world_set_user_data[] = {
	{ "user_data", CALL_LONG, CALL_LONG, -1, -1 },
};
static cn_result invoke_cn_world_shift_origin(cn_world *world, const call_value *v)
{
	return cn_world_shift_origin(world, v[0].f, v[1].f);
}
static const call_param params_cn_world_shift_origin[] = {
	{ "x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_create(cn_world *world, const call_value *v)
{
	return cn_body_create(world, (const cn_body_def *)v[0].in, (cn_body *)v[1].out);
}
static const call_param params_cn_body_create[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 0, -1 },
	{ "out_body", CALL_OUT, CALL_BODY, -1, -1 },
};
static cn_result invoke_cn_body_create_many(cn_world *world, const call_value *v)
{
	return cn_body_create_many(world, (const cn_body_def *)v[0].in, v[1].i, (cn_body *)v[2].out);
}
static const call_param params_cn_body_create_many[] = {
	{ "defs", CALL_STRUCTS, CALL_WORD, 0, 1 },
	{ "count", CALL_INT, CALL_INT, -1, -1 },
	{ "out_bodies", CALL_OUTS, CALL_BODY, -1, 1 },
};
static cn_result invoke_cn_body_destroy(cn_world *world, const call_value *v)
{
	return cn_body_destroy(world, v[0].w);
}
static const call_param params_cn_body_destroy[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
};
static cn_result invoke_cn_body_destroy_many(cn_world *world, const call_value *v)
{
	return cn_body_destroy_many(world, (const cn_body *)v[0].in, v[1].i);
}
static const call_param params_cn_body_destroy_many[] = {
	{ "bodies", CALL_INS, CALL_BODY, -1, 1 },
	{ "count", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_body_set_type(cn_world *world, const call_value *v)
{
	return cn_body_set_type(world, v[0].w, v[1].i);
}
static const call_param params_cn_body_set_type[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "type", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_body_set_flags(cn_world *world, const call_value *v)
{
	return cn_body_set_flags(world, v[0].w, v[1].w);
}
static const call_param params_cn_body_set_flags[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "flags", CALL_WORD, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_body_set_awake(cn_world *world, const call_value *v)
{
	return cn_body_set_awake(world, v[0].w, v[1].i);
}
static const call_param params_cn_body_set_awake[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "awake", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_body_set_pose(cn_world *world, const call_value *v)
{
	return cn_body_set_pose(world, v[0].w, v[1].f, v[2].f, v[3].f);
}
static const call_param params_cn_body_set_pose[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "position_x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "position_y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "angle_rad", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_velocity(cn_world *world, const call_value *v)
{
	return cn_body_set_velocity(world, v[0].w, v[1].f, v[2].f, v[3].f);
}
static const call_param params_cn_body_set_velocity[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "linear_x_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "linear_y_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "angular_radps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_target_pose(cn_world *world, const call_value *v)
{
	return cn_body_set_target_pose(world, v[0].w, v[1].f, v[2].f, v[3].f, v[4].f);
}
static const call_param params_cn_body_set_target_pose[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "position_x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "position_y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "angle_rad", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "dt_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_force(cn_world *world, const call_value *v)
{
	return cn_body_apply_force(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_body_apply_force[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "force_x_N", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "force_y_N", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_force_at(cn_world *world, const call_value *v)
{
	return cn_body_apply_force_at(world, v[0].w, v[1].f, v[2].f, v[3].f, v[4].f);
}
static const call_param params_cn_body_apply_force_at[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "force_x_N", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "force_y_N", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "point_x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "point_y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_torque(cn_world *world, const call_value *v)
{
	return cn_body_apply_torque(world, v[0].w, v[1].f);
}
static const call_param params_cn_body_apply_torque[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "torque_Nm", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_impulse(cn_world *world, const call_value *v)
{
	return cn_body_apply_impulse(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_body_apply_impulse[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "impulse_x_Ns", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "impulse_y_Ns", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_impulse_at(cn_world *world, const call_value *v)
{
	return cn_body_apply_impulse_at(world, v[0].w, v[1].f, v[2].f, v[3].f, v[4].f);
}
static const call_param params_cn_body_apply_impulse_at[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "impulse_x_Ns", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "impulse_y_Ns", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "point_x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "point_y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_apply_angular_impulse(cn_world *world, const call_value *v)
{
	return cn_body_apply_angular_impulse(world, v[0].w, v[1].f);
}
static const call_param params_cn_body_apply_angular_impulse[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "impulse_Nms", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_mass_data(cn_world *world, const call_value *v)
{
	return cn_body_set_mass_data(world, v[0].w, (const cn_mass_data *)v[1].in);
}
static const call_param params_cn_body_set_mass_data[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "mass", CALL_STRUCT, CALL_WORD, 1, -1 },
};
static cn_result invoke_cn_body_reset_mass_data(cn_world *world, const call_value *v)
{
	return cn_body_reset_mass_data(world, v[0].w);
}
static const call_param params_cn_body_reset_mass_data[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
};
static cn_result invoke_cn_body_set_damping(cn_world *world, const call_value *v)
{
	return cn_body_set_damping(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_body_set_damping[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "linear_per_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "angular_per_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_gravity_scale(cn_world *world, const call_value *v)
{
	return cn_body_set_gravity_scale(world, v[0].w, v[1].f);
}
static const call_param params_cn_body_set_gravity_scale[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "scale", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_sleep_speed(cn_world *world, const call_value *v)
{
	return cn_body_set_sleep_speed(world, v[0].w, v[1].f);
}
static const call_param params_cn_body_set_sleep_speed[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "speed_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_body_set_solver(cn_world *world, const call_value *v)
{
	return cn_body_set_solver(world, v[0].w, v[1].i);
}
static const call_param params_cn_body_set_solver[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "solver", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_body_set_user_data(cn_world *world, const call_value *v)
{
	return cn_body_set_user_data(world, v[0].w, v[1].l);
}
static const call_param params_cn_body_set_user_data[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "user_data", CALL_LONG, CALL_LONG, -1, -1 },
};
static cn_result invoke_cn_body_set_name(cn_world *world, const call_value *v)
{
	return cn_body_set_name(world, v[0].w, (const char *)v[1].in);
}
static const call_param params_cn_body_set_name[] = {
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
	{ "name", CALL_TEXT, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_world_write_velocities(cn_world *world, const call_value *v)
{
	return cn_world_write_velocities(world, (const cn_body *)v[0].in, v[1].i, (const cn_velocity *)v[2].in);
}
static const call_param params_cn_world_write_velocities[] = {
	{ "bodies", CALL_INS, CALL_BODY, -1, 1 },
	{ "count", CALL_INT, CALL_INT, -1, -1 },
	{ "velocities", CALL_STRUCTS, CALL_WORD, 2, 1 },
};
static cn_result invoke_cn_shape_create_circle(cn_world *world, const call_value *v)
{
	return cn_shape_create_circle(world, (const cn_shape_def *)v[0].in, (const cn_circle *)v[1].in, (cn_shape *)v[2].out);
}
static const call_param params_cn_shape_create_circle[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "circle", CALL_STRUCT, CALL_WORD, 4, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_create_capsule(cn_world *world, const call_value *v)
{
	return cn_shape_create_capsule(world, (const cn_shape_def *)v[0].in, (const cn_capsule *)v[1].in, (cn_shape *)v[2].out);
}
static const call_param params_cn_shape_create_capsule[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "capsule", CALL_STRUCT, CALL_WORD, 5, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_create_edge(cn_world *world, const call_value *v)
{
	return cn_shape_create_edge(world, (const cn_shape_def *)v[0].in, (const cn_edge *)v[1].in, (cn_shape *)v[2].out);
}
static const call_param params_cn_shape_create_edge[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "edge", CALL_STRUCT, CALL_WORD, 6, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_create_polygon(cn_world *world, const call_value *v)
{
	return cn_shape_create_polygon(world, (const cn_shape_def *)v[0].in, (const cn_polygon *)v[1].in, (cn_shape *)v[2].out);
}
static const call_param params_cn_shape_create_polygon[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "polygon", CALL_STRUCT, CALL_WORD, 7, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_create_box(cn_world *world, const call_value *v)
{
	return cn_shape_create_box(world, (const cn_shape_def *)v[0].in, v[1].f, v[2].f, v[3].f, (cn_shape *)v[4].out);
}
static const call_param params_cn_shape_create_box[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "half_width_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "half_height_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "radius_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_create_chain(cn_world *world, const call_value *v)
{
	return cn_shape_create_chain(world, (const cn_shape_def *)v[0].in, (const cn_chain *)v[1].in, (cn_shape *)v[2].out);
}
static const call_param params_cn_shape_create_chain[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 3, -1 },
	{ "chain", CALL_STRUCT, CALL_WORD, 8, -1 },
	{ "out_shape", CALL_OUT, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_attach(cn_world *world, const call_value *v)
{
	return cn_shape_attach(world, v[0].w, v[1].w);
}
static const call_param params_cn_shape_attach[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "body", CALL_BODY, CALL_BODY, -1, -1 },
};
static cn_result invoke_cn_shape_detach(cn_world *world, const call_value *v)
{
	return cn_shape_detach(world, v[0].w);
}
static const call_param params_cn_shape_detach[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_destroy(cn_world *world, const call_value *v)
{
	return cn_shape_destroy(world, v[0].w);
}
static const call_param params_cn_shape_destroy[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
};
static cn_result invoke_cn_shape_set_material(cn_world *world, const call_value *v)
{
	return cn_shape_set_material(world, v[0].w, (const cn_material *)v[1].in);
}
static const call_param params_cn_shape_set_material[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "material", CALL_STRUCT, CALL_WORD, 9, -1 },
};
static cn_result invoke_cn_shape_set_density(cn_world *world, const call_value *v)
{
	return cn_shape_set_density(world, v[0].w, v[1].f);
}
static const call_param params_cn_shape_set_density[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "density_kgpm2", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_shape_set_filter(cn_world *world, const call_value *v)
{
	return cn_shape_set_filter(world, v[0].w, (const cn_filter *)v[1].in);
}
static const call_param params_cn_shape_set_filter[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "filter", CALL_STRUCT, CALL_WORD, 10, -1 },
};
static cn_result invoke_cn_shape_set_event_mask(cn_world *world, const call_value *v)
{
	return cn_shape_set_event_mask(world, v[0].w, v[1].w);
}
static const call_param params_cn_shape_set_event_mask[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "event_mask", CALL_WORD, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_shape_set_flags(cn_world *world, const call_value *v)
{
	return cn_shape_set_flags(world, v[0].w, v[1].w);
}
static const call_param params_cn_shape_set_flags[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "flags", CALL_WORD, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_shape_set_user_data(cn_world *world, const call_value *v)
{
	return cn_shape_set_user_data(world, v[0].w, v[1].l);
}
static const call_param params_cn_shape_set_user_data[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "user_data", CALL_LONG, CALL_LONG, -1, -1 },
};
static cn_result invoke_cn_shape_set_circle(cn_world *world, const call_value *v)
{
	return cn_shape_set_circle(world, v[0].w, (const cn_circle *)v[1].in);
}
static const call_param params_cn_shape_set_circle[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "circle", CALL_STRUCT, CALL_WORD, 4, -1 },
};
static cn_result invoke_cn_shape_set_capsule(cn_world *world, const call_value *v)
{
	return cn_shape_set_capsule(world, v[0].w, (const cn_capsule *)v[1].in);
}
static const call_param params_cn_shape_set_capsule[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "capsule", CALL_STRUCT, CALL_WORD, 5, -1 },
};
static cn_result invoke_cn_shape_set_edge(cn_world *world, const call_value *v)
{
	return cn_shape_set_edge(world, v[0].w, (const cn_edge *)v[1].in);
}
static const call_param params_cn_shape_set_edge[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "edge", CALL_STRUCT, CALL_WORD, 6, -1 },
};
static cn_result invoke_cn_shape_set_polygon(cn_world *world, const call_value *v)
{
	return cn_shape_set_polygon(world, v[0].w, (const cn_polygon *)v[1].in);
}
static const call_param params_cn_shape_set_polygon[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "polygon", CALL_STRUCT, CALL_WORD, 7, -1 },
};
static cn_result invoke_cn_shape_set_chain(cn_world *world, const call_value *v)
{
	return cn_shape_set_chain(world, v[0].w, (const cn_chain *)v[1].in);
}
static const call_param params_cn_shape_set_chain[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "chain", CALL_STRUCT, CALL_WORD, 8, -1 },
};
static cn_result invoke_cn_joint_create_revolute(cn_world *world, const call_value *v)
{
	return cn_joint_create_revolute(world, (const cn_revolute_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_revolute[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 11, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_distance(cn_world *world, const call_value *v)
{
	return cn_joint_create_distance(world, (const cn_distance_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_distance[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 12, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_fixed(cn_world *world, const call_value *v)
{
	return cn_joint_create_fixed(world, (const cn_fixed_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_fixed[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 13, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_prismatic(cn_world *world, const call_value *v)
{
	return cn_joint_create_prismatic(world, (const cn_prismatic_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_prismatic[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 14, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_wheel(cn_world *world, const call_value *v)
{
	return cn_joint_create_wheel(world, (const cn_wheel_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_wheel[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 15, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_motor(cn_world *world, const call_value *v)
{
	return cn_joint_create_motor(world, (const cn_motor_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_motor[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 16, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_mouse(cn_world *world, const call_value *v)
{
	return cn_joint_create_mouse(world, (const cn_mouse_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_mouse[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 17, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_gear(cn_world *world, const call_value *v)
{
	return cn_joint_create_gear(world, (const cn_gear_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_gear[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 18, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_pulley(cn_world *world, const call_value *v)
{
	return cn_joint_create_pulley(world, (const cn_pulley_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_pulley[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 19, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_ratchet(cn_world *world, const call_value *v)
{
	return cn_joint_create_ratchet(world, (const cn_ratchet_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_ratchet[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 20, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_rotary_spring(cn_world *world, const call_value *v)
{
	return cn_joint_create_rotary_spring(world, (const cn_rotary_spring_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_rotary_spring[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 21, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_groove(cn_world *world, const call_value *v)
{
	return cn_joint_create_groove(world, (const cn_groove_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_groove[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 22, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_create_filter(cn_world *world, const call_value *v)
{
	return cn_joint_create_filter(world, (const cn_filter_joint_def *)v[0].in, (cn_joint *)v[1].out);
}
static const call_param params_cn_joint_create_filter[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 23, -1 },
	{ "out_joint", CALL_OUT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_destroy(cn_world *world, const call_value *v)
{
	return cn_joint_destroy(world, v[0].w);
}
static const call_param params_cn_joint_destroy[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
};
static cn_result invoke_cn_joint_set_solver(cn_world *world, const call_value *v)
{
	return cn_joint_set_solver(world, v[0].w, v[1].i);
}
static const call_param params_cn_joint_set_solver[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "solver", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_joint_set_user_data(cn_world *world, const call_value *v)
{
	return cn_joint_set_user_data(world, v[0].w, v[1].l);
}
static const call_param params_cn_joint_set_user_data[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "user_data", CALL_LONG, CALL_LONG, -1, -1 },
};
static cn_result invoke_cn_joint_set_flags(cn_world *world, const call_value *v)
{
	return cn_joint_set_flags(world, v[0].w, v[1].w);
}
static const call_param params_cn_joint_set_flags[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "flags", CALL_WORD, CALL_WORD, -1, -1 },
};
static cn_result invoke_cn_joint_set_revolute(cn_world *world, const call_value *v)
{
	return cn_joint_set_revolute(world, v[0].w, (const cn_revolute_def *)v[1].in);
}
static const call_param params_cn_joint_set_revolute[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 11, -1 },
};
static cn_result invoke_cn_joint_set_distance(cn_world *world, const call_value *v)
{
	return cn_joint_set_distance(world, v[0].w, (const cn_distance_def *)v[1].in);
}
static const call_param params_cn_joint_set_distance[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 12, -1 },
};
static cn_result invoke_cn_joint_set_fixed(cn_world *world, const call_value *v)
{
	return cn_joint_set_fixed(world, v[0].w, (const cn_fixed_def *)v[1].in);
}
static const call_param params_cn_joint_set_fixed[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 13, -1 },
};
static cn_result invoke_cn_joint_set_prismatic(cn_world *world, const call_value *v)
{
	return cn_joint_set_prismatic(world, v[0].w, (const cn_prismatic_def *)v[1].in);
}
static const call_param params_cn_joint_set_prismatic[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 14, -1 },
};
static cn_result invoke_cn_joint_set_wheel(cn_world *world, const call_value *v)
{
	return cn_joint_set_wheel(world, v[0].w, (const cn_wheel_def *)v[1].in);
}
static const call_param params_cn_joint_set_wheel[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 15, -1 },
};
static cn_result invoke_cn_joint_set_motor_to(cn_world *world, const call_value *v)
{
	return cn_joint_set_motor_to(world, v[0].w, (const cn_motor_def *)v[1].in);
}
static const call_param params_cn_joint_set_motor_to[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 16, -1 },
};
static cn_result invoke_cn_joint_set_mouse(cn_world *world, const call_value *v)
{
	return cn_joint_set_mouse(world, v[0].w, (const cn_mouse_def *)v[1].in);
}
static const call_param params_cn_joint_set_mouse[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 17, -1 },
};
static cn_result invoke_cn_joint_set_gear(cn_world *world, const call_value *v)
{
	return cn_joint_set_gear(world, v[0].w, (const cn_gear_def *)v[1].in);
}
static const call_param params_cn_joint_set_gear[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 18, -1 },
};
static cn_result invoke_cn_joint_set_pulley(cn_world *world, const call_value *v)
{
	return cn_joint_set_pulley(world, v[0].w, (const cn_pulley_def *)v[1].in);
}
static const call_param params_cn_joint_set_pulley[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 19, -1 },
};
static cn_result invoke_cn_joint_set_ratchet(cn_world *world, const call_value *v)
{
	return cn_joint_set_ratchet(world, v[0].w, (const cn_ratchet_def *)v[1].in);
}
static const call_param params_cn_joint_set_ratchet[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 20, -1 },
};
static cn_result invoke_cn_joint_set_rotary_spring(cn_world *world, const call_value *v)
{
	return cn_joint_set_rotary_spring(world, v[0].w, (const cn_rotary_spring_def *)v[1].in);
}
static const call_param params_cn_joint_set_rotary_spring[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 21, -1 },
};
static cn_result invoke_cn_joint_set_groove(cn_world *world, const call_value *v)
{
	return cn_joint_set_groove(world, v[0].w, (const cn_groove_def *)v[1].in);
}
static const call_param params_cn_joint_set_groove[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 22, -1 },
};
static cn_result invoke_cn_joint_set_base(cn_world *world, const call_value *v)
{
	return cn_joint_set_base(world, v[0].w, (const cn_joint_base *)v[1].in);
}
static const call_param params_cn_joint_set_base[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "base", CALL_STRUCT, CALL_WORD, 24, -1 },
};
static cn_result invoke_cn_joint_set_target(cn_world *world, const call_value *v)
{
	return cn_joint_set_target(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_joint_set_target[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "target_x_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "target_y_m", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_joint_set_motor(cn_world *world, const call_value *v)
{
	return cn_joint_set_motor(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_joint_set_motor[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "speed", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "force_or_torque_max", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_joint_set_limits(cn_world *world, const call_value *v)
{
	return cn_joint_set_limits(world, v[0].w, v[1].f, v[2].f);
}
static const call_param params_cn_joint_set_limits[] = {
	{ "joint", CALL_JOINT, CALL_JOINT, -1, -1 },
	{ "lower", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "upper", CALL_FLOAT, CALL_FLOAT, -1, -1 },
};
static cn_result invoke_cn_constraint_create_angle(cn_world *world, const call_value *v)
{
	return cn_constraint_create_angle(world, (const cn_angle_constraint_def *)v[0].in, (cn_constraint *)v[1].out);
}
static const call_param params_cn_constraint_create_angle[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 25, -1 },
	{ "out_constraint", CALL_OUT, CALL_CONSTRAINT, -1, -1 },
};
static cn_result invoke_cn_constraint_create_line(cn_world *world, const call_value *v)
{
	return cn_constraint_create_line(world, (const cn_line_constraint_def *)v[0].in, (cn_constraint *)v[1].out);
}
static const call_param params_cn_constraint_create_line[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 26, -1 },
	{ "out_constraint", CALL_OUT, CALL_CONSTRAINT, -1, -1 },
};
static cn_result invoke_cn_constraint_destroy(cn_world *world, const call_value *v)
{
	return cn_constraint_destroy(world, v[0].w);
}
static const call_param params_cn_constraint_destroy[] = {
	{ "constraint", CALL_CONSTRAINT, CALL_CONSTRAINT, -1, -1 },
};
static cn_result invoke_cn_constraint_set_angle(cn_world *world, const call_value *v)
{
	return cn_constraint_set_angle(world, v[0].w, (const cn_angle_constraint_def *)v[1].in);
}
static const call_param params_cn_constraint_set_angle[] = {
	{ "constraint", CALL_CONSTRAINT, CALL_CONSTRAINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 25, -1 },
};
static cn_result invoke_cn_constraint_set_line(cn_world *world, const call_value *v)
{
	return cn_constraint_set_line(world, v[0].w, (const cn_line_constraint_def *)v[1].in);
}
static const call_param params_cn_constraint_set_line[] = {
	{ "constraint", CALL_CONSTRAINT, CALL_CONSTRAINT, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 26, -1 },
};
static cn_result invoke_cn_world_set_fixed_step(cn_world *world, const call_value *v)
{
	return cn_world_set_fixed_step(world, v[0].f, v[1].i);
}
static const call_param params_cn_world_set_fixed_step[] = {
	{ "step_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "steps_max", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_world_update(cn_world *world, const call_value *v)
{
	return cn_world_update(world, v[0].f, (cn_update_report *)v[1].out);
}
static const call_param params_cn_world_update[] = {
	{ "elapsed_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "out", CALL_RESULT, CALL_WORD, 27, -1 },
};
static cn_result invoke_cn_mover_move(cn_world *world, const call_value *v)
{
	return cn_mover_move(world, (const cn_mover_def *)v[0].in, v[1].f, (cn_mover *)v[2].out);
}
static const call_param params_cn_mover_move[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 28, -1 },
	{ "dt_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "mover", CALL_INOUT, CALL_WORD, 29, -1 },
};
static cn_result invoke_cn_shape_set_area(cn_world *world, const call_value *v)
{
	return cn_shape_set_area(world, v[0].w, (const cn_area_def *)v[1].in);
}
static const call_param params_cn_shape_set_area[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "def", CALL_STRUCT, CALL_WORD, 30, -1 },
};
static cn_result invoke_cn_shape_apply_wind(cn_world *world, const call_value *v)
{
	return cn_shape_apply_wind(world, v[0].w, v[1].f, v[2].f, v[3].f, v[4].f, v[5].f, v[6].i);
}
static const call_param params_cn_shape_apply_wind[] = {
	{ "shape", CALL_SHAPE, CALL_SHAPE, -1, -1 },
	{ "flow_x_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "flow_y_mps", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "drag_kgpm2", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "lift_kgpm2", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "dt_s", CALL_FLOAT, CALL_FLOAT, -1, -1 },
	{ "wake", CALL_INT, CALL_INT, -1, -1 },
};
static cn_result invoke_cn_world_explode(cn_world *world, const call_value *v)
{
	return cn_world_explode(world, (const cn_explosion_def *)v[0].in);
}
static const call_param params_cn_world_explode[] = {
	{ "def", CALL_STRUCT, CALL_WORD, 31, -1 },
};

const call_entry call_entries[] = {
	{ "cn_world_step", invoke_cn_world_step, params_cn_world_step, 1 },
	{ "cn_world_set_gravity", invoke_cn_world_set_gravity, params_cn_world_set_gravity, 2 },
	{ "cn_world_set_substep_count", invoke_cn_world_set_substep_count, params_cn_world_set_substep_count, 1 },
	{ "cn_world_set_solver", invoke_cn_world_set_solver, params_cn_world_set_solver, 1 },
	{ "cn_world_set_accuracy", invoke_cn_world_set_accuracy, params_cn_world_set_accuracy, 2 },
	{ "cn_world_set_flags", invoke_cn_world_set_flags, params_cn_world_set_flags, 1 },
	{ "cn_world_set_restitution_threshold", invoke_cn_world_set_restitution_threshold, params_cn_world_set_restitution_threshold, 1 },
	{ "cn_world_set_hit_speed", invoke_cn_world_set_hit_speed, params_cn_world_set_hit_speed, 1 },
	{ "cn_world_set_speed_limits", invoke_cn_world_set_speed_limits, params_cn_world_set_speed_limits, 2 },
	{ "cn_world_set_sleep", invoke_cn_world_set_sleep, params_cn_world_set_sleep, 2 },
	{ "cn_world_set_user_data", invoke_cn_world_set_user_data, params_cn_world_set_user_data, 1 },
	{ "cn_world_shift_origin", invoke_cn_world_shift_origin, params_cn_world_shift_origin, 2 },
	{ "cn_body_create", invoke_cn_body_create, params_cn_body_create, 2 },
	{ "cn_body_create_many", invoke_cn_body_create_many, params_cn_body_create_many, 3 },
	{ "cn_body_destroy", invoke_cn_body_destroy, params_cn_body_destroy, 1 },
	{ "cn_body_destroy_many", invoke_cn_body_destroy_many, params_cn_body_destroy_many, 2 },
	{ "cn_body_set_type", invoke_cn_body_set_type, params_cn_body_set_type, 2 },
	{ "cn_body_set_flags", invoke_cn_body_set_flags, params_cn_body_set_flags, 2 },
	{ "cn_body_set_awake", invoke_cn_body_set_awake, params_cn_body_set_awake, 2 },
	{ "cn_body_set_pose", invoke_cn_body_set_pose, params_cn_body_set_pose, 4 },
	{ "cn_body_set_velocity", invoke_cn_body_set_velocity, params_cn_body_set_velocity, 4 },
	{ "cn_body_set_target_pose", invoke_cn_body_set_target_pose, params_cn_body_set_target_pose, 5 },
	{ "cn_body_apply_force", invoke_cn_body_apply_force, params_cn_body_apply_force, 3 },
	{ "cn_body_apply_force_at", invoke_cn_body_apply_force_at, params_cn_body_apply_force_at, 5 },
	{ "cn_body_apply_torque", invoke_cn_body_apply_torque, params_cn_body_apply_torque, 2 },
	{ "cn_body_apply_impulse", invoke_cn_body_apply_impulse, params_cn_body_apply_impulse, 3 },
	{ "cn_body_apply_impulse_at", invoke_cn_body_apply_impulse_at, params_cn_body_apply_impulse_at, 5 },
	{ "cn_body_apply_angular_impulse", invoke_cn_body_apply_angular_impulse, params_cn_body_apply_angular_impulse, 2 },
	{ "cn_body_set_mass_data", invoke_cn_body_set_mass_data, params_cn_body_set_mass_data, 2 },
	{ "cn_body_reset_mass_data", invoke_cn_body_reset_mass_data, params_cn_body_reset_mass_data, 1 },
	{ "cn_body_set_damping", invoke_cn_body_set_damping, params_cn_body_set_damping, 3 },
	{ "cn_body_set_gravity_scale", invoke_cn_body_set_gravity_scale, params_cn_body_set_gravity_scale, 2 },
	{ "cn_body_set_sleep_speed", invoke_cn_body_set_sleep_speed, params_cn_body_set_sleep_speed, 2 },
	{ "cn_body_set_solver", invoke_cn_body_set_solver, params_cn_body_set_solver, 2 },
	{ "cn_body_set_user_data", invoke_cn_body_set_user_data, params_cn_body_set_user_data, 2 },
	{ "cn_body_set_name", invoke_cn_body_set_name, params_cn_body_set_name, 2 },
	{ "cn_world_write_velocities", invoke_cn_world_write_velocities, params_cn_world_write_velocities, 3 },
	{ "cn_shape_create_circle", invoke_cn_shape_create_circle, params_cn_shape_create_circle, 3 },
	{ "cn_shape_create_capsule", invoke_cn_shape_create_capsule, params_cn_shape_create_capsule, 3 },
	{ "cn_shape_create_edge", invoke_cn_shape_create_edge, params_cn_shape_create_edge, 3 },
	{ "cn_shape_create_polygon", invoke_cn_shape_create_polygon, params_cn_shape_create_polygon, 3 },
	{ "cn_shape_create_box", invoke_cn_shape_create_box, params_cn_shape_create_box, 5 },
	{ "cn_shape_create_chain", invoke_cn_shape_create_chain, params_cn_shape_create_chain, 3 },
	{ "cn_shape_attach", invoke_cn_shape_attach, params_cn_shape_attach, 2 },
	{ "cn_shape_detach", invoke_cn_shape_detach, params_cn_shape_detach, 1 },
	{ "cn_shape_destroy", invoke_cn_shape_destroy, params_cn_shape_destroy, 1 },
	{ "cn_shape_set_material", invoke_cn_shape_set_material, params_cn_shape_set_material, 2 },
	{ "cn_shape_set_density", invoke_cn_shape_set_density, params_cn_shape_set_density, 2 },
	{ "cn_shape_set_filter", invoke_cn_shape_set_filter, params_cn_shape_set_filter, 2 },
	{ "cn_shape_set_event_mask", invoke_cn_shape_set_event_mask, params_cn_shape_set_event_mask, 2 },
	{ "cn_shape_set_flags", invoke_cn_shape_set_flags, params_cn_shape_set_flags, 2 },
	{ "cn_shape_set_user_data", invoke_cn_shape_set_user_data, params_cn_shape_set_user_data, 2 },
	{ "cn_shape_set_circle", invoke_cn_shape_set_circle, params_cn_shape_set_circle, 2 },
	{ "cn_shape_set_capsule", invoke_cn_shape_set_capsule, params_cn_shape_set_capsule, 2 },
	{ "cn_shape_set_edge", invoke_cn_shape_set_edge, params_cn_shape_set_edge, 2 },
	{ "cn_shape_set_polygon", invoke_cn_shape_set_polygon, params_cn_shape_set_polygon, 2 },
	{ "cn_shape_set_chain", invoke_cn_shape_set_chain, params_cn_shape_set_chain, 2 },
	{ "cn_joint_create_revolute", invoke_cn_joint_create_revolute, params_cn_joint_create_revolute, 2 },
	{ "cn_joint_create_distance", invoke_cn_joint_create_distance, params_cn_joint_create_distance, 2 },
	{ "cn_joint_create_fixed", invoke_cn_joint_create_fixed, params_cn_joint_create_fixed, 2 },
	{ "cn_joint_create_prismatic", invoke_cn_joint_create_prismatic, params_cn_joint_create_prismatic, 2 },
	{ "cn_joint_create_wheel", invoke_cn_joint_create_wheel, params_cn_joint_create_wheel, 2 },
	{ "cn_joint_create_motor", invoke_cn_joint_create_motor, params_cn_joint_create_motor, 2 },
	{ "cn_joint_create_mouse", invoke_cn_joint_create_mouse, params_cn_joint_create_mouse, 2 },
	{ "cn_joint_create_gear", invoke_cn_joint_create_gear, params_cn_joint_create_gear, 2 },
	{ "cn_joint_create_pulley", invoke_cn_joint_create_pulley, params_cn_joint_create_pulley, 2 },
	{ "cn_joint_create_ratchet", invoke_cn_joint_create_ratchet, params_cn_joint_create_ratchet, 2 },
	{ "cn_joint_create_rotary_spring", invoke_cn_joint_create_rotary_spring, params_cn_joint_create_rotary_spring, 2 },
	{ "cn_joint_create_groove", invoke_cn_joint_create_groove, params_cn_joint_create_groove, 2 },
	{ "cn_joint_create_filter", invoke_cn_joint_create_filter, params_cn_joint_create_filter, 2 },
	{ "cn_joint_destroy", invoke_cn_joint_destroy, params_cn_joint_destroy, 1 },
	{ "cn_joint_set_solver", invoke_cn_joint_set_solver, params_cn_joint_set_solver, 2 },
	{ "cn_joint_set_user_data", invoke_cn_joint_set_user_data, params_cn_joint_set_user_data, 2 },
	{ "cn_joint_set_flags", invoke_cn_joint_set_flags, params_cn_joint_set_flags, 2 },
	{ "cn_joint_set_revolute", invoke_cn_joint_set_revolute, params_cn_joint_set_revolute, 2 },
	{ "cn_joint_set_distance", invoke_cn_joint_set_distance, params_cn_joint_set_distance, 2 },
	{ "cn_joint_set_fixed", invoke_cn_joint_set_fixed, params_cn_joint_set_fixed, 2 },
	{ "cn_joint_set_prismatic", invoke_cn_joint_set_prismatic, params_cn_joint_set_prismatic, 2 },
	{ "cn_joint_set_wheel", invoke_cn_joint_set_wheel, params_cn_joint_set_wheel, 2 },
	{ "cn_joint_set_motor_to", invoke_cn_joint_set_motor_to, params_cn_joint_set_motor_to, 2 },
	{ "cn_joint_set_mouse", invoke_cn_joint_set_mouse, params_cn_joint_set_mouse, 2 },
	{ "cn_joint_set_gear", invoke_cn_joint_set_gear, params_cn_joint_set_gear, 2 },
	{ "cn_joint_set_pulley", invoke_cn_joint_set_pulley, params_cn_joint_set_pulley, 2 },
	{ "cn_joint_set_ratchet", invoke_cn_joint_set_ratchet, params_cn_joint_set_ratchet, 2 },
	{ "cn_joint_set_rotary_spring", invoke_cn_joint_set_rotary_spring, params_cn_joint_set_rotary_spring, 2 },
	{ "cn_joint_set_groove", invoke_cn_joint_set_groove, params_cn_joint_set_groove, 2 },
	{ "cn_joint_set_base", invoke_cn_joint_set_base, params_cn_joint_set_base, 2 },
	{ "cn_joint_set_target", invoke_cn_joint_set_target, params_cn_joint_set_target, 3 },
	{ "cn_joint_set_motor", invoke_cn_joint_set_motor, params_cn_joint_set_motor, 3 },
	{ "cn_joint_set_limits", invoke_cn_joint_set_limits, params_cn_joint_set_limits, 3 },
	{ "cn_constraint_create_angle", invoke_cn_constraint_create_angle, params_cn_constraint_create_angle, 2 },
	{ "cn_constraint_create_line", invoke_cn_constraint_create_line, params_cn_constraint_create_line, 2 },
	{ "cn_constraint_destroy", invoke_cn_constraint_destroy, params_cn_constraint_destroy, 1 },
	{ "cn_constraint_set_angle", invoke_cn_constraint_set_angle, params_cn_constraint_set_angle, 2 },
	{ "cn_constraint_set_line", invoke_cn_constraint_set_line, params_cn_constraint_set_line, 2 },
	{ "cn_world_set_fixed_step", invoke_cn_world_set_fixed_step, params_cn_world_set_fixed_step, 2 },
	{ "cn_world_update", invoke_cn_world_update, params_cn_world_update, 2 },
	{ "cn_mover_move", invoke_cn_mover_move, params_cn_mover_move, 3 },
	{ "cn_shape_set_area", invoke_cn_shape_set_area, params_cn_shape_set_area, 2 },
	{ "cn_shape_apply_wind", invoke_cn_shape_apply_wind, params_cn_shape_apply_wind, 7 },
	{ "cn_world_explode", invoke_cn_world_explode, params_cn_world_explode, 1 },
};
const int32_t call_count = (int32_t)(sizeof call_entries / sizeof call_entries[0]);
