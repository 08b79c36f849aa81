"""What an idiomatic layer makes of the C functions, for all languages: api -> a list of calls.

    owner     "world" or "tree" when the first parameter is one (a method), else "" (a function)
    name      the C name without cn_, and without world_ or tree_ when that is the owner: step, body_create, polygon_cast
    changes   whether the owner may change
    inputs    in C's order; kind: "value", "struct", "array", "string", "bytes" (read); "change" and "changes" (one or an array, read
              and written); "fill" (an array of the caller that is written whole)
    outputs   kind: "value", "list" (array of unknown length), "view" (the library's array), "string", "bytes"
    result    "error" (cn_result), or the C type that it returns
    length    names of inputs whose number of elements is the parameter count
    room      of an output "bytes": the C function that gives the room it needs, or None: that of all bytes that go in

Calls that need a callback, memory that the caller lays out or a hand-written form are not among them (SKIPPED and unfit).
"""
SKIPPED = {"cn_world_create", "cn_world_destroy", "cn_tree_create", "cn_tree_destroy", "cn_world_def_check", "cn_world_validate", "cn_world_error_text",
    "cn_world_read_poses_strided", "cn_sizeof", "cn_world_draw", "cn_world_bytes_needed", "cn_world_read"}  # fmt: skip


def calls(api):
    structs = {entry["name"] for entry in api["structs"]}
    callbacks = {entry["name"] for entry in api["callbacks"]}
    functions = {entry["name"] for entry in api["functions"]}
    return [call(function, structs, functions) for function in api["functions"] if fits(function, callbacks)]


def fits(function, callbacks):
    parts = function["parameters"]
    return function["name"] not in SKIPPED and not is_init(function) and not any(part["base"] in callbacks for part in parts)


def is_init(function):
    return function["name"].endswith("_init")


def inits(api):
    """Structs with an init function: name of the struct -> name of the function."""
    return {f["parameters"][0]["base"]: f["name"] for f in api["functions"] if is_init(f)}


def call(function, structs, functions):
    parts = list(function["parameters"])
    owner = ""
    if parts and parts[0]["base"] in ("cn_world", "cn_tree"):
        owner, changes = parts[0]["base"][3:], not parts[0]["const"]
    else:
        changes = False
    name = function["name"][3:]
    if owner and name.startswith(owner + "_"):
        name = name[len(owner) + 1 :]
    counts = {part["length"] for part in parts if part["pointers"] and part["length"]} | {part["written"] for part in parts if part["pointers"]}
    inputs, outputs = [], []
    for part in parts[1:] if owner else parts:
        if part["name"] in counts:
            continue
        entry = {"name": part["name"], "base": part["base"], "nullable": bool(part["pointers"]) and part["nullable"], "length": part.get("length"), "part": part}
        kind = kind_of(part, structs)
        if kind in ("value out", "list", "view", "string out", "bytes out"):
            outputs.append({**entry, "kind": kind.split()[0], "name": part["name"].replace("out_", "") if part["name"] != "out" else "out"})
        else:
            inputs.append({**entry, "kind": kind})
    result = "error" if function["returns"]["type"] == "cn_result" else function["returns"]["type"]
    length = [entry["name"] for entry in inputs if entry["length"] == "count"]
    return {"c": function["name"], "owner": owner, "name": name, "changes": changes, "inputs": inputs, "outputs": outputs, "result": result, "length": length,
        "room": function["name"] + "_size" if function["name"] + "_size" in functions else None, "doc": function["doc"], "parameters": parts}  # fmt: skip


def kind_of(part, structs):
    if not part["pointers"]:
        return "value"
    if part["direction"] == "out":
        if part["base"] == "void":
            return "bytes out"
        if part["owner"] == "library":
            return "string out" if part["string"] else "view"
        return "value out" if not part["length"] else "list" if part["written"] else "fill"
    if part["string"]:
        return "string"
    if part["base"] == "void":
        return "bytes"
    if part["direction"] == "inout":
        return "changes" if part["length"] else "change"
    return "array" if part["length"] else "struct"


def methods(api, owner):
    return [call for call in calls(api) if call["owner"] == owner]


def bytes_of(call, part):
    """The input whose length in bytes is this parameter, or None."""
    return next((entry for entry in call["inputs"] if entry["kind"] == "bytes" and entry["length"] == part["name"]), None)


def bytes_in(call):
    return [entry["name"] for entry in call["inputs"] if entry["kind"] == "bytes"]


def counted(call):
    """The input that says how many elements: one that may not be NULL, or None."""
    fitting = [entry for entry in call["inputs"] if entry["length"] == "count" and not entry["nullable"]]
    return fitting[-1] if fitting else None


def type_name(name):
    """cn_world_def -> WorldDef"""
    return "".join(word[0].upper() + word[1:] for word in name[3:].split("_"))


def camel(name):
    """body_get_pose -> bodyGetPose"""
    words = name.split("_")
    return words[0] + "".join(word[:1].upper() + word[1:] for word in words[1:])


def pascal(name):
    words = name.split("_")
    return "".join(word[:1].upper() + word[1:] for word in words)
