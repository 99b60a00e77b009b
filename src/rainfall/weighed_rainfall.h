#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"
#include "rainfall/network/step_rainfall.h"

namespace thiessen {

struct ArealRainfallSettings {
  Gaps gaps = Gaps::retessellate;
  std::size_t min_gauges = 1;  ///< with fewer that weigh a basin has no value
  bool accounts = true;        ///< whether `gauges` and `coverage` are wanted; else they are 0
  std::size_t remembered_bytes = std::size_t{256} << 20;  ///< kept for silent gauges

  bool counts_gauges() const { return accounts || min_gauges > 1; }
};

/// Areal rainfall as sums of weight x factor x reading, by one way to weigh gauges and one gap
/// policy. This class adds what is the same for every policy: the coverage, and the least number of
/// gauges.
class WeighedRainfall : public StepRainfall {
 public:
  /// The weights by basin when every gauge reports.
  const std::vector<BasinWeights>& full_weights() const { return policy_->full_weights(); }
  /// Whether the values of a step equal those of a network without the gauges that are silent then.
  bool leaves_silent_out() const {
    return policy_->leaves_silent_out() && settings_.min_gauges <= 1;
  }

  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

  /// The values of a step, and the account of what they are made of.
  std::vector<BasinRainfall> at(std::span<const double> readings, CellAccount& account) const;
  /// The full network's weights of the cells that an account speaks of, by basin, then by cell.
  std::vector<CellWeight> full_cells() const { return policy_->full_cells(); }
  /// The readings that an account would hold: one for each cell.
  std::vector<double> cell_readings(std::span<const double> readings) const {
    return policy_->cell_readings(readings);
  }

 protected:
  const ArealRainfallSettings& settings() const { return settings_; }
  WeighedRainfall(std::shared_ptr<const Weigher> weigher, const ArealRainfallSettings& settings,
                  const NormalMonth& month = {});

 private:
  void finish(std::vector<BasinRainfall>& values, std::span<const double> readings) const;

  ArealRainfallSettings settings_;
  std::shared_ptr<const Weigher> weigher_;
  std::unique_ptr<const GapPolicy> policy_;
};

}  // namespace thiessen
