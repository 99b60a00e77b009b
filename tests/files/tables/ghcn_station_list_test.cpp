#include "files/tables/ghcn_station_list.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

// Columns as section IV of the readme.txt of GHCN-Daily gives them; the lines are made up.
constexpr const char* lines =
    "XX000000001  40.0339 -105.2811 1641.0 CO BOULDER SPRINGS                    HCN 72469\n"
    "XXE00147708 -36.7200    4.0500 -999.9    TIZI                           GSN     60395\n";

std::vector<std::vector<std::string>> rows_of(GhcnStationList& list) {
  std::vector<std::vector<std::string>> rows;
  for (Row row; list.next(row);) rows.emplace_back(row.fields.begin(), row.fields.end());
  return rows;
}

TEST(GhcnStationList, is_known_by_its_first_line) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_ghcn_station_list(folder.write("a.txt", lines)));
  for (const char* other :
       {"id,lon,lat\n", "", "XX000000001 140.0339 -105.2811\n", "XX000000001  40.0339 -205.2811\n",
        "xx000000001  40.0339 -105.2811\n", "XX000000001,  40.0339 -105.2811\n"})
    EXPECT_FALSE(is_ghcn_station_list(folder.write("b.txt", other))) << other;
  EXPECT_FALSE(is_ghcn_station_list(folder.path() + "/none"));
}

TEST(GhcnStationList, is_a_table_of_columns) {
  const TemporaryFolder folder;
  GhcnStationList list(folder.write("a.txt", lines));
  EXPECT_EQ(list.header(),
            (std::vector<std::string>{"id", "latitude", "longitude", "elevation", "state", "name",
                                      "gsn_flag", "hcn_crn_flag", "wmo_id"}));
  EXPECT_EQ(rows_of(list),
            (std::vector<std::vector<std::string>>{
                {"XX000000001", "40.0339", "-105.2811", "1641.0", "CO", "BOULDER SPRINGS", "",
                 "HCN", "72469"},
                {"XXE00147708", "-36.7200", "4.0500", "", "", "TIZI", "GSN", "", "60395"}}));
}

TEST(GhcnStationList, may_be_packed) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/a.txt.gz";
  const gzFile packed = gzopen(file.c_str(), "wb");
  gzputs(packed, lines);
  gzclose(packed);
  EXPECT_TRUE(is_ghcn_station_list(file));
  GhcnStationList list(file);
  EXPECT_EQ(rows_of(list).size(), 2U);
}

TEST(GhcnStationList, names_every_line_that_is_none) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.txt", std::string(lines) + "\ncut\nXX0\n");
  GhcnStationList list(file);
  const auto found = complaints_of([&] { rows_of(list); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], file + ":4: is no line of GHCN-Daily's list of stations: 'cut'");
}

}  // namespace
}  // namespace thiessen
