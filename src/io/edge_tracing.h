#pragma once

#include <optional>
#include <vector>

#include "geometry/polygon.h"
#include "io/crs.h"

namespace thiessen {

/// A ring whose edges are straight in one CRS, as it runs in another.
struct TracedRing {
  Ring ring;
  /// For each edge of `ring`, the area in square metres between the true edge and the chord,
  /// positive where the true edge lies to the chord's right. Only where it was asked for.
  std::vector<double> bulges;
};

/// Follows edges that are straight in `from` with chords in `to`.
class EdgeTracer {
 public:
  /// `chord_error`: metres that a chord may lie from the true edge. `bulges`: `to` is WGS 84
  /// longitude and latitude, and the areas between are wanted (to 1e-6 of each).
  EdgeTracer(const Crs& from, const Crs& to, double chord_error, bool bulges);

  /// Nothing where a vertex, or a point on an edge, lies outside the projection's area: then
  /// `outside()` is the first such point, in `from`. Longitudes run on over the antimeridian. An
  /// edge that two rings share is cut at the same points in both, whichever way they run. Cost: for
  /// each vertex two projections, for each chord three more.
  std::optional<TracedRing> trace(const Ring& ring);
  Point outside() const { return outside_; }

 private:
  struct Chord;

  bool cut(std::vector<Chord>& chords);
  double metres_off(Point a, Point b, Point on) const;

  Transformation transformation_;
  Crs to_;
  double chord_error_;
  bool bulges_;
  bool wraps_;
  Point outside_;
};

}  // namespace thiessen
