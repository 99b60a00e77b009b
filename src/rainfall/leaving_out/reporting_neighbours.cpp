#include "rainfall/leaving_out/reporting_neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "earth/sphere/conformal_sphere.h"
#include "geometry/predicates.h"
#include "rainfall/methods/nearest_gauges.h"
#include "tessellation/star.h"

namespace thiessen {
namespace {

double in_range_or_0(double coordinate) {
  return std::abs(coordinate) < smallest_coordinate ? 0 : coordinate;
}

ChartPoint seen_in(const StereographicChart& chart, Direction direction) {
  const Point at = chart.project(direction);
  return {{in_range_or_0(at.x), in_range_or_0(at.y)}, direction};
}

}  // namespace

ReportingNeighbours::ReportingNeighbours(std::span<const Point> places, Metric metric)
    : reports_(places.size(), false) {
  const GaugeChart chart(places, metric);
  kind_ = chart.kind();
  closes_ = kind_ == ChartKind::whole_earth;
  for (const Point p : places) at_.push_back(chart.at(p));
  if (closes_) see_from_between_two(places, metric);
  std::map<Point, std::size_t> numbers;
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    const auto [found, is_fresh] = numbers.emplace(at_[p].at, numbers.size());
    number_of_.push_back(found->second);
    if (is_fresh) places_of_.emplace_back();
    places_of_[found->second].push_back(PlaceIndex{p});
  }
  count_of_.resize(places_of_.size(), 0);
  id_of_.resize(places_of_.size(), infinite_point);
}

/// No gauge stands between one and the nearest to it.
void ReportingNeighbours::see_from_between_two(std::span<const Point> places, Metric metric) {
  std::vector<NearestGauges::Near> near;
  NearestGauges(places, metric).find(places.front(), 2, {}, near);
  const PlaceIndex other = index(near[0].place) == 0 ? near[1].place : near[0].place;
  const StereographicChart chart(unit(at_[0].direction + at_[index(other)].direction));
  for (ChartPoint& point : at_) point = seen_in(chart, point.direction);
}

void ReportingNeighbours::report(const ReportingPlaces& reports) {
  for (std::uint32_t p = 0; p < at_.size(); ++p) {
    const PlaceIndex place{p};
    if (reports[place] == reports_[place]) continue;
    reports_.set(place, reports[place]);
    const std::size_t number = number_of_[p];
    std::size_t& count = count_of_[number];
    if (reports[place]) {
      if (count++ > 0) continue;
      const PointId id = tessellation_.add(at_[p].at);
      id_of_[number] = id;
      number_at_.resize(std::max(number_at_.size(), index(id) + 1));
      number_at_[index(id)] = number;
    } else if (--count == 0) {
      tessellation_.remove(id_of_[number]);
    }
  }
}

void ReportingNeighbours::add_reporting(std::size_t number,
                                        std::vector<PlaceIndex>& neighbours) const {
  for (const PlaceIndex p : places_of_[number]) {
    if (reports_[p]) neighbours.push_back(p);
  }
}

void ReportingNeighbours::add_others(PlaceIndex place, std::vector<PlaceIndex>& neighbours) const {
  for (std::uint32_t p = 0; p < at_.size(); ++p) {
    if (PlaceIndex{p} != place && reports_[PlaceIndex{p}]) neighbours.push_back(PlaceIndex{p});
  }
}

void ReportingNeighbours::find(PlaceIndex place, std::vector<PlaceIndex>& neighbours) const {
  neighbours.clear();
  const std::size_t number = number_of_[index(place)];
  if (count_of_[number] > 1) {
    add_reporting(number, neighbours);
    std::erase(neighbours, place);
    return;
  }
  bool has_all = tessellation_.span() == Span::plane;
  if (has_all) {
    walk_round(tessellation_.topology(), id_of_[number], [&](VertexId, PointId next, VertexId) {
      if (next != infinite_point) {
        add_reporting(number_at_[index(next)], neighbours);
      } else if (closes_) {
        has_all = false;
      }
    });
  }
  if (!has_all) {
    neighbours.clear();
    add_others(place, neighbours);
  }
  std::sort(neighbours.begin(), neighbours.end());
}

void ReportingNeighbours::chart(PlaceIndex place, std::span<const PlaceIndex> neighbours,
                                std::vector<ChartPoint>& points, ChartPoint& own) const {
  points.clear();
  own = at_[index(place)];
  if (!closes_) {
    for (const PlaceIndex p : neighbours) points.push_back(at_[index(p)]);
    return;
  }
  const StereographicChart chart(-1.0 * own.direction);
  for (const PlaceIndex p : neighbours) points.push_back(seen_in(chart, at_[index(p)].direction));
  own = seen_in(chart, own.direction);
}

}  // namespace thiessen
