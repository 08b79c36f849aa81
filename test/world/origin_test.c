/*
 * test/world/origin_test.c - promises of cn_world_shift_origin (nothing happens but that all coordinates change) and of worlds far from the
 * origin (what rests and slides there does so as near the origin, and positions can be read with all digits).
 *
 * If a test fails, look in world/origin.c for something in world coordinates that is not shifted; far from the origin in
 * model/body.h (low parts), step/finalize.c, narrowphase/touch.c.
 */
#include "fixture.h"
#include "joints.h"

#define BODIES 40

typedef struct twin {
	cn_world *world;
	cn_body bodies[BODIES];
	int32_t count;
} twin;

static int32_t broadphase;

static void twin_open(twin *t, int32_t sleep)
{
	cn_world_def def;
	memset(t, 0, sizeof *t);
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	if (!sleep)
		def.flags &= ~(uint32_t)CN_WORLD_SLEEP;
	must(cn_world_create(&def, &t->world), NULL, "cn_world_create");
}

static void twin_add(twin *t, cn_body body) { t->bodies[t->count++] = body; }

static double part(cn_vec2 high, cn_vec2 low, int32_t y) { return y ? (double)high.y + (double)low.y : (double)high.x + (double)low.x; }

static double position(const twin *t, int32_t k, int32_t y)
{
	cn_vec2 high, low;
	must(cn_body_get_position_parts(t->world, t->bodies[k], &high, &low), t->world, "cn_body_get_position_parts");
	return part(high, low, y);
}

/* Largest distance between where bodies are and where their twins are, shifted by (x, y). */
static double twins_differ(const twin *a, const twin *b, double x, double y)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < a->count; ++k)
		most = greater(most, hypot(position(a, k, 0) - x - position(b, k, 0), position(a, k, 1) - y - position(b, k, 1)));
	return most;
}

static int32_t events_of_step(cn_world *world)
{
	static const int32_t kinds[] = { CN_EVENT_CREATED, CN_EVENT_ENTER, CN_EVENT_LEAVE, CN_EVENT_DESTROYED };
	int32_t k, sum = 0;
	for (k = 0; k < 4; ++k) {
		const cn_contact_event *events = NULL;
		int32_t count = 0;
		must(cn_world_contact_events(world, kinds[k], &events, &count), world, "cn_world_contact_events");
		sum += count;
	}
	return sum;
}

/* Sum of the normal impulses at a body's contacts. */
static double impulse_of(const twin *t, int32_t k)
{
	cn_contact_event contacts[16];
	double sum = 0.0;
	int32_t count, c, p;
	must(cn_body_get_contacts(t->world, t->bodies[k], contacts, 16, &count), t->world, "cn_body_get_contacts");
	for (c = 0; c < count && c < 16; ++c)
		for (p = 0; p < contacts[c].manifold.point_count; ++p)
			sum += (double)contacts[c].manifold.points[p].normal_impulse_Ns;
	return sum;
}

static void add_pyramid(twin *t)
{
	int32_t i, k;
	fixture_floor(t->world, 0.6f, 0.0f);
	for (i = 0; i < 6; ++i)
		for (k = i; k < 6; ++k)
			twin_add(t, fixture_box(t->world, CN_BODY_DYNAMIC, (float)k - 0.5f * (float)i, 0.5f + (float)i, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f));
}

static void pyramid_is_shifted(int32_t sleep, float x, float y)
{
	twin a, b;
	double impulses = 0.0;
	int32_t k, events = 0;
	twin_open(&a, sleep);
	twin_open(&b, sleep);
	add_pyramid(&a);
	add_pyramid(&b);
	fixture_step(a.world, 200);
	fixture_step(b.world, 200);
	CHECK((fixture_counters(a.world).bodies_awake == 0) == (sleep != 0));
	must(cn_world_shift_origin(b.world, x, y), b.world, "cn_world_shift_origin");
	CHECK(fixture_is_valid(b.world));
	CHECK_LE("shift against doubles", twins_differ(&a, &b, (double)x, (double)y), 1e-6, "m");
	for (k = 0; k < a.count; ++k)
		impulses = greater(impulses, fabs(impulse_of(&a, k) - impulse_of(&b, k)));
	CHECK_LE("change of impulses", impulses, 0.0, "Ns");
	for (k = 0; k < 60; ++k) {
		fixture_step(a.world, 1);
		fixture_step(b.world, 1);
		events += events_of_step(b.world);
	}
	CHECK_LE("contact events after the shift", events, 0, "");
	CHECK_LE("bodies awake", fixture_counters(b.world).bodies_awake, sleep ? 0 : a.count, "");
	CHECK_LE("difference after a second", twins_differ(&a, &b, (double)x, (double)y), SOLVED, "m");
	CHECK(fixture_is_valid(b.world));
	cn_world_destroy(a.world);
	cn_world_destroy(b.world);
}

static void t_pyramid_stays_at_rest(void)
{
	for (broadphase = 0; broadphase < 2; ++broadphase) {
		pyramid_is_shifted(1, 1234.567f, -89.01f);
		pyramid_is_shifted(0, -345.6f, 4321.0f);
		pyramid_is_shifted(0, 100000.0f, 3.3f);
	}
	broadphase = 0;
}

/* Joints of all types with numbers in world coordinates, swinging. */
static void add_mechanism(twin *t)
{
	cn_revolute_def hinge_def;
	cn_pulley_def pulley;
	cn_groove_def groove;
	cn_mouse_def mouse;
	cn_body b[5];
	cn_joint joint;
	int32_t k;
	for (k = 0; k < 5; ++k)
		twin_add(t, b[k] = fixture_box(t->world, CN_BODY_DYNAMIC, 4.0f * (float)k, 1.0f, 0.3f, 0.5f, 0.25f, 0.5f, 0.0f));
	cn_revolute_def_init(&hinge_def);
	hinge_def.base.body_b = b[0];
	hinge_def.base.anchor_a_m = at(0.0f, 2.0f);
	hinge_def.base.anchor_b_m = at(-0.5f, 0.0f);
	must(cn_joint_create_revolute(t->world, &hinge_def, &joint), t->world, "revolute");
	cn_pulley_def_init(&pulley);
	pulley.base.body_a = b[1];
	pulley.base.body_b = b[2];
	pulley.ground_a_m = at(4.0f, 6.0f);
	pulley.ground_b_m = at(8.0f, 6.0f);
	pulley.length_m = 9.0f;
	pulley.ratio = 1.0f;
	must(cn_joint_create_pulley(t->world, &pulley, &joint), t->world, "pulley");
	cn_groove_def_init(&groove);
	groove.base.body_b = b[3];
	groove.base.anchor_a_m = at(11.0f, 1.0f);
	groove.end_m = at(14.0f, 2.0f);
	must(cn_joint_create_groove(t->world, &groove, &joint), t->world, "groove");
	cn_mouse_def_init(&mouse);
	mouse.base.body_b = b[4];
	mouse.base.force_max_N = 200.0f;
	mouse.base.anchor_a_m = at(17.0f, 3.0f);
	must(cn_joint_create_mouse(t->world, &mouse, &joint), t->world, "mouse");
}

/* Floats hold all anchors less (x, y). */
static void joints_are_shifted(float x, float y, double bound)
{
	twin a, b;
	twin_open(&a, 0);
	twin_open(&b, 0);
	add_mechanism(&a);
	add_mechanism(&b);
	fixture_step(a.world, 20);
	fixture_step(b.world, 20);
	must(cn_world_shift_origin(b.world, x, y), b.world, "cn_world_shift_origin");
	fixture_step(a.world, 20);
	fixture_step(b.world, 20);
	CHECK_LE("difference after 20 steps", twins_differ(&a, &b, (double)x, (double)y), bound, "m");
	cn_world_destroy(a.world);
	cn_world_destroy(b.world);
}

static void t_joints_go_on(void)
{
	joints_are_shifted(512.0f, -2048.0f, 1e-3);
}

static void t_queries_and_poses_are_shifted(void)
{
	cn_ray ray = { { -10.0f, 0.5f }, { 20.0f, 0.0f } };
	cn_ray_hit before, after;
	cn_update_report report;
	cn_pose poses[2];
	cn_body ball;
	twin t;
	twin_open(&t, 1);
	fixture_floor(t.world, 0.5f, 0.0f);
	ball = fixture_circle(t.world, CN_BODY_DYNAMIC, 1.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	fixture_set_velocity(t.world, ball, 3.0f, 0.0f, 0.0f);
	must(cn_world_update(t.world, 0.05f, &report), t.world, "cn_world_update");
	must(cn_world_cast_ray(t.world, &ray, NULL, &before), t.world, "cn_world_cast_ray");
	must(cn_world_read_poses_interpolated(t.world, &ball, 1, 0.5f, &poses[0]), t.world, "cn_world_read_poses_interpolated");
	must(cn_world_shift_origin(t.world, 64.0f, 32.0f), t.world, "cn_world_shift_origin");
	ray.origin_m = at(-74.0f, -31.5f);
	must(cn_world_cast_ray(t.world, &ray, NULL, &after), t.world, "cn_world_cast_ray");
	must(cn_world_read_poses_interpolated(t.world, &ball, 1, 0.5f, &poses[1]), t.world, "cn_world_read_poses_interpolated");
	CHECK(before.shape != 0 && after.shape == before.shape);
	CHECK_LE("change of the ray's fraction", fabs((double)after.fraction - (double)before.fraction), ROUNDING, "");
	CHECK_LE("interpolated pose", fabs((double)poses[0].position_m.x - 64.0 - (double)poses[1].position_m.x), ROUNDING, "m");
	cn_world_destroy(t.world);
}

/* Poses that were read before are shifted, too, of what moves, rests and is static. */
static void t_poses_are_shifted_at_once(void)
{
	cn_world *world = fixture_world(-10.0f, 1);
	cn_body bodies[3];
	cn_pose before[3], after[3];
	int32_t k;
	bodies[0] = fixture_floor(world, 0.5f, 0.0f);
	bodies[1] = unit_box(world, 0.0f, 0.5f, 0.0f);
	fixture_step(world, 60);
	bodies[2] = unit_box(world, 5.0f, 3.0f, 0.0f);
	for (k = 0; k < 2; ++k) {
		fixture_step(world, 1);
		must(cn_world_read_poses(world, bodies, 3, before), world, "cn_world_read_poses");
	}
	must(cn_world_shift_origin(world, 4.0f, 2.0f), world, "cn_world_shift_origin");
	CHECK(fixture_is_valid(world) && !fixture_is_awake(world, bodies[1]));
	must(cn_world_read_poses(world, bodies, 3, after), world, "cn_world_read_poses");
	for (k = 0; k < 3; ++k)
		CHECK_LE("error of a shifted pose", hypot((double)before[k].position_m.x - 4.0 - (double)after[k].position_m.x, (double)before[k].position_m.y - 2.0 - (double)after[k].position_m.y), ROUNDING, "m");
	cn_world_destroy(world);
}

/* ---- far from the origin ---- */

/* Made near the origin and shifted, as floats cannot place bodies at 100 km. What is left of 1 mm at a distance. */
static void scene_is_accurate_at(float distance, double slide_bound, double pile_bound)
{
	twin a, b;
	int32_t k;
	for (k = 0; k < 2; ++k) {
		twin *t = k == 0 ? &a : &b;
		twin_open(t, 0);
		add_pyramid(t);
		twin_add(t, fixture_box(t->world, CN_BODY_DYNAMIC, -40.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.3f, 0.0f));
		fixture_set_velocity(t->world, t->bodies[t->count - 1], 6.0f, 0.0f, 0.0f);
	}
	must(cn_world_shift_origin(b.world, -distance, -distance), b.world, "cn_world_shift_origin");
	fixture_step(a.world, 180);
	fixture_step(b.world, 180);
	printf("  at %g km:\n", (double)distance * 1e-3);
	k = a.count - 1;
	CHECK_LE("a box slid so much farther or less far", fabs(position(&a, k, 0) + (double)distance - position(&b, k, 0)), slide_bound, "m");
	a.count = b.count = k;
	CHECK_LE("a pyramid stands so far off", twins_differ(&a, &b, -(double)distance, -(double)distance), pile_bound, "m");
	cn_world_destroy(a.world);
	cn_world_destroy(b.world);
}

static void t_accuracy_far_away(void)
{
	scene_is_accurate_at(1e3f, 1e-3, 1e-3);
	scene_is_accurate_at(1e4f, 1e-3, 1e-3);
	scene_is_accurate_at(1e5f, 1e-3, 1e-3);
}

/* Balls of 0.2 m at 200 m/s against a wall of 0.1 m, and boxes that fall on a floor. */
static void t_fast_bodies_stop_far_away(void)
{
	double through = 0.0, deep = 0.0;
	twin t;
	int32_t k;
	twin_open(&t, 0);
	fixture_floor(t.world, 0.5f, 0.0f);
	fixture_box(t.world, CN_BODY_STATIC, 10.0f, 10.0f, 0.0f, 0.05f, 10.0f, 0.5f, 0.0f);
	for (k = 0; k < BODIES; ++k) {
		twin_add(&t, k % 2 == 0 ? fixture_circle(t.world, CN_BODY_DYNAMIC, -10.0f, 0.3f + 0.45f * (float)k, 0.2f, 0.5f, 0.0f)
		                        : fixture_box(t.world, CN_BODY_DYNAMIC, -20.0f - 1.5f * (float)k, 10.0f, 0.2f, 0.5f, 0.5f, 0.5f, 0.0f));
		if (k % 2 == 0)
			fixture_set_velocity(t.world, t.bodies[k], 200.0f + (float)k, 0.0f, 0.0f);
	}
	must(cn_world_shift_origin(t.world, -1e5f, -1e5f), t.world, "cn_world_shift_origin");
	for (k = 0; k < 180; ++k) {
		int32_t i;
		fixture_step(t.world, 1);
		for (i = 0; i < t.count; ++i) {
			through = greater(through, i % 2 == 0 ? position(&t, i, 0) - 1e5 - (10.0 - 0.05 - 0.2) : 0.0);
			deep = greater(deep, 1e5 + (i % 2 == 0 ? 0.2 : 0.45) - position(&t, i, 1));
		}
	}
	CHECK_LE("balls in the wall at 100 km", through, 0.1, "m");
	CHECK_LE("bodies in the floor at 100 km", deep, 0.1, "m");
	cn_world_destroy(t.world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_pyramid_stays_at_rest);
	RUN(t_joints_go_on);
	RUN(t_queries_and_poses_are_shifted);
	RUN(t_poses_are_shifted_at_once);
	RUN(t_accuracy_far_away);
	RUN(t_fast_bodies_stop_far_away);
	return test_end();
}
