#pragma once

#include <string>

#include "base/error.h"
#include "base/utf8.h"
#include "text/csv_dialect.h"

namespace thiessen {

/// A file of stations or basins as its reader names it, and what the user says of it. A text is
/// empty where the user says nothing.
struct Source {
  std::string file;
  std::string layer;                             ///< which layer, where the file has several
  std::string where;                             ///< an OGR attribute filter
  std::string crs;                               ///< EPSG:32633, WKT or PROJ
  std::string layer_setting = "stations_layer";  ///< names of these settings in messages
  std::string where_setting = "stations_where";
  std::string crs_setting = "crs";
  CsvDialect csv = {};  ///< how it is written, where it is a CSV
};

/// The error that a layer is named of a CSV.
inline Error no_layers(const Source& source) {
  return Error(Message{source.file,
                       0,
                       "a CSV file has no layers: " + setting(source.layer_setting, source.layer),
                       {}});
}

}  // namespace thiessen
