#include "gdal/output/study_layers.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "gdal/sqlite_rows.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

StudyLayers two_basins() {
  StudyLayers layers;
  layers.area_column = "area";
  layers.has_rainfall = true;
  layers.gauges = {{"a", {1, 2}, 0.5}, {"b", {3, 4}, none}};
  layers.basin_shapes = {{Polygon{{{{0, 0}, {2, 0}, {0, 2}}}, {}}},
                         {Polygon{{{{2, 0}, {2, 2}, {0, 2}}}, {}}}};
  BasinSummary one;
  one.basin = "P";
  one.area = 2;
  one.gauges_inside = 1;
  one.gauges_weighing = 2;
  one.largest_weight = 0.75;
  one.mean = 0.25;
  one.largest = 1;
  BasinSummary two;
  two.basin = "Q";
  two.area = 2;
  two.empty_steps = 2;
  layers.basins = {one, two};
  layers.weights = {{"P", "a", 1.5, 0.75}, {"P", "b", 0.5, 0.25}, {"Q", "b", 2, 1}};
  return layers;
}

std::string written(const StudyLayers& layers, std::string older = {}) {
  Warnings warnings;
  return with_study_layers(std::move(older), layers, "study.gpkg", warnings);
}

TEST(StudyLayers, gauges_are_points_and_have_no_rainfall_where_they_are_silent) {
  EXPECT_EQ(sqlite_rows(written(two_basins()), "SELECT station, rainfall, geom FROM gauges"),
            (Rows{"a|0.5|POINT (1 2)", "b|-|POINT (3 4)"}));
}

TEST(StudyLayers, basins_have_their_area_and_of_a_series_what_it_comes_to) {
  StudyLayers layers = two_basins();
  EXPECT_EQ(sqlite_rows(written(layers), "SELECT * FROM basins WHERE basin = 'P'"),
            (Rows{"P|2|MULTIPOLYGON (((0 0,2 0,0 2,0 0)))"}));
  layers.has_series = true;
  EXPECT_EQ(sqlite_rows(written(layers),
                        "SELECT basin, gauges_inside, gauges_weighing, largest_weight, mean, "
                        "standard_error, largest, empty_steps FROM basins"),
            (Rows{"P|1|2|0.75|0.25|-|1|0", "Q|0|0|0|-|-|-|2"}));
}

TEST(StudyLayers, weights_and_a_series_are_tables_of_rows) {
  StudyLayers layers = two_basins();
  layers.rain = StudyLayers::Rain{{"2020-01", "2020-02"}, {0.5, none, 0.25, 1}};
  const std::string bytes = written(layers);
  EXPECT_EQ(sqlite_rows(bytes, "SELECT basin, station, area, weight FROM weights"),
            (Rows{"P|a|1.5|0.75", "P|b|0.5|0.25", "Q|b|2|1"}));
  EXPECT_EQ(sqlite_rows(bytes, "SELECT time, basin, rainfall FROM rain"),
            (Rows{"2020-01|P|0.5", "2020-01|Q|-", "2020-02|P|0.25", "2020-02|Q|1"}));
  EXPECT_EQ(
      sqlite_rows(bytes, "SELECT table_name, data_type FROM gpkg_contents ORDER BY table_name"),
      (Rows{"basins|features", "gauges|features", "layer_styles|attributes", "rain|attributes",
            "weights|attributes"}));
}

TEST(StudyLayers, are_put_in_the_place_of_those_that_are_there) {
  StudyLayers layers = two_basins();
  const std::string older = written(layers);
  layers.gauges.resize(1);
  EXPECT_EQ(sqlite_rows(written(layers, older), "SELECT count(*) FROM gauges"), Rows{"1"});
  EXPECT_EQ(written(layers), written(layers)) << "the same study makes the same bytes";
}

TEST(StudyLayers, isohyets_are_there_where_they_were_drawn_though_there_be_none) {
  StudyLayers layers = two_basins();
  layers.made_by.emplace().software = "thiessen";
  layers.isohyets = {Isohyet{5, 1, {{{0, 0}, {1, 1}}}}};
  EXPECT_EQ(sqlite_rows(written(layers), "SELECT basin, rainfall, geom FROM isohyets"),
            (Rows{"Q|5|MULTILINESTRING ((0 0,1 1))"}));
  layers.isohyets = std::vector<Isohyet>();
  EXPECT_EQ(sqlite_rows(written(layers), "SELECT count(*) FROM isohyets"), Rows{"0"});
}

TEST(StudyLayers, of_degrees_basins_are_cut_at_the_antimeridian) {
  StudyLayers layers = two_basins();
  layers.basin_shapes[0] = {Polygon{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}};
  EXPECT_EQ(sqlite_rows(written(layers), "SELECT geom FROM basins WHERE basin = 'P'"),
            (Rows{"|MULTIPOLYGON (((170 0,190 0,190 10,170 10,170 0)))"}))
      << "of a plane they stay";
  layers.crs = Crs::wgs84();
  EXPECT_EQ(sqlite_rows(written(layers),
                        "SELECT MIN(minx) >= -180 AND MAX(maxx) <= 180 FROM rtree_basins_geom"),
            Rows{"1"});
}

}  // namespace
}  // namespace thiessen
