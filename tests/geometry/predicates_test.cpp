#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/integer_determinants.h"
#include "geometry/plane_families.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(Orientation, is_left_right_or_on_the_line) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), 0);
  EXPECT_EQ(orientation({0, 0}, {0, 0}, {7, 3}), 0);
}

TEST(Orientation, law_1_changes_its_sign_when_two_points_change_places) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    ASSERT_EQ(orientation(b, a, c), -orientation(a, b, c));
  }
}

TEST(Orientation, law_2_stays_when_the_points_turn) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    ASSERT_EQ(orientation(b, c, a), orientation(a, b, c));
  }
}

// L. Kettner, K. Mehlhorn, S. Pion, S. Schirra, C. Yap, Classroom examples of robustness problems
// in geometric computations, 2008: (0.5 + i u, 0.5 + j u) against the line through (12, 12) and
// (24, 24).
TEST(Orientation, of_kettners_grid_is_that_of_its_whole_numbers) {
  const double u = 0x1p-53;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Point p{0.5 + i * u, 0.5 + j * u};
      const int expected = p.y > p.x ? 1 : p.y < p.x ? -1 : 0;
      ASSERT_EQ(orientation({12, 12}, {24, 24}, p), expected) << i << " " << j;
    }
  }
}

// The same paper, failure A1: doubles see a contradiction among these.
TEST(Orientation, of_kettners_failure_a1) {
  const Point p1{7.3000000000000194, 7.3000000000000167};
  const Point p2{24.000000000000068, 24.000000000000071};
  const Point p3{24.00000000000005, 24.000000000000053};
  const Point p4{0.50000000000001621, 0.50000000000001243};
  EXPECT_EQ(orientation(p1, p2, p3), 1);
  EXPECT_EQ(orientation(p1, p2, p4), 1);
  EXPECT_EQ(orientation(p2, p3, p4), 1);
  EXPECT_EQ(orientation(p3, p1, p4), -1);
}

TEST(Orientation, agrees_with_whole_numbers) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const long long size = 1LL << seeded.whole(1, 28);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::Position, 3> p{};
    for (auto& corner : p) corner = {seeded.whole(-size, size), seeded.whole(-size, size)};
    if (seeded.below(2) == 0) p[2] = {2 * p[1].x - p[0].x, 2 * p[1].y - p[0].y};
    ASSERT_EQ(orientation(point(p[0], unit), point(p[1], unit), point(p[2], unit)),
              whole::sign_of(whole::doubled_area(p[0], p[1], p[2])));
  }
}

// Beside the diagonal by less than doubles can tell: the filter must pass it on.
TEST(Orientation, is_exact_where_the_filter_cannot_decide) {
  const double tiny = smallest_coordinate;
  const double huge = largest_coordinate;
  EXPECT_EQ(orientation({0, 0}, {huge, huge}, {tiny, tiny}), 0);
  EXPECT_EQ(orientation({0, 0}, {huge, huge}, {tiny, std::nextafter(tiny, 1)}), 1);
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {tiny, std::nextafter(tiny, 1)}), 1);
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, tiny}), 1);
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, -tiny}), -1);
}

TEST(DoubledArea, is_that_of_the_triangle_in_whole_numbers) {
  EXPECT_EQ(doubled_area({0, 0}, {4, 0}, {0, 3}), 12);
  EXPECT_EQ(doubled_area({0, 0}, {0, 3}, {4, 0}), -12);
  EXPECT_EQ(doubled_area({0, 0}, {134217728, 134217729}, {134217727, 134217728}), 1);
}

TEST(DoubledArea, changes_its_sign_alone_when_two_points_change_places) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    ASSERT_EQ(doubled_area(b, a, c), -doubled_area(a, b, c));
  }
}

TEST(InCircle, is_inside_outside_or_on_it) {
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}), 1);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {0, 1}, {1, std::nextafter(1, 2)}), -1);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {0, 1}, {1, std::nextafter(1, 0)}), 1);
}

TEST(InCircle, law_1_stays_under_even_permutations) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    auto [a, b, c, d] = random_corners(seeded);
    if (orientation(a, b, c) == 0) continue;
    if (orientation(a, b, c) < 0) std::swap(a, b);
    const int side = in_circle(a, b, c, d);
    ASSERT_EQ(in_circle(b, c, a, d), side);
    ASSERT_EQ(in_circle(c, a, b, d), side);
  }
}

TEST(InCircle, law_2_changes_its_sign_round_a_convex_quadrilateral) {
  Seeded seeded;
  int convex = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    if (orientation(a, b, c) <= 0 || orientation(b, c, d) <= 0 || orientation(c, d, a) <= 0 ||
        orientation(d, a, b) <= 0)
      continue;
    ++convex;
    ASSERT_EQ(in_circle(b, c, d, a), -in_circle(a, b, c, d));
  }
  EXPECT_GT(convex, 1000);
}

TEST(InCircle, agrees_with_whole_numbers) {
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const long long size = 1LL << seeded.whole(1, 26);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::Position, 4> p{};
    for (auto& corner : p) corner = {seeded.whole(-size, size), seeded.whole(-size, size)};
    // A rectangle, and a rectangle with one corner a step away.
    if (seeded.below(2) == 0) p[3] = {p[0].x, p[2].y};
    if (seeded.below(2) == 0) p[1] = {p[2].x, p[0].y};
    if (seeded.below(4) == 0) ++p[3].x;
    if (whole::doubled_area(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    if (whole::doubled_area(p[0], p[1], p[2]) == 0) continue;
    const int expected = whole::sign_of(whole::in_circle(p[0], p[1], p[2], p[3]));
    on_circle += expected == 0;
    ASSERT_EQ(in_circle(point(p[0], unit), point(p[1], unit), point(p[2], unit), point(p[3], unit)),
              expected);
  }
  EXPECT_GT(on_circle, 1000);
}

TEST(InCircle, is_exact_at_both_ends_of_the_range) {
  for (const double s : {smallest_coordinate, 1.0, largest_coordinate}) {
    EXPECT_EQ(in_circle({-s, -s}, {s, -s}, {s, s}, {-s, s}), 0);
    EXPECT_EQ(in_circle({-s, -s}, {s, -s}, {s, s}, {0, 0}), 1);
    EXPECT_EQ(in_circle({-s, -s}, {s, -s}, {s, s}, {-std::nextafter(s, 2 * s), s}), -1);
  }
  const double h = largest_coordinate;
  EXPECT_EQ(in_circle({-h, 0}, {h, 0}, {0, h}, {smallest_coordinate, -h}), -1);
  EXPECT_EQ(in_circle({-h, 0}, {h, 0}, {0, h}, {smallest_coordinate, h}), -1);
  EXPECT_EQ(in_circle({-h, 0}, {h, 0}, {0, h}, {0, -h}), 0);
}

// Points of x^2 + y^2 = 325^2 with whole coordinates.
std::vector<Point> circle_of_whole_numbers() {
  std::vector<Point> points;
  for (int x = -325; x <= 325; ++x) {
    for (int y = -325; y <= 325; ++y) {
      if (x * x + y * y == 325 * 325)
        points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  return points;
}

TEST(InPerturbedCircle, agrees_with_in_circle_off_the_circle) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    auto [a, b, c, d] = random_corners(seeded);
    if (orientation(a, b, c) < 0) std::swap(a, b);
    if (orientation(a, b, c) <= 0 || in_circle(a, b, c, d) == 0) continue;
    ASSERT_EQ(in_perturbed_circle(a, b, c, d), in_circle(a, b, c, d) > 0);
  }
}

TEST(InPerturbedCircle, law_stays_under_even_permutations) {
  const std::vector<Point> circle = circle_of_whole_numbers();
  ASSERT_EQ(circle.size(), 60u);
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    std::array<Point, 4> p;
    std::sample(circle.begin(), circle.end(), p.begin(), 4, seeded.generator());
    std::shuffle(p.begin(), p.end(), seeded.generator());
    if (orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const bool inside = in_perturbed_circle(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(in_perturbed_circle(p[1], p[2], p[0], p[3]), inside);
    ASSERT_EQ(in_perturbed_circle(p[2], p[0], p[1], p[3]), inside);
  }
}

// Of a quadrilateral's two diagonals one is Delaunay, and each triangle at it agrees.
TEST(InPerturbedCircle, chooses_one_diagonal_of_four_points_on_a_circle) {
  const std::vector<Point> circle = circle_of_whole_numbers();
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    std::array<Point, 4> p;
    std::sample(circle.begin(), circle.end(), p.begin(), 4, seeded.generator());
    std::sort(p.begin(), p.end(), [](Point s, Point t) {
      return std::atan2(s.y, s.x) < std::atan2(t.y, t.x);  // counter-clockwise
    });
    const auto [a, b, c, d] = p;
    ASSERT_EQ(orientation(a, b, c), 1);
    const bool d_inside_abc = in_perturbed_circle(a, b, c, d);
    ASSERT_EQ(in_perturbed_circle(c, d, a, b), d_inside_abc);
    ASSERT_EQ(in_perturbed_circle(b, c, d, a), !d_inside_abc);
    ASSERT_EQ(in_perturbed_circle(d, a, b, c), !d_inside_abc);
  }
}

// The thesis leaves four points on a circle open; here the lexicographically last is lifted most,
// so that its diagonal goes.
TEST(InPerturbedCircle, of_a_square_keeps_the_diagonal_that_misses_its_last_corner) {
  EXPECT_FALSE(in_perturbed_circle({0, 0}, {1, 0}, {0, 1}, {1, 1}));
  EXPECT_TRUE(in_perturbed_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}));
}

TEST(CompareDistance, tells_the_nearer) {
  EXPECT_EQ(compare_distance(Point{0, 0}, {1, 0}, {0, 2}), -1);
  EXPECT_EQ(compare_distance(Point{0, 0}, {3, 4}, {0, 2}), 1);
  EXPECT_EQ(compare_distance(Point{0, 0}, {3, 4}, {-5, 0}), 0);
  EXPECT_EQ(compare_distance(Point{0, 0}, {3, 4}, {-5, smallest_coordinate}), -1);
  EXPECT_EQ(compare_distance(Point{0.1, 0.1}, {0.1, 0.2}, {0.2, 0.1}), 0);
}

TEST(CompareDistance, agrees_with_whole_numbers) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const long long size = 1LL << seeded.whole(1, 28);
    const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-60, 60)));
    std::array<whole::Position, 3> p{};
    for (auto& corner : p) corner = {seeded.whole(-size, size), seeded.whole(-size, size)};
    if (seeded.below(2) == 0) p[2] = {p[0].x + (p[1].y - p[0].y), p[0].y - (p[1].x - p[0].x)};
    if (seeded.below(4) == 0) ++p[2].y;
    const auto difference = whole::square_distance(p[0], p[1]) - whole::square_distance(p[0], p[2]);
    ASSERT_EQ(compare_distance(point(p[0], unit), point(p[1], unit), point(p[2], unit)),
              whole::sign_of(difference));
  }
}

TEST(Circumcentre, of_a_right_triangle_is_its_hypotenuses_middle) {
  EXPECT_EQ(circumcentre({0, 0}, {4, 0}, {0, 2}), (Point{2, 1}));
  EXPECT_EQ(circumcentre({500000, 4000000}, {500008, 4000000}, {500000, 4000006}),
            (Point{500004, 4000003}));
}

TEST(Circumcentre, does_not_depend_on_the_order_of_the_points) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const Corners corners = random_corners(seeded);
    std::array<Point, 3> p{corners[0], corners[1], corners[2]};
    if (orientation(p[0], p[1], p[2]) == 0) continue;
    std::sort(p.begin(), p.end());
    const Point centre = circumcentre(p[0], p[1], p[2]);
    while (std::next_permutation(p.begin(), p.end())) {
      ASSERT_EQ(circumcentre(p[0], p[1], p[2]), centre);
    }
  }
}

// Whichever of the two stages tells it.
TEST(Circumcentre, is_that_of_whole_numbers_to_the_bit) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const Corners corners = random_corners(seeded);
    const double size = std::pow(10, seeded.uniform(-6, 6));
    const auto near = [&](double at) { return at + size * seeded.uniform(-1, 1); };
    const Point middle{seeded.uniform(-1e6, 1e6), seeded.uniform(0, 1e6)};
    std::array<Point, 3> p{corners[0], corners[1], corners[2]};
    if (round % 2 == 0) {
      for (Point& q : p) q = {near(middle.x), near(middle.y)};
    }
    if (orientation(p[0], p[1], p[2]) == 0) continue;
    std::sort(p.begin(), p.end());
    ASSERT_EQ(circumcentre(p[0], p[1], p[2]), exact::circumcentre(p[0], p[1], p[2]));
  }
}

TEST(ExactRange, holds_zero_and_what_lies_between_its_ends) {
  EXPECT_TRUE(in_exact_range(0.0));
  EXPECT_TRUE(in_exact_range(-0.0));
  EXPECT_TRUE(in_exact_range(smallest_coordinate));
  EXPECT_TRUE(in_exact_range(-largest_coordinate));
  EXPECT_FALSE(in_exact_range(std::nextafter(smallest_coordinate, 0)));
  EXPECT_FALSE(in_exact_range(std::nextafter(largest_coordinate, HUGE_VAL)));
  EXPECT_FALSE(in_exact_range(std::nan("")));
  EXPECT_FALSE(in_exact_range(Point{1, HUGE_VAL}));
}

}  // namespace
}  // namespace thiessen
