/* Written by bindings/generate.py from include/cairn.h: edit bindings/generator/record.py instead. */
/*
 * Include this instead of cairn.h, link examples/record/ and bindings/record/: then each call that changes a world is recorded
 * while examples/record/record.h records that world. A program that does not include it pays nothing.
 */
#ifndef CAIRN_RECORD_H
#define CAIRN_RECORD_H

#include "cairn.h"

cn_result cnr_world_restore(cn_world *world, const void *save, uint64_t bytes);
void cnr_world_destroy(cn_world *world);
cn_result cnr_world_step(cn_world *world, float dt_s);
cn_result cnr_world_set_gravity(cn_world *world, float gravity_x_mps2, float gravity_y_mps2);
cn_result cnr_world_set_substep_count(cn_world *world, int32_t count);
cn_result cnr_world_set_solver(cn_world *world, int32_t solver);
cn_result cnr_world_set_accuracy(cn_world *world, float accuracy_m, int32_t work_budget);
cn_result cnr_world_set_flags(cn_world *world, uint32_t flags);
cn_result cnr_world_set_restitution_threshold(cn_world *world, float speed_mps);
cn_result cnr_world_set_hit_speed(cn_world *world, float speed_mps);
cn_result cnr_world_set_speed_limits(cn_world *world, float linear_mps, float angular_radps);
cn_result cnr_world_set_sleep(cn_world *world, float speed_mps, float delay_s);
cn_result cnr_world_set_user_data(cn_world *world, uint64_t user_data);
cn_result cnr_world_shift_origin(cn_world *world, float x_m, float y_m);
cn_result cnr_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body);
cn_result cnr_body_create_many(cn_world *world, const cn_body_def *defs, int32_t count, cn_body *out_bodies);
cn_result cnr_body_destroy(cn_world *world, cn_body body);
cn_result cnr_body_destroy_many(cn_world *world, const cn_body *bodies, int32_t count);
cn_result cnr_body_set_type(cn_world *world, cn_body body, int32_t type);
cn_result cnr_body_set_flags(cn_world *world, cn_body body, uint32_t flags);
cn_result cnr_body_set_awake(cn_world *world, cn_body body, int32_t awake);
cn_result cnr_body_set_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad);
cn_result cnr_body_set_velocity(cn_world *world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps);
cn_result cnr_body_set_target_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s);
cn_result cnr_body_apply_force(cn_world *world, cn_body body, float force_x_N, float force_y_N);
cn_result cnr_body_apply_force_at(cn_world *world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m);
cn_result cnr_body_apply_torque(cn_world *world, cn_body body, float torque_Nm);
cn_result cnr_body_apply_impulse(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns);
cn_result cnr_body_apply_impulse_at(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m);
cn_result cnr_body_apply_angular_impulse(cn_world *world, cn_body body, float impulse_Nms);
cn_result cnr_body_set_mass_data(cn_world *world, cn_body body, const cn_mass_data *mass);
cn_result cnr_body_reset_mass_data(cn_world *world, cn_body body);
cn_result cnr_body_set_damping(cn_world *world, cn_body body, float linear_per_s, float angular_per_s);
cn_result cnr_body_set_gravity_scale(cn_world *world, cn_body body, float scale);
cn_result cnr_body_set_sleep_speed(cn_world *world, cn_body body, float speed_mps);
cn_result cnr_body_set_solver(cn_world *world, cn_body body, int32_t solver);
cn_result cnr_body_set_user_data(cn_world *world, cn_body body, uint64_t user_data);
cn_result cnr_body_set_name(cn_world *world, cn_body body, const char *name);
cn_result cnr_world_write_velocities(cn_world *world, const cn_body *bodies, int32_t count, const cn_velocity *velocities);
cn_result cnr_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape);
cn_result cnr_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape);
cn_result cnr_shape_create_edge(cn_world *world, const cn_shape_def *def, const cn_edge *edge, cn_shape *out_shape);
cn_result cnr_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape);
cn_result cnr_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape);
cn_result cnr_shape_create_chain(cn_world *world, const cn_shape_def *def, const cn_chain *chain, cn_shape *out_shape);
cn_result cnr_shape_attach(cn_world *world, cn_shape shape, cn_body body);
cn_result cnr_shape_detach(cn_world *world, cn_shape shape);
cn_result cnr_shape_destroy(cn_world *world, cn_shape shape);
cn_result cnr_shape_set_material(cn_world *world, cn_shape shape, const cn_material *material);
cn_result cnr_shape_set_density(cn_world *world, cn_shape shape, float density_kgpm2);
cn_result cnr_shape_set_filter(cn_world *world, cn_shape shape, const cn_filter *filter);
cn_result cnr_shape_set_event_mask(cn_world *world, cn_shape shape, uint32_t event_mask);
cn_result cnr_shape_set_flags(cn_world *world, cn_shape shape, uint32_t flags);
cn_result cnr_shape_set_user_data(cn_world *world, cn_shape shape, uint64_t user_data);
cn_result cnr_shape_set_circle(cn_world *world, cn_shape shape, const cn_circle *circle);
cn_result cnr_shape_set_capsule(cn_world *world, cn_shape shape, const cn_capsule *capsule);
cn_result cnr_shape_set_edge(cn_world *world, cn_shape shape, const cn_edge *edge);
cn_result cnr_shape_set_polygon(cn_world *world, cn_shape shape, const cn_polygon *polygon);
cn_result cnr_shape_set_chain(cn_world *world, cn_shape shape, const cn_chain *chain);
cn_result cnr_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_prismatic(cn_world *world, const cn_prismatic_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_wheel(cn_world *world, const cn_wheel_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_motor(cn_world *world, const cn_motor_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_mouse(cn_world *world, const cn_mouse_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_gear(cn_world *world, const cn_gear_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_pulley(cn_world *world, const cn_pulley_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_ratchet(cn_world *world, const cn_ratchet_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_rotary_spring(cn_world *world, const cn_rotary_spring_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_groove(cn_world *world, const cn_groove_def *def, cn_joint *out_joint);
cn_result cnr_joint_create_filter(cn_world *world, const cn_filter_joint_def *def, cn_joint *out_joint);
cn_result cnr_joint_destroy(cn_world *world, cn_joint joint);
cn_result cnr_joint_set_solver(cn_world *world, cn_joint joint, int32_t solver);
cn_result cnr_joint_set_user_data(cn_world *world, cn_joint joint, uint64_t user_data);
cn_result cnr_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags);
cn_result cnr_joint_set_revolute(cn_world *world, cn_joint joint, const cn_revolute_def *def);
cn_result cnr_joint_set_distance(cn_world *world, cn_joint joint, const cn_distance_def *def);
cn_result cnr_joint_set_fixed(cn_world *world, cn_joint joint, const cn_fixed_def *def);
cn_result cnr_joint_set_prismatic(cn_world *world, cn_joint joint, const cn_prismatic_def *def);
cn_result cnr_joint_set_wheel(cn_world *world, cn_joint joint, const cn_wheel_def *def);
cn_result cnr_joint_set_motor_to(cn_world *world, cn_joint joint, const cn_motor_def *def);
cn_result cnr_joint_set_mouse(cn_world *world, cn_joint joint, const cn_mouse_def *def);
cn_result cnr_joint_set_gear(cn_world *world, cn_joint joint, const cn_gear_def *def);
cn_result cnr_joint_set_pulley(cn_world *world, cn_joint joint, const cn_pulley_def *def);
cn_result cnr_joint_set_ratchet(cn_world *world, cn_joint joint, const cn_ratchet_def *def);
cn_result cnr_joint_set_rotary_spring(cn_world *world, cn_joint joint, const cn_rotary_spring_def *def);
cn_result cnr_joint_set_groove(cn_world *world, cn_joint joint, const cn_groove_def *def);
cn_result cnr_joint_set_base(cn_world *world, cn_joint joint, const cn_joint_base *base);
cn_result cnr_joint_set_target(cn_world *world, cn_joint joint, float target_x_m, float target_y_m);
cn_result cnr_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max);
cn_result cnr_joint_set_limits(cn_world *world, cn_joint joint, float lower, float upper);
cn_result cnr_constraint_create_angle(cn_world *world, const cn_angle_constraint_def *def, cn_constraint *out_constraint);
cn_result cnr_constraint_create_line(cn_world *world, const cn_line_constraint_def *def, cn_constraint *out_constraint);
cn_result cnr_constraint_destroy(cn_world *world, cn_constraint constraint);
cn_result cnr_constraint_set_angle(cn_world *world, cn_constraint constraint, const cn_angle_constraint_def *def);
cn_result cnr_constraint_set_line(cn_world *world, cn_constraint constraint, const cn_line_constraint_def *def);
cn_result cnr_world_set_fixed_step(cn_world *world, float step_s, int32_t steps_max);
cn_result cnr_world_update(cn_world *world, float elapsed_s, cn_update_report *out);
cn_result cnr_mover_move(cn_world *world, const cn_mover_def *def, float dt_s, cn_mover *mover);
cn_result cnr_shape_set_area(cn_world *world, cn_shape shape, const cn_area_def *def);
cn_result cnr_shape_apply_wind(cn_world *world, cn_shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2, float dt_s, int32_t wake);
cn_result cnr_world_explode(cn_world *world, const cn_explosion_def *def);

#ifndef CAIRN_RECORD_PLAIN_NAMES
#define cn_world_restore cnr_world_restore
#define cn_world_destroy cnr_world_destroy
#define cn_world_step cnr_world_step
#define cn_world_set_gravity cnr_world_set_gravity
#define cn_world_set_substep_count cnr_world_set_substep_count
#define cn_world_set_solver cnr_world_set_solver
#define cn_world_set_accuracy cnr_world_set_accuracy
#define cn_world_set_flags cnr_world_set_flags
#define cn_world_set_restitution_threshold cnr_world_set_restitution_threshold
#define cn_world_set_hit_speed cnr_world_set_hit_speed
#define cn_world_set_speed_limits cnr_world_set_speed_limits
#define cn_world_set_sleep cnr_world_set_sleep
#define cn_world_set_user_data cnr_world_set_user_data
#define cn_world_shift_origin cnr_world_shift_origin
#define cn_body_create cnr_body_create
#define cn_body_create_many cnr_body_create_many
#define cn_body_destroy cnr_body_destroy
#define cn_body_destroy_many cnr_body_destroy_many
#define cn_body_set_type cnr_body_set_type
#define cn_body_set_flags cnr_body_set_flags
#define cn_body_set_awake cnr_body_set_awake
#define cn_body_set_pose cnr_body_set_pose
#define cn_body_set_velocity cnr_body_set_velocity
#define cn_body_set_target_pose cnr_body_set_target_pose
#define cn_body_apply_force cnr_body_apply_force
#define cn_body_apply_force_at cnr_body_apply_force_at
#define cn_body_apply_torque cnr_body_apply_torque
#define cn_body_apply_impulse cnr_body_apply_impulse
#define cn_body_apply_impulse_at cnr_body_apply_impulse_at
#define cn_body_apply_angular_impulse cnr_body_apply_angular_impulse
#define cn_body_set_mass_data cnr_body_set_mass_data
#define cn_body_reset_mass_data cnr_body_reset_mass_data
#define cn_body_set_damping cnr_body_set_damping
#define cn_body_set_gravity_scale cnr_body_set_gravity_scale
#define cn_body_set_sleep_speed cnr_body_set_sleep_speed
#define cn_body_set_solver cnr_body_set_solver
#define cn_body_set_user_data cnr_body_set_user_data
#define cn_body_set_name cnr_body_set_name
#define cn_world_write_velocities cnr_world_write_velocities
#define cn_shape_create_circle cnr_shape_create_circle
#define cn_shape_create_capsule cnr_shape_create_capsule
#define cn_shape_create_edge cnr_shape_create_edge
#define cn_shape_create_polygon cnr_shape_create_polygon
#define cn_shape_create_box cnr_shape_create_box
#define cn_shape_create_chain cnr_shape_create_chain
#define cn_shape_attach cnr_shape_attach
#define cn_shape_detach cnr_shape_detach
#define cn_shape_destroy cnr_shape_destroy
#define cn_shape_set_material cnr_shape_set_material
#define cn_shape_set_density cnr_shape_set_density
#define cn_shape_set_filter cnr_shape_set_filter
#define cn_shape_set_event_mask cnr_shape_set_event_mask
#define cn_shape_set_flags cnr_shape_set_flags
#define cn_shape_set_user_data cnr_shape_set_user_data
#define cn_shape_set_circle cnr_shape_set_circle
#define cn_shape_set_capsule cnr_shape_set_capsule
#define cn_shape_set_edge cnr_shape_set_edge
#define cn_shape_set_polygon cnr_shape_set_polygon
#define cn_shape_set_chain cnr_shape_set_chain
#define cn_joint_create_revolute cnr_joint_create_revolute
#define cn_joint_create_distance cnr_joint_create_distance
#define cn_joint_create_fixed cnr_joint_create_fixed
#define cn_joint_create_prismatic cnr_joint_create_prismatic
#define cn_joint_create_wheel cnr_joint_create_wheel
#define cn_joint_create_motor cnr_joint_create_motor
#define cn_joint_create_mouse cnr_joint_create_mouse
#define cn_joint_create_gear cnr_joint_create_gear
#define cn_joint_create_pulley cnr_joint_create_pulley
#define cn_joint_create_ratchet cnr_joint_create_ratchet
#define cn_joint_create_rotary_spring cnr_joint_create_rotary_spring
#define cn_joint_create_groove cnr_joint_create_groove
#define cn_joint_create_filter cnr_joint_create_filter
#define cn_joint_destroy cnr_joint_destroy
#define cn_joint_set_solver cnr_joint_set_solver
#define cn_joint_set_user_data cnr_joint_set_user_data
#define cn_joint_set_flags cnr_joint_set_flags
#define cn_joint_set_revolute cnr_joint_set_revolute
#define cn_joint_set_distance cnr_joint_set_distance
#define cn_joint_set_fixed cnr_joint_set_fixed
#define cn_joint_set_prismatic cnr_joint_set_prismatic
#define cn_joint_set_wheel cnr_joint_set_wheel
#define cn_joint_set_motor_to cnr_joint_set_motor_to
#define cn_joint_set_mouse cnr_joint_set_mouse
#define cn_joint_set_gear cnr_joint_set_gear
#define cn_joint_set_pulley cnr_joint_set_pulley
#define cn_joint_set_ratchet cnr_joint_set_ratchet
#define cn_joint_set_rotary_spring cnr_joint_set_rotary_spring
#define cn_joint_set_groove cnr_joint_set_groove
#define cn_joint_set_base cnr_joint_set_base
#define cn_joint_set_target cnr_joint_set_target
#define cn_joint_set_motor cnr_joint_set_motor
#define cn_joint_set_limits cnr_joint_set_limits
#define cn_constraint_create_angle cnr_constraint_create_angle
#define cn_constraint_create_line cnr_constraint_create_line
#define cn_constraint_destroy cnr_constraint_destroy
#define cn_constraint_set_angle cnr_constraint_set_angle
#define cn_constraint_set_line cnr_constraint_set_line
#define cn_world_set_fixed_step cnr_world_set_fixed_step
#define cn_world_update cnr_world_update
#define cn_mover_move cnr_mover_move
#define cn_shape_set_area cnr_shape_set_area
#define cn_shape_apply_wind cnr_shape_apply_wind
#define cn_world_explode cnr_world_explode
#endif

#endif
