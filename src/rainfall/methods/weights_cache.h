#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "rainfall/methods/area_method.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// Remembers a method's weights, with the normals of a month or of the year, for the sets of
/// reporting places that were asked for lately, within a bound of memory. Safe for several threads
/// at once; the result depends on the set alone.
class WeightsCache {
 public:
  /// The method must outlive this object.
  WeightsCache(const AreaMethod& method, std::size_t bytes, const NormalMonth& month = {})
      : method_(method), month_(month), generation_bytes_(bytes / 2) {}

  std::shared_ptr<const AreaMethod::Weights> of(const ReportingPlaces& reports);

 private:
  using Generation = std::unordered_map<ReportingPlaces, std::shared_ptr<const AreaMethod::Weights>,
                                        ReportingPlaces::Hash>;

  std::shared_ptr<const AreaMethod::Weights> find(const ReportingPlaces& reports);
  void keep(const ReportingPlaces& reports,
            const std::shared_ptr<const AreaMethod::Weights>& weights);

  const AreaMethod& method_;
  NormalMonth month_;
  std::size_t generation_bytes_;
  std::mutex mutex_;
  // When the young generation is full it becomes the old one, and the old one is forgotten except
  // for the sets that have been asked for since.
  Generation young_;
  Generation old_;
  std::size_t young_bytes_ = 0;
};

}  // namespace thiessen
