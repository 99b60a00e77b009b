// What fuzzers found in readings/, numbered on from room to room.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "base/iso_time.h"
#include "rainfall/network/network.h"
#include "readings/readings_grammar.h"
#include "readings/steps/mixed_steps.h"
#include "readings/times/time_format.h"

namespace thiessen {
namespace {

TEST(ReadingGrammar, finding_4_takes_a_gap_as_written_beside_decimal_commas) {
  const std::vector<std::string> missing = {"0.51"};
  const ReadingGrammar grammar(missing, {}, DecimalMark::comma);
  for (const char* gap : {"0.51", "0,51", "-99.9", "-99,9"})
    EXPECT_EQ(grammar.read(gap, false).kind, ReadingKind::missing) << gap;
  EXPECT_EQ(grammar.read("0.52", false).kind, ReadingKind::not_a_number);
}

// B reads on the days 1, 3 and 11: on three of the six odd days from the first to the last, which
// is not more than half, whatever the order.
TEST(MixedSteps, finding_6_counts_a_gauges_places_from_its_earliest_reading_to_its_latest) {
  const std::vector<Station> stations = {{"A", {}}, {"B", {}}};
  constexpr double silent = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array in_order = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  constexpr std::array scattered = {1, 11, 3, 2, 4, 5, 6, 7, 8, 9, 10};
  for (const std::array<int, 11>& days : {in_order, scattered}) {
    MixedSteps steps(stations.size());
    for (const int day : days) {
      const std::string time = (day < 10 ? "2020-01-0" : "2020-01-") + std::to_string(day);
      const bool reads = day == 1 || day == 3 || day == 11;
      const std::array<double, 2> readings = {1, reads ? 1 : silent};
      steps.note(time, 0, readings);
    }
    EXPECT_FALSE(steps.fault("r.csv", stations));
  }
}

// The library of dates negates the least of all numbers, and converts seconds that it has not read.
TEST(TimeFormat, finding_13_refuses_a_zone_without_digits_and_a_time_without_seconds) {
  EXPECT_EQ(TimeFormat("%m-%Y %H %z %d").read("5-9999 2-x").fault, IsoTimeFault::form);
  EXPECT_EQ(TimeFormat("%Y%m%d%H%M%S").read("99999999999").fault, IsoTimeFault::form);
  EXPECT_EQ(TimeFormat("%Y-%m-%d %H:%M:%S").read("2020-01-01 10:00:").fault, IsoTimeFault::form);
}

}  // namespace
}  // namespace thiessen
