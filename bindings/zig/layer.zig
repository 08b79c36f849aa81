//! Cairn for Zig: error unions and slices. Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//!
//!     var world = try cairn.World.init(&cairn.defaultWorldDef());
//!     defer world.deinit();
//!     var def = cairn.defaultBodyDef();
//!     def.position_m = .{ .x = 0, .y = 4 };
//!     const body = try world.bodyCreate(&def);
//!     try world.step(1.0 / 60.0);
//!     const pose = try world.bodyGetPose(body);
//!
//! A method is C's function without cn_ and without the world: cn_body_get_pose(world, body, &out) is try world.bodyGetPose(body).
//! `c` has C's functions and constants.
const std = @import("std");
pub const c = @import("cairn.zig");

pub const Error = error{ Argument, Handle, NoMemory, Locked, Capacity, State, Internal, Format, Unknown };

fn check(code: i32) Error!void {
    return switch (code) {
        c.CN_OK => {},
        c.CN_ERROR_ARGUMENT => error.Argument,
        c.CN_ERROR_HANDLE => error.Handle,
        c.CN_ERROR_MEMORY => error.NoMemory,
        c.CN_ERROR_LOCKED => error.Locked,
        c.CN_ERROR_CAPACITY => error.Capacity,
        c.CN_ERROR_STATE => error.State,
        c.CN_ERROR_INTERNAL => error.Internal,
        c.CN_ERROR_FORMAT => error.Format,
        else => error.Unknown,
    };
}

pub const Body = c.cn_body;
pub const Shape = c.cn_shape;
pub const Joint = c.cn_joint;
pub const Constraint = c.cn_constraint;
pub const Vec2 = c.cn_vec2;
pub const Pose = c.cn_pose;
pub const Velocity = c.cn_velocity;
pub const Aabb = c.cn_aabb;
pub const MassData = c.cn_mass_data;
pub const WorldDef = c.cn_world_def;
pub const Counters = c.cn_counters;
pub const IslandReport = c.cn_island_report;
pub const Profile = c.cn_profile;
pub const MemoryStats = c.cn_memory_stats;
pub const BodyDef = c.cn_body_def;
pub const BodyMoved = c.cn_body_moved;
pub const Filter = c.cn_filter;
pub const Material = c.cn_material;
pub const ShapeDef = c.cn_shape_def;
pub const Circle = c.cn_circle;
pub const Capsule = c.cn_capsule;
pub const Edge = c.cn_edge;
pub const Polygon = c.cn_polygon;
pub const Chain = c.cn_chain;
pub const ManifoldPoint = c.cn_manifold_point;
pub const Manifold = c.cn_manifold;
pub const ContactEvent = c.cn_contact_event;
pub const SensorEvent = c.cn_sensor_event;
pub const JointBase = c.cn_joint_base;
pub const RevoluteDef = c.cn_revolute_def;
pub const DistanceDef = c.cn_distance_def;
pub const FixedDef = c.cn_fixed_def;
pub const PrismaticDef = c.cn_prismatic_def;
pub const WheelDef = c.cn_wheel_def;
pub const MotorDef = c.cn_motor_def;
pub const MouseDef = c.cn_mouse_def;
pub const GearDef = c.cn_gear_def;
pub const PulleyDef = c.cn_pulley_def;
pub const RatchetDef = c.cn_ratchet_def;
pub const RotarySpringDef = c.cn_rotary_spring_def;
pub const GrooveDef = c.cn_groove_def;
pub const FilterJointDef = c.cn_filter_joint_def;
pub const JointEvent = c.cn_joint_event;
pub const AngleConstraintDef = c.cn_angle_constraint_def;
pub const LineConstraintDef = c.cn_line_constraint_def;
pub const UpdateReport = c.cn_update_report;
pub const Ray = c.cn_ray;
pub const RayHit = c.cn_ray_hit;
pub const QueryFilter = c.cn_query_filter;
pub const Closest = c.cn_closest;
pub const Distance = c.cn_distance;
pub const Sweep = c.cn_sweep;
pub const Impact = c.cn_impact;
pub const Plane = c.cn_plane;
pub const MoverDef = c.cn_mover_def;
pub const Mover = c.cn_mover;
pub const AreaDef = c.cn_area_def;
pub const ExplosionDef = c.cn_explosion_def;
pub const DebugDraw = c.cn_debug_draw;

pub fn defaultWorldDef() WorldDef {
    var value: WorldDef = undefined;
    c.cn_world_def_init(&value);
    return value;
}

pub fn defaultBodyDef() BodyDef {
    var value: BodyDef = undefined;
    c.cn_body_def_init(&value);
    return value;
}

pub fn defaultShapeDef() ShapeDef {
    var value: ShapeDef = undefined;
    c.cn_shape_def_init(&value);
    return value;
}

pub fn defaultRevoluteDef() RevoluteDef {
    var value: RevoluteDef = undefined;
    c.cn_revolute_def_init(&value);
    return value;
}

pub fn defaultDistanceDef() DistanceDef {
    var value: DistanceDef = undefined;
    c.cn_distance_def_init(&value);
    return value;
}

pub fn defaultFixedDef() FixedDef {
    var value: FixedDef = undefined;
    c.cn_fixed_def_init(&value);
    return value;
}

pub fn defaultPrismaticDef() PrismaticDef {
    var value: PrismaticDef = undefined;
    c.cn_prismatic_def_init(&value);
    return value;
}

pub fn defaultWheelDef() WheelDef {
    var value: WheelDef = undefined;
    c.cn_wheel_def_init(&value);
    return value;
}

pub fn defaultMotorDef() MotorDef {
    var value: MotorDef = undefined;
    c.cn_motor_def_init(&value);
    return value;
}

pub fn defaultMouseDef() MouseDef {
    var value: MouseDef = undefined;
    c.cn_mouse_def_init(&value);
    return value;
}

pub fn defaultGearDef() GearDef {
    var value: GearDef = undefined;
    c.cn_gear_def_init(&value);
    return value;
}

pub fn defaultPulleyDef() PulleyDef {
    var value: PulleyDef = undefined;
    c.cn_pulley_def_init(&value);
    return value;
}

pub fn defaultRatchetDef() RatchetDef {
    var value: RatchetDef = undefined;
    c.cn_ratchet_def_init(&value);
    return value;
}

pub fn defaultRotarySpringDef() RotarySpringDef {
    var value: RotarySpringDef = undefined;
    c.cn_rotary_spring_def_init(&value);
    return value;
}

pub fn defaultGrooveDef() GrooveDef {
    var value: GrooveDef = undefined;
    c.cn_groove_def_init(&value);
    return value;
}

pub fn defaultFilterJointDef() FilterJointDef {
    var value: FilterJointDef = undefined;
    c.cn_filter_joint_def_init(&value);
    return value;
}

pub fn defaultAngleConstraintDef() AngleConstraintDef {
    var value: AngleConstraintDef = undefined;
    c.cn_angle_constraint_def_init(&value);
    return value;
}

pub fn defaultLineConstraintDef() LineConstraintDef {
    var value: LineConstraintDef = undefined;
    c.cn_line_constraint_def_init(&value);
    return value;
}

pub fn defaultQueryFilter() QueryFilter {
    var value: QueryFilter = undefined;
    c.cn_query_filter_init(&value);
    return value;
}

pub fn defaultMoverDef() MoverDef {
    var value: MoverDef = undefined;
    c.cn_mover_def_init(&value);
    return value;
}

pub fn defaultAreaDef() AreaDef {
    var value: AreaDef = undefined;
    c.cn_area_def_init(&value);
    return value;
}

pub fn defaultExplosionDef() ExplosionDef {
    var value: ExplosionDef = undefined;
    c.cn_explosion_def_init(&value);
    return value;
}

pub fn defaultDebugDraw() DebugDraw {
    var value: DebugDraw = undefined;
    c.cn_debug_draw_init(&value);
    return value;
}

/// A world with everything in it.
pub const World = struct {
    pointer: *c.cn_world,

    pub fn init(def: *const WorldDef) Error!World {
        var pointer: ?*c.cn_world = null;
        try check(c.cn_world_create(def, &pointer));
        return .{ .pointer = pointer.? };
    }

    /// A world from the bytes of write. Of the definition only memory, workers and capacities are used.
    pub fn read(file: []const u8, def: ?*const WorldDef) Error!World {
        var pointer: ?*c.cn_world = null;
        try check(c.cn_world_read(def, file.ptr, file.len, &pointer));
        return .{ .pointer = pointer.? };
    }

    pub fn deinit(self: World) void {
        c.cn_world_destroy(self.pointer);
    }

    /// The sentence of the last call that failed, "" if none did.
    pub fn errorText(self: World) [:0]const u8 {
        return std.mem.span(c.cn_world_error_text(self.pointer));
    }


    /// Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
    /// O(awake bodies and their contacts and joints).
    pub fn step(self: World, dt_s: f32) Error!void {
        return check(c.cn_world_step(self.pointer, dt_s));
    }

    /// Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
    pub fn setGravity(self: World, gravity_x_mps2: f32, gravity_y_mps2: f32) Error!void {
        return check(c.cn_world_set_gravity(self.pointer, gravity_x_mps2, gravity_y_mps2));
    }

    /// Reads gravity in m/s^2.
    pub fn getGravity(self: World) Error!Vec2 {
        var out0: Vec2 = undefined;
        try check(c.cn_world_get_gravity(self.pointer, &out0));
        return out0;
    }

    /// Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.
    pub fn setSubstepCount(self: World, count: i32) Error!void {
        return check(c.cn_world_set_substep_count(self.pointer, count));
    }

    /// Reads the substeps of a step.
    pub fn getSubstepCount(self: World) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_world_get_substep_count(self.pointer, &out0));
        return out0;
    }

    /// Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
    /// memory of the solver it was created with; a solver that needs more works without direct solving
    /// (CN_WARNING_FRAME_MEMORY).
    pub fn setSolver(self: World, solver: i32) Error!void {
        return check(c.cn_world_set_solver(self.pointer, solver));
    }

    /// Reads the solver (CN_SOLVER_*).
    pub fn getSolver(self: World) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_world_get_solver(self.pointer, &out0));
        return out0;
    }

    /// Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
    pub fn setAccuracy(self: World, accuracy_m: f32, work_budget: i32) Error!void {
        return check(c.cn_world_set_accuracy(self.pointer, accuracy_m, work_budget));
    }

    /// Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
    /// (CN_DEFAULT: none).
    pub fn getAccuracy(self: World) Error!struct { accuracy_m: f32, work_budget: i32 } {
        var out0: f32 = undefined;
        var out1: i32 = undefined;
        try check(c.cn_world_get_accuracy(self.pointer, &out0, &out1));
        return .{ .accuracy_m = out0, .work_budget = out1 };
    }

    /// Reads how many workers a step can use: 1, or worker_count where the library supports threads.
    pub fn getWorkerCount(self: World) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_world_get_worker_count(self.pointer, &out0));
        return out0;
    }

    /// Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
    pub fn setFlags(self: World, flags: u32) Error!void {
        return check(c.cn_world_set_flags(self.pointer, flags));
    }

    /// Reads the CN_WORLD_ flags.
    pub fn getFlags(self: World) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_world_get_flags(self.pointer, &out0));
        return out0;
    }

    /// Impacts slower than this, in m/s, do not bounce; >= 0.
    pub fn setRestitutionThreshold(self: World, speed_mps: f32) Error!void {
        return check(c.cn_world_set_restitution_threshold(self.pointer, speed_mps));
    }

    /// Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
    pub fn setHitSpeed(self: World, speed_mps: f32) Error!void {
        return check(c.cn_world_set_hit_speed(self.pointer, speed_mps));
    }

    /// Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster
    /// bodies down to them and keeps the direction.
    pub fn setSpeedLimits(self: World, linear_mps: f32, angular_radps: f32) Error!void {
        return check(c.cn_world_set_speed_limits(self.pointer, linear_mps, angular_radps));
    }

    /// Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
    /// they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
    /// others that no joint holds and that are slower than four times the speed lose theirs within a second
    /// or two: what rocks in a hollow would keep all of a heap awake.
    pub fn setSleep(self: World, speed_mps: f32, delay_s: f32) Error!void {
        return check(c.cn_world_set_sleep(self.pointer, speed_mps, delay_s));
    }

    /// Stores a number for the user.
    pub fn setUserData(self: World, user_data: u64) Error!void {
        return check(c.cn_world_set_user_data(self.pointer, user_data));
    }

    /// Reads the user's number.
    pub fn getUserData(self: World) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_world_get_user_data(self.pointer, &out0));
        return out0;
    }

    /// Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
    /// capacity is 0. out_count is their number. O(slots).
    /// The caller frees the slice.
    pub fn getBodies(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]Body {
        var found: i32 = 0;
        try check(c.cn_world_get_bodies(self.pointer, null, 0, &found));
        const list = try gpa.alloc(Body, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_get_bodies(self.pointer, list.ptr, found, &found));
        return list;
    }

    /// Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    /// The caller frees the slice.
    pub fn getShapes(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_world_get_shapes(self.pointer, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_get_shapes(self.pointer, list.ptr, found, &found));
        return list;
    }

    /// Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(slots).
    /// The caller frees the slice.
    pub fn getJoints(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]Joint {
        var found: i32 = 0;
        try check(c.cn_world_get_joints(self.pointer, null, 0, &found));
        const list = try gpa.alloc(Joint, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_get_joints(self.pointer, list.ptr, found, &found));
        return list;
    }

    /// Reads counts of objects and what the last step reported. O(bodies + islands).
    pub fn getCounters(self: World) Error!Counters {
        var out0: Counters = undefined;
        try check(c.cn_world_get_counters(self.pointer, &out0));
        return out0;
    }

    /// Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies,
    /// in a deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their
    /// number. A step does no work for it. O(bodies + contacts and joints of the islands written).
    /// The caller frees the slice.
    pub fn getIslands(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]IslandReport {
        var found: i32 = 0;
        try check(c.cn_world_get_islands(self.pointer, null, 0, &found));
        const list = try gpa.alloc(IslandReport, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_get_islands(self.pointer, list.ptr, found, &found));
        return list;
    }

    /// Reads the seconds of the last step by stage.
    pub fn getProfile(self: World) Error!Profile {
        var out0: Profile = undefined;
        try check(c.cn_world_get_profile(self.pointer, &out0));
        return out0;
    }

    /// Reads the memory statistics.
    pub fn getMemoryStats(self: World) Error!MemoryStats {
        var out0: MemoryStats = undefined;
        try check(c.cn_world_get_memory_stats(self.pointer, &out0));
        return out0;
    }

    /// Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position
    /// p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
    /// world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay,
    /// and no event is reported. Distances between bodies keep their digits; world anchors are rounded to
    /// floats at the new place. Arrays returned before become invalid; the user moves their own points
    /// (movers, rays, cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next
    /// step looks at all pairs again.
    pub fn shiftOrigin(self: World, x_m: f32, y_m: f32) Error!void {
        return check(c.cn_world_shift_origin(self.pointer, x_m, y_m));
    }

    /// 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
    /// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
    /// every compiler, CPU and thread count. O(bodies + contacts + joints).
    pub fn hash(self: World) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_world_hash(self.pointer, &out0));
        return out0;
    }

    /// Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn saveSize(self: World) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_world_save_size(self.pointer, &out0));
        return out0;
    }

    /// Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and
    /// the number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the
    /// world), about 1 KB per body.
    /// The caller frees the slice.
    pub fn save(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]u8 {
        var room: u64 = 0;
        try check(c.cn_world_save_size(self.pointer, &room));
        const list = try gpa.alloc(u8, @intCast(room));
        errdefer gpa.free(list);
        try check(c.cn_world_save(self.pointer, list.ptr, list.len, &room));
        return if (gpa.resize(list, @intCast(room))) list[0..@intCast(room)] else gpa.realloc(list, @intCast(room));
    }

    /// Restores a saved state, into the saved world or one created with the same definition (broadphase,
    /// length unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save;
    /// CN_ERROR_FORMAT for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the
    /// objects alive then (a world in a caller's block has room for its own saves). Arrays returned before
    /// become invalid. Handles of objects alive at the save are valid again, also of objects destroyed since;
    /// handles created since are refused until the same handle is given to a new object: with the same calls
    /// to the same object. O(memory of the world).
    pub fn restore(self: World, save_: []const u8) Error!void {
        return check(c.cn_world_restore(self.pointer, save_.ptr, save_.len));
    }

    /// Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn writeSize(self: World) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_world_write_size(self.pointer, &out0));
        return out0;
    }

    /// Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
    /// of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about
    /// 1 KB per body.
    /// The caller frees the slice.
    pub fn write(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]u8 {
        var room: u64 = 0;
        try check(c.cn_world_write_size(self.pointer, &room));
        const list = try gpa.alloc(u8, @intCast(room));
        errdefer gpa.free(list);
        try check(c.cn_world_write(self.pointer, list.ptr, list.len, &room));
        return if (gpa.resize(list, @intCast(room))) list[0..@intCast(room)] else gpa.realloc(list, @intCast(room));
    }

    /// Creates a body. O(1) amortized.
    pub fn bodyCreate(self: World, def: *const BodyDef) Error!Body {
        var out0: Body = undefined;
        try check(c.cn_body_create(self.pointer, def, &out0));
        return out0;
    }

    /// Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
    pub fn bodyCreateMany(self: World, defs: []const BodyDef, out_bodies: []Body) Error!void {
        if (defs.len != out_bodies.len) return error.Argument;
        return check(c.cn_body_create_many(self.pointer, defs.ptr, @intCast(out_bodies.len), out_bodies.ptr));
    }

    /// Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
    /// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts
    /// + joints + shapes).
    pub fn bodyDestroy(self: World, body: Body) Error!void {
        return check(c.cn_body_destroy(self.pointer, body));
    }

    /// Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
    /// O(their contacts + joints + shapes).
    pub fn bodyDestroyMany(self: World, bodies: []const Body) Error!void {
        return check(c.cn_body_destroy_many(self.pointer, bodies.ptr, @intCast(bodies.len)));
    }

    /// 1 if the handle names a living body of this world, else 0 (also for a NULL world).
    pub fn bodyIsValid(self: World, body: Body) bool {
        return c.cn_body_is_valid(self.pointer, body) != 0;
    }

    /// Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those
    /// that still overlap begin again in the next step), with its forces and any mass override; a body made
    /// static stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints +
    /// shapes).
    pub fn bodySetType(self: World, body: Body, @"type": i32) Error!void {
        return check(c.cn_body_set_type(self.pointer, body, @"type"));
    }

    /// Reads the type (CN_BODY_*).
    pub fn bodyGetType(self: World, body: Body) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_body_get_type(self.pointer, body, &out0));
        return out0;
    }

    /// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
    /// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
    /// are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
    pub fn bodySetFlags(self: World, body: Body, flags: u32) Error!void {
        return check(c.cn_body_set_flags(self.pointer, body, flags));
    }

    /// Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
    pub fn bodyGetFlags(self: World, body: Body) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_body_get_flags(self.pointer, body, &out0));
        return out0;
    }

    /// 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and
    /// disabled bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
    pub fn bodySetAwake(self: World, body: Body, awake: i32) Error!void {
        return check(c.cn_body_set_awake(self.pointer, body, awake));
    }

    /// Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <=
    /// 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
    /// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
    /// neighbours. O(contacts + joints + shapes).
    pub fn bodySetPose(self: World, body: Body, position_x_m: f32, position_y_m: f32, angle_rad: f32) Error!void {
        return check(c.cn_body_set_pose(self.pointer, body, position_x_m, position_y_m, angle_rad));
    }

    /// Reads the position of the origin and the rotation.
    pub fn bodyGetPose(self: World, body: Body) Error!Pose {
        var out0: Pose = undefined;
        try check(c.cn_body_get_pose(self.pointer, body, &out0));
        return out0;
    }

    /// Reads the position of the origin as the sum of two floats: the high part is within rounding that of
    /// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in
    /// double is more precise; so is a difference of two bodies, taken high from high and low from low, in
    /// floats.
    pub fn bodyGetPositionParts(self: World, body: Body) Error!struct { high_m: Vec2, low_m: Vec2 } {
        var out0: Vec2 = undefined;
        var out1: Vec2 = undefined;
        try check(c.cn_body_get_position_parts(self.pointer, body, &out0, &out1));
        return .{ .high_m = out0, .low_m = out1 };
    }

    /// Reads the angle in radians, in (-pi, pi].
    pub fn bodyGetAngle(self: World, body: Body) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_body_get_angle(self.pointer, body, &out0));
        return out0;
    }

    /// Reads the world position of the centre of mass, in metres.
    pub fn bodyGetCenter(self: World, body: Body) Error!Vec2 {
        var out0: Vec2 = undefined;
        try check(c.cn_body_get_center(self.pointer, body, &out0));
        return out0;
    }

    /// Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
    /// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.
    pub fn bodySetVelocity(self: World, body: Body, linear_x_mps: f32, linear_y_mps: f32, angular_radps: f32) Error!void {
        return check(c.cn_body_set_velocity(self.pointer, body, linear_x_mps, linear_y_mps, angular_radps));
    }

    /// Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
    pub fn bodyGetVelocity(self: World, body: Body) Error!Velocity {
        var out0: Velocity = undefined;
        try check(c.cn_body_get_velocity(self.pointer, body, &out0));
        return out0;
    }

    /// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1)
    /// takes it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits.
    /// Unlike after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this
    /// before every step, or stop the body after it.
    pub fn bodySetTargetPose(self: World, body: Body, position_x_m: f32, position_y_m: f32, angle_rad: f32, dt_s: f32) Error!void {
        return check(c.cn_body_set_target_pose(self.pointer, body, position_x_m, position_y_m, angle_rad, dt_s));
    }

    /// Velocity in m/s of the body's material at a world point in metres.
    pub fn bodyGetVelocityAt(self: World, body: Body, point_x_m: f32, point_y_m: f32) Error!Vec2 {
        var out0: Vec2 = undefined;
        try check(c.cn_body_get_velocity_at(self.pointer, body, point_x_m, point_y_m, &out0));
        return out0;
    }

    /// World position of a point given in the body's frame, both in metres.
    pub fn bodyGetWorldPoint(self: World, body: Body, local_x_m: f32, local_y_m: f32) Error!Vec2 {
        var out0: Vec2 = undefined;
        try check(c.cn_body_get_world_point(self.pointer, body, local_x_m, local_y_m, &out0));
        return out0;
    }

    /// Position in the body's frame of a world point, both in metres.
    pub fn bodyGetLocalPoint(self: World, body: Body, world_x_m: f32, world_y_m: f32) Error!Vec2 {
        var out0: Vec2 = undefined;
        try check(c.cn_body_get_local_point(self.pointer, body, world_x_m, world_y_m, &out0));
        return out0;
    }

    /// Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
    /// O(shapes).
    pub fn bodyGetAabb(self: World, body: Body) Error!Aabb {
        var out0: Aabb = undefined;
        try check(c.cn_body_get_aabb(self.pointer, body, &out0));
        return out0;
    }

    /// Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static,
    /// kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.
    pub fn bodyApplyForce(self: World, body: Body, force_x_N: f32, force_y_N: f32) Error!void {
        return check(c.cn_body_apply_force(self.pointer, body, force_x_N, force_y_N));
    }

    /// Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
    /// cn_body_apply_force.
    pub fn bodyApplyForceAt(self: World, body: Body, force_x_N: f32, force_y_N: f32, point_x_m: f32, point_y_m: f32) Error!void {
        return check(c.cn_body_apply_force_at(self.pointer, body, force_x_N, force_y_N, point_x_m, point_y_m));
    }

    /// Adds a torque in newton metres; otherwise as cn_body_apply_force.
    pub fn bodyApplyTorque(self: World, body: Body, torque_Nm: f32) Error!void {
        return check(c.cn_body_apply_torque(self.pointer, body, torque_Nm));
    }

    /// Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
    /// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
    /// overflows.
    pub fn bodyApplyImpulse(self: World, body: Body, impulse_x_Ns: f32, impulse_y_Ns: f32) Error!void {
        return check(c.cn_body_apply_impulse(self.pointer, body, impulse_x_Ns, impulse_y_Ns));
    }

    /// Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity
    /// too; otherwise as cn_body_apply_impulse.
    pub fn bodyApplyImpulseAt(self: World, body: Body, impulse_x_Ns: f32, impulse_y_Ns: f32, point_x_m: f32, point_y_m: f32) Error!void {
        return check(c.cn_body_apply_impulse_at(self.pointer, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m));
    }

    /// Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
    /// cn_body_apply_impulse.
    pub fn bodyApplyAngularImpulse(self: World, body: Body, impulse_Nms: f32) Error!void {
        return check(c.cn_body_apply_angular_impulse(self.pointer, body, impulse_Nms));
    }

    /// Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
    /// shapes have no mass weighs 1 kg; without shapes it does not rotate.
    pub fn bodyGetMassData(self: World, body: Body) Error!MassData {
        var out0: MassData = undefined;
        try check(c.cn_body_get_mass_data(self.pointer, body, &out0));
        return out0;
    }

    /// Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
    /// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35.
    /// Wakes the body.
    pub fn bodySetMassData(self: World, body: Body, mass: *const MassData) Error!void {
        return check(c.cn_body_set_mass_data(self.pointer, body, mass));
    }

    /// Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
    pub fn bodyResetMassData(self: World, body: Body) Error!void {
        return check(c.cn_body_reset_mass_data(self.pointer, body));
    }

    /// Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
    pub fn bodySetDamping(self: World, body: Body, linear_per_s: f32, angular_per_s: f32) Error!void {
        return check(c.cn_body_set_damping(self.pointer, body, linear_per_s, angular_per_s));
    }

    /// Reads the linear and angular damping in 1/s.
    pub fn bodyGetDamping(self: World, body: Body) Error!struct { linear_per_s: f32, angular_per_s: f32 } {
        var out0: f32 = undefined;
        var out1: f32 = undefined;
        try check(c.cn_body_get_damping(self.pointer, body, &out0, &out1));
        return .{ .linear_per_s = out0, .angular_per_s = out1 };
    }

    /// Sets the factor on gravity for this body, finite. A change wakes the body.
    pub fn bodySetGravityScale(self: World, body: Body, scale: f32) Error!void {
        return check(c.cn_body_set_gravity_scale(self.pointer, body, scale));
    }

    /// Reads the factor on gravity.
    pub fn bodyGetGravityScale(self: World, body: Body) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_body_get_gravity_scale(self.pointer, body, &out0));
        return out0;
    }

    /// Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
    pub fn bodySetSleepSpeed(self: World, body: Body, speed_mps: f32) Error!void {
        return check(c.cn_body_set_sleep_speed(self.pointer, body, speed_mps));
    }

    /// Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
    /// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
    /// bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
    /// within the work_budget. Takes effect with the next step; does not wake.
    pub fn bodySetSolver(self: World, body: Body, solver: i32) Error!void {
        return check(c.cn_body_set_solver(self.pointer, body, solver));
    }

    /// Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn bodyGetSolver(self: World, body: Body) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_body_get_solver(self.pointer, body, &out0));
        return out0;
    }

    /// Stores a number for the user.
    pub fn bodySetUserData(self: World, body: Body, user_data: u64) Error!void {
        return check(c.cn_body_set_user_data(self.pointer, body, user_data));
    }

    /// Reads the user's number.
    pub fn bodyGetUserData(self: World, body: Body) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_body_get_user_data(self.pointer, body, &out0));
        return out0;
    }

    /// Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
    /// O(length).
    pub fn bodySetName(self: World, body: Body, name: ?[:0]const u8) Error!void {
        return check(c.cn_body_set_name(self.pointer, body, if (name) |given| given.ptr else null));
    }

    /// Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
    pub fn bodyGetName(self: World, body: Body) Error![:0]const u8 {
        var text: ?[*:0]const u8 = null;
        try check(c.cn_body_get_name(self.pointer, body, &text));
        return std.mem.span(text.?);
    }

    /// Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).
    /// The caller frees the slice.
    pub fn bodyGetShapes(self: World, gpa: std.mem.Allocator, body: Body) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_body_get_shapes(self.pointer, body, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_body_get_shapes(self.pointer, body, list.ptr, found, &found));
        return list;
    }

    /// Handles of the body's joints without constraints; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(joints).
    /// The caller frees the slice.
    pub fn bodyGetJoints(self: World, gpa: std.mem.Allocator, body: Body) (Error || std.mem.Allocator.Error)![]Joint {
        var found: i32 = 0;
        try check(c.cn_body_get_joints(self.pointer, body, null, 0, &found));
        const list = try gpa.alloc(Joint, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_body_get_joints(self.pointer, body, list.ptr, found, &found));
        return list;
    }

    /// Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then
    /// be their number. One bad handle fails the whole call. O(count).
    pub fn readPoses(self: World, bodies: ?[]const Body, out: []Pose) Error!void {
        if (bodies) |given| if (given.len != out.len) return error.Argument;
        return check(c.cn_world_read_poses(self.pointer, if (bodies) |given| given.ptr else null, @intCast(out.len), out.ptr));
    }

    /// Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
    pub fn readVelocities(self: World, bodies: ?[]const Body, out: []Velocity) Error!void {
        if (bodies) |given| if (given.len != out.len) return error.Argument;
        return check(c.cn_world_read_velocities(self.pointer, if (bodies) |given| given.ptr else null, @intCast(out.len), out.ptr));
    }

    /// Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
    /// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).
    pub fn writeVelocities(self: World, bodies: ?[]const Body, velocities: []const Velocity) Error!void {
        if (bodies) |given| if (given.len != velocities.len) return error.Argument;
        return check(c.cn_world_write_velocities(self.pointer, if (bodies) |given| given.ptr else null, @intCast(velocities.len), velocities.ptr));
    }

    /// Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since.
    /// The first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
    pub fn moved(self: World) Error![]const BodyMoved {
        var data: ?[*]const BodyMoved = null;
        var found: i32 = 0;
        try check(c.cn_world_moved(self.pointer, &data, &found));
        return if (data) |at| at[0..@intCast(found)] else &.{};
    }

    /// Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
    pub fn shapeCreateCircle(self: World, def: *const ShapeDef, circle: *const Circle) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_circle(self.pointer, def, circle, &out0));
        return out0;
    }

    /// Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body.
    /// out_shape may be NULL.
    pub fn shapeCreateCapsule(self: World, def: *const ShapeDef, capsule: *const Capsule) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_capsule(self.pointer, def, capsule, &out0));
        return out0;
    }

    /// Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.
    pub fn shapeCreateEdge(self: World, def: *const ShapeDef, edge: *const Edge) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_edge(self.pointer, def, edge, &out0));
        return out0;
    }

    /// Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
    /// out_shape may be NULL.
    pub fn shapeCreatePolygon(self: World, def: *const ShapeDef, polygon: *const Polygon) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_polygon(self.pointer, def, polygon, &out0));
        return out0;
    }

    /// Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body.
    /// out_shape may be NULL.
    pub fn shapeCreateBox(self: World, def: *const ShapeDef, half_width_m: f32, half_height_m: f32, radius_m: f32) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_box(self.pointer, def, half_width_m, half_height_m, radius_m, &out0));
        return out0;
    }

    /// Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
    /// may be NULL. O(count).
    pub fn shapeCreateChain(self: World, def: *const ShapeDef, chain: *const Chain) Error!Shape {
        var out0: Shape = undefined;
        try check(c.cn_shape_create_chain(self.pointer, def, chain, &out0));
        return out0;
    }

    /// Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static
    /// one. CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
    pub fn shapeAttach(self: World, shape: Shape, body: Body) Error!void {
        return check(c.cn_shape_attach(self.pointer, shape, body));
    }

    /// Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no
    /// body. O(contacts + shapes of the body).
    pub fn shapeDetach(self: World, shape: Shape) Error!void {
        return check(c.cn_shape_detach(self.pointer, shape));
    }

    /// Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
    pub fn shapeDestroy(self: World, shape: Shape) Error!void {
        return check(c.cn_shape_destroy(self.pointer, shape));
    }

    /// 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
    pub fn shapeIsValid(self: World, shape: Shape) bool {
        return c.cn_shape_is_valid(self.pointer, shape) != 0;
    }

    /// Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
    pub fn shapeGetType(self: World, shape: Shape) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_shape_get_type(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads the body; 0 if unattached.
    pub fn shapeGetBody(self: World, shape: Shape) Error!Body {
        var out0: Body = undefined;
        try check(c.cn_shape_get_body(self.pointer, shape, &out0));
        return out0;
    }

    /// Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
    /// body).
    pub fn shapeSetMaterial(self: World, shape: Shape, material: *const Material) Error!void {
        return check(c.cn_shape_set_material(self.pointer, shape, material));
    }

    /// Reads the material.
    pub fn shapeGetMaterial(self: World, shape: Shape) Error!Material {
        var out0: Material = undefined;
        try check(c.cn_shape_get_material(self.pointer, shape, &out0));
        return out0;
    }

    /// Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
    /// wakes the body. O(shapes of the body).
    pub fn shapeSetDensity(self: World, shape: Shape, density_kgpm2: f32) Error!void {
        return check(c.cn_shape_set_density(self.pointer, shape, density_kgpm2));
    }

    /// Reads the density in kg/m^2.
    pub fn shapeGetDensity(self: World, shape: Shape) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_shape_get_density(self.pointer, shape, &out0));
        return out0;
    }

    /// Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
    /// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn shapeSetFilter(self: World, shape: Shape, filter: *const Filter) Error!void {
        return check(c.cn_shape_set_filter(self.pointer, shape, filter));
    }

    /// Reads the filter.
    pub fn shapeGetFilter(self: World, shape: Shape) Error!Filter {
        var out0: Filter = undefined;
        try check(c.cn_shape_get_filter(self.pointer, shape, &out0));
        return out0;
    }

    /// Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts
    /// of the body).
    pub fn shapeSetEventMask(self: World, shape: Shape, event_mask: u32) Error!void {
        return check(c.cn_shape_set_event_mask(self.pointer, shape, event_mask));
    }

    /// Reads the event mask.
    pub fn shapeGetEventMask(self: World, shape: Shape) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_shape_get_event_mask(self.pointer, shape, &out0));
        return out0;
    }

    /// Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the
    /// next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn shapeSetFlags(self: World, shape: Shape, flags: u32) Error!void {
        return check(c.cn_shape_set_flags(self.pointer, shape, flags));
    }

    /// Reads the CN_SHAPE_ flags.
    pub fn shapeGetFlags(self: World, shape: Shape) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_shape_get_flags(self.pointer, shape, &out0));
        return out0;
    }

    /// Stores a number for the user.
    pub fn shapeSetUserData(self: World, shape: Shape, user_data: u64) Error!void {
        return check(c.cn_shape_set_user_data(self.pointer, shape, user_data));
    }

    /// Reads the user's number.
    pub fn shapeGetUserData(self: World, shape: Shape) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_shape_get_user_data(self.pointer, shape, &out0));
        return out0;
    }

    /// AABB without margin, in the world (in the shape's own space when unattached). O(points).
    pub fn shapeGetAabb(self: World, shape: Shape) Error!Aabb {
        var out0: Aabb = undefined;
        try check(c.cn_shape_get_aabb(self.pointer, shape, &out0));
        return out0;
    }

    /// Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
    /// O(points).
    pub fn shapeGetMassData(self: World, shape: Shape) Error!MassData {
        var out0: MassData = undefined;
        try check(c.cn_shape_get_mass_data(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shapeGetCircle(self: World, shape: Shape) Error!Circle {
        var out0: Circle = undefined;
        try check(c.cn_shape_get_circle(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shapeGetCapsule(self: World, shape: Shape) Error!Capsule {
        var out0: Capsule = undefined;
        try check(c.cn_shape_get_capsule(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shapeGetEdge(self: World, shape: Shape) Error!Edge {
        var out0: Edge = undefined;
        try check(c.cn_shape_get_edge(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shapeGetPolygon(self: World, shape: Shape) Error!Polygon {
        var out0: Polygon = undefined;
        try check(c.cn_shape_get_polygon(self.pointer, shape, &out0));
        return out0;
    }

    /// Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
    /// NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
    /// written).
    /// The caller frees the slice.
    pub fn shapeGetChainPoints(self: World, gpa: std.mem.Allocator, shape: Shape) (Error || std.mem.Allocator.Error)![]Vec2 {
        var found: i32 = 0;
        try check(c.cn_shape_get_chain_points(self.pointer, shape, null, 0, &found));
        const list = try gpa.alloc(Vec2, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_shape_get_chain_points(self.pointer, shape, list.ptr, found, &found));
        return list;
    }

    /// Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
    /// of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
    /// once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
    /// the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
    /// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
    /// CN_ERROR_STATE for another type. O(contacts + shapes of the body).
    pub fn shapeSetCircle(self: World, shape: Shape, circle: *const Circle) Error!void {
        return check(c.cn_shape_set_circle(self.pointer, shape, circle));
    }

    /// Replaces a capsule in place; otherwise as cn_shape_set_circle.
    pub fn shapeSetCapsule(self: World, shape: Shape, capsule: *const Capsule) Error!void {
        return check(c.cn_shape_set_capsule(self.pointer, shape, capsule));
    }

    /// Replaces an edge in place; otherwise as cn_shape_set_circle.
    pub fn shapeSetEdge(self: World, shape: Shape, edge: *const Edge) Error!void {
        return check(c.cn_shape_set_edge(self.pointer, shape, edge));
    }

    /// Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.
    pub fn shapeSetPolygon(self: World, shape: Shape, polygon: *const Polygon) Error!void {
        return check(c.cn_shape_set_polygon(self.pointer, shape, polygon));
    }

    /// Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
    /// begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body +
    /// count).
    pub fn shapeSetChain(self: World, shape: Shape, chain: *const Chain) Error!void {
        return check(c.cn_shape_set_chain(self.pointer, shape, chain));
    }

    /// out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
    /// unattached), else 0. Edges and chains contain no point. O(points).
    pub fn shapeTestPoint(self: World, shape: Shape, point_x_m: f32, point_y_m: f32) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_shape_test_point(self.pointer, shape, point_x_m, point_y_m, &out0));
        return out0;
    }

    /// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
    /// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
    /// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
    /// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
    /// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
    /// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of
    /// the step, and got an impulse; bodies that pass a blow on to others that already touch them, without
    /// closing, have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which
    /// they begin), STAY or HIT.
    pub fn contactEvents(self: World, kind: i32) Error![]const ContactEvent {
        var data: ?[*]const ContactEvent = null;
        var found: i32 = 0;
        try check(c.cn_world_contact_events(self.pointer, kind, &data, &found));
        return if (data) |at| at[0..@intCast(found)] else &.{};
    }

    /// The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
    /// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
    /// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
    /// chains. A pair without an awake body reports nothing until one wakes.
    pub fn sensorEvents(self: World) Error![]const SensorEvent {
        var data: ?[*]const SensorEvent = null;
        var found: i32 = 0;
        try check(c.cn_world_sensor_events(self.pointer, &data, &found));
        return if (data) |at| at[0..@intCast(found)] else &.{};
    }

    /// The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
    /// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
    /// impulses of the last substep. At rest their force is that of the points times substep_count (with
    /// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
    /// *out_count is their number. O(contacts).
    /// The caller frees the slice.
    pub fn bodyGetContacts(self: World, gpa: std.mem.Allocator, body: Body) (Error || std.mem.Allocator.Error)![]ContactEvent {
        var found: i32 = 0;
        try check(c.cn_body_get_contacts(self.pointer, body, null, 0, &found));
        const list = try gpa.alloc(ContactEvent, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_body_get_contacts(self.pointer, body, list.ptr, found, &found));
        return list;
    }

    /// The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
    /// cn_body_get_contacts. O(contacts of its body).
    /// The caller frees the slice.
    pub fn shapeGetContacts(self: World, gpa: std.mem.Allocator, shape: Shape) (Error || std.mem.Allocator.Error)![]ContactEvent {
        var found: i32 = 0;
        try check(c.cn_shape_get_contacts(self.pointer, shape, null, 0, &found));
        const list = try gpa.alloc(ContactEvent, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_shape_get_contacts(self.pointer, shape, list.ptr, found, &found));
        return list;
    }

    /// The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
    /// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
    /// its body), squared for chains.
    /// The caller frees the slice.
    pub fn shapeGetVisitors(self: World, gpa: std.mem.Allocator, sensor: Shape) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_shape_get_visitors(self.pointer, sensor, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_shape_get_visitors(self.pointer, sensor, list.ptr, found, &found));
        return list;
    }

    /// Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
    /// destroyed since are stale.
    pub fn fellAsleep(self: World) Error![]const Body {
        var data: ?[*]const Body = null;
        var found: i32 = 0;
        try check(c.cn_world_fell_asleep(self.pointer, &data, &found));
        return if (data) |at| at[0..@intCast(found)] else &.{};
    }

    /// Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn jointCreateRevolute(self: World, def: *const RevoluteDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_revolute(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn jointCreateDistance(self: World, def: *const DistanceDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_distance(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreateFixed(self: World, def: *const FixedDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_fixed(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn jointCreatePrismatic(self: World, def: *const PrismaticDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_prismatic(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreateWheel(self: World, def: *const WheelDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_wheel(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreateMotor(self: World, def: *const MotorDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_motor(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or body_a is not 0. O(contacts of body_a).
    pub fn jointCreateMouse(self: World, def: *const MouseDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_mouse(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    /// dynamic. O(contacts of body_a).
    pub fn jointCreateGear(self: World, def: *const GearDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_gear(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreatePulley(self: World, def: *const PulleyDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_pulley(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreateRatchet(self: World, def: *const RatchetDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_ratchet(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn jointCreateRotarySpring(self: World, def: *const RotarySpringDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_rotary_spring(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or the slot has no length. O(contacts of body_a).
    pub fn jointCreateGroove(self: World, def: *const GrooveDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_groove(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
    /// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
    /// body_a).
    pub fn jointCreateFilter(self: World, def: *const FilterJointDef) Error!Joint {
        var out0: Joint = undefined;
        try check(c.cn_joint_create_filter(self.pointer, def, &out0));
        return out0;
    }

    /// Destroys a joint and wakes its bodies. No event is reported.
    pub fn jointDestroy(self: World, joint: Joint) Error!void {
        return check(c.cn_joint_destroy(self.pointer, joint));
    }

    /// 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).
    pub fn jointIsValid(self: World, joint: Joint) bool {
        return c.cn_joint_is_valid(self.pointer, joint) != 0;
    }

    /// Reads the type (CN_JOINT_REVOLUTE to _FILTER).
    pub fn jointGetType(self: World, joint: Joint) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_joint_get_type(self.pointer, joint, &out0));
        return out0;
    }

    /// Reads both bodies; 0 stands for the world.
    pub fn jointGetBodies(self: World, joint: Joint) Error!struct { a: Body, b: Body } {
        var out0: Body = undefined;
        var out1: Body = undefined;
        try check(c.cn_joint_get_bodies(self.pointer, joint, &out0, &out1));
        return .{ .a = out0, .b = out1 };
    }

    /// Reads the world positions of both anchors, in metres.
    pub fn jointGetAnchors(self: World, joint: Joint) Error!struct { world_a_m: Vec2, world_b_m: Vec2 } {
        var out0: Vec2 = undefined;
        var out1: Vec2 = undefined;
        try check(c.cn_joint_get_anchors(self.pointer, joint, &out0, &out1));
        return .{ .world_a_m = out0, .world_b_m = out1 };
    }

    /// Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
    /// after a change of type or of CN_BODY_ENABLED of one of its bodies.
    pub fn jointGetReaction(self: World, joint: Joint) Error!struct { force_N: Vec2, torque_Nm: f32 } {
        var out0: Vec2 = undefined;
        var out1: f32 = undefined;
        try check(c.cn_joint_get_reaction(self.pointer, joint, &out0, &out1));
        return .{ .force_N = out0, .torque_Nm = out1 };
    }

    /// Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
    /// (angles beyond limits).
    pub fn jointGetError(self: World, joint: Joint) Error!struct { m: f32, rad: f32 } {
        var out0: f32 = undefined;
        var out1: f32 = undefined;
        try check(c.cn_joint_get_error(self.pointer, joint, &out0, &out1));
        return .{ .m = out0, .rad = out1 };
    }

    /// Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
    /// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
    /// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for
    /// a world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next
    /// step; does not wake.
    pub fn jointSetSolver(self: World, joint: Joint, solver: i32) Error!void {
        return check(c.cn_joint_set_solver(self.pointer, joint, solver));
    }

    /// Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn jointGetSolver(self: World, joint: Joint) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_joint_get_solver(self.pointer, joint, &out0));
        return out0;
    }

    /// Stores a number for the user.
    pub fn jointSetUserData(self: World, joint: Joint, user_data: u64) Error!void {
        return check(c.cn_joint_set_user_data(self.pointer, joint, user_data));
    }

    /// Reads the user's number.
    pub fn jointGetUserData(self: World, joint: Joint) Error!u64 {
        var out0: u64 = undefined;
        try check(c.cn_joint_get_user_data(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn jointSetFlags(self: World, joint: Joint, flags: u32) Error!void {
        return check(c.cn_joint_set_flags(self.pointer, joint, flags));
    }

    /// Reads the CN_JOINT_ flags.
    pub fn jointGetFlags(self: World, joint: Joint) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_joint_get_flags(self.pointer, joint, &out0));
        return out0;
    }

    /// Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
    pub fn jointGetRevolute(self: World, joint: Joint) Error!RevoluteDef {
        var out0: RevoluteDef = undefined;
        try check(c.cn_joint_get_revolute(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetRevolute(self: World, joint: Joint, def: *const RevoluteDef) Error!void {
        return check(c.cn_joint_set_revolute(self.pointer, joint, def));
    }

    /// Reads the definition of a distance joint. CN_ERROR_STATE for another type.
    pub fn jointGetDistance(self: World, joint: Joint) Error!DistanceDef {
        var out0: DistanceDef = undefined;
        try check(c.cn_joint_get_distance(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetDistance(self: World, joint: Joint, def: *const DistanceDef) Error!void {
        return check(c.cn_joint_set_distance(self.pointer, joint, def));
    }

    /// Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
    pub fn jointGetFixed(self: World, joint: Joint) Error!FixedDef {
        var out0: FixedDef = undefined;
        try check(c.cn_joint_get_fixed(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetFixed(self: World, joint: Joint, def: *const FixedDef) Error!void {
        return check(c.cn_joint_set_fixed(self.pointer, joint, def));
    }

    /// Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
    pub fn jointGetPrismatic(self: World, joint: Joint) Error!PrismaticDef {
        var out0: PrismaticDef = undefined;
        try check(c.cn_joint_get_prismatic(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors
    /// and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetPrismatic(self: World, joint: Joint, def: *const PrismaticDef) Error!void {
        return check(c.cn_joint_set_prismatic(self.pointer, joint, def));
    }

    /// Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
    pub fn jointGetWheel(self: World, joint: Joint) Error!WheelDef {
        var out0: WheelDef = undefined;
        try check(c.cn_joint_get_wheel(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetWheel(self: World, joint: Joint, def: *const WheelDef) Error!void {
        return check(c.cn_joint_set_wheel(self.pointer, joint, def));
    }

    /// Reads the definition of a motor joint. CN_ERROR_STATE for another type.
    pub fn jointGetMotorTo(self: World, joint: Joint) Error!MotorDef {
        var out0: MotorDef = undefined;
        try check(c.cn_joint_get_motor_to(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetMotorTo(self: World, joint: Joint, def: *const MotorDef) Error!void {
        return check(c.cn_joint_set_motor_to(self.pointer, joint, def));
    }

    /// Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
    pub fn jointGetMouse(self: World, joint: Joint) Error!MouseDef {
        var out0: MouseDef = undefined;
        try check(c.cn_joint_get_mouse(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
    /// CN_JOINT_COLLIDE changes.
    pub fn jointSetMouse(self: World, joint: Joint, def: *const MouseDef) Error!void {
        return check(c.cn_joint_set_mouse(self.pointer, joint, def));
    }

    /// Reads the definition of a gear joint. CN_ERROR_STATE for another type.
    pub fn jointGetGear(self: World, joint: Joint) Error!GearDef {
        var out0: GearDef = undefined;
        try check(c.cn_joint_get_gear(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn jointSetGear(self: World, joint: Joint, def: *const GearDef) Error!void {
        return check(c.cn_joint_set_gear(self.pointer, joint, def));
    }

    /// Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
    pub fn jointGetPulley(self: World, joint: Joint) Error!PulleyDef {
        var out0: PulleyDef = undefined;
        try check(c.cn_joint_get_pulley(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetPulley(self: World, joint: Joint, def: *const PulleyDef) Error!void {
        return check(c.cn_joint_set_pulley(self.pointer, joint, def));
    }

    /// Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
    pub fn jointGetRatchet(self: World, joint: Joint) Error!RatchetDef {
        var out0: RatchetDef = undefined;
        try check(c.cn_joint_get_ratchet(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn jointSetRatchet(self: World, joint: Joint, def: *const RatchetDef) Error!void {
        return check(c.cn_joint_set_ratchet(self.pointer, joint, def));
    }

    /// Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
    pub fn jointGetRotarySpring(self: World, joint: Joint) Error!RotarySpringDef {
        var out0: RotarySpringDef = undefined;
        try check(c.cn_joint_get_rotary_spring(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetRotarySpring(self: World, joint: Joint, def: *const RotarySpringDef) Error!void {
        return check(c.cn_joint_set_rotary_spring(self.pointer, joint, def));
    }

    /// Reads the definition of a groove joint. CN_ERROR_STATE for another type.
    pub fn jointGetGroove(self: World, joint: Joint) Error!GrooveDef {
        var out0: GrooveDef = undefined;
        try check(c.cn_joint_get_groove(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn jointSetGroove(self: World, joint: Joint, def: *const GrooveDef) Error!void {
        return check(c.cn_joint_set_groove(self.pointer, joint, def));
    }

    /// Reads the base of a joint of any type.
    pub fn jointGetBase(self: World, joint: Joint) Error!JointBase {
        var out0: JointBase = undefined;
        try check(c.cn_joint_get_base(self.pointer, joint, &out0));
        return out0;
    }

    /// Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges
    /// as in cn_joint_base. Wakes both bodies.
    pub fn jointSetBase(self: World, joint: Joint, base: *const JointBase) Error!void {
        return check(c.cn_joint_set_base(self.pointer, joint, base));
    }

    /// Sets the target of a mouse joint, a world point in metres; cheap enough for every frame.
    /// CN_ERROR_STATE for another type. Wakes the body.
    pub fn jointSetTarget(self: World, joint: Joint, target_x_m: f32, target_y_m: f32) Error!void {
        return check(c.cn_joint_set_target(self.pointer, joint, target_x_m, target_y_m));
    }

    /// Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
    /// reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the
    /// translation along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a;
    /// ratchet, rotary spring: angle b - angle a; these three over whole turns.
    pub fn jointGetPosition(self: World, joint: Joint) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_joint_get_position(self.pointer, joint, &out0));
        return out0;
    }

    /// Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
    /// positive motor speed has the same sign.
    pub fn jointGetSpeed(self: World, joint: Joint) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_joint_get_speed(self.pointer, joint, &out0));
        return out0;
    }

    /// Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
    /// prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
    pub fn jointSetMotor(self: World, joint: Joint, speed: f32, force_or_torque_max: f32) Error!void {
        return check(c.cn_joint_set_motor(self.pointer, joint, speed, force_or_torque_max));
    }

    /// Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0),
    /// prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
    pub fn jointSetLimits(self: World, joint: Joint, lower: f32, upper: f32) Error!void {
        return check(c.cn_joint_set_limits(self.pointer, joint, lower, upper));
    }

    /// Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a
    /// body in that step or between it and the step before.
    pub fn jointEvents(self: World) Error![]const JointEvent {
        var data: ?[*]const JointEvent = null;
        var found: i32 = 0;
        try check(c.cn_world_joint_events(self.pointer, &data, &found));
        return if (data) |at| at[0..@intCast(found)] else &.{};
    }

    /// Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn constraintCreateAngle(self: World, def: *const AngleConstraintDef) Error!Constraint {
        var out0: Constraint = undefined;
        try check(c.cn_constraint_create_angle(self.pointer, def, &out0));
        return out0;
    }

    /// Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn constraintCreateLine(self: World, def: *const LineConstraintDef) Error!Constraint {
        var out0: Constraint = undefined;
        try check(c.cn_constraint_create_line(self.pointer, def, &out0));
        return out0;
    }

    /// Destroys a constraint and wakes its body. No event is reported.
    pub fn constraintDestroy(self: World, constraint: Constraint) Error!void {
        return check(c.cn_constraint_destroy(self.pointer, constraint));
    }

    /// 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).
    pub fn constraintIsValid(self: World, constraint: Constraint) bool {
        return c.cn_constraint_is_valid(self.pointer, constraint) != 0;
    }

    /// Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
    pub fn constraintGetType(self: World, constraint: Constraint) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_constraint_get_type(self.pointer, constraint, &out0));
        return out0;
    }

    /// Reads the body.
    pub fn constraintGetBody(self: World, constraint: Constraint) Error!Body {
        var out0: Body = undefined;
        try check(c.cn_constraint_get_body(self.pointer, constraint, &out0));
        return out0;
    }

    /// Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
    pub fn constraintGetAngle(self: World, constraint: Constraint) Error!AngleConstraintDef {
        var out0: AngleConstraintDef = undefined;
        try check(c.cn_constraint_get_angle(self.pointer, constraint, &out0));
        return out0;
    }

    /// Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes
    /// the body.
    pub fn constraintSetAngle(self: World, constraint: Constraint, def: *const AngleConstraintDef) Error!void {
        return check(c.cn_constraint_set_angle(self.pointer, constraint, def));
    }

    /// Reads the definition of a line constraint. CN_ERROR_STATE for another type.
    pub fn constraintGetLine(self: World, constraint: Constraint) Error!LineConstraintDef {
        var out0: LineConstraintDef = undefined;
        try check(c.cn_constraint_get_line(self.pointer, constraint, &out0));
        return out0;
    }

    /// Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
    /// body.
    pub fn constraintSetLine(self: World, constraint: Constraint, def: *const LineConstraintDef) Error!void {
        return check(c.cn_constraint_set_line(self.pointer, constraint, def));
    }

    /// Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
    /// along the axis, in metres from origin.
    pub fn constraintGetPosition(self: World, constraint: Constraint) Error!f32 {
        var out0: f32 = undefined;
        try check(c.cn_constraint_get_position(self.pointer, constraint, &out0));
        return out0;
    }

    /// Force in newtons and torque in newton metres that the constraint applied to the body in the last
    /// substep.
    pub fn constraintGetReaction(self: World, constraint: Constraint) Error!struct { force_N: Vec2, torque_Nm: f32 } {
        var out0: Vec2 = undefined;
        var out1: f32 = undefined;
        try check(c.cn_constraint_get_reaction(self.pointer, constraint, &out0, &out1));
        return .{ .force_N = out0, .torque_Nm = out1 };
    }

    /// Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle
    /// constraint.
    pub fn constraintGetError(self: World, constraint: Constraint) Error!struct { m: f32, rad: f32 } {
        var out0: f32 = undefined;
        var out1: f32 = undefined;
        try check(c.cn_constraint_get_error(self.pointer, constraint, &out0, &out1));
        return .{ .m = out0, .rad = out1 };
    }

    /// Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    /// The caller frees the slice.
    pub fn getConstraints(self: World, gpa: std.mem.Allocator) (Error || std.mem.Allocator.Error)![]Constraint {
        var found: i32 = 0;
        try check(c.cn_world_get_constraints(self.pointer, null, 0, &found));
        const list = try gpa.alloc(Constraint, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_get_constraints(self.pointer, list.ptr, found, &found));
        return list;
    }

    /// Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
    /// constraints of the body).
    /// The caller frees the slice.
    pub fn bodyGetConstraints(self: World, gpa: std.mem.Allocator, body: Body) (Error || std.mem.Allocator.Error)![]Constraint {
        var found: i32 = 0;
        try check(c.cn_body_get_constraints(self.pointer, body, null, 0, &found));
        const list = try gpa.alloc(Constraint, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_body_get_constraints(self.pointer, body, list.ptr, found, &found));
        return list;
    }

    /// Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
    /// update, 1 to 1000, default 8.
    pub fn setFixedStep(self: World, step_s: f32, steps_max: i32) Error!void {
        return check(c.cn_world_set_fixed_step(self.pointer, step_s, steps_max));
    }

    /// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
    /// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
    pub fn update(self: World, elapsed_s: f32) Error!UpdateReport {
        var out0: UpdateReport = undefined;
        try check(c.cn_world_update(self.pointer, elapsed_s, &out0));
        return out0;
    }

    /// Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last
    /// step, 1 after it. Bodies that did not take part in the last step have their present pose. bodies and
    /// count as in cn_world_read_poses. O(count).
    pub fn readPosesInterpolated(self: World, bodies: ?[]const Body, factor: f32, out: []Pose) Error!void {
        if (bodies) |given| if (given.len != out.len) return error.Argument;
        return check(c.cn_world_read_poses_interpolated(self.pointer, if (bodies) |given| given.ptr else null, @intCast(out.len), factor, out.ptr));
    }

    /// Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
    /// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child.
    /// filter may be NULL: the defaults. O(log shapes) to O(shapes along the ray).
    pub fn castRay(self: World, ray: *const Ray, filter: ?*const QueryFilter) Error!RayHit {
        var out0: RayHit = undefined;
        try check(c.cn_world_cast_ray(self.pointer, ray, filter, &out0));
        return out0;
    }

    /// out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL.
    /// O(log shapes) to O(shapes along the ray).
    pub fn castRayAny(self: World, ray: *const Ray, filter: ?*const QueryFilter) Error!i32 {
        var out0: i32 = undefined;
        try check(c.cn_world_cast_ray_any(self.pointer, ray, filter, &out0));
        return out0;
    }

    /// Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found.
    /// A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
    /// The caller frees the slice.
    pub fn castRayAll(self: World, gpa: std.mem.Allocator, ray: *const Ray, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]RayHit {
        var found: i32 = 0;
        try check(c.cn_world_cast_ray_all(self.pointer, ray, filter, null, 0, &found));
        const list = try gpa.alloc(RayHit, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_cast_ray_all(self.pointer, ray, filter, list.ptr, found, &found));
        return list;
    }

    /// Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
    /// filter may be NULL. O(sum of the rays).
    pub fn castRays(self: World, rays: []const Ray, filter: ?*const QueryFilter, out: []RayHit) Error!void {
        if (rays.len != out.len) return error.Argument;
        return check(c.cn_world_cast_rays(self.pointer, rays.ptr, @intCast(out.len), filter, out.ptr));
    }

    /// Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
    /// O(points of the shape).
    pub fn shapeCastRay(self: World, shape: Shape, ray: *const Ray) Error!RayHit {
        var out0: RayHit = undefined;
        try check(c.cn_shape_cast_ray(self.pointer, shape, ray, &out0));
        return out0;
    }

    /// First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
    /// way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or
    /// 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the
    /// moving points is in front of it. filter may be NULL. O(shapes along the way).
    pub fn castShape(self: World, shape: *const Polygon, translation_x_m: f32, translation_y_m: f32, filter: ?*const QueryFilter) Error!RayHit {
        var out0: RayHit = undefined;
        try check(c.cn_world_cast_shape(self.pointer, shape, translation_x_m, translation_y_m, filter, &out0));
        return out0;
    }

    /// Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
    /// cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
    /// filter may be NULL. O(log shapes) to O(boxes in the region).
    /// The caller frees the slice.
    pub fn overlapAabb(self: World, gpa: std.mem.Allocator, box: *const Aabb, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_world_overlap_aabb(self.pointer, box, filter, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_overlap_aabb(self.pointer, box, filter, list.ptr, found, &found));
        return list;
    }

    /// Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
    /// Edges and chains are lines here, seen from both sides.
    /// The caller frees the slice.
    pub fn overlapCircle(self: World, gpa: std.mem.Allocator, circle: *const Circle, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_world_overlap_circle(self.pointer, circle, filter, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_overlap_circle(self.pointer, circle, filter, list.ptr, found, &found));
        return list;
    }

    /// Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
    /// in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
    /// The caller frees the slice.
    pub fn overlapPolygon(self: World, gpa: std.mem.Allocator, polygon: *const Polygon, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_world_overlap_polygon(self.pointer, polygon, filter, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_overlap_polygon(self.pointer, polygon, filter, list.ptr, found, &found));
        return list;
    }

    /// Shapes that contain a world point in metres; order, capacity, filter and cost as in
    /// cn_world_overlap_aabb. Edges and chains contain no point.
    /// The caller frees the slice.
    pub fn overlapPoint(self: World, gpa: std.mem.Allocator, x_m: f32, y_m: f32, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]Shape {
        var found: i32 = 0;
        try check(c.cn_world_overlap_point(self.pointer, x_m, y_m, filter, null, 0, &found));
        const list = try gpa.alloc(Shape, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_world_overlap_point(self.pointer, x_m, y_m, filter, list.ptr, found, &found));
        return list;
    }

    /// Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
    /// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
    pub fn closestPoint(self: World, x_m: f32, y_m: f32, distance_max_m: f32, filter: ?*const QueryFilter) Error!Closest {
        var out0: Closest = undefined;
        try check(c.cn_world_closest_point(self.pointer, x_m, y_m, distance_max_m, filter, &out0));
        return out0;
    }

    /// Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape)
    /// moved by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of
    /// least separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a
    /// one-way shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the
    /// length unit plus its rise in the last step. Shapes wholly behind the plane of another shape are left
    /// out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby,
    /// squared).
    /// The caller frees the slice.
    pub fn moverCollide(self: World, gpa: std.mem.Allocator, shape: *const Polygon, position_x_m: f32, position_y_m: f32, margin_m: f32, filter: ?*const QueryFilter) (Error || std.mem.Allocator.Error)![]Plane {
        var found: i32 = 0;
        try check(c.cn_mover_collide(self.pointer, shape, position_x_m, position_y_m, margin_m, filter, null, 0, &found));
        const list = try gpa.alloc(Plane, @intCast(found));
        errdefer gpa.free(list);
        if (found > 0) try check(c.cn_mover_collide(self.pointer, shape, position_x_m, position_y_m, margin_m, filter, list.ptr, found, &found));
        return list;
    }

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
    pub fn moverMove(self: World, def: *const MoverDef, dt_s: f32, mover: *Mover) Error!void {
        return check(c.cn_mover_move(self.pointer, def, dt_s, mover));
    }

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
    pub fn shapeSetArea(self: World, shape: Shape, def: ?*const AreaDef) Error!void {
        return check(c.cn_shape_set_area(self.pointer, shape, def));
    }

    /// Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
    pub fn shapeGetArea(self: World, shape: Shape) Error!AreaDef {
        var out0: AreaDef = undefined;
        try check(c.cn_shape_get_area(self.pointer, shape, &out0));
        return out0;
    }

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
    pub fn shapeApplyWind(self: World, shape: Shape, flow_x_mps: f32, flow_y_mps: f32, drag_kgpm2: f32, lift_kgpm2: f32, dt_s: f32, wake: i32) Error!void {
        return check(c.cn_shape_apply_wind(self.pointer, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake));
    }

    /// Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
    /// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
    pub fn explode(self: World, def: *const ExplosionDef) Error!void {
        return check(c.cn_world_explode(self.pointer, def));
    }
};

/// A dynamic AABB tree apart from any world.
pub const Tree = struct {
    pointer: *c.cn_tree,

    pub fn init(margin_m: f32) Error!Tree {
        var pointer: ?*c.cn_tree = null;
        try check(c.cn_tree_create(margin_m, null, null, null, &pointer));
        return .{ .pointer = pointer.? };
    }

    pub fn deinit(self: Tree) void {
        c.cn_tree_destroy(self.pointer);
    }

    /// Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
    pub fn insert(self: Tree, box: *const Aabb, user_data: u64) Error!u32 {
        var out0: u32 = undefined;
        try check(c.cn_tree_insert(self.pointer, box, user_data, &out0));
        return out0;
    }

    /// Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
    pub fn remove(self: Tree, item: u32) Error!void {
        return check(c.cn_tree_remove(self.pointer, item));
    }

    /// Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log
    /// n). CN_ERROR_HANDLE for a stale item.
    pub fn move(self: Tree, item: u32, box: *const Aabb) Error!void {
        return check(c.cn_tree_move(self.pointer, item, box));
    }

    /// Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
    pub fn getBox(self: Tree, item: u32) Error!Aabb {
        var out0: Aabb = undefined;
        try check(c.cn_tree_get_box(self.pointer, item, &out0));
        return out0;
    }

    /// Reads the number of items and the height of the tree.
    pub fn getStats(self: Tree) Error!struct { count: i32, height: i32 } {
        var out0: i32 = undefined;
        var out1: i32 = undefined;
        try check(c.cn_tree_get_stats(self.pointer, &out0, &out1));
        return .{ .count = out0, .height = out1 };
    }
};

/// Version of the library as major * 1000000 + minor * 1000 + patch.
pub fn version() i32 {
    return c.cn_version();
}

/// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
pub fn abiVersion() i32 {
    return c.cn_abi_version();
}

/// English text for a result code: static, never NULL.
pub fn resultText(result: i32) [:0]const u8 {
    return std.mem.span(c.cn_result_text(result));
}

/// Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
pub fn saveDeltaSize(base: []const u8, save_: []const u8) Error!u64 {
    var out0: u64 = undefined;
    try check(c.cn_save_delta_size(base.ptr, base.len, save_.ptr, save_.len, &out0));
    return out0;
}

/// Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
/// The caller frees the slice.
pub fn saveDelta(gpa: std.mem.Allocator, base: []const u8, save_: []const u8) (Error || std.mem.Allocator.Error)![]u8 {
    var room: u64 = 0;
    try check(c.cn_save_delta_size(base.ptr, base.len, save_.ptr, save_.len, &room));
    const list = try gpa.alloc(u8, @intCast(room));
    errdefer gpa.free(list);
    try check(c.cn_save_delta(base.ptr, base.len, save_.ptr, save_.len, list.ptr, list.len, &room));
    return if (gpa.resize(list, @intCast(room))) list[0..@intCast(room)] else gpa.realloc(list, @intCast(room));
}

/// Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
/// CN_ERROR_CAPACITY if out is too small. O(bytes).
/// The caller frees the slice.
pub fn saveApply(gpa: std.mem.Allocator, base: []const u8, delta: []const u8) (Error || std.mem.Allocator.Error)![]u8 {
    var room: u64 = base.len + delta.len;
    const list = try gpa.alloc(u8, @intCast(room));
    errdefer gpa.free(list);
    try check(c.cn_save_apply(base.ptr, base.len, delta.ptr, delta.len, list.ptr, list.len, &room));
    return if (gpa.resize(list, @intCast(room))) list[0..@intCast(room)] else gpa.realloc(list, @intCast(room));
}

/// Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
/// O(count^2) at worst.
pub fn polygonMakeHull(points_m: []const Vec2, radius_m: f32) Error!Polygon {
    var out0: Polygon = undefined;
    try check(c.cn_polygon_make_hull(points_m.ptr, @intCast(points_m.len), radius_m, &out0));
    return out0;
}

/// A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
/// (|angle| <= 1e4); radius_m >= 0.
pub fn polygonMakeBox(half_width_m: f32, half_height_m: f32, center_x_m: f32, center_y_m: f32, angle_rad: f32, radius_m: f32) Error!Polygon {
    var out0: Polygon = undefined;
    try check(c.cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, &out0));
    return out0;
}

/// Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
/// thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
/// area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
/// *out_count is the number of all. 34 KB of stack. O(count^2).
/// The caller frees the slice.
pub fn outlineDecompose(gpa: std.mem.Allocator, points_m: []const Vec2, length_unit_m: f32) (Error || std.mem.Allocator.Error)![]Polygon {
    var found: i32 = 0;
    try check(c.cn_outline_decompose(points_m.ptr, @intCast(points_m.len), length_unit_m, null, 0, &found));
    const list = try gpa.alloc(Polygon, @intCast(found));
    errdefer gpa.free(list);
    if (found > 0) try check(c.cn_outline_decompose(points_m.ptr, @intCast(points_m.len), length_unit_m, list.ptr, found, &found));
    return list;
}

/// Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
/// points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst.
/// The caller frees the slice.
pub fn outlineSimplify(gpa: std.mem.Allocator, points_m: []const Vec2, closed: i32, tolerance_m: f32) (Error || std.mem.Allocator.Error)![]Vec2 {
    var found: i32 = 0;
    try check(c.cn_outline_simplify(points_m.ptr, @intCast(points_m.len), closed, tolerance_m, null, 0, &found));
    const list = try gpa.alloc(Vec2, @intCast(found));
    errdefer gpa.free(list);
    if (found > 0) try check(c.cn_outline_simplify(points_m.ptr, @intCast(points_m.len), closed, tolerance_m, list.ptr, found, &found));
    return list;
}

/// An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
/// squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
/// column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
/// 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
/// counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
/// touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
/// (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
/// boundary of n edges.
/// The caller frees the slice.
pub fn outlineFromCells(gpa: std.mem.Allocator, cells: []const u8, columns: i32, origin_x_m: f32, origin_y_m: f32, cell_m: f32, outline: i32) (Error || std.mem.Allocator.Error)![]Vec2 {
    var found: i32 = 0;
    try check(c.cn_outline_from_cells(cells.ptr, @intCast(cells.len), columns, origin_x_m, origin_y_m, cell_m, outline, null, 0, &found));
    const list = try gpa.alloc(Vec2, @intCast(found));
    errdefer gpa.free(list);
    if (found > 0) try check(c.cn_outline_from_cells(cells.ptr, @intCast(cells.len), columns, origin_x_m, origin_y_m, cell_m, outline, list.ptr, found, &found));
    return list;
}

/// The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
/// least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).
/// The caller frees the slice.
pub fn outlineFromField(gpa: std.mem.Allocator, values: []const f32, columns: i32, threshold: f32, origin_x_m: f32, origin_y_m: f32, spacing_m: f32, outline: i32) (Error || std.mem.Allocator.Error)![]Vec2 {
    var found: i32 = 0;
    try check(c.cn_outline_from_field(values.ptr, @intCast(values.len), columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, null, 0, &found));
    const list = try gpa.alloc(Vec2, @intCast(found));
    errdefer gpa.free(list);
    if (found > 0) try check(c.cn_outline_from_field(values.ptr, @intCast(values.len), columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, list.ptr, found, &found));
    return list;
}

/// Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).
pub fn polygonDistance(a: *const Polygon, pose_a: *const Pose, b: *const Polygon, pose_b: *const Pose) Error!Distance {
    var out0: Distance = undefined;
    try check(c.cn_polygon_distance(a, pose_a, b, pose_b, &out0));
    return out0;
}

/// Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
/// as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
pub fn polygonCast(a: *const Polygon, pose_a: *const Pose, b: *const Polygon, pose_b: *const Pose, translation_x_m: f32, translation_y_m: f32) Error!struct { out: RayHit, hit: i32 } {
    var out0: RayHit = undefined;
    var out1: i32 = undefined;
    try check(c.cn_polygon_cast(a, pose_a, b, pose_b, translation_x_m, translation_y_m, &out0, &out1));
    return .{ .out = out0, .hit = out1 };
}

/// Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
/// to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
/// O(points).
pub fn polygonCollide(a: *const Polygon, pose_a: *const Pose, b: *const Polygon, pose_b: *const Pose, margin_m: f32) Error!Manifold {
    var out0: Manifold = undefined;
    try check(c.cn_polygon_collide(a, pose_a, b, pose_b, margin_m, &out0));
    return out0;
}

/// First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
/// hit. Needs no world; runs in any thread.
pub fn polygonTimeOfImpact(a: *const Polygon, sweep_a: *const Sweep, b: *const Polygon, sweep_b: *const Sweep, distance_m: f32) Error!Impact {
    var out0: Impact = undefined;
    try check(c.cn_polygon_time_of_impact(a, sweep_a, b, sweep_b, distance_m, &out0));
    return out0;
}

/// The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
/// of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
/// limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.
pub fn moverSolve(planes: []Plane, translation_x_m: f32, translation_y_m: f32) Error!struct { translation_m: Vec2, overlap_m: f32 } {
    var out0: Vec2 = undefined;
    var out1: f32 = undefined;
    try check(c.cn_mover_solve(planes.ptr, @intCast(planes.len), translation_x_m, translation_y_m, &out0, &out1));
    return .{ .translation_m = out0, .overlap_m = out1 };
}

/// The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
/// cn_mover_solve. Needs no world. O(count^2).
pub fn moverClip(planes: []const Plane, velocity_x_mps: f32, velocity_y_mps: f32) Error!Vec2 {
    var out0: Vec2 = undefined;
    try check(c.cn_mover_clip(planes.ptr, @intCast(planes.len), velocity_x_mps, velocity_y_mps, &out0));
    return out0;
}
