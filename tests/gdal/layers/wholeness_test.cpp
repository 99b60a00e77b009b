#include "gdal/layers/wholeness.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/layers/layer.h"

namespace thiessen {
namespace {

/// Points a and b in a file of GDAL's making; its name in the folder.
std::string two_points(const TemporaryFolder& folder, const std::string& name) {
  folder.write("in.csv", "id,x,y\na,1,2\nb,3,4\n");
  const std::string command = "cd '" + folder.path() +
                              "' && ogr2ogr -oo X_POSSIBLE_NAMES=x -oo Y_POSSIBLE_NAMES=y " + name +
                              " in.csv >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return folder.path(name);
}

std::size_t rows_in(const std::string& file, Warnings* warnings = nullptr) {
  Layer layer(file, "", "", warnings);
  std::size_t count = 0;
  for (Row row; layer.next(row);) ++count;
  return count;
}

void patch(const TemporaryFolder& folder, const std::string& name, std::size_t at, char byte) {
  std::string bytes = folder.read(name);
  bytes.at(at) = byte;
  folder.write(name, bytes);
}

class Format : public testing::TestWithParam<const char*> {};

TEST_P(Format, law_1_a_whole_file_is_read_and_no_beginning_of_it) {
  const TemporaryFolder folder;
  const std::string name = std::string("a.") + GetParam();
  two_points(folder, name);
  EXPECT_EQ(rows_in(folder.path(name)), 2u);
  const std::string whole = folder.read(name);
  // The sign at the end of a .dbf may be lacking.
  const std::size_t step = std::max<std::size_t>(1, whole.size() / 200);
  for (std::size_t cut = 0; cut + 2 < whole.size(); cut += step) {
    folder.write(name, std::string_view(whole).substr(0, cut));
    EXPECT_THROW(rows_in(folder.path(name)), Error) << name << " cut at " << cut;
  }
}

INSTANTIATE_TEST_SUITE_P(Wholeness, Format,
                         testing::Values("fgb", "gpkg", "shp", "kml", "xlsx", "ods"));

TEST(Wholeness, a_shapefile_in_an_archive_is_looked_at_alike) {
  const TemporaryFolder folder;
  two_points(folder, "a.shp");
  const std::string shx = folder.read("a.shx");
  folder.write("a.shx", shx.substr(0, shx.size() - 8));
  ASSERT_EQ(std::system(("cd '" + folder.path() +
                         "' && python3 -m zipfile -c a.shz a.shp a.shx a.dbf"
                         " && cp a.shz a.zip")
                            .c_str()),
            0);
  for (const char* name : {"a.shz", "a.zip"}) {
    EXPECT_TRUE(contains(complaint_of([&] { rows_in(folder.path(name)); }),
                         "a.shx has 108 bytes, and its header declares 116"))
        << name;
  }
}

TEST(Wholeness, a_shapefile_without_a_dbf_is_odd) {
  const TemporaryFolder folder;
  const std::string file = two_points(folder, "a.shp");
  std::filesystem::remove(folder.path("a.dbf"));
  Layer layer(file, "", "");
  ASSERT_EQ(layer.oddities().size(), 1u);
  EXPECT_TRUE(contains(layer.oddities()[0], "no .dbf"));
}

TEST(Wholeness, deleted_records_are_not_missing) {
  const TemporaryFolder folder;
  const std::string file = two_points(folder, "a.shp");
  const std::size_t first_record = 32 + 3 * 32 + 1;
  patch(folder, "a.dbf", first_record, '*');
  EXPECT_EQ(rows_in(file), 1u);
}

TEST(Wholeness, a_geopackage_is_held_to_the_count_that_it_declares) {
  const TemporaryFolder folder;
  const std::string file = two_points(folder, "a.gpkg");
  ASSERT_EQ(
      std::system(
          ("sqlite3 '" + file + "' 'UPDATE gpkg_ogr_contents SET feature_count = 3'").c_str()),
      0);
  EXPECT_TRUE(
      contains(complaint_of([&] { rows_in(file); }), "it declares 3 features, and 2 can be read"));
}

}  // namespace
}  // namespace thiessen
