#pragma once

#include <optional>
#include <vector>

#include "rainfall/methods/gauge_chart.h"
#include "rainfall/methods/natural_weights.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen {

/// Places that report, all different, with their values.
struct SurfaceGauges {
  std::vector<Point> at;
  std::vector<double> values;
};

/// What surfaces by the gauges' Delaunay tessellation have in common: the tessellation and its
/// hull, beyond which the nearest gauge counts.
class TessellatedSurface : public RainSurface {
 public:
  TessellatedSurface(const SurfaceGauges& gauges, Metric metric);

  Value at(Point position) override;
  Value continued(Point position) override;
  void begin_anew() override;

 protected:
  /// The value at a point of the chart, or nothing where that lies beyond the hull.
  virtual std::optional<double> among_gauges(const ChartPoint& point) = 0;
  std::optional<double> natural_value(const ChartPoint& point);
  /// Whether values tend to those between the two gauges at an edge of the hull as a point comes
  /// near it.
  virtual bool tends_to_edge() const = 0;

  ChartKind kind() const { return chart_.kind(); }
  const NaturalWeights& natural() const { return natural_; }
  const Tessellation<2>& triangles() const { return natural_.tessellation(); }
  double value_of(PointId gauge) const { return values_[index(gauge)]; }
  /// The vertex in whose triangle a point of the chart lies. Requires that they span the plane, and
  /// a point in the exact range.
  VertexId locate(Point in_chart);

 private:
  /// The point of the hull's edge that is nearest to one beyond it.
  struct OnHull {
    Point at;
    double value;
    double square;  // of the distance
  };
  std::optional<double> value_at_mirror(Point point, const OnHull& edge, double times);
  OnHull nearest_on_edge(VertexId outside, Point point) const;
  OnHull nearest_on_hull(Point point);
  double nearest_value(Point position);

  GaugeChart chart_;
  NaturalWeights natural_;
  std::vector<double> values_;  // by number
  NearestGauges nearest_;
  std::vector<double> gauge_values_;
  std::optional<PointId> last_;  // near the last point
  std::vector<NaturalWeight> weights_;
  std::vector<NearestGauges::Near> near_;
};

/// Sibson's natural neighbours (see NaturalWeights).
class NaturalSurface : public TessellatedSurface {
 public:
  using TessellatedSurface::TessellatedSurface;

 private:
  std::optional<double> among_gauges(const ChartPoint& point) override {
    return natural_value(point);
  }
  bool tends_to_edge() const override { return false; }
};

/// Linear in each triangle of gauges (see surface_of).
class LinearSurface : public TessellatedSurface {
 public:
  using TessellatedSurface::TessellatedSurface;

 private:
  std::optional<double> among_gauges(const ChartPoint& point) override;
  /// On the Earth flat triangles reach as far as great circles, a little beyond the chart's edges.
  bool tends_to_edge() const override { return kind() == ChartKind::plane; }
};

}  // namespace thiessen
