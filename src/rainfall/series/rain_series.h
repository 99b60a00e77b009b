#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rainfall/network/step_rainfall.h"
#include "rainfall/series/readings.h"

namespace thiessen {

/// One step of a series of areal rainfall.
struct RainStep {
  std::string time;
  std::vector<double> readings;             ///< by station; NaN where it is silent
  std::vector<BasinRainfall> basins;        ///< by basin, or by basin and method
  std::string text;                         ///< what `prepare` makes of it
  std::size_t line = 0;                     ///< see TimeStep
  std::optional<WrittenTime> written = {};  ///< see TimeStep
};

/// How a series is computed; the result does not depend on it.
struct SeriesWork {
  unsigned threads = 1;
  std::size_t steps_in_a_block = 2048;  ///< at most, and at most 16 MB; two blocks are in memory
  /// Called whenever all steps that have come by a pipe are handed on, and every fifth of a second
  /// or so, whether others come or not. Where it is empty steps are handed on in whole blocks,
  /// however long these are in coming.
  std::function<void()> when_handed_on = {};
  /// The calendar month of a step, from 0, by which normals are chosen where months have their own;
  /// then it is to be given.
  std::function<std::size_t(const RainStep&)> month_of = {};
};

/// What computes a step: the rainfall itself, or that of its calendar month where months are told
/// apart.
const StepRainfall& rainfall_at(const StepRainfall& rainfall, const RainStep& step,
                                const SeriesWork& work);

/// Reads the steps of a series, computes each and calls `prepare` for it on several threads, then
/// hands them on to `take` in their order. Returns the number of steps. With more than one thread
/// it reads ahead. Memory: two blocks, however many steps there are. Throws what reading, `prepare`
/// or `take` throws; where there is a `when_handed_on`, what reading throws comes once all steps
/// before it have been handed on.
std::size_t for_each_step(Readings& readings, const StepRainfall& rainfall, const SeriesWork& work,
                          const std::function<void(RainStep&)>& prepare,
                          const std::function<void(const RainStep&)>& take);

}  // namespace thiessen
