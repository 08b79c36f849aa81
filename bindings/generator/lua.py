"""Writes lua/calls.h: descriptions of the structs and one C function for Lua per call of idiom.py. lua/cairn_lua.c includes it."""
from . import idiom, names

START = """/* %s
 * Included by cairn_lua.c, which has the conversions. */

""" % names.NOTICE
KINDS = {"float": "FLOAT", "int32_t": "INT32", "uint32_t": "UINT32", "uint64_t": "UINT64", "uint8_t": "UINT8"}


def kind(base, api):
    if base in names.structs(api):
        return "RECORD"
    return KINDS[names.aliases(api).get(base, base)]


def record(base, api):
    return "&record_" + base if base in names.structs(api) else "NULL"


def write(api):
    out = [START]
    inits = idiom.inits(api)
    for entry in names.in_order(api):
        if "fields" in entry:
            out.append(write_record(entry, inits.get(entry["name"]), api))
    for owner in ("world", "tree", ""):
        calls = idiom.methods(api, owner)
        out += [write_call(call, api) for call in calls]
        out.append("\nstatic const luaL_Reg %s_calls[] = {\n" % (owner or "library"))
        out += ['\t{ "%s", call_%s },\n' % (call["name"], call["c"]) for call in calls] + ["\t{ NULL, NULL },\n};\n"]
    out.append("\nstatic const struct {\n\tconst char *name;\n\tint32_t value;\n} constants[] = {\n")
    out += ['\t{ "%s", (int32_t)%s },\n' % (name[3:], name) for name, _, _ in names.all_constants(api)]
    return "".join(out) + "};\n"


def field_kind(field, api):
    """None for what has no value in Lua: pointers but for text, arrays of points and visitors of queries, and struct_size, which the
    init function sets."""
    if field["base"] == "cn_query_fn":
        return "VISITOR"
    if field["pointers"]:
        return "TEXT" if field.get("string") else "POINTS" if field["base"] == "cn_vec2" else None
    return None if field["name"] == "struct_size" else kind(field["base"], api)


def write_record(entry, init, api):
    name, out = entry["name"], []
    if init:
        out.append("static void init_%s(void *at)\n{\n\t%s(at);\n}\n\n" % (name, init))
    fields = [(field, field_kind(field, api)) for field in entry["fields"]]
    out.append("static const field fields_%s[] = {\n" % name)
    for field, of_kind in fields:
        if of_kind:
            out.append('\t{ "%s", offsetof(%s, %s), %s, %d, %s },\n' % (field["name"], name, field["name"], of_kind, field["array"] or 0, record(field["base"], api) if of_kind == "RECORD" else "NULL"))
    arrays = any(field["array"] or of_kind == "POINTS" for field, of_kind in fields)
    count = next((field["name"] for field, _ in fields if arrays and field["name"] in ("count", "point_count")), None)
    out.append("\t{ NULL, 0, FLOAT, 0, NULL },\n};\nstatic const record record_%s = { \"%s\", sizeof(%s), fields_%s, %s, %s };\n\n" % (
        name, name, name, name, "init_" + name if init else "NULL", "offsetof(%s, %s)" % (name, count) if count else "-1"))  # fmt: skip
    return "".join(out)


def write_call(call, api):
    first = 2 if call["owner"] else 1
    index = {entry["name"]: first + i for i, entry in enumerate(call["inputs"])}
    body = ["lua_settop(L, %d);" % (first - 1 + len(call["inputs"]))]
    if call["owner"]:
        changed = "changed_" if call["owner"] == "world" and call["changes"] else ""
        body.append("%s_object *self = to_%s%s(L);" % (call["owner"], changed, call["owner"]))
    fill = next((entry for entry in call["inputs"] if entry["kind"] == "fill"), None)
    for entry in call["inputs"]:
        if entry["kind"] != "fill":
            body += read_input(entry, index[entry["name"]], api)
    body += counting(call, index, fill)
    if fill:
        body.append("%s *%s = buffer(L, count, sizeof(%s));" % (fill["base"], fill["name"], fill["base"]))
    arguments = ["self->pointer"] if call["owner"] else []
    for part in call["parameters"][len(arguments) :]:
        if part["name"] in index:
            arguments.append(part["name"])
        elif part["name"] == "count" or idiom.bytes_of(call, part):
            arguments.append(part["name"])
    body += results(call, arguments, index, fill, api)
    return "\nstatic int call_%s(lua_State *L)\n{\n%s}\n" % (call["c"], "".join("\t%s\n" % line for line in body))


def read_input(entry, i, api):
    name, base = entry["name"], entry["base"]
    nullable = 1 if entry["nullable"] else 0
    if entry["kind"] == "value":
        return ["%s %s;" % (base, name), 'read_value(L, %d, %s, NULL, &%s, "%s");' % (i, kind(base, api), name, name)]
    if entry["kind"] in ("struct", "change"):
        const = "const " if entry["kind"] == "struct" else ""
        return ["%s %s_value;" % (base, name), '%s%s *%s = read_struct(L, %d, %s, &%s_value, %d, "%s");' % (const, base, name, i, record(base, api), name, nullable, name)]
    if entry["kind"] in ("array", "changes"):
        return ["int32_t %s_count;" % name, '%s *%s = read_array(L, %d, %s, %s, %d, "%s", &%s_count);' % (base, name, i, kind(base, api), record(base, api), nullable, name, name)]
    if entry["kind"] == "string":
        read = "luaL_optstring(L, %d, NULL)" if nullable else "luaL_checkstring(L, %d)"
        return ["const char *%s = %s;" % (name, read % i)]
    return ["size_t %s;" % entry["length"], "const void *%s = luaL_checklstring(L, %d, &%s);" % (name, i, entry["length"])]


def counting(call, index, fill):
    """The parameter count, and that all arrays given have it."""
    arrays = [entry for entry in call["inputs"] if entry["length"] == "count" and entry is not fill]
    if not arrays:
        return []
    base = next((entry for entry in reversed(arrays) if not entry["nullable"]), arrays[0])
    count = "%s_count" % base["name"]
    lines = ["int32_t count = %s;" % ("%s ? %s : body_count(self)" % (base["name"], count) if base["nullable"] else count)]
    for entry in arrays:
        if entry is not base:
            lines.append("even(L, %d, !%s || %s_count == count);" % (index[entry["name"]], entry["name"], entry["name"]))
    return lines


def has_visitor(base, api):
    struct = next((entry for entry in api["structs"] if entry["name"] == base), None)
    return struct is not None and any(field["base"] == "cn_query_fn" or has_visitor(field["base"], api) for field in struct["fields"])


def results(call, arguments, index, fill, api):
    invoke = lambda extra: "%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    self = "self" if call["owner"] == "world" and call["changes"] else "NULL"
    visited = "visited(L, self, %s)" if any(has_visitor(entry["base"], api) for entry in call["inputs"]) else "%s"
    check = lambda extra: "check(L, %s, %s);" % (self, visited % invoke(extra))  # noqa: E731
    if call["result"] != "error":
        push = "lua_pushstring(L, %s)" if "char" in call["result"] else "lua_pushboolean(L, %s)" if call["name"].endswith("is_valid") else "push_whole(L, %s)"
        return [push % invoke([]) + ";", "return 1;"]
    outputs = call["outputs"]
    back = []
    for entry in call["inputs"]:
        if entry["kind"] == "change":
            back.append("lua_pushvalue(L, %d);" % index[entry["name"]])
            back += ["write_record(L, %s, %s);" % (record(entry["base"], api), entry["name"]), "lua_pop(L, 1);"]
        elif entry["kind"] == "changes":
            back.append("write_array(L, %d, %s, %s, %s, count);" % (index[entry["name"]], kind(entry["base"], api), record(entry["base"], api), entry["name"]))
            back.append("lua_pop(L, 1);")
    if fill:
        array = "write_array(L, %d, %s, %s, %s, count);" % (index[fill["name"]], kind(fill["base"], api), record(fill["base"], api), fill["name"])
        return [check([]), array, "return 1;"]
    if not outputs:
        return [check([]), *back, "return 0;"]
    base, of_kind = outputs[0]["base"], outputs[0]["kind"]
    if of_kind == "bytes":
        size = ["uint64_t room;", "check(L, %s, %s(%s));" % (self, call["room"], ", ".join([*arguments, "&room"]))] if call["room"] else ["uint64_t room = %s;" % " + ".join(entry["length"] for entry in call["inputs"])]
        return [*size, "void *out = lua_newuserdata(L, room > 0 ? (size_t)room : 1);", check(["out", "room", "&room"]), "lua_pushlstring(L, out, (size_t)room);", "return 1;"]
    if of_kind == "string":
        return ["const char *text;", check(["&text"]), "lua_pushstring(L, text);", "return 1;"]
    if of_kind in ("list", "view"):
        array = "write_array(L, 0, %s, %s, out, out_count);" % (kind(base, api), record(base, api))
        if of_kind == "view":
            return ["const %s *out;" % base, "int32_t out_count;", check(["&out", "&out_count"]), array, "return 1;"]
        # The second time a visitor may take more.
        return ["int32_t capacity, out_count;", check(["NULL", "0", "&capacity"]), "%s *out = buffer(L, capacity, sizeof(%s));" % (base, base),
            check(["out", "capacity", "&out_count"]), "out_count = out_count < capacity ? out_count : capacity;", array, "return 1;"]  # fmt: skip
    lines = ["%s out_%d;" % (entry["base"], i) for i, entry in enumerate(outputs)]
    lines.append(check(["&out_%d" % i for i in range(len(outputs))]))
    lines += back
    for i, entry in enumerate(outputs):
        lines.append("push_hash(L, out_%d);" % i if call["name"].endswith("hash") else "push_value(L, %s, %s, &out_%d);" % (kind(entry["base"], api), record(entry["base"], api), i))
    return lines + ["return %d;" % len(outputs)]
