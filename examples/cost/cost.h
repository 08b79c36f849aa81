/*
 * examples/cost/cost.h - what a feature costs a step: one base scene, and each feature added to it.
 *
 * The base scene is a drum of 24 m that turns, with 150 mixed bodies of 0.8 m in it: they never rest, and are not so fast
 * that continuous collision would look at them.
 * A feature is measured in four forms, each a world of its own:
 *
 *     COST_WITHOUT  the base scene
 *     COST_UNUSED   the feature is there, and nothing in the drum uses it: it lies on two bodies that sleep far away,
 *                   or is switched on and finds nothing to do. The bodies in the drum must keep their bits.
 *     COST_PLAIN    what the used form is compared with: the base scene, and whatever the feature needs around it
 *     COST_USED     the feature at work
 *
 * Outside of the drum there may be pairs of boxes that float without touching anything: what joints are put on.
 */
#ifndef CAIRN_COST_H
#define CAIRN_COST_H

#include "scenes/build.h"

enum {
	COST_WITHOUT = 0,
	COST_UNUSED = 1,
	COST_PLAIN = 2,
	COST_USED = 3,
	COST_FORMS = 4
};

#define COST_DRUM_BODIES 150
#define COST_PAIRS 10

typedef struct cost_feature cost_feature;

/* One world. */
typedef struct cost_world {
	scene_run run;               /* its world, and the first call that failed */
	const cost_feature *feature;
	int32_t form;                /* COST_* */
	cn_body drum;
	cn_body bodies[COST_DRUM_BODIES];
	cn_shape shapes[COST_DRUM_BODIES]; /* one of each body */
	int32_t read_kind;           /* CN_EVENT_* whose array is read after each step; -1: none */
} cost_world;

/* Has a feature a form that nothing uses, and do bodies move with it as without? */
enum { COST_UNUSED_NONE = 0, COST_UNUSED_ALIKE = 1, COST_UNUSED_OTHERWISE = 2 };

struct cost_feature {
	const char *name;
	const char *used;            /* the used form in words; NULL: there is none */
	int32_t units;               /* how many of it the used form has: cost is given for each; 0: it is not counted so */
	int32_t has_unused;          /* COST_UNUSED_ */
	int32_t parameter;           /* its own */
	/* Each may be NULL. define: the world's settings. build: when the drum is full, before the first step. */
	void (*define)(cn_world_def *def, int32_t form);
	void (*build)(cost_world *w);
	/* Put on a body, a shape, a pair of bodies. In the unused form on two that sleep far away; in the used form on every
	   one of the drum, pairs on ten that float, which the plain form has too. */
	void (*on_body)(cost_world *w, cn_body body);
	void (*on_shape)(cost_world *w, cn_shape shape);
	void (*on_pair)(cost_world *w, cn_body a, cn_body b);
};

extern const cost_feature cost_world_features[], cost_surface_features[], cost_joint_features[];
extern const int32_t cost_world_feature_count, cost_surface_feature_count, cost_joint_feature_count;

/* Opens the world of a feature in a form; 0 when a call failed: the run says which. */
int32_t cost_open(cost_world *w, const cost_feature *feature, int32_t form);
/* A step with what is read after it. Instructions are counted in here. */
cn_result cost_step(cost_world *w);
/* Of the poses of the bodies in the drum. */
uint64_t cost_hash(const cost_world *w);
void cost_close(cost_world *w);

/* A box of 1 m; boxes of a pile count up from the floor. */
cn_body cost_box(cost_world *w, float x_m, float y_m, cn_shape *out_shape);
/* Ten boxes on a floor, away from the drum and awake. Returns the lowest. */
cn_body cost_stack(cost_world *w);

#endif
