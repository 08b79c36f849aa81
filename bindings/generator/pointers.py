"""Adds to the api what C's types do not say of a pointer. Each parameter and field that is a pointer gets

    direction   "in", "out" (written on CN_OK) or "inout"
    length      the parameter or field that holds the number of elements (bytes of void and char), or null: one element
    written     the output that tells how many of length were written, or null
    owner       "library" for an array or text that stays the library's, else "caller"
    nullable    whether NULL is allowed
    string      whether it is text that ends with a zero

by the conventions of the header: outputs are called out or out_..., counts follow or precede their arrays, and a comment says
where NULL is allowed. A pointer that fits no convention is an error. test/nullable.py asks the library about NULL.
"""
import re

from .header import HeaderError

# Read and written: no name says so.
CHANGED = {("cn_mover_solve", "planes"), ("cn_mover_move", "mover"), ("cn_material_mix_fn", "mixed")}
# Whole objects of the library, and what the user passes through.
PASSED = {"user", "context", "allocator_user", "task_user", "task", "memory", "reserved"}


def add(api):
    functions = {entry["name"]: entry for entry in api["functions"]}
    callbacks = {entry["name"] for entry in api["callbacks"]}
    for entry in api["functions"] + api["callbacks"]:
        for part in entry["parameters"]:
            if part["pointers"]:
                describe(entry, entry["parameters"], part, callbacks)
        if entry["returns"]["pointers"]:
            text = entry["returns"]["base"] == "char"
            facts(entry["returns"], "out", owner="library", nullable=not text, string=text)
    for struct in api["structs"]:
        for field in struct["fields"]:
            if field["pointers"]:
                describe_field(struct, field, callbacks)
    for entry in api["functions"]:
        for part in entry["parameters"]:
            if part["pointers"]:
                part["nullable"] = part["nullable"] or may_be_null(entry, part, functions, callbacks)


def facts(part, direction, length=None, written=None, owner="caller", nullable=False, string=False):
    part.update({"direction": direction, "length": length, "written": written, "owner": owner, "nullable": nullable, "string": string})


def describe(entry, parts, part, callbacks):
    i = parts.index(part)
    after = parts[i + 1]["name"] if i + 1 < len(parts) else ""
    name, names = part["name"], [other["name"] for other in parts]
    out = name == "out" or name.startswith("out_")
    if part["base"] in callbacks:
        facts(part, "in")
    elif part["base"] in ("cn_world", "cn_tree") and part["pointers"] == 1:
        facts(part, "in" if part["const"] else "inout")
    elif name in PASSED:
        facts(part, "in", nullable=True)
    elif out and part["pointers"] == 2 and part["base"] == "char":
        facts(part, "out", owner="library", string=True)
    elif out and part["pointers"] == 2 and part["const"]:
        require(entry, name, after == "out_count")
        facts(part, "out", length=after, owner="library")
    elif out and after == "capacity":
        facts(part, "out", length=after, written=parts[i + 2]["name"], nullable=part["base"] != "void")
    elif out and part["pointers"] == 1 and (i and parts[i - 1]["name"] == "count" or "count" in names and part["base"] in ("cn_pose", "cn_ray_hit")):
        facts(part, "out", length="count")
    elif out:
        facts(part, "out", owner="library" if part["pointers"] == 2 else "caller")
    elif part["base"] == "char" and after.endswith("_bytes"):
        facts(part, "out", length=after, string=True, nullable=True)
    elif part["base"] == "char":
        require(entry, name, part["const"])
        facts(part, "in", string=True)
    elif part["base"] == "void":
        require(entry, name, after in ("bytes", name + "_bytes") and part["const"])
        facts(part, "in", length=after)
    elif "count" in names and (after == "count" or parts[i - 1]["name"] == "count" and name.endswith("s")):
        facts(part, "inout" if (entry["name"], name) in CHANGED else "in", length="count")
        require(entry, name, part["const"] or part["direction"] == "inout")
    elif entry["name"].endswith("_init"):
        facts(part, "out")
    else:
        changed = (entry["name"], name) in CHANGED
        require(entry, name, part["const"] or changed)
        facts(part, "in" if part["const"] else "inout")


def describe_field(struct, field, callbacks):
    names = [other["name"] for other in struct["fields"]]
    if field["base"] in callbacks or field["name"] in PASSED:
        bytes_of = field["name"] + "_bytes"
        facts(field, "in", nullable=True, length=bytes_of if bytes_of in names else None)
    elif field["base"] == "char":
        facts(field, "in", nullable="NULL" in field["doc"], string=True)
    else:
        require(struct, field["name"], field["const"] and "count" in names)
        facts(field, "in", length="count")


def require(entry, name, condition):
    if not condition:
        raise HeaderError("%s: the pointer %s follows no convention (generator/pointers.py)" % (entry["name"], name))


def may_be_null(entry, part, functions, callbacks):
    doc, name = entry["doc"], part["name"]
    if re.search(r"\b%s(, which)? may be NULL" % name, doc) or re.search(r"\b%s NULL means" % name, doc):
        return True
    if part["base"] in callbacks:
        return "NULL removes it" in doc or "both NULL" in doc
    if part["string"] and "NULL or \"\"" in doc:
        return True
    if entry["parameters"][0] is part and re.search(r"(^|\. |, )NULL(,[^,]*,)? does? nothing|NULL, and .* do nothing|NULL world|world is NULL", doc):
        return True
    if part["base"] == "cn_query_filter":
        return part["const"]
    other = re.search(r"\b%s\b[^.;]* as in (cn_\w+)|otherwise as (cn_\w+)" % name, doc)
    other = other and functions.get(other.group(1) or other.group(2))
    return bool(other) and any(p["name"] == name and p.get("nullable") for p in other["parameters"])
