#include "rainfall/normals/calendar_normals.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two places of which the second has twice the rain, with months of their own.
CalendarNormals years(int count) {
  CalendarNormals normals(2);
  for (int year = 0; year < count; ++year) {
    for (std::size_t month = 0; month < 12; ++month) {
      const double rain = static_cast<double>(month + 1);
      normals.add(std::vector<double>{rain, 2 * rain}, MonthOfYear{1990 + year, month});
    }
  }
  return normals;
}

TEST(CalendarNormals, tell_the_year_and_its_months) {
  const CalendarNormals normals = years(2);
  EXPECT_EQ(normals.of_year(), (std::vector<double>{6.5, 13}));
  EXPECT_EQ(normals.of_month(0), (std::vector<double>{1, 2}));
  EXPECT_EQ(normals.of_month(11), (std::vector<double>{12, 24}));
}

TEST(CalendarNormals, want_ten_years_of_each_month) {
  EXPECT_EQ(years(10).places_with_enough_years(), 2);
  EXPECT_EQ(years(9).places_with_enough_years(), 0);
  // Several steps of one month are one year of it.
  CalendarNormals daily = years(9);
  for (std::size_t month = 0; month < 12; ++month)
    daily.add(std::vector<double>{1, 2}, MonthOfYear{1998, month});
  EXPECT_EQ(daily.places_with_enough_years(), 0);
  // The second place lacks a tenth June.
  CalendarNormals gap = years(9);
  for (std::size_t month = 0; month < 12; ++month)
    gap.add(std::vector<double>{1, month == 5 ? none : 2}, MonthOfYear{1999, month});
  EXPECT_EQ(gap.places_with_enough_years(), 1);
}

TEST(CalendarNormals, have_no_months_where_a_time_tells_none) {
  CalendarNormals normals = years(10);
  normals.add(std::vector<double>{6.5, 13}, std::nullopt);
  EXPECT_EQ(normals.places_with_enough_years(), 0);
  EXPECT_EQ(normals.of_year(), (std::vector<double>{6.5, 13}));
}

}  // namespace
}  // namespace thiessen
