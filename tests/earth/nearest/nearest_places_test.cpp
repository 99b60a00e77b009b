// Rivals in balls, in both metrics: whatever point of a ball is asked for, its nearest place is
// among them.
#include "earth/nearest/nearest_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

class NearestPlacesBy : public testing::TestWithParam<Metric> {
 protected:
  Point near(Point p, double size) {
    return {p.x + size * seeded_.uniform(-1, 1), p.y + size * seeded_.uniform(-1, 1)};
  }
  double distance(Point a, Point b) const {
    return GetParam() == Metric::planar ? std::hypot(a.x - b.x, a.y - b.y)
                                        : geodesic_distance(a, b);
  }
  /// A ball that holds the points, round the first of them.
  Ball ball_of(const std::vector<Point>& points) const {
    Ball ball{nearest_->in_space(points.front()), 0};
    for (const Point p : points)
      ball.radius = std::max(ball.radius, length(nearest_->in_space(p) - ball.centre));
    return ball;
  }
  std::vector<Point> points_round(Point middle, double size) {
    std::vector<Point> points{middle};
    for (int i = 0; i < 10; ++i) points.push_back(near(middle, size));
    return points;
  }
  std::vector<PlaceIndex> rivals(const Ball& ball) const {
    std::vector<PlaceIndex> rivals;
    nearest_->find_rivals(ball, rivals);
    return rivals;
  }
  /// Nothing but rounding is nearer to the point than the nearest of the rivals.
  void expect_nearest_among(const std::vector<PlaceIndex>& rivals, Point p) const {
    double least = HUGE_VAL;
    for (const Point place : places_) least = std::min(least, distance(place, p));
    double of_rivals = HUGE_VAL;
    for (const PlaceIndex r : rivals)
      of_rivals = std::min(of_rivals, distance(places_[index(r)], p));
    EXPECT_LE(of_rivals, least * (1 + 1e-15) + 2e-8);
  }

  std::vector<Point> places() {
    std::vector<Point> places;
    for (int i = 0; i < 60; ++i) places.push_back(near(centre_, 2));
    return places;
  }

  Seeded seeded_;
  const Point centre_{20, 50};
  const std::vector<Point> places_{places()};
  const std::unique_ptr<NearestPlaces> nearest_{nearest_places(places_, GetParam())};
};

TEST_P(NearestPlacesBy, law_1_the_nearest_place_of_every_point_of_a_ball_is_a_rival_there) {
  for (std::uint64_t round = 0; round < Seeded::rounds(60); ++round) {
    const double size = std::pow(10, seeded_.uniform(-6, 0.5));
    const std::vector<Point> points = points_round(near(centre_, 4), size);
    const std::vector<PlaceIndex> found = rivals(ball_of(points));
    for (const Point p : points) {
      expect_nearest_among(found, p);
      const auto nearest = nearest_->nearest(p, found);
      ASSERT_TRUE(nearest);
      expect_nearest_among({*nearest}, p);
    }
  }
}

TEST_P(NearestPlacesBy, law_2_in_a_ball_within_another_they_are_some_of_its_rivals_in_their_order) {
  for (std::uint64_t round = 0; round < Seeded::rounds(60); ++round) {
    const double size = std::pow(10, seeded_.uniform(-4, 0.5));
    const Point middle = near(centre_, 4);
    const std::vector<Point> inner = points_round(middle, size / 10);
    Ball outer = ball_of(inner);
    outer.radius *= 10;
    const std::vector<PlaceIndex> all = rivals(outer);
    std::vector<PlaceIndex> kept;
    nearest_->keep_rivals(ball_of(inner), all, kept);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), kept.begin(), kept.end()));
    for (const Point p : inner) expect_nearest_among(kept, p);
    std::vector<PlaceIndex> backward;
    nearest_->keep_rivals(ball_of(inner), std::vector(all.rbegin(), all.rend()), backward);
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(backward, kept);
  }
}

// Else all places would be right, too.
TEST_P(NearestPlacesBy, law_3_where_one_place_is_clearly_nearest_it_has_no_rival) {
  std::size_t clear = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    const Point p = near(centre_, 3);
    std::vector<double> distances;
    for (const Point place : places_) distances.push_back(distance(place, p));
    std::sort(distances.begin(), distances.end());
    if (distances[1] < 1.001 * distances[0]) continue;
    ++clear;
    const double radius = (distances[1] - distances[0]) / 4;
    EXPECT_EQ(rivals({nearest_->in_space(p), radius}).size(), 1u);
  }
  EXPECT_GT(clear, Seeded::rounds(250));
}

TEST_P(NearestPlacesBy, law_4_in_a_ball_round_all_places_each_of_them_is_a_rival) {
  Ball ball{nearest_->in_space(centre_), 0};
  for (const Point p : places_)
    ball.radius = std::max(ball.radius, length(nearest_->in_space(p) - ball.centre));
  EXPECT_EQ(rivals(ball).size(), places_.size());
}

TEST_P(NearestPlacesBy, law_5_a_lone_place_is_the_only_rival_everywhere) {
  const auto lone = nearest_places(std::vector<Point>{{3, 4}}, GetParam());
  std::vector<PlaceIndex> found;
  lone->find_rivals({lone->in_space({100, -60}), 1e9}, found);
  EXPECT_EQ(found, std::vector<PlaceIndex>{PlaceIndex{0}});
}

INSTANTIATE_TEST_SUITE_P(BothMetrics, NearestPlacesBy,
                         testing::Values(Metric::planar, Metric::geodesic), [](const auto& test) {
                           return test.param == Metric::planar ? "planar" : "geodesic";
                         });

// At 60 degrees a degree of longitude is half as long as one of latitude.
TEST(NearestPlaces, are_by_the_metric_that_is_asked_for) {
  const std::vector<Point> places{{1.5, 60}, {0, 61}};
  const std::vector<PlaceIndex> both{PlaceIndex{0}, PlaceIndex{1}};
  EXPECT_EQ(nearest_places(places, Metric::planar)->nearest({0, 60}, both), both[1]);
  EXPECT_EQ(nearest_places(places, Metric::geodesic)->nearest({0, 60}, both), both[0]);
}

}  // namespace
}  // namespace thiessen
