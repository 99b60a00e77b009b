#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "earth/plane/plane_fit.h"
#include "files/places/basins_file.h"
#include "files/places/stations_file.h"
#include "gdal/crs/crs.h"
#include "study/study_parts.h"
#include "text/attributes.h"

namespace thiessen {

/// The files of a study to be read, and the metric and plane that are asked for.
struct StudyRequest {
  StationsRequest stations;
  std::optional<BasinsRequest> basins;
  /// The gauges that a what-if opens and the file lacks, in the file's coordinates.
  std::vector<Point> opened;
  std::string opened_from =
      "opened gauges";           ///< name that messages give these gauges in place of a file's
  std::optional<Metric> metric;  ///< nothing: geodesic where the coordinates have a CRS
  std::string plane;             ///< a CRS, or automatic_plane; empty: none is asked for
  double tolerance = 0.1;        ///< metres
  bool mend = false;             ///< basins that cross themselves are mended by union
  unsigned threads = 1;          ///< how many may read the files and mend basins
};

/// A study read from its files, ready to be tessellated, and what the files hold beyond that.
struct StudyFiles : StudyParts {
  Attributes attributes;
  /// What the stations are called, by their ids: see StationsFile.
  std::unordered_map<std::string, std::string> labels;
  std::unordered_set<std::string> filtered_ids;  ///< ids of the stations that the filter left out
  /// The normals of the stations and of the basins, by their ids: see StationsFile.
  std::unordered_map<std::string, std::vector<double>> station_normals;
  std::unordered_map<std::string, std::vector<double>> basin_normals;
  /// The elevations of the stations and of the basins, by their ids, and the stations' field of
  /// them: see StationsFile.
  std::unordered_map<std::string, double> station_elevations;
  std::unordered_map<std::string, double> basin_elevations;
  std::string elevation_field;
  std::vector<MultiPolygon> native_basins;  ///< the basins, mended, in `basins_crs`, with the edges
                                            ///< that the file gives them
  /// The ids of the stations whose coordinates are 0 and 0 in a known CRS, in the file's order:
  /// missing coordinates are often written so.
  std::vector<std::string> at_zero;
  /// The plane that was made for the study; nothing where none was.
  std::optional<StudyPlane> plane;
  std::optional<Crs> stations_crs;  ///< CRS of the stations' file
  std::optional<Crs> basins_crs;    ///< CRS of the basins' file, and of native_basins
  /// The CRS of the study's coordinates: WGS 84 where the metric is geodesic; nothing for a plane
  /// without a CRS.
  std::optional<Crs> crs;

  /// The CRS in which files other than GeoJSON are written: the basins', or the stations' where
  /// there are no basins.
  const std::optional<Crs>& output_crs() const { return has_basins ? basins_crs : stations_crs; }
};

/// Reads both files, settles the CRS of each and the metric, and brings everything into the study's
/// coordinates.
///
/// Geodesic: WGS 84 longitude and latitude in degrees. Edges of basins that are straight in a
/// projection are subdivided until the chord in longitude and latitude lies within a quarter of
/// Yardstick::measuring_tolerance of the true edge, and the slivers that the chords cut off are
/// kept as `bulges`; where another tolerance is asked for they are subdivided once more for
/// `drawn_basins`.
/// Longitudes of a basin run on over the antimeridian (to 190); stations lie in [-180, 180].
///
/// Planar: coordinates stay as they are, or every vertex is taken to `plane`. A plane made for the
/// study is told in a warning, and its CRS is that of its PROJ text.
///
/// Throws Error where a CRS is unknown or contradicts the file's, coordinates do not fit the CRS,
/// or a basin crosses itself. Cost: linear, but for one check of validity a basin (n log n).
StudyFiles read_study(const StudyRequest& request, Warnings& warnings);

/// Makes the same of stations and basins that have been read, or were never in a file. The request
/// counts but for the files that it names.
StudyFiles study_of(StationsFile stations, std::optional<BasinsFile> basins,
                    const StudyRequest& request, Warnings& warnings);

}  // namespace thiessen
