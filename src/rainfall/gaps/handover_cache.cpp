#include "rainfall/gaps/handover_cache.h"

#include <utility>

namespace thiessen {
namespace {

constexpr std::size_t bytes_of_a_single = 160;

std::size_t bytes_of(const Handover& handover) {
  return handover.shares.capacity() * sizeof(CellWeight) +
         (handover.weighted.normals.capacity() + handover.weighted.covered.capacity()) *
             sizeof(double) +
         handover.made_of.parts.capacity() * sizeof(HandedPart) +
         handover.made_of.borders.capacity() * sizeof(handover.made_of.borders[0]) +
         handover.made_of.unmeasured.capacity() * sizeof(PlaceIndex);
}

}  // namespace

HandoverCache::Singles::~Singles() {
  for (const auto& handover : of_cell_) delete handover.load(std::memory_order_relaxed);
}

const Handover* HandoverCache::Singles::keep(PlaceIndex cell,
                                             std::unique_ptr<const Handover> handover) {
  const Handover* known = nullptr;
  // If another thread has kept the cell's handover before, that one stays.
  if (!of_cell_[index(cell)].compare_exchange_strong(known, handover.get(),
                                                     std::memory_order_acq_rel))
    return known;
  return handover.release();
}

HandoverCache::HandoverCache(const Handovers& handovers, std::size_t bytes, bool tells_parts)
    : handovers_(handovers),
      tells_parts_(tells_parts),
      singles_(handovers.adjacency().cells()),
      singles_bytes_left_(bytes / 2),
      others_(bytes / 2) {}

std::shared_ptr<const Handover> HandoverCache::of_single(PlaceIndex cell) {
  // It is kept to the end, so its users need not be counted.
  const auto uncounted = [](const Handover* handover) {
    return std::shared_ptr<const Handover>(std::shared_ptr<const Handover>(), handover);
  };
  if (const Handover* found = singles_.find(cell)) return uncounted(found);
  auto handover = std::make_unique<const Handover>(handovers_.of({&cell, 1}, tells_parts_));
  const std::size_t bytes = bytes_of_a_single + bytes_of(*handover);
  std::size_t left = singles_bytes_left_.load(std::memory_order_relaxed);
  do {
    if (left < bytes) return handover;
  } while (!singles_bytes_left_.compare_exchange_weak(left, left - bytes));
  const Handover* ours = handover.get();
  const Handover* kept = singles_.keep(cell, std::move(handover));
  if (kept != ours) singles_bytes_left_ += bytes;
  return uncounted(kept);
}

std::shared_ptr<const Handover> HandoverCache::of(std::span<const PlaceIndex> component) {
  if (component.size() == 1) return of_single(component.front());
  return others_.of(
      component, [&] { return handovers_.of(component, tells_parts_); }, bytes_of);
}

}  // namespace thiessen
