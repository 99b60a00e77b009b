"""Runs the program that THIESSEN_PROGRAM names, on files in a folder of the test's own."""

import csv
import io
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ.get("THIESSEN_PROGRAM", "build/cli/thiessen")).resolve()
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def table(text):
    """The rows of a CSV text as dictionaries."""
    return list(csv.DictReader(io.StringIO(text, newline="")))


def weights_of(text):
    """{basin: {station: weight}} of a table of weights."""
    found = {}
    for row in table(text):
        found.setdefault(row["basin"], {})[row["station"]] = float(row["weight"])
    return found


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own, self.folder, in which the program runs."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="thiessen-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def run_program(self, *arguments, **settings):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, timeout=120, text=True,
                              encoding="utf-8", stdin=subprocess.DEVNULL, capture_output=True, **settings)

    def output(self, *arguments):
        """What the program prints; the test fails where it does not end with 0."""
        ran = self.run_program(*arguments)
        self.assertEqual(ran.returncode, 0, f"thiessen {' '.join(map(str, arguments))}: {ran.stderr}")
        return ran.stdout
