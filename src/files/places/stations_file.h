#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "files/places/crs_origin.h"
#include "files/tables/source.h"
#include "gdal/crs/crs.h"
#include "study/source_lists.h"
#include "text/attributes.h"

namespace thiessen {

/// A file of stations to be read, and the fields of their ids and coordinates.
struct StationsRequest {
  Source source;
  std::string id, x, y;  ///< names of fields; empty: found by usual names
  std::string label;     ///< name of the field with what stations are called; empty: none is read
  /// The field of normals, or of which twelve fields have the name with _01 to _12 behind it;
  /// empty: none are read.
  std::string normal_field;
  /// The field of elevations; empty: found by usual names, or none where there is none; nothing:
  /// none are read.
  std::optional<std::string> elevation_field;
  bool attributes = false;
  bool skip_unplaced = false;  ///< stations without coordinates are passed over, with a warning
};

/// The stations of a file, in its order, with coordinates as the file has them.
struct StationsFile : StationList {  ///< positions in `crs`, or in a plane without one
  Attributes attributes;             ///< read only where asked for
  /// What the stations are called, by their ids, where asked for; without those that have no name.
  std::unordered_map<std::string, std::string> labels;
  /// The normals of the stations, by their ids, one or twelve, where asked for; NaN where one is
  /// empty.
  std::unordered_map<std::string, std::vector<double>> normals;
  /// The elevations of the stations, by their ids, where asked for and there is a field; NaN where
  /// one is empty or a code for missing ones.
  std::unordered_map<std::string, double> elevations;
  std::string elevation_field;  ///< the name of that field; empty where there is none
  std::unordered_set<std::string> filtered_ids;  ///< ids of the stations that the filter left out
  std::optional<Crs> crs;
  CrsOrigin crs_origin = CrsOrigin::none;
};

/// Reads the stations: a CSV with coordinates in two columns, in numbers or in degrees, minutes and
/// seconds, or in a column of geometries (see geometry_of_text); GHCN-Daily's list of stations; or
/// any vector file or table that GDAL reads. Ids are kept as written. Rows that repeat a station at
/// its place are one. Columns named lon, long or longitude and lat
/// or latitude hold WGS 84 longitude and latitude unless the options say otherwise; x, y, easting
/// and northing say nothing of their CRS. Throws Error with every bad row (an id given at two
/// places, a coordinate that is no finite number, a geometry that is no point), and where there are
/// no stations. Cost: linear in the file's length, memory linear in the number of stations.
StationsFile read_stations(const StationsRequest& request, Warnings& warnings);

/// Finds the field of the stations' file, other than that of the ids, in which a station has this
/// text; empty where there is none, and where the file cannot be read a second time. Cost: linear
/// in the file's length.
std::string field_that_holds(const StationsRequest& request, const std::string& text);

}  // namespace thiessen
