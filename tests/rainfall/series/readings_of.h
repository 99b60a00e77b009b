#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "rainfall/series/readings.h"

namespace thiessen {

/// Readings of one gauge: step i, from 0, reads i, and stands in line i + 2. At the end they may
/// throw, as a table with bad rows does.
class ReadingsOf : public Readings {
 public:
  explicit ReadingsOf(std::vector<std::string> times, std::optional<Message> fault = std::nullopt)
      : times_(std::move(times)), fault_(std::move(fault)) {}

  bool next(TimeStep& step) override {
    if (done_ == times_.size()) {
      if (fault_) throw Error(*fault_);
      return false;
    }
    reading_ = static_cast<double>(done_);
    step = {times_[done_], {&reading_, 1}, done_ + 2};
    ++done_;
    return true;
  }
  double share_read() const override {
    return static_cast<double>(done_) / static_cast<double>(times_.size());
  }

 private:
  std::vector<std::string> times_;
  std::optional<Message> fault_;
  std::size_t done_ = 0;
  double reading_ = 0;
};

}  // namespace thiessen
