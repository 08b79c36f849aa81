//! The falling-hinges scene of examples/scenes/joints.c through layer.zig; prints what bindings/test/hinges.c
//! prints. Constants are f32 by name: Zig would compute with more digits else.
const std = @import("std");
const cairn = @import("cairn");
const c = cairn.c;

const half: f32 = 0.25;
const radius: f32 = 0.025;
const lean: f32 = 0.06;
const pi: f32 = 3.14159265;

var world: cairn.World = undefined;

fn createBody(kind: i32, x: f32, y: f32) !cairn.Body {
    var def = cairn.defaultBodyDef();
    def.type = kind;
    def.position_m = .{ .x = x, .y = y };
    return world.bodyCreate(&def);
}

fn addBox(body: cairn.Body, friction: f32, half_width: f32, half_height: f32, rounding: f32) !void {
    var def = cairn.defaultShapeDef();
    def.body = body;
    def.material.static_friction = friction;
    def.material.dynamic_friction = friction;
    _ = try world.shapeCreateBox(&def, half_width, half_height, rounding);
}

fn join(below: cairn.Body, body: cairn.Body) !void {
    var def = cairn.defaultRevoluteDef();
    def.base.body_a = below;
    def.base.body_b = body;
    def.base.anchor_a_m = .{ .x = half, .y = half };
    def.base.anchor_b_m = .{ .x = half - lean, .y = -half };
    def.base.flags = c.CN_JOINT_LIMIT;
    def.lower_angle_rad = @as(f32, -0.3) * pi;
    def.upper_angle_rad = @as(f32, 0.1) * pi;
    _ = try world.jointCreateRevolute(&def);
}

fn addColumn(x: f32, rows: i32) !void {
    var below: cairn.Body = .none;
    var i: i32 = 0;
    while (i < rows) : (i += 1) {
        const row: f32 = @floatFromInt(i);
        const body = try createBody(c.CN_BODY_DYNAMIC, x + lean * row, half + 2.0 * half * row);
        try addBox(body, 0.3, half - radius, half - radius, radius);
        if (@rem(i, 2) == 1) try join(below, body);
        below = body;
    }
}

fn countCall(_: *c.cn_world, event: *const cairn.ContactEvent, user: ?*anyopaque) callconv(.c) void {
    const called: *i32 = @ptrCast(@alignCast(user));
    if (event.kind == c.CN_EVENT_ENTER) called.* += 1;
}

// Every function is looked at.
comptime {
    @setEvalBranchQuota(10000);
    for (std.meta.declarations(cairn.World)) |name| _ = &@field(cairn.World, name);
    for (std.meta.declarations(cairn.Tree)) |name| _ = &@field(cairn.Tree, name);
    for (std.meta.declarations(cairn)) |name| _ = &@field(cairn, name);
}

fn checks(gpa: std.mem.Allocator) !void {
    if (world.step(-1.0)) |_| return error.NegativeStep else |err| if (err != error.Argument) return err;
    if (std.mem.indexOf(u8, world.errorText(), "dt_s") == null) return error.NoSentence;
    const body = try createBody(c.CN_BODY_DYNAMIC, 0.0, 0.0);
    var poses: [2]cairn.Pose = undefined;
    if (world.readPoses(&.{body}, &poses)) |_| return error.UnevenSlices else |_| {}
    try world.bodySetName(body, "crate");
    if (!std.mem.eql(u8, try world.bodyGetName(body), "crate")) return error.OtherName;
    const saved = try world.save(gpa);
    defer gpa.free(saved);
    const before = try world.hash();
    try world.step(0.1);
    const later = try world.save(gpa);
    defer gpa.free(later);
    const delta = try cairn.saveDelta(gpa, saved, later);
    defer gpa.free(delta);
    const again = try cairn.saveApply(gpa, saved, delta);
    defer gpa.free(again);
    if (!std.mem.eql(u8, again, later) or delta.len >= saved.len) return error.OtherSave;
    try world.restore(saved);
    if (try world.hash() != before) return error.OtherWorld;
    const file = try world.write(gpa);
    defer gpa.free(file);
    const read = try cairn.World.read(file, null);
    defer read.deinit();
    if (try read.hash() != before) return error.OtherFile;
    if (cairn.World.read("no world", null)) |_| return error.ReadNothing else |err| if (err != error.Format) return err;
}

pub fn main() !void {
    const columns = 4;
    const rows = 30;
    const steps = 480;
    const gpa = std.heap.c_allocator;
    try c.check();
    world = try cairn.World.init(&cairn.defaultWorldDef());
    try checks(gpa);
    world.deinit();
    world = try cairn.World.init(&cairn.defaultWorldDef());
    defer world.deinit();
    try addBox(try createBody(c.CN_BODY_STATIC, 0.0, -1.0), 0.6, 30.0, 1.0, 0.0);
    var j: f32 = 0.0;
    while (j < columns) : (j += 1.0)
        try addColumn(@as(f32, 2.5) * j - @as(f32, 0.5) * 2.5 * (columns - 1), rows);

    const bodies = try world.getBodies(gpa);
    defer gpa.free(bodies);
    const poses = try gpa.alloc(cairn.Pose, bodies.len);
    defer gpa.free(poses);
    var sum: u32 = 0;
    var entered: usize = 0;
    var called: i32 = 0;
    if (c.cn_world_set_contact_callback(world.pointer, c.CN_EVENT_ENTER, countCall, &called) != c.CN_OK) return error.Callback;
    for (0..steps) |_| {
        try world.step(1.0 / 60.0);
        try world.readPoses(null, poses);
        entered += (try world.contactEvents(c.CN_EVENT_ENTER)).len;
        for (std.mem.bytesAsSlice(u32, std.mem.sliceAsBytes(poses))) |word| sum = sum *% 31 +% word;
    }
    const format = "falling_hinges: {d} steps, {d} bodies, {d} entered, {d} called, poses {x:0>8}, hash {x:0>16}\n";
    std.debug.print(format, .{ steps, poses.len, entered, called, sum, try world.hash() });
}
