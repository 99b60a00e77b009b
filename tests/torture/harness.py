"""A row of the list: a folder of its own, what the program does there, and what must hold of every run."""

import csv
import io
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from fractions import Fraction

TESTS = pathlib.Path(__file__).resolve().parents[1]
SAMPLES = TESTS.parent / "samples"
ROWS = {}


class NotTried(Exception):
    """What this machine lacks for a row."""


class Ran:
    def __init__(self, status, out, err, seconds, megabytes):
        self.status, self.out, self.err, self.seconds, self.megabytes = status, out, err, seconds, megabytes

    def rows(self):
        return list(csv.DictReader(io.StringIO(self.out, newline="")))

    def weights(self):
        found = {}
        for row in self.rows():
            found.setdefault(row["basin"], {})[row["station"]] = float(row["weight"])
        return found


def row(number, about):
    def note(function):
        ROWS[number] = (about, function)
        return function
    return note


def square(x0, y0, x1, y1):
    return f"POLYGON (({x0} {y0}, {x1} {y0}, {x1} {y1}, {x0} {y1}, {x0} {y0}))"


def geojson(*polygons, **members):
    features = [{"type": "Feature", "properties": {"id": f"B{i + 1}"},
                 "geometry": {"type": "Polygon", "coordinates": rings}} for i, rings in enumerate(polygons)]
    return json.dumps({"type": "FeatureCollection", **members, "features": features})


def clipped(polygon, a, b, c):
    """The part of an exact polygon where a x + b y <= c."""
    out = []
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        d0, d1 = a * x0 + b * y0 - c, a * x1 + b * y1 - c
        if d0 <= 0:
            out.append((x0, y0))
        if (d0 < 0 < d1) or (d1 < 0 < d0):
            share = d0 / (d0 - d1)
            out.append((x0 + share * (x1 - x0), y0 + share * (y1 - y0)))
    return out


def exact_shares(points, box):
    """Each point's share of the box, by half-planes in fractions: a cell is what is left of the box."""
    places = [(Fraction(x), Fraction(y)) for x, y in points]
    x0, y0, x1, y1 = map(Fraction, box)
    shares = []
    for px, py in places:
        cell = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        nearest_first = sorted(places, key=lambda q: (q[0] - px) ** 2 + (q[1] - py) ** 2)
        for qx, qy in nearest_first:
            if (qx, qy) == (px, py) or not cell:
                continue
            cell = clipped(cell, 2 * (qx - px), 2 * (qy - py), qx * qx - px * px + qy * qy - py * py)
        doubled = sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(cell, cell[1:] + cell[:1]))
        shares.append(doubled / 2 / ((x1 - x0) * (y1 - y0)))
    return shares


class Case:
    """What a row works with. Faults that it finds are gathered."""

    def __init__(self, options, folder):
        self.options, self.folder, self.faults = options, folder, []

    # What there is

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content) if isinstance(content, bytes) else path.write_text(content, encoding="utf-8", newline="")
        return name

    def stations(self, points, name="stations.csv", head="id,x,y"):
        return self.write(name, head + "\n" + "".join(f"S{i},{x!r},{y!r}\n" for i, (x, y) in enumerate(points)))

    def basins(self, *shapes, name="basin.csv"):
        rows = "".join(f'B{i + 1},"{shape}"\n' for i, shape in enumerate(shapes))
        return self.write(name, "id,WKT\n" + rows)

    def names(self):
        return sorted(p.relative_to(self.folder).as_posix() for p in self.folder.rglob("*"))

    def read(self, name):
        return (self.folder / name).read_bytes()

    # What is found

    def fault(self, text):
        self.faults.append(" ".join(str(text).split())[:300])

    def hold(self, is_so, text):
        if not is_so:
            self.fault(text)

    # What is run

    def run(self, *arguments, seconds=60, megabytes=2000, stdin=None, limits=(), env=None, shell=None, user=None, cwd=None,
            text=True):
        """Runs the program; whatever it is given, no signal ends it, and it leaves no hidden file."""
        def prepare():
            for limit, value in limits:
                resource.setrlimit(limit, (value, value))
            if user is not None:
                os.setgroups([])
                os.setgid(user)
                os.setuid(user)
        environment = {"PATH": "/usr/bin:/bin", "HOME": str(self.folder), "LC_ALL": "C.UTF-8", **(env or {})}
        environment = {name: value for name, value in environment.items() if value is not None}
        command = ["bash", "-c", shell, self.options.program] if shell else [self.options.program, *map(str, arguments)]
        begin = time.monotonic()
        source = subprocess.PIPE if isinstance(stdin, bytes) else stdin or subprocess.DEVNULL
        # By pipes, for a limit on the size of files is one on what is printed into a file.
        with subprocess.Popen(command, cwd=cwd or self.folder, env=environment, stdin=source, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, preexec_fn=prepare) as process:
            printed = [[], []]
            listeners = [threading.Thread(target=lambda s=stream, p=parts: p.append(s.read()))
                         for stream, parts in zip((process.stdout, process.stderr), printed)]
            for listener in listeners:
                listener.start()
            try:
                if isinstance(stdin, bytes):
                    try:
                        process.stdin.write(stdin)
                        process.stdin.close()
                    except BrokenPipeError:
                        pass
                status, usage = self.wait(process, begin + 4 * seconds)
            except TimeoutError:
                process.kill()
                process.wait()
                self.fault(f"{self.said(arguments, shell)} hangs")
                return Ran(-9, "", "", 4 * seconds, 0)
            finally:
                for listener in listeners:
                    listener.join(10)
        output, errors = b"".join(printed[0]), b"".join(printed[1]).decode("utf-8", "backslashreplace")
        ran = Ran(status, output.decode("utf-8", "backslashreplace") if text else output, errors,
                  usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
        if status < 0 or (shell and status > 128 and status not in (130, 143, 129)):
            self.fault(f"{self.said(arguments, shell)} is ended by a signal ({status}): {errors[-200:]}")
        if "a fault of the program itself" in errors:
            self.fault(f"{self.said(arguments, shell)}: {errors[-200:]}")
        if ran.seconds > seconds:
            self.fault(f"{self.said(arguments, shell)} takes {ran.seconds:.0f} s of processor time")
        if ran.megabytes > megabytes:
            self.fault(f"{self.said(arguments, shell)} takes {ran.megabytes:.0f} MB")
        hidden = [name for name in self.names() if ".thiessen-" in name]
        self.hold(not hidden, f"{self.said(arguments, shell)} leaves {hidden}")
        return ran

    @staticmethod
    def wait(process, until):
        while time.monotonic() < until:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = os.waitstatus_to_exitcode(status)
                return process.returncode, usage
            time.sleep(0.005)
        raise TimeoutError

    @staticmethod
    def said(arguments, shell):
        words = shell or " ".join(map(str, arguments))
        return "thiessen " + (words if len(words) < 90 else words[:90] + "...")

    def done(self, *arguments, **settings):
        ran = self.run(*arguments, **settings)
        if ran.status != 0:
            self.fault(f"{self.said(arguments, settings.get('shell'))}: exit {ran.status}: {ran.err[-250:]}")
        return ran

    def fails(self, *arguments, status=1, says="", **settings):
        """It fails as it should, with a message that has these words, and writes nothing."""
        before = self.names()
        ran = self.run(*arguments, **settings)
        words = self.said(arguments, settings.get("shell"))
        if ran.status != status:
            self.fault(f"{words}: exit {ran.status}, not {status}: {ran.err[-200:]}")
        elif "thiessen: error: " not in ran.err:
            self.fault(f"{words}: no message: {ran.err[-200:]}")
        elif says and says.lower() not in ran.err.lower():
            self.fault(f"{words}: the message does not say {says!r}: {ran.err[-250:]}")
        left = sorted(set(self.names()) - set(before))
        self.hold(not left, f"{words} leaves {left}")
        return ran

    # What is measured

    def exact(self, points, box, tolerance=1e-9):
        """Weights in a box are those of exact half-planes."""
        x0, y0, x1, y1 = box
        self.stations(points)
        self.basins(square(*(repr(v) for v in (x0, y0, x1, y1))))
        found = self.done("weights", "stations.csv", "basin.csv", "--metric", "planar").weights().get("B1", {})
        for i, share in enumerate(exact_shares(points, box)):
            if abs(found.get(f"S{i}", 0) - float(share)) > tolerance:
                self.fault(f"the weight of {points[i]} is {found.get(f'S{i}', 0)}, exactly {float(share)}")
                return
        self.hold(abs(sum(found.values()) - 1) < 1e-9, f"weights add up to {sum(found.values())}")

    def session(self, *lines, dim=2, **settings):
        script = self.write("script.txt", "".join(line + "\n" for line in lines))
        return self.run("tessel", "--dim", dim, script, **settings)

    def points(self, places, name="points.csv"):
        return self.write(name, "".join(",".join(map(repr, place)) + "\n" for place in places))

    def sound(self, places, dim=2, **settings):
        """The tessellation of these points proves sound."""
        self.points(places)
        ran = self.session("load points.csv", "check", dim=dim, **settings)
        if ran.status != 0 or "sound:" not in ran.out:
            self.fault(f"{len(places)} points: exit {ran.status}: {ran.out[-100:]} {ran.err[-200:]}")
        return ran

    def cells_are_valid(self, *arguments):
        """Cells are written without an edge of no length, and cover the basin."""
        ran = self.done("cells", *arguments, "-o", "-")
        if ran.status != 0:
            return
        share = {}
        for feature in json.loads(ran.out)["features"]:
            of = feature["properties"]
            share[of.get("basin")] = share.get(of.get("basin"), 0) + of["weight"]
            shapes = feature["geometry"]["coordinates"]
            for rings in [shapes] if feature["geometry"]["type"] == "Polygon" else shapes:
                for ring in rings:
                    if ring[0] != ring[-1] or len(ring) < 4 or any(a == b for a, b in zip(ring, ring[1:])):
                        self.fault(f"a ring of {of['station']} is none: {ring[:6]}")
                        return
        for basin, sum_of in share.items():
            self.hold(abs(sum_of - 1) < 1e-9, f"the weights in {basin} add up to {sum_of}")

    def golden(self, *rows):
        """The golden cases of these rows pass."""
        cases = [path for path in sorted((TESTS / "golden").rglob("*.case"))
                 if any(name in path.read_text(encoding="utf-8").partition("\n")[0] or path.stem.startswith(name)
                        for name in rows)]
        self.cases(cases)

    def cases(self, cases):
        if not cases:
            self.fault("it has no golden case")
            return
        ran = subprocess.run([sys.executable, "-B", TESTS / "golden" / "run.py", "--program", self.options.program, *cases],
                             capture_output=True, text=True, check=False)
        if ran.returncode != 0:
            self.fault(f"golden cases: {ran.stdout[-250:]}")

    def golden_folder(self, *folders):
        self.cases([path for folder in folders for path in sorted((TESTS / "golden" / folder).glob("*.case"))])


def need(tool):
    found = shutil.which(tool)
    if found is None:
        raise NotTried(f"{tool} is not installed")
    return found


def small_study(case):
    """Three gauges, a basin, three steps."""
    case.write("stations.csv", "id,x,y\nA,2,2\nB,8,3\nC,5,8\n")
    case.basins(square(0, 0, 10, 10))
    case.write("rainfall.csv", "time,A,B,C\n2020-01-01,1,2,3\n2020-01-02,4,,6\n2020-01-03,0,0,0\n")
    return ["stations.csv", "basin.csv"], ["stations.csv", "basin.csv", "rainfall.csv"]


PLANAR = ("--metric", "planar")
SIGNALS = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}
