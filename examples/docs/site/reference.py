"""The API reference as Markdown pages, one a section of cairn.h, from bindings/api.json: every symbol with its comment."""
import json
import os
import re

KINDS = ("enums", "structs", "callbacks", "functions")
HANDLES = ("handles", "scalars", "opaque")
NAME = re.compile(r"\b(?:cn_[a-z0-9_]+|CN_[A-Z0-9_]+)\b")


def slug(section):
    return re.sub(r"[^a-z0-9]+", "_", section.lower()).strip("_")


class Api:
    def __init__(self, top):
        with open(os.path.join(top, "bindings", "api.json"), encoding="utf-8") as file:
            self.data = json.load(file)
        with open(os.path.join(top, "include", "cairn.h"), encoding="utf-8") as file:
            self.header = file.read()
        self.sections = list(dict.fromkeys(re.findall(r"^/\* -{10,} (.+?) \*/$", self.header, re.M)))
        self.page = {}  # symbol -> page
        for kind in KINDS:
            for item in self.data[kind]:
                page = slug(item["section"]) + ".md"
                for name in [item.get("name")] + [value["name"] for value in item.get("values", [])]:
                    if name:
                        self.page[name] = page
        for kind in HANDLES:
            for item in self.data[kind]:
                self.page[item["name"]] = "basic_types.md"
        for item in self.data["constants"]:
            self.page[item["name"]] = "constants.md"

    def of(self, kind, section):
        return [item for item in self.data[kind] if item["section"] == section]


def declared(kind, name):
    """A parameter or field as C writes it."""
    return kind + name if kind.endswith("*") else f"{kind} {name}"


def prototype(function):
    parameters = ", ".join(declared(p["type"], p["name"]) for p in function["parameters"]) or "void"
    line = declared(function["returns"]["type"], function["name"]) + "(" + parameters + ");"
    return line if len(line) <= 76 else line.replace("(", "(\n\t", 1)


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def link(api, text, page):
    """Names of symbols in a comment become links."""
    def one(match):
        name = match.group(0)
        where = api.page.get(name)
        return f"[`{name}`]({'' if where == page else where}#{name})" if where else f"`{name}`"
    return NAME.sub(one, text.replace("*", "\\*").replace("<", "&lt;"))


def enum_lines(api, item, page):
    yield f"### {item['doc'].split('.')[0].split(':')[0]}\n"
    yield link(api, item["doc"], page) + "\n"
    yield "| constant | value | |\n|---|---|---|"
    for value in item["values"]:
        yield f'| <a id="{value["name"]}"></a>`{value["name"]}` | {value["value"]} | {cell(link(api, value["doc"], page))} |'
    yield ""


def struct_lines(api, item, page):
    yield f"### `{item['name']}` {{ #{item['name']} }}\n"
    yield link(api, item["doc"], page) + "\n"
    yield f"{item['size']} bytes on 64-bit machines.\n"
    yield "| field | type | |\n|---|---|---|"
    for field in item["fields"]:
        kind = field["type"] + (f" [{field['array']}]" if field["array"] else "")
        name = NAME.search(kind)
        kind = link(api, kind, page) if name and name.group(0) in api.page else f"`{kind}`"
        yield f"| `{field['name']}` | {cell(kind)} | {cell(link(api, field['doc'], page))} |"
    yield ""


def function_lines(api, item, page):
    yield f"### `{item['name']}` {{ #{item['name']} }}\n"
    yield f"```c\n{prototype(item)}\n```\n"
    yield link(api, item["doc"], page) + "\n"


def section_page(api, section):
    page = slug(section) + ".md"
    lines = [f"# {section[0].upper()}{section[1:]}\n"]
    if section == "basic types":
        for kind in HANDLES:
            for item in api.data[kind]:
                what = item.get("type", "opaque struct")
                lines += [f"### `{item['name']}` {{ #{item['name']} }}\n", f"`{what}`: {link(api, item['doc'], page)}\n"]
    for kind, title, write in (("functions", "Functions", function_lines), ("structs", "Structs", struct_lines),
                               ("enums", "Constants", enum_lines), ("callbacks", "Callbacks", function_lines)):
        items = api.of(kind, section)
        if items:
            lines.append(f"## {title}\n")
            for item in items:
                lines += write(api, item, page)
    return page, "\n".join(lines) + "\n"


def constants_page(api):
    lines = ["# Constants of the library\n", "| constant | value | |\n|---|---|---|"]
    for item in api.data["constants"]:
        lines.append(f'| <a id="{item["name"]}"></a>`{item["name"]}` | {item["value"]} | {cell(link(api, item["doc"], "constants.md"))} |')
    return "constants.md", "\n".join(lines) + "\n"


def rules(api):
    """The header's first comment: the rules of every function."""
    text = api.header.split("/*", 1)[1].split("*/", 1)[0]
    text = text[text.index("Rules of every function"):]
    entries = []
    for line in text.split("\n")[1:]:
        start = re.match(r" \*  (\w+)\s{2,}(.*)", line)
        if start:
            entries.append([start.group(1), start.group(2)])
        elif entries and line.strip(" *"):
            entries[-1][1] += " " + line.strip(" *")
    return entries


def index_page(api):
    lines = ["# API reference\n", "Written from [cairn.h](../include/cairn.h), whose comments say the same.\n", "## Rules of every function\n",
             "| | |\n|---|---|"]
    lines += [f"| {word} | {cell(link(api, text, 'index.md'))} |" for word, text in rules(api)]
    lines += ["", "## Every symbol\n"]
    for name in sorted(api.page, key=str.lower):
        lines.append(f"[`{name}`]({api.page[name]}#{name})")
    return "index.md", "\n".join(lines) + "\n"


def write(top, folder):
    """Writes all pages; returns their names in order."""
    api = Api(top)
    pages = [index_page(api)] + [section_page(api, section) for section in api.sections] + [constants_page(api)]
    os.makedirs(folder, exist_ok=True)
    for name, text in pages:
        with open(os.path.join(folder, name), "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
    return api, [name for name, _ in pages]
