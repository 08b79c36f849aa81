"""Reads the text of cairn.h into the api: a dictionary of plain lists, as in api.json.

A hand-written parser for exactly the C that the header is written in:

    #define NAME integer                    constants
    typedef uint32_t cn_thing;              handles      (int32_t: a scalar with a name, cn_result)
    typedef struct cn_thing cn_thing;       opaque types
    typedef struct cn_thing { ... } cn_thing;
    typedef void cn_thing_fn(...);          callbacks; a field void (*name)(...) of a struct makes one
                                            that is called <struct>_<name>_fn
    enum { NAME = value, ... };
    CN_API type cn_name(...);               functions

Anything else raises HeaderError with its line: a binding must never be wrong in silence. Comments
become documentation: the one that ends on the line before a declaration, and the one behind it.
"""
import re

SCALARS = {"char": 1, "int8_t": 1, "uint8_t": 1, "int16_t": 2, "uint16_t": 2, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "float": 4, "double": 8}

TOKENS = re.compile(
    r"(?P<comment>/\*.*?\*/)|(?P<directive>^[ \t]*\#[^\n]*)|(?P<string>\"[^\"\n]*\")"
    r"|(?P<number>(?:0[xX][0-9a-fA-F]+|[0-9]+)[uU]?)(?![\w.])|(?P<name>[A-Za-z_]\w*)|(?P<punctuation><<|[{}()\[\];:,*=|+~-])|(?P<space>\s+)",
    re.DOTALL | re.MULTILINE,
)


class HeaderError(Exception):
    pass


class Token:
    def __init__(self, kind, text, line):
        self.kind, self.text, self.line = kind, text, line

    def __repr__(self):
        return repr(self.text)


def tokenize(text, file, line=1):
    tokens, position = [], 0
    while position < len(text):
        match = TOKENS.match(text, position)
        if match is None:
            raise HeaderError("%s:%d: cannot read %r" % (file, line, text[position:].split("\n", 1)[0]))
        if match.lastgroup != "space":
            tokens.append(Token(match.lastgroup, match.group(), line))
        line += match.group().count("\n")
        position = match.end()
    return tokens


def drop_conditionals(tokens, file):
    """Removes include lines, the include guard, what is for C++ only and the definition of CN_API.

    Each open #if is one of "guard", "cxx" (contents dropped up to #else), "c" (behind that #else) and "api" (may define CN_API, no
    more).
    """
    kept, open_ifs = [], []
    for token in tokens:
        words = re.sub(r"#\s+", "#", token.text.strip()).split() if token.kind == "directive" else [""]
        if words[0] in ("#if", "#ifdef", "#ifndef"):
            guard = not open_ifs and words[0] == "#ifndef"
            cxx = words[1:] == ["__cplusplus"] or words[1:] == ["defined(__cplusplus)", "&&", "defined(CN_STRICT_HANDLES)"]
            open_ifs.append("guard" if guard else "cxx" if cxx else "api")
        elif words[0] == "#else" and open_ifs and open_ifs[-1] == "cxx":
            open_ifs[-1] = "c"
        elif words[0] == "#endif" and open_ifs:
            open_ifs.pop()
        elif words[0] == "#include":
            pass
        elif "cxx" in open_ifs:
            pass
        elif "api" in open_ifs:
            if words[0] not in ("#else", "#elif") and words[:2] != ["#define", "CN_API"]:
                raise HeaderError("%s:%d: %s inside of #if: bindings cannot see conditions" % (file, token.line, token))
        elif words[0] == "#define" and len(words) == 2 and open_ifs == ["guard"]:
            pass
        else:
            kept.append(token)
    if open_ifs:
        raise HeaderError("%s: #if without #endif" % file)
    return kept


def clean_comment(text):
    lines = [line.strip().lstrip("*").strip() for line in text[2:-2].split("\n")]
    return " ".join(line for line in lines if line)


class Comments:
    """Takes the comments out of the tokens and gives them back by line."""

    def __init__(self, tokens):
        self.before, self.behind, self.sections = {}, {}, []
        self.tokens, last_line = [], 0
        for token in tokens:
            if token.kind != "comment":
                self.tokens.append(token)
                last_line = token.line
                continue
            words, end = clean_comment(token.text), token.line + token.text.count("\n")
            section = re.fullmatch(r"-{5,} *(.*)", words)
            if section:
                self.sections.append((token.line, section.group(1)))
            elif last_line == token.line:
                self.behind[token.line] = words
            else:
                self.before[end + 1] = words

    def of(self, first_line, last_line):
        parts = [self.before.get(first_line), self.behind.get(last_line)]
        return " ".join(part for part in parts if part)

    def section(self, line):
        return next((name for start, name in reversed(self.sections) if start < line), "")


class Parser:
    def __init__(self, text, file):
        self.file = file
        self.comments = Comments(drop_conditionals(tokenize(text, file), file))
        self.tokens, self.position = self.comments.tokens, 0
        self.tokens.append(Token("end", "", text.count("\n") + 1))
        self.api = {"abi_version": None, "constants": [], "enums": [], "handles": [], "scalars": [], "opaque": [], "structs": [], "callbacks": [], "functions": []}
        self.values = {}   # of constants and enumerators
        self.kinds = {}    # of declared types: "handle", "scalar", "opaque", "struct", "callback"
        self.names = set()

    # ---------------------------------------------------------------- tokens

    def fail(self, message, line=None):
        if line is None:
            line = self.tokens[self.position].line
        raise HeaderError("%s:%d: %s" % (self.file, line, message))

    def peek(self):
        return self.tokens[self.position].text

    def take(self):
        if self.tokens[self.position].kind == "end":
            self.fail("the header ends in the middle of a declaration")
        self.position += 1
        return self.tokens[self.position - 1]

    def accept(self, text):
        if self.peek() != text:
            return False
        self.position += 1
        return True

    def expect(self, text):
        if not self.accept(text):
            self.fail("expected %r, found %r" % (text, self.peek()))

    def name(self):
        token = self.take()
        if token.kind != "name":
            self.fail("expected a name, found %r" % token.text, token.line)
        return token

    def new_name(self, token):
        if token.text in self.names:
            self.fail("%s is declared twice" % token.text, token.line)
        self.names.add(token.text)
        return token.text

    # ---------------------------------------------------------------- values and types

    def integer(self, tokens, line):
        """Value of a constant expression, and whether it is unsigned."""
        words = []
        for token in tokens:
            if token.kind == "name" and token.text not in self.values:
                self.fail("%s is not a known constant" % token.text, line)
            if token.kind not in ("name", "number", "punctuation"):
                self.fail("%r in a constant; only integers are understood" % token.text, line)
            words.append(str(self.values[token.text]) if token.kind == "name" else token.text.rstrip("uU"))
        try:
            value = eval(" ".join(words), {"__builtins__": {}})  # integers and | + - ~ << ( ) only, as checked
        except (SyntaxError, TypeError, ValueError):
            self.fail("cannot evaluate %r" % " ".join(words), line)
        unsigned = any(token.kind == "number" and token.text[-1] in "uU" for token in tokens)
        low, high = (0, 2**32 - 1) if unsigned else (-(2**31), 2**31 - 1)
        if not isinstance(value, int) or not low <= value <= high:
            self.fail("%s does not fit 32 bits" % " ".join(words), line)
        return value, unsigned

    def tokens_until(self, *ends):
        tokens = []
        while self.peek() not in ends:
            tokens.append(self.take())
        return tokens

    def type(self):
        """const? name *... as a dictionary; the C spelling is in "type"."""
        const, token = self.accept("const"), self.name()
        base, pointers = token.text, 0
        if base == "struct":
            self.fail("write the typedef's name, not struct", token.line)
        if base not in SCALARS and base != "void" and base not in self.kinds:
            self.fail("unknown type %s (64-bit, float and exact-width integers, and types declared above)" % base, token.line)
        while self.accept("*"):
            pointers += 1
        if self.peek() == "const":
            self.fail("const behind *")
        if pointers > 2:
            self.fail("more than two *")
        if const and pointers == 0:
            self.fail("const without *", token.line)
        if self.kinds.get(base) in ("opaque", "callback") and pointers == 0:
            self.fail("%s without *" % base, token.line)
        spelling = ("const " if const else "") + base + (" " + "*" * pointers if pointers else "")
        return {"type": spelling, "base": base, "pointers": pointers, "const": const}

    def passed_type(self, what):
        """A parameter's or a result's: no struct by value, which LuaJIT does not compile."""
        line, found = self.tokens[self.position].line, self.type()
        if self.kinds.get(found["base"]) == "struct" and found["pointers"] == 0:
            self.fail("%s: struct %s by value; pass its fields or a pointer" % (what, found["base"]), line)
        return found

    def parameters(self, owner):
        self.expect("(")
        if self.peek() == "void" and self.tokens[self.position + 1].text == ")":
            self.position += 2
            return []
        found = []
        while True:
            parameter = self.passed_type(owner)
            if parameter["base"] in ("void", "char") and parameter["pointers"] == 0:
                self.fail("%s: a parameter of type %s" % (owner, parameter["base"]))
            parameter = {"name": self.name().text, **parameter}
            found.append(parameter)
            if self.accept(")"):
                return found
            self.expect(",")

    # ---------------------------------------------------------------- declarations

    def directive(self):
        token = self.take()
        line = re.sub(r"/\*.*?\*/", "", token.text)
        match = re.fullmatch(r"\s*#\s*define\s+(\w+)\s+([^\\]+)", line)
        if match is None:
            self.fail("cannot read %r (only #define NAME integer)" % token.text.strip(), token.line)
        name = self.new_name(Token("name", match.group(1), token.line))
        value, unsigned = self.integer(tokenize(match.group(2).strip(), self.file, token.line), token.line)
        self.values[name] = value
        doc = self.comments.of(token.line, token.line)
        self.api["constants"].append({"name": name, "value": value, "type": "uint32_t" if unsigned else "int32_t", "doc": doc})

    def enum(self):
        first = self.take()
        if self.peek() != "{":
            self.fail("an enum with a name has no fixed size; use enum { ... } and int32_t")
        self.expect("{")
        values, next_value, unsigned = [], 0, False
        while not self.accept("}"):
            token = self.name()
            name = self.new_name(token)
            if self.accept("="):
                next_value, is_unsigned = self.integer(self.tokens_until(",", "}"), token.line)
                unsigned = unsigned or is_unsigned
            last = self.tokens[self.position - 1].line
            if not self.accept(",") and self.peek() != "}":
                self.fail("expected ',' or '}', found %r" % self.peek())
            self.values[name] = next_value
            values.append({"name": name, "value": next_value, "doc": self.comments.of(token.line, last)})
            next_value += 1
        self.expect(";")
        doc = self.comments.before.get(first.line, "")
        self.api["enums"].append({"type": "uint32_t" if unsigned else "int32_t", "doc": doc, "section": self.comments.section(first.line), "values": values})

    def declare(self, kind, entry):
        self.kinds[entry["name"]] = kind
        lists = {"handle": "handles", "scalar": "scalars", "opaque": "opaque", "struct": "structs", "callback": "callbacks"}
        self.api[lists[kind]].append(entry)

    def typedef(self):
        first = self.take()
        doc = self.comments.before.get(first.line, "")
        if self.peek() in ("enum", "union"):
            self.fail("typedef %s" % self.peek())
        if self.accept("struct"):
            self.struct(doc, first.line)
            return
        line, result = first.line, self.passed_type("a callback")
        if self.peek() == "(":
            self.fail("a function pointer; declare the function type, as in typedef void cn_name_fn(...)")
        name = self.new_name(self.name())
        if self.peek() == "(":
            self.callback(name, doc, line, result, True)
        elif result["type"] in ("uint32_t", "int32_t"):
            doc = self.comments.of(line, self.tokens[self.position].line)
            self.declare("handle" if result["base"] == "uint32_t" else "scalar", {"name": name, "type": result["base"], "doc": doc})
        else:
            self.fail("typedef of %s (handles are uint32_t, results int32_t)" % result["type"], line)
        self.expect(";")

    def callback(self, name, doc, line, result, in_header):
        """in_header: the header has a type of this name."""
        parameters = self.parameters(name)
        if not parameters or parameters[-1]["type"] != "void *":
            self.fail("%s: the last parameter of a callback is void *user" % name, line)
        section = self.comments.section(line)
        self.declare("callback", {"name": name, "in_header": in_header, "doc": doc, "section": section, "returns": result, "parameters": parameters})

    def struct(self, doc, line):
        token = self.name()
        if self.peek() != "{":
            if self.name().text != token.text:
                self.fail("the typedef and the struct have different names", token.line)
            self.declare("opaque", {"name": self.new_name(token), "doc": doc or self.comments.of(line, line)})
            self.expect(";")
            return
        self.expect("{")
        fields = []
        while not self.accept("}"):
            fields.append(self.field(token.text))
            if fields[-1]["name"] in [field["name"] for field in fields[:-1]]:
                self.fail("%s: field %s twice" % (token.text, fields[-1]["name"]))
        if not fields:
            self.fail("%s has no fields" % token.text, token.line)
        if self.name().text != token.text:
            self.fail("the typedef and the struct have different names", token.line)
        self.expect(";")
        self.declare("struct", {"name": self.new_name(token), "doc": doc, "section": self.comments.section(line), "fields": fields})

    def field(self, owner):
        first = self.tokens[self.position]
        if first.text in ("struct", "union", "enum"):
            self.fail("%s: %s inside of a struct" % (owner, first.text))
        found = self.type()
        if self.accept("("):
            return self.pointer_field(owner, first, found)
        if found["base"] in ("void", "char") and found["pointers"] == 0:
            self.fail("%s: a field of type %s" % (owner, found["base"]), first.line)
        name, count = self.name().text, 0
        if self.accept("["):
            count = self.integer(self.tokens_until("]"), first.line)[0]
            self.expect("]")
            if count < 1:
                self.fail("%s: array %s of %d" % (owner, name, count), first.line)
        last = self.tokens[self.position].line
        self.expect(";")
        return {"name": name, **found, "array": count, "doc": self.comments.of(first.line, last)}

    def pointer_field(self, owner, first, result):
        """The rest of a field result (*name)(parameters), with a callback type of its own."""
        if self.kinds.get(result["base"]) == "struct" and result["pointers"] == 0:
            self.fail("%s: a callback returns struct %s by value" % (owner, result["base"]), first.line)
        self.expect("*")
        token = self.name()
        self.expect(")")
        kind = self.new_name(Token("name", "%s_%s_fn" % (owner, token.text), token.line))
        self.callback(kind, "", first.line, result, False)
        last = self.tokens[self.position].line
        self.expect(";")
        found = {"type": kind + " *", "base": kind, "pointers": 1, "const": False}
        doc = self.comments.of(first.line, last)
        self.api["callbacks"][-1]["doc"] = doc
        return {"name": token.text, **found, "array": 0, "doc": doc}

    def function(self):
        first = self.take()
        result = self.passed_type("a result")
        token = self.name()
        name = self.new_name(token)
        parameters = self.parameters(name)
        self.expect(";")
        doc = self.comments.before.get(first.line, "")
        self.api["functions"].append({"name": name, "doc": doc, "section": self.comments.section(first.line), "returns": result, "parameters": parameters})

    def parse(self):
        while self.tokens[self.position].kind != "end":
            token = self.tokens[self.position]
            if token.kind == "directive":
                self.directive()
            elif token.text == "typedef":
                self.typedef()
            elif token.text == "enum":
                self.enum()
            elif token.text == "CN_API":
                self.function()
            else:
                self.fail("cannot read a declaration that starts with %r" % token.text)
        self.api["abi_version"] = self.values.get("CN_ABI_VERSION", 0)
        return self.api


def parse(text, file="cairn.h"):
    return Parser(text, file).parse()
