"""The figures as Markdown."""

from flash import ALONE, FAST_GRIDS, FEATURES, TARGETS, WHOLE
from processors import INDEX_BITS, PROCESSORS
from stack_bound import CALLS_BACK, TARGET

FEATURE_TEXTS = {
    "query": "point and box queries",
    "booleans": "and Booleans",
    "conversion": "and conversion",
    "check": "and check",
    "measures": "moments, surface and Euler characteristic",
    "components": "connected components",
    "ray": "rays and segments",
    "stream_query": "point, measures, digest and equality of streams",
    "stream_boolean": "Booleans from stream to stream",
    "nearest": "face neighbours and the nearest leaf",
    "collide": "collision of two trees",
    "grid": "conversion by grids",
    FAST_GRIDS: "the same with `OSEM_FAST_GRIDS`",
    "bintree": "conversion by a bintree",
    "fit": "the finest conversion that fits, and pruning",
    "csg": "expressions over solids, trees and streams",
    "transform": "translation, symmetries, scale, coarsening and crop",
    "slice": "slices as runs and as bitmaps",
    "boundary": "the surface of a solid",
    WHOLE: "the whole kernel",
}
JOB_TEXTS = {
    "check": "check a sphere of 768 triangles",
    "convert": "convert it at 64 x 64 x 64",
    "convert_grid": "convert it by grids",
    "convert_grid_fast": "the same with `OSEM_FAST_GRIDS`",
    "convert_bintree": "convert it by the bintree technique",
    "union": "union of two such trees",
    "point_queries": "1,000 point queries",
    "box_queries": "1,000 box queries",
    "write_stream": "write the tree as a stream",
    "read_stream": "read it back",
    "stream_union": "union of two such streams, in one pass",
    "check_stream": "check one of these streams",
    "checked_stream_union": "the union, both checked before",
    "index_stream": "check one of them, and index its subtrees",
    "stream_queries": "100 point queries in a stream that was checked before",
    "indexed_stream_queries": "the same with its index",
}
ONE_BY_ONE = 100  # bytes; functions with less stack share one row


def row(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table(heads, rows):
    ruler = "|---|" + "---:|" * (len(heads) - 1)
    return "\n".join([row(heads), ruler, *(row(cells) for cells in rows)])


def names(figures, kind):
    """The second parts of the figures' names of a kind."""
    return sorted({name.split("/")[1] for name in figures if name.split("/")[0] == kind})


def missed_targets(figures):
    """What takes more than its target."""
    bounds = {f"flash/{feature}/{name}/{bits}": bound
              for (feature, name), bound in TARGETS.items() for bits in INDEX_BITS}
    bounds |= {name: TARGET for name in figures if name.startswith("stack/")}
    return [f"{name}: {figures[name]} of {bound}" for name, bound in bounds.items() if figures[name] > bound]


def target_cell(figures, feature):
    """The target, and on which processor it is missed."""
    targets = {name: bound for (of, name), bound in TARGETS.items() if of == feature}
    if not targets:
        return ""
    missed = [name for name, bound in targets.items()
              if any(figures[f"flash/{feature}/{name}/{bits}"] > bound for bits in INDEX_BITS)]
    where = " and ".join(targets)
    verdict = f"**missed on {' and '.join(missed)}**" if missed else "met"
    return f"{min(targets.values())} on {where}: {verdict}"


def flash_table(figures):
    heads = ["a program with"]
    heads += [f"{processor.name}, {bits}-bit" for processor in PROCESSORS for bits in INDEX_BITS]
    heads += [f"helpers, {processor.name}" for processor in PROCESSORS] + ["target"]
    rows = []
    after_grid = ALONE.index("grid") + 1
    for feature in (*FEATURES, *ALONE[:after_grid], FAST_GRIDS, *ALONE[after_grid:], WHOLE):
        cells = [FEATURE_TEXTS[feature]]
        cells += [figures[f"flash/{feature}/{processor.name}/{bits}"]
                  for processor in PROCESSORS for bits in INDEX_BITS]
        cells += [max(figures[f"helpers/{feature}/{processor.name}/{bits}"] for bits in INDEX_BITS)
                  for processor in PROCESSORS]
        rows.append([*cells, target_cell(figures, feature)])
    return table(heads, rows)


def stack_of(figures, name):
    kinds = ("stack", "painted")
    return [figures[f"{kind}/{name}/{processor.name}"] for processor in PROCESSORS for kind in kinds]


def stack_table(figures):
    heads = ["function"]
    for processor in PROCESSORS:
        heads += [f"{processor.name}, bound", f"{processor.name}, measured"]
    stacks = {name: stack_of(figures, name) for name in names(figures, "stack")}
    order = sorted(stacks, key=lambda name: -stacks[name][0])
    large = [name for name in order if max(stacks[name]) >= ONE_BY_ONE]
    rows = [[f"`{name}`" + (f" (and {CALLS_BACK[name]})" if name in CALLS_BACK else ""), *stacks[name]]
            for name in large]
    small = [stacks[name] for name in order if name not in large]
    rows.append([f"each of the other {len(small)}, at most", *(max(column) for column in zip(*small))])
    return table(heads, rows)


def count_table(figures):
    heads = ["job", *(processor.name for processor in PROCESSORS)]
    rows = [[JOB_TEXTS[job], *(f"{figures[f'count/{job}/{processor.name}']:,}" for processor in PROCESSORS)]
            for job in JOB_TEXTS]
    return table(heads, rows)


def ram_table(figures):
    def size(name):
        return [figures[f"ram/{name}/{bits}"] for bits in INDEX_BITS]

    def held(name):
        initial = figures.get(f"initial/{name}/{INDEX_BITS[0]}", 0) != 0
        return [f"`{name}`{' *' if initial else ''}", *size(name)]

    pools = [f"{own} + {node} n" for own, node in zip(size("NodePool"), size("Node"))]
    rows = [["a pool of n nodes", *pools],
            ["`check`: scratch for c corners", *(f"{edge} c" for edge in size("Edge"))],
            ["`Conversion`: scratch for f faces", "4 f", "4 f"],
            ["`Boundary`: scratch for c corners", *(f"{corner} c" for corner in size("BoundaryCorner"))],
            ["`compact`: scratch for n nodes in use", "4 ceil(n / 32)", "4 ceil(n / 32)"]]
    types = [name for name in names(figures, "ram") if name not in ("Node", "NodePool", "Edge", "BoundaryCorner")]
    rows += [held(name) for name in sorted(types, key=lambda name: -size(name)[0])]
    return table(["what", *(f"{bits}-bit indices" for bits in INDEX_BITS)], rows)


def image_table(figures):
    kinds = ("flash", "variables", "stack")
    return table(["image", "flash", "static variables", "stack kept free"],
                 [[name, *(figures[f"image/{name}/{kind}"] for kind in kinds)]
                  for name in names(figures, "image")])


def greatest_stack(figures):
    bounds = [name for name in figures if name.startswith("stack/")]
    greatest = max(bounds, key=figures.get)
    name, bound = greatest.split("/")[1], figures[greatest]
    verdict = f"under the target of {TARGET}" if bound <= TARGET else f"**over the target of {TARGET}**"
    return f"The greatest is that of `{name}` with {bound}, {verdict}"


def greatest_fast_stack(figures):
    return max(value for name, value in figures.items() if name.startswith("fast_grids_stack/"))


FLASH_TEXT = """\
Flash, in bytes of code and constants at `-Os`; a row that begins with "and" includes those above it, another one
stands for a program of nothing else. Helpers are what comes beside it from the compiler's library and newlib's
small C library: 64-bit arithmetic, `memcpy`, `memset`; targets are for the kernel's own code, without them."""
STACK_TEXT = """\
Worst-case stack, in bytes, a function's own saved registers included. The bound is the longest path in the call
graph, helpers included; measured is what painting the stack shows; both with 32-bit indices. {greatest};
with `OSEM_FAST_GRIDS`, to which the target does not apply, the greatest bound is {fast}."""
COUNT_TEXT = """\
Instructions, counted by QEMU in steps of 40, with 32-bit indices. (The M0's code runs on the model of a
Cortex-M3, whose memory is large enough.)"""
RAM_TEXT = """\
RAM, in bytes, the same on both processors. A type with a star does not begin with zeros alone: a static object of
it takes as many bytes of flash besides, unless it is made at run time."""
IMAGE_TEXT = "The example firmware, whole images in bytes (Cortex-M0, 16-bit indices)."


def document(figures):
    parts = [FLASH_TEXT, flash_table(figures),
             STACK_TEXT.format(greatest=greatest_stack(figures), fast=greatest_fast_stack(figures)), stack_table(figures),
             COUNT_TEXT, count_table(figures),
             RAM_TEXT, ram_table(figures)]
    if names(figures, "image"):
        parts += [IMAGE_TEXT, image_table(figures)]
    return "\n\n".join(parts) + "\n"
