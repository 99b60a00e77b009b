// Every allocation fails once, the n-th for every n: what fails half-way is taken back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <span>
#include <vector>

#include "tessellation/history.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace {

// Allocations until one fails; none does while it is negative.
long left = -1;

void* allocate(std::size_t size) {
  if (left > 0 && --left == 0) {
    left = -1;
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}

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

}  // namespace
}  // namespace thiessen
