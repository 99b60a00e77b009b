#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// The edges of a shape in longitude and latitude that span more than 180 degrees, by what they are
/// taken for. Edges along a pole have no length and are not among them.
struct WideEdges {
  struct Edge {
    Point from;
    Point to;
  };
  std::vector<Edge> unclear;    ///< which way they go is not known: up to 270 degrees
  std::vector<Edge> short_way;  ///< beyond 270 degrees: they go over the antimeridian
  std::vector<Edge> circles;    ///< along a whole parallel
  std::vector<Edge> one_point;  ///< their ends are one repeated point

  /// Words the first unclear edge and how many more there are; empty where there is none.
  std::string fault() const;
  /// Words what was taken for what, an entry a kind; none where nothing was assumed.
  std::vector<std::string> assumptions() const;
};

/// Reads a ring in longitude and latitude (degrees), whose last point does not repeat the first, as
/// its author meant it, and adds to `found` what had to be assumed. An edge goes as written up to
/// 180 degrees, and the short way beyond 270; in between it is unclear. An edge along a parallel
/// between points whole turns apart is a circle where the ring would have no area without it (a
/// band between two parallels, a cap), and else one repeated point.
WindingRing ring_as_meant(const Ring& ring, WideEdges& found);

}  // namespace thiessen
