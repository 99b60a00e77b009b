#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"

namespace thiessen {

/// Gauge 0 with others round it, each of which borders on it and on the next.
inline Network ring_network(std::uint32_t others) {
  std::vector<Station> stations{{"0", {0, 0}}};
  for (std::uint32_t i = 1; i <= others; ++i) {
    const double angle = 2 * 3.141592653589793 * i / others;
    stations.push_back({std::to_string(i), {std::cos(angle), std::sin(angle)}});
  }
  return {stations, Metric::planar};
}

inline std::vector<StationBorder> ring_borders(std::uint32_t others) {
  std::vector<StationBorder> borders;
  for (std::uint32_t i = 1; i <= others; ++i) {
    borders.push_back({StationIndex{0}, StationIndex{i}, 1});
    borders.push_back({StationIndex{i}, StationIndex{i % others + 1}, 1});
  }
  return borders;
}

inline GaugeNeighbours ring_of(std::uint32_t others) {
  return {ring_network(others), ring_borders(others)};
}

inline constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Steps that are shown to a search, with what it finds in them.
class ShownSteps {
 public:
  explicit ShownSteps(FindingSearch& search) : search_(search) {}

  void show(const std::string& time, const std::vector<double>& readings, bool follows = true) {
    std::vector<StationIndex> wet;
    std::vector<StationIndex> without;
    for (std::uint32_t g = 0; g < readings.size(); ++g) {
      if (readings[g] > 0) wet.push_back(StationIndex{g});
      if (std::isnan(readings[g])) without.push_back(StationIndex{g});
    }
    search_.see({time, readings, wet, without, follows}, take_);
  }

  std::vector<ReadingFinding> found;

 private:
  FindingSearch& search_;
  TakeFinding take_ = [this](ReadingFinding finding) { found.push_back(std::move(finding)); };
};

/// Puts the steps of some readings, which follow each other, into stretches of one year.
inline void for_each_stretch(const std::vector<std::vector<double>>& steps, std::optional<int> year,
                             const std::function<void(const Stretch&)>& take) {
  Stretch stretch(steps.front().size());
  const std::string time;
  stretch.clear(year);
  for (const std::vector<double>& readings : steps) {
    std::vector<StationIndex> wet;
    std::vector<StationIndex> without;
    for (std::uint32_t g = 0; g < readings.size(); ++g) {
      if (readings[g] > 0) wet.push_back(StationIndex{g});
      if (std::isnan(readings[g])) without.push_back(StationIndex{g});
    }
    stretch.add({time, readings, wet, without, true});
    if (!stretch.is_full()) continue;
    take(stretch);
    stretch.clear(year);
  }
  if (stretch.steps() > 0) take(stretch);
}

}  // namespace thiessen
