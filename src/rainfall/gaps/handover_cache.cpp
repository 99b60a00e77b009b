#include "rainfall/gaps/handover_cache.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace thiessen {
namespace {

// An entry takes a node and a bucket of the map, and the counters of the shared pointer.
constexpr std::size_t bytes_of_an_entry = 160;

std::size_t bytes_of(std::span<const PlaceIndex> component, const Handover& handover) {
  return bytes_of_an_entry + component.size_bytes() +
         handover.shares.capacity() * sizeof(CellWeight) +
         (handover.weighted.normals.capacity() + handover.weighted.covered.capacity()) *
             sizeof(double);
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

HandoverCache::HandoverCache(const Handovers& handovers, std::size_t bytes)
    : handovers_(handovers),
      singles_(handovers.adjacency().cells()),
      singles_bytes_left_(bytes / 2),
      generation_bytes_(bytes / 2 / shard_count / 2) {}

std::shared_ptr<const Handover> HandoverCache::of_single(PlaceIndex cell) {
  // It is kept to the end, so its users need not be counted.
  const auto uncounted = [](const Handover* handover) {
    return std::shared_ptr<const Handover>(std::shared_ptr<const Handover>(), handover);
  };
  if (const Handover* found = singles_.find(cell)) return uncounted(found);
  auto handover = std::make_unique<const Handover>(handovers_.of({&cell, 1}));
  const std::size_t bytes = bytes_of({}, *handover);
  std::size_t left = singles_bytes_left_.load(std::memory_order_relaxed);
  do {
    if (left < bytes) return handover;
  } while (!singles_bytes_left_.compare_exchange_weak(left, left - bytes));
  const Handover* ours = handover.get();
  const Handover* kept = singles_.keep(cell, std::move(handover));
  if (kept != ours) singles_bytes_left_ += bytes;
  return uncounted(kept);
}

std::size_t HandoverCache::Hash::operator()(std::span<const PlaceIndex> component) const {
  std::uint64_t hash = component.size();
  for (const PlaceIndex cell : component) {
    hash = (hash ^ index(cell)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return hash;
}

bool HandoverCache::Equal::operator()(std::span<const PlaceIndex> a,
                                      std::span<const PlaceIndex> b) const {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

std::shared_ptr<const Handover> HandoverCache::of(std::span<const PlaceIndex> component) {
  if (component.size() == 1) return of_single(component.front());
  Shard& shard = shards_[(Hash{}(component) >> 32) % shard_count];
  {
    const std::lock_guard lock(shard.mutex);
    if (auto found = find(shard, component)) return found;
  }
  auto handover = std::make_shared<const Handover>(handovers_.of(component));
  const std::lock_guard lock(shard.mutex);
  keep(shard, component, handover);
  return handover;
}

std::shared_ptr<const Handover> HandoverCache::find(Shard& shard,
                                                    std::span<const PlaceIndex> component) {
  const auto young = shard.young.find(component);
  if (young != shard.young.end()) return young->second;
  const auto old = shard.old.find(component);
  if (old == shard.old.end()) return nullptr;
  auto handover = old->second;
  shard.old.erase(old);
  keep(shard, component, handover);
  return handover;
}

void HandoverCache::keep(Shard& shard, std::span<const PlaceIndex> component,
                         const std::shared_ptr<const Handover>& handover) {
  const std::size_t bytes = bytes_of(component, *handover);
  if (bytes > generation_bytes_) return;
  if (shard.young_bytes + bytes > generation_bytes_) {
    shard.old = std::move(shard.young);
    shard.young.clear();
    shard.young_bytes = 0;
  }
  if (shard.young.emplace(Component(component.begin(), component.end()), handover).second)
    shard.young_bytes += bytes;
}

}  // namespace thiessen
