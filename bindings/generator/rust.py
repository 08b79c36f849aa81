"""Writes rust/cairn-sys/src/lib.rs: extern declarations with C's names; and rust/cairn/src/calls.rs: safe methods made of idiom.py.

Handles are structs of one number, so that a shape is never taken for a body. Structs with an init function get it as Default.
"""
from . import idiom, names

SYS = """//! C's functions of Cairn under their own names. %s
//! The crate `cairn` is the safe layer above.
#![no_std]
#![allow(non_camel_case_types, non_snake_case, clippy::too_many_arguments)]
use core::ffi::{c_char, c_void};

"""
DERIVE = "#[repr(C)]\n#[derive(Clone, Copy, Debug%s)]\n"
SCALARS = {"float": "f32", "double": "f64", "char": "c_char", "void": "c_void"}
WORDS = set("abstract as async await become box break const do final macro override priv typeof unsized virtual yield continue crate dyn else enum extern false fn for if impl in let loop match mod move mut pub ref return self static struct super trait true try type unsafe use where while".split())


def safe(name):
    return "r#" + name if name in WORDS else name


def scalar(base):
    return SCALARS.get(base) or (base[:-2].replace("uint", "u").replace("int", "i") if base.endswith("_t") else base)


def spell(part, api):
    base, pointers = part["base"], part["pointers"]
    if base in names.callbacks(api):
        return "Option<%s>" % base
    text = scalar(base)
    if not pointers:
        return text
    text = ("*const " if part["const"] else "*mut ") + text
    return "*mut " + text if pointers == 2 else text


def returns(entry, api):
    return "" if entry["returns"]["type"] == "void" else " -> " + spell(entry["returns"], api)


def parameters(entry, api):
    return ", ".join("%s: %s" % (safe(part["name"]), spell(part, api)) for part in entry["parameters"])


def doc(entry, indent=""):
    return names.comment(entry["doc"].replace("[", "\\[").replace("]", "\\]"), "/// ", indent)


def write_sys(api):
    out = [SYS % names.NOTICE]
    out += ["%spub const %s: %s = %d;\n" % (doc(entry) if "doc" in entry else "", name, scalar(kind), value) for name, value, kind in names.all_constants(api) for entry in [{}]]
    out += ["\n%spub type %s = i32;\n" % (doc(entry), entry["name"]) for entry in api["scalars"]]
    for entry in api["handles"]:
        out.append("\n%s#[repr(transparent)]\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]\npub struct %s(pub u32);\n" % (doc(entry), entry["name"]))
    for entry in api["opaque"]:
        out.append("\n%s#[repr(C)]\npub struct %s {\n    _private: [u8; 0],\n    _pinned: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,\n}\n" % (doc(entry), entry["name"]))
    for entry in api["callbacks"]:
        out.append("\n%spub type %s = unsafe extern \"C\" fn(%s)%s;\n" % (doc(entry), entry["name"], parameters(entry, api), returns(entry, api)))
    inits, plain = idiom.inits(api), {}
    for struct in api["structs"]:
        plain[struct["name"]] = not any(field["pointers"] or plain.get(field["base"]) is False or field["array"] > 32 for field in struct["fields"])
        derived = plain[struct["name"]] and struct["name"] not in inits
        out.append("\n" + doc(struct) + DERIVE % ((", Default" if derived else "") + (", PartialEq" if plain[struct["name"]] else "")) + "pub struct %s {\n" % struct["name"])
        for field in struct["fields"]:
            kind = "[%s; %d]" % (spell(field, api), field["array"]) if field["array"] else spell(field, api)
            out.append("%s    pub %s: %s,\n" % (doc(field, "    "), safe(field["name"]), kind))
        out.append("}\n")
        if not derived:
            out.append(default(struct["name"], inits.get(struct["name"])))
        out.append("const _: () = assert!(size_of::<%s>() == %d || size_of::<usize>() != 8);\n" % (struct["name"], struct["size"]))
    out.append("\nextern \"C\" {\n")
    for function in api["functions"]:
        out.append("%s    pub fn %s(%s)%s;\n" % (doc(function, "    "), function["name"], parameters(function, api), returns(function, api)))
    return "".join(out).replace("size_of::", "core::mem::size_of::") + "}\n"


def default(name, init):
    # All bytes 0 is a value of every struct here: numbers, NULL and None.
    lines = ["let mut value: Self = unsafe { core::mem::zeroed() };", "unsafe { %s(&mut value) };" % init, "value"] if init else ["unsafe { core::mem::zeroed() }"]
    return "impl Default for %s {\n    fn default() -> Self {\n%s    }\n}\n" % (name, "".join("        %s\n" % line for line in lines))


# ---------------------------------------------------------------- the safe layer


def public(base, api):
    """The name in the crate cairn: Pose for cn_pose."""
    if base in {entry["name"] for entry in api["scalars"]}:
        return "i32"
    return idiom.type_name(base) if base.startswith("cn_") else scalar(base)


def write_layer(api):
    out = ["// %s\nuse crate::*;\n\n" % names.NOTICE]
    types = [entry["name"] for kind in ("handles", "structs") for entry in api[kind]]
    out += ["pub use cairn_sys::%s as %s;\n" % (name, idiom.type_name(name)) for name in types]
    out.append(cleared(api))
    for owner in ("world", "tree"):
        out.append("\nimpl %s {\n" % idiom.type_name("cn_" + owner))
        out.append("\n".join(write_call(call, api, "    ") for call in usable(api, owner)) + "}\n")
    return "".join(out) + "".join("\n" + write_call(call, api, "") for call in usable(api, ""))


def usable(api, owner):
    """Without the one whose struct is nothing but a pointer: World::create_chain."""
    return [call for call in idiom.methods(api, owner) if not any(entry["base"] == "cn_chain" for entry in call["inputs"])]


def cleared(api):
    """Structs without their pointers, which safe code may not give to C."""
    out = ["\npub(crate) trait Cleared {\n    /// A copy without pointers, which C would follow.\n    fn cleared(&self) -> Self;\n}\n"]
    for struct in (entry for entry in api["structs"] if holds_pointer(entry["name"], api)):
        out.append("impl Cleared for %s {\n    fn cleared(&self) -> Self {\n        Self {\n" % idiom.type_name(struct["name"]))
        for field in struct["fields"]:
            if field["pointers"]:
                null = "None" if field["base"] in names.callbacks(api) else "core::ptr::null%s()" % ("" if field["const"] else "_mut")
                out.append("            %s: %s,\n" % (safe(field["name"]), null))
            elif holds_pointer(field["base"], api):
                out.append("            %s: self.%s.cleared(),\n" % (field["name"], field["name"]))
        out.append("            ..*self\n        }\n    }\n}\n")
    return "".join(out)


def holds_pointer(base, api):
    struct = next((entry for entry in api["structs"] if entry["name"] == base), None)
    return struct is not None and any(field["pointers"] or holds_pointer(field["base"], api) for field in struct["fields"])


def parameter(entry, api):
    base, name = public(entry["base"], api), safe(entry["name"])
    kind = {"value": base, "struct": "&" + base, "array": "&[%s]" % base, "fill": "&mut [%s]" % base, "changes": "&mut [%s]" % base, "change": "&mut " + base,
        "string": "&core::ffi::CStr", "bytes": "&[u8]"}[entry["kind"]]  # fmt: skip
    return "%s: %s" % (name, "Option<%s>" % kind if entry["nullable"] else kind)


def argument(part, call, inputs):
    entry = inputs.get(part["name"])
    if entry is None:
        if part["name"] == "count":
            return "%s.len() as i32" % idiom.counted(call)["name"]
        of = idiom.bytes_of(call, part)
        return "%s.len() as u64" % of["name"] if of else None
    name = safe(entry["name"])
    if entry["kind"] == "value":
        return name
    if entry["nullable"]:
        as_pointer = {"struct": "value as *const _", "array": "value.as_ptr()", "string": "value.as_ptr()"}[entry["kind"]]
        return "%s.map_or(core::ptr::null(), |value| %s)" % (name, as_pointer)
    return {"struct": name, "change": name, "array": name + ".as_ptr()", "string": name + ".as_ptr()", "bytes": name + ".as_ptr().cast()", "fill": name + ".as_mut_ptr()", "changes": name + ".as_mut_ptr()"}[entry["kind"]]


def write_call(call, api, indent):
    inputs, outputs = {entry["name"]: entry for entry in call["inputs"]}, call["outputs"]
    dangerous = [entry for entry in call["inputs"] if entry["kind"] in ("struct", "array") and holds_pointer(entry["base"], api)]
    owner = ["self.pointer()"] if call["owner"] else []
    receiver = (["&mut self" if call["changes"] else "&self"] if owner else []) + [parameter(entry, api) for entry in call["inputs"]]
    kinds = {"value": lambda e: public(e["base"], api), "list": lambda e: "Vec<%s>" % public(e["base"], api), "view": lambda e: "&[%s]" % public(e["base"], api), "string": lambda e: "&core::ffi::CStr", "bytes": lambda e: "Vec<u8>"}
    types = [kinds[entry["kind"]](entry) for entry in outputs]
    value = types[0] if len(types) == 1 else "(%s)" % ", ".join(types)
    result = {"error": "Result<%s>" % value, "const char *": "&'static core::ffi::CStr"}.get(call["result"], "bool" if call["name"].endswith("is_valid") else scalar(call["result"]))
    out = doc(call, indent) + "%spub fn %s(%s) -> %s {\n" % (indent, safe(call["name"]), ", ".join(receiver), result)
    body = []
    for entry in call["inputs"]:
        if entry["length"] == "count" and entry is not idiom.counted(call):
            length = "%s.map_or(false, |value| value.len() != %s.len())" if entry["nullable"] else "%s.len() != %s.len()"
            body += ["if %s {" % (length % (entry["name"], idiom.counted(call)["name"])), "    return Err(Error::uneven());", "}"]
    for entry in dangerous:
        name = safe(entry["name"])
        if entry["kind"] == "array":
            body.append("let %s: Vec<_> = %s.iter().map(Cleared::cleared).collect();" % (name, name))
        elif entry["nullable"]:
            body += ["let %s = %s.map(Cleared::cleared);" % (name, name), "let %s = %s.as_ref();" % (name, name)]
        else:
            body.append("let %s = &%s.cleared();" % (name, name))
    arguments = owner + [text for text in (argument(part, call, inputs) for part in call["parameters"][len(owner) :]) if text is not None]
    invoke = lambda extra: "unsafe { cairn_sys::%s(%s) }" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    check = "self.check(%s)?;" if call["owner"] == "world" and call["changes"] else "check(%s)?;"
    body += room(call, arguments, invoke, check) if outputs and outputs[0]["kind"] == "bytes" else results(call, outputs, invoke, check, api)
    return out + "".join("%s    %s\n" % (indent, line) for line in body) + indent + "}\n"


def room(call, arguments, invoke, check):
    size = check % ("unsafe { cairn_sys::%s(%s) }" % (call["room"], ", ".join([*arguments, "&mut bytes"]))) if call["room"] else "bytes += (%s) as u64;" % " + ".join("%s.len()" % name for name in idiom.bytes_in(call))
    return ["let mut bytes = 0;", size, "let mut out: Vec<u8> = vec![0; bytes as usize];", check % invoke(["out.as_mut_ptr().cast()", "bytes", "&mut bytes"]), "out.truncate(bytes as usize);", "Ok(out)"]


def results(call, outputs, invoke, check, api):
    if call["result"] == "const char *":
        return ["unsafe { core::ffi::CStr::from_ptr(%s) }" % invoke([])[9:-2]]
    if call["result"] != "error":
        return [invoke([]).replace("unsafe {", "(unsafe {") + ") != 0" if call["name"].endswith("is_valid") else invoke([])]
    if not outputs:
        return [(check % invoke([])), "Ok(())"]
    kind = outputs[0]["kind"]
    if kind == "list":
        return ["let mut count = 0;", check % invoke(["core::ptr::null_mut()", "0", "&mut count"]), "let mut out = Vec::with_capacity(count as usize);",
            "if count > 0 {", "    " + check % invoke(["out.as_mut_ptr()", "count", "&mut count"]), "    unsafe { out.set_len((count as usize).min(out.capacity())) };", "}", "Ok(out)"]  # fmt: skip
    if kind == "view":
        return ["let (mut data, mut count) = (core::ptr::null(), 0);", check % invoke(["&mut data", "&mut count"]),
            "Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })"]  # fmt: skip
    if kind == "string":
        return ["let mut text = core::ptr::null();", check % invoke(["&mut text"]), "Ok(unsafe { core::ffi::CStr::from_ptr(text) })"]
    lines = ["let mut out_%s = %s::default();" % (entry["name"], public(entry["base"], api)) for entry in outputs]
    values = ", ".join("out_" + entry["name"] for entry in outputs)
    return lines + [check % invoke(["&mut out_" + entry["name"] for entry in outputs]), "Ok(%s)" % (values if len(outputs) == 1 else "(%s)" % values)]
