"""Tables of results."""

import numpy

try:
    import pandas
except ImportError:
    pandas = None


def table(columns):
    """A DataFrame of the columns or, where pandas is not installed, a structured array."""
    if pandas is not None:
        return pandas.DataFrame(columns)
    arrays = {}
    for name, column in columns.items():
        column = numpy.asarray(column)
        arrays[name] = column.astype(str) if column.dtype == object else column
    size = len(next(iter(arrays.values())))
    result = numpy.empty(size, dtype=[(name, column.dtype) for name, column in arrays.items()])
    for name, column in arrays.items():
        result[name] = column
    return result
