#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <span>
#include <vector>

#include "earth/cell_mesh.h"
#include "earth/geodesic_bisector.h"

namespace thiessen {

/// The far side of a network that is small against the Earth: round its antipode, where distances
/// to its places hardly differ, their shortest paths come from all sides, and Newton's method loses
/// its way. There the cells of the outermost places meet in a tree of edges, which is another one
/// than the sphere's: along the cut locus, 130 km from end to end at the equator, paths from the
/// north and from the south are equally long. It is found by cutting ears: of three cells side by
/// side the middle one ends where its two edges meet, if no other place is nearer to that point.
class FarSide {
 public:
  /// As far from three places, in metres.
  struct Meeting {
    Point position;
    double radius;
  };
  /// A vertex of the far side, and the triangle whose it is.
  struct Vertex {
    std::uint32_t triangle;
    Meeting at;
  };
  /// Where a triangle outside the far side has its vertex.
  using DirectionOf = std::function<Direction(std::uint32_t triangle)>;

  FarSide(const SphereTessellation& sphere, std::span<const Point> places, double accuracy,
          CellMesh& mesh)
      : sphere_(sphere), places_(places), accuracy_(accuracy), mesh_(mesh) {}

  /// Lays those triangles anew, which must hang together without a hole. Positions are right as far
  /// as every point near them is in the right cell: distances agree to 1e-4 metres or so. Empty,
  /// and nothing changed, where a vertex is not found. Cost: for k triangles some 3 k searches of a
  /// few hundred geodesics each, and k^2 distances at most.
  std::vector<Vertex> lay_anew(const std::vector<std::uint32_t>& triangles,
                               const DirectionOf& direction_of);

 private:
  /// A side of the polygon that is left, with its inside to the left.
  struct OpenSide {
    PlaceIndex from;
    PlaceIndex to;
    SideIndex outside;
    double angle = 0;  ///< along its bisector: where the edge comes in
    /// Where the cells of `from`, `to` and of the next side's `to` would meet.
    std::optional<Meeting> meeting;
  };
  /// A triangle cut off, and what its sides are to be joined to: nothing where the triangle beyond
  /// is to come.
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
