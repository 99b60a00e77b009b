// Linked with OpenCV: a view is of a picture, which knows its formats.
#include "map/sheet/study_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/complaints.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

using Kind = MapProjection::Kind;

MultiPolygon box(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

Picture plane_of(const MultiPolygon& shape) {
  Picture picture;
  picture.cells.push_back({shape, 0});
  return picture;
}

Picture earth_of(const MultiPolygon& shape) {
  Picture picture = plane_of(shape);
  picture.geographic = true;
  return picture;
}

TEST(StudyView, of_a_plane_counts_from_the_middle_of_its_shapes) {
  Picture picture = plane_of(box(100, 50, 104, 56));
  picture.metres_per_unit = 0.3048;
  picture.gauges = {{{101, 51}, "g"}};
  const StudyView view = view_study(picture);
  EXPECT_EQ(view.projection.kind(), Kind::plane);
  EXPECT_EQ(view.projection.metres_per_unit(), 0.3048);
  EXPECT_EQ(view.radius, 0);
  EXPECT_EQ(view.gauges.at(0), (Point{-1, -2}));
  EXPECT_EQ(view.cells.at(0).at(0).rings.at(0).at(0), (Point{-2, -3}));
  EXPECT_EQ(view.extent.width(), 4);
  EXPECT_EQ(view.extent.height(), 6);
}

TEST(StudyView, holds_gauges_that_own_a_cell_and_lie_not_far_outside) {
  Picture picture = plane_of(box(0, 0, 8, 4));
  picture.gauges = {{{9.5, 2}, "owner"}, {{-1, 2}, "without a cell"}};
  EXPECT_EQ(view_study(picture).extent.east, 5.5) << "within a quarter of the longer side";
  EXPECT_EQ(view_study(picture).extent.west, -4);
  picture.gauges[0].position.x = 10.1;
  EXPECT_EQ(view_study(picture).extent.east, 4);
}

TEST(StudyView, without_shapes_holds_the_gauges_and_is_never_without_width_and_height) {
  Picture picture;
  picture.gauges = {{{3, 1}, "a"}, {{5, 1}, "b"}};
  EXPECT_EQ(view_study(picture).extent.width(), 2);
  picture.gauges.pop_back();
  for (const bool geographic : {false, true}) {
    picture.geographic = geographic;
    const Extent extent = view_study(picture).extent;
    EXPECT_GT(extent.width(), 0);
    EXPECT_GT(extent.height(), 0);
  }
}

TEST(StudyView, of_less_than_a_hemisphere_is_stereographic_about_its_middle) {
  const StudyView view = view_study(earth_of(box(170, 10, 190, 20)));
  EXPECT_EQ(view.projection.kind(), Kind::stereographic);
  EXPECT_NEAR(view.projection.centre().x, 180, 1e-9);
  EXPECT_NEAR(view.projection.centre().y, 15, 1e-9);
  // The corner that is nearer to the equator is farther off: the sphere's law of cosines.
  const double degree = std::numbers::pi / 180;
  const double far =
      std::acos(std::sin(15 * degree) * std::sin(10 * degree) +
                std::cos(15 * degree) * std::cos(10 * degree) * std::cos(10 * degree));
  EXPECT_NEAR(view.radius, far, 1e-9);
}

TEST(StudyView, both_sides_of_the_antimeridian_lie_side_by_side) {
  Picture picture = earth_of(box(170, 10, 180, 20));
  picture.cells.push_back({box(-180, 10, -170, 20), 0});
  picture.gauges = {{{-175, 15}, "east"}};
  const StudyView view = view_study(picture);
  EXPECT_NEAR(view.projection.centre().x, 180, 1e-9);
  EXPECT_GT(view.gauges.at(0).x, 0);
  EXPECT_LT(view.extent.width(), 0.4) << "20 degrees are 0.35 radians";
}

TEST(StudyView, round_a_pole_has_the_pole_in_its_middle) {
  for (const double sign : {1.0, -1.0}) {
    MultiPolygon cap(1);
    for (int longitude = -180; longitude < 180; longitude += 30)
      cap[0].outer.push_back({1.0 * longitude, sign * 60});
    const StudyView view = view_study(earth_of(cap));
    EXPECT_EQ(view.projection.kind(), Kind::stereographic);
    EXPECT_EQ(view.projection.centre(), (Point{0, sign * 90}));
    EXPECT_NEAR(view.radius, 30 * std::numbers::pi / 180, 1e-12);
  }
}

TEST(StudyView, of_more_than_a_hemisphere_is_plate_carree_over_its_whole_window) {
  const StudyView view = view_study(earth_of(box(-180, -90, 180, 90)));
  EXPECT_EQ(view.projection.kind(), Kind::plate_carree);
  EXPECT_NEAR(view.extent.width(), view.projection.period(), 1e-12);
  EXPECT_NEAR(view.extent.height(), std::numbers::pi, 1e-12);
}

TEST(StudyView, refuses_what_cannot_be_drawn) {
  const double infinity = HUGE_VAL;
  EXPECT_EQ(complaint_of([&] { view_study(plane_of(box(0, 0, infinity, 1))); }),
            "a coordinate to draw is not finite");
  EXPECT_EQ(complaint_of([] { view_study(plane_of(box(0, 0, 2e150, 1))); }),
            "the study area reaches too far to be drawn");
  Picture picture;
  picture.gauges = {{{std::nan(""), 0}, "a"}};
  EXPECT_EQ(complaint_of([&] { view_study(picture); }), "a coordinate to draw is not finite");
}

// Half a study projected alone would have another centre.
TEST(StudyView, of_another_map_has_the_same_projection_and_an_extent_of_its_own) {
  Picture whole = row_of_cells({1, 2, 3, 4});
  whole.geographic = true;
  const StudyView first = view_study(whole);
  Picture half = row_of_cells({1, 2});
  half.geographic = true;
  const StudyView view = view_study(half, first);
  EXPECT_EQ(view.projection.centre(), first.projection.centre());
  EXPECT_EQ(view.gauges[0], first.gauges[0]);
  EXPECT_LT(view.extent.east, first.extent.east);
  EXPECT_EQ(view.extent.west, first.extent.west);
}

}  // namespace
}  // namespace thiessen
