"""Turns Google Benchmark's JSON into tables with ratios, a list of targets and a plot.

usage: report.py RESULTS.json OUT    writes OUT.md, OUT.json and OUT.png
"""
import json
import sys

from measurements import Measurements
from plots import draw
from targets import judged

METHODS = {
    "convert": ["scan-runs", "scan-bits", "scan-simple", "osem-centre", "osem-three", "plain-centre",
                "plain-three", "vdb-fill"],
    "threads": ["threads-1", "threads-2", "threads-4", "threads-8"],
    "union": ["runs", "osem-pool", "osem-stream", "osem-stream-checked", "osem-stream-indexed", "osem-pool-three",
              "osem-stream-three", "vdb-topology", "vdb-csg", "cgal"],
}
METHODS["intersection"] = METHODS["difference"] = METHODS["union"]
FLOOR = {"convert": "scan-runs", "threads": "threads-1", "union": "runs", "intersection": "runs", "difference": "runs"}
TITLES = {
    "convert": "Conversion",
    "threads": "Conversion on several threads, by the clock",
    "union": "Union",
    "intersection": "Intersection",
    "difference": "Difference",
}


EXPLANATION = """Milliseconds of one thread's processor time, the least of the repetitions; in brackets how many times those of the
floor, which is the exact scanline (runs), or one thread's where there are several: below 1 is faster. Osem's conversions write into a pool of the
right size, which a counting pass has found that is not timed; several threads are timed by the clock, with all that the
tool does but reading and writing files. What others make is freed while the clock stands. Booleans leave out what makes the
operands.

- `osem-centre`, `osem-three`: octrees by grids, centre leaves or three-valued ones; `plain-*`: octant by octant. `osem-pool`,
  `osem-stream`: Booleans of these in a pool, and from stream to stream; `osem-stream-checked`: of
  streams that were checked before; `osem-stream-indexed`: of such ones with an index of their subtrees.
- `scan-runs`, `scan-bits`: the scanline's rows of runs, and a bit a cell of them; `runs`: their Booleans. It has been made fast;
  `scan-simple` is what one writes first, to the same runs: each row of a triangle's bounding box against its three edges, a division
  a crossing.
- `vdb-fill`: OpenVDB's meshToVolume and interior mask; `vdb-topology`: Booleans of masks of the exact cells; `vdb-csg`: of level
  sets; `cgal`: corefinement of the meshes.

A cell is inside where the exact winding number of its centre is not 0. Centres on the surface count by where the centre lies when
it is moved by (e, e^2, e^3) for an infinitesimal e: Osem and the scanline alike. "Cells that differ" from these are others'.
Faces of the bracket have holes: Osem converts them as they are, all others get them cut into triangles.
Bytes of result: the pool's nodes (for `osem-pool` those added to the operands', which are shared), runs, bits or OpenVDB's grids.
Bytes of memory: the same with operands, job and scratch as allocated, without the solid, without what OpenVDB and CGAL take on the way.
A node in a Boolean's cost is one of the operands.
"""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def three_digits(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def ratios(found, theme):
    """A row a solid and grid, a column a method: milliseconds, and how many times the floor's they are."""
    methods = [m for m in METHODS[theme] if found.has_method(theme, m)]
    rows = []
    for solid, cells in found.subjects(theme):
        floor = found.get(theme, solid, cells, FLOOR[theme])
        row = [f"{solid}, {cells}"]
        for method in methods:
            one = found.get(theme, solid, cells, method)
            text = "" if one is None else three_digits(one.ms)
            if one is not None and floor is not None and method != FLOOR[theme]:
                text += f" ({three_digits(one.ms / floor.ms)}x)"
            row.append(text)
        rows.append(row)
    return table(["solid, cells along an axis"] + methods, rows)


def per(one, counter):
    count = one.counters.get(counter, 0)
    return f"{one.ms * 1e6 / count:.1f}" if count else ""


def details(found, theme, columns):
    """A row a measurement: what a unit of work costs, and bytes."""
    rows = []
    for solid, cells in found.subjects(theme):
        for method in METHODS[theme]:
            one = found.get(theme, solid, cells, method)
            if one is None:
                continue
            row = [f"{solid}, {cells}, {method}"]
            row += [per(one, counter) for counter in columns]
            row += [f"{int(one.counters[key])}" if key in one.counters else ""
                    for key in ("result_bytes", "memory_bytes", "cells", "cells_off")]
            rows.append(row)
    head = ["solid, cells, method"] + ["ns per " + counter[:-1].replace("_", " ") for counter in columns]
    return table(head + ["bytes of result", "bytes of memory", "cells inside", "cells that differ"], rows)


def report(found):
    parts = ["# Osem measured\n", found.context() + "\n"]
    parts += [EXPLANATION]
    for theme, title in TITLES.items():
        if not found.subjects(theme):
            continue
        columns = ["octants", "boundary_cells"] if theme == "convert" else ["nodes"]
        parts += [f"## {title}\n", ratios(found, theme)]
        if theme != "threads":
            parts += [details(found, theme, columns)]
    parts += ["## Targets\n", table(["target", "limit", "measured", ""], judged(found))]
    return "\n".join(parts)


def main():
    results, out = sys.argv[1:3]
    with open(results, encoding="utf-8") as file:
        found = Measurements(json.load(file))
    with open(out + ".md", "w", encoding="utf-8") as file:
        file.write(report(found))
    with open(out + ".json", "w", encoding="utf-8") as file:
        json.dump({"measurements": found.as_list(), "targets": judged(found)}, file, indent=1)
    draw(found, out + ".png")


if __name__ == "__main__":
    main()
