"""Stations and basins in every form that they may have in memory are those of a file."""

import json
import struct

import numpy
import pandas
import pytest

import thiessen
from conftest import COLORADO, TEXTBOOK

shapely = pytest.importorskip("shapely.geometry")

# Chow, Maidment and Mays, Applied Hydrology (1988), problem 3.4.5, as in samples/textbook.
GAUGES = {"1": (7, 4), "2": (3, 4), "3": (-2, 5), "4": (-10, 1), "5": (-3, -3), "6": (-7, -7), "7": (2, -3),
          "8": (2, -10), "9": (0, 0)}
RING = [(5, 5), (-5, 5), (-5, -5), (0, -10), (5, -5)]
STORM = [62, 59, 41, 39, 105, 98, 60, 41, 81]
POLYGON = {"type": "Polygon", "coordinates": [[*RING, RING[0]]]}


def rainfall(study):
    return study.rain(numpy.array(STORM, float)).iloc[0, 1]


def wkb():
    closed = [*RING, RING[0]]
    return struct.pack("<BIII", 1, 3, 1, len(closed)) + b"".join(struct.pack("<dd", *point) for point in closed)


BASINS = {
    "dictionary": {"A": POLYGON},
    "collection": {"type": "FeatureCollection",
                   "features": [{"type": "Feature", "properties": {"basin": "A"}, "geometry": POLYGON}]},
    "shapely": [shapely.Polygon(RING)],
    "two parts of one basin": {"A": shapely.MultiPolygon([
        shapely.Polygon([(5, 5), (-5, 5), (-5, 0), (5, 0)]), shapely.Polygon([(5, 0), (-5, 0), (-5, -5), (0, -10), (5, -5)])])},
    "wkb": {"A": wkb()},
    "wkt": {"A": "POLYGON ((5 5, -5 5, -5 -5, 0 -10, 5 -5, 5 5))"},
    "open ring": {"A": {"type": "Polygon", "coordinates": [RING]}},
    "clockwise": {"A": {"type": "Polygon", "coordinates": [RING[::-1]]}},
}


@pytest.mark.parametrize("form", BASINS)
def test_basins_in_memory(form):
    study = thiessen.Study(GAUGES, BASINS[form], metric="planar")
    assert study.basins == ["1" if form == "shapely" else "A"]
    assert rainfall(study) == pytest.approx(69.8364, abs=5e-5)  # the textbook's answer
    weights = study.weights()
    assert weights["weight"].sum() == pytest.approx(1, abs=1e-12)
    assert weights["area"].sum() == pytest.approx(125, abs=1e-9)


STATIONS = {
    "dictionary": (GAUGES, {}),
    "array": (numpy.array(list(GAUGES.values())), {"ids": list(GAUGES)}),
    "array without ids": (list(GAUGES.values()), {}),
    "frame": (pandas.DataFrame([(int(i), x, y) for i, (x, y) in GAUGES.items()], columns=["station", "x", "y"]), {}),
    "frame with an index": (pandas.DataFrame(list(GAUGES.values()), columns=["east", "north"], index=list(GAUGES)),
                            {"x": "east", "y": "north"}),
    "points": ({"type": "FeatureCollection",
                "features": [{"type": "Feature", "properties": {"name": i}, "geometry": {"type": "Point", "coordinates": p}}
                             for i, p in GAUGES.items()]}, {}),
    "list of shapely": ([shapely.Point(p) for p in GAUGES.values()], {}),
    "series of shapely": (pandas.Series({i: shapely.Point(p) for i, p in GAUGES.items()}), {}),
    "list of WKT": ([f"POINT ({x} {y})" for x, y in GAUGES.values()], {}),
    "dictionary of WKT": ({i: f"POINT ({x} {y})" for i, (x, y) in GAUGES.items()}, {}),
    "list of WKB": ([struct.pack("<BIdd", 1, 1, *p) for p in GAUGES.values()], {"ids": list(GAUGES)}),
    "list of GeoJSON": ([{"type": "Point", "coordinates": p} for p in GAUGES.values()], {}),
    "dictionary of features": ({i: {"type": "Feature", "geometry": {"type": "Point", "coordinates": p}}
                                for i, p in GAUGES.items()}, {}),
    "file": (TEXTBOOK[0], {}),
}


@pytest.mark.parametrize("form", STATIONS)
def test_stations_in_memory(form):
    stations, keywords = STATIONS[form]
    study = thiessen.Study(stations, {"A": POLYGON}, metric="planar", **keywords)
    assert study.stations == list(GAUGES)
    assert rainfall(study) == pytest.approx(69.8364, abs=5e-5)


def test_counties_in_memory_are_those_of_the_file():
    stations = pandas.read_csv(COLORADO[0], dtype={"id": str})
    with open(COLORADO[1], encoding="utf-8") as file:
        counties = json.load(file)
    from_files = thiessen.Study(*COLORADO[:2])
    in_memory = thiessen.Study(stations, counties)
    assert in_memory.metric == from_files.metric == "geodesic"
    assert in_memory.basins == from_files.basins
    one, other = from_files.weights(), in_memory.weights()
    assert one["station"].tolist() == other["station"].tolist()
    assert one["weight"].tolist() == other["weight"].tolist()


class Projected:
    """What a GeoDataFrame is to us: shapes, and a CRS beside them."""

    def __init__(self, features, crs):
        self.__geo_interface__ = {"type": "FeatureCollection", "features": features}
        self.crs = crs


def test_the_crs_of_a_frame_counts():
    # A square of 10 km beside the central meridian of UTM 33N, and two gauges that part it in the middle.
    square = [(500e3, 5e6), (510e3, 5e6), (510e3, 5.01e6), (500e3, 5.01e6), (500e3, 5e6)]
    frame = Projected([{"type": "Feature", "properties": {"id": "B"},
                        "geometry": {"type": "Polygon", "coordinates": [square]}}], "EPSG:32633")
    study = thiessen.Study({"a": (502.5e3, 5.005e6), "b": (507.5e3, 5.005e6)}, frame, crs="EPSG:32633")
    assert study.metric == "geodesic"
    table = study.weights()
    # The scale on the central meridian is 0.9996: 100 km2 of the plane are 100 / 0.9996^2 of the Earth.
    assert table["area_km2"].sum() == pytest.approx(100 / 0.9996**2, rel=1e-5)
    assert table["weight"].tolist() == pytest.approx([0.5, 0.5], abs=1e-5)


def test_coordinates_of_nothing_known_are_asked_for():
    with pytest.raises(thiessen.Error, match="hint: crs='EPSG:4326' for longitude"):
        thiessen.Study(GAUGES, {"A": POLYGON})


@pytest.mark.parametrize("stations, basins, words", [
    ({}, {"A": POLYGON}, "there are no stations"),
    ({"a": (0, float("nan"))}, {"A": POLYGON}, "coordinate that is not finite"),
    ([(0, 0), (1, 1)], {"A": {"type": "LineString", "coordinates": RING}}, "basin 'A' is a LineString"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon", "coordinates": []}}, "basin 'A' has an empty geometry"),
    ([(0, 0), (1, 1)], {"A": "POLYGON ((0 0"}, "neither WKT nor WKB"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon", "coordinates": [[(0, 0), (2, 2), (2, 0), (0, 2)]]}}, "overlaps itself"),
    ([(0, 0), (1, 1)], {}, "there are no basins"),
    ([(0, 0), (1, 1)], {"A": "POLYGON EMPTY"}, "basin 'A' has an empty geometry"),
    ([(0, 0), (1, 1)], {"A": "POINT (1 2)"}, "basin 'A' is a Point, and not a polygon"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon"}}, "basin 'A' has no coordinates"),
    ([(0, 0), (1, 1)], [numpy.array(RING)], "basin '1' is no geometry but 'ndarray'\nhint: GeoJSON"),
    ([(0, 0), (1, 1)], {"type": "Polygoon", "coordinates": []}, "GeoJSON of a type that is not known: 'Polygoon'"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon", "coordinates": [[1, 2], [3, 4]]}}, "coordinates that are no rings"),
    ([(0, 0), (1, 1)], 5, "the basins are a 'int'"),
    (None, {"A": POLYGON}, "the stations are a 'NoneType'"),
    ([(0, 0), (1, 1)], pandas.DataFrame({"basin": ["A"]}), "a frame without geometries"),
    ({"a": (0, 0), None: (1, 1)}, {"A": POLYGON}, "a station has no id"),
    (pandas.DataFrame({"id": ["a", None], "x": [0, 1], "y": [0, 1]}), {"A": POLYGON}, "a station has no id"),
    (pandas.DataFrame({"id": [1, float("nan")], "x": [0, 1], "y": [0, 1]}), {"A": POLYGON}, "a station has no id"),
    ([(0, 0), (1, 1)], {None: POLYGON}, "basin 1 has no id"),
    (["POINT (0 0)", "POINT (1 1"], {"A": POLYGON}, "station '2' is neither WKT nor WKB"),
    (["POINT (0 0)", "POINT EMPTY"], {"A": POLYGON}, "station '2' has an empty geometry"),
    (["POINT (0 0)", "LINESTRING (0 0, 1 1)"], {"A": POLYGON}, "station '2' is a LineString, and not a point"),
    ([shapely.Point(0, 0), (1, 1)], {"A": POLYGON}, "station '2' is no geometry but 'tuple'"),
    ({"a": {"lon": 1, "lat": 2}}, {"A": POLYGON}, "station 'a' is no geometry but 'dict'"),
    ([(0, 0, 0), (1, 1, 1)], {"A": POLYGON}, "the coordinates of the stations are not two for each"),
    (numpy.array([[1j, 0], [0, 1]]), {"A": POLYGON}, "the coordinates of the stations are no numbers: they are complex"),
    (["SRID=4326;POINT (0 0)", "SRID=32633;POINT (1 1)"], {"A": POLYGON}, "the stations are of several CRSs"),
])
def test_what_cannot_be_used_is_refused(stations, basins, words):
    with pytest.raises(thiessen.Error, match=words):
        thiessen.Study(stations, basins, metric="planar")


def test_ids_that_nothing_lacks_are_refused():
    with pytest.raises(thiessen.Error, match="the stations have ids"):
        thiessen.Study(GAUGES, {"A": POLYGON}, ids=list(GAUGES), metric="planar")
    with pytest.raises(thiessen.Error, match="the basins have ids"):
        thiessen.Study(GAUGES, {"A": POLYGON}, basin_ids=["A"], metric="planar")
    with pytest.raises(thiessen.Error, match="basin_id is about basins in a file, and these are in memory"):
        thiessen.Study(GAUGES, {"A": POLYGON}, basin_id="zz", metric="planar")
    frame = pandas.DataFrame([(1, 2)], columns=["x", "y"])
    with pytest.raises(thiessen.Error, match="id is about stations in a file"):
        thiessen.Study(frame, {"A": POLYGON}, ids=["a"], id="zz", metric="planar")


# A square of 10 km beside the central meridian of UTM 33N, and two gauges that part it in the middle.
UTM_SQUARE = {"type": "Polygon", "coordinates": [[(500e3, 5e6), (510e3, 5e6), (510e3, 5.01e6), (500e3, 5.01e6),
                                                  (500e3, 5e6)]]}
UTM_GAUGES = {"a": (502.5e3, 5.005e6), "b": (507.5e3, 5.005e6)}
UTM = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32633"}}


def utm_forms():
    feature = {"type": "Feature", "properties": {"id": "B"}, "geometry": UTM_SQUARE}
    yield {"type": "FeatureCollection", "crs": UTM, "features": [feature]}
    yield {**feature, "crs": UTM}
    yield [feature | {"geometry": {**UTM_SQUARE, "crs": UTM}}]
    yield {"B": {**UTM_SQUARE, "crs": UTM}}
    yield {"B": "SRID=32633;" + shapely.shape(UTM_SQUARE).wkt}
    yield Projected([feature], "EPSG:32633")


@pytest.mark.parametrize("basins", utm_forms())
def test_a_crs_that_stands_with_shapes_counts_and_is_not_overruled(basins):
    study = thiessen.Study(UTM_GAUGES, basins, crs="EPSG:32633")
    assert study.metric == "geodesic"
    # The scale on the central meridian is 0.9996: 100 km2 of the plane are 100 / 0.9996^2 of the Earth.
    assert study.weights()["area_km2"].sum() == pytest.approx(100 / 0.9996**2, rel=1e-5)
    assert thiessen.Study(UTM_GAUGES, basins, crs=32633, basins_crs=32633).metric == "geodesic"
    with pytest.raises(thiessen.Error, match="basins: their CRS is EPSG:32633, and not EPSG:32634 as basins_crs says"):
        thiessen.Study(UTM_GAUGES, basins, crs="EPSG:32633", basins_crs="EPSG:32634")


def test_a_crs_that_stands_with_stations_counts_and_is_not_overruled():
    gauges = {"type": "FeatureCollection", "crs": UTM, "features": [
        {"type": "Feature", "properties": {"id": i}, "geometry": {"type": "Point", "coordinates": p}}
        for i, p in UTM_GAUGES.items()]}
    with pytest.warns(thiessen.ThiessenWarning, match="^basins: names no CRS; that of stations, EPSG:32633, is taken"):
        study = thiessen.Study(gauges, {"B": UTM_SQUARE})
    assert study.weights()["weight"].tolist() == pytest.approx([0.5, 0.5], abs=1e-5)
    with pytest.raises(thiessen.Error, match="stations: their CRS is EPSG:32633, and not EPSG:32634 as crs says"):
        thiessen.Study(gauges, {"B": UTM_SQUARE}, crs="EPSG:32634")
    with pytest.raises(thiessen.Error, match="a member crs of GeoJSON names no CRS"):
        thiessen.Study({**gauges, "crs": {"type": "link", "properties": {"href": "x"}}}, {"B": UTM_SQUARE})


def test_features_are_in_longitude_and_latitude_and_bare_geometries_say_nothing():
    feature = {"type": "Feature", "properties": {}, "geometry": POLYGON}
    for basins in (feature, [feature], {"A": feature}, {"type": "FeatureCollection", "features": [feature]}):
        assert thiessen.Study(GAUGES, basins).metric == "geodesic"
    for basins in (POLYGON, [POLYGON], {"A": POLYGON}):
        with pytest.raises(thiessen.Error, match="nothing says what the coordinates are"):
            thiessen.Study(GAUGES, basins)


class Framed(Projected):
    """The same with labels of its rows."""

    def __init__(self, features, labels):
        super().__init__(features, None)
        self.index = labels


def test_labels_of_a_frame_of_shapes_are_ids_where_no_column_is():
    features = [{"type": "Feature", "id": str(i), "properties": {"size": 3}, "geometry": POLYGON} for i in range(1)]
    assert thiessen.Study(GAUGES, Framed(features, pandas.Index(["north"])), metric="planar").basins == ["north"]
    assert thiessen.Study(GAUGES, Framed(features, pandas.RangeIndex(1)), metric="planar").basins == ["1"]
    features[0]["properties"]["name"] = "A"
    assert thiessen.Study(GAUGES, Framed(features, pandas.Index(["north"])), metric="planar").basins == ["A"]
    series = pandas.Series({"north": shapely.shape(POLYGON)})
    assert thiessen.Study(GAUGES, series, metric="planar").basins == ["north"]
