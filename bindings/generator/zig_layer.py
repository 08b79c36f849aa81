"""Writes zig/layer.zig: error unions, slices and values above zig/cairn.zig, made of idiom.py."""
import copy

from . import idiom, names, zig

START = """//! Cairn for Zig: error unions and slices. %s
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

"""
WORLD = """
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

"""
TREE = """
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
"""


def typed(base, api):
    if base in {entry["name"] for entry in api["scalars"]}:
        return "i32"
    return idiom.type_name(base) if base.startswith("cn_") else zig.element({"base": base, "pointers": 0}, api)


def shadowless(api):
    """The api with parameters that no declaration of the layer has as its name, as Zig demands."""
    api, declared = copy.deepcopy(api), {"read", "init", "deinit", "check", "c", "std"}
    for owner in ("world", "tree", ""):
        declared |= {idiom.camel(call["name"]) for call in idiom.methods(api, owner)}
    for part in (part for function in api["functions"] for part in function["parameters"]):
        part["name"] += "_" if part["name"] in declared else ""
    return api


def write(api):
    api = shadowless(api)
    out = [START % names.NOTICE]
    out += ["pub const %s = c.%s;\n" % (idiom.type_name(entry["name"]), entry["name"]) for kind in ("handles", "structs") for entry in api[kind]]
    for struct, init in idiom.inits(api).items():
        name = idiom.type_name(struct)
        out.append("\npub fn default%s() %s {\n    var value: %s = undefined;\n    c.%s(&value);\n    return value;\n}\n" % (name, name, name, init))
    for text, owner in ((WORLD, "world"), (TREE, "tree")):
        out += [text] + [write_call(call, api, "    ") for call in idiom.methods(api, owner)] + ["};\n"]
    return "".join(out + [write_call(call, api, "") for call in idiom.methods(api, "")])


def parameter(entry, api):
    base = typed(entry["base"], api)
    kind = {"value": base, "struct": "*const " + base, "change": "*" + base, "array": "[]const " + base, "fill": "[]" + base, "changes": "[]" + base, "string": "[:0]const u8", "bytes": "[]const u8"}[entry["kind"]]
    return "%s: %s%s" % (zig.safe(entry["name"]), "?" if entry["nullable"] else "", kind)


def write_call(call, api, indent):
    inputs, owner, outputs, body = {entry["name"]: entry for entry in call["inputs"]}, call["owner"], call["outputs"], []
    for entry in call["inputs"]:
        if entry["length"] == "count" and entry is not idiom.counted(call):
            name, base = entry["name"], idiom.counted(call)["name"]
            body.append(("if (%s) |given| if (given.len != %s.len) return error.Argument;" if entry["nullable"] else "if (%s.len != %s.len) return error.Argument;") % (name, base))
    arguments = ["self.pointer"] if owner else []
    for part in call["parameters"][len(arguments) :]:
        entry = inputs.get(part["name"])
        if entry is None:
            arguments += ["@intCast(%s.len)" % idiom.counted(call)["name"]] if part["name"] == "count" else ["%s.len" % idiom.bytes_of(call, part)["name"]] if idiom.bytes_of(call, part) else []
        elif entry["kind"] in ("array", "fill", "changes", "bytes") or entry["kind"] == "string":
            arguments.append("if (%s) |given| given.ptr else null" % entry["name"] if entry["nullable"] else entry["name"] + ".ptr")
        else:
            arguments.append(zig.safe(entry["name"]))
    lists = bool(outputs) and outputs[0]["kind"] in ("list", "bytes")
    parameters = (["self: " + owner.capitalize()] if owner else []) + (["gpa: std.mem.Allocator"] if lists else []) + [parameter(entry, api) for entry in call["inputs"]]
    kinds = [{"value": "%s", "list": "[]%s", "view": "[]const %s", "string": "[:0]const u8", "bytes": "[]u8"}[entry["kind"]].replace("%s", "u8" if entry["kind"] == "bytes" else typed(entry["base"], api)) for entry in outputs]
    value = "void" if not kinds else kinds[0] if len(kinds) == 1 else "struct { %s }" % ", ".join("%s: %s" % (entry["name"], kind) for entry, kind in zip(outputs, kinds))
    result = "(Error || std.mem.Allocator.Error)!" + value if lists else "Error!" + value
    if call["result"] != "error":
        result = "[:0]const u8" if "char" in call["result"] else "bool" if call["name"].endswith("is_valid") else typed(call["result"], api)
    body += results(call, arguments, kinds, api)
    doc = zig.doc_comment(call, indent) + ("%s/// The caller frees the slice.\n" % indent if lists else "")
    return "\n" + doc + "%spub fn %s(%s) %s {\n" % (indent, zig.safe(idiom.camel(call["name"])), ", ".join(parameters), result) + "".join("%s    %s\n" % (indent, line) for line in body) + indent + "}\n"


def results(call, arguments, kinds, api):
    outputs = call["outputs"]
    invoke = lambda extra: "c.%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    if call["result"] != "error":
        return ["return %s;" % ("std.mem.span(%s)" % invoke([]) if "char" in call["result"] else invoke([]) + (" != 0" if call["name"].endswith("is_valid") else ""))]
    if not outputs:
        return ["return check(%s);" % invoke([])]
    if outputs[0]["kind"] == "bytes":
        size = ["var room: u64 = 0;", "try check(c.%s(%s));" % (call["room"], ", ".join([*arguments, "&room"]))] if call["room"] else ["var room: u64 = %s;" % " + ".join(name + ".len" for name in idiom.bytes_in(call))]
        return [*size, "const list = try gpa.alloc(u8, @intCast(room));", "errdefer gpa.free(list);", "try check(%s);" % invoke(["list.ptr", "list.len", "&room"]),
            "return if (gpa.resize(list, @intCast(room))) list[0..@intCast(room)] else gpa.realloc(list, @intCast(room));"]  # fmt: skip
    base = typed(outputs[0]["base"], api)
    if outputs[0]["kind"] == "list":
        return ["var found: i32 = 0;", "try check(%s);" % invoke(["null", "0", "&found"]), "const list = try gpa.alloc(%s, @intCast(found));" % base, "errdefer gpa.free(list);",
            "if (found > 0) try check(%s);" % invoke(["list.ptr", "found", "&found"]), "return list;"]  # fmt: skip
    if outputs[0]["kind"] == "view":
        return ["var data: ?[*]const %s = null;" % base, "var found: i32 = 0;", "try check(%s);" % invoke(["&data", "&found"]), "return if (data) |at| at[0..@intCast(found)] else &.{};"]
    if outputs[0]["kind"] == "string":
        return ["var text: ?[*:0]const u8 = null;", "try check(%s);" % invoke(["&text"]), "return std.mem.span(text.?);"]
    lines = ["var out%d: %s = undefined;" % pair for pair in enumerate(kinds)] + ["try check(%s);" % invoke(["&out%d" % i for i in range(len(kinds))])]
    return lines + ["return out0;" if len(kinds) == 1 else "return .{ %s };" % ", ".join(".%s = out%d" % (entry["name"], i) for i, entry in enumerate(outputs))]
