"""Writes javascript/cairn.js (start.js and classes made of idiom.py) and the TypeScript types of the same."""
import json
import os

from . import idiom, names
from .header import SCALARS as SIZES

HERE = os.path.dirname(os.path.abspath(__file__))
KINDS = {"float": "f32", "double": "f64", "char": "i8"}
WORLD_JS = """
export class World {
	#pointer;
	constructor(def = {}, file = null) {
		begin();
		const out = take(4), given = struct("cn_world_def", def);
		check(file ? raw.cn_world_read(given, array("u8", file), BigInt(file.length), out) : raw.cn_world_create(given, out));
		refresh();
		this.#pointer = view.getUint32(out, true);
		worlds.register(this, this.#pointer, this);
	}
	static read(file, def = {}) {
		return new World(def, file);
	}
	get pointer() {
		if (this.#pointer === 0)
			throw new TypeError("the world is destroyed");
		return this.#pointer;
	}
	destroy() {
		worlds.unregister(this);
		raw.cn_world_destroy(this.#pointer);
		this.#pointer = 0;
	}
"""
TREE_JS = """
export class Tree {
	#pointer;
	constructor(margin_m) {
		begin();
		const out = take(4);
		check(raw.cn_tree_create(margin_m, 0, 0, 0, out));
		refresh();
		this.#pointer = view.getUint32(out, true);
		trees.register(this, this.#pointer, this);
	}
	get pointer() { return this.#pointer; }
"""
WORLD_TS = """
/** A world with everything in it. It is destroyed by destroy(), else some time after nothing refers to it. */
export class World {
	constructor(def?: Partial<WorldDef>);
	/** For functions of raw. */
	readonly pointer: number;
	destroy(): void;
	/** A world from the bytes of write. Of the definition only workers and capacities are used. */
	static read(file: Uint8Array, def?: Partial<WorldDef>): World;
"""
TREE_TS = """
/** A dynamic AABB tree apart from any world. */
export class Tree {
	constructor(margin_m: number);
	readonly pointer: number;
"""
TS = """// Types of Cairn for JavaScript. %s

/** C's functions, on the memory of the module. */
export const raw: WebAssembly.Exports & Record<string, any>;
/** A call that failed: code is CN_ERROR_..., the message is the library's sentence. */
export class CairnError extends Error {
	readonly code: number;
}
/** A struct going in: fields that are not given have their defaults. */
export type In<T> = T extends number ? T : T extends object ? { [K in keyof T]?: In<T[K]> } : T;

"""


def kind(base, api):
    base = names.aliases(api).get(base, base)
    return KINDS.get(base) or (base[:-2].replace("uint", "u").replace("int", "i") if base.endswith("_t") else base)


def place(api):
    """Sizes and offsets where a pointer has 4 bytes, as in wasm32: name -> (size, alignment, fields)."""
    placed = {}
    for struct in api["structs"]:
        offset, widest, fields = 0, 1, []
        for field in struct["fields"]:
            base = names.aliases(api).get(field["base"], field["base"])
            size, alignment = (4, 4) if field["pointers"] else placed[base][:2] if base in placed else (SIZES[base],) * 2
            offset = -(-offset // alignment) * alignment
            fields.append((field, offset))
            offset, widest = offset + size * (field["array"] or 1), max(widest, alignment)
        placed[struct["name"]] = (-(-offset // widest) * widest, widest, fields)
    return placed


def floats(name, api):
    struct = next((entry for entry in api["structs"] if entry["name"] == name), None)
    return struct is not None and all(not f["pointers"] and (f["base"] == "float" or floats(f["base"], api)) for f in struct["fields"])


def flat(entry, api):
    return entry["base"] in ("cn_pose", "cn_vec2", "cn_velocity")


def tables(api):
    out, inits = ["const STRUCTS = {\n"], idiom.inits(api)
    for name, (size, _, placed) in place(api).items():
        fields = []
        for field, offset in placed:
            if not field["pointers"]:
                fields.append([field["name"], offset, kind(field["base"], api), field["array"]])
            elif field["string"]:
                fields.append([field["name"], offset, "string", 0])
            elif field["length"] and field["base"] != "void":
                fields.append([field["name"], offset, "array:" + field["base"], 0, field["length"]])
        out.append("\t%s: { size: %d, init: %s, floats: %s, fields: %s },\n" % (name, size, json.dumps(inits.get(name)), json.dumps(name in ("cn_pose", "cn_vec2", "cn_velocity")), json.dumps(fields)))
    checks = ", ".join('["%s", %s]' % (entry["name"], entry["sizeof_type"]) for entry in names.checked_structs(api))
    return "".join(out) + "};\nfor (const name in STRUCTS)\n\tSTRUCTS[name].names = new Set(STRUCTS[name].fields.map(field => field[0]));\n", checks


def write(api):
    with open(os.path.join(HERE, "..", "javascript", "start.js"), encoding="utf-8") as file:
        out = [file.read().replace("@NOTICE@", names.NOTICE), "\n"]
    out += ["export const %s = %d;\n" % (name, value) for name, value, _ in names.all_constants(api)]
    table, checks = tables(api)
    out += ["\n", table, "if (raw.cn_abi_version() !== CN_ABI_VERSION)\n\tthrow new Error(`cairn.js is for ABI ${CN_ABI_VERSION}, cairn.wasm has ${raw.cn_abi_version()}`);\n"]
    out.append("for (const [name, type] of [%s])\n\tif (STRUCTS[name].size !== raw.cn_sizeof(type))\n\t\tthrow new Error(`${name} has another size in cairn.wasm`);\n" % checks)
    for text, owner in ((WORLD_JS, "world"), (TREE_JS, "tree")):
        out += [text] + [function(call, api, "\t") for call in idiom.methods(api, owner)] + ["}\n"]
    return "".join(out + [function(call, api, "") for call in idiom.methods(api, "")])


def js_name(name):
    return {"default": "default_"}.get(idiom.camel(name), idiom.camel(name))


def argument(part, call, inputs, api):
    entry = inputs.get(part["name"])
    if entry is None:
        of = idiom.bytes_of(call, part)
        return "count" if part["name"] == "count" else "BigInt(%s.length)" % of["name"] if of else None
    name, wide = entry["name"], names.aliases(api).get(entry["base"], entry["base"])
    if entry["kind"] == "value":
        return "BigInt(%s)" % name if wide in ("uint64_t", "int64_t") else name
    return "p_" + name


def function(call, api, indent):
    inputs, body, owner = {entry["name"]: entry for entry in call["inputs"]}, [], ["this.pointer"] if call["owner"] else []
    pointers = [entry for entry in call["inputs"] if entry["kind"] != "value"]
    counted = [entry for entry in call["inputs"] if entry["length"] == "count"]
    body.append("begin();")
    fill = [entry for entry in counted if entry["kind"] == "fill"]
    sized = [entry for entry in counted if entry["kind"] != "fill"]
    if counted:
        expression = 'size("%s", %s)' % (kind(sized[-1]["base"], api), sized[-1]["name"])
        if fill and sized[-1]["nullable"]:
            first, out = sized[-1]["name"], fill[0]["name"]
            body += ["const count = %s ? %s : %s ? size(\"%s\", %s) : this.getBodies().length;" % (first, expression, out, fill[0]["base"], out), "begin();"]
        else:
            body.append("const count = %s;" % expression)
        for entry in sized[:-1] + fill:
            body.append("if (%s)\n%s\t\teven(size(\"%s\", %s), count);" % (entry["name"], indent, kind(entry["base"], api), entry["name"]))
    for entry in pointers:
        name, of = entry["name"], kind(entry["base"], api)
        made = {"struct": 'struct("%s", %s)' % (of, name), "change": 'struct("%s", %s)' % (of, name), "array": 'array("%s", %s)' % (of, name), "changes": 'array("%s", %s)' % (of, name),
            "fill": 'take(stride("%s") * count || 1)' % of, "string": "string(%s)" % name, "bytes": 'array("u8", %s)' % name}[entry["kind"]]  # fmt: skip
        body.append("const p_%s = %s;" % (name, "%s ? %s : 0" % (name, made) if entry["nullable"] and entry["kind"] != "string" else made))
    body += results(call, api, owner, pointers, inputs)
    head = "%s%s%s(%s) {\n" % (indent, "" if owner else "export function ", js_name(call["name"]), ", ".join(entry["name"] for entry in ordered(call)))
    return "\n" + head + "".join("%s\t%s\n" % (indent, line) for line in body) + indent + "}\n"


def ordered(call):
    """What may be left out comes last."""
    optional = lambda entry: entry["nullable"] or entry["kind"] == "fill"  # noqa: E731
    return [entry for entry in call["inputs"] if not optional(entry)] + [entry for entry in call["inputs"] if optional(entry)]


def results(call, api, owner, pointers, inputs):
    outputs, body = call["outputs"], []
    arguments = owner + [text for text in (argument(part, call, inputs, api) for part in call["parameters"][len(owner) :]) if text is not None]
    invoke = lambda extra: "raw.%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    world = ", this.pointer" if call["owner"] == "world" and call["changes"] else ""
    if call["result"] != "error":
        return ["return " + ("text(%s)" if "char" in call["result"] else "%s !== 0" if call["name"].endswith("is_valid") else "%s") % invoke([]) + ";"]
    after = []
    for entry in pointers:
        if entry["kind"] == "change":
            after.append('Object.assign(%s, readStruct("%s", p_%s));' % (entry["name"], entry["base"], entry["name"]))
        elif entry["kind"] == "changes":
            after.append('list("%s", p_%s, count, %s);' % (kind(entry["base"], api), entry["name"], entry["name"]))
    if not outputs:
        body += ["check(%s%s);" % (invoke([]), world)] + (["refresh();"] + after if after else [])
        return body + ['return list("%s", p_%s, count, %s);' % (kind(e["base"], api), e["name"], e["name"]) for e in pointers if e["kind"] == "fill"]
    if outputs[0]["kind"] == "bytes":
        size = ["check(raw.%s(%s));" % (call["room"], ", ".join([*arguments, "number"])), "refresh();", "const bytes = view.getBigUint64(number, true), out = take(Number(bytes) || 1);"]
        if not call["room"]:
            size = ["const bytes = BigInt(%s), out = take(Number(bytes) || 1);" % " + ".join(name + ".length" for name in idiom.bytes_in(call))]
        return ["const number = take(8);", *size, "check(%s);" % invoke(["out", "bytes", "number"]), "refresh();", "return u8.slice(out, out + Number(view.getBigUint64(number, true)));"]
    of = kind(outputs[0]["base"], api)
    if outputs[0]["kind"] == "list":
        return body + ["const number = take(4);", "check(%s%s);" % (invoke(["0", "0", "number"]), world), "refresh();", "const found = view.getInt32(number, true), out = take(stride(\"%s\") * found || 1);" % of,
            "if (found > 0)\n\t\t\tcheck(%s%s);" % (invoke(["out", "found", "number"]), world), 'return list("%s", out, found);' % of]  # fmt: skip
    body += ["const o_%s = take(%s);" % (e["name"], "8" if e["kind"] in ("view", "string") else 'stride("%s")' % kind(e["base"], api)) for e in outputs]
    if outputs[0]["kind"] == "view":
        name = "o_" + outputs[0]["name"]
        return body + ["check(%s%s);" % (invoke([name, name + " + 4"]), world), "refresh();", 'return list("%s", view.getUint32(%s, true), view.getInt32(%s + 4, true));' % (of, name, name)]
    body += ["check(%s%s);" % (invoke(["o_" + e["name"] for e in outputs]), world), "refresh();"] + after
    if outputs[0]["kind"] == "string":
        return body + ["return text(view.getUint32(o_%s, true));" % outputs[0]["name"]]
    structs = names.structs(api)
    values = ['readStruct("%s", o_%s)' % (e["base"], e["name"]) if e["base"] in structs else "READ.%s(o_%s)" % (kind(e["base"], api), e["name"]) for e in outputs]
    return body + ["return %s;" % (values[0] if len(values) == 1 else "{ %s }" % ", ".join("%s: %s" % (e["name"], value) for e, value in zip(outputs, values)))]


# ---------------------------------------------------------------- types


def ts_type(base, api):
    if base in {entry["name"] for entry in api["handles"]} | names.structs(api):
        return idiom.type_name(base)
    return "bigint" if names.aliases(api).get(base, base) in ("uint64_t", "int64_t") else "number"


def ts_array(entry, api):
    return "Float32Array" if flat(entry, api) else ts_type(entry["base"], api) + "[]"


def ts_doc(doc, indent):
    return names.comment("/** %s */" % doc.replace("*/", "* /"), "", indent) if doc else ""


def write_types(api):
    out = [TS % names.NOTICE]
    out += ["%sexport const %s: %d;\n" % ("", name, value) for name, value, _ in names.all_constants(api)]
    for entry in api["handles"]:
        out.append("\n%sexport type %s = number & { readonly __handle: \"%s\" };\n" % (ts_doc(entry["doc"], ""), idiom.type_name(entry["name"]), entry["name"]))
    for struct in api["structs"]:
        out.append("\n%sexport interface %s {\n" % (ts_doc(struct["doc"], ""), idiom.type_name(struct["name"])))
        for field in struct["fields"]:
            if field["pointers"] and (field["base"] in names.callbacks(api) or field["base"] == "void"):
                continue
            text = "string" if field["pointers"] and field["string"] else "%s[] | Float32Array" % ts_type(field["base"], api) if field["pointers"] else ts_type(field["base"], api) + ("[]" if field["array"] else "")
            out.append("%s\t%s%s: %s;\n" % (ts_doc(field["doc"], "\t"), field["name"], "?" if field["pointers"] else "", text))
        out.append("}\n")
    for text, owner in ((WORLD_TS, "world"), (TREE_TS, "tree")):
        out += [text] + [signature(call, api, "\t") for call in idiom.methods(api, owner)] + ["}\n"]
    return "".join(out + ["\n"] + [signature(call, api, "") for call in idiom.methods(api, "")])


def signature(call, api, indent):
    parameters = []
    for entry in ordered(call):
        base = ts_type(entry["base"], api)
        text = {"value": "number | bigint" if base == "bigint" else base, "struct": "In<%s>" % base, "change": base, "array": "In<%s>[]%s" % (base, " | Float32Array" if flat(entry, api) else ""),
            "changes": base + "[]", "fill": ts_array(entry, api), "string": "string | null", "bytes": "Uint8Array"}[entry["kind"]]  # fmt: skip
        optional = entry["nullable"] or entry["kind"] == "fill"
        parameters.append("%s%s: %s%s" % (entry["name"], "?" if optional else "", text, " | null" if optional and entry["kind"] != "string" else ""))
    types = {"bytes": lambda e, a: "Uint8Array", "list": ts_array, "view": ts_array, "string": lambda e, a: "string", "value": lambda e, a: ts_type(e["base"], a)}
    values = [(e["name"], types[e["kind"]](e, api)) for e in call["outputs"]]
    result = "void" if not values else values[0][1] if len(values) == 1 else "{ %s }" % "; ".join("%s: %s" % v for v in values)
    fill = [entry for entry in call["inputs"] if entry["kind"] == "fill"]
    if fill:
        result = ts_array(fill[0], api)
    if call["result"] != "error":
        result = "string" if "char" in call["result"] else "boolean" if call["name"].endswith("is_valid") else "number"
    return "%s%s%s%s(%s): %s;\n" % (ts_doc(call["doc"], indent), indent, "" if indent else "export function ", js_name(call["name"]), ", ".join(parameters), result)
