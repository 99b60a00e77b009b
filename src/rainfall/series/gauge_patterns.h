#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace thiessen {

/// Numbers the different sets of reporting gauges, from 1, in the order in which they come. Memory:
/// some 50 bytes a set, whatever its size: two sets are taken for one where 128 bits of hash agree.
class GaugePatterns {
 public:
  struct Pattern {
    std::size_t number;
    bool is_fresh;  ///< not seen before
  };
  /// `readings`: one a station, NaN where it is silent.
  Pattern of(std::span<const double> readings);

 private:
  using Hash = std::array<std::uint64_t, 2>;
  struct FirstHalf {
    std::size_t operator()(const Hash& hash) const { return hash[0]; }
  };
  std::unordered_map<Hash, std::size_t, FirstHalf> number_;
};

}  // namespace thiessen
