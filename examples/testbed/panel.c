/*
 * examples/testbed/panel.c - the panel: buttons, sliders, figures. Each widget is drawn and asked in one call; a press acts in the frame
 * after it.
 */
#include "testbed/font.h"
#include "testbed/testbed.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define LINE_PX 17.0f
#define PANEL_COLOR 0xeeede8
#define BUTTON_COLOR 0xdcdad2
#define ON_COLOR 0x5b9bd5
#define TEXT_COLOR 0x2d3138

typedef struct panel {
	testbed *t;
	float left, y, width;
} panel;

/* ------------------------------------------------------------------ drawing */

static void rect(canvas *c, float x, float y, float width, float height, canvas_color color)
{
	canvas_rect(c, (int32_t)x, (int32_t)y, (int32_t)(x + width) - (int32_t)x, (int32_t)(y + height) - (int32_t)y, color);
}

static void text(canvas *c, float x, float y, const char *words, canvas_color color)
{
	for (; *words != '\0'; ++words, x += FONT_WIDTH) {
		if (*words < FONT_FIRST || *words >= FONT_FIRST + FONT_COUNT)
			continue;
		for (int32_t row = 0; row < FONT_HEIGHT; ++row) {
			for (int32_t bit = 0; bit < FONT_WIDTH; ++bit) {
				if (font_rows[*words - FONT_FIRST][row] & 64 >> bit)
					rect(c, x + (float)bit, y + (float)row, 1.0f, 1.0f, color);
			}
		}
	}
}

/* ------------------------------------------------------------------ widgets */

static int32_t inside(const testbed *t, float x, float y, float width, float height)
{
	return t->x >= x && t->x < x + width && t->y >= y && t->y < y + height;
}

static void remember(testbed *t, const char *name, float x, float y, float width, float height)
{
	if (t->widget_count >= TESTBED_WIDGETS)
		return;
	testbed_widget *w = &t->widgets[t->widget_count++];
	snprintf(w->name, sizeof w->name, "%s", name);
	w->x = x;
	w->y = y;
	w->width = width;
	w->height = height;
}

/* One of count buttons in a row. 1 when it was pressed. */
static int32_t button(panel *p, int32_t index, int32_t count, const char *name, int32_t on)
{
	testbed *t = p->t;
	float width = (p->width - 4.0f * (float)(count - 1)) / (float)count, x = p->left + (width + 4.0f) * (float)index;
	rect(&t->canvas, x, p->y, width, LINE_PX + 2.0f, on ? ON_COLOR : BUTTON_COLOR);
	text(&t->canvas, x + 0.5f * (width - (float)(FONT_WIDTH * (int32_t)strlen(name))), p->y + 3.0f, name, on ? 0xffffff : TEXT_COLOR);
	remember(t, name, x, p->y, width, LINE_PX + 2.0f);
	int32_t pressed = t->pressed && t->holds == TESTBED_HOLDS_PANEL && inside(t, x, p->y, width, LINE_PX + 2.0f);
	p->y += index == count - 1 ? LINE_PX + 6.0f : 0.0f;
	return pressed;
}

/* A value from 0 to 1. 1 while it is moved. */
static int32_t slider(panel *p, const char *name, const char *value, float *part)
{
	testbed *t = p->t;
	float knob = p->left + *part * (p->width - 8.0f);
	text(&t->canvas, p->left, p->y, name, TEXT_COLOR);
	text(&t->canvas, p->left + p->width - (float)(FONT_WIDTH * (int32_t)strlen(value)), p->y, value, TEXT_COLOR);
	rect(&t->canvas, p->left, p->y + 19.0f, p->width, 3.0f, BUTTON_COLOR);
	rect(&t->canvas, knob, p->y + 14.0f, 8.0f, 13.0f, ON_COLOR);
	remember(t, name, p->left, p->y + 12.0f, p->width, 17.0f);
	int32_t held = t->holds == TESTBED_HOLDS_PANEL && inside(t, p->left - 8.0f, p->y + 12.0f, p->width + 16.0f, 17.0f);
	p->y += 2.0f * LINE_PX - 1.0f;
	if (!held)
		return 0;
	float at = (t->x - p->left - 4.0f) / (p->width - 8.0f);
	*part = at < 0.0f ? 0.0f : at > 1.0f ? 1.0f : at;
	return 1;
}

static void line(panel *p, const char *words)
{
	text(&p->t->canvas, p->left, p->y, words, TEXT_COLOR);
	p->y += LINE_PX - 2.0f;
}

/* ------------------------------------------------------------------ parts of the panel */

static void scene_part(panel *p)
{
	testbed *t = p->t;
	char words[40];
	snprintf(words, sizeof words, "%" PRId32 "/%" PRId32 " %s", t->entry + 1, testbed_count(), testbed_at(t->entry).scene->name);
	line(p, words);
	p->y += 2.0f;
	if (button(p, 0, 2, "< scene", 0))
		testbed_key(t, '[');
	if (button(p, 1, 2, "scene >", 0))
		testbed_key(t, ']');
	if (button(p, 0, 3, "pause", t->paused))
		testbed_key(t, ' ');
	if (button(p, 1, 3, "step", 0))
		testbed_key(t, '.');
	if (button(p, 2, 3, "reset", 0))
		testbed_key(t, 'r');
}

/* 0.1 mm to 100 mm in three decades, three steps of a decade. */
static float accuracy_of(int32_t step)
{
	static const float steps[10] = {1e-4f, 2e-4f, 5e-4f, 1e-3f, 2e-3f, 5e-3f, 1e-2f, 2e-2f, 5e-2f, 1e-1f};
	return steps[step < 0 ? 0 : step > 9 ? 9 : step];
}

static float accuracy_part(float accuracy_m)
{
	int32_t step = 0;
	while (step < 9 && accuracy_of(step) < 0.99f * accuracy_m)
		++step;
	return (float)step / 9.0f;
}

static void settings_part(panel *p)
{
	static const char *const solvers[4] = {"auto", "soft", "dir", "seq"};
	testbed *t = p->t;
	char words[24];
	for (int32_t i = 0; i < 4; ++i) {
		if (button(p, i, 4, solvers[i], t->solver == i))
			testbed_key(t, '1' + i);
	}
	float substeps = (float)(t->substeps - 1) / 15.0f, accuracy = accuracy_part(t->accuracy_m), gravity = (10.0f - t->gravity_mps2) / 40.0f;
	snprintf(words, sizeof words, "%" PRId32, t->substeps);
	int32_t changed = slider(p, "substeps", words, &substeps);
	snprintf(words, sizeof words, "%.1f mm", 1000.0 * (double)t->accuracy_m);
	changed |= slider(p, "accuracy", words, &accuracy) << 1;
	snprintf(words, sizeof words, "%.1f m/s2", (double)t->gravity_mps2);
	changed |= slider(p, "gravity", words, &gravity) << 2;
	if (changed & 1)
		t->substeps = 1 + (int32_t)(15.0f * substeps + 0.5f);
	if (changed & 2)
		t->accuracy_m = accuracy_of((int32_t)(9.0f * accuracy + 0.5f));
	if (changed & 4)
		t->gravity_mps2 = 10.0f - (float)(int32_t)(40.0f * gravity + 0.5f);
	if (changed)
		testbed_apply(t);
}

static void show_part(panel *p)
{
	testbed *t = p->t;
	if (button(p, 0, 3, "contacts", (t->show & DRAW_SHOW_CONTACTS) != 0))
		testbed_key(t, 'c');
	if (button(p, 1, 3, "joints", (t->show & DRAW_SHOW_JOINTS) != 0))
		testbed_key(t, 'j');
	if (button(p, 2, 3, "boxes", (t->show & DRAW_SHOW_BOXES) != 0))
		testbed_key(t, 'b');
	if (button(p, 0, 3, "islands", (t->show & DRAW_SHOW_ISLANDS) != 0))
		testbed_key(t, 'i');
	if (button(p, 1, 3, "tiers", (t->show & DRAW_SHOW_TIERS) != 0))
		testbed_key(t, 't');
	if (button(p, 2, 3, "sleep", t->sleeping))
		testbed_key(t, 'z');
}

static void figures_part(panel *p)
{
	testbed *t = p->t;
	cn_counters c;
	char words[48];
	if (t->run.world == NULL || t->run.result != CN_OK) {
		line(p, "the scene failed:");
		snprintf(words, sizeof words, "%.30s", t->run.error_text);
		line(p, words);
		return;
	}
	cn_world_get_counters(t->run.world, &c);
	snprintf(words, sizeof words, "bodies %" PRId32 ", awake %" PRId32, c.bodies, c.bodies_awake);
	line(p, words);
	snprintf(words, sizeof words, "contacts %" PRId32 ", joints %" PRId32, c.contacts_touching, c.joints);
	line(p, words);
	snprintf(words, sizeof words, "islands %" PRId32 ", direct %" PRId32, c.islands_awake, c.islands_direct);
	line(p, words);
	snprintf(words, sizeof words, "step %" PRId32, t->run.step_index);
	line(p, words);
	snprintf(words, sizeof words, "hash %016" PRIx64, testbed_hash(t));
	line(p, words);
	snprintf(words, sizeof words, "step %.2f ms, draw %.2f ms", (double)t->step_ms, (double)t->draw_ms);
	line(p, words);
}

/* A bar of a stage: its whole width is 1 ms, or the longest stage. */
static void profile_part(panel *p)
{
	static const char *const stages[8] = {"sleep", "pairs", "narrow", "islands", "prepare", "substep", "finalize", "events"};
	testbed *t = p->t;
	float most = 1.0f;
	for (int32_t i = 0; i < 8; ++i)
		most = t->stages_ms[i] > most ? t->stages_ms[i] : most;
	for (int32_t i = 0; i < 8; ++i) {
		char words[16];
		float width = (p->width - 112.0f) * t->stages_ms[i] / most;
		rect(&t->canvas, p->left + 60.0f, p->y + 3.0f, width < 1.0f ? 1.0f : width, 8.0f, ON_COLOR);
		snprintf(words, sizeof words, "%6.3f", (double)t->stages_ms[i]);
		text(&t->canvas, p->left + p->width - 46.0f, p->y, words, TEXT_COLOR);
		line(p, stages[i]);
	}
}

void testbed_panel(testbed *t)
{
	panel p = {t, (float)(t->canvas.width - TESTBED_PANEL_PX) + 12.0f, 10.0f, (float)TESTBED_PANEL_PX - 24.0f};
	t->widget_count = 0;
	rect(&t->canvas, p.left - 12.0f, 0.0f, (float)TESTBED_PANEL_PX, (float)t->canvas.height, PANEL_COLOR);
	scene_part(&p);
	settings_part(&p);
	show_part(&p);
	figures_part(&p);
	profile_part(&p);
	line(&p, "drag bodies, drag the view,");
	line(&p, "wheel: zoom");
	t->pressed = 0;
}
