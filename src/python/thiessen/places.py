"""Stations and basins in memory, in whatever form they are there."""

import numpy

from . import _thiessen
from .forms import (column_numbers, id_text, interface, is_frame, is_missing, is_series, labels_of, named,
                    numbers)
from .keywords import crs_text

GEOGRAPHIC = "EPSG:4326"


class Places:
    """Stations or basins with ids, the CRS that they have of themselves, and where that is from: it stands with them
    (object), names of columns say it, or GeoJSON implies it."""

    def __init__(self, ids, places, crs=("", ""), normals=()):
        self.ids = [id_text(one) for one in ids]
        self.places = places
        self.crs, self.origin = crs
        self.normals = normals  # for each one or twelve; none where none are asked for

    def made(self):
        return self._made(self.ids, self.places, self.crs, self.origin, self.normals)


class HeldStations(Places):
    _made = _thiessen.Stations


class HeldBasins(Places):
    _made = _thiessen.Basins


def _features(collection):
    if collection["type"] == "FeatureCollection":
        return list(collection.get("features") or ())
    return [collection if collection["type"] == "Feature" else {"type": "Feature", "geometry": collection}]


def _member_crs(geojson):
    """The CRS that a member `crs` names, as GeoJSON had it before RFC 7946, and as many still write it."""
    member = geojson.get("crs") if isinstance(geojson, dict) else None
    if member is None:
        return None
    properties = member.get("properties") if isinstance(member, dict) else None
    name = properties.get("name") if isinstance(properties, dict) else None
    if not isinstance(name, str) or not name:
        raise _thiessen.Error("a member crs of GeoJSON names no CRS\n"
                              "hint: without that member, crs or basins_crs names one")
    return name


def _crs_in(shapes):
    """The CRSs that shapes of GeoJSON have of themselves, in their members."""
    found = set()
    for shape in shapes:
        geojson = interface(shape)
        for one in (geojson, geojson.get("geometry") if geojson else None):
            name = _member_crs(one)
            if name is not None:
                found.add(name)
    return found


def _one_of(names, what):
    """The CRS of all: nothing where none has one."""
    if len(names) > 1:
        raise _thiessen.Error(f"the {what} are of several CRSs: {', '.join(sorted(one or 'none' for one in names))}")
    return next(iter(names), "")


def _own_crs(value, shapes, what):
    """The CRS that a collection or its shapes have of themselves, and where it is from."""
    own = getattr(value, "crs", None)
    if own is not None and not isinstance(own, dict):
        return crs_text(own), "object"
    geojson = interface(value)
    name = (_member_crs(geojson) if geojson else None) or _one_of(_crs_in(shapes), what)
    if name:
        return name, "object"
    kinds = {shape.get("type") if isinstance(shape, dict) else None for shape in ([value] if geojson else shapes)}
    implied = bool(kinds) and kinds <= {"FeatureCollection", "Feature"}
    return (GEOGRAPHIC, "implied") if implied else ("", "")


def _property_ids(features, field):
    """The ids of features by the property that is named."""
    properties = [feature.get("properties") or {} for feature in features]
    if any(field not in one for one in properties):
        names = list(properties[0]) if properties else []
        raise _thiessen.Error(f"there is no field {field!r}; found {', '.join(map(repr, names)) or 'none'}")
    return [one[field] for one in properties]


def _normal_fields(names, field):
    """The field of normals among these names, or the twelve of the calendar months."""
    months = [f"{field}_{month:02}" for month in range(1, 13)]
    found = [field] if field in names else [name for name in months if name in names]
    if len(found) in (1, 12):
        return found
    raise _thiessen.Error(f"normal_field: there is no field {field!r}, and " + (f"only {len(found)}" if found else "none")
                          + f" of {months[0]!r} to {months[-1]!r}; found {named(names)}")


def _normals_of_features(features, keywords):
    """The normals in the properties of features, if normal_field asks for them; NaN where one is missing."""
    field = keywords.get("normal_field")
    if not field:
        return ()
    properties = [feature.get("properties") or {} for feature in features]
    fields = _normal_fields([str(name) for name in properties[0]] if properties else [], str(field))
    rows = [[numpy.nan if is_missing(one.get(name)) else one[name] for name in fields] for one in properties]
    return numbers(rows, "the normals").tolist()


def _normals_of_frame(frame, keywords):
    """The normals in the columns of a frame, if normal_field asks for them."""
    field = keywords.get("normal_field")
    if not field:
        return ()
    names = [str(name) for name in frame.columns]
    fields = _normal_fields(names, str(field))
    return numpy.column_stack([column_numbers(frame.iloc[:, names.index(name)], f"the normals in column {name!r}")
                               for name in fields]).tolist()


def _refuse_normals(keywords, what):
    if not keywords.get("normal_field"):
        return
    raise _thiessen.Error(f"normal_field is about fields, and these {what} have none\n"
                          "hint: columns of a frame are, and properties of GeoJSON; normals is a raster")


def _station_ids(features, field):
    """The ids of stations: of the property that is named, else of one with a usual name, else GeoJSON's own ids."""
    if field is not None:
        return _property_ids(features, field)
    properties = [feature.get("properties") or {} for feature in features]
    names = list(properties[0]) if properties else []
    known = _thiessen.known_columns([str(name) for name in names])[0]
    if known is not None and all(names[known] in one for one in properties):
        return [one[names[known]] for one in properties]
    if features and all(feature.get("id") is not None for feature in features):
        return [feature["id"] for feature in features]
    return range(1, len(features) + 1)


def _is_shape(value):
    return isinstance(value, (str, bytes, bytearray, memoryview, dict)) or interface(value) is not None


def _of_text(shape, place):
    """The geometry in WKT or WKB: its type, points and polygons, and the CRS that stands with it."""
    if not isinstance(shape, str):
        shape = bytes(shape).hex()
    found = _thiessen.geometry_in(shape)
    if found is None:
        raise _thiessen.Error(f"{place} is neither WKT nor WKB")
    kind, points, polygons, srid = found
    return kind, points, polygons, f"EPSG:{srid}" if srid else ""


def _geometry_of(shape, place):
    """The GeoJSON geometry of a shape."""
    geometry = interface(shape)
    if geometry is not None and geometry["type"] == "Feature":
        geometry = geometry.get("geometry")
        if geometry is None:
            raise _thiessen.Error(f"{place} has no geometry")
    if not isinstance(geometry, dict) or "type" not in geometry:
        raise _thiessen.Error(f"{place} is no geometry but {type(shape).__name__!r}\n"
                              "hint: GeoJSON, an object with __geo_interface__, WKB and WKT are")
    wanted = "geometries" if geometry["type"] == "GeometryCollection" else "coordinates"
    if wanted not in geometry:
        raise _thiessen.Error(f"{place} has no {wanted}")
    return geometry


def _point(shape, station):
    """The coordinates of a shape that is a point, and the CRS that stands with it."""
    place = f"station {id_text(station)!r}"
    if isinstance(shape, (str, bytes, bytearray, memoryview)):
        kind, points, _, crs = _of_text(shape, place)
        coordinates = list(points[0]) if len(points) else ()
    else:
        geometry = _geometry_of(shape, place)
        kind, coordinates, crs = geometry["type"], geometry.get("coordinates") or (), ""
    if kind != "Point":
        raise _thiessen.Error(f"{place} is a {kind}, and not a point")
    if len(coordinates) < 2:
        raise _thiessen.Error(f"{place} has an empty geometry")
    return coordinates[:2], crs


def _pairs(points):
    points = numbers(points, "the coordinates of the stations")
    if points.size == 0:
        return points.reshape(0, 2)
    if points.ndim != 2 or points.shape[1] != 2:
        raise _thiessen.Error("the coordinates of the stations are not two for each")
    return points


def _stations_of_values(values, ids, what=None, normals=()):
    """Stations of two numbers each, or of shapes that are points."""
    if not hasattr(values, "__iter__"):
        raise _thiessen.Error(f"the stations are a {type(values).__name__!r}: a list of places is wanted")
    shapes = not isinstance(values, numpy.ndarray) or values.dtype.kind in "OSU"
    values = list(values) if shapes else values
    if not shapes or not any(map(_is_shape, values)):
        return HeldStations(range(1, len(values) + 1) if ids is None else ids, _pairs(values), normals=normals)
    ids = list(range(1, len(values) + 1) if ids is None else ids)
    if len(ids) != len(values):
        raise _thiessen.Error(f"{len(values)} stations, and {len(ids)} ids: one for each is needed")
    found = [_point(value, name) for value, name in zip(values, ids)]
    text = _one_of({crs for _, crs in found}, "stations")
    crs = (text, "object") if text else _own_crs(what, values, "stations")
    return HeldStations(ids, _pairs([point for point, _ in found]), crs, normals)


def _collected(values):
    """A list of Features is a collection of them."""
    if isinstance(values, (list, tuple)) and values:
        features = [interface(value) for value in values]
        if all(isinstance(one, dict) and one.get("type") == "Feature" for one in features):
            return {"type": "FeatureCollection", "features": features}
    return values


def stations_of(stations, ids, keywords):
    """Stations in memory: see Study. Takes of the keywords those that are about their fields."""
    stations = _collected(stations)
    geojson = interface(stations)
    if geojson is not None:
        features = _features(geojson)
        if ids is None:
            ids = _station_ids(features, keywords.pop("id", None))
        return _stations_of_values(features, ids, stations, _normals_of_features(features, keywords))
    if is_frame(stations):
        return _stations_of_frame(stations, ids, keywords)
    _refuse_normals(keywords, "stations")
    if isinstance(stations, dict):
        if ids is not None:
            raise _thiessen.Error("the stations have ids, as they are a dictionary, and ids gives others\n"
                                  "hint: leave ids out")
        return _stations_of_values(list(stations.values()), list(stations))
    if is_series(stations):
        labels = labels_of(stations)
        return _stations_of_values(list(stations), labels if ids is None else ids)
    return _stations_of_values(stations, ids)


def _stations_of_frame(frame, ids, keywords):
    names = [str(name) for name in frame.columns]
    known_id, known_x, known_y, are_degrees = _thiessen.known_columns(names)
    are_degrees = are_degrees and keywords.get("x") is None and keywords.get("y") is None

    def place_of(keyword, known, what):
        field = keywords.pop(keyword, None)
        if field is not None:
            if str(field) not in names:
                raise _thiessen.Error(f"there is no column {field!r}; found {named(names)}")
            return names.index(str(field))
        if known is None and what is not None:
            raise _thiessen.Error(f"no column is known for {what}; found {named(names)}\nhint: name them with x and y")
        return known

    x = place_of("x", known_x, "the longitude or easting")
    y = place_of("y", known_y, "the latitude or northing")
    if ids is None:
        column = place_of("id", known_id, None)
        ids = frame.index if column is None else frame.iloc[:, column]
    points = numpy.column_stack([column_numbers(frame.iloc[:, one], f"the coordinates in column {names[one]!r}")
                                 for one in (x, y)])
    return HeldStations(ids, _pairs(points), (GEOGRAPHIC, "columns") if are_degrees else ("", ""),
                        _normals_of_frame(frame, keywords))


def _ring(ring, basin):
    points = numbers([point[:2] for point in ring], f"the coordinates of basin {basin!r}")
    return points.reshape(0, 2) if points.size == 0 else points


def _polygons(shape, basin):
    """A shape as polygons, each a list of rings, and the CRS that stands with it."""
    place = f"basin {basin!r}"
    if isinstance(shape, (str, bytes, bytearray, memoryview)):
        kind, points, polygons, crs = _of_text(shape, place)
        if not polygons and (len(points) or kind not in ("Polygon", "MultiPolygon", "GeometryCollection")):
            raise _thiessen.Error(f"{place} is a {kind}, and not a polygon")
        return polygons, crs
    geometry = _geometry_of(shape, place)
    kind = geometry["type"]
    if kind in ("Polygon", "MultiPolygon"):
        polygons = [geometry["coordinates"]] if kind == "Polygon" else geometry["coordinates"]
        try:
            return [[_ring(ring, basin) for ring in polygon] for polygon in polygons], ""
        except (TypeError, IndexError):
            raise _thiessen.Error(f"{place} has coordinates that are no rings of points") from None
    if kind == "GeometryCollection":
        return [polygon for part in geometry["geometries"] for polygon in _polygons(part, basin)[0]], ""
    raise _thiessen.Error(f"{place} is a {kind}, and not a polygon")


def _shapes_in(basins, ids, keywords):
    """The shapes of basins, and the ids that they have of themselves; None for numbers from 1."""
    geojson = interface(basins)
    if geojson is not None:
        shapes = _features(geojson)
        return shapes, _basin_ids(shapes, keywords.pop("basin_id", None), labels_of(basins)) if ids is None else ids
    if isinstance(basins, dict):
        if ids is not None:
            raise _thiessen.Error("the basins have ids, as they are a dictionary, and basin_ids gives others\n"
                                  "hint: leave basin_ids out")
        if "type" in basins and isinstance(basins["type"], str):
            raise _thiessen.Error(f"the basins are GeoJSON of a type that is not known: {basins['type']!r}")
        return list(basins.values()), list(basins)
    if is_frame(basins):
        raise _thiessen.Error("the basins are a frame without geometries\nhint: a GeoDataFrame has them")
    if is_series(basins):
        return list(basins), labels_of(basins) if ids is None else ids
    if isinstance(basins, (bytes, bytearray, memoryview)):
        return [basins], ids
    if not hasattr(basins, "__iter__"):
        raise _thiessen.Error(f"the basins are a {type(basins).__name__!r}: a list of shapes is wanted")
    return list(basins), ids


def basins_of(basins, ids, keywords):
    """Basins in memory: see Study. Shapes that share an id are one basin. Takes of the keywords those that are about
    their fields.
    """
    basins = _collected(basins)
    shapes, ids = _shapes_in(basins, ids, keywords)
    if interface(basins) is None:
        _refuse_normals(keywords, "basins")
    normals = _normals_of_features(shapes, keywords)
    ids = [id_text(one) for one in (range(1, len(shapes) + 1) if ids is None else ids)]
    if len(ids) != len(shapes):
        raise _thiessen.Error(f"{len(shapes)} basins, and {len(ids)} basin_ids: one for each is needed")
    merged = {}
    normals_of = {}
    crss = set()
    for number, (name, shape) in enumerate(zip(ids, shapes), 1):
        if not name:
            raise _thiessen.Error(f"basin {number} has no id")
        polygons, crs = _polygons(shape, name)
        crss.add(crs)
        merged.setdefault(name, []).extend(polygons)
        if normals and not numpy.array_equal(normals_of.setdefault(name, normals[number - 1]), normals[number - 1],
                                             equal_nan=True):
            raise _thiessen.Error(f"basin {name!r} has other normals in another of its features\n"
                                  "hint: the features of one basin have the same normals")
    text = _one_of(crss, "basins")
    crs = (text, "object") if text else _own_crs(basins, shapes, "basins")
    return HeldBasins(list(merged), list(merged.values()), crs, list(normals_of.values()))


def _basin_ids(features, field, labels):
    """The program's rule: the first of these names whose values are all there and all different; else the labels of a
    GeoDataFrame, where they do not only count its rows, or numbers.
    """
    if field is not None:
        return _property_ids(features, field)
    properties = [feature.get("properties") or {} for feature in features]
    for known in ("basin", "basin_id", "id", "code", "name"):
        for name in properties[0] if properties else ():
            values = [id_text(one.get(name)) for one in properties]
            if str(name).lower() == known and all(values) and len(set(values)) == len(values):
                return values
    return labels
