#include "map/sheet/projection.h"

#include <gtest/gtest.h>

#include <vector>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "map/sheet/longitude_window.h"

namespace thiessen {
namespace {

constexpr double radian = std::numbers::pi / 180;

/// Metres to a degree of latitude and of longitude on WGS 84, from its radii of curvature.
struct DegreeLengths {
  double north;
  double east;
};

DegreeLengths degree_lengths(double latitude) {
  const double a = 6378137;
  const double square = (2 - 1 / 298.257223563) / 298.257223563;
  const double sine = std::sin(latitude * radian);
  const double w = 1 - square * sine * sine;
  return {a * (1 - square) / (w * std::sqrt(w)) * radian,
          a * std::cos(latitude * radian) / std::sqrt(w) * radian};
}

TEST(Projection, stereographic_is_conformal_and_true_at_its_centre) {
  for (const double centre : {-80.0, -33.0, 0.0, 39.0, 60.0, 89.0}) {
    const MapProjection project = MapProjection::stereographic({20, centre});
    for (const double dy : {0.0, 7.0, -15.0, 30.0}) {
      for (const double dx : {0.0, 12.0, -40.0}) {
        const Point p{20 + dx, std::clamp(centre + dy, -88.0, 88.0)};
        const double h = 1e-4;
        const Point north0 = project({p.x, p.y - h});
        const Point north1 = project({p.x, p.y + h});
        const Point east0 = project({p.x - h, p.y});
        const Point east1 = project({p.x + h, p.y});
        const DegreeLengths degree = degree_lengths(p.y);
        const double north = std::hypot(north1.x - north0.x, north1.y - north0.y) / degree.north;
        const double east = std::hypot(east1.x - east0.x, east1.y - east0.y) / degree.east;
        EXPECT_NEAR(north / east, 1, 1e-6);
        const double turn = (north1.x - north0.x) * (east1.x - east0.x) +
                            (north1.y - north0.y) * (east1.y - east0.y);
        EXPECT_NEAR(turn, 0, 1e-6 * h * h);
        if (dx == 0 && p.y == centre) {
          EXPECT_NEAR(north / (2 * h) * project.metres_per_unit(), 1, 1e-6);
          EXPECT_NEAR(north1.x, 0, 1e-12) << "north is up";
        }
      }
    }
  }
}

TEST(Projection, stereographic_at_a_pole_is_round) {
  const MapProjection project = MapProjection::stereographic({0, 90});
  for (int lon = -180; lon < 180; lon += 30) {
    const Point p = project({1.0 * lon, 60});
    const Point q = project({0, 60});
    EXPECT_NEAR(std::hypot(p.x, p.y), std::hypot(q.x, q.y), 1e-12);
  }
}

TEST(Projection, plate_carree_is_true_along_its_latitude) {
  const MapProjection project = MapProjection::plate_carree({}, 60);
  EXPECT_NEAR(project({10, 60}).x - project({0, 60}).x, 10 * radian * 0.5, 1e-15);
  EXPECT_NEAR(project.period(), std::numbers::pi, 1e-15);
}

TEST(Projection, law_inverse_takes_back_what_was_projected) {
  const std::vector<MapProjection> projections{
      MapProjection::plane({5e5, 4e6}, 1), MapProjection::stereographic({-105.5, 39}),
      MapProjection::stereographic({10, -60}), MapProjection::stereographic({0, 90}),
      MapProjection::plate_carree({-180, 360}, 20)};
  for (const MapProjection& projection : projections) {
    for (const double dx : {-7.0, 0.0, 0.5, 20.0}) {
      for (const double dy : {-12.0, -0.25, 0.0}) {
        const Point study{projection.centre().x + dx, projection.centre().y + dy};
        const Point back = projection.inverse(projection(study));
        EXPECT_NEAR(back.y, study.y, 1e-9);
        EXPECT_NEAR(std::remainder(back.x - study.x, 360) *
                        std::cos(std::min(std::abs(study.y), 90.0) * 3.14159265358979 / 180),
                    0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
