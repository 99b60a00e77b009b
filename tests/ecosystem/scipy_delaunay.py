"""Delaunay triangles and borders in a plane, by scipy: scipy_delaunay.py FOLDER"""

import csv
import json
import math
import os
import pathlib
import random
import subprocess
import sys

import numpy
from scipy.spatial import Delaunay, Voronoi

work = pathlib.Path(sys.argv[1])
program = os.environ["THIESSEN"]


def thiessen(*words, **more):
    return subprocess.run([program, *words], cwd=work, check=True, **more)


rng = random.Random(17)
points = [(rng.uniform(0, 1e5), rng.uniform(0, 1e5)) for _ in range(2000)]
with open(work / "stations.csv", "w", encoding="utf-8") as file:
    file.write("id,x,y\n")
    file.writelines(f"g{i},{x!r},{y!r}\n" for i, (x, y) in enumerate(points))
thiessen("cells", "stations.csv", "--metric", "planar", "--delaunay", "triangles.geojson", "--neighbours",
         "neighbours.csv", "--quiet")

with open(work / "triangles.geojson", encoding="utf-8") as file:
    features = json.load(file)["features"]
ours = {frozenset(feature["properties"][corner] for corner in "abc") for feature in features}
theirs = {frozenset(f"g{i}" for i in simplex) for simplex in Delaunay(numpy.array(points)).simplices}
assert len(ours) == len(features)
assert ours == theirs, f"{len(ours - theirs)} triangles are ours alone, {len(theirs - ours)} scipy's"
for feature in features:
    ring = feature["geometry"]["coordinates"][0]
    corners = [points[int(feature["properties"][corner][1:])] for corner in "abc"]
    assert [tuple(p) for p in ring] == corners + corners[:1]
    assert sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:])) > 0, "counter-clockwise"

voronoi = Voronoi(numpy.array(points))
lengths = {}
for (p, q), ends in zip(voronoi.ridge_points, voronoi.ridge_vertices):
    a, b = (voronoi.vertices[end] for end in ends)
    lengths[frozenset((f"g{p}", f"g{q}"))] = math.inf if -1 in ends else math.dist(a, b)
with open(work / "neighbours.csv", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
assert len(rows) == len(lengths)
for row in rows:
    length = lengths[frozenset((row["station"], row["neighbour"]))]
    assert float(row["length"]) == length or math.isclose(float(row["length"]), length, rel_tol=1e-6, abs_tol=1e-3), row

script = "".join(f"add {x!r} {y!r}\n" for x, y in points[:500])
script += "".join(f"delete {x!r} {y!r}\n" for x, y in points[100:300:3])
thiessen("tessel", "-", input=(script + "save saved.txt\ncells cells.csv\n").encode())
thiessen("tessel", "-", input=b"load saved.txt\nprint again.txt\n")
assert (work / "saved.txt").read_bytes() == (work / "again.txt").read_bytes()
with open(work / "cells.csv", encoding="utf-8") as file:
    assert len(list(csv.DictReader(file))) == 500 - len(points[100:300:3])
