//! The package: the module cairn (layer.zig, C's functions as cairn.c) with the library compiled in from its one file, source/cairn.c
//! or what `make amalgamation` writes. -Dsource names another.
const std = @import("std");

pub fn build(b: *std.Build) void {
    const target = b.standardTargetOptions(.{});
    const optimize = b.standardOptimizeOption(.{});
    const source = b.option([]const u8, "source", "path of cairn.c") orelse b.pathFromRoot("../../build/amalgamation/cairn.c");
    const module = b.addModule("cairn", .{ .root_source_file = b.path("layer.zig"), .target = target, .optimize = optimize, .link_libc = true });
    module.addCSourceFile(.{ .file = .{ .cwd_relative = source }, .flags = &.{ "-std=c99", "-fno-sanitize=undefined" } });
    if (b.option([]const u8, "program", "a program to build with it, for tests")) |program| {
        const root = b.createModule(.{ .root_source_file = .{ .cwd_relative = program }, .target = target, .optimize = optimize, .link_libc = true });
        root.addImport("cairn", module);
        b.installArtifact(b.addExecutable(.{ .name = "program", .root_module = root }));
    }
}
