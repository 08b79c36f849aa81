/*
 * examples/cost/features_world.c - settings, solvers, events, callbacks, and bodies' own settings (cost.h).
 */
#include "cost/cost.h"

#define SLEEPERS 200
#define FAST_BODIES 10

/* Is the feature switched on, used or not? */
static int32_t is_there(const cost_world *w) { return w->form == COST_UNUSED || w->form == COST_USED; }

/* ------------------------------------------------------------------ sleeping, continuous collision, profile */

static void define_sleep(cn_world_def *def, int32_t form)
{
	if (form == COST_WITHOUT || form == COST_PLAIN)
		def->flags &= ~(uint32_t)CN_WORLD_SLEEP;
}

static void build_sleep(cost_world *w)
{
	for (int32_t i = 0; i < SLEEPERS && w->form == COST_USED && w->run.result == CN_OK; ++i) {
		cn_body body = cost_box(w, 300.0f + 1.0f * (float)(i % 20), 1.0f * (float)(i / 20), NULL);
		if (w->run.result == CN_OK)
			scene_check(&w->run, cn_body_set_awake(w->run.world, body, 0));
	}
}

/* Balls at 80 m/s between thin walls. */
static void build_fast(cost_world *w)
{
	scene_run *run = &w->run;
	if (w->form < COST_PLAIN)
		return;
	cn_body room = scene_body(run, CN_BODY_STATIC, 200.0f, 0.0f);
	cn_shape_def wall = scene_surface(room, 0.0f, 0.0f, 1.0f);
	for (int32_t side = -1; side <= 1; side += 2) {
		scene_offset_box(run, &wall, scene_vec(10.0f * (float)side, 0.0f), 0.05f, 10.0f);
		scene_offset_box(run, &wall, scene_vec(0.0f, 10.0f * (float)side), 10.0f, 0.05f);
	}
	for (int32_t i = 0; i < FAST_BODIES; ++i) {
		cn_body ball = scene_body(run, CN_BODY_DYNAMIC, 200.0f, -8.0f + 1.6f * (float)i);
		cn_shape_def surface = scene_surface(ball, 1.0f, 0.0f, 1.0f);
		scene_circle(run, &surface, 0.1f);
		if (run->result != CN_OK)
			return;
		scene_check(run, cn_body_set_gravity_scale(run->world, ball, 0.0f));
		scene_check(run, cn_body_set_velocity(run->world, ball, 80.0f, 5.0f * (float)(i - 5), 0.0f));
		if (w->feature->on_body != NULL && w->form == COST_USED)
			w->feature->on_body(w, ball);
	}
}

static void define_continuous(cn_world_def *def, int32_t form)
{
	if (form == COST_WITHOUT || form == COST_PLAIN)
		def->flags &= ~(uint32_t)CN_WORLD_CONTINUOUS;
}

static int32_t is_in_drum(const cost_world *w, cn_body body)
{
	for (int32_t i = 0; i < COST_DRUM_BODIES; ++i) {
		if (w->bodies[i] == body)
			return 1;
	}
	return 0;
}

static void add_flag(cost_world *w, cn_body body, uint32_t flag)
{
	uint32_t flags = 0;
	scene_check(&w->run, cn_body_get_flags(w->run.world, body, &flags));
	scene_check(&w->run, cn_body_set_flags(w->run.world, body, flags | flag));
}

static void make_bullet(cost_world *w, cn_body body)
{
	if (!is_in_drum(w, body))
		add_flag(w, body, CN_BODY_BULLET);
}

static void define_profile(cn_world_def *def, int32_t form)
{
	if (form == COST_USED)
		def->flags |= CN_WORLD_PROFILE;
}

/* ------------------------------------------------------------------ solvers, broadphase */

static void define_auto(cn_world_def *def, int32_t form)
{
	if (form == COST_WITHOUT || form == COST_PLAIN)
		def->solver = CN_SOLVER_SOFT;
}

static void define_solver(cn_world_def *def, int32_t form, int32_t solver)
{
	if (form == COST_USED)
		def->solver = solver;
}

static void define_direct(cn_world_def *def, int32_t form) { define_solver(def, form, CN_SOLVER_DIRECT); }
static void define_soft(cn_world_def *def, int32_t form) { define_solver(def, form, CN_SOLVER_SOFT); }
static void define_sequential(cn_world_def *def, int32_t form) { define_solver(def, form, CN_SOLVER_SEQUENTIAL); }

static void define_tree(cn_world_def *def, int32_t form)
{
	if (form == COST_USED)
		def->broadphase = CN_BROADPHASE_TREE;
}

static void define_substeps(cn_world_def *def, int32_t form)
{
	if (form == COST_USED)
		def->substep_count = 8;
}

static void build_stack(cost_world *w)
{
	if (w->form >= COST_PLAIN)
		cost_stack(w);
}

static void build_override(cost_world *w)
{
	cn_body lowest = w->form >= COST_PLAIN ? cost_stack(w) : 0;
	if (w->form == COST_USED && w->run.result == CN_OK)
		scene_check(&w->run, cn_body_set_solver(w->run.world, lowest, CN_SOLVER_DIRECT));
}

static void override_body(cost_world *w, cn_body body)
{
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_body_set_solver(w->run.world, body, CN_SOLVER_DIRECT));
}

/* ------------------------------------------------------------------ events */

/* The feature's parameter is the kind. What nobody asks for, the walls do not ask for either. */
static void build_events(cost_world *w)
{
	cn_shape walls[4];
	int32_t count = 0;
	uint32_t mask = w->form == COST_USED ? 1u << w->feature->parameter : 0u;
	scene_check(&w->run, cn_body_get_shapes(w->run.world, w->drum, walls, 4, &count));
	for (int32_t i = 0; i < count && w->run.result == CN_OK; ++i)
		scene_check(&w->run, cn_shape_set_event_mask(w->run.world, walls[i], 0));
	for (int32_t i = 0; i < COST_DRUM_BODIES && w->run.result == CN_OK; ++i)
		scene_check(&w->run, cn_shape_set_event_mask(w->run.world, w->shapes[i], mask));
	if (w->form == COST_USED)
		w->read_kind = w->feature->parameter;
}

static void ask_for_event(cost_world *w, cn_shape shape)
{
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_shape_set_event_mask(w->run.world, shape, 1u << w->feature->parameter));
}

static void hear(cn_world *world, const cn_contact_event *event, void *user) { (void)world, (void)event, (void)user; }

/* Without being heard, events of this kind are gathered all the same: every form has them. */
static void build_callback(cost_world *w)
{
	for (int32_t i = 0; i < COST_DRUM_BODIES && w->run.result == CN_OK; ++i)
		scene_check(&w->run, cn_shape_set_event_mask(w->run.world, w->shapes[i], 1u << CN_EVENT_STAY));
	if (w->run.result == CN_OK && is_there(w))
		scene_check(&w->run, cn_world_set_contact_callback(w->run.world, CN_EVENT_STAY, hear, NULL));
	if (w->run.result == CN_OK && w->form == COST_UNUSED)
		scene_check(&w->run, cn_world_set_contact_callback(w->run.world, CN_EVENT_STAY, NULL, NULL));
}

/* ------------------------------------------------------------------ callbacks that decide */

static int32_t allow(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	(void)world, (void)a, (void)b, (void)user;
	return 1;
}

static void build_filter(cost_world *w)
{
	if (is_there(w))
		scene_check(&w->run, cn_world_set_filter_callback(w->run.world, allow, NULL));
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_world_set_filter_callback(w->run.world, NULL, NULL));
}

static int32_t go_on(cn_world *world, const cn_contact_event *contact, void *user)
{
	(void)world, (void)contact, (void)user;
	return 1;
}

/* Unused: the callback is there, and shapes that sleep want to be shown to it. */
static void build_pre_solve(cost_world *w)
{
	if (is_there(w))
		scene_check(&w->run, cn_world_set_pre_solve_callback(w->run.world, go_on, NULL));
}

static void show_to_pre_solve(cost_world *w, cn_shape shape)
{
	scene_check(&w->run, cn_shape_set_flags(w->run.world, shape, CN_SHAPE_PRE_SOLVE));
}

static void leave_mixed(cn_world *world, cn_shape a, cn_shape b, cn_material *mixed, void *user)
{
	(void)world, (void)a, (void)b, (void)mixed, (void)user;
}

static void build_mix(cost_world *w)
{
	if (is_there(w))
		scene_check(&w->run, cn_world_set_material_mix_callback(w->run.world, leave_mixed, NULL));
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_world_set_material_mix_callback(w->run.world, NULL, NULL));
}

/* ------------------------------------------------------------------ bodies */

static void lock_rotation(cost_world *w, cn_body body) { add_flag(w, body, CN_BODY_LOCK_ROTATION); }
static void set_damping(cost_world *w, cn_body body) { scene_check(&w->run, cn_body_set_damping(w->run.world, body, 0.1f, 0.1f)); }
static void set_gravity_scale(cost_world *w, cn_body body) { scene_check(&w->run, cn_body_set_gravity_scale(w->run.world, body, 0.9f)); }

static void build_speed_limits(cost_world *w)
{
	if (is_there(w))
		scene_check(&w->run, cn_world_set_speed_limits(w->run.world, w->form == COST_USED ? 2.0f : 100.0f, 300.0f));
}

static void build_disabled(cost_world *w)
{
	for (int32_t i = 0; i < SLEEPERS && w->form == COST_UNUSED && w->run.result == CN_OK; ++i) {
		cn_body body = cost_box(w, 300.0f + 1.0f * (float)(i % 20), 1.0f * (float)(i / 20), NULL);
		if (w->run.result == CN_OK)
			scene_check(&w->run, cn_body_set_flags(w->run.world, body, 0));
	}
}

static void build_statics(cost_world *w)
{
	for (int32_t i = 0; i < SLEEPERS && w->form == COST_UNUSED; ++i) {
		cn_body body = scene_body(&w->run, CN_BODY_STATIC, 300.0f + 2.0f * (float)(i % 20), 2.0f * (float)(i / 20));
		cn_shape_def surface = scene_surface(body, 0.0f, 0.6f, 0.0f);
		scene_box(&w->run, &surface, 1.0f, 1.0f, 0.0f);
	}
}

const cost_feature cost_world_features[] = {
	{"sleeping", "200 boxes asleep", 200, 1, 0, define_sleep, build_sleep, NULL, NULL, NULL},
	{"static bodies", NULL, 0, 1, 0, NULL, build_statics, NULL, NULL, NULL},
	{"disabled bodies", NULL, 0, 1, 0, NULL, build_disabled, NULL, NULL, NULL},
	{"continuous collision", "10 balls at 80 m/s", 10, 1, 0, define_continuous, build_fast, NULL, NULL, NULL},
	{"bullets", "10 balls at 80 m/s", 0, 1, 0, NULL, build_fast, make_bullet, NULL, NULL},
	{"profile", "on", 0, 0, 0, define_profile, NULL, NULL, NULL, NULL},
	{"AUTO beside SOFT", "a stack of 10 too", 0, COST_UNUSED_OTHERWISE, 0, define_auto, build_stack, NULL, NULL, NULL},
	{"DIRECT beside AUTO", "the world's", 0, 0, 0, define_direct, NULL, NULL, NULL, NULL},
	{"SOFT beside AUTO", "the world's", 0, 0, 0, define_soft, NULL, NULL, NULL, NULL},
	{"SEQUENTIAL beside AUTO", "the world's", 0, 0, 0, define_sequential, NULL, NULL, NULL, NULL},
	{"solver of a body", "DIRECT for a stack of 10", 1, 1, 0, NULL, build_override, override_body, NULL, NULL},
	{"tree broadphase", "instead of sweep", 0, 0, 0, define_tree, NULL, NULL, NULL, NULL},
	{"8 substeps", "instead of 4", 0, 0, 0, define_substeps, NULL, NULL, NULL, NULL},
	{"event created", "all and read", 0, 1, CN_EVENT_CREATED, NULL, build_events, NULL, ask_for_event, NULL},
	{"event enter", "all and read", 0, 1, CN_EVENT_ENTER, NULL, build_events, NULL, ask_for_event, NULL},
	{"event stay", "all and read", 0, 1, CN_EVENT_STAY, NULL, build_events, NULL, ask_for_event, NULL},
	{"event leave", "all and read", 0, 1, CN_EVENT_LEAVE, NULL, build_events, NULL, ask_for_event, NULL},
	{"event destroyed", "all and read", 0, 1, CN_EVENT_DESTROYED, NULL, build_events, NULL, ask_for_event, NULL},
	{"event hit", "all and read", 0, 1, CN_EVENT_HIT, NULL, build_events, NULL, ask_for_event, NULL},
	{"contact callback", "of stay", 0, 1, 0, NULL, build_callback, NULL, NULL, NULL},
	{"filter callback", "all pairs", 0, 1, 0, NULL, build_filter, NULL, NULL, NULL},
	{"pre-solve callback", "all contacts", 0, 1, 0, NULL, build_pre_solve, NULL, show_to_pre_solve, NULL},
	{"material mix callback", "all pairs", 0, 1, 0, NULL, build_mix, NULL, NULL, NULL},
	{"locked rotation", "150 bodies", 0, 1, 0, NULL, NULL, lock_rotation, NULL, NULL},
	{"damping", "150 bodies", 0, 1, 0, NULL, NULL, set_damping, NULL, NULL},
	{"gravity scale", "150 bodies", 0, 1, 0, NULL, NULL, set_gravity_scale, NULL, NULL},
	{"speed limits", "2 m/s", 0, 1, 0, NULL, build_speed_limits, NULL, NULL, NULL},
};
const int32_t cost_world_feature_count = (int32_t)(sizeof cost_world_features / sizeof cost_world_features[0]);
