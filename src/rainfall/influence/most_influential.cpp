#include "rainfall/influence/most_influential.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "rainfall/influence/influence.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/gauge_patterns.h"

namespace thiessen {
namespace {

constexpr std::size_t steps_in_a_block = 64;
constexpr std::size_t remembered_bytes = std::size_t{64} << 20;

/// The number of cells that report, have ground and have a silent neighbour: each needs a handover
/// of several cells.
std::size_t cells_beside_gaps(const Handovers& handovers, std::span<const double> readings) {
  const CellAdjacency& adjacency = handovers.adjacency();
  ReportingPlaces report(adjacency.cells(), false);
  for (std::uint32_t c = 0; c < report.size(); ++c) {
    for (const StationIndex s : handovers.cells().stations_of(PlaceIndex{c})) {
      if (!std::isnan(readings[index(s)])) report.set(PlaceIndex{c}, true);
    }
  }
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < report.size(); ++c) {
    if (!report[PlaceIndex{c}] || !handovers.has_ground(PlaceIndex{c})) continue;
    const auto next = adjacency.neighbours(PlaceIndex{c});
    count +=
        std::all_of(next.begin(), next.end(), [&](PlaceIndex q) { return report[q]; }) ? 0u : 1u;
  }
  return count;
}

/// How many steps to go on at a time so that about `most_handovers` are computed. Sets of reporting
/// gauges that come again cost nothing, so each counts once.
std::size_t spacing(const Handovers& handovers, const StepSample& sample,
                    std::size_t most_handovers) {
  GaugePatterns patterns;
  std::size_t handovers_wanted = 0;
  for (std::size_t step = 0; step < sample.steps(); ++step) {
    if (patterns.of(sample[step]).is_fresh)
      handovers_wanted += cells_beside_gaps(handovers, sample[step]);
  }
  const std::size_t most = std::max<std::size_t>(most_handovers, 1);
  return std::max<std::size_t>(1, (handovers_wanted + most - 1) / most);
}

}  // namespace

SampledInfluence most_influential(const Handovers& handovers, const StepSample& sample,
                                  std::size_t most_handovers, unsigned threads) {
  std::vector<std::span<const double>> rows;
  const std::size_t spaced = spacing(handovers, sample, most_handovers);
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
