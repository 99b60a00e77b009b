#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "files/places/basins_file.h"
#include "files/places/stations_file.h"

namespace thiessen::python {

/// Numbers of a caller, copied where they do not lie row by row.
using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

/// Normals of a caller, one or twelve for each station or basin.
using Normals = std::vector<std::vector<double>>;

/// Stations of a caller: an id for each row of two coordinates, and the CRS that they have of
/// themselves, if any. Its origin is `object`, where it stands with them, `columns`, where names of
/// columns say degrees, or `implied`, where it is GeoJSON's. `normals` are one or twelve for each,
/// NaN where one is missing, or none at all. Throws Python's ValueError for arrays that do not fit,
/// and Error.
StationsFile stations_of(const std::vector<std::string>& ids, const Doubles& positions,
                         const std::string& crs, const std::string& origin, const Normals& normals);

/// The rings of a polygon, the outer one first.
using Rings = std::vector<Doubles>;

/// Basins of a caller: an id for each shape, which is a list of polygons. Throws as stations_of
/// does.
BasinsFile basins_of(const std::vector<std::string>& ids,
                     const std::vector<std::vector<Rings>>& shapes, const std::string& crs,
                     const std::string& origin, const Normals& normals);

std::vector<std::string> ids_of(const std::vector<Station>& stations);
/// The coordinates of stations as an array of two columns.
Doubles positions_of(const std::vector<Station>& stations);

/// A geometry's type, points and polygons, and its SRID, of a text in WKT or of WKB in hexadecimal
/// digits; None where it is neither.
pybind11::object geometry_in(const std::string& text);

/// The places of the id, the two coordinates, and whether their names say degrees, among names of
/// columns; None for what is not there.
pybind11::tuple known_columns(const std::vector<std::string>& names);

}  // namespace thiessen::python
