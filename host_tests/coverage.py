#!/usr/bin/env python3
"""Reports what tests reached of kernel/ from a profile of Clang 19: lines, branches, conditions by MC/DC.

    coverage.py [--check] ROOT PROFILE PROGRAM

A template or inline function that stands in the program several times counts once: a line, a branch's outcome or a
condition is covered if it is so in any of its instances. What the compiler decides counts for nothing, and neither do
contract checks (OSEM_ASSERT), which are code in a build with sanitizers alone and whose other side is a trap.

Code that no test can reach says so, and why:

    // unreachable: ARGUMENT

behind a line it speaks of that line, on lines of its own of the next one and of what is indented under it.
With --check, what is neither covered nor marked fails, and so does a mark on what is covered.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

MARK = re.compile(r"//\s*unreachable: \S")

Outcome = collections.namedtuple("Outcome", "kind line column text covered")


LINE = re.compile(r" *(\d+)\| *([\d.]+[kMGTPEZY]?)\|")
CONDITION = re.compile(r" *\| +Condition C(\d+) --> \((\d+):(\d+)\)")
PAIR = re.compile(r" *\| +C(\d+)-Pair: (constant folded|covered|not covered)")


def llvm_cov(command, profile, program, sources, *options):
    command = ["llvm-cov-19", command, f"--instr-profile={profile}", *options, program, *sources]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def lines_and_decisions(listing):
    """Of an annotated source: which lines were run, and which conditions decide alone."""
    lines, decisions, places = {}, {}, {}
    for text in listing.splitlines():
        if match := LINE.match(text):
            lines[int(match[1])] = match[2] != "0"
        elif "MC/DC Decision Region" in text:
            places = {}
        elif match := CONDITION.match(text):
            places[match[1]] = (int(match[2]), int(match[3]))
        elif (match := PAIR.match(text)) and match[2] != "constant folded":
            place = places[match[1]]
            decisions[place] = decisions.get(place, False) or match[2] == "covered"
    return lines, decisions


def branches_of(functions):
    """Of each file, the places of conditions and whether each was ever true and ever false."""
    branches = collections.defaultdict(dict)
    for function in functions:
        for first, start, last, end, true, false, file_id, *_ in function["branches"]:
            found = branches[function["filenames"][file_id]].setdefault((first, start, last, end), [False, False])
            found[0] |= true > 0
            found[1] |= false > 0
    return branches


def text_of(source, first, start, last, end):
    lines = source[first - 1:last]
    lines[-1] = lines[-1][:end - 1]
    lines[0] = lines[0][start - 1:]
    return " ".join(" ".join(lines).split())


def outcomes_of(source, listing, branches):
    """All that a file is measured by."""
    lines, decisions = lines_and_decisions(listing)
    texts = {}
    for line, run in lines.items():
        yield Outcome("line", line, 1, "never run", run)
    checks = {number for number, line in enumerate(source, 1) if "OSEM_ASSERT(" in line}
    for place, found in branches.items():
        if place[0] in checks:
            continue
        texts[place[:2]] = min(text_of(source, *place), texts.get(place[:2], " " * 1000), key=len)
        for was, value in zip(found, ("true", "false")):
            yield Outcome("branch", *place[:2], f"`{text_of(source, *place)}` is never {value}", was)
    for place, shown in decisions.items():
        if place[0] in checks:
            continue
        yield Outcome("MC/DC", *place, f"`{texts[place]}` never decides alone", shown)


def marked_lines(lines):
    """The lines that each mark speaks of, by the mark's line."""
    marks = {}
    for number, line in enumerate(lines, 1):
        if not MARK.search(line):
            continue
        if not line.lstrip().startswith("//"):
            marks[number] = {number}
            continue
        first = number + 1
        while lines[first - 1].lstrip().startswith("//"):
            first += 1
        indentation = len(lines[first - 1]) - len(lines[first - 1].lstrip())
        last = first
        while last < len(lines) and (not lines[last].strip() or lines[last].startswith(" " * (indentation + 1))):
            last += 1
        marks[number] = set(range(first, last + 1))
        if last < len(lines) and lines[last].strip() == "}":
            marks[number].add(last + 1)
    return marks


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true", help="fail if something is neither covered nor marked")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("profile")
    parser.add_argument("program")
    options = parser.parse_args()

    sources = sorted(p for p in (options.root / "kernel").rglob("*") if p.suffix in (".cpp", ".hpp"))
    lines_of = {str(p): p.read_text().splitlines() for p in sources}
    measured = (options.profile, options.program)
    exported = json.loads(llvm_cov("export", *measured, lines_of))["data"][0]
    branches = branches_of(exported["functions"])

    kinds = ("line", "branch", "MC/DC")
    totals = {kind: [0, 0, 0] for kind in kinds}
    open_places, marked_places, faults = [], [], []
    print(f"{'file':<36}{'lines':>14}{'branches':>14}{'MC/DC':>14}{'marked':>8}")
    for path in map(str, sources):
        name = path[len(str(options.root)) + 1:]
        marks = marked_lines(lines_of[path])
        used = set()
        counts = {kind: [0, 0, 0] for kind in kinds}  # covered, marked, all
        listing = llvm_cov("show", *measured, [path], "--show-mcdc", "--show-instantiations=false")
        for outcome in sorted(outcomes_of(lines_of[path], listing, branches[path]), key=lambda o: o[1:3]):
            mark = next((m for m, covered in marks.items() if outcome.line in covered), None)
            count = counts[outcome.kind]
            count[2] += 1
            if outcome.covered:
                count[0] += 1
                continue
            if mark is None:
                open_places.append((name, outcome))
            else:
                used.add(mark)
                count[1] += 1
                marked_places.append((name, outcome))
        faults += [(name, Outcome("mark", mark, 1, "all is covered", False)) for mark in marks if mark not in used]
        if path.endswith(".cpp") and counts["line"][2] == 0:
            faults.append((name, Outcome("file", 1, 1, "not in the program", False)))
        for kind in kinds:
            totals[kind] = [a + b for a, b in zip(totals[kind], counts[kind])]
        print_row(name[len("kernel/"):], counts)
    print_row("all", totals)
    print_places("marked unreachable", marked_places)
    print_places("not covered", open_places)
    print_places("faults", faults)
    if options.check and (open_places or faults):
        sys.exit(1)


def print_places(title, places):
    """Lines one behind the other are one place."""
    rows = []
    for name, outcome in places:
        before = rows[-1] if rows else ["", 0, 0, outcome]
        if outcome.kind == before[3].kind == "line" and (before[0], before[2] + 1) == (name, outcome.line):
            before[2] = outcome.line
        else:
            rows.append([name, outcome.line, outcome.line, outcome])
    if rows:
        print(f"\n{title}: {len(places)}")
    for name, first, last, outcome in rows:
        lines = f"{first}-{last}" if last > first else f"{first}:{outcome.column}"
        print(f"{name}:{lines}: {outcome.kind}: {outcome.text}")


def print_row(name, counts):
    if not any(count[2] for count in counts.values()):
        return
    cells = "".join(f"{f'{count[0]}/{count[2]}' if count[2] else '-':>14}" for count in counts.values())
    marked = sum(count[1] for count in counts.values())
    print(f"{name:<36}{cells}{marked or '':>8}")


if __name__ == "__main__":
    main()
