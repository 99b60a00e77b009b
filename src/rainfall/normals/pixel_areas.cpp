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

// The ordinate is a parabola through the edges of a row and its middle: the fourth term of its
// series is 6e-9 of a row that is as high as they may be.
double PixelsInDegrees::ordinate(double row) const {
  if (middles_.empty() || row < 0 || row > static_cast<double>(middles_.size()))
    return exactly(row);
  const std::size_t r = std::min(static_cast<std::size_t>(row), middles_.size() - 1);
  return in_row(r)->at(row - static_cast<double>(r));
}

std::optional<PixelAreas::InRow> PixelsInDegrees::in_row(std::size_t row) const {
  if (middles_.empty()) return std::nullopt;
  const double whole = edges_[row + 1] - edges_[row];
  return InRow{edges_[row], whole, 4 * (middles_[row] - edges_[row] - whole / 2)};
}

PixelsOfPlane::PixelsOfPlane(std::vector<double> nodes, std::size_t columns, std::size_t spacing)
    : nodes_(std::move(nodes)), spacing_(spacing), nodes_in_row_(nodes_along(columns, spacing)) {}

PixelAreas::Scales PixelsOfPlane::scales(std::size_t row, std::size_t column) const {
  const std::size_t node = column / spacing_;
  const double* const upper = &nodes_[row / spacing_ * nodes_in_row_ + node];
  const double* const lower = upper + nodes_in_row_;
  const auto pixels = static_cast<double>(spacing_);
  const double down = (static_cast<double>(row % spacing_) + 0.5) / pixels;
  const double left = upper[0] + down * (lower[0] - upper[0]);
  const double right = upper[1] + down * (lower[1] - upper[1]);
  const double step = (right - left) / pixels;
  return {node * spacing_, (node + 1) * spacing_, left + step / 2, step};
}

}  // namespace thiessen
