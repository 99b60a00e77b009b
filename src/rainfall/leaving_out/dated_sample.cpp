#include "rainfall/leaving_out/dated_sample.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace thiessen {

void DatedSample::add(std::span<const double> readings, NormalMonth month,
                      std::optional<int> year) {
  const std::size_t number = seen_++;
  const std::size_t spacing = sample_.spacing();
  sample_.add(readings);
  if (number % spacing != 0) return;
  if (sample_.spacing() != spacing) {
    const std::size_t kept = (dates_.size() + 1) / 2;
    for (std::size_t i = 1; i < kept; ++i) dates_[i] = dates_[2 * i];
    dates_.resize(kept);
  }
  if (number % sample_.spacing() == 0) dates_.push_back({month, year});
}

std::vector<std::size_t> DatedSample::by_years() const {
  std::vector<std::size_t> order(steps());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t step) {
    return std::pair(!dates_[step].year.has_value(), dates_[step].year.value_or(0));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

bool DatedSample::has_sums_of_years() const {
  std::optional<int> before;
  for (const std::size_t step : by_years()) {
    if (dates_[step].year && dates_[step].year == before) return true;
    before = dates_[step].year;
  }
  return false;
}

}  // namespace thiessen
