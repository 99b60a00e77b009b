#pragma once

#include <cstddef>
#include <optional>

#include "files/places/stations_file.h"
#include "files/tables/features.h"

namespace thiessen {

/// Which fields of a stations' file hold what.
struct StationFields {
  std::optional<std::size_t> id;  ///< nothing: stations are numbered from 1, in the file's order
  std::optional<std::size_t> label;
  bool by_geometry = false;  ///< positions are the features' geometries, and not two fields
  std::size_t x = 0;
  std::size_t y = 0;
  bool are_degrees = false;  ///< the names of the two fields say longitude and latitude
};

/// Finds the fields: those that the request names, else by usual names. The id is else the first
/// field that is neither a coordinate nor called as rainfall; where there is none, stations have
/// numbers. Throws Error where a named field is not there, or coordinates are nowhere.
StationFields find_station_fields(const Features& features, const StationsRequest& request);

}  // namespace thiessen
