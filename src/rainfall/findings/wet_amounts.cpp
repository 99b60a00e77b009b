#include "rainfall/findings/wet_amounts.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {
namespace {

constexpr int bits_of_fraction = 52;
constexpr int bits_within_octave = 4;
/// The class of 2^-12: what is less counts there, and from 2^20 on in the last class.
constexpr std::int64_t first_class = std::int64_t{1023 - 12} << bits_within_octave;

std::size_t class_of(double amount, std::size_t classes) {
  const auto number =
      std::bit_cast<std::int64_t>(amount) >> (bits_of_fraction - bits_within_octave);
  return static_cast<std::size_t>(
      std::clamp<std::int64_t>(number - first_class, 0, static_cast<std::int64_t>(classes) - 1));
}

/// Where a class begins.
double begin_of(std::size_t at) {
  return std::bit_cast<double>((static_cast<std::int64_t>(at) + first_class)
                               << (bits_of_fraction - bits_within_octave));
}

}  // namespace

void WetAmounts::add(StationIndex gauge, double amount) {
  ++counts_[index(gauge) % most_counted][class_of(amount, classes)];
  ++count_;
}

double WetAmounts::quantile_of(const std::array<std::uint64_t, classes>& counts, double share) {
  const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  if (all == 0) return std::numeric_limits<double>::quiet_NaN();
  double rest = share * static_cast<double>(all);
  for (std::size_t i = 0; i < classes; ++i) {
    const auto here = static_cast<double>(counts[i]);
    if (here > 0 && rest <= here)
      return begin_of(i) + (begin_of(i + 1) - begin_of(i)) * rest / here;
    rest -= here;
  }
  return begin_of(classes);
}

double WetAmounts::quantile(double share, const std::function<bool(StationIndex)>& counts) const {
  std::vector<bool> left_out(counts_.size());
  for (std::uint32_t g = 0; g < gauges_; ++g) {
    if (!counts(StationIndex{g})) left_out[g % most_counted] = true;
  }
  std::array<std::uint64_t, classes> sums{};
  for (std::size_t g = 0; g < counts_.size(); ++g) {
    if (left_out[g]) continue;
    for (std::size_t i = 0; i < classes; ++i) sums[i] += counts_[g][i];
  }
  return quantile_of(sums, share);
}

double WetAmounts::median_quantile(double share, std::size_t least) const {
  std::vector<double> quantiles;
  for (const Counts& counts : counts_) {
    std::array<std::uint64_t, classes> wide{};
    std::copy(counts.begin(), counts.end(), wide.begin());
    if (std::accumulate(wide.begin(), wide.end(), std::uint64_t{0}) >= least)
      quantiles.push_back(quantile_of(wide, share));
  }
  return median_of(quantiles);
}

}  // namespace thiessen
