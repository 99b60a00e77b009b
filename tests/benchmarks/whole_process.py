#!/usr/bin/env python3
"""Times whole runs of the program and prints what they took; asserts nothing.

    tests/benchmarks/whole_process.py [PROGRAM]

`weights` of 10,000 gauges and 1,000 basins of 50 corners that tile their area (goal: 1 s, 200 MB), in longitude and
latitude and in the plane; the same with twice and four times as many of both, which shows how it grows, and of
100,000 gauges and 1,024 basins; `run` on the Colorado sample (goal: 1 s); `map` of 1,000 gauges as a GeoTIFF of 4,000
x 4,000 pixels (goal: 1 s); geodesic cells in a basin of 10,000 corners (goal: 1 s); `rain` with gauges silent at
random (goals: 0.03 ms a step at 5 %, over 100,000 steps; 1 ms at 20 %), and what it takes to count gauges (--long,
--min-gauges: goal 1.15 times), idw and natural neighbours (20 and 200 million points and steps; goals 45 and 60 ns each); the
whole Earth in the cells of a town's gauges (goal: 5 s, 300 MB); `weights --influence` of 1,000 gauges, 100 basins and
10,000 steps beside `check`, which only reads them (goal: 2 s more), and of fewer steps with silent gauges.

    tests/benchmarks/whole_process.py --plane [PROGRAM]

times large studies in a plane alone: `cells` without basins, of a million gauges as GeoJSON (goal: 4 s, 400 MB) and of
100,000 as a GeoPackage (goal: 0.9 s) beside ogr2ogr, which copies it without an index and with one; `weights` of
100,000 gauges and 10,000 tiles by one thread and by two (goal: 1.8 times as fast).
"""

import math
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time

CLONE = pathlib.Path(__file__).resolve().parents[2]
REPEATS = 5
SEED = 20_240_101


def write_gauges(path, count, box):
    rng = random.Random(SEED)
    west, south, east, north = box
    rows = (f"{i},{rng.uniform(west, east):.6f},{rng.uniform(south, north):.6f}\n" for i in range(count))
    path.write_text("id,x,y\n" + "".join(rows), encoding="utf-8")


def wavy(rng, start, end, points):
    """Points from start (kept) to end (left out), off the straight line, but within 22 degrees of it at both ends."""
    (x0, y0), (x1, y1) = start, end
    line = [start]
    for i in range(1, points):
        t = i / points
        off = 0.4 * min(t, 1 - t) * rng.uniform(-1, 1)
        line.append((x0 + t * (x1 - x0) + off * (y1 - y0), y0 + t * (y1 - y0) - off * (x1 - x0)))
    return line


def tiles(columns, rows, box):
    """Rings of 50 corners that tile the box with wavy sides; neighbours share their side corner for corner."""
    rng = random.Random(SEED)
    west, south, east, north = box
    at = {(i, j): (west + (east - west) * i / columns, south + (north - south) * j / rows)
          for i in range(columns + 1) for j in range(rows + 1)}
    across = {(i, j): wavy(rng, at[i, j], at[i + 1, j], 13) for i in range(columns) for j in range(rows + 1)}
    up = {(i, j): wavy(rng, at[i, j], at[i, j + 1], 12) for i in range(columns + 1) for j in range(rows)}
    for i in range(columns):
        for j in range(rows):
            back = [at[i + 1, j + 1]] + across[i, j + 1][:0:-1]
            down = [at[i, j + 1]] + up[i, j][:0:-1]
            yield across[i, j] + up[i + 1, j] + back + down


def write_basins(path, columns, rows, box):
    lines = ["id,WKT"]
    for number, ring in enumerate(tiles(columns, rows, box)):
        text = ", ".join(f"{x:.7f} {y:.7f}" for x, y in [*ring, ring[0]])
        lines.append(f'b{number},"POLYGON (({text}))"')
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def measure(arguments):
    """Seconds and megabytes of one run, child processes included."""
    begun = time.perf_counter()
    child = os.posix_spawn(arguments[0], arguments, os.environ,
                           file_actions=[(os.POSIX_SPAWN_OPEN, 1, "/dev/null", os.O_WRONLY, 0)])
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(arguments)} failed")
    return time.perf_counter() - begun, usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime


def report(what, arguments):
    runs = [measure([str(a) for a in arguments]) for _ in range(REPEATS)]
    seconds = sorted(run[0] for run in runs)
    print(f"{what:<58} {seconds[0]:7.3f} s best {seconds[len(seconds) // 2]:7.3f} s median "
          f"{max(run[1] for run in runs):6.0f} MB {min(run[2] for run in runs):7.3f} s CPU", flush=True)


def write_readings(path, gauges, steps, silent):
    """Wide, each step with its own random share of silent gauges."""
    rng = random.Random(SEED)
    texts = [f",{tenths / 10}" for tenths in range(300)]
    with path.open("w", encoding="utf-8") as file:
        file.write("time," + ",".join(str(g) for g in range(gauges)) + "\n")
        for step in range(steps):
            readings = ("," if rng.random() < silent else texts[rng.randrange(300)] for _ in range(gauges))
            file.write(f"{step:06d}" + "".join(readings) + "\n")


def write_star(path, corners, centre, radius):
    rng = random.Random(SEED)
    points = []
    for i in range(corners):
        angle = 2 * math.pi * i / corners
        r = radius * (0.8 + 0.15 * math.sin(7 * angle) + 0.03 * math.sin(301 * angle) + 0.005 * rng.random())
        points.append(f"{centre[0] + 1.45 * r * math.cos(angle):.6f} {centre[1] + r * math.sin(angle):.6f}")
    path.write_text(f'id,WKT\nb,"POLYGON (({", ".join([*points, points[0]])}))"\n', encoding="utf-8")


def in_a_plane(program):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        box = (0, 0, 1_000_000, 1_000_000)
        gauges, basins = folder / "gauges.csv", folder / "basins.csv"
        common = ["-q", "--metric", "planar", "--overwrite"]
        write_gauges(gauges, 1_000_000, box)
        report("cells, 1,000,000 gauges, GeoJSON",
               [program, "cells", gauges, *common, "--threads", 1, "-o", folder / "cells.geojson"])
        write_gauges(gauges, 100_000, box)
        write_basins(basins, 100, 100, box)
        cells = folder / "cells.gpkg"
        report("cells, 100,000 gauges, GeoPackage", [program, "cells", gauges, *common, "--threads", 1, "-o", cells])
        ogr2ogr = shutil.which("ogr2ogr")
        for index in ("NO", "YES") if ogr2ogr else ():
            report(f"ogr2ogr, SPATIAL_INDEX={index}",
                   [ogr2ogr, "-overwrite", "-lco", f"SPATIAL_INDEX={index}", folder / "copy.gpkg", cells])
        for threads in (1, 2, 1, 2):
            report(f"weights, 100,000 gauges, 10,000 basins, {threads} threads",
                   [program, "weights", gauges, basins, *common, "--threads", threads, "-o", folder / "weights.csv"])


def main():
    arguments = [a for a in sys.argv[1:] if a != "--plane"]
    program = pathlib.Path(arguments[0] if arguments else CLONE / "build/cli/thiessen").resolve()
    if len(arguments) < len(sys.argv) - 1:
        in_a_plane(program)
        return
    sample = CLONE / "samples" / "colorado"
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        report("starting up (--version)", [program, "--version"])
        inputs = [sample / name for name in ("stations.csv", "counties.geojson", "rainfall.csv")]
        report("Colorado, run", [program, "run", *inputs, "--basin-id", "name", "-q", "--overwrite", "-o",
                                 folder / "out"])
        for crs, box in (("EPSG:4326", (8, 46, 14, 50)), (None, (0, 0, 500_000, 400_000))):
            for times, columns, rows in ((1, 40, 25), (2, 50, 40), (4, 80, 50), (10, 32, 32)):
                gauges, basins = folder / "gauges.csv", folder / "basins.csv"
                write_gauges(gauges, 10_000 * times, box)
                write_basins(basins, columns, rows, box)
                options = ["--crs", crs, "--basins-crs", crs] if crs else []
                report(f"weights, {10_000 * times:,} gauges, {columns * rows:,} basins, {crs or 'a plane'}",
                       [program, "weights", gauges, basins, "-q", *options])
        gauges, basins = folder / "gauges.csv", folder / "basins.csv"
        write_gauges(gauges, 10_000, (3.7, 43.75, 10.3, 48.25))
        write_star(basins, 10_000, (7, 46), 2.1)
        lon_lat = ["--crs", "EPSG:4326", "--basins-crs", "EPSG:4326"]
        report("cells, 10,000 gauges over 500 km, a basin of 10,000 corners",
               [program, "cells", gauges, basins, "-q", *lon_lat, "--overwrite", "-o", folder / "cells.geojson"])
        for crs, box in (("EPSG:4326", (5, 46, 10, 49.5)), (None, (0, 0, 400_000, 400_000))):
            write_gauges(gauges, 1_000, box)
            write_basins(basins, 10, 10, box)
            for silent, steps in ((0.05, 100_000), (0.2, 2_000)):
                write_readings(folder / "rain.csv", 1_000, steps, silent)
                report(f"rain, 1,000 gauges, 100 basins, {steps:,} steps, {silent:.0%} silent, {crs or 'a plane'}",
                       [program, "rain", gauges, basins, folder / "rain.csv", "-q", *(lon_lat if crs else []),
                        "--overwrite", "-o", folder / "areal.csv"])
        write_readings(folder / "rain.csv", 1_000, 5_000, 0.05)
        for options in ([], ["--long"], ["--min-gauges", 2]):
            report(f"rain, 5,000 steps, 5% silent, a plane {' '.join(str(o) for o in options)}",
                   [program, "rain", gauges, basins, folder / "rain.csv", "-q", *options, "--overwrite", "-o",
                    folder / "areal.csv"])
        for steps in (1, 101, 1_001):
            write_readings(folder / "rain.csv", 1_000, steps, 0.05)
            for method in ("idw", "natural"):
                report(f"rain --method {method}, 200,000 points, {steps} steps, 5% silent, a plane",
                       [program, "rain", gauges, basins, folder / "rain.csv", "-q", "--method", method, "--threads", 1,
                        "--overwrite", "-o", folder / "areal.csv"])
        write_gauges(gauges, 800, (8.5, 47.3, 8.6, 47.4))
        basins.write_text('id,WKT\nearth,"POLYGON ((-180 -90, 180 -90, 180 90, -180 90, -180 -90))"\n',
                          encoding="utf-8")
        report("weights, 800 gauges of a town, the Earth", [program, "weights", gauges, basins, "-q", *lon_lat])
        report("cells, 800 gauges of a town, the Earth",
               [program, "cells", gauges, basins, "-q", *lon_lat, "--overwrite", "-o", folder / "cells.geojson"])
        for crs, box in (("EPSG:4326", (5, 46, 10, 49.5)), (None, (0, 0, 400_000, 400_000))):
            write_gauges(gauges, 1_000, box)
            write_basins(basins, 10, 10, box)
            for silent, steps in ((0, 10_000), (0.05, 1_000), (0.2, 100)):
                write_readings(folder / "rain.csv", 1_000, steps, silent)
                options = ["-q", *(lon_lat if crs else [])]
                where = f"{steps:,} steps, {silent:.0%} silent, {crs or 'a plane'}"
                report(f"check, {where}", [program, "check", gauges, basins, folder / "rain.csv", *options])
                report(f"weights --influence, {where}",
                       [program, "weights", gauges, basins, "--influence", folder / "rain.csv", *options])
        for crs, box, pixel in (("EPSG:4326", (9, 42, 19, 52), 0.0025), ("EPSG:32633", (2e5, 47e5, 8e5, 53e5), 150),
                                (None, (0, 0, 6e5, 6e5), 150)):
            gauges, basins = folder / "gauges.csv", folder / "basins.csv"
            write_gauges(gauges, 1_000, box)
            write_basins(basins, 1, 1, box)
            options = ["--crs", crs, "--basins-crs", crs] if crs else []
            report(f"map, 1,000 gauges, 16 million pixels, {crs or 'a plane'}",
                   [program, "map", gauges, basins, "-q", *options, "--resolution", pixel, "--overwrite", "-o",
                    folder / "map.tif"])


if __name__ == "__main__":
    main()
