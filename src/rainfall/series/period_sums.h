#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/iso_time.h"
#include "geometry/long_sum.h"
#include "rainfall/errors/total_error.h"
#include "rainfall/network/step_rainfall.h"
#include "rainfall/series/held_totals.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_depths.h"

namespace thiessen {

/// The sums of one period, by basin, or by basin and method: whatever the periods are, it is told
/// when one begins, each of its steps, and asked for the totals when it ends.
///
/// Sums are LongSums, so the order of the steps does not matter.
class PeriodSums {
 public:
  /// `depths`: what values count for that are rates, nothing where they are depths. `correlation`:
  /// how the errors of steps go together, where totals are to have errors; else null.
  PeriodSums(std::optional<StepDepths> depths, Stamp stamp,
             std::shared_ptr<const ErrorCorrelation> correlation)
      : depths_(depths), stamp_(stamp), errors_(std::move(correlation)) {}

  void begin(std::size_t basins) {
    sums_.assign(basins, Sum{});
    errors_.begin(basins);
  }
  /// Adds a step, which holds the moment `within`. A basin without a value lacks it.
  void add(std::span<const BasinRainfall> step, const IsoTime& within);
  /// Has a basin lack steps.
  void lack(std::size_t basin, std::size_t steps) { sums_[basin].missing += steps; }
  std::size_t basins() const { return sums_.size(); }
  /// The totals and their errors: of sums times `depth`, and NaN where no step has a value.
  void totals(double depth, std::vector<BasinTotal>& totals) const;

 private:
  struct Sum {
    LongSum rainfall;
    std::size_t values = 0;
    std::size_t missing = 0;
  };

  std::optional<StepDepths> depths_;
  Stamp stamp_;
  std::vector<Sum> sums_;
  TotalErrors errors_;
};

}  // namespace thiessen
