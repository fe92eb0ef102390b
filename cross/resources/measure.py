#!/usr/bin/env python3
"""Measures flash, stack, instructions and RAM of the kernel on Cortex-M0 and Cortex-M4, and prints the table.

--check compares with the committed budget.json and the README: 2 % more or less of anything, a missed target, a figure that is new or
gone, or a README with another table fails with exit code 1. --write sets both to what was measured.
Needs arm-none-eabi-g++ with newlib, qemu-system-arm and CMake."""

import argparse
import sys
from pathlib import Path

sys.dont_write_bytecode = True

import budget
import flash
import images
import ram
import stack_bound
import tables
from kernel_build import build_kernel, with_fast_grids
from processors import CONFIGURATIONS, INDEX_BITS, PROCESSORS, REPOSITORY, Failure


def add_same(figures, more):
    """What is measured twice must agree."""
    for name, value in more.items():
        if figures.setdefault(name, value) != value:
            raise Failure(f"{name} is {figures[name]} on one processor and {value} on another")


def measure_code(directory):
    """Flash, sizes and stack bounds; those of the default index width are reported."""
    figures, bounds, on_top = {}, {}, {}
    for processor, bits in CONFIGURATIONS:
        build = build_kernel(REPOSITORY / "kernel", processor, bits, directory)
        whole_image = flash.link_whole_kernel(build)
        figures.update(flash.figures(build, whole_image))
        add_same(figures, ram.sizes(build))
        fast_grids = with_fast_grids(build)
        figures.update(flash.fast_figures(fast_grids))
        found, more = stack_bound.bounds(build, whole_image)
        if bits == INDEX_BITS[0]:
            bounds[processor] = found
            on_top[processor] = more
            fast, _ = stack_bound.bounds(fast_grids, flash.link_whole_kernel(fast_grids))
            figures[f"fast_grids_stack/greatest/{processor.name}"] = max(fast.values())
    return figures, bounds, on_top


def measure_runs(directory, bounds, on_top):
    figures = {}
    for processor in PROCESSORS:
        programs = images.build_images(processor, directory)
        measured = images.painted(processor, programs)
        images.check_painted(processor, bounds[processor], on_top[processor], measured)
        for name, bound in bounds[processor].items():
            figures[f"stack/{name}/{processor.name}"] = bound
            figures[f"painted/{name}/{processor.name}"] = measured[name]
        counts = images.counts(processor, programs)
        fast_grids = images.counts(processor, images.build_fast_grids(processor, directory))
        counts["convert_grid_fast"] = fast_grids["convert_grid"]
        for name, count in counts.items():
            figures[f"count/{name}/{processor.name}"] = count
    return figures


def measure(options):
    figures, bounds, on_top = measure_code(options.build)
    figures.update(measure_runs(options.build, bounds, on_top))
    for name, image in options.image:
        figures.update(ram.image_figures(name, image))
    return figures


def check(figures):
    """Prints each difference; whether there is none that matters."""
    allowed = budget.read()
    faults, hints = budget.compare(allowed, figures)
    faults += [f"a target is missed: {line}" for line in tables.missed_targets(figures)]
    if allowed.keys() == figures.keys() and not budget.readme_has(tables.document(allowed)):
        faults.append("README.md: its table is not that of the budget; --write sets both")
    for line in hints:
        print(f"resources: less than the budget, which may be lowered: {line}")
    for line in faults:
        print(f"resources: {line}", file=sys.stderr)
    return not faults


def named_image(text):
    name, separator, path = text.partition("=")
    if not separator or "/" in name:
        raise argparse.ArgumentTypeError("NAME=PATH is wanted")
    return name, Path(path)


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=REPOSITORY / "build" / "resources", metavar="DIR")
    parser.add_argument("--image", type=named_image, action="append", default=[], metavar="NAME=PATH",
                        help="an image whose flash, variables and stack are listed, too")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="compare with budget.json and the README")
    what.add_argument("--write", action="store_true", help="rewrite budget.json and the README's table")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    options.build = options.build.resolve()
    try:
        figures = measure(options)
        print(tables.document(figures))
        if options.write:
            budget.write_readme(tables.document(figures))
            budget.write(figures)
        return 1 if options.check and not check(figures) else 0
    except Failure as failure:
        print(f"resources: {failure}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
