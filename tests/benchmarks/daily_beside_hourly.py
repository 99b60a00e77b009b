#!/usr/bin/env python3
"""What daily totals add to hourly means: a third of the gauges of an hourly network are made daily.

    tests/benchmarks/daily_beside_hourly.py --program build/cli/thiessen STATIONS HOURLY
    tests/benchmarks/daily_beside_hourly.py --program build/cli/thiessen --speed

STATIONS and HOURLY (wide, times with a clock) are an hourly network. The means of basins, squares of 75 km whose middles
lie within the gauges' hull, by all gauges are taken for true. In each round a third of the gauges, drawn by the seed, is
read once a day at 09:00 UTC; told is the root mean square error of hourly means, over the hours in which any gauge has rain,
where these gauges are left out and where their totals are spread. --speed times `rain` beside `rain --totals` on 1,000
gauges and 50,000 hours in turn, in processor time.
"""

import argparse
import csv
import datetime
import math
import pathlib
import random
import resource
import subprocess
import sys
import tempfile


def run(program, folder, *arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(program), *arguments], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stderr


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def hull(points):
    points = sorted(set(points))

    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and cross(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    return half(points) + half(points[::-1])


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def squares(points, kilometres=75):
    """Squares in longitude and latitude whose middles lie in the hull of points."""
    corners = hull(points)
    lats = [p[1] for p in points]
    lons = [p[0] for p in points]
    high = kilometres / 111.2
    wide = high / math.cos(math.radians((min(lats) + max(lats)) / 2))
    found = []
    for i in range(int((max(lons) - min(lons)) / wide) + 1):
        for j in range(int((max(lats) - min(lats)) / high) + 1):
            x, y = min(lons) + (i + .5) * wide, min(lats) + (j + .5) * high
            if all(cross(corners[k - 1], corners[k], (x, y)) > 0 for k in range(len(corners))):
                a, b, c, d = x - wide / 2, y - high / 2, x + wide / 2, y + high / 2
                found.append([f"b{i}_{j}", f"POLYGON (({a} {b}, {c} {b}, {c} {d}, {a} {d}, {a} {b}))"])
    return found


def value(text):
    return float(text) if text else math.nan


def daily(rows, columns):
    """Totals from 09:00 to 09:00 of these columns, dated by their end; only whole ones."""
    sums, hours = {}, {}
    order = []
    for row in rows[1:]:
        date, clock = row[0][:10], int(row[0][11:13])
        day = f"{date}+" if clock >= 9 else date  # the morning of a day belongs to its own date
        if day not in sums:
            sums[day], hours[day] = [0.0] * len(columns), 0
            order.append(day)
        hours[day] += 1
        for k, c in enumerate(columns):
            sums[day][k] += value(row[c])
    table = []
    for evening, morning in zip(order, order[1:]):
        if not evening.endswith("+") or hours[evening] != 15 or hours[morning] != 9:
            continue
        totals = [a + b for a, b in zip(sums[evening], sums[morning])]
        table.append([morning] + ["" if math.isnan(t) else repr(round(t, 6)) for t in totals])
    return table


def errors(truth, found, wet):
    squares_of, count = 0.0, 0
    for a, b, is_wet in zip(truth[1:], found[1:], wet):
        for x, y in zip(a[1:], b[1:]):
            if is_wet and x and y:
                squares_of += (float(x) - float(y)) ** 2
                count += 1
    return math.sqrt(squares_of / count)


def accuracy(said):
    stations, hourly = read(said.stations), read(said.hourly)
    names = [field.lower() for field in stations[0]]
    lon, lat = names.index("longitude"), names.index("latitude")
    points = {row[0]: (float(row[lon]), float(row[lat])) for row in stations[1:]}
    ids = hourly[0][1:]
    # A trailing Z on every time does not matter here: 09:00 is meant by the clock of the file.
    wet = [any(value(field) > 0 for field in row[1:]) for row in hourly[1:]]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder / "stations.csv", [["id", "longitude", "latitude"]] + [[i, *points[i]] for i in ids])
        write(folder / "basins.csv", [["id", "WKT"]] + squares([points[i] for i in ids]))
        write(folder / "hourly.csv", hourly)
        common = ["rain", "stations.csv", "basins.csv"]
        written = ["--basins-crs", "EPSG:4326", "--decimals", "6", "--overwrite", "-q", "-o"]
        run(said.program, folder, *common, "hourly.csv", *written, "truth.csv")
        truth = read(folder / "truth.csv")
        print(f"{len(truth[0]) - 1} basins, {sum(wet)} hours with rain; root mean square error in mm: left out, spread")
        sums = [0.0, 0.0]
        for turn in range(said.rounds):
            drawn = random.Random(said.seed + turn).sample(range(1, len(ids) + 1), len(ids) // 3)
            kept = [0] + [c for c in range(1, len(ids) + 1) if c not in drawn]
            write(folder / "some.csv", [[row[c] for c in kept] for row in hourly])
            write(folder / "totals.csv", [["date"] + [hourly[0][c] for c in drawn]] + daily(hourly, drawn))
            run(said.program, folder, *common, "some.csv", *written, "left_out.csv")
            run(said.program, folder, *common, "some.csv", "--totals", "totals.csv", "--observed-at", "09:00",
                *written, "spread.csv")
            both = [errors(truth, read(folder / file), wet) for file in ("left_out.csv", "spread.csv")]
            print(f"  seed {said.seed + turn}: {both[0]:.4f} {both[1]:.4f}")
            sums = [a + b * b for a, b in zip(sums, both)]
        print("all:", *(f"{math.sqrt(s / said.rounds):.4f}" for s in sums))


def speed(said):
    chance = random.Random(said.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        gauges = [f"g{i}" for i in range(said.gauges)]
        fine = [g for i, g in enumerate(gauges) if i % 3]
        coarse = [g for i, g in enumerate(gauges) if i % 3 == 0]
        write(folder / "stations.csv", [["id", "x", "y"]] + [[g, chance.uniform(0, 500), chance.uniform(0, 500)]
                                                             for g in gauges])
        write(folder / "basins.csv", [["id", "WKT"], *(
            [f"b{i}{j}", f"POLYGON (({a} {b}, {a + 100} {b}, {a + 100} {b + 100}, {a} {b + 100}, {a} {b}))"]
            for i in range(5) for j in range(5) for a, b in [(100 * i, 100 * j)])])
        days = said.hours // 24
        with open(folder / "fine.csv", "w", encoding="utf-8") as table, \
                open(folder / "all.csv", "w", encoding="utf-8") as whole, \
                open(folder / "totals.csv", "w", encoding="utf-8") as totals:
            table.write("time," + ",".join(fine) + "\n")
            whole.write("time," + ",".join(gauges) + "\n")
            totals.write("date," + ",".join(coarse) + "\n")
            for day in range(days):
                date = (datetime.date(2000, 1, 1) + datetime.timedelta(day)).isoformat()
                is_wet = chance.random() < .5
                for hour in range(24):
                    rain = [f"{chance.random() * 3:.1f}" if is_wet and chance.random() < .3 else "0" for _ in gauges]
                    time = f"{date}T{hour:02}:00,"
                    whole.write(time + ",".join(rain) + "\n")
                    table.write(time + ",".join(r for i, r in enumerate(rain) if i % 3) + "\n")
                totals.write(f"{date}," + ",".join(f"{chance.random() * 20:.1f}" if is_wet else "0" for _ in coarse) + "\n")
        common = ["rain", "stations.csv", "basins.csv"]
        rest = ["--metric", "planar", "--overwrite", "-q", "-o", "rain.csv"]
        for _ in range(said.rounds):
            alone = run(said.program, folder, *common, "fine.csv", *rest)[0]
            hourly = run(said.program, folder, *common, "all.csv", *rest)[0]
            both = run(said.program, folder, *common, "fine.csv", "--totals", "totals.csv", "--observed-at", "24:00",
                       *rest)[0]
            print(f"rain of the hourly gauges {alone:.2f} s, of all as hourly {hourly:.2f} s, with --totals {both:.2f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--speed", action="store_true")
    parser.add_argument("--gauges", type=int, default=1000)
    parser.add_argument("--hours", type=int, default=50_000)
    parser.add_argument("stations", nargs="?")
    parser.add_argument("hourly", nargs="?")
    said = parser.parse_args()
    if said.speed:
        speed(said)
    else:
        accuracy(said)


if __name__ == "__main__":
    main()
