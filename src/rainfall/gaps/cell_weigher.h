#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/weigher.h"

namespace thiessen {

/// Weighs gauges by the parts of the basins that their cells hold.
class CellWeigher : public Weigher {
 public:
  /// How much a retessellation keeps and counts.
  struct Keeping {
    std::size_t remembered_bytes;  ///< of handovers
    bool counts_gauges;            ///< else 0 of them
  };

  /// The weighing must outlive it.
  CellWeigher(const Weighing& weighing, const Keeping& keeping, unsigned threads)
      : weighing_(weighing), keeping_(keeping), threads_(threads) {}

  const Network& network() const override { return weighing_.network(); }
  /// Cost: as Weighing::weights.
  std::vector<BasinWeights> full_weights() const override;
  std::unique_ptr<const Retessellation> retessellation() const override;

  /// Made when they are first asked for.
  const Handovers& handovers() const;

 private:
  const Weighing& weighing_;
  Keeping keeping_;
  unsigned threads_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Handovers> handovers_;
};

}  // namespace thiessen
