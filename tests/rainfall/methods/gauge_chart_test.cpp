#include "rainfall/methods/gauge_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(GaugeChart, of_a_plane_is_the_plane) {
  const GaugeChart chart(std::vector<Point>{{1, 2}}, Metric::planar);
  EXPECT_EQ(chart.kind(), ChartKind::plane);
  EXPECT_EQ(chart.at({7, -1e-200}).at, (Point{7, 0}));
  EXPECT_EQ(chart.found_at({7, -1e-200}).at, (Point{7, 0}));
}

ChartKind kind_of(const std::vector<Point>& places) {
  return GaugeChart(places, Metric::geodesic).kind();
}

// Three on the equator and a pole leave the other hemisphere free up to its edge; one beyond it
// closes the triangles round the Earth.
TEST(GaugeChart, is_of_the_whole_earth_where_no_hemisphere_is_without_a_gauge) {
  EXPECT_EQ(kind_of({{0, 1}, {120, 1}, {-120, 1}, {0, 90}}), ChartKind::part_of_earth);
  EXPECT_EQ(kind_of({{0, -1}, {120, -1}, {-120, -1}, {0, 90}}), ChartKind::whole_earth);
  EXPECT_EQ(kind_of({{0, 1}, {120, 1}, {-120, 1}, {0, 90}, {40, -80}}), ChartKind::whole_earth);
  EXPECT_EQ(kind_of({{0, 0}, {120, 0}, {-120, 0}}), ChartKind::part_of_earth) << "a ring";
  EXPECT_EQ(kind_of({{5, 5}}), ChartKind::part_of_earth);
  EXPECT_EQ(kind_of({{5, 5}, {-175, -5}}), ChartKind::part_of_earth);
}

TEST(GaugeChart, of_the_whole_earth_has_its_first_gauge_at_infinity) {
  const std::vector<Point> places{{120, -1}, {0, 90}, {-120, -1}, {0, -1}};
  const GaugeChart chart(places, Metric::geodesic);
  EXPECT_FALSE(in_exact_range(chart.at({-120, -1}).at));
  for (const Point p : {Point{120, -1}, {0, 90}, {0, -1}, {-120, -1.0000001}})
    EXPECT_TRUE(in_exact_range(chart.at(p).at));
}

TEST(GaugeChart, finds_a_point_again) {
  Seeded seeded;
  const GaugeChart chart(std::vector<Point>{{12, 47}, {14, 47}, {13, 49}}, Metric::geodesic);
  for (int i = 0; i < 100; ++i) {
    const ChartPoint point = chart.at({seeded.uniform(-60, 80), seeded.uniform(-30, 85)});
    const ChartPoint again = chart.found_at(point.at);
    EXPECT_EQ(again.at, point.at);
    EXPECT_NEAR(length(again.direction - point.direction), 0, 1e-14);
    EXPECT_NEAR(length(again.direction), 1, 1e-14);
  }
}

// What lies in the smallest circle round them: the middle of a small network is the chart's middle.
TEST(GaugeChart, has_a_small_network_in_its_middle) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(50); ++round) {
    const Point middle{seeded.uniform(-180, 180), seeded.uniform(-80, 80)};
    std::vector<Point> places;
    for (std::uint64_t i = 1 + seeded.below(30); i > 0; --i) {
      places.push_back({middle.x + seeded.uniform(-5, 5), middle.y + seeded.uniform(-5, 5)});
    }
    const GaugeChart chart(places, Metric::geodesic);
    double farthest = 0;
    for (const Point p : places) {
      const Point at = chart.at(p).at;
      farthest = std::max(farthest, std::hypot(at.x, at.y));
    }
    // A radian is a quarter in the chart's middle.
    EXPECT_LT(farthest, 0.25 * 10 * M_PI / 180 * 1.2);
    // Two at least are that far, unless there is one.
    const auto at_rim = std::count_if(places.begin(), places.end(), [&](Point p) {
      const Point at = chart.at(p).at;
      return std::hypot(at.x, at.y) > farthest * (1 - 1e-9) - 1e-15;
    });
    EXPECT_GE(at_rim, std::min<std::ptrdiff_t>(2, std::ssize(places)));
  }
}

TEST(GaugeChart, does_not_depend_on_the_order_of_places) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    std::vector<Point> places;
    for (std::uint64_t i = 1 + seeded.below(40); i > 0; --i) {
      const Point p{seeded.uniform(-179, 180), seeded.uniform(-89, 89)};
      places.push_back(
          round % 2 == 0 ? p : Point{std::round(p.x / 20) * 20, std::round(p.y / 20) * 20});
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::erase_if(places, [](Point p) { return p.x == -180; });
    if (places.empty()) continue;
    const Point before = GaugeChart(places, Metric::geodesic).at({12, 34}).at;
    std::shuffle(places.begin(), places.end(), seeded.generator());
    EXPECT_EQ(GaugeChart(places, Metric::geodesic).at({12, 34}).at, before);
  }
}

TEST(GaugeChart, leaves_out_one_point) {
  const GaugeChart chart(std::vector<Point>{{0, 90}}, Metric::geodesic);
  EXPECT_FALSE(in_exact_range(chart.at({0, -90}).at));
  EXPECT_TRUE(in_exact_range(chart.at({0, -89}).at));
}

}  // namespace
}  // namespace thiessen
