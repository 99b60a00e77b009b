#include "map/raster/pixel_handovers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

const auto as_it_is = [] { return [](std::vector<Point>&) {}; };

using Handed = std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>;

/// A raster, gauges, each at a place of its own, and what silent ones hand over.
struct Raster {
  Raster(const PixelGrid& pixels, std::vector<Station> stations, unsigned threads = 1)
      : grid(pixels),
        network(std::move(stations), Metric::planar),
        owners(grid, everywhere(), network, Metric::planar,
               ReportingStations(network.stations().size(), true), as_it_is, 1),
        runs(grid, network, owners),
        handovers(grid, network, Metric::planar, runs, as_it_is, threads) {}

  std::vector<MultiPolygon> everywhere() const {
    return {{{{{-1e4, -1e4}, {1e4, -1e4}, {1e4, 1e4}, {-1e4, 1e4}}, {}}}};
  }

  /// Begin, end and the gauge of each run of a silent gauge's pixels. Places have the numbers of
  /// their gauges.
  Handed of(std::uint32_t silent, const std::vector<bool>& reports) {
    Handed found;
    for (const HandedRun& run : handovers.of(0, PlaceIndex{silent}, ReportingPlaces(reports)))
      found.emplace_back(run.pixels.begin, run.pixels.end, index(run.owner));
    return found;
  }

  PixelGrid grid;
  Network network;
  Owners owners;
  PlaceRuns runs;
  PixelHandovers handovers;
};

// Six pixels from 0 to 6; the gauges at 1, 3 and 5 have two each.
const PixelGrid row_of_six{{0, 1}, 1, 6, 1};
const std::vector<Station> three_gauges{{"a", {1, 0.5}}, {"b", {3, 0.5}}, {"c", {5, 0.5}}};

TEST(PixelHandovers, give_each_pixel_to_the_nearest_place_that_reports) {
  Raster raster(row_of_six, three_gauges);
  EXPECT_EQ(raster.of(1, {true, false, true}), (Handed{{2, 3, 0}, {3, 4, 2}}));
  EXPECT_EQ(raster.of(0, {false, true, true}), (Handed{{0, 2, 1}}));
  EXPECT_EQ(raster.of(0, {false, false, true}), (Handed{{0, 2, 2}})) << "the next is silent, too";
  EXPECT_EQ(raster.of(1, {false, false, true}), (Handed{{2, 4, 2}}));
}

TEST(PixelHandovers, are_none_where_nobody_reports) {
  Raster raster(row_of_six, three_gauges);
  EXPECT_TRUE(raster.of(1, {false, false, false}).empty());
  EXPECT_EQ(raster.of(1, {true, false, true}), (Handed{{2, 3, 0}, {3, 4, 2}})) << "afterwards";
}

TEST(PixelHandovers, of_places_as_near_go_to_the_first_in_the_file) {
  // The pixel's centre, 2.5, is as far from 0 as from 5.
  for (const bool is_turned : {false, true}) {
    const std::vector<Station> stations =
        is_turned ? std::vector<Station>{{"b", {5, 0.5}}, {"a", {0, 0.5}}, {"c", {2.5, 0.5}}}
                  : std::vector<Station>{{"a", {0, 0.5}}, {"b", {5, 0.5}}, {"c", {2.5, 0.5}}};
    Raster raster(row_of_six, stations);
    const std::uint32_t west = is_turned ? 1 : 0;
    const std::uint32_t east = is_turned ? 0 : 1;
    const std::uint32_t middle_goes_to = 0;
    const Handed found = raster.of(2, {true, true, false});
    for (const auto& [begin, end, owner] : found) {
      for (std::uint32_t pixel = begin; pixel < end; ++pixel)
        EXPECT_EQ(owner, pixel < 2 ? west : pixel > 2 ? east : middle_goes_to) << pixel;
    }
    EXPECT_FALSE(found.empty());
  }
}

// So many silent neighbours that they are asked for at once, and not one by one.
TEST(PixelHandovers, find_the_one_that_reports_behind_many_silent_places) {
  std::vector<Station> stations;
  for (int i = 0; i < 30; ++i) stations.push_back({"", {2.0 * i + 1, 0.5}});
  Raster raster({{0, 1}, 1, 60, 1}, stations);
  std::vector<bool> reports(30, false);
  reports[29] = true;
  EXPECT_EQ(raster.of(0, reports), (Handed{{0, 2, 29}}));
  reports[0] = false;
  reports[12] = true;
  EXPECT_EQ(raster.of(0, reports), (Handed{{0, 2, 12}}));
  EXPECT_EQ(raster.of(28, reports), (Handed{{56, 58, 29}}));
}

/// The owners of all pixels when these stations report, each found anew.
std::vector<std::int32_t> anew(const Raster& raster, const std::vector<bool>& reports) {
  Owners owners(raster.grid, raster.everywhere(), raster.network, Metric::planar,
                ReportingStations(reports), as_it_is, 1);
  const auto rows = owners.rows(0, raster.grid.rows);
  return {rows.begin(), rows.end()};
}

TEST(PixelHandovers, law_1_hand_over_all_pixels_of_a_place_to_their_owners_in_order) {
  Seeded seeded;
  std::vector<Station> stations;
  for (int i = 0; i < 80; ++i)
    stations.push_back({"", {seeded.uniform(0, 60), seeded.uniform(0, 40)}});
  Raster raster({{0, 40}, 1, 60, 40}, stations);
  for (const double share : {0.05, 0.3, 0.8, 0.3}) {
    std::vector<bool> reports(80, true);
    for (std::size_t g = 0; g < 80; ++g) reports[g] = seeded.uniform(0, 1) >= share;
    const std::vector<std::int32_t> wanted = anew(raster, reports);
    for (std::uint32_t s = 0; s < 80; ++s) {
      if (reports[s] || raster.runs.pixels_of(PlaceIndex{s}) == 0) continue;
      std::size_t pixels = 0;
      std::uint32_t before = 0;
      for (const auto& [begin, end, owner] : raster.of(s, reports)) {
        ASSERT_GE(begin, before);
        ASSERT_LT(begin, end);
        before = end;
        pixels += end - begin;
        for (std::uint32_t i = begin; i < end; ++i)
          ASSERT_EQ(static_cast<std::int32_t>(owner) + 1, wanted[i]) << i << " at share " << share;
      }
      EXPECT_EQ(pixels, raster.runs.pixels_of(PlaceIndex{s}));
    }
  }
}

TEST(PixelHandovers, law_2_do_not_depend_on_what_was_asked_before_or_is_forgotten) {
  Raster raster(row_of_six, three_gauges);
  const std::vector<bool> first{true, false, true};
  const std::vector<bool> second{false, false, true};
  const Handed wanted_first = raster.of(1, first);
  const Handed wanted_second = raster.of(1, second);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1} << 30}) {
    raster.handovers.forget_beyond(bytes);
    EXPECT_EQ(raster.of(1, second), wanted_second);
    EXPECT_EQ(raster.of(1, first), wanted_first);
    EXPECT_EQ(raster.of(1, first), wanted_first) << "remembered";
  }
}

// The raster's own coordinates are a tenth of the study's.
TEST(PixelHandovers, ask_in_the_coordinates_of_the_study) {
  const auto tenfold = [] {
    return [](std::vector<Point>& points) {
      for (Point& p : points) p = {10 * p.x, 10 * p.y};
    };
  };
  const Network network({{"a", {10, 5}}, {"b", {30, 5}}, {"c", {52, 5}}}, Metric::planar);
  const std::vector<MultiPolygon> areas{{{{{0, 0}, {6, 0}, {6, 1}, {0, 1}}, {}}}};
  Owners owners(row_of_six, areas, network, Metric::planar, ReportingStations(3, true), tenfold, 1);
  const PlaceRuns runs(row_of_six, network, owners);
  PixelHandovers handovers(row_of_six, network, Metric::planar, runs, tenfold, 1);
  const auto found =
      handovers.of(0, network.place_of(StationIndex{1}), ReportingPlaces{true, false, true});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].pixels.begin, 2U);
  EXPECT_EQ(found[0].owner, network.place_of(StationIndex{0}));
  EXPECT_EQ(found[1].pixels.end, 4U);
  EXPECT_EQ(found[1].owner, network.place_of(StationIndex{2}));
}

}  // namespace
}  // namespace thiessen
