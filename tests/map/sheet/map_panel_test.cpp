// Linked with OpenCV: the colours of cells are the legend's.
#include "map/sheet/map_panel.h"

#include <gtest/gtest.h>

#include "map/ink/ink.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

constexpr std::int32_t nobody = OwnerRaster::nobody;

MapShape box(double west, double north, double east, double south) {
  const Ring ring = {{west, north}, {east, north}, {east, south}, {west, south}};
  Ring line = ring;
  line.push_back(ring.front());
  const MapPart part = {{ring}, {line}};
  return {part};
}

/// A panel of 6 by 4 pixels: a basin over columns 1 to 4, cells over columns 1 and 2 of it, and 3.
struct Panel {
  Panel() {
    view.basins = {box(1, 0, 5, 4)};
    view.cells = {box(1, 0, 3, 4), box(3, 0, 4, 4)};
  }
  OwnerRaster basins() const { return basin_raster(view, {0, 0, 6, 4}); }
  OwnerRaster cells(const PixelBox& sight = {0, 0, 6, 4}) const {
    return cell_raster(view, basins(), sight);
  }
  StudyView view;
};

std::vector<std::int32_t> row(const OwnerRaster& raster, int y) {
  std::vector<std::int32_t> owners;
  for (int x = 0; x < raster.width(); ++x) owners.push_back(raster.at(x, y));
  return owners;
}

Colour at(Canvas& canvas, int x, int y) {
  const auto first = 3 * static_cast<std::size_t>(y * canvas.width() + x);
  return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
}

TEST(MapPanel, pixels_belong_to_the_cell_or_else_the_basin_that_holds_their_centre) {
  const Panel panel;
  EXPECT_EQ(row(panel.basins(), 2), (std::vector<std::int32_t>{nobody, 0, 0, 0, 0, nobody}));
  EXPECT_EQ(row(panel.cells(), 2),
            (std::vector<std::int32_t>{nobody, 0, 0, 1, basin_without_cell, nobody}));
}

TEST(MapPanel, what_is_out_of_sight_belongs_to_nobody) {
  const OwnerRaster cells = Panel().cells({2, 1, 2, 2});
  EXPECT_EQ(row(cells, 0), std::vector<std::int32_t>(6, nobody));
  EXPECT_EQ(row(cells, 2), (std::vector<std::int32_t>{nobody, nobody, 0, 1, nobody, nobody}));
  EXPECT_EQ(row(cells, 3), std::vector<std::int32_t>(6, nobody));
}

TEST(MapPanel, all_of_the_panel_is_in_sight_but_of_the_whole_earth) {
  const PixelBox panel = {7, 9, 400, 300};
  StudyView view;
  view.extent = {-1, -1, 1, 1};
  const PanelTransform plane(view.extent, panel);
  EXPECT_EQ(sight_box(view, plane, panel).width, 400);
  EXPECT_EQ(sight_box(view, plane, panel).x, 0);
  view.projection = MapProjection::plate_carree({}, 0);
  view.extent = {-3, -1.5, 3, 1.5};
  const PixelBox sight = sight_box(view, PanelTransform(view.extent, panel), panel);
  EXPECT_EQ(sight.x, 16) << "4 % of the width";
  EXPECT_EQ(sight.width, 368);
  EXPECT_EQ(sight.height, 184);
  EXPECT_EQ(sight.y, 58);
}

TEST(MapPanel, counts_the_pixels_of_all_cells_of_a_gauge) {
  Picture picture;
  picture.cells = {{{}, 2}, {{}, 0}};
  picture.gauges.resize(2);
  EXPECT_EQ(pixels_of_gauges(picture, Panel().cells()), (std::vector<std::size_t>{4, 0, 8}));
  picture.cells[1].gauge = 2;
  EXPECT_EQ(pixels_of_gauges(picture, Panel().cells()), (std::vector<std::size_t>{0, 0, 12}));
}

TEST(MapPanel, shapes_and_gauges_are_taken_to_pixels) {
  Panel panel;
  panel.view.gauges = {{3, 2}};
  to_pixels(panel.view, PanelTransform({1, 0, 5, 4}, {0, 0, 400, 400}));  // 92 pixels a unit
  EXPECT_EQ(panel.view.gauges[0], (Point{200, 200}));
  EXPECT_NEAR(panel.view.basins[0][0].rings[0][0].x, 16, 1e-9);
  EXPECT_NEAR(panel.view.basins[0][0].rings[0][0].y, 384, 1e-9);
  EXPECT_NEAR(panel.view.cells[1][0].lines[0][1].x, 292, 1e-9);
}

TEST(MapPanel, cells_are_filled_by_rainfall_and_hatched_where_there_is_none) {
  Picture picture = row_of_cells({3, 8});
  const RainfallClasses classes(picture);
  Canvas canvas(8, 6);
  draw_cells(canvas, {2, 1, 6, 4}, picture, Panel().cells(), classes, 20);
  EXPECT_EQ(at(canvas, 3, 1), classes.colour(3));
  EXPECT_EQ(at(canvas, 5, 4), classes.colour(8));
  EXPECT_EQ(at(canvas, 6, 2), hatching(6, 2, 20));
  EXPECT_EQ(at(canvas, 2, 1), ink::background);
  EXPECT_EQ(at(canvas, 0, 0), ink::white) << "beside the panel nothing changes";
  picture.cells[1].rainfall = none;
  draw_cells(canvas, {2, 1, 6, 4}, picture, Panel().cells(), classes, 20);
  EXPECT_EQ(at(canvas, 5, 4), hatching(5, 4, 20));
}

TEST(MapPanel, cells_by_station_differ_from_their_neighbours_and_not_among_one_gauge) {
  Picture picture = row_of_cells({3, 8});
  picture.by_rainfall = false;
  Canvas canvas(6, 4);
  draw_cells(canvas, {0, 0, 6, 4}, picture, Panel().cells(), RainfallClasses(picture), 20);
  EXPECT_NE(at(canvas, 2, 2), at(canvas, 3, 2));
  EXPECT_EQ(at(canvas, 4, 2), ink::background) << "ground without a cell is no missing reading";
  picture.cells[1].gauge = 0;
  draw_cells(canvas, {0, 0, 6, 4}, picture, Panel().cells(), RainfallClasses(picture), 20);
  EXPECT_EQ(at(canvas, 2, 2), at(canvas, 3, 2));
}

}  // namespace
}  // namespace thiessen
