"""The public functions of the kernel: declared in its headers, not private and not inline."""

import re
from pathlib import Path

from processors import run

SCOPE = re.compile(r"\bnamespace\s+(\w+)|(?<!enum )\b(class|struct)\s+(?:OSEM_\w+\s+)?(\w+)")
ACCESS = re.compile(r"\b(public|protected|private)\s*:(?!:)")
DECLARED = re.compile(r"(\w+)\s*\((?!\s*\*)")


def without_comments(text):
    lines = [line.split("//")[0] for line in text.splitlines()]
    return "\n".join(line for line in lines if not line.lstrip().startswith("#"))


class HeaderReader:
    """Goes through a header scope by scope. A function's declaration ends with a semicolon; one with a body
    is inline and has no address of its own."""

    def __init__(self):
        self.functions = set()
        self.scopes = []  # (name, whether what is declared now is public); no name inside bodies

    def open_scope(self, statement):
        named = SCOPE.search(statement)
        outside = all(name for name, _ in self.scopes)
        if named and outside:
            self.scopes.append((named.group(1) or named.group(3), named.group(2) != "class"))
        else:
            self.scopes.append((None, False))

    def set_access(self, statement):
        access = ACCESS.findall(statement)
        if access and self.scopes:
            self.scopes[-1] = (self.scopes[-1][0], access[-1] == "public")

    def declare(self, statement):
        declared = DECLARED.search(statement)
        # The last: a variable, whatever its initialiser calls.
        excluded = re.search(r"=\s*(delete|default)|static_assert|\busing\b|\(\s*\*|^[^(]*=", statement)
        visible = all(name and public for name, public in self.scopes)
        if declared and visible and not excluded:
            self.functions.add("::".join([name for name, _ in self.scopes[1:]] + [declared.group(1)]))

    def read(self, text):
        statement = ""
        for character in without_comments(text):
            if character not in "{};":
                statement += character
                continue
            self.set_access(statement)
            if character == "{":
                self.open_scope(statement)
            elif character == "}":
                self.scopes.pop()
            else:
                self.declare(statement)
            statement = ""


def declared(kernel: Path):
    reader = HeaderReader()
    for header in sorted((kernel / "include").rglob("*.hpp")):
        reader.read(header.read_text())
    return reader.functions


def readable_names(symbols):
    """Maps symbols to names without the namespace, such as Conversion::step."""
    symbols = sorted(symbols)
    names = run(["arm-none-eabi-c++filt", *symbols]).splitlines()
    names = [re.sub(r"\[abi:\w+\]", "", name) for name in names]
    return {symbol: name.split("(")[0].removeprefix("osem::") for symbol, name in zip(symbols, names)}
