#include "readings/published/headerless_formats.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace thiessen {
namespace {

std::string format_of(std::string_view beginning) {
  const PublishedFormat* format = format_of_rows(beginning);
  return format == nullptr ? "none" : std::string(format->name);
}

TEST(HeaderlessFormats, rows_of_GHCN_Daily_need_no_header) {
  const std::string name = "NOAA's GHCN-Daily by year or by station, without a header";
  EXPECT_EQ(format_of("USC00050848,20130911,PRCP,254,,,7,1700\n"), name);
  EXPECT_EQ(format_of("XXE00147708,20130911,TMIN,-12,,,E,\r\nX"), name);
  EXPECT_EQ(format_of("ID,DATE,ELEMENT,VALUE,M,Q,S,OBS\n"), "none");
  EXPECT_EQ(format_of("USC00050848,20130911,PRCP,25.4,,,7,1700\n"), "none");
  EXPECT_EQ(format_of("USC00050848,20130911,PRCP,254,,,7\n"), "none");
}

TEST(HeaderlessFormats, rows_of_Meteostat_are_a_date_and_numbers) {
  EXPECT_EQ(format_of("2019-12-30,4.1,1.0,7.2,2.4,,180,12.1,30.2,1010.1,\n"),
            "Meteostat's daily data, without a header");
  EXPECT_EQ(format_of("1949-01-01,,,,,,,,,,"), "Meteostat's daily data, without a header");
  EXPECT_EQ(format_of("2020-01-01,23,4.1,1.0,80,0.2,,180,12.0,,1010.0,,\n"),
            "Meteostat's hourly data, without a header");
  EXPECT_EQ(format_of("2020-01-01,24,4.1,1.0,80,0.2,,180,12.0,,1010.0,,\n"), "none");
  EXPECT_EQ(format_of("2020-01-01,a,4.1,1.0,80,0.2,,180,12.0,,1010.0,,\n"), "none");
  EXPECT_EQ(format_of("date,tavg,tmin,tmax,prcp,snow,wdir,wspd,wpgt,pres,tsun\n"), "none");
  EXPECT_EQ(format_of(""), "none");
}

TEST(HeaderlessFormats, their_columns_are_named) {
  for (const PublishedFormat& format : headerless_formats()) {
    std::vector<std::string> header;
    for (const std::string_view name : parted(format.columns, ',')) header.emplace_back(name);
    EXPECT_TRUE(published_column(header, format.value)) << format.name;
    for (const std::string_view time : parted(format.time, ','))
      EXPECT_TRUE(published_column(header, time)) << format.name;
  }
}

}  // namespace
}  // namespace thiessen
