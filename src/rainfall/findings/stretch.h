#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rainfall/findings/seen_step.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Up to 64 steps that follow each other within one year, as what is wrong with whole gauges is
/// looked for in: a bit a step says who reports and where it rains, so that sums over the steps at
/// which two gauges report cost next to nothing where both report throughout. Of more than 30,000
/// gauges there are fewer steps in one, so that it takes no more than 16 MB for a million.
class Stretch {
 public:
  using Bits = std::uint64_t;

  explicit Stretch(std::size_t gauges);

  /// Empties it; `year` is that of the steps to come, where it is known, and `descends` whether
  /// each of them is before the one that it follows.
  void clear(std::optional<int> year);
  void set_descends(bool descends) { descends_ = descends; }
  /// Adds the next step. Requires that it is not full.
  void add(const SeenStep& step);

  std::size_t steps() const { return steps_; }
  bool is_full() const { return steps_ == most_steps_; }
  /// How many amounts of a gauge stand beside each other. One more than steps, for rows that begin
  /// at multiples of a power of two share few lines of a processor's cache.
  std::size_t stride() const { return most_steps_ + 1; }
  std::optional<int> year() const { return year_; }
  bool descends() const { return descends_; }
  Bits reports(std::size_t gauge) const { return all() & ~silent_[gauge]; }
  Bits wet(std::size_t gauge) const { return wet_[gauge]; }
  /// The reading of a gauge at a step at which it is wet.
  double amount(std::size_t gauge, std::size_t step) const {
    return amounts_[gauge * stride() + step];
  }
  /// The sum of a gauge's readings at the steps of the bits.
  double sum(std::size_t gauge, Bits steps) const {
    double sum = totals_[gauge];
    for (Bits others = wet_[gauge] & ~steps; others != 0; others &= others - 1)
      sum -= amount(gauge, static_cast<std::size_t>(std::countr_zero(others)));
    return (wet_[gauge] & steps) == 0 ? 0 : sum;
  }

 private:
  Bits all() const { return steps_ == 64 ? ~Bits{0} : (Bits{1} << steps_) - 1; }

  std::size_t most_steps_;
  std::size_t steps_ = 0;
  std::optional<int> year_;
  bool descends_ = false;
  std::vector<Bits> silent_;  // by gauge
  std::vector<Bits> wet_;
  std::vector<double> totals_;
  std::vector<double> amounts_;  // of wet steps alone
};

}  // namespace thiessen
