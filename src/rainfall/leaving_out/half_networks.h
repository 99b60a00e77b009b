#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rainfall/leaving_out/error_sums.h"
#include "rainfall/leaving_out/left_out_estimates.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// The readings of a step, and the month whose normals count.
struct HalvedStep {
  std::span<const double> readings;
  NormalMonth month = {};
};

/// What the basins' means of a method are off by when half of the gauges are left out.
struct HalvedMethod {
  PointMethod method;
  bool with_normals;
  ErrorSums errors;
};

/// Leaves every other gauge out, along Hilbert's curve through the network: once those of even
/// number and once the others, stations of a place together. The basins' means of what is left are
/// held against those of all gauges by the same method, as `rain` has them, where both have a
/// value. Linear is no method for basins, and not among them. With normals, if the weighing has
/// some, and without. `points` are those of a basin that idw and natural look at.
std::vector<HalvedMethod> errors_with_half_the_gauges(const Weighing& weighing,
                                                      std::span<const HalvedStep> steps,
                                                      std::size_t points, unsigned threads);

}  // namespace thiessen
