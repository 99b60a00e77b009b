#include "base/iso_time.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

using P = TimePrecision;

IsoTime at(std::string_view text) {
  const ParsedTime parsed = parse_iso_time(text);
  EXPECT_TRUE(parsed) << text;
  return parsed.time;
}

/// year, month, day, hour, minute, second, nanosecond
std::vector<int> parts(std::string_view text) {
  const IsoTime t = at(text);
  return {t.year, t.month, t.day, t.hour, t.minute, t.second, t.nanosecond};
}

bool is_before(std::string_view a, std::string_view b) {
  return order_of_moments(at(a), at(b)) < 0 && order_of_moments(at(b), at(a)) > 0;
}

bool is_same_moment(std::string_view a, std::string_view b) {
  return order_of_moments(at(a), at(b)) == 0;
}

using Parts = std::vector<int>;

TEST(IsoTime, reads_years_months_and_days) {
  EXPECT_EQ(parts("2013"), (Parts{2013, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(parts("2013-08"), (Parts{2013, 8, 1, 0, 0, 0, 0}));
  EXPECT_EQ(parts("2013-08-31"), (Parts{2013, 8, 31, 0, 0, 0, 0}));
  EXPECT_EQ(parts("20130831"), (Parts{2013, 8, 31, 0, 0, 0, 0}));
  EXPECT_EQ(parts("0000-01-01"), (Parts{0, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(at("2013").precision, P::year);
  EXPECT_EQ(at("2013-08").precision, P::month);
  EXPECT_EQ(at("2013-08-31").precision, P::day);
  EXPECT_EQ(at("20130831").precision, P::day);
}

TEST(IsoTime, reads_times_of_the_day) {
  EXPECT_EQ(parts("2013-08-31T06"), (Parts{2013, 8, 31, 6, 0, 0, 0}));
  EXPECT_EQ(parts("2013-08-31T06:15"), (Parts{2013, 8, 31, 6, 15, 0, 0}));
  EXPECT_EQ(parts("2013-08-31 06:15:59"), (Parts{2013, 8, 31, 6, 15, 59, 0}));
  EXPECT_EQ(parts("2013-08-31T06:15:59.5"), (Parts{2013, 8, 31, 6, 15, 59, 500'000'000}));
  EXPECT_EQ(parts("2013-08-31T06:15:59,123456789"), (Parts{2013, 8, 31, 6, 15, 59, 123'456'789}));
  EXPECT_EQ(parts("2013-08-31T24:00"), (Parts{2013, 8, 31, 24, 0, 0, 0}));
  EXPECT_EQ(parts("20130831T06"), (Parts{2013, 8, 31, 6, 0, 0, 0}));
  EXPECT_EQ(parts("20130831T0615"), (Parts{2013, 8, 31, 6, 15, 0, 0}));
  EXPECT_EQ(parts("20130831 061559.25"), (Parts{2013, 8, 31, 6, 15, 59, 250'000'000}));
  EXPECT_EQ(at("2013-08-31T06").precision, P::instant);
}

TEST(IsoTime, reads_zones) {
  EXPECT_EQ(at("2013-08-31T06:15").ahead_of_utc, std::nullopt);
  EXPECT_EQ(at("2013-08-31T06:15Z").ahead_of_utc, 0);
  EXPECT_EQ(at("2013-08-31T06+02").ahead_of_utc, 120);
  EXPECT_EQ(at("2013-08-31T06:15:00.5+05:45").ahead_of_utc, 345);
  EXPECT_EQ(at("2013-08-31T06:15:00-0330").ahead_of_utc, -210);
  EXPECT_EQ(at("20130831T0615-0330").ahead_of_utc, -210);
}

TEST(IsoTime, refuses_what_is_not_written_so) {
  for (const char* text : {"",
                           "storm",
                           "13",
                           "201",
                           "201308",
                           "2013-8",
                           "2013-08-1",
                           "2013-08-",
                           "2013-",
                           "2013/08/31",
                           "31.08.2013",
                           "08/31/2013",
                           "2013-0831",
                           "201308-31",
                           "20138",
                           "2013083",
                           "201308310600",
                           "2013-08-31T",
                           "2013-08-31  06:00",
                           "2013-08-31t06:00",
                           "2013-08-31T6:00",
                           "2013-08-31T0600",
                           "20130831T06:00",
                           "2013-08-31T06:0",
                           "2013-08-31T06:00:",
                           "2013-08-31T06:00:00.",
                           "2013-08-31T06:00.5",
                           "2013-08-31T06:00:00.1234567890",
                           "2013-08-31T06:00z",
                           "2013-08-31T06:00ZZ",
                           "2013-08-31T06:00+",
                           "2013-08-31T06:00+2",
                           "2013-08-31T06:00+02:",
                           "2013-08-31T06:00+02:0",
                           "2013-08-31T06:00 +02:00",
                           "2013-08Z",
                           "2013-08-31Z",
                           " 2013",
                           "2013 ",
                           "+2013",
                           "-2013",
                           "2013-W35",
                           "2013-243",
                           "２０１３"}) {
    EXPECT_EQ(parse_iso_time(text).fault, IsoTimeFault::form) << text;
  }
  EXPECT_EQ(parse_iso_time(std::string_view("2013\0", 5)).fault, IsoTimeFault::form);
}

TEST(IsoTime, refuses_what_there_is_not) {
  for (const char* text :
       {"2013-00", "2013-13", "2013-08-00", "2013-08-32", "2013-09-31", "2013-02-29", "1900-02-29",
        "20130230", "2013-08-31T25", "2013-08-31T24:01", "2013-08-31T24:00:00.1",
        "2013-08-31T06:60", "2013-08-31T06:00:60", "2013-08-31T06:00+24",
        "2013-08-31T06:00+02:60"}) {
    EXPECT_EQ(parse_iso_time(text).fault, IsoTimeFault::value) << text;
  }
  EXPECT_TRUE(parse_iso_time("2012-02-29"));
  EXPECT_TRUE(parse_iso_time("2000-02-29"));
}

TEST(IsoTime, orders_moments_by_the_clock) {
  EXPECT_TRUE(is_before("2012-12-31T23:59:59.999999999", "2013"));
  EXPECT_TRUE(is_before("2013-08-31T06:00:00.1", "2013-08-31T06:00:00.11"));
  EXPECT_TRUE(is_before("2012-02-28T24:00", "2012-02-29T00:01"));
  EXPECT_TRUE(is_before("0000-01-01", "9999-12-31"));
  EXPECT_TRUE(is_same_moment("2013", "20130101T00"));
  EXPECT_TRUE(is_same_moment("2012-02-29T24:00", "2012-03-01T00:00"));
  EXPECT_TRUE(is_same_moment("2013-08-31T06:00Z", "2013-08-31 06:00:00"));
}

TEST(IsoTime, orders_moments_of_two_zones_by_what_they_are) {
  EXPECT_TRUE(is_same_moment("2013-08-31T06:00Z", "2013-08-31T08:00+02:00"));
  EXPECT_TRUE(is_same_moment("2013-08-31T23:00-01:30", "2013-09-01T00:30Z"));
  EXPECT_TRUE(is_before("2013-08-31T07:59+02:00", "2013-08-31T06:00Z"));
}

TEST(IsoTime, orders_dates_as_far_as_is_asked) {
  const auto order = [](std::string_view a, std::string_view b, P precision) {
    return order_of_dates(at(a), at(b), precision);
  };
  EXPECT_TRUE(order("2013-08-31T24:00", "2013-08", P::month) == 0);
  EXPECT_TRUE(order("2013-08-31T24:00", "2013-08-31", P::day) == 0);
  EXPECT_TRUE(order("2013-08-31", "2013-08-01", P::day) > 0);
  EXPECT_TRUE(order("2013-12-31", "2013-01-01", P::year) == 0);
  EXPECT_TRUE(order("2013-12-31", "2014-01-01", P::year) < 0);
}

TEST(IsoTime, writes_dates) {
  EXPECT_EQ(date_text(at("2013-08-01T06:00"), P::day), "2013-08-01");
  EXPECT_EQ(date_text(at("20130801T0600"), P::month), "2013-08");
  EXPECT_EQ(date_text(at("0987-12-31"), P::year), "0987");
}

TEST(IsoTime, is_written_in_its_own_precision) {
  for (const char* text : {"2013", "2013-08", "2013-08-31", "2013-08-31T06:00", "2013-08-31T24:00",
                           "2013-08-31T06:00:07.05", "2013-08-31T06:00Z", "2013-08-31T06:00-03:30"})
    EXPECT_EQ(iso_text(parse_iso_time(text).time), text);
  EXPECT_EQ(iso_text(parse_iso_time("20130831 0600").time), "2013-08-31T06:00");
}

}  // namespace
}  // namespace thiessen
