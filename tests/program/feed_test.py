"""Readings that come by a pipe, row by row: each step is written before anything else has to come. Nothing here is judged
by the clock: a row is fed only once the test has read what the rows before it tell.
"""

import os
import signal
import subprocess
import threading
import unittest

from thiessen import PROGRAM, ProgramTest

# So long a machine that is busy with other things may take for what is promised within a second.
LONGEST = 60


class Feed:
    """A run of the program that is fed, and whose output is read line by line."""

    def __init__(self, folder, *arguments, stdin=subprocess.PIPE):
        self.process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=folder, stdin=stdin,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.lines = self.process.stdout
        self.timer = threading.Timer(LONGEST, self.process.kill)
        self.timer.start()

    def feed(self, text):
        self.process.stdin.write(text.encode())
        self.process.stdin.flush()

    def line(self):
        """The next line of the output; empty where there is none within a minute."""
        return self.lines.readline().decode()

    def end(self):
        """The rest of the output, the messages and the exit status, once the pipe has ended."""
        if self.process.stdin and not self.process.stdin.closed:
            self.process.stdin.close()
        return self.wait()

    def wait(self):
        """The same of a run that ends though its pipe does not."""
        rest = self.lines.read().decode()
        messages = self.process.stderr.read().decode()
        status = self.process.wait()
        self.close()
        return rest, messages, status

    def close(self):
        self.timer.cancel()
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            if stream:
                try:
                    stream.close()
                except BrokenPipeError:
                    pass


class FedTest(ProgramTest):
    """A square of 10 by 10 with a gauge in the middle of each half: a step is the mean of A and B."""

    def setUp(self):
        super().setUp()
        self.write("s.csv", "id,x,y\nA,2.5,5\nB,7.5,5\n")
        self.write("b.csv", 'id,WKT\nQ,"POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"\n')

    def rain(self, rainfall, *options, **settings):
        return Feed(self.folder, "rain", "s.csv", "b.csv", rainfall, "--metric", "planar", *options, **settings)


class FeedTest(FedTest):
    def test_a_row_is_written_before_the_next_one_comes(self):
        for threads in ("1", "2", "5"):
            feed = self.rain("-", "--threads", threads)
            feed.feed("time,A,B\n2020-01-01,1,2\n")
            self.assertEqual(feed.line(), "time,Q\n")
            self.assertEqual(feed.line(), "2020-01-01,1.500\n")
            feed.feed("2020-01-02,3,4\n2020-01-03,5,6\n2020-01-")
            self.assertEqual(feed.line(), "2020-01-02,3.500\n")
            self.assertEqual(feed.line(), "2020-01-03,5.500\n")
            feed.feed("04,7,\n")
            self.assertEqual(feed.line(), "2020-01-04,7.000\n")
            rest, messages, status = feed.end()
            self.assertEqual((rest, status), ("", 0), messages)

    def test_a_named_pipe_and_dev_stdin_are_fed_too(self):
        os.mkfifo(self.folder / "p")
        feed = self.rain("p", stdin=subprocess.DEVNULL)
        with open(self.folder / "p", "w", encoding="utf-8") as pipe:
            for step in ("time;A;B\r\n1;1,5;2\r\n", "2;3;4\r\n", "3;5;6,25\r\n"):
                pipe.write(step)
                pipe.flush()
                if step.startswith("time"):
                    self.assertEqual(feed.line(), "time,Q\n")
                self.assertRegex(feed.line(), r"^[123],\d\.\d{3}\n$")
        self.assertEqual(feed.wait()[2], 0)
        feed = self.rain("/dev/stdin")
        feed.feed("time,A,B\n1,1,2\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n1,1.500\n")
        self.assertEqual(feed.end()[2], 0)

    def test_a_long_step_is_written_once_all_have_reported_or_another_has_begun(self):
        feed = self.rain("-", "--long")
        feed.feed("time,station,rain\n1,A,1\n")
        feed.feed("1,B,3\n")  # had the step been written before, its value would be 1
        self.assertEqual(feed.line(), "time,basin,rainfall,gauges,coverage\n")
        self.assertEqual(feed.line(), "1,Q,2.000,2,1\n")
        feed.feed("2,B,6\n")
        feed.feed("3,A,4\n")
        self.assertEqual(feed.line(), "2,Q,6.000,1,0.5\n")
        feed.feed("4,A,1\n")
        self.assertEqual(feed.line(), "3,Q,4.000,1,0.5\n")
        self.assertEqual(feed.end(), ("4,Q,1.000,1,0.5\n", feed_notices(), 0))

    def test_a_long_file_in_a_pipe_is_sorted_as_ever(self):
        rows = "".join(f"{2000 + t},{s},{t % 7}\n" for s in "AB" for t in range(3000))
        self.write("r.csv", "time,station,rain\n" + rows)
        wanted = self.output("rain", "s.csv", "b.csv", "r.csv", "--metric", "planar")
        feed = self.rain("-")
        feed.feed("time,station,rain\n" + rows)
        self.assertEqual(feed.end()[0], wanted)

    def test_times_that_come_back_after_their_step_was_written_are_an_error(self):
        feed = self.rain("-")
        feed.feed("time,station,rain\n1,A,1\n2,A,1\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n1,1.000\n")
        feed.feed("1,B,3\n")
        rest, messages, status = feed.wait()
        self.assertEqual((rest, status), ("", 1))
        self.assertIn("standard input:4: time '1' comes when its step, or one behind it, has been written", messages)

    def test_several_methods_have_rows_as_they_come(self):
        feed = self.rain("-", "--method", "all")
        feed.feed("time,A,B\n1,1,2\n")
        self.assertTrue(feed.line().startswith("time,Q_thiessen"))
        self.assertTrue(feed.line().startswith("1,1.500,"))
        feed.feed("2,3,4\n")
        self.assertTrue(feed.line().startswith("2,3.500,"))
        self.assertEqual(feed.end()[2], 0)

    def test_a_period_is_written_when_another_begins(self):
        feed = self.rain("-", "--every", "day")
        feed.feed("time,A,B\n2020-01-01T00:00,1,2\n2020-01-01T12:00,1,2\n2020-01-02T00:00,1,1\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q,Q_missing\n2020-01-01,3.000,0\n")
        feed.feed("2020-01-04T00:00,1,1\n")
        self.assertEqual(feed.line() + feed.line(), "2020-01-02,,1\n2020-01-03,,2\n")
        self.assertEqual(feed.end()[::2], ("2020-01-04,,1\n", 0))

    def test_the_first_row_tells_in_which_columns_the_time_stands(self):
        feed = self.rain("-")
        feed.feed("date,time,station,rain\n2020-01-01,06:00,A,1\n2020-01-01,06:00,B,3\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n2020-01-01 06:00,2.000\n")
        self.assertEqual(feed.end()[2], 0)
        feed = self.rain("-")
        feed.feed("YEAR,DOY,A,B\n2020,60,1,3\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n2020-02-29,2.000\n")
        self.assertEqual(feed.end()[2], 0)

    def test_rates_count_times_the_step_that_the_first_period_tells(self):
        feed = self.rain("-", "--every", "day")  # 1 mm/h in two steps of 12 hours is 24 mm
        feed.feed("time,station,rain (mm/h)\n2020-01-01T00:00,A,1\n2020-01-01T12:00,A,1\n2020-01-02T00:00,A,2\n"
                  "2020-01-02T12:00,A,2\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q,Q_missing\n2020-01-01,24.000,0\n")
        feed.feed("2020-01-02T13:00,A,1\n2020-01-02T14:00,A,1\n")
        rest, messages, status = feed.wait()
        self.assertEqual((rest, status), ("", 1))
        self.assertIn("time '2020-01-02T13:00' in line 6 lies no whole steps of 12 hours", messages)

    def test_a_range_of_times_holds_nothing_back(self):
        feed = self.rain("-", "--from", "2020", "--to", "2021")
        feed.feed("time,A,B\n2019,0,0\n2020,1,2\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n2020,1.500\n")
        feed.feed("2021,1,3\n2022,1,1\n")
        self.assertEqual(feed.line(), "2021,2.000\n")
        self.assertEqual(feed.end()[::2], ("", 0))

    def test_a_bad_row_is_told_at_once_and_what_came_before_it_is_written(self):
        for row, said in (("2,x,1", "reading 'x' of station 'A' is no number"), ("2,1", "row has 2 fields"),
                          ("1,1,2", "time '1' is already in line 2"), ("2,-1,2", "negative reading")):
            feed = self.rain("-")
            feed.feed(f"time,A,B\n1,1,2\n{row}\n3,1,2\n")
            rest, messages, status = feed.wait()
            self.assertEqual((rest, status), ("time,Q\n1,1.500\n", 1), messages)
            self.assertIn("standard input:3: " + said, messages)

    def test_what_was_found_out_is_told_before_the_first_row(self):
        feed = self.rain("-")
        feed.feed("time;A;B\n1;1;2\n")
        self.assertEqual(feed.line() + feed.line(), "time,Q\n1,1.500\n")
        said = os.read(feed.process.stderr.fileno(), 10_000).decode()
        self.assertIn("notice: standard input: its fields are parted by semicolons", said)
        self.assertEqual(feed.end()[2], 0)

    def test_ctrl_c_is_heard_while_nothing_comes(self):
        for fed in ("", "time,A,B\n1,1,2\n"):
            feed = self.rain("-")
            feed.feed(fed)
            if fed:
                self.assertEqual(feed.line() + feed.line(), "time,Q\n1,1.500\n")
            await_handler(feed.process.pid)
            feed.process.send_signal(signal.SIGINT)
            rest, messages, status = feed.wait()
            self.assertEqual((rest, status), ("", 130), messages)

    def test_where_nobody_reads_it_ends_quietly(self):
        feed = self.rain("-", "-q")
        feed.feed("time,A,B\n1,1,2\n")
        self.assertEqual(feed.line(), "time,Q\n")
        feed.process.stdout.close()
        self.assertEqual(feed.process.wait(LONGEST), 1)  # though its input has not ended
        self.assertEqual(feed.process.stderr.read(), b"")
        feed.close()

    def test_a_file_appears_whole_in_the_end(self):
        feed = self.rain("-", "-o", "r.csv")
        feed.feed("time,A,B\n1,1,2\n")
        feed.feed("2,1,3\n")
        self.assertFalse((self.folder / "r.csv").exists())
        self.assertEqual(feed.end()[2], 0)
        self.assertEqual((self.folder / "r.csv").read_text(), "time,Q\n1,1.500\n2,2.000\n")


class AppendedFeedTest(FedTest):
    """`--append` from a pipe: the file grows step by step, and what it has is passed over."""

    def appended(self):
        return (self.folder / "r.csv").read_text()

    def await_file(self, text):
        """Waits until the file holds this text."""
        for _ in range(LONGEST * 50):
            if (self.folder / "r.csv").exists() and self.appended() == text:
                return
            threading.Event().wait(0.02)
        self.assertEqual(self.appended(), text)

    def test_steps_are_added_as_they_come(self):
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,A,B\n2020,1,2\n")
        self.await_file("time,Q\n2020,1.500\n")
        feed.feed("2021,1,3\n")
        self.await_file("time,Q\n2020,1.500\n2021,2.000\n")
        feed.process.kill()
        feed.wait()
        with open(self.folder / "r.csv", "a", encoding="utf-8") as table:
            table.write("2022,1.")  # as a writer leaves it that the power failed
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,A,B\n2020,1,2\n2021,1,3\n2022,1,1\n2023,2,2\n")
        self.await_file("time,Q\n2020,1.500\n2021,2.000\n2022,1.000\n2023,2.000\n")
        feed.feed("2024,x,2\n")
        _, messages, status = feed.wait()
        self.assertEqual(status, 1, messages)
        self.assertEqual(self.appended(), "time,Q\n2020,1.500\n2021,2.000\n2022,1.000\n2023,2.000\n")
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,A,B\n2023,2,2\n2024,0,2\n")
        _, messages, status = feed.end()
        self.assertEqual(status, 0)
        self.assertIn("notice: r.csv: 1 step added, 4 were there", messages)

    def test_a_step_that_comes_again_is_written_once(self):
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,A,B\n2020-03-04,1,2\n")
        self.await_file("time,Q\n2020-03-04,1.500\n")
        feed.feed("2020-03-04,1,2\n2020-03-05,1,3\n2020-03-04,1,2\n")
        self.await_file("time,Q\n2020-03-04,1.500\n2020-03-05,2.000\n")
        feed.feed("2020-03-04,1,9\n2020-03-06,1,1\n")
        self.await_file("time,Q\n2020-03-04,1.500\n2020-03-05,2.000\n2020-03-06,1.000\n")
        _, messages, status = feed.end()
        self.assertEqual(status, 0, messages)
        self.assertIn("warning: standard input:6: time '2020-03-04' comes again with other readings", messages)
        self.assertIn("notice: standard input: 3 steps that came again are passed over, the first is '2020-03-04'", messages)
        self.assertIn("notice: r.csv: 3 steps added, none were there", messages)
        self.assertEqual(self.appended(), "time,Q\n2020-03-04,1.500\n2020-03-05,2.000\n2020-03-06,1.000\n")

    def test_a_step_that_comes_again_is_no_part_of_a_total(self):
        feed = self.rain("-", "-o", "r.csv", "--append", "--every", "day")
        feed.feed("time,A,B\n2020-03-04T00:00,1,2\n2020-03-04T12:00,1,2\n")
        feed.feed("2020-03-04T12:00,1,2\n2020-03-05T00:00,0,0\n")
        self.await_file("time,Q,Q_missing\n2020-03-04,3.000,0\n")
        self.assertEqual(feed.end()[2], 0)

    def test_long_rows_of_a_step_that_is_written_are_passed_over(self):
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,station,rain\n1,A,1\n1,A,1\n1,B,3\n")
        self.await_file("time,Q\n1,2.000\n")
        feed.feed("1,A,1\n1,B,3\n2,A,4\n2,B,6\n")
        self.await_file("time,Q\n1,2.000\n2,5.000\n")
        _, messages, status = feed.end()
        self.assertEqual(status, 0, messages)
        self.assertEqual(messages.count("comes when its step has been written, and is passed over"), 1, messages)

    def test_nothing_is_left_of_a_feed_without_a_step(self):
        feed = self.rain("-", "-o", "r.csv", "--append")
        feed.feed("time,A,B\n2024,x,2\n")
        self.assertEqual(feed.wait()[2], 1)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["b.csv", "s.csv"])


def feed_notices():
    return ("thiessen: notice: standard input: all 2 stations make the network, whether they report or not: RAINFALL is "
            "read only once\n")


def await_handler(pid):
    """Waits until a process catches Ctrl-C."""
    for _ in range(LONGEST * 50):
        with open(f"/proc/{pid}/status", encoding="utf-8") as status:
            caught = next(line for line in status if line.startswith("SigCgt"))
        if int(caught.split()[1], 16) & 1 << signal.SIGINT - 1:
            return
        threading.Event().wait(0.02)


if __name__ == "__main__":
    unittest.main()
