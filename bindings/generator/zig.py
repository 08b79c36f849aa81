"""Writes zig/cairn.zig: extern declarations, without @cImport (gone in Zig 0.17).

Handles are enums of 32 bits, so that a shape is never taken for a body. Pointers are *T, [*]T and [*:0]u8, with ? where null is
allowed.
"""
from . import names

START = """//! Cairn for Zig, one to one with cairn.h.
//! %s
//!
//!     const cn = @import("cairn");
//!     var def: cn.cn_world_def = undefined;
//!     cn.cn_world_def_init(&def);
//!     var world: ?*cn.cn_world = null;
//!     if (cn.cn_world_create(&def, &world) != cn.CN_OK) return error.Cairn;

"""
CHECK = """
/// A library of another version would read other structs: call this once before anything else.
pub fn check() error{WrongLibrary}!void {
    if (cn_abi_version() != CN_ABI_VERSION) return error.WrongLibrary;
%s}
"""
SCALARS = {"float": "f32", "double": "f64", "char": "u8", "void": "void"}
WORDS = set(
    "addrspace align allowzero and anyframe anytype asm break callconv catch comptime const continue defer else enum errdefer error export extern fn for if inline"
    " linksection noalias noinline nosuspend opaque or orelse packed pub resume return struct suspend switch test threadlocal try type union unreachable var volatile while"
    " void bool true false null undefined".split()
)


def safe(name):
    return '@"%s"' % name if name in WORDS else name


def element(part, api):
    """The type without pointers."""
    base = part["base"]
    if base in names.callbacks(api):
        return "*const " + base
    if base == "void" and part["pointers"]:
        return "u8" if part.get("length") else "anyopaque"
    if base in SCALARS:
        return SCALARS[base]
    return base[:-2].replace("uint", "u").replace("int", "i") if base.endswith("_t") else base


def spell(part, api):
    if not part["pointers"]:
        return element(part, api)
    text, optional = element(part, api), "?" if part.get("nullable", True) else ""
    const = "const " if part["const"] else ""
    if part["base"] in names.callbacks(api):
        return optional + text
    if part["pointers"] == 2 and part["base"] != "void":
        kind = "[*:0]" if part["string"] else "[*]" if part["length"] else "*"
        return "%s*?%s%s%s" % (optional, kind, const, text)
    kind = "[*:0]" if part.get("string") and not part["length"] else "[*]" if part.get("length") else "*"
    return optional + kind + const + text


def write(api):
    out = [START % names.NOTICE]
    for constant in api["constants"]:
        out.append(doc_comment(constant) + "pub const %s = %d;\n" % (constant["name"], constant["value"]))
    for enum in api["enums"]:
        out.append("\n" + names.comment(enum["doc"], "// "))
        for value in enum["values"]:
            out.append(doc_comment(value) + "pub const %s = %d;\n" % (value["name"], value["value"]))
    out.append("\n")
    out += ["pub const %s = i32;\n" % entry["name"] for entry in api["scalars"]]
    out += ["pub const %s = enum(u32) { none = 0, _ };\n" % entry["name"] for entry in api["handles"]]
    out += ["pub const %s = opaque {};\n" % entry["name"] for entry in api["opaque"]]
    for callback in api["callbacks"]:
        out.append("\n" + doc_comment(callback) + "pub const %s = fn (%s) callconv(.c) %s;\n" % (callback["name"], parameters(callback, api), spell(callback["returns"], api)))
    for struct in api["structs"]:
        out.append(write_struct(struct, api))
    out.append("\n")
    for function in api["functions"]:
        out.append(doc_comment(function) + "pub extern fn %s(%s) %s;\n" % (function["name"], parameters(function, api), spell(function["returns"], api)))
    checks = "".join("    if (cn_sizeof(%s) != @sizeOf(%s)) return error.WrongLibrary;\n" % (entry["sizeof_type"], entry["name"]) for entry in names.checked_structs(api))
    out.append(CHECK % checks)
    return "".join(out)


def write_struct(struct, api):
    out = ["\n", doc_comment(struct), "pub const %s = extern struct {\n" % struct["name"]]
    for field in struct["fields"]:
        array = "[%d]" % field["array"] if field["array"] else ""
        out.append(doc_comment(field, "    ") + "    %s: %s%s,\n" % (safe(field["name"]), array, spell(field, api)))
    out.append("\n    comptime {\n        if (@sizeOf(usize) == 8 and @sizeOf(%s) != %d) @compileError(\"%s\");\n    }\n};\n" % (struct["name"], struct["size"], struct["name"]))
    return "".join(out)


def parameters(entry, api):
    return ", ".join("%s: %s" % (safe(part["name"]), spell(part, api)) for part in entry["parameters"])


def doc_comment(entry, indent=""):
    return names.comment(entry["doc"], "/// ", indent)
