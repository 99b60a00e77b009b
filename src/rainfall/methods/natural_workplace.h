#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/methods/natural_neighbours.h"

namespace thiessen {

class NaturalNeighbours::Workplace {
 public:
  explicit Workplace(const NaturalNeighbours& all);

  /// Finds the weights at a point when these places report, and tells whether the point is in the
  /// hull. Requires that at least one place reports, and that the tessellation is of those that
  /// report.
  bool find(const ChartPoint& at, Point position, const ReportingPlaces& reports,
            std::vector<Neighbour>& weights);
  /// The sums of a block's weights, which depend on it and on the places that report alone.
  /// Requires what `find` does.
  Sums sums_of(const Points& points, const PointBlock& block, std::size_t month,
               const ReportingPlaces& reports);

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
  /// Does `work(reports)` while the tessellation is of all places but these few. Requires a chart
  /// that is not of the whole Earth.
  template <typename Work>
  void without(std::span<const PlaceIndex> silent, Work&& work) {
    for (const PlaceIndex p : silent) all_but_.set(p, false);
    std::vector<PointId> numbers;
    for (const PlaceIndex p : silent) {
      const PointId number = all_.full_.natural.numbers()[index(p)];
      const bool is_new = std::find(numbers.begin(), numbers.end(), number) == numbers.end();
      if (is_new && is_silent(number, all_but_)) numbers.push_back(number);
    }
    natural_.without(numbers, [&] { work(std::as_const(all_but_)); });
    for (const PlaceIndex p : silent) all_but_.set(p, true);
  }

 private:
  bool is_silent(PointId number, const ReportingPlaces& reports) const;
  std::vector<PointId> silent_numbers(const ReportingPlaces& reports) const;
  void begin_in(const Points& points, const PointBlock& block, const ReportingPlaces& reports);

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
                  std::vector<Neighbour>& weights) const;

  const NaturalNeighbours& all_;
  NaturalWeights natural_;
  std::optional<Gauges> afresh_;  // of a step for which it does not do to delete gauges
  ReportingPlaces all_but_;       // all true between calls
  std::vector<NaturalWeight> gauges_;
  std::vector<NearestGauges::Near> near_;
  std::vector<Neighbour> found_;

 public:
  WeightSums sums;
};

}  // namespace thiessen
