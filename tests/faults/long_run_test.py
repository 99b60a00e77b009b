"""A week in an hour, in half a minute: see tests/faults/long_run.py."""

import os
import unittest

import long_run

PROGRAM, SHIM = os.environ["THIESSEN_PROGRAM"], os.environ["THIESSEN_SHIM"]


class LongRunTest(unittest.TestCase):
    def test_steps_from_a_pipe_take_no_more_memory(self):
        self.assertEqual(long_run.steps_from_a_pipe(PROGRAM, 400_000), [])

    def test_a_reader_sees_whole_files_whoever_writes(self):
        self.assertEqual(long_run.writers_and_a_reader(PROGRAM, 3), [])

    def test_a_clock_that_jumps_changes_nothing(self):
        self.assertEqual(long_run.clocks_that_jump(PROGRAM, SHIM, 5), [])


if __name__ == "__main__":
    unittest.main()
