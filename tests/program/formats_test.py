"""Every published format of tests/formats, read by its command, against values worked out here."""

import pathlib
import shlex
import tomllib
import unittest
from fractions import Fraction

from thiessen import ProgramTest, table

FORMATS = pathlib.Path(__file__).resolve().parents[1] / "formats"
WEST, EAST = Fraction(1, 4), Fraction(3, 4)  # the gauges' shares of the basin: see formats.toml
SILENT = "-"


def areal(west, east):
    """The mean over the basin; None where neither gauge has a reading."""
    heard = [(share, Fraction(str(caught))) for share, caught in ((WEST, west), (EAST, east))
             if caught != SILENT]
    if not heard:
        return None
    return sum(share * caught for share, caught in heard) / sum(share for share, _ in heard)


class Formats(ProgramTest):
    def setUp(self):
        with open(FORMATS / "formats.toml", "rb") as file:
            self.formats = tomllib.load(file)["format"]

    def ran(self, case, left_out=()):
        self.folder = FORMATS / case["folder"]
        words = [word for word in shlex.split(case["command"]) if word not in left_out]
        return self.run_program(*words, "--decimals", 6)

    def test_each_is_read_right(self):
        for case in self.formats:
            with self.subTest(case["name"]):
                ran = self.ran(case)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertIn(case.get("told", ""), ran.stderr)
                self.assertIn(case.get("also", ""), ran.stderr)
                rows = sorted(table(ran.stdout), key=lambda row: row["time"])
                self.assertEqual([row["time"] for row in rows], [row[0] for row in case["rows"]])
                for found, (time, west, east) in zip(rows, case["rows"]):
                    right = areal(west, east)
                    if right is None:
                        self.assertEqual(found["basin"], "", time)
                    else:
                        self.assertAlmostEqual(float(found["basin"]), float(right), delta=2e-6, msg=time)

    def test_what_cannot_be_known_is_asked_for(self):
        for case in self.formats:
            if "without" not in case:
                continue
            with self.subTest(case["name"]):
                ran = self.ran(case, case["without"])
                self.assertEqual(ran.returncode, 1)
                self.assertIn(case["error"], ran.stderr)
                self.assertIn("hint: ", ran.stderr)

    def test_every_sample_has_a_row(self):
        folders = sorted(path.name for path in FORMATS.iterdir() if path.is_dir())
        self.assertEqual(folders, sorted({case["folder"] for case in self.formats}))


if __name__ == "__main__":
    unittest.main()
