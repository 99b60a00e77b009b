#include "rainfall/normals/elevation_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

/// The number of the last node at or before a position.
std::int64_t node_before(double position, std::size_t apart) {
  return static_cast<std::int64_t>(std::floor(position / static_cast<double>(apart)));
}

std::uint64_t key_of(ElevationPatch::Corner node) {
  return static_cast<std::uint64_t>(node.column) << 32U ^
         (static_cast<std::uint64_t>(node.row) & 0xffffffffU);
}

/// What is bilinear between nodes.
struct Blend {
  double constant;
  double slope;
  double nearest;
};

Blend between(const ToldNormal& a, const ToldNormal& b, double along) {
  const auto mix = [&](double from, double to) { return from + along * (to - from); };
  return {mix(a.line.constant, b.line.constant), mix(a.line.slope, b.line.slope),
          mix(a.nearest, b.nearest)};
}

ToldNormal nothing_told() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {{none, none, {none, none, none}}, none};
}

}  // namespace

void ElevationPatch::fill(const Row& row, std::span<const double> elevations,
                          std::span<const double> spreads, std::span<double> normals,
                          std::span<char> held) const {
  const std::int64_t above = node_before(row.first.y, rows_apart_);
  const auto j = static_cast<std::size_t>(above - first_node_.row);
  const double down = row.first.y / static_cast<double>(rows_apart_) - static_cast<double>(above);
  const auto apart = static_cast<double>(columns_apart_);
  const double step = row.apart / apart;
  for (std::size_t month = 0; month < months_; ++month) {
    const std::span<double> out = normals.subspan(month * elevations.size(), elevations.size());
    for (std::size_t c = 0; c < elevations.size();) {
      const double at = row.first.x + row.apart * static_cast<double>(c);
      const std::int64_t before = node_before(at, columns_apart_);
      const auto i = static_cast<std::size_t>(before - first_node_.column);
      const Blend left = between(node(i, j, month), node(i, j + 1, month), down);
      const Blend right = between(node(i + 1, j, month), node(i + 1, j + 1, month), down);
      double along = at / apart - static_cast<double>(before);
      do {
        const auto mix = [&](double from, double to) { return from + along * (to - from); };
        const double slope = mix(left.slope, right.slope);
        const double logarithm = mix(left.constant, right.constant) + slope * elevations[c];
        const double kept = held_logarithm(logarithm, mix(left.nearest, right.nearest));
        if (kept < logarithm || kept > logarithm) held[c] = 1;
        out[c] = std::exp(kept) * (1 + slope * slope * spreads[c] / 2);
        ++c;
        along += step;
      } while (c < elevations.size() && along < 1);
    }
  }
}

double ElevationPatch::variance(Point at, double elevation, std::size_t month) const {
  const auto nearest = [](double position, std::size_t apart, std::int64_t first) {
    return static_cast<std::size_t>(std::llround(position / static_cast<double>(apart)) - first);
  };
  return node(nearest(at.x, columns_apart_, first_node_.column),
              nearest(at.y, rows_apart_, first_node_.row), month)
      .line.variance(elevation);
}

ElevationLattice::ElevationLattice(const ElevationFit& fit, ToStudy to_study,
                                   std::size_t columns_apart, std::size_t rows_apart,
                                   unsigned threads)
    : fit_(fit),
      to_study_(std::move(to_study)),
      columns_apart_(columns_apart),
      rows_apart_(rows_apart),
      threads_(threads) {}

ElevationPatch ElevationLattice::over(ElevationPatch::Corner corner, std::size_t columns,
                                      std::size_t rows) {
  ElevationPatch patch;
  patch.columns_apart_ = columns_apart_;
  patch.rows_apart_ = rows_apart_;
  patch.months_ = fit_.months();
  patch.first_node_ = {node_before(static_cast<double>(corner.column), columns_apart_),
                       node_before(static_cast<double>(corner.row), rows_apart_)};
  const ElevationPatch::Corner last{
      node_before(static_cast<double>(corner.column) + static_cast<double>(columns),
                  columns_apart_) +
          1,
      node_before(static_cast<double>(corner.row) + static_cast<double>(rows), rows_apart_) + 1};
  patch.nodes_in_row_ = static_cast<std::size_t>(last.column - patch.first_node_.column + 1);
  std::vector<ElevationPatch::Corner> nodes;
  for (std::int64_t row = patch.first_node_.row; row <= last.row; ++row) {
    for (std::int64_t column = patch.first_node_.column; column <= last.column; ++column)
      nodes.push_back({column, row});
  }
  compute(nodes);
  for (const ElevationPatch::Corner node : nodes) {
    const auto first = told_.begin() + static_cast<std::ptrdiff_t>(known_.at(key_of(node)));
    patch.nodes_.insert(patch.nodes_.end(), first,
                        first + static_cast<std::ptrdiff_t>(fit_.months()));
  }
  return patch;
}

void ElevationLattice::compute(const std::vector<ElevationPatch::Corner>& nodes) {
  const std::size_t first = told_.size();
  std::vector<Point> positions;
  for (const ElevationPatch::Corner node : nodes) {
    const std::size_t begin = first + positions.size() * fit_.months();
    if (!known_.emplace(key_of(node), begin).second) continue;
    positions.push_back({static_cast<double>(node.column) * static_cast<double>(columns_apart_),
                         static_cast<double>(node.row) * static_cast<double>(rows_apart_)});
  }
  positions = to_study_(std::move(positions));
  told_.resize(first + positions.size() * fit_.months(), nothing_told());
  in_parallel(positions.size(), threads_, [&](std::size_t, std::size_t i) {
    if (!is_finite(positions[i])) return;
    fit_.at(positions[i], std::span(told_).subspan(first + i * fit_.months(), fit_.months()));
  });
}

}  // namespace thiessen
