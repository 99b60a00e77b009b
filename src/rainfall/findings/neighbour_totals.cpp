#include "rainfall/findings/neighbour_totals.h"

#include <bit>

namespace thiessen {

std::vector<NeighbourTotals::Totals>& NeighbourTotals::of_year(std::optional<int> year) {
  std::vector<Totals>& totals = year ? years_[*year] : without_year_;
  totals.resize(neighbours_.pairs().size());
  return totals;
}

void NeighbourTotals::add(const Stretch& stretch) {
  std::vector<Totals>& totals = of_year(stretch.year());
  for (std::size_t p = 0; p < totals.size(); ++p) {
    const GaugeNeighbours::Pair& pair = neighbours_.pairs()[p];
    const std::size_t a = index(pair.first);
    const std::size_t b = index(pair.second);
    const Stretch::Bits both = stretch.reports(a) & stretch.reports(b);
    totals[p].steps += static_cast<std::uint32_t>(std::popcount(both));
    const Stretch::Bits wet = (stretch.wet(a) | stretch.wet(b)) & both;
    if (wet == 0) continue;
    if (wet_steps_[p] < most_wet_steps)
      wet_steps_[p] += static_cast<std::size_t>(std::popcount(wet));
    totals[p].first += static_cast<float>(stretch.sum(a, both));
    totals[p].second += static_cast<float>(stretch.sum(b, both));
  }
}

NeighbourTotals::Sums NeighbourTotals::of_all(std::uint32_t pair) const {
  Sums sums;
  const auto add = [&](const std::vector<Totals>& totals) {
    if (totals.empty()) return;
    sums.first += static_cast<double>(totals[pair].first);
    sums.second += static_cast<double>(totals[pair].second);
  };
  for (const auto& [year, totals] : years_) add(totals);
  add(without_year_);
  return sums;
}

}  // namespace thiessen
