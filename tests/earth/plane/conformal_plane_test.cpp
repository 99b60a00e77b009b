#include "earth/plane/conformal_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

const std::vector<PlaneParameters> planes = {{ProjectionKind::transverse_mercator, 9, 0, 0.9996},
                                             {ProjectionKind::transverse_mercator, -179.5, 0, 1},
                                             {ProjectionKind::lambert_conformal, -100, 40, 0.995},
                                             {ProjectionKind::lambert_conformal, 20, -33.25, 1},
                                             {ProjectionKind::lambert_conformal, 110, 0, 0.99},
                                             {ProjectionKind::polar_stereographic, 0, 90, 0.994},
                                             {ProjectionKind::polar_stereographic, 150, -90, 1}};

/// Points round the plane's centre, as far as the planes of studies reach.
std::vector<Point> points_of(const PlaneParameters& plane) {
  const double middle = plane.kind == ProjectionKind::transverse_mercator ? 30 : plane.latitude;
  std::vector<Point> points;
  for (double east = -40; east <= 40; east += 8) {
    for (double north = -32; north <= 32; north += 4) {
      const double latitude = middle + north;
      if (std::abs(latitude) <= 90) points.push_back({plane.longitude + east, latitude});
    }
  }
  return points;
}

TEST(ConformalPlane, law_2_the_inverse_leads_back) {
  for (const PlaneParameters& parameters : planes) {
    const ConformalPlane plane(parameters);
    for (const Point p : points_of(parameters))
      EXPECT_LT(geodesic_distance(plane.reverse(plane.forward(p)), p), 1e-8)
          << plane.proj_text() << " at " << p.x << " " << p.y;
  }
}

TEST(ConformalPlane, a_short_way_is_as_long_as_the_scale_says_in_every_direction) {
  for (const PlaneParameters& parameters : planes) {
    const ConformalPlane plane(parameters);
    for (const Point p : points_of(parameters)) {
      if (std::abs(p.y) > 85) continue;
      for (const Point q : {Point{p.x + 1e-4, p.y}, Point{p.x, p.y + 1e-4}}) {
        const Point a = plane.forward(p);
        const Point b = plane.forward(q);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        EXPECT_NEAR(length / geodesic_distance(p, q), plane.scale_at(p), 1e-5)
            << plane.proj_text() << " at " << p.x << " " << p.y;
      }
    }
  }
}

TEST(ConformalPlane, the_centre_has_the_scale_that_is_given) {
  for (const PlaneParameters& parameters : planes) {
    const ConformalPlane plane(parameters);
    EXPECT_NEAR(plane.scale_at({parameters.longitude, parameters.latitude}), parameters.scale,
                1e-12);
  }
}

TEST(ConformalPlane, its_text_is_short) {
  EXPECT_EQ(ConformalPlane(planes[0]).proj_text(),
            "+proj=tmerc +lat_0=0 +lon_0=9 +k_0=0.9996 +x_0=0 +y_0=0 +datum=WGS84 +units=m "
            "+no_defs");
  EXPECT_EQ(ConformalPlane(planes[2]).proj_text(),
            "+proj=lcc +lat_1=40 +lat_0=40 +lon_0=-100 +k_0=0.995 +x_0=0 +y_0=0 +datum=WGS84 "
            "+units=m +no_defs");
  EXPECT_EQ(ConformalPlane(planes[4]).proj_text(),
            "+proj=merc +lon_0=110 +k_0=0.99 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs");
  EXPECT_EQ(ConformalPlane(planes[6]).proj_text(),
            "+proj=stere +lat_0=-90 +lon_0=150 +k_0=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m "
            "+no_defs");
}

}  // namespace
}  // namespace thiessen
