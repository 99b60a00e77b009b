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
    with pytest.raises(thiessen.Error, match='crs="EPSG:4326"'):
        thiessen.Study(GAUGES, {"A": POLYGON})


@pytest.mark.parametrize("stations, basins, words", [
    ({}, {"A": POLYGON}, "there are no stations"),
    ({"a": (0, float("nan"))}, {"A": POLYGON}, "coordinate that is not finite"),
    ([(0, 0), (1, 1)], {"A": {"type": "LineString", "coordinates": RING}}, "basin 'A' is a LineString"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon", "coordinates": []}}, "basin 'A' has an empty geometry"),
    ([(0, 0), (1, 1)], {"A": "POLYGON ((0 0"}, "neither WKT nor WKB"),
    ([(0, 0), (1, 1)], {"A": {"type": "Polygon", "coordinates": [[(0, 0), (2, 2), (2, 0), (0, 2)]]}}, "overlaps itself"),
    ([(0, 0), (1, 1)], {}, "there are no basins"),
])
def test_what_cannot_be_used_is_refused(stations, basins, words):
    with pytest.raises(thiessen.Error, match=words):
        thiessen.Study(stations, basins, metric="planar")
