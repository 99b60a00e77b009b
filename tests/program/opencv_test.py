#!/usr/bin/env python3
"""Which functions of OpenCV the program draws with: cells, lines, discs and letters are its work, not ours."""

import re
import shutil
import subprocess
import unittest

import thiessen

# Filled shapes; lines; discs; letters.
DRAWING = {"fillConvexPoly", "fillPoly", "polylines", "circle", "createFreeType2"}
# What is done to pixels in between: means of a finer grid, halos, blending by coverage, looking at parts.
PIXELS = {"add", "bitwise_and", "bitwise_not", "boundingRect", "copyMakeBorder", "countNonZero", "cvtColor", "dilate",
          "extractChannel", "getStructuringElement", "multiply", "noArray", "resize", "sum"}
# How it works: on the thread that calls it.
WAYS = {"setNumThreads"}
FUNCTION = re.compile(r"cv::(?:freetype::)?([a-z]\w*)\(")


class OpenCvTest(unittest.TestCase):
    def used(self):
        if shutil.which("nm") is None:
            self.skipTest("nm is not installed")
        command = ["nm", "--dynamic", "--undefined-only", "--demangle", thiessen.PROGRAM]
        symbols = subprocess.run(command, check=True, text=True, capture_output=True).stdout.splitlines()
        # A line is "U cv::name(arguments)": what stands in the brackets is not called.
        found = (FUNCTION.match(symbol.strip().removeprefix("U ")) for symbol in symbols)
        names = {function[1] for function in found if function}
        if not names:
            self.skipTest("OpenCV is linked into the program")
        return names

    def test_it_draws_fills_and_sets(self):
        self.assertEqual(DRAWING - self.used(), set())

    def test_whatever_else_is_used_is_in_this_list(self):
        self.assertEqual(self.used() - DRAWING - PIXELS - WAYS, set())


if __name__ == "__main__":
    unittest.main()
