#include "study/nearness.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "base/complaints.h"
#include "study/thiessen.h"

namespace thiessen {
namespace {

ThiessenInput study_of(std::vector<Point> gauges, double west, double south, double side,
                       Metric metric = Metric::geodesic) {
  ThiessenInput input;
  input.metric = metric;
  for (std::size_t i = 0; i < gauges.size(); ++i)
    input.stations.push_back({"g" + std::to_string(i), gauges[i]});
  input.basins = {
      {"B",
       {{{{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}},
         {}}},
       {}}};
  return input;
}

std::string error_of(ThiessenInput input) {
  try {
    const Thiessen study(std::move(input));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string warnings_of(ThiessenInput input) {
  std::string text;
  const Thiessen study(std::move(input));
  for (const Message& message : study.warnings()) text += message.sentence() + "\n";
  return text;
}

TEST(Nearness, names_the_mistake_without_which_they_would_meet) {
  const auto swapped = error_of(study_of({{47.1, 10.1}, {47.2, 10.9}}, 10, 47, 1));
  EXPECT_NE(swapped.find("nowhere near each other"), std::string::npos) << swapped;
  EXPECT_NE(swapped.find("latitude and longitude swapped"), std::string::npos) << swapped;
  EXPECT_NE(swapped.find("longitude 47.1 to 47.2, latitude 10.1 to 10.9"), std::string::npos);
  EXPECT_NE(swapped.find("longitude 10 to 11, latitude 47 to 48"), std::string::npos);
  const auto sign = error_of(study_of({{105.1, 40.1}, {104.9, 40.2}}, -106, 40, 1));
  EXPECT_NE(sign.find("the other sign of longitude"), std::string::npos) << sign;
  const auto south = error_of(study_of({{18.2, 33.1}, {18.4, 33.9}}, 18, -34, 1));
  EXPECT_NE(south.find("the other sign of latitude"), std::string::npos) << south;
  const auto km =
      error_of(study_of({{501, 5201}, {502, 5203}}, 500000, 5200000, 5000, Metric::planar));
  EXPECT_NE(km.find("the gauges' coordinates in kilometres"), std::string::npos) << km;
}

TEST(Nearness, no_mistake_is_named_that_does_not_help) {
  const auto far = error_of(study_of({{-105, 40}, {-104, 39}, {-106, 39.5}}, -9, 52, 1));
  EXPECT_NE(far.find("nowhere near each other"), std::string::npos) << far;
  EXPECT_EQ(far.find("would meet"), std::string::npos) << far;
}

TEST(Nearness, may_be_allowed) {
  ThiessenInput input = study_of({{-105, 40}, {-104, 39}, {-106, 39.5}}, -9, 52, 1);
  input.allow_far = true;
  EXPECT_NE(warnings_of(input).find("nowhere near each other"), std::string::npos);
}

TEST(Nearness, both_bounds_have_to_be_passed) {
  // 290 km of a village are far beside its extent, and no fault below 300 km.
  EXPECT_EQ(error_of(study_of({{10, 50}}, 10, 52.6, 0.01)), "");
  EXPECT_NE(error_of(study_of({{10, 50}}, 10, 52.8, 0.01)), "");
  // 2,000 km beside a country of 900.
  EXPECT_EQ(error_of(study_of({{0, 40}, {8, 45}}, 30, 40, 1)), "");
}

TEST(Nearness, a_basin_far_from_dense_gauges_is_warned_of) {
  std::vector<Point> gauges;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) gauges.push_back({10 + 0.1 * i, 50 + 0.1 * j});
  }
  const std::string warning = warnings_of(study_of(gauges, 10, 51.2, 0.1));
  EXPECT_NE(warning.find("far from all gauges: basin 'B' is 89.0 km from the nearest"),
            std::string::npos)
      << warning;
  EXPECT_EQ(warning.find("would meet"), std::string::npos) << warning;
  EXPECT_EQ(warnings_of(study_of(gauges, 10, 50.6, 0.1)), "");
  // A basin as wide as it is far is not far.
  EXPECT_EQ(warnings_of(study_of(gauges, 10, 51.2, 1)), "");
}

TEST(Nearness, of_a_plane_without_a_unit_only_the_proportions_count) {
  StudyParts parts;
  parts.stations = {{"a", {0, 0}}, {"b", {1, 0}}};
  parts.basins = {{"B", {{{{20, 0}, {21, 0}, {21, 1}, {20, 1}}, {}}}, {}}};
  const Network network(parts.stations, Metric::planar);
  Warnings warnings;
  EXPECT_THROW(judge_nearness(parts, network, false, warnings), Error);
  parts.basins[0].shape[0].outer = {{7, 0}, {8, 0}, {8, 1}, {7, 1}};
  judge_nearness(parts, network, false, warnings);
  EXPECT_EQ(warnings.messages().size(), 1U);
}

}  // namespace
}  // namespace thiessen
