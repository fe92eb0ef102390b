"""What the machine code says of the stack: by how much a function lowers it, and whom it goes on to."""

import re

from processors import Failure, run

FUNCTION = re.compile(r"^[0-9a-f]+ <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t[0-9a-f ]+\t(\S+)(?:\t(.*))?$")
TARGET = re.compile(r"<([^>+]+)(?:\+0x[0-9a-f]+)?>")
CALL = re.compile(r"bl(\.[nw])?$")
JUMP = re.compile(r"b(eq|ne|cs|cc|hs|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le|al)?(\.[nw])?$")


class UnknownLowering(Exception):
    """The stack pointer is lowered by a register."""


def register_count(listed):
    """Of r4, r6-r8, lr."""
    count = 0
    for part in listed.split(","):
        numbers = re.findall(r"r(\d+)", part)
        count += int(numbers[1]) - int(numbers[0]) + 1 if len(numbers) == 2 else 1
    return count


def lowered_by(mnemonic, operands):
    """Bytes by which an instruction lowers the stack pointer."""
    stored = re.match(r"(push|(stmdb|stmfd)\S*(?=\tsp!))", f"{mnemonic}\t{operands}")
    if stored:
        return 4 * register_count(operands[operands.index("{"):])
    written_back = re.search(r"\[sp, #-(\d+)\]!", operands)
    if written_back:
        return int(written_back.group(1))
    if re.match(r"(sub|add)w?(\.w)?$", mnemonic) and operands.startswith("sp,"):
        amount = re.search(r"#(\d+)", operands)
        if amount is None:
            raise UnknownLowering
        return int(amount.group(1)) if mnemonic.startswith("sub") else 0
    return 0


def disassemble(file):
    """The instructions of every function, as (mnemonic, operands), by the function's symbol."""
    functions, current = {}, []
    for line in run(["arm-none-eabi-objdump", "-d", file]).splitlines():
        begins = FUNCTION.match(line)
        if begins:
            current = functions.setdefault(begins.group(1), [])
        instruction = INSTRUCTION.match(line)
        if instruction:
            current.append((instruction.group(1), instruction.group(2) or ""))
    add_other_names(file, functions)
    return functions


def add_other_names(file, functions):
    """The disassembler shows one name of a place; memory functions and constructors have several."""
    for names in same_place(file):
        known = next((name for name in names if name in functions), None)
        for name in names if known else ():
            functions.setdefault(name, functions[known])


def same_place(file):
    """Sets of symbols that stand for one function: the same place in the same section."""
    places = {}
    for line in run(["arm-none-eabi-readelf", "-sW", file]).splitlines():
        fields = line.split()
        is_code = len(fields) == 8 and fields[3] in ("FUNC", "NOTYPE") and fields[6].isdigit()
        if is_code and fields[7][0] != "$":  # $t and $d mark code and data
            places.setdefault((fields[6], int(fields[1], 16) & ~1), set()).add(fields[7])
    return [names for names in places.values() if len(names) > 1]


def stack_lowered(instructions):
    """Bytes at most: whatever a function pushes is added up over its whole body, pops are not looked at."""
    return sum(lowered_by(*instruction) for instruction in instructions)


def goes_on_to(name, instructions):
    """The functions that a function calls or jumps to."""
    found = set()
    for mnemonic, operands in instructions:
        target = TARGET.search(operands)
        if mnemonic.startswith("blx") or mnemonic.startswith("bx") and operands != "lr":
            raise Failure(f"{name} calls through a register")
        if CALL.match(mnemonic) or JUMP.match(mnemonic) and target and target.group(1) != name:
            found.add(target.group(1))
    return found
