"""T100 to T116: memory, limits, tongues, environments, clocks, and what came after the first list."""

import io
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import zipfile

from harness import PLANAR, SAMPLES, NotTried, geojson, row, small_study
from rows_of_files import with_faults

MB = 1_000_000


@row(100, "an allocation that fails")
def _(t):
    with_faults(t, "rain", ("malloc",), 12)
    with_faults(t, "run", ("malloc", "mmap"), 4)


@row(101, "200 MB of addresses, a stack of 64 kB, a second of time")
def _(t):
    study, readings = small_study(t)
    for size in (240, 300, 400):
        ran = t.run("run", *readings, *PLANAR, "-q", "-o", "out", "--overwrite", limits=[(resource.RLIMIT_AS, size * MB)])
        t.hold(ran.status in (0, 1, 127), f"{size} MB: exit {ran.status}")
    draw = random.Random(101)
    many = 10_000_000 if t.options.long else 500_000
    with open(t.folder / "many.csv", "w", encoding="ascii") as file:
        file.write("id,x,y\n")
        file.writelines(f"S{i},{draw.random()},{draw.random()}\n" for i in range(many))
    t.fails("weights", "many.csv", study[1], *PLANAR, limits=[(resource.RLIMIT_AS, 300 * MB)], says="memory")
    t.run("weights", *study, *PLANAR, limits=[(resource.RLIMIT_STACK, 65536)])
    t.sound([(float(i), float(i % 7)) for i in range(20_000)], limits=[(resource.RLIMIT_STACK, 262_144)])


@row(102, "other tongues and time zones")
def _(t):
    t.golden("T102")
    _, readings = small_study(t)
    seen = set()
    found = subprocess.run(["locale", "-a"], capture_output=True, text=True, check=False).stdout.split()
    for name in ["C", "nonsense", "de_DE.UTF-8", "tr_TR.UTF-8", "fr_FR.UTF-8", "ar_EG.UTF-8", *found[:5]]:
        for zone in ("UTC", "Asia/Kathmandu", ":nonsense"):
            seen.add(t.done("rain", *readings, *PLANAR, env={"LC_ALL": name, "TZ": zone}).out)
    t.hold(len(seen) == 1, "rain differs between tongues")
    if not {"de_DE.utf8", "tr_TR.utf8"} & set(found):
        raise NotTried("no tongue with a decimal comma is installed; without them it holds" if not t.faults else t.faults[0])


@row(103, "other compilers, machines and ways to round")
def _(t):
    raise NotTried("a program that is built cannot be compiled otherwise: the figures of tests/README.md tell of builds")


@row(106, "clocks that jump")
def _(t):
    if t.options.shim is None:
        raise NotTried("no --shim is given (build/tests/libthiessen_faults.so)")
    _, readings = small_study(t)
    seen = {t.done("rain", *readings, *PLANAR, env=env).out
            for env in ({}, {"LD_PRELOAD": t.options.shim, "FAULT_CLOCK": "1"})}
    t.hold(len(seen) == 1, "a clock that jumps changes the rain")


@row(107, "GDAL's own settings in the environment, data that is not there")
def _(t):
    study, _ = small_study(t)
    seen = set()
    t.write("basin.geojson", geojson([[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]))
    t.write("stations.csv", "id,lon,lat\nA,2,2\nB,8,3\nC,5,8\n")
    for env in ({}, {"GDAL_SKIP": "GeoJSON CSV"}, {"GDAL_DRIVER_PATH": "/nowhere"}, {"GDAL_DATA": "/nowhere"},
                {"OGR_SKIP": "GeoJSON"}, {"OGR_GEOJSON_MAX_OBJ_SIZE": "0"}):
        seen.add(t.done("weights", "stations.csv", "basin.geojson", env=env).out)
    t.hold(len(seen) == 1, "the environment changes weights")
    t.golden("T074")


@row(108, "an environment that is hostile")
def _(t):
    study, readings = small_study(t)
    before = t.done("rain", *readings, *PLANAR)
    for env in ({"OGR_CT_OP_SELECTION": "FIRST_MATCHING"}, {"CPL_DEBUG": "ON"}, {"GDAL_VRT_ENABLE_PYTHON": "YES"},
                {"LD_LIBRARY_PATH": str(t.folder)}, {"CPL_LOG": "log.txt"}, {"PROJ_NETWORK": "ON"}, {"PROJ_DEBUG": "3"},
                {"OPENCV_LOG_LEVEL": "DEBUG"}, {"OMP_NUM_THREADS": "-1"}):
        ran = t.done("rain", *readings, *PLANAR, env=env)
        t.hold((ran.out, ran.err) == (before.out, before.err), f"{env} changes what is printed")
    t.hold(not (t.folder / "log.txt").exists(), "a log is written")


@row(109, "gauges of an hour beside gauges of a day")
def _(t):
    study, _ = small_study(t)
    hours = "".join(f"2020-01-0{1 + h // 24}T{h % 24:02}:00,1,2,{24 if h % 24 == 0 else ''}\n" for h in range(72))
    t.write("rainfall.csv", "time,A,B,C\n" + hours)
    ran = t.fails("rain", *study, "rainfall.csv", *PLANAR)
    t.hold("C" in ran.err and "--totals" in ran.err, f"neither gauge nor --totals is named: {ran.err[-200:]}")


@row(110, "gauges in another CRS, hemisphere, order or unit than the basins")
def _(t):
    t.write("basin.geojson", geojson([[[10, 45], [11, 45], [11, 46], [10, 46], [10, 45]]]))
    for places in ("A,10.5,-45.5\nB,10.7,-45.2\n", "A,45.5,10.5\nB,45.2,10.7\n", "A,600000,5000000\nB,610000,5010000\n",
                   "A,-10.5,45.5\nB,-10.7,45.2\n"):
        t.write("stations.csv", "id,lon,lat\n" + places)
        t.fails("weights", "stations.csv", "basin.geojson")
    t.write("stations.csv", "id,lon,lat\nA,-10.5,45.5\nB,-10.7,45.2\n")
    t.done("weights", "stations.csv", "basin.geojson", "--allow-far")


@row(111, "months, days or hours that a table lacks")
def _(t):
    study, _ = small_study(t)
    days = [f"2020-01-{d:02}" for d in range(1, 32) if d not in (10, 11)]
    t.write("rainfall.csv", "time,A,B,C\n" + "".join(f"{day},1,2,3\n" for day in days))
    said = t.run("check", *study, "rainfall.csv", *PLANAR)
    t.hold("2020-01-10" in said.out + said.err or "2020-01-09" in said.out + said.err, "check names no gap")
    found = t.done("rain", *study, "rainfall.csv", *PLANAR, "--every", "month")
    t.hold("warning" in found.err or "," in found.out.splitlines()[-1], "a month with gaps is silent")


@row(112, "islands in lakes, enclaves, needles and slivers")
def _(t):
    t.golden("T112")


def as_somebody_without_processes():
    """A limit of processes holds for no root, and counts all that a user has: so the user is nobody's."""
    if os.geteuid() != 0:
        return None
    return 64000 + os.getpid() % 1000


@row(113, "no second thread, no temporary folder, no memory while drawing")
def _(t):
    study, readings = small_study(t)
    os.chmod(t.folder, 0o777)
    for words in (["rain", *readings], ["weights", *study, "--influence", readings[2]], ["run", *readings, "-o", "out"],
                                    ["map", *study, "-o", "m.png"]):
        whole = t.run(*words, *PLANAR, "-q", "--threads", 2)
        for name in ("out", "m.png"):
            shutil.rmtree(t.folder / name) if (t.folder / name).is_dir() else (t.folder / name).unlink(missing_ok=True)
        ran = t.run(*words, *PLANAR, "-q", "--threads", 2, limits=[(resource.RLIMIT_NPROC, 1)], user=as_somebody_without_processes())
        t.hold(ran.status == 0 and ran.out == whole.out, f"{words[0]} without a second thread: exit {ran.status} {ran.err[-150:]}")
    shutil.rmtree(t.folder / "out", ignore_errors=True)
    for size in range(205, 320, 3 if t.options.long else 9):
        ran = t.run("run", *readings, *PLANAR, "-q", "-o", "out", limits=[(resource.RLIMIT_AS, size * 1024 * 1000)])
        t.hold(ran.status in (0, 1, 127), f"{size} MB: exit {ran.status}: {ran.err[-100:]}")
        t.hold(ran.status != 1 or "memory" in ran.err or "map" in ran.err, f"{size} MB: {ran.err[-150:]}")
        t.hold(ran.status == 0 or not (t.folder / "out").exists(), f"{size} MB: a folder is left")
        shutil.rmtree(t.folder / "out", ignore_errors=True)
    t.fails("map", *study, *PLANAR, "-o", "big.png", "--size", "9000x9000", limits=[(resource.RLIMIT_AS, 500 * MB)],
            says="not enough memory to draw")


@row(114, "40,000 properties, sheets that unpack to a gigabyte, filters that explode")
def _(t):
    study, _ = small_study(t)
    box = {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}
    features = [{"type": "Feature", "properties": {"id": f"B{n}", **{f"p{i}": i for i in range(40_000)}}, "geometry": box}
                for n in range(2)]
    t.write("stations.csv", "id,lon,lat\nA,2,2\nB,8,3\n")
    t.write("basin.geojson", json.dumps({"type": "FeatureCollection", "features": features}))
    t.run("weights", "stations.csv", "basin.geojson", "--basin-id", "id", seconds=5, megabytes=1000)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as sheet:
        sheet.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet", zipfile.ZIP_STORED)
        with sheet.open("content.xml", "w", force_zip64=True) as content:
            content.write(b'<?xml version="1.0"?><office:document-content '
                          b'xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0">')
            for _ in range(1000):
                content.write(b" " * MB)
    t.write("bomb.ods", packed.getvalue())
    t.fails("rain", *study, "bomb.ods", *PLANAR, seconds=20, megabytes=900)
    t.write("name.geojson", json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"id": "a" * 30_000}, "geometry": box}]}))
    t.run("weights", "stations.csv", "name.geojson", "--basin-where", "id LIKE '" + "%a" * 40 + "b'", seconds=10)


def workbook(sheets):
    """An .xlsx of sheets: {name: rows of cells}, a cell a number, a text or XML as it is."""
    def cell(value):
        if isinstance(value, tuple):
            return value[0]
        if isinstance(value, (int, float)):
            return f"<c><v>{value}</v></c>"
        return f'<c t="inlineStr"><is><t>{value}</t></is></c>'
    packed = io.BytesIO()
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as book:
        numbers = range(1, len(sheets) + 1)
        kinds = "application/vnd.openxmlformats-officedocument.spreadsheetml"
        book.writestr("[Content_Types].xml", f'<Types xmlns="{package}/content-types"><Default Extension="rels" '
                      'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" '
                      f'ContentType="application/xml"/><Override PartName="/xl/workbook.xml" ContentType="{kinds}.sheet.main'
                      '+xml"/>' + "".join(f'<Override PartName="/xl/worksheets/sheet{n}.xml" ContentType="{kinds}.worksheet'
                                          '+xml"/>' for n in numbers) + "</Types>")
        book.writestr("_rels/.rels", f'<Relationships xmlns="{package}/relationships"><Relationship Id="r" '
                      f'Type="{office}/officeDocument" Target="xl/workbook.xml"/></Relationships>')
        book.writestr("xl/workbook.xml", f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets>' + "".join(
            f'<sheet name="{name}" sheetId="{n}" r:id="r{n}"/>' for n, name in zip(numbers, sheets)) + "</sheets></workbook>")
        book.writestr("xl/_rels/workbook.xml.rels", f'<Relationships xmlns="{package}/relationships">' + "".join(
            f'<Relationship Id="r{n}" Type="{office}/worksheet" Target="worksheets/sheet{n}.xml"/>' for n in numbers)
            + "</Relationships>")
        for n, rows in zip(numbers, sheets.values()):
            lines = "".join("<row>" + "".join(map(cell, line)) + "</row>" for line in rows)
            book.writestr(f"xl/worksheets/sheet{n}.xml", f'<worksheet xmlns="{main}"><sheetData>{lines}</sheetData></worksheet>')
    return packed.getvalue()


@row(115, "workbooks: several sheets, errors in cells, dates and serial numbers")
def _(t):
    study, readings = small_study(t)
    rows = [["time", "A", "B", "C"], ["2020-01-01", 1, 2, 3], ["2020-01-02", 4, "", 6], ["2020-01-03", 0, 0, 0]]
    t.write("rain.xlsx", workbook({"rain": rows}))
    plain = t.done("rain", *readings, *PLANAR)
    t.hold(t.done("rain", *study, "rain.xlsx", *PLANAR).out == plain.out, "a workbook reads otherwise than its CSV")
    rows[2][2] = ('<c t="e"><v>#N/A</v></c>',)
    t.write("bad.xlsx", workbook({"rain": rows}))
    t.hold(t.done("rain", *study, "bad.xlsx", *PLANAR).out == plain.out, "#N/A is not taken for an empty cell")
    torn = [*rows[:2], [*rows[2][:2], ('<c t="e"><v>#REF!</v></c>',), rows[2][3]], rows[3]]
    t.write("torn.xlsx", workbook({"rain": torn}))
    t.fails("rain", *study, "torn.xlsx", *PLANAR, says="#REF!")
    t.write("two.xlsx", workbook({"one": rows, "two": rows}))
    ran = t.run("rain", *study, "two.xlsx", *PLANAR)
    t.hold(ran.status in (0, 1) and ("one" in ran.err or ran.status == 0), f"two sheets: {ran.err[-150:]}")
    t.cases([p for p in (pathlib.Path(SAMPLES).parent / "tests/golden/readings").glob("*spreadsheet*.case")])


@row(116, "normals of 0, negative, missing at a gauge, over half a basin; elevation in feet")
def _(t):
    study, readings = small_study(t)
    for value in ("0", "-5", ""):
        t.write("stations.csv", f"id,x,y,normal\nA,2,2,{value}\nB,8,3,900\nC,5,8,800\n")
        ran = t.run("rain", *readings, *PLANAR, "--normal-field", "normal")
        t.hold(ran.status in (1, 2) or "warning" in ran.err, f"a normal of {value!r}: exit {ran.status}: {ran.err[-150:]}")
    t.golden_folder("normals")
