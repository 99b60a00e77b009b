#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"

namespace thiessen {

/// Looks for gauges whose series goes better with those of their neighbours one step earlier or
/// later, as it does where dates are those of another observation hour: by the correlations of
/// square roots over the whole record. A neighbour counts the more the better the two go together
/// at any of the three lags, by r^2 / (1 - r^2); at least three have to report together with it at
/// 120 steps. Of long records each eighth stretch is taken.
class ShiftSearch : public FindingSearch {
 public:
  static constexpr double least_gain = 0.05;
  static constexpr std::size_t least_neighbours = 3;
  static constexpr std::size_t least_steps = 120;

  explicit ShiftSearch(const GaugeNeighbours& neighbours);

  void see(const Stretch& stretch) override;
  using FindingSearch::see;
  void conclude(const TakeFinding& take) override;

 private:
  /// Sums over the steps at which both of a pair report, the second so many steps later.
  struct Sums {
    double steps = 0;
    double first = 0;  ///< of roots
    double second = 0;
    double first_squares = 0;  ///< which are the readings themselves
    double second_squares = 0;
    double products = 0;

    double correlation() const;
  };
  enum Lag : std::size_t { none, second_later, second_earlier };

  void take_roots(const Stretch& stretch);
  void add(const Stretch& stretch, std::size_t earlier, std::size_t later, std::size_t steps_later,
           Sums& sums) const;
  /// How much better a gauge goes with its neighbours where its series is moved a step: one
  /// earlier, as it is late, or one later; 0 where too few can tell.
  struct Gain {
    double where_late = 0;
    double where_early = 0;
  };
  Gain gain(StationIndex gauge) const;

  const GaugeNeighbours& neighbours_;
  std::vector<std::array<Sums, 3>> sums_;  // by pair and lag
  std::size_t stretches_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> roots_;   // as the amounts of a stretch
  std::vector<double> totals_;  // of roots, by gauge
};

}  // namespace thiessen
