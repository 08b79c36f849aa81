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
 * Rules of every function here (each function's own comment adds only its particulars):
 *
 *  Units      metres, kilograms, seconds, radians; counter-clockwise is positive; field names end
 *             in their unit where it is not the obvious one.
 *  Handles    32 bits: index, kind, generation. 0 is never valid. A handle that is stale, of another
 *             kind or out of range gives CN_ERROR_HANDLE in every build, never undefined behaviour.
 *             A handle belongs to the world that made it; another world may not detect a foreign handle. A
 *             stale handle is refused until its world has created (2^20 - n) * 1023 more objects of its kind,
 *             with n the most that were alive at once: a billion in most worlds. Joints and constraints
 *             count together. The memory for this does not grow with the number of objects created.
 *  Errors     a call that can fail returns cn_result. When it is not CN_OK nothing has changed, and
 *             cn_world_error_text gives one sentence with the value and the allowed range if the
 *             function takes a non-const world (other functions may run on several threads and return
 *             the code only). Every function that creates something can return CN_ERROR_MEMORY and
 *             CN_ERROR_CAPACITY; functions that end contacts reserve memory for their events first
 *             and can return CN_ERROR_MEMORY.
 *  Floats     NaN and infinity give CN_ERROR_ARGUMENT everywhere. Positions and anchors that
 *             a world stores are at most 1e6 length units in size, angles at most 1e4 radians.
 *  Pointers   NULL gives CN_ERROR_ARGUMENT except where a comment allows it. Output pointers
 *             come last and are written only on CN_OK. Arrays returned by pointer and count belong
 *             to the world and are valid until the next cn_world_step or cn_world_destroy.
 *  Structs    initialise definitions with their *_init function; their first field, struct_size,
 *             tells the library which version of the struct it was given. Fields are only appended.
 *  Defaults   the *_init function stores the default of every field of a definition. Where the default is no
 *             number in the field's range (it depends on the world, or means "no limit", "rigid", "never"),
 *             the field holds CN_DEFAULT, and only exactly this value stands for the default. Zero always
 *             means zero; it is refused where it is out of range. No field takes zero for the default.
 *  Threads    one world may be used by one thread at a time; different worlds share nothing, so any
 *             number may be used at once. Functions that take a const cn_world may be called from
 *             several threads at once while no other function runs on that world. Inside cn_world_step
 *             several workers may share the work (worker_count in cn_world_def). They finish before the
 *             step returns and change no bit of any result; the user's callbacks and memory hooks are
 *             still called one at a time.
 *  Callbacks  while a callback runs the world is locked: reading works, and every function that takes
 *             a non-const cn_world returns CN_ERROR_LOCKED.
 *  Cost       O(1) unless the comment gives another.
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

/* Incompatible changes of the API. */
#define CN_VERSION_MAJOR 0
/* Compatible additions. */
#define CN_VERSION_MINOR 1
/* Corrections. */
#define CN_VERSION_PATCH 0

/* Raised whenever a struct layout or a function signature changes. */
#define CN_ABI_VERSION 3

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

/* In a definition: the default of a field whose comment names CN_DEFAULT; other fields refuse it where it is out of their range. */
enum { CN_DEFAULT = -1 };

typedef int32_t cn_result; /* CN_OK or a CN_ERROR_ */
/* Result codes. */
enum {
	CN_OK = 0,              /* success */
	CN_ERROR_ARGUMENT = -1, /* a value is NaN, infinite, out of range, NULL or degenerate */
	CN_ERROR_HANDLE = -2,   /* a handle is stale, of the wrong kind or 0 */
	CN_ERROR_MEMORY = -3,   /* the allocator or the fixed block has no room */
	CN_ERROR_LOCKED = -4,   /* called from inside a callback */
	CN_ERROR_CAPACITY = -5, /* more than CN_MAX_HANDLES things, or an output array too small */
	CN_ERROR_STATE = -6,    /* the object is in a state that does not permit the call */
	CN_ERROR_INTERNAL = -7, /* cn_world_validate found a broken invariant: a bug in Cairn */
	CN_ERROR_FORMAT = -8    /* the bytes are no saved world, or are damaged */
};

/* With CN_STRICT_HANDLES defined before this header, handles are distinct types in C++11 and later: a shape or a number in the place of
   a body does not compile; cn_body{} is no body. Size, value and calling convention are those of the numbers, as the standard has it. */
#if defined(__cplusplus) && defined(CN_STRICT_HANDLES)
enum cn_body : uint32_t {};
enum cn_shape : uint32_t {};
enum cn_joint : uint32_t {};
enum cn_constraint : uint32_t {};
#else
typedef uint32_t cn_body;          /* handle of a body; 0: none */
typedef uint32_t cn_shape;         /* handle of a shape; 0: none */
typedef uint32_t cn_joint;         /* handle of a joint; 0: none */
typedef uint32_t cn_constraint;    /* handle of a constraint on one body; 0: none */
#endif
typedef struct cn_world cn_world;  /* a world with everything in it */

/* A point, vector or pair of numbers. */
typedef struct cn_vec2 {
	float x; /* to the right */
	float y; /* upwards */
} cn_vec2;

/* Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be uploaded to a GPU directly. */
typedef struct cn_pose {
	cn_vec2 position_m; /* of the body's origin */
	float cosine;       /* of the angle */
	float sine;         /* of the angle */
} cn_pose;

/* Velocity of a body. */
typedef struct cn_velocity {
	cn_vec2 linear_mps;  /* of the centre of mass */
	float angular_radps; /* counter-clockwise is positive */
} cn_velocity;

/* Axis-aligned bounding box, lower_m <= upper_m. */
typedef struct cn_aabb {
	cn_vec2 lower_m; /* left and bottom */
	cn_vec2 upper_m; /* right and top */
} cn_aabb;

/* Mass, inertia and centre of mass. */
typedef struct cn_mass_data {
	float mass_kg;      /* of all shapes, or as set */
	float inertia_kgm2; /* about the centre of mass */
	cn_vec2 center_m;   /* in the body's local frame */
} cn_mass_data;

/* ------------------------------------------------------------------ library */

/* Version of the library as major * 1000000 + minor * 1000 + patch. */
CN_API int32_t cn_version(void);
/* CN_ABI_VERSION of the library that was linked; a binding compares it with its own. */
CN_API int32_t cn_abi_version(void);
/* English text for a result code: static, never NULL. */
CN_API const char *cn_result_text(cn_result result);

/* Structs, for cn_sizeof. */
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
	CN_TYPE_AREA_DEF = 54,
	CN_TYPE_COUNT = 55
};
/* sizeof the struct that a CN_TYPE_ constant names, 0 for an unknown constant; bindings check their layouts with it. */
CN_API int32_t cn_sizeof(int32_t type);

/* ------------------------------------------------------------------ world */

/* Memory hook: allocates bytes aligned to align, a power of two of at most 64; returns NULL when there is no memory. Called only from
   inside functions that take a non-const world. */
typedef void *cn_alloc_fn(uint64_t bytes, uint32_t align, void *user);
/* Memory hook: frees memory of cn_alloc_fn; bytes is the size it was allocated with. */
typedef void cn_free_fn(void *memory, uint64_t bytes, void *user);

/* The library's part of a user's task system (cn_world_def.enqueue and finish, for worlds with worker_count of 2 or more; without them
   the world starts its own threads). Call it for ranges [begin, end) that together cover 0 to item_count - 1, each item once, on any
   threads, in any order. A call may last as long as the step and may wait for calls that have begun, never for one that has not. Its
   thread must have the floating-point mode of the stepping thread. */
typedef void cn_task_fn(int32_t begin, int32_t end, void *context);
/* Starts a task of item_count items (worker_count - 1) in ranges of at least min_range and returns a handle for finish. It may run the
   whole task at once, and must do so if it cannot store the task; it then returns NULL, and finish is not called. A step with enough
   work enqueues 3 to 10 tasks; enqueue and finish run in the stepping thread, never during a callback, and must not call the library. */
typedef void *cn_enqueue_fn(cn_task_fn *task, void *context, int32_t item_count, int32_t min_range, void *user);
/* Returns when every item of the task has run; it may run items itself. Called once for each enqueue that did not return NULL, in the
   thread that enqueued. */
typedef void cn_finish_fn(void *task, void *user);

/* Flags of a world. */
enum {
	CN_WORLD_SLEEP = 1u << 0,       /* islands at rest fall asleep (default on) */
	CN_WORLD_WARM_START = 1u << 1,  /* start solving from the last step's impulses (default on) */
	CN_WORLD_PROFILE = 1u << 2,     /* measure cn_profile (default off: reading a clock costs time) */
	CN_WORLD_CONTINUOUS = 1u << 3   /* fast bodies stop at surfaces instead of passing through (default on) */
};

/* What a block of fixed capacities (cn_world_def.memory) has room for from the beginning. */
enum {
	CN_RESERVE_NAMES = 1u << 0,      /* a name of each body */
	CN_RESERVE_CHAINS = 1u << 1,     /* chains; cn_material.user_id of each shape */
	CN_RESERVE_EXTRA_ROWS = 1u << 2, /* rolling resistance, conveyors, locked axes */
	CN_RESERVE_MOVED = 1u << 3       /* lists of moved bodies, interpolated poses */
};

/* Solvers: see examples/docs/solvers.md. */
enum {
	CN_SOLVER_AUTO = 0,      /* soft constraints with substeps, and direct solving of joints, leaning piles and heavily loaded piles */
	CN_SOLVER_SOFT = 1,      /* soft contact and joint constraints with substeps only (Catto, Solver2D, 2024) */
	CN_SOLVER_DIRECT = 2,    /* direct solving of all joints, and of all piles without joints, at any cost */
	CN_SOLVER_SEQUENTIAL = 3 /* the paper's twelve steps, once a step: a baseline (limits: examples/docs/limits.md) */
};

/* Broadphases. */
enum {
	CN_BROADPHASE_SWEEP = 0, /* tiled sweep-and-prune */
	CN_BROADPHASE_TREE = 1   /* dynamic AABB tree: for worlds of very mixed sizes with many region queries */
};

/* Definition of a world. */
typedef struct cn_world_def {
	uint32_t struct_size;             /* set by the init function */
	uint32_t flags;                   /* CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS */
	cn_vec2 gravity_mps2;             /* default (0, -10) */
	float length_unit_m;              /* a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1 */
	int32_t solver;                   /* CN_SOLVER_*; default CN_SOLVER_AUTO */
	int32_t broadphase;               /* CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP */
	int32_t substep_count;            /* 1 to 64; default 4 */
	float accuracy_m;                 /* CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit */
	int32_t work_budget;              /* limit of direct solving in a step, in factored blocks (joints, contacts and their fill),
	                                     substeps included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single
	                                     islands, and with CN_SOLVER_AUTO 512 contacts of a world */
	float restitution_threshold_mps;  /* slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit */
	float push_speed_max_mps;         /* greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved
	                                     joint closes (of its angles: rad/s, for each length unit), > 0; in a crowd the
	                                     speeds of neighbours add up: n bodies made in one spot leave it at some sqrt(n) / 2
	                                     times as much, on the ground, which pushes them upwards, at some sqrt(n) times;
	                                     CN_DEFAULT (default): 3 x length unit */
	float linear_speed_max_mps;       /* faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit */
	float angular_speed_max_radps;    /* faster bodies are slowed to it, > 0; default 400 */
	float sleep_speed_mps;            /* bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit */
	float sleep_delay_s;              /* ... after this time, >= 0; default 0.5 */
	int32_t body_capacity;            /* hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0; default 0 */
	int32_t shape_capacity;           /* counts every edge of a chain */
	int32_t contact_capacity;         /* pairs whose fat AABBs overlap */
	int32_t joint_capacity;           /* counts constraints too */
	uint64_t user_data;               /* a number for the user; default 0 */
	uint64_t memory_bytes;            /* size of memory; 0: use alloc and free */
	void *memory;                     /* NULL, or one block aligned to 64 bytes that holds the whole world */
	cn_alloc_fn *alloc;               /* NULL: malloc; set both or none */
	cn_free_fn *free;                 /* NULL: free */
	void *allocator_user;             /* last argument of alloc and free */
	cn_enqueue_fn *enqueue;           /* NULL: the world's own threads; set both or none */
	cn_finish_fn *finish;             /* see cn_finish_fn */
	void *task_user;                  /* last argument of enqueue and finish */
	int32_t worker_count;             /* threads that share a step, including the calling one; 1 to CN_WORKERS_MAX;
	                                     default 1: no threads, no tasks */
	float hit_speed_mps;              /* blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit */
	/* Of a world in one block (memory); others ignore them. */
	int32_t touching_capacity;        /* pairs that touch at once, >= 0; further ones do not collide: CN_WARNING_CONTACT_MEMORY;
	                                     CN_DEFAULT (default): contact_capacity */
	int32_t event_capacity;           /* pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which
	                                     cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity */
	int32_t vertex_capacity;          /* vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block;
	                                     default CN_POLYGON_MAX_VERTICES */
	uint32_t reserve;                 /* CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all */
} cn_world_def;

/* Sets struct_size and the defaults given beside the fields. NULL does nothing. Defaults that scale with the length unit are
   stored as CN_DEFAULT, which cn_world_create resolves. */
CN_API void cn_world_def_init(cn_world_def *def);
/* Checks a definition. Writes one sentence about its first error, at most text_bytes (>= 0) bytes with the terminating zero;
   text may be NULL when text_bytes is 0. */
CN_API cn_result cn_world_def_check(const cn_world_def *def, char *text, int32_t text_bytes);
/* Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here. */
CN_API cn_result cn_world_bytes_needed(const cn_world_def *def, uint64_t *out_bytes);
/* Creates a world. CN_ERROR_MEMORY also when a thread cannot be started. Each worker takes about 150 bytes of the world's
   memory; its stack comes from the system, even for a world in a caller's block. Without thread support (CN_NO_THREADS, or an
   unknown system) the world has one worker: see cn_world_get_worker_count. O(capacities). */
CN_API cn_result cn_world_create(const cn_world_def *def, cn_world **out_world);
/* Destroys a world, everything in it and its threads. A caller's block is free for other use afterwards. NULL, and a call
   from a callback, do nothing. O(memory blocks). */
CN_API void cn_world_destroy(cn_world *world);
/* Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion. O(awake bodies and
   their contacts and joints). */
CN_API cn_result cn_world_step(cn_world *world, float dt_s);
/* One sentence about the last call that failed on this world; "" if none failed or world is NULL. Valid until the next failing call. */
CN_API const char *cn_world_error_text(const cn_world *world);

/* Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies). */
CN_API cn_result cn_world_set_gravity(cn_world *world, float gravity_x_mps2, float gravity_y_mps2);
/* Reads gravity in m/s^2. */
CN_API cn_result cn_world_get_gravity(const cn_world *world, cn_vec2 *out_mps2);
/* Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more. */
CN_API cn_result cn_world_set_substep_count(cn_world *world, int32_t count);
/* Reads the substeps of a step. */
CN_API cn_result cn_world_get_substep_count(const cn_world *world, int32_t *out_count);
/* Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch memory of the solver
   it was created with; a solver that needs more works without direct solving (CN_WARNING_FRAME_MEMORY). */
CN_API cn_result cn_world_set_solver(cn_world *world, int32_t solver);
/* Reads the solver (CN_SOLVER_*). */
CN_API cn_result cn_world_get_solver(const cn_world *world, int32_t *out_solver);
/* Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT. */
CN_API cn_result cn_world_set_accuracy(cn_world *world, float accuracy_m, int32_t work_budget);
/* Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget (CN_DEFAULT: none). */
CN_API cn_result cn_world_get_accuracy(const cn_world *world, float *out_accuracy_m, int32_t *out_work_budget);
/* Reads how many workers a step can use: 1, or worker_count where the library supports threads. */
CN_API cn_result cn_world_get_worker_count(const cn_world *world, int32_t *out_count);
/* Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies). */
CN_API cn_result cn_world_set_flags(cn_world *world, uint32_t flags);
/* Reads the CN_WORLD_ flags. */
CN_API cn_result cn_world_get_flags(const cn_world *world, uint32_t *out_flags);
/* Impacts slower than this, in m/s, do not bounce; >= 0. */
CN_API cn_result cn_world_set_restitution_threshold(cn_world *world, float speed_mps);
/* Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0. */
CN_API cn_result cn_world_set_hit_speed(cn_world *world, float speed_mps);
/* Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster bodies down to them and
   keeps the direction. */
CN_API cn_result cn_world_set_speed_limits(cn_world *world, float linear_mps, float angular_radps);
/* Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which they do. Where all but one in 64
   bodies of an island, or but one, have rested for four delays, those others that no joint holds and that are slower than four times the
   speed lose theirs within a second or two: what rocks in a hollow would keep all of a heap awake. */
CN_API cn_result cn_world_set_sleep(cn_world *world, float speed_mps, float delay_s);
/* Stores a number for the user. */
CN_API cn_result cn_world_set_user_data(cn_world *world, uint64_t user_data);
/* Reads the user's number. */
CN_API cn_result cn_world_get_user_data(const cn_world *world, uint64_t *out_user_data);

/* Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when capacity is 0.
   *out_count is their number. O(slots). */
CN_API cn_result cn_world_get_bodies(const cn_world *world, cn_body *out, int32_t capacity, int32_t *out_count);
/* Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots). */
CN_API cn_result cn_world_get_shapes(const cn_world *world, cn_shape *out, int32_t capacity, int32_t *out_count);
/* Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots). */
CN_API cn_result cn_world_get_joints(const cn_world *world, cn_joint *out, int32_t capacity, int32_t *out_count);

/* Counts of objects, and problems of the last step. */
typedef struct cn_counters {
	int32_t bodies;              /* alive */
	int32_t bodies_awake;        /* dynamic and kinematic bodies that are simulated */
	int32_t shapes;              /* alive */
	int32_t proxies;             /* boxes in the broadphase: one per shape, one per edge of a chain */
	int32_t contacts;            /* pairs whose fat boxes overlap */
	int32_t contacts_awake;      /* with an awake body */
	int32_t contacts_touching;   /* pairs with a manifold, asleep or awake */
	int32_t joints;              /* and constraints */
	int32_t joints_awake;        /* and constraints, with an awake body */
	int32_t islands;             /* awake and asleep; a single dynamic body counts */
	int32_t islands_awake;       /* of them */
	int32_t colors_used;         /* groups of contacts that share no dynamic body */
	int32_t overflow_contacts;   /* contacts that fit no colour: solved one by one */
	int32_t broadphase_tiles;    /* cells of the broadphase */
	uint32_t steps;              /* steps taken since creation, modulo 2^32 */
	/* Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again. */
	uint32_t warnings;           /* CN_WARNING_* */
	int32_t pairs_not_added;     /* new pairs without a contact */
	int32_t events_not_reported; /* events without a place in a log */
	int32_t islands_direct;      /* of several bodies, solved directly in the last step, contacts included */
	int32_t direct_work;         /* planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1 */
	int32_t islands_unsolved;    /* of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET */
} cn_counters;
/* Warnings of a step that lacked memory or skipped work. */
enum {
	CN_WARNING_CONTACT_MEMORY = 1u << 0, /* new contacts were not added: pairs_not_added */
	CN_WARNING_FRAME_MEMORY = 1u << 1,   /* the step worked around missing scratch memory */
	CN_WARNING_EVENT_MEMORY = 1u << 2,   /* events_not_reported */
	CN_WARNING_CROWD = 1u << 3,          /* thousands of boxes overlap in one spot: contacts of the most crowded bodies come over several
	                                        steps, and pairs_not_added counts what the last step left out */
	CN_WARNING_NOT_FINITE = 1u << 4      /* forces or impulses gave bodies a speed that floats cannot hold: these bodies were stopped at
	                                        their poses, and the others go on */
};
/* Reads counts of objects and what the last step reported. O(bodies + islands). */
CN_API cn_result cn_world_get_counters(const cn_world *world, cn_counters *out);

/* How an island is solved. In each tier joints may be solved together with their neighbours. */
enum {
	CN_TIER_SOFT = 0,   /* contacts by soft constraints */
	CN_TIER_DIRECT = 1, /* contacts and joints in one system, exactly */
	CN_TIER_FREE = 2    /* no contacts and no joints: nothing to solve */
};
/* Why an island has its tier. "A problem" is one of CN_TIER_REASON_NEW_CONTACT, _OVERLAP and _STRESSED. */
enum {
	CN_TIER_REASON_NONE = 0,        /* no problem */
	CN_TIER_REASON_SETTLING = 1,    /* direct: the problem has ended, but not for long enough */
	CN_TIER_REASON_NEW_CONTACT = 2, /* direct: a contact began to carry load in a leaning or heavily loaded island */
	CN_TIER_REASON_OVERLAP = 3,     /* direct: an overlap exceeds the accuracy */
	CN_TIER_REASON_JOINT = 4,       /* no longer used */
	CN_TIER_REASON_STRESSED = 5,    /* direct: a body carries so many times its weight that soft contacts would yield */
	CN_TIER_REASON_SOLVER = 6,      /* the world's solver is not CN_SOLVER_AUTO */
	CN_TIER_REASON_OVERRIDE = 7,    /* a body's own solver: cn_body_set_solver */
	CN_TIER_REASON_ALONE = 8,       /* soft: a single body */
	CN_TIER_REASON_MOVING = 9,      /* soft: a problem, but the island moves too fast, bounces, or did a short time ago */
	CN_TIER_REASON_CROWDED = 10,    /* soft: a problem, but the island or the sum of such islands is too large */
	CN_TIER_REASON_WORK = 11,       /* soft for a time: the system exceeds the work limit or the work_budget */
	CN_TIER_REASON_KIND = 12,       /* soft for a time: a conveyor, a locked axis, or rolling resistance at a single point */
	CN_TIER_REASON_NO_SET = 13,     /* soft for a time: no solution was found for its contacts; it stays awake while it moves at all */
	CN_TIER_REASON_MEMORY = 14,     /* soft: no scratch memory (CN_WARNING_FRAME_MEMORY) */
	CN_TIER_REASON_JOINTED = 15     /* soft contacts: a problem, but the island has joints (which are solved directly) */
};
/* Report on one island. */
typedef struct cn_island_report {
	cn_body body;        /* its body of least slot */
	int32_t bodies;      /* dynamic */
	int32_t contacts;    /* touching */
	int32_t joints;      /* and constraints */
	int32_t tier;        /* CN_TIER_*, after the last step */
	int32_t reason;      /* CN_TIER_REASON_* */
	int32_t substeps;    /* of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more */
	float residual_m;    /* at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
	                        that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count */
} cn_island_report;
/* Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in a deterministic
   order, then single bodies. Writes at most capacity (>= 0); *out_count is their number. A step does no work for it. O(bodies
   + contacts and joints of the islands written). */
CN_API cn_result cn_world_get_islands(const cn_world *world, cn_island_report *out, int32_t capacity, int32_t *out_count);

/* Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set. */
typedef struct cn_profile {
	float step_s;         /* the whole step */
	float wake_s;         /* waking */
	float broadphase_s;   /* pairs */
	float narrowphase_s;  /* manifolds */
	float islands_s;      /* islands */
	float prepare_s;      /* constraints, plans */
	float substeps_s;     /* all substeps */
	float finalize_s;     /* poses and boxes */
	float events_s;       /* callbacks */
	float sleep_s;        /* falling asleep */
} cn_profile;
/* Reads the seconds of the last step by stage. */
CN_API cn_result cn_world_get_profile(const cn_world *world, cn_profile *out);

/* Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block allocator serves small
   variable-size pieces from free lists of size classes. */
typedef struct cn_memory_stats {
	uint64_t bytes_in_use;         /* taken from the user's allocator or carved from the fixed block */
	uint64_t bytes_peak;           /* most bytes_in_use since creation */
	uint64_t allocator_calls;      /* calls of the user's alloc (or of the fixed block's) since creation */
	uint64_t arena_capacity;       /* of the frame arena */
	uint64_t arena_peak;           /* most bytes in use at once since creation */
	uint64_t arena_fallbacks;      /* entries that did not fit: the allocator served them; since creation */
	uint64_t blocks_capacity;      /* bytes in chunks */
	uint64_t blocks_in_use;        /* bytes handed out of them */
	uint64_t blocks_large;         /* blocks above the largest class, served by the allocator */
} cn_memory_stats;
/* Reads the memory statistics. */
CN_API cn_result cn_world_get_memory_stats(const cn_world *world, cn_memory_stats *out);

/* Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position p becomes p - (x_m, y_m), so that a
   large world stays precise near its player. Moves bodies, boxes, world anchors of joints, and poses for interpolation; velocities,
   impulses, sleep and contacts stay, and no event is reported. Distances between bodies keep their digits; world anchors are
   rounded to floats at the new place. Arrays returned before become invalid; the user moves their own points (movers, rays, cached
   poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all pairs again. */
CN_API cn_result cn_world_shift_origin(cn_world *world, float x_m, float y_m);

/* 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every contact's impulses and
   the solver's memory of joints, by slot. Equal histories give equal hashes on every compiler, CPU and thread count. O(bodies
   + contacts + joints). */
CN_API cn_result cn_world_hash(const cn_world *world, uint64_t *out_hash);
/* Checks every invariant between the tables. CN_ERROR_INTERNAL, and one sentence in text, for the first that is broken. text
   holds at most text_bytes (>= 0) bytes with the zero and may be NULL when text_bytes is 0. O(everything). */
CN_API cn_result cn_world_validate(const cn_world *world, char *text, int32_t text_bytes);

/* ------------------------------------------------------------------ saving and restoring */

/* Rollback: the whole state of a world between two steps, in the caller's memory. With the same calls a restored world continues bit for
   bit as after the save and returns the same handles. The state includes bodies, shapes, joints, contacts with their impulses, sleep,
   forces set for the next step, settings, events of the last step and pending ones, time owed by cn_world_update, names and user data.
   Memory, workers, callbacks and the sentence of cn_world_error_text are not part of it.

   A save is valid for one version of the library on one kind of machine while a program runs. It is no file format and not safe against
   forged bytes; a checksum detects damage. */

/* Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots). */
CN_API cn_result cn_world_save_size(const cn_world *world, uint64_t *out_bytes);
/* Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of bytes to
   out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB per body. */
CN_API cn_result cn_world_save(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes);
/* Restores a saved state, into the saved world or one created with the same definition (broadphase, length unit, caller's
   block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT for damaged bytes or another version
   or machine; CN_ERROR_MEMORY without room for the objects alive then (a world in a caller's block has room for its own
   saves). Arrays returned before become invalid. Handles of objects alive at the save are valid again, also of objects
   destroyed since; handles created since are refused until the same handle is given to a new object: with the same calls to
   the same object. O(memory of the world). */
CN_API cn_result cn_world_restore(cn_world *world, const void *save, uint64_t bytes);

/* What one save has changed against an earlier one, the base, of the same world: for long rings of saves. It holds the words of
   8 bytes that differ, so bodies that sleep take nothing; a table that has grown since the base moves what follows it, and the delta is
   nearly a whole save. The functions know bytes only and no world. Neither bytes nor pointers may be NULL; out may not overlap the others. */

/* Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes). */
CN_API cn_result cn_save_delta_size(const void *base, uint64_t base_bytes, const void *save, uint64_t save_bytes, uint64_t *out_bytes);
/* Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to out_bytes, which may be NULL.
   CN_ERROR_FORMAT as above. O(bytes). */
CN_API cn_result cn_save_delta(const void *base, uint64_t base_bytes, const void *save, uint64_t save_bytes, void *out, uint64_t capacity, uint64_t *out_bytes);
/* Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to out_bytes, which may be NULL.
   CN_ERROR_FORMAT if the delta is damaged or of another base, CN_ERROR_CAPACITY if out is too small. O(bytes). */
CN_API cn_result cn_save_apply(const void *base, uint64_t base_bytes, const void *delta, uint64_t delta_bytes, void *out, uint64_t capacity, uint64_t *out_bytes);

/* ------------------------------------------------------------------ files */

/* A world as bytes for files and networks: little-endian and of fixed widths, so equal worlds write the same bytes on every machine.
   With the same calls the world that is read continues bit for bit like the written one, on every machine, and the game's handles
   are valid in it. A file holds what a save holds (see above), names and user data included; memory, workers and callbacks come
   from the definition and from calls. Only the broadphase is built anew, which its own figures in cn_counters show.

   Later versions of the library read the files of earlier ones; across versions the world is the same, its future need not be
   bit for bit. Bytes from anywhere are safe: whatever is no written world gives CN_ERROR_FORMAT. Memory taken is proportional to the
   bytes; a step's cost is that of the world they describe. */

/* Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots). */
CN_API cn_result cn_world_write_size(const cn_world *world, uint64_t *out_bytes);
/* Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of bytes to out_bytes, which
   may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB per body. */
CN_API cn_result cn_world_write(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes);
/* Creates a world from bytes of cn_world_write (bytes: exactly as many). def, which may be NULL for defaults, gives memory, workers and
   capacities (which a caller's block needs); its settings are not used, the file's are. CN_ERROR_FORMAT for damaged or forged bytes,
   CN_ERROR_MEMORY without room, CN_ERROR_ARGUMENT for a definition that cn_world_create refuses. O(memory of the world). */
CN_API cn_result cn_world_read(const cn_world_def *def, const void *file, uint64_t bytes, cn_world **out_world);

/* ------------------------------------------------------------------ bodies */

/* Types of bodies. */
enum {
	CN_BODY_STATIC = 0,    /* never moves, infinite mass */
	CN_BODY_KINEMATIC = 1, /* moves by its velocity alone, infinite mass */
	CN_BODY_DYNAMIC = 2    /* moves by forces, contacts and joints */
};

/* Flags of a body. */
enum {
	CN_BODY_LOCK_X = 1u << 0,          /* the centre of mass keeps its world x */
	CN_BODY_LOCK_Y = 1u << 1,          /* ... its world y */
	CN_BODY_LOCK_ROTATION = 1u << 2,   /* the body keeps its angle */
	CN_BODY_BULLET = 1u << 3,          /* continuous collision against dynamic bodies too */
	CN_BODY_ENABLED = 1u << 4,         /* takes part in the simulation (default on) */
	CN_BODY_SLEEP = 1u << 5,           /* may fall asleep (default on) */
	CN_BODY_AWAKE = 1u << 6            /* starts awake (default on) */
};

/* Definition of a body. */
typedef struct cn_body_def {
	uint32_t struct_size;          /* set by the init function */
	int32_t type;                  /* CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic */
	cn_vec2 position_m;            /* of the origin; |x|, |y| <= 1e6 x length unit */
	float angle_rad;               /* |angle| <= 1e4 */
	cn_vec2 linear_velocity_mps;   /* of the centre of mass; both velocities are ignored without CN_BODY_AWAKE */
	float angular_velocity_radps;  /* default 0 */
	float linear_damping_per_s;    /* v' = -damping v; >= 0, default 0 */
	float angular_damping_per_s;   /* >= 0, default 0 */
	float gravity_scale;           /* default 1 */
	float sleep_speed_mps;         /* >= 0; CN_DEFAULT (default): the world's */
	uint32_t flags;                /* CN_BODY_*; default ENABLED | SLEEP | AWAKE */
	int32_t solver;                /* as in cn_body_set_solver; default CN_SOLVER_AUTO */
	uint64_t user_data;            /* a number for the user; default 0 */
	const char *name;              /* NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied */
} cn_body_def;

/* Sets struct_size and the defaults given beside the fields. NULL does nothing. */
CN_API void cn_body_def_init(cn_body_def *def);
/* Creates a body. O(1) amortized. */
CN_API cn_result cn_body_create(cn_world *world, const cn_body_def *def, cn_body *out_body);
/* Creates count (>= 0) bodies from an array of definitions, all or none. O(count). */
CN_API cn_result cn_body_create_many(cn_world *world, const cn_body_def *defs, int32_t count, cn_body *out_bodies);
/* Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching contacts get their
   LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts + joints + shapes). */
CN_API cn_result cn_body_destroy(cn_world *world, cn_body body);
/* Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice. O(their contacts + joints + shapes). */
CN_API cn_result cn_body_destroy_many(cn_world *world, const cn_body *bodies, int32_t count);
/* 1 if the handle names a living body of this world, else 0 (also for a NULL world). */
CN_API int32_t cn_body_is_valid(const cn_world *world, cn_body body);

/* Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that still overlap
   begin again in the next step), with its forces and any mass override; a body made static stops. CN_ERROR_STATE if a joint
   would be left without a dynamic body. O(contacts + joints + shapes). */
CN_API cn_result cn_body_set_type(cn_world *world, cn_body body, int32_t type);
/* Reads the type (CN_BODY_*). */
CN_API cn_result cn_body_get_type(const cn_world *world, cn_body body, int32_t *out_type);
/* Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without CN_BODY_ENABLED a body
   keeps its shapes but does not move or collide; its contacts end and its joints are inactive. O(contacts + joints + shapes)
   when CN_BODY_ENABLED changes. */
CN_API cn_result cn_body_set_flags(cn_world *world, cn_body body, uint32_t flags);
/* Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake. */
CN_API cn_result cn_body_get_flags(const cn_world *world, cn_body body, uint32_t *out_flags);
/* 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled bodies are
   unchanged. 0 can return CN_ERROR_MEMORY. O(island). */
CN_API cn_result cn_body_set_awake(cn_world *world, cn_body body, int32_t awake);

/* Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <= 1e4). Velocities stay.
   Contacts whose boxes no longer overlap end at once, and the next step reports them. Gaps of its joints close at some 15 length
   units a second. Wakes the body and its new and old neighbours. O(contacts + joints + shapes). */
CN_API cn_result cn_body_set_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad);
/* Reads the position of the origin and the rotation. */
CN_API cn_result cn_body_get_pose(const cn_world *world, cn_body body, cn_pose *out);
/* Reads the position of the origin as the sum of two floats: the high part is within rounding that of cn_body_get_pose, the low part
   holds the digits that do not fit. Far from the origin their sum in double is more precise; so is a difference of two bodies, taken high
   from high and low from low, in floats. */
CN_API cn_result cn_body_get_position_parts(const cn_world *world, cn_body body, cn_vec2 *out_high_m, cn_vec2 *out_low_m);
/* Reads the angle in radians, in (-pi, pi]. */
CN_API cn_result cn_body_get_angle(const cn_world *world, cn_body body, float *out_rad);
/* Reads the world position of the centre of mass, in metres. */
CN_API cn_result cn_body_get_center(const cn_world *world, cn_body body, cn_vec2 *out_m);
/* Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite. CN_ERROR_STATE for static
   bodies. Wakes the body unless all are 0. */
CN_API cn_result cn_body_set_velocity(cn_world *world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps);
/* Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s). */
CN_API cn_result cn_body_get_velocity(const cn_world *world, cn_body body, cn_velocity *out);
/* Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it to a pose
   (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike after cn_body_set_pose, bodies
   on it or in its way move along. The velocity stays: call this before every step, or stop the body after it. */
CN_API cn_result cn_body_set_target_pose(cn_world *world, cn_body body, float position_x_m, float position_y_m, float angle_rad,
	float dt_s);
/* Velocity in m/s of the body's material at a world point in metres. */
CN_API cn_result cn_body_get_velocity_at(const cn_world *world, cn_body body, float point_x_m, float point_y_m, cn_vec2 *out_mps);
/* World position of a point given in the body's frame, both in metres. */
CN_API cn_result cn_body_get_world_point(const cn_world *world, cn_body body, float local_x_m, float local_y_m, cn_vec2 *out_m);
/* Position in the body's frame of a world point, both in metres. */
CN_API cn_result cn_body_get_local_point(const cn_world *world, cn_body body, float world_x_m, float world_y_m, cn_vec2 *out_m);
/* Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes. O(shapes). */
CN_API cn_result cn_body_get_aabb(const cn_world *world, cn_body body, cn_aabb *out);

/* Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic and disabled bodies
   are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows. */
CN_API cn_result cn_body_apply_force(cn_world *world, cn_body body, float force_x_N, float force_y_N);
/* Adds a force in newtons at a world point in metres, hence a torque too; otherwise as cn_body_apply_force. */
CN_API cn_result cn_body_apply_force_at(cn_world *world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m);
/* Adds a torque in newton metres; otherwise as cn_body_apply_force. */
CN_API cn_result cn_body_apply_torque(cn_world *world, cn_body body, float torque_Nm);
/* Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body. Static, kinematic and
   disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity overflows. */
CN_API cn_result cn_body_apply_impulse(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns);
/* Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too; otherwise as
   cn_body_apply_impulse. */
CN_API cn_result cn_body_apply_impulse_at(cn_world *world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m);
/* Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as cn_body_apply_impulse. */
CN_API cn_result cn_body_apply_angular_impulse(cn_world *world, cn_body body, float impulse_Nms);

/* Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose shapes have no mass
   weighs 1 kg; without shapes it does not rotate. */
CN_API cn_result cn_body_get_mass_data(const cn_world *world, cn_body body, cn_mass_data *out);
/* Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a change of type:
   mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes the body. */
CN_API cn_result cn_body_set_mass_data(cn_world *world, cn_body body, const cn_mass_data *mass);
/* Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes). */
CN_API cn_result cn_body_reset_mass_data(cn_world *world, cn_body body);
/* Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0. */
CN_API cn_result cn_body_set_damping(cn_world *world, cn_body body, float linear_per_s, float angular_per_s);
/* Reads the linear and angular damping in 1/s. */
CN_API cn_result cn_body_get_damping(const cn_world *world, cn_body body, float *out_linear_per_s, float *out_angular_per_s);
/* Sets the factor on gravity for this body, finite. A change wakes the body. */
CN_API cn_result cn_body_set_gravity_scale(cn_world *world, cn_body body, float scale);
/* Reads the factor on gravity. */
CN_API cn_result cn_body_get_gravity_scale(const cn_world *world, cn_body body, float *out_scale);
/* Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's. */
CN_API cn_result cn_body_set_sleep_speed(cn_world *world, cn_body body, float speed_mps);
/* Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): the world
   chooses. _SOFT: contacts and joints are never solved directly, whatever other bodies ask for. _DIRECT: the island is solved
   directly at any speed, where its contacts permit it and within the work_budget. Takes effect with the next step; does not
   wake. */
CN_API cn_result cn_body_set_solver(cn_world *world, cn_body body, int32_t solver);
/* Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT). */
CN_API cn_result cn_body_get_solver(const cn_world *world, cn_body body, int32_t *out_solver);
/* Stores a number for the user. */
CN_API cn_result cn_body_set_user_data(cn_world *world, cn_body body, uint64_t user_data);
/* Reads the user's number. */
CN_API cn_result cn_body_get_user_data(const cn_world *world, cn_body body, uint64_t *out_user_data);
/* Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it. O(length). */
CN_API cn_result cn_body_set_name(cn_world *world, cn_body body, const char *name);
/* Reads the name, "" if there is none. Valid until the name changes or the body is destroyed. */
CN_API cn_result cn_body_get_name(const cn_world *world, cn_body body, const char **out_name);

/* Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes). */
CN_API cn_result cn_body_get_shapes(const cn_world *world, cn_body body, cn_shape *out, int32_t capacity, int32_t *out_count);
/* Handles of the body's joints without constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints). */
CN_API cn_result cn_body_get_joints(const cn_world *world, cn_body body, cn_joint *out, int32_t capacity, int32_t *out_count);

/* Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be their number. One
   bad handle fails the whole call. O(count). */
CN_API cn_result cn_world_read_poses(const cn_world *world, const cn_body *bodies, int32_t count, cn_pose *out);
/* Reads count cn_pose at intervals of stride_bytes (0, tightly packed, or >= 16); otherwise as cn_world_read_poses. O(count). */
CN_API cn_result cn_world_read_poses_strided(const cn_world *world, const cn_body *bodies, int32_t count, void *out, int32_t stride_bytes);
/* Reads count velocities; bodies and count as in cn_world_read_poses. O(count). */
CN_API cn_result cn_world_read_velocities(const cn_world *world, const cn_body *bodies, int32_t count, cn_velocity *out);
/* Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static bodies take zero
   only (CN_ERROR_STATE). One bad entry fails the whole call. O(count). */
CN_API cn_result cn_world_write_velocities(cn_world *world, const cn_body *bodies, int32_t count, const cn_velocity *velocities);

/* A body that moved or fell asleep in the last step. */
typedef struct cn_body_moved {
	cn_pose pose;         /* after the step */
	uint64_t user_data;   /* the body's */
	cn_body body;         /* that moved */
	uint32_t fell_asleep; /* 1 in the step in which it fell asleep */
} cn_body_moved;
/* Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The first call after a
   step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY. */
CN_API cn_result cn_world_moved(cn_world *world, const cn_body_moved **out_moved, int32_t *out_count);

/* ------------------------------------------------------------------ shapes */

/* Types of shapes. */
enum {
	CN_SHAPE_CIRCLE = 0,
	CN_SHAPE_CAPSULE = 1,
	CN_SHAPE_POLYGON = 2,
	CN_SHAPE_EDGE = 3,
	CN_SHAPE_CHAIN = 4
};

/* Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others collide if the category of each
   has a bit in the mask of the other. */
typedef struct cn_filter {
	uint64_t category; /* default 1 */
	uint64_t mask;     /* default all ones */
	int32_t group;     /* default 0 */
	uint32_t reserved; /* 0 */
} cn_filter;

/* How the values of two materials are mixed. If the materials have different rules, the later one of this list applies. */
enum {
	CN_MIX_AVERAGE = 0,   /* half the sum */
	CN_MIX_GEOMETRIC = 1, /* square root of the product; default for friction */
	CN_MIX_MINIMUM = 2,   /* the smaller one */
	CN_MIX_MULTIPLY = 3,  /* the product */
	CN_MIX_MAXIMUM = 4    /* the greater one; default for restitution */
};

/* Surface of a shape. */
typedef struct cn_material {
	float static_friction;    /* coefficient while sticking, [0, 100], default 0.6 */
	float dynamic_friction;   /* coefficient while sliding, [0, static_friction], default 0.6 */
	float restitution;        /* [0, 1], default 0 */
	float rolling_resistance; /* metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0 */
	float tangent_speed_mps;  /* conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0 */
	int32_t friction_mix;     /* CN_MIX_*; default CN_MIX_GEOMETRIC */
	int32_t restitution_mix;  /* CN_MIX_*; default CN_MIX_MAXIMUM */
	uint32_t user_id;         /* a number for the user, reported in contact events; default 0 */
} cn_material;

/* Flags of a shape. */
enum {
	CN_SHAPE_SENSOR = 1u << 0,       /* detects shapes that enter and leave, collides with nothing: cn_world_sensor_events */
	CN_SHAPE_SENSOR_SEEN = 1u << 1,  /* queries see this sensor (default: they do not) */
	CN_SHAPE_ONE_WAY = 1u << 2,      /* collides only with shapes that come from the side of its local +y axis */
	CN_SHAPE_PRE_SOLVE = 1u << 3     /* the pre-solve callback is called for its contacts */
};

/* Kinds of contact events. */
enum {
	CN_EVENT_CREATED = 0,   /* the fat boxes of two shapes began to overlap */
	CN_EVENT_ENTER = 1,     /* they began to touch */
	CN_EVENT_STAY = 2,      /* they still touch */
	CN_EVENT_LEAVE = 3,     /* they stopped touching, or one is gone */
	CN_EVENT_DESTROYED = 4, /* the fat boxes no longer overlap, or one is gone */
	CN_EVENT_HIT = 5,       /* a blow at hit_speed_mps of cn_world_def or faster, at the beginning of touching or within it */
	CN_EVENT_KINDS = 6      /* number of kinds */
};

/* Definition of a shape. */
typedef struct cn_shape_def {
	uint32_t struct_size;     /* set by the init function */
	cn_body body;             /* 0: create unattached, for cn_shape_attach */
	cn_vec2 offset_m;         /* of the shape in the body's local frame */
	float angle_rad;          /* of the shape in the body's local frame */
	float density_kgpm2;      /* >= 0, giving 0 or 1e-20 to 1e20 kg; default 1 */
	cn_material material;     /* defaults: see cn_material */
	cn_filter filter;         /* defaults: see cn_filter */
	uint32_t event_mask;      /* bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE */
	uint32_t flags;           /* CN_SHAPE_SENSOR ...; default 0 */
	uint64_t user_data;       /* a number for the user; default 0 */
} cn_shape_def;

/* A disc. */
typedef struct cn_circle {
	cn_vec2 center_m; /* in the body's frame */
	float radius_m;   /* > 0 */
} cn_circle;

/* All points within radius_m of the segment. */
typedef struct cn_capsule {
	cn_vec2 a_m;    /* one end of the segment, in the body's frame */
	cn_vec2 b_m;    /* the other end */
	float radius_m; /* around the segment, > 0 */
} cn_capsule;

/* A two-sided segment without mass. */
typedef struct cn_edge {
	cn_vec2 a_m; /* one end, in the body's frame */
	cn_vec2 b_m; /* the other end */
} cn_edge;

/* Convex polygon. Either winding is accepted; points are stored counter-clockwise. */
typedef struct cn_polygon {
	int32_t count;   /* 3 to CN_POLYGON_MAX_VERTICES */
	float radius_m;  /* rounding added outside the points, >= 0 */
	cn_vec2 points_m[CN_POLYGON_MAX_VERTICES]; /* the first count of them; in the body's frame */
} cn_polygon;

/* One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is on the left of the order of
   points and surface normals point to the right: points that run from +x to -x collide from above, a counter-clockwise loop collides
   from outside. */
typedef struct cn_chain {
	const cn_vec2 *points_m;  /* copied */
	int32_t count;            /* an open chain: >= 2; a loop: >= 3; at most 65535 */
	uint32_t loop;            /* 1: the last point joins the first */
} cn_chain;

/* Sets struct_size and the defaults given beside the fields. NULL does nothing. */
CN_API void cn_shape_def_init(cn_shape_def *def);
/* Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL. */
CN_API cn_result cn_shape_create_circle(cn_world *world, const cn_shape_def *def, const cn_circle *circle, cn_shape *out_shape);
/* Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body. out_shape may be NULL. */
CN_API cn_result cn_shape_create_capsule(cn_world *world, const cn_shape_def *def, const cn_capsule *capsule, cn_shape *out_shape);
/* Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL. */
CN_API cn_result cn_shape_create_edge(cn_world *world, const cn_shape_def *def, const cn_edge *edge, cn_shape *out_shape);
/* Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL. */
CN_API cn_result cn_shape_create_polygon(cn_world *world, const cn_shape_def *def, const cn_polygon *polygon, cn_shape *out_shape);
/* Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body. out_shape may be NULL. */
CN_API cn_result cn_shape_create_box(cn_world *world, const cn_shape_def *def, float half_width_m, float half_height_m, float radius_m, cn_shape *out_shape);
/* Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL. O(count). */
CN_API cn_result cn_shape_create_chain(cn_world *world, const cn_shape_def *def, const cn_chain *chain, cn_shape *out_shape);

/* Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one. CN_ERROR_STATE if the
   shape has a body. O(shapes of the body + edges of a chain). */
CN_API cn_result cn_shape_attach(cn_world *world, cn_shape shape, cn_body body);
/* Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body. O(contacts + shapes
   of the body). */
CN_API cn_result cn_shape_detach(cn_world *world, cn_shape shape);
/* Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body). */
CN_API cn_result cn_shape_destroy(cn_world *world, cn_shape shape);
/* 1 if the handle names a living shape of this world, else 0 (also for a NULL world). */
CN_API int32_t cn_shape_is_valid(const cn_world *world, cn_shape shape);
/* Reads the type (CN_SHAPE_CIRCLE to _CHAIN). */
CN_API cn_result cn_shape_get_type(const cn_world *world, cn_shape shape, int32_t *out_type);
/* Reads the body; 0 if unattached. */
CN_API cn_result cn_shape_get_body(const cn_world *world, cn_shape shape, cn_body *out_body);
/* Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the body). */
CN_API cn_result cn_shape_set_material(cn_world *world, cn_shape shape, const cn_material *material);
/* Reads the material. */
CN_API cn_result cn_shape_get_material(const cn_world *world, cn_shape shape, cn_material *out);
/* Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and wakes the body.
   O(shapes of the body). */
CN_API cn_result cn_shape_set_density(cn_world *world, cn_shape shape, float density_kgpm2);
/* Reads the density in kg/m^2. */
CN_API cn_result cn_shape_get_density(const cn_world *world, cn_shape shape, float *out_kgpm2);
/* Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits begin in the next
   step. Wakes the body, or the bodies near a static shape. O(contacts of the body). */
CN_API cn_result cn_shape_set_filter(cn_world *world, cn_shape shape, const cn_filter *filter);
/* Reads the filter. */
CN_API cn_result cn_shape_get_filter(const cn_world *world, cn_shape shape, cn_filter *out);
/* Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts of the body). */
CN_API cn_result cn_shape_set_event_mask(cn_world *world, cn_shape shape, uint32_t event_mask);
/* Reads the event mask. */
CN_API cn_result cn_shape_get_event_mask(const cn_world *world, cn_shape shape, uint32_t *out_event_mask);
/* Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next step. Wakes the
   body, or the bodies near a static shape. O(contacts of the body). */
CN_API cn_result cn_shape_set_flags(cn_world *world, cn_shape shape, uint32_t flags);
/* Reads the CN_SHAPE_ flags. */
CN_API cn_result cn_shape_get_flags(const cn_world *world, cn_shape shape, uint32_t *out_flags);
/* Stores a number for the user. */
CN_API cn_result cn_shape_set_user_data(cn_world *world, cn_shape shape, uint64_t user_data);
/* Reads the user's number. */
CN_API cn_result cn_shape_get_user_data(const cn_world *world, cn_shape shape, uint64_t *out_user_data);
/* AABB without margin, in the world (in the shape's own space when unattached). O(points). */
CN_API cn_result cn_shape_get_aabb(const cn_world *world, cn_shape shape, cn_aabb *out);
/* Mass at the present density, centre in the body's frame, inertia about the shape's own centre. O(points). */
CN_API cn_result cn_shape_get_mass_data(const cn_world *world, cn_shape shape, cn_mass_data *out);
/* Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type. */
CN_API cn_result cn_shape_get_circle(const cn_world *world, cn_shape shape, cn_circle *out);
/* Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type. */
CN_API cn_result cn_shape_get_capsule(const cn_world *world, cn_shape shape, cn_capsule *out);
/* Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type. */
CN_API cn_result cn_shape_get_edge(const cn_world *world, cn_shape shape, cn_edge *out);
/* Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type. */
CN_API cn_result cn_shape_get_polygon(const cn_world *world, cn_shape shape, cn_polygon *out);
/* Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be NULL when capacity
   is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points written). */
CN_API cn_result cn_shape_get_chain_points(const cn_world *world, cn_shape shape, cn_vec2 *out, int32_t capacity, int32_t *out_count);
/* Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks of creation: the
   handle and all other properties stay. Mass and box are those of the new geometry at once; contacts stay unless the boxes
   no longer overlap, and the next step computes them anew, without the impulses of features that are gone. Wakes the body,
   touching bodies and bodies that the new box meets. A shape that grows into others is pushed out of them at
   push_speed_max_mps at most. CN_ERROR_STATE for another type. O(contacts + shapes of the body). */
CN_API cn_result cn_shape_set_circle(cn_world *world, cn_shape shape, const cn_circle *circle);
/* Replaces a capsule in place; otherwise as cn_shape_set_circle. */
CN_API cn_result cn_shape_set_capsule(cn_world *world, cn_shape shape, const cn_capsule *capsule);
/* Replaces an edge in place; otherwise as cn_shape_set_circle. */
CN_API cn_result cn_shape_set_edge(cn_world *world, cn_shape shape, const cn_edge *edge);
/* Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle. */
CN_API cn_result cn_shape_set_polygon(cn_world *world, cn_shape shape, const cn_polygon *polygon);
/* Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap begin again in the
   next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body + count). */
CN_API cn_result cn_shape_set_chain(cn_world *world, cn_shape shape, const cn_chain *chain);
/* *out_inside is 1 if the shape contains a world point in metres (in the shape's own space when unattached), else 0. Edges
   and chains contain no point. O(points). */
CN_API cn_result cn_shape_test_point(const cn_world *world, cn_shape shape, float point_x_m, float point_y_m, int32_t *out_inside);

/* Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts farthest points, as
   Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most area. CN_ERROR_ARGUMENT for fewer than
   three distinct points or collinear ones. It drops details below 5 mm (below 5% of the half size for hulls under 0.1 m,
   below 0.5% for those over 1 m). radius_m >= 0. O(count^2) at worst. */
CN_API cn_result cn_polygon_make_hull(const cn_vec2 *points_m, int32_t count, float radius_m, cn_polygon *out);
/* A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad (|angle| <= 1e4);
   radius_m >= 0. */
CN_API cn_result cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon *out);

/* Outlines need not be convex. Pure geometry: no world, any thread, no memory but the stack. */

/* Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon in worlds of this length unit
   ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and without new points: ears are clipped (Meisters, 1975) and
   triangles merged (Hertel, Mehlhorn, 1983). Points nearer than 0.05% of the length unit to the one before and collinear points are
   dropped, and pieces thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no area.
   Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0. *out_count is the number of all.
   34 KB of stack. O(count^2). */
CN_API cn_result cn_outline_decompose(const cn_vec2 *points_m, int32_t count, float length_unit_m, cn_polygon *out, int32_t capacity, int32_t *out_count);
/* Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than tolerance_m (0 to 1e6),
   by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else 0. A closed outline within tolerance_m of a segment
   has 0 points left. A simple outline can cross itself afterwards if parts of it are nearer than tolerance_m. Writes at most capacity
   points (>= 0); out may be points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst. */
CN_API cn_result cn_outline_simplify(const cn_vec2 *points_m, int32_t count, int32_t closed, float tolerance_m, cn_vec2 *out, int32_t capacity, int32_t *out_count);
/* An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096), squares of side cell_m > 0
   with the lower left corner of the first at the origin. cells[row * columns + column] is not 0 where solid; row 0 is the lowest.
   outline is the outline's number, from 0; *out_count is 0 where there are not so many. The outline is a loop for
   cn_shape_create_chain, solid on its left: counter-clockwise around solids, clockwise around holes. Its points are corners of
   cells. Solid cells that touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
   (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a boundary of n edges. */
CN_API cn_result cn_outline_from_cells(const uint8_t *cells, int32_t count, int32_t columns, float origin_x_m, float origin_y_m, float cell_m, int32_t outline,
                                       cn_vec2 *out, int32_t capacity, int32_t *out_count);
/* The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all finite, is the value at the origin +
   spacing_m * (column, row), solid from threshold, with at least 2 columns and rows. A point of an outline lies between two
   neighbouring samples, by linear interpolation, at least spacing_m / 64 from both; the grid's border closes outlines. An outline
   never touches itself or another one. cn_outline_simplify removes its collinear points. O(values + n log n). */
CN_API cn_result cn_outline_from_field(const float *values, int32_t count, int32_t columns, float threshold, float origin_x_m, float origin_y_m, float spacing_m,
                                       int32_t outline, cn_vec2 *out, int32_t capacity, int32_t *out_count);

/* ------------------------------------------------------------------ contacts and their events */

/* One point of a contact. */
typedef struct cn_manifold_point {
	cn_vec2 point_m;          /* world, midway between the surfaces */
	float separation_m;       /* negative when overlapping */
	float normal_impulse_Ns;  /* of the last substep */
	uint32_t feature_id;      /* the same while the same features touch */
} cn_manifold_point;

/* How two shapes touch. */
typedef struct cn_manifold {
	cn_vec2 normal;             /* unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces'
	                               by up to 0.1 rad, so that piles stand */
	float friction_impulse_Ns;  /* of the last substep, on body b along (normal.y, -normal.x) */
	int32_t point_count;        /* 0, 1 or 2 */
	cn_manifold_point points[2]; /* the first point_count of them */
} cn_manifold;

/* A contact event, or the present state of a contact. */
typedef struct cn_contact_event {
	cn_shape shape_a;           /* one shape of the pair */
	cn_shape shape_b;           /* the other */
	cn_body body_a;             /* of shape_a */
	cn_body body_b;             /* of shape_b */
	int32_t child_a;            /* edge number within a chain, else 0 */
	int32_t child_b;            /* the same of shape b */
	uint32_t contact_id;        /* the same from CREATED to DESTROYED, then reused */
	int32_t kind;               /* CN_EVENT_* */
	float approach_speed_mps;   /* ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0 */
	cn_manifold manifold;       /* geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT */
	/* Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of cn_world_contact_events; else 0, as in
	   cn_body_get_contacts. In the substeps of a predicted contact that its shapes do not reach in this step, they are 0 too. */
	float normal_impulse_Ns;    /* along manifold.normal, on body b; its mean force is normal_impulse_Ns / dt_s */
	float friction_impulse_Ns;  /* along (normal.y, -normal.x), on body b */
	cn_vec2 hit_point_m;        /* HIT: where, in the world; else (0, 0) */
	uint32_t material_a;        /* cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED */
	uint32_t material_b;        /* the same of shape_b */
} cn_contact_event;

/* The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call for a kind after a
   step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED inside callbacks. Every CREATED gets a
   DESTROYED and every ENTER a LEAVE, however the pair ends (moved apart, body or shape destroyed, detached or disabled,
   filter or type changed). The next step reports pairs that end between two steps; their handles may be stale. A sleeping
   pair reports nothing, and continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest
   of the step, and got an impulse; bodies that pass a blow on to others that already touch them, without closing, have no
   HIT. Impulses are summed only for contacts that report ENTER (in the step in which they begin), STAY or HIT. */
CN_API cn_result cn_world_contact_events(cn_world *world, int32_t kind, const cn_contact_event **out_events, int32_t *out_count);

/* Called at the end of cn_world_step for each event of this kind, in the order of the array. */
typedef void cn_contact_event_fn(cn_world *world, const cn_contact_event *event, void *user);
/* Sets the callback for contact events of one kind (CN_EVENT_*); NULL removes it. */
CN_API cn_result cn_world_set_contact_callback(cn_world *world, int32_t kind, cn_contact_event_fn *function, void *user);

/* Returns 1 if two shapes that pass their filters may touch, else 0. Called when their boxes begin to overlap; the world is locked. */
typedef int32_t cn_filter_fn(cn_world *world, cn_shape shape_a, cn_shape shape_b, void *user);
/* Called in every step, before solving, for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE; the event's kind is STAY or
   ENTER. Returns 0 to let the pair pass through each other in this step, else 1. */
typedef int32_t cn_pre_solve_fn(cn_world *world, const cn_contact_event *contact, void *user);
/* Mixes two materials instead of the CN_MIX_ rules: *mixed holds the rules' result and takes the new one. Called when a pair begins to
   touch and when a material changes. */
typedef void cn_material_mix_fn(cn_world *world, cn_shape shape_a, cn_shape shape_b, cn_material *mixed, void *user);
/* Sets the callback that decides whether two shapes may touch; NULL removes it. */
CN_API cn_result cn_world_set_filter_callback(cn_world *world, cn_filter_fn *function, void *user);
/* Sets the pre-solve callback; NULL removes it. */
CN_API cn_result cn_world_set_pre_solve_callback(cn_world *world, cn_pre_solve_fn *function, void *user);
/* Sets the callback that mixes materials; NULL removes it. */
CN_API cn_result cn_world_set_material_mix_callback(cn_world *world, cn_material_mix_fn *function, void *user);

/* A shape entered or left a sensor. */
typedef struct cn_sensor_event {
	cn_shape sensor;      /* the sensor */
	cn_shape visitor;     /* the shape that it met */
	cn_body sensor_body;  /* the sensor's body */
	cn_body visitor_body; /* the visitor's body */
	int32_t kind;         /* CN_EVENT_ENTER or CN_EVENT_LEAVE */
	uint32_t reserved;    /* 0 */
} cn_sensor_event;
/* The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact events; a chain
   has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and kinematic bodies by exact overlap: a chain
   is a line with two sides here, which meets no edges or chains. A pair without an awake body reports nothing until one wakes. */
CN_API cn_result cn_world_sensor_events(const cn_world *world, const cn_sensor_event **out_events, int32_t *out_count);

/* The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of sensors: see
   cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the impulses of the last substep. At rest their
   force is that of the points times substep_count (with CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be
   NULL when capacity is 0. *out_count is their number. O(contacts). */
CN_API cn_result cn_body_get_contacts(const cn_world *world, cn_body body, cn_contact_event *out, int32_t capacity, int32_t *out_count);

/* The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in cn_body_get_contacts.
   O(contacts of its body). */
CN_API cn_result cn_shape_get_contacts(const cn_world *world, cn_shape shape, cn_contact_event *out, int32_t capacity, int32_t *out_count);
/* The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity and *out_count as in
   cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of its body), squared for chains. */
CN_API cn_result cn_shape_get_visitors(const cn_world *world, cn_shape sensor, cn_shape *out, int32_t capacity, int32_t *out_count);

/* Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies destroyed since are stale. */
CN_API cn_result cn_world_fell_asleep(const cn_world *world, const cn_body **out_bodies, int32_t *out_count);

/* ------------------------------------------------------------------ joints */

/* Types of joints: see their definitions. */
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

/* Flags of a joint. */
enum {
	CN_JOINT_COLLIDE = 1u << 0, /* the connected bodies' shapes collide with each other (default off) */
	CN_JOINT_LIMIT = 1u << 1,   /* the limits hold */
	CN_JOINT_MOTOR = 1u << 2,   /* the motor runs */
	CN_JOINT_SPRING = 1u << 3,  /* the spring pulls */
	CN_JOINT_BREAKS = 1u << 4   /* destroyed beyond its break force or torque, not only reported */
};

/* First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and limits in place; springs and
   motors are not rigid parts. */
typedef struct cn_joint_base {
	uint32_t struct_size;   /* of the whole definition */
	uint32_t flags;         /* CN_JOINT_*; default 0; a type ignores flags that it does not use */
	cn_body body_a;         /* 0: the world */
	cn_body body_b;         /* 0: the world; one of the two must be dynamic */
	cn_vec2 anchor_a_m;     /* in body a's local frame, or in world coordinates */
	cn_vec2 anchor_b_m;     /* the same for body b */
	float stiffness_hertz;  /* of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of
	                           all springs; CN_DEFAULT (default): as stiff as the substeps permit */
	float stiffness_damping_ratio; /* used with a stiffness_hertz; 0 to 1e6, default 0 */
	float force_max_N;      /* greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded */
	float torque_max_Nm;    /* greatest torque of angles, > 0; CN_DEFAULT (default): unbounded */
	float break_force_N;    /* a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never */
	float break_torque_Nm;  /* the same for the torque */
	uint64_t user_data;     /* a number for the user; default 0 */
} cn_joint_base;

/* Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi]. */
typedef struct cn_revolute_def {
	cn_joint_base base;           /* what every joint has */
	float reference_angle_rad;    /* angle b - angle a at joint angle 0 */
	float lower_angle_rad;        /* CN_JOINT_LIMIT: -pi <= lower <= upper <= pi */
	float upper_angle_rad;        /* the upper limit */
	float motor_speed_radps;      /* CN_JOINT_MOTOR */
	float motor_torque_max_Nm;    /* >= 0 */
	float spring_target_rad;      /* CN_JOINT_SPRING: pulls the joint angle to this */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
} cn_revolute_def;

/* Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of length_m. With a spring, length_m
   is its rest length, and limits keep the distance within [min, max]; limits alone make a rope (min 0). */
typedef struct cn_distance_def {
	cn_joint_base base;           /* what every joint has */
	float length_m;               /* > 0; default 1 */
	float length_min_m;           /* CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1 */
	float length_max_m;           /* the upper limit */
	float motor_speed_mps;        /* CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only */
	float motor_force_max_N;      /* >= 0 */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
	float reserved;               /* 0 */
} cn_distance_def;

/* Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy. */
typedef struct cn_fixed_def {
	cn_joint_base base;           /* what every joint has */
	float reference_angle_rad;    /* angle b - angle a */
	float angular_hertz;          /* stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's */
	float angular_damping_ratio;  /* 0 to 1e6 */
	float reserved;               /* 0 */
} cn_fixed_def;

/* b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a. */
typedef struct cn_prismatic_def {
	cn_joint_base base;           /* what every joint has */
	cn_vec2 axis;                 /* in body a's frame, any length > 0 (read back with length 1); default (1, 0) */
	float reference_angle_rad;    /* angle b - angle a */
	float lower_m;                /* CN_JOINT_LIMIT: lower <= upper */
	float upper_m;                /* the upper limit */
	float motor_speed_mps;        /* CN_JOINT_MOTOR */
	float motor_force_max_N;      /* >= 0 */
	float spring_target_m;        /* CN_JOINT_SPRING: pulls the translation to this */
	float spring_hertz;           /* 0 to 1e6 */
	float spring_damping_ratio;   /* 0 to 1e6 */
} cn_prismatic_def;

/* A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or by the motor. */
typedef struct cn_wheel_def {
	cn_joint_base base;           /* what every joint has */
	cn_vec2 axis;                 /* in body a's frame, any length > 0 (read back with length 1); default (0, 1) */
	float lower_m;                /* CN_JOINT_LIMIT: lower <= upper */
	float upper_m;                /* the upper limit */
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
	float hertz;                  /* frequency of the spring, > 0, to 1e6; default 5 */
	float damping_ratio;          /* 0 to 1e6, default 1 */
	float reserved;               /* 0 */
} cn_motor_def;

/* Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
   base.force_max_N must be > 0. */
typedef struct cn_mouse_def {
	cn_joint_base base;           /* what every joint has */
	cn_vec2 target_m;             /* world */
	float hertz;                  /* > 0, to 1e6; default 5 */
	float damping_ratio;          /* 0 to 1e6, default 0.7 */
} cn_mouse_def;

/* angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed) and
   count whole turns from there. */
typedef struct cn_gear_def {
	cn_joint_base base;           /* what every joint has */
	float ratio;                  /* size 1e-4 to 1e4, negative: they turn against each other; default 1 */
	float phase_rad;              /* default 0 */
} cn_gear_def;

/* A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never pushes. */
typedef struct cn_pulley_def {
	cn_joint_base base;           /* what every joint has */
	cn_vec2 ground_a_m;           /* world */
	cn_vec2 ground_b_m;           /* world */
	float ratio;                  /* 1e-4 to 1e4; default 1 */
	float length_m;               /* > 0: must be set */
} cn_pulley_def;

/* b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase + n * click_rad for every
   whole number n, over whole turns. */
typedef struct cn_ratchet_def {
	cn_joint_base base;           /* what every joint has */
	float phase_rad;              /* default 0 */
	float click_rad;              /* size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise */
} cn_ratchet_def;

/* A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of the two bodies. */
typedef struct cn_rotary_spring_def {
	cn_joint_base base;           /* what every joint has */
	float rest_angle_rad;         /* default 0 */
	float hertz;                  /* > 0, to 1e6; default 1 */
	float damping_ratio;          /* 0 to 1e6, default 0 */
	float reserved;               /* 0 */
} cn_rotary_spring_def;

/* Anchor b slides in a slot of body a from anchor a to end_m. */
typedef struct cn_groove_def {
	cn_joint_base base;           /* what every joint has */
	cn_vec2 end_m;                /* in body a's frame; not equal to anchor a; default (1, 0) */
} cn_groove_def;

/* The two bodies do not collide; no other effect. */
typedef struct cn_filter_joint_def {
	cn_joint_base base; /* what every joint has */
} cn_filter_joint_def;

/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_revolute_def_init(cn_revolute_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_distance_def_init(cn_distance_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_fixed_def_init(cn_fixed_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_prismatic_def_init(cn_prismatic_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_wheel_def_init(cn_wheel_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_motor_def_init(cn_motor_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_mouse_def_init(cn_mouse_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_gear_def_init(cn_gear_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_pulley_def_init(cn_pulley_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_ratchet_def_init(cn_ratchet_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_rotary_spring_def_init(cn_rotary_spring_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_groove_def_init(cn_groove_def *def);
/* Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_filter_joint_def_init(cn_filter_joint_def *def);
/* Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_revolute(cn_world *world, const cn_revolute_def *def, cn_joint *out_joint);
/* Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_distance(cn_world *world, const cn_distance_def *def, cn_joint *out_joint);
/* Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic. O(contacts
   of body_a). */
CN_API cn_result cn_joint_create_fixed(cn_world *world, const cn_fixed_def *def, cn_joint *out_joint);
/* Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_prismatic(cn_world *world, const cn_prismatic_def *def, cn_joint *out_joint);
/* Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic. O(contacts
   of body_a). */
CN_API cn_result cn_joint_create_wheel(cn_world *world, const cn_wheel_def *def, cn_joint *out_joint);
/* Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic. O(contacts
   of body_a). */
CN_API cn_result cn_joint_create_motor(cn_world *world, const cn_motor_def *def, cn_joint *out_joint);
/* Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic, or body_a
   is not 0. O(contacts of body_a). */
CN_API cn_result cn_joint_create_mouse(cn_world *world, const cn_mouse_def *def, cn_joint *out_joint);
/* Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic. O(contacts
   of body_a). */
CN_API cn_result cn_joint_create_gear(cn_world *world, const cn_gear_def *def, cn_joint *out_joint);
/* Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_pulley(cn_world *world, const cn_pulley_def *def, cn_joint *out_joint);
/* Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_ratchet(cn_world *world, const cn_ratchet_def *def, cn_joint *out_joint);
/* Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic.
   O(contacts of body_a). */
CN_API cn_result cn_joint_create_rotary_spring(cn_world *world, const cn_rotary_spring_def *def, cn_joint *out_joint);
/* Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic, or the
   slot has no length. O(contacts of body_a). */
CN_API cn_result cn_joint_create_groove(cn_world *world, const cn_groove_def *def, cn_joint *out_joint);
/* Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the bodies are the same
   or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of body_a). */
CN_API cn_result cn_joint_create_filter(cn_world *world, const cn_filter_joint_def *def, cn_joint *out_joint);
/* Destroys a joint and wakes its bodies. No event is reported. */
CN_API cn_result cn_joint_destroy(cn_world *world, cn_joint joint);
/* 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world). */
CN_API int32_t cn_joint_is_valid(const cn_world *world, cn_joint joint);
/* Reads the type (CN_JOINT_REVOLUTE to _FILTER). */
CN_API cn_result cn_joint_get_type(const cn_world *world, cn_joint joint, int32_t *out_type);
/* Reads both bodies; 0 stands for the world. */
CN_API cn_result cn_joint_get_bodies(const cn_world *world, cn_joint joint, cn_body *out_a, cn_body *out_b);
/* Reads the world positions of both anchors, in metres. */
CN_API cn_result cn_joint_get_anchors(const cn_world *world, cn_joint joint, cn_vec2 *out_world_a_m, cn_vec2 *out_world_b_m);
/* Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0 after a change of type or of
   CN_BODY_ENABLED of one of its bodies. */
CN_API cn_result cn_joint_get_reaction(const cn_world *world, cn_joint joint, cn_vec2 *out_force_N, float *out_torque_Nm);
/* Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians (angles beyond limits). */
CN_API cn_result cn_joint_get_error(const cn_world *world, cn_joint joint, float *out_m, float *out_rad);
/* Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): together with its
   neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all connected joints, up to the work limits of
   CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a world in a caller's block that was not created with
   CN_SOLVER_DIRECT. Takes effect with the next step; does not wake. */
CN_API cn_result cn_joint_set_solver(cn_world *world, cn_joint joint, int32_t solver);
/* Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT). */
CN_API cn_result cn_joint_get_solver(const cn_world *world, cn_joint joint, int32_t *out_solver);
/* Stores a number for the user. */
CN_API cn_result cn_joint_set_user_data(cn_world *world, cn_joint joint, uint64_t user_data);
/* Reads the user's number. */
CN_API cn_result cn_joint_get_user_data(const cn_world *world, cn_joint joint, uint64_t *out_user_data);
/* Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_flags(cn_world *world, cn_joint joint, uint32_t flags);
/* Reads the CN_JOINT_ flags. */
CN_API cn_result cn_joint_get_flags(const cn_world *world, cn_joint joint, uint32_t *out_flags);

/* Reads the definition of a revolute joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_revolute(const cn_world *world, cn_joint joint, cn_revolute_def *out);
/* Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_revolute(cn_world *world, cn_joint joint, const cn_revolute_def *def);
/* Reads the definition of a distance joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_distance(const cn_world *world, cn_joint joint, cn_distance_def *out);
/* Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_distance(cn_world *world, cn_joint joint, const cn_distance_def *def);
/* Reads the definition of a fixed joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_fixed(const cn_world *world, cn_joint joint, cn_fixed_def *out);
/* Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_fixed(cn_world *world, cn_joint joint, const cn_fixed_def *def);
/* Reads the definition of a prismatic joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_prismatic(const cn_world *world, cn_joint joint, cn_prismatic_def *out);
/* Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_prismatic(cn_world *world, cn_joint joint, const cn_prismatic_def *def);
/* Reads the definition of a wheel joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_wheel(const cn_world *world, cn_joint joint, cn_wheel_def *out);
/* Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_wheel(cn_world *world, cn_joint joint, const cn_wheel_def *def);
/* Reads the definition of a motor joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_motor_to(const cn_world *world, cn_joint joint, cn_motor_def *out);
/* Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_motor_to(cn_world *world, cn_joint joint, const cn_motor_def *def);
/* Reads the definition of a mouse joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_mouse(const cn_world *world, cn_joint joint, cn_mouse_def *out);
/* Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and struct_size. Sets the
   target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_mouse(cn_world *world, cn_joint joint, const cn_mouse_def *def);
/* Reads the definition of a gear joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_gear(const cn_world *world, cn_joint joint, cn_gear_def *out);
/* Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and struct_size. A new ratio
   starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
   CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_gear(cn_world *world, cn_joint joint, const cn_gear_def *def);
/* Reads the definition of a pulley joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_pulley(const cn_world *world, cn_joint joint, cn_pulley_def *out);
/* Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_pulley(cn_world *world, cn_joint joint, const cn_pulley_def *def);
/* Reads the definition of a ratchet joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_ratchet(const cn_world *world, cn_joint joint, cn_ratchet_def *out);
/* Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and struct_size. The
   ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
   CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_ratchet(cn_world *world, cn_joint joint, const cn_ratchet_def *def);
/* Reads the definition of a rotary spring. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_rotary_spring(const cn_world *world, cn_joint joint, cn_rotary_spring_def *out);
/* Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_rotary_spring(cn_world *world, cn_joint joint, const cn_rotary_spring_def *def);
/* Reads the definition of a groove joint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_joint_get_groove(const cn_world *world, cn_joint joint, cn_groove_def *out);
/* Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and struct_size.
   CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
CN_API cn_result cn_joint_set_groove(cn_world *world, cn_joint joint, const cn_groove_def *def);
/* Reads the base of a joint of any type. */
CN_API cn_result cn_joint_get_base(const cn_world *world, cn_joint joint, cn_joint_base *out);
/* Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as in cn_joint_base.
   Wakes both bodies. */
CN_API cn_result cn_joint_set_base(cn_world *world, cn_joint joint, const cn_joint_base *base);
/* Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE for another type.
   Wakes the body. */
CN_API cn_result cn_joint_set_target(cn_world *world, cn_joint joint, float target_x_m, float target_y_m);
/* Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without reference) in (-pi, pi].
   Distance, pulley: the present length. Prismatic, wheel, groove: the translation along the axis. Mouse: the distance to the
   target. Gear: angle b - ratio * angle a; ratchet, rotary spring: angle b - angle a; these three over whole turns. */
CN_API cn_result cn_joint_get_position(const cn_world *world, cn_joint joint, float *out_position);
/* Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A positive motor speed has
   the same sign. */
CN_API cn_result cn_joint_get_speed(const cn_world *world, cn_joint joint, float *out_speed);
/* Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance, prismatic or wheel
   joint (others: CN_ERROR_STATE). Wakes both bodies. */
CN_API cn_result cn_joint_set_motor(cn_world *world, cn_joint joint, float speed, float force_or_torque_max);
/* Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0), prismatic or wheel joint
   (metres); others: CN_ERROR_STATE. Wakes both bodies. */
CN_API cn_result cn_joint_set_limits(cn_world *world, cn_joint joint, float lower, float upper);

/* A joint or constraint exceeded a break threshold or was destroyed with a body. */
typedef struct cn_joint_event {
	cn_joint joint;            /* 0: it was a constraint; stale when destroyed is 1 */
	cn_constraint constraint;  /* 0: it was a joint; stale when destroyed is 1 */
	cn_body body_a;            /* 0: the world */
	cn_body body_b;            /* 0: the world */
	float force_N;             /* largest reaction of the step; 0 when a body was destroyed */
	float torque_Nm;           /* the same for the torque */
	uint32_t destroyed;        /* 1: it broke, or one of its bodies was destroyed */
	uint32_t reserved;         /* 0 */
	uint64_t user_data;        /* the joint's or constraint's */
} cn_joint_event;
/* Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body in that step or
   between it and the step before. */
CN_API cn_result cn_world_joint_events(const cn_world *world, const cn_joint_event **out_events, int32_t *out_count);

/* ------------------------------------------------------------------ constraints on one body */

/* Types of constraints. */
enum {
	CN_CONSTRAINT_ANGLE = 0, /* cn_angle_constraint_def */
	CN_CONSTRAINT_LINE = 1   /* cn_line_constraint_def */
};
/* Flags of a constraint. */
enum {
	CN_CONSTRAINT_LIMIT = 1u << 0, /* line: the limits along the axis hold */
	CN_CONSTRAINT_BREAKS = 1u << 1 /* destroyed beyond its break force or torque, not only reported */
};

/* Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from there. */
typedef struct cn_angle_constraint_def {
	uint32_t struct_size;     /* set by the init function */
	uint32_t flags;           /* CN_CONSTRAINT_*; default 0 */
	cn_body body;             /* must be dynamic */
	float lower_rad;          /* lower <= upper; equal: locked */
	float upper_rad;          /* the upper limit */
	float hertz;              /* > 0, to 1e6; CN_DEFAULT (default): rigid */
	float damping_ratio;      /* used with a hertz; 0 to 1e6 */
	float break_torque_Nm;    /* a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never */
	uint64_t user_data;       /* a number for the user; default 0 */
} cn_angle_constraint_def;

/* Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along the line. */
typedef struct cn_line_constraint_def {
	uint32_t struct_size;     /* set by the init function */
	uint32_t flags;           /* CN_CONSTRAINT_*; default 0 */
	cn_body body;             /* must be dynamic */
	cn_vec2 anchor_m;         /* in the body's frame */
	cn_vec2 origin_m;         /* of the line, world */
	cn_vec2 axis;             /* world, any length > 0 (read back with length 1); default (1, 0) */
	float tolerance_m;        /* >= 0: free play across the axis */
	float lower_m;            /* CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper */
	float upper_m;            /* the upper limit */
	float hertz;              /* > 0, to 1e6; CN_DEFAULT (default): rigid */
	float damping_ratio;      /* used with a hertz; 0 to 1e6 */
	float break_force_N;      /* a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never */
	uint32_t reserved;        /* 0 */
	uint64_t user_data;       /* a number for the user; default 0 */
} cn_line_constraint_def;

/* Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_angle_constraint_def_init(cn_angle_constraint_def *def);
/* Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing. */
CN_API void cn_line_constraint_def_init(cn_line_constraint_def *def);
/* Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not dynamic. Wakes the body. */
CN_API cn_result cn_constraint_create_angle(cn_world *world, const cn_angle_constraint_def *def, cn_constraint *out_constraint);
/* Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not dynamic. Wakes the body. */
CN_API cn_result cn_constraint_create_line(cn_world *world, const cn_line_constraint_def *def, cn_constraint *out_constraint);
/* Destroys a constraint and wakes its body. No event is reported. */
CN_API cn_result cn_constraint_destroy(cn_world *world, cn_constraint constraint);
/* 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world). */
CN_API int32_t cn_constraint_is_valid(const cn_world *world, cn_constraint constraint);
/* Reads the type (CN_CONSTRAINT_ANGLE or _LINE). */
CN_API cn_result cn_constraint_get_type(const cn_world *world, cn_constraint constraint, int32_t *out_type);
/* Reads the body. */
CN_API cn_result cn_constraint_get_body(const cn_world *world, cn_constraint constraint, cn_body *out_body);
/* Reads the definition of an angle constraint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_constraint_get_angle(const cn_world *world, cn_constraint constraint, cn_angle_constraint_def *out);
/* Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the body. */
CN_API cn_result cn_constraint_set_angle(cn_world *world, cn_constraint constraint, const cn_angle_constraint_def *def);
/* Reads the definition of a line constraint. CN_ERROR_STATE for another type. */
CN_API cn_result cn_constraint_get_line(const cn_world *world, cn_constraint constraint, cn_line_constraint_def *out);
/* Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the body. */
CN_API cn_result cn_constraint_set_line(cn_world *world, cn_constraint constraint, const cn_line_constraint_def *def);
/* Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point along the axis, in
   metres from origin. */
CN_API cn_result cn_constraint_get_position(const cn_world *world, cn_constraint constraint, float *out_position);
/* Force in newtons and torque in newton metres that the constraint applied to the body in the last substep. */
CN_API cn_result cn_constraint_get_reaction(const cn_world *world, cn_constraint constraint, cn_vec2 *out_force_N, float *out_torque_Nm);
/* Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle constraint. */
CN_API cn_result cn_constraint_get_error(const cn_world *world, cn_constraint constraint, float *out_m, float *out_rad);
/* Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots). */
CN_API cn_result cn_world_get_constraints(const cn_world *world, cn_constraint *out, int32_t capacity, int32_t *out_count);
/* Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints + constraints of the body). */
CN_API cn_result cn_body_get_constraints(const cn_world *world, cn_body body, cn_constraint *out, int32_t capacity, int32_t *out_count);

/* ------------------------------------------------------------------ variable time */

/* Result of cn_world_update. */
typedef struct cn_update_report {
	int32_t steps;        /* fixed steps taken */
	float leftover_s;     /* time kept for the next update */
	float dropped_s;      /* time discarded because of steps_max */
	float interpolation;  /* leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated */
} cn_update_report;

/* Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an update, 1 to 1000, default 8. */
CN_API cn_result cn_world_set_fixed_step(cn_world *world, float step_s, int32_t steps_max);
/* Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The event arrays hold
   the last step; callbacks see every step. out may be NULL. Costs as the steps. */
CN_API cn_result cn_world_update(cn_world *world, float elapsed_s, cn_update_report *out);
/* Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step, 1 after it. Bodies
   that did not take part in the last step have their present pose. bodies and count as in cn_world_read_poses. O(count). */
CN_API cn_result cn_world_read_poses_interpolated(const cn_world *world, const cn_body *bodies, int32_t count, float factor, cn_pose *out);

/* ------------------------------------------------------------------ queries */

/* A ray with an end. */
typedef struct cn_ray {
	cn_vec2 origin_m;      /* world */
	cn_vec2 translation_m; /* at most 2e6 length units each way; 0 hits only shapes around the origin */
} cn_ray;

/* What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that shape at fraction 0, with the
   shortest way out: depth_m along the normal. A shape that it touches up to a depth of 0.5% of the length unit is no hit if the translation
   leads along the surface or away from it. */
typedef struct cn_ray_hit {
	cn_shape shape;       /* 0: nothing was hit */
	cn_body body;         /* the shape's */
	int32_t child;        /* edge of a chain */
	float fraction;       /* of the translation, [0, 1]; 1 when nothing was hit */
	cn_vec2 point_m;      /* on the surface of the shape that was hit */
	cn_vec2 normal;       /* unit, out of the shape that was hit */
	float depth_m;        /* depth of the start inside it, 0 outside */
	uint32_t reserved;    /* 0 */
} cn_ray_hit;

/* Results of a cn_query_fn. */
enum {
	CN_QUERY_SKIP = 0, /* ignore the shape */
	CN_QUERY_TAKE = 1, /* take it */
	CN_QUERY_STOP = 2  /* take it, and nothing after it in the order of results */
};
/* Called by a query for each shape (edge of a chain) found, in no particular order and perhaps more than once: the result, CN_QUERY_*,
   must depend on the shape alone. hit is complete in casts; other queries set shape, body and child. May call only functions that take a
   const world, also of the same world. */
typedef int32_t cn_query_fn(const cn_world *world, const cn_ray_hit *hit, void *user);

/* Flags of a query. */
enum {
	CN_QUERY_IGNORE_JOINED = 1u << 0, /* also ignore bodies that a joint connects to ignored_body */
	CN_QUERY_ONE_WAY = 1u << 1,       /* casts meet one-way shapes from their upper side (45 degrees) only, and not those that they
	                                     start in by more than 0.5% of the length unit; all other queries do not see one-way shapes.
	                                     Default: they are like others */
	CN_QUERY_LEAVING = 1u << 2        /* casts do not hit shapes that they start in, at any depth, unless they lead farther in */
};

/* Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a bit in category; sensors
   only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between steps. */
typedef struct cn_query_filter {
	uint64_t category;    /* default 1 */
	uint64_t mask;        /* default all ones */
	cn_body ignored_body; /* its shapes are ignored; 0 (default): none. A stale handle is an error */
	uint32_t flags;       /* CN_QUERY_IGNORE_JOINED ...; default 0 */
	cn_query_fn *visit;   /* NULL (default): take all shapes */
	void *user;           /* last argument of visit */
} cn_query_filter;
/* Sets the defaults given beside the fields. NULL does nothing. */
CN_API void cn_query_filter_init(cn_query_filter *filter);

/* Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from their front. Of equal
   hits the first by shape (in the order of cn_world_get_shapes), then child. filter may be NULL: the defaults. O(log shapes)
   to O(shapes along the ray). */
CN_API cn_result cn_world_cast_ray(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out);
/* *out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log shapes) to
   O(shapes along the ray). */
CN_API cn_result cn_world_cast_ray_any(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, int32_t *out_hit);
/* Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found. A chain counts once
   for each edge hit. filter may be NULL. O(shapes along the ray * log capacity). */
CN_API cn_result cn_world_cast_ray_all(const cn_world *world, const cn_ray *ray, const cn_query_filter *filter, cn_ray_hit *out, int32_t capacity, int32_t *out_count);
/* Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call. filter may be NULL. O(sum
   of the rays). */
CN_API cn_result cn_world_cast_rays(const cn_world *world, const cn_ray *rays, int32_t count, const cn_query_filter *filter, cn_ray_hit *out);
/* Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached. O(points of the shape). */
CN_API cn_result cn_shape_cast_ray(const cn_world *world, cn_shape shape, const cn_ray *ray, cn_ray_hit *out);
/* First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each way) without
   turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or 2: circle, capsule. A shape in
   contact at the start: see cn_ray_hit. A chain is met if the mean of the moving points is in front of it. filter may be
   NULL. O(shapes along the way). */
CN_API cn_result cn_world_cast_shape(const cn_world *world, const cn_polygon *shape, float translation_x_m, float translation_y_m, const cn_query_filter *filter, cn_ray_hit *out);

/* Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of cn_world_get_shapes, each
   once. The first capacity (>= 0) are written; *out_count is the number found. filter may be NULL. O(log shapes) to O(boxes in
   the region). */
CN_API cn_result cn_world_overlap_aabb(const cn_world *world, const cn_aabb *box, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
/* Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges and chains are
   lines here, seen from both sides. */
CN_API cn_result cn_world_overlap_circle(const cn_world *world, const cn_circle *circle, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
/* Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as in
   cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides. */
CN_API cn_result cn_world_overlap_polygon(const cn_world *world, const cn_polygon *polygon, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);
/* Shapes that contain a world point in metres; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges and chains
   contain no point. */
CN_API cn_result cn_world_overlap_point(const cn_world *world, float x_m, float y_m, const cn_query_filter *filter, cn_shape *out, int32_t capacity, int32_t *out_count);

/* The shape nearest to a point. */
typedef struct cn_closest {
	cn_shape shape;       /* 0: nothing within the distance */
	cn_body body;         /* the shape's */
	int32_t child;        /* edge of a chain */
	float distance_m;     /* negative: depth inside a shape with area */
	cn_vec2 point_m;      /* on the surface */
	cn_vec2 normal;       /* outward there; of edges and chains towards the point */
} cn_closest;
/* Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several contain the point.
   filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m. */
CN_API cn_result cn_world_closest_point(const cn_world *world, float x_m, float y_m, float distance_max_m, const cn_query_filter *filter, cn_closest *out);

/* ------------------------------------------------------------------ two shapes without a world */

/* Functions of two convex shapes: polygons as in cn_world_cast_shape; 1 or 2 points may also have radius 0: a point, a segment. Each shape
   is in its own frame, with a pose in the world (rotation of unit length within 1%). The functions are pure: any thread, no memory,
   O(points). Points closer than 5e-4 m are degenerate, as in a world of length unit 1. */

/* Distance of two shapes. */
typedef struct cn_distance {
	cn_vec2 point_a_m;    /* on the surface of a, in the world */
	cn_vec2 point_b_m;    /* on the surface of b */
	cn_vec2 normal;       /* unit, from a to b */
	float distance_m;     /* of the surfaces; negative: the depth, the shortest translation of b out of a */
	uint32_t reserved;    /* 0 */
} cn_distance;
/* Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their radii are apart,
   else by their Minkowski difference. Needs no world; runs in any thread. O(points). */
CN_API cn_result cn_polygon_distance(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b,
	cn_distance *out);
/* Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out as cn_ray_hit,
   without shape, body and child. Needs no world; runs in any thread. O(points). */
CN_API cn_result cn_polygon_cast(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b,
	float translation_x_m, float translation_y_m, cn_ray_hit *out, int32_t *out_hit);
/* Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0 to 1e6). A single
   point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread. O(points). */
CN_API cn_result cn_polygon_collide(const cn_polygon *a, const cn_pose *pose_a, const cn_polygon *b, const cn_pose *pose_b,
	float margin_m, cn_manifold *out);

/* A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about it at a constant rate. */
typedef struct cn_sweep {
	cn_pose start;         /* of the shape, before the motion */
	cn_vec2 center_m;      /* that point, in the shape's frame: the centre of mass of a body */
	cn_vec2 translation_m; /* of it; at most 2e6 m each way */
	float turn_rad;        /* counter-clockwise, |turn| <= 1e4 */
	uint32_t reserved;     /* 0 */
} cn_sweep;
/* States of a time of impact. */
enum {
	CN_IMPACT_NONE = 0,    /* the shapes never come that close; fraction is 1 */
	CN_IMPACT_HIT = 1,     /* they do, at fraction */
	CN_IMPACT_OVERLAP = 2, /* the shapes without their radii overlap at the start: fraction 0, no normal */
	CN_IMPACT_FAILED = 3   /* no hit before fraction, perhaps one after it: the search ended early */
};
/* Result of cn_polygon_time_of_impact. */
typedef struct cn_impact {
	int32_t state;         /* CN_IMPACT_* */
	float fraction;        /* of both motions, [0, 1] */
	cn_vec2 point_m;       /* HIT only, as are the next two: between the surfaces */
	cn_vec2 normal;        /* unit, from a to b */
	float distance_m;      /* of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it */
	uint32_t reserved;     /* 0 */
} cn_impact;
/* First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they start closer.
   Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a hit. Needs no world; runs in any
   thread. */
CN_API cn_result cn_polygon_time_of_impact(const cn_polygon *a, const cn_sweep *sweep_a, const cn_polygon *b, const cn_sweep *sweep_b,
	float distance_m, cn_impact *out);

/* ------------------------------------------------------------------ character mover */

/* A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0, unless that needs a push of more than
   push_max_m. */
typedef struct cn_plane {
	cn_vec2 normal;        /* unit, from the surface to the shape */
	cn_vec2 point_m;       /* world point of least distance */
	float separation_m;    /* of the surfaces along the normal; negative: they overlap */
	float push_max_m;      /* greatest push of this plane, >= 0; FLT_MAX: rigid */
	float push_m;          /* its push in the last cn_mover_solve */
	cn_shape shape;        /* whose surface it is */
	cn_body body;          /* the shape's */
	int32_t child;         /* edge of a chain */
} cn_plane;
/* Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved by position, from
   the same manifolds as in a step, rigid. Writes at most capacity, those of least separation first; *out_count is their
   number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way shape has a plane only on its upper side, and only for an
   overlap of at most 0.5% of the length unit plus its rise in the last step. Shapes wholly behind the plane of another shape
   are left out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared). */
CN_API cn_result cn_mover_collide(const cn_world *world, const cn_polygon *shape, float position_x_m, float position_y_m, float margin_m,
	const cn_query_filter *filter, cn_plane *out, int32_t capacity, int32_t *out_count);
/* The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two dimensions at most
   two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957) finds the planes at their limit. Sets
   push_m. If the surfaces leave no room, the result has the least sum of squared overlaps (Cimmino, 1938); *out_overlap_m is
   the deepest remaining overlap of planes below their limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3)
   where two planes hold it. */
CN_API cn_result cn_mover_solve(cn_plane *planes, int32_t count, float translation_x_m, float translation_y_m, cn_vec2 *out_translation_m,
	float *out_overlap_m);
/* The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last cn_mover_solve. Needs
   no world. O(count^2). */
CN_API cn_result cn_mover_clip(const cn_plane *planes, int32_t count, float velocity_x_mps, float velocity_y_mps, cn_vec2 *out_mps);

/* Flags of a mover's definition. */
enum {
	CN_MOVER_DROP = 1u << 0        /* ignore one-way shapes: set it while the character drops through one */
};
/* How a character moves. It may change between moves: crouching is another shape. */
typedef struct cn_mover_def {
	uint32_t struct_size;          /* set by the init function */
	uint32_t flags;                /* CN_MOVER_DROP; default 0 */
	cn_polygon shape;              /* around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule
	                                  of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly */
	cn_query_filter filter;        /* shapes that it collides with; sensors never, one-way shapes from above */
	cn_vec2 up;                    /* any length > 0; default (0, 1) */
	float slope_limit_rad;         /* greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees) */
	float step_height_m;           /* greatest height of steps that it climbs, >= 0; default 0.3 */
	float snap_m;                  /* a walking character follows ground that falls by up to this in a move, >= 0; default 0.3 */
	float gravity_scale;           /* of the world's gravity in the air; default 1 */
	float push_force_N;            /* greatest push on a dynamic body, >= 0; default 200 */
	int32_t iterations_max;        /* of sliding, 1 to 64; default 8 */
} cn_mover_def;
/* Sets struct_size and the defaults given beside the fields. NULL does nothing. */
CN_API void cn_mover_def_init(cn_mover_def *def);

/* State flags of a mover. */
enum {
	CN_MOVER_ON_GROUND = 1u << 0,  /* stands on walkable ground */
	CN_MOVER_ON_WALL = 1u << 1,    /* touches a surface too steep to walk on */
	CN_MOVER_ON_CEILING = 1u << 2  /* touches a surface above it */
};
/* State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The world does not know it, and
   bodies do not collide with it: for that give it a kinematic body that is filter.ignored_body and follows by cn_body_set_target_pose.
   Initially all fields are 0 except the position. */
typedef struct cn_mover {
	cn_vec2 position_m;            /* of the shape's origin, world */
	cn_vec2 velocity_mps;          /* in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as
	                                  its component across up; the one along up is 0, and a jump when the caller makes it > 0 */
	cn_vec2 ground_normal;         /* of the ground with CN_MOVER_ON_GROUND, else (0, 0) */
	cn_vec2 ground_point_m;        /* in the world, after the move */
	cn_vec2 ground_local_m;        /* ... in the frame of ground_body */
	cn_vec2 ground_velocity_mps;   /* of the ground there */
	cn_body ground_body;           /* 0: none; a stale handle counts as none */
	cn_shape ground_shape;         /* the same for its shape */
	uint32_t flags;                /* CN_MOVER_ON_*, after the last move */
	float squeezed_m;              /* overlap with surfaces that leave it no room; else 0 up to rounding */
} cn_mover;
/*
 * Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step behind the ground that carries it.
 *
 *  1. carried   by the motion of its ground since the last move: of the point of ground_body under it, and of conveyors
 *  2. walking   on the ground: velocity_mps across up, along the ground, at the same speed uphill and downhill; no gravity, so that
 *               it does not creep. A step up where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground
 *     flying    in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep ground_velocity_mps
 *  3. sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes through a wall
 *  4. pushing   dynamic bodies in the way get a force for the next step that brings them to the character's velocity, of at most
 *               push_force_N each
 *  5. ground    ground that it touches, or that lies within snap_m below a walking character; velocity_mps loses blocked components
 *
 * The result depends on the world, def and mover alone: equal calls give equal bits. The loop of planes, solver and cast is that of
 * Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies wake; nothing else in the world changes. O(shapes nearby
 * x iterations_max): about 1 us standing, 3 us walking, 10 us against a wall.
 */
CN_API cn_result cn_mover_move(cn_world *world, const cn_mover_def *def, float dt_s, cn_mover *mover);

/* ------------------------------------------------------------------ areas and wind */

/* Flags of an area. */
enum {
	CN_AREA_REPLACE = 1u << 0 /* bodies whose centre of mass is in it: the world's gravity and areas of lower order do not act on them */
};
/* What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity. Several areas act in the order
   of their priority, equal ones in that of cn_world_get_shapes; their accelerations, damping and forces add up. */
typedef struct cn_area_def {
	uint32_t struct_size;         /* set by the init function */
	uint32_t flags;               /* CN_AREA_REPLACE; default 0 */
	int32_t priority;             /* default 0 */
	cn_vec2 gravity_mps2;         /* acceleration in the axes of the world, times the body's gravity_scale; default (0, 0) */
	cn_vec2 center_m;             /* of pull_mps2, in the frame of the sensor's body; default (0, 0) */
	float pull_mps2;              /* acceleration towards center_m; negative pushes; default 0 */
	float pull_distance_m;        /* CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with its inverse square
	                                 outside, and falling to 0 at the centre: a homogeneous planet */
	float linear_damping_per_s;   /* of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium
	                                 with density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0 */
	float angular_damping_per_s;  /* ... of the rotation; 0 to 1e9, default 0 */
	float density_kgpm2;          /* of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0 */
	float drag_kgpm2;             /* density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0 */
	float lift_kgpm2;             /* density times lift coefficient; 0 to 1e9, default 0 */
	cn_vec2 flow_mps;             /* velocity of the medium relative to the sensor, in the axes of the world; default (0, 0) */
} cn_area_def;
/* Sets struct_size and the defaults given beside the fields. NULL does nothing. */
CN_API void cn_area_def_init(cn_area_def *def);
/* Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says which shapes it has.
   CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area that loses the flag later does nothing while it is
   without.

   Gravity, and damping without density, act on bodies whose centre of mass is in the area (on its border too) while one of their shapes
   touches it: on a body half in it in full or not at all. The medium acts on the part of each shape that is in the area, exactly for
   polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The surface of a circle or capsule is flat across
   a body, as of a planet. Shapes of a body do not shade each other. The area's body feels no reaction.

   Between steps nothing happens: the acceleration is that in the middle of the next step (leapfrog), so bodies on orbits and floating
   bodies keep their energy. Damping and drag are implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies
   that enter or leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may sleep. Areas are in saves and
   files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a second) are damped, and carry less under a load. An area takes
   64 bytes of the world's memory; a step takes about 0.15 us for each shape in an area, 0.35 us in a medium. Best on a body of its own:
   O(contacts of the body). */
CN_API cn_result cn_shape_set_area(cn_world *world, cn_shape shape, const cn_area_def *def);
/* Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas). */
CN_API cn_result cn_shape_get_area(const cn_world *world, cn_shape shape, cn_area_def *out);
/* The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step. flow: velocity of the air in
   m/s. On each part of the outline that faces the flow, of width w across it, with u the velocity relative to that point: drag drag_kgpm2
   / 2 w |u| u, the law of Newton (1687), and across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between
   surface and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline, round parts included, and
   drag along straight edges also for turning bodies; edges and chains are plates with two sides. Solved implicitly, so that wind never
   reverses the motion relative to it, at any speed, mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping
   bodies stay asleep and unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a shape
   without a body. O(points). */
CN_API cn_result cn_shape_apply_wind(cn_world *world, cn_shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2,
	float dt_s, int32_t wake);

/* ------------------------------------------------------------------ explosions */

/* Definition of an explosion. */
typedef struct cn_explosion_def {
	uint32_t struct_size;     /* set by the init function */
	float radius_m;           /* full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1 */
	float falloff_m;          /* then linearly to 0 over this distance, 0 to 1e6 length units; default 0 */
	float impulse_Nspm;       /* per metre of the shape's width seen from the centre; negative pulls; default 0 */
	cn_vec2 center_m;         /* world */
	cn_query_filter filter;   /* which shapes; defaults: see cn_query_filter */
} cn_explosion_def;
/* Sets struct_size and the defaults given beside the fields. NULL does nothing. */
CN_API void cn_explosion_def_init(cn_explosion_def *def);
/* Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes them.
   CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that). */
CN_API cn_result cn_world_explode(cn_world *world, const cn_explosion_def *def);

/* ------------------------------------------------------------------ debug draw */

/* What cn_world_draw draws. */
enum {
	CN_DRAW_SHAPES = 1u << 0,      /* coloured by type and sleep */
	CN_DRAW_JOINTS = 1u << 1,      /* and constraints: anchors, axes, limits */
	CN_DRAW_CONTACTS = 1u << 2,    /* points and normals */
	CN_DRAW_AABBS = 1u << 3,       /* without margin */
	CN_DRAW_CENTERS = 1u << 4,     /* of mass, with the bodies' names */
	CN_DRAW_ISLANDS = 1u << 5      /* colours by island */
};

/* The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world coordinates. */
typedef struct cn_debug_draw {
	uint32_t struct_size;       /* set by the init function */
	uint32_t flags;             /* CN_DRAW_*; default SHAPES | JOINTS | CONTACTS */
	cn_aabb view;               /* things outside are not drawn; default everything */
	void (*polygon)(const cn_vec2 *points_m, int32_t count, float radius_m, uint32_t color, void *user); /* count points, counter-clockwise */
	/* rim_m: a point on the rim that turns with the body */
	void (*circle)(const cn_vec2 *center_m, float radius_m, const cn_vec2 *rim_m, uint32_t color, void *user);
	void (*capsule)(const cn_vec2 *a_m, const cn_vec2 *b_m, float radius_m, uint32_t color, void *user); /* a disc swept from a to b */
	void (*segment)(const cn_vec2 *a_m, const cn_vec2 *b_m, uint32_t color, void *user); /* a line from a to b */
	void (*point)(const cn_vec2 *point_m, float size_px, uint32_t color, void *user); /* size in pixels */
	void (*text)(const cn_vec2 *point_m, const char *text, uint32_t color, void *user); /* zero-terminated, valid during the call */
	void *user;                 /* last argument of the functions */
	void *reserved;             /* 0 */
} cn_debug_draw;
/* Sets struct_size and the defaults given beside the fields, every function to NULL. NULL does nothing. */
CN_API void cn_debug_draw_init(cn_debug_draw *draw);
/* Draws the world through the given functions, in the calling thread. Reads only. O(bodies + shapes + contacts + joints). */
CN_API cn_result cn_world_draw(const cn_world *world, const cn_debug_draw *draw);

/* ------------------------------------------------------------------ a tree of boxes for the game's own use */

/* A dynamic AABB tree apart from any world. One thread at a time may change it; several may search it while nothing changes it. */
typedef struct cn_tree cn_tree;
/* Returns 0 to stop the search, any other value to continue. */
typedef int32_t cn_tree_query_fn(uint32_t item, uint64_t user_data, void *user);
/* Returns the fraction at which the ray now ends: the given one to ignore the item, 0 to stop. */
typedef float cn_tree_ray_fn(uint32_t item, uint64_t user_data, float fraction, void *user);

/* Creates a dynamic AABB tree; margin_m >= 0 is added around every box. alloc and free: both NULL for malloc, or both set. */
CN_API cn_result cn_tree_create(float margin_m, cn_alloc_fn *alloc, cn_free_fn *free, void *allocator_user, cn_tree **out_tree);
/* Destroys a tree. NULL does nothing. */
CN_API void cn_tree_destroy(cn_tree *tree);
/* Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n). */
CN_API cn_result cn_tree_insert(cn_tree *tree, const cn_aabb *box, uint64_t user_data, uint32_t *out_item);
/* Removes an item. CN_ERROR_HANDLE for a stale one. O(log n). */
CN_API cn_result cn_tree_remove(cn_tree *tree, uint32_t item);
/* Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n). CN_ERROR_HANDLE
   for a stale item. */
CN_API cn_result cn_tree_move(cn_tree *tree, uint32_t item, const cn_aabb *box);
/* Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item. */
CN_API cn_result cn_tree_get_box(const cn_tree *tree, uint32_t item, cn_aabb *out);
/* Calls visit for every item whose box with margin overlaps box, until visit returns 0. visit must not change the tree. O(log
   n + items visited). */
CN_API cn_result cn_tree_query(const cn_tree *tree, const cn_aabb *box, cn_tree_query_fn *visit, void *user);
/* Calls visit for items whose box with margin a ray crosses; visit shortens or stops the ray by its result and must not
   change the tree. O(log n + items visited). */
CN_API cn_result cn_tree_cast_ray(const cn_tree *tree, const cn_ray *ray, cn_tree_ray_fn *visit, void *user);
/* Reads the number of items and the height of the tree. */
CN_API cn_result cn_tree_get_stats(const cn_tree *tree, int32_t *out_count, int32_t *out_height);

#ifdef __cplusplus
}
#endif

#endif
