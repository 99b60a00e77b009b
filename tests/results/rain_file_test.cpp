#include "results/rain_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/complaints.h"
#include "results/written.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<Basin> basins(const std::vector<std::string>& ids) {
  std::vector<Basin> basins;
  for (const std::string& id : ids) basins.push_back({id, {}, {}});
  return basins;
}

RainStep step(std::vector<BasinRainfall> values) {
  RainStep step;
  step.time = "t,1";
  step.basins = std::move(values);
  return step;
}

std::string rain(const std::vector<Basin>& basins, const RainFormat& format, const RainStep& step,
                 std::size_t pattern = 0) {
  return written([&](OutputFile& file) {
    RainFile rain(file, basins, format);
    rain.append(rain.text_of(step, pattern));
  });
}

TEST(RainFile, has_a_column_a_basin_and_leaves_empty_what_cannot_be_had) {
  EXPECT_EQ(rain(basins({"A", "B"}), {}, step({{1.23456, 2, 1}, {none, 0, 0}})),
            "time,A,B\n\"t,1\",1.235,\n");
}

TEST(RainFile, decimals_are_as_asked_for) {
  RainFormat format;
  format.decimals = 0;
  EXPECT_EQ(rain(basins({"A"}), format, step({{2.6, 1, 1}})), "time,A\n\"t,1\",3\n");
}

TEST(RainFile, rows_for_basins_have_gauges_and_coverage_and_what_was_asked_for_more) {
  RainFormat format;
  format.rows_for_basins = true;
  format.patterns = true;
  format.errors = true;
  EXPECT_EQ(rain(basins({"A", "B"}), format, step({{1.5, 2, 0.75, 0.25}, {none, 0, 0, none}}), 7),
            "time,basin,rainfall,gauges,coverage,se,pattern\n"
            "\"t,1\",A,1.500,2,0.75,0.250,7\n"
            "\"t,1\",B,,0,0,,7\n");
}

TEST(RainFile, of_several_methods_each_has_a_column_in_their_order) {
  RainFormat format;
  format.methods = {"thiessen", "idw"};
  EXPECT_EQ(rain(basins({"A"}), format, step({{1, 1, 1}, {2, 1, 1}})),
            "time,A_thiessen,A_idw\n\"t,1\",1.000,2.000\n");
  format.rows_for_basins = true;
  EXPECT_EQ(rain(basins({"A"}), format, step({{1, 1, 1}, {2, 1, 1}})),
            "time,basin,method,rainfall,gauges,coverage\n"
            "\"t,1\",A,thiessen,1.000,1,1\n\"t,1\",A,idw,2.000,1,1\n");
}

TEST(RainFile, columns_of_errors_stand_behind_all_values_and_two_of_one_name_are_refused) {
  RainFormat format;
  format.errors = true;
  EXPECT_EQ(rain(basins({"A", "B"}), format, step({{1, 1, 1, 0.1}, {2, 1, 1, 0.2}})),
            "time,A,B,A_se,B_se\n\"t,1\",1.000,2.000,0.100,0.200\n");
  EXPECT_EQ(complaints_of([&] { rain(basins({"A", "A_se"}), format, step({})); }).size(), 1U);
}

}  // namespace
}  // namespace thiessen
