#!/usr/bin/env -S python3 -B
"""A week of work in an hour: long_run.py --program build/cli/thiessen [--shim build/tests/libthiessen_faults.so]

Ten million steps come by a pipe into `rain`, whose memory must not grow; ten writers replace one output again and again
while a reader looks at it; a series grows by `--append` under a clock that jumps by days. --steps and --seconds say how
long: the short form is a test.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

STATIONS = "id,x,y\nA,2,2\nB,8,3\nC,5,8\n"
BASIN = 'id,WKT\nB1,"POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"\n'
PLAIN = ["stations.csv", "basin.csv"]
MOST_GROWTH_MB = 40  # blocks of steps grow to 16 MB each; ten million steps would be 400 MB


def study(folder):
    folder = pathlib.Path(folder)
    (folder / "stations.csv").write_text(STATIONS, encoding="utf-8")
    (folder / "basin.csv").write_text(BASIN, encoding="utf-8")
    return folder


def memory_of(pid):
    """Megabytes that a process has of its own: files that it maps do not count."""
    for line in pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines():
        if line.startswith("RssAnon:"):
            return int(line.split()[1]) / 1024
    return 0


def steps_from_a_pipe(program, steps):
    """Feeds that many steps and reads what comes. Returns the faults."""
    block = 20_000
    faults, seen = [], []
    with tempfile.TemporaryDirectory(prefix="thiessen-long-") as scratch:
        folder = study(scratch)
        with open(folder / "out.csv", "wb") as out, subprocess.Popen(
                [program, "rain", *PLAIN, "-", "--metric", "planar", "-q"], cwd=folder, stdin=subprocess.PIPE,
                stdout=out) as process:
            process.stdin.write(b"time,A,B,C\n")
            for begin in range(0, steps, block):
                rows = (f"{i},{i % 50},{'' if i % 20 == 0 else i % 7},3\n" for i in range(begin, begin + block))
                process.stdin.write("".join(rows).encode())
                process.stdin.flush()
                seen.append(memory_of(process.pid))
            process.stdin.close()
            status = process.wait()
        with open(folder / "out.csv", "rb") as out:
            rows = sum(1 for _ in out) - 1
    wanted = len(range(0, steps, block)) * block
    if status != 0 or rows != wanted:
        faults.append(f"exit {status}, {rows} of {wanted} rows")
    settled = seen[len(seen) // 4]
    if max(seen) > settled + MOST_GROWTH_MB:
        faults.append(f"memory grows from {settled:.0f} to {max(seen):.0f} MB in {steps} steps")
    print(f"{wanted} steps from a pipe: {settled:.0f} MB after a quarter, {max(seen):.0f} MB at most", flush=True)
    return faults


def writers_and_a_reader(program, seconds, writers=10):
    """Writers of two different results, and a reader that must see one of both, whole."""
    faults, looks, runs = [], 0, 0
    with tempfile.TemporaryDirectory(prefix="thiessen-long-") as scratch:
        folder = study(scratch)
        (folder / "other.csv").write_text(STATIONS.replace("5,8", "6,9"), encoding="utf-8")
        whole = set()
        commands = [[program, "weights", name, "basin.csv", "--metric", "planar", "-q", "-o", "w.csv", "--overwrite"]
                    for name in ("stations.csv", "other.csv")]
        for command in commands:
            subprocess.run(command, cwd=folder, check=True)
            whole.add((folder / "w.csv").read_bytes())
        until = time.monotonic() + seconds
        running = []
        while time.monotonic() < until or running:
            while len(running) < writers and time.monotonic() < until:
                running.append(subprocess.Popen(commands[runs % 2], cwd=folder, stderr=subprocess.PIPE))
                runs += 1
            looks += 1
            if (folder / "w.csv").read_bytes() not in whole:
                faults.append(f"look {looks} sees half a file")
            for process in [p for p in running if p.poll() is not None]:
                running.remove(process)
                said = process.stderr.read().decode()
                process.stderr.close()
                if process.returncode != 0:
                    faults.append(f"a writer ends with {process.returncode}: {said[-200:]}")
        left = sorted(p.name for p in folder.iterdir())
        if left != ["basin.csv", "other.csv", "stations.csv", "w.csv"]:
            faults.append(f"there is {left}")
    print(f"{runs} runs of {writers} writers at a time, {looks} looks", flush=True)
    return faults


def clocks_that_jump(program, shim, days):
    """A series that grows day by day while the clock jumps is what one run makes of all days."""
    with tempfile.TemporaryDirectory(prefix="thiessen-long-") as scratch:
        folder = study(scratch)
        lines = ["time,A,B,C"]
        environment = {**os.environ, "LD_PRELOAD": shim, "FAULT_CLOCK": "1"}
        command = [program, "rain", *PLAIN, "rain.csv", "--metric", "planar", "-q"]
        for day in range(days):
            lines.append(f"2020-{1 + day // 28:02}-{1 + day % 28:02},{day % 9},{day % 5},1")
            (folder / "rain.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
            ran = subprocess.run([*command, "-o", "grown.csv", "--append"], cwd=folder, env=environment,
                                 capture_output=True, text=True, check=False)
            if ran.returncode != 0:
                return [f"day {day}: exit {ran.returncode}: {ran.stderr[-200:]}"]
        subprocess.run([*command, "-o", "whole.csv"], cwd=folder, check=True)
        is_same = (folder / "grown.csv").read_bytes() == (folder / "whole.csv").read_bytes()
    print(f"{days} days under a clock that jumps", flush=True)
    return [] if is_same else ["what grew under a clock that jumps is another series"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--shim")
    parser.add_argument("--steps", type=int, default=10_000_000)
    parser.add_argument("--seconds", type=float, default=1200)
    parser.add_argument("--days", type=int, default=330)
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    faults = steps_from_a_pipe(program, options.steps) + writers_and_a_reader(program, options.seconds)
    if options.shim:
        faults += clocks_that_jump(program, str(pathlib.Path(options.shim).resolve()), options.days)
    print("\n".join(faults or ["all held"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
