"""Normals in Python are those of the program, in files and in memory."""

import json
import pathlib

import numpy
import pandas
import pytest

import thiessen
from conftest import rows, run

# The square from 0 to 8 by 0 to 4 is parted at x = 4. In January the basin has twice the gauges' normal.
BASIN = {"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 4], [0, 4], [0, 0]]]}
MONTHS = [f"normal_{month:02}" for month in range(1, 13)]
ASCII = """ncols 8
nrows 4
xllcorner 0
yllcorner 0
cellsize 1
""" + 4 * "1 2 2.5 2.5 5 5 8 6\n"


@pytest.fixture
def files(tmp_path):
    """Stations, basins and readings in files, and a raster."""
    gauges = pandas.DataFrame({"id": ["a", "b"], "x": [2, 6], "y": [2, 2], "normal": [40, 80]})
    for month in MONTHS:
        gauges["of_" + month] = 30
    basin = {"id": "B", "normal": 60, **{"of_" + month: 30 for month in MONTHS}, "of_normal_01": 60}
    gauges.to_csv(tmp_path / "stations.csv", index=False)
    features = [{"type": "Feature", "properties": basin, "geometry": BASIN}]
    collection = {"type": "FeatureCollection", "features": features}
    # One CRS for both, so that what is in memory and what is in files says the same.
    (tmp_path / "basins.geojson").write_text(json.dumps(collection), encoding="utf-8")
    readings = pandas.DataFrame({"time": ["2014-01-31T00:00", "2014-02-01T00:00"], "a": [10, 10], "b": [13, 13]})
    readings.to_csv(tmp_path / "rain.csv", index=False)
    (tmp_path / "normals.asc").write_text(ASCII, encoding="utf-8")
    return tmp_path


def studies(files, **keywords):
    """The study of files, and the same in memory."""
    given = [files / name for name in ("stations.csv", "basins.geojson", "rain.csv")]
    frame = pandas.read_csv(given[2], index_col=0)
    frame.index = pandas.to_datetime(frame.index)
    basins = json.loads(given[1].read_text(encoding="utf-8"))
    yield thiessen.Study(*given, metric="planar", **keywords)
    yield thiessen.Study(pandas.read_csv(given[0]), basins, frame, metric="planar", **keywords)


def command(name, files, *options):
    given = [files / file for file in ("stations.csv", "basins.geojson", "rain.csv")]
    return [name, *given[:2 if name == "weights" else 3], "--metric", "planar", *options]


def test_fields_are_those_of_the_program(files):
    for study in studies(files, normal_field="normal"):
        table = study.weights()
        assert list(table.columns) == rows(*command("weights", files, "--normal-field", "normal"))[0]
        assert table["factor"].tolist() == [1.5, 0.75]
        assert study.rain()["B"].tolist() == [12.375, 12.375]  # 0.5 x 1.5 x 10 + 0.5 x 0.75 x 13
        changed = study.weights(without="b")
        assert list(changed.columns)[-2:] == ["factor", "factor_after"]
        assert changed["factor_after"].tolist()[0] == 1.5
        assert numpy.isnan(changed["factor_after"].tolist()[1])
        assert [cell["properties"]["factor"] for cell in study.cells()["features"]] == [1.5, 0.75]


def test_fields_of_months_go_by_the_times_of_steps(files):
    for study in studies(files, normal_field="of_normal"):
        table = study.weights()
        assert list(table.columns) == rows(*command("weights", files, "--normal-field", "of_normal"))[0]
        assert table["factor_01"].tolist() == [2, 2]
        assert table["factor_12"].tolist() == [1, 1]
        assert study.rain()["B"].tolist() == [23, 11.5]
        assert study.rain(stamp="end")["B"].tolist() == [23, 23]
        assert study.rain(from_="2014-02")["B"].tolist() == [11.5]
        assert study.influence()["mean_change"].tolist() == [2.25, -2.25]
        assert study.influence(stamp="end")["mean_change"].tolist() == [3, -3]
        changed = study.weights(without="b")
        assert list(changed.columns)[6:8] == ["factor_01", "factor_01_after"]
        time = "2014-01-31T00:00"
        assert [cell["properties"]["factor"] for cell in study.cells(time=time)["features"]] == [2, 2]
    for study in studies(files, normal_field="of_normal", stamp="end"):
        assert study.rain()["B"].tolist() == [23, 23]
        assert study.influence()["mean_change"].tolist() == [3, -3]


def test_a_raster_is_that_of_the_program(files):
    header, found = rows(*command("weights", files, "--normals", files / "normals.asc"))
    for study in studies(files, normals=files / "normals.asc"):
        table = study.weights()
        assert list(table.columns) == header
        assert table["factor"].tolist() == [float(row[4]) for row in found] == [0.8, 0.75]
        assert study.rain(gaps="renormalise")["B"].tolist() == [8.875, 8.875]
        assert list(study.rain(method=["thiessen", "arithmetic"]).columns) == ["time", "B_thiessen", "B_arithmetic"]
    assert "factor" in run(*command("cells", files, "--normals", files / "normals.asc"))


def test_what_cannot_be_is_an_error(files):
    for study in studies(files):
        with pytest.raises(thiessen.Error, match="^stamp is about normals of months and totals beside rainfall"):
            study.influence(stamp="end")
        with pytest.raises(thiessen.Error, match="^stamp decides in which total a step counts"):
            study.rain(stamp="end")
    gauges = {"a": (2, 2), "b": (6, 2)}
    with pytest.raises(thiessen.Error, match="normal_field is about fields, and these stations have none"):
        thiessen.Study(gauges, {"B": BASIN}, metric="planar", normal_field="normal")
    frame = pandas.read_csv(files / "stations.csv")
    with pytest.raises(thiessen.Error, match="normal_field is about fields, and these basins have none"):
        thiessen.Study(frame, {"B": BASIN}, metric="planar", normal_field="normal")
    with pytest.raises(thiessen.Error, match="normal_field: there is no field 'zz', and none of 'zz_01' to 'zz_12'"):
        thiessen.Study(frame, files / "basins.geojson", metric="planar", normal_field="zz")
    frame.loc[1, "normal"] = numpy.nan
    with pytest.raises(thiessen.Error, match="station 'b' has no normal in 'normal'"):
        thiessen.Study(frame, files / "basins.geojson", metric="planar", normal_field="normal")
    with pytest.raises(thiessen.Error, match="normals and normal_field both say where normals are"):
        thiessen.Study(frame, files / "basins.geojson", metric="planar", normal_field="normal", normals="n.tif")
    two = [{"type": "Feature", "properties": {"id": "B", "normal": normal}, "geometry": BASIN} for normal in (1, 2)]
    with pytest.raises(thiessen.Error, match="basin 'B' has other normals in another of its features"):
        thiessen.Study(frame, two, metric="planar", normal_field="normal", basin_id="id")


def test_readings_without_times_have_no_months(files):
    given = [files / name for name in ("stations.csv", "basins.geojson")]
    study = thiessen.Study(*given, metric="planar", normal_field="of_normal")
    for call in (study.rain, study.influence):
        with pytest.raises(thiessen.Error, match="the readings have no times, and normals are of calendar months"):
            call(numpy.array([[10.0, 13]]))
    years = pandas.DataFrame({"a": [10.0], "b": [13.0]}, index=["2014"])
    with pytest.raises(thiessen.Error, match="time '2014' tells no calendar month"):
        study.rain(years)
    with pytest.raises(thiessen.Error, match="time '2014' tells no calendar month"):
        thiessen.Study(*given, years, metric="planar", normal_field="of_normal").cells(time="2014")
    twice = pandas.DataFrame({"a": [10.0, 10], "b": [13.0, 13]}, index=["2014-01", "2014-01"])
    assert study.rain(twice)["B"].tolist() == [23, 23]


def test_normals_are_fitted_to_readings_in_files_by_elevation():
    colorado = pathlib.Path(__file__).parents[2] / "samples" / "colorado"
    places = colorado / "stations.csv", colorado / "counties.geojson"
    options = {"basin_id": "name", "rainfall": colorado / "rainfall.csv"}
    raster = {"elevation_field": "elev"}
    with pytest.raises(thiessen.Error, match="elevation_field: there is no field 'elev'"):
        thiessen.Study(*places, **options, **raster)  # counties have no elevation
    with pytest.raises(thiessen.Error, match="^elevation fits normals to rainfall, and there is none"):
        thiessen.Study(*places, basin_id="name", elevation="dem.tif")
    with pytest.raises(thiessen.Error, match="^elevation_field is of stations in a file, and these are in memory"):
        thiessen.Study({"a": (15, 50)}, places[1], rainfall, crs=4326, elevation_field="z")


def test_normals_are_fitted_to_readings_in_files_by_elevation(tmp_path):
    samples = pathlib.Path(__file__).parents[2] / "samples" / "colorado"
    counties = json.loads((samples / "counties.geojson").read_text(encoding="utf-8"))
    counties["features"] = counties["features"][:3]
    for feature in counties["features"]:
        feature["properties"]["elev"] = 2200
    (tmp_path / "counties.geojson").write_text(json.dumps(counties), encoding="utf-8")
    places = samples / "stations.csv", tmp_path / "counties.geojson"
    rainfall = samples / "rainfall.csv"
    study = thiessen.Study(*places, rainfall, basin_id="name", elevation_field="elev")
    assert "factor_12" in study.weights().columns
    header, found = rows("rain", *places, rainfall, "--basin-id", "name", "--elevation-field", "elev", "--decimals", "12")
    table = study.rain()
    assert list(table.columns) == header
    assert numpy.allclose(table.iloc[:, 1:], [[float(value) for value in row[1:]] for row in found], rtol=0, atol=1e-11)
    assert (study.rain(error=True)[header[1] + "_se"] > 0).all()
    with pytest.raises(thiessen.Error, match="^elevation_field fits normals to rainfall, and there is none"):
        thiessen.Study(*places, basin_id="name", elevation_field="elev")
    with pytest.raises(thiessen.Error, match="^elevation_field is of stations in a file, and these are in memory"):
        thiessen.Study({"a": (15, 50)}, places[1], rainfall, crs=4326, elevation_field="z")
