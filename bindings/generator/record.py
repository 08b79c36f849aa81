"""Calls that change a world, as tables: what recording, replay and fuzzing share (examples/record/).

    calls.h         how each call is made, and what its arguments are, down to the fields of structs
    cairn_record.h  for games: every such function under its own name, recorded

A function belongs here if it takes a world that is not const and returns cn_result, has no callback and hands out no array of
the world's.
"""

KINDS = {"float": "CALL_FLOAT", "int32_t": "CALL_INT", "uint32_t": "CALL_WORD", "uint64_t": "CALL_LONG", "cn_body": "CALL_BODY",
         "cn_shape": "CALL_SHAPE", "cn_joint": "CALL_JOINT", "cn_constraint": "CALL_CONSTRAINT"}
MEMBERS = {"CALL_FLOAT": "f", "CALL_INT": "i", "CALL_LONG": "l"}
HEAD = "/* Written by bindings/generate.py from include/cairn.h: edit bindings/generator/record.py instead. */\n"


def is_callable(function, callbacks):
    parameters = function["parameters"]
    if not parameters or parameters[0]["type"] != "cn_world *" or function["returns"]["type"] != "cn_result" or function["name"] == "cn_world_restore":
        return False
    return all(p["pointers"] < 2 and p["base"] not in callbacks for p in parameters)


def calls_of(api):
    callbacks = {c["name"] for c in api["callbacks"]}
    return [f for f in api["functions"] if is_callable(f, callbacks)]


def leaves(structs, name, path=""):
    """(path, base, array) of every field, nested structs taken apart."""
    for field in structs[name]["fields"]:
        where = path + field["name"]
        if field["pointers"]:
            if field["base"] == "char":
                yield where, "text", 1
            elif field["base"] == "cn_vec2":
                yield where, "points", 1
            continue  # callbacks and their users: NULL in a replay
        if field["base"] in structs:
            count = field["array"] or 1
            inner = list(leaves(structs, field["base"]))
            for k in range(count):
                for sub, base, array in inner:
                    yield "%s%s.%s" % (where, "[%d]" % k if field["array"] else "", sub), base, array
        else:
            yield where, field["base"], field["array"] or 1


def field_line(struct, path, base, array):
    if path.endswith("struct_size"):
        kind = "CALL_SIZE"
    else:
        kind = {"text": "CALL_TEXT", "points": "CALL_POINTS"}.get(base) or KINDS.get(base, "CALL_WORD")
    return '\t{ "%s", (uint32_t)offsetof(%s, %s), %d, %s },\n' % (path, struct, path, array, kind)


def parameter_kind(parameter, structs, counted):
    base = parameter["base"]
    if not parameter["pointers"]:
        return KINDS[base]
    if base == "char":
        return "CALL_TEXT"
    if base in structs:
        if not parameter["const"]:
            return "CALL_RESULT" if parameter["name"].startswith("out") else "CALL_INOUT"
        return "CALL_STRUCTS" if counted else "CALL_STRUCT"
    many = "S" if counted else ""
    return ("CALL_IN" if parameter["const"] else "CALL_OUT") + many


def describe(function, structs):
    """Rows (name, kind, base, index of the parameter with the count)."""
    parameters = function["parameters"][1:]
    count = next((k for k, p in enumerate(parameters) if p["name"] == "count" and not p["pointers"]), -1)
    arrays = [p for p in parameters if p["pointers"]]
    rows = []
    for p in parameters:
        counted = count >= 0 and p in arrays
        rows.append((p["name"], parameter_kind(p, structs, counted), p["base"], count if counted else -1))
    return rows


def member_of(kind, base):
    if kind in ("CALL_INOUT", "CALL_RESULT", "CALL_OUT", "CALL_OUTS"):
        return "out"
    if kind in ("CALL_TEXT", "CALL_STRUCT", "CALL_STRUCTS", "CALL_IN", "CALL_INS"):
        return "in"
    return MEMBERS.get(kind, "w")


def used_structs(api, structs):
    names = []
    for function in calls_of(api):
        for p in function["parameters"][1:]:
            if p["pointers"] and p["base"] in structs and p["base"] not in names:
                names.append(p["base"])
    return names


def init_of(name, api):
    return next((f["name"] for f in api["functions"] if f["name"] == name + "_init"), None)


def struct_tables(names, structs, api):
    out = []
    for name in names:
        out.append("static const call_field fields_%s[] = {\n" % name)
        out += [field_line(name, *leaf) for leaf in leaves(structs, name)]
        out.append("};\n")
    inits = {name: init_of(name, api) for name in names}
    for name, init in inits.items():
        if init:
            out.append("static void start_%s(void *item) { %s((%s *)item); }\n" % (name, init, name))
    out.append("\nconst call_struct call_structs[] = {\n")
    for name in names:
        start = "start_" + name if inits[name] else "NULL"
        out.append('\t{ "%s", fields_%s, (int32_t)(sizeof fields_%s / sizeof fields_%s[0]), (uint32_t)sizeof(%s), %s },\n' % (name, name, name, name, name, start))
    out.append("};\n\n")
    return out


def invoker(function, rows):
    arguments = ["world"]
    for k, (row, p) in enumerate(zip(rows, function["parameters"][1:])):
        member = member_of(row[1], row[2])
        cast = "(%s)" % p["type"] if p["pointers"] else ""
        arguments.append("%sv[%d].%s" % (cast, k, member))
    return "static cn_result invoke_%s(cn_world *world, const call_value *v)\n{\n%s\treturn %s(%s);\n}\n" % (
        function["name"], "" if rows else "\t(void)v;\n", function["name"], ", ".join(arguments))


def write_calls(api):
    structs = {s["name"]: s for s in api["structs"]}
    names = used_structs(api, structs)
    functions = calls_of(api)
    out = [HEAD] + struct_tables(names, structs, api)
    for function in functions:
        rows = describe(function, structs)
        out.append(invoker(function, rows))
        if rows:
            out.append("static const call_param params_%s[] = {\n" % function["name"])
            for name, kind, base, count in rows:
                item = names.index(base) if base in structs else -1
                of = KINDS.get(base, "CALL_WORD")
                out.append('\t{ "%s", %s, %s, %d, %d },\n' % (name, kind, of, item, count))
            out.append("};\n")
    out.append("\nconst call_entry call_entries[] = {\n")
    for function in functions:
        count = len(function["parameters"]) - 1
        out.append('\t{ "%s", invoke_%s, %s, %d },\n' % (function["name"], function["name"], "params_" + function["name"] if count else "NULL", count))
    out.append("};\nconst int32_t call_count = (int32_t)(sizeof call_entries / sizeof call_entries[0]);\n")
    return "".join(out)


def signature(function):
    parameters = ", ".join("%s%s%s" % (p["type"], "" if p["type"].endswith("*") else " ", p["name"]) for p in function["parameters"])
    return "cn_result %s(%s)" % (function["name"].replace("cn_", "cnr_", 1), parameters.replace(" * ", " *"))


def write_wrappers(api):
    """Definitions; examples/record/record.c includes them."""
    structs = {s["name"]: s for s in api["structs"]}
    out = [HEAD]
    for index, function in enumerate(calls_of(api)):
        rows = describe(function, structs)
        out.append(signature(function) + "\n{\n\tcall_value v[%d];\n" % max(len(rows), 1))
        for k, (name, kind, base, _) in enumerate(rows):
            out.append("\tv[%d].%s = %s;\n" % (k, member_of(kind, base), name))
        out.append("\treturn record_call(world, %d, v);\n}\n\n" % index)
    return "".join(out)


def write_header(api):
    functions = calls_of(api)
    out = [HEAD, """/*
 * Include this instead of cairn.h, link examples/record/ and bindings/record/: then each call that changes a world is recorded
 * while examples/record/record.h records that world. A program that does not include it pays nothing.
 */
#ifndef CAIRN_RECORD_H
#define CAIRN_RECORD_H

#include "cairn.h"

cn_result cnr_world_restore(cn_world *world, const void *save, uint64_t bytes);
void cnr_world_destroy(cn_world *world);
"""]
    out += [signature(f) + ";\n" for f in functions]
    out.append("\n#ifndef CAIRN_RECORD_PLAIN_NAMES\n#define cn_world_restore cnr_world_restore\n#define cn_world_destroy cnr_world_destroy\n")
    out += ["#define %s %s\n" % (f["name"], f["name"].replace("cn_", "cnr_", 1)) for f in functions]
    out.append("#endif\n\n#endif\n")
    return "".join(out)
