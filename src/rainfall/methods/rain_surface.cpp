#include "rainfall/methods/rain_surface.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/natural_neighbours.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/squared_distances.h"
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
      : values_(std::move(gauges.values)),
        nearest_(gauges.at, metric),
        distances_(gauges.at, metric) {}

  Value at(Point position) override {
    nearest_.find(position, InverseDistance::neighbours, {}, near_);
    distances_.from(position, near_, squares_);
    double sum = 0;
    double total = 0;
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const double value = values_[index(near_[k].place)];
      if (squares_[k] == 0) return {value, true};
      // Relative to the nearest, no unit of length makes a weight too large or too small.
      sum += squares_.front() / squares_[k] * value;
      total += squares_.front() / squares_[k];
    }
    return {sum / total, true};
  }

 private:
  std::vector<double> values_;
  NearestGauges nearest_;
  SquaredDistances distances_;
  std::vector<NearestGauges::Near> near_;
  std::vector<double> squares_;
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
