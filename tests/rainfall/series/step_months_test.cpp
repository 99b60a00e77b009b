#include "rainfall/series/step_months.h"

#include <gtest/gtest.h>

#include <optional>

#include "base/error.h"

namespace thiessen {
namespace {

TEST(StepMonths, are_those_that_times_say) {
  const StepMonths months("rain.csv", Stamp::begin);
  EXPECT_EQ(months.of("2014-01", {}, 2), 0u);
  EXPECT_EQ(months.of("2014-12-31T23:00", {}, 2), 11u);
  EXPECT_EQ(months.of("2014-02-01T00:00", {}, 2), 1u);
}

TEST(StepMonths, of_times_that_end_steps_are_those_before_midnight) {
  const StepMonths months("rain.csv", Stamp::end);
  EXPECT_EQ(months.of("2014-02-01T00:00", {}, 2), 0u);
  EXPECT_EQ(months.of("2014-01-01T00:00", {}, 2), 11u);
  EXPECT_EQ(months.of("2014-02-01T01:00", {}, 2), 1u);
  EXPECT_EQ(months.of("2014-02", {}, 2), 1u);
}

TEST(StepMonths, years_are_those_before_midnight_too) {
  EXPECT_EQ(year_of("2014-01-01T00:00", {}, Stamp::end), 2013);
  EXPECT_EQ(year_of("2014-01-01T00:00", {}, Stamp::begin), 2014);
  EXPECT_EQ(year_of("2014", {}, Stamp::end), 2014);
  EXPECT_EQ(year_of("flood", {}, Stamp::begin), std::nullopt);
}

TEST(StepMonths, are_not_told_by_years_and_labels) {
  const StepMonths months("rain.csv", Stamp::begin);
  EXPECT_THROW(months.of("2014", {}, 2), Error);
  try {
    months.of("flood", {}, 7);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.messages().front().line, 7u);
  }
}

}  // namespace
}  // namespace thiessen
