"""Readings in memory as an array of doubles, a row for each step and a column for each station."""

import numpy

from . import _thiessen
from .forms import column_numbers, id_text, is_frame, is_series, labels_of, named, numbers
from .tables import pandas


class Held:
    """Readings in memory: the array, the times of its rows, if they have some, and whether stations were found by
    labels."""

    def __init__(self, matrix, times=None, labelled=False):
        self.matrix = matrix
        self.times = times
        self.labelled = labelled


class _Labelled:
    """Readings whose columns have labels: their labels, the columns by their places, their number of rows, times."""

    def __init__(self, labels, column, rows, times):
        self.labels = [id_text(label) for label in labels]
        self.column = column
        self.rows = rows
        self.times = times


def _of_dictionary(columns):
    arrays = [numpy.atleast_1d(numbers(column, f"the readings of {name!r}")) for name, column in columns.items()]
    sizes = {array.shape for array in arrays}
    if len(sizes) > 1 or any(len(shape) != 1 for shape in sizes):
        raise _thiessen.Error("readings in a dictionary are a list for each station, all of one length")
    return _Labelled(columns, arrays.__getitem__, len(arrays[0]) if arrays else 0, None)


def _of_frame(frame):
    def column(i):
        return column_numbers(frame.iloc[:, i], f"the readings in column {str(frame.columns[i])!r}")

    return _Labelled(frame.columns, column, len(frame), frame.index)


def _of_series(series):
    """One step: a row of a frame, whose name is its time."""
    values = column_numbers(series, "the readings")
    times = pandas.Index([series.name]) if hasattr(series.name, "isoformat") else None
    return _Labelled(series.index, lambda i: values[i:i + 1], 1, times)


def _labels_along(array, dimension):
    return [id_text(label) for label in array.coords[dimension].values] if dimension in array.coords else None


def _of_data_array(array, ids):
    """An array of xarray: which dimension is the stations' say its labels, or else its name."""
    if array.ndim not in (1, 2):
        raise _thiessen.Error(f"readings of {array.ndim} dimensions: time and station are wanted")
    known = set(ids)
    dimensions = [str(dimension) for dimension in array.dims]
    by_labels = [i for i, dimension in enumerate(array.dims)
                 if known.intersection(_labels_along(array, dimension) or ())]
    by_name = _thiessen.known_columns(dimensions)[0]
    if len(by_labels) == 1:
        stations = by_labels[0]
    elif by_name is not None:
        stations = by_name
    elif not any(_labels_along(array, dimension) for dimension in array.dims[-1:]):
        stations = array.ndim - 1
    else:
        raise _thiessen.Error(f"no dimension of the readings is known to be the stations': {named(dimensions)}\n"
                              "hint: coordinates of ids, or the name 'station'")
    values = array.values if array.ndim == 2 else array.values[numpy.newaxis, :]
    if array.ndim == 2 and stations == 0:
        values = values.T
    values = numbers(values, "the readings")
    other = [dimension for i, dimension in enumerate(array.dims) if i != stations]
    times = array.coords[other[0]].to_index() if other and other[0] in array.coords else None
    if not other and "time" in array.coords and array.coords["time"].ndim == 0:
        times = pandas.Index([array.coords["time"].values[()]])
    labels = _labels_along(array, array.dims[stations])
    if labels is None:
        return Held(values, times)
    return _Labelled(labels, lambda i: values[:, i], len(values), times)


def _labelled(readings, ids_of_stations):
    """Readings whose stations have labels, or Held where it is an array of them without; None for all others."""
    if is_frame(readings):
        return _of_frame(readings)
    if isinstance(readings, dict):
        return _of_dictionary(readings)
    if is_series(readings):
        # A series that only counts its values has no labels, unless the stations are so called.
        if labels_of(readings) is None and {id_text(one) for one in readings.index} != set(ids_of_stations()):
            return Held(column_numbers(readings, "the readings")[numpy.newaxis, :])
        return _of_series(readings)
    if hasattr(readings, "dims") and hasattr(readings, "coords") and hasattr(readings, "ndim"):
        return _of_data_array(readings, ids_of_stations())
    names = getattr(getattr(readings, "dtype", None), "names", None)
    if names is None and hasattr(readings, "columns") and hasattr(readings, "__getitem__"):  # as polars has them
        names = [str(name) for name in readings.columns]
    return _of_dictionary({name: readings[name] for name in names}) if names is not None else None


def _by_labels(found, ids, ignore_unknown):
    """The array of readings by their labels. Stations without any are silent in it."""
    columns = {label: i for i, label in enumerate(found.labels)}
    if len(columns) < len(found.labels):
        raise _thiessen.Error("two columns of the readings have one name")
    unknown = sorted(set(columns) - set(ids))
    if columns and len(unknown) == len(columns):
        raise _thiessen.Error(f"no column of the readings is a station: found {named(columns)}\n"
                              "hint: a column for each station, and the times in the index")
    if unknown and not ignore_unknown:
        raise _thiessen.Error(f"columns of the readings are no stations: {named(unknown)}\n"
                              "hint: ignore_unknown=True passes over them")
    matrix = numpy.full((found.rows, len(ids)), numpy.nan)
    for i, station in enumerate(ids):
        if station in columns:
            matrix[:, i] = found.column(columns[station])
    return Held(matrix, found.times, labelled=True)


def readings_of(readings, ids_of_stations, ignore_unknown=False):
    """Readings in memory. Where they have labels, which are ids of stations, columns are found by these; else they are
    in the order of the stations, whose ids are asked for only where that matters.
    """
    found = _labelled(readings, ids_of_stations)
    if isinstance(found, Held):
        return found
    if found is not None:
        return _by_labels(found, ids_of_stations(), ignore_unknown)
    array = numbers(readings, "the readings")
    if array.ndim == 1:
        array = array[numpy.newaxis, :]
    if array.ndim != 2:
        raise _thiessen.Error(f"readings of {array.ndim} dimensions: an array of steps by stations is wanted")
    return Held(array)


def _is_midnight(times):
    return times.tz is None and bool((times == times.normalize()).all())


def time_texts(times, ends_steps=False):
    """Times as ISO 8601 writes them. Timestamps of pandas that are all midnight are days, as pandas writes them; but
    where it is said what times are of their steps they have clocks.
    """
    if hasattr(times, "normalize"):
        if not ends_steps and _is_midnight(times):
            return list(times.strftime("%Y-%m-%d"))
        return [time.isoformat() for time in times]
    return [time.isoformat() if hasattr(time, "isoformat") else str(time) for time in times]


def texts_of_unique(times, ends_steps=False):
    """The same of times of which each is there once."""
    if not times.is_unique:
        raise _thiessen.Error(f"the time {str(times[times.duplicated()][0])!r} is there twice\n"
                              "hint: times are told apart by what they are called")
    return time_texts(times, ends_steps)


def text_of_time(time, times, texts):
    """The text of the one of these times that is meant; `texts` are theirs."""
    meant = str(time)
    if hasattr(times, "normalize"):
        try:
            stamp = pandas.Timestamp(time)
            if (stamp.tz is None) != (times.tz is None):
                stamp = stamp.tz_localize(times.tz)
            found = numpy.flatnonzero(times == stamp)
        except (TypeError, ValueError):
            found = ()
        if len(found):
            return texts[found[0]]
    elif meant in texts:
        return meant
    raise _thiessen.Error(f"there is no time step {meant!r}" +
                          (f": the first is {texts[0]!r}, the last {texts[-1]!r}" if texts else ""))
