//! Drops eight boxes and prints where they are, four times a second; one call a frame reads all poses.
//! zig build-exe -lc -Lbuild -lcairn --dep cairn -Mroot=bindings/zig/example.zig -Mcairn=bindings/zig/cairn.zig
const std = @import("std");
const cn = @import("cairn");

var world: ?*cn.cn_world = null;

fn check(result: cn.cn_result) !void {
    if (result == cn.CN_OK) return;
    std.debug.print("{s}\n", .{cn.cn_world_error_text(world)});
    return error.Cairn;
}

fn addBox(kind: i32, x: f32, y: f32, half_width: f32, half_height: f32) !cn.cn_body {
    var body_def: cn.cn_body_def = undefined;
    var shape_def: cn.cn_shape_def = undefined;
    var body: cn.cn_body = .none;
    cn.cn_body_def_init(&body_def);
    body_def.type = kind;
    body_def.position_m = .{ .x = x, .y = y };
    try check(cn.cn_body_create(world.?, &body_def, &body));
    cn.cn_shape_def_init(&shape_def);
    shape_def.body = body;
    try check(cn.cn_shape_create_box(world.?, &shape_def, half_width, half_height, 0, null));
    return body;
}

pub fn main() !void {
    var world_def: cn.cn_world_def = undefined;
    try cn.check();
    cn.cn_world_def_init(&world_def); // gravity (0, -10) m/s^2
    try check(cn.cn_world_create(&world_def, &world));
    _ = try addBox(cn.CN_BODY_STATIC, 0, -1, 20, 1);
    var boxes: [8]cn.cn_body = undefined;
    var poses: [8]cn.cn_pose = undefined;
    for (&boxes, 0..) |*box, i| box.* = try addBox(cn.CN_BODY_DYNAMIC, 5 + 0.25 * @as(f32, @floatFromInt(i)), 2 + 1.5 * @as(f32, @floatFromInt(i)), 0.5, 0.5);
    for (1..121) |frame| {
        try check(cn.cn_world_step(world.?, 1.0 / 60.0));
        try check(cn.cn_world_read_poses(world.?, &boxes, boxes.len, &poses));
        if (frame % 15 != 0) continue;
        std.debug.print("{d:.2} s:", .{@as(f32, @floatFromInt(frame)) / 60.0});
        for (poses) |pose| std.debug.print(" ({d:.2}, {d:.2})", .{ pose.position_m.x, pose.position_m.y });
        std.debug.print("\n", .{});
    }
    cn.cn_world_destroy(world);
}
