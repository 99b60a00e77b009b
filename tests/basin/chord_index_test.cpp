// Chords near a box, judged by looking at each.
#include "basin/chord_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "diagram/plane_diagram.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

std::vector<std::uint32_t> found_near(const ChordIndex& chords, const Box& box) {
  std::vector<std::uint32_t> found;
  chords.for_each_near(box, [&](std::uint32_t chord) { found.push_back(chord); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::uint32_t> near_one_by_one(const Diagram& diagram, const Box& box) {
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < diagram.chords.size(); ++i) {
    const Point a = diagram.nodes[diagram.chords[i].from];
    const Point b = diagram.nodes[diagram.chords[i].to];
    const bool apart = std::max(a.x, b.x) < box.low.x || std::min(a.x, b.x) > box.high.x ||
                       std::max(a.y, b.y) < box.low.y || std::min(a.y, b.y) > box.high.y;
    if (!apart) near.push_back(i);
  }
  return near;
}

/// So many chords, some of which continue the one before; of whole coordinates, so that boxes
/// touch.
Diagram random_chords(Seeded& seeded, std::size_t count) {
  Diagram diagram;
  const auto new_node = [&] {
    diagram.nodes.push_back(
        {static_cast<double>(seeded.whole(0, 60)), static_cast<double>(seeded.whole(0, 60))});
    return static_cast<std::uint32_t>(diagram.nodes.size() - 1);
  };
  while (diagram.chords.size() < count) {
    const bool goes_on = !diagram.chords.empty() && seeded.below(4) > 0;
    const std::uint32_t from = goes_on ? diagram.chords.back().to : new_node();
    diagram.chords.push_back({from, new_node(), PlaceIndex{0}, PlaceIndex{1}});
  }
  return diagram;
}

// With few chords, which are searched one by one, and with many.
TEST(ChordIndex, law_1_finds_each_chord_whose_box_meets_the_box_once) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(150); ++round) {
    const Diagram diagram = random_chords(seeded, round);
    const ChordIndex chords(diagram);
    const ChordIndex seldom(diagram, Searches::few);
    for (int i = 0; i < 20; ++i) {
      const auto corner = [&] {
        return Point{static_cast<double>(seeded.whole(-5, 65)),
                     static_cast<double>(seeded.whole(-5, 65))};
      };
      const Box box = box_of(corner(), corner());
      ASSERT_EQ(found_near(chords, box), near_one_by_one(diagram, box)) << round;
      ASSERT_EQ(found_near(seldom, box), near_one_by_one(diagram, box)) << round;
    }
  }
}

TEST(ChordIndex, law_2_finds_all_of_a_diagram_near_its_frame_and_none_far_away) {
  Seeded seeded;
  std::vector<Point> places(300);
  for (Point& p : places) p = {seeded.uniform(0, 1), seeded.uniform(0, 1)};
  const Diagram diagram = plane_diagram(places, {{0, 0}, {1, 1}});
  const ChordIndex chords(diagram);
  std::vector<std::uint32_t> all(diagram.chords.size());
  std::iota(all.begin(), all.end(), 0u);
  ASSERT_GT(all.size(), 40u);
  EXPECT_EQ(found_near(chords, {{-1e9, -1e9}, {1e9, 1e9}}), all);
  EXPECT_TRUE(found_near(chords, {{1e6, 1e6}, {2e6, 2e6}}).empty());
}

// A run ends after four chords, and a chord that begins elsewhere begins another one.
TEST(ChordIndex, law_3_a_box_within_one_chord_of_a_run_finds_that_chord_alone) {
  Diagram diagram;
  for (std::uint32_t i = 0; i <= 50; ++i) diagram.nodes.push_back({10.0 * i, 0});
  for (std::uint32_t i = 0; i < 50; ++i)
    diagram.chords.push_back({i, i + 1, PlaceIndex{0}, PlaceIndex{1}});
  const ChordIndex chords(diagram);
  for (std::uint32_t i = 0; i < 50; ++i) {
    const double middle = 10.0 * i + 5;
    EXPECT_EQ(found_near(chords, {{middle, -1}, {middle, 1}}), std::vector<std::uint32_t>{i});
  }
  EXPECT_EQ(found_near(chords, {{200, 0}, {200, 0}}), (std::vector<std::uint32_t>{19, 20}));
}

}  // namespace
}  // namespace thiessen
