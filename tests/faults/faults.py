#!/usr/bin/env -S python3 -B
"""A failing machine, call by call: faults.py --program build/cli/thiessen --shim build/tests/libthiessen_faults.so

For every kind of call that shim.cpp knows, and every n, runs the program so that its n-th such call fails, and so that
all fail from there on. After each run: the exit status is 0 or 1, and no signal ended it; with 1 there is a message, of
the kind's own cause where the program itself was told it; what was there is as it was, to the byte; nothing new is left,
under no name. With 0 all is there, and tables are what they are on a machine that does not fail. --every K tries
every K-th call alone; --kind and --job choose.
"""

import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

SAMPLE = pathlib.Path(__file__).resolve().parents[2] / "samples" / "textbook"
STUDY = [str(SAMPLE / f"{name}.csv") for name in ("stations", "basin")]
READINGS = [*STUDY, str(SAMPLE / "rainfall.csv")]
PLAIN = ["--metric", "planar", "--threads", "2"]

JOBS = {  # what is run, in a folder of its own; what it writes lies in the folder out
    "weights": ["weights", *STUDY, *PLAIN, "-o", "out/weights.csv"],
    "rain": ["rain", *READINGS, *PLAIN, "-o", "out/rain.csv"],
    "influence": ["weights", *STUDY, *PLAIN, "--influence", READINGS[2], "-o", "out/weights.csv"],
    "cells": ["cells", *STUDY, *PLAIN, "-o", "out/cells.gpkg"],
    "map": ["map", *READINGS, *PLAIN, "-o", "out/map.png", "--size", "300"],
    "raster": ["map", *STUDY, *PLAIN, "-o", "out/map.tif", "--resolution", "0.05"],
    "run": ["run", *READINGS, *PLAIN, "-o", "out", "--size", "300"],
    "run_anew": ["run", *READINGS, *PLAIN, "-o", "anew/in/out", "--size", "300"],
}
KINDS = ("malloc", "open", "read", "write", "fsync", "close", "rename", "link", "unlink", "mkdir", "mmap", "thread", "dup")
# A library that finds no memory or no file may draw with other fonts; what is computed is the same or is not there.
EXACT = (".csv", ".geojson", ".toml")
TIME_LIMIT_S = 120


class Machine:
    def __init__(self, program, shim):
        self.program, self.shim = str(pathlib.Path(program).resolve()), str(pathlib.Path(shim).resolve())

    def start(self, job, folder):
        overwrite = [] if job == "run_anew" else ["--overwrite"]
        return subprocess.Popen([self.program, *JOBS[job], *overwrite], cwd=folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def run(self, job, folder, replaces=False, **faults):
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "LD_PRELOAD": self.shim, **faults}
        overwrite = [] if job == "run_anew" and not replaces else ["--overwrite"]
        return subprocess.run([self.program, *JOBS[job], *overwrite], cwd=folder, env=environment, capture_output=True,
                              timeout=TIME_LIMIT_S, stdin=subprocess.DEVNULL)


def files_of(folder):
    """What lies in the folder, by name; None for a folder."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() if path.is_file() else None
            for path in sorted(folder.rglob("*"))}


def told(ran):
    return ran.stderr.decode("utf-8", "backslashreplace")


def wrong(kind, lasts, ran, before, after, whole):
    """What is wrong of a run: an empty list where all is as it has to be."""
    faults = []
    if ran.returncode < 0:
        return [f"ended by {signal.Signals(-ran.returncode).name}: {told(ran)[-300:]}"]
    if ran.returncode not in (0, 1):
        faults.append(f"exit status {ran.returncode}")
    if "a fault of the program itself" in told(ran):
        faults.append("blamed on the program: " + told(ran)[-300:])
    if ran.returncode == 0:
        lost = [name for name in whole if name not in after]
        other = [name for name in whole if name.endswith(EXACT) and name in after and after[name] != whole[name]]
        left = [name for name in after if name not in whole]
        faults += [f"{name} is not there, with exit status 0" for name in lost]
        faults += [f"{name} is another, with exit status 0" for name in other]
        # What cannot be removed once all is in place does no harm; a later run removes it.
        faults += [f"{name} is left" for name in left if kind not in ("unlink", "open")]
        return faults
    if "thiessen: error: " not in told(ran):
        faults.append("no message: " + repr(told(ran)[-300:]))
    if kind == "malloc" and "memory" not in told(ran):
        faults.append("the message names no lack of memory: " + told(ran)[-300:])
    kept = [line for line in told(ran).splitlines() if "kept as" in line or "which is new" in line]
    for name in sorted(before.keys() | after.keys()):
        if before.get(name, b"") == after.get(name, b"") and (name in before) == (name in after):
            continue
        short = name.rpartition("/")[2]
        if any(short in line for line in kept) and kind in ("rename", "unlink", "link"):
            continue  # nothing can be brought back, and the message says where it is
        if name in after and kind == "unlink" and lasts and short.startswith(".thiessen-"):
            continue  # nothing at all can be removed
        faults.append(f"{name} is {'gone' if name not in after else 'left' if name not in before else 'changed'}")
    return faults


class Trial:
    """One job on a machine that fails in one way."""

    def __init__(self, machine, job):
        self.machine, self.job = machine, job
        self.old = {}
        with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
            folder = self.prepared(scratch)
            ran = machine.run(job, folder)
            if ran.returncode != 0:
                sys.exit(f"{job} fails on a sound machine: {told(ran)}")
            self.whole = files_of(folder)
            self.old = {name: b"old" for name, content in self.whole.items()
                        if content is not None and job != "run_anew" and not name.endswith(".gpkg")}

    def prepared(self, scratch):
        folder = pathlib.Path(scratch)
        if self.job != "run_anew":
            (folder / "out").mkdir()
        for name, content in self.old.items():
            (folder / name).write_bytes(content)
        return folder

    def count(self, kind, **more):
        with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
            folder = self.prepared(scratch)
            with tempfile.NamedTemporaryFile() as counted:
                self.machine.run(self.job, folder, FAULT=f"{kind}:0", FAULT_COUNT=counted.name, **more)
                return int(pathlib.Path(counted.name).read_text() or 0)

    def faults(self, kind, number, lasts, **more):
        with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
            folder = self.prepared(scratch)
            before = files_of(folder)
            try:
                ran = self.machine.run(self.job, folder, FAULT=f"{kind}{'+' if lasts else ''}:{number}", **more)
            except subprocess.TimeoutExpired:
                return ["it hangs"]
            return wrong(kind, lasts, ran, before, files_of(folder), self.whole)


def is_hidden(name):
    return "/.thiessen-" in name


def wrong_of_killed(before, after, whole):
    """What is wrong of what a killed run left: each file is old or new, whole; where any is new all are, but in the moment
    of the names, which shows by folders that are still empty, and by hidden names from the first to the last rename."""
    names = {name for name in after if not is_hidden(name)}
    new = names ^ set(before)
    is_at_names = len(names) < len(after) or all(name in whole and after.get(name, b"") is None for name in new)
    faults = []
    if names != set(whole) and not (is_at_names and set(before) <= names <= set(before) | set(whole)):
        faults.append("there is " + ", ".join(sorted(new)))
    return faults + [name + " is cut" for name in sorted(names) if name.endswith(EXACT) and name in whole
                     and after[name] not in (before.get(name), whole[name])]


def killed(machine, job, times, tell=lambda line: None):
    """Kills the job at moments spread over its run. Returns what is wrong of what it leaves, and what the next run does
    not clear away."""
    trial, faults = Trial(machine, job), []
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
        machine.run(job, trial.prepared(scratch))
    lasts = time.monotonic() - begin
    for number in range(times):
        with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
            folder = trial.prepared(scratch)
            before = files_of(folder)
            with machine.start(job, folder) as process:
                try:
                    process.wait(lasts * (number + 1) / times * random.uniform(0.8, 1.1))
                except subprocess.TimeoutExpired:
                    process.kill()
                process.wait()
            after = files_of(folder)
            moment = f"{job} killed, {number + 1} of {times}: "
            faults += [moment + fault for fault in wrong_of_killed(before, after, trial.whole)]
            names = {name for name in after if not is_hidden(name)}
            is_renaming = any(after[name] != before.get(name) for name in names if name in before)
            if len(names) < len(after) and not is_renaming:
                tell(moment + "it was at the names: " + ", ".join(sorted(set(after) - names)))
            machine.run(job, folder, replaces=True)
            left = [name for name in files_of(folder) if is_hidden(name)]
            faults += [moment + name + " is left after the next run" for name in left]
    return faults


def numbers(count, every, most):
    """Which calls fail: every K-th, or at most so many, the first and the last among them."""
    if most is not None and count > most:
        return sorted({1 + round(i * (count - 1) / (most - 1)) for i in range(most)})
    return range(1, count + 1, every)


def try_all(machine, jobs, kinds, every=1, most=None, tell=print):
    """Runs all trials; returns how many there were, and the faults by trial."""
    runs, found = 0, {}
    for job in jobs:
        trial = Trial(machine, job)
        for more in ({}, {"FAULT_UNNAMED": "1"}):
            for kind in kinds:
                if more and kind in ("malloc", "mmap", "thread", "read"):
                    continue  # they know nothing of names
                count = trial.count(kind, **more)
                bad = 0
                for lasts in (False, True):
                    for number in numbers(count, every, most):
                        runs += 1
                        faults = trial.faults(kind, number, lasts, **more)
                        if faults:
                            bad += 1
                            found[(job, kind, number, lasts, bool(more))] = faults
                tell(f"{job} {kind}{' (no unnamed files)' if more else ''}: {count} calls, {bad} faults")
    return runs, found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--shim", required=True)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--most", type=int)
    parser.add_argument("--kind", action="append", choices=KINDS)
    parser.add_argument("--kill", type=int, default=0, help="also kill each job so many times")
    parser.add_argument("--job", action="append", choices=JOBS)
    options = parser.parse_args()
    machine = Machine(options.program, options.shim)
    runs, found = try_all(machine, options.job or JOBS, options.kind or KINDS,
                          options.every, options.most, lambda line: print(line, flush=True))
    for (job, kind, number, lasts, named), faults in found.items():
        for fault in faults:
            print(f"{job}: {kind}{'+' if lasts else ''}:{number}{' FAULT_UNNAMED=1' if named else ''}: {fault}")
    left = [fault for job in options.job or JOBS if options.kill
            for fault in killed(machine, job, options.kill, lambda line: print(line, flush=True))]
    print("".join(fault + "\n" for fault in left) + f"{runs} runs, {len(found)} with faults")
    return 1 if found or left else 0


if __name__ == "__main__":
    sys.exit(main())
