#include "results/models/series_times.h"

#include "base/complaints.h"

namespace thiessen {
namespace {

IsoTime at(const char* text) {
  return parse_iso_time(text).time;
}

SeriesTimes times_of(const std::vector<const char*>& texts) {
  SeriesTimes times("r.csv", "a model");
  for (const char* text : texts) times.note(at(text));
  return times;
}

TEST(SeriesTimes, tell_the_step_of_several_and_of_one_that_names_its_own) {
  EXPECT_EQ(times_of({"2020-01-01", "2020-01-02", "2020-01-04"}).step(), (StepLength{0, 86'400}));
  EXPECT_EQ(times_of({"2020-01", "2020-02"}).step(), (StepLength{1, 0}));
  EXPECT_EQ(times_of({"2020-01-01"}).step(), (StepLength{0, 86'400}));
  EXPECT_EQ(times_of({"2020-01"}).step(), (StepLength{1, 0}));
  EXPECT_EQ(times_of({"2020"}).step(), (StepLength{12, 0}));
  EXPECT_FALSE(times_of({"2020-01-01T06:00"}).step());
}

TEST(SeriesTimes, count_seconds_by_the_clock_of_the_first_zone) {
  const SeriesTimes times = times_of({"1970-01-01T06:00+02:00", "1970-01-01T06:00+01:00"});
  EXPECT_EQ(times.zone(), 120);
  EXPECT_EQ(times.seconds_of(at("1970-01-01T06:00+02:00")), 6 * 3600);
  EXPECT_EQ(times.seconds_of(at("1970-01-01T06:00+01:00")), 7 * 3600);
  EXPECT_EQ(times_of({"1970-01-01T06:00"}).seconds_of(at("1970-01-01T07:00")), 7 * 3600);
}

TEST(SeriesTimes, have_all_a_zone_or_none) {
  EXPECT_EQ(complaint_of([] {
              times_of({"2020-01-01T00:00Z", "2020-01-01T01:00"});
            }),
            "r.csv: some times have a zone and others have none, and a model counts from one | a "
            "CSV takes any times");
}

TEST(SeriesTimes, are_of_the_calendar) {
  EXPECT_EQ(calendar_time_for("a model", "2020-01-02", {}, "r.csv", 3).day, 2);
  EXPECT_EQ(complaint_of([] { calendar_time_for("a model", "week 3", {}, "r.csv", 3); }),
            "r.csv:3: the time 'week 3' is none of the calendar, and a model wants one | "
            "'time_format' says how times are written; a CSV takes any");
  const WrittenTime two{{}, " is 1 February or 2 January", "say which", false};
  EXPECT_EQ(complaint_of([&] { calendar_time_for("a model", "01/02/2020", two, "r.csv", 3); }),
            "r.csv:3: the time '01/02/2020' is 1 February or 2 January | say which");
}

TEST(SeriesTimes, name_a_zone_as_iso_8601_does) {
  EXPECT_EQ(zone_text(0), "Z");
  EXPECT_EQ(zone_text(330), "+05:30");
  EXPECT_EQ(zone_text(-180), "-03:00");
}

}  // namespace
}  // namespace thiessen
