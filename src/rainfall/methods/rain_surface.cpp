#include "rainfall/methods/rain_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "geometry/predicates.h"
#include "rainfall/methods/gauge_chart.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/natural_neighbours.h"
#include "rainfall/methods/natural_weights.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/network/mean_reading.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

/// The places that report, with their values.
struct Gauges {
  std::vector<Point> at;
  std::vector<double> values;
};

Gauges gauges_of(const Network& network, std::span<const double> readings) {
  const std::vector<double> by_place = readings_by_place(network, readings);
  Gauges gauges;
  for (std::size_t p = 0; p < by_place.size(); ++p) {
    if (std::isnan(by_place[p])) continue;
    gauges.at.push_back(network.places()[p]);
    gauges.values.push_back(by_place[p]);
  }
  return gauges;
}

class IdwSurface : public RainSurface {
 public:
  IdwSurface(Gauges gauges, Metric metric)
      : values_(std::move(gauges.values)), nearest_(gauges.at, metric) {
    if (metric != Metric::geodesic) return;
    for (const Point p : gauges.at) on_earth_.emplace_back(p);
  }

  Value at(Point position) override {
    nearest_.find(position, InverseDistance::neighbours, {}, near_);
    const EarthPoint here =
        on_earth_.empty() ? EarthPoint(Point{}, Direction{}) : EarthPoint(position);
    double sum = 0;
    double total = 0;
    double least = 0;
    for (const NearestGauges::Near& near : near_) {
      const double square = square_to(near, here);
      if (square == 0) return {values_[index(near.place)], true};
      // Relative to the nearest, no unit of length makes a weight too large or too small.
      if (least == 0) least = square;
      sum += least / square * values_[index(near.place)];
      total += least / square;
    }
    return {sum / total, true};
  }

 private:
  double square_to(const NearestGauges::Near& near, const EarthPoint& here) const {
    constexpr double accuracy = 1;  // metres, of geodesics longer than 1,000 km
    if (on_earth_.empty() || near.square == 0) return near.square;
    const double distance = arrival(on_earth_[index(near.place)], here, accuracy).distance;
    return distance * distance;
  }

  std::vector<double> values_;
  NearestGauges nearest_;
  std::vector<EarthPoint> on_earth_;
  std::vector<NearestGauges::Near> near_;
};

std::vector<ChartPoint> charted(const std::vector<Point>& positions, const GaugeChart& chart) {
  std::vector<ChartPoint> points;
  points.reserve(positions.size());
  for (const Point p : positions) points.push_back(chart.at(p));
  return points;
}

/// The mean value of the gauges that have each number: several where rounding cannot tell them
/// apart.
std::vector<double> values_by_number(std::span<const PointId> numbers,
                                     std::span<const double> values) {
  std::vector<double> sums;
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t number = index(numbers[i]);
    if (number >= sums.size()) {
      sums.resize(number + 1, 0);
      counts.resize(number + 1, 0);
    }
    sums[number] += values[i];
    ++counts[number];
  }
  for (std::size_t n = 0; n < sums.size(); ++n) {
    if (counts[n] > 0) sums[n] /= static_cast<double>(counts[n]);
  }
  return sums;
}

class NaturalSurface : public RainSurface {
 public:
  NaturalSurface(const Gauges& gauges, Metric metric)
      : chart_(gauges.at, metric),
        natural_(charted(gauges.at, chart_), chart_.is_of_earth()),
        values_(values_by_number(natural_.numbers(), gauges.values)),
        nearest_(gauges.at, metric),
        gauge_values_(gauges.values) {}

  Value at(Point position) override {
    if (!natural_.find(chart_.at(position), weights_)) return {nearest_value(position), false};
    double sum = 0;
    double total = 0;
    for (const NaturalWeight& w : weights_) {
      sum += w.weight * values_[index(w.gauge)];
      total += w.weight;
    }
    return {sum / total, true};
  }

  void begin_anew() override { natural_.begin_anew(); }

  double nearest_value(Point position) {
    nearest_.find(position, 1, {}, near_);
    return gauge_values_[index(near_.front().place)];
  }
  const GaugeChart& chart() const { return chart_; }

 private:
  GaugeChart chart_;
  NaturalWeights natural_;
  std::vector<double> values_;  // by number
  NearestGauges nearest_;
  std::vector<double> gauge_values_;
  std::vector<NaturalWeight> weights_;
  std::vector<NearestGauges::Near> near_;
};

class LinearSurface : public RainSurface {
 public:
  LinearSurface(const Gauges& gauges, Metric metric) : natural_(gauges, metric) {
    std::vector<Point> at;
    for (const ChartPoint& point : charted(gauges.at, natural_.chart())) at.push_back(point.at);
    values_ = values_by_number(triangles_.add_all(at), gauges.values);
  }

  Value at(Point position) override {
    // On a line natural neighbours are linear already.
    if (triangles_.span() != Span::plane) return natural_.at(position);
    const Point point = natural_.chart().at(position).at;
    if (!in_exact_range(point)) return {natural_.nearest_value(position), false};
    const VertexId triangle = triangles_.locate(point, near_);
    const auto& corners = triangles_.topology().forming(triangle);
    for (const PointId p : corners) {
      if (p != infinite_point) near_ = p;
    }
    if (triangles_.topology().is_infinite(triangle))
      return {natural_.nearest_value(position), false};
    return {in_triangle(point, corners), true};
  }

  void begin_anew() override {
    natural_.begin_anew();
    near_.reset();
  }

 private:
  template <typename Corners>
  double in_triangle(Point point, const Corners& corners) const {
    double sum = 0;
    double total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double across =
          std::max(0.0, doubled_area(point, triangles_.position(corners[(i + 1) % 3]),
                                     triangles_.position(corners[(i + 2) % 3])));
      sum += across * values_[index(corners[i])];
      total += across;
    }
    return total > 0 ? sum / total : values_[index(corners[0])];
  }

  NaturalSurface natural_;
  Tessellation<2> triangles_;
  std::vector<double> values_;  // by number
  std::optional<PointId> near_;
};

}  // namespace

const char* name_of(SurfaceMethod method) {
  switch (method) {
    case SurfaceMethod::idw:
      return InverseDistance::name;
    case SurfaceMethod::natural:
      return NaturalNeighbours::name;
    case SurfaceMethod::linear:
      return "linear";
  }
  throw std::logic_error("not a method");
}

std::unique_ptr<RainSurface> surface_of(SurfaceMethod method, const Network& network, Metric metric,
                                        std::span<const double> readings) {
  Gauges gauges = gauges_of(network, readings);
  switch (method) {
    case SurfaceMethod::idw:
      return std::make_unique<IdwSurface>(std::move(gauges), metric);
    case SurfaceMethod::natural:
      return std::make_unique<NaturalSurface>(gauges, metric);
    case SurfaceMethod::linear:
      return std::make_unique<LinearSurface>(gauges, metric);
  }
  throw std::logic_error("not a method");
}

}  // namespace thiessen
