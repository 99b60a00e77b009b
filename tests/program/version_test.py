"""What `--version` says."""

import re
import unittest

from thiessen import ProgramTest

LINES = [r"thiessen \d+\.\d+\.\d+", r"commit ([0-9a-f]{7}(-dirty)?|unknown)", r"GDAL \d+\.\d+\.\d+\w*",
         r"PROJ \d+\.\d+\.\d+\w*", r"GeographicLib \d+\.\d+(\.\d+)?", r"OpenCV \d+\.\d+\.\d+\S*"]


class Version(ProgramTest):
    def test_each_line_names_one_thing(self):
        lines = self.output("--version").splitlines()
        self.assertEqual(len(lines), len(LINES))
        for line, form in zip(lines, LINES):
            self.assertRegex(line, re.compile(f"^{form}$"))

    def test_a_command_says_the_same(self):
        self.assertEqual(self.output("rain", "--version"), self.output("--version"))


if __name__ == "__main__":
    unittest.main()
