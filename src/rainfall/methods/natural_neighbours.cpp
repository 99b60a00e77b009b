#include "rainfall/methods/natural_neighbours.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "rainfall/methods/basin_points.h"
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

class NaturalNeighbours::Workplace {
 public:
  explicit Workplace(const NaturalNeighbours& all)
      : all_(all), natural_(all.full_.natural), sums(all.weighing_.network().places().size()) {}

  /// Finds the weights at a point when these places report, and tells whether the point is in the
  /// hull. Requires that at least one place reports, and that the tessellation is of those that
  /// report.
  bool find(const ChartPoint& at, Point position, const ReportingPlaces& reports,
            std::vector<Neighbour>& weights) {
    weights.clear();
    const bool is_inside = afresh_ ? afresh_->natural.find(afresh_->chart.at(position), gauges_)
                                   : natural_.find(at, gauges_);
    if (!is_inside) {
      all_.nearest_.find(position, 1, reports, near_);
      weights.push_back({near_.front().place, 1});
    }
    for (const NaturalWeight& w : gauges_) add_places(w, reports, weights);
    return is_inside;
  }

  void begin_anew() { natural_.begin_anew(); }
  /// Does `work` while the tessellation is of the places that report.
  template <typename Work>
  void with(const ReportingPlaces& reports, Work&& work) {
    const std::vector<PointId> silent = silent_numbers(reports);
    const bool closes = all_.full_.chart.kind() == ChartKind::whole_earth;
    bool done = false;
    if (!closes || silent.empty() || silent.front() != infinite_point) {
      natural_.without(silent, [&] {
        if (closes && !natural_.close_round_the_earth()) return;
        work();
        done = true;
      });
    }
    if (!done) with_others_afresh(reports, work);
  }

 private:
  std::vector<PointId> silent_numbers(const ReportingPlaces& reports) const {
    std::vector<PointId> silent;
    for (std::size_t n = 0; n < all_.full_.places_of.size(); ++n) {
      const auto& places = all_.full_.places_of[n];
      const bool is_silent =
          std::none_of(places.begin(), places.end(), [&](PlaceIndex p) { return reports[p]; });
      if (!places.empty() && is_silent) silent.push_back(PointId{static_cast<std::uint32_t>(n)});
    }
    return silent;
  }

  template <typename Work>
  void with_others_afresh(const ReportingPlaces& reports, Work&& work) {
    std::vector<Point> positions;
    std::vector<PlaceIndex> places;
    const std::vector<Point>& all = all_.weighing_.network().places();
    for (std::uint32_t p = 0; p < all.size(); ++p) {
      if (!reports[PlaceIndex{p}]) continue;
      positions.push_back(all[p]);
      places.push_back(PlaceIndex{p});
    }
    afresh_.emplace(positions, places, all_.weighing_.yardstick().metric);
    work();
    afresh_.reset();
  }

  void add_places(const NaturalWeight& w, const ReportingPlaces& reports,
                  std::vector<Neighbour>& weights) const {
    const std::size_t first = weights.size();
    for (const PlaceIndex p : (afresh_ ? *afresh_ : all_.full_).places_of[index(w.gauge)]) {
      if (reports[p]) weights.push_back({p, w.weight});
    }
    const auto count = static_cast<double>(weights.size() - first);
    for (std::size_t i = first; i < weights.size(); ++i) weights[i].weight /= count;
  }

  const NaturalNeighbours& all_;
  NaturalWeights natural_;
  std::optional<Gauges> afresh_;  // of a step for which it does not do to delete gauges
  std::vector<NaturalWeight> gauges_;
  std::vector<NearestGauges::Near> near_;

 public:
  WeightSums sums;
};

NaturalNeighbours::NaturalNeighbours(const Weighing& weighing, std::size_t points, unsigned threads)
    : weighing_(weighing),
      nearest_(weighing.network().places(), weighing.yardstick().metric),
      full_(weighing.network().places(), all_places(weighing.network().places().size()),
            weighing.yardstick().metric),
      points_(weighing.basins().size()),
      shares_outside_(points_.size()) {
  in_parallel(points_.size(), threads, [&](std::size_t, std::size_t b) {
    points_[b].positions = basin_points(weighing.basins()[b], weighing.yardstick(), points);
    points_[b].at = charted(points_[b].positions, full_.chart);
    points_[b].normals = point_normals(weighing.normals(), b, points_[b].positions);
    auto workplace = borrow();
    shares_outside_[b] =
        static_cast<double>(keep_neighbours(points_[b], *workplace)) / static_cast<double>(points);
    give_back(std::move(workplace));
  });
}

NaturalNeighbours::~NaturalNeighbours() = default;

// Returns how many points are outside the hull.
std::size_t NaturalNeighbours::keep_neighbours(Points& points, Workplace& workplace) const {
  const ReportingPlaces reports(weighing_.network().places().size(), true);
  std::vector<Neighbour> weights;
  std::size_t outside = 0;
  workplace.begin_anew();
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    if (!workplace.find(points.at[i], points.positions[i], reports, weights)) ++outside;
    points.neighbours.insert(points.neighbours.end(), weights.begin(), weights.end());
    points.first.push_back(static_cast<std::uint32_t>(points.neighbours.size()));
  }
  points.neighbours.shrink_to_fit();
  for (const Neighbour& w : points.neighbours) points.all.push_back(w.place);
  std::sort(points.all.begin(), points.all.end());
  points.all.erase(std::unique(points.all.begin(), points.all.end()), points.all.end());
  points.all.shrink_to_fit();
  for (std::size_t m = 0; m < std::max<std::size_t>(1, points.normals.size()); ++m)
    points.full.push_back(weights_of(points, m, reports, workplace));
  return outside;
}

std::vector<PlaceWeight> NaturalNeighbours::weights_of(const Points& points, std::size_t month,
                                                       const ReportingPlaces& reports,
                                                       Workplace& workplace) const {
  std::vector<Neighbour> found;
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    const auto first = points.neighbours.begin() + points.first[i];
    const auto end = points.neighbours.begin() + points.first[i + 1];
    const bool as_ever =
        std::all_of(first, end, [&](const Neighbour& w) { return reports[w.place]; });
    if (!as_ever) workplace.find(points.at[i], points.positions[i], reports, found);
    const std::span<const Neighbour> weights = as_ever ? std::span(first, end) : std::span(found);
    if (points.normals.empty()) {
      for (const Neighbour& w : weights) workplace.sums.add(w.place, w.weight);
    } else {
      for (const Neighbour& w : weights)
        workplace.sums.add(w.place, w.weight, points.normals[month][i]);
    }
  }
  return workplace.sums.take();
}

AreaMethod::Weights NaturalNeighbours::weights(const ReportingPlaces& reports,
                                               const NormalMonth& month) const {
  const std::size_t m = place_of(weighing_.normals(), month);
  Weights weights(points_.size());
  if (!reports.any()) return weights;
  std::vector<std::size_t> changed;
  for (std::size_t b = 0; b < points_.size(); ++b) {
    if (all_report(points_[b].all, reports)) {
      weights[b] = points_[b].full[m];
    } else {
      changed.push_back(b);
    }
  }
  if (changed.empty()) return weights;
  auto workplace = borrow();
  workplace->with(reports, [&] {
    for (const std::size_t b : changed) weights[b] = weights_of(points_[b], m, reports, *workplace);
  });
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
