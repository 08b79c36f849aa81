"""Collects the pages of the site: every Markdown page of the repository in its place, the small examples and files that pages link to,
the API reference. Links that a site cannot follow (folders, C files) are turned into ones that it can.

    python3 examples/docs/site/stage.py build/docs-pages     also writes build/docs-pages.yml for mkdocs
"""
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.abspath(os.path.join(HERE, "..", "..", ".."))
sys.path.insert(0, HERE)
import reference  # noqa: E402

LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s]+)(\))")
SYMBOL = re.compile(r"(?<!\[)`((?:cn_|CN_)[A-Za-z0-9_]+)`(?!\])")


def pages():
    for folder, names, files in os.walk(TOP):
        names[:] = sorted(n for n in names if n not in ("build", ".git"))
        yield from (os.path.relpath(os.path.join(folder, f), TOP) for f in sorted(files) if f.endswith(".md"))


def code_page(path, out):
    """A source file as a page."""
    target = os.path.join(out, path + ".md")
    if os.path.exists(target):
        return
    os.makedirs(os.path.dirname(target), exist_ok=True)
    with open(os.path.join(TOP, path), encoding="utf-8") as file:
        text = file.read()
    language = "c" if path.endswith((".c", ".h")) else "python" if path.endswith(".py") else "sh"
    with open(target, "w", encoding="utf-8", newline="\n") as file:
        file.write(f"# {os.path.basename(path)}\n\n````{language}\n{text}````\n")


def new_target(page, target, out):
    """Where a link leads in the site; None: nowhere."""
    if re.match(r"[a-z]+:", target) or target.startswith("#"):
        return target
    file, _, anchor = target.partition("#")
    path = os.path.normpath(os.path.join(os.path.dirname(page), file))
    full = os.path.join(TOP, path)
    if os.path.isdir(full):
        return os.path.join(file, "README.md") if os.path.exists(os.path.join(full, "README.md")) else None
    if path.endswith(".md"):
        return target
    if path.endswith((".c", ".h", ".py", ".sh")):
        code_page(path, out)
        return file + ".md"
    os.makedirs(os.path.dirname(os.path.join(out, path)), exist_ok=True)
    shutil.copyfile(full, os.path.join(out, path))
    return target


def convert(page, text, api, out):
    """A page's text for the site; code blocks stay as they are."""
    to_reference = os.path.relpath("reference", os.path.dirname(page) or ".")

    def link(match):
        target = new_target(page, match.group(2), out)
        return match.group(0)[1:].split("](")[0] if target is None else match.group(1) + target + match.group(3)

    def symbol(match):
        name = match.group(1)
        return f"[`{name}`]({to_reference}/{api.page[name]}#{name})" if name in api.page else match.group(0)

    lines, code = [], False
    for line in text.split("\n"):
        fence = line.startswith("```")
        if fence:
            code = not code
        if not code and not fence:
            line = LINK.sub(link, line)
            if not line.startswith("#"):
                line = SYMBOL.sub(symbol, line)
        lines.append(line)
    return "\n".join(lines)


def menu(names, folder):
    return "".join(f"\n    - {folder}/{name}" for name in names)


def main(out):
    shutil.rmtree(out, ignore_errors=True)
    api, names = reference.write(TOP, os.path.join(out, "reference"))
    for page in pages():
        with open(os.path.join(TOP, page), encoding="utf-8") as file:
            text = convert(page, file.read(), api, out)
        os.makedirs(os.path.dirname(os.path.join(out, page)), exist_ok=True)
        with open(os.path.join(out, page), "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
    shutil.copyfile(os.path.join(HERE, "extra.css"), os.path.join(out, "extra.css"))
    code_page("include/cairn.h", out)
    with open(os.path.join(out, "reference", "index.md"), encoding="utf-8") as file:
        text = file.read().replace("(../include/cairn.h)", "(../include/cairn.h.md)")
    with open(os.path.join(out, "reference", "index.md"), "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    small = sorted(name for name in os.listdir(os.path.join(TOP, "examples")) if name.endswith(".c"))
    for name in small:
        code_page(f"examples/{name}", out)
    with open(os.path.join(HERE, "mkdocs.yml"), encoding="utf-8") as file:
        settings = file.read()
    settings = settings.replace(" REFERENCE", menu(names, "reference"))
    settings = settings.replace(" EXAMPLES", menu(["README.md"] + [name + ".md" for name in small], "examples"))
    with open(out.rstrip("/") + ".yml", "w", encoding="utf-8", newline="\n") as file:
        file.write(settings)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
