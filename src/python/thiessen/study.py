"""A study: gauges, basins, and the rainfall of the one over the other."""

import json
import os
import warnings as warning_list

import numpy

from . import _thiessen
from .keywords import OF_SERIES, texts_of
from .places import basins_of, stations_of
from .readings import readings_of
from .tables import table


class ThiessenWarning(UserWarning):
    """Something odd in the input, or something that was assumed: in the words of the program."""


def _is_path(value):
    return isinstance(value, (str, os.PathLike))


def _are_files(value):
    return _is_path(value) or (isinstance(value, (list, tuple)) and len(value) > 0 and all(map(_is_path, value)))


def _rainfall_keywords(files):
    """The keywords by which readings in files are named: one file, or several that are joined."""
    if _is_path(files):
        return [("RAINFALL", [os.fspath(files)])]
    return [("rainfall", [os.fspath(file) for file in files])]


class Study:
    """Rain gauges, basins, and what near means between them.

    stations: the name of a file, as the program reads it; a dictionary of ids and (x, y); an array of two columns,
        with `ids` (else they are numbered from 1); a frame with columns of usual names (station, longitude, latitude);
        a GeoDataFrame, a GeoJSON FeatureCollection or anything else with `__geo_interface__`.
    basins: the name of a file; a dictionary of ids and shapes; a list of shapes, with `basin_ids` (else they are
        numbered from 1); a GeoDataFrame, a FeatureCollection. A shape is a GeoJSON geometry or Feature, anything with
        `__geo_interface__`, WKB, or WKT. Without basins the study area is the extent of the stations, grown by
        `margin` percent.
    rainfall: readings, which decide which stations are of the network: those with at least one. Files, or what
        `rain` takes. Without them all stations are.
    ids, basin_ids: of stations and basins that have none.
    progress: called with the steps done and those there are (0 where that is not known), some twenty times a second.
    keywords: the long options of the program, such as crs, basins_crs, metric, plane, tolerance, margin, mend,
        allow_far, threads, id, x, y, basin_id, stations_where; of readings in files also station_field, value_field,
        time_field, missing, ignore_unknown and so on.

    Coordinates in memory need a CRS ("EPSG:4326" for longitude and latitude) or metric="planar"; GeoJSON is in
    longitude and latitude where nothing else is said.

    Raises Error, in the words of the program, for input that cannot be used, and TypeError for an unknown keyword.
    What is odd is told as a ThiessenWarning, and stands in `warnings`. A study may be used by several threads, one at
    a time; the interpreter is free while it computes, and Ctrl-C ends it.
    """

    def __init__(self, stations, basins=None, rainfall=None, *, ids=None, basin_ids=None, progress=None, **keywords):
        self._of_series = {name: keywords.pop(name) for name in OF_SERIES if name in keywords}
        given = []
        held_stations = held_basins = None
        crs = keywords.get("crs")
        basins_crs = keywords.get("basins_crs")
        if _is_path(stations):
            given.append(("STATIONS", [os.fspath(stations)]))
            if ids is not None:
                raise TypeError("ids are of stations in memory; id names the field of a file")
        else:
            held_stations = stations_of(stations, ids, crs, keywords.pop("id", None), keywords.pop("x", None),
                                        keywords.pop("y", None))
            given.append(("STATIONS", ["stations"]))
        if _is_path(basins):
            given.append(("BASINS", [os.fspath(basins)]))
            if basin_ids is not None:
                raise TypeError("basin_ids are of basins in memory; basin_id names the field of a file")
        elif basins is not None:
            held_basins = basins_of(basins, basin_ids, basins_crs, keywords.pop("basin_id", None))
            given.append(("BASINS", ["basins"]))
        matrix = None
        self._times = None
        if _are_files(rainfall):
            given += _rainfall_keywords(rainfall)
        elif rainfall is not None:
            def ids_of_stations():
                if held_stations is not None:
                    return held_stations.ids
                return _thiessen.station_ids([given[0], *texts_of(keywords, only_stations=True)])

            held = readings_of(rainfall, ids_of_stations, keywords.pop("ignore_unknown", False))
            matrix, self._times = held.matrix, held.times
        if held_stations is not None:
            held_stations.require_crs(keywords, held_basins)
        self._matrix = matrix
        self._study = _thiessen.Study(held_stations and held_stations.made(), held_basins and held_basins.made(),
                                      matrix, given + texts_of(keywords), progress)
        self._stations = numpy.array(self._study.stations, dtype=object)
        self._basins = numpy.array(self._study.basins, dtype=object)
        self._tell(self._study.warnings)

    @staticmethod
    def _tell(texts):
        for text in texts:
            warning_list.warn(text, ThiessenWarning, stacklevel=3)

    @property
    def stations(self):
        """The ids of the network's stations, in the order in which they were given."""
        return list(self._stations)

    @property
    def positions(self):
        """Their coordinates, an array of two columns: longitude and latitude, or those of the plane."""
        return self._study.positions

    @property
    def never_reporting(self):
        """The ids of the stations without any reading: they are not of the network."""
        return self._study.never_reporting

    @property
    def basins(self):
        """The ids of the basins."""
        return list(self._basins)

    @property
    def metric(self):
        """What near means: "geodesic" or "planar"."""
        return self._study.metric

    @property
    def warnings(self):
        """What is odd about the input, in the words of the program."""
        return self._study.warnings

    @property
    def notices(self):
        """What was taken for granted."""
        return self._study.notices

    def weights(self):
        """The share of each basin that lies in each station's cell: basin, station, area_km2 (or area, where the unit
        of the plane is not known), weight. The weights of a basin add up to 1. A DataFrame, or where pandas is not
        installed a structured array.
        """
        basin, station, area, weight = self._study.weights()
        return table({"basin": self._basins[basin], "station": self._stations[station],
                      self._study.area_column: area, "weight": weight})

    def cells(self):
        """The cells, clipped to the basins, as a GeoJSON FeatureCollection: what the program's cells.geojson holds."""
        text, told = self._study.cells()
        self._tell(told)
        return json.loads(text)

    def rain(self, readings=None, *, progress=None, **keywords):
        """The areal rainfall of each basin at each step: time, and a column for each basin, in the order of the
        basins; NaN where there is none. With error=True also columns BASIN_se of standard errors, behind all others.
        A DataFrame, or where pandas is not installed a structured array.

        readings: nothing, for those of the study; files; an array of steps by stations, in the order in which the
            stations were given, NaN where a gauge is silent; a frame with a column for each station, whose index is
            the time. What has labels (a frame, a row of one, a dictionary, a structured array, an array of xarray with
            coordinates) goes by them. An array of doubles in C's order is read where it lies.
        keywords: gaps, min_gauges, method (several with commas between them), error, and of readings in files from_,
            to, time_field and the other options of readings.

        Memory: the readings in an array, and the result. Readings in files are read as they are needed.
        """
        matrix, times, given = self._readings(readings, keywords)
        names, file_times, values, errors, told = self._study.rain(matrix, given, progress)
        self._tell(told)
        columns = {"time": self._time_column(times, file_times, len(values))}
        for i, name in enumerate(names):
            columns[name] = values[:, i]
        if errors is not None:
            for i, name in enumerate(names):
                columns[name + "_se"] = errors[:, i]
        return table(columns)

    def standard_errors(self, readings=None, *, progress=None, **keywords):
        """The standard error of each basin's rainfall at each step: time, and a column for each basin. NaN where fewer
        than five gauges report or all that do read the same. Takes what `rain` takes.
        """
        matrix, times, given = self._readings(readings, {**keywords, "error": True})
        names, file_times, values, errors, told = self._study.rain(matrix, given, progress)
        self._tell(told)
        columns = {"time": self._time_column(times, file_times, len(values))}
        columns.update((name, errors[:, i]) for i, name in enumerate(names))
        return table(columns)

    def influence(self, readings=None, *, progress=None, **keywords):
        """What each gauge is worth to each basin: basin, station, weight, rms_change, mean_change, by how much the
        rainfall of the basin changes when the gauge is left out, over all steps. Takes the readings that `rain` takes.
        """
        matrix, _, given = self._readings(readings, keywords)
        (basin, station, weight, rms, mean), told = self._study.influence(matrix, given, progress)
        self._tell(told)
        return table({"basin": self._basins[basin], "station": self._stations[station], "weight": weight,
                      "rms_change": rms, "mean_change": mean})

    def _readings(self, readings, keywords):
        """The readings in memory, their times, and the keywords of a series."""
        keywords = {**self._of_series, **keywords}
        if readings is None:
            if self._matrix is None and not self._study.has_readings:
                raise _thiessen.Error("there are no readings\nhint: give an array, a frame or a file, here or to the "
                                      "study")
            return self._matrix, self._times, texts_of(keywords)
        if _are_files(readings):
            return None, None, _rainfall_keywords(readings) + texts_of(keywords)
        held = readings_of(readings, lambda: self._study.given_ids, keywords.pop("ignore_unknown", False))
        return held.matrix, held.times, texts_of(keywords)

    @staticmethod
    def _time_column(times, file_times, steps):
        if times is not None:
            return times
        return numpy.array(file_times, dtype=object) if file_times else numpy.arange(steps)
