#include "rainfall/errors/field_model.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "earth/sphere/units.h"
#include "rainfall/errors/distance_classes.h"
#include "rainfall/errors/variogram_fit.h"

namespace thiessen {
namespace {

/// A distance that is longer than any between two gauges, or between a gauge and a basin.
double longest_distance(const Weighing& weighing) {
  if (weighing.yardstick().metric == Metric::geodesic) return 2.1 * mean_radius;
  Box box = weighing.frame();
  for (const Point p : weighing.network().places()) box.take_in(p);
  return std::hypot(box.width(), box.height());
}

}  // namespace

FieldModel::FieldModel(const Weighing& weighing, Sites sites, const StepSample& sample,
                       unsigned threads)
    : weighing_(weighing), sites_(std::move(sites)) {
  DistanceClasses found = distance_classes(sample, sites_, threads);
  shortfall_ = std::move(found.shortfall);
  if (!shortfall_.empty()) return;
  variogram_.emplace(fit_variogram(found.classes), longest_distance(weighing));
  variance_.emplace(sites_, *variogram_);
}

std::vector<double> by_site(const Sites& sites, const std::vector<double>& of_place) {
  std::vector<double> values(of_place.size());
  for (std::uint32_t site = 0; site < values.size(); ++site)
    values[site] = of_place[sites.place_of(site)];
  return values;
}

}  // namespace thiessen
