//! C's functions of Cairn under their own names. Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//! The crate `cairn` is the safe layer above.
#![no_std]
#![allow(non_camel_case_types, non_snake_case, clippy::too_many_arguments)]
use core::ffi::{c_char, c_void};

pub const CN_VERSION_MAJOR: i32 = 0;
pub const CN_VERSION_MINOR: i32 = 1;
pub const CN_VERSION_PATCH: i32 = 0;
pub const CN_ABI_VERSION: i32 = 3;
pub const CN_POLYGON_MAX_VERTICES: i32 = 16;
pub const CN_NAME_MAX_BYTES: i32 = 63;
pub const CN_PLANES_MAX: i32 = 64;
pub const CN_WORKERS_MAX: i32 = 64;
pub const CN_MAX_HANDLES: i32 = 1048575;
pub const CN_DEFAULT: i32 = -1;
pub const CN_OK: i32 = 0;
pub const CN_ERROR_ARGUMENT: i32 = -1;
pub const CN_ERROR_HANDLE: i32 = -2;
pub const CN_ERROR_MEMORY: i32 = -3;
pub const CN_ERROR_LOCKED: i32 = -4;
pub const CN_ERROR_CAPACITY: i32 = -5;
pub const CN_ERROR_STATE: i32 = -6;
pub const CN_ERROR_INTERNAL: i32 = -7;
pub const CN_ERROR_FORMAT: i32 = -8;
pub const CN_TYPE_VEC2: i32 = 0;
pub const CN_TYPE_POSE: i32 = 1;
pub const CN_TYPE_VELOCITY: i32 = 2;
pub const CN_TYPE_AABB: i32 = 3;
pub const CN_TYPE_MASS_DATA: i32 = 4;
pub const CN_TYPE_WORLD_DEF: i32 = 5;
pub const CN_TYPE_BODY_DEF: i32 = 6;
pub const CN_TYPE_SHAPE_DEF: i32 = 7;
pub const CN_TYPE_CIRCLE: i32 = 8;
pub const CN_TYPE_CAPSULE: i32 = 9;
pub const CN_TYPE_EDGE: i32 = 10;
pub const CN_TYPE_POLYGON: i32 = 11;
pub const CN_TYPE_CHAIN: i32 = 12;
pub const CN_TYPE_FILTER: i32 = 13;
pub const CN_TYPE_MATERIAL: i32 = 14;
pub const CN_TYPE_MANIFOLD_POINT: i32 = 15;
pub const CN_TYPE_MANIFOLD: i32 = 16;
pub const CN_TYPE_CONTACT_EVENT: i32 = 17;
pub const CN_TYPE_BODY_MOVED: i32 = 18;
pub const CN_TYPE_REVOLUTE_DEF: i32 = 19;
pub const CN_TYPE_DISTANCE_DEF: i32 = 20;
pub const CN_TYPE_COUNTERS: i32 = 21;
pub const CN_TYPE_PROFILE: i32 = 22;
pub const CN_TYPE_MEMORY_STATS: i32 = 23;
pub const CN_TYPE_SENSOR_EVENT: i32 = 24;
pub const CN_TYPE_UPDATE_REPORT: i32 = 25;
pub const CN_TYPE_DEBUG_DRAW: i32 = 26;
pub const CN_TYPE_QUERY_FILTER: i32 = 27;
pub const CN_TYPE_RAY: i32 = 28;
pub const CN_TYPE_RAY_HIT: i32 = 29;
pub const CN_TYPE_CLOSEST: i32 = 30;
pub const CN_TYPE_EXPLOSION_DEF: i32 = 31;
pub const CN_TYPE_FIXED_DEF: i32 = 32;
pub const CN_TYPE_PRISMATIC_DEF: i32 = 33;
pub const CN_TYPE_WHEEL_DEF: i32 = 34;
pub const CN_TYPE_MOTOR_DEF: i32 = 35;
pub const CN_TYPE_MOUSE_DEF: i32 = 36;
pub const CN_TYPE_GEAR_DEF: i32 = 37;
pub const CN_TYPE_PULLEY_DEF: i32 = 38;
pub const CN_TYPE_RATCHET_DEF: i32 = 39;
pub const CN_TYPE_ROTARY_SPRING_DEF: i32 = 40;
pub const CN_TYPE_GROOVE_DEF: i32 = 41;
pub const CN_TYPE_FILTER_JOINT_DEF: i32 = 42;
pub const CN_TYPE_JOINT_BASE: i32 = 43;
pub const CN_TYPE_JOINT_EVENT: i32 = 44;
pub const CN_TYPE_ANGLE_CONSTRAINT_DEF: i32 = 45;
pub const CN_TYPE_LINE_CONSTRAINT_DEF: i32 = 46;
pub const CN_TYPE_ISLAND_REPORT: i32 = 47;
pub const CN_TYPE_DISTANCE: i32 = 48;
pub const CN_TYPE_SWEEP: i32 = 49;
pub const CN_TYPE_IMPACT: i32 = 50;
pub const CN_TYPE_PLANE: i32 = 51;
pub const CN_TYPE_MOVER_DEF: i32 = 52;
pub const CN_TYPE_MOVER: i32 = 53;
pub const CN_TYPE_AREA_DEF: i32 = 54;
pub const CN_TYPE_COUNT: i32 = 55;
pub const CN_WORLD_SLEEP: u32 = 1;
pub const CN_WORLD_WARM_START: u32 = 2;
pub const CN_WORLD_PROFILE: u32 = 4;
pub const CN_WORLD_CONTINUOUS: u32 = 8;
pub const CN_RESERVE_NAMES: u32 = 1;
pub const CN_RESERVE_CHAINS: u32 = 2;
pub const CN_RESERVE_EXTRA_ROWS: u32 = 4;
pub const CN_RESERVE_MOVED: u32 = 8;
pub const CN_SOLVER_AUTO: i32 = 0;
pub const CN_SOLVER_SOFT: i32 = 1;
pub const CN_SOLVER_DIRECT: i32 = 2;
pub const CN_SOLVER_SEQUENTIAL: i32 = 3;
pub const CN_BROADPHASE_SWEEP: i32 = 0;
pub const CN_BROADPHASE_TREE: i32 = 1;
pub const CN_WARNING_CONTACT_MEMORY: u32 = 1;
pub const CN_WARNING_FRAME_MEMORY: u32 = 2;
pub const CN_WARNING_EVENT_MEMORY: u32 = 4;
pub const CN_WARNING_CROWD: u32 = 8;
pub const CN_WARNING_NOT_FINITE: u32 = 16;
pub const CN_TIER_SOFT: i32 = 0;
pub const CN_TIER_DIRECT: i32 = 1;
pub const CN_TIER_FREE: i32 = 2;
pub const CN_TIER_REASON_NONE: i32 = 0;
pub const CN_TIER_REASON_SETTLING: i32 = 1;
pub const CN_TIER_REASON_NEW_CONTACT: i32 = 2;
pub const CN_TIER_REASON_OVERLAP: i32 = 3;
pub const CN_TIER_REASON_JOINT: i32 = 4;
pub const CN_TIER_REASON_STRESSED: i32 = 5;
pub const CN_TIER_REASON_SOLVER: i32 = 6;
pub const CN_TIER_REASON_OVERRIDE: i32 = 7;
pub const CN_TIER_REASON_ALONE: i32 = 8;
pub const CN_TIER_REASON_MOVING: i32 = 9;
pub const CN_TIER_REASON_CROWDED: i32 = 10;
pub const CN_TIER_REASON_WORK: i32 = 11;
pub const CN_TIER_REASON_KIND: i32 = 12;
pub const CN_TIER_REASON_NO_SET: i32 = 13;
pub const CN_TIER_REASON_MEMORY: i32 = 14;
pub const CN_TIER_REASON_JOINTED: i32 = 15;
pub const CN_BODY_STATIC: i32 = 0;
pub const CN_BODY_KINEMATIC: i32 = 1;
pub const CN_BODY_DYNAMIC: i32 = 2;
pub const CN_BODY_LOCK_X: u32 = 1;
pub const CN_BODY_LOCK_Y: u32 = 2;
pub const CN_BODY_LOCK_ROTATION: u32 = 4;
pub const CN_BODY_BULLET: u32 = 8;
pub const CN_BODY_ENABLED: u32 = 16;
pub const CN_BODY_SLEEP: u32 = 32;
pub const CN_BODY_AWAKE: u32 = 64;
pub const CN_SHAPE_CIRCLE: i32 = 0;
pub const CN_SHAPE_CAPSULE: i32 = 1;
pub const CN_SHAPE_POLYGON: i32 = 2;
pub const CN_SHAPE_EDGE: i32 = 3;
pub const CN_SHAPE_CHAIN: i32 = 4;
pub const CN_MIX_AVERAGE: i32 = 0;
pub const CN_MIX_GEOMETRIC: i32 = 1;
pub const CN_MIX_MINIMUM: i32 = 2;
pub const CN_MIX_MULTIPLY: i32 = 3;
pub const CN_MIX_MAXIMUM: i32 = 4;
pub const CN_SHAPE_SENSOR: u32 = 1;
pub const CN_SHAPE_SENSOR_SEEN: u32 = 2;
pub const CN_SHAPE_ONE_WAY: u32 = 4;
pub const CN_SHAPE_PRE_SOLVE: u32 = 8;
pub const CN_EVENT_CREATED: i32 = 0;
pub const CN_EVENT_ENTER: i32 = 1;
pub const CN_EVENT_STAY: i32 = 2;
pub const CN_EVENT_LEAVE: i32 = 3;
pub const CN_EVENT_DESTROYED: i32 = 4;
pub const CN_EVENT_HIT: i32 = 5;
pub const CN_EVENT_KINDS: i32 = 6;
pub const CN_JOINT_REVOLUTE: i32 = 0;
pub const CN_JOINT_DISTANCE: i32 = 1;
pub const CN_JOINT_FIXED: i32 = 2;
pub const CN_JOINT_PRISMATIC: i32 = 3;
pub const CN_JOINT_WHEEL: i32 = 4;
pub const CN_JOINT_MOTOR_TO: i32 = 5;
pub const CN_JOINT_MOUSE: i32 = 6;
pub const CN_JOINT_GEAR: i32 = 7;
pub const CN_JOINT_PULLEY: i32 = 8;
pub const CN_JOINT_RATCHET: i32 = 9;
pub const CN_JOINT_ROTARY_SPRING: i32 = 10;
pub const CN_JOINT_GROOVE: i32 = 11;
pub const CN_JOINT_FILTER: i32 = 12;
pub const CN_JOINT_COLLIDE: u32 = 1;
pub const CN_JOINT_LIMIT: u32 = 2;
pub const CN_JOINT_MOTOR: u32 = 4;
pub const CN_JOINT_SPRING: u32 = 8;
pub const CN_JOINT_BREAKS: u32 = 16;
pub const CN_CONSTRAINT_ANGLE: i32 = 0;
pub const CN_CONSTRAINT_LINE: i32 = 1;
pub const CN_CONSTRAINT_LIMIT: u32 = 1;
pub const CN_CONSTRAINT_BREAKS: u32 = 2;
pub const CN_QUERY_SKIP: i32 = 0;
pub const CN_QUERY_TAKE: i32 = 1;
pub const CN_QUERY_STOP: i32 = 2;
pub const CN_QUERY_IGNORE_JOINED: u32 = 1;
pub const CN_QUERY_ONE_WAY: u32 = 2;
pub const CN_QUERY_LEAVING: u32 = 4;
pub const CN_IMPACT_NONE: i32 = 0;
pub const CN_IMPACT_HIT: i32 = 1;
pub const CN_IMPACT_OVERLAP: i32 = 2;
pub const CN_IMPACT_FAILED: i32 = 3;
pub const CN_MOVER_DROP: u32 = 1;
pub const CN_MOVER_ON_GROUND: u32 = 1;
pub const CN_MOVER_ON_WALL: u32 = 2;
pub const CN_MOVER_ON_CEILING: u32 = 4;
pub const CN_AREA_REPLACE: u32 = 1;
pub const CN_DRAW_SHAPES: u32 = 1;
pub const CN_DRAW_JOINTS: u32 = 2;
pub const CN_DRAW_CONTACTS: u32 = 4;
pub const CN_DRAW_AABBS: u32 = 8;
pub const CN_DRAW_CENTERS: u32 = 16;
pub const CN_DRAW_ISLANDS: u32 = 32;

/// CN_OK or a CN_ERROR_
pub type cn_result = i32;

/// handle of a body; 0: none
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct cn_body(pub u32);

/// handle of a shape; 0: none
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct cn_shape(pub u32);

/// handle of a joint; 0: none
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct cn_joint(pub u32);

/// handle of a constraint on one body; 0: none
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct cn_constraint(pub u32);

/// a world with everything in it
#[repr(C)]
pub struct cn_world {
    _private: [u8; 0],
    _pinned: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A dynamic AABB tree apart from any world. One thread at a time may change it; several may search it while
/// nothing changes it.
#[repr(C)]
pub struct cn_tree {
    _private: [u8; 0],
    _pinned: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Memory hook: allocates bytes aligned to align, a power of two of at most 64; returns NULL when there is no
/// memory. Called only from inside functions that take a non-const world.
pub type cn_alloc_fn = unsafe extern "C" fn(bytes: u64, align: u32, user: *mut c_void) -> *mut c_void;

/// Memory hook: frees memory of cn_alloc_fn; bytes is the size it was allocated with.
pub type cn_free_fn = unsafe extern "C" fn(memory: *mut c_void, bytes: u64, user: *mut c_void);

/// The library's part of a user's task system (cn_world_def.enqueue and finish, for worlds with worker_count
/// of 2 or more; without them the world starts its own threads). Call it for ranges \[begin, end) that
/// together cover 0 to item_count - 1, each item once, on any threads, in any order. A call may last as long
/// as the step and may wait for calls that have begun, never for one that has not. Its thread must have the
/// floating-point mode of the stepping thread.
pub type cn_task_fn = unsafe extern "C" fn(begin: i32, end: i32, context: *mut c_void);

/// Starts a task of item_count items (worker_count - 1) in ranges of at least min_range and returns a handle
/// for finish. It may run the whole task at once, and must do so if it cannot store the task; it then returns
/// NULL, and finish is not called. A step with enough work enqueues 3 to 10 tasks; enqueue and finish run in
/// the stepping thread, never during a callback, and must not call the library.
pub type cn_enqueue_fn = unsafe extern "C" fn(task: Option<cn_task_fn>, context: *mut c_void, item_count: i32, min_range: i32, user: *mut c_void) -> *mut c_void;

/// Returns when every item of the task has run; it may run items itself. Called once for each enqueue that
/// did not return NULL, in the thread that enqueued.
pub type cn_finish_fn = unsafe extern "C" fn(task: *mut c_void, user: *mut c_void);

/// Called at the end of cn_world_step for each event of this kind, in the order of the array.
pub type cn_contact_event_fn = unsafe extern "C" fn(world: *mut cn_world, event: *const cn_contact_event, user: *mut c_void);

/// Returns 1 if two shapes that pass their filters may touch, else 0. Called when their boxes begin to
/// overlap; the world is locked.
pub type cn_filter_fn = unsafe extern "C" fn(world: *mut cn_world, shape_a: cn_shape, shape_b: cn_shape, user: *mut c_void) -> i32;

/// Called in every step, before solving, for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE; the
/// event's kind is STAY or ENTER. Returns 0 to let the pair pass through each other in this step, else 1.
pub type cn_pre_solve_fn = unsafe extern "C" fn(world: *mut cn_world, contact: *const cn_contact_event, user: *mut c_void) -> i32;

/// Mixes two materials instead of the CN_MIX_ rules: *mixed holds the rules' result and takes the new one.
/// Called when a pair begins to touch and when a material changes.
pub type cn_material_mix_fn = unsafe extern "C" fn(world: *mut cn_world, shape_a: cn_shape, shape_b: cn_shape, mixed: *mut cn_material, user: *mut c_void);

/// Called by a query for each shape (edge of a chain) found, in no particular order and perhaps more than
/// once: the result, CN_QUERY_*, must depend on the shape alone. hit is complete in casts; other queries set
/// shape, body and child. May call only functions that take a const world, also of the same world.
pub type cn_query_fn = unsafe extern "C" fn(world: *const cn_world, hit: *const cn_ray_hit, user: *mut c_void) -> i32;

/// count points, counter-clockwise
pub type cn_debug_draw_polygon_fn = unsafe extern "C" fn(points_m: *const cn_vec2, count: i32, radius_m: f32, color: u32, user: *mut c_void);

/// rim_m: a point on the rim that turns with the body
pub type cn_debug_draw_circle_fn = unsafe extern "C" fn(center_m: *const cn_vec2, radius_m: f32, rim_m: *const cn_vec2, color: u32, user: *mut c_void);

/// a disc swept from a to b
pub type cn_debug_draw_capsule_fn = unsafe extern "C" fn(a_m: *const cn_vec2, b_m: *const cn_vec2, radius_m: f32, color: u32, user: *mut c_void);

/// a line from a to b
pub type cn_debug_draw_segment_fn = unsafe extern "C" fn(a_m: *const cn_vec2, b_m: *const cn_vec2, color: u32, user: *mut c_void);

/// size in pixels
pub type cn_debug_draw_point_fn = unsafe extern "C" fn(point_m: *const cn_vec2, size_px: f32, color: u32, user: *mut c_void);

/// zero-terminated, valid during the call
pub type cn_debug_draw_text_fn = unsafe extern "C" fn(point_m: *const cn_vec2, text: *const c_char, color: u32, user: *mut c_void);

/// Returns 0 to stop the search, any other value to continue.
pub type cn_tree_query_fn = unsafe extern "C" fn(item: u32, user_data: u64, user: *mut c_void) -> i32;

/// Returns the fraction at which the ray now ends: the given one to ignore the item, 0 to stop.
pub type cn_tree_ray_fn = unsafe extern "C" fn(item: u32, user_data: u64, fraction: f32, user: *mut c_void) -> f32;

/// A point, vector or pair of numbers.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_vec2 {
    /// to the right
    pub x: f32,
    /// upwards
    pub y: f32,
}
const _: () = assert!(core::mem::size_of::<cn_vec2>() == 8 || core::mem::size_of::<usize>() != 8);

/// Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
/// uploaded to a GPU directly.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_pose {
    /// of the body's origin
    pub position_m: cn_vec2,
    /// of the angle
    pub cosine: f32,
    /// of the angle
    pub sine: f32,
}
const _: () = assert!(core::mem::size_of::<cn_pose>() == 16 || core::mem::size_of::<usize>() != 8);

/// Velocity of a body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_velocity {
    /// of the centre of mass
    pub linear_mps: cn_vec2,
    /// counter-clockwise is positive
    pub angular_radps: f32,
}
const _: () = assert!(core::mem::size_of::<cn_velocity>() == 12 || core::mem::size_of::<usize>() != 8);

/// Axis-aligned bounding box, lower_m <= upper_m.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_aabb {
    /// left and bottom
    pub lower_m: cn_vec2,
    /// right and top
    pub upper_m: cn_vec2,
}
const _: () = assert!(core::mem::size_of::<cn_aabb>() == 16 || core::mem::size_of::<usize>() != 8);

/// Mass, inertia and centre of mass.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_mass_data {
    /// of all shapes, or as set
    pub mass_kg: f32,
    /// about the centre of mass
    pub inertia_kgm2: f32,
    /// in the body's local frame
    pub center_m: cn_vec2,
}
const _: () = assert!(core::mem::size_of::<cn_mass_data>() == 16 || core::mem::size_of::<usize>() != 8);

/// Definition of a world.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_world_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS
    pub flags: u32,
    /// default (0, -10)
    pub gravity_mps2: cn_vec2,
    /// a typical object's size, (0, 1e6\]; slop, margins and speed limits scale with it; default 1
    pub length_unit_m: f32,
    /// CN_SOLVER_*; default CN_SOLVER_AUTO
    pub solver: i32,
    /// CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP
    pub broadphase: i32,
    /// 1 to 64; default 4
    pub substep_count: i32,
    /// CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit
    pub accuracy_m: f32,
    /// limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
    /// included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
    /// CN_SOLVER_AUTO 512 contacts of a world
    pub work_budget: i32,
    /// slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit
    pub restitution_threshold_mps: f32,
    /// greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved
    /// joint closes (of its angles: rad/s, for each length unit), > 0; in a crowd the speeds of neighbours
    /// add up: n bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which
    /// pushes them upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit
    pub push_speed_max_mps: f32,
    /// faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit
    pub linear_speed_max_mps: f32,
    /// faster bodies are slowed to it, > 0; default 400
    pub angular_speed_max_radps: f32,
    /// bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit
    pub sleep_speed_mps: f32,
    /// ... after this time, >= 0; default 0.5
    pub sleep_delay_s: f32,
    /// hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0;
    /// default 0
    pub body_capacity: i32,
    /// counts every edge of a chain
    pub shape_capacity: i32,
    /// pairs whose fat AABBs overlap
    pub contact_capacity: i32,
    /// counts constraints too
    pub joint_capacity: i32,
    /// a number for the user; default 0
    pub user_data: u64,
    /// size of memory; 0: use alloc and free
    pub memory_bytes: u64,
    /// NULL, or one block aligned to 64 bytes that holds the whole world
    pub memory: *mut c_void,
    /// NULL: malloc; set both or none
    pub alloc: Option<cn_alloc_fn>,
    /// NULL: free
    pub free: Option<cn_free_fn>,
    /// last argument of alloc and free
    pub allocator_user: *mut c_void,
    /// NULL: the world's own threads; set both or none
    pub enqueue: Option<cn_enqueue_fn>,
    /// see cn_finish_fn
    pub finish: Option<cn_finish_fn>,
    /// last argument of enqueue and finish
    pub task_user: *mut c_void,
    /// threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no
    /// tasks
    pub worker_count: i32,
    /// blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit
    pub hit_speed_mps: f32,
    /// Of a world in one block (memory); others ignore them. pairs that touch at once, >= 0; further ones do
    /// not collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity
    pub touching_capacity: i32,
    /// pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which
    /// cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity
    pub event_capacity: i32,
    /// vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block;
    /// default CN_POLYGON_MAX_VERTICES
    pub vertex_capacity: i32,
    /// CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all
    pub reserve: u32,
}
impl Default for cn_world_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_world_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_world_def>() == 176 || core::mem::size_of::<usize>() != 8);

/// Counts of objects, and problems of the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_counters {
    /// alive
    pub bodies: i32,
    /// dynamic and kinematic bodies that are simulated
    pub bodies_awake: i32,
    /// alive
    pub shapes: i32,
    /// boxes in the broadphase: one per shape, one per edge of a chain
    pub proxies: i32,
    /// pairs whose fat boxes overlap
    pub contacts: i32,
    /// with an awake body
    pub contacts_awake: i32,
    /// pairs with a manifold, asleep or awake
    pub contacts_touching: i32,
    /// and constraints
    pub joints: i32,
    /// and constraints, with an awake body
    pub joints_awake: i32,
    /// awake and asleep; a single dynamic body counts
    pub islands: i32,
    /// of them
    pub islands_awake: i32,
    /// groups of contacts that share no dynamic body
    pub colors_used: i32,
    /// contacts that fit no colour: solved one by one
    pub overflow_contacts: i32,
    /// cells of the broadphase
    pub broadphase_tiles: i32,
    /// steps taken since creation, modulo 2^32
    pub steps: u32,
    /// Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try
    /// again. CN_WARNING_*
    pub warnings: u32,
    /// new pairs without a contact
    pub pairs_not_added: i32,
    /// events without a place in a log
    pub events_not_reported: i32,
    /// of several bodies, solved directly in the last step, contacts included
    pub islands_direct: i32,
    /// planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1
    pub direct_work: i32,
    /// of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET
    pub islands_unsolved: i32,
}
const _: () = assert!(core::mem::size_of::<cn_counters>() == 84 || core::mem::size_of::<usize>() != 8);

/// Report on one island.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_island_report {
    /// its body of least slot
    pub body: cn_body,
    /// dynamic
    pub bodies: i32,
    /// touching
    pub contacts: i32,
    /// and constraints
    pub joints: i32,
    /// CN_TIER_*, after the last step
    pub tier: i32,
    /// CN_TIER_REASON_*
    pub reason: i32,
    /// of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more
    pub substeps: i32,
    /// at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent);
    /// joints that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count
    pub residual_m: f32,
}
const _: () = assert!(core::mem::size_of::<cn_island_report>() == 32 || core::mem::size_of::<usize>() != 8);

/// Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_profile {
    /// the whole step
    pub step_s: f32,
    /// waking
    pub wake_s: f32,
    /// pairs
    pub broadphase_s: f32,
    /// manifolds
    pub narrowphase_s: f32,
    /// islands
    pub islands_s: f32,
    /// constraints, plans
    pub prepare_s: f32,
    /// all substeps
    pub substeps_s: f32,
    /// poses and boxes
    pub finalize_s: f32,
    /// callbacks
    pub events_s: f32,
    /// falling asleep
    pub sleep_s: f32,
}
const _: () = assert!(core::mem::size_of::<cn_profile>() == 40 || core::mem::size_of::<usize>() != 8);

/// Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
/// allocator serves small variable-size pieces from free lists of size classes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_memory_stats {
    /// taken from the user's allocator or carved from the fixed block
    pub bytes_in_use: u64,
    /// most bytes_in_use since creation
    pub bytes_peak: u64,
    /// calls of the user's alloc (or of the fixed block's) since creation
    pub allocator_calls: u64,
    /// of the frame arena
    pub arena_capacity: u64,
    /// most bytes in use at once since creation
    pub arena_peak: u64,
    /// entries that did not fit: the allocator served them; since creation
    pub arena_fallbacks: u64,
    /// bytes in chunks
    pub blocks_capacity: u64,
    /// bytes handed out of them
    pub blocks_in_use: u64,
    /// blocks above the largest class, served by the allocator
    pub blocks_large: u64,
}
const _: () = assert!(core::mem::size_of::<cn_memory_stats>() == 72 || core::mem::size_of::<usize>() != 8);

/// Definition of a body.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_body_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
    pub r#type: i32,
    /// of the origin; |x|, |y| <= 1e6 x length unit
    pub position_m: cn_vec2,
    /// |angle| <= 1e4
    pub angle_rad: f32,
    /// of the centre of mass; both velocities are ignored without CN_BODY_AWAKE
    pub linear_velocity_mps: cn_vec2,
    /// default 0
    pub angular_velocity_radps: f32,
    /// v' = -damping v; >= 0, default 0
    pub linear_damping_per_s: f32,
    /// >= 0, default 0
    pub angular_damping_per_s: f32,
    /// default 1
    pub gravity_scale: f32,
    /// >= 0; CN_DEFAULT (default): the world's
    pub sleep_speed_mps: f32,
    /// CN_BODY_*; default ENABLED | SLEEP | AWAKE
    pub flags: u32,
    /// as in cn_body_set_solver; default CN_SOLVER_AUTO
    pub solver: i32,
    /// a number for the user; default 0
    pub user_data: u64,
    /// NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
    pub name: *const c_char,
}
impl Default for cn_body_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_body_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_body_def>() == 72 || core::mem::size_of::<usize>() != 8);

/// A body that moved or fell asleep in the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_body_moved {
    /// after the step
    pub pose: cn_pose,
    /// the body's
    pub user_data: u64,
    /// that moved
    pub body: cn_body,
    /// 1 in the step in which it fell asleep
    pub fell_asleep: u32,
}
const _: () = assert!(core::mem::size_of::<cn_body_moved>() == 32 || core::mem::size_of::<usize>() != 8);

/// Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
/// collide if the category of each has a bit in the mask of the other.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_filter {
    /// default 1
    pub category: u64,
    /// default all ones
    pub mask: u64,
    /// default 0
    pub group: i32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_filter>() == 24 || core::mem::size_of::<usize>() != 8);

/// Surface of a shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_material {
    /// coefficient while sticking, \[0, 100\], default 0.6
    pub static_friction: f32,
    /// coefficient while sliding, \[0, static_friction\], default 0.6
    pub dynamic_friction: f32,
    /// \[0, 1\], default 0
    pub restitution: f32,
    /// metres, \[0, 1e3\]: lever arm that resists rolling; the pair takes the greater; default 0
    pub rolling_resistance: f32,
    /// conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; \[-1e4, 1e4\], default
    /// 0
    pub tangent_speed_mps: f32,
    /// CN_MIX_*; default CN_MIX_GEOMETRIC
    pub friction_mix: i32,
    /// CN_MIX_*; default CN_MIX_MAXIMUM
    pub restitution_mix: i32,
    /// a number for the user, reported in contact events; default 0
    pub user_id: u32,
}
const _: () = assert!(core::mem::size_of::<cn_material>() == 32 || core::mem::size_of::<usize>() != 8);

/// Definition of a shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_shape_def {
    /// set by the init function
    pub struct_size: u32,
    /// 0: create unattached, for cn_shape_attach
    pub body: cn_body,
    /// of the shape in the body's local frame
    pub offset_m: cn_vec2,
    /// of the shape in the body's local frame
    pub angle_rad: f32,
    /// >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
    pub density_kgpm2: f32,
    /// defaults: see cn_material
    pub material: cn_material,
    /// defaults: see cn_filter
    pub filter: cn_filter,
    /// bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE
    pub event_mask: u32,
    /// CN_SHAPE_SENSOR ...; default 0
    pub flags: u32,
    /// a number for the user; default 0
    pub user_data: u64,
}
impl Default for cn_shape_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_shape_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_shape_def>() == 96 || core::mem::size_of::<usize>() != 8);

/// A disc.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_circle {
    /// in the body's frame
    pub center_m: cn_vec2,
    /// > 0
    pub radius_m: f32,
}
const _: () = assert!(core::mem::size_of::<cn_circle>() == 12 || core::mem::size_of::<usize>() != 8);

/// All points within radius_m of the segment.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_capsule {
    /// one end of the segment, in the body's frame
    pub a_m: cn_vec2,
    /// the other end
    pub b_m: cn_vec2,
    /// around the segment, > 0
    pub radius_m: f32,
}
const _: () = assert!(core::mem::size_of::<cn_capsule>() == 20 || core::mem::size_of::<usize>() != 8);

/// A two-sided segment without mass.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_edge {
    /// one end, in the body's frame
    pub a_m: cn_vec2,
    /// the other end
    pub b_m: cn_vec2,
}
const _: () = assert!(core::mem::size_of::<cn_edge>() == 16 || core::mem::size_of::<usize>() != 8);

/// Convex polygon. Either winding is accepted; points are stored counter-clockwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_polygon {
    /// 3 to CN_POLYGON_MAX_VERTICES
    pub count: i32,
    /// rounding added outside the points, >= 0
    pub radius_m: f32,
    /// the first count of them; in the body's frame
    pub points_m: [cn_vec2; 16],
}
const _: () = assert!(core::mem::size_of::<cn_polygon>() == 136 || core::mem::size_of::<usize>() != 8);

/// One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is on
/// the left of the order of points and surface normals point to the right: points that run from +x to -x
/// collide from above, a counter-clockwise loop collides from outside.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_chain {
    /// copied
    pub points_m: *const cn_vec2,
    /// an open chain: >= 2; a loop: >= 3; at most 65535
    pub count: i32,
    /// 1: the last point joins the first
    pub r#loop: u32,
}
impl Default for cn_chain {
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}
const _: () = assert!(core::mem::size_of::<cn_chain>() == 16 || core::mem::size_of::<usize>() != 8);

/// One point of a contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_manifold_point {
    /// world, midway between the surfaces
    pub point_m: cn_vec2,
    /// negative when overlapping
    pub separation_m: f32,
    /// of the last substep
    pub normal_impulse_Ns: f32,
    /// the same while the same features touch
    pub feature_id: u32,
}
const _: () = assert!(core::mem::size_of::<cn_manifold_point>() == 20 || core::mem::size_of::<usize>() != 8);

/// How two shapes touch.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_manifold {
    /// unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the
    /// faces' by up to 0.1 rad, so that piles stand
    pub normal: cn_vec2,
    /// of the last substep, on body b along (normal.y, -normal.x)
    pub friction_impulse_Ns: f32,
    /// 0, 1 or 2
    pub point_count: i32,
    /// the first point_count of them
    pub points: [cn_manifold_point; 2],
}
const _: () = assert!(core::mem::size_of::<cn_manifold>() == 56 || core::mem::size_of::<usize>() != 8);

/// A contact event, or the present state of a contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_contact_event {
    /// one shape of the pair
    pub shape_a: cn_shape,
    /// the other
    pub shape_b: cn_shape,
    /// of shape_a
    pub body_a: cn_body,
    /// of shape_b
    pub body_b: cn_body,
    /// edge number within a chain, else 0
    pub child_a: i32,
    /// the same of shape b
    pub child_b: i32,
    /// the same from CREATED to DESTROYED, then reused
    pub contact_id: u32,
    /// CN_EVENT_*
    pub kind: i32,
    /// ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0
    pub approach_speed_mps: f32,
    /// geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT
    pub manifold: cn_manifold,
    /// Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
    /// cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact
    /// that its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean
    /// force is normal_impulse_Ns / dt_s
    pub normal_impulse_Ns: f32,
    /// along (normal.y, -normal.x), on body b
    pub friction_impulse_Ns: f32,
    /// HIT: where, in the world; else (0, 0)
    pub hit_point_m: cn_vec2,
    /// cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED
    pub material_a: u32,
    /// the same of shape_b
    pub material_b: u32,
}
const _: () = assert!(core::mem::size_of::<cn_contact_event>() == 116 || core::mem::size_of::<usize>() != 8);

/// A shape entered or left a sensor.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_sensor_event {
    /// the sensor
    pub sensor: cn_shape,
    /// the shape that it met
    pub visitor: cn_shape,
    /// the sensor's body
    pub sensor_body: cn_body,
    /// the visitor's body
    pub visitor_body: cn_body,
    /// CN_EVENT_ENTER or CN_EVENT_LEAVE
    pub kind: i32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_sensor_event>() == 24 || core::mem::size_of::<usize>() != 8);

/// First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
/// limits in place; springs and motors are not rigid parts.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_joint_base {
    /// of the whole definition
    pub struct_size: u32,
    /// CN_JOINT_*; default 0; a type ignores flags that it does not use
    pub flags: u32,
    /// 0: the world
    pub body_a: cn_body,
    /// 0: the world; one of the two must be dynamic
    pub body_b: cn_body,
    /// in body a's local frame, or in world coordinates
    pub anchor_a_m: cn_vec2,
    /// the same for body b
    pub anchor_b_m: cn_vec2,
    /// of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of
    /// all springs; CN_DEFAULT (default): as stiff as the substeps permit
    pub stiffness_hertz: f32,
    /// used with a stiffness_hertz; 0 to 1e6, default 0
    pub stiffness_damping_ratio: f32,
    /// greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded
    pub force_max_N: f32,
    /// greatest torque of angles, > 0; CN_DEFAULT (default): unbounded
    pub torque_max_Nm: f32,
    /// a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default):
    /// never
    pub break_force_N: f32,
    /// the same for the torque
    pub break_torque_Nm: f32,
    /// a number for the user; default 0
    pub user_data: u64,
}
const _: () = assert!(core::mem::size_of::<cn_joint_base>() == 64 || core::mem::size_of::<usize>() != 8);

/// Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi\].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_revolute_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// angle b - angle a at joint angle 0
    pub reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
    pub lower_angle_rad: f32,
    /// the upper limit
    pub upper_angle_rad: f32,
    /// CN_JOINT_MOTOR
    pub motor_speed_radps: f32,
    /// >= 0
    pub motor_torque_max_Nm: f32,
    /// CN_JOINT_SPRING: pulls the joint angle to this
    pub spring_target_rad: f32,
    /// 0 to 1e6
    pub spring_hertz: f32,
    /// 0 to 1e6
    pub spring_damping_ratio: f32,
}
impl Default for cn_revolute_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_revolute_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_revolute_def>() == 96 || core::mem::size_of::<usize>() != 8);

/// Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
/// length_m. With a spring, length_m is its rest length, and limits keep the distance within \[min, max\];
/// limits alone make a rope (min 0).
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_distance_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// > 0; default 1
    pub length_m: f32,
    /// CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
    pub length_min_m: f32,
    /// the upper limit
    pub length_max_m: f32,
    /// CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
    pub motor_speed_mps: f32,
    /// >= 0
    pub motor_force_max_N: f32,
    /// 0 to 1e6
    pub spring_hertz: f32,
    /// 0 to 1e6
    pub spring_damping_ratio: f32,
    /// 0
    pub reserved: f32,
}
impl Default for cn_distance_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_distance_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_distance_def>() == 96 || core::mem::size_of::<usize>() != 8);

/// Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_fixed_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// angle b - angle a
    pub reference_angle_rad: f32,
    /// stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's
    pub angular_hertz: f32,
    /// 0 to 1e6
    pub angular_damping_ratio: f32,
    /// 0
    pub reserved: f32,
}
impl Default for cn_fixed_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_fixed_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_fixed_def>() == 80 || core::mem::size_of::<usize>() != 8);

/// b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_prismatic_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (1, 0)
    pub axis: cn_vec2,
    /// angle b - angle a
    pub reference_angle_rad: f32,
    /// CN_JOINT_LIMIT: lower <= upper
    pub lower_m: f32,
    /// the upper limit
    pub upper_m: f32,
    /// CN_JOINT_MOTOR
    pub motor_speed_mps: f32,
    /// >= 0
    pub motor_force_max_N: f32,
    /// CN_JOINT_SPRING: pulls the translation to this
    pub spring_target_m: f32,
    /// 0 to 1e6
    pub spring_hertz: f32,
    /// 0 to 1e6
    pub spring_damping_ratio: f32,
}
impl Default for cn_prismatic_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_prismatic_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_prismatic_def>() == 104 || core::mem::size_of::<usize>() != 8);

/// A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
/// by the motor.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_wheel_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// in body a's frame, any length > 0 (read back with length 1); default (0, 1)
    pub axis: cn_vec2,
    /// CN_JOINT_LIMIT: lower <= upper
    pub lower_m: f32,
    /// the upper limit
    pub upper_m: f32,
    /// CN_JOINT_MOTOR
    pub motor_speed_radps: f32,
    /// >= 0
    pub motor_torque_max_Nm: f32,
    /// CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1
    pub spring_hertz: f32,
    /// 0 to 1e6, default 0.7
    pub spring_damping_ratio: f32,
}
impl Default for cn_wheel_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_wheel_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_wheel_def>() == 96 || core::mem::size_of::<usize>() != 8);

/// Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
/// base.torque_max_Nm must be > 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_motor_def {
    /// anchor b is driven to anchor a + offset
    pub base: cn_joint_base,
    /// in body a's frame
    pub offset_m: cn_vec2,
    /// angle b - angle a
    pub angle_rad: f32,
    /// frequency of the spring, > 0, to 1e6; default 5
    pub hertz: f32,
    /// 0 to 1e6, default 1
    pub damping_ratio: f32,
    /// 0
    pub reserved: f32,
}
impl Default for cn_motor_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_motor_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_motor_def>() == 88 || core::mem::size_of::<usize>() != 8);

/// Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
/// base.force_max_N must be > 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_mouse_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// world
    pub target_m: cn_vec2,
    /// > 0, to 1e6; default 5
    pub hertz: f32,
    /// 0 to 1e6, default 0.7
    pub damping_ratio: f32,
}
impl Default for cn_mouse_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_mouse_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_mouse_def>() == 80 || core::mem::size_of::<usize>() != 8);

/// angle b = ratio * angle a + phase. Angles begin in (-pi, pi\] at creation (or when the ratio is changed)
/// and count whole turns from there.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_gear_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// size 1e-4 to 1e4, negative: they turn against each other; default 1
    pub ratio: f32,
    /// default 0
    pub phase_rad: f32,
}
impl Default for cn_gear_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_gear_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_gear_def>() == 72 || core::mem::size_of::<usize>() != 8);

/// A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never
/// pushes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_pulley_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// world
    pub ground_a_m: cn_vec2,
    /// world
    pub ground_b_m: cn_vec2,
    /// 1e-4 to 1e4; default 1
    pub ratio: f32,
    /// > 0: must be set
    pub length_m: f32,
}
impl Default for cn_pulley_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_pulley_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_pulley_def>() == 88 || core::mem::size_of::<usize>() != 8);

/// b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase
/// + n * click_rad for every whole number n, over whole turns.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_ratchet_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// default 0
    pub phase_rad: f32,
    /// size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise
    pub click_rad: f32,
}
impl Default for cn_ratchet_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_ratchet_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_ratchet_def>() == 72 || core::mem::size_of::<usize>() != 8);

/// A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
/// the two bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_rotary_spring_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// default 0
    pub rest_angle_rad: f32,
    /// > 0, to 1e6; default 1
    pub hertz: f32,
    /// 0 to 1e6, default 0
    pub damping_ratio: f32,
    /// 0
    pub reserved: f32,
}
impl Default for cn_rotary_spring_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_rotary_spring_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_rotary_spring_def>() == 80 || core::mem::size_of::<usize>() != 8);

/// Anchor b slides in a slot of body a from anchor a to end_m.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_groove_def {
    /// what every joint has
    pub base: cn_joint_base,
    /// in body a's frame; not equal to anchor a; default (1, 0)
    pub end_m: cn_vec2,
}
impl Default for cn_groove_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_groove_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_groove_def>() == 72 || core::mem::size_of::<usize>() != 8);

/// The two bodies do not collide; no other effect.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_filter_joint_def {
    /// what every joint has
    pub base: cn_joint_base,
}
impl Default for cn_filter_joint_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_filter_joint_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_filter_joint_def>() == 64 || core::mem::size_of::<usize>() != 8);

/// A joint or constraint exceeded a break threshold or was destroyed with a body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_joint_event {
    /// 0: it was a constraint; stale when destroyed is 1
    pub joint: cn_joint,
    /// 0: it was a joint; stale when destroyed is 1
    pub constraint: cn_constraint,
    /// 0: the world
    pub body_a: cn_body,
    /// 0: the world
    pub body_b: cn_body,
    /// largest reaction of the step; 0 when a body was destroyed
    pub force_N: f32,
    /// the same for the torque
    pub torque_Nm: f32,
    /// 1: it broke, or one of its bodies was destroyed
    pub destroyed: u32,
    /// 0
    pub reserved: u32,
    /// the joint's or constraint's
    pub user_data: u64,
}
const _: () = assert!(core::mem::size_of::<cn_joint_event>() == 40 || core::mem::size_of::<usize>() != 8);

/// Keeps a body's angle within limits. The angle begins in (-pi, pi\] at creation and counts whole turns from
/// there.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_angle_constraint_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_CONSTRAINT_*; default 0
    pub flags: u32,
    /// must be dynamic
    pub body: cn_body,
    /// lower <= upper; equal: locked
    pub lower_rad: f32,
    /// the upper limit
    pub upper_rad: f32,
    /// > 0, to 1e6; CN_DEFAULT (default): rigid
    pub hertz: f32,
    /// used with a hertz; 0 to 1e6
    pub damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
    pub break_torque_Nm: f32,
    /// a number for the user; default 0
    pub user_data: u64,
}
impl Default for cn_angle_constraint_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_angle_constraint_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_angle_constraint_def>() == 40 || core::mem::size_of::<usize>() != 8);

/// Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along
/// the line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_line_constraint_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_CONSTRAINT_*; default 0
    pub flags: u32,
    /// must be dynamic
    pub body: cn_body,
    /// in the body's frame
    pub anchor_m: cn_vec2,
    /// of the line, world
    pub origin_m: cn_vec2,
    /// world, any length > 0 (read back with length 1); default (1, 0)
    pub axis: cn_vec2,
    /// >= 0: free play across the axis
    pub tolerance_m: f32,
    /// CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper
    pub lower_m: f32,
    /// the upper limit
    pub upper_m: f32,
    /// > 0, to 1e6; CN_DEFAULT (default): rigid
    pub hertz: f32,
    /// used with a hertz; 0 to 1e6
    pub damping_ratio: f32,
    /// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
    pub break_force_N: f32,
    /// 0
    pub reserved: u32,
    /// a number for the user; default 0
    pub user_data: u64,
}
impl Default for cn_line_constraint_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_line_constraint_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_line_constraint_def>() == 72 || core::mem::size_of::<usize>() != 8);

/// Result of cn_world_update.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_update_report {
    /// fixed steps taken
    pub steps: i32,
    /// time kept for the next update
    pub leftover_s: f32,
    /// time discarded because of steps_max
    pub dropped_s: f32,
    /// leftover_s / fixed step, \[0, 1): factor for cn_world_read_poses_interpolated
    pub interpolation: f32,
}
const _: () = assert!(core::mem::size_of::<cn_update_report>() == 16 || core::mem::size_of::<usize>() != 8);

/// A ray with an end.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_ray {
    /// world
    pub origin_m: cn_vec2,
    /// at most 2e6 length units each way; 0 hits only shapes around the origin
    pub translation_m: cn_vec2,
}
const _: () = assert!(core::mem::size_of::<cn_ray>() == 16 || core::mem::size_of::<usize>() != 8);

/// What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
/// shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
/// depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_ray_hit {
    /// 0: nothing was hit
    pub shape: cn_shape,
    /// the shape's
    pub body: cn_body,
    /// edge of a chain
    pub child: i32,
    /// of the translation, \[0, 1\]; 1 when nothing was hit
    pub fraction: f32,
    /// on the surface of the shape that was hit
    pub point_m: cn_vec2,
    /// unit, out of the shape that was hit
    pub normal: cn_vec2,
    /// depth of the start inside it, 0 outside
    pub depth_m: f32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_ray_hit>() == 40 || core::mem::size_of::<usize>() != 8);

/// Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
/// bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
/// steps.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_query_filter {
    /// default 1
    pub category: u64,
    /// default all ones
    pub mask: u64,
    /// its shapes are ignored; 0 (default): none. A stale handle is an error
    pub ignored_body: cn_body,
    /// CN_QUERY_IGNORE_JOINED ...; default 0
    pub flags: u32,
    /// NULL (default): take all shapes
    pub visit: Option<cn_query_fn>,
    /// last argument of visit
    pub user: *mut c_void,
}
impl Default for cn_query_filter {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_query_filter_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_query_filter>() == 40 || core::mem::size_of::<usize>() != 8);

/// The shape nearest to a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_closest {
    /// 0: nothing within the distance
    pub shape: cn_shape,
    /// the shape's
    pub body: cn_body,
    /// edge of a chain
    pub child: i32,
    /// negative: depth inside a shape with area
    pub distance_m: f32,
    /// on the surface
    pub point_m: cn_vec2,
    /// outward there; of edges and chains towards the point
    pub normal: cn_vec2,
}
const _: () = assert!(core::mem::size_of::<cn_closest>() == 32 || core::mem::size_of::<usize>() != 8);

/// Distance of two shapes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_distance {
    /// on the surface of a, in the world
    pub point_a_m: cn_vec2,
    /// on the surface of b
    pub point_b_m: cn_vec2,
    /// unit, from a to b
    pub normal: cn_vec2,
    /// of the surfaces; negative: the depth, the shortest translation of b out of a
    pub distance_m: f32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_distance>() == 32 || core::mem::size_of::<usize>() != 8);

/// A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about it
/// at a constant rate.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_sweep {
    /// of the shape, before the motion
    pub start: cn_pose,
    /// that point, in the shape's frame: the centre of mass of a body
    pub center_m: cn_vec2,
    /// of it; at most 2e6 m each way
    pub translation_m: cn_vec2,
    /// counter-clockwise, |turn| <= 1e4
    pub turn_rad: f32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_sweep>() == 40 || core::mem::size_of::<usize>() != 8);

/// Result of cn_polygon_time_of_impact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_impact {
    /// CN_IMPACT_*
    pub state: i32,
    /// of both motions, \[0, 1\]
    pub fraction: f32,
    /// HIT only, as are the next two: between the surfaces
    pub point_m: cn_vec2,
    /// unit, from a to b
    pub normal: cn_vec2,
    /// of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it
    pub distance_m: f32,
    /// 0
    pub reserved: u32,
}
const _: () = assert!(core::mem::size_of::<cn_impact>() == 32 || core::mem::size_of::<usize>() != 8);

/// A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0, unless
/// that needs a push of more than push_max_m.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_plane {
    /// unit, from the surface to the shape
    pub normal: cn_vec2,
    /// world point of least distance
    pub point_m: cn_vec2,
    /// of the surfaces along the normal; negative: they overlap
    pub separation_m: f32,
    /// greatest push of this plane, >= 0; FLT_MAX: rigid
    pub push_max_m: f32,
    /// its push in the last cn_mover_solve
    pub push_m: f32,
    /// whose surface it is
    pub shape: cn_shape,
    /// the shape's
    pub body: cn_body,
    /// edge of a chain
    pub child: i32,
}
const _: () = assert!(core::mem::size_of::<cn_plane>() == 40 || core::mem::size_of::<usize>() != 8);

/// How a character moves. It may change between moves: crouching is another shape.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_mover_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_MOVER_DROP; default 0
    pub flags: u32,
    /// around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule
    /// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
    pub shape: cn_polygon,
    /// shapes that it collides with; sensors never, one-way shapes from above
    pub filter: cn_query_filter,
    /// any length > 0; default (0, 1)
    pub up: cn_vec2,
    /// greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)
    pub slope_limit_rad: f32,
    /// greatest height of steps that it climbs, >= 0; default 0.3
    pub step_height_m: f32,
    /// a walking character follows ground that falls by up to this in a move, >= 0; default 0.3
    pub snap_m: f32,
    /// of the world's gravity in the air; default 1
    pub gravity_scale: f32,
    /// greatest push on a dynamic body, >= 0; default 200
    pub push_force_N: f32,
    /// of sliding, 1 to 64; default 8
    pub iterations_max: i32,
}
impl Default for cn_mover_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_mover_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_mover_def>() == 216 || core::mem::size_of::<usize>() != 8);

/// State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
/// world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
/// filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
/// position.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct cn_mover {
    /// of the shape's origin, world
    pub position_m: cn_vec2,
    /// in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as
    /// its component across up; the one along up is 0, and a jump when the caller makes it > 0
    pub velocity_mps: cn_vec2,
    /// of the ground with CN_MOVER_ON_GROUND, else (0, 0)
    pub ground_normal: cn_vec2,
    /// in the world, after the move
    pub ground_point_m: cn_vec2,
    /// ... in the frame of ground_body
    pub ground_local_m: cn_vec2,
    /// of the ground there
    pub ground_velocity_mps: cn_vec2,
    /// 0: none; a stale handle counts as none
    pub ground_body: cn_body,
    /// the same for its shape
    pub ground_shape: cn_shape,
    /// CN_MOVER_ON_*, after the last move
    pub flags: u32,
    /// overlap with surfaces that leave it no room; else 0 up to rounding
    pub squeezed_m: f32,
}
const _: () = assert!(core::mem::size_of::<cn_mover>() == 64 || core::mem::size_of::<usize>() != 8);

/// What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity.
/// Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
/// accelerations, damping and forces add up.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct cn_area_def {
    /// set by the init function
    pub struct_size: u32,
    /// CN_AREA_REPLACE; default 0
    pub flags: u32,
    /// default 0
    pub priority: i32,
    /// acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)
    pub gravity_mps2: cn_vec2,
    /// of pull_mps2, in the frame of the sensor's body; default (0, 0)
    pub center_m: cn_vec2,
    /// acceleration towards center_m; negative pushes; default 0
    pub pull_mps2: f32,
    /// CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with
    /// its inverse square outside, and falling to 0 at the centre: a homogeneous planet
    pub pull_distance_m: f32,
    /// of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
    /// density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0
    pub linear_damping_per_s: f32,
    /// ... of the rotation; 0 to 1e9, default 0
    pub angular_damping_per_s: f32,
    /// of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default
    /// 0
    pub density_kgpm2: f32,
    /// density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0
    pub drag_kgpm2: f32,
    /// density times lift coefficient; 0 to 1e9, default 0
    pub lift_kgpm2: f32,
    /// velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)
    pub flow_mps: cn_vec2,
}
impl Default for cn_area_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_area_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_area_def>() == 64 || core::mem::size_of::<usize>() != 8);

/// Definition of an explosion.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_explosion_def {
    /// set by the init function
    pub struct_size: u32,
    /// full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1
    pub radius_m: f32,
    /// then linearly to 0 over this distance, 0 to 1e6 length units; default 0
    pub falloff_m: f32,
    /// per metre of the shape's width seen from the centre; negative pulls; default 0
    pub impulse_Nspm: f32,
    /// world
    pub center_m: cn_vec2,
    /// which shapes; defaults: see cn_query_filter
    pub filter: cn_query_filter,
}
impl Default for cn_explosion_def {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_explosion_def_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_explosion_def>() == 64 || core::mem::size_of::<usize>() != 8);

/// The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
/// coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct cn_debug_draw {
    /// set by the init function
    pub struct_size: u32,
    /// CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
    pub flags: u32,
    /// things outside are not drawn; default everything
    pub view: cn_aabb,
    /// count points, counter-clockwise
    pub polygon: Option<cn_debug_draw_polygon_fn>,
    /// rim_m: a point on the rim that turns with the body
    pub circle: Option<cn_debug_draw_circle_fn>,
    /// a disc swept from a to b
    pub capsule: Option<cn_debug_draw_capsule_fn>,
    /// a line from a to b
    pub segment: Option<cn_debug_draw_segment_fn>,
    /// size in pixels
    pub point: Option<cn_debug_draw_point_fn>,
    /// zero-terminated, valid during the call
    pub text: Option<cn_debug_draw_text_fn>,
    /// last argument of the functions
    pub user: *mut c_void,
    /// 0
    pub reserved: *mut c_void,
}
impl Default for cn_debug_draw {
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        unsafe { cn_debug_draw_init(&mut value) };
        value
    }
}
const _: () = assert!(core::mem::size_of::<cn_debug_draw>() == 88 || core::mem::size_of::<usize>() != 8);

extern "C" {
    /// Version of the library as major * 1000000 + minor * 1000 + patch.
    pub fn cn_version() -> i32;
    /// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
    pub fn cn_abi_version() -> i32;
    /// English text for a result code: static, never NULL.
    pub fn cn_result_text(result: cn_result) -> *const c_char;
    /// sizeof the struct that a CN_TYPE_ constant names, 0 for an unknown constant; bindings check their
    /// layouts with it.
    pub fn cn_sizeof(r#type: i32) -> i32;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing. Defaults that scale with
    /// the length unit are stored as CN_DEFAULT, which cn_world_create resolves.
    pub fn cn_world_def_init(def: *mut cn_world_def);
    /// Checks a definition. Writes one sentence about its first error, at most text_bytes (>= 0) bytes with
    /// the terminating zero; text may be NULL when text_bytes is 0.
    pub fn cn_world_def_check(def: *const cn_world_def, text: *mut c_char, text_bytes: i32) -> cn_result;
    /// Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL
    /// here.
    pub fn cn_world_bytes_needed(def: *const cn_world_def, out_bytes: *mut u64) -> cn_result;
    /// Creates a world. CN_ERROR_MEMORY also when a thread cannot be started. Each worker takes about 150
    /// bytes of the world's memory; its stack comes from the system, even for a world in a caller's block.
    /// Without thread support (CN_NO_THREADS, or an unknown system) the world has one worker: see
    /// cn_world_get_worker_count. O(capacities).
    pub fn cn_world_create(def: *const cn_world_def, out_world: *mut *mut cn_world) -> cn_result;
    /// Destroys a world, everything in it and its threads. A caller's block is free for other use afterwards.
    /// NULL, and a call from a callback, do nothing. O(memory blocks).
    pub fn cn_world_destroy(world: *mut cn_world);
    /// Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
    /// O(awake bodies and their contacts and joints).
    pub fn cn_world_step(world: *mut cn_world, dt_s: f32) -> cn_result;
    /// One sentence about the last call that failed on this world; "" if none failed or world is NULL. Valid
    /// until the next failing call.
    pub fn cn_world_error_text(world: *const cn_world) -> *const c_char;
    /// Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
    pub fn cn_world_set_gravity(world: *mut cn_world, gravity_x_mps2: f32, gravity_y_mps2: f32) -> cn_result;
    /// Reads gravity in m/s^2.
    pub fn cn_world_get_gravity(world: *const cn_world, out_mps2: *mut cn_vec2) -> cn_result;
    /// Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.
    pub fn cn_world_set_substep_count(world: *mut cn_world, count: i32) -> cn_result;
    /// Reads the substeps of a step.
    pub fn cn_world_get_substep_count(world: *const cn_world, out_count: *mut i32) -> cn_result;
    /// Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
    /// memory of the solver it was created with; a solver that needs more works without direct solving
    /// (CN_WARNING_FRAME_MEMORY).
    pub fn cn_world_set_solver(world: *mut cn_world, solver: i32) -> cn_result;
    /// Reads the solver (CN_SOLVER_*).
    pub fn cn_world_get_solver(world: *const cn_world, out_solver: *mut i32) -> cn_result;
    /// Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
    pub fn cn_world_set_accuracy(world: *mut cn_world, accuracy_m: f32, work_budget: i32) -> cn_result;
    /// Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
    /// (CN_DEFAULT: none).
    pub fn cn_world_get_accuracy(world: *const cn_world, out_accuracy_m: *mut f32, out_work_budget: *mut i32) -> cn_result;
    /// Reads how many workers a step can use: 1, or worker_count where the library supports threads.
    pub fn cn_world_get_worker_count(world: *const cn_world, out_count: *mut i32) -> cn_result;
    /// Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
    pub fn cn_world_set_flags(world: *mut cn_world, flags: u32) -> cn_result;
    /// Reads the CN_WORLD_ flags.
    pub fn cn_world_get_flags(world: *const cn_world, out_flags: *mut u32) -> cn_result;
    /// Impacts slower than this, in m/s, do not bounce; >= 0.
    pub fn cn_world_set_restitution_threshold(world: *mut cn_world, speed_mps: f32) -> cn_result;
    /// Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
    pub fn cn_world_set_hit_speed(world: *mut cn_world, speed_mps: f32) -> cn_result;
    /// Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster
    /// bodies down to them and keeps the direction.
    pub fn cn_world_set_speed_limits(world: *mut cn_world, linear_mps: f32, angular_radps: f32) -> cn_result;
    /// Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
    /// they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
    /// others that no joint holds and that are slower than four times the speed lose theirs within a second
    /// or two: what rocks in a hollow would keep all of a heap awake.
    pub fn cn_world_set_sleep(world: *mut cn_world, speed_mps: f32, delay_s: f32) -> cn_result;
    /// Stores a number for the user.
    pub fn cn_world_set_user_data(world: *mut cn_world, user_data: u64) -> cn_result;
    /// Reads the user's number.
    pub fn cn_world_get_user_data(world: *const cn_world, out_user_data: *mut u64) -> cn_result;
    /// Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
    /// capacity is 0. out_count is their number. O(slots).
    pub fn cn_world_get_bodies(world: *const cn_world, out: *mut cn_body, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    pub fn cn_world_get_shapes(world: *const cn_world, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(slots).
    pub fn cn_world_get_joints(world: *const cn_world, out: *mut cn_joint, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Reads counts of objects and what the last step reported. O(bodies + islands).
    pub fn cn_world_get_counters(world: *const cn_world, out: *mut cn_counters) -> cn_result;
    /// Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies,
    /// in a deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their
    /// number. A step does no work for it. O(bodies + contacts and joints of the islands written).
    pub fn cn_world_get_islands(world: *const cn_world, out: *mut cn_island_report, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Reads the seconds of the last step by stage.
    pub fn cn_world_get_profile(world: *const cn_world, out: *mut cn_profile) -> cn_result;
    /// Reads the memory statistics.
    pub fn cn_world_get_memory_stats(world: *const cn_world, out: *mut cn_memory_stats) -> cn_result;
    /// Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position
    /// p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
    /// world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay,
    /// and no event is reported. Distances between bodies keep their digits; world anchors are rounded to
    /// floats at the new place. Arrays returned before become invalid; the user moves their own points
    /// (movers, rays, cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next
    /// step looks at all pairs again.
    pub fn cn_world_shift_origin(world: *mut cn_world, x_m: f32, y_m: f32) -> cn_result;
    /// 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
    /// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
    /// every compiler, CPU and thread count. O(bodies + contacts + joints).
    pub fn cn_world_hash(world: *const cn_world, out_hash: *mut u64) -> cn_result;
    /// Checks every invariant between the tables. CN_ERROR_INTERNAL, and one sentence in text, for the first
    /// that is broken. text holds at most text_bytes (>= 0) bytes with the zero and may be NULL when
    /// text_bytes is 0. O(everything).
    pub fn cn_world_validate(world: *const cn_world, text: *mut c_char, text_bytes: i32) -> cn_result;
    /// Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn cn_world_save_size(world: *const cn_world, out_bytes: *mut u64) -> cn_result;
    /// Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and
    /// the number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the
    /// world), about 1 KB per body.
    pub fn cn_world_save(world: *const cn_world, out: *mut c_void, capacity: u64, out_bytes: *mut u64) -> cn_result;
    /// Restores a saved state, into the saved world or one created with the same definition (broadphase,
    /// length unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save;
    /// CN_ERROR_FORMAT for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the
    /// objects alive then (a world in a caller's block has room for its own saves). Arrays returned before
    /// become invalid. Handles of objects alive at the save are valid again, also of objects destroyed since;
    /// handles created since are refused until the same handle is given to a new object: with the same calls
    /// to the same object. O(memory of the world).
    pub fn cn_world_restore(world: *mut cn_world, save: *const c_void, bytes: u64) -> cn_result;
    /// Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
    pub fn cn_save_delta_size(base: *const c_void, base_bytes: u64, save: *const c_void, save_bytes: u64, out_bytes: *mut u64) -> cn_result;
    /// Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes
    /// to out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
    pub fn cn_save_delta(base: *const c_void, base_bytes: u64, save: *const c_void, save_bytes: u64, out: *mut c_void, capacity: u64, out_bytes: *mut u64) -> cn_result;
    /// Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
    /// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
    /// CN_ERROR_CAPACITY if out is too small. O(bytes).
    pub fn cn_save_apply(base: *const c_void, base_bytes: u64, delta: *const c_void, delta_bytes: u64, out: *mut c_void, capacity: u64, out_bytes: *mut u64) -> cn_result;
    /// Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn cn_world_write_size(world: *const cn_world, out_bytes: *mut u64) -> cn_result;
    /// Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
    /// of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about
    /// 1 KB per body.
    pub fn cn_world_write(world: *const cn_world, out: *mut c_void, capacity: u64, out_bytes: *mut u64) -> cn_result;
    /// Creates a world from bytes of cn_world_write (bytes: exactly as many). def, which may be NULL for
    /// defaults, gives memory, workers and capacities (which a caller's block needs); its settings are not
    /// used, the file's are. CN_ERROR_FORMAT for damaged or forged bytes, CN_ERROR_MEMORY without room,
    /// CN_ERROR_ARGUMENT for a definition that cn_world_create refuses. O(memory of the world).
    pub fn cn_world_read(def: *const cn_world_def, file: *const c_void, bytes: u64, out_world: *mut *mut cn_world) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing.
    pub fn cn_body_def_init(def: *mut cn_body_def);
    /// Creates a body. O(1) amortized.
    pub fn cn_body_create(world: *mut cn_world, def: *const cn_body_def, out_body: *mut cn_body) -> cn_result;
    /// Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
    pub fn cn_body_create_many(world: *mut cn_world, defs: *const cn_body_def, count: i32, out_bodies: *mut cn_body) -> cn_result;
    /// Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
    /// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts
    /// + joints + shapes).
    pub fn cn_body_destroy(world: *mut cn_world, body: cn_body) -> cn_result;
    /// Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
    /// O(their contacts + joints + shapes).
    pub fn cn_body_destroy_many(world: *mut cn_world, bodies: *const cn_body, count: i32) -> cn_result;
    /// 1 if the handle names a living body of this world, else 0 (also for a NULL world).
    pub fn cn_body_is_valid(world: *const cn_world, body: cn_body) -> i32;
    /// Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those
    /// that still overlap begin again in the next step), with its forces and any mass override; a body made
    /// static stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints +
    /// shapes).
    pub fn cn_body_set_type(world: *mut cn_world, body: cn_body, r#type: i32) -> cn_result;
    /// Reads the type (CN_BODY_*).
    pub fn cn_body_get_type(world: *const cn_world, body: cn_body, out_type: *mut i32) -> cn_result;
    /// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
    /// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
    /// are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
    pub fn cn_body_set_flags(world: *mut cn_world, body: cn_body, flags: u32) -> cn_result;
    /// Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
    pub fn cn_body_get_flags(world: *const cn_world, body: cn_body, out_flags: *mut u32) -> cn_result;
    /// 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and
    /// disabled bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
    pub fn cn_body_set_awake(world: *mut cn_world, body: cn_body, awake: i32) -> cn_result;
    /// Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <=
    /// 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
    /// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
    /// neighbours. O(contacts + joints + shapes).
    pub fn cn_body_set_pose(world: *mut cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32) -> cn_result;
    /// Reads the position of the origin and the rotation.
    pub fn cn_body_get_pose(world: *const cn_world, body: cn_body, out: *mut cn_pose) -> cn_result;
    /// Reads the position of the origin as the sum of two floats: the high part is within rounding that of
    /// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in
    /// double is more precise; so is a difference of two bodies, taken high from high and low from low, in
    /// floats.
    pub fn cn_body_get_position_parts(world: *const cn_world, body: cn_body, out_high_m: *mut cn_vec2, out_low_m: *mut cn_vec2) -> cn_result;
    /// Reads the angle in radians, in (-pi, pi\].
    pub fn cn_body_get_angle(world: *const cn_world, body: cn_body, out_rad: *mut f32) -> cn_result;
    /// Reads the world position of the centre of mass, in metres.
    pub fn cn_body_get_center(world: *const cn_world, body: cn_body, out_m: *mut cn_vec2) -> cn_result;
    /// Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
    /// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.
    pub fn cn_body_set_velocity(world: *mut cn_world, body: cn_body, linear_x_mps: f32, linear_y_mps: f32, angular_radps: f32) -> cn_result;
    /// Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
    pub fn cn_body_get_velocity(world: *const cn_world, body: cn_body, out: *mut cn_velocity) -> cn_result;
    /// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1)
    /// takes it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits.
    /// Unlike after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this
    /// before every step, or stop the body after it.
    pub fn cn_body_set_target_pose(world: *mut cn_world, body: cn_body, position_x_m: f32, position_y_m: f32, angle_rad: f32, dt_s: f32) -> cn_result;
    /// Velocity in m/s of the body's material at a world point in metres.
    pub fn cn_body_get_velocity_at(world: *const cn_world, body: cn_body, point_x_m: f32, point_y_m: f32, out_mps: *mut cn_vec2) -> cn_result;
    /// World position of a point given in the body's frame, both in metres.
    pub fn cn_body_get_world_point(world: *const cn_world, body: cn_body, local_x_m: f32, local_y_m: f32, out_m: *mut cn_vec2) -> cn_result;
    /// Position in the body's frame of a world point, both in metres.
    pub fn cn_body_get_local_point(world: *const cn_world, body: cn_body, world_x_m: f32, world_y_m: f32, out_m: *mut cn_vec2) -> cn_result;
    /// Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
    /// O(shapes).
    pub fn cn_body_get_aabb(world: *const cn_world, body: cn_body, out: *mut cn_aabb) -> cn_result;
    /// Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static,
    /// kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.
    pub fn cn_body_apply_force(world: *mut cn_world, body: cn_body, force_x_N: f32, force_y_N: f32) -> cn_result;
    /// Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
    /// cn_body_apply_force.
    pub fn cn_body_apply_force_at(world: *mut cn_world, body: cn_body, force_x_N: f32, force_y_N: f32, point_x_m: f32, point_y_m: f32) -> cn_result;
    /// Adds a torque in newton metres; otherwise as cn_body_apply_force.
    pub fn cn_body_apply_torque(world: *mut cn_world, body: cn_body, torque_Nm: f32) -> cn_result;
    /// Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
    /// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
    /// overflows.
    pub fn cn_body_apply_impulse(world: *mut cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32) -> cn_result;
    /// Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity
    /// too; otherwise as cn_body_apply_impulse.
    pub fn cn_body_apply_impulse_at(world: *mut cn_world, body: cn_body, impulse_x_Ns: f32, impulse_y_Ns: f32, point_x_m: f32, point_y_m: f32) -> cn_result;
    /// Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
    /// cn_body_apply_impulse.
    pub fn cn_body_apply_angular_impulse(world: *mut cn_world, body: cn_body, impulse_Nms: f32) -> cn_result;
    /// Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
    /// shapes have no mass weighs 1 kg; without shapes it does not rotate.
    pub fn cn_body_get_mass_data(world: *const cn_world, body: cn_body, out: *mut cn_mass_data) -> cn_result;
    /// Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
    /// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35.
    /// Wakes the body.
    pub fn cn_body_set_mass_data(world: *mut cn_world, body: cn_body, mass: *const cn_mass_data) -> cn_result;
    /// Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
    pub fn cn_body_reset_mass_data(world: *mut cn_world, body: cn_body) -> cn_result;
    /// Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
    pub fn cn_body_set_damping(world: *mut cn_world, body: cn_body, linear_per_s: f32, angular_per_s: f32) -> cn_result;
    /// Reads the linear and angular damping in 1/s.
    pub fn cn_body_get_damping(world: *const cn_world, body: cn_body, out_linear_per_s: *mut f32, out_angular_per_s: *mut f32) -> cn_result;
    /// Sets the factor on gravity for this body, finite. A change wakes the body.
    pub fn cn_body_set_gravity_scale(world: *mut cn_world, body: cn_body, scale: f32) -> cn_result;
    /// Reads the factor on gravity.
    pub fn cn_body_get_gravity_scale(world: *const cn_world, body: cn_body, out_scale: *mut f32) -> cn_result;
    /// Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
    pub fn cn_body_set_sleep_speed(world: *mut cn_world, body: cn_body, speed_mps: f32) -> cn_result;
    /// Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
    /// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
    /// bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
    /// within the work_budget. Takes effect with the next step; does not wake.
    pub fn cn_body_set_solver(world: *mut cn_world, body: cn_body, solver: i32) -> cn_result;
    /// Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn cn_body_get_solver(world: *const cn_world, body: cn_body, out_solver: *mut i32) -> cn_result;
    /// Stores a number for the user.
    pub fn cn_body_set_user_data(world: *mut cn_world, body: cn_body, user_data: u64) -> cn_result;
    /// Reads the user's number.
    pub fn cn_body_get_user_data(world: *const cn_world, body: cn_body, out_user_data: *mut u64) -> cn_result;
    /// Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
    /// O(length).
    pub fn cn_body_set_name(world: *mut cn_world, body: cn_body, name: *const c_char) -> cn_result;
    /// Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
    pub fn cn_body_get_name(world: *const cn_world, body: cn_body, out_name: *mut *const c_char) -> cn_result;
    /// Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).
    pub fn cn_body_get_shapes(world: *const cn_world, body: cn_body, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Handles of the body's joints without constraints; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(joints).
    pub fn cn_body_get_joints(world: *const cn_world, body: cn_body, out: *mut cn_joint, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then
    /// be their number. One bad handle fails the whole call. O(count).
    pub fn cn_world_read_poses(world: *const cn_world, bodies: *const cn_body, count: i32, out: *mut cn_pose) -> cn_result;
    /// Reads count cn_pose at intervals of stride_bytes (0, tightly packed, or >= 16); otherwise as
    /// cn_world_read_poses. O(count).
    pub fn cn_world_read_poses_strided(world: *const cn_world, bodies: *const cn_body, count: i32, out: *mut c_void, stride_bytes: i32) -> cn_result;
    /// Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
    pub fn cn_world_read_velocities(world: *const cn_world, bodies: *const cn_body, count: i32, out: *mut cn_velocity) -> cn_result;
    /// Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
    /// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).
    pub fn cn_world_write_velocities(world: *mut cn_world, bodies: *const cn_body, count: i32, velocities: *const cn_velocity) -> cn_result;
    /// Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since.
    /// The first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
    pub fn cn_world_moved(world: *mut cn_world, out_moved: *mut *const cn_body_moved, out_count: *mut i32) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing.
    pub fn cn_shape_def_init(def: *mut cn_shape_def);
    /// Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
    pub fn cn_shape_create_circle(world: *mut cn_world, def: *const cn_shape_def, circle: *const cn_circle, out_shape: *mut cn_shape) -> cn_result;
    /// Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body.
    /// out_shape may be NULL.
    pub fn cn_shape_create_capsule(world: *mut cn_world, def: *const cn_shape_def, capsule: *const cn_capsule, out_shape: *mut cn_shape) -> cn_result;
    /// Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.
    pub fn cn_shape_create_edge(world: *mut cn_world, def: *const cn_shape_def, edge: *const cn_edge, out_shape: *mut cn_shape) -> cn_result;
    /// Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
    /// out_shape may be NULL.
    pub fn cn_shape_create_polygon(world: *mut cn_world, def: *const cn_shape_def, polygon: *const cn_polygon, out_shape: *mut cn_shape) -> cn_result;
    /// Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body.
    /// out_shape may be NULL.
    pub fn cn_shape_create_box(world: *mut cn_world, def: *const cn_shape_def, half_width_m: f32, half_height_m: f32, radius_m: f32, out_shape: *mut cn_shape) -> cn_result;
    /// Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
    /// may be NULL. O(count).
    pub fn cn_shape_create_chain(world: *mut cn_world, def: *const cn_shape_def, chain: *const cn_chain, out_shape: *mut cn_shape) -> cn_result;
    /// Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static
    /// one. CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
    pub fn cn_shape_attach(world: *mut cn_world, shape: cn_shape, body: cn_body) -> cn_result;
    /// Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no
    /// body. O(contacts + shapes of the body).
    pub fn cn_shape_detach(world: *mut cn_world, shape: cn_shape) -> cn_result;
    /// Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
    pub fn cn_shape_destroy(world: *mut cn_world, shape: cn_shape) -> cn_result;
    /// 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
    pub fn cn_shape_is_valid(world: *const cn_world, shape: cn_shape) -> i32;
    /// Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
    pub fn cn_shape_get_type(world: *const cn_world, shape: cn_shape, out_type: *mut i32) -> cn_result;
    /// Reads the body; 0 if unattached.
    pub fn cn_shape_get_body(world: *const cn_world, shape: cn_shape, out_body: *mut cn_body) -> cn_result;
    /// Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
    /// body).
    pub fn cn_shape_set_material(world: *mut cn_world, shape: cn_shape, material: *const cn_material) -> cn_result;
    /// Reads the material.
    pub fn cn_shape_get_material(world: *const cn_world, shape: cn_shape, out: *mut cn_material) -> cn_result;
    /// Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
    /// wakes the body. O(shapes of the body).
    pub fn cn_shape_set_density(world: *mut cn_world, shape: cn_shape, density_kgpm2: f32) -> cn_result;
    /// Reads the density in kg/m^2.
    pub fn cn_shape_get_density(world: *const cn_world, shape: cn_shape, out_kgpm2: *mut f32) -> cn_result;
    /// Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
    /// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn cn_shape_set_filter(world: *mut cn_world, shape: cn_shape, filter: *const cn_filter) -> cn_result;
    /// Reads the filter.
    pub fn cn_shape_get_filter(world: *const cn_world, shape: cn_shape, out: *mut cn_filter) -> cn_result;
    /// Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts
    /// of the body).
    pub fn cn_shape_set_event_mask(world: *mut cn_world, shape: cn_shape, event_mask: u32) -> cn_result;
    /// Reads the event mask.
    pub fn cn_shape_get_event_mask(world: *const cn_world, shape: cn_shape, out_event_mask: *mut u32) -> cn_result;
    /// Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the
    /// next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn cn_shape_set_flags(world: *mut cn_world, shape: cn_shape, flags: u32) -> cn_result;
    /// Reads the CN_SHAPE_ flags.
    pub fn cn_shape_get_flags(world: *const cn_world, shape: cn_shape, out_flags: *mut u32) -> cn_result;
    /// Stores a number for the user.
    pub fn cn_shape_set_user_data(world: *mut cn_world, shape: cn_shape, user_data: u64) -> cn_result;
    /// Reads the user's number.
    pub fn cn_shape_get_user_data(world: *const cn_world, shape: cn_shape, out_user_data: *mut u64) -> cn_result;
    /// AABB without margin, in the world (in the shape's own space when unattached). O(points).
    pub fn cn_shape_get_aabb(world: *const cn_world, shape: cn_shape, out: *mut cn_aabb) -> cn_result;
    /// Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
    /// O(points).
    pub fn cn_shape_get_mass_data(world: *const cn_world, shape: cn_shape, out: *mut cn_mass_data) -> cn_result;
    /// Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn cn_shape_get_circle(world: *const cn_world, shape: cn_shape, out: *mut cn_circle) -> cn_result;
    /// Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn cn_shape_get_capsule(world: *const cn_world, shape: cn_shape, out: *mut cn_capsule) -> cn_result;
    /// Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn cn_shape_get_edge(world: *const cn_world, shape: cn_shape, out: *mut cn_edge) -> cn_result;
    /// Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn cn_shape_get_polygon(world: *const cn_world, shape: cn_shape, out: *mut cn_polygon) -> cn_result;
    /// Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
    /// NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
    /// written).
    pub fn cn_shape_get_chain_points(world: *const cn_world, shape: cn_shape, out: *mut cn_vec2, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
    /// of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
    /// once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
    /// the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
    /// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
    /// CN_ERROR_STATE for another type. O(contacts + shapes of the body).
    pub fn cn_shape_set_circle(world: *mut cn_world, shape: cn_shape, circle: *const cn_circle) -> cn_result;
    /// Replaces a capsule in place; otherwise as cn_shape_set_circle.
    pub fn cn_shape_set_capsule(world: *mut cn_world, shape: cn_shape, capsule: *const cn_capsule) -> cn_result;
    /// Replaces an edge in place; otherwise as cn_shape_set_circle.
    pub fn cn_shape_set_edge(world: *mut cn_world, shape: cn_shape, edge: *const cn_edge) -> cn_result;
    /// Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.
    pub fn cn_shape_set_polygon(world: *mut cn_world, shape: cn_shape, polygon: *const cn_polygon) -> cn_result;
    /// Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
    /// begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body +
    /// count).
    pub fn cn_shape_set_chain(world: *mut cn_world, shape: cn_shape, chain: *const cn_chain) -> cn_result;
    /// out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
    /// unattached), else 0. Edges and chains contain no point. O(points).
    pub fn cn_shape_test_point(world: *const cn_world, shape: cn_shape, point_x_m: f32, point_y_m: f32, out_inside: *mut i32) -> cn_result;
    /// Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
    /// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the
    /// most area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details
    /// below 5 mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m
    /// >= 0. O(count^2) at worst.
    pub fn cn_polygon_make_hull(points_m: *const cn_vec2, count: i32, radius_m: f32, out: *mut cn_polygon) -> cn_result;
    /// A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
    /// (|angle| <= 1e4); radius_m >= 0.
    pub fn cn_polygon_make_box(half_width_m: f32, half_height_m: f32, center_x_m: f32, center_y_m: f32, angle_rad: f32, radius_m: f32, out: *mut cn_polygon) -> cn_result;
    /// Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for
    /// cn_shape_create_polygon in worlds of this length unit ((1e-6 to 1e6); 1 by default),
    /// counter-clockwise, with radius_m 0 and without new points: ears are clipped (Meisters, 1975) and
    /// triangles merged (Hertel, Mehlhorn, 1983). Points nearer than 0.05% of the length unit to the one
    /// before and collinear points are dropped, and pieces thinner than that are left out. CN_ERROR_ARGUMENT
    /// for an outline that crosses or touches itself or has no area. Writes at most capacity pieces (>= 0;
    /// count - 2 always suffice); out may be NULL when capacity is 0. *out_count is the number of all. 34 KB
    /// of stack. O(count^2).
    pub fn cn_outline_decompose(points_m: *const cn_vec2, count: i32, length_unit_m: f32, out: *mut cn_polygon, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more
    /// than tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the
    /// first, else 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline
    /// can cross itself afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points
    /// (>= 0); out may be points_m, or NULL when capacity is 0. *out_count is the number of all. O(count *
    /// *out_count) at worst.
    pub fn cn_outline_simplify(points_m: *const cn_vec2, count: i32, closed: i32, tolerance_m: f32, out: *mut cn_vec2, capacity: i32, out_count: *mut i32) -> cn_result;
    /// An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to
    /// 4096), squares of side cell_m > 0 with the lower left corner of the first at the origin. cells\[row *
    /// columns + column\] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0;
    /// *out_count is 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on
    /// its left: counter-clockwise around solids, clockwise around holes. Its points are corners of cells.
    /// Solid cells that touch at a corner only are apart; an outline may pass such a corner twice. Writes at
    /// most capacity points (>= 0); out may be NULL when capacity is 0. *out_count is the number of all.
    /// O(cells + n log n) for a boundary of n edges.
    pub fn cn_outline_from_cells(cells: *const u8, count: i32, columns: i32, origin_x_m: f32, origin_y_m: f32, cell_m: f32, outline: i32, out: *mut cn_vec2, capacity: i32, out_count: *mut i32) -> cn_result;
    /// The same for a field by marching squares (Lorensen, Cline, 1987): values\[row * columns + column\],
    /// all finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at
    /// least 2 columns and rows. A point of an outline lies between two neighbouring samples, by linear
    /// interpolation, at least spacing_m / 64 from both; the grid's border closes outlines. An outline never
    /// touches itself or another one. cn_outline_simplify removes its collinear points. O(values + n log n).
    pub fn cn_outline_from_field(values: *const f32, count: i32, columns: i32, threshold: f32, origin_x_m: f32, origin_y_m: f32, spacing_m: f32, outline: i32, out: *mut cn_vec2, capacity: i32, out_count: *mut i32) -> cn_result;
    /// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
    /// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
    /// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
    /// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
    /// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
    /// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of
    /// the step, and got an impulse; bodies that pass a blow on to others that already touch them, without
    /// closing, have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which
    /// they begin), STAY or HIT.
    pub fn cn_world_contact_events(world: *mut cn_world, kind: i32, out_events: *mut *const cn_contact_event, out_count: *mut i32) -> cn_result;
    /// Sets the callback for contact events of one kind (CN_EVENT_*); NULL removes it.
    pub fn cn_world_set_contact_callback(world: *mut cn_world, kind: i32, function: Option<cn_contact_event_fn>, user: *mut c_void) -> cn_result;
    /// Sets the callback that decides whether two shapes may touch; NULL removes it.
    pub fn cn_world_set_filter_callback(world: *mut cn_world, function: Option<cn_filter_fn>, user: *mut c_void) -> cn_result;
    /// Sets the pre-solve callback; NULL removes it.
    pub fn cn_world_set_pre_solve_callback(world: *mut cn_world, function: Option<cn_pre_solve_fn>, user: *mut c_void) -> cn_result;
    /// Sets the callback that mixes materials; NULL removes it.
    pub fn cn_world_set_material_mix_callback(world: *mut cn_world, function: Option<cn_material_mix_fn>, user: *mut c_void) -> cn_result;
    /// The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
    /// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
    /// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
    /// chains. A pair without an awake body reports nothing until one wakes.
    pub fn cn_world_sensor_events(world: *const cn_world, out_events: *mut *const cn_sensor_event, out_count: *mut i32) -> cn_result;
    /// The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
    /// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
    /// impulses of the last substep. At rest their force is that of the points times substep_count (with
    /// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
    /// *out_count is their number. O(contacts).
    pub fn cn_body_get_contacts(world: *const cn_world, body: cn_body, out: *mut cn_contact_event, capacity: i32, out_count: *mut i32) -> cn_result;
    /// The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
    /// cn_body_get_contacts. O(contacts of its body).
    pub fn cn_shape_get_contacts(world: *const cn_world, shape: cn_shape, out: *mut cn_contact_event, capacity: i32, out_count: *mut i32) -> cn_result;
    /// The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
    /// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
    /// its body), squared for chains.
    pub fn cn_shape_get_visitors(world: *const cn_world, sensor: cn_shape, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
    /// destroyed since are stale.
    pub fn cn_world_fell_asleep(world: *const cn_world, out_bodies: *mut *const cn_body, out_count: *mut i32) -> cn_result;
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_revolute_def_init(def: *mut cn_revolute_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_distance_def_init(def: *mut cn_distance_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_fixed_def_init(def: *mut cn_fixed_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_prismatic_def_init(def: *mut cn_prismatic_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_wheel_def_init(def: *mut cn_wheel_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_motor_def_init(def: *mut cn_motor_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_mouse_def_init(def: *mut cn_mouse_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_gear_def_init(def: *mut cn_gear_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_pulley_def_init(def: *mut cn_pulley_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_ratchet_def_init(def: *mut cn_ratchet_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_rotary_spring_def_init(def: *mut cn_rotary_spring_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_groove_def_init(def: *mut cn_groove_def);
    /// Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
    /// nothing.
    pub fn cn_filter_joint_def_init(def: *mut cn_filter_joint_def);
    /// Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_revolute(world: *mut cn_world, def: *const cn_revolute_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_distance(world: *mut cn_world, def: *const cn_distance_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_fixed(world: *mut cn_world, def: *const cn_fixed_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_prismatic(world: *mut cn_world, def: *const cn_prismatic_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_wheel(world: *mut cn_world, def: *const cn_wheel_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_motor(world: *mut cn_world, def: *const cn_motor_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or body_a is not 0. O(contacts of body_a).
    pub fn cn_joint_create_mouse(world: *mut cn_world, def: *const cn_mouse_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    /// dynamic. O(contacts of body_a).
    pub fn cn_joint_create_gear(world: *mut cn_world, def: *const cn_gear_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_pulley(world: *mut cn_world, def: *const cn_pulley_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_ratchet(world: *mut cn_world, def: *const cn_ratchet_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn cn_joint_create_rotary_spring(world: *mut cn_world, def: *const cn_rotary_spring_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or the slot has no length. O(contacts of body_a).
    pub fn cn_joint_create_groove(world: *mut cn_world, def: *const cn_groove_def, out_joint: *mut cn_joint) -> cn_result;
    /// Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
    /// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
    /// body_a).
    pub fn cn_joint_create_filter(world: *mut cn_world, def: *const cn_filter_joint_def, out_joint: *mut cn_joint) -> cn_result;
    /// Destroys a joint and wakes its bodies. No event is reported.
    pub fn cn_joint_destroy(world: *mut cn_world, joint: cn_joint) -> cn_result;
    /// 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).
    pub fn cn_joint_is_valid(world: *const cn_world, joint: cn_joint) -> i32;
    /// Reads the type (CN_JOINT_REVOLUTE to _FILTER).
    pub fn cn_joint_get_type(world: *const cn_world, joint: cn_joint, out_type: *mut i32) -> cn_result;
    /// Reads both bodies; 0 stands for the world.
    pub fn cn_joint_get_bodies(world: *const cn_world, joint: cn_joint, out_a: *mut cn_body, out_b: *mut cn_body) -> cn_result;
    /// Reads the world positions of both anchors, in metres.
    pub fn cn_joint_get_anchors(world: *const cn_world, joint: cn_joint, out_world_a_m: *mut cn_vec2, out_world_b_m: *mut cn_vec2) -> cn_result;
    /// Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
    /// after a change of type or of CN_BODY_ENABLED of one of its bodies.
    pub fn cn_joint_get_reaction(world: *const cn_world, joint: cn_joint, out_force_N: *mut cn_vec2, out_torque_Nm: *mut f32) -> cn_result;
    /// Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
    /// (angles beyond limits).
    pub fn cn_joint_get_error(world: *const cn_world, joint: cn_joint, out_m: *mut f32, out_rad: *mut f32) -> cn_result;
    /// Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
    /// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
    /// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for
    /// a world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next
    /// step; does not wake.
    pub fn cn_joint_set_solver(world: *mut cn_world, joint: cn_joint, solver: i32) -> cn_result;
    /// Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn cn_joint_get_solver(world: *const cn_world, joint: cn_joint, out_solver: *mut i32) -> cn_result;
    /// Stores a number for the user.
    pub fn cn_joint_set_user_data(world: *mut cn_world, joint: cn_joint, user_data: u64) -> cn_result;
    /// Reads the user's number.
    pub fn cn_joint_get_user_data(world: *const cn_world, joint: cn_joint, out_user_data: *mut u64) -> cn_result;
    /// Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn cn_joint_set_flags(world: *mut cn_world, joint: cn_joint, flags: u32) -> cn_result;
    /// Reads the CN_JOINT_ flags.
    pub fn cn_joint_get_flags(world: *const cn_world, joint: cn_joint, out_flags: *mut u32) -> cn_result;
    /// Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_revolute(world: *const cn_world, joint: cn_joint, out: *mut cn_revolute_def) -> cn_result;
    /// Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_revolute(world: *mut cn_world, joint: cn_joint, def: *const cn_revolute_def) -> cn_result;
    /// Reads the definition of a distance joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_distance(world: *const cn_world, joint: cn_joint, out: *mut cn_distance_def) -> cn_result;
    /// Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_distance(world: *mut cn_world, joint: cn_joint, def: *const cn_distance_def) -> cn_result;
    /// Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_fixed(world: *const cn_world, joint: cn_joint, out: *mut cn_fixed_def) -> cn_result;
    /// Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_fixed(world: *mut cn_world, joint: cn_joint, def: *const cn_fixed_def) -> cn_result;
    /// Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_prismatic(world: *const cn_world, joint: cn_joint, out: *mut cn_prismatic_def) -> cn_result;
    /// Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors
    /// and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_prismatic(world: *mut cn_world, joint: cn_joint, def: *const cn_prismatic_def) -> cn_result;
    /// Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_wheel(world: *const cn_world, joint: cn_joint, out: *mut cn_wheel_def) -> cn_result;
    /// Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_wheel(world: *mut cn_world, joint: cn_joint, def: *const cn_wheel_def) -> cn_result;
    /// Reads the definition of a motor joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_motor_to(world: *const cn_world, joint: cn_joint, out: *mut cn_motor_def) -> cn_result;
    /// Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_motor_to(world: *mut cn_world, joint: cn_joint, def: *const cn_motor_def) -> cn_result;
    /// Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_mouse(world: *const cn_world, joint: cn_joint, out: *mut cn_mouse_def) -> cn_result;
    /// Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
    /// CN_JOINT_COLLIDE changes.
    pub fn cn_joint_set_mouse(world: *mut cn_world, joint: cn_joint, def: *const cn_mouse_def) -> cn_result;
    /// Reads the definition of a gear joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_gear(world: *const cn_world, joint: cn_joint, out: *mut cn_gear_def) -> cn_result;
    /// Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn cn_joint_set_gear(world: *mut cn_world, joint: cn_joint, def: *const cn_gear_def) -> cn_result;
    /// Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_pulley(world: *const cn_world, joint: cn_joint, out: *mut cn_pulley_def) -> cn_result;
    /// Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_pulley(world: *mut cn_world, joint: cn_joint, def: *const cn_pulley_def) -> cn_result;
    /// Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_ratchet(world: *const cn_world, joint: cn_joint, out: *mut cn_ratchet_def) -> cn_result;
    /// Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn cn_joint_set_ratchet(world: *mut cn_world, joint: cn_joint, def: *const cn_ratchet_def) -> cn_result;
    /// Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_rotary_spring(world: *const cn_world, joint: cn_joint, out: *mut cn_rotary_spring_def) -> cn_result;
    /// Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_rotary_spring(world: *mut cn_world, joint: cn_joint, def: *const cn_rotary_spring_def) -> cn_result;
    /// Reads the definition of a groove joint. CN_ERROR_STATE for another type.
    pub fn cn_joint_get_groove(world: *const cn_world, joint: cn_joint, out: *mut cn_groove_def) -> cn_result;
    /// Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn cn_joint_set_groove(world: *mut cn_world, joint: cn_joint, def: *const cn_groove_def) -> cn_result;
    /// Reads the base of a joint of any type.
    pub fn cn_joint_get_base(world: *const cn_world, joint: cn_joint, out: *mut cn_joint_base) -> cn_result;
    /// Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges
    /// as in cn_joint_base. Wakes both bodies.
    pub fn cn_joint_set_base(world: *mut cn_world, joint: cn_joint, base: *const cn_joint_base) -> cn_result;
    /// Sets the target of a mouse joint, a world point in metres; cheap enough for every frame.
    /// CN_ERROR_STATE for another type. Wakes the body.
    pub fn cn_joint_set_target(world: *mut cn_world, joint: cn_joint, target_x_m: f32, target_y_m: f32) -> cn_result;
    /// Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
    /// reference) in (-pi, pi\]. Distance, pulley: the present length. Prismatic, wheel, groove: the
    /// translation along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a;
    /// ratchet, rotary spring: angle b - angle a; these three over whole turns.
    pub fn cn_joint_get_position(world: *const cn_world, joint: cn_joint, out_position: *mut f32) -> cn_result;
    /// Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
    /// positive motor speed has the same sign.
    pub fn cn_joint_get_speed(world: *const cn_world, joint: cn_joint, out_speed: *mut f32) -> cn_result;
    /// Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
    /// prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
    pub fn cn_joint_set_motor(world: *mut cn_world, joint: cn_joint, speed: f32, force_or_torque_max: f32) -> cn_result;
    /// Sets the limits, lower <= upper, of a revolute (radians in \[-pi, pi\]), distance (metres >= 0),
    /// prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
    pub fn cn_joint_set_limits(world: *mut cn_world, joint: cn_joint, lower: f32, upper: f32) -> cn_result;
    /// Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a
    /// body in that step or between it and the step before.
    pub fn cn_world_joint_events(world: *const cn_world, out_events: *mut *const cn_joint_event, out_count: *mut i32) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
    pub fn cn_angle_constraint_def_init(def: *mut cn_angle_constraint_def);
    /// Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.
    pub fn cn_line_constraint_def_init(def: *mut cn_line_constraint_def);
    /// Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn cn_constraint_create_angle(world: *mut cn_world, def: *const cn_angle_constraint_def, out_constraint: *mut cn_constraint) -> cn_result;
    /// Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn cn_constraint_create_line(world: *mut cn_world, def: *const cn_line_constraint_def, out_constraint: *mut cn_constraint) -> cn_result;
    /// Destroys a constraint and wakes its body. No event is reported.
    pub fn cn_constraint_destroy(world: *mut cn_world, constraint: cn_constraint) -> cn_result;
    /// 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).
    pub fn cn_constraint_is_valid(world: *const cn_world, constraint: cn_constraint) -> i32;
    /// Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
    pub fn cn_constraint_get_type(world: *const cn_world, constraint: cn_constraint, out_type: *mut i32) -> cn_result;
    /// Reads the body.
    pub fn cn_constraint_get_body(world: *const cn_world, constraint: cn_constraint, out_body: *mut cn_body) -> cn_result;
    /// Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
    pub fn cn_constraint_get_angle(world: *const cn_world, constraint: cn_constraint, out: *mut cn_angle_constraint_def) -> cn_result;
    /// Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes
    /// the body.
    pub fn cn_constraint_set_angle(world: *mut cn_world, constraint: cn_constraint, def: *const cn_angle_constraint_def) -> cn_result;
    /// Reads the definition of a line constraint. CN_ERROR_STATE for another type.
    pub fn cn_constraint_get_line(world: *const cn_world, constraint: cn_constraint, out: *mut cn_line_constraint_def) -> cn_result;
    /// Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
    /// body.
    pub fn cn_constraint_set_line(world: *mut cn_world, constraint: cn_constraint, def: *const cn_line_constraint_def) -> cn_result;
    /// Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
    /// along the axis, in metres from origin.
    pub fn cn_constraint_get_position(world: *const cn_world, constraint: cn_constraint, out_position: *mut f32) -> cn_result;
    /// Force in newtons and torque in newton metres that the constraint applied to the body in the last
    /// substep.
    pub fn cn_constraint_get_reaction(world: *const cn_world, constraint: cn_constraint, out_force_N: *mut cn_vec2, out_torque_Nm: *mut f32) -> cn_result;
    /// Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle
    /// constraint.
    pub fn cn_constraint_get_error(world: *const cn_world, constraint: cn_constraint, out_m: *mut f32, out_rad: *mut f32) -> cn_result;
    /// Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    pub fn cn_world_get_constraints(world: *const cn_world, out: *mut cn_constraint, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
    /// constraints of the body).
    pub fn cn_body_get_constraints(world: *const cn_world, body: cn_body, out: *mut cn_constraint, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Sets the fixed step of cn_world_update: step_s in (0, 1\], default 1/60; at most steps_max steps an
    /// update, 1 to 1000, default 8.
    pub fn cn_world_set_fixed_step(world: *mut cn_world, step_s: f32, steps_max: i32) -> cn_result;
    /// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
    /// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
    pub fn cn_world_update(world: *mut cn_world, elapsed_s: f32, out: *mut cn_update_report) -> cn_result;
    /// Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last
    /// step, 1 after it. Bodies that did not take part in the last step have their present pose. bodies and
    /// count as in cn_world_read_poses. O(count).
    pub fn cn_world_read_poses_interpolated(world: *const cn_world, bodies: *const cn_body, count: i32, factor: f32, out: *mut cn_pose) -> cn_result;
    /// Sets the defaults given beside the fields. NULL does nothing.
    pub fn cn_query_filter_init(filter: *mut cn_query_filter);
    /// Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
    /// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child.
    /// filter may be NULL: the defaults. O(log shapes) to O(shapes along the ray).
    pub fn cn_world_cast_ray(world: *const cn_world, ray: *const cn_ray, filter: *const cn_query_filter, out: *mut cn_ray_hit) -> cn_result;
    /// out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL.
    /// O(log shapes) to O(shapes along the ray).
    pub fn cn_world_cast_ray_any(world: *const cn_world, ray: *const cn_ray, filter: *const cn_query_filter, out_hit: *mut i32) -> cn_result;
    /// Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found.
    /// A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
    pub fn cn_world_cast_ray_all(world: *const cn_world, ray: *const cn_ray, filter: *const cn_query_filter, out: *mut cn_ray_hit, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
    /// filter may be NULL. O(sum of the rays).
    pub fn cn_world_cast_rays(world: *const cn_world, rays: *const cn_ray, count: i32, filter: *const cn_query_filter, out: *mut cn_ray_hit) -> cn_result;
    /// Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
    /// O(points of the shape).
    pub fn cn_shape_cast_ray(world: *const cn_world, shape: cn_shape, ray: *const cn_ray, out: *mut cn_ray_hit) -> cn_result;
    /// First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
    /// way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or
    /// 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the
    /// moving points is in front of it. filter may be NULL. O(shapes along the way).
    pub fn cn_world_cast_shape(world: *const cn_world, shape: *const cn_polygon, translation_x_m: f32, translation_y_m: f32, filter: *const cn_query_filter, out: *mut cn_ray_hit) -> cn_result;
    /// Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
    /// cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
    /// filter may be NULL. O(log shapes) to O(boxes in the region).
    pub fn cn_world_overlap_aabb(world: *const cn_world, r#box: *const cn_aabb, filter: *const cn_query_filter, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
    /// Edges and chains are lines here, seen from both sides.
    pub fn cn_world_overlap_circle(world: *const cn_world, circle: *const cn_circle, filter: *const cn_query_filter, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
    /// in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
    pub fn cn_world_overlap_polygon(world: *const cn_world, polygon: *const cn_polygon, filter: *const cn_query_filter, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Shapes that contain a world point in metres; order, capacity, filter and cost as in
    /// cn_world_overlap_aabb. Edges and chains contain no point.
    pub fn cn_world_overlap_point(world: *const cn_world, x_m: f32, y_m: f32, filter: *const cn_query_filter, out: *mut cn_shape, capacity: i32, out_count: *mut i32) -> cn_result;
    /// Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
    /// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
    pub fn cn_world_closest_point(world: *const cn_world, x_m: f32, y_m: f32, distance_max_m: f32, filter: *const cn_query_filter, out: *mut cn_closest) -> cn_result;
    /// Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without
    /// their radii are apart, else by their Minkowski difference. Needs no world; runs in any thread.
    /// O(points).
    pub fn cn_polygon_distance(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, out: *mut cn_distance) -> cn_result;
    /// Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0;
    /// *out as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
    pub fn cn_polygon_cast(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, translation_x_m: f32, translation_y_m: f32, out: *mut cn_ray_hit, out_hit: *mut i32) -> cn_result;
    /// Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m
    /// (0 to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
    /// O(points).
    pub fn cn_polygon_collide(a: *const cn_polygon, pose_a: *const cn_pose, b: *const cn_polygon, pose_b: *const cn_pose, margin_m: f32, out: *mut cn_manifold) -> cn_result;
    /// First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if
    /// they start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never
    /// misses a hit. Needs no world; runs in any thread.
    pub fn cn_polygon_time_of_impact(a: *const cn_polygon, sweep_a: *const cn_sweep, b: *const cn_polygon, sweep_b: *const cn_sweep, distance_m: f32, out: *mut cn_impact) -> cn_result;
    /// Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape)
    /// moved by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of
    /// least separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a
    /// one-way shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the
    /// length unit plus its rise in the last step. Shapes wholly behind the plane of another shape are left
    /// out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby,
    /// squared).
    pub fn cn_mover_collide(world: *const cn_world, shape: *const cn_polygon, position_x_m: f32, position_y_m: f32, margin_m: f32, filter: *const cn_query_filter, out: *mut cn_plane, capacity: i32, out_count: *mut i32) -> cn_result;
    /// The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in
    /// two dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method
    /// (1957) finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the
    /// least sum of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of
    /// planes below their limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two
    /// planes hold it.
    pub fn cn_mover_solve(planes: *mut cn_plane, count: i32, translation_x_m: f32, translation_y_m: f32, out_translation_m: *mut cn_vec2, out_overlap_m: *mut f32) -> cn_result;
    /// The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
    /// cn_mover_solve. Needs no world. O(count^2).
    pub fn cn_mover_clip(planes: *const cn_plane, count: i32, velocity_x_mps: f32, velocity_y_mps: f32, out_mps: *mut cn_vec2) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing.
    pub fn cn_mover_def_init(def: *mut cn_mover_def);
    /// Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step
    /// behind the ground that carries it. 1. carried   by the motion of its ground since the last move: of
    /// the point of ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across
    /// up, along the ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A
    /// step up where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground
    /// flying    in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off
    /// keep ground_velocity_mps 3. sliding   both by collision planes, cn_mover_solve and casts, up to
    /// iterations_max times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a
    /// force for the next step that brings them to the character's velocity, of at most push_force_N each 5.
    /// ground    ground that it touches, or that lies within snap_m below a walking character; velocity_mps
    /// loses blocked components The result depends on the world, def and mover alone: equal calls give equal
    /// bits. The loop of planes, solver and cast is that of Box2D 3's sample of a character mover (Catto,
    /// 2025). Pushed bodies wake; nothing else in the world changes. O(shapes nearby x iterations_max): about
    /// 1 us standing, 3 us walking, 10 us against a wall.
    pub fn cn_mover_move(world: *mut cn_world, def: *const cn_mover_def, dt_s: f32, mover: *mut cn_mover) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing.
    pub fn cn_area_def_init(def: *mut cn_area_def);
    /// Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter
    /// says which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an
    /// area that loses the flag later does nothing while it is without. Gravity, and damping without density,
    /// act on bodies whose centre of mass is in the area (on its border too) while one of their shapes
    /// touches it: on a body half in it in full or not at all. The medium acts on the part of each shape that
    /// is in the area, exactly for polygons; parts of round shapes are computed as those of polygons of 16
    /// sides, to 1%. The surface of a circle or capsule is flat across a body, as of a planet. Shapes of a
    /// body do not shade each other. The area's body feels no reaction. Between steps nothing happens: the
    /// acceleration is that in the middle of the next step (leapfrog), so bodies on orbits and floating
    /// bodies keep their energy. Damping and drag are implicit: stable at any strength, mass and time step,
    /// with exact terminal speeds. Bodies that enter or leave, that are in an area that moves, and those in
    /// it now, wake; bodies at rest in it may sleep. Areas are in saves and files. Floats whose draught is
    /// less than about g dt^2 (3 mm at 60 steps a second) are damped, and carry less under a load. An area
    /// takes 64 bytes of the world's memory; a step takes about 0.15 us for each shape in an area, 0.35 us in
    /// a medium. Best on a body of its own: O(contacts of the body).
    pub fn cn_shape_set_area(world: *mut cn_world, shape: cn_shape, def: *const cn_area_def) -> cn_result;
    /// Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
    pub fn cn_shape_get_area(world: *const cn_world, shape: cn_shape, out: *mut cn_area_def) -> cn_result;
    /// The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each
    /// step. flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w
    /// across it, with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton
    /// (1687), and across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle
    /// between surface and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the
    /// whole outline, round parts included, and drag along straight edges also for turning bodies; edges and
    /// chains are plates with two sides. Solved implicitly, so that wind never reverses the motion relative
    /// to it, at any speed, mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0:
    /// sleeping bodies stay asleep and unchanged; else they wake. Static, kinematic and disabled bodies are
    /// unchanged. CN_ERROR_STATE for a shape without a body. O(points).
    pub fn cn_shape_apply_wind(world: *mut cn_world, shape: cn_shape, flow_x_mps: f32, flow_y_mps: f32, drag_kgpm2: f32, lift_kgpm2: f32, dt_s: f32, wake: i32) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields. NULL does nothing.
    pub fn cn_explosion_def_init(def: *mut cn_explosion_def);
    /// Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
    /// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
    pub fn cn_world_explode(world: *mut cn_world, def: *const cn_explosion_def) -> cn_result;
    /// Sets struct_size and the defaults given beside the fields, every function to NULL. NULL does nothing.
    pub fn cn_debug_draw_init(draw: *mut cn_debug_draw);
    /// Draws the world through the given functions, in the calling thread. Reads only. O(bodies + shapes +
    /// contacts + joints).
    pub fn cn_world_draw(world: *const cn_world, draw: *const cn_debug_draw) -> cn_result;
    /// Creates a dynamic AABB tree; margin_m >= 0 is added around every box. alloc and free: both NULL for
    /// malloc, or both set.
    pub fn cn_tree_create(margin_m: f32, alloc: Option<cn_alloc_fn>, free: Option<cn_free_fn>, allocator_user: *mut c_void, out_tree: *mut *mut cn_tree) -> cn_result;
    /// Destroys a tree. NULL does nothing.
    pub fn cn_tree_destroy(tree: *mut cn_tree);
    /// Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
    pub fn cn_tree_insert(tree: *mut cn_tree, r#box: *const cn_aabb, user_data: u64, out_item: *mut u32) -> cn_result;
    /// Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
    pub fn cn_tree_remove(tree: *mut cn_tree, item: u32) -> cn_result;
    /// Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log
    /// n). CN_ERROR_HANDLE for a stale item.
    pub fn cn_tree_move(tree: *mut cn_tree, item: u32, r#box: *const cn_aabb) -> cn_result;
    /// Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
    pub fn cn_tree_get_box(tree: *const cn_tree, item: u32, out: *mut cn_aabb) -> cn_result;
    /// Calls visit for every item whose box with margin overlaps box, until visit returns 0. visit must not
    /// change the tree. O(log n + items visited).
    pub fn cn_tree_query(tree: *const cn_tree, r#box: *const cn_aabb, visit: Option<cn_tree_query_fn>, user: *mut c_void) -> cn_result;
    /// Calls visit for items whose box with margin a ray crosses; visit shortens or stops the ray by its
    /// result and must not change the tree. O(log n + items visited).
    pub fn cn_tree_cast_ray(tree: *const cn_tree, ray: *const cn_ray, visit: Option<cn_tree_ray_fn>, user: *mut c_void) -> cn_result;
    /// Reads the number of items and the height of the tree.
    pub fn cn_tree_get_stats(tree: *const cn_tree, out_count: *mut i32, out_height: *mut i32) -> cn_result;
}
