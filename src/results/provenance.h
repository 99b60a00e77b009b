#pragma once

#include <string>
#include <utility>
#include <vector>

namespace thiessen {

/// What an output says of how it was made. It has no dates and no paths, so that the same input
/// gives the same bytes.
struct Provenance {
  std::string software;    ///< what made it, with its version: "thiessen 0.1.0"
  std::string metric;      ///< geodesic or planar
  std::string plane;       ///< the CRS whose plane distances were measured in; empty: none is known
  double tolerance = 0.1;  ///< metres
  std::string method;      ///< how rainfall is told between gauges: thiessen, idw ...
  std::string unit;        ///< of the rainfall; empty where there is none
  std::string rainfall;  ///< what its values are: a time, or which means; empty where there is none
  /// Where normals are from, such as "raster" or "fields of calendar months"; empty without.
  std::string normals = {};
};

/// What is known of how an output was made, as names and values in their order: `software`,
/// `metric`, `plane`, `tolerance`, `method`, `normals`, `unit`, `rainfall`. Empty ones are left
/// out.
std::vector<std::pair<std::string, std::string>> items_of(const Provenance& provenance);

/// What is known of how an output was made, on one line: `thiessen 0.1.0; metric: geodesic; ...`.
std::string sentence_of(const Provenance& provenance);

}  // namespace thiessen
