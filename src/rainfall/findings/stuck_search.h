#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rainfall/findings/finding_search.h"

namespace thiessen {

/// Looks for a gauge that reads the same, and not 0, in so many steps that follow each other. All
/// of these readings are found, once the last of so many has come. No neighbour is asked, so that
/// what is expected instead is not known.
class StuckSearch : public FindingSearch {
 public:
  /// Requires at least 2 equal readings.
  StuckSearch(std::size_t gauges, std::size_t equal)
      : equal_(equal), times_(equal), runs_(gauges), before_(gauges) {}

  void see(const SeenStep& step, const TakeFinding& take) override;
  using FindingSearch::see;

 private:
  /// Takes note of a reading that equals the one before it.
  void go_on(StationIndex gauge, const SeenStep& step, const TakeFinding& take);

  struct Run {
    std::size_t last = 0;   ///< the number of the last step that equals the one before it, from 1
    std::size_t steps = 0;  ///< so many equal ones up to that
  };

  std::size_t equal_;
  std::vector<std::string> times_;  // of the last steps, each at its number modulo their count
  std::vector<Run> runs_;           // by gauge
  std::vector<double> before_;      // the readings of the step before
  std::size_t step_ = 0;            // the number of the step, from 1
};

}  // namespace thiessen
