// The spatial index of a GeoPackage, by SQLite's own check of it and by what it finds.
#include "gdal/output/spatial_index.h"

#include <gtest/gtest.h>
#include <ogr_geometry.h>

#include <memory>
#include <string>
#include <vector>

#include "gdal/output/vector_layer.h"
#include "gdal/sqlite_rows.h"

namespace thiessen {
namespace {

/// A GeoPackage with rows of one point each along a line that winds; every tenth has no shape.
std::string points(std::size_t rows, const std::string& name = "it's \"points\"") {
  VectorLayer layer;
  layer.name = name;
  layer.shapes = VectorLayer::Shapes::points;
  layer.fields = {{"number", FieldType::integer}};
  layer.own_fields = 1;
  layer.values.rows = rows;
  layer.values.names = {"number"};
  layer.values.text = [](std::size_t row, std::size_t) { return std::to_string(row); };
  layer.values.number = [](std::size_t, std::size_t) { return std::nullopt; };
  layer.shape = [](std::size_t row) -> std::unique_ptr<OGRGeometry> {
    if (row % 10 == 9) return nullptr;
    const auto at = static_cast<double>(row);
    return std::make_unique<OGRPoint>(0.1 * at, -0.1 * static_cast<double>(row * 37 % 100));
  };
  Warnings warnings;
  return write_vector_layer(layer, std::nullopt, "p.gpkg", "", warnings).front().bytes;
}

using Rows = std::vector<std::string>;

// A node holds 51 entries, so that there are trees of one node, of two levels and of three.
TEST(SpatialIndex, is_one_that_SQLite_finds_no_fault_in) {
  for (const std::size_t rows : {0U, 1U, 9U, 56U, 57U, 58U, 3000U}) {
    const std::string bytes = points(rows);
    EXPECT_EQ(sqlite_rows(bytes, "SELECT rtreecheck('rtree_it''s \"points\"_geom')"), Rows{"ok"});
    EXPECT_EQ(sqlite_rows(bytes, "PRAGMA integrity_check"), Rows{"ok"});
    EXPECT_EQ(sqlite_rows(bytes, "SELECT count(*) FROM \"rtree_it's \"\"points\"\"_geom\""),
              Rows{std::to_string(rows - rows / 10)});
  }
}

// Bytes are no letters: of this name there are fewer letters.
TEST(SpatialIndex, of_a_layer_whose_name_has_letters_of_several_bytes_has_no_fault_either) {
  const std::string bytes = points(3000, "Fl\u00fcsse");
  EXPECT_EQ(sqlite_rows(bytes, "SELECT rtreecheck('rtree_Fl\u00fcsse_geom')"), Rows{"ok"});
  EXPECT_EQ(sqlite_rows(bytes, "SELECT count(*) FROM \"rtree_Fl\u00fcsse_geom\""), Rows{"2700"});
}

TEST(SpatialIndex, finds_what_lies_in_a_box) {
  EXPECT_EQ(
      sqlite_rows(points(3000),
                  "SELECT id FROM \"rtree_it's \"\"points\"\"_geom\" WHERE minx <= 100.25 AND "
                  "maxx >= 99.95 AND miny <= 0 AND maxy >= -7.45 ORDER BY id"),
      (Rows{"1001", "1002", "1003"}));
}

// Of points that no float is equal to, the box holds the double.
TEST(SpatialIndex, has_boxes_that_hold_their_shapes) {
  EXPECT_EQ(
      sqlite_rows(points(3000),
                  "SELECT count(*) FROM \"rtree_it's \"\"points\"\"_geom\" WHERE minx <= (id - "
                  "1) * 0.1 AND maxx >= (id - 1) * 0.1 AND maxx - minx < 1e-4"),
      Rows{"2700"});
}

TEST(SpatialIndex, is_kept_true_by_triggers_and_known_as_an_extension) {
  const std::string bytes = points(60);
  EXPECT_EQ(sqlite_rows(bytes,
                        "SELECT count(*) > 5 FROM sqlite_master WHERE type = 'trigger' AND "
                        "substr(name, 1, 6) = 'rtree_'"),
            Rows{"1"});
  EXPECT_EQ(sqlite_rows(bytes, "SELECT extension_name FROM gpkg_extensions"),
            Rows{"gpkg_rtree_index"});
}

}  // namespace
}  // namespace thiessen
