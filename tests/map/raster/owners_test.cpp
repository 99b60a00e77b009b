#include "map/raster/owners.h"

#include <gtest/gtest.h>

#include <csignal>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/interrupt.h"

namespace thiessen {
namespace {

using Numbers = std::vector<std::int32_t>;

const auto as_it_is = [] { return [](std::vector<Point>&) {}; };

MultiPolygon rectangle(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

Network network_of(const std::vector<Point>& positions, Metric metric) {
  std::vector<Station> stations;
  for (const Point p : positions) stations.push_back({std::to_string(stations.size()), p, 0});
  return {stations, metric};
}

Numbers owners_of(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                  const Network& network, Metric metric, const ReportingStations& reports,
                  const std::function<PointMapping()>& to_study, unsigned threads) {
  Owners owners(grid, areas, network, metric, reports, to_study, threads);
  const std::span<const std::int32_t> rows = owners.rows(0, grid.rows);
  return {rows.begin(), rows.end()};
}

// A row of six pixels from 0 to 6, 1 high.
const PixelGrid row_of_six{{0, 1}, 1, 6, 1};

TEST(Owners, are_numbers_in_file_order_and_0_outside) {
  const Network network = network_of({{5, 0.5}, {1, 0.5}}, Metric::planar);
  const std::vector<MultiPolygon> areas{rectangle(0, 0, 2, 1), rectangle(3, 0, 6, 1)};
  EXPECT_EQ(owners_of(row_of_six, areas, network, Metric::planar, {true, true}, as_it_is, 1),
            (Numbers{2, 2, 0, 1, 1, 1}));
}

TEST(Owners, ties_and_shared_places_go_to_the_lower_number) {
  const std::vector<MultiPolygon> area{rectangle(0, 0, 6, 1)};
  // The third pixel's centre, 2.5, is as far from 1 as from 4.
  const Network ascending = network_of({{1, 0}, {4, 0}, {1, 0}, {4, 0}}, Metric::planar);
  EXPECT_EQ(
      owners_of(row_of_six, area, ascending, Metric::planar, {true, true, true, true}, as_it_is, 1),
      (Numbers{1, 1, 1, 2, 2, 2}));
  const Network descending = network_of({{4, 0}, {1, 0}, {4, 0}, {1, 0}}, Metric::planar);
  EXPECT_EQ(owners_of(row_of_six, area, descending, Metric::planar, {true, true, true, true},
                      as_it_is, 1),
            (Numbers{2, 2, 1, 1, 1, 1}));
}

TEST(Owners, leave_out_stations_that_do_not_report) {
  const std::vector<MultiPolygon> area{rectangle(0, 0, 6, 1)};
  // The first station shares its place with the third: silent, its place is the third's, and in a
  // tie the second station comes before it.
  const Network network = network_of({{1, 0}, {4, 0}, {1, 0}}, Metric::planar);
  EXPECT_EQ(owners_of(row_of_six, area, network, Metric::planar, {false, true, true}, as_it_is, 1),
            (Numbers{3, 3, 2, 2, 2, 2}));
  EXPECT_EQ(owners_of(row_of_six, area, network, Metric::planar, {false, true, false}, as_it_is, 1),
            (Numbers{2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(
      owners_of(row_of_six, area, network, Metric::planar, {false, false, false}, as_it_is, 1),
      (Numbers{0, 0, 0, 0, 0, 0}));
}

TEST(Owners, geodesic_ties_go_to_the_lower_number) {
  // On the equator halfway between two stations, and along the meridian between them.
  const Network network = network_of({{3, 0}, {1, 0}}, Metric::geodesic);
  const PixelGrid grid{{-0.5, 2.5}, 1, 6, 5};
  const Numbers found = owners_of(grid, {rectangle(-1, -3, 6, 3)}, network, Metric::geodesic,
                                  {true, true}, as_it_is, 1);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], i % 6 < 2 ? 2 : 1) << i;
}

TEST(Owners, are_0_where_the_projection_ends) {
  const auto half_plane = [] {
    return [](std::vector<Point>& points) {
      for (Point& p : points) {
        if (p.x > 33.5) p.x = std::numeric_limits<double>::quiet_NaN();
      }
    };
  };
  const PixelGrid grid{{0, 50}, 1, 50, 50};
  const Network network = network_of({{1, 1}}, Metric::planar);
  const Numbers found =
      owners_of(grid, {rectangle(0, 0, 50, 50)}, network, Metric::planar, {true}, half_plane, 1);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], i % 50 <= 33 ? 1 : 0) << i;
}

TEST(Owners, do_not_depend_on_the_number_of_threads) {
  std::vector<Point> positions;
  for (int i = 0; i < 60; ++i)
    positions.push_back({std::fmod(i * 7.31, 40), std::fmod(i * 3.7, 40)});
  const Network network = network_of(positions, Metric::geodesic);
  const PixelGrid grid{{0, 40}, 0.1, 400, 400};
  const ReportingStations all(positions.size(), true);
  const auto with = [&](unsigned threads) {
    return owners_of(grid, {rectangle(0, 0, 40, 40)}, network, Metric::geodesic, all, as_it_is,
                     threads);
  };
  const Numbers one = with(1);
  EXPECT_TRUE(one == with(2));
  EXPECT_TRUE(one == with(7));
}

TEST(Owners, are_the_same_a_few_rows_at_a_time) {
  std::vector<Point> positions;
  for (int i = 0; i < 30; ++i)
    positions.push_back({std::fmod(i * 7.31, 20), std::fmod(i * 3.7, 20)});
  const Network network = network_of(positions, Metric::planar);
  const PixelGrid grid{{0, 20}, 0.125, 160, 160};
  const ReportingStations all(positions.size(), true);
  const std::vector<MultiPolygon> areas{{{{{0, 0}, {20, 0}, {3, 20}}, {{{4, 4}, {5, 9}, {9, 4}}}}},
                                        rectangle(15, 16, 19, 20)};
  const Numbers whole = owners_of(grid, areas, network, Metric::planar, all, as_it_is, 2);
  Owners owners(grid, areas, network, Metric::planar, all, as_it_is, 2);
  Numbers in_bands;
  for (const int row : {0, 1, 60, 61, 130}) {
    const int next = row == 0 ? 1 : row == 1 ? 60 : row == 60 ? 61 : row == 61 ? 130 : 160;
    const std::span<const std::int32_t> rows = owners.rows(row, next - row);
    in_bands.insert(in_bands.end(), rows.begin(), rows.end());
  }
  EXPECT_TRUE(in_bands == whole);
  EXPECT_EQ(std::count(whole.begin(), whole.end(), 0) > 5000, true);
}

TEST(Owners, stop_when_interrupted) {
  watch_for_interrupts();
  const Network network = network_of({{1, 1}, {3, 3}}, Metric::planar);
  const auto interrupted = [] {
    std::raise(SIGINT);
    return [](std::vector<Point>&) {};
  };
  EXPECT_THROW(owners_of(row_of_six, {rectangle(0, 0, 6, 1)}, network, Metric::planar, {true, true},
                         interrupted, 1),
               Interrupted);
  forget_interrupt();
}

}  // namespace
}  // namespace thiessen
