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


def compile_command(build, source, target, options=()):
    kernel = build.kernel
    return [COMPILER, *FLAGS, *options, f"-mcpu={build.processor.cpu}", f"-DOSEM_NODE_INDEX_BITS={build.index_bits}",
            f"-I{kernel}/include", f"-I{kernel}/src", f"-I{RESOURCES}", "-fcallgraph-info=su,da",
            "-c", source, "-o", target]


def compile_source(build, source, target, options=()):
    target.parent.mkdir(parents=True, exist_ok=True)
    run(compile_command(build, source, target, options))
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


def with_fast_grids(build):
    """The same kernel as the option OSEM_FAST_GRIDS makes it: what converts by grids at -O2."""
    directory = build.directory.with_name(build.directory.name + "-fast-grids")
    shutil.rmtree(directory, ignore_errors=True)
    sources = sorted((build.kernel / "src" / "grid").glob("*.cpp"))
    slow = [build.directory / "kernel" / "grid" / source.with_suffix(".o").name for source in sources]
    if not sources or not set(slow) <= set(build.objects):
        raise Failure("the sources of the conversion by grids are not where they are looked for")
    fast = [compile_source(build, source, directory / "kernel" / "grid" / old.name, ("-O2",))
            for source, old in zip(sources, slow)]
    rest = [path for path in build.objects if path not in slow]
    return build._replace(directory=directory, objects=(*rest, *fast))
