/*
 * test/world/area_test.c - areas (sensors with gravity, damping and a medium) and wind, against closed forms.
 *
 * If a test here fails, look first in: geometry/medium (its own test), step/areas.c (fields of a body), model/area.c (waking, order),
 * step/integrate.c (external accelerations).
 */
#include "save/files.h"

#define PI 3.14159265358979
#define G 10.0

/* ---- scenes ---- */

static cn_shape sensor_box(cn_world *world, int32_t type, float x, float y, float hx, float hy)
{
	cn_body body = fixture_body(world, type, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.flags = CN_SHAPE_SENSOR;
	return fixture_box_shape(world, &def, hx, hy);
}

static cn_shape sensor_circle(cn_world *world, float x, float y, float radius)
{
	cn_body body = fixture_body(world, CN_BODY_STATIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_shape shape;
	circle.radius_m = radius;
	def.flags = CN_SHAPE_SENSOR;
	must(cn_shape_create_circle(world, &def, &circle, &shape), world, "cn_shape_create_circle");
	return shape;
}

static cn_area_def area_def(void)
{
	cn_area_def def;
	cn_area_def_init(&def);
	return def;
}

static void set_area(cn_world *world, cn_shape shape, const cn_area_def *def)
{
	must(cn_shape_set_area(world, shape, def), world, "cn_shape_set_area");
}

static cn_shape water(cn_world *world, float density, float drag, float damping)
{
	cn_shape shape = sensor_box(world, CN_BODY_STATIC, 0.0f, -50.0f, 200.0f, 50.0f); /* surface at y = 0 */
	cn_area_def def = area_def();
	def.density_kgpm2 = density;
	def.drag_kgpm2 = drag;
	def.linear_damping_per_s = def.angular_damping_per_s = damping;
	set_area(world, shape, &def);
	return shape;
}

static cn_body box_of_density(cn_world *world, float x, float y, float hx, float hy, float density)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.density_kgpm2 = density;
	fixture_box_shape(world, &def, hx, hy);
	return body;
}

static void steps(cn_world *world, float dt, int32_t count)
{
	while (count-- > 0)
		must(cn_world_step(world, dt), world, "cn_world_step");
}

static double height(const cn_world *world, cn_body body) { return (double)fixture_pose(world, body).position_m.y; }
static double fall_speed(const cn_world *world, cn_body body) { return -(double)fixture_velocity(world, body).linear_mps.y; }

/* ---- wind ---- */

static void terminal_speeds_are_exact(void)
{
	static const float dts[] = { 1.0f / 240.0f, 1.0f / 60.0f, 1.0f / 10.0f };
	double quadratic = 0.0, linear = 0.0;
	for (int32_t k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(-(float)G, 0);
		cn_shape air = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 4000.0f, 4000.0f);
		cn_area_def def = area_def();
		cn_body box = box_of_density(world, 0.0f, 0.0f, 0.5f, 1.0f, 1.0f), disc = fixture_circle(world, CN_BODY_DYNAMIC, 5.0f, 0.0f, 0.5f, 0.5f, 0.0f);
		def.drag_kgpm2 = 0.5f;
		set_area(world, air, &def);
		steps(world, dts[k], (int32_t)(20.0f / dts[k]));
		quadratic = greater(quadratic, fabs(fall_speed(world, box) / sqrt(2.0 * 2.0 * G / 0.5) - 1.0));
		quadratic = greater(quadratic, fabs(fall_speed(world, disc) / sqrt(2.0 * PI * 0.25 * G / 0.5) - 1.0));
		def.drag_kgpm2 = 0.0f;
		def.linear_damping_per_s = 2.0f;
		set_area(world, air, &def);
		steps(world, dts[k], (int32_t)(20.0f / dts[k]));
		linear = greater(linear, fabs(fall_speed(world, box) / (G / 2.0) - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("terminal speed with quadratic drag, sqrt(2 m g / (drag w))", quadratic, ROUNDING, "relative");
	CHECK_LE("terminal speed with damping, g / c", linear, ROUNDING, "relative");
}

/* m v' = -k v^2: v = v0 / (1 + k v0 t / m), whatever the steps. */
static void wind_slows_exactly(void)
{
	double worst = 0.0;
	for (int32_t k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body box = box_of_density(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f);
		int32_t count = k == 0 ? 600 : k == 1 ? 60 : 10;
		fixture_set_velocity(world, box, 40.0f, 0.0f, 0.0f);
		for (int32_t i = 0; i < count; ++i) {
			must(cn_shape_apply_wind(world, fixture_first_shape(world, box), 0.0f, 0.0f, 0.2f, 0.0f, 10.0f / (float)count, 1), world, "wind");
			steps(world, 10.0f / (float)count, 1);
		}
		worst = greater(worst, fabs((double)fixture_velocity(world, box).linear_mps.x / (40.0 / (1.0 + 0.1 * 40.0 * 10.0)) - 1.0));
		cn_world_destroy(world);
	}
	CHECK_LE("speed after 10 s in 600, 60 and 10 steps", worst, 1e-4, "relative");
}

static void wind_wakes_if_asked(void)
{
	cn_world *world = fixture_world(-(float)G, 1);
	cn_body box;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 120);
	REQUIRE(!fixture_is_awake(world, box));
	must(cn_shape_apply_wind(world, fixture_first_shape(world, box), 9.0f, 0.0f, 1.0f, 1.0f, FRAME_S, 0), world, "wind");
	CHECK(!fixture_is_awake(world, box) && fixture_velocity(world, box).linear_mps.x == 0.0f);
	must(cn_shape_apply_wind(world, fixture_first_shape(world, box), 9.0f, 0.0f, 1.0f, 1.0f, FRAME_S, 1), world, "wind");
	CHECK(fixture_is_awake(world, box) && fixture_velocity(world, box).linear_mps.x > 0.0f);
	cn_world_destroy(world);
}

static void a_wind_tunnel_carries(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape tunnel = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 20.0f, 2.0f);
	cn_area_def def = area_def();
	cn_body in = box_of_density(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f), out = box_of_density(world, 0.0f, 5.0f, 0.5f, 0.5f, 1.0f);
	def.drag_kgpm2 = 5.0f;
	def.flow_mps.x = 8.0f;
	set_area(world, tunnel, &def);
	fixture_step(world, 60);
	CHECK_GE("speed in the tunnel", (double)fixture_velocity(world, in).linear_mps.x, 7.0, "m/s");
	CHECK_LE("... at most that of the flow", (double)fixture_velocity(world, in).linear_mps.x, 8.0, "m/s");
	CHECK(fixture_velocity(world, out).linear_mps.x == 0.0f);
	fixture_step(world, 300);
	def.drag_kgpm2 = 1e9f;
	set_area(world, tunnel, &def);
	must(cn_body_set_pose(world, in, 0.0f, 0.0f, 0.7f), world, "cn_body_set_pose");
	fixture_set_velocity(world, in, -300.0f, 0.0f, 200.0f);
	fixture_step(world, 3);
	CHECK_LE("a medium as hard as stone: speed off the flow's", hypot((double)fixture_velocity(world, in).linear_mps.x - 8.0, (double)fixture_velocity(world, in).linear_mps.y), 0.5, "m/s");
	cn_world_destroy(world);
}

/* ---- water ---- */

/* A box of draught d = h rho_b / rho_f heaves with w^2 = g / d. */
static void a_box_floats_with_its_period(void)
{
	cn_world *world = fixture_world(-(float)G, 0);
	cn_body box = box_of_density(world, 0.0f, 0.0f, 1.0f, 0.5f, 500.0f);
	double period = 2.0 * PI * sqrt(0.5 / G), crossed[100], last, amplitude = 0.0;
	int32_t crossings = 0, k;
	water(world, 1000.0f, 0.0f, 0.0f);
	must(cn_body_set_pose(world, box, 0.0f, 0.1f, 0.0f), world, "cn_body_set_pose");
	last = height(world, box);
	for (k = 1; k <= 3600; ++k) {
		double now;
		fixture_step(world, 1);
		now = height(world, box);
		if (last < 0.0 && now >= 0.0 && crossings < 100)
			crossed[crossings++] = ((double)k - now / (now - last)) / 60.0;
		if (k > 3300)
			amplitude = fmax(amplitude, fabs(now));
		last = now;
	}
	REQUIRE(crossings > 30);
	CHECK_LE("period, less 2 pi sqrt(d / g)", fabs((crossed[crossings - 1] - crossed[0]) / (crossings - 1) / period - 1.0), 0.002, "relative");
	CHECK_LE("amplitude after a minute without damping", fabs(amplitude / 0.1 - 1.0), 0.01, "relative");
	cn_world_destroy(world);
}

static void boxes_find_their_draught(void)
{
	cn_world *world = fixture_world(-(float)G, 0);
	cn_body wood = box_of_density(world, 0.0f, 0.2f, 1.0f, 0.5f, 700.0f), cork = box_of_density(world, 5.0f, 0.2f, 1.0f, 0.5f, 100.0f);
	cn_body stone = box_of_density(world, -5.0f, 0.0f, 0.5f, 0.5f, 2500.0f);
	water(world, 1000.0f, 1000.0f, 1.0f);
	fixture_step(world, 60 * 30);
	CHECK_LE("draught of wood", fabs(0.5 - height(world, wood) - 0.7), 1e-4, "m");
	CHECK_LE("draught of cork", fabs(0.5 - height(world, cork) - 0.1), 1e-4, "m");
	CHECK(height(world, stone) < -10.0);
	cn_world_destroy(world);
}

static void floats_sleep(void)
{
	cn_world *world = fixture_world(-(float)G, 1);
	cn_body wood = box_of_density(world, 0.0f, 0.2f, 1.0f, 0.5f, 700.0f);
	cn_shape pool = water(world, 1000.0f, 1000.0f, 1.0f);
	fixture_step(world, 60 * 20);
	CHECK(!fixture_is_awake(world, wood));
	CHECK_LE("draught of wood that sleeps: a swing of 0.05 m/s is less", fabs(0.5 - height(world, wood) - 0.7), 0.05 / sqrt(G / 0.7), "m");
	must(cn_shape_set_area(world, pool, NULL), world, "cn_shape_set_area");
	CHECK(fixture_is_awake(world, wood));
	fixture_step(world, 30);
	CHECK_GE("fall without water", 0.5 - height(world, wood) - 0.7, 1.0, "m");
	cn_world_destroy(world);
}

/* A plank on edge lies down; cork of a thousandth of the density and strong water are stable at any step. */
static void light_floats_are_stable(void)
{
	static const float dts[] = { 1.0f / 240.0f, 1.0f / 60.0f, 1.0f / 15.0f };
	double most = 0.0, deep = 0.0;
	for (int32_t k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(-(float)G, 0);
		cn_body foam = box_of_density(world, 0.0f, 0.5f, 0.5f, 0.1f, 1.0f), plank = box_of_density(world, 5.0f, 0.0f, 0.1f, 1.0f, 500.0f);
		water(world, 1000.0f, 1000.0f, 0.5f);
		must(cn_body_set_pose(world, plank, 5.0f, 0.0f, 0.05f), world, "cn_body_set_pose");
		for (int32_t i = 0; i < (int32_t)(20.0f / dts[k]); ++i) {
			steps(world, dts[k], 1);
			if ((float)i * dts[k] > 10.0f)
				most = greater(most, fabs(fall_speed(world, foam)));
			deep = greater(deep, -height(world, foam));
		}
		CHECK_LE("plank: sine of its angle to the vertical", fabs((double)fixture_pose(world, plank).cosine), 0.05, "");
		cn_world_destroy(world);
	}
	CHECK_LE("foam of a thousandth of the density: speed after 10 s", most, 0.05, "m/s");
	CHECK_LE("... depth of its middle", deep, 0.5, "m");
}

/* Buoyancy under a load is that of the displaced water, whatever the damping. */
static void a_raft_carries_a_load(void)
{
	cn_world *world = fixture_world(-(float)G, 0);
	cn_body raft = box_of_density(world, 0.0f, -0.1f, 2.0f, 0.5f, 200.0f), load = box_of_density(world, 0.0f, 0.9f, 0.5f, 0.5f, 1000.0f);
	water(world, 1000.0f, 2000.0f, 2.0f);
	fixture_step(world, 60 * 20);
	CHECK_LE("draught of a raft of 800 kg under 1000 kg, less 0.45 m", fabs(0.5 - height(world, raft) - 0.45), 2e-3, "m");
	CHECK_LE("the load stays on it", fabs(height(world, load) - height(world, raft) - 1.0), 2e-3, "m");
	cn_world_destroy(world);
}

/* ---- gravity ---- */

static double orbit_energy(const cn_world *world, cn_body body)
{
	cn_velocity v = fixture_velocity(world, body);
	cn_pose p = fixture_pose(world, body);
	return 0.5 * ((double)v.linear_mps.x * (double)v.linear_mps.x + (double)v.linear_mps.y * (double)v.linear_mps.y) - 10.0 * 100.0 / hypot((double)p.position_m.x, (double)p.position_m.y);
}

/* A body at distance x with speed v in the pull of a planet of 10 m with 10 m/s^2 on its surface. */
static cn_world *planet_with(float x, float v, cn_body *out_body)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape space = sensor_circle(world, 0.0f, 0.0f, 60.0f);
	cn_area_def def = area_def();
	*out_body = fixture_circle(world, CN_BODY_DYNAMIC, x, 0.0f, 0.5f, 0.5f, 0.0f);
	def.pull_mps2 = 10.0f;
	def.pull_distance_m = 10.0f;
	set_area(world, space, &def);
	fixture_set_velocity(world, *out_body, 0.0f, v, 0.0f);
	return world;
}

static void orbits_keep_their_energy(void)
{
	double energy, year = 2.0 * PI * 20.0 / sqrt(50.0), drift = 0.0;
	cn_body body;
	cn_world *world = planet_with(20.0f, (float)sqrt(50.0), &body);
	fixture_step(world, (int32_t)(10.0 * year * 60.0 + 0.5));
	CHECK_LE("circular orbit: distance from the start after ten years", hypot((double)fixture_pose(world, body).position_m.x - 20.0, (double)fixture_pose(world, body).position_m.y), 0.2, "m");
	cn_world_destroy(world);
	world = planet_with(40.0f, 3.5f, &body);
	energy = orbit_energy(world, body);
	for (int32_t k = 0; k < 160; ++k) {
		fixture_step(world, 100);
		drift = greater(drift, fabs(orbit_energy(world, body) / energy - 1.0));
	}
	CHECK_LE("long orbit: energy in ten years", drift, 0.002, "relative");
	cn_world_destroy(world);
}

/* Inside a homogeneous planet a body swings with w^2 = g / R. */
static void a_tunnel_through_a_planet(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape planet = sensor_circle(world, 3.0f, 4.0f, 30.0f);
	cn_body body = fixture_circle(world, CN_BODY_DYNAMIC, 13.0f, 4.0f, 0.2f, 0.5f, 0.0f);
	cn_area_def def = area_def();
	def.pull_mps2 = 5.0f;
	def.pull_distance_m = 20.0f;
	set_area(world, planet, &def);
	fixture_step(world, 1 + (int32_t)(2.0 * PI / sqrt(5.0 / 20.0) * 60.0 + 0.5)); /* the first step finds it */
	CHECK_LE("back at the start after 2 pi sqrt(R / g)", fabs((double)fixture_pose(world, body).position_m.x - 13.0), 0.02, "m");
	cn_world_destroy(world);
}

static void the_centre_decides(void)
{
	for (int32_t k = 0; k < 3; ++k) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_shape area = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, 1.0f);
		cn_body body = box_of_density(world, k == 0 ? 1.001f : k == 1 ? 0.999f : 1.0f, 0.0f, 0.5f, 0.5f, 1.0f);
		cn_area_def def = area_def();
		def.gravity_mps2.y = 3.0f;
		set_area(world, area, &def);
		fixture_step(world, 1);
		if (k == 0)
			CHECK(fixture_velocity(world, body).linear_mps.y == 0.0f);
		else
			CHECK_LE("a body whose centre is in, or on the border: 3 m/s^2", fabs((double)fixture_velocity(world, body).linear_mps.y * 60.0 - 3.0), ROUNDING, "m/s^2");
		cn_world_destroy(world);
	}
}

static double acceleration(int32_t low_flags, int32_t low_priority, int32_t high_flags, int32_t high_priority)
{
	cn_world *world = fixture_world(-(float)G, 0);
	cn_body body = box_of_density(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f);
	cn_shape first = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 3.0f, 3.0f), second = sensor_box(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 3.0f, 3.0f);
	cn_area_def def = area_def();
	double a;
	def.gravity_mps2.y = 1.0f;
	def.flags = (uint32_t)low_flags;
	def.priority = low_priority;
	set_area(world, first, &def);
	def.gravity_mps2.y = 2.0f;
	def.flags = (uint32_t)high_flags;
	def.priority = high_priority;
	set_area(world, second, &def);
	fixture_step(world, 1);
	a = (double)fixture_velocity(world, body).linear_mps.y * 60.0;
	cn_world_destroy(world);
	return a;
}

static void areas_add_or_replace(void)
{
	CHECK_LE("both add", fabs(acceleration(0, 0, 0, 0) + 7.0), 1e-5, "m/s^2");
	CHECK_LE("the later one replaces", fabs(acceleration(0, 0, CN_AREA_REPLACE, 0) - 2.0), 1e-5, "m/s^2");
	CHECK_LE("the first one replaces the world, the second adds", fabs(acceleration(CN_AREA_REPLACE, 0, 0, 0) - 3.0), 1e-5, "m/s^2");
	CHECK_LE("priority: the first one is last", fabs(acceleration(CN_AREA_REPLACE, 5, CN_AREA_REPLACE, -5) - 1.0), 1e-5, "m/s^2");
}

static void a_room_without_gravity(void)
{
	cn_world *world = fixture_world(-(float)G, 1);
	cn_shape room = sensor_box(world, CN_BODY_KINEMATIC, 0.0f, 0.0f, 5.0f, 5.0f);
	cn_body still = box_of_density(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f), moving = box_of_density(world, 0.0f, 2.0f, 0.5f, 0.5f, 1.0f), sensor;
	cn_area_def def = area_def();
	def.flags = CN_AREA_REPLACE;
	set_area(world, room, &def);
	fixture_set_velocity(world, moving, 1.0f, 0.0f, 2.0f);
	fixture_step(world, 60);
	CHECK(height(world, still) == 0.0 && !fixture_is_awake(world, still));
	CHECK_LE("uniform motion after 1 s", hypot((double)fixture_pose(world, moving).position_m.x - 1.0, height(world, moving) - 2.0), 1e-5, "m");
	/* The room moves away from the body that sleeps in it. */
	must(cn_shape_get_body(world, room, &sensor), world, "cn_shape_get_body");
	fixture_set_velocity(world, sensor, 20.0f, 0.0f, 0.0f);
	fixture_step(world, 60);
	CHECK(fixture_is_awake(world, still));
	CHECK_GE("fall after the room has left", -height(world, still), 1.0, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- waking ---- */

static cn_body sleeper_in(cn_world *world, cn_shape *out_area)
{
	cn_body body = box_of_density(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f);
	cn_area_def def = area_def();
	*out_area = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 5.0f, 5.0f);
	def.flags = CN_AREA_REPLACE;
	set_area(world, *out_area, &def);
	fixture_step(world, 60);
	CHECK(!fixture_is_awake(world, body));
	return body;
}

static void changes_wake_sleepers(void)
{
	for (int32_t k = 0; k < 6; ++k) {
		cn_world *world = fixture_world(-(float)G, 1);
		cn_shape area;
		cn_body body = sleeper_in(world, &area), sensor = 0;
		cn_area_def def = area_def();
		must(cn_shape_get_body(world, area, &sensor), world, "cn_shape_get_body");
		if (k == 0)
			set_area(world, area, &def);
		else if (k == 1)
			must(cn_body_destroy(world, sensor), world, "cn_body_destroy");
		else if (k == 2)
			must(cn_shape_destroy(world, area), world, "cn_shape_destroy");
		else if (k == 3)
			must(cn_shape_set_flags(world, area, 0), world, "cn_shape_set_flags");
		else if (k == 4)
			must(cn_body_set_flags(world, sensor, 0), world, "cn_body_set_flags");
		else
			must(cn_body_set_pose(world, sensor, 20.0f, 0.0f, 0.0f), world, "cn_body_set_pose");
		CHECK(fixture_is_awake(world, body));
		CHECK(fixture_is_valid(world));
		fixture_step(world, 30);
		CHECK(k == 3 || height(world, body) < -0.5); /* without the flag it is a solid box around the body */
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
	}
}

/* A kinematic wind tunnel comes over a box that sleeps on the ground. */
static void a_moving_area_wakes_what_it_meets(void)
{
	for (int32_t k = 0; k < 2; ++k) {
		cn_world *world = fixture_world(-(float)G, 1);
		cn_shape area = sensor_box(world, CN_BODY_KINEMATIC, -20.0f, 2.0f, 5.0f, 3.0f);
		cn_body box, sensor;
		cn_area_def def = area_def();
		fixture_floor(world, 0.3f, 0.0f);
		box = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 0.5f, 0.5f, 0.3f, 0.0f);
		def.gravity_mps2.x = 20.0f;
		set_area(world, area, &def);
		fixture_step(world, 90);
		REQUIRE(!fixture_is_awake(world, box));
		must(cn_shape_get_body(world, area, &sensor), world, "cn_shape_get_body");
		if (k == 0)
			fixture_set_velocity(world, sensor, 10.0f, 0.0f, 0.0f);
		else
			must(cn_body_set_pose(world, sensor, 0.0f, 2.0f, 0.0f), world, "cn_body_set_pose");
		fixture_step(world, 120);
		CHECK_GE("way of the box", (double)fixture_pose(world, box).position_m.x, 0.5, "m");
		cn_world_destroy(world);
	}
}

/* ---- state ---- */

/* Water, and a planet with air that rises; 80 bodies fall in. Without collisions the solver has no part in it. */
static cn_world *busy_world(int32_t workers, int32_t solver, int32_t broadphase, int32_t collide)
{
	cn_world_def wd;
	cn_world *world = NULL;
	cn_area_def def = area_def();
	cn_shape planet;
	cn_world_def_init(&wd);
	wd.worker_count = workers;
	wd.solver = solver;
	wd.broadphase = broadphase;
	must(cn_world_create(&wd, &world), NULL, "cn_world_create");
	if (collide)
		fixture_box(world, CN_BODY_STATIC, 0.0f, -6.0f, 0.0f, 30.0f, 1.0f, 0.6f, 0.0f);
	water(world, 1.5f, 1.0f, 0.2f);
	planet = sensor_circle(world, 15.0f, 15.0f, 12.0f);
	def.flags = CN_AREA_REPLACE;
	def.priority = 1;
	def.pull_mps2 = 8.0f;
	def.pull_distance_m = 3.0f;
	def.lift_kgpm2 = 0.2f;
	def.drag_kgpm2 = 0.1f;
	def.flow_mps.y = 2.0f;
	set_area(world, planet, &def);
	for (int32_t k = 0; k < 80; ++k) {
		float x = -10.0f + 1.5f * (float)(k % 16), y = 1.0f + 2.0f * (float)(k / 16);
		cn_filter filter = { 1, ~(uint64_t)0, -1, 0 };
		cn_body body = k % 3 == 0 ? fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.5f, 0.4f, 0.1f)
		                          : fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.3f * (float)k, 0.5f, 0.25f, 0.4f, 0.0f);
		if (!collide)
			must(cn_shape_set_filter(world, fixture_first_shape(world, body), &filter), world, "cn_shape_set_filter");
	}
	return world;
}

static uint64_t digest_of_steps(cn_world *world, int32_t count)
{
	uint64_t digest = 0;
	while (count-- > 0) {
		fixture_step(world, 1);
		digest = digest_world(digest, world);
	}
	return digest;
}

static void saves_and_files_hold_areas(void)
{
	cn_world *world = busy_world(1, CN_SOLVER_AUTO, SWEEP, 1), *read;
	saved save, file;
	uint64_t digest;
	fixture_step(world, 100);
	save = save_world(world);
	file = write_world(world);
	digest = digest_of_steps(world, 100);
	restore_world(world, &save);
	CHECK(digest_of_steps(world, 100) == digest);
	read = read_world(&file);
	CHECK(writes_the_same(read, &file));
	CHECK(digest_of_steps(read, 100) == digest);
	CHECK(fixture_is_valid(read));
	saved_free(&save);
	saved_free(&file);
	cn_world_destroy(read);
	cn_world_destroy(world);
}

static void areas_are_deterministic(void)
{
	static const int32_t solvers[] = { CN_SOLVER_AUTO, CN_SOLVER_SEQUENTIAL };
	for (int32_t k = 0; k < 2; ++k) {
		cn_world *world = busy_world(1, solvers[k], SWEEP, 1);
		uint64_t digest = digest_of_steps(world, 150);
		CHECK(fixture_is_valid(world));
		cn_world_destroy(world);
		world = busy_world(3, solvers[k], SWEEP, 1);
		CHECK(digest_of_steps(world, 150) == digest);
		cn_world_destroy(world);
		world = busy_world(1, solvers[k], TREE, 1);
		CHECK(digest_of_steps(world, 150) == digest);
		cn_world_destroy(world);
	}
}

/* Changes with integration and areas alone. */
#define GOLDEN_AREAS 0x8c429230fd135709u

static void areas_give_the_same_bits_everywhere(void)
{
	cn_world *world = busy_world(1, CN_SOLVER_AUTO, SWEEP, 0);
	uint64_t digest = digest_of_steps(world, 300);
	printf("  areas: %016llx\n", (unsigned long long)digest);
	CHECK(test_golden_holds(digest, GOLDEN_AREAS));
	cn_world_destroy(world);
}

static void areas_read_back(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_shape shape = sensor_box(world, CN_BODY_STATIC, 0.0f, 0.0f, 1.0f, 1.0f);
	cn_area_def def = area_def(), out;
	float *numbers = (float *)(void *)&def.gravity_mps2;
	def.flags = CN_AREA_REPLACE;
	def.priority = -7;
	for (int32_t k = 0; k < 13; ++k)
		numbers[k] = 1.0f + (float)k;
	CHECK(cn_shape_get_area(world, shape, &out) == CN_ERROR_STATE);
	set_area(world, shape, &def);
	must(cn_shape_get_area(world, shape, &out), world, "cn_shape_get_area");
	CHECK(memcmp(&def, &out, sizeof def) == 0);
	must(cn_shape_set_area(world, shape, NULL), world, "cn_shape_set_area");
	CHECK(cn_shape_get_area(world, shape, &out) == CN_ERROR_STATE);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(terminal_speeds_are_exact);
	RUN(wind_slows_exactly);
	RUN(wind_wakes_if_asked);
	RUN(a_wind_tunnel_carries);
	RUN(a_box_floats_with_its_period);
	RUN(boxes_find_their_draught);
	RUN(floats_sleep);
	RUN(light_floats_are_stable);
	RUN(a_raft_carries_a_load);
	RUN(orbits_keep_their_energy);
	RUN(a_tunnel_through_a_planet);
	RUN(the_centre_decides);
	RUN(areas_add_or_replace);
	RUN(a_room_without_gravity);
	RUN(changes_wake_sleepers);
	RUN(a_moving_area_wakes_what_it_meets);
	RUN(saves_and_files_hold_areas);
	RUN(areas_are_deterministic);
	RUN(areas_give_the_same_bits_everywhere);
	RUN(areas_read_back);
	return test_end();
}
