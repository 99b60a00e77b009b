#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/methods/rain_surface.h"
#include "rainfall/network/step_rainfall.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Areal rainfall as textbooks take it from a map of isohyets: the areas between them times their
/// mid-levels. The isohyets are those of the natural surface over a basin's points (with normals
/// that of relative readings times the normal; see basin_points and isohyetal_mean), whose least
/// and largest value are looked for at the vertices of its outline too. Which basins have a value,
/// by how many gauges and with which coverage, is told by the mean of natural neighbours. Accuracy:
/// that of the areas between isohyets, which 2,000 points have to 4e-3 of the basin. Cost of a
/// step: a tessellation of the gauges that report, and half a microsecond a point.
class IsohyetalRainfall : public StepRainfall {
 public:
  static constexpr const char* name = "isohyetal";

  /// `interval` is that between isohyets; 0 for a rounded step of its own in each basin and step.
  /// The weighing must outlive this object.
  IsohyetalRainfall(const Weighing& weighing, std::unique_ptr<const StepRainfall> natural,
                    std::size_t points, double interval, unsigned threads,
                    const NormalMonth& month = {});

  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  /// The weights of the mean of natural neighbours, for isohyets weigh no gauges.
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

 private:
  double mean_of(std::size_t basin, RainSurface& surface) const;
  double normal_on_outline(std::size_t basin, Point p) const;

  const Weighing& weighing_;
  std::unique_ptr<const StepRainfall> natural_;
  std::vector<std::vector<Point>> points_;    // by basin
  std::vector<std::vector<double>> normals_;  // of the points, by basin; empty without
  NormalMonth month_;
  double interval_;
};

}  // namespace thiessen
