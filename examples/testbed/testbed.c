/*
 * examples/testbed/testbed.c - scenes, steps, the camera and dragging. Keys:
 *
 *   space pause   . step   r reset   [ ] scene   1 to 4 solver   - + substeps   z sleep
 *   c contacts   j joints   b boxes   i islands   t tiers
 */
#include "testbed/testbed.h"
#include "measure/measure.h"
#include <string.h>

#define STEPS_A_FRAME_MAX 3
#define MEAN_SHARE 0.08f

/* ------------------------------------------------------------------ scenes */

int32_t testbed_open(testbed *t, int32_t width, int32_t height)
{
	memset(t, 0, sizeof *t);
	t->solver = CN_SOLVER_AUTO;
	t->substeps = 4;
	t->sleeping = 1;
	t->accuracy_m = 0.005f;
	t->show = DRAW_SHOW_BODIES | DRAW_SHOW_JOINTS;
	if (!canvas_open(&t->canvas, width, height))
		return 0;
	testbed_select(t, testbed_find("machines"));
	return 1;
}

void testbed_close(testbed *t)
{
	scene_close(&t->run);
	canvas_close(&t->canvas);
}

/* The scene's view in the picture beside the panel. */
static void fit_view(testbed *t)
{
	const cn_aabb *box = &testbed_at(t->entry).scene->view_m;
	float width_m = box->upper_m.x - box->lower_m.x, height_m = box->upper_m.y - box->lower_m.y;
	float width = (float)(t->canvas.width - TESTBED_PANEL_PX), height = (float)t->canvas.height;
	t->view.scale = width / width_m < height / height_m ? width / width_m : height / height_m;
	t->view.lower_m.x = 0.5f * (box->lower_m.x + box->upper_m.x) - 0.5f * width / t->view.scale;
	t->view.lower_m.y = 0.5f * (box->lower_m.y + box->upper_m.y) - 0.5f * height / t->view.scale;
}

int32_t testbed_resize(testbed *t, int32_t width, int32_t height)
{
	canvas_close(&t->canvas);
	if (!canvas_open(&t->canvas, width > 400 ? width : 400, height > 300 ? height : 300))
		return 0;
	fit_view(t);
	return 1;
}

void testbed_select(testbed *t, int32_t entry)
{
	const int32_t same = t->entry == entry && t->run.world != NULL;
	testbed_entry which = testbed_at(entry);
	cn_world_def def;
	scene_close(&t->run);
	t->entry = entry;
	t->drag = 0;
	t->holds = TESTBED_HOLDS_NOTHING;
	t->owed_s = 0.0;
	if (!same) {
		fit_view(t);
		t->gravity_mps2 = which.scene->gravity_mps2.y;
	}
	scene_world_def(which.scene, &def);
	def.length_unit_m = which.length_unit_m;
	def.solver = t->solver;
	def.substep_count = t->substeps;
	def.accuracy_m = t->accuracy_m * which.length_unit_m;
	def.gravity_mps2.y = t->gravity_mps2;
	def.flags = (def.flags & ~(t->sleeping ? 0u : CN_WORLD_SLEEP)) | CN_WORLD_PROFILE;
	scene_open(&t->run, which.scene, &def);
}

void testbed_apply(testbed *t)
{
	cn_vec2 gravity;
	uint32_t flags;
	if (t->run.world == NULL)
		return;
	cn_world_set_solver(t->run.world, t->solver);
	cn_world_set_substep_count(t->run.world, t->substeps);
	cn_world_set_accuracy(t->run.world, t->accuracy_m * testbed_at(t->entry).length_unit_m, CN_DEFAULT);
	cn_world_get_gravity(t->run.world, &gravity);
	cn_world_set_gravity(t->run.world, gravity.x, t->gravity_mps2);
	cn_world_get_flags(t->run.world, &flags);
	const uint32_t sleep = t->sleeping && testbed_at(t->entry).scene->flags & SCENE_SLEEP ? CN_WORLD_SLEEP : 0u;
	cn_world_set_flags(t->run.world, (flags & ~(uint32_t)CN_WORLD_SLEEP) | sleep);
}

uint64_t testbed_hash(const testbed *t)
{
	uint64_t hash = 0;
	if (t->run.world != NULL)
		cn_world_hash(t->run.world, &hash);
	return hash;
}

/* ------------------------------------------------------------------ dragging */

static cn_vec2 to_world(const testbed *t, float x, float y)
{
	cn_vec2 point;
	point.x = t->view.lower_m.x + x / t->view.scale;
	point.y = t->view.lower_m.y + ((float)t->canvas.height - y) / t->view.scale;
	return point;
}

/* The first dynamic body near the pointer; 0: none. */
static cn_body body_at(const testbed *t, cn_vec2 at)
{
	cn_circle pointer = {at, 4.0f / t->view.scale};
	cn_shape shapes[16];
	int32_t count = 0;
	if (t->run.world == NULL || cn_world_overlap_circle(t->run.world, &pointer, NULL, shapes, 16, &count) != CN_OK)
		return 0;
	for (int32_t i = 0; i < count && i < 16; ++i) {
		cn_body body = 0;
		int32_t type = CN_BODY_STATIC;
		if (cn_shape_get_body(t->run.world, shapes[i], &body) == CN_OK && body != 0 &&
			cn_body_get_type(t->run.world, body, &type) == CN_OK && type == CN_BODY_DYNAMIC)
			return body;
	}
	return 0;
}

static void press(testbed *t)
{
	cn_vec2 at = to_world(t, t->x, t->y);
	cn_body body = body_at(t, at);
	cn_mouse_def def;
	cn_mass_data mass;
	t->pressed = 1;
	if (t->x >= (float)(t->canvas.width - TESTBED_PANEL_PX)) {
		t->holds = TESTBED_HOLDS_PANEL;
		return;
	}
	t->holds = TESTBED_HOLDS_CAMERA;
	if (body == 0)
		return;
	cn_mouse_def_init(&def);
	def.base.body_b = body;
	def.target_m = at;
	cn_body_get_local_point(t->run.world, body, at.x, at.y, &def.base.anchor_b_m);
	cn_body_get_mass_data(t->run.world, body, &mass);
	def.base.force_max_N = 500.0f * mass.mass_kg;
	if (cn_joint_create_mouse(t->run.world, &def, &t->drag) == CN_OK)
		t->holds = TESTBED_HOLDS_BODY;
}

static void release(testbed *t)
{
	if (t->drag != 0 && cn_joint_is_valid(t->run.world, t->drag))
		cn_joint_destroy(t->run.world, t->drag);
	t->drag = 0;
	t->holds = TESTBED_HOLDS_NOTHING;
}

/* ------------------------------------------------------------------ events */

static void move(testbed *t, float x, float y)
{
	if (t->holds == TESTBED_HOLDS_CAMERA) {
		t->view.lower_m.x -= (x - t->x) / t->view.scale;
		t->view.lower_m.y += (y - t->y) / t->view.scale;
	}
	t->x = x;
	t->y = y;
}

/* The point under the pointer stays there. */
static void zoom(testbed *t, int32_t clicks)
{
	cn_vec2 before = to_world(t, t->x, t->y), after;
	for (; clicks > 0; --clicks)
		t->view.scale *= 1.15f;
	for (; clicks < 0; ++clicks)
		t->view.scale /= 1.15f;
	after = to_world(t, t->x, t->y);
	t->view.lower_m.x += before.x - after.x;
	t->view.lower_m.y += before.y - after.y;
}

static void show_one_of(testbed *t, uint32_t which)
{
	uint32_t colors = DRAW_SHOW_ISLANDS | DRAW_SHOW_TIERS;
	t->show = (t->show & ~colors) | (t->show & which ? 0u : which);
}

void testbed_key(testbed *t, int32_t code)
{
	switch (code) {
	case ' ': t->paused = !t->paused; break;
	case '.': testbed_step(t); break;
	case 'r': testbed_select(t, t->entry); break;
	case '[': testbed_select(t, (t->entry + testbed_count() - 1) % testbed_count()); break;
	case ']': testbed_select(t, (t->entry + 1) % testbed_count()); break;
	case '1': case '2': case '3': case '4': t->solver = code - '1'; break;
	case '-': t->substeps -= t->substeps > 1; break;
	case '+': case '=': t->substeps += t->substeps < 16; break;
	case 'z': t->sleeping = !t->sleeping; break;
	case 'c': t->show ^= DRAW_SHOW_CONTACTS; break;
	case 'j': t->show ^= DRAW_SHOW_JOINTS; break;
	case 'b': t->show ^= DRAW_SHOW_BOXES; break;
	case 'i': show_one_of(t, DRAW_SHOW_ISLANDS); break;
	case 't': show_one_of(t, DRAW_SHOW_TIERS); break;
	default: return;
	}
	if ((code >= '1' && code <= '4') || code == '-' || code == '+' || code == '=' || code == 'z')
		testbed_apply(t);
}

void testbed_event(testbed *t, int32_t kind, float x, float y, int32_t code)
{
	if (kind == TESTBED_KEY) {
		testbed_key(t, code);
		return;
	}
	move(t, x, y);
	if (kind == TESTBED_PRESS)
		press(t);
	else if (kind == TESTBED_RELEASE)
		release(t);
	else if (kind == TESTBED_WHEEL)
		zoom(t, code);
}

/* ------------------------------------------------------------------ time */

static void add_mean(float *mean, double value) { *mean += MEAN_SHARE * ((float)value - *mean); }

static void add_profile(testbed *t)
{
	cn_profile p;
	if (cn_world_get_profile(t->run.world, &p) != CN_OK)
		return;
	const float stages[8] = {p.wake_s + p.sleep_s, p.broadphase_s, p.narrowphase_s, p.islands_s, p.prepare_s, p.substeps_s, p.finalize_s,
		p.events_s};
	for (int32_t i = 0; i < 8; ++i)
		add_mean(&t->stages_ms[i], 1000.0 * (double)stages[i]);
}

void testbed_step(testbed *t)
{
	if (t->run.world == NULL || t->run.result != CN_OK)
		return;
	if (t->drag != 0 && cn_joint_is_valid(t->run.world, t->drag)) {
		cn_vec2 target = to_world(t, t->x, t->y);
		cn_joint_set_target(t->run.world, t->drag, target.x, target.y);
	}
	double start = measure_clock_s();
	scene_step(&t->run);
	add_mean(&t->step_ms, 1000.0 * (measure_clock_s() - start));
	add_profile(t);
}

static void follow_focus(testbed *t)
{
	const cn_aabb *box = &t->run.scene->view_m;
	cn_vec2 center;
	if (t->run.focus == 0 || t->holds == TESTBED_HOLDS_CAMERA || cn_body_get_center(t->run.world, t->run.focus, &center) != CN_OK)
		return;
	float width_m = (float)(t->canvas.width - TESTBED_PANEL_PX) / t->view.scale;
	t->view.lower_m.x = center.x - 0.5f * width_m - 0.1f * (box->lower_m.x + box->upper_m.x);
}

void testbed_frame(testbed *t, double elapsed_s)
{
	t->owed_s = t->paused ? 0.0 : t->owed_s + elapsed_s;
	for (int32_t i = 0; i < STEPS_A_FRAME_MAX && t->owed_s >= 0.999 / 60.0; ++i) {
		testbed_step(t);
		t->owed_s -= 1.0 / 60.0;
	}
	t->owed_s = t->owed_s > 1.0 / 60.0 ? 0.0 : t->owed_s; /* too slow: time that is not stepped is lost */
	double start = measure_clock_s();
	if (t->run.world != NULL) {
		follow_focus(t);
		draw_world(&t->canvas, &t->view, t->run.world, t->show);
	} else {
		canvas_clear(&t->canvas, draw_colors[DRAW_BACKGROUND]);
	}
	testbed_panel(t);
	add_mean(&t->draw_ms, 1000.0 * (measure_clock_s() - start));
}
