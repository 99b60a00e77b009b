#include "tessellation/topology_table_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

template <int Dimension>
NumberedTable<Dimension> read(const std::vector<std::string>& lines) {
  TopologyTableReader<Dimension> reader("table.txt");
  for (std::size_t i = 0; i < lines.size(); ++i) reader.take(lines[i], i + 1);
  return std::move(reader).table();
}

TEST(TopologyTableReader, knows_a_table_by_its_first_line) {
  EXPECT_TRUE(TopologyTableReader<2>::begins_table("point 1 0 0"));
  EXPECT_TRUE(TopologyTableReader<2>::begins_table(" point\t12 0 0 0"));
  for (const char* other : {"", "x,y", "1,2", "point,x,y", "point x y", "points 1 2", "vertex 1"})
    EXPECT_FALSE(TopologyTableReader<2>::begins_table(other)) << other;
}

TEST(TopologyTableReader, reads_points_in_the_order_of_their_numbers) {
  const auto table = read<2>({"# saved", "point 7 -0 2.5", "", "point 3 1e3 4"});
  EXPECT_EQ(table.file, "table.txt");
  EXPECT_EQ(table.numbers, (std::vector<std::uint64_t>{3, 7}));
  EXPECT_EQ(table.positions, (std::vector<Point>{{1000, 4}, {0, 2.5}}));
  EXPECT_TRUE(table.vertices.empty());
}

TEST(TopologyTableReader, reads_vertices) {
  const auto table =
      read<3>({"point 1 0 0 0", "point 2 1 0 0", "point 3 0 1 0", "point 4 0 0 1",
               "vertex 9 center 0.5 0.5 infinity radius 1 forming 1 2 3 4 neighbors 0 12 0 0"});
  ASSERT_EQ(table.vertices.size(), 1U);
  EXPECT_EQ(table.vertices[0].number, 9U);
  EXPECT_EQ(table.vertices[0].forming, (std::array<std::uint64_t, 4>{1, 2, 3, 4}));
  EXPECT_EQ(table.vertices[0].neighbours, (std::array<std::uint64_t, 4>{0, 12, 0, 0}));
  EXPECT_EQ(table.vertices[0].line, 5U);
}

TEST(TopologyTableReader, tells_every_bad_line) {
  std::string said;
  for (const std::string& sentence : complaints_of([] {
         read<2>({"point 1 0 0", "point 2 0", "point 0 1 1", "point 3 x 1", "point 4 1 1e70",
                  "point 1 5 5", "point 6 0 0", "edge 1 2",
                  "vertex 1 center 0 0 radius 1 forming 1 2 neighbors 0 0",
                  "vertex 1 center 0 0 radius 1 forming 1 2 0 neighbors 0 0 0", "point 8 1 2 3"});
       }))
    said += sentence + "\n";
  for (const char* part :
       {"table.txt:2: the line of a point is `point ID X Y`",
        "table.txt:3: a point's number is no whole number from 1: '0'",
        "table.txt:4: x is no number: 'x'", "table.txt:5: y is outside the supported range",
        "table.txt:6: point 1 is told of in line 1 already",
        "table.txt:7: point 6 is where point 1 is, in line 1",
        "table.txt:8: a line begins with point or vertex, not with 'edge'",
        "table.txt:9: the line of a vertex is `vertex ID center X Y radius R forming F1 F2 F3 "
        "neighbors N1 N2 N3`",
        "table.txt:10: no number of a point or a vertex: '0'",
        "a session in three dimensions takes points in space"})
    EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
}

}  // namespace
}  // namespace thiessen
