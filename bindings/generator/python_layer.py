"""Writes the classes of python/cairn.py: worlds and trees that destroy themselves, exceptions, results as values. From idiom.py."""
import copy

from . import idiom, names

START = '''

class Error(Exception):
    """A call that failed: code is the cn_result, the text is the library's sentence."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def _check(result, world=None):
    if result != CN_OK:
        text = cn_world_error_text(world) if world else b""
        raise Error(result, (text or cn_result_text(result)).decode())


def _array(kind, values):
    """None, a ctypes array as it is, anything else copied into one."""
    return values if values is None or isinstance(values, _c.Array) else (kind * len(values))(*values)


def _even(count, *arrays):
    for array in arrays:
        if array is not None and len(array) != count:
            raise ValueError("arrays of %d and %d elements" % (len(array), count))


def _copy(kind, pointer, count):
    array = (kind * count)()
    if count:
        _c.memmove(array, pointer, _c.sizeof(array))
    return array


def _made(definition, fields):
    for name, value in fields.items():
        getattr(definition, name)
        setattr(definition, name, value)
    return definition
'''
WORLD = '''

class World:
    """A world; close() or the end of a with block destroys it, as does the garbage collector. World(definition), or fields of
    cn_world_def: World(substep_count=8)."""

    _pointer = None

    def __init__(self, definition=None, **fields):
        self._callbacks = {}
        pointer = _c.POINTER(cn_world)()
        _check(cn_world_create(_made(definition or WorldDef(), fields), pointer))
        self._pointer = pointer

    @property
    def pointer(self):
        """For functions of C."""
        if self._pointer is None:
            raise ValueError("the world is closed")
        return self._pointer

    def close(self):
        """Destroys the world, unless that has happened."""
        if self._pointer is not None:
            cn_world_destroy(self._pointer)
            self._pointer = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        self.close()

    def on_contact(self, kind, function):
        """Calls function(event) for contact events of one kind (CN_EVENT_*), while the world is locked; None ends that. The
        event is valid during the call."""
        callback = cn_contact_event_fn(function and (lambda _world, event, _user: function(event.contents)) or 0)
        _check(cn_world_set_contact_callback(self.pointer, kind, callback, None), self.pointer)
        self._callbacks[kind] = callback

    @classmethod
    def read(cls, file, definition=None, **fields):
        """A world from the bytes of write. Of the definition only memory, workers and capacities are used."""
        pointer = _c.POINTER(cn_world)()
        _check(cn_world_read(_made(definition or WorldDef(), fields), file, len(file), pointer))
        world = cls.__new__(cls)
        world._callbacks, world._pointer = {}, pointer
        return world
'''
TREE = '''

class Tree:
    """A dynamic AABB tree; the garbage collector destroys it."""

    _pointer = None

    def __init__(self, margin_m):
        pointer = _c.POINTER(cn_tree)()
        _check(cn_tree_create(margin_m, cn_alloc_fn(), cn_free_fn(), None, pointer))
        self._pointer = self.pointer = pointer

    def __del__(self):
        if self._pointer is not None:
            cn_tree_destroy(self._pointer)
'''


def docstring(doc, indent):
    return names.comment(doc.replace("\\", "\\\\").replace('"', "'"), "", indent).strip()


def layer_calls(api, owner):
    """Without Python's keywords as names."""
    for call in idiom.methods(api, owner):
        for entry in call["inputs"] + call["parameters"]:
            if entry["name"] == "def":
                entry["name"] = "definition"
        yield call


def write(api):
    api = copy.deepcopy(api)
    out = [START]
    for struct, init in idiom.inits(api).items():
        doc = next(entry["doc"] for entry in api["structs"] if entry["name"] == struct)
        name = idiom.type_name(struct)
        out.append('\n\ndef %s(**fields):\n    """A %s with its defaults but for the given fields. %s"""\n' % (name, struct, docstring(doc, "    ")))
        out.append("    definition = %s()\n    %s(definition)\n    return _made(definition, fields)\n" % (struct, init))
    for text, owner in ((WORLD, "world"), (TREE, "tree")):
        out += [text] + [write_call(call, api, "    ") for call in layer_calls(api, owner)]
    out += ["\n"] + [write_call(call, api, "") for call in layer_calls(api, "")]
    return "".join(out)


def ctype(base):
    """Of a value that C writes."""
    return "_c.c_" + base.replace("_t", "") if base == "float" or base.endswith("_t") else base


def signature(call):
    required = [entry["name"] for entry in call["inputs"] if not optional(entry, call)]
    return required + [entry["name"] + "=None" for entry in call["inputs"] if optional(entry, call)]


def optional(entry, call):
    """Arguments at the end that may be left out. Names are given: nullable ones that come first become keywords."""
    return entry["nullable"] or entry["kind"] == "fill"


def write_call(call, api, indent):
    inputs = {entry["name"]: entry for entry in call["inputs"]}
    owner, body = call["owner"], []
    for entry in call["inputs"]:
        if entry["kind"] in ("array", "changes"):
            body.append("%s = _array(%s, %s)" % (entry["name"], entry["base"], entry["name"]))
    body += counting(call)
    arguments = ["self.pointer"] if owner else []
    for part in call["parameters"][len(arguments) :]:
        entry = inputs.get(part["name"])
        if entry is None:
            arguments += ["_count"] if part["name"] == "count" else ["len(%s)" % idiom.bytes_of(call, part)["name"]] if idiom.bytes_of(call, part) else []
        elif entry["kind"] == "string":
            body.append("%s = %s and %s.encode()" % (entry["name"], entry["name"], entry["name"]))
            arguments.append(entry["name"])
        else:
            arguments.append(entry["name"])
    body += outputs_of(call, arguments, api)
    head = "%sdef %s(%s):\n" % (indent, call["name"], ", ".join((["self"] if owner else []) + signature(call)))
    doc = '%s    """%s"""\n' % (indent, docstring(call["doc"], indent + "    "))
    return ("\n" if owner else "\n\n") + head + doc + "".join("%s    %s\n" % (indent, line) for line in body)


def counting(call):
    """_count, arrays of one length, and an array to fill if there is none."""
    if not any(entry["length"] == "count" for entry in call["inputs"]):
        return []
    arrays = [entry for entry in call["inputs"] if entry["length"] == "count"]
    fill = [entry for entry in arrays if entry["kind"] == "fill"]
    given = [entry for entry in arrays if entry["kind"] != "fill"]
    if not fill:
        base = idiom.counted(call)["name"]
        others = [entry["name"] for entry in arrays if entry["name"] != base]
        return ["_count = len(%s)" % base] + (["_even(_count, %s)" % ", ".join(others)] if others else [])
    out, first = fill[0], given[0]
    lines = []
    if first["nullable"]:
        lines += ["if %s is None and %s is None:" % (first["name"], out["name"]), "    %s = (%s * len(self.get_bodies()))()" % (out["name"], out["base"])]
        lines += ["elif %s is None:" % out["name"]]
    else:
        lines += ["if %s is None:" % out["name"]]
    lines += ["    %s = (%s * len(%s))()" % (out["name"], out["base"], first["name"]), "_count = len(%s)" % out["name"], "_even(_count, %s)" % first["name"]]
    return lines


def outputs_of(call, arguments, api):
    world = ", self.pointer" if call["owner"] == "world" and call["changes"] else ""  # others leave no sentence
    invoke = lambda extra: "%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    outputs = call["outputs"]
    if call["result"] != "error":
        text = invoke([])
        return ["return %s" % (text + ".decode()" if "char" in call["result"] else "bool(%s)" % text if call["name"].endswith("is_valid") else text)]
    fill = [entry["name"] for entry in call["inputs"] if entry["kind"] == "fill"]
    if not outputs:
        return ["_check(%s%s)" % (invoke([]), world)] + (["return %s" % fill[0]] if fill else [])
    kind, base = outputs[0]["kind"], outputs[0]["base"]
    if kind == "list":
        return ["count = _c.c_int32()", "_check(%s%s)" % (invoke(["None", "0", "count"]), world), "out = (%s * count.value)()" % base,
            "_check(%s%s)" % (invoke(["out", "count", "count"]), world), "return out"]  # fmt: skip
    if kind == "bytes":
        size = "_check(%s(%s))" % (call["room"], ", ".join([*arguments, "_bytes"])) if call["room"] else "_bytes.value = %s" % " + ".join("len(%s)" % name for name in idiom.bytes_in(call))
        return ["_bytes = _c.c_uint64()", size, "_out = _c.create_string_buffer(_bytes.value or 1)", "_check(%s)" % invoke(["_out", "_bytes", "_bytes"]), "return _out.raw[: _bytes.value]"]
    if kind == "view":
        return ["data, count = _c.POINTER(%s)(), _c.c_int32()" % base, "_check(%s%s)" % (invoke(["data", "count"]), world), "return _copy(%s, data, count.value)" % base]
    if kind == "string":
        return ["text = _c.c_char_p()", "_check(%s%s)" % (invoke(["text"]), world), "return text.value.decode()"]
    structs = names.structs(api)
    lines = ["_%s = %s()" % (entry["name"], ctype(entry["base"])) for entry in outputs]
    lines.append("_check(%s%s)" % (invoke(["_" + entry["name"] for entry in outputs]), world))
    return lines + ["return " + ", ".join("_" + entry["name"] + ("" if entry["base"] in structs else ".value") for entry in outputs)]
