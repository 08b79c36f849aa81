/*
 * test/world/defaults_test.c - the convention for defaults: *_init stores every default, CN_DEFAULT stands for those that depend on
 * the world, and zero means zero.
 *
 * One table holds every number of the definitions of worlds, bodies and shapes (all others: defaults_more_test.c). The list of
 * fields is read from include/cairn.h at run time, so a new field without a row fails the test. Rows also say what the library stores
 * for a zero.
 *
 * If a test here fails, look in: world/create.c, body.c, shape_create.c (*_init, checks, what is stored).
 */
#include "defaults.h"
#include "fixture.h"
#include "model/world.h"

typedef struct all_defs {
	cn_world_def world;
	cn_body_def body;
	cn_shape_def shape;
} all_defs;

#define WF(field, by_default, zero, resolved) { "cn_world_def", #field, offsetof(all_defs, world.field), 1, by_default, zero, resolved }
#define WI(field, by_default, zero) { "cn_world_def", #field, offsetof(all_defs, world.field), 0, by_default, zero, 0.0 }
#define BF(field, by_default, zero, resolved) { "cn_body_def", #field, offsetof(all_defs, body.field), 1, by_default, zero, resolved }
#define BI(field, by_default, zero) { "cn_body_def", #field, offsetof(all_defs, body.field), 0, by_default, zero, 0.0 }
#define SF(field, by_default, zero) { "cn_shape_def", #field, offsetof(all_defs, shape.field), 1, by_default, zero, 0.0 }
#define MF(field, by_default, zero) { "cn_material", #field, offsetof(all_defs, shape.material.field), 1, by_default, zero, 0.0 }
#define MI(field, by_default, zero) { "cn_material", #field, offsetof(all_defs, shape.material.field), 0, by_default, zero, 0.0 }

static const row rows[] = {
	WF(length_unit_m, 1.0, ZERO_IS_REFUSED, 0.0), WI(solver, CN_SOLVER_AUTO, ZERO_IS_STORED), WI(broadphase, CN_BROADPHASE_SWEEP, ZERO_IS_STORED),
	WI(substep_count, 4, ZERO_IS_REFUSED), WF(accuracy_m, CN_DEFAULT, ZERO_IS_STORED, 0.01), WI(work_budget, CN_DEFAULT, ZERO_IS_REFUSED),
	WF(restitution_threshold_mps, CN_DEFAULT, ZERO_IS_STORED, 2.0), WF(push_speed_max_mps, CN_DEFAULT, ZERO_IS_REFUSED, 6.0),
	WF(linear_speed_max_mps, CN_DEFAULT, ZERO_IS_REFUSED, 800.0), WF(angular_speed_max_radps, 400.0, ZERO_IS_REFUSED, 0.0),
	WF(sleep_speed_mps, CN_DEFAULT, ZERO_IS_STORED, 0.1), WF(sleep_delay_s, 0.5, ZERO_IS_STORED, 0.0), WI(body_capacity, 0, ZERO_IS_NONE),
	WI(shape_capacity, 0, ZERO_IS_NONE), WI(contact_capacity, 0, ZERO_IS_NONE), WI(joint_capacity, 0, ZERO_IS_NONE), WI(worker_count, 1, ZERO_IS_REFUSED),
	WI(touching_capacity, CN_DEFAULT, ZERO_IS_NONE), WI(event_capacity, CN_DEFAULT, ZERO_IS_NONE), WI(vertex_capacity, CN_POLYGON_MAX_VERTICES, ZERO_IS_REFUSED),
	WF(hit_speed_mps, CN_DEFAULT, ZERO_IS_STORED, 2.0),
	BI(type, CN_BODY_DYNAMIC, ZERO_IS_STORED), BF(angle_rad, 0.0, ZERO_IS_STORED, 0.0), BF(angular_velocity_radps, 0.0, ZERO_IS_STORED, 0.0),
	BF(linear_damping_per_s, 0.0, ZERO_IS_STORED, 0.0), BF(angular_damping_per_s, 0.0, ZERO_IS_STORED, 0.0), BF(gravity_scale, 1.0, ZERO_IS_STORED, 0.0),
	BF(sleep_speed_mps, CN_DEFAULT, ZERO_IS_STORED, -1.0), BI(solver, CN_SOLVER_AUTO, ZERO_IS_STORED),
	SF(angle_rad, 0.0, ZERO_IS_STORED), SF(density_kgpm2, 1.0, ZERO_IS_STORED),
	MF(static_friction, 0.6, ZERO_IS_STORED), MF(dynamic_friction, 0.6, ZERO_IS_STORED), MF(restitution, 0.0, ZERO_IS_STORED),
	MF(rolling_resistance, 0.0, ZERO_IS_STORED), MF(tangent_speed_mps, 0.0, ZERO_IS_STORED), MI(friction_mix, CN_MIX_GEOMETRIC, ZERO_IS_STORED),
	MI(restitution_mix, CN_MIX_MAXIMUM, ZERO_IS_STORED)
};
#define ROWS ((int32_t)(sizeof rows / sizeof *rows))

static void defs_init(all_defs *d)
{
	memset(d, 0x5A, sizeof *d);
	cn_world_def_init(&d->world);
	cn_body_def_init(&d->body);
	cn_shape_def_init(&d->shape);
}

/* What the library stored, in the order of the rows; other is for those that no table of a world holds. */
static double stored(const cn_world *world, cn_body body, cn_shape shape, const row *r, double other)
{
	const cni_settings *s = &world->settings;
	const cni_body *b = cni_body_at(world, cni_handles_slot(&world->body_handles, body));
	cn_material m;
	struct { const char *structure, *field; double value; } at[40];
	int32_t n = 0, k;
	must(cn_shape_get_material(world, shape, &m), world, "cn_shape_get_material");
#define AT(part, name, expression) do { at[n].structure = part; at[n].field = name; at[n++].value = (double)(expression); } while (0)
	AT("cn_world_def", "solver", s->solver); AT("cn_world_def", "broadphase", s->broadphase); AT("cn_world_def", "accuracy_m", s->accuracy);
	AT("cn_world_def", "restitution_threshold_mps", s->restitution_threshold); AT("cn_world_def", "push_speed_max_mps", s->push_speed_max);
	AT("cn_world_def", "linear_speed_max_mps", s->linear_speed_max); AT("cn_world_def", "sleep_speed_mps", s->sleep_speed);
	AT("cn_world_def", "sleep_delay_s", s->sleep_delay); AT("cn_world_def", "hit_speed_mps", s->hit_speed);
	AT("cn_body_def", "type", b->type); AT("cn_body_def", "linear_damping_per_s", b->linear_damping);
	AT("cn_body_def", "angular_damping_per_s", b->angular_damping); AT("cn_body_def", "gravity_scale", b->gravity_scale);
	AT("cn_body_def", "sleep_speed_mps", b->sleep_speed); AT("cn_shape_def", "density_kgpm2", cni_shape_at(world, cni_handles_slot(&world->shape_handles, shape))->density);
	AT("cn_material", "static_friction", m.static_friction); AT("cn_material", "dynamic_friction", m.dynamic_friction);
	AT("cn_material", "restitution", m.restitution); AT("cn_material", "rolling_resistance", m.rolling_resistance);
	AT("cn_material", "tangent_speed_mps", m.tangent_speed_mps); AT("cn_material", "friction_mix", m.friction_mix);
	AT("cn_material", "restitution_mix", m.restitution_mix);
#undef AT
	for (k = 0; k < n; ++k)
		if (strcmp(at[k].structure, r->structure) == 0 && strcmp(at[k].field, r->field) == 0)
			return at[k].value;
	return other;
}

/* Creates a world, a body and a shape; the first failure. On success *out is what is stored of the row's field. */
static cn_result create(all_defs *d, const row *r, double *out)
{
	cn_world *world = NULL;
	cn_body body = 0;
	cn_shape shape = 0;
	cn_result result = cn_world_create(&d->world, &world);
	if (result != CN_OK)
		return result;
	result = cn_body_create(world, &d->body, &body);
	d->shape.body = body;
	if (result == CN_OK)
		result = cn_shape_create_box(world, &d->shape, 0.5f, 0.5f, 0.0f, &shape);
	if (result == CN_OK)
		*out = stored(world, body, shape, r, row_number(d, r));
	if (result == CN_OK)
		fixture_step(world, 3);
	cn_world_destroy(world);
	return result;
}

static void init_stores_every_default(void)
{
	all_defs d;
	int32_t k;
	defs_init(&d);
	for (k = 0; k < ROWS; ++k) {
		if (fabs(row_number(&d, &rows[k]) - rows[k].by_default) <= 1e-7)
			continue;
		printf("  %s.%s is %g, not %g\n", rows[k].structure, rows[k].field, row_number(&d, &rows[k]), rows[k].by_default);
		test_fail(__FILE__, __LINE__, "default");
	}
}

static void zero_means_zero(void)
{
	int32_t k;
	for (k = 0; k < ROWS; ++k) {
		const row *r = &rows[k];
		all_defs d;
		double is = -7.0;
		cn_result result;
		defs_init(&d);
		row_set(&d, r, 0.0);
		if (strcmp(r->field, "static_friction") == 0)
			d.shape.material.dynamic_friction = 0.0f;
		result = create(&d, r, &is);
		if (r->zero == ZERO_IS_REFUSED ? result == CN_ERROR_ARGUMENT : result == CN_OK && is == 0.0)
			continue;
		printf("  %s.%s 0: result %d, stored %g\n", r->structure, r->field, (int)result, is);
		test_fail(__FILE__, __LINE__, "zero");
	}
}

static void default_is_resolved_where_it_is_a_default_only(void)
{
	int32_t k;
	for (k = 0; k < ROWS; ++k) {
		const row *r = &rows[k];
		all_defs d;
		double is = -7.0;
		cn_result result;
		defs_init(&d);
		d.world.length_unit_m = 2.0f;
		if (r->by_default != (double)CN_DEFAULT || !r->is_float)
			continue;
		result = create(&d, r, &is);
		CHECK(result == CN_OK);
		CHECK_LE(r->field, fabs(is - r->resolved), 1e-6, "from the default in a world of 2 m");
		row_set(&d, r, -2.0);
		CHECK(create(&d, r, &is) == CN_ERROR_ARGUMENT);
	}
}

static void every_field_has_a_row(void)
{
	static const char *const structures[] = { "cn_world_def", "cn_body_def", "cn_shape_def", "cn_material" };
	check_fields(structures, (int32_t)(sizeof structures / sizeof *structures), rows, ROWS);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(init_stores_every_default);
	RUN(zero_means_zero);
	RUN(default_is_resolved_where_it_is_a_default_only);
	RUN(every_field_has_a_row);
	return test_end();
}
