#include "map/raster/pixel_positions.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

constexpr std::size_t nodes_a_side = 5;
constexpr double half_root = 0.70710678118654752;
constexpr std::array<double, nodes_a_side> nodes{-1, -half_root, 0, half_root, 1};
// The cosines of the odd eighths of a half circle: these points lie between the nodes.
constexpr std::array<double, nodes_a_side - 1> between_nodes{
    -0.92387953251128674, -0.38268343236508977, 0.38268343236508977, 0.92387953251128674};

/// The coefficients of 1, t ... t^4 of the polynomial that takes these values at the nodes.
std::array<Direction, nodes_a_side> through(const std::array<Direction, nodes_a_side>& v) {
  const Direction outer = 0.5 * (v[4] + v[0]) - v[2];
  const Direction inner = 0.5 * (v[3] + v[1]) - v[2];
  const Direction outer_slope = 0.5 * (v[4] - v[0]);
  const Direction inner_slope = (1 / half_root / 2) * (v[3] - v[1]);
  return {v[2], 2 * inner_slope - outer_slope, 4 * inner - outer, 2 * (outer_slope - inner_slope),
          2 * outer - 4 * inner};
}

template <std::size_t N>
Direction value(const std::array<Direction, N>& terms, double at) {
  Direction sum = terms.back();
  for (std::size_t i = N - 1; i-- > 0;) sum = at * sum + terms[i];
  return sum;
}

template <std::size_t N>
Direction slope(const std::array<Direction, N>& terms, double at) {
  Direction sum = static_cast<double>(N - 1) * terms.back();
  for (std::size_t i = N - 1; i-- > 1;) sum = at * sum + static_cast<double>(i) * terms[i];
  return sum;
}

}  // namespace

std::optional<PixelPositions> PixelPositions::fit(const PixelGrid& grid, const PixelBlock& block,
                                                  const PointMapping& to_study,
                                                  const NearestPlaces& places) {
  constexpr double pixels_off_at_most = 0.002;
  std::vector<Point> points;
  const auto add = [&](double east, double south) {
    points.push_back(grid.at(block.column + (1 + east) / 2 * block.columns,
                             block.row + (1 + south) / 2 * block.rows));
  };
  for (const double south : nodes) {
    for (const double east : nodes) add(east, south);
  }
  for (const double south : between_nodes) {
    for (const double east : between_nodes) add(east, south);
  }
  to_study(points);
  std::vector<Direction> there;
  double rounding = 0;
  for (const Point p : points) {
    there.push_back(places.in_space(p));
    if (!std::isfinite(there.back().x + there.back().y + there.back().z)) return {};
    rounding = std::max(rounding, places.rounding(there.back()));
  }
  PixelPositions positions(block);
  positions.pass_through(there);
  positions.bound_tangents();
  const double pixel = std::max(length(positions.middle_.east) / block.columns,
                                length(positions.middle_.south) / block.rows) *
                       2;
  const double off = 4 * positions.farthest_off(there);
  if (!(off <= std::max(pixels_off_at_most * pixel, 4 * rounding)) || !positions.is_even())
    return {};
  positions.off_ = off + 2 * rounding;
  positions.bound_curvature();
  return positions;
}

void PixelPositions::pass_through(const std::vector<Direction>& there) {
  origin_ = there[nodes_a_side * nodes_a_side / 2];
  std::array<Row, terms> rows;
  for (std::size_t i = 0; i < nodes_a_side; ++i) {
    Row row;
    for (std::size_t j = 0; j < nodes_a_side; ++j) row[j] = there[i * nodes_a_side + j] - origin_;
    rows[i] = through(row);
  }
  for (std::size_t j = 0; j < terms; ++j) {
    Row column;
    for (std::size_t i = 0; i < nodes_a_side; ++i) column[i] = rows[i][j];
    column = through(column);
    for (std::size_t i = 0; i < terms; ++i) terms_[i][j] = column[i];
  }
}

double PixelPositions::farthest_off(const std::vector<Direction>& there) const {
  double farthest = 0;
  std::size_t i = nodes_a_side * nodes_a_side;
  for (const double south : between_nodes) {
    for (const double east : between_nodes)
      farthest = std::max(farthest, length(position(east, south) - (there[i++] - origin_)));
  }
  return farthest;
}

// Bounds how far tangents differ from the middle one, because the position changes from one point
// of the block to another by the mean of the tangents between them.
void PixelPositions::bound_tangents() {
  constexpr double beyond_nodes = 1.5;
  middle_ = tangent(0, 0);
  for (const double south : nodes) {
    for (const double east : nodes) {
      const Tangent here = tangent(east, south);
      east_varies_ = std::max(east_varies_, beyond_nodes * length(here.east - middle_.east));
      south_varies_ = std::max(south_varies_, beyond_nodes * length(here.south - middle_.south));
    }
  }
}

// Each term's derivatives are largest at the block's corners, where they are its factors.
void PixelPositions::bound_curvature() {
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t j = 0; j < terms; ++j) {
      const double size = length(terms_[i][j]);
      const auto south = static_cast<double>(i);
      const auto east = static_cast<double>(j);
      bends_east_ += east * (east - 1) * size;
      bends_across_ += east * south * size;
      bends_south_ += south * (south - 1) * size;
    }
  }
}

bool PixelPositions::is_even() const {
  constexpr double share = 1.0 / 3;
  return east_varies_ + south_varies_ <= share * (length(middle_.east) + length(middle_.south));
}

Direction PixelPositions::position(double east, double south) const {
  Row across;
  for (std::size_t i = 0; i < terms; ++i) across[i] = value(terms_[i], east);
  return value(across, south);
}

PixelPositions::Tangent PixelPositions::tangent(double east, double south) const {
  Row across;
  Row along;
  for (std::size_t i = 0; i < terms; ++i) {
    across[i] = value(terms_[i], east);
    along[i] = slope(terms_[i], east);
  }
  return {value(across, south), value(along, south), slope(across, south)};
}

Ball PixelPositions::ball(const PixelBlock& part) const {
  const double columns = block_.columns;
  const double rows = block_.rows;
  const double east = (2 * (part.column - block_.column) + part.columns) / columns - 1;
  const double south = (2 * (part.row - block_.row) + part.rows) / rows - 1;
  // These are the shares of the half block from the middle of the part to the centres of its outer
  // pixels.
  const double half_width = (part.columns - 1) / columns;
  const double half_height = (part.rows - 1) / rows;
  const Direction along = half_width * middle_.east;
  const Direction down = half_height * middle_.south;
  const double reach = std::max(length(along + down), length(along - down));
  return {origin_ + position(east, south),
          reach + half_width * east_varies_ + half_height * south_varies_ + off_};
}

PixelPlane PixelPositions::plane(const PixelBlock& part) const {
  const double columns = block_.columns;
  const double rows = block_.rows;
  const double east = (2 * (part.column - block_.column) + part.columns) / columns - 1;
  const double south = (2 * (part.row - block_.row) + part.rows) / rows - 1;
  const Tangent there = tangent(east, south);
  const double half_width = (part.columns - 1) / columns;
  const double half_height = (part.rows - 1) / rows;
  const double bend = half_width * half_width * bends_east_ +
                      2 * half_width * half_height * bends_across_ +
                      half_height * half_height * bends_south_;
  return {origin_ + (there.position - half_width * there.east - half_height * there.south),
          (2 / columns) * there.east, (2 / rows) * there.south, bend / 2 + off_};
}

}  // namespace thiessen
