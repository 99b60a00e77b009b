#include "rainfall/methods/weights_cache.h"

#include <utility>

namespace thiessen {
namespace {

std::size_t bytes_of(const ReportingPlaces& reports, const AreaMethod::Weights& weights) {
  constexpr std::size_t bytes_of_an_entry = 160;  // a node, a bucket, the pointer's counters
  std::size_t bytes = bytes_of_an_entry + reports.size() / 8;
  for (const auto& basin : weights)
    bytes += sizeof(std::vector<PlaceWeight>) + basin.capacity() * sizeof(PlaceWeight);
  return bytes;
}

}  // namespace

std::shared_ptr<const AreaMethod::Weights> WeightsCache::of(const ReportingPlaces& reports) {
  {
    const std::lock_guard lock(mutex_);
    if (auto found = find(reports)) return found;
  }
  auto weights = std::make_shared<const AreaMethod::Weights>(method_.weights(reports, month_));
  const std::lock_guard lock(mutex_);
  keep(reports, weights);
  return weights;
}

std::shared_ptr<const AreaMethod::Weights> WeightsCache::find(const ReportingPlaces& reports) {
  const auto young = young_.find(reports);
  if (young != young_.end()) return young->second;
  const auto old = old_.find(reports);
  if (old == old_.end()) return nullptr;
  auto weights = old->second;
  old_.erase(old);
  keep(reports, weights);
  return weights;
}

void WeightsCache::keep(const ReportingPlaces& reports,
                        const std::shared_ptr<const AreaMethod::Weights>& weights) {
  const std::size_t bytes = bytes_of(reports, *weights);
  if (bytes > generation_bytes_) return;
  if (young_bytes_ + bytes > generation_bytes_) {
    old_ = std::move(young_);
    young_.clear();
    young_bytes_ = 0;
  }
  if (young_.emplace(reports, weights).second) young_bytes_ += bytes;
}

}  // namespace thiessen
