"""Writes python/cairn.py: the header as ctypes sees it, and above it the classes of python_layer.py."""
from . import names, python_layer

START = '''"""Cairn for Python (ctypes), one to one with cairn.h.
%s

    import cairn

    world = cairn.World(gravity_mps2=(0, -10))
    body = world.body_create(cairn.BodyDef(position_m=(0, 4)))
    world.shape_create_box(cairn.ShapeDef(body=body), 0.5, 0.5, 0)
    world.step(1 / 60)
    print(world.body_get_pose(body).position_m.y)

Below the classes are C's functions under their own names (cn_world_step), for ctypes: where C takes a pointer to a struct or
number, pass the struct or a ctypes number itself; where it takes an array, pass an array. The library is the one beside this
file, else the system's; CAIRN_LIBRARY in the environment names another.
"""
import ctypes as _c
import os as _os
import sys as _sys

_files = {"darwin": "libcairn.dylib", "win32": "cairn.dll"}
_file = _files.get(_sys.platform, "libcairn.so")
_beside = _os.path.join(_os.path.dirname(_os.path.abspath(__file__)), _file)
_library = _c.CDLL(_os.environ.get("CAIRN_LIBRARY") or (_beside if _os.path.exists(_beside) else _file))

# A library of another version would read other structs: refuse it here and, by their sizes, below.
if _library.cn_abi_version() != %d:
    raise ImportError("cairn.py is for ABI %d, the library has %%d" %% _library.cn_abi_version())


def _function(name, doc, result, *arguments):
    function = getattr(_library, name)
    function.__doc__ = doc
    function.restype = result
    function.argtypes = arguments
    return function


'''
END = """

for _struct, _number in (
%s):
    if _c.sizeof(_struct) != cn_sizeof(_number):
        raise ImportError("%%s has %%d bytes here, %%d in the library" %% (_struct.__name__, _c.sizeof(_struct), cn_sizeof(_number)))
"""
SCALARS = {"float": "_c.c_float", "double": "_c.c_double", "void": "None"}


def spell(part, api):
    base, pointers = part["base"], part["pointers"]
    if base == "char" and pointers:
        text, pointers = "_c.c_char_p", pointers - 1
    elif base == "void" and pointers:
        text, pointers = "_c.c_void_p", pointers - 1
    elif base in names.callbacks(api):
        text, pointers = base, pointers - 1  # a CFUNCTYPE is a pointer already
    elif base in SCALARS:
        text = SCALARS[base]
    elif base.endswith("_t"):
        text = "_c.c_" + base[:-2]
    else:
        text = base
    # A char * that the library writes to must be a buffer, which c_char_p is not.
    if part["base"] == "char" and part["pointers"] == 1 and not part["const"]:
        text = "_c.POINTER(_c.c_char)"
    return "_c.POINTER(" * pointers + text + ")" * pointers


def write(api):
    out = [START % (names.NOTICE, api["abi_version"], api["abi_version"])]
    out += ["%s = %d\n" % (name, value) for name, value, _ in names.all_constants(api)]
    out.append("\n")
    out += ["%s = _c.c_%s\n" % (entry["name"], entry["type"][:-2]) for entry in api["scalars"] + api["handles"]]
    out += ["\n\nclass %s(_c.Structure):\n    pass\n" % entry["name"] for entry in api["opaque"]]
    for entry in names.in_order(api):
        out.append("\n\n")
        if "parameters" in entry:
            types = [spell(part, api) for part in [entry["returns"], *entry["parameters"]]]
            out.append(names.comment(entry["doc"], "# ") + "%s = _c.CFUNCTYPE(%s)\n" % (entry["name"], ", ".join(types)))
        else:
            out.append('class %s(_c.Structure):\n    """%s"""\n\n    _fields_ = [\n' % (entry["name"], docstring(entry["doc"], "    ")))
            out += [field_line(field, api) for field in entry["fields"]]
            out.append("    ]\n")
    out.append("\n\n")
    for function in api["functions"]:
        types = [spell(part, api) for part in [function["returns"], *function["parameters"]]]
        doc = '    """%s"""' % docstring(function["doc"], "    ")
        out.append('%s = _function(\n    "%s",\n%s,\n    %s,\n)\n' % (function["name"], function["name"], doc, ", ".join(types)))
    checks = "".join("    (%s, %s),\n" % (struct["name"], struct["sizeof_type"]) for struct in names.checked_structs(api))
    return "".join(out) + END % checks + python_layer.write(api)


docstring = python_layer.docstring


def field_line(field, api):
    array = " * %d" % field["array"] if field["array"] else ""
    doc = "  # " + field["doc"] if field["doc"] else ""
    return '        ("%s", %s%s),%s\n' % (field["name"], spell(field, api), array, doc)
