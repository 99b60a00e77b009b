#include "gdal/layers/opening.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/drivers.h"
#include "gdal/layers/layer.h"
#include "gdal/layers/xlsx_file.h"

namespace thiessen {
namespace {

TEST(Opening, the_extension_tells_a_csv_from_what_gdal_reads) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_by_gdal(folder.write("a.csv", "id,x,y\n")));
  EXPECT_FALSE(read_by_gdal(folder.write("a.TSV", "id\tx\ty\n")));
  EXPECT_TRUE(read_by_gdal(folder.write("a.geojson", "{}")));
  EXPECT_TRUE(read_by_gdal(folder.write("a.GPKG", "")));
  EXPECT_TRUE(read_by_gdal("PG:dbname=rain"));
}

TEST(Opening, the_first_bytes_tell_where_the_extension_does_not) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_by_gdal(folder.write("gauges", "id,x,y\n1,2,3\n")));
  EXPECT_TRUE(
      read_by_gdal(folder.write("basins", R"({"type":"FeatureCollection","features":[]})")));
}

TEST(Opening, a_missing_file_a_folder_and_an_unreadable_one_are_named_as_the_system_names_them) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_of([&] { read_by_gdal(folder.path("no.gpkg")); }),
            folder.path("no.gpkg") + ": No such file or directory");
  EXPECT_EQ(complaint_of([&] { read_by_gdal(folder.path()); }), folder.path() + ": Is a directory");
  EXPECT_TRUE(
      contains(complaint_of([&] { read_by_gdal(std::string(5000, 'a')); }), "File name too long"));
  EXPECT_TRUE(contains(complaint_of([] { read_by_gdal(""); }), "empty"));
  const std::string locked = folder.write("locked.geojson", "{}");
  chmod(locked.c_str(), 0);
  if (geteuid() != 0) {
    EXPECT_EQ(complaint_of([&] { read_by_gdal(locked); }), locked + ": Permission denied");
  }
}

TEST(Opening, a_text_or_a_page_under_the_name_of_a_spreadsheet_is_what_it_is) {
  const TemporaryFolder folder;
  for (const char* name : {"a.xls", "b.XLSX", "c.ods"}) {
    EXPECT_TRUE(find_opening(folder.write(name, "time\ta\n2020-01-01\t4\n")).drivers.empty())
        << name;
  }
  using namespace std::literals;
  EXPECT_TRUE(find_opening(folder.write("d.xls", "\xff\xfet\0\t\0"sv)).drivers.empty()) << "UTF-16";
  const std::string workbook = folder.write("e.xls", "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0"sv);
  EXPECT_EQ(std::string(find_opening(workbook).drivers.at(0)), "XLS");
  const std::string page = folder.write("f.xls", " <html><table></table></html>");
  EXPECT_EQ(complaint_of([&] { find_opening(page); }),
            page +
                ": is a page (HTML or XML) under the name of a spreadsheet | open it in a "
                "spreadsheet program, and save it as .xlsx or .csv");
}

TEST(Opening, a_workbook_is_one_under_the_name_of_the_older_kind_too) {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.xls");
  start_gdal();
  write_xlsx(file, {{"rain", ""}});
  EXPECT_EQ(std::string(find_opening(file).drivers.front()), "XLSX");
}

class Connection : public testing::TestWithParam<const char*> {};

TEST_P(Connection, is_refused) {
  const std::string complaint = complaint_of([] { read_by_gdal(GetParam()); });
  EXPECT_TRUE(contains(complaint, "read")) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    Opening, Connection,
    testing::Values("/vsicurl/http://127.0.0.1:9/a.geojson", "/vsis3/bucket/a.gpkg",
                    "/vsizip//vsicurl/http://127.0.0.1:9/a.zip",
                    "/vsizip/vsicurl/http://127.0.0.1:9/a.zip",
                    "/vsizip/{/vsicurl/http://127.0.0.1:9/a.zip}/b.shp", "/vsistdin/",
                    "/vsimem/a.geojson", "/vsisubfile/0_10,a.geojson",
                    "http://127.0.0.1:9/a.geojson", "https://127.0.0.1:9/", "ftp://127.0.0.1/a",
                    "WFS:http://127.0.0.1:9/", "MEM:::DATAPOINTER=1",
                    R"({"type":"Point","coordinates":[1,2]})", "GeoJSON:a"));

TEST(Opening, a_virtual_file_in_the_clothes_of_geojson_is_not_opened) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "a.geojson",
      "<OGRVRTDataSource><OGRVRTLayer name='a'><SrcDataSource>/etc/passwd</SrcDataSource>"
      "</OGRVRTLayer></OGRVRTDataSource>");
  EXPECT_TRUE(contains(complaint_of([&] { Layer(file, "", ""); }), "not whole JSON"));
}

TEST(Opening, an_archive_of_a_local_file_is_read) {
  const TemporaryFolder folder;
  folder.write("a.geojson", R"({"type":"Point","coordinates":[1,2]})");
  const std::string pack = "cd '" + folder.path() + "' && gzip -k a.geojson";
  ASSERT_EQ(std::system(pack.c_str()), 0);
  Layer layer("/vsigzip/" + folder.path("a.geojson.gz"), "", "");
  Row row;
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(layer.geometry().points.at(0), (Point{1, 2}));
}

TEST(Opening, a_zip_of_several_tables_has_them_all) {
  const TemporaryFolder folder;
  for (const char* name : {"a.csv", "b.txt", "c.pdf", "mimetype", "content.xml"})
    folder.write(name, "x");
  const auto zip = [&](const std::string& name, const std::string& files) {
    const std::string pack =
        "cd '" + folder.path() + "' && python3 -m zipfile -c " + name + " " + files;
    EXPECT_EQ(std::system(pack.c_str()), 0);
    return folder.path(name);
  };
  EXPECT_EQ(tables_in_zip(zip("a.zip", "a.csv b.txt c.pdf")),
            (std::vector<std::string>{"a.csv", "b.txt"}));
  EXPECT_TRUE(tables_in_zip(zip("b.zip", "a.csv mimetype content.xml")).empty()) << "a spreadsheet";
  EXPECT_TRUE(tables_in_zip(folder.path("a.csv")).empty());
  EXPECT_TRUE(tables_in_zip(folder.path("no.zip")).empty());
  EXPECT_TRUE(tables_in_zip("-").empty());
}

}  // namespace
}  // namespace thiessen
