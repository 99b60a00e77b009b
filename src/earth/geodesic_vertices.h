#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "earth/cell_mesh.h"
#include "earth/equidistance.h"
#include "geometry/box.h"

namespace thiessen {

/// The Voronoi vertices of the ellipsoid near a frame, and the mesh of triangles whose centres they
/// are: see geodesic_diagram. Cost: for each vertex some ten geodesics.
class GeodesicVertices {
 public:
  /// The sphere's tessellation and the places must outlive it. Requires three places.
  GeodesicVertices(const SphereTessellation& sphere, std::span<const Point> places,
                   const Box& frame, unsigned threads);

  const CellMesh& mesh() const { return mesh_; }
  /// Whether one of the triangle's edges comes near the frame; others are left as on the sphere.
  bool is_near(std::uint32_t triangle) const { return vertices_[triangle].is_near; }
  Point position(std::uint32_t triangle) const { return vertices_[triangle].position; }
  /// Triangles whose centres are less than 2 micrometres apart, hand to hand, have one vertex, and
  /// are known by one of them: the first by its corners' coordinates.
  std::uint32_t group_of(std::uint32_t triangle) const;
  /// The edge between the cells of two places.
  GeodesicBisector edge(PlaceIndex first, PlaceIndex second) const {
    return {position(first), position(second), sphere_.bisector(first, second)};
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
  };

  Point position(PlaceIndex p) const { return places_[index(p)]; }
  void place_on_sphere(std::uint32_t triangle);
  void place_on_earth(std::uint32_t triangle);
  void find_near(const Box& frame);
  void flip_sides();
  bool holds_point_across(SideIndex s) const;
  void unite();

  const SphereTessellation& sphere_;
  std::span<const Point> places_;
  CellMesh mesh_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> group_;
};

}  // namespace thiessen
