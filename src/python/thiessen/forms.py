"""What values of other libraries are, told by what they can do: none of these has to be installed."""

import numpy

from . import _thiessen
from .tables import pandas

KINDS = ("FeatureCollection", "Feature", "GeometryCollection", "Point", "MultiPoint", "LineString", "MultiLineString",
         "Polygon", "MultiPolygon")


def named(names):
    """Names for a message: the first five, and how many there are besides."""
    names = [repr(name) for name in names]
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")


def interface(value):
    """The GeoJSON that a value is or tells of itself; None where it does neither."""
    if isinstance(value, dict):
        return value if value.get("type") in KINDS else None
    return getattr(value, "__geo_interface__", None)


def is_frame(value):
    return hasattr(value, "columns") and hasattr(value, "index") and hasattr(value, "to_numpy")


def is_series(value):
    """A column or a row of a frame: values with labels."""
    return hasattr(value, "index") and not callable(value.index) and hasattr(value, "to_numpy") \
        and not hasattr(value, "columns")


def labels_of(value):
    """The labels of a frame's rows or of a series; None where they only count the rows from 0, or there are none."""
    index = getattr(value, "index", None)
    if index is None or callable(index):
        return None
    counts = type(index).__name__ == "RangeIndex" and index.start == 0 and index.step == 1
    return None if counts else index


def is_missing(value):
    """Whether a value is none: None, NaN, pandas.NA."""
    if value is None:
        return True
    if pandas is not None and (value is pandas.NA or value is pandas.NaT):
        return True
    return isinstance(value, (float, numpy.floating)) and bool(numpy.isnan(value))


def id_text(value):
    """An id as text: 7 for 7.0, which is what a column of whole numbers with gaps makes of 7; empty where it is
    missing."""
    if is_missing(value):
        return ""
    if isinstance(value, (float, numpy.floating)) and float(value).is_integer():
        return str(int(value))
    return str(value)


def numbers(values, what):
    """Numbers as an array of doubles in C's order, copied only where they are none. Raises Error where they are none
    at all: dates and complex numbers, which NumPy would take for numbers.
    """
    try:
        array = numpy.asanyarray(values)
        if numpy.ma.isMaskedArray(array):
            array = array.astype(float).filled(numpy.nan)
        if array.dtype.kind not in "biufOUS":
            raise TypeError(f"they are {array.dtype}")
        return numpy.ascontiguousarray(array, dtype=numpy.float64)
    except (TypeError, ValueError) as fault:
        raise _thiessen.Error(f"{what} are no numbers: {fault}") from None


def column_numbers(column, what):
    """The numbers of a frame's column; NaN where one is missing."""
    kind = getattr(column.dtype, "kind", "O")
    if kind not in "biufO":
        raise _thiessen.Error(f"{what} are no numbers: they are {column.dtype}")
    try:
        return column.to_numpy(dtype=float, na_value=numpy.nan)
    except (TypeError, ValueError) as fault:
        raise _thiessen.Error(f"{what} are no numbers: {fault}") from None
