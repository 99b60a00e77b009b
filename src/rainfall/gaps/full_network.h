#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// The base of policies that use the full network's weights and no tessellation of the gauges that
/// report. They decide basin by basin. The cells of their accounts are the network's places. Cost
/// of a step: the number of the full network's weights.
class FullNetwork : public GapPolicy {
 public:
  /// The weigher must outlive this object.
  explicit FullNetwork(const Weigher& weigher, const NormalMonth& month = {})
      : network_(weigher.network()), full_(weigher.full_weights(month)) {}

  bool leaves_silent_out() const override { return false; }
  const std::vector<BasinWeights>& full_weights() const override { return full_; }
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinRainfall> at(std::span<const double> readings,
                                CellAccount& account) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;
  std::vector<CellWeight> full_cells() const override;
  std::vector<double> cell_readings(std::span<const double> readings) const override;

 protected:
  /// The full network's weights of one basin, summed up over the gauges that report at a step.
  struct Reporting {
    std::size_t gauges;  ///< number that have weight and report
    bool complete;       ///< whether all with weight report, and there is at least one
    double share;        ///< sum of the reporting gauges' weights
    double sum;          ///< sum of their weight x factor x reading
  };
  static Reporting reporting(const BasinWeights& full, std::span<const double> readings);

  const Network& network() const { return network_; }

 private:
  /// The value of one basin; NaN where the policy gives none.
  virtual double value(const Reporting& reporting) const = 0;
  /// The weights that the value of one basin is made with; none where there is no value.
  virtual BasinWeights weights(const BasinWeights& full,
                               std::span<const double> readings) const = 0;
  /// The changes of the full network's weights, for the account.
  virtual std::vector<CellWeight> change(std::span<const double> readings) const = 0;

  const Network& network_;
  std::vector<BasinWeights> full_;
};

}  // namespace thiessen
