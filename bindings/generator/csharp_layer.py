"""Writes csharp/World.cs: safe C# 7.3 above Cairn.cs, in PascalCase: worlds to dispose of, exceptions, spans; from idiom.py."""
from . import csharp, idiom, names

START = """// Cairn for C#: the safe layer. %s
//
//     using (var world = new World())
//     {
//         var def = BodyDef.Default;
//         def.PositionM = new Vec2 { X = 0, Y = 4 };
//         Body body = world.BodyCreate(def);
//         world.Step(1f / 60);
//         Pose pose = world.BodyGetPose(body);
//     }
//
// A method is C's function without cn_ and without the world: cn_body_get_pose(world, body, &out) is world.BodyGetPose(body).
// A failed call throws CairnException. An empty span of bodies stands for all bodies. Structs have C's layout; pointers in them are
// private and stay null. Calls need no unsafe; this file and Cairn.cs are compiled with it.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Cairn
{
	/// <summary>A call that failed; then nothing has changed. The message is the library's sentence.</summary>
	public sealed class CairnException : Exception
	{
		public readonly int Code;

		public CairnException(int code, string message) : base(message)
		{
			Code = code;
		}
	}

	internal static unsafe class Call
	{
		public static void Check(int code, cn_world* world)
		{
			if (code == Native.CN_OK)
				return;
			string text = world != null ? Native.Text(Native.cn_world_error_text(world)) : "";
			throw new CairnException(code, text != "" ? text : Native.Text(Native.cn_result_text(code)));
		}

		public static void Even(int a, int b)
		{
			if (a != b)
				throw new ArgumentException("spans of " + a + " and " + b + " elements");
		}

		public static byte[] Utf8(string text)
		{
			return text == null ? null : System.Text.Encoding.UTF8.GetBytes(text + "\\0");
		}

		public static T[] Copy<T>(void* data, int count)
		{
			return new ReadOnlySpan<T>(data, count).ToArray();
		}
	}
"""
WORLD = """
	/// <summary>A world with everything in it. Dispose of it, or the finalizer does.</summary>
	public sealed unsafe partial class World : IDisposable
	{
		private cn_world* pointer;
		private readonly Dictionary<int, cn_contact_event_fn> callbacks = new Dictionary<int, cn_contact_event_fn>();

		public World() : this(WorldDef.Default) { }

		public World(WorldDef def)
		{
			Native.Check();
			cn_world* made;
			Call.Check(Native.cn_world_create((cn_world_def*)&def, &made), null);
			pointer = made;
		}

		private World(cn_world* made)
		{
			pointer = made;
		}

		/// <summary>A world from the bytes of Write. Of the definition only workers and capacities are used.</summary>
		public static World Read(ReadOnlySpan<byte> file, WorldDef? def = null)
		{
			WorldDef given = def ?? WorldDef.Default;
			cn_world* made;
			fixed (byte* from = file)
				Call.Check(Native.cn_world_read((cn_world_def*)&given, from, (ulong)file.Length, &made), null);
			return new World(made);
		}

		~World()
		{
			Native.cn_world_destroy(pointer);
		}

		/// <summary>For functions of Native.</summary>
		public cn_world* Pointer
		{
			get
			{
				if (pointer == null)
					throw new ObjectDisposedException("World");
				return pointer;
			}
		}

		public void Dispose()
		{
			Native.cn_world_destroy(pointer);
			pointer = null;
			GC.SuppressFinalize(this);
		}

		/// <summary>Calls the function for contact events of one kind, while the world is locked; null ends that. It must not throw.</summary>
		public void OnContact(int kind, Action<ContactEvent> function)
		{
			cn_contact_event_fn callback = function == null ? (cn_contact_event_fn)null : (world, contact, user) => function(*(ContactEvent*)contact);
			IntPtr address = callback == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(callback);
			Call.Check(Native.cn_world_set_contact_callback(Pointer, kind, address, null), Pointer);
			callbacks[kind] = callback; // the library keeps a pointer that C# does not see
		}

		/// <summary>Creates a chain through points in the body's frame; closed: the last joins the first.</summary>
		public Shape ShapeCreateChain(ShapeDef def, ReadOnlySpan<Vec2> pointsM, bool closed)
		{
			cn_shape shape;
			fixed (Vec2* points = pointsM)
			{
				var chain = new cn_chain { points_m = (cn_vec2*)points, count = pointsM.Length, loop = closed ? 1u : 0 };
				Call.Check(Native.cn_shape_create_chain(Pointer, (cn_shape_def*)&def, &chain, &shape), Pointer);
			}
			return (Shape)shape;
		}
"""
TREE = """
	/// <summary>A dynamic AABB tree apart from any world.</summary>
	public sealed unsafe partial class Tree : IDisposable
	{
		private cn_tree* pointer;

		public Tree(float marginM)
		{
			cn_tree* made;
			Call.Check(Native.cn_tree_create(marginM, IntPtr.Zero, IntPtr.Zero, null, &made), null);
			pointer = made;
		}

		~Tree()
		{
			Native.cn_tree_destroy(pointer);
		}

		/// <summary>For functions of Native.</summary>
		public cn_tree* Pointer
		{
			get
			{
				if (pointer == null)
					throw new ObjectDisposedException("Tree");
				return pointer;
			}
		}

		public void Dispose()
		{
			Native.cn_tree_destroy(pointer);
			pointer = null;
			GC.SuppressFinalize(this);
		}
"""


def typed(base, api):
    """The public type of a value."""
    if base in {entry["name"] for entry in api["scalars"]}:
        return "int"
    return idiom.type_name(base) if base.startswith("cn_") else csharp.SCALARS[base]


def write(api):
    out = [START % names.NOTICE]
    out += ["\n%s\tpublic enum %s : uint { None = 0 }\n" % (csharp.summary(entry, "\t"), idiom.type_name(entry["name"])) for entry in api["handles"]]
    arrays, inits = {}, idiom.inits(api)
    for struct in api["structs"]:
        out.append("\n%s\t[StructLayout(LayoutKind.Sequential)]\n\tpublic unsafe struct %s\n\t{\n" % (csharp.summary(struct, "\t"), idiom.type_name(struct["name"])))
        for field in struct["fields"]:
            kind = "IntPtr" if field["pointers"] else typed(field["base"], api)
            if field["array"]:
                kind, element = "%sArray%d" % (idiom.pascal(kind), field["array"]), kind
                arrays[kind] = csharp.ARRAY % {"array": kind, "element": element, "count": field["array"], "fields": ", ".join("e%d" % i for i in range(field["array"]))}
            out.append("%s\t\t%s %s %s;\n" % (csharp.summary(field, "\t\t"), "internal" if field["pointers"] else "public", kind, idiom.pascal(field["name"])))
        if struct["name"] in inits:
            out.append("\n\t\t/// <summary>The defaults of the fields.</summary>\n\t\tpublic static %s Default\n\t\t{\n\t\t\tget\n\t\t\t{\n" % idiom.type_name(struct["name"]))
            out.append("\t\t\t\t%s value;\n\t\t\t\tNative.%s((%s*)&value);\n\t\t\t\treturn value;\n\t\t\t}\n\t\t}\n" % (idiom.type_name(struct["name"]), inits[struct["name"]], struct["name"]))
        out.append("\t}\n")
    out += arrays.values()
    for text, owner in ((WORLD, "world"), (TREE, "tree"), ("\n\tpublic static unsafe class Functions\n\t{\n", "")):
        out += [text] + [write_call(call, api) for call in idiom.methods(api, owner) if not any(entry["base"] == "cn_chain" for entry in call["inputs"])] + ["\t}\n"]
    return "".join(out) + "}\n"


def local(name):
    return csharp.safe(idiom.camel(name))


def parameter(entry, api, last):
    base, name = typed(entry["base"], api), local(entry["name"])
    text = {"value": base, "struct": base, "change": "ref " + base, "array": "ReadOnlySpan<%s>" % base, "fill": "Span<%s>" % base, "changes": "Span<%s>" % base, "string": "string", "bytes": "ReadOnlySpan<byte>"}[entry["kind"]]
    if entry["kind"] == "struct" and entry["nullable"]:
        return "%s? %s%s" % (base, name, " = null" if last else "")
    return "%s %s" % (text, name)


def write_call(call, api):
    inputs, owner, body, fixed = {entry["name"]: entry for entry in call["inputs"]}, call["owner"], [], []
    result = result_type(call, api)
    for entry in call["inputs"]:
        name, raw = local(entry["name"]), entry["base"]
        pointer = "p_" + entry["name"]
        if entry["length"] == "count" and entry is not idiom.counted(call):
            body.append("%sCall.Even(%s.Length, %s.Length);" % ("if (!%s.IsEmpty)\n\t\t\t\t" % name if entry["nullable"] else "", name, local(idiom.counted(call)["name"])))
        if entry["kind"] in ("array", "fill", "changes"):
            fixed.append("fixed (%s* %s = %s)" % (typed(raw, api), pointer, name))
        elif entry["kind"] == "change":
            fixed.append("fixed (%s* %s = &%s)" % (typed(raw, api), pointer, name))
        elif entry["kind"] == "bytes":
            fixed.append("fixed (byte* %s = %s)" % (pointer, name))
        elif entry["kind"] == "string":
            fixed.append("fixed (byte* %s = Call.Utf8(%s))" % (pointer, name))
        elif entry["kind"] == "struct" and entry["nullable"]:
            body.append("%s v_%s = %s.GetValueOrDefault();" % (typed(raw, api), entry["name"], name))
    arguments = ["Pointer"] if owner else []
    for part in call["parameters"][len(arguments) :]:
        entry = inputs.get(part["name"])
        if entry is None:
            arguments += ["%s.Length" % local(idiom.counted(call)["name"])] if part["name"] == "count" else ["(ulong)%s.Length" % local(idiom.bytes_of(call, part)["name"])] if idiom.bytes_of(call, part) else []
        elif entry["kind"] == "value":
            handle = entry["base"] in {h["name"] for h in api["handles"]}
            arguments.append(("(%s)" % entry["base"] if handle else "") + local(entry["name"]))
        elif entry["kind"] == "struct":
            v = "&v_" + entry["name"] if entry["nullable"] else "&" + local(entry["name"])
            cast = "(%s*)%s" % (entry["base"], v)
            arguments.append("%s.HasValue ? %s : null" % (local(entry["name"]), cast) if entry["nullable"] else cast)
        else:
            arguments.append(("" if entry["kind"] in ("bytes", "string") else "(%s*)" % csharp.SCALARS.get(entry["base"], entry["base"])) + "p_" + entry["name"])
    lines = body + ["%s%s" % ("\t" * i, line) for i, line in enumerate(fixed)]
    inner = results(call, arguments, api)
    if fixed:
        lines += ["{"] + ["\t" + line for line in inner] + ["}"]
        lines = body + fixed + ["{"] + ["\t" + line for line in inner] + ["}"]
    else:
        lines += inner
    head = "\n%s\t\tpublic %s%s %s(%s)\n\t\t{\n" % (csharp.summary(call, "\t\t"), "" if owner else "static ", result, idiom.pascal(call["name"]), ", ".join(parameter(entry, api, entry is call["inputs"][-1]) for entry in call["inputs"]))
    return head + "".join("\t\t\t%s\n" % line for line in lines) + "\t\t}\n"


def result_type(call, api):
    if call["result"] != "error":
        return "string" if "char" in call["result"] else "bool" if call["name"].endswith("is_valid") else typed(call["result"], api)
    kinds = [{"value": "%s", "list": "%s[]", "view": "%s[]", "string": "string", "bytes": "byte[]"}[entry["kind"]].replace("%s", "byte" if entry["kind"] == "bytes" else typed(entry["base"], api)) for entry in call["outputs"]]
    if len(kinds) > 1:
        return "(%s)" % ", ".join("%s %s" % (kind, idiom.pascal(entry["name"])) for kind, entry in zip(kinds, call["outputs"]))
    return kinds[0] if kinds else "void"


def results(call, arguments, api):
    outputs = call["outputs"]
    invoke = lambda extra: "Native.%s(%s)" % (call["c"], ", ".join(arguments + extra))  # noqa: E731
    world = "Pointer" if call["owner"] == "world" and call["changes"] else "null"
    check = lambda extra: "Call.Check(%s, %s);" % (invoke(extra), world)  # noqa: E731
    keep = ["GC.KeepAlive(this);"] if call["owner"] else []
    if call["result"] != "error":
        text = invoke([])
        text = "Native.Text(%s)" % text if "char" in call["result"] else text + " != 0" if call["name"].endswith("is_valid") else text
        return ["var result_ = %s;" % text, *keep, "return result_;"]
    if not outputs:
        return [check([]), *keep]
    kind, base = outputs[0]["kind"], outputs[0]["base"]
    if kind == "list":
        return ["int count_;", check(["null", "0", "&count_"]), "var result_ = new %s[count_];" % typed(base, api), "if (count_ > 0)",
            "\tfixed (%s* to = result_)" % typed(base, api), "\t\t" + check(["(%s*)to" % base, "count_", "&count_"]), *keep, "return result_;"]  # fmt: skip
    if kind == "bytes":
        size = "Call.Check(Native.%s(%s), null);" % (call["room"], ", ".join([*arguments, "&bytes_"])) if call["room"] else "bytes_ = (ulong)(%s);" % " + ".join(local(name) + ".Length" for name in idiom.bytes_in(call))
        return ["ulong bytes_;", size, "var result_ = new byte[bytes_];", "fixed (byte* to = result_)", "\t" + check(["to", "bytes_", "&bytes_"]), *keep,
            "Array.Resize(ref result_, (int)bytes_);", "return result_;"]  # fmt: skip
    if kind == "view":
        return ["%s* data;" % base, "int count_;", check(["&data", "&count_"]), "var result_ = Call.Copy<%s>(data, count_);" % typed(base, api), *keep, "return result_;"]
    if kind == "string":
        return ["byte* text;", check(["&text"]), "var result_ = Native.Text(text);", *keep, "return result_;"]
    raw = [entry["base"] if entry["base"].startswith("cn_") else csharp.SCALARS[entry["base"]] for entry in outputs]
    variables = ["out%d" % i for i in range(len(outputs))]
    values = ["*(%s*)&%s" % (typed(entry["base"], api), name) if entry["base"].startswith("cn_") else name for entry, name in zip(outputs, variables)]
    return ["%s %s;" % pair for pair in zip(raw, variables)] + [check(["&" + name for name in variables]), *keep, "return %s;" % (values[0] if len(values) == 1 else "(%s)" % ", ".join(values))]
