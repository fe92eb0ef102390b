"""Builds the programs for the bare-metal boards and runs them in QEMU."""

import os
import re
from subprocess import DEVNULL

from processors import REPOSITORY, Failure, run

STACK = re.compile(r"^stack osem::(\S+) (\d+)$", re.MULTILINE)
COUNT = re.compile(r"^count (\S+) (\d+)$", re.MULTILINE)
TIMEOUT = 600  # seconds; a run takes a few


def build(processor, directory, targets, *options):
    """Builds as the kernel is built for the bounds: MinSizeRel is -Os."""
    run(["cmake", "-S", REPOSITORY, "-B", directory, "-DCMAKE_BUILD_TYPE=MinSizeRel",
         f"-DCMAKE_TOOLCHAIN_FILE={REPOSITORY}/cross/toolchains/{processor.cpu}.cmake",
         "-DOSEM_BUILD_CROSS=ON", "-DOSEM_BUILD_TOOL=OFF", "-DOSEM_BUILD_TESTS=OFF", *options])
    run(["cmake", "--build", directory, f"-j{os.cpu_count()}", "--target", *targets])
    return directory / "cross" / "resources"


def build_images(processor, directory):
    return build(processor, directory / f"images-{processor.name}", ("osem_stack_paint", "osem_jobs"))


def build_fast_grids(processor, directory):
    """The jobs once more, with the conversion by grids compiled for speed."""
    return build(processor, directory / f"images-{processor.name}-fast-grids", ("osem_jobs",),
                 "-DOSEM_FAST_GRIDS=ON")


def run_image(processor, image):
    """One instruction is one nanosecond of the virtual clock."""
    return run(["qemu-system-arm", "-M", processor.machine, "-nographic", "-icount", "shift=0",
                "-semihosting-config", "enable=on,target=native", "-kernel", image],
               timeout=TIMEOUT, stdin=DEVNULL)


def painted(processor, directory):
    """Bytes of stack by public function; the most where a function was measured more than once."""
    found = {}
    for name, size in STACK.findall(run_image(processor, directory / "osem_stack_paint")):
        found[name] = max(int(size), found.get(name, 0))
    return found


def counts(processor, directory):
    """Instructions by job; the same in every run."""
    outputs = [run_image(processor, directory / "osem_jobs") for _ in range(2)]
    if outputs[0] != outputs[1]:
        raise Failure(f"two runs of the jobs for the {processor.cpu} counted differently")
    found = {name: int(count) for name, count in COUNT.findall(outputs[0])}
    if not found:
        raise Failure(f"the jobs for the {processor.cpu} printed no counts")
    return found


def check_painted(processor, bounds, on_top, measured):
    """A painted stack above its bound, and what comes on top, means that the bound is wrong."""
    for name in sorted(bounds.keys() | measured.keys()):
        if name not in measured:
            raise Failure(f"the stack of {name} is not measured by cross/resources/paint")
        if name not in bounds:
            raise Failure(f"cross/resources/paint measures {name}, which is no public function")
        if measured[name] > bounds[name] + on_top.get(name, 0):
            raise Failure(f"{name} took {measured[name]} bytes of stack on the {processor.cpu}, "
                          f"over its bound of {bounds[name]}")
