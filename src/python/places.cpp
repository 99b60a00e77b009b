#include "python/places.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>

#include "base/error.h"
#include "files/places/crs_origin.h"
#include "gdal/crs/crs.h"
#include "gdal/layers/geometry_text.h"
#include "geometry/polygon.h"
#include "study/given_lists.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace py = pybind11;

namespace thiessen::python {
namespace {

/// Names what is in memory as messages name files: `stations: ...`.
template <typename File>
void name(File& file, const char* what, const std::string& crs, const std::string& origin) {
  file.file = what;
  if (crs.empty()) return;
  file.crs = Crs::from_text(crs, "the CRS of the " + std::string(what));
  file.crs_origin = origin == "implied"   ? CrsOrigin::implied
                    : origin == "columns" ? CrsOrigin::columns
                                          : CrsOrigin::object;
}

void require_pairs(const Doubles& points) {
  if (points.ndim() == 2 && points.shape(1) == 2) return;
  throw py::value_error("coordinates are not an array of two columns");
}

Ring ring_of(const Doubles& points) {
  require_pairs(points);
  const auto at = points.unchecked<2>();
  Ring ring;
  ring.reserve(static_cast<std::size_t>(points.shape(0)));
  for (py::ssize_t i = 0; i < points.shape(0); ++i) ring.push_back({at(i, 0), at(i, 1)});
  return ring;
}

Doubles array_of(const Ring& ring) {
  Doubles array({static_cast<py::ssize_t>(ring.size()), py::ssize_t{2}});
  auto at = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    at(i, 0) = ring[static_cast<std::size_t>(i)].x;
    at(i, 1) = ring[static_cast<std::size_t>(i)].y;
  }
  return array;
}

}  // namespace

StationsFile stations_of(const std::vector<std::string>& ids, const Doubles& positions,
                         const std::string& crs, const std::string& origin,
                         const Normals& normals) {
  require_pairs(positions);
  if (ids.size() != static_cast<std::size_t>(positions.shape(0))) {
    throw py::value_error(std::to_string(positions.shape(0)) + " stations, and " +
                          std::to_string(ids.size()) + " ids: one for each is needed");
  }
  const auto at = positions.unchecked<2>();
  std::vector<Station> stations;
  stations.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    stations.push_back({ids[i], {at(row, 0), at(row, 1)}});
  }
  StationsFile file;
  static_cast<StationList&>(file) = given_stations(std::move(stations));
  name(file, "stations", crs, origin);
  for (std::size_t i = 0; i < normals.size(); ++i) file.normals.emplace(ids.at(i), normals[i]);
  return file;
}

BasinsFile basins_of(const std::vector<std::string>& ids,
                     const std::vector<std::vector<Rings>>& shapes, const std::string& crs,
                     const std::string& origin, const Normals& normals) {
  std::vector<Basin> basins;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Basin basin{ids[i], {}, {}};
    for (const Rings& rings : shapes.at(i)) {
      if (rings.empty()) continue;
      Polygon polygon{ring_of(rings.front()), {}};
      for (std::size_t hole = 1; hole < rings.size(); ++hole)
        polygon.holes.push_back(ring_of(rings[hole]));
      basin.shape.push_back(std::move(polygon));
    }
    basins.push_back(std::move(basin));
  }
  if (basins.empty()) throw Error({"", 0, "there are no basins", ""});
  BasinsFile file;
  static_cast<BasinList&>(file) = given_basins(std::move(basins));
  name(file, "basins", crs, origin);
  for (std::size_t i = 0; i < normals.size(); ++i) file.normals.emplace(ids.at(i), normals[i]);
  return file;
}

std::vector<std::string> ids_of(const std::vector<Station>& stations) {
  std::vector<std::string> ids;
  ids.reserve(stations.size());
  for (const Station& station : stations) ids.push_back(station.id);
  return ids;
}

Doubles positions_of(const std::vector<Station>& stations) {
  Ring points;
  points.reserve(stations.size());
  for (const Station& station : stations) points.push_back(station.position);
  return array_of(points);
}

py::object geometry_in(const std::string& text) {
  const auto found = geometry_of_text(text);
  if (!found) return py::none();
  std::vector<Rings> polygons;
  for (const Polygon& polygon : found->geometry.polygons) {
    Rings& rings = polygons.emplace_back();
    rings.push_back(array_of(polygon.outer));
    for (const Ring& hole : polygon.holes) rings.push_back(array_of(hole));
  }
  return py::make_tuple(found->geometry.type, array_of(found->geometry.points), polygons,
                        found->srid);
}

py::tuple known_columns(const std::vector<std::string>& names) {
  const auto x = find_field(names, known::eastings);
  const auto y = find_field(names, known::northings);
  const auto says_degrees = [&](std::size_t field) {
    const std::vector<std::string> one{names[field]};
    return find_field(one, known::degrees).has_value();
  };
  return py::make_tuple(find_field(names, known::station_ids), x, y,
                        x && y && says_degrees(*x) && says_degrees(*y));
}

}  // namespace thiessen::python
