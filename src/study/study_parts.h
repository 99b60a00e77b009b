#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "basin/basin.h"
#include "earth/yardstick.h"
#include "rainfall/network.h"

namespace thiessen {

/// What a study is made of, in one system of coordinates: WGS 84 longitude and latitude in degrees
/// where the metric is geodesic, else those of a plane.
struct StudyParts {
  Metric metric = Metric::planar;
  std::vector<Station> stations;  ///< in the order of their source
  std::size_t opened = 0;         ///< how many, the last of `stations`, the source lacks
  std::vector<Basin> basins;      ///< valid: see Polygon
  bool has_basins = true;         ///< else the extent of the stations is the study area
  /// How long the plane's unit is in metres; nothing where that is unknown (no CRS, or degrees):
  /// areas are then in the square of the coordinates' unit.
  std::optional<double> metres_per_unit;

  // How messages name where these come from; empty for what is not of a file.
  std::string stations_file;
  std::string basins_file;
  std::string opened_from;
  bool stations_have_lines = false;  ///< Station::line is a line, and not a feature's number
};

}  // namespace thiessen
