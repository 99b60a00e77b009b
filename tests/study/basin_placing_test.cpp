#include "study/basin_placing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

Ring square(double west, double south, double side) {
  return {{west, south},
          {west + side, south},
          {west + side, south + side},
          {west, south + side},
          {west, south}};
}

Ring open(Ring ring) {
  ring.pop_back();
  return ring;
}

BasinList list_of(const std::vector<Ring>& rings) {
  BasinList list = {"b.csv", {}};
  for (const Ring& ring : rings) {
    const std::string id(1, static_cast<char>('a' + list.basins.size()));
    list.basins.push_back({id, "basin '" + id + "'", list.basins.size() + 2, {{ring, {}}}});
  }
  return list;
}

const MendingRules in_plane = {};
const MendingRules on_earth = {.round_the_earth = true, .kind = {}};
const Ring bow_tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 0}};

TEST(MendBasins, gives_valid_shapes_in_the_order_of_the_list_and_leaves_it_ids_and_places) {
  BasinList list = list_of({square(5, 5, 1), square(0, 0, 2)});
  Warnings warnings;
  const auto shapes = mend_basins(list, in_plane, warnings);
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes[0].at(0).outer, open(square(5, 5, 1)));
  EXPECT_EQ(shapes[1].at(0).outer, open(square(0, 0, 2)));
  EXPECT_EQ(list.basins[1].id, "b");
  EXPECT_EQ(list.basins[1].line, 3U);
  EXPECT_TRUE(list.basins[1].polygons.empty());
  EXPECT_TRUE(warnings.messages().empty());
}

TEST(MendBasins, tells_every_basin_that_cannot_be_mended) {
  BasinList list = list_of({bow_tie, square(9, 9, 1), {{0, 0}, {5, 5}, {0, 0}}, bow_tie});
  Warnings warnings;
  const auto faults = complaints_of([&] { mend_basins(list, in_plane, warnings); });
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_TRUE(faults[0].starts_with("b.csv:2: basin 'a' ")) << faults[0];
  EXPECT_TRUE(faults[1].starts_with("b.csv:4: basin 'c' ")) << faults[1];
  EXPECT_TRUE(faults[2].starts_with("b.csv:5: basin 'd' ")) << faults[2];
}

TEST(MendBasins, says_the_same_by_several_threads) {
  std::vector<Ring> rings;
  for (int i = 0; i < 20; ++i) {
    rings.push_back(square(i, i, 1));
    rings.push_back(open(square(0, i, 2)));  // which is mended, and told
  }
  const auto found = [&](unsigned threads) {
    BasinList list = list_of(rings);
    Warnings warnings;
    auto shapes = mend_basins(list, in_plane, warnings, threads);
    std::vector<Ring> outers;
    for (const MultiPolygon& shape : shapes) outers.push_back(shape.at(0).outer);
    return std::pair(outers, sentences_of(warnings));
  };
  EXPECT_EQ(found(1).second.size(), 20U);
  EXPECT_EQ(found(3), found(1));
  rings.insert(rings.begin() + 1, bow_tie);
  rings.push_back(bow_tie);
  const auto faults = complaints_of([&] { found(3); });
  EXPECT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults, complaints_of([&] { found(1); }));
}

TEST(MendBasins, edges_go_the_short_way_round_the_earth_where_there_is_one) {
  const Ring over = {{178, 0}, {-178, 0}, {-178, 4}, {178, 4}, {178, 0}};
  Warnings warnings;
  BasinList over_it = list_of({over});
  EXPECT_EQ(mend_basins(over_it, on_earth, warnings)[0][0].outer,
            (Ring{{178, 0}, {182, 0}, {182, 4}, {178, 4}}));
  BasinList as_plane = list_of({over});
  const Ring outer = mend_basins(as_plane, in_plane, warnings)[0][0].outer;
  double width = 0;
  for (const Point point : outer) width = std::max(width, std::abs(point.x - outer[0].x));
  EXPECT_EQ(width, 356);
}

TEST(MendBasins, a_ring_that_no_pole_explains_is_told_with_its_place) {
  BasinList list = list_of({{{0, 0}, {80, 0}, {160, 0}, {-120, 0}, {-40, 0}, {0, 0}}});
  Warnings warnings;
  const std::string fault = complaint_of([&] { mend_basins(list, on_earth, warnings); });
  EXPECT_TRUE(fault.starts_with("b.csv:2: basin 'a': ")) << fault;
  EXPECT_TRUE(contains(fault, "neither pole is nearer")) << fault;
}

TEST(BringBasinsTogether, puts_both_sides_of_the_antimeridian_into_one_turn) {
  std::vector<Basin> basins = {{"west", {{open(square(170, 0, 5)), {}}}, {{1, 2, 3, 4}}},
                               {"east", {{open(square(-175, 0, 5)), {}}}, {{5, 6, 7, 8}}}};
  bring_basins_together(basins);
  EXPECT_EQ(basins[0].id, "west");
  EXPECT_EQ(basins[0].shape[0].outer, open(square(170, 0, 5)));
  EXPECT_EQ(basins[1].shape[0].outer, open(square(185, 0, 5)));
  EXPECT_EQ(basins[1].bulges, (std::vector<std::vector<double>>{{5, 6, 7, 8}}));
  std::vector<MultiPolygon> shapes = {{{open(square(170, 0, 5)), {}}},
                                      {{open(square(-175, 0, 5)), {}}}};
  bring_basins_together(shapes);
  EXPECT_EQ(shapes[0][0].outer, open(square(170, 0, 5)));
  EXPECT_EQ(shapes[1][0].outer, open(square(185, 0, 5)));
}

TEST(BringBasinsTogether, leaves_what_lies_together_bit_for_bit) {
  std::vector<Basin> basins = {{"a", {{open(square(0.1, 0.3, 5)), {}}}, {}},
                               {"b", {{open(square(-7.7, 0.1, 5)), {}}}, {}}};
  const std::vector<Basin> before = basins;
  bring_basins_together(basins);
  EXPECT_EQ(basins[0].shape[0].outer, before[0].shape[0].outer);
  EXPECT_EQ(basins[1].shape[0].outer, before[1].shape[0].outer);
}

}  // namespace
}  // namespace thiessen
