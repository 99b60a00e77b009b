#!/usr/bin/env python3
"""What the next model reads, read back by parsers written from the models' documentation, against rain.csv and weights.csv."""

import csv
import datetime
import json
import subprocess
import unittest
import xml.etree.ElementTree

import thiessen
from grids_test import lines_of, python_with

COLORADO = thiessen.SAMPLES / "colorado"
PLACES = (COLORADO / "stations.csv", COLORADO / "counties.geojson", "-q")
PI = "{http://www.wldelft.nl/fews/PI}"


def read_hype(text):
    """{id: {moment: value}} of a Pobs.txt: columns parted by tabs, the first of dates, the others called by whole numbers."""
    header, *rows = [line.split("\t") for line in text.splitlines()]
    values = {int(name): {} for name in header[1:]}
    for row in rows:
        form = "%Y-%m-%d %H:%M" if " " in row[0] else "%Y-%m-%d"
        moment = datetime.datetime.strptime(row[0], form)
        for name, value in zip(header[1:], row[1:], strict=True):
            values[int(name)][moment] = None if float(value) == -9999 else float(value)
    return values


def read_swmm(text):
    """{station: {moment: value}} of a rain file: station, year, month, day, hour, minute and value, by blanks."""
    values = {}
    for line in text.splitlines():
        station, *moment, value = line.split()
        values.setdefault(station, {})[datetime.datetime(*map(int, moment))] = float(value)
    return values


def read_swat(folder):
    """{file: (latitude, longitude, elevation, years, {date: value})} of the files that pcp.cli lists."""
    _, header, *names = (folder / "pcp.cli").read_text().splitlines()
    assert header == "filename"
    stations = {}
    for name in names:
        _, _, station, *rows = (folder / name).read_text().splitlines()
        years, step, latitude, longitude, elevation = station.split()
        assert step == "0"
        values = {}
        for row in rows:
            year, day, value = row.split()
            date = datetime.datetime(int(year), 1, 1) + datetime.timedelta(days=int(day) - 1)
            values[date] = None if float(value) <= -97 else float(value)
        stations[name] = (float(latitude), float(longitude), float(elevation), int(years), values)
    return names, stations


def read_pi(text):
    """(zone in hours, {location: (header, {moment: value})}) of a PI-XML of time series."""
    root = xml.etree.ElementTree.fromstring(text)
    series = {}
    for one in root.findall(PI + "series"):
        header = one.find(PI + "header")
        missing = float(header.find(PI + "missVal").text)
        values = {}
        for event in one.findall(PI + "event"):
            moment = datetime.datetime.fromisoformat(event.get("date") + "T" + event.get("time"))
            value = float(event.get("value"))
            values[moment] = None if value == missing else value
        series[header.find(PI + "locationId").text] = (header, values)
    return float(root.find(PI + "timeZone").text), series


def read_raven(text):
    """The rows of a :GaugeWeightTable; lines that begin with # are comments."""
    lines = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    assert lines[0] == [":GaugeWeightTable"] and lines[-1] == [":EndGaugeWeightTable"]
    gauges, units = map(int, lines[1])
    rows = [list(map(float, line)) for line in lines[2:-1]]
    assert len(rows) == units and all(len(row) == gauges for row in rows)
    return rows


def read_hms(text):
    """The blocks of a file of HEC-HMS, [(kind, name, [(key, value)])], each of which ends with End:."""
    blocks = []
    for line in text.splitlines():
        if not line.strip():
            continue
        key, _, value = line.strip().partition(":")
        if line.startswith(" "):
            blocks[-1][2].append((key, value[1:]))
        elif key != "End":
            blocks.append((key, value[1:], []))
    return blocks


class WeightsTest(thiessen.ProgramTest):
    def setUp(self):
        super().setUp()
        self.weights = thiessen.weights_of(self.output("weights", *PLACES, "--basin-id", "name"))

    def test_raven(self):
        rows = read_raven(self.output("weights", *PLACES, "--basin-id", "name", "--format", "raven", "-o", "t.rvt")
                          or (self.folder / "t.rvt").read_text())
        with open(COLORADO / "stations.csv", encoding="utf-8") as file:
            stations = [row["id"] for row in csv.DictReader(file)]
        self.assertEqual(len(rows), len(self.weights))
        for row, weights in zip(rows, self.weights.values()):
            self.assertEqual({s: w for s, w in zip(stations, row, strict=True) if w != 0}, weights)

    def test_hms(self):
        blocks = read_hms(self.output("weights", *PLACES, "--basin-id", "name", "--format", "hms"))
        self.assertEqual(blocks[0][0], "Meteorology")
        self.assertIn(("Precipitation Method", "Weighted Gages"), blocks[0][2])
        self.assertTrue(dict(blocks[0][2])["Description"].startswith("thiessen"))
        gages = {name for kind, name, _ in blocks if kind == "Gage"}
        found = {}
        for kind, name, items in blocks:
            if kind != "Subbasin":
                continue
            for (k, gage), (depth, weight), (time, same) in zip(items[::3], items[1::3], items[2::3], strict=True):
                self.assertEqual((k, depth, time), ("Gage", "Volume Weight", "Temporal Distribution Weight"))
                self.assertEqual(weight, same)
                self.assertIn(gage, gages)
                found.setdefault(name, {})[gage] = float(weight)
        self.assertEqual(found, self.weights)


class SeriesTest(thiessen.ProgramTest):
    """The Colorado sample, whose months are taken for steps of another length."""

    def series(self, first, length, count=120):
        with open(COLORADO / "rainfall.csv", encoding="utf-8") as file:
            rows = [next(file)] + [row for _, row in zip(range(count), file)]
        written = [rows[0]]
        for i, row in enumerate(rows[1:]):
            moment = first + i * length
            text = moment.date().isoformat() if length.days else moment.isoformat(timespec="minutes")
            written.append(text + row[row.index(","):])
        return self.write("r.csv", "".join(written))

    def table(self, *options):
        """rain.csv as {basin: {moment: value}}."""
        rows = thiessen.table(self.output("rain", *PLACES, "r.csv", *options))
        moments = [datetime.datetime.fromisoformat(row["time"]) for row in rows]
        return {basin: {m: float(row[basin]) if row[basin] else None for m, row in zip(moments, rows)}
                for basin in rows[0] if basin != "time"}

    def test_hype(self):
        self.series(datetime.datetime(1990, 2, 1), datetime.timedelta(days=1))
        for options in (("--basin-id", "id"), ("--basin-id", "id", "--gaps", "strict", "--decimals", "1")):
            expected = self.table(*options)
            found = read_hype(self.output("rain", *PLACES, "r.csv", *options, "--format", "hype"))
            self.assertEqual(found, {int(basin): values for basin, values in expected.items()})
        self.assertTrue(any(None in values.values() for values in found.values()))

    def test_hype_of_hours(self):
        self.series(datetime.datetime(1990, 2, 1), datetime.timedelta(hours=1))
        expected = self.table("--basin-id", "id")
        found = read_hype(self.output("rain", *PLACES, "r.csv", "--basin-id", "id", "--format", "hype"))
        self.assertEqual(found, {int(basin): values for basin, values in expected.items()})

    def test_swmm(self):
        self.series(datetime.datetime(1990, 2, 1, 23), datetime.timedelta(minutes=5))
        expected = self.table("--basin-id", "id")
        found = read_swmm(self.output("rain", *PLACES, "r.csv", "--basin-id", "id", "--format", "swmm"))
        self.assertEqual(set(found), set(expected))
        for basin, values in expected.items():
            # What has no line is dry.
            self.assertEqual({m: found[basin].get(m, 0) for m in values}, values)
            self.assertLessEqual(set(found[basin]), set(values))

    def test_swat(self):
        self.series(datetime.datetime(1990, 12, 1), datetime.timedelta(days=1))
        options = ("--basin-id", "id", "--gaps", "strict")
        expected = self.table(*options)
        self.output("rain", *PLACES, "r.csv", *options, "--format", "swat", "-o", "pcp")
        names, stations = read_swat(self.folder / "pcp")
        self.assertEqual(names, sorted(basin + ".pcp" for basin in expected))
        with open(COLORADO / "counties.geojson", encoding="utf-8") as file:
            shapes = {str(f["properties"]["id"]): f["geometry"] for f in json.load(file)["features"]}
        for basin, values in expected.items():
            latitude, longitude, elevation, years, found = stations[basin + ".pcp"]
            self.assertEqual((elevation, years), (0, 2))
            self.assertEqual(found, values)
            shape = shapes[basin]
            parts = shape["coordinates"] if shape["type"] == "MultiPolygon" else [shape["coordinates"]]
            x, y = centroid(parts)
            self.assertAlmostEqual(longitude, x, delta=2e-3)
            self.assertAlmostEqual(latitude, y, delta=2e-3)

    def test_pi_xml(self):
        self.series(datetime.datetime(1990, 2, 1, 6), datetime.timedelta(hours=6))
        options = ("--basin-id", "name", "--gaps", "strict")
        expected = self.table(*options)
        for stamp, later in (("begin", datetime.timedelta(hours=6)), ("end", datetime.timedelta(0))):
            self.output("rain", *PLACES, "r.csv", *options, "--format", "pi-xml", "--stamp", stamp, "-o", "p.xml",
                        "--overwrite", "--units", "mm")
            zone, series = read_pi((self.folder / "p.xml").read_text(encoding="utf-8"))
            self.assertEqual(zone, 0)
            self.assertEqual(list(series), list(expected))
            for basin, values in expected.items():
                header, found = series[basin]
                self.assertEqual(found, {moment + later: value for moment, value in values.items()})
                self.assertEqual(header.find(PI + "parameterId").text, "P")
                step = header.find(PI + "timeStep")
                self.assertEqual((step.get("unit"), step.get("multiplier")), ("second", "21600"))
                self.assertEqual([child.tag.replace(PI, "") for child in header],
                                 ["type", "locationId", "parameterId", "timeStep", "startDate", "endDate", "missVal",
                                  "units"])

    def test_netcdf(self):
        python = python_with("xarray")
        if python is None:
            self.skipTest("python3-xarray is not installed")
        options = ("--basin-id", "name", "--error", "--from", "1990-01", "--to", "1990-06")
        rain = COLORADO / "rainfall.csv"
        rows = thiessen.table(self.output("rain", *PLACES, rain, *options, "--decimals", "6"))
        self.output("rain", *PLACES, rain, *options, "--format", "netcdf", "-o", "r.nc")
        script = """import sys, xarray
series = xarray.open_dataset(sys.argv[1])
print(series.rainfall.dims, series.rainfall.dtype, series.rainfall.attrs["units"], series.attrs["featureType"])
print(*series.basin_id.values, sep="|")
print(*series.time.values.astype("datetime64[D]"))
print(*series.time_bnds.values.astype("datetime64[D]").ravel())
for name in ("rainfall", "standard_error"):
    for values in series[name].values:
        print(*("%.6f" % value for value in values))
"""
        lines = lines_of(python, "-c", script, self.folder / "r.nc")
        basins = [name for name in rows[0] if name != "time" and not name.endswith("_se")]
        self.assertEqual(lines[0], "('basin', 'time') float64 mm timeSeries")
        self.assertEqual(lines[1].split("|"), basins)
        months = [f"1990-0{month}-01" for month in range(1, 8)]
        self.assertEqual(lines[2].split(), months[:-1])
        self.assertEqual(lines[3].split(), [m for pair in zip(months, months[1:]) for m in pair])
        columns = basins + [basin + "_se" for basin in basins]
        for column, line in zip(columns, lines[4:], strict=True):
            found = [None if value == "nan" else float(value) for value in line.split()]
            self.assertEqual(found, [float(row[column]) if row[column] else None for row in rows], column)

    def test_a_series_in_netcdf_is_read_again(self):
        """As stations: areal rainfall at the basins' centroids, as another study would take it."""
        self.series(datetime.datetime(1990, 2, 1), datetime.timedelta(days=1), 5)
        self.output("rain", *PLACES, "r.csv", "--basin-id", "name", "--format", "netcdf", "-o", "r.nc")
        ran = self.run_program("rain", "r.nc", COLORADO / "counties.geojson", "r.nc", "--basin-id", "name", "-q")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(len(thiessen.table(ran.stdout)), 5)

    def test_memory_does_not_grow_with_steps_times_basins(self):
        self.series(datetime.datetime(1990, 2, 1), datetime.timedelta(minutes=1), 4)
        with open(self.folder / "r.csv", encoding="utf-8") as file:
            header, *rows = file.readlines()
        with open(self.folder / "long.csv", "w", encoding="utf-8") as file:
            file.write(header)
            for i in range(20000):
                moment = datetime.datetime(1990, 1, 1) + datetime.timedelta(minutes=i)
                row = rows[0]  # of one kind of gauges
                file.write(moment.isoformat(timespec="minutes") + row[row.index(","):])
        script = """import resource, subprocess, sys
ran = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
print(ran.returncode, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""
        used = {}
        for name, target in (("csv", "-"), ("pi-xml", "-"), ("hype", "-"), ("netcdf", "m.nc")):
            out = subprocess.run(["python3", "-c", script, thiessen.PROGRAM, "rain", *map(str, PLACES), "long.csv",
                                  "--basin-id", "id", "--format", name, "-o", target],
                                 cwd=self.folder, check=True, capture_output=True, text=True).stdout.split()
            self.assertEqual(out[0], "0", name)
            used[name] = int(out[1]) * 1024
        # 64 basins of 20,000 steps are 10 MB of doubles, and 40 MB of text.
        for name, most in used.items():
            self.assertLess(most, used["csv"] + (30 << 20), f"{name}: {used}")


def centroid(parts):
    """The centroid of rings in degrees, as of a plane: near enough for a county."""
    area = x = y = 0
    ox, oy = parts[0][0][0]
    for part in parts:
        for ring in part:
            for (ax, ay), (bx, by) in zip(ring, ring[1:]):
                turned = (ax - ox) * (by - oy) - (bx - ox) * (ay - oy)
                area, x, y = area + turned, x + turned * (ax + bx + ox) / 3, y + turned * (ay + by + oy) / 3
    return x / area, y / area


if __name__ == "__main__":
    unittest.main()
