// What is copied while a trial lasts is no part of it. (Trials themselves: history_test.cpp.)
#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tessellation/history.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class TrialCopyOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(TrialCopyOf, PlaneAndSpace);

/// Deletes every third point and adds those that are not there.
template <int Dimension>
void change_much(Tessellation<Dimension>& tessellation,
                 const std::vector<PositionIn<Dimension>>& points) {
  std::vector<PointId> numbers;
  tessellation.for_each_point([&](PointId p) { numbers.push_back(p); });
  for (std::size_t i = 0; i < numbers.size(); i += 3) tessellation.remove(numbers[i]);
  for (std::size_t i = 0; i < points.size(); i += 2) tessellation.add(points[i]);
}

/// Sound, and that of its points built anew.
template <int Dimension>
void expect_whole(const Tessellation<Dimension>& tessellation) {
  expect_sound(tessellation);
  EXPECT_TRUE(plain_simplices(tessellation) ==
              plain_simplices(tessellation_of(positions_of(tessellation))));
}

template <int Dimension>
std::size_t count_of(const typename Trial<Dimension>::Changes& changes) {
  return changes.topology.rows.size() + changes.topology.points.size() + changes.positions.size();
}

// Each way of copying, in a trial and in one within another.
TYPED_TEST(TrialCopyOf, a_tessellation_made_inside_is_its_own) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    const std::span<const PositionIn<d>> half(family.points.data(), family.points.size() / 2);
    Tessellation<d> tessellation;
    tessellation.add_all(half);
    Tessellation<d> assigned;
    assigned.add(family.points.back());
    Tessellation<d> copy;
    const Bits before = bits_of(tessellation.structure());
    typename Trial<d>::Changes changes;
    Bits of_copy;
    {
      const Trial<d> outer(tessellation, changes);
      change_much<d>(tessellation, family.points);
      const Trial<d> inner(tessellation, changes);
      tessellation.add_all(family.points);
      const Bits tried = bits_of(tessellation.structure());
      const std::size_t recorded = count_of<d>(changes);
      Tessellation<d> made = tessellation;
      assigned = tessellation;
      EXPECT_EQ(bits_of(made.structure()), tried);
      EXPECT_EQ(bits_of(assigned.structure()), tried);
      EXPECT_FALSE(made.is_tried());
      EXPECT_FALSE(assigned.is_tried());
      change_much<d>(made, family.points);
      change_much<d>(assigned, family.points);
      EXPECT_EQ(count_of<d>(changes), recorded);
      EXPECT_EQ(bits_of(tessellation.structure()), tried);
      copy = std::move(made);
      of_copy = bits_of(copy.structure());
    }
    EXPECT_EQ(bits_of(tessellation.structure()), before);
    EXPECT_EQ(bits_of(copy.structure()), of_copy);
    EXPECT_EQ(bits_of(assigned.structure()), of_copy);
    for (Tessellation<d>* own : {&tessellation, &copy, &assigned}) {
      expect_whole(*own);
      change_much<d>(*own, family.points);
      expect_whole(*own);
    }
    EXPECT_EQ(count_of<d>(changes), 0u);
  }
}

// A copy has trials of its own, which the other's end does not touch.
TYPED_TEST(TrialCopyOf, a_trial_outlasts_the_one_that_its_tessellation_was_copied_in) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    Tessellation<d> tessellation = tessellation_of(family.points);
    Tessellation<d> copy;
    typename Trial<d>::Changes changes;
    {
      const Trial<d> trial(tessellation, changes);
      change_much<d>(tessellation, family.points);
      copy = tessellation;
    }
    const Bits before = bits_of(copy.structure());
    typename Trial<d>::Changes others;
    {
      const Trial<d> trial(copy, others);
      change_much<d>(copy, family.points);
      change_much<d>(tessellation, family.points);
      EXPECT_GT(count_of<d>(others), 0u);
    }
    EXPECT_EQ(bits_of(copy.structure()), before);
    EXPECT_EQ(count_of<d>(changes), 0u);
    expect_whole(copy);
    expect_whole(tessellation);
  }
}

}  // namespace
}  // namespace thiessen
