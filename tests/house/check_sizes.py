# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""No file is longer than 300 lines, no function longer than 60, no line of code longer than 140 characters."""
import ast
import re

from house import is_code, main

FILE_CAP = 300
FUNCTION_CAP = 60
LINE_CAP = 140
NOT_CODE = re.compile(
    r'R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-zA-Z_])\'(?:\\.|[^\'\\\n])+\''
    r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*",
    re.S | re.M,
)
SCOPE = re.compile(r"\s*(?:template\s*<.*>\s*)?(?:inline\s+|typedef\s+)?(?:namespace|class|struct|union|enum|extern)\b", re.S)
MEMBER_INITIALISERS = re.compile(r"\)[\s\w]*:(?!:)")


def blanked(text):
    """The text with comments, literals and preprocessor lines emptied; lines stay where they are."""

    def blank(match):
        literal = match[0][0] in "R\"'"
        return '""' * literal + "\n" * match[0].count("\n")

    return NOT_CODE.sub(blank, text)


def matching_brace(code, start):
    """Position behind the brace that closes the one at `start`."""
    depth = 0
    for position in range(start, len(code)):
        depth += {"{": 1, "}": -1}.get(code[position], 0)
        if depth == 0:
            return position + 1
    return len(code)


def cpp_functions(text):
    """(first line, last line) of every function of namespaces and classes; what is inside a function counts with it."""
    code, found = blanked(text), []
    position = header_start = parentheses = 0
    while position < len(code):
        letter = code[position]
        parentheses += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "{":
            header = code[header_start:position]
            end = matching_brace(code, position)
            in_initialisers = MEMBER_INITIALISERS.search(header) and re.search(r"[\w>]\s*$", header)
            if parentheses > 0 or in_initialisers:
                position = end
                continue
            if not SCOPE.match(header):
                if ")" in header:
                    first = header_start + len(header) - len(header.lstrip())
                    found.append((code.count("\n", 0, first) + 1, code.count("\n", 0, end) + 1))
                header_start = position = end
                continue
        if letter in "{};" and parentheses == 0:
            header_start = position + 1
        position += 1
    return found


def python_functions(text):
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return [(node.lineno, node.end_lineno) for node in ast.walk(ast.parse(text)) if isinstance(node, kinds)]


def check(files):
    findings = []
    for path, text in files.items():
        python = path.endswith(".py")
        if not (python or path.endswith(".sh") or is_code(path)):
            continue
        lines = text.count("\n")
        if lines > FILE_CAP:
            findings.append(f"{path}: {lines} lines; the cap is {FILE_CAP}: one idea for each file")
        findings += [f"{path}:{number}: {len(line)} characters; the cap is {LINE_CAP}: see .clang-format"
                     for number, line in enumerate(text.splitlines(), 1) if is_code(path) and len(line) > LINE_CAP]
        functions = python_functions(text) if python else cpp_functions(text) if is_code(path) else []
        for first, last in functions:
            if last - first + 1 > FUNCTION_CAP:
                findings.append(f"{path}:{first}: a function of {last - first + 1} lines; the cap is {FUNCTION_CAP}")
    return findings


LONG = "    a = b;\n" * FUNCTION_CAP
BAD = [
    {"core/a.cpp": "// what f() does\nclass A {\n    void f()\n    {\n" + LONG + "    }\n};\n"},
    {"core/a.hpp": "// line\n" * (FILE_CAP + 1)},
    {"core/a.cpp": "namespace core {\nint f(int a = int{})\n{\n" + LONG + "}\n} // namespace core\n"},
    {"core/a.cpp": "A::A(int b) : b_{b}, c_(b)\n{\n" + LONG + "}\n"},
    {"core/a.hpp": "template <class T> struct A {\n    int c = 0;\n    int f() const noexcept {\n" + LONG + "    }\n};\n"},
    {"core/a.cpp": "char c = '{';\nauto s = \"}\"; // {\nvoid f() {\n" + LONG + "}\n"},
    {"tests/a.py": "def f():\n" + LONG},
    {"core/a.hpp": "// " + "x" * LINE_CAP + "\n"},
]
GOOD = {
    "core/a.hpp": "namespace core {\nstruct A {\n" + "    int f() { return 1; }\n" * 70 + "};\n} // namespace core\n",
    "core/b.cpp": "// line\n" * FUNCTION_CAP + "void f()\n{\n}\n",
    "core/a.cpp": "const int a[] = {\n" + "    1,\n" * 70 + "};\n",
}
main(check, BAD, GOOD)
