#include "readings/published/published_formats.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "readings/units/rain_unit.h"

namespace thiessen {
namespace {

using Header = std::vector<std::string>;

std::string format_of(const Header& header) {
  const PublishedFormat* format = format_of_header(header);
  return format == nullptr ? "none" : std::string(format->name);
}

TEST(PublishedFormats, is_known_by_columns_in_their_order) {
  EXPECT_EQ(format_of({"STATION", "DATE", "LATITUDE", "LONGITUDE", "ELEVATION", "NAME", "PRCP",
                       "PRCP_ATTRIBUTES"}),
            "NOAA's GHCN-Daily, a column an element");
  EXPECT_EQ(format_of({"STATION", "NAME", "LATITUDE", "LONGITUDE", "ELEVATION", "DATE", "PRCP",
                       "PRCP_ATTRIBUTES"}),
            "an order of NOAA's Climate Data Online, with flags");
  EXPECT_EQ(format_of({"ID", "DATE", "ELEMENT", "VALUE", "M", "Q", "S", "OBS"}),
            "NOAA's GHCN-Daily by year or by station");
  EXPECT_EQ(format_of({"STATIONS_ID", "MESS_DATUM", "QN_8", "  R1", "RS_IND", "WRTR"}),
            "DWD's hourly precipitation");
  EXPECT_EQ(format_of({"station", "date", "rain"}), "none");
  EXPECT_EQ(format_of({}), "none");
}

TEST(PublishedFormats, common_names_in_small_letters_are_no_order) {
  EXPECT_EQ(format_of({"STATION", "NAME", "DATE", "PRCP"}),
            "an order of NOAA's Climate Data Online");
  EXPECT_EQ(format_of({"STATION", "DATE", "PRCP"}), "an order of NOAA's daily summaries");
  EXPECT_EQ(format_of({"station", "name", "date", "prcp"}), "none");
  EXPECT_EQ(format_of({"station", "date", "prcp"}), "none");
}

TEST(PublishedFormats, every_row_names_columns_of_its_own_and_a_unit) {
  for (const PublishedFormat& format : published_formats()) {
    Header header;
    for (const std::string_view names : parted(format.columns, ','))
      header.emplace_back(parted(names, '|').back());
    const std::string_view beginning = parted(format.begins, '|').back();
    EXPECT_EQ(format_of_header(header, beginning), &format) << format.name;
    EXPECT_TRUE(format.station.empty() || published_column(header, format.station)) << format.name;
    EXPECT_TRUE(published_column(header, format.value)) << format.name;
    for (const std::string_view time : parted(format.time, ','))
      EXPECT_TRUE(published_column(header, time)) << format.name;
    if (!format.flags.empty()) {
      EXPECT_TRUE(published_column(header, format.flags)) << format.name;
    }
    EXPECT_EQ(rain_unit(format.unit).has_value(), !format.unit_is_ordered) << format.name;
  }
}

TEST(PublishedFormats, common_columns_belong_to_one_with_its_lines_above_them_alone) {
  const Header header = {"date", "ind", "rain"};
  EXPECT_EQ(format_of_header(header), nullptr);
  const PublishedFormat* format = format_of_header(header, "Station Name: WESTFIELD\n\n");
  ASSERT_NE(format, nullptr);
  EXPECT_EQ(format->repeated, "ind");
  EXPECT_TRUE(begins_as_published("\xEF\xBB\xBFREGIAO:;CO\n"));
  EXPECT_FALSE(begins_as_published("date,rain\n"));
}

TEST(PublishedFormats, none_has_thousands_of_columns) {
  Header header(2000, "x");
  header.insert(header.end(), {"STATION", "DATE", "TEMP", "DEWP", "PRCP", "FRSHTT"});
  EXPECT_EQ(format_of_header(header), nullptr);
}

std::string without_rain(const Header& header, std::string_view beginning = {}) {
  return std::string(format_without_rain(header, beginning));
}

TEST(PublishedFormats, without_its_rain_is_known_where_the_other_columns_tell_it) {
  EXPECT_EQ(without_rain({"STATION", "DATE", "LATITUDE", "LONGITUDE", "ELEVATION", "NAME", "TMAX"}),
            "NOAA's GHCN-Daily, a column an element");
  EXPECT_EQ(without_rain({"STATION", "NAME", "DATE", "TMAX", "TMIN"}),
            "an order of NOAA's Climate Data Online, with flags");
  EXPECT_EQ(without_rain({"STATIONS_ID", "MESS_DATUM", "QN_9", "TT_TU", "RF_TU", "eor"}),
            "a product of DWD's other than rain");
  EXPECT_EQ(without_rain({"date", "ind", "maxtp"}, "Station Name: X\n"),
            "Met \u00c9ireann's hourly or daily data");
}

TEST(PublishedFormats, that_may_have_rain_by_another_name_is_not_without_it) {
  EXPECT_EQ(without_rain({"STATIONS_ID", "MESS_DATUM", "QN", "RS_05", "eor"}), "");
  EXPECT_EQ(without_rain({"STATIONS_ID", "MESS_DATUM_BEGINN", "MESS_DATUM_ENDE", "QN_6", "JA_RR"}),
            "");
  EXPECT_EQ(without_rain({"STATION", "NAME", "DATE", "HPCP"}), "");
  EXPECT_EQ(without_rain({"STATION", "DATE", "TMAX"}), "") << "anybody may call columns so";
  EXPECT_EQ(without_rain({"station", "name", "date", "tmax"}), "");
  EXPECT_EQ(without_rain({}), "");
}

}  // namespace
}  // namespace thiessen
