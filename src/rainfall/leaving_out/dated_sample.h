#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rainfall/normals/normal_field.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// A StepSample that keeps of each step its calendar month, where normals are of months, and its
/// calendar year.
class DatedSample {
 public:
  DatedSample(std::size_t stations, std::size_t most) : sample_(stations, most) {}

  /// Takes the next step, with one reading for each station, NaN where it is silent.
  void add(std::span<const double> readings, NormalMonth month, std::optional<int> year);

  /// How many steps have come, and how many are kept.
  std::size_t seen() const { return seen_; }
  std::size_t steps() const { return sample_.steps(); }
  std::size_t spacing() const { return sample_.spacing(); }
  std::span<const double> readings(std::size_t step) const { return sample_[step]; }
  NormalMonth month(std::size_t step) const { return dates_[step].month; }
  std::optional<int> year(std::size_t step) const { return dates_[step].year; }
  /// The steps that are kept, those of a year one after the other, years as they follow each other,
  /// and last what has none.
  std::vector<std::size_t> by_years() const;
  /// Whether some year has more than one of the steps, so that its sum is not just a step.
  bool has_sums_of_years() const;

 private:
  struct Date {
    NormalMonth month;
    std::optional<int> year;
  };
  StepSample sample_;
  std::vector<Date> dates_;
  std::size_t seen_ = 0;
};

}  // namespace thiessen
