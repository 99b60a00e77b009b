"""Normals that the program fits by elevation: what it says of gauges that are left out, beside the same
computed plainly; simulated rain whose normals are known; and rain that elevation does not tell."""

import csv
import math
import random
import re
import unittest

from thiessen import SAMPLES, ProgramTest, table

COLORADO = SAMPLES / "colorado"
# Round the gauges' middle, with the mean elevation of Colorado.
BASIN = 'id,elev,WKT\nB,2070,"POLYGON((-107 38,-105 38,-105 40,-107 40,-107 38))"\n'
PAIR = re.compile(r"(-?[\d.]+)(?: mm)? \((-?[\d.]+)\), bias (-?[\d.]+)(?: mm)? \((-?[\d.]+)\)")


def chord(p, q):
    """The distance through a sphere, which ranks gauges as the ellipsoid's does but for near ties."""
    def at(lon, lat):
        lon, lat = math.radians(lon), math.radians(lat)
        return math.cos(lat) * math.cos(lon), math.cos(lat) * math.sin(lon), math.sin(lat)
    return math.dist(at(*p), at(*q))


def errors_of_nearest(places, steps):
    """The root mean square error, and the mean, of each reading told by the nearest gauge that reports."""
    order = {g: sorted((h for h in places if h != g), key=lambda h: chord(places[g], places[h]))
             for g in places}
    errors = [readings[next(h for h in order[g] if h in readings)] - reading
              for readings in steps for g, reading in readings.items()]
    return math.sqrt(sum(e * e for e in errors) / len(errors)), sum(errors) / len(errors)


class FittedNormals(ProgramTest):
    def notices(self, *arguments):
        ran = self.run_program("rain", *arguments)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout, [line for line in ran.stderr.splitlines() if "leaving each gauge out" in line]

    def test_colorado_gains_by_its_elevations(self):
        self.write("basin.csv", BASIN)
        _, said = self.notices(COLORADO / "stations.csv", "basin.csv", COLORADO / "rainfall.csv",
                               "--elevation-field", "elev")
        by_elevation, by_gauges_around, by_nearest = map(float, re.findall(r"([\d.]+) %", said[0]))
        self.assertLess(by_elevation, 0.8 * by_gauges_around)
        self.assertLess(by_elevation, 0.9 * by_nearest)
        errors = [tuple(map(float, found)) for found in PAIR.findall(said[1])]
        fitted, plain, bias, plain_bias = errors[0]
        with open(COLORADO / "stations.csv", encoding="utf-8", newline="") as file:
            places = {row["id"]: (float(row["lon"]), float(row["lat"])) for row in csv.DictReader(file)}
        with open(COLORADO / "rainfall.csv", encoding="utf-8", newline="") as file:
            steps = [{g: float(v) for g, v in row.items() if g != "month" and v} for row in csv.DictReader(file)]
        heard = {g for readings in steps for g in readings}
        expected = errors_of_nearest({g: places[g] for g in heard}, steps)
        self.assertAlmostEqual(plain, expected[0], delta=0.06)
        self.assertAlmostEqual(plain_bias, expected[1], delta=0.06)
        self.assertLess(fitted, 0.85 * plain)
        self.assertLess(abs(bias), abs(plain_bias))
        # The highest band gains most, and the lowest does not lose.
        self.assertEqual(len(errors), 4)
        self.assertLess(errors[3][0], 0.88 * errors[3][1])
        self.assertLessEqual(errors[1][0], errors[1][1])

    def simulated(self, normal_of, pairs=False):
        """60 gauges with 24 months of rain: normals times a state of the step and a gauge's own factor."""
        numbers = random.Random(18)
        places, heights = [], []
        for i in range(60):
            beside = pairs and i % 2 == 1
            places.append((places[-1][0] + 0.5, places[-1][1]) if beside
                          else (numbers.uniform(0, 100), numbers.uniform(0, 100)))
            heights.append(numbers.uniform(0, 3000))
        normals = [normal_of(i, heights[i], numbers) for i in range(60)]
        self.write("stations.csv", "id,x,y,elev\n" + "".join(
            f"g{i},{places[i][0]!r},{places[i][1]!r},{heights[i]!r}\n" for i in range(60)))
        rows = "time," + ",".join(f"g{i}" for i in range(60)) + "\n"
        self.states = [numbers.uniform(0.2, 2) for _ in range(24)]
        for step, state in enumerate(self.states):
            rows += f"{step + 1}," + ",".join(
                repr(normal * state * numbers.uniform(0.8, 1.2)) for normal in normals) + "\n"
        self.write("rain.csv", rows)

    def test_known_normals_are_found(self):
        self.simulated(lambda _, height, numbers: 100 * 2 ** (height / 1500) * numbers.uniform(0.95, 1.05))
        heights = (200, 1200, 2800)
        self.write("basins.csv", "id,elev,WKT\n" + "".join(
            f'B{height},{height},"POLYGON((0 0,100 0,100 100,0 100,0 0))"\n' for height in heights))
        rain, _ = self.notices("stations.csv", "basins.csv", "rain.csv", "--elevation-field", "elev",
                               "--metric", "planar")
        for row, state in zip(table(rain), self.states):
            for height in heights:
                truth = 100 * 2 ** (height / 1500) * state
                # 60 gauges' own factors, of which each has a standard deviation of 12 %.
                self.assertAlmostEqual(float(row[f"B{height}"]) / truth, 1, delta=0.08)

    def test_rain_that_elevation_does_not_tell_is_refused(self):
        def of_pair(i, _, numbers):
            if i % 2 == 0:
                self.normal = math.exp(numbers.uniform(4, 6))
            return self.normal
        self.simulated(of_pair, pairs=True)
        self.write("basins.csv", 'id,elev,WKT\nB,500,"POLYGON((0 0,100 0,100 100,0 100,0 0))"\n')
        ran = self.run_program("rain", "stations.csv", "basins.csv", "rain.csv", "--elevation-field", "elev",
                               "--metric", "planar")
        self.assertEqual(ran.returncode, 1, ran.stderr)
        self.assertEqual(ran.stdout, "")
        self.assertIn("rain.csv: elevation does not tell rain here: leaving each gauge out", ran.stderr)


if __name__ == "__main__":
    unittest.main()
