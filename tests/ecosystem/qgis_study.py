"""Opens a study.gpkg in QGIS, without a window, and draws it: qgis_study.py CLONE FOLDER"""

import os
import pathlib
import subprocess
import sys

from qgis.core import (QgsApplication, QgsFeatureRequest, QgsMapRendererParallelJob, QgsMapSettings, QgsProject, QgsVectorLayer)
from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QColor

clone, work = map(pathlib.Path, sys.argv[1:])
colorado = clone / "samples/colorado"
application = QgsApplication([], False, str(work / "profile"))
application.initQgis()

subprocess.run([os.environ["THIESSEN"], "run", colorado / "stations.csv", colorado / "counties.geojson",
                colorado / "rainfall.csv", "--basin-id", "name", "--interval", "5", "-o", work / "study", "-q"],
               check=True)
study = work / "study/study.gpkg"

# As a user opens them: nothing is said of a style.
layers = {}
with open(colorado / "stations.csv", encoding="utf-8") as table:
    stations = len(table.readlines()) - 1
with open(work / "study/weights.csv", encoding="utf-8") as table:
    weights = len(table.readlines()) - 1
for name, count in (("cells", weights), ("gauges", stations), ("basins", 64), ("isohyets", None), ("weights", weights),
                    ("rain", 64 * 120)):
    layer = QgsVectorLayer(f"{study}|layername={name}", name, "ogr")
    assert layer.isValid(), name
    assert count is None or layer.featureCount() == count, (name, layer.featureCount())
    layers[name] = layer
assert layers["gauges"].labelsEnabled() and layers["gauges"].labeling().settings().fieldName == "station"
assert layers["basins"].labelsEnabled() and layers["basins"].labeling().settings().fieldName == "basin"
assert layers["isohyets"].labelsEnabled() and layers["isohyets"].featureCount() > 100

# Each class of the cells has a rule, and every cell is of one of them.
cells = layers["cells"]
assert cells.renderer().type() == "RuleRenderer", cells.renderer().type()
rules = cells.renderer().rootRule().children()
assert len(rules) >= 5, [rule.label() for rule in rules]
held = {}
for rule in rules:
    held[rule.symbol().color().name()] = sum(
        1 for _ in cells.getFeatures(QgsFeatureRequest().setFilterExpression(rule.filterExpression())))
assert sum(held.values()) == cells.featureCount(), held


def drawn(names, file):
    """The map of these layers, the first on top, as an image."""
    settings = QgsMapSettings()
    settings.setLayers([layers[name] for name in names])
    settings.setDestinationCrs(cells.crs())
    settings.setExtent(cells.extent().buffered(0.1))
    settings.setOutputSize(QSize(1200, 900))
    settings.setBackgroundColor(QColor("white"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    image.save(str(work / file))
    return image


image = drawn(["cells"], "cells.png")
seen = {}
for y in range(0, image.height(), 2):
    for x in range(0, image.width(), 2):
        colour = image.pixelColor(x, y).name()
        seen[colour] = seen.get(colour, 0) + 1
missing = [colour for colour, count in held.items() if count > 0 and seen.get(colour, 0) < 20]
assert not missing, (missing, held)
drawn(["isohyets", "gauges", "basins", "cells"], "study.png")
QgsProject.instance().clear()
os._exit(0)  # QGIS's own end may fail without a window
