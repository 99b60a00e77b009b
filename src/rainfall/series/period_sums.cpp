#include "rainfall/series/period_sums.h"

#include <cmath>
#include <limits>

namespace thiessen {

void PeriodSums::add(std::span<const BasinRainfall> step, const IsoTime& within) {
  errors_.add(step, depths_ ? depths_->of(1, within, stamp_) : 1);
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const double rainfall = step[b].rainfall;
    Sum& sum = sums_[b];
    if (std::isnan(rainfall)) {
      ++sum.missing;
    } else {
      ++sum.values;
      sum.rainfall.add(depths_ ? depths_->of(rainfall, within, stamp_) : rainfall);
    }
  }
}

void PeriodSums::totals(double depth, std::vector<BasinTotal>& totals) const {
  constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
  totals.clear();
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const Sum& sum = sums_[b];
    totals.push_back({sum.values > 0 ? sum.rainfall.value() * depth : no_value, sum.missing,
                      sum.values > 0 ? errors_.of(b) * depth : no_value});
  }
}

}  // namespace thiessen
