#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/readings.h"

namespace thiessen {

/// One step of a series of areal rainfall.
struct RainStep {
  std::string time;
  std::vector<double> readings;       ///< by station; NaN where silent
  std::vector<BasinRainfall> basins;  ///< by basin
};

/// Reads step after step, computes them on up to `threads` threads and hands them on in their
/// order. Memory: a block of a few hundred steps, whatever their number. Throws what reading or
/// `take` throws. Returns the number of steps.
std::size_t for_each_step(Readings& readings, const ArealRainfall& rainfall, unsigned threads,
                          const std::function<void(const RainStep&)>& take);

}  // namespace thiessen
