#include "rainfall/methods/rain_surface.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/natural_neighbours.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/tessellated_surface.h"
#include "rainfall/network/mean_reading.h"

namespace thiessen {
namespace {

SurfaceGauges gauges_of(const Network& network, std::span<const double> readings) {
  const std::vector<double> by_place = readings_by_place(network, readings);
  SurfaceGauges gauges;
  for (std::size_t p = 0; p < by_place.size(); ++p) {
    if (std::isnan(by_place[p])) continue;
    gauges.at.push_back(network.places()[p]);
    gauges.values.push_back(by_place[p]);
  }
  return gauges;
}

class IdwSurface : public RainSurface {
 public:
  IdwSurface(SurfaceGauges gauges, Metric metric)
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
  SurfaceGauges gauges = gauges_of(network, readings);
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
