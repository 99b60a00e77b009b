#include "rainfall/gaps/cell_retessellation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/long_sum.h"
#include "rainfall/network/mean_reading.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The full network's weights as relative readings count: weight x normal.
std::vector<CellWeight> bearing(const Handovers& handovers, std::size_t figure) {
  std::vector<CellWeight> weights = handovers.full();
  if (handovers.normals() == nullptr) return weights;
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i].weight = handovers.full_normals().at(i, figure);
  return weights;
}

}  // namespace

CellRetessellation::CellRetessellation(const Handovers& handovers, HandoverCache& remembered,
                                       const NormalMonth& month, bool counts_gauges)
    : handovers_(handovers),
      remembered_(remembered),
      month_(month),
      figure_(place_of(handovers.normals(), month)),
      counts_gauges_(counts_gauges),
      full_(handovers.full_weights(month)) {
  keep_parts();
  keep_turns(bearing(handovers, figure_));
  if (handovers.normals() == nullptr) return;
  std::size_t stations = 0;
  for (std::uint32_t p = 0; p < handovers.adjacency().cells(); ++p)
    stations += handovers.cells().stations_of(PlaceIndex{p}).size();
  for (std::uint32_t s = 0; s < stations; ++s)
    at_gauges_.push_back(relative_at_gauge(*handovers.normals(), StationIndex{s}, month));
}

void CellRetessellation::keep_parts() {
  const std::vector<CellWeight>& parts = handovers_.full();
  full_gauges_.assign(full_.size(), 0);
  first_basin_.assign(handovers_.adjacency().cells() + 1, 0);
  for (const CellWeight& part : parts) {
    full_gauges_[part.basin] += handovers_.cells().stations_of(part.cell).size();
    ++first_basin_[index(part.cell) + 1];
  }
  std::partial_sum(first_basin_.begin(), first_basin_.end(), first_basin_.begin());
  std::vector<std::size_t> next(first_basin_.begin(), first_basin_.end() - 1);
  basins_.resize(parts.size());
  for (const CellWeight& part : parts) basins_[next[index(part.cell)]++] = part.basin;
  for (std::uint32_t c = 0; c < next.size(); ++c) {
    const auto stations = handovers_.cells().stations_of(PlaceIndex{c});
    if (stations.size() > 1) shared_cells_.push_back(PlaceIndex{c});
    if (stations.size() != 1) continue;
    single_cells_.push_back(PlaceIndex{c});
    single_stations_.push_back(stations.front());
  }
}

/// Requires weights by basin.
void CellRetessellation::keep_turns(const std::vector<CellWeight>& weights) {
  std::vector<std::size_t> first(full_.size() + 1, 0);
  for (const CellWeight& weight : weights) ++first[weight.basin + 1];
  const std::vector<std::size_t> counts(first.begin() + 1, first.end());
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> basins(full_.size());
  std::iota(basins.begin(), basins.end(), 0U);
  std::stable_sort(basins.begin(), basins.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return counts[a] > counts[b]; });
  sum_of_.resize(basins.size());
  for (std::uint32_t i = 0; i < basins.size(); ++i) sum_of_[basins[i]] = i;
  const std::size_t turns = basins.empty() ? 0 : counts[basins.front()];
  for (std::size_t turn = 0; turn < turns; ++turn) {
    first_in_turn_.push_back(static_cast<std::uint32_t>(weights_in_turn_.size()));
    for (const std::uint32_t basin : basins) {
      if (counts[basin] <= turn) break;
      weights_in_turn_.push_back(weights[first[basin] + turn].weight);
      cells_in_turn_.push_back(weights[first[basin] + turn].cell);
    }
  }
  first_in_turn_.push_back(static_cast<std::uint32_t>(weights_in_turn_.size()));
}

std::vector<double> CellRetessellation::cell_readings(std::span<const double> readings) const {
  std::vector<double> of_cell(handovers_.adjacency().cells());
  for (std::uint32_t p = 0; p < of_cell.size(); ++p)
    of_cell[p] = mean_reading(handovers_.cells().stations_of(PlaceIndex{p}), readings);
  return of_cell;
}

// Without normals, and where all are the same, it is the mean reading bit for bit.
double CellRetessellation::reading_of(std::span<const StationIndex> stations,
                                      std::span<const double> readings) const {
  if (at_gauges_.empty()) return mean_reading(stations, readings);
  if (stations.size() == 1)
    return readings[index(stations.front())] / at_gauges_[index(stations.front())];
  std::vector<double> relative(readings.begin(), readings.end());
  for (const StationIndex s : stations) relative[index(s)] /= at_gauges_[index(s)];
  return mean_reading(stations, relative);
}

void CellRetessellation::read_cells(std::span<const double> readings,
                                    std::vector<double>& of_cell) const {
  for (std::size_t i = 0; i < single_cells_.size(); ++i) {
    const std::size_t station = index(single_stations_[i]);
    of_cell[index(single_cells_[i])] =
        at_gauges_.empty() ? readings[station] : readings[station] / at_gauges_[station];
  }
  for (const PlaceIndex cell : shared_cells_)
    of_cell[index(cell)] = reading_of(handovers_.cells().stations_of(cell), readings);
}

CellRetessellation::State CellRetessellation::state_of(std::span<const double> readings) const {
  State state;
  state.of_cell.assign(handovers_.adjacency().cells(), no_value);
  read_cells(readings, state.of_cell);
  std::vector<PlaceIndex> silent;
  for (std::uint32_t p = 0; p < state.of_cell.size(); ++p) {
    if (!std::isnan(state.of_cell[p])) {
      state.any = true;
    } else if (!handovers_.cells().stations_of(PlaceIndex{p}).empty()) {
      silent.push_back(PlaceIndex{p});
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
  // Ground without normals takes the mean of the rest of what its gauge has at this very step.
  const bool is_linear = handovers_.full_normals().covered.empty() || state.handovers.empty();
  if (is_linear) {
    add_linearly(state, sums);
  } else {
    add_in_parts(state, parts(state), sums);
  }
  std::vector<BasinRainfall> result;
  result.reserve(sum_of_.size());
  for (const std::uint32_t sum : sum_of_)
    result.push_back({state.any ? sums[sum].value() : no_value, 0, 0});
  if (counts_gauges_) count_gauges(state, readings, result);
  return result;
}

// A cell counts once in a basin, be it for its own ground, for what it takes over, or for both.
void CellRetessellation::count_gauges(const State& state, std::span<const double> readings,
                                      std::vector<BasinRainfall>& result) const {
  for (std::size_t b = 0; b < result.size(); ++b) result[b].gauges = full_gauges_[b];
  const auto take_out = [&](PlaceIndex cell, std::size_t silent) {
    for (const std::uint32_t basin : basins_of(cell)) result[basin].gauges -= silent;
  };
  for (std::uint32_t c = 0; c < state.of_cell.size(); ++c) {
    if (std::isnan(state.of_cell[c]))
      take_out(PlaceIndex{c}, handovers_.cells().stations_of(PlaceIndex{c}).size());
  }
  for (const PlaceIndex cell : shared_cells_) {
    const auto stations = handovers_.cells().stations_of(cell);
    if (!std::isnan(state.of_cell[index(cell)]))
      take_out(cell, stations.size() - count_reporting(stations, readings));
  }
  std::vector<std::pair<std::uint32_t, PlaceIndex>> taken_over;
  for (const auto& handover : state.handovers) {
    for (const CellWeight& share : *handover) {
      const auto basins = basins_of(share.cell);
      if (!std::binary_search(basins.begin(), basins.end(), share.basin))
        taken_over.emplace_back(share.basin, share.cell);
    }
  }
  std::sort(taken_over.begin(), taken_over.end());
  taken_over.erase(std::unique(taken_over.begin(), taken_over.end()), taken_over.end());
  for (const auto& [basin, cell] : taken_over)
    result[basin].gauges += count_reporting(handovers_.cells().stations_of(cell), readings);
}

void CellRetessellation::add_linearly(const State& state, std::vector<LongSum>& sums) const {
  // To add 0 changes nothing.
  std::vector<double> terms(weights_in_turn_.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double reading = state.of_cell[index(cells_in_turn_[i])];
    terms[i] = std::isnan(reading) ? 0 : weights_in_turn_[i] * reading;
  }
  for (std::size_t turn = 0; turn + 1 < first_in_turn_.size(); ++turn) {
    const std::size_t first = first_in_turn_[turn];
    const std::size_t count = first_in_turn_[turn + 1] - first;
    for (std::size_t i = 0; i < count; ++i) sums[i].add(terms[first + i]);
  }
  for (const auto& handover : state.handovers) {
    if (handover->weighted.months == 0) {
      for (const CellWeight& share : *handover)
        sums[sum_of_[share.basin]].add(share.weight * state.of_cell[index(share.cell)]);
      continue;
    }
    for (std::size_t i = 0; i < handover->size(); ++i) {
      const CellWeight& share = (*handover)[i];
      sums[sum_of_[share.basin]].add(handover->weighted.at(i, figure_) *
                                     state.of_cell[index(share.cell)]);
    }
  }
}

double CellRetessellation::normal_of(const CellPart& part) const {
  if (part.covered > 0) return part.normals / part.covered;
  const NormalField& normals = *handovers_.normals();
  return basin_normal(normals, part.part.basin, month_) / reference_normal(normals, month_);
}

void CellRetessellation::add_in_parts(const State& state, const std::vector<CellPart>& parts,
                                      std::vector<LongSum>& sums) const {
  for (const CellPart& p : parts)
    sums[sum_of_[p.part.basin]].add(p.part.weight * normal_of(p) *
                                    state.of_cell[index(p.part.cell)]);
}

CellRetessellation::CellPart CellRetessellation::part_of(const CellWeight& weight,
                                                         const WeightedNormals& weighted,
                                                         std::size_t number) const {
  if (weighted.months == 0) return {weight, weight.weight, weight.weight};
  const double covered = weighted.covered_at(number, figure_);
  return {weight, weight.weight * covered, weighted.at(number, figure_) * covered};
}

/// Gives the parts of the cells that report, by basin, then by cell.
std::vector<CellRetessellation::CellPart> CellRetessellation::parts(const State& state) const {
  std::vector<CellPart> all;
  for (std::size_t i = 0; i < handovers_.full().size(); ++i) {
    const CellWeight& full = handovers_.full()[i];
    if (!std::isnan(state.of_cell[index(full.cell)]))
      all.push_back(part_of(full, handovers_.full_normals(), i));
  }
  for (const auto& handover : state.handovers) {
    for (std::size_t i = 0; i < handover->size(); ++i)
      all.push_back(part_of((*handover)[i], handover->weighted, i));
  }
  std::stable_sort(all.begin(), all.end(), [](const CellPart& a, const CellPart& b) {
    return std::pair(a.part.basin, a.part.cell) < std::pair(b.part.basin, b.part.cell);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size();) {
    const CellWeight first = all[i].part;
    LongSum weight;
    LongSum covered;
    LongSum normals;
    for (; i < all.size() && all[i].part.basin == first.basin && all[i].part.cell == first.cell;
         ++i) {
      weight.add(all[i].part.weight);
      covered.add(all[i].covered);
      normals.add(all[i].normals);
    }
    all[kept++] = {{first.basin, first.cell, weight.value()}, covered.value(), normals.value()};
  }
  all.resize(kept);
  return all;
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
  const State state = state_of(readings);
  std::vector<BasinRainfall> result = rainfall(state, readings);
  account.change = change(state);
  account.readings = cell_readings(readings);
  return result;
}

std::vector<BasinWeights> CellRetessellation::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> result(full_.size());
  for (std::size_t b = 0; b < full_.size(); ++b) result[b].area = full_[b].area;
  const auto reports = [&](StationIndex s) { return !std::isnan(readings[index(s)]); };
  for (const CellPart& p : parts(state_of(readings))) {
    const CellWeight& w = p.part;
    const auto in_cell = handovers_.cells().stations_of(w.cell);
    std::vector<StationIndex> stations;
    std::copy_if(in_cell.begin(), in_cell.end(), std::back_inserter(stations), reports);
    add_shares(result[w.basin], stations, w.weight * result[w.basin].area);
    if (handovers_.normals() == nullptr) continue;
    const double normal = normal_of(p) * reference_normal(*handovers_.normals(), month_);
    set_factors(result[w.basin], stations, normal, *handovers_.normals(), month_);
  }
  for (BasinWeights& basin : result) sort_by_station(basin.stations);
  return result;
}

}  // namespace thiessen
