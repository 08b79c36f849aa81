"""Writes a C program that asks the compiler whether the api says what the header says.

Every prototype is declared again, every callback type and field is pointed at by a pointer of the
type in the api (the compiler refuses these when they differ), and every constant, size and offset
is compared when it runs.
"""
from . import names

START = """#include "cairn.h"
#include <inttypes.h>
#include <stdio.h>

static int failures, checks;

static void compare(const char *what, int64_t measured, int64_t expected)
{
	++checks;
	if (measured != expected) {
		++failures;
		printf("%s: the compiler says %" PRId64 ", api.json %" PRId64 "\\n", what, measured, expected);
	}
}
"""
END = """
	printf("%d sizes, offsets and constants compared, %d differ\\n", checks, failures);
	return failures != 0;
}
"""


def write(api):
    out = [START]
    for function in api["functions"]:
        out.append("%s;" % names.prototype(function))
    for callback in (entry for entry in api["callbacks"] if not entry["in_header"]):
        out.append("typedef %s;" % names.prototype(callback))
    for callback in api["callbacks"]:
        pointer = {**callback, "name": "(*const probe_%s)" % callback["name"]}
        out.append("static %s = (%s *)0;" % (names.prototype(pointer), callback["name"]))
    out.append("\nint main(void)\n{")
    for callback in api["callbacks"]:
        out.append("\t(void)probe_%s;" % callback["name"])
    for name, value, _ in names.all_constants(api):
        out.append('\tcompare("%s", %s, INT64_C(%d));' % (name, name, value))
    for struct in api["structs"]:
        out.append('\tif (sizeof(void *) == 8)\n\t\tcompare("sizeof(%s)", (int64_t)sizeof(%s), %d);' % (struct["name"], struct["name"], struct["size"]))
        for field in struct["fields"]:
            out += probe_field(struct["name"], field)
    return "\n".join(out) + END


def probe_field(struct, field):
    what = "%s.%s" % (struct, field["name"])
    pointer = names.declaration({**field, "name": "(*p)" if field["array"] else "*p"})
    return [
        '\tif (sizeof(void *) == 8)\n\t\tcompare("%s", (int64_t)offsetof(%s, %s), %d);' % (what, struct, field["name"], field["offset"]),
        '\tif (sizeof(void *) == 8)\n\t\tcompare("sizeof %s", (int64_t)sizeof ((%s *)0)->%s, %d);' % (what, struct, field["name"], field["size"]),
        "\t{\n\t\t%s s;\n\t\t%s = &s.%s;\n\t\t(void)p;\n\t}" % (struct, pointer, field["name"]),
    ]
