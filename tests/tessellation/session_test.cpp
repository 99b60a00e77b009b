#include "tessellation/session.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "tessellation/audit.h"
#include "tessellation/topology_table.h"
#include "tessellation/topology_table_reader.h"

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

  const State& now() const { return states[at]; }
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

/// Both, changed alike; `side` is how many different coordinates there are.
template <int Dimension>
class Followed {
 public:
  Followed(Seeded& seeded, std::uint64_t side) : seeded_(seeded), side_(side) {}

  void run(int steps) {
    for (int step = 0; step < steps; ++step) {
      operate();
      if (testing::Test::HasFatalFailure()) return;
      expect_same();
      if (testing::Test::HasFatalFailure()) return;
    }
  }

 private:
  void operate() {
    const std::uint64_t choice = seeded_.below(12);
    if (choice < 2) return undo();
    if (choice < 4) return redo();
    if (choice < 6) return load();
    const SpacePoint p = any_place();
    const auto number = number_at(model_.now(), p);
    if (number == 0) {
      add(p);
    } else {
      remove(p, number);
    }
  }

  SpacePoint any_place() {
    const auto coordinate = [&] { return static_cast<double>(seeded_.below(side_)); };
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, Dimension == 3 ? coordinate() : 0};
  }
  /// 0 where there is none.
  static std::uint64_t number_at(const Model::State& state, const SpacePoint& p) {
    for (const auto& [number, q] : state.points) {
      if (q == p) return number;
    }
    return 0;
  }

  void undo() {
    if (model_.at == 0) {
      EXPECT_EQ(complaint_of([&] { session_.undo(); }), "there is nothing to undo");
      return;
    }
    session_.undo();
    --model_.at;
    ASSERT_EQ(table_of(session_), model_.tables[model_.at]);
  }
  void redo() {
    if (model_.at + 1 == model_.states.size()) {
      EXPECT_EQ(complaint_of([&] { session_.redo(); }), "there is nothing to redo");
      return;
    }
    session_.redo();
    ++model_.at;
    ASSERT_EQ(table_of(session_), model_.tables[model_.at]);
  }
  void add(const SpacePoint& p) {
    auto& state = model_.begin();
    state.points[state.next] = p;
    ASSERT_EQ(session_.add(position<Dimension>(p)), state.next++);
    model_.tables.push_back(table_of(session_));
  }
  void remove(const SpacePoint& p, std::uint64_t number) {
    ASSERT_EQ(session_.remove(position<Dimension>(p)), number);
    model_.begin().points.erase(number);
    model_.tables.push_back(table_of(session_));
  }

  // Few or none beside what is there, about as many, or many more; some of them twice, some there
  // already.
  void load() {
    const std::size_t there = model_.now().points.size();
    const std::uint64_t kind = seeded_.below(3);
    const std::size_t most = kind == 0 ? 3 : kind == 1 ? there + 2 : 4 * there + 20;
    std::vector<SpacePoint> places(seeded_.below(most));
    std::vector<PositionIn<Dimension>> positions;
    for (SpacePoint& p : places) {
      p = any_place();
      positions.push_back(position<Dimension>(p));
    }
    auto& state = model_.begin();
    typename TessellationSession<Dimension>::Added expected{state.next, 0, 0, 0};
    for (const SpacePoint& p : places) {
      const std::uint64_t number = number_at(state, p);
      if (number == 0) {
        state.points[state.next++] = p;
        ++expected.points;
      } else {
        ++(number >= expected.first ? expected.repeated : expected.there_already);
      }
    }
    const auto added = session_.add_all(positions);
    EXPECT_EQ(added.first, expected.first);
    EXPECT_EQ(added.points, expected.points);
    EXPECT_EQ(added.repeated, expected.repeated);
    EXPECT_EQ(added.there_already, expected.there_already);
    model_.tables.push_back(table_of(session_));
  }

  void expect_same() {
    ASSERT_EQ(session_.tessellation().count(), model_.now().points.size());
    for (const auto& [number, q] : model_.now().points)
      ASSERT_EQ(session_.number_of(session_.point_at(position<Dimension>(q))), number);
    ASSERT_TRUE(audit(session_.tessellation()).empty());
  }

  Seeded& seeded_;
  std::uint64_t side_;
  TessellationSession<Dimension> session_;
  Model model_;
};

TEST(Session, follows_a_list_of_its_states) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    for (const std::uint64_t side : {2u, 4u, 12u}) {
      Followed<2>(seeded, side).run(300);
      ASSERT_FALSE(HasFailure());
      Followed<3>(seeded, side).run(side == 12 ? 60 : 200);
      ASSERT_FALSE(HasFailure());
    }
  }
}

// The watcher sees the change, numbers included; where he throws, it never was.
TEST(Session, takes_back_what_its_watcher_refuses) {
  TessellationSession<2> session;
  session.add({0, 0});
  session.add({4, 0});
  session.add({9, 9});
  session.undo();
  const std::string before = table_of(session);
  std::vector<std::string> seen;
  session.watch([&] {
    seen.push_back(table_of(session));
    throw Error(Message{"", 0, "refused", {}});
  });
  EXPECT_THROW(session.add({0, 3}), Error);
  EXPECT_THROW(session.remove({0, 0}), Error);
  EXPECT_THROW(session.add_all(std::vector<Point>{{0, 3}, {4, 0}, {5, 5}}), Error);
  EXPECT_THROW(session.undo(), Error);
  EXPECT_THROW(session.redo(), Error);
  EXPECT_EQ(table_of(session), before);
  ASSERT_EQ(seen.size(), 5u);
  EXPECT_TRUE(seen[0].starts_with("point 1 0 0\npoint 2 4 0\npoint 3 0 3\nvertex 1 ")) << seen[0];
  EXPECT_EQ(seen[1], "point 2 4 0\n");
  EXPECT_TRUE(seen[2].starts_with("point 1 0 0\npoint 2 4 0\npoint 3 0 3\npoint 4 5 5\n"));
  EXPECT_EQ(seen[3], "point 1 0 0\n");
  EXPECT_TRUE(seen[4].starts_with("point 1 0 0\npoint 2 4 0\npoint 3 9 9\n"));
  session.watch({});
  session.redo();
  EXPECT_EQ(session.number_of(session.point_at({9, 9})), 3u) << "what was undone is still there";
  session.undo();
  EXPECT_EQ(session.add({0, 3}), 3u);
  EXPECT_EQ(complaint_of([&] { session.redo(); }), "there is nothing to redo");
  for (int i = 0; i < 3; ++i) session.undo();
  EXPECT_TRUE(session.tessellation().empty());
  for (int i = 0; i < 3; ++i) session.redo();
  EXPECT_EQ(session.number_of(session.point_at({0, 3})), 3u);
}

/// What a printed table tells.
template <int Dimension>
NumberedTable<Dimension> read_table(const std::string& text) {
  TopologyTableReader<Dimension> reader("saved");
  std::size_t line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    reader.take(std::string_view(text).substr(at, end - at), ++line);
    at = end + 1;
  }
  return std::move(reader).table();
}

template <int Dimension>
PositionIn<Dimension> random_position(Seeded& seeded) {
  const auto coordinate = [&] { return static_cast<double>(seeded.whole(0, 9)); };
  if constexpr (Dimension == 2) {
    return {coordinate(), coordinate()};
  } else {
    return {coordinate(), coordinate(), coordinate()};
  }
}

// Whatever was added, deleted and taken back before: vertices get the numbers that they have.
template <int Dimension>
void expect_same_lines_again(Seeded& seeded) {
  TessellationSession<Dimension> session;
  for (int i = 0; i < 150; ++i) {
    const auto at = random_position<Dimension>(seeded);
    const bool is_there = session.tessellation().find(at).has_value();
    if (is_there) {
      session.remove(at);
    } else {
      session.add(at);
    }
    if (seeded.below(10) == 0) session.undo();
    if (i % 25 != 24 || session.tessellation().empty()) continue;
    const std::string before = table_of(session);
    TessellationSession<Dimension> again;
    const auto restored = again.restore(read_table<Dimension>(before));
    EXPECT_TRUE(restored.keeps_numbers);
    EXPECT_TRUE(restored.keeps_vertices);
    ASSERT_EQ(table_of(again), before);
    EXPECT_TRUE(audit(again.tessellation()).empty());
    again.undo();
    EXPECT_TRUE(again.tessellation().empty());
    again.redo();
    ASSERT_EQ(table_of(again), before);
  }
}

TEST(Session, law_a_table_that_is_restored_is_printed_again) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    expect_same_lines_again<2>(seeded);
    expect_same_lines_again<3>(seeded);
  }
}

TEST(Session, restores_numbers_where_none_was_given_before) {
  TessellationSession<2> session;
  session.add({0, 0});
  session.add({1, 0});
  const auto kept = session.restore(read_table<2>("point 1 0 0\npoint 4 5 5\npoint 9 6 5\n"));
  EXPECT_TRUE(kept.keeps_numbers);
  EXPECT_EQ(kept.there_already, 1U);
  EXPECT_EQ(kept.points, 2U);
  EXPECT_EQ(kept.first, 4U);
  EXPECT_EQ(kept.last, 9U);
  EXPECT_EQ(session.add({7, 7}), 10U) << "no number is used twice";
  const auto numbered_on = session.restore(read_table<2>("point 2 8 8\npoint 30 9 8\n"));
  EXPECT_FALSE(numbered_on.keeps_numbers);
  EXPECT_EQ(numbered_on.first, 11U);
  EXPECT_EQ(numbered_on.last, 12U);
  session.undo();
  EXPECT_EQ(session.add({8, 8}), 11U) << "undo takes the numbers back";
}

TEST(Session, refuses_a_table_whose_vertices_are_not_those_of_its_points) {
  const std::string points = "point 1 0 0\npoint 2 4 0\npoint 3 0 3\npoint 4 5 5\n";
  TessellationSession<2> session;
  session.restore(read_table<2>(points));
  std::string table = table_of(session);
  session.undo();
  const auto complaint = [&](const std::string& text) {
    const std::string said = complaint_of([&] { session.restore(read_table<2>(text)); });
    EXPECT_TRUE(session.tessellation().empty()) << text;
    return said;
  };
  const std::size_t last = table.rfind("vertex");
  EXPECT_EQ(complaint(table.substr(0, last)),
            "saved: a vertex is missing: 1 do not make a tessellation of the points; is the file "
            "whole?");
  EXPECT_EQ(complaint(points + "vertex 1 center 0 0 radius 1 forming 1 2 9 neighbors 0 0 0\n"),
            "saved:5: there is no point 9");
  EXPECT_EQ(complaint(points + "vertex 1 center 0 0 radius 1 forming 1 3 2 neighbors 0 0 0\n"),
            "saved:5: the points have no such vertex: 1");
  EXPECT_EQ(complaint("point 1 0 0\nvertex 1 center 0 0 radius 1 forming 1 1 1 neighbors 0 0 0\n"),
            "saved:2: the points do not span enough to have vertices");
  const std::size_t neighbours = table.rfind("neighbors");
  EXPECT_TRUE(complaint(table.substr(0, neighbours) + "neighbors 77 77 77\n")
                  .starts_with("saved:6: neighbor 1 of vertex "));
}

TEST(Session, numbers_vertices_anew_where_theirs_are_out_of_reach) {
  TessellationSession<2> session;
  const auto restored = session.restore(
      read_table<2>("point 1 0 0\npoint 2 4 0\npoint 3 0 3\n"
                    "vertex 4000000000 center 2 1.5 radius 2.5 forming 1 2 3 neighbors 0 0 0\n"));
  EXPECT_FALSE(restored.keeps_vertices);
  EXPECT_EQ(restored.points, 3U);
  EXPECT_LT(session.tessellation().topology().size(), 10U);
}

}  // namespace
}  // namespace thiessen
