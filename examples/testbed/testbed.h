/*
 * examples/testbed/testbed.h - every scene to play with: drag bodies, pause, single steps, camera, settings, what the solver sees.
 *
 * The testbed draws into a canvas in memory and takes events; it knows no window. platform/sdl.c and platform/web.c show the canvas and
 * pass events on. Without drags and changed settings a scene has the bits of scene_step alone: the hash is that of the library's own run.
 */
#ifndef CAIRN_TESTBED_H
#define CAIRN_TESTBED_H

#include "demo/draw.h"
#include "scenes/scenes.h"

#define TESTBED_PANEL_PX 232
#define TESTBED_WIDGETS 40

enum { TESTBED_MOVE, TESTBED_PRESS, TESTBED_RELEASE, TESTBED_WHEEL, TESTBED_KEY };

/* What the pointer holds. */
enum { TESTBED_HOLDS_NOTHING, TESTBED_HOLDS_BODY, TESTBED_HOLDS_CAMERA, TESTBED_HOLDS_PANEL };

/* A scene and the length unit of its world. */
typedef struct testbed_entry {
	const scene *scene;
	float length_unit_m;
} testbed_entry;

/* Where a widget was drawn: tests press them. */
typedef struct testbed_widget {
	char name[24];
	float x, y, width, height;
} testbed_widget;

typedef struct testbed {
	scene_run run;
	int32_t entry;
	int32_t paused;
	double owed_s;        /* time that has not been stepped yet */
	/* settings of the world */
	int32_t solver, substeps, sleeping;
	float accuracy_m, gravity_mps2;
	uint32_t show;        /* DRAW_SHOW_* */
	/* picture and camera */
	canvas canvas;
	draw_view view;
	/* pointer */
	float x, y;
	int32_t holds, pressed; /* pressed: since the last frame */
	cn_joint drag;
	/* means of the last steps and frames */
	float step_ms, draw_ms, stages_ms[8];
	testbed_widget widgets[TESTBED_WIDGETS];
	int32_t widget_count;
} testbed;

int32_t testbed_count(void);
testbed_entry testbed_at(int32_t index);
/* -1 if there is none of this name. */
int32_t testbed_find(const char *name);

/* 0 when there is no memory. */
int32_t testbed_open(testbed *t, int32_t width, int32_t height);
void testbed_close(testbed *t);
int32_t testbed_resize(testbed *t, int32_t width, int32_t height);
/* Makes a scene anew; the present one: a reset. Settings stay, gravity is the scene's. */
void testbed_select(testbed *t, int32_t entry);
/* MOVE, PRESS, RELEASE: the pointer, in pixels. WHEEL: code is the number of clicks up. KEY: code is a letter, see testbed.c. */
void testbed_event(testbed *t, int32_t kind, float x, float y, int32_t code);
/* One step of the scene, paused or not. */
void testbed_step(testbed *t);
/* Steps for the elapsed time, at most three, and draws. */
void testbed_frame(testbed *t, double elapsed_s);
uint64_t testbed_hash(const testbed *t);

/* ---- parts, for panel.c ---- */

void testbed_apply(testbed *t);      /* settings to the world */
void testbed_key(testbed *t, int32_t code);
void testbed_panel(testbed *t);      /* draws the panel and acts on the pointer */

#endif
