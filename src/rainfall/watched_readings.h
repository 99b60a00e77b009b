#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <utility>

#include "rainfall/readings.h"

namespace thiessen {

/// Other readings, of which any thread may ask how much is read while another reads them.
class WatchedReadings : public Readings {
 public:
  explicit WatchedReadings(std::unique_ptr<Readings> all) : all_(std::move(all)) {}

  bool next(TimeStep& step) override {
    const bool more = all_->next(step);
    share_.store(all_->share_read(), std::memory_order_relaxed);
    return more;
  }
  double share_read() const override { return share_.load(std::memory_order_relaxed); }

 private:
  std::unique_ptr<Readings> all_;
  std::atomic<double> share_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace thiessen
