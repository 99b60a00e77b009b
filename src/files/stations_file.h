#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "files/crs_origin.h"
#include "files/source.h"
#include "gdal/crs/crs.h"
#include "study/source_lists.h"
#include "text/attributes.h"

namespace thiessen {

class Features;

/// A file of stations to be read, and the fields of their ids and coordinates.
struct StationsRequest {
  Source source;
  std::string id, x, y;  ///< names of fields; empty: found by usual names
  std::string label;     ///< name of the field with what stations are called; empty: none is read
  bool attributes = false;
};

/// The stations of a file, in its order, with coordinates as the file has them.
struct StationsFile : StationList {  ///< positions in `crs`, or in a plane without one
  Attributes attributes;             ///< read only where asked for
  /// What the stations are called, by their ids, where asked for; without those that have no name.
  std::unordered_map<std::string, std::string> labels;
  std::unordered_set<std::string> filtered_ids;  ///< ids of the stations that the filter left out
  std::optional<Crs> crs;
  CrsOrigin crs_origin = CrsOrigin::none;
};

/// Reads the stations: a CSV with coordinates in two columns or in a WKT column, or any vector file
/// or table that GDAL reads. Ids are kept as written. Columns named lon, long or longitude and lat
/// or latitude hold WGS 84 longitude and latitude unless the options say otherwise; x, y, easting
/// and northing say nothing of their CRS. Throws Error with every bad row (an id given twice, a
/// coordinate that is no finite number, a geometry that is no point), and where there are no
/// stations. Cost: linear in the file's length, memory linear in the number of stations.
StationsFile read_stations(const StationsRequest& request, Warnings& warnings);

/// The field of the stations' ids: the one that is asked for, else the first with a usual name,
/// else the first. Requires a header that is not empty. Throws Error where the named one is not
/// there.
std::size_t station_id_field(const Features& features, const StationsRequest& request);

/// Finds the field of the stations' file, other than that of the ids, in which a station has this
/// text; empty where there is none, and where the file cannot be read a second time. Cost: linear
/// in the file's length.
std::string field_that_holds(const StationsRequest& request, const std::string& text);

}  // namespace thiessen
