#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/full_network.h"

namespace thiessen {

/// Scales the full network's weights of the gauges that report so that they add up to 1. A basin
/// where none of its gauges reports has no value.
class Renormalisation : public FullNetwork {
 public:
  static constexpr const char* name = "renormalise";
  static std::unique_ptr<const GapPolicy> of(const Weigher& weigher, const NormalMonth& month) {
    return std::make_unique<const Renormalisation>(weigher, month);
  }

  using FullNetwork::FullNetwork;

 private:
  double value(const Reporting& reporting) const override;
  BasinWeights weights(const BasinWeights& full, std::span<const double> readings) const override;
  std::vector<CellWeight> change(std::span<const double> readings) const override;
};

}  // namespace thiessen
