"""The textbook case of samples/textbook against its published, exact answer."""

import unittest
from fractions import Fraction

import exact
from thiessen import SAMPLES, ProgramTest, table, weights_of

SAMPLE = SAMPLES / "textbook"
STATIONS, BASIN, RAINFALL = (SAMPLE / f"{name}.csv" for name in ("stations", "basin", "rainfall"))
WEIGHTS = {
    "2": Fraction(478277, 3421250), "3": Fraction(832043, 6440000), "5": Fraction(2563, 11200),
    "7": Fraction(3607, 14875), "8": Fraction(83, 1000), "9": Fraction(60446, 342125),
}
MEAN_MM = Fraction(119463938, 1710625)
RING = [(5, 5), (-5, 5), (-5, -5), (0, -10), (5, -5)]


def gauges():
    rows = table(STATIONS.read_text(encoding="utf-8"))
    return {row["id"]: (Fraction(row["x"]), Fraction(row["y"])) for row in rows}


class Textbook(ProgramTest):
    def rain(self, *options, rainfall=RAINFALL):
        return table(self.output("rain", STATIONS, BASIN, rainfall, "--decimals", 12, *options))

    def with_gauge_5_silent(self):
        """A dry step before it, in which gauge 5 reports: else it were not of the network."""
        header, row = RAINFALL.read_text(encoding="utf-8").splitlines()
        self.assertIn(",105,", row)
        dry = "dry" + ",0" * (len(header.split(",")) - 1)
        return self.write("rainfall.csv", f"{header}\n{dry}\n{row.replace(',105,', ',,')}\n")

    def test_published_weights_follow_from_the_definition(self):
        self.assertEqual(exact.weights(gauges(), [RING]), WEIGHTS)

    def test_weights(self):
        text = self.output("weights", STATIONS, BASIN)
        found = weights_of(text)["A"]
        self.assertEqual(list(found), list(WEIGHTS), "positive weights only, in the order of the file")
        for gauge, weight in WEIGHTS.items():
            self.assertAlmostEqual(found[gauge], float(weight), delta=1e-14)
        self.assertAlmostEqual(sum(found.values()), 1, delta=1e-15)
        for row in table(text):
            self.assertAlmostEqual(float(row["area"]), 125 * float(row["weight"]), delta=1e-12)

    def test_rain(self):
        self.assertEqual([row["time"] for row in self.rain()], ["storm"])
        self.assertAlmostEqual(float(self.rain()[0]["A"]), float(MEAN_MM), delta=1e-11)

    def test_rain_does_not_depend_on_the_number_of_threads(self):
        self.assertEqual(self.rain("--threads", 1), self.rain("--threads", 2))

    def test_gauge_5_silent_retessellated(self):
        _, row = self.rain(rainfall=self.with_gauge_5_silent())
        self.assertAlmostEqual(float(row["A"]), 64.095793703568, delta=1e-11)

    def test_gauge_5_silent_renormalised(self):
        _, row = self.rain("--gaps", "renormalise", rainfall=self.with_gauge_5_silent())
        self.assertAlmostEqual(float(row["A"]), 59.401757880433, delta=1e-11)

    def test_gauge_5_silent_strict(self):
        _, row = self.rain("--gaps", "strict", rainfall=self.with_gauge_5_silent())
        self.assertEqual(row["A"], "")

    def test_long_rows_count_gauges_and_coverage(self):
        _, row = self.rain("--long", "--gaps", "renormalise", rainfall=self.with_gauge_5_silent())
        self.assertEqual((row["time"], row["basin"], row["gauges"]), ("storm", "A", "5"))
        self.assertAlmostEqual(float(row["coverage"]), float(1 - WEIGHTS["5"]), delta=1e-12)


if __name__ == "__main__":
    unittest.main()
