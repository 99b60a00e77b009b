#include "rainfall/areal_rainfall.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "geometry/long_sum.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Of those that report; NaN: none does.
double mean_reading(std::span<const StationIndex> stations, std::span<const double> readings) {
  if (stations.size() == 1) return readings[index(stations.front())];
  LongSum sum;
  std::size_t count = 0;
  for (const StationIndex s : stations) {
    const double reading = readings[index(s)];
    if (std::isnan(reading)) continue;
    sum.add(reading);
    ++count;
  }
  return count == 0 ? no_value : sum.value() / static_cast<double>(count);
}

/// Of weights by basin, the first of each basin, then the second of each.
std::vector<CellWeight> in_turn(const std::vector<CellWeight>& weights) {
  std::vector<std::pair<std::size_t, CellWeight>> turns;
  turns.reserve(weights.size());
  std::size_t turn = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    turn = i > 0 && weights[i].basin == weights[i - 1].basin ? turn + 1 : 0;
    turns.emplace_back(turn, weights[i]);
  }
  std::stable_sort(turns.begin(), turns.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<CellWeight> result;
  result.reserve(turns.size());
  for (const auto& [_, weight] : turns) result.push_back(weight);
  return result;
}

}  // namespace

ArealRainfall::ArealRainfall(const Weighing& weighing, const ArealRainfallSettings& settings,
                             unsigned threads)
    : settings_(settings), network_(weighing.network()) {
  if (settings.gaps == Gaps::retessellate) {
    handovers_ = std::make_unique<const Handovers>(weighing, threads);
    remembered_ = std::make_unique<HandoverCache>(*handovers_, settings.remembered_bytes);
    full_ = handovers_->full_weights();
    full_in_turn_ = in_turn(handovers_->full());
  } else {
    full_ =
        weighing.weights(std::vector<bool>(weighing.network().stations().size(), true), threads);
  }
}

std::size_t ArealRainfall::reporting_in(PlaceIndex cell, std::span<const double> readings) const {
  const auto stations = handovers_->cells().stations_of(cell);
  return static_cast<std::size_t>(
      std::count_if(stations.begin(), stations.end(),
                    [&](StationIndex s) { return !std::isnan(readings[index(s)]); }));
}

ArealRainfall::State ArealRainfall::state_of(std::span<const double> readings) const {
  const NetworkCells& cells = handovers_->cells();
  State state;
  state.of_cell.assign(handovers_->adjacency().cells(), no_value);
  std::vector<PlaceIndex> silent;
  for (std::uint32_t p = 0; p < state.of_cell.size(); ++p) {
    const auto stations = cells.stations_of(PlaceIndex{p});
    if (stations.empty()) continue;
    state.of_cell[p] = mean_reading(stations, readings);
    if (std::isnan(state.of_cell[p])) {
      silent.push_back(PlaceIndex{p});
    } else {
      state.any = true;
    }
  }
  if (!state.any) return state;
  for (const auto& component : components_of(silent, handovers_->adjacency()))
    state.handovers.push_back(remembered_->of(component));
  return state;
}

std::vector<double> ArealRainfall::cell_readings(std::span<const double> readings) const {
  std::vector<double> of_cell(network_.places().size());
  for (std::uint32_t p = 0; p < of_cell.size(); ++p) {
    const PlaceIndex cell{p};
    of_cell[p] = mean_reading(
        handovers_ ? handovers_->cells().stations_of(cell) : network_.stations_at(cell), readings);
  }
  return of_cell;
}

std::vector<BasinRainfall> ArealRainfall::retessellated(const State& state,
                                                        std::span<const double> readings) const {
  std::vector<LongSum> sums(full_.size());
  for (const CellWeight& full : full_in_turn_) {
    const double reading = state.of_cell[index(full.cell)];
    if (!std::isnan(reading)) sums[full.basin].add(full.weight * reading);
  }
  for (const auto& handover : state.handovers) {
    for (const CellWeight& share : *handover)
      sums[share.basin].add(share.weight * state.of_cell[index(share.cell)]);
  }
  std::vector<BasinRainfall> result;
  result.reserve(sums.size());
  for (const LongSum& sum : sums) result.push_back({state.any ? sum.value() : no_value, 0, 0});
  if (settings_.accounts || settings_.min_gauges > 1) count_gauges(state, readings, result);
  return result;
}

// The weights of those that report, by basin, then by cell.
std::vector<CellWeight> ArealRainfall::weights_of(const State& state) const {
  std::vector<CellWeight> weights;
  for (const CellWeight& full : handovers_->full()) {
    if (!std::isnan(state.of_cell[index(full.cell)])) weights.push_back(full);
  }
  for (const auto& handover : state.handovers)
    weights.insert(weights.end(), handover->begin(), handover->end());
  std::stable_sort(weights.begin(), weights.end(), [](const CellWeight& a, const CellWeight& b) {
    return std::pair(a.basin, a.cell) < std::pair(b.basin, b.cell);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < weights.size();) {
    CellWeight& whole = weights[kept++];
    LongSum sum;
    const CellWeight first = weights[i];
    for (; i < weights.size() && weights[i].basin == first.basin && weights[i].cell == first.cell;
         ++i) {
      sum.add(weights[i].weight);
    }
    whole = {first.basin, first.cell, sum.value()};
  }
  weights.resize(kept);
  return weights;
}

void ArealRainfall::count_gauges(const State& state, std::span<const double> readings,
                                 std::vector<BasinRainfall>& result) const {
  for (const CellWeight& w : weights_of(state))
    result[w.basin].gauges += reporting_in(w.cell, readings);
  for (BasinRainfall& basin : result) {
    if (basin.gauges < settings_.min_gauges) basin.rainfall = no_value;
  }
}

void ArealRainfall::add_coverage(std::span<const double> readings,
                                 std::vector<BasinRainfall>& result) const {
  for (std::size_t b = 0; settings_.accounts && b < full_.size(); ++b)
    result[b].coverage = coverage(full_[b], readings);
}

std::vector<BasinRainfall> ArealRainfall::at(std::span<const double> readings) const {
  std::vector<BasinRainfall> result;
  if (handovers_) {
    result = retessellated(state_of(readings), readings);
  } else {
    for (const BasinWeights& weights : full_)
      result.push_back(
          rainfall_of_full_network(weights, readings, settings_.gaps, settings_.min_gauges));
  }
  add_coverage(readings, result);
  return result;
}

std::vector<BasinRainfall> ArealRainfall::at(std::span<const double> readings,
                                             CellAccount& account) const {
  if (!handovers_) {
    account.readings = cell_readings(readings);
    if (settings_.gaps == Gaps::renormalise) account.change = silent_weights(readings);
    return at(readings);
  }
  State state = state_of(readings);
  std::vector<BasinRainfall> result = retessellated(state, readings);
  add_coverage(readings, result);
  account.change = change_of(state);
  account.readings = std::move(state.of_cell);
  return result;
}

std::vector<CellWeight> ArealRainfall::change_of(const State& state) const {
  std::vector<CellWeight> change;
  for (const CellWeight& full : handovers_->full()) {
    if (std::isnan(state.of_cell[index(full.cell)]))
      change.push_back({full.basin, full.cell, -full.weight});
  }
  for (const auto& handover : state.handovers)
    change.insert(change.end(), handover->begin(), handover->end());
  return change;
}

std::vector<CellWeight> ArealRainfall::silent_weights(std::span<const double> readings) const {
  std::vector<CellWeight> change;
  for (std::uint32_t b = 0; b < full_.size(); ++b) {
    for (const StationWeight& s : full_[b].stations) {
      if (std::isnan(readings[index(s.station)]))
        change.push_back({b, network_.place_of(s.station), -s.weight});
    }
  }
  return change;
}

std::vector<CellWeight> ArealRainfall::full_cells() const {
  if (handovers_) return handovers_->full();
  std::vector<CellWeight> cells;
  for (std::uint32_t b = 0; b < full_.size(); ++b) {
    std::map<PlaceIndex, LongSum> weights;
    for (const StationWeight& s : full_[b].stations)
      weights[network_.place_of(s.station)].add(s.weight);
    for (const auto& [place, weight] : weights) cells.push_back({b, place, weight.value()});
  }
  return cells;
}

std::vector<BasinWeights> ArealRainfall::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> weights(full_.size());
  for (std::size_t b = 0; b < full_.size(); ++b) weights[b].area = full_[b].area;
  const auto reports = [&](StationIndex s) { return !std::isnan(readings[index(s)]); };
  if (settings_.gaps == Gaps::retessellate) {
    for (const CellWeight& w : weights_of(state_of(readings))) {
      const auto in_cell = handovers_->cells().stations_of(w.cell);
      std::vector<StationIndex> stations;
      std::copy_if(in_cell.begin(), in_cell.end(), std::back_inserter(stations), reports);
      add_shares(weights[w.basin], stations, w.weight * weights[w.basin].area);
    }
    for (BasinWeights& basin : weights) sort_by_station(basin.stations);
  } else {
    for (std::size_t b = 0; b < full_.size(); ++b)
      weights[b] = weights_of_full_network(full_[b], readings, settings_.gaps);
  }
  for (BasinWeights& basin : weights) {
    if (basin.stations.size() < settings_.min_gauges) basin.stations.clear();
  }
  return weights;
}

}  // namespace thiessen
