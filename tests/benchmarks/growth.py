#!/usr/bin/env python3
"""Measures how work and memory grow, each in one number over three decades, and prints a table; asserts nothing.

    tests/benchmarks/growth.py [PROGRAM [NAME...]]

Each run is of the whole program: processor time and the most memory, less what `--version` takes. A slope is that of the
logarithms: 1 is in proportion. It is told for each decade, since what is small beside starting up says little, and for
the last two together by least squares. NAME is a part of a row's name, such as `basins`.
"""

import math
import multiprocessing
import pathlib
import random
import sys
import tempfile

from whole_process import CLONE, SEED, measure, write_basins, write_gauges

PLANE = (0, 0, 500_000, 400_000)
EARTH = (8, 46, 14, 50)
LON_LAT = ["--crs", "EPSG:4326", "--basins-crs", "EPSG:4326"]
LEAST = 0.005  # seconds of processor time, below which no slope is told


class Inputs:
    """Writes what the rows need into a folder. Called in a process of its own: a program's most memory counts that of
    the process which starts it."""

    def __init__(self, folder):
        self.gauges = folder / "gauges.csv"
        self.basins = folder / "basins.csv"
        self.rain = folder / "rain.csv"
        self.out = folder

    def write_star(self, corners, box):
        """One basin whose sides are as rough at any number of corners."""
        rng = random.Random(SEED)
        west, south, east, north = box
        points = []
        for i in range(corners):
            angle = 2 * math.pi * i / corners
            r = (north - south) / 2.1 * (0.8 + 0.15 * math.sin(7 * angle) + 0.03 * math.sin(301 * angle) +
                                         math.pi / corners * rng.random())
            points.append(f"{(west + east) / 2 + r * math.cos(angle):.9f} {(south + north) / 2 + r * math.sin(angle):.9f}")
        self.basins.write_text(f'id,WKT\nb,"POLYGON (({", ".join([*points, points[0]])}))"\n', encoding="utf-8")

    def write_rain(self, gauges, steps):
        """Wide; the same thousand rows again and again, each with a twentieth of the gauges silent."""
        rows = ["".join("," if (7 * row + 13 * g) % 20 == 0 else f",{(row * 31 + g * 17) % 300 / 10}"
                        for g in range(gauges)) for row in range(min(steps, 1000))]
        with self.rain.open("w", encoding="utf-8") as file:
            file.write("time," + ",".join(str(g) for g in range(gauges)) + "\n")
            for step in range(steps):
                file.write(f"{step:07d}{rows[step % 1000]}\n")


def stations(inputs, count, box, options):
    write_gauges(inputs.gauges, count, box)
    write_basins(inputs.basins, 10, 10, box)
    return ["weights", inputs.gauges, inputs.basins, "-q", *options, "--overwrite", "-o", inputs.out / "weights.csv"]


def basins(inputs, count, box, options):
    columns = {10: 5, 100: 10, 1_000: 40, 10_000: 100}[count]
    write_gauges(inputs.gauges, 1_000, box)
    write_basins(inputs.basins, columns, count // columns, box)
    return ["weights", inputs.gauges, inputs.basins, "-q", *options, "--overwrite", "-o", inputs.out / "weights.csv"]


def vertices(inputs, count, box, options):
    write_gauges(inputs.gauges, 1_000, box)
    inputs.write_star(count, box)
    return ["weights", inputs.gauges, inputs.basins, "-q", *options, "--overwrite", "-o", inputs.out / "weights.csv"]


def steps(inputs, count, box, options):
    write_gauges(inputs.gauges, 100, box)
    write_basins(inputs.basins, 5, 2, box)
    inputs.write_rain(100, count)
    return ["rain", inputs.gauges, inputs.basins, inputs.rain, "-q", *options, "--overwrite", "-o",
            inputs.out / "areal.csv"]


def cells(inputs, count, box, options):
    write_gauges(inputs.gauges, count, box)
    return ["cells", inputs.gauges, "-q", *options[:2], "--overwrite", "-o", inputs.out / "cells.geojson"]


def pixels(inputs, count, box, options):
    write_gauges(inputs.gauges, 1_000, box)
    west, south, east, north = box
    pixel = math.sqrt((east - west) * (north - south) / count)
    return ["map", inputs.gauges, "-q", *options[:2], "--resolution", f"{pixel:.9f}", "--overwrite", "-o",
            inputs.out / "map.tif"]


ROWS = {"stations": (stations, (1_000, 10_000, 100_000, 1_000_000)),
        "basins": (basins, (10, 100, 1_000, 10_000)),
        "vertices of a basin": (vertices, (1_000, 10_000, 100_000, 1_000_000)),
        "steps": (steps, (100, 1_000, 10_000, 100_000)),
        "cells written, GeoJSON": (cells, (1_000, 10_000, 100_000, 1_000_000)),
        "pixels of a GeoTIFF": (pixels, (100_000, 1_000_000, 10_000_000, 100_000_000))}


def least(arguments, repeats):
    """The least processor time of some runs, in seconds, and memory in megabytes."""
    runs = [measure([str(a) for a in arguments]) for _ in range(repeats)]
    return min(run[2] for run in runs), min(run[1] for run in runs)


def slope(points):
    """Least squares of the logarithms."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x, mean_y = (sum(axis) / len(logs) for axis in zip(*logs))
    return (sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs))


def slopes_of(counts, values, smallest):
    """Of each decade and of the last two, a dash where a value is too small to tell."""
    def told(points):
        return f"{slope(points):.2f}" if all(value > smallest for _, value in points) else "-"
    points = list(zip(counts, values))
    return " ".join(told(points[i:i + 2]) for i in range(len(points) - 1)), told(points[-3:])


def main():
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else CLONE / "build/cli/thiessen").resolve()
    names = sys.argv[2:]
    begun, at_first = least([program, "--version"], 10)
    print(f"starting up: {begun * 1000:.0f} ms, {at_first:.0f} MB; taken off in each row")
    with tempfile.TemporaryDirectory() as scratch:
        inputs = Inputs(pathlib.Path(scratch))
        for name, (arguments_of, counts) in ROWS.items():
            if names and not any(part in name for part in names):
                continue
            for where, box, options in (("a plane", PLANE, []), ("the Earth", EARTH, LON_LAT)):
                times, sizes = [], []
                for count in counts:
                    with multiprocessing.Pool(1) as pool:
                        arguments = [program, *pool.apply(arguments_of, (inputs, count, box, options))]
                    seconds, megabytes = least(arguments, 1 if count == counts[-1] else 3)
                    times.append(seconds - begun)
                    sizes.append(megabytes - at_first)
                by_decade, last = slopes_of(counts, times, LEAST)
                memory_by_decade, memory_last = slopes_of(counts, sizes, 1)
                print(f"{name}, {where}, {counts[0]:,} to {counts[-1]:,}: time {by_decade}, last two decades {last} "
                      f"(to {times[-1]:.2f} s); memory {memory_by_decade}, last two {memory_last} "
                      f"(to {sizes[-1]:.0f} MB)", flush=True)


if __name__ == "__main__":
    main()
