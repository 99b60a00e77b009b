#include "files/cells_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/complaints.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

CellsOutput output(const std::vector<MultiPolygon>& shapes, const std::optional<Crs>& crs) {
  CellsOutput wanted;
  for (const MultiPolygon& shape : shapes) {
    CellFeature& cell = wanted.cells.emplace_back();
    cell.station = "A-1";
    cell.shape = shape;
  }
  wanted.study_crs = crs;
  return wanted;
}

Crs crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

const MultiPolygon west = {{{{14, 50}, {15, 50}, {15, 51}, {14, 51}}, {}}};
const MultiPolygon east = {{{{15, 50}, {16, 50}, {16, 51}, {15, 51}}, {}}};
const MultiPolygon over = {{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}};

TEST(CellsShapes, stay_bit_for_bit_where_there_is_nothing_to_change) {
  const MultiPolygon odd = {{{{0.1, 1.0 / 3}, {1e9, 0.2}, {0.3, 7}}, {}}};
  for (const std::optional<Crs>& known :
       {std::optional<Crs>(), std::optional<Crs>(crs("EPSG:32633"))}) {
    EXPECT_EQ(cells_shapes(output({odd}, known), known).at(0).at(0).outer, odd[0].outer);
  }
  EXPECT_EQ(cells_shapes(output({west, east}, Crs::wgs84()), Crs::wgs84()).at(1).at(0).outer,
            east[0].outer);
}

TEST(CellsShapes, in_degrees_are_cut_at_the_antimeridian) {
  const auto shapes = cells_shapes(output({over}, Crs::wgs84()), Crs::wgs84());
  ASSERT_EQ(shapes.at(0).size(), 2U);
  for (const Polygon& part : shapes[0]) {
    EXPECT_EQ(signed_area(part.outer), 100);
    for (const Point point : part.outer) EXPECT_LE(std::abs(point.x), 180);
  }
  EXPECT_EQ(cells_shapes(output({over}, std::nullopt), std::nullopt).at(0).size(), 1U);
}

TEST(CellsShapes, law_1_neighbours_share_their_edge_vertex_for_vertex_in_another_crs) {
  const auto shapes = cells_shapes(output({west, east}, Crs::wgs84()), crs("EPSG:3035"));
  Ring a = shapes.at(0).at(0).outer;
  Ring b = shapes.at(1).at(0).outer;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  Ring shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  EXPECT_GT(shared.size(), 5U) << "the meridian of 15 degrees bends in this projection";
  EXPECT_GT(signed_area(shapes[0][0].outer), 0);
}

TEST(CellsShapes, a_finer_tolerance_takes_more_vertices) {
  const auto vertices = [&](double tolerance) {
    CellsOutput wanted = output({west}, Crs::wgs84());
    wanted.tolerance = tolerance;
    return cells_shapes(wanted, crs("EPSG:3035")).at(0).at(0).outer.size();
  };
  EXPECT_GT(vertices(0.01), 2 * vertices(1));
  EXPECT_GT(vertices(1), vertices(1e5));
}

TEST(CellsShapes, a_cell_that_the_crs_cannot_hold_is_named_with_it) {
  EXPECT_EQ(complaint_of([] { cells_shapes(output({over}, Crs::wgs84()), crs("EPSG:32633")); }),
            "the cell of station 'A-1' reaches outside the area of EPSG:32633 | cells in longitude "
            "and latitude (.geojson) reach anywhere");
  const MultiPolygon far = {{{{9e7, 0}, {9.1e7, 0}, {9.1e7, 1e6}}, {}}};
  EXPECT_EQ(complaint_of([&] { cells_shapes(output({far}, crs("EPSG:32633")), Crs::wgs84()); }),
            "the cell of station 'A-1' reaches outside the area of EPSG:32633");
}

}  // namespace
}  // namespace thiessen
