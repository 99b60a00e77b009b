#include "gdal/layers/archive.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Names = std::vector<std::string>;

std::string data_set(const Names& names) {
  return data_set_in_archive("a.zip", names);
}

TEST(Archive, law_1_one_file_of_a_format_that_is_read_is_its_data_set) {
  EXPECT_EQ(data_set({"stations.csv"}), "stations.csv");
  EXPECT_EQ(data_set({"licence.pdf", "data/Basins.GeoJSON", "style.qml"}), "data/Basins.GeoJSON");
  EXPECT_EQ(data_set({"b.kmz", "b"}), "b.kmz");
}

TEST(Archive, the_files_beside_a_shapefile_are_parts_of_it) {
  EXPECT_EQ(data_set({"a.cpg", "a.dbf", "a.prj", "a.shp", "a.shx"}), "a.shp");
  EXPECT_EQ(data_set({"in/A.DBF", "in/A.SHP", "in/A.SHX"}), "in/A.SHP");
  EXPECT_EQ(data_set({"a.dbf", "a.shp", "A.DBF"}), "a.shp");
  EXPECT_EQ(data_set({"a.dbf", "readme.pdf"}), "a.dbf") << "alone it is a table";
}

TEST(Archive, a_table_beside_another_shapefile_is_a_data_set_of_its_own) {
  for (const char* table : {"b.dbf", "other/a.dbf"}) {
    EXPECT_EQ(complaint_of([&] {
                data_set({"a.shp", "a.shx", "a.dbf", table});
              }),
              "a.zip: a zip archive of several data sets: 'a.shp', '" + std::string(table) +
                  "' | name one as /vsizip/a.zip/a.shp");
  }
}

TEST(Archive, a_text_counts_only_where_it_is_alone) {
  EXPECT_EQ(data_set({"readme.txt", "data.csv"}), "data.csv");
  EXPECT_EQ(data_set({"produkt_nieder.TXT", "notes.html"}), "produkt_nieder.TXT");
  EXPECT_TRUE(contains(complaint_of([] {
                         data_set({"a.txt", "b.txt"});
                       }),
                       "several data sets: 'a.txt', 'b.txt'"));
}

TEST(Archive, its_tables_are_all_that_may_be_data_texts_too) {
  EXPECT_EQ(tables_in_archive({"a.TXT", "b.pdf", "c.csv", "s.shp", "s.dbf", "t.dbf", ".d.csv"}),
            (Names{"a.TXT", "c.csv", "s.shp", "t.dbf"}));
  EXPECT_EQ(tables_in_archive({"b.pdf"}), Names{});
}

TEST(Archive, its_files_are_named_as_gdal_and_a_shell_want_them) {
  EXPECT_EQ(path_in_archive("in/A.ZIP", "d/b.csv"), "/vsizip/in/A.ZIP/d/b.csv");
  EXPECT_EQ(path_in_archive("rain", "b.csv"), "/vsizip/{rain}/b.csv");
  EXPECT_EQ(path_in_archive_quoted("a.zip", "b.csv"), "/vsizip/a.zip/b.csv");
  EXPECT_EQ(path_in_archive_quoted("a.zip", "b 1.csv"), "'/vsizip/a.zip/b 1.csv'");
  EXPECT_EQ(path_in_archive_quoted("rain", "b.csv"), "'/vsizip/{rain}/b.csv'");
}

TEST(Archive, what_its_maker_s_machine_left_in_it_does_not_count) {
  EXPECT_EQ(data_set({"a.csv", "__MACOSX/._a.csv", ".hidden.csv", "in/.b.csv"}), "a.csv");
  EXPECT_TRUE(contains(complaint_of([] { data_set({"__MACOSX/a.csv"}); }), "without a data set"));
}

TEST(Archive, without_a_data_set_says_what_it_holds_and_what_is_read) {
  EXPECT_EQ(complaint_of([] {
              data_set({"a.pdf", "b.tif"});
            }),
            "a.zip: a zip archive without a data set that is read: 'a.pdf', 'b.tif' | read are "
            "CSV, GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML and spreadsheets");
}

TEST(Archive, names_ten_of_many_and_how_many_more) {
  Names names;
  for (char letter = 'a'; letter <= 'l'; ++letter) names.push_back(std::string(1, letter) + ".csv");
  const std::string complaint = complaint_of([&] { data_set(names); });
  EXPECT_TRUE(contains(complaint, "'i.csv', 'j.csv' and 2 more")) << complaint;
  EXPECT_FALSE(contains(complaint, "k.csv"));
}

/// Makes an archive of these files by another program, in this order.
std::string packed(const TemporaryFolder& folder, const Names& names) {
  std::string list;
  for (const std::string& name : names) {
    const std::string folder_of = name.substr(0, name.rfind('/') + 1);
    if (!folder_of.empty()) std::filesystem::create_directories(folder.path(folder_of));
    folder.write(name, name);
    list += " '" + name + "'";
  }
  const std::string pack =
      "cd '" + folder.path() +
      "' && python3 -c \"import sys, zipfile\nwith zipfile.ZipFile('a.zip', 'w') as archive:\n "
      "for name in sys.argv[1:]: archive.write(name)\"" +
      list;
  EXPECT_EQ(std::system(pack.c_str()), 0);
  return folder.path("a.zip");
}

TEST(Archive, has_its_files_in_its_order_and_no_folders) {
  const TemporaryFolder folder;
  EXPECT_EQ(files_in_archive("a.zip", packed(folder, {"b.csv", "in/c.csv", "a.csv"})),
            (Names{"b.csv", "in/c.csv", "a.csv"}));
}

// Two files of 2^63 bytes each, as they state: together more than a number of 64 bits holds.
TEST(Archive, sizes_that_add_up_to_more_than_a_number_holds_are_no_small_size) {
  const TemporaryFolder folder;
  const std::string pack = "cd '" + folder.path() +
                           "' && python3 -c \"import zipfile\n"
                           "with zipfile.ZipFile('a.zip', 'w') as archive:\n"
                           " archive.writestr('a', 'a')\n archive.writestr('b', 'b')\n"
                           " for entry in archive.filelist: entry.file_size = 1 << 63\"";
  ASSERT_EQ(std::system(pack.c_str()), 0);
  EXPECT_EQ(unpacked_size("a.zip", folder.path("a.zip")),
            std::numeric_limits<std::uint64_t>::max());
}

// The list of the files stands at the end, and behind it where it begins. GDAL finds it without
// some of the last bytes.
TEST(Archive, law_2_no_beginning_of_an_archive_is_one_that_holds_less) {
  const TemporaryFolder folder;
  const Names names = files_in_archive("a.zip", packed(folder, {"a.csv", "b.csv"}));
  const std::string whole = folder.read("a.zip");
  std::size_t refused = 0;
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    const std::string part = folder.write("cut" + std::to_string(cut), whole.substr(0, cut));
    try {
      EXPECT_EQ(files_in_archive("rain.zip", part), names) << cut;
    } catch (const Error& error) {
      ++refused;
      EXPECT_TRUE(contains(error.what(), "rain.zip: no whole zip archive")) << error.what();
    }
  }
  constexpr std::size_t end_bytes = 10;  // how long the list is and where it begins, and a comment
  EXPECT_GE(refused, whole.size() - end_bytes);
}

TEST(Archive, that_is_empty_or_no_archive_is_an_error) {
  const TemporaryFolder folder;
  const std::string empty =
      folder.write("empty.zip", std::string("PK\x05\x06", 4) + std::string(18, '\0'));
  EXPECT_TRUE(contains(complaint_of([&] { files_in_archive("a.zip", empty); }),
                       "no whole zip archive, or an empty one"));
  const std::string text = folder.write("text.zip", "id,x,y\na,1,2\n");
  EXPECT_TRUE(contains(complaint_of([&] { files_in_archive("a.zip", text); }),
                       "a.zip: no whole zip archive"));
}

}  // namespace
}  // namespace thiessen
