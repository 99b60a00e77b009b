"""T077 to T099: files, names, outputs, pictures."""

import errno
import itertools
import json
import math
import os
import random
import resource
import shutil
import struct
import subprocess
import threading
import time

from harness import PLANAR, SIGNALS, NotTried, need, row, small_study, square

for number, about in ((77, "inputs that are no files"), (79, "addresses instead of files"),
                      (95, "pictures of no or endless size"), (104, "options as they come"),
                      (105, "options against each other and out of range")):
    row(number, about)(lambda t, name=f"T{number:03}": t.golden(name))


@row(78, "names of every kind are names")
def _(t):
    study, _ = small_study(t)
    for name in ("a b", "it's", 'say "x"', "$(touch gone)", "two\nlines", "%s%n", ";rm x", "*", "a\\b", "`id`", b"\xff\xfe"):
        folder = os.fsencode(t.folder)
        source, output = os.path.join(folder, os.fsencode(name) + b".csv"), os.fsencode(name) + b"_out.csv"
        shutil.copy(os.path.join(folder, b"stations.csv"), source)
        ran = subprocess.run([t.options.program, "weights", source, study[1], *PLANAR, "-o", output], cwd=t.folder,
                             capture_output=True, check=False)
        t.hold(ran.returncode == 0 and os.path.exists(os.path.join(folder, output)), f"{name!r}: {ran.stderr[-200:]}")
    t.hold(not (t.folder / "gone").exists(), "a name was given to a shell")
    shutil.copy(t.folder / "stations.csv", t.folder / "-s.csv")
    t.done("weights", "./-s.csv", study[1], *PLANAR)


@row(80, "files in disguise, and such as are not whole")
def _(t):
    t.golden("T080")
    t.golden_folder("wholeness")


@row(81, "files that claim to be huge, and such as unpack to a thousand times their size")
def _(t):
    study, readings = small_study(t)
    subprocess.run("head -c 1000000000 /dev/zero | gzip > bomb.csv.gz", shell=True, cwd=t.folder, check=True)
    t.fails("weights", "bomb.csv.gz", study[1], *PLANAR, megabytes=600)
    t.fails("rain", *study, "bomb.csv.gz", *PLANAR, megabytes=600)
    # A GeoTIFF of 1e9 x 1e9 pixels of which there is none.
    tags = [(256, 4, 1, 10 ** 9), (257, 4, 1, 10 ** 9), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 8),
            (277, 3, 1, 1), (278, 4, 1, 10 ** 9), (279, 4, 1, 8), (339, 3, 1, 1)]
    header = b"II*\0" + struct.pack("<I", 16) + b"\0" * 8
    t.write("normals.tif", header + struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", *tag) for tag in tags)
            + b"\0" * 4)
    t.fails("rain", *readings, "--normals", "normals.tif", *PLANAR, megabytes=600)


@row(82, "outputs that are there already")
def _(t):
    t.golden("T082")
    study, _ = small_study(t)
    t.write("w.csv", "old")
    t.fails("weights", *study, *PLANAR, "-o", "w.csv", says="exists already")
    os.chmod(t.folder / "w.csv", 0o640)
    t.done("weights", *study, *PLANAR, "-o", "w.csv", "--overwrite")
    t.hold((t.folder / "w.csv").stat().st_mode & 0o777 == 0o640, "the mode of the replaced file is lost")


@row(83, "outputs that are inputs, links, folders, or in no folder")
def _(t):
    t.golden("T083")
    study, _ = small_study(t)
    os.symlink("stations.csv", t.folder / "link.csv")
    os.link(t.folder / "stations.csv", t.folder / "hard.csv")
    os.symlink("nowhere", t.folder / "dangling.csv")
    os.symlink("loop.csv", t.folder / "loop.csv")
    (t.folder / "folder").mkdir()
    whole = t.read("stations.csv")
    for name in ("stations.csv", "link.csv", "hard.csv", "dangling.csv", "loop.csv", "folder", "no/w.csv",
                 "stations.csv/w.csv"):
        t.fails("weights", *study, *PLANAR, "-o", name, "--overwrite")
    t.hold(t.read("stations.csv") == whole, "an input is changed")


@row(84, "a link that is swapped while the program runs")
def _(t):
    study, _ = small_study(t)
    t.write("precious.csv", "precious")
    stop = threading.Event()

    def swap():
        for name in itertools.cycle(("precious.csv", "other.csv")):
            if stop.is_set():
                return
            try:
                os.symlink(name, t.folder / "new.link")
                os.rename(t.folder / "new.link", t.folder / "w.csv")
            except OSError:
                pass
    thread = threading.Thread(target=swap)
    t.write("other.csv", "other")
    thread.start()
    try:
        for _ in range(200 if t.options.long else 10):
            ran = t.run("weights", *study, *PLANAR, "-o", "w.csv", "--overwrite")
            t.hold(ran.status in (0, 1), f"exit {ran.status}")
    finally:
        stop.set()
        thread.join()
    t.hold(t.read("precious.csv") == b"precious" and t.read("other.csv") == b"other", "a link was followed")


def limited(t, arguments, name, sizes):
    for size in sizes:
        before = t.read(name)
        t.fails(*arguments, limits=[(resource.RLIMIT_FSIZE, size)], says=os.strerror(errno.EFBIG))
        t.hold(t.read(name) == before, f"{name} is changed where the disk is full at byte {size}")


@row(85, "a disk that is full at every byte")
def _(t):
    t.golden("T085")
    study, readings = small_study(t)
    for command, name in ((["weights", *study], "w.csv"), (["rain", *readings], "r.csv"), (["cells", *study], "c.geojson"),
                          (["cells", *study], "c.gpkg"), (["map", *study, "--size", "200"], "m.png")):
        arguments = [*command, *PLANAR, "-q", "-o", name]
        t.done(*arguments)
        size = (t.folder / name).stat().st_size
        if name.endswith(".gpkg"):
            (t.folder / name).unlink()
            t.fails(*arguments, limits=[(resource.RLIMIT_FSIZE, 4096)])
            continue
        t.write(name, "old")
        step = 1 if t.options.long else max(1, size // 6)
        limited(t, [*arguments, "--overwrite"], name, range(0, size, step))
    for arguments in (["weights", *study], ["rain", *readings]):
        t.run(shell=f"\"$0\" {' '.join(arguments)} --metric planar > /dev/full", seconds=20)


def with_faults(t, job, kinds, most):
    if t.options.shim is None:
        raise NotTried("no --shim is given (build/tests/libthiessen_faults.so)")
    import faults
    machine = faults.Machine(t.options.program, t.options.shim)
    _, found = faults.try_all(machine, [job], kinds, most=None if t.options.long else most, tell=lambda line: None)
    for trial, seen in list(found.items())[:3]:
        t.fault(f"{trial}: {seen}")


@row(86, "writing, syncing, closing and renaming that fail")
def _(t):
    with_faults(t, "weights", ("write", "fsync", "close", "rename", "link"), 3)
    with_faults(t, "run", ("fsync", "rename", "link"), 2)


@row(87, "killed at random moments")
def _(t):
    _, readings = small_study(t)
    arguments = ["run", *readings, *PLANAR, "-q", "-o", "out", "--overwrite", "--size", "200"]
    t.done(*arguments)
    whole = {name: t.read(name) for name in t.names() if name.startswith("out/")}
    for number in range(1000 if t.options.long else 25):
        t.write("out/rain.csv", "old")
        with subprocess.Popen([t.options.program, *arguments], cwd=t.folder, stderr=subprocess.DEVNULL) as process:
            time.sleep(random.Random(number).uniform(0, 0.5))
            process.kill()
        now = t.read("out/rain.csv")
        t.hold(now in (b"old", whole["out/rain.csv"]), "rain.csv is neither old nor new")
    t.done(*arguments)
    left = set(t.names()) - set(whole) - {"out"} - {"stations.csv", "basin.csv", "rainfall.csv"}
    t.hold(not left, f"the next run leaves {left}")


@row(88, "signals, a reader that goes away, closed streams")
def _(t):
    t.golden("T088")
    draw = random.Random(88)
    t.stations([(draw.uniform(-180, 180), draw.uniform(-80, 80)) for _ in range(3000)], head="id,lon,lat")
    for one, status in SIGNALS.items():
        for moment in (0.05, 0.3, 0.6):
            with subprocess.Popen([t.options.program, "cells", "stations.csv", "-o", "c.geojson", "--overwrite"],
                                  cwd=t.folder, stderr=subprocess.DEVNULL) as process:
                time.sleep(moment)
                process.send_signal(one)
                ended = process.wait(60)
            # Before its first line the program has not asked for the signal yet, and the system ends it.
            t.hold(ended in (0, status, -one), f"{one.name} after {moment} s: exit {ended}")
            t.hold(not [n for n in t.names() if ".thiessen-" in n], "a hidden file is left")
    study, readings = small_study(t)
    rows = "".join(f"{i},1,2,3\n" for i in range(200_000))
    t.write("rainfall.csv", "time,A,B,C\n" + rows)
    words = f"{' '.join(readings)} --metric planar"
    ran = t.run(shell=f"\"$0\" rain {words} 2>err | head -1 >/dev/null; echo ${{PIPESTATUS[0]}}; cat err")
    t.hold(ran.out.splitlines()[:1] == ["1"] and len(ran.out.splitlines()) == 1, f"a reader that is gone: {ran.out[:200]}")
    for closed in (">&-", "2>&-", "<&-", ">&- 2>&- <&-"):
        t.run(shell=f"\"$0\" weights {' '.join(study)} --metric planar {closed}; test $? -le 1")


@row(89, "runs that write one output at the same time, and a reader")
def _(t):
    study, _ = small_study(t)
    command = [t.options.program, "weights", *study, *PLANAR, "-q", "-o", "w.csv", "--overwrite"]
    t.done(*command[1:])
    whole = t.read("w.csv")
    running = [subprocess.Popen(command, cwd=t.folder, stderr=subprocess.PIPE) for _ in range(20)]
    while any(process.poll() is None for process in running):
        t.hold(t.read("w.csv") == whole, "a reader sees half a file")
    for process in running:
        said = process.stderr.read()
        process.stderr.close()
        t.hold(process.returncode == 0, f"exit {process.returncode}: {said[-200:]}")
    t.hold(sorted(t.names()) == ["basin.csv", "rainfall.csv", "stations.csv", "w.csv"], f"there is {t.names()}")


@row(90, "one of several outputs fails")
def _(t):
    _, readings = small_study(t)
    arguments = ["run", *readings, *PLANAR, "-q", "-o", "out"]
    t.done(*arguments)
    for name in ("rain.csv", "weights.csv", "map.png"):
        t.write(f"out/{name}", "old")
    (t.folder / "out/report.html").unlink()
    (t.folder / "out/report.html").mkdir()
    before = {name: t.read(name) for name in t.names() if (t.folder / name).is_file()}
    t.fails(*arguments, "--overwrite", says="report.html")
    t.hold(all(t.read(name) == content for name, content in before.items()), "some outputs are new, others old")


@row(91, "standard input and output; a terminal and a pipe")
def _(t):
    t.golden("T091")
    study, _ = small_study(t)
    ran = t.done("rain", *study, "-", *PLANAR, stdin=t.read("rainfall.csv"))
    t.hold(ran.out.startswith("time,B1\n") and "\r" not in ran.err + ran.out, "stdout is not pure")


@row(92, "ids that a spreadsheet takes for formulas")
def _(t):
    names = ["=1+1", "@SUM(A1)", "+cmd|' /C calc'!A0", "-2", "\tx"]
    t.write("stations.csv", "id,x,y\n" + "".join(f'"{name}",{i},{i % 2}\n' for i, name in enumerate(names)))
    t.basins(square(-1, -1, 6, 3))
    found = t.done("weights", "stations.csv", "basin.csv", *PLANAR).weights().get("B1", {})
    t.hold({name.strip() for name in names} == {name.strip() for name in found}, f"ids are {list(found)}")


@row(93, "names with markup and with a terminal's commands")
def _(t):
    t.write("stations.csv", 'id,x,y\n"</script><b>",1,1\n"q""\u2028",2,5\nC,8,8\n')
    t.basins(square(0, 0, 10, 10))
    t.write("rainfall.csv", 'time,"</script><b>","q""\u2028",C\n1,1,2,3\n')
    t.done("run", "stations.csv", "basin.csv", "rainfall.csv", *PLANAR, "-q", "-o", "out")
    if (t.folder / "out").exists():
        page = t.read("out/report.html").decode()
        t.hold("</script><b>" not in page, "the page holds a name as markup")
        json.loads(t.read("out/cells.geojson"))
    t.write("bad.csv", "id,x,y\nA\x1b[2J,one,2\n")
    ran = t.fails("weights", "bad.csv", "basin.csv", *PLANAR)
    t.hold("\x1b" not in ran.err, "a terminal's command is printed")


@row(94, "no folder to write, no HOME, no TMPDIR, masks, few descriptors, no /proc")
def _(t):
    study, readings = small_study(t)
    words = " ".join(readings)
    for env in ({"HOME": None}, {"HOME": "/nowhere", "TMPDIR": "/nowhere"}, {"TMPDIR": ""}):
        t.done("run", *readings, *PLANAR, "-q", "-o", "out", "--overwrite", env=env)
    for mask, mode in (("077", 0o600), ("000", 0o666)):
        t.run(shell=f"umask {mask}; \"$0\" weights {' '.join(study)} --metric planar -q -o {mask}.csv")
        t.hold((t.folder / f"{mask}.csv").stat().st_mode & 0o777 == mode, f"umask {mask} is not heard")
    for number in (*range(3, 12), 16, 24):
        ran = t.run("run", *readings, *PLANAR, "-q", "-o", "few", limits=[(resource.RLIMIT_NOFILE, number)])
        t.hold(ran.status in (0, 1, 127), f"{number} descriptors: exit {ran.status}")
        t.hold(ran.status == 0 or not (t.folder / "few").exists(), f"{number} descriptors: a folder is left")
        shutil.rmtree(t.folder / "few", ignore_errors=True)
    if os.geteuid() == 0 and shutil.which("unshare"):
        t.run(shell=f"unshare -m sh -c 'umount -l /proc 2>/dev/null; exec \"$0\" run {words} --metric planar -q -o np' \"$0\"")
        t.hold((t.folder / "np/rain.csv").exists(), "without /proc nothing is written")
    os.chmod(t.folder, 0o755)
    (t.folder / "shut").mkdir(mode=0o555)
    user = 65534 if os.geteuid() == 0 else None
    t.fails("weights", *study, *PLANAR, "-o", "shut/w.csv", user=user, says="ermission denied")


@row(96, "pictures that cannot be written")
def _(t):
    study, _ = small_study(t)
    for name in ("m.bmp", "m.xyz", "no/m.png", "basin.csv/m.png"):
        t.fails("map", *study, *PLANAR, "-o", name, status=2 if "/" not in name else 1)


@row(97, "every pixel's owner")
def _(t):
    translate = need("gdal_translate")
    draw = random.Random(97)
    places = [(draw.uniform(0, 10), draw.uniform(0, 10)) for _ in range(40)]
    t.stations(places)
    t.basins(square(0, 0, 10, 10))
    t.done("map", "stations.csv", "basin.csv", *PLANAR, "-q", "-o", "m.tif", "--resolution", "0.05")
    t.done("weights", "stations.csv", "basin.csv", *PLANAR)
    text = subprocess.run([translate, "-q", "-of", "XYZ", "m.tif", "/vsistdout/"], cwd=t.folder, capture_output=True,
                          text=True, check=True).stdout
    number_of, wrong, tried = {}, 0, 0
    for line in text.splitlines():
        x, y, value = map(float, line.split())
        if not (0 < x < 10 and 0 < y < 10):
            continue
        far = sorted((math.hypot(x - px, y - py), i) for i, (px, py) in enumerate(places))
        if far[1][0] - far[0][0] < 1e-9:
            continue
        tried += 1
        wrong += number_of.setdefault(far[0][1], value) != value
    t.hold(tried > 30_000 and wrong == 0 and len(set(number_of.values())) == len(number_of),
           f"{wrong} of {tried} pixels are another gauge's")


@row(98, "constant rain, none at all, names in other scripts")
def _(t):
    study, _ = small_study(t)
    for values in ("5,5,5", "0,0,0", ",,", "1,,"):
        t.write("rainfall.csv", f"time,A,B,C\n1,{values}\n")
        ran = t.run("map", *study, "rainfall.csv", *PLANAR, "-o", "m.png", "--overwrite")
        t.hold(ran.status in (0, 1), f"rain {values}: exit {ran.status}")
    t.write("stations.csv", "id,x,y\n\u96e8\u91cf,2,2\n\u0e1d\u0e19,8,3\n\u05d2\u05e9\u05dd,5,8\n")
    t.done("map", *study, *PLANAR, "-o", "n.png")


@row(99, "the same bytes twice, with other threads, in other tongues")
def _(t):
    _, readings = small_study(t)
    seen = {}
    for number, (threads, env) in enumerate(((1, {}), (1, {}), (4, {}), (2, {"LC_ALL": "C"}), (2, {"TZ": "Asia/Kathmandu"}))):
        t.done("run", *readings, *PLANAR, "-q", "-o", "out", "--overwrite", "--threads", threads, env=env)
        for name in t.names():
            if name.startswith("out/") and not name.endswith("study.toml"):
                t.hold(seen.setdefault(name, t.read(name)) == t.read(name), f"{name} differs in run {number}")
