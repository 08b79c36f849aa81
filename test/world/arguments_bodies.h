/*
 * test/world/arguments_bodies.h - entries of arguments_test for bodies: good and bad calls of each function. Included by
 * arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_BODIES_H
#define CAIRN_TEST_ARGUMENTS_BODIES_H

static char long_name[CN_NAME_MAX_BYTES + 2];
static const char *too_long(void)
{
	memset(long_name, 'n', CN_NAME_MAX_BYTES + 1);
	return long_name;
}

static cn_body_def many[3];
static const cn_body_def *spoiled_last(const cn_body_def *d)
{
	many[0] = many[1] = many[2] = *d;
	reset();
	many[0] = many[1] = bd;
	return many;
}

static cn_result call_body_create(const cn_body_def *d) { return cn_body_create(W, d, OUT(cn_body)); }
static cn_result call_body_create_many(const cn_body_def *d) { return cn_body_create_many(W, d != NULL ? spoiled_last(d) : NULL, 3, OUT(cn_body)); }

static void bad_body_defs(cn_result (*call)(const cn_body_def *))
{
	ARG(call(NULL));
	SIZES(x, call(BD(struct_size, x)));
	INTEGER(x, -1, 3, call(BD(type, x)));
	POSITION(v, call(BD(position_m, v)));
	ANGLE(x, call(BD(angle_rad, x)));
	VECTOR(v, call(BD(linear_velocity_mps, v)));
	FLOAT(x, call(BD(angular_velocity_radps, x)));
	NOT_NEGATIVE(x, call(BD(linear_damping_per_s, x)));
	NOT_NEGATIVE(x, call(BD(angular_damping_per_s, x)));
	FLOAT(x, call(BD(gravity_scale, x)));
	DEFAULT_OR_NOT_NEGATIVE(x, call(BD(sleep_speed_mps, x)));
	FLAGS(x, 7, call(BD(flags, x)));
	INTEGER(x, -1, 3, call(BD(solver, x)));
	ARG(call(BD(name, too_long())));
}

ENTRY(cn_body_def_init, (cn_body_def_init(&bd), CN_OK), cn_body_def_init(NULL);)
ENTRY(cn_body_create, cn_body_create(W, (reset(), &bd), OUT(cn_body)),
	bad_body_defs(call_body_create); NOW(cn_body_create(NULL, (reset(), &bd), OUT(cn_body))); ARG(cn_body_create(W, (reset(), &bd), NULL));)
ENTRY(cn_body_create_many, cn_body_create_many(W, spoiled_last((reset(), &bd)), 3, OUT(cn_body)),
	bad_body_defs(call_body_create_many); NOW(cn_body_create_many(NULL, many, 3, OUT(cn_body)));
	ARG(cn_body_create_many(W, spoiled_last((reset(), &bd)), -1, OUT(cn_body))); ARG(cn_body_create_many(W, many, 3, NULL));)
ENTRY(cn_body_destroy, cn_body_destroy(W, f.box), NOW(cn_body_destroy(NULL, f.box)); BODY(h, cn_body_destroy(W, h));)

ENTRY(cn_body_destroy_many, cn_body_destroy_many(W, three(f.box, f.ground, f.ball), 3),
	NOW(cn_body_destroy_many(NULL, three(f.box, f.ground, f.ball), 3)); BODY(h, cn_body_destroy_many(W, three(f.box, f.ball, h), 3));
	BODY(h, cn_body_destroy_many(W, three(h, f.box, f.ball), 3)); ARG(cn_body_destroy_many(W, NULL, 1));
	ARG(cn_body_destroy_many(W, three(f.box, f.ball, f.box), 3)); ARG(cn_body_destroy_many(W, three(f.box, f.ball, f.pill), -1));)
ENTRY(cn_body_is_valid, cn_body_is_valid(W, f.box) ? CN_OK : -1,
	int k; CHECK(cn_body_is_valid(NULL, f.box) == 0); for (k = 0; k < f.bad_body_count; ++k) CHECK(cn_body_is_valid(W, f.bad_bodies[k]) == 0);)
ENTRY(cn_body_set_type, cn_body_set_type(W, f.box, CN_BODY_STATIC),
	NOW(cn_body_set_type(NULL, f.box, 0)); BODY(h, cn_body_set_type(W, h, 0)); INTEGER(x, -1, 3, cn_body_set_type(W, f.box, x));
	STATE(cn_body_set_type(W, f.ball, CN_BODY_STATIC)); STATE(cn_body_set_type(W, f.ball, CN_BODY_KINEMATIC));)
GETTER(cn_body_get_type, BODY, f.box, int32_t)
ENTRY(cn_body_set_flags, cn_body_set_flags(W, f.box, CN_BODY_LOCK_X),
	NOW(cn_body_set_flags(NULL, f.box, 0)); BODY(h, cn_body_set_flags(W, h, 0)); FLAGS(x, 7, cn_body_set_flags(W, f.box, x));)
GETTER(cn_body_get_flags, BODY, f.box, uint32_t)
ENTRY(cn_body_set_awake, cn_body_set_awake(W, f.box, 0), NOW(cn_body_set_awake(NULL, f.box, 0)); BODY(h, cn_body_set_awake(W, h, 0));)
ENTRY(cn_body_set_pose, cn_body_set_pose(W, f.box, 1.0f, 3.0f, 0.5f),
	NOW(cn_body_set_pose(NULL, f.box, 1.0f, 3.0f, 0.5f)); BODY(h, cn_body_set_pose(W, h, 1.0f, 3.0f, 0.5f));
	POSITION(v, cn_body_set_pose(W, f.box, v.x, v.y, 0.5f)); ANGLE(x, cn_body_set_pose(W, f.box, 0.0f, 0.0f, x));)
GETTER(cn_body_get_pose, BODY, f.box, cn_pose)
GETTER(cn_body_get_angle, BODY, f.box, float)
GETTER2(cn_body_get_position_parts, BODY, f.box, cn_vec2, cn_vec2)
GETTER(cn_body_get_center, BODY, f.box, cn_vec2)
ENTRY(cn_body_set_velocity, cn_body_set_velocity(W, f.box, 1.0f, 0.0f, 1.0f),
	NOW(cn_body_set_velocity(NULL, f.box, 1.0f, 0.0f, 1.0f)); BODY(h, cn_body_set_velocity(W, h, 1.0f, 0.0f, 1.0f));
	VECTOR(v, cn_body_set_velocity(W, f.box, v.x, v.y, 1.0f)); FLOAT(x, cn_body_set_velocity(W, f.box, 1.0f, 0.0f, x));
	STATE(cn_body_set_velocity(W, f.ground, 0.0f, 0.0f, 0.0f));)
ENTRY(cn_body_set_target_pose, cn_body_set_target_pose(W, f.rail, 1.0f, 3.0f, 0.5f, 0.01f),
	NOW(cn_body_set_target_pose(NULL, f.rail, 1.0f, 3.0f, 0.5f, 0.01f)); BODY(h, cn_body_set_target_pose(W, h, 1.0f, 3.0f, 0.5f, 0.01f));
	POSITION(v, cn_body_set_target_pose(W, f.rail, v.x, v.y, 0.5f, 0.01f)); ANGLE(x, cn_body_set_target_pose(W, f.rail, 0.0f, 0.0f, x, 0.01f));
	RANGE(x, 0.0f, 1.1f, cn_body_set_target_pose(W, f.rail, 0.0f, 0.0f, 0.0f, x));
	STATE(cn_body_set_target_pose(W, f.box, 0.0f, 0.0f, 0.0f, 0.01f)); STATE(cn_body_set_target_pose(W, f.ground, 0.0f, 0.0f, 0.0f, 0.01f));)
GETTER(cn_body_get_velocity, BODY, f.box, cn_velocity)
#define POINT_GETTER(name) ENTRY(name, name(W, f.box, 1.0f, 2.0f, OUT(cn_vec2)), NOW(name(NULL, f.box, 1.0f, 2.0f, OUT(cn_vec2))); \
	BODY(h, name(W, h, 1.0f, 2.0f, OUT(cn_vec2))); VECTOR(v, name(W, f.box, v.x, v.y, OUT(cn_vec2))); ARG(name(W, f.box, 1.0f, 2.0f, NULL));)
POINT_GETTER(cn_body_get_velocity_at)
POINT_GETTER(cn_body_get_world_point)
POINT_GETTER(cn_body_get_local_point)
GETTER(cn_body_get_aabb, BODY, f.box, cn_aabb)
#define PUSH_VECTOR(name, huge) ENTRY(name, name(W, f.box, 1.0f, 2.0f), NOW(name(NULL, f.box, 1.0f, 2.0f)); \
	BODY(h, name(W, h, 1.0f, 2.0f)); VECTOR(v, name(W, f.box, v.x, v.y)); huge)
#define PUSH_AT(name) ENTRY(name, name(W, f.box, 1.0f, 2.0f, 0.0f, 1.0f), NOW(name(NULL, f.box, 1.0f, 2.0f, 0.0f, 1.0f)); \
	BODY(h, name(W, h, 1.0f, 2.0f, 0.0f, 1.0f)); VECTOR(v, name(W, f.box, v.x, v.y, 0.0f, 1.0f)); \
	VECTOR(v, name(W, f.box, 1.0f, 2.0f, v.x, v.y)); ARG(name(W, f.box, 3e38f, 0.0f, 1.0f, 3e38f));)
#define PUSH_FLOAT(name) ENTRY(name, name(W, f.box, 2.0f), NOW(name(NULL, f.box, 2.0f)); BODY(h, name(W, h, 2.0f)); FLOAT(x, name(W, f.box, x));)
PUSH_VECTOR(cn_body_apply_force, CHECK(cn_body_apply_force(W, f.box, 3e38f, 0.0f) == CN_OK); ARG(cn_body_apply_force(W, f.box, 3e38f, 0.0f));
	CHECK(cn_body_apply_force(W, f.box, -3e38f, 0.0f) == CN_OK);)
PUSH_AT(cn_body_apply_force_at)
PUSH_FLOAT(cn_body_apply_torque)
PUSH_VECTOR(cn_body_apply_impulse, (void)0;)
PUSH_AT(cn_body_apply_impulse_at)
PUSH_FLOAT(cn_body_apply_angular_impulse)
GETTER(cn_body_get_mass_data, BODY, f.box, cn_mass_data)
ENTRY(cn_body_set_mass_data, cn_body_set_mass_data(W, f.box, (reset(), &mass)),
	NOW(cn_body_set_mass_data(NULL, f.box, &mass)); BODY(h, cn_body_set_mass_data(W, h, (reset(), &mass))); ARG(cn_body_set_mass_data(W, f.box, NULL));
	POSITIVE(x, cn_body_set_mass_data(W, f.box, MD(mass_kg, x))); NOT_NEGATIVE(x, cn_body_set_mass_data(W, f.box, MD(inertia_kgm2, x)));
	ARG(cn_body_set_mass_data(W, f.box, MD(mass_kg, 1e-40f))); ARG(cn_body_set_mass_data(W, f.box, MD(inertia_kgm2, 1e-40f)));
	POSITION(v, cn_body_set_mass_data(W, f.box, MD(center_m, v))); STATE(cn_body_set_mass_data(W, f.ground, (reset(), &mass)));
	STATE(cn_body_set_mass_data(W, f.rail, (reset(), &mass)));)
ENTRY(cn_body_reset_mass_data, cn_body_reset_mass_data(W, f.box), NOW(cn_body_reset_mass_data(NULL, f.box)); BODY(h, cn_body_reset_mass_data(W, h));)
ENTRY(cn_body_set_damping, cn_body_set_damping(W, f.box, 0.1f, 0.2f),
	NOW(cn_body_set_damping(NULL, f.box, 0.1f, 0.2f)); BODY(h, cn_body_set_damping(W, h, 0.1f, 0.2f));
	NOT_NEGATIVE(x, cn_body_set_damping(W, f.box, x, 0.2f)); NOT_NEGATIVE(x, cn_body_set_damping(W, f.box, 0.1f, x));)
GETTER2(cn_body_get_damping, BODY, f.box, float, float)
ENTRY(cn_body_set_gravity_scale, cn_body_set_gravity_scale(W, f.box, -0.5f),
	NOW(cn_body_set_gravity_scale(NULL, f.box, 1.0f)); BODY(h, cn_body_set_gravity_scale(W, h, 1.0f)); FLOAT(x, cn_body_set_gravity_scale(W, f.box, x));)
GETTER(cn_body_get_gravity_scale, BODY, f.box, float)
ENTRY(cn_body_set_sleep_speed, cn_body_set_sleep_speed(W, f.box, 0.1f),
	NOW(cn_body_set_sleep_speed(NULL, f.box, 0.1f)); BODY(h, cn_body_set_sleep_speed(W, h, 0.1f)); DEFAULT_OR_NOT_NEGATIVE(x, cn_body_set_sleep_speed(W, f.box, x));)
ENTRY(cn_body_set_solver, cn_body_set_solver(W, f.box, CN_SOLVER_DIRECT),
	NOW(cn_body_set_solver(NULL, f.box, 0)); BODY(h, cn_body_set_solver(W, h, 0)); INTEGER(x, -1, 3, cn_body_set_solver(W, f.box, x));)
GETTER(cn_body_get_solver, BODY, f.box, int32_t)
ENTRY(cn_body_set_user_data, cn_body_set_user_data(W, f.box, 3), NOW(cn_body_set_user_data(NULL, f.box, 3)); BODY(h, cn_body_set_user_data(W, h, 3));)
GETTER(cn_body_get_user_data, BODY, f.box, uint64_t)
ENTRY(cn_body_set_name, cn_body_set_name(W, f.box, "another and a rather longer name"),
	NOW(cn_body_set_name(NULL, f.box, "n")); BODY(h, cn_body_set_name(W, h, "n")); ARG(cn_body_set_name(W, f.box, too_long()));)
GETTER(cn_body_get_name, BODY, f.box, const char *)
HANDLE_LIST(cn_body_get_shapes, BODY, f.box, cn_shape)
HANDLE_LIST(cn_body_get_joints, BODY, f.ball, cn_joint)

#define BULK(name, T, out) NOW(name(NULL, three(f.box, f.ball, f.pill), 3, out)); BODY(h, name(W, three(f.box, f.ball, h), 3, out)); \
	ARG(name(W, three(f.box, f.ball, f.pill), -1, out)); ARG(name(W, three(f.box, f.ball, f.pill), 3, NULL)); \
	ARG(name(W, NULL, 3, out)); ARG(name(W, NULL, 6, out)); ARG(name(W, NULL, -1, out));
ENTRY(cn_world_read_poses, cn_world_read_poses(W, NULL, 5, OUT(cn_pose)), BULK(cn_world_read_poses, cn_pose, OUT(cn_pose)))
ENTRY(cn_world_read_poses_strided, cn_world_read_poses_strided(W, NULL, 5, OUT(void), 20),
	const cn_body *l = three(f.box, f.ball, f.pill); NOW(cn_world_read_poses_strided(NULL, l, 3, OUT(void), 20));
	ARG(cn_world_read_poses_strided(W, l, 3, OUT(void), 15)); ARG(cn_world_read_poses_strided(W, l, 3, OUT(void), -16));
	ARG(cn_world_read_poses_strided(W, l, 3, NULL, 20)); ARG(cn_world_read_poses_strided(W, l, -3, OUT(void), 20));
	ARG(cn_world_read_poses_strided(W, NULL, 4, OUT(void), 20));
	BODY(h, cn_world_read_poses_strided(W, three(f.box, h, f.ball), 3, OUT(void), 20));)
ENTRY(cn_world_read_velocities, cn_world_read_velocities(W, NULL, 5, OUT(cn_velocity)), BULK(cn_world_read_velocities, cn_velocity, OUT(cn_velocity)))

static cn_velocity speeds[6];
static const cn_velocity *last_velocity(cn_vec2 linear, float angular)
{
	memset(speeds, 0, sizeof speeds);
	speeds[0].linear_mps = v2(1.0f, 1.0f);
	speeds[2].linear_mps = linear;
	speeds[2].angular_radps = angular;
	return speeds;
}
ENTRY(cn_world_write_velocities, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v2(1.0f, 2.0f), 3.0f)),
	const cn_velocity *good = last_velocity(v2(1.0f, 2.0f), 3.0f); BULK(cn_world_write_velocities, cn_velocity, good)
	VECTOR(v, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v, 0.0f)));
	FLOAT(x, cn_world_write_velocities(W, three(f.box, f.ball, f.pill), 3, last_velocity(v2(0.0f, 0.0f), x)));
	STATE(cn_world_write_velocities(W, three(f.box, f.ball, f.ground), 3, last_velocity(v2(1.0f, 0.0f), 0.0f)));)
#define ARRAY_GETTER(name, T) ENTRY(name, name(W, OUT(const T *), INT + 8), NOW(name(NULL, OUT(const T *), INT + 8)); \
	ARG(name(W, NULL, INT + 8)); ARG(name(W, OUT(const T *), NULL));)
ARRAY_GETTER(cn_world_moved, cn_body_moved)

#endif
