/*
 * test/world/defaults_more_test.c - the convention for defaults (defaults_test.c) in the definitions of joints, constraints, areas,
 * movers and explosions: *_init stores every default, CN_DEFAULT stands for those that are no number in the range, and zero means zero
 * or is refused.
 *
 * If a test here fails, look in: world/joint_kinds.c, joint_create.c (base), area.c, mover.c, explosion.c.
 */
#include "defaults.h"
#include "fixture.h"

typedef union any_def {
	cn_joint_base base; /* first in the definitions of joints */
	cn_revolute_def revolute;
	cn_distance_def distance;
	cn_fixed_def fixed;
	cn_prismatic_def prismatic;
	cn_wheel_def wheel;
	cn_motor_def motor;
	cn_mouse_def mouse;
	cn_gear_def gear;
	cn_pulley_def pulley;
	cn_ratchet_def ratchet;
	cn_rotary_spring_def rotary_spring;
	cn_groove_def groove;
	cn_filter_joint_def filter;
	cn_angle_constraint_def angle;
	cn_line_constraint_def line;
	cn_area_def area;
	cn_mover_def mover;
	cn_explosion_def explosion;
} any_def;

#define F(def, member, field, by_default, zero) { #def, #field, offsetof(any_def, member.field), 1, by_default, zero, 0.0 }
#define I(def, member, field, by_default, zero) { #def, #field, offsetof(any_def, member.field), 0, by_default, zero, 0.0 }
#define BASE(field, by_default, zero) F(cn_joint_base, base, field, by_default, zero)

static const row rows[] = {
	BASE(stiffness_hertz, CN_DEFAULT, ZERO_IS_REFUSED), BASE(stiffness_damping_ratio, 0.0, ZERO_IS_STORED), BASE(force_max_N, CN_DEFAULT, ZERO_IS_REFUSED),
	BASE(torque_max_Nm, CN_DEFAULT, ZERO_IS_REFUSED), BASE(break_force_N, CN_DEFAULT, ZERO_IS_REFUSED), BASE(break_torque_Nm, CN_DEFAULT, ZERO_IS_REFUSED),
#define R(field) F(cn_revolute_def, revolute, field, 0.0, ZERO_IS_STORED)
	R(reference_angle_rad), R(lower_angle_rad), R(upper_angle_rad), R(motor_speed_radps), R(motor_torque_max_Nm), R(spring_target_rad), R(spring_hertz),
	R(spring_damping_ratio),
#define D(field, by_default, zero) F(cn_distance_def, distance, field, by_default, zero)
	D(length_m, 1.0, ZERO_IS_REFUSED), D(length_min_m, 0.0, ZERO_IS_STORED), D(length_max_m, 1.0, ZERO_IS_STORED), D(motor_speed_mps, 0.0, ZERO_IS_STORED),
	D(motor_force_max_N, 0.0, ZERO_IS_STORED), D(spring_hertz, 0.0, ZERO_IS_STORED), D(spring_damping_ratio, 0.0, ZERO_IS_STORED),
#define X(field, by_default, zero) F(cn_fixed_def, fixed, field, by_default, zero)
	X(reference_angle_rad, 0.0, ZERO_IS_STORED), X(angular_hertz, CN_DEFAULT, ZERO_IS_REFUSED), X(angular_damping_ratio, 0.0, ZERO_IS_STORED),
#define P(field) F(cn_prismatic_def, prismatic, field, 0.0, ZERO_IS_STORED)
	P(reference_angle_rad), P(lower_m), P(upper_m), P(motor_speed_mps), P(motor_force_max_N), P(spring_target_m), P(spring_hertz), P(spring_damping_ratio),
#define W(field, by_default) F(cn_wheel_def, wheel, field, by_default, ZERO_IS_STORED)
	W(lower_m, 0.0), W(upper_m, 0.0), W(motor_speed_radps, 0.0), W(motor_torque_max_Nm, 0.0), W(spring_hertz, 1.0), W(spring_damping_ratio, 0.7),
	F(cn_motor_def, motor, angle_rad, 0.0, ZERO_IS_STORED), F(cn_motor_def, motor, hertz, 5.0, ZERO_IS_REFUSED),
	F(cn_motor_def, motor, damping_ratio, 1.0, ZERO_IS_STORED),
	F(cn_mouse_def, mouse, hertz, 5.0, ZERO_IS_REFUSED), F(cn_mouse_def, mouse, damping_ratio, 0.7, ZERO_IS_STORED),
	F(cn_gear_def, gear, ratio, 1.0, ZERO_IS_REFUSED), F(cn_gear_def, gear, phase_rad, 0.0, ZERO_IS_STORED),
	F(cn_pulley_def, pulley, ratio, 1.0, ZERO_IS_REFUSED), F(cn_pulley_def, pulley, length_m, 0.0, ZERO_IS_REFUSED),
	F(cn_ratchet_def, ratchet, phase_rad, 0.0, ZERO_IS_STORED), F(cn_ratchet_def, ratchet, click_rad, 0.0, ZERO_IS_REFUSED),
	F(cn_rotary_spring_def, rotary_spring, rest_angle_rad, 0.0, ZERO_IS_STORED), F(cn_rotary_spring_def, rotary_spring, hertz, 1.0, ZERO_IS_REFUSED),
	F(cn_rotary_spring_def, rotary_spring, damping_ratio, 0.0, ZERO_IS_STORED),
#define A(field, by_default, zero) F(cn_angle_constraint_def, angle, field, by_default, zero)
	A(lower_rad, 0.0, ZERO_IS_STORED), A(upper_rad, 0.0, ZERO_IS_STORED), A(hertz, CN_DEFAULT, ZERO_IS_REFUSED), A(damping_ratio, 0.0, ZERO_IS_STORED),
	A(break_torque_Nm, CN_DEFAULT, ZERO_IS_REFUSED),
#define L(field, by_default, zero) F(cn_line_constraint_def, line, field, by_default, zero)
	L(tolerance_m, 0.0, ZERO_IS_STORED), L(lower_m, 0.0, ZERO_IS_STORED), L(upper_m, 0.0, ZERO_IS_STORED), L(hertz, CN_DEFAULT, ZERO_IS_REFUSED),
	L(damping_ratio, 0.0, ZERO_IS_STORED), L(break_force_N, CN_DEFAULT, ZERO_IS_REFUSED),
#define M(field) F(cn_area_def, area, field, 0.0, ZERO_IS_STORED)
	I(cn_area_def, area, priority, 0, ZERO_IS_STORED), M(pull_mps2), F(cn_area_def, area, pull_distance_m, CN_DEFAULT, ZERO_IS_REFUSED),
	M(linear_damping_per_s), M(angular_damping_per_s), M(density_kgpm2), M(drag_kgpm2), M(lift_kgpm2),
#define C(field, by_default) F(cn_mover_def, mover, field, by_default, ZERO_IS_NONE)
	C(slope_limit_rad, 0.87), C(step_height_m, 0.3), C(snap_m, 0.3), C(gravity_scale, 1.0), C(push_force_N, 200.0),
	I(cn_mover_def, mover, iterations_max, 8, ZERO_IS_REFUSED),
#define E(field, by_default) F(cn_explosion_def, explosion, field, by_default, ZERO_IS_NONE)
	E(radius_m, 1.0), E(falloff_m, 0.0), E(impulse_Nspm, 0.0)
};
#define ROWS ((int32_t)(sizeof rows / sizeof *rows))

/* ---- what a definition is used for ---- */

/* Uses *d in a new world; on success *d is what the library stored of it. */
typedef cn_result use_fn(cn_world *world, cn_body body, any_def *d);

#define JOINT_USE(noun, member, type, get) \
	static void init_##member(any_def *d) { cn_##type##_init(&d->member); } \
	static cn_result use_##member(cn_world *world, cn_body body, any_def *d) \
	{ \
		cn_joint joint; \
		cn_result result; \
		d->base.body_b = body; \
		result = cn_joint_create_##noun(world, &d->member, &joint); \
		return result == CN_OK ? get : result; \
	}
#define JOINT(noun, type) JOINT_USE(noun, noun, type, cn_joint_get_##noun(world, joint, &d->noun))

JOINT(revolute, revolute_def)
JOINT(distance, distance_def)
JOINT(fixed, fixed_def)
JOINT(prismatic, prismatic_def)
JOINT(wheel, wheel_def)
JOINT(gear, gear_def)
JOINT(rotary_spring, rotary_spring_def)
JOINT(groove, groove_def)
JOINT(pulley, pulley_def)
JOINT(ratchet, ratchet_def)
JOINT_USE(motor, motor, motor_def, cn_joint_get_motor_to(world, joint, &d->motor))
JOINT_USE(mouse, mouse, mouse_def, cn_joint_get_mouse(world, joint, &d->mouse))
JOINT_USE(filter, filter, filter_joint_def, cn_joint_get_base(world, joint, &d->base))

#define CONSTRAINT(noun) \
	static void init_##noun(any_def *d) { cn_##noun##_constraint_def_init(&d->noun); } \
	static cn_result use_##noun(cn_world *world, cn_body body, any_def *d) \
	{ \
		cn_constraint constraint; \
		cn_result result; \
		d->noun.body = body; \
		result = cn_constraint_create_##noun(world, &d->noun, &constraint); \
		return result == CN_OK ? cn_constraint_get_##noun(world, constraint, &d->noun) : result; \
	}
CONSTRAINT(angle)
CONSTRAINT(line)

static void init_area(any_def *d) { cn_area_def_init(&d->area); }
static cn_result use_area(cn_world *world, cn_body body, any_def *d)
{
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_shape sensor = 0;
	cn_result result;
	def.flags = CN_SHAPE_SENSOR;
	must(cn_shape_create_box(world, &def, 1.0f, 1.0f, 0.0f, &sensor), world, "cn_shape_create_box");
	result = cn_shape_set_area(world, sensor, &d->area);
	return result == CN_OK ? cn_shape_get_area(world, sensor, &d->area) : result;
}

static void init_mover(any_def *d) { cn_mover_def_init(&d->mover); }
static cn_result use_mover(cn_world *world, cn_body body, any_def *d)
{
	cn_mover mover;
	(void)body;
	memset(&mover, 0, sizeof mover);
	return cn_mover_move(world, &d->mover, 1.0f / 60.0f, &mover);
}

static void init_explosion(any_def *d) { cn_explosion_def_init(&d->explosion); }
static cn_result use_explosion(cn_world *world, cn_body body, any_def *d)
{
	(void)body;
	return cn_world_explode(world, &d->explosion);
}

typedef struct kind {
	const char *structure;
	void (*init)(any_def *d);
	use_fn *use;
	int32_t is_joint;
} kind;
#define KIND(structure, member, is_joint) { #structure, init_##member, use_##member, is_joint }
static const kind kinds[] = {
	KIND(cn_revolute_def, revolute, 1), KIND(cn_distance_def, distance, 1), KIND(cn_fixed_def, fixed, 1), KIND(cn_prismatic_def, prismatic, 1),
	KIND(cn_wheel_def, wheel, 1), KIND(cn_motor_def, motor, 1), KIND(cn_mouse_def, mouse, 1), KIND(cn_gear_def, gear, 1), KIND(cn_pulley_def, pulley, 1),
	KIND(cn_ratchet_def, ratchet, 1), KIND(cn_rotary_spring_def, rotary_spring, 1), KIND(cn_groove_def, groove, 1), KIND(cn_filter_joint_def, filter, 1),
	KIND(cn_angle_constraint_def, angle, 0), KIND(cn_line_constraint_def, line, 0), KIND(cn_area_def, area, 0), KIND(cn_mover_def, mover, 0),
	KIND(cn_explosion_def, explosion, 0)
};
#define KINDS ((int32_t)(sizeof kinds / sizeof *kinds))

static int32_t has_field(const kind *k, const row *r)
{
	return strcmp(k->structure, r->structure) == 0 || (k->is_joint && strcmp(r->structure, "cn_joint_base") == 0);
}

/* Defaults, and values where a definition must have some. */
static void prepare(const kind *k, any_def *d)
{
	memset(d, 0x5A, sizeof *d);
	k->init(d);
	if (k->use == use_motor)
		d->base.torque_max_Nm = 10.0f;
	if (k->use == use_motor || k->use == use_mouse)
		d->base.force_max_N = 10.0f;
	if (k->use == use_pulley)
		d->pulley.length_m = 20.0f;
	if (k->use == use_ratchet)
		d->ratchet.click_rad = 0.5f;
}

static cn_result use(const kind *k, any_def *d)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body body = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	cn_result result = k->use(world, body, d);
	fixture_step(world, 2);
	cn_world_destroy(world);
	return result;
}

/* ---- tests ---- */

static void init_stores_every_default(void)
{
	int32_t i, k;
	for (k = 0; k < KINDS; ++k)
		for (i = 0; i < ROWS; ++i) {
			any_def d;
			if (!has_field(&kinds[k], &rows[i]))
				continue;
			memset(&d, 0x5A, sizeof d);
			kinds[k].init(&d);
			if (fabs(row_number(&d, &rows[i]) - rows[i].by_default) <= 1e-7)
				continue;
			printf("  %s: %s is %g, not %g\n", kinds[k].structure, rows[i].field, row_number(&d, &rows[i]), rows[i].by_default);
			test_fail(__FILE__, __LINE__, "default");
		}
}

static void zero_means_zero(void)
{
	int32_t i, k, tried = 0;
	for (k = 0; k < KINDS; ++k)
		for (i = 0; i < ROWS; ++i) {
			const row *r = &rows[i];
			any_def d;
			cn_result result;
			if (!has_field(&kinds[k], r))
				continue;
			prepare(&kinds[k], &d);
			row_set(&d, r, 0.0);
			++tried;
			result = use(&kinds[k], &d);
			if (r->zero == ZERO_IS_REFUSED ? result == CN_ERROR_ARGUMENT : result == CN_OK && row_number(&d, r) == 0.0)
				continue;
			printf("  %s: %s 0: result %d, read back %g\n", kinds[k].structure, r->field, (int)result, row_number(&d, r));
			test_fail(__FILE__, __LINE__, "zero");
		}
	CHECK_GE("fields set to zero", tried, ROWS, "");
}

/* CN_DEFAULT is read back; a number near it is no default. */
static void default_is_read_back(void)
{
	int32_t i, k;
	for (k = 0; k < KINDS; ++k)
		for (i = 0; i < ROWS; ++i) {
			const row *r = &rows[i];
			any_def d;
			if (!has_field(&kinds[k], r) || r->by_default != (double)CN_DEFAULT)
				continue;
			prepare(&kinds[k], &d);
			if (row_number(&d, r) != (double)CN_DEFAULT) /* motor, mouse: must be set */
				continue;
			CHECK(use(&kinds[k], &d) == CN_OK && row_number(&d, r) == (double)CN_DEFAULT);
			prepare(&kinds[k], &d);
			row_set(&d, r, -2.0);
			CHECK(use(&kinds[k], &d) == CN_ERROR_ARGUMENT);
			prepare(&kinds[k], &d);
			row_set(&d, r, 7.0);
			CHECK(use(&kinds[k], &d) == CN_OK && row_number(&d, r) == 7.0);
		}
}

static void every_field_has_a_row(void)
{
	const char *structures[KINDS + 1];
	int32_t k;
	structures[KINDS] = "cn_joint_base";
	for (k = 0; k < KINDS; ++k)
		structures[k] = kinds[k].structure;
	check_fields(structures, KINDS + 1, rows, ROWS);
}

/* A definition that is in neither of the two tests. */
static void every_definition_is_tested(void)
{
	const char *p, *open = "\ntypedef struct cn_";
	for (p = strstr(header_text(), open); p != NULL; p = strstr(p + 1, open)) {
		const char *name = p + 16;
		size_t length = strcspn(name, " ;");
		int32_t k, known = strncmp(name, "cn_world_def", length) == 0 || strncmp(name, "cn_body_def", length) == 0 || strncmp(name, "cn_shape_def", length) == 0;
		if (length < 4 || strncmp(name + length - 4, "_def", 4) != 0)
			continue;
		for (k = 0; k < KINDS; ++k)
			known |= strlen(kinds[k].structure) == length && strncmp(kinds[k].structure, name, length) == 0;
		if (known)
			continue;
		printf("  no test of %.*s\n", (int)length, name);
		test_fail(__FILE__, __LINE__, "definition");
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(init_stores_every_default);
	RUN(zero_means_zero);
	RUN(default_is_read_back);
	RUN(every_field_has_a_row);
	RUN(every_definition_is_tested);
	return test_end();
}
