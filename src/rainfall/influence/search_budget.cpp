#include "rainfall/influence/search_budget.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "rainfall/network/reporting.h"
#include "rainfall/series/gauge_patterns.h"

namespace thiessen {
namespace {

// These are in microseconds, measured as SearchWork says.
constexpr double of_the_picture = 150e3;
constexpr double of_a_gauge = 150;  // its vertices and edges, clipped, measured and written
constexpr double of_a_weight_and_step = 0.02;
constexpr double of_a_reading = 0.03;
constexpr double of_a_handover = 20;
constexpr double of_a_cell_handed_over = 15;
constexpr double of_a_departure = 35;  // one for each set of silent cells beside it

double handover_of(std::size_t cells) {
  return of_a_handover + of_a_cell_handed_over * static_cast<double>(cells);
}

/// A component of silent cells, or a cell and the components beside it, by its hash; two with the
/// same hash are taken for one.
using Key = std::uint64_t;
Key mixed(Key key, std::uint64_t number) {
  key = (key ^ number) * 0x9E3779B97F4A7C15u;
  return key ^ (key >> 29);
}

/// Counts what the steps of a sample need.
class Counting {
 public:
  Counting(const Handovers& handovers, SearchWork& work)
      : handovers_(handovers), work_(work), component_of_(handovers.adjacency().cells()) {}

  void take(std::span<const double> readings) {
    find_components(readings);
    for (std::uint32_t c = 0; c < component_of_.size(); ++c) {
      if (component_of_[c] == reports && handovers_.has_ground(PlaceIndex{c})) leave(PlaceIndex{c});
    }
  }
  double values() const { return values_; }

 private:
  static constexpr std::uint32_t reports = 0xFFFFFFFFu;
  static constexpr std::uint32_t none = 0xFFFFFFFEu;  // a place without a cell of its own

  struct Component {
    Key key;
    std::size_t cells;
  };

  bool is_silent(PlaceIndex cell, std::span<const double> readings) const {
    const auto stations = handovers_.cells().stations_of(cell);
    return std::all_of(stations.begin(), stations.end(),
                       [&](StationIndex s) { return std::isnan(readings[index(s)]); });
  }

  void find_components(std::span<const double> readings) {
    std::vector<PlaceIndex> silent;
    for (std::uint32_t c = 0; c < component_of_.size(); ++c) {
      component_of_[c] = handovers_.cells().stations_of(PlaceIndex{c}).empty() ? none : reports;
      if (component_of_[c] == reports && is_silent(PlaceIndex{c}, readings))
        silent.push_back(PlaceIndex{c});
    }
    components_.clear();
    for (const auto& component : components_of(silent, handovers_.adjacency())) {
      Key key = component.size();
      for (const PlaceIndex cell : component) {
        component_of_[index(cell)] = static_cast<std::uint32_t>(components_.size());
        key = mixed(key, index(cell));
      }
      components_.push_back({key, component.size()});
      if (in_values_.insert(key).second) values_ += handover_of(component.size());
    }
  }

  // Counts what is handed over if one more cell falls silent (see Departures). It is often counted
  // when it is remembered, for what is beside may differ in cells that do not matter. With normals
  // it is the handover of them all.
  void leave(PlaceIndex cell) {
    beside_.clear();
    for (const PlaceIndex q : handovers_.adjacency().neighbours(cell)) {
      if (component_of_[index(q)] < components_.size()) beside_.push_back(component_of_[index(q)]);
    }
    if (beside_.empty()) return;
    std::sort(beside_.begin(), beside_.end());
    beside_.erase(std::unique(beside_.begin(), beside_.end()), beside_.end());
    Key key = mixed(1, index(cell));
    std::size_t cells = 1;
    for (const std::uint32_t c : beside_) {
      key = mixed(key, components_[c].key);
      cells += components_[c].cells;
    }
    if (in_search_.insert(key).second)
      work_.all += handovers_.normals() == nullptr ? of_a_departure : handover_of(cells);
  }

  const Handovers& handovers_;
  SearchWork& work_;
  std::vector<std::uint32_t> component_of_;  // by cell: its silent component
  std::vector<Component> components_;
  std::vector<std::uint32_t> beside_;
  std::unordered_set<Key> in_values_;
  std::unordered_set<Key> in_search_;
  double values_ = 0;
};

}  // namespace

SearchWork search_work(const Handovers& handovers, const StepSample& sample,
                       std::size_t steps_of_series) {
  SearchWork work;
  work.steps = sample.steps();
  const auto gauges = static_cast<double>(sample.stations());
  const auto steps = static_cast<double>(steps_of_series);
  Counting counting(handovers, work);
  GaugePatterns patterns;
  for (std::size_t step = 0; step < sample.steps(); ++step) {
    if (patterns.of(sample[step]).is_fresh) counting.take(sample[step]);
  }
  const double of_all_steps = steps / std::max(1.0, static_cast<double>(sample.steps()));
  work.run = of_the_picture + of_a_gauge * gauges + of_a_reading * gauges * steps +
             of_a_weight_and_step * static_cast<double>(handovers.full().size()) * steps +
             counting.values() * of_all_steps;
  for (std::uint32_t c = 0; c < handovers.adjacency().cells(); ++c) {
    if (handovers.has_ground(PlaceIndex{c})) work.once += handover_of(1);
  }
  return work;
}

std::size_t spacing_within(const SearchWork& work, double share, double least) {
  const double left = std::max(share * work.run, least) - work.once;
  if (work.all <= left) return 1;
  const std::size_t most = std::max<std::size_t>(work.steps, 1);
  if (!(left > 0) || work.all >= left * static_cast<double>(most)) return most;
  return static_cast<std::size_t>(std::ceil(work.all / left));
}

}  // namespace thiessen
