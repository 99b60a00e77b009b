#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/remembered.h"

namespace thiessen {

/// Remembers the handovers of the components that were asked for lately, within a bound of memory.
/// Safe for several threads at once; the result depends on the component alone.
class HandoverCache {
 public:
  /// The handovers must outlive this object. With `tells_parts` they say what they are made of.
  HandoverCache(const Handovers& handovers, std::size_t bytes, bool tells_parts = false);

  std::shared_ptr<const Handover> of(std::span<const PlaceIndex> component);

 private:
  /// The handovers of components of one cell, which are the commonest and are found without a
  /// search. Each is computed once and kept to the end, while all of them are within half of the
  /// bound.
  class Singles {
   public:
    explicit Singles(std::size_t cells) : of_cell_(cells) {}
    Singles(const Singles&) = delete;
    Singles& operator=(const Singles&) = delete;
    ~Singles();
    const Handover* find(PlaceIndex cell) const {
      return of_cell_[index(cell)].load(std::memory_order_acquire);
    }
    const Handover* keep(PlaceIndex cell, std::unique_ptr<const Handover> handover);

   private:
    std::vector<std::atomic<const Handover*>> of_cell_;
  };

  std::shared_ptr<const Handover> of_single(PlaceIndex cell);

  const Handovers& handovers_;
  bool tells_parts_;
  Singles singles_;
  std::atomic<std::size_t> singles_bytes_left_;
  Remembered<PlaceIndex, Handover> others_;
};

}  // namespace thiessen
