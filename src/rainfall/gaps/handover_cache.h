#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/kept.h"
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
  std::shared_ptr<const Handover> of_single(PlaceIndex cell);

  const Handovers& handovers_;
  bool tells_parts_;
  /// The handovers of components of one cell, which are the commonest: by cell, within half of the
  /// bound.
  Kept<Handover> singles_;
  Remembered<PlaceIndex, Handover> others_;
};

}  // namespace thiessen
