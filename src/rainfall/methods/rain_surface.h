#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "earth/yardstick.h"
#include "geometry/point.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// How rainfall between gauges is told, other than by cells.
enum class SurfaceMethod : std::uint8_t { idw, natural, linear };

const char* name_of(SurfaceMethod method);

/// The rainfall of one time at any point, from the gauges that report then. Gauges at one place
/// count as one, with the mean reading of those that report. An object serves one thread.
class RainSurface {
 public:
  struct Value {
    double rainfall;
    /// Whether the point lies among the gauges: in their hull, for methods that have one. Beyond it
    /// the nearest gauge counts.
    bool is_among_gauges;
  };

  virtual ~RainSurface() = default;
  /// The value at a point in the study's coordinates.
  virtual Value at(Point position) = 0;
  /// The value at a point, as the surface goes on smoothly from the gauges' hull where the point
  /// lies beyond it: what a line of equal value that ends on the hull is led up to. Near the hull
  /// it goes on in a straight line, further away it is the value on the edge.
  virtual Value continued(Point position) { return at(position); }
  /// Forgets where the last point was, near which the next is looked for: the last bits of values
  /// may depend on it.
  virtual void begin_anew() {}
};

/// The surface of some readings: one for each station, NaN where it is silent. Requires one that
/// reports.
///
/// - idw: inverse distance squared of the 12 nearest gauges, as InverseDistance has it;
/// - natural: Sibson's natural neighbours, as NaturalNeighbours has it;
/// - linear: linear in each Delaunay triangle of the gauges; on the Earth in the flat triangle
///   between the three, as its points are seen from the middle of the conformal sphere. Gauges that
///   all lie on one line have no triangles: only on the line is the surface linear, elsewhere that
///   of the nearest gauge.
///
/// Natural and linear reproduce a plane of rainfall within the hull. Gauges all round the Earth
/// have no hull (see GaugeChart), and nothing lies beyond it. Cost: n log n for n gauges; then a
/// microsecond a point or less, for idw on the Earth 2.
std::unique_ptr<RainSurface> surface_of(SurfaceMethod method, const Network& network, Metric metric,
                                        std::span<const double> readings);

}  // namespace thiessen
