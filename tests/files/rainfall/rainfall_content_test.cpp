#include "files/rainfall/rainfall_content.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/tables/netcdf_file.h"

namespace thiessen {
namespace {

using namespace std::literals;

class RainfallContentTest : public testing::Test {
 protected:
  RainfallContent of(const std::string& name, std::string_view text) const {
    return rainfall_content(folder_.write(name, text));
  }

  TemporaryFolder folder_;
};

TEST_F(RainfallContentTest, of_a_known_format_or_a_long_table_is_readings) {
  const auto readings = RainfallContent::readings;
  EXPECT_EQ(of("p.txt", "STATIONS_ID;MESS_DATUM;QN_8;  R1;eor\n1;2024060107;3;0.4;eor\n"),
            readings);
  EXPECT_EQ(of("g.csv", "USC00000001,20200101,PRCP,40,,,7,0700\n"), readings);
  EXPECT_EQ(of("a.txt", "20000228\n0.5\n"), readings);
  EXPECT_EQ(of("l.csv", "station,lon,lat,date,rain_mm\nA,10,50,2020-01-01,4\n"), readings);
  EXPECT_EQ(of("v.txt", "agency_cd\tsite_no\tdatetime\t1_00045\n5s\t15s\t20d\t14n\n"), readings);
}

TEST_F(RainfallContentTest, of_a_netcdf_of_stations_is_readings) {
  EXPECT_EQ(rainfall_content(NetcdfOfStations().write(folder_.path("s.nc"))),
            RainfallContent::readings);
}

TEST_F(RainfallContentTest, of_any_other_table_is_unknown) {
  const auto unknown = RainfallContent::unknown;
  EXPECT_EQ(of("w.csv", "time,A,B\n2020-01-01,4,8\n"), unknown);
  EXPECT_EQ(of("s.csv", "id,lon,lat\nA,10,50\n"), unknown);
  EXPECT_EQ(of("u.csv", "\xFF\xFEt\0,\0A\0\n\0"s + "2\0,\0001\0\n\0"s), unknown);
  EXPECT_EQ(of("e.csv", ""), unknown);
  EXPECT_EQ(rainfall_content(folder_.path("no.csv")), unknown);
}

TEST_F(RainfallContentTest, of_what_is_told_is_none) {
  const auto none = RainfallContent::none;
  EXPECT_EQ(of("r.txt", "Rain of A, B and others\n\nMeasured by hand.\n"), none);
  EXPECT_EQ(of("m.json", R"({"title": "Rain"})"), none);
  EXPECT_EQ(of("ghcnd-stations.txt",
               "USC00050848  40.0000 -105.5000 1671.5 CO BOULDER                                 \n"
               "USC00050849  40.0000 -105.0000 1671.5 CO BOULDER 2                               "
               "\n"),
            none);
}

TEST_F(RainfallContentTest, of_a_list_of_files_are_these) {
  folder_.write("p1.txt", "20000228\n0.5\n");
  const std::string list = folder_.write("pcp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,p1,41,-93,9\n");
  EXPECT_EQ(files_listed_in(list), std::vector<std::string>{folder_.path("p1.txt")});
  EXPECT_FALSE(lists_no_rain(list));
  folder_.write("t1.txt", "20000228\n10.5,2.1\n");
  const std::string other = folder_.write("tmp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,t1,41,-93,9\n");
  EXPECT_TRUE(lists_no_rain(other));
  EXPECT_EQ(files_listed_in(folder_.write("a.csv", "time,A\n1,2\n")), std::vector<std::string>{});
  const std::string plus = folder_.write("pcp.cli", "pcp.cli: x\nfilename\np1.pcp\np2.pcp\n");
  EXPECT_EQ(files_listed_in(plus),
            (std::vector<std::string>{folder_.path("p1.pcp"), folder_.path("p2.pcp")}));
}

}  // namespace
}  // namespace thiessen
