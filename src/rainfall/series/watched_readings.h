#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"

namespace thiessen {

/// Passes on other readings. While one thread reads them, any other may ask how much is read or
/// done.
class WatchedReadings : public Readings {
 public:
  explicit WatchedReadings(std::unique_ptr<Readings> all) : all_(std::move(all)) {}

  bool next(TimeStep& step) override {
    const bool more = all_->next(step);
    if (more) steps_.fetch_add(1, std::memory_order_relaxed);
    share_.store(all_->share_read(), std::memory_order_relaxed);
    return more;
  }
  bool is_waiting(std::chrono::milliseconds patience) override {
    return all_->is_waiting(patience);
  }
  std::string unit() const override { return all_->unit(); }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return share_.load(std::memory_order_relaxed); }
  /// The share of the input that the first `steps` steps make up, if steps are of equal length.
  double share_of(std::size_t steps) const {
    const auto read = static_cast<double>(steps_.load(std::memory_order_relaxed));
    return read > 0 ? share_read() * std::min(1.0, static_cast<double>(steps) / read) : 0;
  }

 private:
  std::unique_ptr<Readings> all_;
  std::atomic<std::size_t> steps_ = 0;
  std::atomic<double> share_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace thiessen
