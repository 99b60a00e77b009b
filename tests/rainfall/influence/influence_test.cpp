#include "rainfall/influence/influence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/normals/uniform_normals.h"
#include "rainfall/textbook.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t remembered_bytes = std::size_t{1} << 24;

using Series = std::vector<std::vector<double>>;  // by step, then by station

std::vector<std::vector<GaugeInfluence>> influence_of(const Weighing& weighing,
                                                      const Series& series, std::size_t block = 7,
                                                      std::size_t remembered = remembered_bytes,
                                                      unsigned threads = 1) {
  const Handovers handovers(weighing, threads);
  Influence influence(handovers, remembered, threads);
  for (std::size_t first = 0; first < series.size(); first += block) {
    const std::size_t end = std::min(series.size(), first + block);
    std::vector<std::span<const double>> rows;
    for (std::size_t step = first; step < end; ++step) rows.emplace_back(series[step]);
    influence.add(rows);
  }
  return influence.result();
}

struct Expected {
  double rms_change;
  double mean_change;
};

// Each basin's value at one time.
using Values = std::function<std::vector<double>(const std::vector<double>&)>;

// From the tessellation of those that report.
Values from_scratch(const Weighing& weighing) {
  return [&weighing, known = std::map<std::vector<bool>, std::vector<BasinWeights>>()](
             const std::vector<double>& readings) mutable {
    std::vector<bool> reports(readings.size());
    for (std::size_t s = 0; s < readings.size(); ++s) reports[s] = !std::isnan(readings[s]);
    if (!known.contains(reports))
      known.emplace(reports, weighing.weights(ReportingStations(reports), 1));
    std::vector<double> values;
    for (const BasinWeights& basin : known.at(reports)) {
      double sum = basin.stations.empty() ? silent : 0;
      for (const StationWeight& s : basin.stations) sum += s.weight * readings[index(s.station)];
      values.push_back(sum);
    }
    return values;
  };
}

// As `rain` computes it.
Values as_rain(const ArealRainfall& rainfall) {
  return [&rainfall](const std::vector<double>& readings) {
    std::vector<double> values;
    for (const BasinRainfall& basin : rainfall.at(readings)) values.push_back(basin.rainfall);
    return values;
  };
}

// The series of each basin, whole and without one station's column.
class LeftOut {
 public:
  LeftOut(Values compute, const Series& series)
      : compute_(std::move(compute)), series_(series), whole_(values(no_station)) {}

  /// What leaving a station's column out of the series changes, by basin.
  std::vector<Expected> without(std::size_t station) const {
    const Series left = values(station);
    std::vector<Expected> result;
    for (std::size_t b = 0; b < whole_.front().size(); ++b) {
      double sum = 0;
      double squares = 0;
      double steps = 0;
      for (std::size_t step = 0; step < series_.size(); ++step) {
        const double change = left[step][b] - whole_[step][b];
        if (std::isnan(change)) continue;
        sum += change;
        squares += change * change;
        ++steps;
      }
      result.push_back({std::sqrt(squares / steps), sum / steps});
    }
    return result;
  }

 private:
  static constexpr std::size_t no_station = std::numeric_limits<std::size_t>::max();

  Series values(std::size_t left_out) const {
    Series values;
    for (std::vector<double> readings : series_) {
      if (left_out != no_station) readings[left_out] = silent;
      values.push_back(compute_(readings));
    }
    return values;
  }

  Values compute_;
  const Series& series_;
  Series whole_;
};

// `elsewhere`: of gauges that have no row.
void expect_as_left_out(const Weighing& weighing, const Series& series, const Values& values,
                        double tolerance, double elsewhere) {
  const LeftOut oracle(values, series);
  const auto found = influence_of(weighing, series);
  const auto full = weighing.weights(ReportingStations(series.front().size(), true), 1);
  for (std::uint32_t s = 0; s < series.front().size(); ++s) {
    const std::vector<Expected> expected = oracle.without(s);
    for (std::size_t b = 0; b < found.size(); ++b) {
      const auto is_station = [&](const auto& gauge) { return gauge.station == StationIndex{s}; };
      const auto gauge = std::find_if(found[b].begin(), found[b].end(), is_station);
      const auto weighs =
          std::find_if(full[b].stations.begin(), full[b].stations.end(), is_station);
      if (gauge == found[b].end()) {
        EXPECT_EQ(weighs, full[b].stations.end());
        EXPECT_TRUE(std::isnan(expected[b].rms_change) || expected[b].rms_change <= elsewhere);
        continue;
      }
      EXPECT_NEAR(gauge->weight, weighs == full[b].stations.end() ? 0 : weighs->weight, 1e-12);
      ASSERT_EQ(std::isnan(gauge->rms_change), std::isnan(expected[b].rms_change));
      if (std::isnan(gauge->rms_change)) continue;
      EXPECT_NEAR(gauge->rms_change, expected[b].rms_change, tolerance);
      EXPECT_NEAR(gauge->mean_change, expected[b].mean_change, tolerance);
    }
  }
}

void expect_as_from_scratch(const Weighing& weighing, const Series& series, double tolerance) {
  expect_as_left_out(weighing, series, from_scratch(weighing), tolerance, tolerance);
}

Series random_series(Seeded& seeded, std::size_t stations, std::size_t steps, double share_silent) {
  Series series(steps, std::vector<double>(stations, silent));
  for (std::vector<double>& readings : series) {
    for (double& reading : readings) {
      if (seeded.uniform(0, 1) >= share_silent) reading = seeded.uniform(0, 100);
    }
  }
  return series;
}

std::vector<Basin> some_basins(Seeded& seeded) {
  std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {6, 6}), {}}})};
  for (int i = 0; i < 4; ++i) {
    const Point centre{seeded.uniform(0, 5), seeded.uniform(0, 5)};
    basins.push_back(shapes::basin({{shapes::star(seeded, centre, 1.2, 15), {}}}));
  }
  return basins;
}

// Two in three places have one station, the rest two or three.
std::vector<Station> random_stations(Seeded& seeded, std::size_t count) {
  std::vector<Station> stations;
  while (stations.size() < count) {
    const Point at = !stations.empty() && seeded.below(3) == 0
                         ? stations[seeded.below(stations.size())].position
                         : Point{seeded.uniform(0, 5), seeded.uniform(0, 5)};
    stations.push_back({std::to_string(stations.size()), at, 0});
  }
  return stations;
}

std::vector<Station> lattice() {
  std::vector<Station> stations;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j)
      stations.push_back({std::to_string(5 * i + j), {1.0 * i, 1.0 * j}, 0});
  }
  return stations;
}

constexpr double shares_silent[] = {0, 0.05, 0.3, 0.6, 0.95};

TEST(Influence, is_that_of_leaving_a_column_out) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(3); ++round) {
    for (const double share : shares_silent) {
      const Network network(random_stations(seeded, 20), Metric::planar);
      const std::vector<Basin> basins = some_basins(seeded);
      const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
      expect_as_from_scratch(weighing, random_series(seeded, 20, 15, share), 1e-10);
    }
  }
}

TEST(Influence, is_that_of_leaving_a_column_out_of_a_lattice) {
  Seeded seeded;
  const Network network(lattice(), Metric::planar);
  for (std::uint64_t round = 0; round < Seeded::rounds(2); ++round) {
    for (const double share : shares_silent) {
      const std::vector<Basin> basins = some_basins(seeded);
      const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
      expect_as_from_scratch(weighing, random_series(seeded, 25, 10, share), 1e-10);
    }
  }
}

TEST(Influence, of_few_gauges_is_that_of_leaving_a_column_out) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5); ++round) {
    for (const std::size_t stations : {1u, 2u, 3u, 4u}) {
      const Network network(random_stations(seeded, stations), Metric::planar);
      const std::vector<Basin> basins = some_basins(seeded);
      const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
      expect_as_from_scratch(weighing, random_series(seeded, stations, 20, 0.4), 1e-10);
    }
  }
}

// On the Earth what is handed over has the accuracy that silent gauges' values have, 1e-7 of the
// readings where gauges are 100 km apart, and a tessellation from scratch that of its chords. The
// series differ by less: ground that the gauge has no part in is handed over in another chart.
TEST(Influence, on_the_earth_is_that_of_leaving_a_column_out) {
  Seeded seeded;
  for (const double share : {0.0, 0.3}) {
    const Network network(random_stations(seeded, 20), Metric::geodesic);
    const std::vector<Basin> basins = some_basins(seeded);
    const Weighing weighing(network, basins, {Metric::geodesic, 1, 1e-3});
    const Series series = random_series(seeded, 20, 8, share);
    expect_as_from_scratch(weighing, series, 3e-5);
    const ArealRainfall rainfall(weighing, {}, 1);
    expect_as_left_out(weighing, series, as_rain(rainfall), 1e-5, 3e-5);
  }
}

TEST(Influence, does_not_depend_on_threads_blocks_or_memory) {
  Seeded seeded;
  const Network network(random_stations(seeded, 40), Metric::planar);
  const std::vector<Basin> basins = some_basins(seeded);
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const Series series = random_series(seeded, 40, 50, 0.2);
  const auto once = influence_of(weighing, series, 7, remembered_bytes, 1);
  for (const auto& [threads, remembered] :
       {std::pair{2u, remembered_bytes}, std::pair{5u, std::size_t{0}},
        std::pair{3u, std::size_t{100000}}}) {
    const auto again = influence_of(weighing, series, 7, remembered, threads);
    for (std::size_t b = 0; b < once.size(); ++b) {
      ASSERT_EQ(again[b].size(), once[b].size());
      for (std::size_t i = 0; i < once[b].size(); ++i) {
        EXPECT_EQ(again[b][i].station, once[b][i].station);
        EXPECT_EQ(again[b][i].weight, once[b][i].weight);
        EXPECT_EQ(again[b][i].rms_change, once[b][i].rms_change);
        EXPECT_EQ(again[b][i].mean_change, once[b][i].mean_change);
      }
    }
  }
}

// 69.836427 mm with all gauges of the textbook, 64.095794 without gauge 5; 1, 4 and 6 do not weigh.
TEST(Influence, of_the_textbooks_gauges) {
  const Network network(textbook::stations(), Metric::planar);
  const std::vector<Basin> basins{textbook::basin()};
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const auto found = influence_of(weighing, {textbook::readings()})[0];
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(found[2].station, StationIndex{4});
  EXPECT_NEAR(found[2].weight, 2563.0 / 11200, 1e-14);
  EXPECT_NEAR(found[2].mean_change, 64.095794 - 69.836427, 1e-6);
  EXPECT_EQ(found[2].rms_change, -found[2].mean_change);
}

// Nothing of three at one place and two at another; 0.1 has no exact third.
TEST(Influence, of_constant_readings_is_none) {
  Seeded seeded;
  std::vector<Station> stations = random_stations(seeded, 20);
  for (int i = 0; i < 2; ++i) stations.push_back({"twin", stations[0].position, 0});
  const Network network(stations, Metric::planar);
  const std::vector<Basin> basins = some_basins(seeded);
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  Series series = random_series(seeded, 22, 20, 0.3);
  for (std::vector<double>& readings : series) {
    for (double& reading : readings) reading = std::isnan(reading) ? silent : 0.1;
  }
  for (const auto& basin : influence_of(weighing, series)) {
    EXPECT_FALSE(basin.empty());
    for (const GaugeInfluence& gauge : basin) {
      EXPECT_EQ(gauge.rms_change, 0);
      EXPECT_EQ(gauge.mean_change, 0);
    }
  }
}

// Where it alone reports there is nothing without it; where it is silent it changes nothing.
TEST(Influence, counts_the_steps_in_which_both_values_are_there) {
  const Network network({{"a", {0, 0}, 2}, {"b", {4, 0}, 3}}, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const auto found =
      influence_of(weighing, {{10, silent}, {10, 20}, {silent, 30}, {silent, silent}})[0];
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].mean_change, 5.0 / 2);
  EXPECT_EQ(found[0].rms_change, std::sqrt(25.0 / 2));
  EXPECT_EQ(found[1].mean_change, -5.0 / 2);
}

TEST(Influence, of_a_lone_gauge_and_of_no_steps_is_unknown) {
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const Network one({{"a", {0, 0}, 2}}, Metric::planar);
  const Network two({{"a", {0, 0}, 2}, {"b", {4, 0}, 3}}, Metric::planar);
  for (const auto& [network, series] :
       {std::pair{&one, Series{{10}, {20}}}, std::pair{&two, Series{}},
        std::pair{&two, Series{{silent, silent}}}}) {
    const Weighing weighing(*network, basins, {Metric::planar, 1, 0.1});
    const auto found = influence_of(weighing, series)[0];
    EXPECT_EQ(found.size(), network->stations().size());
    for (const GaugeInfluence& gauge : found) {
      EXPECT_TRUE(std::isnan(gauge.rms_change));
      EXPECT_TRUE(std::isnan(gauge.mean_change));
    }
  }
}

// Against the values of a month with the gauge's reading and without it. The year is no month of
// the series, and comes from a call without months.
TEST(Influence, counts_the_normals_of_the_month_of_each_step) {
  Seeded seeded;
  constexpr std::size_t months = 3;
  const Network network(random_stations(seeded, 20), Metric::planar);
  const std::vector<Basin> basins = some_basins(seeded);
  Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const auto normals_of = [&](std::size_t count) {
    std::vector<std::vector<double>> all(count, std::vector<double>(months));
    for (std::vector<double>& normals : all) {
      for (double& normal : normals) normal = seeded.uniform(0.5, 2);
    }
    return all;
  };
  weighing.take_normals(std::make_shared<const UniformNormals>(
      normals_of(network.stations().size()), normals_of(basins.size())));
  const Series series = random_series(seeded, 20, 30, 0.3);
  std::vector<std::span<const double>> rows(series.begin(), series.end());
  std::vector<std::size_t> month_of;
  for (std::size_t step = 0; step < series.size(); ++step) month_of.push_back(step * step % months);
  const ArealRainfall of_year(weighing, {}, 1);
  const Handovers handovers(weighing, 1);
  for (const bool by_month : {true, false}) {
    Influence influence(handovers, remembered_bytes, 2);
    influence.add(rows, by_month ? month_of : std::vector<std::size_t>());
    const auto found = influence.result();
    for (std::size_t b = 0; b < basins.size(); ++b) {
      for (const GaugeInfluence& gauge : found[b]) {
        double sum = 0;
        double steps = 0;
        for (std::size_t step = 0; step < series.size(); ++step) {
          const auto rainfall =
              of_year.of_month(by_month ? NormalMonth(month_of[step]) : NormalMonth());
          std::vector<double> without = series[step];
          without[index(gauge.station)] = silent;
          const double change =
              rainfall->at(without)[b].rainfall - rainfall->at(series[step])[b].rainfall;
          if (std::isnan(change)) continue;
          sum += change;
          ++steps;
        }
        EXPECT_NEAR(gauge.mean_change, sum / steps, 1e-11);
      }
    }
  }
}

// No square of these is a double.
TEST(Influence, of_huge_and_of_tiny_readings) {
  const Network network({{"a", {0, 0}, 2}, {"b", {4, 0}, 3}}, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  for (const double size : {1e300, 1e-300}) {
    const auto found = influence_of(weighing, {{0, size}, {0, size}})[0];
    EXPECT_NEAR(found[0].rms_change / size, 0.5, 1e-15);
    EXPECT_NEAR(found[1].mean_change / size, -0.5, 1e-15);
  }
}

}  // namespace
}  // namespace thiessen
