"""Writes python/cairn.py: the header as ctypes sees it."""
from . import names

START = '''"""Cairn for Python (ctypes), one to one with cairn.h.
%s

    import ctypes
    from cairn import *

    definition = cn_world_def()
    cn_world_def_init(definition)
    world = ctypes.POINTER(cn_world)()
    assert cn_world_create(definition, world) == CN_OK

Where C takes a pointer to a struct or number, pass the struct or a ctypes number itself; where it
takes an array, pass an array. CAIRN_LIBRARY in the environment names another file than the system's
libcairn.
"""
import ctypes as _c
import os as _os
import sys as _sys

_files = {"darwin": "libcairn.dylib", "win32": "cairn.dll"}
_library = _c.CDLL(_os.environ.get("CAIRN_LIBRARY") or _files.get(_sys.platform, "libcairn.so"))

# A library of another version would read other structs: refuse it here and, by their sizes, below.
if _library.cn_abi_version() != %d:
    raise ImportError("cairn.py is for ABI %d, the library has %%d" %% _library.cn_abi_version())


def _function(name, result, *arguments):
    function = getattr(_library, name)
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
            out.append("class %s(_c.Structure):\n%s    _fields_ = [\n" % (entry["name"], names.comment(entry["doc"], "# ", "    ")))
            out += [field_line(field, api) for field in entry["fields"]]
            out.append("    ]\n")
    out.append("\n\n")
    for function in api["functions"]:
        types = [spell(part, api) for part in [function["returns"], *function["parameters"]]]
        out.append(names.comment(function["doc"], "# ") + '%s = _function("%s", %s)\n' % (function["name"], function["name"], ", ".join(types)))
    checks = "".join("    (%s, %s),\n" % (struct["name"], struct["sizeof_type"]) for struct in names.checked_structs(api))
    return "".join(out) + END % checks


def field_line(field, api):
    array = " * %d" % field["array"] if field["array"] else ""
    doc = "  # " + field["doc"] if field["doc"] else ""
    return '        ("%s", %s%s),%s\n' % (field["name"], spell(field, api), array, doc)
