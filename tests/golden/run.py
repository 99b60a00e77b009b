#!/usr/bin/env -S python3 -B
"""Runs golden cases: a command, and what it must print, return and write.

    run.py --program build/cli/thiessen CASE...            compares; exit 0 same, 1 different, 77 not accepted yet
    run.py --program build/cli/thiessen --show CASE...     prints what the command does now
    run.py --program build/cli/thiessen --accept CASE...   writes that into the case: read it first

A folder stands for the cases in it. README.md in this folder describes a case's form.
"""

import argparse
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import case as cases

PENDING = 77
TIME_LIMIT_S = 120
PASSED_ON = ("LC_ALL", "LANG", "LOCPATH", "TZ", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LD_LIBRARY_PATH")
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def snapshot(folder):
    """{name: content} of every file below the folder; the link to the samples is not followed."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_symlink():
            if name != "samples":
                found[name] = b"-> " + os.fsencode(os.readlink(path))
        elif path.is_fifo():
            found[name] = b"(fifo)"
        elif path.is_file():
            found[name] = path.read_bytes()
    return found


def shell(script, folder, programs):
    environment = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
    environment.setdefault("LC_ALL", "C.UTF-8")
    environment.update(HOME=str(folder), PATH=f"{programs}:/usr/bin:/bin")
    return subprocess.run(["bash", "-c", script], cwd=folder, env=environment, timeout=TIME_LIMIT_S,
                          stdin=subprocess.DEVNULL, capture_output=True)


def perform(case, program):
    """Runs the case's command in a folder of its own; returns what it did, as a case writes it down."""
    with tempfile.TemporaryDirectory(prefix="thiessen-golden-") as scratch:
        programs, folder = pathlib.Path(scratch, "bin"), pathlib.Path(scratch, "case")
        programs.mkdir()
        folder.mkdir()
        (programs / "thiessen").symlink_to(pathlib.Path(program).resolve())
        (folder / "samples").symlink_to(SAMPLES)
        for name, content in case.inputs.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content)
        if case.make:
            made = shell(case.make, folder, programs)
            if made.returncode != 0:
                sys.exit(f"{case.path}: its make section failed: {made.stderr.decode()}")
        before = snapshot(folder)
        ran = shell(case.command, folder, programs)
        after = snapshot(folder)
        shutil.rmtree(folder, ignore_errors=True)
    outputs = {name: content for name, content in after.items() if before.get(name) != content}
    gone = sorted(set(before) - set(after))
    return cases.Outcome(ran.returncode, ran.stdout, ran.stderr, outputs, gone)


def difference(name, expected, actual):
    if expected == actual:
        return []
    if len(expected) + len(actual) > 200_000:
        return [f"{name} differs ({len(expected)} bytes expected, {len(actual)} found)"]
    lines = [content.decode("utf-8", "backslashreplace").splitlines() for content in (expected, actual)]
    return list(difflib.unified_diff(*lines, f"{name} expected", f"{name} found", lineterm=""))


def compare(expected, actual):
    report = []
    if expected.status != actual.status:
        report.append(f"exit status {actual.status}, expected {expected.status}")
    report += difference("stdout", expected.stdout, actual.stdout)
    report += difference("stderr", expected.stderr, actual.stderr)
    report += [f"the file {name} is gone" for name in actual.gone]
    for name in sorted(expected.outputs.keys() | actual.outputs.keys()):
        if name not in actual.outputs:
            report.append(f"the file {name} was not written")
        elif name not in expected.outputs:
            report.append(f"the file {name} was written, and should not have been")
        elif expected.outputs[name] is not cases.ANYTHING:
            report += difference(name, expected.outputs[name], actual.outputs[name])
    return report


def gathered(paths):
    """The files of cases that are named, and those in the folders that are."""
    found = []
    for path in paths:
        below = sorted(path.rglob("*.case")) if path.is_dir() else [path]
        if not below:
            sys.exit(f"{path}: there are no cases")
        found += below
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--accept", action="store_true")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    failed = pending = 0
    paths = gathered(options.cases)
    for path in paths:
        case = cases.read(path)
        if case.expected is None and not (options.accept or options.show):
            print(f"{path}: pending: nobody has accepted its output yet")
            pending += 1
            continue
        actual = perform(case, options.program)
        if options.show:
            print(f"==== {path}: {case.title}\n{cases.written(case, actual)}")
        elif options.accept:
            path.write_text(cases.whole(case, actual), encoding="utf-8")
        elif report := compare(case.expected, actual):
            failed += 1
            print("\n".join([f"{path}: {case.title}", "$ " + case.command.strip(), *report]))
            print(f"to run it alone: {__file__} --program {options.program} {path}", flush=True)
    if not (options.show or options.accept):
        print(f"{len(paths)} cases: {failed} failed, {pending} pending")
    return 1 if failed else PENDING if pending else 0


if __name__ == "__main__":
    sys.exit(main())
