#include "study/weight_findings.h"

#include <algorithm>
#include <cmath>

#include "basin/containment.h"

namespace thiessen {

bool WeightFindings::OfBasin::adds_up() const {
  return std::abs(sum - 1) < 1e-9;
}

WeightFindings findings_of(const Study& study, const std::vector<BasinWeights>& weights) {
  std::vector<Point> positions;
  for (const Station& station : study.network().stations()) positions.push_back(station.position);
  const double period = study.parts().metric == Metric::geodesic ? 360 : 0;
  const auto inside = count_within(study.basins(), positions, period);
  std::vector<bool> weighs(positions.size(), false);
  WeightFindings findings;
  findings.basins.resize(weights.size());
  for (std::size_t b = 0; b < weights.size(); ++b) {
    WeightFindings::OfBasin& basin = findings.basins[b];
    basin.gauges_inside = inside[b];
    if (inside[b] == 0) ++findings.basins_without_gauge;
    for (const StationWeight& s : weights[b].stations) {
      weighs[index(s.station)] = true;
      basin.largest_weight = std::max(basin.largest_weight, s.weight);
      basin.sum += s.weight;
    }
  }
  findings.idle_gauges = static_cast<std::size_t>(std::count(weighs.begin(), weighs.end(), false));
  return findings;
}

}  // namespace thiessen
