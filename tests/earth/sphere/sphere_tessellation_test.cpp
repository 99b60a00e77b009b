// The tessellation of the conformal sphere, judged place by place.
#include "earth/sphere/sphere_tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "earth/networks.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

template <typename Look>
void for_each_network(Look&& look) {
  Seeded seeded;
  for (const WorldNetwork& network : world_networks(seeded)) {
    SCOPED_TRACE(network.name);
    look(seeded, network.places, SphereTessellation(network.places));
  }
}

/// Calls `look` with the corners of each triangle, counter-clockwise.
template <typename Look>
void for_each_triangle(const SphereTessellation& sphere, Look&& look) {
  const Topology<2>& topology = sphere.tessellation().topology();
  topology.for_each_vertex([&](VertexId v) {
    const auto& forming = topology.forming(v);
    look(sphere.place(forming[0]), sphere.place(forming[1]), sphere.place(forming[2]));
  });
}

TEST(SphereTessellation, law_1_a_centre_is_as_far_from_its_corners_and_no_place_is_nearer) {
  for_each_network([](Seeded&, const std::vector<Point>& places, const SphereTessellation& sphere) {
    std::size_t triangles = 0;
    for_each_triangle(sphere, [&](PlaceIndex a, PlaceIndex b, PlaceIndex c) {
      ++triangles;
      const Direction centre = sphere.centre(a, b, c);
      const double cosine = dot(centre, sphere.direction(a));
      EXPECT_NEAR(length(centre), 1, 1e-15);
      EXPECT_NEAR(dot(centre, sphere.direction(b)), cosine, 1e-14);
      EXPECT_NEAR(dot(centre, sphere.direction(c)), cosine, 1e-14);
      for (std::uint32_t p = 0; p < places.size(); ++p)
        ASSERT_LE(dot(centre, sphere.direction(PlaceIndex{p})), cosine + 1e-14);
    });
    EXPECT_EQ(triangles, 2 * places.size() - 4);  // Euler's relation on a sphere
  });
}

TEST(SphereTessellation, law_2_neighbours_are_mutual_and_the_sides_of_triangles) {
  for_each_network([](Seeded&, const std::vector<Point>& places, const SphereTessellation& sphere) {
    std::set<std::pair<PlaceIndex, PlaceIndex>> sides, pairs;
    for_each_triangle(sphere, [&](PlaceIndex a, PlaceIndex b, PlaceIndex c) {
      for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
        sides.insert({p, q});
    });
    for (std::uint32_t p = 0; p < places.size(); ++p) {
      for (const PlaceIndex q : sphere.neighbours(PlaceIndex{p})) pairs.insert({PlaceIndex{p}, q});
    }
    EXPECT_EQ(pairs, sides);
  });
}

TEST(SphereTessellation, law_3_the_nearest_place_is_that_of_all_from_wherever_the_walk_starts) {
  for_each_network(
      [](Seeded& seeded, const std::vector<Point>& places, const SphereTessellation& sphere) {
        for (int i = 0; i < 300; ++i) {
          const Point any = places[seeded.below(places.size())];
          const Point p = i % 2 == 0 ? random_point(seeded) : random_point_at(seeded, any, 3e3);
          const Direction at = on_sphere(p);
          double least = HUGE_VAL;
          for (std::uint32_t k = 0; k < places.size(); ++k)
            least = std::min(least, sphere.square_distance(at, PlaceIndex{k}));
          const PlaceIndex start{static_cast<std::uint32_t>(seeded.below(places.size()))};
          ASSERT_LE(sphere.square_distance(at, sphere.nearest(at)), least + 1e-15);
          ASSERT_LE(sphere.square_distance(at, sphere.nearest(at, start)), least + 1e-15);
        }
      });
}

TEST(SphereTessellation, law_4_the_nearest_on_the_earth_is_so_by_geodesics) {
  for_each_network(
      [](Seeded& seeded, const std::vector<Point>& places, const SphereTessellation& sphere) {
        for (int i = 0; i < 100; ++i) {
          const Point any = places[seeded.below(places.size())];
          const Point p = i % 2 == 0 ? random_point(seeded) : random_point_at(seeded, any, 3e3);
          double least = HUGE_VAL;
          for (const Point q : places) least = std::min(least, geodesic_distance(q, p));
          const Point found = places[index(sphere.nearest_on_earth(p))];
          ASSERT_NEAR(geodesic_distance(found, p), least, 5e-8) << p.x << ' ' << p.y;
        }
      });
}

using Pairs = std::set<std::pair<Point, Point>>;

Pairs neighbours_of(const std::vector<Point>& places) {
  const SphereTessellation sphere(places);
  Pairs pairs;
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    for (const PlaceIndex q : sphere.neighbours(PlaceIndex{p}))
      pairs.insert({places[p], places[index(q)]});
  }
  return pairs;
}

TEST(SphereTessellation, law_5_the_order_of_the_places_does_not_matter) {
  Seeded seeded;
  for (WorldNetwork& network : world_networks(seeded)) {
    SCOPED_TRACE(network.name);
    const Pairs expected = neighbours_of(network.places);
    std::shuffle(network.places.begin(), network.places.end(), seeded.generator());
    EXPECT_EQ(neighbours_of(network.places), expected);
    const SphereTessellation sphere(network.places);
    EXPECT_EQ(network.places[index(sphere.pole())],
              *std::min_element(network.places.begin(), network.places.end()));
  }
}

// At the equator 3e-12 degrees are 5e-14 radians, and the ends of four such steps are 2e-13 apart;
// 1e-10 degrees are told apart.
TEST(SphereTessellation, law_6_a_chain_of_places_that_rounding_does_not_tell_apart_has_one_owner) {
  Seeded seeded;
  std::vector<Point> places{{10 + 1e-10, 0}};
  for (int i = 4; i >= 0; --i) places.push_back({10 + 3e-12 * i, 0});
  for (int i = 0; i < 30; ++i) places.push_back(random_point(seeded));
  for (int round = 0; round < 10; ++round) {
    const SphereTessellation sphere(places);
    const std::set<PlaceIndex> owners(sphere.cell_of().begin(), sphere.cell_of().end());
    EXPECT_EQ(owners.size(), places.size() - 4);
    for (std::uint32_t p = 0; p < places.size(); ++p) {
      const Point owner = places[index(sphere.cell_of()[p])];
      const bool is_of_chain = places[p].y == 0 && places[p].x < 10 + 2e-11;
      EXPECT_EQ(owner, is_of_chain ? (Point{10, 0}) : places[p]);
    }
    std::shuffle(places.begin(), places.end(), seeded.generator());
  }
}

TEST(SphereTessellation, law_7_places_of_one_direction_share_the_cell_of_the_first_by_coordinates) {
  Seeded seeded;
  std::vector<Point> places{{40, 90}, {-77, 90}, {12, 90}, {180, 5}, {-180, 5}, {-180, -60}};
  for (int i = 0; i < 20; ++i) places.push_back({seeded.uniform(-170, 170), 0.1 * i});
  for (int round = 0; round < 10; ++round) {
    const SphereTessellation sphere(places);
    for (std::uint32_t p = 0; p < places.size(); ++p) {
      const Point owner = places[index(sphere.cell_of()[p])];
      const Point expected = places[p].y == 90                                  ? Point{-77, 90}
                             : places[p].y == 5 && std::abs(places[p].x) == 180 ? Point{-180, 5}
                                                                                : places[p];
      EXPECT_EQ(owner, expected);
    }
    std::shuffle(places.begin(), places.end(), seeded.generator());
  }
}

TEST(SphereTessellation, law_8_of_few_places_each_is_every_others_neighbour) {
  const std::vector<Point> places{{0, 10}, {40, -20}, {-100, 60}};
  for (std::size_t count = 1; count <= 3; ++count) {
    const std::vector<Point> some(places.begin(),
                                  places.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ(neighbours_of(some).size(), count * (count - 1));
    const SphereTessellation sphere(some);
    EXPECT_LT(sphere.tessellation().span(), Span::plane);
    for (const Point p : some) EXPECT_EQ(some[index(sphere.nearest(on_sphere(p)))], p);
  }
}

TEST(SphereTessellation, law_9_a_triangle_is_turned_to_its_first_corner_and_keyed_by_all_three) {
  const SphereTessellation sphere(std::vector<Point>{{5, 5}, {-3, 8}, {-3, 2}, {50, 50}});
  const std::array<PlaceIndex, 3> corners{PlaceIndex{0}, PlaceIndex{1}, PlaceIndex{2}};
  const std::array<PlaceIndex, 3> turned{PlaceIndex{2}, PlaceIndex{0}, PlaceIndex{1}};
  EXPECT_EQ(sphere.in_order(corners), turned);
  EXPECT_EQ(sphere.in_order({corners[1], corners[2], corners[0]}), turned);
  const std::array<Point, 3> key{Point{-3, 2}, Point{-3, 8}, Point{5, 5}};
  EXPECT_EQ(sphere.key_of(corners), key);
  EXPECT_EQ(sphere.key_of({corners[1], corners[0], corners[2]}), key);
}

}  // namespace
}  // namespace thiessen
