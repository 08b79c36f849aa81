"""What the writers share: the notice at the top, order of declarations, wrapped comments, api.json."""
import json
import textwrap

NOTICE = "Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit."


def structs(api):
    return {entry["name"] for entry in api["structs"]}


def callbacks(api):
    return {entry["name"] for entry in api["callbacks"]}


def aliases(api):
    return {entry["name"]: entry["type"] for entry in api["handles"] + api["scalars"]}


def checked_structs(api):
    """Structs whose size cn_sizeof tells."""
    return [entry for entry in api["structs"] if entry["sizeof_type"] is not None]


def all_constants(api):
    """(name, value, type) of #defines and enumerators, in this order."""
    for entry in api["constants"]:
        yield entry["name"], entry["value"], entry["type"]
    for enum in api["enums"]:
        for value in enum["values"]:
            yield value["name"], value["value"], enum["type"]


def in_order(api):
    """Structs and callbacks, each behind those that it mentions."""
    entries = {entry["name"]: entry for entry in api["structs"] + api["callbacks"]}
    done, waiting, ordered = set(), [], []

    def visit(entry):
        if entry["name"] in done:
            return
        if entry["name"] in waiting:
            raise ValueError("types that mention each other: " + ", ".join(waiting))
        waiting.append(entry["name"])
        for part in entry.get("fields", []) + entry.get("parameters", []):
            if part["base"] in entries:
                visit(entries[part["base"]])
        waiting.pop()
        done.add(entry["name"])
        ordered.append(entry)

    for entry in entries.values():
        visit(entry)
    return ordered


def comment(doc, prefix, indent=""):
    """Lines of documentation, each behind prefix."""
    lines = textwrap.wrap(doc, 110 - len(indent) - len(prefix), break_long_words=False, break_on_hyphens=False)
    return "".join("%s%s%s\n" % (indent, prefix, line) for line in lines)


def declaration(part):
    """A parameter or field in C."""
    space = "" if part["type"].endswith("*") else " "
    array = "[%d]" % part["array"] if part.get("array") else ""
    return part["type"] + space + part["name"] + array


def is_array(part):
    return bool(part["pointers"]) and part["length"] is not None


def prototype(entry):
    parameters = ", ".join(declaration(part) for part in entry["parameters"]) or "void"
    returns = entry["returns"]["type"]
    return "%s%s%s(%s)" % (returns, "" if returns.endswith("*") else " ", entry["name"], parameters)


def api_text(api):
    return pretty({"generated": NOTICE, **api}) + "\n"


def pretty(value, indent=""):
    """JSON with what fits in a line on a line."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + len(indent) <= 160 or not isinstance(value, (dict, list)) or not value:
        return flat
    inner = indent + "\t"
    if isinstance(value, dict):
        parts = ["%s%s: %s" % (inner, json.dumps(key), pretty(item, inner)) for key, item in value.items()]
        return "{\n" + ",\n".join(parts) + "\n" + indent + "}"
    return "[\n" + ",\n".join(inner + pretty(item, inner) for item in value) + "\n" + indent + "]"
