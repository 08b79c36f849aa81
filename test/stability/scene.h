/*
 * test/stability/scene.h - what a scene of the stability suite is, and what scenes are written with.
 *
 * A family is code: it builds a world from parameters, looks at it after every frame and reports metrics. A case is
 * data: the name of a family, values for its parameters and bounds for its metrics (cases.c). Everything is read back
 * through cairn.h and compared in double precision.
 *
 * Texts of values are "name=number name=number"; texts of bounds "metric<=number metric>=number".
 *
 * Every family also has the parameters of SCENE_COMMON: hertz (frames a second), seconds, size (factor on all
 * lengths), unit (the world's length unit, m), far (metres that everything is moved in x), vary (1: frames of 0.5 to
 * 1.5 times the mean), sleep (1: islands may sleep), gravity (m/s^2, down).
 */
#ifndef CAIRN_STABILITY_SCENE_H
#define CAIRN_STABILITY_SCENE_H

#include "cairn.h"
#include <stddef.h>
#include <stdio.h>

#define SCENE_COMMON "hertz=60 seconds=10 size=1 unit=1 far=0 vary=0 sleep=0 gravity=10"
#define SCENE_METRICS_MAX 16
#define SCENE_GROUND_MAX 8
#define SCENE_PI 3.14159265358979323846

typedef struct scene_run scene_run;

typedef struct scene_family {
	const char *name;
	const char *parameters;          /* its own, with defaults; may also replace common ones */
	uint64_t state_bytes;            /* of run->state, zero at the start */
	void (*build)(scene_run *run);
	void (*observe)(scene_run *run); /* after every frame; may be NULL */
	void (*finish)(scene_run *run);  /* reports the metrics */
} scene_family;

typedef struct scene_case {
	const char *name;
	const char *family;
	const char *parameters;
	const char *bounds;
	int32_t seeds; /* > 0: as many runs, with seed=1 and so on; name_seed1 ... */
} scene_case;

/* What the command line asks for. */
typedef struct scene_settings {
	const char *solver_name;
	int32_t solver;
	int32_t substeps;       /* 0: the library's default */
	double dt_s;            /* 0: the scene's */
	double seconds;         /* 0: the scene's */
	const char *parameters; /* stronger than a case's */
	FILE *film;             /* NULL, or where film.c writes the run */
} scene_settings;

typedef struct scene_metric {
	const char *name;
	double value;
} scene_metric;

/* A body whose motion is measured, and how it started. */
typedef struct scene_item {
	cn_body body;
	double half_x, half_y; /* of a box; 0, 0: another shape */
	double x, y;           /* metres, without far */
	long film[3];          /* last pose that film.c wrote */
} scene_item;

struct scene_run {
	const scene_family *family;
	const char *parameters[4]; /* from weakest to strongest */
	cn_world *world;
	void *state;
	/* Surface and filter of the shapes made next. */
	double density, friction, restitution;
	double far_m; /* the parameter */
	int32_t group;
	uint32_t body_flags;
	/* Dynamic bodies in order of creation, and joints. */
	scene_item *items;
	int32_t item_count, item_capacity;
	/* The first static boxes, for overlaps. */
	scene_item ground[SCENE_GROUND_MAX];
	int32_t ground_count;
	cn_joint *joints;
	int32_t joint_count, joint_capacity;
	/* Progress: frame is 0 while building, 1 after the first step. */
	int32_t frame, frame_count;
	double dt_s, time_s;
	double cpu_s;
	FILE *film;
	char refusal[160]; /* why the library would not build or step it; "" if it did */
	scene_metric metrics[SCENE_METRICS_MAX];
	int32_t metric_count;
};

/* ---- values.c: texts of values and bounds ---- */

/* Finds name in a text of values. Returns 0 if it is not there. */
int values_find(const char *text, const char *name, double *out);
/* The strongest value of a parameter; a family that asks for one it does not have is a mistake in this program. */
double scene_value(const scene_run *run, const char *name);
int32_t scene_count(const scene_run *run, const char *name);
/* Takes the next bound of a text and moves on; at_most is 0 for >=. Returns 0 at the end. */
typedef struct values_bound {
	char metric[64];
	double bound;
	int at_most;
} values_bound;
int values_next_bound(const char **text, values_bound *out);

/* ---- run.c: one run of one case ---- */

int scene_execute(scene_run *run, const scene_family *family, const scene_case *which, const scene_settings *settings);
void scene_dispose(scene_run *run);
/* Remembers the first call that failed; such a case counts as skipped. Returns 1 if all is well so far. */
int scene_check(scene_run *run, cn_result result);
void scene_report(scene_run *run, const char *metric, double value);

/* ---- build.c: bodies and joints; lengths are multiplied by size, and x is moved by far ---- */

cn_body scene_body(scene_run *run, int32_t type, double x, double y, double angle);
cn_body scene_box(scene_run *run, int32_t type, double x, double y, double angle, double half_x, double half_y);
cn_body scene_circle(scene_run *run, int32_t type, double x, double y, double radius);
cn_body scene_polygon(scene_run *run, int32_t type, double x, double y, const double (*points)[2], int32_t count);
void scene_capsule_shape(scene_run *run, cn_body body, double ax, double ay, double bx, double by, double radius);
void scene_floor(scene_run *run);
void scene_set_velocity(scene_run *run, cn_body body, double vx, double vy, double w);
/* Pins, welds: at a point of the scene where both bodies are now. body_a 0: the world. */
void scene_pin(scene_run *run, cn_body body_a, cn_body body_b, double x, double y);
void scene_pin_limited(scene_run *run, cn_body body_a, cn_body body_b, double x, double y, double lower, double upper);
void scene_weld(scene_run *run, cn_body body_a, cn_body body_b, double x, double y);
void scene_keep_joint(scene_run *run, cn_joint joint);

/* ---- film.c: what a run looks like; nothing without --film ---- */

void scene_film_body(scene_run *run, int32_t type, const cn_body_def *def);
void scene_film_shape(scene_run *run, const char *kind, const float *numbers, int32_t count);
void scene_film_frame(scene_run *run);
void scene_film_metrics(const scene_run *run);

/* ---- measure.c: reading back, in double precision ---- */

typedef struct scene_motion {
	double x, y, angle; /* centre of mass, metres without far; angle in (-pi, pi] */
	double vx, vy, w;
	double mass, inertia;
} scene_motion;

typedef struct scene_momentum {
	double x, y, angular; /* angular about the scene's origin */
} scene_momentum;

scene_motion scene_read(const scene_run *run, int32_t item);
/* Kinetic plus potential above y = 0, of all items. */
double scene_energy(const scene_run *run);
scene_momentum scene_momentum_read(const scene_run *run);
/* Farthest that the two anchors of a joint are apart. */
double scene_anchor_error(const scene_run *run);
/* Deepest overlap of two boxes that the library lists as a contact (separating axes, from poses). */
double scene_penetration(const scene_run *run);
/* Largest distance of an item from where it started. */
double scene_displacement(const scene_run *run);
double scene_speed_max(const scene_run *run);
/* Number of items whose pose or velocity is not finite. */
int32_t scene_broken_count(const scene_run *run);
double scene_greater(double a, double b);

/* ---- reference.c: exact solutions ---- */

/* Period of a pendulum that swings to angle_rad, by the arithmetic-geometric mean. small_period_s: of small swings. */
double reference_period(double small_period_s, double angle_rad);

#define REFERENCE_LINKS_MAX 64
/* A chain of equal rods pinned to the origin, with a point mass at its end; angles from +x, at rest at the start.
   Integrated in minimal coordinates by RK4 with a step far below the frame's. */
typedef struct reference_chain {
	int32_t links;
	double length, mass, inertia, end_mass, gravity;
	double angle[REFERENCE_LINKS_MAX], speed[REFERENCE_LINKS_MAX];
} reference_chain;
void reference_chain_advance(reference_chain *chain, double duration_s, int32_t steps);
void reference_chain_end(const reference_chain *chain, double *x, double *y);

/* ---- cases.c and the families ---- */

extern const scene_case scene_cases[];
extern const int32_t scene_case_count;
/* NULL if there is none of this name. */
const scene_family *scene_family_find(const char *name);

extern const scene_family motion_families[], impact_families[], swing_families[], joint_families[], pile_families[], structure_families[], random_families[];
extern const int32_t motion_family_count, impact_family_count, swing_family_count, joint_family_count, pile_family_count, structure_family_count, random_family_count;

#endif
