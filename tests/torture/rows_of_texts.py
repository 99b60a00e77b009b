"""T045 to T076: CSV, polygons and GeoJSON, coordinate reference systems."""

import json
import math
import random
import shutil
import subprocess

from harness import PLANAR, geojson, row, small_study, square

for number, about in ((45, "marks, line ends and empty files"), (46, "encodings"), (47, "a NUL byte in a field"),
                      (48, "a quote that is never closed"), (49, "quotes"), (50, "too few and too many columns, headers"),
                      (51, "separators and decimal commas"), (52, "endless lines, a million columns, huge fields"),
                      (53, "a million bad rows"), (55, "numbers that are none"),
                      (56, "no features, no geometry, other geometries"), (57, "rings that are not closed, spikes"),
                      (58, "rings that cross and touch themselves"), (59, "rings in either direction"),
                      (65, "positions that are none"), (70, "no CRS, a CRS by name or link, two of them"),
                      (71, "CRS that are none"), (72, "the order of axes"), (73, "far outside of a UTM zone"),
                      (74, "feet, Gauss-Krueger, datums, no database")):
    row(number, about)(lambda t, name=f"T{number:03}": t.golden(name))


@row(54, "odd and duplicate ids")
def _(t):
    t.golden("T054")
    names = ["a b", 'q"q', "\N{RAINBOW}", "\u202ertl", "x" * 300, "../x", "NULL", "%s%n"]
    rows = "".join('"{}",{},{}\n'.format(name.replace('"', '""'), i, i % 3) for i, name in enumerate(names))
    t.write("stations.csv", "id,x,y\n" + rows)
    t.basins(square(-1, -1, 10, 10))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).weights().get("B1", {})
    t.hold(set(found) == set(names), f"ids are changed: {sorted(found)[:4]}")


@row(60, "basins smaller than a cell, than 1 mm2, thinner than a unit in the last place")
def _(t):
    t.stations([(2.0, 2.0), (8.0, 8.0)])
    t.basins(square(1, 1, 1.001, 1.001), square("1.0", "1.0", "1.0005", "1.0005"))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).weights()
    t.hold(all(found.get(b) == {"S0": 1.0} for b in ("B1", "B2")), f"weights are {found}")
    t.basins(f"POLYGON ((1 1, 2 1, 2 {math.nextafter(1, 2)!r}, 1 1))")
    ran = t.run("weights", "stations.csv", "basin.csv", *PLANAR)
    t.hold(ran.status in (0, 1), f"exit {ran.status}")


@row(61, "basins along the edges of cells, vertices on vertices, stations on the outline")
def _(t):
    t.stations([(float(x), float(y)) for x in (0, 2, 4) for y in (0, 2, 4)])
    t.basins(square(0, 0, 1, 4), square(1, 0, 3, 4), square(3, 0, 4, 4), square(0, 0, 4, 4), square(1, 1, 3, 3))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).rows()
    areas = {}
    for line in found:
        areas[line["basin"]] = areas.get(line["basin"], 0) + float(line["area"])
    t.hold({b: round(a, 12) for b, a in areas.items()} == {"B1": 4, "B2": 8, "B3": 4, "B4": 16, "B5": 4},
           f"areas are {areas}")


def koch(order):
    """A closed curve of 3 * 4^order points."""
    turn = complex(0.5, -math.sqrt(3) / 2)
    places = [complex(0, 0), complex(0.5, math.sqrt(3) / 2), complex(1, 0)]
    for _ in range(order):
        longer = []
        for a, b in zip(places, places[1:] + places[:1]):
            third = (b - a) / 3
            longer += [a, a + third, a + third + third * turn.conjugate(), a + 2 * third]
        places = longer
    return [(z.real, z.imag) for z in places]


@row(62, "a coast of many vertices, a thousand islands, a thousand holes")
def _(t):
    outline = koch(9 if t.options.long else 7)
    doubled = abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1])))
    shape = "POLYGON ((" + ", ".join(f"{x!r} {y!r}" for x, y in [*outline, outline[0]]) + "))"
    draw = random.Random(62)
    t.stations([(draw.random(), draw.random()) for _ in range(200)])
    cell = "{0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}"
    small = [cell.format(i / 40 + 0.004, j / 25 + 0.004, i / 40 + 0.02, j / 25 + 0.03) for i in range(40) for j in range(25)]
    islands = "MULTIPOLYGON (" + ", ".join(f"(({c}))" for c in small) + ")"
    holes = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0), " + ", ".join(f"({c})" for c in small) + ")"
    t.basins(shape, islands, holes)
    areas = {}
    for line in t.done("weights", "stations.csv", "basin.csv", *PLANAR).rows():
        areas[line["basin"]] = areas.get(line["basin"], 0) + float(line["area"])
    wanted = {"B1": doubled / 2, "B2": 1000 * 0.016 * 0.026, "B3": 1 - 1000 * 0.016 * 0.026}
    t.hold(all(abs(areas.get(b, 0) - a) < 1e-11 for b, a in wanted.items()), f"areas are {areas}, {wanted} wanted")


@row(63, "basins that overlap, adjoin, are the same")
def _(t):
    draw = random.Random(63)
    t.stations([(10 * draw.random(), 10 * draw.random()) for _ in range(30)])
    t.basins(square(0, 0, 5, 10), square(5, 0, 10, 10), square(0, 0, 10, 10), square(0, 0, 10, 10), square(3, 3, 8, 8))
    found = {}
    for line in t.done("weights", "stations.csv", "basin.csv", *PLANAR).rows():
        found.setdefault(line["basin"], {})[line["station"]] = float(line["area"])
    t.hold(found["B3"] == found["B4"], "two basins of one shape differ")
    t.hold(all(abs(found["B1"].get(s, 0) + found["B2"].get(s, 0) - a) < 1e-12 for s, a in found["B3"].items()),
           "halves do not add up")


@row(64, "basins over the antimeridian and round a pole")
def _(t):
    t.golden("T064")


@row(66, "GeoJSON cut at every byte")
def _(t):
    t.golden("T066")
    t.stations([(2.0, 2.0), (8.0, 8.0)], head="id,lon,lat")
    whole = geojson([[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]])
    for length in range(0, len(whole), 1 if t.options.long else 23):
        t.write("basin.geojson", whole[:length])
        t.fails("weights", "stations.csv", "basin.geojson")


@row(67, "JSON of keys twice, depth, length, bad escapes, trailing bytes")
def _(t):
    t.golden("T067")
    t.stations([(2.0, 2.0), (8.0, 8.0)], head="id,lon,lat")
    box = [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]
    whole = geojson(box)
    t.write("basin.geojson", whole.replace('"id": "B1"', '"id": "\\q"'))
    t.fails("weights", "stations.csv", "basin.geojson")
    t.write("basin.geojson", "\x1e" + whole + "\n\x1e" + whole)
    t.run("weights", "stations.csv", "basin.geojson")
    t.write("basin.geojson", whole.replace('"B1"', '"' + "x" * 30_000_000 + '"'))
    t.run("weights", "stations.csv", "basin.geojson", seconds=30, megabytes=1500)


@row(68, "outputs read by other readers")
def _(t):
    study, _ = small_study(t)
    t.done("cells", *study, *PLANAR, "-o", "cells.geojson")
    text = t.read("cells.geojson").decode()
    ours = json.loads(text)
    for feature in ours["features"]:
        for outer in [feature["geometry"]["coordinates"][0]]:
            doubled = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outer, outer[1:]))
            t.hold(doubled > 0, f"the ring of {feature['properties']['station']} runs clockwise")
    if shutil.which("jq"):
        told = subprocess.run(["jq", "-c", "[.features[].properties.weight]", "cells.geojson"], cwd=t.folder, text=True,
                              capture_output=True, check=True).stdout
        t.hold(json.loads(told) == [f["properties"]["weight"] for f in ours["features"]], "jq reads other weights")
    if shutil.which("ogrinfo"):
        told = subprocess.run(["ogrinfo", "-ro", "-al", "-so", "cells.geojson"], cwd=t.folder, text=True,
                              capture_output=True, check=False).stdout
        t.hold(f"Feature Count: {len(ours['features'])}" in told, f"ogrinfo says {told[:200]}")


@row(69, "near vertices and decimals")
def _(t):
    t.write("stations.csv", "id,lon,lat\nA,10,50\nB,10.00000002,50\nC,10.00000002,50.00000002\nD,10.1,50.1\n")
    t.write("basin.geojson", geojson([[[9.9, 49.9], [10.2, 49.9], [10.2, 50.2], [9.9, 50.2], [9.9, 49.9]]]))
    t.cells_are_valid("stations.csv", "basin.geojson")


@row(75, "areas of cells add up to the basin's")
def _(t):
    draw = random.Random(75)
    many = 2000 if t.options.long else 100
    boxes = []
    for _ in range(many):
        lon, lat, size = draw.uniform(-170, 160), draw.uniform(-80, 70), draw.uniform(0.01, 8)
        boxes.append(square(lon, lat, lon + size, lat + size))
    t.basins(*boxes)

    def areas(count):
        t.stations([(draw.uniform(-180, 180), draw.uniform(-85, 85)) for _ in range(count)], head="id,lon,lat")
        found = {}
        for line in t.done("weights", "stations.csv", "basin.csv").rows():
            area = next(value for name, value in line.items() if name.startswith("area"))
            found[line["basin"]] = found.get(line["basin"], 0) + float(area)
        return found
    whole, parted = areas(1), areas(3000)
    worst = max(abs(parted[b] / a - 1) for b, a in whole.items())
    t.hold(worst < 1e-9, f"the areas of cells differ by {worst} from the basin's")


@row(76, "a continent and the Earth")
def _(t):
    t.golden("T076", "T064")
    t.write("stations.csv", "id,lon,lat\nA,0,10\nB,60,20\nC,120,-30\n")
    t.write("basin.geojson", geojson([[[-20, -40], [140, -40], [140, 60], [-20, 60], [-20, -40]]]))
    ran = t.done("weights", "stations.csv", "basin.geojson", *PLANAR)
    t.hold("warning" in ran.err and any(c.isdigit() for c in ran.err), "planar degrees are not warned of with a figure")
