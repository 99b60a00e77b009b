#include "gdal/layers/cell_form.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

/// `d`, `c`, `dc` for what a form shows.
std::string shown(const CellForm& form) {
  return std::string(form.has_date ? "d" : "") + (form.has_clock ? "c" : "");
}

TEST(CellForm, of_excels_own_numbers) {
  EXPECT_EQ(shown(built_in_form(0)), "");
  EXPECT_EQ(shown(built_in_form(2)), "");
  EXPECT_EQ(shown(built_in_form(14)), "d");
  EXPECT_EQ(shown(built_in_form(20)), "c");
  EXPECT_EQ(shown(built_in_form(22)), "dc");
  EXPECT_EQ(shown(built_in_form(49)), "") << "text";
}

TEST(CellForm, of_codes) {
  for (const char* code : {"GENERAL", "General", "0.00", "0.00E+00", "#,##0 \"days\"", "[Red]0.0",
                           "0\\d", "\"TRUE\";\"TRUE\";\"FALSE\""})
    EXPECT_EQ(shown(form_of_code(code)), "") << code;
  for (const char* code :
       {"DD/MM/YY", "yyyy-mm-dd;@", "[$-407]d. mmmm yyyy", "mmm", "yyyy\"年\"m\"月\""})
    EXPECT_EQ(shown(form_of_code(code)), "d") << code;
  for (const char* code : {"HH:MM:SS", "h:mm AM/PM", "[h]:mm", "mm:ss.0"})
    EXPECT_EQ(shown(form_of_code(code)), "c") << code;
  for (const char* code : {"yyyy-mm-dd h:mm:ss", "DD/MM/YYYY\\ HH:MM", "m/d/yy h:mm a/p"})
    EXPECT_EQ(shown(form_of_code(code)), "dc") << code;
}

// 1 January 2020 is 43831 days after 30 December 1899: 120 years of 365 days, 29 leap days (1904 to
// 2016) and the 2 days to 1 January 1900 are 43800 + 29 + 2.
TEST(CellForm, makes_times_of_serial_numbers) {
  const CellForm date{true, false}, both{true, true}, clock{false, true};
  EXPECT_EQ(time_of_serial(43831, date, false, false), "2020-01-01");
  EXPECT_EQ(time_of_serial(43831, date, true, false), "2020-01-01T00:00");
  EXPECT_EQ(time_of_serial(43831.27083333334, date, false, false), "2020-01-01T06:30")
      << "6.5 hours are 13 of 48 parts of a day, whatever the form shows";
  EXPECT_EQ(time_of_serial(43831 + (6 * 3600 + 1.25) / 86400, both, true, false),
            "2020-01-01T06:00:01.250");
  EXPECT_EQ(time_of_serial(43830.999999999, both, true, false), "2020-01-01T00:00");
  EXPECT_EQ(time_of_serial(43831 - 1462, date, false, true), "2020-01-01")
      << "from 1 January 1904 on, which is number 1462 of the others";
  EXPECT_EQ(time_of_serial(0.25, clock, true, false), "06:00");
  EXPECT_EQ(time_of_serial(1, clock, true, false), "24:00") << "beside a date the end of its day";
  EXPECT_FALSE(time_of_serial(1.25, clock, true, false));
  EXPECT_EQ(time_of_serial(61, date, false, false), "1900-03-01");
  EXPECT_EQ(time_of_serial(60, date, false, false), std::nullopt) << "29 February 1900";
  EXPECT_EQ(time_of_serial(1e9, date, false, false), std::nullopt);
}

}  // namespace
}  // namespace thiessen
