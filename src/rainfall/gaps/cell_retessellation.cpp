#include "rainfall/gaps/cell_retessellation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "geometry/long_sum.h"
#include "rainfall/network/mean_reading.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Puts weights that are ordered by basin in turn: the first of each basin, then the second of
/// each.
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

/// Sorts weights by basin, then by cell, and adds up those of the same basin and cell.
void merge(std::vector<CellWeight>& weights) {
  std::stable_sort(weights.begin(), weights.end(), [](const CellWeight& a, const CellWeight& b) {
    return std::pair(a.basin, a.cell) < std::pair(b.basin, b.cell);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < weights.size();) {
    const CellWeight first = weights[i];
    LongSum sum;
    for (; i < weights.size() && weights[i].basin == first.basin && weights[i].cell == first.cell;
         ++i) {
      sum.add(weights[i].weight);
    }
    weights[kept++] = {first.basin, first.cell, sum.value()};
  }
  weights.resize(kept);
}

}  // namespace

CellRetessellation::CellRetessellation(const Handovers& handovers, std::size_t remembered_bytes,
                                       bool counts_gauges)
    : handovers_(handovers),
      remembered_(handovers, remembered_bytes),
      counts_gauges_(counts_gauges),
      full_(handovers.full_weights()),
      full_in_turn_(in_turn(handovers.full())) {}

std::vector<double> CellRetessellation::cell_readings(std::span<const double> readings) const {
  std::vector<double> of_cell(handovers_.adjacency().cells());
  for (std::uint32_t p = 0; p < of_cell.size(); ++p)
    of_cell[p] = mean_reading(handovers_.cells().stations_of(PlaceIndex{p}), readings);
  return of_cell;
}

CellRetessellation::State CellRetessellation::state_of(std::span<const double> readings) const {
  const NetworkCells& cells = handovers_.cells();
  State state;
  state.of_cell.assign(handovers_.adjacency().cells(), no_value);
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
  for (const auto& component : components_of(silent, handovers_.adjacency()))
    state.handovers.push_back(remembered_.of(component));
  return state;
}

std::vector<BasinRainfall> CellRetessellation::rainfall(const State& state,
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
  if (!counts_gauges_) return result;
  for (const CellWeight& w : weights(state))
    result[w.basin].gauges += count_reporting(handovers_.cells().stations_of(w.cell), readings);
  return result;
}

/// Gives the weights of the cells that report, by basin, then by cell.
std::vector<CellWeight> CellRetessellation::weights(const State& state) const {
  std::vector<CellWeight> weights;
  for (const CellWeight& full : handovers_.full()) {
    if (!std::isnan(state.of_cell[index(full.cell)])) weights.push_back(full);
  }
  for (const auto& handover : state.handovers)
    weights.insert(weights.end(), handover->begin(), handover->end());
  merge(weights);
  return weights;
}

std::vector<CellWeight> CellRetessellation::change(const State& state) const {
  std::vector<CellWeight> change;
  for (const CellWeight& full : handovers_.full()) {
    if (std::isnan(state.of_cell[index(full.cell)]))
      change.push_back({full.basin, full.cell, -full.weight});
  }
  for (const auto& handover : state.handovers)
    change.insert(change.end(), handover->begin(), handover->end());
  return change;
}

std::vector<BasinRainfall> CellRetessellation::at(std::span<const double> readings) const {
  return rainfall(state_of(readings), readings);
}

std::vector<BasinRainfall> CellRetessellation::at(std::span<const double> readings,
                                                  CellAccount& account) const {
  State state = state_of(readings);
  std::vector<BasinRainfall> result = rainfall(state, readings);
  account.change = change(state);
  account.readings = std::move(state.of_cell);
  return result;
}

std::vector<BasinWeights> CellRetessellation::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> result(full_.size());
  for (std::size_t b = 0; b < full_.size(); ++b) result[b].area = full_[b].area;
  const auto reports = [&](StationIndex s) { return !std::isnan(readings[index(s)]); };
  for (const CellWeight& w : weights(state_of(readings))) {
    const auto in_cell = handovers_.cells().stations_of(w.cell);
    std::vector<StationIndex> stations;
    std::copy_if(in_cell.begin(), in_cell.end(), std::back_inserter(stations), reports);
    add_shares(result[w.basin], stations, w.weight * result[w.basin].area);
  }
  for (BasinWeights& basin : result) sort_by_station(basin.stations);
  return result;
}

}  // namespace thiessen
