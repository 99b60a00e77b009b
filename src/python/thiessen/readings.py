"""Readings in memory as an array of doubles, a row for each step and a column for each station."""

import numpy

from . import _thiessen


def _is_frame(value):
    return hasattr(value, "columns") and hasattr(value, "index") and hasattr(value, "to_numpy")


def _named(names):
    names = [repr(name) for name in names]
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")


def readings_of(readings, ids_of_stations, ignore_unknown):
    """The array, and the times of its rows where they have some. Stations that a frame lacks are silent in it; its
    columns are found by the ids, which are asked for only then.
    """
    if _is_frame(readings):
        ids = ids_of_stations()
        columns = {str(name): i for i, name in enumerate(readings.columns)}
        if len(columns) < len(readings.columns):
            raise _thiessen.Error("two columns of the readings have one name")
        unknown = sorted(set(columns) - set(ids))
        if len(unknown) == len(columns):
            raise _thiessen.Error(f"no column of the readings is a station: found {_named(columns)}\n"
                                  "hint: a column for each station, and the times in the index")
        if unknown and not ignore_unknown:
            raise _thiessen.Error(f"columns of the readings are no stations: {_named(unknown)}\n"
                                  "hint: ignore_unknown=True passes over them")
        matrix = numpy.full((len(readings), len(ids)), numpy.nan)
        for i, station in enumerate(ids):
            if station in columns:
                matrix[:, i] = readings.iloc[:, columns[station]].to_numpy(dtype=float, na_value=numpy.nan)
        return matrix, readings.index
    array = numpy.asanyarray(readings)
    if numpy.ma.isMaskedArray(array):
        array = array.astype(float).filled(numpy.nan)
    if array.ndim == 1:
        array = array[numpy.newaxis, :]
    if array.ndim != 2:
        raise _thiessen.Error(f"readings of {array.ndim} dimensions: an array of steps by stations is wanted")
    # Copied only where they are no doubles in C's order.
    return numpy.ascontiguousarray(array, dtype=numpy.float64), None
