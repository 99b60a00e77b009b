#include "rainfall/gaps/nearest_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thiessen {
namespace {

/// The share of a piece of ground up to which parts of it are rounding: on the Earth; in a plane
/// where coordinates have all their digits.
constexpr double rounding_on_earth = 1e-12;
constexpr double rounding_in_a_plane = 1e-14;
/// The share of a region's area by which its area in a chart may miss it; as Handovers has it.
constexpr double most_astray = 1e-4;

}  // namespace

/// A cell's ground in a chart of its own, and how near the gauges around are there.
struct NearestSets::ChartedCell {
  ChartedCell(Direction centre, double reach) : chart(centre), nearness(chart, reach) {}

  GnomonicChart chart;
  ChartNearness nearness;
  bool is_known = true;
  std::vector<Basin> grounds;  ///< by region
  std::vector<double> scales;  ///< what an area in the chart is multiplied by
  std::vector<std::pair<PlaceIndex, std::optional<Nearness>>> near;
};

NearestSets::NearestSets(const Handovers& handovers, std::size_t bytes)
    : handovers_(handovers),
      remembered_(bytes / 2),
      slots_(handovers.weighing().yardstick().metric == Metric::geodesic
                 ? handovers.adjacency().cells()
                 : 0),
      bytes_left_(bytes / 2) {
  places_.reserve(slots_.size());
  for (std::size_t i = 0; i < slots_.size(); ++i)
    places_.emplace_back(handovers.cells().diagram().places[i]);
}

NearestSets::~NearestSets() = default;

NearestSets::Bench NearestSets::bench() const {
  return {NearestGround(handovers_.weighing().yardstick().unit_area), {}, {}};
}

std::shared_ptr<const NearestSets::Shares> NearestSets::of(std::span<const PlaceIndex> cells,
                                                           Bench& bench) {
  return remembered_.of(
      cells, [&] { return computed(cells, bench); },
      [](const Shares& shares) { return shares.weights.capacity() * sizeof(CellWeight); });
}

// Lists the set, and after it the cells next to it.
void NearestSets::find_places(std::span<const PlaceIndex> cells, Bench& bench) const {
  bench.places.assign(cells.begin(), cells.end());
  for (const PlaceIndex cell : cells) {
    for (const PlaceIndex q : handovers_.adjacency().neighbours(cell)) {
      if (!std::binary_search(cells.begin(), cells.end(), q)) bench.places.push_back(q);
    }
  }
  const auto others = bench.places.begin() + static_cast<std::ptrdiff_t>(cells.size());
  std::sort(others, bench.places.end());
  bench.places.erase(std::unique(others, bench.places.end()), bench.places.end());
}

NearestSets::Shares NearestSets::computed(std::span<const PlaceIndex> cells, Bench& bench) {
  find_places(cells, bench);
  Shares shares;
  for (std::size_t own = 0; own < cells.size() && shares.is_known; ++own) {
    if (!handovers_.has_ground(cells[own])) continue;
    slots_.empty() ? add_in_plane(cells.size(), own, bench, shares)
                   : add_on_earth(cells.size(), own, bench, shares);
  }
  std::vector<CellWeight>& weights = shares.weights;
  if (!shares.is_known) weights.clear();
  std::stable_sort(weights.begin(), weights.end(), [](const CellWeight& a, const CellWeight& b) {
    return std::pair(a.basin, a.cell) < std::pair(b.basin, b.cell);
  });
  std::size_t last = 0;
  for (std::size_t i = 1; i < weights.size(); ++i) {
    if (weights[i].basin == weights[last].basin && weights[i].cell == weights[last].cell) {
      weights[last].weight += weights[i].weight;
    } else {
      weights[++last] = weights[i];
    }
  }
  if (!weights.empty()) weights.resize(last + 1);
  weights.shrink_to_fit();
  return shares;
}

void NearestSets::add_in_plane(std::size_t members, std::size_t own, Bench& bench,
                               Shares& shares) const {
  const std::vector<Point>& positions = handovers_.cells().diagram().places;
  const Point origin = positions[index(bench.places[own])];
  bench.nearness.clear();
  for (const PlaceIndex place : bench.places)
    bench.nearness.push_back(plane_nearness(positions[index(place)], origin));
  bench.ground.take_places(bench.nearness);
  for (const Handovers::Region& region : handovers_.ground_of(bench.places[own])) {
    bench.ground.take_ground(region.ground, origin);
    add(region, 1, members, own, bench, shares);
  }
}

void NearestSets::add_on_earth(std::size_t members, std::size_t own, Bench& bench, Shares& shares) {
  const PlaceIndex cell = bench.places[own];
  std::unique_ptr<ChartedCell> not_kept;
  const ChartedCell* here = nullptr;
  {
    Slot& slot = slots_[index(cell)];
    const std::lock_guard lock(slot.mutex);
    if (!slot.charted) {
      std::unique_ptr<ChartedCell> fresh = charted(cell);
      std::size_t bytes = sizeof(ChartedCell);
      for (const Basin& ground : fresh->grounds) {
        bytes += sizeof(Basin);
        for (const auto& bulges : ground.bulges)
          bytes += bulges.size() * (sizeof(double) + sizeof(Point)) + sizeof(Polygon);
      }
      (takes(bytes) ? slot.charted : not_kept) = std::move(fresh);
    }
    ChartedCell& charted = slot.charted ? *slot.charted : *not_kept;
    shares.is_known = charted.is_known && find_nearness(charted, bench);
    here = &charted;
  }
  if (!shares.is_known) return;
  bench.ground.take_chart(here->chart);
  bench.ground.take_places(bench.nearness);
  const auto regions = handovers_.ground_of(cell);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    bench.ground.take_ground(here->grounds[i]);
    add(regions[i], here->scales[i], members, own, bench, shares);
  }
}

void NearestSets::add(const Handovers::Region& region, double scale, std::size_t members,
                      std::size_t own, Bench& bench, Shares& shares) const {
  const double least = least_area(region);
  const std::span<const double> areas = bench.ground.areas_by_next(members, own);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double area = scale * areas[i];
    if (area > least)
      shares.weights.push_back({region.basin, bench.places[members + i],
                                area / handovers_.weighing().basin_area(region.basin)});
  }
}

// A region's corners are rounded to the digits of its coordinates, which moves its edges so far.
double NearestSets::least_area(const Handovers::Region& region) const {
  if (region.shape) return rounding_on_earth * region.area;
  double largest = 0;
  for (const Polygon& part : region.ground.shape) {
    for (const Point p : part.outer) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  const double unit_area = handovers_.weighing().yardstick().unit_area;
  const double width = std::sqrt(region.area / unit_area);
  const double of_corners = 4 * std::numeric_limits<double>::epsilon() * largest / width;
  return std::max(rounding_in_a_plane, of_corners) * region.area;
}

std::unique_ptr<NearestSets::ChartedCell> NearestSets::charted(PlaceIndex cell) const {
  const auto regions = handovers_.ground_of(cell);
  Direction sum;
  for (const Handovers::Region& region : regions) sum = sum + region.shape->centre();
  const Direction centre = unit(length(sum) > 0 ? sum : regions.front().shape->centre());
  double reach = 0;
  for (const Handovers::Region& region : regions) {
    const double half = length(region.shape->centre() - centre) / 2;
    reach = std::max(reach, 2 * std::asin(std::min(1.0, half)) + region.shape->reach());
  }
  auto charted = std::make_unique<ChartedCell>(centre, std::min(reach, ChartNearness::widest));
  charted->is_known = reach <= ChartNearness::widest;
  if (!charted->is_known) return charted;
  NearestGround ground;
  ground.take_chart(charted->chart);
  for (const Handovers::Region& region : regions) {
    charted->grounds.push_back(region.shape->in_chart(charted->chart));
    ground.take_ground(charted->grounds.back());
    charted->scales.push_back(region.area / ground.area());
    // A sliver may be smaller than the rounding in a chart.
    charted->is_known = charted->is_known && std::abs(charted->scales.back() - 1) <= most_astray;
  }
  return charted;
}

// Finds how near the places of the bench are in the cell's chart; false where one is too far.
bool NearestSets::find_nearness(ChartedCell& cell, Bench& bench) {
  bench.nearness.clear();
  for (const PlaceIndex place : bench.places) {
    const auto known = std::find_if(cell.near.begin(), cell.near.end(),
                                    [&](const auto& near) { return near.first == place; });
    const bool is_kept = known != cell.near.end();
    const std::optional<Nearness> nearness =
        is_kept ? known->second : cell.nearness.of(places_[index(place)]);
    if (!is_kept && takes(sizeof(cell.near[0]))) cell.near.emplace_back(place, nearness);
    if (!nearness) return false;
    bench.nearness.push_back(*nearness);
  }
  return true;
}

/// Whether there is memory for what is to be kept.
bool NearestSets::takes(std::size_t bytes) {
  std::size_t left = bytes_left_.load(std::memory_order_relaxed);
  do {
    if (left < bytes) return false;
  } while (!bytes_left_.compare_exchange_weak(left, left - bytes));
  return true;
}

}  // namespace thiessen
