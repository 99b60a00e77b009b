#include "text/known_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

using Names = std::span<const std::string_view>;

const std::vector<Names> all_lists = {known::station_ids, known::eastings,  known::northings,
                                      known::degrees,     known::basin_ids, known::times,
                                      known::values,      known::gaps};

bool holds(Names names, std::string_view name) {
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view one) { return equal_ignoring_case(one, name); });
}

void expect_apart(Names a, Names b) {
  for (const std::string_view name : a) EXPECT_FALSE(holds(b, name)) << name;
}

TEST(KnownNames, law_1_no_list_has_a_name_twice_or_with_blanks_at_its_ends) {
  for (const Names names : all_lists) {
    std::set<std::string> seen;
    for (const std::string_view name : names) {
      EXPECT_TRUE(seen.insert(lower_case(name)).second) << name;
      EXPECT_EQ(trimmed(name), name);
      EXPECT_FALSE(name.empty());
    }
  }
}

// One column would else be found for two things.
TEST(KnownNames, law_2_what_is_looked_for_in_one_table_has_no_name_in_common) {
  expect_apart(known::eastings, known::northings);
  for (const Names coordinates : {Names(known::eastings), Names(known::northings)}) {
    expect_apart(known::station_ids, coordinates);
  }
  expect_apart(known::times, known::station_ids);
  expect_apart(known::times, known::values);
  expect_apart(known::values, known::station_ids);
}

TEST(KnownNames, law_3_degrees_are_eastings_or_northings_and_lengths_are_none) {
  for (const std::string_view name : known::degrees)
    EXPECT_TRUE(holds(known::eastings, name) || holds(known::northings, name)) << name;
  for (const char* name : {"x", "y", "easting", "northing"})
    EXPECT_FALSE(holds(known::degrees, name)) << name;
}

// A gap that could be an amount of rain would make rain vanish.
TEST(KnownNames, law_4_a_gap_that_is_a_number_is_below_0) {
  std::size_t numbers = 0;
  for (const std::string_view gap : known::gaps) {
    const auto number = parse_number(gap);
    if (!number) continue;
    ++numbers;
    EXPECT_LT(number.value, 0) << gap;
  }
  EXPECT_EQ(numbers, 3U);
}

TEST(KnownNames, are_those_that_users_are_promised) {
  for (const char* name : {"id", "station", "gauge", "name"})
    EXPECT_TRUE(holds(known::station_ids, name)) << name;
  for (const char* name : {"time", "date", "datetime"})
    EXPECT_TRUE(holds(known::times, name)) << name;
  for (const char* name : {"value", "rain", "rainfall", "precipitation", "prcp", "precip", "p"})
    EXPECT_TRUE(holds(known::values, name)) << name;
}

}  // namespace
}  // namespace thiessen
