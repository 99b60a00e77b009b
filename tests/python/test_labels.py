"""Readings in memory that have labels go by them, in whatever order they stand."""

import numpy
import pandas
import pytest

import thiessen
from test_places import GAUGES, POLYGON, STORM

IDS = list(GAUGES)
ANSWER = pytest.approx(69.8364, abs=5e-5)  # the textbook's, as in test_places.py
BACKWARDS = pandas.DataFrame([STORM], columns=IDS).iloc[:, ::-1]


@pytest.fixture(scope="module")
def study():
    return thiessen.Study(GAUGES, {"A": POLYGON}, metric="planar")


LABELLED = {
    "frame": BACKWARDS,
    "frame of whole numbers": BACKWARDS.rename(columns=int),
    "frame of numbers": BACKWARDS.rename(columns=float),
    "row of a frame": BACKWARDS.iloc[0],
    "series": pandas.Series(STORM, index=IDS)[::-1],
    "series without labels": pandas.Series(STORM),
    "dictionary of lists": {name: [value] for name, value in reversed(list(zip(IDS, STORM)))},
    "dictionary": dict(reversed(list(zip(IDS, STORM)))),
    "structured array": numpy.array([tuple(reversed(STORM))], dtype=[(name, float) for name in reversed(IDS)]),
    "list": STORM,
}


@pytest.mark.parametrize("form", LABELLED)
def test_readings_go_by_their_labels(study, form):
    assert study.rain(LABELLED[form])["A"].tolist() == [ANSWER]
    with_study = thiessen.Study(GAUGES, {"A": POLYGON}, LABELLED[form], metric="planar")
    assert with_study.rain()["A"].tolist() == [ANSWER]


def test_labels_that_only_count_are_ids_where_stations_are_called_so():
    study = thiessen.Study([(0, 0), (1, 1)], {"A": "POLYGON ((-1 -1, 0.4 -1, 0.4 0.4, -1 0.4, -1 -1))"}, ids=[1, 0],
                           metric="planar")
    assert study.rain(pandas.Series([3, 5]))["A"].tolist() == [5]  # the basin is all of station 1's cell


def test_a_series_of_other_labels_is_refused(study):
    with pytest.raises(thiessen.Error, match="no column of the readings is a station"):
        study.rain(pandas.Series(STORM, index=list("abcdefghi")))
    with pytest.raises(thiessen.Error, match="columns of the readings are no stations: 'x'"):
        study.rain(pandas.Series([*STORM, 1], index=[*IDS, "x"]))
    assert study.rain(pandas.Series([*STORM, 1], index=[*IDS, "x"]), ignore_unknown=True)["A"].tolist() == [ANSWER]


def test_a_row_of_a_frame_keeps_its_time(study):
    days = pandas.date_range("1990-01-01", periods=2)
    frame = pandas.DataFrame([STORM, STORM], columns=IDS, index=days)
    assert study.rain(frame.loc["1990-01-02"])["time"].tolist() == [days[1]]


def test_lists_of_several_lengths_are_refused(study):
    with pytest.raises(thiessen.Error, match="all of one length"):
        study.rain({"1": [1, 2], "2": [1]})


@pytest.mark.parametrize("readings, words", [
    (numpy.full((1, 9), numpy.datetime64("2000-01-01")), "no numbers: they are datetime64"),
    (numpy.ones((1, 9), complex), "no numbers: they are complex128"),
    (pandas.DataFrame({name: pandas.date_range("2000-01-01", periods=2) for name in IDS}), "no numbers: they are datetime64"),
    ([["x"] * 9], "no numbers"),
    ([STORM, STORM[1:]], "no numbers"),
    (numpy.ones((2, 2, 9)), "readings of 3 dimensions"),
])
def test_what_is_no_reading_is_refused(study, readings, words):
    with pytest.raises(thiessen.Error, match=words):
        study.rain(readings)
