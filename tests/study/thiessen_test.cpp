#include "study/thiessen.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/complaints.h"

namespace thiessen {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two gauges, and a basin of 6 by 2 that their bisector at x = 2 halves.
ThiessenInput two_gauges() {
  ThiessenInput input;
  input.stations = {{"a", {0, 0}}, {"b", {4, 0}}};
  input.basins = {{"B", {{{{-1, -1}, {5, -1}, {5, 1}, {-1, 1}}, {}}}, {}}};
  return input;
}

std::vector<std::string> faults_of(const ThiessenInput& input) {
  return complaints_of([&] { const Thiessen unused(input); });
}

void expect_halves(const Thiessen& study) {
  const std::vector<BasinWeights>& weights = study.weights();
  ASSERT_EQ(weights.size(), 1U);
  EXPECT_EQ(weights[0].area, 12);
  ASSERT_EQ(weights[0].stations.size(), 2U);
  EXPECT_EQ(weights[0].stations[0].weight, 0.5);
  EXPECT_EQ(weights[0].stations[1].area, 6);
}

TEST(Thiessen, weighs_gauges_from_memory) {
  const Thiessen study(two_gauges());
  expect_halves(study);
  EXPECT_TRUE(study.warnings().empty());
}

TEST(Thiessen, owns_what_it_was_given_and_may_be_moved) {
  std::vector<Thiessen> studies;
  {
    Thiessen made(two_gauges());
    studies.push_back(std::move(made));
  }
  expect_halves(studies[0]);
}

TEST(Thiessen, turns_a_clockwise_ring_and_takes_off_a_repeated_last_point) {
  ThiessenInput input = two_gauges();
  input.basins[0].shape[0].outer = {{-1, -1}, {-1, 1}, {5, 1}, {5, -1}, {-1, -1}};
  const Thiessen study(input);
  expect_halves(study);
  EXPECT_EQ(study.basins()[0].shape[0].outer.size(), 4U);
  EXPECT_TRUE(study.warnings().empty());
}

TEST(Thiessen, refuses_coordinates_that_are_no_numbers_all_at_once) {
  ThiessenInput input = two_gauges();
  input.stations[0].position.x = nan;
  input.stations[1].position.y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(faults_of(input),
            (std::vector<std::string>{"station 'a' has a coordinate that is not finite",
                                      "station 'b' has a coordinate that is not finite"}));
}

TEST(Thiessen, refuses_coordinates_beyond_the_exact_range) {
  ThiessenInput input = two_gauges();
  input.stations[1].position.x = 1e200;
  const auto faults = faults_of(input);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("a coordinate of station 'b' is outside the supported range"),
            std::string::npos);
}

TEST(Thiessen, mends_a_basin_that_crosses_itself_where_that_is_asked_for) {
  ThiessenInput input = two_gauges();
  input.basins[0].shape[0].outer = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  input.mend = true;
  const Thiessen study(input);
  EXPECT_EQ(study.weights().at(0).area, 8);
  ASSERT_EQ(study.warnings().size(), 1U);
  EXPECT_NE(study.warnings()[0].sentence().find("in dispute at 2 2"), std::string::npos);
}

TEST(Thiessen, refuses_an_edge_whose_way_round_the_earth_is_not_known) {
  ThiessenInput input = two_gauges();
  input.metric = Metric::geodesic;
  input.basins[0].shape[0].outer = {{-10, 0}, {180, 0}, {180, 80}, {-10, 80}};
  const std::vector<std::string> faults = faults_of(input);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("the edge from -10 0 to 180 0"), std::string::npos) << faults[0];
}

TEST(Thiessen, refuses_a_basin_that_crosses_itself) {
  ThiessenInput input = two_gauges();
  input.basins[0].shape[0].outer = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  const auto faults = faults_of(input);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("basin 'B' crosses or overlaps itself"), std::string::npos);
}

TEST(Thiessen, refuses_ids_and_shapes_that_are_missing_or_there_twice) {
  ThiessenInput input = two_gauges();
  input.stations[1].id = "a";
  EXPECT_EQ(faults_of(input),
            std::vector<std::string>{"station 'a' is there twice | ids must differ"});
  input.stations.clear();
  EXPECT_EQ(faults_of(input), std::vector<std::string>{"there are no stations"});
  input = two_gauges();
  input.basins.push_back(input.basins[0]);
  EXPECT_EQ(faults_of(input),
            std::vector<std::string>{
                "basin 'B' is there twice | parts of one basin are one basin's shape"});
  input = two_gauges();
  input.basins[0].shape.clear();
  EXPECT_EQ(faults_of(input), std::vector<std::string>{"basin 'B' has an empty geometry"});
}

TEST(Thiessen, refuses_settings_that_no_study_can_be_computed_with) {
  const auto faults = [](auto set) {
    ThiessenInput input = two_gauges();
    set(input);
    return faults_of(input).size();
  };
  EXPECT_EQ(faults([](ThiessenInput& input) { input.metres_per_unit = 1e-200; }), 1U);
  EXPECT_EQ(faults([](ThiessenInput& input) { input.metres_per_unit = nan; }), 1U);
  EXPECT_EQ(faults([](ThiessenInput& input) { input.tolerance = 1e-300; }), 1U);
  EXPECT_EQ(faults([](ThiessenInput& input) { input.margin = -1; }), 1U);
}

TEST(Thiessen, areas_are_square_metres_by_the_length_of_the_planes_unit) {
  ThiessenInput input = two_gauges();
  input.metres_per_unit = 1000;
  EXPECT_EQ(Thiessen(input).weights()[0].area, 12e6);
}

TEST(Thiessen, refuses_degrees_that_are_none_on_the_earth_alone) {
  ThiessenInput input = two_gauges();
  input.stations[0].position = {0, 91};
  EXPECT_NO_THROW(Thiessen unused(input));
  input.metric = Metric::geodesic;
  EXPECT_EQ(faults_of(input),
            std::vector<std::string>{"latitude 91 of station 'a' is outside [-90, 90] | "
                                     "latitude and longitude look swapped"});
}

TEST(Thiessen, warns_of_stations_at_one_place_which_share_its_cell) {
  ThiessenInput input = two_gauges();
  input.stations.push_back({"c", {4, -0.0}});
  const Thiessen study(input);
  ASSERT_EQ(study.warnings().size(), 1U);
  EXPECT_EQ(study.weights()[0].stations[2].weight, 0.25);
}

TEST(Thiessen, without_basins_the_extent_of_the_gauges_is_weighed) {
  ThiessenInput input = two_gauges();
  input.stations.push_back({"c", {4, 2}});
  input.basins.clear();
  const Thiessen study(input);
  EXPECT_EQ(study.weights()[0].area, 8);
}

TEST(Thiessen, rainfall_is_the_sum_of_weight_and_reading_and_a_silent_gauge_hands_its_cell_over) {
  const Thiessen study(two_gauges());
  EXPECT_EQ(study.rainfall(std::vector<double>{10, 30})[0].rainfall, 20);
  EXPECT_EQ(study.rainfall(std::vector<double>{10, nan})[0].rainfall, 10);
  EXPECT_TRUE(std::isnan(study.rainfall(std::vector<double>{nan, nan})[0].rainfall));
  EXPECT_EQ(study.weights({false, true})[0].stations[0].weight, 1);
}

// The factors are 60 / 40 and 60 / 80: 0.5 x 1.5 x 10 + 0.5 x 0.75 x 13 = 12.375; of a alone 15.
TEST(Thiessen, readings_count_by_normals) {
  ThiessenInput input = two_gauges();
  input.station_normals = {40, 80};
  input.basin_normals = {60};
  const Thiessen study(input);
  expect_halves(study);
  EXPECT_EQ(study.weights()[0].stations[0].factor, 1.5);
  EXPECT_EQ(study.weights({true, false})[0].stations[0].factor, 1.5);
  EXPECT_EQ(study.cells()[0][1].factor, 0.75);
  EXPECT_DOUBLE_EQ(study.rainfall(std::vector{10.0, 13.0})[0].rainfall, 12.375);
  EXPECT_DOUBLE_EQ(study.rainfall(std::vector{10.0, nan})[0].rainfall, 15);
}

TEST(Thiessen, refuses_normals_that_are_not_one_for_each_and_above_0) {
  ThiessenInput input = two_gauges();
  input.station_normals = {40, 0, nan};
  EXPECT_EQ(faults_of(input),
            (std::vector<std::string>{"2 stations, and 3 normals: one for each is needed",
                                      "the normal of number 1 of the stations is not above 0",
                                      "the normal of number 2 of the stations is not above 0",
                                      "1 basins, and 0 normals: one for each is needed"}));
}

TEST(Thiessen, refuses_more_or_fewer_readings_than_stations) {
  const Thiessen study(two_gauges());
  EXPECT_EQ(complaints_of([&] { study.rainfall(std::vector<double>{1}); }),
            std::vector<std::string>{"2 stations, and 1 readings: one for each is needed"});
  EXPECT_THROW(study.weights({true}), Error);
}

TEST(Thiessen, refuses_a_negative_reading) {
  const Thiessen study(two_gauges());
  EXPECT_EQ(complaints_of([&] {
              study.rainfall(std::vector<double>{1, -5});
            }),
            std::vector<std::string>{"the reading of station 'b' is negative"});
}

TEST(Thiessen, the_cells_of_a_basin_cover_it) {
  const Thiessen study(two_gauges());
  const auto cells = study.cells();
  ASSERT_EQ(cells[0].size(), 2U);
  EXPECT_EQ(cells[0][0].area + cells[0][1].area, 12);
}

// A degree of longitude from 179.5 on: the basin lies on both sides of the antimeridian.
TEST(Thiessen, a_basin_over_the_antimeridian_goes_the_short_way) {
  ThiessenInput input;
  input.metric = Metric::geodesic;
  input.stations = {{"west", {179.75, 0}}, {"east", {-179.75, 0}}};
  input.basins = {{"B", {{{{179.5, -0.5}, {-179.5, -0.5}, {-179.5, 0.5}, {179.5, 0.5}}, {}}}, {}}};
  const Thiessen study(input);
  const auto& weights = study.weights();
  EXPECT_NEAR(weights[0].stations[0].weight, 0.5, 1e-12);
  EXPECT_NEAR(weights[0].area, 1.2309e10, 1e7);
}

/// All weights of a study of awkward numbers, and its rainfall.
std::vector<double> figures_of_thirds() {
  ThiessenInput input;
  input.stations = {{"a", {0.1, 0.7}}, {"b", {1.0 / 3, 0.2}}, {"c", {2.0 / 3, 0.9}}};
  input.basins = {{"B", {{{{0, 0}, {1.1, 0.1}, {0.9, 1.2}, {0.1, 0.9}}, {}}}, {}}};
  const Thiessen study(input);
  std::vector<double> figures;
  for (const StationWeight& gauge : study.weights()[0].stations) figures.push_back(gauge.weight);
  const std::vector<BasinWeights> without = study.weights({true, false, true});
  for (const StationWeight& gauge : without[0].stations) figures.push_back(gauge.weight);
  const std::vector<std::vector<StationCell>> cells = study.cells();
  for (const StationCell& cell : cells[0]) figures.push_back(cell.area);
  figures.push_back(study.rainfall(std::vector<double>{0.1, 0.2, nan})[0].rainfall);
  return figures;
}

TEST(Thiessen, is_the_same_whatever_way_of_rounding_the_caller_has_set) {
  const std::vector<double> figures = figures_of_thirds();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::vector<double> again = figures_of_thirds();
    EXPECT_EQ(std::fegetround(), mode) << "the caller's own";
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(again, figures) << mode;
  }
}

}  // namespace
}  // namespace thiessen
