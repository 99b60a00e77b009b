#include "cli/options/blocks/period_options.h"

#include <optional>

#include "base/complaints.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Periods : Given<PeriodOptions> {
  Periods() { block.declare(options); }
};

bool holds(const Periods& periods, const char* time) {
  return periods.block.times().value().range.holds(parse_iso_time(time).time);
}

TEST(PeriodOptions, want_nothing_of_times_unless_told) {
  Periods periods;
  periods.read({});
  EXPECT_FALSE(periods.block.times());
  EXPECT_FALSE(periods.block.totalling());
  EXPECT_EQ(periods.contradiction(), "");
}

TEST(PeriodOptions, take_the_steps_from_one_time_to_another_both_included) {
  Periods periods;
  periods.read({"--from", "2013-08", "--to", "2013-09-02"});
  EXPECT_EQ(periods.contradiction(), "");
  for (const char* time : {"2013-08-01", "2013-09-02T23:59"}) EXPECT_TRUE(holds(periods, time));
  for (const char* time : {"2013-07-31", "2013-09-03"}) EXPECT_FALSE(holds(periods, time));
  EXPECT_FALSE(periods.block.totalling());
}

TEST(PeriodOptions, refuse_a_range_that_holds_no_time) {
  Periods periods;
  periods.read({"--from", "2014", "--to", "2013-12"});
  EXPECT_EQ(periods.contradiction(), "--from 2014 is after --to 2013-12");
  Periods same;
  same.read({"--from", "2013-12", "--to", "2013"});
  EXPECT_EQ(same.contradiction(), "");
}

TEST(PeriodOptions, law_1_totals_want_times_as_precise_as_their_periods) {
  const std::pair<const char*, TimePrecision> every[] = {
      {"day", TimePrecision::day}, {"month", TimePrecision::month}, {"year", TimePrecision::year}};
  for (const auto& [name, precision] : every) {
    Periods periods;
    periods.read({"--every", name, "--allow-missing", "2"});
    EXPECT_EQ(periods.contradiction(), "");
    EXPECT_EQ(periods.block.totalling().value().every.least_precision(), precision);
    EXPECT_EQ(periods.block.totalling().value().allowed_missing, 2U);
    EXPECT_EQ(periods.block.times().value().least, precision);
  }
  EXPECT_NE(Periods().refusal({"--every", "fortnight"}), "");
}

TEST(PeriodOptions, say_when_days_and_years_begin) {
  Periods periods;
  periods.read({"--every", "year", "--day-start", "09:00", "--year-start", "10"});
  EXPECT_EQ(periods.contradiction(), "");
  const Every every = periods.block.totalling().value().every;
  EXPECT_EQ(every.day_start, 32'400);
  EXPECT_TRUE(every.has_day_start);
  EXPECT_EQ(every.year_start, 10);
  EXPECT_EQ(periods.block.times().value().least, TimePrecision::instant);
}

// 2014-02-01 is day 16102; at eight o'clock the day that begins at nine is the one before.
TEST(PeriodOptions, count_hours_that_make_up_no_day_from_the_first_day_of_the_range) {
  Periods periods;
  periods.read({"--every", "36h", "--day-start", "09:00", "--from", "2014-02-01T08:00"});
  EXPECT_EQ(periods.block.totalling().value().every.first_day, 16'101);
}

TEST(PeriodOptions, refuse_what_the_periods_do_not_have) {
  const auto said = [](const std::vector<std::string>& words) {
    Periods periods;
    periods.read(words);
    return periods.contradiction();
  };
  EXPECT_EQ(said({"--day-start", "09:00"}),
            "--day-start is about the periods of --every that have days or hours");
  EXPECT_EQ(said({"--every", "storm", "--day-start", "09:00"}),
            "--day-start is about the periods of --every that have days or hours");
  EXPECT_EQ(said({"--every", "season", "--year-start", "2"}), "--year-start is about --every year");
  EXPECT_EQ(said({"--every", "day", "--dry", "6h"}), "--dry is about --every storm");
  EXPECT_EQ(said({"--every", "storm", "--dry", "2d"}), "");
}

TEST(PeriodOptions, allow_steps_to_be_missing_of_totals_alone) {
  Periods periods;
  periods.read({"--allow-missing", "0"});
  EXPECT_EQ(periods.contradiction(), "--allow-missing is about totals, and there is no --every");
}

TEST(PeriodOptions, may_be_the_range_alone) {
  Given<PeriodOptions> range;
  range.block.declare_range(range.options);
  EXPECT_EQ(range.refusal({"--every", "day"}), "unknown option '--every'");
  EXPECT_EQ(range.refusal({"--from", "2013"}), "");
  EXPECT_EQ(range.contradiction(), "");
}

TEST(PeriodOptions, take_from_the_readings_what_times_are_of_their_steps) {
  Periods untold;
  untold.read({"--every", "day"});
  untold.block.settle_stamp(Stamp::end, "r.nc");
  EXPECT_EQ(untold.block.totalling().value().stamp, Stamp::end);
  Periods unknown;
  unknown.read({"--every", "day", "--stamp", "end"});
  unknown.block.settle_stamp(std::nullopt, "r.csv");
  unknown.block.settle_stamp(Stamp::end, "r.nc");
  EXPECT_EQ(unknown.block.totalling().value().stamp, Stamp::end);
  EXPECT_TRUE(contains(complaint_of([&] { unknown.block.settle_stamp(Stamp::begin, "r.nc"); }),
                       "r.nc: it says that its times begin their steps"));
}

}  // namespace
}  // namespace thiessen::cli
