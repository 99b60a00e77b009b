#include "map/raster/place_runs.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Runs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

const auto as_it_is = [] { return [](std::vector<Point>&) {}; };

MultiPolygon rectangle(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

Owners owners_of(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                 const Network& network) {
  return {
      grid,     areas, network, Metric::planar, ReportingStations(network.stations().size(), true),
      as_it_is, 1};
}

Runs of(const PlaceRuns& runs, PlaceIndex place) {
  Runs found;
  for (const PixelRun& run : runs.of(place)) found.emplace_back(run.begin, run.end);
  return found;
}

// Two rows of six pixels from 0 to 6. The places of the gauges at 1, 5 and 99 are told apart at 3.
TEST(PlaceRuns, are_a_places_pixels_row_by_row_and_none_outside_the_areas) {
  const PixelGrid grid{{0, 2}, 1, 6, 2};
  const Network network({{"a", {1, 1}}, {"b", {5, 1}}, {"c", {99, 1}}}, Metric::planar);
  const std::vector<MultiPolygon> areas{rectangle(0, 1, 6, 2), rectangle(0, 0, 1, 1),
                                        rectangle(2, 0, 4, 1)};
  Owners owners = owners_of(grid, areas, network);
  const PlaceRuns runs(grid, network, owners);
  EXPECT_EQ(of(runs, PlaceIndex{0}), (Runs{{0, 3}, {6, 7}, {8, 9}}));
  EXPECT_EQ(of(runs, PlaceIndex{1}), (Runs{{3, 6}, {9, 10}}));
  EXPECT_TRUE(of(runs, PlaceIndex{2}).empty()) << "it is too far away";
  EXPECT_EQ(runs.pixels_of(PlaceIndex{0}), 5U);
  EXPECT_EQ(runs.pixels_of(PlaceIndex{1}), 4U);
  EXPECT_EQ(runs.pixels_of(PlaceIndex{2}), 0U);
  EXPECT_EQ(runs.pixels(), 9U);
}

TEST(PlaceRuns, gauges_at_one_place_have_its_runs_together) {
  const PixelGrid grid{{0, 1}, 1, 6, 1};
  const Network network({{"a", {5, 0.5}}, {"b", {1, 0.5}}, {"twin", {5, 0.5}}}, Metric::planar);
  Owners owners = owners_of(grid, {rectangle(0, 0, 6, 1)}, network);
  const PlaceRuns runs(grid, network, owners);
  EXPECT_EQ(of(runs, network.place_of(StationIndex{2})), (Runs{{3, 6}}));
  EXPECT_EQ(of(runs, network.place_of(StationIndex{1})), (Runs{{0, 3}}));
}

// There are more rows than are asked for at once.
TEST(PlaceRuns, law_1_part_the_pixels_that_have_an_owner_and_end_with_each_row) {
  Seeded seeded;
  const PixelGrid grid{{0, 600}, 1, 20, 600};
  std::vector<Station> stations;
  for (int i = 0; i < 60; ++i)
    stations.push_back({"", {seeded.uniform(0, 20), seeded.uniform(0, 600)}});
  const Network network(std::move(stations), Metric::planar);
  const std::vector<MultiPolygon> areas{rectangle(3.2, 20, 18.7, 590)};
  Owners owners = owners_of(grid, areas, network);
  const PlaceRuns runs(grid, network, owners);
  std::vector<std::int32_t> rebuilt(20 * 600, 0);
  std::size_t pixels = 0;
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    std::uint32_t before = 0;
    std::size_t own = 0;
    for (const PixelRun& run : runs.of(PlaceIndex{p})) {
      ASSERT_LT(run.begin, run.end);
      ASSERT_GE(run.begin, before);
      ASSERT_EQ(run.begin / 20, (run.end - 1) / 20);
      before = run.end;
      own += run.end - run.begin;
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        ASSERT_EQ(rebuilt[i], 0);
        rebuilt[i] = static_cast<std::int32_t>(p) + 1;  // no two gauges are at one place
      }
    }
    EXPECT_EQ(runs.pixels_of(PlaceIndex{p}), own);
    pixels += own;
  }
  EXPECT_EQ(runs.pixels(), pixels);
  Owners again = owners_of(grid, areas, network);
  const auto wanted = again.rows(0, grid.rows);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::int32_t owner =
        wanted[i] == 0 ? 0
                       : static_cast<std::int32_t>(index(network.place_of(
                             StationIndex{static_cast<std::uint32_t>(wanted[i] - 1)}))) +
                             1;
    ASSERT_EQ(rebuilt[i], owner) << i;
  }
}

}  // namespace
}  // namespace thiessen
