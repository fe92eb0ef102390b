"""Compiles each source of the kernel for one processor and index width, with its call graph."""

import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from processors import COMPILER, FLAGS, RESOURCES, Failure, Processor, run


class Build(NamedTuple):
    processor: Processor
    index_bits: int
    kernel: Path  # the kernel's folder
    directory: Path
    objects: tuple  # one a source, with GCC's call graph (.ci) beside it


def compile_command(build, source, target):
    kernel = build.kernel
    return [COMPILER, *FLAGS, f"-mcpu={build.processor.cpu}", f"-DOSEM_NODE_INDEX_BITS={build.index_bits}",
            f"-I{kernel}/include", f"-I{kernel}/src", f"-I{RESOURCES}", "-fcallgraph-info=su,da",
            "-c", source, "-o", target]


def compile_source(build, source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    run(compile_command(build, source, target))
    return target


def build_kernel(kernel, processor, index_bits, directory):
    directory = directory / f"{processor.name}-{index_bits}"
    shutil.rmtree(directory, ignore_errors=True)  # a source that is gone leaves nothing behind
    sources = sorted((kernel / "src").rglob("*.cpp"))
    if not sources:
        raise Failure(f"there are no sources in {kernel}/src")
    build = Build(processor, index_bits, kernel, directory, ())
    targets = [directory / "kernel" / source.relative_to(kernel / "src").with_suffix(".o")
               for source in sources]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = tuple(pool.map(lambda pair: compile_source(build, *pair), zip(sources, targets)))
    return build._replace(objects=objects)
