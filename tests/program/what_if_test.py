"""`weights --without` and `--with` against `weights` of a file without these stations and with these, by every digit."""

import csv
import unittest

from thiessen import SAMPLES, ProgramTest, table

COLORADO = SAMPLES / "colorado"
BASINS = [COLORADO / "counties.geojson", "--basin-id", "name", "-q"]


class WhatIf(ProgramTest):
    def setUp(self):
        super().setUp()
        with (COLORADO / "stations.csv").open(encoding="utf-8", newline="") as file:
            self.header, *self.stations = csv.reader(file)
        self.id, self.lon, self.lat = (self.header.index(name) for name in ("id", "lon", "lat"))

    def weights(self, stations, *options):
        with (self.folder / "stations.csv").open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([self.header, *stations])
        return table(self.output("weights", "stations.csv", *BASINS, *options))

    def compare(self, closed, opened, *options):
        left = [row for row in self.stations if row[self.id] not in closed]
        for number, (lon, lat) in enumerate(opened, 1):
            row = [""] * len(self.header)
            row[self.id], row[self.lon], row[self.lat] = f"with {number}", lon, lat
            left.append(row)
        after = self.weights(left, *options)
        before = self.weights(self.stations, *options)
        changes = [f"--without={station}" for station in closed] + [f"--with={lon},{lat}" for lon, lat in opened]
        found = self.weights(self.stations, *options, *changes)
        self.assertNotEqual(before, after)
        for suffix, expected in (("", before), ("_after", after)):
            rows = [{"basin": row["basin"], "station": row["station"], "area_km2": row["area_km2" + suffix],
                     "weight": row["weight" + suffix]} for row in found]
            self.assertEqual([row for row in rows if row["weight"] != "0"], expected)
        pairs = {(row["basin"], row["station"]) for row in before + after}
        self.assertEqual(len(found), len(pairs))

    def weighing(self):
        return [row["station"] for row in self.weights(self.stations)]

    def test_closed(self):
        stations = self.weighing()
        self.compare({stations[100]}, [])
        self.compare(set(stations[::40]), [])

    def test_opened(self):
        self.compare(set(), [("-105.5", "39.25"), ("-108.1", "37.3"), ("-102.5", "40.9")])

    def test_closed_and_opened(self):
        self.compare(set(self.weighing()[::30]), [("-105.5", "39.25"), ("-106.75", "38.5")])

    def test_opened_where_one_stands(self):
        one = self.weighing()[10]
        self.compare(set(), [(row[self.lon], row[self.lat]) for row in self.stations if row[self.id] == one])

    def test_in_a_projection(self):
        self.compare(set(self.weighing()[::50]), [("-105.5", "39.25")], "--plane", "EPSG:26913")


if __name__ == "__main__":
    unittest.main()
