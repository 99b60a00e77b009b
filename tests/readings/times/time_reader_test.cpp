#include "readings/times/time_reader.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "base/error.h"

namespace thiessen {
namespace {

/// What a time says: as ISO 8601, its fault, or that it is a label or ISO 8601 anyway.
std::string told(TimeReader& reader, const std::string& text, std::size_t line = 9) {
  const std::optional<WrittenTime> time = reader.read(text, line);
  if (!time) return "as it is";
  if (!time->fault.empty()) return time->fault.plain().substr(1);
  return time->parsed ? iso_text(time->parsed.time) : "does not exist";
}

TimeReader reader_that_saw(std::initializer_list<const char*> times) {
  TimeReader reader;
  std::size_t line = 1;
  for (const char* time : times) reader.see(time, ++line);
  return reader;
}

TEST(TimeReader, leaves_times_of_iso_8601_and_labels) {
  TimeReader reader;
  for (const char* text :
       {"2010-12-31", "2010-12-31 06:00", "2010-13-01", "storm 1", "", "20101231"})
    EXPECT_EQ(told(reader, text), "as it is") << text;
}

TEST(TimeReader, reads_what_can_be_read_in_one_way) {
  TimeReader reader;
  EXPECT_EQ(told(reader, "2010/12/31"), "2010-12-31");
  EXPECT_EQ(told(reader, "31-Dec-2010"), "2010-12-31");
  EXPECT_EQ(told(reader, " 2010123109 "), "2010-12-31T09:00");
  EXPECT_EQ(told(reader, "01/01/2010"), "2010-01-01") << "both ways are one";
  EXPECT_EQ(told(reader, "2010/02/30"), "does not exist");
}

TEST(TimeReader, finds_the_order_by_a_day_above_12) {
  TimeReader day_first = reader_that_saw({"01/02/2010", "13/02/2010"});
  EXPECT_EQ(told(day_first, "01/02/2010"), "2010-02-01");
  TimeReader month_first = reader_that_saw({"01/02/2010", "02/13/2010"});
  EXPECT_EQ(told(month_first, "01/02/2010 06:00"), "2010-01-02T06:00");
}

TEST(TimeReader, shows_both_readings_where_nothing_tells) {
  TimeReader reader = reader_that_saw({"01/02/2010", "02/02/2010"});
  const std::optional<WrittenTime> time = reader.read("01/02/2010", 2);
  EXPECT_EQ(time->fault.plain(), " could be 2010-02-01 or 2010-01-02");
  EXPECT_EQ(time->hint.plain(),
            "time_format = %d/%m/%Y reads it as 2010-02-01, time_format = %m/%d/%Y as 2010-01-02");
  EXPECT_FALSE(time->breaks_format) << "it may be a label";
  EXPECT_EQ(told(reader, "13/02/2010"), "2010-02-13") << "this leaves no choice";
  EXPECT_EQ(told(reader, "01/02/2010"), "could be 2010-02-01 or 2010-01-02") << "it came too late";
}

TEST(TimeReader, the_first_time_of_a_pipe_may_tell) {
  TimeReader reader;
  EXPECT_EQ(told(reader, "13/02/2010"), "2010-02-13");
  EXPECT_EQ(told(reader, "01/02/2010"), "2010-02-01");
}

TEST(TimeReader, a_contradiction_is_a_fault_of_the_file) {
  TimeReader reader = reader_that_saw({"13/02/2010"});
  EXPECT_EQ(told(reader, "02/13/2010"), "has the month first, and '13/02/2010' in line 2 the day");
  EXPECT_TRUE(reader.read("02/13/2010", 9)->breaks_format);
}

TEST(TimeReader, reads_all_times_as_the_user_says) {
  TimeReader reader("%d/%m/%Y");
  EXPECT_EQ(told(reader, "01/02/2010"), "2010-02-01");
  EXPECT_EQ(told(reader, "2010-12-31"), "is not written as time_format = %d/%m/%Y says");
  EXPECT_TRUE(reader.read("storm 1", 9)->breaks_format);
  EXPECT_THROW(TimeReader("%H:%M"), Error);
}

TEST(TimeReader, serial_numbers_have_clocks_where_one_has) {
  TimeReader days("excel");
  days.see("40543", 2);
  EXPECT_EQ(told(days, "40543"), "2010-12-31");
  TimeReader hours("excel");
  hours.see("40543", 2);
  hours.see("40543.25", 3);
  EXPECT_EQ(told(hours, "40543"), "2010-12-31T00:00");
}

TEST(TimeReader, a_text_among_times_is_a_fault_of_the_file) {
  TimeReader reader = reader_that_saw({"2020-01-01", "2020-01-02", "Total"});
  EXPECT_EQ(told(reader, "2020-01-01"), "as it is");
  EXPECT_EQ(told(reader, "Total"), "is no time, as those of the other rows are");
  EXPECT_EQ(reader.read("Total", 4)->hint.plain(), "take the row out of the file");
  reader.times_stand_in("day");
  EXPECT_EQ(reader.read("Total", 4)->hint.plain(),
            "rainfall_where = \"day\"<>'Total' leaves such rows out");
  EXPECT_TRUE(reader.is_no_time("42372", 4)) << "a day of a spreadsheet";
  EXPECT_FALSE(reader.is_no_time("2020-02-30", 4)) << "some calendars have it";
  TimeReader others = reader_that_saw({"31.12.2019", "01.01.2020", "02.01.2020"});
  EXPECT_TRUE(others.is_no_time("Mean", 5));
}

TEST(TimeReader, labels_stay_labels) {
  TimeReader storms = reader_that_saw({"storm 1", "2020", "2021"});
  EXPECT_EQ(told(storms, "storm 2"), "as it is");
  TimeReader steps = reader_that_saw({"998", "999", "1000", "1001", "1002", "1003"});
  EXPECT_EQ(told(steps, "1"), "as it is") << "numbers of four digits look like years";
  TimeReader halves = reader_that_saw({"2020-01-01", "2020-01-02", "first", "second"});
  EXPECT_EQ(told(halves, "third"), "as it is");
}

TEST(TimeReader, of_a_pipe_three_times_tell_that_none_is_a_label) {
  TimeReader reader = reader_that_saw({"2020-01-01"});
  for (const char* text : {"2020-01-01", "2020-01-02", "2020-01-03"})
    EXPECT_EQ(told(reader, text), "as it is");
  EXPECT_TRUE(reader.is_no_time("Total", 5));
  TimeReader labels = reader_that_saw({"2020-01-01"});
  for (const char* text : {"2020-01-01", "storm 1", "2020-01-02", "2020-01-03", "storm 2"})
    EXPECT_EQ(told(labels, text), "as it is");
}

TEST(TimeReader, names_the_time_that_told_the_order_of_others_above_it) {
  const TimeReader late = reader_that_saw({"1/2/2010", "1/13/2010"});
  EXPECT_EQ(late.order_told().by, "1/13/2010");
  EXPECT_EQ(late.order_told().line, 3U);
  EXPECT_FALSE(late.order_told().is_day_first);
  EXPECT_EQ(reader_that_saw({"1/13/2010", "1/2/2010"}).order_told().by, "");
  EXPECT_EQ(reader_that_saw({"1/2/2010", "2/3/2010"}).order_told().by, "");
}

TEST(TimeReader, tells_once_the_formats_of_what_leaves_the_century_open) {
  TimeReader reader = reader_that_saw({"31/12/99", "01/01/00"});
  const std::optional<WrittenTime> time = reader.read("31/12/99", 2);
  ASSERT_TRUE(time);
  EXPECT_FALSE(time->parsed) << "it stays a label";
  EXPECT_FALSE(time->breaks_format);
  EXPECT_EQ(time->fault.plain(), " is not written as ISO 8601 wants it");
  EXPECT_EQ(time->hint.plain(), "time_format = %d/%m/%y reads it as 1999-12-31");
  EXPECT_EQ(told(reader, "01/01/00"), "as it is");
}

TEST(TimeReader, tells_all_formats_that_may_be_meant) {
  TimeReader reader;
  EXPECT_EQ(reader.read("1/2/10 06:00", 2)->hint.plain(),
            "time_format = '%d/%m/%y %H:%M' reads it as 2010-02-01T06:00, time_format = "
            "'%m/%d/%y %H:%M' as 2010-01-02T06:00, time_format = '%y/%m/%d %H:%M' as "
            "2001-02-10T06:00");
  TimeReader serials;
  EXPECT_EQ(serials.read("42370", 2)->hint.plain(), "time_format = excel reads it as 2016-01-01");
}

TEST(TimeReader, of_parts_of_the_calendar_has_no_labels) {
  TimeReader reader;
  reader.times_are_of_parts();
  EXPECT_EQ(told(reader, "2010-12-31"), "as it is");
  EXPECT_EQ(told(reader, "2010 day 366"), "is no time");
  EXPECT_TRUE(reader.read("10-01-31", 2)->breaks_format);
}

}  // namespace
}  // namespace thiessen
