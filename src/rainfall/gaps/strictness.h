#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/full_network.h"

namespace thiessen {

/// No value where any gauge is silent that has weight in the basin; else the full network's.
class Strictness : public FullNetwork {
 public:
  static constexpr const char* name = "strict";
  static std::unique_ptr<const GapPolicy> of(const Weigher& weigher) {
    return std::make_unique<const Strictness>(weigher);
  }

  using FullNetwork::FullNetwork;

 private:
  double value(const Reporting& reporting) const override;
  BasinWeights weights(const BasinWeights& full, std::span<const double> readings) const override;
  /// Nothing: what has a value has the full network's weights.
  std::vector<CellWeight> change(std::span<const double>) const override { return {}; }
};

}  // namespace thiessen
