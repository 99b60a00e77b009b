#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "basin/basin.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"
#include "study/far_cause.h"

namespace thiessen {

/// The stations and basins of a study, in one system of coordinates: WGS 84 longitude and latitude
/// in degrees where the metric is geodesic, else the coordinates of a plane.
struct StudyParts {
  Metric metric = Metric::planar;
  std::vector<Station> stations;  ///< in the order of their source
  std::size_t opened = 0;  ///< how many gauges at the end of `stations` were opened for a what-if:
                           ///< the source lacks them
  /// The stations of the source that have no reading at all: they are not of the network, but they
  /// are there, and pictures show where.
  std::vector<Station> never_reporting;
  std::vector<Basin> basins;  ///< valid: see Polygon
  /// The basins once more, where their edges are curves that are drawn more finely, or less, than
  /// areas are measured with (Yardstick::measuring_tolerance); else none.
  std::vector<Basin> drawn_basins;
  bool has_basins = true;  ///< false: the extent of the stations is the study area
  /// The length of the plane's unit in metres; nothing where it is unknown (no CRS, or degrees):
  /// areas are then in the square of the coordinates' unit.
  std::optional<double> metres_per_unit;
  /// How many degrees on the Earth one unit of a plane is; 0 for a plane of lengths.
  double degrees_per_unit = 0;

  /// The mistakes that may be why gauges and basins are nowhere near each other; asked for only
  /// then. Empty: those of far_causes_of_coordinates.
  std::function<std::vector<FarCause>()> far_causes;
  // Where gauges and basins are in the coordinates of their files, for messages; empty: in those of
  // the study.
  std::string gauges_extent;
  std::string basins_extent;

  // Messages name the sources by these; a name is empty for what does not come from a file.
  std::string stations_file;
  std::string basins_file;
  std::string opened_from;
  /// Whether Station::line is a line of the file, and not a feature's number.
  bool stations_have_lines = false;
};

}  // namespace thiessen
