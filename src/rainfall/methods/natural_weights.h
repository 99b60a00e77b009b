#pragma once

#include <span>
#include <vector>

#include "rainfall/methods/gauge_chart.h"
#include "rainfall/methods/plane_stolen_areas.h"
#include "rainfall/methods/sphere_stolen_areas.h"
#include "tessellation/history.h"

namespace thiessen {

/// The weight of a gauge at a point.
struct NaturalWeight {
  PointId gauge;
  double weight;
};

/// Sibson's natural neighbour coordinates of points among gauges: the weight of a gauge is the area
/// that the point, if it were a gauge, would take from the gauge's cell (R. Sibson, A brief
/// description of natural neighbour interpolation, 1981). In the plane the weighted mean of the
/// gauges' positions is the point itself.
///
/// Planar: the topology is exact. Geodesic: the topology is that of the conformal sphere and areas
/// are the sphere's; see GaugeChart. On an edge of the hull, and between gauges that all lie on one
/// line, the two gauges on either side weigh, linearly with distance: in the plane this is the
/// limit of the coordinates there; on the Earth, where a cell ends before the other side, only
/// nearly so. At a gauge, that gauge has all the weight. Outside the hull there are no weights, and
/// so none anywhere off the line if all gauges lie on one. Gauges all round the Earth have no hull.
///
/// Accuracy: planar 1e-12 (see the test). Geodesic, against the areas of the ellipsoid's own cells:
/// 1e-4 where gauges are 100 km apart, and in proportion to that distance. Cost: 0.3 microseconds a
/// point that lies near the point before. Not safe for several threads: each needs an object of its
/// own, and a copy is independent.
class NaturalWeights {
 public:
  /// Numbers the gauges; those on one point of the chart get the same number. In a chart of the
  /// whole Earth the gauge at infinity has the infinite point's.
  NaturalWeights(std::span<const ChartPoint> gauges, ChartKind kind);

  ChartKind kind() const { return kind_; }
  /// The number of each gauge, in the order in which they were given.
  const std::vector<PointId>& numbers() const { return numbers_; }
  /// The tessellation of the gauges in the chart, and the direction of each on the sphere.
  const Tessellation<2>& tessellation() const { return tessellation_; }
  Direction direction(PointId gauge) const { return directions_[index(gauge)]; }

  /// Forgets where the last point was, for the last bits of weights may depend on it.
  void begin_anew() { last_ = no_vertex; }
  /// Has the next search begin at a gauge that is there, wherever the last point was.
  void begin_at(PointId gauge) {
    last_ =
        tessellation_.span() == Span::plane ? tessellation_.topology().vertex_of(gauge) : no_vertex;
  }
  /// Finds the weights at a point, which add up to 1. Outside the hull it returns false and gives
  /// none.
  bool find(const ChartPoint& point, std::vector<NaturalWeight>& weights);

  /// Whether the gauges that are there stand all round the Earth, so that there is no hull.
  /// Requires a chart of the whole Earth. Cost: that of all vertices.
  bool close_round_the_earth() const;

  /// Does `work` while some gauges are deleted; they are back afterwards. `silent` holds their
  /// numbers, each once, without the infinite point. In a chart of the whole Earth `work` may only
  /// look for weights where the others still stand all round it. Cost: that of the deletions, and
  /// in such a chart that of all vertices.
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

  ChartKind kind_;
  Tessellation<2> tessellation_;
  std::vector<PointId> numbers_;
  std::vector<Direction> directions_;  // by number
  PlaneStolenAreas plane_;
  SphereStolenAreas sphere_;
  VertexId last_ = no_vertex;  // near the last point, where the next search begins
  Trial<2>::Changes changes_;
  ConflictZone<2> zone_;
  std::vector<StolenArea> stolen_;
};

}  // namespace thiessen
