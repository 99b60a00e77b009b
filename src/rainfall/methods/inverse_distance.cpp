#include "rainfall/methods/inverse_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/point_blocks.h"
#include "rainfall/normals/point_normals.h"

namespace thiessen {
namespace {

constexpr float at_the_point = std::numeric_limits<float>::infinity();

/// Takes the first 12 neighbours of a point that report, and adds their weights, scaled to add up
/// to 1.
template <typename Neighbour>
class Shares {
 public:
  bool is_full() const { return count_ == nearest_.size(); }
  void add(const Neighbour& neighbour) {
    nearest_[count_++] = neighbour;
    total_ += static_cast<double>(neighbour.weight);
  }
  /// Calls add(place, weight) for each of them.
  template <typename Add>
  void add_to(const Add& add) const {
    if (total_ == static_cast<double>(at_the_point)) {
      for (std::size_t i = 0; i < count_; ++i) {
        if (nearest_[i].weight == at_the_point) return add(nearest_[i].place, 1);
      }
    }
    const double scale = 1 / total_;
    for (std::size_t i = 0; i < count_; ++i)
      add(nearest_[i].place, scale * static_cast<double>(nearest_[i].weight));
  }

 private:
  std::array<Neighbour, InverseDistance::neighbours> nearest_;
  std::size_t count_ = 0;
  double total_ = 0;
};

}  // namespace

InverseDistance::InverseDistance(const Weighing& weighing, std::size_t points, unsigned threads)
    : weighing_(weighing),
      nearest_(weighing.network().places(), weighing.yardstick().metric),
      kept_(std::min(kept, weighing.network().places().size())),
      points_(weighing.basins().size()) {
  const std::vector<Point>& places = weighing.network().places();
  if (weighing.yardstick().metric == Metric::geodesic) {
    for (const Point p : places) on_earth_.emplace_back(p);
  }
  in_parallel(points_.size(), threads, [&](std::size_t, std::size_t b) {
    points_[b].at = basin_points(weighing.basins()[b], weighing.yardstick(), points);
    keep_neighbours(points_[b]);
    points_[b].normals = point_normals(weighing.normals(), b, points_[b].at);
    Bench bench(places.size());
    const ReportingPlaces all(places.size(), true);
    for (std::size_t m = 0; m < std::max<std::size_t>(1, points_[b].normals.size()); ++m) {
      for (std::size_t i = 0; i < points_[b].at.size(); ++i) add(points_[b], m, i, all, bench);
      points_[b].full.push_back(bench.sums.take());
    }
    put_in_blocks(points_[b], all, bench);
  });
}

// The full network's weights, above, are summed along the rows of the basin.
void InverseDistance::put_in_blocks(Points& points, const ReportingPlaces& all,
                                    Bench& bench) const {
  std::vector<std::array<PlaceIndex, neighbours>> sets(points.at.size());
  const std::size_t count = std::min(neighbours, kept_);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    sets[i].fill(PlaceIndex{});
    for (std::size_t k = 0; k < count; ++k) sets[i][k] = kept_at(points, i)[k].place;
    std::sort(sets[i].begin(), sets[i].begin() + static_cast<std::ptrdiff_t>(count));
  }
  const std::vector<std::uint32_t> order = order_of(sets);
  std::vector<Neighbour> near;
  near.reserve(points.near.size());
  for (const std::uint32_t i : order) {
    const auto nearest = kept_at(points, i);
    near.insert(near.end(), nearest.begin(), nearest.end());
  }
  points.near = std::move(near);
  points.at = in_order(points.at, order);
  for (std::vector<double>& normals : points.normals) normals = in_order(normals, order);
  points.blocks =
      point_blocks(sets, order, std::max<std::size_t>(1, points.normals.size()), bench.sums,
                   [&](std::size_t m, std::uint32_t i) { add(points, m, i, all, bench); });
}

void InverseDistance::keep_neighbours(Points& points) const {
  points.near.resize(points.at.size() * kept_);
  std::vector<NearestGauges::Near> near;
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    nearest_.find(points.at[i], kept_, {}, near);
    weigh(points.at[i], near, std::span(points.near).subspan(i * kept_, kept_));
  }
}

// Weights are relative to the nearest gauge's distance, so that no unit of length makes them too
// large or too small for a float.
void InverseDistance::weigh(Point at, std::span<const NearestGauges::Near> near,
                            std::span<Neighbour> weighed) const {
  constexpr double accuracy = 1;  // metres, of geodesics longer than 1,000 km
  const bool planar = weighing_.yardstick().metric == Metric::planar;
  const EarthPoint here = planar ? EarthPoint(Point{}, Direction{}) : EarthPoint(at);
  double least = 0;
  for (std::size_t k = 0; k < near.size(); ++k) {
    double square = near[k].square;
    if (!planar && square > 0) {
      const double distance = arrival(on_earth_[index(near[k].place)], here, accuracy).distance;
      square = distance * distance;
    }
    if (least == 0) least = square;
    weighed[k] = {near[k].place, square == 0 ? at_the_point : static_cast<float>(least / square)};
  }
}

// Adds what gauges weigh at a point.
void InverseDistance::add(const Points& points, std::size_t month, std::size_t point,
                          const ReportingPlaces& reports, Bench& bench) const {
  Shares<Neighbour> shares;
  for (const Neighbour& neighbour : kept_at(points, point)) {
    if (!reports[neighbour.place]) continue;
    shares.add(neighbour);
    if (shares.is_full()) break;
  }
  if (!shares.is_full() && kept_ < reports.size()) {
    std::array<Neighbour, neighbours> others{};
    nearest_.find(points.at[point], neighbours, reports, bench.near);
    weigh(points.at[point], bench.near, others);
    shares = {};
    for (std::size_t k = 0; k < bench.near.size(); ++k) shares.add(others[k]);
  }
  if (points.normals.empty()) {
    shares.add_to([&](PlaceIndex place, double weight) { bench.sums.add(place, weight); });
  } else {
    const double normal = points.normals[month][point];
    shares.add_to([&](PlaceIndex place, double weight) { bench.sums.add(place, weight, normal); });
  }
}

std::vector<PlaceWeight> InverseDistance::weights_of(const Points& points, std::size_t month,
                                                     const ReportingPlaces& reports,
                                                     Bench& bench) const {
  for (const PointBlock& block : points.blocks.all) {
    const auto sums = points.blocks.sums_of(block, month);
    const bool is_full =
        std::all_of(sums.begin(), sums.end(), [&](const PlaceSum& s) { return reports[s.place]; });
    if (is_full) {
      bench.sums.add(sums);
    } else {
      for (std::uint32_t i = block.first_point; i < block.end_point; ++i)
        add(points, month, i, reports, bench);
    }
  }
  return bench.sums.take();
}

AreaMethod::Weights InverseDistance::weights(const ReportingPlaces& reports,
                                             const NormalMonth& month) const {
  Weights weights(points_.size());
  if (!reports.any()) return weights;
  Bench bench(reports.size());
  const std::size_t m = place_of(weighing_.normals(), month);
  for (std::size_t b = 0; b < points_.size(); ++b) {
    const auto& full = points_[b].full[m];
    const bool is_full = std::all_of(full.begin(), full.end(),
                                     [&](const PlaceWeight& w) { return reports[w.place]; });
    weights[b] = is_full ? full : weights_of(points_[b], m, reports, bench);
  }
  return weights;
}

}  // namespace thiessen
