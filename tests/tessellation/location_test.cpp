// The walk to the simplex that holds a point, from wherever it starts.
#include "tessellation/location.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tessellation/at_dimension.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class LocationIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(LocationIn, PlaneAndSpace);

/// The simplex holds q, edges included; or it has the infinite point, and q lies beyond its facet.
template <int d, int Dimension>
bool holds(const Structure<Dimension>& structure, VertexId v, const PositionIn<Dimension>& q) {
  const auto simplex = structure.template simplex<d>(v);
  const std::size_t infinite = Structure<Dimension>::template infinite_corner<d>(simplex);
  if (infinite <= d) return structure.template orientation_with<d>(simplex, infinite, q) > 0;
  for (std::size_t i = 0; i <= d; ++i) {
    if (structure.template orientation_with<d>(simplex, i, q) < 0) return false;
  }
  return true;
}

/// Points of a family, of the middle between two, and of as far beyond one as another is away.
template <int Dimension>
std::vector<PositionIn<Dimension>> sought_of(Seeded& seeded,
                                             const std::vector<PositionIn<Dimension>>& points) {
  std::vector<PositionIn<Dimension>> sought;
  const auto any = [&] { return coordinates(points[seeded.below(points.size())]); };
  for (int i = 0; i < 20; ++i) {
    const auto a = any();
    const auto b = any();
    CoordinatesIn<Dimension> middle, beyond;
    for (std::size_t k = 0; k < a.size(); ++k) {
      middle[k] = a[k] / 2 + b[k] / 2;
      beyond[k] = 2 * b[k] - a[k];
    }
    for (const auto& c : {a, middle, beyond}) sought.push_back(position_of<Dimension>(c));
  }
  return sought;
}

TYPED_TEST(LocationIn, law_1_from_every_vertex_it_ends_where_the_point_is) {
  constexpr int space = TestFixture::dimension;
  Seeded seeded;
  std::size_t outside = 0;
  std::size_t inside = 0;
  for (const FamilyIn<space>& family : families::all_in<space>(seeded, 30)) {
    SCOPED_TRACE(family.name);
    const Tessellation<space> tessellation = tessellation_of(family.points);
    const Structure<space>& structure = tessellation.structure();
    if (tessellation.span() < Span::line) continue;
    for (const auto& q : sought_of<space>(seeded, family.points)) {
      if (structure.is_off(q)) continue;
      at_dimension<space>(structure.topology().dimension(), [&](auto spanned) {
        constexpr int d = decltype(spanned)::value;
        structure.topology().for_each_vertex([&](VertexId hint) {
          const VertexId v = locate<d>(structure, q, hint);
          ASSERT_TRUE((holds<d, space>(structure, v, q)));
          ++(structure.topology().is_infinite(v) ? outside : inside);
        });
      });
    }
  }
  EXPECT_GT(inside, 1000u);
  EXPECT_GT(outside, 1000u);
}

// On a line of 0, 1, 2 and 3: between two, at one, and before and after all.
TYPED_TEST(LocationIn, on_a_line_it_is_the_piece_between_two_points_or_what_lies_beyond) {
  constexpr int d = TestFixture::dimension;
  const Tessellation<d> line =
      tessellation_of(std::vector<PositionIn<d>>{{0, 0}, {1, 1}, {2, 2}, {3, 3}});
  const Structure<d>& structure = line.structure();
  const auto ends = [&](double at) {
    const VertexId hint = structure.topology().vertex_of(infinite_point);
    const auto simplex = structure.template simplex<1>(locate<1>(structure, {at, at}, hint));
    std::vector<double> found;
    for (const PointId p : simplex)
      found.push_back(p == infinite_point ? HUGE_VAL : structure.position(p).x);
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(ends(1.5), (std::vector<double>{1, 2}));
  EXPECT_EQ(ends(2.25), (std::vector<double>{2, 3}));
  EXPECT_EQ(ends(-7), (std::vector<double>{0, HUGE_VAL}));
  EXPECT_EQ(ends(7), (std::vector<double>{3, HUGE_VAL}));
}

}  // namespace
}  // namespace thiessen
