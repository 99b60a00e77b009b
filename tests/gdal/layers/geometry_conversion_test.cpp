#include "gdal/layers/geometry_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "gdal/drivers.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

std::unique_ptr<OGRGeometry> geometry(const char* wkt) {
  OGRGeometry* made = nullptr;
  EXPECT_EQ(OGRGeometryFactory::createFromWkt(wkt, nullptr, &made), OGRERR_NONE) << wkt;
  return std::unique_ptr<OGRGeometry>(made);
}

GeometryRecord record(const char* wkt) {
  return record_of(geometry(wkt).get());
}

const MultiPolygon two_parts = {{{{0, 0}, {4, 0}, {4, 4}}, {{{3, 1}, {3, 2}, {2, 1}}}},
                                {{{9, 9}, {10, 9}, {10, 10}}, {}}};

TEST(GeometryRecord, of_none_is_empty) {
  EXPECT_EQ(record_of(nullptr).type, "");
}

TEST(GeometryRecord, has_the_points_of_one_and_of_several) {
  EXPECT_EQ(record("POINT (1 2)").points, (std::vector<Point>{{1, 2}}));
  const GeometryRecord several = record("MULTIPOINT ((1 2),(3 4))");
  EXPECT_EQ(several.type, "MultiPoint");
  EXPECT_EQ(several.points, (std::vector<Point>{{1, 2}, {3, 4}}));
}

TEST(GeometryRecord, keeps_rings_as_they_are_written) {
  const GeometryRecord clockwise = record("POLYGON ((0 0,4 4,4 0,0 0))");
  EXPECT_EQ(clockwise.polygons.at(0).outer, (Ring{{0, 0}, {4, 4}, {4, 0}, {0, 0}}));
  const GeometryRecord several = record("MULTIPOLYGON (((0 0,1 0,1 1,0 0)),((5 5,6 5,6 6,5 5)))");
  EXPECT_EQ(several.type, "MultiPolygon");
  ASSERT_EQ(several.polygons.size(), 2U);
  EXPECT_EQ(several.polygons[1].outer.front(), (Point{5, 5}));
}

TEST(GeometryRecord, of_other_kinds_has_the_kind_alone) {
  for (const auto& [wkt, type] :
       {std::pair("LINESTRING (0 0,1 1)", "LineString"),
        std::pair("GEOMETRYCOLLECTION (POINT (1 2))", "GeometryCollection"),
        std::pair("MULTIPOLYGON EMPTY", "MultiPolygon")}) {
    const GeometryRecord other = record(wkt);
    EXPECT_EQ(other.type, type);
    EXPECT_TRUE(other.points.empty() && other.polygons.empty());
  }
}

// A circle of radius 2 by its arcs, drawn in steps of a tenth of a degree: what the chords cut off
// is 1 - sin(s) / s of it, s = 2 pi / 3600, which is 5.1e-7.
TEST(GeometryRecord, curves_become_straight_lines_that_are_close_to_them) {
  start_gdal();
  const GeometryRecord circle = record("CURVEPOLYGON (CIRCULARSTRING (2 0,-2 0,2 0))");
  EXPECT_EQ(circle.type, "Polygon");
  ASSERT_EQ(circle.polygons.size(), 1U);
  const double share = std::abs(signed_area(circle.polygons[0].outer)) / (4 * std::numbers::pi);
  EXPECT_NEAR(1 - share, 5.08e-7, 2e-8);
}

TEST(OgrShape, has_closed_rings) {
  const auto shape = ogr_shape(two_parts);
  ASSERT_EQ(shape->getNumGeometries(), 2);
  const OGRLinearRing* outer = shape->getGeometryRef(0)->getExteriorRing();
  EXPECT_EQ(outer->getNumPoints(), 4);
  EXPECT_EQ(outer->getX(3), 0);
  EXPECT_EQ(shape->getGeometryRef(0)->getNumInteriorRings(), 1);
}

TEST(PolygonsOf, law_1_come_back_from_gdal_as_they_went) {
  const MultiPolygon back = polygons_of(*ogr_shape(two_parts));
  ASSERT_EQ(back.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back[i].outer, two_parts[i].outer);
    EXPECT_EQ(back[i].holes, two_parts[i].holes);
  }
}

TEST(PolygonsOf, gathers_polygons_however_deep_they_lie) {
  const auto deep = geometry(
      "GEOMETRYCOLLECTION (POINT (1 2),POLYGON EMPTY,POLYGON ((0 0,1 0,1 1,0 0)),"
      "GEOMETRYCOLLECTION (MULTIPOLYGON (((5 5,6 5,6 6,5 5)),((7 7,8 7,8 8,7 7)))))");
  const MultiPolygon found = polygons_of(*deep);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].outer, (Ring{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(found[2].outer.front(), (Point{7, 7}));
  EXPECT_TRUE(polygons_of(*geometry("LINESTRING (0 0,1 1)")).empty());
}

}  // namespace
}  // namespace thiessen
