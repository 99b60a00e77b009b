#include "files/basin_centroids.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

StudyFiles square_at(double x, double y, double size) {
  StudyFiles study;
  study.basins = {{"A", {{{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}, {}}}, {}}};
  return study;
}

TEST(BasinCentroids, of_degrees_are_those_of_the_sphere) {
  StudyFiles study = square_at(10, -1, 2);
  study.metric = Metric::geodesic;
  const auto found = centroids_on_earth(study);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at(0).x, 11, 1e-12);
  EXPECT_NEAR(found->at(0).y, 0, 1e-12);
}

TEST(BasinCentroids, of_a_plane_are_brought_to_the_earth_by_its_crs) {
  StudyFiles study = square_at(499'999, 4'999'999, 2);
  study.crs = Crs::from_text("EPSG:32633", setting("crs"));
  const auto found = centroids_on_earth(study);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at(0).x, 15, 1e-9) << "the central meridian of the zone";
  EXPECT_NEAR(found->at(0).y, 45.1535, 1e-4);
  EXPECT_EQ(centroids_in_plane(study), (std::vector<Point>{{500'000, 5'000'000}}));
}

TEST(BasinCentroids, of_a_plane_of_its_own_are_not_on_the_earth) {
  EXPECT_FALSE(centroids_on_earth(square_at(0, 0, 2)));
}

}  // namespace
}  // namespace thiessen
