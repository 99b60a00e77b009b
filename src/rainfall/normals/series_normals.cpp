#include "rainfall/normals/series_normals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr std::size_t bits = 64;
constexpr double enough = 1e-10;
constexpr int most_turns = 1000;

/// Calls visit(gauge) for each gauge of a set.
template <class Visit>
void for_each_of(const std::vector<std::uint64_t>& set, Visit visit) {
  for (std::size_t word = 0; word < set.size(); ++word) {
    for (std::uint64_t left = set[word]; left != 0; left &= left - 1)
      visit(word * bits + static_cast<std::size_t>(std::countr_zero(left)));
  }
}

}  // namespace

SeriesNormals::SeriesNormals(std::size_t gauges) : sums_(gauges), counts_(gauges) {}

void SeriesNormals::add(std::span<const double> readings) {
  Set set((sums_.size() + bits - 1) / bits);
  double total = 0;
  for (std::size_t gauge = 0; gauge < readings.size(); ++gauge) {
    const double reading = readings[gauge];
    if (std::isnan(reading)) continue;
    set[gauge / bits] |= std::uint64_t{1} << gauge % bits;
    sums_[gauge] += reading;
    ++counts_[gauge];
    total += reading;
  }
  totals_[std::move(set)] += total;
}

std::vector<double> SeriesNormals::result() const {
  std::vector<double> normals(sums_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (counts_[i] > 0) normals[i] = sums_[i] / static_cast<double>(counts_[i]);
  }
  for (int turn = 0; turn < most_turns; ++turn) {
    throw_if_interrupted();
    std::vector<double> states(sums_.size());  // by gauge: the sum of s_t over its steps
    for (const auto& [set, total] : totals_) {
      double of_all = 0;
      for_each_of(set, [&](std::size_t i) { of_all += normals[i]; });
      if (!(of_all > 0)) continue;
      for_each_of(set, [&, state = total / of_all](std::size_t i) { states[i] += state; });
    }
    double change = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      if (!(states[i] > 0)) continue;
      const double next = sums_[i] / states[i];
      if (next > 0) change = std::max(change, std::abs(next / normals[i] - 1));
      normals[i] = next;
    }
    if (change <= enough) break;
  }
  return normals;
}

}  // namespace thiessen
