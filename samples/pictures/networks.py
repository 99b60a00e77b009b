#!/usr/bin/env python3
"""Networks for pictures, the same each time: networks.py FOLDER

one.csv, three.csv and twenty_five.csv in a plane, with a basin in basin.csv; scripts.csv, eight gauges with names in
eight scripts; globe.csv, 24,285 gauges strewn evenly over the Earth (earth.csv). Beside each, as in one_rain.csv, its readings.
"""

import math
import pathlib
import random
import sys

BASIN = 'id,WKT\nbasin,"POLYGON ((0 0,120 0,120 80,0 80,0 0))"\n'
EARTH = 'id,WKT\nEarth,"POLYGON ((-180 -90,180 -90,180 90,-180 90,-180 -90))"\n'
NAMES = ["Ärmelkanal", "Θεσσαλονίκη", "Санкт-Петербург", "القاهرة", "ירושלים", "दिल्ली", "กรุงเทพ", "東京"]


def network(draw, count):
    places = [(round(draw.uniform(4, 116), 1), round(draw.uniform(4, 76), 1)) for _ in range(count)]
    # Rain of a shower, deepest at (40, 50).
    rain = [round(60 * math.exp(-((x - 40) ** 2 + (y - 50) ** 2) / 900) + draw.uniform(0, 3), 1) for x, y in places]
    return places, rain


def write(folder, name, header, stations, rain):
    lines = [",".join(map(str, station)) for station in stations]
    (folder / f"{name}.csv").write_text("\n".join([header, *lines]) + "\n", encoding="utf-8")
    ids = ",".join(str(station[0]) for station in stations)
    (folder / f"{name}_rain.csv").write_text(f"time,{ids}\na shower,{','.join(map(str, rain))}\n")


def globe(draw):
    stations, rain = [], []
    for i in range(24285):
        lat = math.degrees(math.asin(draw.uniform(-1, 1)))
        lon = draw.uniform(-180, 180)
        wet = 120 * math.cos(math.radians(lat)) ** 4 * (1 + math.sin(math.radians(2 * lon)) / 2)
        stations.append((i + 1, f"{lon:.4f}", f"{lat:.4f}"))
        rain.append(round(wet + draw.uniform(0, 15), 1))
    return stations, rain


def main(folder):
    draw = random.Random(1908)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "basin.csv").write_text(BASIN)
    for name, count in (("one", 1), ("three", 3), ("twenty_five", 25), ("scripts", 8)):
        places, rain = network(draw, count)
        stations = [(f"G{i + 1}", x, y, NAMES[i % len(NAMES)]) for i, (x, y) in enumerate(places)]
        write(folder, name, "id,x,y,name", stations, rain)
    (folder / "earth.csv").write_text(EARTH)
    write(folder, "globe", "id,lon,lat", *globe(draw))


main(pathlib.Path(sys.argv[1]))
