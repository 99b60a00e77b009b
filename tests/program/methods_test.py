"""The textbook case by every method, beside means over a fine lattice of values computed plainly:
inverse distances by the formula, natural neighbours by clipping half planes."""

import math
import unittest

from thiessen import SAMPLES, ProgramTest, table

GAUGES = [(7, 4), (3, 4), (-2, 5), (-10, 1), (-3, -3), (-7, -7), (2, -3), (2, -10), (0, 0)]
READINGS = [62, 59, 41, 39, 105, 98, 60, 41, 81]
BASIN = [(5, 5), (-5, 5), (-5, -5), (0, -10), (5, -5)]
FAR = 1e4


def nearer_to(ring, p, q):
    """The part of a convex ring that is nearer to p than to q."""
    def excess(v):
        return sum((p[k] - q[k]) * (2 * v[k] - p[k] - q[k]) for k in (0, 1))
    part = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        at_a, at_b = excess(a), excess(b)
        if at_a >= 0:
            part.append(a)
        if (at_a >= 0) != (at_b >= 0):
            t = at_a / (at_a - at_b)
            part.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    return part


def area(ring):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def cell(p, others, within):
    for q in others:
        if q != p:
            within = nearer_to(within, p, q)
    return within


def hull(points):
    """Counter-clockwise."""
    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and area([chain[-2], chain[-1], p]) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    ordered = sorted(points)
    return half(ordered) + half(ordered[::-1])


def is_inside(ring, p):
    return all(area([a, b, p]) > 0 for a, b in zip(ring, ring[1:] + ring[:1]))


def nearest(p):
    return READINGS[min(range(9), key=lambda i: math.dist(p, GAUGES[i]))]


def natural(p):
    if not is_inside(hull(GAUGES), p):
        return nearest(p)
    square = [(-FAR, -FAR), (FAR, -FAR), (FAR, FAR), (-FAR, FAR)]
    new = cell(p, GAUGES, square)
    shares = [area(cell(g, GAUGES, new)) for g in GAUGES]
    return sum(s * r for s, r in zip(shares, READINGS)) / sum(shares)


def inverse_distance(p):
    weights = [1 / math.dist(p, g) ** 2 for g in GAUGES]
    return sum(w * r for w, r in zip(weights, READINGS)) / sum(weights)


def lattice(step):
    """Every other row shifted, so that no point lies on the basin's edge."""
    rows = int(15 / step)
    for i in range(rows):
        for k in range(int(10 / step)):
            p = (-5 + step * (k + 0.25 + 0.5 * (i % 2)), -10 + step * (i + 0.5))
            if is_inside(BASIN, p):
                yield p


def mean(method, points):
    return sum(map(method, points)) / len(points)


class Methods(ProgramTest):
    def test_clipping_gives_the_fractions(self):
        self.assertAlmostEqual(natural((1, 1)), 980956849 / 13746548, delta=1e-6)

    def test_each_is_the_mean_of_its_values(self):
        files = (SAMPLES / "textbook" / f"{name}.csv" for name in ("stations", "basin", "rainfall"))
        row, = table(self.output("rain", *files, "--method", "all", "--grid", 20000, "--decimals", 9,
                                 "--quiet"))
        points = list(lattice(0.1))
        self.assertAlmostEqual(float(row["A_arithmetic"]), 346 / 5, delta=1e-9)
        self.assertAlmostEqual(float(row["A_idw"]), mean(inverse_distance, points), delta=0.01)
        self.assertAlmostEqual(float(row["A_natural"]), mean(natural, points), delta=0.02)


if __name__ == "__main__":
    unittest.main()
