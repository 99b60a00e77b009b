#include "report/thinned_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thiessen {
namespace {

SeriesStretch::OfBasin of_one(double value) {
  if (std::isnan(value)) return {};
  return {value, value, value, 1};
}

SeriesStretch::OfBasin joined(const SeriesStretch::OfBasin& a, const SeriesStretch::OfBasin& b) {
  if (a.values == 0) return b;
  if (b.values == 0) return a;
  return {std::min(a.least, b.least), std::max(a.largest, b.largest), a.sum + b.sum,
          a.values + b.values};
}

double sum_of(std::span<const double> readings) {
  double sum = 0;
  for (const double reading : readings) sum += std::isnan(reading) ? 0 : reading;
  return sum;
}

/// Joins a stretch to the one before it.
void join(SeriesStretch& into, SeriesStretch&& next) {
  into.steps += next.steps;
  for (std::size_t b = 0; b < into.basins.size(); ++b)
    into.basins[b] = joined(into.basins[b], next.basins[b]);
  if (next.gauges_sum <= into.gauges_sum) return;
  into.time = std::move(next.time);
  into.readings = std::move(next.readings);
  into.gauges_sum = next.gauges_sum;
}

}  // namespace

ThinnedSeries::ThinnedSeries(std::size_t basins, std::size_t gauges, const SeriesLimits& limits)
    : wanted_(std::clamp(limits.values / std::max<std::size_t>(basins, 1), limits.fewest,
                         std::max(limits.fewest, limits.most))),
      most_readings_(limits.readings),
      silent_(gauges),
      since_(gauges),
      longest_(gauges) {}

void ThinnedSeries::add(const std::string& time, std::span<const double> basins,
                        std::span<const double> readings) {
  note_silence(readings);
  ++steps_;
  SeriesStretch step{1, time, time, {}, sum_of(readings), {}};
  for (const double value : basins) step.basins.push_back(of_one(value));
  if (has_readings_) step.readings.assign(readings.begin(), readings.end());
  if (!stretches_.empty() && stretches_.back().steps < length_) {
    join(stretches_.back(), std::move(step));
    return;
  }
  if (stretches_.size() == 2 * wanted_) {
    join_pairs();
  }
  stretches_.push_back(std::move(step));
  if (stretches_.size() * readings.size() > most_readings_) leave_readings_out();
}

void ThinnedSeries::note_silence(std::span<const double> readings) {
  for (std::size_t i = 0; i < readings.size(); ++i) {
    since_[i] = std::isnan(readings[i]) ? since_[i] + 1 : 0;
    silent_[i] += since_[i] > 0 ? 1U : 0U;
    longest_[i] = std::max(longest_[i], since_[i]);
  }
}

void ThinnedSeries::join_pairs() {
  for (std::size_t i = 0; 2 * i + 1 < stretches_.size(); ++i) {
    if (i > 0) stretches_[i] = std::move(stretches_[2 * i]);
    join(stretches_[i], std::move(stretches_[2 * i + 1]));
  }
  stretches_.resize(wanted_);
  length_ *= 2;
}

void ThinnedSeries::leave_readings_out() {
  has_readings_ = false;
  for (SeriesStretch& stretch : stretches_) {
    stretch.readings.clear();
    stretch.readings.shrink_to_fit();
  }
}

}  // namespace thiessen
