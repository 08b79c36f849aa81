/*
 * cairn.h - Cairn, a 2D rigid-body physics library. This is the whole public C API.
 *
 * The idiom of use:
 *
 *     cn_world_def wd;  cn_world_def_init(&wd);
 *     cn_world *world;  cn_world_create(&wd, &world);
 *     cn_body_def bd;   cn_body_def_init(&bd);   bd.position_m.y = 4.0f;
 *     cn_body body;     cn_body_create(world, &bd, &body);
 *     cn_shape_def sd;  cn_shape_def_init(&sd);  sd.body = body;
 *     cn_shape_create_box(world, &sd, 0.5f, 0.5f, 0.0f, NULL);
 *     cn_world_step(world, 1.0f / 60.0f);
 *     cn_pose pose;     cn_body_get_pose(world, body, &pose);
 *     cn_world_destroy(world);
 *
 * Rules that hold for every function here (each comment adds only what is particular to it):
 *
 *  Units      metres, kilograms, seconds, radians; counter-clockwise is positive; field names end
 *             in their unit where it is not the obvious one.
 *  Handles    32 bits: index, kind, generation. 0 is never valid. A handle that is stale, of another
 *             kind or out of range gives CN_ERROR_HANDLE in every build, never undefined behaviour.
 *             A handle belongs to the world that made it; another world may or may not notice. A
 *             stale handle stays refused until, of its kind in its world, (2^20 - n) * 1023 more things
 *             have been made, n being the most that ever were alive at once: a billion in most worlds. Joints and
 *             constraints count together. The memory that this takes does not grow with what is made.
 *  Errors     a call that can fail returns cn_result. When it is not CN_OK nothing has changed, and
 *             cn_world_error_text gives one sentence with the value and the allowed range, if the
 *             function takes a non-const world (others may run on several threads: code only).
 *  Floats     NaN and infinity are refused everywhere (CN_ERROR_ARGUMENT).
 *  Pointers   NULL is refused (CN_ERROR_ARGUMENT) except where a comment allows it. Output pointers
 *             come last and are written only on CN_OK. Arrays handed out by pointer and count belong
 *             to the world and live until the next cn_world_step or cn_world_destroy.
 *  Structs    initialise definitions with their *_init function; their first field, struct_size,
 *             tells the library which version of the struct it was given. Fields are only appended.
 *  Threads    one world may be used by one thread at a time; different worlds share nothing, so any
 *             number may be used at once. Functions that take a const cn_world may be called from
 *             several threads at once while no other function runs on that world. Within cn_world_step
 *             a world may share its work among several workers (worker_count in cn_world_def); that is
 *             over when the step returns, changes no bit of any result, and the user's callbacks and
 *             memory hooks are still called one at a time.
 *  Callbacks  while a callback runs the world is locked: reading works, every function that takes
 *             a non-const cn_world fails with CN_ERROR_LOCKED.
 *  Cost       O(1) unless the comment says otherwise.
 */
#ifndef CAIRN_H
#define CAIRN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(CN_SHARED)
#ifdef CN_BUILD
#define CN_API __declspec(dllexport)
#else
#define CN_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CN_API __attribute__((visibility("default")))
#else
#define CN_API
#endif

#define CN_VERSION_MAJOR 0
#define CN_VERSION_MINOR 1
#define CN_VERSION_PATCH 0

/* Raised whenever a struct layout or a function signature changes. */
#define CN_ABI_VERSION 2

/* Most vertices a convex polygon may have. */
#define CN_POLYGON_MAX_VERTICES 16
/* Longest body name in bytes, without the terminating zero. */
#define CN_NAME_MAX_BYTES 63
/* Most planes of cn_mover_solve and cn_mover_clip. */
#define CN_PLANES_MAX 64
/* Most workers of a world. */
#define CN_WORKERS_MAX 64
/* Most bodies, shapes or joints alive at once in one world (20 bits of index). */
#define CN_MAX_HANDLES 1048575

/* ------------------------------------------------------------------ basic types */

typedef int32_t cn_result;
enum {
	CN_OK = 0,
	CN_ERROR_ARGUMENT = -1, /* a value is NaN, infinite, out of range, NULL or degenerate */
	CN_ERROR_HANDLE = -2,   /* a handle is stale, of the wrong kind or 0 */
	CN_ERROR_MEMORY = -3,   /* the allocator or the fixed block has no room */
	CN_ERROR_LOCKED = -4,   /* called from inside a callback */
	CN_ERROR_CAPACITY = -5, /* more than CN_MAX_HANDLES things, or an output array too small */
	CN_ERROR_STATE = -6,    /* the object is in a state in which this makes no sense */
	CN_ERROR_INTERNAL = -7, /* cn_world_validate found a broken invariant: a bug in Cairn */
	CN_ERROR_FORMAT = -8    /* bytes that should be a saved world are not, or are damaged */
};

typedef uint32_t cn_body;
typedef uint32_t cn_shape;
typedef uint32_t cn_joint;
typedef uint32_t cn_constraint;
typedef struct cn_world cn_world;

typedef struct cn_vec2 {
	float x;
	float y;
} cn_vec2;

/* Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of these can
   be uploaded to a GPU as it is. */
typedef struct cn_pose {
	cn_vec2 position_m;
	float cosine;
	float sine;
} cn_pose;

typedef struct cn_velocity {
	cn_vec2 linear_mps; /* of the centre of mass */
	float angular_radps;
} cn_velocity;

typedef struct cn_aabb {
	cn_vec2 lower_m;
	cn_vec2 upper_m;
} cn_aabb;

typedef struct cn_mass_data {
	float mass_kg;
	float inertia_kgm2; /* about the centre of mass */
	cn_vec2 center_m;   /* in the body's local frame */
} cn_mass_data;

/* ------------------------------------------------------------------ library */

/* Version as major * 1000000 + minor * 1000 + patch. */
CN_API int32_t cn_version(void);
/* CN_ABI_VERSION of the library that was linked; a binding compares it with its own. */
CN_API int32_t cn_abi_version(void);
/* Static English text for a result code, never NULL. */
CN_API const char *cn_result_text(cn_result result);

enum {
	CN_TYPE_VEC2 = 0,
	CN_TYPE_POSE = 1,
	CN_TYPE_VELOCITY = 2,
	CN_TYPE_AABB = 3,
	CN_TYPE_MASS_DATA = 4,
	CN_TYPE_WORLD_DEF = 5,
	CN_TYPE_BODY_DEF = 6,
	CN_TYPE_SHAPE_DEF = 7,
	CN_TYPE_CIRCLE = 8,
	CN_TYPE_CAPSULE = 9,
	CN_TYPE_EDGE = 10,
	CN_TYPE_POLYGON = 11,
	CN_TYPE_CHAIN = 12,
	CN_TYPE_FILTER = 13,
	CN_TYPE_MATERIAL = 14,
	CN_TYPE_MANIFOLD_POINT = 15,
	CN_TYPE_MANIFOLD = 16,
	CN_TYPE_CONTACT_EVENT = 17,
	CN_TYPE_BODY_MOVED = 18,
	CN_TYPE_REVOLUTE_DEF = 19,
	CN_TYPE_DISTANCE_DEF = 20,
	CN_TYPE_COUNTERS = 21,
	CN_TYPE_PROFILE = 22,
	CN_TYPE_MEMORY_STATS = 23,
	CN_TYPE_SENSOR_EVENT = 24,
	CN_TYPE_UPDATE_REPORT = 25,
	CN_TYPE_DEBUG_DRAW = 26,
	CN_TYPE_QUERY_FILTER = 27,
	CN_TYPE_RAY = 28,
	CN_TYPE_RAY_HIT = 29,
	CN_TYPE_CLOSEST = 30,
	CN_TYPE_EXPLOSION_DEF = 31,
	CN_TYPE_FIXED_DEF = 32,
	CN_TYPE_PRISMATIC_DEF = 33,
	CN_TYPE_WHEEL_DEF = 34,
	CN_TYPE_MOTOR_DEF = 35,
	CN_TYPE_MOUSE_DEF = 36,
	CN_TYPE_GEAR_DEF = 37,
	CN_TYPE_PULLEY_DEF = 38,
	CN_TYPE_RATCHET_DEF = 39,
	CN_TYPE_ROTARY_SPRING_DEF = 40,
	CN_TYPE_GROOVE_DEF = 41,
	CN_TYPE_FILTER_JOINT_DEF = 42,
	CN_TYPE_JOINT_BASE = 43,
	CN_TYPE_JOINT_EVENT = 44,
	CN_TYPE_ANGLE_CONSTRAINT_DEF = 45,
	CN_TYPE_LINE_CONSTRAINT_DEF = 46,
	CN_TYPE_ISLAND_REPORT = 47,
	CN_TYPE_DISTANCE = 48,
	CN_TYPE_SWEEP = 49,
	CN_TYPE_IMPACT = 50,
	CN_TYPE_PLANE = 51,
	CN_TYPE_MOVER_DEF = 52,
	CN_TYPE_MOVER = 53,
	CN_TYPE_COUNT = 54
};
/* sizeof the struct named by a CN_TYPE_ constant, 0 for an unknown one: bindings check themselves. */
CN_API int32_t cn_sizeof(int32_t type);

/* ------------------------------------------------------------------ world */

/* Memory hooks. Return NULL when there is none; align is a power of two, at most 64. Called only
   from inside functions that take a non-const world. */
typedef void *cn_alloc_fn(uint64_t bytes, uint32_t align, void *user);
typedef void cn_free_fn(void *memory, uint64_t bytes, void *user);

/* A user's own task system, for worlds with worker_count of 2 or more; without one they start threads of their own.
   Within cn_world_step a world that has enough to do asks for help with enqueue, works itself, and then calls finish;
   some 3 to 10 times a step. It does not matter where tasks run, in which order, or whether side by side.

   cn_task_fn     the library's: call it for ranges [begin, end) that cover 0 to item_count - 1, each item once, on any
                  threads. A call may last as long as the step, and may wait for others that have already begun, never
                  for one that has not. Its thread must have the floating-point mode of the one that steps.
   cn_enqueue_fn  the user's: makes a task of item_count items (one less than worker_count) in ranges of at least
                  min_range, and returns what finish knows it by. It may also run all of it at once, and must
                  do so if it cannot keep it; NULL then says that there is nothing to finish.
   cn_finish_fn   the user's: returns when every item of the task has run. Called once for each enqueue that did not
                  return NULL, in the thread that enqueued. It may run items itself.

   enqueue and finish are called in the thread that steps, while no callback runs, and must not call the library. */
typedef void cn_task_fn(int32_t begin, int32_t end, void *context);
typedef void *cn_enqueue_fn(cn_task_fn *task, void *context, int32_t item_count, int32_t min_range, void *user);
typedef void cn_finish_fn(void *task, void *user);

enum {
	CN_WORLD_SLEEP = 1u << 0,       /* islands at rest fall asleep (default on) */
	CN_WORLD_WARM_START = 1u << 1,  /* start solving from the last step's impulses (default on) */
	CN_WORLD_PROFILE = 1u << 2,     /* measure cn_profile (default off: reading a clock costs time) */
	CN_WORLD_CONTINUOUS = 1u << 3   /* fast bodies stop at what they would pass through (default on) */
};

enum {
	CN_SOLVER_AUTO = 0,      /* soft constraints with substeps; directly solved where that is worth its cost */
	CN_SOLVER_SOFT = 1,      /* soft contact and joint constraints with substeps alone (Catto, Solver2D, 2024) */
	CN_SOLVER_DIRECT = 2,    /* directly solved wherever it can be, whatever it costs: all joints, all piles without joints */
	CN_SOLVER_SEQUENTIAL = 3 /* the twelve steps of the paper, once a step: the baseline; see README on its weaknesses */
};

enum {
	CN_BROADPHASE_SWEEP = 0, /* tiled sweep-and-prune */
	CN_BROADPHASE_TREE = 1   /* dynamic AABB tree: for worlds of very mixed sizes with many region queries */
};

typedef struct cn_world_def {
	uint32_t struct_size;
	uint32_t flags;                   /* CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS */
	cn_vec2 gravity_mps2;             /* default (0, -10) */
	float length_unit_m;              /* a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1 */
	int32_t solver;                   /* CN_SOLVER_*; default CN_SOLVER_AUTO */
	int32_t broadphase;               /* CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP */
	int32_t substep_count;            /* 1 to 64; default 4 */
	float accuracy_m;                 /* CN_SOLVER_AUTO works towards errors below this, >= 0; default 0.005 x length unit */
	int32_t work_budget;              /* ... but spends no more than this on direct solving in a step, in blocks (joints,
	                                     contacts and the fill between them) factored, substeps included: some 10 ns each;
	                                     0 to 1e9; default 0: no bound but those of single islands */
	float restitution_threshold_mps;  /* slower impacts do not bounce, >= 0; default 1 x length unit */
	float push_speed_max_mps;         /* fastest speed at which overlap is pushed apart, > 0; default 3 x length unit */
	float linear_speed_max_mps;       /* > 0; default 400 x length unit */
	float angular_speed_max_radps;    /* > 0; default 400 */
	float sleep_speed_mps;            /* bodies slower than this may sleep, >= 0; default 0.05 x length unit */
	float sleep_delay_s;              /* ... after this long, >= 0; default 0.5 */
	int32_t body_capacity;            /* hints for a growing world, exact for a fixed one; >= 0; default 0 */
	int32_t shape_capacity;           /* counts every edge of a chain */
	int32_t contact_capacity;
	int32_t joint_capacity;           /* counts constraints too */
	uint64_t user_data;
	uint64_t memory_bytes;            /* size of memory; 0: use alloc and free */
	void *memory;                     /* NULL, or one block aligned to 64 bytes that the world lives in, whole */
	cn_alloc_fn *alloc;               /* NULL: malloc; set both or none */
	cn_free_fn *free;
	void *allocator_user;
	cn_enqueue_fn *enqueue;           /* NULL: threads of the world's own; set both or none */
	cn_finish_fn *finish;
	void *task_user;
	int32_t worker_count;             /* how many may work on a step at once, the calling thread one of them; 0 to CN_WORKERS_MAX;
	                                     default 0: as 1, which starts no threads and enqueues no tasks */
	uint32_t reserved;
} cn_world_def;

/* Defaults as given beside the fields (those that scale with the length unit are stored as 0 and
   resolved by cn_world_create: 0 means the default there). */
CN_API void cn_world_def_init(cn_world_def *def);
/* Says in one sentence what is wrong with a definition; writes at most text_bytes bytes including
   the terminating zero; text may be NULL when text_bytes is 0. */
CN_API cn_result cn_world_def_check(const cn_world_def *def, char *text, int32_t text_bytes);
/* Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here. */
CN_API cn_result cn_world_bytes_needed(const cn_world_def *def, uint64_t *out_bytes);
/* Threads that cannot be started are CN_ERROR_MEMORY. A world's memory holds some 150 bytes for each; their stacks, and
   whatever else a thread needs, are the system's, for a world in a caller's block too. A library built with CN_NO_THREADS,
   or on a system whose threads it does not know, makes the same world without them: see cn_world_get_worker_count. */
CN_API cn_result cn_world_create(const cn_world_def *def, cn_world **out_world);
/* NULL is allowed. Frees everything; a world in a caller's block just stops using it. Its own threads have ended when
   this returns. Not from callbacks. */
CN_API void cn_world_destroy(cn_world *world);
/* One fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion, and so does less than 1e-9.
   Cost grows with the number of awake bodies and their contacts. */
CN_API cn_result cn_world_step(cn_world *world, float dt_s);
/* One sentence on the last call that failed on this world; "" if none did. world may be NULL. */
CN_API const char *cn_world_error_text(const cn_world *world);

/* A change wakes every body: O(bodies) then. */
CN_API cn_result cn_world_set_gravity(cn_world *world, float gravity_x_mps2, float gravity_y_mps2);
CN_API cn_result cn_world_get_gravity(const cn_world *world, cn_vec2 *out_mps2);
/* 1 to 64; more substeps are stiffer and dearer. */
CN_API cn_result cn_world_set_substep_count(cn_world *world, int32_t count);
CN_API cn_result cn_world_get_substep_count(const cn_world *world, int32_t *out_count);
/* CN_SOLVER_*, from the next step on. A world in a caller's block has scratch memory for the solver that it was made
   with: a dearer one may have to do without direct solving there (CN_WARNING_FRAME_MEMORY). */
CN_API cn_result cn_world_set_solver(cn_world *world, int32_t solver);
CN_API cn_result cn_world_get_solver(const cn_world *world, int32_t *out_solver);
/* Both as in cn_world_def; 0 metres: the default. get gives the accuracy in metres that this stands for. */
CN_API cn_result cn_world_set_accuracy(cn_world *world, float accuracy_m, int32_t work_budget);
CN_API cn_result cn_world_get_accuracy(const cn_world *world, float *out_accuracy_m, int32_t *out_work_budget);
/* Workers that a step may have: 1, or worker_count where the library can have several. */
CN_API cn_result cn_world_get_worker_count(const cn_world *world, int32_t *out_count);
/* Replaces the CN_WORLD_ flags. Turning CN_WORLD_SLEEP off wakes everything: O(bodies) then. */
CN_API cn_result cn_world_set_flags(cn_world *world, uint32_t flags);
CN_API cn_result cn_world_get_flags(const cn_world *world, uint32_t *out_flags);
/* Metres a second, >= 0. */
CN_API cn_result cn_world_set_restitution_threshold(cn_world *world, float speed_mps);
/* Both > 0: bodies are slowed to these at the end of each step (direction kept). */
CN_API cn_result cn_world_set_speed_limits(cn_world *world, float linear_mps, float angular_radps);
/* speed_mps >= 0, delay_s >= 0. */
CN_API cn_result cn_world_set_sleep(cn_world *world, float speed_mps, float delay_s);
CN_API cn_result cn_world_set_user_data(cn_world *world, uint64_t user_data);
CN_API cn_result cn_world_get_user_data(const cn_world *world, uint64_t *out_user_data);

/* Handles of everything alive, in a fixed order (by slot). Writes at most capacity of them (out may
   be NULL when capacity is 0) and always sets *out_count to how many there are. O(slots). */
CN_API cn_result cn_world_get_bodies(const cn_world *world, cn_body *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_world_get_shapes(const cn_world *world, cn_shape *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_world_get_joints(const cn_world *world, cn_joint *out, int32_t capacity, int32_t *out_count);

typedef struct cn_counters {
	int32_t bodies;
	int32_t bodies_awake;        /* dynamic and kinematic bodies that are simulated */
	int32_t shapes;
	int32_t proxies;             /* boxes in the broadphase: one a shape, one an edge of a chain */
	int32_t contacts;            /* pairs whose fat boxes overlap */
	int32_t contacts_awake;
	int32_t contacts_touching;   /* pairs that share a manifold, asleep or awake */
	int32_t joints;              /* and constraints */
	int32_t joints_awake;
	int32_t islands;             /* awake and asleep, of two or more bodies or one */
	int32_t islands_awake;
	int32_t colors_used;         /* groups of contacts that are solved without sharing a body */
	int32_t overflow_contacts;   /* contacts that fit no colour and are solved one by one */
	int32_t broadphase_tiles;
	uint32_t steps;              /* steps taken since creation, modulo 2^32 */
	/* What the last step could not do for want of memory; 0 when all is well. It tries again. */
	uint32_t warnings;           /* CN_WARNING_* */
	int32_t pairs_not_added;
	int32_t events_not_reported;
	int32_t islands_direct;      /* of several bodies, solved directly in the last step, contacts and all */
	int32_t direct_work;         /* planned for all that is solved directly in it, in the units of work_budget; at most 2^31 - 1 */
	int32_t islands_unsolved;    /* of several bodies, left to soft constraints for a time because no solution was found: CN_TIER_REASON_NO_SET */
} cn_counters;
enum {
	CN_WARNING_CONTACT_MEMORY = 1u << 0, /* new contacts were not added: pairs_not_added */
	CN_WARNING_FRAME_MEMORY = 1u << 1,   /* the step worked around missing scratch memory */
	CN_WARNING_EVENT_MEMORY = 1u << 2    /* events_not_reported */
};
/* O(bodies + islands). */
CN_API cn_result cn_world_get_counters(const cn_world *world, cn_counters *out);

/* How an island is solved. Joints of either may be solved together with their neighbours. */
enum {
	CN_TIER_SOFT = 0,   /* contacts by soft constraints */
	CN_TIER_DIRECT = 1, /* contacts and joints in one system, exactly */
	CN_TIER_FREE = 2    /* nothing touches it and it has no joints: nothing to solve */
};
/* Why. */
enum {
	CN_TIER_REASON_NONE = 0,        /* nothing is wrong */
	CN_TIER_REASON_SETTLING = 1,    /* direct: nothing is wrong any more, but not yet for long enough */
	CN_TIER_REASON_NEW_CONTACT = 2, /* direct: a contact began to bear where much is borne or things lean */
	CN_TIER_REASON_OVERLAP = 3,     /* direct: an overlap that the accuracy does not allow */
	CN_TIER_REASON_JOINT = 4,       /* no longer given */
	CN_TIER_REASON_STRESSED = 5,    /* direct: something bears so many times its weight that soft contacts would give way */
	CN_TIER_REASON_SOLVER = 6,      /* the world's solver is not CN_SOLVER_AUTO */
	CN_TIER_REASON_OVERRIDE = 7,    /* a body's own solver: cn_body_set_solver */
	CN_TIER_REASON_ALONE = 8,       /* soft: a single body */
	CN_TIER_REASON_MOVING = 9,      /* soft: something is wrong, but it moves too fast */
	CN_TIER_REASON_CROWDED = 10,    /* soft: something is wrong, but it or the sum of such islands is too large */
	CN_TIER_REASON_WORK = 11,       /* soft for a time: its system is beyond the limit of work or the work_budget */
	CN_TIER_REASON_KIND = 12,       /* soft for a time: restitution, a conveyor, rolling resistance or a locked axis */
	CN_TIER_REASON_NO_SET = 13,     /* soft for a time: no solution was found for its contacts; it stays awake while it moves at all */
	CN_TIER_REASON_MEMORY = 14,     /* soft: no scratch memory (CN_WARNING_FRAME_MEMORY) */
	CN_TIER_REASON_JOINTED = 15     /* soft contacts: something is wrong, but it has joints (which are solved directly) */
};
typedef struct cn_island_report {
	cn_body body;        /* one of it: of least slot */
	int32_t bodies;
	int32_t contacts;    /* touching */
	int32_t joints;      /* and constraints */
	int32_t tier;        /* CN_TIER_*, after the last step */
	int32_t reason;      /* CN_TIER_REASON_* */
	int32_t substeps;    /* of the world, 1 while it rests, as after the last step that took time; joints that swing freely
	                        may take more */
	float residual_m;    /* where bodies are now: largest overlap, or gap of a rigid joint (angles times its bodies' extent);
	                        joints that may give way (stiffness_hertz, force_max_N, torque_max_Nm) do not count */
} cn_island_report;
/* Of every awake island, as cn_counters.islands_awake counts them: those of several bodies first, in a deterministic
   order, then bodies alone. Writes at most capacity; *out_count is how many there are. Costs nothing when it is not
   called. O(bodies + what touches in the islands written). */
CN_API cn_result cn_world_get_islands(const cn_world *world, cn_island_report *out, int32_t capacity, int32_t *out_count);

/* Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set. */
typedef struct cn_profile {
	float step_s;
	float wake_s;
	float broadphase_s;
	float narrowphase_s;
	float islands_s;
	float prepare_s;
	float substeps_s;
	float finalize_s;
	float events_s;
	float sleep_s;
} cn_profile;
CN_API cn_result cn_world_get_profile(const cn_world *world, cn_profile *out);

/* Memory, in bytes. The frame arena is the stack allocator whose entries live within one step; the
   block allocator serves small variable-size pieces from free lists of size classes. */
typedef struct cn_memory_stats {
	uint64_t bytes_in_use;         /* taken from the user's allocator or carved from the fixed block */
	uint64_t bytes_peak;
	uint64_t allocator_calls;      /* calls of the user's alloc (or of the fixed block's) since creation */
	uint64_t arena_capacity;
	uint64_t arena_peak;           /* most bytes in use at once since creation */
	uint64_t arena_fallbacks;      /* entries that did not fit and came from the allocator, since creation */
	uint64_t blocks_capacity;      /* bytes in chunks */
	uint64_t blocks_in_use;
	uint64_t blocks_large;         /* blocks above the largest class, served by the allocator */
} cn_memory_stats;
CN_API cn_result cn_world_get_memory_stats(const cn_world *world, cn_memory_stats *out);

/* 64-bit hash (FNV-1a, Fowler/Noll/Vo) of every body's pose, velocity and sleep state and every
   contact's impulses in handle order: equal for equal histories on every compiler, CPU and thread
   count. O(bodies + contacts). */
CN_API cn_result cn_world_hash(const cn_world *world, uint64_t *out_hash);
/* Checks every invariant between the tables. CN_OK, or CN_ERROR_INTERNAL with a sentence in text
   (at most text_bytes bytes with the zero; may be NULL when text_bytes is 0). O(everything). */
CN_API cn_result cn_world_validate(const cn_world *world, char *text, int32_t text_bytes);

/* ------------------------------------------------------------------ saving and restoring */

/* Rollback: a world's whole state between two steps, in the caller's memory. A world that is restored goes on bit for bit as
   it went on after it was saved, given the same calls: bodies, shapes, joints, contacts with their impulses, what sleeps, forces set
   for the next step, settings, the events of the last step and those that are pending, time that cn_world_update owes,
   names, user data. The same calls also give the same handles again. What a world was made of stays its own:
   memory, workers, callbacks. So does the sentence of cn_world_error_text.

   A save is of one version of the library on one kind of machine, for the time that a program runs: it is neither a file
   format nor safe against bytes that were made up. Damage is noticed by a checksum. */

/* Bytes that cn_world_save needs now. From callbacks CN_ERROR_LOCKED. O(slots). */
CN_API cn_result cn_world_save_size(const cn_world *world, uint64_t *out_bytes);
/* Writes the state to out, which may have any alignment, and how many bytes that took to out_bytes (may be NULL). capacity: bytes
   that out has; too few are CN_ERROR_CAPACITY. From callbacks CN_ERROR_LOCKED. O(memory of the world), about 1 KB a body. */
CN_API cn_result cn_world_save(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes);
/* Puts a state back: into the world that was saved, or one that was made by the same definition (broadphase, length unit, whether it
   lives in a caller's block; else CN_ERROR_STATE). bytes: as many as cn_world_save wrote. CN_ERROR_FORMAT: not a save of this
   version and machine, or damaged. CN_ERROR_MEMORY: no room for what was alive then; a growing world takes what it needs, a
   world in a caller's block has room for what it had. Arrays handed out before are void. O(memory of the world).

   Handles of what was alive when the world was saved are valid again, also of what was destroyed since. Those made since are refused, until
   the same handle is given to something new: with the same calls to the same thing. A game rolls its own state back
   with the world, and so keeps none of them. */
CN_API cn_result cn_world_restore(cn_world *world, const void *save, uint64_t bytes);

/* ------------------------------------------------------------------ bodies */

enum {
	CN_BODY_STATIC = 0,    /* never moves, infinite mass */
	CN_BODY_KINEMATIC = 1, /* moves by its velocity alone, infinite mass */
	CN_BODY_DYNAMIC = 2
};

enum {
	CN_BODY_LOCK_X = 1u << 0,          /* the centre of mass keeps its world x */
	CN_BODY_LOCK_Y = 1u << 1,
	CN_BODY_LOCK_ROTATION = 1u << 2,
	CN_BODY_BULLET = 1u << 3,          /* continuous collision against dynamic bodies too (stored) */
	CN_BODY_ENABLED = 1u << 4,         /* takes part in the simulation (default on) */
	CN_BODY_SLEEP = 1u << 5,           /* may fall asleep (default on) */
	CN_BODY_AWAKE = 1u << 6            /* starts awake (default on) */
};

typedef struct cn_body_def {
	uint32_t struct_size;
	int32_t type;                  /* CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic */
	cn_vec2 position_m;            /* of the origin; |x|, |y| <= 1e6 x length unit */
	float angle_rad;               /* |angle| <= 1e4 */
	cn_vec2 linear_velocity_mps;   /* of the centre of mass; both velocities count only with CN_BODY_AWAKE: what sleeps does not move */
	float angular_velocity_radps;
	float linear_damping_per_s;    /* v' = -damping v; >= 0, default 0 */
	float angular_damping_per_s;
	float gravity_scale;           /* default 1 */
	float sleep_speed_mps;         /* >= 0; default 0: the world's */
	uint32_t flags;                /* CN_BODY_*; default ENABLED | SLEEP | AWAKE */
	int32_t solver;                /* as in cn_body_set_solver; default CN_SOLVER_AUTO */
	uint64_t user_data;
	const char *name;              /* NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied */
} cn_body_def;

CN_API void cn_body_def_init(cn_body_def *def);
CN_API cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body);
/* count bodies from an array of definitions; all of them or none. O(count). */
CN_API cn_result cn_body_create_many(cn_world *world, const cn_body_def *defs, int32_t count, cn_body *out_bodies);
/* Also destroys its shapes, contacts, joints and constraints; touching contacts get their leave event, joints
   and constraints theirs (cn_world_joint_events). */
CN_API cn_result cn_body_destroy(cn_world *world, cn_body body);
/* Destroys all or, if any handle is bad or appears twice, none. */
CN_API cn_result cn_body_destroy_many(cn_world *world, const cn_body *bodies, int32_t count);
/* 1 if the handle names a body that is alive in this world, else 0 (also for a NULL world). */
CN_API int32_t cn_body_is_valid(const cn_world *world, cn_body body);

/* Changing the type ends the body's contacts (those that still overlap begin again in the next step),
   its forces and any mass override, and wakes it; a body made static stops. CN_ERROR_STATE if a joint
   would be left without a dynamic body. O(contacts + joints + shapes). */
CN_API cn_result cn_body_set_type(cn_world *world, cn_body body, int32_t type);
CN_API cn_result cn_body_get_type(const cn_world *world, cn_body body, int32_t *out_type);
/* Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which is cn_body_set_awake's and is ignored
   here. A body without CN_BODY_ENABLED keeps its shapes but collides with nothing and does not move;
   its contacts end, its joints rest. O(contacts + joints + shapes) when that changes. */
CN_API cn_result cn_body_set_flags(cn_world *world, cn_body body, uint32_t flags);
/* CN_BODY_AWAKE is set in the result when the body is awake. */
CN_API cn_result cn_body_get_flags(const cn_world *world, cn_body body, uint32_t *out_flags);
/* 0 puts the body and everything connected to it to sleep, at rest; anything else wakes. Does nothing
   to static and disabled bodies. O(island). */
CN_API cn_result cn_body_set_awake(cn_world *world, cn_body body, int32_t awake);

/* Teleport: origin and angle; velocities stay. Contacts that are no longer near end (the next step
   reports it). Wakes the body and what is near it. O(contacts + shapes). */
CN_API cn_result cn_body_set_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad);
CN_API cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out);
/* In (-pi, pi]. */
CN_API cn_result cn_body_get_angle(const cn_world *world, cn_body body, float *out_rad);
/* World position of the centre of mass. */
CN_API cn_result cn_body_get_center(const cn_world *world, cn_body body, cn_vec2 *out_m);
/* Static bodies refuse this with CN_ERROR_STATE. Wakes when not zero. */
CN_API cn_result cn_body_set_velocity(cn_world *world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps);
CN_API cn_result cn_body_get_velocity(const cn_world *world, cn_body body, cn_velocity *out);
/* Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it to this pose, the shorter way
   round, up to rounding and the world's speed limits: what stands on it or is in its way moves along, as nothing does with
   cn_body_set_pose. It goes on with that velocity: call it before every step, or stop it after. */
CN_API cn_result cn_body_set_target_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s);
/* Velocity of the body's material at a world point. */
CN_API cn_result cn_body_get_velocity_at(const cn_world *world, cn_body body, float point_x_m, float point_y_m, cn_vec2 *out_mps);
CN_API cn_result cn_body_get_world_point(const cn_world *world, cn_body body, float local_x_m, float local_y_m, cn_vec2 *out_m);
CN_API cn_result cn_body_get_local_point(const cn_world *world, cn_body body, float world_x_m, float world_y_m, cn_vec2 *out_m);
/* Union of its shapes' boxes, without margin; the origin as a point if it has none. O(shapes). */
CN_API cn_result cn_body_get_aabb(const cn_world *world, cn_body body, cn_aabb *out);

/* Forces and torques act for the next step only and are then cleared. All of these wake a dynamic
   body and do nothing to static, kinematic and disabled ones (CN_OK). Sums of forces and velocities
   after impulses must stay finite (CN_ERROR_ARGUMENT). */
CN_API cn_result cn_body_apply_force(cn_world *world, cn_body body, float force_x_N, float force_y_N);
CN_API cn_result cn_body_apply_force_at(cn_world *world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m);
CN_API cn_result cn_body_apply_torque(cn_world *world, cn_body body, float torque_Nm);
CN_API cn_result cn_body_apply_impulse(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns);
CN_API cn_result cn_body_apply_impulse_at(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m);
CN_API cn_result cn_body_apply_angular_impulse(cn_world *world, cn_body body, float impulse_Nms);

/* Sums over the attached shapes unless overridden. A dynamic body whose shapes have no mass weighs 1 kg
   (and, having no shape, does not rotate). */
CN_API cn_result cn_body_get_mass_data(const cn_world *world, cn_body body, cn_mass_data *out);
/* Override for a dynamic body (others: CN_ERROR_STATE): mass_kg from 1e-20 to 1e20, inertia_kgm2 0 (never
   rotates) or from 1e-35 to 1e35. Kept until cn_body_reset_mass_data or until the type changes. */
CN_API cn_result cn_body_set_mass_data(cn_world *world, cn_body body, const cn_mass_data *mass);
CN_API cn_result cn_body_reset_mass_data(cn_world *world, cn_body body);
/* Both >= 0. */
CN_API cn_result cn_body_set_damping(cn_world *world, cn_body body, float linear_per_s, float angular_per_s);
CN_API cn_result cn_body_get_damping(const cn_world *world, cn_body body, float *out_linear_per_s, float *out_angular_per_s);
CN_API cn_result cn_body_set_gravity_scale(cn_world *world, cn_body body, float scale);
CN_API cn_result cn_body_get_gravity_scale(const cn_world *world, cn_body body, float *out_scale);
/* >= 0; 0 restores the world's. */
CN_API cn_result cn_body_set_sleep_speed(cn_world *world, cn_body body, float speed_mps);
/* How the island of a dynamic body is solved, in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): as the
   world chooses. _SOFT: never directly, contacts and all, whatever its other bodies ask for. _DIRECT: always, however
   fast it moves, as far as its contacts can be, and within the work_budget. From the next step on; does not wake. */
CN_API cn_result cn_body_set_solver(cn_world *world, cn_body body, int32_t solver);
CN_API cn_result cn_body_get_solver(const cn_world *world, cn_body body, int32_t *out_solver);
CN_API cn_result cn_body_set_user_data(cn_world *world, cn_body body, uint64_t user_data);
CN_API cn_result cn_body_get_user_data(const cn_world *world, cn_body body, uint64_t *out_user_data);
/* NULL or "" removes the name. */
CN_API cn_result cn_body_set_name(cn_world *world, cn_body body, const char *name);
/* "" if it has none; valid until the name changes or the body is destroyed. */
CN_API cn_result cn_body_get_name(const cn_world *world, cn_body body, const char **out_name);

/* As cn_world_get_bodies, for one body. O(shapes), O(joints). */
CN_API cn_result cn_body_get_shapes(const cn_world *world, cn_body body, cn_shape *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_body_get_joints(const cn_world *world, cn_body body, cn_joint *out, int32_t capacity, int32_t *out_count);

/* Bulk forms: bodies NULL means every body in the order of cn_world_get_bodies, of which there must
   be exactly count. stride_bytes 0 means tightly packed. One bad handle fails the whole call. O(count). */
CN_API cn_result cn_world_read_poses(const cn_world *world, const cn_body *bodies, int32_t count, cn_pose *out);
CN_API cn_result cn_world_read_poses_strided(const cn_world *world, const cn_body *bodies, int32_t count, void *out, int32_t stride_bytes);
CN_API cn_result cn_world_read_velocities(const cn_world *world, const cn_body *bodies, int32_t count, cn_velocity *out);
/* cn_body_set_velocity for many; nothing is written if one is bad. Static bodies take zero only. */
CN_API cn_result cn_world_write_velocities(cn_world *world, const cn_body *bodies, int32_t count, const cn_velocity *velocities);

typedef struct cn_body_moved {
	cn_pose pose;
	uint64_t user_data;
	cn_body body;
	uint32_t fell_asleep; /* 1 in the step in which it fell asleep */
} cn_body_moved;
/* Bodies whose pose changed in the last step, and those that fell asleep in it, without the ones
   destroyed since. Built on the first call after a step: O(awake bodies) then. */
CN_API cn_result cn_world_moved(cn_world *world, const cn_body_moved **out_moved, int32_t *out_count);

/* ------------------------------------------------------------------ shapes */

enum {
	CN_SHAPE_CIRCLE = 0,
	CN_SHAPE_CAPSULE = 1,
	CN_SHAPE_POLYGON = 2,
	CN_SHAPE_EDGE = 3,
	CN_SHAPE_CHAIN = 4
};

/* Two shapes collide when group is equal and not 0: positive yes, negative no; otherwise when each
   one's category has a bit in the other's mask. */
typedef struct cn_filter {
	uint64_t category; /* default 1 */
	uint64_t mask;     /* default all ones */
	int32_t group;     /* default 0 */
	uint32_t reserved;
} cn_filter;

/* How two materials' numbers become a pair's. When the two ask for different rules, the later one of
   this list is taken. */
enum {
	CN_MIX_AVERAGE = 0,
	CN_MIX_GEOMETRIC = 1, /* square root of the product; default for friction */
	CN_MIX_MINIMUM = 2,
	CN_MIX_MULTIPLY = 3,
	CN_MIX_MAXIMUM = 4    /* default for restitution */
};

typedef struct cn_material {
	float static_friction;    /* coefficient while sticking, [0, 100], default 0.6 */
	float dynamic_friction;   /* coefficient while sliding, [0, static_friction], default 0.6 */
	float restitution;        /* [0, 1], default 0 */
	float rolling_resistance; /* metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0 */
	float tangent_speed_mps;  /* conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; default 0 */
	int32_t friction_mix;     /* CN_MIX_* */
	int32_t restitution_mix;  /* CN_MIX_* */
	uint32_t reserved;
} cn_material;

enum {
	CN_SHAPE_SENSOR = 1u << 0,       /* reports who enters and leaves and touches nothing; see cn_world_sensor_events */
	CN_SHAPE_SENSOR_SEEN = 1u << 1,  /* queries see this sensor (default: they do not) */
	CN_SHAPE_ONE_WAY = 1u << 2,      /* collides only with what comes from the side its local +y axis points to */
	CN_SHAPE_PRE_SOLVE = 1u << 3     /* its contacts are shown to the pre-solve callback */
};

enum {
	CN_EVENT_CREATED = 0,   /* the fat boxes of two shapes began to overlap */
	CN_EVENT_ENTER = 1,     /* they began to touch */
	CN_EVENT_STAY = 2,      /* they still touch */
	CN_EVENT_LEAVE = 3,     /* they stopped touching, or one went away */
	CN_EVENT_DESTROYED = 4, /* the fat boxes no longer overlap, or one went away */
	CN_EVENT_KINDS = 5
};

typedef struct cn_shape_def {
	uint32_t struct_size;
	cn_body body;             /* 0: create unattached, for cn_shape_attach */
	cn_vec2 offset_m;         /* of the shape in the body's local frame */
	float angle_rad;
	float density_kgpm2;      /* >= 0, giving 0 or 1e-20 to 1e20 kg; default 1 */
	cn_material material;
	cn_filter filter;
	uint32_t event_mask;      /* bit 1 << CN_EVENT_*; a pair reports what either shape asks for; default ENTER and LEAVE */
	uint32_t flags;           /* CN_SHAPE_SENSOR ...; default 0 */
	uint64_t user_data;
} cn_shape_def;

typedef struct cn_circle {
	cn_vec2 center_m;
	float radius_m;
} cn_circle;

/* All points within radius_m of the segment. */
typedef struct cn_capsule {
	cn_vec2 a_m;
	cn_vec2 b_m;
	float radius_m;
} cn_capsule;

/* A two-sided segment without mass. */
typedef struct cn_edge {
	cn_vec2 a_m;
	cn_vec2 b_m;
} cn_edge;

/* Convex; counter-clockwise or clockwise in, always stored counter-clockwise. */
typedef struct cn_polygon {
	int32_t count;   /* 3 to CN_POLYGON_MAX_VERTICES */
	float radius_m;  /* rounding added outside of the points, >= 0 */
	cn_vec2 points_m[CN_POLYGON_MAX_VERTICES];
} cn_polygon;

/* One-sided, massless ground without catches at its inner vertices. The solid side is on the left
   of the direction of travel: surface normals point to the right of it, so ground whose points run
   from +x to -x collides from above and a counter-clockwise loop collides from outside. */
typedef struct cn_chain {
	const cn_vec2 *points_m;  /* copied */
	int32_t count;            /* an open chain: >= 2; a loop: >= 3; at most 65535 */
	uint32_t loop;            /* 1: the last point joins the first */
} cn_chain;

CN_API void cn_shape_def_init(cn_shape_def *def);
/* out_shape may be NULL in all of these. Points closer than 0.05% of the length unit are degenerate. */
CN_API cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape);
CN_API cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape);
CN_API cn_result cn_shape_create_edge(cn_world *world, const cn_shape_def *def, const cn_edge *edge, cn_shape *out_shape);
CN_API cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape);
/* Half sizes > 0; radius_m >= 0 is added outside of them. */
CN_API cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape);
/* O(count). */
CN_API cn_result cn_shape_create_chain(cn_world *world, const cn_shape_def *def, const cn_chain *chain, cn_shape *out_shape);

/* An unattached shape joins a body (CN_ERROR_STATE if it already has one), an attached one leaves it. */
CN_API cn_result cn_shape_attach(cn_world *world, cn_shape shape, cn_body body);
CN_API cn_result cn_shape_detach(cn_world *world, cn_shape shape);
CN_API cn_result cn_shape_destroy(cn_world *world, cn_shape shape);
CN_API int32_t cn_shape_is_valid(const cn_world *world, cn_shape shape);
CN_API cn_result cn_shape_get_type(const cn_world *world, cn_shape shape, int32_t *out_type);
/* 0 if unattached. */
CN_API cn_result cn_shape_get_body(const cn_world *world, cn_shape shape, cn_body *out_body);
/* Takes effect at once, on resting contacts too (their bodies wake). */
CN_API cn_result cn_shape_set_material(cn_world *world, cn_shape shape, const cn_material *material);
CN_API cn_result cn_shape_get_material(const cn_world *world, cn_shape shape, cn_material *out);
/* >= 0; the body's mass follows at once. */
CN_API cn_result cn_shape_set_density(cn_world *world, cn_shape shape, float density_kgpm2);
CN_API cn_result cn_shape_get_density(const cn_world *world, cn_shape shape, float *out_kgpm2);
/* Contacts that it forbids end at once (with their events); ones that it allows begin in the next step. */
CN_API cn_result cn_shape_set_filter(cn_world *world, cn_shape shape, const cn_filter *filter);
CN_API cn_result cn_shape_get_filter(const cn_world *world, cn_shape shape, cn_filter *out);
/* Takes effect at once, for present contacts too. */
CN_API cn_result cn_shape_set_event_mask(cn_world *world, cn_shape shape, uint32_t event_mask);
CN_API cn_result cn_shape_get_event_mask(const cn_world *world, cn_shape shape, uint32_t *out_event_mask);
/* Replaces the CN_SHAPE_ flags (SENSOR ...). Contacts end and begin anew as needed. */
CN_API cn_result cn_shape_set_flags(cn_world *world, cn_shape shape, uint32_t flags);
CN_API cn_result cn_shape_get_flags(const cn_world *world, cn_shape shape, uint32_t *out_flags);
CN_API cn_result cn_shape_set_user_data(cn_world *world, cn_shape shape, uint64_t user_data);
CN_API cn_result cn_shape_get_user_data(const cn_world *world, cn_shape shape, uint64_t *out_user_data);
/* Without margin, in world space (in shape space when unattached). O(points). */
CN_API cn_result cn_shape_get_aabb(const cn_world *world, cn_shape shape, cn_aabb *out);
/* In the body's local frame, at the present density; inertia about the shape's own centre. O(points). */
CN_API cn_result cn_shape_get_mass_data(const cn_world *world, cn_shape shape, cn_mass_data *out);
/* The shape's geometry in its body's local frame, offset applied. CN_ERROR_STATE for another type. */
CN_API cn_result cn_shape_get_circle(const cn_world *world, cn_shape shape, cn_circle *out);
CN_API cn_result cn_shape_get_capsule(const cn_world *world, cn_shape shape, cn_capsule *out);
CN_API cn_result cn_shape_get_edge(const cn_world *world, cn_shape shape, cn_edge *out);
CN_API cn_result cn_shape_get_polygon(const cn_world *world, cn_shape shape, cn_polygon *out);
/* Writes at most capacity points (out may be NULL when capacity is 0); *out_count is how many there are. */
CN_API cn_result cn_shape_get_chain_points(const cn_world *world, cn_shape shape, cn_vec2 *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_shape_test_point(const cn_world *world, cn_shape shape, float point_x_m, float point_y_m, int32_t *out_inside);

/* Convex hull of 1 or more points (farthest points inserted, as in Quickhull: Barber, Dobkin, Huhdanpaa 1996) of at most
   CN_POLYGON_MAX_VERTICES, those that add the most area. CN_ERROR_ARGUMENT
   for fewer than three distinct points or collinear ones. Details below 5 mm are dropped (below 5% of
   the half size for hulls under 0.1 m, below 0.5% for those over 1 m). O(count^2) at worst, count <= 65536. */
CN_API cn_result cn_polygon_make_hull(const cn_vec2 *points_m, int32_t count, float radius_m, cn_polygon *out);
/* A box of half sizes > 0, moved and then turned about its own centre. */
CN_API cn_result cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon *out);

/* ------------------------------------------------------------------ contacts and their events */

typedef struct cn_manifold_point {
	cn_vec2 point_m;          /* world, midway between the surfaces */
	float separation_m;       /* negative when overlapping */
	float normal_impulse_Ns;  /* of the last substep */
	uint32_t feature_id;      /* the same while the same features touch */
} cn_manifold_point;

typedef struct cn_manifold {
	cn_vec2 normal;             /* unit, from shape a to shape b */
	float friction_impulse_Ns;  /* of the last substep, on body b along (normal.y, -normal.x) */
	int32_t point_count;        /* 0, 1 or 2 */
	cn_manifold_point points[2];
} cn_manifold;

typedef struct cn_contact_event {
	cn_shape shape_a;
	cn_shape shape_b;
	cn_body body_a;
	cn_body body_b;
	int32_t child_a;            /* edge number within a chain, else 0 */
	int32_t child_b;
	uint32_t contact_id;        /* the same from CREATED to DESTROYED, then reused */
	int32_t kind;               /* CN_EVENT_* */
	float approach_speed_mps;   /* ENTER: closing speed along the normal before the impact; else 0 */
	cn_manifold manifold;       /* geometry as the step found it, impulses as it left them; points only for ENTER and STAY */
} cn_contact_event;

/* The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. They are
   always bookended: every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends
   (moved away, body or shape destroyed, detached or disabled, filter or type changed). Pairs that
   end through a call between two steps are reported by the next step; handles in such events may be
   stale. Falling asleep is not leaving: a sleeping pair reports nothing until it wakes, and
   then goes on where it was. The array is built on the first request after a step, O(events) then:
   that may return CN_ERROR_MEMORY, and inside callbacks CN_ERROR_LOCKED. */
CN_API cn_result cn_world_contact_events(cn_world *world, int32_t kind, const cn_contact_event **out_events, int32_t *out_count);

/* Called at the end of cn_world_step for each event of this kind, in the order of the array. */
typedef void cn_contact_event_fn(cn_world *world, const cn_contact_event *event, void *user);
/* function NULL removes it. */
CN_API cn_result cn_world_set_contact_callback(cn_world *world, int32_t kind, cn_contact_event_fn *function, void *user);

/* Decides whether two shapes that pass their filters may touch: 1 yes, 0 no. Asked when their boxes begin to
   overlap. The world is locked. */
typedef int32_t cn_filter_fn(cn_world *world, cn_shape shape_a, cn_shape shape_b, void *user);
/* Asked in every step for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE, before solving:
   0 makes the pair pass through each other in this step. Event kind is STAY or ENTER. */
typedef int32_t cn_pre_solve_fn(cn_world *world, const cn_contact_event *contact, void *user);
/* Mixes two materials in place of the CN_MIX_ rules: fills *mixed, which holds what the rules gave. Asked when a
   pair begins to touch and when a material changes. */
typedef void cn_material_mix_fn(cn_world *world, cn_shape shape_a, cn_shape shape_b, cn_material *mixed, void *user);
/* function NULL removes it. */
CN_API cn_result cn_world_set_filter_callback(cn_world *world, cn_filter_fn *function, void *user);
CN_API cn_result cn_world_set_pre_solve_callback(cn_world *world, cn_pre_solve_fn *function, void *user);
CN_API cn_result cn_world_set_material_mix_callback(cn_world *world, cn_material_mix_fn *function, void *user);

/* A shape entered or left a sensor. */
typedef struct cn_sensor_event {
	cn_shape sensor;
	cn_shape visitor;
	cn_body sensor_body;
	cn_body visitor_body;
	int32_t kind;         /* CN_EVENT_ENTER or CN_EVENT_LEAVE */
	uint32_t reserved;
} cn_sensor_event;
/* Of the last step, in a deterministic order; bookended like contact events. Sensors see dynamic and
   kinematic bodies' shapes that are not sensors, by exact overlap. */
CN_API cn_result cn_world_sensor_events(const cn_world *world, const cn_sensor_event **out_events, int32_t *out_count);

/* The contacts of a body, touching or not, as events of kind STAY (touching) or CREATED.
   Writes at most capacity; *out_count is how many there are. O(contacts). */
CN_API cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count);

/* As cn_body_get_contacts, of one shape, a chain with all its edges. O(contacts of its body). */
CN_API cn_result cn_shape_get_contacts(const cn_world *world, cn_shape shape, cn_contact_event *out, int32_t capacity, int32_t *out_count);
/* The shapes that are in a sensor, each once: those whose ENTER had no LEAVE up to the last step. CN_ERROR_STATE for a shape that is
   no sensor. O(contacts of its body), for chains squared. */
CN_API cn_result cn_shape_get_visitors(const cn_world *world, cn_shape sensor, cn_shape *out, int32_t capacity, int32_t *out_count);

/* Bodies that fell asleep in the last step, or since by cn_body_set_awake; ones destroyed since are
   stale handles. */
CN_API cn_result cn_world_fell_asleep(const cn_world *world, const cn_body **out_bodies, int32_t *out_count);

/* ------------------------------------------------------------------ joints */

enum {
	CN_JOINT_REVOLUTE = 0,
	CN_JOINT_DISTANCE = 1,
	CN_JOINT_FIXED = 2,
	CN_JOINT_PRISMATIC = 3,
	CN_JOINT_WHEEL = 4,
	CN_JOINT_MOTOR_TO = 5,
	CN_JOINT_MOUSE = 6,
	CN_JOINT_GEAR = 7,
	CN_JOINT_PULLEY = 8,
	CN_JOINT_RATCHET = 9,
	CN_JOINT_ROTARY_SPRING = 10,
	CN_JOINT_GROOVE = 11,
	CN_JOINT_FILTER = 12
};

enum {
	CN_JOINT_COLLIDE = 1u << 0, /* the connected bodies' shapes collide with each other (default off) */
	CN_JOINT_LIMIT = 1u << 1,
	CN_JOINT_MOTOR = 1u << 2,
	CN_JOINT_SPRING = 1u << 3,
	CN_JOINT_BREAKS = 1u << 4   /* beyond its break force or torque it is destroyed, not only reported */
};

/* First field of every joint definition. A joint's rigid parts are what holds anchors, axes, angles, lengths and
   limits in place; springs and motors are not. */
typedef struct cn_joint_base {
	uint32_t struct_size;   /* of the whole definition */
	uint32_t flags;         /* CN_JOINT_*; default 0; a type ignores those it has no use for */
	cn_body body_a;         /* 0: the world */
	cn_body body_b;         /* 0: the world; one of the two must be dynamic */
	cn_vec2 anchor_a_m;     /* in body a's local frame, or in world coordinates */
	cn_vec2 anchor_b_m;
	float stiffness_hertz;  /* of the rigid parts, 0 to 1e6; 0 (default): as stiff as the substeps allow */
	float stiffness_damping_ratio; /* used when stiffness_hertz > 0; 0 to 1e6 */
	float force_max_N;      /* anchors and axes never pull harder, nor does a limit; 0 (default): no bound */
	float torque_max_Nm;    /* the same for angles */
	float break_force_N;    /* a reaction above this in any substep is reported (cn_world_joint_events); 0 (default): never */
	float break_torque_Nm;
	uint64_t user_data;
} cn_joint_base;

/* Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi]. */
typedef struct cn_revolute_def {
	cn_joint_base base;
	float reference_angle_rad;
	float lower_angle_rad;        /* CN_JOINT_LIMIT: -pi <= lower <= upper <= pi */
	float upper_angle_rad;
	float motor_speed_radps;      /* CN_JOINT_MOTOR */
	float motor_torque_max_Nm;    /* >= 0 */
	float spring_target_rad;      /* CN_JOINT_SPRING: pulls the joint angle to this */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
} cn_revolute_def;

/* Two points keep a distance. Without CN_JOINT_SPRING and without CN_JOINT_LIMIT it is a rigid rod of
   length_m. With a spring, length_m is its rest length and the distance stays within [min, max] when
   limits are on; limits alone make a rope (min 0). */
typedef struct cn_distance_def {
	cn_joint_base base;
	float length_m;               /* > 0; default 1 */
	float length_min_m;           /* CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1 */
	float length_max_m;
	float motor_speed_mps;        /* CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only */
	float motor_force_max_N;      /* >= 0 */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
	float reserved;
} cn_distance_def;

/* Welded: no relative motion. base.stiffness_hertz makes it springy. */
typedef struct cn_fixed_def {
	cn_joint_base base;
	float reference_angle_rad;    /* angle b - angle a */
	float angular_hertz;          /* stiffness of the angle alone, 0 to 1e6; 0: as the base's */
	float angular_damping_ratio;  /* 0 to 1e6 */
	float reserved;
} cn_fixed_def;

/* b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a. */
typedef struct cn_prismatic_def {
	cn_joint_base base;
	cn_vec2 axis;                 /* in body a's frame, any length > 0 (read back with length 1); default (1, 0) */
	float reference_angle_rad;    /* angle b - angle a */
	float lower_m;                /* CN_JOINT_LIMIT: lower <= upper */
	float upper_m;
	float motor_speed_mps;        /* CN_JOINT_MOTOR */
	float motor_force_max_N;      /* >= 0 */
	float spring_target_m;        /* CN_JOINT_SPRING: pulls the translation to this */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
} cn_prismatic_def;

/* A wheel b on suspension: slides along an axis fixed in a (springy, with limits), turns freely; the motor turns it. */
typedef struct cn_wheel_def {
	cn_joint_base base;
	cn_vec2 axis;                 /* in body a's frame, any length > 0 (read back with length 1); default (0, 1) */
	float lower_m;                /* CN_JOINT_LIMIT: lower <= upper */
	float upper_m;
	float motor_speed_radps;      /* CN_JOINT_MOTOR */
	float motor_torque_max_Nm;    /* >= 0 */
	float spring_hertz;           /* CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1 */
	float spring_damping_ratio;   /* 0 to 1e6, default 0.7 */
} cn_wheel_def;

/* Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
   base.torque_max_Nm must be > 0. */
typedef struct cn_motor_def {
	cn_joint_base base;           /* anchor b is driven to anchor a + offset */
	cn_vec2 offset_m;             /* in body a's frame */
	float angle_rad;              /* angle b - angle a */
	float hertz;                  /* how briskly, > 0, to 1e6; default 5 */
	float damping_ratio;          /* 0 to 1e6, default 1 */
	float reserved;
} cn_motor_def;

/* Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
   base.force_max_N must be > 0. */
typedef struct cn_mouse_def {
	cn_joint_base base;
	cn_vec2 target_m;
	float hertz;                  /* > 0, to 1e6; default 5 */
	float damping_ratio;          /* 0 to 1e6, default 0.7 */
} cn_mouse_def;

/* angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed) and
   count whole turns from there. */
typedef struct cn_gear_def {
	cn_joint_base base;
	float ratio;                  /* size 1e-4 to 1e4, negative: they turn against each other; default 1 */
	float phase_rad;
} cn_gear_def;

/* |anchor a - ground a| + ratio |anchor b - ground b| <= length: a rope over two pulleys (never pushes). */
typedef struct cn_pulley_def {
	cn_joint_base base;
	cn_vec2 ground_a_m;           /* world */
	cn_vec2 ground_b_m;
	float ratio;                  /* 1e-4 to 1e4; default 1 */
	float length_m;               /* > 0 */
} cn_pulley_def;

/* b may turn against a in one direction only, and back no farther than to the last click that it passed. Clicks
   are at phase + any whole number of click_rad, over whole turns. */
typedef struct cn_ratchet_def {
	cn_joint_base base;
	float phase_rad;
	float click_rad;              /* size 1e-4 to 1e4; positive: b may turn counter-clockwise */
} cn_ratchet_def;

/* A torque that pulls angle b - angle a to rest, over whole turns. hertz is that of the two bodies' own inertia. */
typedef struct cn_rotary_spring_def {
	cn_joint_base base;
	float rest_angle_rad;
	float hertz;                  /* > 0, to 1e6; default 1 */
	float damping_ratio;          /* 0 to 1e6, default 0 */
	float reserved;
} cn_rotary_spring_def;

/* anchor b slides in a slot of body a from anchor a to end. */
typedef struct cn_groove_def {
	cn_joint_base base;
	cn_vec2 end_m;                /* in body a's frame; not equal to anchor a; default (1, 0) */
} cn_groove_def;

/* Nothing but: the two bodies do not collide. */
typedef struct cn_filter_joint_def {
	cn_joint_base base;
} cn_filter_joint_def;

CN_API void cn_revolute_def_init(cn_revolute_def *def);
CN_API void cn_distance_def_init(cn_distance_def *def);
CN_API void cn_fixed_def_init(cn_fixed_def *def);
CN_API void cn_prismatic_def_init(cn_prismatic_def *def);
CN_API void cn_wheel_def_init(cn_wheel_def *def);
CN_API void cn_motor_def_init(cn_motor_def *def);
CN_API void cn_mouse_def_init(cn_mouse_def *def);
CN_API void cn_gear_def_init(cn_gear_def *def);
CN_API void cn_pulley_def_init(cn_pulley_def *def);
CN_API void cn_ratchet_def_init(cn_ratchet_def *def);
CN_API void cn_rotary_spring_def_init(cn_rotary_spring_def *def);
CN_API void cn_groove_def_init(cn_groove_def *def);
CN_API void cn_filter_joint_def_init(cn_filter_joint_def *def);
/* Wake both bodies. CN_ERROR_ARGUMENT for a body with itself or without a dynamic body. */
CN_API cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_prismatic(cn_world *world, const cn_prismatic_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_wheel(cn_world *world, const cn_wheel_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_motor(cn_world *world, const cn_motor_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_mouse(cn_world *world, const cn_mouse_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_gear(cn_world *world, const cn_gear_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_pulley(cn_world *world, const cn_pulley_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_ratchet(cn_world *world, const cn_ratchet_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_rotary_spring(cn_world *world, const cn_rotary_spring_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_groove(cn_world *world, const cn_groove_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_create_filter(cn_world *world, const cn_filter_joint_def *def, cn_joint *out_joint);
CN_API cn_result cn_joint_destroy(cn_world *world, cn_joint joint);
CN_API int32_t cn_joint_is_valid(const cn_world *world, cn_joint joint);
CN_API cn_result cn_joint_get_type(const cn_world *world, cn_joint joint, int32_t *out_type);
CN_API cn_result cn_joint_get_bodies(const cn_world *world, cn_joint joint, cn_body *out_a, cn_body *out_b);
CN_API cn_result cn_joint_get_anchors(const cn_world *world, cn_joint joint, cn_vec2 *out_world_a_m, cn_vec2 *out_world_b_m);
/* Force in newtons and torque in newton metres that the joint put on body b in the last substep. */
CN_API cn_result cn_joint_get_reaction(const cn_world *world, cn_joint joint, cn_vec2 *out_force_N, float *out_torque_Nm);
/* How far the joint's rigid parts are from being satisfied: metres (anchors, lengths beyond limits)
   and radians (angles beyond limits), both >= 0. */
CN_API cn_result cn_joint_get_error(const cn_world *world, cn_joint joint, float *out_m, float *out_rad);
/* In worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): the joint is solved together with its neighbours
   where that is cheap. _SOFT: always by itself. _DIRECT: together with all joints that it hangs together with, for as much
   work as CN_SOLVER_DIRECT takes, within the work_budget. In a world in a caller's block that was not made with
   CN_SOLVER_DIRECT, _DIRECT is _AUTO. From the next step on; does not wake. */
CN_API cn_result cn_joint_set_solver(cn_world *world, cn_joint joint, int32_t solver);
CN_API cn_result cn_joint_get_solver(const cn_world *world, cn_joint joint, int32_t *out_solver);
CN_API cn_result cn_joint_set_user_data(cn_world *world, cn_joint joint, uint64_t user_data);
CN_API cn_result cn_joint_get_user_data(const cn_world *world, cn_joint joint, uint64_t *out_user_data);
/* Replaces the CN_JOINT_ flags. Wakes. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags);
CN_API cn_result cn_joint_get_flags(const cn_world *world, cn_joint joint, uint32_t *out_flags);

/* Read back or replace a definition. set leaves bodies and anchors as they are and ignores struct_size; all else
   is taken, flags and user data too. CN_ERROR_STATE for a joint of another type. set wakes. A filter joint has
   nothing but its base. */
CN_API cn_result cn_joint_get_revolute(const cn_world *world, cn_joint joint, cn_revolute_def *out);
CN_API cn_result cn_joint_set_revolute(cn_world *world, cn_joint joint, const cn_revolute_def *def);
CN_API cn_result cn_joint_get_distance(const cn_world *world, cn_joint joint, cn_distance_def *out);
CN_API cn_result cn_joint_set_distance(cn_world *world, cn_joint joint, const cn_distance_def *def);
CN_API cn_result cn_joint_get_fixed(const cn_world *world, cn_joint joint, cn_fixed_def *out);
CN_API cn_result cn_joint_set_fixed(cn_world *world, cn_joint joint, const cn_fixed_def *def);
CN_API cn_result cn_joint_get_prismatic(const cn_world *world, cn_joint joint, cn_prismatic_def *out);
CN_API cn_result cn_joint_set_prismatic(cn_world *world, cn_joint joint, const cn_prismatic_def *def);
CN_API cn_result cn_joint_get_wheel(const cn_world *world, cn_joint joint, cn_wheel_def *out);
CN_API cn_result cn_joint_set_wheel(cn_world *world, cn_joint joint, const cn_wheel_def *def);
CN_API cn_result cn_joint_get_motor_to(const cn_world *world, cn_joint joint, cn_motor_def *out);
CN_API cn_result cn_joint_set_motor_to(cn_world *world, cn_joint joint, const cn_motor_def *def);
CN_API cn_result cn_joint_get_mouse(const cn_world *world, cn_joint joint, cn_mouse_def *out);
CN_API cn_result cn_joint_set_mouse(cn_world *world, cn_joint joint, const cn_mouse_def *def);
CN_API cn_result cn_joint_get_gear(const cn_world *world, cn_joint joint, cn_gear_def *out);
CN_API cn_result cn_joint_set_gear(cn_world *world, cn_joint joint, const cn_gear_def *def);
CN_API cn_result cn_joint_get_pulley(const cn_world *world, cn_joint joint, cn_pulley_def *out);
CN_API cn_result cn_joint_set_pulley(cn_world *world, cn_joint joint, const cn_pulley_def *def);
CN_API cn_result cn_joint_get_ratchet(const cn_world *world, cn_joint joint, cn_ratchet_def *out);
CN_API cn_result cn_joint_set_ratchet(cn_world *world, cn_joint joint, const cn_ratchet_def *def);
CN_API cn_result cn_joint_get_rotary_spring(const cn_world *world, cn_joint joint, cn_rotary_spring_def *out);
CN_API cn_result cn_joint_set_rotary_spring(cn_world *world, cn_joint joint, const cn_rotary_spring_def *def);
CN_API cn_result cn_joint_get_groove(const cn_world *world, cn_joint joint, cn_groove_def *out);
CN_API cn_result cn_joint_set_groove(cn_world *world, cn_joint joint, const cn_groove_def *def);
/* The base of any joint. */
CN_API cn_result cn_joint_get_base(const cn_world *world, cn_joint joint, cn_joint_base *out);
/* Takes stiffness, most force and torque, and break thresholds; the rest of base is ignored. Wakes. */
CN_API cn_result cn_joint_set_base(cn_world *world, cn_joint joint, const cn_joint_base *base);
/* Mouse joint: where to drag to; called each frame. CN_ERROR_STATE for another type. Wakes. */
CN_API cn_result cn_joint_set_target(cn_world *world, cn_joint joint, float target_x_m, float target_y_m);
/* Revolute, fixed, motor: the angle b - angle a - reference (motor: without one), in (-pi, pi]. Distance, pulley:
   the present length. Prismatic, wheel, groove: the translation along the axis. Mouse: distance to the target.
   Gear: angle b - ratio * angle a; ratchet, rotary spring: angle b - angle a, these three over whole turns. */
CN_API cn_result cn_joint_get_position(const cn_world *world, cn_joint joint, float *out_position);
/* How fast that changes; but of a wheel how fast b turns against a. With CN_JOINT_MOTOR, positive follows these. */
CN_API cn_result cn_joint_get_speed(const cn_world *world, cn_joint joint, float *out_speed);
/* The two setters that games call each frame, for revolute, distance, prismatic and wheel (others:
   CN_ERROR_STATE). Wake. */
CN_API cn_result cn_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max);
CN_API cn_result cn_joint_set_limits(cn_world *world, cn_joint joint, float lower, float upper);

/* Something happened to a joint or to a constraint on one body. */
typedef struct cn_joint_event {
	cn_joint joint;            /* 0: it was a constraint; stale when destroyed is 1 */
	cn_constraint constraint;  /* 0: it was a joint; stale when destroyed is 1 */
	cn_body body_a;            /* 0: the world */
	cn_body body_b;
	float force_N;             /* largest reaction of the step; 0 when a body was destroyed */
	float torque_Nm;
	uint32_t destroyed;        /* 1: it is gone (it breaks, or a body of it was destroyed) */
	uint32_t reserved;
	uint64_t user_data;
} cn_joint_event;
/* Those that exceeded a break threshold in the last step, and those destroyed with a body in or since the step
   before (by calls between two steps: reported by the next step). */
CN_API cn_result cn_world_joint_events(const cn_world *world, const cn_joint_event **out_events, int32_t *out_count);

/* ------------------------------------------------------------------ constraints on one body */

enum {
	CN_CONSTRAINT_ANGLE = 0,
	CN_CONSTRAINT_LINE = 1
};
enum {
	CN_CONSTRAINT_LIMIT = 1u << 0, /* line: the limits along the axis hold */
	CN_CONSTRAINT_BREAKS = 1u << 1 /* beyond its break force or torque it is destroyed, not only reported */
};

/* Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from there. */
typedef struct cn_angle_constraint_def {
	uint32_t struct_size;
	uint32_t flags;           /* CN_CONSTRAINT_*; default 0 */
	cn_body body;             /* must be dynamic */
	float lower_rad;          /* lower <= upper; equal: locked */
	float upper_rad;
	float hertz;              /* 0 (default): rigid; to 1e6 */
	float damping_ratio;      /* used when hertz > 0; 0 to 1e6 */
	float break_torque_Nm;    /* a reaction above this is reported (cn_world_joint_events); 0: never */
	uint64_t user_data;
} cn_angle_constraint_def;

/* Keeps a point of a body on a line in the world, within a tolerance to either side, and between limits along it. */
typedef struct cn_line_constraint_def {
	uint32_t struct_size;
	uint32_t flags;           /* CN_CONSTRAINT_*; default 0 */
	cn_body body;             /* must be dynamic */
	cn_vec2 anchor_m;         /* in the body's frame */
	cn_vec2 origin_m;         /* of the line, world */
	cn_vec2 axis;             /* world, any length > 0 (read back with length 1); default (1, 0) */
	float tolerance_m;        /* >= 0: free play across the axis */
	float lower_m;            /* CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper */
	float upper_m;
	float hertz;              /* 0 (default): rigid; to 1e6 */
	float damping_ratio;      /* used when hertz > 0; 0 to 1e6 */
	float break_force_N;      /* a reaction above this is reported (cn_world_joint_events); 0: never */
	uint32_t reserved;
	uint64_t user_data;
} cn_line_constraint_def;

CN_API void cn_angle_constraint_def_init(cn_angle_constraint_def *def);
CN_API void cn_line_constraint_def_init(cn_line_constraint_def *def);
/* They are solved with the joints, before contacts. Wake the body. */
CN_API cn_result cn_constraint_create_angle(cn_world *world, const cn_angle_constraint_def *def, cn_constraint *out_constraint);
CN_API cn_result cn_constraint_create_line(cn_world *world, const cn_line_constraint_def *def, cn_constraint *out_constraint);
CN_API cn_result cn_constraint_destroy(cn_world *world, cn_constraint constraint);
CN_API int32_t cn_constraint_is_valid(const cn_world *world, cn_constraint constraint);
CN_API cn_result cn_constraint_get_type(const cn_world *world, cn_constraint constraint, int32_t *out_type);
CN_API cn_result cn_constraint_get_body(const cn_world *world, cn_constraint constraint, cn_body *out_body);
/* Read back or replace a definition; set ignores body. CN_ERROR_STATE for the other type. set wakes. */
CN_API cn_result cn_constraint_get_angle(const cn_world *world, cn_constraint constraint, cn_angle_constraint_def *out);
CN_API cn_result cn_constraint_set_angle(cn_world *world, cn_constraint constraint, const cn_angle_constraint_def *def);
CN_API cn_result cn_constraint_get_line(const cn_world *world, cn_constraint constraint, cn_line_constraint_def *out);
CN_API cn_result cn_constraint_set_line(cn_world *world, cn_constraint constraint, const cn_line_constraint_def *def);
/* Angle: the angle over whole turns. Line: where along the axis the point is, from origin. */
CN_API cn_result cn_constraint_get_position(const cn_world *world, cn_constraint constraint, float *out_position);
/* Force in newtons and torque in newton metres that it put on the body in the last substep. */
CN_API cn_result cn_constraint_get_reaction(const cn_world *world, cn_constraint constraint, cn_vec2 *out_force_N, float *out_torque_Nm);
/* How far beyond what is allowed, >= 0. */
CN_API cn_result cn_constraint_get_error(const cn_world *world, cn_constraint constraint, float *out_m, float *out_rad);
/* As cn_world_get_joints and cn_body_get_joints, which do not list constraints. */
CN_API cn_result cn_world_get_constraints(const cn_world *world, cn_constraint *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_body_get_constraints(const cn_world *world, cn_body body, cn_constraint *out, int32_t capacity, int32_t *out_count);

/* ------------------------------------------------------------------ variable time */

typedef struct cn_update_report {
	int32_t steps;        /* fixed steps taken */
	float leftover_s;     /* time kept for the next update */
	float dropped_s;      /* time given up because of the step cap */
	float interpolation;  /* leftover / fixed step, [0, 1): between the last two poses */
} cn_update_report;

/* step_s in (0, 1], default 1/60; steps_max >= 1, default 8. */
CN_API cn_result cn_world_set_fixed_step(cn_world *world, float step_s, int32_t steps_max);
/* Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. Events of all
   steps but the last are only seen by callbacks. out may be NULL. */
CN_API cn_result cn_world_update(cn_world *world, float elapsed_s, cn_update_report *out);
/* Poses between the last two steps of cn_world_update: factor 0 the one before, 1 the last. bodies as in
   cn_world_read_poses. Bodies that did not take part in the last step have their present pose. */
CN_API cn_result cn_world_read_poses_interpolated(const cn_world *world, const cn_body *bodies, int32_t count, float factor, cn_pose *out);

/* ------------------------------------------------------------------ queries */

typedef struct cn_ray {
	cn_vec2 origin_m;
	cn_vec2 translation_m; /* may be 0: then only shapes around the origin are hit; at most 2e6 length units each way */
} cn_ray;

/* What a ray or a moved shape meets. One that starts in contact, overlapping or just touching, meets that shape at fraction 0,
   with the shortest way out: depth_m along the normal. It does not meet what it touches, up to a depth of 0.5% of the
   length unit, when its translation does not lead in: along the surface or away from it. */
typedef struct cn_ray_hit {
	cn_shape shape;       /* 0: nothing was hit */
	cn_body body;
	int32_t child;        /* edge of a chain */
	float fraction;       /* of the translation, [0, 1]; 1 when nothing was hit */
	cn_vec2 point_m;      /* on the surface of the shape that was hit */
	cn_vec2 normal;       /* unit, out of the shape that was hit */
	float depth_m;        /* how deep the start is in it, 0 when it is outside */
	uint32_t reserved;
} cn_ray_hit;

enum {
	CN_QUERY_SKIP = 0, /* the shape is not there */
	CN_QUERY_TAKE = 1,
	CN_QUERY_STOP = 2  /* it is taken, and nothing that comes after it in the order of the results */
};
/* Asked by a query for each shape (edge of a chain) that it would find, in no particular order and perhaps more than once: the answer
   must depend on the shape alone. hit is what is known of it: all of it in casts, else shape, body and child. Returns
   CN_QUERY_*. May call functions that take a const world, of the same world too, and no others. */
typedef int32_t cn_query_fn(const cn_world *world, const cn_ray_hit *hit, void *user);

enum {
	CN_QUERY_IGNORE_JOINED = 1u << 0, /* bodies that a joint connects to ignored_body are not seen either */
	CN_QUERY_ONE_WAY = 1u << 1,       /* casts meet one-way shapes from their upper side (45 degrees) only, and not those that they
	                                     start in by more than 0.5% of the length unit; all other queries do not see one-way shapes. Default: they are like others */
	CN_QUERY_LEAVING = 1u << 2        /* casts do not meet what they start in, however deep, when they do not lead farther in */
};

/* A query sees shapes of enabled bodies whose category has a bit in mask and whose mask has one in category, and of
   sensors only those with CN_SHAPE_SENSOR_SEEN. Bodies are seen where they are now, also between steps. */
typedef struct cn_query_filter {
	uint64_t category;    /* default 1 */
	uint64_t mask;        /* default all ones */
	cn_body ignored_body; /* its shapes are not seen; 0 (default): none. A stale handle is an error */
	uint32_t flags;       /* CN_QUERY_IGNORE_JOINED ...; default 0 */
	cn_query_fn *visit;   /* NULL (default): all are taken */
	void *user;
} cn_query_filter;
CN_API void cn_query_filter_init(cn_query_filter *filter);

/* Nearest hit; out->shape is 0 when there is none. An edge is hit from both sides, a chain from its front only. Of equal
   hits the first by shape (as in cn_world_get_shapes), then child. filter may be NULL in all queries: the defaults.
   O(log) to O(shapes along the ray). */
CN_API cn_result cn_world_cast_ray(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out);
/* 1 if anything is hit: cheaper than the nearest. */
CN_API cn_result cn_world_cast_ray_any(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, int32_t *out_hit);
/* Up to capacity hits, nearest first (the nearest ones if there are more); *out_count is how many were found. A chain is
   hit once by each edge on the way. */
CN_API cn_result cn_world_cast_ray_all(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out, int32_t capacity, int32_t *out_count);
/* count rays, the nearest hit of each; nothing is written if one of them is bad. */
CN_API cn_result cn_world_cast_rays(const cn_world *world, const cn_ray *rays, int32_t count, const cn_query_filter *filter, cn_ray_hit *out);
/* Against one shape alone, whatever its filter, in shape space when unattached. O(edges of a chain). */
CN_API cn_result cn_shape_cast_ray(const cn_world *world, cn_shape shape, const cn_ray *ray, cn_ray_hit *out);
/* A polygon (its points in world coordinates; count may be 1 or 2 too, with radius > 0: circle, capsule) moved by
   translation without turning: the first shape it meets. A chain is met by what has the mean of its points in front. */
CN_API cn_result cn_world_cast_shape(const cn_world *world, const cn_polygon *shape, float translation_x_m, float translation_y_m, const cn_query_filter *filter, cn_ray_hit *out);

/* Shapes that overlap a region: at most capacity handles are written (the first ones), *out_count is how many there are,
   in the order of cn_world_get_shapes. The first is by the shapes' boxes without margin, the others exact. A chain is
   listed once; edges and chains are lines here, seen from both sides, and contain no point. Polygons as in
   cn_world_cast_shape. O(log) to O(boxes in the region). */
CN_API cn_result cn_world_overlap_aabb(const cn_world *world, const cn_aabb *box, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_world_overlap_circle(const cn_world *world, const cn_circle *circle, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_world_overlap_polygon(const cn_world *world, const cn_polygon *polygon, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
CN_API cn_result cn_world_overlap_point(const cn_world *world, float x_m, float y_m, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);

typedef struct cn_closest {
	cn_shape shape;       /* 0: nothing within the distance */
	cn_body body;
	int32_t child;
	float distance_m;     /* negative: depth inside a shape with area */
	cn_vec2 point_m;      /* on the surface */
	cn_vec2 normal;       /* outward there; of edges and chains towards the point */
} cn_closest;
/* The shape nearest to a point within distance_max_m (0 to 4e6 length units), the deepest if the point is in several.
   Cost grows with what is near, not with distance_max_m. */
CN_API cn_result cn_world_closest_point(const cn_world *world, float x_m, float y_m, float distance_max_m, const cn_query_filter *filter, cn_closest *out);

/* ------------------------------------------------------------------ two shapes without a world */

/* These work on any two convex shapes: polygons as in cn_world_cast_shape, but 1 or 2 points may have radius 0 too: a point,
   a segment. Each is in its own frame, with a pose in the world (the rotation must be of unit length within 1%). They are
   pure functions: any thread, no memory, O(points). Points closer than 5e-4 m are degenerate, as in a world of length unit 1. */

typedef struct cn_distance {
	cn_vec2 point_a_m;    /* on the surface of a, in the world */
	cn_vec2 point_b_m;
	cn_vec2 normal;       /* unit, from a to b */
	float distance_m;     /* of the surfaces; negative: the depth, the shortest way that moves b out of a */
	uint32_t reserved;
} cn_distance;
/* By GJK (Gilbert, Johnson, Keerthi 1988) when the shapes without their radii are apart, else by their Minkowski difference. */
CN_API cn_result cn_polygon_distance(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, cn_distance *out);
/* b is moved by translation (at most 2e6 m each way) without turning: where it meets a, as cn_ray_hit says, without shape, body
   and child; 1 in *out_hit, or 0. */
CN_API cn_result cn_polygon_cast(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, float translation_x_m,
	float translation_y_m, cn_ray_hit *out, int32_t *out_hit);
/* The contact of a step: no points when they are farther apart than margin_m (0 to 1e6). Impulses are 0. Not for a single
   point of radius 0. */
CN_API cn_result cn_polygon_collide(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b, float margin_m, cn_manifold *out);

/* A motion from fraction 0 to 1: a point of the shape goes in a straight line, and the shape turns evenly about it. */
typedef struct cn_sweep {
	cn_pose start;
	cn_vec2 center_m;      /* that point, in the shape's frame: the centre of mass of a body */
	cn_vec2 translation_m; /* of it; at most 2e6 m each way */
	float turn_rad;        /* counter-clockwise, |turn| <= 1e4 */
	uint32_t reserved;
} cn_sweep;
enum {
	CN_IMPACT_NONE = 0,    /* they never come so near; fraction is 1 */
	CN_IMPACT_HIT = 1,
	CN_IMPACT_OVERLAP = 2, /* the shapes without their radii overlap at the start: fraction 0, no normal */
	CN_IMPACT_FAILED = 3   /* they may meet after fraction, and do not before it: the search ended early */
};
typedef struct cn_impact {
	int32_t state;         /* CN_IMPACT_* */
	float fraction;
	cn_vec2 point_m;       /* HIT only, as are the next two: between the surfaces */
	cn_vec2 normal;        /* unit, from a to b */
	float distance_m;      /* of the surfaces at fraction, from distance_m to 0.1 mm (or what floats can tell) above */
	uint32_t reserved;
} cn_impact;
/* When two shapes that move and turn first come within distance_m (0 to 1e6) of each other; fraction 0 for those that start
   nearer. Conservative advancement (Mirtich 1996) along fixed axes (Catto, GDC 2013) that never passes by a hit. */
CN_API cn_result cn_polygon_time_of_impact(const cn_polygon *a, const cn_sweep *sweep_a, const cn_polygon *b, const cn_sweep *sweep_b,
	float distance_m, cn_impact *out);

/* ------------------------------------------------------------------ character mover */

/* A surface that bounds where a shape may move: after a translation t of the shape, separation_m + normal . t is >= 0, unless that takes
   more than push_max_m. */
typedef struct cn_plane {
	cn_vec2 normal;        /* unit, from the surface to the shape */
	cn_vec2 point_m;       /* where they are nearest, in the world */
	float separation_m;    /* of the surfaces along the normal; negative: they overlap */
	float push_max_m;      /* >= 0: the farthest that this plane pushes; FLT_MAX: rigid */
	float push_m;          /* of the last cn_mover_solve: how far it pushed */
	cn_shape shape;
	cn_body body;
	int32_t child;         /* edge of a chain */
} cn_plane;
/* The planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved by position: how they
   touch it, as in a step, rigid. At most capacity, those of least separation first; *out_count is how many there are. Sensors
   are no surfaces. With CN_QUERY_ONE_WAY a one-way shape is one only from its upper side, and only for what is no deeper in it than
   0.5% of the length unit and what it rose by in the last step. A shape wholly behind another one's plane is left out: it
   cannot be met while that plane holds, so that the seams of tiles do not catch (not done when capacity is too small for all).
   O(shapes near, squared). */
CN_API cn_result cn_mover_collide(const cn_world *world, const cn_polygon *shape, float position_x_m, float position_y_m, float margin_m,
	const cn_query_filter *filter, cn_plane *out, int32_t capacity, int32_t *out_count);
/* The translation nearest to a wanted one that the planes allow: exactly, for in two dimensions it lies on at most two of them. A
   plane pushes by no more than push_max_m: which ones push their most, Hildreth's method (1957) tells. Sets push_m. Between surfaces that leave no room it is that of the least sum of
   squared overlaps (Cimmino 1938), and *out_overlap_m, else 0 up to rounding, says how deep the deepest of them remains that did
   not push its most. count 0 to CN_PLANES_MAX. No world. O(count^2), O(count^3) where two planes hold it. */
CN_API cn_result cn_mover_solve(cn_plane *planes, int32_t count, float translation_x_m, float translation_y_m, cn_vec2 *out_translation_m, float *out_overlap_m);
/* The velocity nearest to a given one that leads into none of the planes that pushed in the last cn_mover_solve. No world. */
CN_API cn_result cn_mover_clip(const cn_plane *planes, int32_t count, float velocity_x_mps, float velocity_y_mps, cn_vec2 *out_mps);

enum {
	CN_MOVER_DROP = 1u << 0        /* one-way shapes are not there: set it while the character is to drop through one */
};
/* How a character moves. The same for every move, or changed from move to move: crouching is another shape. */
typedef struct cn_mover_def {
	uint32_t struct_size;
	uint32_t flags;                /* CN_MOVER_DROP; default 0 */
	cn_polygon shape;              /* around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule
	                                  of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly */
	cn_query_filter filter;        /* what it collides with; sensors never, one-way shapes from above */
	cn_vec2 up;                    /* any length > 0; default (0, 1) */
	float slope_limit_rad;         /* steeper ground cannot be stood on or walked up, 0 to pi / 2; default 0.87 (50 degrees) */
	float step_height_m;           /* climbs steps up to this high while it walks, >= 0; default 0.3 */
	float snap_m;                  /* walking, keeps to ground that falls away by up to this in a move, >= 0; default 0.3 */
	float gravity_scale;           /* of the world's gravity in the air; default 1 */
	float push_force_N;            /* the most it pushes a dynamic body with, >= 0; default 200 */
	int32_t iterations_max;        /* of sliding, 1 to 64; default 8 */
} cn_mover_def;
CN_API void cn_mover_def_init(cn_mover_def *def);

enum {
	CN_MOVER_ON_GROUND = 1u << 0,
	CN_MOVER_ON_WALL = 1u << 1,    /* touches what is too steep to walk on */
	CN_MOVER_ON_CEILING = 1u << 2
};
/* A character between two moves. It belongs to the caller, who may copy it, keep it and go back to it: the world knows nothing
   of it, and other bodies do not collide with it: for that give it a kinematic body that is filter.ignored_body and follows by
   cn_body_set_target_pose. Begin with all 0 but the position. */
typedef struct cn_mover {
	cn_vec2 position_m;
	cn_vec2 velocity_mps;          /* in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as
	                                  its component across up; the one along up is 0, and a jump when the caller makes it > 0 */
	cn_vec2 ground_normal;         /* of what it stands on, with CN_MOVER_ON_GROUND; else (0, 0) */
	cn_vec2 ground_point_m;        /* in the world, after the move */
	cn_vec2 ground_local_m;        /* ... in the frame of ground_body */
	cn_vec2 ground_velocity_mps;   /* of the ground there */
	cn_body ground_body;           /* 0: none; may become stale, which is as none */
	cn_shape ground_shape;
	uint32_t flags;                /* CN_MOVER_ON_*, after the last move */
	float squeezed_m;              /* by how much it overlaps what left it no room; 0 but for rounding */
} cn_mover;
/*
 * Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, or it is a step behind what carries it.
 *
 *  1. carried   by what its ground did since the last move: the change of the place in ground_body where it stood, conveyors too
 *  2. walking   on the ground: velocity_mps across up, along the ground, as fast uphill as downhill; no gravity, so that it does
 *               not creep. Where something too steep is in the way, a step up: up by step_height_m, forward, down on what can
 *               be walked on
 *     flying    in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off take ground_velocity_mps along
 *  3. sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes through a wall
 *  4. pushing   dynamic bodies in the way get a force for the next step that brings them to the character's velocity, of at most
 *               push_force_N each
 *  5. ground    what it touches and can stand on, or finds within snap_m below when it walked; velocity_mps loses what is blocked
 *
 * Depends on the world, def and mover alone: the same calls give the same bits. The loop of planes, solver and cast is that of
 * Box2D 3's sample of a character mover (Catto 2025). Bodies pushed wake up; nothing else of the world changes. O(shapes near
 * x iterations_max): some 1 us standing, 3 us walking, 10 us against a wall.
 */
CN_API cn_result cn_mover_move(cn_world *world, const cn_mover_def *def, float dt_s, cn_mover *mover);

/* ------------------------------------------------------------------ explosions */

typedef struct cn_explosion_def {
	uint32_t struct_size;
	float radius_m;           /* full strength within, to the nearest point of a shape; >= 0, default 1 */
	float falloff_m;          /* then linearly to none over this distance; >= 0 */
	float impulse_Nspm;       /* per metre of the shape's width seen from the centre; negative pulls */
	cn_vec2 center_m;
	cn_query_filter filter;
} cn_explosion_def;
CN_API void cn_explosion_def_init(cn_explosion_def *def);
/* Pushes dynamic bodies away from the centre, each shape at its point nearest to it, and wakes them. Velocities must
   stay finite (CN_ERROR_ARGUMENT). O(shapes in reach). */
CN_API cn_result cn_world_explode(cn_world *world, const cn_explosion_def *def);

/* ------------------------------------------------------------------ debug draw */

enum {
	CN_DRAW_SHAPES = 1u << 0,
	CN_DRAW_JOINTS = 1u << 1,      /* and constraints: anchors, axes, limits */
	CN_DRAW_CONTACTS = 1u << 2,
	CN_DRAW_AABBS = 1u << 3,
	CN_DRAW_CENTERS = 1u << 4,
	CN_DRAW_ISLANDS = 1u << 5
};

/* Functions that are NULL are not called. Colours are 0xRRGGBB. Points are in world coordinates. */
typedef struct cn_debug_draw {
	uint32_t struct_size;
	uint32_t flags;             /* CN_DRAW_*; default SHAPES | JOINTS | CONTACTS */
	cn_aabb view;               /* only what overlaps it is drawn; default everything */
	void (*polygon)(const cn_vec2 *points_m, int32_t count, float radius_m, uint32_t color, void *user);
	/* axis: a point on the rim that turns with the body */
	void (*circle)(const cn_vec2 *center_m, float radius_m, const cn_vec2 *rim_m, uint32_t color, void *user);
	void (*capsule)(const cn_vec2 *a_m, const cn_vec2 *b_m, float radius_m, uint32_t color, void *user);
	void (*segment)(const cn_vec2 *a_m, const cn_vec2 *b_m, uint32_t color, void *user);
	void (*point)(const cn_vec2 *point_m, float size_px, uint32_t color, void *user);
	void (*text)(const cn_vec2 *point_m, const char *text, uint32_t color, void *user);
	void *user;
	void *reserved;
} cn_debug_draw;
CN_API void cn_debug_draw_init(cn_debug_draw *draw);
/* Reads only. O(what is drawn). */
CN_API cn_result cn_world_draw(const cn_world *world, const cn_debug_draw *draw);

/* ------------------------------------------------------------------ a tree of boxes for the game's own use */

typedef struct cn_tree cn_tree;
/* Return 0 to stop, anything else to go on. */
typedef int32_t cn_tree_query_fn(uint32_t item, uint64_t user_data, void *user);
/* Return the fraction to go on with: the given one to ignore the item, 0 to stop. */
typedef float cn_tree_ray_fn(uint32_t item, uint64_t user_data, float fraction, void *user);

/* Dynamic AABB tree. alloc and free NULL: malloc. margin_m >= 0 is added around every box. */
CN_API cn_result cn_tree_create(float margin_m, cn_alloc_fn *alloc, cn_free_fn *free, void *allocator_user, cn_tree **out_tree);
CN_API void cn_tree_destroy(cn_tree *tree);
/* O(log n). *out_item is never 0. */
CN_API cn_result cn_tree_insert(cn_tree *tree, const cn_aabb *box, uint64_t user_data, uint32_t *out_item);
CN_API cn_result cn_tree_remove(cn_tree *tree, uint32_t item);
/* Nothing happens while the box stays within its margin. O(log n) else. */
CN_API cn_result cn_tree_move(cn_tree *tree, uint32_t item, const cn_aabb *box);
CN_API cn_result cn_tree_get_box(const cn_tree *tree, uint32_t item, cn_aabb *out);
CN_API cn_result cn_tree_query(const cn_tree *tree, const cn_aabb *box, cn_tree_query_fn *visit, void *user);
CN_API cn_result cn_tree_cast_ray(const cn_tree *tree, const cn_ray *ray, cn_tree_ray_fn *visit, void *user);
/* Number of items and height of the tree. */
CN_API cn_result cn_tree_get_stats(const cn_tree *tree, int32_t *out_count, int32_t *out_height);

#ifdef __cplusplus
}
#endif

#endif
