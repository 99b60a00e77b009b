// Linked with OpenCV: the colours of cells are the legend's.
#include "map/sheet/map_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "map/ink/contrast.h"
#include "map/ink/ink.h"
#include "map/ink/signs.h"
#include "map/opencv/pixel_canvas.h"
#include "map/sheet/palette.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

constexpr std::int32_t nobody = LabelImage::nobody;

MapShape box(double west, double north, double east, double south) {
  const Ring ring = {{west, north}, {east, north}, {east, south}, {west, south}};
  Ring line = ring;
  line.push_back(ring.front());
  const MapPart part = {{ring}, {line}};
  return {part};
}

/// A panel of 60 by 40 pixels: a basin over columns 10 to 49, cells over 10 to 29 of it, and 30 to
/// 39. Outlines lie in the middles of pixels, which they touch.
struct Panel {
  Panel() {
    view.basins = {box(10.5, 0.5, 49.5, 39.5)};
    view.cells = {box(10.5, 0.5, 29.5, 39.5), box(30.5, 0.5, 39.5, 39.5)};
  }
  LabelImage basins() const { return basin_labels(view, box_of); }
  LabelImage cells(const PixelBox& sight = {0, 0, 60, 40}) const {
    return cell_labels(view, box_of, sight);
  }
  StudyView view;
  PixelBox box_of{0, 0, 60, 40};
};

/// The runs of labels in a row: each label and how many pixels it takes.
using Runs = std::vector<std::pair<std::int32_t, int>>;

Runs row(const LabelImage& labels, int y) {
  Runs runs;
  for (int x = 0; x < labels.width(); ++x) {
    if (runs.empty() || runs.back().first != labels.at(x, y)) runs.push_back({labels.at(x, y), 0});
    ++runs.back().second;
  }
  return runs;
}

Colour at(PixelCanvas& canvas, int x, int y) {
  const auto first = 3 * static_cast<std::size_t>(y * canvas.width() + x);
  return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
}

TEST(MapPanel, pixels_show_the_basin_and_the_cell_that_they_lie_in) {
  const Panel panel;
  EXPECT_EQ(row(panel.basins(), 20), (Runs{{nobody, 10}, {0, 40}, {nobody, 10}}));
  EXPECT_EQ(row(panel.cells(), 20), (Runs{{nobody, 10}, {0, 20}, {1, 10}, {nobody, 20}}));
}

TEST(MapPanel, what_is_out_of_sight_belongs_to_nobody) {
  const LabelImage cells = Panel().cells({20, 10, 15, 20});
  EXPECT_EQ(row(cells, 9), (Runs{{nobody, 60}}));
  EXPECT_EQ(row(cells, 20), (Runs{{nobody, 20}, {0, 10}, {1, 5}, {nobody, 25}}));
  EXPECT_EQ(row(cells, 30), (Runs{{nobody, 60}}));
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
  EXPECT_EQ(pixels_of_gauges(picture, Panel().cells()), (std::vector<std::size_t>{400, 0, 800}));
  picture.cells[1].gauge = 2;
  EXPECT_EQ(pixels_of_gauges(picture, Panel().cells()), (std::vector<std::size_t>{0, 0, 1200}));
}

TEST(MapPanel, shapes_and_gauges_are_taken_to_pixels) {
  Panel panel;
  panel.view.basins = {box(1, 0, 5, 4)};
  panel.view.cells = {box(3, 0, 4, 4)};
  panel.view.gauges = {{3, 2}};
  to_pixels(panel.view, PanelTransform({1, 0, 5, 4}, {0, 0, 400, 400}));  // 92 pixels a unit
  EXPECT_EQ(panel.view.gauges[0], (Point{200, 200}));
  EXPECT_NEAR(panel.view.basins[0][0].rings[0][0].x, 16, 1e-9);
  EXPECT_NEAR(panel.view.basins[0][0].rings[0][0].y, 384, 1e-9);
  EXPECT_NEAR(panel.view.cells[0][0].lines[0][1].x, 292, 1e-9);
}

/// The cells of the panel, drawn at (2, 1) of a page.
PixelCanvas drawn(const Picture& picture) {
  PixelCanvas canvas(70, 50);
  const Panel panel;
  draw_cells(canvas, {2, 1, 60, 40}, {0, 0, 60, 40}, picture, panel.view, panel.cells(),
             classes_of(picture), 20);
  return canvas;
}

/// Whether the pixels of a column are of the two greys of a hatch, and of both.
bool is_hatched(PixelCanvas& canvas, int x) {
  std::size_t light = 0;
  for (int y = 5; y < 35; ++y) {
    const Colour colour = at(canvas, x, y);
    if (colour.green > ink::no_reading.green || colour.green < ink::hatch.green) return false;
    light += colour == ink::no_reading ? 1U : 0U;
  }
  return light > 5 && light < 30;
}

TEST(MapPanel, cells_are_filled_by_rainfall_and_hatched_where_there_is_none) {
  Picture picture = row_of_cells({3, 8});
  const RainfallClasses classes = classes_of(picture);
  PixelCanvas canvas = drawn(picture);
  EXPECT_EQ(at(canvas, 20, 20), classes.colour(3));
  EXPECT_EQ(at(canvas, 36, 20), classes.colour(8));
  EXPECT_TRUE(is_hatched(canvas, 46)) << "of a basin, but of no cell";
  EXPECT_EQ(at(canvas, 5, 20), ink::background);
  EXPECT_EQ(at(canvas, 0, 0), ink::white) << "beside the panel nothing changes";
  EXPECT_FALSE(is_hatched(canvas, 36));
  picture.cells[1].rainfall = none;
  canvas = drawn(picture);
  EXPECT_TRUE(is_hatched(canvas, 36));
}

TEST(MapPanel, cells_by_station_differ_from_their_neighbours_and_not_among_one_gauge) {
  Picture picture = row_of_cells({3, 8});
  picture.by_rainfall = false;
  PixelCanvas canvas = drawn(picture);
  EXPECT_NE(at(canvas, 20, 20), at(canvas, 36, 20));
  EXPECT_EQ(at(canvas, 46, 20), ink::background) << "ground without a cell is no missing reading";
  picture.cells[1].gauge = 0;
  canvas = drawn(picture);
  EXPECT_EQ(at(canvas, 20, 20), at(canvas, 36, 20));
}

// The line has twice or half of the light of the ground that it runs over, whatever that is.
TEST(MapPanel, the_outline_of_a_cell_is_told_from_every_colour_of_every_palette) {
  for (const Palette palette :
       {Palette::viridis, Palette::blues, Palette::browns, Palette::greys}) {
    for (std::size_t count = 1; count <= 14; ++count) {
      for (std::size_t i = 0; i < count; ++i) {
        const Colour ground = sequential_colour(palette, i, count);
        const Stroke line = cell_stroke(20, ground);
        EXPECT_GE(contrast(blended(ground, line.colour, line.alpha), ground), 2)
            << static_cast<int>(palette) << ' ' << i << " of " << count;
      }
    }
  }
}

/// A basin of two cells of these readings, drawn with its outlines.
PixelCanvas outlined(double west, double east, const ClassRule& rule) {
  Picture picture = row_of_cells({west, east});
  const RainfallClasses classes({0.5, 10}, rule);
  Page page;
  page.style.em = 20;
  page.panel = {0, 0, 400, 200};
  StudyView view;
  view.cells = {box(40.5, 40.5, 200.5, 160.5), box(200.5, 40.5, 360.5, 160.5)};
  view.basins = {box(40.5, 40.5, 360.5, 160.5)};
  PixelCanvas canvas(400, 200);
  const LabelImage cells = cell_labels(view, page.panel, page.panel);
  draw_cells(canvas, page.panel, page.panel, picture, view, cells, classes, page.style.em);
  draw_outlines(canvas, page, page.panel, picture, view, cells, classes, MapDetail());
  return canvas;
}

TEST(MapPanel, outlines_are_light_between_dark_cells_and_dark_between_pale_ones) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::breaks;
  rule.breaks = {1, 2, 3, 4};
  PixelCanvas dark = outlined(0.5, 0.5, rule);
  EXPECT_GE(contrast(at(dark, 200, 100), at(dark, 150, 100)), 2);
  EXPECT_GT(at(dark, 200, 100).green, at(dark, 150, 100).green);
  PixelCanvas pale = outlined(9, 9, rule);
  EXPECT_GE(contrast(at(pale, 200, 100), at(pale, 150, 100)), 2);
  EXPECT_LT(at(pale, 200, 100).green, at(pale, 150, 100).green);
  PixelCanvas both = outlined(0.5, 9, rule);
  EXPECT_LT(at(both, 200, 100).green, at(both, 250, 100).green) << "one line, and not a light one";
}

// Rows of cells 100, 10 and 3 pixels wide.
TEST(MapPanel, cells_of_a_few_pixels_have_no_outline_beside_larger_ones_that_have) {
  Picture picture;
  StudyView view;
  const auto add_row = [&](double top, double side, int count) {
    for (int i = 0; i < count; ++i) {
      const double left = i * side + 0.5;  // the middle of a pixel
      view.cells.push_back(box(left, top + 0.5, left + side, top + side + 0.5));
      picture.cells.push_back({{}, 0});
    }
  };
  add_row(0, 100, 3);
  add_row(100, 10, 5);
  add_row(150, 3, 20);
  Page page;
  page.style.em = 20;
  page.panel = {0, 0, 400, 200};
  PixelCanvas canvas(400, 200);
  const LabelImage cells = cell_labels(view, page.panel, page.panel);
  EXPECT_EQ(draw_outlines(canvas, page, page.panel, picture, view, cells, RainfallClasses({}, {}),
                          MapDetail()),
            8U);
  const auto darkest = [&](int left, int right, int y) {
    int green = 255;
    for (int x = left; x < right; ++x) green = std::min<int>(green, at(canvas, x, y).green);
    return green;
  };
  EXPECT_LT(darkest(98, 103, 50), 150);
  EXPECT_LT(darkest(8, 13, 105), 225);
  EXPECT_GT(darkest(8, 13, 105), darkest(98, 103, 50)) << "fainter";
  EXPECT_EQ(darkest(2, 60, 152), 255);
}

TEST(MapPanel, the_outline_of_a_basin_has_a_light_rim_where_the_ground_is_as_dark) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::breaks;
  rule.breaks = {1, 2, 3, 4};
  rule.palette = Palette::greys;
  const auto lightest_beside = [](PixelCanvas canvas) {
    int green = 0;
    for (int x = 41; x < 46; ++x) green = std::max<int>(green, at(canvas, x, 100).green);
    return green - at(canvas, 100, 100).green;
  };
  EXPECT_GT(lightest_beside(outlined(9, 9, rule)), 60) << "on the darkest grey";
  EXPECT_LE(lightest_beside(outlined(1.5, 1.5, rule)), 0) << "on the second lightest";
}

}  // namespace
}  // namespace thiessen
