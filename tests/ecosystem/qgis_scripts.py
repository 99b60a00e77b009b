"""Runs the scripts of samples/qgis in QGIS, without a window: qgis_scripts.py CLONE FOLDER"""

import csv
import importlib.util
import os
import pathlib
import subprocess
import sys
import threading
import time

from qgis.core import (QgsApplication, QgsCoordinateReferenceSystem, QgsProcessingContext, QgsProcessingException,
                       QgsProcessingFeedback, QgsProcessingUtils, QgsProject, QgsVectorLayer)

clone, work = map(pathlib.Path, sys.argv[1:])
scripts, colorado = clone / "samples/qgis", clone / "samples/colorado"
application = QgsApplication([], False, str(work / "profile"))
application.initQgis()
sys.path.append("/usr/share/qgis/python/plugins")
from processing.core.Processing import Processing  # noqa: E402
from processing.script import ScriptUtils  # noqa: E402

Processing.initialize()


class Heard(QgsProcessingFeedback):
    """Feedback that keeps what it is told."""

    def __init__(self):
        super().__init__(False)
        self.warnings, self.informed = [], []

    def pushWarning(self, text):
        self.warnings.append(text)

    def pushInfo(self, text):
        self.informed.append(text)


def algorithm(name):
    # As the toolbox finds it: the first algorithm in the file of a script.
    found = ScriptUtils.loadAlgorithm(name, str(scripts / f"{name}.py"))
    assert found is not None, name
    return found.create()


def run(name, parameters):
    feedback, context = Heard(), QgsProcessingContext()
    context.setProject(QgsProject.instance())
    ran = algorithm(name)
    ok, why = ran.checkParameterValues(parameters, context)
    assert ok, why
    result, good = ran.run(parameters, context, feedback, catchExceptions=False)
    assert good, result
    return result, feedback


def by_program(*arguments):
    return subprocess.run([os.environ["THIESSEN"], *map(str, arguments)], check=True, capture_output=True, text=True).stdout


stations = QgsVectorLayer(f"file://{colorado}/stations.csv?xField=lon&yField=lat&crs=EPSG:4326&detectTypes=no", "gauges",
                          "delimitedtext")
counties = QgsVectorLayer(str(colorado / "counties.geojson"), "counties", "ogr")
assert stations.isValid() and counties.isValid()
places = {"STATIONS": stations, "STATION_ID": "id", "BASINS": counties, "BASIN_ID": "id"}
files = (colorado / "stations.csv", colorado / "counties.geojson")

result, _ = run("thiessen_cells", {**places, "OUTPUT": str(work / "out/cells.gpkg")})
cells = QgsVectorLayer(result["OUTPUT"], "cells", "ogr")
weights = list(csv.DictReader(by_program("weights", *files).splitlines()))
assert cells.featureCount() == len(weights), (cells.featureCount(), len(weights))
of_cells = {(cell["basin"], cell["station"]): cell["weight"] for cell in cells.getFeatures()}
assert all(abs(of_cells[row["basin"], row["station"]] - float(row["weight"])) < 1e-15 for row in weights)

result, _ = run("thiessen_weights", {**places, "OUTPUT": str(work / "out/weights.csv")})
assert pathlib.Path(result["OUTPUT"]).read_text() == by_program("weights", *files)

readings = colorado / "rainfall.csv"
result, feedback = run("thiessen_rain", {**places, "RAINFALL": str(readings), "GAPS": 2,
                                         "OUTPUT": str(work / "out/rain.csv")})
assert pathlib.Path(result["OUTPUT"]).read_text() == by_program("rain", *files, readings, "--gaps", "strict")
assert any("78 stations have no readings" in text for text in feedback.warnings), feedback.warnings

# An error of the program ends the algorithm with its words and its hint, and leaves nothing.
(work / "bad.csv").write_text("time,nobody\n2020-01-01,1\n")
try:
    run("thiessen_rain", {**places, "RAINFALL": str(work / "bad.csv"), "OUTPUT": str(work / "out/bad.csv")})
    raise AssertionError("an error was wanted")
except QgsProcessingException as error:
    assert "nobody" in str(error), error
assert sorted(path.name for path in (work / "out").iterdir()) == ["cells.gpkg", "rain.csv", "weights.csv"]


def refusal(parameters):
    try:
        run("thiessen_cells", {**places, **parameters})
    except QgsProcessingException as error:
        return str(error)
    raise AssertionError("an error was wanted")


assert "nothing can be written into" in refusal({"OUTPUT": str(work / "none/cells.gpkg")})
assert "cannot be parted into words" in refusal({"OUTPUT": str(work / "out/x.gpkg"), "OPTIONS": "--metric 'planar"})
program, os.environ["THIESSEN"] = os.environ["THIESSEN"], str(work / "none/thiessen")
assert "that is no program" in refusal({"OUTPUT": str(work / "out/x.gpkg")})
os.environ["THIESSEN"] = program
assert not (work / "out/x.gpkg").exists()

# Cells go to a layer of a GeoPackage that has others, and to the memory.
subprocess.run(["ogr2ogr", work / "dest.gpkg", files[1], "-nln", "counties"], check=True)
for destination in (f"ogr:dbname='{work}/dest.gpkg' table=\"cells\" (geom)", "memory:cells"):
    ran, context = algorithm("thiessen_cells"), QgsProcessingContext()
    context.setProject(QgsProject.instance())
    result, good = ran.run({**places, "OUTPUT": destination}, context, Heard(), catchExceptions=False)
    layer = QgsProcessingUtils.mapLayerFromString(result["OUTPUT"], context)
    assert layer.crs().authid() == "EPSG:4326", layer.crs()
    found = {(cell["basin"], cell["station"]): cell["weight"] for cell in layer.getFeatures()}
    assert found == of_cells
assert QgsVectorLayer(f"{work}/dest.gpkg|layername=counties", "counties", "ogr").featureCount() == 64

# A layer is in the CRS that QGIS has for it, whether its file names none or another.
for name, file in (("stations", files[0]), ("basins", files[1])):
    given = ["-oo", "X_POSSIBLE_NAMES=lon", "-oo", "Y_POSSIBLE_NAMES=lat"] if name == "stations" else []
    subprocess.run(["ogr2ogr", work / f"{name}.shp", file, *given, "-s_srs", "EPSG:4326", "-t_srs", "EPSG:32613"], check=True)
(work / "stations.prj").unlink()
wanted = by_program("weights", work / "stations.shp", work / "basins.shp", "--crs", "EPSG:26713", "--id", "id", "--basin-id", "id")
in_nad27 = QgsVectorLayer(str(work / "stations.shp"), "gauges", "ogr")
in_nad27.setCrs(QgsCoordinateReferenceSystem("EPSG:26713"))
in_utm = QgsVectorLayer(str(work / "basins.shp"), "basins", "ogr")
result, feedback = run("thiessen_weights", {"STATIONS": in_nad27, "STATION_ID": "id", "BASINS": in_utm, "BASIN_ID": "id",
                                            "OUTPUT": str(work / "out/crs.csv")})
assert pathlib.Path(result["OUTPUT"]).read_text() == wanted
assert "STATIONS: the layer's CRS is taken, EPSG:26713; its file names none" in feedback.informed, feedback.informed
assert not any(text.startswith("BASINS: ") for text in feedback.informed), feedback.informed
(work / "basins.prj").unlink()
wanted = by_program("weights", work / "stations.shp", work / "basins.shp", "--crs", "EPSG:26713", "--basins-crs", "EPSG:26713",
                    "--id", "id", "--basin-id", "id")
subprocess.run(["ogr2ogr", work / "basins.gpkg", work / "basins.shp", "-a_srs", "EPSG:32613"], check=True)
moved = QgsVectorLayer(str(work / "basins.gpkg"), "basins", "ogr")
moved.setCrs(QgsCoordinateReferenceSystem("EPSG:26713"))
result, feedback = run("thiessen_weights", {"STATIONS": in_nad27, "STATION_ID": "id", "BASINS": moved, "BASIN_ID": "id",
                                            "OUTPUT": str(work / "out/crs.csv")})
assert pathlib.Path(result["OUTPUT"]).read_text() == wanted
assert "BASINS: the layer's CRS is taken, EPSG:26713; its file names EPSG:32613" in feedback.informed, feedback.informed

# Cancel ends the program in the midst of a series that has no end of its own.
feedback, context = Heard(), QgsProcessingContext()
feed = work / "feed"
os.mkfifo(feed)
station = weights[0]["station"]


def feed_and_cancel():
    with open(feed, "w", encoding="utf-8") as rows:
        rows.write(f"time,{station}\n2000-01-01,1\n2000-01-02,2\n")
        rows.flush()
        time.sleep(1)
        feedback.cancel()
        ended.wait()


ended = threading.Event()
threading.Thread(target=feed_and_cancel, daemon=True).start()
ran = algorithm("thiessen_rain")
try:
    ran.run({**places, "RAINFALL": str(feed), "OUTPUT": str(work / "out/many.csv")}, context, feedback,
            catchExceptions=False)
    raise AssertionError("an end was wanted")
except QgsProcessingException as error:
    assert "interrupted" in str(error), error
finally:
    ended.set()
assert not (work / "out/many.csv").exists()
os._exit(0)  # QGIS's own end may fail without a window
