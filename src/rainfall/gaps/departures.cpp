#include "rainfall/gaps/departures.h"

#include <algorithm>

namespace thiessen {

void Departures::add_borders(PlaceIndex cell, const HandoverParts& made_of,
                             std::vector<PlaceIndex>& heirs) {
  for (const auto& [a, b] : made_of.borders) {
    if (a == cell) heirs.push_back(b);
    if (b == cell) heirs.push_back(a);
  }
  for (const PlaceIndex heir : made_of.unmeasured) {
    if (heir != cell) heirs.push_back(heir);
  }
}

// The heirs come in rising order, and after their number the regions, so that the lists can be told
// from the key.
std::shared_ptr<const Departures::Shares> Departures::shared(Bench& bench) {
  std::sort(bench.heirs.begin(), bench.heirs.end());
  bench.heirs.erase(std::unique(bench.heirs.begin(), bench.heirs.end()), bench.heirs.end());
  std::sort(bench.regions.begin(), bench.regions.end());
  bench.key.assign(1, static_cast<std::uint32_t>(bench.heirs.size()));
  for (const PlaceIndex heir : bench.heirs)
    bench.key.push_back(static_cast<std::uint32_t>(index(heir)));
  bench.key.insert(bench.key.end(), bench.regions.begin(), bench.regions.end());
  return remembered_.of(
      bench.key, [&] { return handovers_.shared_among(bench.heirs, bench.regions); },
      [](const Shares& shares) { return shares.capacity() * sizeof(CellWeight); });
}

}  // namespace thiessen
