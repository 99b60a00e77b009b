#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// What a policy is built on that keeps the full network's weights, basin by basin. Its cells are
/// the network's places. Cost of a step: the full network's weights.
class FullNetwork : public GapPolicy {
 public:
  /// The weigher must outlive it.
  explicit FullNetwork(const Weigher& weigher)
      : network_(weigher.network()), full_(weigher.full_weights()) {}

  bool leaves_silent_out() const override { return false; }
  const std::vector<BasinWeights>& full_weights() const override { return full_; }
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinRainfall> at(std::span<const double> readings,
                                CellAccount& account) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;
  std::vector<CellWeight> full_cells() const override;
  std::vector<double> cell_readings(std::span<const double> readings) const override;

 protected:
  /// What the full network's weights of one basin come to with a step's readings.
  struct Reporting {
    std::size_t gauges;  ///< with weight, that report
    bool complete;       ///< whether all do, and there is one
    double share;        ///< sum of their weights
    double sum;          ///< of weight x reading
  };
  static Reporting reporting(const BasinWeights& full, std::span<const double> readings);

  const Network& network() const { return network_; }

 private:
  /// The value of one basin; NaN: none.
  virtual double value(const Reporting& reporting) const = 0;
  /// The weights that it is made with.
  virtual BasinWeights weights(const BasinWeights& full,
                               std::span<const double> readings) const = 0;
  /// The account's change of the full network's weights.
  virtual std::vector<CellWeight> change(std::span<const double> readings) const = 0;

  const Network& network_;
  std::vector<BasinWeights> full_;
};

}  // namespace thiessen
