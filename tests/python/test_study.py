"""A study in Python gives what the program gives, digit for digit."""

import csv
import json

import numpy
import pandas
import pytest

import thiessen
from conftest import COLORADO, TEXTBOOK, rows, run

STUDIES = {"textbook": (TEXTBOOK, {"metric": "planar"}), "colorado": (COLORADO, {})}


@pytest.fixture(params=STUDIES)
def study_and_command(request):
    files, keywords = STUDIES[request.param]
    options = [word for name, value in keywords.items() for word in (f"--{name}", value)]
    return thiessen.Study(*files, **keywords), files, options


def as_floats(found, column):
    return [float(row[column]) if row[column] else float("nan") for row in found]


def test_weights_are_the_programs(study_and_command):
    study, files, options = study_and_command
    # The program's weights of the full network, as `run` has them: without gauges that never report.
    header, found = rows("weights", *files[:2], *options)
    table = study.weights()
    silent = set(study.never_reporting)
    if not silent:
        assert list(table.columns) == header
        assert list(table["basin"]) == [row[0] for row in found]
        assert list(table["station"]) == [row[1] for row in found]
        assert list(table.iloc[:, 2]) == as_floats(found, 2)
        assert list(table["weight"]) == as_floats(found, 3)
    sums = table.groupby("basin")["weight"].sum()
    assert numpy.allclose(sums, 1, rtol=0, atol=1e-12)


def test_weights_without_readings_are_the_programs():
    study = thiessen.Study(*COLORADO[:2])
    header, found = rows("weights", *COLORADO[:2])
    table = study.weights()
    assert list(table.columns) == header
    assert table["station"].tolist() == [row[1] for row in found]
    assert table["area_km2"].tolist() == as_floats(found, 2)
    assert table["weight"].tolist() == as_floats(found, 3)


def test_rain_is_the_programs(study_and_command):
    study, files, options = study_and_command
    header, found = rows("rain", *files, *options, "--decimals", "12")
    table = study.rain()
    assert list(table.columns) == header
    assert list(table["time"]) == [row[0] for row in found]
    for column, name in enumerate(header[1:], 1):
        texts = ["" if numpy.isnan(value) else f"{value:.12f}" for value in table[name]]
        assert texts == [row[column] for row in found], name


@pytest.mark.parametrize("gaps", ["retessellate", "renormalise", "strict"])
def test_gap_policies_are_the_programs(gaps):
    header, found = rows("rain", *COLORADO, "--gaps", gaps, "--min-gauges", "2")
    table = thiessen.Study(*COLORADO).rain(gaps=gaps, min_gauges=2)
    for column, name in enumerate(header[1:], 1):
        assert ["" if numpy.isnan(v) else f"{v:.3f}" for v in table[name]] == [row[column] for row in found]


def test_methods_are_the_programs():
    header, found = rows("rain", *COLORADO, "--method", "thiessen,idw", "--to", "1994-06-01")
    table = thiessen.Study(*COLORADO).rain(method="thiessen,idw", to="1994-06-01")
    assert list(table.columns) == header
    assert [f"{v:.3f}" for v in table[header[2]]] == [row[2] for row in found]


def test_standard_errors_are_the_programs():
    header, found = rows("rain", *COLORADO, "--error", "--decimals", "9")
    study = thiessen.Study(*COLORADO)
    both = study.rain(error=True)
    assert list(both.columns) == header
    errors = study.standard_errors()
    count = len(study.basins)
    for i, name in enumerate(study.basins):
        texts = ["" if numpy.isnan(v) else f"{v:.9f}" for v in errors[name]]
        assert texts == [row[1 + count + i] for row in found], name
        assert both[name + "_se"].equals(errors[name])


def test_standard_errors_of_totals_and_of_other_methods_are_the_programs():
    header, found = rows("rain", *COLORADO, "--error", "--every", "year", "--method", "thiessen,idw",
                         "--allow-missing", "9")
    with pytest.warns(thiessen.ThiessenWarning, match="near gauges differ for good"):
        both = thiessen.Study(*COLORADO).rain(error=True, every="year", method="thiessen,idw", allow_missing=9)
    assert list(both.columns) == header
    for i, name in enumerate(header[1:], 1):
        if name.endswith("_se"):
            texts = ["" if numpy.isnan(v) else f"{v:.3f}" for v in both[name]]
            assert texts == [row[i] for row in found], name


def test_influence_is_the_programs():
    header, found = rows("weights", *TEXTBOOK[:2], "--metric", "planar", "--influence", TEXTBOOK[2])
    table = thiessen.Study(*TEXTBOOK, metric="planar").influence()
    assert list(table.columns) == header
    assert table["station"].tolist() == [row[1] for row in found]
    for column, name in enumerate(header[2:], 2):
        assert numpy.array_equal(table[name], as_floats(found, column), equal_nan=True)


def test_cells_are_the_programs():
    assert thiessen.Study(*COLORADO[:2]).cells() == json.loads(run("cells", *COLORADO[:2]))


def test_cells_with_rainfall_are_the_programs():
    readings = pd_readings()
    times = [None, readings.index[3]]
    for time in times:
        words = () if time is None else ("--time", time)
        wanted = json.loads(run("cells", *COLORADO, *words))
        assert "rainfall" in wanted["features"][0]["properties"]
        assert thiessen.Study(*COLORADO).cells(time=time) == wanted
        in_memory = thiessen.Study(*COLORADO[:2], readings).cells(time=time)
        assert in_memory["features"] == wanted["features"]
    dated = readings.set_axis(pandas.to_datetime(readings.index))
    study = thiessen.Study(*COLORADO[:2], dated)
    assert study.cells(time=dated.index[3])["features"] == wanted["features"]
    assert study.cells(time=str(dated.index[3].date()))["features"] == wanted["features"]
    with pytest.raises(thiessen.Error, match="there is no time step '2050-01-01': the first is"):
        study.cells(time="2050-01-01")
    with pytest.raises(thiessen.Error, match="time is about times, and the readings in memory have none"):
        thiessen.Study(*COLORADO[:2], readings.to_numpy()).cells(time="1990")
    with pytest.raises(thiessen.Error, match="time is about readings, and the study has none"):
        thiessen.Study(*COLORADO[:2]).cells(time="1990")


def test_readings_in_memory_are_those_of_the_file():
    readings = pd_readings()
    from_file = thiessen.Study(*COLORADO)
    from_frame = thiessen.Study(*COLORADO[:2], readings)
    assert from_frame.stations == from_file.stations
    assert from_frame.never_reporting == from_file.never_reporting
    one, other = from_file.rain(), from_frame.rain()
    assert list(one.columns) == list(other.columns)
    for name in from_file.basins:
        assert numpy.array_equal(one[name], other[name], equal_nan=True)
    array = thiessen.Study(*COLORADO[:2], readings.to_numpy()).rain()
    for name in from_file.basins:
        assert numpy.array_equal(one[name], array[name], equal_nan=True)


def pd_readings():
    """The sample's readings as pandas reads them, with a column for each station of the list, in its order."""
    frame = pandas.read_csv(COLORADO[2])
    frame = frame.set_index(frame.columns[0])
    stations = [row[0] for row in csv_rows(COLORADO[0])]
    return frame.reindex(columns=stations)


def csv_rows(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.reader(lines))[1:]
