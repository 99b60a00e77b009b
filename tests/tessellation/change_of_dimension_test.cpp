// Points that come to span more, and less: the steps by themselves, from nothing to space and back.
#include "tessellation/change_of_dimension.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class ChangeOfDimensionIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(ChangeOfDimensionIn, PlaneAndSpace);

/// Points that span less than the plane or space, and one that lies off what they span.
template <int Dimension>
struct Base {
  std::vector<PositionIn<Dimension>> points;
  PositionIn<Dimension> apex;
};

std::vector<Base<2>> bases(Seeded& seeded, std::integral_constant<int, 2>) {
  std::vector<Base<2>> all{{{}, {3, 4}}, {{{3, 4}}, {1, 9}}, {{{3, 4}}, {7, -2}}};
  for (const Point step : {Point{1, 2}, Point{0, 1}, Point{-1, 0}}) {
    for (const Point apex : {Point{5, 3}, Point{-9, 400}, Point{2.5, -0x1p-40}}) {
      std::vector<Point> line = families::line(12, {0, 0}, step);
      if (orientation(line[0], line[1], apex) == 0) continue;
      std::shuffle(line.begin(), line.end(), seeded.generator());
      all.push_back({line, apex});
    }
  }
  return all;
}

std::vector<Base<3>> bases(Seeded& seeded, std::integral_constant<int, 3>) {
  std::vector<Base<3>> all{{{}, {3, 4, 5}}, {{{3, 4, 5}}, {1, 9, 9}}};
  for (const SpacePoint& step : {SpacePoint{1, 2, -3}, SpacePoint{0, 0, 1}, SpacePoint{-1, 0, 0}}) {
    for (const SpacePoint& apex : {SpacePoint{5, 3, 1}, SpacePoint{-9, 400, -2}})
      all.push_back({families::line_in_space(12, {0, 0, 0}, step), apex});
  }
  std::vector<Point> scattered(30);
  for (Point& p : scattered)
    p = {static_cast<double>(seeded.whole(0, 1000)), static_cast<double>(seeded.whole(0, 1000))};
  const std::vector<std::vector<Point>> flat{distinct(scattered),
                                             families::lattice(25, 1, {0, 0}, 0),
                                             families::whole_circle({0, 0}),
                                             {{0, 0}, {1, 0}, {0, 1}}};
  for (const std::vector<Point>& points : flat) {
    for (const double slope : {0.0, 2.0}) {
      const auto plane = families::on_plane(points, {0, 0, 0}, slope, -slope / 2);
      all.push_back({plane, {1, 1, 1000}});
      all.push_back({plane, {1, 1, -1000}});
    }
  }
  return all;
}

template <int Dimension>
PointId raise(Tessellation<Dimension>& tessellation, const PositionIn<Dimension>& apex) {
  Structure<Dimension>& structure = tessellation.structure_to_break();
  const PointId p = structure.add_point(apex);
  raise_dimension(structure, p);
  return p;
}

TYPED_TEST(ChangeOfDimensionIn, law_1_raised_it_is_the_tessellation_of_all_points) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (auto& [points, apex] : bases(seeded, std::integral_constant<int, d>())) {
    Tessellation<d> tessellation = tessellation_of(points);
    const int before = tessellation.topology().dimension();
    raise<d>(tessellation, apex);
    EXPECT_EQ(tessellation.topology().dimension(), before + 1);
    points.push_back(apex);
    EXPECT_EQ(plain_simplices(tessellation), plain_simplices(tessellation_of(points)));
    expect_sound(tessellation);
  }
}

// The apex over what was there: a simplex over each finite one, and on the hull these themselves
// and a facet over each end.
TYPED_TEST(ChangeOfDimensionIn, law_2_every_simplex_gets_the_apex_and_finite_ones_a_copy) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const auto& [points, apex] : bases(seeded, std::integral_constant<int, d>())) {
    Tessellation<d> tessellation = tessellation_of(points);
    if (tessellation.span() < Span::line) continue;
    const std::size_t finite = count_finite(tessellation);
    const std::size_t infinite = plain_simplices(tessellation).size() - finite;
    const PointId p = raise<d>(tessellation, apex);
    std::size_t with_apex = 0;
    const Topology<d>& topology = tessellation.topology();
    topology.for_each_vertex([&](VertexId v) {
      with_apex += topology.corner_of(v, p) < Topology<d>::corners ? 1u : 0u;
    });
    EXPECT_EQ(with_apex, finite + infinite);
    EXPECT_EQ(count_finite(tessellation), finite);
    EXPECT_EQ(plain_simplices(tessellation).size(), 2 * finite + infinite);
  }
}

TYPED_TEST(ChangeOfDimensionIn, law_3_lowered_again_it_is_what_it_was) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const auto& [points, apex] : bases(seeded, std::integral_constant<int, d>())) {
    Tessellation<d> tessellation = tessellation_of(points);
    const auto before = plain_simplices(tessellation);
    const int spanned = tessellation.topology().dimension();
    const PointId p = raise<d>(tessellation, apex);
    lower_dimension(tessellation.structure_to_break(), p);
    EXPECT_EQ(tessellation.topology().dimension(), spanned);
    EXPECT_FALSE(tessellation.is_there(p));
    EXPECT_EQ(tessellation.count(), points.size());
    EXPECT_EQ(plain_simplices(tessellation), before);
    expect_sound(tessellation);
  }
}

// A point, and from there a ring of three: from each to the next the order is that of coordinates,
// over the infinite point.
TYPED_TEST(ChangeOfDimensionIn, from_nothing_to_a_point_to_a_line) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const PointId b = raise<d>(tessellation, {3, 4});
  const Topology<d>& topology = tessellation.topology();
  EXPECT_EQ(topology.size(), 2u);
  EXPECT_EQ(topology.neighbour(topology.vertex_of(b), 0), topology.vertex_of(infinite_point));
  const PointId a = raise<d>(tessellation, {1, 9});
  ASSERT_EQ(plain_simplices(tessellation).size(), 3u);
  const std::vector<PointId> order{a, b, infinite_point};
  std::size_t met = 0;
  topology.for_each_vertex([&](VertexId v) {
    const auto from = std::find(order.begin(), order.end(), topology.forming(v)[0]) - order.begin();
    EXPECT_EQ(topology.forming(v)[1], order[static_cast<std::size_t>(from + 1) % 3]);
    EXPECT_EQ(topology.forming(topology.neighbour(v, 0))[0], topology.forming(v)[1]);
    ++met;
  });
  EXPECT_EQ(met, 3u);
}

TYPED_TEST(ChangeOfDimensionIn, from_a_point_to_nothing) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const PointId p = raise<d>(tessellation, {3, 4});
  lower_dimension(tessellation.structure_to_break(), p);
  EXPECT_EQ(tessellation.span(), Span::nothing);
  EXPECT_TRUE(tessellation.empty());
  EXPECT_TRUE(plain_simplices(tessellation).empty());
}

}  // namespace
}  // namespace thiessen
