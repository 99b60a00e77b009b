#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace thiessen {

/// A sample of the steps of a series of unknown length, evenly spaced over it, within a bound of
/// memory: every step while there is room, then every second, every fourth, and so on. Which steps
/// are kept depends on their number alone. At least half of the room is filled if the series is
/// that long.
///
/// The spacing is a power of 2, so in a series of hourly steps it meets at least three times of the
/// day. Memory: 8 bytes for each reading that is kept, and as much again for a moment while it
/// grows. Cost of a step: its gauges where it is kept, else nothing; dropping it later costs as
/// much once.
class StepSample {
 public:
  /// `most` is the number of steps that are held at once, at least 2.
  StepSample(std::size_t stations, std::size_t most);

  /// Takes the next step, with one reading for each station, NaN where it is silent, and with its
  /// calendar month from 0 if all have one.
  void add(std::span<const double> readings, const std::optional<std::size_t>& month = {});

  std::size_t steps() const { return stations_ == 0 ? 0 : readings_.size() / stations_; }
  std::size_t stations() const { return stations_; }
  /// The readings of a step that is kept; such steps are numbered in the order in which they came.
  std::span<const double> operator[](std::size_t step) const {
    return std::span(readings_).subspan(step * stations_, stations_);
  }
  /// The months of the steps that are kept, where they were given; else none.
  std::span<const std::size_t> months() const { return months_; }
  /// The number of steps of the series from one that is kept to the next.
  std::size_t spacing() const { return spacing_; }

 private:
  void drop_every_second();

  std::size_t stations_;
  std::size_t most_;
  std::size_t spacing_ = 1;
  std::size_t seen_ = 0;
  std::vector<double> readings_;  // a row for each step
  std::vector<std::size_t> months_;
};

/// The number of steps that fit in `bytes`, but no more than `most` and no fewer than 2.
std::size_t steps_within(std::size_t bytes, std::size_t stations, std::size_t most);

}  // namespace thiessen
