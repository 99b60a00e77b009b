#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "earth/sphere/bisector_arc.h"
#include "earth/sphere/conformal_sphere.h"
#include "tessellation/place.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The Delaunay tessellation of places on the conformal sphere. It is that of their projections in
/// a chart whose pole is the first place by coordinates; the pole stands for the point at infinity,
/// so there is no hull and no outside.
class SphereTessellation {
 public:
  /// `places` are longitude and latitude in degrees. Requires at least one, different ones.
  explicit SphereTessellation(std::span<const Point> places);

  /// The tessellation of all places but the pole, in the chart.
  const Tessellation<2>& tessellation() const { return tessellation_; }
  PlaceIndex pole() const { return pole_; }
  PlaceIndex place(PointId p) const { return place_of_[index(p)]; }
  Direction direction(PlaceIndex p) const { return directions_[index(p)]; }
  /// The place that owns each place's cell, by place: itself, or the first by coordinates of a
  /// chain of places less than 1e-13 radians (0.6 micrometres) from one to the next. At less than
  /// that, rounding does not tell on which side of another a place lies.
  const std::vector<PlaceIndex>& cell_of() const { return cell_of_; }
  /// The places whose cells have an edge in common with the place's, and those that rounding does
  /// not tell from it. A place may stand in the list twice.
  std::span<const PlaceIndex> neighbours(PlaceIndex p) const {
    std::call_once(is_connected_, [this] { connect(); });
    const std::size_t first = first_neighbour_[index(p)];
    return std::span(neighbours_).subspan(first, first_neighbour_[index(p) + 1] - first);
  }
  /// The vector from a to b on the sphere. The plain difference of their directions has their
  /// rounding, which turns a chord of length s by 1e-16 / s, so it is taken only where that turn is
  /// below `turned`; otherwise chord_on_sphere computes it.
  Direction chord(PlaceIndex a, PlaceIndex b, double turned) const;
  /// What chords of bisectors and circumcentres may be turned by, in radians.
  static constexpr double turned_at_most = 1e-12;
  /// The great circle between the cells of a and b.
  BisectorArc bisector(PlaceIndex a, PlaceIndex b) const {
    return {direction(a), direction(b), chord(a, b, turned_at_most)};
  }
  /// The circumcentre, as a unit vector, of the triangle a, b, c, which must be counter-clockwise.
  Direction centre(PlaceIndex a, PlaceIndex b, PlaceIndex c) const {
    return unit(cross(chord(a, b, turned_at_most), chord(a, c, turned_at_most)));
  }
  /// Which of a triangle's corners is the first by coordinates.
  std::uint8_t first_corner(const std::array<PlaceIndex, 3>& corners) const;
  /// A triangle's corners, turned to begin with the first by coordinates, so that figures computed
  /// from them are rounded the same for any order of places.
  std::array<PlaceIndex, 3> in_order(std::array<PlaceIndex, 3> corners) const;
  /// The key by which triangles are ordered: their corners' positions, sorted.
  std::array<Point, 3> key_of(const std::array<PlaceIndex, 3>& corners) const;
  /// The square of the chord between a direction and a place.
  double square_distance(Direction p, PlaceIndex place) const {
    const Direction chord = directions_[index(place)] - p;
    return dot(chord, chord);
  }
  /// The nearest place on the sphere. Cost: a walk from `start`, or from the place where the chart
  /// puts p.
  PlaceIndex nearest(Direction p, PlaceIndex start) const;
  PlaceIndex nearest(Direction p) const;
  /// The nearest place on the ellipsoid by Karney's distances, or one of several equally near.
  /// Cost: a walk as for nearest, and a distance for each place that is at most 0.4 % farther on
  /// the sphere than the nearest.
  PlaceIndex nearest_on_earth(Point p) const;

 private:
  template <typename Visit>
  void for_each_edge(Visit&& visit) const;
  template <typename Visit>
  void for_each_link(Visit&& visit) const;
  void tessellate();
  bool merge_indistinct();
  void connect() const;

  std::vector<Point> positions_;
  std::vector<Direction> directions_;
  PlaceIndex pole_;
  StereographicChart chart_;
  Tessellation<2> tessellation_;
  std::vector<PlaceIndex> place_of_;  // by point; the infinite point stands for the pole
  std::vector<PlaceIndex> cell_of_;
  // Neighbours are found when they are first asked for, which often nobody does.
  mutable std::once_flag is_connected_;
  mutable std::vector<std::uint32_t> first_neighbour_;  // by place: where its own begin
  mutable std::vector<PlaceIndex> neighbours_;
};

template <typename Visit>
void SphereTessellation::for_each_edge(Visit&& visit) const {
  if (tessellation_.span() != Span::plane) {
    std::vector<PointId> ring = tessellation_.along_line();
    ring.push_back(infinite_point);
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) {
      visit(place(ring[i]), place(ring[(i + 1) % ring.size()]));
    }
    return;
  }
  const Topology<2>& topology = tessellation_.topology();
  topology.for_each_vertex([&](VertexId v) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (topology.neighbour(v, side) < v) continue;
      const auto& forming = topology.forming(v);
      visit(place(forming[(side + 1) % 3]), place(forming[(side + 2) % 3]));
    }
  });
}

}  // namespace thiessen
