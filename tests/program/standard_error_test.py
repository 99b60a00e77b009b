"""Standard errors on real rain: the Colorado sample's gauges in two halves, each of which knows nothing of the other."""

import math
import random
import unittest

from thiessen import SAMPLES, ProgramTest, table

SAMPLE = SAMPLES / "colorado"
SEED = 6
SHUFFLES = 3


class StandardError(ProgramTest):
    def half(self, name, header, gauges):
        stations = self.write(f"{name}.csv", "\n".join([header, *gauges]) + "\n")
        return table(self.output("rain", stations, SAMPLE / "counties.geojson", SAMPLE / "rainfall.csv", "--basin-id",
                                 "name", "--error", "--long", "--ignore-unknown", "-q"))

    def differences(self):
        """Of the halves' values for a county and a month, in units of their standard errors taken together."""
        rng = random.Random(SEED)
        header, *gauges = (SAMPLE / "stations.csv").read_text(encoding="utf-8").splitlines()
        for _ in range(SHUFFLES):
            rng.shuffle(gauges)
            for one, other in zip(self.half("one", header, gauges[::2]), self.half("other", header, gauges[1::2])):
                self.assertEqual((one["time"], one["basin"]), (other["time"], other["basin"]))
                together = math.hypot(float(one["se"]), float(other["se"]))
                yield (float(one["rainfall"]) - float(other["rainfall"])) / together

    def test_halves_of_a_network_differ_as_their_errors_say(self):
        found = list(self.differences())
        self.assertEqual(len(found), SHUFFLES * 64 * 120)
        within = sum(abs(d) <= 1.96 for d in found) / len(found)
        print(f"seed {SEED}: within 1.96 standard errors: {within:.2%} of {len(found):,}")
        self.assertGreaterEqual(within, 0.93)
        self.assertLessEqual(within, 0.97)


if __name__ == "__main__":
    unittest.main()
