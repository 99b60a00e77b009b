#include "readings/published/text_beginning.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "readings/published/published_formats.h"

namespace thiessen {
namespace {

constexpr const char* inmet =
    "REGI\xC3O:;CO\nUF:;DF\nESTA\xC7\xC3O:;OESTE\nCODIGO (WMO):;A901\nLATITUDE:;-15,8\n"
    "Data;Hora UTC;PRECIPITA\xC7\xC3O TOTAL, HOR\xC1RIO (mm);VENTO;\n"
    "2019/01/01;0000 UTC;,8;1,8;\n";

TEST(TextBeginning, a_format_that_is_published_in_Latin_1_needs_no_encoding) {
  const TextBeginning told = look_at_beginning(inmet, {});
  EXPECT_TRUE(told.tells_encoding);
  EXPECT_EQ(told.dialect.encoding, "Latin-1");
  EXPECT_NE(told.text.find("PRECIPITA\u00c7\u00c3O"), std::string::npos);
}

TEST(TextBeginning, what_the_user_says_of_the_encoding_stays) {
  CsvDialect said;
  said.encoding = "Windows-1252";
  const TextBeginning told = look_at_beginning(inmet, said);
  EXPECT_FALSE(told.tells_encoding);
  EXPECT_EQ(told.dialect.encoding, "Windows-1252");
}

TEST(TextBeginning, any_other_text_in_Latin_1_stays_unknown) {
  const TextBeginning told = look_at_beginning(
      "date;Stra\xDF"
      "e\n2020-01-01;1\n",
      {});
  EXPECT_FALSE(told.tells_encoding);
  EXPECT_EQ(told.dialect.encoding, "");
}

TEST(TextBeginning, a_header_may_repeat_what_its_format_repeats) {
  EXPECT_EQ(look_at_beginning("Station Name: A\n\ndate,ind,rain,ind,temp\n", {}).dialect.repeated,
            std::vector<std::string>{"ind"});
  EXPECT_TRUE(look_at_beginning("date,ind,rain,ind,temp\n", {}).dialect.repeated.empty());
}

TEST(TextBeginning, the_lines_above_the_header_and_the_name_of_the_file_tell_the_station) {
  const std::string above = "Station Name: EASTFIELD (No.2)  \r\nStation Height: 5 M\r\n";
  const PublishedFormat& format = *format_of_header({"date", "ind", "rain"}, above);
  EXPECT_EQ(stations_told(format, above, "a/dly9532.csv"),
            (std::vector<std::string>{"EASTFIELD (No.2)", "9532"}));
  EXPECT_EQ(stations_told(format, "Station Name:\n", "dly.csv"), std::vector<std::string>{});
  EXPECT_EQ(stations_told(format, "Station Name: \r\n", "dly.csv"), std::vector<std::string>{});
  EXPECT_EQ(stations_told(format, above, "9532.csv"), std::vector<std::string>{"EASTFIELD (No.2)"});
}

TEST(TextBeginning, tells_readings_of_a_known_format) {
  EXPECT_TRUE(begins_as_readings(inmet));
  EXPECT_TRUE(begins_as_readings("STATION,DATE,PRCP\nA,2020-01-01,1\n"));
  EXPECT_TRUE(begins_as_readings("USC00000001,20200101,PRCP,40,,,7,0700\n"));
  EXPECT_TRUE(begins_as_readings("Station  a,\nLati 35.0\nLong-81.5\nElev  200\n"));
  EXPECT_TRUE(begins_as_readings("20000228\n0.5\n"));
  EXPECT_TRUE(begins_as_readings("# remark\nid;date;rain (mm)\nA;2020-01-01;1\n"));
  EXPECT_FALSE(begins_as_readings("time,A,B\n2020-01-01,1,2\n"));
  EXPECT_FALSE(begins_as_readings("Stations_id;Stationshoehe;Stationsname\n44;4.0;A\n"));
  EXPECT_FALSE(begins_as_readings(""));
}

}  // namespace
}  // namespace thiessen
