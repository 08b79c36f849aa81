"""Cairn for Python (ctypes), one to one with cairn.h.
Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.

    import ctypes
    from cairn import *

    definition = cn_world_def()
    cn_world_def_init(definition)
    world = ctypes.POINTER(cn_world)()
    assert cn_world_create(definition, world) == CN_OK

Where C takes a pointer to a struct or number, pass the struct or a ctypes number itself; where it
takes an array, pass an array. CAIRN_LIBRARY in the environment names another file than the system's
libcairn.
"""
import ctypes as _c
import os as _os
import sys as _sys

_files = {"darwin": "libcairn.dylib", "win32": "cairn.dll"}
_library = _c.CDLL(_os.environ.get("CAIRN_LIBRARY") or _files.get(_sys.platform, "libcairn.so"))

# A library of another version would read other structs: refuse it here and, by their sizes, below.
if _library.cn_abi_version() != 2:
    raise ImportError("cairn.py is for ABI 2, the library has %d" % _library.cn_abi_version())


def _function(name, result, *arguments):
    function = getattr(_library, name)
    function.restype = result
    function.argtypes = arguments
    return function


CN_VERSION_MAJOR = 0
CN_VERSION_MINOR = 1
CN_VERSION_PATCH = 0
CN_ABI_VERSION = 2
CN_POLYGON_MAX_VERTICES = 16
CN_NAME_MAX_BYTES = 63
CN_PLANES_MAX = 64
CN_WORKERS_MAX = 64
CN_MAX_HANDLES = 1048575
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
CN_TYPE_COUNT = 54
CN_WORLD_SLEEP = 1
CN_WORLD_WARM_START = 2
CN_WORLD_PROFILE = 4
CN_WORLD_CONTINUOUS = 8
CN_SOLVER_AUTO = 0
CN_SOLVER_SOFT = 1
CN_SOLVER_DIRECT = 2
CN_SOLVER_SEQUENTIAL = 3
CN_BROADPHASE_SWEEP = 0
CN_BROADPHASE_TREE = 1
CN_WARNING_CONTACT_MEMORY = 1
CN_WARNING_FRAME_MEMORY = 2
CN_WARNING_EVENT_MEMORY = 4
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
CN_EVENT_KINDS = 5
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
    _fields_ = [
        ("x", _c.c_float),
        ("y", _c.c_float),
    ]


class cn_pose(_c.Structure):
    # Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of these can be
    # uploaded to a GPU as it is.
    _fields_ = [
        ("position_m", cn_vec2),
        ("cosine", _c.c_float),
        ("sine", _c.c_float),
    ]


class cn_velocity(_c.Structure):
    _fields_ = [
        ("linear_mps", cn_vec2),  # of the centre of mass
        ("angular_radps", _c.c_float),
    ]


class cn_aabb(_c.Structure):
    _fields_ = [
        ("lower_m", cn_vec2),
        ("upper_m", cn_vec2),
    ]


class cn_mass_data(_c.Structure):
    _fields_ = [
        ("mass_kg", _c.c_float),
        ("inertia_kgm2", _c.c_float),  # about the centre of mass
        ("center_m", cn_vec2),  # in the body's local frame
    ]


# Memory hooks. Return NULL when there is none; align is a power of two, at most 64. Called only from inside
# functions that take a non-const world.
cn_alloc_fn = _c.CFUNCTYPE(_c.c_void_p, _c.c_uint64, _c.c_uint32, _c.c_void_p)


cn_free_fn = _c.CFUNCTYPE(None, _c.c_void_p, _c.c_uint64, _c.c_void_p)


# A user's own task system, for worlds with worker_count of 2 or more; without one they start threads of their
# own. Within cn_world_step a world that has enough to do asks for help with enqueue, works itself, and then
# calls finish; some 3 to 10 times a step. It does not matter where tasks run, in which order, or whether side
# by side. cn_task_fn     the library's: call it for ranges [begin, end) that cover 0 to item_count - 1, each
# item once, on any threads. A call may last as long as the step, and may wait for others that have already
# begun, never for one that has not. Its thread must have the floating-point mode of the one that steps.
# cn_enqueue_fn  the user's: makes a task of item_count items (one less than worker_count) in ranges of at
# least min_range, and returns what finish knows it by. It may also run all of it at once, and must do so if
# it cannot keep it; NULL then says that there is nothing to finish. cn_finish_fn   the user's: returns when
# every item of the task has run. Called once for each enqueue that did not return NULL, in the thread that
# enqueued. It may run items itself. enqueue and finish are called in the thread that steps, while no callback
# runs, and must not call the library.
cn_task_fn = _c.CFUNCTYPE(None, _c.c_int32, _c.c_int32, _c.c_void_p)


cn_enqueue_fn = _c.CFUNCTYPE(_c.c_void_p, cn_task_fn, _c.c_void_p, _c.c_int32, _c.c_int32, _c.c_void_p)


cn_finish_fn = _c.CFUNCTYPE(None, _c.c_void_p, _c.c_void_p)


class cn_world_def(_c.Structure):
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("flags", _c.c_uint32),  # CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS
        ("gravity_mps2", cn_vec2),  # default (0, -10)
        ("length_unit_m", _c.c_float),  # a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1
        ("solver", _c.c_int32),  # CN_SOLVER_*; default CN_SOLVER_AUTO
        ("broadphase", _c.c_int32),  # CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP
        ("substep_count", _c.c_int32),  # 1 to 64; default 4
        ("accuracy_m", _c.c_float),  # CN_SOLVER_AUTO works towards errors below this, >= 0; default 0.005 x length unit
        ("work_budget", _c.c_int32),  # ... but spends no more than this on direct solving in a step, in blocks (joints, contacts and the fill between them) factored, substeps included: some 10 ns each; 0 to 1e9; default 0: no bound but those of single islands
        ("restitution_threshold_mps", _c.c_float),  # slower impacts do not bounce, >= 0; default 1 x length unit
        ("push_speed_max_mps", _c.c_float),  # fastest speed at which overlap is pushed apart, > 0; default 3 x length unit
        ("linear_speed_max_mps", _c.c_float),  # > 0; default 400 x length unit
        ("angular_speed_max_radps", _c.c_float),  # > 0; default 400
        ("sleep_speed_mps", _c.c_float),  # bodies slower than this may sleep, >= 0; default 0.05 x length unit
        ("sleep_delay_s", _c.c_float),  # ... after this long, >= 0; default 0.5
        ("body_capacity", _c.c_int32),  # hints for a growing world, exact for a fixed one; >= 0; default 0
        ("shape_capacity", _c.c_int32),  # counts every edge of a chain
        ("contact_capacity", _c.c_int32),
        ("joint_capacity", _c.c_int32),  # counts constraints too
        ("user_data", _c.c_uint64),
        ("memory_bytes", _c.c_uint64),  # size of memory; 0: use alloc and free
        ("memory", _c.c_void_p),  # NULL, or one block aligned to 64 bytes that the world lives in, whole
        ("alloc", cn_alloc_fn),  # NULL: malloc; set both or none
        ("free", cn_free_fn),
        ("allocator_user", _c.c_void_p),
        ("enqueue", cn_enqueue_fn),  # NULL: threads of the world's own; set both or none
        ("finish", cn_finish_fn),
        ("task_user", _c.c_void_p),
        ("worker_count", _c.c_int32),  # how many may work on a step at once, the calling thread one of them; 0 to CN_WORKERS_MAX; default 0: as 1, which starts no threads and enqueues no tasks
        ("reserved", _c.c_uint32),
    ]


class cn_counters(_c.Structure):
    _fields_ = [
        ("bodies", _c.c_int32),
        ("bodies_awake", _c.c_int32),  # dynamic and kinematic bodies that are simulated
        ("shapes", _c.c_int32),
        ("proxies", _c.c_int32),  # boxes in the broadphase: one a shape, one an edge of a chain
        ("contacts", _c.c_int32),  # pairs whose fat boxes overlap
        ("contacts_awake", _c.c_int32),
        ("contacts_touching", _c.c_int32),  # pairs that share a manifold, asleep or awake
        ("joints", _c.c_int32),  # and constraints
        ("joints_awake", _c.c_int32),
        ("islands", _c.c_int32),  # awake and asleep, of two or more bodies or one
        ("islands_awake", _c.c_int32),
        ("colors_used", _c.c_int32),  # groups of contacts that are solved without sharing a body
        ("overflow_contacts", _c.c_int32),  # contacts that fit no colour and are solved one by one
        ("broadphase_tiles", _c.c_int32),
        ("steps", _c.c_uint32),  # steps taken since creation, modulo 2^32
        ("warnings", _c.c_uint32),  # What the last step could not do for want of memory; 0 when all is well. It tries again. CN_WARNING_*
        ("pairs_not_added", _c.c_int32),
        ("events_not_reported", _c.c_int32),
        ("islands_direct", _c.c_int32),  # of several bodies, solved directly in the last step, contacts and all
        ("direct_work", _c.c_int32),  # planned for all that is solved directly in it, in the units of work_budget; at most 2^31 - 1
        ("islands_unsolved", _c.c_int32),  # of several bodies, left to soft constraints for a time because no solution was found: CN_TIER_REASON_NO_SET
    ]


class cn_island_report(_c.Structure):
    _fields_ = [
        ("body", cn_body),  # one of it: of least slot
        ("bodies", _c.c_int32),
        ("contacts", _c.c_int32),  # touching
        ("joints", _c.c_int32),  # and constraints
        ("tier", _c.c_int32),  # CN_TIER_*, after the last step
        ("reason", _c.c_int32),  # CN_TIER_REASON_*
        ("substeps", _c.c_int32),  # of the world, 1 while it rests, as after the last step that took time; joints that swing freely may take more
        ("residual_m", _c.c_float),  # where bodies are now: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints that may give way (stiffness_hertz, force_max_N, torque_max_Nm) do not count
    ]


class cn_profile(_c.Structure):
    # Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.
    _fields_ = [
        ("step_s", _c.c_float),
        ("wake_s", _c.c_float),
        ("broadphase_s", _c.c_float),
        ("narrowphase_s", _c.c_float),
        ("islands_s", _c.c_float),
        ("prepare_s", _c.c_float),
        ("substeps_s", _c.c_float),
        ("finalize_s", _c.c_float),
        ("events_s", _c.c_float),
        ("sleep_s", _c.c_float),
    ]


class cn_memory_stats(_c.Structure):
    # Memory, in bytes. The frame arena is the stack allocator whose entries live within one step; the block
    # allocator serves small variable-size pieces from free lists of size classes.
    _fields_ = [
        ("bytes_in_use", _c.c_uint64),  # taken from the user's allocator or carved from the fixed block
        ("bytes_peak", _c.c_uint64),
        ("allocator_calls", _c.c_uint64),  # calls of the user's alloc (or of the fixed block's) since creation
        ("arena_capacity", _c.c_uint64),
        ("arena_peak", _c.c_uint64),  # most bytes in use at once since creation
        ("arena_fallbacks", _c.c_uint64),  # entries that did not fit and came from the allocator, since creation
        ("blocks_capacity", _c.c_uint64),  # bytes in chunks
        ("blocks_in_use", _c.c_uint64),
        ("blocks_large", _c.c_uint64),  # blocks above the largest class, served by the allocator
    ]


class cn_body_def(_c.Structure):
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("type", _c.c_int32),  # CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
        ("position_m", cn_vec2),  # of the origin; |x|, |y| <= 1e6 x length unit
        ("angle_rad", _c.c_float),  # |angle| <= 1e4
        ("linear_velocity_mps", cn_vec2),  # of the centre of mass; both velocities count only with CN_BODY_AWAKE: what sleeps does not move
        ("angular_velocity_radps", _c.c_float),
        ("linear_damping_per_s", _c.c_float),  # v' = -damping v; >= 0, default 0
        ("angular_damping_per_s", _c.c_float),
        ("gravity_scale", _c.c_float),  # default 1
        ("sleep_speed_mps", _c.c_float),  # >= 0; default 0: the world's
        ("flags", _c.c_uint32),  # CN_BODY_*; default ENABLED | SLEEP | AWAKE
        ("solver", _c.c_int32),  # as in cn_body_set_solver; default CN_SOLVER_AUTO
        ("user_data", _c.c_uint64),
        ("name", _c.c_char_p),  # NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
    ]


class cn_body_moved(_c.Structure):
    _fields_ = [
        ("pose", cn_pose),
        ("user_data", _c.c_uint64),
        ("body", cn_body),
        ("fell_asleep", _c.c_uint32),  # 1 in the step in which it fell asleep
    ]


class cn_filter(_c.Structure):
    # Two shapes collide when group is equal and not 0: positive yes, negative no; otherwise when each one's
    # category has a bit in the other's mask.
    _fields_ = [
        ("category", _c.c_uint64),  # default 1
        ("mask", _c.c_uint64),  # default all ones
        ("group", _c.c_int32),  # default 0
        ("reserved", _c.c_uint32),
    ]


class cn_material(_c.Structure):
    _fields_ = [
        ("static_friction", _c.c_float),  # coefficient while sticking, [0, 100], default 0.6
        ("dynamic_friction", _c.c_float),  # coefficient while sliding, [0, static_friction], default 0.6
        ("restitution", _c.c_float),  # [0, 1], default 0
        ("rolling_resistance", _c.c_float),  # metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0
        ("tangent_speed_mps", _c.c_float),  # conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; default 0
        ("friction_mix", _c.c_int32),  # CN_MIX_*
        ("restitution_mix", _c.c_int32),  # CN_MIX_*
        ("reserved", _c.c_uint32),
    ]


class cn_shape_def(_c.Structure):
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("body", cn_body),  # 0: create unattached, for cn_shape_attach
        ("offset_m", cn_vec2),  # of the shape in the body's local frame
        ("angle_rad", _c.c_float),
        ("density_kgpm2", _c.c_float),  # >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
        ("material", cn_material),
        ("filter", cn_filter),
        ("event_mask", _c.c_uint32),  # bit 1 << CN_EVENT_*; a pair reports what either shape asks for; default ENTER and LEAVE
        ("flags", _c.c_uint32),  # CN_SHAPE_SENSOR ...; default 0
        ("user_data", _c.c_uint64),
    ]


class cn_circle(_c.Structure):
    _fields_ = [
        ("center_m", cn_vec2),
        ("radius_m", _c.c_float),
    ]


class cn_capsule(_c.Structure):
    # All points within radius_m of the segment.
    _fields_ = [
        ("a_m", cn_vec2),
        ("b_m", cn_vec2),
        ("radius_m", _c.c_float),
    ]


class cn_edge(_c.Structure):
    # A two-sided segment without mass.
    _fields_ = [
        ("a_m", cn_vec2),
        ("b_m", cn_vec2),
    ]


class cn_polygon(_c.Structure):
    # Convex; counter-clockwise or clockwise in, always stored counter-clockwise.
    _fields_ = [
        ("count", _c.c_int32),  # 3 to CN_POLYGON_MAX_VERTICES
        ("radius_m", _c.c_float),  # rounding added outside of the points, >= 0
        ("points_m", cn_vec2 * 16),
    ]


class cn_chain(_c.Structure):
    # One-sided, massless ground without catches at its inner vertices. The solid side is on the left of the
    # direction of travel: surface normals point to the right of it, so ground whose points run from +x to -x
    # collides from above and a counter-clockwise loop collides from outside.
    _fields_ = [
        ("points_m", _c.POINTER(cn_vec2)),  # copied
        ("count", _c.c_int32),  # an open chain: >= 2; a loop: >= 3; at most 65535
        ("loop", _c.c_uint32),  # 1: the last point joins the first
    ]


class cn_manifold_point(_c.Structure):
    _fields_ = [
        ("point_m", cn_vec2),  # world, midway between the surfaces
        ("separation_m", _c.c_float),  # negative when overlapping
        ("normal_impulse_Ns", _c.c_float),  # of the last substep
        ("feature_id", _c.c_uint32),  # the same while the same features touch
    ]


class cn_manifold(_c.Structure):
    _fields_ = [
        ("normal", cn_vec2),  # unit, from shape a to shape b
        ("friction_impulse_Ns", _c.c_float),  # of the last substep, on body b along (normal.y, -normal.x)
        ("point_count", _c.c_int32),  # 0, 1 or 2
        ("points", cn_manifold_point * 2),
    ]


class cn_contact_event(_c.Structure):
    _fields_ = [
        ("shape_a", cn_shape),
        ("shape_b", cn_shape),
        ("body_a", cn_body),
        ("body_b", cn_body),
        ("child_a", _c.c_int32),  # edge number within a chain, else 0
        ("child_b", _c.c_int32),
        ("contact_id", _c.c_uint32),  # the same from CREATED to DESTROYED, then reused
        ("kind", _c.c_int32),  # CN_EVENT_*
        ("approach_speed_mps", _c.c_float),  # ENTER: closing speed along the normal before the impact; else 0
        ("manifold", cn_manifold),  # geometry as the step found it, impulses as it left them; points only for ENTER and STAY
    ]


class cn_sensor_event(_c.Structure):
    # A shape entered or left a sensor.
    _fields_ = [
        ("sensor", cn_shape),
        ("visitor", cn_shape),
        ("sensor_body", cn_body),
        ("visitor_body", cn_body),
        ("kind", _c.c_int32),  # CN_EVENT_ENTER or CN_EVENT_LEAVE
        ("reserved", _c.c_uint32),
    ]


class cn_joint_base(_c.Structure):
    # First field of every joint definition. A joint's rigid parts are what holds anchors, axes, angles,
    # lengths and limits in place; springs and motors are not.
    _fields_ = [
        ("struct_size", _c.c_uint32),  # of the whole definition
        ("flags", _c.c_uint32),  # CN_JOINT_*; default 0; a type ignores those it has no use for
        ("body_a", cn_body),  # 0: the world
        ("body_b", cn_body),  # 0: the world; one of the two must be dynamic
        ("anchor_a_m", cn_vec2),  # in body a's local frame, or in world coordinates
        ("anchor_b_m", cn_vec2),
        ("stiffness_hertz", _c.c_float),  # of the rigid parts, 0 to 1e6; 0 (default): as stiff as the substeps allow
        ("stiffness_damping_ratio", _c.c_float),  # used when stiffness_hertz > 0; 0 to 1e6
        ("force_max_N", _c.c_float),  # anchors and axes never pull harder, nor does a limit; 0 (default): no bound
        ("torque_max_Nm", _c.c_float),  # the same for angles
        ("break_force_N", _c.c_float),  # a reaction above this in any substep is reported (cn_world_joint_events); 0 (default): never
        ("break_torque_Nm", _c.c_float),
        ("user_data", _c.c_uint64),
    ]


class cn_revolute_def(_c.Structure):
    # Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].
    _fields_ = [
        ("base", cn_joint_base),
        ("reference_angle_rad", _c.c_float),
        ("lower_angle_rad", _c.c_float),  # CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
        ("upper_angle_rad", _c.c_float),
        ("motor_speed_radps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_torque_max_Nm", _c.c_float),  # >= 0
        ("spring_target_rad", _c.c_float),  # CN_JOINT_SPRING: pulls the joint angle to this
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
    ]


class cn_distance_def(_c.Structure):
    # Two points keep a distance. Without CN_JOINT_SPRING and without CN_JOINT_LIMIT it is a rigid rod of
    # length_m. With a spring, length_m is its rest length and the distance stays within [min, max] when
    # limits are on; limits alone make a rope (min 0).
    _fields_ = [
        ("base", cn_joint_base),
        ("length_m", _c.c_float),  # > 0; default 1
        ("length_min_m", _c.c_float),  # CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
        ("length_max_m", _c.c_float),
        ("motor_speed_mps", _c.c_float),  # CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
        ("motor_force_max_N", _c.c_float),  # >= 0
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
        ("reserved", _c.c_float),
    ]


class cn_fixed_def(_c.Structure):
    # Welded: no relative motion. base.stiffness_hertz makes it springy.
    _fields_ = [
        ("base", cn_joint_base),
        ("reference_angle_rad", _c.c_float),  # angle b - angle a
        ("angular_hertz", _c.c_float),  # stiffness of the angle alone, 0 to 1e6; 0: as the base's
        ("angular_damping_ratio", _c.c_float),  # 0 to 1e6
        ("reserved", _c.c_float),
    ]


class cn_prismatic_def(_c.Structure):
    # b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.
    _fields_ = [
        ("base", cn_joint_base),
        ("axis", cn_vec2),  # in body a's frame, any length > 0 (read back with length 1); default (1, 0)
        ("reference_angle_rad", _c.c_float),  # angle b - angle a
        ("lower_m", _c.c_float),  # CN_JOINT_LIMIT: lower <= upper
        ("upper_m", _c.c_float),
        ("motor_speed_mps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_force_max_N", _c.c_float),  # >= 0
        ("spring_target_m", _c.c_float),  # CN_JOINT_SPRING: pulls the translation to this
        ("spring_hertz", _c.c_float),  # 0 to 1e6
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6
    ]


class cn_wheel_def(_c.Structure):
    # A wheel b on suspension: slides along an axis fixed in a (springy, with limits), turns freely; the motor
    # turns it.
    _fields_ = [
        ("base", cn_joint_base),
        ("axis", cn_vec2),  # in body a's frame, any length > 0 (read back with length 1); default (0, 1)
        ("lower_m", _c.c_float),  # CN_JOINT_LIMIT: lower <= upper
        ("upper_m", _c.c_float),
        ("motor_speed_radps", _c.c_float),  # CN_JOINT_MOTOR
        ("motor_torque_max_Nm", _c.c_float),  # >= 0
        ("spring_hertz", _c.c_float),  # CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1
        ("spring_damping_ratio", _c.c_float),  # 0 to 1e6, default 0.7
    ]


class cn_motor_def(_c.Structure):
    # Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
    # base.torque_max_Nm must be > 0.
    _fields_ = [
        ("base", cn_joint_base),  # anchor b is driven to anchor a + offset
        ("offset_m", cn_vec2),  # in body a's frame
        ("angle_rad", _c.c_float),  # angle b - angle a
        ("hertz", _c.c_float),  # how briskly, > 0, to 1e6; default 5
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 1
        ("reserved", _c.c_float),
    ]


class cn_mouse_def(_c.Structure):
    # Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
    # base.force_max_N must be > 0.
    _fields_ = [
        ("base", cn_joint_base),
        ("target_m", cn_vec2),
        ("hertz", _c.c_float),  # > 0, to 1e6; default 5
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 0.7
    ]


class cn_gear_def(_c.Structure):
    # angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
    # and count whole turns from there.
    _fields_ = [
        ("base", cn_joint_base),
        ("ratio", _c.c_float),  # size 1e-4 to 1e4, negative: they turn against each other; default 1
        ("phase_rad", _c.c_float),
    ]


class cn_pulley_def(_c.Structure):
    # |anchor a - ground a| + ratio |anchor b - ground b| <= length: a rope over two pulleys (never pushes).
    _fields_ = [
        ("base", cn_joint_base),
        ("ground_a_m", cn_vec2),  # world
        ("ground_b_m", cn_vec2),
        ("ratio", _c.c_float),  # 1e-4 to 1e4; default 1
        ("length_m", _c.c_float),  # > 0
    ]


class cn_ratchet_def(_c.Structure):
    # b may turn against a in one direction only, and back no farther than to the last click that it passed.
    # Clicks are at phase + any whole number of click_rad, over whole turns.
    _fields_ = [
        ("base", cn_joint_base),
        ("phase_rad", _c.c_float),
        ("click_rad", _c.c_float),  # size 1e-4 to 1e4; positive: b may turn counter-clockwise
    ]


class cn_rotary_spring_def(_c.Structure):
    # A torque that pulls angle b - angle a to rest, over whole turns. hertz is that of the two bodies' own
    # inertia.
    _fields_ = [
        ("base", cn_joint_base),
        ("rest_angle_rad", _c.c_float),
        ("hertz", _c.c_float),  # > 0, to 1e6; default 1
        ("damping_ratio", _c.c_float),  # 0 to 1e6, default 0
        ("reserved", _c.c_float),
    ]


class cn_groove_def(_c.Structure):
    # anchor b slides in a slot of body a from anchor a to end.
    _fields_ = [
        ("base", cn_joint_base),
        ("end_m", cn_vec2),  # in body a's frame; not equal to anchor a; default (1, 0)
    ]


class cn_filter_joint_def(_c.Structure):
    # Nothing but: the two bodies do not collide.
    _fields_ = [
        ("base", cn_joint_base),
    ]


class cn_joint_event(_c.Structure):
    # Something happened to a joint or to a constraint on one body.
    _fields_ = [
        ("joint", cn_joint),  # 0: it was a constraint; stale when destroyed is 1
        ("constraint", cn_constraint),  # 0: it was a joint; stale when destroyed is 1
        ("body_a", cn_body),  # 0: the world
        ("body_b", cn_body),
        ("force_N", _c.c_float),  # largest reaction of the step; 0 when a body was destroyed
        ("torque_Nm", _c.c_float),
        ("destroyed", _c.c_uint32),  # 1: it is gone (it breaks, or a body of it was destroyed)
        ("reserved", _c.c_uint32),
        ("user_data", _c.c_uint64),
    ]


class cn_angle_constraint_def(_c.Structure):
    # Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns
    # from there.
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("flags", _c.c_uint32),  # CN_CONSTRAINT_*; default 0
        ("body", cn_body),  # must be dynamic
        ("lower_rad", _c.c_float),  # lower <= upper; equal: locked
        ("upper_rad", _c.c_float),
        ("hertz", _c.c_float),  # 0 (default): rigid; to 1e6
        ("damping_ratio", _c.c_float),  # used when hertz > 0; 0 to 1e6
        ("break_torque_Nm", _c.c_float),  # a reaction above this is reported (cn_world_joint_events); 0: never
        ("user_data", _c.c_uint64),
    ]


class cn_line_constraint_def(_c.Structure):
    # Keeps a point of a body on a line in the world, within a tolerance to either side, and between limits
    # along it.
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("flags", _c.c_uint32),  # CN_CONSTRAINT_*; default 0
        ("body", cn_body),  # must be dynamic
        ("anchor_m", cn_vec2),  # in the body's frame
        ("origin_m", cn_vec2),  # of the line, world
        ("axis", cn_vec2),  # world, any length > 0 (read back with length 1); default (1, 0)
        ("tolerance_m", _c.c_float),  # >= 0: free play across the axis
        ("lower_m", _c.c_float),  # CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper
        ("upper_m", _c.c_float),
        ("hertz", _c.c_float),  # 0 (default): rigid; to 1e6
        ("damping_ratio", _c.c_float),  # used when hertz > 0; 0 to 1e6
        ("break_force_N", _c.c_float),  # a reaction above this is reported (cn_world_joint_events); 0: never
        ("reserved", _c.c_uint32),
        ("user_data", _c.c_uint64),
    ]


class cn_update_report(_c.Structure):
    _fields_ = [
        ("steps", _c.c_int32),  # fixed steps taken
        ("leftover_s", _c.c_float),  # time kept for the next update
        ("dropped_s", _c.c_float),  # time given up because of the step cap
        ("interpolation", _c.c_float),  # leftover / fixed step, [0, 1): between the last two poses
    ]


class cn_ray(_c.Structure):
    _fields_ = [
        ("origin_m", cn_vec2),
        ("translation_m", cn_vec2),  # may be 0: then only shapes around the origin are hit; at most 2e6 length units each way
    ]


class cn_ray_hit(_c.Structure):
    # What a ray or a moved shape meets. One that starts in contact, overlapping or just touching, meets that
    # shape at fraction 0, with the shortest way out: depth_m along the normal. It does not meet what it
    # touches, up to a depth of 0.5% of the length unit, when its translation does not lead in: along the
    # surface or away from it.
    _fields_ = [
        ("shape", cn_shape),  # 0: nothing was hit
        ("body", cn_body),
        ("child", _c.c_int32),  # edge of a chain
        ("fraction", _c.c_float),  # of the translation, [0, 1]; 1 when nothing was hit
        ("point_m", cn_vec2),  # on the surface of the shape that was hit
        ("normal", cn_vec2),  # unit, out of the shape that was hit
        ("depth_m", _c.c_float),  # how deep the start is in it, 0 when it is outside
        ("reserved", _c.c_uint32),
    ]


# Asked by a query for each shape (edge of a chain) that it would find, in no particular order and perhaps
# more than once: the answer must depend on the shape alone. hit is what is known of it: all of it in casts,
# else shape, body and child. Returns CN_QUERY_*. May call functions that take a const world, of the same
# world too, and no others.
cn_query_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), _c.POINTER(cn_ray_hit), _c.c_void_p)


class cn_query_filter(_c.Structure):
    # A query sees shapes of enabled bodies whose category has a bit in mask and whose mask has one in
    # category, and of sensors only those with CN_SHAPE_SENSOR_SEEN. Bodies are seen where they are now, also
    # between steps.
    _fields_ = [
        ("category", _c.c_uint64),  # default 1
        ("mask", _c.c_uint64),  # default all ones
        ("ignored_body", cn_body),  # its shapes are not seen; 0 (default): none. A stale handle is an error
        ("flags", _c.c_uint32),  # CN_QUERY_IGNORE_JOINED ...; default 0
        ("visit", cn_query_fn),  # NULL (default): all are taken
        ("user", _c.c_void_p),
    ]


class cn_closest(_c.Structure):
    _fields_ = [
        ("shape", cn_shape),  # 0: nothing within the distance
        ("body", cn_body),
        ("child", _c.c_int32),
        ("distance_m", _c.c_float),  # negative: depth inside a shape with area
        ("point_m", cn_vec2),  # on the surface
        ("normal", cn_vec2),  # outward there; of edges and chains towards the point
    ]


class cn_distance(_c.Structure):
    _fields_ = [
        ("point_a_m", cn_vec2),  # on the surface of a, in the world
        ("point_b_m", cn_vec2),
        ("normal", cn_vec2),  # unit, from a to b
        ("distance_m", _c.c_float),  # of the surfaces; negative: the depth, the shortest way that moves b out of a
        ("reserved", _c.c_uint32),
    ]


class cn_sweep(_c.Structure):
    # A motion from fraction 0 to 1: a point of the shape goes in a straight line, and the shape turns evenly
    # about it.
    _fields_ = [
        ("start", cn_pose),
        ("center_m", cn_vec2),  # that point, in the shape's frame: the centre of mass of a body
        ("translation_m", cn_vec2),  # of it; at most 2e6 m each way
        ("turn_rad", _c.c_float),  # counter-clockwise, |turn| <= 1e4
        ("reserved", _c.c_uint32),
    ]


class cn_impact(_c.Structure):
    _fields_ = [
        ("state", _c.c_int32),  # CN_IMPACT_*
        ("fraction", _c.c_float),
        ("point_m", cn_vec2),  # HIT only, as are the next two: between the surfaces
        ("normal", cn_vec2),  # unit, from a to b
        ("distance_m", _c.c_float),  # of the surfaces at fraction, from distance_m to 0.1 mm (or what floats can tell) above
        ("reserved", _c.c_uint32),
    ]


class cn_plane(_c.Structure):
    # A surface that bounds where a shape may move: after a translation t of the shape, separation_m + normal
    # . t is >= 0, unless that takes more than push_max_m.
    _fields_ = [
        ("normal", cn_vec2),  # unit, from the surface to the shape
        ("point_m", cn_vec2),  # where they are nearest, in the world
        ("separation_m", _c.c_float),  # of the surfaces along the normal; negative: they overlap
        ("push_max_m", _c.c_float),  # >= 0: the farthest that this plane pushes; FLT_MAX: rigid
        ("push_m", _c.c_float),  # of the last cn_mover_solve: how far it pushed
        ("shape", cn_shape),
        ("body", cn_body),
        ("child", _c.c_int32),  # edge of a chain
    ]


class cn_mover_def(_c.Structure):
    # How a character moves. The same for every move, or changed from move to move: crouching is another
    # shape.
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("flags", _c.c_uint32),  # CN_MOVER_DROP; default 0
        ("shape", cn_polygon),  # around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
        ("filter", cn_query_filter),  # what it collides with; sensors never, one-way shapes from above
        ("up", cn_vec2),  # any length > 0; default (0, 1)
        ("slope_limit_rad", _c.c_float),  # steeper ground cannot be stood on or walked up, 0 to pi / 2; default 0.87 (50 degrees)
        ("step_height_m", _c.c_float),  # climbs steps up to this high while it walks, >= 0; default 0.3
        ("snap_m", _c.c_float),  # walking, keeps to ground that falls away by up to this in a move, >= 0; default 0.3
        ("gravity_scale", _c.c_float),  # of the world's gravity in the air; default 1
        ("push_force_N", _c.c_float),  # the most it pushes a dynamic body with, >= 0; default 200
        ("iterations_max", _c.c_int32),  # of sliding, 1 to 64; default 8
    ]


class cn_mover(_c.Structure):
    # A character between two moves. It belongs to the caller, who may copy it, keep it and go back to it: the
    # world knows nothing of it, and other bodies do not collide with it: for that give it a kinematic body
    # that is filter.ignored_body and follows by cn_body_set_target_pose. Begin with all 0 but the position.
    _fields_ = [
        ("position_m", cn_vec2),
        ("velocity_mps", cn_vec2),  # in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its component across up; the one along up is 0, and a jump when the caller makes it > 0
        ("ground_normal", cn_vec2),  # of what it stands on, with CN_MOVER_ON_GROUND; else (0, 0)
        ("ground_point_m", cn_vec2),  # in the world, after the move
        ("ground_local_m", cn_vec2),  # ... in the frame of ground_body
        ("ground_velocity_mps", cn_vec2),  # of the ground there
        ("ground_body", cn_body),  # 0: none; may become stale, which is as none
        ("ground_shape", cn_shape),
        ("flags", _c.c_uint32),  # CN_MOVER_ON_*, after the last move
        ("squeezed_m", _c.c_float),  # by how much it overlaps what left it no room; 0 but for rounding
    ]


class cn_explosion_def(_c.Structure):
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("radius_m", _c.c_float),  # full strength within, to the nearest point of a shape; >= 0, default 1
        ("falloff_m", _c.c_float),  # then linearly to none over this distance; >= 0
        ("impulse_Nspm", _c.c_float),  # per metre of the shape's width seen from the centre; negative pulls
        ("center_m", cn_vec2),
        ("filter", cn_query_filter),
    ]


cn_debug_draw_polygon_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_int32, _c.c_float, _c.c_uint32, _c.c_void_p)


cn_debug_draw_circle_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_float, _c.POINTER(cn_vec2), _c.c_uint32, _c.c_void_p)


cn_debug_draw_capsule_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2), _c.c_float, _c.c_uint32, _c.c_void_p)


cn_debug_draw_segment_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2), _c.c_uint32, _c.c_void_p)


cn_debug_draw_point_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_float, _c.c_uint32, _c.c_void_p)


cn_debug_draw_text_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_vec2), _c.c_char_p, _c.c_uint32, _c.c_void_p)


class cn_debug_draw(_c.Structure):
    # Functions that are NULL are not called. Colours are 0xRRGGBB. Points are in world coordinates.
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("flags", _c.c_uint32),  # CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
        ("view", cn_aabb),  # only what overlaps it is drawn; default everything
        ("polygon", cn_debug_draw_polygon_fn),
        ("circle", cn_debug_draw_circle_fn),  # axis: a point on the rim that turns with the body
        ("capsule", cn_debug_draw_capsule_fn),
        ("segment", cn_debug_draw_segment_fn),
        ("point", cn_debug_draw_point_fn),
        ("text", cn_debug_draw_text_fn),
        ("user", _c.c_void_p),
        ("reserved", _c.c_void_p),
    ]


# Called at the end of cn_world_step for each event of this kind, in the order of the array.
cn_contact_event_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_world), _c.POINTER(cn_contact_event), _c.c_void_p)


# Decides whether two shapes that pass their filters may touch: 1 yes, 0 no. Asked when their boxes begin to
# overlap. The world is locked.
cn_filter_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), cn_shape, cn_shape, _c.c_void_p)


# Asked in every step for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE, before solving: 0 makes
# the pair pass through each other in this step. Event kind is STAY or ENTER.
cn_pre_solve_fn = _c.CFUNCTYPE(_c.c_int32, _c.POINTER(cn_world), _c.POINTER(cn_contact_event), _c.c_void_p)


# Mixes two materials in place of the CN_MIX_ rules: fills *mixed, which holds what the rules gave. Asked when
# a pair begins to touch and when a material changes.
cn_material_mix_fn = _c.CFUNCTYPE(None, _c.POINTER(cn_world), cn_shape, cn_shape, _c.POINTER(cn_material), _c.c_void_p)


# Return 0 to stop, anything else to go on.
cn_tree_query_fn = _c.CFUNCTYPE(_c.c_int32, _c.c_uint32, _c.c_uint64, _c.c_void_p)


# Return the fraction to go on with: the given one to ignore the item, 0 to stop.
cn_tree_ray_fn = _c.CFUNCTYPE(_c.c_float, _c.c_uint32, _c.c_uint64, _c.c_float, _c.c_void_p)


# Version as major * 1000000 + minor * 1000 + patch.
cn_version = _function("cn_version", _c.c_int32)
# CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
cn_abi_version = _function("cn_abi_version", _c.c_int32)
# Static English text for a result code, never NULL.
cn_result_text = _function("cn_result_text", _c.c_char_p, cn_result)
# sizeof the struct named by a CN_TYPE_ constant, 0 for an unknown one: bindings check themselves.
cn_sizeof = _function("cn_sizeof", _c.c_int32, _c.c_int32)
# Defaults as given beside the fields (those that scale with the length unit are stored as 0 and resolved by
# cn_world_create: 0 means the default there).
cn_world_def_init = _function("cn_world_def_init", None, _c.POINTER(cn_world_def))
# Says in one sentence what is wrong with a definition; writes at most text_bytes bytes including the
# terminating zero; text may be NULL when text_bytes is 0.
cn_world_def_check = _function("cn_world_def_check", cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.c_char), _c.c_int32)
# Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL here.
cn_world_bytes_needed = _function("cn_world_bytes_needed", cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.c_uint64))
# Threads that cannot be started are CN_ERROR_MEMORY. A world's memory holds some 150 bytes for each; their
# stacks, and whatever else a thread needs, are the system's, for a world in a caller's block too. A library
# built with CN_NO_THREADS, or on a system whose threads it does not know, makes the same world without them:
# see cn_world_get_worker_count.
cn_world_create = _function("cn_world_create", cn_result, _c.POINTER(cn_world_def), _c.POINTER(_c.POINTER(cn_world)))
# NULL is allowed. Frees everything; a world in a caller's block just stops using it. Its own threads have
# ended when this returns. Not from callbacks.
cn_world_destroy = _function("cn_world_destroy", None, _c.POINTER(cn_world))
# One fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion, and so does
# less than 1e-9. Cost grows with the number of awake bodies and their contacts.
cn_world_step = _function("cn_world_step", cn_result, _c.POINTER(cn_world), _c.c_float)
# One sentence on the last call that failed on this world; "" if none did. world may be NULL.
cn_world_error_text = _function("cn_world_error_text", _c.c_char_p, _c.POINTER(cn_world))
# A change wakes every body: O(bodies) then.
cn_world_set_gravity = _function("cn_world_set_gravity", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float)
cn_world_get_gravity = _function("cn_world_get_gravity", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_vec2))
# 1 to 64; more substeps are stiffer and dearer.
cn_world_set_substep_count = _function("cn_world_set_substep_count", cn_result, _c.POINTER(cn_world), _c.c_int32)
cn_world_get_substep_count = _function("cn_world_get_substep_count", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32))
# CN_SOLVER_*, from the next step on. A world in a caller's block has scratch memory for the solver that it
# was made with: a dearer one may have to do without direct solving there (CN_WARNING_FRAME_MEMORY).
cn_world_set_solver = _function("cn_world_set_solver", cn_result, _c.POINTER(cn_world), _c.c_int32)
cn_world_get_solver = _function("cn_world_get_solver", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32))
# Both as in cn_world_def; 0 metres: the default. get gives the accuracy in metres that this stands for.
cn_world_set_accuracy = _function("cn_world_set_accuracy", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_int32)
cn_world_get_accuracy = _function("cn_world_get_accuracy", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_float), _c.POINTER(_c.c_int32))
# Workers that a step may have: 1, or worker_count where the library can have several.
cn_world_get_worker_count = _function("cn_world_get_worker_count", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_int32))
# Replaces the CN_WORLD_ flags. Turning CN_WORLD_SLEEP off wakes everything: O(bodies) then.
cn_world_set_flags = _function("cn_world_set_flags", cn_result, _c.POINTER(cn_world), _c.c_uint32)
cn_world_get_flags = _function("cn_world_get_flags", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint32))
# Metres a second, >= 0.
cn_world_set_restitution_threshold = _function("cn_world_set_restitution_threshold", cn_result, _c.POINTER(cn_world), _c.c_float)
# Both > 0: bodies are slowed to these at the end of each step (direction kept).
cn_world_set_speed_limits = _function("cn_world_set_speed_limits", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float)
# speed_mps >= 0, delay_s >= 0.
cn_world_set_sleep = _function("cn_world_set_sleep", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float)
cn_world_set_user_data = _function("cn_world_set_user_data", cn_result, _c.POINTER(cn_world), _c.c_uint64)
cn_world_get_user_data = _function("cn_world_get_user_data", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64))
# Handles of everything alive, in a fixed order (by slot). Writes at most capacity of them (out may be NULL
# when capacity is 0) and always sets *out_count to how many there are. O(slots).
cn_world_get_bodies = _function("cn_world_get_bodies", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_get_shapes = _function("cn_world_get_shapes", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_get_joints = _function("cn_world_get_joints", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_joint), _c.c_int32, _c.POINTER(_c.c_int32))
# O(bodies + islands).
cn_world_get_counters = _function("cn_world_get_counters", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_counters))
# Of every awake island, as cn_counters.islands_awake counts them: those of several bodies first, in a
# deterministic order, then bodies alone. Writes at most capacity; *out_count is how many there are. Costs
# nothing when it is not called. O(bodies + what touches in the islands written).
cn_world_get_islands = _function("cn_world_get_islands", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_island_report), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_get_profile = _function("cn_world_get_profile", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_profile))
cn_world_get_memory_stats = _function("cn_world_get_memory_stats", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_memory_stats))
# 64-bit hash (FNV-1a, Fowler/Noll/Vo) of every body's pose, velocity and sleep state and every contact's
# impulses in handle order: equal for equal histories on every compiler, CPU and thread count. O(bodies +
# contacts).
cn_world_hash = _function("cn_world_hash", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64))
# Checks every invariant between the tables. CN_OK, or CN_ERROR_INTERNAL with a sentence in text (at most
# text_bytes bytes with the zero; may be NULL when text_bytes is 0). O(everything).
cn_world_validate = _function("cn_world_validate", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_char), _c.c_int32)
# Bytes that cn_world_save needs now. From callbacks CN_ERROR_LOCKED. O(slots).
cn_world_save_size = _function("cn_world_save_size", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.c_uint64))
# Writes the state to out, which may have any alignment, and how many bytes that took to out_bytes (may be
# NULL). capacity: bytes that out has; too few are CN_ERROR_CAPACITY. From callbacks CN_ERROR_LOCKED. O(memory
# of the world), about 1 KB a body.
cn_world_save = _function("cn_world_save", cn_result, _c.POINTER(cn_world), _c.c_void_p, _c.c_uint64, _c.POINTER(_c.c_uint64))
# Puts a state back: into the world that was saved, or one that was made by the same definition (broadphase,
# length unit, whether it lives in a caller's block; else CN_ERROR_STATE). bytes: as many as cn_world_save
# wrote. CN_ERROR_FORMAT: not a save of this version and machine, or damaged. CN_ERROR_MEMORY: no room for
# what was alive then; a growing world takes what it needs, a world in a caller's block has room for what it
# had. Arrays handed out before are void. O(memory of the world). Handles of what was alive when the world was
# saved are valid again, also of what was destroyed since. Those made since are refused, until the same handle
# is given to something new: with the same calls to the same thing. A game rolls its own state back with the
# world, and so keeps none of them.
cn_world_restore = _function("cn_world_restore", cn_result, _c.POINTER(cn_world), _c.c_void_p, _c.c_uint64)
cn_body_def_init = _function("cn_body_def_init", None, _c.POINTER(cn_body_def))
cn_body_create = _function("cn_body_create", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body_def), _c.POINTER(cn_body))
# count bodies from an array of definitions; all of them or none. O(count).
cn_body_create_many = _function("cn_body_create_many", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body_def), _c.c_int32, _c.POINTER(cn_body))
# Also destroys its shapes, contacts, joints and constraints; touching contacts get their leave event, joints
# and constraints theirs (cn_world_joint_events).
cn_body_destroy = _function("cn_body_destroy", cn_result, _c.POINTER(cn_world), cn_body)
# Destroys all or, if any handle is bad or appears twice, none.
cn_body_destroy_many = _function("cn_body_destroy_many", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32)
# 1 if the handle names a body that is alive in this world, else 0 (also for a NULL world).
cn_body_is_valid = _function("cn_body_is_valid", _c.c_int32, _c.POINTER(cn_world), cn_body)
# Changing the type ends the body's contacts (those that still overlap begin again in the next step), its
# forces and any mass override, and wakes it; a body made static stops. CN_ERROR_STATE if a joint would be
# left without a dynamic body. O(contacts + joints + shapes).
cn_body_set_type = _function("cn_body_set_type", cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32)
cn_body_get_type = _function("cn_body_get_type", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_int32))
# Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which is cn_body_set_awake's and is ignored here. A body
# without CN_BODY_ENABLED keeps its shapes but collides with nothing and does not move; its contacts end, its
# joints rest. O(contacts + joints + shapes) when that changes.
cn_body_set_flags = _function("cn_body_set_flags", cn_result, _c.POINTER(cn_world), cn_body, _c.c_uint32)
# CN_BODY_AWAKE is set in the result when the body is awake.
cn_body_get_flags = _function("cn_body_get_flags", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_uint32))
# 0 puts the body and everything connected to it to sleep, at rest; anything else wakes. Does nothing to
# static and disabled bodies. O(island).
cn_body_set_awake = _function("cn_body_set_awake", cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32)
# Teleport: origin and angle; velocities stay. Contacts that are no longer near end (the next step reports
# it). Wakes the body and what is near it. O(contacts + shapes).
cn_body_set_pose = _function("cn_body_set_pose", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float)
cn_body_get_pose = _function("cn_body_get_pose", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_pose))
# In (-pi, pi].
cn_body_get_angle = _function("cn_body_get_angle", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float))
# World position of the centre of mass.
cn_body_get_center = _function("cn_body_get_center", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_vec2))
# Static bodies refuse this with CN_ERROR_STATE. Wakes when not zero.
cn_body_set_velocity = _function("cn_body_set_velocity", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float)
cn_body_get_velocity = _function("cn_body_get_velocity", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_velocity))
# Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes it
# to this pose, the shorter way round, up to rounding and the world's speed limits: what stands on it or is in
# its way moves along, as nothing does with cn_body_set_pose. It goes on with that velocity: call it before
# every step, or stop it after.
cn_body_set_target_pose = _function("cn_body_set_target_pose", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float)
# Velocity of the body's material at a world point.
cn_body_get_velocity_at = _function("cn_body_get_velocity_at", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2))
cn_body_get_world_point = _function("cn_body_get_world_point", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2))
cn_body_get_local_point = _function("cn_body_get_local_point", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.POINTER(cn_vec2))
# Union of its shapes' boxes, without margin; the origin as a point if it has none. O(shapes).
cn_body_get_aabb = _function("cn_body_get_aabb", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_aabb))
# Forces and torques act for the next step only and are then cleared. All of these wake a dynamic body and do
# nothing to static, kinematic and disabled ones (CN_OK). Sums of forces and velocities after impulses must
# stay finite (CN_ERROR_ARGUMENT).
cn_body_apply_force = _function("cn_body_apply_force", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float)
cn_body_apply_force_at = _function("cn_body_apply_force_at", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float)
cn_body_apply_torque = _function("cn_body_apply_torque", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float)
cn_body_apply_impulse = _function("cn_body_apply_impulse", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float)
cn_body_apply_impulse_at = _function("cn_body_apply_impulse_at", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float, _c.c_float, _c.c_float)
cn_body_apply_angular_impulse = _function("cn_body_apply_angular_impulse", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float)
# Sums over the attached shapes unless overridden. A dynamic body whose shapes have no mass weighs 1 kg (and,
# having no shape, does not rotate).
cn_body_get_mass_data = _function("cn_body_get_mass_data", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_mass_data))
# Override for a dynamic body (others: CN_ERROR_STATE): mass_kg from 1e-20 to 1e20, inertia_kgm2 0 (never
# rotates) or from 1e-35 to 1e35. Kept until cn_body_reset_mass_data or until the type changes.
cn_body_set_mass_data = _function("cn_body_set_mass_data", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_mass_data))
cn_body_reset_mass_data = _function("cn_body_reset_mass_data", cn_result, _c.POINTER(cn_world), cn_body)
# Both >= 0.
cn_body_set_damping = _function("cn_body_set_damping", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float, _c.c_float)
cn_body_get_damping = _function("cn_body_get_damping", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float))
cn_body_set_gravity_scale = _function("cn_body_set_gravity_scale", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float)
cn_body_get_gravity_scale = _function("cn_body_get_gravity_scale", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_float))
# >= 0; 0 restores the world's.
cn_body_set_sleep_speed = _function("cn_body_set_sleep_speed", cn_result, _c.POINTER(cn_world), cn_body, _c.c_float)
# How the island of a dynamic body is solved, in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
# (default): as the world chooses. _SOFT: never directly, contacts and all, whatever its other bodies ask for.
# _DIRECT: always, however fast it moves, as far as its contacts can be, and within the work_budget. From the
# next step on; does not wake.
cn_body_set_solver = _function("cn_body_set_solver", cn_result, _c.POINTER(cn_world), cn_body, _c.c_int32)
cn_body_get_solver = _function("cn_body_get_solver", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_int32))
cn_body_set_user_data = _function("cn_body_set_user_data", cn_result, _c.POINTER(cn_world), cn_body, _c.c_uint64)
cn_body_get_user_data = _function("cn_body_get_user_data", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_uint64))
# NULL or "" removes the name.
cn_body_set_name = _function("cn_body_set_name", cn_result, _c.POINTER(cn_world), cn_body, _c.c_char_p)
# "" if it has none; valid until the name changes or the body is destroyed.
cn_body_get_name = _function("cn_body_get_name", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(_c.c_char_p))
# As cn_world_get_bodies, for one body. O(shapes), O(joints).
cn_body_get_shapes = _function("cn_body_get_shapes", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
cn_body_get_joints = _function("cn_body_get_joints", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_joint), _c.c_int32, _c.POINTER(_c.c_int32))
# Bulk forms: bodies NULL means every body in the order of cn_world_get_bodies, of which there must be exactly
# count. stride_bytes 0 means tightly packed. One bad handle fails the whole call. O(count).
cn_world_read_poses = _function("cn_world_read_poses", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_pose))
cn_world_read_poses_strided = _function("cn_world_read_poses_strided", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.c_void_p, _c.c_int32)
cn_world_read_velocities = _function("cn_world_read_velocities", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_velocity))
# cn_body_set_velocity for many; nothing is written if one is bad. Static bodies take zero only.
cn_world_write_velocities = _function("cn_world_write_velocities", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.POINTER(cn_velocity))
# Bodies whose pose changed in the last step, and those that fell asleep in it, without the ones destroyed
# since. Built on the first call after a step: O(awake bodies) then.
cn_world_moved = _function("cn_world_moved", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_body_moved)), _c.POINTER(_c.c_int32))
cn_shape_def_init = _function("cn_shape_def_init", None, _c.POINTER(cn_shape_def))
# out_shape may be NULL in all of these. Points closer than 0.05% of the length unit are degenerate.
cn_shape_create_circle = _function("cn_shape_create_circle", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_circle), _c.POINTER(cn_shape))
cn_shape_create_capsule = _function("cn_shape_create_capsule", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_capsule), _c.POINTER(cn_shape))
cn_shape_create_edge = _function("cn_shape_create_edge", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_edge), _c.POINTER(cn_shape))
cn_shape_create_polygon = _function("cn_shape_create_polygon", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_polygon), _c.POINTER(cn_shape))
# Half sizes > 0; radius_m >= 0 is added outside of them.
cn_shape_create_box = _function("cn_shape_create_box", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_shape))
# O(count).
cn_shape_create_chain = _function("cn_shape_create_chain", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_shape_def), _c.POINTER(cn_chain), _c.POINTER(cn_shape))
# An unattached shape joins a body (CN_ERROR_STATE if it already has one), an attached one leaves it.
cn_shape_attach = _function("cn_shape_attach", cn_result, _c.POINTER(cn_world), cn_shape, cn_body)
cn_shape_detach = _function("cn_shape_detach", cn_result, _c.POINTER(cn_world), cn_shape)
cn_shape_destroy = _function("cn_shape_destroy", cn_result, _c.POINTER(cn_world), cn_shape)
cn_shape_is_valid = _function("cn_shape_is_valid", _c.c_int32, _c.POINTER(cn_world), cn_shape)
cn_shape_get_type = _function("cn_shape_get_type", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_int32))
# 0 if unattached.
cn_shape_get_body = _function("cn_shape_get_body", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_body))
# Takes effect at once, on resting contacts too (their bodies wake).
cn_shape_set_material = _function("cn_shape_set_material", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_material))
cn_shape_get_material = _function("cn_shape_get_material", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_material))
# >= 0; the body's mass follows at once.
cn_shape_set_density = _function("cn_shape_set_density", cn_result, _c.POINTER(cn_world), cn_shape, _c.c_float)
cn_shape_get_density = _function("cn_shape_get_density", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_float))
# Contacts that it forbids end at once (with their events); ones that it allows begin in the next step.
cn_shape_set_filter = _function("cn_shape_set_filter", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_filter))
cn_shape_get_filter = _function("cn_shape_get_filter", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_filter))
# Takes effect at once, for present contacts too.
cn_shape_set_event_mask = _function("cn_shape_set_event_mask", cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint32)
cn_shape_get_event_mask = _function("cn_shape_get_event_mask", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint32))
# Replaces the CN_SHAPE_ flags (SENSOR ...). Contacts end and begin anew as needed.
cn_shape_set_flags = _function("cn_shape_set_flags", cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint32)
cn_shape_get_flags = _function("cn_shape_get_flags", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint32))
cn_shape_set_user_data = _function("cn_shape_set_user_data", cn_result, _c.POINTER(cn_world), cn_shape, _c.c_uint64)
cn_shape_get_user_data = _function("cn_shape_get_user_data", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(_c.c_uint64))
# Without margin, in world space (in shape space when unattached). O(points).
cn_shape_get_aabb = _function("cn_shape_get_aabb", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_aabb))
# In the body's local frame, at the present density; inertia about the shape's own centre. O(points).
cn_shape_get_mass_data = _function("cn_shape_get_mass_data", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_mass_data))
# The shape's geometry in its body's local frame, offset applied. CN_ERROR_STATE for another type.
cn_shape_get_circle = _function("cn_shape_get_circle", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_circle))
cn_shape_get_capsule = _function("cn_shape_get_capsule", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_capsule))
cn_shape_get_edge = _function("cn_shape_get_edge", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_edge))
cn_shape_get_polygon = _function("cn_shape_get_polygon", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_polygon))
# Writes at most capacity points (out may be NULL when capacity is 0); *out_count is how many there are.
cn_shape_get_chain_points = _function("cn_shape_get_chain_points", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_vec2), _c.c_int32, _c.POINTER(_c.c_int32))
cn_shape_test_point = _function("cn_shape_test_point", cn_result, _c.POINTER(cn_world), cn_shape, _c.c_float, _c.c_float, _c.POINTER(_c.c_int32))
# Convex hull of 1 or more points (farthest points inserted, as in Quickhull: Barber, Dobkin, Huhdanpaa 1996)
# of at most CN_POLYGON_MAX_VERTICES, those that add the most area. CN_ERROR_ARGUMENT for fewer than three
# distinct points or collinear ones. Details below 5 mm are dropped (below 5% of the half size for hulls under
# 0.1 m, below 0.5% for those over 1 m). O(count^2) at worst, count <= 65536.
cn_polygon_make_hull = _function("cn_polygon_make_hull", cn_result, _c.POINTER(cn_vec2), _c.c_int32, _c.c_float, _c.POINTER(cn_polygon))
# A box of half sizes > 0, moved and then turned about its own centre.
cn_polygon_make_box = _function("cn_polygon_make_box", cn_result, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_polygon))
# The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. They are always
# bookended: every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved away, body
# or shape destroyed, detached or disabled, filter or type changed). Pairs that end through a call between two
# steps are reported by the next step; handles in such events may be stale. Falling asleep is not leaving: a
# sleeping pair reports nothing until it wakes, and then goes on where it was. The array is built on the first
# request after a step, O(events) then: that may return CN_ERROR_MEMORY, and inside callbacks CN_ERROR_LOCKED.
cn_world_contact_events = _function("cn_world_contact_events", cn_result, _c.POINTER(cn_world), _c.c_int32, _c.POINTER(_c.POINTER(cn_contact_event)), _c.POINTER(_c.c_int32))
# function NULL removes it.
cn_world_set_contact_callback = _function("cn_world_set_contact_callback", cn_result, _c.POINTER(cn_world), _c.c_int32, cn_contact_event_fn, _c.c_void_p)
# function NULL removes it.
cn_world_set_filter_callback = _function("cn_world_set_filter_callback", cn_result, _c.POINTER(cn_world), cn_filter_fn, _c.c_void_p)
cn_world_set_pre_solve_callback = _function("cn_world_set_pre_solve_callback", cn_result, _c.POINTER(cn_world), cn_pre_solve_fn, _c.c_void_p)
cn_world_set_material_mix_callback = _function("cn_world_set_material_mix_callback", cn_result, _c.POINTER(cn_world), cn_material_mix_fn, _c.c_void_p)
# Of the last step, in a deterministic order; bookended like contact events. Sensors see dynamic and kinematic
# bodies' shapes that are not sensors, by exact overlap.
cn_world_sensor_events = _function("cn_world_sensor_events", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_sensor_event)), _c.POINTER(_c.c_int32))
# The contacts of a body, touching or not, as events of kind STAY (touching) or CREATED. Writes at most
# capacity; *out_count is how many there are. O(contacts).
cn_body_get_contacts = _function("cn_body_get_contacts", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_contact_event), _c.c_int32, _c.POINTER(_c.c_int32))
# As cn_body_get_contacts, of one shape, a chain with all its edges. O(contacts of its body).
cn_shape_get_contacts = _function("cn_shape_get_contacts", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_contact_event), _c.c_int32, _c.POINTER(_c.c_int32))
# The shapes that are in a sensor, each once: those whose ENTER had no LEAVE up to the last step.
# CN_ERROR_STATE for a shape that is no sensor. O(contacts of its body), for chains squared.
cn_shape_get_visitors = _function("cn_shape_get_visitors", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
# Bodies that fell asleep in the last step, or since by cn_body_set_awake; ones destroyed since are stale
# handles.
cn_world_fell_asleep = _function("cn_world_fell_asleep", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_body)), _c.POINTER(_c.c_int32))
cn_revolute_def_init = _function("cn_revolute_def_init", None, _c.POINTER(cn_revolute_def))
cn_distance_def_init = _function("cn_distance_def_init", None, _c.POINTER(cn_distance_def))
cn_fixed_def_init = _function("cn_fixed_def_init", None, _c.POINTER(cn_fixed_def))
cn_prismatic_def_init = _function("cn_prismatic_def_init", None, _c.POINTER(cn_prismatic_def))
cn_wheel_def_init = _function("cn_wheel_def_init", None, _c.POINTER(cn_wheel_def))
cn_motor_def_init = _function("cn_motor_def_init", None, _c.POINTER(cn_motor_def))
cn_mouse_def_init = _function("cn_mouse_def_init", None, _c.POINTER(cn_mouse_def))
cn_gear_def_init = _function("cn_gear_def_init", None, _c.POINTER(cn_gear_def))
cn_pulley_def_init = _function("cn_pulley_def_init", None, _c.POINTER(cn_pulley_def))
cn_ratchet_def_init = _function("cn_ratchet_def_init", None, _c.POINTER(cn_ratchet_def))
cn_rotary_spring_def_init = _function("cn_rotary_spring_def_init", None, _c.POINTER(cn_rotary_spring_def))
cn_groove_def_init = _function("cn_groove_def_init", None, _c.POINTER(cn_groove_def))
cn_filter_joint_def_init = _function("cn_filter_joint_def_init", None, _c.POINTER(cn_filter_joint_def))
# Wake both bodies. CN_ERROR_ARGUMENT for a body with itself or without a dynamic body.
cn_joint_create_revolute = _function("cn_joint_create_revolute", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_revolute_def), _c.POINTER(cn_joint))
cn_joint_create_distance = _function("cn_joint_create_distance", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_distance_def), _c.POINTER(cn_joint))
cn_joint_create_fixed = _function("cn_joint_create_fixed", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_fixed_def), _c.POINTER(cn_joint))
cn_joint_create_prismatic = _function("cn_joint_create_prismatic", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_prismatic_def), _c.POINTER(cn_joint))
cn_joint_create_wheel = _function("cn_joint_create_wheel", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_wheel_def), _c.POINTER(cn_joint))
cn_joint_create_motor = _function("cn_joint_create_motor", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_motor_def), _c.POINTER(cn_joint))
cn_joint_create_mouse = _function("cn_joint_create_mouse", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_mouse_def), _c.POINTER(cn_joint))
cn_joint_create_gear = _function("cn_joint_create_gear", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_gear_def), _c.POINTER(cn_joint))
cn_joint_create_pulley = _function("cn_joint_create_pulley", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_pulley_def), _c.POINTER(cn_joint))
cn_joint_create_ratchet = _function("cn_joint_create_ratchet", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ratchet_def), _c.POINTER(cn_joint))
cn_joint_create_rotary_spring = _function("cn_joint_create_rotary_spring", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_rotary_spring_def), _c.POINTER(cn_joint))
cn_joint_create_groove = _function("cn_joint_create_groove", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_groove_def), _c.POINTER(cn_joint))
cn_joint_create_filter = _function("cn_joint_create_filter", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_filter_joint_def), _c.POINTER(cn_joint))
cn_joint_destroy = _function("cn_joint_destroy", cn_result, _c.POINTER(cn_world), cn_joint)
cn_joint_is_valid = _function("cn_joint_is_valid", _c.c_int32, _c.POINTER(cn_world), cn_joint)
cn_joint_get_type = _function("cn_joint_get_type", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_int32))
cn_joint_get_bodies = _function("cn_joint_get_bodies", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_body), _c.POINTER(cn_body))
cn_joint_get_anchors = _function("cn_joint_get_anchors", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_vec2), _c.POINTER(cn_vec2))
# Force in newtons and torque in newton metres that the joint put on body b in the last substep.
cn_joint_get_reaction = _function("cn_joint_get_reaction", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float))
# How far the joint's rigid parts are from being satisfied: metres (anchors, lengths beyond limits) and
# radians (angles beyond limits), both >= 0.
cn_joint_get_error = _function("cn_joint_get_error", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float))
# In worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): the joint is solved together with its
# neighbours where that is cheap. _SOFT: always by itself. _DIRECT: together with all joints that it hangs
# together with, for as much work as CN_SOLVER_DIRECT takes, within the work_budget. In a world in a caller's
# block that was not made with CN_SOLVER_DIRECT, _DIRECT is _AUTO. From the next step on; does not wake.
cn_joint_set_solver = _function("cn_joint_set_solver", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_int32)
cn_joint_get_solver = _function("cn_joint_get_solver", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_int32))
cn_joint_set_user_data = _function("cn_joint_set_user_data", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_uint64)
cn_joint_get_user_data = _function("cn_joint_get_user_data", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_uint64))
# Replaces the CN_JOINT_ flags. Wakes. O(contacts) when CN_JOINT_COLLIDE changes.
cn_joint_set_flags = _function("cn_joint_set_flags", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_uint32)
cn_joint_get_flags = _function("cn_joint_get_flags", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_uint32))
# Read back or replace a definition. set leaves bodies and anchors as they are and ignores struct_size; all
# else is taken, flags and user data too. CN_ERROR_STATE for a joint of another type. set wakes. A filter
# joint has nothing but its base.
cn_joint_get_revolute = _function("cn_joint_get_revolute", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_revolute_def))
cn_joint_set_revolute = _function("cn_joint_set_revolute", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_revolute_def))
cn_joint_get_distance = _function("cn_joint_get_distance", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_distance_def))
cn_joint_set_distance = _function("cn_joint_set_distance", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_distance_def))
cn_joint_get_fixed = _function("cn_joint_get_fixed", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_fixed_def))
cn_joint_set_fixed = _function("cn_joint_set_fixed", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_fixed_def))
cn_joint_get_prismatic = _function("cn_joint_get_prismatic", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_prismatic_def))
cn_joint_set_prismatic = _function("cn_joint_set_prismatic", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_prismatic_def))
cn_joint_get_wheel = _function("cn_joint_get_wheel", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_wheel_def))
cn_joint_set_wheel = _function("cn_joint_set_wheel", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_wheel_def))
cn_joint_get_motor_to = _function("cn_joint_get_motor_to", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_motor_def))
cn_joint_set_motor_to = _function("cn_joint_set_motor_to", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_motor_def))
cn_joint_get_mouse = _function("cn_joint_get_mouse", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_mouse_def))
cn_joint_set_mouse = _function("cn_joint_set_mouse", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_mouse_def))
cn_joint_get_gear = _function("cn_joint_get_gear", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_gear_def))
cn_joint_set_gear = _function("cn_joint_set_gear", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_gear_def))
cn_joint_get_pulley = _function("cn_joint_get_pulley", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_pulley_def))
cn_joint_set_pulley = _function("cn_joint_set_pulley", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_pulley_def))
cn_joint_get_ratchet = _function("cn_joint_get_ratchet", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_ratchet_def))
cn_joint_set_ratchet = _function("cn_joint_set_ratchet", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_ratchet_def))
cn_joint_get_rotary_spring = _function("cn_joint_get_rotary_spring", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_rotary_spring_def))
cn_joint_set_rotary_spring = _function("cn_joint_set_rotary_spring", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_rotary_spring_def))
cn_joint_get_groove = _function("cn_joint_get_groove", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_groove_def))
cn_joint_set_groove = _function("cn_joint_set_groove", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_groove_def))
# The base of any joint.
cn_joint_get_base = _function("cn_joint_get_base", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_joint_base))
# Takes stiffness, most force and torque, and break thresholds; the rest of base is ignored. Wakes.
cn_joint_set_base = _function("cn_joint_set_base", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(cn_joint_base))
# Mouse joint: where to drag to; called each frame. CN_ERROR_STATE for another type. Wakes.
cn_joint_set_target = _function("cn_joint_set_target", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float)
# Revolute, fixed, motor: the angle b - angle a - reference (motor: without one), in (-pi, pi]. Distance,
# pulley: the present length. Prismatic, wheel, groove: the translation along the axis. Mouse: distance to the
# target. Gear: angle b - ratio * angle a; ratchet, rotary spring: angle b - angle a, these three over whole
# turns.
cn_joint_get_position = _function("cn_joint_get_position", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float))
# How fast that changes; but of a wheel how fast b turns against a. With CN_JOINT_MOTOR, positive follows
# these.
cn_joint_get_speed = _function("cn_joint_get_speed", cn_result, _c.POINTER(cn_world), cn_joint, _c.POINTER(_c.c_float))
# The two setters that games call each frame, for revolute, distance, prismatic and wheel (others:
# CN_ERROR_STATE). Wake.
cn_joint_set_motor = _function("cn_joint_set_motor", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float)
cn_joint_set_limits = _function("cn_joint_set_limits", cn_result, _c.POINTER(cn_world), cn_joint, _c.c_float, _c.c_float)
# Those that exceeded a break threshold in the last step, and those destroyed with a body in or since the step
# before (by calls between two steps: reported by the next step).
cn_world_joint_events = _function("cn_world_joint_events", cn_result, _c.POINTER(cn_world), _c.POINTER(_c.POINTER(cn_joint_event)), _c.POINTER(_c.c_int32))
cn_angle_constraint_def_init = _function("cn_angle_constraint_def_init", None, _c.POINTER(cn_angle_constraint_def))
cn_line_constraint_def_init = _function("cn_line_constraint_def_init", None, _c.POINTER(cn_line_constraint_def))
# They are solved with the joints, before contacts. Wake the body.
cn_constraint_create_angle = _function("cn_constraint_create_angle", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_angle_constraint_def), _c.POINTER(cn_constraint))
cn_constraint_create_line = _function("cn_constraint_create_line", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_line_constraint_def), _c.POINTER(cn_constraint))
cn_constraint_destroy = _function("cn_constraint_destroy", cn_result, _c.POINTER(cn_world), cn_constraint)
cn_constraint_is_valid = _function("cn_constraint_is_valid", _c.c_int32, _c.POINTER(cn_world), cn_constraint)
cn_constraint_get_type = _function("cn_constraint_get_type", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_int32))
cn_constraint_get_body = _function("cn_constraint_get_body", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_body))
# Read back or replace a definition; set ignores body. CN_ERROR_STATE for the other type. set wakes.
cn_constraint_get_angle = _function("cn_constraint_get_angle", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_angle_constraint_def))
cn_constraint_set_angle = _function("cn_constraint_set_angle", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_angle_constraint_def))
cn_constraint_get_line = _function("cn_constraint_get_line", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_line_constraint_def))
cn_constraint_set_line = _function("cn_constraint_set_line", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_line_constraint_def))
# Angle: the angle over whole turns. Line: where along the axis the point is, from origin.
cn_constraint_get_position = _function("cn_constraint_get_position", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_float))
# Force in newtons and torque in newton metres that it put on the body in the last substep.
cn_constraint_get_reaction = _function("cn_constraint_get_reaction", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float))
# How far beyond what is allowed, >= 0.
cn_constraint_get_error = _function("cn_constraint_get_error", cn_result, _c.POINTER(cn_world), cn_constraint, _c.POINTER(_c.c_float), _c.POINTER(_c.c_float))
# As cn_world_get_joints and cn_body_get_joints, which do not list constraints.
cn_world_get_constraints = _function("cn_world_get_constraints", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_constraint), _c.c_int32, _c.POINTER(_c.c_int32))
cn_body_get_constraints = _function("cn_body_get_constraints", cn_result, _c.POINTER(cn_world), cn_body, _c.POINTER(cn_constraint), _c.c_int32, _c.POINTER(_c.c_int32))
# step_s in (0, 1], default 1/60; steps_max >= 1, default 8.
cn_world_set_fixed_step = _function("cn_world_set_fixed_step", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_int32)
# Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. Events of
# all steps but the last are only seen by callbacks. out may be NULL.
cn_world_update = _function("cn_world_update", cn_result, _c.POINTER(cn_world), _c.c_float, _c.POINTER(cn_update_report))
# Poses between the last two steps of cn_world_update: factor 0 the one before, 1 the last. bodies as in
# cn_world_read_poses. Bodies that did not take part in the last step have their present pose.
cn_world_read_poses_interpolated = _function("cn_world_read_poses_interpolated", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_body), _c.c_int32, _c.c_float, _c.POINTER(cn_pose))
cn_query_filter_init = _function("cn_query_filter_init", None, _c.POINTER(cn_query_filter))
# Nearest hit; out->shape is 0 when there is none. An edge is hit from both sides, a chain from its front
# only. Of equal hits the first by shape (as in cn_world_get_shapes), then child. filter may be NULL in all
# queries: the defaults. O(log) to O(shapes along the ray).
cn_world_cast_ray = _function("cn_world_cast_ray", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit))
# 1 if anything is hit: cheaper than the nearest.
cn_world_cast_ray_any = _function("cn_world_cast_ray_any", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(_c.c_int32))
# Up to capacity hits, nearest first (the nearest ones if there are more); *out_count is how many were found.
# A chain is hit once by each edge on the way.
cn_world_cast_ray_all = _function("cn_world_cast_ray_all", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit), _c.c_int32, _c.POINTER(_c.c_int32))
# count rays, the nearest hit of each; nothing is written if one of them is bad.
cn_world_cast_rays = _function("cn_world_cast_rays", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_ray), _c.c_int32, _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit))
# Against one shape alone, whatever its filter, in shape space when unattached. O(edges of a chain).
cn_shape_cast_ray = _function("cn_shape_cast_ray", cn_result, _c.POINTER(cn_world), cn_shape, _c.POINTER(cn_ray), _c.POINTER(cn_ray_hit))
# A polygon (its points in world coordinates; count may be 1 or 2 too, with radius > 0: circle, capsule) moved
# by translation without turning: the first shape it meets. A chain is met by what has the mean of its points
# in front.
cn_world_cast_shape = _function("cn_world_cast_shape", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_ray_hit))
# Shapes that overlap a region: at most capacity handles are written (the first ones), *out_count is how many
# there are, in the order of cn_world_get_shapes. The first is by the shapes' boxes without margin, the others
# exact. A chain is listed once; edges and chains are lines here, seen from both sides, and contain no point.
# Polygons as in cn_world_cast_shape. O(log) to O(boxes in the region).
cn_world_overlap_aabb = _function("cn_world_overlap_aabb", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_aabb), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_overlap_circle = _function("cn_world_overlap_circle", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_circle), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_overlap_polygon = _function("cn_world_overlap_polygon", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
cn_world_overlap_point = _function("cn_world_overlap_point", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_shape), _c.c_int32, _c.POINTER(_c.c_int32))
# The shape nearest to a point within distance_max_m (0 to 4e6 length units), the deepest if the point is in
# several. Cost grows with what is near, not with distance_max_m.
cn_world_closest_point = _function("cn_world_closest_point", cn_result, _c.POINTER(cn_world), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_closest))
# By GJK (Gilbert, Johnson, Keerthi 1988) when the shapes without their radii are apart, else by their
# Minkowski difference.
cn_polygon_distance = _function("cn_polygon_distance", cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_distance))
# b is moved by translation (at most 2e6 m each way) without turning: where it meets a, as cn_ray_hit says,
# without shape, body and child; 1 in *out_hit, or 0.
cn_polygon_cast = _function("cn_polygon_cast", cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.c_float, _c.c_float, _c.POINTER(cn_ray_hit), _c.POINTER(_c.c_int32))
# The contact of a step: no points when they are farther apart than margin_m (0 to 1e6). Impulses are 0. Not
# for a single point of radius 0.
cn_polygon_collide = _function("cn_polygon_collide", cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.POINTER(cn_polygon), _c.POINTER(cn_pose), _c.c_float, _c.POINTER(cn_manifold))
# When two shapes that move and turn first come within distance_m (0 to 1e6) of each other; fraction 0 for
# those that start nearer. Conservative advancement (Mirtich 1996) along fixed axes (Catto, GDC 2013) that
# never passes by a hit.
cn_polygon_time_of_impact = _function("cn_polygon_time_of_impact", cn_result, _c.POINTER(cn_polygon), _c.POINTER(cn_sweep), _c.POINTER(cn_polygon), _c.POINTER(cn_sweep), _c.c_float, _c.POINTER(cn_impact))
# The planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved by
# position: how they touch it, as in a step, rigid. At most capacity, those of least separation first;
# *out_count is how many there are. Sensors are no surfaces. With CN_QUERY_ONE_WAY a one-way shape is one only
# from its upper side, and only for what is no deeper in it than 0.5% of the length unit and what it rose by
# in the last step. A shape wholly behind another one's plane is left out: it cannot be met while that plane
# holds, so that the seams of tiles do not catch (not done when capacity is too small for all). O(shapes near,
# squared).
cn_mover_collide = _function("cn_mover_collide", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_polygon), _c.c_float, _c.c_float, _c.c_float, _c.POINTER(cn_query_filter), _c.POINTER(cn_plane), _c.c_int32, _c.POINTER(_c.c_int32))
# The translation nearest to a wanted one that the planes allow: exactly, for in two dimensions it lies on at
# most two of them. A plane pushes by no more than push_max_m: which ones push their most, Hildreth's method
# (1957) tells. Sets push_m. Between surfaces that leave no room it is that of the least sum of squared
# overlaps (Cimmino 1938), and *out_overlap_m, else 0 up to rounding, says how deep the deepest of them
# remains that did not push its most. count 0 to CN_PLANES_MAX. No world. O(count^2), O(count^3) where two
# planes hold it.
cn_mover_solve = _function("cn_mover_solve", cn_result, _c.POINTER(cn_plane), _c.c_int32, _c.c_float, _c.c_float, _c.POINTER(cn_vec2), _c.POINTER(_c.c_float))
# The velocity nearest to a given one that leads into none of the planes that pushed in the last
# cn_mover_solve. No world.
cn_mover_clip = _function("cn_mover_clip", cn_result, _c.POINTER(cn_plane), _c.c_int32, _c.c_float, _c.c_float, _c.POINTER(cn_vec2))
cn_mover_def_init = _function("cn_mover_def_init", None, _c.POINTER(cn_mover_def))
# Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, or it is a step behind what
# carries it. 1. carried   by what its ground did since the last move: the change of the place in ground_body
# where it stood, conveyors too 2. walking   on the ground: velocity_mps across up, along the ground, as fast
# uphill as downhill; no gravity, so that it does not creep. Where something too steep is in the way, a step
# up: up by step_height_m, forward, down on what can be walked on flying    in the air: velocity_mps and
# gravity (exact for constant gravity). Jumping and walking off take ground_velocity_mps along 3. sliding
# both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes through a
# wall 4. pushing   dynamic bodies in the way get a force for the next step that brings them to the
# character's velocity, of at most push_force_N each 5. ground    what it touches and can stand on, or finds
# within snap_m below when it walked; velocity_mps loses what is blocked Depends on the world, def and mover
# alone: the same calls give the same bits. The loop of planes, solver and cast is that of Box2D 3's sample of
# a character mover (Catto 2025). Bodies pushed wake up; nothing else of the world changes. O(shapes near x
# iterations_max): some 1 us standing, 3 us walking, 10 us against a wall.
cn_mover_move = _function("cn_mover_move", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_mover_def), _c.c_float, _c.POINTER(cn_mover))
cn_explosion_def_init = _function("cn_explosion_def_init", None, _c.POINTER(cn_explosion_def))
# Pushes dynamic bodies away from the centre, each shape at its point nearest to it, and wakes them.
# Velocities must stay finite (CN_ERROR_ARGUMENT). O(shapes in reach).
cn_world_explode = _function("cn_world_explode", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_explosion_def))
cn_debug_draw_init = _function("cn_debug_draw_init", None, _c.POINTER(cn_debug_draw))
# Reads only. O(what is drawn).
cn_world_draw = _function("cn_world_draw", cn_result, _c.POINTER(cn_world), _c.POINTER(cn_debug_draw))
# Dynamic AABB tree. alloc and free NULL: malloc. margin_m >= 0 is added around every box.
cn_tree_create = _function("cn_tree_create", cn_result, _c.c_float, cn_alloc_fn, cn_free_fn, _c.c_void_p, _c.POINTER(_c.POINTER(cn_tree)))
cn_tree_destroy = _function("cn_tree_destroy", None, _c.POINTER(cn_tree))
# O(log n). *out_item is never 0.
cn_tree_insert = _function("cn_tree_insert", cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_aabb), _c.c_uint64, _c.POINTER(_c.c_uint32))
cn_tree_remove = _function("cn_tree_remove", cn_result, _c.POINTER(cn_tree), _c.c_uint32)
# Nothing happens while the box stays within its margin. O(log n) else.
cn_tree_move = _function("cn_tree_move", cn_result, _c.POINTER(cn_tree), _c.c_uint32, _c.POINTER(cn_aabb))
cn_tree_get_box = _function("cn_tree_get_box", cn_result, _c.POINTER(cn_tree), _c.c_uint32, _c.POINTER(cn_aabb))
cn_tree_query = _function("cn_tree_query", cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_aabb), cn_tree_query_fn, _c.c_void_p)
cn_tree_cast_ray = _function("cn_tree_cast_ray", cn_result, _c.POINTER(cn_tree), _c.POINTER(cn_ray), cn_tree_ray_fn, _c.c_void_p)
# Number of items and height of the tree.
cn_tree_get_stats = _function("cn_tree_get_stats", cn_result, _c.POINTER(cn_tree), _c.POINTER(_c.c_int32), _c.POINTER(_c.c_int32))


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
    (cn_explosion_def, CN_TYPE_EXPLOSION_DEF),
    (cn_debug_draw, CN_TYPE_DEBUG_DRAW),
):
    if _c.sizeof(_struct) != cn_sizeof(_number):
        raise ImportError("%s has %d bytes here, %d in the library" % (_struct.__name__, _c.sizeof(_struct), cn_sizeof(_number)))
