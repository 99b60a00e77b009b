// Whose cell is whose: stations at one place, and silent ones.
#include "rainfall/network/network_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr Box frame{{0, 0}, {10, 10}};
constexpr Yardstick plane{Metric::planar, 1, 0.1};

std::vector<Station> stations_at(const std::vector<Point>& positions) {
  std::vector<Station> stations;
  for (const Point p : positions) stations.push_back({std::to_string(stations.size()), p, 0});
  return stations;
}

std::vector<std::uint32_t> stations_of(const NetworkCells& cells, std::uint32_t cell) {
  std::vector<std::uint32_t> numbers;
  for (const StationIndex s : cells.stations_of(PlaceIndex{cell}))
    numbers.push_back(static_cast<std::uint32_t>(index(s)));
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

TEST(NetworkCells, law_1_a_cell_belongs_to_the_stations_that_report_at_its_place) {
  const Network network(stations_at({{1, 1}, {5, 5}, {1, 1}, {9, 1}, {5, 5}}), Metric::planar);
  const NetworkCells all(network, ReportingStations(5, true), plane, frame, 1);
  EXPECT_EQ(all.diagram().places, (std::vector<Point>{{1, 1}, {5, 5}, {9, 1}}));
  EXPECT_EQ(stations_of(all, 0), (Numbers{0, 2}));
  EXPECT_EQ(stations_of(all, 1), (Numbers{1, 4}));
  EXPECT_EQ(stations_of(all, 2), (Numbers{3}));
  const NetworkCells some(network, {false, false, true, true, false}, plane, frame, 1);
  EXPECT_EQ(some.diagram().places, (std::vector<Point>{{1, 1}, {9, 1}}));
  EXPECT_EQ(stations_of(some, 0), (Numbers{2}));
  EXPECT_EQ(stations_of(some, 1), (Numbers{3}));
}

TEST(NetworkCells, law_2_each_station_that_reports_has_a_cell_at_its_position) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(50); ++round) {
    std::vector<Point> positions;
    for (int i = 0; i < 40; ++i) {
      positions.push_back(
          {static_cast<double>(seeded.whole(0, 5)), static_cast<double>(seeded.whole(0, 5))});
    }
    const Network network(stations_at(positions), Metric::planar);
    ReportingStations reports(40, false);
    for (std::uint32_t i = 0; i < 40; ++i) reports.set(StationIndex{i}, seeded.below(3) > 0);
    const NetworkCells cells(network, reports, plane, frame, 1);
    std::vector<int> met(40, 0);
    for (std::uint32_t c = 0; c < cells.diagram().places.size(); ++c) {
      const Numbers stations = stations_of(cells, c);
      EXPECT_FALSE(stations.empty());
      EXPECT_TRUE(std::is_sorted(stations.begin(), stations.end()));
      for (const std::uint32_t s : stations) {
        EXPECT_EQ(positions[s], cells.diagram().places[c]);
        ++met[s];
      }
    }
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_EQ(met[i], reports[StationIndex{i}] ? 1 : 0);
  }
}

// 3e-12 degrees are 0.3 micrometres.
TEST(NetworkCells, law_3_stations_within_a_micrometre_share_one_cell) {
  const Network network(
      stations_at({{5 + 3e-12, 5}, {8, 8}, {5, 5}, {2, 8}, {5 + 3e-12, 5}, {5, 2}}),
      Metric::geodesic);
  ASSERT_EQ(network.places().size(), 4u);
  const NetworkCells cells(network, ReportingStations(6, true), {Metric::geodesic, 1, 1}, frame, 1);
  EXPECT_EQ(cells.diagram().places[0], (Point{5, 5}));
  EXPECT_EQ(stations_of(cells, 0), (Numbers{0, 2, 4}));
  EXPECT_EQ(stations_of(cells, 1), (Numbers{1}));
}

TEST(NetworkCells, law_4_where_none_reports_there_are_none) {
  const Network network(stations_at({{1, 1}, {5, 5}}), Metric::planar);
  EXPECT_FALSE(NetworkCells(network, ReportingStations(2, false), plane, frame, 1).any());
  EXPECT_TRUE(NetworkCells(network, {true, false}, plane, frame, 1).any());
}

// Drawn coarsely they have fewer chords than as they are measured; in a plane edges are straight.
TEST(NetworkCells, law_5_edges_are_as_they_are_drawn_or_as_they_are_measured) {
  const std::vector<Point> positions{{1, 1}, {9, 2}, {5, 9}, {4, 4}};
  const ReportingStations all(4, true);
  const auto chords = [&](const Yardstick& yardstick, Edges edges) {
    const Network network(stations_at(positions), yardstick.metric);
    return NetworkCells(network, all, yardstick, frame, 1, edges).diagram().chords.size();
  };
  const Yardstick coarse{Metric::geodesic, 1, 100};
  EXPECT_LT(chords(coarse, Edges::drawn), chords(coarse, Edges::measured));
  EXPECT_EQ(chords({Metric::planar, 1, 100}, Edges::drawn), chords(plane, Edges::measured));
}

}  // namespace
}  // namespace thiessen
