#!/usr/bin/env python3
"""Plants faults in readings and prints how many `check` finds, and what it finds where none is planted.

    tests/benchmarks/planted_findings.py PROGRAM STATIONS RAINFALL [SEED...]

RAINFALL is a wide CSV in mm of days, hours or months. Each seed plants each fault in a copy of its own, in gauges or
readings that are not found without it. What is found in the copy that has no fault is an alarm: false, or true and
unknown.
"""

import collections
import csv
import datetime
import pathlib
import random
import subprocess
import sys
import tempfile

PLANTED = 100  # single readings of a seed
GAUGES = 3  # whole gauges of a seed


class Rain:
    """A table of readings, None where there is none."""

    def __init__(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        self.ids = rows[0][1:]
        self.times = [row[0] for row in rows[1:]]
        self.readings = [[None if text in ("", "NA") else float(text) for text in row[1:]] for row in rows[1:]]
        moments = [datetime.datetime.fromisoformat((t + "-01" if len(t) == 7 else t).replace("Z", "+00:00"))
                   for t in self.times]
        self.step = collections.Counter(b - a for a, b in zip(moments, moments[1:])).most_common(1)[0][0]
        self.years = [moment.year for moment in moments]
        self.follows = [False] + [b - a == self.step for a, b in zip(moments, moments[1:])]

    def copy(self):
        return [list(row) for row in self.readings]

    def gauge_years(self):
        per_year = 31_557_600 / self.step.total_seconds()
        return sum(reading is not None for row in self.readings for reading in row) / per_year

    def dry(self, step, gauge):
        return self.readings[step][gauge] == 0

    def at_least(self, amount):
        return lambda step, gauge: (self.readings[step][gauge] or 0) >= amount

    def write(self, path, readings):
        with open(path, "w", encoding="utf-8", newline="") as file:
            out = csv.writer(file)
            out.writerow(["time", *self.ids])
            for time, row in zip(self.times, readings):
                out.writerow([time, *("" if r is None else repr(r) for r in row)])


def findings(program, stations, rain, readings, folder):
    """What is found, as kinds by (station, time)."""
    table, found = folder / "rain.csv", folder / "findings.csv"
    rain.write(table, readings)
    subprocess.run([program, "check", stations, "--rainfall", table, "-q", "-o", found, "--overwrite"], check=True,
                   stdout=subprocess.DEVNULL)
    kinds = collections.defaultdict(set)
    with open(found, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            kinds[row["station"], row["time"]].add(row["finding"])
    return kinds


def plant_readings(rain, rng, among, fault):
    """Changes single readings, one a step at most."""
    readings, places, steps = rain.copy(), [], set()
    candidates = [(s, g) for s, row in enumerate(rain.readings) for g, r in enumerate(row) if r is not None and among(s, g)]
    for step, gauge in rng.sample(candidates, len(candidates)):
        if step in steps:
            continue
        steps.add(step)
        readings[step][gauge] = fault(readings[step][gauge])
        places.append((rain.ids[gauge], rain.times[step]))
        if len(places) == PLANTED:
            break
    return readings, places


def stuck(rain, rng, steps):
    """Has gauges read one of their readings over and over."""
    readings, places = rain.copy(), []
    for _ in range(10_000):
        if len(places) == PLANTED // 5:
            break
        gauge, first = rng.randrange(len(rain.ids)), rng.randrange(len(rain.times) - steps)
        held = readings[first][gauge]
        if not held or not all(rain.follows[first + 1:first + steps]):
            continue
        for step in range(first, first + steps):
            readings[step][gauge] = held
        places.append((rain.ids[gauge], rain.times[first + steps // 2]))
    return readings, places


def plant_gauges(rain, rng, good, change):
    """Changes whole gauges; `change` gives a gauge's column anew."""
    readings, places = rain.copy(), []
    for gauge in rng.sample(good, GAUGES):
        for step, reading in enumerate(change([row[gauge] for row in rain.readings])):
            readings[step][gauge] = reading
        places.append((rain.ids[gauge], ""))
    return readings, places


def times(factor, steps=lambda step: True):
    return lambda column: [r if r is None or not steps(i) else round(r * factor, 4) for i, r in enumerate(column)]


def broken(rain, rng, factor):
    """From a year in the middle half of the gauge's record on."""
    def change(column):
        years = sorted({year for year, reading in zip(rain.years, column) if reading is not None})
        since = rng.choice(years[len(years) // 4:len(years) * 3 // 4])
        return times(factor, lambda step: rain.years[step] >= since)(column)
    return change


def moved(rain, late):
    if late:
        return lambda column: [column[i - 1] if rain.follows[i] else None for i in range(len(column))]
    return lambda column: [column[i + 1] if i + 1 < len(column) and rain.follows[i + 1] else None
                           for i in range(len(column))]


def faults(rain, rng, good):
    """The faults, and the kind by which each is to be found."""
    day, wide = rain.step == datetime.timedelta(days=1), rain.step > datetime.timedelta(days=1)
    if not wide:
        high = 100.0 if day else 30.0
        yield f"{high:g} mm on a dry step", "spike", *plant_readings(rain, rng, rain.dry, lambda r: high)
        yield "x 25.4 of 2 mm or more", "spike", *plant_readings(rain, rng, rain.at_least(2), lambda r: r * 25.4)
        for least in (5, 10, 20):
            yield f"0 for {least} mm or more", "zero", *plant_readings(rain, rng, rain.at_least(least), lambda r: 0.0)
        yield f"{15 if day else 24} steps alike", "stuck", *stuck(rain, rng, 15 if day else 24)
    for factor in (25.4, 10, 0.1):
        yield f"all x {factor:g}", "unit", *plant_gauges(rain, rng, good["unit"], times(factor))
    if day:
        for late in (True, False):
            yield f"a step {'late' if late else 'early'}", "shift", *plant_gauges(rain, rng, good["shift"],
                                                                                 moved(rain, late))
    if len(set(rain.years)) >= 15:
        for factor in (1.5, 1 / 1.5, 2):
            yield f"x {factor:.3g} from a year on", "break", *plant_gauges(rain, rng, good["break"],
                                                                          broken(rain, rng, factor))


def main():
    program, stations = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    rain = Rain(sys.argv[3])
    seeds = [int(seed) for seed in sys.argv[4:]] or list(range(1, 11))
    counts = collections.defaultdict(lambda: [0, 0])
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        plain = findings(program, stations, rain, rain.readings, folder)
        print(f"{len(rain.ids)} gauges, {rain.gauge_years():.0f} gauge years, nothing planted:")
        for kind in ("spike", "zero", "stuck", "unit", "shift", "break"):
            found = sum(kind in kinds for kinds in plain.values())
            share = f"{found / rain.gauge_years():.3f} a gauge year" if kind in ("spike", "zero", "stuck") \
                else f"{found / len(rain.ids):.1%} of gauges"
            print(f"  {kind:<6} {found:>5}  {share}")
        never = [all(row[g] is None for row in rain.readings) for g in range(len(rain.ids))]
        good = {kind: [g for g, name in enumerate(rain.ids) if kind not in plain.get((name, ""), ()) and not never[g]]
                for kind in ("unit", "shift", "break")}
        good["break"] = [g for g in good["break"]
                         if len({year for year, row in zip(rain.years, rain.readings) if row[g] is not None}) >= 15]
        for seed in seeds:
            rng = random.Random(seed)
            for name, kind, readings, places in faults(rain, rng, good):
                kinds = findings(program, stations, rain, readings, folder)
                counts[name, kind][0] += sum(kind in kinds.get(place, ()) for place in places)
                counts[name, kind][1] += len(places)
        print(f"planted, seeds {seeds[0]} to {seeds[-1]}:")
        for (name, kind), (found, planted) in counts.items():
            print(f"  {kind:<6} {name:<24} {found:>5} of {planted:>5}  {found / max(1, planted):.1%}")


if __name__ == "__main__":
    main()
