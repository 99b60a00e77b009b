#include "rainfall/network/weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/textbook.h"

namespace thiessen {
namespace {

ReportingStations all_of(const Network& network) {
  return ReportingStations(network.stations().size(), true);
}

std::map<std::string, double> weights_by_id(const Network& network, const BasinWeights& weights) {
  std::map<std::string, double> by_id;
  for (const StationWeight& s : weights.stations)
    by_id[network.stations()[index(s.station)].id] = s.weight;
  return by_id;
}

constexpr Yardstick plane{Metric::planar, 1, 0.1};
constexpr Yardstick ellipsoid{Metric::geodesic, 1, 0.1};

TEST(Weights, of_the_textbook_case_are_its_fractions) {
  const Network network(textbook::stations(), Metric::planar);
  const std::vector<Basin> basins{textbook::basin()};
  const Weighing weighing(network, basins, plane);
  const std::vector<BasinWeights> weights = weighing.weights(all_of(network), 1);
  ASSERT_EQ(weights.size(), 1u);
  EXPECT_EQ(weights[0].area, 125);
  const std::map<std::string, double> expected{{"2", 478277.0 / 3421250}, {"3", 832043.0 / 6440000},
                                               {"5", 2563.0 / 11200},     {"7", 3607.0 / 14875},
                                               {"8", 83.0 / 1000},        {"9", 60446.0 / 342125}};
  const auto found = weights_by_id(network, weights[0]);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [id, weight] : expected) EXPECT_NEAR(found.at(id), weight, 1e-15) << id;
}

TEST(Weights, are_in_the_order_of_the_stations_and_add_up_to_one) {
  const Network network(textbook::stations(), Metric::planar);
  const std::vector<Basin> basins{textbook::basin()};
  const auto weights = Weighing(network, basins, plane).weights(all_of(network), 1);
  double sum = 0;
  double area = 0;
  StationIndex before{0};
  for (const StationWeight& s : weights[0].stations) {
    EXPECT_LT(before, s.station);
    before = s.station;
    EXPECT_GT(s.weight, 0);
    sum += s.weight;
    area += s.area;
  }
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_NEAR(area, 125, 1e-13);
}

TEST(Weights, at_a_shared_place_are_equal_shares) {
  const std::vector<Station> stations{{"a", {0, 0}, 2}, {"b", {4, 0}, 3}, {"c", {0, 0}, 4}};
  const Network network(stations, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const Weighing weighing(network, basins, plane);
  const auto all = weights_by_id(network, weighing.weights({true, true, true}, 1)[0]);
  EXPECT_EQ(all, (std::map<std::string, double>{{"a", 0.25}, {"b", 0.5}, {"c", 0.25}}));
  const auto half = weights_by_id(network, weighing.weights({true, true, false}, 1)[0]);
  EXPECT_EQ(half, (std::map<std::string, double>{{"a", 0.5}, {"b", 0.5}}));
  const auto none = weights_by_id(network, weighing.weights({false, true, false}, 1)[0]);
  EXPECT_EQ(none, (std::map<std::string, double>{{"b", 1}}));
}

TEST(Weights, of_no_reporting_gauge_are_none) {
  const Network network(textbook::stations(), Metric::planar);
  const std::vector<Basin> basins{textbook::basin()};
  const auto weights = Weighing(network, basins, plane).weights(ReportingStations(9, false), 1);
  ASSERT_EQ(weights.size(), 1u);
  EXPECT_EQ(weights[0].area, 125);
  EXPECT_TRUE(weights[0].stations.empty());
}

TEST(Weights, cells_of_stations_at_one_place_have_the_whole_shape_each) {
  const std::vector<Station> stations{{"a", {0, 0}, 2}, {"b", {4, 0}, 3}, {"c", {0, 0}, 4}};
  const Network network(stations, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const auto cells = Weighing(network, basins, plane).cells({true, true, true}, 1);
  ASSERT_EQ(cells[0].size(), 3u);
  EXPECT_EQ(cells[0][0].shape[0].outer.size(), 4u);
  EXPECT_EQ(shapes::box_of(cells[0][0].shape).high, (Point{2, 1}));
  EXPECT_EQ(cells[0][2].shape[0].outer, cells[0][0].shape[0].outer);
  EXPECT_EQ(cells[0][0].area, 3);
  EXPECT_EQ(cells[0][1].area, 6);
}

/// Gauges on a lattice and at random, and stars over them.
struct Study {
  std::vector<Station> stations;
  std::vector<Basin> basins;
};

Study random_study(Seeded& seeded) {
  Study study;
  for (int i = 0; i < 80; ++i) {
    Point p{seeded.uniform(-105, -103), seeded.uniform(38, 40)};
    if (i % 3 == 0) p = {-105 + 0.25 * (i % 9), 38 + 0.25 * ((i / 9) % 9)};
    study.stations.push_back({std::to_string(i), p, 0});
  }
  for (int i = 0; i < 20; ++i) {
    const Point centre{seeded.uniform(-105, -103), seeded.uniform(38, 40)};
    study.basins.push_back(shapes::basin({{shapes::star(seeded, centre, 1, 30), {}}}));
  }
  return study;
}

TEST(Weights, do_not_depend_on_the_number_of_threads_by_a_bit) {
  Seeded seeded;
  const Study study = random_study(seeded);
  for (const Yardstick& yardstick : {plane, ellipsoid}) {
    const Network network(study.stations, yardstick.metric);
    const Weighing weighing(network, study.basins, yardstick);
    const auto one = weighing.weights(all_of(network), 1);
    for (const unsigned threads : {2u, 5u, 64u}) {
      const auto many = weighing.weights(all_of(network), threads);
      for (std::size_t b = 0; b < one.size(); ++b)
        ASSERT_EQ(weights_by_id(network, many[b]), weights_by_id(network, one[b]));
    }
  }
}

/// The cells that are handed over one at a time, up to so many.
std::vector<std::vector<StationCell>> handed_over(const Weighing& weighing,
                                                  const ReportingStations& reports,
                                                  unsigned threads, std::size_t most) {
  std::vector<std::vector<StationCell>> cells(weighing.basins().size());
  std::size_t count = 0;
  weighing.for_each_cell(reports, threads, {}, [&](std::size_t basin, StationCell&& cell) {
    cells.at(basin).push_back(std::move(cell));
    return ++count < most;
  });
  EXPECT_LE(count, most);
  return cells;
}

void expect_same_cells(const std::vector<std::vector<StationCell>>& found,
                       const std::vector<std::vector<StationCell>>& expected) {
  for (std::size_t b = 0; b < expected.size(); ++b) {
    ASSERT_EQ(found[b].size(), expected[b].size());
    for (std::size_t i = 0; i < expected[b].size(); ++i) {
      EXPECT_EQ(found[b][i].station, expected[b][i].station);
      EXPECT_EQ(found[b][i].area, expected[b][i].area);
      EXPECT_EQ(found[b][i].weight, expected[b][i].weight);
      ASSERT_EQ(found[b][i].shape.size(), expected[b][i].shape.size());
      for (std::size_t k = 0; k < expected[b][i].shape.size(); ++k) {
        EXPECT_EQ(found[b][i].shape[k].outer, expected[b][i].shape[k].outer);
        EXPECT_EQ(found[b][i].shape[k].holes, expected[b][i].shape[k].holes);
      }
    }
  }
}

TEST(Weights, cells_that_are_handed_over_are_the_same_by_a_bit) {
  Seeded seeded;
  Study study = random_study(seeded);
  study.stations[40].position = study.stations[7].position;  // a cell that two stations share
  for (const Yardstick& yardstick : {plane, ellipsoid}) {
    const Network network(study.stations, yardstick.metric);
    const Weighing weighing(network, study.basins, yardstick);
    ReportingStations reports = all_of(network);
    reports.set(StationIndex{3}, false);
    const auto expected = weighing.cells(reports, 1);
    for (const unsigned threads : {1u, 3u})
      expect_same_cells(handed_over(weighing, reports, threads, 1'000'000), expected);
    const auto some = handed_over(weighing, reports, 1, expected[0].size() + 2);
    EXPECT_EQ(some[0].size(), expected[0].size());
    EXPECT_EQ(some[1].size(), 2u);
    EXPECT_TRUE(some[2].empty());
  }
}

TEST(Weights, no_cells_are_handed_over_where_no_gauge_reports) {
  const Network network(textbook::stations(), Metric::planar);
  const std::vector<Basin> basins{textbook::basin()};
  const ReportingStations none(network.stations().size(), false);
  EXPECT_TRUE(handed_over(Weighing(network, basins, plane), none, 1, 10).front().empty());
}

TEST(Weights, do_not_depend_on_the_order_of_the_stations_by_a_bit) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5); ++round) {
    Study study = random_study(seeded);
    for (const Yardstick& yardstick : {plane, ellipsoid}) {
      const Network network(study.stations, yardstick.metric);
      const auto expected = Weighing(network, study.basins, yardstick).weights(all_of(network), 1);
      std::shuffle(study.stations.begin(), study.stations.end(), seeded.generator());
      const Network shuffled(study.stations, yardstick.metric);
      const auto found = Weighing(shuffled, study.basins, yardstick).weights(all_of(shuffled), 1);
      for (std::size_t b = 0; b < expected.size(); ++b)
        ASSERT_EQ(weights_by_id(shuffled, found[b]), weights_by_id(network, expected[b]));
    }
  }
}

// Other basins widen the frame that the diagram is drawn for.
TEST(Weights, of_a_basin_do_not_depend_on_the_others) {
  Seeded seeded;
  const Study study = random_study(seeded);
  for (const Yardstick& yardstick : {plane, ellipsoid}) {
    const Network network(study.stations, yardstick.metric);
    const auto together = Weighing(network, study.basins, yardstick).weights(all_of(network), 1);
    for (std::size_t b = 0; b < study.basins.size(); ++b) {
      const std::vector<Basin> alone{study.basins[b]};
      const auto found = Weighing(network, alone, yardstick).weights(all_of(network), 1);
      const auto expected = weights_by_id(network, together[b]);
      const auto weights = weights_by_id(network, found[0]);
      ASSERT_EQ(weights.size(), expected.size());
      for (const auto& [id, weight] : expected) EXPECT_NEAR(weights.at(id), weight, 1e-7) << id;
    }
  }
}

// Two basins side by side: no ground is lost between them, or counted twice.
TEST(Weights, of_adjoining_basins_add_up) {
  Seeded seeded;
  const Study study = random_study(seeded);
  const Ring seam{{-104, 38}, {-103.9, 38.7}, {-104.2, 39.3}, {-104, 40}};
  Ring west{{-105, 38}};
  west.insert(west.end(), seam.begin(), seam.end());
  west.push_back({-105, 40});
  Ring east{{-103, 40}};
  east.insert(east.end(), seam.rbegin(), seam.rend());
  east.push_back({-103, 38});
  const std::vector<Basin> basins{
      shapes::basin({{west, {}}}), shapes::basin({{east, {}}}),
      shapes::basin(
          {{{{-105, 38}, {-104, 38}, {-103, 38}, {-103, 40}, {-104, 40}, {-105, 40}}, {}}})};
  for (const Yardstick& yardstick : {plane, ellipsoid}) {
    const Network network(study.stations, yardstick.metric);
    const auto weights = Weighing(network, basins, yardstick).weights(all_of(network), 1);
    std::map<std::size_t, double> left;
    for (const StationWeight& s : weights[0].stations) left[index(s.station)] += s.area;
    for (const StationWeight& s : weights[1].stations) left[index(s.station)] += s.area;
    for (const StationWeight& s : weights[2].stations) left[index(s.station)] -= s.area;
    for (const auto& [station, area] : left) EXPECT_NEAR(area, 0, 1e-12 * weights[2].area);
  }
}

// Only shapes follow the tolerance: at a kilometre many of these basins lose cells, or gain them.
TEST(Weights, do_not_depend_on_the_tolerance_by_a_bit) {
  Seeded seeded;
  Study study = random_study(seeded);
  for (int i = 0; i < 20; ++i) {
    const Point centre{seeded.uniform(-105, -103), seeded.uniform(38, 40)};
    study.basins.push_back(shapes::basin({{shapes::star(seeded, centre, 0.01, 9), {}}}));
  }
  const Network network(study.stations, Metric::geodesic);
  const Weighing usual(network, study.basins, ellipsoid);
  const auto expected = usual.weights(all_of(network), 1);
  for (const double tolerance : {0.001, 10.0, 1000.0, 1e5}) {
    const Weighing weighing(network, study.basins, Yardstick{Metric::geodesic, 1, tolerance});
    const auto weights = weighing.weights(all_of(network), 1);
    const auto cells = weighing.cells(all_of(network), 2);
    for (std::size_t b = 0; b < expected.size(); ++b) {
      ASSERT_EQ(weights_by_id(network, weights[b]), weights_by_id(network, expected[b]));
      ASSERT_EQ(cells[b].size(), expected[b].stations.size());
      for (std::size_t i = 0; i < cells[b].size(); ++i) {
        ASSERT_EQ(cells[b][i].station, expected[b].stations[i].station);
        ASSERT_EQ(cells[b][i].area, expected[b].stations[i].area);
        ASSERT_EQ(cells[b][i].weight, expected[b].stations[i].weight);
        ASSERT_FALSE(cells[b][i].shape.empty());
      }
    }
  }
}

std::size_t vertices_of(const std::vector<StationCell>& cells) {
  std::size_t count = 0;
  for (const StationCell& cell : cells) {
    for (const Polygon& part : cell.shape) count += part.outer.size();
  }
  return count;
}

// Four gauges about the corners of a basin of ten degrees, whose bisectors are curved in degrees. A
// kilometre along 2,000 of edges is less than a hundredth of the smallest cell.
TEST(Weights, pictured_cells_have_as_few_vertices_as_their_tolerance_allows) {
  const Network network({{"a", {0, 40}}, {"b", {10, 41}}, {"c", {1, 50}}, {"d", {9, 49}}},
                        Metric::geodesic);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({0, 40}, {10, 50}), {}}})};
  const Weighing weighing(network, basins, ellipsoid);
  const auto exact = weighing.cells(all_of(network), 1)[0];
  const auto pictured = weighing.pictured_cells(all_of(network), 1000, 2)[0];
  ASSERT_EQ(pictured.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_EQ(pictured[i].station, exact[i].station);
    EXPECT_NEAR(pictured[i].area / exact[i].area, 1, 0.01);
  }
  EXPECT_LT(vertices_of(pictured), vertices_of(exact) / 4);
}

}  // namespace
}  // namespace thiessen
