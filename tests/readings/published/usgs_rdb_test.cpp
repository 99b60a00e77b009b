#include "readings/published/usgs_rdb.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/file.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// As the RDB of USGS's instantaneous values has it; values are made up.
constexpr const char* two_sites =
    "# ---- WARNING ----\n"
    "agency_cd\tsite_no\tdatetime\ttz_cd\t1_00065\t1_00065_cd\t2_00045\t2_00045_cd\n"
    "5s\t15s\t20d\t6s\t14n\t10s\t14n\t10s\n"
    "USGS\t0214\t2024-03-10 01:45\tEST\t2.1\tP\t0.10\tP\n"
    "USGS\t0214\t2024-03-10 03:00\tEDT\t2.1\tP\tEqp\tP\n"
    "# Data provided for site 0215\n"
    "agency_cd\tsite_no\tdatetime\ttz_cd\t3_00045\t3_00045_cd\n"
    "5s\t15s\t20d\t6s\t14n\t10s\n"
    "USGS\t0215\t2024-03-10 00:45\tCST\t0.20\tP\n";

class UsgsRdbTest : public testing::Test {
 protected:
  Rows rows(const std::string& text, const std::string& wanted = "") {
    const std::string file = folder_.write("v.txt", text);
    UsgsRdb rdb(
        file, [file] { return InputFile(file); }, wanted, warnings_);
    Rows all;
    for (Row row; rdb.next(row);) all.emplace_back(row.fields.begin(), row.fields.end());
    return all;
  }

  std::vector<std::string> notices() const {
    std::vector<std::string> all;
    for (const Message& notice : warnings_.notices()) all.push_back(notice.text.plain());
    return all;
  }

  const TemporaryFolder folder_;
  Warnings warnings_;
};

TEST_F(UsgsRdbTest, is_known_by_its_header) {
  EXPECT_TRUE(is_usgs_rdb(two_sites));
  EXPECT_FALSE(is_usgs_rdb("# remark\nid,lon,lat\n"));
  EXPECT_FALSE(is_usgs_rdb("agency_cd\tsite_no\tdec_lat_va\tdec_long_va\n")) << "a list of sites";
  EXPECT_FALSE(is_usgs_rdb(""));
}

TEST_F(UsgsRdbTest, has_each_site_by_its_own_header_in_one_zone) {
  EXPECT_EQ(rows(two_sites), (Rows{{"0214", "2024-03-10 01:45", "0.10"},
                                   {"0214", "2024-03-10 02:00", "Eqp"},
                                   {"0215", "2024-03-10 01:45", "0.20"}}));
}

TEST_F(UsgsRdbTest, of_daily_values_the_sum_is_read) {
  EXPECT_EQ(rows("agency_cd\tsite_no\tdatetime\t7_00045_00001\t7_00045_00001_cd\t7_00045_00006\n"
                 "5s\t15s\t20d\t14n\t10s\t14n\n"
                 "USGS\t1\t2024-03-10\t0.3\tA\t0.9\n"),
            (Rows{{"1", "2024-03-10", "0.9"}}));
}

TEST_F(UsgsRdbTest, names_every_bad_row) {
  const auto found = complaints_of([&] {
    rows(std::string(two_sites) + "USGS\t0215\nUSGS\t0215\t2024-03-10 01:00\tXYZ\t1\tP\n" +
         "USGS\t0215\tnoon\tCST\t1\tP\n");
  });
  ASSERT_EQ(found.size(), 3U);
  const std::string file = folder_.path() + "/v.txt:";
  EXPECT_EQ(found[0], file + "10: the row has 2 fields, and the header above it 6");
  EXPECT_EQ(found[1], file + "11: no such time zone: 'XYZ'");
  EXPECT_EQ(found[2], file + "12: the time is none: 'noon'");
}

TEST_F(UsgsRdbTest, a_file_without_precipitation_is_an_error) {
  EXPECT_EQ(complaint_of([&] { rows("agency_cd\tsite_no\tdatetime\t1_00065\nUSGS\t1\tx\t2\n"); }),
            folder_.path() + "/v.txt:2: no column of precipitation (00045) is in the file");
}

TEST_F(UsgsRdbTest, tells_the_zone_that_times_are_brought_to) {
  rows(two_sites);
  EXPECT_EQ(notices(), std::vector<std::string>{"its times in EDT are brought to EST, as all are"});
}

constexpr const char* two_sensors =
    "agency_cd\tsite_no\tdatetime\t1_00045\t1_00045_cd\t2_00045\t2_00045_cd\n"
    "5s\t15s\t20d\t14n\t10s\t14n\t10s\n"
    "USGS\t1\t2024-03-10 00:00\t1\tA\t0.5\tA\n";

TEST_F(UsgsRdbTest, of_two_sensors_the_first_is_read_and_told) {
  EXPECT_EQ(rows(two_sensors), (Rows{{"1", "2024-03-10 00:00", "1"}}));
  EXPECT_EQ(notices(), std::vector<std::string>{
                           "of its columns of precipitation '1_00045' is read, and not '2_00045'"});
}

TEST_F(UsgsRdbTest, a_sensor_that_is_wanted_is_read) {
  EXPECT_EQ(rows(two_sensors, "2_00045"), (Rows{{"1", "2024-03-10 00:00", "0.5"}}));
  EXPECT_EQ(notices(), std::vector<std::string>{});
  EXPECT_EQ(complaint_of([&] { rows(two_sensors, "3_00045"); }),
            folder_.path() + "/v.txt:3: there is no column '3_00045'");
}

TEST_F(UsgsRdbTest, a_mean_or_an_extreme_of_a_day_is_no_rain) {
  const char* text =
      "agency_cd\tsite_no\tdatetime\t1_00045_00001\t1_00045_00003\n"
      "5s\t15s\t20d\t14n\t14n\n"
      "USGS\t1\t2024-03-10\t0.9\t0.1\n";
  EXPECT_EQ(complaint_of([&] { rows(text); }),
            folder_.path() +
                "/v.txt:1: its daily precipitation '1_00045_00001' is no sum of the day: that "
                "would be 00006 | value_field = 1_00045_00001 reads it nonetheless");
  EXPECT_EQ(rows(text, "1_00045_00003"), (Rows{{"1", "2024-03-10", "0.1"}}));
}

TEST_F(UsgsRdbTest, has_rain_where_any_of_its_sites_has) {
  const auto has_rain = [&](const std::string& text) {
    return has_usgs_rain(InputFile(folder_.write("h.txt", text)));
  };
  const std::string flow = "# x\nagency_cd\tsite_no\tdatetime\t1_00060\n";
  EXPECT_FALSE(has_rain(flow));
  EXPECT_TRUE(has_rain(flow + "USGS\t1\t2020-01-01\t7\n" +
                       "agency_cd\tsite_no\tdatetime\t1_00045\t1_00045_cd\n"));
  EXPECT_FALSE(has_rain("agency_cd\tsite_no\tdatetime\t1_00045_cd\n"));
}

}  // namespace
}  // namespace thiessen
