#include "files/basin_centroids.h"

#include <algorithm>

#include "basin/centroid.h"
#include "gdal/crs/transformation.h"

namespace thiessen {

std::vector<Point> centroids_in_plane(const StudyFiles& study) {
  std::vector<Point> centroids;
  for (const Basin& basin : study.basins) centroids.push_back(plane_centroid(basin.shape));
  return centroids;
}

std::optional<std::vector<Point>> centroids_on_earth(const StudyFiles& study) {
  if (study.metric == Metric::geodesic) {
    std::vector<Point> centroids;
    for (const Basin& basin : study.basins) centroids.push_back(sphere_centroid(basin.shape));
    return centroids;
  }
  if (!study.crs) return std::nullopt;
  Crs degrees = Crs::wgs84();
  if (study.crs->area()) degrees = degrees.over(*study.crs->area());
  std::vector<Point> centroids = centroids_in_plane(study);
  const std::vector<bool> inside = Transformation(*study.crs, degrees).apply(centroids);
  if (std::find(inside.begin(), inside.end(), false) != inside.end()) return std::nullopt;
  return centroids;
}

}  // namespace thiessen
