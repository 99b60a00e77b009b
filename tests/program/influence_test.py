"""Influence against leaving each gauge's column out of the file, on the Colorado sample.

A third of its readings are missing, in another pattern every month.
"""

import csv
import math
import unittest

from thiessen import SAMPLES, ProgramTest, table

COLORADO = SAMPLES / "colorado"
INPUTS = [COLORADO / "stations.csv", COLORADO / "counties.geojson"]
GAUGES = 4


def square_mean(changes):
    return math.sqrt(sum(change * change for change in changes) / len(changes))


class ColoradoInfluence(ProgramTest):
    def setUp(self):
        super().setUp()
        with (COLORADO / "rainfall.csv").open(encoding="utf-8", newline="") as file:
            self.header, *self.rows = csv.reader(file)

    def rain(self, rainfall, options):
        return table(self.output("rain", *INPUTS, rainfall, "--basin-id", "name", "--decimals", 12, "-q", *options))

    def write_readings(self, name, rows):
        with (self.folder / name).open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([self.header, *rows])
        return name

    def without(self, gauge, options):
        """The series where the gauge's column is empty."""
        column = self.header.index(gauge)
        rows = [[*row[:column], "", *row[column + 1:]] for row in self.rows]
        return self.rain(self.write_readings("less.csv", rows), options)

    def compare(self, tolerance, *options):
        rainfall = self.write_readings("rainfall.csv", self.rows)
        found = {}
        for row in table(self.output("weights", *INPUTS, "--influence", rainfall, "--basin-id", "name", "-q", *options)):
            found.setdefault(row["station"], {})[row["basin"]] = row
        whole = self.rain(rainfall, options)
        gauges = [gauge for gauge in self.header[1:] if gauge in found]
        for gauge in gauges[::len(gauges) // GAUGES]:
            less = self.without(gauge, options)
            for basin in list(whole[0])[1:]:
                changes = [float(b[basin]) - float(a[basin]) for a, b in zip(whole, less) if a[basin] and b[basin]]
                if basin not in found[gauge]:
                    self.assertLess(square_mean(changes), 1e-7, (gauge, basin))
                    continue
                row = found[gauge][basin]
                self.assertAlmostEqual(float(row["rms_change"]), square_mean(changes), delta=tolerance,
                                       msg=(gauge, basin))
                self.assertAlmostEqual(float(row["mean_change"]), sum(changes) / len(changes), delta=tolerance,
                                       msg=(gauge, basin))

    def test_in_a_plane(self):
        self.compare(1e-9, "--plane", "EPSG:26913")

    def test_on_the_earth(self):
        self.compare(1e-8)  # what is handed over elsewhere may be drawn anew, in another chart

    def test_whatever_the_threads_and_the_memory(self):
        arguments = ["weights", *INPUTS, "--influence", COLORADO / "rainfall.csv", "--basin-id", "name", "-q", "--plane",
                     "EPSG:26913", "--to", self.rows[5][0]]
        once = self.output(*arguments, "--threads", 1)
        for options in (["--threads", 2], ["--threads", 5, "--cache", 0], ["--cache", 1]):
            self.assertEqual(self.output(*arguments, *options), once)


if __name__ == "__main__":
    unittest.main()
