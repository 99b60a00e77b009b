#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "results/provenance.h"

namespace thiessen {

/// A Delaunay triangle to be written.
struct TriangleFeature {
  std::array<std::string, 3> stations;  ///< the ids of its corners, counter-clockwise
  MultiPolygon shape;                   ///< in the study's coordinates, counter-clockwise
};

/// The triangles of one output file.
struct TriangleFeatures {
  std::vector<TriangleFeature> triangles;
  std::optional<Provenance> made_by;  ///< what the file says of how it was made
};

/// The names of the fields that hold the stations of a triangle's corners.
inline constexpr std::array<const char*, 3> corner_names = {"a", "b", "c"};

}  // namespace thiessen
