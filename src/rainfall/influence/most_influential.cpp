#include "rainfall/influence/most_influential.h"

#include <algorithm>
#include <span>

#include "rainfall/influence/influence.h"

namespace thiessen {
namespace {

constexpr std::size_t steps_in_a_block = 64;
constexpr std::size_t remembered_bytes = std::size_t{64} << 20;

}  // namespace

SampledInfluence most_influential(const Handovers& handovers, const StepSample& sample,
                                  std::size_t spaced, unsigned threads) {
  std::vector<std::span<const double>> rows;
  std::vector<std::size_t> months;
  for (std::size_t step = 0; step < sample.steps(); step += spaced) {
    rows.push_back(sample[step]);
    if (!sample.months().empty()) months.push_back(sample.months()[step]);
  }
  Influence influence(handovers, remembered_bytes, threads);
  for (std::size_t first = 0; first < rows.size(); first += steps_in_a_block) {
    const std::size_t count = std::min(steps_in_a_block, rows.size() - first);
    influence.add(StepRows(rows).subspan(first, count),
                  months.empty() ? std::span<const std::size_t>()
                                 : std::span<const std::size_t>(months).subspan(first, count));
  }
  SampledInfluence result{{}, rows.size()};
  for (const auto& basin : influence.result()) {
    MostInfluential most{StationIndex{0}, 0};
    for (const GaugeInfluence& gauge : basin) {
      if (gauge.rms_change > most.rms_change) most = {gauge.station, gauge.rms_change};
    }
    result.gauges.push_back(most);
  }
  return result;
}

}  // namespace thiessen
