"""Ctrl-C is heard within half a second of processor time, by scripts of the session and by other commands, at several
moments of their work; then the exit status is 130 and nothing is left but what was there.
"""

import json
import os
import random
import signal
import subprocess
import tempfile
import time
import unittest

from thiessen import PROGRAM, ProgramTest

# Half a second is promised; a machine that others share counts their misses of its caches as the program's time.
LONGEST = 1.0
MOMENTS = (0.1, 0.4, 0.7)  # of the whole run's processor time
TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(pid):
    """The time that a process has taken so far, and whether it is still running."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS, fields[0] != "Z"


def interrupted_at(command, folder, moment):
    """The exit status, the seconds after Ctrl-C, and all seconds, of a run interrupted after `moment` seconds."""
    with tempfile.TemporaryFile() as output:
        with subprocess.Popen([PROGRAM, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=output,
                              stderr=subprocess.DEVNULL) as process:
            spent, runs = 0, True
            while runs and (moment is None or spent < moment):
                time.sleep(0.005)
                spent, runs = processor_seconds(process.pid)
            if runs:
                os.kill(process.pid, signal.SIGINT)  # send_signal would reap a process that has ended
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        printed = output.read()
    total = usage.ru_utime + usage.ru_stime
    return process.returncode, total - spent, total, printed


class InterruptTest(ProgramTest):
    def assert_heard(self, *command):
        """Interrupts the run at several moments. Files are as before it, or, where it ended first, all are there whole;
        what is printed is the beginning of what the whole run prints.
        """
        before = sorted(p.name for p in self.folder.iterdir())
        status, _, whole, answer = interrupted_at(command, self.folder, None)
        self.assertEqual(status, 0)
        made = [p for p in self.folder.iterdir() if p.name not in before]
        for path in made:
            path.unlink()
        heard = 0
        for share in MOMENTS:
            status, after, _, printed = interrupted_at(command, self.folder, share * whole)
            if status == 0:  # it was done before the signal came
                for path in made:
                    path.unlink(missing_ok=True)
                continue
            heard += 1
            # Before the first line of the program the system itself ends it, which a shell calls 130 too.
            self.assertIn(status, (130, -signal.SIGINT), command)
            self.assertLess(after, LONGEST, f"{command} at {share} of {whole:.2f} s")
            self.assertEqual(sorted(p.name for p in self.folder.iterdir()), before)
            # A run on a loaded machine may have begun to print what a measured run had still to compute.
            self.assertTrue(answer.startswith(printed), f"{command} at {share} of {whole:.2f} s")
        self.assertGreater(heard, 1)

    def points(self, name, count, axes):
        generator = random.Random(axes)
        lines = (",".join(repr(generator.random()) for _ in range(axes)) for _ in range(count))
        return self.write(name, "\n".join(lines) + "\n")

    def test_a_session_in_space_hears(self):
        self.points("p.csv", 30_000, 3)
        for command in ("check", "print", "print t.txt"):
            self.write("s.txt", f"load p.csv\n{command}\n")
            self.assert_heard("tessel", "--dim", "3", "s.txt")

    def test_a_picture_of_space_hears(self):
        self.points("p.csv", 10_000, 3)
        self.write("s.txt", "load p.csv\nshow a.png\n")
        self.assert_heard("tessel", "--dim", "3", "s.txt")

    def test_a_picture_of_the_plane_hears(self):
        self.points("p.csv", 100_000, 2)
        self.write("s.txt", "load p.csv\nshow a.png --size 3000x2000\n")
        self.assert_heard("tessel", "s.txt")

    def test_a_cell_and_a_deletion_with_a_hundred_thousand_neighbours_hear(self):
        generator = random.Random(9)
        with open(self.folder / "hub.csv", "w", encoding="utf-8") as hub:
            hub.write("0,0,0\n")
            for _ in range(100_000):
                place = [generator.gauss(0, 1) for _ in range(3)]
                length = sum(c * c for c in place) ** 0.5
                hub.write(",".join(repr(c / length) for c in place) + "\n")
        for command in ("cell 0 0 0", "delete 0 0 0"):
            self.write("s.txt", f"load hub.csv\n{command}\n")
            self.assert_heard("tessel", "--dim", "3", "s.txt")

    def world(self, gauges):
        generator = random.Random(3)
        rows = [f"S{i},{generator.uniform(-180, 180)!r},{generator.uniform(-80, 80)!r}" for i in range(gauges)]
        self.write("stations.csv", "station,longitude,latitude\n" + "\n".join(rows) + "\n")
        ring = [[-170, -70], [170, -70], [170, 75], [-170, 75], [-170, -70]]
        feature = {"type": "Feature", "properties": {"basin": "W"},
                   "geometry": {"type": "Polygon", "coordinates": [ring]}}
        self.write("basins.geojson", json.dumps({"type": "FeatureCollection", "features": [feature]}))

    def test_maps_cells_and_weights_of_the_world_hear(self):
        self.world(1_000)
        self.assert_heard("map", "stations.csv", "-o", "m.png", "--size", "2000x1250")
        self.assert_heard("cells", "stations.csv", "-o", "c.geojson")
        self.assert_heard("weights", "stations.csv", "basins.geojson", "-o", "w.csv")

    def test_rain_hears(self):
        self.world(300)
        generator = random.Random(4)
        with open(self.folder / "rain.csv", "w", encoding="utf-8") as rain:
            rain.write("time," + ",".join(f"S{i}" for i in range(300)) + "\n")
            for step in range(2000):
                values = (str(generator.randrange(9)) if generator.random() < 0.9 else "" for _ in range(300))
                rain.write(f"{step}," + ",".join(values) + "\n")
        self.assert_heard("rain", "stations.csv", "basins.geojson", "rain.csv", "-o", "r.csv")


if __name__ == "__main__":
    unittest.main()
