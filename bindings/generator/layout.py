"""Adds sizes and offsets on 64-bit machines to the api, and refuses structs that languages could lay
out differently: padding that is not written down, and fields that no language can name.
"""
import keyword

from .header import SCALARS, HeaderError

LUA_WORDS = set("and break do else elseif end false for function goto if in local nil not or repeat return then true until while".split())


def add(api):
    known = {name: (size, size) for name, size in SCALARS.items()}
    for entry in api["handles"] + api["scalars"]:
        known[entry["name"]] = known[entry["type"]]
    for struct in api["structs"]:
        known[struct["name"]] = place(struct, known)
    add_type_numbers(api)


def place(struct, known):
    """Size and alignment of one struct, by the rules that all C compilers for 64-bit machines share."""
    offset, widest = 0, 1
    for field in struct["fields"]:
        name = "%s.%s" % (struct["name"], field["name"])
        if keyword.iskeyword(field["name"]) or field["name"] in LUA_WORDS:
            raise HeaderError("%s is a keyword in Python or Lua" % name)
        size, alignment = (8, 8) if field["pointers"] else known[field["base"]]
        if offset % alignment:
            raise HeaderError("%s: %d bytes of padding before it; add a reserved field" % (name, alignment - offset % alignment))
        field["offset"], field["size"] = offset, size * (field["array"] or 1)
        offset, widest = offset + field["size"], max(widest, alignment)
    if offset % widest:
        raise HeaderError("%s: %d bytes of padding at its end; add a reserved field" % (struct["name"], widest - offset % widest))
    struct["size"], struct["alignment"] = offset, widest
    return offset, widest


def add_type_numbers(api):
    """Structs get the number by which cn_sizeof knows them, so that bindings can check themselves."""
    by_name = {struct["name"]: struct for struct in api["structs"]}
    for struct in api["structs"]:
        struct["sizeof_type"] = None
    for value in (value for enum in api["enums"] for value in enum["values"]):
        if value["name"].startswith("CN_TYPE_") and value["name"] != "CN_TYPE_COUNT":
            struct = by_name.get("cn_" + value["name"][len("CN_TYPE_") :].lower())
            if struct is None:
                raise HeaderError("%s names no struct" % value["name"])
            struct["sizeof_type"] = value["name"]
