#pragma once

#include <optional>
#include <vector>

#include "basin/ring_linking.h"
#include "geometry/polygon.h"
#include "outlines/mapping.h"
#include "outlines/plane_poles.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// The figures that a caller wants of an edge's course.
enum class Course {
  chords,
  chords_and_bulges,  ///< also the areas between chords and true edges (to 1e-6 of each)
  ends,               ///< its ends alone, but edges that the projection tears apart are still found
};

/// Follows edges that are straight in one system of coordinates, `from`, with chords in another,
/// `to`.
class EdgeTracer {
 public:
  /// `from` and `to` are those of the mapping, which must outlive the tracer. `poles` are those of
  /// `from`, where it is a plane. `chord_error` is how many metres a chord may lie from the true
  /// edge. Bulges require that `to` is WGS 84 longitude and latitude.
  EdgeTracer(const Mapping& mapping, PlanePoles poles, double chord_error, Course course);

  /// Traces a ring in `to`; in degrees, with its turns and the poles that it goes round. A ring
  /// through a pole (within 1e-6 metres) has two points there, at the longitudes on which it comes
  /// and goes. The result is empty where a vertex, or a point on an edge, lies outside the
  /// projection's area; `outside()` is then the first such point, in `from`. An edge that two rings
  /// share is cut at the same points in both, whichever way they run. Cost: two projections for
  /// each vertex, three more for each chord.
  std::optional<WindingRing> trace(const Ring& ring);
  /// Traces edges in degrees within [-180, 180], none of which may run along a pole. Points that
  /// are one point of the Earth (on either side of the antimeridian, or at a pole) become one point
  /// of `to`. The result is empty as for a ring.
  std::optional<std::vector<DirectedEdge>> trace(const std::vector<DirectedEdge>& edges);
  /// The point, in `from`, at which the last tracing left the projection's area.
  Point outside() const { return outside_; }

 private:
  struct Chord;
  struct Node;

  bool is_beside_pole(Point point) const;
  bool see(std::vector<Node>& nodes);
  std::optional<std::vector<Chord>> chords_between(const std::vector<Node>& nodes);
  void find_poles_within(const Ring& ring, const std::vector<Node>& nodes,
                         WindingRing& traced) const;
  bool settle(std::vector<Chord>& chords);
  bool cut(std::vector<Chord>& chords);
  bool fits(Chord& chord, const Point* quarters) const;
  Point metres_at(Point point) const;
  double metres_between(Point a, Point b) const;
  double metres_off(Point a, Point b, Point on) const;

  const Mapping* mapping_;
  CoordinateKind from_;
  CoordinateKind to_;
  double chord_error_;
  Course course_;
  bool wraps_;
  double widest_;     ///< degrees of longitude that a chord may span
  PlanePoles poles_;  ///< poles of `from`, where `to` is in degrees; else none
  Point outside_;
};

}  // namespace thiessen
