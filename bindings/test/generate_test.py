"""Tests of bindings/generate.py: what it reads, what it refuses and in which words, and that the
probe and the check for stale files can fail. Ends with "N passed, N failed, N skipped".
"""
import contextlib
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

import generate  # noqa: E402
from generator import header, layout, pointers  # noqa: E402

START = "#ifndef T_H\n#define T_H\n#include <stdint.h>\n"
END = "\n#endif\n"
TYPES = "typedef int32_t cn_result;\ntypedef uint32_t cn_body;\ntypedef struct cn_world cn_world;\ntypedef struct cn_vec2 {\n\tfloat x;\n\tfloat y;\n} cn_vec2;\n"

# Each line of C, and words of the message that it must give.
REFUSED = [
    ("CN_API void cn_a(cn_vec2 p);", "cn_a: struct cn_vec2 by value"),
    ("CN_API cn_vec2 cn_a(void);", "struct cn_vec2 by value"),
    ("typedef void cn_a_fn(cn_vec2 p, void *user);", "struct cn_vec2 by value"),
    ("typedef void cn_a_fn(int32_t n);", "last parameter of a callback is void *user"),
    ("typedef void (*cn_a_fn)(void *user);", "a function pointer; declare the function type"),
    ("CN_API void cn_a(int n);", "unknown type int"),
    ("CN_API void cn_a(size_t n);", "unknown type size_t"),
    ("CN_API void cn_a(const int32_t n);", "const without *"),
    ("CN_API void cn_a(cn_world world);", "cn_world without *"),
    ("CN_API void cn_a(void *a, ...);", "cannot read '..."),
    ("CN_API void cn_a(float p[2]);", "expected ',', found '['"),
    ("CN_API void cn_a(cn_body ***p);", "more than two *"),
    ("CN_API void cn_a(cn_body *const *p);", "const behind *"),
    ("CN_API void cn_a();", "expected a name, found ')'"),
    ("CN_API void cn_a(void);\nCN_API void cn_a(void);", "cn_a is declared twice"),
    ("void cn_a(void);", "starts with 'void'"),
    ("static inline void cn_a(void) {}", "starts with 'static'"),
    ("typedef struct cn_a { bool b; } cn_a;", "unknown type bool"),
    ("typedef struct cn_a { int32_t b : 3; } cn_a;", "expected ';', found ':'"),
    ("typedef struct cn_a { union { float f; } u; } cn_a;", "union inside of a struct"),
    ("typedef struct cn_a { float x, y; } cn_a;", "expected ';', found ','"),
    ("typedef struct cn_a { float x; float x; } cn_a;", "field x twice"),
    ("typedef struct cn_a { float end; } cn_a;", "cn_a.end is a keyword"),
    ("typedef struct cn_a { float x; } cn_b;", "different names"),
    ("typedef struct cn_a { cn_world world; } cn_a;", "cn_world without *"),
    ("typedef struct cn_a { uint32_t n; uint64_t m; } cn_a;", "cn_a.m: 4 bytes of padding before it"),
    ("typedef struct cn_a { void *p; uint32_t n; } cn_a;", "cn_a: 4 bytes of padding at its end"),
    ("typedef struct cn_a { float f[CN_N]; } cn_a;", "CN_N is not a known constant"),
    ("typedef uint64_t cn_a;", "typedef of uint64_t"),
    ("typedef enum cn_a { CN_A } cn_a;", "typedef enum"),
    ("typedef union cn_a { float f; } cn_a;", "typedef union"),
    ("enum cn_a { CN_A };", "an enum with a name"),
    ("enum { CN_A = 1 << 40 };", "does not fit 32 bits"),
    ("enum { CN_A = sizeof(float) };", "sizeof is not a known constant"),
    ("enum { CN_TYPE_NOTHING = 0 };", "CN_TYPE_NOTHING names no struct"),
    ("#define CN_A 1.5f", "cannot read '1.5f'"),
    ("#define CN_A(x) (x)", "only #define NAME integer"),
    ("#ifdef CN_B\n#define CN_A 1\n#endif", "bindings cannot see conditions"),
    ("#ifdef CN_B\nCN_API void cn_a(void);\n#endif", "bindings cannot see conditions"),
    ("#pragma pack(1)", "only #define NAME integer"),
    ("CN_API void cn_a(", "ends in the middle"),
    ("CN_API cn_result cn_a(cn_world *world, cn_vec2 *p);", "cn_a: the pointer p follows no convention"),
    ("CN_API cn_result cn_a(cn_world *world, char *name);", "cn_a: the pointer name follows no convention"),
    ("CN_API cn_result cn_a(const cn_world *world, const cn_vec2 **out);", "cn_a: the pointer out follows no convention"),
    ("typedef struct cn_a { const cn_vec2 *points; } cn_a;", "cn_a: the pointer points follows no convention"),
]

READ = """
/* --------- things */
#define CN_N 3
enum {
	CN_TYPE_VEC2 = 0,
	CN_BIT = 1u << 4, /* a bit */
	CN_BOTH = CN_BIT | 1u /* both */
};
/* A thing
   of two lines. */
typedef struct cn_thing {
	uint64_t id;
	cn_vec2 points_m[CN_N]; /* metres */
	void (*draw)(const cn_vec2 *at, void *user); /* draws it */
} cn_thing;
/* Does it. */
CN_API cn_result cn_thing_do(cn_world *world, const cn_thing *thing, const char **out_text);
"""

passed = failed = 0


def report(name, problem):
    global passed, failed
    passed, failed = passed + (problem is None), failed + (problem is not None)
    print("PASS " + name if problem is None else "FAIL %s: %s" % (name, problem))


def parse(text):
    api = header.parse(START + TYPES + text + END, "t.h")
    layout.add(api)
    pointers.add(api)
    return api


def refusal(text, words):
    """None if it is refused with these words and the right line, else what happened."""
    try:
        parse(text)
    except header.HeaderError as error:
        return None if words in str(error) else "the message was %r" % str(error)
    return "it was accepted"


def reading():
    api = parse(READ)
    thing, function = api["structs"][1], api["functions"][0]
    expected = [
        ("offsets", [(0, 8), (8, 24), (32, 8)], [(field["offset"], field["size"]) for field in thing["fields"]]),
        ("size", 40, thing["size"]),
        ("array", 3, thing["fields"][1]["array"]),
        ("documentation", ["A thing of two lines.", "metres", "Does it."], [thing["doc"], thing["fields"][1]["doc"], function["doc"]]),
        ("documentation of values", ["", "a bit", "both"], [value["doc"] for value in api["enums"][0]["values"]]),
        ("documentation of callbacks", "draws it", api["callbacks"][0]["doc"]),
        ("undocumented", ["cn_vec2", "cn_vec2.x", "cn_vec2.y", "cn_thing.id"], generate.undocumented(api)),
        ("section", "things", function["section"]),
        ("values", [("CN_TYPE_VEC2", 0), ("CN_BIT", 16), ("CN_BOTH", 17)], [(value["name"], value["value"]) for value in api["enums"][0]["values"]]),
        ("flags are unsigned", "uint32_t", api["enums"][0]["type"]),
        ("callback of a field", ["const cn_vec2 *", "void *"], [part["type"] for part in api["callbacks"][0]["parameters"]]),
        ("parameters", ["cn_world *", "const cn_thing *", "const char **"], [part["type"] for part in function["parameters"]]),
        ("struct numbers", ["CN_TYPE_VEC2", None], [struct["sizeof_type"] for struct in api["structs"]]),
    ]
    for name, want, have in expected:
        report("reads " + name, None if want == have else "expected %r, found %r" % (want, have))


def probe_notices(api, name, change):
    """A changed api must not pass; change undoes itself when called again."""
    change()
    problem = "the probe passed"
    try:
        with tempfile.TemporaryFile("w+") as log, redirected(log):
            generate.run_probe(api, os.path.join(generate.TOP, "include"))
    except subprocess.CalledProcessError:
        problem = None
    change()
    report("probe notices " + name, problem)


@contextlib.contextmanager
def redirected(file):
    """The output of child processes too."""
    sys.stdout.flush()
    saved = [(number, os.dup(number)) for number in (1, 2)]
    for number, _ in saved:
        os.dup2(file.fileno(), number)
    try:
        yield
    finally:
        for number, copy in saved:
            os.dup2(copy, number)
            os.close(copy)


def swap(entry, key, value):
    """A function that exchanges entry[key] with value, and back."""
    held = [value]

    def change():
        entry[key], held[0] = held[0], entry[key]

    return change


def probing(api):
    structs = {struct["name"]: struct for struct in api["structs"]}
    step = next(function for function in api["functions"] if function["name"] == "cn_world_step")
    probe_notices(api, "a wrong offset", swap(structs["cn_pose"]["fields"][1], "offset", 4))
    probe_notices(api, "a wrong size", swap(structs["cn_pose"], "size", 12))
    probe_notices(api, "a wrong constant", swap(api["constants"][0], "value", 77))
    probe_notices(api, "a wrong field type", swap(structs["cn_pose"]["fields"][1], "type", "uint32_t"))
    probe_notices(api, "a wrong parameter", swap(step["parameters"][1], "type", "int32_t"))
    probe_notices(api, "a wrong callback", swap(api["callbacks"][0]["parameters"][0], "type", "float"))


def staleness(api):
    with tempfile.TemporaryDirectory() as folder:
        for name, _ in generate.WRITERS:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
        generate.write_all(api, folder)
        report("check accepts what was just written", None if generate.check_all(api, folder) == [] else "it did not")
        with open(os.path.join(folder, "zig/cairn.zig"), "a") as file:
            file.write("\n")
        os.remove(os.path.join(folder, "api.json"))
        stale = generate.check_all(api, folder)
        report("check names stale and missing files", None if stale == ["api.json", "zig/cairn.zig"] else "it said %r" % stale)


def main():
    for text, words in REFUSED:
        report("refuses " + re.sub(r"\s+", " ", text), refusal(text, words))
    try:
        parse("\n\n\nCN_API void cn_a(int n);")
    except header.HeaderError as error:
        line = (START + TYPES).count("\n") + 4
        report("says where", None if str(error).startswith("t.h:%d: " % line) else str(error))
    reading()
    api = generate.read_api(os.path.join(generate.TOP, "include", "cairn.h"))
    probing(api)
    staleness(api)
    print("%d passed, %d failed, 0 skipped" % (passed, failed))
    sys.exit(failed != 0)


main()
