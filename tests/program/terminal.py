"""A pseudo-terminal on which the program runs, and what is read and typed there.

Nothing waits for a time: each step waits for a text, or for the program to read keys, and gives up only after LONGEST
seconds.
"""

import os
import pathlib
import pty
import re
import select
import signal
import termios
import time

from thiessen import PROGRAM

LONGEST = 120
ENTER = "\r"
ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b[()][A-Z0-9]|\x1b[=>]|\x07")


class Terminal:
    """The program with a terminal for its input, its messages and, unless `output` is given, its output."""

    def __init__(self, folder, *arguments, output=None):
        self.text = ""
        self.seen = 0
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            try:
                os.chdir(folder)
                if output is not None:
                    os.dup2(output, 1)
                os.environ.update(TERM="xterm", LC_ALL="C.UTF-8")
                os.execv(PROGRAM, [str(PROGRAM), *arguments])
            finally:
                os._exit(127)

    def type(self, keys):
        self.await_reading()
        self.type_ahead(keys)

    def type_ahead(self, keys):
        """Whatever the program is doing."""
        os.write(self.master, keys.encode())

    def await_reading(self):
        """Until the line editor has the terminal, key by key, and the program sleeps in its read.

        The prompt comes a moment before. What is typed ahead of that goes through the terminal's own line editing.
        """
        end = time.monotonic() + LONGEST
        while not (self.is_key_by_key() and self.is_asleep()):
            if time.monotonic() > end:
                raise AssertionError(f"no key is read: {self.text!r}")
            os.sched_yield()

    def is_key_by_key(self):
        return not termios.tcgetattr(self.master)[3] & termios.ICANON

    def is_asleep(self):
        stat = pathlib.Path(f"/proc/{self.pid}/stat").read_text(encoding="utf-8", errors="replace")
        return stat.rpartition(")")[2].split()[0] in "SZ"

    def enter(self, line):
        self.type(line + ENTER)

    def ask(self, line, answer):
        """Enters a line and reads on to its answer and the next prompt."""
        self.enter(line)
        self.await_text(answer)
        self.await_text("> ")

    def await_text(self, wanted):
        """Reads on until `wanted` has come after what was awaited before."""
        end = time.monotonic() + LONGEST
        while wanted not in self.text[self.seen:]:
            if not self.read_some(end):
                raise AssertionError(f"{wanted!r} never came, but {self.text[self.seen:]!r}")
        self.seen = self.text.index(wanted, self.seen) + len(wanted)

    def read_some(self, end):
        ready, _, _ = select.select([self.master], [], [], max(0, end - time.monotonic()))
        if not ready:
            return False
        try:
            more = os.read(self.master, 65536)
        except OSError:  # the other side is closed
            more = b""
        self.text = ESCAPES.sub("", self.text + more.decode("utf-8", "replace"))
        return bool(more)

    def status(self):
        """The exit status, once the program has ended by itself."""
        end = time.monotonic() + LONGEST
        while self.read_some(end):
            pass
        if time.monotonic() > end:
            raise AssertionError(f"no end: {self.text!r}")
        _, status = os.waitpid(self.pid, 0)
        self.pid = None
        return os.waitstatus_to_exitcode(status)

    def close(self):
        os.close(self.master)
        if self.pid is not None:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
