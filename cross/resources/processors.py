"""What is measured, how it is compiled, and how tools are run."""

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

RESOURCES = Path(__file__).resolve().parent
REPOSITORY = RESOURCES.parent.parent


class Failure(Exception):
    """Whatever keeps the figures from being right; its text is the one line that is reported."""


class Processor(NamedTuple):
    name: str
    cpu: str
    machine: str  # of QEMU
    libraries: str  # the compiler's directory of libraries for it


# The 16 KB of a micro:bit cannot hold the trees of the jobs. ARMv6-M code is a subset of ARMv7-M code, so the
# Cortex-M0 build runs on the MPS2 board with a Cortex-M3 and 4 MB.
PROCESSORS = (
    Processor("M0", "cortex-m0", "mps2-an385", "thumb/v6-m/nofp"),
    Processor("M4", "cortex-m4", "mps2-an386", "thumb/v7e-m/nofp"),
)
INDEX_BITS = (32, 16)
CONFIGURATIONS = tuple((processor, bits) for processor in PROCESSORS for bits in INDEX_BITS)

NAMES_A_FAULT = re.compile(r"(?<!collect2: )\berror\b|undefined reference|wrong result", re.IGNORECASE)

COMPILER = "arm-none-eabi-g++"

# Those of check_freestanding.sh; a function a section, so that the linker can leave out what is not called.
FLAGS = (
    "-std=c++17 -mthumb -Os -ffreestanding -fno-exceptions -fno-rtti -nostdlib -fno-threadsafe-statics "
    "-ffunction-sections -fdata-sections -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror"
).split()


def run(command, **options):
    """Runs a tool; what it wrote to its standard output."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    except FileNotFoundError:
        raise Failure(f"{words[0]} is not installed") from None
    except subprocess.TimeoutExpired as expired:
        raise Failure(f"{words[0]} took longer than {expired.timeout} s: {' '.join(words)}") from None
    if done.returncode != 0:
        # The line that names what is wrong, wherever the tool wrote it; else its last line.
        lines = (done.stderr + done.stdout).strip().splitlines() or ["no message"]
        reason = next((line for line in lines if NAMES_A_FAULT.search(line)), lines[-1])
        raise Failure(f"{words[0]} failed with exit code {done.returncode}: {reason.strip()}")
    return done.stdout
