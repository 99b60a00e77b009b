#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rainfall/series/readings.h"
#include "rainfall/step_rainfall.h"

namespace thiessen {

/// One step of a series of areal rainfall.
struct RainStep {
  std::string time;
  std::vector<double> readings;       ///< by station; NaN where silent
  std::vector<BasinRainfall> basins;  ///< by basin, or by basin and method
  std::string text;                   ///< what `prepare` makes of it
  std::size_t line = 0;               ///< see TimeStep
};

/// How a series is computed: what comes out does not depend on it.
struct SeriesWork {
  unsigned threads = 1;
  std::size_t steps_in_a_block = 2048;  ///< at the most, and 16 MB; two blocks are in memory
};

/// Reads step after step, computes them and calls `prepare` for each on several threads, then hands
/// them on to `take` in their order. With more threads than one it reads ahead. Memory: two blocks,
/// whatever their number. Throws what reading, `prepare` or `take` throws. Returns the number of
/// steps.
std::size_t for_each_step(Readings& readings, const StepRainfall& rainfall, const SeriesWork& work,
                          const std::function<void(RainStep&)>& prepare,
                          const std::function<void(const RainStep&)>& take);

}  // namespace thiessen
