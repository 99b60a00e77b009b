#include "cli/outputs/cell_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

CellsOutput output_of(const GivenInputs& given, const GaugeReadings* readings) {
  const auto cells = cells_of(given.inputs, readings, 1);
  return cells_output(given.inputs, cells, readings, given.options(), "mm");
}

TEST(CellFeatures, are_the_cells_of_the_network_where_there_are_no_readings) {
  const GivenInputs given;
  const CellsOutput output = output_of(given, nullptr);
  ASSERT_EQ(output.cells.size(), 2U);
  const CellFeature& b = output.cells[1];
  EXPECT_EQ(b.station, "B");
  EXPECT_EQ(b.basin, "Q");
  EXPECT_NEAR(b.area, 24, 1e-12);  // of no known unit, so as it is
  EXPECT_NEAR(b.weight, 0.6, 1e-12);
  EXPECT_TRUE(std::isnan(b.rainfall));
  EXPECT_EQ(b.attribute_row, 1U);
  EXPECT_EQ(output.area_column, "area");
  EXPECT_FALSE(output.has_rainfall);
  EXPECT_EQ(output.rainfall_is, "");
  EXPECT_EQ(output.attributes, nullptr);
  EXPECT_FALSE(output.study_crs);
  EXPECT_FALSE(output.file_crs);
}

TEST(CellFeatures, are_those_of_the_gauges_that_report_with_what_they_say) {
  const GivenInputs given;
  const GaugeReadings readings{{silent, 12.5}, "2013-08-01"};
  const CellsOutput output = output_of(given, &readings);
  ASSERT_EQ(output.cells.size(), 1U);
  EXPECT_EQ(output.cells[0].station, "B");
  EXPECT_NEAR(output.cells[0].weight, 1, 1e-12);
  EXPECT_EQ(output.cells[0].rainfall, 12.5);
  EXPECT_TRUE(output.has_rainfall);
  EXPECT_EQ(output.rainfall_is, "2013-08-01");
  EXPECT_EQ(output.made_by->unit, "mm");
  EXPECT_EQ(cells_of_network(given.inputs, 1).at(0).size(), 2U);
}

TEST(CellFeatures, have_attributes_where_they_are_asked_for) {
  GivenFiles files;
  files.options.emplace_back("--attributes");
  const GivenInputs given(files);
  const CellsOutput output = output_of(given, nullptr);
  ASSERT_NE(output.attributes, nullptr);
  EXPECT_EQ(output.attributes->rows.at(output.cells[1].attribute_row).back(), "vale");
}

TEST(CellFeatures, have_square_kilometres_and_a_crs_where_these_are_known) {
  const GivenInputs given(files_in_utm());
  const CellsOutput output = output_of(given, nullptr);
  EXPECT_EQ(output.area_column, "area_km2");
  EXPECT_NEAR(output.cells.at(0).area + output.cells.at(1).area, 4, 1e-12);
  EXPECT_EQ(output.study_crs->name(), "EPSG:32633");
  EXPECT_EQ(output.file_crs->name(), "EPSG:32633");
}

TEST(CellFeatures, have_no_basin_where_there_are_none) {
  GivenFiles files;
  files.basins.clear();
  files.stations = "id,x,y\nA,0,0\nB,8,2\n";
  const GivenInputs given(files);
  EXPECT_FALSE(output_of(given, nullptr).cells.at(0).basin);
}

TEST(CellFeatures, in_a_planes_own_coordinates_are_warned_of) {
  Warnings warnings;
  const GivenInputs plane;
  warn_of_own_coordinates(plane.inputs, "c.geojson", warnings);
  warn_of_own_coordinates(plane.inputs, "-", warnings);
  const GivenInputs utm(files_in_utm());
  warn_of_own_coordinates(utm.inputs, "u.geojson", warnings);
  const std::string text = ": the cells are in the plane's own coordinates: no CRS is known";
  EXPECT_EQ(sentences_of(warnings),
            (std::vector<std::string>{"c.geojson" + text, "standard output" + text}));
}

}  // namespace
}  // namespace thiessen::cli
