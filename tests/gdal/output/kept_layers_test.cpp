#include "gdal/output/kept_layers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gdal/output/study_layers.h"
#include "gdal/output/vector_layer.h"
#include "gdal/sqlite_rows.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::string>;

const std::vector<std::string> ours{"gauges", "isohyets"};
const std::vector<std::string> written{"gauges"};
constexpr const char* names_of_layers =
    "SELECT table_name FROM gpkg_contents WHERE table_name <> 'layer_styles' ORDER BY table_name";

/// Adds a layer without rows to a GeoPackage.
std::string with_layer(const std::string& name, const std::string& software, std::string older) {
  VectorLayer layer;
  layer.name = name;
  layer.shapes = VectorLayer::Shapes::none;
  layer.fields = {{"a", FieldType::text}};
  layer.values.names = {"a"};
  layer.made_by.emplace().software = software;
  Warnings warnings;
  return write_vector_layer(layer, {}, "s.gpkg", older, warnings).front().bytes;
}

TEST(KeptLayers, are_those_of_others) {
  std::string older = with_layer("mine", "", {});
  older = with_layer("gauges", "somebody's", older);
  older = with_layer("isohyets", "thiessen 0.1.0", older);
  Warnings warnings;
  const std::string kept = kept_layers(older, ours, written, "s.gpkg", warnings);
  EXPECT_EQ(sqlite_rows(kept, names_of_layers), Rows{"mine"});
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            "s.gpkg: layers of an older study that this one does not have are removed: 'isohyets'");
}

TEST(KeptLayers, may_have_a_name_of_ours_that_is_not_written) {
  const std::string older = with_layer("isohyets", "somebody's", {});
  Warnings warnings;
  EXPECT_EQ(sqlite_rows(kept_layers(older, ours, written, "s.gpkg", warnings), names_of_layers),
            Rows{"isohyets"});
  EXPECT_TRUE(warnings.notices().empty());
}

TEST(KeptLayers, of_a_study_alone_are_no_file) {
  Warnings warnings;
  EXPECT_EQ(kept_layers(with_layer("gauges", "thiessen", {}), ours, written, "s.gpkg", warnings),
            "");
  EXPECT_EQ(kept_layers("", ours, written, "s.gpkg", warnings), "");
}

}  // namespace
}  // namespace thiessen
