#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "earth/cell_mesh.h"
#include "earth/geodesic_bisector.h"
#include "geometry/box.h"

namespace thiessen {

/// The Voronoi vertices of the ellipsoid near a frame, and the mesh of triangles whose centres they
/// are: see geodesic_diagram. Cost: for each vertex some ten geodesics.
class GeodesicVertices {
 public:
  /// The sphere's tessellation and the places must outlive it. Requires three places. `accuracy`:
  /// of the vertices and of edges, in metres, at least 1e-6.
  GeodesicVertices(const SphereTessellation& sphere, std::span<const Point> places,
                   const Box& frame, double accuracy, unsigned threads);

  const CellMesh& mesh() const { return mesh_; }
  /// Whether the triangle's vertex lies near the frame; others are left as on the sphere.
  bool is_near(std::uint32_t triangle) const { return vertices_[triangle].is_near; }
  /// Whether its vertex is at equal distances of its corners, to the accuracy.
  bool is_exact(std::uint32_t triangle) const { return vertices_[triangle].is_exact; }
  Point position(std::uint32_t triangle) const { return vertices_[triangle].position; }
  Direction direction(std::uint32_t triangle) const { return vertices_[triangle].direction; }
  /// Triangles whose centres are less than twice the accuracy apart, hand to hand, have one vertex,
  /// and are known by one of them: the first by its corners' coordinates.
  std::uint32_t group_of(std::uint32_t triangle) const;
  /// The edge between the cells of two places.
  GeodesicBisector edge(PlaceIndex first, PlaceIndex second) const {
    return {earth_point(first), earth_point(second), sphere_.bisector(first, second), accuracy_};
  }
  /// Calls visit(a, b) for every pair of places whose cells have an edge in common. Far from the
  /// frame and at antipodes, where the vertices are the sphere's, also for those next to a side
  /// that the ellipsoid may have flipped.
  template <typename Visit>
  void for_each_neighbours(Visit&& visit) const {
    for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
      const SideIndex s{i};
      if (mesh_.twin(s) < s) continue;
      visit(mesh_.from(s), mesh_.to(s));
      if (may_be_flipped(s)) visit(mesh_.apex(s), mesh_.apex(mesh_.twin(s)));
    }
  }
  /// Of the vertices at its ends along an edge, the second not before the first.
  std::pair<double, double> angles(const GeodesicBisector& edge, std::uint32_t start,
                                   std::uint32_t end) const;

 private:
  struct Vertex {
    Point position;
    Direction direction;
    double radius = 0;
    bool is_near = false;
    bool is_exact = false;
    bool is_far = false;  ///< at the antipode of the places: see FarSide
  };

  Point position(PlaceIndex p) const { return places_[index(p)]; }
  EarthPoint earth_point(PlaceIndex p) const { return {position(p), sphere_.direction(p)}; }
  double farthest_off(std::uint32_t triangle) const;
  void place_on_sphere(std::uint32_t triangle);
  void place_on_earth(std::uint32_t triangle);
  void lay_far_side_anew();
  void flip_sides();
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
};

}  // namespace thiessen
