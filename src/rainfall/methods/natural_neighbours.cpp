#include "rainfall/methods/natural_neighbours.h"

#include <algorithm>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/natural_step.h"
#include "rainfall/methods/point_blocks.h"
#include "rainfall/normals/point_normals.h"

namespace thiessen {
namespace {

std::vector<PlaceIndex> all_places(std::size_t count) {
  std::vector<PlaceIndex> places;
  for (std::uint32_t p = 0; p < count; ++p) places.push_back(PlaceIndex{p});
  return places;
}

bool all_report(const std::vector<PlaceIndex>& places, const ReportingPlaces& reports) {
  return std::all_of(places.begin(), places.end(), [&](PlaceIndex p) { return reports[p]; });
}

std::vector<ChartPoint> charted(const std::vector<Point>& positions, const GaugeChart& chart) {
  std::vector<ChartPoint> points;
  points.reserve(positions.size());
  for (const Point p : positions) points.push_back(chart.at(p));
  return points;
}

}  // namespace

NaturalNeighbours::Gauges::Gauges(const std::vector<Point>& positions,
                                  const std::vector<PlaceIndex>& places, Metric metric)
    : chart(positions, metric), natural(charted(positions, chart), chart.kind()) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t number = index(natural.numbers()[i]);
    if (number >= places_of.size()) places_of.resize(number + 1);
    places_of[number].push_back(places[i]);
  }
}

NaturalNeighbours::NaturalNeighbours(const Weighing& weighing, std::size_t points, unsigned threads,
                                     std::size_t remembered_bytes)
    : weighing_(weighing),
      nearest_(weighing.network().places(), weighing.yardstick().metric),
      full_(weighing.network().places(), all_places(weighing.network().places().size()),
            weighing.yardstick().metric),
      points_(weighing.basins().size()),
      shares_outside_(points_.size()),
      remembered_(remembered_bytes / 2) {
  in_parallel(points_.size(), threads, [&](std::size_t, std::size_t b) {
    points_[b].positions = basin_points(weighing.basins()[b], weighing.yardstick(), points);
    points_[b].at = charted(points_[b].positions, full_.chart);
    points_[b].normals = point_normals(weighing.normals(), b, points_[b].positions);
    auto workplace = borrow();
    shares_outside_[b] =
        static_cast<double>(keep_neighbours(points_[b], *workplace)) / static_cast<double>(points);
    give_back(std::move(workplace));
  });
  std::size_t sums = 0;
  for (const Points& of_basin : points_) {
    first_sum_.push_back(sums);
    sums += of_basin.blocks.sums.size() * of_basin.blocks.sums.front().size();
  }
  singles_ = std::make_unique<Kept<Sums>>(sums, remembered_bytes / 2);
}

NaturalNeighbours::~NaturalNeighbours() = default;

// Returns how many points are outside the hull.
std::size_t NaturalNeighbours::keep_neighbours(Points& points, Workplace& workplace) const {
  const ReportingPlaces reports(weighing_.network().places().size(), true);
  Found found;
  std::vector<Neighbour> weights;
  std::size_t outside = 0;
  workplace.begin_anew();
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    if (!workplace.find(points.at[i], points.positions[i], reports, weights)) ++outside;
    found.neighbours.insert(found.neighbours.end(), weights.begin(), weights.end());
    found.first.push_back(static_cast<std::uint32_t>(found.neighbours.size()));
  }
  for (const Neighbour& w : found.neighbours) points.all.push_back(w.place);
  std::sort(points.all.begin(), points.all.end());
  points.all.erase(std::unique(points.all.begin(), points.all.end()), points.all.end());
  points.all.shrink_to_fit();
  weigh_all(points, found, workplace.sums);
  put_in_blocks(points, found, workplace.sums);
  return outside;
}

// Adds what the neighbours of a point weigh there.
void NaturalNeighbours::add(const Points& points, std::size_t month, std::size_t point,
                            std::span<const Neighbour> neighbours, WeightSums& sums) {
  if (points.normals.empty()) {
    for (const Neighbour& w : neighbours) sums.add(w.place, w.weight);
  } else {
    for (const Neighbour& w : neighbours) sums.add(w.place, w.weight, points.normals[month][point]);
  }
}

// The full network's weights are summed point by point, along the rows of the basin.
void NaturalNeighbours::weigh_all(Points& points, const Found& found, WeightSums& sums) {
  for (std::size_t m = 0; m < std::max<std::size_t>(1, points.normals.size()); ++m) {
    for (std::size_t i = 0; i < points.at.size(); ++i) add(points, m, i, found.of(i), sums);
    points.full.push_back(sums.take());
  }
}

void NaturalNeighbours::put_in_blocks(Points& points, const Found& found, WeightSums& sums) {
  std::vector<std::vector<PlaceIndex>> sets(points.at.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (const Neighbour& w : found.of(i)) sets[i].push_back(w.place);
    std::sort(sets[i].begin(), sets[i].end());
  }
  const std::vector<std::uint32_t> order = order_of(sets);
  points.positions = in_order(points.positions, order);
  points.at = in_order(points.at, order);
  for (std::vector<double>& normals : points.normals) normals = in_order(normals, order);
  points.blocks = point_blocks(
      sets, order, std::max<std::size_t>(1, points.normals.size()), sums,
      [&](std::size_t m, std::uint32_t i) { add(points, m, i, found.of(order[i]), sums); });
}

AreaMethod::Weights NaturalNeighbours::weights(const ReportingPlaces& reports,
                                               const NormalMonth& month) const {
  const std::size_t m = place_of(weighing_.normals(), month);
  Weights weights(points_.size());
  if (!reports.any()) return weights;
  std::vector<std::uint32_t> changed;
  for (std::uint32_t b = 0; b < points_.size(); ++b) {
    if (all_report(points_[b].all, reports)) {
      weights[b] = points_[b].full[m];
    } else {
      changed.push_back(b);
    }
  }
  if (changed.empty()) return weights;
  auto workplace = borrow();
  AtStep step(*this, reports, m, *workplace);
  for (const std::uint32_t b : changed) step.take_up(b);
  step.find_all();
  for (const std::uint32_t b : changed) weights[b] = step.weights_of(b);
  give_back(std::move(workplace));
  return weights;
}

std::unique_ptr<NaturalNeighbours::Workplace> NaturalNeighbours::borrow() const {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto workplace = std::move(idle_.back());
      idle_.pop_back();
      return workplace;
    }
  }
  return std::make_unique<Workplace>(*this);
}

void NaturalNeighbours::give_back(std::unique_ptr<Workplace> workplace) const {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(workplace));
}

}  // namespace thiessen
