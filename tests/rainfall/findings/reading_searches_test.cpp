#include "rainfall/findings/reading_searches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/iso_time.h"
#include "rainfall/findings/ring_of_gauges.h"
#include "rainfall/network/network_dual.h"

namespace thiessen {
namespace {

constexpr std::int64_t hour = 3600;
constexpr std::int64_t day = 24 * hour;

using Table = std::vector<std::vector<double>>;

std::vector<ReadingFinding> findings_of(const GaugeNeighbours& neighbours, const Table& table,
                                        std::int64_t step, AmountMeaning meaning = {},
                                        std::map<FindingKind, std::string>* reasons = nullptr) {
  ReadingSearches searches(neighbours, meaning);
  const TimePrecision precision = step < day ? TimePrecision::instant : TimePrecision::day;
  for (std::size_t i = 0; i < table.size(); ++i) {
    TimeStep one{time_text(static_cast<std::int64_t>(i) * step, precision), table[i]};
    searches.see(one);
  }
  std::vector<ReadingFinding> found;
  searches.conclude([&](ReadingFinding finding) { found.push_back(std::move(finding)); });
  for (const FindingKind kind : all_findings) {
    if (reasons != nullptr) (*reasons)[kind] = searches.reason_against(kind);
  }
  return found;
}

std::size_t count_of(const std::vector<ReadingFinding>& found, FindingKind kind) {
  return static_cast<std::size_t>(std::count_if(
      found.begin(), found.end(), [&](const ReadingFinding& one) { return one.kind == kind; }));
}

/// Hours without rain, but for what the first gauge and the others read at one of them.
Table hours_with(double first, double others) {
  Table table(48, std::vector<double>(6, 0.0));
  table[20].assign(6, others);
  table[20][0] = first;
  return table;
}

TEST(ReadingSearches, bound_a_spike_of_an_hour_by_10_mm) {
  const GaugeNeighbours ring = ring_of(5);
  EXPECT_EQ(findings_of(ring, hours_with(10, 0), hour).size(), 0u);
  const auto found = findings_of(ring, hours_with(10.1, 0), hour);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].time, "1970-01-01T20:00");
  EXPECT_EQ(findings_of(ring, hours_with(16, 2), hour).size(), 0u);
  EXPECT_EQ(findings_of(ring, hours_with(16.1, 2), hour).size(), 1u);
}

TEST(ReadingSearches, take_their_bounds_to_the_unit_of_the_readings) {
  const GaugeNeighbours ring = ring_of(5);
  const AmountMeaning inches{25.4, std::nullopt};
  EXPECT_EQ(findings_of(ring, hours_with(0.40, 0), hour, inches).size(), 1u);  // 10.16 mm
  EXPECT_EQ(findings_of(ring, hours_with(0.39, 0), hour, inches).size(), 0u);  // 9.906 mm
  EXPECT_EQ(findings_of(ring, hours_with(0, 0.20), hour, inches).size(), 1u);  // 5.08 mm, and 0
  EXPECT_EQ(findings_of(ring, hours_with(0, 0.19), hour, inches).size(), 0u);
  // 60 mm/h for ten minutes are 10 mm.
  const AmountMeaning rates{1, StepLength{0, hour}};
  EXPECT_EQ(findings_of(ring, hours_with(60.1, 0), hour / 6, rates).size(), 1u);
  EXPECT_EQ(findings_of(ring, hours_with(59.9, 0), hour / 6, rates).size(), 0u);
}

TEST(ReadingSearches, count_equal_readings_by_the_length_of_the_steps) {
  const GaugeNeighbours ring = ring_of(5);
  const auto equal = [&](std::size_t steps, std::int64_t step) {
    Table table(200, std::vector<double>(6, 0.0));
    for (std::size_t i = 0; i < steps; ++i) table[100 + i][0] = 0.2;
    return count_of(findings_of(ring, table, step), FindingKind::stuck);
  };
  EXPECT_EQ(equal(4, day), 0u);
  EXPECT_EQ(equal(5, day), 5u);
  EXPECT_EQ(equal(11, hour), 0u);
  EXPECT_EQ(equal(12, hour), 12u);
  EXPECT_EQ(equal(71, hour / 6), 0u);
  EXPECT_EQ(equal(72, hour / 6), 72u);
  EXPECT_EQ(equal(12, 3 * hour), 12u);
}

TEST(ReadingSearches, say_what_is_not_looked_for) {
  using Reasons = std::map<FindingKind, std::string>;
  Reasons reasons;
  const GaugeNeighbours ring = ring_of(5);
  const Table table(70, std::vector<double>(6, 1.0));
  findings_of(ring, table, hour, {}, &reasons);
  EXPECT_EQ(reasons, (Reasons{{FindingKind::spike, ""},
                              {FindingKind::zero, ""},
                              {FindingKind::stuck, ""},
                              {FindingKind::unit, ""},
                              {FindingKind::shift, "wants steps of a day"},
                              {FindingKind::jump, "wants 15 years"}}));
  findings_of(ring, table, 7 * day, {}, &reasons);
  EXPECT_EQ(reasons[FindingKind::spike], "wants steps of a day or less");
  EXPECT_EQ(reasons[FindingKind::stuck], "wants steps of a day or less");
  EXPECT_EQ(reasons[FindingKind::unit], "");
  const GaugeNeighbours few = ring_of(3);
  EXPECT_EQ(findings_of(few, Table(70, std::vector<double>(4, 1.0)), day, {}, &reasons).size(),
            280u);  // all of which are stuck
  EXPECT_EQ(reasons[FindingKind::spike], "wants 5 gauges");
  EXPECT_EQ(reasons[FindingKind::unit], "wants 5 gauges");
  EXPECT_EQ(reasons[FindingKind::stuck], "");
}

TEST(ReadingSearches, are_content_with_labels_and_with_nothing) {
  const GaugeNeighbours ring = ring_of(5);
  ReadingSearches searches(ring, {});
  const std::vector<double> readings{25.4, 1, 1, 1, 1, 1};
  for (int i = 0; i < 100; ++i) searches.see({"storm " + std::to_string(i), readings});
  std::vector<FindingKind> kinds;
  searches.conclude([&](const ReadingFinding& found) { kinds.push_back(found.kind); });
  EXPECT_EQ(kinds, std::vector<FindingKind>{FindingKind::unit});
  EXPECT_EQ(searches.reason_against(FindingKind::spike), "wants steps of one length");
  ReadingSearches none(ring, {});
  none.conclude([](const ReadingFinding&) { FAIL(); });
}

TEST(ReadingSearches, tell_of_a_gauge_in_another_unit_once) {
  const GaugeNeighbours ring = ring_of(5);
  Table table(400, std::vector<double>(6, 0.0));
  for (std::size_t i = 0; i < table.size(); i += 2) {
    table[i].assign(6, 1.0 + static_cast<double>(i % 14));
    table[i][0] *= 25.4;
  }
  const auto found = findings_of(ring, table, day);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, FindingKind::unit);
}

/// Days of rain over a square of gauges: a third of them are wet, with three showers each, whose
/// sums are as alike in neighbours as those of Colorado are.
class SimulatedDays {
 public:
  SimulatedDays(std::uint32_t seed, std::size_t side, std::size_t days) : random_(seed) {
    std::vector<Station> stations;
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto column = static_cast<double>(i % side);
      const auto row = static_cast<double>(i / side);
      stations.push_back({std::to_string(i), {column + 0.7 * draw(), row + 0.7 * draw()}});
    }
    network_.emplace(stations, Metric::planar);
    for (std::size_t i = 0; i < days; ++i) table_.push_back(day(static_cast<double>(side)));
  }

  GaugeNeighbours neighbours() const {
    const ReportingStations all(network_->stations().size(), true);
    return {*network_, network_dual(*network_, all, {}, 1).borders};
  }
  Table& table() { return table_; }
  double draw() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  std::size_t draw_below(std::size_t end) {
    return static_cast<std::size_t>(draw() * static_cast<double>(end));
  }

 private:
  double normal() {
    return std::sqrt(-2 * std::log(draw())) * std::cos(2 * 3.141592653589793 * draw());
  }
  std::vector<double> day(double side) {
    std::vector<double> readings(network_->stations().size(), 0.0);
    if (draw() > 0.35) return readings;
    for (int shower = 0; shower < 3; ++shower) {
      const Point centre{side * draw(), side * draw()};
      const double depth = 8 * std::exp(0.8 * normal());
      const double width = side * (0.15 + 0.35 * draw());
      for (std::size_t g = 0; g < readings.size(); ++g) {
        const Point at = network_->stations()[g].position;
        const double x = (at.x - centre.x) / width;
        const double y = (at.y - centre.y) / width;
        readings[g] += depth * std::exp(-x * x - y * y);
      }
    }
    for (double& reading : readings) {
      reading = std::max(0.0, reading * std::exp(0.3 * normal()) - 1);
      reading = std::round(10 * reading) / 10;
    }
    return readings;
  }

  std::mt19937 random_;
  std::optional<Network> network_;
  Table table_;
};

constexpr std::size_t gauges = 49;
constexpr std::size_t days_of_30_years = 10'958;

std::set<std::pair<StationIndex, std::string>> places_of(const std::vector<ReadingFinding>& found,
                                                         FindingKind kind) {
  std::set<std::pair<StationIndex, std::string>> places;
  for (const ReadingFinding& one : found) {
    if (one.kind == kind) places.insert({one.station, one.time});
  }
  return places;
}

std::string day_text(std::size_t step) {
  return time_text(static_cast<std::int64_t>(step) * day, TimePrecision::day);
}

TEST(PlantedFaults, are_few_where_none_is_planted) {
  for (const std::uint32_t seed : {1u, 2u}) {
    SimulatedDays days(seed, 7, days_of_30_years);
    const auto found = findings_of(days.neighbours(), days.table(), day);
    const double gauge_years = 30.0 * gauges;
    EXPECT_LE(static_cast<double>(count_of(found, FindingKind::spike)), 0.03 * gauge_years);
    EXPECT_LE(static_cast<double>(count_of(found, FindingKind::zero)), 0.3 * gauge_years);
    EXPECT_LE(static_cast<double>(count_of(found, FindingKind::stuck)), 0.01 * gauge_years);
    EXPECT_EQ(count_of(found, FindingKind::unit), 0u);
    EXPECT_LE(count_of(found, FindingKind::shift), 2u);  // 6 % are 2.9
    EXPECT_LE(count_of(found, FindingKind::jump), 1u);   // 4 % are 2.0
  }
}

TEST(PlantedFaults, of_single_readings_are_found) {
  for (const std::uint32_t seed : {3u, 4u}) {
    SimulatedDays days(seed, 7, 3'653);
    const GaugeNeighbours neighbours = days.neighbours();
    Table& table = days.table();
    std::set<std::pair<StationIndex, std::string>> spikes;
    std::set<std::pair<StationIndex, std::string>> stuck;
    for (std::size_t step = 20; step + 20 < table.size(); step += 20) {
      const std::size_t gauge = days.draw_below(gauges);
      const StationIndex station{static_cast<std::uint32_t>(gauge)};
      if (step % 80 == 0) {
        for (std::size_t i = step; i < step + 15; ++i) {
          table[i][gauge] = 1.3;
          stuck.insert({station, day_text(i)});
        }
      } else if (table[step][gauge] == 0) {
        table[step][gauge] = 100;
        spikes.insert({station, day_text(step)});
      }
    }
    const auto found = findings_of(neighbours, table, day);
    const auto told = places_of(found, FindingKind::spike);
    const auto hit = std::count_if(spikes.begin(), spikes.end(),
                                   [&](const auto& place) { return told.contains(place); });
    EXPECT_GE(static_cast<double>(hit), 0.95 * static_cast<double>(spikes.size()));
    const auto held = places_of(found, FindingKind::stuck);
    EXPECT_TRUE(std::includes(held.begin(), held.end(), stuck.begin(), stuck.end()));
  }
}

TEST(PlantedFaults, of_whole_gauges_are_found) {
  std::size_t units = 0;
  std::size_t shifts = 0;
  std::size_t breaks = 0;
  std::size_t planted = 0;
  for (const std::uint32_t seed : {5u, 6u}) {
    SimulatedDays days(seed, 7, days_of_30_years);
    const GaugeNeighbours neighbours = days.neighbours();
    Table& table = days.table();
    const std::size_t of_unit = 7 * (seed % 3);  // in three rows of the square
    const std::size_t of_shift = of_unit + 14 + 3;
    const std::size_t of_break = of_unit + 28 + 6;
    for (std::size_t step = table.size(); step-- > 0;) {
      table[step][of_unit] *= 10;
      if (step > 0) table[step][of_shift] = table[step - 1][of_shift];
      if (step > days_of_30_years / 2) table[step][of_break] *= 1.5;
    }
    const auto found = findings_of(neighbours, table, day);
    const auto is_found = [&](FindingKind kind, std::size_t gauge) {
      return places_of(found, kind).contains({StationIndex{static_cast<std::uint32_t>(gauge)}, ""});
    };
    ++planted;
    units += is_found(FindingKind::unit, of_unit) ? 1u : 0u;
    shifts += is_found(FindingKind::shift, of_shift) ? 1u : 0u;
    breaks += is_found(FindingKind::jump, of_break) ? 1u : 0u;
  }
  EXPECT_EQ(units, planted);
  EXPECT_EQ(shifts, planted);
  EXPECT_EQ(breaks, planted);
}

}  // namespace
}  // namespace thiessen
