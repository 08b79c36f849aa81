"""Writes cpp/cairn.hpp: cpp/start.hpp, then classes made of the calls of idiom.py."""
import os

from . import idiom, names

HERE = os.path.dirname(os.path.abspath(__file__))
CLASS = """
/// %(doc)s
class %(type)s {
public:
%(create)s	explicit %(type)s(%(c)s *owned) noexcept : %(field)s(owned) {}
	%(type)s(%(type)s &&other) noexcept : %(field)s(std::exchange(other.%(field)s, nullptr)) {}
	%(type)s &operator=(%(type)s &&other) noexcept
	{
		std::swap(%(field)s, other.%(field)s);
		return *this;
	}
	~%(type)s() { %(c)s_destroy(%(field)s); }
	/// For functions of cairn.h.
	%(c)s *get() const noexcept { return %(field)s; }
"""
WORLD = """	/// A world with the defaults, or of a definition; an error if there is no memory or a value is bad.
	static Result<World> create(const cn_world_def &def)
	{
		cn_world *out = nullptr;
		cn_result code = cn_world_create(&def, &out);
		return { Status(code, nullptr), World(out) };
	}
	/// A world from bytes of write. Of the definition only memory, workers and capacities are used.
	static Result<World> read(Slice<const unsigned char> file, const cn_world_def *def = nullptr)
	{
		cn_world *out = nullptr;
		cn_result code = cn_world_read(def, file.data(), file.size(), &out);
		return { Status(code, nullptr), World(out) };
	}
	/// As create, which throws or ends the program instead.
	explicit World(const cn_world_def &def = WorldDef()) : World(create(def).value()) {}
"""
TREE = """	/// An empty tree in memory of malloc.
	static Result<Tree> create(float margin_m)
	{
		cn_tree *out = nullptr;
		cn_result code = cn_tree_create(margin_m, nullptr, nullptr, nullptr, &out);
		return { Status(code, nullptr), Tree(out) };
	}
"""
SAVE = """	/// The sentence of the last call that failed, "" if none did.
	const char *error_text() const noexcept { return cn_world_error_text(world_); }
	/// Calls function(event) for contact events of one kind, while the world is locked; null ends that. The function stays the
	/// caller's and must live as long as it may be called. No exception may leave it.
	template <class F> Status on_contact(int32_t kind, F &function)
	{
		auto call = [](cn_world *, const cn_contact_event *event, void *user) { (*static_cast<F *>(user))(*event); };
		return { cn_world_set_contact_callback(world_, kind, call, &function), world_ };
	}
	Status on_contact(int32_t kind, std::nullptr_t) { return { cn_world_set_contact_callback(world_, kind, nullptr, nullptr), world_ }; }
"""


def write(api):
    with open(os.path.join(HERE, "..", "cpp", "start.hpp"), encoding="utf-8") as file:
        out = [file.read().replace("@NOTICE@", names.NOTICE)]
    handles = [entry["name"] for entry in api["handles"]]
    out += ["using %s = Handle<%s, %d>;\n" % (idiom.type_name(name), name, i) for i, name in enumerate(handles)]
    out.append("\n")
    for struct, init in idiom.inits(api).items():
        out.append("/// %s with its defaults.\nstruct %s : %s {\n\t%s() noexcept : %s() { %s(this); }\n};\n" % (struct, idiom.type_name(struct), struct, idiom.type_name(struct), struct, init))
    for owner, create, more in (("world", WORLD, SAVE), ("tree", TREE, "")):
        out.append(CLASS % {"doc": "Owns a cn_%s." % owner, "type": idiom.type_name("cn_" + owner), "c": "cn_" + owner, "field": owner + "_", "create": create} + more)
        for call in idiom.methods(api, owner):
            out.append(write_call(call, handles, "\t"))
        out.append("\nprivate:\n\tcn_%s *%s_;\n};\n" % (owner, owner))
    for call in idiom.methods(api, ""):
        out.append(write_call(call, handles, ""))
    out.append("\n} // namespace cairn\n\n#endif\n")
    return "".join(out)


def typed(base, handles):
    return idiom.type_name(base) if base in handles else base


def parameter(entry, handles):
    base, name = entry["base"], entry["name"]
    const = "const " if entry["kind"] in ("array", "struct") else ""
    return {
        "value": lambda: "%s %s" % (typed(base, handles), name),
        "struct": lambda: "const %s *%s" % (base, name) if entry["nullable"] else "const %s &%s" % (base, name),
        "array": lambda: "Slice<%s%s> %s" % (const, base, name),
        "fill": lambda: "Slice<%s> %s" % (base, name),
        "changes": lambda: "Slice<%s> %s" % (base, name),
        "change": lambda: "%s &%s" % (base, name),
        "string": lambda: "const char *%s" % name,
        "bytes": lambda: "Slice<const unsigned char> %s" % name,
    }[entry["kind"]]()


def argument(part, call, inputs):
    """What C's parameter gets."""
    entry = inputs.get(part["name"])
    if entry is None:
        if part["name"] == "count":
            return "static_cast<int32_t>(%s.size())" % idiom.counted(call)["name"]
        of = idiom.bytes_of(call, part)
        return "%s.size()" % of["name"] if of else None
    if entry["kind"] in ("array", "fill", "changes", "bytes"):
        return "%s.data()" % entry["name"]
    if entry["kind"] == "change" or entry["kind"] == "struct" and not entry["nullable"]:
        return "&" + entry["name"]
    return entry["name"]


def output_type(entry, handles):
    base = entry["base"]
    return {"bytes": "std::vector<unsigned char>", "value": typed(base, handles), "list": "std::vector<%s>" % base, "view": "Slice<const %s>" % base, "string": "const char *"}[entry["kind"]]


def write_call(call, handles, indent):
    inputs = {entry["name"]: entry for entry in call["inputs"]}
    parameters = ", ".join(parameter(entry, handles) for entry in call["inputs"])
    owner = [call["owner"] + "_"] if call["owner"] else []
    const = " const" if call["owner"] and not call["changes"] else ""
    plain = call["result"] != "error"
    outputs = call["outputs"]
    world = "world_" if call["owner"] == "world" and call["changes"] else "nullptr"
    returned = call["result"] if plain else "Status"
    if outputs:
        types = [output_type(entry, handles) for entry in outputs]
        returned = "Result<%s>" % (types[0] if len(types) == 1 else "std::tuple<%s>" % ", ".join(types))
    if call["name"].endswith("is_valid"):
        returned = "bool"
    head = names.comment(call["doc"], "/// ", indent) + "%s%s%s%s(%s)%s\n%s{\n" % (
        indent, "" if owner else "inline ", returned + ("" if returned.endswith("*") else " "), call["name"], parameters, const + (" noexcept" if plain else ""), indent)  # fmt: skip
    body = []
    uneven = [entry["name"] for entry in call["inputs"] if entry["length"] == "count" and entry is not idiom.counted(call)]
    for name in uneven:
        base, nullable = idiom.counted(call)["name"], inputs[name]["nullable"]
        condition = "%s%s.size() != %s.size()" % ("%s.data() != nullptr && " % name if nullable else "", name, base)
        body.append("if (%s)\n%s\t\treturn { CN_ERROR_ARGUMENT, nullptr };" % (condition, indent))
    body += declarations(outputs, handles)
    arguments = owner + [value for value in (argument(part, call, inputs) for part in call["parameters"][len(owner) :]) if value is not None]
    c_call = lambda extra: "%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    if plain:
        body.append("return %s%s;" % (c_call([]), " != 0" if returned == "bool" else ""))
    elif not outputs:
        body.append("return Status(%s, %s);" % (c_call([]), world))
    else:
        body += room(call, arguments, c_call, indent) if outputs[0]["kind"] == "bytes" else fetch(outputs, c_call, indent)
        values = [value(entry, handles) for entry in outputs]
        body.append("return { Status(code, %s), %s };" % (world, values[0] if len(values) == 1 else "{ %s }" % ", ".join(values)))
    return "\n" + head + "".join("%s\t%s\n" % (indent, line) for line in body) + indent + "}\n"


def declarations(outputs, handles):
    out = []
    for entry in outputs:
        if entry["kind"] == "bytes":
            out += ["uint64_t bytes = 0;", "std::vector<unsigned char> out;"]
        elif entry["kind"] == "view":
            out += ["const %s *data = nullptr;" % entry["base"], "int32_t count = 0;"]
        elif entry["kind"] == "list":
            out += ["std::vector<%s> list;" % entry["base"], "int32_t count = 0;"]
        elif entry["kind"] == "string":
            out.append('const char *%s = "";' % entry["name"])
        else:
            out.append("%s out_%s{};" % (entry["base"], entry["name"]))
    return out


def room(call, arguments, c_call, indent):
    """Bytes that are written into a vector of the right size."""
    lines = ["cn_result code = %s(%s);" % (call["room"], ", ".join([*arguments, "&bytes"]))]
    if not call["room"]:
        lines = ["cn_result code = CN_OK;", "bytes = %s;" % " + ".join(name + ".size()" for name in idiom.bytes_in(call))]
    lines += ["out.resize(static_cast<std::size_t>(bytes));", "if (code == CN_OK)\n%s\t\tcode = %s;" % (indent, c_call(["out.data()", "bytes", "&bytes"]))]
    return lines + ["out.resize(static_cast<std::size_t>(bytes));"]


def fetch(outputs, c_call, indent):
    kind = outputs[0]["kind"]
    if kind == "list":
        return ["cn_result code = %s;" % c_call(["nullptr", "0", "&count"]), "list.resize(static_cast<std::size_t>(count));",
            "if (code == CN_OK && count > 0)\n%s\t\tcode = %s;" % (indent, c_call(["list.data()", "count", "&count"]))]  # fmt: skip
    if kind == "view":
        return ["cn_result code = %s;" % c_call(["&data", "&count"])]
    return ["cn_result code = %s;" % c_call(["&" + ("out_" if entry["kind"] == "value" else "") + entry["name"] for entry in outputs])]


def value(entry, handles):
    if entry["kind"] in ("list", "bytes"):
        return "std::move(list)" if entry["kind"] == "list" else "std::move(out)"
    if entry["kind"] == "view":
        return "Slice<const %s>(data, static_cast<std::size_t>(count))" % entry["base"]
    if entry["kind"] == "string":
        return "std::move(%s)" % entry["name"]
    return "%s(out_%s)" % (typed(entry["base"], handles), entry["name"]) if entry["base"] in handles else "std::move(out_%s)" % entry["name"]
