#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace thiessen {

/// Numbers the different sets of reporting gauges from 1, in the order in which they come. A set is
/// known by 128 bits of hash: two sets with the same hash are taken for one. Memory: some 50 bytes
/// a set, whatever its size.
class GaugePatterns {
 public:
  struct Pattern {
    std::size_t number;
    bool is_fresh;  ///< not seen before
  };
  /// Gives the number of a step's set. `readings` has one entry for each station, NaN where it is
  /// silent. Sets of different months are different where months have normals of their own; else
  /// the month is 0.
  Pattern of(std::span<const double> readings, std::size_t month = 0);

 private:
  using Hash = std::array<std::uint64_t, 2>;
  struct FirstHalf {
    std::size_t operator()(const Hash& hash) const { return hash[0]; }
  };
  std::unordered_map<Hash, std::size_t, FirstHalf> number_;
};

}  // namespace thiessen
