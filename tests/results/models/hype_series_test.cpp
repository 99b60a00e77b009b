#include "results/models/hype_series.h"

#include "results/models/model_subject.h"

namespace thiessen {
namespace {

TEST(HypeSeries, has_a_row_a_day_and_a_column_a_basin) {
  EXPECT_EQ(series_text<HypeSeries>(subject_of({"12", "7"}),
                                    {{"2020-02-28", {1.23456, 0}}, {"2020-02-29", {0.5, 10}}}),
            "date\t12\t7\n2020-02-28\t1.235\t0.000\n2020-02-29\t0.500\t10.000\n");
}

TEST(HypeSeries, has_a_clock_where_steps_are_shorter_and_dates_their_beginning) {
  const std::vector<GivenStep> steps{{"2020-01-01T06:00", {1}}, {"2020-01-01T12:00", {2}}};
  ModelSubject subject = subject_of({"1"});
  subject.decimals = 0;
  EXPECT_EQ(series_text<HypeSeries>(subject, steps),
            "date\t1\n2020-01-01 06:00\t1\n2020-01-01 12:00\t2\n");
  subject.stamp = Stamp::end;
  EXPECT_EQ(series_text<HypeSeries>(subject, steps),
            "date\t1\n2020-01-01 00:00\t1\n2020-01-01 06:00\t2\n");
}

TEST(HypeSeries, of_days_that_end_at_midnight_has_their_dates) {
  ModelSubject subject = subject_of({"1"});
  subject.stamp = Stamp::end;
  subject.decimals = 0;
  EXPECT_EQ(
      series_text<HypeSeries>(subject, {{"2020-01-02T00:00", {1}}, {"2020-01-02T24:00", {2}}}),
      "date\t1\n2020-01-01\t1\n2020-01-02\t2\n");
  // A date without a clock is its whole day either way.
  EXPECT_EQ(series_text<HypeSeries>(subject, {{"2020-01-02", {1}}, {"2020-01-03", {2}}}),
            "date\t1\n2020-01-02\t1\n2020-01-03\t2\n");
}

TEST(HypeSeries, writes_9999_for_what_is_missing_or_lacks_and_says_so) {
  Warnings told;
  EXPECT_EQ(series_text<HypeSeries>(
                subject_of({"1"}),
                {{"2020-01-01", {1}}, {"2020-01-02", {none}}, {"2020-01-04", {2}}}, told),
            "date\t1\n2020-01-01\t1.000\n2020-01-02\t-9999\n2020-01-03\t-9999\n"
            "2020-01-04\t2.000\n");
  EXPECT_EQ(sentences_of(told),
            (std::vector<std::string>{
                "r.csv: 1 step lacks between others, at 2020-01-03: -9999 stands there",
                "out: 2 values are missing and written as -9999, the first at 2020-01-02, and "
                "HYPE wants a value in every step that it simulates"}));
}

TEST(HypeSeries, is_by_the_clock_of_its_zone_and_says_so) {
  Warnings told;
  series_text<HypeSeries>(subject_of({"1"}),
                          {{"2020-01-01T00:00+05:30", {1}}, {"2020-01-01T01:00+05:30", {1}}}, told);
  ASSERT_EQ(told.notices().size(), 1);
  EXPECT_EQ(told.notices()[0].sentence(),
            "out: HYPE's Pobs.txt has no time zone: its times are by the clock of +05:30");
}

TEST(HypeSeries, refuses_ids_that_are_no_whole_numbers) {
  const std::vector<std::string> complaints = complaints_of([] {
    series_text<HypeSeries>(subject_of({"A", "1.5", "-1", "3000000000", "7", "007"}), {});
  });
  ASSERT_EQ(complaints.size(), 5);
  EXPECT_EQ(complaints[0],
            "out: the basin's id 'A' is no whole number up to 2147483647, as HYPE's Pobs.txt wants "
            "it | 'basin_id' names a field of such numbers");
  EXPECT_EQ(complaints[4],
            "out: the basins' ids '7' and '007' are one number in HYPE's Pobs.txt | 'basin_id' "
            "names a field of different numbers");
}

TEST(HypeSeries, refuses_another_unit) {
  ModelSubject subject = subject_of({"1"});
  subject.unit = "in";
  EXPECT_EQ(series_fault<HypeSeries>(subject, {}),
            "r.csv: the readings are in in, and HYPE's Pobs.txt wants mm | to_unit = mm brings "
            "them to it");
  subject.unit = "mm/h";
  EXPECT_TRUE(contains(series_fault<HypeSeries>(subject, {}), "this is a rate"));
}

TEST(HypeSeries, refuses_steps_that_it_cannot_hold) {
  const ModelSubject one = subject_of({"1"});
  const auto fault = [&](const std::vector<GivenStep>& steps) {
    return series_fault<HypeSeries>(one, steps);
  };
  EXPECT_EQ(fault({}), "r.csv: there is no time step to write");
  EXPECT_TRUE(contains(fault({{"2020-01", {1}}, {"2020-02", {1}}}),
                       "its steps are of 1 month, and HYPE's Pobs.txt wants steps of one length"));
  EXPECT_TRUE(contains(fault({{"2020-01-01", {1}}, {"2020-01-08", {1}}, {"2020-01-15", {1}}}),
                       "its steps are of 7 days"));
  EXPECT_TRUE(contains(fault({{"2020-01-01T00:00", {1}}, {"2020-01-01T05:00", {1}}}),
                       "its steps are of 5 hours"));
  EXPECT_TRUE(
      contains(fault({{"2020-01-01T00:00", {1}}}), "nothing tells how long its only step is"));
  EXPECT_TRUE(contains(fault({{"2020-01-01T09:00", {1}}, {"2020-01-02T09:00", {1}}}),
                       "its steps begin at 2020-01-01T09:00, and HYPE's Pobs.txt has dates"));
  EXPECT_TRUE(contains(fault({{"2020-01-02", {1}}, {"2020-01-01", {1}}}),
                       "the time 2020-01-01 does not come after the one before it"));
  EXPECT_TRUE(contains(fault({{"2020-01-01", {1}}, {"2020-01-02T00:00", {1}}}),
                       "some times have a clock and others have none"));
  EXPECT_TRUE(contains(fault({{"2020-01-01T00:00:00.5", {1}}}), "fractions of a second"));
}

TEST(HypeSeries, refuses_a_step_out_of_line_with_the_others) {
  std::vector<GivenStep> steps;
  for (const char* time : {"00", "01", "02", "03", "04", "05", "06", "07", "08", "09", "10"})
    steps.push_back({time, {1}});
  std::vector<std::string> texts;
  for (const GivenStep& step : steps)
    texts.push_back(std::string("2020-01-01T") + step.time + ":00");
  texts.back() = "2020-01-01T10:30";
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].time = texts[i].c_str();
  EXPECT_TRUE(contains(series_fault<HypeSeries>(subject_of({"1"}), steps),
                       "the step at 2020-01-01T10:30 is out of line with steps of 1 hour"));
}

}  // namespace
}  // namespace thiessen
