"""RAM: the sizes of what a program holds, and the variables and stack of whole images."""

import re

from kernel_build import compile_source
from processors import RESOURCES, Failure, run

SIZE = "size_of_"
OBJECT = "object_of_"


def sizes(build):
    """Bytes of each type, as 'ram/TYPE/WIDTH', and of a static object's initial values in flash, as 'initial/...'."""
    compiled = compile_source(build, RESOURCES / "sizes.cpp", build.directory / "sizes.o")
    listed = run(["arm-none-eabi-nm", "-S", compiled])
    found = {}
    for size, kind, name in re.findall(r"^\S+ ([0-9a-f]+) (\w) (\w+)$", listed, re.MULTILINE):
        if name.startswith(SIZE):
            found[f"ram/{name.removeprefix(SIZE)}/{build.index_bits}"] = int(size, 16)
        elif name.startswith(OBJECT):
            zeros = kind in "Bb"
            found[f"initial/{name.removeprefix(OBJECT)}/{build.index_bits}"] = 0 if zeros else int(size, 16)
    return found


def symbol(image, name):
    found = re.search(rf"^([0-9a-f]+) \w {name}$", run(["arm-none-eabi-nm", image]), re.MULTILINE)
    if found is None:
        raise Failure(f"{image} has no symbol {name}")
    return int(found.group(1), 16)


def image_figures(name, image):
    """Flash, variables and the stack that the linker keeps free for it, as 'image/NAME/...'."""
    text, data, bss = (int(field) for field in run(["arm-none-eabi-size", image]).splitlines()[1].split()[:3])
    return {f"image/{name}/flash": text + data, f"image/{name}/variables": data + bss,
            f"image/{name}/stack": symbol(image, "stack_size")}
