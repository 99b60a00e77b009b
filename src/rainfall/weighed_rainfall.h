#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"
#include "rainfall/step_rainfall.h"

namespace thiessen {

struct ArealRainfallSettings {
  Gaps gaps = Gaps::retessellate;
  std::size_t min_gauges = 1;  ///< fewer that weigh give no value
  bool accounts = true;        ///< whether `gauges` and `coverage` are wanted, else they are 0
  std::size_t remembered_bytes = std::size_t{256} << 20;  ///< of what was made for silent gauges

  bool counts_gauges() const { return accounts || min_gauges > 1; }
};

/// Areal rainfall as sums of weight x reading, by one way to weigh gauges and one gap policy. It
/// adds what holds of every policy: coverage, and the least number of gauges.
class WeighedRainfall : public StepRainfall {
 public:
  /// The weights where every gauge reports, by basin.
  const std::vector<BasinWeights>& full_weights() const { return policy_->full_weights(); }
  /// Whether a step's values are those of a network that never had its silent gauges.
  bool leaves_silent_out() const {
    return policy_->leaves_silent_out() && settings_.min_gauges <= 1;
  }

  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

  /// The same values, and what they are made of.
  std::vector<BasinRainfall> at(std::span<const double> readings, CellAccount& account) const;
  /// The full network's weights of the account's cells, by basin, then by cell.
  std::vector<CellWeight> full_cells() const { return policy_->full_cells(); }
  /// The account's readings.
  std::vector<double> cell_readings(std::span<const double> readings) const {
    return policy_->cell_readings(readings);
  }

 protected:
  WeighedRainfall(std::shared_ptr<const Weigher> weigher, const ArealRainfallSettings& settings);

 private:
  void finish(std::vector<BasinRainfall>& values, std::span<const double> readings) const;

  ArealRainfallSettings settings_;
  std::shared_ptr<const Weigher> weigher_;
  std::unique_ptr<const GapPolicy> policy_;
};

}  // namespace thiessen
