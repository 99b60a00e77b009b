#include "rainfall/series/step_sample.h"

#include <algorithm>

namespace thiessen {

StepSample::StepSample(std::size_t stations, std::size_t most)
    : stations_(stations), most_(std::max<std::size_t>(most, 2)) {}

void StepSample::add(std::span<const double> readings, const std::optional<std::size_t>& month) {
  const std::size_t number = seen_++;
  if (number % spacing_ != 0) return;
  if (steps() == most_) {
    drop_every_second();
    if (number % spacing_ != 0) return;
  }
  readings_.insert(readings_.end(), readings.begin(), readings.end());
  if (month) months_.push_back(*month);
}

void StepSample::drop_every_second() {
  const std::size_t kept = (steps() + 1) / 2;
  const auto row = [&](std::size_t step) {
    return readings_.begin() + static_cast<std::ptrdiff_t>(step * stations_);
  };
  for (std::size_t i = 1; i < kept; ++i) std::copy(row(2 * i), row(2 * i + 1), row(i));
  readings_.resize(kept * stations_);
  if (!months_.empty()) {
    for (std::size_t i = 1; i < kept; ++i) months_[i] = months_[2 * i];
    months_.resize(kept);
  }
  spacing_ *= 2;
}

std::size_t steps_within(std::size_t bytes, std::size_t stations, std::size_t most) {
  const std::size_t room = bytes / sizeof(double) / std::max<std::size_t>(stations, 1);
  return std::clamp<std::size_t>(room, 2, std::max<std::size_t>(most, 2));
}

}  // namespace thiessen
