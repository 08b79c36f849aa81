/* Written by bindings/generate.py from include/cairn.h: edit bindings/generator/record.py instead. */
cn_result cnr_world_step(cn_world *world, float dt_s)
{
	call_value v[1];
	v[0].f = dt_s;
	return record_call(world, 0, v);
}

cn_result cnr_world_set_gravity(cn_world *world, float gravity_x_mps2, float gravity_y_mps2)
{
	call_value v[2];
	v[0].f = gravity_x_mps2;
	v[1].f = gravity_y_mps2;
	return record_call(world, 1, v);
}

cn_result cnr_world_set_substep_count(cn_world *world, int32_t count)
{
	call_value v[1];
	v[0].i = count;
	return record_call(world, 2, v);
}

cn_result cnr_world_set_solver(cn_world *world, int32_t solver)
{
	call_value v[1];
	v[0].i = solver;
	return record_call(world, 3, v);
}

cn_result cnr_world_set_accuracy(cn_world *world, float accuracy_m, int32_t work_budget)
{
	call_value v[2];
	v[0].f = accuracy_m;
	v[1].i = work_budget;
	return record_call(world, 4, v);
}

cn_result cnr_world_set_flags(cn_world *world, uint32_t flags)
{
	call_value v[1];
	v[0].w = flags;
	return record_call(world, 5, v);
}

cn_result cnr_world_set_restitution_threshold(cn_world *world, float speed_mps)
{
	call_value v[1];
	v[0].f = speed_mps;
	return record_call(world, 6, v);
}

cn_result cnr_world_set_hit_speed(cn_world *world, float speed_mps)
{
	call_value v[1];
	v[0].f = speed_mps;
	return record_call(world, 7, v);
}

cn_result cnr_world_set_speed_limits(cn_world *world, float linear_mps, float angular_radps)
{
	call_value v[2];
	v[0].f = linear_mps;
	v[1].f = angular_radps;
	return record_call(world, 8, v);
}

cn_result cnr_world_set_sleep(cn_world *world, float speed_mps, float delay_s)
{
	call_value v[2];
	v[0].f = speed_mps;
	v[1].f = delay_s;
	return record_call(world, 9, v);
}

cn_result cnr_world_set_user_data(cn_world *world, uint64_t user_data)
{
	call_value v[1];
	v[0].l = user_data;
	return record_call(world, 10, v);
}

cn_result cnr_world_shift_origin(cn_world *world, float x_m, float y_m)
{
	call_value v[2];
	v[0].f = x_m;
	v[1].f = y_m;
	return record_call(world, 11, v);
}

cn_result cnr_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_body;
	return record_call(world, 12, v);
}

cn_result cnr_body_create_many(cn_world *world, const cn_body_def *defs, int32_t count, cn_body *out_bodies)
{
	call_value v[3];
	v[0].in = defs;
	v[1].i = count;
	v[2].out = out_bodies;
	return record_call(world, 13, v);
}

cn_result cnr_body_destroy(cn_world *world, cn_body body)
{
	call_value v[1];
	v[0].w = body;
	return record_call(world, 14, v);
}

cn_result cnr_body_destroy_many(cn_world *world, const cn_body *bodies, int32_t count)
{
	call_value v[2];
	v[0].in = bodies;
	v[1].i = count;
	return record_call(world, 15, v);
}

cn_result cnr_body_set_type(cn_world *world, cn_body body, int32_t type)
{
	call_value v[2];
	v[0].w = body;
	v[1].i = type;
	return record_call(world, 16, v);
}

cn_result cnr_body_set_flags(cn_world *world, cn_body body, uint32_t flags)
{
	call_value v[2];
	v[0].w = body;
	v[1].w = flags;
	return record_call(world, 17, v);
}

cn_result cnr_body_set_awake(cn_world *world, cn_body body, int32_t awake)
{
	call_value v[2];
	v[0].w = body;
	v[1].i = awake;
	return record_call(world, 18, v);
}

cn_result cnr_body_set_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad)
{
	call_value v[4];
	v[0].w = body;
	v[1].f = position_x_m;
	v[2].f = position_y_m;
	v[3].f = angle_rad;
	return record_call(world, 19, v);
}

cn_result cnr_body_set_velocity(cn_world *world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps)
{
	call_value v[4];
	v[0].w = body;
	v[1].f = linear_x_mps;
	v[2].f = linear_y_mps;
	v[3].f = angular_radps;
	return record_call(world, 20, v);
}

cn_result cnr_body_set_target_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s)
{
	call_value v[5];
	v[0].w = body;
	v[1].f = position_x_m;
	v[2].f = position_y_m;
	v[3].f = angle_rad;
	v[4].f = dt_s;
	return record_call(world, 21, v);
}

cn_result cnr_body_apply_force(cn_world *world, cn_body body, float force_x_N, float force_y_N)
{
	call_value v[3];
	v[0].w = body;
	v[1].f = force_x_N;
	v[2].f = force_y_N;
	return record_call(world, 22, v);
}

cn_result cnr_body_apply_force_at(cn_world *world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m)
{
	call_value v[5];
	v[0].w = body;
	v[1].f = force_x_N;
	v[2].f = force_y_N;
	v[3].f = point_x_m;
	v[4].f = point_y_m;
	return record_call(world, 23, v);
}

cn_result cnr_body_apply_torque(cn_world *world, cn_body body, float torque_Nm)
{
	call_value v[2];
	v[0].w = body;
	v[1].f = torque_Nm;
	return record_call(world, 24, v);
}

cn_result cnr_body_apply_impulse(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns)
{
	call_value v[3];
	v[0].w = body;
	v[1].f = impulse_x_Ns;
	v[2].f = impulse_y_Ns;
	return record_call(world, 25, v);
}

cn_result cnr_body_apply_impulse_at(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m)
{
	call_value v[5];
	v[0].w = body;
	v[1].f = impulse_x_Ns;
	v[2].f = impulse_y_Ns;
	v[3].f = point_x_m;
	v[4].f = point_y_m;
	return record_call(world, 26, v);
}

cn_result cnr_body_apply_angular_impulse(cn_world *world, cn_body body, float impulse_Nms)
{
	call_value v[2];
	v[0].w = body;
	v[1].f = impulse_Nms;
	return record_call(world, 27, v);
}

cn_result cnr_body_set_mass_data(cn_world *world, cn_body body, const cn_mass_data *mass)
{
	call_value v[2];
	v[0].w = body;
	v[1].in = mass;
	return record_call(world, 28, v);
}

cn_result cnr_body_reset_mass_data(cn_world *world, cn_body body)
{
	call_value v[1];
	v[0].w = body;
	return record_call(world, 29, v);
}

cn_result cnr_body_set_damping(cn_world *world, cn_body body, float linear_per_s, float angular_per_s)
{
	call_value v[3];
	v[0].w = body;
	v[1].f = linear_per_s;
	v[2].f = angular_per_s;
	return record_call(world, 30, v);
}

cn_result cnr_body_set_gravity_scale(cn_world *world, cn_body body, float scale)
{
	call_value v[2];
	v[0].w = body;
	v[1].f = scale;
	return record_call(world, 31, v);
}

cn_result cnr_body_set_sleep_speed(cn_world *world, cn_body body, float speed_mps)
{
	call_value v[2];
	v[0].w = body;
	v[1].f = speed_mps;
	return record_call(world, 32, v);
}

cn_result cnr_body_set_solver(cn_world *world, cn_body body, int32_t solver)
{
	call_value v[2];
	v[0].w = body;
	v[1].i = solver;
	return record_call(world, 33, v);
}

cn_result cnr_body_set_user_data(cn_world *world, cn_body body, uint64_t user_data)
{
	call_value v[2];
	v[0].w = body;
	v[1].l = user_data;
	return record_call(world, 34, v);
}

cn_result cnr_body_set_name(cn_world *world, cn_body body, const char *name)
{
	call_value v[2];
	v[0].w = body;
	v[1].in = name;
	return record_call(world, 35, v);
}

cn_result cnr_world_write_velocities(cn_world *world, const cn_body *bodies, int32_t count, const cn_velocity *velocities)
{
	call_value v[3];
	v[0].in = bodies;
	v[1].i = count;
	v[2].in = velocities;
	return record_call(world, 36, v);
}

cn_result cnr_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape)
{
	call_value v[3];
	v[0].in = def;
	v[1].in = circle;
	v[2].out = out_shape;
	return record_call(world, 37, v);
}

cn_result cnr_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape)
{
	call_value v[3];
	v[0].in = def;
	v[1].in = capsule;
	v[2].out = out_shape;
	return record_call(world, 38, v);
}

cn_result cnr_shape_create_edge(cn_world *world, const cn_shape_def *def, const cn_edge *edge, cn_shape *out_shape)
{
	call_value v[3];
	v[0].in = def;
	v[1].in = edge;
	v[2].out = out_shape;
	return record_call(world, 39, v);
}

cn_result cnr_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape)
{
	call_value v[3];
	v[0].in = def;
	v[1].in = polygon;
	v[2].out = out_shape;
	return record_call(world, 40, v);
}

cn_result cnr_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape)
{
	call_value v[5];
	v[0].in = def;
	v[1].f = half_width_m;
	v[2].f = half_height_m;
	v[3].f = radius_m;
	v[4].out = out_shape;
	return record_call(world, 41, v);
}

cn_result cnr_shape_create_chain(cn_world *world, const cn_shape_def *def, const cn_chain *chain, cn_shape *out_shape)
{
	call_value v[3];
	v[0].in = def;
	v[1].in = chain;
	v[2].out = out_shape;
	return record_call(world, 42, v);
}

cn_result cnr_shape_attach(cn_world *world, cn_shape shape, cn_body body)
{
	call_value v[2];
	v[0].w = shape;
	v[1].w = body;
	return record_call(world, 43, v);
}

cn_result cnr_shape_detach(cn_world *world, cn_shape shape)
{
	call_value v[1];
	v[0].w = shape;
	return record_call(world, 44, v);
}

cn_result cnr_shape_destroy(cn_world *world, cn_shape shape)
{
	call_value v[1];
	v[0].w = shape;
	return record_call(world, 45, v);
}

cn_result cnr_shape_set_material(cn_world *world, cn_shape shape, const cn_material *material)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = material;
	return record_call(world, 46, v);
}

cn_result cnr_shape_set_density(cn_world *world, cn_shape shape, float density_kgpm2)
{
	call_value v[2];
	v[0].w = shape;
	v[1].f = density_kgpm2;
	return record_call(world, 47, v);
}

cn_result cnr_shape_set_filter(cn_world *world, cn_shape shape, const cn_filter *filter)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = filter;
	return record_call(world, 48, v);
}

cn_result cnr_shape_set_event_mask(cn_world *world, cn_shape shape, uint32_t event_mask)
{
	call_value v[2];
	v[0].w = shape;
	v[1].w = event_mask;
	return record_call(world, 49, v);
}

cn_result cnr_shape_set_flags(cn_world *world, cn_shape shape, uint32_t flags)
{
	call_value v[2];
	v[0].w = shape;
	v[1].w = flags;
	return record_call(world, 50, v);
}

cn_result cnr_shape_set_user_data(cn_world *world, cn_shape shape, uint64_t user_data)
{
	call_value v[2];
	v[0].w = shape;
	v[1].l = user_data;
	return record_call(world, 51, v);
}

cn_result cnr_shape_set_circle(cn_world *world, cn_shape shape, const cn_circle *circle)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = circle;
	return record_call(world, 52, v);
}

cn_result cnr_shape_set_capsule(cn_world *world, cn_shape shape, const cn_capsule *capsule)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = capsule;
	return record_call(world, 53, v);
}

cn_result cnr_shape_set_edge(cn_world *world, cn_shape shape, const cn_edge *edge)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = edge;
	return record_call(world, 54, v);
}

cn_result cnr_shape_set_polygon(cn_world *world, cn_shape shape, const cn_polygon *polygon)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = polygon;
	return record_call(world, 55, v);
}

cn_result cnr_shape_set_chain(cn_world *world, cn_shape shape, const cn_chain *chain)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = chain;
	return record_call(world, 56, v);
}

cn_result cnr_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 57, v);
}

cn_result cnr_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 58, v);
}

cn_result cnr_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 59, v);
}

cn_result cnr_joint_create_prismatic(cn_world *world, const cn_prismatic_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 60, v);
}

cn_result cnr_joint_create_wheel(cn_world *world, const cn_wheel_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 61, v);
}

cn_result cnr_joint_create_motor(cn_world *world, const cn_motor_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 62, v);
}

cn_result cnr_joint_create_mouse(cn_world *world, const cn_mouse_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 63, v);
}

cn_result cnr_joint_create_gear(cn_world *world, const cn_gear_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 64, v);
}

cn_result cnr_joint_create_pulley(cn_world *world, const cn_pulley_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 65, v);
}

cn_result cnr_joint_create_ratchet(cn_world *world, const cn_ratchet_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 66, v);
}

cn_result cnr_joint_create_rotary_spring(cn_world *world, const cn_rotary_spring_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 67, v);
}

cn_result cnr_joint_create_groove(cn_world *world, const cn_groove_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 68, v);
}

cn_result cnr_joint_create_filter(cn_world *world, const cn_filter_joint_def *def, cn_joint *out_joint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_joint;
	return record_call(world, 69, v);
}

cn_result cnr_joint_destroy(cn_world *world, cn_joint joint)
{
	call_value v[1];
	v[0].w = joint;
	return record_call(world, 70, v);
}

cn_result cnr_joint_set_solver(cn_world *world, cn_joint joint, int32_t solver)
{
	call_value v[2];
	v[0].w = joint;
	v[1].i = solver;
	return record_call(world, 71, v);
}

cn_result cnr_joint_set_user_data(cn_world *world, cn_joint joint, uint64_t user_data)
{
	call_value v[2];
	v[0].w = joint;
	v[1].l = user_data;
	return record_call(world, 72, v);
}

cn_result cnr_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags)
{
	call_value v[2];
	v[0].w = joint;
	v[1].w = flags;
	return record_call(world, 73, v);
}

cn_result cnr_joint_set_revolute(cn_world *world, cn_joint joint, const cn_revolute_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 74, v);
}

cn_result cnr_joint_set_distance(cn_world *world, cn_joint joint, const cn_distance_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 75, v);
}

cn_result cnr_joint_set_fixed(cn_world *world, cn_joint joint, const cn_fixed_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 76, v);
}

cn_result cnr_joint_set_prismatic(cn_world *world, cn_joint joint, const cn_prismatic_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 77, v);
}

cn_result cnr_joint_set_wheel(cn_world *world, cn_joint joint, const cn_wheel_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 78, v);
}

cn_result cnr_joint_set_motor_to(cn_world *world, cn_joint joint, const cn_motor_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 79, v);
}

cn_result cnr_joint_set_mouse(cn_world *world, cn_joint joint, const cn_mouse_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 80, v);
}

cn_result cnr_joint_set_gear(cn_world *world, cn_joint joint, const cn_gear_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 81, v);
}

cn_result cnr_joint_set_pulley(cn_world *world, cn_joint joint, const cn_pulley_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 82, v);
}

cn_result cnr_joint_set_ratchet(cn_world *world, cn_joint joint, const cn_ratchet_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 83, v);
}

cn_result cnr_joint_set_rotary_spring(cn_world *world, cn_joint joint, const cn_rotary_spring_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 84, v);
}

cn_result cnr_joint_set_groove(cn_world *world, cn_joint joint, const cn_groove_def *def)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = def;
	return record_call(world, 85, v);
}

cn_result cnr_joint_set_base(cn_world *world, cn_joint joint, const cn_joint_base *base)
{
	call_value v[2];
	v[0].w = joint;
	v[1].in = base;
	return record_call(world, 86, v);
}

cn_result cnr_joint_set_target(cn_world *world, cn_joint joint, float target_x_m, float target_y_m)
{
	call_value v[3];
	v[0].w = joint;
	v[1].f = target_x_m;
	v[2].f = target_y_m;
	return record_call(world, 87, v);
}

cn_result cnr_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max)
{
	call_value v[3];
	v[0].w = joint;
	v[1].f = speed;
	v[2].f = force_or_torque_max;
	return record_call(world, 88, v);
}

cn_result cnr_joint_set_limits(cn_world *world, cn_joint joint, float lower, float upper)
{
	call_value v[3];
	v[0].w = joint;
	v[1].f = lower;
	v[2].f = upper;
	return record_call(world, 89, v);
}

cn_result cnr_constraint_create_angle(cn_world *world, const cn_angle_constraint_def *def, cn_constraint *out_constraint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_constraint;
	return record_call(world, 90, v);
}

cn_result cnr_constraint_create_line(cn_world *world, const cn_line_constraint_def *def, cn_constraint *out_constraint)
{
	call_value v[2];
	v[0].in = def;
	v[1].out = out_constraint;
	return record_call(world, 91, v);
}

cn_result cnr_constraint_destroy(cn_world *world, cn_constraint constraint)
{
	call_value v[1];
	v[0].w = constraint;
	return record_call(world, 92, v);
}

cn_result cnr_constraint_set_angle(cn_world *world, cn_constraint constraint, const cn_angle_constraint_def *def)
{
	call_value v[2];
	v[0].w = constraint;
	v[1].in = def;
	return record_call(world, 93, v);
}

cn_result cnr_constraint_set_line(cn_world *world, cn_constraint constraint, const cn_line_constraint_def *def)
{
	call_value v[2];
	v[0].w = constraint;
	v[1].in = def;
	return record_call(world, 94, v);
}

cn_result cnr_world_set_fixed_step(cn_world *world, float step_s, int32_t steps_max)
{
	call_value v[2];
	v[0].f = step_s;
	v[1].i = steps_max;
	return record_call(world, 95, v);
}

cn_result cnr_world_update(cn_world *world, float elapsed_s, cn_update_report *out)
{
	call_value v[2];
	v[0].f = elapsed_s;
	v[1].out = out;
	return record_call(world, 96, v);
}

cn_result cnr_mover_move(cn_world *world, const cn_mover_def *def, float dt_s, cn_mover *mover)
{
	call_value v[3];
	v[0].in = def;
	v[1].f = dt_s;
	v[2].out = mover;
	return record_call(world, 97, v);
}

cn_result cnr_shape_set_area(cn_world *world, cn_shape shape, const cn_area_def *def)
{
	call_value v[2];
	v[0].w = shape;
	v[1].in = def;
	return record_call(world, 98, v);
}

cn_result cnr_shape_apply_wind(cn_world *world, cn_shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2, float dt_s, int32_t wake)
{
	call_value v[7];
	v[0].w = shape;
	v[1].f = flow_x_mps;
	v[2].f = flow_y_mps;
	v[3].f = drag_kgpm2;
	v[4].f = lift_kgpm2;
	v[5].f = dt_s;
	v[6].i = wake;
	return record_call(world, 99, v);
}

cn_result cnr_world_explode(cn_world *world, const cn_explosion_def *def)
{
	call_value v[1];
	v[0].in = def;
	return record_call(world, 100, v);
}

