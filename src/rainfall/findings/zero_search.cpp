#include "rainfall/findings/zero_search.h"

#include <cstdint>
#include <span>

#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {

ZeroSearch::ZeroSearch(const GaugeNeighbours& neighbours, double much)
    : neighbours_(neighbours), much_(much), asked_(neighbours.gauges() + 1) {
  for (std::uint32_t g = 0; g < neighbours.gauges(); ++g) {
    const auto of_gauge = neighbours.of(StationIndex{g});
    first_.push_back(of_gauge.empty() ? StationIndex{g} : of_gauge.front().station);
  }
}

bool ZeroSearch::do_all_read_much(const SeenStep& step, StationIndex gauge) const {
  std::size_t with_much = 0;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours_.of(gauge)) {
    const double reading = step.readings[index(neighbour.station)];
    if (reading < much_) return false;
    with_much += reading >= much_ ? 1u : 0u;  // and the silent ones say nothing
  }
  return with_much >= least_neighbours;
}

void ZeroSearch::see(const SeenStep& step, const TakeFinding& take) {
  std::size_t with_much = 0;
  for (const StationIndex gauge : step.wet)
    with_much += step.readings[index(gauge)] >= much_ ? 1u : 0u;
  if (with_much < least_neighbours) return;
  // Who reads 0 cannot be foreseen: those whose first neighbour allows it are listed without a
  // branch.
  std::size_t asked = 0;
  for (std::uint32_t g = 0; g < first_.size(); ++g) {
    asked_[asked] = StationIndex{g};
    const bool is_zero = step.readings[g] == 0;
    const bool has_little = step.readings[index(first_[g])] < much_;
    asked += static_cast<std::size_t>(is_zero) & static_cast<std::size_t>(!has_little);
  }
  for (const StationIndex gauge : std::span(asked_).first(asked)) {
    if (!do_all_read_much(step, gauge)) continue;
    take({gauge, FindingKind::zero, step.time, 0, expected_reading(neighbours_, step, gauge)});
  }
}

}  // namespace thiessen
