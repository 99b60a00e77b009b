#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/methods/gauge_chart.h"
#include "rainfall/network/reporting.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Which places are neighbours among those that report, kept from step to step: places that fall
/// silent are deleted from one tessellation, and those that report again inserted, as in the thesis
/// (J. C.-H. Chang, 1982).
///
/// If a place is left out, its cell falls to its neighbours alone. So whatever is told at it by
/// natural neighbours or by triangles hangs on these alone, and on no other gauge.
///
/// The chart is that of the whole network, as NaturalNeighbours has it. Gauges all round the Earth
/// have a chart that is seen from between two of them; those next to these take all others for
/// neighbours, of which the true ones are a part. Cost of a step: 10 microseconds for each place
/// that falls silent or reports again.
class ReportingNeighbours {
 public:
  /// Requires at least one place, and all places different. Nobody reports at first.
  ReportingNeighbours(std::span<const Point> places, Metric metric);

  void report(const ReportingPlaces& reports);
  /// Finds the neighbours of a place that reports, in rising order. Where places at one point of
  /// the chart, which rounding cannot tell apart, report too, they alone are.
  void find(PlaceIndex place, std::vector<PlaceIndex>& neighbours) const;

  /// The chart in which a place's neighbours tell what is at it: the places' points there, and its
  /// own. Without a hull it is the chart from the place's antipode.
  ChartKind kind() const { return closes_ ? ChartKind::part_of_earth : kind_; }
  void chart(PlaceIndex place, std::span<const PlaceIndex> neighbours,
             std::vector<ChartPoint>& points, ChartPoint& own) const;

 private:
  void see_from_between_two(std::span<const Point> places, Metric metric);
  void add_others(PlaceIndex place, std::vector<PlaceIndex>& neighbours) const;
  void add_reporting(std::size_t number, std::vector<PlaceIndex>& neighbours) const;

  ChartKind kind_;
  bool closes_;                                     // whether the gauges stand all round the Earth
  std::vector<ChartPoint> at_;                      // by place
  std::vector<std::size_t> number_of_;              // by place: that of its point of the chart
  std::vector<std::vector<PlaceIndex>> places_of_;  // by number
  ReportingPlaces reports_;
  std::vector<std::size_t> count_of_;   // by number: how many of its places report
  std::vector<PointId> id_of_;          // by number, where one reports
  std::vector<std::size_t> number_at_;  // by id
  Tessellation<2> tessellation_;
};

}  // namespace thiessen
