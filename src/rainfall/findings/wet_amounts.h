#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// How often gauges read how much, where it rains: counts in classes of a sixteenth of an octave,
/// of which quantiles are told to some 3 %. Memory: 2 kB a gauge, and no more than 8 MB: of more
/// than 4,096 gauges several are counted together, and count where all of these do.
class WetAmounts {
 public:
  explicit WetAmounts(std::size_t gauges)
      : gauges_(gauges), counts_(std::min(gauges, most_counted)) {}

  /// Requires an amount above 0.
  void add(StationIndex gauge, double amount);
  /// How many amounts are counted.
  std::size_t count() const { return count_; }
  /// The amount that so large a share of the amounts is not above, of the gauges that count
  /// together. NaN where they have none.
  double quantile(double share, const std::function<bool(StationIndex)>& counts) const;
  /// The median of the quantiles of each gauge alone, of those that have so many amounts at least;
  /// NaN where none has.
  double median_quantile(double share, std::size_t least) const;

 private:
  static constexpr std::size_t classes = 512;  ///< 32 octaves
  static constexpr std::size_t most_counted = 4096;
  using Counts = std::array<std::uint32_t, classes>;

  static double quantile_of(const std::array<std::uint64_t, classes>& counts, double share);

  std::size_t gauges_;
  std::vector<Counts> counts_;  // by gauge, modulo their number
  std::size_t count_ = 0;
};

}  // namespace thiessen
