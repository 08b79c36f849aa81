/*
 * calls_test - promises: what a setter stores its getter returns; the list of moved bodies is right; contact
 * events are bookended whatever calls come between the steps; and random calls, with an allocator that
 * fails now and then, keep every invariant and change nothing when they fail.
 */
#include "calls.h"

/* What a random life has made. */
static cn_body bodies[32];
static cn_shape shapes[64];
static cn_joint joints[32];

/* ------------------------------------------------------------------ reading back */

static void read_back_body(void)
{
	cn_pose pose;
	cn_velocity velocity;
	cn_mass_data got;
	cn_vec2 point, local;
	const char *name = NULL;
	float a = 0.0f, b = 0.0f;
	uint32_t flags = 0;
	uint64_t user = 0;
	CHECK(cn_body_set_mass_data(W, f.box, (reset(), &mass)) == CN_OK);
	CHECK(cn_body_get_mass_data(W, f.box, &got) == CN_OK && memcmp(&got, &mass, sizeof got) == 0);
	CHECK(cn_body_set_pose(W, f.box, 7.0f, 3.0f, 0.75f) == CN_OK);
	CHECK(cn_body_get_pose(W, f.box, &pose) == CN_OK);
	CHECK_LE("pose error x", (pose.position_m.x - 7.0f) * (pose.position_m.x - 7.0f), 1e-12, "m2");
	CHECK_LE("pose error y", (pose.position_m.y - 3.0f) * (pose.position_m.y - 3.0f), 1e-12, "m2");
	CHECK(cn_body_get_angle(W, f.box, &a) == CN_OK);
	CHECK_LE("angle error", (a - 0.75f) * (a - 0.75f), 1e-12, "rad2");
	CHECK(cn_body_get_world_point(W, f.box, 0.3f, -0.4f, &point) == CN_OK);
	CHECK(cn_body_get_local_point(W, f.box, point.x, point.y, &local) == CN_OK);
	CHECK_LE("local point error", (local.x - 0.3f) * (local.x - 0.3f) + (local.y + 0.4f) * (local.y + 0.4f), 1e-12, "m2");
	CHECK(cn_body_set_velocity(W, f.box, 1.0f, 2.0f, 3.0f) == CN_OK);
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK);
	CHECK(velocity.linear_mps.x == 1.0f && velocity.linear_mps.y == 2.0f && velocity.angular_radps == 3.0f);
	CHECK(cn_body_apply_impulse(W, f.box, 2.0f, 0.0f) == CN_OK && cn_body_apply_angular_impulse(W, f.box, 1.0f) == CN_OK);
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK);
	CHECK(velocity.linear_mps.x == 2.0f && velocity.angular_radps == 5.0f); /* 2 kg, 0.5 kg m^2 */
	CHECK(cn_body_set_damping(W, f.box, 0.25f, 0.5f) == CN_OK && cn_body_get_damping(W, f.box, &a, &b) == CN_OK && a == 0.25f && b == 0.5f);
	CHECK(cn_body_set_gravity_scale(W, f.box, 0.5f) == CN_OK && cn_body_get_gravity_scale(W, f.box, &a) == CN_OK && a == 0.5f);
	CHECK(cn_body_set_user_data(W, f.box, 1234567890123u) == CN_OK && cn_body_get_user_data(W, f.box, &user) == CN_OK && user == 1234567890123u);
	CHECK(cn_body_set_name(W, f.box, "crate") == CN_OK && cn_body_get_name(W, f.box, &name) == CN_OK && strcmp(name, "crate") == 0);
	CHECK(cn_body_set_name(W, f.box, NULL) == CN_OK && cn_body_get_name(W, f.box, &name) == CN_OK && strcmp(name, "") == 0);
	CHECK(cn_body_set_flags(W, f.box, CN_BODY_LOCK_X | CN_BODY_ENABLED) == CN_OK && cn_body_get_flags(W, f.box, &flags) == CN_OK);
	CHECK(flags == (CN_BODY_LOCK_X | CN_BODY_ENABLED | CN_BODY_AWAKE));
	CHECK(cn_body_get_velocity(W, f.box, &velocity) == CN_OK && velocity.linear_mps.x == 0.0f && velocity.linear_mps.y == 2.0f);
	CHECK(cn_body_reset_mass_data(W, f.box) == CN_OK && cn_body_get_mass_data(W, f.box, &got) == CN_OK);
	CHECK_LE("mass of a unit square", (got.mass_kg - 1.0f) * (got.mass_kg - 1.0f), 1e-12, "kg2");
	CHECK_LE("its inertia", (got.inertia_kgm2 - 1.0f / 6.0f) * (got.inertia_kgm2 - 1.0f / 6.0f), 1e-12, "");
}

static void read_back_shape(void)
{
	cn_material m;
	cn_filter g;
	cn_circle c;
	cn_polygon p;
	cn_vec2 points[8];
	cn_mass_data d;
	float density = 0.0f;
	uint32_t mask = 0;
	int32_t count = 0, inside = 0;
	cn_body body = 1;
	reset();
	CHECK(cn_shape_set_material(W, f.box_shape, &material) == CN_OK && cn_shape_get_material(W, f.box_shape, &m) == CN_OK && memcmp(&m, &material, sizeof m) == 0);
	CHECK(cn_shape_set_filter(W, f.box_shape, &filter) == CN_OK && cn_shape_get_filter(W, f.box_shape, &g) == CN_OK && memcmp(&g, &filter, sizeof g) == 0);
	CHECK(cn_shape_set_density(W, f.box_shape, 3.0f) == CN_OK && cn_shape_get_density(W, f.box_shape, &density) == CN_OK && density == 3.0f);
	CHECK(cn_body_get_mass_data(W, f.box, &d) == CN_OK);
	CHECK_LE("mass after a change of density", (d.mass_kg - 3.0f) * (d.mass_kg - 3.0f), 1e-11, "kg2");
	CHECK(cn_shape_set_event_mask(W, f.box_shape, 5) == CN_OK && cn_shape_get_event_mask(W, f.box_shape, &mask) == CN_OK && mask == 5);
	CHECK(cn_shape_get_circle(W, f.ball_shape, &c) == CN_OK && memcmp(&c, &circle, sizeof c) == 0);
	CHECK(cn_shape_get_polygon(W, f.box_shape, &p) == CN_OK && memcmp(&p, &polygon, sizeof p) == 0);
	CHECK(cn_shape_get_chain_points(W, f.chain, points, 8, &count) == CN_OK && count == 4 && memcmp(points, chain_points, sizeof chain_points) == 0);
	CHECK(cn_shape_get_body(W, f.loose, &body) == CN_OK && body == 0);
	CHECK(cn_shape_attach(W, f.loose, f.pill) == CN_OK && cn_shape_get_body(W, f.loose, &body) == CN_OK && body == f.pill);
	CHECK(cn_body_get_shapes(W, f.pill, NULL, 0, &count) == CN_OK && count == 2);
	CHECK(cn_body_set_pose(W, f.box, 50.0f, 60.0f, 0.0f) == CN_OK);
	CHECK(cn_shape_test_point(W, f.box_shape, 50.4f, 60.4f, &inside) == CN_OK && inside == 1);
	CHECK(cn_shape_test_point(W, f.box_shape, 50.6f, 60.4f, &inside) == CN_OK && inside == 0);
}

static void read_back_joint(void)
{
	cn_revolute_def r;
	cn_distance_def d;
	cn_body a = 1, b = 1;
	reset();
	rd.base.flags = CN_JOINT_LIMIT | CN_JOINT_MOTOR;
	rd.lower_angle_rad = -1.0f;
	rd.upper_angle_rad = 2.0f;
	rd.motor_speed_radps = 3.0f;
	rd.motor_torque_max_Nm = 4.0f;
	rd.spring_hertz = 5.0f;
	rd.spring_damping_ratio = 0.5f;
	rd.spring_target_rad = 0.25f;
	rd.base.user_data = 99;
	CHECK(cn_joint_set_revolute(W, f.pin, &rd) == CN_OK && cn_joint_get_revolute(W, f.pin, &r) == CN_OK);
	CHECK(r.base.body_a == f.ball && r.base.body_b == f.pill && r.base.anchor_a_m.x == 1.0f);
	rd.base = r.base;
	CHECK(memcmp(&r, &rd, sizeof r) == 0);
	CHECK(r.base.flags == (CN_JOINT_LIMIT | CN_JOINT_MOTOR) && r.base.user_data == 99);
	CHECK(cn_joint_set_motor(W, f.pin, -1.0f, 7.0f) == CN_OK && cn_joint_set_limits(W, f.pin, -0.5f, 0.5f) == CN_OK);
	CHECK(cn_joint_get_revolute(W, f.pin, &r) == CN_OK && r.motor_speed_radps == -1.0f && r.motor_torque_max_Nm == 7.0f);
	CHECK(r.lower_angle_rad == -0.5f && r.upper_angle_rad == 0.5f);
	CHECK(cn_joint_get_distance(W, f.rope, &d) == CN_OK && d.length_m == 2.0f && d.length_max_m == 1.0f);
	CHECK(cn_joint_get_bodies(W, f.rope, &a, &b) == CN_OK && a == 0 && b == f.ball);
}

static void read_back_solvers(void)
{
	float accuracy = 0.0f;
	int32_t solver, got = -1, budget = -1;
	for (solver = CN_SOLVER_SEQUENTIAL; solver >= CN_SOLVER_AUTO; --solver)
		CHECK(cn_world_set_solver(W, solver) == CN_OK && cn_world_get_solver(W, &got) == CN_OK && got == solver);
	CHECK(cn_world_set_accuracy(W, 0.25f, 1234) == CN_OK && cn_world_get_accuracy(W, &accuracy, &budget) == CN_OK && accuracy == 0.25f && budget == 1234);
	CHECK(cn_world_set_accuracy(W, CN_DEFAULT, CN_DEFAULT) == CN_OK && cn_world_get_accuracy(W, &accuracy, &budget) == CN_OK && accuracy == 0.005f && budget == CN_DEFAULT);
	for (solver = CN_SOLVER_DIRECT; solver >= CN_SOLVER_AUTO; --solver) {
		CHECK(cn_body_set_solver(W, f.box, solver) == CN_OK && cn_body_get_solver(W, f.box, &got) == CN_OK && got == solver);
		CHECK(cn_joint_set_solver(W, f.pin, solver) == CN_OK && cn_joint_get_solver(W, f.pin, &got) == CN_OK && got == solver);
	}
}

static void t_what_is_set_is_read_back(void)
{
	fixture_make(0);
	read_back_body();
	read_back_shape();
	read_back_joint();
	read_back_solvers();
	check_valid("setters");
	fixture_free();
}

/* A bulk read of all bodies, the bodies moved and the poses one by one tell the same. */
static void t_moved_lists_what_moved(void)
{
	const cn_body_moved *moved = NULL;
	const cn_body *asleep = NULL;
	cn_pose now[5], one;
	cn_body list[5];
	int32_t count = 0, k, steps_taken, fell = 0;
	fixture_make(0);
	CHECK(cn_body_set_velocity(W, f.rail, 1.0f, 0.0f, 0.0f) == CN_OK);
	CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	CHECK_GE("moved", count, 3, ""); /* rail, ball, capsule */
	for (k = 0; k < count; ++k) {
		CHECK(cn_body_get_pose(W, moved[k].body, &one) == CN_OK && memcmp(&one, &moved[k].pose, sizeof one) == 0);
		CHECK(moved[k].body != f.ground);
	}
	CHECK(cn_world_get_bodies(W, list, 5, &count) == CN_OK && count == 5);
	CHECK(cn_world_read_poses(W, NULL, 5, now) == CN_OK);
	for (k = 0; k < 5; ++k)
		CHECK(cn_body_get_pose(W, list[k], &one) == CN_OK && memcmp(&one, &now[k], sizeof one) == 0);
	CHECK(cn_body_destroy(W, f.rail) == CN_OK);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	for (k = 0; k < count; ++k)
		CHECK(moved[k].body != f.rail);
	for (steps_taken = 0; steps_taken < 600 && fell == 0; ++steps_taken) {
		CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
		CHECK(cn_world_fell_asleep(W, &asleep, &fell) == CN_OK);
	}
	CHECK_LE("steps until something fell asleep", steps_taken, 120, "");
	REQUIRE(fell > 0);
	CHECK(cn_world_moved(W, &moved, &count) == CN_OK);
	CHECK(count >= fell && moved[0].body == asleep[0] && moved[0].fell_asleep == 1);
	fixture_free();
}

/* A teleport ends contacts at once: putting the body to sleep before the next step must not keep them. */
static void t_teleport_ends_contacts(void)
{
	const cn_contact_event *events = NULL;
	int32_t count = -1, k, seen = 0;
	fixture_make(0);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count > 0);
	CHECK(cn_body_set_pose(W, f.box, 0.0f, 30.0f, 0.0f) == CN_OK);
	CHECK(cn_body_set_awake(W, f.box, 0) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == 0);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_world_contact_events(W, CN_EVENT_LEAVE, &events, &count) == CN_OK);
	for (k = 0; k < count; ++k)
		seen += events[k].shape_a == f.box_shape || events[k].shape_b == f.box_shape;
	CHECK_GE("leave events of the box", seen, 1, "");
	check_valid("teleport");
	fixture_free();
}

/* A filter that forbids ends contacts at once; one that allows again brings them back in the next step. */
static void t_filters_end_and_allow_contacts(void)
{
	int32_t count = -1, first = 0;
	cn_filter old;
	fixture_make(0);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &first) == CN_OK && first > 0);
	CHECK(cn_shape_get_filter(W, f.box_shape, &old) == CN_OK);
	filter.mask = 0;
	CHECK(cn_shape_set_filter(W, f.box_shape, &filter) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == 0);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == 0);
	CHECK(cn_shape_set_filter(W, f.box_shape, &old) == CN_OK);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == first);
	check_valid("filters");
	fixture_free();
}

/* A type or a flag takes a body out and puts it back: contacts, island and joints follow. */
static void t_types_and_flags_take_out_and_put_back(void)
{
	int32_t count = -1, first = 0;
	cn_counters c;
	fixture_make(0);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &first) == CN_OK && first > 0);
	CHECK(cn_body_set_flags(W, f.box, 0) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == 0);
	CHECK(cn_body_set_flags(W, f.box, CN_BODY_ENABLED | CN_BODY_SLEEP) == CN_OK);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == first);
	CHECK(cn_body_set_type(W, f.box, CN_BODY_STATIC) == CN_OK);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == 0);
	CHECK(cn_body_set_type(W, f.box, CN_BODY_DYNAMIC) == CN_OK);
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	CHECK(cn_body_get_contacts(W, f.box, NULL, 0, &count) == CN_OK && count == first);
	CHECK(cn_body_set_flags(W, f.ball, 0) == CN_OK);
	CHECK(cn_world_get_counters(W, &c) == CN_OK && c.joints == 2 && c.joints_awake == 0);
	CHECK(cn_body_set_flags(W, f.ball, CN_BODY_ENABLED) == CN_OK);
	CHECK(cn_world_get_counters(W, &c) == CN_OK && c.joints == 2 && c.joints_awake == 2);
	check_valid("types and flags");
	fixture_free();
}

/* ------------------------------------------------------------------ many boxes at once */

#define LONG_CHAIN TEST_FORM(3000, 1500, 1500)
static cn_vec2 long_points[LONG_CHAIN];

static cn_result make_long_chain(cn_body body)
{
	int k;
	for (k = 0; k < LONG_CHAIN; ++k)
		long_points[k] = v2(1500.0f - (float)k, (float)(k & 1));
	reset();
	sd.body = body;
	chain.points_m = long_points;
	chain.count = LONG_CHAIN;
	return cn_shape_create_chain(W, &sd, &chain, &shapes[0]);
}

static cn_result create_long_chain(void) { return make_long_chain(f.ground); }
static cn_result create_long_loose(void) { return make_long_chain(0); }
static cn_result attach_long_chain(void) { return cn_shape_attach(W, shapes[0], f.rail); }
static cn_result enable_ground(void) { return cn_body_set_flags(W, f.ground, CN_BODY_ENABLED); }
static cn_result disable_ground(void)
{
	cn_result result = create_long_chain();
	return result == CN_OK ? cn_body_set_flags(W, f.ground, 0) : result;
}

/* A call with each of its allocations failing in turn, after a preparation. Returns how many it made. */
static int fail_each_allocation(cn_result (*prepare)(void), cn_result (*call)(void), const char *what)
{
	int allow;
	for (allow = 0; allow < 1000; ++allow) {
		state s, after;
		cn_result result;
		fixture_make(1);
		CHECK(prepare == NULL || prepare() == CN_OK);
		s = state_of(W);
		alloc_allow = allow;
		result = call();
		alloc_allow = -1;
		after = state_of(W);
		if (result != CN_OK && (result != CN_ERROR_MEMORY || state_differs(&s, &after))) {
			printf("  %s with allocation %d failing gives %d\n", what, allow, (int)result);
			test_fail(__FILE__, __LINE__, "a call without memory must fail and change nothing");
		}
		CHECK(result == CN_OK || call() == CN_OK);
		CHECK(cn_world_step(W, 1.0f / 60.0f) == CN_OK);
		check_valid(what);
		fixture_free();
		if (result == CN_OK)
			break;
	}
	return allow;
}

static void t_long_chains_without_memory_change_nothing(void)
{
	CHECK_GE("allocations of creating", fail_each_allocation(NULL, create_long_chain, "create"), 10, "");
	CHECK_GE("allocations of attaching", fail_each_allocation(create_long_loose, attach_long_chain, "attach"), 1, "");
	fail_each_allocation(disable_ground, enable_ground, "enable");
	CHECK_LE("bytes leaked", alloc_live, 0, "B");
}

/* ------------------------------------------------------------------ bookends */

/* The pairs that the events of all steps so far say are there. */
typedef struct known_pair {
	cn_shape a, b;
	int32_t child_a, child_b;
	uint32_t id;
	int touching;
} known_pair;
static known_pair known[4096];
static int known_count, bookend_errors, bookend_events;

static int known_find(const cn_contact_event *e)
{
	int k;
	for (k = 0; k < known_count; ++k)
		if (known[k].a == e->shape_a && known[k].b == e->shape_b && known[k].child_a == e->child_a && known[k].child_b == e->child_b)
			break;
	return k;
}

static void known_take(const cn_contact_event *e, int32_t kind)
{
	int k = known_find(e), there = k < known_count, good;
	known_pair *p = &known[k];
	++bookend_events;
	if (kind == CN_EVENT_CREATED) {
		good = !there && known_count < 4096;
		if (good) {
			++known_count;
			p->a = e->shape_a;
			p->b = e->shape_b;
			p->child_a = e->child_a;
			p->child_b = e->child_b;
			p->id = e->contact_id;
			p->touching = 0;
		}
	} else {
		good = there && p->id == e->contact_id && p->touching == (kind == CN_EVENT_LEAVE);
		if (good && kind == CN_EVENT_DESTROYED)
			*p = known[--known_count];
		else if (good)
			p->touching = kind == CN_EVENT_ENTER;
	}
	bookend_errors += !good;
}

/* After a step: its events must lead from the pairs known before to the pairs there are now. */
static void bookends_check(void)
{
	static const int32_t order[] = { CN_EVENT_LEAVE, CN_EVENT_DESTROYED, CN_EVENT_CREATED, CN_EVENT_ENTER };
	const cn_contact_event *events;
	cn_counters c;
	int32_t count, i, touching = 0;
	size_t k;
	for (k = 0; k < 4; ++k) {
		CHECK(cn_world_contact_events(W, order[k], &events, &count) == CN_OK);
		for (i = 0; i < count; ++i)
			known_take(&events[i], order[k]);
	}
	for (i = 0; i < known_count; ++i)
		touching += known[i].touching;
	CHECK(cn_world_get_counters(W, &c) == CN_OK);
	bookend_errors += c.contacts != known_count || c.contacts_touching != touching;
}

/* ------------------------------------------------------------------ random lives */

#define LIVES TEST_MANY(12)

static int events_all; /* every shape reports everything, and keeps doing so */

static cn_result steps(int count)
{
	cn_result result = CN_OK;
	while (count-- > 0 && result == CN_OK) {
		result = cn_world_step(W, 1.0f / 60.0f);
		if (events_all)
			bookends_check();
	}
	return result;
}

/* The fixture's shapes report only some events until here: ask for all, and let their pairs begin anew. */
static void events_begin(void)
{
	cn_shape list[16];
	int32_t count = 0, k;
	CHECK(cn_world_get_shapes(W, list, 16, &count) == CN_OK);
	for (k = 0; k < count; ++k) {
		cn_body body = 0;
		CHECK(cn_shape_set_event_mask(W, list[k], (1u << CN_EVENT_KINDS) - 1u) == CN_OK);
		CHECK(cn_shape_get_body(W, list[k], &body) == CN_OK);
		if (body == 0)
			continue;
		CHECK(cn_shape_detach(W, list[k]) == CN_OK);
		CHECK(cn_shape_attach(W, list[k], body) == CN_OK);
	}
	CHECK(cn_world_step(W, 0.0f) == CN_OK);
	known_count = 0;
	{
		const cn_contact_event *events;
		CHECK(cn_world_contact_events(W, CN_EVENT_CREATED, &events, &count) == CN_OK);
		for (k = 0; k < count; ++k)
			known_take(&events[k], CN_EVENT_CREATED);
		CHECK(cn_world_contact_events(W, CN_EVENT_ENTER, &events, &count) == CN_OK);
		for (k = 0; k < count; ++k)
			known_take(&events[k], CN_EVENT_ENTER);
	}
}

static cn_result random_create(uint32_t r, uint32_t *state_)
{
	int slot = (int)(r >> 8 & 31u);
	reset();
	if (events_all)
		sd.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	switch (r >> 4 & 3u) {
	case 0:
		bd.position_m = v2((float)(r >> 16 & 7u), (float)(r >> 20 & 3u));
		bd.type = r >> 24 & 7u ? CN_BODY_DYNAMIC : (int32_t)(r >> 27 & 1u);
		bd.flags = CN_BODY_ENABLED | CN_BODY_SLEEP | (r >> 28 & 1u ? (uint32_t)CN_BODY_AWAKE : 0u);
		return cn_body_is_valid(W, bodies[slot]) ? CN_OK : cn_body_create(W, &bd, &bodies[slot]);
	case 1:
		sd.body = cn_body_is_valid(W, bodies[slot]) && (r >> 16 & 7u) ? bodies[slot] : 0;
		if (cn_shape_is_valid(W, shapes[r >> 20 & 63u]))
			return cn_shape_destroy(W, shapes[r >> 20 & 63u]);
		if (r >> 30 & 1u)
			return cn_shape_create_circle(W, &sd, &circle, &shapes[r >> 20 & 63u]);
		if (r >> 29 & 1u)
			return cn_shape_create_polygon(W, &sd, &polygon, &shapes[r >> 20 & 63u]);
		return cn_shape_create_chain(W, &sd, &chain, &shapes[r >> 20 & 63u]);
	case 2:
		rd.base.body_a = bodies[slot];
		rd.base.body_b = bodies[random_next(state_) & 31u];
		rd.base.flags = r >> 29 & 1u ? (uint32_t)CN_JOINT_COLLIDE : 0u;
		if (cn_joint_is_valid(W, joints[r >> 20 & 31u]))
			return cn_joint_destroy(W, joints[r >> 20 & 31u]);
		return cn_joint_create_revolute(W, &rd, &joints[r >> 20 & 31u]);
	default:
		return cn_shape_attach(W, shapes[r >> 20 & 63u], bodies[slot]);
	}
}

/* Of the world, now and then, of a joint or of a body. */
static cn_result random_solver(cn_body body, cn_joint joint, uint32_t more)
{
	switch (more & 7u) {
	case 0: return cn_world_set_solver(W, (int32_t)(more >> 3 & 3u));
	case 1: return cn_world_set_accuracy(W, (more >> 3 & 7u) == 0 ? (float)CN_DEFAULT : 0.001f * (float)(more >> 3 & 7u), (more >> 6 & 1023u) == 0 ? CN_DEFAULT : (int32_t)(more >> 6 & 1023u));
	case 2: case 3: return cn_joint_set_solver(W, joint, (int32_t)(more >> 3 & 3u));
	default: return cn_body_set_solver(W, body, (int32_t)(more >> 3 & 3u));
	}
}

static cn_result random_change(uint32_t r, uint32_t *state_)
{
	cn_body body = bodies[r >> 8 & 31u];
	cn_shape shape = shapes[r >> 20 & 63u];
	cn_joint joint = joints[r >> 20 & 31u];
	uint32_t more = random_next(state_);
	reset();
	filter.mask = more & 3u;
	switch (r >> 4 & 15u) {
	case 0: return more & 3u ? cn_shape_attach(W, shape, body) : cn_body_destroy(W, body);
	case 1: return cn_body_set_type(W, body, more & 1u ? CN_BODY_DYNAMIC : (int32_t)(more >> 1 & 1u));
	case 2: return steps(1);
	case 3: case 4: return cn_body_set_flags(W, body, (more & 7u ? (uint32_t)CN_BODY_ENABLED : 0u) | (more >> 4 & (CN_BODY_LOCK_X | CN_BODY_LOCK_ROTATION | CN_BODY_SLEEP)));
	case 5: return cn_body_set_awake(W, body, (int32_t)(more & 1u));
	case 6: return cn_body_set_pose(W, body, (float)(more & 7u), (float)(more >> 4 & 3u), (float)(more >> 8 & 3u));
	case 7: return cn_shape_detach(W, shape);
	case 8: return cn_shape_set_filter(W, shape, &filter);
	case 9: return cn_shape_set_material(W, shape, &material);
	case 10: return events_all ? CN_OK : cn_shape_set_event_mask(W, shape, more & 31u);
	case 11: return cn_joint_set_flags(W, joint, more & 15u);
	case 12: return cn_body_set_mass_data(W, body, &mass);
	case 13: return cn_shape_set_density(W, shape, (float)(more & 3u));
	case 14: return more >> 28 ? cn_world_set_gravity(W, 0.0f, -8.0f - (float)(more & 3u)) : cn_body_destroy_many(W, three(body, bodies[more & 31u], bodies[more >> 8 & 31u]), 3);
	default: return more & 2u ? random_solver(body, joint, more >> 2) : cn_body_set_name(W, body, more & 1u ? "a name of some length, longer than sixteen" : "short");
	}
}

typedef struct tally {
	int done, refused, without_memory;
	int touching_most, joints_most, islands_most, asleep_most;
} tally;

static int larger(int a, int b) { return a > b ? a : b; }

static void tally_add(tally *t, cn_result result)
{
	cn_counters c;
	CHECK(cn_world_get_counters(W, &c) == CN_OK);
	t->done += result == CN_OK;
	t->without_memory += result == CN_ERROR_MEMORY;
	t->refused += result != CN_OK && result != CN_ERROR_MEMORY;
	t->touching_most = larger(t->touching_most, c.contacts_touching);
	t->joints_most = larger(t->joints_most, c.joints);
	t->islands_most = larger(t->islands_most, c.islands);
	t->asleep_most = larger(t->asleep_most, c.contacts - c.contacts_awake);
}

/* A random life of a world whose allocator may fail now and then. */
static void random_life(uint32_t seed, int operations, uint32_t fail_mask, tally *t)
{
	uint32_t random_state = seed;
	int k;
	memset(bodies, 0, sizeof bodies);
	memset(shapes, 0, sizeof shapes);
	memset(joints, 0, sizeof joints);
	fixture_make(1);
	if (events_all)
		events_begin();
	for (k = 0; k < operations && !test_this_failed; ++k) {
		uint32_t r = random_next(&random_state), kind = r & 15u;
		state s = state_of(W), after;
		cn_result result;
		alloc_random = r;
		alloc_fail_mask = r >> 31 ? fail_mask : 0u;
		result = kind < 2 ? steps(1 + (int)(r >> 4 & 15u)) : kind < 9 ? random_create(r, &random_state) : random_change(r, &random_state);
		alloc_fail_mask = 0;
		if (result != CN_OK) {
			after = state_of(W);
			if (state_differs(&s, &after)) {
				printf("  operation %d (%08x): %s\n", k, r, cn_world_error_text(W));
				test_fail(__FILE__, __LINE__, "a failed call changed the world");
			}
		}
		tally_add(t, result);
		check_valid("a random call");
		if (test_this_failed)
			printf("  seed %u operation %d (%08x) result %d\n", seed, k, r, (int)result);
	}
	fixture_free();
}

static void t_events_are_bookended(void)
{
	uint32_t seed;
	tally t;
	memset(&t, 0, sizeof t);
	events_all = 1;
	bookend_errors = bookend_events = 0;
	for (seed = 1; seed <= LIVES && !test_this_failed; ++seed)
		random_life(seed * 40503u + 1u, 1200, 0u, &t);
	events_all = 0;
	CHECK_GE("events seen", bookend_events, 100 * LIVES, "");
	CHECK_LE("events out of place, or pairs that they do not account for", bookend_errors, 0, "");
}

static void t_random_calls_keep_the_world_valid(void)
{
	uint32_t seed;
	tally t;
	memset(&t, 0, sizeof t);
	for (seed = 1; seed <= LIVES && !test_this_failed; ++seed)
		random_life(seed * 2654435761u, 1200, 1u, &t);
	CHECK_GE("calls that succeeded", t.done, 400 * LIVES, "");
	CHECK_GE("calls refused for their arguments", t.refused, 100 * LIVES, "");
	CHECK_GE("calls that ran out of memory", t.without_memory, 10 * LIVES, "");
	CHECK_GE("most touching contacts", t.touching_most, 20, "");
	CHECK_GE("most contacts asleep", t.asleep_most, 10, "");
	CHECK_GE("most joints", t.joints_most, 10, "");
	CHECK_GE("most islands", t.islands_most, 10, "");
	CHECK_LE("bytes leaked", alloc_live, 0, "B");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_what_is_set_is_read_back);
	RUN(t_moved_lists_what_moved);
	RUN(t_teleport_ends_contacts);
	RUN(t_filters_end_and_allow_contacts);
	RUN(t_types_and_flags_take_out_and_put_back);
	RUN(t_long_chains_without_memory_change_nothing);
	RUN(t_events_are_bookended);
	RUN(t_random_calls_keep_the_world_valid);
	return test_end();
}
