#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "basin/basin.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// The stations and basins of a study, in one system of coordinates: WGS 84 longitude and latitude
/// in degrees where the metric is geodesic, else the coordinates of a plane.
struct StudyParts {
  Metric metric = Metric::planar;
  std::vector<Station> stations;  ///< in the order of their source
  std::size_t opened = 0;  ///< how many gauges at the end of `stations` were opened for a what-if:
                           ///< the source lacks them
  std::vector<Basin> basins;  ///< valid: see Polygon
  bool has_basins = true;     ///< false: the extent of the stations is the study area
  /// The length of the plane's unit in metres; nothing where it is unknown (no CRS, or degrees):
  /// areas are then in the square of the coordinates' unit.
  std::optional<double> metres_per_unit;

  // Messages name the sources by these; a name is empty for what does not come from a file.
  std::string stations_file;
  std::string basins_file;
  std::string opened_from;
  /// Whether Station::line is a line of the file, and not a feature's number.
  bool stations_have_lines = false;
};

}  // namespace thiessen
