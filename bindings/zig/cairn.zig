//! Cairn for Zig, one to one with cairn.h.
//! Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//!
//!     const cn = @import("cairn");
//!     var def: cn.cn_world_def = undefined;
//!     cn.cn_world_def_init(&def);
//!     var world: ?*cn.cn_world = null;
//!     if (cn.cn_world_create(&def, &world) != cn.CN_OK) return error.Cairn;

pub const CN_VERSION_MAJOR = 0;
pub const CN_VERSION_MINOR = 1;
pub const CN_VERSION_PATCH = 0;
/// Raised whenever a struct layout or a function signature changes.
pub const CN_ABI_VERSION = 2;
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
/// the object is in a state in which this makes no sense
pub const CN_ERROR_STATE = -6;
/// cn_world_validate found a broken invariant: a bug in Cairn
pub const CN_ERROR_INTERNAL = -7;
pub const CN_ERROR_FORMAT = -8;

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
pub const CN_TYPE_COUNT = 54;

/// islands at rest fall asleep (default on)
pub const CN_WORLD_SLEEP = 1;
/// start solving from the last step's impulses (default on)
pub const CN_WORLD_WARM_START = 2;
/// measure cn_profile (default off: reading a clock costs time)
pub const CN_WORLD_PROFILE = 4;
pub const CN_WORLD_CONTINUOUS = 8;

/// soft constraints with substeps; directly solved where that is worth its cost
pub const CN_SOLVER_AUTO = 0;
/// soft contact and joint constraints with substeps alone (Catto, Solver2D, 2024)
pub const CN_SOLVER_SOFT = 1;
/// directly solved wherever it can be, whatever it costs: all joints, all piles without joints
pub const CN_SOLVER_DIRECT = 2;
pub const CN_SOLVER_SEQUENTIAL = 3;

/// tiled sweep-and-prune
pub const CN_BROADPHASE_SWEEP = 0;
pub const CN_BROADPHASE_TREE = 1;

/// new contacts were not added: pairs_not_added
pub const CN_WARNING_CONTACT_MEMORY = 1;
/// the step worked around missing scratch memory
pub const CN_WARNING_FRAME_MEMORY = 2;
pub const CN_WARNING_EVENT_MEMORY = 4;

// How an island is solved. Joints of either may be solved together with their neighbours.
/// contacts by soft constraints
pub const CN_TIER_SOFT = 0;
/// contacts and joints in one system, exactly
pub const CN_TIER_DIRECT = 1;
pub const CN_TIER_FREE = 2;

// Why.
/// nothing is wrong
pub const CN_TIER_REASON_NONE = 0;
/// direct: nothing is wrong any more, but not yet for long enough
pub const CN_TIER_REASON_SETTLING = 1;
/// direct: a contact began to bear where much is borne or things lean
pub const CN_TIER_REASON_NEW_CONTACT = 2;
/// direct: an overlap that the accuracy does not allow
pub const CN_TIER_REASON_OVERLAP = 3;
/// no longer given
pub const CN_TIER_REASON_JOINT = 4;
/// direct: something bears so many times its weight that soft contacts would give way
pub const CN_TIER_REASON_STRESSED = 5;
/// the world's solver is not CN_SOLVER_AUTO
pub const CN_TIER_REASON_SOLVER = 6;
/// a body's own solver: cn_body_set_solver
pub const CN_TIER_REASON_OVERRIDE = 7;
/// soft: a single body
pub const CN_TIER_REASON_ALONE = 8;
/// soft: something is wrong, but it moves too fast
pub const CN_TIER_REASON_MOVING = 9;
/// soft: something is wrong, but it or the sum of such islands is too large
pub const CN_TIER_REASON_CROWDED = 10;
/// soft for a time: its system is beyond the limit of work or the work_budget
pub const CN_TIER_REASON_WORK = 11;
/// soft for a time: restitution, a conveyor, rolling resistance or a locked axis
pub const CN_TIER_REASON_KIND = 12;
/// soft for a time: no solution was found for its contacts; it stays awake while it moves at all
pub const CN_TIER_REASON_NO_SET = 13;
/// soft: no scratch memory (CN_WARNING_FRAME_MEMORY)
pub const CN_TIER_REASON_MEMORY = 14;
pub const CN_TIER_REASON_JOINTED = 15;

/// never moves, infinite mass
pub const CN_BODY_STATIC = 0;
/// moves by its velocity alone, infinite mass
pub const CN_BODY_KINEMATIC = 1;
pub const CN_BODY_DYNAMIC = 2;

/// the centre of mass keeps its world x
pub const CN_BODY_LOCK_X = 1;
pub const CN_BODY_LOCK_Y = 2;
pub const CN_BODY_LOCK_ROTATION = 4;
/// continuous collision against dynamic bodies too (stored)
pub const CN_BODY_BULLET = 8;
/// takes part in the simulation (default on)
pub const CN_BODY_ENABLED = 16;
/// may fall asleep (default on)
pub const CN_BODY_SLEEP = 32;
pub const CN_BODY_AWAKE = 64;

pub const CN_SHAPE_CIRCLE = 0;
pub const CN_SHAPE_CAPSULE = 1;
pub const CN_SHAPE_POLYGON = 2;
pub const CN_SHAPE_EDGE = 3;
pub const CN_SHAPE_CHAIN = 4;

// How two materials' numbers become a pair's. When the two ask for different rules, the later one of this
// list is taken.
pub const CN_MIX_AVERAGE = 0;
/// square root of the product; default for friction
pub const CN_MIX_GEOMETRIC = 1;
pub const CN_MIX_MINIMUM = 2;
pub const CN_MIX_MULTIPLY = 3;
pub const CN_MIX_MAXIMUM = 4;

/// reports who enters and leaves and touches nothing; see cn_world_sensor_events
pub const CN_SHAPE_SENSOR = 1;
/// queries see this sensor (default: they do not)
pub const CN_SHAPE_SENSOR_SEEN = 2;
/// collides only with what comes from the side its local +y axis points to
pub const CN_SHAPE_ONE_WAY = 4;
pub const CN_SHAPE_PRE_SOLVE = 8;

/// the fat boxes of two shapes began to overlap
pub const CN_EVENT_CREATED = 0;
/// they began to touch
pub const CN_EVENT_ENTER = 1;
/// they still touch
pub const CN_EVENT_STAY = 2;
/// they stopped touching, or one went away
pub const CN_EVENT_LEAVE = 3;
/// the fat boxes no longer overlap, or one went away
pub const CN_EVENT_DESTROYED = 4;
pub const CN_EVENT_KINDS = 5;

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

/// the connected bodies' shapes collide with each other (default off)
pub const CN_JOINT_COLLIDE = 1;
pub const CN_JOINT_LIMIT = 2;
pub const CN_JOINT_MOTOR = 4;
pub const CN_JOINT_SPRING = 8;
pub const CN_JOINT_BREAKS = 16;

pub const CN_CONSTRAINT_ANGLE = 0;
pub const CN_CONSTRAINT_LINE = 1;

/// line: the limits along the axis hold
pub const CN_CONSTRAINT_LIMIT = 1;
pub const CN_CONSTRAINT_BREAKS = 2;

/// the shape is not there
pub const CN_QUERY_SKIP = 0;
pub const CN_QUERY_TAKE = 1;
pub const CN_QUERY_STOP = 2;

/// bodies that a joint connects to ignored_body are not seen either
pub const CN_QUERY_IGNORE_JOINED = 1;
/// casts meet one-way shapes from their upper side (45 degrees) only, and not those that they start in by
/// more than 0.5% of the length unit; all other queries do not see one-way shapes. Default: they are like
/// others
pub const CN_QUERY_ONE_WAY = 2;
pub const CN_QUERY_LEAVING = 4;

/// they never come so near; fraction is 1
pub const CN_IMPACT_NONE = 0;
pub const CN_IMPACT_HIT = 1;
/// the shapes without their radii overlap at the start: fraction 0, no normal
pub const CN_IMPACT_OVERLAP = 2;
pub const CN_IMPACT_FAILED = 3;

pub const CN_MOVER_DROP = 1;

pub const CN_MOVER_ON_GROUND = 1;
/// touches what is too steep to walk on
pub const CN_MOVER_ON_WALL = 2;
pub const CN_MOVER_ON_CEILING = 4;

pub const CN_DRAW_SHAPES = 1;
/// and constraints: anchors, axes, limits
pub const CN_DRAW_JOINTS = 2;
pub const CN_DRAW_CONTACTS = 4;
pub const CN_DRAW_AABBS = 8;
pub const CN_DRAW_CENTERS = 16;
pub const CN_DRAW_ISLANDS = 32;

pub const cn_result = i32;
pub const cn_body = enum(u32) { none = 0, _ };
pub const cn_shape = enum(u32) { none = 0, _ };
pub const cn_joint = enum(u32) { none = 0, _ };
pub const cn_constraint = enum(u32) { none = 0, _ };
pub const cn_world = opaque {};
pub const cn_tree = opaque {};

/// Memory hooks. Return NULL when there is none; align is a power of two, at most 64. Called only from inside
/// functions that take a non-const world.
pub const cn_alloc_fn = fn (bytes: u64, @"align": u32, user: ?*anyopaque) callconv(.c) ?*anyopaque;

pub const cn_free_fn = fn (memory: ?*anyopaque, bytes: u64, user: ?*anyopaque) callconv(.c) void;

/// A user's own task system, for worlds with worker_count of 2 or more; without one they start threads of
/// their own. Within cn_world_step a world that has enough to do asks for help with enqueue, works itself,
/// and then calls finish; some 3 to 10 times a step. It does not matter where tasks run, in which order, or
/// whether side by side. cn_task_fn     the library's: call it for ranges [begin, end) that cover 0 to
/// item_count - 1, each item once, on any threads. A call may last as long as the step, and may wait for
/// others that have already begun, never for one that has not. Its thread must have the floating-point mode
/// of the one that steps. cn_enqueue_fn  the user's: makes a task of item_count items (one less than
/// worker_count) in ranges of at least min_range, and returns what finish knows it by. It may also run all of
/// it at once, and must do so if it cannot keep it; NULL then says that there is nothing to finish.
/// cn_finish_fn   the user's: returns when every item of the task has run. Called once for each enqueue that
/// did not return NULL, in the thread that enqueued. It may run items itself. enqueue and finish are called
/// in the thread that steps, while no callback runs, and must not call the library.
pub const cn_task_fn = fn (begin: i32, end: i32, context: ?*anyopaque) callconv(.c) void;

pub const cn_enqueue_fn = fn (task: ?*const cn_task_fn, context: ?*anyopaque, item_count: i32, min_range: i32, user: ?*anyopaque) callconv(.c) ?*anyopaque;

pub const cn_finish_fn = fn (task: ?*anyopaque, user: ?*anyopaque) callconv(.c) void;

/// Called at the end of cn_world_step for each event of this kind, in the order of the array.
pub const cn_contact_event_fn = fn (world: ?*cn_world, event: [*c]const cn_contact_event, user: ?*anyopaque) callconv(.c) void;

/// Decides whether two shapes that pass their filters may touch: 1 yes, 0 no. Asked when their boxes begin to
/// overlap. The world is locked.
pub const cn_filter_fn = fn (world: ?*cn_world, shape_a: cn_shape, shape_b: cn_shape, user: ?*anyopaque) callconv(.c) i32;

/// Asked in every step for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE, before solving: 0
/// makes the pair pass through each other in this step. Event kind is STAY or ENTER.
pub const cn_pre_solve_fn = fn (world: ?*cn_world, contact: [*c]const cn_contact_event, user: ?*anyopaque) callconv(.c) i32;

/// Mixes two materials in place of the CN_MIX_ rules: fills *mixed, which holds what the rules gave. Asked
/// when a pair begins to touch and when a material changes.
pub const cn_material_mix_fn = fn (world: ?*cn_world, shape_a: cn_shape, shape_b: cn_shape, mixed: [*c]cn_material, user: ?*anyopaque) callconv(.c) void;

/// Asked by a query for each shape (edge of a chain) that it would find, in no particular order and perhaps
/// more than once: the answer must depend on the shape alone. hit is what is known of it: all of it in casts,
/// else shape, body and child. Returns CN_QUERY_*. May call functions that take a const world, of the same
/// world too, and no others.
pub const cn_query_fn = fn (world: ?*const cn_world, hit: [*c]const cn_ray_hit, user: ?*anyopaque) callconv(.c) i32;

pub const cn_debug_draw_polygon_fn = fn (points_m: [*c]const cn_vec2, count: i32, radius_m: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

pub const cn_debug_draw_circle_fn = fn (center_m: [*c]const cn_vec2, radius_m: f32, rim_m: [*c]const cn_vec2, color: u32, user: ?*anyopaque) callconv(.c) void;

pub const cn_debug_draw_capsule_fn = fn (a_m: [*c]const cn_vec2, b_m: [*c]const cn_vec2, radius_m: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

pub const cn_debug_draw_segment_fn = fn (a_m: [*c]const cn_vec2, b_m: [*c]const cn_vec2, color: u32, user: ?*anyopaque) callconv(.c) void;

pub const cn_debug_draw_point_fn = fn (point_m: [*c]const cn_vec2, size_px: f32, color: u32, user: ?*anyopaque) callconv(.c) void;

pub const cn_debug_draw_text_fn = fn (point_m: [*c]const cn_vec2, text: [*c]const u8, color: u32, user: ?*anyopaque) callconv(.c) void;

/// Return 0 to stop, anything else to go on.
pub const cn_tree_query_fn = fn (item: u32, user_data: u64, user: ?*anyopaque) callconv(.c) i32;

/// Return the fraction to go on with: the given one to ignore the item, 0 to stop.
pub const cn_tree_ray_fn = fn (item: u32, user_data: u64, fraction: f32, user: ?*anyopaque) callconv(.c) f32;

pub const cn_vec2 = extern struct {
    x: f32,
    y: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_vec2) != 8) @compileError("cn_vec2");
    }
};

/// Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of these can be
/// uploaded to a GPU as it is.
pub const cn_pose = extern struct {
    position_m: cn_vec2,
    cosine: f32,
    sine: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_pose) != 16) @compileError("cn_pose");
    }
};

pub const cn_velocity = extern struct {
    /// of the centre of mass
    linear_mps: cn_vec2,
    angular_radps: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_velocity) != 12) @compileError("cn_velocity");
    }
};

pub const cn_aabb = extern struct {
    lower_m: cn_vec2,
    upper_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_aabb) != 16) @compileError("cn_aabb");
    }
};

pub const cn_mass_data = extern struct {
    mass_kg: f32,
    /// about the centre of mass
    inertia_kgm2: f32,
    /// in the body's local frame
    center_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mass_data) != 16) @compileError("cn_mass_data");
    }
};

pub const cn_world_def = extern struct {
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
    /// CN_SOLVER_AUTO works towards errors below this, >= 0; default 0.005 x length unit
    accuracy_m: f32,
    /// ... but spends no more than this on direct solving in a step, in blocks (joints, contacts and the fill
    /// between them) factored, substeps included: some 10 ns each; 0 to 1e9; default 0: no bound but those of
    /// single islands
    work_budget: i32,
    /// slower impacts do not bounce, >= 0; default 1 x length unit
    restitution_threshold_mps: f32,
    /// fastest speed at which overlap is pushed apart, > 0; default 3 x length unit
    push_speed_max_mps: f32,
    /// > 0; default 400 x length unit
    linear_speed_max_mps: f32,
    /// > 0; default 400
    angular_speed_max_radps: f32,
    /// bodies slower than this may sleep, >= 0; default 0.05 x length unit
    sleep_speed_mps: f32,
    /// ... after this long, >= 0; default 0.5
    sleep_delay_s: f32,
    /// hints for a growing world, exact for a fixed one; >= 0; default 0
    body_capacity: i32,
    /// counts every edge of a chain
    shape_capacity: i32,
    contact_capacity: i32,
    /// counts constraints too
    joint_capacity: i32,
    user_data: u64,
    /// size of memory; 0: use alloc and free
    memory_bytes: u64,
    /// NULL, or one block aligned to 64 bytes that the world lives in, whole
    memory: ?*anyopaque,
    /// NULL: malloc; set both or none
    alloc: ?*const cn_alloc_fn,
    free: ?*const cn_free_fn,
    allocator_user: ?*anyopaque,
    /// NULL: threads of the world's own; set both or none
    enqueue: ?*const cn_enqueue_fn,
    finish: ?*const cn_finish_fn,
    task_user: ?*anyopaque,
    /// how many may work on a step at once, the calling thread one of them; 0 to CN_WORKERS_MAX; default 0:
    /// as 1, which starts no threads and enqueues no tasks
    worker_count: i32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_world_def) != 160) @compileError("cn_world_def");
    }
};

pub const cn_counters = extern struct {
    bodies: i32,
    /// dynamic and kinematic bodies that are simulated
    bodies_awake: i32,
    shapes: i32,
    /// boxes in the broadphase: one a shape, one an edge of a chain
    proxies: i32,
    /// pairs whose fat boxes overlap
    contacts: i32,
    contacts_awake: i32,
    /// pairs that share a manifold, asleep or awake
    contacts_touching: i32,
    /// and constraints
    joints: i32,
    joints_awake: i32,
    /// awake and asleep, of two or more bodies or one
    islands: i32,
    islands_awake: i32,
    /// groups of contacts that are solved without sharing a body
    colors_used: i32,
    /// contacts that fit no colour and are solved one by one
    overflow_contacts: i32,
    broadphase_tiles: i32,
    /// steps taken since creation, modulo 2^32
    steps: u32,
    /// What the last step could not do for want of memory; 0 when all is well. It tries again. CN_WARNING_*
    warnings: u32,
    pairs_not_added: i32,
    events_not_reported: i32,
    /// of several bodies, solved directly in the last step, contacts and all
    islands_direct: i32,
    /// planned for all that is solved directly in it, in the units of work_budget; at most 2^31 - 1
    direct_work: i32,
    /// of several bodies, left to soft constraints for a time because no solution was found:
    /// CN_TIER_REASON_NO_SET
    islands_unsolved: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_counters) != 84) @compileError("cn_counters");
    }
};

pub const cn_island_report = extern struct {
    /// one of it: of least slot
    body: cn_body,
    bodies: i32,
    /// touching
    contacts: i32,
    /// and constraints
    joints: i32,
    /// CN_TIER_*, after the last step
    tier: i32,
    /// CN_TIER_REASON_*
    reason: i32,
    /// of the world, 1 while it rests, as after the last step that took time; joints that swing freely may
    /// take more
    substeps: i32,
    /// where bodies are now: largest overlap, or gap of a rigid joint (angles times its bodies' extent);
    /// joints that may give way (stiffness_hertz, force_max_N, torque_max_Nm) do not count
    residual_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_island_report) != 32) @compileError("cn_island_report");
    }
};

/// Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.
pub const cn_profile = extern struct {
    step_s: f32,
    wake_s: f32,
    broadphase_s: f32,
    narrowphase_s: f32,
    islands_s: f32,
    prepare_s: f32,
    substeps_s: f32,
    finalize_s: f32,
    events_s: f32,
    sleep_s: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_profile) != 40) @compileError("cn_profile");
    }
};

/// Memory, in bytes. The frame arena is the stack allocator whose entries live within one step; the block
/// allocator serves small variable-size pieces from free lists of size classes.
pub const cn_memory_stats = extern struct {
    /// taken from the user's allocator or carved from the fixed block
    bytes_in_use: u64,
    bytes_peak: u64,
    /// calls of the user's alloc (or of the fixed block's) since creation
    allocator_calls: u64,
    arena_capacity: u64,
    /// most bytes in use at once since creation
    arena_peak: u64,
    /// entries that did not fit and came from the allocator, since creation
    arena_fallbacks: u64,
    /// bytes in chunks
    blocks_capacity: u64,
    blocks_in_use: u64,
    /// blocks above the largest class, served by the allocator
    blocks_large: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_memory_stats) != 72) @compileError("cn_memory_stats");
    }
};

pub const cn_body_def = extern struct {
    struct_size: u32,
    /// CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
    @"type": i32,
    /// of the origin; |x|, |y| <= 1e6 x length unit
    position_m: cn_vec2,
    /// |angle| <= 1e4
    angle_rad: f32,
    /// of the centre of mass; both velocities count only with CN_BODY_AWAKE: what sleeps does not move
    linear_velocity_mps: cn_vec2,
    angular_velocity_radps: f32,
    /// v' = -damping v; >= 0, default 0
    linear_damping_per_s: f32,
    angular_damping_per_s: f32,
    /// default 1
    gravity_scale: f32,
    /// >= 0; default 0: the world's
    sleep_speed_mps: f32,
    /// CN_BODY_*; default ENABLED | SLEEP | AWAKE
    flags: u32,
    /// as in cn_body_set_solver; default CN_SOLVER_AUTO
    solver: i32,
    user_data: u64,
    /// NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
    name: [*c]const u8,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_body_def) != 72) @compileError("cn_body_def");
    }
};

pub const cn_body_moved = extern struct {
    pose: cn_pose,
    user_data: u64,
    body: cn_body,
    /// 1 in the step in which it fell asleep
    fell_asleep: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_body_moved) != 32) @compileError("cn_body_moved");
    }
};

/// Two shapes collide when group is equal and not 0: positive yes, negative no; otherwise when each one's
/// category has a bit in the other's mask.
pub const cn_filter = extern struct {
    /// default 1
    category: u64,
    /// default all ones
    mask: u64,
    /// default 0
    group: i32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_filter) != 24) @compileError("cn_filter");
    }
};

pub const cn_material = extern struct {
    /// coefficient while sticking, [0, 100], default 0.6
    static_friction: f32,
    /// coefficient while sliding, [0, static_friction], default 0.6
    dynamic_friction: f32,
    /// [0, 1], default 0
    restitution: f32,
    /// metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0
    rolling_resistance: f32,
    /// conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; default 0
    tangent_speed_mps: f32,
    /// CN_MIX_*
    friction_mix: i32,
    /// CN_MIX_*
    restitution_mix: i32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_material) != 32) @compileError("cn_material");
    }
};

pub const cn_shape_def = extern struct {
    struct_size: u32,
    /// 0: create unattached, for cn_shape_attach
    body: cn_body,
    /// of the shape in the body's local frame
    offset_m: cn_vec2,
    angle_rad: f32,
    /// >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
    density_kgpm2: f32,
    material: cn_material,
    filter: cn_filter,
    /// bit 1 << CN_EVENT_*; a pair reports what either shape asks for; default ENTER and LEAVE
    event_mask: u32,
    /// CN_SHAPE_SENSOR ...; default 0
    flags: u32,
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_shape_def) != 96) @compileError("cn_shape_def");
    }
};

pub const cn_circle = extern struct {
    center_m: cn_vec2,
    radius_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_circle) != 12) @compileError("cn_circle");
    }
};

/// All points within radius_m of the segment.
pub const cn_capsule = extern struct {
    a_m: cn_vec2,
    b_m: cn_vec2,
    radius_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_capsule) != 20) @compileError("cn_capsule");
    }
};

/// A two-sided segment without mass.
pub const cn_edge = extern struct {
    a_m: cn_vec2,
    b_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_edge) != 16) @compileError("cn_edge");
    }
};

/// Convex; counter-clockwise or clockwise in, always stored counter-clockwise.
pub const cn_polygon = extern struct {
    /// 3 to CN_POLYGON_MAX_VERTICES
    count: i32,
    /// rounding added outside of the points, >= 0
    radius_m: f32,
    points_m: [16]cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_polygon) != 136) @compileError("cn_polygon");
    }
};

/// One-sided, massless ground without catches at its inner vertices. The solid side is on the left of the
/// direction of travel: surface normals point to the right of it, so ground whose points run from +x to -x
/// collides from above and a counter-clockwise loop collides from outside.
pub const cn_chain = extern struct {
    /// copied
    points_m: [*c]const cn_vec2,
    /// an open chain: >= 2; a loop: >= 3; at most 65535
    count: i32,
    /// 1: the last point joins the first
    loop: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_chain) != 16) @compileError("cn_chain");
    }
};

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

pub const cn_manifold = extern struct {
    /// unit, from shape a to shape b
    normal: cn_vec2,
    /// of the last substep, on body b along (normal.y, -normal.x)
    friction_impulse_Ns: f32,
    /// 0, 1 or 2
    point_count: i32,
    points: [2]cn_manifold_point,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_manifold) != 56) @compileError("cn_manifold");
    }
};

pub const cn_contact_event = extern struct {
    shape_a: cn_shape,
    shape_b: cn_shape,
    body_a: cn_body,
    body_b: cn_body,
    /// edge number within a chain, else 0
    child_a: i32,
    child_b: i32,
    /// the same from CREATED to DESTROYED, then reused
    contact_id: u32,
    /// CN_EVENT_*
    kind: i32,
    /// ENTER: closing speed along the normal before the impact; else 0
    approach_speed_mps: f32,
    /// geometry as the step found it, impulses as it left them; points only for ENTER and STAY
    manifold: cn_manifold,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_contact_event) != 92) @compileError("cn_contact_event");
    }
};

/// A shape entered or left a sensor.
pub const cn_sensor_event = extern struct {
    sensor: cn_shape,
    visitor: cn_shape,
    sensor_body: cn_body,
    visitor_body: cn_body,
    /// CN_EVENT_ENTER or CN_EVENT_LEAVE
    kind: i32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_sensor_event) != 24) @compileError("cn_sensor_event");
    }
};

/// First field of every joint definition. A joint's rigid parts are what holds anchors, axes, angles, lengths
/// and limits in place; springs and motors are not.
pub const cn_joint_base = extern struct {
    /// of the whole definition
    struct_size: u32,
    /// CN_JOINT_*; default 0; a type ignores those it has no use for
    flags: u32,
    /// 0: the world
    body_a: cn_body,
    /// 0: the world; one of the two must be dynamic
    body_b: cn_body,
    /// in body a's local frame, or in world coordinates
    anchor_a_m: cn_vec2,
    anchor_b_m: cn_vec2,
    /// of the rigid parts, 0 to 1e6; 0 (default): as stiff as the substeps allow
    stiffness_hertz: f32,
    /// used when stiffness_hertz > 0; 0 to 1e6
    stiffness_damping_ratio: f32,
    /// anchors and axes never pull harder, nor does a limit; 0 (default): no bound
    force_max_N: f32,
    /// the same for angles
    torque_max_Nm: f32,
    /// a reaction above this in any substep is reported (cn_world_joint_events); 0 (default): never
    break_force_N: f32,
    break_torque_Nm: f32,
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_joint_base) != 64) @compileError("cn_joint_base");
    }
};

/// Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].
pub const cn_revolute_def = extern struct {
    base: cn_joint_base,
    reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
    lower_angle_rad: f32,
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

/// Two points keep a distance. Without CN_JOINT_SPRING and without CN_JOINT_LIMIT it is a rigid rod of
/// length_m. With a spring, length_m is its rest length and the distance stays within [min, max] when limits
/// are on; limits alone make a rope (min 0).
pub const cn_distance_def = extern struct {
    base: cn_joint_base,
    /// > 0; default 1
    length_m: f32,
    /// CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
    length_min_m: f32,
    length_max_m: f32,
    /// CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
    motor_speed_mps: f32,
    /// >= 0
    motor_force_max_N: f32,
    /// 0 to 1e6
    spring_hertz: f32,
    /// 0 to 1e6
    spring_damping_ratio: f32,
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_distance_def) != 96) @compileError("cn_distance_def");
    }
};

/// Welded: no relative motion. base.stiffness_hertz makes it springy.
pub const cn_fixed_def = extern struct {
    base: cn_joint_base,
    /// angle b - angle a
    reference_angle_rad: f32,
    /// stiffness of the angle alone, 0 to 1e6; 0: as the base's
    angular_hertz: f32,
    /// 0 to 1e6
    angular_damping_ratio: f32,
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_fixed_def) != 80) @compileError("cn_fixed_def");
    }
};

/// b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.
pub const cn_prismatic_def = extern struct {
    base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (1, 0)
    axis: cn_vec2,
    /// angle b - angle a
    reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: lower <= upper
    lower_m: f32,
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

/// A wheel b on suspension: slides along an axis fixed in a (springy, with limits), turns freely; the motor
/// turns it.
pub const cn_wheel_def = extern struct {
    base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (0, 1)
    axis: cn_vec2,
    /// CN_JOINT_LIMIT: lower <= upper
    lower_m: f32,
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
    /// how briskly, > 0, to 1e6; default 5
    hertz: f32,
    /// 0 to 1e6, default 1
    damping_ratio: f32,
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_motor_def) != 88) @compileError("cn_motor_def");
    }
};

/// Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
/// base.force_max_N must be > 0.
pub const cn_mouse_def = extern struct {
    base: cn_joint_base,
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
    base: cn_joint_base,
    /// size 1e-4 to 1e4, negative: they turn against each other; default 1
    ratio: f32,
    phase_rad: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_gear_def) != 72) @compileError("cn_gear_def");
    }
};

/// |anchor a - ground a| + ratio |anchor b - ground b| <= length: a rope over two pulleys (never pushes).
pub const cn_pulley_def = extern struct {
    base: cn_joint_base,
    /// world
    ground_a_m: cn_vec2,
    ground_b_m: cn_vec2,
    /// 1e-4 to 1e4; default 1
    ratio: f32,
    /// > 0
    length_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_pulley_def) != 88) @compileError("cn_pulley_def");
    }
};

/// b may turn against a in one direction only, and back no farther than to the last click that it passed.
/// Clicks are at phase + any whole number of click_rad, over whole turns.
pub const cn_ratchet_def = extern struct {
    base: cn_joint_base,
    phase_rad: f32,
    /// size 1e-4 to 1e4; positive: b may turn counter-clockwise
    click_rad: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ratchet_def) != 72) @compileError("cn_ratchet_def");
    }
};

/// A torque that pulls angle b - angle a to rest, over whole turns. hertz is that of the two bodies' own
/// inertia.
pub const cn_rotary_spring_def = extern struct {
    base: cn_joint_base,
    rest_angle_rad: f32,
    /// > 0, to 1e6; default 1
    hertz: f32,
    /// 0 to 1e6, default 0
    damping_ratio: f32,
    reserved: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_rotary_spring_def) != 80) @compileError("cn_rotary_spring_def");
    }
};

/// anchor b slides in a slot of body a from anchor a to end.
pub const cn_groove_def = extern struct {
    base: cn_joint_base,
    /// in body a's frame; not equal to anchor a; default (1, 0)
    end_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_groove_def) != 72) @compileError("cn_groove_def");
    }
};

/// Nothing but: the two bodies do not collide.
pub const cn_filter_joint_def = extern struct {
    base: cn_joint_base,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_filter_joint_def) != 64) @compileError("cn_filter_joint_def");
    }
};

/// Something happened to a joint or to a constraint on one body.
pub const cn_joint_event = extern struct {
    /// 0: it was a constraint; stale when destroyed is 1
    joint: cn_joint,
    /// 0: it was a joint; stale when destroyed is 1
    constraint: cn_constraint,
    /// 0: the world
    body_a: cn_body,
    body_b: cn_body,
    /// largest reaction of the step; 0 when a body was destroyed
    force_N: f32,
    torque_Nm: f32,
    /// 1: it is gone (it breaks, or a body of it was destroyed)
    destroyed: u32,
    reserved: u32,
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_joint_event) != 40) @compileError("cn_joint_event");
    }
};

/// Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
/// there.
pub const cn_angle_constraint_def = extern struct {
    struct_size: u32,
    /// CN_CONSTRAINT_*; default 0
    flags: u32,
    /// must be dynamic
    body: cn_body,
    /// lower <= upper; equal: locked
    lower_rad: f32,
    upper_rad: f32,
    /// 0 (default): rigid; to 1e6
    hertz: f32,
    /// used when hertz > 0; 0 to 1e6
    damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events); 0: never
    break_torque_Nm: f32,
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_angle_constraint_def) != 40) @compileError("cn_angle_constraint_def");
    }
};

/// Keeps a point of a body on a line in the world, within a tolerance to either side, and between limits
/// along it.
pub const cn_line_constraint_def = extern struct {
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
    upper_m: f32,
    /// 0 (default): rigid; to 1e6
    hertz: f32,
    /// used when hertz > 0; 0 to 1e6
    damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events); 0: never
    break_force_N: f32,
    reserved: u32,
    user_data: u64,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_line_constraint_def) != 72) @compileError("cn_line_constraint_def");
    }
};

pub const cn_update_report = extern struct {
    /// fixed steps taken
    steps: i32,
    /// time kept for the next update
    leftover_s: f32,
    /// time given up because of the step cap
    dropped_s: f32,
    /// leftover / fixed step, [0, 1): between the last two poses
    interpolation: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_update_report) != 16) @compileError("cn_update_report");
    }
};

pub const cn_ray = extern struct {
    origin_m: cn_vec2,
    /// may be 0: then only shapes around the origin are hit; at most 2e6 length units each way
    translation_m: cn_vec2,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ray) != 16) @compileError("cn_ray");
    }
};

/// What a ray or a moved shape meets. One that starts in contact, overlapping or just touching, meets that
/// shape at fraction 0, with the shortest way out: depth_m along the normal. It does not meet what it
/// touches, up to a depth of 0.5% of the length unit, when its translation does not lead in: along the
/// surface or away from it.
pub const cn_ray_hit = extern struct {
    /// 0: nothing was hit
    shape: cn_shape,
    body: cn_body,
    /// edge of a chain
    child: i32,
    /// of the translation, [0, 1]; 1 when nothing was hit
    fraction: f32,
    /// on the surface of the shape that was hit
    point_m: cn_vec2,
    /// unit, out of the shape that was hit
    normal: cn_vec2,
    /// how deep the start is in it, 0 when it is outside
    depth_m: f32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_ray_hit) != 40) @compileError("cn_ray_hit");
    }
};

/// A query sees shapes of enabled bodies whose category has a bit in mask and whose mask has one in category,
/// and of sensors only those with CN_SHAPE_SENSOR_SEEN. Bodies are seen where they are now, also between
/// steps.
pub const cn_query_filter = extern struct {
    /// default 1
    category: u64,
    /// default all ones
    mask: u64,
    /// its shapes are not seen; 0 (default): none. A stale handle is an error
    ignored_body: cn_body,
    /// CN_QUERY_IGNORE_JOINED ...; default 0
    flags: u32,
    /// NULL (default): all are taken
    visit: ?*const cn_query_fn,
    user: ?*anyopaque,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_query_filter) != 40) @compileError("cn_query_filter");
    }
};

pub const cn_closest = extern struct {
    /// 0: nothing within the distance
    shape: cn_shape,
    body: cn_body,
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

pub const cn_distance = extern struct {
    /// on the surface of a, in the world
    point_a_m: cn_vec2,
    point_b_m: cn_vec2,
    /// unit, from a to b
    normal: cn_vec2,
    /// of the surfaces; negative: the depth, the shortest way that moves b out of a
    distance_m: f32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_distance) != 32) @compileError("cn_distance");
    }
};

/// A motion from fraction 0 to 1: a point of the shape goes in a straight line, and the shape turns evenly
/// about it.
pub const cn_sweep = extern struct {
    start: cn_pose,
    /// that point, in the shape's frame: the centre of mass of a body
    center_m: cn_vec2,
    /// of it; at most 2e6 m each way
    translation_m: cn_vec2,
    /// counter-clockwise, |turn| <= 1e4
    turn_rad: f32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_sweep) != 40) @compileError("cn_sweep");
    }
};

pub const cn_impact = extern struct {
    /// CN_IMPACT_*
    state: i32,
    fraction: f32,
    /// HIT only, as are the next two: between the surfaces
    point_m: cn_vec2,
    /// unit, from a to b
    normal: cn_vec2,
    /// of the surfaces at fraction, from distance_m to 0.1 mm (or what floats can tell) above
    distance_m: f32,
    reserved: u32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_impact) != 32) @compileError("cn_impact");
    }
};

/// A surface that bounds where a shape may move: after a translation t of the shape, separation_m + normal .
/// t is >= 0, unless that takes more than push_max_m.
pub const cn_plane = extern struct {
    /// unit, from the surface to the shape
    normal: cn_vec2,
    /// where they are nearest, in the world
    point_m: cn_vec2,
    /// of the surfaces along the normal; negative: they overlap
    separation_m: f32,
    /// >= 0: the farthest that this plane pushes; FLT_MAX: rigid
    push_max_m: f32,
    /// of the last cn_mover_solve: how far it pushed
    push_m: f32,
    shape: cn_shape,
    body: cn_body,
    /// edge of a chain
    child: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_plane) != 40) @compileError("cn_plane");
    }
};

/// How a character moves. The same for every move, or changed from move to move: crouching is another shape.
pub const cn_mover_def = extern struct {
    struct_size: u32,
    /// CN_MOVER_DROP; default 0
    flags: u32,
    /// around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule
    /// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
    shape: cn_polygon,
    /// what it collides with; sensors never, one-way shapes from above
    filter: cn_query_filter,
    /// any length > 0; default (0, 1)
    up: cn_vec2,
    /// steeper ground cannot be stood on or walked up, 0 to pi / 2; default 0.87 (50 degrees)
    slope_limit_rad: f32,
    /// climbs steps up to this high while it walks, >= 0; default 0.3
    step_height_m: f32,
    /// walking, keeps to ground that falls away by up to this in a move, >= 0; default 0.3
    snap_m: f32,
    /// of the world's gravity in the air; default 1
    gravity_scale: f32,
    /// the most it pushes a dynamic body with, >= 0; default 200
    push_force_N: f32,
    /// of sliding, 1 to 64; default 8
    iterations_max: i32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mover_def) != 216) @compileError("cn_mover_def");
    }
};

/// A character between two moves. It belongs to the caller, who may copy it, keep it and go back to it: the
/// world knows nothing of it, and other bodies do not collide with it: for that give it a kinematic body that
/// is filter.ignored_body and follows by cn_body_set_target_pose. Begin with all 0 but the position.
pub const cn_mover = extern struct {
    position_m: cn_vec2,
    /// in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as
    /// its component across up; the one along up is 0, and a jump when the caller makes it > 0
    velocity_mps: cn_vec2,
    /// of what it stands on, with CN_MOVER_ON_GROUND; else (0, 0)
    ground_normal: cn_vec2,
    /// in the world, after the move
    ground_point_m: cn_vec2,
    /// ... in the frame of ground_body
    ground_local_m: cn_vec2,
    /// of the ground there
    ground_velocity_mps: cn_vec2,
    /// 0: none; may become stale, which is as none
    ground_body: cn_body,
    ground_shape: cn_shape,
    /// CN_MOVER_ON_*, after the last move
    flags: u32,
    /// by how much it overlaps what left it no room; 0 but for rounding
    squeezed_m: f32,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_mover) != 64) @compileError("cn_mover");
    }
};

pub const cn_explosion_def = extern struct {
    struct_size: u32,
    /// full strength within, to the nearest point of a shape; >= 0, default 1
    radius_m: f32,
    /// then linearly to none over this distance; >= 0
    falloff_m: f32,
    /// per metre of the shape's width seen from the centre; negative pulls
    impulse_Nspm: f32,
    center_m: cn_vec2,
    filter: cn_query_filter,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_explosion_def) != 64) @compileError("cn_explosion_def");
    }
};

/// Functions that are NULL are not called. Colours are 0xRRGGBB. Points are in world coordinates.
pub const cn_debug_draw = extern struct {
    struct_size: u32,
    /// CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
    flags: u32,
    /// only what overlaps it is drawn; default everything
    view: cn_aabb,
    polygon: ?*const cn_debug_draw_polygon_fn,
    /// axis: a point on the rim that turns with the body
    circle: ?*const cn_debug_draw_circle_fn,
    capsule: ?*const cn_debug_draw_capsule_fn,
    segment: ?*const cn_debug_draw_segment_fn,
    point: ?*const cn_debug_draw_point_fn,
    text: ?*const cn_debug_draw_text_fn,
    user: ?*anyopaque,
    reserved: ?*anyopaque,

    comptime {
        if (@sizeOf(usize) == 8 and @sizeOf(cn_debug_draw) != 88) @compileError("cn_debug_draw");
    }
};

/// Version as major * 1000000 + minor * 1000 + patch.
pub extern fn cn_version() i32;
/// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
pub extern fn cn_abi_version() i32;
/// Static English text for a result code, never NULL.
pub extern fn cn_result_text(result: cn_result) [*c]const u8;
/// sizeof the struct named by a CN_TYPE_ constant, 0 for an unknown one: bindings check themselves.
pub extern fn cn_sizeof(@"type": i32) i32;
/// Defaults as given beside the fields (those that scale with the length unit are stored as 0 and resolved by
/// cn_world_create: 0 means the default there).
pub extern fn cn_world_def_init(def: [*c]cn_world_def) void;
/// Says in one sentence what is wrong with a definition; writes at most text_bytes bytes including the
/// terminating zero; text may be NULL when text_bytes is 0.
pub extern fn cn_world_def_check(def: [*c]const cn_world_def, text: [*c]u8, text_bytes: i32) cn_result;
/// Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here.
pub extern fn cn_world_bytes_needed(def: [*c]const cn_world_def, out_bytes: [*c]u64) cn_result;
/// Threads that cannot be started are CN_ERROR_MEMORY. A world's memory holds some 150 bytes for each; their
/// stacks, and whatever else a thread needs, are the system's, for a world in a caller's block too. A library
/// built with CN_NO_THREADS, or on a system whose threads it does not know, makes the same world without
/// them: see cn_world_get_worker_count.
pub extern fn cn_world_create(def: [*c]const cn_world_def, out_world: [*c]?*cn_world) cn_result;
/// NULL is allowed. Frees everything; a world in a caller's block just stops using it. Its own threads have
/// ended when this returns. Not from callbacks.
pub extern fn cn_world_destroy(world: ?*cn_world) void;
/// One fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion, and so does
/// less than 1e-9. Cost grows with the number of awake bodies and their contacts.
pub extern fn cn_world_step(world: ?*cn_world, dt_s: f32) cn_result;
/// One sentence on the last call that failed on this world; "" if none did. world may be NULL.
pub extern fn cn_world_error_text(world: ?*const cn_world) [*c]const u8;
/// A change wakes every body: O(bodies) then.
pub extern fn cn_world_set_gravity(world: ?*cn_world, gravity_x_mps2: f32, gravity_y_mps2: f32) cn_result;
pub extern fn cn_world_get_gravity(world: ?*const cn_world, out_mps2: [*c]cn_vec2) cn_result;
/// 1 to 64; more substeps are stiffer and dearer.
pub extern fn cn_world_set_substep_count(world: ?*cn_world, count: i32) cn_result;
pub extern fn cn_world_get_substep_count(world: ?*const cn_world, out_count: [*c]i32) cn_result;
/// CN_SOLVER_*, from the next step on. A world in a caller's block has scratch memory for the solver that it
/// was made with: a dearer one may have to do without direct solving there (CN_WARNING_FRAME_MEMORY).
pub extern fn cn_world_set_solver(world: ?*cn_world, solver: i32) cn_result;
pub extern fn cn_world_get_solver(world: ?*const cn_world, out_solver: [*c]i32) cn_result;
/// Both as in cn_world_def; 0 metres: the default. get gives the accuracy in metres that this stands for.
pub extern fn cn_world_set_accuracy(world: ?*cn_world, accuracy_m: f32, work_budget: i32) cn_result;
pub extern fn cn_world_get_accuracy(world: ?*const cn_world, out_accuracy_m: [*c]f32, out_work_budget: [*c]i32) cn_result;
/// Workers that a step may have: 1, or worker_count where the library can have several.
pub extern fn cn_world_get_worker_count(world: ?*const cn_world, out_count: [*c]i32) cn_result;
/// Replaces the CN_WORLD_ flags. Turning CN_WORLD_SLEEP off wakes everything: O(bodies) then.
pub extern fn cn_world_set_flags(world: ?*cn_world, flags: u32) cn_result;
pub extern fn cn_world_get_flags(world: ?*const cn_world, out_flags: [*c]u32) cn_result;
/// Metres a second, >= 0.
pub extern fn cn_world_set_restitution_threshold(world: ?*cn_world, speed_mps: f32) cn_result;
/// Both > 0: bodies are slowed to these at the end of each step (direction kept).
pub extern fn cn_world_set_speed_limits(world: ?*cn_world, linear_mps: f32, angular_radps: f32) cn_result;
/// speed_mps >= 0, delay_s >= 0.
pub extern fn cn_world_set_sleep(world: ?*cn_world, speed_mps: f32, delay_s: f32) cn_result;
pub extern fn cn_world_set_user_data(world: ?*cn_world, user_data: u64) cn_result;
pub extern fn cn_world_get_user_data(world: ?*const cn_world, out_user_data: [*c]u64) cn_result;
/// Handles of everything alive, in a fixed order (by slot). Writes at most capacity of them (out may be NULL
/// when capacity is 0) and always sets *out_count to how many there are. O(slots).
pub extern fn cn_world_get_bodies(world: ?*const cn_world, out: [*c]cn_body, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_get_shapes(world: ?*const cn_world, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_get_joints(world: ?*const cn_world, out: [*c]cn_joint, capacity: i32, out_count: [*c]i32) cn_result;
/// O(bodies + islands).
pub extern fn cn_world_get_counters(world: ?*const cn_world, out: [*c]cn_counters) cn_result;
/// Of every awake island, as cn_counters.islands_awake counts them: those of several bodies first, in a
/// deterministic order, then bodies alone. Writes at most capacity; *out_count is how many there are. Costs
/// nothing when it is not called. O(bodies + what touches in the islands written).
pub extern fn cn_world_get_islands(world: ?*const cn_world, out: [*c]cn_island_report, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_get_profile(world: ?*const cn_world, out: [*c]cn_profile) cn_result;
pub extern fn cn_world_get_memory_stats(world: ?*const cn_world, out: [*c]cn_memory_stats) cn_result;
/// 64-bit hash (FNV-1a, Fowler/Noll/Vo) of every body's pose, velocity and sleep state and every contact's
/// impulses in handle order: equal for equal histories on every compiler, CPU and thread count. O(bodies +
/// contacts).
pub extern fn cn_world_hash(world: ?*const cn_world, out_hash: [*c]u64) cn_result;
/// Checks every invariant between the tables. CN_OK, or CN_ERROR_INTERNAL with a sentence in text (at most
/// text_bytes bytes with the zero; may be NULL when text_bytes is 0). O(everything).
pub extern fn cn_world_validate(world: ?*const cn_world, text: [*c]u8, text_bytes: i32) cn_result;
/// Bytes that cn_world_save needs now. From callbacks CN_ERROR_LOCKED. O(slots).
pub extern fn cn_world_save_size(world: ?*const cn_world, out_bytes: [*c]u64) cn_result;
/// Writes the state to out, which may have any alignment, and how many bytes that took to out_bytes (may be
/// NULL). capacity: bytes that out has; too few are CN_ERROR_CAPACITY. From callbacks CN_ERROR_LOCKED.
/// O(memory of the world), about 1 KB a body.
pub extern fn cn_world_save(world: ?*const cn_world, out: ?*anyopaque, capacity: u64, out_bytes: [*c]u64) cn_result;
/// Puts a state back: into the world that was saved, or one that was made by the same definition (broadphase,
/// length unit, whether it lives in a caller's block; else CN_ERROR_STATE). bytes: as many as cn_world_save
/// wrote. CN_ERROR_FORMAT: not a save of this version and machine, or damaged. CN_ERROR_MEMORY: no room for
/// what was alive then; a growing world takes what it needs, a world in a caller's block has room for what it
/// had. Arrays handed out before are void. O(memory of the world). Handles of what was alive when the world
/// was saved are valid again, also of what was destroyed since. Those made since are refused, until the same
/// handle is given to something new: with the same calls to the same thing. A game rolls its own state back
/// with the world, and so keeps none of them.
pub extern fn cn_world_restore(world: ?*cn_world, save: ?*const anyopaque, bytes: u64) cn_result;
pub extern fn cn_body_def_init(def: [*c]cn_body_def) void;
pub extern fn cn_body_create(world: ?*cn_world, def: [*c]const cn_body_def, out_body: [*c]cn_body) cn_result;
/// count bodies from an array of definitions; all of them or none. O(count).
pub extern fn cn_body_create_many(world: ?*cn_world, defs: [*c]const cn_body_def, count: i32, out_bodies: [*c]cn_body) cn_result;
/// Also destroys its shapes, contacts, joints and constraints; touching contacts get their leave event,
/// joints and constraints theirs (cn_world_joint_events).
pub extern fn cn_body_destroy(world: ?*cn_world, body: cn_body) cn_result;
/// Destroys all or, if any handle is bad or appears twice, none.
pub extern fn cn_body_destroy_many(world: ?*cn_world, bodies: [*c]const cn_body, count: i32) cn_result;
/// 1 if the handle names a body that is alive in this world, else 0 (also for a NULL world).
pub extern fn cn_body_is_valid(world: ?*const cn_world, body: cn_body) i32;
/// Changing the type ends the body's contacts (those that still overlap begin again in the next step), its
/// forces and any mass override, and wakes it; a body made static stops. CN_ERROR_STATE if a joint would be
/// left without a dynamic body. O(contacts + joints + shapes).
pub extern fn cn_body_set_type(world: ?*cn_world, body: cn_body, @"type": i32) cn_result;
pub extern fn cn_body_get_type(world: ?*const cn_world, body: cn_body, out_type: [*c]i32) cn_result;
/// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which is cn_body_set_awake's and is ignored here. A body
/// without CN_BODY_ENABLED keeps its shapes but collides with nothing and does not move; its contacts end,
/// its joints rest. O(contacts + joints + shapes) when that changes.
pub extern fn cn_body_set_flags(world: ?*cn_world, body: cn_body, flags: u32) cn_result;
/// CN_BODY_AWAKE is set in the result when the body is awake.
pub extern fn cn_body_get_flags(world: ?*const cn_world, body: cn_body, out_flags: [*c]u32) cn_result;
/// 0 puts the body and everything connected to it to sleep, at rest; anything else wakes. Does nothing to
/// static and disabled bodies. O(island).
pub extern fn cn_body_set_awake(world: ?*cn_world, body: cn_body, awake: i32) cn_result;
/// Teleport: origin and angle; velocities stay. Contacts that are no longer near end (the next step reports
/// it). Wakes the body and what is near it. O(contacts + shapes).
pub extern fn cn_body_set_pose(world: ?*cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32) cn_result;
pub extern fn cn_body_get_pose(world: ?*const cn_world, body: cn_body, out: [*c]cn_pose) cn_result;
/// In (-pi, pi].
pub extern fn cn_body_get_angle(world: ?*const cn_world, body: cn_body, out_rad: [*c]f32) cn_result;
/// World position of the centre of mass.
pub extern fn cn_body_get_center(world: ?*const cn_world, body: cn_body, out_m: [*c]cn_vec2) cn_result;
/// Static bodies refuse this with CN_ERROR_STATE. Wakes when not zero.
pub extern fn cn_body_set_velocity(world: ?*cn_world, body: cn_body, linear_x_mps: f32, linear_y_mps: f32, angular_radps: f32) cn_result;
pub extern fn cn_body_get_velocity(world: ?*const cn_world, body: cn_body, out: [*c]cn_velocity) cn_result;
/// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it
/// to this pose, the shorter way round, up to rounding and the world's speed limits: what stands on it or is
/// in its way moves along, as nothing does with cn_body_set_pose. It goes on with that velocity: call it
/// before every step, or stop it after.
pub extern fn cn_body_set_target_pose(world: ?*cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32, dt_s: f32) cn_result;
/// Velocity of the body's material at a world point.
pub extern fn cn_body_get_velocity_at(world: ?*const cn_world, body: cn_body, point_x_m: f32, point_y_m: f32, out_mps: [*c]cn_vec2) cn_result;
pub extern fn cn_body_get_world_point(world: ?*const cn_world, body: cn_body, local_x_m: f32, local_y_m: f32, out_m: [*c]cn_vec2) cn_result;
pub extern fn cn_body_get_local_point(world: ?*const cn_world, body: cn_body, world_x_m: f32, world_y_m: f32, out_m: [*c]cn_vec2) cn_result;
/// Union of its shapes' boxes, without margin; the origin as a point if it has none. O(shapes).
pub extern fn cn_body_get_aabb(world: ?*const cn_world, body: cn_body, out: [*c]cn_aabb) cn_result;
/// Forces and torques act for the next step only and are then cleared. All of these wake a dynamic body and
/// do nothing to static, kinematic and disabled ones (CN_OK). Sums of forces and velocities after impulses
/// must stay finite (CN_ERROR_ARGUMENT).
pub extern fn cn_body_apply_force(world: ?*cn_world, body: cn_body, force_x_N: f32, force_y_N: f32) cn_result;
pub extern fn cn_body_apply_force_at(world: ?*cn_world, body: cn_body, force_x_N: f32, force_y_N: f32, point_x_m: f32, point_y_m: f32) cn_result;
pub extern fn cn_body_apply_torque(world: ?*cn_world, body: cn_body, torque_Nm: f32) cn_result;
pub extern fn cn_body_apply_impulse(world: ?*cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32) cn_result;
pub extern fn cn_body_apply_impulse_at(world: ?*cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32, point_x_m: f32, point_y_m: f32) cn_result;
pub extern fn cn_body_apply_angular_impulse(world: ?*cn_world, body: cn_body, impulse_Nms: f32) cn_result;
/// Sums over the attached shapes unless overridden. A dynamic body whose shapes have no mass weighs 1 kg
/// (and, having no shape, does not rotate).
pub extern fn cn_body_get_mass_data(world: ?*const cn_world, body: cn_body, out: [*c]cn_mass_data) cn_result;
/// Override for a dynamic body (others: CN_ERROR_STATE): mass_kg from 1e-20 to 1e20, inertia_kgm2 0 (never
/// rotates) or from 1e-35 to 1e35. Kept until cn_body_reset_mass_data or until the type changes.
pub extern fn cn_body_set_mass_data(world: ?*cn_world, body: cn_body, mass: [*c]const cn_mass_data) cn_result;
pub extern fn cn_body_reset_mass_data(world: ?*cn_world, body: cn_body) cn_result;
/// Both >= 0.
pub extern fn cn_body_set_damping(world: ?*cn_world, body: cn_body, linear_per_s: f32, angular_per_s: f32) cn_result;
pub extern fn cn_body_get_damping(world: ?*const cn_world, body: cn_body, out_linear_per_s: [*c]f32, out_angular_per_s: [*c]f32) cn_result;
pub extern fn cn_body_set_gravity_scale(world: ?*cn_world, body: cn_body, scale: f32) cn_result;
pub extern fn cn_body_get_gravity_scale(world: ?*const cn_world, body: cn_body, out_scale: [*c]f32) cn_result;
/// >= 0; 0 restores the world's.
pub extern fn cn_body_set_sleep_speed(world: ?*cn_world, body: cn_body, speed_mps: f32) cn_result;
/// How the island of a dynamic body is solved, in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
/// (default): as the world chooses. _SOFT: never directly, contacts and all, whatever its other bodies ask
/// for. _DIRECT: always, however fast it moves, as far as its contacts can be, and within the work_budget.
/// From the next step on; does not wake.
pub extern fn cn_body_set_solver(world: ?*cn_world, body: cn_body, solver: i32) cn_result;
pub extern fn cn_body_get_solver(world: ?*const cn_world, body: cn_body, out_solver: [*c]i32) cn_result;
pub extern fn cn_body_set_user_data(world: ?*cn_world, body: cn_body, user_data: u64) cn_result;
pub extern fn cn_body_get_user_data(world: ?*const cn_world, body: cn_body, out_user_data: [*c]u64) cn_result;
/// NULL or "" removes the name.
pub extern fn cn_body_set_name(world: ?*cn_world, body: cn_body, name: [*c]const u8) cn_result;
/// "" if it has none; valid until the name changes or the body is destroyed.
pub extern fn cn_body_get_name(world: ?*const cn_world, body: cn_body, out_name: [*c][*c]const u8) cn_result;
/// As cn_world_get_bodies, for one body. O(shapes), O(joints).
pub extern fn cn_body_get_shapes(world: ?*const cn_world, body: cn_body, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_body_get_joints(world: ?*const cn_world, body: cn_body, out: [*c]cn_joint, capacity: i32, out_count: [*c]i32) cn_result;
/// Bulk forms: bodies NULL means every body in the order of cn_world_get_bodies, of which there must be
/// exactly count. stride_bytes 0 means tightly packed. One bad handle fails the whole call. O(count).
pub extern fn cn_world_read_poses(world: ?*const cn_world, bodies: [*c]const cn_body, count: i32, out: [*c]cn_pose) cn_result;
pub extern fn cn_world_read_poses_strided(world: ?*const cn_world, bodies: [*c]const cn_body, count: i32, out: ?*anyopaque, stride_bytes: i32) cn_result;
pub extern fn cn_world_read_velocities(world: ?*const cn_world, bodies: [*c]const cn_body, count: i32, out: [*c]cn_velocity) cn_result;
/// cn_body_set_velocity for many; nothing is written if one is bad. Static bodies take zero only.
pub extern fn cn_world_write_velocities(world: ?*cn_world, bodies: [*c]const cn_body, count: i32, velocities: [*c]const cn_velocity) cn_result;
/// Bodies whose pose changed in the last step, and those that fell asleep in it, without the ones destroyed
/// since. Built on the first call after a step: O(awake bodies) then.
pub extern fn cn_world_moved(world: ?*cn_world, out_moved: [*c][*c]const cn_body_moved, out_count: [*c]i32) cn_result;
pub extern fn cn_shape_def_init(def: [*c]cn_shape_def) void;
/// out_shape may be NULL in all of these. Points closer than 0.05% of the length unit are degenerate.
pub extern fn cn_shape_create_circle(world: ?*cn_world, def: [*c]const cn_shape_def, circle: [*c]const cn_circle, out_shape: [*c]cn_shape) cn_result;
pub extern fn cn_shape_create_capsule(world: ?*cn_world, def: [*c]const cn_shape_def, capsule: [*c]const cn_capsule, out_shape: [*c]cn_shape) cn_result;
pub extern fn cn_shape_create_edge(world: ?*cn_world, def: [*c]const cn_shape_def, edge: [*c]const cn_edge, out_shape: [*c]cn_shape) cn_result;
pub extern fn cn_shape_create_polygon(world: ?*cn_world, def: [*c]const cn_shape_def, polygon: [*c]const cn_polygon, out_shape: [*c]cn_shape) cn_result;
/// Half sizes > 0; radius_m >= 0 is added outside of them.
pub extern fn cn_shape_create_box(world: ?*cn_world, def: [*c]const cn_shape_def, half_width_m: f32, half_height_m: f32, radius_m: f32, out_shape: [*c]cn_shape) cn_result;
/// O(count).
pub extern fn cn_shape_create_chain(world: ?*cn_world, def: [*c]const cn_shape_def, chain: [*c]const cn_chain, out_shape: [*c]cn_shape) cn_result;
/// An unattached shape joins a body (CN_ERROR_STATE if it already has one), an attached one leaves it.
pub extern fn cn_shape_attach(world: ?*cn_world, shape: cn_shape, body: cn_body) cn_result;
pub extern fn cn_shape_detach(world: ?*cn_world, shape: cn_shape) cn_result;
pub extern fn cn_shape_destroy(world: ?*cn_world, shape: cn_shape) cn_result;
pub extern fn cn_shape_is_valid(world: ?*const cn_world, shape: cn_shape) i32;
pub extern fn cn_shape_get_type(world: ?*const cn_world, shape: cn_shape, out_type: [*c]i32) cn_result;
/// 0 if unattached.
pub extern fn cn_shape_get_body(world: ?*const cn_world, shape: cn_shape, out_body: [*c]cn_body) cn_result;
/// Takes effect at once, on resting contacts too (their bodies wake).
pub extern fn cn_shape_set_material(world: ?*cn_world, shape: cn_shape, material: [*c]const cn_material) cn_result;
pub extern fn cn_shape_get_material(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_material) cn_result;
/// >= 0; the body's mass follows at once.
pub extern fn cn_shape_set_density(world: ?*cn_world, shape: cn_shape, density_kgpm2: f32) cn_result;
pub extern fn cn_shape_get_density(world: ?*const cn_world, shape: cn_shape, out_kgpm2: [*c]f32) cn_result;
/// Contacts that it forbids end at once (with their events); ones that it allows begin in the next step.
pub extern fn cn_shape_set_filter(world: ?*cn_world, shape: cn_shape, filter: [*c]const cn_filter) cn_result;
pub extern fn cn_shape_get_filter(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_filter) cn_result;
/// Takes effect at once, for present contacts too.
pub extern fn cn_shape_set_event_mask(world: ?*cn_world, shape: cn_shape, event_mask: u32) cn_result;
pub extern fn cn_shape_get_event_mask(world: ?*const cn_world, shape: cn_shape, out_event_mask: [*c]u32) cn_result;
/// Replaces the CN_SHAPE_ flags (SENSOR ...). Contacts end and begin anew as needed.
pub extern fn cn_shape_set_flags(world: ?*cn_world, shape: cn_shape, flags: u32) cn_result;
pub extern fn cn_shape_get_flags(world: ?*const cn_world, shape: cn_shape, out_flags: [*c]u32) cn_result;
pub extern fn cn_shape_set_user_data(world: ?*cn_world, shape: cn_shape, user_data: u64) cn_result;
pub extern fn cn_shape_get_user_data(world: ?*const cn_world, shape: cn_shape, out_user_data: [*c]u64) cn_result;
/// Without margin, in world space (in shape space when unattached). O(points).
pub extern fn cn_shape_get_aabb(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_aabb) cn_result;
/// In the body's local frame, at the present density; inertia about the shape's own centre. O(points).
pub extern fn cn_shape_get_mass_data(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_mass_data) cn_result;
/// The shape's geometry in its body's local frame, offset applied. CN_ERROR_STATE for another type.
pub extern fn cn_shape_get_circle(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_circle) cn_result;
pub extern fn cn_shape_get_capsule(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_capsule) cn_result;
pub extern fn cn_shape_get_edge(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_edge) cn_result;
pub extern fn cn_shape_get_polygon(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_polygon) cn_result;
/// Writes at most capacity points (out may be NULL when capacity is 0); *out_count is how many there are.
pub extern fn cn_shape_get_chain_points(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_vec2, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_shape_test_point(world: ?*const cn_world, shape: cn_shape, point_x_m: f32, point_y_m: f32, out_inside: [*c]i32) cn_result;
/// Convex hull of 1 or more points (farthest points inserted, as in Quickhull: Barber, Dobkin, Huhdanpaa
/// 1996) of at most CN_POLYGON_MAX_VERTICES, those that add the most area. CN_ERROR_ARGUMENT for fewer than
/// three distinct points or collinear ones. Details below 5 mm are dropped (below 5% of the half size for
/// hulls under 0.1 m, below 0.5% for those over 1 m). O(count^2) at worst, count <= 65536.
pub extern fn cn_polygon_make_hull(points_m: [*c]const cn_vec2, count: i32, radius_m: f32, out: [*c]cn_polygon) cn_result;
/// A box of half sizes > 0, moved and then turned about its own centre.
pub extern fn cn_polygon_make_box(half_width_m: f32, half_height_m: f32, center_x_m: f32, center_y_m: f32, angle_rad: f32, radius_m: f32, out: [*c]cn_polygon) cn_result;
/// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. They are always
/// bookended: every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved away, body
/// or shape destroyed, detached or disabled, filter or type changed). Pairs that end through a call between
/// two steps are reported by the next step; handles in such events may be stale. Falling asleep is not
/// leaving: a sleeping pair reports nothing until it wakes, and then goes on where it was. The array is built
/// on the first request after a step, O(events) then: that may return CN_ERROR_MEMORY, and inside callbacks
/// CN_ERROR_LOCKED.
pub extern fn cn_world_contact_events(world: ?*cn_world, kind: i32, out_events: [*c][*c]const cn_contact_event, out_count: [*c]i32) cn_result;
/// function NULL removes it.
pub extern fn cn_world_set_contact_callback(world: ?*cn_world, kind: i32, function: ?*const cn_contact_event_fn, user: ?*anyopaque) cn_result;
/// function NULL removes it.
pub extern fn cn_world_set_filter_callback(world: ?*cn_world, function: ?*const cn_filter_fn, user: ?*anyopaque) cn_result;
pub extern fn cn_world_set_pre_solve_callback(world: ?*cn_world, function: ?*const cn_pre_solve_fn, user: ?*anyopaque) cn_result;
pub extern fn cn_world_set_material_mix_callback(world: ?*cn_world, function: ?*const cn_material_mix_fn, user: ?*anyopaque) cn_result;
/// Of the last step, in a deterministic order; bookended like contact events. Sensors see dynamic and
/// kinematic bodies' shapes that are not sensors, by exact overlap.
pub extern fn cn_world_sensor_events(world: ?*const cn_world, out_events: [*c][*c]const cn_sensor_event, out_count: [*c]i32) cn_result;
/// The contacts of a body, touching or not, as events of kind STAY (touching) or CREATED. Writes at most
/// capacity; *out_count is how many there are. O(contacts).
pub extern fn cn_body_get_contacts(world: ?*const cn_world, body: cn_body, out: [*c]cn_contact_event, capacity: i32, out_count: [*c]i32) cn_result;
/// As cn_body_get_contacts, of one shape, a chain with all its edges. O(contacts of its body).
pub extern fn cn_shape_get_contacts(world: ?*const cn_world, shape: cn_shape, out: [*c]cn_contact_event, capacity: i32, out_count: [*c]i32) cn_result;
/// The shapes that are in a sensor, each once: those whose ENTER had no LEAVE up to the last step.
/// CN_ERROR_STATE for a shape that is no sensor. O(contacts of its body), for chains squared.
pub extern fn cn_shape_get_visitors(world: ?*const cn_world, sensor: cn_shape, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
/// Bodies that fell asleep in the last step, or since by cn_body_set_awake; ones destroyed since are stale
/// handles.
pub extern fn cn_world_fell_asleep(world: ?*const cn_world, out_bodies: [*c][*c]const cn_body, out_count: [*c]i32) cn_result;
pub extern fn cn_revolute_def_init(def: [*c]cn_revolute_def) void;
pub extern fn cn_distance_def_init(def: [*c]cn_distance_def) void;
pub extern fn cn_fixed_def_init(def: [*c]cn_fixed_def) void;
pub extern fn cn_prismatic_def_init(def: [*c]cn_prismatic_def) void;
pub extern fn cn_wheel_def_init(def: [*c]cn_wheel_def) void;
pub extern fn cn_motor_def_init(def: [*c]cn_motor_def) void;
pub extern fn cn_mouse_def_init(def: [*c]cn_mouse_def) void;
pub extern fn cn_gear_def_init(def: [*c]cn_gear_def) void;
pub extern fn cn_pulley_def_init(def: [*c]cn_pulley_def) void;
pub extern fn cn_ratchet_def_init(def: [*c]cn_ratchet_def) void;
pub extern fn cn_rotary_spring_def_init(def: [*c]cn_rotary_spring_def) void;
pub extern fn cn_groove_def_init(def: [*c]cn_groove_def) void;
pub extern fn cn_filter_joint_def_init(def: [*c]cn_filter_joint_def) void;
/// Wake both bodies. CN_ERROR_ARGUMENT for a body with itself or without a dynamic body.
pub extern fn cn_joint_create_revolute(world: ?*cn_world, def: [*c]const cn_revolute_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_distance(world: ?*cn_world, def: [*c]const cn_distance_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_fixed(world: ?*cn_world, def: [*c]const cn_fixed_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_prismatic(world: ?*cn_world, def: [*c]const cn_prismatic_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_wheel(world: ?*cn_world, def: [*c]const cn_wheel_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_motor(world: ?*cn_world, def: [*c]const cn_motor_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_mouse(world: ?*cn_world, def: [*c]const cn_mouse_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_gear(world: ?*cn_world, def: [*c]const cn_gear_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_pulley(world: ?*cn_world, def: [*c]const cn_pulley_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_ratchet(world: ?*cn_world, def: [*c]const cn_ratchet_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_rotary_spring(world: ?*cn_world, def: [*c]const cn_rotary_spring_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_groove(world: ?*cn_world, def: [*c]const cn_groove_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_create_filter(world: ?*cn_world, def: [*c]const cn_filter_joint_def, out_joint: [*c]cn_joint) cn_result;
pub extern fn cn_joint_destroy(world: ?*cn_world, joint: cn_joint) cn_result;
pub extern fn cn_joint_is_valid(world: ?*const cn_world, joint: cn_joint) i32;
pub extern fn cn_joint_get_type(world: ?*const cn_world, joint: cn_joint, out_type: [*c]i32) cn_result;
pub extern fn cn_joint_get_bodies(world: ?*const cn_world, joint: cn_joint, out_a: [*c]cn_body, out_b: [*c]cn_body) cn_result;
pub extern fn cn_joint_get_anchors(world: ?*const cn_world, joint: cn_joint, out_world_a_m: [*c]cn_vec2, out_world_b_m: [*c]cn_vec2) cn_result;
/// Force in newtons and torque in newton metres that the joint put on body b in the last substep.
pub extern fn cn_joint_get_reaction(world: ?*const cn_world, joint: cn_joint, out_force_N: [*c]cn_vec2, out_torque_Nm: [*c]f32) cn_result;
/// How far the joint's rigid parts are from being satisfied: metres (anchors, lengths beyond limits) and
/// radians (angles beyond limits), both >= 0.
pub extern fn cn_joint_get_error(world: ?*const cn_world, joint: cn_joint, out_m: [*c]f32, out_rad: [*c]f32) cn_result;
/// In worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): the joint is solved together with its
/// neighbours where that is cheap. _SOFT: always by itself. _DIRECT: together with all joints that it hangs
/// together with, for as much work as CN_SOLVER_DIRECT takes, within the work_budget. In a world in a
/// caller's block that was not made with CN_SOLVER_DIRECT, _DIRECT is _AUTO. From the next step on; does not
/// wake.
pub extern fn cn_joint_set_solver(world: ?*cn_world, joint: cn_joint, solver: i32) cn_result;
pub extern fn cn_joint_get_solver(world: ?*const cn_world, joint: cn_joint, out_solver: [*c]i32) cn_result;
pub extern fn cn_joint_set_user_data(world: ?*cn_world, joint: cn_joint, user_data: u64) cn_result;
pub extern fn cn_joint_get_user_data(world: ?*const cn_world, joint: cn_joint, out_user_data: [*c]u64) cn_result;
/// Replaces the CN_JOINT_ flags. Wakes. O(contacts) when CN_JOINT_COLLIDE changes.
pub extern fn cn_joint_set_flags(world: ?*cn_world, joint: cn_joint, flags: u32) cn_result;
pub extern fn cn_joint_get_flags(world: ?*const cn_world, joint: cn_joint, out_flags: [*c]u32) cn_result;
/// Read back or replace a definition. set leaves bodies and anchors as they are and ignores struct_size; all
/// else is taken, flags and user data too. CN_ERROR_STATE for a joint of another type. set wakes. A filter
/// joint has nothing but its base.
pub extern fn cn_joint_get_revolute(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_revolute_def) cn_result;
pub extern fn cn_joint_set_revolute(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_revolute_def) cn_result;
pub extern fn cn_joint_get_distance(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_distance_def) cn_result;
pub extern fn cn_joint_set_distance(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_distance_def) cn_result;
pub extern fn cn_joint_get_fixed(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_fixed_def) cn_result;
pub extern fn cn_joint_set_fixed(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_fixed_def) cn_result;
pub extern fn cn_joint_get_prismatic(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_prismatic_def) cn_result;
pub extern fn cn_joint_set_prismatic(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_prismatic_def) cn_result;
pub extern fn cn_joint_get_wheel(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_wheel_def) cn_result;
pub extern fn cn_joint_set_wheel(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_wheel_def) cn_result;
pub extern fn cn_joint_get_motor_to(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_motor_def) cn_result;
pub extern fn cn_joint_set_motor_to(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_motor_def) cn_result;
pub extern fn cn_joint_get_mouse(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_mouse_def) cn_result;
pub extern fn cn_joint_set_mouse(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_mouse_def) cn_result;
pub extern fn cn_joint_get_gear(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_gear_def) cn_result;
pub extern fn cn_joint_set_gear(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_gear_def) cn_result;
pub extern fn cn_joint_get_pulley(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_pulley_def) cn_result;
pub extern fn cn_joint_set_pulley(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_pulley_def) cn_result;
pub extern fn cn_joint_get_ratchet(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_ratchet_def) cn_result;
pub extern fn cn_joint_set_ratchet(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_ratchet_def) cn_result;
pub extern fn cn_joint_get_rotary_spring(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_rotary_spring_def) cn_result;
pub extern fn cn_joint_set_rotary_spring(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_rotary_spring_def) cn_result;
pub extern fn cn_joint_get_groove(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_groove_def) cn_result;
pub extern fn cn_joint_set_groove(world: ?*cn_world, joint: cn_joint, def: [*c]const cn_groove_def) cn_result;
/// The base of any joint.
pub extern fn cn_joint_get_base(world: ?*const cn_world, joint: cn_joint, out: [*c]cn_joint_base) cn_result;
/// Takes stiffness, most force and torque, and break thresholds; the rest of base is ignored. Wakes.
pub extern fn cn_joint_set_base(world: ?*cn_world, joint: cn_joint, base: [*c]const cn_joint_base) cn_result;
/// Mouse joint: where to drag to; called each frame. CN_ERROR_STATE for another type. Wakes.
pub extern fn cn_joint_set_target(world: ?*cn_world, joint: cn_joint, target_x_m: f32, target_y_m: f32) cn_result;
/// Revolute, fixed, motor: the angle b - angle a - reference (motor: without one), in (-pi, pi]. Distance,
/// pulley: the present length. Prismatic, wheel, groove: the translation along the axis. Mouse: distance to
/// the target. Gear: angle b - ratio * angle a; ratchet, rotary spring: angle b - angle a, these three over
/// whole turns.
pub extern fn cn_joint_get_position(world: ?*const cn_world, joint: cn_joint, out_position: [*c]f32) cn_result;
/// How fast that changes; but of a wheel how fast b turns against a. With CN_JOINT_MOTOR, positive follows
/// these.
pub extern fn cn_joint_get_speed(world: ?*const cn_world, joint: cn_joint, out_speed: [*c]f32) cn_result;
/// The two setters that games call each frame, for revolute, distance, prismatic and wheel (others:
/// CN_ERROR_STATE). Wake.
pub extern fn cn_joint_set_motor(world: ?*cn_world, joint: cn_joint, speed: f32, force_or_torque_max: f32) cn_result;
pub extern fn cn_joint_set_limits(world: ?*cn_world, joint: cn_joint, lower: f32, upper: f32) cn_result;
/// Those that exceeded a break threshold in the last step, and those destroyed with a body in or since the
/// step before (by calls between two steps: reported by the next step).
pub extern fn cn_world_joint_events(world: ?*const cn_world, out_events: [*c][*c]const cn_joint_event, out_count: [*c]i32) cn_result;
pub extern fn cn_angle_constraint_def_init(def: [*c]cn_angle_constraint_def) void;
pub extern fn cn_line_constraint_def_init(def: [*c]cn_line_constraint_def) void;
/// They are solved with the joints, before contacts. Wake the body.
pub extern fn cn_constraint_create_angle(world: ?*cn_world, def: [*c]const cn_angle_constraint_def, out_constraint: [*c]cn_constraint) cn_result;
pub extern fn cn_constraint_create_line(world: ?*cn_world, def: [*c]const cn_line_constraint_def, out_constraint: [*c]cn_constraint) cn_result;
pub extern fn cn_constraint_destroy(world: ?*cn_world, constraint: cn_constraint) cn_result;
pub extern fn cn_constraint_is_valid(world: ?*const cn_world, constraint: cn_constraint) i32;
pub extern fn cn_constraint_get_type(world: ?*const cn_world, constraint: cn_constraint, out_type: [*c]i32) cn_result;
pub extern fn cn_constraint_get_body(world: ?*const cn_world, constraint: cn_constraint, out_body: [*c]cn_body) cn_result;
/// Read back or replace a definition; set ignores body. CN_ERROR_STATE for the other type. set wakes.
pub extern fn cn_constraint_get_angle(world: ?*const cn_world, constraint: cn_constraint, out: [*c]cn_angle_constraint_def) cn_result;
pub extern fn cn_constraint_set_angle(world: ?*cn_world, constraint: cn_constraint, def: [*c]const cn_angle_constraint_def) cn_result;
pub extern fn cn_constraint_get_line(world: ?*const cn_world, constraint: cn_constraint, out: [*c]cn_line_constraint_def) cn_result;
pub extern fn cn_constraint_set_line(world: ?*cn_world, constraint: cn_constraint, def: [*c]const cn_line_constraint_def) cn_result;
/// Angle: the angle over whole turns. Line: where along the axis the point is, from origin.
pub extern fn cn_constraint_get_position(world: ?*const cn_world, constraint: cn_constraint, out_position: [*c]f32) cn_result;
/// Force in newtons and torque in newton metres that it put on the body in the last substep.
pub extern fn cn_constraint_get_reaction(world: ?*const cn_world, constraint: cn_constraint, out_force_N: [*c]cn_vec2, out_torque_Nm: [*c]f32) cn_result;
/// How far beyond what is allowed, >= 0.
pub extern fn cn_constraint_get_error(world: ?*const cn_world, constraint: cn_constraint, out_m: [*c]f32, out_rad: [*c]f32) cn_result;
/// As cn_world_get_joints and cn_body_get_joints, which do not list constraints.
pub extern fn cn_world_get_constraints(world: ?*const cn_world, out: [*c]cn_constraint, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_body_get_constraints(world: ?*const cn_world, body: cn_body, out: [*c]cn_constraint, capacity: i32, out_count: [*c]i32) cn_result;
/// step_s in (0, 1], default 1/60; steps_max >= 1, default 8.
pub extern fn cn_world_set_fixed_step(world: ?*cn_world, step_s: f32, steps_max: i32) cn_result;
/// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. Events
/// of all steps but the last are only seen by callbacks. out may be NULL.
pub extern fn cn_world_update(world: ?*cn_world, elapsed_s: f32, out: [*c]cn_update_report) cn_result;
/// Poses between the last two steps of cn_world_update: factor 0 the one before, 1 the last. bodies as in
/// cn_world_read_poses. Bodies that did not take part in the last step have their present pose.
pub extern fn cn_world_read_poses_interpolated(world: ?*const cn_world, bodies: [*c]const cn_body, count: i32, factor: f32, out: [*c]cn_pose) cn_result;
pub extern fn cn_query_filter_init(filter: [*c]cn_query_filter) void;
/// Nearest hit; out->shape is 0 when there is none. An edge is hit from both sides, a chain from its front
/// only. Of equal hits the first by shape (as in cn_world_get_shapes), then child. filter may be NULL in all
/// queries: the defaults. O(log) to O(shapes along the ray).
pub extern fn cn_world_cast_ray(world: ?*const cn_world, ray: [*c]const cn_ray, filter: [*c]const cn_query_filter, out: [*c]cn_ray_hit) cn_result;
/// 1 if anything is hit: cheaper than the nearest.
pub extern fn cn_world_cast_ray_any(world: ?*const cn_world, ray: [*c]const cn_ray, filter: [*c]const cn_query_filter, out_hit: [*c]i32) cn_result;
/// Up to capacity hits, nearest first (the nearest ones if there are more); *out_count is how many were
/// found. A chain is hit once by each edge on the way.
pub extern fn cn_world_cast_ray_all(world: ?*const cn_world, ray: [*c]const cn_ray, filter: [*c]const cn_query_filter, out: [*c]cn_ray_hit, capacity: i32, out_count: [*c]i32) cn_result;
/// count rays, the nearest hit of each; nothing is written if one of them is bad.
pub extern fn cn_world_cast_rays(world: ?*const cn_world, rays: [*c]const cn_ray, count: i32, filter: [*c]const cn_query_filter, out: [*c]cn_ray_hit) cn_result;
/// Against one shape alone, whatever its filter, in shape space when unattached. O(edges of a chain).
pub extern fn cn_shape_cast_ray(world: ?*const cn_world, shape: cn_shape, ray: [*c]const cn_ray, out: [*c]cn_ray_hit) cn_result;
/// A polygon (its points in world coordinates; count may be 1 or 2 too, with radius > 0: circle, capsule)
/// moved by translation without turning: the first shape it meets. A chain is met by what has the mean of its
/// points in front.
pub extern fn cn_world_cast_shape(world: ?*const cn_world, shape: [*c]const cn_polygon, translation_x_m: f32, translation_y_m: f32, filter: [*c]const cn_query_filter, out: [*c]cn_ray_hit) cn_result;
/// Shapes that overlap a region: at most capacity handles are written (the first ones), *out_count is how
/// many there are, in the order of cn_world_get_shapes. The first is by the shapes' boxes without margin, the
/// others exact. A chain is listed once; edges and chains are lines here, seen from both sides, and contain
/// no point. Polygons as in cn_world_cast_shape. O(log) to O(boxes in the region).
pub extern fn cn_world_overlap_aabb(world: ?*const cn_world, box: [*c]const cn_aabb, filter: [*c]const cn_query_filter, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_overlap_circle(world: ?*const cn_world, circle: [*c]const cn_circle, filter: [*c]const cn_query_filter, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_overlap_polygon(world: ?*const cn_world, polygon: [*c]const cn_polygon, filter: [*c]const cn_query_filter, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
pub extern fn cn_world_overlap_point(world: ?*const cn_world, x_m: f32, y_m: f32, filter: [*c]const cn_query_filter, out: [*c]cn_shape, capacity: i32, out_count: [*c]i32) cn_result;
/// The shape nearest to a point within distance_max_m (0 to 4e6 length units), the deepest if the point is in
/// several. Cost grows with what is near, not with distance_max_m.
pub extern fn cn_world_closest_point(world: ?*const cn_world, x_m: f32, y_m: f32, distance_max_m: f32, filter: [*c]const cn_query_filter, out: [*c]cn_closest) cn_result;
/// By GJK (Gilbert, Johnson, Keerthi 1988) when the shapes without their radii are apart, else by their
/// Minkowski difference.
pub extern fn cn_polygon_distance(a: [*c]const cn_polygon, pose_a: [*c]const cn_pose, b: [*c]const cn_polygon, pose_b: [*c]const cn_pose, out: [*c]cn_distance) cn_result;
/// b is moved by translation (at most 2e6 m each way) without turning: where it meets a, as cn_ray_hit says,
/// without shape, body and child; 1 in *out_hit, or 0.
pub extern fn cn_polygon_cast(a: [*c]const cn_polygon, pose_a: [*c]const cn_pose, b: [*c]const cn_polygon, pose_b: [*c]const cn_pose, translation_x_m: f32, translation_y_m: f32, out: [*c]cn_ray_hit, out_hit: [*c]i32) cn_result;
/// The contact of a step: no points when they are farther apart than margin_m (0 to 1e6). Impulses are 0. Not
/// for a single point of radius 0.
pub extern fn cn_polygon_collide(a: [*c]const cn_polygon, pose_a: [*c]const cn_pose, b: [*c]const cn_polygon, pose_b: [*c]const cn_pose, margin_m: f32, out: [*c]cn_manifold) cn_result;
/// When two shapes that move and turn first come within distance_m (0 to 1e6) of each other; fraction 0 for
/// those that start nearer. Conservative advancement (Mirtich 1996) along fixed axes (Catto, GDC 2013) that
/// never passes by a hit.
pub extern fn cn_polygon_time_of_impact(a: [*c]const cn_polygon, sweep_a: [*c]const cn_sweep, b: [*c]const cn_polygon, sweep_b: [*c]const cn_sweep, distance_m: f32, out: [*c]cn_impact) cn_result;
/// The planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved by
/// position: how they touch it, as in a step, rigid. At most capacity, those of least separation first;
/// *out_count is how many there are. Sensors are no surfaces. With CN_QUERY_ONE_WAY a one-way shape is one
/// only from its upper side, and only for what is no deeper in it than 0.5% of the length unit and what it
/// rose by in the last step. A shape wholly behind another one's plane is left out: it cannot be met while
/// that plane holds, so that the seams of tiles do not catch (not done when capacity is too small for all).
/// O(shapes near, squared).
pub extern fn cn_mover_collide(world: ?*const cn_world, shape: [*c]const cn_polygon, position_x_m: f32, position_y_m: f32, margin_m: f32, filter: [*c]const cn_query_filter, out: [*c]cn_plane, capacity: i32, out_count: [*c]i32) cn_result;
/// The translation nearest to a wanted one that the planes allow: exactly, for in two dimensions it lies on
/// at most two of them. A plane pushes by no more than push_max_m: which ones push their most, Hildreth's
/// method (1957) tells. Sets push_m. Between surfaces that leave no room it is that of the least sum of
/// squared overlaps (Cimmino 1938), and *out_overlap_m, else 0 up to rounding, says how deep the deepest of
/// them remains that did not push its most. count 0 to CN_PLANES_MAX. No world. O(count^2), O(count^3) where
/// two planes hold it.
pub extern fn cn_mover_solve(planes: [*c]cn_plane, count: i32, translation_x_m: f32, translation_y_m: f32, out_translation_m: [*c]cn_vec2, out_overlap_m: [*c]f32) cn_result;
/// The velocity nearest to a given one that leads into none of the planes that pushed in the last
/// cn_mover_solve. No world.
pub extern fn cn_mover_clip(planes: [*c]const cn_plane, count: i32, velocity_x_mps: f32, velocity_y_mps: f32, out_mps: [*c]cn_vec2) cn_result;
pub extern fn cn_mover_def_init(def: [*c]cn_mover_def) void;
/// Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, or it is a step behind what
/// carries it. 1. carried   by what its ground did since the last move: the change of the place in
/// ground_body where it stood, conveyors too 2. walking   on the ground: velocity_mps across up, along the
/// ground, as fast uphill as downhill; no gravity, so that it does not creep. Where something too steep is in
/// the way, a step up: up by step_height_m, forward, down on what can be walked on flying    in the air:
/// velocity_mps and gravity (exact for constant gravity). Jumping and walking off take ground_velocity_mps
/// along 3. sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no
/// speed passes through a wall 4. pushing   dynamic bodies in the way get a force for the next step that
/// brings them to the character's velocity, of at most push_force_N each 5. ground    what it touches and can
/// stand on, or finds within snap_m below when it walked; velocity_mps loses what is blocked Depends on the
/// world, def and mover alone: the same calls give the same bits. The loop of planes, solver and cast is that
/// of Box2D 3's sample of a character mover (Catto 2025). Bodies pushed wake up; nothing else of the world
/// changes. O(shapes near x iterations_max): some 1 us standing, 3 us walking, 10 us against a wall.
pub extern fn cn_mover_move(world: ?*cn_world, def: [*c]const cn_mover_def, dt_s: f32, mover: [*c]cn_mover) cn_result;
pub extern fn cn_explosion_def_init(def: [*c]cn_explosion_def) void;
/// Pushes dynamic bodies away from the centre, each shape at its point nearest to it, and wakes them.
/// Velocities must stay finite (CN_ERROR_ARGUMENT). O(shapes in reach).
pub extern fn cn_world_explode(world: ?*cn_world, def: [*c]const cn_explosion_def) cn_result;
pub extern fn cn_debug_draw_init(draw: [*c]cn_debug_draw) void;
/// Reads only. O(what is drawn).
pub extern fn cn_world_draw(world: ?*const cn_world, draw: [*c]const cn_debug_draw) cn_result;
/// Dynamic AABB tree. alloc and free NULL: malloc. margin_m >= 0 is added around every box.
pub extern fn cn_tree_create(margin_m: f32, alloc: ?*const cn_alloc_fn, free: ?*const cn_free_fn, allocator_user: ?*anyopaque, out_tree: [*c]?*cn_tree) cn_result;
pub extern fn cn_tree_destroy(tree: ?*cn_tree) void;
/// O(log n). *out_item is never 0.
pub extern fn cn_tree_insert(tree: ?*cn_tree, box: [*c]const cn_aabb, user_data: u64, out_item: [*c]u32) cn_result;
pub extern fn cn_tree_remove(tree: ?*cn_tree, item: u32) cn_result;
/// Nothing happens while the box stays within its margin. O(log n) else.
pub extern fn cn_tree_move(tree: ?*cn_tree, item: u32, box: [*c]const cn_aabb) cn_result;
pub extern fn cn_tree_get_box(tree: ?*const cn_tree, item: u32, out: [*c]cn_aabb) cn_result;
pub extern fn cn_tree_query(tree: ?*const cn_tree, box: [*c]const cn_aabb, visit: ?*const cn_tree_query_fn, user: ?*anyopaque) cn_result;
pub extern fn cn_tree_cast_ray(tree: ?*const cn_tree, ray: [*c]const cn_ray, visit: ?*const cn_tree_ray_fn, user: ?*anyopaque) cn_result;
/// Number of items and height of the tree.
pub extern fn cn_tree_get_stats(tree: ?*const cn_tree, out_count: [*c]i32, out_height: [*c]i32) cn_result;

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
    if (cn_sizeof(CN_TYPE_EXPLOSION_DEF) != @sizeOf(cn_explosion_def)) return error.WrongLibrary;
    if (cn_sizeof(CN_TYPE_DEBUG_DRAW) != @sizeOf(cn_debug_draw)) return error.WrongLibrary;
}
