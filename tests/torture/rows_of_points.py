"""T001 to T044: sets of points, coordinates and values."""

import math
import random

from harness import PLANAR, row, square

TENTHS = [i / 10 for i in range(20)]


def turned(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [(c * x - s * y, s * x + c * y) for x, y in points]


def ring(count, radius=1.0, at=(0.0, 0.0)):
    return [(at[0] + radius * math.cos(2 * math.pi * i / count), at[1] + radius * math.sin(2 * math.pi * i / count))
            for i in range(count)]


def on_lattice_circle():
    """The whole points at distance 325 of the origin."""
    found = []
    for x in range(-325, 326):
        y = math.isqrt(325 * 325 - x * x)
        if x * x + y * y == 325 * 325:
            found += [(float(x), float(y))] + ([(float(x), float(-y))] if y else [])
    return found


@row(1, "no stations")
def _(t):
    t.stations([])
    t.basins(square(0, 0, 10, 10))
    t.fails("weights", "stations.csv", "basin.csv", *PLANAR, says="no stations")


@row(2, "one station")
def _(t):
    t.exact([(2.0, 5.0)], (0.0, 0.0, 10.0, 10.0), 0)


@row(3, "two stations")
def _(t):
    t.exact([(2.0, 5.0), (6.0, 5.0)], (0.0, 0.0, 10.0, 10.0), 1e-15)


@row(4, "three stations on a line")
def _(t):
    t.exact([(1.0, 1.0), (2.0, 2.0), (4.0, 4.0)], (0.0, 0.0, 10.0, 10.0))
    said = t.done("check", "stations.csv", "basin.csv", *PLANAR)
    t.hold("line" in said.err + said.out, "nothing says that the stations lie on one line")


@row(5, "fifty whole points on a line")
def _(t):
    t.exact([(float(i), 2.0 * i) for i in range(50)], (-10.0, -10.0, 60.0, 120.0))


@row(6, "fifty tenths on a line, which are none as doubles")
def _(t):
    t.exact([(i / 10, 3 * i / 10) for i in range(50)], (-1.0, -1.0, 6.0, 20.0))


def table_of(text):
    """A printed tessellation by its places: the points, and the triangles as sets of places."""
    places, vertices = {}, set()
    for line in text.splitlines():
        words = line.split()
        if words and words[0] == "point":
            places[words[1]] = tuple(words[2:])
        elif words and words[0] == "vertex":
            at = words.index("forming") + 1
            vertices.add(frozenset(places.get(w, w) for w in words[at:words.index("neighbors")]))
    return set(places.values()), vertices


def same_as_rebuilt(t, lines, dim=2):
    """What the operations leave is what the remaining points give when they are loaded at once."""
    ran = t.session(*lines, "check", "print left.txt", dim=dim)
    t.hold("sound:" in ran.out, f"not sound: {ran.out[-100:]} {ran.err[-100:]}")
    left = table_of(t.read("left.txt").decode())
    t.write("points.csv", "".join(",".join(place) + "\n" for place in sorted(left[0])))
    t.session("load points.csv", "print rebuilt.txt", dim=dim)
    t.hold(left == table_of(t.read("rebuilt.txt").decode()), "the state is another than rebuilt")


@row(7, "a line and one point off it, which goes away again")
def _(t):
    add = [f"add {i} {i}" for i in range(6)]
    same_as_rebuilt(t, [*add, "add 1 4", "delete 1 4"])
    same_as_rebuilt(t, [*add, "add 1 4", "delete 1 4", "undo", "undo", "redo"])


@row(8, "stations at one place")
def _(t):
    t.write("stations.csv", "id,x,y\nA,2,5\nB,2,5\nC,6,5\n")
    t.basins(square(0, 0, 10, 10))
    ran = t.done("weights", "stations.csv", "basin.csv", *PLANAR)
    found = ran.weights().get("B1", {})
    t.hold([found.get(s) for s in "ABC"] == [0.2, 0.2, 0.6], f"weights are {found}")
    t.hold("warning" in ran.err and "A" in ran.err and "B" in ran.err, "no warning names both")


@row(9, "stations at one place with other readings, one silent")
def _(t):
    t.write("stations.csv", "id,x,y\nA,2,5\nB,2,5\nC,6,5\n")
    t.basins(square(0, 0, 10, 10))
    t.write("rain.csv", "time,A,B,C\n1,10,20,0\n2,10,,0\n")
    found = t.done("rain", "stations.csv", "basin.csv", "rain.csv", *PLANAR).rows()
    t.hold([float(r["B1"]) for r in found] == [6.0, 4.0], f"rain is {found}")


@row(10, "a zero with a sign")
def _(t):
    t.write("stations.csv", "id,x,y\nA,-0.0,5\nB,0.0,5\nC,6,5\n")
    t.basins(square(-10, 0, 10, 10))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).weights().get("B1", {})
    t.hold(found.get("A") == found.get("B"), f"-0.0 and 0.0 are two places: {found}")


@row(11, "pairs one unit in the last place apart")
def _(t):
    x = math.nextafter(3.0, 4)
    t.exact([(3.0, 5.0), (x, 5.0), (8.0, 2.0)], (0.0, 0.0, 10.0, 10.0), 1e-12)


@row(12, "pairs 1e-12, 1e-9 and 1e-6 apart")
def _(t):
    t.exact([(x + d, y) for x, y in ((2.0, 2.0), (7.0, 3.0), (4.0, 8.0)) for d in (0, 1e-12, 1e-9, 1e-6)],
            (0.0, 0.0, 10.0, 10.0))


@row(13, "a cluster of 8 x 8 units in the last place, and four corners")
def _(t):
    unit = 2.0 ** -52
    cluster = [(1 + i * unit, 1 + j * unit) for i in range(8) for j in range(8)]
    places = cluster + [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    t.exact(places, (0.0, 0.0, 2.0, 2.0))
    t.sound(places)


@row(14, "points about 0.5, one unit in the last place apart")
def _(t):
    unit = 2.0 ** -53
    places = [(0.5 + i * unit, 0.5 + j * unit) for i in range(6) for j in range(6)] + [(12.0, 12.0), (24.0, 24.0)]
    t.exact(places, (0.0, 0.0, 24.0, 24.0))
    t.sound(places)


@row(15, "a lattice of 20 x 20")
def _(t):
    t.stations([(float(i), float(j)) for i in range(20) for j in range(20)])
    t.basins(square(-0.5, -0.5, 19.5, 19.5))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).weights().get("B1", {})
    t.hold(len(found) == 400 and all(abs(w - 1 / 400) < 1e-12 for w in found.values()), "cells are not equal")
    t.cells_are_valid("stations.csv", "basin.csv", *PLANAR)


@row(16, "a lattice in tenths")
def _(t):
    t.sound([(x, y) for x in TENTHS for y in TENTHS])


@row(17, "a lattice turned by 0.3 radians")
def _(t):
    t.sound(turned([(float(i), float(j)) for i in range(20) for j in range(20)], 0.3))


@row(18, "a lattice of 100 x 100 turned by 302.328 degrees")
def _(t):
    t.sound(turned([(float(i), float(j)) for i in range(100) for j in range(100)], math.radians(302.328)))


@row(19, "points on a circle, with and without its centre")
def _(t):
    for places in (ring(17), on_lattice_circle(), ring(200)):
        t.sound(places)
        t.sound([*places, (0.0, 0.0)])
    t.stations(on_lattice_circle())
    t.basins(square(-400, -400, 400, 400))
    t.cells_are_valid("stations.csv", "basin.csv", *PLANAR)


@row(20, "a circle in UTM coordinates")
def _(t):
    t.sound(ring(100, 325.0, (5e5, 4e6)))
    t.stations(ring(64, 325.0, (5e5, 4e6)))
    t.basins(square(499000, 3999000, 501000, 4001000))
    t.cells_are_valid("stations.csv", "basin.csv", *PLANAR)


@row(21, "small sets that broke other tools")
def _(t):
    for places in (
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
        [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0), (1.5, 0.5)],
        [(0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 1e-9), (2.0, 3.0)],
        [(x, y) for x in (0.0, 1e-7, 1.0) for y in (0.0, 1.0)],
        [(1 / 3, 1 / 7), (2 / 3, 1 / 7), (1 / 3, 2 / 7), (2 / 3, 2 / 7)],
        [(100.0 + d, 100.0) for d in (0, 1e-13, 50.0)],
    ):
        t.exact(places, (-200.0, -200.0, 200.0, 200.0))


@row(22, "81 points of a parabola")
def _(t):
    places = [(float(i), float(i * i)) for i in range(-40, 41)]
    t.sound(places)
    t.exact(places, (-100.0, -100.0, 100.0, 2000.0))


@row(23, "a hull that curves by 1e-12")
def _(t):
    places = [(float(i), 1e-12 * i * i) for i in range(40)]
    t.sound(places)
    t.exact(places, (-10.0, -10.0, 50.0, 10.0))


@row(24, "two clusters 1e-3 wide, 1e6 apart")
def _(t):
    draw = random.Random(24)
    t.exact([(at + draw.random() * 1e-3, draw.random() * 1e-3) for at in (0.0, 1e6) for _ in range(15)],
            (-1e6, -1e6, 2e6, 1e6))


@row(25, "a needle of 1e6 by 1e-6")
def _(t):
    draw = random.Random(25)
    t.exact([(draw.random() * 1e6, draw.random() * 1e-6) for _ in range(30)], (0.0, 0.0, 1e6, 1e-6))


@row(26, "scales from 1e-8 to 1e8")
def _(t):
    t.exact([(s * 10.0 ** k, r * 10.0 ** k) for k in range(-8, 9, 2) for s, r in ((1, 0), (-1, 1), (0, -1))],
            (-2e8, -2e8, 2e8, 2e8))


@row(27, "one set in every order")
def _(t):
    draw = random.Random(27)
    places = [(draw.random(), draw.random()) for _ in range(300)]
    seen = set()
    for order in (places, sorted(places), sorted(places, reverse=True), sorted(places, key=lambda p: math.atan2(*p)),
                  draw.sample(places, len(places))):
        t.points(order)
        t.session("load points.csv", "print out.txt")
        seen.add(frozenset(table_of(t.read("out.txt").decode())[1]))
    t.hold(len(seen) == 1, "another order gives another topology")


@row(28, "many points: uniform, clustered, on a circle, on a diagonal")
def _(t):
    draw = random.Random(28)
    many = 1_000_000 if t.options.long else 200_000
    few = 100_000 if t.options.long else 30_000
    for places in ([(draw.random(), draw.random()) for _ in range(many)],
                   [(k % 10 + draw.gauss(0, 1e-4), draw.gauss(0, 1e-4)) for k in range(many)], ring(few),
                   [(float(i), float(i)) for i in range(few)]):
        t.points(places)
        ran = t.session("load points.csv", "nearest 0.5 0.5", seconds=20)
        t.hold(ran.status == 0, f"{len(places)} points: {ran.err[-100:]}")


@row(29, "insertions, deletions, undo and redo at random")
def _(t):
    draw = random.Random(29)
    for dim in (2, 3):
        for _ in range(3):
            there, lines = [], []
            for _ in range(100_000 if t.options.long else 400):
                what = draw.random()
                if what < 0.5 or not there:
                    there.append(" ".join(repr(draw.random()) for _ in range(dim)))
                    lines.append("add " + there[-1])
                elif what < 0.8:
                    lines.append("delete " + there.pop(draw.randrange(len(there))))
                else:
                    steps = draw.randrange(1, 4)
                    lines += ["undo"] * min(steps, len(lines)) + ["redo"] * min(steps, len(lines))
            same_as_rebuilt(t, lines, dim)
            t.session(*lines, *(f"delete {p}" for p in there), "check", "add " + " ".join("1" * dim), "check", dim=dim)
    ran = t.session("add 1 1", "undo", "add 2 2", "redo", "print")
    t.hold("redo" in ran.err or "nothing" in ran.err, "a redo after a new edit is not refused")


@row(30, "removed twice, undone past the beginning, an unknown point")
def _(t):
    for lines in (["add 1 2", "delete 1 2", "delete 1 2"], ["undo"], ["add 1 2", "delete 3 4"]):
        ran = t.session(*lines, "print")
        t.hold(ran.status == 1 and "error" in ran.err, f"{lines}: exit {ran.status}: {ran.err}")
    t.golden("T030")


@row(31, "degenerate sets in space")
def _(t):
    gold = (1 + 5 ** 0.5) / 2
    corners = [(float(i), float(j), float(k)) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    icosahedron = [p for a in (-1.0, 1.0) for b in (-gold, gold) for p in ((0.0, a, b), (a, b, 0.0), (b, 0.0, a))]
    lattice = [(float(i), float(j), float(k)) for i in range(10) for j in range(10) for k in range(10)]
    flat = [(float(i), float(j), 0.0) for i in range(5) for j in range(5)]
    line = [(float(i), 2.0 * i, 3.0 * i) for i in range(9)]
    slivers = [(math.cos(i), math.sin(i), (-1) ** i * 1e-9) for i in range(12)]
    columns = [(x, y, z) for x, y in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)) for z in (0.0, 1e-9, 5.0)]
    for places, dimension in ((corners, 3), (icosahedron, 3), (lattice, 3), (flat, 2), (line, 1), (slivers, 3),
                              (columns, 3)):
        ran = t.sound(places, 3)
        t.hold(f"dimension {dimension}" in ran.out, f"{ran.out.strip()} of dimension {dimension}")


for number, about in ((32, "coordinates that are no finite numbers"), (33, "latitude and longitude swapped, or beyond 90"),
                      (34, "longitudes beyond 180"), (37, "metres given as degrees, degrees as metres"),
                      (40, "numbers in every form"), (41, "what stands for a missing reading"),
                      (42, "negative and absurd rain"), (43, "a step in which nobody reports"),
                      (44, "one station inside, the rest far outside")):
    row(number, about)(lambda t, name=f"T{number:03}": t.golden(name))




@row(35, "neighbours across the date line")
def _(t):
    t.write("stations.csv", "id,lon,lat\nA,179.9999999,0\nB,-179.9999999,0\nC,-180,1\nD,180,-1\n")
    t.basins("POLYGON ((179 -2, 181 -2, 181 2, 179 2, 179 -2))")
    found = t.done("weights", "stations.csv", "basin.csv").weights().get("B1", {})
    t.hold(abs(found.get("A", 0) - found.get("B", 1)) < 1e-6 and abs(sum(found.values()) - 1) < 1e-9,
           f"weights across the date line are {found}")


@row(36, "at the poles")
def _(t):
    t.write("stations.csv", "id,lon,lat\nN,0,90\nA,0,80\nB,120,80\nC,-120,80\nD,7,89.999999\n")
    t.basins("POLYGON ((0 75, 90 75, 180 75, 270 75, 360 75, 360 90, 0 90, 0 75))")
    found = t.done("weights", "stations.csv", "basin.csv").weights().get("B1", {})
    t.hold(abs(sum(found.values()) - 1) < 1e-9 and abs(found.get("B", 0) - found.get("C", 1)) < 1e-4,
           f"weights round the pole are {found}")
    t.golden("T064")


def out_of_range(t, value):
    t.stations([(value, value), (2 * value, value), (value, 3 * value)])
    t.basins(square(0, 0, *(repr(3 * value),) * 2))
    ran = t.run("weights", "stations.csv", "basin.csv", *PLANAR)
    if ran.status == 0:
        weights = list(ran.weights()["B1"].values())
        t.hold(abs(sum(weights) - 1) < 1e-9, f"{value}: weights are {weights}")
    else:
        t.hold(ran.status == 1 and "range" in ran.err, f"{value}: exit {ran.status}: {ran.err[-150:]}")


@row(38, "the smallest numbers")
def _(t):
    for value in (5e-324, 1e-300, 1e-150, 1e-20):
        out_of_range(t, value)
    t.golden("T038")


@row(39, "the largest numbers")
def _(t):
    for value in (1e12, 1e15, 1e100, 1e160, 5e307):
        out_of_range(t, value)
    for at, tolerance in ((1e6, 1e-9), (1e9, 1e-6)):
        t.exact([(at + i, at + j) for i in range(4) for j in range(4)], (at - 1, at - 1, at + 4, at + 4), tolerance)
    for at in (1e12, 1e15):
        t.stations([(at + i, at + j) for i in range(4) for j in range(4)])
        t.basins(square(repr(at - 1), repr(at - 1), repr(at + 4), repr(at + 4)))
        ran = t.run("weights", "stations.csv", "basin.csv", *PLANAR)
        ends = {0: 2.25 / 25, 5: 1 / 25}
        ok = ran.status == 1 or all(abs(ran.weights()["B1"].get(f"S{i}", 0) - w) < 1e-6 for i, w in ends.items())
        t.hold(ok, f"a lattice of spacing 1 at {at}: weights are {ran.weights() if ran.status == 0 else ''}")
    t.golden("T039")
