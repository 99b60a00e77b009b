#pragma once

#include <span>
#include <vector>

#include "rainfall/methods/gauge_chart.h"
#include "rainfall/methods/plane_stolen_areas.h"
#include "rainfall/methods/sphere_stolen_areas.h"
#include "tessellation/history.h"

namespace thiessen {

/// A gauge's part at a point.
struct NaturalWeight {
  PointId gauge;
  double weight;
};

/// Sibson's coordinates of points among gauges: a gauge weighs as the area that the point, if it
/// were a gauge, would take from its cell (R. Sibson, A brief description of natural neighbour
/// interpolation, 1981). In the plane the weighted positions give back the point.
///
/// Planar: the topology is exact. Geodesic: that of the conformal sphere, and areas are the
/// sphere's; see GaugeChart. On an edge of the hull, and between gauges that are all on one line,
/// the two on either side weigh, linearly; it is what the coordinates tend to there. At a gauge it
/// has all the weight. Outside the hull, so anywhere off the line of gauges that are on one, there
/// are none.
/// Accuracy: planar 1e-12 (see the test); geodesic, against the areas of the ellipsoid's own cells,
/// 1e-4 where gauges are 100 km apart, and in proportion to that distance. Cost: 0.3 microseconds a
/// point where the one before is near. One for each thread; a copy is independent.
class NaturalWeights {
 public:
  /// Gauges on one point of the chart get one number.
  NaturalWeights(std::span<const ChartPoint> gauges, bool is_of_earth);

  /// The number of each gauge.
  const std::vector<PointId>& numbers() const { return numbers_; }

  /// Forgets where the last point was, on which the last bits of weights may depend.
  void begin_anew() { last_ = no_vertex; }
  /// False, and no weights, outside the hull. They add up to 1.
  bool find(const ChartPoint& point, std::vector<NaturalWeight>& weights);

  /// Does `work` without some of the gauges, which are back afterwards. `silent`: numbers, each
  /// once. Cost: the deletions', and on the sphere its vertices'.
  template <typename Work>
  void without(std::span<const PointId> silent, Work&& work) {
    {
      const Trial<2> trial(tessellation_, changes_);
      for (const PointId p : silent) tessellation_.remove(p);
      take_vertices();
      work();
    }
    take_vertices();
  }

 private:
  void take_vertices();
  bool find_in_plane(const ChartPoint& point, std::vector<NaturalWeight>& weights);
  bool find_on_edge(Point point, PointId a, PointId b, std::vector<NaturalWeight>& weights) const;
  void share_stolen(std::vector<NaturalWeight>& weights);

  bool is_of_earth_;
  Tessellation<2> tessellation_;
  std::vector<PointId> numbers_;
  std::vector<Direction> directions_;  // by number
  PlaneStolenAreas plane_;
  SphereStolenAreas sphere_;
  VertexId last_ = no_vertex;  // where the last point was
  Trial<2>::Changes changes_;
  ConflictZone<2> zone_;
  std::vector<StolenArea> stolen_;
};

}  // namespace thiessen
