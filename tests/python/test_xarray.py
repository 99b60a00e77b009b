"""Readings in arrays of xarray go by their coordinates."""

import numpy
import pandas
import pytest

import thiessen
from test_labels import ANSWER, IDS, study  # noqa: F401
from test_places import STORM

xarray = pytest.importorskip("xarray")
DAYS = pandas.date_range("2000-01-01", periods=2)


@pytest.mark.parametrize("dims", [("time", "station"), ("station", "time")])
def test_arrays_of_xarray_go_by_their_coordinates(study, dims):
    array = xarray.DataArray(numpy.array([STORM[::-1], [2 * value for value in STORM[::-1]]], float),
                             dims=("time", "station"), coords={"station": IDS[::-1], "time": DAYS}).transpose(*dims)
    table = study.rain(array)
    assert table["A"].tolist() == [ANSWER, pytest.approx(2 * 69.8364, abs=1e-4)]
    assert table["time"].tolist() == list(DAYS)
    assert study.rain(array.isel(time=0))["A"].tolist() == [ANSWER]


def test_arrays_of_xarray_without_coordinates_go_by_the_names_of_their_dimensions(study):
    square = numpy.ones((9, 9)) * numpy.array(STORM, float)
    assert study.rain(xarray.DataArray(square, dims=("time", "station")))["A"].tolist() == [ANSWER] * 9
    assert study.rain(xarray.DataArray(square.T, dims=("station", "time")))["A"].tolist() == [ANSWER] * 9


def test_an_array_of_xarray_of_other_stations_is_refused(study):
    array = xarray.DataArray(numpy.ones((2, 9)), dims=("a", "b"), coords={"b": list("abcdefghi")})
    with pytest.raises(thiessen.Error, match="no dimension of the readings is known to be the stations'"):
        study.rain(array)
