// The hole that a deleted point leaves (section 2.3), filled facet by facet and from a tessellation
// of the points round it: in every dimension both ways, which Deletion chooses between by number.
#include "tessellation/hole.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/at_dimension.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

template <typename Constant>
class HoleIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(HoleIn, PlaneAndSpace);

enum class Way { facet_by_facet, from_tessellation };

/// A point's hole in a tessellation, filled.
template <int Dimension>
struct Filled {
  const Tessellation<Dimension>& before;
  const Tessellation<Dimension>& without;  ///< the other points', built from nothing
  const Star<Dimension>& star;
  const Tessellation<Dimension>& after;
  const std::vector<VertexId>& vertices;
};

template <int Dimension>
std::vector<VertexId> fill(Structure<Dimension>& structure, PointId p, const Star<Dimension>& star,
                           Hole<Dimension>& hole, Way way) {
  return at_dimension<Dimension>(structure.topology().dimension(), [&](auto d) {
    hole.template open<d>(structure.topology(), p, star);
    return way == Way::facet_by_facet ? hole.template fill<d>(structure)
                                      : hole.template fill_from_tessellation<d>(structure);
  });
}

/// Fills the hole of some points of every family in both ways, but for points that are the last off
/// what the others span, and calls `look`. All holes are one object.
template <int Dimension, typename Look>
void for_each_hole(Look&& look) {
  Seeded seeded;
  Hole<Dimension> hole;
  Star<Dimension> star;
  std::size_t count = 0;
  for (const FamilyIn<Dimension>& family : families::all_in<Dimension>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    std::vector<PositionIn<Dimension>> points = distinct(family.points);
    std::shuffle(points.begin(), points.end(), seeded.generator());
    const Tessellation<Dimension> before = tessellation_of(points);
    if (before.span() < Span::line) continue;
    for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 5); ++i) {
      const PositionIn<Dimension> position = points.front();
      std::rotate(points.begin(), points.begin() + 1, points.end());
      const std::vector<PositionIn<Dimension>> others(points.begin(), points.end() - 1);
      const Tessellation<Dimension> without = tessellation_of(others);
      if (without.span() != before.span()) continue;
      const PointId p = *before.find(position);
      before.find_star(p, star);
      for (const Way way : {Way::facet_by_facet, Way::from_tessellation}) {
        SCOPED_TRACE(way == Way::facet_by_facet ? "facet by facet" : "from a tessellation");
        Tessellation<Dimension> after = before;
        Structure<Dimension>& structure = after.structure_to_break();
        const std::vector<VertexId> vertices = fill(structure, p, star, hole, way);
        structure.topology().release_point(p);
        look(Filled<Dimension>{before, without, star, after, vertices});
        if (testing::Test::HasFatalFailure()) return;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100u);
}

TYPED_TEST(HoleIn, law_1_filled_in_either_way_it_is_the_tessellation_of_the_other_points) {
  constexpr int d = TestFixture::dimension;
  for_each_hole<d>([](const Filled<d>& filled) {
    ASSERT_EQ(plain_simplices(filled.after), plain_simplices(filled.without));
    expect_sound(filled.after);
  });
}

TYPED_TEST(HoleIn, law_2_the_new_vertices_take_the_rows_of_the_star_first_and_free_the_rest) {
  constexpr int d = TestFixture::dimension;
  for_each_hole<d>([](const Filled<d>& filled) {
    const std::vector<VertexId>& old_rows = filled.star.vertices();
    const std::size_t reused = std::min(old_rows.size(), filled.vertices.size());
    for (std::size_t i = 0; i < reused; ++i) ASSERT_EQ(filled.vertices[i], old_rows[i]);
    for (std::size_t i = reused; i < old_rows.size(); ++i)
      ASSERT_TRUE(filled.after.topology().is_free(old_rows[i]));
    ASSERT_EQ(plain_simplices(filled.after).size() + old_rows.size(),
              plain_simplices(filled.before).size() + filled.vertices.size());
  });
}

TYPED_TEST(HoleIn, law_3_points_of_the_star_alone_form_the_new_vertices) {
  constexpr int d = TestFixture::dimension;
  for_each_hole<d>([](const Filled<d>& filled) {
    const std::vector<PointId>& points = filled.star.points();
    for (const VertexId v : filled.vertices) {
      for (int i = 0; i <= filled.after.topology().dimension(); ++i) {
        const PointId q = filled.after.topology().forming(v)[static_cast<std::size_t>(i)];
        ASSERT_EQ(std::count(points.begin(), points.end(), q), 1);
      }
    }
  });
}

TYPED_TEST(HoleIn, law_4_what_is_not_of_the_star_keeps_its_points) {
  constexpr int d = TestFixture::dimension;
  for_each_hole<d>([](const Filled<d>& filled) {
    const std::vector<VertexId>& old_rows = filled.star.vertices();
    filled.before.topology().for_each_vertex([&](VertexId v) {
      if (std::count(old_rows.begin(), old_rows.end(), v) > 0) return;
      ASSERT_EQ(filled.after.topology().forming(v), filled.before.topology().forming(v));
    });
  });
}

// The centre of a rhombus leaves two triangles, and the shorter diagonal parts them.
TEST(HoleInPlane, of_the_centre_of_a_rhombus_is_parted_by_the_shorter_diagonal) {
  const Tessellation<2> rhombus = tessellation_of<2>({{-3, 0}, {3, 0}, {0, 1}, {0, -1}, {0, 0}});
  const PointId centre = *rhombus.find({0, 0});
  Star<2> star;
  rhombus.find_star(centre, star);
  ASSERT_EQ(star.vertices().size(), 4u);
  for (const Way way : {Way::facet_by_facet, Way::from_tessellation}) {
    Tessellation<2> changed = rhombus;
    Hole<2> hole;
    const auto vertices = fill<2>(changed.structure_to_break(), centre, star, hole, way);
    ASSERT_EQ(vertices.size(), 2u);
    for (const VertexId v : vertices) {
      for (const Point end : {Point{0, 1}, Point{0, -1}})
        EXPECT_LT(changed.topology().corner_of(v, *rhombus.find(end)), 3u);
    }
  }
}

}  // namespace
}  // namespace thiessen
