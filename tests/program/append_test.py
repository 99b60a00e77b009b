"""`rain --append`: a table that has grown is, byte for byte, the table that one run writes of all readings, whatever had
been written before, and wherever an earlier writer was ended.
"""

import os
import subprocess
import unittest

from thiessen import PROGRAM, ProgramTest


class AppendTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("s.csv", "id,x,y\nA,2,3\nB,7,5\nC,4,8\n")
        self.write("b.csv", 'id,WKT\nQ,"POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"\n'
                            '"R, the second","POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))"\n')
        self.rows = [f"2020-01-{d:02}T{h:02}:00,{d + h},{'' if h == 12 else d},{h / 7:.2f}"
                     for d in range(1, 6) for h in range(0, 24, 6)]

    def readings(self, rows, name="r.csv"):
        return self.write(name, "time,A,B,C\n" + "".join(row + "\n" for row in rows))

    def run_rain(self, output, *options, rainfall="r.csv"):
        return self.run_program("rain", "s.csv", "b.csv", rainfall, "--metric", "planar", "-o", output, *options)

    def rain(self, output, *options, rainfall="r.csv"):
        """Runs it, and returns what it says."""
        ran = self.run_rain(output, *options, rainfall=rainfall)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stderr

    def bytes(self, name):
        return (self.folder / name).read_bytes()

    def test_parts_make_the_whole(self):
        for options in ((), ("--long",), ("--error",), ("--method", "all", "--long"), ("--long", "--error"),
                        ("--every", "day"), ("--every", "day", "--long"), ("--iso-times",)):
            least = 12 if "--error" in options else 4  # standard errors need ten steps
            for parts in ((least, 20), (least, least, 16, 20)):
                for path in self.folder.glob("[gw].csv"):
                    path.unlink()
                for part in parts:
                    self.readings(self.rows[:part])
                    said = self.rain("g.csv", "--append", *options)
                self.rain("w.csv", *options)
                if "--error" in options:  # of a variogram of the steps that there were
                    self.assertEqual(len(self.bytes("g.csv").splitlines()), len(self.bytes("w.csv").splitlines()))
                else:
                    self.assertEqual(self.bytes("g.csv"), self.bytes("w.csv"), options)
                self.assertRegex(said, r"notice: g.csv: \d+ (step|period)s? added, \d+ w(as|ere) there")

    def test_a_table_that_was_cut_anywhere_is_mended(self):
        for options, rows, apart in (((), 2, 2), (("--long",), 2, 7), (("--every", "day"), 4, 7)):
            self.readings(self.rows[:rows])
            (self.folder / "w.csv").unlink(missing_ok=True)
            self.rain("w.csv", *options)
            whole = self.bytes("w.csv")
            header = whole.index(b"\n") + 1
            for kept in [0, *range(header, len(whole), apart), len(whole) - 1, len(whole)]:
                (self.folder / "g.csv").write_bytes(whole[:kept])
                self.rain("g.csv", "--append", *options)
                self.assertEqual(self.bytes("g.csv"), whole, f"{options}, of {kept} bytes")
            for kept in range(1, header, 7):
                (self.folder / "g.csv").write_bytes(whole[:kept])
                self.assertEqual(self.run_rain("g.csv", "--append", *options).returncode, 1)
                self.assertEqual(self.bytes("g.csv"), whole[:kept])

    def test_steps_that_are_there_are_left_alone(self):
        self.readings(self.rows)
        self.rain("g.csv", "--append")
        before = os.stat(self.folder / "g.csv")
        self.assertIn("no steps added, 20 were there", self.rain("g.csv", "--append"))
        self.assertIn("no steps added, 20 were there", self.rain("g.csv", "--append", "--from", "2020-01-03"))
        after = os.stat(self.folder / "g.csv")
        self.assertEqual((before.st_ino, before.st_mtime_ns), (after.st_ino, after.st_mtime_ns))

    def test_line_ends_mode_and_times_written_otherwise_are_kept(self):
        self.readings(self.rows[:2])
        self.rain("g.csv")
        self.rain("w.csv")
        (self.folder / "g.csv").write_bytes(self.bytes("g.csv").replace(b"\n", b"\r\n"))
        os.chmod(self.folder / "g.csv", 0o640)
        self.readings([row.replace("T", " ") for row in self.rows[:3]])
        self.assertIn("1 step added, 2 were there", self.rain("g.csv", "--append"))
        self.assertEqual(self.bytes("g.csv").count(b"\r\n"), 4)
        self.assertTrue(self.bytes("g.csv").startswith(self.bytes("w.csv").replace(b"\n", b"\r\n")))
        self.assertEqual(os.stat(self.folder / "g.csv").st_mode & 0o777, 0o640)

    def test_the_last_period_is_added_once_it_is_whole(self):
        self.readings(self.rows[:6])
        said = self.rain("g.csv", "--append", "--every", "day")
        self.assertIn("the last period, 2020-01-02, is left out, as it may not be over: it lacks 2 of 4 steps", said)
        self.assertEqual(len(self.bytes("g.csv").splitlines()), 2)
        self.readings(self.rows[:8])
        self.assertIn("1 period added, 1 was there", self.rain("g.csv", "--append", "--every", "day"))

    def test_a_failure_leaves_the_table_as_it_was(self):
        self.readings(self.rows[:4])
        self.rain("g.csv", "--append")
        before = self.bytes("g.csv")
        self.readings(self.rows[:8] + ["2020-01-09T00:00,1,bad,3"])
        self.assertEqual(self.run_rain("g.csv", "--append").returncode, 1)
        self.assertEqual(self.bytes("g.csv"), before)
        self.readings(self.rows)
        ran = subprocess.run(["bash", "-c", f"ulimit -f 0; exec '{PROGRAM}' rain s.csv b.csv r.csv --metric planar "
                              "-o g.csv --append"], cwd=self.folder, capture_output=True, check=False)
        self.assertNotEqual(ran.returncode, 0)
        self.assertEqual(self.bytes("g.csv"), before)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["b.csv", "g.csv", "r.csv", "s.csv"])

    def test_runs_at_once_add_each_step_once(self):
        self.readings(self.rows)
        self.rain("w.csv")
        for there in (True, False):
            (self.folder / "g.csv").unlink(missing_ok=True)
            if there:
                (self.folder / "g.csv").write_bytes(b"".join(self.bytes("w.csv").splitlines(True)[:3]))
            command = [PROGRAM, "rain", "s.csv", "b.csv", "r.csv", "--metric", "planar", "-o", "g.csv", "--append"]
            runs = [subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE) for _ in range(6)]
            said = [run.communicate()[1] for run in runs]
            done = [run.returncode for run in runs]
            # Of those that find no table only the first can make it.
            self.assertIn(0, done, said)
            if there:
                self.assertEqual(done, [0] * 6, said)
            self.assertEqual(self.bytes("g.csv"), self.bytes("w.csv"))


if __name__ == "__main__":
    unittest.main()
