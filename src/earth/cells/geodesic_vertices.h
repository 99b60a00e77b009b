#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "earth/cells/cell_mesh.h"
#include "earth/cells/geodesic_bisector.h"
#include "geometry/box.h"

namespace thiessen {

/// The Voronoi vertices of the ellipsoid near a frame, and the mesh of triangles whose
/// circumcentres they are; geodesic_diagram tells how they are found. Cost: some ten geodesics for
/// each vertex.
class GeodesicVertices {
 public:
  /// The tessellation of the sphere and the places must outlive it. Requires three places.
  /// `accuracy`: of the vertices and of edges, in metres, at least 1e-6.
  GeodesicVertices(const SphereTessellation& sphere, std::span<const Point> places,
                   const Box& frame, double accuracy, unsigned threads);

  const CellMesh& mesh() const { return mesh_; }
  /// Whether the triangle's vertex lies near the frame; the other vertices stay where they are on
  /// the sphere.
  bool is_near(std::uint32_t triangle) const { return vertices_[triangle].is_near; }
  /// Whether the triangle's vertex is at equal distances of its corners, to the accuracy.
  bool is_exact(std::uint32_t triangle) const { return vertices_[triangle].is_exact; }
  Point position(std::uint32_t triangle) const { return vertices_[triangle].position; }
  Direction direction(std::uint32_t triangle) const { return vertices_[triangle].direction; }
  /// The triangle that stands for all those that share this one's vertex. Triangles joined by steps
  /// between neighbours whose centres are less than twice the accuracy apart have one vertex; the
  /// first of them by its corners' coordinates stands for them.
  std::uint32_t group_of(std::uint32_t triangle) const;
  /// The direction of a place.
  Direction place(PlaceIndex p) const { return sphere_.direction(p); }
  /// The edge between the cells of two places.
  GeodesicBisector edge(PlaceIndex first, PlaceIndex second) const {
    return {earth_point(first), earth_point(second), sphere_.bisector(first, second), accuracy_};
  }
  /// Calls visit(a, b) for every pair of places whose cells have an edge in common. Far from the
  /// frame and at antipodes, where the vertices are the sphere's, it also calls it for the pair
  /// across a side that may be flipped on the ellipsoid.
  template <typename Visit>
  void for_each_neighbours(Visit&& visit) const {
    for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
      const SideIndex s{i};
      if (mesh_.twin(s) < s) continue;
      visit(mesh_.from(s), mesh_.to(s));
      if (may_be_flipped(s)) visit(mesh_.apex(s), mesh_.apex(mesh_.twin(s)));
    }
  }
  /// An edge from its vertex on the right of the way from one place to the other to that on the
  /// left.
  struct Border {
    PlaceIndex left;
    PlaceIndex right;
    std::uint32_t start;  ///< the triangle that stands for the vertex: see group_of
    std::uint32_t end;
  };
  /// The edge across a side of the mesh; nothing where both its ends are one vertex. Both of its
  /// directions are computed as one, so that rounding is the same for any order of places.
  std::optional<Border> border(SideIndex s) const;
  /// The angles along an edge of the vertices at its two ends, the second not before the first.
  std::pair<double, double> angles(const GeodesicBisector& edge, std::uint32_t start,
                                   std::uint32_t end) const;

 private:
  struct Vertex {
    Point position;
    Direction direction;
    double radius = 0;
    bool is_near = false;
    bool is_exact = false;
    bool is_far = false;     ///< at the antipode of the places: see FarSide
    std::uint8_t first = 0;  ///< the first corner by coordinates: see SphereTessellation::in_order
  };

  Point position(PlaceIndex p) const { return places_[index(p)]; }
  EarthPoint earth_point(PlaceIndex p) const { return {position(p), sphere_.direction(p)}; }
  std::array<PlaceIndex, 3> corners_in_order(std::uint32_t triangle) const {
    const std::uint32_t first = vertices_[triangle].first;
    const auto corner = [&](std::uint32_t i) {
      return mesh_.apex(CellMesh::side(triangle, i % 3));
    };
    return {corner(first), corner(first + 1), corner(first + 2)};
  }
  double farthest_off(std::uint32_t triangle) const;
  void place_on_sphere(std::uint32_t triangle);
  bool is_near_frame(const Box& frame, std::uint32_t triangle);
  Point position_near_corner(std::uint32_t triangle) const;
  void place_on_earth(std::uint32_t triangle);
  void lay_far_side_anew();
  void flip_sides();
  bool may_hold_point_across(SideIndex s) const;
  bool holds_point_across(SideIndex s, double margin) const;
  bool is_to_be_flipped(SideIndex s) const;
  bool may_be_flipped(SideIndex s) const;
  void unite();

  const SphereTessellation& sphere_;
  std::span<const Point> places_;
  double accuracy_;
  CellMesh mesh_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> group_;
  std::vector<double> scales_;  // of the sphere, by place
};

}  // namespace thiessen
