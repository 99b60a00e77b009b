#include "geometry/space_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/integer_determinants.h"
#include "geometry/seeded.h"
#include "geometry/space_families.h"
#include "geometry/stages.h"

namespace thiessen {
namespace {

using Four = std::array<SpacePoint, 4>;
using Five = std::array<SpacePoint, 5>;

/// As above, but only sets whose first four have a positive orientation.
template <class Check>
void for_all_spheres(std::uint64_t rounds, Check check) {
  for_all_families(rounds, [&](Five p) {
    const int side = orientation(p[0], p[1], p[2], p[3]);
    if (side < 0) std::swap(p[0], p[1]);
    if (side != 0) check(p);
  });
}

/// Every order of four numbers, and whether it is even.
std::vector<std::pair<std::array<std::size_t, 4>, bool>> permutations_of_four() {
  std::vector<std::pair<std::array<std::size_t, 4>, bool>> permutations;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) inversions += static_cast<int>(order[i] > order[j]);
    }
    permutations.emplace_back(order, inversions % 2 == 0);
  } while (std::next_permutation(order.begin(), order.end()));
  return permutations;
}

TEST(SpaceOrientation, is_positive_where_the_first_three_are_seen_counter_clockwise) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 3, 0}), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {7, 3, 5}), 0);
}

TEST(SpaceOrientation, laws_1_and_2_a_permutation_changes_the_sign_where_it_is_odd) {
  const auto permutations = permutations_of_four();
  ASSERT_EQ(permutations.size(), 24u);
  for_all_families(8000, [&](const Five& p) {
    const int side = orientation(p[0], p[1], p[2], p[3]);
    for (const auto& [order, even] : permutations) {
      ASSERT_EQ(orientation(p.at(order[0]), p.at(order[1]), p.at(order[2]), p.at(order[3])),
                even ? side : -side);
    }
  });
}

TEST(SpaceOrientation, agrees_with_whole_numbers) {
  Seeded seeded;
  int flat = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const long long size = 1LL << seeded.whole(1, 21);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::SpacePosition, 4> p{};
    for (auto& q : p)
      q = {seeded.whole(-size, size), seeded.whole(-size, size), seeded.whole(-size, size)};
    if (seeded.below(2) == 0)  // a parallelogram
      p[3] = {p[1].x + p[2].x - p[0].x, p[1].y + p[2].y - p[0].y, p[1].z + p[2].z - p[0].z};
    if (seeded.below(4) == 0) ++p[3].z;
    const int expected = whole::sign_of(whole::sixfold_volume(p[0], p[1], p[2], p[3]));
    flat += static_cast<int>(expected == 0);
    ASSERT_EQ(
        orientation(point(p[0], unit), point(p[1], unit), point(p[2], unit), point(p[3], unit)),
        expected);
  }
  EXPECT_GT(flat, 10000);
}

TEST(InSphere, is_inside_outside_or_on_it) {
  const SpacePoint o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(in_sphere(o, x, y, z, {0.25, 0.25, 0.25}), 1);
  EXPECT_EQ(in_sphere(o, x, y, z, {1, 1, 1}), 0);
  EXPECT_EQ(in_sphere(o, x, y, z, {1, 0, 0}), 0);
  EXPECT_EQ(in_sphere(o, x, y, z, {1, 1, std::nextafter(1, 2)}), -1);
  EXPECT_EQ(in_sphere(o, x, y, z, {1, 1, std::nextafter(1, 0)}), 1);
}

TEST(InSphere, law_1_stays_under_even_permutations) {
  const auto permutations = permutations_of_four();
  for_all_spheres(8000, [&](const Five& p) {
    const int side = in_sphere(p[0], p[1], p[2], p[3], p[4]);
    for (const auto& [order, even] : permutations) {
      if (!even) continue;
      ASSERT_EQ(in_sphere(p.at(order[0]), p.at(order[1]), p.at(order[2]), p.at(order[3]), p[4]),
                side);
    }
  });
}

// A corner and the fifth point change places: e inside means a outside where a sees b, c, d as e
// does, and inside where it sees them the other way round.
template <class Predicate>
void expect_law_2(const Five& p, int side, Predicate in) {
  const auto& [a, b, c, d, e] = p;
  const int seen = orientation(e, b, c, d);
  if (seen > 0) {
    ASSERT_EQ(in(e, b, c, d, a), -side);
  }
  if (seen < 0) {
    ASSERT_EQ(in(b, e, c, d, a), side);
  }
}

TEST(InSphere, law_2_when_a_corner_and_the_fifth_change_places) {
  for_all_spheres(20000, [](const Five& p) {
    expect_law_2(p, in_sphere(p[0], p[1], p[2], p[3], p[4]), in_sphere);
  });
}

TEST(InSphere, agrees_with_whole_numbers) {
  Seeded seeded;
  int on_sphere = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const long long size = 1LL << seeded.whole(1, 20);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::SpacePosition, 5> p{};
    for (auto& q : p)
      q = {seeded.whole(-size, size), seeded.whole(-size, size), seeded.whole(-size, size)};
    if (seeded.below(2) == 0) {  // corners of a cuboid, and beside them
      p[1].y = p[0].y, p[1].z = p[0].z;
      p[2] = {p[1].x, p[2].y, p[0].z};
      p[3] = {p[1].x, p[0].y, p[3].z};
      p[4] = {p[seeded.below(2)].x, p[2].y, p[3].z};
      if (seeded.below(4) == 0) ++p[4].z;
    }
    const auto volume = whole::sixfold_volume(p[0], p[1], p[2], p[3]);
    if (volume == 0) continue;
    if (volume < 0) std::swap(p[0], p[1]);
    const int expected = whole::sign_of(whole::in_sphere(p[0], p[1], p[2], p[3], p[4]));
    on_sphere += static_cast<int>(expected == 0);
    ASSERT_EQ(in_sphere(point(p[0], unit), point(p[1], unit), point(p[2], unit), point(p[3], unit),
                        point(p[4], unit)),
              expected);
  }
  EXPECT_GT(on_sphere, 10000);
}

TEST(InSphere, is_exact_at_both_ends_of_the_range) {
  for (const double s : {smallest_coordinate, 1.0, largest_coordinate}) {
    const SpacePoint a{-s, -s, -s}, b{s, -s, -s}, c{-s, s, -s}, d{-s, -s, s};
    ASSERT_EQ(orientation(a, b, c, d), 1);
    EXPECT_EQ(in_sphere(a, b, c, d, {s, s, s}), 0);
    EXPECT_EQ(in_sphere(a, b, c, d, {0, 0, 0}), 1);
    EXPECT_EQ(in_sphere(a, b, c, d, {s, s, std::nextafter(s, 2 * s)}), -1);
    EXPECT_EQ(in_sphere(a, b, c, d, {s, s, std::nextafter(s, 0)}), 1);
  }
}

TEST(InPerturbedSphere, agrees_with_in_sphere_off_the_sphere) {
  for_all_spheres(20000, [](const Five& p) {
    const int side = in_sphere(p[0], p[1], p[2], p[3], p[4]);
    if (side != 0) {
      ASSERT_EQ(in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]), side > 0);
    }
  });
}

TEST(InPerturbedSphere, law_1_stays_under_even_permutations) {
  const auto permutations = permutations_of_four();
  int ties = 0;
  for_all_spheres(30000, [&](const Five& p) {
    if (!are_different(p)) return;
    ties += static_cast<int>(in_sphere(p[0], p[1], p[2], p[3], p[4]) == 0);
    const bool inside = in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]);
    for (const auto& [order, even] : permutations) {
      if (!even) continue;
      ASSERT_EQ(
          in_perturbed_sphere(p.at(order[0]), p.at(order[1]), p.at(order[2]), p.at(order[3]), p[4]),
          inside);
    }
  });
  EXPECT_GT(ties, 1000);
}

TEST(InPerturbedSphere, law_2_when_a_corner_and_the_fifth_change_places) {
  const auto in = [](const auto&... p) { return in_perturbed_sphere(p...) ? 1 : -1; };
  int ties = 0;
  for_all_spheres(30000, [&](const Five& p) {
    if (!are_different(p)) return;
    ties += static_cast<int>(in_sphere(p[0], p[1], p[2], p[3], p[4]) == 0);
    expect_law_2(p, in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]) ? 1 : -1, in);
  });
  EXPECT_GT(ties, 1000);
}

// Of the unit cube's corners the last, (1, 1, 1), is lifted most: outside of all spheres through
// the others, and of two corners on a side with it the other is inside.
TEST(InPerturbedSphere, lifts_the_lexicographically_last_most) {
  const SpacePoint o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, last{1, 1, 1};
  EXPECT_FALSE(in_perturbed_sphere(o, x, y, z, last));
  EXPECT_TRUE(in_perturbed_sphere(x, y, z, last, {1, 1, 0}));
  EXPECT_FALSE(in_perturbed_sphere(y, x, z, o, last));
}

// The last corner of a cube and one more that is on a circle with the other three: the highest
// lift's coefficient is zero, and the next decides.
TEST(InPerturbedSphere, of_four_points_on_a_circle_and_a_fifth_asks_the_next) {
  const SpacePoint a{0, 0, 0}, b{0, 1, 0}, c{0, 1, 1}, d{0, 0, 1}, top{1, 0, 0};
  // d on the circle of a, b, c; of these c is the last: with d opened, a-c is no edge.
  ASSERT_EQ(orientation(a, b, c, top), 1);
  EXPECT_EQ(in_perturbed_sphere(a, b, c, top, d),
            in_perturbed_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}));
  EXPECT_EQ(in_perturbed_sphere(c, d, a, top, b),
            in_perturbed_circle({1, 1}, {0, 1}, {0, 0}, {1, 0}));
  EXPECT_EQ(in_perturbed_sphere(b, c, d, top, a),
            in_perturbed_circle({1, 0}, {1, 1}, {0, 1}, {0, 0}));
}

TEST(SpaceCompareDistance, tells_the_nearer) {
  EXPECT_EQ(compare_distance({0, 0, 0}, {1, 0, 0}, {0, 0, 2}), -1);
  EXPECT_EQ(compare_distance({0, 0, 0}, {3, 4, 12}, {0, 12, 0}), 1);
  EXPECT_EQ(compare_distance({0, 0, 0}, {3, 4, 12}, {0, -13, 0}), 0);
  EXPECT_EQ(compare_distance({0, 0, 0}, {3, 4, 12}, {0, -13, smallest_coordinate}), -1);
  EXPECT_EQ(compare_distance({0.1, 0.1, 0.1}, {0.1, 0.2, 0.1}, {0.1, 0.1, 0.2}), 0);
}

TEST(SpaceCompareDistance, agrees_with_whole_numbers_and_with_seven_limbs) {
  for_all_families(20000, [](const Five& p) {
    const auto difference = [](const auto& to) {
      return determinant::square(to[0]) - determinant::square(to[1]);
    };
    ASSERT_EQ(compare_distance(p[0], p[1], p[2]),
              sign_at_all_widths(std::array{p[1], p[2], p[0]}, difference));
  });
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const long long size = 1LL << seeded.whole(1, 28);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::SpacePosition, 3> p{};
    for (auto& q : p)
      q = {seeded.whole(-size, size), seeded.whole(-size, size), seeded.whole(-size, size)};
    if (seeded.below(2) == 0)  // the same vector with its coordinates exchanged
      p[2] = {p[0].x + (p[1].y - p[0].y), p[0].y + (p[1].z - p[0].z), p[0].z - (p[1].x - p[0].x)};
    if (seeded.below(4) == 0) ++p[2].y;
    const auto difference = whole::square_distance(p[0], p[1]) - whole::square_distance(p[0], p[2]);
    ASSERT_EQ(compare_distance(point(p[0], unit), point(p[1], unit), point(p[2], unit)),
              whole::sign_of(difference));
  }
}

TEST(SpaceCircumcentre, of_a_cuboids_corners_is_its_middle) {
  EXPECT_EQ(circumcentre({0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 6}), (SpacePoint{2, 1, 3}));
  EXPECT_EQ(circumcentre({500000, 4000000, 1}, {500008, 4000000, 1}, {500000, 4000006, 1},
                         {500000, 4000000, 3}),
            (SpacePoint{500004, 4000003, 2}));
}

TEST(SpaceCircumcentre, does_not_depend_on_the_order_of_the_points) {
  const auto permutations = permutations_of_four();
  for_all_spheres(8000, [&](const Five& p) {
    const SpacePoint centre = circumcentre(p[0], p[1], p[2], p[3]);
    for (const auto& [order, even] : permutations) {
      ASSERT_EQ(circumcentre(p.at(order[0]), p.at(order[1]), p.at(order[2]), p.at(order[3])),
                centre);
    }
  });
}

TEST(SpaceExactRange, asks_all_three_coordinates) {
  EXPECT_TRUE(in_exact_range(SpacePoint{0, smallest_coordinate, -largest_coordinate}));
  EXPECT_FALSE(in_exact_range(SpacePoint{HUGE_VAL, 0, 0}));
  EXPECT_FALSE(in_exact_range(SpacePoint{0, 1e-300, 0}));
  EXPECT_FALSE(in_exact_range(SpacePoint{0, 0, std::nan("")}));
}

}  // namespace
}  // namespace thiessen
