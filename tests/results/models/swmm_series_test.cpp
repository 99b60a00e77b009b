#include "results/models/swmm_series.h"

#include "results/models/model_subject.h"

namespace thiessen {
namespace {

TEST(SwmmSeries, has_a_line_for_rain_and_for_the_first_step) {
  Warnings told;
  EXPECT_EQ(series_text<SwmmSeries>(subject_of({"east", "west"}),
                                    {{"2020-01-01T00:00", {0, 0.25}},
                                     {"2020-01-01T00:05", {1, 0.0001}},
                                     {"2020-01-01T00:10", {0, 2}}},
                                    told),
            "east 2020 01 01 00 00 0.000\nwest 2020 01 01 00 00 0.250\n"
            "east 2020 01 01 00 05 1.000\nwest 2020 01 01 00 10 2.000\n");
  ASSERT_EQ(told.notices().size(), 1);
  EXPECT_EQ(told.notices()[0].sentence(),
            "out: in [RAINGAGES] it is of VOLUME, interval 0:05, units MM; a step without a line "
            "is dry");
}

// 0.0001 and 0.0003 are less than half of the third decimal.
TEST(SwmmSeries, warns_of_rain_that_its_decimals_lose) {
  Warnings told;
  ModelSubject subject = subject_of({"a"});
  subject.unit = "in";
  series_text<SwmmSeries>(subject,
                          {{"2020-01-01T00:00", {0.0001}},
                           {"2020-01-01T01:00", {0.0003}},
                           {"2020-01-01T02:00", {0}},
                           {"2020-01-01T03:00", {0.0006}}},
                          told);
  ASSERT_EQ(told.messages().size(), 1);
  EXPECT_EQ(told.messages()[0].sentence(),
            "out: 2 values above 0 are 0 to 3 decimals and so dry in it, 0.00040 in in all");
}

TEST(SwmmSeries, of_inches_an_hour_is_of_intensity) {
  Warnings told;
  ModelSubject subject = subject_of({"a"});
  subject.unit = "in/h";
  series_text<SwmmSeries>(subject, {{"2020-01-01", {1}}, {"2020-01-02", {1}}}, told);
  EXPECT_TRUE(contains(told.notices()[0].sentence(), "of INTENSITY, interval 24:00, units IN"));
  subject.unit = "ft";
  EXPECT_TRUE(contains(series_fault<SwmmSeries>(subject, {}), "a rain file of SWMM wants mm"));
}

TEST(SwmmSeries, dates_a_step_by_its_beginning) {
  ModelSubject subject = subject_of({"a"});
  subject.stamp = Stamp::end;
  EXPECT_EQ(
      series_text<SwmmSeries>(subject, {{"2020-01-01T00:00", {1}}, {"2020-01-01T01:00", {2}}}),
      "a 2019 12 31 23 00 1.000\na 2020 01 01 00 00 2.000\n");
}

TEST(SwmmSeries, refuses_what_would_be_dry) {
  EXPECT_EQ(
      series_fault<SwmmSeries>(subject_of({"a"}), {{"2020-01-01", {1}}, {"2020-01-02", {none}}}),
      "r.csv: basin 'a' has no rainfall at 2020-01-02T00:00, and a rain file of SWMM cannot "
      "say so: a step without a line is dry | 'from' and 'to' choose steps that have values");
  EXPECT_TRUE(contains(
      series_fault<SwmmSeries>(subject_of({"a"}),
                               {{"2020-01-01", {1}}, {"2020-01-02", {1}}, {"2020-01-04", {1}}}),
      "no rainfall at 2020-01-03"))
      << "a step that lacks would be dry, too";
}

TEST(SwmmSeries, refuses_ids_that_are_no_words) {
  const auto complaints = complaints_of([] {
    series_text<SwmmSeries>(subject_of({"a b", "a;b", "", "A", "a", "\"q\""}), {});
  });
  ASSERT_EQ(complaints.size(), 5);
  EXPECT_TRUE(contains(complaints[0], "'a b' is no word"));
  EXPECT_TRUE(contains(complaints[3], "ids 'A' and 'a' are one to SWMM"));
}

}  // namespace
}  // namespace thiessen
