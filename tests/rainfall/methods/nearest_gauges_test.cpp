#include "rainfall/methods/nearest_gauges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

std::vector<PlaceIndex> found(const NearestGauges& nearest, Point p, std::size_t count,
                              const ReportingPlaces& reports,
                              std::vector<NearestGauges::Near>& near) {
  nearest.find(p, count, reports, near);
  std::vector<PlaceIndex> places;
  for (const auto& n : near) places.push_back(n.place);
  return places;
}

/// By looking at all of them.
template <typename Distance>
std::vector<PlaceIndex> sorted(const std::vector<Point>& places, std::size_t count,
                               const ReportingPlaces& reports, const Distance& distance) {
  std::vector<PlaceIndex> all;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (reports[PlaceIndex{i}]) all.push_back(PlaceIndex{i});
  }
  std::sort(all.begin(), all.end(), [&](PlaceIndex a, PlaceIndex b) {
    const Point p = places[index(a)];
    const Point q = places[index(b)];
    return std::pair(distance(p), p) < std::pair(distance(q), q);
  });
  all.resize(std::min(count, all.size()));
  return all;
}

TEST(NearestGauges, are_those_of_a_look_at_all) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(30); ++round) {
    const bool planar = round % 2 == 0;
    std::vector<Point> places;
    for (std::uint64_t i = 1 + seeded.below(120); i > 0; --i) {
      const Point p{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
      places.push_back(round % 4 == 0 ? Point{std::round(p.x / 30), std::round(p.y / 30)} : p);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::shuffle(places.begin(), places.end(), seeded.generator());
    const NearestGauges nearest(places, planar ? Metric::planar : Metric::geodesic);
    std::vector<NearestGauges::Near> near;
    for (int i = 0; i < 40; ++i) {
      Point p{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
      if (i % 2 == 0) p = places[seeded.below(places.size())];
      ReportingPlaces reports(places.size(), true);
      for (std::uint32_t k = 0; k < places.size(); ++k)
        reports.set(PlaceIndex{k}, i < 5 || seeded.below(3) > 0);
      const std::size_t count = 1 + seeded.below(20);
      const auto expected = sorted(places, count, reports, [&](Point q) {
        return planar ? (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y)
                      : geodesic_distance(p, q);
      });
      const auto places_found = found(nearest, p, count, reports, near);
      if (planar) {
        EXPECT_EQ(places_found, expected);
        continue;
      }
      // Chords and geodesics rank alike but for near ties.
      ASSERT_EQ(places_found.size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const double wanted = geodesic_distance(p, places[index(expected[k])]);
        EXPECT_NEAR(geodesic_distance(p, places[index(places_found[k])]), wanted,
                    wanted * std::min(0.007, 1e-4 * std::pow(wanted / 1e6, 2)));
      }
    }
  }
}

TEST(NearestGauges, over_the_antimeridian) {
  const NearestGauges nearest(std::vector<Point>{{179, 0}, {170, 0}}, Metric::geodesic);
  std::vector<NearestGauges::Near> near;
  EXPECT_EQ(found(nearest, {-179, 0}, 1, {}, near), std::vector{PlaceIndex{0}});
  EXPECT_EQ(found(nearest, {181, 0}, 2, {}, near), (std::vector{PlaceIndex{0}, PlaceIndex{1}}));
}

}  // namespace
}  // namespace thiessen
