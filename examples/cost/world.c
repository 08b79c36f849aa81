/*
 * examples/cost/world.c - the base scene, and a feature put into it (cost.h).
 */
#include "cost/cost.h"
#include <string.h>

#define DRUM_HALF_M 12.0f
#define DRUM_RADPS 0.25f
#define FAR_M 500.0f
#define PAIRS_M 100.0f
#define STACK_M -100.0f
#define STACK_BOXES 10

/* ------------------------------------------------------------------ drum */

static void make_drum(cost_world *w)
{
	scene_run *run = &w->run;
	w->drum = scene_body(run, CN_BODY_KINEMATIC, 0.0f, 0.0f);
	cn_shape_def wall = scene_surface(w->drum, 0.0f, 0.6f, 0.0f);
	for (int32_t side = -1; side <= 1; side += 2) {
		scene_offset_box(run, &wall, scene_vec(DRUM_HALF_M * (float)side, 0.0f), 0.5f, DRUM_HALF_M);
		scene_offset_box(run, &wall, scene_vec(0.0f, DRUM_HALF_M * (float)side), DRUM_HALF_M, 0.5f);
	}
	if (run->result == CN_OK)
		scene_check(run, cn_body_set_velocity(run->world, w->drum, 0.0f, 0.0f, DRUM_RADPS));
}

/* Boxes, circles and capsules by turns. */
static void add_drum_body(cost_world *w, int32_t index)
{
	scene_run *run = &w->run;
	float x = -8.8f + 1.6f * (float)(index % 12), y = -10.0f + 1.0f * (float)(index / 12);
	cn_body body = scene_body(run, CN_BODY_DYNAMIC, x, y);
	cn_shape_def surface = scene_surface(body, 1.0f, 0.6f, 0.0f);
	cn_circle circle = {{0.0f, 0.0f}, 0.44f};
	cn_capsule capsule = {{-0.2f, 0.0f}, {0.2f, 0.0f}, 0.36f};
	w->bodies[index] = body;
	if (run->result != CN_OK)
		return;
	if (index % 3 == 0)
		scene_check(run, cn_shape_create_box(run->world, &surface, 0.44f, 0.4f, 0.0f, &w->shapes[index]));
	else if (index % 3 == 1)
		scene_check(run, cn_shape_create_circle(run->world, &surface, &circle, &w->shapes[index]));
	else
		scene_check(run, cn_shape_create_capsule(run->world, &surface, &capsule, &w->shapes[index]));
}

/* ------------------------------------------------------------------ what a feature may need */

cn_body cost_box(cost_world *w, float x_m, float y_m, cn_shape *out_shape)
{
	cn_body body = scene_body(&w->run, CN_BODY_DYNAMIC, x_m, y_m);
	cn_shape_def surface = scene_surface(body, 1.0f, 0.6f, 0.0f);
	if (w->run.result == CN_OK)
		scene_check(&w->run, cn_shape_create_box(w->run.world, &surface, 0.5f, 0.5f, 0.0f, out_shape));
	return body;
}

/* Put to sleep before they could fall. */
static void add_unused(cost_world *w, const cost_feature *feature)
{
	scene_run *run = &w->run;
	for (int32_t i = 0; i < 2; ++i) {
		cn_shape shape = 0;
		cn_body a = cost_box(w, FAR_M + 10.0f * (float)i, 0.0f, &shape), b = 0;
		if (feature->on_pair != NULL)
			b = cost_box(w, FAR_M + 10.0f * (float)i, 2.0f, NULL);
		if (feature->on_pair != NULL && run->result == CN_OK)
			feature->on_pair(w, a, b);
		if (feature->on_body != NULL && run->result == CN_OK)
			feature->on_body(w, a);
		if (feature->on_shape != NULL && run->result == CN_OK)
			feature->on_shape(w, shape);
		if (run->result == CN_OK)
			scene_check(run, cn_body_set_awake(run->world, a, 0));
		if (b != 0 && run->result == CN_OK)
			scene_check(run, cn_body_set_awake(run->world, b, 0));
	}
}

/* Floating, turning, never asleep. */
static cn_body add_floating(cost_world *w, float x_m, float y_m)
{
	cn_body body = cost_box(w, x_m, y_m, NULL);
	if (w->run.result == CN_OK) {
		scene_check(&w->run, cn_body_set_flags(w->run.world, body, CN_BODY_ENABLED));
		scene_check(&w->run, cn_body_set_gravity_scale(w->run.world, body, 0.0f));
		scene_check(&w->run, cn_body_set_velocity(w->run.world, body, 0.05f, 0.0f, 0.2f));
	}
	return body;
}

static void add_pairs(cost_world *w, const cost_feature *feature)
{
	for (int32_t i = 0; i < COST_PAIRS; ++i) {
		cn_body a = add_floating(w, PAIRS_M, 5.0f * (float)i), b = add_floating(w, PAIRS_M, 5.0f * (float)i + 2.0f);
		if (w->form == COST_USED && w->run.result == CN_OK)
			feature->on_pair(w, a, b);
	}
}

static void add_used(cost_world *w, const cost_feature *feature)
{
	for (int32_t i = 0; i < COST_DRUM_BODIES && w->run.result == CN_OK; ++i) {
		if (feature->on_body != NULL)
			feature->on_body(w, w->bodies[i]);
		if (feature->on_shape != NULL)
			feature->on_shape(w, w->shapes[i]);
	}
}

cn_body cost_stack(cost_world *w)
{
	cn_body ground = scene_body(&w->run, CN_BODY_STATIC, STACK_M, -0.5f), lowest = 0;
	cn_shape_def surface = scene_surface(ground, 0.0f, 0.6f, 0.0f);
	scene_box(&w->run, &surface, 5.0f, 0.5f, 0.0f);
	for (int32_t i = 0; i < STACK_BOXES; ++i) {
		cn_body box = cost_box(w, STACK_M, 0.5f + (float)i, NULL);
		lowest = i == 0 ? box : lowest;
		if (w->run.result == CN_OK)
			scene_check(&w->run, cn_body_set_flags(w->run.world, box, CN_BODY_ENABLED));
	}
	return lowest;
}

/* ------------------------------------------------------------------ life */

int32_t cost_open(cost_world *w, const cost_feature *feature, int32_t form)
{
	cn_world_def def;
	memset(w, 0, sizeof *w);
	w->feature = feature;
	w->form = form;
	w->read_kind = -1;
	cn_world_def_init(&def);
	if (feature->define != NULL)
		feature->define(&def, form);
	w->run.result = cn_world_create(&def, &w->run.world);
	if (w->run.result != CN_OK)
		return 0;
	make_drum(w);
	for (int32_t i = 0; i < COST_DRUM_BODIES; ++i)
		add_drum_body(w, i);
	if (feature->on_pair != NULL && form >= COST_PLAIN)
		add_pairs(w, feature);
	if (form == COST_USED)
		add_used(w, feature);
	if (form == COST_UNUSED && (feature->on_body != NULL || feature->on_shape != NULL || feature->on_pair != NULL))
		add_unused(w, feature);
	if (feature->build != NULL && w->run.result == CN_OK)
		feature->build(w);
	return w->run.result == CN_OK;
}

/* Stays a function, whatever is inlined: its name is looked for. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
cn_result cost_step(cost_world *w)
{
	const cn_contact_event *events = NULL;
	int32_t count = 0;
	cn_result result = cn_world_step(w->run.world, SCENE_STEP_S);
	if (result == CN_OK && w->read_kind >= 0)
		result = cn_world_contact_events(w->run.world, w->read_kind, &events, &count);
	return result;
}

uint64_t cost_hash(const cost_world *w)
{
	uint64_t hash = 14695981039346656037u; /* FNV-1a */
	for (int32_t i = 0; i < COST_DRUM_BODIES; ++i) {
		unsigned char bytes[sizeof(cn_pose)];
		cn_pose pose;
		if (cn_body_get_pose(w->run.world, w->bodies[i], &pose) != CN_OK)
			return 0;
		memcpy(bytes, &pose, sizeof bytes);
		for (size_t k = 0; k < sizeof bytes; ++k)
			hash = (hash ^ bytes[k]) * 1099511628211u;
	}
	return hash;
}

void cost_close(cost_world *w)
{
	cn_world_destroy(w->run.world);
	w->run.world = NULL;
}
