#include "tessellation/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tessellation/audit.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

using Rows = std::vector<ArrangedVertex<2>>;

/// A square with its middle: four triangles.
Tessellation<2> square() {
  Tessellation<2> tessellation;
  tessellation.add_all(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}});
  return tessellation;
}

/// The finite vertices as they are.
Rows rows_of(const Tessellation<2>& tessellation) {
  Rows rows;
  const auto& topology = tessellation.topology();
  topology.for_each_vertex([&](VertexId v) {
    if (!topology.is_infinite(v)) rows.push_back({v, topology.forming(v)});
  });
  return rows;
}

TEST(Arrangement, law_1_vertices_have_the_numbers_and_the_order_that_are_wanted) {
  Tessellation<2> tessellation = square();
  Rows rows = rows_of(tessellation);
  ASSERT_EQ(rows.size(), 4U);
  std::uint32_t number = 3;
  for (auto& row : rows) {
    row.vertex = VertexId{number};
    number += 5;
    std::rotate(row.forming.begin(), row.forming.begin() + 1, row.forming.end());
  }
  EXPECT_FALSE(tessellation.arrange(rows));
  EXPECT_TRUE(audit(tessellation).empty());
  for (const auto& row : rows) EXPECT_EQ(tessellation.topology().forming(row.vertex), row.forming);
  EXPECT_EQ(tessellation.topology().size(), 19U) << "no longer than the largest number asks";
}

TEST(Arrangement, law_2_goes_on_as_any_other_tessellation) {
  Tessellation<2> tessellation = square();
  Rows rows = rows_of(tessellation);
  for (auto& row : rows) row.vertex = VertexId{static_cast<std::uint32_t>(40 - index(row.vertex))};
  ASSERT_FALSE(tessellation.arrange(rows));
  tessellation.add({0.5, 1});
  tessellation.remove(*tessellation.find({1, 1}));
  for (int i = 0; i < 30; ++i) tessellation.add({0.1 * i, 0.07 * i * i});
  EXPECT_TRUE(audit(tessellation).empty());
}

TEST(Arrangement, law_3_tells_what_does_not_fit_and_changes_nothing) {
  Tessellation<2> tessellation = square();
  const Rows rows = rows_of(tessellation);
  const auto refused = [&](Rows wrong) {
    const auto unfit = tessellation.arrange(wrong);
    EXPECT_EQ(rows_of(tessellation).front().forming, rows.front().forming);
    return unfit;
  };
  Rows turned = rows;
  std::swap(turned[2].forming[0], turned[2].forming[1]);
  EXPECT_EQ(refused(turned), 2U);
  Rows twice = rows;
  twice[3].vertex = twice[0].vertex;
  EXPECT_TRUE(refused(twice) == 3U || refused(twice) == 0U);
  Rows none_such = rows;
  none_such[1].forming[0] = none_such[1].forming[1];
  EXPECT_TRUE(refused(none_such).has_value());
  EXPECT_EQ(refused(Rows(rows.begin(), rows.end() - 1)), 3U) << "one is missing";
  EXPECT_TRUE(audit(tessellation).empty());
}

}  // namespace
}  // namespace thiessen
