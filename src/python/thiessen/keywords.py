"""Keywords as the texts of the program's options."""

import datetime
import numbers
import os

import numpy

# What decides which stations a file has, and what they are called.
OF_STATIONS = ("id", "x", "y", "crs", "skip_unplaced", "stations_layer", "stations_where", "separator", "decimal_comma",
               "encoding", "skip", "stations_separator", "stations_decimal_comma", "stations_encoding",
               "stations_skip")

# What says how a series is computed, of a study and of its readings alike.
OF_SERIES = ("gaps", "min_gauges", "cache", "method", "grid", "interval", "from_", "to", "stamp", "every",
             "allow_missing", "day_start", "year_start", "dry")
# What of these is about the steps that count and about memory, which the worth of a gauge has too.
OF_INFLUENCE = ("cache", "from_", "to", "stamp")

# What gives a study normals: what times are of their steps then decides in which month a step is.
OF_NORMALS = ("normals", "normal_field", "elevation", "elevation_field")

# What is about the times of steps.
OF_TIMES = ("from_", "to", "stamp", "every", "allow_missing", "day_start", "year_start", "dry")

# The long options of `rain`, `weights` and `cells` that are no keywords, for they say where a table goes and how it is
# written, or are methods here: `influence` is.
NO_KEYWORDS = ("append", "decimals", "delaunay", "format", "help", "influence", "iso_times", "long", "neighbours",
               "output", "output_layer", "overwrite", "study", "units", "version", "weights_log")

# What may be the number of EPSG's code.
CRS_KEYWORDS = ("crs", "basins_crs", "plane")


def is_given(value):
    """None and False say nothing."""
    return value is not None and not (isinstance(value, (bool, numpy.bool_)) and not value)


def crs_text(crs):
    """A CRS as text: the number is that of EPSG's code, and a CRS of pyproj is WKT."""
    if crs is None or isinstance(crs, str):
        return crs or ""
    if isinstance(crs, numbers.Integral) and not isinstance(crs, bool):
        return f"EPSG:{int(crs)}"
    to_wkt = getattr(crs, "to_wkt", None)
    if to_wkt is None:
        raise TypeError(f"a CRS is a {type(crs).__name__}: EPSG's number, a text or a CRS of pyproj is wanted")
    return to_wkt()


def _text_of(name, value):
    if isinstance(value, str):
        return value
    if name in CRS_KEYWORDS:
        return crs_text(value)
    if isinstance(value, (datetime.date, datetime.datetime)):
        return value.isoformat()
    if isinstance(value, numpy.datetime64):
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (int, float)) or hasattr(value, "__float__"):
        return repr(int(value)) if float(value).is_integer() and abs(value) < 1e15 else repr(float(value))
    if hasattr(value, "isoformat") or hasattr(value, "strftime"):  # a Timestamp, a Period
        return value.isoformat() if hasattr(value, "isoformat") else str(value)
    raise TypeError(f"{name} is a {type(value).__name__}: a text, a number, a truth value or a list of them is wanted")


def _is_listed(value):
    return isinstance(value, (list, tuple)) or (isinstance(value, numpy.ndarray) and value.ndim > 0)


def _is_point(value):
    return _is_listed(value) and len(value) == 2 and all(isinstance(one, numbers.Real) for one in value)


def _texts(name, value):
    if isinstance(value, (bool, numpy.bool_)):
        return ["true"]
    if name == "with_" and _is_point(value):
        value = [value]
    if not _is_listed(value):
        return [_text_of(name, value)]
    if name == "method":  # several are one text
        return [",".join(_text_of(name, one) for one in value)] if len(value) else []
    return [",".join(_text_of(name, part) for part in one) if name == "with_" and _is_listed(one) else
            _text_of(name, one) for one in value]


def texts_of(keywords, only_stations=False):
    """Pairs of a keyword and the texts of its values. None and False say nothing; True is a flag; a list repeats."""
    pairs = []
    for name, value in keywords.items():
        if name != name.lower():  # the program's arguments have names in capitals, which are no keywords
            raise TypeError(f"there is no keyword {name!r}")
        if not is_given(value) or (only_stations and name not in OF_STATIONS):
            continue
        texts = _texts(name, value)
        if texts:
            pairs.append((name, texts))
    return pairs
