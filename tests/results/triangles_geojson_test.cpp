#include "results/triangles_geojson.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

TEST(TrianglesGeoJson, has_the_stations_of_the_corners) {
  TriangleFeatures features;
  features.triangles.push_back({{"1", "b\"", "c"}, {{{{0, 0}, {4, 0}, {0, 3}}, {}}}});
  features.triangles.push_back({{"d", "e", "f"}, {}});
  const std::vector<MultiPolygon> shapes{features.triangles[0].shape, {}};
  EXPECT_EQ(triangles_geojson(features, shapes, VertexRounding()),
            "{\"type\":\"FeatureCollection\",\"features\":[\n"
            "{\"type\":\"Feature\",\"properties\":{\"a\":\"1\",\"b\":\"b\\\"\",\"c\":\"c\"},"
            "\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[0,3],[0,0]]]}},\n"
            "{\"type\":\"Feature\",\"properties\":{\"a\":\"d\",\"b\":\"e\",\"c\":\"f\"},"
            "\"geometry\":null}\n]}\n");
}

}  // namespace
}  // namespace thiessen
