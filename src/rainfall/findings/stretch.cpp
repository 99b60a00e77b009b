#include "rainfall/findings/stretch.h"

#include <algorithm>

namespace thiessen {
namespace {

constexpr std::size_t amounts_at_most = 2'000'000;

}  // namespace

Stretch::Stretch(std::size_t gauges)
    : most_steps_(
          std::clamp<std::size_t>(amounts_at_most / std::max<std::size_t>(gauges, 1), 2, 64)),
      silent_(gauges),
      wet_(gauges),
      totals_(gauges),
      amounts_(gauges * stride()) {}

void Stretch::clear(std::optional<int> year) {
  steps_ = 0;
  year_ = year;
  descends_ = false;
  std::fill(silent_.begin(), silent_.end(), Bits{0});
  std::fill(wet_.begin(), wet_.end(), Bits{0});
  std::fill(totals_.begin(), totals_.end(), 0.0);
}

void Stretch::add(const SeenStep& step) {
  const Bits bit = Bits{1} << steps_;
  for (const StationIndex gauge : step.silent) silent_[index(gauge)] |= bit;
  for (const StationIndex gauge : step.wet) {
    const std::size_t g = index(gauge);
    wet_[g] |= bit;
    amounts_[g * stride() + steps_] = step.readings[g];
    totals_[g] += step.readings[g];
  }
  ++steps_;
}

}  // namespace thiessen
