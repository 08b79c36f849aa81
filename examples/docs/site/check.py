"""Checks what pages say, without the site's generator: every C block compiles and runs, quoted code is in the file that it is quoted
from, every cn_ name exists, the site's menu names pages that exist, and the reference has every function of the header.

    python3 examples/docs/site/check.py build        needs build/libcairn.a; CC names the compiler

A C block is one of these:
  quoted      after "<!-- from file -->": these lines are in that file, which is compiled and run by the tests
  program     has a main: compiled and run as it is
  outline     after "<!-- outline -->": shown only; the program that it is about has tests
  functions   begins with static or typedef: for the fragments after it on the same page
  fragment    statements: run in a world with `ground`, `body` (a box above it), `shape`, `body_def`, `shape_def`. No call may fail,
              unless "<!-- a call fails -->" is before the block: then one must.
"""
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.abspath(os.path.join(HERE, "..", "..", ".."))
sys.path.insert(0, HERE)
import reference  # noqa: E402
import stage  # noqa: E402

FLAGS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-but-set-variable", "-Wno-unused-function",
         "-O1", f"-I{TOP}/include", f"-I{TOP}/examples", f"-I{TOP}"]
PRELUDE = """#include "cairn.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
"""
BEGIN = """static const char *block_%d(void)
{
	cn_world_def world_def;
	cn_world *world = NULL;
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body ground = 0, body = 0;
	cn_shape shape = 0;
	cn_world_def_init(&world_def);
	cn_world_create(&world_def, &world);
	cn_body_def_init(&body_def);
	cn_shape_def_init(&shape_def);
	body_def.type = CN_BODY_STATIC;
	cn_body_create(world, &body_def, &ground);
	shape_def.body = ground;
	cn_shape_create_box(world, &shape_def, 20.0f, 0.5f, 0.0f, NULL);
	body_def.type = CN_BODY_DYNAMIC;
	body_def.position_m.y = 2.0f;
	cn_body_create(world, &body_def, &body);
	shape_def.body = body;
	cn_shape_create_box(world, &shape_def, 0.5f, 0.5f, 0.0f, &shape);
	{
#line %d "%s"
%s
	}
	static char text[256];
	snprintf(text, sizeof text, "%%s", cn_world_error_text(world));
	cn_world_destroy(world);
	return text;
}
"""


def blocks(page):
    """(first line, mark before the block, text) of each C block."""
    found, lines, mark, start = [], page.split("\n"), "", None
    for number, line in enumerate(lines, 1):
        if start is None and line == "```c":
            start = number + 1
        elif start is not None and line == "```":
            found.append((start, mark, "\n".join(lines[start - 1:number - 1])))
            start, mark = None, ""
        elif start is None and line.strip():
            comment = re.match(r"<!-- (.*) -->$", line)
            mark = comment.group(1) if comment else ""
    return found


def compile_and_run(source, name, build, folder):
    """What went wrong, or nothing."""
    path = os.path.join(folder, name)
    with open(path + ".c", "w", encoding="utf-8") as file:
        file.write(source)
    compiler = os.environ.get("CC", "gcc").split()
    done = subprocess.run([*compiler, *FLAGS, path + ".c", os.path.join(build, "libcairn.a"), "-lm", "-lpthread", "-o", path],
                          capture_output=True, text=True, check=False, cwd=TOP)
    if done.returncode != 0:
        return done.stderr
    done = subprocess.run([path], capture_output=True, text=True, check=False, timeout=60)
    return "" if done.returncode == 0 else f"{done.stdout}{done.stderr}ended with code {done.returncode}\n"


def check_quote(text, file):
    with open(os.path.join(TOP, file), encoding="utf-8") as source:
        return "" if text + "\n" in source.read() else f"these lines are not in {file}\n"


def check_page(name, page, build, folder):
    """Number of blocks and messages. All fragments of a page are one program."""
    messages, program, calls, count = [], "", "", 0
    for line, mark, text in blocks(page):
        count += 1
        here = f"{name}:{line}"
        if mark == "outline":
            continue
        if mark.startswith("from "):
            wrong = check_quote(text, mark[5:])
        elif "int main(" in text:
            wrong = compile_and_run(text + "\n", f"program_{count}", build, folder)
        elif re.match(r"(/\*.*\*/\s*)?(static|typedef)\b", text):
            program += f'#line {line} "{name}"\n{text}\n'
            wrong = ""
        else:
            program += BEGIN % (count, line, name, text)
            fails = 1 if mark == "a call fails" else 0
            calls += f'\tfailed |= report("{here}", block_{count}(), {fails});\n'
            wrong = ""
        messages += [f"{here}: {wrong}"] if wrong else []
    if calls:
        program += ('static int report(const char *where, const char *text, int expected)\n{\n'
                    '\tif ((text[0] != 0) != expected)\n\t\tprintf("%s: %s\\n", where, text[0] != 0 ? text : "no call failed");\n'
                    '\treturn (text[0] != 0) != expected;\n}\n')
        wrong = compile_and_run(PRELUDE + program + f"int main(void)\n{{\n\tint failed = 0;\n{calls}\treturn failed;\n}}\n", "page", build, folder)
        messages += [wrong] if wrong else []
    elif program:
        wrong = compile_and_run(PRELUDE + program + "int main(void) { return 0; }\n", "page", build, folder)
        messages += [wrong] if wrong else []
    return count, messages


def check_names(name, page, api):
    """Names of the API in code marks; cn_joint_create_* stands for several."""
    known = set(api.page) | {"cn_", "CN_"}
    built = {"CN_NO_THREADS", "CN_NO_SIMD", "CN_NO_CLOCK", "CN_BUILD", "CN_SHARED", "CN_NO_MALLOC", "CN_STRICT_HANDLES"}
    for match in re.finditer(r"`((?:cn_|CN_)[A-Za-z0-9_]*)(\*|\.\.\.)?", page):
        word = match.group(1)
        if word in known or word in built or match.group(2) or any(other.startswith(word) for other in known if word.endswith("_")):
            continue
        line = page[:match.start()].count("\n") + 1
        yield f"{name}:{line}: cairn.h has no {word}\n"


def check_menu(folder):
    stage.main(os.path.join(folder, "pages"))
    with open(os.path.join(folder, "pages.yml"), encoding="utf-8") as file:
        menu = re.findall(r"^ +- (?:.+: )?(\S+\.md)$", file.read(), re.M)
    for page in menu:
        if not os.path.exists(os.path.join(folder, "pages", page)):
            yield f"examples/docs/site/mkdocs.yml: no page {page}\n"


def check_reference(api, folder):
    """Each function that the header declares has its heading."""
    declared = set(re.findall(r"^CN_API [^;]*?\b(cn_\w+)\(", api.header, re.M))
    text = ""
    for file in os.listdir(os.path.join(folder, "pages", "reference")):
        with open(os.path.join(folder, "pages", "reference", file), encoding="utf-8") as page:
            text += page.read()
    for symbol in sorted(declared | set(api.page)):
        if f"{{ #{symbol} }}" not in text and f'id="{symbol}"' not in text:
            yield f"reference: no {symbol}\n"
    if len(declared) < 100:
        yield "reference: cairn.h was not understood\n"


def main(build):
    api, messages, count, pages = reference.Api(TOP), [], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for name in stage.pages():
            if not name.startswith(("README.md", "examples/docs/")):
                continue
            with open(os.path.join(TOP, name), encoding="utf-8") as file:
                page = file.read()
            number, wrong = check_page(name, page, os.path.abspath(build), folder)
            count, pages = count + number, pages + 1
            messages += wrong
            messages += check_names(name, page, api)
        messages += check_menu(folder)
        messages += check_reference(api, folder)
    for message in messages:
        print(message, end="" if message.endswith("\n") else "\n")
    print(f"pages: {pages}, C blocks: {count}, symbols: {len(api.page)}, {'wrong: ' + str(len(messages)) if messages else 'good'}")
    return 1 if messages or count < 20 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
