#!/usr/bin/env python3
"""Shows that the kernel's tests see small bugs: plants those of mutations.py, one at a time, and runs the tests.

    mutate.py [--only EXPRESSION] [--jobs N] [--build DIR]

The kernel and its tests are copied first, and compiled there. A bug is planted in one more copy of its file, which is
compiled in the file's place; what includes it is compiled anew, and all else is linked as it is. The tests of the bug's
own subject run first, up to the first failure. Prints which test saw each bug. Fails if one was not seen, or if the text
to be changed does not stand in its file exactly once.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

from mutations import MUTATIONS, SUITES

PROJECT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("kernel", "host_tests/kernel", "host_tests/support")
FLAGS = ["-std=c++17", "-O1", "-DOSEM_FAST_CRC=1"]
LIBRARIES = ["-lgtest_main", "-lgtest", "-pthread"]
COMPILER = os.environ.get("CXX", "g++").split()
MOST_TIMES = 2  # what the tests may take with a bug of what they take without: else they have no end
MEMORY = 2 << 30  # bytes, for bugs that fill it


def copy_tree(tree):
    """With the files' times, so that what is compiled already stays so."""
    for folder in FOLDERS:
        shutil.rmtree(tree / folder, ignore_errors=True)
        shutil.copytree(PROJECT / folder, tree / folder)


def sources(tree):
    cmake = (tree / "host_tests/kernel/CMakeLists.txt").read_text()
    names = re.search(r"add_executable\(osem_kernel_tests([^)]*)\)", cmake)[1].split()
    tests = [(tree / "host_tests/kernel" / name).resolve() for name in names]
    return sorted((tree / "kernel").rglob("*.cpp")) + tests


def dependencies(target):
    text = pathlib.Path(f"{target}.d").read_text().replace("\\\n", " ").split(":", 1)[1]
    return {os.path.abspath(name) for name in text.split()}


def is_current(target):
    if not target.exists() or not pathlib.Path(f"{target}.d").exists():
        return False
    made = target.stat().st_mtime
    return all(os.path.exists(name) and os.path.getmtime(name) <= made for name in dependencies(target))


class Program:
    """The kernel and its tests as they are, one object a file."""

    def __init__(self, build, pool):
        self.build = build
        self.tree = build / "tree"
        copy_tree(self.tree)
        self.objects = {s: build / "objects" / f"{s.relative_to(self.tree)}.o" for s in sources(self.tree)}
        stale = [(s, t) for s, t in self.objects.items() if not is_current(t)]
        for error in pool.map(lambda item: self.compile(*item), stale):
            if error:
                sys.exit(error)
        self.depends = {source: dependencies(target) for source, target in self.objects.items()}

    def check(self):
        """What is wrong before anything is planted. Measures how long the tests take."""
        error = self.link(self.build / "tests")
        began = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        failed = error or run_tests(self.build / "tests", "*")
        self.seconds = 10 + int(MOST_TIMES * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - began))
        return error or (f"{failed} fails before anything is planted" if failed else None)

    def compile(self, source, target, *first_includes):
        """The error, if there is one. What the object depends on is noted beside it."""
        target.parent.mkdir(parents=True, exist_ok=True)
        includes = [*first_includes, *(self.tree / f for f in ("host_tests", "kernel/src", "kernel/include"))]
        command = [*COMPILER, *(f"-I{i}" for i in includes), *FLAGS, "-MMD", "-MF", f"{target}.d", "-c", str(source),
                   "-o", str(target)]
        return subprocess.run(command, capture_output=True, text=True).stderr

    def link(self, program, replaced=None):
        replaced = replaced or {}
        objects = [str(replaced.get(source, target)) for source, target in self.objects.items()]
        command = [*COMPILER, *objects, *LIBRARIES, "-o", str(program)]
        return subprocess.run(command, capture_output=True, text=True).stderr


def run_tests(program, pattern, seconds="unlimited"):
    """The test that fails, or how the program ends; None when all is well. Seconds are those of a processor."""
    limits = ["prlimit", f"--as={MEMORY}", f"--cpu={seconds}", "--core=0"]
    command = [*limits, str(program), "--gtest_fail_fast", f"--gtest_filter={pattern}"]
    run = subprocess.run(command, capture_output=True, text=True, errors="replace")
    if run.returncode == 0:
        return None
    failed = re.search(r"^\[  FAILED  \] ([\w./]+)", run.stdout, re.MULTILINE)
    if failed:
        return failed[1]
    begun = re.findall(r"^\[ RUN      \] ([\w./]+)", run.stdout, re.MULTILINE)
    late = run.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return f"{begun[-1] if begun else 'start'} ({'no end' if late else 'crash'})"


class Planted:
    """One bug: found, planted, built and looked for."""

    def __init__(self, number, mutation, tree):
        self.number = number
        self.name, self.find, self.replacement, self.reason = mutation
        places = (tree / "kernel/src" / self.name, tree / "kernel/include" / self.name)
        self.file = next((p for p in places if p.exists()), None)
        self.text = self.file.read_text() if self.file else ""
        self.killer = None
        self.fault = None if self.text.count(self.find) == 1 else "the text does not stand there exactly once"
        self.seconds = 0.0

    def look(self, program):
        began = time.monotonic()
        folder = program.build / f"{self.number}"
        shutil.rmtree(folder, ignore_errors=True)
        try:
            self.fault = self.build(program, folder) or None
            if not self.fault:
                suites = SUITES[self.name.split("/")[0]]
                runs = (run_tests(folder / "tests", pattern, program.seconds) for pattern in (suites, f"-{suites}"))
                self.killer = next((seen for seen in runs if seen), None)
        finally:
            shutil.rmtree(folder, ignore_errors=True)
        self.seconds = time.monotonic() - began
        return self

    def build(self, program, folder):
        overlay = folder / "overlay"
        copy = overlay / self.name
        copy.parent.mkdir(parents=True)
        copy.write_text(self.text.replace(self.find, self.replacement))
        replaced = {}
        for source, depends in program.depends.items():
            if str(self.file) not in depends:
                continue
            replaced[source] = folder / f"{len(replaced)}.o"
            error = program.compile(copy if source == self.file else source, replaced[source], overlay)
            if error:
                return "does not compile:\n" + error
        return program.link(folder / "tests", replaced) if replaced else "nothing is compiled from it"

    def row(self):
        line = self.text[: self.text.find(self.find)].count("\n") + 1
        seen = self.fault or self.killer or "SURVIVES"
        return f"{self.name + ':' + str(line):<34} {self.reason:<58} {seen:<62} {self.seconds:5.1f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="bugs whose file and reason match this expression")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--build", type=pathlib.Path, default=PROJECT / "build/mutation")
    options = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        program = Program(options.build.resolve(), pool)
        chosen = [(n, m) for n, m in enumerate(MUTATIONS) if re.search(options.only, f"{m[0]} {m[3]}")]
        planted = [Planted(n, m, program.tree) for n, m in chosen]
        fault = program.check()
        if fault:
            sys.exit(fault)
        for bug in pool.map(lambda p: p if p.fault else p.look(program), planted):
            print(bug.row(), flush=True)
    unseen = [p for p in planted if p.fault or not p.killer]
    print(f"\n{len(planted) - len(unseen)} of {len(planted)} planted bugs were seen")
    sys.exit(1 if unseen else 0)


if __name__ == "__main__":
    main()
