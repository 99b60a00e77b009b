"""Random networks and basins in the plane against exact arithmetic: weights, and rain with silent gauges.

The basins are not convex, have holes and parts, and share corners, edges and bisectors with the gauges' grid, because
all coordinates are small whole numbers. Run one again with its seed: THIESSEN_SEED=17 random_planes_test.py
"""

import math
import os
import random
import unittest
from fractions import Fraction

import exact
from thiessen import ProgramTest, table, weights_of

SEEDS = [int(os.environ["THIESSEN_SEED"])] if "THIESSEN_SEED" in os.environ else range(1, 26)
LARGEST_READING = 90


def star(rng, centre, radius, corners, widest):
    """A ring of whole numbers round a centre that sees all of it, counter-clockwise.

    widest: the largest angle, in radians, at which the centre may see an edge.
    """
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(corners))
    steps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + 2 * math.pi])]
    if max(steps) > widest:
        return star(rng, centre, radius, corners, widest)
    reach = [rng.uniform(0.55, 1) * radius for _ in angles]
    ring = [(centre[0] + round(r * math.cos(a)), centre[1] + round(r * math.sin(a)))
            for r, a in zip(reach, angles)]
    ring = [p for i, p in enumerate(ring) if p != ring[i - 1]]
    turns = [(a[0] - centre[0]) * (b[1] - centre[1]) - (a[1] - centre[1]) * (b[0] - centre[0])
             for a, b in zip(ring, ring[1:] + ring[:1])]
    return ring if min(turns) > 0 else star(rng, centre, radius, corners, widest)


def square(x, y, half):
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def some_basin(rng):
    """Polygons of two parts, the first with a hole: [[outer, hole], [outer]]."""
    hole = square(30, 30, rng.randint(2, 5))[::-1]
    return [[star(rng, (30, 30), 27, rng.randint(12, 30), 1.2), hole],
            [star(rng, (85, 40), 20, rng.randint(5, 12), 2.5)]]


def wkt(polygons):
    def ring(points):
        return "(" + ", ".join(f"{x} {y}" for x, y in [*points, points[0]]) + ")"
    return "MULTIPOLYGON (" + ", ".join("(" + ", ".join(map(ring, part)) + ")" for part in polygons) + ")"


class RandomPlanes(ProgramTest):
    def network(self, seed):
        rng = random.Random(seed)
        places = set()
        count = rng.choice([1, 2, 3, 5, 10, 40])
        while len(places) < count:
            places.add((rng.randint(-10, 120), rng.randint(-10, 80)))
        places = sorted(places)
        rng.shuffle(places)
        gauges = {f"g{i}": (Fraction(x), Fraction(y)) for i, (x, y) in enumerate(places)}
        basins = {"north": some_basin(rng), "south": some_basin(rng)}
        self.write("stations.csv", "id,x,y\n" + "".join(f"{g},{x},{y}\n" for g, (x, y) in gauges.items()))
        self.write("basins.csv", "id,WKT\n" + "".join(f'{b},"{wkt(p)}"\n' for b, p in basins.items()))
        return rng, gauges, {name: [ring for part in parts for ring in part] for name, parts in basins.items()}

    def test_weights(self):
        for seed in SEEDS:
            with self.subTest(again=f"THIESSEN_SEED={seed}"):
                _, gauges, basins = self.network(seed)
                found = weights_of(self.output("weights", "stations.csv", "basins.csv"))
                for basin, rings in basins.items():
                    expected = exact.weights(gauges, rings)
                    self.assertEqual(list(found[basin]), list(expected))
                    for gauge, weight in expected.items():
                        self.assertAlmostEqual(found[basin][gauge], float(weight), delta=1e-12)

    def rain(self, gauges, steps, policy):
        lines = ["time," + ",".join(gauges)]
        lines += [f"{i}," + ",".join(str(step.get(g, "")) for g in gauges) for i, step in enumerate(steps)]
        self.write("rainfall.csv", "\n".join(lines) + "\n")
        return table(self.output("rain", "stations.csv", "basins.csv", "rainfall.csv", "--gaps", policy,
                                 "--decimals", 12))

    def assert_rain(self, found, expected):
        if expected is None:
            self.assertEqual(found, "")
        else:
            self.assertAlmostEqual(float(found), float(expected), delta=LARGEST_READING * 1e-12)

    def test_rain_with_silent_gauges(self):
        for seed in list(SEEDS)[:10]:
            with self.subTest(again=f"THIESSEN_SEED={seed}"):
                rng, gauges, basins = self.network(seed)
                steps = [{g: rng.randint(0, LARGEST_READING) for g in gauges if rng.random() < share}
                         for share in (1, 0.7, 0.3, 0)]
                anew = self.rain(gauges, steps, "retessellate")
                scaled = self.rain(gauges, steps, "renormalise")
                strict = self.rain(gauges, steps, "strict")
                for basin, rings in basins.items():
                    full = exact.weights(gauges, rings)
                    for i, step in enumerate(steps):
                        again = exact.weights({g: gauges[g] for g in gauges if g in step}, rings)
                        self.assert_rain(anew[i][basin], mean(again, step))
                        self.assert_rain(scaled[i][basin], mean(full, step))
                        whole = all(g in step for g in full)
                        self.assert_rain(strict[i][basin], mean(full, step) if whole else None)


def mean(weights, step):
    """The mean by these weights of the gauges that report, scaled to them; None where none does."""
    reporting = {g: w for g, w in weights.items() if g in step}
    total = sum(reporting.values())
    return sum(w * step[g] for g, w in reporting.items()) / total if total else None


if __name__ == "__main__":
    unittest.main()
