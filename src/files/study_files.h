#pragma once

#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "files/basins_file.h"
#include "files/stations_file.h"
#include "gdal/crs.h"
#include "study/study_parts.h"
#include "text/attributes.h"

namespace thiessen {

struct StudyRequest {
  StationsRequest stations;
  std::optional<BasinsRequest> basins;
  std::vector<Point> opened;                  ///< gauges that the file lacks, in its coordinates
  std::string opened_from = "opened gauges";  ///< what messages about these call their file
  std::optional<Metric> metric;               ///< none: geodesic where the coordinates have a CRS
  std::string plane;                          ///< a CRS; empty: none
  double tolerance = 0.1;                     ///< metres
};

/// A study as its files have it, ready to be tessellated, and what they say beyond that.
struct StudyFiles : StudyParts {
  Attributes attributes;
  std::unordered_set<std::string> filtered_ids;  ///< of the stations that the filter left out
  std::vector<MultiPolygon>
      native_basins;                ///< the basins, mended, in `basins_crs`: their own edges
  std::optional<Crs> stations_crs;  ///< of the stations' file
  std::optional<Crs> basins_crs;    ///< of the basins' file, and of native_basins
  /// Of the study's coordinates: WGS 84 where the metric is geodesic; none: a plane without a CRS.
  std::optional<Crs> crs;

  /// The CRS in which files other than GeoJSON are written: the basins', without basins the
  /// stations'.
  const std::optional<Crs>& output_crs() const { return has_basins ? basins_crs : stations_crs; }
};

/// Reads both files, settles the CRS of each and the metric, and brings everything into the study's
/// coordinates. Geodesic: WGS 84 longitude and latitude in degrees; edges of basins that are
/// straight in a projection are subdivided until the chord in longitude and latitude lies within a
/// quarter of the tolerance of the true edge, and what the chords cut off is kept as `bulges`.
/// Longitudes of a basin run on over the antimeridian (to 190), stations lie in [-180, 180].
/// Planar: coordinates as they are, or every vertex taken to `plane`. Throws Error where a CRS is
/// unknown or contradicts the file's, coordinates do not fit the CRS, or a basin crosses itself.
/// Cost: linear, but for one check of validity a basin (n log n).
StudyFiles read_study(const StudyRequest& request, Warnings& warnings);

}  // namespace thiessen
