// The rain of a NetCDF of stations.
#include "files/tables/netcdf_rainfall.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "files/tables/netcdf_file.h"

namespace thiessen {
namespace {

struct Outcome {
  std::vector<std::string> values;  ///< time by time, of `a` and of `b`
  std::vector<std::string> warnings;
};

Outcome read(const NetcdfOfStations& file) {
  const TemporaryFolder folder;
  Warnings warnings;
  NetcdfRainfall table(file.write(folder.path() + "/r.nc"), "pr", warnings);
  Outcome outcome;
  for (const auto& one : {table.again(), table.again()}) {
    outcome.values.clear();
    for (Row row; one->next(row);) outcome.values.emplace_back(row.fields[2]);
  }
  for (const Message& warning : warnings.messages())
    outcome.warnings.push_back(warning.text.plain());
  return outcome;
}

using Texts = std::vector<std::string>;

TEST(NetcdfRainfall, is_missing_outside_its_valid_range) {
  const Outcome range = read({.rain_attributes = {{"valid_range", {0, 9}}}});
  EXPECT_EQ(range.values, (Texts{"4", "8", "5", "9", "", ""}));
  EXPECT_EQ(range.warnings,
            Texts{"'pr', step 3 of station 'b', is 10, outside what its valid_range allows: taken "
                  "for missing"});
  const Outcome most = read({.rain_attributes = {{"valid_max", {8.5}}}});
  EXPECT_EQ(most.values, (Texts{"4", "8", "5", "", "", ""}));
  EXPECT_EQ(most.warnings,
            Texts{"'pr', step 2 of station 'b', is 9, outside what its valid_max allows, the first "
                  "of 2: taken for missing"});
  const Outcome least = read({.rain_attributes = {{"valid_min", {5}}}});
  EXPECT_EQ(least.values, (Texts{"", "8", "5", "9", "", "10"}));
  EXPECT_EQ(least.warnings.size(), 1U);
}

TEST(NetcdfRainfall, says_nothing_where_all_is_valid) {
  const Outcome outcome = read({.rain_attributes = {{"valid_min", {0}}, {"valid_max", {10}}}});
  EXPECT_EQ(outcome.values, (Texts{"4", "8", "5", "9", "", "10"}));
  EXPECT_EQ(outcome.warnings, Texts{});
}

// A range of a wider type than that of packed values is one of what these stand for.
TEST(NetcdfRainfall, has_a_range_of_amounts_or_of_what_is_stored) {
  NetcdfOfStations file;
  file.rain_type = NC_SHORT;
  file.rain = {40, 50, -999, 80, 90, 100};
  file.rain_attributes = {{"scale_factor", {0.1}}, {"valid_range", {0, 9}}};
  EXPECT_EQ(read(file).values, (Texts{"4", "8", "5", "9", "", ""}));
  file.rain_type = NC_FLOAT;
  file.rain_attributes["valid_range"] = {0, 90};
  EXPECT_EQ(read(file).values, (Texts{"4", "8", "5", "9", "", ""}));
}

}  // namespace
}  // namespace thiessen
