#pragma once

#include <string>

namespace thiessen {

/// A file of stations or basins as its reader names it, and what is said of it.
/// An empty text means that nothing is said.
struct Source {
  std::string file;
  std::string layer;                             ///< which layer, where the file has several
  std::string where;                             ///< an OGR attribute filter
  std::string crs;                               ///< EPSG:32633, WKT or PROJ
  std::string layer_setting = "stations_layer";  ///< what messages call these settings
  std::string where_setting = "stations_where";
  std::string crs_setting = "crs";
  char separator = '\0';       ///< of a CSV; '\0': not given, a comma
  bool decimal_comma = false;  ///< of a CSV
};

}  // namespace thiessen
