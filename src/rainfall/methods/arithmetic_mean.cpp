#include "rainfall/methods/arithmetic_mean.h"

#include "basin/containment.h"

namespace thiessen {

ArithmeticMean::ArithmeticMean(const Weighing& weighing)
    : weighing_(weighing),
      inside_(points_within(weighing.basins(), weighing.network().places(),
                            weighing.yardstick().metric == Metric::geodesic ? 360 : 0)) {}

AreaMethod::Weights ArithmeticMean::weights(const ReportingPlaces& reports,
                                            const NormalMonth& month) const {
  Weights weights(inside_.size());
  for (std::size_t b = 0; b < inside_.size(); ++b) {
    for (const std::size_t p : inside_[b]) {
      const PlaceIndex place{static_cast<std::uint32_t>(p)};
      if (reports[place]) weights[b].push_back({place, 0});
    }
    const NormalField* const normals = weighing_.normals();
    const double normal =
        normals == nullptr ? 1
                           : basin_normal(*normals, b, month) / reference_normal(*normals, month);
    for (PlaceWeight& w : weights[b]) {
      w.weight = 1 / static_cast<double>(weights[b].size());
      w.normal = normal;
    }
  }
  return weights;
}

}  // namespace thiessen
