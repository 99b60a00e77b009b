#include "gdal/output/vector_layer.h"

#include <gtest/gtest.h>
#include <ogr_geometry.h>

#include "base/program_output.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

/// A layer of two rows, with a text and a number each.
VectorLayer layer_of(const std::string& name, VectorLayer::Shapes shapes) {
  VectorLayer layer;
  layer.name = name;
  layer.shapes = shapes;
  layer.fields = {{"basin", FieldType::text}, {"rainfall", FieldType::real}};
  layer.own_fields = 2;
  layer.values.rows = 2;
  layer.values.names = {"basin", "rainfall"};
  layer.values.text = [](std::size_t row, std::size_t field) {
    return std::string(field == 0 ? row == 0 ? "Tőke" : "B" : "");
  };
  layer.values.number = [](std::size_t row, std::size_t field) {
    return field == 1 ? std::optional(1.5 + static_cast<double>(row)) : std::nullopt;
  };
  layer.shape = [shapes](std::size_t) -> std::unique_ptr<OGRGeometry> {
    OGRGeometry* shape = nullptr;
    OGRGeometryFactory::createFromWkt(shapes == VectorLayer::Shapes::lines
                                          ? "MULTILINESTRING ((0 0,1 1))"
                                          : "MULTIPOLYGON (((0 0,1 0,1 1,0 0)))",
                                      nullptr, &shape);
    return std::unique_ptr<OGRGeometry>(shape);
  };
  Provenance made_by;
  made_by.software = "thiessen 0";
  made_by.metric = "planar";
  layer.made_by = made_by;
  return layer;
}

std::vector<EncodedFile> written(const VectorLayer& layer, const std::string& path,
                                 const std::string& older = "") {
  Warnings warnings;
  return write_vector_layer(layer, std::nullopt, path, older, warnings);
}

TEST(VectorLayer, of_lines_has_the_options_of_each_driver_as_polygons_have_them) {
  TemporaryFolder folder;
  for (const char* extension : {"shp", "tab", "sqlite", "fgb", "gpkg", "csv", "geojson"}) {
    const std::string path = folder.path(std::string("lines.") + extension);
    for (const EncodedFile& file : written(layer_of("lines", VectorLayer::Shapes::lines), path))
      folder.write(file.name.substr(folder.path().size() + 1), file.bytes);
    const std::string info = program_output("ogrinfo -ro -al '" + path + "' 2>&1");
    EXPECT_NE(info.find("Feature Count: 2"), std::string::npos) << extension << info;
    EXPECT_NE(info.find("Tőke"), std::string::npos) << extension << info;
    EXPECT_NE(info.find("2.5"), std::string::npos) << extension << info;
  }
}

// -1 is the GeoPackage's own number for an undefined plane, 0 for undefined degrees.
TEST(VectorLayer, of_a_plane_is_no_geopackage_of_degrees) {
  TemporaryFolder folder;
  folder.write("l.gpkg", written(layer_of("l", VectorLayer::Shapes::lines), "l.gpkg")[0].bytes);
  const std::string ids =
      program_output("ogrinfo -ro -q -sql 'SELECT srs_id FROM gpkg_contents' '" +
                     folder.path("l.gpkg") + "' 2>&1");
  EXPECT_NE(ids.find("= -1"), std::string::npos) << ids;
}

TEST(VectorLayer, of_the_same_values_is_the_same_bytes) {
  for (const char* path : {"l.gpkg", "l.shp", "l.sqlite", "l.sql"}) {
    const auto first = written(layer_of("l", VectorLayer::Shapes::polygons), path);
    const auto again = written(layer_of("l", VectorLayer::Shapes::polygons), path);
    ASSERT_EQ(first.size(), again.size());
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_EQ(first[i].bytes, again[i].bytes) << path;
  }
}

TEST(VectorLayer, replaces_its_own_layer_of_a_geopackage_and_keeps_the_others) {
  TemporaryFolder folder;
  const std::string cells =
      written(layer_of("cells", VectorLayer::Shapes::polygons), "s.gpkg")[0].bytes;
  const std::string both =
      written(layer_of("isohyets", VectorLayer::Shapes::lines), "s.gpkg", cells)[0].bytes;
  const std::string again =
      written(layer_of("isohyets", VectorLayer::Shapes::lines), "s.gpkg", both)[0].bytes;
  folder.write("s.gpkg", again);
  const std::string info = program_output("ogrinfo -ro '" + folder.path("s.gpkg") + "' 2>&1");
  EXPECT_NE(info.find("1: cells (Multi Polygon)"), std::string::npos) << info;
  EXPECT_NE(info.find("2: isohyets (Multi Line String)"), std::string::npos) << info;
  EXPECT_EQ(info.find("3: "), std::string::npos) << info;
}

TEST(VectorLayer, is_proved_when_it_is_written) {
  VectorLayer layer = layer_of("l", VectorLayer::Shapes::lines);
  std::string asked;
  layer.prove = [&](const std::string&, const std::string& driver) { asked = driver; };
  written(layer, "l.fgb");
  EXPECT_EQ(asked, "FlatGeobuf");
}

}  // namespace
}  // namespace thiessen
