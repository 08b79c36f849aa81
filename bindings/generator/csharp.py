"""Writes csharp/Cairn.cs: P/Invoke in C# 7 (Mono, .NET Framework, Unity) that .NET 8 takes as well.

Every struct is blittable. Handles are enums of uint, so that a shape is never taken for a body.
Arrays inside of structs are structs with an indexer: C# has fixed arrays of plain numbers only.
Function pointers are IntPtr: from a delegate by Marshal.GetFunctionPointerForDelegate, or from a
C# 9 function pointer by a cast.
"""
from xml.sax.saxutils import escape

from . import names

START = """// Cairn for C#, one to one with cairn.h.
// %s
//
//     using Cairn;
//     using static Cairn.Native;
//     cn_world_def def;
//     cn_world_def_init(&def);
//     cn_world* world;
//     if (cn_world_create(&def, &world) != CN_OK) ...
//
// Compile with -unsafe. The library is found as "cairn" (libcairn.so, cairn.dll).
using System;
using System.Runtime.InteropServices;

namespace Cairn
{
"""
NATIVE = """
	public static unsafe class Native
	{
		private const string Library = "cairn";

		/// <summary>A library of another version would read other structs: call this once before anything else.</summary>
		public static void Check()
		{
			if (cn_abi_version() != CN_ABI_VERSION)
				throw new DllNotFoundException("Cairn.cs is for ABI " + CN_ABI_VERSION + ", the library has " + cn_abi_version());
%s		}

		private static void CheckSize(string name, int bytes, int type)
		{
			if (bytes != cn_sizeof(type))
				throw new DllNotFoundException(name + " has " + bytes + " bytes here, " + cn_sizeof(type) + " in the library");
		}

		/// <summary>The string at a const char* of the library.</summary>
		public static string Text(byte* text)
		{
			int length = 0;
			while (text != null && text[length] != 0)
				++length;
			return length == 0 ? "" : System.Text.Encoding.UTF8.GetString(text, length);
		}

"""
ARRAY = """
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct %(array)s
	{
		public %(element)s %(fields)s;

		public %(element)s this[int index]
		{
			get
			{
				if ((uint)index >= %(count)d)
					throw new IndexOutOfRangeException();
				fixed (%(element)s* first = &e0)
					return first[index];
			}
			set
			{
				if ((uint)index >= %(count)d)
					throw new IndexOutOfRangeException();
				fixed (%(element)s* first = &e0)
					first[index] = value;
			}
		}
	}
"""
SCALARS = {
    "float": "float", "double": "double", "char": "byte", "void": "void", "int8_t": "sbyte", "uint8_t": "byte", "int16_t": "short",
    "uint16_t": "ushort", "int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong",
}  # fmt: skip
WORDS = set(
    "abstract as base bool break byte case catch char checked class const continue decimal default delegate do double else enum event explicit extern false finally"
    " fixed float for foreach goto if implicit in int interface internal is lock long namespace new null object operator out override params private protected public"
    " readonly ref return sbyte sealed short sizeof stackalloc static string struct switch this throw true try typeof uint ulong unchecked unsafe ushort using virtual"
    " void volatile while".split()
)


def safe(name):
    return "@" + name if name in WORDS else name


def spell(part, api):
    base, pointers = part["base"], part["pointers"]
    if base in names.callbacks(api):
        return "IntPtr" + "*" * (pointers - 1)
    scalars = {entry["name"]: SCALARS[entry["type"]] for entry in api["scalars"]}
    return SCALARS.get(base, scalars.get(base, base)) + "*" * pointers


def array_name(field, api):
    return "%s_array%d" % (spell(field, api), field["array"])


def write(api):
    out = [START % names.NOTICE]
    out += ["\tpublic enum %s : uint { none = 0 }\n" % entry["name"] for entry in api["handles"]]
    out += ["\tpublic struct %s { }\n" % entry["name"] for entry in api["opaque"]]
    for callback in api["callbacks"]:
        out.append("\n%s\t[UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n" % summary(callback, "\t"))
        out.append("\tpublic unsafe delegate %s %s(%s);\n" % (spell(callback["returns"], api), callback["name"], parameters(callback, api)))
    out += write_arrays(api)
    out += [write_struct(struct, api) for struct in api["structs"]]
    checks = ['\t\t\tCheckSize("%s", sizeof(%s), %s);\n' % (entry["name"], entry["name"], entry["sizeof_type"]) for entry in names.checked_structs(api)]
    out.append(NATIVE % "".join(checks))
    out += write_constants(api)
    for function in api["functions"]:
        out.append("\n%s\t\t[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n" % summary(function, "\t\t"))
        out.append("\t\tpublic static extern %s %s(%s);\n" % (spell(function["returns"], api), function["name"], parameters(function, api)))
    return "".join(out) + "\t}\n}\n"


def write_arrays(api):
    found = {}
    for field in (field for struct in api["structs"] for field in struct["fields"] if field["array"]):
        fields = ", ".join("e%d" % i for i in range(field["array"]))
        name = array_name(field, api)
        found[name] = ARRAY % {"array": name, "element": spell(field, api), "count": field["array"], "fields": fields}
    return list(found.values())


def write_struct(struct, api):
    out = ["\n", summary(struct, "\t"), "\t[StructLayout(LayoutKind.Sequential)]\n\tpublic unsafe struct %s\n\t{\n" % struct["name"]]
    for field in struct["fields"]:
        kind = array_name(field, api) if field["array"] else spell(field, api)
        out.append(summary(field, "\t\t") + "\t\tpublic %s %s;\n" % (kind, safe(field["name"])))
    return "".join(out) + "\t}\n"


def write_constants(api):
    out = ["\t\tpublic const int %s = %d;\n" % (constant["name"], constant["value"]) for constant in api["constants"]]
    for enum in api["enums"]:
        out.append("\n" + names.comment(enum["doc"], "// ", "\t\t"))
        for value in enum["values"]:
            out.append(summary(value, "\t\t") + "\t\tpublic const %s %s = %d;\n" % (SCALARS[enum["type"]], value["name"], value["value"]))
    return out


def parameters(entry, api):
    return ", ".join("%s %s" % (spell(part, api), safe(part["name"])) for part in entry["parameters"])


def summary(entry, indent):
    if not entry["doc"]:
        return ""
    lines = names.comment(escape(entry["doc"]), "/// ", indent).rstrip("\n")
    first = indent + "/// "
    return first + "<summary>" + lines[len(first) :] + "</summary>\n"
