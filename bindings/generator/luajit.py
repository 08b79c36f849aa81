"""Writes luajit/cairn.lua: the header as ffi.cdef sees it, the loader and its checks.

The module is the library's own namespace (cn.cn_world_step, cn.CN_OK): nothing stands between Lua
and the call, which is what LuaJIT compiles best.
"""
from . import names

START = """-- cairn.lua - Cairn for LuaJIT, one to one with cairn.h.
-- %s
--
--     local ffi = require "ffi"
--     local cn = require "cairn"           -- the library's namespace: cn.cn_world_step, cn.CN_OK
--     local world = ffi.new "cn_world *[1]"
--     local def = ffi.new "cn_world_def"
--     cn.cn_world_def_init(def)
--     assert(cn.cn_world_create(def, world) == cn.CN_OK)
--
-- CAIRN_LIBRARY in the environment names another file than the system's libcairn.
local ffi = require "ffi"

ffi.cdef [[
"""
END = """]]

local cairn = ffi.load(os.getenv "CAIRN_LIBRARY" or "cairn")

-- A library of another version would read other structs: refuse it here.
if cairn.cn_abi_version() ~= cairn.CN_ABI_VERSION then
	error(("cairn.lua is for ABI %%d, the library has %%d"):format(cairn.CN_ABI_VERSION, cairn.cn_abi_version()))
end
for name, number in pairs {
%s} do
	if ffi.sizeof(name) ~= cairn.cn_sizeof(number) then
		error(("%%s has %%d bytes here, %%d in the library"):format(name, ffi.sizeof(name), cairn.cn_sizeof(number)))
	end
end

return cairn
"""


def write(api):
    out = [START % names.NOTICE]
    for constant in api["constants"]:
        out.append("static const %s %s = %d;\n" % (constant["type"], constant["name"], constant["value"]))
    for enum in api["enums"]:
        out.append("\n" + c_comment(enum["doc"]) + "enum {\n")
        out += ["\t%s = %d,%s\n" % (value["name"], value["value"], behind(value)) for value in enum["values"]]
        out.append("};\n")
    out.append("\n")
    out += ["typedef %s %s;\n" % (entry["type"], entry["name"]) for entry in api["scalars"] + api["handles"]]
    out += ["typedef struct %s %s;\n" % (entry["name"], entry["name"]) for entry in api["opaque"]]
    for entry in names.in_order(api):
        out.append("\n" + c_comment(entry["doc"]))
        if "parameters" in entry:
            out.append("typedef %s;\n" % names.prototype(entry))
        else:
            out.append("typedef struct %s {\n" % entry["name"])
            out += ["\t%s;%s\n" % (names.declaration(field), behind(field)) for field in entry["fields"]]
            out.append("} %s;\n" % entry["name"])
    out.append("\n")
    for function in api["functions"]:
        out.append(c_comment(function["doc"]) + names.prototype(function) + ";\n")
    checks = "".join("\t%s = cairn.%s,\n" % (struct["name"], struct["sizeof_type"]) for struct in names.checked_structs(api))
    return "".join(out) + END % checks


# A doc must not hold ]], which would end the cdef.
def c_comment(doc):
    return names.comment(doc.replace("]]", "] ]"), "// ")


def behind(entry):
    return " // " + entry["doc"].replace("]]", "] ]") if entry["doc"] else ""
