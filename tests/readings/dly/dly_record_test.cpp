#include "readings/dly/dly_record.h"

#include <gtest/gtest.h>

#include <numeric>

#include "readings/dly_text.h"

namespace thiessen {
namespace {

const std::string id = "USC00050001";

CalendarMonth month_of(int year, int month) {
  return CalendarMonth{12 * year + month - 1};
}

std::string fault_of(const std::string& line, bool ends = true) {
  std::string fault;
  const bool is_read = read_dly_record(line, ends, fault).has_value();
  EXPECT_EQ(is_read, fault.empty());
  return fault;
}

DlyDay day_of(const std::string& value, const std::string& flags = "   ", int day = 31) {
  const std::string line = dly_line(id, 2020, 1, {{day, {value, flags}}});
  std::string fault;
  const auto record = read_dly_record(line, true, fault);
  EXPECT_EQ(fault, "");
  // The field refers to the line, which ends here.
  DlyDay read = read_dly_day(record.value(), day);
  read.field = {};
  return read;
}

// Gregory's rule: every fourth year is a leap year, of full centuries every fourth.
TEST(CalendarMonth, february_has_a_29th_by_gregorys_rule) {
  for (const int year : {1904, 2000, 2020, 2024}) EXPECT_EQ(days_in(month_of(year, 2)), 29) << year;
  for (const int year : {1900, 2019, 2100, 2200}) EXPECT_EQ(days_in(month_of(year, 2)), 28) << year;
}

TEST(CalendarMonth, law_1_the_months_of_400_years_have_146097_days) {
  int days = 0;
  for (int i = 0; i < 4800; ++i) days += days_in(CalendarMonth{12 * 1750 + i});
  EXPECT_EQ(days, 146097);
}

TEST(CalendarMonth, is_written_as_iso_8601_has_it) {
  EXPECT_EQ(text_of(month_of(2013, 1)), "2013-01");
  EXPECT_EQ(text_of(month_of(2013, 12)), "2013-12");
  EXPECT_EQ(text_of(month_of(2013, 8), 5), "2013-08-05");
  EXPECT_EQ(text_of(month_of(2013, 8), 31), "2013-08-31");
}

TEST(DlyRecord, has_its_columns_where_the_readme_of_the_data_set_says) {
  const std::string line = dly_line(id, 1995, 7, {}, "SNOW");
  ASSERT_EQ(line.size(), 269U);
  std::string fault;
  const auto record = read_dly_record(line, true, fault);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->id, id);
  EXPECT_EQ(record->month, month_of(1995, 7));
  EXPECT_EQ(record->element, "SNOW");
  EXPECT_EQ(record->days.size(), 31U * 8);
}

TEST(DlyRecord, a_line_may_lack_blanks_at_its_end_where_it_ends) {
  const std::string line = dly_line(id, 2020, 1, {});
  EXPECT_EQ(fault_of(line.substr(0, 266)), "");
  EXPECT_EQ(fault_of(line.substr(0, 265)), "the line is cut: it has 265 of 269 characters");
  EXPECT_EQ(fault_of(line.substr(0, 268), false), "the line is cut: it has 268 of 269 characters");
  EXPECT_EQ(fault_of(line, false), "");
  EXPECT_EQ(fault_of(line + "  "), "");
  EXPECT_EQ(fault_of(line + " x"), "the line has more than 269 characters");
}

TEST(DlyRecord, years_and_months_are_those_of_measured_rain) {
  for (const int year : {1700, 2299}) EXPECT_EQ(fault_of(dly_line(id, year, 12, {})), "");
  for (const int year : {1699, 2300})
    EXPECT_EQ(fault_of(dly_line(id, year, 12, {})),
              "columns 12 to 15, '" + std::to_string(year) + "', are no year from 1700 to 2299");
  for (const int month : {0, 13})
    EXPECT_TRUE(fault_of(dly_line(id, 2020, month, {})).ends_with(", are no month from 01 to 12"));
  std::string line = dly_line(id, 2020, 1, {});
  line[12] = '-';
  EXPECT_TRUE(fault_of(line).starts_with("columns 12 to 15, '2-20'"));
}

TEST(DlyDay, is_a_number_of_five_columns_flush_right) {
  EXPECT_EQ(day_of("0").value, 0);
  EXPECT_EQ(day_of("-5").value, -5);
  EXPECT_EQ(day_of("99999").value, 99999);
  EXPECT_EQ(day_of("-9999").value, dly_missing);
  EXPECT_TRUE(day_of("12", "   ", 1).is_number);
  for (const char* value : {"", "-", "1.5", "1 2", "x", "12-"})
    EXPECT_FALSE(day_of(value).is_number) << value;
}

// The flags: of measurement, quality and source, in this order.
TEST(DlyDay, is_flagged_by_the_second_flag_alone) {
  EXPECT_TRUE(day_of("12", " X ").is_flagged);
  EXPECT_FALSE(day_of("12", "B 7").is_flagged);
  std::string fault;
  const std::string line = dly_line(id, 2020, 1, {{31, {"12", "   "}}}).substr(0, 266);
  EXPECT_FALSE(read_dly_day(read_dly_record(line, true, fault).value(), 31).is_flagged);
}

}  // namespace
}  // namespace thiessen
