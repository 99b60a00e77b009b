#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rainfall/series/readings.h"

namespace thiessen {

/// Steps of readings: a row for each step, and in it a reading for each station, NaN where it is
/// silent.
using StepRows = std::span<const std::span<const double>>;

/// Some steps that follow each other.
struct StepBlock {
  StepRows rows;
  std::span<const std::size_t> months;  ///< the calendar month of each, from 0; none if not wanted
};

/// Tells the calendar month of a step, from 0.
using MonthOfTime = std::function<std::size_t(const TimeStep&)>;

/// Reads steps in blocks of `most` (the last may be shorter) and hands each block on to `take`.
/// Where `month_of` is not empty the blocks have months. With more than one thread the next block
/// is read meanwhile. Memory: two blocks. Throws what reading, `month_of` or `take` throws.
void for_each_block(Readings& readings, std::size_t most, unsigned threads,
                    const MonthOfTime& month_of, const std::function<void(const StepBlock&)>& take);

}  // namespace thiessen
