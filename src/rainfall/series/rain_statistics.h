#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/network/step_rainfall.h"

namespace thiessen {

/// What a series of areal rainfall comes to, basin by basin. Memory: a few numbers a basin, however
/// many steps.
class RainStatistics {
 public:
  struct OfBasin {
    double sum = 0;          ///< of the steps that have a value
    double largest = 0;      ///< of these
    std::size_t values = 0;  ///< how many steps have one
    std::size_t empty = 0;   ///< how many have none

    /// Requires a value.
    double mean() const { return sum / static_cast<double>(values); }
  };

  explicit RainStatistics(std::size_t basins) : basins_(basins) {}
  /// The values of one step, by basin.
  void add(const std::vector<BasinRainfall>& step);
  /// By basin.
  const std::vector<OfBasin>& basins() const { return basins_; }
  std::size_t steps() const { return steps_; }

 private:
  std::vector<OfBasin> basins_;
  std::size_t steps_ = 0;
};

}  // namespace thiessen
