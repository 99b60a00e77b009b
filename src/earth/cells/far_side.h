#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <span>
#include <vector>

#include "earth/cells/cell_mesh.h"
#include "earth/cells/geodesic_bisector.h"

namespace thiessen {

/// The far side of a network that is small against the Earth: the surroundings of its antipode.
/// Distances to its places hardly differ there, their shortest paths come from all sides, and
/// Newton's method may fail to converge. The cells of the outermost places meet there in a tree of
/// edges, which differs from the sphere's: along the cut locus, 130 km from end to end at the
/// equator, paths from the north and from the south are equally long. The tree is found by cutting
/// ears: of three cells side by side the middle one ends where its two edges meet, if no other
/// place is nearer to that point.
class FarSide {
 public:
  /// A point at the same distance, `radius` in metres, from three places.
  struct Meeting {
    Point position;
    double radius;
  };
  /// A vertex of the far side, and the triangle that it belongs to.
  struct Vertex {
    std::uint32_t triangle;
    Meeting at;
  };
  /// Gives the direction of the vertex of a triangle outside the far side.
  using DirectionOf = std::function<Direction(std::uint32_t triangle)>;

  /// The tessellation, the places (longitude and latitude in degrees) and the mesh must outlive it.
  /// `accuracy`: of the bisectors, in metres.
  FarSide(const SphereTessellation& sphere, std::span<const Point> places, double accuracy,
          CellMesh& mesh)
      : sphere_(sphere), places_(places), accuracy_(accuracy), mesh_(mesh) {}

  /// Lays the given triangles of the mesh anew and returns their vertices. Requires triangles in
  /// rising order that hang together without a hole. Positions are right in so far as every point
  /// near them is in the right cell: distances agree to 1e-4 metres or so. The result is empty, and
  /// the mesh unchanged, where a vertex is not found. Cost: for k triangles some 3 k searches of a
  /// few hundred geodesics each, and k^2 distances at most.
  std::vector<Vertex> lay_anew(const std::vector<std::uint32_t>& triangles,
                               const DirectionOf& direction_of);

 private:
  /// A side of the polygon that is still to be filled, with the inside to its left.
  struct OpenSide {
    PlaceIndex from;
    PlaceIndex to;
    SideIndex outside;
    double angle = 0;  ///< radians along its bisector to where the edge enters
    /// The point where the cells of `from`, of `to` and of the next side's `to` would meet.
    std::optional<Meeting> meeting;
  };
  /// A triangle that has been cut off, and the sides that its own are to be joined to; a side is
  /// empty where the triangle beyond is still to come.
  struct Ear {
    Vertex vertex;
    std::array<PlaceIndex, 3> corners;
    std::array<std::optional<SideIndex>, 3> outside;
  };
  using Polygon = std::list<OpenSide>;
  using Place = Polygon::iterator;

  Point position(PlaceIndex p) const { return places_[index(p)]; }
  GeodesicBisector bisector(const OpenSide& side) const;
  Polygon boundary_of(const std::vector<std::uint32_t>& triangles, const DirectionOf& direction_of);
  Place next(Place side);
  void find_meeting(Place side);
  bool is_ear(Place side) const;
  std::optional<Place> find_ear();
  Ear cut(Place first, std::uint32_t triangle);

  const SphereTessellation& sphere_;
  std::span<const Point> places_;
  double accuracy_;
  CellMesh& mesh_;
  Polygon polygon_;
};

}  // namespace thiessen
