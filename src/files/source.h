#pragma once

#include <string>

namespace thiessen {

/// A file of stations or basins as the command line names it, and what its options say of it.
/// An empty text means that the option is not given.
struct Source {
  std::string file;
  std::string layer;                              ///< which layer, where the file has several
  std::string where;                              ///< an OGR attribute filter
  std::string crs;                                ///< EPSG:32633, WKT or PROJ
  std::string layer_option = "--stations-layer";  ///< the options' names, for messages
  std::string where_option = "--stations-where";
  std::string crs_option = "--crs";
  char separator = '\0';       ///< of a CSV; '\0': not given, a comma
  bool decimal_comma = false;  ///< of a CSV
};

}  // namespace thiessen
