//! Cairn for Zig, one to one with cairn.h.
//! Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//!
//!     const cn = @import("cairn");
//!     var def: cn.cn_world_def = undefined;
//!     cn.cn_world_def_init(&def);
//!     var world: ?*cn.cn_world = null;
//!     if (cn.cn_world_create(&def, &world) != cn.CN_OK) return error.Cairn;

/// Incompatible changes of the API.
pub const CN_VERSION_MAJOR = 0;
/// Compatible additions.
pub const CN_VERSION_MINOR = 1;
/// Corrections.
pub const CN_VERSION_PATCH = 0;
/// Raised whenever a struct layout or a function signature changes.
pub const CN_ABI_VERSION = 3;
/// Most vertices a convex polygon may have.
pub const CN_POLYGON_MAX_VERTICES = 16;
/// Longest body name in bytes, without the terminating zero.
pub const CN_NAME_MAX_BYTES = 63;
/// Most planes of cn_mover_solve and cn_mover_clip.
pub const CN_PLANES_MAX = 64;
/// Most workers of a world.
pub const CN_WORKERS_MAX = 64;
/// Most bodies, shapes or joints alive at once in one world (20 bits of index).
pub const CN_MAX_HANDLES = 1048575;

// In a definition: the default of a field whose comment names CN_DEFAULT; other fields refuse it where it is
// out of their range.
/// In a definition: the default of a field whose comment names CN_DEFAULT; other fields refuse it where it is
/// out of their range.
pub const CN_DEFAULT = -1;

// Result codes.
/// success
pub const CN_OK = 0;
/// a value is NaN, infinite, out of range, NULL or degenerate
pub const CN_ERROR_ARGUMENT = -1;
/// a handle is stale, of the wrong kind or 0
pub const CN_ERROR_HANDLE = -2;
/// the allocator or the fixed block has no room
pub const CN_ERROR_MEMORY = -3;
/// called from inside a callback
pub const CN_ERROR_LOCKED = -4;
/// more than CN_MAX_HANDLES things, or an output array too small
pub const CN_ERROR_CAPACITY = -5;
/// the object is in a state that does not permit the call
pub const CN_ERROR_STATE = -6;
/// cn_world_validate found a broken invariant: a bug in Cairn
pub const CN_ERROR_INTERNAL = -7;
/// the bytes are no saved world, or are damaged
pub const CN_ERROR_FORMAT = -8;

// Structs, for cn_sizeof.
pub const CN_TYPE_VEC2 = 0;
pub const CN_TYPE_POSE = 1;
pub const CN_TYPE_VELOCITY = 2;
pub const CN_TYPE_AABB = 3;
pub const CN_TYPE_MASS_DATA = 4;
pub const CN_TYPE_WORLD_DEF = 5;
pub const CN_TYPE_BODY_DEF = 6;
pub const CN_TYPE_SHAPE_DEF = 7;
pub const CN_TYPE_CIRCLE = 8;
pub const CN_TYPE_CAPSULE = 9;
pub const CN_TYPE_EDGE = 10;
pub const CN_TYPE_POLYGON = 11;
pub const CN_TYPE_CHAIN = 12;
pub const CN_TYPE_FILTER = 13;
pub const CN_TYPE_MATERIAL = 14;
pub const CN_TYPE_MANIFOLD_POINT = 15;
pub const CN_TYPE_MANIFOLD = 16;
pub const CN_TYPE_CONTACT_EVENT = 17;
pub const CN_TYPE_BODY_MOVED = 18;
pub const CN_TYPE_REVOLUTE_DEF = 19;
pub const CN_TYPE_DISTANCE_DEF = 20;
pub const CN_TYPE_COUNTERS = 21;
pub const CN_TYPE_PROFILE = 22;
pub const CN_TYPE_MEMORY_STATS = 23;
pub const CN_TYPE_SENSOR_EVENT = 24;
pub const CN_TYPE_UPDATE_REPORT = 25;
pub const CN_TYPE_DEBUG_DRAW = 26;
pub const CN_TYPE_QUERY_FILTER = 27;
pub const CN_TYPE_RAY = 28;
pub const CN_TYPE_RAY_HIT = 29;
pub const CN_TYPE_CLOSEST = 30;
pub const CN_TYPE_EXPLOSION_DEF = 31;
pub const CN_TYPE_FIXED_DEF = 32;
pub const CN_TYPE_PRISMATIC_DEF = 33;
pub const CN_TYPE_WHEEL_DEF = 34;
pub const CN_TYPE_MOTOR_DEF = 35;
pub const CN_TYPE_MOUSE_DEF = 36;
pub const CN_TYPE_GEAR_DEF = 37;
pub const CN_TYPE_PULLEY_DEF = 38;
pub const CN_TYPE_RATCHET_DEF = 39;
pub const CN_TYPE_ROTARY_SPRING_DEF = 40;
pub const CN_TYPE_GROOVE_DEF = 41;
pub const CN_TYPE_FILTER_JOINT_DEF = 42;
pub const CN_TYPE_JOINT_BASE = 43;
pub const CN_TYPE_JOINT_EVENT = 44;
pub const CN_TYPE_ANGLE_CONSTRAINT_DEF = 45;
pub const CN_TYPE_LINE_CONSTRAINT_DEF = 46;
pub const CN_TYPE_ISLAND_REPORT = 47;
pub const CN_TYPE_DISTANCE = 48;
pub const CN_TYPE_SWEEP = 49;
pub const CN_TYPE_IMPACT = 50;
pub const CN_TYPE_PLANE = 51;
pub const CN_TYPE_MOVER_DEF = 52;
pub const CN_TYPE_MOVER = 53;
pub const CN_TYPE_AREA_DEF = 54;
pub const CN_TYPE_COUNT = 55;

// Flags of a world.
/// islands at rest fall asleep (default on)
pub const CN_WORLD_SLEEP = 1;
/// start solving from the last step's impulses (default on)
pub const CN_WORLD_WARM_START = 2;
/// measure cn_profile (default off: reading a clock costs time)
pub const CN_WORLD_PROFILE = 4;
/// fast bodies stop at surfaces instead of passing through (default on)
pub const CN_WORLD_CONTINUOUS = 8;

// What a block of fixed capacities (cn_world_def.memory) has room for from the beginning.
/// a name of each body
pub const CN_RESERVE_NAMES = 1;
/// chains; cn_material.user_id of each shape
pub const CN_RESERVE_CHAINS = 2;
/// rolling resistance, conveyors, locked axes
pub const CN_RESERVE_EXTRA_ROWS = 4;
/// lists of moved bodies, interpolated poses
pub const CN_RESERVE_MOVED = 8;

// Solvers: see examples/docs/solvers.md.
/// soft constraints with substeps, and direct solving of joints, leaning piles and heavily loaded piles
pub const CN_SOLVER_AUTO = 0;
/// soft contact and joint constraints with substeps only (Catto, Solver2D, 2024)
pub const CN_SOLVER_SOFT = 1;
/// direct solving of all joints, and of all piles without joints, at any cost
pub const CN_SOLVER_DIRECT = 2;
/// the paper's twelve steps, once a step: a baseline (limits: examples/docs/limits.md)
pub const CN_SOLVER_SEQUENTIAL = 3;

// Broadphases.
/// tiled sweep-and-prune
pub const CN_BROADPHASE_SWEEP = 0;
/// dynamic AABB tree: for worlds of very mixed sizes with many region queries
pub const CN_BROADPHASE_TREE = 1;

// Warnings of a step that lacked memory or skipped work.
/// new contacts were not added: pairs_not_added
pub const CN_WARNING_CONTACT_MEMORY = 1;
/// the step worked around missing scratch memory
pub const CN_WARNING_FRAME_MEMORY = 2;
/// events_not_reported
pub const CN_WARNING_EVENT_MEMORY = 4;
/// thousands of boxes overlap in one spot: contacts of the most crowded bodies come over several steps, and
/// pairs_not_added counts what the last step left out
pub const CN_WARNING_CROWD = 8;
/// forces or impulses gave bodies a speed that floats cannot hold: these bodies were stopped at their poses,
/// and the others go on
pub const CN_WARNING_NOT_FINITE = 16;

// How an island is solved. In each tier joints may be solved together with their neighbours.
/// contacts by soft constraints
pub const CN_TIER_SOFT = 0;
/// contacts and joints in one system, exactly
pub const CN_TIER_DIRECT = 1;
/// no contacts and no joints: nothing to solve
pub const CN_TIER_FREE = 2;

// Why an island has its tier. "A problem" is one of CN_TIER_REASON_NEW_CONTACT, _OVERLAP and _STRESSED.
/// no problem
pub const CN_TIER_REASON_NONE = 0;
/// direct: the problem has ended, but not for long enough
pub const CN_TIER_REASON_SETTLING = 1;
/// direct: a contact began to carry load in a leaning or heavily loaded island
pub const CN_TIER_REASON_NEW_CONTACT = 2;
/// direct: an overlap exceeds the accuracy
pub const CN_TIER_REASON_OVERLAP = 3;
/// no longer used
pub const CN_TIER_REASON_JOINT = 4;
/// direct: a body carries so many times its weight that soft contacts would yield
pub const CN_TIER_REASON_STRESSED = 5;
/// the world's solver is not CN_SOLVER_AUTO
pub const CN_TIER_REASON_SOLVER = 6;
/// a body's own solver: cn_body_set_solver
pub const CN_TIER_REASON_OVERRIDE = 7;
/// soft: a single body
pub const CN_TIER_REASON_ALONE = 8;
/// soft: a problem, but the island moves too fast, bounces, or did a short time ago
pub const CN_TIER_REASON_MOVING = 9;
/// soft: a problem, but the island or the sum of such islands is too large
pub const CN_TIER_REASON_CROWDED = 10;
/// soft for a time: the system exceeds the work limit or the work_budget
pub const CN_TIER_REASON_WORK = 11;
/// soft for a time: a conveyor, a locked axis, or rolling resistance at a single point
pub const CN_TIER_REASON_KIND = 12;
/// soft for a time: no solution was found for its contacts; it stays awake while it moves at all
pub const CN_TIER_REASON_NO_SET = 13;
/// soft: no scratch memory (CN_WARNING_FRAME_MEMORY)
pub const CN_TIER_REASON_MEMORY = 14;
/// soft contacts: a problem, but the island has joints (which are solved directly)
pub const CN_TIER_REASON_JOINTED = 15;

// Types of bodies.
/// never moves, infinite mass
pub const CN_BODY_STATIC = 0;
/// moves by its velocity alone, infinite mass
pub const CN_BODY_KINEMATIC = 1;
/// moves by forces, contacts and joints
pub const CN_BODY_DYNAMIC = 2;

// Flags of a body.
/// the centre of mass keeps its world x
pub const CN_BODY_LOCK_X = 1;
/// ... its world y
pub const CN_BODY_LOCK_Y = 2;
/// the body keeps its angle
pub const CN_BODY_LOCK_ROTATION = 4;
/// continuous collision against dynamic bodies too
pub const CN_BODY_BULLET = 8;
/// takes part in the simulation (default on)
pub const CN_BODY_ENABLED = 16;
/// may fall asleep (default on)
pub const CN_BODY_SLEEP = 32;
/// starts awake (default on)
pub const CN_BODY_AWAKE = 64;

// Types of shapes.
pub const CN_SHAPE_CIRCLE = 0;
pub const CN_SHAPE_CAPSULE = 1;
pub const CN_SHAPE_POLYGON = 2;
pub const CN_SHAPE_EDGE = 3;
pub const CN_SHAPE_CHAIN = 4;

// How the values of two materials are mixed. If the materials have different rules, the later one of this
// list applies.
/// half the sum
pub const CN_MIX_AVERAGE = 0;
/// square root of the product; default for friction
pub const CN_MIX_GEOMETRIC = 1;
/// the smaller one
pub const CN_MIX_MINIMUM = 2;
/// the product
pub const CN_MIX_MULTIPLY = 3;
/// the greater one; default for restitution
pub const CN_MIX_MAXIMUM = 4;

// Flags of a shape.
/// detects shapes that enter and leave, collides with nothing: cn_world_sensor_events
pub const CN_SHAPE_SENSOR = 1;
/// queries see this sensor (default: they do not)
pub const CN_SHAPE_SENSOR_SEEN = 2;
/// collides only with shapes that come from the side of its local +y axis
pub const CN_SHAPE_ONE_WAY = 4;
/// the pre-solve callback is called for its contacts
pub const CN_SHAPE_PRE_SOLVE = 8;

// Kinds of contact events.
/// the fat boxes of two shapes began to overlap
pub const CN_EVENT_CREATED = 0;
/// they began to touch
pub const CN_EVENT_ENTER = 1;
/// they still touch
pub const CN_EVENT_STAY = 2;
/// they stopped touching, or one is gone
pub const CN_EVENT_LEAVE = 3;
/// the fat boxes no longer overlap, or one is gone
pub const CN_EVENT_DESTROYED = 4;
/// a blow at hit_speed_mps of cn_world_def or faster, at the beginning of touching or within it
pub const CN_EVENT_HIT = 5;
/// number of kinds
pub const CN_EVENT_KINDS = 6;

// Types of joints: see their definitions.
pub const CN_JOINT_REVOLUTE = 0;
pub const CN_JOINT_DISTANCE = 1;
pub const CN_JOINT_FIXED = 2;
pub const CN_JOINT_PRISMATIC = 3;
pub const CN_JOINT_WHEEL = 4;
pub const CN_JOINT_MOTOR_TO = 5;
pub const CN_JOINT_MOUSE = 6;
pub const CN_JOINT_GEAR = 7;
pub const CN_JOINT_PULLEY = 8;
pub const CN_JOINT_RATCHET = 9;
pub const CN_JOINT_ROTARY_SPRING = 10;
pub const CN_JOINT_GROOVE = 11;
pub const CN_JOINT_FILTER = 12;

// Flags of a joint.
/// the connected bodies' shapes collide with each other (default off)
pub const CN_JOINT_COLLIDE = 1;
/// the limits hold
pub const CN_JOINT_LIMIT = 2;
/// the motor runs
pub const CN_JOINT_MOTOR = 4;
/// the spring pulls
pub const CN_JOINT_SPRING = 8;
/// destroyed beyond its break force or torque, not only reported
pub const CN_JOINT_BREAKS = 16;

// Types of constraints.
/// cn_angle_constraint_def
pub const CN_CONSTRAINT_ANGLE = 0;
/// cn_line_constraint_def
pub const CN_CONSTRAINT_LINE = 1;

// Flags of a constraint.
/// line: the limits along the axis hold
pub const CN_CONSTRAINT_LIMIT = 1;
/// destroyed beyond its break force or torque, not only reported
pub const CN_CONSTRAINT_BREAKS = 2;

// Results of a cn_query_fn.
/// ignore the shape
pub const CN_QUERY_SKIP = 0;
/// take it
pub const CN_QUERY_TAKE = 1;
/// take it, and nothing after it in the order of results
pub const CN_QUERY_STOP = 2;

// Flags of a query.
/// also ignore bodies that a joint connects to ignored_body
pub const CN_QUERY_IGNORE_JOINED = 1;
/// casts meet one-way shapes from their upper side (45 degrees) only, and not those that they start in by
/// more than 0.5% of the length unit; all other queries do not see one-way shapes. Default: they are like
/// others
pub const CN_QUERY_ONE_WAY = 2;
/// casts do not hit shapes that they start in, at any depth, unless they lead farther in
pub const CN_QUERY_LEAVING = 4;

// States of a time of impact.
/// the shapes never come that close; fraction is 1
pub const CN_IMPACT_NONE = 0;
/// they do, at fraction
pub const CN_IMPACT_HIT = 1;
/// the shapes without their radii overlap at the start: fraction 0, no normal
pub const CN_IMPACT_OVERLAP = 2;
/// no hit before fraction, perhaps one after it: the search ended early
pub const CN_IMPACT_FAILED = 3;

// Flags of a mover's definition.
/// ignore one-way shapes: set it while the character drops through one
pub const CN_MOVER_DROP = 1;

// State flags of a mover.
/// stands on walkable ground
pub const CN_MOVER_ON_GROUND = 1;
/// touches a surface too steep to walk on
pub const CN_MOVER_ON_WALL = 2;
/// touches a surface above it
pub const CN_MOVER_ON_CEILING = 4;

// Flags of an area.
/// bodies whose centre of mass is in it: the world's gravity and areas of lower order do not act on them
pub const CN_AREA_REPLACE = 1;

// What cn_world_draw draws.
/// coloured by type and sleep
pub const CN_DRAW_SHAPES = 1;
/// and constraints: anchors, axes, limits
pub const CN_DRAW_JOINTS = 2;
/// points and normals
pub const CN_DRAW_CONTACTS = 4;
/// without margin
pub const CN_DRAW_AABBS = 8;
/// of mass, with the bodies' names
pub const CN_DRAW_CENTERS = 16;
/// colours by island
pub const CN_DRAW_ISLANDS = 32;

pub const cn_result = i32;
pub const cn_body = enum(u32) { none = 0, _ };
pub const cn_shape = enum(u32) { none = 0, _ };
pub const cn_joint = enum(u32) { none = 0, _ };
pub const cn_constraint = enum(u32) { none = 0, _ };
pub const cn_world = opaque {};
pub const cn_tree = opaque {};

/// Memory hook: allocates bytes aligned to align, a power of two of at most 64; returns NULL when there is no
/// memory. Called only from inside functions that take a non-const world.
pub const cn_alloc_fn = fn (bytes: u64, @"align": u32, user: ?*anyopaque) callconv(.c) ?*anyopaque;

/// Memory hook: frees memory of cn_alloc_fn; bytes is the size it was allocated with.
pub const cn_free_fn = fn (memory: ?*anyopaque, bytes: u64, user: ?*anyopaque) callconv(.c) void;

/// The library's part of a user's task system (cn_world_def.enqueue and finish, for worlds with worker_count
/// of 2 or more; without them the world starts its own threads). Call it for ranges [begin, end) that
/// together cover 0 to item_count - 1, each item once, on any threads, in any order. A call may last as long
/// as the step and may wait for calls that have begun, never for one that has not. Its thread must have the
/// floating-point mode of the stepping thread.
pub const cn_task_fn = fn (begin: i32, end: i32, context: ?*anyopaque) callconv(.c) void;

/// Starts a task of item_count items (worker_count - 1) in ranges of at least min_range and returns a handle
/// for finish. It may run the whole task at once, and must do so if it cannot store the task; it then returns
/// NULL, and finish is not called. A step with enough work enqueues 3 to 10 tasks; enqueue and finish run in
/// the stepping thread, never during a callback, and must not call the library.
pub const cn_enqueue_fn = fn (task: *const cn_task_fn, context: ?*anyopaque, item_count: i32, min_range: i32, user: ?*anyopaque) callconv(.c) ?*anyopaque;

/// Returns when every item of the task has run; it may run items itself. Called once for each enqueue that
/// did not return NULL, in the thread that enqueued.
pub const cn_finish_fn = fn (task: ?*anyopaque, user: ?*anyopaque) callconv(.c) void;

/// Called at the end of cn_world_step for each event of this kind, in the order of the array.
pub const cn_contact_event_fn = fn (world: *cn_world, event: *const cn_contact_event, user: ?*anyopaque) callconv(.c) void;

/// Returns 1 if two shapes that pass their filters may touch, else 0. Called when their boxes begin to
/// overlap; the world is locked.
pub const cn_filter_fn = fn (world: *cn_world, shape_a: cn_shape, shape_b: cn_shape, user: ?*anyopaque) callconv(.c) i32;

/// Called in every step, before solving, for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE; the
/// event's kind is STAY or ENTER. Returns 0 to let the pair pass through each other in this step, else 1.
pub const cn_pre_solve_fn = fn (world: *cn_world, contact: *const cn_contact_event, user: ?*anyopaque) callconv(.c) i32;

/// Mixes two materials instead of the CN_MIX_ rules: *mixed holds the rules' result and takes the new one.
/// Called when a pair begins to touch and when a material changes.
pub const cn_material_mix_fn = fn (world: *cn_world, shape_a: cn_shape, shape_b: cn_shape, mixed: *cn_material, user: ?*anyopaque) callconv(.c) void;

/// Called by a query for each shape (edge of a chain) found, in no particular order and perhaps more than
/// once: the result, CN_QUERY_*, must depend on the shape alone. hit is complete in casts; other queries set
/// shape, body and child. May call only functions that take a const world, also of the same world.
pub const cn_query_fn = fn (world: *const cn_world, hit: *const cn_ray_hit, user: ?*anyopaque) callconv(.c) i32;

/// count points, counter-clockwise
pub const cn_debug_draw_polygon_fn = fn (points_m: [*]const cn_vec2, count: i32, radius_m: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

/// rim_m: a point on the rim that turns with the body
pub const cn_debug_draw_circle_fn = fn (center_m: *const cn_vec2, radius_m: f32, rim_m: *const cn_vec2, color: u32, user: ?*anyopaque) callconv(.c) void;

/// a disc swept from a to b
pub const cn_debug_draw_capsule_fn = fn (a_m: *const cn_vec2, b_m: *const cn_vec2, radius_m: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

/// a line from a to b
pub const cn_debug_draw_segment_fn = fn (a_m: *const cn_vec2, b_m: *const cn_vec2, color: u32, user: ?*anyopaque) callconv(.c) void;

/// size in pixels
pub const cn_debug_draw_point_fn = fn (point_m: *const cn_vec2, size_px: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

/// zero-terminated, valid during the call
pub const cn_debug_draw_text_fn = fn (point_m: *const cn_vec2, text: [*:0]const u8, color: u32, user: ?*anyopaque) callconv(.c) void;

/// Returns 0 to stop the search, any other value to continue.
pub const cn_tree_query_fn = fn (item: u32, user_data: u64, user: ?*anyopaque) callconv(.c) i32;

/// Returns the fraction at which the ray now ends: the given one to ignore the item, 0 to stop.
pub const cn_tree_ray_fn = fn (item: u32, user_data: u64, fraction: f32, user: ?*anyopaque) callconv(.c) f32;

/// A point, vector or pair of numbers.
pub const cn_vec2 = extern struct {
    /// to the right
    x: f32,
    /// upwards
    y: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_vec2) != 8) @compileError("cn_vec2");
    }
};

/// Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
/// uploaded to a GPU directly.
pub const cn_pose = extern struct {
    /// of the body's origin
    position_m: cn_vec2,
    /// of the angle
    cosine: f32,
    /// of the angle
    sine: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_pose) != 16) @compileError("cn_pose");
    }
};

/// Velocity of a body.
pub const cn_velocity = extern struct {
    /// of the centre of mass
    linear_mps: cn_vec2,
    /// counter-clockwise is positive
    angular_radps: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_velocity) != 12) @compileError("cn_velocity");
    }
};

/// Axis-aligned bounding box, lower_m <= upper_m.
pub const cn_aabb = extern struct {
    /// left and bottom
    lower_m: cn_vec2,
    /// right and top
    upper_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_aabb) != 16) @compileError("cn_aabb");
    }
};

/// Mass, inertia and centre of mass.
pub const cn_mass_data = extern struct {
    /// of all shapes, or as set
    mass_kg: f32,
    /// about the centre of mass
    inertia_kgm2: f32,
    /// in the body's local frame
    center_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mass_data) != 16) @compileError("cn_mass_data");
    }
};

/// Definition of a world.
pub const cn_world_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS
    flags: u32,
    /// default (0, -10)
    gravity_mps2: cn_vec2,
    /// a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1
    length_unit_m: f32,
    /// CN_SOLVER_*; default CN_SOLVER_AUTO
    solver: i32,
    /// CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP
    broadphase: i32,
    /// 1 to 64; default 4
    substep_count: i32,
    /// CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit
    accuracy_m: f32,
    /// limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
    /// included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
    /// CN_SOLVER_AUTO 512 contacts of a world
    work_budget: i32,
    /// slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit
    restitution_threshold_mps: f32,
    /// greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved
    /// joint closes (of its angles: rad/s, for each length unit), > 0; in a crowd the speeds of neighbours
    /// add up: n bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which
    /// pushes them upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit
    push_speed_max_mps: f32,
    /// faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit
    linear_speed_max_mps: f32,
    /// faster bodies are slowed to it, > 0; default 400
    angular_speed_max_radps: f32,
    /// bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit
    sleep_speed_mps: f32,
    /// ... after this time, >= 0; default 0.5
    sleep_delay_s: f32,
    /// hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0;
    /// default 0
    body_capacity: i32,
    /// counts every edge of a chain
    shape_capacity: i32,
    /// pairs whose fat AABBs overlap
    contact_capacity: i32,
    /// counts constraints too
    joint_capacity: i32,
    /// a number for the user; default 0
    user_data: u64,
    /// size of memory; 0: use alloc and free
    memory_bytes: u64,
    /// NULL, or one block aligned to 64 bytes that holds the whole world
    memory: ?[*]u8,
    /// NULL: malloc; set both or none
    alloc: ?*const cn_alloc_fn,
    /// NULL: free
    free: ?*const cn_free_fn,
    /// last argument of alloc and free
    allocator_user: ?*anyopaque,
    /// NULL: the world's own threads; set both or none
    enqueue: ?*const cn_enqueue_fn,
    /// see cn_finish_fn
    finish: ?*const cn_finish_fn,
    /// last argument of enqueue and finish
    task_user: ?*anyopaque,
    /// threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no
    /// tasks
    worker_count: i32,
    /// blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit
    hit_speed_mps: f32,
    /// Of a world in one block (memory); others ignore them. pairs that touch at once, >= 0; further ones do
    /// not collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity
    touching_capacity: i32,
    /// pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which
    /// cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity
    event_capacity: i32,
    /// vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block;
    /// default CN_POLYGON_MAX_VERTICES
    vertex_capacity: i32,
    /// CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all
    reserve: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_world_def) != 176) @compileError("cn_world_def");
    }
};

/// Counts of objects, and problems of the last step.
pub const cn_counters = extern struct {
    /// alive
    bodies: i32,
    /// dynamic and kinematic bodies that are simulated
    bodies_awake: i32,
    /// alive
    shapes: i32,
    /// boxes in the broadphase: one per shape, one per edge of a chain
    proxies: i32,
    /// pairs whose fat boxes overlap
    contacts: i32,
    /// with an awake body
    contacts_awake: i32,
    /// pairs with a manifold, asleep or awake
    contacts_touching: i32,
    /// and constraints
    joints: i32,
    /// and constraints, with an awake body
    joints_awake: i32,
    /// awake and asleep; a single dynamic body counts
    islands: i32,
    /// of them
    islands_awake: i32,
    /// groups of contacts that share no dynamic body
    colors_used: i32,
    /// contacts that fit no colour: solved one by one
    overflow_contacts: i32,
    /// cells of the broadphase
    broadphase_tiles: i32,
    /// steps taken since creation, modulo 2^32
    steps: u32,
    /// Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try
    /// again. CN_WARNING_*
    warnings: u32,
    /// new pairs without a contact
    pairs_not_added: i32,
    /// events without a place in a log
    events_not_reported: i32,
    /// of several bodies, solved directly in the last step, contacts included
    islands_direct: i32,
    /// planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1
    direct_work: i32,
    /// of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET
    islands_unsolved: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_counters) != 84) @compileError("cn_counters");
    }
};

/// Report on one island.
pub const cn_island_report = extern struct {
    /// its body of least slot
    body: cn_body,
    /// dynamic
    bodies: i32,
    /// touching
    contacts: i32,
    /// and constraints
    joints: i32,
    /// CN_TIER_*, after the last step
    tier: i32,
    /// CN_TIER_REASON_*
    reason: i32,
    /// of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more
    substeps: i32,
    /// at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent);
    /// joints that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count
    residual_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_island_report) != 32) @compileError("cn_island_report");
    }
};

/// Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.
pub const cn_profile = extern struct {
    /// the whole step
    step_s: f32,
    /// waking
    wake_s: f32,
    /// pairs
    broadphase_s: f32,
    /// manifolds
    narrowphase_s: f32,
    /// islands
    islands_s: f32,
    /// constraints, plans
    prepare_s: f32,
    /// all substeps
    substeps_s: f32,
    /// poses and boxes
    finalize_s: f32,
    /// callbacks
    events_s: f32,
    /// falling asleep
    sleep_s: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_profile) != 40) @compileError("cn_profile");
    }
};

/// Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
/// allocator serves small variable-size pieces from free lists of size classes.
pub const cn_memory_stats = extern struct {
    /// taken from the user's allocator or carved from the fixed block
    bytes_in_use: u64,
    /// most bytes_in_use since creation
    bytes_peak: u64,
    /// calls of the user's alloc (or of the fixed block's) since creation
    allocator_calls: u64,
    /// of the frame arena
    arena_capacity: u64,
    /// most bytes in use at once since creation
    arena_peak: u64,
    /// entries that did not fit: the allocator served them; since creation
    arena_fallbacks: u64,
    /// bytes in chunks
    blocks_capacity: u64,
    /// bytes handed out of them
    blocks_in_use: u64,
    /// blocks above the largest class, served by the allocator
    blocks_large: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_memory_stats) != 72) @compileError("cn_memory_stats");
    }
};

/// Definition of a body.
pub const cn_body_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
    @"type": i32,
    /// of the origin; |x|, |y| <= 1e6 x length unit
    position_m: cn_vec2,
    /// |angle| <= 1e4
    angle_rad: f32,
    /// of the centre of mass; both velocities are ignored without CN_BODY_AWAKE
    linear_velocity_mps: cn_vec2,
    /// default 0
    angular_velocity_radps: f32,
    /// v' = -damping v; >= 0, default 0
    linear_damping_per_s: f32,
    /// >= 0, default 0
    angular_damping_per_s: f32,
    /// default 1
    gravity_scale: f32,
    /// >= 0; CN_DEFAULT (default): the world's
    sleep_speed_mps: f32,
    /// CN_BODY_*; default ENABLED | SLEEP | AWAKE
    flags: u32,
    /// as in cn_body_set_solver; default CN_SOLVER_AUTO
    solver: i32,
    /// a number for the user; default 0
    user_data: u64,
    /// NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
    name: ?[*:0]const u8,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_body_def) != 72) @compileError("cn_body_def");
    }
};

/// A body that moved or fell asleep in the last step.
pub const cn_body_moved = extern struct {
    /// after the step
    pose: cn_pose,
    /// the body's
    user_data: u64,
    /// that moved
    body: cn_body,
    /// 1 in the step in which it fell asleep
    fell_asleep: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_body_moved) != 32) @compileError("cn_body_moved");
    }
};

/// Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
/// collide if the category of each has a bit in the mask of the other.
pub const cn_filter = extern struct {
    /// default 1
    category: u64,
    /// default all ones
    mask: u64,
    /// default 0
    group: i32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_filter) != 24) @compileError("cn_filter");
    }
};

/// Surface of a shape.
pub const cn_material = extern struct {
    /// coefficient while sticking, [0, 100], default 0.6
    static_friction: f32,
    /// coefficient while sliding, [0, static_friction], default 0.6
    dynamic_friction: f32,
    /// [0, 1], default 0
    restitution: f32,
    /// metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0
    rolling_resistance: f32,
    /// conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0
    tangent_speed_mps: f32,
    /// CN_MIX_*; default CN_MIX_GEOMETRIC
    friction_mix: i32,
    /// CN_MIX_*; default CN_MIX_MAXIMUM
    restitution_mix: i32,
    /// a number for the user, reported in contact events; default 0
    user_id: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_material) != 32) @compileError("cn_material");
    }
};

/// Definition of a shape.
pub const cn_shape_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// 0: create unattached, for cn_shape_attach
    body: cn_body,
    /// of the shape in the body's local frame
    offset_m: cn_vec2,
    /// of the shape in the body's local frame
    angle_rad: f32,
    /// >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
    density_kgpm2: f32,
    /// defaults: see cn_material
    material: cn_material,
    /// defaults: see cn_filter
    filter: cn_filter,
    /// bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE
    event_mask: u32,
    /// CN_SHAPE_SENSOR ...; default 0
    flags: u32,
    /// a number for the user; default 0
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_shape_def) != 96) @compileError("cn_shape_def");
    }
};

/// A disc.
pub const cn_circle = extern struct {
    /// in the body's frame
    center_m: cn_vec2,
    /// > 0
    radius_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_circle) != 12) @compileError("cn_circle");
    }
};

/// All points within radius_m of the segment.
pub const cn_capsule = extern struct {
    /// one end of the segment, in the body's frame
    a_m: cn_vec2,
    /// the other end
    b_m: cn_vec2,
    /// around the segment, > 0
    radius_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_capsule) != 20) @compileError("cn_capsule");
    }
};

/// A two-sided segment without mass.
pub const cn_edge = extern struct {
    /// one end, in the body's frame
    a_m: cn_vec2,
    /// the other end
    b_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_edge) != 16) @compileError("cn_edge");
    }
};

/// Convex polygon. Either winding is accepted; points are stored counter-clockwise.
pub const cn_polygon = extern struct {
    /// 3 to CN_POLYGON_MAX_VERTICES
    count: i32,
    /// rounding added outside the points, >= 0
    radius_m: f32,
    /// the first count of them; in the body's frame
    points_m: [16]cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_polygon) != 136) @compileError("cn_polygon");
    }
};

/// One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is on
/// the left of the order of points and surface normals point to the right: points that run from +x to -x
/// collide from above, a counter-clockwise loop collides from outside.
pub const cn_chain = extern struct {
    /// copied
    points_m: [*]const cn_vec2,
    /// an open chain: >= 2; a loop: >= 3; at most 65535
    count: i32,
    /// 1: the last point joins the first
    loop: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_chain) != 16) @compileError("cn_chain");
    }
};

/// One point of a contact.
pub const cn_manifold_point = extern struct {
    /// world, midway between the surfaces
    point_m: cn_vec2,
    /// negative when overlapping
    separation_m: f32,
    /// of the last substep
    normal_impulse_Ns: f32,
    /// the same while the same features touch
    feature_id: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_manifold_point) != 20) @compileError("cn_manifold_point");
    }
};

/// How two shapes touch.
pub const cn_manifold = extern struct {
    /// unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the
    /// faces' by up to 0.1 rad, so that piles stand
    normal: cn_vec2,
    /// of the last substep, on body b along (normal.y, -normal.x)
    friction_impulse_Ns: f32,
    /// 0, 1 or 2
    point_count: i32,
    /// the first point_count of them
    points: [2]cn_manifold_point,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_manifold) != 56) @compileError("cn_manifold");
    }
};

/// A contact event, or the present state of a contact.
pub const cn_contact_event = extern struct {
    /// one shape of the pair
    shape_a: cn_shape,
    /// the other
    shape_b: cn_shape,
    /// of shape_a
    body_a: cn_body,
    /// of shape_b
    body_b: cn_body,
    /// edge number within a chain, else 0
    child_a: i32,
    /// the same of shape b
    child_b: i32,
    /// the same from CREATED to DESTROYED, then reused
    contact_id: u32,
    /// CN_EVENT_*
    kind: i32,
    /// ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0
    approach_speed_mps: f32,
    /// geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT
    manifold: cn_manifold,
    /// Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
    /// cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact
    /// that its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean
    /// force is normal_impulse_Ns / dt_s
    normal_impulse_Ns: f32,
    /// along (normal.y, -normal.x), on body b
    friction_impulse_Ns: f32,
    /// HIT: where, in the world; else (0, 0)
    hit_point_m: cn_vec2,
    /// cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED
    material_a: u32,
    /// the same of shape_b
    material_b: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_contact_event) != 116) @compileError("cn_contact_event");
    }
};

/// A shape entered or left a sensor.
pub const cn_sensor_event = extern struct {
    /// the sensor
    sensor: cn_shape,
    /// the shape that it met
    visitor: cn_shape,
    /// the sensor's body
    sensor_body: cn_body,
    /// the visitor's body
    visitor_body: cn_body,
    /// CN_EVENT_ENTER or CN_EVENT_LEAVE
    kind: i32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_sensor_event) != 24) @compileError("cn_sensor_event");
    }
};

/// First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
/// limits in place; springs and motors are not rigid parts.
pub const cn_joint_base = extern struct {
    /// of the whole definition
    struct_size: u32,
    /// CN_JOINT_*; default 0; a type ignores flags that it does not use
    flags: u32,
    /// 0: the world
    body_a: cn_body,
    /// 0: the world; one of the two must be dynamic
    body_b: cn_body,
    /// in body a's local frame, or in world coordinates
    anchor_a_m: cn_vec2,
    /// the same for body b
    anchor_b_m: cn_vec2,
    /// of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of
    /// all springs; CN_DEFAULT (default): as stiff as the substeps permit
    stiffness_hertz: f32,
    /// used with a stiffness_hertz; 0 to 1e6, default 0
    stiffness_damping_ratio: f32,
    /// greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded
    force_max_N: f32,
    /// greatest torque of angles, > 0; CN_DEFAULT (default): unbounded
    torque_max_Nm: f32,
    /// a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default):
    /// never
    break_force_N: f32,
    /// the same for the torque
    break_torque_Nm: f32,
    /// a number for the user; default 0
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_joint_base) != 64) @compileError("cn_joint_base");
    }
};

/// Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].
pub const cn_revolute_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// angle b - angle a at joint angle 0
    reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
    lower_angle_rad: f32,
    /// the upper limit
    upper_angle_rad: f32,
    /// CN_JOINT_MOTOR
    motor_speed_radps: f32,
    /// >= 0
    motor_torque_max_Nm: f32,
    /// CN_JOINT_SPRING: pulls the joint angle to this
    spring_target_rad: f32,
    /// 0 to 1e6
    spring_hertz: f32,
    /// 0 to 1e6
    spring_damping_ratio: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_revolute_def) != 96) @compileError("cn_revolute_def");
    }
};

/// Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
/// length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max];
/// limits alone make a rope (min 0).
pub const cn_distance_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// > 0; default 1
    length_m: f32,
    /// CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
    length_min_m: f32,
    /// the upper limit
    length_max_m: f32,
    /// CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
    motor_speed_mps: f32,
    /// >= 0
    motor_force_max_N: f32,
    /// 0 to 1e6
    spring_hertz: f32,
    /// 0 to 1e6
    spring_damping_ratio: f32,
    /// 0
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_distance_def) != 96) @compileError("cn_distance_def");
    }
};

/// Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy.
pub const cn_fixed_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// angle b - angle a
    reference_angle_rad: f32,
    /// stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's
    angular_hertz: f32,
    /// 0 to 1e6
    angular_damping_ratio: f32,
    /// 0
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_fixed_def) != 80) @compileError("cn_fixed_def");
    }
};

/// b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.
pub const cn_prismatic_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (1, 0)
    axis: cn_vec2,
    /// angle b - angle a
    reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: lower <= upper
    lower_m: f32,
    /// the upper limit
    upper_m: f32,
    /// CN_JOINT_MOTOR
    motor_speed_mps: f32,
    /// >= 0
    motor_force_max_N: f32,
    /// CN_JOINT_SPRING: pulls the translation to this
    spring_target_m: f32,
    /// 0 to 1e6
    spring_hertz: f32,
    /// 0 to 1e6
    spring_damping_ratio: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_prismatic_def) != 104) @compileError("cn_prismatic_def");
    }
};

/// A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
/// by the motor.
pub const cn_wheel_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (0, 1)
    axis: cn_vec2,
    /// CN_JOINT_LIMIT: lower <= upper
    lower_m: f32,
    /// the upper limit
    upper_m: f32,
    /// CN_JOINT_MOTOR
    motor_speed_radps: f32,
    /// >= 0
    motor_torque_max_Nm: f32,
    /// CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1
    spring_hertz: f32,
    /// 0 to 1e6, default 0.7
    spring_damping_ratio: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_wheel_def) != 96) @compileError("cn_wheel_def");
    }
};

/// Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
/// base.torque_max_Nm must be > 0.
pub const cn_motor_def = extern struct {
    /// anchor b is driven to anchor a + offset
    base: cn_joint_base,
    /// in body a's frame
    offset_m: cn_vec2,
    /// angle b - angle a
    angle_rad: f32,
    /// frequency of the spring, > 0, to 1e6; default 5
    hertz: f32,
    /// 0 to 1e6, default 1
    damping_ratio: f32,
    /// 0
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_motor_def) != 88) @compileError("cn_motor_def");
    }
};

/// Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
/// base.force_max_N must be > 0.
pub const cn_mouse_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// world
    target_m: cn_vec2,
    /// > 0, to 1e6; default 5
    hertz: f32,
    /// 0 to 1e6, default 0.7
    damping_ratio: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mouse_def) != 80) @compileError("cn_mouse_def");
    }
};

/// angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
/// and count whole turns from there.
pub const cn_gear_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// size 1e-4 to 1e4, negative: they turn against each other; default 1
    ratio: f32,
    /// default 0
    phase_rad: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_gear_def) != 72) @compileError("cn_gear_def");
    }
};

/// A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never
/// pushes.
pub const cn_pulley_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// world
    ground_a_m: cn_vec2,
    /// world
    ground_b_m: cn_vec2,
    /// 1e-4 to 1e4; default 1
    ratio: f32,
    /// > 0: must be set
    length_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_pulley_def) != 88) @compileError("cn_pulley_def");
    }
};

/// b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase
/// + n * click_rad for every whole number n, over whole turns.
pub const cn_ratchet_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// default 0
    phase_rad: f32,
    /// size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise
    click_rad: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ratchet_def) != 72) @compileError("cn_ratchet_def");
    }
};

/// A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
/// the two bodies.
pub const cn_rotary_spring_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// default 0
    rest_angle_rad: f32,
    /// > 0, to 1e6; default 1
    hertz: f32,
    /// 0 to 1e6, default 0
    damping_ratio: f32,
    /// 0
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_rotary_spring_def) != 80) @compileError("cn_rotary_spring_def");
    }
};

/// Anchor b slides in a slot of body a from anchor a to end_m.
pub const cn_groove_def = extern struct {
    /// what every joint has
    base: cn_joint_base,
    /// in body a's frame; not equal to anchor a; default (1, 0)
    end_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_groove_def) != 72) @compileError("cn_groove_def");
    }
};

/// The two bodies do not collide; no other effect.
pub const cn_filter_joint_def = extern struct {
    /// what every joint has
    base: cn_joint_base,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_filter_joint_def) != 64) @compileError("cn_filter_joint_def");
    }
};

/// A joint or constraint exceeded a break threshold or was destroyed with a body.
pub const cn_joint_event = extern struct {
    /// 0: it was a constraint; stale when destroyed is 1
    joint: cn_joint,
    /// 0: it was a joint; stale when destroyed is 1
    constraint: cn_constraint,
    /// 0: the world
    body_a: cn_body,
    /// 0: the world
    body_b: cn_body,
    /// largest reaction of the step; 0 when a body was destroyed
    force_N: f32,
    /// the same for the torque
    torque_Nm: f32,
    /// 1: it broke, or one of its bodies was destroyed
    destroyed: u32,
    /// 0
    reserved: u32,
    /// the joint's or constraint's
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_joint_event) != 40) @compileError("cn_joint_event");
    }
};

/// Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
/// there.
pub const cn_angle_constraint_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_CONSTRAINT_*; default 0
    flags: u32,
    /// must be dynamic
    body: cn_body,
    /// lower <= upper; equal: locked
    lower_rad: f32,
    /// the upper limit
    upper_rad: f32,
    /// > 0, to 1e6; CN_DEFAULT (default): rigid
    hertz: f32,
    /// used with a hertz; 0 to 1e6
    damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
    break_torque_Nm: f32,
    /// a number for the user; default 0
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_angle_constraint_def) != 40) @compileError("cn_angle_constraint_def");
    }
};

/// Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along
/// the line.
pub const cn_line_constraint_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_CONSTRAINT_*; default 0
    flags: u32,
    /// must be dynamic
    body: cn_body,
    /// in the body's frame
    anchor_m: cn_vec2,
    /// of the line, world
    origin_m: cn_vec2,
    /// world, any length > 0 (read back with length 1); default (1, 0)
    axis: cn_vec2,
    /// >= 0: free play across the axis
    tolerance_m: f32,
    /// CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper
    lower_m: f32,
    /// the upper limit
    upper_m: f32,
    /// > 0, to 1e6; CN_DEFAULT (default): rigid
    hertz: f32,
    /// used with a hertz; 0 to 1e6
    damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
    break_force_N: f32,
    /// 0
    reserved: u32,
    /// a number for the user; default 0
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_line_constraint_def) != 72) @compileError("cn_line_constraint_def");
    }
};

/// Result of cn_world_update.
pub const cn_update_report = extern struct {
    /// fixed steps taken
    steps: i32,
    /// time kept for the next update
    leftover_s: f32,
    /// time discarded because of steps_max
    dropped_s: f32,
    /// leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated
    interpolation: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_update_report) != 16) @compileError("cn_update_report");
    }
};

/// A ray with an end.
pub const cn_ray = extern struct {
    /// world
    origin_m: cn_vec2,
    /// at most 2e6 length units each way; 0 hits only shapes around the origin
    translation_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ray) != 16) @compileError("cn_ray");
    }
};

/// What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
/// shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
/// depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it.
pub const cn_ray_hit = extern struct {
    /// 0: nothing was hit
    shape: cn_shape,
    /// the shape's
    body: cn_body,
    /// edge of a chain
    child: i32,
    /// of the translation, [0, 1]; 1 when nothing was hit
    fraction: f32,
    /// on the surface of the shape that was hit
    point_m: cn_vec2,
    /// unit, out of the shape that was hit
    normal: cn_vec2,
    /// depth of the start inside it, 0 outside
    depth_m: f32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ray_hit) != 40) @compileError("cn_ray_hit");
    }
};

/// Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
/// bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
/// steps.
pub const cn_query_filter = extern struct {
    /// default 1
    category: u64,
    /// default all ones
    mask: u64,
    /// its shapes are ignored; 0 (default): none. A stale handle is an error
    ignored_body: cn_body,
    /// CN_QUERY_IGNORE_JOINED ...; default 0
    flags: u32,
    /// NULL (default): take all shapes
    visit: ?*const cn_query_fn,
    /// last argument of visit
    user: ?*anyopaque,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_query_filter) != 40) @compileError("cn_query_filter");
    }
};

/// The shape nearest to a point.
pub const cn_closest = extern struct {
    /// 0: nothing within the distance
    shape: cn_shape,
    /// the shape's
    body: cn_body,
    /// edge of a chain
    child: i32,
    /// negative: depth inside a shape with area
    distance_m: f32,
    /// on the surface
    point_m: cn_vec2,
    /// outward there; of edges and chains towards the point
    normal: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_closest) != 32) @compileError("cn_closest");
    }
};

/// Distance of two shapes.
pub const cn_distance = extern struct {
    /// on the surface of a, in the world
    point_a_m: cn_vec2,
    /// on the surface of b
    point_b_m: cn_vec2,
    /// unit, from a to b
    normal: cn_vec2,
    /// of the surfaces; negative: the depth, the shortest translation of b out of a
    distance_m: f32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_distance) != 32) @compileError("cn_distance");
    }
};

/// A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about it
/// at a constant rate.
pub const cn_sweep = extern struct {
    /// of the shape, before the motion
    start: cn_pose,
    /// that point, in the shape's frame: the centre of mass of a body
    center_m: cn_vec2,
    /// of it; at most 2e6 m each way
    translation_m: cn_vec2,
    /// counter-clockwise, |turn| <= 1e4
    turn_rad: f32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_sweep) != 40) @compileError("cn_sweep");
    }
};

/// Result of cn_polygon_time_of_impact.
pub const cn_impact = extern struct {
    /// CN_IMPACT_*
    state: i32,
    /// of both motions, [0, 1]
    fraction: f32,
    /// HIT only, as are the next two: between the surfaces
    point_m: cn_vec2,
    /// unit, from a to b
    normal: cn_vec2,
    /// of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it
    distance_m: f32,
    /// 0
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_impact) != 32) @compileError("cn_impact");
    }
};

/// A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0, unless
/// that needs a push of more than push_max_m.
pub const cn_plane = extern struct {
    /// unit, from the surface to the shape
    normal: cn_vec2,
    /// world point of least distance
    point_m: cn_vec2,
    /// of the surfaces along the normal; negative: they overlap
    separation_m: f32,
    /// greatest push of this plane, >= 0; FLT_MAX: rigid
    push_max_m: f32,
    /// its push in the last cn_mover_solve
    push_m: f32,
    /// whose surface it is
    shape: cn_shape,
    /// the shape's
    body: cn_body,
    /// edge of a chain
    child: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_plane) != 40) @compileError("cn_plane");
    }
};

/// How a character moves. It may change between moves: crouching is another shape.
pub const cn_mover_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_MOVER_DROP; default 0
    flags: u32,
    /// around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule
    /// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
    shape: cn_polygon,
    /// shapes that it collides with; sensors never, one-way shapes from above
    filter: cn_query_filter,
    /// any length > 0; default (0, 1)
    up: cn_vec2,
    /// greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)
    slope_limit_rad: f32,
    /// greatest height of steps that it climbs, >= 0; default 0.3
    step_height_m: f32,
    /// a walking character follows ground that falls by up to this in a move, >= 0; default 0.3
    snap_m: f32,
    /// of the world's gravity in the air; default 1
    gravity_scale: f32,
    /// greatest push on a dynamic body, >= 0; default 200
    push_force_N: f32,
    /// of sliding, 1 to 64; default 8
    iterations_max: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mover_def) != 216) @compileError("cn_mover_def");
    }
};

/// State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
/// world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
/// filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
/// position.
pub const cn_mover = extern struct {
    /// of the shape's origin, world
    position_m: cn_vec2,
    /// in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as
    /// its component across up; the one along up is 0, and a jump when the caller makes it > 0
    velocity_mps: cn_vec2,
    /// of the ground with CN_MOVER_ON_GROUND, else (0, 0)
    ground_normal: cn_vec2,
    /// in the world, after the move
    ground_point_m: cn_vec2,
    /// ... in the frame of ground_body
    ground_local_m: cn_vec2,
    /// of the ground there
    ground_velocity_mps: cn_vec2,
    /// 0: none; a stale handle counts as none
    ground_body: cn_body,
    /// the same for its shape
    ground_shape: cn_shape,
    /// CN_MOVER_ON_*, after the last move
    flags: u32,
    /// overlap with surfaces that leave it no room; else 0 up to rounding
    squeezed_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mover) != 64) @compileError("cn_mover");
    }
};

/// What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity.
/// Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
/// accelerations, damping and forces add up.
pub const cn_area_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_AREA_REPLACE; default 0
    flags: u32,
    /// default 0
    priority: i32,
    /// acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)
    gravity_mps2: cn_vec2,
    /// of pull_mps2, in the frame of the sensor's body; default (0, 0)
    center_m: cn_vec2,
    /// acceleration towards center_m; negative pushes; default 0
    pull_mps2: f32,
    /// CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with
    /// its inverse square outside, and falling to 0 at the centre: a homogeneous planet
    pull_distance_m: f32,
    /// of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
    /// density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0
    linear_damping_per_s: f32,
    /// ... of the rotation; 0 to 1e9, default 0
    angular_damping_per_s: f32,
    /// of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default
    /// 0
    density_kgpm2: f32,
    /// density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0
    drag_kgpm2: f32,
    /// density times lift coefficient; 0 to 1e9, default 0
    lift_kgpm2: f32,
    /// velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)
    flow_mps: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_area_def) != 64) @compileError("cn_area_def");
    }
};

/// Definition of an explosion.
pub const cn_explosion_def = extern struct {
    /// set by the init function
    struct_size: u32,
    /// full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1
    radius_m: f32,
    /// then linearly to 0 over this distance, 0 to 1e6 length units; default 0
    falloff_m: f32,
    /// per metre of the shape's width seen from the centre; negative pulls; default 0
    impulse_Nspm: f32,
    /// world
    center_m: cn_vec2,
    /// which shapes; defaults: see cn_query_filter
    filter: cn_query_filter,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_explosion_def) != 64) @compileError("cn_explosion_def");
    }
};

/// The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
/// coordinates.
pub const cn_debug_draw = extern struct {
    /// set by the init function
    struct_size: u32,
    /// CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
    flags: u32,
    /// things outside are not drawn; default everything
    view: cn_aabb,
    /// count points, counter-clockwise
    polygon: ?*const cn_debug_draw_polygon_fn,
    /// rim_m: a point on the rim that turns with the body
    circle: ?*const cn_debug_draw_circle_fn,
    /// a disc swept from a to b
    capsule: ?*const cn_debug_draw_capsule_fn,
    /// a line from a to b
    segment: ?*const cn_debug_draw_segment_fn,
    /// size in pixels
    point: ?*const cn_debug_draw_point_fn,
    /// zero-terminated, valid during the call
    text: ?*const cn_debug_draw_text_fn,
    /// last argument of the functions
    user: ?*anyopaque,
    /// 0
    reserved: ?*anyopaque,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_debug_draw) != 88) @compileError("cn_debug_draw");
    }
};

/// Version of the library as major * 1000000 + minor * 1000 + patch.
pub extern fn cn_version() i32;
/// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
pub extern fn cn_abi_version() i32;
/// English text for a result code: static, never NULL.
pub extern fn cn_result_text(result: cn_result) [*:0]const u8;
/// sizeof the struct that a CN_TYPE_ constant names, 0 for an unknown constant; bindings check their layouts
/// with it.
pub extern fn cn_sizeof(@"type": i32) i32;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing. Defaults that scale with the
/// length unit are stored as CN_DEFAULT, which cn_world_create resolves.
pub extern fn cn_world_def_init(def: ?*cn_world_def) void;
/// Checks a definition. Writes one sentence about its first error, at most text_bytes (>= 0) bytes with the
/// terminating zero; text may be NULL when text_bytes is 0.
pub extern fn cn_world_def_check(def: *const cn_world_def, text: ?[*]u8, text_bytes: i32) cn_result;
/// Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here.
pub extern fn cn_world_bytes_needed(def: *const cn_world_def, out_bytes: *u64) cn_result;
/// Creates a world. CN_ERROR_MEMORY also when a thread cannot be started. Each worker takes about 150 bytes
/// of the world's memory; its stack comes from the system, even for a world in a caller's block. Without
/// thread support (CN_NO_THREADS, or an unknown system) the world has one worker: see
/// cn_world_get_worker_count. O(capacities).
pub extern fn cn_world_create(def: *const cn_world_def, out_world: *?*cn_world) cn_result;
/// Destroys a world, everything in it and its threads. A caller's block is free for other use afterwards.
/// NULL, and a call from a callback, do nothing. O(memory blocks).
pub extern fn cn_world_destroy(world: ?*cn_world) void;
/// Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
/// O(awake bodies and their contacts and joints).
pub extern fn cn_world_step(world: *cn_world, dt_s: f32) cn_result;
/// One sentence about the last call that failed on this world; "" if none failed or world is NULL. Valid
/// until the next failing call.
pub extern fn cn_world_error_text(world: ?*const cn_world) [*:0]const u8;
/// Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
pub extern fn cn_world_set_gravity(world: *cn_world, gravity_x_mps2: f32, gravity_y_mps2: f32) cn_result;
/// Reads gravity in m/s^2.
pub extern fn cn_world_get_gravity(world: *const cn_world, out_mps2: *cn_vec2) cn_result;
/// Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.
pub extern fn cn_world_set_substep_count(world: *cn_world, count: i32) cn_result;
/// Reads the substeps of a step.
pub extern fn cn_world_get_substep_count(world: *const cn_world, out_count: *i32) cn_result;
/// Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
/// memory of the solver it was created with; a solver that needs more works without direct solving
/// (CN_WARNING_FRAME_MEMORY).
pub extern fn cn_world_set_solver(world: *cn_world, solver: i32) cn_result;
/// Reads the solver (CN_SOLVER_*).
pub extern fn cn_world_get_solver(world: *const cn_world, out_solver: *i32) cn_result;
/// Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
pub extern fn cn_world_set_accuracy(world: *cn_world, accuracy_m: f32, work_budget: i32) cn_result;
/// Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
/// (CN_DEFAULT: none).
pub extern fn cn_world_get_accuracy(world: *const cn_world, out_accuracy_m: *f32, out_work_budget: *i32) cn_result;
/// Reads how many workers a step can use: 1, or worker_count where the library supports threads.
pub extern fn cn_world_get_worker_count(world: *const cn_world, out_count: *i32) cn_result;
/// Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
pub extern fn cn_world_set_flags(world: *cn_world, flags: u32) cn_result;
/// Reads the CN_WORLD_ flags.
pub extern fn cn_world_get_flags(world: *const cn_world, out_flags: *u32) cn_result;
/// Impacts slower than this, in m/s, do not bounce; >= 0.
pub extern fn cn_world_set_restitution_threshold(world: *cn_world, speed_mps: f32) cn_result;
/// Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
pub extern fn cn_world_set_hit_speed(world: *cn_world, speed_mps: f32) cn_result;
/// Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster bodies
/// down to them and keeps the direction.
pub extern fn cn_world_set_speed_limits(world: *cn_world, linear_mps: f32, angular_radps: f32) cn_result;
/// Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
/// they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
/// others that no joint holds and that are slower than four times the speed lose theirs within a second or
/// two: what rocks in a hollow would keep all of a heap awake.
pub extern fn cn_world_set_sleep(world: *cn_world, speed_mps: f32, delay_s: f32) cn_result;
/// Stores a number for the user.
pub extern fn cn_world_set_user_data(world: *cn_world, user_data: u64) cn_result;
/// Reads the user's number.
pub extern fn cn_world_get_user_data(world: *const cn_world, out_user_data: *u64) cn_result;
/// Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
/// capacity is 0. out_count is their number. O(slots).
pub extern fn cn_world_get_bodies(world: *const cn_world, out: ?[*]cn_body, capacity: i32, out_count: *i32) cn_result;
/// Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots).
pub extern fn cn_world_get_shapes(world: *const cn_world, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
/// cn_world_get_bodies. O(slots).
pub extern fn cn_world_get_joints(world: *const cn_world, out: ?[*]cn_joint, capacity: i32, out_count: *i32) cn_result;
/// Reads counts of objects and what the last step reported. O(bodies + islands).
pub extern fn cn_world_get_counters(world: *const cn_world, out: *cn_counters) cn_result;
/// Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in a
/// deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their number. A
/// step does no work for it. O(bodies + contacts and joints of the islands written).
pub extern fn cn_world_get_islands(world: *const cn_world, out: ?[*]cn_island_report, capacity: i32, out_count: *i32) cn_result;
/// Reads the seconds of the last step by stage.
pub extern fn cn_world_get_profile(world: *const cn_world, out: *cn_profile) cn_result;
/// Reads the memory statistics.
pub extern fn cn_world_get_memory_stats(world: *const cn_world, out: *cn_memory_stats) cn_result;
/// Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position p
/// becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes, world
/// anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and no
/// event is reported. Distances between bodies keep their digits; world anchors are rounded to floats at the
/// new place. Arrays returned before become invalid; the user moves their own points (movers, rays, cached
/// poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all pairs
/// again.
pub extern fn cn_world_shift_origin(world: *cn_world, x_m: f32, y_m: f32) cn_result;
/// 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
/// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on every
/// compiler, CPU and thread count. O(bodies + contacts + joints).
pub extern fn cn_world_hash(world: *const cn_world, out_hash: *u64) cn_result;
/// Checks every invariant between the tables. CN_ERROR_INTERNAL, and one sentence in text, for the first that
/// is broken. text holds at most text_bytes (>= 0) bytes with the zero and may be NULL when text_bytes is 0.
/// O(everything).
pub extern fn cn_world_validate(world: *const cn_world, text: ?[*]u8, text_bytes: i32) cn_result;
/// Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
pub extern fn cn_world_save_size(world: *const cn_world, out_bytes: *u64) cn_result;
/// Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
/// number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
/// about 1 KB per body.
pub extern fn cn_world_save(world: *const cn_world, out: [*]u8, capacity: u64, out_bytes: ?*u64) cn_result;
/// Restores a saved state, into the saved world or one created with the same definition (broadphase, length
/// unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT for
/// damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then (a
/// world in a caller's block has room for its own saves). Arrays returned before become invalid. Handles of
/// objects alive at the save are valid again, also of objects destroyed since; handles created since are
/// refused until the same handle is given to a new object: with the same calls to the same object. O(memory
/// of the world).
pub extern fn cn_world_restore(world: *cn_world, save: [*]const u8, bytes: u64) cn_result;
/// Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
pub extern fn cn_save_delta_size(base: [*]const u8, base_bytes: u64, save: [*]const u8, save_bytes: u64, out_bytes: *u64) cn_result;
/// Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
pub extern fn cn_save_delta(base: [*]const u8, base_bytes: u64, save: [*]const u8, save_bytes: u64, out: [*]u8, capacity: u64, out_bytes: ?*u64) cn_result;
/// Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
/// CN_ERROR_CAPACITY if out is too small. O(bytes).
pub extern fn cn_save_apply(base: [*]const u8, base_bytes: u64, delta: [*]const u8, delta_bytes: u64, out: [*]u8, capacity: u64, out_bytes: ?*u64) cn_result;
/// Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
pub extern fn cn_world_write_size(world: *const cn_world, out_bytes: *u64) cn_result;
/// Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of
/// bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB
/// per body.
pub extern fn cn_world_write(world: *const cn_world, out: [*]u8, capacity: u64, out_bytes: ?*u64) cn_result;
/// Creates a world from bytes of cn_world_write (bytes: exactly as many). def, which may be NULL for
/// defaults, gives memory, workers and capacities (which a caller's block needs); its settings are not used,
/// the file's are. CN_ERROR_FORMAT for damaged or forged bytes, CN_ERROR_MEMORY without room,
/// CN_ERROR_ARGUMENT for a definition that cn_world_create refuses. O(memory of the world).
pub extern fn cn_world_read(def: ?*const cn_world_def, file: [*]const u8, bytes: u64, out_world: *?*cn_world) cn_result;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing.
pub extern fn cn_body_def_init(def: ?*cn_body_def) void;
/// Creates a body. O(1) amortized.
pub extern fn cn_body_create(world: *cn_world, def: *const cn_body_def, out_body: *cn_body) cn_result;
/// Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
pub extern fn cn_body_create_many(world: *cn_world, defs: [*]const cn_body_def, count: i32, out_bodies: [*]cn_body) cn_result;
/// Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
/// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
/// joints + shapes).
pub extern fn cn_body_destroy(world: *cn_world, body: cn_body) cn_result;
/// Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice. O(their
/// contacts + joints + shapes).
pub extern fn cn_body_destroy_many(world: *cn_world, bodies: [*]const cn_body, count: i32) cn_result;
/// 1 if the handle names a living body of this world, else 0 (also for a NULL world).
pub extern fn cn_body_is_valid(world: ?*const cn_world, body: cn_body) i32;
/// Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
/// still overlap begin again in the next step), with its forces and any mass override; a body made static
/// stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes).
pub extern fn cn_body_set_type(world: *cn_world, body: cn_body, @"type": i32) cn_result;
/// Reads the type (CN_BODY_*).
pub extern fn cn_body_get_type(world: *const cn_world, body: cn_body, out_type: *i32) cn_result;
/// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
/// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints are
/// inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
pub extern fn cn_body_set_flags(world: *cn_world, body: cn_body, flags: u32) cn_result;
/// Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
pub extern fn cn_body_get_flags(world: *const cn_world, body: cn_body, out_flags: *u32) cn_result;
/// 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
/// bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
pub extern fn cn_body_set_awake(world: *cn_world, body: cn_body, awake: i32) cn_result;
/// Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <= 1e4).
/// Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports them. Gaps
/// of its joints close at some 15 length units a second. Wakes the body and its new and old neighbours.
/// O(contacts + joints + shapes).
pub extern fn cn_body_set_pose(world: *cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32) cn_result;
/// Reads the position of the origin and the rotation.
pub extern fn cn_body_get_pose(world: *const cn_world, body: cn_body, out: *cn_pose) cn_result;
/// Reads the position of the origin as the sum of two floats: the high part is within rounding that of
/// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double
/// is more precise; so is a difference of two bodies, taken high from high and low from low, in floats.
pub extern fn cn_body_get_position_parts(world: *const cn_world, body: cn_body, out_high_m: *cn_vec2, out_low_m: *cn_vec2) cn_result;
/// Reads the angle in radians, in (-pi, pi].
pub extern fn cn_body_get_angle(world: *const cn_world, body: cn_body, out_rad: *f32) cn_result;
/// Reads the world position of the centre of mass, in metres.
pub extern fn cn_body_get_center(world: *const cn_world, body: cn_body, out_m: *cn_vec2) cn_result;
/// Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite. CN_ERROR_STATE
/// for static bodies. Wakes the body unless all are 0.
pub extern fn cn_body_set_velocity(world: *cn_world, body: cn_body, linear_x_mps: f32, linear_y_mps: f32, angular_radps: f32) cn_result;
/// Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
pub extern fn cn_body_get_velocity(world: *const cn_world, body: cn_body, out: *cn_velocity) cn_result;
/// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it
/// to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike after
/// cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before every step,
/// or stop the body after it.
pub extern fn cn_body_set_target_pose(world: *cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32, dt_s: f32) cn_result;
/// Velocity in m/s of the body's material at a world point in metres.
pub extern fn cn_body_get_velocity_at(world: *const cn_world, body: cn_body, point_x_m: f32, point_y_m: f32, out_mps: *cn_vec2) cn_result;
/// World position of a point given in the body's frame, both in metres.
pub extern fn cn_body_get_world_point(world: *const cn_world, body: cn_body, local_x_m: f32, local_y_m: f32, out_m: *cn_vec2) cn_result;
/// Position in the body's frame of a world point, both in metres.
pub extern fn cn_body_get_local_point(world: *const cn_world, body: cn_body, world_x_m: f32, world_y_m: f32, out_m: *cn_vec2) cn_result;
/// Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
/// O(shapes).
pub extern fn cn_body_get_aabb(world: *const cn_world, body: cn_body, out: *cn_aabb) cn_result;
/// Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
/// and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.
pub extern fn cn_body_apply_force(world: *cn_world, body: cn_body, force_x_N: f32, force_y_N: f32) cn_result;
/// Adds a force in newtons at a world point in metres, hence a torque too; otherwise as cn_body_apply_force.
pub extern fn cn_body_apply_force_at(world: *cn_world, body: cn_body, force_x_N: f32, force_y_N: f32, point_x_m: f32, point_y_m: f32) cn_result;
/// Adds a torque in newton metres; otherwise as cn_body_apply_force.
pub extern fn cn_body_apply_torque(world: *cn_world, body: cn_body, torque_Nm: f32) cn_result;
/// Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
/// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity overflows.
pub extern fn cn_body_apply_impulse(world: *cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32) cn_result;
/// Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
/// otherwise as cn_body_apply_impulse.
pub extern fn cn_body_apply_impulse_at(world: *cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32, point_x_m: f32, point_y_m: f32) cn_result;
/// Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
/// cn_body_apply_impulse.
pub extern fn cn_body_apply_angular_impulse(world: *cn_world, body: cn_body, impulse_Nms: f32) cn_result;
/// Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
/// shapes have no mass weighs 1 kg; without shapes it does not rotate.
pub extern fn cn_body_get_mass_data(world: *const cn_world, body: cn_body, out: *cn_mass_data) cn_result;
/// Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
/// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes
/// the body.
pub extern fn cn_body_set_mass_data(world: *cn_world, body: cn_body, mass: *const cn_mass_data) cn_result;
/// Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
pub extern fn cn_body_reset_mass_data(world: *cn_world, body: cn_body) cn_result;
/// Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
pub extern fn cn_body_set_damping(world: *cn_world, body: cn_body, linear_per_s: f32, angular_per_s: f32) cn_result;
/// Reads the linear and angular damping in 1/s.
pub extern fn cn_body_get_damping(world: *const cn_world, body: cn_body, out_linear_per_s: *f32, out_angular_per_s: *f32) cn_result;
/// Sets the factor on gravity for this body, finite. A change wakes the body.
pub extern fn cn_body_set_gravity_scale(world: *cn_world, body: cn_body, scale: f32) cn_result;
/// Reads the factor on gravity.
pub extern fn cn_body_get_gravity_scale(world: *const cn_world, body: cn_body, out_scale: *f32) cn_result;
/// Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
pub extern fn cn_body_set_sleep_speed(world: *cn_world, body: cn_body, speed_mps: f32) cn_result;
/// Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
/// the world chooses. _SOFT: contacts and joints are never solved directly, whatever other bodies ask for.
/// _DIRECT: the island is solved directly at any speed, where its contacts permit it and within the
/// work_budget. Takes effect with the next step; does not wake.
pub extern fn cn_body_set_solver(world: *cn_world, body: cn_body, solver: i32) cn_result;
/// Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
pub extern fn cn_body_get_solver(world: *const cn_world, body: cn_body, out_solver: *i32) cn_result;
/// Stores a number for the user.
pub extern fn cn_body_set_user_data(world: *cn_world, body: cn_body, user_data: u64) cn_result;
/// Reads the user's number.
pub extern fn cn_body_get_user_data(world: *const cn_world, body: cn_body, out_user_data: *u64) cn_result;
/// Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
/// O(length).
pub extern fn cn_body_set_name(world: *cn_world, body: cn_body, name: ?[*:0]const u8) cn_result;
/// Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
pub extern fn cn_body_get_name(world: *const cn_world, body: cn_body, out_name: *?[*:0]const u8) cn_result;
/// Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).
pub extern fn cn_body_get_shapes(world: *const cn_world, body: cn_body, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Handles of the body's joints without constraints; out, capacity and *out_count as in cn_world_get_bodies.
/// O(joints).
pub extern fn cn_body_get_joints(world: *const cn_world, body: cn_body, out: ?[*]cn_joint, capacity: i32, out_count: *i32) cn_result;
/// Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
/// their number. One bad handle fails the whole call. O(count).
pub extern fn cn_world_read_poses(world: *const cn_world, bodies: ?[*]const cn_body, count: i32, out: [*]cn_pose) cn_result;
/// Reads count cn_pose at intervals of stride_bytes (0, tightly packed, or >= 16); otherwise as
/// cn_world_read_poses. O(count).
pub extern fn cn_world_read_poses_strided(world: *const cn_world, bodies: ?[*]const cn_body, count: i32, out: [*]u8, stride_bytes: i32) cn_result;
/// Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
pub extern fn cn_world_read_velocities(world: *const cn_world, bodies: ?[*]const cn_body, count: i32, out: [*]cn_velocity) cn_result;
/// Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
/// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).
pub extern fn cn_world_write_velocities(world: *cn_world, bodies: ?[*]const cn_body, count: i32, velocities: [*]const cn_velocity) cn_result;
/// Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
/// first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
pub extern fn cn_world_moved(world: *cn_world, out_moved: *?[*]const cn_body_moved, out_count: *i32) cn_result;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing.
pub extern fn cn_shape_def_init(def: ?*cn_shape_def) void;
/// Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
pub extern fn cn_shape_create_circle(world: *cn_world, def: *const cn_shape_def, circle: *const cn_circle, out_shape: ?*cn_shape) cn_result;
/// Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body. out_shape
/// may be NULL.
pub extern fn cn_shape_create_capsule(world: *cn_world, def: *const cn_shape_def, capsule: *const cn_capsule, out_shape: ?*cn_shape) cn_result;
/// Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.
pub extern fn cn_shape_create_edge(world: *cn_world, def: *const cn_shape_def, edge: *const cn_edge, out_shape: ?*cn_shape) cn_result;
/// Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
/// out_shape may be NULL.
pub extern fn cn_shape_create_polygon(world: *cn_world, def: *const cn_shape_def, polygon: *const cn_polygon, out_shape: ?*cn_shape) cn_result;
/// Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body. out_shape
/// may be NULL.
pub extern fn cn_shape_create_box(world: *cn_world, def: *const cn_shape_def, half_width_m: f32, half_height_m: f32, radius_m: f32, out_shape: ?*cn_shape) cn_result;
/// Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape may
/// be NULL. O(count).
pub extern fn cn_shape_create_chain(world: *cn_world, def: *const cn_shape_def, chain: *const cn_chain, out_shape: ?*cn_shape) cn_result;
/// Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
/// CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
pub extern fn cn_shape_attach(world: *cn_world, shape: cn_shape, body: cn_body) cn_result;
/// Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
/// O(contacts + shapes of the body).
pub extern fn cn_shape_detach(world: *cn_world, shape: cn_shape) cn_result;
/// Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
pub extern fn cn_shape_destroy(world: *cn_world, shape: cn_shape) cn_result;
/// 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
pub extern fn cn_shape_is_valid(world: ?*const cn_world, shape: cn_shape) i32;
/// Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
pub extern fn cn_shape_get_type(world: *const cn_world, shape: cn_shape, out_type: *i32) cn_result;
/// Reads the body; 0 if unattached.
pub extern fn cn_shape_get_body(world: *const cn_world, shape: cn_shape, out_body: *cn_body) cn_result;
/// Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
/// body).
pub extern fn cn_shape_set_material(world: *cn_world, shape: cn_shape, material: *const cn_material) cn_result;
/// Reads the material.
pub extern fn cn_shape_get_material(world: *const cn_world, shape: cn_shape, out: *cn_material) cn_result;
/// Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and wakes
/// the body. O(shapes of the body).
pub extern fn cn_shape_set_density(world: *cn_world, shape: cn_shape, density_kgpm2: f32) cn_result;
/// Reads the density in kg/m^2.
pub extern fn cn_shape_get_density(world: *const cn_world, shape: cn_shape, out_kgpm2: *f32) cn_result;
/// Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
/// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
pub extern fn cn_shape_set_filter(world: *cn_world, shape: cn_shape, filter: *const cn_filter) cn_result;
/// Reads the filter.
pub extern fn cn_shape_get_filter(world: *const cn_world, shape: cn_shape, out: *cn_filter) cn_result;
/// Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts of
/// the body).
pub extern fn cn_shape_set_event_mask(world: *cn_world, shape: cn_shape, event_mask: u32) cn_result;
/// Reads the event mask.
pub extern fn cn_shape_get_event_mask(world: *const cn_world, shape: cn_shape, out_event_mask: *u32) cn_result;
/// Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
/// step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
pub extern fn cn_shape_set_flags(world: *cn_world, shape: cn_shape, flags: u32) cn_result;
/// Reads the CN_SHAPE_ flags.
pub extern fn cn_shape_get_flags(world: *const cn_world, shape: cn_shape, out_flags: *u32) cn_result;
/// Stores a number for the user.
pub extern fn cn_shape_set_user_data(world: *cn_world, shape: cn_shape, user_data: u64) cn_result;
/// Reads the user's number.
pub extern fn cn_shape_get_user_data(world: *const cn_world, shape: cn_shape, out_user_data: *u64) cn_result;
/// AABB without margin, in the world (in the shape's own space when unattached). O(points).
pub extern fn cn_shape_get_aabb(world: *const cn_world, shape: cn_shape, out: *cn_aabb) cn_result;
/// Mass at the present density, centre in the body's frame, inertia about the shape's own centre. O(points).
pub extern fn cn_shape_get_mass_data(world: *const cn_world, shape: cn_shape, out: *cn_mass_data) cn_result;
/// Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
pub extern fn cn_shape_get_circle(world: *const cn_world, shape: cn_shape, out: *cn_circle) cn_result;
/// Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
pub extern fn cn_shape_get_capsule(world: *const cn_world, shape: cn_shape, out: *cn_capsule) cn_result;
/// Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
pub extern fn cn_shape_get_edge(world: *const cn_world, shape: cn_shape, out: *cn_edge) cn_result;
/// Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
pub extern fn cn_shape_get_polygon(world: *const cn_world, shape: cn_shape, out: *cn_polygon) cn_result;
/// Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
/// NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points written).
pub extern fn cn_shape_get_chain_points(world: *const cn_world, shape: cn_shape, out: ?[*]cn_vec2, capacity: i32, out_count: *i32) cn_result;
/// Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks of
/// creation: the handle and all other properties stay. Mass and box are those of the new geometry at once;
/// contacts stay unless the boxes no longer overlap, and the next step computes them anew, without the
/// impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box meets. A
/// shape that grows into others is pushed out of them at push_speed_max_mps at most. CN_ERROR_STATE for
/// another type. O(contacts + shapes of the body).
pub extern fn cn_shape_set_circle(world: *cn_world, shape: cn_shape, circle: *const cn_circle) cn_result;
/// Replaces a capsule in place; otherwise as cn_shape_set_circle.
pub extern fn cn_shape_set_capsule(world: *cn_world, shape: cn_shape, capsule: *const cn_capsule) cn_result;
/// Replaces an edge in place; otherwise as cn_shape_set_circle.
pub extern fn cn_shape_set_edge(world: *cn_world, shape: cn_shape, edge: *const cn_edge) cn_result;
/// Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.
pub extern fn cn_shape_set_polygon(world: *cn_world, shape: cn_shape, polygon: *const cn_polygon) cn_result;
/// Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
/// begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body + count).
pub extern fn cn_shape_set_chain(world: *cn_world, shape: cn_shape, chain: *const cn_chain) cn_result;
/// out_inside is 1 if the shape contains a world point in metres (in the shape's own space when unattached),
/// else 0. Edges and chains contain no point. O(points).
pub extern fn cn_shape_test_point(world: *const cn_world, shape: cn_shape, point_x_m: f32, point_y_m: f32, out_inside: *i32) cn_result;
/// Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
/// O(count^2) at worst.
pub extern fn cn_polygon_make_hull(points_m: [*]const cn_vec2, count: i32, radius_m: f32, out: *cn_polygon) cn_result;
/// A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
/// (|angle| <= 1e4); radius_m >= 0.
pub extern fn cn_polygon_make_box(half_width_m: f32, half_height_m: f32, center_x_m: f32, center_y_m: f32, angle_rad: f32, radius_m: f32, out: *cn_polygon) cn_result;
/// Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
/// thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
/// area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
/// *out_count is the number of all. 34 KB of stack. O(count^2).
pub extern fn cn_outline_decompose(points_m: [*]const cn_vec2, count: i32, length_unit_m: f32, out: ?[*]cn_polygon, capacity: i32, out_count: *i32) cn_result;
/// Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
/// points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst.
pub extern fn cn_outline_simplify(points_m: [*]const cn_vec2, count: i32, closed: i32, tolerance_m: f32, out: ?[*]cn_vec2, capacity: i32, out_count: *i32) cn_result;
/// An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
/// squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
/// column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
/// 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
/// counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
/// touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
/// (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
/// boundary of n edges.
pub extern fn cn_outline_from_cells(cells: [*]const u8, count: i32, columns: i32, origin_x_m: f32, origin_y_m: f32, cell_m: f32, outline: i32, out: ?[*]cn_vec2, capacity: i32, out_count: *i32) cn_result;
/// The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
/// least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).
pub extern fn cn_outline_from_field(values: [*]const f32, count: i32, columns: i32, threshold: f32, origin_x_m: f32, origin_y_m: f32, spacing_m: f32, outline: i32, out: ?[*]cn_vec2, capacity: i32, out_count: *i32) cn_result;
/// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call for
/// a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED inside
/// callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved apart,
/// body or shape destroyed, detached or disabled, filter or type changed). The next step reports pairs that
/// end between two steps; their handles may be stale. A sleeping pair reports nothing, and continues when it
/// wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the step, and got an
/// impulse; bodies that pass a blow on to others that already touch them, without closing, have no HIT.
/// Impulses are summed only for contacts that report ENTER (in the step in which they begin), STAY or HIT.
pub extern fn cn_world_contact_events(world: *cn_world, kind: i32, out_events: *?[*]const cn_contact_event, out_count: *i32) cn_result;
/// Sets the callback for contact events of one kind (CN_EVENT_*); NULL removes it.
pub extern fn cn_world_set_contact_callback(world: *cn_world, kind: i32, function: ?*const cn_contact_event_fn, user: ?*anyopaque) cn_result;
/// Sets the callback that decides whether two shapes may touch; NULL removes it.
pub extern fn cn_world_set_filter_callback(world: *cn_world, function: ?*const cn_filter_fn, user: ?*anyopaque) cn_result;
/// Sets the pre-solve callback; NULL removes it.
pub extern fn cn_world_set_pre_solve_callback(world: *cn_world, function: ?*const cn_pre_solve_fn, user: ?*anyopaque) cn_result;
/// Sets the callback that mixes materials; NULL removes it.
pub extern fn cn_world_set_material_mix_callback(world: *cn_world, function: ?*const cn_material_mix_fn, user: ?*anyopaque) cn_result;
/// The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
/// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
/// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or chains.
/// A pair without an awake body reports nothing until one wakes.
pub extern fn cn_world_sensor_events(world: *const cn_world, out_events: *?[*]const cn_sensor_event, out_count: *i32) cn_result;
/// The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of sensors:
/// see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the impulses of the
/// last substep. At rest their force is that of the points times substep_count (with CN_SOLVER_SEQUENTIAL 1)
/// / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0. *out_count is their number.
/// O(contacts).
pub extern fn cn_body_get_contacts(world: *const cn_world, body: cn_body, out: ?[*]cn_contact_event, capacity: i32, out_count: *i32) cn_result;
/// The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
/// cn_body_get_contacts. O(contacts of its body).
pub extern fn cn_shape_get_contacts(world: *const cn_world, shape: cn_shape, out: ?[*]cn_contact_event, capacity: i32, out_count: *i32) cn_result;
/// The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity and
/// *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of its
/// body), squared for chains.
pub extern fn cn_shape_get_visitors(world: *const cn_world, sensor: cn_shape, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
/// destroyed since are stale.
pub extern fn cn_world_fell_asleep(world: *const cn_world, out_bodies: *?[*]const cn_body, out_count: *i32) cn_result;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_revolute_def_init(def: ?*cn_revolute_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_distance_def_init(def: ?*cn_distance_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_fixed_def_init(def: ?*cn_fixed_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_prismatic_def_init(def: ?*cn_prismatic_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_wheel_def_init(def: ?*cn_wheel_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_motor_def_init(def: ?*cn_motor_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_mouse_def_init(def: ?*cn_mouse_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_gear_def_init(def: ?*cn_gear_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_pulley_def_init(def: ?*cn_pulley_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_ratchet_def_init(def: ?*cn_ratchet_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_rotary_spring_def_init(def: ?*cn_rotary_spring_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_groove_def_init(def: ?*cn_groove_def) void;
/// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_filter_joint_def_init(def: ?*cn_filter_joint_def) void;
/// Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_revolute(world: *cn_world, def: *const cn_revolute_def, out_joint: *cn_joint) cn_result;
/// Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_distance(world: *cn_world, def: *const cn_distance_def, out_joint: *cn_joint) cn_result;
/// Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_fixed(world: *cn_world, def: *const cn_fixed_def, out_joint: *cn_joint) cn_result;
/// Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
/// is dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_prismatic(world: *cn_world, def: *const cn_prismatic_def, out_joint: *cn_joint) cn_result;
/// Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_wheel(world: *cn_world, def: *const cn_wheel_def, out_joint: *cn_joint) cn_result;
/// Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_motor(world: *cn_world, def: *const cn_motor_def, out_joint: *cn_joint) cn_result;
/// Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic, or body_a is not 0. O(contacts of body_a).
pub extern fn cn_joint_create_mouse(world: *cn_world, def: *const cn_mouse_def, out_joint: *cn_joint) cn_result;
/// Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_gear(world: *cn_world, def: *const cn_gear_def, out_joint: *cn_joint) cn_result;
/// Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_pulley(world: *cn_world, def: *const cn_pulley_def, out_joint: *cn_joint) cn_result;
/// Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_ratchet(world: *cn_world, def: *const cn_ratchet_def, out_joint: *cn_joint) cn_result;
/// Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic. O(contacts of body_a).
pub extern fn cn_joint_create_rotary_spring(world: *cn_world, def: *const cn_rotary_spring_def, out_joint: *cn_joint) cn_result;
/// Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
/// dynamic, or the slot has no length. O(contacts of body_a).
pub extern fn cn_joint_create_groove(world: *cn_world, def: *const cn_groove_def, out_joint: *cn_joint) cn_result;
/// Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
/// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
/// body_a).
pub extern fn cn_joint_create_filter(world: *cn_world, def: *const cn_filter_joint_def, out_joint: *cn_joint) cn_result;
/// Destroys a joint and wakes its bodies. No event is reported.
pub extern fn cn_joint_destroy(world: *cn_world, joint: cn_joint) cn_result;
/// 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).
pub extern fn cn_joint_is_valid(world: ?*const cn_world, joint: cn_joint) i32;
/// Reads the type (CN_JOINT_REVOLUTE to _FILTER).
pub extern fn cn_joint_get_type(world: *const cn_world, joint: cn_joint, out_type: *i32) cn_result;
/// Reads both bodies; 0 stands for the world.
pub extern fn cn_joint_get_bodies(world: *const cn_world, joint: cn_joint, out_a: *cn_body, out_b: *cn_body) cn_result;
/// Reads the world positions of both anchors, in metres.
pub extern fn cn_joint_get_anchors(world: *const cn_world, joint: cn_joint, out_world_a_m: *cn_vec2, out_world_b_m: *cn_vec2) cn_result;
/// Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0 after
/// a change of type or of CN_BODY_ENABLED of one of its bodies.
pub extern fn cn_joint_get_reaction(world: *const cn_world, joint: cn_joint, out_force_N: *cn_vec2, out_torque_Nm: *f32) cn_result;
/// Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
/// (angles beyond limits).
pub extern fn cn_joint_get_error(world: *const cn_world, joint: cn_joint, out_m: *f32, out_rad: *f32) cn_result;
/// Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
/// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
/// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a
/// world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
/// does not wake.
pub extern fn cn_joint_set_solver(world: *cn_world, joint: cn_joint, solver: i32) cn_result;
/// Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
pub extern fn cn_joint_get_solver(world: *const cn_world, joint: cn_joint, out_solver: *i32) cn_result;
/// Stores a number for the user.
pub extern fn cn_joint_set_user_data(world: *cn_world, joint: cn_joint, user_data: u64) cn_result;
/// Reads the user's number.
pub extern fn cn_joint_get_user_data(world: *const cn_world, joint: cn_joint, out_user_data: *u64) cn_result;
/// Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
pub extern fn cn_joint_set_flags(world: *cn_world, joint: cn_joint, flags: u32) cn_result;
/// Reads the CN_JOINT_ flags.
pub extern fn cn_joint_get_flags(world: *const cn_world, joint: cn_joint, out_flags: *u32) cn_result;
/// Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_revolute(world: *const cn_world, joint: cn_joint, out: *cn_revolute_def) cn_result;
/// Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_revolute(world: *cn_world, joint: cn_joint, def: *const cn_revolute_def) cn_result;
/// Reads the definition of a distance joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_distance(world: *const cn_world, joint: cn_joint, out: *cn_distance_def) cn_result;
/// Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_distance(world: *cn_world, joint: cn_joint, def: *const cn_distance_def) cn_result;
/// Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_fixed(world: *const cn_world, joint: cn_joint, out: *cn_fixed_def) cn_result;
/// Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_fixed(world: *cn_world, joint: cn_joint, def: *const cn_fixed_def) cn_result;
/// Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_prismatic(world: *const cn_world, joint: cn_joint, out: *cn_prismatic_def) cn_result;
/// Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_prismatic(world: *cn_world, joint: cn_joint, def: *const cn_prismatic_def) cn_result;
/// Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_wheel(world: *const cn_world, joint: cn_joint, out: *cn_wheel_def) cn_result;
/// Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_wheel(world: *cn_world, joint: cn_joint, def: *const cn_wheel_def) cn_result;
/// Reads the definition of a motor joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_motor_to(world: *const cn_world, joint: cn_joint, out: *cn_motor_def) cn_result;
/// Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_motor_to(world: *cn_world, joint: cn_joint, def: *const cn_motor_def) cn_result;
/// Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_mouse(world: *const cn_world, joint: cn_joint, out: *cn_mouse_def) cn_result;
/// Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
/// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
/// CN_JOINT_COLLIDE changes.
pub extern fn cn_joint_set_mouse(world: *cn_world, joint: cn_joint, def: *const cn_mouse_def) cn_result;
/// Reads the definition of a gear joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_gear(world: *const cn_world, joint: cn_joint, out: *cn_gear_def) cn_result;
/// Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
/// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
/// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
pub extern fn cn_joint_set_gear(world: *cn_world, joint: cn_joint, def: *const cn_gear_def) cn_result;
/// Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_pulley(world: *const cn_world, joint: cn_joint, out: *cn_pulley_def) cn_result;
/// Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_pulley(world: *cn_world, joint: cn_joint, def: *const cn_pulley_def) cn_result;
/// Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_ratchet(world: *const cn_world, joint: cn_joint, out: *cn_ratchet_def) cn_result;
/// Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
/// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
/// bodies. O(contacts) when CN_JOINT_COLLIDE changes.
pub extern fn cn_joint_set_ratchet(world: *cn_world, joint: cn_joint, def: *const cn_ratchet_def) cn_result;
/// Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_rotary_spring(world: *const cn_world, joint: cn_joint, out: *cn_rotary_spring_def) cn_result;
/// Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_rotary_spring(world: *cn_world, joint: cn_joint, def: *const cn_rotary_spring_def) cn_result;
/// Reads the definition of a groove joint. CN_ERROR_STATE for another type.
pub extern fn cn_joint_get_groove(world: *const cn_world, joint: cn_joint, out: *cn_groove_def) cn_result;
/// Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
/// changes.
pub extern fn cn_joint_set_groove(world: *cn_world, joint: cn_joint, def: *const cn_groove_def) cn_result;
/// Reads the base of a joint of any type.
pub extern fn cn_joint_get_base(world: *const cn_world, joint: cn_joint, out: *cn_joint_base) cn_result;
/// Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
/// in cn_joint_base. Wakes both bodies.
pub extern fn cn_joint_set_base(world: *cn_world, joint: cn_joint, base: *const cn_joint_base) cn_result;
/// Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
/// for another type. Wakes the body.
pub extern fn cn_joint_set_target(world: *cn_world, joint: cn_joint, target_x_m: f32, target_y_m: f32) cn_result;
/// Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
/// reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
/// along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary
/// spring: angle b - angle a; these three over whole turns.
pub extern fn cn_joint_get_position(world: *const cn_world, joint: cn_joint, out_position: *f32) cn_result;
/// Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A positive
/// motor speed has the same sign.
pub extern fn cn_joint_get_speed(world: *const cn_world, joint: cn_joint, out_speed: *f32) cn_result;
/// Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
/// prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
pub extern fn cn_joint_set_motor(world: *cn_world, joint: cn_joint, speed: f32, force_or_torque_max: f32) cn_result;
/// Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0), prismatic
/// or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
pub extern fn cn_joint_set_limits(world: *cn_world, joint: cn_joint, lower: f32, upper: f32) cn_result;
/// Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
/// in that step or between it and the step before.
pub extern fn cn_world_joint_events(world: *const cn_world, out_events: *?[*]const cn_joint_event, out_count: *i32) cn_result;
/// Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_angle_constraint_def_init(def: ?*cn_angle_constraint_def) void;
/// Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
pub extern fn cn_line_constraint_def_init(def: ?*cn_line_constraint_def) void;
/// Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
/// dynamic. Wakes the body.
pub extern fn cn_constraint_create_angle(world: *cn_world, def: *const cn_angle_constraint_def, out_constraint: *cn_constraint) cn_result;
/// Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
/// dynamic. Wakes the body.
pub extern fn cn_constraint_create_line(world: *cn_world, def: *const cn_line_constraint_def, out_constraint: *cn_constraint) cn_result;
/// Destroys a constraint and wakes its body. No event is reported.
pub extern fn cn_constraint_destroy(world: *cn_world, constraint: cn_constraint) cn_result;
/// 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).
pub extern fn cn_constraint_is_valid(world: ?*const cn_world, constraint: cn_constraint) i32;
/// Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
pub extern fn cn_constraint_get_type(world: *const cn_world, constraint: cn_constraint, out_type: *i32) cn_result;
/// Reads the body.
pub extern fn cn_constraint_get_body(world: *const cn_world, constraint: cn_constraint, out_body: *cn_body) cn_result;
/// Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
pub extern fn cn_constraint_get_angle(world: *const cn_world, constraint: cn_constraint, out: *cn_angle_constraint_def) cn_result;
/// Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
/// body.
pub extern fn cn_constraint_set_angle(world: *cn_world, constraint: cn_constraint, def: *const cn_angle_constraint_def) cn_result;
/// Reads the definition of a line constraint. CN_ERROR_STATE for another type.
pub extern fn cn_constraint_get_line(world: *const cn_world, constraint: cn_constraint, out: *cn_line_constraint_def) cn_result;
/// Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
/// body.
pub extern fn cn_constraint_set_line(world: *cn_world, constraint: cn_constraint, def: *const cn_line_constraint_def) cn_result;
/// Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
/// along the axis, in metres from origin.
pub extern fn cn_constraint_get_position(world: *const cn_world, constraint: cn_constraint, out_position: *f32) cn_result;
/// Force in newtons and torque in newton metres that the constraint applied to the body in the last substep.
pub extern fn cn_constraint_get_reaction(world: *const cn_world, constraint: cn_constraint, out_force_N: *cn_vec2, out_torque_Nm: *f32) cn_result;
/// Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle constraint.
pub extern fn cn_constraint_get_error(world: *const cn_world, constraint: cn_constraint, out_m: *f32, out_rad: *f32) cn_result;
/// Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
/// O(slots).
pub extern fn cn_world_get_constraints(world: *const cn_world, out: ?[*]cn_constraint, capacity: i32, out_count: *i32) cn_result;
/// Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
/// constraints of the body).
pub extern fn cn_body_get_constraints(world: *const cn_world, body: cn_body, out: ?[*]cn_constraint, capacity: i32, out_count: *i32) cn_result;
/// Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an update,
/// 1 to 1000, default 8.
pub extern fn cn_world_set_fixed_step(world: *cn_world, step_s: f32, steps_max: i32) cn_result;
/// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
/// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
pub extern fn cn_world_update(world: *cn_world, elapsed_s: f32, out: ?*cn_update_report) cn_result;
/// Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step, 1
/// after it. Bodies that did not take part in the last step have their present pose. bodies and count as in
/// cn_world_read_poses. O(count).
pub extern fn cn_world_read_poses_interpolated(world: *const cn_world, bodies: ?[*]const cn_body, count: i32, factor: f32, out: [*]cn_pose) cn_result;
/// Sets the defaults given beside the fields. NULL does nothing.
pub extern fn cn_query_filter_init(filter: ?*cn_query_filter) void;
/// Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from their
/// front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter may be
/// NULL: the defaults. O(log shapes) to O(shapes along the ray).
pub extern fn cn_world_cast_ray(world: *const cn_world, ray: *const cn_ray, filter: ?*const cn_query_filter, out: *cn_ray_hit) cn_result;
/// out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
/// shapes) to O(shapes along the ray).
pub extern fn cn_world_cast_ray_any(world: *const cn_world, ray: *const cn_ray, filter: ?*const cn_query_filter, out_hit: *i32) cn_result;
/// Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found. A
/// chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
pub extern fn cn_world_cast_ray_all(world: *const cn_world, ray: *const cn_ray, filter: ?*const cn_query_filter, out: ?[*]cn_ray_hit, capacity: i32, out_count: *i32) cn_result;
/// Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call. filter
/// may be NULL. O(sum of the rays).
pub extern fn cn_world_cast_rays(world: *const cn_world, rays: [*]const cn_ray, count: i32, filter: ?*const cn_query_filter, out: [*]cn_ray_hit) cn_result;
/// Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
/// O(points of the shape).
pub extern fn cn_shape_cast_ray(world: *const cn_world, shape: cn_shape, ray: *const cn_ray, out: *cn_ray_hit) cn_result;
/// First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
/// way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or 2:
/// circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the moving
/// points is in front of it. filter may be NULL. O(shapes along the way).
pub extern fn cn_world_cast_shape(world: *const cn_world, shape: *const cn_polygon, translation_x_m: f32, translation_y_m: f32, filter: ?*const cn_query_filter, out: *cn_ray_hit) cn_result;
/// Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
/// cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
/// filter may be NULL. O(log shapes) to O(boxes in the region).
pub extern fn cn_world_overlap_aabb(world: *const cn_world, box: *const cn_aabb, filter: ?*const cn_query_filter, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges
/// and chains are lines here, seen from both sides.
pub extern fn cn_world_overlap_circle(world: *const cn_world, circle: *const cn_circle, filter: ?*const cn_query_filter, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as in
/// cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
pub extern fn cn_world_overlap_polygon(world: *const cn_world, polygon: *const cn_polygon, filter: ?*const cn_query_filter, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Shapes that contain a world point in metres; order, capacity, filter and cost as in cn_world_overlap_aabb.
/// Edges and chains contain no point.
pub extern fn cn_world_overlap_point(world: *const cn_world, x_m: f32, y_m: f32, filter: ?*const cn_query_filter, out: ?[*]cn_shape, capacity: i32, out_count: *i32) cn_result;
/// Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
/// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
pub extern fn cn_world_closest_point(world: *const cn_world, x_m: f32, y_m: f32, distance_max_m: f32, filter: ?*const cn_query_filter, out: *cn_closest) cn_result;
/// Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).
pub extern fn cn_polygon_distance(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, out: *cn_distance) cn_result;
/// Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
/// as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
pub extern fn cn_polygon_cast(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, translation_x_m: f32, translation_y_m: f32, out: *cn_ray_hit, out_hit: *i32) cn_result;
/// Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
/// to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
/// O(points).
pub extern fn cn_polygon_collide(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, margin_m: f32, out: *cn_manifold) cn_result;
/// First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
/// hit. Needs no world; runs in any thread.
pub extern fn cn_polygon_time_of_impact(a: *const cn_polygon, sweep_a: *const cn_sweep, b: *const cn_polygon, sweep_b: *const cn_sweep, distance_m: f32, out: *cn_impact) cn_result;
/// Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
/// by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least
/// separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way
/// shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the length unit plus
/// its rise in the last step. Shapes wholly behind the plane of another shape are left out, so that seams of
/// tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared).
pub extern fn cn_mover_collide(world: *const cn_world, shape: *const cn_polygon, position_x_m: f32, position_y_m: f32, margin_m: f32, filter: ?*const cn_query_filter, out: ?[*]cn_plane, capacity: i32, out_count: *i32) cn_result;
/// The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
/// of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
/// limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.
pub extern fn cn_mover_solve(planes: [*]cn_plane, count: i32, translation_x_m: f32, translation_y_m: f32, out_translation_m: *cn_vec2, out_overlap_m: *f32) cn_result;
/// The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
/// cn_mover_solve. Needs no world. O(count^2).
pub extern fn cn_mover_clip(planes: [*]const cn_plane, count: i32, velocity_x_mps: f32, velocity_y_mps: f32, out_mps: *cn_vec2) cn_result;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing.
pub extern fn cn_mover_def_init(def: ?*cn_mover_def) void;
/// Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step behind
/// the ground that carries it. 1. carried   by the motion of its ground since the last move: of the point of
/// ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up, along the
/// ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A step up where a
/// too steep surface blocks it: up by step_height_m, forward, down on walkable ground flying    in the air:
/// velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep ground_velocity_mps 3.
/// sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes
/// through a wall 4. pushing   dynamic bodies in the way get a force for the next step that brings them to
/// the character's velocity, of at most push_force_N each 5. ground    ground that it touches, or that lies
/// within snap_m below a walking character; velocity_mps loses blocked components The result depends on the
/// world, def and mover alone: equal calls give equal bits. The loop of planes, solver and cast is that of
/// Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies wake; nothing else in the world
/// changes. O(shapes nearby x iterations_max): about 1 us standing, 3 us walking, 10 us against a wall.
pub extern fn cn_mover_move(world: *cn_world, def: *const cn_mover_def, dt_s: f32, mover: *cn_mover) cn_result;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing.
pub extern fn cn_area_def_init(def: ?*cn_area_def) void;
/// Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says
/// which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area that
/// loses the flag later does nothing while it is without. Gravity, and damping without density, act on bodies
/// whose centre of mass is in the area (on its border too) while one of their shapes touches it: on a body
/// half in it in full or not at all. The medium acts on the part of each shape that is in the area, exactly
/// for polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The surface of a
/// circle or capsule is flat across a body, as of a planet. Shapes of a body do not shade each other. The
/// area's body feels no reaction. Between steps nothing happens: the acceleration is that in the middle of
/// the next step (leapfrog), so bodies on orbits and floating bodies keep their energy. Damping and drag are
/// implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies that enter or
/// leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may sleep. Areas
/// are in saves and files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a second) are
/// damped, and carry less under a load. An area takes 64 bytes of the world's memory; a step takes about 0.15
/// us for each shape in an area, 0.35 us in a medium. Best on a body of its own: O(contacts of the body).
pub extern fn cn_shape_set_area(world: *cn_world, shape: cn_shape, def: ?*const cn_area_def) cn_result;
/// Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
pub extern fn cn_shape_get_area(world: *const cn_world, shape: cn_shape, out: *cn_area_def) cn_result;
/// The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step.
/// flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w across it,
/// with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton (1687), and
/// across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between surface and
/// flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline, round
/// parts included, and drag along straight edges also for turning bodies; edges and chains are plates with
/// two sides. Solved implicitly, so that wind never reverses the motion relative to it, at any speed, mass
/// and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay asleep and
/// unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a shape
/// without a body. O(points).
pub extern fn cn_shape_apply_wind(world: *cn_world, shape: cn_shape, flow_x_mps: f32, flow_y_mps: f32, drag_kgpm2: f32, lift_kgpm2: f32, dt_s: f32, wake: i32) cn_result;
/// Sets struct_size and the defaults given beside the fields. NULL does nothing.
pub extern fn cn_explosion_def_init(def: ?*cn_explosion_def) void;
/// Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes them.
/// CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
pub extern fn cn_world_explode(world: *cn_world, def: *const cn_explosion_def) cn_result;
/// Sets struct_size and the defaults given beside the fields, every function to NULL. NULL does nothing.
pub extern fn cn_debug_draw_init(draw: ?*cn_debug_draw) void;
/// Draws the world through the given functions, in the calling thread. Reads only. O(bodies + shapes +
/// contacts + joints).
pub extern fn cn_world_draw(world: *const cn_world, draw: *const cn_debug_draw) cn_result;
/// Creates a dynamic AABB tree; margin_m >= 0 is added around every box. alloc and free: both NULL for
/// malloc, or both set.
pub extern fn cn_tree_create(margin_m: f32, alloc: ?*const cn_alloc_fn, free: ?*const cn_free_fn, allocator_user: ?*anyopaque, out_tree: *?*cn_tree) cn_result;
/// Destroys a tree. NULL does nothing.
pub extern fn cn_tree_destroy(tree: ?*cn_tree) void;
/// Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
pub extern fn cn_tree_insert(tree: *cn_tree, box: *const cn_aabb, user_data: u64, out_item: *u32) cn_result;
/// Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
pub extern fn cn_tree_remove(tree: *cn_tree, item: u32) cn_result;
/// Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
/// CN_ERROR_HANDLE for a stale item.
pub extern fn cn_tree_move(tree: *cn_tree, item: u32, box: *const cn_aabb) cn_result;
/// Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
pub extern fn cn_tree_get_box(tree: *const cn_tree, item: u32, out: *cn_aabb) cn_result;
/// Calls visit for every item whose box with margin overlaps box, until visit returns 0. visit must not
/// change the tree. O(log n + items visited).
pub extern fn cn_tree_query(tree: *const cn_tree, box: *const cn_aabb, visit: *const cn_tree_query_fn, user: ?*anyopaque) cn_result;
/// Calls visit for items whose box with margin a ray crosses; visit shortens or stops the ray by its result
/// and must not change the tree. O(log n + items visited).
pub extern fn cn_tree_cast_ray(tree: *const cn_tree, ray: *const cn_ray, visit: *const cn_tree_ray_fn, user: ?*anyopaque) cn_result;
/// Reads the number of items and the height of the tree.
pub extern fn cn_tree_get_stats(tree: *const cn_tree, out_count: *i32, out_height: *i32) cn_result;

/// A library of another version would read other structs: call this once before anything else.
pub fn check() error{WrongLibrary}!void {
    if (cn_abi_version() != CN_ABI_VERSION) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_VEC2) != @sizeOf(cn_vec2)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_POSE) != @sizeOf(cn_pose)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_VELOCITY) != @sizeOf(cn_velocity)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_AABB) != @sizeOf(cn_aabb)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MASS_DATA) != @sizeOf(cn_mass_data)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_WORLD_DEF) != @sizeOf(cn_world_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_COUNTERS) != @sizeOf(cn_counters)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_ISLAND_REPORT) != @sizeOf(cn_island_report)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_PROFILE) != @sizeOf(cn_profile)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MEMORY_STATS) != @sizeOf(cn_memory_stats)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_BODY_DEF) != @sizeOf(cn_body_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_BODY_MOVED) != @sizeOf(cn_body_moved)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_FILTER) != @sizeOf(cn_filter)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MATERIAL) != @sizeOf(cn_material)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_SHAPE_DEF) != @sizeOf(cn_shape_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_CIRCLE) != @sizeOf(cn_circle)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_CAPSULE) != @sizeOf(cn_capsule)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_EDGE) != @sizeOf(cn_edge)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_POLYGON) != @sizeOf(cn_polygon)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_CHAIN) != @sizeOf(cn_chain)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MANIFOLD_POINT) != @sizeOf(cn_manifold_point)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MANIFOLD) != @sizeOf(cn_manifold)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_CONTACT_EVENT) != @sizeOf(cn_contact_event)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_SENSOR_EVENT) != @sizeOf(cn_sensor_event)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_JOINT_BASE) != @sizeOf(cn_joint_base)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_REVOLUTE_DEF) != @sizeOf(cn_revolute_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_DISTANCE_DEF) != @sizeOf(cn_distance_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_FIXED_DEF) != @sizeOf(cn_fixed_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_PRISMATIC_DEF) != @sizeOf(cn_prismatic_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_WHEEL_DEF) != @sizeOf(cn_wheel_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MOTOR_DEF) != @sizeOf(cn_motor_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MOUSE_DEF) != @sizeOf(cn_mouse_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_GEAR_DEF) != @sizeOf(cn_gear_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_PULLEY_DEF) != @sizeOf(cn_pulley_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_RATCHET_DEF) != @sizeOf(cn_ratchet_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_ROTARY_SPRING_DEF) != @sizeOf(cn_rotary_spring_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_GROOVE_DEF) != @sizeOf(cn_groove_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_FILTER_JOINT_DEF) != @sizeOf(cn_filter_joint_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_JOINT_EVENT) != @sizeOf(cn_joint_event)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_ANGLE_CONSTRAINT_DEF) != @sizeOf(cn_angle_constraint_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_LINE_CONSTRAINT_DEF) != @sizeOf(cn_line_constraint_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_UPDATE_REPORT) != @sizeOf(cn_update_report)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_RAY) != @sizeOf(cn_ray)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_RAY_HIT) != @sizeOf(cn_ray_hit)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_QUERY_FILTER) != @sizeOf(cn_query_filter)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_CLOSEST) != @sizeOf(cn_closest)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_DISTANCE) != @sizeOf(cn_distance)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_SWEEP) != @sizeOf(cn_sweep)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_IMPACT) != @sizeOf(cn_impact)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_PLANE) != @sizeOf(cn_plane)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MOVER_DEF) != @sizeOf(cn_mover_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_MOVER) != @sizeOf(cn_mover)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_AREA_DEF) != @sizeOf(cn_area_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_EXPLOSION_DEF) != @sizeOf(cn_explosion_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_DEBUG_DRAW) != @sizeOf(cn_debug_draw)) return error.WrongLibrary;
}
