"""Writes go/cairn.go: Go structs of C's layout, and methods made of idiom.py on worlds that the garbage collector closes."""
from . import idiom, names

START = """// Code generated from include/cairn.h by bindings/generate.py (make bindings). DO NOT EDIT.

package cairn

/*
#include "cairn.h"
#include <stdlib.h>
*/
import "C"
import (
	"runtime"
	"unsafe"
)

"""
SCALARS = {"float": "float32", "double": "float64", "char": "int8"}
INITIAL = {"def": "def", "type": "kind", "range": "limits", "func": "function", "map": "table", "chan": "channel", "select": "selected", "len": "length"}


def scalar(base, api):
    if base in {entry["name"] for entry in api["scalars"]}:
        return "int32"
    return idiom.type_name(base) if base.startswith("cn_") else SCALARS.get(base, base[:-2] if base.endswith("_t") else base)


def constant(name):
    if name in ("CN_OK", "CN_ABI_VERSION"):
        return {"CN_OK": "OK", "CN_ABI_VERSION": "HeaderAbiVersion"}[name]
    return "".join(word.capitalize() if len(word) > 2 or word.isdigit() else word for word in name[3:].split("_"))


def exported(name):
    return idiom.pascal(name)


def safe(name):
    return INITIAL.get(name, name)


def write(api):
    out = [START, "// Constants of cairn.h.\nconst (\n"]
    out += ["\t%s = %d\n" % (constant(name), value) for name, value, _ in names.all_constants(api)]
    out.append(")\n")
    for entry in api["handles"]:
        out.append("\n%stype %s uint32\n" % (names.comment("%s: %s" % (idiom.type_name(entry["name"]), entry["doc"]), "// "), idiom.type_name(entry["name"])))
    inits = idiom.inits(api)
    for struct in api["structs"]:
        name = idiom.type_name(struct["name"])
        out.append("\n%stype %s struct {\n" % (names.comment("%s: %s" % (name, struct["doc"]), "// "), name))
        for field in struct["fields"]:
            kind = "unsafe.Pointer" if field["pointers"] else scalar(field["base"], api)
            array = "[%d]" % field["array"] if field["array"] else ""
            # Pointers stay as the init function leaves them.
            out.append("%s\t%s %s%s\n" % (names.comment(field["doc"], "// ", "\t"), "c_" + field["name"] if field["pointers"] else exported(field["name"]), array, kind))
        out.append("}\n\nvar _ [unsafe.Sizeof(%s{})]byte = [C.sizeof_%s]byte{}\n" % (name, struct["name"]))
        if struct["name"] in inits:
            out.append("\n// Default%s has the defaults of the fields.\nfunc Default%s() %s {\n\tvar value %s\n" % (name, name, name, name))
            out.append("\tC.%s((*C.%s)(unsafe.Pointer(&value)))\n\treturn value\n}\n" % (inits[struct["name"]], struct["name"]))
    for owner in ("world", "tree", ""):
        out += [write_call(call, api) for call in idiom.methods(api, owner) if not any(entry["base"] == "cn_chain" for entry in call["inputs"])]
    return "".join(out)


def parameter(entry, api):
    base = scalar(entry["base"], api)
    kind = {"value": base, "struct": "*" + base, "change": "*" + base, "array": "[]" + base, "fill": "[]" + base, "changes": "[]" + base, "string": "string", "bytes": "[]byte"}[entry["kind"]]
    return "%s %s" % (safe(entry["name"]), kind)


def argument(part, call, inputs):
    entry = inputs.get(part["name"])
    if entry is None:
        if part["name"] == "count":
            return "C.int32_t(len(%s))" % safe(idiom.counted(call)["name"])
        of = idiom.bytes_of(call, part)
        return "C.uint64_t(len(%s))" % safe(of["name"]) if of else None
    name = safe(entry["name"])
    if entry["kind"] == "value":
        return "C.%s(%s)" % (entry["base"], name)
    if entry["kind"] == "string":
        return "c_" + name
    if entry["kind"] == "bytes":
        return "unsafe.Pointer(unsafe.SliceData(%s))" % name
    pointer = name if entry["kind"] in ("struct", "change") else "unsafe.SliceData(%s)" % name
    return "(*C.%s)(unsafe.Pointer(%s))" % (entry["base"], pointer)


def write_call(call, api):
    inputs, outputs = {entry["name"]: entry for entry in call["inputs"]}, call["outputs"]
    owner = call["owner"]
    kinds = {"value": "%s", "list": "[]%s", "view": "[]%s", "string": "string", "bytes": "[]byte"}
    types = [kinds[entry["kind"]].replace("%s", scalar(entry["base"], api)) for entry in outputs]
    plain = call["result"] != "error"
    result = ("string" if "char" in call["result"] else "bool" if call["name"].endswith("is_valid") else scalar(call["result"], api)) if plain else "(%s)" % ", ".join([*types, "error"]) if types else "error"
    receiver = "(%s *%s) " % (owner[0], owner.capitalize()) if owner else ""
    head = "\n%sfunc %s%s(%s) %s {\n" % (names.comment("%s: %s" % (exported(call["name"]), call["doc"]), "// "), receiver, exported(call["name"]), ", ".join(parameter(entry, api) for entry in call["inputs"]), result)
    body = []
    zero = ["*new(%s)" % kind for kind in types]
    failed = lambda error: "return %s" % ", ".join([*zero, error])  # noqa: E731
    for entry in call["inputs"]:
        if entry["length"] == "count" and entry is not idiom.counted(call):
            name, base = safe(entry["name"]), safe(idiom.counted(call)["name"])
            body += ["if %slen(%s) != len(%s) {" % (name + " != nil && " if entry["nullable"] else "", name, base), "\t" + failed("errUneven"), "}"]
        if entry["kind"] == "string":
            name = safe(entry["name"])
            body += ["c_%s := C.CString(%s)" % (name, name), "defer C.free(unsafe.Pointer(c_%s))" % name]
    arguments = (["%s.c()" % owner[0]] if owner else []) + [text for text in (argument(part, call, inputs) for part in call["parameters"][bool(owner) :]) if text is not None]
    invoke = lambda extra: "C.%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    keep = ["defer runtime.KeepAlive(%s)" % owner[0]] if owner else []
    check = (owner[0] + ".check(%s)") if owner == "world" and call["changes"] else "check(%s)"
    body = keep + body + (room(call, arguments, invoke, check, failed) if outputs and outputs[0]["kind"] == "bytes" else results(call, outputs, invoke, check, types, failed, api))
    return head + "".join("\t%s\n" % line for line in body) + "}\n"


def room(call, arguments, invoke, check, failed):
    tried = lambda text: ["if err := %s; err != nil {" % (check % text), "\t" + failed("err"), "}"]  # noqa: E731
    size = tried("C.%s(%s)" % (call["room"], ", ".join([*arguments, "&bytes"]))) if call["room"] else ["bytes = C.uint64_t(%s)" % " + ".join("len(%s)" % safe(name) for name in idiom.bytes_in(call))]
    return ["var bytes C.uint64_t", *size, "out := make([]byte, bytes)", *tried(invoke(["unsafe.Pointer(unsafe.SliceData(out))", "bytes", "&bytes"])), "return out[:bytes], nil"]


def results(call, outputs, invoke, check, types, failed, api):
    if call["result"] != "error":
        text = invoke([])
        return ["return " + ("C.GoString(%s)" % text if "char" in call["result"] else text + " != 0" if call["name"].endswith("is_valid") else "%s(%s)" % (scalar(call["result"], api), text))]
    if not outputs:
        return ["return " + check % invoke([])]
    tried = lambda extra: ["if err := %s; err != nil {" % (check % invoke(extra)), "\t" + failed("err"), "}"]  # noqa: E731
    base = outputs[0]["base"]
    if outputs[0]["kind"] == "list":
        return ["var count C.int32_t", *tried(["nil", "0", "&count"]), "out := make(%s, count)" % types[0], "if count > 0 {",
            *["\t" + line for line in tried(["(*C.%s)(unsafe.Pointer(&out[0]))" % base, "count", "&count"])], "}", "return out, nil"]  # fmt: skip
    if outputs[0]["kind"] == "view":
        return ["var data *C.%s" % base, "var count C.int32_t", *tried(["&data", "&count"]), "return append(%s(nil), unsafe.Slice((*%s)(unsafe.Pointer(data)), count)...), nil" % (types[0], types[0][2:])]
    if outputs[0]["kind"] == "string":
        return ["var text *C.char", *tried(["&text"]), "return C.GoString(text), nil"]
    names_of = ["out%d" % i for i in range(len(outputs))]
    lines = ["var %s %s" % (name, kind) for name, kind in zip(names_of, types)]
    return lines + tried(["(*C.%s)(unsafe.Pointer(&%s))" % (entry["base"], name) for entry, name in zip(outputs, names_of)]) + ["return %s, nil" % ", ".join(names_of)]
