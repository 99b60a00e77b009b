#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "geometry/coordinates.h"
#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "tessellation/audit.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// For typed tests: in the plane and in space.
template <typename Constant>
class InDimension : public testing::Test {
 public:
  static constexpr int dimension = Constant::value;
};
using PlaneAndSpace =
    testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

template <int Dimension>
PositionIn<Dimension> position_of(const CoordinatesIn<Dimension>& c) {
  if constexpr (Dimension == 2) {
    return {c[0], c[1]};
  } else {
    return {c[0], c[1], c[2]};
  }
}

template <int Dimension>
PositionIn<Dimension> infinite_position() {
  CoordinatesIn<Dimension> c;
  c.fill(std::numeric_limits<double>::infinity());
  return position_of<Dimension>(c);
}

/// A simplex by its points' positions, which no order of operations changes: the infinite point is
/// at infinity in every coordinate, and so are the corners that a lower span does without; they are
/// in order, but for the last two of the span's where its orientation asks for it.
template <int Dimension>
using PlainSimplexIn = std::array<PositionIn<Dimension>, std::size_t{Dimension} + 1>;
using PlainSimplex = PlainSimplexIn<2>;

/// Sorts the first `count`; returns whether an odd number of swaps did it.
template <typename Corners>
bool sort_corners(Corners& corners, std::size_t count) {
  bool odd = false;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = i; k > 0 && corners[k] < corners[k - 1]; --k) {
      std::swap(corners[k], corners[k - 1]);
      odd = !odd;
    }
  }
  return odd;
}

/// All of them in order, with their orientation.
template <int Dimension>
std::vector<PlainSimplexIn<Dimension>> plain_simplices(
    const Tessellation<Dimension>& tessellation) {
  const Topology<Dimension>& topology = tessellation.topology();
  const auto corners = static_cast<std::size_t>(topology.dimension() + 1);
  std::vector<PlainSimplexIn<Dimension>> simplices;
  topology.for_each_vertex([&](VertexId v) {
    PlainSimplexIn<Dimension> simplex;
    simplex.fill(infinite_position<Dimension>());
    for (std::size_t i = 0; i < corners; ++i) {
      const PointId p = topology.forming(v)[i];
      if (p != infinite_point) simplex[i] = tessellation.position(p);
    }
    const bool odd = sort_corners(simplex, corners);
    if (odd && corners > 1) std::swap(simplex[corners - 1], simplex[corners - 2]);
    simplices.push_back(simplex);
  });
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

/// Those without the infinite point.
template <int Dimension>
std::size_t count_finite(const Tessellation<Dimension>& tessellation) {
  std::size_t count = 0;
  const Topology<Dimension>& topology = tessellation.topology();
  topology.for_each_vertex([&](VertexId v) { count += topology.is_infinite(v) ? 0u : 1u; });
  return count;
}

template <int Dimension>
std::vector<PositionIn<Dimension>> positions_of(const Tessellation<Dimension>& tessellation) {
  std::vector<PositionIn<Dimension>> positions;
  tessellation.for_each_point([&](PointId p) { positions.push_back(tessellation.position(p)); });
  std::sort(positions.begin(), positions.end());
  return positions;
}

/// Too long to be printed.
struct Bits {
  std::string bytes;

  friend bool operator==(const Bits&, const Bits&) = default;
  friend void PrintTo(const Bits& bits, std::ostream* stream) {
    *stream << bits.bytes.size() << " bytes";
  }
};

/// The structure bit for bit: every row, free ones too, every point's number and position, and what
/// holds for the whole.
template <int Dimension>
Bits bits_of(const Structure<Dimension>& structure) {
  Bits bits;
  const auto append = [&](const auto& value) {
    const char* begin = reinterpret_cast<const char*>(&value);
    bits.bytes.append(begin, sizeof value);
  };
  const Topology<Dimension>& topology = structure.topology();
  const auto& state = topology.state();
  append(state.dimension);
  append(state.rows);
  append(state.first_free);
  append(state.points);
  append(state.points_there);
  append(state.first_free_point);
  append(structure.dropped());
  for (std::uint32_t i = 0; i < topology.size(); ++i) append(topology.row(VertexId{i}));
  for (std::uint32_t i = 0; i < topology.point_limit(); ++i) {
    append(topology.vertex_of(PointId{i}));
    append(structure.position(PointId{i}));
  }
  return bits;
}

template <int Dimension>
std::string in_words(const PositionIn<Dimension>& position) {
  std::string words;
  for (const double c : coordinates(position)) words += " " + testing::PrintToString(c);
  return words;
}

template <int Dimension>
void expect_sound(const Tessellation<Dimension>& tessellation) {
  const std::vector<Finding<Dimension>> findings = audit(tessellation);
  for (std::size_t i = 0; i < findings.size() && i < 5; ++i) {
    ADD_FAILURE() << name_of(findings[i].fault) << " near"
                  << in_words<Dimension>(findings[i].position);
  }
}

template <int Dimension>
Tessellation<Dimension> tessellation_of(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  tessellation.add_all(points);
  return tessellation;
}
inline Tessellation<2> tessellation_of(const std::vector<Point>& points) {
  return tessellation_of<2>(points);
}
inline Tessellation<3> tessellation_of(const std::vector<SpacePoint>& points) {
  return tessellation_of<3>(points);
}

template <typename Position>
std::vector<Position> distinct(std::vector<Position> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The nearest of the points, the first by coordinates of equally near ones, by looking at each.
template <typename Position>
std::optional<Position> nearest_one_by_one(const std::vector<Position>& points,
                                           const Position& to) {
  std::optional<Position> best;
  for (const Position& p : points) {
    const int order = best ? compare_distance(to, p, *best) : -1;
    if (order < 0 || (order == 0 && p < *best)) best = p;
  }
  return best;
}

}  // namespace thiessen
