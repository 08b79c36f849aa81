/*
 * examples/scenes/scenes.h - the scenes that the demo, the benchmark and the golden-hash tests share.
 *
 *     scene_run run;
 *     if (scene_open(&run, scene_find("pyramid"), NULL) != CN_OK) puts(run.error_text);
 *     for (int32_t i = 0; i < run.scene->step_count; ++i) scene_step(&run);
 *     scene_close(&run);
 *
 * A scene uses only the public API and computes its coordinates without libm, so that the same scene
 * has the same bits everywhere. All run at 60 Hz. Runs share nothing: any number may be open at once.
 */
#ifndef CAIRN_SCENES_H
#define CAIRN_SCENES_H

#include "cairn.h"

#define SCENE_STEP_S (1.0f / 60.0f)

enum {
	SCENE_DEMO = 1u << 0,   /* shown by make demo */
	SCENE_BENCH = 1u << 1,  /* timed by make bench */
	SCENE_STANDS = 1u << 2, /* bodies should stay where they start: displacement is an error */
	SCENE_SLEEP = 1u << 3   /* sleeping on */
};

typedef struct scene scene;

/* A scene that runs. Fields are for reading. */
typedef struct scene_run {
	const scene *scene;
	cn_world *world;
	cn_result result;     /* the first call that failed, CN_OK so far */
	int32_t step_index;   /* steps taken */
	cn_body focus;        /* a camera follows this body's x; 0: none */
	void *memory;         /* the scene's own, freed with free() by scene_close */
	char error_text[200]; /* of result */
} scene_run;

struct scene {
	const char *name;
	const char *title;
	void (*create)(scene_run *run);
	void (*step)(scene_run *run, int32_t step_index); /* NULL, or called before each step */
	int32_t step_count;     /* usual length of a run */
	int32_t size;           /* the scene's parameter: bodies, rows or the base of a pyramid */
	uint32_t flags;         /* SCENE_* */
	cn_vec2 gravity_mps2;
	cn_aabb view_m;         /* what a picture shows */
	cn_aabb bounds_m;       /* bodies outside of this have left the scene */
};

int32_t scene_count(void);
const scene *scene_at(int32_t index);
/* NULL if there is none of this name. */
const scene *scene_find(const char *name);

/* The world definition of a scene: gravity and sleeping; change it (memory, solver) and pass it on. */
void scene_world_def(const scene *which, cn_world_def *out);
/* Makes the world and everything in it. def NULL: as scene_world_def. After a failure the run has no
   world and error_text says why. */
cn_result scene_open(scene_run *run, const scene *which, const cn_world_def *def);
/* scene->step alone: what the scene does between two steps. */
cn_result scene_before_step(scene_run *run);
/* scene_before_step, then one step of 1/60 s. */
cn_result scene_step(scene_run *run);
void scene_close(scene_run *run);

#endif
