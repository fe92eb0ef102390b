"""Flash a feature takes: links a program of each feature and reads the linker's map."""

import re

from kernel_build import compile_source
from processors import COMPILER, RESOURCES, Failure, run

# Each program has its own functions and those of the features before it.
FEATURES = ("query", "booleans", "conversion", "check")
# Each program has its own functions only.
ALONE = ("stream_query", "stream_boolean", "ray", "nearest", "collide", "measures", "components", "grid", "bintree",
         "fit", "csg", "transform", "slice", "boundary")
# "grid" once more, of a kernel with OSEM_FAST_GRIDS.
FAST_GRIDS = "grid_fast"
WHOLE = "all"  # every function of the kernel

# Bytes of the kernel's own flash that a program may take on any processor, or on the one named.
TARGETS = {("query", "M0"): 1536, ("query", "M4"): 1536, ("conversion", "M4"): 6144}

IN_FLASH = (".text", ".rodata", ".data", ".init_array", ".ARM.ex")
PLACED = re.compile(r"^ (\.\S+)\s+0x[0-9a-f]+\s+(0x[0-9a-f]+)\s+(\S+)$", re.MULTILINE)


def link(build, name, objects, options):
    """Links against the compiler's helpers and newlib's small memory functions, without start-up code."""
    image = build.directory / f"{name}.elf"
    run([COMPILER, f"-mcpu={build.processor.cpu}", "-mthumb", "-nostdlib", "-Wl,--gc-sections",
         *options, f"-Wl,-Map={image}.map", *objects,
         "-Wl,--start-group", "-lgcc", "-lc_nano", "-Wl,--end-group", "-o", image])
    return image


def root_options(names):
    roots = [f"{name}_roots" for name in names]
    return [f"-Wl,--entry={roots[0]}", *(f"-Wl,--undefined={root}" for root in roots)]


def bytes_by_owner(build, image):
    """Bytes in flash of the kernel and of the helpers; the program's own table is left out."""
    text = image.with_name(image.name + ".map").read_text()
    placed = text.split("Linker script and memory map", 1)[-1]
    sums = {"kernel": 0, "helpers": 0}
    kernel_objects = {str(path) for path in build.objects}
    for section, size, origin in PLACED.findall(placed):
        if not section.startswith(IN_FLASH):
            continue
        if origin in kernel_objects:
            sums["kernel"] += int(size, 16)
        elif ".a(" in origin:
            sums["helpers"] += int(size, 16)
    if sums["kernel"] == 0:
        raise Failure(f"{image.name}: the linker's map names nothing of the kernel")
    return sums


def link_whole_kernel(build):
    """An image of every function of the kernel and every helper it calls."""
    return link(build, WHOLE, build.objects, ["-Wl,--no-gc-sections", "-Wl,--entry=0"])


def alone(build, feature):
    """An image of one feature's functions."""
    program = compile_source(build, RESOURCES / "features" / f"{feature}.cpp",
                             build.directory / "features" / f"{feature}.o")
    return link(build, feature, [*build.objects, program], root_options([feature]))


def figures(build, whole_image):
    """Names and bytes, as 'flash/FEATURE/PROCESSOR/WIDTH' and 'helpers/...'."""
    return named_figures(build, images_of(build, whole_image))


def fast_figures(build):
    """The same of the conversion by grids, of a kernel with OSEM_FAST_GRIDS."""
    return named_figures(build, {FAST_GRIDS: alone(build, "grid")})


def images_of(build, whole_image):
    images = {feature: alone(build, feature) for feature in ALONE}
    for feature in FEATURES:
        names = FEATURES[: FEATURES.index(feature) + 1]
        programs = [compile_source(build, RESOURCES / "features" / f"{name}.cpp",
                                   build.directory / "features" / f"{name}.o") for name in names]
        # The kernel comes first: an inline function that both hold is then the kernel's.
        images[feature] = link(build, feature, [*build.objects, *programs], root_options(names))
    images[WHOLE] = whole_image
    return images


def named_figures(build, images):
    found = {}
    for feature, image in images.items():
        where = f"{feature}/{build.processor.name}/{build.index_bits}"
        sums = bytes_by_owner(build, image)
        found[f"flash/{where}"] = sums["kernel"]
        found[f"helpers/{where}"] = sums["helpers"]
    return found
