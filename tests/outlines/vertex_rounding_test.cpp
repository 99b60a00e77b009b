#include "outlines/vertex_rounding.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

std::string written(const VertexRounding& rounding, const Ring& ring) {
  std::string text;
  rounding.append(text, ring);
  return text;
}

MultiPolygon shape(Ring ring) {
  return {{std::move(ring), {}}};
}

TEST(VertexRounding, closes_the_ring_and_leaves_out_trailing_zeros) {
  const Ring ring = {{0.5, 0}, {1.25, 0}, {1.25, 1.123456789}};
  const std::vector<MultiPolygon> cells = {shape(ring)};
  EXPECT_EQ(written(VertexRounding(cells, 7), ring), "[[0.5,0],[1.25,0],[1.25,1.1234568],[0.5,0]]");
}

TEST(VertexRounding, without_decimals_every_digit_is_written) {
  const Ring ring = {{0.1, 0}, {1, 0}, {1, 1.0 / 3}};
  EXPECT_EQ(written(VertexRounding(), ring), "[[0.1,0],[1,0],[1,0.3333333333333333],[0.1,0]]");
}

TEST(VertexRounding, neighbours_that_fall_together_stand_once) {
  const Ring ring = {{0, 0}, {4, 0}, {4, 4}, {4.001, 4.001}, {0, 4}};
  const std::vector<MultiPolygon> cells = {shape(ring)};
  EXPECT_EQ(written(VertexRounding(cells, 1), ring), "[[0,0],[4,0],[4,4],[0,4],[0,0]]");
}

TEST(VertexRounding, a_cell_that_would_collapse_gets_more_decimals) {
  const Ring thin = {{0, 0}, {1, 0}, {1, 0.0004}};
  const std::vector<MultiPolygon> cells = {shape(thin)};
  EXPECT_EQ(written(VertexRounding(cells, 1), thin), "[[0,0],[1,0],[1,0.0004],[0,0]]");
}

TEST(VertexRounding, a_cell_that_would_turn_over_gets_more_decimals) {
  // Rounded to one decimal the third vertex would lie on the other side of the first edge.
  const Ring ring = {{0, 0.04}, {1, 0.06}, {0.25, 0.0451}};
  const std::vector<MultiPolygon> cells = {shape(ring)};
  EXPECT_EQ(written(VertexRounding(cells, 1), ring), "[[0,0.04],[1,0.06],[0.25,0.05],[0,0.04]]");
}

TEST(VertexRounding, neighbours_of_a_fine_cell_write_the_shared_vertices_alike) {
  const Ring thin = {{0, 0}, {1, 0.00001}, {1, 0.0004}};
  const Ring wide = {{0, 0}, {1, 0.0004}, {1, 2}};
  const std::vector<MultiPolygon> cells = {shape(thin), shape(wide)};
  const VertexRounding rounding(cells, 1);
  EXPECT_NE(written(rounding, wide).find("[1,0.0004]"), std::string::npos);
  EXPECT_NE(written(rounding, thin).find("[1,0.0004]"), std::string::npos);
  EXPECT_NE(written(rounding, wide).find("[1,2]"), std::string::npos);
}

TEST(VertexRounding, decimals_follow_the_tolerance) {
  EXPECT_EQ(decimals_for(0.1), 7);
  EXPECT_EQ(decimals_for(0.01), 8);
  EXPECT_EQ(decimals_for(1), 6);
  EXPECT_EQ(decimals_for(1e9), 1);
  EXPECT_EQ(decimals_for(1e-30), 15);
}

}  // namespace
}  // namespace thiessen
