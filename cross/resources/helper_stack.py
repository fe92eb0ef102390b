"""Stack of the compiler's helpers (64-bit arithmetic) and of memcpy and memset. They come without a call
graph, and some are written in assembler, so it is read from their machine code."""

from machine_code import UnknownLowering, disassemble, goes_on_to, stack_lowered
from processors import Failure


def add_helper(graph, name, instructions):
    try:
        graph.add_function(name, stack_lowered(instructions))
    except UnknownLowering:
        raise Failure(f"the stack of the helper {name} is not known") from None
    for callee in goes_on_to(name, instructions):
        graph.add_call(name, callee)


def add_helpers(graph, image):
    """Adds all that the kernel calls and does not hold itself, and what those helpers go on to."""
    functions = disassemble(image)
    while graph.unknown():
        for name in graph.unknown():
            if name not in functions:
                raise Failure(f"{name} has no code in {image.name}")
            add_helper(graph, name, functions[name])
