"""Writes the low-level bindings from the public header.

    python3 bindings/generate.py            api.json, then every binding from it
    python3 bindings/generate.py --check    fails if a committed file is not what would be written
    python3 bindings/generate.py --probe    compiles C against the header ($CC, default cc) that
                                            compares every layout, constant and signature

    header.py  text of include/cairn.h -> api (the dictionary in api.json)
    layout.py  sizes and offsets, and the rules that keep structs equal in every language
    pointers.py  which pointers are arrays, outputs, strings, may be NULL
    probe.py   api -> C program that asks the compiler
    record.py  api -> tables of calls, for recording, replay and fuzzing
    idiom.py     what a layer above C makes of the functions
    luajit.py, lua.py, csharp.py, csharp_layer.py, zig.py, zig_layer.py, python.py, cpp.py, rust.py, javascript.py, go.py    api -> one file each

Whatever header.py does not understand is an error with a line number: nothing is guessed. The
writers see only the api, so that another language needs one more file here and nothing else.
"""
import argparse
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True

from generator import cpp, csharp, csharp_layer, go, header, javascript, layout, lua, luajit, names, pointers, probe, python, record, rust, zig, zig_layer  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(HERE)
WRITERS = [
    ("api.json", names.api_text),
    ("luajit/cairn.lua", luajit.write),
    ("lua/calls.h", lua.write),
    ("csharp/Cairn.cs", csharp.write),
    ("csharp/World.cs", csharp_layer.write),
    ("zig/cairn.zig", zig.write),
    ("zig/layer.zig", zig_layer.write),
    ("python/cairn.py", python.write),
    ("record/calls.h", record.write_calls),
    ("record/wrappers.h", record.write_wrappers),
    ("record/cairn_record.h", record.write_header),
    ("cpp/cairn.hpp", cpp.write),
    ("go/cairn.go", go.write),
    ("javascript/cairn.js", javascript.write),
    ("javascript/cairn.d.ts", javascript.write_types),
    ("rust/cairn-sys/src/lib.rs", rust.write_sys),
    ("rust/cairn/src/calls.rs", rust.write_layer),
]


def read_api(path):
    with open(path, encoding="utf-8") as file:
        api = header.parse(file.read(), os.path.basename(path))
    layout.add(api)
    pointers.add(api)
    return api


def undocumented(api):
    """Names of functions, structs, callbacks and fields without a comment of their own."""
    names = [entry["name"] for kind in ("functions", "structs", "callbacks") for entry in api[kind] if not entry["doc"]]
    return names + ["%s.%s" % (entry["name"], field["name"]) for entry in api["structs"] for field in entry["fields"] if not field["doc"]]


def write_all(api, folder):
    for name, writer in WRITERS:
        with open(os.path.join(folder, name), "w", encoding="utf-8", newline="\n") as file:
            file.write(writer(api))


def check_all(api, folder):
    """Names of the files that differ from what would be written."""
    stale = []
    for name, writer in WRITERS:
        try:
            with open(os.path.join(folder, name), encoding="utf-8", newline="") as file:
                old = file.read()
        except FileNotFoundError:
            old = None
        if old != writer(api):
            stale.append(name)
    return stale


def run_probe(api, include):
    with tempfile.TemporaryDirectory() as folder:
        source, program = os.path.join(folder, "probe.c"), os.path.join(folder, "probe")
        with open(source, "w", encoding="utf-8") as file:
            file.write(probe.write(api))
        compiler = os.environ.get("CC") or "cc"
        subprocess.run([*compiler.split(), "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I" + include, source, "-o", program], check=True)
        subprocess.run([program], check=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--probe", action="store_true")
    arguments.add_argument("--header", default=os.path.join(TOP, "include", "cairn.h"))
    arguments.add_argument("--output", default=HERE, help="folder with luajit/, csharp/, zig/, python/, record/")
    options = arguments.parse_args()
    try:
        api = read_api(options.header)
        if options.probe:
            run_probe(api, os.path.dirname(options.header))
        elif undocumented(api):
            sys.exit("no comment right above or behind: " + ", ".join(undocumented(api)))
        elif options.check:
            stale = check_all(api, options.output)
            if stale:
                sys.exit("not what the header says (run make bindings): " + ", ".join(stale))
        else:
            write_all(api, options.output)
    except header.HeaderError as error:
        sys.exit(str(error))
    except subprocess.CalledProcessError as error:
        sys.exit("probe: the compiler disagrees with api.json: %s gave code %d" % (os.path.basename(error.cmd[0]), error.returncode))
    count = {kind: len(api[kind]) for kind in ("functions", "structs", "callbacks")}
    print("%(functions)d functions, %(structs)d structs, %(callbacks)d callback types" % count)


if __name__ == "__main__":
    main()
