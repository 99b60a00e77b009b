#include "rainfall/totals/total_spreading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace thiessen {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The sum of all amounts that are known, without what rounding would lose in a long one (Neumaier
/// 1974).
double sum_of(std::span<const double> amounts) {
  double sum = 0;
  double lost = 0;
  for (const double amount : amounts) {
    if (std::isnan(amount)) continue;
    const double more = sum + amount;
    lost += std::abs(sum) >= std::abs(amount) ? (sum - more) + amount : (amount - more) + sum;
    sum = more;
  }
  return sum + lost;
}

void mend_rounding(double total, std::span<double> amounts) {
  std::size_t largest = amounts.size();
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    if (std::isnan(amounts[i])) continue;
    if (largest == amounts.size() || amounts[i] > amounts[largest]) largest = i;
  }
  if (largest < amounts.size()) amounts[largest] += total - sum_of(amounts);
}

}  // namespace

SpreadBy spread_total(double total, std::span<const double> around, std::span<double> amounts) {
  if (around.empty()) return SpreadBy::nothing;
  std::size_t reported = 0;
  double most = 0;
  for (const double rain : around) {
    if (std::isnan(rain)) continue;
    ++reported;
    most = std::max(most, rain);
  }
  if (reported == 0) {
    std::fill(amounts.begin(), amounts.end(), total / static_cast<double>(amounts.size()));
    mend_rounding(total, amounts);
    return SpreadBy::evenly_unreported;
  }
  // Shares of the largest cannot overflow, however large or small the rain around is.
  double sum = 0;
  for (const double rain : around) sum += std::isnan(rain) || most == 0 ? 0 : rain / most;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const double share = most == 0 ? 1 / static_cast<double>(reported) : around[i] / most / sum;
    amounts[i] = std::isnan(around[i]) ? nothing : total * share;
  }
  mend_rounding(total, amounts);
  return most == 0 ? SpreadBy::evenly_dry : SpreadBy::gauges;
}

}  // namespace thiessen
