#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rainfall/series/readings.h"

namespace thiessen {

/// Steps of readings: a row a step, in each a reading a station, NaN where it is silent.
using StepRows = std::span<const std::span<const double>>;

/// Reads steps in blocks of `most` (the last may be shorter) and hands each block on to `take`,
/// while with more threads than one it reads the next. Memory: two blocks. Throws what reading or
/// `take` throws.
void for_each_block(Readings& readings, std::size_t most, unsigned threads,
                    const std::function<void(StepRows)>& take);

}  // namespace thiessen
