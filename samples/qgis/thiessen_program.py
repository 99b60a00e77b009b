"""What the Processing scripts beside this file share: how they run the program `thiessen`.

The program is the one that the variable THIESSEN names, in QGIS's settings (System, Environment) or in the shell, or
else the `thiessen` on the PATH.
"""

import os
import pty
import re
import select
import shutil
import signal
import subprocess
import tempfile

from osgeo import gdal
from qgis.core import (QgsCoordinateReferenceSystem, QgsFeature, QgsFeatureSink, QgsProcessing, QgsProcessingException,
                       QgsProcessingParameterEnum, QgsProcessingParameterField, QgsProcessingParameterFile,
                       QgsProcessingParameterFeatureSource, QgsProcessingParameterString, QgsProcessingUtils,
                       QgsVectorLayer)

PROGRESS = re.compile(r"(\d+) %")
ESCAPES = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def program():
    named = os.environ.get("THIESSEN")
    found = shutil.which(named or "thiessen")
    if named and not found:
        raise QgsProcessingException(f"the environment variable THIESSEN names {named}, and that is no program")
    if not found:
        raise QgsProcessingException("the program thiessen is not found: install it, or name it in the environment "
                                     "variable THIESSEN (Settings, Options, System, Environment)")
    return found


def _tell(line, feedback, errors):
    """Hands a line of the program's on: a warning as a warning, an error to those that end the algorithm."""
    line = ESCAPES.sub("", line).strip()
    if not line:
        return
    if line.startswith("thiessen: error: "):
        errors.append(line.removeprefix("thiessen: error: "))
    elif line.startswith("hint: ") and errors:
        errors[-1] += " (" + line + ")"
    elif line.startswith("thiessen: warning: "):
        feedback.pushWarning(line.removeprefix("thiessen: warning: "))
    elif (share := PROGRESS.search(line)) and line.startswith("thiessen: "):
        feedback.setProgress(int(share[1]))
    else:
        feedback.pushInfo(line.removeprefix("thiessen: "))


def run(arguments, feedback):
    """Runs the program; its messages and its progress are shown, Cancel ends it as Ctrl-C does, but by
    a signal that is heard in a QGIS from a script, too, whose programs may not hear Ctrl-C."""
    command = [program(), *arguments]
    feedback.pushCommandInfo(" ".join(command))
    # The program shows its progress on a terminal alone, so its messages go through one.
    ours, its = pty.openpty()
    errors = []
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=its) as process:
        os.close(its)
        rest = ""
        while True:
            if feedback.isCanceled():
                process.terminate()
            # A program that is silent, as one that waits for its input, hears of Cancel too.
            if not select.select([ours], [], [], 0.2)[0]:
                continue
            try:
                part = os.read(ours, 4096).decode("utf-8", "replace")
            except OSError:  # the program has ended
                part = ""
            if not part:
                break
            *lines, rest = re.split(r"[\r\n]+", rest + part)
            for line in lines:
                _tell(line, feedback, errors)
        _tell(rest, feedback, errors)
    os.close(ours)
    if process.returncode == 128 + signal.SIGTERM:
        raise QgsProcessingException("interrupted")
    if process.returncode != 0:
        raise QgsProcessingException("\n".join(errors) or f"thiessen ended with {process.returncode}")
    feedback.setProgress(100)


class ThiessenScript:
    """The parameters that the algorithms share, and their texts on the command line."""

    STATIONS, STATION_ID, BASINS, BASIN_ID, RAINFALL = "STATIONS", "STATION_ID", "BASINS", "BASIN_ID", "RAINFALL"
    GAPS, METRIC, OPTIONS = "GAPS", "METRIC", "OPTIONS"
    POLICIES = ("retessellate", "renormalise", "strict")
    METRICS = ("", "geodesic", "planar")

    def group(self):
        return "Areal rainfall"

    def groupId(self):
        return "arealrainfall"

    def add_places(self, basins_optional):
        self.addParameter(QgsProcessingParameterFeatureSource(self.STATIONS, "Rain gauges",
                                                              [QgsProcessing.TypeVectorPoint]))
        self.addParameter(QgsProcessingParameterField(self.STATION_ID, "Field of the gauges' ids", None, self.STATIONS,
                                                      optional=True))
        self.addParameter(QgsProcessingParameterFeatureSource(self.BASINS, "Basins", [QgsProcessing.TypeVectorPolygon],
                                                              optional=basins_optional))
        self.addParameter(QgsProcessingParameterField(self.BASIN_ID, "Field of the basins' ids", None, self.BASINS,
                                                      optional=True))

    def add_readings(self, optional):
        self.addParameter(QgsProcessingParameterFile(self.RAINFALL, "Readings (CSV, wide or long)", optional=optional))

    def add_method(self):
        self.addParameter(QgsProcessingParameterEnum(
            self.METRIC, "What near means", ["geodesic where the CRS is known", "geodesic", "planar"], defaultValue=0))
        self.addParameter(QgsProcessingParameterString(self.OPTIONS, "Further options, as on the command line",
                                                       optional=True))

    def places(self, parameters, context, feedback):
        """STATIONS and BASINS as files that the program reads, and the options that name their fields and layers."""
        words, options = [], []
        for name, field, layer_option, id_option in (
                (self.STATIONS, self.STATION_ID, "--stations-layer", "--id"),
                (self.BASINS, self.BASIN_ID, "--basins-layer", "--basin-id")):
            if parameters.get(name) is None:
                continue
            path, layer = self.parameterAsCompatibleSourceLayerPathAndLayerName(
                parameters, name, context, ["gpkg", "geojson", "shp", "fgb"], "gpkg", feedback)
            wanted, named = self.parameterAsSource(parameters, name, context).sourceCrs(), crs_of_file(path, layer)
            if named != wanted:
                # The layer's CRS counts, as its properties have it: a copy of the layer is written in that.
                path, layer = self.parameterAsCompatibleSourceLayerPathAndLayerName(
                    parameters, name, context, [], "gpkg", feedback)
                feedback.pushInfo(f"{name}: the layer's CRS is taken, {words_of(wanted)}; its file names {words_of(named)}")
            words.append(path)
            if layer:
                options += [layer_option, layer]
            of_ids = self.parameterAsString(parameters, field, context)
            if of_ids:
                options += [id_option, of_ids]
        return words, options

    def method(self, parameters, context):
        metric = self.METRICS[self.parameterAsEnum(parameters, self.METRIC, context)]
        words = ["--metric", metric] if metric else []
        further = self.parameterAsString(parameters, self.OPTIONS, context)
        return words + split_words(further or "")


def split_words(text):
    import shlex

    try:
        return shlex.split(text)
    except ValueError as error:
        raise QgsProcessingException(f"the further options {text} cannot be parted into words: {error}") from error


def words_of(crs):
    return (crs.authid() or crs.toWkt()) if crs.isValid() else "none"


def crs_of_file(path, layer):
    """The CRS that a file names for a layer of it; invalid where it names none."""
    file = gdal.OpenEx(path, gdal.OF_VECTOR)
    opened = file and (file.GetLayerByName(layer) if layer else file.GetLayer(0))
    named = opened and opened.GetSpatialRef()
    if not named:
        return QgsCoordinateReferenceSystem()
    return QgsCoordinateReferenceSystem.fromWkt(named.ExportToWkt(["FORMAT=WKT2_2019"]))


def to_destination(destination, arguments, context, feedback):
    """Runs the program for a vector layer, which goes to a file, or to what else Processing can write to: a layer of a
    GeoPackage, a table of a database, the memory. Returns the layer's source.
    """
    if os.path.splitext(destination)[1] and ":" not in destination.split(os.sep, 1)[0]:
        in_place(destination, arguments, feedback)
        return destination
    folder = tempfile.mkdtemp(prefix="thiessen-")
    try:
        made = os.path.join(folder, "made.gpkg")
        run([*arguments, "-o", made], feedback)
        layer = QgsVectorLayer(made, "made", "ogr")
        fields = layer.fields()
        fields.remove(fields.indexOf("fid"))  # which the destination numbers anew
        sink, source = QgsProcessingUtils.createFeatureSink(destination, context, fields, layer.wkbType(), layer.crs())
        if sink is None:
            raise QgsProcessingException(f"nothing can be written to {destination}")
        for feature in layer.getFeatures():
            copy = QgsFeature(fields)
            copy.setGeometry(feature.geometry())
            copy.setAttributes([feature[field.name()] for field in fields])
            if not sink.addFeature(copy, QgsFeatureSink.FastInsert):
                raise QgsProcessingException(f"a cell cannot be written to {destination}: {sink.lastError()}")
        del sink  # which writes what it has not yet written
        return source
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def in_place(parameters_path, arguments, feedback):
    """Runs the program with its output beside `parameters_path`, and puts it there when it is whole: Processing has
    asked before whether a file may be replaced.
    """
    beside = os.path.dirname(os.path.abspath(parameters_path))
    try:
        folder = tempfile.mkdtemp(prefix="thiessen-", dir=beside)
    except OSError as error:
        raise QgsProcessingException(f"nothing can be written into {beside}: {error.strerror}") from error
    try:
        made = os.path.join(folder, os.path.basename(parameters_path))
        run([*arguments, "-o", made], feedback)
        for name in os.listdir(folder):
            os.replace(os.path.join(folder, name), os.path.join(beside, name))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
