#include "readings/times/time_shape.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "readings/times/time_format.h"

namespace thiessen {
namespace {

/// What a time says that has one shape; else its shapes.
std::string told(const std::string& text) {
  const TimeShape shape = time_shape(text);
  if (shape.format.empty()) return "none";
  if (!shape.month_first.empty()) return shape.format + " or " + shape.month_first;
  const ParsedTime parsed = TimeFormat(shape.format).read(text);
  return parsed ? iso_text(parsed.time) : "not " + shape.format;
}

TEST(TimeShape, of_what_can_be_read_in_one_way) {
  EXPECT_EQ(told("2010/12/31"), "2010-12-31");
  EXPECT_EQ(told("2010.1.5"), "2010-01-05");
  EXPECT_EQ(told("2010-1-5 9:30"), "2010-01-05T09:30");
  EXPECT_EQ(told("2010/12"), "2010-12");
  EXPECT_EQ(told("12/2010"), "2010-12");
  EXPECT_EQ(told("2010123109"), "2010-12-31T09:00");
  EXPECT_EQ(told("201012310930"), "2010-12-31T09:30");
  EXPECT_EQ(told("20101231093015"), "2010-12-31T09:30:15");
  EXPECT_EQ(told("20160101 00:00"), "2016-01-01T00:00");
  EXPECT_EQ(told("20160101 2400"), "2016-01-01T24:00");
  EXPECT_EQ(told("2016-01-01 0000 UTC"), "2016-01-01T00:00Z");
  EXPECT_EQ(told("2016/01/01 06:00+01:30"), "2016-01-01T06:00+01:30");
  EXPECT_EQ(told("31-Dec-2010"), "2010-12-31");
  EXPECT_EQ(told("31-dec-2010 06:00"), "2010-12-31T06:00");
  EXPECT_EQ(told("01JAN2000"), "2000-01-01");
  EXPECT_EQ(told("01JAN2000:13:00:00"), "2000-01-01T13:00");
  EXPECT_EQ(told("01JAN2000, 24:00"), "2000-01-01T24:00");
  EXPECT_EQ(told("1 January 2000"), "2000-01-01");
  EXPECT_EQ(told("Dec 31, 2010"), "2010-12-31");
}

TEST(TimeShape, of_months_that_have_a_name_and_of_days_of_the_year) {
  for (const char* month : {"Dec 2010", "December 2010", "2010 Dec", "2010 DECEMBER", "Dec-2010",
                            "2010-dec", "Dec/2010", "DEC2010", "12-2010"})
    EXPECT_EQ(told(month), "2010-12") << month;
  EXPECT_EQ(told("2010-Dec-31"), "2010-12-31");
  EXPECT_EQ(told("2010 Dec 5 06:00"), "2010-12-05T06:00");
  EXPECT_EQ(told("2010-365"), "2010-12-31");
  EXPECT_EQ(told("2012 366"), "2012-12-31");
  EXPECT_EQ(told("2010-060 06:00"), "2010-03-01T06:00");
  EXPECT_EQ(told("2010-366"), "not %Y-%j") << "2010 has 365 days";
  for (const char* text : {"Foo 2010", "2010 Foo", "Dec 10", "Dec 2010 x", "2010365", "2010.365"})
    EXPECT_EQ(told(text), "none") << text;
}

// 42370 is 1 January 2016 by Excel. A year of two digits is of 1969 to 2068, as POSIX has it.
TEST(TimeShape, tells_the_formats_of_what_leaves_something_open) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(open_formats("31/12/99"), Texts{"%d/%m/%y"});
  EXPECT_EQ(open_formats("31/12/99 06:00"), Texts{"%d/%m/%y %H:%M"});
  EXPECT_EQ(open_formats("1.2.10"), (Texts{"%d.%m.%y", "%m.%d.%y", "%y.%m.%d"}));
  EXPECT_EQ(open_formats("31-Dec-99"), Texts{"%d-%b-%y"});
  EXPECT_EQ(open_formats("Dec-99"), Texts{"%b-%y"});
  EXPECT_EQ(open_formats("991231"), Texts{"%y%m%d"});
  EXPECT_EQ(open_formats("201012"), (Texts{"%Y%m", "%y%m%d", "%d%m%y"}));
  EXPECT_EQ(open_formats("2012366"), Texts{"%Y%j"});
  EXPECT_EQ(open_formats("2010366"), Texts{}) << "2010 has 365 days";
  EXPECT_EQ(open_formats("42370"), Texts{"excel"});
  EXPECT_EQ(open_formats(" 42370.25 "), Texts{"excel"});
  for (const char* text : {"", "storm 1", "2010-12-31", "31/12/2010", "1", "99999", "42370.x",
                           "1/2/3/4", "32/13/99", "Foo-99"})
    EXPECT_EQ(open_formats(text), Texts{}) << text;
}

TEST(TimeShape, knows_months_by_their_names) {
  EXPECT_EQ(month_called("Jan"), 1);
  EXPECT_EQ(month_called("DECEMBER"), 12);
  EXPECT_EQ(month_called("may"), 5);
  EXPECT_EQ(month_called("Ja"), std::nullopt);
  EXPECT_EQ(month_called(""), std::nullopt);
}

TEST(TimeShape, of_what_has_a_day_that_may_be_a_month) {
  EXPECT_EQ(told("31/12/2010"), "%d/%m/%Y or %m/%d/%Y");
  EXPECT_EQ(told("1.2.2010 06:00"), "%d.%m.%Y %H:%M or %m.%d.%Y %H:%M");
  EXPECT_EQ(told("1/2/2010 6:00:00 PM"), "%d/%m/%Y %I:%M:%S %p or %m/%d/%Y %I:%M:%S %p");
}

TEST(TimeShape, is_unknown_of_labels_and_of_years_of_two_digits) {
  for (const char* text : {"", "storm 1", "31/12/10", "1", "2010", "201012", "31-Foo-2010", "40543",
                           "1262304000", "2010/12/31 x", "31/12-2010", "12:00", "2010/12/31 6:0"})
    EXPECT_EQ(told(text), "none") << text;
}

TEST(TimeShape, tells_dates_from_clocks) {
  for (const char* date : {"2020-01-01", "20200101", "31.12.2010", "01/02/2010", "1-Jan-2020"}) {
    EXPECT_TRUE(is_date(date)) << date;
    EXPECT_FALSE(is_clock(date)) << date;
  }
  for (const char* clock : {"05:00", "5", "24", "0500", "0000 UTC", "05:00:00", "5:00 PM"}) {
    EXPECT_TRUE(is_clock(clock)) << clock;
    EXPECT_FALSE(is_date(clock)) << clock;
  }
  EXPECT_TRUE(is_date_with_clock("2020-01-01 05:00"));
  EXPECT_FALSE(is_date_with_clock("05:00"));
  EXPECT_FALSE(is_date_with_clock("2020-01-01"));
  for (const char* other : {"2020-01-01 05:00", "", "A", "3.2"}) {
    EXPECT_FALSE(is_date(other)) << other;
    EXPECT_FALSE(is_clock(other)) << other;
  }
}

}  // namespace
}  // namespace thiessen
