"""The list of hostile input and failing machines has a row for each of its numbers, and some quick ones hold.

tests/torture.sh runs them all."""

import os
import pathlib
import subprocess
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
QUICK = ("T002", "T012", "T063", "T081-T084", "T089", "T090", "T094", "T109", "T113")


class TortureTest(unittest.TestCase):
    def ran(self, *words):
        return subprocess.run([TESTS / "torture.sh", "--program", os.environ["THIESSEN_PROGRAM"], "--shim",
                               os.environ["THIESSEN_SHIM"], *words], capture_output=True, text=True, check=False)

    def test_every_row_has_a_line(self):
        ran = self.ran("--list")
        self.assertEqual([line[:4] for line in ran.stdout.splitlines()], [f"T{n:03}" for n in range(1, 117)])

    def test_quick_rows_hold(self):
        ran = self.ran(*QUICK)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)


if __name__ == "__main__":
    unittest.main()
