// The searches that look at whole gauges: unit, shift and break.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rainfall/findings/break_search.h"
#include "rainfall/findings/ring_of_gauges.h"
#include "rainfall/findings/shift_search.h"
#include "rainfall/findings/unit_search.h"

namespace thiessen {
namespace {

using Steps = std::vector<std::vector<double>>;

std::vector<ReadingFinding> concluded(FindingSearch& search) {
  std::vector<ReadingFinding> found;
  search.conclude([&](ReadingFinding finding) { found.push_back(std::move(finding)); });
  return found;
}

std::vector<ReadingFinding> units(const GaugeNeighbours& neighbours, const Steps& steps) {
  NeighbourTotals totals(neighbours);
  for_each_stretch(steps, 2000, [&](const Stretch& stretch) { totals.add(stretch); });
  UnitSearch search(totals);
  return concluded(search);
}

TEST(UnitSearch, finds_a_gauge_with_more_than_four_times_the_rain_of_its_neighbours) {
  const GaugeNeighbours ring = ring_of(4);
  const auto found = units(ring, Steps(30, {25.4, 1, 1, 1, 1}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].station, StationIndex{0});
  EXPECT_EQ(found[0].kind, FindingKind::unit);
  EXPECT_EQ(found[0].time, "");
  EXPECT_NEAR(found[0].value, 25.4, 1e-6);
  EXPECT_EQ(found[0].expected, 1);
  EXPECT_TRUE(units(ring, Steps(30, {4, 1, 1, 1, 1})).empty());
  EXPECT_EQ(units(ring, Steps(30, {0.24, 1, 1, 1, 1})).size(), 1u);
  EXPECT_EQ(units(ring, Steps(30, {0, 1, 1, 1, 1})).size(), 1u);
}

TEST(UnitSearch, wants_thirty_steps_with_rain) {
  const GaugeNeighbours ring = ring_of(4);
  Steps steps(29, {25.4, 1, 1, 1, 1});
  steps.resize(300, {0, 0, 0, 0, 0});
  EXPECT_TRUE(units(ring, steps).empty());
}

TEST(UnitSearch, sums_over_the_steps_at_which_both_report) {
  // Gauge 0 is silent in the wet half of the record, in which its neighbours have all they have
  // beyond it.
  const GaugeNeighbours ring = ring_of(4);
  Steps steps(200, {1, 1, 1, 1, 1});
  for (std::size_t i = 0; i < 100; ++i) steps[2 * i] = {silent, 50, 50, 50, 50};
  EXPECT_TRUE(units(ring, steps).empty());
}

/// Rain that falls at each step, or not, everywhere alike.
std::vector<double> rain_of(std::uint32_t seed, std::size_t steps) {
  std::mt19937 random(seed);
  std::vector<double> rain(steps);
  for (double& amount : rain) {
    const auto draw = static_cast<double>(random()) / 4294967296.0;
    amount = draw < 0.3 ? 20 * draw : 0;
  }
  return rain;
}

Steps with_first_moved(const std::vector<double>& rain, int by) {
  Steps steps;
  for (std::size_t i = 1; i + 1 < rain.size(); ++i) {
    const double moved = rain[i - static_cast<std::size_t>(by)];
    steps.push_back({moved, rain[i], rain[i], rain[i], rain[i]});
  }
  return steps;
}

std::vector<ReadingFinding> shifts(const Steps& steps, bool descends = false) {
  const GaugeNeighbours ring = ring_of(4);
  ShiftSearch search(ring);
  for_each_stretch(steps, 2000, [&](const Stretch& stretch) {
    Stretch turned = stretch;
    turned.set_descends(descends);
    search.see(turned);
  });
  return concluded(search);
}

TEST(ShiftSearch, finds_a_series_that_is_a_step_late_or_early) {
  const std::vector<double> rain = rain_of(1, 400);
  const auto late = shifts(with_first_moved(rain, 1));
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].station, StationIndex{0});
  EXPECT_EQ(late[0].kind, FindingKind::shift);
  EXPECT_EQ(late[0].value, 1);
  EXPECT_EQ(late[0].expected, 0);
  const auto early = shifts(with_first_moved(rain, -1));
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(early[0].value, -1);
  EXPECT_TRUE(shifts(with_first_moved(rain, 0)).empty());
}

TEST(ShiftSearch, minds_in_which_direction_time_goes) {
  const auto found = shifts(with_first_moved(rain_of(1, 400), 1), true);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].value, -1);
}

TEST(ShiftSearch, wants_120_steps_at_which_both_report) {
  EXPECT_TRUE(shifts(with_first_moved(rain_of(1, 121), 1)).empty());
  EXPECT_EQ(shifts(with_first_moved(rain_of(1, 122), 1)).size(), 1u);
}

TEST(ShiftSearch, passes_over_silence) {
  Steps steps = with_first_moved(rain_of(2, 600), 1);
  for (std::size_t i = 0; i < steps.size(); i += 7) steps[i][0] = silent;
  for (std::size_t i = 3; i < steps.size(); i += 11) steps[i][2] = silent;
  const auto found = shifts(steps);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].value, 1);
}

std::vector<ReadingFinding> breaks(const std::vector<double>& first_of_years,
                                   std::size_t silent_from = 1000) {
  const GaugeNeighbours ring = ring_of(4);
  NeighbourTotals totals(ring);
  for (std::size_t y = 0; y < first_of_years.size(); ++y) {
    // The neighbours differ a little from year to year, and none of them alike.
    const double odd = y % 2 == 0 ? 1.02 : 0.98;
    const std::vector<double> year{y < silent_from ? first_of_years[y] : silent, odd, 1 / odd, 1,
                                   1};
    for_each_stretch(Steps(10, year), 1980 + static_cast<int>(y),
                     [&](const Stretch& stretch) { totals.add(stretch); });
  }
  BreakSearch search(totals);
  return concluded(search);
}

std::vector<double> doubled_from(std::size_t year, std::size_t years, double factor) {
  std::vector<double> values(years, 1.0);
  for (std::size_t y = year; y < years; ++y) values[y] = factor;
  return values;
}

TEST(BreakSearch, finds_a_gauge_that_catches_more_from_some_year_on) {
  const auto found = breaks(doubled_from(8, 20, 1.5));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].station, StationIndex{0});
  EXPECT_EQ(found[0].kind, FindingKind::jump);
  EXPECT_EQ(found[0].since, 1988);
  EXPECT_NEAR(found[0].value, 1.5, 0.05);
  EXPECT_EQ(found[0].expected, 1);
}

TEST(BreakSearch, wants_15_years_and_a_fifth) {
  EXPECT_EQ(breaks(doubled_from(7, 15, 1.5)).size(), 1u);
  EXPECT_TRUE(breaks(doubled_from(7, 14, 1.5)).empty());
  EXPECT_TRUE(breaks(doubled_from(8, 20, 1.15)).empty());
  EXPECT_EQ(breaks(doubled_from(8, 20, 1 / 1.5)).size(), 1u);
}

TEST(BreakSearch, counts_years_in_which_the_gauge_reports) {
  EXPECT_EQ(breaks(doubled_from(7, 20, 1.5), 15).size(), 1u);
  EXPECT_TRUE(breaks(doubled_from(7, 20, 1.5), 14).empty());
}

}  // namespace
}  // namespace thiessen
