#include "tessellation/conflict_zone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

template <typename Constant>
class ConflictZoneOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(ConflictZoneOf, PlaneAndSpace);

template <int Dimension>
using Simplices = std::vector<PlainSimplexIn<Dimension>>;

template <int Dimension>
Simplices<Dimension> not_in(const Simplices<Dimension>& these, const Simplices<Dimension>& those) {
  Simplices<Dimension> left;
  std::set_difference(these.begin(), these.end(), those.begin(), those.end(),
                      std::back_inserter(left));
  return left;
}

template <int Dimension>
Simplices<Dimension> zone_simplices(const Tessellation<Dimension>& tessellation,
                                    const ConflictZone<Dimension>& zone) {
  const Topology<Dimension>& topology = tessellation.topology();
  const auto corners = static_cast<std::size_t>(topology.dimension()) + 1;
  Simplices<Dimension> simplices;
  for (const VertexId v : zone.vertices()) {
    PlainSimplexIn<Dimension> simplex;
    simplex.fill(infinite_position<Dimension>());
    for (std::size_t i = 0; i < corners; ++i) {
      const PointId p = topology.forming(v)[i];
      if (p != infinite_point) simplex[i] = tessellation.position(p);
    }
    if (sort_corners(simplex, corners)) std::swap(simplex[corners - 1], simplex[corners - 2]);
    simplices.push_back(simplex);
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

template <int Dimension>
void expect_rim_round_zone(const Topology<Dimension>& topology,
                           const ConflictZone<Dimension>& zone) {
  const auto is_inside = [&](VertexId v) {
    return std::count(zone.vertices().begin(), zone.vertices().end(), v) == 1;
  };
  std::size_t facets = 0;
  for (const VertexId v : zone.vertices()) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(topology.dimension()); ++i)
      facets += is_inside(topology.neighbour(v, i)) ? 0u : 1u;
  }
  EXPECT_EQ(zone.rim().size(), facets);
  for (const auto& f : zone.rim()) {
    EXPECT_TRUE(is_inside(f.inside));
    EXPECT_FALSE(is_inside(f.outside));
    EXPECT_EQ(topology.neighbour(f.inside, f.side), f.outside);
    EXPECT_EQ(topology.neighbour(f.outside, f.outside_side), f.inside);
  }
}

// What a point's insertion deletes, in every span and with every tie.
TYPED_TEST(ConflictZoneOf, a_new_point_is_what_its_insertion_deletes) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (FamilyIn<d>& family : families::all_in<d>(seeded, 40)) {
      SCOPED_TRACE(family.name);
      std::shuffle(family.points.begin(), family.points.end(), seeded.generator());
      Tessellation<d> tessellation;
      ConflictZone<d> zone;
      for (const auto& p : family.points) {
        const bool grows = tessellation.empty() || (tessellation.topology().dimension() < d &&
                                                    tessellation.structure().is_off(p));
        if (grows || tessellation.span() < Span::line) {
          tessellation.add(p);
          continue;
        }
        const bool is_new = !tessellation.find(p).has_value();
        ASSERT_EQ(tessellation.find_conflict_zone(p, {}, zone), is_new);
        const Simplices<d> before = plain_simplices(tessellation);
        if (is_new) expect_rim_round_zone(tessellation.topology(), zone);
        const Simplices<d> doomed = is_new ? zone_simplices(tessellation, zone) : Simplices<d>{};
        tessellation.add(p);
        const Simplices<d> after = plain_simplices(tessellation);
        ASSERT_EQ(doomed, not_in<d>(before, after));
        const Simplices<d> come = not_in<d>(after, before);
        if (is_new) {
          ASSERT_EQ(come.size(), zone.rim().size());
        } else {
          ASSERT_TRUE(come.empty());
        }
      }
    }
  }
}

// Each facet of the rim ends where the next begins.
TEST(ConflictZoneInPlane, has_its_rim_in_order) {
  Seeded seeded;
  const Tessellation<2> tessellation = tessellation_of(families::uniform(seeded, 100));
  const Topology<2>& topology = tessellation.topology();
  ConflictZone<2> zone;
  for (int i = 0; i < 200; ++i) {
    const Point p{seeded.uniform(-0.2, 1.2), seeded.uniform(-0.2, 1.2)};
    ASSERT_TRUE(tessellation.find_conflict_zone(p, {}, zone));
    const auto& rim = zone.rim();
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const auto& next = rim[(k + 1) % rim.size()];
      ASSERT_EQ(topology.forming(rim[k].inside)[(rim[k].side + 2u) % 3],
                topology.forming(next.inside)[(next.side + 1u) % 3]);
    }
  }
}

// A simplex is in the zone exactly where its sphere holds the point, or it has the infinite point
// and sees it: by looking at each.
TYPED_TEST(ConflictZoneOf, a_new_point_is_every_simplex_in_conflict) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  std::vector<PositionIn<d>> points;
  if constexpr (d == 2) {
    points = distinct(families::small_grid(seeded, 30, 4));
  } else {
    points = distinct(families::small_grid_in_space(seeded, 40, 3));
  }
  const Tessellation<d> tessellation = tessellation_of(points);
  ConflictZone<d> zone;
  for (int i = 0; i < 300; ++i) {
    CoordinatesIn<d> c;
    for (double& x : c) x = static_cast<double>(seeded.whole(-10, 10)) / 2;
    const PositionIn<d> p = position_of<d>(c);
    if (!tessellation.find_conflict_zone(p, {}, zone)) continue;
    std::vector<VertexId> expected;
    tessellation.topology().for_each_vertex([&](VertexId v) {
      const auto simplex = tessellation.structure().template simplex<d>(v);
      if (tessellation.structure().template in_conflict<d>(simplex, p)) expected.push_back(v);
    });
    std::vector<VertexId> found = zone.vertices();
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace thiessen
