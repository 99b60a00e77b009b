#include "rainfall/influence/influence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

// With so few silent cells beside a cell the joint component is looked up: it is small, and each of
// its cells asks for the same one when the others are silent.
constexpr std::size_t few_silent = 2;

// Sets of a cell and silent ones are looked at where at most one in so many of its neighbours is
// silent, so many cells at most beside it and with it, and so many sets at most; for sets are many
// where much is silent.
constexpr std::size_t few_silent_in = 3;
constexpr std::size_t most_silent = 12;
constexpr std::size_t most_sets = 48;

}  // namespace

Influence::Influence(const Handovers& handovers, std::size_t remembered_bytes, unsigned threads)
    : handovers_(handovers),
      remembered_(handovers, remembered_bytes / 4, handovers.normals() == nullptr),
      departures_(handovers, remembered_bytes / 4),
      nearest_(handovers, remembered_bytes / 2),
      threads_(std::max(1u, threads)),
      year_(place_of(handovers.normals(), {})),
      month_(year_),
      full_(handovers.full_weights()),
      readings_(handovers.cells(), handovers.adjacency()),
      cells_(handovers.adjacency().cells()),
      benches_(threads_) {
  for (Bench& bench : benches_) bench.nearest = nearest_.bench();
  for (const NormalMonth& month : months_of(handovers.normals()))
    normals_.push_back(at_gauges(month));
  for (std::size_t i = 0; i < handovers.full().size(); ++i) {
    const CellWeight& full = handovers.full()[i];
    Part& part = part_of(full.cell, full.basin);
    if (handovers.normals() == nullptr) part.weights.front() = full.weight;
    for (std::size_t m = 0; m < normals_.size(); ++m)
      part.weights[m] = handovers.full_normals().at(i, m);
    for (Sums& sums : part.sums) sums.weighs = true;
  }
}

std::vector<double> Influence::at_gauges(const NormalMonth& month) const {
  std::size_t stations = 0;
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    stations += handovers_.cells().stations_of(PlaceIndex{c}).size();
  std::vector<double> normals;
  for (std::uint32_t s = 0; s < stations; ++s)
    normals.push_back(relative_at_gauge(*handovers_.normals(), StationIndex{s}, month));
  return normals;
}

Influence::Part& Influence::part_of(PlaceIndex cell, std::uint32_t basin) {
  std::vector<Part>& parts = cells_[index(cell)].parts;
  const auto at =
      std::lower_bound(parts.begin(), parts.end(), basin,
                       [](const Part& part, std::uint32_t b) { return part.basin < b; });
  if (at != parts.end() && at->basin == basin) return *at;
  const std::size_t stations = handovers_.cells().stations_of(cell).size();
  const std::size_t months = std::max<std::size_t>(1, normals_.size());
  return *parts.insert(at, {basin, std::vector<double>(months), std::vector<Sums>(stations)});
}

void Influence::add(StepRows rows, std::span<const std::size_t> months) {
  if (months.empty()) return add_in_month(rows, year_);
  std::vector<std::vector<std::span<const double>>> by_month(year_);
  for (std::size_t step = 0; step < rows.size(); ++step)
    by_month[months[step]].push_back(rows[step]);
  for (std::size_t month = 0; month < by_month.size(); ++month) {
    if (!by_month[month].empty()) add_in_month(by_month[month], month);
  }
}

void Influence::add_in_month(StepRows rows, std::size_t month) {
  rows_ = rows;
  month_ = month;
  if (!normals_.empty()) readings_.take_normals(normals_[month]);
  readings_.take_up(rows, threads_);
  count_alone();
  in_parallel(cells_.size(), threads_, [&](std::size_t worker, std::size_t cell) {
    take(PlaceIndex{static_cast<std::uint32_t>(cell)}, benches_[worker]);
  });
}

void Influence::count_alone() {
  for (std::size_t step = 0; step < rows_.size(); ++step) {
    const std::span<const double> readings = rows_[step];
    if (readings_.reporting(step) > 0) ++steps_with_values_;
    if (readings_.reporting(step) != 1) continue;
    alone_.resize(std::max(alone_.size(), readings.size()));
    const auto it = std::find_if(readings.begin(), readings.end(),
                                 [](double reading) { return !std::isnan(reading); });
    ++alone_[static_cast<std::size_t>(it - readings.begin())];
  }
}

void Influence::take(PlaceIndex cell, Bench& bench) {
  const std::size_t stations = handovers_.cells().stations_of(cell).size();
  if (stations == 0) return;
  find_gaps(cell, bench);
  if (stations == 1) take_steps_without_gaps(cell, bench);
  const std::span<const double> own = readings_.of(cell);
  for (std::size_t step = 0; step < own.size(); ++step) {
    const bool counts = !std::isnan(own[step]) && readings_.reporting(step) > 1;
    if (counts && (stations > 1 || std::isnan(bench.gaps[step]))) take_step(cell, step, bench);
  }
}

void Influence::find_gaps(PlaceIndex cell, Bench& bench) const {
  const auto add = [&](std::span<const double> readings) {
    for (std::size_t step = 0; step < readings.size(); ++step)
      bench.gaps[step] += 0 * readings[step];
  };
  bench.gaps.assign(readings_.steps(), 0);
  add(readings_.of(cell));
  for (const PlaceIndex q : handovers_.adjacency().neighbours(cell)) add(readings_.of(q));
}

void Influence::take_steps_without_gaps(PlaceIndex cell, Bench& bench) {
  const std::size_t steps = readings_.steps();
  const bool none =
      std::all_of(bench.gaps.begin(), bench.gaps.end(), [](double gap) { return std::isnan(gap); });
  if (none) return;
  const Handover& handover = handover_of(cell);
  const double* const own = readings_.of(cell).data();
  for (std::size_t share = 0; share < handover.size();) {
    const std::uint32_t basin = handover[share].basin;
    bench.change.assign(steps, 0);
    double* const change = bench.change.data();
    for (; share < handover.size() && handover[share].basin == basin; ++share) {
      const double weight = handover.bearing(share, month_);
      const double* const heir = readings_.of(handover[share].cell).data();
      for (std::size_t step = 0; step < steps; ++step)
        change[step] += weight * (heir[step] - own[step]);
    }
    Sums& sums = part_of(cell, basin).sums.front();
    for (std::size_t step = 0; step < steps; ++step) {
      if (!std::isnan(bench.gaps[step])) sums.add(change[step]);
    }
  }
}

const Handover& Influence::handover_of(PlaceIndex cell) {
  std::shared_ptr<const Handover>& handover = cells_[index(cell)].handover;
  if (!handover) handover = remembered_.of({&cell, 1});
  return *handover;
}

// This handles any step, whatever else is silent and however many stations report in the cell.
void Influence::take_step(PlaceIndex cell, std::size_t step, Bench& bench) {
  const auto stations = handovers_.cells().stations_of(cell);
  bench.here.clear();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!std::isnan(rows_[step][index(stations[i])])) bench.here.push_back(i);
  }
  const bool is_by_sets = find_moments_by_sets(cell, step, bench);
  if (!is_by_sets) {
    find_components(cell, step, bench);
    find_moments(cell, bench);
  }
  if (bench.moments.empty()) return;
  if (bench.here.size() > 1) {
    for (const Moment& moment : bench.moments) share(cell, step, moment, bench.here);
  } else {
    if (!is_by_sets) find_changes(cell, step, bench);
    for (const Moment& moment : bench.moments)
      part_of(cell, moment.basin).sums[bench.here.front()].add(moment.change);
  }
}

// Finds the cell's weights at the step, and what changes if it falls silent, by sets of the cell
// and silent ones: see NearestSets. False where they would be many, or are not known.
bool Influence::find_moments_by_sets(PlaceIndex cell, std::size_t step, Bench& bench) {
  bench.moments.clear();
  if (handovers_.normals() != nullptr || !begin_sets(cell, step, bench)) return false;
  const double own = readings_.of(cell)[step];
  for (std::size_t set = 0; set < bench.set_count; ++set) {
    const auto shares = nearest_.of(bench.sets[set], bench.nearest);
    if (!shares->is_known) return false;
    const bool has_cell = std::binary_search(bench.sets[set].begin(), bench.sets[set].end(), cell);
    for (const CellWeight& share : shares->weights) {
      const double reading = readings_.of(share.cell)[step];
      if (share.cell == cell || std::isnan(reading)) {
        if (!add_set(set, share.cell, bench)) return false;
      } else if (has_cell) {
        add_change({share.basin, share.weight, share.weight * (reading - own)}, bench.moments);
      }
    }
  }
  return true;
}

void Influence::add_change(const Moment& change, std::vector<Moment>& moments) {
  const auto at = std::lower_bound(
      moments.begin(), moments.end(), change.basin,
      [](const Moment& moment, std::uint32_t basin) { return moment.basin < basin; });
  if (at != moments.end() && at->basin == change.basin) {
    at->weight += change.weight;
    at->change += change.change;
  } else {
    moments.insert(at, change);
  }
}

// Begins with the cell and each silent one of the components beside it: ground in a silent cell may
// come to it by way of sets without it, where those with it have no ground in a basin. False where
// too many are silent, or none.
bool Influence::begin_sets(PlaceIndex cell, std::size_t step, Bench& bench) const {
  const auto neighbours = handovers_.adjacency().neighbours(cell);
  std::size_t silent = 0;
  bench.set_count = 0;
  bench.beside.clear();
  begin_set(cell, bench);
  for (const PlaceIndex q : neighbours) {
    if (!std::isnan(readings_.of(q)[step])) continue;
    if (few_silent_in * ++silent > neighbours.size()) return false;
    const std::vector<PlaceIndex>* component = &readings_.component_of(q, step);
    if (std::find(bench.beside.begin(), bench.beside.end(), component) != bench.beside.end())
      continue;
    bench.beside.push_back(component);
    if (bench.set_count + component->size() > most_silent) return false;
    for (const PlaceIndex s : *component) begin_set(s, bench);
  }
  return silent > 0;
}

void Influence::begin_set(PlaceIndex cell, Bench& bench) {
  if (bench.set_count == bench.sets.size()) bench.sets.emplace_back();
  bench.sets[bench.set_count++].assign(1, cell);
}

// Adds a set of the bench with one more cell, if it is not there yet; false where there are too
// many.
bool Influence::add_set(std::size_t grown, PlaceIndex by, Bench& bench) {
  if (bench.set_count == bench.sets.size()) bench.sets.emplace_back();
  std::vector<PlaceIndex>& fresh = bench.sets[bench.set_count];
  fresh = bench.sets[grown];
  fresh.insert(std::lower_bound(fresh.begin(), fresh.end(), by), by);
  const auto end = bench.sets.begin() + static_cast<std::ptrdiff_t>(bench.set_count);
  if (std::find(bench.sets.begin(), end, fresh) != end) return true;
  if (bench.set_count == most_sets) return false;
  ++bench.set_count;
  return true;
}

// Finds the silent components beside the cell, and what they hand over.
void Influence::find_components(PlaceIndex cell, std::size_t step, Bench& bench) {
  bench.beside.clear();
  bench.handed_over.clear();
  bench.reporting.clear();
  for (const PlaceIndex q : handovers_.adjacency().neighbours(cell)) {
    if (!std::isnan(readings_.of(q)[step])) {
      bench.reporting.push_back(q);
      continue;
    }
    const std::vector<PlaceIndex>* component = &readings_.component_of(q, step);
    if (std::find(bench.beside.begin(), bench.beside.end(), component) != bench.beside.end())
      continue;
    bench.beside.push_back(component);
    bench.handed_over.push_back(remembered_.of(*component));
  }
}

// Finds the cell's weights at the step: its own, and those that are handed to it.
void Influence::find_moments(PlaceIndex cell, Bench& bench) const {
  bench.moments.clear();
  for (const Part& part : cells_[index(cell)].parts) {
    const double weight = part.weights[month_];
    if (weight > 0) bench.moments.push_back({part.basin, weight, 0});
  }
  for (const auto& handover : bench.handed_over) {
    for (std::size_t i = 0; i < handover->size(); ++i) {
      const CellWeight& share = (*handover)[i];
      if (share.cell != cell) continue;
      const double weight = handover->bearing(i, month_);
      const auto at = std::lower_bound(
          bench.moments.begin(), bench.moments.end(), share.basin,
          [](const Moment& moment, std::uint32_t basin) { return moment.basin < basin; });
      if (at != bench.moments.end() && at->basin == share.basin) {
        at->weight += weight;
      } else {
        bench.moments.insert(at, {share.basin, weight, 0});
      }
    }
  }
}

std::size_t Influence::silent_beside(const Bench& bench) {
  std::size_t silent = 0;
  for (const std::vector<PlaceIndex>* component : bench.beside) silent += component->size();
  return silent;
}

void Influence::find_changes(PlaceIndex cell, std::size_t step, Bench& bench) {
  if (bench.beside.empty()) {
    add_changes(handover_of(cell), 1, cell, step, bench.moments);
  } else if (handovers_.normals() != nullptr || silent_beside(bench) <= few_silent) {
    find_changes_of_joint(cell, step, bench);
  } else {
    find_changes_beside_silent(cell, step, bench);
  }
}

void Influence::add_changes(const Handover& handover, double sign, PlaceIndex cell,
                            std::size_t step, std::vector<Moment>& moments) const {
  const double own = readings_.of(cell)[step];
  auto moment = moments.begin();
  for (std::size_t i = 0; i < handover.size(); ++i) {
    const CellWeight& share = handover[i];
    while (moment != moments.end() && moment->basin < share.basin) ++moment;
    if (moment == moments.end()) return;
    if (moment->basin == share.basin)
      moment->change += sign * handover.bearing(i, month_) * (readings_.of(share.cell)[step] - own);
  }
}

void Influence::find_changes_beside_silent(PlaceIndex cell, std::size_t step, Bench& bench) {
  const double own = readings_.of(cell)[step];
  departures_.of(cell, {bench.handed_over, bench.reporting}, bench.departure,
                 [&](std::uint32_t basin, PlaceIndex heir, double weight) {
                   const auto moment =
                       std::find_if(bench.moments.begin(), bench.moments.end(),
                                    [&](const Moment& m) { return m.basin == basin; });
                   if (moment != bench.moments.end())
                     moment->change += weight * (readings_.of(heir)[step] - own);
                 });
}

void Influence::find_changes_of_joint(PlaceIndex cell, std::size_t step, Bench& bench) {
  bench.component.assign(1, cell);
  for (std::size_t i = 0; i < bench.beside.size(); ++i) {
    bench.component.insert(bench.component.end(), bench.beside[i]->begin(), bench.beside[i]->end());
    add_changes(*bench.handed_over[i], -1, cell, step, bench.moments);
  }
  std::sort(bench.component.begin(), bench.component.end());
  add_changes(*remembered_.of(bench.component), 1, cell, step, bench.moments);
}

// When one of several reporting stations is left out, the cell's mean becomes that of the others.
void Influence::share(PlaceIndex cell, std::size_t step, const Moment& moment,
                      const std::vector<std::size_t>& here) {
  const auto stations = handovers_.cells().stations_of(cell);
  const auto reading = [&](std::size_t i) {
    return readings_.relative(stations[i], rows_[step][index(stations[i])]);
  };
  const auto count = static_cast<double>(here.size());
  for (const std::size_t i : here) {
    double shift = 0;
    for (const std::size_t other : here) shift += reading(other) - reading(i);
    part_of(cell, moment.basin).sums[i].add(moment.weight * shift / (count * (count - 1)));
  }
}

std::vector<std::vector<GaugeInfluence>> Influence::result() const {
  std::vector<std::vector<GaugeInfluence>> result(full_.size());
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    const auto stations = handovers_.cells().stations_of(PlaceIndex{c});
    for (const Part& part : cells_[c].parts) {
      for (std::size_t i = 0; i < stations.size(); ++i) {
        const Sums& sums = part.sums[i];
        if (!sums.weighs) continue;
        const std::size_t station = index(stations[i]);
        const std::size_t without = station < alone_.size() ? alone_[station] : 0;
        const auto steps = static_cast<long double>(steps_with_values_ - without);
        result[part.basin].push_back({stations[i], 0,
                                      static_cast<double>(std::sqrt(sums.squares / steps)),
                                      static_cast<double>(sums.changes / steps)});
      }
    }
  }
  for (std::size_t b = 0; b < result.size(); ++b) {
    sort_by_station(result[b]);
    auto gauge = result[b].begin();
    for (const StationWeight& full : full_[b].stations) {
      while (gauge->station < full.station) ++gauge;
      gauge->weight = full.weight;
    }
  }
  return result;
}

}  // namespace thiessen
