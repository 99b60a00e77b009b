#include "files/cells_file.h"

#include <gtest/gtest.h>
#include <cmath>

#include <set>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/layers/layer.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

CellsOutput two_cells() {
  CellsOutput wanted;
  for (const double x : {15.0, 16.0}) {
    CellFeature cell;
    cell.station = x == 15 ? "007" : "\xC3\xA9t\xC3\xA9";
    cell.basin = "B";
    cell.area = 1 / x;
    cell.weight = 0.1;
    cell.shape = {{{{x, 50}, {x + 1, 50}, {x + 1, 51}, {x, 51}}, {}}};
    wanted.cells.push_back(cell);
  }
  wanted.study_crs = Crs::wgs84();
  wanted.file_crs = Crs::wgs84();
  return wanted;
}

std::vector<EncodedFile> files_of(const CellsOutput& output, const std::string& name) {
  Warnings warnings;
  return cells_files(output, name, warnings);
}

/// Writes the files where they belong and opens the first.
struct OnDisk {
  explicit OnDisk(const CellsOutput& output, const std::string& name) {
    for (const EncodedFile& file : cells_files(output, folder.path(name), warnings)) {
      names.push_back(file.name.substr(folder.path().size() + 1));
      folder.write(names.back(), file.bytes);
    }
  }
  TemporaryFolder folder;
  Warnings warnings;
  std::vector<std::string> names;
};

class Format : public testing::TestWithParam<const char*> {};

TEST_P(Format, comes_back_as_it_went) {
  const OnDisk disk(two_cells(), std::string("my cells.") + GetParam());
  ASSERT_EQ(disk.names.at(0), std::string("my cells.") + GetParam());
  Layer layer(disk.folder.path(disk.names[0]), "", "");
  Row row;
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.fields.at(0), "007");
  EXPECT_EQ(row.fields.at(1), "B");
  EXPECT_EQ(row.fields.at(2), "0.06666666666666667");
  EXPECT_EQ(row.fields.at(3), "0.1");
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.fields.at(0), "\xC3\xA9t\xC3\xA9");
  EXPECT_DOUBLE_EQ(std::abs(signed_area(layer.geometry().polygons.at(0).outer)), 1);
  EXPECT_FALSE(layer.next(row));
  EXPECT_TRUE(layer.crs()->is_wgs84());
}

INSTANTIATE_TEST_SUITE_P(CellsFile, Format, testing::Values("gpkg"));

TEST(CellsFile, a_flatgeobuf_has_its_cells_in_the_order_of_its_index) {
  const OnDisk disk(two_cells(), "c.fgb");
  Layer layer(disk.folder.path("c.fgb"), "", "");
  std::set<std::string> stations;
  for (Row row; layer.next(row);) stations.emplace(row.fields.at(0));
  EXPECT_EQ(stations, (std::set<std::string>{"007", "\xC3\xA9t\xC3\xA9"}));
}

TEST(CellsFile, a_field_that_the_format_renames_is_told_with_both_names) {
  CellsOutput wanted = two_cells();
  const Attributes attributes{{{"a_name_that_is_long", FieldType::text}}, {{"x"}, {"y"}}};
  wanted.attributes = &attributes;
  wanted.cells[1].attribute_row = 1;
  const OnDisk disk(wanted, "c.shp");
  ASSERT_EQ(disk.warnings.messages().size(), 1u);
  EXPECT_TRUE(contains(disk.warnings.messages()[0].sentence(),
                       "the field 'a_name_that_is_long' is called 'a_name_tha'"));
}

TEST(CellsFile, whole_numbers_and_letters_of_all_scripts_come_back_from_mapinfo) {
  CellsOutput wanted = two_cells();
  const Attributes attributes{{{"n", FieldType::integer}}, {{"7"}, {"-8"}}};
  wanted.attributes = &attributes;
  wanted.cells[1].attribute_row = 1;
  wanted.cells[1].station = "\xE6\x9D\xB1\xE4\xBA\xAC";
  for (const char* name : {"c.tab", "c.mif"}) EXPECT_NO_THROW(files_of(wanted, name)) << name;
  wanted.cells[1].station = std::string(300, 'x');
  for (const char* name : {"c.tab", "c.shp"})
    EXPECT_TRUE(contains(complaint_of([&] { files_of(wanted, name); }), "is cut to 254 of its 300"))
        << name << complaint_of([&] { files_of(wanted, name); });
}

TEST(CellsFile, a_shapefile_is_several_files) {
  const OnDisk disk(two_cells(), "c.shp");
  EXPECT_EQ(disk.names, (std::vector<std::string>{"c.shp", "c.cpg", "c.dbf", "c.prj", "c.shx"}));
  Layer layer(disk.folder.path("c.shp"), "", "");
  Row row;
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.fields.at(0), "007");
  EXPECT_EQ(row.fields.at(3), "0.1");
}

TEST(CellsFile, the_same_cells_make_the_same_bytes) {
  for (const char* name : {"c.gpkg", "c.shp", "c.fgb", "c.kml", "c.gml"}) {
    const auto first = files_of(two_cells(), name);
    const auto second = files_of(two_cells(), name);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_TRUE(first[i].bytes == second[i].bytes) << first[i].name;
  }
}

TEST(CellsFile, other_formats_are_in_the_files_crs) {
  CellsOutput wanted = two_cells();
  wanted.file_crs = Crs::from_text("EPSG:32633", setting("basins_crs"));
  const OnDisk disk(wanted, "c.gpkg");
  Layer layer(disk.folder.path("c.gpkg"), "", "");
  EXPECT_EQ(layer.crs()->name(), "EPSG:32633");
  Row row;
  ASSERT_TRUE(layer.next(row));
  // 15 degrees east is the zone's central meridian.
  EXPECT_NEAR(layer.geometry().polygons.at(0).outer.at(0).x, 500000, 1e-3);
}

TEST(CellsFile, kml_is_in_longitude_and_latitude) {
  CellsOutput wanted = two_cells();
  wanted.file_crs = Crs::from_text("EPSG:32633", setting("basins_crs"));
  EXPECT_TRUE(contains(files_of(wanted, "c.kml").at(0).bytes, "15,50"));
  wanted.study_crs.reset();
  EXPECT_TRUE(contains(complaint_of([&] { files_of(wanted, "c.kml"); }),
                       "c.kml: the format holds longitude"));
}

TEST(CellsFile, an_unknown_extension_lists_the_known_ones) {
  for (const char* name : {"c.xyz", "c", "a.b/c", "c."}) {
    const std::string complaint = complaint_of([&] { require_cells_format(name); });
    EXPECT_TRUE(contains(complaint, "cells are written to .geojson, .json, .gpkg, .shp"))
        << complaint;
  }
  EXPECT_NO_THROW(require_cells_format("c.GPKG"));
  EXPECT_NO_THROW(require_cells_format("c.geojson"));
}

TEST(CellsFile, a_text_too_long_for_the_format_is_an_error) {
  CellsOutput wanted = two_cells();
  wanted.cells[0].station = std::string(300, 'x');
  EXPECT_TRUE(contains(complaint_of([&] { files_of(wanted, "c.shp"); }), "c.shp: "));
  EXPECT_NO_THROW(files_of(wanted, "c.gpkg"));
}

}  // namespace
}  // namespace thiessen
