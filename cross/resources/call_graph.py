"""The call graph that GCC writes (-fcallgraph-info=su,da), and the deepest stack on it."""

import re

from machine_code import UnknownLowering, disassemble, same_place, stack_lowered
from processors import Failure, run

INDIRECT = "__indirect_call"
NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"', re.MULTILINE)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', re.MULTILINE)
FRAME = re.compile(r"(\d+) bytes \(([a-z,]+)\)")
OBJECTS = re.compile(r"(\d+) dynamic objects")


def readable(name):
    return run(["arm-none-eabi-c++filt", name.rsplit(":", 1)[-1]]).strip()


class CallGraph:
    def __init__(self):
        self.frames = {}  # bytes that a function itself takes, its saved registers included
        self.calls = {}
        self.aliases = {}
        self._deepest = {}

    def add_function(self, name, frame):
        self.frames[name] = max(frame, self.frames.get(name, 0))
        self.calls.setdefault(name, set())

    def add_call(self, caller, callee):
        self.calls.setdefault(caller, set()).add(callee)

    def resolve(self, name):
        return name if name in self.frames else self.aliases.get(name, name)

    def unknown(self):
        """Functions that are called and not defined here."""
        called = {self.resolve(callee) for callees in self.calls.values() for callee in callees}
        return sorted(called - self.frames.keys() - {INDIRECT})

    def reaches(self, name, wanted):
        found, waiting = set(), [name]
        while waiting:
            function = self.resolve(waiting.pop())
            if function not in found:
                found.add(function)
                waiting.extend(self.calls.get(function, ()))
        return wanted in found

    def deepest(self, name, path=()):
        """Bytes of stack at most, from the moment `name` is entered; the path is that of its callers."""
        name = self.resolve(name)
        if name == INDIRECT:
            return 0
        if name in path:
            raise Failure("recursion: " + " -> ".join(map(readable, path[path.index(name):] + (name,))))
        if name not in self.frames:
            callers = " and ".join(map(readable, path[-1:]))
            raise Failure(f"the frame of {readable(name)} is not known, called by {callers or 'nothing'}")
        if name not in self._deepest:
            below = [self.deepest(callee, path + (name,)) for callee in sorted(self.calls[name])]
            self._deepest[name] = self.frames[name] + max(below, default=0)
        return self._deepest[name]


def function_name(title):
    """GCC puts the file before a function that other files do not see. An inline function that several files
    hold is one to the linker; anonymous ones and the compiler's partial copies are each file's own."""
    name = title.rsplit(":", 1)[-1]
    return title if "." in name or "_GLOBAL__N_" in name else name


def frame_of(stated, instructions):
    """GCC's figure counts the saved registers and the local variables, but not the registers in which a
    caller hands over the first part of a large argument and which the function then stores on its own stack;
    the machine code shows them. There are at most four, if it cannot be read."""
    try:
        return max(stated, stack_lowered(instructions))
    except UnknownLowering:
        return stated + 16


def add_node(graph, title, label, code):
    stated = FRAME.search(label)
    if stated is None:
        return  # a declaration
    readable = label.split("\\n")[0]
    objects = OBJECTS.search(label)
    if stated.group(2) != "static" or (objects and objects.group(1) != "0"):
        raise Failure(f"the stack of {readable} is not known when it is compiled ({stated.group(2)})")
    symbol = title.rsplit(":", 1)[-1]
    if symbol not in code:
        raise Failure(f"{readable} is in the call graph, but has no code")
    graph.add_function(function_name(title), frame_of(int(stated.group(1)), code[symbol]))


def add_aliases(graph, object_file):
    for names in same_place(object_file):
        defined = names & graph.frames.keys()
        for name in names - defined:
            if defined:
                graph.aliases[name] = min(defined)


def check_complete(graph, object_file):
    """The assembler's view: a call that GCC made without saying so would be missing in the graph."""
    named = graph.calls.keys() | {callee for callees in graph.calls.values() for callee in callees}
    for line in run(["arm-none-eabi-nm", "-u", object_file]).splitlines():
        symbol = line.split()[-1]
        if symbol not in named:
            raise Failure(f"{object_file.name} calls {symbol}, which the call graph does not show")


def read_kernel(build):
    graph = CallGraph()
    for object_file in build.objects:
        text = object_file.with_suffix(".ci").read_text()
        code = disassemble(object_file)
        for title, label in NODE.findall(text):
            add_node(graph, title, label, code)
        for caller, callee in EDGE.findall(text):
            graph.add_call(function_name(caller), function_name(callee))
    for object_file in build.objects:
        add_aliases(graph, object_file)
        check_complete(graph, object_file)
    return graph
