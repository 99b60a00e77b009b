#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/full_network.h"

namespace thiessen {

/// Gives a basin no value where any gauge that has weight in it is silent; else the value by the
/// full network's weights.
class Strictness : public FullNetwork {
 public:
  static constexpr const char* name = "strict";
  static std::unique_ptr<const GapPolicy> of(const Weigher& weigher, const NormalMonth& month) {
    return std::make_unique<const Strictness>(weigher, month);
  }

  using FullNetwork::FullNetwork;

 private:
  double value(const Reporting& reporting) const override;
  BasinWeights weights(const BasinWeights& full, std::span<const double> readings) const override;
  /// There are no changes: a basin with a value has the full network's weights.
  std::vector<CellWeight> change(std::span<const double>) const override { return {}; }
};

}  // namespace thiessen
