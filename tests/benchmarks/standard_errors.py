#!/usr/bin/env python3
"""Times `rain` with and without --error and prints the ratio; asserts nothing.

    tests/benchmarks/standard_errors.py [PROGRAM]

1,000 gauges and 100 basins, on the Earth and in a plane, 5 % and 20 % of the gauges silent at random, each policy for
gaps; with 5 % also few steps, where the fit and what is made ready for each basin are all there is; and 10,000 gauges
in 1,000 basins (goal: no more than twice the time). Runs with and without take turns, and the best of each count.
"""

import pathlib
import sys
import tempfile

from whole_process import CLONE, measure, write_basins, write_gauges, write_readings

REPEATS = 5


def compare(what, arguments):
    arguments = [str(a) for a in arguments]
    without, with_errors = [], []
    for _ in range(REPEATS):
        without.append(measure(arguments))
        with_errors.append(measure([*arguments, "--error"]))
    plain, error = min(run[0] for run in without), min(run[0] for run in with_errors)
    cpu = min(run[2] for run in with_errors) / min(run[2] for run in without)
    print(f"{what:<72} {plain:7.3f} s {error:7.3f} s ratio {error / plain:5.2f}, of processor time {cpu:5.2f}, "
          f"{max(run[1] for run in with_errors):5.0f} MB", flush=True)


def main():
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else CLONE / "build/cli/thiessen").resolve()
    settings = [(1_000, 10, steps, silent, gaps)
                for gaps, steps, silent in (("retessellate", 10_000, 0.05), ("retessellate", 1_000, 0.2),
                                            ("renormalise", 10_000, 0.05), ("strict", 10_000, 0.05),
                                            ("retessellate", 10_000, 0.0), ("retessellate", 1_000, 0.05),
                                            ("retessellate", 100, 0.05))]
    settings.append((10_000, 32, 100, 0.05, "retessellate"))
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        gauges, basins, rain = folder / "gauges.csv", folder / "basins.csv", folder / "rain.csv"
        for count, side, steps, silent, gaps in settings:
            write_readings(rain, count, steps, silent)
            for crs, box in (("EPSG:4326", (5, 46, 10, 49.5)), (None, (0, 0, 400_000, 400_000))):
                write_gauges(gauges, count, box)
                write_basins(basins, side, side, box)
                options = ["--crs", crs, "--basins-crs", crs] if crs else []
                compare(f"{count:,} gauges, {side * side:,} basins, {steps:,} steps, {silent:.0%} silent, {gaps}, "
                        f"{crs or 'a plane'}",
                        [program, "rain", gauges, basins, rain, "-q", *options, "--gaps", gaps, "--overwrite", "-o",
                         folder / "areal.csv"])


if __name__ == "__main__":
    main()
