#include "tessellation/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tessellation/audited.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class HistoryOf : public InDimension<Constant> {};
template <typename Constant>
class TrialOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(HistoryOf, PlaneAndSpace);
TYPED_TEST_SUITE(TrialOf, PlaneAndSpace);

template <int Dimension>
Bits bits_of(const Tessellation<Dimension>& tessellation) {
  return thiessen::bits_of(tessellation.structure());
}

template <int Dimension>
PointId any_point(Seeded& seeded, const Tessellation<Dimension>& tessellation) {
  for (;;) {
    const PointId p{
        static_cast<std::uint32_t>(seeded.below(tessellation.topology().point_limit()))};
    if (tessellation.is_there(p)) return p;
  }
}

/// Adds one of the points or deletes one.
template <int Dimension, typename Changed>
void change_somehow(Seeded& seeded, Changed& changed, const Tessellation<Dimension>& tessellation,
                    const std::vector<PositionIn<Dimension>>& points) {
  if (!tessellation.empty() && seeded.below(2) == 0) {
    changed.remove(any_point(seeded, tessellation));
  } else {
    changed.add(points[seeded.below(points.size())]);
  }
}

TYPED_TEST(HistoryOf, nothing_has_nothing_to_undo) {
  History<TestFixture::dimension> history;
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undoable(), 0u);
  EXPECT_EQ(history.redoable(), 0u);
  EXPECT_TRUE(history.tessellation().empty());
}

// T029, T030: through every span, down to nothing and up again.
TYPED_TEST(HistoryOf, operations_is_undone_and_redone_bit_for_bit) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (const FamilyIn<d>& family : families::all_in<d>(seeded, 15)) {
      SCOPED_TRACE(family.name);
      History<d> history;
      const Tessellation<d>& tessellation = history.tessellation();
      std::vector<Bits> bits{bits_of(tessellation)};
      for (int i = 0; i < 60; ++i) {
        change_somehow<d>(seeded, history, tessellation, family.points);
        bits.push_back(bits_of(tessellation));
      }
      for (int way = 0; way < 2; ++way) {
        for (std::size_t i = bits.size() - 1; i > 0; --i) {
          ASSERT_EQ(history.undoable(), i);
          ASSERT_TRUE(history.undo());
          ASSERT_EQ(bits_of(tessellation), bits[i - 1]) << i;
        }
        ASSERT_FALSE(history.undo());
        ASSERT_EQ(bits_of(tessellation), bits.front());
        for (std::size_t i = 1; i < bits.size(); ++i) {
          ASSERT_TRUE(history.redo());
          ASSERT_EQ(bits_of(tessellation), bits[i]) << i;
          ASSERT_EQ(history.redoable(), bits.size() - 1 - i);
        }
        ASSERT_FALSE(history.redo());
      }
    }
  }
}

TYPED_TEST(HistoryOf, many_points_at_once_is_one_operation) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 80)) {
    SCOPED_TRACE(family.name);
    History<d> history;
    const Tessellation<d>& tessellation = history.tessellation();
    const std::span<const PositionIn<d>> points(family.points);
    history.add(points.front());
    std::vector<Bits> bits{bits_of(tessellation)};
    // One that more than doubles the points, and some that do not.
    for (const auto& batch : {points.subspan(0, points.size() / 2),
                              points.subspan(points.size() / 2, points.size() / 5),
                              points.subspan(points.size() - 1), points.subspan(0, 0)}) {
      const std::vector<PointId> numbers = history.add_all(batch);
      ASSERT_EQ(numbers.size(), batch.size());
      for (std::size_t i = 0; i < batch.size(); ++i)
        ASSERT_EQ(tessellation.position(numbers[i]), batch[i]);
      bits.push_back(bits_of(tessellation));
    }
    ASSERT_EQ(history.undoable(), bits.size());
    for (std::size_t i = bits.size() - 1; i > 0; --i) {
      ASSERT_TRUE(history.undo());
      ASSERT_EQ(bits_of(tessellation), bits[i - 1]);
    }
    ASSERT_TRUE(history.undo());
    ASSERT_TRUE(tessellation.empty());
    for (const Bits& expected : bits) {
      ASSERT_TRUE(history.redo());
      ASSERT_EQ(bits_of(tessellation), expected);
    }
    expect_sound(tessellation);
  }
}

TYPED_TEST(HistoryOf, operations_forgets_the_undone_at_the_next_one) {
  History<TestFixture::dimension> history;
  history.add({0, 0});
  history.add({1, 0});
  history.add({0, 1});
  EXPECT_TRUE(history.undo());
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.redoable(), 2u);
  history.add({5, 5});
  EXPECT_EQ(history.redoable(), 0u);
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undoable(), 2u);
  EXPECT_EQ(history.tessellation().count(), 2u);
  EXPECT_TRUE(history.tessellation().find({5, 5}));
  EXPECT_FALSE(history.tessellation().find({1, 0}));
}

TYPED_TEST(HistoryOf, operations_gives_numbers_back) {
  History<TestFixture::dimension> history;
  const PointId a = history.add({0, 0});
  const PointId b = history.add({1, 0});
  history.undo();
  EXPECT_EQ(history.add({7, 7}), b);
  history.remove(a);
  EXPECT_EQ(history.add({8, 8}), a);
  history.undo();
  history.undo();
  EXPECT_TRUE(history.tessellation().is_there(a));
  EXPECT_EQ(history.tessellation().find({0, 0}), a);
}

// A point that is there already changes nothing, but is an operation.
TYPED_TEST(HistoryOf, operations_counts_a_duplicate) {
  History<TestFixture::dimension> history;
  const PointId a = history.add({0, 0});
  const Bits before = bits_of(history.tessellation());
  EXPECT_EQ(history.add({-0.0, 0}), a);
  EXPECT_EQ(bits_of(history.tessellation()), before);
  EXPECT_EQ(history.undoable(), 2u);
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(bits_of(history.tessellation()), before);
}

TYPED_TEST(HistoryOf, operations_undone_answers_from_any_hint) {
  constexpr int d = TestFixture::dimension;
  History<d> history;
  history.add({0, 0});
  history.add({4, 0});
  for (int i = 0; i < 40; ++i) history.add({1.0 * (i % 7), 1.0 * (i % 5)});
  const PointId gone = history.add({100, 100});
  while (history.undoable() > 2) {
    history.undo();
    const Tessellation<d>& tessellation = history.tessellation();
    for (const std::optional<PointId> hint : {std::optional<PointId>{}, {gone}, {no_point}}) {
      ASSERT_EQ(tessellation.nearest({-1, 0}, hint), tessellation.find({0, 0}, hint));
      ASSERT_TRUE(tessellation.find({4, 0}, hint));
    }
  }
}

// The tessellation without history, changed alike, has the same simplices at every step.
TYPED_TEST(HistoryOf, operations_changes_nothing_else) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 20)) {
    SCOPED_TRACE(family.name);
    History<d> history;
    Tessellation<d> bare;
    for (const auto& p : family.points) {
      history.add(p);
      history.undo();
      history.redo();
      bare.add(p);
      ASSERT_EQ(plain_simplices(history.tessellation()), plain_simplices(bare));
    }
  }
}

TYPED_TEST(TrialOf, changes_leaves_nothing_behind) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 20)) {
    SCOPED_TRACE(family.name);
    Tessellation<d> tessellation;
    typename Trial<d>::Changes changes;
    for (int i = 0; i < 60; ++i) {
      change_somehow<d>(seeded, tessellation, tessellation, family.points);
      const Bits before = bits_of(tessellation);
      {
        const Trial<d> trial(tessellation, changes);
        const std::uint64_t steps = seeded.below(8);
        for (std::uint64_t k = 0; k < steps; ++k)
          change_somehow<d>(seeded, tessellation, tessellation, family.points);
      }
      ASSERT_EQ(bits_of(tessellation), before);
      ASSERT_TRUE(audit(tessellation).empty());
    }
  }
}

TYPED_TEST(TrialOf, trials_may_be_nested) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 20)) {
    SCOPED_TRACE(family.name);
    Tessellation<d> tessellation = tessellation_of(family.points);
    typename Trial<d>::Changes changes;
    typename Trial<d>::Changes others;
    const Bits before = bits_of(tessellation);
    {
      const Trial<d> outer(tessellation, changes);
      for (int i = 0; i < 5; ++i) {
        change_somehow<d>(seeded, tessellation, tessellation, family.points);
        const Bits half_way = bits_of(tessellation);
        {
          const Trial<d> inner(tessellation, i % 2 == 0 ? changes : others);
          for (int k = 0; k < 5; ++k)
            change_somehow<d>(seeded, tessellation, tessellation, family.points);
        }
        ASSERT_EQ(bits_of(tessellation), half_way);
      }
    }
    ASSERT_EQ(bits_of(tessellation), before);
    ASSERT_EQ(changes.extent().topology.rows, 0u);
    ASSERT_EQ(changes.extent().topology.points, 0u);
    ASSERT_EQ(changes.extent().positions, 0u);
  }
}

TYPED_TEST(TrialOf, everything_deleted_is_taken_back) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 50)) {
    SCOPED_TRACE(family.name);
    Tessellation<d> tessellation = tessellation_of(family.points);
    typename Trial<d>::Changes changes;
    const Bits before = bits_of(tessellation);
    {
      const Trial<d> trial(tessellation, changes);
      while (!tessellation.empty()) tessellation.remove(any_point(seeded, tessellation));
      tessellation.add_all(family.points);
    }
    ASSERT_EQ(bits_of(tessellation), before);
  }
}

// What a million trials leave behind: nothing, and lists no longer than after the first thousand.
TYPED_TEST(TrialOf, a_million_times_needs_no_more_memory) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  std::vector<PositionIn<d>> points;
  if constexpr (d == 2) {
    points = families::uniform(seeded, 100);
  } else {
    points = families::uniform_in_space(seeded, 100);
  }
  Tessellation<d> tessellation;
  const std::vector<PointId> numbers =
      tessellation.add_all(std::span<const PositionIn<d>>(points).subspan(0, 50));
  typename Trial<d>::Changes changes;
  const Bits before = bits_of(tessellation);
  const auto try_often = [&](int times) {
    for (int i = 0; i < times; ++i) {
      const Trial<d> trial(tessellation, changes);
      const auto k = static_cast<std::size_t>(i % 50);
      if (i % 2 == 0) {
        tessellation.add(points[50 + k], numbers[k]);
      } else {
        tessellation.remove(numbers[k]);
      }
    }
  };
  const int million = often(d == 2 ? 1000000 : 100000);
  try_often(1000);
  const std::size_t rows = changes.topology.rows.capacity();
  const std::size_t moves = changes.topology.points.capacity();
  const std::size_t positions = changes.positions.capacity();
  try_often(million);
  EXPECT_EQ(changes.topology.rows.capacity(), rows);
  EXPECT_EQ(changes.topology.points.capacity(), moves);
  EXPECT_EQ(changes.positions.capacity(), positions);
  EXPECT_TRUE(changes.topology.rows.empty());
  EXPECT_EQ(bits_of(tessellation), before);
}

struct Refusal {};

// Whatever the witness sees, nothing is left of an operation that he does not let pass: of one
// point, of a few (recorded as changes) and of many (a copy is kept), of a deletion.
TYPED_TEST(HistoryOf, operations_that_the_witness_refuses_leaves_nothing_behind) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    History<d> history;
    const Tessellation<d>& tessellation = history.tessellation();
    history.add_all(family.points);
    const PointId first = any_point(seeded, tessellation);
    const auto place = tessellation.position(first);
    history.remove(first);
    const Bits redone = bits_of(tessellation);
    history.undo();
    const Bits before = bits_of(tessellation);
    std::size_t seen = 0;
    const auto refuse = [&](std::span<const PointId> points) {
      seen += points.size();
      throw Refusal();
    };
    const PositionIn<d> fresh{0.123456, 0.654321};
    EXPECT_THROW(history.add(fresh, {}, refuse), Refusal);
    EXPECT_EQ(bits_of(tessellation), before);
    EXPECT_THROW(history.add_all(std::vector{fresh}, refuse), Refusal);
    EXPECT_EQ(bits_of(tessellation), before);
    EXPECT_THROW(history.add_all(std::vector(1000, fresh), refuse), Refusal);
    EXPECT_EQ(bits_of(tessellation), before);
    EXPECT_EQ(seen, 1002u);
    EXPECT_THROW(history.remove(*tessellation.find(place), refuse), Refusal);
    EXPECT_EQ(bits_of(tessellation), before);
    ASSERT_TRUE(history.redo()) << "what was undone is not forgotten";
    EXPECT_EQ(bits_of(tessellation), redone);
    history.undo();
    history.add(fresh);
    EXPECT_EQ(history.redoable(), 0u);
    history.undo();
    EXPECT_EQ(bits_of(tessellation), before);
    history.undo();
    EXPECT_TRUE(tessellation.empty());
  }
}

}  // namespace
}  // namespace thiessen
