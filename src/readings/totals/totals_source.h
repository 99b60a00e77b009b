#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/series/readings.h"

namespace thiessen {

/// Totals of gauges, as readings whose steps are coarse, and of how many days each of them is.
struct TotalsPart {
  std::unique_ptr<Readings> amounts;
  std::unique_ptr<Readings> days;  ///< null where all are of the file's step
  /// Whether an amount without a number of days is one of a step; else nothing tells its length.
  bool is_of_step_without_days = true;
};

/// Totals that can be read more than once.
struct TotalsSource {
  std::string name;  ///< in messages
  /// Opens all parts of the totals, with steps in ascending order of time where `is_sorted`, else
  /// as the file has them.
  std::function<std::vector<TotalsPart>(bool is_sorted, Warnings& warnings)> open;
};

}  // namespace thiessen
