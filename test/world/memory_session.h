/*
 * test/world/memory_session.h - one scripted life of a world under memory hooks that can be told to fail: about
 * 70 bodies of every kind of shape, joints, names, every kind of change, explosions, sleep, all events read in
 * every step, and everything destroyed at the end.
 *
 * Every call goes through TRY. A call that fails must say CN_ERROR_MEMORY, leave the state hash and the counters
 * as they were and the world valid, and succeed when it is repeated with memory back. Events are entered
 * in a ledger by contact; see session_read_events.
 */
#ifndef CAIRN_TEST_MEMORY_SESSION_H
#define CAIRN_TEST_MEMORY_SESSION_H

#include "model/world.h"
#include "fixture.h"

#define SESSION_BODIES 96
#define SESSION_CONTACTS 8192
#define SESSION_STEPS 120
#define SESSION_CHECKED_STEPS 10 /* steps after recovery until the script is cut short */

typedef struct session_hooks {
	int64_t calls;
	int64_t fail_first, fail_last; /* calls that fail, counted from 1; 0: none */
	int64_t failed;
	int64_t pieces, bytes;
	int64_t wrong;                 /* frees with another size, or another alignment asked */
} session_hooks;

typedef struct session {
	session_hooks hooks;
	cn_world *world;
	int32_t calls;            /* through TRY */
	int32_t failing_call;     /* number of the call in which the first failure is due, 0: not known */
	int32_t failing_steps;    /* how long the hooks go on failing after the first failure, 0: only that one fails */
	int32_t failed_step;      /* first step or call with a failure, -1: none yet */
	int32_t recovered_step;   /* memory came back before this step, -1: not yet */
	int32_t step;
	uint64_t hash_before;
	cn_counters counters_before;
	const char *problem;      /* first broken promise */
	int32_t problem_step;
	int64_t problem_value;
	int32_t refused;          /* calls that said CN_ERROR_MEMORY */
	int32_t warned;           /* steps with a warning */

	cn_body bodies[SESSION_BODIES];
	cn_shape shapes[SESSION_BODIES];
	int32_t body_count;
	cn_body ground;
	cn_shape chain, spare_shape;
	cn_joint joints[8];
	int8_t created[SESSION_CONTACTS], entered[SESSION_CONTACTS]; /* by contact id */
	int32_t sensed;
	int32_t asleep_most;
	int32_t called;           /* ENTER callbacks in this step */
	int32_t unlocked;         /* callbacks in which a change was not refused */
	int64_t events;
} session;

/* ---- hooks ---- */

static inline void *session_alloc(uint64_t bytes, uint32_t align, void *user)
{
	session_hooks *h = (session_hooks *)user;
	uint8_t *raw, *aligned;
	++h->calls;
	h->wrong += align != 64;
	if (h->fail_first != 0 && h->calls >= h->fail_first && h->calls <= h->fail_last) {
		++h->failed;
		return NULL;
	}
	raw = (uint8_t *)malloc((size_t)bytes + 192);
	if (raw == NULL)
		abort();
	aligned = raw + 128 - (uintptr_t)raw % 64;
	memcpy(aligned - 16, &raw, sizeof raw);
	memcpy(aligned - 8, &bytes, 8);
	memset(aligned, 0xA5, (size_t)bytes);
	++h->pieces;
	h->bytes += (int64_t)bytes;
	return aligned;
}

static inline void session_free(void *memory, uint64_t bytes, void *user)
{
	session_hooks *h = (session_hooks *)user;
	uint8_t *raw;
	uint64_t asked;
	memcpy(&raw, (uint8_t *)memory - 16, sizeof raw);
	memcpy(&asked, (uint8_t *)memory - 8, 8);
	h->wrong += asked != bytes;
	--h->pieces;
	h->bytes -= (int64_t)bytes;
	free(raw);
}

/* ---- promises ---- */

static inline void session_problem(session *s, const char *what, int64_t value)
{
	if (s->problem != NULL)
		return;
	s->problem = what;
	s->problem_step = s->step;
	s->problem_value = value;
}

static inline void session_check_valid(session *s)
{
	char text[160] = "";
	if (s->world == NULL || cn_world_validate(s->world, text, (int32_t)sizeof text) == CN_OK)
		return;
	if (s->problem == NULL)
		printf("  %s\n", text);
	session_problem(s, "the world is not valid", s->step);
}

static inline void session_recover(session *s)
{
	s->hooks.fail_first = 0;
	s->recovered_step = s->step;
}

/* Counters without those that tell of the last step. */
static inline cn_counters session_counters(const session *s)
{
	cn_counters c;
	memset(&c, 0, sizeof c);
	if (s->world != NULL)
		(void)cn_world_get_counters(s->world, &c);
	c.broadphase_tiles = 0; /* settling between steps is no change */
	return c;
}

static inline uint64_t session_hash(const session *s)
{
	uint64_t hash = 0;
	if (s->world != NULL)
		(void)cn_world_hash(s->world, &hash);
	return hash;
}

static inline void session_before(session *s)
{
	++s->calls;
	if (s->hooks.fail_first == 0 || (s->failing_call != 0 && s->calls < s->failing_call))
		return;
	s->hash_before = session_hash(s);
	s->counters_before = session_counters(s);
}

/* 1: the call has to be repeated. */
static inline int session_failed(session *s, cn_result result, const char *what)
{
	cn_counters now;
	if (s->hooks.failed > 0 && s->failed_step < 0) {
		s->failed_step = s->step;
		if (s->failing_steps == 0)
			session_recover(s);
		if (result == CN_OK)
			session_check_valid(s);
	}
	if (result == CN_OK)
		return 0;
	if (result != CN_ERROR_MEMORY || s->hooks.failed == 0) {
		session_problem(s, what, result);
		return 0;
	}
	++s->refused;
	now = session_counters(s);
	if (session_hash(s) != s->hash_before)
		session_problem(s, "the hash changed in a call that failed", s->calls);
	if (memcmp(&now, &s->counters_before, sizeof now) != 0)
		session_problem(s, "the counters changed in a call that failed", s->calls);
	session_check_valid(s);
	session_recover(s);
	return 1;
}

#define TRY(s, expression) \
	do { \
		cn_result result_; \
		session_before(s); \
		result_ = (expression); \
		if (session_failed(s, result_, #expression)) { \
			result_ = (expression); \
			if (result_ != CN_OK) \
				session_problem(s, "again: " #expression, result_); \
		} \
	} while (0)

/* ---- events ---- */

static inline void session_count(session *s, int8_t *ledger, uint32_t contact, int32_t change)
{
	if (contact == 0 || contact >= SESSION_CONTACTS) {
		session_problem(s, "contact id out of range", contact);
		return;
	}
	ledger[contact] = (int8_t)(ledger[contact] + change);
	++s->events;
}

/* Reads one kind; sets *seen for STAY and for the ledger's check after all kinds were read. */
static inline void session_read_kind(session *s, int32_t kind)
{
	const cn_contact_event *events = NULL;
	int32_t count = 0, k;
	TRY(s, cn_world_contact_events(s->world, kind, &events, &count));
	if (kind == CN_EVENT_ENTER && session_counters(s).events_not_reported == 0 && s->called != count)
		session_problem(s, "callbacks and ENTER events differ", s->called - count);
	for (k = 0; k < count; ++k) {
		uint32_t id = events[k].contact_id;
		if (events[k].kind != kind)
			session_problem(s, "event of another kind", kind);
		if (kind == CN_EVENT_CREATED || kind == CN_EVENT_DESTROYED)
			session_count(s, s->created, id, kind == CN_EVENT_CREATED ? 1 : -1);
		else if (kind == CN_EVENT_ENTER || kind == CN_EVENT_LEAVE)
			session_count(s, s->entered, id, kind == CN_EVENT_ENTER ? 1 : -1);
	}
}

/* After a step an id has at most one open CREATED and one open ENTER, and never a negative number. STAY is read too. */
static inline void session_read_events(session *s)
{
	const cn_body_moved *moved = NULL;
	const cn_body *asleep = NULL;
	const cn_sensor_event *sensor = NULL;
	int32_t count = 0, kind, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind)
		session_read_kind(s, kind);
	for (k = 0; k < SESSION_CONTACTS; ++k) {
		if (s->created[k] < 0 || s->created[k] > 1)
			session_problem(s, "CREATED and DESTROYED do not match, contact", k);
		if (s->entered[k] < 0 || s->entered[k] > 1)
			session_problem(s, "ENTER and LEAVE do not match, contact", k);
	}
	TRY(s, cn_world_sensor_events(s->world, &sensor, &count));
	for (k = 0; k < count; ++k)
		s->sensed += sensor[k].kind == CN_EVENT_ENTER ? 1 : -1;
	if (s->sensed < 0)
		session_problem(s, "more sensor LEAVE than ENTER", s->sensed);
	TRY(s, cn_world_moved(s->world, &moved, &count));
	TRY(s, cn_world_fell_asleep(s->world, &asleep, &count));
}

/* Boxes that overlapped in the last step belong to a contact. */
static inline void session_check_contacts(session *s)
{
	const cn_world *world = s->world;
	int32_t a, b;
	for (a = 0; a < world->proxy_used; ++a)
		for (b = a + 1; b < world->proxy_used; ++b) {
			const cni_proxy *pa = cni_proxy_at(world, a), *pb = cni_proxy_at(world, b);
			if (!(pa->flags & pb->flags & CNI_PROXY_ALIVE) || pa->old.x0 > pa->old.x1 || pb->old.x0 > pb->old.x1)
				continue;
			if (!cni_aabb_overlap(&pa->old, &pb->old) || !cni_contact_allowed(world, a, b))
				continue;
			if (cni_contact_find(world, a, b) == CNI_NONE)
				session_problem(s, "boxes overlap without a contact, proxies", (int64_t)a * 1000 + b);
		}
}

static inline void session_step(session *s)
{
	int64_t failed = s->hooks.failed;
	cn_counters c;
	s->called = 0;
	if (s->step >= 93 && s->step < 99)
		TRY(s, cn_world_update(s->world, FRAME_S, NULL)); /* one step exactly */
	else
		TRY(s, cn_world_step(s->world, FRAME_S));
	c = session_counters(s);
	if (c.warnings != 0)
		++s->warned;
	if (s->body_count - c.bodies_awake > s->asleep_most)
		s->asleep_most = s->body_count - c.bodies_awake;
	if (c.warnings != 0 && s->hooks.failed == failed && s->hooks.fail_first == 0)
		session_problem(s, "a warning without a failure", c.warnings);
	if (((c.warnings & CN_WARNING_CONTACT_MEMORY) != 0) != (c.pairs_not_added > 0))
		session_problem(s, "warning of contacts and counter of pairs", c.pairs_not_added);
	if (((c.warnings & CN_WARNING_EVENT_MEMORY) != 0) != (c.events_not_reported > 0))
		session_problem(s, "warning of events and counter of events", c.events_not_reported);
	if (s->failed_step >= 0)
		session_check_valid(s);
	session_read_events(s);
	++s->step;
	if (s->failed_step >= 0 && s->recovered_step < 0 && s->step - s->failed_step >= s->failing_steps)
		session_recover(s);
	if (s->hooks.fail_first == 0 && (s->recovered_step < 0 || s->step >= s->recovered_step + 2))
		session_check_contacts(s);
}

/* ---- the script ---- */

static inline void session_on_enter(cn_world *world, const cn_contact_event *event, void *user)
{
	session *s = (session *)user;
	++s->called;
	s->unlocked += event->kind != CN_EVENT_ENTER || cn_body_set_awake(world, event->body_a, 1) != CN_ERROR_LOCKED;
}

static inline void session_world(session *s)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = &s->hooks;
	def.sleep_delay_s = 0.1f;
	def.sleep_speed_mps = 0.3f;
	TRY(s, cn_world_create(&def, &s->world));
	TRY(s, cn_world_set_contact_callback(s->world, CN_EVENT_ENTER, session_on_enter, s));
}

static inline cn_body_def session_body_def(int32_t index)
{
	cn_body_def def;
	cn_body_def_init(&def);
	def.position_m.x = (float)(index % 10) * 1.1f - 5.0f;
	def.position_m.y = (float)(index / 10) * 1.3f + 1.0f;
	def.angle_rad = (float)index * 0.37f;
	def.name = index % 3 == 0 ? "a name of some length, for the third class" : NULL;
	def.user_data = (uint64_t)index;
	return def;
}

/* One shape of each kind in turn, all events asked for. */
static inline void session_shape(session *s, int32_t index)
{
	cn_shape_def def = fixture_shape_def(s->bodies[index], 0.5f, index % 4 == 0 ? 0.5f : 0.0f);
	cn_shape *out = &s->shapes[index];
	def.event_mask = (1u << CN_EVENT_KINDS) - 1u;
	def.flags = index == 13 ? CN_SHAPE_SENSOR : 0u;
	def.material.rolling_resistance = index == 21 ? 0.05f : 0.0f;
	def.material.tangent_speed_mps = index == 22 ? 1.0f : 0.0f;
	if (index % 5 == 0) {
		cn_circle circle = { { 0.0f, 0.0f }, 0.45f };
		TRY(s, cn_shape_create_circle(s->world, &def, &circle, out));
	} else if (index % 5 == 1) {
		cn_capsule capsule = { { -0.3f, 0.0f }, { 0.3f, 0.0f }, 0.25f };
		TRY(s, cn_shape_create_capsule(s->world, &def, &capsule, out));
	} else if (index % 5 == 2) {
		cn_edge edge = { { -0.5f, 0.0f }, { 0.5f, 0.1f } };
		TRY(s, cn_shape_create_edge(s->world, &def, &edge, out));
	} else if (index % 5 == 3) {
		cn_vec2 points[20];
		cn_polygon hull;
		int32_t k;
		for (k = 0; k < 20; ++k) {
			points[k].x = 0.5f * (float)cos(0.314159 * k);
			points[k].y = 0.5f * (float)sin(0.314159 * k);
		}
		TRY(s, cn_polygon_make_hull(points, 20, 0.0f, &hull));
		TRY(s, cn_shape_create_polygon(s->world, &def, &hull, out));
	} else {
		TRY(s, cn_shape_create_box(s->world, &def, 0.4f, 0.3f, 0.05f, out));
	}
}

static inline void session_chain(session *s)
{
	cn_vec2 points[17];
	cn_chain chain;
	cn_shape_def def = fixture_shape_def(s->ground, 0.6f, 0.0f);
	int32_t k;
	for (k = 0; k < 17; ++k) {
		points[k].x = 16.0f - 2.0f * (float)k;
		points[k].y = k == 0 || k == 16 ? 6.0f : (float)(k % 2) * 0.3f;
	}
	chain.points_m = points;
	chain.count = 17;
	chain.loop = 0;
	TRY(s, cn_shape_create_chain(s->world, &def, &chain, &s->chain));
}

static inline void session_revolute(session *s, int32_t joint, int32_t a, int32_t b)
{
	cn_revolute_def def;
	cn_revolute_def_init(&def);
	def.base.body_a = s->bodies[a];
	def.base.body_b = s->bodies[b];
	def.base.anchor_a_m.x = 0.6f;
	def.base.anchor_b_m.x = -0.6f;
	def.base.flags = joint % 2 == 0 ? CN_JOINT_SPRING : CN_JOINT_COLLIDE;
	def.spring_hertz = 2.0f;
	TRY(s, cn_joint_create_revolute(s->world, &def, &s->joints[joint]));
}

static inline void session_distance(session *s, int32_t joint, int32_t a, int32_t b)
{
	cn_distance_def def;
	cn_distance_def_init(&def);
	def.base.body_a = s->bodies[a];
	def.base.body_b = b < 0 ? 0 : s->bodies[b];
	def.base.anchor_b_m.y = b < 0 ? 8.0f : 0.0f;
	def.length_m = 1.5f;
	TRY(s, cn_joint_create_distance(s->world, &def, &s->joints[joint]));
}

static inline void session_build(session *s)
{
	cn_body_def def = session_body_def(0);
	int32_t k;
	def.type = CN_BODY_STATIC;
	def.position_m.x = def.position_m.y = def.angle_rad = 0.0f;
	TRY(s, cn_body_create(s->world, &def, &s->ground));
	session_chain(s);
	s->body_count = 60;
	for (k = 0; k < s->body_count; ++k) {
		def = session_body_def(k);
		TRY(s, cn_body_create(s->world, &def, &s->bodies[k]));
		session_shape(s, k);
	}
	for (k = 0; k < 3; ++k)
		session_revolute(s, k, 10 * k, 10 * k + 1);
	session_distance(s, 3, 40, 41);
	session_distance(s, 4, 52, -1);
}

/* A burst from a point: nearly every contact ends and others begin. */
static inline void session_explode(session *s, float speed)
{
	int32_t k;
	for (k = 0; k < s->body_count; ++k) {
		cn_pose pose = fixture_pose(s->world, s->bodies[k]);
		float x = pose.position_m.x, y = pose.position_m.y + 1.0f, r = (float)sqrt((double)(x * x + y * y)) + 0.1f;
		int32_t type;
		TRY(s, cn_body_get_type(s->world, s->bodies[k], &type));
		if (type != CN_BODY_STATIC)
			TRY(s, cn_body_set_velocity(s->world, s->bodies[k], speed * x / r, speed * y / r, 5.0f));
	}
}

static inline void session_replace_bodies(session *s)
{
	cn_body_def defs[12];
	cn_body made[12];
	int32_t k;
	TRY(s, cn_body_destroy_many(s->world, s->bodies + 24, 12));
	for (k = 0; k < 12; ++k) {
		defs[k] = session_body_def(24 + k);
		defs[k].position_m.y += 3.0f;
		defs[k].name = k % 2 ? "short" : "one that fills the sixty-three bytes a name may have, or nearly";
	}
	TRY(s, cn_body_create_many(s->world, defs, 12, made));
	for (k = 0; k < 12; ++k) {
		s->bodies[24 + k] = made[k];
		session_shape(s, 24 + k);
	}
}

static inline void session_flags(session *s, int32_t first, int32_t count, uint32_t flags)
{
	int32_t k;
	for (k = first; k < first + count; ++k)
		TRY(s, cn_body_set_flags(s->world, s->bodies[k], flags));
}

static inline void session_types(session *s, int32_t first, int32_t count, int32_t type)
{
	int32_t k;
	for (k = first; k < first + count; ++k)
		TRY(s, cn_body_set_type(s->world, s->bodies[k], type));
}

static inline void session_filters(session *s, int32_t group)
{
	cn_filter filter;
	int32_t k;
	memset(&filter, 0, sizeof filter);
	filter.category = 1;
	filter.mask = ~(uint64_t)0;
	filter.group = group;
	for (k = 30; k < 50; ++k)
		TRY(s, cn_shape_set_filter(s->world, s->shapes[k], &filter));
}

static inline void session_materials(session *s)
{
	cn_material material;
	int32_t k;
	for (k = 0; k < 60; k += 7) {
		TRY(s, cn_shape_get_material(s->world, s->shapes[k], &material));
		material.restitution = 0.8f;
		material.rolling_resistance = 0.02f;
		TRY(s, cn_shape_set_material(s->world, s->shapes[k], &material));
	}
}

static inline void session_teleport(session *s)
{
	int32_t k;
	for (k = 0; k < 12; ++k)
		TRY(s, cn_body_set_pose(s->world, s->bodies[5 * k], (float)(k % 4) * 0.7f - 1.0f, (float)(k / 4) + 0.8f, 0.3f));
}

static inline void session_shapes_change(session *s)
{
	cn_shape_def def = fixture_shape_def(0, 0.5f, 0.0f);
	int32_t k;
	def.event_mask = 31u;
	TRY(s, cn_shape_create_box(s->world, &def, 0.6f, 0.2f, 0.0f, &s->spare_shape));
	TRY(s, cn_shape_attach(s->world, s->spare_shape, s->bodies[6]));
	TRY(s, cn_shape_detach(s->world, s->shapes[7]));
	TRY(s, cn_shape_attach(s->world, s->shapes[7], s->bodies[8]));
	TRY(s, cn_shape_destroy(s->world, s->shapes[9]));
	session_shape(s, 9);
	TRY(s, cn_shape_set_flags(s->world, s->shapes[11], CN_SHAPE_SENSOR));
	for (k = 40; k < 44; ++k)
		TRY(s, cn_shape_set_density(s->world, s->shapes[k], 3.0f));
}

static inline void session_joints_change(session *s)
{
	TRY(s, cn_joint_set_flags(s->world, s->joints[0], CN_JOINT_COLLIDE));
	TRY(s, cn_joint_set_flags(s->world, s->joints[1], CN_JOINT_SPRING));
	TRY(s, cn_joint_destroy(s->world, s->joints[2]));
	session_revolute(s, 2, 44, 45);
	session_distance(s, 5, 46, 47);
	session_distance(s, 6, 48, 49);
}

static inline void session_names(session *s)
{
	static const char *const names[] = { "a", "a name of more than sixteen", "one of more than thirty-two bytes..", NULL };
	int32_t k;
	for (k = 0; k < 20; ++k)
		TRY(s, cn_body_set_name(s->world, s->bodies[k], names[k % 4]));
}

static inline void session_sleep_some(session *s)
{
	int32_t k;
	for (k = 0; k < 60; k += 3)
		TRY(s, cn_body_set_awake(s->world, s->bodies[k], 0));
}

static inline void session_wake_all(session *s)
{
	int32_t k;
	for (k = 0; k < 60; ++k)
		TRY(s, cn_body_set_awake(s->world, s->bodies[k], 1));
}

static inline void session_before_step(session *s)
{
	const uint32_t plain = CN_BODY_SLEEP, enabled = CN_BODY_ENABLED | CN_BODY_SLEEP;
	switch (s->step) {
	case 12: session_names(s); break;
	case 16: session_replace_bodies(s); break;
	case 22: session_types(s, 50, 2, CN_BODY_STATIC); break;
	case 25: session_types(s, 50, 2, CN_BODY_KINEMATIC); break;
	case 28: session_types(s, 50, 2, CN_BODY_DYNAMIC); break;
	case 31: session_flags(s, 3, 5, plain); break;
	case 36: session_flags(s, 3, 5, enabled); break;
	case 40: session_filters(s, -3); break;
	case 44: session_filters(s, 0); break;
	case 47: session_materials(s); break;
	case 50: session_teleport(s); break;
	case 54: session_explode(s, 20.0f); break;
	case 60: session_joints_change(s); break;
	case 66: session_shapes_change(s); break;
	case 72: session_sleep_some(s); break;
	case 76: session_wake_all(s); break;
	case 84: session_explode(s, 60.0f); break;
	case 90:
		TRY(s, cn_world_set_gravity(s->world, 0.0f, -20.0f));
		TRY(s, cn_shape_destroy(s->world, s->chain));
		session_chain(s);
		break;
	case 104: session_replace_bodies(s); break;
	default: break;
	}
}

static inline void session_end(session *s)
{
	int32_t k;
	TRY(s, cn_body_destroy_many(s->world, s->bodies, s->body_count));
	TRY(s, cn_body_destroy(s->world, s->ground));
	session_recover(s);
	session_step(s);
	for (k = 0; k < SESSION_CONTACTS; ++k)
		if (s->created[k] != 0 || s->entered[k] != 0)
			session_problem(s, "events left open at the end, contact", k);
	if (s->sensed != 0)
		session_problem(s, "sensor events left open at the end", s->sensed);
	if (s->unlocked != 0)
		session_problem(s, "a callback could change the world", s->unlocked);
	session_check_valid(s);
	cn_world_destroy(s->world);
	s->world = NULL;
	if (s->hooks.pieces != 0 || s->hooks.bytes != 0)
		session_problem(s, "memory not given back, bytes", s->hooks.bytes);
	if (s->hooks.wrong != 0)
		session_problem(s, "pieces given back with another size", s->hooks.wrong);
}

/* One life; the script is cut short when a failure is well behind it. */
static inline void session_run(session *s, int64_t fail_at, int32_t failing_steps)
{
	s->failed_step = s->recovered_step = -1;
	s->hooks.fail_first = fail_at;
	s->hooks.fail_last = failing_steps > 0 ? INT64_MAX : fail_at;
	s->failing_steps = failing_steps;
	session_world(s);
	session_build(s);
	while (s->problem == NULL && s->step < SESSION_STEPS && (s->recovered_step < 0 || s->step < s->recovered_step + SESSION_CHECKED_STEPS)) {
		session_before_step(s);
		session_step(s);
	}
	if (s->problem == NULL)
		session_end(s);
	if (s->world != NULL)
		cn_world_destroy(s->world);
}

#endif
