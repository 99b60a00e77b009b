// Ground by the sets of cells that are nearest to it, beside what components hand over.
#include "rainfall/gaps/nearest_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

using Weights = std::map<std::pair<std::uint32_t, PlaceIndex>, double>;
using Cells = std::vector<PlaceIndex>;

Cells rising(PlaceIndex a, PlaceIndex b) {
  return {std::min(a, b), std::max(a, b)};
}

void add(std::span<const CellWeight> shares, const Cells& but, double sign, Weights& weights) {
  for (const CellWeight& share : shares) {
    if (std::find(but.begin(), but.end(), share.cell) == but.end())
      weights[{share.basin, share.cell}] += sign * share.weight;
  }
}

void expect_none(const Weights& differences, double tolerance) {
  for (const auto& [key, difference] : differences) EXPECT_NEAR(difference, 0, tolerance);
}

// Of two cells that are silent the ground goes to whoever is next of either, or next of both.
void expect_as_components(const Weighing& weighing, double tolerance) {
  const Handovers handovers(weighing, 1);
  NearestSets sets(handovers, std::size_t{1} << 20);
  NearestSets::Bench bench = sets.bench();
  for (std::uint32_t c = 0; c < handovers.adjacency().cells(); ++c) {
    const Cells one{PlaceIndex{c}};
    Weights of_one;
    add(sets.of(one, bench)->weights, one, 1, of_one);
    add(handovers.of(one).shares, one, -1, of_one);
    expect_none(of_one, tolerance);
    for (const PlaceIndex q : handovers.adjacency().neighbours(PlaceIndex{c})) {
      const Cells two = rising(PlaceIndex{c}, q);
      ASSERT_TRUE(sets.of(two, bench)->is_known);
      Weights of_two;
      for (const Cells& set : {one, Cells{q}, two})
        add(sets.of(set, bench)->weights, two, 1, of_two);
      add(handovers.of(two).shares, two, -1, of_two);
      expect_none(of_two, tolerance);
    }
  }
}

std::vector<Station> within(Seeded& seeded, int count, Point low, double width) {
  std::vector<Station> stations;
  for (int i = 0; i < count; ++i) {
    stations.push_back({std::to_string(i),
                        {low.x + seeded.uniform(0, width), low.y + seeded.uniform(0, width)},
                        0});
  }
  return stations;
}

TEST(NearestSets, law_1_in_a_plane_they_add_up_to_what_components_hand_over) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(4); ++round) {
    const gappy::Study study = gappy::random_study(seeded);
    expect_as_components(study.weighing, 1e-13);
  }
}

// Four cells meet at each corner, and basins have their corners, edges and holes there.
TEST(NearestSets, law_2_so_they_do_on_a_lattice) {
  Seeded seeded;
  std::vector<Station> stations;
  for (int i = 0; i < 36; ++i)
    stations.push_back({std::to_string(i), {1.0 * (i % 6), 1.0 * (i / 6)}, 0});
  const std::vector<Basin> basins{
      shapes::basin({{shapes::rectangle({0.5, 0.5}, {3.5, 4.5}),
                      {shapes::reversed(shapes::rectangle({1, 1}, {2, 2.5}))}}}),
      shapes::basin({{shapes::star(seeded, {3, 3}, 2.5, 20), {}}})};
  const gappy::Study study(stations, basins);
  expect_as_components(study.weighing, 1e-13);
}

// Gauges are some 15 km apart, and the vertices of what components hand over are right to a
// millimetre, which is 7e-8 of that.
TEST(NearestSets, law_3_on_the_earth_they_do_as_nearly_as_vertices_are_known) {
  Seeded seeded;
  const std::vector<Station> stations = within(seeded, 60, {5, 45}, 1);
  const std::vector<Basin> basins{
      shapes::basin({{shapes::rectangle({5.2, 45.1}, {5.7, 45.8}), {}}}),
      shapes::basin({{shapes::star(seeded, {5.5, 45.5}, 0.4, 20), {}}})};
  const Network network(stations, Metric::geodesic);
  const Weighing weighing(network, basins, {Metric::geodesic, 1, 0.1});
  expect_as_components(weighing, 7e-8);
}

TEST(NearestSets, law_4_where_cells_are_wider_than_charts_they_are_not_known) {
  Seeded seeded;
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({1, 41}, {9, 49}), {}}})};
  const Network network(within(seeded, 12, {0, 40}, 10), Metric::geodesic);
  const Weighing weighing(network, basins, {Metric::geodesic, 1, 0.1});
  const Handovers handovers(weighing, 1);
  NearestSets sets(handovers, 0);
  NearestSets::Bench bench = sets.bench();
  std::size_t unknown = 0;
  for (std::uint32_t c = 0; c < handovers.adjacency().cells(); ++c) {
    const auto shares = sets.of(Cells{PlaceIndex{c}}, bench);
    if (shares->is_known) continue;
    ++unknown;
    EXPECT_TRUE(shares->weights.empty());
  }
  EXPECT_GT(unknown, 0u);
}

}  // namespace
}  // namespace thiessen
