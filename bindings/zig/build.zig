//! The package: the module cairn (layer.zig, with the functions of C in c) and in it the library, compiled from the one file
//! that `make amalgamation` writes. -Dsource names another; a relative path is from where zig runs.
const std = @import("std");

pub fn build(b: *std.Build) void {
    const target = b.standardTargetOptions(.{});
    const optimize = b.standardOptimizeOption(.{});
    const source = b.option([]const u8, "source", "path of cairn.c") orelse "../../build/amalgamation/cairn.c";
    const module = b.addModule("cairn", .{ .root_source_file = b.path("layer.zig"), .target = target, .optimize = optimize, .link_libc = true });
    // Without vectors: Zig links no library that asks the processor for AVX2. The results are the same bits.
    module.addCSourceFile(.{ .file = .{ .cwd_relative = source }, .flags = &.{ "-std=c99", "-fno-sanitize=undefined", "-DCN_NO_SIMD" } });
    if (b.option([]const u8, "program", "a program to build with it, for tests")) |program| {
        const root = b.createModule(.{ .root_source_file = .{ .cwd_relative = program }, .target = target, .optimize = optimize, .link_libc = true });
        root.addImport("cairn", module);
        b.installArtifact(b.addExecutable(.{ .name = "program", .root_module = root }));
    }
}
