#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/handover_cache.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// Weighs gauges by the parts of the basins that lie in their cells.
class CellWeigher : public Weigher {
 public:
  /// What a retessellation remembers and counts.
  struct Keeping {
    std::size_t remembered_bytes;  ///< the bound for remembered handovers
    bool counts_gauges;            ///< else values have 0 gauges
  };

  /// The weighing must outlive this object.
  CellWeigher(const Weighing& weighing, const Keeping& keeping, unsigned threads)
      : weighing_(weighing), keeping_(keeping), threads_(threads) {}

  const Network& network() const override { return weighing_.network(); }
  const NormalField* normals() const override { return weighing_.normals(); }
  /// The weights by basin when every gauge reports. Cost: that of Weighing::weights, once for all
  /// months.
  std::vector<BasinWeights> full_weights(const NormalMonth& month) const override;
  std::unique_ptr<const Retessellation> retessellation(const NormalMonth& month) const override;
  using Weigher::full_weights;
  using Weigher::retessellation;

  /// The handovers of the network, which are made when they are first asked for.
  const Handovers& handovers() const;

 private:
  const Weighing& weighing_;
  Keeping keeping_;
  unsigned threads_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Handovers> handovers_;
  mutable std::unique_ptr<HandoverCache> remembered_;
  mutable std::once_flag weighed_;
  mutable std::vector<std::vector<BasinWeights>> by_month_;
};

}  // namespace thiessen
