// What falls silent beside silent cells, told from few cells, beside what whole components hand
// over.
#include "rainfall/gaps/departures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "rainfall/gaps/gappy_study.h"
#include "rainfall/gaps/handover_cache.h"

namespace thiessen {
namespace {

using Changes = std::map<std::pair<std::uint32_t, PlaceIndex>, double>;
using Component = std::vector<PlaceIndex>;

/// Cells of which some are silent.
struct SilentCells {
  SilentCells(Seeded& seeded, const CellAdjacency& adjacency, double share)
      : is_silent(adjacency.cells(), false) {
    Component silent;
    for (std::uint32_t c = 0; c < is_silent.size(); ++c) {
      is_silent[c] = seeded.uniform(0, 1) < share;
      if (is_silent[c]) silent.push_back(PlaceIndex{c});
    }
    components = components_of(silent, adjacency);
  }
  std::vector<const Component*> beside(PlaceIndex cell, const CellAdjacency& adjacency) const {
    std::vector<const Component*> found;
    for (const Component& component : components) {
      const auto next = adjacency.neighbours(cell);
      const bool is_beside = std::any_of(next.begin(), next.end(), [&](PlaceIndex q) {
        return std::binary_search(component.begin(), component.end(), q);
      });
      if (is_beside) found.push_back(&component);
    }
    return found;
  }

  std::vector<bool> is_silent;
  std::vector<Component> components;
};

/// The joint component's handover less those of its parts.
Changes by_joint_component(const Handovers& handovers, PlaceIndex cell,
                           const std::vector<const Component*>& beside) {
  Changes changes;
  const auto add = [&](const Component& component, double sign) {
    for (const CellWeight& share : handovers.of(component)) {
      if (share.cell != cell) changes[{share.basin, share.cell}] += sign * share.weight;
    }
  };
  Component joint{cell};
  for (const Component* component : beside) {
    joint.insert(joint.end(), component->begin(), component->end());
    add(*component, -1);
  }
  std::sort(joint.begin(), joint.end());
  add(joint, 1);
  return changes;
}

Changes by_departure(const Handovers& handovers, Departures& departures, PlaceIndex cell,
                     const SilentCells& silent, const std::vector<const Component*>& beside) {
  std::vector<std::shared_ptr<const Handover>> components;
  for (const Component* component : beside)
    components.push_back(std::make_shared<const Handover>(handovers.of(*component, true)));
  std::vector<PlaceIndex> reporting;
  for (const PlaceIndex q : handovers.adjacency().neighbours(cell)) {
    if (!silent.is_silent[index(q)]) reporting.push_back(q);
  }
  Changes changes;
  Departures::Bench bench;
  departures.of(cell, {components, reporting}, bench,
                [&](std::uint32_t basin, PlaceIndex heir, double weight) {
                  EXPECT_FALSE(silent.is_silent[index(heir)]);
                  EXPECT_NE(heir, cell);
                  changes[{basin, heir}] += weight;
                });
  return changes;
}

void expect_near(const Changes& found, const Changes& expected, double tolerance) {
  Changes differences = found;
  for (const auto& [key, weight] : expected) differences[key] -= weight;
  for (const auto& [key, difference] : differences) EXPECT_NEAR(difference, 0, tolerance);
}

void expect_as_joint_components(Seeded& seeded, const Weighing& weighing, double tolerance) {
  const Handovers handovers(weighing, 1);
  Departures departures(handovers, std::size_t{1} << 22);
  const CellAdjacency& adjacency = handovers.adjacency();
  for (const double share : {0.05, 0.2, 0.5, 0.8}) {
    const SilentCells silent(seeded, adjacency, share);
    for (std::uint32_t c = 0; c < adjacency.cells(); ++c) {
      const PlaceIndex cell{c};
      if (silent.is_silent[c] || handovers.cells().stations_of(cell).empty()) continue;
      const auto beside = silent.beside(cell, adjacency);
      expect_near(by_departure(handovers, departures, cell, silent, beside),
                  by_joint_component(handovers, cell, beside), tolerance);
    }
  }
}

TEST(Departures, law_1_in_a_plane_they_are_what_joint_components_hand_over) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(4); ++round) {
    const gappy::Study study = gappy::random_study(seeded);
    expect_as_joint_components(seeded, study.weighing, 1e-13);
  }
}

// Four cells meet at each corner, and basins have their corners and edges there.
TEST(Departures, law_2_so_they_are_on_a_lattice) {
  Seeded seeded;
  std::vector<Station> stations;
  for (int i = 0; i < 36; ++i)
    stations.push_back({std::to_string(i), {1.0 * (i % 6), 1.0 * (i / 6)}, 0});
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({0.5, 0.5}, {3.5, 4.5}), {}}}),
                                  shapes::basin({{shapes::star(seeded, {3, 3}, 2.5, 20), {}}})};
  const gappy::Study study(stations, basins);
  for (std::uint64_t round = 0; round < Seeded::rounds(4); ++round)
    expect_as_joint_components(seeded, study.weighing, 1e-13);
}

// Both are right to 1e-7 where gauges are 100 km apart.
TEST(Departures, law_3_on_the_earth_they_are_as_near_as_charts_are) {
  Seeded seeded;
  for (const int count : {8, 40, 200}) {
    std::vector<Station> stations;
    for (int i = 0; i < count; ++i)
      stations.push_back({std::to_string(i), {seeded.uniform(0, 5), seeded.uniform(40, 45)}, 0});
    const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({1, 41}, {3, 44}), {}}}),
                                    shapes::basin({{shapes::star(seeded, {3, 43}, 1.5, 20), {}}})};
    const Network network(stations, Metric::geodesic);
    const Weighing weighing(network, basins, {Metric::geodesic, 1, 0.1});
    expect_as_joint_components(seeded, weighing, count > 8 ? 1e-7 : 1e-5);
  }
}

// A gauge at the edge of a component outside all basins has its ground taken over beyond it.
TEST(Departures, law_4_silent_cells_without_ground_are_seen_past) {
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {1, 1}), {}}})};
  const gappy::Study study({{"a", {0, 0}, 0}, {"b", {4, 0}, 0}, {"c", {8, 0}, 0}}, basins);
  const Handovers handovers(study.weighing, 1);
  Departures departures(handovers, 0);
  const std::vector<std::shared_ptr<const Handover>> beside{
      std::make_shared<const Handover>(handovers.of(std::vector{PlaceIndex{1}}, true))};
  Departures::Bench bench;
  double taken = 0;
  departures.of(PlaceIndex{0}, {beside, {}}, bench,
                [&](std::uint32_t, PlaceIndex heir, double weight) {
                  EXPECT_EQ(heir, PlaceIndex{2});
                  taken += weight;
                });
  EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace thiessen
