"""The committed figures: a flat table from a figure's name to its value."""

import json

from processors import REPOSITORY, RESOURCES, Failure

FILE = RESOURCES / "budget.json"
README = REPOSITORY / "README.md"
BEGIN = "<!-- resource table -->"
END = "<!-- end of resource table -->"
TOLERANCE = 2  # percent


def read():
    try:
        return json.loads(FILE.read_text())
    except FileNotFoundError:
        raise Failure(f"there is no {FILE.name}: write one with --write") from None
    except json.JSONDecodeError as error:
        raise Failure(f"{FILE.name} is damaged: {error}") from None


def write(figures):
    FILE.write_text(json.dumps(figures, indent=1, sort_keys=True) + "\n")


def compare(budget, figures):
    """Lines on what has left the budget, either way, and lines on what has become a little less."""
    faults, hints = [], []
    for name in sorted(budget.keys() | figures.keys()):
        if name not in figures:
            faults.append(f"{name}: in the budget, but not measured")
        elif name not in budget:
            faults.append(f"{name}: {figures[name]}, not in the budget")
        else:
            allowed, value = budget[name], figures[name]
            percent = 100 * (value - allowed) / allowed if allowed else 100
            line = f"{name}: {allowed} -> {value} ({value - allowed:+d}, {percent:+.1f} %, at most {TOLERANCE} %)"
            if 100 * abs(value - allowed) > TOLERANCE * allowed:
                faults.append(line)
            elif value < allowed:
                hints.append(line)
    return faults, hints


def split_readme():
    text = README.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise Failure(f"{README.name} does not hold {BEGIN} and {END} once each, in this order")
    before, rest = text.split(BEGIN)
    between, after = rest.split(END)
    return before, between, after


def readme_has(table):
    return split_readme()[1].strip() == table.strip()


def write_readme(table):
    before, _, after = split_readme()
    README.write_text(f"{before}{BEGIN}\n{table.strip()}\n{END}{after}")
