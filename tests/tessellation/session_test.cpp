#include "tessellation/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "geometry/seeded.h"
#include "tessellation/topology_table.h"

namespace thiessen {
namespace {

/// The sentence with which the call fails.
template <typename Call>
std::string complaint_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.messages().front().sentence();
  }
  return "no complaint";
}

template <int Dimension>
std::string table_of(const TessellationSession<Dimension>& session) {
  std::string text;
  write_topology_table<Dimension>(
      session.tessellation(), [&](PointId p) { return session.number_of(p); },
      [&](std::string_view line) { text += line; });
  return text;
}

TEST(Session, uses_no_number_twice_but_one_that_undo_took_back) {
  TessellationSession<2> session;
  EXPECT_EQ(session.add({0, 0}), 1u);
  EXPECT_EQ(session.add({1, 0}), 2u);
  EXPECT_EQ(session.remove({1, 0}), 2u);
  EXPECT_EQ(session.add({1, 0}), 3u);
  session.undo();
  EXPECT_EQ(session.add({5, 5}), 3u);
  session.undo();
  session.undo();  // point 2 is there again
  EXPECT_EQ(session.number_of(session.point_at({1, 0})), 2u);
  EXPECT_EQ(session.add({7, 7}), 3u);
}

TEST(Session, redo_gives_the_same_numbers_again) {
  TessellationSession<2> session;
  session.add({0, 0});
  session.add({1, 0});
  session.remove({0, 0});
  session.add({4, 4});
  for (int i = 0; i < 4; ++i) session.undo();
  EXPECT_TRUE(session.tessellation().empty());
  for (int i = 0; i < 4; ++i) session.redo();
  EXPECT_EQ(table_of(session), "point 2 1 0\npoint 3 4 4\n");
}

TEST(Session, says_what_cannot_be_done_and_changes_nothing) {
  TessellationSession<2> session;
  EXPECT_EQ(complaint_of([&] { session.undo(); }), "there is nothing to undo");
  EXPECT_EQ(complaint_of([&] { session.redo(); }), "there is nothing to redo");
  EXPECT_EQ(complaint_of([&] { session.remove({1, 2}); }), "there is no point at 1 2");
  EXPECT_EQ(complaint_of([&] { session.nearest({1, 2}); }), "there are no points");
  session.add({1, 2.5});
  session.add({3, 4});
  session.undo();
  EXPECT_EQ(complaint_of([&] { session.add({1, 2.5}); }), "point 1 is at 1 2.5 already");
  EXPECT_EQ(complaint_of([&] { session.point_at({3, 4}); }), "there is no point at 3 4");
  EXPECT_EQ(complaint_of([&] { session.remove({3, 4}); }), "there is no point at 3 4");
  session.redo();  // what failed has not taken it away
  EXPECT_EQ(table_of(session), "point 1 1 2.5\npoint 2 3 4\n");
  session.undo();
  session.add({9, 9});
  EXPECT_EQ(complaint_of([&] { session.redo(); }), "there is nothing to redo");
}

TEST(Session, adds_many_points_in_one_step_and_equal_ones_once) {
  TessellationSession<2> session;
  session.add({1, 1});
  const std::vector<Point> points{{0, 0}, {1, 1}, {2, 0}, {0, 0}, {0, 0}, {5, 3}};
  const auto added = session.add_all(points);
  EXPECT_EQ(added.first, 2u);
  EXPECT_EQ(added.points, 3u);
  EXPECT_EQ(added.repeated, 2u);
  EXPECT_EQ(added.there_already, 1u);
  const std::string table = table_of(session);
  EXPECT_TRUE(table.starts_with("point 1 1 1\npoint 2 0 0\npoint 3 2 0\npoint 4 5 3\nvertex"))
      << table;
  session.undo();
  EXPECT_EQ(table_of(session), "point 1 1 1\n");
  EXPECT_EQ(session.add({8, 8}), 2u);
  session.undo();
  session.add_all(points);
  EXPECT_EQ(table_of(session), table);
}

TEST(Session, takes_the_lowest_number_of_equally_near_points) {
  TessellationSession<2> session;
  for (const Point p : {Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) session.add(p);
  EXPECT_EQ(session.number_of(session.nearest({0, 0})), 1u);
  session.remove({1, 0});
  EXPECT_EQ(session.number_of(session.nearest({0, 0})), 2u);
  EXPECT_EQ(session.number_of(session.nearest({-0.5, -0.25})), 3u);
}

/// A session as a list of what it was after every step.
struct Model {
  struct State {
    std::map<std::uint64_t, SpacePoint> points;
    std::uint64_t next = 1;
  };
  std::vector<State> states = {{}};
  std::vector<std::string> tables = {""};
  std::size_t at = 0;

  State& begin() {
    states.resize(at + 1);
    tables.resize(at + 1);
    states.push_back(states.back());
    ++at;
    return states.back();
  }
};

template <int Dimension>
PositionIn<Dimension> position(const SpacePoint& p) {
  if constexpr (Dimension == 2) {
    return {p.x, p.y};
  } else {
    return p;
  }
}

template <int Dimension>
void expect_to_follow_the_model(Seeded& seeded, int steps) {
  TessellationSession<Dimension> session;
  Model model;
  const auto coordinate = [&] { return static_cast<double>(seeded.below(4)); };
  for (int step = 0; step < steps; ++step) {
    const SpacePoint p{coordinate(), coordinate(), Dimension == 3 ? coordinate() : 0};
    const auto& points = model.states[model.at].points;
    const auto there = std::find_if(points.begin(), points.end(),
                                    [&](const auto& entry) { return entry.second == p; });
    const std::uint64_t choice = seeded.below(10);
    if (choice < 2) {
      if (model.at == 0) continue;
      session.undo();
      --model.at;
      ASSERT_EQ(table_of(session), model.tables[model.at]);
    } else if (choice < 4) {
      if (model.at + 1 == model.states.size()) continue;
      session.redo();
      ++model.at;
      ASSERT_EQ(table_of(session), model.tables[model.at]);
    } else if (there != points.end()) {
      const std::uint64_t number = there->first;
      ASSERT_EQ(session.remove(position<Dimension>(p)), number);
      model.begin().points.erase(number);
      model.tables.push_back(table_of(session));
    } else {
      auto& state = model.begin();
      state.points[state.next] = p;
      ASSERT_EQ(session.add(position<Dimension>(p)), state.next++);
      model.tables.push_back(table_of(session));
    }
    ASSERT_EQ(session.tessellation().count(), model.states[model.at].points.size());
    for (const auto& [number, q] : model.states[model.at].points)
      ASSERT_EQ(session.number_of(session.point_at(position<Dimension>(q))), number);
  }
}

TEST(Session, follows_a_list_of_its_states) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    expect_to_follow_the_model<2>(seeded, 400);
    expect_to_follow_the_model<3>(seeded, 400);
  }
}

}  // namespace
}  // namespace thiessen
