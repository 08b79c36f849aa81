/*
 * test/families/families.h - families of random scenes: what a generator builds with, and what the harness measures.
 *
 * A generator builds a scene from a seed and does nothing else. Every random number comes from the scene's own integer
 * generator; take one number a statement, because the order in which arguments are evaluated is the compiler's. Joints
 * and shapes are recorded as they are made, and errors are measured from poses alone, in double precision: the same code
 * judges every solver and every engine that is linked under it.
 */
#ifndef CAIRN_FAMILIES_H
#define CAIRN_FAMILIES_H

#include "cairn.h"
#include <stddef.h>

#define PI 3.14159265358979323846
#define GRAVITY 10.0   /* m/s^2 */
#define POINTS_MAX 8   /* of a shape */
#define WORLD (-1)     /* a body index that stands for the world, in joints */

enum {
	SCENE_STANDS = 1,   /* ought to stay where it is: its displacement is judged */
	SCENE_NO_ENERGY = 2 /* has springs or motors: energy is measured, not judged */
};

typedef struct scene_body {
	cn_body handle;
	int32_t dynamic;
	double x, y, angle;  /* where it was made; m, rad */
	double reach;        /* farthest point of its shapes from its origin, m */
	double mass, inertia;
	double turned;       /* angle over whole turns, rad */
	/* Now: origin, rotation, centre of mass, velocity. */
	double px, py, c, s, cx, cy, vx, vy, w;
} scene_body;

typedef struct scene_shape {
	int32_t body, count, group;
	double points[POINTS_MAX][2]; /* of the core, local: 1 a disc, 2 a capsule, more a polygon; counter-clockwise */
	double radius;
	double now[POINTS_MAX][2];    /* in the world */
	double lower[2], upper[2];
} scene_shape;

/* Types of scene_joint beside those of joints: constraints on one body, whose a is the world. */
enum { ANGLE_CONSTRAINT = 100, LINE_CONSTRAINT = 101 };

typedef struct scene_joint {
	cn_joint handle;           /* 0: a constraint */
	int32_t type, a, b;        /* type -1: it was cut */
	double ax, ay, bx, by;     /* anchors, local; of the world: in the world */
	double axis_x, axis_y;     /* in a */
	double reference;          /* angle b - angle a */
	double lower, upper;       /* of an angle, a length or a translation; lower > upper: no limit */
	double arm;                /* m: what an angle's error is multiplied by */
	double ground[4], ratio, length; /* of pulleys and gears */
	double tolerance;          /* of a line constraint: free play to either side, m */
} scene_joint;

typedef struct scene {
	cn_world *world;
	uint32_t random;
	/* Of shapes made next. */
	double density, friction, restitution;
	int32_t surface; /* SURFACE_ */
	int32_t group;
	/* Of joints made next. */
	uint32_t joint_flags;
	double motor_speed, motor_max; /* motor_max > 0: a motor */
	double joint_hertz, joint_force; /* > 0: the stiffness, the greatest force and torque; then the joint's error is not measured */
	/* Of the run. */
	double dt_s, seconds;
	int32_t substeps;
	int32_t vary;  /* 1: frames of 0.5 to 1.5 times dt_s */
	uint32_t flags;
	/* What was made. */
	scene_body *bodies;
	scene_shape *shapes;
	scene_joint *joints;
	int32_t body_count, body_capacity, shape_count, shape_capacity, joint_count, joint_capacity;
	/* Pairs of bodies that a joint keeps from colliding: the lesser index times 65536 plus the greater. */
	uint32_t *apart;
	int32_t apart_count, apart_capacity;
	int32_t *order; /* shapes by their lower x */
	double drift_mps, drifted_m; /* velocity of the frame in which it was made, along x; how far that has come */
	cn_body frame;               /* a kinematic body in place of the world, where it drifts */
	double noise_m;
	uint32_t noise_random;
	/* What is done to it while it runs: meddle.c. */
	int32_t meddle;      /* 0: nothing; else a kind */
	int32_t held;        /* a body, or WORLD */
	double next_act_s, act_end_s, held_angle;
	cn_joint mouse, driven; /* the mouse's or the rod; the joint with a motor */
	char refusal[160];
} scene;

typedef struct family {
	const char *name;
	void (*build)(scene *s);
	uint32_t flags;   /* SCENE_* */
} family;

/* ---- build.c: random numbers ---- */

double pick(scene *s, double lower, double upper);
double pick_log(scene *s, double lower, double upper); /* both > 0; uniform in the logarithm */
int32_t pick_int(scene *s, int32_t lower, int32_t upper);      /* inclusive */
int32_t pick_int_log(scene *s, int32_t lower, int32_t upper);  /* inclusive, small ones more often */
int chance(scene *s, double probability);

/* ---- build.c: bodies are indices; x, y in metres, angles in radians ---- */

int32_t add_box(scene *s, int32_t type, double x, double y, double angle, double half_x, double half_y);
int32_t add_disc(scene *s, int32_t type, double x, double y, double radius);
int32_t add_capsule(scene *s, int32_t type, double x, double y, double angle, double half_length, double radius);
/* Points relative to (x, y), counter-clockwise, at most POINTS_MAX. */
int32_t add_polygon(scene *s, int32_t type, double x, double y, double angle, const double (*points)[2], int32_t count);
/* A further shape of a body, in its frame. */
void attach_box(scene *s, int32_t body, double x, double y, double angle, double half_x, double half_y);
/* A regular polygon. */
int32_t add_regular(scene *s, int32_t type, double x, double y, double angle, double radius, int32_t count);
/* Top at y = 0, 400 m wide. */
int32_t add_floor(scene *s);
/* Floor and two walls, half_width to either side, 40 m high. */
void add_pit(scene *s, double half_width);
void set_velocity(scene *s, int32_t body, double vx, double vy, double w);
/* Density at which the shapes made next, of this area, weigh mass_kg. */
void set_mass(scene *s, double mass_kg, double area_m2);

/* A rectangle of the world with a medium: its density (0: none), its drag, damping, velocity, and an acceleration beside gravity. */
void add_area(scene *s, double x, double y, double half_x, double half_y, double density, double drag, double damping, double flow_x, double lift);

/* It keeps its angle. */
void lock_rotation(scene *s, int32_t body);

/* Joints at points of the world where the bodies are now. a may be WORLD. */
void add_pin(scene *s, int32_t a, int32_t b, double x, double y);
void add_pin_limited(scene *s, int32_t a, int32_t b, double x, double y, double lower, double upper);
void add_weld(scene *s, int32_t a, int32_t b, double x, double y);
/* A rigid rod as long as the points are apart. */
void add_rod(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by);
/* A rope that is longer than the points are apart by the share slack. */
void add_rope(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by, double slack);
/* A spring with its present length at rest; it may stretch and shrink by the share give (0: any). */
void add_spring(scene *s, int32_t a, int32_t b, double ax, double ay, double bx, double by, double hertz, double damping, double give);
/* b slides along (axis_x, axis_y) in a; lower > upper: without limits. */
void add_slider(scene *s, int32_t a, int32_t b, double x, double y, double axis_x, double axis_y, double lower, double upper);
void add_wheel(scene *s, int32_t a, int32_t b, double x, double y, double axis_x, double axis_y, double hertz, double damping, double travel);
void add_gear(scene *s, int32_t a, int32_t b, double ratio);
/* A rope from the origin of a over two points to the origin of b, taut now. */
void add_pulley(scene *s, int32_t a, int32_t b, double gax, double gay, double gbx, double gby, double ratio);
/* The point (x, y) of b slides in a's slot from there to the end. */
void add_groove(scene *s, int32_t a, int32_t b, double x, double y, double end_x, double end_y);
void add_ratchet(scene *s, int32_t a, int32_t b, double click);
/* At rest now. */
void add_rotary_spring(scene *s, int32_t a, int32_t b, double hertz, double damping);
/* Drives b to where it is now in a. */
void add_motor_to(scene *s, int32_t a, int32_t b, double x, double y, double force);

/* Constraints on one body. They know no moving frame: where the scene drifts they are left out. */
void add_angle_constraint(scene *s, int32_t body, double lower, double upper);
/* The point (x, y) of the body keeps to the line through it; lower > upper: without limits. */
void add_line_constraint(scene *s, int32_t body, double x, double y, double axis_x, double axis_y, double tolerance, double lower, double upper);

/* ---- measure.c ---- */

typedef struct scene_measures {
	/* Over frames: greatest, 99th percentile, mean of the greatest joint error, m. */
	double joint_max, joint_p99, joint_mean;
	double overlap_max, overlap_p99; /* the same of the deepest overlap, m */
	double energy_pct;               /* greatest rise above the start, of m g L + kinetic energy at the start */
	double speed_max, speed_fall;    /* m/s; what a free fall through the scene could give */
	double joint_start, overlap_start; /* before the first step, m: of a sound scene both are next to 0 */
	double moved_m;                  /* greatest displacement at the end, at most MOVED_MAX_M */
	double step_ms, step_max_ms;     /* processor time */
	int32_t steps, broken, at_limit, bodies, joints;
	uint32_t flags;                  /* SCENE_* of this seed */
	int32_t refused;                 /* the engine cannot build it */
	char refusal[160];
} scene_measures;

#define MOVED_MAX_M 0.5 /* beyond, it fell: by how much is chance */

enum { PACE_OF_SEED, PACE_HITCHES, PACE_SLOW_MOTION, PACE_ALTERNATING, PACE_ANY };
enum { SURFACE_OF_FAMILY, SURFACE_BOUNCES, SURFACE_ROLLS, SURFACE_BELTS, SURFACE_SLIPS, SURFACE_STICKS, SURFACE_COUNT };

typedef struct run_settings {
	int32_t solver, substeps; /* 0 substeps: the default */
	int32_t noise;            /* 0: none; else which perturbation of 1e-5 m of all dynamic bodies */
	double drift_mps;         /* all of it moves along x, static bodies as kinematic ones; measured in its own frame */
	int32_t pace;             /* PACE_: lengths of frames, 0: the seed's */
	int32_t surface;          /* SURFACE_: what all shapes are made of, 0: the family's */
	int32_t meddle;           /* 0: nothing is done to the scene while it runs; -1: a kind that the seed draws; else that one */
} run_settings;

/* Reads poses and velocities back. Returns the number of bodies that are not finite. */
int32_t measure_read(scene *s);
double measure_joints(const scene *s);
double measure_overlap(scene *s);
double measure_energy(const scene *s);

/* ---- meddle.c ---- */

/* After the scene was built. */
void meddle_begin(scene *s, int32_t kind);
/* Before each step. */
cn_result meddle(scene *s, double now_s, double dt_s);

/* ---- run.c ---- */

scene_measures run_scene(const family *which, int32_t seed, const run_settings *settings);
double cpu_clock_s(void);

/* ---- generators ---- */

extern const family cloth_families[], mechanism_families[], machine_families[], rope_families[], figure_families[], vehicle_families[], structure_families[], heap_families[], workshop_families[], compound_families[], playground_families[], contraption_families[], guided_families[], area_families[];
extern const int32_t cloth_family_count, mechanism_family_count, machine_family_count, rope_family_count, figure_family_count, vehicle_family_count, structure_family_count, heap_family_count, workshop_family_count, compound_family_count, playground_family_count, contraption_family_count, guided_family_count, area_family_count;
#define FAMILY_COUNT(table) ((int32_t)(sizeof(table) / sizeof *(table)))

#endif
