#include "rainfall/gaps/handover_cache.h"

#include <utility>

namespace thiessen {
namespace {

std::size_t bytes_of(const Handover& handover) {
  return handover.shares.capacity() * sizeof(CellWeight) +
         (handover.weighted.normals.capacity() + handover.weighted.covered.capacity()) *
             sizeof(double) +
         handover.made_of.parts.capacity() * sizeof(HandedPart) +
         handover.made_of.borders.capacity() * sizeof(handover.made_of.borders[0]) +
         handover.made_of.unmeasured.capacity() * sizeof(PlaceIndex);
}

}  // namespace

HandoverCache::HandoverCache(const Handovers& handovers, std::size_t bytes, bool tells_parts)
    : handovers_(handovers),
      tells_parts_(tells_parts),
      singles_(handovers.adjacency().cells(), bytes / 2),
      others_(bytes / 2) {}

std::shared_ptr<const Handover> HandoverCache::of_single(PlaceIndex cell) {
  if (auto found = singles_.find(index(cell))) return found;
  auto handover = std::make_unique<const Handover>(handovers_.of({&cell, 1}, tells_parts_));
  const std::size_t bytes = bytes_of(*handover);
  return singles_.keep(index(cell), std::move(handover), bytes);
}

std::shared_ptr<const Handover> HandoverCache::of(std::span<const PlaceIndex> component) {
  if (component.size() == 1) return of_single(component.front());
  return others_.of(
      component, [&] { return handovers_.of(component, tells_parts_); }, bytes_of);
}

}  // namespace thiessen
