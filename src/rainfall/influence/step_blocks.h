#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rainfall/series/readings.h"

namespace thiessen {

/// Steps of readings: a row for each step, and in it a reading for each station, NaN where it is
/// silent.
using StepRows = std::span<const std::span<const double>>;

/// Reads steps in blocks of `most` (the last may be shorter) and hands each block on to `take`.
/// With more than one thread the next block is read meanwhile. Memory: two blocks. Throws what
/// reading or `take` throws.
void for_each_block(Readings& readings, std::size_t most, unsigned threads,
                    const std::function<void(StepRows)>& take);

}  // namespace thiessen
