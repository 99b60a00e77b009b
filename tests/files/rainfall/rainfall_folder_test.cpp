#include "files/rainfall/rainfall_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/tables/netcdf_file.h"

namespace thiessen {
namespace {

using Names = std::vector<std::string>;

TEST(RainfallFolder, stands_for_its_files_of_a_format_that_is_read) {
  const TemporaryFolder folder;
  for (const char* name : {"2020.csv", "2019.csv.gz", "s.shp", "s.dbf", "t.dbf", "z.zip", ".x.csv"})
    folder.write(name, "");
  folder.write("about.pdf", "");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({"r.csv", folder.path(), "-"}, {}, warnings),
            (Names{"r.csv", folder.path("2019.csv.gz"), folder.path("2020.csv"),
                   folder.path("s.shp"), folder.path("t.dbf"), folder.path("z.zip"), "-"}));
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            folder.path() + ": about.pdf and s.dbf hold no readings, and are passed over");
}

TEST(RainfallFolder, of_dly_files_stands_for_itself) {
  const TemporaryFolder folder;
  folder.write("a.dly", "");
  folder.write("a.csv", "");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({folder.path()}, {}, warnings), Names{folder.path()});
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(
      warnings.notices()[0].sentence(),
      folder.path() + ": a.csv is passed over: of a folder with .dly files these alone are read");
}

TEST(RainfallFolder, without_a_file_of_readings_is_an_error) {
  const TemporaryFolder folder;
  Warnings warnings;
  EXPECT_TRUE(contains(complaint_of([&] { rainfall_files({folder.path()}, {}, warnings); }),
                       folder.path() + ": is a folder without a file of readings"));
}

TEST(RainfallFolder, passes_over_what_is_surely_no_table) {
  const TemporaryFolder folder;
  folder.write("2020.csv", "time,A\n2020-01-01,1\n");
  folder.write("2021.txt", "# daily\ntime;A\n2021-01-01;1,5\n");
  folder.write("readme.txt", "Rain of A, B and others\n\nMeasured, as it were, by hand.\n");
  folder.write("about.json", R"({"title": "Rain", "year": 2020})");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({folder.path()}, {}, warnings),
            (Names{folder.path("2020.csv"), folder.path("2021.txt")}));
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            folder.path() + ": about.json and readme.txt hold no readings, and are passed over");
}

constexpr const char* wide = "time,A\n2020-01-01,1\n";

/// The notices of looking into a folder, without its name.
Names notices_of(const TemporaryFolder& folder, const Names& beside, Names& files) {
  Warnings warnings;
  files = rainfall_files({folder.path()}, beside, warnings);
  Names notices;
  for (const Message& notice : warnings.notices())
    notices.push_back(notice.sentence().substr(folder.path().size() + 2));
  return notices;
}

TEST(RainfallFolder, leaves_out_the_files_of_stations_and_basins) {
  const TemporaryFolder folder;
  folder.write("r.csv", wide);
  folder.write("stations.csv", "id,x,y\nA,1,2\n");
  for (const char* name : {"b.shp", "b.dbf", "b.shx", "B.PRJ", "b.xml"}) folder.write(name, "");
  std::filesystem::create_symlink("stations.csv", folder.path("link.csv"));
  Names files;
  EXPECT_EQ(notices_of(folder, {folder.path("./stations.csv"), folder.path("b.shp")}, files),
            (Names{"b.dbf, b.shp, b.shx, link.csv and stations.csv are given as 'stations' or "
                   "'basins', and left out of its readings",
                   "B.PRJ and b.xml hold no readings, and are passed over"}));
  EXPECT_EQ(files, Names{folder.path("r.csv")});
}

TEST(RainfallFolder, keeps_a_table_of_readings_that_is_the_one_of_stations_too) {
  const TemporaryFolder folder;
  const std::string both = folder.write("r.csv", "station,x,y,date,rain\nA,1,2,2020-01-01,1\n");
  Names files;
  EXPECT_EQ(notices_of(folder, {both}, files), Names{});
  EXPECT_EQ(files, Names{both});
}

TEST(RainfallFolder, of_netcdfs_of_stations_keeps_the_one_that_stations_are_read_from) {
  const TemporaryFolder folder;
  const std::string both = NetcdfOfStations().write(folder.path("s.nc"));
  folder.write("grid.nc", "CDF\x01" + std::string(28, '\0'));
  Names files;
  EXPECT_EQ(notices_of(folder, {both}, files),
            Names{"grid.nc holds no readings, and is passed over"});
  EXPECT_EQ(files, Names{both});
}

TEST(RainfallFolder, names_the_folders_in_it) {
  const TemporaryFolder folder;
  folder.write("r.csv", wide);
  std::filesystem::create_directory(folder.path("2020"));
  std::filesystem::create_directory(folder.path(".git"));
  Names files;
  EXPECT_EQ(notices_of(folder, {}, files),
            Names{"its folder 2020 is passed over: of a folder the files count that lie right in "
                  "it"});
  std::filesystem::create_directory(folder.path("2021"));
  std::filesystem::remove(folder.path("r.csv"));
  EXPECT_EQ(complaint_of([&] { notices_of(folder, {}, files); }),
            folder.path() +
                ": is a folder without a file of readings, and what lies in folders in it does not "
                "count | name the folder that holds them");
}

TEST(RainfallFolder, passes_over_what_might_be_waited_for_and_archives_without_a_table) {
  const TemporaryFolder folder;
  folder.write("r.csv", wide);
  folder.write("x.pdf", "");
  ASSERT_EQ(::mkfifo(folder.path("pipe.csv").c_str(), 0600), 0);
  const std::string pack = "cd '" + folder.path() + "' && python3 -m zipfile -c x.zip x.pdf";
  ASSERT_EQ(std::system(pack.c_str()), 0);
  Names files;
  EXPECT_EQ(notices_of(folder, {}, files),
            Names{"pipe.csv, x.pdf and x.zip hold no readings, and are passed over"});
  EXPECT_EQ(files, Names{folder.path("r.csv")});
}

TEST(RainfallFolder, of_swat_plus_is_read_by_its_list) {
  const TemporaryFolder folder;
  for (const char* name : {"p1.pcp", "p2.pcp"})
    folder.write(name, "p: x\nnbyr tstep lat long elev\n1 0 35.0 -81.5 200\n2001 1 0.5\n");
  folder.write("t1.tmp", "t: x\nnbyr tstep lat long elev\n1 0 35.0 -81.5 200\n2001 1 0.5 2\n");
  folder.write("tmp.cli", "tmp.cli: x\nfilename\nt1.tmp\n");
  Names files;
  notices_of(folder, {}, files);
  EXPECT_EQ(files, (Names{folder.path("p1.pcp"), folder.path("p2.pcp")}));
  folder.write("pcp.cli", "pcp.cli: x\nfilename\np1.pcp\np2.pcp\n");
  EXPECT_EQ(notices_of(folder, {}, files),
            Names{"t1.tmp and tmp.cli hold no readings, and are passed over"});
  EXPECT_EQ(files, Names{folder.path("pcp.cli")});
}

TEST(RainfallFolder, of_arcswat_is_read_by_its_list_of_rain) {
  const TemporaryFolder folder;
  const std::string head = "ID,NAME,LAT,LONG,ELEVATION\n";
  folder.write("pa.txt", "20000228\n0.5\n");
  folder.write("sa.txt", "20000228\n12.5\n");
  folder.write("ta.txt", "20000228\n10.5,2.5\n");
  folder.write("tmp.txt", head + "1,ta,41,-93,9\n");
  Names files;
  notices_of(folder, {}, files);
  EXPECT_EQ(files, (Names{folder.path("pa.txt"), folder.path("sa.txt")}));
  folder.write("pcp.txt", head + "1,pa,41,-93,9\n");
  notices_of(folder, {}, files);
  EXPECT_EQ(files, (Names{folder.path("pcp.txt"), folder.path("sa.txt")}));
  folder.write("solar.txt", head + "1,sa,41,-93,9\n");
  EXPECT_EQ(notices_of(folder, {folder.path("pcp.txt")}, files),
            Names{"sa.txt, solar.txt, ta.txt and tmp.txt hold no readings, and are passed over"});
  EXPECT_EQ(files, Names{folder.path("pcp.txt")});
  std::filesystem::rename(folder.path("pcp.txt"), folder.path("gauges.txt"));
  EXPECT_EQ(complaint_of([&] { notices_of(folder, {}, files); }),
            folder.path() +
                ": is a folder with several lists of files, each of which may be of rain: "
                "gauges.txt and solar.txt | name one as 'rainfall'");
}

}  // namespace
}  // namespace thiessen
