"""A study: gauges, basins, and the rainfall of the one over the other."""

import json
import os
import warnings as warning_list

import numpy

from . import _thiessen
from .keywords import OF_INFLUENCE, OF_NORMALS, OF_SERIES, OF_TIMES, is_given, texts_of
from .places import basins_of, stations_of
from .readings import readings_of, text_of_time, texts_of_unique, time_texts
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

    stations: the name of a file, as the program reads it; a dictionary of ids and places; an array of two columns, or
        a list of places, with `ids` (else they are numbered from 1); a frame with columns of usual names (station,
        longitude, latitude) or those that `id`, `x` and `y` name; a GeoDataFrame, a GeoJSON FeatureCollection or
        anything else with `__geo_interface__`. A place is (x, y), or a point as a shape.
    basins: the name of a file; a dictionary of ids and shapes; a list of shapes, with `basin_ids` (else they are
        numbered from 1); a GeoDataFrame, a FeatureCollection, whose field `basin_id` names. A shape is a GeoJSON
        geometry or Feature, anything with `__geo_interface__`, WKB, or WKT. Without basins the study area is the
        extent of the stations, grown by `margin` percent.
    rainfall: readings, which decide which stations are of the network: those with at least one. Files, or what
        `rain` takes. Without them all stations are.
    normals, normal_field: long-term means, in any unit: a reading counts at a point times the normal there over the
        gauge's. A raster that GDAL reads, of one band, or of twelve for the calendar months; or the field of stations
        and of basins that has them, or the twelve fields normal_01 to normal_12 for "normal": in files, in columns of
        frames, or in properties of features.
    elevation, elevation_field: normals are fitted to `rainfall`, which is in files, by elevation: of the ground from a
        raster, of stations from a field of their file; `elevation_field` alone is of stations and of basins.
    ids, basin_ids: of stations and basins that have none. The labels of a series or a GeoDataFrame are ids where no
        column is.
    progress: called with the steps done and those there are (0 where that is not known), some twenty times a second.
    keywords: the long options of the program, such as crs, basins_crs, metric, plane, tolerance, margin, mend,
        allow_far, threads, basin_id, stations_where; of readings in files also station_field, value_field,
        time_field, missing, ignore_unknown and so on; and those of `rain`, which it takes for granted where it is not
        told otherwise: gaps, min_gauges, method, from_ and so on. What cannot act on what is given, as stations_where
        on an array, is an Error. A CRS may be a text, EPSG's number, or one of pyproj. quiet=True tells no warnings.

    Coordinates in memory need a CRS: their own, as a GeoDataFrame, EWKT and a member `crs` of GeoJSON have it; or
    `crs` and `basins_crs` ("EPSG:4326" for longitude and latitude), which may not contradict their own; or
    metric="planar". A FeatureCollection or a Feature of GeoJSON is in longitude and latitude where nothing else is
    said; a bare geometry says nothing.

    Raises Error, in the words of the program, for input that cannot be used, and TypeError for an unknown keyword.
    What is odd is told as a ThiessenWarning, and stands in `warnings`. A study may be used by several threads, one at
    a time; the interpreter is free while it computes, and Ctrl-C ends it. It cannot be pickled: another process makes
    its own.
    """

    def __init__(self, stations, basins=None, rainfall=None, *, ids=None, basin_ids=None, progress=None, **keywords):
        self._quiet = is_given(keywords.pop("quiet", None))
        self._of_series = {name: keywords.pop(name) for name in OF_SERIES if name in keywords}
        given = []
        self._held = held_stations, held_basins = self._places(stations, basins, ids, basin_ids, keywords, given)
        self._readings_held = None
        if _are_files(rainfall):
            given += _rainfall_keywords(rainfall)
        elif rainfall is not None:
            def ids_of_stations():
                if held_stations is not None:
                    return held_stations.ids
                return _thiessen.station_ids([given[0], *texts_of(keywords, only_stations=True)])

            self._readings_held = _held_readings(rainfall, ids_of_stations, keywords)
        held = self._readings_held
        self._keywords = given + texts_of(keywords)
        _thiessen.check_series(texts_of(self._of_series), None if held is None else held.times is not None,
                               any(is_given(keywords.get(name)) for name in (*OF_NORMALS, "totals")))
        self._study = _thiessen.Study(held_stations and held_stations.made(), held_basins and held_basins.made(),
                                      held and held.matrix, self._keywords,
                                      str(self._of_series.get("stamp", "")) == "end", progress)
        self._stations = numpy.array(self._study.stations, dtype=object)
        self._basins = numpy.array(self._study.basins, dtype=object)
        self._tell(self._study.warnings)

    @staticmethod
    def _places(stations, basins, ids, basin_ids, keywords, given):
        """The stations and basins that are in memory, and names for both in the place of files."""
        held_stations = held_basins = None
        if _is_path(stations):
            given.append(("STATIONS", [os.fspath(stations)]))
            if ids is not None:
                raise TypeError("ids are of stations in memory; id names the field of a file")
        else:
            held_stations = stations_of(stations, ids, keywords)
            given.append(("STATIONS", ["stations"]))
        if _is_path(basins):
            given.append(("BASINS", [os.fspath(basins)]))
        elif basins is not None:
            held_basins = basins_of(basins, basin_ids, keywords)
            given.append(("BASINS", ["basins"]))
        if held_basins is None and basin_ids is not None:
            raise TypeError("basin_ids are of basins in memory; basin_id names the field of a file")
        return held_stations, held_basins

    def __reduce__(self):
        raise TypeError("a Study cannot be pickled or copied\nhint: make it again, of what it was made of, where it is "
                        "wanted")

    def _tell(self, texts, depth=3):
        for text in texts if not self._quiet else ():
            warning_list.warn(text, ThiessenWarning, stacklevel=depth)

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

    def weights(self, *, without=None, with_=None):
        """The share of each basin that lies in each station's cell: basin, station, area_km2 (or area, where the unit
        of the plane is not known), weight. The weights of a basin add up to 1. With normals also factor, by which a
        reading counts beside its weight, or factor_01 to factor_12 of calendar months. A DataFrame, or where pandas is
        not installed a structured array.

        without, with_: what if these stations closed (an id, or a list of ids), and gauges opened at these points
            ((x, y), or a list of them, in the stations' coordinates; the first is called 'with 1'): beside them
            area_km2_after and weight_after, and factor_after, NaN where there is no weight.
        """
        changes = texts_of({"without": without, "with_": with_})
        if changes:
            return self._changed_weights(changes)
        basin, station, area, weight, *factors = self._study.weights()
        return table({"basin": self._basins[basin], "station": self._stations[station],
                      self._study.area_column: area, "weight": weight, **dict(zip(_factors(len(factors)), factors))})

    def _changed_weights(self, changes):
        stations, basins = (held and held.made() for held in self._held)
        (basin, station, *numbers), names, told = _thiessen.changed_weights(stations, basins, self._keywords + changes,
                                                                            self.never_reporting)
        self._tell(told, depth=4)
        area = self._study.area_column
        columns = [area, "weight", area + "_after", "weight_after"]
        for factor in _factors((len(numbers) - len(columns)) // 2):
            columns += [factor, factor + "_after"]
        return table({"basin": self._basins[basin], "station": numpy.array(names, dtype=object)[station],
                      **dict(zip(columns, numbers))})

    def cells(self, *, time=None):
        """The cells, clipped to the basins, as a GeoJSON FeatureCollection: what the program's cells.geojson holds.
        Where the study has readings they have a rainfall: each gauge's mean over the steps that it reports.

        time: the step whose rainfall it is, and whose reporting gauges have the cells; as the file writes it, or as it
            stands in the index of a frame.
        """
        held = self._readings_held
        times, given = [], texts_of({"time": time})
        if held is not None and given:
            if held.times is None:
                raise _thiessen.Error("time is about times, and the readings in memory have none\n"
                                      "hint: a frame has them in its index")
            times = texts_of_unique(held.times)
            given = [("time", [text_of_time(time, held.times, times)])]
        text, told = self._study.cells(held and held.matrix, times, given)
        self._tell(told)
        return json.loads(text)

    def rain(self, readings=None, *, progress=None, **keywords):
        """The areal rainfall of each basin at each step: time, and a column for each basin, in the order of the
        basins; NaN where there is none. With error=True also columns BASIN_se of standard errors, behind all others;
        with every="month" (hour, 6h, day, week, season, year, storm) totals over months, and behind each column
        BASIN_missing, of how many steps without a value; BASIN_se is then the standard error of the total.
        A DataFrame, or where pandas is not installed a structured array.

        readings: nothing, for those of the study; files; an array of steps by stations, in the order in which the
            stations were given, NaN where a gauge is silent; a frame with a column for each station, whose index is
            the time. What has labels (a frame, a row of one, a dictionary, a structured array, an array of xarray with
            coordinates) goes by them. An array of doubles in C's order is read where it lies.
        keywords: gaps, min_gauges, cache, method (several in a list), grid, interval, error; of readings that have
            times from_, to, every, allow_missing, day_start, year_start, dry, stamp; and of readings in files that are
            named here time_field and the other options of readings.

        Memory: the readings in an array, and the result. Readings in files are read as they are needed.
        """
        return self._rain(readings, progress, {**self._of_series, **keywords}, self._all_columns)

    def standard_errors(self, readings=None, *, progress=None, **keywords):
        """The standard error of each basin's rainfall at each step, or with `every` of each total: time, and a column
        for each basin. NaN where fewer than five gauges report or all that do read the same. Takes what `rain` takes.
        """
        return self._rain(readings, progress, {**self._of_series, **keywords, "error": True},
                          lambda found: zip(found["names"], found["errors"].T))

    @staticmethod
    def _all_columns(found):
        for i, name in enumerate(found["names"]):
            yield name, found["rainfall"][:, i]
            if "missing" in found:
                yield name + "_missing", found["missing"][:, i].astype(numpy.int64)
        if "errors" in found:
            for i, name in enumerate(found["names"]):
                yield name + "_se", found["errors"][:, i]

    def _rain(self, readings, progress, keywords, columns_of):
        held, texts = self._readings(readings, keywords)
        found = self._study.rain(*_handed(held, keywords, self._study.tells_months), texts, progress)
        self._tell(found["warnings"], depth=4)
        return table({"time": _time_column(held, found), **dict(columns_of(found))})

    def influence(self, readings=None, *, progress=None, **keywords):
        """What each gauge is worth to each basin: basin, station, weight, rms_change, mean_change, by how much the
        rainfall of the basin changes when the gauge is left out, over all steps; both by the cells of the gauges that
        report, whatever the study says of gaps and methods. Takes the readings that `rain` takes, and of its keywords
        cache, from_, to, with normals or totals stamp, and those of readings in files.
        """
        acting = [name for name in OF_INFLUENCE if name != "stamp" or self._study.stamp_acts]
        keywords = {**{name: value for name, value in self._of_series.items() if name in acting}, **keywords}
        held, texts = self._readings(readings, keywords)
        (basin, station, weight, rms, mean), told = self._study.influence(*_handed(held, keywords, self._study.tells_months),
                                                                        texts, progress)
        self._tell(told)
        return table({"basin": self._basins[basin], "station": self._stations[station], "weight": weight,
                      "rms_change": rms, "mean_change": mean})

    def _readings(self, readings, keywords):
        """The readings in memory, if they are there, and the keywords of a series as texts."""
        if readings is None:
            readings = keywords.pop("rainfall", None)
        if readings is None:
            if self._readings_held is None and not self._study.has_readings:
                raise _thiessen.Error("there are no readings\nhint: give an array, a frame or a file, here or to the "
                                      "study")
            return self._readings_held, texts_of(keywords)
        if _are_files(readings):
            return None, _rainfall_keywords(readings) + texts_of(keywords)
        return _held_readings(readings, lambda: self._study.given_ids, keywords), texts_of(keywords)


def _held_readings(readings, ids_of_stations, keywords):
    """Readings in memory. Takes ignore_unknown of the keywords where they go by labels."""
    held = readings_of(readings, ids_of_stations, is_given(keywords.get("ignore_unknown")))
    if held.labelled:
        keywords.pop("ignore_unknown", None)
    return held


def _handed(held, keywords, by_month):
    """The array of readings in memory, whether they have times, and these where a keyword is about them, or normals of
    calendar months are."""
    if held is None:
        return None, False, []
    wanted = any(is_given(keywords.get(name)) for name in OF_TIMES)
    if held.times is None or not (wanted or by_month):
        return held.matrix, held.times is not None, []
    return held.matrix, True, (texts_of_unique if wanted else time_texts)(held.times, is_given(keywords.get("stamp")))


def _factors(count):
    """The names of the columns of factors: one of the year, or twelve of the months."""
    return ["factor"] if count == 1 else [f"factor_{month:02}" for month in range(1, count + 1)]


def _time_column(held, found):
    if "missing" in found or held is None:
        return numpy.array(found["times"], dtype=object)
    times = numpy.arange(len(held.matrix)) if held.times is None else held.times
    return times[found["steps"]] if "steps" in found else times
