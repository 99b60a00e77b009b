#pragma once

#include <string>
#include <vector>

#include "outlines/raw_basin.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Stations as their source gives them, neither checked nor projected.
struct StationList {
  std::string file;
  std::vector<Station> stations;
  bool has_lines = false;  ///< Station::line is a line of the file, and not a feature's number
};

/// Basins as their source gives them, not yet mended.
struct BasinList {
  std::string file;
  std::vector<RawBasin> basins;  ///< in the order in which their ids first appear
};

}  // namespace thiessen
