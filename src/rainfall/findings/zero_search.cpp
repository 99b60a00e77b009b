#include "rainfall/findings/zero_search.h"

#include <cstdint>
#include <span>

#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {

ZeroSearch::ZeroSearch(const GaugeNeighbours& neighbours, double much)
    : neighbours_(neighbours),
      much_(much),
      asked_(neighbours.gauges() + 1),
      doubts_(neighbours.gauges()) {
  for (std::uint32_t g = 0; g < neighbours.gauges(); ++g) {
    const StationIndex gauge{g};
    const auto of_gauge = neighbours.of(gauge);
    first_two_.push_back(of_gauge.size() < least_neighbours
                             ? Two{gauge, gauge}
                             : Two{of_gauge[0].station, of_gauge[1].station});
  }
}

bool ZeroSearch::rained_all_round(const SeenStep& step, StationIndex gauge) const {
  std::size_t with_much = 0;
  unsigned doubts = 0;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours_.of(gauge)) {
    doubts += doubts_[index(neighbour.station)];
    if (doubts > most_doubts) return false;
    with_much += step.readings[index(neighbour.station)] >= much_ ? 1u : 0u;
  }
  return with_much >= least_neighbours;
}

void ZeroSearch::see(const SeenStep& step, const TakeFinding& take) {
  std::size_t with_much = 0;
  for (const StationIndex gauge : step.wet)
    with_much += step.readings[index(gauge)] >= much_ ? 1u : 0u;
  if (with_much < least_neighbours) return;
  for (std::size_t g = 0; g < doubts_.size(); ++g) {
    const double reading = step.readings[g];
    doubts_[g] = static_cast<std::uint8_t>((reading < much_ ? 1 : 0) + (reading == 0 ? 1 : 0));
  }
  // Who reads 0 cannot be foreseen: those whose first two neighbours allow it are listed without a
  // branch.
  std::size_t asked = 0;
  for (std::uint32_t g = 0; g < first_two_.size(); ++g) {
    asked_[asked] = StationIndex{g};
    const unsigned doubts =
        doubts_[index(first_two_[g].first)] + doubts_[index(first_two_[g].second)];
    const auto is_zero = static_cast<unsigned>(doubts_[g] == doubts_of_zero);
    asked += is_zero & static_cast<unsigned>(doubts <= most_doubts);
  }
  for (const StationIndex gauge : std::span(asked_).first(asked)) {
    if (!rained_all_round(step, gauge)) continue;
    take({gauge, FindingKind::zero, step.time, 0, expected_reading(neighbours_, step, gauge)});
  }
}

}  // namespace thiessen
