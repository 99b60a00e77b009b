#!/usr/bin/env python3
"""Silent gauges on the Colorado sample: values beside those of files that have only the gauges that report, and the same
bytes whatever the threads and the cache."""

import csv
import unittest

import thiessen

COLORADO = thiessen.SAMPLES / "colorado"
BASINS = COLORADO / "counties.geojson"
PLANE = ("--plane", "EPSG:26913", "--basin-id", "name", "-q")
MONTHS = 6


class SilentGaugesTest(thiessen.ProgramTest):
    def setUp(self):
        super().setUp()
        with (COLORADO / "stations.csv").open(encoding="utf-8", newline="") as file:
            self.stations = list(csv.reader(file))
        with (COLORADO / "rainfall.csv").open(encoding="utf-8", newline="") as file:
            self.rainfall = list(csv.reader(file))

    def rain(self, *options):
        text = self.output("rain", COLORADO / "stations.csv", BASINS, COLORADO / "rainfall.csv", *PLANE, "--decimals",
                           "12", *options)
        return {row["time"]: row for row in thiessen.table(text)}

    def network_weights(self):
        """The weights of the gauges with a reading in the file: the others are not of the network."""
        header, *gauges = self.stations
        heard = {id_ for column, id_ in enumerate(self.rainfall[0]) if column and any(row[column] for row in self.rainfall[1:])}
        rows = [header, *(row for row in gauges if row[0] in heard)]
        self.write("network.csv", "".join(",".join(row) + "\n" for row in rows))
        return thiessen.weights_of(self.output("weights", "network.csv", BASINS, *PLANE))

    def months(self):
        """Some months, spread over the file: the time, and the readings of the gauges that report."""
        step = len(self.rainfall) // MONTHS
        for row in self.rainfall[1::step]:
            yield row[0], {id_: float(field) for id_, field in zip(self.rainfall[0][1:], row[1:]) if field}

    def test_a_step_has_the_cells_of_the_gauges_that_report(self):
        found = self.rain()
        for time, readings in self.months():
            header, *gauges = self.stations
            rows = [header, *(row for row in gauges if row[0] in readings)]
            self.write("gauges.csv", "".join(",".join(row) + "\n" for row in rows))
            weights = thiessen.weights_of(self.output("weights", "gauges.csv", BASINS, *PLANE))
            self.assertEqual(len(weights), 64)
            for basin, of_basin in weights.items():
                value = sum(weight * readings[gauge] for gauge, weight in of_basin.items())
                self.assertAlmostEqual(float(found[time][basin]), value, delta=1e-9, msg=f"{time} {basin}")

    def test_renormalised_weights_are_the_network_s(self):
        found = self.rain("--gaps", "renormalise")
        weights = self.network_weights()
        for time, readings in self.months():
            for basin, of_basin in weights.items():
                reporting = {gauge: weight for gauge, weight in of_basin.items() if gauge in readings}
                if not reporting:
                    self.assertEqual(found[time][basin], "")
                    continue
                value = sum(weight * readings[gauge] for gauge, weight in reporting.items()) / sum(reporting.values())
                self.assertAlmostEqual(float(found[time][basin]), value, delta=1e-9, msg=f"{time} {basin}")

    def test_strict_has_no_value_where_a_gauge_that_weighs_is_silent(self):
        found = self.rain("--gaps", "strict")
        weights = self.network_weights()
        empty = 0
        for time, readings in self.months():
            for basin, of_basin in weights.items():
                complete = all(gauge in readings for gauge in of_basin)
                self.assertEqual(found[time][basin] != "", complete, f"{time} {basin}")
                empty += not complete
        self.assertGreater(empty, 0)

    def test_bytes_are_the_same_for_any_threads_and_cache(self):
        for metric in (PLANE, ("--basin-id", "name", "-q")):
            texts = {
                self.output("rain", COLORADO / "stations.csv", BASINS, COLORADO / "rainfall.csv", *metric, "--decimals",
                            "12", "--long", "--threads", threads, "--cache", cache)
                for threads in (1, 2, 7) for cache in (0, 1, 256)
            }
            self.assertEqual(len(texts), 1)


if __name__ == "__main__":
    unittest.main()
