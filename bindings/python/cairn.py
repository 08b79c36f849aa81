"""Cairn for Python (ctypes), one to one with cairn.h.
Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.

    import cairn

    world = cairn.World(gravity_mps2=(0, -10))
    body = world.body_create(cairn.BodyDef(position_m=(0, 4)))
    world.shape_create_box(cairn.ShapeDef(body=body), 0.5, 0.5, 0)
    world.step(1 / 60)
    print(world.body_get_pose(body).position_m.y)

Below the classes are C's functions under their own names (cn_world_step), for ctypes: where C takes a pointer to a struct or
number, pass the struct or a ctypes number itself; where it takes an array, pass an array. The library is the one beside this
file, else the system's; CAIRN_LIBRARY in the environment names another.
"""
import ctypes as _c
import os as _os
import sys as _sys

_files = {"darwin": "libcairn.dylib", "win32": "cairn.dll"}
_file = _files.get(_sys.platform, "libcairn.so")
_beside = _os.path.join(_os.path.dirname(_os.path.abspath(__file__)), _file)
_library = _c.CDLL(_os.environ.get("CAIRN_LIBRARY") or (_beside if _os.path.exists(_beside) else _file))

# A library of another version would read other structs: refuse it here and, by their sizes, below.
if _library.cn_abi_version() != 3:
    raise ImportError("cairn.py is for ABI 3, the library has %d" % _library.cn_abi_version())


def _function(name, doc, result, *arguments):
    function = getattr(_library, name)
    function.__doc__ = doc
    function.restype = result
    function.argtypes = arguments
    return function


CN_VERSION_MAJOR = 0
CN_VERSION_MINOR = 1
CN_VERSION_PATCH = 0
CN_ABI_VERSION = 3
CN_POLYGON_MAX_VERTICES = 16
CN_NAME_MAX_BYTES = 63
CN_PLANES_MAX = 64
CN_WORKERS_MAX = 64
CN_MAX_HANDLES = 1048575
CN_DEFAULT = -1
CN_OK = 0
CN_ERROR_ARGUMENT = -1
CN_ERROR_HANDLE = -2
CN_ERROR_MEMORY = -3
CN_ERROR_LOCKED = -4
CN_ERROR_CAPACITY = -5
CN_ERROR_STATE = -6
CN_ERROR_INTERNAL = -7
CN_ERROR_FORMAT = -8
CN_TYPE_VEC2 = 0
CN_TYPE_POSE = 1
CN_TYPE_VELOCITY = 2
CN_TYPE_AABB = 3
CN_TYPE_MASS_DATA = 4
CN_TYPE_WORLD_DEF = 5
CN_TYPE_BODY_DEF = 6
CN_TYPE_SHAPE_DEF = 7
CN_TYPE_CIRCLE = 8
CN_TYPE_CAPSULE = 9
CN_TYPE_EDGE = 10
CN_TYPE_POLYGON = 11
CN_TYPE_CHAIN = 12
CN_TYPE_FILTER = 13
CN_TYPE_MATERIAL = 14
CN_TYPE_MANIFOLD_POINT = 15
CN_TYPE_MANIFOLD = 16
CN_TYPE_CONTACT_EVENT = 17
CN_TYPE_BODY_MOVED = 18
CN_TYPE_REVOLUTE_DEF = 19
CN_TYPE_DISTANCE_DEF = 20
CN_TYPE_COUNTERS = 21
CN_TYPE_PROFILE = 22
CN_TYPE_MEMORY_STATS = 23
CN_TYPE_SENSOR_EVENT = 24
CN_TYPE_UPDATE_REPORT = 25
CN_TYPE_DEBUG_DRAW = 26
CN_TYPE_QUERY_FILTER = 27
CN_TYPE_RAY = 28
CN_TYPE_RAY_HIT = 29
CN_TYPE_CLOSEST = 30
CN_TYPE_EXPLOSION_DEF = 31
CN_TYPE_FIXED_DEF = 32
CN_TYPE_PRISMATIC_DEF = 33
CN_TYPE_WHEEL_DEF = 34
CN_TYPE_MOTOR_DEF = 35
CN_TYPE_MOUSE_DEF = 36
CN_TYPE_GEAR_DEF = 37
CN_TYPE_PULLEY_DEF = 38
CN_TYPE_RATCHET_DEF = 39
CN_TYPE_ROTARY_SPRING_DEF = 40
CN_TYPE_GROOVE_DEF = 41
CN_TYPE_FILTER_JOINT_DEF = 42
CN_TYPE_JOINT_BASE = 43
CN_TYPE_JOINT_EVENT = 44
CN_TYPE_ANGLE_CONSTRAINT_DEF = 45
CN_TYPE_LINE_CONSTRAINT_DEF = 46
CN_TYPE_ISLAND_REPORT = 47
CN_TYPE_DISTANCE = 48
CN_TYPE_SWEEP = 49
CN_TYPE_IMPACT = 50
CN_TYPE_PLANE = 51
CN_TYPE_MOVER_DEF = 52
CN_TYPE_MOVER = 53
CN_TYPE_AREA_DEF = 54
CN_TYPE_COUNT = 55
CN_WORLD_SLEEP = 1
CN_WORLD_WARM_START = 2
CN_WORLD_PROFILE = 4
CN_WORLD_CONTINUOUS = 8
CN_RESERVE_NAMES = 1
CN_RESERVE_CHAINS = 2
CN_RESERVE_EXTRA_ROWS = 4
CN_RESERVE_MOVED = 8
CN_SOLVER_AUTO = 0
CN_SOLVER_SOFT = 1
CN_SOLVER_DIRECT = 2
CN_SOLVER_SEQUENTIAL = 3
CN_BROADPHASE_SWEEP = 0
CN_BROADPHASE_TREE = 1
CN_WARNING_CONTACT_MEMORY = 1
CN_WARNING_FRAME_MEMORY = 2
CN_WARNING_EVENT_MEMORY = 4
CN_WARNING_CROWD = 8
CN_WARNING_NOT_FINITE = 16
CN_TIER_SOFT = 0
CN_TIER_DIRECT = 1
CN_TIER_FREE = 2
CN_TIER_REASON_NONE = 0
CN_TIER_REASON_SETTLING = 1
CN_TIER_REASON_NEW_CONTACT = 2
CN_TIER_REASON_OVERLAP = 3
CN_TIER_REASON_JOINT = 4
CN_TIER_REASON_STRESSED = 5
CN_TIER_REASON_SOLVER = 6
CN_TIER_REASON_OVERRIDE = 7
CN_TIER_REASON_ALONE = 8
CN_TIER_REASON_MOVING = 9
CN_TIER_REASON_CROWDED = 10
CN_TIER_REASON_WORK = 11
CN_TIER_REASON_KIND = 12
CN_TIER_REASON_NO_SET = 13
CN_TIER_REASON_MEMORY = 14
CN_TIER_REASON_JOINTED = 15
CN_BODY_STATIC = 0
CN_BODY_KINEMATIC = 1
CN_BODY_DYNAMIC = 2
CN_BODY_LOCK_X = 1
CN_BODY_LOCK_Y = 2
CN_BODY_LOCK_ROTATION = 4
CN_BODY_BULLET = 8
CN_BODY_ENABLED = 16
CN_BODY_SLEEP = 32
CN_BODY_AWAKE = 64
CN_SHAPE_CIRCLE = 0
CN_SHAPE_CAPSULE = 1
CN_SHAPE_POLYGON = 2
CN_SHAPE_EDGE = 3
CN_SHAPE_CHAIN = 4
CN_MIX_AVERAGE = 0
CN_MIX_GEOMETRIC = 1
CN_MIX_MINIMUM = 2
CN_MIX_MULTIPLY = 3
CN_MIX_MAXIMUM = 4
CN_SHAPE_SENSOR = 1
CN_SHAPE_SENSOR_SEEN = 2
CN_SHAPE_ONE_WAY = 4
CN_SHAPE_PRE_SOLVE = 8
CN_EVENT_CREATED = 0
CN_EVENT_ENTER = 1
CN_EVENT_STAY = 2
CN_EVENT_LEAVE = 3
CN_EVENT_DESTROYED = 4
CN_EVENT_HIT = 5
CN_EVENT_KINDS = 6
CN_JOINT_REVOLUTE = 0
CN_JOINT_DISTANCE = 1
CN_JOINT_FIXED = 2
CN_JOINT_PRISMATIC = 3
CN_JOINT_WHEEL = 4
CN_JOINT_MOTOR_TO = 5
CN_JOINT_MOUSE = 6
CN_JOINT_GEAR = 7
CN_JOINT_PULLEY = 8
CN_JOINT_RATCHET = 9
CN_JOINT_ROTARY_SPRING = 10
CN_JOINT_GROOVE = 11
CN_JOINT_FILTER = 12
CN_JOINT_COLLIDE = 1
CN_JOINT_LIMIT = 2
CN_JOINT_MOTOR = 4
CN_JOINT_SPRING = 8
CN_JOINT_BREAKS = 16
CN_CONSTRAINT_ANGLE = 0
CN_CONSTRAINT_LINE = 1
CN_CONSTRAINT_LIMIT = 1
CN_CONSTRAINT_BREAKS = 2
CN_QUERY_SKIP = 0
CN_QUERY_TAKE = 1
CN_QUERY_STOP = 2
CN_QUERY_IGNORE_JOINED = 1
CN_QUERY_ONE_WAY = 2
CN_QUERY_LEAVING = 4
CN_IMPACT_NONE = 0
CN_IMPACT_HIT = 1
CN_IMPACT_OVERLAP = 2
CN_IMPACT_FAILED = 3
CN_MOVER_DROP = 1
CN_MOVER_ON_GROUND = 1
CN_MOVER_ON_WALL = 2
CN_MOVER_ON_CEILING = 4
CN_AREA_REPLACE = 1
CN_DRAW_SHAPES = 1
CN_DRAW_JOINTS = 2
CN_DRAW_CONTACTS = 4
CN_DRAW_AABBS = 8
CN_DRAW_CENTERS = 16
CN_DRAW_ISLANDS = 32

cn_result = _c.c_int32
cn_body = _c.c_uint32
cn_shape = _c.c_uint32
cn_joint = _c.c_uint32
cn_constraint = _c.c_uint32


class cn_world(_c.Structure):
    pass


class cn_tree(_c.Structure):
    pass


class cn_vec2(_c.Structure):
    """A point, vector or pair of numbers."""

    _fields_ = [
        ("x", _c.c_float),  # to the right
        ("y", _c.c_float),  # upwards
    ]


class cn_pose(_c.Structure):
    """Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
    uploaded to a GPU directly."""

    _fields_ = [
        ("position_m", cn_vec2),  # of the body's origin
        ("cosine", _c.c_float),  # of the angle
        ("sine", _c.c_float),  # of the angle
    ]


class cn_velocity(_c.Structure):
    """Velocity of a body."""

    _fields_ = [
        ("linear_mps", cn_vec2),  # of the centre of mass
        ("angular_radps", _c.c_float),  # counter-clockwise is positive
    ]


class cn_aabb(_c.Structure):
    """Axis-aligned bounding box, lower_m <= upper_m."""

    _fields_ = [
        ("lower_m", cn_vec2),  # left and bottom
        ("upper_m", cn_vec2),  # right and top
    ]


class cn_mass_data(_c.Structure):
    """Mass, inertia and centre of mass."""

    _fields_ = [
        ("mass_kg", _c.c_float),  # of all shapes, or as set
        ("inertia_kgm2", _c.c_float),  # about the centre of mass
        ("center_m", cn_vec2),  # in the body's local frame
    ]


# Memory hook: allocates bytes aligned to align, a power of two of at most 64; returns NULL when there is no
# memory. Called only from inside functions that take a non-const world.
cn_alloc_fn = _c.CFUNCTYPE(_c.c_void_p, _c.c_uint64, _c.c_uint32, _c.c_void_p)


# Memory hook: frees memory of cn_alloc_fn; bytes is the size it was allocated with.
cn_free_fn = _c.CFUNCTYPE(None, _c.c_void_p, _c.c_uint64, _c.c_void_p)


# The library's part of a user's task system (cn_world_def.enqueue and finish, for worlds with worker_count of
# 2 or more; without them the world starts its own threads). Call it for ranges [begin, end) that together
# cover 0 to item_count - 1, each item once, on any threads, in any order. A call may last as long as the step
# and may wait for calls that have begun, never for one that has not. Its thread must have the floating-point
# mode of the stepping thread.
cn_task_fn = _c.CFUNCTYPE(None, _c.c_int32, _c.c_int32, _c.c_void_p)


# Starts a task of item_count items (worker_count - 1) in ranges of at least min_range and returns a handle
# for finish. It may run the whole task at once, and must do so if it cannot store the task; it then returns
# NULL, and finish is not called. A step with enough work enqueues 3 to 10 tasks; enqueue and finish run in
# the stepping thread, never during a callback, and must not call the library.
cn_enqueue_fn = _c.CFUNCTYPE(_c.c_void_p, cn_task_fn, _c.c_void_p, _c.c_int32, _c.c_int32, _c.c_void_p)


# Returns when every item of the task has run; it may run items itself. Called once for each enqueue that did
# not return NULL, in the thread that enqueued.
cn_finish_fn = _c.CFUNCTYPE(None, _c.c_void_p, _c.c_void_p)


class cn_world_def(_c.Structure):
    """Definition of a world."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS
        ("gravity_mps2", cn_vec2),  # default (0, -10)
        ("length_unit_m", _c.c_float),  # a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1
        ("solver", _c.c_int32),  # CN_SOLVER_*; default CN_SOLVER_AUTO
        ("broadphase", _c.c_int32),  # CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP
        ("substep_count", _c.c_int32),  # 1 to 64; default 4
        ("accuracy_m", _c.c_float),  # CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit
        ("work_budget", _c.c_int32),  # limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with CN_SOLVER_AUTO 512 contacts of a world
        ("restitution_threshold_mps", _c.c_float),  # slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit
        ("push_speed_max_mps", _c.c_float),  # greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved joint closes (of its angles: rad/s, for each length unit), > 0; in a crowd the speeds of neighbours add up: n bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which pushes them upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit
        ("linear_speed_max_mps", _c.c_float),  # faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit
        ("angular_speed_max_radps", _c.c_float),  # faster bodies are slowed to it, > 0; default 400
        ("sleep_speed_mps", _c.c_float),  # bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit
        ("sleep_delay_s", _c.c_float),  # ... after this time, >= 0; default 0.5
        ("body_capacity", _c.c_int32),  # hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0; default 0
        ("shape_capacity", _c.c_int32),  # counts every edge of a chain
        ("contact_capacity", _c.c_int32),  # pairs whose fat AABBs overlap
        ("joint_capacity", _c.c_int32),  # counts constraints too
        ("user_data", _c.c_uint64),  # a number for the user; default 0
        ("memory_bytes", _c.c_uint64),  # size of memory; 0: use alloc and free
        ("memory", _c.c_void_p),  # NULL, or one block aligned to 64 bytes that holds the whole world
        ("alloc", cn_alloc_fn),  # NULL: malloc; set both or none
        ("free", cn_free_fn),  # NULL: free
        ("allocator_user", _c.c_void_p),  # last argument of alloc and free
        ("enqueue", cn_enqueue_fn),  # NULL: the world's own threads; set both or none
        ("finish", cn_finish_fn),  # see cn_finish_fn
        ("task_user", _c.c_void_p),  # last argument of enqueue and finish
        ("worker_count", _c.c_int32),  # threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no tasks
        ("hit_speed_mps", _c.c_float),  # blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit
        ("touching_capacity", _c.c_int32),  # Of a world in one block (memory); others ignore them. pairs that touch at once, >= 0; further ones do not collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity
        ("event_capacity", _c.c_int32),  # pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity
        ("vertex_capacity", _c.c_int32),  # vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block; default CN_POLYGON_MAX_VERTICES
        ("reserve", _c.c_uint32),  # CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all
    ]


class cn_counters(_c.Structure):
    """Counts of objects, and problems of the last step."""

    _fields_ = [
        ("bodies", _c.c_int32),  # alive
        ("bodies_awake", _c.c_int32),  # dynamic and kinematic bodies that are simulated
        ("shapes", _c.c_int32),  # alive
        ("proxies", _c.c_int32),  # boxes in the broadphase: one per shape, one per edge of a chain
        ("contacts", _c.c_int32),  # pairs whose fat boxes overlap
        ("contacts_awake", _c.c_int32),  # with an awake body
        ("contacts_touching", _c.c_int32),  # pairs with a manifold, asleep or awake
        ("joints", _c.c_int32),  # and constraints
        ("joints_awake", _c.c_int32),  # and constraints, with an awake body
        ("islands", _c.c_int32),  # awake and asleep; a single dynamic body counts
        ("islands_awake", _c.c_int32),  # of them
        ("colors_used", _c.c_int32),  # groups of contacts that share no dynamic body
        ("overflow_contacts", _c.c_int32),  # contacts that fit no colour: solved one by one
        ("broadphase_tiles", _c.c_int32),  # cells of the broadphase
        ("steps", _c.c_uint32),  # steps taken since creation, modulo 2^32
        ("warnings", _c.c_uint32),  # Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again. CN_WARNING_*
        ("pairs_not_added", _c.c_int32),  # new pairs without a contact
        ("events_not_reported", _c.c_int32),  # events without a place in a log
        ("islands_direct", _c.c_int32),  # of several bodies, solved directly in the last step, contacts included
        ("direct_work", _c.c_int32),  # planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1
        ("islands_unsolved", _c.c_int32),  # of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET
    ]


class cn_island_report(_c.Structure):
    """Report on one island."""

    _fields_ = [
        ("body", cn_body),  # its body of least slot
        ("bodies", _c.c_int32),  # dynamic
        ("contacts", _c.c_int32),  # touching
        ("joints", _c.c_int32),  # and constraints
        ("tier", _c.c_int32),  # CN_TIER_*, after the last step
        ("reason", _c.c_int32),  # CN_TIER_REASON_*
        ("substeps", _c.c_int32),  # of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more
        ("residual_m", _c.c_float),  # at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count
    ]


class cn_profile(_c.Structure):
    """Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set."""

    _fields_ = [
        ("step_s", _c.c_float),  # the whole step
        ("wake_s", _c.c_float),  # waking
        ("broadphase_s", _c.c_float),  # pairs
        ("narrowphase_s", _c.c_float),  # manifolds
        ("islands_s", _c.c_float),  # islands
        ("prepare_s", _c.c_float),  # constraints, plans
        ("substeps_s", _c.c_float),  # all substeps
        ("finalize_s", _c.c_float),  # poses and boxes
        ("events_s", _c.c_float),  # callbacks
        ("sleep_s", _c.c_float),  # falling asleep
    ]


class cn_memory_stats(_c.Structure):
    """Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
    allocator serves small variable-size pieces from free lists of size classes."""

    _fields_ = [
        ("bytes_in_use", _c.c_uint64),  # taken from the user's allocator or carved from the fixed block
        ("bytes_peak", _c.c_uint64),  # most bytes_in_use since creation
        ("allocator_calls", _c.c_uint64),  # calls of the user's alloc (or of the fixed block's) since creation
        ("arena_capacity", _c.c_uint64),  # of the frame arena
        ("arena_peak", _c.c_uint64),  # most bytes in use at once since creation
        ("arena_fallbacks", _c.c_uint64),  # entries that did not fit: the allocator served them; since creation
        ("blocks_capacity", _c.c_uint64),  # bytes in chunks
        ("blocks_in_use", _c.c_uint64),  # bytes handed out of them
        ("blocks_large", _c.c_uint64),  # blocks above the largest class, served by the allocator
    ]


class cn_body_def(_c.Structure):
    """Definition of a body."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("type", _c.c_int32),  # CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
        ("position_m", cn_vec2),  # of the origin; |x|, |y| <= 1e6 x length unit
        ("angle_rad", _c.c_float),  # |angle| <= 1e4
        ("linear_velocity_mps", cn_vec2),  # of the centre of mass; both velocities are ignored without CN_BODY_AWAKE
        ("angular_velocity_radps", _c.c_float),  # default 0
        ("linear_damping_per_s", _c.c_float),  # v' = -damping v; >= 0, default 0
        ("angular_damping_per_s", _c.c_float),  # >= 0, default 0
        ("gravity_scale", _c.c_float),  # default 1
        ("sleep_speed_mps", _c.c_float),  # >= 0; CN_DEFAULT (default): the world's
        ("flags", _c.c_uint32),  # CN_BODY_*; default ENABLED | SLEEP | AWAKE
        ("solver", _c.c_int32),  # as in cn_body_set_solver; default CN_SOLVER_AUTO
        ("user_data", _c.c_uint64),  # a number for the user; default 0
        ("name", _c.c_char_p),  # NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
    ]


class cn_body_moved(_c.Structure):
    """A body that moved or fell asleep in the last step."""

    _fields_ = [
        ("pose", cn_pose),  # after the step
        ("user_data", _c.c_uint64),  # the body's
        ("body", cn_body),  # that moved
        ("fell_asleep", _c.c_uint32),  # 1 in the step in which it fell asleep
    ]


class cn_filter(_c.Structure):
    """Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
    collide if the category of each has a bit in the mask of the other."""

    _fields_ = [
        ("category", _c.c_uint64),  # default 1
        ("mask", _c.c_uint64),  # default all ones
        ("group", _c.c_int32),  # default 0
        ("reserved", _c.c_uint32),  # 0
    ]


class cn_material(_c.Structure):
    """Surface of a shape."""

    _fields_ = [
        ("static_friction", _c.c_float),  # coefficient while sticking, [0, 100], default 0.6
        ("dynamic_friction", _c.c_float),  # coefficient while sliding, [0, static_friction], default 0.6
        ("restitution", _c.c_float),  # [0, 1], default 0
        ("rolling_resistance", _c.c_float),  # metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0
        ("tangent_speed_mps", _c.c_float),  # conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0
        ("friction_mix", _c.c_int32),  # CN_MIX_*; default CN_MIX_GEOMETRIC
        ("restitution_mix", _c.c_int32),  # CN_MIX_*; default CN_MIX_MAXIMUM
        ("user_id", _c.c_uint32),  # a number for the user, reported in contact events; default 0
    ]


class cn_shape_def(_c.Structure):
    """Definition of a shape."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("body", cn_body),  # 0: create unattached, for cn_shape_attach
        ("offset_m", cn_vec2),  # of the shape in the body's local frame
        ("angle_rad", _c.c_float),  # of the shape in the body's local frame
        ("density_kgpm2", _c.c_float),  # >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
        ("material", cn_material),  # defaults: see cn_material
        ("filter", cn_filter),  # defaults: see cn_filter
        ("event_mask", _c.c_uint32),  # bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE
        ("flags", _c.c_uint32),  # CN_SHAPE_SENSOR ...; default 0
        ("user_data", _c.c_uint64),  # a number for the user; default 0
    ]


class cn_circle(_c.Structure):
    """A disc."""

    _fields_ = [
        ("center_m", cn_vec2),  # in the body's frame
        ("radius_m", _c.c_float),  # > 0
    ]


class cn_capsule(_c.Structure):
    """All points within radius_m of the segment."""

    _fields_ = [
        ("a_m", cn_vec2),  # one end of the segment, in the body's frame
        ("b_m", cn_vec2),  # the other end
        ("radius_m", _c.c_float),  # around the segment, > 0
    ]


class cn_edge(_c.Structure):
    """A two-sided segment without mass."""

    _fields_ = [
        ("a_m", cn_vec2),  # one end, in the body's frame
        ("b_m", cn_vec2),  # the other end
    ]


class cn_polygon(_c.Structure):
    """Convex polygon. Either winding is accepted; points are stored counter-clockwise."""

    _fields_ = [
        ("count", _c.c_int32),  # 3 to CN_POLYGON_MAX_VERTICES
        ("radius_m", _c.c_float),  # rounding added outside the points, >= 0
        ("points_m", cn_vec2 * 16),  # the first count of them; in the body's frame
    ]


class cn_chain(_c.Structure):
    """One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is on
    the left of the order of points and surface normals point to the right: points that run from +x to -x
    collide from above, a counter-clockwise loop collides from outside."""

    _fields_ = [
        ("points_m", _c.POINTER(cn_vec2)),  # copied
        ("count", _c.c_int32),  # an open chain: >= 2; a loop: >= 3; at most 65535
        ("loop", _c.c_uint32),  # 1: the last point joins the first
    ]


class cn_manifold_point(_c.Structure):
    """One point of a contact."""

    _fields_ = [
        ("point_m", cn_vec2),  # world, midway between the surfaces
        ("separation_m", _c.c_float),  # negative when overlapping
        ("normal_impulse_Ns", _c.c_float),  # of the last substep
        ("feature_id", _c.c_uint32),  # the same while the same features touch
    ]


class cn_manifold(_c.Structure):
    """How two shapes touch."""

    _fields_ = [
        ("normal", cn_vec2),  # unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces' by up to 0.1 rad, so that piles stand
        ("friction_impulse_Ns", _c.c_float),  # of the last substep, on body b along (normal.y, -normal.x)
        ("point_count", _c.c_int32),  # 0, 1 or 2
        ("points", cn_manifold_point * 2),  # the first point_count of them
    ]


class cn_contact_event(_c.Structure):
    """A contact event, or the present state of a contact."""

    _fields_ = [
        ("shape_a", cn_shape),  # one shape of the pair
        ("shape_b", cn_shape),  # the other
        ("body_a", cn_body),  # of shape_a
        ("body_b", cn_body),  # of shape_b
        ("child_a", _c.c_int32),  # edge number within a chain, else 0
        ("child_b", _c.c_int32),  # the same of shape b
        ("contact_id", _c.c_uint32),  # the same from CREATED to DESTROYED, then reused
        ("kind", _c.c_int32),  # CN_EVENT_*
        ("approach_speed_mps", _c.c_float),  # ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0
        ("manifold", cn_manifold),  # geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT
        ("normal_impulse_Ns", _c.c_float),  # Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact that its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean force is normal_impulse_Ns / dt_s
        ("friction_impulse_Ns", _c.c_float),  # along (normal.y, -normal.x), on body b
        ("hit_point_m", cn_vec2),  # HIT: where, in the world; else (0, 0)
        ("material_a", _c.c_uint32),  # cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED
        ("material_b", _c.c_uint32),  # the same of shape_b
    ]


class cn_sensor_event(_c.Structure):
    """A shape entered or left a sensor."""

    _fields_ = [
        ("sensor", cn_shape),  # the sensor
        ("visitor", cn_shape),  # the shape that it met
        ("sensor_body", cn_body),  # the sensor's body
        ("visitor_body", cn_body),  # the visitor's body
        ("kind", _c.c_int32),  # CN_EVENT_ENTER or CN_EVENT_LEAVE
        ("reserved", _c.c_uint32),  # 0
    ]


class cn_joint_base(_c.Structure):
    """First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
    limits in place; springs and motors are not rigid parts."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # of the whole definition
        ("flags", _c.c_uint32),  # CN_JOINT_*; default 0; a type ignores flags that it does not use
        ("body_a", cn_body),  # 0: the world
        ("body_b", cn_body),  # 0: the world; one of the two must be dynamic
        ("anchor_a_m", cn_vec2),  # in body a's local frame, or in world coordinates
        ("anchor_b_m", cn_vec2),  # the same for body b
        ("stiffness_hertz", _c.c_float),  # of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of all springs; CN_DEFAULT (default): as stiff as the substeps permit
        ("stiffness_damping_ratio", _c.c_float),  # used with a stiffness_hertz; 0 to 1e6, default 0
        ("force_max_N", _c.c_float),  # greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded
        ("torque_max_Nm", _c.c_float),  # greatest torque of angles, > 0; CN_DEFAULT (default): unbounded
        ("break_force_N", _c.c_float),  # a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
        ("break_torque_Nm", _c.c_float),  # the same for the torque
        ("user_data", _c.c_uint64),  # a number for the user; default 0
    ]


class cn_revolute_def(_c.Structure):
    """Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi]."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("reference_angle_rad", _c.c_float),  # angle b - angle a at joint angle 0
        ("lower_angle_rad", _c.c_float),  # CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
        ("upper_angle_rad", _c.c_float),  # the upper limit
        ("motor_speed_radps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_torque_max_Nm", _c.c_float),  # >= 0
        ("spring_target_rad", _c.c_float),  # CN_JOINT_SPRING: pulls the joint angle to this
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
    ]


class cn_distance_def(_c.Structure):
    """Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
    length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max];
    limits alone make a rope (min 0)."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("length_m", _c.c_float),  # > 0; default 1
        ("length_min_m", _c.c_float),  # CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
        ("length_max_m", _c.c_float),  # the upper limit
        ("motor_speed_mps", _c.c_float),  # CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
        ("motor_force_max_N", _c.c_float),  # >= 0
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
        ("reserved", _c.c_float),  # 0
    ]


class cn_fixed_def(_c.Structure):
    """Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("reference_angle_rad", _c.c_float),  # angle b - angle a
        ("angular_hertz", _c.c_float),  # stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's
        ("angular_damping_ratio", _c.c_float),  # 0 to 1e6
        ("reserved", _c.c_float),  # 0
    ]


class cn_prismatic_def(_c.Structure):
    """b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("axis", cn_vec2),  # in body a's frame, any length > 0 (read back with length 1); default (1, 0)
        ("reference_angle_rad", _c.c_float),  # angle b - angle a
        ("lower_m", _c.c_float),  # CN_JOINT_LIMIT: lower <= upper
        ("upper_m", _c.c_float),  # the upper limit
        ("motor_speed_mps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_force_max_N", _c.c_float),  # >= 0
        ("spring_target_m", _c.c_float),  # CN_JOINT_SPRING: pulls the translation to this
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
    ]


class cn_wheel_def(_c.Structure):
    """A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
    by the motor."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("axis", cn_vec2),  # in body a's frame, any length > 0 (read back with length 1); default (0, 1)
        ("lower_m", _c.c_float),  # CN_JOINT_LIMIT: lower <= upper
        ("upper_m", _c.c_float),  # the upper limit
        ("motor_speed_radps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_torque_max_Nm", _c.c_float),  # >= 0
        ("spring_hertz", _c.c_float),  # CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6, default 0.7
    ]


class cn_motor_def(_c.Structure):
    """Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
    base.torque_max_Nm must be > 0."""

    _fields_ = [
        ("base", cn_joint_base),  # anchor b is driven to anchor a + offset
        ("offset_m", cn_vec2),  # in body a's frame
        ("angle_rad", _c.c_float),  # angle b - angle a
        ("hertz", _c.c_float),  # frequency of the spring, > 0, to 1e6; default 5
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 1
        ("reserved", _c.c_float),  # 0
    ]


class cn_mouse_def(_c.Structure):
    """Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
    base.force_max_N must be > 0."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("target_m", cn_vec2),  # world
        ("hertz", _c.c_float),  # > 0, to 1e6; default 5
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 0.7
    ]


class cn_gear_def(_c.Structure):
    """angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
    and count whole turns from there."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("ratio", _c.c_float),  # size 1e-4 to 1e4, negative: they turn against each other; default 1
        ("phase_rad", _c.c_float),  # default 0
    ]


class cn_pulley_def(_c.Structure):
    """A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never
    pushes."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("ground_a_m", cn_vec2),  # world
        ("ground_b_m", cn_vec2),  # world
        ("ratio", _c.c_float),  # 1e-4 to 1e4; default 1
        ("length_m", _c.c_float),  # > 0: must be set
    ]


class cn_ratchet_def(_c.Structure):
    """b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase
    + n * click_rad for every whole number n, over whole turns."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("phase_rad", _c.c_float),  # default 0
        ("click_rad", _c.c_float),  # size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise
    ]


class cn_rotary_spring_def(_c.Structure):
    """A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
    the two bodies."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("rest_angle_rad", _c.c_float),  # default 0
        ("hertz", _c.c_float),  # > 0, to 1e6; default 1
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 0
        ("reserved", _c.c_float),  # 0
    ]


class cn_groove_def(_c.Structure):
    """Anchor b slides in a slot of body a from anchor a to end_m."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
        ("end_m", cn_vec2),  # in body a's frame; not equal to anchor a; default (1, 0)
    ]


class cn_filter_joint_def(_c.Structure):
    """The two bodies do not collide; no other effect."""

    _fields_ = [
        ("base", cn_joint_base),  # what every joint has
    ]


class cn_joint_event(_c.Structure):
    """A joint or constraint exceeded a break threshold or was destroyed with a body."""

    _fields_ = [
        ("joint", cn_joint),  # 0: it was a constraint; stale when destroyed is 1
        ("constraint", cn_constraint),  # 0: it was a joint; stale when destroyed is 1
        ("body_a", cn_body),  # 0: the world
        ("body_b", cn_body),  # 0: the world
        ("force_N", _c.c_float),  # largest reaction of the step; 0 when a body was destroyed
        ("torque_Nm", _c.c_float),  # the same for the torque
        ("destroyed", _c.c_uint32),  # 1: it broke, or one of its bodies was destroyed
        ("reserved", _c.c_uint32),  # 0
        ("user_data", _c.c_uint64),  # the joint's or constraint's
    ]


class cn_angle_constraint_def(_c.Structure):
    """Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
    there."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_CONSTRAINT_*; default 0
        ("body", cn_body),  # must be dynamic
        ("lower_rad", _c.c_float),  # lower <= upper; equal: locked
        ("upper_rad", _c.c_float),  # the upper limit
        ("hertz", _c.c_float),  # > 0, to 1e6; CN_DEFAULT (default): rigid
        ("damping_ratio", _c.c_float),  # used with a hertz; 0 to 1e6
        ("break_torque_Nm", _c.c_float),  # a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
        ("user_data", _c.c_uint64),  # a number for the user; default 0
    ]


class cn_line_constraint_def(_c.Structure):
    """Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along
    the line."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_CONSTRAINT_*; default 0
        ("body", cn_body),  # must be dynamic
        ("anchor_m", cn_vec2),  # in the body's frame
        ("origin_m", cn_vec2),  # of the line, world
        ("axis", cn_vec2),  # world, any length > 0 (read back with length 1); default (1, 0)
        ("tolerance_m", _c.c_float),  # >= 0: free play across the axis
        ("lower_m", _c.c_float),  # CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper
        ("upper_m", _c.c_float),  # the upper limit
        ("hertz", _c.c_float),  # > 0, to 1e6; CN_DEFAULT (default): rigid
        ("damping_ratio", _c.c_float),  # used with a hertz; 0 to 1e6
        ("break_force_N", _c.c_float),  # a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
        ("reserved", _c.c_uint32),  # 0
        ("user_data", _c.c_uint64),  # a number for the user; default 0
    ]


class cn_update_report(_c.Structure):
    """Result of cn_world_update."""

    _fields_ = [
        ("steps", _c.c_int32),  # fixed steps taken
        ("leftover_s", _c.c_float),  # time kept for the next update
        ("dropped_s", _c.c_float),  # time discarded because of steps_max
        ("interpolation", _c.c_float),  # leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated
    ]


class cn_ray(_c.Structure):
    """A ray with an end."""

    _fields_ = [
        ("origin_m", cn_vec2),  # world
        ("translation_m", cn_vec2),  # at most 2e6 length units each way; 0 hits only shapes around the origin
    ]


class cn_ray_hit(_c.Structure):
    """What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
    shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
    depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it."""

    _fields_ = [
        ("shape", cn_shape),  # 0: nothing was hit
        ("body", cn_body),  # the shape's
        ("child", _c.c_int32),  # edge of a chain
        ("fraction", _c.c_float),  # of the translation, [0, 1]; 1 when nothing was hit
        ("point_m", cn_vec2),  # on the surface of the shape that was hit
        ("normal", cn_vec2),  # unit, out of the shape that was hit
        ("depth_m", _c.c_float),  # depth of the start inside it, 0 outside
        ("reserved", _c.c_uint32),  # 0
    ]


# Called by a query for each shape (edge of a chain) found, in no particular order and perhaps more than once:
# the result, CN_QUERY_*, must depend on the shape alone. hit is complete in casts; other queries set shape,
# body and child. May call only functions that take a const world, also of the same world.
cn_query_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), _c.POINTER(cn_ray_hit), _c.c_void_p)


class cn_query_filter(_c.Structure):
    """Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
    bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
    steps."""

    _fields_ = [
        ("category", _c.c_uint64),  # default 1
        ("mask", _c.c_uint64),  # default all ones
        ("ignored_body", cn_body),  # its shapes are ignored; 0 (default): none. A stale handle is an error
        ("flags", _c.c_uint32),  # CN_QUERY_IGNORE_JOINED ...; default 0
        ("visit", cn_query_fn),  # NULL (default): take all shapes
        ("user", _c.c_void_p),  # last argument of visit
    ]


class cn_closest(_c.Structure):
    """The shape nearest to a point."""

    _fields_ = [
        ("shape", cn_shape),  # 0: nothing within the distance
        ("body", cn_body),  # the shape's
        ("child", _c.c_int32),  # edge of a chain
        ("distance_m", _c.c_float),  # negative: depth inside a shape with area
        ("point_m", cn_vec2),  # on the surface
        ("normal", cn_vec2),  # outward there; of edges and chains towards the point
    ]


class cn_distance(_c.Structure):
    """Distance of two shapes."""

    _fields_ = [
        ("point_a_m", cn_vec2),  # on the surface of a, in the world
        ("point_b_m", cn_vec2),  # on the surface of b
        ("normal", cn_vec2),  # unit, from a to b
        ("distance_m", _c.c_float),  # of the surfaces; negative: the depth, the shortest translation of b out of a
        ("reserved", _c.c_uint32),  # 0
    ]


class cn_sweep(_c.Structure):
    """A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about it
    at a constant rate."""

    _fields_ = [
        ("start", cn_pose),  # of the shape, before the motion
        ("center_m", cn_vec2),  # that point, in the shape's frame: the centre of mass of a body
        ("translation_m", cn_vec2),  # of it; at most 2e6 m each way
        ("turn_rad", _c.c_float),  # counter-clockwise, |turn| <= 1e4
        ("reserved", _c.c_uint32),  # 0
    ]


class cn_impact(_c.Structure):
    """Result of cn_polygon_time_of_impact."""

    _fields_ = [
        ("state", _c.c_int32),  # CN_IMPACT_*
        ("fraction", _c.c_float),  # of both motions, [0, 1]
        ("point_m", cn_vec2),  # HIT only, as are the next two: between the surfaces
        ("normal", cn_vec2),  # unit, from a to b
        ("distance_m", _c.c_float),  # of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it
        ("reserved", _c.c_uint32),  # 0
    ]


class cn_plane(_c.Structure):
    """A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0, unless
    that needs a push of more than push_max_m."""

    _fields_ = [
        ("normal", cn_vec2),  # unit, from the surface to the shape
        ("point_m", cn_vec2),  # world point of least distance
        ("separation_m", _c.c_float),  # of the surfaces along the normal; negative: they overlap
        ("push_max_m", _c.c_float),  # greatest push of this plane, >= 0; FLT_MAX: rigid
        ("push_m", _c.c_float),  # its push in the last cn_mover_solve
        ("shape", cn_shape),  # whose surface it is
        ("body", cn_body),  # the shape's
        ("child", _c.c_int32),  # edge of a chain
    ]


class cn_mover_def(_c.Structure):
    """How a character moves. It may change between moves: crouching is another shape."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_MOVER_DROP; default 0
        ("shape", cn_polygon),  # around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
        ("filter", cn_query_filter),  # shapes that it collides with; sensors never, one-way shapes from above
        ("up", cn_vec2),  # any length > 0; default (0, 1)
        ("slope_limit_rad", _c.c_float),  # greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)
        ("step_height_m", _c.c_float),  # greatest height of steps that it climbs, >= 0; default 0.3
        ("snap_m", _c.c_float),  # a walking character follows ground that falls by up to this in a move, >= 0; default 0.3
        ("gravity_scale", _c.c_float),  # of the world's gravity in the air; default 1
        ("push_force_N", _c.c_float),  # greatest push on a dynamic body, >= 0; default 200
        ("iterations_max", _c.c_int32),  # of sliding, 1 to 64; default 8
    ]


class cn_mover(_c.Structure):
    """State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
    world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
    filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
    position."""

    _fields_ = [
        ("position_m", cn_vec2),  # of the shape's origin, world
        ("velocity_mps", cn_vec2),  # in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its component across up; the one along up is 0, and a jump when the caller makes it > 0
        ("ground_normal", cn_vec2),  # of the ground with CN_MOVER_ON_GROUND, else (0, 0)
        ("ground_point_m", cn_vec2),  # in the world, after the move
        ("ground_local_m", cn_vec2),  # ... in the frame of ground_body
        ("ground_velocity_mps", cn_vec2),  # of the ground there
        ("ground_body", cn_body),  # 0: none; a stale handle counts as none
        ("ground_shape", cn_shape),  # the same for its shape
        ("flags", _c.c_uint32),  # CN_MOVER_ON_*, after the last move
        ("squeezed_m", _c.c_float),  # overlap with surfaces that leave it no room; else 0 up to rounding
    ]


class cn_area_def(_c.Structure):
    """What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity.
    Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
    accelerations, damping and forces add up."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_AREA_REPLACE; default 0
        ("priority", _c.c_int32),  # default 0
        ("gravity_mps2", cn_vec2),  # acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)
        ("center_m", cn_vec2),  # of pull_mps2, in the frame of the sensor's body; default (0, 0)
        ("pull_mps2", _c.c_float),  # acceleration towards center_m; negative pushes; default 0
        ("pull_distance_m", _c.c_float),  # CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with its inverse square outside, and falling to 0 at the centre: a homogeneous planet
        ("linear_damping_per_s", _c.c_float),  # of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0
        ("angular_damping_per_s", _c.c_float),  # ... of the rotation; 0 to 1e9, default 0
        ("density_kgpm2", _c.c_float),  # of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0
        ("drag_kgpm2", _c.c_float),  # density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0
        ("lift_kgpm2", _c.c_float),  # density times lift coefficient; 0 to 1e9, default 0
        ("flow_mps", cn_vec2),  # velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)
    ]


class cn_explosion_def(_c.Structure):
    """Definition of an explosion."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("radius_m", _c.c_float),  # full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1
        ("falloff_m", _c.c_float),  # then linearly to 0 over this distance, 0 to 1e6 length units; default 0
        ("impulse_Nspm", _c.c_float),  # per metre of the shape's width seen from the centre; negative pulls; default 0
        ("center_m", cn_vec2),  # world
        ("filter", cn_query_filter),  # which shapes; defaults: see cn_query_filter
    ]


# count points, counter-clockwise
cn_debug_draw_polygon_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_int32, _c.c_float, _c.c_uint32, _c.c_void_p)


# rim_m: a point on the rim that turns with the body
cn_debug_draw_circle_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_float, _c.POINTER(cn_vec2), _c.c_uint32, _c.c_void_p)


# a disc swept from a to b
cn_debug_draw_capsule_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2), _c.c_float, _c.c_uint32, _c.c_void_p)


# a line from a to b
cn_debug_draw_segment_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2), _c.c_uint32, _c.c_void_p)


# size in pixels
cn_debug_draw_point_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_float, _c.c_uint32, _c.c_void_p)


# zero-terminated, valid during the call
cn_debug_draw_text_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_char_p, _c.c_uint32, _c.c_void_p)


class cn_debug_draw(_c.Structure):
    """The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
    coordinates."""

    _fields_ = [
        ("struct_size", _c.c_uint32),  # set by the init function
        ("flags", _c.c_uint32),  # CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
        ("view", cn_aabb),  # things outside are not drawn; default everything
        ("polygon", cn_debug_draw_polygon_fn),  # count points, counter-clockwise
        ("circle", cn_debug_draw_circle_fn),  # rim_m: a point on the rim that turns with the body
        ("capsule", cn_debug_draw_capsule_fn),  # a disc swept from a to b
        ("segment", cn_debug_draw_segment_fn),  # a line from a to b
        ("point", cn_debug_draw_point_fn),  # size in pixels
        ("text", cn_debug_draw_text_fn),  # zero-terminated, valid during the call
        ("user", _c.c_void_p),  # last argument of the functions
        ("reserved", _c.c_void_p),  # 0
    ]


# Called at the end of cn_world_step for each event of this kind, in the order of the array.
cn_contact_event_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_world), _c.POINTER(cn_contact_event), _c.c_void_p)


# Returns 1 if two shapes that pass their filters may touch, else 0. Called when their boxes begin to overlap;
# the world is locked.
cn_filter_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), cn_shape, cn_shape, _c.c_void_p)


# Called in every step, before solving, for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE; the
# event's kind is STAY or ENTER. Returns 0 to let the pair pass through each other in this step, else 1.
cn_pre_solve_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), _c.POINTER(cn_contact_event), _c.c_void_p)


# Mixes two materials instead of the CN_MIX_ rules: *mixed holds the rules' result and takes the new one.
# Called when a pair begins to touch and when a material changes.
cn_material_mix_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_world), cn_shape, cn_shape, _c.POINTER(cn_material), _c.c_void_p)


# Returns 0 to stop the search, any other value to continue.
cn_tree_query_fn = _c.CFUNCTYPE(_c.c_int32, _c.c_uint32, _c.c_uint64, _c.c_void_p)


# Returns the fraction at which the ray now ends: the given one to ignore the item, 0 to stop.
cn_tree_ray_fn = _c.CFUNCTYPE(_c.c_float, _c.c_uint32, _c.c_uint64, _c.c_float, _c.c_void_p)


cn_version = _function(
    "cn_version",
    """Version of the library as major * 1000000 + minor * 1000 + patch.""",
    _c.c_int32,
)
cn_abi_version = _function(
    "cn_abi_version",
    """CN_ABI_VERSION of the library that was linked; a binding compares it with its own.""",
    _c.c_int32,
)
cn_result_text = _function(
    "cn_result_text",
    """English text for a result code: static, never NULL.""",
    _c.c_char_p, cn_result,
)
cn_sizeof = _function(
    "cn_sizeof",
    """sizeof the struct that a CN_TYPE_ constant names, 0 for an unknown constant; bindings check their layouts
    with it.""",
    _c.c_int32, _c.c_int32,
)
cn_world_def_init = _function(
    "cn_world_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing. Defaults that scale with the
    length unit are stored as CN_DEFAULT, which cn_world_create resolves.""",
    None, _c.POINTER(cn_world_def),
)
cn_world_def_check = _function(
    "cn_world_def_check",
    """Checks a definition. Writes one sentence about its first error, at most text_bytes (>= 0) bytes with the
    terminating zero; text may be NULL when text_bytes is 0.""",
    cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.c_char), _c.c_int32,
)
cn_world_bytes_needed = _function(
    "cn_world_bytes_needed",
    """Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here.""",
    cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.c_uint64),
)
cn_world_create = _function(
    "cn_world_create",
    """Creates a world. CN_ERROR_MEMORY also when a thread cannot be started. Each worker takes about 150 bytes
    of the world's memory; its stack comes from the system, even for a world in a caller's block. Without
    thread support (CN_NO_THREADS, or an unknown system) the world has one worker: see
    cn_world_get_worker_count. O(capacities).""",
    cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.POINTER(cn_world)),
)
cn_world_destroy = _function(
    "cn_world_destroy",
    """Destroys a world, everything in it and its threads. A caller's block is free for other use afterwards.
    NULL, and a call from a callback, do nothing. O(memory blocks).""",
    None, _c.POINTER(cn_world),
)
cn_world_step = _function(
    "cn_world_step",
    """Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
    O(awake bodies and their contacts and joints).""",
    cn_result, _c.POINTER(cn_world), _c.c_float,
)
cn_world_error_text = _function(
    "cn_world_error_text",
    """One sentence about the last call that failed on this world; '' if none failed or world is NULL. Valid
    until the next failing call.""",
    _c.c_char_p, _c.POINTER(cn_world),
)
cn_world_set_gravity = _function(
    "cn_world_set_gravity",
    """Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float,
)
cn_world_get_gravity = _function(
    "cn_world_get_gravity",
    """Reads gravity in m/s^2.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_vec2),
)
cn_world_set_substep_count = _function(
    "cn_world_set_substep_count",
    """Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.""",
    cn_result, _c.POINTER(cn_world), _c.c_int32,
)
cn_world_get_substep_count = _function(
    "cn_world_get_substep_count",
    """Reads the substeps of a step.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32),
)
cn_world_set_solver = _function(
    "cn_world_set_solver",
    """Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
    memory of the solver it was created with; a solver that needs more works without direct solving
    (CN_WARNING_FRAME_MEMORY).""",
    cn_result, _c.POINTER(cn_world), _c.c_int32,
)
cn_world_get_solver = _function(
    "cn_world_get_solver",
    """Reads the solver (CN_SOLVER_*).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32),
)
cn_world_set_accuracy = _function(
    "cn_world_set_accuracy",
    """Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_int32,
)
cn_world_get_accuracy = _function(
    "cn_world_get_accuracy",
    """Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
    (CN_DEFAULT: none).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_float), _c.POINTER(_c.c_int32),
)
cn_world_get_worker_count = _function(
    "cn_world_get_worker_count",
    """Reads how many workers a step can use: 1, or worker_count where the library supports threads.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32),
)
cn_world_set_flags = _function(
    "cn_world_set_flags",
    """Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).""",
    cn_result, _c.POINTER(cn_world), _c.c_uint32,
)
cn_world_get_flags = _function(
    "cn_world_get_flags",
    """Reads the CN_WORLD_ flags.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint32),
)
cn_world_set_restitution_threshold = _function(
    "cn_world_set_restitution_threshold",
    """Impacts slower than this, in m/s, do not bounce; >= 0.""",
    cn_result, _c.POINTER(cn_world), _c.c_float,
)
cn_world_set_hit_speed = _function(
    "cn_world_set_hit_speed",
    """Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.""",
    cn_result, _c.POINTER(cn_world), _c.c_float,
)
cn_world_set_speed_limits = _function(
    "cn_world_set_speed_limits",
    """Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster bodies
    down to them and keeps the direction.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float,
)
cn_world_set_sleep = _function(
    "cn_world_set_sleep",
    """Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
    they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
    others that no joint holds and that are slower than four times the speed lose theirs within a second or
    two: what rocks in a hollow would keep all of a heap awake.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float,
)
cn_world_set_user_data = _function(
    "cn_world_set_user_data",
    """Stores a number for the user.""",
    cn_result, _c.POINTER(cn_world), _c.c_uint64,
)
cn_world_get_user_data = _function(
    "cn_world_get_user_data",
    """Reads the user's number.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64),
)
cn_world_get_bodies = _function(
    "cn_world_get_bodies",
    """Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
    capacity is 0. out_count is their number. O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_get_shapes = _function(
    "cn_world_get_shapes",
    """Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_get_joints = _function(
    "cn_world_get_joints",
    """Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
    cn_world_get_bodies. O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_joint), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_get_counters = _function(
    "cn_world_get_counters",
    """Reads counts of objects and what the last step reported. O(bodies + islands).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_counters),
)
cn_world_get_islands = _function(
    "cn_world_get_islands",
    """Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in a
    deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their number. A
    step does no work for it. O(bodies + contacts and joints of the islands written).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_island_report), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_get_profile = _function(
    "cn_world_get_profile",
    """Reads the seconds of the last step by stage.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_profile),
)
cn_world_get_memory_stats = _function(
    "cn_world_get_memory_stats",
    """Reads the memory statistics.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_memory_stats),
)
cn_world_shift_origin = _function(
    "cn_world_shift_origin",
    """Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position p
    becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes, world
    anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and no
    event is reported. Distances between bodies keep their digits; world anchors are rounded to floats at the
    new place. Arrays returned before become invalid; the user moves their own points (movers, rays, cached
    poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all pairs
    again.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float,
)
cn_world_hash = _function(
    "cn_world_hash",
    """64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
    contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on every
    compiler, CPU and thread count. O(bodies + contacts + joints).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64),
)
cn_world_validate = _function(
    "cn_world_validate",
    """Checks every invariant between the tables. CN_ERROR_INTERNAL, and one sentence in text, for the first that
    is broken. text holds at most text_bytes (>= 0) bytes with the zero and may be NULL when text_bytes is 0.
    O(everything).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_char), _c.c_int32,
)
cn_world_save_size = _function(
    "cn_world_save_size",
    """Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64),
)
cn_world_save = _function(
    "cn_world_save",
    """Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
    number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
    about 1 KB per body.""",
    cn_result, _c.POINTER(cn_world), _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64),
)
cn_world_restore = _function(
    "cn_world_restore",
    """Restores a saved state, into the saved world or one created with the same definition (broadphase, length
    unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT for
    damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then (a
    world in a caller's block has room for its own saves). Arrays returned before become invalid. Handles of
    objects alive at the save are valid again, also of objects destroyed since; handles created since are
    refused until the same handle is given to a new object: with the same calls to the same object. O(memory
    of the world).""",
    cn_result, _c.POINTER(cn_world), _c.c_void_p, _c.c_uint64,
)
cn_save_delta_size = _function(
    "cn_save_delta_size",
    """Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).""",
    cn_result, _c.c_void_p, _c.c_uint64, _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64),
)
cn_save_delta = _function(
    "cn_save_delta",
    """Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
    out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).""",
    cn_result, _c.c_void_p, _c.c_uint64, _c.c_void_p, _c.c_uint64, _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64),
)
cn_save_apply = _function(
    "cn_save_apply",
    """Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
    out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
    CN_ERROR_CAPACITY if out is too small. O(bytes).""",
    cn_result, _c.c_void_p, _c.c_uint64, _c.c_void_p, _c.c_uint64, _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64),
)
cn_world_write_size = _function(
    "cn_world_write_size",
    """Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64),
)
cn_world_write = _function(
    "cn_world_write",
    """Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of
    bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB
    per body.""",
    cn_result, _c.POINTER(cn_world), _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64),
)
cn_world_read = _function(
    "cn_world_read",
    """Creates a world from bytes of cn_world_write (bytes: exactly as many). def, which may be NULL for
    defaults, gives memory, workers and capacities (which a caller's block needs); its settings are not used,
    the file's are. CN_ERROR_FORMAT for damaged or forged bytes, CN_ERROR_MEMORY without room,
    CN_ERROR_ARGUMENT for a definition that cn_world_create refuses. O(memory of the world).""",
    cn_result, _c.POINTER(cn_world_def), _c.c_void_p, _c.c_uint64, _c.POINTER(_c.POINTER(cn_world)),
)
cn_body_def_init = _function(
    "cn_body_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_body_def),
)
cn_body_create = _function(
    "cn_body_create",
    """Creates a body. O(1) amortized.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body_def), _c.POINTER(cn_body),
)
cn_body_create_many = _function(
    "cn_body_create_many",
    """Creates count (>= 0) bodies from an array of definitions, all or none. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body_def), _c.c_int32, _c.POINTER(cn_body),
)
cn_body_destroy = _function(
    "cn_body_destroy",
    """Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
    contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
    joints + shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body,
)
cn_body_destroy_many = _function(
    "cn_body_destroy_many",
    """Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice. O(their
    contacts + joints + shapes).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32,
)
cn_body_is_valid = _function(
    "cn_body_is_valid",
    """1 if the handle names a living body of this world, else 0 (also for a NULL world).""",
    _c.c_int32, _c.POINTER(cn_world), cn_body,
)
cn_body_set_type = _function(
    "cn_body_set_type",
    """Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
    still overlap begin again in the next step), with its forces and any mass override; a body made static
    stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32,
)
cn_body_get_type = _function(
    "cn_body_get_type",
    """Reads the type (CN_BODY_*).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_int32),
)
cn_body_set_flags = _function(
    "cn_body_set_flags",
    """Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
    CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints are
    inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_uint32,
)
cn_body_get_flags = _function(
    "cn_body_get_flags",
    """Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_uint32),
)
cn_body_set_awake = _function(
    "cn_body_set_awake",
    """0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
    bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32,
)
cn_body_set_pose = _function(
    "cn_body_set_pose",
    """Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <= 1e4).
    Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports them. Gaps
    of its joints close at some 15 length units a second. Wakes the body and its new and old neighbours.
    O(contacts + joints + shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float,
)
cn_body_get_pose = _function(
    "cn_body_get_pose",
    """Reads the position of the origin and the rotation.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_pose),
)
cn_body_get_position_parts = _function(
    "cn_body_get_position_parts",
    """Reads the position of the origin as the sum of two floats: the high part is within rounding that of
    cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double
    is more precise; so is a difference of two bodies, taken high from high and low from low, in floats.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2),
)
cn_body_get_angle = _function(
    "cn_body_get_angle",
    """Reads the angle in radians, in (-pi, pi].""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float),
)
cn_body_get_center = _function(
    "cn_body_get_center",
    """Reads the world position of the centre of mass, in metres.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_vec2),
)
cn_body_set_velocity = _function(
    "cn_body_set_velocity",
    """Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite. CN_ERROR_STATE
    for static bodies. Wakes the body unless all are 0.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float,
)
cn_body_get_velocity = _function(
    "cn_body_get_velocity",
    """Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_velocity),
)
cn_body_set_target_pose = _function(
    "cn_body_set_target_pose",
    """Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it
    to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike after
    cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before every step,
    or stop the body after it.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float,
)
cn_body_get_velocity_at = _function(
    "cn_body_get_velocity_at",
    """Velocity in m/s of the body's material at a world point in metres.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2),
)
cn_body_get_world_point = _function(
    "cn_body_get_world_point",
    """World position of a point given in the body's frame, both in metres.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2),
)
cn_body_get_local_point = _function(
    "cn_body_get_local_point",
    """Position in the body's frame of a world point, both in metres.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2),
)
cn_body_get_aabb = _function(
    "cn_body_get_aabb",
    """Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
    O(shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_aabb),
)
cn_body_apply_force = _function(
    "cn_body_apply_force",
    """Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
    and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float,
)
cn_body_apply_force_at = _function(
    "cn_body_apply_force_at",
    """Adds a force in newtons at a world point in metres, hence a torque too; otherwise as cn_body_apply_force.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float,
)
cn_body_apply_torque = _function(
    "cn_body_apply_torque",
    """Adds a torque in newton metres; otherwise as cn_body_apply_force.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float,
)
cn_body_apply_impulse = _function(
    "cn_body_apply_impulse",
    """Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
    Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity overflows.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float,
)
cn_body_apply_impulse_at = _function(
    "cn_body_apply_impulse_at",
    """Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
    otherwise as cn_body_apply_impulse.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float,
)
cn_body_apply_angular_impulse = _function(
    "cn_body_apply_angular_impulse",
    """Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
    cn_body_apply_impulse.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float,
)
cn_body_get_mass_data = _function(
    "cn_body_get_mass_data",
    """Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
    shapes have no mass weighs 1 kg; without shapes it does not rotate.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_mass_data),
)
cn_body_set_mass_data = _function(
    "cn_body_set_mass_data",
    """Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
    change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes
    the body.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_mass_data),
)
cn_body_reset_mass_data = _function(
    "cn_body_reset_mass_data",
    """Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body,
)
cn_body_set_damping = _function(
    "cn_body_set_damping",
    """Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float,
)
cn_body_get_damping = _function(
    "cn_body_get_damping",
    """Reads the linear and angular damping in 1/s.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float),
)
cn_body_set_gravity_scale = _function(
    "cn_body_set_gravity_scale",
    """Sets the factor on gravity for this body, finite. A change wakes the body.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float,
)
cn_body_get_gravity_scale = _function(
    "cn_body_get_gravity_scale",
    """Reads the factor on gravity.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float),
)
cn_body_set_sleep_speed = _function(
    "cn_body_set_sleep_speed",
    """Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_float,
)
cn_body_set_solver = _function(
    "cn_body_set_solver",
    """Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
    the world chooses. _SOFT: contacts and joints are never solved directly, whatever other bodies ask for.
    _DIRECT: the island is solved directly at any speed, where its contacts permit it and within the
    work_budget. Takes effect with the next step; does not wake.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32,
)
cn_body_get_solver = _function(
    "cn_body_get_solver",
    """Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_int32),
)
cn_body_set_user_data = _function(
    "cn_body_set_user_data",
    """Stores a number for the user.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_uint64,
)
cn_body_get_user_data = _function(
    "cn_body_get_user_data",
    """Reads the user's number.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_uint64),
)
cn_body_set_name = _function(
    "cn_body_set_name",
    """Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or '' removes it.
    O(length).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.c_char_p,
)
cn_body_get_name = _function(
    "cn_body_get_name",
    """Reads the name, '' if there is none. Valid until the name changes or the body is destroyed.""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_char_p),
)
cn_body_get_shapes = _function(
    "cn_body_get_shapes",
    """Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_body_get_joints = _function(
    "cn_body_get_joints",
    """Handles of the body's joints without constraints; out, capacity and *out_count as in cn_world_get_bodies.
    O(joints).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_joint), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_read_poses = _function(
    "cn_world_read_poses",
    """Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
    their number. One bad handle fails the whole call. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_pose),
)
cn_world_read_poses_strided = _function(
    "cn_world_read_poses_strided",
    """Reads count cn_pose at intervals of stride_bytes (0, tightly packed, or >= 16); otherwise as
    cn_world_read_poses. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.c_void_p, _c.c_int32,
)
cn_world_read_velocities = _function(
    "cn_world_read_velocities",
    """Reads count velocities; bodies and count as in cn_world_read_poses. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_velocity),
)
cn_world_write_velocities = _function(
    "cn_world_write_velocities",
    """Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
    bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_velocity),
)
cn_world_moved = _function(
    "cn_world_moved",
    """Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
    first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_body_moved)), _c.POINTER(_c.c_int32),
)
cn_shape_def_init = _function(
    "cn_shape_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_shape_def),
)
cn_shape_create_circle = _function(
    "cn_shape_create_circle",
    """Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_circle), _c.POINTER(cn_shape),
)
cn_shape_create_capsule = _function(
    "cn_shape_create_capsule",
    """Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body. out_shape
    may be NULL.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_capsule), _c.POINTER(cn_shape),
)
cn_shape_create_edge = _function(
    "cn_shape_create_edge",
    """Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_edge), _c.POINTER(cn_shape),
)
cn_shape_create_polygon = _function(
    "cn_shape_create_polygon",
    """Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
    out_shape may be NULL.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_polygon), _c.POINTER(cn_shape),
)
cn_shape_create_box = _function(
    "cn_shape_create_box",
    """Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body. out_shape
    may be NULL.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_shape),
)
cn_shape_create_chain = _function(
    "cn_shape_create_chain",
    """Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape may
    be NULL. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_chain), _c.POINTER(cn_shape),
)
cn_shape_attach = _function(
    "cn_shape_attach",
    """Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
    CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).""",
    cn_result, _c.POINTER(cn_world), cn_shape, cn_body,
)
cn_shape_detach = _function(
    "cn_shape_detach",
    """Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
    O(contacts + shapes of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape,
)
cn_shape_destroy = _function(
    "cn_shape_destroy",
    """Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape,
)
cn_shape_is_valid = _function(
    "cn_shape_is_valid",
    """1 if the handle names a living shape of this world, else 0 (also for a NULL world).""",
    _c.c_int32, _c.POINTER(cn_world), cn_shape,
)
cn_shape_get_type = _function(
    "cn_shape_get_type",
    """Reads the type (CN_SHAPE_CIRCLE to _CHAIN).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_int32),
)
cn_shape_get_body = _function(
    "cn_shape_get_body",
    """Reads the body; 0 if unattached.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_body),
)
cn_shape_set_material = _function(
    "cn_shape_set_material",
    """Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
    body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_material),
)
cn_shape_get_material = _function(
    "cn_shape_get_material",
    """Reads the material.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_material),
)
cn_shape_set_density = _function(
    "cn_shape_set_density",
    """Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and wakes
    the body. O(shapes of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_float,
)
cn_shape_get_density = _function(
    "cn_shape_get_density",
    """Reads the density in kg/m^2.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_float),
)
cn_shape_set_filter = _function(
    "cn_shape_set_filter",
    """Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
    begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_filter),
)
cn_shape_get_filter = _function(
    "cn_shape_get_filter",
    """Reads the filter.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_filter),
)
cn_shape_set_event_mask = _function(
    "cn_shape_set_event_mask",
    """Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts of
    the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint32,
)
cn_shape_get_event_mask = _function(
    "cn_shape_get_event_mask",
    """Reads the event mask.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint32),
)
cn_shape_set_flags = _function(
    "cn_shape_set_flags",
    """Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
    step. Wakes the body, or the bodies near a static shape. O(contacts of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint32,
)
cn_shape_get_flags = _function(
    "cn_shape_get_flags",
    """Reads the CN_SHAPE_ flags.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint32),
)
cn_shape_set_user_data = _function(
    "cn_shape_set_user_data",
    """Stores a number for the user.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint64,
)
cn_shape_get_user_data = _function(
    "cn_shape_get_user_data",
    """Reads the user's number.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint64),
)
cn_shape_get_aabb = _function(
    "cn_shape_get_aabb",
    """AABB without margin, in the world (in the shape's own space when unattached). O(points).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_aabb),
)
cn_shape_get_mass_data = _function(
    "cn_shape_get_mass_data",
    """Mass at the present density, centre in the body's frame, inertia about the shape's own centre. O(points).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_mass_data),
)
cn_shape_get_circle = _function(
    "cn_shape_get_circle",
    """Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_circle),
)
cn_shape_get_capsule = _function(
    "cn_shape_get_capsule",
    """Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_capsule),
)
cn_shape_get_edge = _function(
    "cn_shape_get_edge",
    """Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_edge),
)
cn_shape_get_polygon = _function(
    "cn_shape_get_polygon",
    """Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_polygon),
)
cn_shape_get_chain_points = _function(
    "cn_shape_get_chain_points",
    """Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
    NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points written).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_vec2), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_shape_set_circle = _function(
    "cn_shape_set_circle",
    """Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks of
    creation: the handle and all other properties stay. Mass and box are those of the new geometry at once;
    contacts stay unless the boxes no longer overlap, and the next step computes them anew, without the
    impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box meets. A
    shape that grows into others is pushed out of them at push_speed_max_mps at most. CN_ERROR_STATE for
    another type. O(contacts + shapes of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_circle),
)
cn_shape_set_capsule = _function(
    "cn_shape_set_capsule",
    """Replaces a capsule in place; otherwise as cn_shape_set_circle.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_capsule),
)
cn_shape_set_edge = _function(
    "cn_shape_set_edge",
    """Replaces an edge in place; otherwise as cn_shape_set_circle.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_edge),
)
cn_shape_set_polygon = _function(
    "cn_shape_set_polygon",
    """Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_polygon),
)
cn_shape_set_chain = _function(
    "cn_shape_set_chain",
    """Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
    begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body + count).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_chain),
)
cn_shape_test_point = _function(
    "cn_shape_test_point",
    """out_inside is 1 if the shape contains a world point in metres (in the shape's own space when unattached),
    else 0. Edges and chains contain no point. O(points).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_float, _c.c_float, _c.POINTER(_c.c_int32),
)
cn_polygon_make_hull = _function(
    "cn_polygon_make_hull",
    """Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
    farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
    area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
    mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
    O(count^2) at worst.""",
    cn_result, _c.POINTER(cn_vec2), _c.c_int32, _c.c_float, _c.POINTER(cn_polygon),
)
cn_polygon_make_box = _function(
    "cn_polygon_make_box",
    """A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
    (|angle| <= 1e4); radius_m >= 0.""",
    cn_result, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_polygon),
)
cn_outline_decompose = _function(
    "cn_outline_decompose",
    """Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
    in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
    without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
    Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
    thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
    area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
    *out_count is the number of all. 34 KB of stack. O(count^2).""",
    cn_result, _c.POINTER(cn_vec2), _c.c_int32, _c.c_float, _c.POINTER(cn_polygon), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_outline_simplify = _function(
    "cn_outline_simplify",
    """Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
    tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
    0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
    afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
    points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst.""",
    cn_result, _c.POINTER(cn_vec2), _c.c_int32, _c.c_int32, _c.c_float, _c.POINTER(cn_vec2), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_outline_from_cells = _function(
    "cn_outline_from_cells",
    """An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
    squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
    column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
    0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
    counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
    touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
    (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
    boundary of n edges.""",
    cn_result, _c.POINTER(_c.c_uint8), _c.c_int32, _c.c_int32, _c.c_float, _c.c_float, _c.c_float, _c.c_int32, _c.POINTER(cn_vec2), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_outline_from_field = _function(
    "cn_outline_from_field",
    """The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
    finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
    columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
    least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
    another one. cn_outline_simplify removes its collinear points. O(values + n log n).""",
    cn_result, _c.POINTER(_c.c_float), _c.c_int32, _c.c_int32, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_int32, _c.POINTER(cn_vec2), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_contact_events = _function(
    "cn_world_contact_events",
    """The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call for
    a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED inside
    callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved apart,
    body or shape destroyed, detached or disabled, filter or type changed). The next step reports pairs that
    end between two steps; their handles may be stale. A sleeping pair reports nothing, and continues when it
    wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the step, and got an
    impulse; bodies that pass a blow on to others that already touch them, without closing, have no HIT.
    Impulses are summed only for contacts that report ENTER (in the step in which they begin), STAY or HIT.""",
    cn_result, _c.POINTER(cn_world), _c.c_int32, _c.POINTER(_c.POINTER(cn_contact_event)), _c.POINTER(_c.c_int32),
)
cn_world_set_contact_callback = _function(
    "cn_world_set_contact_callback",
    """Sets the callback for contact events of one kind (CN_EVENT_*); NULL removes it.""",
    cn_result, _c.POINTER(cn_world), _c.c_int32, cn_contact_event_fn, _c.c_void_p,
)
cn_world_set_filter_callback = _function(
    "cn_world_set_filter_callback",
    """Sets the callback that decides whether two shapes may touch; NULL removes it.""",
    cn_result, _c.POINTER(cn_world), cn_filter_fn, _c.c_void_p,
)
cn_world_set_pre_solve_callback = _function(
    "cn_world_set_pre_solve_callback",
    """Sets the pre-solve callback; NULL removes it.""",
    cn_result, _c.POINTER(cn_world), cn_pre_solve_fn, _c.c_void_p,
)
cn_world_set_material_mix_callback = _function(
    "cn_world_set_material_mix_callback",
    """Sets the callback that mixes materials; NULL removes it.""",
    cn_result, _c.POINTER(cn_world), cn_material_mix_fn, _c.c_void_p,
)
cn_world_sensor_events = _function(
    "cn_world_sensor_events",
    """The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
    events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
    kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or chains.
    A pair without an awake body reports nothing until one wakes.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_sensor_event)), _c.POINTER(_c.c_int32),
)
cn_body_get_contacts = _function(
    "cn_body_get_contacts",
    """The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of sensors:
    see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the impulses of the
    last substep. At rest their force is that of the points times substep_count (with CN_SOLVER_SEQUENTIAL 1)
    / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0. *out_count is their number.
    O(contacts).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_contact_event), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_shape_get_contacts = _function(
    "cn_shape_get_contacts",
    """The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
    cn_body_get_contacts. O(contacts of its body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_contact_event), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_shape_get_visitors = _function(
    "cn_shape_get_visitors",
    """The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity and
    *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of its
    body), squared for chains.""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_fell_asleep = _function(
    "cn_world_fell_asleep",
    """Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
    destroyed since are stale.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_body)), _c.POINTER(_c.c_int32),
)
cn_revolute_def_init = _function(
    "cn_revolute_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_revolute_def),
)
cn_distance_def_init = _function(
    "cn_distance_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_distance_def),
)
cn_fixed_def_init = _function(
    "cn_fixed_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_fixed_def),
)
cn_prismatic_def_init = _function(
    "cn_prismatic_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_prismatic_def),
)
cn_wheel_def_init = _function(
    "cn_wheel_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_wheel_def),
)
cn_motor_def_init = _function(
    "cn_motor_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_motor_def),
)
cn_mouse_def_init = _function(
    "cn_mouse_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_mouse_def),
)
cn_gear_def_init = _function(
    "cn_gear_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_gear_def),
)
cn_pulley_def_init = _function(
    "cn_pulley_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_pulley_def),
)
cn_ratchet_def_init = _function(
    "cn_ratchet_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_ratchet_def),
)
cn_rotary_spring_def_init = _function(
    "cn_rotary_spring_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_rotary_spring_def),
)
cn_groove_def_init = _function(
    "cn_groove_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_groove_def),
)
cn_filter_joint_def_init = _function(
    "cn_filter_joint_def_init",
    """Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_filter_joint_def),
)
cn_joint_create_revolute = _function(
    "cn_joint_create_revolute",
    """Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_revolute_def), _c.POINTER(cn_joint),
)
cn_joint_create_distance = _function(
    "cn_joint_create_distance",
    """Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_distance_def), _c.POINTER(cn_joint),
)
cn_joint_create_fixed = _function(
    "cn_joint_create_fixed",
    """Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_fixed_def), _c.POINTER(cn_joint),
)
cn_joint_create_prismatic = _function(
    "cn_joint_create_prismatic",
    """Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    is dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_prismatic_def), _c.POINTER(cn_joint),
)
cn_joint_create_wheel = _function(
    "cn_joint_create_wheel",
    """Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_wheel_def), _c.POINTER(cn_joint),
)
cn_joint_create_motor = _function(
    "cn_joint_create_motor",
    """Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_motor_def), _c.POINTER(cn_joint),
)
cn_joint_create_mouse = _function(
    "cn_joint_create_mouse",
    """Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic, or body_a is not 0. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_mouse_def), _c.POINTER(cn_joint),
)
cn_joint_create_gear = _function(
    "cn_joint_create_gear",
    """Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_gear_def), _c.POINTER(cn_joint),
)
cn_joint_create_pulley = _function(
    "cn_joint_create_pulley",
    """Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_pulley_def), _c.POINTER(cn_joint),
)
cn_joint_create_ratchet = _function(
    "cn_joint_create_ratchet",
    """Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ratchet_def), _c.POINTER(cn_joint),
)
cn_joint_create_rotary_spring = _function(
    "cn_joint_create_rotary_spring",
    """Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_rotary_spring_def), _c.POINTER(cn_joint),
)
cn_joint_create_groove = _function(
    "cn_joint_create_groove",
    """Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    dynamic, or the slot has no length. O(contacts of body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_groove_def), _c.POINTER(cn_joint),
)
cn_joint_create_filter = _function(
    "cn_joint_create_filter",
    """Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
    bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
    body_a).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_filter_joint_def), _c.POINTER(cn_joint),
)
cn_joint_destroy = _function(
    "cn_joint_destroy",
    """Destroys a joint and wakes its bodies. No event is reported.""",
    cn_result, _c.POINTER(cn_world), cn_joint,
)
cn_joint_is_valid = _function(
    "cn_joint_is_valid",
    """1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).""",
    _c.c_int32, _c.POINTER(cn_world), cn_joint,
)
cn_joint_get_type = _function(
    "cn_joint_get_type",
    """Reads the type (CN_JOINT_REVOLUTE to _FILTER).""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_int32),
)
cn_joint_get_bodies = _function(
    "cn_joint_get_bodies",
    """Reads both bodies; 0 stands for the world.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_body), _c.POINTER(cn_body),
)
cn_joint_get_anchors = _function(
    "cn_joint_get_anchors",
    """Reads the world positions of both anchors, in metres.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2),
)
cn_joint_get_reaction = _function(
    "cn_joint_get_reaction",
    """Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0 after
    a change of type or of CN_BODY_ENABLED of one of its bodies.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float),
)
cn_joint_get_error = _function(
    "cn_joint_get_error",
    """Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
    (angles beyond limits).""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float),
)
cn_joint_set_solver = _function(
    "cn_joint_set_solver",
    """Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
    together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
    connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a
    world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
    does not wake.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_int32,
)
cn_joint_get_solver = _function(
    "cn_joint_get_solver",
    """Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_int32),
)
cn_joint_set_user_data = _function(
    "cn_joint_set_user_data",
    """Stores a number for the user.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_uint64,
)
cn_joint_get_user_data = _function(
    "cn_joint_get_user_data",
    """Reads the user's number.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_uint64),
)
cn_joint_set_flags = _function(
    "cn_joint_set_flags",
    """Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_uint32,
)
cn_joint_get_flags = _function(
    "cn_joint_get_flags",
    """Reads the CN_JOINT_ flags.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_uint32),
)
cn_joint_get_revolute = _function(
    "cn_joint_get_revolute",
    """Reads the definition of a revolute joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_revolute_def),
)
cn_joint_set_revolute = _function(
    "cn_joint_set_revolute",
    """Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_revolute_def),
)
cn_joint_get_distance = _function(
    "cn_joint_get_distance",
    """Reads the definition of a distance joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_distance_def),
)
cn_joint_set_distance = _function(
    "cn_joint_set_distance",
    """Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_distance_def),
)
cn_joint_get_fixed = _function(
    "cn_joint_get_fixed",
    """Reads the definition of a fixed joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_fixed_def),
)
cn_joint_set_fixed = _function(
    "cn_joint_set_fixed",
    """Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_fixed_def),
)
cn_joint_get_prismatic = _function(
    "cn_joint_get_prismatic",
    """Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_prismatic_def),
)
cn_joint_set_prismatic = _function(
    "cn_joint_set_prismatic",
    """Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_prismatic_def),
)
cn_joint_get_wheel = _function(
    "cn_joint_get_wheel",
    """Reads the definition of a wheel joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_wheel_def),
)
cn_joint_set_wheel = _function(
    "cn_joint_set_wheel",
    """Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_wheel_def),
)
cn_joint_get_motor_to = _function(
    "cn_joint_get_motor_to",
    """Reads the definition of a motor joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_motor_def),
)
cn_joint_set_motor_to = _function(
    "cn_joint_set_motor_to",
    """Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_motor_def),
)
cn_joint_get_mouse = _function(
    "cn_joint_get_mouse",
    """Reads the definition of a mouse joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_mouse_def),
)
cn_joint_set_mouse = _function(
    "cn_joint_set_mouse",
    """Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
    struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
    CN_JOINT_COLLIDE changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_mouse_def),
)
cn_joint_get_gear = _function(
    "cn_joint_get_gear",
    """Reads the definition of a gear joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_gear_def),
)
cn_joint_set_gear = _function(
    "cn_joint_set_gear",
    """Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
    struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
    both bodies. O(contacts) when CN_JOINT_COLLIDE changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_gear_def),
)
cn_joint_get_pulley = _function(
    "cn_joint_get_pulley",
    """Reads the definition of a pulley joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_pulley_def),
)
cn_joint_set_pulley = _function(
    "cn_joint_set_pulley",
    """Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_pulley_def),
)
cn_joint_get_ratchet = _function(
    "cn_joint_get_ratchet",
    """Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_ratchet_def),
)
cn_joint_set_ratchet = _function(
    "cn_joint_set_ratchet",
    """Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
    struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
    bodies. O(contacts) when CN_JOINT_COLLIDE changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_ratchet_def),
)
cn_joint_get_rotary_spring = _function(
    "cn_joint_get_rotary_spring",
    """Reads the definition of a rotary spring. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_rotary_spring_def),
)
cn_joint_set_rotary_spring = _function(
    "cn_joint_set_rotary_spring",
    """Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_rotary_spring_def),
)
cn_joint_get_groove = _function(
    "cn_joint_get_groove",
    """Reads the definition of a groove joint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_groove_def),
)
cn_joint_set_groove = _function(
    "cn_joint_set_groove",
    """Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
    struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    changes.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_groove_def),
)
cn_joint_get_base = _function(
    "cn_joint_get_base",
    """Reads the base of a joint of any type.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_joint_base),
)
cn_joint_set_base = _function(
    "cn_joint_set_base",
    """Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
    in cn_joint_base. Wakes both bodies.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_joint_base),
)
cn_joint_set_target = _function(
    "cn_joint_set_target",
    """Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
    for another type. Wakes the body.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float,
)
cn_joint_get_position = _function(
    "cn_joint_get_position",
    """Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
    reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
    along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary
    spring: angle b - angle a; these three over whole turns.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float),
)
cn_joint_get_speed = _function(
    "cn_joint_get_speed",
    """Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A positive
    motor speed has the same sign.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float),
)
cn_joint_set_motor = _function(
    "cn_joint_set_motor",
    """Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
    prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float,
)
cn_joint_set_limits = _function(
    "cn_joint_set_limits",
    """Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0), prismatic
    or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.""",
    cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float,
)
cn_world_joint_events = _function(
    "cn_world_joint_events",
    """Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
    in that step or between it and the step before.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_joint_event)), _c.POINTER(_c.c_int32),
)
cn_angle_constraint_def_init = _function(
    "cn_angle_constraint_def_init",
    """Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_angle_constraint_def),
)
cn_line_constraint_def_init = _function(
    "cn_line_constraint_def_init",
    """Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.""",
    None, _c.POINTER(cn_line_constraint_def),
)
cn_constraint_create_angle = _function(
    "cn_constraint_create_angle",
    """Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
    dynamic. Wakes the body.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_angle_constraint_def), _c.POINTER(cn_constraint),
)
cn_constraint_create_line = _function(
    "cn_constraint_create_line",
    """Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
    dynamic. Wakes the body.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_line_constraint_def), _c.POINTER(cn_constraint),
)
cn_constraint_destroy = _function(
    "cn_constraint_destroy",
    """Destroys a constraint and wakes its body. No event is reported.""",
    cn_result, _c.POINTER(cn_world), cn_constraint,
)
cn_constraint_is_valid = _function(
    "cn_constraint_is_valid",
    """1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).""",
    _c.c_int32, _c.POINTER(cn_world), cn_constraint,
)
cn_constraint_get_type = _function(
    "cn_constraint_get_type",
    """Reads the type (CN_CONSTRAINT_ANGLE or _LINE).""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_int32),
)
cn_constraint_get_body = _function(
    "cn_constraint_get_body",
    """Reads the body.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_body),
)
cn_constraint_get_angle = _function(
    "cn_constraint_get_angle",
    """Reads the definition of an angle constraint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_angle_constraint_def),
)
cn_constraint_set_angle = _function(
    "cn_constraint_set_angle",
    """Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
    body.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_angle_constraint_def),
)
cn_constraint_get_line = _function(
    "cn_constraint_get_line",
    """Reads the definition of a line constraint. CN_ERROR_STATE for another type.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_line_constraint_def),
)
cn_constraint_set_line = _function(
    "cn_constraint_set_line",
    """Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
    body.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_line_constraint_def),
)
cn_constraint_get_position = _function(
    "cn_constraint_get_position",
    """Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
    along the axis, in metres from origin.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_float),
)
cn_constraint_get_reaction = _function(
    "cn_constraint_get_reaction",
    """Force in newtons and torque in newton metres that the constraint applied to the body in the last substep.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float),
)
cn_constraint_get_error = _function(
    "cn_constraint_get_error",
    """Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle constraint.""",
    cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float),
)
cn_world_get_constraints = _function(
    "cn_world_get_constraints",
    """Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    O(slots).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_constraint), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_body_get_constraints = _function(
    "cn_body_get_constraints",
    """Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
    constraints of the body).""",
    cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_constraint), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_set_fixed_step = _function(
    "cn_world_set_fixed_step",
    """Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an update,
    1 to 1000, default 8.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_int32,
)
cn_world_update = _function(
    "cn_world_update",
    """Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
    event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.POINTER(cn_update_report),
)
cn_world_read_poses_interpolated = _function(
    "cn_world_read_poses_interpolated",
    """Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step, 1
    after it. Bodies that did not take part in the last step have their present pose. bodies and count as in
    cn_world_read_poses. O(count).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.c_float, _c.POINTER(cn_pose),
)
cn_query_filter_init = _function(
    "cn_query_filter_init",
    """Sets the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_query_filter),
)
cn_world_cast_ray = _function(
    "cn_world_cast_ray",
    """Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from their
    front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter may be
    NULL: the defaults. O(log shapes) to O(shapes along the ray).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit),
)
cn_world_cast_ray_any = _function(
    "cn_world_cast_ray_any",
    """out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
    shapes) to O(shapes along the ray).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(_c.c_int32),
)
cn_world_cast_ray_all = _function(
    "cn_world_cast_ray_all",
    """Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found. A
    chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_cast_rays = _function(
    "cn_world_cast_rays",
    """Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call. filter
    may be NULL. O(sum of the rays).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.c_int32, _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit),
)
cn_shape_cast_ray = _function(
    "cn_shape_cast_ray",
    """Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
    O(points of the shape).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_ray), _c.POINTER(cn_ray_hit),
)
cn_world_cast_shape = _function(
    "cn_world_cast_shape",
    """First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
    way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or 2:
    circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the moving
    points is in front of it. filter may be NULL. O(shapes along the way).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit),
)
cn_world_overlap_aabb = _function(
    "cn_world_overlap_aabb",
    """Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
    cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
    filter may be NULL. O(log shapes) to O(boxes in the region).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_aabb), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_overlap_circle = _function(
    "cn_world_overlap_circle",
    """Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges
    and chains are lines here, seen from both sides.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_circle), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_overlap_polygon = _function(
    "cn_world_overlap_polygon",
    """Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as in
    cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_overlap_point = _function(
    "cn_world_overlap_point",
    """Shapes that contain a world point in metres; order, capacity, filter and cost as in cn_world_overlap_aabb.
    Edges and chains contain no point.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_world_closest_point = _function(
    "cn_world_closest_point",
    """Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
    contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.""",
    cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_closest),
)
cn_polygon_distance = _function(
    "cn_polygon_distance",
    """Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
    radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).""",
    cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_distance),
)
cn_polygon_cast = _function(
    "cn_polygon_cast",
    """Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
    as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).""",
    cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.c_float, _c.c_float, _c.POINTER(cn_ray_hit), _c.POINTER(_c.c_int32),
)
cn_polygon_collide = _function(
    "cn_polygon_collide",
    """Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
    to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
    O(points).""",
    cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.c_float, _c.POINTER(cn_manifold),
)
cn_polygon_time_of_impact = _function(
    "cn_polygon_time_of_impact",
    """First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
    start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
    hit. Needs no world; runs in any thread.""",
    cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_sweep), _c.POINTER(cn_polygon), _c.POINTER(cn_sweep), _c.c_float, _c.POINTER(cn_impact),
)
cn_mover_collide = _function(
    "cn_mover_collide",
    """Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
    by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least
    separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way
    shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the length unit plus
    its rise in the last step. Shapes wholly behind the plane of another shape are left out, so that seams of
    tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_plane), _c.c_int32, _c.POINTER(_c.c_int32),
)
cn_mover_solve = _function(
    "cn_mover_solve",
    """The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
    dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
    finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
    of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
    limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.""",
    cn_result, _c.POINTER(cn_plane), _c.c_int32, _c.c_float, _c.c_float, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float),
)
cn_mover_clip = _function(
    "cn_mover_clip",
    """The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
    cn_mover_solve. Needs no world. O(count^2).""",
    cn_result, _c.POINTER(cn_plane), _c.c_int32, _c.c_float, _c.c_float, _c.POINTER(cn_vec2),
)
cn_mover_def_init = _function(
    "cn_mover_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_mover_def),
)
cn_mover_move = _function(
    "cn_mover_move",
    """Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step behind
    the ground that carries it. 1. carried   by the motion of its ground since the last move: of the point of
    ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up, along the
    ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A step up where a
    too steep surface blocks it: up by step_height_m, forward, down on walkable ground flying    in the air:
    velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep ground_velocity_mps 3.
    sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes
    through a wall 4. pushing   dynamic bodies in the way get a force for the next step that brings them to
    the character's velocity, of at most push_force_N each 5. ground    ground that it touches, or that lies
    within snap_m below a walking character; velocity_mps loses blocked components The result depends on the
    world, def and mover alone: equal calls give equal bits. The loop of planes, solver and cast is that of
    Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies wake; nothing else in the world
    changes. O(shapes nearby x iterations_max): about 1 us standing, 3 us walking, 10 us against a wall.""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_mover_def), _c.c_float, _c.POINTER(cn_mover),
)
cn_area_def_init = _function(
    "cn_area_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_area_def),
)
cn_shape_set_area = _function(
    "cn_shape_set_area",
    """Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says
    which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area that
    loses the flag later does nothing while it is without. Gravity, and damping without density, act on bodies
    whose centre of mass is in the area (on its border too) while one of their shapes touches it: on a body
    half in it in full or not at all. The medium acts on the part of each shape that is in the area, exactly
    for polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The surface of a
    circle or capsule is flat across a body, as of a planet. Shapes of a body do not shade each other. The
    area's body feels no reaction. Between steps nothing happens: the acceleration is that in the middle of
    the next step (leapfrog), so bodies on orbits and floating bodies keep their energy. Damping and drag are
    implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies that enter or
    leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may sleep. Areas
    are in saves and files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a second) are
    damped, and carry less under a load. An area takes 64 bytes of the world's memory; a step takes about 0.15
    us for each shape in an area, 0.35 us in a medium. Best on a body of its own: O(contacts of the body).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_area_def),
)
cn_shape_get_area = _function(
    "cn_shape_get_area",
    """Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_area_def),
)
cn_shape_apply_wind = _function(
    "cn_shape_apply_wind",
    """The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step.
    flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w across it,
    with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton (1687), and
    across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between surface and
    flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline, round
    parts included, and drag along straight edges also for turning bodies; edges and chains are plates with
    two sides. Solved implicitly, so that wind never reverses the motion relative to it, at any speed, mass
    and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay asleep and
    unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a shape
    without a body. O(points).""",
    cn_result, _c.POINTER(cn_world), cn_shape, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_int32,
)
cn_explosion_def_init = _function(
    "cn_explosion_def_init",
    """Sets struct_size and the defaults given beside the fields. NULL does nothing.""",
    None, _c.POINTER(cn_explosion_def),
)
cn_world_explode = _function(
    "cn_world_explode",
    """Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes them.
    CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_explosion_def),
)
cn_debug_draw_init = _function(
    "cn_debug_draw_init",
    """Sets struct_size and the defaults given beside the fields, every function to NULL. NULL does nothing.""",
    None, _c.POINTER(cn_debug_draw),
)
cn_world_draw = _function(
    "cn_world_draw",
    """Draws the world through the given functions, in the calling thread. Reads only. O(bodies + shapes +
    contacts + joints).""",
    cn_result, _c.POINTER(cn_world), _c.POINTER(cn_debug_draw),
)
cn_tree_create = _function(
    "cn_tree_create",
    """Creates a dynamic AABB tree; margin_m >= 0 is added around every box. alloc and free: both NULL for
    malloc, or both set.""",
    cn_result, _c.c_float, cn_alloc_fn, cn_free_fn, _c.c_void_p, _c.POINTER(_c.POINTER(cn_tree)),
)
cn_tree_destroy = _function(
    "cn_tree_destroy",
    """Destroys a tree. NULL does nothing.""",
    None, _c.POINTER(cn_tree),
)
cn_tree_insert = _function(
    "cn_tree_insert",
    """Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).""",
    cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_aabb), _c.c_uint64, _c.POINTER(_c.c_uint32),
)
cn_tree_remove = _function(
    "cn_tree_remove",
    """Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).""",
    cn_result, _c.POINTER(cn_tree), _c.c_uint32,
)
cn_tree_move = _function(
    "cn_tree_move",
    """Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
    CN_ERROR_HANDLE for a stale item.""",
    cn_result, _c.POINTER(cn_tree), _c.c_uint32, _c.POINTER(cn_aabb),
)
cn_tree_get_box = _function(
    "cn_tree_get_box",
    """Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.""",
    cn_result, _c.POINTER(cn_tree), _c.c_uint32, _c.POINTER(cn_aabb),
)
cn_tree_query = _function(
    "cn_tree_query",
    """Calls visit for every item whose box with margin overlaps box, until visit returns 0. visit must not
    change the tree. O(log n + items visited).""",
    cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_aabb), cn_tree_query_fn, _c.c_void_p,
)
cn_tree_cast_ray = _function(
    "cn_tree_cast_ray",
    """Calls visit for items whose box with margin a ray crosses; visit shortens or stops the ray by its result
    and must not change the tree. O(log n + items visited).""",
    cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_ray), cn_tree_ray_fn, _c.c_void_p,
)
cn_tree_get_stats = _function(
    "cn_tree_get_stats",
    """Reads the number of items and the height of the tree.""",
    cn_result, _c.POINTER(cn_tree), _c.POINTER(_c.c_int32), _c.POINTER(_c.c_int32),
)


for _struct, _number in (
    (cn_vec2, CN_TYPE_VEC2),
    (cn_pose, CN_TYPE_POSE),
    (cn_velocity, CN_TYPE_VELOCITY),
    (cn_aabb, CN_TYPE_AABB),
    (cn_mass_data, CN_TYPE_MASS_DATA),
    (cn_world_def, CN_TYPE_WORLD_DEF),
    (cn_counters, CN_TYPE_COUNTERS),
    (cn_island_report, CN_TYPE_ISLAND_REPORT),
    (cn_profile, CN_TYPE_PROFILE),
    (cn_memory_stats, CN_TYPE_MEMORY_STATS),
    (cn_body_def, CN_TYPE_BODY_DEF),
    (cn_body_moved, CN_TYPE_BODY_MOVED),
    (cn_filter, CN_TYPE_FILTER),
    (cn_material, CN_TYPE_MATERIAL),
    (cn_shape_def, CN_TYPE_SHAPE_DEF),
    (cn_circle, CN_TYPE_CIRCLE),
    (cn_capsule, CN_TYPE_CAPSULE),
    (cn_edge, CN_TYPE_EDGE),
    (cn_polygon, CN_TYPE_POLYGON),
    (cn_chain, CN_TYPE_CHAIN),
    (cn_manifold_point, CN_TYPE_MANIFOLD_POINT),
    (cn_manifold, CN_TYPE_MANIFOLD),
    (cn_contact_event, CN_TYPE_CONTACT_EVENT),
    (cn_sensor_event, CN_TYPE_SENSOR_EVENT),
    (cn_joint_base, CN_TYPE_JOINT_BASE),
    (cn_revolute_def, CN_TYPE_REVOLUTE_DEF),
    (cn_distance_def, CN_TYPE_DISTANCE_DEF),
    (cn_fixed_def, CN_TYPE_FIXED_DEF),
    (cn_prismatic_def, CN_TYPE_PRISMATIC_DEF),
    (cn_wheel_def, CN_TYPE_WHEEL_DEF),
    (cn_motor_def, CN_TYPE_MOTOR_DEF),
    (cn_mouse_def, CN_TYPE_MOUSE_DEF),
    (cn_gear_def, CN_TYPE_GEAR_DEF),
    (cn_pulley_def, CN_TYPE_PULLEY_DEF),
    (cn_ratchet_def, CN_TYPE_RATCHET_DEF),
    (cn_rotary_spring_def, CN_TYPE_ROTARY_SPRING_DEF),
    (cn_groove_def, CN_TYPE_GROOVE_DEF),
    (cn_filter_joint_def, CN_TYPE_FILTER_JOINT_DEF),
    (cn_joint_event, CN_TYPE_JOINT_EVENT),
    (cn_angle_constraint_def, CN_TYPE_ANGLE_CONSTRAINT_DEF),
    (cn_line_constraint_def, CN_TYPE_LINE_CONSTRAINT_DEF),
    (cn_update_report, CN_TYPE_UPDATE_REPORT),
    (cn_ray, CN_TYPE_RAY),
    (cn_ray_hit, CN_TYPE_RAY_HIT),
    (cn_query_filter, CN_TYPE_QUERY_FILTER),
    (cn_closest, CN_TYPE_CLOSEST),
    (cn_distance, CN_TYPE_DISTANCE),
    (cn_sweep, CN_TYPE_SWEEP),
    (cn_impact, CN_TYPE_IMPACT),
    (cn_plane, CN_TYPE_PLANE),
    (cn_mover_def, CN_TYPE_MOVER_DEF),
    (cn_mover, CN_TYPE_MOVER),
    (cn_area_def, CN_TYPE_AREA_DEF),
    (cn_explosion_def, CN_TYPE_EXPLOSION_DEF),
    (cn_debug_draw, CN_TYPE_DEBUG_DRAW),
):
    if _c.sizeof(_struct) != cn_sizeof(_number):
        raise ImportError("%s has %d bytes here, %d in the library" % (_struct.__name__, _c.sizeof(_struct), cn_sizeof(_number)))


class Error(Exception):
    """A call that failed: code is the cn_result, the text is the library's sentence."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def _check(result, world=None):
    if result != CN_OK:
        text = cn_world_error_text(world) if world else b""
        raise Error(result, (text or cn_result_text(result)).decode())


def _array(kind, values):
    """None, a ctypes array as it is, anything else copied into one."""
    return values if values is None or isinstance(values, _c.Array) else (kind * len(values))(*values)


def _even(count, *arrays):
    for array in arrays:
        if array is not None and len(array) != count:
            raise ValueError("arrays of %d and %d elements" % (len(array), count))


def _copy(kind, pointer, count):
    array = (kind * count)()
    if count:
        _c.memmove(array, pointer, _c.sizeof(array))
    return array


def _made(definition, fields):
    for name, value in fields.items():
        getattr(definition, name)
        setattr(definition, name, value)
    return definition


def WorldDef(**fields):
    """A cn_world_def with its defaults but for the given fields. Definition of a world."""
    definition = cn_world_def()
    cn_world_def_init(definition)
    return _made(definition, fields)


def BodyDef(**fields):
    """A cn_body_def with its defaults but for the given fields. Definition of a body."""
    definition = cn_body_def()
    cn_body_def_init(definition)
    return _made(definition, fields)


def ShapeDef(**fields):
    """A cn_shape_def with its defaults but for the given fields. Definition of a shape."""
    definition = cn_shape_def()
    cn_shape_def_init(definition)
    return _made(definition, fields)


def RevoluteDef(**fields):
    """A cn_revolute_def with its defaults but for the given fields. Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi]."""
    definition = cn_revolute_def()
    cn_revolute_def_init(definition)
    return _made(definition, fields)


def DistanceDef(**fields):
    """A cn_distance_def with its defaults but for the given fields. Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
    length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max];
    limits alone make a rope (min 0)."""
    definition = cn_distance_def()
    cn_distance_def_init(definition)
    return _made(definition, fields)


def FixedDef(**fields):
    """A cn_fixed_def with its defaults but for the given fields. Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy."""
    definition = cn_fixed_def()
    cn_fixed_def_init(definition)
    return _made(definition, fields)


def PrismaticDef(**fields):
    """A cn_prismatic_def with its defaults but for the given fields. b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a."""
    definition = cn_prismatic_def()
    cn_prismatic_def_init(definition)
    return _made(definition, fields)


def WheelDef(**fields):
    """A cn_wheel_def with its defaults but for the given fields. A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
    by the motor."""
    definition = cn_wheel_def()
    cn_wheel_def_init(definition)
    return _made(definition, fields)


def MotorDef(**fields):
    """A cn_motor_def with its defaults but for the given fields. Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
    base.torque_max_Nm must be > 0."""
    definition = cn_motor_def()
    cn_motor_def_init(definition)
    return _made(definition, fields)


def MouseDef(**fields):
    """A cn_mouse_def with its defaults but for the given fields. Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
    base.force_max_N must be > 0."""
    definition = cn_mouse_def()
    cn_mouse_def_init(definition)
    return _made(definition, fields)


def GearDef(**fields):
    """A cn_gear_def with its defaults but for the given fields. angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
    and count whole turns from there."""
    definition = cn_gear_def()
    cn_gear_def_init(definition)
    return _made(definition, fields)


def PulleyDef(**fields):
    """A cn_pulley_def with its defaults but for the given fields. A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never
    pushes."""
    definition = cn_pulley_def()
    cn_pulley_def_init(definition)
    return _made(definition, fields)


def RatchetDef(**fields):
    """A cn_ratchet_def with its defaults but for the given fields. b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase
    + n * click_rad for every whole number n, over whole turns."""
    definition = cn_ratchet_def()
    cn_ratchet_def_init(definition)
    return _made(definition, fields)


def RotarySpringDef(**fields):
    """A cn_rotary_spring_def with its defaults but for the given fields. A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
    the two bodies."""
    definition = cn_rotary_spring_def()
    cn_rotary_spring_def_init(definition)
    return _made(definition, fields)


def GrooveDef(**fields):
    """A cn_groove_def with its defaults but for the given fields. Anchor b slides in a slot of body a from anchor a to end_m."""
    definition = cn_groove_def()
    cn_groove_def_init(definition)
    return _made(definition, fields)


def FilterJointDef(**fields):
    """A cn_filter_joint_def with its defaults but for the given fields. The two bodies do not collide; no other effect."""
    definition = cn_filter_joint_def()
    cn_filter_joint_def_init(definition)
    return _made(definition, fields)


def AngleConstraintDef(**fields):
    """A cn_angle_constraint_def with its defaults but for the given fields. Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
    there."""
    definition = cn_angle_constraint_def()
    cn_angle_constraint_def_init(definition)
    return _made(definition, fields)


def LineConstraintDef(**fields):
    """A cn_line_constraint_def with its defaults but for the given fields. Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along
    the line."""
    definition = cn_line_constraint_def()
    cn_line_constraint_def_init(definition)
    return _made(definition, fields)


def QueryFilter(**fields):
    """A cn_query_filter with its defaults but for the given fields. Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
    bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
    steps."""
    definition = cn_query_filter()
    cn_query_filter_init(definition)
    return _made(definition, fields)


def MoverDef(**fields):
    """A cn_mover_def with its defaults but for the given fields. How a character moves. It may change between moves: crouching is another shape."""
    definition = cn_mover_def()
    cn_mover_def_init(definition)
    return _made(definition, fields)


def AreaDef(**fields):
    """A cn_area_def with its defaults but for the given fields. What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity.
    Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
    accelerations, damping and forces add up."""
    definition = cn_area_def()
    cn_area_def_init(definition)
    return _made(definition, fields)


def ExplosionDef(**fields):
    """A cn_explosion_def with its defaults but for the given fields. Definition of an explosion."""
    definition = cn_explosion_def()
    cn_explosion_def_init(definition)
    return _made(definition, fields)


def DebugDraw(**fields):
    """A cn_debug_draw with its defaults but for the given fields. The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
    coordinates."""
    definition = cn_debug_draw()
    cn_debug_draw_init(definition)
    return _made(definition, fields)


class World:
    """A world; close() or the end of a with block destroys it, as does the garbage collector. World(definition), or fields of
    cn_world_def: World(substep_count=8)."""

    _pointer = None

    def __init__(self, definition=None, **fields):
        self._callbacks = {}
        pointer = _c.POINTER(cn_world)()
        _check(cn_world_create(_made(definition or WorldDef(), fields), pointer))
        self._pointer = pointer

    @property
    def pointer(self):
        """For functions of C."""
        if self._pointer is None:
            raise ValueError("the world is closed")
        return self._pointer

    def close(self):
        """Destroys the world, unless that has happened."""
        if self._pointer is not None:
            cn_world_destroy(self._pointer)
            self._pointer = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        self.close()

    def on_contact(self, kind, function):
        """Calls function(event) for contact events of one kind (CN_EVENT_*), while the world is locked; None ends that. The
        event is valid during the call."""
        callback = cn_contact_event_fn(function and (lambda _world, event, _user: function(event.contents)) or 0)
        _check(cn_world_set_contact_callback(self.pointer, kind, callback, None), self.pointer)
        self._callbacks[kind] = callback

    @classmethod
    def read(cls, file, definition=None, **fields):
        """A world from the bytes of write. Of the definition only memory, workers and capacities are used."""
        pointer = _c.POINTER(cn_world)()
        _check(cn_world_read(_made(definition or WorldDef(), fields), file, len(file), pointer))
        world = cls.__new__(cls)
        world._callbacks, world._pointer = {}, pointer
        return world

    def step(self, dt_s):
        """Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
        O(awake bodies and their contacts and joints)."""
        _check(cn_world_step(self.pointer, dt_s), self.pointer)

    def set_gravity(self, gravity_x_mps2, gravity_y_mps2):
        """Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies)."""
        _check(cn_world_set_gravity(self.pointer, gravity_x_mps2, gravity_y_mps2), self.pointer)

    def get_gravity(self):
        """Reads gravity in m/s^2."""
        _mps2 = cn_vec2()
        _check(cn_world_get_gravity(self.pointer, _mps2))
        return _mps2

    def set_substep_count(self, count):
        """Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more."""
        _check(cn_world_set_substep_count(self.pointer, count), self.pointer)

    def get_substep_count(self):
        """Reads the substeps of a step."""
        _count = _c.c_int32()
        _check(cn_world_get_substep_count(self.pointer, _count))
        return _count.value

    def set_solver(self, solver):
        """Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
        memory of the solver it was created with; a solver that needs more works without direct solving
        (CN_WARNING_FRAME_MEMORY)."""
        _check(cn_world_set_solver(self.pointer, solver), self.pointer)

    def get_solver(self):
        """Reads the solver (CN_SOLVER_*)."""
        _solver = _c.c_int32()
        _check(cn_world_get_solver(self.pointer, _solver))
        return _solver.value

    def set_accuracy(self, accuracy_m, work_budget):
        """Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT."""
        _check(cn_world_set_accuracy(self.pointer, accuracy_m, work_budget), self.pointer)

    def get_accuracy(self):
        """Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
        (CN_DEFAULT: none)."""
        _accuracy_m = _c.c_float()
        _work_budget = _c.c_int32()
        _check(cn_world_get_accuracy(self.pointer, _accuracy_m, _work_budget))
        return _accuracy_m.value, _work_budget.value

    def get_worker_count(self):
        """Reads how many workers a step can use: 1, or worker_count where the library supports threads."""
        _count = _c.c_int32()
        _check(cn_world_get_worker_count(self.pointer, _count))
        return _count.value

    def set_flags(self, flags):
        """Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies)."""
        _check(cn_world_set_flags(self.pointer, flags), self.pointer)

    def get_flags(self):
        """Reads the CN_WORLD_ flags."""
        _flags = _c.c_uint32()
        _check(cn_world_get_flags(self.pointer, _flags))
        return _flags.value

    def set_restitution_threshold(self, speed_mps):
        """Impacts slower than this, in m/s, do not bounce; >= 0."""
        _check(cn_world_set_restitution_threshold(self.pointer, speed_mps), self.pointer)

    def set_hit_speed(self, speed_mps):
        """Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0."""
        _check(cn_world_set_hit_speed(self.pointer, speed_mps), self.pointer)

    def set_speed_limits(self, linear_mps, angular_radps):
        """Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster
        bodies down to them and keeps the direction."""
        _check(cn_world_set_speed_limits(self.pointer, linear_mps, angular_radps), self.pointer)

    def set_sleep(self, speed_mps, delay_s):
        """Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
        they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
        others that no joint holds and that are slower than four times the speed lose theirs within a second
        or two: what rocks in a hollow would keep all of a heap awake."""
        _check(cn_world_set_sleep(self.pointer, speed_mps, delay_s), self.pointer)

    def set_user_data(self, user_data):
        """Stores a number for the user."""
        _check(cn_world_set_user_data(self.pointer, user_data), self.pointer)

    def get_user_data(self):
        """Reads the user's number."""
        _user_data = _c.c_uint64()
        _check(cn_world_get_user_data(self.pointer, _user_data))
        return _user_data.value

    def get_bodies(self):
        """Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
        capacity is 0. out_count is their number. O(slots)."""
        count = _c.c_int32()
        _check(cn_world_get_bodies(self.pointer, None, 0, count))
        out = (cn_body * count.value)()
        _check(cn_world_get_bodies(self.pointer, out, count, count))
        return out

    def get_shapes(self):
        """Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
        O(slots)."""
        count = _c.c_int32()
        _check(cn_world_get_shapes(self.pointer, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_world_get_shapes(self.pointer, out, count, count))
        return out

    def get_joints(self):
        """Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
        cn_world_get_bodies. O(slots)."""
        count = _c.c_int32()
        _check(cn_world_get_joints(self.pointer, None, 0, count))
        out = (cn_joint * count.value)()
        _check(cn_world_get_joints(self.pointer, out, count, count))
        return out

    def get_counters(self):
        """Reads counts of objects and what the last step reported. O(bodies + islands)."""
        _out = cn_counters()
        _check(cn_world_get_counters(self.pointer, _out))
        return _out

    def get_islands(self):
        """Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies,
        in a deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their
        number. A step does no work for it. O(bodies + contacts and joints of the islands written)."""
        count = _c.c_int32()
        _check(cn_world_get_islands(self.pointer, None, 0, count))
        out = (cn_island_report * count.value)()
        _check(cn_world_get_islands(self.pointer, out, count, count))
        return out

    def get_profile(self):
        """Reads the seconds of the last step by stage."""
        _out = cn_profile()
        _check(cn_world_get_profile(self.pointer, _out))
        return _out

    def get_memory_stats(self):
        """Reads the memory statistics."""
        _out = cn_memory_stats()
        _check(cn_world_get_memory_stats(self.pointer, _out))
        return _out

    def shift_origin(self, x_m, y_m):
        """Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position
        p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
        world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay,
        and no event is reported. Distances between bodies keep their digits; world anchors are rounded to
        floats at the new place. Arrays returned before become invalid; the user moves their own points
        (movers, rays, cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next
        step looks at all pairs again."""
        _check(cn_world_shift_origin(self.pointer, x_m, y_m), self.pointer)

    def hash(self):
        """64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
        contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
        every compiler, CPU and thread count. O(bodies + contacts + joints)."""
        _hash = _c.c_uint64()
        _check(cn_world_hash(self.pointer, _hash))
        return _hash.value

    def save_size(self):
        """Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots)."""
        _bytes = _c.c_uint64()
        _check(cn_world_save_size(self.pointer, _bytes))
        return _bytes.value

    def save(self):
        """Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and
        the number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the
        world), about 1 KB per body."""
        _bytes = _c.c_uint64()
        _check(cn_world_save_size(self.pointer, _bytes))
        _out = _c.create_string_buffer(_bytes.value or 1)
        _check(cn_world_save(self.pointer, _out, _bytes, _bytes))
        return _out.raw[: _bytes.value]

    def restore(self, save):
        """Restores a saved state, into the saved world or one created with the same definition (broadphase,
        length unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save;
        CN_ERROR_FORMAT for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the
        objects alive then (a world in a caller's block has room for its own saves). Arrays returned before
        become invalid. Handles of objects alive at the save are valid again, also of objects destroyed since;
        handles created since are refused until the same handle is given to a new object: with the same calls
        to the same object. O(memory of the world)."""
        _check(cn_world_restore(self.pointer, save, len(save)), self.pointer)

    def write_size(self):
        """Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots)."""
        _bytes = _c.c_uint64()
        _check(cn_world_write_size(self.pointer, _bytes))
        return _bytes.value

    def write(self):
        """Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
        of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about
        1 KB per body."""
        _bytes = _c.c_uint64()
        _check(cn_world_write_size(self.pointer, _bytes))
        _out = _c.create_string_buffer(_bytes.value or 1)
        _check(cn_world_write(self.pointer, _out, _bytes, _bytes))
        return _out.raw[: _bytes.value]

    def body_create(self, definition):
        """Creates a body. O(1) amortized."""
        _body = cn_body()
        _check(cn_body_create(self.pointer, definition, _body), self.pointer)
        return _body.value

    def body_create_many(self, defs, out_bodies=None):
        """Creates count (>= 0) bodies from an array of definitions, all or none. O(count)."""
        defs = _array(cn_body_def, defs)
        if out_bodies is None:
            out_bodies = (cn_body * len(defs))()
        _count = len(out_bodies)
        _even(_count, defs)
        _check(cn_body_create_many(self.pointer, defs, _count, out_bodies), self.pointer)
        return out_bodies

    def body_destroy(self, body):
        """Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
        contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts
        + joints + shapes)."""
        _check(cn_body_destroy(self.pointer, body), self.pointer)

    def body_destroy_many(self, bodies):
        """Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
        O(their contacts + joints + shapes)."""
        bodies = _array(cn_body, bodies)
        _count = len(bodies)
        _check(cn_body_destroy_many(self.pointer, bodies, _count), self.pointer)

    def body_is_valid(self, body):
        """1 if the handle names a living body of this world, else 0 (also for a NULL world)."""
        return bool(cn_body_is_valid(self.pointer, body))

    def body_set_type(self, body, type):
        """Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those
        that still overlap begin again in the next step), with its forces and any mass override; a body made
        static stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints +
        shapes)."""
        _check(cn_body_set_type(self.pointer, body, type), self.pointer)

    def body_get_type(self, body):
        """Reads the type (CN_BODY_*)."""
        _type = _c.c_int32()
        _check(cn_body_get_type(self.pointer, body, _type))
        return _type.value

    def body_set_flags(self, body, flags):
        """Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
        CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
        are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes."""
        _check(cn_body_set_flags(self.pointer, body, flags), self.pointer)

    def body_get_flags(self, body):
        """Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake."""
        _flags = _c.c_uint32()
        _check(cn_body_get_flags(self.pointer, body, _flags))
        return _flags.value

    def body_set_awake(self, body, awake):
        """0 puts the body and its island to sleep and stops them; any other value wakes them. Static and
        disabled bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island)."""
        _check(cn_body_set_awake(self.pointer, body, awake), self.pointer)

    def body_set_pose(self, body, position_x_m, position_y_m, angle_rad):
        """Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <=
        1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
        them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
        neighbours. O(contacts + joints + shapes)."""
        _check(cn_body_set_pose(self.pointer, body, position_x_m, position_y_m, angle_rad), self.pointer)

    def body_get_pose(self, body):
        """Reads the position of the origin and the rotation."""
        _out = cn_pose()
        _check(cn_body_get_pose(self.pointer, body, _out))
        return _out

    def body_get_position_parts(self, body):
        """Reads the position of the origin as the sum of two floats: the high part is within rounding that of
        cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in
        double is more precise; so is a difference of two bodies, taken high from high and low from low, in
        floats."""
        _high_m = cn_vec2()
        _low_m = cn_vec2()
        _check(cn_body_get_position_parts(self.pointer, body, _high_m, _low_m))
        return _high_m, _low_m

    def body_get_angle(self, body):
        """Reads the angle in radians, in (-pi, pi]."""
        _rad = _c.c_float()
        _check(cn_body_get_angle(self.pointer, body, _rad))
        return _rad.value

    def body_get_center(self, body):
        """Reads the world position of the centre of mass, in metres."""
        _m = cn_vec2()
        _check(cn_body_get_center(self.pointer, body, _m))
        return _m

    def body_set_velocity(self, body, linear_x_mps, linear_y_mps, angular_radps):
        """Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
        CN_ERROR_STATE for static bodies. Wakes the body unless all are 0."""
        _check(cn_body_set_velocity(self.pointer, body, linear_x_mps, linear_y_mps, angular_radps), self.pointer)

    def body_get_velocity(self, body):
        """Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s)."""
        _out = cn_velocity()
        _check(cn_body_get_velocity(self.pointer, body, _out))
        return _out

    def body_set_target_pose(self, body, position_x_m, position_y_m, angle_rad, dt_s):
        """Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1)
        takes it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits.
        Unlike after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this
        before every step, or stop the body after it."""
        _check(cn_body_set_target_pose(self.pointer, body, position_x_m, position_y_m, angle_rad, dt_s), self.pointer)

    def body_get_velocity_at(self, body, point_x_m, point_y_m):
        """Velocity in m/s of the body's material at a world point in metres."""
        _mps = cn_vec2()
        _check(cn_body_get_velocity_at(self.pointer, body, point_x_m, point_y_m, _mps))
        return _mps

    def body_get_world_point(self, body, local_x_m, local_y_m):
        """World position of a point given in the body's frame, both in metres."""
        _m = cn_vec2()
        _check(cn_body_get_world_point(self.pointer, body, local_x_m, local_y_m, _m))
        return _m

    def body_get_local_point(self, body, world_x_m, world_y_m):
        """Position in the body's frame of a world point, both in metres."""
        _m = cn_vec2()
        _check(cn_body_get_local_point(self.pointer, body, world_x_m, world_y_m, _m))
        return _m

    def body_get_aabb(self, body):
        """Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
        O(shapes)."""
        _out = cn_aabb()
        _check(cn_body_get_aabb(self.pointer, body, _out))
        return _out

    def body_apply_force(self, body, force_x_N, force_y_N):
        """Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static,
        kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows."""
        _check(cn_body_apply_force(self.pointer, body, force_x_N, force_y_N), self.pointer)

    def body_apply_force_at(self, body, force_x_N, force_y_N, point_x_m, point_y_m):
        """Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
        cn_body_apply_force."""
        _check(cn_body_apply_force_at(self.pointer, body, force_x_N, force_y_N, point_x_m, point_y_m), self.pointer)

    def body_apply_torque(self, body, torque_Nm):
        """Adds a torque in newton metres; otherwise as cn_body_apply_force."""
        _check(cn_body_apply_torque(self.pointer, body, torque_Nm), self.pointer)

    def body_apply_impulse(self, body, impulse_x_Ns, impulse_y_Ns):
        """Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
        Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
        overflows."""
        _check(cn_body_apply_impulse(self.pointer, body, impulse_x_Ns, impulse_y_Ns), self.pointer)

    def body_apply_impulse_at(self, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m):
        """Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity
        too; otherwise as cn_body_apply_impulse."""
        _check(cn_body_apply_impulse_at(self.pointer, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m), self.pointer)

    def body_apply_angular_impulse(self, body, impulse_Nms):
        """Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
        cn_body_apply_impulse."""
        _check(cn_body_apply_angular_impulse(self.pointer, body, impulse_Nms), self.pointer)

    def body_get_mass_data(self, body):
        """Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
        shapes have no mass weighs 1 kg; without shapes it does not rotate."""
        _out = cn_mass_data()
        _check(cn_body_get_mass_data(self.pointer, body, _out))
        return _out

    def body_set_mass_data(self, body, mass):
        """Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
        change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35.
        Wakes the body."""
        _check(cn_body_set_mass_data(self.pointer, body, mass), self.pointer)

    def body_reset_mass_data(self, body):
        """Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes)."""
        _check(cn_body_reset_mass_data(self.pointer, body), self.pointer)

    def body_set_damping(self, body, linear_per_s, angular_per_s):
        """Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0."""
        _check(cn_body_set_damping(self.pointer, body, linear_per_s, angular_per_s), self.pointer)

    def body_get_damping(self, body):
        """Reads the linear and angular damping in 1/s."""
        _linear_per_s = _c.c_float()
        _angular_per_s = _c.c_float()
        _check(cn_body_get_damping(self.pointer, body, _linear_per_s, _angular_per_s))
        return _linear_per_s.value, _angular_per_s.value

    def body_set_gravity_scale(self, body, scale):
        """Sets the factor on gravity for this body, finite. A change wakes the body."""
        _check(cn_body_set_gravity_scale(self.pointer, body, scale), self.pointer)

    def body_get_gravity_scale(self, body):
        """Reads the factor on gravity."""
        _scale = _c.c_float()
        _check(cn_body_get_gravity_scale(self.pointer, body, _scale))
        return _scale.value

    def body_set_sleep_speed(self, body, speed_mps):
        """Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's."""
        _check(cn_body_set_sleep_speed(self.pointer, body, speed_mps), self.pointer)

    def body_set_solver(self, body, solver):
        """Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
        (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
        bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
        within the work_budget. Takes effect with the next step; does not wake."""
        _check(cn_body_set_solver(self.pointer, body, solver), self.pointer)

    def body_get_solver(self, body):
        """Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT)."""
        _solver = _c.c_int32()
        _check(cn_body_get_solver(self.pointer, body, _solver))
        return _solver.value

    def body_set_user_data(self, body, user_data):
        """Stores a number for the user."""
        _check(cn_body_set_user_data(self.pointer, body, user_data), self.pointer)

    def body_get_user_data(self, body):
        """Reads the user's number."""
        _user_data = _c.c_uint64()
        _check(cn_body_get_user_data(self.pointer, body, _user_data))
        return _user_data.value

    def body_set_name(self, body, name=None):
        """Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or '' removes it.
        O(length)."""
        name = name and name.encode()
        _check(cn_body_set_name(self.pointer, body, name), self.pointer)

    def body_get_name(self, body):
        """Reads the name, '' if there is none. Valid until the name changes or the body is destroyed."""
        text = _c.c_char_p()
        _check(cn_body_get_name(self.pointer, body, text))
        return text.value.decode()

    def body_get_shapes(self, body):
        """Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes)."""
        count = _c.c_int32()
        _check(cn_body_get_shapes(self.pointer, body, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_body_get_shapes(self.pointer, body, out, count, count))
        return out

    def body_get_joints(self, body):
        """Handles of the body's joints without constraints; out, capacity and *out_count as in
        cn_world_get_bodies. O(joints)."""
        count = _c.c_int32()
        _check(cn_body_get_joints(self.pointer, body, None, 0, count))
        out = (cn_joint * count.value)()
        _check(cn_body_get_joints(self.pointer, body, out, count, count))
        return out

    def read_poses(self, bodies=None, out=None):
        """Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then
        be their number. One bad handle fails the whole call. O(count)."""
        bodies = _array(cn_body, bodies)
        if bodies is None and out is None:
            out = (cn_pose * len(self.get_bodies()))()
        elif out is None:
            out = (cn_pose * len(bodies))()
        _count = len(out)
        _even(_count, bodies)
        _check(cn_world_read_poses(self.pointer, bodies, _count, out))
        return out

    def read_velocities(self, bodies=None, out=None):
        """Reads count velocities; bodies and count as in cn_world_read_poses. O(count)."""
        bodies = _array(cn_body, bodies)
        if bodies is None and out is None:
            out = (cn_velocity * len(self.get_bodies()))()
        elif out is None:
            out = (cn_velocity * len(bodies))()
        _count = len(out)
        _even(_count, bodies)
        _check(cn_world_read_velocities(self.pointer, bodies, _count, out))
        return out

    def write_velocities(self, velocities, bodies=None):
        """Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
        bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count)."""
        bodies = _array(cn_body, bodies)
        velocities = _array(cn_velocity, velocities)
        _count = len(velocities)
        _even(_count, bodies)
        _check(cn_world_write_velocities(self.pointer, bodies, _count, velocities), self.pointer)

    def moved(self):
        """Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since.
        The first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY."""
        data, count = _c.POINTER(cn_body_moved)(), _c.c_int32()
        _check(cn_world_moved(self.pointer, data, count), self.pointer)
        return _copy(cn_body_moved, data, count.value)

    def shape_create_circle(self, definition, circle):
        """Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL."""
        _shape = cn_shape()
        _check(cn_shape_create_circle(self.pointer, definition, circle, _shape), self.pointer)
        return _shape.value

    def shape_create_capsule(self, definition, capsule):
        """Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body.
        out_shape may be NULL."""
        _shape = cn_shape()
        _check(cn_shape_create_capsule(self.pointer, definition, capsule, _shape), self.pointer)
        return _shape.value

    def shape_create_edge(self, definition, edge):
        """Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL."""
        _shape = cn_shape()
        _check(cn_shape_create_edge(self.pointer, definition, edge, _shape), self.pointer)
        return _shape.value

    def shape_create_polygon(self, definition, polygon):
        """Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
        out_shape may be NULL."""
        _shape = cn_shape()
        _check(cn_shape_create_polygon(self.pointer, definition, polygon, _shape), self.pointer)
        return _shape.value

    def shape_create_box(self, definition, half_width_m, half_height_m, radius_m):
        """Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body.
        out_shape may be NULL."""
        _shape = cn_shape()
        _check(cn_shape_create_box(self.pointer, definition, half_width_m, half_height_m, radius_m, _shape), self.pointer)
        return _shape.value

    def shape_create_chain(self, definition, chain):
        """Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
        may be NULL. O(count)."""
        _shape = cn_shape()
        _check(cn_shape_create_chain(self.pointer, definition, chain, _shape), self.pointer)
        return _shape.value

    def shape_attach(self, shape, body):
        """Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static
        one. CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain)."""
        _check(cn_shape_attach(self.pointer, shape, body), self.pointer)

    def shape_detach(self, shape):
        """Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no
        body. O(contacts + shapes of the body)."""
        _check(cn_shape_detach(self.pointer, shape), self.pointer)

    def shape_destroy(self, shape):
        """Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body)."""
        _check(cn_shape_destroy(self.pointer, shape), self.pointer)

    def shape_is_valid(self, shape):
        """1 if the handle names a living shape of this world, else 0 (also for a NULL world)."""
        return bool(cn_shape_is_valid(self.pointer, shape))

    def shape_get_type(self, shape):
        """Reads the type (CN_SHAPE_CIRCLE to _CHAIN)."""
        _type = _c.c_int32()
        _check(cn_shape_get_type(self.pointer, shape, _type))
        return _type.value

    def shape_get_body(self, shape):
        """Reads the body; 0 if unattached."""
        _body = cn_body()
        _check(cn_shape_get_body(self.pointer, shape, _body))
        return _body.value

    def shape_set_material(self, shape, material):
        """Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
        body)."""
        _check(cn_shape_set_material(self.pointer, shape, material), self.pointer)

    def shape_get_material(self, shape):
        """Reads the material."""
        _out = cn_material()
        _check(cn_shape_get_material(self.pointer, shape, _out))
        return _out

    def shape_set_density(self, shape, density_kgpm2):
        """Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
        wakes the body. O(shapes of the body)."""
        _check(cn_shape_set_density(self.pointer, shape, density_kgpm2), self.pointer)

    def shape_get_density(self, shape):
        """Reads the density in kg/m^2."""
        _kgpm2 = _c.c_float()
        _check(cn_shape_get_density(self.pointer, shape, _kgpm2))
        return _kgpm2.value

    def shape_set_filter(self, shape, filter):
        """Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
        begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body)."""
        _check(cn_shape_set_filter(self.pointer, shape, filter), self.pointer)

    def shape_get_filter(self, shape):
        """Reads the filter."""
        _out = cn_filter()
        _check(cn_shape_get_filter(self.pointer, shape, _out))
        return _out

    def shape_set_event_mask(self, shape, event_mask):
        """Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts
        of the body)."""
        _check(cn_shape_set_event_mask(self.pointer, shape, event_mask), self.pointer)

    def shape_get_event_mask(self, shape):
        """Reads the event mask."""
        _event_mask = _c.c_uint32()
        _check(cn_shape_get_event_mask(self.pointer, shape, _event_mask))
        return _event_mask.value

    def shape_set_flags(self, shape, flags):
        """Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the
        next step. Wakes the body, or the bodies near a static shape. O(contacts of the body)."""
        _check(cn_shape_set_flags(self.pointer, shape, flags), self.pointer)

    def shape_get_flags(self, shape):
        """Reads the CN_SHAPE_ flags."""
        _flags = _c.c_uint32()
        _check(cn_shape_get_flags(self.pointer, shape, _flags))
        return _flags.value

    def shape_set_user_data(self, shape, user_data):
        """Stores a number for the user."""
        _check(cn_shape_set_user_data(self.pointer, shape, user_data), self.pointer)

    def shape_get_user_data(self, shape):
        """Reads the user's number."""
        _user_data = _c.c_uint64()
        _check(cn_shape_get_user_data(self.pointer, shape, _user_data))
        return _user_data.value

    def shape_get_aabb(self, shape):
        """AABB without margin, in the world (in the shape's own space when unattached). O(points)."""
        _out = cn_aabb()
        _check(cn_shape_get_aabb(self.pointer, shape, _out))
        return _out

    def shape_get_mass_data(self, shape):
        """Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
        O(points)."""
        _out = cn_mass_data()
        _check(cn_shape_get_mass_data(self.pointer, shape, _out))
        return _out

    def shape_get_circle(self, shape):
        """Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type."""
        _out = cn_circle()
        _check(cn_shape_get_circle(self.pointer, shape, _out))
        return _out

    def shape_get_capsule(self, shape):
        """Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type."""
        _out = cn_capsule()
        _check(cn_shape_get_capsule(self.pointer, shape, _out))
        return _out

    def shape_get_edge(self, shape):
        """Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type."""
        _out = cn_edge()
        _check(cn_shape_get_edge(self.pointer, shape, _out))
        return _out

    def shape_get_polygon(self, shape):
        """Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type."""
        _out = cn_polygon()
        _check(cn_shape_get_polygon(self.pointer, shape, _out))
        return _out

    def shape_get_chain_points(self, shape):
        """Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
        NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
        written)."""
        count = _c.c_int32()
        _check(cn_shape_get_chain_points(self.pointer, shape, None, 0, count))
        out = (cn_vec2 * count.value)()
        _check(cn_shape_get_chain_points(self.pointer, shape, out, count, count))
        return out

    def shape_set_circle(self, shape, circle):
        """Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
        of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
        once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
        the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
        meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
        CN_ERROR_STATE for another type. O(contacts + shapes of the body)."""
        _check(cn_shape_set_circle(self.pointer, shape, circle), self.pointer)

    def shape_set_capsule(self, shape, capsule):
        """Replaces a capsule in place; otherwise as cn_shape_set_circle."""
        _check(cn_shape_set_capsule(self.pointer, shape, capsule), self.pointer)

    def shape_set_edge(self, shape, edge):
        """Replaces an edge in place; otherwise as cn_shape_set_circle."""
        _check(cn_shape_set_edge(self.pointer, shape, edge), self.pointer)

    def shape_set_polygon(self, shape, polygon):
        """Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle."""
        _check(cn_shape_set_polygon(self.pointer, shape, polygon), self.pointer)

    def shape_set_chain(self, shape, chain):
        """Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
        begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body +
        count)."""
        _check(cn_shape_set_chain(self.pointer, shape, chain), self.pointer)

    def shape_test_point(self, shape, point_x_m, point_y_m):
        """out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
        unattached), else 0. Edges and chains contain no point. O(points)."""
        _inside = _c.c_int32()
        _check(cn_shape_test_point(self.pointer, shape, point_x_m, point_y_m, _inside))
        return _inside.value

    def contact_events(self, kind):
        """The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
        for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
        inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
        apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
        pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
        continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of
        the step, and got an impulse; bodies that pass a blow on to others that already touch them, without
        closing, have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which
        they begin), STAY or HIT."""
        data, count = _c.POINTER(cn_contact_event)(), _c.c_int32()
        _check(cn_world_contact_events(self.pointer, kind, data, count), self.pointer)
        return _copy(cn_contact_event, data, count.value)

    def sensor_events(self):
        """The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
        events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
        kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
        chains. A pair without an awake body reports nothing until one wakes."""
        data, count = _c.POINTER(cn_sensor_event)(), _c.c_int32()
        _check(cn_world_sensor_events(self.pointer, data, count))
        return _copy(cn_sensor_event, data, count.value)

    def body_get_contacts(self, body):
        """The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
        sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
        impulses of the last substep. At rest their force is that of the points times substep_count (with
        CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
        *out_count is their number. O(contacts)."""
        count = _c.c_int32()
        _check(cn_body_get_contacts(self.pointer, body, None, 0, count))
        out = (cn_contact_event * count.value)()
        _check(cn_body_get_contacts(self.pointer, body, out, count, count))
        return out

    def shape_get_contacts(self, shape):
        """The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
        cn_body_get_contacts. O(contacts of its body)."""
        count = _c.c_int32()
        _check(cn_shape_get_contacts(self.pointer, shape, None, 0, count))
        out = (cn_contact_event * count.value)()
        _check(cn_shape_get_contacts(self.pointer, shape, out, count, count))
        return out

    def shape_get_visitors(self, sensor):
        """The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
        and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
        its body), squared for chains."""
        count = _c.c_int32()
        _check(cn_shape_get_visitors(self.pointer, sensor, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_shape_get_visitors(self.pointer, sensor, out, count, count))
        return out

    def fell_asleep(self):
        """Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
        destroyed since are stale."""
        data, count = _c.POINTER(cn_body)(), _c.c_int32()
        _check(cn_world_fell_asleep(self.pointer, data, count))
        return _copy(cn_body, data, count.value)

    def joint_create_revolute(self, definition):
        """Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
        neither is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_revolute(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_distance(self, definition):
        """Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
        neither is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_distance(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_fixed(self, definition):
        """Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_fixed(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_prismatic(self, definition):
        """Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
        neither is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_prismatic(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_wheel(self, definition):
        """Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_wheel(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_motor(self, definition):
        """Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_motor(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_mouse(self, definition):
        """Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic, or body_a is not 0. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_mouse(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_gear(self, definition):
        """Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
        dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_gear(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_pulley(self, definition):
        """Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_pulley(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_ratchet(self, definition):
        """Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_ratchet(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_rotary_spring(self, definition):
        """Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_rotary_spring(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_groove(self, definition):
        """Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
        is dynamic, or the slot has no length. O(contacts of body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_groove(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_create_filter(self, definition):
        """Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
        bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
        body_a)."""
        _joint = cn_joint()
        _check(cn_joint_create_filter(self.pointer, definition, _joint), self.pointer)
        return _joint.value

    def joint_destroy(self, joint):
        """Destroys a joint and wakes its bodies. No event is reported."""
        _check(cn_joint_destroy(self.pointer, joint), self.pointer)

    def joint_is_valid(self, joint):
        """1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world)."""
        return bool(cn_joint_is_valid(self.pointer, joint))

    def joint_get_type(self, joint):
        """Reads the type (CN_JOINT_REVOLUTE to _FILTER)."""
        _type = _c.c_int32()
        _check(cn_joint_get_type(self.pointer, joint, _type))
        return _type.value

    def joint_get_bodies(self, joint):
        """Reads both bodies; 0 stands for the world."""
        _a = cn_body()
        _b = cn_body()
        _check(cn_joint_get_bodies(self.pointer, joint, _a, _b))
        return _a.value, _b.value

    def joint_get_anchors(self, joint):
        """Reads the world positions of both anchors, in metres."""
        _world_a_m = cn_vec2()
        _world_b_m = cn_vec2()
        _check(cn_joint_get_anchors(self.pointer, joint, _world_a_m, _world_b_m))
        return _world_a_m, _world_b_m

    def joint_get_reaction(self, joint):
        """Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
        after a change of type or of CN_BODY_ENABLED of one of its bodies."""
        _force_N = cn_vec2()
        _torque_Nm = _c.c_float()
        _check(cn_joint_get_reaction(self.pointer, joint, _force_N, _torque_Nm))
        return _force_N, _torque_Nm.value

    def joint_get_error(self, joint):
        """Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
        (angles beyond limits)."""
        _m = _c.c_float()
        _rad = _c.c_float()
        _check(cn_joint_get_error(self.pointer, joint, _m, _rad))
        return _m.value, _rad.value

    def joint_set_solver(self, joint, solver):
        """Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
        together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
        connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for
        a world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next
        step; does not wake."""
        _check(cn_joint_set_solver(self.pointer, joint, solver), self.pointer)

    def joint_get_solver(self, joint):
        """Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT)."""
        _solver = _c.c_int32()
        _check(cn_joint_get_solver(self.pointer, joint, _solver))
        return _solver.value

    def joint_set_user_data(self, joint, user_data):
        """Stores a number for the user."""
        _check(cn_joint_set_user_data(self.pointer, joint, user_data), self.pointer)

    def joint_get_user_data(self, joint):
        """Reads the user's number."""
        _user_data = _c.c_uint64()
        _check(cn_joint_get_user_data(self.pointer, joint, _user_data))
        return _user_data.value

    def joint_set_flags(self, joint, flags):
        """Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes."""
        _check(cn_joint_set_flags(self.pointer, joint, flags), self.pointer)

    def joint_get_flags(self, joint):
        """Reads the CN_JOINT_ flags."""
        _flags = _c.c_uint32()
        _check(cn_joint_get_flags(self.pointer, joint, _flags))
        return _flags.value

    def joint_get_revolute(self, joint):
        """Reads the definition of a revolute joint. CN_ERROR_STATE for another type."""
        _out = cn_revolute_def()
        _check(cn_joint_get_revolute(self.pointer, joint, _out))
        return _out

    def joint_set_revolute(self, joint, definition):
        """Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_revolute(self.pointer, joint, definition), self.pointer)

    def joint_get_distance(self, joint):
        """Reads the definition of a distance joint. CN_ERROR_STATE for another type."""
        _out = cn_distance_def()
        _check(cn_joint_get_distance(self.pointer, joint, _out))
        return _out

    def joint_set_distance(self, joint, definition):
        """Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_distance(self.pointer, joint, definition), self.pointer)

    def joint_get_fixed(self, joint):
        """Reads the definition of a fixed joint. CN_ERROR_STATE for another type."""
        _out = cn_fixed_def()
        _check(cn_joint_get_fixed(self.pointer, joint, _out))
        return _out

    def joint_set_fixed(self, joint, definition):
        """Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_fixed(self.pointer, joint, definition), self.pointer)

    def joint_get_prismatic(self, joint):
        """Reads the definition of a prismatic joint. CN_ERROR_STATE for another type."""
        _out = cn_prismatic_def()
        _check(cn_joint_get_prismatic(self.pointer, joint, _out))
        return _out

    def joint_set_prismatic(self, joint, definition):
        """Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors
        and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_prismatic(self.pointer, joint, definition), self.pointer)

    def joint_get_wheel(self, joint):
        """Reads the definition of a wheel joint. CN_ERROR_STATE for another type."""
        _out = cn_wheel_def()
        _check(cn_joint_get_wheel(self.pointer, joint, _out))
        return _out

    def joint_set_wheel(self, joint, definition):
        """Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_wheel(self.pointer, joint, definition), self.pointer)

    def joint_get_motor_to(self, joint):
        """Reads the definition of a motor joint. CN_ERROR_STATE for another type."""
        _out = cn_motor_def()
        _check(cn_joint_get_motor_to(self.pointer, joint, _out))
        return _out

    def joint_set_motor_to(self, joint, definition):
        """Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_motor_to(self.pointer, joint, definition), self.pointer)

    def joint_get_mouse(self, joint):
        """Reads the definition of a mouse joint. CN_ERROR_STATE for another type."""
        _out = cn_mouse_def()
        _check(cn_joint_get_mouse(self.pointer, joint, _out))
        return _out

    def joint_set_mouse(self, joint, definition):
        """Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
        struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
        CN_JOINT_COLLIDE changes."""
        _check(cn_joint_set_mouse(self.pointer, joint, definition), self.pointer)

    def joint_get_gear(self, joint):
        """Reads the definition of a gear joint. CN_ERROR_STATE for another type."""
        _out = cn_gear_def()
        _check(cn_joint_get_gear(self.pointer, joint, _out))
        return _out

    def joint_set_gear(self, joint, definition):
        """Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
        struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
        both bodies. O(contacts) when CN_JOINT_COLLIDE changes."""
        _check(cn_joint_set_gear(self.pointer, joint, definition), self.pointer)

    def joint_get_pulley(self, joint):
        """Reads the definition of a pulley joint. CN_ERROR_STATE for another type."""
        _out = cn_pulley_def()
        _check(cn_joint_get_pulley(self.pointer, joint, _out))
        return _out

    def joint_set_pulley(self, joint, definition):
        """Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_pulley(self.pointer, joint, definition), self.pointer)

    def joint_get_ratchet(self, joint):
        """Reads the definition of a ratchet joint. CN_ERROR_STATE for another type."""
        _out = cn_ratchet_def()
        _check(cn_joint_get_ratchet(self.pointer, joint, _out))
        return _out

    def joint_set_ratchet(self, joint, definition):
        """Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
        struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes
        both bodies. O(contacts) when CN_JOINT_COLLIDE changes."""
        _check(cn_joint_set_ratchet(self.pointer, joint, definition), self.pointer)

    def joint_get_rotary_spring(self, joint):
        """Reads the definition of a rotary spring. CN_ERROR_STATE for another type."""
        _out = cn_rotary_spring_def()
        _check(cn_joint_get_rotary_spring(self.pointer, joint, _out))
        return _out

    def joint_set_rotary_spring(self, joint, definition):
        """Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_rotary_spring(self.pointer, joint, definition), self.pointer)

    def joint_get_groove(self, joint):
        """Reads the definition of a groove joint. CN_ERROR_STATE for another type."""
        _out = cn_groove_def()
        _check(cn_joint_get_groove(self.pointer, joint, _out))
        return _out

    def joint_set_groove(self, joint, definition):
        """Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
        struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
        changes."""
        _check(cn_joint_set_groove(self.pointer, joint, definition), self.pointer)

    def joint_get_base(self, joint):
        """Reads the base of a joint of any type."""
        _out = cn_joint_base()
        _check(cn_joint_get_base(self.pointer, joint, _out))
        return _out

    def joint_set_base(self, joint, base):
        """Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges
        as in cn_joint_base. Wakes both bodies."""
        _check(cn_joint_set_base(self.pointer, joint, base), self.pointer)

    def joint_set_target(self, joint, target_x_m, target_y_m):
        """Sets the target of a mouse joint, a world point in metres; cheap enough for every frame.
        CN_ERROR_STATE for another type. Wakes the body."""
        _check(cn_joint_set_target(self.pointer, joint, target_x_m, target_y_m), self.pointer)

    def joint_get_position(self, joint):
        """Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
        reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the
        translation along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a;
        ratchet, rotary spring: angle b - angle a; these three over whole turns."""
        _position = _c.c_float()
        _check(cn_joint_get_position(self.pointer, joint, _position))
        return _position.value

    def joint_get_speed(self, joint):
        """Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
        positive motor speed has the same sign."""
        _speed = _c.c_float()
        _check(cn_joint_get_speed(self.pointer, joint, _speed))
        return _speed.value

    def joint_set_motor(self, joint, speed, force_or_torque_max):
        """Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
        prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies."""
        _check(cn_joint_set_motor(self.pointer, joint, speed, force_or_torque_max), self.pointer)

    def joint_set_limits(self, joint, lower, upper):
        """Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0),
        prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies."""
        _check(cn_joint_set_limits(self.pointer, joint, lower, upper), self.pointer)

    def joint_events(self):
        """Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a
        body in that step or between it and the step before."""
        data, count = _c.POINTER(cn_joint_event)(), _c.c_int32()
        _check(cn_world_joint_events(self.pointer, data, count))
        return _copy(cn_joint_event, data, count.value)

    def constraint_create_angle(self, definition):
        """Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
        not dynamic. Wakes the body."""
        _constraint = cn_constraint()
        _check(cn_constraint_create_angle(self.pointer, definition, _constraint), self.pointer)
        return _constraint.value

    def constraint_create_line(self, definition):
        """Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
        not dynamic. Wakes the body."""
        _constraint = cn_constraint()
        _check(cn_constraint_create_line(self.pointer, definition, _constraint), self.pointer)
        return _constraint.value

    def constraint_destroy(self, constraint):
        """Destroys a constraint and wakes its body. No event is reported."""
        _check(cn_constraint_destroy(self.pointer, constraint), self.pointer)

    def constraint_is_valid(self, constraint):
        """1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world)."""
        return bool(cn_constraint_is_valid(self.pointer, constraint))

    def constraint_get_type(self, constraint):
        """Reads the type (CN_CONSTRAINT_ANGLE or _LINE)."""
        _type = _c.c_int32()
        _check(cn_constraint_get_type(self.pointer, constraint, _type))
        return _type.value

    def constraint_get_body(self, constraint):
        """Reads the body."""
        _body = cn_body()
        _check(cn_constraint_get_body(self.pointer, constraint, _body))
        return _body.value

    def constraint_get_angle(self, constraint):
        """Reads the definition of an angle constraint. CN_ERROR_STATE for another type."""
        _out = cn_angle_constraint_def()
        _check(cn_constraint_get_angle(self.pointer, constraint, _out))
        return _out

    def constraint_set_angle(self, constraint, definition):
        """Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes
        the body."""
        _check(cn_constraint_set_angle(self.pointer, constraint, definition), self.pointer)

    def constraint_get_line(self, constraint):
        """Reads the definition of a line constraint. CN_ERROR_STATE for another type."""
        _out = cn_line_constraint_def()
        _check(cn_constraint_get_line(self.pointer, constraint, _out))
        return _out

    def constraint_set_line(self, constraint, definition):
        """Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
        body."""
        _check(cn_constraint_set_line(self.pointer, constraint, definition), self.pointer)

    def constraint_get_position(self, constraint):
        """Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
        along the axis, in metres from origin."""
        _position = _c.c_float()
        _check(cn_constraint_get_position(self.pointer, constraint, _position))
        return _position.value

    def constraint_get_reaction(self, constraint):
        """Force in newtons and torque in newton metres that the constraint applied to the body in the last
        substep."""
        _force_N = cn_vec2()
        _torque_Nm = _c.c_float()
        _check(cn_constraint_get_reaction(self.pointer, constraint, _force_N, _torque_Nm))
        return _force_N, _torque_Nm.value

    def constraint_get_error(self, constraint):
        """Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle
        constraint."""
        _m = _c.c_float()
        _rad = _c.c_float()
        _check(cn_constraint_get_error(self.pointer, constraint, _m, _rad))
        return _m.value, _rad.value

    def get_constraints(self):
        """Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
        O(slots)."""
        count = _c.c_int32()
        _check(cn_world_get_constraints(self.pointer, None, 0, count))
        out = (cn_constraint * count.value)()
        _check(cn_world_get_constraints(self.pointer, out, count, count))
        return out

    def body_get_constraints(self, body):
        """Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
        constraints of the body)."""
        count = _c.c_int32()
        _check(cn_body_get_constraints(self.pointer, body, None, 0, count))
        out = (cn_constraint * count.value)()
        _check(cn_body_get_constraints(self.pointer, body, out, count, count))
        return out

    def set_fixed_step(self, step_s, steps_max):
        """Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
        update, 1 to 1000, default 8."""
        _check(cn_world_set_fixed_step(self.pointer, step_s, steps_max), self.pointer)

    def update(self, elapsed_s):
        """Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
        event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps."""
        _out = cn_update_report()
        _check(cn_world_update(self.pointer, elapsed_s, _out), self.pointer)
        return _out

    def read_poses_interpolated(self, factor, bodies=None, out=None):
        """Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last
        step, 1 after it. Bodies that did not take part in the last step have their present pose. bodies and
        count as in cn_world_read_poses. O(count)."""
        bodies = _array(cn_body, bodies)
        if bodies is None and out is None:
            out = (cn_pose * len(self.get_bodies()))()
        elif out is None:
            out = (cn_pose * len(bodies))()
        _count = len(out)
        _even(_count, bodies)
        _check(cn_world_read_poses_interpolated(self.pointer, bodies, _count, factor, out))
        return out

    def cast_ray(self, ray, filter=None):
        """Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
        their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child.
        filter may be NULL: the defaults. O(log shapes) to O(shapes along the ray)."""
        _out = cn_ray_hit()
        _check(cn_world_cast_ray(self.pointer, ray, filter, _out))
        return _out

    def cast_ray_any(self, ray, filter=None):
        """out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL.
        O(log shapes) to O(shapes along the ray)."""
        _hit = _c.c_int32()
        _check(cn_world_cast_ray_any(self.pointer, ray, filter, _hit))
        return _hit.value

    def cast_ray_all(self, ray, filter=None):
        """Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found.
        A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity)."""
        count = _c.c_int32()
        _check(cn_world_cast_ray_all(self.pointer, ray, filter, None, 0, count))
        out = (cn_ray_hit * count.value)()
        _check(cn_world_cast_ray_all(self.pointer, ray, filter, out, count, count))
        return out

    def cast_rays(self, rays, filter=None, out=None):
        """Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
        filter may be NULL. O(sum of the rays)."""
        rays = _array(cn_ray, rays)
        if out is None:
            out = (cn_ray_hit * len(rays))()
        _count = len(out)
        _even(_count, rays)
        _check(cn_world_cast_rays(self.pointer, rays, _count, filter, out))
        return out

    def shape_cast_ray(self, shape, ray):
        """Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
        O(points of the shape)."""
        _out = cn_ray_hit()
        _check(cn_shape_cast_ray(self.pointer, shape, ray, _out))
        return _out

    def cast_shape(self, shape, translation_x_m, translation_y_m, filter=None):
        """First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
        way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or
        2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the
        moving points is in front of it. filter may be NULL. O(shapes along the way)."""
        _out = cn_ray_hit()
        _check(cn_world_cast_shape(self.pointer, shape, translation_x_m, translation_y_m, filter, _out))
        return _out

    def overlap_aabb(self, box, filter=None):
        """Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
        cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
        filter may be NULL. O(log shapes) to O(boxes in the region)."""
        count = _c.c_int32()
        _check(cn_world_overlap_aabb(self.pointer, box, filter, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_world_overlap_aabb(self.pointer, box, filter, out, count, count))
        return out

    def overlap_circle(self, circle, filter=None):
        """Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
        Edges and chains are lines here, seen from both sides."""
        count = _c.c_int32()
        _check(cn_world_overlap_circle(self.pointer, circle, filter, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_world_overlap_circle(self.pointer, circle, filter, out, count, count))
        return out

    def overlap_polygon(self, polygon, filter=None):
        """Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
        in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides."""
        count = _c.c_int32()
        _check(cn_world_overlap_polygon(self.pointer, polygon, filter, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_world_overlap_polygon(self.pointer, polygon, filter, out, count, count))
        return out

    def overlap_point(self, x_m, y_m, filter=None):
        """Shapes that contain a world point in metres; order, capacity, filter and cost as in
        cn_world_overlap_aabb. Edges and chains contain no point."""
        count = _c.c_int32()
        _check(cn_world_overlap_point(self.pointer, x_m, y_m, filter, None, 0, count))
        out = (cn_shape * count.value)()
        _check(cn_world_overlap_point(self.pointer, x_m, y_m, filter, out, count, count))
        return out

    def closest_point(self, x_m, y_m, distance_max_m, filter=None):
        """Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
        contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m."""
        _out = cn_closest()
        _check(cn_world_closest_point(self.pointer, x_m, y_m, distance_max_m, filter, _out))
        return _out

    def mover_collide(self, shape, position_x_m, position_y_m, margin_m, filter=None):
        """Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape)
        moved by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of
        least separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a
        one-way shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the
        length unit plus its rise in the last step. Shapes wholly behind the plane of another shape are left
        out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby,
        squared)."""
        count = _c.c_int32()
        _check(cn_mover_collide(self.pointer, shape, position_x_m, position_y_m, margin_m, filter, None, 0, count))
        out = (cn_plane * count.value)()
        _check(cn_mover_collide(self.pointer, shape, position_x_m, position_y_m, margin_m, filter, out, count, count))
        return out

    def mover_move(self, definition, dt_s, mover):
        """Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step
        behind the ground that carries it. 1. carried   by the motion of its ground since the last move: of
        the point of ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across
        up, along the ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A
        step up where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground
        flying    in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off
        keep ground_velocity_mps 3. sliding   both by collision planes, cn_mover_solve and casts, up to
        iterations_max times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a
        force for the next step that brings them to the character's velocity, of at most push_force_N each 5.
        ground    ground that it touches, or that lies within snap_m below a walking character; velocity_mps
        loses blocked components The result depends on the world, def and mover alone: equal calls give equal
        bits. The loop of planes, solver and cast is that of Box2D 3's sample of a character mover (Catto,
        2025). Pushed bodies wake; nothing else in the world changes. O(shapes nearby x iterations_max): about
        1 us standing, 3 us walking, 10 us against a wall."""
        _check(cn_mover_move(self.pointer, definition, dt_s, mover), self.pointer)

    def shape_set_area(self, shape, definition=None):
        """Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter
        says which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an
        area that loses the flag later does nothing while it is without. Gravity, and damping without density,
        act on bodies whose centre of mass is in the area (on its border too) while one of their shapes
        touches it: on a body half in it in full or not at all. The medium acts on the part of each shape that
        is in the area, exactly for polygons; parts of round shapes are computed as those of polygons of 16
        sides, to 1%. The surface of a circle or capsule is flat across a body, as of a planet. Shapes of a
        body do not shade each other. The area's body feels no reaction. Between steps nothing happens: the
        acceleration is that in the middle of the next step (leapfrog), so bodies on orbits and floating
        bodies keep their energy. Damping and drag are implicit: stable at any strength, mass and time step,
        with exact terminal speeds. Bodies that enter or leave, that are in an area that moves, and those in
        it now, wake; bodies at rest in it may sleep. Areas are in saves and files. Floats whose draught is
        less than about g dt^2 (3 mm at 60 steps a second) are damped, and carry less under a load. An area
        takes 64 bytes of the world's memory; a step takes about 0.15 us for each shape in an area, 0.35 us in
        a medium. Best on a body of its own: O(contacts of the body)."""
        _check(cn_shape_set_area(self.pointer, shape, definition), self.pointer)

    def shape_get_area(self, shape):
        """Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas)."""
        _out = cn_area_def()
        _check(cn_shape_get_area(self.pointer, shape, _out))
        return _out

    def shape_apply_wind(self, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake):
        """The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each
        step. flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w
        across it, with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton
        (1687), and across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle
        between surface and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the
        whole outline, round parts included, and drag along straight edges also for turning bodies; edges and
        chains are plates with two sides. Solved implicitly, so that wind never reverses the motion relative
        to it, at any speed, mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0:
        sleeping bodies stay asleep and unchanged; else they wake. Static, kinematic and disabled bodies are
        unchanged. CN_ERROR_STATE for a shape without a body. O(points)."""
        _check(cn_shape_apply_wind(self.pointer, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake), self.pointer)

    def explode(self, definition):
        """Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
        them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that)."""
        _check(cn_world_explode(self.pointer, definition), self.pointer)


class Tree:
    """A dynamic AABB tree; the garbage collector destroys it."""

    _pointer = None

    def __init__(self, margin_m):
        pointer = _c.POINTER(cn_tree)()
        _check(cn_tree_create(margin_m, cn_alloc_fn(), cn_free_fn(), None, pointer))
        self._pointer = self.pointer = pointer

    def __del__(self):
        if self._pointer is not None:
            cn_tree_destroy(self._pointer)

    def insert(self, box, user_data):
        """Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n)."""
        _item = _c.c_uint32()
        _check(cn_tree_insert(self.pointer, box, user_data, _item))
        return _item.value

    def remove(self, item):
        """Removes an item. CN_ERROR_HANDLE for a stale one. O(log n)."""
        _check(cn_tree_remove(self.pointer, item))

    def move(self, item, box):
        """Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log
        n). CN_ERROR_HANDLE for a stale item."""
        _check(cn_tree_move(self.pointer, item, box))

    def get_box(self, item):
        """Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item."""
        _out = cn_aabb()
        _check(cn_tree_get_box(self.pointer, item, _out))
        return _out

    def get_stats(self):
        """Reads the number of items and the height of the tree."""
        _count = _c.c_int32()
        _height = _c.c_int32()
        _check(cn_tree_get_stats(self.pointer, _count, _height))
        return _count.value, _height.value



def version():
    """Version of the library as major * 1000000 + minor * 1000 + patch."""
    return cn_version()


def abi_version():
    """CN_ABI_VERSION of the library that was linked; a binding compares it with its own."""
    return cn_abi_version()


def result_text(result):
    """English text for a result code: static, never NULL."""
    return cn_result_text(result).decode()


def save_delta_size(base, save):
    """Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes)."""
    _bytes = _c.c_uint64()
    _check(cn_save_delta_size(base, len(base), save, len(save), _bytes))
    return _bytes.value


def save_delta(base, save):
    """Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
    out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes)."""
    _bytes = _c.c_uint64()
    _check(cn_save_delta_size(base, len(base), save, len(save), _bytes))
    _out = _c.create_string_buffer(_bytes.value or 1)
    _check(cn_save_delta(base, len(base), save, len(save), _out, _bytes, _bytes))
    return _out.raw[: _bytes.value]


def save_apply(base, delta):
    """Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
    out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
    CN_ERROR_CAPACITY if out is too small. O(bytes)."""
    _bytes = _c.c_uint64()
    _bytes.value = len(base) + len(delta)
    _out = _c.create_string_buffer(_bytes.value or 1)
    _check(cn_save_apply(base, len(base), delta, len(delta), _out, _bytes, _bytes))
    return _out.raw[: _bytes.value]


def polygon_make_hull(points_m, radius_m):
    """Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
    farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
    area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
    mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
    O(count^2) at worst."""
    points_m = _array(cn_vec2, points_m)
    _count = len(points_m)
    _out = cn_polygon()
    _check(cn_polygon_make_hull(points_m, _count, radius_m, _out))
    return _out


def polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m):
    """A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
    (|angle| <= 1e4); radius_m >= 0."""
    _out = cn_polygon()
    _check(cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, _out))
    return _out


def outline_decompose(points_m, length_unit_m):
    """Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
    in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
    without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
    Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
    thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
    area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
    *out_count is the number of all. 34 KB of stack. O(count^2)."""
    points_m = _array(cn_vec2, points_m)
    _count = len(points_m)
    count = _c.c_int32()
    _check(cn_outline_decompose(points_m, _count, length_unit_m, None, 0, count))
    out = (cn_polygon * count.value)()
    _check(cn_outline_decompose(points_m, _count, length_unit_m, out, count, count))
    return out


def outline_simplify(points_m, closed, tolerance_m):
    """Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
    tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
    0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
    afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
    points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst."""
    points_m = _array(cn_vec2, points_m)
    _count = len(points_m)
    count = _c.c_int32()
    _check(cn_outline_simplify(points_m, _count, closed, tolerance_m, None, 0, count))
    out = (cn_vec2 * count.value)()
    _check(cn_outline_simplify(points_m, _count, closed, tolerance_m, out, count, count))
    return out


def outline_from_cells(cells, columns, origin_x_m, origin_y_m, cell_m, outline):
    """An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
    squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
    column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
    0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
    counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
    touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
    (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
    boundary of n edges."""
    cells = _array(uint8_t, cells)
    _count = len(cells)
    count = _c.c_int32()
    _check(cn_outline_from_cells(cells, _count, columns, origin_x_m, origin_y_m, cell_m, outline, None, 0, count))
    out = (cn_vec2 * count.value)()
    _check(cn_outline_from_cells(cells, _count, columns, origin_x_m, origin_y_m, cell_m, outline, out, count, count))
    return out


def outline_from_field(values, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline):
    """The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
    finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
    columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
    least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
    another one. cn_outline_simplify removes its collinear points. O(values + n log n)."""
    values = _array(float, values)
    _count = len(values)
    count = _c.c_int32()
    _check(cn_outline_from_field(values, _count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, None, 0, count))
    out = (cn_vec2 * count.value)()
    _check(cn_outline_from_field(values, _count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, out, count, count))
    return out


def polygon_distance(a, pose_a, b, pose_b):
    """Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
    radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points)."""
    _out = cn_distance()
    _check(cn_polygon_distance(a, pose_a, b, pose_b, _out))
    return _out


def polygon_cast(a, pose_a, b, pose_b, translation_x_m, translation_y_m):
    """Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
    as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points)."""
    _out = cn_ray_hit()
    _hit = _c.c_int32()
    _check(cn_polygon_cast(a, pose_a, b, pose_b, translation_x_m, translation_y_m, _out, _hit))
    return _out, _hit.value


def polygon_collide(a, pose_a, b, pose_b, margin_m):
    """Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
    to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
    O(points)."""
    _out = cn_manifold()
    _check(cn_polygon_collide(a, pose_a, b, pose_b, margin_m, _out))
    return _out


def polygon_time_of_impact(a, sweep_a, b, sweep_b, distance_m):
    """First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
    start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
    hit. Needs no world; runs in any thread."""
    _out = cn_impact()
    _check(cn_polygon_time_of_impact(a, sweep_a, b, sweep_b, distance_m, _out))
    return _out


def mover_solve(planes, translation_x_m, translation_y_m):
    """The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
    dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
    finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
    of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
    limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it."""
    planes = _array(cn_plane, planes)
    _count = len(planes)
    _translation_m = cn_vec2()
    _overlap_m = _c.c_float()
    _check(cn_mover_solve(planes, _count, translation_x_m, translation_y_m, _translation_m, _overlap_m))
    return _translation_m, _overlap_m.value


def mover_clip(planes, velocity_x_mps, velocity_y_mps):
    """The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
    cn_mover_solve. Needs no world. O(count^2)."""
    planes = _array(cn_plane, planes)
    _count = len(planes)
    _mps = cn_vec2()
    _check(cn_mover_clip(planes, _count, velocity_x_mps, velocity_y_mps, _mps))
    return _mps
