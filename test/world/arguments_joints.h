/*
 * test/world/arguments_joints.h - entries of arguments_test for joints and constraints: good and bad calls of each
 * function. Included by arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_JOINTS_H
#define CAIRN_TEST_ARGUMENTS_JOINTS_H

/* ---- all joints, revolute, distance */

ENTRY(cn_revolute_def_init, (cn_revolute_def_init(&rd), CN_OK), cn_revolute_def_init(NULL);)
ENTRY(cn_distance_def_init, (cn_distance_def_init(&dd), CN_OK), cn_distance_def_init(NULL);)

static cn_result call_create_revolute(const cn_revolute_def *d) { return cn_joint_create_revolute(W, d, OUT(cn_joint)); }
static cn_result call_create_distance(const cn_distance_def *d) { return cn_joint_create_distance(W, d, OUT(cn_joint)); }
static cn_result call_set_revolute(const cn_revolute_def *d) { return cn_joint_set_revolute(W, f.pin, d); }
static cn_result call_set_distance(const cn_distance_def *d) { return cn_joint_set_distance(W, f.rope, d); }

static void bad_revolute(cn_result (*call)(const cn_revolute_def *))
{
	ARG(call(NULL));
	FLAGS(x, 5, call(RD(base.flags, x)));
	ANGLE(x, call(RD(reference_angle_rad, x)));
	RANGE(x, -3.2f, 0.1f, call(RD(lower_angle_rad, x)));
	RANGE(x, -0.1f, 3.2f, call(RD(upper_angle_rad, x)));
	FLOAT(x, call(RD(motor_speed_radps, x)));
	NOT_NEGATIVE(x, call(RD(motor_torque_max_Nm, x)));
	ANGLE(x, call(RD(spring_target_rad, x)));
	RANGE(x, -1.0f, 1.1e6f, call(RD(spring_hertz, x)));
	RANGE(x, -1.0f, 1.1e6f, call(RD(spring_damping_ratio, x)));
}

static void bad_distance(cn_result (*call)(const cn_distance_def *))
{
	ARG(call(NULL));
	FLAGS(x, 5, call(DD(base.flags, x)));
	POSITIVE(x, call(DD(length_m, x)));
	RANGE(x, -0.1f, 1.1f, call(DD(length_min_m, x)));
	NOT_NEGATIVE(x, call(DD(length_max_m, x)));
	FLOAT(x, call(DD(motor_speed_mps, x)));
	NOT_NEGATIVE(x, call(DD(motor_force_max_N, x)));
	RANGE(x, -1.0f, 1.1e6f, call(DD(spring_hertz, x)));
	RANGE(x, -1.0f, 1.1e6f, call(DD(spring_damping_ratio, x)));
}

/* What both creators check in base; S spoils a field of one type's definition. */
#define BAD_BASE(create, S, def) NOW(create(NULL, (reset(), &def), OUT(cn_joint))); ARG(create(W, (reset(), &def), NULL)); \
	SIZES(x, create(W, S(base.struct_size, x), OUT(cn_joint))); BODY_BUT_ZERO(h, create(W, S(base.body_a, h), OUT(cn_joint))); \
	BODY_BUT_ZERO(h, create(W, S(base.body_b, h), OUT(cn_joint))); POSITION(v, create(W, S(base.anchor_a_m, v), OUT(cn_joint))); \
	POSITION(v, create(W, S(base.anchor_b_m, v), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.box, f.box), OUT(cn_joint))); \
	ARG(create(W, BASE(def, 0, 0), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.ground, f.rail), OUT(cn_joint))); \
	ARG(create(W, BASE(def, f.ground, 0), OUT(cn_joint)));

ENTRY(cn_joint_create_revolute, cn_joint_create_revolute(W, (reset(), &rd), OUT(cn_joint)),
	bad_revolute(call_create_revolute); BAD_BASE(cn_joint_create_revolute, RD, rd))
ENTRY(cn_joint_create_distance, cn_joint_create_distance(W, (reset(), &dd), OUT(cn_joint)),
	bad_distance(call_create_distance); BAD_BASE(cn_joint_create_distance, DD, dd))
ENTRY(cn_joint_destroy, cn_joint_destroy(W, f.pin), NOW(cn_joint_destroy(NULL, f.pin)); JOINT(h, cn_joint_destroy(W, h));)
ENTRY(cn_joint_is_valid, cn_joint_is_valid(W, f.pin) ? CN_OK : -1,
	int k; CHECK(cn_joint_is_valid(NULL, f.pin) == 0); for (k = 0; k < f.bad_joint_count; ++k) CHECK(cn_joint_is_valid(W, f.bad_joints[k]) == 0);)
GETTER(cn_joint_get_type, JOINT, f.pin, int32_t)
GETTER2(cn_joint_get_bodies, JOINT, f.pin, cn_body, cn_body)
GETTER2(cn_joint_get_anchors, JOINT, f.pin, cn_vec2, cn_vec2)
GETTER2(cn_joint_get_reaction, JOINT, f.pin, cn_vec2, float)
GETTER2(cn_joint_get_error, JOINT, f.pin, float, float)
ENTRY(cn_joint_set_solver, cn_joint_set_solver(W, f.pin, CN_SOLVER_SOFT),
	NOW(cn_joint_set_solver(NULL, f.pin, 0)); JOINT(h, cn_joint_set_solver(W, h, 0)); INTEGER(x, -1, 3, cn_joint_set_solver(W, f.pin, x));)
GETTER(cn_joint_get_solver, JOINT, f.pin, int32_t)
ENTRY(cn_joint_set_user_data, cn_joint_set_user_data(W, f.pin, 3), NOW(cn_joint_set_user_data(NULL, f.pin, 3)); JOINT(h, cn_joint_set_user_data(W, h, 3));)
GETTER(cn_joint_get_user_data, JOINT, f.pin, uint64_t)
ENTRY(cn_joint_set_flags, cn_joint_set_flags(W, f.pin, CN_JOINT_MOTOR | CN_JOINT_COLLIDE),
	NOW(cn_joint_set_flags(NULL, f.pin, 0)); JOINT(h, cn_joint_set_flags(W, h, 0)); FLAGS(x, 5, cn_joint_set_flags(W, f.pin, x));)
GETTER(cn_joint_get_flags, JOINT, f.pin, uint32_t)
#define JOINT_TYPE_GETTER(name, joint, other, T) ENTRY(name, name(W, joint, OUT(T)), \
	NOW(name(NULL, joint, OUT(T))); JOINT(h, name(W, h, OUT(T))); ARG(name(W, joint, NULL)); STATE(name(W, other, OUT(T)));)
JOINT_TYPE_GETTER(cn_joint_get_revolute, f.pin, f.rope, cn_revolute_def)
JOINT_TYPE_GETTER(cn_joint_get_distance, f.rope, f.pin, cn_distance_def)
ENTRY(cn_joint_set_revolute, cn_joint_set_revolute(W, f.pin, RD(base.flags, CN_JOINT_LIMIT | CN_JOINT_COLLIDE)),
	bad_revolute(call_set_revolute); NOW(cn_joint_set_revolute(NULL, f.pin, (reset(), &rd))); JOINT(h, cn_joint_set_revolute(W, h, (reset(), &rd)));
	STATE(cn_joint_set_revolute(W, f.rope, (reset(), &rd)));)
ENTRY(cn_joint_set_distance, cn_joint_set_distance(W, f.rope, DD(base.flags, CN_JOINT_SPRING)),
	bad_distance(call_set_distance); NOW(cn_joint_set_distance(NULL, f.rope, (reset(), &dd))); JOINT(h, cn_joint_set_distance(W, h, (reset(), &dd)));
	STATE(cn_joint_set_distance(W, f.pin, (reset(), &dd)));)
GETTER(cn_joint_get_position, JOINT, f.pin, float)
GETTER(cn_joint_get_speed, JOINT, f.pin, float)
static cn_joint any[CN_JOINT_FILTER + 1]; /* one of each type: joints_make */
ENTRY(cn_joint_set_motor, cn_joint_set_motor(W, f.pin, 1.0f, 2.0f),
	NOW(cn_joint_set_motor(NULL, f.pin, 1.0f, 2.0f)); JOINT(h, cn_joint_set_motor(W, h, 1.0f, 2.0f));
	FLOAT(x, cn_joint_set_motor(W, f.pin, x, 2.0f)); NOT_NEGATIVE(x, cn_joint_set_motor(W, f.pin, 1.0f, x));
	STATE(cn_joint_set_motor(W, any[CN_JOINT_FIXED], 1.0f, 2.0f)); STATE(cn_joint_set_motor(W, any[CN_JOINT_GROOVE], 1.0f, 2.0f));)
ENTRY(cn_joint_set_limits, cn_joint_set_limits(W, f.pin, -1.0f, 1.0f),
	NOW(cn_joint_set_limits(NULL, f.pin, -1.0f, 1.0f)); JOINT(h, cn_joint_set_limits(W, h, -1.0f, 1.0f));
	RANGE(x, -3.2f, 1.1f, cn_joint_set_limits(W, f.pin, x, 1.0f)); RANGE(x, -1.1f, 3.2f, cn_joint_set_limits(W, f.pin, -1.0f, x));
	RANGE(x, -0.1f, 2.1f, cn_joint_set_limits(W, f.rope, x, 2.0f)); RANGE(x, -0.1f, 0.9f, cn_joint_set_limits(W, f.rope, 1.0f, x));
	STATE(cn_joint_set_limits(W, any[CN_JOINT_FIXED], -1.0f, 1.0f)); STATE(cn_joint_set_limits(W, any[CN_JOINT_MOUSE], -1.0f, 1.0f));)

/* ---- the other types, constraints */

/* One joint of each type and both constraints, in the fixture's world. */
static cn_constraint turn_limit, wire;
static cn_constraint bad_constraints[4];

static cn_fixed_def fixed_d;
static cn_prismatic_def prismatic_d;
static cn_wheel_def wheel_d;
static cn_motor_def motor_d;
static cn_mouse_def mouse_d;
static cn_gear_def gear_d;
static cn_pulley_def pulley_d;
static cn_ratchet_def ratchet_d;
static cn_rotary_spring_def rotary_spring_d;
static cn_groove_def groove_d;
static cn_filter_joint_def filter_d;
static cn_angle_constraint_def angle_d;
static cn_line_constraint_def line_d;

/* From the world to the ball, soft so that they do not fight each other. */
static void base_reset(cn_joint_base *base)
{
	base->body_b = f.ball;
	base->anchor_a_m = v2(3.0f, 2.0f);
	base->stiffness_hertz = 0.5f;
	base->force_max_N = 10.0f;
	base->torque_max_Nm = 10.0f;
}

static int reset_joints(void)
{
	reset();
	cn_fixed_def_init(&fixed_d);
	base_reset(&fixed_d.base);
	cn_prismatic_def_init(&prismatic_d);
	base_reset(&prismatic_d.base);
	cn_wheel_def_init(&wheel_d);
	base_reset(&wheel_d.base);
	cn_motor_def_init(&motor_d);
	base_reset(&motor_d.base);
	cn_mouse_def_init(&mouse_d);
	base_reset(&mouse_d.base);
	cn_gear_def_init(&gear_d);
	base_reset(&gear_d.base);
	cn_pulley_def_init(&pulley_d);
	base_reset(&pulley_d.base);
	cn_ratchet_def_init(&ratchet_d);
	base_reset(&ratchet_d.base);
	cn_rotary_spring_def_init(&rotary_spring_d);
	base_reset(&rotary_spring_d.base);
	cn_groove_def_init(&groove_d);
	base_reset(&groove_d.base);
	cn_filter_joint_def_init(&filter_d);
	base_reset(&filter_d.base);
	pulley_d.length_m = 20.0f;
	pulley_d.ground_a_m = v2(2.0f, 9.0f);
	pulley_d.ground_b_m = v2(3.0f, 9.0f);
	ratchet_d.click_rad = 0.5f;
	groove_d.end_m = v2(4.0f, 2.0f);
	cn_angle_constraint_def_init(&angle_d);
	angle_d.body = f.ball;
	angle_d.lower_rad = -1.0f;
	angle_d.upper_rad = 1.0f;
	cn_line_constraint_def_init(&line_d);
	line_d.body = f.ball;
	line_d.hertz = 0.5f;
	return 0;
}

static void joints_make(void)
{
	int k;
	reset_joints();
	any[CN_JOINT_REVOLUTE] = f.pin;
	any[CN_JOINT_DISTANCE] = f.rope;
	CHECK(cn_joint_create_fixed(W, &fixed_d, &any[CN_JOINT_FIXED]) == CN_OK);
	CHECK(cn_joint_create_prismatic(W, &prismatic_d, &any[CN_JOINT_PRISMATIC]) == CN_OK);
	CHECK(cn_joint_create_wheel(W, &wheel_d, &any[CN_JOINT_WHEEL]) == CN_OK);
	CHECK(cn_joint_create_motor(W, &motor_d, &any[CN_JOINT_MOTOR_TO]) == CN_OK);
	CHECK(cn_joint_create_mouse(W, &mouse_d, &any[CN_JOINT_MOUSE]) == CN_OK);
	CHECK(cn_joint_create_gear(W, &gear_d, &any[CN_JOINT_GEAR]) == CN_OK);
	CHECK(cn_joint_create_pulley(W, &pulley_d, &any[CN_JOINT_PULLEY]) == CN_OK);
	CHECK(cn_joint_create_ratchet(W, &ratchet_d, &any[CN_JOINT_RATCHET]) == CN_OK);
	CHECK(cn_joint_create_rotary_spring(W, &rotary_spring_d, &any[CN_JOINT_ROTARY_SPRING]) == CN_OK);
	CHECK(cn_joint_create_groove(W, &groove_d, &any[CN_JOINT_GROOVE]) == CN_OK);
	CHECK(cn_joint_create_filter(W, &filter_d, &any[CN_JOINT_FILTER]) == CN_OK);
	CHECK(cn_constraint_create_angle(W, &angle_d, &turn_limit) == CN_OK);
	CHECK(cn_constraint_create_line(W, &line_d, &wire) == CN_OK);
	/* Each kind's handle is a bad one of the other, also with the kind's bits changed. */
	f.bad_joints[BAD_HANDLES - 1] = turn_limit;
	f.bad_joints[BAD_HANDLES - 2] = turn_limit ^ (1u << 20);
	bad_constraints[0] = 0;
	bad_constraints[1] = f.pin;
	bad_constraints[2] = f.pin ^ (1u << 20);
	bad_constraints[3] = wire ^ (1u << 22); /* another generation */
	for (k = 0; k < f.bad_joint_count; ++k)
		CHECK(!cn_joint_is_valid(W, f.bad_joints[k]));
	reset_joints();
}

static void fixture_with_joints(int with_hooks)
{
	fixture_make(with_hooks);
	joints_make();
}

/* A good definition with one field spoiled. */
#define FIXED_D(field, value) (reset_joints(), fixed_d.field = (value), &fixed_d)
#define PRISMATIC_D(field, value) (reset_joints(), prismatic_d.field = (value), &prismatic_d)
#define WHEEL_D(field, value) (reset_joints(), wheel_d.field = (value), &wheel_d)
#define MOTOR_TO_D(field, value) (reset_joints(), motor_d.field = (value), &motor_d)
#define MOUSE_D(field, value) (reset_joints(), mouse_d.field = (value), &mouse_d)
#define GEAR_D(field, value) (reset_joints(), gear_d.field = (value), &gear_d)
#define PULLEY_D(field, value) (reset_joints(), pulley_d.field = (value), &pulley_d)
#define RATCHET_D(field, value) (reset_joints(), ratchet_d.field = (value), &ratchet_d)
#define ROTARY_SPRING_D(field, value) (reset_joints(), rotary_spring_d.field = (value), &rotary_spring_d)
#define GROOVE_D(field, value) (reset_joints(), groove_d.field = (value), &groove_d)
#define FILTER_D(field, value) (reset_joints(), filter_d.field = (value), &filter_d)
#define ANGLE_D(field, value) (reset_joints(), angle_d.field = (value), &angle_d)
#define LINE_D(field, value) (reset_joints(), line_d.field = (value), &line_d)
#define SIDES(def, a, b) (reset_joints(), def.base.body_a = (a), def.base.body_b = (b), &def)
#define CONSTRAINT(h, call) HANDLE(h, bad_constraints, 4, call)
#define SPRINGINESS(S, call) RANGE(x, -1.0f, 1.1e6f, call(S(spring_hertz, x))); RANGE(x, -1.0f, 1.1e6f, call(S(spring_damping_ratio, x)));
#define DRIVE(S, call) POSITIVE(x, call(S(hertz, x))); ARG(call(S(hertz, 1.1e6f))); RANGE(x, -1.0f, 1.1e6f, call(S(damping_ratio, x)));
#define RATIO(S, field, call) FLOAT(x, call(S(field, x))); ARG(call(S(field, 0.0f))); ARG(call(S(field, 0.9e-4f))); ARG(call(S(field, -1.1e4f)));
#define AXIS(S, call) VECTOR(v, call(S(axis, v))); ARG(call(S(axis, v2(0.0f, 0.0f)))); ARG(call(S(axis, v2(-0.0f, 0.0f))));

/* What every definition checks in base, at creation and when it is replaced. */
#define BAD_STRENGTH(S, call) ARG(call(NULL)); FLAGS(x, 5, call(S(base.flags, x))); \
	DEFAULT_OR_ABOVE_0(x, 1.1e6f, call(S(base.stiffness_hertz, x))); RANGE(x, -1.0f, 1.1e6f, call(S(base.stiffness_damping_ratio, x))); \
	DEFAULT_OR_POSITIVE(x, call(S(base.force_max_N, x))); DEFAULT_OR_POSITIVE(x, call(S(base.torque_max_Nm, x))); \
	DEFAULT_OR_POSITIVE(x, call(S(base.break_force_N, x))); DEFAULT_OR_POSITIVE(x, call(S(base.break_torque_Nm, x)));

/* What only creation checks. */
#define BAD_SIDES(create, S, def) NOW(create(NULL, (reset_joints(), &def), OUT(cn_joint))); ARG(create(W, (reset_joints(), &def), NULL)); \
	SIZES(x, create(W, S(base.struct_size, x), OUT(cn_joint))); BODY_BUT_ZERO(h, create(W, S(base.body_a, h), OUT(cn_joint))); \
	BODY_BUT_ZERO(h, create(W, S(base.body_b, h), OUT(cn_joint))); POSITION(v, create(W, S(base.anchor_a_m, v), OUT(cn_joint))); \
	POSITION(v, create(W, S(base.anchor_b_m, v), OUT(cn_joint))); \
	ARG(create(W, SIDES(def, f.box, f.box), OUT(cn_joint))); \
	ARG(create(W, SIDES(def, 0, 0), OUT(cn_joint))); \
	ARG(create(W, SIDES(def, f.ground, f.rail), OUT(cn_joint))); \
	ARG(create(W, SIDES(def, f.ground, 0), OUT(cn_joint)));

/* ---- what is particular to a type */

#define NUMBERS_FIXED(call) ANGLE(x, call(FIXED_D(reference_angle_rad, x))); DEFAULT_OR_ABOVE_0(x, 1.1e6f, call(FIXED_D(angular_hertz, x))); \
	RANGE(x, -1.0f, 1.1e6f, call(FIXED_D(angular_damping_ratio, x)));
#define NUMBERS_PRISMATIC(call) AXIS(PRISMATIC_D, call) ANGLE(x, call(PRISMATIC_D(reference_angle_rad, x))); FLOAT(x, call(PRISMATIC_D(lower_m, x))); \
	FLOAT(x, call(PRISMATIC_D(upper_m, x))); ARG(call(PRISMATIC_D(lower_m, 0.1f))); ARG(call(PRISMATIC_D(upper_m, -0.1f))); \
	FLOAT(x, call(PRISMATIC_D(motor_speed_mps, x))); NOT_NEGATIVE(x, call(PRISMATIC_D(motor_force_max_N, x))); \
	FLOAT(x, call(PRISMATIC_D(spring_target_m, x))); SPRINGINESS(PRISMATIC_D, call)
#define NUMBERS_WHEEL(call) AXIS(WHEEL_D, call) FLOAT(x, call(WHEEL_D(lower_m, x))); FLOAT(x, call(WHEEL_D(upper_m, x))); \
	ARG(call(WHEEL_D(lower_m, 0.1f))); FLOAT(x, call(WHEEL_D(motor_speed_radps, x))); NOT_NEGATIVE(x, call(WHEEL_D(motor_torque_max_Nm, x))); \
	SPRINGINESS(WHEEL_D, call)
#define NUMBERS_MOTOR_TO(call) POSITION(v, call(MOTOR_TO_D(offset_m, v))); ANGLE(x, call(MOTOR_TO_D(angle_rad, x))); DRIVE(MOTOR_TO_D, call) \
	ARG(call(MOTOR_TO_D(base.force_max_N, CN_DEFAULT))); ARG(call(MOTOR_TO_D(base.torque_max_Nm, CN_DEFAULT)));
#define NUMBERS_MOUSE(call) POSITION(v, call(MOUSE_D(target_m, v))); DRIVE(MOUSE_D, call) ARG(call(MOUSE_D(base.force_max_N, CN_DEFAULT)));
#define NUMBERS_GEAR(call) RATIO(GEAR_D, ratio, call) ANGLE(x, call(GEAR_D(phase_rad, x)));
#define NUMBERS_PULLEY(call) POSITION(v, call(PULLEY_D(ground_a_m, v))); POSITION(v, call(PULLEY_D(ground_b_m, v))); RATIO(PULLEY_D, ratio, call) \
	ARG(call(PULLEY_D(ratio, -1.0f))); POSITIVE(x, call(PULLEY_D(length_m, x)));
#define NUMBERS_RATCHET(call) ANGLE(x, call(RATCHET_D(phase_rad, x))); RATIO(RATCHET_D, click_rad, call)
#define NUMBERS_ROTARY_SPRING(call) ANGLE(x, call(ROTARY_SPRING_D(rest_angle_rad, x))); DRIVE(ROTARY_SPRING_D, call)
#define NUMBERS_GROOVE(call) POSITION(v, call(GROOVE_D(end_m, v))); ARG(call(GROOVE_D(end_m, v2(3.0f, 2.0f))));
#define NUMBERS_FILTER(call)

/* ---- entries */

ENTRY(cn_fixed_def_init, (cn_fixed_def_init(&fixed_d), CN_OK), cn_fixed_def_init(NULL);)
#define CREATE_FIXED(d) cn_joint_create_fixed(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_fixed, CREATE_FIXED((reset_joints(), &fixed_d)),
	BAD_STRENGTH(FIXED_D, CREATE_FIXED) NUMBERS_FIXED(CREATE_FIXED) BAD_SIDES(cn_joint_create_fixed, FIXED_D, fixed_d))
#define SET_FIXED(d) cn_joint_set_fixed(W, any[CN_JOINT_FIXED], d)
ENTRY(cn_joint_set_fixed, SET_FIXED(FIXED_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(FIXED_D, SET_FIXED) NUMBERS_FIXED(SET_FIXED) NOW(cn_joint_set_fixed(NULL, any[CN_JOINT_FIXED], (reset_joints(), &fixed_d)));
	JOINT(h, cn_joint_set_fixed(W, h, (reset_joints(), &fixed_d))); STATE(cn_joint_set_fixed(W, f.pin, (reset_joints(), &fixed_d)));)
JOINT_TYPE_GETTER(cn_joint_get_fixed, any[CN_JOINT_FIXED], f.pin, cn_fixed_def)

ENTRY(cn_prismatic_def_init, (cn_prismatic_def_init(&prismatic_d), CN_OK), cn_prismatic_def_init(NULL);)
#define CREATE_PRISMATIC(d) cn_joint_create_prismatic(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_prismatic, CREATE_PRISMATIC((reset_joints(), &prismatic_d)),
	BAD_STRENGTH(PRISMATIC_D, CREATE_PRISMATIC) NUMBERS_PRISMATIC(CREATE_PRISMATIC) BAD_SIDES(cn_joint_create_prismatic, PRISMATIC_D, prismatic_d))
#define SET_PRISMATIC(d) cn_joint_set_prismatic(W, any[CN_JOINT_PRISMATIC], d)
ENTRY(cn_joint_set_prismatic, SET_PRISMATIC(PRISMATIC_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(PRISMATIC_D, SET_PRISMATIC) NUMBERS_PRISMATIC(SET_PRISMATIC) NOW(cn_joint_set_prismatic(NULL, any[CN_JOINT_PRISMATIC], (reset_joints(), &prismatic_d)));
	JOINT(h, cn_joint_set_prismatic(W, h, (reset_joints(), &prismatic_d))); STATE(cn_joint_set_prismatic(W, f.pin, (reset_joints(), &prismatic_d)));)
JOINT_TYPE_GETTER(cn_joint_get_prismatic, any[CN_JOINT_PRISMATIC], f.pin, cn_prismatic_def)

ENTRY(cn_wheel_def_init, (cn_wheel_def_init(&wheel_d), CN_OK), cn_wheel_def_init(NULL);)
#define CREATE_WHEEL(d) cn_joint_create_wheel(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_wheel, CREATE_WHEEL((reset_joints(), &wheel_d)),
	BAD_STRENGTH(WHEEL_D, CREATE_WHEEL) NUMBERS_WHEEL(CREATE_WHEEL) BAD_SIDES(cn_joint_create_wheel, WHEEL_D, wheel_d))
#define SET_WHEEL(d) cn_joint_set_wheel(W, any[CN_JOINT_WHEEL], d)
ENTRY(cn_joint_set_wheel, SET_WHEEL(WHEEL_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(WHEEL_D, SET_WHEEL) NUMBERS_WHEEL(SET_WHEEL) NOW(cn_joint_set_wheel(NULL, any[CN_JOINT_WHEEL], (reset_joints(), &wheel_d)));
	JOINT(h, cn_joint_set_wheel(W, h, (reset_joints(), &wheel_d))); STATE(cn_joint_set_wheel(W, f.pin, (reset_joints(), &wheel_d)));)
JOINT_TYPE_GETTER(cn_joint_get_wheel, any[CN_JOINT_WHEEL], f.pin, cn_wheel_def)

ENTRY(cn_motor_def_init, (cn_motor_def_init(&motor_d), CN_OK), cn_motor_def_init(NULL);)
#define CREATE_MOTOR_TO(d) cn_joint_create_motor(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_motor, CREATE_MOTOR_TO((reset_joints(), &motor_d)),
	BAD_STRENGTH(MOTOR_TO_D, CREATE_MOTOR_TO) NUMBERS_MOTOR_TO(CREATE_MOTOR_TO) BAD_SIDES(cn_joint_create_motor, MOTOR_TO_D, motor_d))
#define SET_MOTOR_TO(d) cn_joint_set_motor_to(W, any[CN_JOINT_MOTOR_TO], d)
ENTRY(cn_joint_set_motor_to, SET_MOTOR_TO(MOTOR_TO_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(MOTOR_TO_D, SET_MOTOR_TO) NUMBERS_MOTOR_TO(SET_MOTOR_TO) NOW(cn_joint_set_motor_to(NULL, any[CN_JOINT_MOTOR_TO], (reset_joints(), &motor_d)));
	JOINT(h, cn_joint_set_motor_to(W, h, (reset_joints(), &motor_d))); STATE(cn_joint_set_motor_to(W, f.pin, (reset_joints(), &motor_d)));)
JOINT_TYPE_GETTER(cn_joint_get_motor_to, any[CN_JOINT_MOTOR_TO], f.pin, cn_motor_def)

ENTRY(cn_mouse_def_init, (cn_mouse_def_init(&mouse_d), CN_OK), cn_mouse_def_init(NULL);)
#define CREATE_MOUSE(d) cn_joint_create_mouse(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_mouse, CREATE_MOUSE((reset_joints(), &mouse_d)),
	BAD_STRENGTH(MOUSE_D, CREATE_MOUSE) NUMBERS_MOUSE(CREATE_MOUSE) BAD_SIDES(cn_joint_create_mouse, MOUSE_D, mouse_d) ARG(CREATE_MOUSE(SIDES(mouse_d, f.pill, f.ball)));)
#define SET_MOUSE(d) cn_joint_set_mouse(W, any[CN_JOINT_MOUSE], d)
ENTRY(cn_joint_set_mouse, SET_MOUSE(MOUSE_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(MOUSE_D, SET_MOUSE) NUMBERS_MOUSE(SET_MOUSE) NOW(cn_joint_set_mouse(NULL, any[CN_JOINT_MOUSE], (reset_joints(), &mouse_d)));
	JOINT(h, cn_joint_set_mouse(W, h, (reset_joints(), &mouse_d))); STATE(cn_joint_set_mouse(W, f.pin, (reset_joints(), &mouse_d)));)
JOINT_TYPE_GETTER(cn_joint_get_mouse, any[CN_JOINT_MOUSE], f.pin, cn_mouse_def)

ENTRY(cn_gear_def_init, (cn_gear_def_init(&gear_d), CN_OK), cn_gear_def_init(NULL);)
#define CREATE_GEAR(d) cn_joint_create_gear(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_gear, CREATE_GEAR((reset_joints(), &gear_d)),
	BAD_STRENGTH(GEAR_D, CREATE_GEAR) NUMBERS_GEAR(CREATE_GEAR) BAD_SIDES(cn_joint_create_gear, GEAR_D, gear_d))
#define SET_GEAR(d) cn_joint_set_gear(W, any[CN_JOINT_GEAR], d)
ENTRY(cn_joint_set_gear, SET_GEAR(GEAR_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(GEAR_D, SET_GEAR) NUMBERS_GEAR(SET_GEAR) NOW(cn_joint_set_gear(NULL, any[CN_JOINT_GEAR], (reset_joints(), &gear_d)));
	JOINT(h, cn_joint_set_gear(W, h, (reset_joints(), &gear_d))); STATE(cn_joint_set_gear(W, f.pin, (reset_joints(), &gear_d)));)
JOINT_TYPE_GETTER(cn_joint_get_gear, any[CN_JOINT_GEAR], f.pin, cn_gear_def)

ENTRY(cn_pulley_def_init, (cn_pulley_def_init(&pulley_d), CN_OK), cn_pulley_def_init(NULL);)
#define CREATE_PULLEY(d) cn_joint_create_pulley(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_pulley, CREATE_PULLEY((reset_joints(), &pulley_d)),
	BAD_STRENGTH(PULLEY_D, CREATE_PULLEY) NUMBERS_PULLEY(CREATE_PULLEY) BAD_SIDES(cn_joint_create_pulley, PULLEY_D, pulley_d))
#define SET_PULLEY(d) cn_joint_set_pulley(W, any[CN_JOINT_PULLEY], d)
ENTRY(cn_joint_set_pulley, SET_PULLEY(PULLEY_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(PULLEY_D, SET_PULLEY) NUMBERS_PULLEY(SET_PULLEY) NOW(cn_joint_set_pulley(NULL, any[CN_JOINT_PULLEY], (reset_joints(), &pulley_d)));
	JOINT(h, cn_joint_set_pulley(W, h, (reset_joints(), &pulley_d))); STATE(cn_joint_set_pulley(W, f.pin, (reset_joints(), &pulley_d)));)
JOINT_TYPE_GETTER(cn_joint_get_pulley, any[CN_JOINT_PULLEY], f.pin, cn_pulley_def)

ENTRY(cn_ratchet_def_init, (cn_ratchet_def_init(&ratchet_d), CN_OK), cn_ratchet_def_init(NULL);)
#define CREATE_RATCHET(d) cn_joint_create_ratchet(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_ratchet, CREATE_RATCHET((reset_joints(), &ratchet_d)),
	BAD_STRENGTH(RATCHET_D, CREATE_RATCHET) NUMBERS_RATCHET(CREATE_RATCHET) BAD_SIDES(cn_joint_create_ratchet, RATCHET_D, ratchet_d))
#define SET_RATCHET(d) cn_joint_set_ratchet(W, any[CN_JOINT_RATCHET], d)
ENTRY(cn_joint_set_ratchet, SET_RATCHET(RATCHET_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(RATCHET_D, SET_RATCHET) NUMBERS_RATCHET(SET_RATCHET) NOW(cn_joint_set_ratchet(NULL, any[CN_JOINT_RATCHET], (reset_joints(), &ratchet_d)));
	JOINT(h, cn_joint_set_ratchet(W, h, (reset_joints(), &ratchet_d))); STATE(cn_joint_set_ratchet(W, f.pin, (reset_joints(), &ratchet_d)));)
JOINT_TYPE_GETTER(cn_joint_get_ratchet, any[CN_JOINT_RATCHET], f.pin, cn_ratchet_def)

ENTRY(cn_rotary_spring_def_init, (cn_rotary_spring_def_init(&rotary_spring_d), CN_OK), cn_rotary_spring_def_init(NULL);)
#define CREATE_ROTARY_SPRING(d) cn_joint_create_rotary_spring(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_rotary_spring, CREATE_ROTARY_SPRING((reset_joints(), &rotary_spring_d)),
	BAD_STRENGTH(ROTARY_SPRING_D, CREATE_ROTARY_SPRING) NUMBERS_ROTARY_SPRING(CREATE_ROTARY_SPRING) BAD_SIDES(cn_joint_create_rotary_spring, ROTARY_SPRING_D, rotary_spring_d))
#define SET_ROTARY_SPRING(d) cn_joint_set_rotary_spring(W, any[CN_JOINT_ROTARY_SPRING], d)
ENTRY(cn_joint_set_rotary_spring, SET_ROTARY_SPRING(ROTARY_SPRING_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(ROTARY_SPRING_D, SET_ROTARY_SPRING) NUMBERS_ROTARY_SPRING(SET_ROTARY_SPRING) NOW(cn_joint_set_rotary_spring(NULL, any[CN_JOINT_ROTARY_SPRING], (reset_joints(), &rotary_spring_d)));
	JOINT(h, cn_joint_set_rotary_spring(W, h, (reset_joints(), &rotary_spring_d))); STATE(cn_joint_set_rotary_spring(W, f.pin, (reset_joints(), &rotary_spring_d)));)
JOINT_TYPE_GETTER(cn_joint_get_rotary_spring, any[CN_JOINT_ROTARY_SPRING], f.pin, cn_rotary_spring_def)

ENTRY(cn_groove_def_init, (cn_groove_def_init(&groove_d), CN_OK), cn_groove_def_init(NULL);)
#define CREATE_GROOVE(d) cn_joint_create_groove(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_groove, CREATE_GROOVE((reset_joints(), &groove_d)),
	BAD_STRENGTH(GROOVE_D, CREATE_GROOVE) NUMBERS_GROOVE(CREATE_GROOVE) BAD_SIDES(cn_joint_create_groove, GROOVE_D, groove_d))
#define SET_GROOVE(d) cn_joint_set_groove(W, any[CN_JOINT_GROOVE], d)
ENTRY(cn_joint_set_groove, SET_GROOVE(GROOVE_D(base.flags, CN_JOINT_COLLIDE | CN_JOINT_SPRING)),
	BAD_STRENGTH(GROOVE_D, SET_GROOVE) NUMBERS_GROOVE(SET_GROOVE) NOW(cn_joint_set_groove(NULL, any[CN_JOINT_GROOVE], (reset_joints(), &groove_d)));
	JOINT(h, cn_joint_set_groove(W, h, (reset_joints(), &groove_d))); STATE(cn_joint_set_groove(W, f.pin, (reset_joints(), &groove_d)));)
JOINT_TYPE_GETTER(cn_joint_get_groove, any[CN_JOINT_GROOVE], f.pin, cn_groove_def)

ENTRY(cn_filter_joint_def_init, (cn_filter_joint_def_init(&filter_d), CN_OK), cn_filter_joint_def_init(NULL);)
#define CREATE_FILTER(d) cn_joint_create_filter(W, d, OUT(cn_joint))
ENTRY(cn_joint_create_filter, CREATE_FILTER((reset_joints(), &filter_d)),
	BAD_STRENGTH(FILTER_D, CREATE_FILTER) NUMBERS_FILTER(CREATE_FILTER) BAD_SIDES(cn_joint_create_filter, FILTER_D, filter_d))

#define SET_BASE(d) cn_joint_set_base(W, any[CN_JOINT_GROOVE], d)
#define GEAR_BASE(field, value) (&GEAR_D(field, value)->base)
ENTRY(cn_joint_get_base, cn_joint_get_base(W, f.pin, OUT(cn_joint_base)),
	NOW(cn_joint_get_base(NULL, f.pin, OUT(cn_joint_base))); JOINT(h, cn_joint_get_base(W, h, OUT(cn_joint_base))); ARG(cn_joint_get_base(W, f.pin, NULL));)
ENTRY(cn_joint_set_base, SET_BASE(GEAR_BASE(base.break_force_N, 5.0f)),
	ARG(SET_BASE(NULL)); DEFAULT_OR_ABOVE_0(x, 1.1e6f, SET_BASE(GEAR_BASE(base.stiffness_hertz, x))); RANGE(x, -1.0f, 1.1e6f, SET_BASE(GEAR_BASE(base.stiffness_damping_ratio, x)));
	DEFAULT_OR_POSITIVE(x, SET_BASE(GEAR_BASE(base.force_max_N, x))); DEFAULT_OR_POSITIVE(x, SET_BASE(GEAR_BASE(base.torque_max_Nm, x)));
	DEFAULT_OR_POSITIVE(x, SET_BASE(GEAR_BASE(base.break_force_N, x))); DEFAULT_OR_POSITIVE(x, SET_BASE(GEAR_BASE(base.break_torque_Nm, x)));
	ARG(cn_joint_set_base(W, any[CN_JOINT_MOUSE], GEAR_BASE(base.force_max_N, CN_DEFAULT))); ARG(cn_joint_set_base(W, any[CN_JOINT_MOTOR_TO], GEAR_BASE(base.torque_max_Nm, CN_DEFAULT)));
	NOW(cn_joint_set_base(NULL, f.pin, (reset_joints(), &gear_d.base))); JOINT(h, cn_joint_set_base(W, h, (reset_joints(), &gear_d.base)));)
ENTRY(cn_joint_set_target, cn_joint_set_target(W, any[CN_JOINT_MOUSE], 1.0f, 2.0f),
	POSITION(v, cn_joint_set_target(W, any[CN_JOINT_MOUSE], v.x, v.y)); NOW(cn_joint_set_target(NULL, any[CN_JOINT_MOUSE], 1.0f, 2.0f));
	JOINT(h, cn_joint_set_target(W, h, 1.0f, 2.0f)); STATE(cn_joint_set_target(W, f.pin, 1.0f, 2.0f));
	CHECK(cn_joint_set_motor(W, any[CN_JOINT_GEAR], 1.0f, 2.0f) == CN_ERROR_STATE);
	CHECK(cn_joint_set_limits(W, any[CN_JOINT_GROOVE], 1.0f, 2.0f) == CN_ERROR_STATE);)
ENTRY(cn_world_joint_events, cn_world_joint_events(W, OUT(const cn_joint_event *), OUT(int32_t) + 16),
	NOW(cn_world_joint_events(NULL, OUT(const cn_joint_event *), OUT(int32_t) + 16)); ARG(cn_world_joint_events(W, NULL, OUT(int32_t) + 16));
	ARG(cn_world_joint_events(W, OUT(const cn_joint_event *), NULL));)

/* ---- constraints */

#define CREATE_ANGLE(d) cn_constraint_create_angle(W, d, OUT(cn_constraint))
#define CREATE_LINE(d) cn_constraint_create_line(W, d, OUT(cn_constraint))
#define SET_ANGLE(d) cn_constraint_set_angle(W, turn_limit, d)
#define SET_LINE(d) cn_constraint_set_line(W, wire, d)
#define BAD_ANGLE(call) ARG(call(NULL)); SIZES(x, call(ANGLE_D(struct_size, x))); FLAGS(x, 2, call(ANGLE_D(flags, x))); RANGE(x, -10001.0f, 1.1f, call(ANGLE_D(lower_rad, x))); \
	RANGE(x, -1.1f, 10001.0f, call(ANGLE_D(upper_rad, x))); DEFAULT_OR_ABOVE_0(x, 1.1e6f, call(ANGLE_D(hertz, x))); RANGE(x, -1.0f, 1.1e6f, call(ANGLE_D(damping_ratio, x))); \
	DEFAULT_OR_POSITIVE(x, call(ANGLE_D(break_torque_Nm, x)));
#define BAD_LINE(call) ARG(call(NULL)); SIZES(x, call(LINE_D(struct_size, x))); FLAGS(x, 2, call(LINE_D(flags, x))); POSITION(v, call(LINE_D(anchor_m, v))); POSITION(v, call(LINE_D(origin_m, v))); \
	AXIS(LINE_D, call) NOT_NEGATIVE(x, call(LINE_D(tolerance_m, x))); FLOAT(x, call(LINE_D(lower_m, x))); FLOAT(x, call(LINE_D(upper_m, x))); \
	ARG(call(LINE_D(lower_m, 0.1f))); DEFAULT_OR_ABOVE_0(x, 1.1e6f, call(LINE_D(hertz, x))); RANGE(x, -1.0f, 1.1e6f, call(LINE_D(damping_ratio, x))); \
	DEFAULT_OR_POSITIVE(x, call(LINE_D(break_force_N, x)));
ENTRY(cn_angle_constraint_def_init, (cn_angle_constraint_def_init(&angle_d), CN_OK), cn_angle_constraint_def_init(NULL);)
ENTRY(cn_line_constraint_def_init, (cn_line_constraint_def_init(&line_d), CN_OK), cn_line_constraint_def_init(NULL);)
ENTRY(cn_constraint_create_angle, CREATE_ANGLE((reset_joints(), &angle_d)),
	BAD_ANGLE(CREATE_ANGLE) BODY(h, CREATE_ANGLE(ANGLE_D(body, h))); ARG(CREATE_ANGLE(ANGLE_D(body, f.ground))); ARG(CREATE_ANGLE(ANGLE_D(body, f.rail)));
	NOW(cn_constraint_create_angle(NULL, (reset_joints(), &angle_d), OUT(cn_constraint))); ARG(cn_constraint_create_angle(W, (reset_joints(), &angle_d), NULL));)
ENTRY(cn_constraint_create_line, CREATE_LINE((reset_joints(), &line_d)),
	BAD_LINE(CREATE_LINE) BODY(h, CREATE_LINE(LINE_D(body, h))); ARG(CREATE_LINE(LINE_D(body, f.ground))); ARG(CREATE_LINE(LINE_D(body, f.rail)));
	NOW(cn_constraint_create_line(NULL, (reset_joints(), &line_d), OUT(cn_constraint))); ARG(cn_constraint_create_line(W, (reset_joints(), &line_d), NULL));)
ENTRY(cn_constraint_destroy, cn_constraint_destroy(W, wire), NOW(cn_constraint_destroy(NULL, wire)); CONSTRAINT(h, cn_constraint_destroy(W, h));)
ENTRY(cn_constraint_is_valid, cn_constraint_is_valid(W, wire) ? CN_OK : -1,
	int k; CHECK(cn_constraint_is_valid(NULL, wire) == 0); for (k = 0; k < 4; ++k) CHECK(cn_constraint_is_valid(W, bad_constraints[k]) == 0);)
GETTER(cn_constraint_get_type, CONSTRAINT, wire, int32_t)
GETTER(cn_constraint_get_body, CONSTRAINT, wire, cn_body)
GETTER(cn_constraint_get_position, CONSTRAINT, wire, float)
GETTER2(cn_constraint_get_reaction, CONSTRAINT, wire, cn_vec2, float)
GETTER2(cn_constraint_get_error, CONSTRAINT, wire, float, float)
#define CONSTRAINT_TYPE_GETTER(name, constraint, other, T) ENTRY(name, name(W, constraint, OUT(T)), \
	NOW(name(NULL, constraint, OUT(T))); CONSTRAINT(h, name(W, h, OUT(T))); ARG(name(W, constraint, NULL)); STATE(name(W, other, OUT(T)));)
CONSTRAINT_TYPE_GETTER(cn_constraint_get_angle, turn_limit, wire, cn_angle_constraint_def)
CONSTRAINT_TYPE_GETTER(cn_constraint_get_line, wire, turn_limit, cn_line_constraint_def)
ENTRY(cn_constraint_set_angle, SET_ANGLE((reset_joints(), &angle_d)), BAD_ANGLE(SET_ANGLE) NOW(cn_constraint_set_angle(NULL, turn_limit, (reset_joints(), &angle_d)));
	CONSTRAINT(h, cn_constraint_set_angle(W, h, (reset_joints(), &angle_d))); STATE(cn_constraint_set_angle(W, wire, (reset_joints(), &angle_d)));)
ENTRY(cn_constraint_set_line, SET_LINE((reset_joints(), &line_d)), BAD_LINE(SET_LINE) NOW(cn_constraint_set_line(NULL, wire, (reset_joints(), &line_d)));
	CONSTRAINT(h, cn_constraint_set_line(W, h, (reset_joints(), &line_d))); STATE(cn_constraint_set_line(W, turn_limit, (reset_joints(), &line_d)));)
WORLD_LIST(cn_world_get_constraints, cn_constraint)
HANDLE_LIST(cn_body_get_constraints, BODY, f.ball, cn_constraint)

/* Lines of the table. */
#define JOINT_ENTRIES \
	E(cn_fixed_def_init), E(cn_joint_create_fixed), E(cn_joint_set_fixed), E(cn_joint_get_fixed), \
	E(cn_prismatic_def_init), E(cn_joint_create_prismatic), E(cn_joint_set_prismatic), E(cn_joint_get_prismatic), \
	E(cn_wheel_def_init), E(cn_joint_create_wheel), E(cn_joint_set_wheel), E(cn_joint_get_wheel), \
	E(cn_motor_def_init), E(cn_joint_create_motor), E(cn_joint_set_motor_to), E(cn_joint_get_motor_to), \
	E(cn_mouse_def_init), E(cn_joint_create_mouse), E(cn_joint_set_mouse), E(cn_joint_get_mouse), \
	E(cn_gear_def_init), E(cn_joint_create_gear), E(cn_joint_set_gear), E(cn_joint_get_gear), \
	E(cn_pulley_def_init), E(cn_joint_create_pulley), E(cn_joint_set_pulley), E(cn_joint_get_pulley), \
	E(cn_ratchet_def_init), E(cn_joint_create_ratchet), E(cn_joint_set_ratchet), E(cn_joint_get_ratchet), \
	E(cn_rotary_spring_def_init), E(cn_joint_create_rotary_spring), E(cn_joint_set_rotary_spring), E(cn_joint_get_rotary_spring), \
	E(cn_groove_def_init), E(cn_joint_create_groove), E(cn_joint_set_groove), E(cn_joint_get_groove), \
	E(cn_filter_joint_def_init), E(cn_joint_create_filter), E(cn_joint_get_base), E(cn_joint_set_base), \
	E(cn_joint_set_target), E(cn_world_joint_events), E(cn_angle_constraint_def_init), E(cn_line_constraint_def_init), \
	E(cn_constraint_create_angle), E(cn_constraint_create_line), E(cn_constraint_destroy), E(cn_constraint_is_valid), \
	E(cn_constraint_get_type), E(cn_constraint_get_body), E(cn_constraint_get_position), E(cn_constraint_get_reaction), \
	E(cn_constraint_get_error), E(cn_constraint_get_angle), E(cn_constraint_get_line), E(cn_constraint_set_angle), \
	E(cn_constraint_set_line), E(cn_world_get_constraints), E(cn_body_get_constraints)

#endif
