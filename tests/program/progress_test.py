"""What a long series says on the terminal while it is computed, and that a pipe sees nothing of it.

The program is stopped in the midst of its readings until the second has passed in which it is silent.
"""

import os
import pathlib
import re
import signal
import subprocess
import threading
import time
import unittest

from terminal import LONGEST, Terminal
from thiessen import PROGRAM, ProgramTest

SILENT_SECONDS = 1
STATIONS = 100
FIRST_ROWS = 40_000
ROW = ",1" * STATIONS + "\n"
LINE = re.compile(r"thiessen: [1-9][0-9,]* time steps, (\d+) %, (\d+ s|\d+ min|\d+ h \d+ min) left\Z")
COUNT = re.compile(r"thiessen: [1-9][0-9,]* time steps\Z")


def place_in(pid, file):
    """How many bytes of the file a process has read; 0 where it has not opened it, or has ended."""
    try:
        for link in pathlib.Path(f"/proc/{pid}/fd").iterdir():
            if link.resolve() == file:
                return int(pathlib.Path(f"/proc/{pid}/fdinfo/{link.name}").read_text(encoding="ascii").split()[1])
    except OSError:
        pass
    return 0


class ProgressTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("stations.csv", "id,x,y\n" + "".join(f"s{i},{i},{i * i % 7}\n" for i in range(STATIONS)))
        self.write("basin.csv", 'id,WKT\nB,"POLYGON ((0 0, 99 0, 99 7, 0 7, 0 0))"\n')
        self.header = "time" + "".join(f",s{i}" for i in range(STATIONS)) + "\n"
        self.arguments = ["rain", "stations.csv", "basin.csv", "rainfall.csv", "--metric", "planar", "-o",
                          "rain.csv", "--overwrite"]

    def paused_in_the_midst(self, start):
        """A started program that has slept for longer than it is silent, with a part of its readings read."""
        rainfall = (self.folder / "rainfall.csv").resolve()
        rows = FIRST_ROWS
        while True:
            self.write("rainfall.csv", self.header + "".join(f"{i}{ROW}" for i in range(rows)))
            size = rainfall.stat().st_size
            program = start()
            while place_in(program.pid, rainfall) < size // 4 and not self.has_ended(program.pid):
                pass
            if not self.has_ended(program.pid):
                os.kill(program.pid, signal.SIGSTOP)
                if place_in(program.pid, rainfall) < size // 2:
                    time.sleep(1.2 * SILENT_SECONDS)
                    os.kill(program.pid, signal.SIGCONT)
                    return program
                os.kill(program.pid, signal.SIGKILL)
            rows *= 2  # it was too fast

    @staticmethod
    def has_ended(pid):
        stat = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8", errors="replace")
        return stat.rpartition(")")[2].split()[0] in "ZX"

    def on_a_terminal(self, *more):
        def start():
            terminal = Terminal(self.folder, *self.arguments, *more)
            self.addCleanup(terminal.close)
            return terminal
        return self.paused_in_the_midst(start)

    def test_says_how_much_is_done_and_how_long_the_rest_takes(self):
        terminal = self.on_a_terminal()
        self.assertEqual(terminal.status(), 0)
        lines = [line for line in terminal.text.split("\r") if line]
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, LINE)
        shares = [int(LINE.match(line)[1]) for line in lines]
        self.assertGreater(shares[0], 0)
        self.assertEqual(shares, sorted(shares))

    def test_leaves_a_clean_line(self):
        terminal = self.on_a_terminal()
        self.assertEqual(terminal.status(), 0)
        self.assertTrue(terminal.text.endswith("\r"))

    def test_counts_what_comes_from_a_pipe(self):
        os.mkfifo(self.folder / "rainfall.csv")
        shown = threading.Event()

        def feed():
            with open(self.folder / "rainfall.csv", "w", encoding="utf-8") as pipe:
                pipe.write(self.header)
                row = 0
                while not shown.is_set():
                    pipe.writelines(f"{i}{ROW}" for i in range(row, row + 1000))
                    row += 1000
                    shown.wait(0.05)

        feeder = threading.Thread(target=feed)
        feeder.start()
        try:
            terminal = Terminal(self.folder, *self.arguments)
            self.addCleanup(terminal.close)
            terminal.await_text("time steps")
        finally:
            shown.set()
        self.assertEqual(terminal.status(), 0)
        feeder.join(LONGEST)
        # A pipe is read once, which a notice says before the first step.
        counted = re.sub(r"thiessen: notice: [^\r\n]*\r?\n", "", terminal.text)
        for line in filter(None, counted.split("\r")):
            self.assertRegex(line, COUNT)

    def test_is_silent_where_it_is_told_to_be(self):
        terminal = self.on_a_terminal("--quiet")
        self.assertEqual(terminal.status(), 0)
        self.assertEqual(terminal.text, "")

    def test_is_silent_in_a_pipe(self):
        def start():
            return subprocess.Popen([PROGRAM, *self.arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        program = self.paused_in_the_midst(start)
        said, _ = program.communicate(timeout=LONGEST)
        self.assertEqual((program.returncode, said), (0, b""))


if __name__ == "__main__":
    unittest.main()
