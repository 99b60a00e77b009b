#include "readings/times/time_format.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

std::string read(const std::string& format, const std::string& text) {
  const ParsedTime parsed = TimeFormat(format).read(text);
  if (parsed.fault == IsoTimeFault::form) return "form";
  if (parsed.fault == IsoTimeFault::value) return "value";
  return iso_text(parsed.time);
}

TEST(TimeFormat, reads_a_clock_a_day_a_month_or_a_year) {
  EXPECT_EQ(read("%d/%m/%Y %H:%M", "31/12/2010 06:05"), "2010-12-31T06:05");
  EXPECT_EQ(read("%d/%m/%Y", "1/2/2010"), "2010-02-01");
  EXPECT_EQ(read("%m.%Y", "02.2010"), "2010-02");
  EXPECT_EQ(read("%Y", "2010"), "2010");
  EXPECT_EQ(read("%d/%m/%y", "31/12/10"), "2010-12-31");
  EXPECT_EQ(read("%Y-%j", "2010-365"), "2010-12-31");
  EXPECT_EQ(read("%F %T", "2010-12-31 01:02:03.5"), "2010-12-31T01:02:03.5");
}

TEST(TimeFormat, knows_english_months_halves_of_days_and_zones) {
  EXPECT_EQ(read("%d%b%Y %H%M", "01JUN2000 2400"), "2000-06-01T24:00");
  EXPECT_EQ(read("%d %B %Y", "1 June 2000"), "2000-06-01");
  EXPECT_EQ(read("%m/%d/%Y %I:%M %p", "06/01/2000 12:30 AM"), "2000-06-01T00:30");
  EXPECT_EQ(read("%m/%d/%Y %I:%M %p", "06/01/2000 1:30 PM"), "2000-06-01T13:30");
  EXPECT_EQ(read("%Y%m%d %H%M %Z", "20000601 0000 UTC"), "2000-06-01T00:00Z");
  EXPECT_EQ(read("%Y%m%d%H%M%z", "200006010000+0130"), "2000-06-01T00:00+01:30");
}

// 2010 has 365 days, 2012 has 366.
TEST(TimeFormat, refuses_a_day_that_the_year_lacks) {
  EXPECT_EQ(read("%Y %j", "2010 365"), "2010-12-31");
  EXPECT_EQ(read("%Y%j", "2012366"), "2012-12-31");
  EXPECT_EQ(read("%Y %j", "2010 60"), "2010-03-01");
  EXPECT_EQ(read("%j/%Y %H", "1/2010 06"), "2010-01-01T06:00");
  for (const char* text : {"2010 366", "2010 0", "2012 367", "2010 400"})
    EXPECT_EQ(read("%Y %j", text), "value") << text;
}

TEST(TimeFormat, refuses_what_is_written_otherwise_or_does_not_exist) {
  EXPECT_EQ(read("%d/%m/%Y", "2010-12-31"), "form");
  EXPECT_EQ(read("%d/%m/%Y", "31/12/2010 00:00"), "form");
  EXPECT_EQ(read("%d/%m/%Y", ""), "form");
  EXPECT_NE(read("%d/%m/%Y", "29/02/2010"), "2010-02-29");
  EXPECT_NE(read("%d/%m/%Y", "12/31/2010"), "2010-12-31");
  EXPECT_EQ(read("%d/%m/%Y", "31/12/10"), "value") << "the year 10";
}

// 40543 is 31 December 2010 by Excel; 0.25 of a day is 6 hours, and 1/24 is no fraction of 2.
TEST(TimeFormat, reads_serial_numbers_of_spreadsheets) {
  EXPECT_EQ(read("excel", "40543"), "2010-12-31");
  EXPECT_EQ(read("excel", "40543.25"), "2010-12-31T06:00");
  EXPECT_EQ(read("excel", "40543.041666666664"), "2010-12-31T01:00");
  EXPECT_EQ(read("excel", "61"), "1900-03-01");
  EXPECT_EQ(read("excel", "60"), "value") << "29 February 1900";
  EXPECT_EQ(read("excel", "2958466"), "value");
  EXPECT_EQ(read("excel", "31/12/2010"), "form");
}

TEST(TimeFormat, says_a_whole_time_or_is_not_sound) {
  for (const char* sound : {"excel", "%Y", "%Y-%m", "%d/%m/%y", "%F %T", "%Y%j", "%Y%j %H", "%c"})
    EXPECT_TRUE(TimeFormat::is_sound(sound)) << sound;
  for (const char* unsound :
       {"", "%", "d/m/Y", "%d/%m", "%H:%M", "%Y %H", "%Y %m %H", "%Y %d", "Excel"})
    EXPECT_FALSE(TimeFormat::is_sound(unsound)) << unsound;
}

}  // namespace
}  // namespace thiessen
