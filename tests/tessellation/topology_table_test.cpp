#include "tessellation/topology_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tessellation/session.h"

namespace thiessen {
namespace {

template <int Dimension>
std::string table_of(const TessellationSession<Dimension>& session) {
  std::string text;
  write_topology_table<Dimension>(
      session.tessellation(), [&](PointId p) { return session.number_of(p); },
      [&](std::string_view line) { text += line; });
  return text;
}

/// A simplex by its points' numbers; none for what is outside the hull.
using Simplex = std::set<std::string>;
/// For each simplex, which lies across from each of its points.
using Table = std::map<Simplex, std::map<std::string, Simplex>>;

/// Of `print`'s text.
Table parsed(const std::string& text) {
  std::map<std::string, std::vector<std::string>> forming, neighbours;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, id;
    words >> kind >> id;
    if (kind != "vertex") continue;
    std::vector<std::string>* target = nullptr;
    for (std::string word; words >> word;) {
      if (word == "forming") {
        target = &forming[id];
      } else if (word == "neighbors") {
        target = &neighbours[id];
      } else if (target != nullptr) {
        target->push_back(word);
      }
    }
  }
  Table table;
  for (const auto& [id, points] : forming) {
    auto& row = table[{points.begin(), points.end()}];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string& neighbour = neighbours[id].at(i);
      row[points[i]] = neighbour == "0"
                           ? Simplex{}
                           : Simplex{forming.at(neighbour).begin(), forming.at(neighbour).end()};
    }
  }
  return table;
}

/// A row of the thesis: `W2 Q P5 P1 V1 W3 W1`.
Table of_thesis(const std::vector<std::string>& rows, const std::map<std::string, std::string>& q) {
  std::map<std::string, std::vector<std::string>> forming, neighbours;
  for (const std::string& row : rows) {
    std::istringstream words(row);
    std::string name, word;
    words >> name;
    for (int i = 0; words >> word; ++i) {
      if (i >= 3) {
        neighbours[name].push_back(word);
      } else {
        forming[name].push_back(q.count(word) > 0 ? q.at(word) : word.substr(1));
      }
    }
  }
  Table table;
  for (const auto& [name, points] : forming) {
    auto& row = table[{points.begin(), points.end()}];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string& neighbour = neighbours[name].at(i);
      if (neighbour != "0") {
        row[points[i]] = {forming.at(neighbour).begin(), forming.at(neighbour).end()};
      } else {
        row[points[i]] = {};
      }
    }
  }
  return table;
}

TEST(TopologyTable, is_that_of_figure_5_and_with_q_added_table_5) {
  TessellationSession<2> session;
  for (const Point p : {Point{16, 23}, {6, 22}, {22, 10}, {39, 9}, {19, 39}}) session.add(p);
  EXPECT_EQ(parsed(table_of(session)), of_thesis({"V1 P1 P2 P5 0 V3 V2", "V2 P1 P2 P3 0 V4 V1",
                                                  "V3 P5 P1 P4 V4 0 V1", "V4 P3 P4 P1 V3 V2 0"},
                                                 {}));
  session.add({19, 24});
  EXPECT_EQ(parsed(table_of(session)),
            of_thesis({"V1 P1 P2 P5 0 W2 V2", "V2 P1 P2 P3 0 W3 V1", "W1 Q P5 P4 0 W4 W2",
                       "W2 Q P5 P1 V1 W3 W1", "W3 Q P3 P1 V2 W2 W4", "W4 Q P3 P4 0 W1 W3"},
                      {{"Q", "6"}}));
}

// In table 8 the thesis gives W2 itself for W2's first neighbour.
TEST(TopologyTable, is_table_6_and_with_q_deleted_table_8) {
  TessellationSession<2> session;
  for (const Point p :
       {Point{35, 2}, {15, 37}, {2, 15}, {23, 7}, {35, 21}, {38, 12}, {3, 33}, {15, 29}}) {
    session.add(p);
  }
  EXPECT_EQ(parsed(table_of(session)),
            of_thesis({"V1 P2 Q P5 V3 0 V4", "V2 P7 P3 Q V5 V4 0", "V3 P5 P4 Q V5 V1 V7",
                       "V4 Q P2 P7 0 V2 V1", "V5 P3 Q P4 V3 V6 V2", "V6 P3 P4 P1 V8 0 V5",
                       "V7 P5 P6 P4 V8 V3 0", "V8 P1 P4 P6 V7 0 V6"},
                      {{"Q", "8"}}));
  session.remove({15, 29});
  EXPECT_EQ(parsed(table_of(session)),
            of_thesis({"V6 P3 P4 P1 V8 0 W1", "V7 P5 P6 P4 V8 W3 0", "V8 P1 P4 P6 V7 0 V6",
                       "W1 P3 P4 P2 W3 W2 V6", "W2 P7 P3 P2 W1 0 0", "W3 P2 P5 P4 V7 W1 0"},
                      {}));
}

TEST(TopologyTable, has_a_line_a_point_and_a_line_a_vertex) {
  TessellationSession<2> session;
  for (const Point p : {Point{0, 0}, {-0.1, 3}, {1e20, 0}}) session.add(p);
  session.remove({1e20, 0});
  EXPECT_EQ(table_of(session), "point 1 0 0\npoint 2 -0.1 3\n");
  session.remove({-0.1, 3});
  session.add({3, 0});
  session.add({0, 4});
  const std::string text = table_of(session);
  EXPECT_EQ(text.substr(0, text.find("vertex")), "point 1 0 0\npoint 4 3 0\npoint 5 0 4\n");
  EXPECT_NE(text.find(" center 1.5 2 radius 2.5 forming "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(" neighbors 0 0 0\n")) << text;
}

TEST(TopologyTable, in_space_has_four_of_each) {
  TessellationSession<3> session;
  for (const SpacePoint& p : {SpacePoint{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}) session.add(p);
  EXPECT_EQ(table_of(session), "point 1 0 0 0\npoint 2 2 0 0\npoint 3 0 3 0\n");
  session.add({0, 0, 6});
  session.add({0, 0, -1});
  const Table table = parsed(table_of(session));
  const Table expected{
      {{"1", "2", "3", "4"}, {{"1", {}}, {"2", {}}, {"3", {}}, {"4", {"1", "2", "3", "5"}}}},
      {{"1", "2", "3", "5"}, {{"1", {}}, {"2", {}}, {"3", {}}, {"5", {"1", "2", "3", "4"}}}}};
  EXPECT_EQ(table, expected);
  EXPECT_NE(table_of(session).find(" center 1 1.5 3 radius 3.5 "), std::string::npos);
}

TEST(TopologyTable, gives_the_same_digits_for_the_same_points) {
  const std::vector<Point> points{{0.1, 0.7}, {3.3, 0.2}, {2.1, 5.9}, {9.7, 4.3}};
  const auto numbers_of_vertices = [](const TessellationSession<2>& session) {
    std::set<std::string> digits;
    std::istringstream lines(table_of(session));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t center = line.find("center");
      if (center == std::string::npos) continue;
      digits.insert(line.substr(center, line.find("forming") - center));
    }
    return digits;
  };
  TessellationSession<2> forward, backward;
  for (auto p = points.begin(); p != points.end(); ++p) forward.add(*p);
  for (auto p = points.rbegin(); p != points.rend(); ++p) backward.add(*p);
  EXPECT_EQ(numbers_of_vertices(forward), numbers_of_vertices(backward));
  EXPECT_EQ(numbers_of_vertices(forward).size(), 2u);
}

TEST(CellText, says_the_vertices_the_area_and_the_neighbours) {
  TessellationSession<2> session;
  for (const Point p : {Point{0, 0}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}) session.add(p);
  const auto number_of = [&](PointId p) { return session.number_of(p); };
  const auto& tessellation = session.tessellation();
  const PlaneCell cell = find_cell(tessellation, session.point_at({0, 0}));
  const auto id = [&](std::size_t i) { return std::to_string(index(cell.vertices[i].vertex) + 1); };
  const std::string radius = " radius 1.4142135623730951\n";
  EXPECT_EQ(cell_text(tessellation, number_of, cell),
            "point 1 0 0\nvertex " + id(0) + " center -1 -1" + radius + "vertex " + id(1) +
                " center 1 -1" + radius + "vertex " + id(2) + " center 1 1" + radius + "vertex " +
                id(3) + " center -1 1" + radius + "area 4\nneighbors 3 5 2 4\n");
  const PlaneCell outer = find_cell(tessellation, session.point_at({0, 2}));
  const std::string text = cell_text(tessellation, number_of, outer);
  EXPECT_NE(text.find(" direction 0.7071067811865475 0.7071067811865475\n"), std::string::npos)
      << text;
  EXPECT_TRUE(text.ends_with("area infinity\nneighbors 3 1 2\n")) << text;
}

}  // namespace
}  // namespace thiessen
