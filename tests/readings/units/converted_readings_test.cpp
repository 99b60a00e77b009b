#include "readings/units/converted_readings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "readings/table_readings.h"

namespace thiessen {
namespace {

using namespace table_readings;

struct Settled {
  AmountConversion conversion;
  Texts notices;
  Texts warnings;
};

Settled settle(const ReadingsOptions& options, const std::string& column,
               const std::string& unit = "") {
  Settled settled;
  Warnings warnings;
  settled.conversion = conversion_of(options, {"r.csv", 1, column, unit}, warnings);
  for (const Message& notice : warnings.notices()) settled.notices.push_back(notice.sentence());
  for (const Message& warning : warnings.messages()) settled.warnings.push_back(warning.sentence());
  return settled;
}

TEST(AmountConversion, believes_the_name_of_the_column_and_says_so) {
  const Settled inches = settle({}, "prcp_in");
  EXPECT_EQ(inches.conversion.factor.of(1), 25.4);
  EXPECT_EQ(inches.conversion.unit, "mm");
  EXPECT_EQ(inches.conversion.millimetres, 25.4);
  EXPECT_EQ(inches.notices,
            Texts{"r.csv:1: the readings of column 'prcp_in' are converted from in to mm"});
  const Settled millimetres = settle({}, "prcp_mm");
  EXPECT_TRUE(millimetres.conversion.factor.is_one());
  EXPECT_EQ(millimetres.conversion.unit, "mm");
  EXPECT_EQ(millimetres.notices, Texts{});
}

TEST(AmountConversion, believes_a_row_of_units_before_the_name) {
  EXPECT_EQ(settle({}, "rain", "inches").conversion.factor.of(1), 25.4);
  EXPECT_EQ(settle({}, "prcp_in", "mm").conversion.unit, "mm");
  EXPECT_TRUE(settle({}, "prcp_in", "mm").conversion.factor.is_one());
  EXPECT_EQ(settle({}, "", "cm").notices,
            Texts{"r.csv:1: the readings of the table are converted from cm to mm"});
}

TEST(AmountConversion, keeps_the_time_of_a_rate) {
  const Settled rate = settle({}, "rain (in/h)");
  EXPECT_EQ(rate.conversion.factor.of(1), 25.4);
  EXPECT_EQ(rate.conversion.unit, "mm/h");
}

TEST(AmountConversion, is_nothing_where_nothing_is_known) {
  const Settled plain = settle({}, "rain");
  EXPECT_TRUE(plain.conversion.factor.is_one());
  EXPECT_EQ(plain.conversion.unit, "");
}

TEST(AmountConversion, goes_by_the_user_against_the_name_with_a_warning) {
  ReadingsOptions options;
  options.from_unit = rain_unit("0.1mm");
  const Settled tenths = settle(options, "prcp_in");
  EXPECT_EQ(tenths.conversion.factor.of(25), 2.5);
  EXPECT_EQ(tenths.warnings,
            Texts{"r.csv:1: the readings of column 'prcp_in' are taken to be in 0.1mm, as "
                  "'from_unit' says, against its own in"});
}

TEST(AmountConversion, may_keep_inches) {
  ReadingsOptions options;
  options.to_unit = rain_unit("in");
  const Settled inches = settle(options, "prcp_in");
  EXPECT_TRUE(inches.conversion.factor.is_one());
  EXPECT_EQ(inches.conversion.unit, "in");
}

TEST(AmountConversion, needs_a_known_unit_to_bring_it_to_another) {
  ReadingsOptions options;
  options.to_unit = rain_unit("in");
  EXPECT_EQ(complaint_of([&] { settle(options, "rain"); }),
            "r.csv:1: nothing says what the readings are in, so that they cannot be brought to in "
            "| 'from_unit' says it");
}

TEST(AmountConversion, multiplies_alone_where_a_factor_is_given) {
  ReadingsOptions options;
  options.scale = 2.5;
  const Settled scaled = settle(options, "prcp_in");
  EXPECT_EQ(scaled.conversion.factor.of(2), 5);
  EXPECT_EQ(scaled.conversion.unit, "");
  EXPECT_EQ(scaled.notices,
            Texts{"r.csv:1: the readings of column 'prcp_in' are multiplied by 'scale' alone, and "
                  "not taken from in to another unit"});
}

TEST(ConvertedReadings, of_long_tables_leave_gaps_and_codes_alone) {
  const Outcome outcome =
      Reader().read("station,date,prcp_in\nA,x,1\nB,x,NA\nC,x,-999\nA,y,0.5\nB,y,2\nC,y,0\n");
  expect_readings(outcome, {"x", "y"}, {{25.4, silent, silent}, {12.7, 50.8, 0}});
}

TEST(ConvertedReadings, of_wide_tables_go_by_what_the_user_says) {
  Reader reader;
  reader.options.from_unit = rain_unit("0.1mm");
  expect_readings(reader.read("time,A,B,C\nx,1,12,NA\n"), {"x"}, {{0.1, 1.2, silent}});
}

// 2,000 inches fall nowhere in a year, 2,000 tenths of a millimetre in a day in many places.
TEST(ConvertedReadings, are_judged_as_millimetres) {
  Reader reader({"A"});
  const std::string days = "2020-01-01,1\n2020-01-02,2\n2020-01-03,2000\n";
  reader.options.from_unit = rain_unit("0.1mm");
  EXPECT_EQ(reader.read("time,A\n" + days).warnings, Texts{});
  reader.options.from_unit = rain_unit("in");
  EXPECT_EQ(reader.read("time,A\n" + days).warnings,
            Texts{"r.csv:4: reading '2000' of station 'A' is more than falls anywhere in a year"});
}

TEST(AmountConversion, takes_what_falls_in_a_second_to_an_hour) {
  const Settled rate = settle({}, "rain (mm/s)");
  EXPECT_EQ(rate.conversion.factor.of(0.001), 3.6);
  EXPECT_EQ(rate.conversion.unit, "mm/h");
}

TEST(AmountConversion, believes_a_line_above_the_header_after_all_else) {
  const auto settled = [](const std::string& column, std::vector<std::string> lines,
                          Warnings& warnings) {
    return conversion_of({}, {"r.csv", 3, column, "", std::move(lines)}, warnings);
  };
  Warnings warnings;
  EXPECT_EQ(settled("", {"# station list", "# units: inches"}, warnings).factor.of(1), 25.4);
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            "r.csv:3: the readings of the table are converted from in to mm, as a line above the "
            "header says");
  EXPECT_TRUE(settled("prcp_mm", {"units: inches"}, warnings).factor.is_one());
  EXPECT_EQ(complaint_of([&] {
              settled("", {"units: in", "Rain (mm)"}, warnings);
            }),
            "r.csv:3: the lines above the header say that it is in in and in mm | 'from_unit' says "
            "what the readings are in");
}

}  // namespace
}  // namespace thiessen
