#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rainfall/findings/gauge_neighbours.h"
#include "rainfall/findings/stretch.h"

namespace thiessen {

/// What two neighbours read over the steps at which both report, year by year. Memory: 12 bytes for
/// each year and pair of neighbours.
class NeighbourTotals {
 public:
  static constexpr std::size_t most_wet_steps = 1000;

  struct Totals {
    float first = 0;
    float second = 0;
    std::uint32_t steps = 0;  ///< at which both report
  };

  explicit NeighbourTotals(const GaugeNeighbours& neighbours)
      : neighbours_(neighbours), wet_steps_(neighbours.pairs().size()) {}

  void add(const Stretch& stretch);

  const GaugeNeighbours& neighbours() const { return neighbours_; }
  /// The totals of all pairs, by year; of steps without a year there are none.
  const std::map<int, std::vector<Totals>>& years() const { return years_; }
  /// The totals of one pair over all steps, whether their years are known or not.
  struct Sums {
    double first = 0;
    double second = 0;
  };
  Sums of_all(std::uint32_t pair) const;
  /// At how many steps at least one of the pair is wet and both report; counted to most_wet_steps.
  std::size_t wet_steps(std::uint32_t pair) const { return wet_steps_[pair]; }
  /// Whether some pair has so many such steps.
  bool has_wet_steps(std::size_t least) const {
    return std::any_of(wet_steps_.begin(), wet_steps_.end(),
                       [&](std::size_t steps) { return steps >= least; });
  }

 private:
  std::vector<Totals>& of_year(std::optional<int> year);

  const GaugeNeighbours& neighbours_;
  std::map<int, std::vector<Totals>> years_;
  std::vector<Totals> without_year_;
  std::vector<std::size_t> wet_steps_;  // by pair
};

}  // namespace thiessen
