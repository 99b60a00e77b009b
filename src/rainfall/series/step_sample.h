#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace thiessen {

/// Steps of a series of unknown length, evenly spaced over it, within a bound of memory: every
/// step while there is room, then every second, every fourth, and so on. Which are kept depends on
/// their number alone. At least half of the room is filled where the series is that long.
///
/// The spacing is a power of 2: of hourly steps it meets at least three times of the day. Memory: 8
/// bytes a reading kept, and as much again for a moment while it grows. Cost of a step: its gauges
/// where it is kept, else nothing; what is dropped later adds as much once.
class StepSample {
 public:
  /// `most`: steps that are held at once, at least 2.
  StepSample(std::size_t stations, std::size_t most);

  /// The next step: readings one a station, NaN where it is silent.
  void add(std::span<const double> readings);

  std::size_t steps() const { return stations_ == 0 ? 0 : readings_.size() / stations_; }
  std::size_t stations() const { return stations_; }
  /// The readings of a step that is kept, in the order of time.
  std::span<const double> operator[](std::size_t step) const {
    return std::span(readings_).subspan(step * stations_, stations_);
  }
  /// How many steps of the series there are from one that is kept to the next.
  std::size_t spacing() const { return spacing_; }

 private:
  void drop_every_second();

  std::size_t stations_;
  std::size_t most_;
  std::size_t spacing_ = 1;
  std::size_t seen_ = 0;
  std::vector<double> readings_;  // a row a step
};

/// As many steps as a number of bytes has room for, but no more than `most` and at least 2.
std::size_t steps_within(std::size_t bytes, std::size_t stations, std::size_t most);

}  // namespace thiessen
