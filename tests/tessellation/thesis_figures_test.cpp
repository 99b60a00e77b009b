// The figures on the way from the thesis' figure 5 to table 5, by insertion (section 2.2), and from
// figure 11 to table 8, by deletion (section 2.3). The tables at both ends stand in
// topology_table_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/integer_determinants.h"
#include "tessellation/conflict_zone.h"
#include "tessellation/star.h"
#include "tessellation/tessellation.h"
#include "tessellation/voronoi_vertex.h"

namespace thiessen {
namespace {

using Names = std::set<std::string>;

/// The words of a row of the thesis, in their order.
std::vector<std::string> words_of(const std::string& row) {
  std::istringstream stream(row);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}
Names names_in(const std::string& row) {
  const std::vector<std::string> words = words_of(row);
  return {words.begin(), words.end()};
}

/// A tessellation in the names of the thesis: points P1, P2, ... in the order in which they come
/// and Q, the last, and vertices by their forming points.
class Construct {
 public:
  void add(const std::string& name, whole::Position position) {
    const PointId p = tessellation_.add(whole::point(position, 1));
    point_names_[p] = name;
    points_[name] = p;
    places_[name] = position;
  }
  void remove(const std::string& name) { tessellation_.remove(points_.at(name)); }
  /// `V1`, `P1 P2 P5`.
  void call(const std::string& vertex, const std::string& forming) { forming_[vertex] = forming; }

  const Tessellation<2>& tessellation() const { return tessellation_; }
  whole::Position place(const std::string& point) const { return places_.at(point); }
  PointId point(const std::string& name) const { return points_.at(name); }

  /// no_vertex where there is none.
  VertexId vertex(const std::string& name) const {
    VertexId found = no_vertex;
    const Names wanted = names_in(forming_.at(name));
    tessellation_.topology().for_each_vertex([&](VertexId v) {
      if (points_of(v) == wanted) found = v;
    });
    return found;
  }
  bool has(const std::string& name) const { return vertex(name) != no_vertex; }
  /// `0` for one outside the hull, `?` for one that was given no name.
  std::string name_of(VertexId v) const {
    if (tessellation_.topology().is_infinite(v)) return "0";
    for (const auto& [name, forming] : forming_) {
      if (points_of(v) == names_in(forming)) return name;
    }
    return "?";
  }
  std::string name_of(PointId p) const {
    return p == infinite_point ? "infinity" : point_names_.at(p);
  }
  Names points_of(VertexId v) const {
    Names names;
    for (const PointId p : tessellation_.topology().forming(v)) names.insert(name_of(p));
    return names;
  }
  /// The points that a vertex and its neighbour have in common.
  Names common_points(VertexId v, std::size_t side) const {
    Names names = points_of(v);
    names.erase(name_of(tessellation_.topology().forming(v)[side]));
    return names;
  }

  /// The neighbouring vertices, in the order of the forming points that they lie across from.
  std::string neighbours(const std::string& vertex_name) const {
    const Topology<2>& topology = tessellation_.topology();
    const VertexId v = vertex(vertex_name);
    if (v == no_vertex) return vertex_name + " is not there";
    std::string names;
    for (const std::string& name : words_of(forming_.at(vertex_name))) {
      const std::size_t corner = topology.corner_of(v, points_.at(name));
      names += (names.empty() ? "" : " ") + name_of(topology.neighbour(v, corner));
    }
    return names;
  }

 private:
  Tessellation<2> tessellation_;
  std::map<PointId, std::string> point_names_;
  std::map<std::string, PointId> points_;
  std::map<std::string, whole::Position> places_;
  std::map<std::string, std::string> forming_;
};

constexpr whole::Position q_of_figure_6{19, 24};

Construct figure_5() {
  Construct construct;
  construct.add("P1", {16, 23});
  construct.add("P2", {6, 22});
  construct.add("P3", {22, 10});
  construct.add("P4", {39, 9});
  construct.add("P5", {19, 39});
  construct.call("V1", "P1 P2 P5");
  construct.call("V2", "P1 P2 P3");
  construct.call("V3", "P5 P1 P4");
  construct.call("V4", "P3 P4 P1");
  return construct;
}

void call_new_vertices_of_figure_7(Construct& construct) {
  construct.call("W1", "Q P5 P4");
  construct.call("W2", "Q P5 P1");
  construct.call("W3", "Q P3 P1");
  construct.call("W4", "Q P3 P4");
}

ConflictZone<2> zone_of_q(const Construct& construct) {
  ConflictZone<2> zone;
  EXPECT_TRUE(
      construct.tessellation().find_conflict_zone(whole::point(q_of_figure_6, 1), {}, zone));
  return zone;
}

// Step 1 of insertion: Q is nearer to V3 and V4 than their forming points are.
TEST(ThesisFigures, figure_6_is_the_list_of_deleted_vertices) {
  const Construct construct = figure_5();
  const Names listofv{"V3", "V4"};
  const ConflictZone<2> zone = zone_of_q(construct);
  Names deleted;
  for (const VertexId v : zone.vertices()) deleted.insert(construct.name_of(v));
  EXPECT_EQ(deleted, listofv);
  for (const std::string name : {"V1", "V2", "V3", "V4"}) {
    const auto vertex =
        voronoi_vertex(construct.tessellation().structure(), construct.vertex(name));
    const double distance = std::hypot(19 - vertex.centre.x, 24 - vertex.centre.y);
    EXPECT_EQ(distance < vertex.radius, listofv.count(name) == 1) << name;
  }
}

// Steps 2 and 3: for each of W1 to W4 its neighbour outside the list, the deleted vertex, and the
// two forming points that these have in common (table 3).
TEST(ThesisFigures, figures_7_and_8_are_the_rim_of_the_deleted_vertices) {
  const Construct construct = figure_5();
  const ConflictZone<2> zone = zone_of_q(construct);
  std::multiset<std::vector<std::string>> rim;
  for (const auto& facet : zone.rim()) {
    const Names common = construct.common_points(facet.inside, facet.side);
    ASSERT_EQ(common, construct.common_points(facet.outside, facet.outside_side));
    ASSERT_EQ(common.size(), 2u);
    rim.insert({construct.name_of(facet.outside), construct.name_of(facet.inside), *common.begin(),
                *common.rbegin()});
  }
  const std::multiset<std::vector<std::string>> expected{{"0", "V3", "P4", "P5"},
                                                         {"V1", "V3", "P1", "P5"},
                                                         {"V2", "V4", "P1", "P3"},
                                                         {"0", "V4", "P3", "P4"}};
  EXPECT_EQ(rim, expected);
}

// Step 5: V1 and V2, which stay, have W2 and W3 in the place of V3 and V4.
TEST(ThesisFigures, table_4_is_what_the_vertices_that_stay_have_for_neighbours) {
  Construct construct = figure_5();
  EXPECT_EQ(construct.neighbours("V1"), "0 V3 V2");
  EXPECT_EQ(construct.neighbours("V2"), "0 V4 V1");
  const VertexId first = construct.vertex("V1");
  const VertexId second = construct.vertex("V2");
  construct.add("Q", q_of_figure_6);
  call_new_vertices_of_figure_7(construct);
  EXPECT_FALSE(construct.has("V3"));
  EXPECT_FALSE(construct.has("V4"));
  EXPECT_EQ(construct.vertex("V1"), first);
  EXPECT_EQ(construct.vertex("V2"), second);
  EXPECT_EQ(construct.neighbours("V1"), "0 W2 V2");
  EXPECT_EQ(construct.neighbours("V2"), "0 W3 V1");
}

// Step 6: W1 and W2 have Q and P5 in common, so each lies across from the other's third point.
TEST(ThesisFigures, figure_9_is_two_new_vertices_that_differ_in_one_point) {
  Construct construct = figure_5();
  construct.add("Q", q_of_figure_6);
  call_new_vertices_of_figure_7(construct);
  const Topology<2>& topology = construct.tessellation().topology();
  const VertexId w1 = construct.vertex("W1");
  const VertexId w2 = construct.vertex("W2");
  ASSERT_NE(w1, no_vertex);
  ASSERT_NE(w2, no_vertex);
  const std::size_t across_from_p4 = topology.corner_of(w1, construct.point("P4"));
  const std::size_t across_from_p1 = topology.corner_of(w2, construct.point("P1"));
  EXPECT_EQ(topology.neighbour(w1, across_from_p4), w2);
  EXPECT_EQ(topology.neighbour(w2, across_from_p1), w1);
  EXPECT_EQ(construct.common_points(w1, across_from_p4), (Names{"Q", "P5"}));
  EXPECT_EQ(construct.common_points(w2, across_from_p1), (Names{"Q", "P5"}));
}

Construct figure_11() {
  Construct construct;
  construct.add("P1", {35, 2});
  construct.add("P2", {15, 37});
  construct.add("P3", {2, 15});
  construct.add("P4", {23, 7});
  construct.add("P5", {35, 21});
  construct.add("P6", {38, 12});
  construct.add("P7", {3, 33});
  construct.add("Q", {15, 29});
  construct.call("V1", "P2 Q P5");
  construct.call("V2", "P7 P3 Q");
  construct.call("V3", "P5 P4 Q");
  construct.call("V4", "Q P2 P7");
  construct.call("V5", "P3 Q P4");
  construct.call("V6", "P3 P4 P1");
  construct.call("V7", "P5 P6 P4");
  construct.call("V8", "P1 P4 P6");
  return construct;
}

void call_new_vertices_of_figure_15(Construct& construct) {
  construct.call("W1", "P3 P4 P2");
  construct.call("W2", "P7 P3 P2");
  construct.call("W3", "P2 P5 P4");
}

// Step 1 of deletion: the vertices that Q forms, and the points that form them with it.
TEST(ThesisFigures, figure_12_is_the_star_of_the_deleted_point) {
  const Construct construct = figure_11();
  Star<2> star;
  construct.tessellation().find_star(construct.point("Q"), star);
  Names listofv, listofp;
  for (const VertexId v : star.vertices()) listofv.insert(construct.name_of(v));
  for (const PointId p : star.points()) listofp.insert(construct.name_of(p));
  EXPECT_EQ(listofv, names_in("V1 V2 V3 V4 V5"));
  EXPECT_EQ(listofp, names_in("P2 P5 P7 P3 P4"));
  EXPECT_EQ(star.vertices().size(), 5u);
  EXPECT_EQ(star.points().size(), 5u);
}

// Step 2: V6 alone of V5's neighbours is not in the list, so W1 has P3 and P4, and V6 beyond them.
TEST(ThesisFigures, figure_13_is_a_new_vertex_where_a_neighbour_stays) {
  Construct construct = figure_11();
  EXPECT_EQ(construct.neighbours("V5"), "V3 V6 V2");
  const Topology<2>& topology = construct.tessellation().topology();
  const VertexId v5 = construct.vertex("V5");
  const VertexId v6 = construct.vertex("V6");
  ASSERT_NE(v5, no_vertex);
  EXPECT_EQ(construct.common_points(v5, topology.side_towards(v5, v6)), names_in("P3 P4"));
  construct.remove("Q");
  call_new_vertices_of_figure_15(construct);
  EXPECT_EQ(words_of(construct.neighbours("W1")).at(2), "V6");
  EXPECT_EQ(construct.vertex("V6"), v6);
}

/// Whether the circle of three points holds a fourth, in whole numbers.
bool holds(const Construct& construct, const std::string& circle, const std::string& point) {
  const std::vector<std::string> names = words_of(circle);
  const whole::Position a = construct.place(names.at(0));
  const whole::Position b = construct.place(names.at(1));
  const whole::Position c = construct.place(names.at(2));
  const int inside = whole::sign_of(whole::in_circle(a, b, c, construct.place(point)));
  return inside * whole::sign_of(whole::doubled_area(a, b, c)) > 0;
}

// Step 3: the circle of P3, P4 and P5 holds P2, that of P3, P4 and P2 none of LISTOFP. The rows of
// the deleted vertices are as in table 6; V2's third neighbour is 0, for which the figure has Q.
TEST(ThesisFigures, figure_14_is_the_last_point_by_the_circles) {
  Construct construct = figure_11();
  EXPECT_EQ(construct.neighbours("V2"), "V5 V4 0");
  EXPECT_EQ(construct.neighbours("V3"), "V5 V1 V7");
  EXPECT_EQ(construct.neighbours("V5"), "V3 V6 V2");
  EXPECT_TRUE(holds(construct, "P3 P4 P5", "P2"));
  EXPECT_TRUE(holds(construct, "P3 P4 P7", "P2"));
  EXPECT_FALSE(holds(construct, "P3 P4 P2", "P5"));
  EXPECT_FALSE(holds(construct, "P3 P4 P2", "P7"));
  construct.remove("Q");
  construct.call("refused", "P3 P4 P5");
  call_new_vertices_of_figure_15(construct);
  EXPECT_FALSE(construct.has("refused"));
  EXPECT_TRUE(construct.has("W1"));
}

// Step 4, and the neighbours outside that each new vertex has at once.
TEST(ThesisFigures, figure_15_is_what_comes_in_the_place_of_the_deleted) {
  Construct construct = figure_11();
  const Names stay{"V6", "V7", "V8"};
  std::map<std::string, VertexId> rows;
  for (const std::string& name : stay) rows[name] = construct.vertex(name);
  construct.remove("Q");
  call_new_vertices_of_figure_15(construct);
  Names there;
  const Topology<2>& topology = construct.tessellation().topology();
  topology.for_each_vertex([&](VertexId v) {
    if (!topology.is_infinite(v)) there.insert(construct.name_of(v));
  });
  EXPECT_EQ(there, names_in("V6 V7 V8 W1 W2 W3"));
  for (const std::string& name : stay) EXPECT_EQ(construct.vertex(name), rows[name]) << name;
  EXPECT_EQ(construct.neighbours("W1"), "W3 W2 V6");
  EXPECT_EQ(construct.neighbours("W2"), "W1 0 0");
  EXPECT_EQ(construct.neighbours("W3"), "V7 W1 0");
}

// Step 5: V6 and V7, which stay, have W1 and W3 in the place of V5 and V3. V7's first neighbour is
// V8, for which the table has V9.
TEST(ThesisFigures, table_7_is_what_the_vertices_that_stay_have_for_neighbours) {
  Construct construct = figure_11();
  EXPECT_EQ(construct.neighbours("V6"), "V8 0 V5");
  EXPECT_EQ(construct.neighbours("V7"), "V8 V3 0");
  construct.remove("Q");
  call_new_vertices_of_figure_15(construct);
  EXPECT_EQ(construct.neighbours("V6"), "V8 0 W1");
  EXPECT_EQ(construct.neighbours("V7"), "V8 W3 0");
}

}  // namespace
}  // namespace thiessen
