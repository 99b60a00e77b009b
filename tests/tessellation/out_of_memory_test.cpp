// Compiled alone: it replaces the program's operator new with names of its own.
// Every allocation fails once, the n-th for every n: what fails half-way is taken back.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <span>
#include <vector>

#include "base/failing_allocations.h"
#include "tessellation/history.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class OutOfMemoryIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(OutOfMemoryIn, PlaneAndSpace);

/// Fails the operation at every allocation until it gets through; each time all is as it was.
template <int Dimension, typename Operation>
void fail_often(History<Dimension>& history, long& failed, Operation&& operation) {
  const Bits before = bits_of(history.tessellation().structure());
  const std::size_t undoable = history.undoable();
  for (long n = 1;; ++n) {
    left = n;
    try {
      operation();
      left = -1;
      return;
    } catch (const std::bad_alloc&) {
      ++failed;
      ASSERT_EQ(bits_of(history.tessellation().structure()), before);
      ASSERT_EQ(history.undoable(), undoable);
    }
  }
}

template <int Dimension>
std::vector<PositionIn<Dimension>> some_of(Seeded& seeded, const FamilyIn<Dimension>& family) {
  std::vector<PositionIn<Dimension>> points = distinct(family.points);
  std::shuffle(points.begin(), points.end(), seeded.generator());
  if (points.size() > 16) points.resize(16);
  return points;
}

TYPED_TEST(OutOfMemoryIn, a_change_changes_nothing) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 12)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = some_of<d>(seeded, family);
    long failed = 0;
    History<d> history;
    for (const auto& p : points) {
      fail_often<d>(history, failed, [&] { history.add(p); });
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
    EXPECT_EQ(positions_of(history.tessellation()), distinct(points));
    expect_sound(history.tessellation());
    for (const auto& p : points) {
      const PointId number = *history.tessellation().find(p);
      fail_often<d>(history, failed, [&] { history.remove(number); });
      ASSERT_FALSE(testing::Test::HasFatalFailure());
      expect_sound(history.tessellation());
    }
    EXPECT_TRUE(history.tessellation().empty());
    EXPECT_GT(failed, 10);
    while (history.undo()) expect_sound(history.tessellation());
    while (history.redo()) expect_sound(history.tessellation());
  }
}

TYPED_TEST(OutOfMemoryIn, adding_many_points_changes_nothing) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 12)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = some_of<d>(seeded, family);
    const std::span<const PositionIn<d>> all(points);
    long failed = 0;
    History<d> history;
    // Of which the first doubles the points, and the second does not.
    fail_often<d>(history, failed, [&] { history.add_all(all.subspan(0, all.size() - 2)); });
    ASSERT_FALSE(testing::Test::HasFatalFailure());
    fail_often<d>(history, failed, [&] { history.add_all(all.subspan(all.size() - 2)); });
    ASSERT_FALSE(testing::Test::HasFatalFailure());
    EXPECT_EQ(positions_of(history.tessellation()), distinct(points));
    expect_sound(history.tessellation());
    EXPECT_GT(failed, 10);
    while (history.undo()) expect_sound(history.tessellation());
    while (history.redo()) expect_sound(history.tessellation());
    EXPECT_EQ(positions_of(history.tessellation()), distinct(points));
  }
}

/// Tries a change on a copy, whose lists are full, so that every one that grows fails once: what
/// was done until then is taken back, which needs no memory.
template <int Dimension, typename Change>
void fail_in_trial(const Tessellation<Dimension>& tessellation, long& failed, Change&& change) {
  const Bits before = bits_of(tessellation.structure());
  bool fails = true;
  for (long n = 1; fails; ++n) {
    Tessellation<Dimension> tried = tessellation;
    typename Trial<Dimension>::Changes changes;
    fails = false;
    {
      const Trial<Dimension> trial(tried, changes);
      left = n;
      try {
        change(tried);
        left = -1;
      } catch (const std::bad_alloc&) {
        fails = true;
        ++failed;
#ifndef THIESSEN_AUDIT  // an audit, which each change ends with there, needs memory
        left = 1;
#endif
      }
    }
    left = -1;
    ASSERT_EQ(bits_of(tried.structure()), before);
    ASSERT_EQ(changes.extent().topology.rows, 0u);
    ASSERT_EQ(changes.extent().positions, 0u);
    change(tried);
    expect_sound(tried);
  }
}

TYPED_TEST(OutOfMemoryIn, a_trial_leaves_nothing_behind) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 12)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = some_of<d>(seeded, family);
    Tessellation<d> tessellation;
    long failed = 0;
    for (const auto& p : points) {
      fail_in_trial<d>(tessellation, failed, [&](Tessellation<d>& tried) { tried.add(p); });
      ASSERT_FALSE(testing::Test::HasFailure());
      tessellation.add(p);
    }
    fail_in_trial<d>(tessellation, failed, [&](Tessellation<d>& tried) {
      tried.remove(*tried.find(points.front()));
      tried.add_all(points);
    });
    ASSERT_FALSE(testing::Test::HasFailure());
    while (!tessellation.empty()) {
      const PointId number = *tessellation.nearest(points.front());
      fail_in_trial<d>(tessellation, failed, [&](Tessellation<d>& tried) { tried.remove(number); });
      ASSERT_FALSE(testing::Test::HasFailure());
      tessellation.remove(number);
    }
    EXPECT_GT(failed, 10);
  }
}

// What fails in an inner trial is taken back with it, and the outer one goes on.
TYPED_TEST(OutOfMemoryIn, an_inner_trial_leaves_the_outer_one_whole) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  long failed = 0;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 12)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = some_of<d>(seeded, family);
    Tessellation<d> tessellation;
    const std::span<const PositionIn<d>> some(points.data(), points.size() / 2);
    tessellation.add_all(some);
    const Bits before = bits_of(tessellation.structure());
    {
      typename Trial<d>::Changes changes;
      const Trial<d> outer(tessellation, changes);
      for (const auto& p : points) {
        const Bits half_way = bits_of(tessellation.structure());
        {
          const Trial<d> inner(tessellation, changes);
          left = 1 + static_cast<long>(seeded.below(4));
          try {
            tessellation.add(p);
          } catch (const std::bad_alloc&) {
            ++failed;
          }
          left = -1;
        }
        ASSERT_EQ(bits_of(tessellation.structure()), half_way);
        tessellation.add(p);
      }
      expect_sound(tessellation);
      EXPECT_EQ(positions_of(tessellation), distinct(points));
    }
    EXPECT_EQ(bits_of(tessellation.structure()), before);
    expect_sound(tessellation);
  }
  EXPECT_GT(failed, 10);
}

}  // namespace
}  // namespace thiessen
