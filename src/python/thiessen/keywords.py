"""Keywords as the texts of the program's options."""

import datetime
import os

# What decides which stations a file has, and what they are called.
OF_STATIONS = ("id", "x", "y", "crs", "skip_unplaced", "stations_layer", "stations_where", "separator", "decimal_comma",
               "encoding", "skip", "stations_separator", "stations_decimal_comma", "stations_encoding",
               "stations_skip")

# What says how a series is computed, of a study and of its readings alike.
OF_SERIES = ("gaps", "min_gauges", "cache", "method", "grid", "interval", "from_", "to")


def _text_of(name, value):
    if isinstance(value, str):
        return value
    if isinstance(value, (datetime.date, datetime.datetime)):
        return value.isoformat()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (int, float)) or hasattr(value, "__float__"):
        return repr(int(value)) if float(value).is_integer() and abs(value) < 1e15 else repr(float(value))
    to_wkt = getattr(value, "to_wkt", None)  # a CRS of pyproj
    if to_wkt is not None:
        return to_wkt()
    raise TypeError(f"{name} is a {type(value).__name__}: a text, a number, a truth value or a list of them is wanted")


def texts_of(keywords, only_stations=False):
    """Pairs of a keyword and the texts of its values. None and False say nothing; True is a flag; a list repeats."""
    pairs = []
    for name, value in keywords.items():
        if value is None or value is False or (only_stations and name not in OF_STATIONS):
            continue
        if value is True:
            texts = ["true"]
        elif isinstance(value, (list, tuple)):
            texts = [_text_of(name, one) for one in value]
            if not texts:
                continue
        else:
            texts = [_text_of(name, value)]
        pairs.append((name, texts))
    return pairs
