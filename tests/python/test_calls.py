"""How calls behave: keywords, errors, warnings, progress, threads, Ctrl-C, and memory."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy
import pandas
import pytest

import thiessen
from thiessen.readings import readings_of
from conftest import COLORADO, TEXTBOOK


def test_a_wrong_keyword_tells_the_nearest():
    with pytest.raises(TypeError, match="Study has no keyword 'basinid'; is basin_id meant"):
        thiessen.Study(*TEXTBOOK, basinid="x")


def test_a_wrong_value_is_told_in_pythons_words():
    with pytest.raises(thiessen.Error, match="^metric wants geodesic or planar, not 'round'"):
        thiessen.Study(*TEXTBOOK, metric="round")
    with pytest.raises(thiessen.Error, match="plane is planar, and metric says geodesic"):
        thiessen.Study(*TEXTBOOK, plane="EPSG:32633", metric="geodesic")


def test_keywords_of_a_series_may_stand_with_the_study():
    once = thiessen.Study(*COLORADO, gaps="strict", min_gauges=3).rain()
    assert once.equals(thiessen.Study(*COLORADO).rain(gaps="strict", min_gauges=3))
    assert not once.equals(thiessen.Study(*COLORADO).rain())


def test_how_many_points_are_looked_at_may_stand_with_the_study():
    once = thiessen.Study(*COLORADO, method="idw", grid=50).rain()
    assert once.equals(thiessen.Study(*COLORADO).rain(method="idw", grid=50))
    assert not once.equals(thiessen.Study(*COLORADO, method="idw").rain())


def test_a_file_that_is_not_there():
    with pytest.raises(thiessen.Error, match="nowhere.csv"):
        thiessen.Study("nowhere.csv")


def test_an_error_is_a_value_error():
    assert issubclass(thiessen.Error, ValueError)


def test_warnings_are_given():
    with pytest.warns(thiessen.ThiessenWarning, match="stand at one place"):
        study = thiessen.Study({"a": (0, 0), "b": (0, 0), "c": (1, 1)}, metric="planar")
    assert any("one place" in text for text in study.warnings)


def test_readings_that_no_gauge_has():
    study = thiessen.Study({"a": (0, 0), "b": (1, 1)}, metric="planar")
    with pytest.raises(thiessen.Error, match="station 'b' in row 1 is negative"):
        study.rain(numpy.array([[1.0, 2.0], [3.0, -4.0]]))
    with pytest.raises(thiessen.Error, match="not finite"):
        study.rain(numpy.array([[numpy.inf, 2.0]]))
    with pytest.raises(thiessen.Error, match="2 stations were given, and the readings have 3 columns"):
        study.rain(numpy.ones((4, 3)))
    with pytest.raises(thiessen.Error, match="there are no readings"):
        study.rain()


def test_a_frame_of_other_stations():
    study = thiessen.Study({"a": (0, 0), "b": (1, 1)}, metric="planar")
    frame = pandas.DataFrame({"a": [1.0], "c": [2.0]})
    with pytest.raises(thiessen.Error, match="'c'"):
        study.rain(frame)
    assert study.rain(frame, ignore_unknown=True).iloc[0, 1] == 1.0  # b is silent
    with pytest.raises(thiessen.Error, match="no column of the readings is a station"):
        study.rain(pandas.DataFrame({"x": [1.0]}))


def test_times_are_the_frames_index():
    study = thiessen.Study({"a": (0, 0), "b": (1, 1)}, metric="planar")
    days = pandas.date_range("2020-01-01", periods=3)
    table = study.rain(pandas.DataFrame({"a": [1, 2, 3], "b": [3, 2, None]}, index=days))
    assert list(table["time"]) == list(days)
    assert table.iloc[:, 1].tolist() == [2.0, 2.0, 3.0]


def test_stations_that_never_report_are_named():
    readings = numpy.array([[1.0, numpy.nan, 2.0], [3.0, numpy.nan, 4.0]])
    study = thiessen.Study([(0, 0), (1, 0), (2, 0)], {"A": {"type": "Polygon", "coordinates": [
        [(-1, -1), (3, -1), (3, 1), (-1, 1)]]}}, readings, metric="planar")
    assert study.never_reporting == ["2"]
    assert study.stations == ["1", "3"]
    assert study.rain()["A"].tolist() == [1.5, 3.5]
    assert study.rain(gaps="strict")["A"].tolist() == [1.5, 3.5]


def test_doubles_in_order_are_not_copied():
    readings = numpy.ones((5, 3))
    assert readings_of(readings, None).matrix is readings
    assert not numpy.shares_memory(readings_of(numpy.ones((5, 3), int), None).matrix, readings)


def many_readings():
    stations = 200
    generator = numpy.random.default_rng(1)
    places = generator.uniform(0, 100, (stations, 2))
    readings = generator.uniform(0, 10, (20_000, stations))
    readings[generator.uniform(size=readings.shape) < 0.05] = numpy.nan
    return thiessen.Study(places, metric="planar"), readings


def test_other_threads_run_meanwhile_and_progress_is_told():
    study, readings = many_readings()
    counted, told, done = [0], [], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    study.rain(readings, progress=lambda steps, all_steps: told.append((steps, all_steps)))
    done.set()
    counter.join()
    assert counted[0] > 5
    assert told[-1] == (len(readings), len(readings))
    assert told == sorted(told)


def test_what_progress_throws_ends_the_call():
    study, readings = many_readings()

    def stop(_steps, _all_steps):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        study.rain(readings, progress=stop)
    assert len(study.rain(readings[:3])) == 3  # and the study is as it was


INTERRUPTED = """
import signal
import sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a program in the background ignores it
sys.path.insert(0, sys.argv[1])
from test_calls import many_readings
study, readings = many_readings()
print("ready", flush=True)
try:
    while True:
        study.rain(readings)
except KeyboardInterrupt:
    print("interrupted", flush=True)
assert len(study.rain(readings[:3])) == 3
"""


def test_ctrl_c_is_heard():
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, os.path.dirname(__file__)], stdout=subprocess.PIPE,
                               text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    rest, _ = process.communicate(timeout=60)
    assert rest == "interrupted\n"
    assert process.returncode == 0


WITHOUT_PANDAS = """
import sys
sys.modules["pandas"] = None
import thiessen
study = thiessen.Study(*sys.argv[1:], metric="planar")
weights = study.weights()
assert weights.dtype.names == ("basin", "station", "area", "weight"), weights.dtype
assert abs(weights["weight"].sum() - 1) < 1e-12
rain = study.rain()
assert rain.dtype.names == ("time", "A"), rain.dtype
"""


def test_without_pandas_there_are_structured_arrays():
    subprocess.run([sys.executable, "-c", WITHOUT_PANDAS, *map(str, TEXTBOOK)], check=True)


def test_several_files_are_joined(tmp_path):
    lines = COLORADO[2].read_text(encoding="utf-8").splitlines()
    parts = []
    for i, part in enumerate((lines[1:60], lines[60:])):
        parts.append(tmp_path / f"{i}.csv")
        parts[-1].write_text("\n".join([lines[0], *part]) + "\n", encoding="utf-8")
    whole, joined = thiessen.Study(*COLORADO).rain(), thiessen.Study(*COLORADO[:2], parts).rain()
    assert whole.equals(joined)
    assert thiessen.Study(*COLORADO[:2]).rain(rainfall=parts).iloc[:, 1:].shape == whole.iloc[:, 1:].shape
