#include "rainfall/series/rain_totals.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

std::string names(const Every& every) {
  std::string text;
  Totalling totalling;
  totalling.every = every;
  const auto totals =
      totals_of(totalling, "r.csv", [&](const RainPeriod& period) { text += period.time + ' '; });
  for (const char* time : {"2020-05-01T00:00", "2020-05-01T12:00", "2020-05-02T00:00"})
    totals->add({time, {}, {{std::string(time).ends_with("01T12:00") ? 1.0 : 0.0, 1, 1}}, {}});
  Warnings warnings;
  totals->finish(warnings);
  return text;
}

TEST(RainTotals, are_of_the_calendar_or_of_storms) {
  EXPECT_EQ(names(PeriodUnit::day), "2020-05-01 2020-05-02 ");
  EXPECT_EQ(names(PeriodUnit::storm), "2020-05-01T12:00 ");
}

TEST(RainTotals, know_how_long_periods_are) {
  Every hours = PeriodUnit::hours;
  hours.hours = 6;
  EXPECT_EQ(length_of(hours), (StepLength{0, 21'600}));
  EXPECT_EQ(length_of(PeriodUnit::week), (StepLength{0, 604'800}));
  EXPECT_EQ(length_of(PeriodUnit::season), (StepLength{3, 0}));
  EXPECT_EQ(length_of(PeriodUnit::year), (StepLength{12, 0}));
  EXPECT_FALSE(length_of(PeriodUnit::storm));
}

}  // namespace
}  // namespace thiessen
