"""Stations and basins in memory, in whatever form they are there."""

import numpy

from . import _thiessen

GEOGRAPHIC = "EPSG:4326"
KINDS = ("FeatureCollection", "Feature", "GeometryCollection", "Point", "MultiPoint", "LineString", "MultiLineString",
         "Polygon", "MultiPolygon")


def _interface(value):
    """The GeoJSON that a value is or tells of itself; None where it does neither."""
    if isinstance(value, dict):
        return value if value.get("type") in KINDS else None
    return getattr(value, "__geo_interface__", None)


def _crs_text(crs):
    if crs is None:
        return ""
    return crs if isinstance(crs, str) else crs.to_wkt()


def _id_text(value):
    """An id as text: 7 for 7.0, which is what a column of whole numbers with gaps makes of 7."""
    if isinstance(value, (float, numpy.floating)) and float(value).is_integer():
        return str(int(value))
    return str(value)


class Places:
    """Stations or basins with ids, the CRS of their coordinates, and whether that is GeoJSON's own."""

    def __init__(self, ids, places, crs, implied=False):
        self.ids = [_id_text(one) for one in ids]
        self.places = places
        self.crs = crs
        self.implied = implied

    def require_crs(self, keywords, others):
        """Raises Error where nothing says whether coordinates are degrees or those of a plane."""
        known = self.crs or keywords.get("metric") or keywords.get("plane") or (others is not None and others.crs)
        if not known:
            raise _thiessen.Error(
                "nothing says what the coordinates are\n"
                'hint: crs="EPSG:4326" for longitude and latitude, another CRS, or metric="planar" for a plane')


class HeldStations(Places):
    def made(self):
        return _thiessen.Stations(self.ids, self.places, self.crs, self.implied)


class HeldBasins(Places):
    def made(self):
        return _thiessen.Basins(self.ids, self.places, self.crs, self.implied)


def _features(collection):
    if collection["type"] == "FeatureCollection":
        return list(collection["features"])
    return [collection if collection["type"] == "Feature" else {"type": "Feature", "geometry": collection}]


def _own_crs(value, crs, geojson):
    """The CRS as text, and whether it is only implied: what is said comes first, then the value's own, then RFC 7946."""
    if crs is not None:
        return _crs_text(crs), False
    own = getattr(value, "crs", None)
    if own is not None and not isinstance(own, dict):
        return _crs_text(own), False
    if geojson:
        return GEOGRAPHIC, True
    return "", False


def _property_ids(features, named):
    """The ids of features: of the property that is named, else of one with a usual name, else GeoJSON's own ids."""
    properties = [feature.get("properties") or {} for feature in features]
    names = list(properties[0]) if properties else []
    if named is not None:
        if any(named not in one for one in properties):
            raise _thiessen.Error(f"there is no field {named!r}; found {', '.join(map(repr, names)) or 'none'}")
        return [one[named] for one in properties]
    known = _thiessen.known_columns([str(name) for name in names])[0]
    if known is not None and all(names[known] in one for one in properties):
        return [one[names[known]] for one in properties]
    if features and all(feature.get("id") is not None for feature in features):
        return [feature["id"] for feature in features]
    return range(1, len(features) + 1)


def _point(geometry, station):
    kind = geometry.get("type") if geometry else None
    if kind != "Point" or len(geometry["coordinates"]) < 2:
        what = "has no geometry" if kind is None else f"is a {kind}, and not a point" if kind != "Point" else \
            "has an empty geometry"
        raise _thiessen.Error(f"station {station!r} {what}")
    return geometry["coordinates"][:2]


def stations_of(stations, ids, crs, id_field, x_field, y_field):
    """Stations in memory: see Study."""
    geojson = _interface(stations)
    if geojson is not None:
        features = _features(geojson)
        if ids is None:
            ids = _property_ids(features, id_field)
        points = [_point(feature.get("geometry"), name) for feature, name in zip(features, ids)]
        text, implied = _own_crs(stations, crs, isinstance(stations, dict))
        return HeldStations(ids, _array(points), text, implied)
    if isinstance(stations, dict):
        return HeldStations(list(stations), _array(list(stations.values())), _crs_text(crs))
    if hasattr(stations, "columns") and hasattr(stations, "to_numpy"):
        return _stations_of_frame(stations, ids, crs, id_field, x_field, y_field)
    points = _array(stations)
    return HeldStations(range(1, len(points) + 1) if ids is None else ids, points, _crs_text(crs))


def _array(points):
    points = numpy.ascontiguousarray(points, dtype=numpy.float64)
    return points.reshape(0, 2) if points.size == 0 else points


def _stations_of_frame(frame, ids, crs, id_field, x_field, y_field):
    names = [str(name) for name in frame.columns]
    known_id, known_x, known_y, are_degrees = _thiessen.known_columns(names)

    def place_of(named, known, what):
        if named is not None:
            if named not in names:
                raise _thiessen.Error(f"there is no column {named!r}; found {', '.join(map(repr, names))}")
            return names.index(named)
        if known is None and what is not None:
            raise _thiessen.Error(f"no column is known for {what}; found {', '.join(map(repr, names))}\n"
                                  "hint: name them with x and y")
        return known

    x = place_of(x_field, known_x, "the longitude or easting")
    y = place_of(y_field, known_y, "the latitude or northing")
    if ids is None:
        column = place_of(id_field, known_id, None)
        ids = frame.index if column is None else frame.iloc[:, column]
    text, implied = _crs_text(crs), False
    if not text and are_degrees and x_field is None and y_field is None:
        text = GEOGRAPHIC
    points = numpy.column_stack([frame.iloc[:, x].to_numpy(dtype=float), frame.iloc[:, y].to_numpy(dtype=float)])
    return HeldStations(ids, _array(points), text, implied)


def _rings(coordinates):
    return [_array([point[:2] for point in ring]) for ring in coordinates]


def _polygons(shape, basin):
    """A shape as polygons, each a list of rings, and the CRS that stands with it."""
    if isinstance(shape, (bytes, bytearray, memoryview)):
        shape = bytes(shape).hex()
    if isinstance(shape, str):
        found = _thiessen.geometry_in(shape)
        if found is None:
            raise _thiessen.Error(f"basin {basin!r} is neither WKT nor WKB")
        kind, _, polygons, srid = found
        if not polygons:
            raise _thiessen.Error(f"basin {basin!r} is a {kind}, and not a polygon" if kind else
                                  f"basin {basin!r} has an empty geometry")
        return polygons, f"EPSG:{srid}" if srid else ""
    geometry = _interface(shape)
    if geometry is not None and geometry["type"] == "Feature":
        geometry = geometry.get("geometry")
    if geometry is None:
        raise _thiessen.Error(f"basin {basin!r} has no geometry")
    kind = geometry["type"]
    if kind == "Polygon":
        return [_rings(geometry["coordinates"])], ""
    if kind == "MultiPolygon":
        return [_rings(polygon) for polygon in geometry["coordinates"]], ""
    if kind == "GeometryCollection":
        return [polygon for part in geometry["geometries"] for polygon in _polygons(part, basin)[0]], ""
    raise _thiessen.Error(f"basin {basin!r} is a {kind}, and not a polygon")


def basins_of(basins, ids, crs, id_field):
    """Basins in memory: see Study. Shapes that share an id are one basin."""
    geojson = _interface(basins)
    is_geojson = isinstance(basins, dict) and geojson is not None and geojson["type"] in ("FeatureCollection",
                                                                                          "Feature")
    if geojson is not None:
        shapes = _features(geojson)
        if ids is None:
            ids = _basin_ids(shapes, id_field)
    elif isinstance(basins, dict):
        shapes, ids = list(basins.values()), list(basins)
    elif isinstance(basins, (bytes, bytearray, memoryview)):
        shapes = [basins]
    else:
        shapes = list(basins)
    ids = [_id_text(one) for one in (range(1, len(shapes) + 1) if ids is None else ids)]
    if len(ids) != len(shapes):
        raise _thiessen.Error(f"{len(shapes)} basins, and {len(ids)} basin_ids: one for each is needed")
    merged = {}
    srids = set()
    for name, shape in zip(ids, shapes):
        polygons, srid = _polygons(shape, name)
        srids.add(srid)
        merged.setdefault(name, []).extend(polygons)
    if len(srids) > 1:
        raise _thiessen.Error(f"the basins are of several CRSs: {', '.join(sorted(one or 'none' for one in srids))}")
    text, implied = _own_crs(basins, crs, is_geojson)
    if not text and srids and "" not in srids:
        text = srids.pop()
    return HeldBasins(list(merged), list(merged.values()), text, implied)


def _basin_ids(features, named):
    """The program's rule: the first of these names whose values are all there and all different, else numbers."""
    if named is not None:
        return _property_ids(features, named)
    properties = [feature.get("properties") or {} for feature in features]
    for known in ("basin", "basin_id", "id", "code", "name"):
        for name in properties[0] if properties else ():
            values = [one.get(name) for one in properties]
            if str(name).lower() == known and None not in values and len(set(values)) == len(values):
                return values
    return range(1, len(features) + 1)
