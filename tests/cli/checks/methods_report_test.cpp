#include "cli/checks/methods_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

GivenFiles three_gauges() {
  GivenFiles files;
  files.stations = "id,x,y,Elevation\nA,0,2,1200\nB,8,2,\nC,8,4,12e2\n";
  files.options.emplace_back("--attributes");
  return files;
}

std::string report(const GivenInputs& given, std::size_t steps, const std::string& unit) {
  MethodsReport methods(given.inputs, {}, "rain.csv", Stamp::begin);
  const std::vector<double> readings{10, 20, 30};
  for (std::size_t t = 0; t < steps; ++t) methods.add({std::to_string(t), readings});
  return methods.text(unit, 1);
}

TEST(MethodsReport, elevations_are_found_by_their_fields_name) {
  const GivenInputs given(three_gauges());
  const std::vector<double> elevations = elevations_in_attributes(given.inputs.study());
  ASSERT_EQ(elevations.size(), 3u);
  EXPECT_EQ(elevations[0], 1200);
  EXPECT_TRUE(std::isnan(elevations[1]));
  EXPECT_EQ(elevations[2], 1200);
  GivenFiles without;
  without.options.emplace_back("--attributes");
  EXPECT_TRUE(elevations_in_attributes(GivenInputs(without).inputs.study()).empty());
}

TEST(MethodsReport, codes_for_a_missing_elevation_are_none) {
  GivenFiles files = three_gauges();
  files.stations = "id,x,y,Elevation\nA,0,2,1200\nB,8,2,-999.9\nC,8,4,-430\n";
  const GivenInputs given(files);
  const std::vector<double> elevations = elevations_in_attributes(given.inputs.study());
  ASSERT_EQ(elevations.size(), 3u);
  EXPECT_TRUE(std::isnan(elevations[1]));
  EXPECT_EQ(elevations[2], -430) << "the Dead Sea";
}

// By hand: A is told 20 by B, and B and C tell each other 30 and 20.
TEST(MethodsReport, says_what_the_readings_are_in) {
  const GivenInputs given(three_gauges());
  const std::string text = report(given, 1, "mm");
  EXPECT_NE(text.find("3 readings of 3 gauges are told by the others; root mean square error and "
                      "bias, in mm:\n"
                      "at the steps   all  bias\n"
                      "thiessen      10.0   3.3\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("thiessen, off by 10.0 mm at a step"), std::string::npos) << text;
  EXPECT_EQ(text.find("looked at"), std::string::npos) << text;
}

TEST(MethodsReport, a_long_series_is_looked_at_here_and_there) {
  const GivenInputs given(three_gauges());
  const std::string text = report(given, MethodsReport::most_readings / 3 + 7, "");
  EXPECT_NE(text.find("of 333340 steps one of every 2 was looked at"), std::string::npos) << text;
  EXPECT_NE(text.find("leaving each gauge out: 500010 readings of 3 gauges"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace thiessen::cli
