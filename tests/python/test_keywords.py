"""Which of the program's options are keywords, and that none that cannot act is passed over in silence."""

import pickle
import re

import numpy
import pandas
import pytest

import thiessen
from conftest import CLONE, COLORADO, TEXTBOOK, rows, run
from thiessen import _thiessen, keywords
from test_places import GAUGES, POLYGON, STORM

CALLS = dict(_thiessen.keywords_of_calls())
READINGS = numpy.array([STORM, STORM], float)


def options_of(command):
    """The long options of a command, as its help lists them."""
    return set(re.findall(r"^  (?:-\w, )?--([a-z-]+)", run(command, "--help"), re.M))


def as_keyword(option):
    name = option.replace("-", "_")
    return {"from": "from_", "with": "with_"}.get(name, name)


def test_every_option_is_a_keyword_but_those_that_are_listed():
    options = {as_keyword(option) for command in ("rain", "weights", "cells") for option in options_of(command)}
    known = set().union(*CALLS.values())
    assert options - known == set(keywords.NO_KEYWORDS)
    assert known <= options


def test_what_is_no_keyword_is_told():
    for text in (thiessen.__doc__, (CLONE / "samples" / "python" / "README.md").read_text(encoding="utf-8")):
        said = text[text.index("are no keywords"):]
        listed = said[said.index(":") + 1:said.index(".")]
        assert set(re.findall(r"\w+", listed)) == set(keywords.NO_KEYWORDS)


def test_the_lists_are_those_of_the_calls():
    assert set(keywords.OF_SERIES) <= set(CALLS["rain"])
    assert not set(keywords.OF_SERIES) & set(CALLS["Study"])
    assert set(keywords.OF_TIMES) <= set(CALLS["rain"])
    assert set(keywords.OF_INFLUENCE) == set(CALLS["influence"]) & set(keywords.OF_SERIES)
    assert set(keywords.OF_STATIONS) <= set(CALLS["Study"])
    assert set(CALLS["weights"]) == {"without", "with_"}
    assert CALLS["cells"] == ["time"]


# A value that an option takes, for those that take no text.
VALUES = {"stations_skip": 1, "basins_skip": 1, "rainfall_skip": 1, "skip": 1, "scale": 2, "from_unit": "cm", "to_unit": "cm",
          "stations_separator": ";", "basins_separator": ";", "rainfall_separator": ";", "separator": ";",
          "stations_encoding": "cp932", "basins_encoding": "cp932", "rainfall_encoding": "cp932", "encoding": "cp932",
          "normals": "nowhere.tif", "metric": "planar", "plane": "EPSG:32633", "crs": "EPSG:32633", "basins_crs": "EPSG:32633", "tolerance": 1,
          "margin": 1, "threads": 1, "cache": 1, "time_format": "excel", "config": "nowhere.toml",
          "totals_time_format": "excel", "totals_unit": "cm", "observed_at": "09:00", "observed_day": "before"}
FLAGS = {"skip_unplaced", "mend", "decimal_comma", "stations_decimal_comma", "basins_decimal_comma",
         "rainfall_decimal_comma", "allow_far", "ignore_unknown", "ids_as_numbers", "keep_flagged", "cumulative",
         "attributes", "quiet"}
# What acts on a study in memory with basins.
ACT = {"crs", "basins_crs", "mend", "metric", "plane", "allow_far", "tolerance", "threads", "quiet", "config", "normals"}


@pytest.mark.parametrize("name", sorted(set(CALLS["Study"]) - ACT))
def test_a_keyword_that_cannot_act_in_memory_is_an_error(name):
    if name == "rainfall":
        return  # which is the readings themselves
    value = VALUES.get(name, True if name in FLAGS else "zz")
    with pytest.raises(thiessen.Error) as refused:
        thiessen.Study(GAUGES, {"A": POLYGON}, READINGS, metric="planar", **{name: value})
    assert str(refused.value).startswith(name + " ")


def test_a_keyword_that_cannot_act_on_an_array_of_readings_is_an_error():
    study = thiessen.Study(GAUGES, {"A": POLYGON}, metric="planar")
    for name in ("missing", "trace", "time_field", "from_unit", "scale", "ignore_unknown", "cumulative"):
        with pytest.raises(thiessen.Error, match=f"^{name} is about readings in a file, and these are in memory"):
            study.rain(READINGS, **{name: VALUES.get(name, True if name in FLAGS else "zz")})
    for name, value in (("from_", "1990"), ("to", "1990"), ("every", "month")):
        with pytest.raises(thiessen.Error, match=f"^{name} is about times, and the readings in memory have none"):
            study.rain(READINGS, **{name: value})
        with pytest.raises(thiessen.Error, match=f"^{name} is about times"):
            thiessen.Study(GAUGES, {"A": POLYGON}, READINGS, metric="planar", **{name: value})


def test_keywords_of_the_studys_readings_are_given_with_them():
    with pytest.raises(thiessen.Error, match="missing is about readings in a file that is given with it"):
        thiessen.Study(*TEXTBOOK, metric="planar").rain(missing=-5)
    with pytest.raises(thiessen.Error, match="give rainfall, or leave it out"):
        thiessen.Study(*TEXTBOOK[:2], metric="planar", missing=-5)


def test_influence_takes_no_keyword_that_cannot_act_on_it():
    study = thiessen.Study(*TEXTBOOK, metric="planar")
    for name, value in (("gaps", "strict"), ("min_gauges", 5), ("method", "idw"), ("every", "month"), ("error", True)):
        with pytest.raises(TypeError, match=f"influence has no keyword '{name}'; it is one of rain"):
            study.influence(**{name: value})
    of_rain = thiessen.Study(*TEXTBOOK, metric="planar", gaps="strict", cache=1)
    assert of_rain.influence().equals(study.influence())  # gaps are of rain


def test_a_keyword_of_another_call_says_of_which():
    with pytest.raises(TypeError, match="Study has no keyword 'without'; it is one of weights"):
        thiessen.Study(*TEXTBOOK, metric="planar", without="1")
    with pytest.raises(TypeError, match="rain has no keyword 'mend'; it is one of Study"):
        thiessen.Study(*TEXTBOOK, metric="planar").rain(mend=True)
    with pytest.raises(TypeError, match="no keyword 'STATIONS'"):
        thiessen.Study(*TEXTBOOK, STATIONS="other.csv")


def test_a_keyword_is_wrong_before_what_is_in_memory_lacks_a_crs():
    with pytest.raises(TypeError, match="metrik"):
        thiessen.Study(GAUGES, {"A": POLYGON}, metrik="planar")


def test_forms_of_values():
    study = thiessen.Study(*TEXTBOOK, metric="planar", mend=numpy.bool_(True))
    assert list(study.rain(method=["thiessen", "idw"]).columns) == list(study.rain(method="thiessen,idw").columns)
    with pytest.raises(thiessen.Error, match="grid is about method idw"):
        study.rain(grid=500)
    assert thiessen.Study({"a": (15, 50), "b": (15, 51)}, crs=4326).metric == "geodesic"
    assert thiessen.Study({"a": (15, 50), "b": (15, 51)}, crs=numpy.int64(4326)).metric == "geodesic"
    with pytest.raises(TypeError, match="a CRS is a float"):
        thiessen.Study({"a": (15, 50)}, crs=1.5)


def test_quiet_tells_no_warnings(recwarn):
    study = thiessen.Study({"a": (0, 0), "b": (0, 0), "c": (1, 1)}, metric="planar", quiet=True)
    assert not recwarn.list
    assert study.warnings


def test_a_study_cannot_be_pickled():
    with pytest.raises(TypeError, match="a Study cannot be pickled"):
        pickle.dumps(thiessen.Study(*TEXTBOOK, metric="planar"))


def frame_of_colorado():
    return pandas.read_csv(COLORADO[2], index_col=0)


INDEXES = {"texts": lambda times: times,
           "timestamps": pandas.to_datetime,
           "months": lambda times: pandas.PeriodIndex(times, freq="M")}


@pytest.mark.parametrize("form", INDEXES)
def test_times_of_a_frame_count_as_those_of_a_file(form):
    frame = frame_of_colorado()
    frame.index = INDEXES[form](frame.index)
    study = thiessen.Study(*COLORADO[:2], frame)
    from_file = thiessen.Study(*COLORADO)
    for given in ({"from_": "1991", "to": "1992-06"}, {"to": "1980"}):
        one, other = from_file.rain(**given), study.rain(**given)
        assert len(one) == len(other) == len(rows("rain", *COLORADO, *options(given))[1])
        assert [str(time)[:7] for time in one["time"]] == [str(time)[:7] for time in other["time"]]
        assert one.iloc[:, 1:].equals(other.iloc[:, 1:])
        with_study = thiessen.Study(*COLORADO[:2], frame, **given)
        assert with_study.rain().equals(other)
        if len(one):
            assert study.influence(**given).equals(from_file.influence(**given))


def options(given):
    return [word for name, value in given.items() for word in ("--" + name.strip("_").replace("_", "-"), value)]


@pytest.mark.parametrize("given", [{"every": "year"}, {"every": "year", "allow_missing": 2, "from_": "1990-03"}])
def test_totals_are_the_programs(given):
    header, found = rows("rain", *COLORADO, *options({name: str(value) for name, value in given.items()}))
    frame = frame_of_colorado()
    frame.index = pandas.to_datetime(frame.index)
    for study in (thiessen.Study(*COLORADO), thiessen.Study(*COLORADO[:2], frame)):
        table = study.rain(**given)
        assert list(table.columns) == header
        assert table["time"].tolist() == [row[0] for row in found]
        for column, name in enumerate(header[1:], 1):
            texts = [str(value) if name.endswith("_missing") else "" if numpy.isnan(value) else f"{value:.3f}"
                     for value in table[name]]
            assert texts == [row[column] for row in found], name


def test_what_times_are_of_their_steps():
    study = thiessen.Study([(0, 0), (1, 0)], {"A": POLYGON}, metric="planar")
    days = pandas.DataFrame({"1": [1.0, 2.0], "2": [1.0, 2.0]}, index=pandas.to_datetime(["2020-02-01", "2020-02-02"]))
    assert study.rain(days, every="month")["A"].tolist() != study.rain(days, every="month", stamp="end")["A"].tolist()
    ended = study.rain(days, every="month", stamp="end", allow_missing=40)
    assert ended["time"].tolist() == ["2020-01", "2020-02"]
    assert ended["A"].tolist() == [1.0, 2.0]  # midnight ends the last day of January
    assert study.rain(days, every="month", allow_missing=40)["A"].tolist() == [3.0]


def test_totals_want_each_time_once():
    study = thiessen.Study([(0, 0), (1, 0)], {"A": POLYGON}, metric="planar")
    twice = pandas.DataFrame({"1": [1.0, 2.0], "2": [1.0, 2.0]}, index=["2020-01-01", "2020-01-01"])
    with pytest.raises(thiessen.Error, match="the time '2020-01-01' is there twice"):
        study.rain(twice, every="month")
    with pytest.raises(thiessen.Error, match="time '0' is not written as ISO 8601 wants it"):
        study.rain(twice.reset_index(drop=True), from_="2020")


def test_weights_of_a_changed_network_are_the_programs():
    closed = rows("weights", *COLORADO[:2])[1][0][1]
    header, found = rows("weights", *COLORADO[:2], "--without", closed, "--with=-104.5,39.7", "--with=-105.5,39.1")
    table = thiessen.Study(*COLORADO[:2]).weights(without=closed, with_=[(-104.5, 39.7), (-105.5, 39.1)])
    assert list(table.columns) == header
    assert table["basin"].tolist() == [row[0] for row in found]
    assert table["station"].tolist() == [row[1] for row in found]
    for column, name in enumerate(header[2:], 2):
        assert table[name].tolist() == [float(row[column]) for row in found]


def test_weights_of_a_changed_network_in_memory():
    # The square from -1 to 1 is parted at x = 0; without b it is all a's, and with a gauge in b's place again half.
    square = {"A": "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))"}
    study = thiessen.Study({"a": (-0.5, 0), "b": (0.5, 0), "never": (0.1, 0)}, square, [[1, 2, numpy.nan]],
                           metric="planar")
    assert study.never_reporting == ["never"]
    table = study.weights(without=["b"])
    assert table["weight"].tolist() == [0.5, 0.5]
    assert table["weight_after"].tolist() == [1, 0]
    table = study.weights(without="b", with_=(0.5, 0))
    assert table["station"].tolist() == ["a", "b", "with 1"]
    assert table["area"].tolist() == [2, 2, 0]
    assert table["area_after"].tolist() == [2, 0, 2]
    assert study.weights()["weight"].tolist() == [0.5, 0.5]
    with pytest.raises(thiessen.Error, match="without names station 'c', which is not there"):
        study.weights(without="c")
    with pytest.raises(thiessen.Error, match="without closes every gauge that reports"):
        study.weights(without=["a", "b"])
    with pytest.raises(thiessen.Error, match="with_ are about the weights of basins, and there are none"):
        thiessen.Study({"a": (0, 0), "b": (1, 1)}, metric="planar").weights(without="a")


def test_a_basin_called_time_is_refused():
    study = thiessen.Study(GAUGES, {"time": POLYGON}, metric="planar")
    with pytest.raises(thiessen.Error, match="basin 'time' would be called as that of times\nhint: basin_id takes"):
        study.rain(READINGS)
    assert list(study.rain(READINGS, method="thiessen,idw").columns) == ["time", "time_thiessen", "time_idw"]
    both = thiessen.Study(GAUGES, {"A": POLYGON, "A_se": POLYGON}, metric="planar")
    with pytest.raises(thiessen.Error, match="'A_se' would both have a column of the latter name\nhint: basin_id takes"):
        both.standard_errors(READINGS)
    assert "long" not in "".join(str(text) for text in both.warnings)
