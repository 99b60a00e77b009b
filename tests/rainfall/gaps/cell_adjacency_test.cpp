#include "rainfall/gaps/cell_adjacency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/gaps/nine_gauges.h"

namespace thiessen {
namespace {

/// A diagram of some places with pairs of neighbours at random, of which some share another's cell.
Diagram random_neighbours(Seeded& seeded, std::uint32_t places) {
  Diagram diagram;
  diagram.places.resize(places);
  const auto any = [&] { return PlaceIndex{static_cast<std::uint32_t>(seeded.below(places))}; };
  for (std::uint32_t i = 0; i < places; ++i) {
    const bool is_shared = i > 0 && seeded.below(5) == 0;
    diagram.cell_of.push_back(is_shared ? diagram.cell_of[seeded.below(i)] : PlaceIndex{i});
  }
  for (std::uint32_t i = 0; i < places; ++i) diagram.neighbours.emplace_back(any(), any());
  return diagram;
}

std::set<PlaceIndex> neighbours_of(const Diagram& diagram, PlaceIndex cell) {
  std::set<PlaceIndex> neighbours;
  for (const auto& [p, q] : diagram.neighbours) {
    const PlaceIndex a = diagram.cell_of[index(p)];
    const PlaceIndex b = diagram.cell_of[index(q)];
    if (a == cell && b != cell) neighbours.insert(b);
    if (b == cell && a != cell) neighbours.insert(a);
  }
  return neighbours;
}

TEST(CellAdjacency, law_1_the_neighbours_of_a_cell_are_those_of_all_its_places_once_in_order) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Diagram diagram = random_neighbours(seeded, 1 + static_cast<std::uint32_t>(round % 30));
    const CellAdjacency adjacency(diagram);
    ASSERT_EQ(adjacency.cells(), diagram.places.size());
    for (std::uint32_t i = 0; i < diagram.places.size(); ++i) {
      const auto found = adjacency.neighbours(PlaceIndex{i});
      const std::set<PlaceIndex> expected = neighbours_of(diagram, PlaceIndex{i});
      ASSERT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      const bool has_cell = diagram.cell_of[i] == PlaceIndex{i};
      ASSERT_TRUE(has_cell || found.empty());
    }
  }
}

/// Whether a way through the cells leads from one to the other, by steps as many as there are
/// cells.
bool is_way(const Diagram& diagram, const std::set<PlaceIndex>& cells, PlaceIndex from,
            PlaceIndex to) {
  std::set<PlaceIndex> reached{from};
  for (std::size_t step = 0; step < cells.size(); ++step) {
    for (const PlaceIndex p : std::set<PlaceIndex>(reached)) {
      for (const PlaceIndex q : neighbours_of(diagram, p)) {
        if (cells.count(q) == 1) reached.insert(q);
      }
    }
  }
  return reached.count(to) == 1;
}

TEST(ComponentsOf, law_2_two_cells_are_in_one_where_a_way_leads_from_one_to_the_other) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(50); ++round) {
    const Diagram diagram = random_neighbours(seeded, 15);
    std::set<PlaceIndex> cells;
    for (std::uint32_t i = 0; i < 15; ++i) {
      if (diagram.cell_of[i] == PlaceIndex{i} && seeded.below(3) > 0) cells.insert(PlaceIndex{i});
    }
    const std::vector<PlaceIndex> list(cells.begin(), cells.end());
    const auto components = components_of(list, CellAdjacency(diagram));
    std::vector<PlaceIndex> first;
    std::vector<PlaceIndex> all;
    for (const auto& component : components) {
      ASSERT_TRUE(std::is_sorted(component.begin(), component.end()));
      first.push_back(component.front());
      all.insert(all.end(), component.begin(), component.end());
      for (const PlaceIndex p : cells) {
        const bool is_member = std::count(component.begin(), component.end(), p) == 1;
        ASSERT_EQ(is_member, is_way(diagram, cells, component.front(), p));
      }
    }
    ASSERT_TRUE(std::is_sorted(first.begin(), first.end()));
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all, list);
  }
}

class CellsOfNineGauges : public NineGauges {};

TEST_F(CellsOfNineGauges, silent_cells_are_parted_into_components) {
  const auto components = components_of(cells({0, 2, 4, 5, 8}), handovers_.adjacency());
  // Diagonals of the grid are ties: which of them are neighbours is the tessellation's choice.
  std::size_t count = 0;
  for (const auto& component : components) {
    EXPECT_TRUE(std::is_sorted(component.begin(), component.end()));
    count += component.size();
  }
  EXPECT_EQ(count, 5u);
  const auto apart = components_of(cells({0, 2, 6, 8}), handovers_.adjacency());
  EXPECT_EQ(apart.size(), 4u);
  const auto row = components_of(cells({3, 4, 5}), handovers_.adjacency());
  ASSERT_EQ(row.size(), 1u);
  EXPECT_EQ(row[0], cells({3, 4, 5}));
}

}  // namespace
}  // namespace thiessen
