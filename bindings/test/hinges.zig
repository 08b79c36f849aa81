//! The falling-hinges scene of examples/scenes/joints.c through the Zig binding; prints what
//! bindings/test/hinges.c prints. Constants are f32 by name: Zig would compute with more digits else.
const std = @import("std");
const cn = @import("cairn");

const half: f32 = 0.25;
const radius: f32 = 0.025;
const lean: f32 = 0.06;
const pi: f32 = 3.14159265;

var world: ?*cn.cn_world = null;

fn check(result: cn.cn_result) error{Cairn}!void {
    if (result == cn.CN_OK) return;
    std.debug.print("{s}: {s}\n", .{ cn.cn_result_text(result), cn.cn_world_error_text(world) });
    return error.Cairn;
}

fn createBody(kind: i32, x: f32, y: f32) !cn.cn_body {
    var def: cn.cn_body_def = undefined;
    var body: cn.cn_body = .none;
    cn.cn_body_def_init(&def);
    def.type = kind;
    def.position_m = .{ .x = x, .y = y };
    try check(cn.cn_body_create(world.?, &def, &body));
    return body;
}

fn addBox(body: cn.cn_body, friction: f32, half_width: f32, half_height: f32, rounding: f32) !void {
    var def: cn.cn_shape_def = undefined;
    cn.cn_shape_def_init(&def);
    def.body = body;
    def.material.static_friction = friction;
    def.material.dynamic_friction = friction;
    try check(cn.cn_shape_create_box(world.?, &def, half_width, half_height, rounding, null));
}

fn join(below: cn.cn_body, body: cn.cn_body) !void {
    var def: cn.cn_revolute_def = undefined;
    var joint: cn.cn_joint = .none;
    cn.cn_revolute_def_init(&def);
    def.base.body_a = below;
    def.base.body_b = body;
    def.base.anchor_a_m = .{ .x = half, .y = half };
    def.base.anchor_b_m = .{ .x = half - lean, .y = -half };
    def.base.flags = cn.CN_JOINT_LIMIT;
    def.lower_angle_rad = @as(f32, -0.3) * pi;
    def.upper_angle_rad = @as(f32, 0.1) * pi;
    try check(cn.cn_joint_create_revolute(world.?, &def, &joint));
}

fn addColumn(x: f32, rows: i32) !void {
    var below: cn.cn_body = .none;
    var i: i32 = 0;
    while (i < rows) : (i += 1) {
        const row: f32 = @floatFromInt(i);
        const body = try createBody(cn.CN_BODY_DYNAMIC, x + lean * row, half + 2.0 * half * row);
        try addBox(body, 0.3, half - radius, half - radius, radius);
        if (@rem(i, 2) == 1) try join(below, body);
        below = body;
    }
}

fn countCall(_: *cn.cn_world, event: *const cn.cn_contact_event, user: ?*anyopaque) callconv(.c) void {
    const called: *i32 = @ptrCast(@alignCast(user));
    if (event.kind == cn.CN_EVENT_ENTER) called.* += 1;
}

// Every declaration is looked at and every function linked.
comptime {
    @setEvalBranchQuota(10000);
    for (std.meta.declarations(cn)) |name| _ = &@field(cn, name);
}

pub fn main() !void {
    const columns = 4;
    const rows = 30;
    const steps = 480;
    try cn.check();
    var def: cn.cn_world_def = undefined;
    cn.cn_world_def_init(&def);
    try check(cn.cn_world_create(&def, &world));
    try addBox(try createBody(cn.CN_BODY_STATIC, 0.0, -1.0), 0.6, 30.0, 1.0, 0.0);
    var j: f32 = 0.0;
    while (j < columns) : (j += 1.0)
        try addColumn(@as(f32, 2.5) * j - @as(f32, 0.5) * 2.5 * (columns - 1), rows);

    var count: i32 = 0;
    var storage: [256]cn.cn_pose = undefined;
    try check(cn.cn_world_get_bodies(world.?, null, 0, &count));
    const poses = storage[0..@intCast(count)];
    var sum: u32 = 0;
    var events: ?[*]const cn.cn_contact_event = null;
    var event_count: i32 = 0;
    var entered: i32 = 0;
    var called: i32 = 0;
    try check(cn.cn_world_set_contact_callback(world.?, cn.CN_EVENT_ENTER, countCall, &called));
    for (0..steps) |_| {
        try check(cn.cn_world_step(world.?, 1.0 / 60.0));
        try check(cn.cn_world_read_poses(world.?, null, count, poses.ptr));
        try check(cn.cn_world_contact_events(world.?, cn.CN_EVENT_ENTER, &events, &event_count));
        entered += event_count;
        for (std.mem.bytesAsSlice(u32, std.mem.sliceAsBytes(poses))) |word| sum = sum *% 31 +% word;
    }

    var hash: u64 = 0;
    try check(cn.cn_world_hash(world.?, &hash));
    const format = "falling_hinges: {d} steps, {d} bodies, {d} entered, {d} called, poses {x:0>8}, hash {x:0>16}\n";
    std.debug.print(format, .{ steps, poses.len, entered, called, sum, hash });
    cn.cn_world_destroy(world);
}
