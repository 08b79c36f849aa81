#!/usr/bin/env python3
"""usage: readme.py build-folder [--all] [--list] [word...]

Runs the commands of every README as a new user would: in a copy of the tree under build-folder/readme, page by page, line by line. A
command is a line of an sh block, or an indented line that begins with make; a block under a line "`path`:" is written to that file. Words
select pages whose path contains one of them; --list prints the commands.

A command runs as it is written, unless the table `others` has another for it: one that takes long, needs a screen or never ends. Without
--all long ones only must be known to make. All lines "box at ..." must be the same: the hash of one program in every language.
Ends with one line "N passed, N failed, N skipped".
"""
import os
import re
import shutil
import subprocess
import sys
import time

KNOWN = "known"  # make -n of it
# The beginning of a command; what runs without --all; what runs with it. None: as it is written.
others = [
    ("make testbed-web", "make testbed-web-files", "make testbed-web-files"),
    ("make testbed", KNOWN, "SDL_VIDEODRIVER=dummy timeout 60 {}; [ $? = 124 ]"),
    ("make demo", KNOWN, None),
    ("make readme", KNOWN, KNOWN),  # runs this script, and so does the next
    ("make test-all", KNOWN, KNOWN),
    ("make test-arch", KNOWN, "make test-arch CONFIGURATION='gcc-O1 scalar'"),
    ("make test-bindings", KNOWN, None),
    ("make test", KNOWN, None),
    ("make coverage", KNOWN, KNOWN),
    ("make lint", KNOWN, KNOWN),
    ("make mutation", KNOWN, "make mutation QUICK=1 ONLY=maths.c"),
    ("make fuzz", KNOWN, "make fuzz FUZZ_SECONDS=5 TARGET=geometry"),
    ("make families PEERS", KNOWN, KNOWN),
    ("make families", KNOWN, "make families SEEDS=1 FAMILY=cloth"),
    ("make ablation", KNOWN, KNOWN),
    ("make tuning", KNOWN, KNOWN),
    ("make stability STABILITY", KNOWN, None),
    ("make stability", KNOWN, KNOWN),
    ("make soak", KNOWN, KNOWN),
    ("make chart", KNOWN, KNOWN),
    ("make bench-peers", KNOWN, KNOWN),
    ("make bench-diff", KNOWN, "make bench-diff BASE=HEAD SCENE=small_10 QUICK=1 ROUNDS=1"),
    ("make bench-scale", KNOWN, "make bench-scale KIND=tree"),
    ("make feature-cost", KNOWN, "make feature-cost FEATURE=sensor"),
    ("sh bindings/csharp/natives.sh", ":", None),
    ("cc -O3", "cc -O0 -DCN_NO_SIMD {rest}", None),  # quick ones: the same bits
    ("cmake -S", "cmake -D CMAKE_BUILD_TYPE=Debug {rest}", None),
    ("luarocks", "luarocks {rest} CFLAGS='-O0 -fPIC -DCN_NO_SIMD'", None),
    ("build/bin/stability --sweep", "make -n build/bin/stability", "make -n build/bin/stability"),
    ("build/bin/stability", "make -n build/bin/stability", "make build/bin/stability && {}"),
    ("build/test/base/maths_test", "make build/test/base/maths_test && {}", "make build/test/base/maths_test && {}"),
    ("CAIRN_PRINT_GOLDEN=1 build/test", "make -n build/test/world/determinism_test", "make build/test/world/determinism_test && {}"),
    ("CAIRN_OFF", ":", ":"),  # programs of make ablation and make tuning
    ("CAIRN_TUNE", ":", ":"),
]
# What a page needs that may not be installed.
needs = {"rust": "cargo", "go": "go", "javascript": "npm", "csharp": "mcs", "lua": "luarocks", "luajit": "luajit", "cmake": "cmake", "cpp": "g++"}


def steps_of(page):
    """(file, text) and (None, command), in the order of the page."""
    steps, block, language, path = [], [], None, None
    for line in open(page, encoding="utf-8").read().split("\n"):
        fence = re.match(r"```(\w*)", line)
        if fence and language is None:
            language, block = fence[1], []
        elif fence:
            if path:
                steps.append((path, "\n".join(block) + "\n"))
            elif language == "sh":
                steps += [(None, command) for command in map(strip, block) if command]
            language, path = None, None
        elif language is not None:
            block.append(line)
        elif re.match(r"    make ", line):
            steps.append((None, strip(re.sub(r"  +.*", "", line.strip()))))
        elif line.strip():
            named = re.fullmatch(r"`([\w./-]+)`:", line)
            path = named[1] if named else None
    return steps


def strip(line):
    return re.sub(r"\s+# .*|^# .*", "", line).strip()


def instead(command, everything):
    for beginning, quick, whole in others:
        if command.startswith(beginning):
            other = whole if everything else quick
            if other == KNOWN:
                return re.sub(r"^make", "make -n", command)
            return command if other is None else other.replace("{}", command).replace("{rest}", command[len(beginning):] if beginning.startswith(("cc", "lua")) else command[len("cmake"):])
    return command


def copy_tree(tree):
    shutil.rmtree(tree, ignore_errors=True)
    names = subprocess.run(["git", "ls-files", "-z", "-co", "--exclude-standard"], capture_output=True, check=True).stdout.decode().split("\0")
    for name in names:
        if name and os.path.exists(name):
            os.makedirs(os.path.join(tree, os.path.dirname(name)), exist_ok=True)
            shutil.copy2(name, os.path.join(tree, name))
    subprocess.run("git init -q && git add -A && git -c user.name=readme -c user.email=readme@example.org commit -q -m readme", shell=True, cwd=tree, check=True)


def environment(build, everything):
    env = {name: value for name, value in os.environ.items() if not name.startswith(("CAIRN_", "MAKE", "MFLAGS")) and name not in ("CC", "BUILD")}
    venv = os.path.join(build, "venv")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", venv], check=True)
    env["PATH"] = os.pathsep.join([venv + "/bin", "/usr/lib/ccache", env["PATH"]])
    env["PIP_DISABLE_PIP_VERSION_CHECK"] = "1"
    if not everything:  # a sixth of the time, the same bits
        env["CFLAGS"] = env["CGO_CFLAGS"] = "-O0 -DCN_NO_SIMD"
    return env


def main():
    flags = [word for word in sys.argv[1:] if word.startswith("--")]
    build, *words = [word for word in sys.argv[1:] if not word.startswith("--")]
    everything = "--all" in flags
    pages = sorted(subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "README.md", "*/README.md"], capture_output=True, check=True, text=True).stdout.split())
    pages = [page for page in pages if not words or any(word in page for word in words)]
    if "--list" in flags:
        for page in pages:
            for path, text in steps_of(page):
                print("%s: %s" % (page, "writes " + path if path else text if instead(text, everything) == text else text + "  ->  " + instead(text, everything)))
        return 0
    build = os.path.abspath(os.path.join(build, "readme"))
    tree = os.path.join(build, "tree")
    copy_tree(tree)
    env = environment(build, everything)
    passed = failed = skipped = 0
    boxes = {}
    for page in pages:
        tool = needs.get(page.split("/")[-2] if "/" in page else "")
        if tool and not shutil.which(tool):
            print("SKIP %s: %s is not installed (see .ci/deps)" % (page, tool))
            skipped += 1
            continue
        for path, text in steps_of(page):
            if path:
                os.makedirs(os.path.join(tree, os.path.dirname(path)), exist_ok=True)
                open(os.path.join(tree, path), "w", encoding="utf-8").write(text)
                continue
            start = time.time()
            try:
                result = subprocess.run(instead(text, everything), shell=True, cwd=tree, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=1800)
                output, code = result.stdout.decode(errors="replace"), result.returncode
            except subprocess.TimeoutExpired as error:
                output, code = (error.stdout or b"").decode(errors="replace"), "no end"
            for line in re.findall(r"^box at .*$", output, re.M):
                boxes.setdefault(line, []).append(page)
            if code == 0:
                passed += 1
                print("PASS %s: %s (%.0f s)" % (page, text, time.time() - start), flush=True)
            else:
                failed += 1
                print("%s\nFAIL %s: %s (%s)" % (output[-3000:], page, text, code), flush=True)
    for line, of in boxes.items():
        print("%s: %s" % (line, ", ".join(of)))
    if len(boxes) > 1:
        print("FAIL the programs of the languages disagree")
        failed += 1
    print("%d passed, %d failed, %d skipped" % (passed, failed, skipped))
    return failed > 0


sys.exit(main())
