#include "outlines/geos.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring hole{{1, 1}, {1, 2}, {2, 2}, {2, 1}};

double area_of(const Geos& geos, const Geos::Shape& shape) {
  double area = -1;
  EXPECT_EQ(GEOSArea_r(geos.context(), shape.get(), &area), 1);
  return area;
}

double length_of(const Geos& geos, const Geos::Shape& shape) {
  double length = -1;
  EXPECT_EQ(GEOSLength_r(geos.context(), shape.get(), &length), 1);
  return length;
}

Geos::Shape read(const Geos& geos, const char* wkt) {
  GEOSWKTReader* const reader = GEOSWKTReader_create_r(geos.context());
  Geos::Shape shape = geos.own(GEOSWKTReader_read_r(geos.context(), reader, wkt));
  GEOSWKTReader_destroy_r(geos.context(), reader);
  return shape;
}

TEST(Geos, has_shapes_with_their_holes_and_rings_closed) {
  const Geos geos;
  const Geos::Shape shape = geos.shape_of({{square, {hole}}, {{{9, 9}, {11, 9}, {9, 11}}, {}}});
  ASSERT_TRUE(shape);
  EXPECT_EQ(area_of(geos, shape), 16 - 1 + 2);
  EXPECT_EQ(geos.text(), "");
  Ring closed = square;
  closed.push_back(square.front());
  const Geos::Shape same = geos.shape_of({{closed, {}}});
  EXPECT_EQ(GEOSGetNumCoordinates_r(geos.context(), same.get()), 5) << "it is not closed twice";
}

TEST(Geos, law_1_gives_shapes_back_bit_for_bit) {
  const Geos geos;
  const MultiPolygon shapes{{{{0.1, 1e-300}, {1.0 / 3, 0}, {7, 1e300}}, {}},
                            {square, {hole, hole}}};
  const MultiPolygon back = geos.polygons_of(geos.shape_of(shapes).get());
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].outer, shapes[0].outer);
  EXPECT_TRUE(back[0].holes.empty());
  EXPECT_EQ(back[1].outer, square);
  EXPECT_EQ(back[1].holes, (std::vector<Ring>{hole, hole}));
}

TEST(Geos, has_no_shape_of_a_ring_of_one_point_and_says_why) {
  const Ring point{{1, 1}};
  const Geos geos;
  EXPECT_FALSE(geos.shape_of({{square, {}}, {point, {}}}));
  EXPECT_NE(geos.text(), "");
  const Geos other;
  EXPECT_FALSE(other.shape_of({{square, {point}}})) << "nor of a hole of one";
  EXPECT_NE(other.text(), "");
}

TEST(Geos, keeps_the_first_message_alone_on_one_line) {
  const Geos geos;
  geos.shape_of({{{{1, 1}}, {}}});
  const std::string first = geos.text();
  EXPECT_EQ(first.find('\n'), std::string::npos);
  EXPECT_FALSE(first.ends_with('.') || first.ends_with(' ')) << first;
  EXPECT_FALSE(read(geos, "POLYGON ((nonsense"));
  EXPECT_EQ(geos.text(), first);
}

TEST(Geos, law_2_lines_are_as_long_as_the_rings_whatever_they_cross) {
  const Geos geos;
  const std::vector<Ring> bow_tie{{{0, 0}, {3, 4}, {3, 0}, {0, 4}}};
  EXPECT_EQ(length_of(geos, geos.lines_of(bow_tie)), 5 + 4 + 5 + 4);
  const std::vector<Ring> needle{{{0, 0}, {3, 4}}};
  EXPECT_EQ(length_of(geos, geos.lines_of(needle)), 10) << "there and back";
  const std::vector<Ring> both{square, hole, Ring{{7, 7}}, Ring{}};
  EXPECT_EQ(length_of(geos, geos.lines_of(both)), 16 + 4) << "a point has no line";
}

TEST(Geos, law_3_polygons_of_anything_are_those_within_it) {
  const Geos geos;
  const auto count = [&](const char* wkt) {
    return geos.polygons_of(read(geos, wkt).get()).size();
  };
  EXPECT_EQ(count("POINT (1 1)"), 0U);
  EXPECT_EQ(count("POLYGON EMPTY"), 0U);
  EXPECT_EQ(count("POLYGON ((0 0,1 0,1 1,0 0))"), 1U);
  EXPECT_EQ(count("GEOMETRYCOLLECTION (LINESTRING (0 0,1 1),POLYGON ((0 0,1 0,1 1,0 0)),"
                  "GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0,1 0,1 1,0 0)),((5 5,6 5,6 6,5 5)))))"),
            3U);
  EXPECT_TRUE(geos.polygons_of(nullptr).empty());
  EXPECT_TRUE(geos.polygons_of(geos.shape_of({}).get()).empty());
}

}  // namespace
}  // namespace thiessen
