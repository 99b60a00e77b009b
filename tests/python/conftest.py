"""What the tests of the bindings share: the program to compare with, and the samples.

The module is looked for where the build has it, by PYTHONPATH, and the program by THIESSEN_PROGRAM.
"""

import csv
import os
import pathlib
import subprocess

import pytest

CLONE = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = CLONE / "samples"
TEXTBOOK = [SAMPLES / "textbook" / name for name in ("stations.csv", "basin.csv", "rainfall.csv")]
COLORADO = [SAMPLES / "colorado" / name for name in ("stations.csv", "counties.geojson", "rainfall.csv")]


def run(*command):
    """The program's standard output."""
    done = subprocess.run([os.environ["THIESSEN_PROGRAM"], *map(str, command)], capture_output=True, text=True, check=True)
    return done.stdout


def rows(*command):
    """The program's CSV: its header, and its rows of texts."""
    header, *found = csv.reader(run(*command).splitlines())
    return header, found


@pytest.fixture(autouse=True)
def warnings_are_no_errors(recwarn):
    """What is odd about a sample is told, and no fault of a test."""
    return recwarn
