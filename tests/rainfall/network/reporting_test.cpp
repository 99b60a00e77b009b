#include "rainfall/network/reporting.h"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

// Three stations, of which the second and the third share a place.
const Network& network() {
  static const Network three({{"a", {0, 0}}, {"b", {1, 0}}, {"c", {1, 0}}}, Metric::planar);
  return three;
}

template <typename Set, typename Index>
concept asked_by = requires(const Set& set, Index i) {
  set[i];
};

TEST(Reporting, stations_and_places_are_not_mistaken_for_each_other) {
  static_assert(asked_by<ReportingStations, StationIndex>);
  static_assert(asked_by<ReportingPlaces, PlaceIndex>);
  static_assert(!asked_by<ReportingStations, PlaceIndex>);
  static_assert(!asked_by<ReportingPlaces, StationIndex>);
  static_assert(!asked_by<ReportingStations, std::size_t>);
  static_assert(!std::is_convertible_v<ReportingStations, ReportingPlaces>);
}

TEST(Reporting, stations_report_where_their_reading_is_a_number) {
  const std::vector<double> readings{silent, 0, silent};
  EXPECT_EQ(reporting_stations(readings), ReportingStations({false, true, false}));
}

TEST(Reporting, a_place_reports_where_one_of_its_stations_does) {
  EXPECT_EQ(reporting_places(network(), std::vector<double>{silent, silent, 3}),
            ReportingPlaces({false, true}));
  EXPECT_EQ(reporting_places(network(), std::vector<double>{1, silent, silent}),
            ReportingPlaces({true, false}));
}

TEST(Reporting, knows_whether_any_does) {
  ReportingStations report(3, false);
  EXPECT_FALSE(report.any());
  report.set(StationIndex{2}, true);
  EXPECT_TRUE(report.any());
  EXPECT_TRUE(report[StationIndex{2}]);
  EXPECT_FALSE(report[StationIndex{0}]);
}

}  // namespace
}  // namespace thiessen
