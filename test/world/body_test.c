/*
 * test/world/body_test.c - what a body is: damping, forces, mass, pose, names, lists, handles. Types and locks are in
 * body_state_test.c.
 *
 * If a test here fails, look first in: world/body*.c (the calls), model/body.c (mass, records),
 * step/integrate.c (drives, damping).
 */
#include "bodies.h"

/* ---- damping, gravity ---- */

static void damping_follows_its_law(void)
{
	static const float rates[] = { 0.1f, 0.5f, 2.0f };
	size_t r;
	for (r = 0; r < 3; ++r) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body body = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f), falling = box_at(world, CN_BODY_DYNAMIC, 50.0f, 0.0f);
		double c = (double)rates[r], kept = exp(-2.0 * c), way = 8.0 * (1.0 - kept) / c, terminal;
		must(cn_body_set_damping(world, body, rates[r], 0.5f * rates[r]), world, "damping");
		fixture_set_velocity(world, body, 8.0f, 0.0f, 1.0f);
		must(cn_world_set_gravity(world, 0.0f, -10.0f), world, "gravity");
		must(cn_body_set_gravity_scale(world, body, 0.0f), world, "scale");
		must(cn_body_set_damping(world, falling, rates[r], 0.0f), world, "damping");
		fixture_step(world, 120);
		printf("  damping %.1f /s\n", c);
		CHECK_LE("error of v = v0 e^(-c t) / v0", fabs((double)fixture_velocity(world, body).linear_mps.x / 8.0 - kept), 0.005, "");
		CHECK_LE("error of the way / way", fabs((double)fixture_pose(world, body).position_m.x / way - 1.0), 0.01, "");
		CHECK_LE("error of w = w0 e^(-c t / 2)", fabs((double)fixture_velocity(world, body).angular_radps - exp(-c)), 0.005, "");
		terminal = 10.0 / c * (1.0 - kept);
		CHECK_LE("error of the fall's speed, relative", fabs(-(double)fixture_velocity(world, falling).linear_mps.y / terminal - 1.0), 0.005, "");
		cn_world_destroy(world);
	}
}

static void gravity_scale_scales(void)
{
	static const float scales[] = { 0.0f, 0.5f, 1.0f, -1.0f, 3.0f };
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[5];
	size_t k;
	float read;
	for (k = 0; k < 5; ++k) {
		bodies[k] = box_at(world, CN_BODY_DYNAMIC, 3.0f * (float)k, 0.0f);
		must(cn_body_set_gravity_scale(world, bodies[k], scales[k]), world, "scale");
		must(cn_body_get_gravity_scale(world, bodies[k], &read), world, "scale");
		CHECK(read == scales[k]);
	}
	fixture_step(world, 60);
	for (k = 0; k < 5; ++k)
		CHECK_LE("error of the fall in 1 s", fabs((double)fixture_pose(world, bodies[k]).position_m.y + 5.0 * (double)scales[k]), ROUNDING, "m");
	cn_world_destroy(world);
}

/* ---- forces and impulses ---- */

/* A bar of 2 kg with its centre of mass away from its origin, turned. */
static cn_body bar_make(cn_world *world, double *mass, double *inertia)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 1.0f, 2.0f, 0.5f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	def.offset_m.x = 0.7f;
	def.offset_m.y = -0.2f;
	def.density_kgpm2 = 2.5f;
	fixture_box_shape(world, &def, 1.0f, 0.2f);
	*mass = 2.5 * 2.0 * 0.4;
	*inertia = *mass * (4.0 + 0.16) / 12.0;
	return body;
}

static void forces_follow_newton(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	double mass, inertia, lever, cx, cy;
	cn_body body = bar_make(world, &mass, &inertia);
	cn_vec2 c = center_of(world, body);
	cn_velocity v, after;
	int32_t k;
	cx = 1.0 + 0.7 * cos(0.5) + 0.2 * sin(0.5);
	cy = 2.0 + 0.7 * sin(0.5) - 0.2 * cos(0.5);
	CHECK_LE("error of the centre of mass", hypot((double)c.x - cx, (double)c.y - cy), 1e-6, "m");
	CHECK_LE("error of the mass", fabs((double)mass_of(world, body).mass_kg - mass), 1e-6, "kg");
	CHECK_LE("error of the inertia", fabs((double)mass_of(world, body).inertia_kgm2 - inertia), 1e-6, "kg m^2");
	for (k = 0; k < 60; ++k) { /* 1 s of (3, -1) N at the centre and 0.5 N m: x = a t^2 / 2 */
		must(cn_body_apply_force(world, body, 2.0f, -1.0f), world, "force");
		must(cn_body_apply_force(world, body, 1.0f, 0.0f), world, "force");
		must(cn_body_apply_torque(world, body, 0.2f), world, "torque");
		must(cn_body_apply_torque(world, body, 0.3f), world, "torque");
		fixture_step(world, 1);
	}
	v = fixture_velocity(world, body);
	CHECK_LE("error of the speed by a force", hypot((double)v.linear_mps.x - 3.0 / mass, (double)v.linear_mps.y + 1.0 / mass), 1e-5, "m/s");
	CHECK_LE("error of the spin by a torque", fabs((double)v.angular_radps - 0.5 / inertia), 1e-5, "rad/s");
	CHECK_LE("error of the way by a force", hypot((double)center_of(world, body).x - cx - 1.5 / mass, (double)center_of(world, body).y - cy + 0.5 / mass), 1e-5, "m");
	fixture_step(world, 1); /* forces last one step */
	after = fixture_velocity(world, body);
	CHECK(memcmp(&v, &after, sizeof v) == 0);
	fixture_set_velocity(world, body, 0.0f, 0.0f, 0.0f);
	c = center_of(world, body);
	must(cn_body_apply_force_at(world, body, 0.0f, 6.0f, c.x + 0.5f, c.y + 3.0f), world, "force at");
	fixture_step(world, 1);
	v = fixture_velocity(world, body);
	lever = 0.5 * 6.0 / 60.0;
	CHECK_LE("error of the speed by a force at a point", fabs((double)v.linear_mps.y - 6.0 / 60.0 / mass), 1e-6, "m/s");
	CHECK_LE("error of the spin by it", fabs((double)v.angular_radps - lever / inertia), 1e-6, "rad/s");
	cn_world_destroy(world);
}

static void impulses_act_at_once(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	double mass, inertia;
	cn_body body = bar_make(world, &mass, &inertia);
	cn_vec2 c = center_of(world, body), at;
	cn_velocity v;
	must(cn_body_apply_impulse(world, body, 1.0f, 2.0f), world, "impulse");
	must(cn_body_apply_angular_impulse(world, body, 0.3f), world, "angular impulse");
	must(cn_body_apply_impulse_at(world, body, -0.5f, 0.25f, c.x - 0.4f, c.y + 0.1f), world, "impulse at");
	v = fixture_velocity(world, body);
	CHECK_LE("error of the speed", hypot((double)v.linear_mps.x - 0.5 / mass, (double)v.linear_mps.y - 2.25 / mass), 1e-6, "m/s");
	CHECK_LE("error of the spin", fabs((double)v.angular_radps - (0.3 + (-0.4 * 0.25 - 0.1 * -0.5)) / inertia), 1e-6, "rad/s");
	must(cn_body_get_velocity_at(world, body, c.x + 2.0f, c.y - 1.0f, &at), world, "velocity at");
	CHECK_LE("error of the velocity at a point",
	         hypot((double)at.x - ((double)v.linear_mps.x + (double)v.angular_radps), (double)at.y - ((double)v.linear_mps.y + 2.0 * (double)v.angular_radps)), 1e-5, "m/s");
	CHECK(cn_body_apply_impulse(world, body, 3e38f, 0.0f) == CN_OK && cn_body_apply_impulse(world, body, 3e38f, 0.0f) == CN_OK);
	CHECK(cn_body_apply_impulse(world, body, 3e38f, 0.0f) == CN_ERROR_ARGUMENT);
	cn_world_destroy(world);
}

/* ---- mass ---- */

static void mass_may_be_overridden_and_reset(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	double mass, inertia;
	cn_body body = bar_make(world, &mass, &inertia);
	cn_mass_data own = mass_of(world, body), set = { 5.0f, 2.0f, { -0.3f, 0.4f } }, read, still = { 4.0f, 0.0f, { 0.0f, 0.0f } };
	cn_pose before = fixture_pose(world, body), after;
	cn_vec2 at_before, at_after;
	cn_shape_def def;
	fixture_set_velocity(world, body, 1.0f, 2.0f, 3.0f);
	must(cn_body_get_velocity_at(world, body, 0.0f, 0.0f, &at_before), world, "velocity at");
	must(cn_body_set_mass_data(world, body, &set), world, "mass");
	must(cn_body_get_velocity_at(world, body, 0.0f, 0.0f, &at_after), world, "velocity at");
	read = mass_of(world, body);
	CHECK(memcmp(&read, &set, sizeof set) == 0);
	after = fixture_pose(world, body);
	CHECK_LE("change of the origin", hypot((double)(after.position_m.x - before.position_m.x), (double)(after.position_m.y - before.position_m.y)), 1e-6, "m");
	CHECK_LE("change of the material's velocity", hypot((double)(at_after.x - at_before.x), (double)(at_after.y - at_before.y)), 1e-5, "m/s");
	def = fixture_shape_def(body, 0.6f, 0.0f);
	fixture_box_shape(world, &def, 1.0f, 1.0f); /* the override stays */
	read = mass_of(world, body);
	CHECK(memcmp(&read, &set, sizeof set) == 0);
	fixture_set_velocity(world, body, 0.0f, 0.0f, 0.0f);
	must(cn_body_apply_impulse(world, body, 5.0f, 0.0f), world, "impulse");
	CHECK(fabsf(fixture_velocity(world, body).linear_mps.x - 1.0f) < 1e-6f);
	must(cn_body_set_mass_data(world, body, &still), world, "mass"); /* inertia 0: it never turns */
	fixture_set_velocity(world, body, 0.0f, 0.0f, 0.0f);
	must(cn_body_apply_impulse_at(world, body, 1.0f, 1.0f, 9.0f, 0.0f), world, "impulse at");
	fixture_step(world, 10);
	CHECK(fixture_velocity(world, body).angular_radps == 0.0f);
	must(cn_body_reset_mass_data(world, body), world, "reset");
	read = mass_of(world, body);
	CHECK_LE("error of the mass after reset", fabs((double)read.mass_kg - mass - 4.0), 1e-5, "kg");
	CHECK(read.mass_kg != own.mass_kg);
	must(cn_body_set_mass_data(world, body, &set), world, "mass"); /* a change of type forgets it */
	must(cn_body_set_type(world, body, CN_BODY_KINEMATIC), world, "type");
	CHECK(cn_body_set_mass_data(world, body, &set) == CN_ERROR_STATE);
	must(cn_body_set_type(world, body, CN_BODY_DYNAMIC), world, "type");
	CHECK_LE("error of the mass after changes of type", fabs((double)mass_of(world, body).mass_kg - mass - 4.0), 1e-5, "kg");
	cn_world_destroy(world);
}

/* Two boxes of 1 kg at 2 m to either side, one of 2 kg 3 m above: about the centre of all, by Steiner. */
static void shapes_add_their_masses(void)
{
	static const float x[3] = { -2.0f, 2.0f, 0.0f }, y[3] = { 0.0f, 0.0f, 3.0f }, density[3] = { 1.0f, 1.0f, 2.0f };
	cn_world *world = fixture_world(0.0f, 0);
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 5.0f, -1.0f, 0.0f);
	cn_mass_data mass;
	int32_t k;
	for (k = 0; k < 3; ++k) {
		cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
		def.offset_m.x = x[k];
		def.offset_m.y = y[k];
		def.density_kgpm2 = density[k];
		fixture_box_shape(world, &def, 0.5f, 0.5f);
	}
	mass = mass_of(world, body);
	CHECK_LE("error of the mass", fabs((double)mass.mass_kg - 4.0), 1e-6, "kg");
	CHECK_LE("error of the centre", hypot((double)mass.center_m.x, (double)mass.center_m.y - 1.5), 1e-6, "m");
	CHECK_LE("error of the inertia", fabs((double)mass.inertia_kgm2 - (4.0 / 6.0 + 2.0 * (4.0 + 2.25) + 2.0 * 2.25)), 1e-5, "kg m^2");
	cn_world_destroy(world);
}

/* Spinning freely, the centre of mass stays and the origin circles it. */
static void a_body_spins_about_its_centre_of_mass(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	double mass, inertia, worst = 0.0, radius = hypot(0.7, 0.2);
	cn_body body = bar_make(world, &mass, &inertia);
	cn_vec2 start = center_of(world, body);
	int32_t k;
	fixture_set_velocity(world, body, 0.0f, 0.0f, 6.0f);
	for (k = 0; k < 300; ++k) {
		cn_vec2 c, local;
		cn_pose p;
		fixture_step(world, 1);
		c = center_of(world, body);
		p = fixture_pose(world, body);
		worst = greater(worst, hypot((double)(c.x - start.x), (double)(c.y - start.y)));
		worst = greater(worst, fabs(hypot((double)(p.position_m.x - c.x), (double)(p.position_m.y - c.y)) - radius));
		must(cn_body_get_local_point(world, body, c.x, c.y, &local), world, "local point");
		worst = greater(worst, hypot((double)local.x - 0.7, (double)local.y + 0.2));
	}
	CHECK_LE("wandering of the centre and of the origin's distance", worst, 1e-5, "m");
	cn_world_destroy(world);
}

static void a_body_without_mass_weighs_a_kilogram(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bare = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f), light = fixture_body(world, CN_BODY_DYNAMIC, 5.0f, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(light, 0.6f, 0.0f);
	def.density_kgpm2 = 0.0f;
	fixture_box_shape(world, &def, 0.5f, 0.5f);
	CHECK(mass_of(world, bare).mass_kg == 1.0f && mass_of(world, light).mass_kg == 1.0f && mass_of(world, bare).inertia_kgm2 == 0.0f);
	fixture_step(world, 60);
	CHECK_LE("error of its fall in 1 s", fabs((double)fixture_pose(world, bare).position_m.y + 5.0), ROUNDING, "m");
	cn_world_destroy(world);
}

/* ---- pose ---- */

static void teleport_keeps_velocity_and_finds_its_place(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	double mass, inertia;
	cn_body body = bar_make(world, &mass, &inertia), wall;
	cn_pose pose;
	cn_vec2 p, q;
	cn_aabb box;
	float angle;
	fixture_set_velocity(world, body, 1.0f, 2.0f, 3.0f);
	must(cn_body_set_pose(world, body, -30.0f, 40.0f, 2.5f), world, "pose");
	pose = fixture_pose(world, body);
	must(cn_body_get_angle(world, body, &angle), world, "angle");
	CHECK(fabsf(pose.position_m.x + 30.0f) < 1e-5f && fabsf(pose.position_m.y - 40.0f) < 1e-5f && fabsf(angle - 2.5f) < 1e-6f);
	CHECK(fixture_velocity(world, body).linear_mps.x == 1.0f && fixture_velocity(world, body).angular_radps == 3.0f);
	must(cn_body_get_world_point(world, body, 0.3f, -2.0f, &p), world, "world point");
	must(cn_body_get_local_point(world, body, p.x, p.y, &q), world, "local point");
	CHECK_LE("error of a point there and back", hypot((double)q.x - 0.3, (double)q.y + 2.0), 1e-5, "m");
	CHECK_LE("error of a world point", hypot((double)p.x - (-30.0 + 0.3 * cos(2.5) + 2.0 * sin(2.5)), (double)p.y - (40.0 + 0.3 * sin(2.5) - 2.0 * cos(2.5))), 1e-5, "m");
	must(cn_body_get_aabb(world, body, &box), world, "aabb");
	CHECK_LE("error of the box's middle", hypot((double)(0.5f * (box.lower_m.x + box.upper_m.x) - center_of(world, body).x), (double)(0.5f * (box.lower_m.y + box.upper_m.y) - center_of(world, body).y)), 1e-5, "m");
	wall = box_at(world, CN_BODY_STATIC, 100.0f, 0.0f);
	fixture_set_velocity(world, body, 0.0f, 0.0f, 0.0f);
	must(cn_body_set_pose(world, body, 99.0f, 0.0f, 0.0f), world, "pose"); /* into a wall: it is pushed out */
	fixture_step(world, 120);
	CHECK(fixture_penetration(world, &wall, 1) < 0.006f);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* A contact ends with the teleport, also when the body is put to sleep before the next step. */
static void teleport_ends_contacts_at_once(void)
{
	cn_world *world = fixture_world(0.0f, 1);
	cn_body body = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f);
	cn_contact_event contact;
	int32_t count = 0;
	box_at(world, CN_BODY_STATIC, 0.0f, -0.999f);
	fixture_step(world, 1);
	must(cn_body_get_contacts(world, body, &contact, 1, &count), world, "cn_body_get_contacts");
	CHECK(count == 1);
	must(cn_body_set_pose(world, body, 0.0f, 50.0f, 0.0f), world, "pose");
	must(cn_body_get_contacts(world, body, &contact, 1, &count), world, "cn_body_get_contacts");
	CHECK(count == 0);
	must(cn_body_set_awake(world, body, 0), world, "cn_body_set_awake");
	fixture_step(world, 1);
	CHECK(fixture_counters(world).contacts == 0 && fixture_counters(world).contacts_touching == 0);
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- names, data, lists ---- */

static void names_and_data_are_kept(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	char longest[CN_NAME_MAX_BYTES + 2];
	cn_body bodies[64];
	const char *name;
	uint64_t data;
	int32_t k, wrong = 0;
	for (k = 0; k < 64; ++k) {
		memset(longest, 'a' + k % 26, sizeof longest);
		longest[k] = '\0';
		bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f);
		must(cn_body_set_name(world, bodies[k], longest), world, "name");
		must(cn_body_set_user_data(world, bodies[k], ~(uint64_t)k), world, "data");
	}
	for (k = 63; k >= 0; --k) {
		must(cn_body_get_name(world, bodies[k], &name), world, "name");
		must(cn_body_get_user_data(world, bodies[k], &data), world, "data");
		wrong += (int32_t)strlen(name) != k || (k > 0 && name[k - 1] != 'a' + k % 26) || data != ~(uint64_t)k;
	}
	CHECK(wrong == 0);
	memset(longest, 'x', sizeof longest);
	longest[CN_NAME_MAX_BYTES + 1] = '\0';
	CHECK(cn_body_set_name(world, bodies[5], longest) == CN_ERROR_ARGUMENT);
	must(cn_body_get_name(world, bodies[5], &name), world, "name");
	CHECK(strcmp(name, "fffff") == 0);
	must(cn_body_set_name(world, bodies[5], NULL), world, "name");
	must(cn_body_get_name(world, bodies[5], &name), world, "name");
	CHECK(name[0] == '\0');
	cn_world_destroy(world);
}

static void bodies_can_be_gone_through(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[50], list[60];
	int32_t k, count, found = 0;
	for (k = 0; k < 50; ++k)
		bodies[k] = fixture_body(world, k % 3, (float)k, 0.0f, 0.0f);
	for (k = 0; k < 50; k += 2)
		must(cn_body_destroy(world, bodies[k]), world, "destroy");
	must(cn_world_get_bodies(world, NULL, 0, &count), world, "count");
	CHECK(count == 25);
	must(cn_world_get_bodies(world, list, 60, &count), world, "list");
	for (k = 0; k < count; ++k)
		found += list[k] == bodies[2 * k + 1];
	CHECK(count == 25 && found == 25);
	list[10] = 12345;
	must(cn_world_get_bodies(world, list, 10, &count), world, "list");
	CHECK(count == 25 && list[9] == bodies[19] && list[10] == 12345);
	cn_world_destroy(world);
}

typedef struct sprite {
	uint32_t texture;
	cn_pose pose;
	uint32_t layer;
} sprite;

static void bulk_reads_are_single_reads(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body bodies[30], picked[7];
	cn_pose poses[30];
	cn_velocity velocities[30];
	sprite sprites[30];
	int32_t k, wrong = 0;
	for (k = 0; k < 30; ++k) {
		bodies[k] = box_at(world, k % 3, 3.0f * (float)k, 0.0f);
		sprites[k].texture = sprites[k].layer = 77;
		if (k % 3 != CN_BODY_STATIC)
			fixture_set_velocity(world, bodies[k], (float)k, 0.0f, -(float)k);
	}
	fixture_step(world, 10);
	must(cn_world_read_poses(world, NULL, 30, poses), world, "poses");
	must(cn_world_read_velocities(world, NULL, 30, velocities), world, "velocities");
	must(cn_world_read_poses_strided(world, bodies, 30, &sprites[0].pose, (int32_t)sizeof(sprite)), world, "strided");
	for (k = 0; k < 30; ++k) {
		cn_pose p = fixture_pose(world, bodies[k]);
		cn_velocity v = fixture_velocity(world, bodies[k]);
		wrong += memcmp(&p, &poses[k], sizeof p) != 0 || memcmp(&v, &velocities[k], sizeof v) != 0;
		wrong += memcmp(&p, &sprites[k].pose, sizeof p) != 0 || sprites[k].texture != 77 || sprites[k].layer != 77;
	}
	for (k = 0; k < 7; ++k)
		picked[k] = bodies[29 - 4 * k];
	must(cn_world_read_poses_strided(world, picked, 7, poses, 0), world, "packed");
	for (k = 0; k < 7; ++k) {
		cn_pose p = fixture_pose(world, picked[k]);
		wrong += memcmp(&p, &poses[k], sizeof p) != 0;
	}
	CHECK(wrong == 0);
	CHECK(cn_world_read_poses(world, NULL, 29, poses) == CN_ERROR_ARGUMENT);
	for (k = 0; k < 30; ++k) {
		velocities[k].linear_mps.x = velocities[k].linear_mps.y = k % 3 == CN_BODY_STATIC ? 0.0f : 2.0f;
		velocities[k].angular_radps = 0.0f;
	}
	must(cn_world_write_velocities(world, bodies, 30, velocities), world, "write");
	for (k = 0; k < 30; ++k)
		wrong += fixture_velocity(world, bodies[k]).linear_mps.y != (k % 3 == CN_BODY_STATIC ? 0.0f : 2.0f);
	velocities[1].linear_mps.x = 9.0f;
	velocities[27].linear_mps.x = 1.0f; /* static */
	CHECK(cn_world_write_velocities(world, bodies, 30, velocities) == CN_ERROR_STATE);
	CHECK(wrong == 0 && fixture_velocity(world, bodies[1]).linear_mps.x == 2.0f);
	cn_world_destroy(world);
}

/* ---- many at once ---- */

static void many_are_made_or_none(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body_def defs[100];
	cn_body bodies[100], list[3];
	int32_t k;
	uint64_t hash;
	cn_vec2 place;
	for (k = 0; k < 100; ++k) {
		cn_body_def_init(&defs[k]);
		defs[k].type = k % 3;
		defs[k].position_m.x = (float)k;
		defs[k].name = k % 2 ? "odd" : NULL;
		bodies[k] = 0;
	}
	defs[99].position_m.y = (float)NAN;
	hash = fixture_hash(world);
	CHECK(cn_body_create_many(world, defs, 100, bodies) == CN_ERROR_ARGUMENT);
	CHECK(fixture_counters(world).bodies == 0 && bodies[0] == 0 && fixture_hash(world) == hash && fixture_is_valid(world));
	defs[99].position_m.y = 0.0f;
	must(cn_body_create_many(world, defs, 100, bodies), world, "many");
	CHECK(fixture_counters(world).bodies == 100 && fixture_counters(world).bodies_awake == 66);
	must(cn_body_get_center(world, bodies[63], &place), world, "center");
	CHECK(place.x == 63.0f);
	list[0] = bodies[4];
	list[1] = bodies[5];
	list[2] = bodies[4];
	CHECK(cn_body_destroy_many(world, list, 3) == CN_ERROR_ARGUMENT);
	list[2] = 0x00F00001u;
	CHECK(cn_body_destroy_many(world, list, 3) == CN_ERROR_HANDLE);
	CHECK(fixture_counters(world).bodies == 100 && cn_body_is_valid(world, bodies[4]) && fixture_is_valid(world));
	must(cn_body_destroy_many(world, bodies + 10, 90), world, "destroy many");
	CHECK(fixture_counters(world).bodies == 10 && !cn_body_is_valid(world, bodies[10]) && cn_body_is_valid(world, bodies[9]));
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- handles ---- */

#define CYCLES 2500
static void dead_handles_stay_dead(void)
{
	static cn_body dead[CYCLES];
	cn_world *world = fixture_world(0.0f, 0);
	cn_body keep = box_at(world, CN_BODY_DYNAMIC, 0.0f, 0.0f);
	cn_pose pose;
	int32_t k, alive = 0, accepted = 0, refused_wrong = 0;
	for (k = 0; k < CYCLES; ++k) {
		dead[k] = box_at(world, CN_BODY_DYNAMIC, 5.0f, 0.0f);
		if (k % 16 == 0)
			fixture_step(world, 1);
		must(cn_body_destroy(world, dead[k]), world, "destroy");
	}
	for (k = 0; k < CYCLES; ++k) {
		alive += cn_body_is_valid(world, dead[k]);
		accepted += cn_body_get_pose(world, dead[k], &pose) != CN_ERROR_HANDLE;
		refused_wrong += cn_body_destroy(world, dead[k]) != CN_ERROR_HANDLE || cn_shape_destroy(world, dead[k]) != CN_ERROR_HANDLE || cn_joint_destroy(world, dead[k]) != CN_ERROR_HANDLE;
		alive += k > 0 && dead[k] == dead[k - 1];
	}
	CHECK_LE("dead handles that seem alive", alive + accepted + refused_wrong, 0, "");
	CHECK(cn_body_is_valid(world, keep) && fixture_counters(world).bodies == 1 && fixture_counters(world).shapes == 1 && fixture_is_valid(world));
	cn_world_destroy(world);
}

/* A kinematic body is taken from pose to pose, through the angle of pi, with its mass off its origin; what lies on it comes along. */
static void kinematic_bodies_reach_their_targets(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body lift = fixture_body(world, CN_BODY_KINEMATIC, 100.0f, 0.0f, 0.0f), box;
	cn_shape_def sd = fixture_shape_def(lift, 1.0f, 0.0f);
	double worst = 0.0, slip = 0.0;
	int32_t k;
	sd.offset_m.x = 1.0f;
	fixture_box_shape(world, &sd, 2.0f, 0.25f);
	for (k = 1; k <= 400; ++k) {
		float x = 100.0f + sinf(0.02f * (float)k), y = 0.5f * sinf(0.05f * (float)k), angle = 0.03f * (float)k;
		cn_pose pose;
		must(cn_body_set_target_pose(world, lift, x, y, angle, FRAME_S), world, "set_target_pose");
		fixture_step(world, 1);
		pose = fixture_pose(world, lift);
		worst = greater(worst, hypot((double)(pose.position_m.x - x), (double)(pose.position_m.y - y)));
		worst = greater(worst, fabs((double)pose.cosine - cos((double)angle)) + fabs((double)pose.sine - sin((double)angle)));
	}
	CHECK_LE("off its targets", worst, 3e-5, "m");
	must(cn_body_set_target_pose(world, lift, 100.0f, 0.0f, 0.0f, FRAME_S), world, "set_target_pose");
	fixture_step(world, 1);
	fixture_set_velocity(world, lift, 0.0f, 0.0f, 0.0f);
	box = fixture_box(world, CN_BODY_DYNAMIC, 101.0f, 0.75f, 0.0f, 0.5f, 0.5f, 1.0f, 0.0f);
	fixture_step(world, 30);
	for (k = 1; k <= 200; ++k) {
		must(cn_body_set_target_pose(world, lift, 100.0f + 0.0002f * (float)(k * k), 0.0f, 0.0f, FRAME_S), world, "set_target_pose");
		fixture_step(world, 1);
		slip = greater(slip, fabs((double)(fixture_pose(world, box).position_m.x - fixture_pose(world, lift).position_m.x) - 1.0));
	}
	/* The box follows each jump of 0.024 m/s within the first substep, and lags by as much as half of it. */
	CHECK_LE("slip of a box on it", slip, 200 * 0.024 * (double)FRAME_S / 4.0 / 2.0 + SOLVED, "m");
	cn_world_destroy(world);
}

/* ---- shapes added one by one: model/body_shapes.c ---- */

/* Mass of 300 boxes as sums in double precision. */
typedef struct compound {
	double kg, x, y, about_origin;
} compound;

static void compound_add(compound *sum, cn_world *world, cn_body body, int32_t k)
{
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
	float hx = 0.1f + 0.01f * (float)(k % 13), hy = 0.1f + 0.02f * (float)(k % 7);
	double kg = 4.0 * (double)hx * (double)hy;
	def.offset_m.x = 0.3f * (float)(k % 20);
	def.offset_m.y = 0.4f * (float)(k / 20);
	def.density_kgpm2 = 1.0f;
	fixture_box_shape(world, &def, hx, hy);
	sum->kg += kg;
	sum->x += kg * (double)def.offset_m.x;
	sum->y += kg * (double)def.offset_m.y;
	sum->about_origin += kg * ((double)(hx * hx + hy * hy) / 3.0 + (double)(def.offset_m.x * def.offset_m.x + def.offset_m.y * def.offset_m.y));
}

static double mass_error(const compound *sum, const cn_mass_data *m)
{
	double x = sum->x / sum->kg, y = sum->y / sum->kg, inertia = sum->about_origin - sum->kg * (x * x + y * y);
	double center = hypot((double)m->center_m.x - x, (double)m->center_m.y - y);
	return fmax(fabs((double)m->mass_kg / sum->kg - 1.0), fmax(fabs((double)m->inertia_kgm2 / inertia - 1.0), center));
}

/* Two bodies get their shapes in turn, so that both are updated and not computed until the step. */
static void shapes_added_one_by_one_add_up(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[2];
	compound sums[2];
	cn_mass_data m, again;
	int32_t k, side;
	memset(sums, 0, sizeof sums);
	for (k = 0; k < 2; ++k)
		bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, 50.0f * (float)k, 0.0f, 0.3f);
	for (k = 0; k < 600; ++k)
		compound_add(&sums[k % 2], world, bodies[k % 2], k / 2);
	CHECK(fixture_is_valid(world));
	for (side = 0; side < 2; ++side) {
		must(cn_body_get_mass_data(world, bodies[side], &m), world, "mass");
		CHECK_LE("error of mass, centre and inertia when all are added", mass_error(&sums[side], &m), 1e-4, "");
		CHECK_LE("displacement of the origin", hypot((double)fixture_pose(world, bodies[side]).position_m.x - 50.0 * side, (double)fixture_pose(world, bodies[side]).position_m.y), 1e-4, "m");
	}
	fixture_step(world, 1);
	for (side = 0; side < 2; ++side) {
		must(cn_body_get_mass_data(world, bodies[side], &m), world, "mass");
		must(cn_body_reset_mass_data(world, bodies[side]), world, "reset");
		must(cn_body_get_mass_data(world, bodies[side], &again), world, "mass");
		CHECK_LE("after a step", mass_error(&sums[side], &m), ROUNDING, "");
		CHECK(memcmp(&m, &again, sizeof m) == 0);
	}
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* More bodies in turn than the world remembers to compute at the step (CNI_ESTIMATED_MOST). */
static void many_compounds_add_up(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	static cn_body bodies[40];
	static compound sums[40];
	double worst = 0.0;
	int32_t k, body;
	memset(sums, 0, sizeof sums);
	for (body = 0; body < 40; ++body)
		bodies[body] = fixture_body(world, CN_BODY_DYNAMIC, 50.0f * (float)body, 0.0f, 0.3f);
	for (k = 0; k < 24; ++k)
		for (body = 0; body < 40; ++body)
			compound_add(&sums[body], world, bodies[body], k + body);
	fixture_step(world, 1);
	for (body = 0; body < 40; ++body) {
		cn_mass_data m;
		must(cn_body_get_mass_data(world, bodies[body], &m), world, "mass");
		worst = greater(worst, mass_error(&sums[body], &m));
	}
	CHECK_LE("error of mass, centre and inertia of 40 bodies", worst, ROUNDING, "");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* ---- the readback: model/world.h ---- */

#define READ_BODIES 70

/* Two equal worlds: one is read in every step, so that it keeps a readback, the other only at the end, from its records. */
static void read_changes(cn_world *world, cn_body *bodies, int32_t step)
{
	cn_body *b = bodies + 7 * step % READ_BODIES;
	must(cn_body_set_pose(world, bodies[step], 3.0f * (float)step, 9.0f, 0.5f), world, "cn_body_set_pose");
	must(cn_body_set_user_data(world, bodies[step + 1], 1000u + (uint64_t)step), world, "cn_body_set_user_data");
	must(cn_body_destroy(world, *b), world, "cn_body_destroy");
	*b = fixture_box(world, CN_BODY_DYNAMIC, -3.0f * (float)step, 5.0f, 0.3f, 0.2f + 0.01f * (float)step, 0.5f, 0.5f, 0.0f);
	if (step == 20)
		must(cn_body_set_awake(world, bodies[2], 0), world, "cn_body_set_awake");
}

static void readback_is_the_records(void)
{
	static cn_body bodies[2][READ_BODIES + 1];
	static cn_pose poses[2][READ_BODIES + 1];
	const cn_body_moved *moved[2];
	cn_world *world[2];
	int32_t count[2], w, k, step;
	for (w = 0; w < 2; ++w) {
		world[w] = fixture_world(-10.0f, 1);
		fixture_floor(world[w], 0.5f, 0.0f);
		for (k = 0; k < READ_BODIES + 1; ++k)
			bodies[w][k] = fixture_box(world[w], CN_BODY_DYNAMIC, 2.0f * (float)k - 70.0f, 3.0f, 0.1f, 0.5f, 0.5f, 0.5f, 0.0f);
		for (step = 0; step < 60; ++step) {
			if (w == 0)
				must(cn_world_read_poses(world[w], bodies[w], READ_BODIES + 1, poses[w]), world[w], "cn_world_read_poses");
			read_changes(world[w], bodies[w], step);
			fixture_step(world[w], 1);
			if (w == 0)
				must(cn_world_moved(world[w], &moved[w], &count[w]), world[w], "cn_world_moved");
			CHECK(fixture_is_valid(world[w]));
		}
		must(cn_world_moved(world[w], &moved[w], &count[w]), world[w], "cn_world_moved");
		must(cn_world_read_poses(world[w], bodies[w], READ_BODIES + 1, poses[w]), world[w], "cn_world_read_poses");
	}
	CHECK(count[0] == count[1]);
	CHECK(count[0] > 20 && memcmp(moved[0], moved[1], (size_t)count[0] * sizeof *moved[0]) == 0);
	CHECK(memcmp(poses[0], poses[1], sizeof poses[0]) == 0);
	fixture_step(world[0], 200); /* unread for so long that it is kept no more */
	fixture_step(world[1], 200);
	must(cn_world_read_poses(world[0], bodies[0], READ_BODIES + 1, poses[0]), world[0], "cn_world_read_poses");
	must(cn_world_read_poses(world[1], bodies[1], READ_BODIES + 1, poses[1]), world[1], "cn_world_read_poses");
	CHECK(memcmp(poses[0], poses[1], sizeof poses[0]) == 0);
	cn_world_destroy(world[0]);
	cn_world_destroy(world[1]);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(damping_follows_its_law);
	RUN(gravity_scale_scales);
	RUN(forces_follow_newton);
	RUN(impulses_act_at_once);
	RUN(mass_may_be_overridden_and_reset);
	RUN(shapes_add_their_masses);
	RUN(a_body_spins_about_its_centre_of_mass);
	RUN(a_body_without_mass_weighs_a_kilogram);
	RUN(teleport_keeps_velocity_and_finds_its_place);
	RUN(teleport_ends_contacts_at_once);
	RUN(names_and_data_are_kept);
	RUN(bodies_can_be_gone_through);
	RUN(bulk_reads_are_single_reads);
	RUN(shapes_added_one_by_one_add_up);
	RUN(many_compounds_add_up);
	RUN(readback_is_the_records);
	RUN(many_are_made_or_none);
	RUN(dead_handles_stay_dead);
	RUN(kinematic_bodies_reach_their_targets);
	return test_end();
}
