#pragma once

#include <cstddef>

#include "base/error.h"
#include "rainfall/series/rain_series.h"

namespace thiessen::cli {

/// What a series of areal rainfall is written into: a table, or what a model reads.
class RainOutput {
 public:
  virtual ~RainOutput() = default;
  /// Makes what a step is written as ahead of time, where that needs nothing that is known only in
  /// the order of the steps. Safe for several threads.
  virtual void prepare(RainStep& step) const = 0;
  /// Adds the next step in order. `pattern` is the number of its set of reporting gauges, and is
  /// used where the output has such a column.
  virtual void add(const RainStep& step, std::size_t pattern) = 0;
  /// Writes what is still held, and warns of what is odd about it. No step may be added afterwards.
  virtual void finish(Warnings& warnings) = 0;
};

}  // namespace thiessen::cli
