#include "study/coordinate_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/complaints.h"

namespace thiessen {
namespace {

constexpr CoordinateKind degrees = {true, 1};
constexpr CoordinateKind grads = {true, 0.9};

StationList stations_at(const std::vector<Point>& points, bool has_lines = true) {
  StationList list = {"s.csv", {}, has_lines};
  for (const Point point : points) {
    const std::size_t number = list.stations.size();
    list.stations.push_back({std::string(1, static_cast<char>('a' + number)), point, number + 2});
  }
  return list;
}

BasinList basin_of(const Ring& ring) {
  return {"b.csv", {{"q", "basin 'q'", 7, {{ring, {}}}}}};
}

std::vector<std::string> faults(const StationList& list, CoordinateKind kind = degrees) {
  return complaints_of([&] { require_degrees(list, kind); });
}

TEST(Reach, is_the_range_of_all_points) {
  const Reach reach = reach_of(stations_at({{3.5, 41}, {9, 40}}));
  EXPECT_EQ(reach.sentence(), "x from 3.5 to 9 and y from 40 to 41");
  EXPECT_EQ(reach.points, 2U);
  const Reach basins = reach_of(basin_of({{-2, 1}, {5, 1}, {5, 8}}));
  EXPECT_EQ(basins.sentence(), "x from -2 to 5 and y from 1 to 8");
}

TEST(Reach, looks_like_degrees_where_half_of_the_points_or_more_may_be) {
  EXPECT_TRUE(reach_of(stations_at({{360, 90}, {-360, -90}})).looks_like_degrees());
  EXPECT_EQ(reach_of(stations_at({{360.1, 0}, {0, 90.1}, {0, -91}})).not_degrees, 3U);
  EXPECT_TRUE(reach_of(stations_at({{500, 0}, {5, 0}})).looks_like_degrees());
  EXPECT_FALSE(reach_of(stations_at({{500, 0}, {5, 0}, {5, 99}})).looks_like_degrees());
}

TEST(RequireDegrees, takes_latitudes_to_90_and_longitudes_to_540) {
  EXPECT_NO_THROW(require_degrees(stations_at({{540, 90}, {-540, -90}}), degrees));
  EXPECT_EQ(
      faults(stations_at({{0, 90.5}, {0, -91}, {541, 0}, {-600, 0}})),
      (std::vector<std::string>{"s.csv:2: latitude 90.5 of station 'a' is outside [-90, 90]",
                                "s.csv:3: latitude -91 of station 'b' is outside [-90, 90]",
                                "s.csv:4: longitude 541 of station 'c' is outside [-540, 540]",
                                "s.csv:5: longitude -600 of station 'd' is outside [-540, 540]"}));
}

TEST(RequireDegrees, counts_in_the_unit_of_the_crs) {
  EXPECT_NO_THROW(require_degrees(stations_at({{600, 100}}), grads));
  EXPECT_EQ(faults(stations_at({{0, 101}}), grads).size(), 1U);
  EXPECT_EQ(faults(stations_at({{601, 0}}), grads).size(), 1U);
}

TEST(RequireDegrees, refuses_what_is_no_number) {
  const auto found = faults(stations_at({{0, std::nan("")}, {std::nan(""), 0}}));
  ASSERT_EQ(found.size(), 2U);
  for (const std::string& fault : found)
    EXPECT_TRUE(contains(fault, "has a coordinate that is no number")) << fault;
}

TEST(RequireDegrees, asks_once_whether_columns_are_swapped_where_that_would_explain_all) {
  const auto swapped = faults(stations_at({{35, 132.5}, {15, 50}, {36, -133}}));
  ASSERT_EQ(swapped.size(), 2U);
  EXPECT_TRUE(swapped[0].ends_with(" | columns look swapped: latitude and longitude"));
  EXPECT_FALSE(contains(swapped[1], "swapped"));
  for (const Point other : {Point{100, 95}, Point{0, 400}, Point{600, 0}}) {
    for (const std::string& fault : faults(stations_at({{35, 132.5}, other})))
      EXPECT_FALSE(contains(fault, "swapped")) << fault;
  }
}

TEST(RequireDegrees, names_features_by_their_number_where_a_file_has_no_lines) {
  EXPECT_EQ(faults(stations_at({{35, 132.5}}, false)),
            std::vector<std::string>{"s.csv: feature 2: latitude 132.5 of station 'a' is outside "
                                     "[-90, 90] | latitude and longitude look swapped"});
}

TEST(RequireDegrees, of_basins_names_the_first_bad_vertex_of_each) {
  EXPECT_NO_THROW(require_degrees(basin_of({{0, 0}, {540, 90}, {0, 9}}), degrees));
  EXPECT_EQ(complaint_of([] {
              require_degrees(basin_of({{0, 0}, {0, 95}, {0, 96}}), degrees);
            }),
            "b.csv:7: latitude 95 of basin 'q' is outside [-90, 90]");
  EXPECT_TRUE(complaint_of([] {
                require_degrees(basin_of({{50, 100}, {51, 100}, {51, 101}}), degrees);
              }).ends_with(" | latitude and longitude look swapped"));
}

TEST(TurnLongitudes, law_1_are_within_180_degrees_and_whole_turns_from_where_they_were) {
  for (double before = -540; before <= 540; before += 7.5) {
    StationList list = stations_at({{before, 1}});
    Warnings warnings;
    turn_longitudes(list, degrees, warnings);
    const double after = list.stations[0].position.x;
    EXPECT_LE(std::abs(after), 180) << before;
    EXPECT_EQ(std::remainder(after - before, 360), 0) << before;
    EXPECT_EQ(list.stations[0].position.y, 1);
    EXPECT_EQ(warnings.messages().empty(), std::abs(before) <= 180);
    if (std::abs(before) <= 180) {
      EXPECT_EQ(after, before);
    }
  }
}

TEST(TurnLongitudes, is_told_once_for_all_stations) {
  const auto warned = [](const std::vector<Point>& points, CoordinateKind kind) {
    StationList list = stations_at(points);
    Warnings warnings;
    turn_longitudes(list, kind, warnings);
    return sentences_of(warnings);
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(warned({{5, 0}, {185, 0}}, degrees),
            Texts{"s.csv:3: longitude 185 of station 'b' is taken for -175"});
  EXPECT_EQ(warned({{185, 0}, {190, 0}}, degrees),
            Texts{"s.csv:2: longitude 185 of station 'a' is taken for -175, and 1 other likewise"});
  EXPECT_TRUE(
      warned({{185, 0}, {190, 0}, {195, 0}}, degrees)[0].ends_with("and 2 others likewise"));
  EXPECT_EQ(warned({{200, 0}}, grads), Texts{}) << "200 grads are 180 degrees";
  EXPECT_EQ(warned({{210, 0}}, grads),
            Texts{"s.csv:2: longitude 210 of station 'a' is taken for -190"});
}

TEST(LongitudeRange, holds_one_turn_from_minus_180_or_from_0) {
  const auto fault = [](const std::vector<double>& longitudes) -> std::string {
    LongitudeRange range;
    for (const double x : longitudes)
      range.see(x, "station '" + std::to_string(static_cast<int>(x)) + "'", "s.csv", 2);
    try {
      range.require_one_turn();
    } catch (const Error& error) {
      return error.messages()[0].sentence();
    }
    return "";
  };
  for (const std::vector<double>& fine :
       {std::vector<double>{}, {-180, 180}, {0, 360}, {-190, -10}, {170, 185}, {-540, 0}})
    EXPECT_EQ(fault(fine), "");
  EXPECT_EQ(fault({170, 185, 190, -175, -1}),
            "s.csv:2: longitude 190 of station '190' beside -175 of station '-175': planar "
            "distances do not go round the Earth");
  EXPECT_TRUE(fault({-190, 10}).starts_with("s.csv:2: longitude -190 of station '-190' beside 10"));
}

}  // namespace
}  // namespace thiessen
