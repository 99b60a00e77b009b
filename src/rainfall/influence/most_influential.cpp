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
  for (std::size_t step = 0; step < sample.steps(); step += spaced) rows.push_back(sample[step]);
  Influence influence(handovers, remembered_bytes, threads);
  for (std::size_t first = 0; first < rows.size(); first += steps_in_a_block)
    influence.add(StepRows(rows).subspan(first, std::min(steps_in_a_block, rows.size() - first)));
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
