"""The disk is full at one byte after another of an output: exit 1, nothing new on disk, the old file as it was.

A limit on the size of files stands for the disk: a write beyond it fails as on a full one (EFBIG for ENOSPC).
"""

import errno
import os
import pathlib
import resource
import signal
import tempfile
import unittest

from thiessen import SAMPLES, ProgramTest

SAMPLE = SAMPLES / "textbook"
INPUTS = [SAMPLE / f"{name}.csv" for name in ("stations", "basin", "rainfall")]


def limited(size):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


class FullDisk(ProgramTest):
    def files(self):
        return {p.relative_to(self.folder).as_posix(): p.read_bytes()
                for p in self.folder.rglob("*") if p.is_file()}

    def assert_fails_cleanly(self, step, output, *arguments):
        """Runs the command with the limit at every `step`th byte of what it writes."""
        ran = self.run_program(*arguments, "-o", output)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        size = max(len(content) for content in self.files().values())
        for path in self.folder.rglob("*"):
            if path.is_file():
                path.write_bytes(b"old")
        before = self.files()
        for limit in [*range(0, size - 1, step), size - 1]:
            with self.subTest(output=output, limit=limit):
                ran = self.run_program(*arguments, "-o", output, "--overwrite", preexec_fn=limited(limit))
                self.assertEqual(ran.returncode, 1, ran.stderr)
                self.assertIn(os.strerror(errno.EFBIG), ran.stderr)
                self.assertEqual(self.files(), before)

    def test_weights_at_every_byte(self):
        self.assert_fails_cleanly(1 if "THIESSEN_THOROUGH" in os.environ else 9, "weights.csv", "weights",
                                  *INPUTS[:2])

    def test_rain_at_every_byte(self):
        self.assert_fails_cleanly(1, "rain.csv", "rain", *INPUTS)

    def test_cells(self):
        self.assert_fails_cleanly(397, "cells.geojson", "cells", *INPUTS[:2])

    def test_picture(self):
        self.assert_fails_cleanly(9973, "map.png", "map", *INPUTS)

    def test_grid(self):
        dated = INPUTS[2].read_text(encoding="utf-8").replace("storm", "2020-01-01")
        scratch = tempfile.TemporaryDirectory(prefix="thiessen-test-")
        self.addCleanup(scratch.cleanup)
        rainfall = pathlib.Path(scratch.name) / "rainfall.csv"
        rainfall.write_text(dated, encoding="utf-8")
        self.assert_fails_cleanly(9973, "map.nc", "map", *INPUTS[:2], rainfall, "--resolution", "0.02", "--steps",
                                  "--metric", "planar")

    def test_raster(self):
        self.assert_fails_cleanly(200_003, "map.tif", "map", *INPUTS[:2], "--resolution", "0.02")

    def test_raster_with_overviews(self):
        self.assert_fails_cleanly(200_003, "map.tif", "map", *INPUTS[:2], "--resolution", "0.02", "--compress", "none",
                                  "--overviews")

    def test_raster_of_steps(self):
        self.assert_fails_cleanly(50_021, "map.tif", "map", *INPUTS, "--resolution", "0.1", "--steps",
                                  "--compress", "none")

    def test_everything_at_once(self):
        self.assert_fails_cleanly(9973, "out", "run", *INPUTS)


if __name__ == "__main__":
    unittest.main()
