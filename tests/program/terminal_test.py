"""The session on a terminal: a pseudo-terminal stands for it, and what is typed is typed there.

What the line editor writes depends on the terminal, so that the tests look for answers and prompts, not for the echo.
"""

import os
import random
import signal
import subprocess
import time
import unittest

from terminal import LONGEST, Terminal
from thiessen import PROGRAM, ProgramTest

GREETING = "help lists the commands"
UP, TAB, CTRL_C, CTRL_D = "\x1b[A", "\t", "\x03", "\x04"


class TerminalTest(ProgramTest):
    def session(self, *arguments, **settings):
        terminal = Terminal(self.folder, "tessel", *arguments, **settings)
        self.addCleanup(terminal.close)
        return terminal

    def greeted(self, *arguments):
        terminal = self.session(*arguments)
        terminal.await_text(GREETING)
        terminal.await_text("> ")
        return terminal

    def test_greets_prompts_and_says_what_was_done(self):
        terminal = self.greeted()
        terminal.ask("add 3 4", "point 1\r\n")
        terminal.ask("add 0 0", "point 2\r\n")
        terminal.ask("delete 3 4", "point 1 is deleted\r\n")
        terminal.ask("undo", "2 points\r\n")
        terminal.ask("nearest 3 3", "point 1 3 4\r\n")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_helps(self):
        terminal = self.greeted("--dim", "3")
        self.assertIn("3-D", terminal.text)
        terminal.enter("help")
        for command in ("add", "delete", "undo", "redo", "nearest", "cell", "load", "print", "show",
                        "watch", "check", "help", "quit"):
            terminal.await_text(f"\n  {command} ")
        terminal.await_text("> ")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_arrow_up_is_the_line_before(self):
        terminal = self.greeted()
        terminal.ask("add 7 11", "point 1\r\n")
        terminal.ask("nearest 0 0", "point 1 7 11\r\n")
        terminal.ask(UP + UP, "error: point 1 is at 7 11 already\r\n")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_tab_completes_a_command(self):
        terminal = self.greeted()
        terminal.ask("a" + TAB + "5 6", "point 1\r\n")
        terminal.ask("nea" + TAB + "0 0", "point 1 5 6\r\n")
        terminal.enter("q" + TAB)
        self.assertEqual(terminal.status(), 0)

    def test_tab_does_not_choose_between_commands(self):
        terminal = self.greeted()
        terminal.ask("ne" + TAB + " 1 1", "error: there are no points\r\n")  # nearest alone begins so
        terminal.ask("c" + TAB, "error: there is no command 'c'\r\n")  # cell and check
        terminal.type(CTRL_D)
        self.assertEqual(terminal.status(), 0)

    def test_an_error_does_not_end_the_session(self):
        terminal = self.greeted()
        for line, sentence in (("fly 1 2", "there is no command 'fly'"), ("undo", "there is nothing to undo"),
                               ("delete 1 1", "there is no point at 1 1"), ("add 1", "add"),
                               ("load nothing.csv", "nothing.csv"), ("add 'x", "quote")):
            terminal.enter(line)
            terminal.await_text("error: ")
            terminal.await_text(sentence)
            terminal.await_text("> ")
        terminal.ask("add 1 2", "point 1\r\n")
        terminal.ask("check", "sound: 1 points, 0 vertices, dimension 0\r\n")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_ctrl_c_drops_the_line_and_not_the_session(self):
        terminal = self.greeted()
        terminal.ask("add 1 2", "point 1\r\n")
        for typed in ("add 3", "quit", ""):
            terminal.type(typed)
            if typed:
                terminal.await_text(typed)
            terminal.type(CTRL_C)
            terminal.await_text("> ")
        terminal.ask("add 5 6", "point 2\r\n")
        terminal.ask(UP, "error: point 2 is at 5 6 already\r\n")  # what was dropped is not remembered
        terminal.type(CTRL_C)
        terminal.await_text("> ")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.status(), 0)

    def test_ctrl_c_the_moment_that_the_prompt_appears_ends_nothing(self):
        for _ in range(15):
            terminal = self.greeted()
            terminal.type_ahead(CTRL_C)
            terminal.await_text("> ")
            terminal.ask("add 1 2", "point 1\r\n")
            terminal.enter("quit")
            self.assertEqual(terminal.status(), 0)

    def test_other_signals_end_the_session(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            terminal = self.greeted()
            terminal.type("add 3")
            terminal.await_text("add 3")
            os.kill(terminal.pid, number)
            self.assertEqual(terminal.status(), 128 + number)

    def test_ctrl_c_drops_a_long_command_and_what_it_did(self):
        with open(self.folder / "many.csv", "w", encoding="utf-8") as many:
            generator = random.Random(5)
            for _ in range(100_000):
                many.write(",".join(repr(generator.random()) for _ in range(3)) + "\n")
        terminal = self.greeted("--dim", "3")
        terminal.ask("add 1 2 3", "point 1\r\n")
        terminal.ask("add 3 2 1", "point 2\r\n")
        terminal.ask("undo", "1 point\r\n")
        terminal.enter("load many.csv")
        time.sleep(0.15)  # while it reads or tessellates
        terminal.type_ahead(CTRL_C)
        terminal.await_text("interrupted: nothing is changed\r\n")
        terminal.await_text("> ")
        terminal.ask("check", "sound: 1 points, 0 vertices, dimension 0\r\n")
        terminal.ask("redo", "2 points\r\n")
        terminal.ask("load many.csv", "points 3 to 100002\r\n")
        terminal.enter("show many.png")
        time.sleep(1)
        terminal.type_ahead(CTRL_C)
        terminal.await_text("interrupted: nothing is changed\r\n")
        terminal.await_text("> ")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["many.csv"])
        terminal.ask("undo", "2 points\r\n")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_ctrl_c_while_a_watched_picture_is_drawn_takes_the_change_back(self):
        generator = random.Random(6)
        points = "".join(",".join(repr(generator.random()) for _ in range(3)) + "\n" for _ in range(20_000))
        self.write("many.csv", points)
        terminal = self.greeted("--dim", "3")
        terminal.ask("watch a.png", "a.png is written, and will be after each change\r\n")
        empty = (self.folder / "a.png").read_bytes()
        terminal.enter("load many.csv")
        time.sleep(1.5)
        terminal.type_ahead(CTRL_C)
        terminal.await_text("interrupted: nothing is changed\r\n")
        terminal.await_text("> ")
        terminal.ask("check", "sound: 0 points, 0 vertices, dimension -1\r\n")
        self.assertEqual((self.folder / "a.png").read_bytes(), empty)
        terminal.ask("add 1 2 3", "point 1\r\n")
        self.assertNotEqual((self.folder / "a.png").read_bytes(), empty)
        terminal.ask("watch off", "a.png is written no more\r\n")
        terminal.enter("quit")
        self.assertEqual(terminal.status(), 0)

    def test_ctrl_d_ends(self):
        terminal = self.greeted()
        terminal.ask("add 1 2", "point 1\r\n")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.status(), 0)

    def test_a_pipe_sees_no_prompt(self):
        commands = "add 1 2\nadd 3 4\nhelp\nundo\nnearest 9 9\n"
        ran = subprocess.run([PROGRAM, "tessel"], cwd=self.folder, timeout=LONGEST, text=True, input=commands,
                             capture_output=True, check=False)
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, "point 1 1 2\n", ""))

    def test_typed_into_a_pipe_the_prompt_stays_on_the_terminal(self):
        ours, theirs = os.pipe()
        self.addCleanup(os.close, ours)
        terminal = self.session(output=theirs)
        os.close(theirs)
        terminal.await_text("> ")
        terminal.enter("add 1 2")
        terminal.await_text("> ")
        terminal.enter("help")
        terminal.await_text("> ")
        terminal.ask("fly", "error: there is no command 'fly'")
        terminal.enter("nearest 0 0")
        terminal.await_text("> ")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.status(), 0)
        with os.fdopen(os.dup(ours), "rb") as printed:
            self.assertEqual(printed.read(), b"point 1 1 2\n")


if __name__ == "__main__":
    unittest.main()
