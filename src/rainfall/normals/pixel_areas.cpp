#include "rainfall/normals/pixel_areas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "earth/area/ellipsoid_area.h"

namespace thiessen {
namespace {

/// Rows that are higher than this, in degrees, are measured anew for every position in them.
constexpr double highest_row = 0.05;

}  // namespace

PixelsInDegrees::PixelsInDegrees(double top, double height, double width, std::size_t rows)
    : top_(top), height_(height), width_(std::abs(width)) {
  if (std::abs(height) > highest_row) return;
  edges_.reserve(rows + 1);
  middles_.reserve(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    edges_.push_back(exactly(static_cast<double>(r)));
    middles_.push_back(exactly(static_cast<double>(r) + 0.5));
  }
  edges_.push_back(exactly(static_cast<double>(rows)));
}

double PixelsInDegrees::exactly(double row) const {
  const double latitude = std::clamp(top_ + row * height_, -90.0, 90.0);
  return width_ * std::abs(area_under({0, latitude}, {1, latitude}, top_));
}

PixelsOfPlane::PixelsOfPlane(std::vector<double> nodes, std::size_t columns, std::size_t spacing)
    : nodes_(std::move(nodes)), spacing_(spacing), nodes_in_row_(nodes_along(columns, spacing)) {}

}  // namespace thiessen
