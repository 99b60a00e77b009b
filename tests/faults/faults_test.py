"""A machine that fails, in short: some calls of each kind, and all where there are few. tests/faults/faults.py is the
long form, with every call."""

import os
import tempfile
import unittest

import faults

MACHINE = faults.Machine(os.environ["THIESSEN_PROGRAM"], os.environ["THIESSEN_SHIM"])


class FaultsTest(unittest.TestCase):
    def assert_none(self, jobs, kinds, most):
        runs, found = faults.try_all(MACHINE, jobs, kinds, most=most, tell=lambda line: None)
        self.assertGreater(runs, len(kinds))
        self.assertEqual(found, {})

    def test_calls_that_name_the_outputs(self):
        self.assert_none(["run"], ["rename", "link", "fsync"], 3)

    def test_a_folder_and_what_is_written(self):
        self.assert_none(["run_anew"], ["mkdir", "write", "thread"], 2)

    def test_memory(self):
        self.assert_none(["rain"], ["malloc"], 5)

    def test_files_without_names_that_get_none(self):
        """Where the system names no open file, a copy has the name, whole and with the same mode."""
        trial = faults.Trial(MACHINE, "weights")
        with tempfile.TemporaryDirectory(prefix="thiessen-faults-") as scratch:
            folder = trial.prepared(scratch)
            (folder / "out" / "weights.csv").chmod(0o640)
            ran = MACHINE.run("weights", folder, FAULT="link+:1:2")
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertEqual(faults.files_of(folder), trial.whole)
            self.assertEqual((folder / "out" / "weights.csv").stat().st_mode & 0o777, 0o640)

    def test_a_library_that_writes(self):
        self.assert_none(["raster"], ["write", "mkdir", "rename"], 2)

    def assert_no_fault(self, job, kind, numbers, lasts=True):
        trial = faults.Trial(MACHINE, job)
        self.assertEqual({number: trial.faults(kind, number, lasts) for number in numbers}, {number: [] for number in numbers})

    def test_a_library_that_waits_for_its_threads(self):
        """GDAL waits for ever for a thread that could not start."""
        self.assert_no_fault("raster", "thread", [1])

    def test_no_file_can_be_opened_while_a_library_writes(self):
        count = faults.Trial(MACHINE, "raster").count("open")
        self.assert_no_fault("raster", "open", range(count - 9, count + 1, 2))

    def test_what_a_library_has_written_cannot_be_read(self):
        count = faults.Trial(MACHINE, "raster").count("read")
        self.assert_no_fault("raster", "read", [count - 29, count - 28, count])

    def test_a_library_tells_a_lack_of_memory_as_something_else(self):
        count = faults.Trial(MACHINE, "cells").count("malloc")
        self.assert_no_fault("cells", "malloc", [round(count * share) for share in (0.5, 0.77, 0.95, 0.97)], lasts=False)


class KilledTest(unittest.TestCase):
    def test_a_run_that_is_killed_leaves_the_old_files_and_nothing_else(self):
        """Killed at moments spread over its time, it has made neither files nor folders, but where it was at the names."""
        self.assertEqual(faults.killed(MACHINE, "run", 4) + faults.killed(MACHINE, "run_anew", 4), [])

    def test_some_new_names_are_no_fault_but_beside_hidden_ones(self):
        whole = {"out": None, "out/a.csv": b"a", "out/b.csv": b"b"}
        half = {"out": None, "out/a.csv": b"a"}
        self.assertEqual(faults.wrong_of_killed({}, {**half, "out/.thiessen-x": b"b"}, whole), [])
        self.assertEqual(faults.wrong_of_killed({}, {"out": None}, whole), [])
        self.assertEqual(faults.wrong_of_killed({}, {}, whole), [])
        self.assertEqual(faults.wrong_of_killed({}, whole, whole), [])
        self.assertEqual(faults.wrong_of_killed({}, half, whole), ["there is out, out/a.csv"])
        self.assertEqual(faults.wrong_of_killed({}, {**whole, "out/b.csv": b""}, whole), ["out/b.csv is cut"])
        self.assertEqual(faults.wrong_of_killed({"out": None, "c.csv": b""}, {"out": None}, whole), ["there is c.csv"])


if __name__ == "__main__":
    unittest.main()
