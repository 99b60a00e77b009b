#include "rainfall/findings/homogeneity.h"

#include <numeric>

namespace thiessen {

MeanChange mean_change(std::span<const double> values, std::size_t least) {
  MeanChange found;
  if (values.size() < 2 * least || values.size() < 2) return found;
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double variance = squares / (count - 1);
  if (!(variance > 0)) return found;
  double before = 0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    before += values[k - 1] - mean;
    if (k < least || values.size() - k < least) continue;
    const auto first = static_cast<double>(k);
    // The sum of all deviations is 0, so that the rest has the same sum with the other sign.
    const double statistic = before * before / variance * (1 / first + 1 / (count - first));
    if (statistic > found.statistic) found = {k, statistic};
  }
  return found;
}

}  // namespace thiessen
