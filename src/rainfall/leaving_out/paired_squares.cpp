#include "rainfall/leaving_out/paired_squares.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace thiessen {
namespace {

/// The sum of the squares of sums over clusters, for the finite number of which it is corrected.
double clustered(std::span<const double> sums) {
  double squares = 0;
  for (const double sum : sums) squares += sum * sum;
  const auto count = static_cast<double>(sums.size());
  return count > 1 ? squares * count / (count - 1) : 0;
}

}  // namespace

double critical_t(double degrees) {
  constexpr double z = 1.959963984540054;
  constexpr double z2 = z * z;
  const double v = degrees;
  return z * (1 + (z2 + 1) / (4 * v) + ((5 * z2 + 16) * z2 + 3) / (96 * v * v) +
              (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * v * v * v));
}

SquaredDifference PairedSquares::difference(std::size_t first, std::size_t second) const {
  std::vector<double> cells(counts_.size());
  double sum = 0;
  double count = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    cells[c] = sums_[c * estimates_ + first] - sums_[c * estimates_ + second];
    sum += cells[c];
    count += static_cast<double>(counts_[c]);
  }
  SquaredDifference difference;
  if (!(count > 0)) return difference;
  difference.mean = sum / count;
  std::vector<double> by_group(groups_);
  std::vector<double> by_stretch(stretches_);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    cells[c] -= difference.mean * static_cast<double>(counts_[c]);
    by_group[c / stretches_] += cells[c];
    by_stretch[c % stretches_] += cells[c];
  }
  const bool has_stretches = stretches_ >= least_groups;
  double variance = clustered(by_group);
  if (has_stretches) {
    const double of_time = clustered(by_stretch);
    variance = std::max({variance, of_time, variance + of_time - clustered(cells)});
  }
  difference.is_told = groups_ >= least_groups && variance > 0;
  if (!difference.is_told) return difference;
  difference.t = sum / std::sqrt(variance);
  const std::size_t clusters = has_stretches ? std::min(groups_, stretches_) : groups_;
  difference.critical = critical_t(static_cast<double>(clusters - 1));
  return difference;
}

}  // namespace thiessen
