#include "gdal/output/layer_styles.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gdal/output/study_layers.h"
#include "gdal/sqlite_rows.h"

namespace thiessen {
namespace {

/// A GeoPackage with an empty layer of gauges.
std::string gauges(std::string older = {}) {
  StudyLayers layers;
  layers.area_column = "area";
  Warnings warnings;
  return with_study_layers(std::move(older), layers, "x.gpkg", warnings);
}

std::vector<std::string> styles_in(const std::string& geopackage) {
  return sqlite_rows(geopackage,
                     "SELECT f_table_name, f_geometry_column, styleQML, useAsDefault, update_time "
                     "FROM layer_styles ORDER BY f_table_name, styleQML");
}

TEST(LayerStyles, are_where_qgis_looks_for_them) {
  const std::vector<LayerStyle> styles{{"gauges", "<qgis/>"}};
  EXPECT_EQ(styles_in(with_layer_styles(gauges(), styles, "x.gpkg")),
            (std::vector<std::string>{"gauges|geom|<qgis/>|1|1970/01/01 00:00:00+00"}));
}

TEST(LayerStyles, replace_those_of_their_layer_and_leave_the_others) {
  const std::vector<LayerStyle> both{{"gauges", "old"}, {"basins", "theirs"}};
  const std::vector<LayerStyle> one{{"gauges", "new"}};
  const std::string once = with_layer_styles(gauges(), both, "x.gpkg");
  EXPECT_EQ(styles_in(with_layer_styles(once, one, "x.gpkg")),
            (std::vector<std::string>{"basins|geom|theirs|1|1970/01/01 00:00:00+00",
                                      "gauges|geom|new|1|1970/01/01 00:00:00+00"}));
}

TEST(LayerStyles, the_same_styles_make_the_same_bytes) {
  const std::vector<LayerStyle> styles{{"gauges", "<qgis/>"}};
  EXPECT_EQ(with_layer_styles(gauges(), styles, "x.gpkg"),
            with_layer_styles(gauges(), styles, "x.gpkg"));
}

TEST(LayerStyles, of_a_layer_that_is_not_there_are_refused) {
  const std::vector<LayerStyle> styles{{"rivers", "<qgis/>"}};
  EXPECT_THROW(with_layer_styles(gauges(), styles, "x.gpkg"), Error);
}

}  // namespace
}  // namespace thiessen
